import{A as b,B as Oi,C as ih,D as La,E as yn,F as H_,G as Si,H as G_,I as V_,J as ko,L as Fi,M as Qs,a as Ji,b as Hn,c as Ia,d as te,e as Ks,f as uc,g as Ni,h as hc,i as th,j as Ui,k as eh,l as nh,m as U_,n as O_,o as wr,p as Mr,q as F_,r as As,s as pm,t as B_,u as Gn,v as dc,w as k_,x as z_,y as K,z as lt}from"./chunk-AF7HW7SM.js";import{a as N_}from"./chunk-WOT6VMZA.js";var Da=null,sh=new Map,W_=()=>{Da=null;let n=[...sh.values()];sh.clear();for(let t of n)t()};addEventListener("pointerdown",n=>Da=n.target,!0);addEventListener("pointerup",()=>setTimeout(W_,60),!0);addEventListener("pointercancel",W_,!0);addEventListener("click",()=>Da=null,!0);function rh(n,t){Da&&Da!==n&&n.contains(Da)?sh.set(n,t):(sh.delete(n),t())}function E(n,t={},...e){let i=document.createElement(n);for(let[s,r]of Object.entries(t))if(!(r==null||r===!1))if(s==="text")i.textContent=r;else if(s==="on")for(let[o,a]of Object.entries(r))i.addEventListener(o,a);else s==="value"?i.value=r:s==="checked"||s==="disabled"||s==="hidden"?i[s]=r:i.setAttribute(s,r===!0?"":r);return i.append(...e.flat().filter(s=>s!=null&&s!==!1)),i}var Ut=(n,t,e)=>E("button",{type:"button",text:n,...t,on:{click:e}}),Rs=(n,t=document)=>t.querySelector(n),Gt=(n,...t)=>rh(n,()=>n.replaceChildren(...t.flat().filter(Boolean)));function bt(n,t){n.textContent!==t&&(n.textContent=t)}function Be(n,t,e,i,s){let r=E("div",{class:"choice",role:"group","aria-label":n,"data-testid":s}),o=a=>{for(let l of r.children)l.setAttribute("aria-pressed",String(l.dataset.value===a))};for(let[a,l]of t)r.append(E("button",{type:"button",text:l,"data-value":a,on:{click:()=>{o(a),i(a)}}}));return o(e),r.mark=o,r}function hn(n,t,e,i,s={}){let r=E("select",{"aria-label":n,...s,on:{change:()=>i(r.value)}},t.map(([o,a])=>E("option",{value:o,text:a})));return r.value=e,r}function tr(n){let t=!1,e=()=>{t||(t=!0,requestAnimationFrame(()=>{t=!1,n()}))};return e.now=n,e}function zo(n,t){let e=null,i=-1/0,s=()=>{clearTimeout(e),e=null,i=performance.now(),t()};return s.soon=()=>{let r=i+n-performance.now();r<=0?s():e??=setTimeout(s,r)},s}function er(n,t){let e,i=(...s)=>{clearTimeout(e),e=setTimeout(()=>n(...s),t)};return i.cancel=()=>clearTimeout(e),i}function hi(n,t,e="text/plain"){let i=URL.createObjectURL(t instanceof Blob?t:new Blob([t],{type:e})),s=E("a",{href:i,download:n});document.body.append(s),s.click(),s.remove(),setTimeout(()=>URL.revokeObjectURL(i),1e4)}async function no(n){try{await navigator.clipboard.writeText(n)}catch{let t=E("textarea",{class:"offscreen"});t.value=n,document.body.append(t),t.select(),document.execCommand("copy"),t.remove()}de("Copied")}var $_;function de(n,t="plain"){let e=document.getElementById("remark");e.textContent=n,e.dataset.tone=t,e.classList.add("shown"),clearTimeout($_),$_=setTimeout(()=>e.classList.remove("shown"),t==="wrong"?8e3:2500)}function Sr(...n){for(let t of n){let e=o=>{let a=o.closest("[hidden]");return!a||a.contains(t)},i=[...t.querySelectorAll(".number.wrong")].find(e);if(!i)continue;let s=t.closest(".panel");return i.closest("details")&&(i.closest("details").open=!0),i.focus(),`${s.hidden?`${document.getElementById(s.getAttribute("aria-labelledby")).textContent}: `:""}${i.getAttribute("aria-label")} cannot be read (${i.title}).`}return null}function io(n){let t=null,e=!1,i=s=>{if(s){t??=setTimeout(()=>{e=!0,n(!0)},250);return}clearTimeout(t),t=null,e&&(e=!1,n(!1))};return i.late=()=>e,i}function Na(n,...t){for(let e of t)n?e.setAttribute("aria-busy","true"):e.removeAttribute("aria-busy")}var Ua=0,ah=0,xm=-1,mm=[];function _m(n){return{...n,joints:n.joints.map(({text:t,...e})=>e)}}var oh=io(n=>n&&Y_());function Y_(){b.plan=null,lt("plan")}async function gm(){let n=Ua;if(!b.table.joints.length){b.plan={solvable:!1,explain:"The table is empty: add a joint.",max_solutions:0},oh(!1),lt("plan");return}try{let{plan:t}=await Fi("arm",{table:_m(b.table)});if(n!==Ua)return;xm=n,b.plan=t,oh(!1),q_()}catch(t){if(n!==Ua||t instanceof ko)return;b.plan={solvable:!1,refused:!0,explain:t.message,max_solutions:0},oh(!1),q_(t)}lt("plan")}function q_(n){let t=mm;mm=[];for(let{resolve:e,reject:i}of t)n?i(n):e()}var X_=er(gm,60);function j_(){K("table",n=>{Ua+=1,["postures","name","gripper"].includes(n)||(ah+=1,n==="new"&&Y_(),oh(!0)),n==="postures"&&(xm=-1),n==="cell"?X_():(X_.cancel(),gm())}),K("online",n=>{n&&(Ua+=1,gm())})}function JE(){return xm===Ua?Promise.resolve():new Promise((n,t)=>mm.push({resolve:n,reject:t}))}var Cs=()=>ah,lh=class extends Error{},fc=n=>n instanceof ko||n instanceof lh;async function Oe(n,t,e,{whichever:i=!1}={}){let s=ah;await JE();let r=await Fi(n,t,e);if(s!==ah&&!i)throw new lh("The arm was changed meanwhile, so the answer is not shown.");return r}function Z_(n){if(!n)return"";let t=n.explain.split(`
`).map(s=>s.trim()),e=t.find(s=>s.startsWith("Solved by:")),i=(e??t.filter(Boolean)[0]??"").replace(/\s+/g," ");return e||i.length<200?i:`${i.slice(0,200)} \u2026`}function ch(n){if(!n?.solvable)return"";let t=n.max_solutions;return t==null?"":t===1?"One solution":`Up to ${t} solutions`}var mo={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},go={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},Py=0,Xm=1,Iy=2;var Yc=1,Ly=2,cl=3,ar=0,oi=1,mi=2,jo=0,ul=1,Ym=2,jm=3,Zm=4,Dy=5;var Zo=100,Ny=101,Uy=102,Oy=103,Fy=104,By=200,ky=201,zy=202,Hy=203,Jm=204,Km=205,Gy=206,Vy=207,Wy=208,$y=209,qy=210,Xy=211,Yy=212,jy=213,Zy=214,Fh=0,Bh=1,kh=2,Ja=3,zh=4,Hh=5,Gh=6,Vh=7,Qm=0,Jy=1,Ky=2,lr=0,tg=1,eg=2,ng=3,ig=4,sg=5,rg=6,og=7;var ag=300,Jo=301,hl=302,md=303,gd=304,Wh=1e3,ir=1001,$h=1002,ni=1003,Qy=1004;var jc=1005;var Ri=1006,xd=1007;var Or=1008;var is=1009,lg=1010,cg=1011,dl=1012,_d=1013,Us=1014,ps=1015,Os=1016,yd=1017,vd=1018,Ko=1020,ug=35902,hg=35899,dg=1021,fg=1022,Fs=1023,Ir=1026,Fr=1027,bd=1028,wd=1029,xo=1030,Md=1031;var Sd=1033,Zc=33776,Jc=33777,Kc=33778,Qc=33779,Ed=35840,Td=35841,Ad=35842,Rd=35843,Cd=36196,Pd=37492,Id=37496,Ld=37488,Dd=37489,tu=37490,Nd=37491,Ud=37808,Od=37809,Fd=37810,Bd=37811,kd=37812,zd=37813,Hd=37814,Gd=37815,Vd=37816,Wd=37817,$d=37818,qd=37819,Xd=37820,Yd=37821,jd=36492,Zd=36494,Jd=36495,Kd=36283,Qd=36284,eu=36285,tf=36286;var Sc=2300,qh=2301,Uh=2302,km=2303,zm=2400,Hm=2401,Gm=2402;var tv=3200;var pg=0,ev=1,Br="",Ti="srgb",Ec="srgb-linear",Tc="linear",$e="srgb";var Oh=7680,mg=7681;var gg=517;var nv=519,iv=512,sv=513,rv=514,xg=515,ov=516,av=517,_g=518,yg=519,vg=35044,ef=35048;var bg="300 es",fs=2e3,Ac=2001;function QE(n){for(let t=n.length-1;t>=0;--t)if(n[t]>=65535)return!0;return!1}function tT(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function Rc(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function lv(){let n=Rc("canvas");return n.style.display="block",n}var J_={},Ka=null;function Cc(...n){let t="THREE."+n.shift();Ka?Ka("log",t,...n):console.log(t,...n)}function cv(n){let t=n[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=n[1];e&&e.isStackTrace?n[0]+=" "+e.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function ie(...n){n=cv(n);let t="THREE."+n.shift();if(Ka)Ka("warn",t,...n);else{let e=n[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...n)}}function ce(...n){n=cv(n);let t="THREE."+n.shift();if(Ka)Ka("error",t,...n);else{let e=n[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...n)}}function bc(...n){let t=n.join(" ");t in J_||(J_[t]=!0,ie(...n))}function uv(n,t,e){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(t,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:i()}}setTimeout(r,e)})}var hv={[Fh]:Fh,[kh]:Gh,[zh]:zh,[Ja]:Hh,[Bh]:Bh,[Gh]:kh,[Vh]:Vh,[Hh]:Ja},Ds=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[t]===void 0&&(i[t]=[]),i[t].indexOf(e)===-1&&i[t].push(e)}hasEventListener(t,e){let i=this._listeners;return i===void 0?!1:i[t]!==void 0&&i[t].indexOf(e)!==-1}removeEventListener(t,e){let i=this._listeners;if(i===void 0)return;let s=i[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let i=e[t.type];if(i!==void 0){t.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},di=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],K_=1234567,wc=Math.PI/180,Qa=180/Math.PI;function _o(){let n=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(di[n&255]+di[n>>8&255]+di[n>>16&255]+di[n>>24&255]+"-"+di[t&255]+di[t>>8&255]+"-"+di[t>>16&15|64]+di[t>>24&255]+"-"+di[e&63|128]+di[e>>8&255]+"-"+di[e>>16&255]+di[e>>24&255]+di[i&255]+di[i>>8&255]+di[i>>16&255]+di[i>>24&255]).toLowerCase()}function Ae(n,t,e){return Math.max(t,Math.min(e,n))}function wg(n,t){return(n%t+t)%t}function eT(n,t,e,i,s){return i+(n-t)*(s-i)/(e-t)}function nT(n,t,e){return n!==t?(e-n)/(t-n):0}function Mc(n,t,e){return(1-e)*n+e*t}function iT(n,t,e,i){return Mc(n,t,1-Math.exp(-e*i))}function sT(n,t=1){return t-Math.abs(wg(n,t*2)-t)}function rT(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*(3-2*n))}function oT(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*n*(n*(n*6-15)+10))}function aT(n,t){return n+Math.floor(Math.random()*(t-n+1))}function lT(n,t){return n+Math.random()*(t-n)}function cT(n){return n*(.5-Math.random())}function uT(n){n!==void 0&&(K_=n);let t=K_+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function hT(n){return n*wc}function dT(n){return n*Qa}function fT(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function pT(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function Mg(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function mT(n,t,e,i,s){let r=Math.cos,o=Math.sin,a=r(e/2),l=o(e/2),c=r((t+i)/2),u=o((t+i)/2),h=r((t-i)/2),d=o((t-i)/2),f=r((i-t)/2),p=o((i-t)/2);switch(s){case"XYX":n.set(a*u,l*h,l*d,a*c);break;case"YZY":n.set(l*d,a*u,l*h,a*c);break;case"ZXZ":n.set(l*h,l*d,a*u,a*c);break;case"XZX":n.set(a*u,l*p,l*f,a*c);break;case"YXY":n.set(l*f,a*u,l*p,a*c);break;case"ZYZ":n.set(l*p,l*f,a*u,a*c);break;default:ie("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function nf(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Sg(n,t){if(t.constructor===Float32Array)return n;let e=nf(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/e,-1)}function Eg(n,t){if(t.constructor===Float32Array)return n;let e=nf(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*e)}var yo={DEG2RAD:wc,RAD2DEG:Qa,generateUUID:_o,clamp:Ae,euclideanModulo:wg,mapLinear:eT,inverseLerp:nT,lerp:Mc,damp:iT,pingpong:sT,smoothstep:rT,smootherstep:oT,randInt:aT,randFloat:lT,randFloatSpread:cT,seededRandom:uT,degToRad:hT,radToDeg:dT,isPowerOfTwo:fT,ceilPowerOfTwo:pT,floorPowerOfTwo:Mg,setQuaternionFromProperEuler:mT,normalize:Eg,denormalize:Sg},Qt=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,i=this.y,s=t.elements;return this.x=s[0]*e+s[3]*i+s[6],this.y=s[1]*e+s[4]*i+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=Ae(this.x,t.x,e.x),this.y=Ae(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=Ae(this.x,t,e),this.y=Ae(this.y,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Ae(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(Ae(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y;return e*e+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let i=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*i-o*s+t.x,this.y=r*s+o*i+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},fn=class{constructor(t=0,e=0,i=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=i,this._w=s}static slerpFlat(t,e,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],h=i[s+3],d=r[o+0],f=r[o+1],p=r[o+2],y=r[o+3];if(h!==y||l!==d||c!==f||u!==p){let g=l*d+c*f+u*p+h*y;g<0&&(d=-d,f=-f,p=-p,y=-y,g=-g);let m=1-a;if(g<.9995){let x=Math.acos(g),w=Math.sin(x);m=Math.sin(m*x)/w,a=Math.sin(a*x)/w,l=l*m+d*a,c=c*m+f*a,u=u*m+p*a,h=h*m+y*a}else{l=l*m+d*a,c=c*m+f*a,u=u*m+p*a,h=h*m+y*a;let x=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=x,c*=x,u*=x,h*=x}}t[e]=l,t[e+1]=c,t[e+2]=u,t[e+3]=h}static multiplyQuaternionsFlat(t,e,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],h=r[o],d=r[o+1],f=r[o+2],p=r[o+3];return t[e]=a*p+u*h+l*f-c*d,t[e+1]=l*p+u*d+c*h-a*f,t[e+2]=c*p+u*f+a*d-l*h,t[e+3]=u*p-a*h-l*d-c*f,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,i,s){return this._x=t,this._y=e,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let i=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),h=a(r/2),d=l(i/2),f=l(s/2),p=l(r/2);switch(o){case"XYZ":this._x=d*u*h+c*f*p,this._y=c*f*h-d*u*p,this._z=c*u*p+d*f*h,this._w=c*u*h-d*f*p;break;case"YXZ":this._x=d*u*h+c*f*p,this._y=c*f*h-d*u*p,this._z=c*u*p-d*f*h,this._w=c*u*h+d*f*p;break;case"ZXY":this._x=d*u*h-c*f*p,this._y=c*f*h+d*u*p,this._z=c*u*p+d*f*h,this._w=c*u*h-d*f*p;break;case"ZYX":this._x=d*u*h-c*f*p,this._y=c*f*h+d*u*p,this._z=c*u*p-d*f*h,this._w=c*u*h+d*f*p;break;case"YZX":this._x=d*u*h+c*f*p,this._y=c*f*h+d*u*p,this._z=c*u*p-d*f*h,this._w=c*u*h-d*f*p;break;case"XZY":this._x=d*u*h-c*f*p,this._y=c*f*h-d*u*p,this._z=c*u*p+d*f*h,this._w=c*u*h+d*f*p;break;default:ie("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let i=e/2,s=Math.sin(i);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,i=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],u=e[6],h=e[10],d=i+a+h;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(u-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(i>a&&i>h){let f=2*Math.sqrt(1+i-a-h);this._w=(u-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>h){let f=2*Math.sqrt(1+a-i-h);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+u)/f}else{let f=2*Math.sqrt(1+h-i-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+u)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let i=t.dot(e)+1;return i<1e-8?(i=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=i):(this._x=0,this._y=-t.z,this._z=t.y,this._w=i)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=i),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(Ae(this.dot(t),-1,1)))}rotateTowards(t,e){let i=this.angleTo(t);if(i===0)return this;let s=Math.min(1,e/i);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,u=e._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-e;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,e=Math.sin(e*c)/u,this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this._onChangeCallback()}else this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this.normalize();return this}slerpQuaternions(t,e,i){return this.copy(t).slerp(e,i)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},V=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,i=0){this.x=t,this.y=e,this.z=i}set(t,e,i){return i===void 0&&(i=this.z),this.x=t,this.y=e,this.z=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(Q_.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(Q_.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*i+r[6]*s,this.y=r[1]*e+r[4]*i+r[7]*s,this.z=r[2]*e+r[5]*i+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,i=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*i),u=2*(a*e-r*s),h=2*(r*i-o*e);return this.x=e+l*c+o*h-a*u,this.y=i+l*u+a*c-r*h,this.z=s+l*h+r*u-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*i+r[8]*s,this.y=r[1]*e+r[5]*i+r[9]*s,this.z=r[2]*e+r[6]*i+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=Ae(this.x,t.x,e.x),this.y=Ae(this.y,t.y,e.y),this.z=Ae(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=Ae(this.x,t,e),this.y=Ae(this.y,t,e),this.z=Ae(this.z,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Ae(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let i=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let i=t.dot(this)/e;return this.copy(t).multiplyScalar(i)}projectOnPlane(t){return ym.copy(this).projectOnVector(t),this.sub(ym)}reflect(t){return this.sub(ym.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(Ae(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y,s=this.z-t.z;return e*e+i*i+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,i){let s=Math.sin(e)*t;return this.x=s*Math.sin(i),this.y=Math.cos(e)*t,this.z=s*Math.cos(i),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,i){return this.x=t*Math.sin(e),this.y=i,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),i=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=i,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,i=Math.sqrt(1-e*e);return this.x=i*Math.cos(t),this.y=e,this.z=i*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},ym=new V,Q_=new fn,fe=class{static{this.prototype.isMatrix3=!0}constructor(t,e,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c)}set(t,e,i,s,r,o,a,l,c){let u=this.elements;return u[0]=t,u[1]=s,u[2]=a,u[3]=e,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],this}extractBasis(t,e,i){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],h=i[7],d=i[2],f=i[5],p=i[8],y=s[0],g=s[3],m=s[6],x=s[1],w=s[4],v=s[7],A=s[2],S=s[5],_=s[8];return r[0]=o*y+a*x+l*A,r[3]=o*g+a*w+l*S,r[6]=o*m+a*v+l*_,r[1]=c*y+u*x+h*A,r[4]=c*g+u*w+h*S,r[7]=c*m+u*v+h*_,r[2]=d*y+f*x+p*A,r[5]=d*g+f*w+p*S,r[8]=d*m+f*v+p*_,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8];return e*o*u-e*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],h=u*o-a*c,d=a*l-u*r,f=c*r-o*l,p=e*h+i*d+s*f;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let y=1/p;return t[0]=h*y,t[1]=(s*c-u*i)*y,t[2]=(a*i-s*o)*y,t[3]=d*y,t[4]=(u*e-s*l)*y,t[5]=(s*r-a*e)*y,t[6]=f*y,t[7]=(i*l-c*e)*y,t[8]=(o*e-i*r)*y,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return bc("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(vm.makeScale(t,e)),this}rotate(t){return bc("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(vm.makeRotation(-t)),this}translate(t,e){return bc("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(vm.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,i,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<9;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<9;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t}clone(){return new this.constructor().fromArray(this.elements)}},vm=new fe,ty=new fe().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),ey=new fe().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function gT(){let n={enabled:!0,workingColorSpace:Ec,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===$e&&(s.r=Pr(s.r),s.g=Pr(s.g),s.b=Pr(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===$e&&(s.r=Za(s.r),s.g=Za(s.g),s.b=Za(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Br?Tc:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[Ec]:{primaries:t,whitePoint:i,transfer:Tc,toXYZ:ty,fromXYZ:ey,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:Ti},outputColorSpaceConfig:{drawingBufferColorSpace:Ti}},[Ti]:{primaries:t,whitePoint:i,transfer:$e,toXYZ:ty,fromXYZ:ey,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:Ti}}}),n}var De=gT();function Pr(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function Za(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var Oa,Xh=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let i;if(t instanceof HTMLCanvasElement)i=t;else{Oa===void 0&&(Oa=Rc("canvas")),Oa.width=t.width,Oa.height=t.height;let s=Oa.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),i=Oa}return i.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=Rc("canvas");e.width=t.width,e.height=t.height;let i=e.getContext("2d");i.drawImage(t,0,0,t.width,t.height);let s=i.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Pr(r[o]/255)*255;return i.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let i=0;i<e.length;i++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[i]=Math.floor(Pr(e[i]/255)*255):e[i]=Pr(e[i]);return{data:e,width:t.width,height:t.height}}else return ie("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},xT=0,tl=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:xT++}),this.uuid=_o(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(bm(s[o].image)):r.push(bm(s[o]))}else r=bm(s);i.url=r}return e||(t.images[this.uuid]=i),i}};function bm(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?Xh.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(ie("Texture: Unable to serialize Texture."),{})}var _T=0,wm=new V,Bi=class n extends Ds{constructor(t=n.DEFAULT_IMAGE,e=n.DEFAULT_MAPPING,i=ir,s=ir,r=Ri,o=Or,a=Fs,l=is,c=n.DEFAULT_ANISOTROPY,u=Br){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:_T++}),this.uuid=_o(),this.name="",this.source=new tl(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Qt(0,0),this.repeat=new Qt(1,1),this.center=new Qt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new fe,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(wm).x}get height(){return this.source.getSize(wm).y}get depth(){return this.source.getSize(wm).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let i=t[e];if(i===void 0){ie(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){ie(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),e||(t.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==ag)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case Wh:t.x=t.x-Math.floor(t.x);break;case ir:t.x=t.x<0?0:1;break;case $h:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case Wh:t.y=t.y-Math.floor(t.y);break;case ir:t.y=t.y<0?0:1;break;case $h:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};Bi.DEFAULT_IMAGE=null;Bi.DEFAULT_MAPPING=ag;Bi.DEFAULT_ANISOTROPY=1;var bn=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,i=0,s=1){this.x=t,this.y=e,this.z=i,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,i,s){return this.x=t,this.y=e,this.z=i,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*i+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,i,s,r,l=t.elements,c=l[0],u=l[4],h=l[8],d=l[1],f=l[5],p=l[9],y=l[2],g=l[6],m=l[10];if(Math.abs(u-d)<.01&&Math.abs(h-y)<.01&&Math.abs(p-g)<.01){if(Math.abs(u+d)<.1&&Math.abs(h+y)<.1&&Math.abs(p+g)<.1&&Math.abs(c+f+m-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let w=(c+1)/2,v=(f+1)/2,A=(m+1)/2,S=(u+d)/4,_=(h+y)/4,M=(p+g)/4;return w>v&&w>A?w<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(w),s=S/i,r=_/i):v>A?v<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(v),i=S/s,r=M/s):A<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(A),i=_/r,s=M/r),this.set(i,s,r,e),this}let x=Math.sqrt((g-p)*(g-p)+(h-y)*(h-y)+(d-u)*(d-u));return Math.abs(x)<.001&&(x=1),this.x=(g-p)/x,this.y=(h-y)/x,this.z=(d-u)/x,this.w=Math.acos((c+f+m-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=Ae(this.x,t.x,e.x),this.y=Ae(this.y,t.y,e.y),this.z=Ae(this.z,t.z,e.z),this.w=Ae(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=Ae(this.x,t,e),this.y=Ae(this.y,t,e),this.z=Ae(this.z,t,e),this.w=Ae(this.w,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Ae(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this.w=t.w+(e.w-t.w)*i,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Yh=class extends Ds{constructor(t=1,e=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Ri,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=i.depth,this.scissor=new bn(0,0,t,e),this.scissorTest=!1,this.viewport=new bn(0,0,t,e),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new Bi({width:t,height:e,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:Ri,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,i=1){if(this.width!==t||this.height!==e||this.depth!==i){this.width=t,this.height=e,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,i=t.textures.length;e<i;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new tl(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},ts=class extends Yh{constructor(t=1,e=1,i={}){super(t,e,i),this.isWebGLRenderTarget=!0}},Pc=class extends Bi{constructor(t=null,e=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=ni,this.minFilter=ni,this.wrapR=ir,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var jh=class extends Bi{constructor(t=null,e=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=ni,this.minFilter=ni,this.wrapR=ir,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var ye=class n{static{this.prototype.isMatrix4=!0}constructor(t,e,i,s,r,o,a,l,c,u,h,d,f,p,y,g){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c,u,h,d,f,p,y,g)}set(t,e,i,s,r,o,a,l,c,u,h,d,f,p,y,g){let m=this.elements;return m[0]=t,m[4]=e,m[8]=i,m[12]=s,m[1]=r,m[5]=o,m[9]=a,m[13]=l,m[2]=c,m[6]=u,m[10]=h,m[14]=d,m[3]=f,m[7]=p,m[11]=y,m[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],e[9]=i[9],e[10]=i[10],e[11]=i[11],e[12]=i[12],e[13]=i[13],e[14]=i[14],e[15]=i[15],this}copyPosition(t){let e=this.elements,i=t.elements;return e[12]=i[12],e[13]=i[13],e[14]=i[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,i){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),i.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(t,e,i){return this.set(t.x,e.x,i.x,0,t.y,e.y,i.y,0,t.z,e.z,i.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,i=t.elements,s=1/Fa.setFromMatrixColumn(t,0).length(),r=1/Fa.setFromMatrixColumn(t,1).length(),o=1/Fa.setFromMatrixColumn(t,2).length();return e[0]=i[0]*s,e[1]=i[1]*s,e[2]=i[2]*s,e[3]=0,e[4]=i[4]*r,e[5]=i[5]*r,e[6]=i[6]*r,e[7]=0,e[8]=i[8]*o,e[9]=i[9]*o,e[10]=i[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,i=t.x,s=t.y,r=t.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(t.order==="XYZ"){let d=o*u,f=o*h,p=a*u,y=a*h;e[0]=l*u,e[4]=-l*h,e[8]=c,e[1]=f+p*c,e[5]=d-y*c,e[9]=-a*l,e[2]=y-d*c,e[6]=p+f*c,e[10]=o*l}else if(t.order==="YXZ"){let d=l*u,f=l*h,p=c*u,y=c*h;e[0]=d+y*a,e[4]=p*a-f,e[8]=o*c,e[1]=o*h,e[5]=o*u,e[9]=-a,e[2]=f*a-p,e[6]=y+d*a,e[10]=o*l}else if(t.order==="ZXY"){let d=l*u,f=l*h,p=c*u,y=c*h;e[0]=d-y*a,e[4]=-o*h,e[8]=p+f*a,e[1]=f+p*a,e[5]=o*u,e[9]=y-d*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let d=o*u,f=o*h,p=a*u,y=a*h;e[0]=l*u,e[4]=p*c-f,e[8]=d*c+y,e[1]=l*h,e[5]=y*c+d,e[9]=f*c-p,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let d=o*l,f=o*c,p=a*l,y=a*c;e[0]=l*u,e[4]=y-d*h,e[8]=p*h+f,e[1]=h,e[5]=o*u,e[9]=-a*u,e[2]=-c*u,e[6]=f*h+p,e[10]=d-y*h}else if(t.order==="XZY"){let d=o*l,f=o*c,p=a*l,y=a*c;e[0]=l*u,e[4]=-h,e[8]=c*u,e[1]=d*h+y,e[5]=o*u,e[9]=f*h-p,e[2]=p*h-f,e[6]=a*u,e[10]=y*h+d}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(yT,t,vT)}lookAt(t,e,i){let s=this.elements;return Ki.subVectors(t,e),Ki.lengthSq()===0&&(Ki.z=1),Ki.normalize(),so.crossVectors(i,Ki),so.lengthSq()===0&&(Math.abs(i.z)===1?Ki.x+=1e-4:Ki.z+=1e-4,Ki.normalize(),so.crossVectors(i,Ki)),so.normalize(),uh.crossVectors(Ki,so),s[0]=so.x,s[4]=uh.x,s[8]=Ki.x,s[1]=so.y,s[5]=uh.y,s[9]=Ki.y,s[2]=so.z,s[6]=uh.z,s[10]=Ki.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],h=i[5],d=i[9],f=i[13],p=i[2],y=i[6],g=i[10],m=i[14],x=i[3],w=i[7],v=i[11],A=i[15],S=s[0],_=s[4],M=s[8],N=s[12],R=s[1],L=s[5],z=s[9],G=s[13],F=s[2],U=s[6],D=s[10],O=s[14],Z=s[3],X=s[7],J=s[11],nt=s[15];return r[0]=o*S+a*R+l*F+c*Z,r[4]=o*_+a*L+l*U+c*X,r[8]=o*M+a*z+l*D+c*J,r[12]=o*N+a*G+l*O+c*nt,r[1]=u*S+h*R+d*F+f*Z,r[5]=u*_+h*L+d*U+f*X,r[9]=u*M+h*z+d*D+f*J,r[13]=u*N+h*G+d*O+f*nt,r[2]=p*S+y*R+g*F+m*Z,r[6]=p*_+y*L+g*U+m*X,r[10]=p*M+y*z+g*D+m*J,r[14]=p*N+y*G+g*O+m*nt,r[3]=x*S+w*R+v*F+A*Z,r[7]=x*_+w*L+v*U+A*X,r[11]=x*M+w*z+v*D+A*J,r[15]=x*N+w*G+v*O+A*nt,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],u=t[2],h=t[6],d=t[10],f=t[14],p=t[3],y=t[7],g=t[11],m=t[15],x=l*f-c*d,w=a*f-c*h,v=a*d-l*h,A=o*f-c*u,S=o*d-l*u,_=o*h-a*u;return e*(y*x-g*w+m*v)-i*(p*x-g*A+m*S)+s*(p*w-y*A+m*_)-r*(p*v-y*S+g*_)}determinantAffine(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[1],o=t[5],a=t[9],l=t[2],c=t[6],u=t[10];return e*(o*u-a*c)-i*(r*u-a*l)+s*(r*c-o*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,i){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=i),this}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],h=t[9],d=t[10],f=t[11],p=t[12],y=t[13],g=t[14],m=t[15],x=e*a-i*o,w=e*l-s*o,v=e*c-r*o,A=i*l-s*a,S=i*c-r*a,_=s*c-r*l,M=u*y-h*p,N=u*g-d*p,R=u*m-f*p,L=h*g-d*y,z=h*m-f*y,G=d*m-f*g,F=x*G-w*z+v*L+A*R-S*N+_*M;if(F===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let U=1/F;return t[0]=(a*G-l*z+c*L)*U,t[1]=(s*z-i*G-r*L)*U,t[2]=(y*_-g*S+m*A)*U,t[3]=(d*S-h*_-f*A)*U,t[4]=(l*R-o*G-c*N)*U,t[5]=(e*G-s*R+r*N)*U,t[6]=(g*v-p*_-m*w)*U,t[7]=(u*_-d*v+f*w)*U,t[8]=(o*z-a*R+c*M)*U,t[9]=(i*R-e*z-r*M)*U,t[10]=(p*S-y*v+m*x)*U,t[11]=(h*v-u*S-f*x)*U,t[12]=(a*N-o*L-l*M)*U,t[13]=(e*L-i*N+s*M)*U,t[14]=(y*w-p*A-g*x)*U,t[15]=(u*A-h*w+d*x)*U,this}scale(t){let e=this.elements,i=t.x,s=t.y,r=t.z;return e[0]*=i,e[4]*=s,e[8]*=r,e[1]*=i,e[5]*=s,e[9]*=r,e[2]*=i,e[6]*=s,e[10]*=r,e[3]*=i,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],i=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,i,s))}makeTranslation(t,e,i){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,i,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),i=Math.sin(t);return this.set(1,0,0,0,0,e,-i,0,0,i,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,0,i,0,0,1,0,0,-i,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,0,i,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let i=Math.cos(e),s=Math.sin(e),r=1-i,o=t.x,a=t.y,l=t.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(t,e,i){return this.set(t,0,0,0,0,e,0,0,0,0,i,0,0,0,0,1),this}makeShear(t,e,i,s,r,o){return this.set(1,i,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,i){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,u=o+o,h=a+a,d=r*c,f=r*u,p=r*h,y=o*u,g=o*h,m=a*h,x=l*c,w=l*u,v=l*h,A=i.x,S=i.y,_=i.z;return s[0]=(1-(y+m))*A,s[1]=(f+v)*A,s[2]=(p-w)*A,s[3]=0,s[4]=(f-v)*S,s[5]=(1-(d+m))*S,s[6]=(g+x)*S,s[7]=0,s[8]=(p+w)*_,s[9]=(g-x)*_,s[10]=(1-(d+y))*_,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,i){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),e.identity(),this;let o=Fa.set(s[0],s[1],s[2]).length(),a=Fa.set(s[4],s[5],s[6]).length(),l=Fa.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Ps.copy(this);let c=1/o,u=1/a,h=1/l;return Ps.elements[0]*=c,Ps.elements[1]*=c,Ps.elements[2]*=c,Ps.elements[4]*=u,Ps.elements[5]*=u,Ps.elements[6]*=u,Ps.elements[8]*=h,Ps.elements[9]*=h,Ps.elements[10]*=h,e.setFromRotationMatrix(Ps),i.x=o,i.y=a,i.z=l,this}makePerspective(t,e,i,s,r,o,a=fs,l=!1){let c=this.elements,u=2*r/(e-t),h=2*r/(i-s),d=(e+t)/(e-t),f=(i+s)/(i-s),p,y;if(l)p=r/(o-r),y=o*r/(o-r);else if(a===fs)p=-(o+r)/(o-r),y=-2*o*r/(o-r);else if(a===Ac)p=-o/(o-r),y=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=h,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=p,c[14]=y,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,i,s,r,o,a=fs,l=!1){let c=this.elements,u=2/(e-t),h=2/(i-s),d=-(e+t)/(e-t),f=-(i+s)/(i-s),p,y;if(l)p=1/(o-r),y=o/(o-r);else if(a===fs)p=-2/(o-r),y=-(o+r)/(o-r);else if(a===Ac)p=-1/(o-r),y=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=h,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=p,c[14]=y,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<16;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<16;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t[e+9]=i[9],t[e+10]=i[10],t[e+11]=i[11],t[e+12]=i[12],t[e+13]=i[13],t[e+14]=i[14],t[e+15]=i[15],t}},Fa=new V,Ps=new ye,yT=new V(0,0,0),vT=new V(1,1,1),so=new V,uh=new V,Ki=new V,ny=new ye,iy=new fn,uo=class n{constructor(t=0,e=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=i,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,i,s=this._order){return this._x=t,this._y=e,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,i=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],h=s[2],d=s[6],f=s[10];switch(e){case"XYZ":this._y=Math.asin(Ae(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-Ae(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(Ae(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-h,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-Ae(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(Ae(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-Ae(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,f),this._y=0);break;default:ie("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,i===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,i){return ny.makeRotationFromQuaternion(t),this.setFromRotationMatrix(ny,e,i)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return iy.setFromEuler(this),this.setFromQuaternion(iy,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};uo.DEFAULT_ORDER="XYZ";var el=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},bT=0,sy=new V,Ba=new fn,Er=new ye,hh=new V,pc=new V,wT=new V,MT=new fn,ry=new V(1,0,0),oy=new V(0,1,0),ay=new V(0,0,1),ly={type:"added"},ST={type:"removed"},ka={type:"childadded",child:null},Mm={type:"childremoved",child:null},ki=class n extends Ds{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:bT++}),this.uuid=_o(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let t=new V,e=new uo,i=new fn,s=new V(1,1,1);function r(){i.setFromEuler(e,!1)}function o(){e.setFromQuaternion(i,void 0,!1)}e._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new ye},normalMatrix:{value:new fe}}),this.matrix=new ye,this.matrixWorld=new ye,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new el,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return Ba.setFromAxisAngle(t,e),this.quaternion.multiply(Ba),this}rotateOnWorldAxis(t,e){return Ba.setFromAxisAngle(t,e),this.quaternion.premultiply(Ba),this}rotateX(t){return this.rotateOnAxis(ry,t)}rotateY(t){return this.rotateOnAxis(oy,t)}rotateZ(t){return this.rotateOnAxis(ay,t)}translateOnAxis(t,e){return sy.copy(t).applyQuaternion(this.quaternion),this.position.add(sy.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(ry,t)}translateY(t){return this.translateOnAxis(oy,t)}translateZ(t){return this.translateOnAxis(ay,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(Er.copy(this.matrixWorld).invert())}lookAt(t,e,i){t.isVector3?hh.copy(t):hh.set(t,e,i);let s=this.parent;this.updateWorldMatrix(!0,!1),pc.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Er.lookAt(pc,hh,this.up):Er.lookAt(hh,pc,this.up),this.quaternion.setFromRotationMatrix(Er),s&&(Er.extractRotation(s.matrixWorld),Ba.setFromRotationMatrix(Er),this.quaternion.premultiply(Ba.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(ce("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(ly),ka.child=t,this.dispatchEvent(ka),ka.child=null):ce("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(ST),Mm.child=t,this.dispatchEvent(Mm),Mm.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),Er.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),Er.multiply(t.parent.matrixWorld)),t.applyMatrix4(Er),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(ly),ka.child=t,this.dispatchEvent(ka),ka.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,i=[]){this[t]===e&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,i);return i}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(pc,t,wT),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(pc,MT,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,i=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*i-r[8]*s,r[13]+=i-r[1]*e-r[5]*i-r[9]*s,r[14]+=s-r[2]*e-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].updateMatrixWorld(t)}updateWorldMatrix(t,e,i=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(t){let e=t===void 0||typeof t=="string",i={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let h=l[c];r(t.shapes,h)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),u=o(t.images),h=o(t.shapes),d=o(t.skeletons),f=o(t.animations),p=o(t.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),h.length>0&&(i.shapes=h),d.length>0&&(i.skeletons=d),f.length>0&&(i.animations=f),p.length>0&&(i.nodes=p)}return i.object=s,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let i=0;i<t.children.length;i++){let s=t.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};ki.DEFAULT_UP=new V(0,1,0);ki.DEFAULT_MATRIX_AUTO_UPDATE=!0;ki.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Rn=class extends ki{constructor(){super(),this.isGroup=!0,this.type="Group"}},ET={type:"move"},nl=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Rn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Rn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new V,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new V),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Rn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new V,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new V,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let i of t.hand.values())this._getHandJoint(e,i)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let y of t.hand.values()){let g=e.getJointPose(y,i),m=this._getHandJoint(c,y);g!==null&&(m.matrix.fromArray(g.transform.matrix),m.matrix.decompose(m.position,m.quaternion,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=g.radius),m.visible=g!==null}let u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],d=u.position.distanceTo(h.position),f=.02,p=.005;c.inputState.pinching&&d>f+p?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&d<=f-p&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(ET)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let i=new Rn;i.matrixAutoUpdate=!1,i.visible=!1,t.joints[e.jointName]=i,t.add(i)}return t.joints[e.jointName]}},dv={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},ro={h:0,s:0,l:0},dh={h:0,s:0,l:0};function Sm(n,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?n+(t-n)*6*e:e<1/2?t:e<2/3?n+(t-n)*6*(2/3-e):n}var ee=class{constructor(t,e,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,i)}set(t,e,i){if(e===void 0&&i===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,i);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=Ti){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,De.colorSpaceToWorking(this,e),this}setRGB(t,e,i,s=De.workingColorSpace){return this.r=t,this.g=e,this.b=i,De.colorSpaceToWorking(this,s),this}setHSL(t,e,i,s=De.workingColorSpace){if(t=wg(t,1),e=Ae(e,0,1),i=Ae(i,0,1),e===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+e):i+e-i*e,o=2*i-r;this.r=Sm(o,r,t+1/3),this.g=Sm(o,r,t),this.b=Sm(o,r,t-1/3)}return De.colorSpaceToWorking(this,s),this}setStyle(t,e=Ti){function i(r){r!==void 0&&parseFloat(r)<1&&ie("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:ie("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);ie("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=Ti){let i=dv[t.toLowerCase()];return i!==void 0?this.setHex(i,e):ie("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=Pr(t.r),this.g=Pr(t.g),this.b=Pr(t.b),this}copyLinearToSRGB(t){return this.r=Za(t.r),this.g=Za(t.g),this.b=Za(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=Ti){return De.workingToColorSpace(fi.copy(this),t),Math.round(Ae(fi.r*255,0,255))*65536+Math.round(Ae(fi.g*255,0,255))*256+Math.round(Ae(fi.b*255,0,255))}getHexString(t=Ti){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=De.workingColorSpace){De.workingToColorSpace(fi.copy(this),e);let i=fi.r,s=fi.g,r=fi.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case i:l=(s-r)/h+(s<r?6:0);break;case s:l=(r-i)/h+2;break;case r:l=(i-s)/h+4;break}l/=6}return t.h=l,t.s=c,t.l=u,t}getRGB(t,e=De.workingColorSpace){return De.workingToColorSpace(fi.copy(this),e),t.r=fi.r,t.g=fi.g,t.b=fi.b,t}getStyle(t=Ti){De.workingToColorSpace(fi.copy(this),t);let e=fi.r,i=fi.g,s=fi.b;return t!==Ti?`color(${t} ${e.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(t,e,i){return this.getHSL(ro),this.setHSL(ro.h+t,ro.s+e,ro.l+i)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,i){return this.r=t.r+(e.r-t.r)*i,this.g=t.g+(e.g-t.g)*i,this.b=t.b+(e.b-t.b)*i,this}lerpHSL(t,e){this.getHSL(ro),t.getHSL(dh);let i=Mc(ro.h,dh.h,e),s=Mc(ro.s,dh.s,e),r=Mc(ro.l,dh.l,e);return this.setHSL(i,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,i=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*i+r[6]*s,this.g=r[1]*e+r[4]*i+r[7]*s,this.b=r[2]*e+r[5]*i+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},fi=new ee;ee.NAMES=dv;var Ic=class n{constructor(t,e=1,i=1e3){this.isFog=!0,this.name="",this.color=new ee(t),this.near=e,this.far=i}clone(){return new n(this.color,this.near,this.far)}toJSON(){return{type:"Fog",name:this.name,color:this.color.getHex(),near:this.near,far:this.far}}},Lc=class extends ki{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new uo,this.environmentIntensity=1,this.environmentRotation=new uo,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},Is=new V,Tr=new V,Em=new V,Ar=new V,za=new V,Ha=new V,cy=new V,Tm=new V,Am=new V,Rm=new V,Cm=new bn,Pm=new bn,Im=new bn,co=class n{constructor(t=new V,e=new V,i=new V){this.a=t,this.b=e,this.c=i}static getNormal(t,e,i,s){s.subVectors(i,e),Is.subVectors(t,e),s.cross(Is);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,i,s,r){Is.subVectors(s,e),Tr.subVectors(i,e),Em.subVectors(t,e);let o=Is.dot(Is),a=Is.dot(Tr),l=Is.dot(Em),c=Tr.dot(Tr),u=Tr.dot(Em),h=o*c-a*a;if(h===0)return r.set(0,0,0),null;let d=1/h,f=(c*l-a*u)*d,p=(o*u-a*l)*d;return r.set(1-f-p,p,f)}static containsPoint(t,e,i,s){return this.getBarycoord(t,e,i,s,Ar)===null?!1:Ar.x>=0&&Ar.y>=0&&Ar.x+Ar.y<=1}static getInterpolation(t,e,i,s,r,o,a,l){return this.getBarycoord(t,e,i,s,Ar)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Ar.x),l.addScaledVector(o,Ar.y),l.addScaledVector(a,Ar.z),l)}static getInterpolatedAttribute(t,e,i,s,r,o){return Cm.setScalar(0),Pm.setScalar(0),Im.setScalar(0),Cm.fromBufferAttribute(t,e),Pm.fromBufferAttribute(t,i),Im.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(Cm,r.x),o.addScaledVector(Pm,r.y),o.addScaledVector(Im,r.z),o}static isFrontFacing(t,e,i,s){return Is.subVectors(i,e),Tr.subVectors(t,e),Is.cross(Tr).dot(s)<0}set(t,e,i){return this.a.copy(t),this.b.copy(e),this.c.copy(i),this}setFromPointsAndIndices(t,e,i,s){return this.a.copy(t[e]),this.b.copy(t[i]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,i,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,i),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return Is.subVectors(this.c,this.b),Tr.subVectors(this.a,this.b),Is.cross(Tr).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return n.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return n.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,i,s,r){return n.getInterpolation(t,this.a,this.b,this.c,e,i,s,r)}containsPoint(t){return n.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return n.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let i=this.a,s=this.b,r=this.c,o,a;za.subVectors(s,i),Ha.subVectors(r,i),Tm.subVectors(t,i);let l=za.dot(Tm),c=Ha.dot(Tm);if(l<=0&&c<=0)return e.copy(i);Am.subVectors(t,s);let u=za.dot(Am),h=Ha.dot(Am);if(u>=0&&h<=u)return e.copy(s);let d=l*h-u*c;if(d<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),e.copy(i).addScaledVector(za,o);Rm.subVectors(t,r);let f=za.dot(Rm),p=Ha.dot(Rm);if(p>=0&&f<=p)return e.copy(r);let y=f*c-l*p;if(y<=0&&c>=0&&p<=0)return a=c/(c-p),e.copy(i).addScaledVector(Ha,a);let g=u*p-f*h;if(g<=0&&h-u>=0&&f-p>=0)return cy.subVectors(r,s),a=(h-u)/(h-u+(f-p)),e.copy(s).addScaledVector(cy,a);let m=1/(g+y+d);return o=y*m,a=d*m,e.copy(i).addScaledVector(za,o).addScaledVector(Ha,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},zi=class{constructor(t=new V(1/0,1/0,1/0),e=new V(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e+=3)this.expandByPoint(Ls.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,i=t.count;e<i;e++)this.expandByPoint(Ls.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let i=Ls.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(i),this.max.copy(t).add(i),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let i=t.geometry;if(i!==void 0){let r=i.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,Ls):Ls.fromBufferAttribute(r,o),Ls.applyMatrix4(t.matrixWorld),this.expandByPoint(Ls);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),fh.copy(t.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),fh.copy(i.boundingBox)),fh.applyMatrix4(t.matrixWorld),this.union(fh)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Ls),Ls.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,i;return t.normal.x>0?(e=t.normal.x*this.min.x,i=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,i=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,i+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,i+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,i+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,i+=t.normal.z*this.min.z),e<=-t.constant&&i>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(mc),ph.subVectors(this.max,mc),Ga.subVectors(t.a,mc),Va.subVectors(t.b,mc),Wa.subVectors(t.c,mc),oo.subVectors(Va,Ga),ao.subVectors(Wa,Va),Ho.subVectors(Ga,Wa);let e=[0,-oo.z,oo.y,0,-ao.z,ao.y,0,-Ho.z,Ho.y,oo.z,0,-oo.x,ao.z,0,-ao.x,Ho.z,0,-Ho.x,-oo.y,oo.x,0,-ao.y,ao.x,0,-Ho.y,Ho.x,0];return!Lm(e,Ga,Va,Wa,ph)||(e=[1,0,0,0,1,0,0,0,1],!Lm(e,Ga,Va,Wa,ph))?!1:(mh.crossVectors(oo,ao),e=[mh.x,mh.y,mh.z],Lm(e,Ga,Va,Wa,ph))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Ls).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Ls).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(Rr[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),Rr[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),Rr[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),Rr[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),Rr[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),Rr[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),Rr[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),Rr[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(Rr),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},Rr=[new V,new V,new V,new V,new V,new V,new V,new V],Ls=new V,fh=new zi,Ga=new V,Va=new V,Wa=new V,oo=new V,ao=new V,Ho=new V,mc=new V,ph=new V,mh=new V,Go=new V;function Lm(n,t,e,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){Go.fromArray(n,r);let a=s.x*Math.abs(Go.x)+s.y*Math.abs(Go.y)+s.z*Math.abs(Go.z),l=t.dot(Go),c=e.dot(Go),u=i.dot(Go);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var Fn=new V,gh=new Qt,TT=0,He=class extends Ds{constructor(t,e,i=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:TT++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=i,this.usage=vg,this.updateRanges=[],this.gpuType=ps,this.version=0,this._normalizationScale=t!==void 0?nf(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,i){t*=this.itemSize,i*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[i+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,i=this.count;e<i;e++)gh.fromBufferAttribute(this,e),gh.applyMatrix3(t),this.setXY(e,gh.x,gh.y);else if(this.itemSize===3)for(let e=0,i=this.count;e<i;e++)Fn.fromBufferAttribute(this,e),Fn.applyMatrix3(t),this.setXYZ(e,Fn.x,Fn.y,Fn.z);return this}applyMatrix4(t){for(let e=0,i=this.count;e<i;e++)Fn.fromBufferAttribute(this,e),Fn.applyMatrix4(t),this.setXYZ(e,Fn.x,Fn.y,Fn.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)Fn.fromBufferAttribute(this,e),Fn.applyNormalMatrix(t),this.setXYZ(e,Fn.x,Fn.y,Fn.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)Fn.fromBufferAttribute(this,e),Fn.transformDirection(t),this.setXYZ(e,Fn.x,Fn.y,Fn.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let i=this.array[t*this.itemSize+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.array[t*this.itemSize+e]=i,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,i){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.array[t+0]=e,this.array[t+1]=i,this}setXYZ(t,e,i,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):Sg(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):Eg(t,this.array)}};var Dc=class extends He{constructor(t,e,i){super(new Uint16Array(t),e,i)}};var Nc=class extends He{constructor(t,e,i){super(new Uint32Array(t),e,i)}};var be=class extends He{constructor(t,e,i){super(new Float32Array(t),e,i)}},AT=new zi,gc=new V,Dm=new V,sr=class{constructor(t=new V,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let i=this.center;e!==void 0?i.copy(e):AT.setFromPoints(t).getCenter(i);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,i.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let i=this.center.distanceToSquared(t);return e.copy(t),i>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;gc.subVectors(t,this.center);let e=gc.lengthSq();if(e>this.radius*this.radius){let i=Math.sqrt(e),s=(i-this.radius)*.5;this.center.addScaledVector(gc,s/i),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(Dm.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(gc.copy(t.center).add(Dm)),this.expandByPoint(gc.copy(t.center).sub(Dm))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},RT=0,ds=new ye,Nm=new ki,$a=new V,Qi=new zi,xc=new zi,ei=new V,we=class n extends Ds{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:RT++}),this.uuid=_o(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(QE(t)?Nc:Dc)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,i=0){this.groups.push({start:t,count:e,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new fe().getNormalMatrix(t);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return ds.makeRotationFromQuaternion(t),this.applyMatrix4(ds),this}rotateX(t){return ds.makeRotationX(t),this.applyMatrix4(ds),this}rotateY(t){return ds.makeRotationY(t),this.applyMatrix4(ds),this}rotateZ(t){return ds.makeRotationZ(t),this.applyMatrix4(ds),this}translate(t,e,i){return ds.makeTranslation(t,e,i),this.applyMatrix4(ds),this}scale(t,e,i){return ds.makeScale(t,e,i),this.applyMatrix4(ds),this}lookAt(t){return Nm.lookAt(t),Nm.updateMatrix(),this.applyMatrix4(Nm.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter($a).negate(),this.translate($a.x,$a.y,$a.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let i=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new be(i,3))}else{let i=Math.min(t.length,e.count);for(let s=0;s<i;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&ie("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new zi);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){ce("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new V(-1/0,-1/0,-1/0),new V(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let i=0,s=e.length;i<s;i++){let r=e[i];Qi.setFromBufferAttribute(r),this.morphTargetsRelative?(ei.addVectors(this.boundingBox.min,Qi.min),this.boundingBox.expandByPoint(ei),ei.addVectors(this.boundingBox.max,Qi.max),this.boundingBox.expandByPoint(ei)):(this.boundingBox.expandByPoint(Qi.min),this.boundingBox.expandByPoint(Qi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&ce('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new sr);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){ce("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new V,1/0);return}if(t){let i=this.boundingSphere.center;if(Qi.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];xc.setFromBufferAttribute(a),this.morphTargetsRelative?(ei.addVectors(Qi.min,xc.min),Qi.expandByPoint(ei),ei.addVectors(Qi.max,xc.max),Qi.expandByPoint(ei)):(Qi.expandByPoint(xc.min),Qi.expandByPoint(xc.max))}Qi.getCenter(i);let s=0;for(let r=0,o=t.count;r<o;r++)ei.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(ei));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)ei.fromBufferAttribute(a,c),l&&($a.fromBufferAttribute(t,c),ei.add($a)),s=Math.max(s,i.distanceToSquared(ei))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&ce('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){ce("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new He(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let N=0;N<i.count;N++)a[N]=new V,l[N]=new V;let u=new V,h=new V,d=new V,f=new Qt,p=new Qt,y=new Qt,g=new V,m=new V;function x(N,R,L){c[N]=c[R]=c[L]=1,u.fromBufferAttribute(i,N),h.fromBufferAttribute(i,R),d.fromBufferAttribute(i,L),f.fromBufferAttribute(r,N),p.fromBufferAttribute(r,R),y.fromBufferAttribute(r,L),h.sub(u),d.sub(u),p.sub(f),y.sub(f);let z=1/(p.x*y.y-y.x*p.y);isFinite(z)&&(g.copy(h).multiplyScalar(y.y).addScaledVector(d,-p.y).multiplyScalar(z),m.copy(d).multiplyScalar(p.x).addScaledVector(h,-y.x).multiplyScalar(z),a[N].add(g),a[R].add(g),a[L].add(g),l[N].add(m),l[R].add(m),l[L].add(m))}let w=this.groups;w.length===0&&(w=[{start:0,count:t.count}]);for(let N=0,R=w.length;N<R;++N){let L=w[N],z=L.start,G=L.count;for(let F=z,U=z+G;F<U;F+=3)x(t.getX(F+0),t.getX(F+1),t.getX(F+2))}let v=new V,A=new V,S=new V,_=new V;function M(N){S.fromBufferAttribute(s,N),_.copy(S);let R=a[N];v.copy(R),v.sub(S.multiplyScalar(S.dot(R))).normalize(),A.crossVectors(_,R);let z=A.dot(l[N])<0?-1:1;o.setXYZW(N,v.x,v.y,v.z,z)}for(let N=0,R=i.count;N<R;++N)c[N]&&M(N);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==e.count)i=new He(new Float32Array(e.count*3),3),this.setAttribute("normal",i);else for(let d=0,f=i.count;d<f;d++)i.setXYZ(d,0,0,0);let s=new V,r=new V,o=new V,a=new V,l=new V,c=new V,u=new V,h=new V;if(t)for(let d=0,f=t.count;d<f;d+=3){let p=t.getX(d+0),y=t.getX(d+1),g=t.getX(d+2);s.fromBufferAttribute(e,p),r.fromBufferAttribute(e,y),o.fromBufferAttribute(e,g),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(i,p),l.fromBufferAttribute(i,y),c.fromBufferAttribute(i,g),a.add(u),l.add(u),c.add(u),i.setXYZ(p,a.x,a.y,a.z),i.setXYZ(y,l.x,l.y,l.z),i.setXYZ(g,c.x,c.y,c.z)}else for(let d=0,f=e.count;d<f;d+=3)s.fromBufferAttribute(e,d+0),r.fromBufferAttribute(e,d+1),o.fromBufferAttribute(e,d+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),i.setXYZ(d+0,u.x,u.y,u.z),i.setXYZ(d+1,u.x,u.y,u.z),i.setXYZ(d+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,i=t.count;e<i;e++)ei.fromBufferAttribute(t,e),ei.normalize(),t.setXYZ(e,ei.x,ei.y,ei.z)}toNonIndexed(){function t(a,l){let c=a.array,u=a.itemSize,h=a.normalized,d=new c.constructor(l.length*u),f=0,p=0;for(let y=0,g=l.length;y<g;y++){a.isInterleavedBufferAttribute?f=l[y]*a.data.stride+a.offset:f=l[y]*u;for(let m=0;m<u;m++)d[p++]=c[f++]}return new He(d,u,h)}if(this.index===null)return ie("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,i);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,h=c.length;u<h;u++){let d=c[u],f=t(d,i);l.push(f)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let i=this.attributes;for(let l in i){let c=i[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let h=0,d=c.length;h<d;h++){let f=c[h];u.push(f.toJSON(t.data))}u.length>0&&(s[l]=u,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let i=t.index;i!==null&&this.setIndex(i.clone());let s=t.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(e))}let r=t.morphAttributes;for(let c in r){let u=[],h=r[c];for(let d=0,f=h.length;d<f;d++)u.push(h[d].clone(e));this.morphAttributes[c]=u}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,u=o.length;c<u;c++){let h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},il=class{constructor(t,e){this.isInterleavedBuffer=!0,this.array=t,this.stride=e,this.count=t!==void 0?t.length/e:0,this.usage=vg,this.updateRanges=[],this.version=0,this.uuid=_o()}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.array=new t.array.constructor(t.array),this.count=t.count,this.stride=t.stride,this.usage=t.usage,this}copyAt(t,e,i){t*=this.stride,i*=e.stride;for(let s=0,r=this.stride;s<r;s++)this.array[t+s]=e.array[i+s];return this}set(t,e=0){return this.array.set(t,e),this}clone(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=uy(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=this.array.slice(0).buffer);let i=new this.array.constructor(t.arrayBuffers[e]),s=new this.constructor(i,this.stride);return s.setUsage(this.usage),s}onUpload(t){return this.onUploadCallback=t,this}toJSON(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=uy(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let i={uuid:this.uuid,buffer:e,type:this.array.constructor.name,stride:this.stride};return i.usage=this.usage,i}};function uy(n){return n.buffer._uuid===void 0&&(n.buffer._uuid=_o()),n.byteOffset===0&&n.byteLength===n.buffer.byteLength?n.buffer._uuid:n.buffer._uuid+":"+n.byteOffset+":"+n.byteLength}var Ei=new V,sl=class n{constructor(t,e,i,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=t,this.itemSize=e,this.offset=i,this.normalized=s,this._normalizationScale=t!==void 0?nf(t.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(t){this.data.needsUpdate=t}applyMatrix4(t){for(let e=0,i=this.data.count;e<i;e++)Ei.fromBufferAttribute(this,e),Ei.applyMatrix4(t),this.setXYZ(e,Ei.x,Ei.y,Ei.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)Ei.fromBufferAttribute(this,e),Ei.applyNormalMatrix(t),this.setXYZ(e,Ei.x,Ei.y,Ei.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)Ei.fromBufferAttribute(this,e),Ei.transformDirection(t),this.setXYZ(e,Ei.x,Ei.y,Ei.z);return this}getComponent(t,e){let i=this.array[t*this.data.stride+this.offset+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.data.array[t*this.data.stride+this.offset+e]=i,this}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset]=e,this}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+1]=e,this}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+2]=e,this}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+3]=e,this}getX(t){let e=this.data.array[t*this.data.stride+this.offset];return this.normalized&&(e=this._denormalize(e)),e}getY(t){let e=this.data.array[t*this.data.stride+this.offset+1];return this.normalized&&(e=this._denormalize(e)),e}getZ(t){let e=this.data.array[t*this.data.stride+this.offset+2];return this.normalized&&(e=this._denormalize(e)),e}getW(t){let e=this.data.array[t*this.data.stride+this.offset+3];return this.normalized&&(e=this._denormalize(e)),e}setXY(t,e,i){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.data.array[t+0]=e,this.data.array[t+1]=i,this}setXYZ(t,e,i,s){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.data.array[t+0]=e,this.data.array[t+1]=i,this.data.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.data.array[t+0]=e,this.data.array[t+1]=i,this.data.array[t+2]=s,this.data.array[t+3]=r,this}clone(t){if(t===void 0){Cc("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return new He(new this.array.constructor(e),this.itemSize,this.normalized)}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.clone(t)),new n(t.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(t){if(t===void 0){Cc("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:e,normalized:this.normalized}}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.toJSON(t)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):Sg(t,this.data.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):Eg(t,this.data.array)}},Um=new V,CT=new V,PT=new fe,ri=class{constructor(t=new V(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,i,s){return this.normal.set(t,e,i),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,i){let s=Um.subVectors(i,e).cross(CT.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,i=!0){let s=t.delta(Um),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),i=this.distanceToPoint(t.end);return e<0&&i>0||i<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let i=e||PT.getNormalMatrix(t),s=this.coplanarPoint(Um).applyMatrix4(t),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},IT=0,Lr=class extends Ds{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:IT++}),this.uuid=_o(),this.name="",this.type="Material",this.blending=ul,this.side=ar,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Jm,this.blendDst=Km,this.blendEquation=Zo,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new ee(0,0,0),this.blendAlpha=0,this.depthFunc=Ja,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=nv,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Oh,this.stencilZFail=Oh,this.stencilZPass=Oh,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let i=t[e];if(i===void 0){ie(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){ie(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(t).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(t).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(t).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(t).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(t).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new ee().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(i=>new ri().fromJSON(i))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let i=t.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new Qt().fromArray(i)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Qt().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,i=null;if(e!==null){let s=e.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=e[r].clone()}return this.clippingPlanes=i,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}};var Cr=new V,Om=new V,xh=new V,_h=new V,Dr=class{constructor(t=new V,e=new V(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,Cr)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let i=e.dot(this.direction);return i<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=Cr.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(Cr.copy(this.origin).addScaledVector(this.direction,e),Cr.distanceToSquared(t))}distanceSqToSegment(t,e,i,s){Om.copy(t).add(e).multiplyScalar(.5),xh.copy(e).sub(t).normalize(),_h.copy(this.origin).sub(Om);let r=t.distanceTo(e)*.5,o=-this.direction.dot(xh),a=_h.dot(this.direction),l=-_h.dot(xh),c=_h.lengthSq(),u=Math.abs(1-o*o),h,d,f,p;if(u>0)if(h=o*l-a,d=o*a-l,p=r*u,h>=0)if(d>=-p)if(d<=p){let y=1/u;h*=y,d*=y,f=h*(h+o*d+2*a)+d*(o*h+d+2*l)+c}else d=r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;else d=-r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;else d<=-p?(h=Math.max(0,-(-o*r+a)),d=h>0?-r:Math.min(Math.max(-r,-l),r),f=-h*h+d*(d+2*l)+c):d<=p?(h=0,d=Math.min(Math.max(-r,-l),r),f=d*(d+2*l)+c):(h=Math.max(0,-(o*r+a)),d=h>0?r:Math.min(Math.max(-r,-l),r),f=-h*h+d*(d+2*l)+c);else d=o>0?-r:r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(Om).addScaledVector(xh,d),f}intersectSphere(t,e){if(t.radius<0)return null;Cr.subVectors(t.center,this.origin);let i=Cr.dot(this.direction),s=Cr.dot(Cr)-i*i,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(t.normal)+t.constant)/e;return i>=0?i:null}intersectPlane(t,e){let i=this.distanceToPlane(t);return i===null?null:this.at(i,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let i,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,d=this.origin;return c>=0?(i=(t.min.x-d.x)*c,s=(t.max.x-d.x)*c):(i=(t.max.x-d.x)*c,s=(t.min.x-d.x)*c),u>=0?(r=(t.min.y-d.y)*u,o=(t.max.y-d.y)*u):(r=(t.max.y-d.y)*u,o=(t.min.y-d.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(t.min.z-d.z)*h,l=(t.max.z-d.z)*h):(a=(t.max.z-d.z)*h,l=(t.min.z-d.z)*h),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,e)}intersectsBox(t){return this.intersectBox(t,Cr)!==null}intersectTriangle(t,e,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,h=t.x-o.x,d=t.y-o.y,f=t.z-o.z,p=e.x-o.x,y=e.y-o.y,g=e.z-o.z,m=i.x-o.x,x=i.y-o.y,w=i.z-o.z,v=Math.abs(l),A=Math.abs(c),S=Math.abs(u),_,M,N,R,L,z,G,F,U,D,O,Z;if(v>=A&&v>=S?(N=l,z=h,U=p,Z=m,l>=0?(_=c,M=u,R=d,L=f,G=y,F=g,D=x,O=w):(_=u,M=c,R=f,L=d,G=g,F=y,D=w,O=x)):A>=S?(N=c,z=d,U=y,Z=x,c>=0?(_=u,M=l,R=f,L=h,G=g,F=p,D=w,O=m):(_=l,M=u,R=h,L=f,G=p,F=g,D=m,O=w)):(N=u,z=f,U=g,Z=w,u>=0?(_=l,M=c,R=h,L=d,G=p,F=y,D=m,O=x):(_=c,M=l,R=d,L=h,G=y,F=p,D=x,O=m)),N===0)return null;let X=_/N,J=M/N,nt=1/N,dt=R-X*z,ft=L-J*z,st=G-X*U,yt=F-J*U,xt=D-X*Z,Tt=O-J*Z,At=xt*yt-Tt*st,Jt=dt*Tt-ft*xt,xe=st*ft-yt*dt;if(s){if(At<0||Jt<0||xe<0)return null}else if((At<0||Jt<0||xe<0)&&(At>0||Jt>0||xe>0))return null;let jt=At+Jt+xe;if(jt===0)return null;let Te=nt*(At*z+Jt*U+xe*Z);return(jt>0?Te<0:Te>0)?null:this.at(Te/jt,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Vn=class extends Lr{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new ee(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new uo,this.combine=Qm,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},hy=new ye,Vo=new Dr,yh=new sr,dy=new V,vh=new V,bh=new V,wh=new V,Fm=new V,Mh=new V,fy=new V,Sh=new V,Ge=class extends ki{constructor(t=new we,e=new Vn){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){Mh.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],h=r[l];u!==0&&(Fm.fromBufferAttribute(h,t),o?Mh.addScaledVector(Fm,u):Mh.addScaledVector(Fm.sub(e),u))}e.add(Mh)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),yh.copy(i.boundingSphere),yh.applyMatrix4(r),Vo.copy(t.ray).recast(t.near),!(yh.containsPoint(Vo.origin)===!1&&(Vo.intersectSphere(yh,dy)===null||Vo.origin.distanceToSquared(dy)>(t.far-t.near)**2))&&(hy.copy(r).invert(),Vo.copy(t.ray).applyMatrix4(hy),!(i.boundingBox!==null&&Vo.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(t,e,Vo)))}_computeIntersections(t,e,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,y=d.length;p<y;p++){let g=d[p],m=o[g.materialIndex],x=Math.max(g.start,f.start),w=Math.min(a.count,Math.min(g.start+g.count,f.start+f.count));for(let v=x,A=w;v<A;v+=3){let S=a.getX(v),_=a.getX(v+1),M=a.getX(v+2);s=Eh(this,m,t,i,c,u,h,S,_,M),s&&(s.faceIndex=Math.floor(v/3),s.face.materialIndex=g.materialIndex,e.push(s))}}else{let p=Math.max(0,f.start),y=Math.min(a.count,f.start+f.count);for(let g=p,m=y;g<m;g+=3){let x=a.getX(g),w=a.getX(g+1),v=a.getX(g+2);s=Eh(this,o,t,i,c,u,h,x,w,v),s&&(s.faceIndex=Math.floor(g/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let p=0,y=d.length;p<y;p++){let g=d[p],m=o[g.materialIndex],x=Math.max(g.start,f.start),w=Math.min(l.count,Math.min(g.start+g.count,f.start+f.count));for(let v=x,A=w;v<A;v+=3){let S=v,_=v+1,M=v+2;s=Eh(this,m,t,i,c,u,h,S,_,M),s&&(s.faceIndex=Math.floor(v/3),s.face.materialIndex=g.materialIndex,e.push(s))}}else{let p=Math.max(0,f.start),y=Math.min(l.count,f.start+f.count);for(let g=p,m=y;g<m;g+=3){let x=g,w=g+1,v=g+2;s=Eh(this,o,t,i,c,u,h,x,w,v),s&&(s.faceIndex=Math.floor(g/3),e.push(s))}}}};function LT(n,t,e,i,s,r,o,a){let l;if(t.side===oi?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,t.side===ar,a),l===null)return null;Sh.copy(a),Sh.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(Sh);return c<e.near||c>e.far?null:{distance:c,point:Sh.clone(),object:n}}function Eh(n,t,e,i,s,r,o,a,l,c){n.getVertexPosition(a,vh),n.getVertexPosition(l,bh),n.getVertexPosition(c,wh);let u=LT(n,t,e,i,vh,bh,wh,fy);if(u){let h=new V;co.getBarycoord(fy,vh,bh,wh,h),s&&(u.uv=co.getInterpolatedAttribute(s,a,l,c,h,new Qt)),r&&(u.uv1=co.getInterpolatedAttribute(r,a,l,c,h,new Qt)),o&&(u.normal=co.getInterpolatedAttribute(o,a,l,c,h,new V),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new V,materialIndex:0};co.getNormal(vh,bh,wh,d.normal),u.face=d,u.barycoord=h}return u}var Uc=class extends Bi{constructor(t=null,e=1,i=1,s,r,o,a,l,c=ni,u=ni,h,d){super(null,o,a,l,c,u,s,r,h,d),this.isDataTexture=!0,this.image={data:t,width:e,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var rl=class extends He{constructor(t,e,i,s=1){super(t,e,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}toJSON(){let t=super.toJSON();return t.meshPerAttribute=this.meshPerAttribute,t.isInstancedBufferAttribute=!0,t}},qa=new ye,py=new ye,Th=[],my=new zi,DT=new ye,_c=new Ge,yc=new sr,Oc=class extends Ge{constructor(t,e,i){super(t,e),this.isInstancedMesh=!0,this.instanceMatrix=new rl(new Float32Array(i*16),16),this.instanceColor=null,this.morphTexture=null,this.count=i,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<i;s++)this.setMatrixAt(s,DT)}computeBoundingBox(){let t=this.geometry,e=this.count;this.boundingBox===null&&(this.boundingBox=new zi),t.boundingBox===null&&t.computeBoundingBox(),this.boundingBox.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,qa),my.copy(t.boundingBox).applyMatrix4(qa),this.boundingBox.union(my)}computeBoundingSphere(){let t=this.geometry,e=this.count;this.boundingSphere===null&&(this.boundingSphere=new sr),t.boundingSphere===null&&t.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,qa),yc.copy(t.boundingSphere).applyMatrix4(qa),this.boundingSphere.union(yc)}copy(t,e){return super.copy(t,e),this.instanceMatrix.copy(t.instanceMatrix),this.morphTexture=t.morphTexture!==null?t.morphTexture.clone():null,this.instanceColor=t.instanceColor!==null?t.instanceColor.clone():null,this.count=t.count,this.boundingBox=t.boundingBox!==null?t.boundingBox.clone():null,this.boundingSphere=t.boundingSphere!==null?t.boundingSphere.clone():null,this}getColorAt(t,e){return this.instanceColor===null?e.setRGB(1,1,1):e.fromArray(this.instanceColor.array,t*3)}getMatrixAt(t,e){return e.fromArray(this.instanceMatrix.array,t*16)}getMorphAt(t,e){let i=e.morphTargetInfluences,s=this.morphTexture.source.data.data,r=i.length+1,o=t*r+1;for(let a=0;a<i.length;a++)i[a]=s[o+a]}raycast(t,e){let i=this.matrixWorld,s=this.count;if(_c.geometry=this.geometry,_c.material=this.material,_c.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),yc.copy(this.boundingSphere),yc.applyMatrix4(i),t.ray.intersectsSphere(yc)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,qa),py.multiplyMatrices(i,qa),_c.matrixWorld=py,_c.raycast(t,Th);for(let o=0,a=Th.length;o<a;o++){let l=Th[o];l.instanceId=r,l.object=this,e.push(l)}Th.length=0}}setColorAt(t,e){return this.instanceColor===null&&(this.instanceColor=new rl(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),e.toArray(this.instanceColor.array,t*3),this}setMatrixAt(t,e){return e.toArray(this.instanceMatrix.array,t*16),this}setMorphAt(t,e){let i=e.morphTargetInfluences,s=i.length+1;this.morphTexture===null&&(this.morphTexture=new Uc(new Float32Array(s*this.count),s,this.count,bd,ps));let r=this.morphTexture.source.data.data,o=0;for(let c=0;c<i.length;c++)o+=i[c];let a=this.geometry.morphTargetsRelative?1:1-o,l=s*t;return r[l]=a,r.set(i,l+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},Wo=new sr,NT=new Qt(.5,.5),Ah=new V,$o=class{constructor(t=new ri,e=new ri,i=new ri,s=new ri,r=new ri,o=new ri){this.planes=[t,e,i,s,r,o]}set(t,e,i,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let i=0;i<6;i++)e[i].copy(t.planes[i]);return this}setFromProjectionMatrix(t,e=fs,i=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],h=r[5],d=r[6],f=r[7],p=r[8],y=r[9],g=r[10],m=r[11],x=r[12],w=r[13],v=r[14],A=r[15];if(s[0].setComponents(c-o,f-u,m-p,A-x).normalize(),s[1].setComponents(c+o,f+u,m+p,A+x).normalize(),s[2].setComponents(c+a,f+h,m+y,A+w).normalize(),s[3].setComponents(c-a,f-h,m-y,A-w).normalize(),i)s[4].setComponents(l,d,g,v).normalize(),s[5].setComponents(c-l,f-d,m-g,A-v).normalize();else if(s[4].setComponents(c-l,f-d,m-g,A-v).normalize(),e===fs)s[5].setComponents(c+l,f+d,m+g,A+v).normalize();else if(e===Ac)s[5].setComponents(l,d,g,v).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),Wo.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),Wo.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(Wo)}intersectsSprite(t){Wo.center.set(0,0,0);let e=NT.distanceTo(t.center);return Wo.radius=.7071067811865476+e,Wo.applyMatrix4(t.matrixWorld),this.intersectsSphere(Wo)}intersectsSphere(t){let e=this.planes,i=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let i=0;i<6;i++){let s=e[i];if(Ah.x=s.normal.x>0?t.max.x:t.min.x,Ah.y=s.normal.y>0?t.max.y:t.min.y,Ah.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(Ah)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let i=0;i<6;i++)if(e[i].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},gy=new ye,Zh=class n{constructor(){this.coordinateSystem=fs,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,i=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];gy.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new $o),i[s].setFromProjectionMatrix(gy,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,i=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new $o),e[s].copy(i[s]);return this._count=t._count,this}clone(){return new n().copy(this)}};var es=class extends Lr{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new ee(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},Jh=new V,Kh=new V,xy=new ye,vc=new Dr,Rh=new sr,Bm=new V,_y=new V,rr=class extends ki{constructor(t=new we,e=new es){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[0];for(let s=1,r=e.count;s<r;s++)Jh.fromBufferAttribute(e,s-1),Kh.fromBufferAttribute(e,s),i[s]=i[s-1],i[s]+=Jh.distanceTo(Kh);t.setAttribute("lineDistance",new be(i,1))}else ie("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Rh.copy(i.boundingSphere),Rh.applyMatrix4(s),Rh.radius+=r,t.ray.intersectsSphere(Rh)===!1)return;xy.copy(s).invert(),vc.copy(t.ray).applyMatrix4(xy);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,d=i.attributes.position;if(u!==null){let f=Math.max(0,o.start),p=Math.min(u.count,o.start+o.count);for(let y=f,g=p-1;y<g;y+=c){let m=u.getX(y),x=u.getX(y+1),w=Ch(this,t,vc,l,m,x,y);w&&e.push(w)}if(this.isLineLoop){let y=u.getX(p-1),g=u.getX(f),m=Ch(this,t,vc,l,y,g,p-1);m&&e.push(m)}}else{let f=Math.max(0,o.start),p=Math.min(d.count,o.start+o.count);for(let y=f,g=p-1;y<g;y+=c){let m=Ch(this,t,vc,l,y,y+1,y);m&&e.push(m)}if(this.isLineLoop){let y=Ch(this,t,vc,l,p-1,f,p-1);y&&e.push(y)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Ch(n,t,e,i,s,r,o){let a=n.geometry.attributes.position;if(Jh.fromBufferAttribute(a,s),Kh.fromBufferAttribute(a,r),e.distanceSqToSegment(Jh,Kh,Bm,_y)>i)return;Bm.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(Bm);if(!(c<t.near||c>t.far))return{distance:c,point:_y.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var yy=new V,vy=new V,qo=class extends rr{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[];for(let s=0,r=e.count;s<r;s+=2)yy.fromBufferAttribute(e,s),vy.fromBufferAttribute(e,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+yy.distanceTo(vy);t.setAttribute("lineDistance",new be(i,1))}else ie("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var or=class extends Lr{constructor(t){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new ee(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.size=t.size,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},by=new ye,Vm=new Dr,Ph=new sr,Ih=new V,Nr=class extends ki{constructor(t=new we,e=new or){super(),this.isPoints=!0,this.type="Points",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Points.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Ph.copy(i.boundingSphere),Ph.applyMatrix4(s),Ph.radius+=r,t.ray.intersectsSphere(Ph)===!1)return;by.copy(s).invert(),Vm.copy(t.ray).applyMatrix4(by);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=i.index,h=i.attributes.position;if(c!==null){let d=Math.max(0,o.start),f=Math.min(c.count,o.start+o.count);for(let p=d,y=f;p<y;p++){let g=c.getX(p);Ih.fromBufferAttribute(h,g),wy(Ih,g,l,s,t,e,this)}}else{let d=Math.max(0,o.start),f=Math.min(h.count,o.start+o.count);for(let p=d,y=f;p<y;p++)Ih.fromBufferAttribute(h,p),wy(Ih,p,l,s,t,e,this)}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function wy(n,t,e,i,s,r,o){let a=Vm.distanceSqToPoint(n);if(a<e){let l=new V;Vm.closestPointToPoint(n,l),l.applyMatrix4(i);let c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:t,face:null,faceIndex:null,barycoord:null,object:o})}}var Fc=class extends Bi{constructor(t=[],e=Jo,i,s,r,o,a,l,c,u){super(t,e,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}};var Ur=class extends Bi{constructor(t,e,i=Us,s,r,o,a=ni,l=ni,c,u=Ir,h=1){if(u!==Ir&&u!==Fr)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:t,height:e,depth:h};super(d,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new tl(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},Bc=class extends Ur{constructor(t,e=Us,i=Jo,s,r,o=ni,a=ni,l,c=Ir){let u={width:t,height:t,depth:1},h=[u,u,u,u,u,u];super(t,t,e,i,s,r,o,a,l,c),this.image=h,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},kc=class extends Bi{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},Hi=class n extends we{constructor(t=1,e=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],h=[],d=0,f=0;p("z","y","x",-1,-1,i,e,t,o,r,0),p("z","y","x",1,-1,i,e,-t,o,r,1),p("x","z","y",1,1,t,i,e,s,o,2),p("x","z","y",1,-1,t,i,-e,s,o,3),p("x","y","z",1,-1,t,e,i,s,r,4),p("x","y","z",-1,-1,t,e,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new be(c,3)),this.setAttribute("normal",new be(u,3)),this.setAttribute("uv",new be(h,2));function p(y,g,m,x,w,v,A,S,_,M,N){let R=v/_,L=A/M,z=v/2,G=A/2,F=S/2,U=_+1,D=M+1,O=0,Z=0,X=new V;for(let J=0;J<D;J++){let nt=J*L-G;for(let dt=0;dt<U;dt++){let ft=dt*R-z;X[y]=ft*x,X[g]=nt*w,X[m]=F,c.push(X.x,X.y,X.z),X[y]=0,X[g]=0,X[m]=S>0?1:-1,u.push(X.x,X.y,X.z),h.push(dt/_),h.push(1-J/M),O+=1}}for(let J=0;J<M;J++)for(let nt=0;nt<_;nt++){let dt=d+nt+U*J,ft=d+nt+U*(J+1),st=d+(nt+1)+U*(J+1),yt=d+(nt+1)+U*J;l.push(dt,ft,yt),l.push(ft,st,yt),Z+=6}a.addGroup(f,Z,N),f+=Z,d+=O}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}},Xo=class n extends we{constructor(t=1,e=1,i=4,s=8,r=1){super(),this.type="CapsuleGeometry",this.parameters={radius:t,height:e,capSegments:i,radialSegments:s,heightSegments:r},e=Math.max(0,e),i=Math.max(1,Math.floor(i)),s=Math.max(3,Math.floor(s)),r=Math.max(1,Math.floor(r));let o=[],a=[],l=[],c=[],u=e/2,h=Math.PI/2*t,d=e,f=2*h+d,p=i*2+r,y=s+1,g=new V,m=new V;for(let x=0;x<=p;x++){let w=0,v=0,A=0,S=0;if(x<=i){let N=x/i,R=N*Math.PI/2;v=-u-t*Math.cos(R),A=t*Math.sin(R),S=-t*Math.cos(R),w=N*h}else if(x<=i+r){let N=(x-i)/r;v=-u+N*e,A=t,S=0,w=h+N*d}else{let N=(x-i-r)/i,R=N*Math.PI/2;v=u+t*Math.sin(R),A=t*Math.cos(R),S=t*Math.sin(R),w=h+d+N*h}let _=Math.max(0,Math.min(1,w/f)),M=0;x===0?M=.5/s:x===p&&(M=-.5/s);for(let N=0;N<=s;N++){let R=N/s,L=R*Math.PI*2,z=Math.sin(L),G=Math.cos(L);m.x=-A*G,m.y=v,m.z=A*z,a.push(m.x,m.y,m.z),g.set(-A*G,S,A*z),g.normalize(),l.push(g.x,g.y,g.z),c.push(R+M,_)}if(x>0){let N=(x-1)*y;for(let R=0;R<s;R++){let L=N+R,z=N+R+1,G=x*y+R,F=x*y+R+1;o.push(L,z,G),o.push(z,F,G)}}}this.setIndex(o),this.setAttribute("position",new be(a,3)),this.setAttribute("normal",new be(l,3)),this.setAttribute("uv",new be(c,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.height,t.capSegments,t.radialSegments,t.heightSegments)}},zc=class n extends we{constructor(t=1,e=32,i=0,s=Math.PI*2){super(),this.type="CircleGeometry",this.parameters={radius:t,segments:e,thetaStart:i,thetaLength:s},e=Math.max(3,e);let r=[],o=[],a=[],l=[],c=new V,u=new Qt;o.push(0,0,0),a.push(0,0,1),l.push(.5,.5);for(let h=0,d=3;h<=e;h++,d+=3){let f=i+h/e*s;c.x=t*Math.cos(f),c.y=t*Math.sin(f),o.push(c.x,c.y,c.z),a.push(0,0,1),u.x=(o[d]/t+1)/2,u.y=(o[d+1]/t+1)/2,l.push(u.x,u.y)}for(let h=1;h<=e;h++)r.push(h,h+1,0);this.setIndex(r),this.setAttribute("position",new be(o,3)),this.setAttribute("normal",new be(a,3)),this.setAttribute("uv",new be(l,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.segments,t.thetaStart,t.thetaLength)}},Ci=class n extends we{constructor(t=1,e=1,i=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let u=[],h=[],d=[],f=[],p=0,y=[],g=i/2,m=0;x(),o===!1&&(t>0&&w(!0),e>0&&w(!1)),this.setIndex(u),this.setAttribute("position",new be(h,3)),this.setAttribute("normal",new be(d,3)),this.setAttribute("uv",new be(f,2));function x(){let v=new V,A=new V,S=0,_=(e-t)/i;for(let M=0;M<=r;M++){let N=[],R=M/r,L=R*(e-t)+t;for(let z=0;z<=s;z++){let G=z/s,F=G*l+a,U=Math.sin(F),D=Math.cos(F);A.x=L*U,A.y=-R*i+g,A.z=L*D,h.push(A.x,A.y,A.z),v.set(U,_,D).normalize(),d.push(v.x,v.y,v.z),f.push(G,1-R),N.push(p++)}y.push(N)}for(let M=0;M<s;M++)for(let N=0;N<r;N++){let R=y[N][M],L=y[N+1][M],z=y[N+1][M+1],G=y[N][M+1];(t>0||N!==0)&&(u.push(R,L,G),S+=3),(e>0||N!==r-1)&&(u.push(L,z,G),S+=3)}c.addGroup(m,S,0),m+=S}function w(v){let A=p,S=new Qt,_=new V,M=0,N=v===!0?t:e,R=v===!0?1:-1;for(let z=1;z<=s;z++)h.push(0,g*R,0),d.push(0,R,0),f.push(.5,.5),p++;let L=p;for(let z=0;z<=s;z++){let F=z/s*l+a,U=Math.cos(F),D=Math.sin(F);_.x=N*D,_.y=g*R,_.z=N*U,h.push(_.x,_.y,_.z),d.push(0,R,0),S.x=U*.5+.5,S.y=D*.5*R+.5,f.push(S.x,S.y),p++}for(let z=0;z<s;z++){let G=A+z,F=L+z;v===!0?u.push(F,F+1,G):u.push(F+1,F,G),M+=3}c.addGroup(m,M,v===!0?1:2),m+=M}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},Yo=class n extends Ci{constructor(t=1,e=1,i=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,t,e,i,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:i,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(t){return new n(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},Qh=class n extends we{constructor(t=[],e=[],i=1,s=0){super(),this.type="PolyhedronGeometry",this.parameters={vertices:t,indices:e,radius:i,detail:s};let r=[],o=[];a(s),c(i),u(),this.setAttribute("position",new be(r,3)),this.setAttribute("normal",new be(r.slice(),3)),this.setAttribute("uv",new be(o,2)),s===0?this.computeVertexNormals():this.normalizeNormals();function a(x){let w=new V,v=new V,A=new V;for(let S=0;S<e.length;S+=3)f(e[S+0],w),f(e[S+1],v),f(e[S+2],A),l(w,v,A,x)}function l(x,w,v,A){let S=A+1,_=[];for(let M=0;M<=S;M++){_[M]=[];let N=x.clone().lerp(v,M/S),R=w.clone().lerp(v,M/S),L=S-M;for(let z=0;z<=L;z++)z===0&&M===S?_[M][z]=N:_[M][z]=N.clone().lerp(R,z/L)}for(let M=0;M<S;M++)for(let N=0;N<2*(S-M)-1;N++){let R=Math.floor(N/2);N%2===0?(d(_[M][R+1]),d(_[M+1][R]),d(_[M][R])):(d(_[M][R+1]),d(_[M+1][R+1]),d(_[M+1][R]))}}function c(x){let w=new V;for(let v=0;v<r.length;v+=3)w.x=r[v+0],w.y=r[v+1],w.z=r[v+2],w.normalize().multiplyScalar(x),r[v+0]=w.x,r[v+1]=w.y,r[v+2]=w.z}function u(){let x=new V;for(let w=0;w<r.length;w+=3){x.x=r[w+0],x.y=r[w+1],x.z=r[w+2];let v=g(x)/2/Math.PI+.5,A=m(x)/Math.PI+.5;o.push(v,1-A)}p(),h()}function h(){for(let x=0;x<o.length;x+=6){let w=o[x+0],v=o[x+2],A=o[x+4],S=Math.max(w,v,A),_=Math.min(w,v,A);S>.9&&_<.1&&(w<.2&&(o[x+0]+=1),v<.2&&(o[x+2]+=1),A<.2&&(o[x+4]+=1))}}function d(x){r.push(x.x,x.y,x.z)}function f(x,w){let v=x*3;w.x=t[v+0],w.y=t[v+1],w.z=t[v+2]}function p(){let x=new V,w=new V,v=new V,A=new V,S=new Qt,_=new Qt,M=new Qt;for(let N=0,R=0;N<r.length;N+=9,R+=6){x.set(r[N+0],r[N+1],r[N+2]),w.set(r[N+3],r[N+4],r[N+5]),v.set(r[N+6],r[N+7],r[N+8]),S.set(o[R+0],o[R+1]),_.set(o[R+2],o[R+3]),M.set(o[R+4],o[R+5]),A.copy(x).add(w).add(v).divideScalar(3);let L=g(A);y(S,R+0,x,L),y(_,R+2,w,L),y(M,R+4,v,L)}}function y(x,w,v,A){A<0&&x.x===1&&(o[w]=x.x-1),v.x===0&&v.z===0&&(o[w]=A/2/Math.PI+.5)}function g(x){return Math.atan2(x.z,-x.x)}function m(x){return Math.atan2(-x.y,Math.sqrt(x.x*x.x+x.z*x.z))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.vertices,t.indices,t.radius,t.detail)}};var Hc=class n extends we{constructor(t=[new Qt(0,-.5),new Qt(.5,0),new Qt(0,.5)],e=12,i=0,s=Math.PI*2){super(),this.type="LatheGeometry",this.parameters={points:t,segments:e,phiStart:i,phiLength:s},e=Math.floor(e),s=Ae(s,0,Math.PI*2);let r=[],o=[],a=[],l=[],c=[],u=1/e,h=new V,d=new Qt,f=new V,p=new V,y=new V,g=0,m=0;for(let x=0;x<=t.length-1;x++)switch(x){case 0:g=t[x+1].x-t[x].x,m=t[x+1].y-t[x].y,f.x=m*1,f.y=-g,f.z=m*0,y.copy(f),f.normalize(),l.push(f.x,f.y,f.z);break;case t.length-1:y.normalize(),l.push(y.x,y.y,y.z);break;default:g=t[x+1].x-t[x].x,m=t[x+1].y-t[x].y,f.x=m*1,f.y=-g,f.z=m*0,p.copy(f),f.x+=y.x,f.y+=y.y,f.z+=y.z,f.normalize(),l.push(f.x,f.y,f.z),y.copy(p)}for(let x=0;x<=e;x++){let w=i+x*u*s,v=Math.sin(w),A=Math.cos(w);for(let S=0;S<=t.length-1;S++){h.x=t[S].x*v,h.y=t[S].y,h.z=t[S].x*A,o.push(h.x,h.y,h.z),d.x=x/e,d.y=S/(t.length-1),a.push(d.x,d.y);let _=l[3*S+0]*v,M=l[3*S+1],N=l[3*S+0]*A;c.push(_,M,N)}}for(let x=0;x<e;x++)for(let w=0;w<t.length-1;w++){let v=w+x*t.length,A=v,S=v+t.length,_=v+t.length+1,M=v+1;r.push(A,S,M),r.push(_,M,S)}this.setIndex(r),this.setAttribute("position",new be(o,3)),this.setAttribute("uv",new be(a,2)),this.setAttribute("normal",new be(c,3))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.points,t.segments,t.phiStart,t.phiLength)}},Gc=class n extends Qh{constructor(t=1,e=0){let i=[1,0,0,-1,0,0,0,1,0,0,-1,0,0,0,1,0,0,-1],s=[0,2,4,0,4,3,0,3,5,0,5,2,1,2,5,1,5,3,1,3,4,1,4,2];super(i,s,t,e),this.type="OctahedronGeometry",this.parameters={radius:t,detail:e}}static fromJSON(t){return new n(t.radius,t.detail)}},Vc=class n extends we{constructor(t=1,e=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:i,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,h=t/a,d=e/l,f=[],p=[],y=[],g=[];for(let m=0;m<u;m++){let x=m*d-o;for(let w=0;w<c;w++){let v=w*h-r;p.push(v,-x,0),y.push(0,0,1),g.push(w/a),g.push(1-m/l)}}for(let m=0;m<l;m++)for(let x=0;x<a;x++){let w=x+c*m,v=x+c*(m+1),A=x+1+c*(m+1),S=x+1+c*m;f.push(w,v,S),f.push(v,A,S)}this.setIndex(f),this.setAttribute("position",new be(p,3)),this.setAttribute("normal",new be(y,3)),this.setAttribute("uv",new be(g,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.widthSegments,t.heightSegments)}};var Ns=class n extends we{constructor(t=1,e=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),c=0,u=[],h=new V,d=new V,f=[],p=[],y=[],g=[];for(let m=0;m<=i;m++){let x=[],w=m/i,v=o+w*a,A=t*Math.cos(v),S=Math.sqrt(t*t-A*A),_=0;m===0&&o===0?_=.5/e:m===i&&l===Math.PI&&(_=-.5/e);for(let M=0;M<=e;M++){let N=M/e,R=s+N*r;h.x=-S*Math.cos(R),h.y=A,h.z=S*Math.sin(R),p.push(h.x,h.y,h.z),d.copy(h).normalize(),y.push(d.x,d.y,d.z),g.push(N+_,1-w),x.push(c++)}u.push(x)}for(let m=0;m<i;m++)for(let x=0;x<e;x++){let w=u[m][x+1],v=u[m][x],A=u[m+1][x],S=u[m+1][x+1];(m!==0||o>0)&&f.push(w,v,S),(m!==i-1||l<Math.PI)&&f.push(v,A,S)}this.setIndex(f),this.setAttribute("position",new be(p,3)),this.setAttribute("normal",new be(y,3)),this.setAttribute("uv",new be(g,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};var ol=class n extends we{constructor(t=1,e=.4,i=12,s=48,r=Math.PI*2,o=0,a=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:t,tube:e,radialSegments:i,tubularSegments:s,arc:r,thetaStart:o,thetaLength:a},i=Math.floor(i),s=Math.floor(s);let l=[],c=[],u=[],h=[],d=new V,f=new V,p=new V;for(let y=0;y<=i;y++){let g=o+y/i*a;for(let m=0;m<=s;m++){let x=m/s*r;f.x=(t+e*Math.cos(g))*Math.cos(x),f.y=(t+e*Math.cos(g))*Math.sin(x),f.z=e*Math.sin(g),c.push(f.x,f.y,f.z),d.x=t*Math.cos(x),d.y=t*Math.sin(x),p.subVectors(f,d).normalize(),u.push(p.x,p.y,p.z),h.push(m/s),h.push(y/i)}}for(let y=1;y<=i;y++)for(let g=1;g<=s;g++){let m=(s+1)*y+g-1,x=(s+1)*(y-1)+g-1,w=(s+1)*(y-1)+g,v=(s+1)*y+g;l.push(m,x,v),l.push(x,w,v)}this.setIndex(l),this.setAttribute("position",new be(c,3)),this.setAttribute("normal",new be(u,3)),this.setAttribute("uv",new be(h,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.tube,t.radialSegments,t.tubularSegments,t.arc,t.thetaStart,t.thetaLength)}};function Qo(n){let t={};for(let e in n){t[e]={};for(let i in n[e]){let s=n[e][i];if(My(s))s.isRenderTargetTexture?(ie("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][i]=null):t[e][i]=s.clone();else if(Array.isArray(s))if(My(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][i]=r}else t[e][i]=s.slice();else t[e][i]=s}}return t}function gi(n){let t={};for(let e=0;e<n.length;e++){let i=Qo(n[e]);for(let s in i)t[s]=i[s]}return t}function My(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function UT(n){let t=[];for(let e=0;e<n.length;e++)t.push(n[e].clone());return t}function Tg(n){let t=n.getRenderTarget();return t===null?n.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:De.workingColorSpace}var fv={clone:Qo,merge:gi},OT=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,FT=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,pi=class extends Lr{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=OT,this.fragmentShader=FT,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=Qo(t.uniforms),this.uniformsGroups=UT(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(e.extensions=i),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let i in t.uniforms){let s=t.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=e[s.value]||null;break;case"c":this.uniforms[i].value=new ee().setHex(s.value);break;case"v2":this.uniforms[i].value=new Qt().fromArray(s.value);break;case"v3":this.uniforms[i].value=new V().fromArray(s.value);break;case"v4":this.uniforms[i].value=new bn().fromArray(s.value);break;case"m3":this.uniforms[i].value=new fe().fromArray(s.value);break;case"m4":this.uniforms[i].value=new ye().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let i in t.extensions)this.extensions[i]=t.extensions[i];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},td=class extends pi{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var ed=class extends Lr{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=tv,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},nd=class extends Lr{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function Xa(n,t){return!n||n.constructor===t?n:typeof t.BYTES_PER_ELEMENT=="number"?new t(n):Array.prototype.slice.call(n)}function Lh(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var ho=class{constructor(t,e,i,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(i),this.sampleValues=e,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,i=this._cachedIndex,s=e[i],r=e[i-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=i+2;;){if(s===void 0){if(t<r)break i;return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=e[++i],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=e[--i-1],t>=r)break t}o=i,i=0;break e}break n}for(;i<o;){let a=i+o>>>1;t<e[a]?o=a:i=a+1}if(s=e[i],r=e[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=i[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},id=class extends ho{constructor(t,e,i,s){super(t,e,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:zm,endingEnd:zm}}intervalChanged_(t,e,i){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Hm:r=t,a=2*e-i;break;case Gm:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case Hm:o=t,l=2*i-e;break;case Gm:o=1,l=i+s[1]-s[0];break;default:o=t-1,l=e}let c=(i-e)*.5,u=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=this._offsetPrev,h=this._offsetNext,d=this._weightPrev,f=this._weightNext,p=(i-e)/(s-e),y=p*p,g=y*p,m=-d*g+2*d*y-d*p,x=(1+d)*g+(-1.5-2*d)*y+(-.5+d)*p+1,w=(-1-f)*g+(1.5+f)*y+.5*p,v=f*g-f*y;for(let A=0;A!==a;++A)r[A]=m*o[u+A]+x*o[c+A]+w*o[l+A]+v*o[h+A];return r}},sd=class extends ho{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=(i-e)/(s-e),h=1-u;for(let d=0;d!==a;++d)r[d]=o[c+d]*h+o[l+d]*u;return r}},rd=class extends ho{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t){return this.copySampleValue_(t-1)}},od=class extends ho{interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=this.inTangents,h=this.outTangents;if(!u||!h){let p=(i-e)/(s-e),y=1-p;for(let g=0;g!==a;++g)r[g]=o[c+g]*y+o[l+g]*p;return r}let d=a*2,f=t-1;for(let p=0;p!==a;++p){let y=o[c+p],g=o[l+p],m=f*d+p*2,x=h[m],w=h[m+1],v=t*d+p*2,A=u[v],S=u[v+1],_=kT(i,e,x,A,s);r[p]=pv(_,y,w,S,g)}return r}};function pv(n,t,e,i,s){let r=1-n;return r*r*r*t+3*r*r*n*e+3*r*n*n*i+n*n*n*s}function BT(n,t,e,i,s){let r=1-n;return 3*r*r*(e-t)+6*r*n*(i-e)+3*n*n*(s-i)}function kT(n,t,e,i,s){let r=(n-t)/(s-t);for(let o=0;o<8;o++){let a=pv(r,t,e,i,s)-n;if(Math.abs(a)<1e-10)break;let l=BT(r,t,e,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var ns=class{constructor(t,e,i,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=Xa(e,this.TimeBufferType),this.values=Xa(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,i;if(e.toJSON!==this.toJSON)i=e.toJSON(t);else{i={name:t.name,times:Xa(t.times,Array),values:Xa(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(i.interpolation=s),Lh(t.settings)&&(i.settings={inTangents:Xa(t.settings.inTangents,Array),outTangents:Xa(t.settings.outTangents,Array)})}return i.type=t.ValueTypeName,i}InterpolantFactoryMethodDiscrete(t){return new rd(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new sd(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new id(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new od(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case Sc:e=this.InterpolantFactoryMethodDiscrete;break;case qh:e=this.InterpolantFactoryMethodLinear;break;case Uh:e=this.InterpolantFactoryMethodSmooth;break;case km:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return ie("KeyframeTrack:",i),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Sc;case this.InterpolantFactoryMethodLinear:return qh;case this.InterpolantFactoryMethodSmooth:return Uh;case this.InterpolantFactoryMethodBezier:return km}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]+=t;Lh(this.settings)&&(Sy(this.settings.inTangents,t),Sy(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]*=t;Lh(this.settings)&&(Ey(this.settings.inTangents,t),Ey(this.settings.outTangents,t))}return this}trim(t,e){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<t;)++r;for(;o!==-1&&i[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(ce("KeyframeTrack: Invalid value size in track.",this),t=!1);let i=this.times,s=this.values,r=i.length;r===0&&(ce("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){ce("KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){ce("KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&tT(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){ce("KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===Uh,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],u=t[a+1];if(c!==u&&(a!==1||c!==t[0]))if(s)l=!0;else{let h=a*i,d=h-i,f=h+i;for(let p=0;p!==i;++p){let y=e[h+p];if(y!==e[d+p]||y!==e[f+p]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let h=a*i,d=o*i;for(let f=0;f!==i;++f)e[d+f]=e[h+f]}++o}}if(r>0){t[o]=t[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*i)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),i=this.constructor,s=new i(this.name,t,e);return s.createInterpolant=this.createInterpolant,Lh(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function Sy(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]+=t}function Ey(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]*=t}ns.prototype.ValueTypeName="";ns.prototype.TimeBufferType=Float32Array;ns.prototype.ValueBufferType=Float32Array;ns.prototype.DefaultInterpolation=qh;var fo=class extends ns{constructor(t,e,i){super(t,e,i)}};fo.prototype.ValueTypeName="bool";fo.prototype.ValueBufferType=Array;fo.prototype.DefaultInterpolation=Sc;fo.prototype.InterpolantFactoryMethodLinear=void 0;fo.prototype.InterpolantFactoryMethodSmooth=void 0;var ad=class extends ns{constructor(t,e,i,s){super(t,e,i,s)}};ad.prototype.ValueTypeName="color";var ld=class extends ns{constructor(t,e,i,s){super(t,e,i,s)}};ld.prototype.ValueTypeName="number";var cd=class extends ho{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-e)/(s-e),c=t*a;for(let u=c+a;c!==u;c+=4)fn.slerpFlat(r,0,o,c-a,o,c,l);return r}},Wc=class extends ns{constructor(t,e,i,s){super(t,e,i,s)}InterpolantFactoryMethodLinear(t){return new cd(this.times,this.values,this.getValueSize(),t)}};Wc.prototype.ValueTypeName="quaternion";Wc.prototype.InterpolantFactoryMethodSmooth=void 0;var po=class extends ns{constructor(t,e,i){super(t,e,i)}};po.prototype.ValueTypeName="string";po.prototype.ValueBufferType=Array;po.prototype.DefaultInterpolation=Sc;po.prototype.InterpolantFactoryMethodLinear=void 0;po.prototype.InterpolantFactoryMethodSmooth=void 0;var ud=class extends ns{constructor(t,e,i,s){super(t,e,i,s)}};ud.prototype.ValueTypeName="vector";var hd=class{constructor(t,e,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,h){return c.push(u,h),this},this.removeHandler=function(u){let h=c.indexOf(u);return h!==-1&&c.splice(h,2),this},this.getHandler=function(u){for(let h=0,d=c.length;h<d;h+=2){let f=c[h],p=c[h+1];if(f.global&&(f.lastIndex=0),f.test(u))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},mv=new hd,dd=class{constructor(t){this.manager=t!==void 0?t:mv,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let i=this;return new Promise(function(s,r){i.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};dd.DEFAULT_MATERIAL_NAME="__DEFAULT";var Dh=new V,Nh=new fn,nr=new V,$c=class extends ki{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new ye,this.projectionMatrix=new ye,this.projectionMatrixInverse=new ye,this.coordinateSystem=fs,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(Dh,Nh,nr),nr.x===1&&nr.y===1&&nr.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Dh,Nh,nr.set(1,1,1)).invert()}updateWorldMatrix(t,e,i=!1){super.updateWorldMatrix(t,e,i),this.matrixWorld.decompose(Dh,Nh,nr),nr.x===1&&nr.y===1&&nr.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Dh,Nh,nr.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},lo=new V,Ty=new Qt,Ay=new Qt,Ai=class extends $c{constructor(t=50,e=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=Qa*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(wc*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return Qa*2*Math.atan(Math.tan(wc*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,i){lo.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(lo.x,lo.y).multiplyScalar(-t/lo.z),lo.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(lo.x,lo.y).multiplyScalar(-t/lo.z)}getViewSize(t,e){return this.getViewBounds(t,Ty,Ay),e.subVectors(Ay,Ty)}setViewOffset(t,e,i,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(wc*.5*this.fov)/this.zoom,i=2*e,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-i,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var fd=class extends $c{constructor(t=-1,e=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-t,o=i+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}};var Ya=-90,ja=1,al=class extends ki{constructor(t,e,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Ai(Ya,ja,t,e);s.layers=this.layers,this.add(s);let r=new Ai(Ya,ja,t,e);r.layers=this.layers,this.add(r);let o=new Ai(Ya,ja,t,e);o.layers=this.layers,this.add(o);let a=new Ai(Ya,ja,t,e);a.layers=this.layers,this.add(a);let l=new Ai(Ya,ja,t,e);l.layers=this.layers,this.add(l);let c=new Ai(Ya,ja,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[i,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===fs)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===Ac)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,h=t.getRenderTarget(),d=t.getActiveCubeFace(),f=t.getActiveMipmapLevel(),p=t.xr.enabled;t.xr.enabled=!1;let y=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let g=!1;t.isWebGLRenderer===!0?g=t.state.buffers.depth.getReversed():g=t.reversedDepthBuffer,t.setRenderTarget(i,0,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(i,1,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(i,2,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(i,3,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(i,4,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),i.texture.mipmapsAutoUpdate=y,t.setRenderTarget(i,5,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,u),t.setRenderTarget(h,d,f),t.xr.enabled=p,i.texture.needsPMREMUpdate=!0}},pd=class extends Ai{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var Ag="\\[\\]\\.:\\/",zT=new RegExp("["+Ag+"]","g"),Rg="[^"+Ag+"]",HT="[^"+Ag.replace("\\.","")+"]",GT=/((?:WC+[\/:])*)/.source.replace("WC",Rg),VT=/(WCOD+)?/.source.replace("WCOD",HT),WT=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Rg),$T=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Rg),qT=new RegExp("^"+GT+VT+WT+$T+"$"),XT=["material","materials","bones","map"],Wm=class{constructor(t,e,i){let s=i||dn.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(t,e)}setValue(t,e){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].unbind()}},dn=class n{constructor(t,e,i){this.path=e,this.parsedPath=i||n.parseTrackName(e),this.node=n.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,i){return t&&t.isAnimationObjectGroup?new n.Composite(t,e,i):new n(t,e,i)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(zT,"")}static parseTrackName(t){let e=qT.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let i={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);XT.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return i}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let i=t.skeleton.getBoneByName(e);if(i!==void 0)return i}if(t.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=i(a.children);if(l)return l}return null},s=i(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)t[e++]=i[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,i=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=n.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){ie("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=e.objectIndex;switch(i){case"materials":if(!t.material){ce("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){ce("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){ce("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let u=0;u<t.length;u++)if(t[u].name===c){c=u;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){ce("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){ce("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[i]===void 0){ce("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[i]}if(c!==void 0){if(t[c]===void 0){ce("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;ce("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){ce("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){ce("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};dn.Composite=Wm;dn.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};dn.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};dn.prototype.GetterByBindingType=[dn.prototype._getValue_direct,dn.prototype._getValue_array,dn.prototype._getValue_arrayElement,dn.prototype._getValue_toArray];dn.prototype.SetterByBindingTypeAndVersioning=[[dn.prototype._setValue_direct,dn.prototype._setValue_direct_setNeedsUpdate,dn.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[dn.prototype._setValue_array,dn.prototype._setValue_array_setNeedsUpdate,dn.prototype._setValue_array_setMatrixWorldNeedsUpdate],[dn.prototype._setValue_arrayElement,dn.prototype._setValue_arrayElement_setNeedsUpdate,dn.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[dn.prototype._setValue_fromArray,dn.prototype._setValue_fromArray_setNeedsUpdate,dn.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var HU=new Float32Array(1);var Ry=new ye,qc=class{constructor(t,e,i=0,s=1/0){this.ray=new Dr(t,e),this.near=i,this.far=s,this.camera=null,this.layers=new el,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(t,e){this.ray.set(t,e)}setFromCamera(t,e){e.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(t.x,t.y,.5).unproject(e).sub(this.ray.origin).normalize(),this.camera=e):e.isOrthographicCamera?(this.ray.origin.set(t.x,t.y,e.projectionMatrix.elements[14]).unproject(e),this.ray.direction.set(0,0,-1).transformDirection(e.matrixWorld),this.camera=e):ce("Raycaster: Unsupported camera type: "+e.type)}setFromXRController(t){return Ry.identity().extractRotation(t.matrixWorld),this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(Ry),this}intersectObject(t,e=!0,i=[]){return $m(t,this,i,e),i.sort(Cy),i}intersectObjects(t,e=!0,i=[]){for(let s=0,r=t.length;s<r;s++)$m(t[s],this,i,e);return i.sort(Cy),i}};function Cy(n,t){return n.distance-t.distance}function $m(n,t,e,i){let s=!0;if(n.layers.test(t.layers)&&n.raycast(t,e)===!1&&(s=!1),s===!0&&i===!0){let r=n.children;for(let o=0,a=r.length;o<a;o++)$m(r[o],t,e,!0)}}var ll=class{constructor(t=1,e=0,i=0){this.radius=t,this.phi=e,this.theta=i}set(t,e,i){return this.radius=t,this.phi=e,this.theta=i,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=Ae(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,i){return this.radius=Math.sqrt(t*t+e*e+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,i),this.phi=Math.acos(Ae(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var qm=class{static{this.prototype.isMatrix2=!0}constructor(t,e,i,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let i=0;i<4;i++)this.elements[i]=t[i+e];return this}set(t,e,i,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=i,r[3]=s,this}};var Xc=class extends Ds{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function Cg(n,t,e,i){let s=YT(i);switch(e){case dg:return n*t;case bd:return n*t/s.components*s.byteLength;case wd:return n*t/s.components*s.byteLength;case xo:return n*t*2/s.components*s.byteLength;case Md:return n*t*2/s.components*s.byteLength;case fg:return n*t*3/s.components*s.byteLength;case Fs:return n*t*4/s.components*s.byteLength;case Sd:return n*t*4/s.components*s.byteLength;case Zc:case Jc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case Kc:case Qc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Td:case Rd:return Math.max(n,16)*Math.max(t,8)/4;case Ed:case Ad:return Math.max(n,8)*Math.max(t,8)/2;case Cd:case Pd:case Ld:case Dd:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case Id:case tu:case Nd:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Ud:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Od:return Math.floor((n+4)/5)*Math.floor((t+3)/4)*16;case Fd:return Math.floor((n+4)/5)*Math.floor((t+4)/5)*16;case Bd:return Math.floor((n+5)/6)*Math.floor((t+4)/5)*16;case kd:return Math.floor((n+5)/6)*Math.floor((t+5)/6)*16;case zd:return Math.floor((n+7)/8)*Math.floor((t+4)/5)*16;case Hd:return Math.floor((n+7)/8)*Math.floor((t+5)/6)*16;case Gd:return Math.floor((n+7)/8)*Math.floor((t+7)/8)*16;case Vd:return Math.floor((n+9)/10)*Math.floor((t+4)/5)*16;case Wd:return Math.floor((n+9)/10)*Math.floor((t+5)/6)*16;case $d:return Math.floor((n+9)/10)*Math.floor((t+7)/8)*16;case qd:return Math.floor((n+9)/10)*Math.floor((t+9)/10)*16;case Xd:return Math.floor((n+11)/12)*Math.floor((t+9)/10)*16;case Yd:return Math.floor((n+11)/12)*Math.floor((t+11)/12)*16;case jd:case Zd:case Jd:return Math.ceil(n/4)*Math.ceil(t/4)*16;case Kd:case Qd:return Math.ceil(n/4)*Math.ceil(t/4)*8;case eu:case tf:return Math.ceil(n/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function YT(n){switch(n){case is:case lg:return{byteLength:1,components:1};case dl:case cg:case Os:return{byteLength:2,components:1};case yd:case vd:return{byteLength:2,components:4};case Us:case _d:case ps:return{byteLength:4,components:1};case ug:case hg:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?ie("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Fv(){let n=null,t=!1,e=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&n!==null&&(i=n.requestAnimationFrame(s),t=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){n=r}}}function QT(n){let t=new WeakMap;function e(a,l){let c=a.array,u=a.usage,h=c.byteLength,d=n.createBuffer();n.bindBuffer(l,d),n.bufferData(l,c,u),a.onUploadCallback();let f;if(c instanceof Float32Array)f=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=n.HALF_FLOAT:f=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=n.SHORT;else if(c instanceof Uint32Array)f=n.UNSIGNED_INT;else if(c instanceof Int32Array)f=n.INT;else if(c instanceof Int8Array)f=n.BYTE;else if(c instanceof Uint8Array)f=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function i(a,l,c){let u=l.array,h=l.updateRanges;if(n.bindBuffer(c,a),h.length===0)n.bufferSubData(c,0,u);else{h.sort((f,p)=>f.start-p.start);let d=0;for(let f=1;f<h.length;f++){let p=h[d],y=h[f];y.start<=p.start+p.count+1?p.count=Math.max(p.count,y.start+y.count-p.start):(++d,h[d]=y)}h.length=d+1;for(let f=0,p=h.length;f<p;f++){let y=h[f];n.bufferSubData(c,y.start*u.BYTES_PER_ELEMENT,u,y.start,y.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(n.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=t.get(a);(!u||u.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var tA=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,eA=`#ifdef USE_ALPHAHASH
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
#endif`,nA=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,iA=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,sA=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,rA=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,oA=`#ifdef USE_AOMAP
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
#endif`,aA=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,lA=`#ifdef USE_BATCHING
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
#endif`,cA=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,uA=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,hA=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,dA=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,fA=`#ifdef USE_IRIDESCENCE
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
#endif`,pA=`#ifdef USE_BUMPMAP
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
#endif`,mA=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,gA=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,xA=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,_A=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,yA=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,vA=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,bA=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,wA=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,MA=`#define PI 3.141592653589793
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
} // validated`,SA=`vec3 transformedNormal = objectNormal;
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
#endif`,EA=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,TA=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,AA=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,RA=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,CA="gl_FragColor = linearToOutputTexel( gl_FragColor );",PA=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,IA=`#ifdef USE_ENVMAP
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
#endif`,LA=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,DA=`#ifdef USE_ENVMAP
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
#endif`,NA=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,UA=`#ifdef USE_ENVMAP
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
#endif`,OA=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,FA=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,BA=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,kA=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,zA=`#ifdef USE_GRADIENTMAP
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
}`,HA=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,GA=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,VA=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,WA=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,$A=`#ifdef USE_ENVMAP
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
#endif`,qA=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,XA=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,YA=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,jA=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,ZA=`PhysicalMaterial material;
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
#endif`,JA=`uniform sampler2D dfgLUT;
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
}`,KA=`
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
#endif`,QA=`#if defined( RE_IndirectDiffuse )
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
#endif`,tR=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,eR=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,nR=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,iR=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,sR=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,rR=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,oR=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,aR=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,lR=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,cR=`#if defined( USE_POINTS_UV )
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
#endif`,uR=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,hR=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,dR=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,fR=`#if defined( USE_MORPHCOLORS )
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
#endif`,pR=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,mR=`#ifdef USE_MORPHTARGETS
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
#endif`,gR=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,xR=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,_R=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,yR=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,vR=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,bR=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,wR=`#ifdef USE_NORMALMAP
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
#endif`,MR=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,SR=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,ER=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,TR=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,AR=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,RR=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,CR=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,PR=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,IR=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,LR=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,DR=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,NR=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,UR=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,OR=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,FR=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,BR=`float getShadowMask() {
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
}`,kR=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,zR=`#ifdef USE_SKINNING
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
#endif`,HR=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,GR=`#ifdef USE_SKINNING
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
#endif`,VR=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,WR=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,$R=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,qR=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,XR=`#ifdef USE_TRANSMISSION
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
#endif`,YR=`#ifdef USE_TRANSMISSION
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
#endif`,jR=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,ZR=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,JR=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,KR=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,QR=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,tC=`uniform sampler2D t2D;
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
}`,eC=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,nC=`uniform float backgroundBlurriness;
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
}`,iC=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,sC=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,rC=`#include <common>
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
}`,oC=`#if DEPTH_PACKING == 3200
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
}`,aC=`#define DISTANCE
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
}`,lC=`#define DISTANCE
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
}`,cC=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,uC=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,hC=`uniform float scale;
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
}`,dC=`uniform vec3 diffuse;
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
}`,fC=`#include <common>
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
}`,pC=`uniform vec3 diffuse;
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
}`,mC=`#define LAMBERT
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
}`,gC=`#define LAMBERT
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
}`,xC=`#define MATCAP
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
}`,_C=`#define MATCAP
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
}`,yC=`#define NORMAL
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
}`,vC=`#define NORMAL
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
}`,bC=`#define PHONG
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
}`,wC=`#define PHONG
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
}`,MC=`#define STANDARD
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
}`,SC=`#define STANDARD
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
}`,EC=`#define TOON
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
}`,TC=`#define TOON
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
}`,AC=`uniform float size;
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
}`,RC=`uniform vec3 diffuse;
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
}`,CC=`#include <common>
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
}`,PC=`uniform vec3 color;
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
}`,IC=`uniform float rotation;
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
}`,LC=`uniform vec3 diffuse;
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
}`,Ee={alphahash_fragment:tA,alphahash_pars_fragment:eA,alphamap_fragment:nA,alphamap_pars_fragment:iA,alphatest_fragment:sA,alphatest_pars_fragment:rA,aomap_fragment:oA,aomap_pars_fragment:aA,batching_pars_vertex:lA,batching_vertex:cA,begin_vertex:uA,beginnormal_vertex:hA,bsdfs:dA,iridescence_fragment:fA,bumpmap_pars_fragment:pA,clipping_planes_fragment:mA,clipping_planes_pars_fragment:gA,clipping_planes_pars_vertex:xA,clipping_planes_vertex:_A,color_fragment:yA,color_pars_fragment:vA,color_pars_vertex:bA,color_vertex:wA,common:MA,defaultnormal_vertex:SA,displacementmap_pars_vertex:EA,displacementmap_vertex:TA,emissivemap_fragment:AA,emissivemap_pars_fragment:RA,colorspace_fragment:CA,colorspace_pars_fragment:PA,envmap_fragment:IA,envmap_common_pars_fragment:LA,envmap_pars_fragment:DA,envmap_pars_vertex:NA,envmap_physical_pars_fragment:$A,envmap_vertex:UA,fog_vertex:OA,fog_pars_vertex:FA,fog_fragment:BA,fog_pars_fragment:kA,gradientmap_pars_fragment:zA,lightmap_pars_fragment:HA,lights_lambert_fragment:GA,lights_lambert_pars_fragment:VA,lights_pars_begin:WA,lights_toon_fragment:qA,lights_toon_pars_fragment:XA,lights_phong_fragment:YA,lights_phong_pars_fragment:jA,lights_physical_fragment:ZA,lights_physical_pars_fragment:JA,lights_fragment_begin:KA,lights_fragment_maps:QA,lights_fragment_end:tR,lightprobes_pars_fragment:eR,logdepthbuf_fragment:nR,logdepthbuf_pars_fragment:iR,logdepthbuf_pars_vertex:sR,logdepthbuf_vertex:rR,map_fragment:oR,map_pars_fragment:aR,map_particle_fragment:lR,map_particle_pars_fragment:cR,metalnessmap_fragment:uR,metalnessmap_pars_fragment:hR,morphinstance_vertex:dR,morphcolor_vertex:fR,morphnormal_vertex:pR,morphtarget_pars_vertex:mR,morphtarget_vertex:gR,normal_fragment_begin:xR,normal_fragment_maps:_R,normal_pars_fragment:yR,normal_pars_vertex:vR,normal_vertex:bR,normalmap_pars_fragment:wR,clearcoat_normal_fragment_begin:MR,clearcoat_normal_fragment_maps:SR,clearcoat_pars_fragment:ER,iridescence_pars_fragment:TR,opaque_fragment:AR,packing:RR,premultiplied_alpha_fragment:CR,project_vertex:PR,dithering_fragment:IR,dithering_pars_fragment:LR,roughnessmap_fragment:DR,roughnessmap_pars_fragment:NR,shadowmap_pars_fragment:UR,shadowmap_pars_vertex:OR,shadowmap_vertex:FR,shadowmask_pars_fragment:BR,skinbase_vertex:kR,skinning_pars_vertex:zR,skinning_vertex:HR,skinnormal_vertex:GR,specularmap_fragment:VR,specularmap_pars_fragment:WR,tonemapping_fragment:$R,tonemapping_pars_fragment:qR,transmission_fragment:XR,transmission_pars_fragment:YR,uv_pars_fragment:jR,uv_pars_vertex:ZR,uv_vertex:JR,worldpos_vertex:KR,background_vert:QR,background_frag:tC,backgroundCube_vert:eC,backgroundCube_frag:nC,cube_vert:iC,cube_frag:sC,depth_vert:rC,depth_frag:oC,distance_vert:aC,distance_frag:lC,equirect_vert:cC,equirect_frag:uC,linedashed_vert:hC,linedashed_frag:dC,meshbasic_vert:fC,meshbasic_frag:pC,meshlambert_vert:mC,meshlambert_frag:gC,meshmatcap_vert:xC,meshmatcap_frag:_C,meshnormal_vert:yC,meshnormal_frag:vC,meshphong_vert:bC,meshphong_frag:wC,meshphysical_vert:MC,meshphysical_frag:SC,meshtoon_vert:EC,meshtoon_frag:TC,points_vert:AC,points_frag:RC,shadow_vert:CC,shadow_frag:PC,sprite_vert:IC,sprite_frag:LC},kt={common:{diffuse:{value:new ee(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new fe},alphaMap:{value:null},alphaMapTransform:{value:new fe},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new fe}},envmap:{envMap:{value:null},envMapRotation:{value:new fe},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new fe}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new fe}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new fe},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new fe},normalScale:{value:new Qt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new fe},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new fe}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new fe}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new fe}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new ee(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new ee(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new fe},alphaTest:{value:0},uvTransform:{value:new fe}},sprite:{diffuse:{value:new ee(16777215)},opacity:{value:1},center:{value:new Qt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new fe},alphaMap:{value:null},alphaMapTransform:{value:new fe},alphaTest:{value:0}}},ur={basic:{uniforms:gi([kt.common,kt.specularmap,kt.envmap,kt.aomap,kt.lightmap,kt.fog]),vertexShader:Ee.meshbasic_vert,fragmentShader:Ee.meshbasic_frag},lambert:{uniforms:gi([kt.common,kt.specularmap,kt.envmap,kt.aomap,kt.lightmap,kt.emissivemap,kt.bumpmap,kt.normalmap,kt.displacementmap,kt.fog,kt.lights,{emissive:{value:new ee(0)},envMapIntensity:{value:1}}]),vertexShader:Ee.meshlambert_vert,fragmentShader:Ee.meshlambert_frag},phong:{uniforms:gi([kt.common,kt.specularmap,kt.envmap,kt.aomap,kt.lightmap,kt.emissivemap,kt.bumpmap,kt.normalmap,kt.displacementmap,kt.fog,kt.lights,{emissive:{value:new ee(0)},specular:{value:new ee(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:Ee.meshphong_vert,fragmentShader:Ee.meshphong_frag},standard:{uniforms:gi([kt.common,kt.envmap,kt.aomap,kt.lightmap,kt.emissivemap,kt.bumpmap,kt.normalmap,kt.displacementmap,kt.roughnessmap,kt.metalnessmap,kt.fog,kt.lights,{emissive:{value:new ee(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:Ee.meshphysical_vert,fragmentShader:Ee.meshphysical_frag},toon:{uniforms:gi([kt.common,kt.aomap,kt.lightmap,kt.emissivemap,kt.bumpmap,kt.normalmap,kt.displacementmap,kt.gradientmap,kt.fog,kt.lights,{emissive:{value:new ee(0)}}]),vertexShader:Ee.meshtoon_vert,fragmentShader:Ee.meshtoon_frag},matcap:{uniforms:gi([kt.common,kt.bumpmap,kt.normalmap,kt.displacementmap,kt.fog,{matcap:{value:null}}]),vertexShader:Ee.meshmatcap_vert,fragmentShader:Ee.meshmatcap_frag},points:{uniforms:gi([kt.points,kt.fog]),vertexShader:Ee.points_vert,fragmentShader:Ee.points_frag},dashed:{uniforms:gi([kt.common,kt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:Ee.linedashed_vert,fragmentShader:Ee.linedashed_frag},depth:{uniforms:gi([kt.common,kt.displacementmap]),vertexShader:Ee.depth_vert,fragmentShader:Ee.depth_frag},normal:{uniforms:gi([kt.common,kt.bumpmap,kt.normalmap,kt.displacementmap,{opacity:{value:1}}]),vertexShader:Ee.meshnormal_vert,fragmentShader:Ee.meshnormal_frag},sprite:{uniforms:gi([kt.sprite,kt.fog]),vertexShader:Ee.sprite_vert,fragmentShader:Ee.sprite_frag},background:{uniforms:{uvTransform:{value:new fe},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:Ee.background_vert,fragmentShader:Ee.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new fe}},vertexShader:Ee.backgroundCube_vert,fragmentShader:Ee.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:Ee.cube_vert,fragmentShader:Ee.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:Ee.equirect_vert,fragmentShader:Ee.equirect_frag},distance:{uniforms:gi([kt.common,kt.displacementmap,{referencePosition:{value:new V},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:Ee.distance_vert,fragmentShader:Ee.distance_frag},shadow:{uniforms:gi([kt.lights,kt.fog,{color:{value:new ee(0)},opacity:{value:1}}]),vertexShader:Ee.shadow_vert,fragmentShader:Ee.shadow_frag}};ur.physical={uniforms:gi([ur.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new fe},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new fe},clearcoatNormalScale:{value:new Qt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new fe},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new fe},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new fe},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new fe},sheen:{value:0},sheenColor:{value:new ee(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new fe},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new fe},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new fe},transmissionSamplerSize:{value:new Qt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new fe},attenuationDistance:{value:0},attenuationColor:{value:new ee(0)},specularColor:{value:new ee(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new fe},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new fe},anisotropyVector:{value:new Qt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new fe}}]),vertexShader:Ee.meshphysical_vert,fragmentShader:Ee.meshphysical_frag};var sf={r:0,b:0,g:0},DC=new ye,Bv=new fe;Bv.set(-1,0,0,0,1,0,0,0,1);function NC(n,t,e,i,s,r){let o=new ee(0),a=s===!0?0:1,l,c,u=null,h=0,d=null;function f(x){let w=x.isScene===!0?x.background:null;if(w&&w.isTexture){let v=x.backgroundBlurriness>0;w=t.get(w,v)}return w}function p(x){let w=!1,v=f(x);v===null?g(o,a):v&&v.isColor&&(g(v,1),w=!0);let A=n.xr.getEnvironmentBlendMode();A==="additive"?e.buffers.color.setClear(0,0,0,1,r):A==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(n.autoClear||w)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function y(x,w){let v=f(w);v&&v.isCubeTexture?(c===void 0&&(c=new Ge(new Hi(1,1,1),new pi({name:"BackgroundCubeMaterial",uniforms:Qo(ur.backgroundCube.uniforms),vertexShader:ur.backgroundCube.vertexShader,fragmentShader:ur.backgroundCube.fragmentShader,side:oi,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(A,S,_){this.matrixWorld.copyPosition(_.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=v,c.material.uniforms.backgroundBlurriness.value=w.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=w.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(DC.makeRotationFromEuler(w.backgroundRotation)).transpose(),v.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Bv),c.material.toneMapped=De.getTransfer(v.colorSpace)!==$e,(u!==v||h!==v.version||d!==n.toneMapping)&&(c.material.needsUpdate=!0,u=v,h=v.version,d=n.toneMapping),c.layers.enableAll(),x.unshift(c,c.geometry,c.material,0,0,null)):v&&v.isTexture&&(l===void 0&&(l=new Ge(new Vc(2,2),new pi({name:"BackgroundMaterial",uniforms:Qo(ur.background.uniforms),vertexShader:ur.background.vertexShader,fragmentShader:ur.background.fragmentShader,side:ar,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=v,l.material.uniforms.backgroundIntensity.value=w.backgroundIntensity,l.material.toneMapped=De.getTransfer(v.colorSpace)!==$e,v.matrixAutoUpdate===!0&&v.updateMatrix(),l.material.uniforms.uvTransform.value.copy(v.matrix),(u!==v||h!==v.version||d!==n.toneMapping)&&(l.material.needsUpdate=!0,u=v,h=v.version,d=n.toneMapping),l.layers.enableAll(),x.unshift(l,l.geometry,l.material,0,0,null))}function g(x,w){x.getRGB(sf,Tg(n)),e.buffers.color.setClear(sf.r,sf.g,sf.b,w,r)}function m(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(x,w=1){o.set(x),a=w,g(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(x){a=x,g(o,a)},render:p,addToRenderList:y,dispose:m}}function UC(n,t){let e=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=d(null),r=s,o=!1;function a(L,z,G,F,U){let D=!1,O=h(L,F,G,z);r!==O&&(r=O,c(r.object)),D=f(L,F,G,U),D&&p(L,F,G,U),U!==null&&t.update(U,n.ELEMENT_ARRAY_BUFFER),(D||o)&&(o=!1,v(L,z,G,F),U!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,t.get(U).buffer))}function l(){return n.createVertexArray()}function c(L){return n.bindVertexArray(L)}function u(L){return n.deleteVertexArray(L)}function h(L,z,G,F){let U=F.wireframe===!0,D=i[z.id];D===void 0&&(D={},i[z.id]=D);let O=L.isInstancedMesh===!0?L.id:0,Z=D[O];Z===void 0&&(Z={},D[O]=Z);let X=Z[G.id];X===void 0&&(X={},Z[G.id]=X);let J=X[U];return J===void 0&&(J=d(l()),X[U]=J),J}function d(L){let z=[],G=[],F=[];for(let U=0;U<e;U++)z[U]=0,G[U]=0,F[U]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:z,enabledAttributes:G,attributeDivisors:F,object:L,attributes:{},index:null}}function f(L,z,G,F){let U=r.attributes,D=z.attributes,O=0,Z=G.getAttributes();for(let X in Z)if(Z[X].location>=0){let nt=U[X],dt=D[X];if(dt===void 0&&(X==="instanceMatrix"&&L.instanceMatrix&&(dt=L.instanceMatrix),X==="instanceColor"&&L.instanceColor&&(dt=L.instanceColor)),nt===void 0||nt.attribute!==dt||dt&&nt.data!==dt.data)return!0;O++}return r.attributesNum!==O||r.index!==F}function p(L,z,G,F){let U={},D=z.attributes,O=0,Z=G.getAttributes();for(let X in Z)if(Z[X].location>=0){let nt=D[X];nt===void 0&&(X==="instanceMatrix"&&L.instanceMatrix&&(nt=L.instanceMatrix),X==="instanceColor"&&L.instanceColor&&(nt=L.instanceColor));let dt={};dt.attribute=nt,nt&&nt.data&&(dt.data=nt.data),U[X]=dt,O++}r.attributes=U,r.attributesNum=O,r.index=F}function y(){let L=r.newAttributes;for(let z=0,G=L.length;z<G;z++)L[z]=0}function g(L){m(L,0)}function m(L,z){let G=r.newAttributes,F=r.enabledAttributes,U=r.attributeDivisors;G[L]=1,F[L]===0&&(n.enableVertexAttribArray(L),F[L]=1),U[L]!==z&&(n.vertexAttribDivisor(L,z),U[L]=z)}function x(){let L=r.newAttributes,z=r.enabledAttributes;for(let G=0,F=z.length;G<F;G++)z[G]!==L[G]&&(n.disableVertexAttribArray(G),z[G]=0)}function w(L,z,G,F,U,D,O){O===!0?n.vertexAttribIPointer(L,z,G,U,D):n.vertexAttribPointer(L,z,G,F,U,D)}function v(L,z,G,F){y();let U=F.attributes,D=G.getAttributes(),O=z.defaultAttributeValues;for(let Z in D){let X=D[Z];if(X.location>=0){let J=U[Z];if(J===void 0&&(Z==="instanceMatrix"&&L.instanceMatrix&&(J=L.instanceMatrix),Z==="instanceColor"&&L.instanceColor&&(J=L.instanceColor)),J!==void 0){let nt=J.normalized,dt=J.itemSize,ft=t.get(J);if(ft===void 0)continue;let st=ft.buffer,yt=ft.type,xt=ft.bytesPerElement,Tt=yt===n.INT||yt===n.UNSIGNED_INT||J.gpuType===_d;if(J.isInterleavedBufferAttribute){let At=J.data,Jt=At.isInterleavedBuffer===!0?At.stride:At.itemSize,xe=J.offset;if(At.isInstancedInterleavedBuffer||At.isInstancedBufferAttribute){for(let jt=0;jt<X.locationSize;jt++)m(X.location+jt,At.meshPerAttribute);L.isInstancedMesh!==!0&&F._maxInstanceCount===void 0&&(F._maxInstanceCount=At.meshPerAttribute*At.count)}else for(let jt=0;jt<X.locationSize;jt++)g(X.location+jt);n.bindBuffer(n.ARRAY_BUFFER,st);for(let jt=0;jt<X.locationSize;jt++)w(X.location+jt,dt/X.locationSize,yt,nt,Jt*xt,(xe+dt/X.locationSize*jt)*xt,Tt)}else{if(J.isInstancedBufferAttribute){for(let At=0;At<X.locationSize;At++)m(X.location+At,J.meshPerAttribute);L.isInstancedMesh!==!0&&F._maxInstanceCount===void 0&&(F._maxInstanceCount=J.meshPerAttribute*J.count)}else for(let At=0;At<X.locationSize;At++)g(X.location+At);n.bindBuffer(n.ARRAY_BUFFER,st);for(let At=0;At<X.locationSize;At++)w(X.location+At,dt/X.locationSize,yt,nt,dt*xt,dt/X.locationSize*At*xt,Tt)}}else if(O!==void 0){let nt=O[Z];if(nt!==void 0)switch(nt.length){case 2:n.vertexAttrib2fv(X.location,nt);break;case 3:n.vertexAttrib3fv(X.location,nt);break;case 4:n.vertexAttrib4fv(X.location,nt);break;default:n.vertexAttrib1fv(X.location,nt)}}}}x()}function A(){N();for(let L in i){let z=i[L];for(let G in z){let F=z[G];for(let U in F){let D=F[U];for(let O in D)u(D[O].object),delete D[O];delete F[U]}}delete i[L]}}function S(L){if(i[L.id]===void 0)return;let z=i[L.id];for(let G in z){let F=z[G];for(let U in F){let D=F[U];for(let O in D)u(D[O].object),delete D[O];delete F[U]}}delete i[L.id]}function _(L){for(let z in i){let G=i[z];for(let F in G){let U=G[F];if(U[L.id]===void 0)continue;let D=U[L.id];for(let O in D)u(D[O].object),delete D[O];delete U[L.id]}}}function M(L){for(let z in i){let G=i[z],F=L.isInstancedMesh===!0?L.id:0,U=G[F];if(U!==void 0){for(let D in U){let O=U[D];for(let Z in O)u(O[Z].object),delete O[Z];delete U[D]}delete G[F],Object.keys(G).length===0&&delete i[z]}}}function N(){R(),o=!0,r!==s&&(r=s,c(r.object))}function R(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:N,resetDefaultState:R,dispose:A,releaseStatesOfGeometry:S,releaseStatesOfObject:M,releaseStatesOfProgram:_,initAttributes:y,enableAttribute:g,disableUnusedAttributes:x}}function OC(n,t,e){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),e.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),e.update(c,i,u))}function a(l,c,u){if(u===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let d=0;for(let f=0;f<u;f++)d+=c[f];e.update(d,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function FC(n,t,e,i){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let _=t.get("EXT_texture_filter_anisotropic");s=n.getParameter(_.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(_){return!(_!==Fs&&i.convert(_)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(_){let M=_===Os&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(_!==is&&_!==ps&&!M&&i.convert(_)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(_){if(_==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";_="mediump"}return _==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",u=l(c);u!==c&&(ie("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let h=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),d=e.logarithmicDepthBuffer===!0&&h===!1;e.reversedDepthBuffer===!0&&h===!1&&ie("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&h===!0&&ie("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),p=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),y=n.getParameter(n.MAX_TEXTURE_SIZE),g=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),m=n.getParameter(n.MAX_VERTEX_ATTRIBS),x=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),w=n.getParameter(n.MAX_VARYING_VECTORS),v=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),A=n.getParameter(n.MAX_SAMPLES),S=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:h,maxTextures:f,maxVertexTextures:p,maxTextureSize:y,maxCubemapSize:g,maxAttributes:m,maxVertexUniforms:x,maxVaryings:w,maxFragmentUniforms:v,maxSamples:A,samples:S}}function BC(n){let t=this,e=null,i=0,s=!1,r=!1,o=new ri,a=new fe,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,d){let f=h.length!==0||d||i!==0||s;return s=d,i=h.length,f},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,d){e=u(h,d,0)},this.setState=function(h,d,f){let p=h.clippingPlanes,y=h.clipIntersection,g=h.clipShadows,m=n.get(h);if(!s||p===null||p.length===0||r&&!g)r?u(null):c();else{let x=r?0:i,w=x*4,v=m.clippingState||null;l.value=v,v=u(p,d,w,f);for(let A=0;A!==w;++A)v[A]=e[A];m.clippingState=v,this.numIntersection=y?this.numPlanes:0,this.numPlanes+=x}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=i>0),t.numPlanes=i,t.numIntersection=0}function u(h,d,f,p){let y=h!==null?h.length:0,g=null;if(y!==0){if(g=l.value,p!==!0||g===null){let m=f+y*4,x=d.matrixWorldInverse;a.getNormalMatrix(x),(g===null||g.length<m)&&(g=new Float32Array(m));for(let w=0,v=f;w!==y;++w,v+=4)o.copy(h[w]).applyMatrix4(x,a),o.normal.toArray(g,v),g[v+3]=o.constant}l.value=g,l.needsUpdate=!0}return t.numPlanes=y,t.numIntersection=0,g}}var su=class extends ts{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let i={width:t,height:t,depth:1},s=[i,i,i,i,i,i];this.texture=new Fc(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new Hi(5,5,5),r=new pi({name:"CubemapFromEquirect",uniforms:Qo(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:oi,blending:jo});r.uniforms.tEquirect.value=e;let o=new Ge(s,r),a=e.minFilter;return e.minFilter===Or&&(e.minFilter=Ri),new al(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,i=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,i,s);t.setRenderTarget(r)}},gv=256,kC=3,zC=20,kv=256,zv=16,HC=3,GC=new V,VC=new ee,of=class n{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new al(1,10,null),this._boxMesh=new Ge(new Hi(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,i=.1,s=100,r={}){let{size:o=256,position:a=GC}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);e>0&&(u.texture.mipmapsAutoUpdate=!1);let h=l.autoClear,d=l.autoClearColor,f=l.autoClearDepth,p=l.autoClearStencil,y=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,y===null&&(t.background=l.getClearColor(VC));let g=new al(i,s,u);return g.position.copy(a),g.update(l,t),l.autoClear=h,l.autoClearColor=d,l.autoClearDepth=f,l.autoClearStencil=p,t.background=y,e>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=yv(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=_v(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(gv,Mg(t))}_fromTexture(t,e){t.mapping===Jo||t.mapping===hl?this._setSize(t.image.length===0?gv:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let i=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(i),i}_allocateTarget(){let t=this._cubeSize,e=xv(t,!1,!1),i=Math.log2(t)-kC;for(let s=0;s<=i;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==e||t&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=xv(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===Jo||t.mapping===hl?(this._cubemapMaterial===null&&(this._cubemapMaterial=yv()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=_v()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=WC(),this._integrationMaterial=$C());let e=this._cubeSize,i=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/zv);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-HC)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let l=a>0?Math.log2(e)+.5*Math.log2(6/(kv*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=qC());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,i),s.envMap.value=t.texture,this._renderCube(r,0,i)}};function xv(n,t,e){return new su(n,{minFilter:Or,generateMipmaps:t,type:Os,colorSpace:Ec,depthBuffer:e})}function ru(n,t,e){return new pi({name:n,uniforms:t,vertexShader:Ee.cube_vert,fragmentShader:e,side:oi,blending:jo,depthTest:!1,depthWrite:!1})}function WC(){return ru("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${kv}u

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
	`)}function $C(){return ru("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:zv}},`

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
	`)}function qC(){return ru("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${zC}
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
	`)}function _v(){return ru("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function yv(){return ru("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function XC(n){let t=new WeakMap,e=new WeakMap,i=null;function s(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===md||f===gd)if(t.has(d)){let p=t.get(d).texture;return a(p,d.mapping)}else{let p=d.image;if(p&&p.height>0){let y=new su(p.height);return y.fromEquirectangularTexture(n,d),t.set(d,y),d.addEventListener("dispose",c),a(y.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,p=f===md||f===gd,y=f===Jo||f===hl;if(p||y){let g=e.get(d),m=g!==void 0?g.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==m)return i===null&&(i=new of(n)),g=p?i.fromEquirectangular(d,g):i.fromCubemap(d,g),g.texture.pmremVersion=d.pmremVersion,e.set(d,g),g.texture;if(g!==void 0)return g.texture;{let x=d.image;return p&&x&&x.height>0||y&&x&&l(x)?(i===null&&(i=new of(n)),g=p?i.fromEquirectangular(d):i.fromCubemap(d),g.texture.pmremVersion=d.pmremVersion,e.set(d,g),d.addEventListener("dispose",u),g.texture):null}}}return d}function a(d,f){return f===md?d.mapping=Jo:f===gd&&(d.mapping=hl),d}function l(d){let f=0,p=6;for(let y=0;y<p;y++)d[y]!==void 0&&f++;return f===p}function c(d){let f=d.target;f.removeEventListener("dispose",c);let p=t.get(f);p!==void 0&&(t.delete(f),p.dispose())}function u(d){let f=d.target;f.removeEventListener("dispose",u);let p=e.get(f);p!==void 0&&(e.delete(f),p.dispose())}function h(){t=new WeakMap,e=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:h}}function YC(n){let t={};function e(i){if(t[i]!==void 0)return t[i];let s=n.getExtension(i);return t[i]=s,s}return{has:function(i){return e(i)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(i){let s=e(i);return s===null&&bc("WebGLRenderer: "+i+" extension not supported."),s}}}function jC(n,t,e,i){let s={},r=new WeakMap,o=new FinalizationRegistry(p=>delete s[p]);function a(p){l(p.target)}function l(p){p.index!==null&&t.remove(p.index);for(let g in p.attributes)t.remove(p.attributes[g]);p.removeEventListener("dispose",a),delete s[p.id],o.unregister(p);let y=r.get(p);y&&(t.remove(y),r.delete(p)),i.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,e.memory.geometries--}function c(p,y){return s[y.id]!==void 0||(y.addEventListener("dispose",a),s[y.id]=new WeakRef(y),o.register(y,y.id,y),e.memory.geometries++),y}function u(p){let y=p.attributes;for(let g in y)t.update(y[g],n.ARRAY_BUFFER)}function h(p){let y=p.index,g=p.attributes.position,m=0;if(g===void 0)return;let x=y!==null?y.array.length:g.array.length/3-1,w=g.count>=65535?Nc:Dc,v=new w(Math.ceil(x/3)*6,1),A=v.array;if(y!==null){let _=y.array;m=y.version;for(let M=0,N=0;M<x;M+=3){let R=_[M+0],L=_[M+1],z=_[M+2];A[N++]=R,A[N++]=L,A[N++]=L,A[N++]=z,A[N++]=z,A[N++]=R}}else{m=g.version;for(let _=0,M=0;_<x;_+=3){let N=_+0,R=_+1,L=_+2;A[M++]=N,A[M++]=R,A[M++]=R,A[M++]=L,A[M++]=L,A[M++]=N}}v.version=m;let S=r.get(p);S&&t.remove(S),r.set(p,v)}function d(p){let y=r.get(p);if(y){let g=p.index;g!==null&&y.version<g.version&&h(p)}else h(p);return r.get(p)}function f(){for(let p in s){let y=s[p].deref();y!==void 0&&l(y)}}return{get:c,update:u,getWireframeAttribute:d,dispose:f}}function ZC(n,t,e){let i;function s(h){i=h}let r,o;function a(h){r=h.type,o=h.bytesPerElement}function l(h,d){n.drawElements(i,d,r,h*o),e.update(d,i,1)}function c(h,d,f){f!==0&&(n.drawElementsInstanced(i,d,r,h*o,f),e.update(d,i,f))}function u(h,d,f){if(f===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,d,0,r,h,0,f);let y=0;for(let g=0;g<f;g++)y+=d[g];e.update(y,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function JC(n){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(e.calls++,o){case n.TRIANGLES:e.triangles+=a*(r/3);break;case n.LINES:e.lines+=a*(r/2);break;case n.LINE_STRIP:e.lines+=a*(r-1);break;case n.LINE_LOOP:e.lines+=a*r;break;case n.POINTS:e.points+=a*r;break;default:ce("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:i}}function KC(n,t,e){let i=new WeakMap,s=new bn;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,d=i.get(a);if(d===void 0||d.count!==h){let N=function(){_.dispose(),i.delete(a),a.removeEventListener("dispose",N)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,y=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],m=a.morphAttributes.normal||[],x=a.morphAttributes.color||[],w=0;f===!0&&(w=1),p===!0&&(w=2),y===!0&&(w=3);let v=a.attributes.position.count*w,A=1;v>t.maxTextureSize&&(A=Math.ceil(v/t.maxTextureSize),v=t.maxTextureSize);let S=new Float32Array(v*A*4*h),_=new Pc(S,v,A,h);_.type=ps,_.needsUpdate=!0;let M=w*4;for(let R=0;R<h;R++){let L=g[R],z=m[R],G=x[R],F=v*A*4*R;for(let U=0;U<L.count;U++){let D=U*M;f===!0&&(s.fromBufferAttribute(L,U),S[F+D+0]=s.x,S[F+D+1]=s.y,S[F+D+2]=s.z,S[F+D+3]=0),p===!0&&(s.fromBufferAttribute(z,U),S[F+D+4]=s.x,S[F+D+5]=s.y,S[F+D+6]=s.z,S[F+D+7]=0),y===!0&&(s.fromBufferAttribute(G,U),S[F+D+8]=s.x,S[F+D+9]=s.y,S[F+D+10]=s.z,S[F+D+11]=G.itemSize===4?s.w:1)}}d={count:h,texture:_,size:new Qt(v,A)},i.set(a,d),a.addEventListener("dispose",N)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,e);else{let f=0;for(let y=0;y<c.length;y++)f+=c[y];let p=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(n,"morphTargetBaseInfluence",p),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",d.texture,e),l.getUniforms().setValue(n,"morphTargetsTextureSize",d.size)}return{update:r}}function QC(n,t,e,i,s){let r=new WeakMap;function o(c){let u=s.render.frame,h=c.geometry,d=t.get(c,h);if(r.get(d)!==u&&(t.update(d),r.set(d,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(e.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==u&&(f.update(),r.set(f,u))}return d}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),e.remove(u.instanceMatrix),u.instanceColor!==null&&e.remove(u.instanceColor)}return{update:o,dispose:a}}var tP={[tg]:"LINEAR_TONE_MAPPING",[eg]:"REINHARD_TONE_MAPPING",[ng]:"CINEON_TONE_MAPPING",[ig]:"ACES_FILMIC_TONE_MAPPING",[rg]:"AGX_TONE_MAPPING",[og]:"NEUTRAL_TONE_MAPPING",[sg]:"CUSTOM_TONE_MAPPING"};function eP(n,t,e,i,s,r){let o=new ts(t,e,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new we;u.setAttribute("position",new be([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new be([0,2,0,0,2,0],2));let h=new td({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),d=new Ge(u,h),f=new fd(-1,1,1,-1,0,1),p=null,y=null,g=!1,m,x=null,w=[],v=!1;this.setSize=function(A,S){o.setSize(A,S),a!==null&&a.setSize(A,S),l!==null&&l.setSize(A,S);for(let _=0;_<w.length;_++){let M=w[_];M.setSize&&M.setSize(A,S)}},this.setEffects=function(A){w=A,v=w.length>0&&w[0].isRenderPass===!0;let S=o.width,_=o.height;w.length>0&&a===null&&(a=new ts(S,_,{type:Os,depthBuffer:!1,stencilBuffer:!1}),l=new ts(S,_,{type:Os,depthBuffer:!1,stencilBuffer:!1}));let M=s===!0&&w.some(N=>N.needsDepthTexture===!0);M!==(o.depthTexture!==null)&&(M===!0&&c===null&&(c=new Ur(S,_),r===!0&&(c.format=Fr,c.type=Ko)),o.dispose(),o.depthTexture=M?c:null,o.resolveDepthBuffer=M,o.storeMultisampledDepthBuffer=M);for(let N=0;N<w.length;N++){let R=w[N];R.setSize&&R.setSize(S,_),M&&R.needsDepthTexture===!0&&R.setDepthTexture&&R.setDepthTexture(c)}},this.begin=function(A,S){if(g||A.toneMapping===lr&&w.length===0)return!1;if(x=S,S!==null){let _=S.width,M=S.height;(o.width!==_||o.height!==M)&&this.setSize(_,M)}return v===!1&&A.setRenderTarget(o),m=A.toneMapping,A.toneMapping=lr,!0},this.hasRenderPass=function(){return v},this.end=function(A,S){A.toneMapping=m,g=!0;let _=o,M=a;for(let N=0;N<w.length;N++){let R=w[N];R.enabled!==!1&&(R.render(A,M,_,S),R.needsSwap!==!1&&(_=M,M=M===a?l:a))}if(p!==A.outputColorSpace||y!==A.toneMapping){p=A.outputColorSpace,y=A.toneMapping,h.defines={},De.getTransfer(p)===$e&&(h.defines.SRGB_TRANSFER="");let N=tP[y];N&&(h.defines[N]=""),h.needsUpdate=!0}h.uniforms.tDiffuse.value=_.texture,A.setRenderTarget(x),A.render(d,f),x=null,g=!1},this.isCompositing=function(){return g},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),h.dispose()}}var Hv=new Bi,Gv=new Ur(1,1),Vv=new Bc(1),Wv=new Pc,$v=new jh,qv=new Fc,vv=[],bv=[],wv=new Float32Array(16),Mv=new Float32Array(9),Sv=new Float32Array(4);function pl(n,t,e){let i=n[0];if(i<=0||i>0)return n;let s=t*e,r=vv[s];if(r===void 0&&(r=new Float32Array(s),vv[s]=r),t!==0){i.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,n[o].toArray(r,a)}return r}function Wn(n,t){if(n.length!==t.length)return!1;for(let e=0,i=n.length;e<i;e++)if(n[e]!==t[e])return!1;return!0}function $n(n,t){for(let e=0,i=t.length;e<i;e++)n[e]=t[e]}function lf(n,t){let e=bv[t];e===void 0&&(e=new Int32Array(t),bv[t]=e);for(let i=0;i!==t;++i)e[i]=n.allocateTextureUnit();return e}function nP(n,t){let e=this.cache;e[0]!==t&&(n.uniform1f(this.addr,t),e[0]=t)}function iP(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Wn(e,t))return;n.uniform2fv(this.addr,t),$n(e,t)}}function sP(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(n.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(Wn(e,t))return;n.uniform3fv(this.addr,t),$n(e,t)}}function rP(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Wn(e,t))return;n.uniform4fv(this.addr,t),$n(e,t)}}function oP(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Wn(e,t))return;n.uniformMatrix2fv(this.addr,!1,t),$n(e,t)}else{if(Wn(e,i))return;Sv.set(i),n.uniformMatrix2fv(this.addr,!1,Sv),$n(e,i)}}function aP(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Wn(e,t))return;n.uniformMatrix3fv(this.addr,!1,t),$n(e,t)}else{if(Wn(e,i))return;Mv.set(i),n.uniformMatrix3fv(this.addr,!1,Mv),$n(e,i)}}function lP(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Wn(e,t))return;n.uniformMatrix4fv(this.addr,!1,t),$n(e,t)}else{if(Wn(e,i))return;wv.set(i),n.uniformMatrix4fv(this.addr,!1,wv),$n(e,i)}}function cP(n,t){let e=this.cache;e[0]!==t&&(n.uniform1i(this.addr,t),e[0]=t)}function uP(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Wn(e,t))return;n.uniform2iv(this.addr,t),$n(e,t)}}function hP(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Wn(e,t))return;n.uniform3iv(this.addr,t),$n(e,t)}}function dP(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Wn(e,t))return;n.uniform4iv(this.addr,t),$n(e,t)}}function fP(n,t){let e=this.cache;e[0]!==t&&(n.uniform1ui(this.addr,t),e[0]=t)}function pP(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Wn(e,t))return;n.uniform2uiv(this.addr,t),$n(e,t)}}function mP(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Wn(e,t))return;n.uniform3uiv(this.addr,t),$n(e,t)}}function gP(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Wn(e,t))return;n.uniform4uiv(this.addr,t),$n(e,t)}}function cf(n){return n.version===0&&(n.compareFunction=yg,n.needsUpdate=!0),n}function xP(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=cf(Gv):r=Hv,e.setTexture2D(t||r,s)}function _P(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture3D(t||$v,s)}function yP(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=cf(Vv):r=qv,e.setTextureCube(t||r,s)}function vP(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture2DArray(t||Wv,s)}function bP(n){switch(n){case 5126:return nP;case 35664:return iP;case 35665:return sP;case 35666:return rP;case 35674:return oP;case 35675:return aP;case 35676:return lP;case 5124:case 35670:return cP;case 35667:case 35671:return uP;case 35668:case 35672:return hP;case 35669:case 35673:return dP;case 5125:return fP;case 36294:return pP;case 36295:return mP;case 36296:return gP;case 35678:case 36198:case 36298:case 36306:case 35682:return xP;case 35679:case 36299:case 36307:return _P;case 35680:case 36300:case 36308:case 36293:return yP;case 36289:case 36303:case 36311:case 36292:return vP}}function wP(n,t){n.uniform1fv(this.addr,t)}function MP(n,t){let e=pl(t,this.size,2);n.uniform2fv(this.addr,e)}function SP(n,t){let e=pl(t,this.size,3);n.uniform3fv(this.addr,e)}function EP(n,t){let e=pl(t,this.size,4);n.uniform4fv(this.addr,e)}function TP(n,t){let e=pl(t,this.size,4);n.uniformMatrix2fv(this.addr,!1,e)}function AP(n,t){let e=pl(t,this.size,9);n.uniformMatrix3fv(this.addr,!1,e)}function RP(n,t){let e=pl(t,this.size,16);n.uniformMatrix4fv(this.addr,!1,e)}function CP(n,t){n.uniform1iv(this.addr,t)}function PP(n,t){n.uniform2iv(this.addr,t)}function IP(n,t){n.uniform3iv(this.addr,t)}function LP(n,t){n.uniform4iv(this.addr,t)}function DP(n,t){n.uniform1uiv(this.addr,t)}function NP(n,t){n.uniform2uiv(this.addr,t)}function UP(n,t){n.uniform3uiv(this.addr,t)}function OP(n,t){n.uniform4uiv(this.addr,t)}function FP(n,t,e){let i=this.cache,s=t.length,r=lf(e,s);Wn(i,r)||(n.uniform1iv(this.addr,r),$n(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=cf(Gv):o=Hv;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function BP(n,t,e){let i=this.cache,s=t.length,r=lf(e,s);Wn(i,r)||(n.uniform1iv(this.addr,r),$n(i,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||$v,r[o])}function kP(n,t,e){let i=this.cache,s=t.length,r=lf(e,s);Wn(i,r)||(n.uniform1iv(this.addr,r),$n(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=cf(Vv):o=qv;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function zP(n,t,e){let i=this.cache,s=t.length,r=lf(e,s);Wn(i,r)||(n.uniform1iv(this.addr,r),$n(i,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||Wv,r[o])}function HP(n){switch(n){case 5126:return wP;case 35664:return MP;case 35665:return SP;case 35666:return EP;case 35674:return TP;case 35675:return AP;case 35676:return RP;case 5124:case 35670:return CP;case 35667:case 35671:return PP;case 35668:case 35672:return IP;case 35669:case 35673:return LP;case 5125:return DP;case 36294:return NP;case 36295:return UP;case 36296:return OP;case 35678:case 36198:case 36298:case 36306:case 35682:return FP;case 35679:case 36299:case 36307:return BP;case 35680:case 36300:case 36308:case 36293:return kP;case 36289:case 36303:case 36311:case 36292:return zP}}var Lg=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.setValue=bP(e.type)}},Dg=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=HP(e.type)}},Ng=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],i)}}},Pg=/(\w+)(\])?(\[|\.)?/g;function Ev(n,t){n.seq.push(t),n.map[t.id]=t}function GP(n,t,e){let i=n.name,s=i.length;for(Pg.lastIndex=0;;){let r=Pg.exec(i),o=Pg.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){Ev(e,c===void 0?new Lg(a,n,t):new Dg(a,n,t));break}else{let h=e.map[a];h===void 0&&(h=new Ng(a),Ev(e,h)),e=h}}}var fl=class{constructor(t,e){this.seq=[],this.map={};let i=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=t.getActiveUniform(e,o),l=t.getUniformLocation(e,a.name);GP(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,i,s){let r=this.map[e];r!==void 0&&r.setValue(t,i,s)}setOptional(t,e,i){let s=e[i];s!==void 0&&this.setValue(t,i,s)}static upload(t,e,i,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let i=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&i.push(o)}return i}};function Tv(n,t,e){let i=n.createShader(t);return n.shaderSource(i,e),n.compileShader(i),i}var VP=37297,WP=0;function $P(n,t){let e=n.split(`
`),i=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return i.join(`
`)}var Av=new fe;function qP(n){De._getMatrix(Av,De.workingColorSpace,n);let t=`mat3( ${Av.elements.map(e=>e.toFixed(4))} )`;switch(De.getTransfer(n)){case Tc:return[t,"LinearTransferOETF"];case $e:return[t,"sRGBTransferOETF"];default:return ie("WebGLProgram: Unsupported color space: ",n),[t,"LinearTransferOETF"]}}function Rv(n,t,e){let i=n.getShaderParameter(t,n.COMPILE_STATUS),r=(n.getShaderInfoLog(t)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+$P(n.getShaderSource(t),a)}else return r}function XP(n,t){let e=qP(t);return[`vec4 ${n}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var YP={[tg]:"Linear",[eg]:"Reinhard",[ng]:"Cineon",[ig]:"ACESFilmic",[rg]:"AgX",[og]:"Neutral",[sg]:"Custom"};function jP(n,t){let e=YP[t];return e===void 0?(ie("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var rf=new V;function ZP(){De.getLuminanceCoefficients(rf);let n=rf.x.toFixed(4),t=rf.y.toFixed(4),e=rf.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function JP(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(iu).join(`
`)}function KP(n){let t=[];for(let e in n){let i=n[e];i!==!1&&t.push("#define "+e+" "+i)}return t.join(`
`)}function QP(n,t){let e={},i=n.getProgramParameter(t,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(t,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:n.getAttribLocation(t,o),locationSize:a}}return e}function iu(n){return n!==""}function Cv(n,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function Pv(n,t){return n.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var tI=/^[ \t]*#include +<([\w\d./]+)>/gm;function Ug(n){return n.replace(tI,eI)}function eI(n,t){let e=Ee[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return Ug(e)}var nI=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Iv(n){return n.replace(nI,iI)}function iI(n,t,e,i){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Lv(n){let t=`precision ${n.precision} float;
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
#define LOW_PRECISION`),t}var sI={[Yc]:"SHADOWMAP_TYPE_PCF",[cl]:"SHADOWMAP_TYPE_VSM"};function rI(n){return sI[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var oI={[hl]:"ENVMAP_MODE_REFRACTION"};function aI(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":oI[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var lI={[Qm]:"ENVMAP_BLENDING_MULTIPLY",[Jy]:"ENVMAP_BLENDING_MIX",[Ky]:"ENVMAP_BLENDING_ADD"};function cI(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":lI[n.combine]||"ENVMAP_BLENDING_NONE"}function uI(n,t,e,i){let s=n.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=rI(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=aI(e),h=cI(e),d=JP(e),f=KP(r),p=s.createProgram(),y,g,m=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(y=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(iu).join(`
`),y.length>0&&(y+=`
`),g=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(iu).join(`
`),g.length>0&&(g+=`
`)):(y=[Lv(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+u:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(iu).join(`
`),g=[Lv(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+u:"",e.envMap?"#define "+h:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==lr?"#define TONE_MAPPING":"",e.toneMapping!==lr?Ee.tonemapping_pars_fragment:"",e.toneMapping!==lr?jP("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",Ee.colorspace_pars_fragment,XP("linearToOutputTexel",e.outputColorSpace),ZP(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(iu).join(`
`)),o=Ug(o),o=Cv(o,e),o=Pv(o,e),a=Ug(a),a=Cv(a,e),a=Pv(a,e),o=Iv(o),a=Iv(a),e.isRawShaderMaterial!==!0&&(m=`#version 300 es
`,y=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+y,g=["#define varying in",e.glslVersion===bg?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===bg?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+g);let x=m+y+o,w=m+g+a,v=Tv(s,s.VERTEX_SHADER,x),A=Tv(s,s.FRAGMENT_SHADER,w);s.attachShader(p,v),s.attachShader(p,A),e.index0AttributeName!==void 0?s.bindAttribLocation(p,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function S(R){if(n.debug.checkShaderErrors){let L=s.getProgramInfoLog(p)||"",z=s.getShaderInfoLog(v)||"",G=s.getShaderInfoLog(A)||"",F=L.trim(),U=z.trim(),D=G.trim(),O=!0,Z=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(O=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,p,v,A);else{let X=Rv(s,v,"vertex"),J=Rv(s,A,"fragment");ce("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+R.name+`
Material Type: `+R.type+`

Program Info Log: `+F+`
`+X+`
`+J)}else F!==""?ie("WebGLProgram: Program Info Log:",F):(U===""||D==="")&&(Z=!1);Z&&(R.diagnostics={runnable:O,programLog:F,vertexShader:{log:U,prefix:y},fragmentShader:{log:D,prefix:g}})}s.deleteShader(v),s.deleteShader(A),_=new fl(s,p),M=QP(s,p)}let _;this.getUniforms=function(){return _===void 0&&S(this),_};let M;this.getAttributes=function(){return M===void 0&&S(this),M};let N=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return N===!1&&(N=s.getProgramParameter(p,VP)),N},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=WP++,this.cacheKey=t,this.usedTimes=1,this.program=p,this.vertexShader=v,this.fragmentShader=A,this}var hI=0,Og=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,i){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let i of e)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,i=e.get(t);return i===void 0&&(i=new Set,e.set(t,i)),i}_getShaderStage(t){let e=this.shaderCache,i=e.get(t);return i===void 0&&(i=new Fg(t),e.set(t,i)),i}},Fg=class{constructor(t){this.id=hI++,this.code=t,this.usedTimes=0}};function dI(n){return n===xo||n===tu||n===eu}function fI(n,t,e,i,s,r){let o=new el,a=new Og,l=new Set,c=[],u=new Map,h=i.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(_){return l.add(_),_===0?"uv":`uv${_}`}function p(_,M,N,R,L,z){let G=R.fog,F=L.geometry,U=_.isMeshStandardMaterial||_.isMeshLambertMaterial||_.isMeshPhongMaterial?R.environment:null,D=_.isMeshStandardMaterial||_.isMeshLambertMaterial&&!_.envMap||_.isMeshPhongMaterial&&!_.envMap,O=t.get(_.envMap||U,D),Z=d[_.type],X=i.precision;_.precision!==null&&(X=i.getMaxPrecision(_.precision),X!==_.precision&&ie("WebGLProgram.getParameters:",_.precision,"not supported, using",X,"instead."));let J=F.morphAttributes.position||F.morphAttributes.normal||F.morphAttributes.color,nt=J!==void 0?J.length:0,dt=0;F.morphAttributes.position!==void 0&&(dt=1),F.morphAttributes.normal!==void 0&&(dt=2),F.morphAttributes.color!==void 0&&(dt=3);let ft,st,yt,xt;if(Z){let Dt=ur[Z];ft=Dt.vertexShader,st=Dt.fragmentShader}else{ft=_.vertexShader,st=_.fragmentShader;let Dt=a.getVertexShaderStage(_),ve=a.getFragmentShaderStage(_);a.update(_,Dt,ve),yt=Dt.id,xt=ve.id}let Tt=n.getRenderTarget(),At=n.state.buffers.depth.getReversed(),Jt=L.isInstancedMesh===!0,xe=L.isBatchedMesh===!0,jt=!!_.map,Te=!!_.matcap,Me=!!O,me=Me&&O.isPMREMTexture===!0,xn=!!_.aoMap,on=!!_.lightMap,In=!!_.bumpMap&&_.wireframe===!1,Je=!!_.normalMap,Zn=!!_.displacementMap,Ue=!!_.emissiveMap,kn=!!_.metalnessMap,Mn=!!_.roughnessMap,Ln=_.anisotropy>0,$=_.clearcoat>0,Nt=_.diffuseRoughness>0,se=_.dispersion>0,_e=_.retroreflectivity>0,Ct=_.iridescence>0,tn=_.sheen>0,Yt=_.transmission>0,ne=Ln&&!!_.anisotropyMap,B=$&&!!_.clearcoatMap,C=$&&!!_.clearcoatNormalMap,j=$&&!!_.clearcoatRoughnessMap,mt=Nt&&!!_.diffuseRoughnessMap,ut=Ct&&!!_.iridescenceMap,Mt=Ct&&!!_.iridescenceThicknessMap,St=tn&&!!_.sheenColorMap,rt=tn&&!!_.sheenRoughnessMap,at=!!_.specularMap,vt=!!_.specularColorMap,W=!!_.specularIntensityMap,ct=Yt&&!!_.transmissionMap,ot=Yt&&!!_.thicknessMap,Pt=!!_.gradientMap,wt=!!_.alphaMap,Rt=_.alphaTest>0,Zt=!!_.alphaHash,ae=!!_.extensions,pt=lr;_.toneMapped&&(Tt===null||Tt.isXRRenderTarget===!0)&&(pt=n.toneMapping);let $t=me?O.isCompressedCubeTexture?O.image[0].mipmaps:O.mipmaps:null,le={shaderID:Z,shaderType:_.type,shaderName:_.name,vertexShader:ft,fragmentShader:st,defines:_.defines,customVertexShaderID:yt,customFragmentShaderID:xt,isRawShaderMaterial:_.isRawShaderMaterial===!0,glslVersion:_.glslVersion,precision:X,batching:xe,batchingColor:xe&&L._colorsTexture!==null,instancing:Jt,instancingColor:Jt&&L.instanceColor!==null,instancingMorph:Jt&&L.morphTexture!==null,outputColorSpace:Tt===null?n.outputColorSpace:Tt.isXRRenderTarget===!0?Tt.texture.colorSpace:De.workingColorSpace,alphaToCoverage:!!_.alphaToCoverage,map:jt,matcap:Te,envMap:Me,envMapMode:Me&&O.mapping,envMapPMREM:me,envMapMaxLod:me?$t.length-1:null,envMapSize:me?$t[0].width:null,aoMap:xn,lightMap:on,bumpMap:In,normalMap:Je,displacementMap:Zn,emissiveMap:Ue,normalMapObjectSpace:Je&&_.normalMapType===ev,normalMapTangentSpace:Je&&_.normalMapType===pg,packedNormalMap:Je&&_.normalMapType===pg&&dI(_.normalMap.format),metalnessMap:kn,roughnessMap:Mn,anisotropy:Ln,anisotropyMap:ne,clearcoat:$,clearcoatMap:B,clearcoatNormalMap:C,clearcoatRoughnessMap:j,diffuseRoughness:Nt,diffuseRoughnessMap:mt,dispersion:se,retroreflection:_e,iridescence:Ct,iridescenceMap:ut,iridescenceThicknessMap:Mt,sheen:tn,sheenColorMap:St,sheenRoughnessMap:rt,specularMap:at,specularColorMap:vt,specularIntensityMap:W,transmission:Yt,transmissionMap:ct,thicknessMap:ot,gradientMap:Pt,opaque:_.transparent===!1&&_.blending===ul&&_.alphaToCoverage===!1,alphaMap:wt,alphaTest:Rt,alphaHash:Zt,combine:_.combine,mapUv:jt&&f(_.map.channel),aoMapUv:xn&&f(_.aoMap.channel),lightMapUv:on&&f(_.lightMap.channel),bumpMapUv:In&&f(_.bumpMap.channel),normalMapUv:Je&&f(_.normalMap.channel),displacementMapUv:Zn&&f(_.displacementMap.channel),emissiveMapUv:Ue&&f(_.emissiveMap.channel),metalnessMapUv:kn&&f(_.metalnessMap.channel),roughnessMapUv:Mn&&f(_.roughnessMap.channel),anisotropyMapUv:ne&&f(_.anisotropyMap.channel),clearcoatMapUv:B&&f(_.clearcoatMap.channel),clearcoatNormalMapUv:C&&f(_.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:j&&f(_.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:mt&&f(_.diffuseRoughnessMap.channel),iridescenceMapUv:ut&&f(_.iridescenceMap.channel),iridescenceThicknessMapUv:Mt&&f(_.iridescenceThicknessMap.channel),sheenColorMapUv:St&&f(_.sheenColorMap.channel),sheenRoughnessMapUv:rt&&f(_.sheenRoughnessMap.channel),specularMapUv:at&&f(_.specularMap.channel),specularColorMapUv:vt&&f(_.specularColorMap.channel),specularIntensityMapUv:W&&f(_.specularIntensityMap.channel),transmissionMapUv:ct&&f(_.transmissionMap.channel),thicknessMapUv:ot&&f(_.thicknessMap.channel),alphaMapUv:wt&&f(_.alphaMap.channel),vertexTangents:!!F.attributes.tangent&&(Je||Ln),vertexNormals:!!F.attributes.normal,vertexColors:_.vertexColors,vertexAlphas:_.vertexColors===!0&&!!F.attributes.color&&F.attributes.color.itemSize===4,pointsUvs:L.isPoints===!0&&!!F.attributes.uv&&(jt||wt),fog:!!G,useFog:_.fog===!0,fogExp2:!!G&&G.isFogExp2,flatShading:_.wireframe===!1&&(_.flatShading===!0||F.attributes.normal===void 0&&Je===!1&&(_.isMeshLambertMaterial||_.isMeshPhongMaterial||_.isMeshStandardMaterial||_.isMeshPhysicalMaterial)),sizeAttenuation:_.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:At,skinning:L.isSkinnedMesh===!0,hasPositionAttribute:F.attributes.position!==void 0,morphTargets:F.morphAttributes.position!==void 0,morphNormals:F.morphAttributes.normal!==void 0,morphColors:F.morphAttributes.color!==void 0,morphTargetsCount:nt,morphTextureStride:dt,numSunLights:M.sun.length,numDirLights:M.directional.length,numPointLights:M.point.length,numSpotLights:M.spot.length,numSpotLightMaps:M.spotLightMap.length,numRectAreaLights:M.rectArea.length,numHemiLights:M.hemi.length,numSunLightShadows:M.sunShadowMap.length,numDirLightShadows:M.directionalShadowMap.length,numPointLightShadows:M.pointShadowMap.length,numSpotLightShadows:M.spotShadowMap.length,numSpotLightShadowsWithMaps:M.numSpotLightShadowsWithMaps,numLightProbes:M.numLightProbes,numLightProbeGrids:z.filter(Dt=>Dt.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:_.dithering,shadowMapEnabled:n.shadowMap.enabled&&N.length>0,shadowMapType:n.shadowMap.type,toneMapping:pt,decodeVideoTexture:jt&&_.map.isVideoTexture===!0&&De.getTransfer(_.map.colorSpace)===$e,decodeVideoTextureEmissive:Ue&&_.emissiveMap.isVideoTexture===!0&&De.getTransfer(_.emissiveMap.colorSpace)===$e,premultipliedAlpha:_.premultipliedAlpha,doubleSided:_.side===mi,flipSided:_.side===oi,useDepthPacking:_.depthPacking>=0,depthPacking:_.depthPacking||0,index0AttributeName:_.index0AttributeName,extensionClipCullDistance:ae&&_.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(ae&&_.extensions.multiDraw===!0||xe)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:_.customProgramCacheKey()};return le.vertexUv1s=l.has(1),le.vertexUv2s=l.has(2),le.vertexUv3s=l.has(3),l.clear(),le}function y(_){let M=[];if(_.shaderID?M.push(_.shaderID):(M.push(_.customVertexShaderID),M.push(_.customFragmentShaderID)),_.defines!==void 0)for(let N in _.defines)M.push(N),M.push(_.defines[N]);return _.isRawShaderMaterial===!1&&(g(M,_),m(M,_),M.push(n.outputColorSpace)),M.push(_.customProgramCacheKey),M.join()}function g(_,M){_.push(M.precision),_.push(M.outputColorSpace),_.push(M.envMapMode),_.push(M.envMapPMREM),_.push(M.envMapMaxLod),_.push(M.envMapSize),_.push(M.mapUv),_.push(M.alphaMapUv),_.push(M.lightMapUv),_.push(M.aoMapUv),_.push(M.bumpMapUv),_.push(M.normalMapUv),_.push(M.displacementMapUv),_.push(M.emissiveMapUv),_.push(M.metalnessMapUv),_.push(M.roughnessMapUv),_.push(M.anisotropyMapUv),_.push(M.clearcoatMapUv),_.push(M.clearcoatNormalMapUv),_.push(M.clearcoatRoughnessMapUv),_.push(M.diffuseRoughnessMapUv),_.push(M.iridescenceMapUv),_.push(M.iridescenceThicknessMapUv),_.push(M.sheenColorMapUv),_.push(M.sheenRoughnessMapUv),_.push(M.specularMapUv),_.push(M.specularColorMapUv),_.push(M.specularIntensityMapUv),_.push(M.transmissionMapUv),_.push(M.thicknessMapUv),_.push(M.combine),_.push(M.fogExp2),_.push(M.sizeAttenuation),_.push(M.morphTargetsCount),_.push(M.numSunLights),_.push(M.numDirLights),_.push(M.numPointLights),_.push(M.numSpotLights),_.push(M.numSpotLightMaps),_.push(M.numHemiLights),_.push(M.numRectAreaLights),_.push(M.numSunLightShadows),_.push(M.numDirLightShadows),_.push(M.numPointLightShadows),_.push(M.numSpotLightShadows),_.push(M.numSpotLightShadowsWithMaps),_.push(M.numLightProbes),_.push(M.numLightProbeGrids),_.push(M.shadowMapType),_.push(M.toneMapping),_.push(M.numClippingPlanes),_.push(M.numClipIntersection),_.push(M.depthPacking)}function m(_,M){o.disableAll(),M.instancing&&o.enable(0),M.instancingColor&&o.enable(1),M.instancingMorph&&o.enable(2),M.matcap&&o.enable(3),M.envMap&&o.enable(4),M.normalMapObjectSpace&&o.enable(5),M.normalMapTangentSpace&&o.enable(6),M.clearcoat&&o.enable(7),M.iridescence&&o.enable(8),M.alphaTest&&o.enable(9),M.vertexColors&&o.enable(10),M.vertexAlphas&&o.enable(11),M.vertexUv1s&&o.enable(12),M.vertexUv2s&&o.enable(13),M.vertexUv3s&&o.enable(14),M.vertexTangents&&o.enable(15),M.anisotropy&&o.enable(16),M.alphaHash&&o.enable(17),M.batching&&o.enable(18),M.dispersion&&o.enable(19),M.retroreflection&&o.enable(24),M.diffuseRoughness&&o.enable(25),M.batchingColor&&o.enable(20),M.gradientMap&&o.enable(21),M.packedNormalMap&&o.enable(22),M.vertexNormals&&o.enable(23),_.push(o.mask),o.disableAll(),M.fog&&o.enable(0),M.useFog&&o.enable(1),M.flatShading&&o.enable(2),M.logarithmicDepthBuffer&&o.enable(3),M.reversedDepthBuffer&&o.enable(4),M.skinning&&o.enable(5),M.morphTargets&&o.enable(6),M.morphNormals&&o.enable(7),M.morphColors&&o.enable(8),M.premultipliedAlpha&&o.enable(9),M.shadowMapEnabled&&o.enable(10),M.doubleSided&&o.enable(11),M.flipSided&&o.enable(12),M.useDepthPacking&&o.enable(13),M.dithering&&o.enable(14),M.transmission&&o.enable(15),M.sheen&&o.enable(16),M.opaque&&o.enable(17),M.pointsUvs&&o.enable(18),M.decodeVideoTexture&&o.enable(19),M.decodeVideoTextureEmissive&&o.enable(20),M.alphaToCoverage&&o.enable(21),M.numLightProbeGrids>0&&o.enable(22),M.hasPositionAttribute&&o.enable(23),_.push(o.mask)}function x(_){let M=d[_.type],N;if(M){let R=ur[M];N=fv.clone(R.uniforms)}else N=_.uniforms;return N}function w(_,M){let N=u.get(M);return N!==void 0?++N.usedTimes:(N=new uI(n,M,_,s),c.push(N),u.set(M,N)),N}function v(_){if(--_.usedTimes===0){let M=c.indexOf(_);c[M]=c[c.length-1],c.pop(),u.delete(_.cacheKey),_.destroy()}}function A(_){a.remove(_)}function S(){a.dispose()}return{getParameters:p,getProgramCacheKey:y,getUniforms:x,acquireProgram:w,releaseProgram:v,releaseShaderCache:A,programs:c,dispose:S}}function pI(){let n=new WeakMap;function t(o){return n.has(o)}function e(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:t,get:e,remove:i,update:s,dispose:r}}function mI(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.material.id!==t.material.id?n.material.id-t.material.id:n.materialVariant!==t.materialVariant?n.materialVariant-t.materialVariant:n.z!==t.z?n.z-t.z:n.id-t.id}function Dv(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.z!==t.z?t.z-n.z:n.id-t.id}function Nv(){let n=[],t=0,e=[],i=[],s=[];function r(){t=0,e.length=0,i.length=0,s.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,p,y,g,m){let x=n[t];return x===void 0?(x={id:d.id,object:d,geometry:f,material:p,materialVariant:o(d),groupOrder:y,renderOrder:d.renderOrder,z:g,group:m},n[t]=x):(x.id=d.id,x.object=d,x.geometry=f,x.material=p,x.materialVariant=o(d),x.groupOrder=y,x.renderOrder=d.renderOrder,x.z=g,x.group=m),t++,x}function l(d,f,p,y,g,m,x){x.reversedDepth===!0&&(g=-g);let w=a(d,f,p,y,g,m);p.transmission>0?i.push(w):p.transparent===!0?s.push(w):e.push(w)}function c(d,f,p,y,g,m){let x=a(d,f,p,y,g,m);p.transmission>0?i.unshift(x):p.transparent===!0?s.unshift(x):e.unshift(x)}function u(d,f){e.length>1&&e.sort(d||mI),i.length>1&&i.sort(f||Dv),s.length>1&&s.sort(f||Dv)}function h(){for(let d=t,f=n.length;d<f;d++){let p=n[d];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:e,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:h,sort:u}}function gI(){let n=new WeakMap;function t(i,s){let r=n.get(i),o;return r===void 0?(o=new Nv,n.set(i,[o])):s>=r.length?(o=new Nv,r.push(o)):o=r[s],o}function e(){n=new WeakMap}return{get:t,dispose:e}}function xI(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new V,color:new ee};break;case"SpotLight":e={position:new V,direction:new V,color:new ee,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new V,color:new ee,distance:0,decay:0};break;case"HemisphereLight":e={direction:new V,skyColor:new ee,groundColor:new ee};break;case"RectAreaLight":e={color:new ee,position:new V,halfWidth:new V,halfHeight:new V};break}return n[t.id]=e,e}}}function _I(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Qt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Qt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Qt,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[t.id]=e,e}}}var yI=0;function vI(n,t){return(t.castShadow?2:0)-(n.castShadow?2:0)+(t.map?1:0)-(n.map?1:0)}function bI(n){let t=new xI,e=_I(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new V);let s=new V,r=new ye,o=new ye;function a(c){let u=0,h=0,d=0;for(let z=0;z<9;z++)i.probe[z].set(0,0,0);let f=0,p=0,y=0,g=0,m=0,x=0,w=0,v=0,A=0,S=0,_=0,M=0,N=0,R=0;c.sort(vI);for(let z=0,G=c.length;z<G;z++){let F=c[z],U=F.color,D=F.intensity,O=F.distance,Z=null;if(F.shadow&&F.shadow.map&&(F.shadow.map.texture.format===xo?Z=F.shadow.map.texture:Z=F.shadow.map.depthTexture||F.shadow.map.texture),F.isAmbientLight)u+=U.r*D,h+=U.g*D,d+=U.b*D;else if(F.isLightProbe){for(let X=0;X<9;X++)i.probe[X].addScaledVector(F.sh.coefficients[X],D);R++}else if(F.isSunLight){let X=t.get(F);if(X.color.copy(F.color).multiplyScalar(F.intensity),F.castShadow){let J=F.shadow,nt=e.get(F);nt.shadowIntensity=J.intensity,nt.shadowBias=J.bias,nt.shadowNormalBias=J.normalBias,nt.shadowRadius=J.radius,nt.shadowMapSize.copy(J.mapSize).multiply(J.getFrameExtents()),i.sunShadow[p]=nt,i.sunShadowMap[p]=Z;let dt=J.getViewportCount();for(let ft=0;ft<dt;ft++)i.sunShadowMatrix[y+ft]=J.getMatrix(ft),i.sunShadowCascade[y+ft]=J._cascadeData[ft];y+=dt,p++}i.sun[f]=X,f++}else if(F.isDirectionalLight){let X=t.get(F);if(X.color.copy(F.color).multiplyScalar(F.intensity),F.castShadow){let J=F.shadow,nt=e.get(F);nt.shadowIntensity=J.intensity,nt.shadowBias=J.bias,nt.shadowNormalBias=J.normalBias,nt.shadowRadius=J.radius,nt.shadowMapSize=J.mapSize,i.directionalShadow[g]=nt,i.directionalShadowMap[g]=Z,i.directionalShadowMatrix[g]=F.shadow.matrix,A++}i.directional[g]=X,g++}else if(F.isSpotLight){let X=t.get(F);X.position.setFromMatrixPosition(F.matrixWorld),X.color.copy(U).multiplyScalar(D),X.distance=O,X.coneCos=Math.cos(F.angle),X.penumbraCos=Math.cos(F.angle*(1-F.penumbra)),X.decay=F.decay,i.spot[x]=X;let J=F.shadow;if(F.map&&(i.spotLightMap[M]=F.map,M++,J.updateMatrices(F),F.castShadow&&N++),i.spotLightMatrix[x]=J.matrix,F.castShadow){let nt=e.get(F);nt.shadowIntensity=J.intensity,nt.shadowBias=J.bias,nt.shadowNormalBias=J.normalBias,nt.shadowRadius=J.radius,nt.shadowMapSize=J.mapSize,i.spotShadow[x]=nt,i.spotShadowMap[x]=Z,_++}x++}else if(F.isRectAreaLight){let X=t.get(F);X.color.copy(U).multiplyScalar(D),X.halfWidth.set(F.width*.5,0,0),X.halfHeight.set(0,F.height*.5,0),i.rectArea[w]=X,w++}else if(F.isPointLight){let X=t.get(F);if(X.color.copy(F.color).multiplyScalar(F.intensity),X.distance=F.distance,X.decay=F.decay,F.castShadow){let J=F.shadow,nt=e.get(F);nt.shadowIntensity=J.intensity,nt.shadowBias=J.bias,nt.shadowNormalBias=J.normalBias,nt.shadowRadius=J.radius,nt.shadowMapSize=J.mapSize,nt.shadowCameraNear=J.camera.near,nt.shadowCameraFar=J.camera.far,i.pointShadow[m]=nt,i.pointShadowMap[m]=Z,i.pointShadowMatrix[m]=F.shadow.matrix,S++}i.point[m]=X,m++}else if(F.isHemisphereLight){let X=t.get(F);X.skyColor.copy(F.color).multiplyScalar(D),X.groundColor.copy(F.groundColor).multiplyScalar(D),i.hemi[v]=X,v++}}w>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=kt.LTC_FLOAT_1,i.rectAreaLTC2=kt.LTC_FLOAT_2):(i.rectAreaLTC1=kt.LTC_HALF_1,i.rectAreaLTC2=kt.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=h,i.ambient[2]=d;let L=i.hash;(L.sunLength!==f||L.directionalLength!==g||L.pointLength!==m||L.spotLength!==x||L.rectAreaLength!==w||L.hemiLength!==v||L.numSunShadows!==p||L.numDirectionalShadows!==A||L.numPointShadows!==S||L.numSpotShadows!==_||L.numSpotMaps!==M||L.numLightProbes!==R)&&(i.sun.length=f,i.directional.length=g,i.spot.length=x,i.rectArea.length=w,i.point.length=m,i.hemi.length=v,i.sunShadow.length=p,i.sunShadowMap.length=p,i.sunShadowMatrix.length=y,i.sunShadowCascade.length=y,i.directionalShadow.length=A,i.directionalShadowMap.length=A,i.directionalShadowMatrix.length=A,i.pointShadow.length=S,i.pointShadowMap.length=S,i.pointShadowMatrix.length=S,i.spotShadow.length=_,i.spotShadowMap.length=_,i.spotLightMatrix.length=_+M-N,i.spotLightMap.length=M,i.numSpotLightShadowsWithMaps=N,i.numLightProbes=R,L.sunLength=f,L.directionalLength=g,L.pointLength=m,L.spotLength=x,L.rectAreaLength=w,L.hemiLength=v,L.numSunShadows=p,L.numDirectionalShadows=A,L.numPointShadows=S,L.numSpotShadows=_,L.numSpotMaps=M,L.numLightProbes=R,i.version=yI++)}function l(c,u){let h=0,d=0,f=0,p=0,y=0,g=0,m=u.matrixWorldInverse;for(let x=0,w=c.length;x<w;x++){let v=c[x];if(v.isSunLight){let A=i.sun[h];A.direction.setFromMatrixPosition(v.matrixWorld),A.direction.transformDirection(m),h++}else if(v.isDirectionalLight){let A=i.directional[d];A.direction.setFromMatrixPosition(v.matrixWorld),s.setFromMatrixPosition(v.target.matrixWorld),A.direction.sub(s),A.direction.transformDirection(m),d++}else if(v.isSpotLight){let A=i.spot[p];A.position.setFromMatrixPosition(v.matrixWorld),A.position.applyMatrix4(m),A.direction.setFromMatrixPosition(v.matrixWorld),s.setFromMatrixPosition(v.target.matrixWorld),A.direction.sub(s),A.direction.transformDirection(m),p++}else if(v.isRectAreaLight){let A=i.rectArea[y];A.position.setFromMatrixPosition(v.matrixWorld),A.position.applyMatrix4(m),o.identity(),r.copy(v.matrixWorld),r.premultiply(m),o.extractRotation(r),A.halfWidth.set(v.width*.5,0,0),A.halfHeight.set(0,v.height*.5,0),A.halfWidth.applyMatrix4(o),A.halfHeight.applyMatrix4(o),y++}else if(v.isPointLight){let A=i.point[f];A.position.setFromMatrixPosition(v.matrixWorld),A.position.applyMatrix4(m),f++}else if(v.isHemisphereLight){let A=i.hemi[g];A.direction.setFromMatrixPosition(v.matrixWorld),A.direction.transformDirection(m),g++}}}return{setup:a,setupView:l,state:i}}function Uv(n){let t=new bI(n),e=[],i=[],s=[];function r(h){u.camera=h,e.length=0,i.length=0,s.length=0}function o(h){h.isLightProbeGrid?s.push(h):e.push(h)}function a(h){i.push(h)}function l(){t.setup(e),s.sort((h,d)=>h.priority-d.priority||h.id-d.id)}function c(h){t.setupView(e,h)}let u={lightsArray:e,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function wI(n){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new Uv(n),t.set(s,[a])):r>=o.length?(a=new Uv(n),o.push(a)):a=o[r],a}function i(){t=new WeakMap}return{get:e,dispose:i}}var MI=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,SI=`uniform sampler2D shadow_pass;
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
}`,EI=[new V(1,0,0),new V(-1,0,0),new V(0,1,0),new V(0,-1,0),new V(0,0,1),new V(0,0,-1)],TI=[new V(0,-1,0),new V(0,-1,0),new V(0,0,1),new V(0,0,-1),new V(0,-1,0),new V(0,-1,0)],Ov=new ye,nu=new V,Ig=new V;function AI(n,t,e){let i=new $o,s=new Qt,r=new Qt,o=new bn,a=new ed,l=new nd,c={},u=e.maxTextureSize,h={[ar]:oi,[oi]:ar,[mi]:mi},d=new pi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Qt},radius:{value:4}},vertexShader:MI,fragmentShader:SI}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let p=new we;p.setAttribute("position",new He(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let y=new Ge(p,d),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Yc;let m=this.type;this.render=function(S,_,M){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||S.length===0)return;this.type===Ly&&(ie("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Yc);let N=n.getRenderTarget(),R=n.getActiveCubeFace(),L=n.getActiveMipmapLevel(),z=n.state;z.setBlending(jo),z.buffers.depth.getReversed()===!0?z.buffers.color.setClear(0,0,0,0):z.buffers.color.setClear(1,1,1,1),z.buffers.depth.setTest(!0),z.setScissorTest(!1);let G=m!==this.type;G&&_.traverse(function(F){F.material&&(Array.isArray(F.material)?F.material.forEach(U=>U.needsUpdate=!0):F.material.needsUpdate=!0)});for(let F=0,U=S.length;F<U;F++){let D=S[F],O=D.shadow;if(O===void 0){ie("WebGLShadowMap:",D,"has no shadow.");continue}if(O.autoUpdate===!1&&O.needsUpdate===!1)continue;s.copy(O.mapSize);let Z=O.getFrameExtents();s.multiply(Z),r.copy(O.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/Z.x),s.x=r.x*Z.x,O.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/Z.y),s.y=r.y*Z.y,O.mapSize.y=r.y));let X=n.state.buffers.depth.getReversed();if(O.camera._reversedDepth=X,O.map===null||G===!0){if(O.map!==null&&(O.map.depthTexture!==null&&(O.map.depthTexture.dispose(),O.map.depthTexture=null),O.map.dispose()),this.type===cl){if(D.isPointLight){ie("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}O.map=new ts(s.x,s.y,{format:xo,type:Os,minFilter:Ri,magFilter:Ri,generateMipmaps:!1}),O.map.texture.name=D.name+".shadowMap",O.map.depthTexture=new Ur(s.x,s.y,ps),O.map.depthTexture.name=D.name+".shadowMapDepth",O.map.depthTexture.format=Ir,O.map.depthTexture.compareFunction=null,O.map.depthTexture.minFilter=ni,O.map.depthTexture.magFilter=ni}else D.isPointLight?(O.map=new su(s.x),O.map.depthTexture=new Bc(s.x,Us)):(O.map=new ts(s.x,s.y),O.map.depthTexture=new Ur(s.x,s.y,Us)),O.map.depthTexture.name=D.name+".shadowMap",O.map.depthTexture.format=Ir,this.type===Yc?(O.map.depthTexture.compareFunction=X?_g:xg,O.map.depthTexture.minFilter=Ri,O.map.depthTexture.magFilter=Ri):(O.map.depthTexture.compareFunction=null,O.map.depthTexture.minFilter=ni,O.map.depthTexture.magFilter=ni);O.camera.updateProjectionMatrix()}O.map.isWebGLCubeRenderTarget!==!0&&(O.map.width!==s.x||O.map.height!==s.y)&&O.map.setSize(s.x,s.y);let J=O.map.isWebGLCubeRenderTarget?6:O.getViewportCount();D.isPointLight!==!0&&O.updateMatrices(D,M);let nt=(O.camera.layers.mask&4294967294)!==0?O.camera.layers:M.layers;for(let dt=0;dt<J;dt++){let ft=O.getCamera(dt);if(D.isPointLight){let st=O.camera,yt=O.matrix,xt=D.distance||st.far;xt!==st.far&&(st.far=xt,st.updateProjectionMatrix()),nu.setFromMatrixPosition(D.matrixWorld),st.position.copy(nu),Ig.copy(st.position),Ig.add(EI[dt]),st.up.copy(TI[dt]),st.lookAt(Ig),st.updateMatrixWorld(),yt.makeTranslation(-nu.x,-nu.y,-nu.z),Ov.multiplyMatrices(st.projectionMatrix,st.matrixWorldInverse),O._frustum.setFromProjectionMatrix(Ov,st.coordinateSystem,st.reversedDepth)}if(O.map.isWebGLCubeRenderTarget)n.setRenderTarget(O.map,dt),n.clear();else{dt===0&&(n.setRenderTarget(O.map),n.clear());let st=O.getViewport(dt);o.set(r.x*st.x,r.y*st.y,r.x*st.z,r.y*st.w),z.viewport(o)}i=O.getFrustum(dt),v(_,M,ft,D,nt,this.type)}O.isPointLightShadow!==!0&&this.type===cl&&x(O,M),O.needsUpdate=!1}m=this.type,g.needsUpdate=!1,n.setRenderTarget(N,R,L)};function x(S,_){let M=t.update(y);d.defines.VSM_SAMPLES!==S.blurSamples&&(d.defines.VSM_SAMPLES=S.blurSamples,f.defines.VSM_SAMPLES=S.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),S.mapPass===null?S.mapPass=new ts(s.x,s.y,{format:xo,type:Os}):(S.mapPass.width!==S.map.width||S.mapPass.height!==S.map.height)&&S.mapPass.setSize(S.map.width,S.map.height),d.uniforms.shadow_pass.value=S.map.depthTexture,d.uniforms.resolution.value.set(S.map.width,S.map.height),d.uniforms.radius.value=S.radius,n.setRenderTarget(S.mapPass),n.clear(),n.renderBufferDirect(_,null,M,d,y,null),f.uniforms.shadow_pass.value=S.mapPass.texture,f.uniforms.resolution.value.set(S.map.width,S.map.height),f.uniforms.radius.value=S.radius,n.setRenderTarget(S.map),n.clear(),n.renderBufferDirect(_,null,M,f,y,null)}function w(S,_,M,N){let R=null,L=M.isPointLight===!0?S.customDistanceMaterial:S.customDepthMaterial;if(L!==void 0)R=L;else if(R=M.isPointLight===!0?l:a,n.localClippingEnabled&&_.clipShadows===!0&&Array.isArray(_.clippingPlanes)&&_.clippingPlanes.length!==0||_.displacementMap&&_.displacementScale!==0||_.alphaMap&&_.alphaTest>0||_.map&&_.alphaTest>0||_.alphaToCoverage===!0){let z=R.uuid,G=_.uuid,F=c[z];F===void 0&&(F={},c[z]=F);let U=F[G];U===void 0&&(U=R.clone(),F[G]=U,_.addEventListener("dispose",A)),R=U}if(R.visible=_.visible,R.wireframe=_.wireframe,N===cl?R.side=_.shadowSide!==null?_.shadowSide:_.side:R.side=_.shadowSide!==null?_.shadowSide:h[_.side],R.alphaMap=_.alphaMap,R.alphaTest=_.alphaToCoverage===!0?.5:_.alphaTest,R.map=_.map,R.clipShadows=_.clipShadows,R.clippingPlanes=_.clippingPlanes,R.clipIntersection=_.clipIntersection,R.displacementMap=_.displacementMap,R.displacementScale=_.displacementScale,R.displacementBias=_.displacementBias,R.wireframeLinewidth=_.wireframeLinewidth,R.linewidth=_.linewidth,M.isPointLight===!0&&R.isMeshDistanceMaterial===!0){let z=n.properties.get(R);z.light=M}return R}function v(S,_,M,N,R,L){if(S.visible===!1)return;if(S.layers.test(R)&&(S.isMesh||S.isLine||S.isPoints)&&(S.castShadow||S.receiveShadow&&L===cl)&&(!S.frustumCulled||S.intersectsFrustum(i))){S.modelViewMatrix.multiplyMatrices(M.matrixWorldInverse,S.matrixWorld);let F=t.update(S),U=S.material;if(Array.isArray(U)){let D=F.groups;for(let O=0,Z=D.length;O<Z;O++){let X=D[O],J=U[X.materialIndex];if(J&&J.visible){let nt=w(S,J,N,L);S.onBeforeShadow(n,S,_,M,F,nt,X),n.renderBufferDirect(M,null,F,nt,S,X),S.onAfterShadow(n,S,_,M,F,nt,X)}}}else if(U.visible){let D=w(S,U,N,L);S.onBeforeShadow(n,S,_,M,F,D,null),n.renderBufferDirect(M,null,F,D,S,null),S.onAfterShadow(n,S,_,M,F,D,null)}}let G=S.children;for(let F=0,U=G.length;F<U;F++)v(G[F],_,M,N,R,L)}function A(S){S.target.removeEventListener("dispose",A);for(let M in c){let N=c[M],R=S.target.uuid;R in N&&(N[R].dispose(),delete N[R])}}}function RI(n,t){function e(){let W=!1,ct=new bn,ot=null,Pt=new bn(0,0,0,0);return{setMask:function(wt){ot!==wt&&!W&&(n.colorMask(wt,wt,wt,wt),ot=wt)},setLocked:function(wt){W=wt},setClear:function(wt,Rt,Zt,ae,pt){pt===!0&&(wt*=ae,Rt*=ae,Zt*=ae),ct.set(wt,Rt,Zt,ae),Pt.equals(ct)===!1&&(n.clearColor(wt,Rt,Zt,ae),Pt.copy(ct))},reset:function(){W=!1,ot=null,Pt.set(-1,0,0,0)}}}function i(){let W=!1,ct=!1,ot=null,Pt=null,wt=null;return{setReversed:function(Rt){if(ct!==Rt){let Zt=t.get("EXT_clip_control");Rt?Zt.clipControlEXT(Zt.LOWER_LEFT_EXT,Zt.ZERO_TO_ONE_EXT):Zt.clipControlEXT(Zt.LOWER_LEFT_EXT,Zt.NEGATIVE_ONE_TO_ONE_EXT),ct=Rt;let ae=wt;wt=null,this.setClear(ae)}},getReversed:function(){return ct},setTest:function(Rt){Rt?At(n.DEPTH_TEST):Jt(n.DEPTH_TEST)},setMask:function(Rt){ot!==Rt&&!W&&(n.depthMask(Rt),ot=Rt)},setFunc:function(Rt){if(ct&&(Rt=hv[Rt]),Pt!==Rt){switch(Rt){case Fh:n.depthFunc(n.NEVER);break;case Bh:n.depthFunc(n.ALWAYS);break;case kh:n.depthFunc(n.LESS);break;case Ja:n.depthFunc(n.LEQUAL);break;case zh:n.depthFunc(n.EQUAL);break;case Hh:n.depthFunc(n.GEQUAL);break;case Gh:n.depthFunc(n.GREATER);break;case Vh:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Pt=Rt}},setLocked:function(Rt){W=Rt},setClear:function(Rt){wt!==Rt&&(wt=Rt,ct&&(Rt=1-Rt),n.clearDepth(Rt))},reset:function(){W=!1,ot=null,Pt=null,wt=null,ct=!1}}}function s(){let W=!1,ct=null,ot=null,Pt=null,wt=null,Rt=null,Zt=null,ae=null,pt=null;return{setTest:function($t){W||($t?At(n.STENCIL_TEST):Jt(n.STENCIL_TEST))},setMask:function($t){ct!==$t&&!W&&(n.stencilMask($t),ct=$t)},setFunc:function($t,le,Dt){(ot!==$t||Pt!==le||wt!==Dt)&&(n.stencilFunc($t,le,Dt),ot=$t,Pt=le,wt=Dt)},setOp:function($t,le,Dt){(Rt!==$t||Zt!==le||ae!==Dt)&&(n.stencilOp($t,le,Dt),Rt=$t,Zt=le,ae=Dt)},setLocked:function($t){W=$t},setClear:function($t){pt!==$t&&(n.clearStencil($t),pt=$t)},reset:function(){W=!1,ct=null,ot=null,Pt=null,wt=null,Rt=null,Zt=null,ae=null,pt=null}}}let r=new e,o=new i,a=new s,l={},c=new WeakMap,u={},h={},d={},f=new WeakMap,p=[],y=null,g=!1,m=null,x=null,w=null,v=null,A=null,S=null,_=null,M=new ee(0,0,0),N=0,R=!1,L=null,z=null,G=null,F=null,U=null,D=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),O=!1,Z=0,X=n.getParameter(n.VERSION);X.indexOf("WebGL")!==-1?(Z=parseFloat(/^WebGL (\d)/.exec(X)[1]),O=Z>=1):X.indexOf("OpenGL ES")!==-1&&(Z=parseFloat(/^OpenGL ES (\d)/.exec(X)[1]),O=Z>=2);let J=null,nt={},dt=n.getParameter(n.SCISSOR_BOX),ft=n.getParameter(n.VIEWPORT),st=new bn().fromArray(dt),yt=new bn().fromArray(ft);function xt(W,ct,ot,Pt){let wt=new Uint8Array(4),Rt=n.createTexture();n.bindTexture(W,Rt),n.texParameteri(W,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(W,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Zt=0;Zt<ot;Zt++)W===n.TEXTURE_3D||W===n.TEXTURE_2D_ARRAY?n.texImage3D(ct,0,n.RGBA,1,1,Pt,0,n.RGBA,n.UNSIGNED_BYTE,wt):n.texImage2D(ct+Zt,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,wt);return Rt}let Tt={};Tt[n.TEXTURE_2D]=xt(n.TEXTURE_2D,n.TEXTURE_2D,1),Tt[n.TEXTURE_CUBE_MAP]=xt(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Tt[n.TEXTURE_2D_ARRAY]=xt(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Tt[n.TEXTURE_3D]=xt(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),At(n.DEPTH_TEST),o.setFunc(Ja),In(!1),Je(Xm),At(n.CULL_FACE),xn(jo);function At(W){u[W]!==!0&&(n.enable(W),u[W]=!0)}function Jt(W){u[W]!==!1&&(n.disable(W),u[W]=!1)}function xe(W,ct){return d[W]!==ct?(n.bindFramebuffer(W,ct),d[W]=ct,W===n.DRAW_FRAMEBUFFER&&(d[n.FRAMEBUFFER]=ct),W===n.FRAMEBUFFER&&(d[n.DRAW_FRAMEBUFFER]=ct),!0):!1}function jt(W,ct){let ot=p,Pt=!1;if(W){ot=f.get(ct),ot===void 0&&(ot=[],f.set(ct,ot));let wt=W.textures;if(ot.length!==wt.length||ot[0]!==n.COLOR_ATTACHMENT0){for(let Rt=0,Zt=wt.length;Rt<Zt;Rt++)ot[Rt]=n.COLOR_ATTACHMENT0+Rt;ot.length=wt.length,Pt=!0}}else ot[0]!==n.BACK&&(ot[0]=n.BACK,Pt=!0);Pt&&n.drawBuffers(ot)}function Te(W){return y!==W?(n.useProgram(W),y=W,!0):!1}let Me={[Zo]:n.FUNC_ADD,[Ny]:n.FUNC_SUBTRACT,[Uy]:n.FUNC_REVERSE_SUBTRACT};Me[Oy]=n.MIN,Me[Fy]=n.MAX;let me={[By]:n.ZERO,[ky]:n.ONE,[zy]:n.SRC_COLOR,[Jm]:n.SRC_ALPHA,[qy]:n.SRC_ALPHA_SATURATE,[Wy]:n.DST_COLOR,[Gy]:n.DST_ALPHA,[Hy]:n.ONE_MINUS_SRC_COLOR,[Km]:n.ONE_MINUS_SRC_ALPHA,[$y]:n.ONE_MINUS_DST_COLOR,[Vy]:n.ONE_MINUS_DST_ALPHA,[Xy]:n.CONSTANT_COLOR,[Yy]:n.ONE_MINUS_CONSTANT_COLOR,[jy]:n.CONSTANT_ALPHA,[Zy]:n.ONE_MINUS_CONSTANT_ALPHA};function xn(W,ct,ot,Pt,wt,Rt,Zt,ae,pt,$t){if(W===jo){g===!0&&(Jt(n.BLEND),g=!1);return}if(g===!1&&(At(n.BLEND),g=!0),W!==Dy){if(W!==m||$t!==R){if((x!==Zo||A!==Zo)&&(n.blendEquation(n.FUNC_ADD),x=Zo,A=Zo),$t)switch(W){case ul:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Ym:n.blendFunc(n.ONE,n.ONE);break;case jm:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Zm:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:ce("WebGLState: Invalid blending: ",W);break}else switch(W){case ul:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Ym:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case jm:ce("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Zm:ce("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:ce("WebGLState: Invalid blending: ",W);break}w=null,v=null,S=null,_=null,M.set(0,0,0),N=0,m=W,R=$t}return}wt=wt||ct,Rt=Rt||ot,Zt=Zt||Pt,(ct!==x||wt!==A)&&(n.blendEquationSeparate(Me[ct],Me[wt]),x=ct,A=wt),(ot!==w||Pt!==v||Rt!==S||Zt!==_)&&(n.blendFuncSeparate(me[ot],me[Pt],me[Rt],me[Zt]),w=ot,v=Pt,S=Rt,_=Zt),(ae.equals(M)===!1||pt!==N)&&(n.blendColor(ae.r,ae.g,ae.b,pt),M.copy(ae),N=pt),m=W,R=!1}function on(W,ct){W.side===mi?Jt(n.CULL_FACE):At(n.CULL_FACE);let ot=W.side===oi;ct&&(ot=!ot),In(ot),W.blending===ul&&W.transparent===!1?xn(jo):xn(W.blending,W.blendEquation,W.blendSrc,W.blendDst,W.blendEquationAlpha,W.blendSrcAlpha,W.blendDstAlpha,W.blendColor,W.blendAlpha,W.premultipliedAlpha),o.setFunc(W.depthFunc),o.setTest(W.depthTest),o.setMask(W.depthWrite),r.setMask(W.colorWrite);let Pt=W.stencilWrite;a.setTest(Pt),Pt&&(a.setMask(W.stencilWriteMask),a.setFunc(W.stencilFunc,W.stencilRef,W.stencilFuncMask),a.setOp(W.stencilFail,W.stencilZFail,W.stencilZPass)),Ue(W.polygonOffset,W.polygonOffsetFactor,W.polygonOffsetUnits),W.alphaToCoverage===!0?At(n.SAMPLE_ALPHA_TO_COVERAGE):Jt(n.SAMPLE_ALPHA_TO_COVERAGE)}function In(W){L!==W&&(W?n.frontFace(n.CW):n.frontFace(n.CCW),L=W)}function Je(W){W!==Py?(At(n.CULL_FACE),W!==z&&(W===Xm?n.cullFace(n.BACK):W===Iy?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Jt(n.CULL_FACE),z=W}function Zn(W){W!==G&&(O&&n.lineWidth(W),G=W)}function Ue(W,ct,ot){W?(At(n.POLYGON_OFFSET_FILL),(F!==ct||U!==ot)&&(F=ct,U=ot,o.getReversed()&&(ct=-ct,ot=-ot),n.polygonOffset(ct,ot))):Jt(n.POLYGON_OFFSET_FILL)}function kn(W){W?At(n.SCISSOR_TEST):Jt(n.SCISSOR_TEST)}function Mn(W){W===void 0&&(W=n.TEXTURE0+D-1),J!==W&&(n.activeTexture(W),J=W)}function Ln(W,ct,ot){ot===void 0&&(J===null?ot=n.TEXTURE0+D-1:ot=J);let Pt=nt[ot];Pt===void 0&&(Pt={type:void 0,texture:void 0},nt[ot]=Pt),(Pt.type!==W||Pt.texture!==ct)&&(J!==ot&&(n.activeTexture(ot),J=ot),n.bindTexture(W,ct||Tt[W]),Pt.type=W,Pt.texture=ct)}function $(){let W=nt[J];W!==void 0&&W.type!==void 0&&(n.bindTexture(W.type,null),W.type=void 0,W.texture=void 0)}function Nt(){try{n.compressedTexImage2D(...arguments)}catch(W){ce("WebGLState:",W)}}function se(){try{n.compressedTexImage3D(...arguments)}catch(W){ce("WebGLState:",W)}}function _e(){try{n.texSubImage2D(...arguments)}catch(W){ce("WebGLState:",W)}}function Ct(){try{n.texSubImage3D(...arguments)}catch(W){ce("WebGLState:",W)}}function tn(){try{n.compressedTexSubImage2D(...arguments)}catch(W){ce("WebGLState:",W)}}function Yt(){try{n.compressedTexSubImage3D(...arguments)}catch(W){ce("WebGLState:",W)}}function ne(){try{n.texStorage2D(...arguments)}catch(W){ce("WebGLState:",W)}}function B(){try{n.texStorage3D(...arguments)}catch(W){ce("WebGLState:",W)}}function C(){try{n.texImage2D(...arguments)}catch(W){ce("WebGLState:",W)}}function j(){try{n.texImage3D(...arguments)}catch(W){ce("WebGLState:",W)}}function mt(W){return h[W]!==void 0?h[W]:n.getParameter(W)}function ut(W,ct){h[W]!==ct&&(n.pixelStorei(W,ct),h[W]=ct)}function Mt(W){st.equals(W)===!1&&(n.scissor(W.x,W.y,W.z,W.w),st.copy(W))}function St(W){yt.equals(W)===!1&&(n.viewport(W.x,W.y,W.z,W.w),yt.copy(W))}function rt(W,ct){let ot=c.get(ct);ot===void 0&&(ot=new WeakMap,c.set(ct,ot));let Pt=ot.get(W);Pt===void 0&&(Pt=n.getUniformBlockIndex(ct,W.name),n.uniformBlockBinding(ct,Pt,Pt),ot.set(W,Pt))}function at(W,ct,ot){let wt=c.get(ct).get(W);l[wt]!==ot&&(n.bindBufferBase(n.UNIFORM_BUFFER,wt,ot),l[wt]=ot)}function vt(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},h={},J=null,nt={},d={},l={},f=new WeakMap,p=[],y=null,g=!1,m=null,x=null,w=null,v=null,A=null,S=null,_=null,M=new ee(0,0,0),N=0,R=!1,L=null,z=null,G=null,F=null,U=null,st.set(0,0,n.canvas.width,n.canvas.height),yt.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:At,disable:Jt,bindFramebuffer:xe,drawBuffers:jt,useProgram:Te,setBlending:xn,setMaterial:on,setFlipSided:In,setCullFace:Je,setLineWidth:Zn,setPolygonOffset:Ue,setScissorTest:kn,activeTexture:Mn,bindTexture:Ln,unbindTexture:$,compressedTexImage2D:Nt,compressedTexImage3D:se,texImage2D:C,texImage3D:j,pixelStorei:ut,getParameter:mt,updateUBOMapping:rt,uniformBlockBinding:at,texStorage2D:ne,texStorage3D:B,texSubImage2D:_e,texSubImage3D:Ct,compressedTexSubImage2D:tn,compressedTexSubImage3D:Yt,scissor:Mt,viewport:St,reset:vt}}function CI(n,t,e,i,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Qt,u=new WeakMap,h=new Set,d,f=new WeakMap,p=new Set,y=new FinalizationRegistry(B=>p.delete(B)),g=!1;try{g=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(B,C){return g?new OffscreenCanvas(B,C):Rc("canvas")}function x(B,C,j){let mt=1,ut=ne(B);if((ut.width>j||ut.height>j)&&(mt=j/Math.max(ut.width,ut.height)),mt<1)if(typeof HTMLImageElement<"u"&&B instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&B instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&B instanceof ImageBitmap||typeof VideoFrame<"u"&&B instanceof VideoFrame){let Mt=Math.floor(mt*ut.width),St=Math.floor(mt*ut.height);d===void 0&&(d=m(Mt,St));let rt=C?m(Mt,St):d;return rt.width=Mt,rt.height=St,rt.getContext("2d").drawImage(B,0,0,Mt,St),ie("WebGLRenderer: Texture has been resized from ("+ut.width+"x"+ut.height+") to ("+Mt+"x"+St+")."),rt}else return"data"in B&&ie("WebGLRenderer: Image in DataTexture is too big ("+ut.width+"x"+ut.height+")."),B;return B}function w(B){return B.generateMipmaps}function v(B){n.generateMipmap(B)}function A(B){return B.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:B.isWebGL3DRenderTarget?n.TEXTURE_3D:B.isWebGLArrayRenderTarget||B.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function S(B,C,j,mt,ut,Mt=!1){if(B!==null){if(n[B]!==void 0)return n[B];ie("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+B+"'")}let St;mt&&(St=t.get("EXT_texture_norm16"),St||ie("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let rt=C;if(C===n.RED&&(j===n.FLOAT&&(rt=n.R32F),j===n.HALF_FLOAT&&(rt=n.R16F),j===n.UNSIGNED_BYTE&&(rt=n.R8),j===n.UNSIGNED_SHORT&&St&&(rt=St.R16_EXT),j===n.SHORT&&St&&(rt=St.R16_SNORM_EXT)),C===n.RED_INTEGER&&(j===n.UNSIGNED_BYTE&&(rt=n.R8UI),j===n.UNSIGNED_SHORT&&(rt=n.R16UI),j===n.UNSIGNED_INT&&(rt=n.R32UI),j===n.BYTE&&(rt=n.R8I),j===n.SHORT&&(rt=n.R16I),j===n.INT&&(rt=n.R32I)),C===n.RG&&(j===n.FLOAT&&(rt=n.RG32F),j===n.HALF_FLOAT&&(rt=n.RG16F),j===n.UNSIGNED_BYTE&&(rt=n.RG8),j===n.UNSIGNED_SHORT&&St&&(rt=St.RG16_EXT),j===n.SHORT&&St&&(rt=St.RG16_SNORM_EXT)),C===n.RG_INTEGER&&(j===n.UNSIGNED_BYTE&&(rt=n.RG8UI),j===n.UNSIGNED_SHORT&&(rt=n.RG16UI),j===n.UNSIGNED_INT&&(rt=n.RG32UI),j===n.BYTE&&(rt=n.RG8I),j===n.SHORT&&(rt=n.RG16I),j===n.INT&&(rt=n.RG32I)),C===n.RGB_INTEGER&&(j===n.UNSIGNED_BYTE&&(rt=n.RGB8UI),j===n.UNSIGNED_SHORT&&(rt=n.RGB16UI),j===n.UNSIGNED_INT&&(rt=n.RGB32UI),j===n.BYTE&&(rt=n.RGB8I),j===n.SHORT&&(rt=n.RGB16I),j===n.INT&&(rt=n.RGB32I)),C===n.RGBA_INTEGER&&(j===n.UNSIGNED_BYTE&&(rt=n.RGBA8UI),j===n.UNSIGNED_SHORT&&(rt=n.RGBA16UI),j===n.UNSIGNED_INT&&(rt=n.RGBA32UI),j===n.BYTE&&(rt=n.RGBA8I),j===n.SHORT&&(rt=n.RGBA16I),j===n.INT&&(rt=n.RGBA32I)),C===n.RGB&&(j===n.UNSIGNED_SHORT&&St&&(rt=St.RGB16_EXT),j===n.SHORT&&St&&(rt=St.RGB16_SNORM_EXT),j===n.UNSIGNED_INT_5_9_9_9_REV&&(rt=n.RGB9_E5),j===n.UNSIGNED_INT_10F_11F_11F_REV&&(rt=n.R11F_G11F_B10F)),C===n.RGBA){let at=Mt?Tc:De.getTransfer(ut);j===n.FLOAT&&(rt=n.RGBA32F),j===n.HALF_FLOAT&&(rt=n.RGBA16F),j===n.UNSIGNED_BYTE&&(rt=at===$e?n.SRGB8_ALPHA8:n.RGBA8),j===n.UNSIGNED_SHORT&&St&&(rt=St.RGBA16_EXT),j===n.SHORT&&St&&(rt=St.RGBA16_SNORM_EXT),j===n.UNSIGNED_SHORT_4_4_4_4&&(rt=n.RGBA4),j===n.UNSIGNED_SHORT_5_5_5_1&&(rt=n.RGB5_A1)}return(rt===n.R16F||rt===n.R32F||rt===n.RG16F||rt===n.RG32F||rt===n.RGBA16F||rt===n.RGBA32F)&&t.get("EXT_color_buffer_float"),rt}function _(B,C){let j;return B?C===null||C===Us||C===Ko?j=n.DEPTH24_STENCIL8:C===ps?j=n.DEPTH32F_STENCIL8:C===dl&&(j=n.DEPTH24_STENCIL8,ie("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):C===null||C===Us||C===Ko?j=n.DEPTH_COMPONENT24:C===ps?j=n.DEPTH_COMPONENT32F:C===dl&&(j=n.DEPTH_COMPONENT16),j}function M(B,C){return w(B)===!0||B.isFramebufferTexture&&B.minFilter!==ni&&B.minFilter!==Ri?Math.log2(Math.max(C.width,C.height))+1:B.mipmaps.length>0?B.mipmaps.length:B.isCompressedTexture&&Array.isArray(B.image)?C.mipmaps.length:1}function N(B){let C=new WeakRef(B);i.get(B).__ref=C,p.add(C),y.register(B,C,C)}function R(B){let C=i.get(B).__ref;C!==void 0&&(p.delete(C),y.unregister(C))}function L(B){G(B.target)}function z(B){F(B.target)}function G(B){B.removeEventListener("dispose",L),R(B),D(B),B.isVideoTexture&&u.delete(B),B.isHTMLTexture&&h.delete(B)}function F(B){B.removeEventListener("dispose",z),R(B),Z(B)}function U(){for(let B of p){let C=B.deref();C!==void 0&&(C.isRenderTarget===!0?F(C):G(C))}p.clear(),h.clear()}function D(B){let C=i.get(B);if(C.__webglInit===void 0)return;let j=B.source,mt=f.get(j);if(mt){let ut=mt[C.__cacheKey];ut.usedTimes--,ut.usedTimes===0&&O(B),Object.keys(mt).length===0&&f.delete(j)}i.remove(B)}function O(B){let C=i.get(B);n.deleteTexture(C.__webglTexture);let j=B.source,mt=f.get(j);delete mt[C.__cacheKey],o.memory.textures--}function Z(B){let C=i.get(B);C.__depthDisposeCallback&&C.__depthDisposeCallback();let j=B.depthTexture;if(j&&j.renderTarget===B&&G(j),B.isWebGLCubeRenderTarget)for(let ut=0;ut<6;ut++){if(Array.isArray(C.__webglFramebuffer[ut]))for(let Mt=0;Mt<C.__webglFramebuffer[ut].length;Mt++)n.deleteFramebuffer(C.__webglFramebuffer[ut][Mt]);else n.deleteFramebuffer(C.__webglFramebuffer[ut]);C.__webglDepthbuffer&&n.deleteRenderbuffer(C.__webglDepthbuffer[ut])}else{if(Array.isArray(C.__webglFramebuffer))for(let ut=0;ut<C.__webglFramebuffer.length;ut++)n.deleteFramebuffer(C.__webglFramebuffer[ut]);else n.deleteFramebuffer(C.__webglFramebuffer);if(C.__webglDepthbuffer&&n.deleteRenderbuffer(C.__webglDepthbuffer),C.__webglMultisampledFramebuffer&&n.deleteFramebuffer(C.__webglMultisampledFramebuffer),C.__webglColorRenderbuffer)for(let ut=0;ut<C.__webglColorRenderbuffer.length;ut++)C.__webglColorRenderbuffer[ut]&&n.deleteRenderbuffer(C.__webglColorRenderbuffer[ut]);C.__webglDepthRenderbuffer&&n.deleteRenderbuffer(C.__webglDepthRenderbuffer)}let mt=B.textures;for(let ut=0,Mt=mt.length;ut<Mt;ut++){let St=i.get(mt[ut]);St.__webglTexture&&(n.deleteTexture(St.__webglTexture),o.memory.textures--),i.remove(mt[ut])}i.remove(B)}let X=0;function J(){X=0}function nt(){return X}function dt(B){X=B}function ft(){let B=X;return B>=s.maxTextures&&ie("WebGLTextures: Trying to use "+(B+1)+" texture units while this GPU supports only "+s.maxTextures),X+=1,B}function st(B){let C=[];return C.push(B.wrapS),C.push(B.wrapT),C.push(B.wrapR||0),C.push(B.magFilter),C.push(B.minFilter),C.push(B.anisotropy),C.push(B.internalFormat),C.push(B.format),C.push(B.type),C.push(B.generateMipmaps),C.push(B.mipmapsAutoUpdate),C.push(B.premultiplyAlpha),C.push(B.flipY),C.push(B.unpackAlignment),C.push(B.colorSpace),C.join()}function yt(B,C){let j=i.get(B);if(B.isVideoTexture&&tn(B),B.isRenderTargetTexture===!1&&B.isExternalTexture!==!0&&B.version>0&&j.__version!==B.version){let mt=B.image;if(mt===null)ie("WebGLRenderer: Texture marked for update but no image data found.");else if(mt.complete===!1)ie("WebGLRenderer: Texture marked for update but image is incomplete");else{on(j,B,C);return}}else B.isExternalTexture&&(j.__webglTexture=B.sourceTexture?B.sourceTexture:null);e.bindTexture(n.TEXTURE_2D,j.__webglTexture,n.TEXTURE0+C)}function xt(B,C){let j=i.get(B);if(B.isRenderTargetTexture===!1&&B.version>0&&j.__version!==B.version){on(j,B,C);return}else B.isExternalTexture&&(j.__webglTexture=B.sourceTexture?B.sourceTexture:null);e.bindTexture(n.TEXTURE_2D_ARRAY,j.__webglTexture,n.TEXTURE0+C)}function Tt(B,C){let j=i.get(B);if(B.isRenderTargetTexture===!1&&B.version>0&&j.__version!==B.version){on(j,B,C);return}e.bindTexture(n.TEXTURE_3D,j.__webglTexture,n.TEXTURE0+C)}function At(B,C){let j=i.get(B);if(B.version>0&&j.__version!==B.version){In(j,B,C);return}e.bindTexture(n.TEXTURE_CUBE_MAP,j.__webglTexture,n.TEXTURE0+C)}let Jt={[Wh]:n.REPEAT,[ir]:n.CLAMP_TO_EDGE,[$h]:n.MIRRORED_REPEAT},xe={[ni]:n.NEAREST,[Qy]:n.NEAREST_MIPMAP_NEAREST,[jc]:n.NEAREST_MIPMAP_LINEAR,[Ri]:n.LINEAR,[xd]:n.LINEAR_MIPMAP_NEAREST,[Or]:n.LINEAR_MIPMAP_LINEAR},jt={[iv]:n.NEVER,[yg]:n.ALWAYS,[sv]:n.LESS,[xg]:n.LEQUAL,[rv]:n.EQUAL,[_g]:n.GEQUAL,[ov]:n.GREATER,[av]:n.NOTEQUAL};function Te(B,C){if(C.type===ps&&t.has("OES_texture_float_linear")===!1&&(C.magFilter===Ri||C.magFilter===xd||C.magFilter===jc||C.magFilter===Or||C.minFilter===Ri||C.minFilter===xd||C.minFilter===jc||C.minFilter===Or)&&ie("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(B,n.TEXTURE_WRAP_S,Jt[C.wrapS]),n.texParameteri(B,n.TEXTURE_WRAP_T,Jt[C.wrapT]),(B===n.TEXTURE_3D||B===n.TEXTURE_2D_ARRAY)&&n.texParameteri(B,n.TEXTURE_WRAP_R,Jt[C.wrapR]),n.texParameteri(B,n.TEXTURE_MAG_FILTER,xe[C.magFilter]),n.texParameteri(B,n.TEXTURE_MIN_FILTER,xe[C.minFilter]),C.compareFunction&&(n.texParameteri(B,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(B,n.TEXTURE_COMPARE_FUNC,jt[C.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(C.magFilter===ni||C.minFilter!==jc&&C.minFilter!==Or||C.type===ps&&t.has("OES_texture_float_linear")===!1)return;if(C.anisotropy>1||i.get(C).__currentAnisotropy){let j=t.get("EXT_texture_filter_anisotropic");n.texParameterf(B,j.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(C.anisotropy,s.getMaxAnisotropy())),i.get(C).__currentAnisotropy=C.anisotropy}}}function Me(B,C){let j=!1;B.__webglInit===void 0&&(B.__webglInit=!0,C.addEventListener("dispose",L),N(C));let mt=C.source,ut=f.get(mt);ut===void 0&&(ut={},f.set(mt,ut));let Mt=st(C);if(Mt!==B.__cacheKey){ut[Mt]===void 0&&(ut[Mt]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,j=!0),ut[Mt].usedTimes++;let St=ut[B.__cacheKey];St!==void 0&&(ut[B.__cacheKey].usedTimes--,St.usedTimes===0&&O(C)),B.__cacheKey=Mt,B.__webglTexture=ut[Mt].texture}return j}function me(B,C,j){return Math.floor(Math.floor(B/j)/C)}function xn(B,C,j,mt){let Mt=B.updateRanges;if(Mt.length===0)e.texSubImage2D(n.TEXTURE_2D,0,0,0,C.width,C.height,j,mt,C.data);else{Mt.sort((W,ct)=>W.start-ct.start);let St=0;for(let W=1;W<Mt.length;W++){let ct=Mt[St],ot=Mt[W],Pt=ct.start+ct.count,wt=me(ot.start,C.width,4),Rt=me(ct.start,C.width,4);ot.start<=Pt+1&&wt===Rt&&me(ot.start+ot.count-1,C.width,4)===wt?ct.count=Math.max(ct.count,ot.start+ot.count-ct.start):(++St,Mt[St]=ot)}Mt.length=St+1;let rt=e.getParameter(n.UNPACK_ROW_LENGTH),at=e.getParameter(n.UNPACK_SKIP_PIXELS),vt=e.getParameter(n.UNPACK_SKIP_ROWS);e.pixelStorei(n.UNPACK_ROW_LENGTH,C.width);for(let W=0,ct=Mt.length;W<ct;W++){let ot=Mt[W],Pt=Math.floor(ot.start/4),wt=Math.ceil(ot.count/4),Rt=Pt%C.width,Zt=Math.floor(Pt/C.width),ae=wt,pt=1;e.pixelStorei(n.UNPACK_SKIP_PIXELS,Rt),e.pixelStorei(n.UNPACK_SKIP_ROWS,Zt),e.texSubImage2D(n.TEXTURE_2D,0,Rt,Zt,ae,pt,j,mt,C.data)}B.clearUpdateRanges(),e.pixelStorei(n.UNPACK_ROW_LENGTH,rt),e.pixelStorei(n.UNPACK_SKIP_PIXELS,at),e.pixelStorei(n.UNPACK_SKIP_ROWS,vt)}}function on(B,C,j){let mt=n.TEXTURE_2D;(C.isDataArrayTexture||C.isCompressedArrayTexture)&&(mt=n.TEXTURE_2D_ARRAY),C.isData3DTexture&&(mt=n.TEXTURE_3D);let ut=Me(B,C),Mt=C.source;e.bindTexture(mt,B.__webglTexture,n.TEXTURE0+j);let St=i.get(Mt);if(Mt.version!==St.__version||ut===!0){if(e.activeTexture(n.TEXTURE0+j),(typeof ImageBitmap<"u"&&C.image instanceof ImageBitmap)===!1){let pt=De.getPrimaries(De.workingColorSpace),$t=C.colorSpace===Br?null:De.getPrimaries(C.colorSpace),le=C.colorSpace===Br||pt===$t?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,C.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,C.premultiplyAlpha),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,le)}e.pixelStorei(n.UNPACK_ALIGNMENT,C.unpackAlignment);let at=x(C.image,!1,s.maxTextureSize);at=Yt(C,at);let vt=r.convert(C.format,C.colorSpace),W=r.convert(C.type),ct=S(C.internalFormat,vt,W,C.normalized,C.colorSpace,C.isVideoTexture);Te(mt,C);let ot,Pt=C.mipmaps,wt=C.isVideoTexture!==!0,Rt=St.__version===void 0||ut===!0,Zt=Mt.dataReady,ae=M(C,at);if(C.isDepthTexture)ct=_(C.format===Fr,C.type),Rt&&(wt?e.texStorage2D(n.TEXTURE_2D,1,ct,at.width,at.height):e.texImage2D(n.TEXTURE_2D,0,ct,at.width,at.height,0,vt,W,null));else if(C.isDataTexture)if(Pt.length>0){wt&&Rt&&e.texStorage2D(n.TEXTURE_2D,ae,ct,Pt[0].width,Pt[0].height);for(let pt=0,$t=Pt.length;pt<$t;pt++)ot=Pt[pt],wt?Zt&&e.texSubImage2D(n.TEXTURE_2D,pt,0,0,ot.width,ot.height,vt,W,ot.data):e.texImage2D(n.TEXTURE_2D,pt,ct,ot.width,ot.height,0,vt,W,ot.data);C.generateMipmaps=!1}else wt?(Rt&&e.texStorage2D(n.TEXTURE_2D,ae,ct,at.width,at.height),Zt&&xn(C,at,vt,W)):e.texImage2D(n.TEXTURE_2D,0,ct,at.width,at.height,0,vt,W,at.data);else if(C.isCompressedTexture)if(C.isCompressedArrayTexture){wt&&Rt&&e.texStorage3D(n.TEXTURE_2D_ARRAY,ae,ct,Pt[0].width,Pt[0].height,at.depth);for(let pt=0,$t=Pt.length;pt<$t;pt++)if(ot=Pt[pt],C.format!==Fs)if(vt!==null)if(wt){if(Zt)if(C.layerUpdates.size>0){let le=Cg(ot.width,ot.height,C.format,C.type);for(let Dt of C.layerUpdates){let ve=ot.data.subarray(Dt*le/ot.data.BYTES_PER_ELEMENT,(Dt+1)*le/ot.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,pt,0,0,Dt,ot.width,ot.height,1,vt,ve)}}else e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,pt,0,0,0,ot.width,ot.height,at.depth,vt,ot.data)}else e.compressedTexImage3D(n.TEXTURE_2D_ARRAY,pt,ct,ot.width,ot.height,at.depth,0,ot.data,0,0);else ie("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else wt?Zt&&e.texSubImage3D(n.TEXTURE_2D_ARRAY,pt,0,0,0,ot.width,ot.height,at.depth,vt,W,ot.data):e.texImage3D(n.TEXTURE_2D_ARRAY,pt,ct,ot.width,ot.height,at.depth,0,vt,W,ot.data);C.layerUpdates.size>0&&C.clearLayerUpdates()}else{wt&&Rt&&e.texStorage2D(n.TEXTURE_2D,ae,ct,Pt[0].width,Pt[0].height);for(let pt=0,$t=Pt.length;pt<$t;pt++)ot=Pt[pt],C.format!==Fs?vt!==null?wt?Zt&&e.compressedTexSubImage2D(n.TEXTURE_2D,pt,0,0,ot.width,ot.height,vt,ot.data):e.compressedTexImage2D(n.TEXTURE_2D,pt,ct,ot.width,ot.height,0,ot.data):ie("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):wt?Zt&&e.texSubImage2D(n.TEXTURE_2D,pt,0,0,ot.width,ot.height,vt,W,ot.data):e.texImage2D(n.TEXTURE_2D,pt,ct,ot.width,ot.height,0,vt,W,ot.data)}else if(C.isDataArrayTexture)if(wt){if(Rt&&e.texStorage3D(n.TEXTURE_2D_ARRAY,ae,ct,at.width,at.height,at.depth),Zt)if(C.layerUpdates.size>0){let pt=Cg(at.width,at.height,C.format,C.type);for(let $t of C.layerUpdates){let le=at.data.subarray($t*pt/at.data.BYTES_PER_ELEMENT,($t+1)*pt/at.data.BYTES_PER_ELEMENT);e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,$t,at.width,at.height,1,vt,W,le)}C.clearLayerUpdates()}else e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,at.width,at.height,at.depth,vt,W,at.data)}else e.texImage3D(n.TEXTURE_2D_ARRAY,0,ct,at.width,at.height,at.depth,0,vt,W,at.data);else if(C.isData3DTexture)wt?(Rt&&e.texStorage3D(n.TEXTURE_3D,ae,ct,at.width,at.height,at.depth),Zt&&e.texSubImage3D(n.TEXTURE_3D,0,0,0,0,at.width,at.height,at.depth,vt,W,at.data)):e.texImage3D(n.TEXTURE_3D,0,ct,at.width,at.height,at.depth,0,vt,W,at.data);else if(C.isFramebufferTexture){if(Rt)if(wt)e.texStorage2D(n.TEXTURE_2D,ae,ct,at.width,at.height);else{let pt=at.width,$t=at.height;for(let le=0;le<ae;le++)e.texImage2D(n.TEXTURE_2D,le,ct,pt,$t,0,vt,W,null),pt>>=1,$t>>=1}}else if(C.isHTMLTexture){if("texElementImage2D"in n){let pt=n.canvas;if(pt.hasAttribute("layoutsubtree")||pt.setAttribute("layoutsubtree","true"),at.parentNode!==pt){pt.appendChild(at),h.add(C),pt.onpaint=$t=>{let le=$t.changedElements;for(let Dt of h)le.includes(Dt.image)&&(Dt.needsUpdate=!0)},pt.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,at);else{let le=n.RGBA,Dt=n.RGBA,ve=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,le,Dt,ve,at)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Pt.length>0){if(wt&&Rt){let pt=ne(Pt[0]);e.texStorage2D(n.TEXTURE_2D,ae,ct,pt.width,pt.height)}for(let pt=0,$t=Pt.length;pt<$t;pt++)ot=Pt[pt],wt?Zt&&e.texSubImage2D(n.TEXTURE_2D,pt,0,0,vt,W,ot):e.texImage2D(n.TEXTURE_2D,pt,ct,vt,W,ot);C.generateMipmaps=!1}else if(wt){if(Rt){let pt=ne(at);e.texStorage2D(n.TEXTURE_2D,ae,ct,pt.width,pt.height)}Zt&&e.texSubImage2D(n.TEXTURE_2D,0,0,0,vt,W,at)}else e.texImage2D(n.TEXTURE_2D,0,ct,vt,W,at);w(C)&&C.mipmapsAutoUpdate===!0&&v(mt),St.__version=Mt.version,C.onUpdate&&C.onUpdate(C)}B.__version=C.version}function In(B,C,j){if(C.image.length!==6)return;let mt=Me(B,C),ut=C.source;e.bindTexture(n.TEXTURE_CUBE_MAP,B.__webglTexture,n.TEXTURE0+j);let Mt=i.get(ut);if(ut.version!==Mt.__version||mt===!0){e.activeTexture(n.TEXTURE0+j);let St=De.getPrimaries(De.workingColorSpace),rt=C.colorSpace===Br?null:De.getPrimaries(C.colorSpace),at=C.colorSpace===Br||St===rt?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,C.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,C.premultiplyAlpha),e.pixelStorei(n.UNPACK_ALIGNMENT,C.unpackAlignment),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,at);let vt=C.isCompressedTexture||C.image[0].isCompressedTexture,W=C.image[0]&&C.image[0].isDataTexture,ct=[];for(let Dt=0;Dt<6;Dt++)!vt&&!W?ct[Dt]=x(C.image[Dt],!0,s.maxCubemapSize):ct[Dt]=W?C.image[Dt].image:C.image[Dt],ct[Dt]=Yt(C,ct[Dt]);let ot=ct[0],Pt=r.convert(C.format,C.colorSpace),wt=r.convert(C.type),Rt=S(C.internalFormat,Pt,wt,C.normalized,C.colorSpace),Zt=C.isVideoTexture!==!0,ae=Mt.__version===void 0||mt===!0,pt=ut.dataReady,$t=M(C,ot);Te(n.TEXTURE_CUBE_MAP,C);let le;if(C.isDepthTexture){if(Rt=_(C.format===Fr,C.type),ae)if(Zt)e.texStorage2D(n.TEXTURE_CUBE_MAP,1,Rt,ot.width,ot.height);else for(let Dt=0;Dt<6;Dt++)e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,0,Rt,ot.width,ot.height,0,Pt,wt,null)}else if(vt){Zt&&ae&&e.texStorage2D(n.TEXTURE_CUBE_MAP,$t,Rt,ot.width,ot.height);for(let Dt=0;Dt<6;Dt++){le=ct[Dt].mipmaps;for(let ve=0;ve<le.length;ve++){let an=le[ve];C.format!==Fs?Pt!==null?Zt?pt&&e.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,ve,0,0,an.width,an.height,Pt,an.data):e.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,ve,Rt,an.width,an.height,0,an.data):ie("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Zt?pt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,ve,0,0,an.width,an.height,Pt,wt,an.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,ve,Rt,an.width,an.height,0,Pt,wt,an.data)}}}else{if(le=C.mipmaps,Zt&&ae){le.length>0&&$t++;let Dt=ne(ct[0]);e.texStorage2D(n.TEXTURE_CUBE_MAP,$t,Rt,Dt.width,Dt.height)}for(let Dt=0;Dt<6;Dt++)if(W){Zt?pt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,0,0,0,ct[Dt].width,ct[Dt].height,Pt,wt,ct[Dt].data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,0,Rt,ct[Dt].width,ct[Dt].height,0,Pt,wt,ct[Dt].data);for(let ve=0;ve<le.length;ve++){let yi=le[ve].image[Dt].image;Zt?pt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,ve+1,0,0,yi.width,yi.height,Pt,wt,yi.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,ve+1,Rt,yi.width,yi.height,0,Pt,wt,yi.data)}}else{Zt?pt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,0,0,0,Pt,wt,ct[Dt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,0,Rt,Pt,wt,ct[Dt]);for(let ve=0;ve<le.length;ve++){let an=le[ve];Zt?pt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,ve+1,0,0,Pt,wt,an.image[Dt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,ve+1,Rt,Pt,wt,an.image[Dt])}}}w(C)&&C.mipmapsAutoUpdate===!0&&v(n.TEXTURE_CUBE_MAP),Mt.__version=ut.version,C.onUpdate&&C.onUpdate(C)}B.__version=C.version}function Je(B,C,j,mt,ut,Mt){let St=r.convert(j.format,j.colorSpace),rt=r.convert(j.type),at=S(j.internalFormat,St,rt,j.normalized,j.colorSpace),vt=i.get(C),W=i.get(j);if(W.__renderTarget=C,!vt.__hasExternalTextures){let ct=Math.max(1,C.width>>Mt),ot=Math.max(1,C.height>>Mt);ut===n.TEXTURE_3D||ut===n.TEXTURE_2D_ARRAY?e.texImage3D(ut,Mt,at,ct,ot,C.depth,0,St,rt,null):e.texImage2D(ut,Mt,at,ct,ot,0,St,rt,null)}e.bindFramebuffer(n.FRAMEBUFFER,B),Ct(C)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,mt,ut,W.__webglTexture,0,_e(C)):(ut===n.TEXTURE_2D||ut>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&ut<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,mt,ut,W.__webglTexture,Mt),e.bindFramebuffer(n.FRAMEBUFFER,null)}function Zn(B,C,j){if(n.bindRenderbuffer(n.RENDERBUFFER,B),C.depthBuffer){let mt=C.depthTexture,ut=mt&&mt.isDepthTexture?mt.type:null,Mt=_(C.stencilBuffer,ut),St=C.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;Ct(C)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,_e(C),Mt,C.width,C.height):j?n.renderbufferStorageMultisample(n.RENDERBUFFER,_e(C),Mt,C.width,C.height):n.renderbufferStorage(n.RENDERBUFFER,Mt,C.width,C.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,St,n.RENDERBUFFER,B)}else{let mt=C.textures;for(let ut=0;ut<mt.length;ut++){let Mt=mt[ut],St=r.convert(Mt.format,Mt.colorSpace),rt=r.convert(Mt.type),at=S(Mt.internalFormat,St,rt,Mt.normalized,Mt.colorSpace);Ct(C)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,_e(C),at,C.width,C.height):j?n.renderbufferStorageMultisample(n.RENDERBUFFER,_e(C),at,C.width,C.height):n.renderbufferStorage(n.RENDERBUFFER,at,C.width,C.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function Ue(B,C,j){let mt=C.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(n.FRAMEBUFFER,B),!(C.depthTexture&&C.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ut=i.get(C.depthTexture);ut.__renderTarget=C;let Mt=mt?C.depthTexture.image[0]:C.depthTexture.image;(!ut.__webglTexture||Mt.width!==C.width||Mt.height!==C.height)&&(Mt.width=C.width,Mt.height=C.height,C.depthTexture.needsUpdate=!0),mt?At(C.depthTexture,0):yt(C.depthTexture,0);let St=ut.__webglTexture,rt=_e(C),at=mt?n.TEXTURE_CUBE_MAP_POSITIVE_X+j:n.TEXTURE_2D,vt=C.depthTexture.format===Fr?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(C.depthTexture.format===Ir)Ct(C)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,vt,at,St,0,rt):n.framebufferTexture2D(n.FRAMEBUFFER,vt,at,St,0);else if(C.depthTexture.format===Fr)Ct(C)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,vt,at,St,0,rt):n.framebufferTexture2D(n.FRAMEBUFFER,vt,at,St,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function kn(B){let C=i.get(B),j=B.isWebGLCubeRenderTarget===!0;if(C.__boundDepthTexture!==B.depthTexture){let mt=B.depthTexture;if(C.__depthDisposeCallback&&C.__depthDisposeCallback(),mt){let ut=()=>{delete C.__boundDepthTexture,delete C.__depthDisposeCallback,mt.removeEventListener("dispose",ut)};mt.addEventListener("dispose",ut),C.__depthDisposeCallback=ut}C.__boundDepthTexture=mt}if(B.depthTexture&&!C.__autoAllocateDepthBuffer)if(j)for(let mt=0;mt<6;mt++)Ue(C.__webglFramebuffer[mt],B,mt);else B.texture.mipmaps.length>0?Ue(C.__webglFramebuffer[0],B,0):Ue(C.__webglFramebuffer,B,0);else if(j){C.__webglDepthbuffer=[];for(let mt=0;mt<6;mt++)if(e.bindFramebuffer(n.FRAMEBUFFER,C.__webglFramebuffer[mt]),C.__webglDepthbuffer[mt]===void 0)C.__webglDepthbuffer[mt]=n.createRenderbuffer(),Zn(C.__webglDepthbuffer[mt],B,!1);else{let ut=B.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,Mt=C.__webglDepthbuffer[mt];n.bindRenderbuffer(n.RENDERBUFFER,Mt),n.framebufferRenderbuffer(n.FRAMEBUFFER,ut,n.RENDERBUFFER,Mt)}}else if(B.texture.mipmaps.length>0?e.bindFramebuffer(n.FRAMEBUFFER,C.__webglFramebuffer[0]):e.bindFramebuffer(n.FRAMEBUFFER,C.__webglFramebuffer),C.__webglDepthbuffer===void 0)C.__webglDepthbuffer=n.createRenderbuffer(),Zn(C.__webglDepthbuffer,B,!1);else{let ut=B.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,Mt=C.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,Mt),n.framebufferRenderbuffer(n.FRAMEBUFFER,ut,n.RENDERBUFFER,Mt)}e.bindFramebuffer(n.FRAMEBUFFER,null)}function Mn(B,C,j){let mt=i.get(B);C!==void 0&&Je(mt.__webglFramebuffer,B,B.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),j!==void 0&&kn(B)}function Ln(B){let C=B.texture,j=i.get(B),mt=i.get(C);B.addEventListener("dispose",z),N(B);let ut=B.textures,Mt=B.isWebGLCubeRenderTarget===!0,St=ut.length>1;if(St||(mt.__webglTexture===void 0&&(mt.__webglTexture=n.createTexture()),mt.__version=C.version,o.memory.textures++),Mt){j.__webglFramebuffer=[];for(let rt=0;rt<6;rt++)if(C.mipmaps.length>0){j.__webglFramebuffer[rt]=[];for(let at=0;at<C.mipmaps.length;at++)j.__webglFramebuffer[rt][at]=n.createFramebuffer()}else j.__webglFramebuffer[rt]=n.createFramebuffer()}else{if(C.mipmaps.length>0){j.__webglFramebuffer=[];for(let rt=0;rt<C.mipmaps.length;rt++)j.__webglFramebuffer[rt]=n.createFramebuffer()}else j.__webglFramebuffer=n.createFramebuffer();if(St)for(let rt=0,at=ut.length;rt<at;rt++){let vt=i.get(ut[rt]);vt.__webglTexture===void 0&&(vt.__webglTexture=n.createTexture(),o.memory.textures++)}if(B.samples>0&&Ct(B)===!1){j.__webglMultisampledFramebuffer=n.createFramebuffer(),j.__webglColorRenderbuffer=[],e.bindFramebuffer(n.FRAMEBUFFER,j.__webglMultisampledFramebuffer);for(let rt=0;rt<ut.length;rt++){let at=ut[rt];j.__webglColorRenderbuffer[rt]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,j.__webglColorRenderbuffer[rt]);let vt=r.convert(at.format,at.colorSpace),W=r.convert(at.type),ct=S(at.internalFormat,vt,W,at.normalized,at.colorSpace,B.isXRRenderTarget===!0),ot=_e(B);n.renderbufferStorageMultisample(n.RENDERBUFFER,ot,ct,B.width,B.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+rt,n.RENDERBUFFER,j.__webglColorRenderbuffer[rt])}n.bindRenderbuffer(n.RENDERBUFFER,null),B.depthBuffer&&(j.__webglDepthRenderbuffer=n.createRenderbuffer(),Zn(j.__webglDepthRenderbuffer,B,!0)),e.bindFramebuffer(n.FRAMEBUFFER,null)}}if(Mt){e.bindTexture(n.TEXTURE_CUBE_MAP,mt.__webglTexture),Te(n.TEXTURE_CUBE_MAP,C);for(let rt=0;rt<6;rt++)if(C.mipmaps.length>0)for(let at=0;at<C.mipmaps.length;at++)Je(j.__webglFramebuffer[rt][at],B,C,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,at);else Je(j.__webglFramebuffer[rt],B,C,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,0);w(C)?v(n.TEXTURE_CUBE_MAP):C.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,C.mipmaps.length-1),e.unbindTexture()}else if(St){for(let rt=0,at=ut.length;rt<at;rt++){let vt=ut[rt],W=i.get(vt),ct=n.TEXTURE_2D;(B.isWebGL3DRenderTarget||B.isWebGLArrayRenderTarget)&&(ct=B.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(ct,W.__webglTexture),Te(ct,vt),Je(j.__webglFramebuffer,B,vt,n.COLOR_ATTACHMENT0+rt,ct,0),w(vt)&&v(ct)}e.unbindTexture()}else{let rt=n.TEXTURE_2D;if((B.isWebGL3DRenderTarget||B.isWebGLArrayRenderTarget)&&(rt=B.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(rt,mt.__webglTexture),Te(rt,C),C.mipmaps.length>0)for(let at=0;at<C.mipmaps.length;at++)Je(j.__webglFramebuffer[at],B,C,n.COLOR_ATTACHMENT0,rt,at);else Je(j.__webglFramebuffer,B,C,n.COLOR_ATTACHMENT0,rt,0);w(C)?v(rt):C.mipmaps.length>0&&n.texParameteri(rt,n.TEXTURE_MAX_LEVEL,C.mipmaps.length-1),e.unbindTexture()}B.depthBuffer&&kn(B)}function $(B){let C=B.textures;for(let j=0,mt=C.length;j<mt;j++){let ut=C[j];if(w(ut)&&ut.mipmapsAutoUpdate===!0){let Mt=A(B),St=i.get(ut).__webglTexture;e.bindTexture(Mt,St),v(Mt),e.unbindTexture()}}}let Nt=[];function se(B){if(B.samples>0){if(Ct(B)===!1){let C=B.textures,j=B.width,mt=B.height,ut=n.COLOR_BUFFER_BIT,Mt=B.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,St=i.get(B),rt=C.length>1;if(rt)for(let vt=0;vt<C.length;vt++)e.bindFramebuffer(n.FRAMEBUFFER,St.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+vt,n.RENDERBUFFER,null),e.bindFramebuffer(n.FRAMEBUFFER,St.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+vt,n.TEXTURE_2D,null,0);e.bindFramebuffer(n.READ_FRAMEBUFFER,St.__webglMultisampledFramebuffer),B.texture.mipmaps.length>0?e.bindFramebuffer(n.DRAW_FRAMEBUFFER,St.__webglFramebuffer[0]):e.bindFramebuffer(n.DRAW_FRAMEBUFFER,St.__webglFramebuffer);for(let vt=0;vt<C.length;vt++){if(B.resolveDepthBuffer&&(B.depthBuffer&&(ut|=n.DEPTH_BUFFER_BIT),B.stencilBuffer&&B.resolveStencilBuffer&&(ut|=n.STENCIL_BUFFER_BIT)),rt){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,St.__webglColorRenderbuffer[vt]);let W=i.get(C[vt]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,W,0)}n.blitFramebuffer(0,0,j,mt,0,0,j,mt,ut,n.NEAREST),l===!0&&(Nt.length=0,Nt.push(n.COLOR_ATTACHMENT0+vt),B.depthBuffer&&B.storeMultisampledDepthBuffer===!1&&Nt.push(Mt),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Nt))}if(e.bindFramebuffer(n.READ_FRAMEBUFFER,null),e.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),rt)for(let vt=0;vt<C.length;vt++){e.bindFramebuffer(n.FRAMEBUFFER,St.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+vt,n.RENDERBUFFER,St.__webglColorRenderbuffer[vt]);let W=i.get(C[vt]).__webglTexture;e.bindFramebuffer(n.FRAMEBUFFER,St.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+vt,n.TEXTURE_2D,W,0)}e.bindFramebuffer(n.DRAW_FRAMEBUFFER,St.__webglMultisampledFramebuffer)}else if(B.depthBuffer&&B.storeMultisampledDepthBuffer===!1&&l){let C=B.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[C])}}}function _e(B){return Math.min(s.maxSamples,B.samples)}function Ct(B){let C=i.get(B);return B.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&C.__useRenderToTexture!==!1}function tn(B){let C=o.render.frame;u.get(B)!==C&&(u.set(B,C),B.update())}function Yt(B,C){let j=B.colorSpace,mt=B.format,ut=B.type;return B.isCompressedTexture===!0||B.isVideoTexture===!0||j!==Ec&&j!==Br&&(De.getTransfer(j)===$e?(mt!==Fs||ut!==is)&&ie("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):ce("WebGLTextures: Unsupported texture color space:",j)),C}function ne(B){return typeof HTMLImageElement<"u"&&B instanceof HTMLImageElement?(c.width=B.naturalWidth||B.width,c.height=B.naturalHeight||B.height):typeof VideoFrame<"u"&&B instanceof VideoFrame?(c.width=B.displayWidth,c.height=B.displayHeight):(c.width=B.width,c.height=B.height),c}this.allocateTextureUnit=ft,this.resetTextureUnits=J,this.getTextureUnits=nt,this.setTextureUnits=dt,this.setTexture2D=yt,this.setTexture2DArray=xt,this.setTexture3D=Tt,this.setTextureCube=At,this.rebindTextures=Mn,this.setupRenderTarget=Ln,this.updateRenderTargetMipmap=$,this.updateMultisampleRenderTarget=se,this.setupDepthRenderbuffer=kn,this.setupFrameBufferTexture=Je,this.useMultisampledRTT=Ct,this.dispose=U}function PI(n,t){function e(i,s=Br){let r,o=De.getTransfer(s);if(i===is)return n.UNSIGNED_BYTE;if(i===yd)return n.UNSIGNED_SHORT_4_4_4_4;if(i===vd)return n.UNSIGNED_SHORT_5_5_5_1;if(i===ug)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===hg)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===lg)return n.BYTE;if(i===cg)return n.SHORT;if(i===dl)return n.UNSIGNED_SHORT;if(i===_d)return n.INT;if(i===Us)return n.UNSIGNED_INT;if(i===ps)return n.FLOAT;if(i===Os)return n.HALF_FLOAT;if(i===dg)return n.ALPHA;if(i===fg)return n.RGB;if(i===Fs)return n.RGBA;if(i===Ir)return n.DEPTH_COMPONENT;if(i===Fr)return n.DEPTH_STENCIL;if(i===bd)return n.RED;if(i===wd)return n.RED_INTEGER;if(i===xo)return n.RG;if(i===Md)return n.RG_INTEGER;if(i===Sd)return n.RGBA_INTEGER;if(i===Zc||i===Jc||i===Kc||i===Qc)if(o===$e)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===Zc)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===Jc)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Kc)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===Qc)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===Zc)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===Jc)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Kc)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===Qc)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===Ed||i===Td||i===Ad||i===Rd)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===Ed)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===Td)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===Ad)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===Rd)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===Cd||i===Pd||i===Id||i===Ld||i===Dd||i===tu||i===Nd)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(i===Cd||i===Pd)return o===$e?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===Id)return o===$e?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===Ld)return r.COMPRESSED_R11_EAC;if(i===Dd)return r.COMPRESSED_SIGNED_R11_EAC;if(i===tu)return r.COMPRESSED_RG11_EAC;if(i===Nd)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===Ud||i===Od||i===Fd||i===Bd||i===kd||i===zd||i===Hd||i===Gd||i===Vd||i===Wd||i===$d||i===qd||i===Xd||i===Yd)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(i===Ud)return o===$e?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Od)return o===$e?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Fd)return o===$e?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===Bd)return o===$e?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===kd)return o===$e?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===zd)return o===$e?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Hd)return o===$e?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Gd)return o===$e?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Vd)return o===$e?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===Wd)return o===$e?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===$d)return o===$e?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===qd)return o===$e?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===Xd)return o===$e?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Yd)return o===$e?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===jd||i===Zd||i===Jd)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(i===jd)return o===$e?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Zd)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Jd)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Kd||i===Qd||i===eu||i===tf)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(i===Kd)return r.COMPRESSED_RED_RGTC1_EXT;if(i===Qd)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===eu)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===tf)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Ko?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:e}}var II=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,LI=`
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

}`,Bg=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let i=new kc(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=i}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,i=new pi({vertexShader:II,fragmentShader:LI,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new Ge(new Vc(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},kg=class extends Ds{constructor(t,e){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,d=null,f=null,p=null,y=typeof XRWebGLBinding<"u",g=new Bg,m={},x=e.getContextAttributes(),w=null,v=null,A=[],S=[],_=new Qt,M=null,N=null,R=new Ai;R.viewport=new bn;let L=new Ai;L.viewport=new bn;let z=[R,L],G=new pd,F=null,U=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(st){let yt=A[st];return yt===void 0&&(yt=new nl,A[st]=yt),yt.getTargetRaySpace()},this.getControllerGrip=function(st){let yt=A[st];return yt===void 0&&(yt=new nl,A[st]=yt),yt.getGripSpace()},this.getHand=function(st){let yt=A[st];return yt===void 0&&(yt=new nl,A[st]=yt),yt.getHandSpace()};function D(st){let yt=S.indexOf(st.inputSource);if(yt===-1)return;let xt=A[yt];xt!==void 0&&(xt.update(st.inputSource,st.frame,c||o),xt.dispatchEvent({type:st.type,data:st.inputSource}))}function O(){s.removeEventListener("select",D),s.removeEventListener("selectstart",D),s.removeEventListener("selectend",D),s.removeEventListener("squeeze",D),s.removeEventListener("squeezestart",D),s.removeEventListener("squeezeend",D),s.removeEventListener("end",O),s.removeEventListener("inputsourceschange",Z);for(let st=0;st<A.length;st++){let yt=S[st];yt!==null&&(S[st]=null,A[st].disconnect(yt))}F=null,U=null,g.reset();for(let st in m)delete m[st];if(t.setRenderTarget(w),f=null,d=null,h=null,s=null,v=null,ft.stop(),i.isPresenting=!1,t.setPixelRatio(M),t.setSize(_.width,_.height,!1),N!==null){let st=N.camera;st.fov=N.fov,st.zoom=N.zoom,st.updateProjectionMatrix(),N=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(st){r=st,i.isPresenting===!0&&ie("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(st){a=st,i.isPresenting===!0&&ie("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(st){c=st},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return h===null&&y&&(h=new XRWebGLBinding(s,e)),h},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(st){if(s=st,s!==null){if(w=t.getRenderTarget(),s.addEventListener("select",D),s.addEventListener("selectstart",D),s.addEventListener("selectend",D),s.addEventListener("squeeze",D),s.addEventListener("squeezestart",D),s.addEventListener("squeezeend",D),s.addEventListener("end",O),s.addEventListener("inputsourceschange",Z),x.xrCompatible!==!0&&await e.makeXRCompatible(),M=t.getPixelRatio(),t.getSize(_),y&&"createProjectionLayer"in XRWebGLBinding.prototype){let xt=null,Tt=null,At=null;x.depth&&(At=x.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,xt=x.stencil?Fr:Ir,Tt=x.stencil?Ko:Us);let Jt={colorFormat:e.RGBA8,depthFormat:At,scaleFactor:r};h=this.getBinding(),d=h.createProjectionLayer(Jt),s.updateRenderState({layers:[d]}),t.setPixelRatio(1),t.setSize(d.textureWidth,d.textureHeight,!1),v=new ts(d.textureWidth,d.textureHeight,{format:Fs,type:is,depthTexture:new Ur(d.textureWidth,d.textureHeight,Tt,void 0,void 0,void 0,void 0,void 0,void 0,xt),stencilBuffer:x.stencil,colorSpace:t.outputColorSpace,samples:x.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let xt={antialias:x.antialias,alpha:!0,depth:x.depth,stencil:x.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,e,xt),s.updateRenderState({baseLayer:f}),t.setPixelRatio(1),t.setSize(f.framebufferWidth,f.framebufferHeight,!1),v=new ts(f.framebufferWidth,f.framebufferHeight,{format:Fs,type:is,colorSpace:t.outputColorSpace,stencilBuffer:x.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}v.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),ft.setContext(s),ft.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function Z(st){for(let yt=0;yt<st.removed.length;yt++){let xt=st.removed[yt],Tt=S.indexOf(xt);Tt>=0&&(S[Tt]=null,A[Tt].disconnect(xt))}for(let yt=0;yt<st.added.length;yt++){let xt=st.added[yt],Tt=S.indexOf(xt);if(Tt===-1){for(let Jt=0;Jt<A.length;Jt++)if(Jt>=S.length){S.push(xt),Tt=Jt;break}else if(S[Jt]===null){S[Jt]=xt,Tt=Jt;break}if(Tt===-1)break}let At=A[Tt];At&&At.connect(xt)}}function X(st,yt){yt===null?st.matrixWorld.copy(st.matrix):st.matrixWorld.multiplyMatrices(yt.matrixWorld,st.matrix),st.matrixWorldInverse.copy(st.matrixWorld).invert()}this.updateCamera=function(st){if(s===null)return;let yt=st.near,xt=st.far;g.texture!==null&&(g.depthNear>0&&(yt=g.depthNear),g.depthFar>0&&(xt=g.depthFar)),G.near=L.near=R.near=yt,G.far=L.far=R.far=xt,(F!==G.near||U!==G.far)&&(s.updateRenderState({depthNear:G.near,depthFar:G.far}),F=G.near,U=G.far),G.layers.mask=st.layers.mask|6,R.layers.mask=G.layers.mask&-5,L.layers.mask=G.layers.mask&-3;let Tt=st.parent,At=G.cameras;X(G,Tt);for(let Jt=0;Jt<At.length;Jt++)X(At[Jt],Tt);G.projectionMatrix.copy(R.projectionMatrix),G.projectionMatrixInverse.copy(R.projectionMatrixInverse),N===null&&st.isPerspectiveCamera&&(N={camera:st,fov:st.fov,zoom:st.zoom}),J(st,G,Tt)};function J(st,yt,xt){xt===null?st.matrix.copy(yt.matrixWorld):(st.matrix.copy(xt.matrixWorld),st.matrix.invert(),st.matrix.multiply(yt.matrixWorld)),st.matrix.decompose(st.position,st.quaternion,st.scale),st.updateMatrixWorld(!0),st.projectionMatrix.copy(yt.projectionMatrix),st.projectionMatrixInverse.copy(yt.projectionMatrixInverse),st.isPerspectiveCamera&&(st.fov=Qa*2*Math.atan(1/st.projectionMatrix.elements[5]),st.zoom=1)}this.getCamera=function(){return G},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function(st){l=st,d!==null&&(d.fixedFoveation=st),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=st)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(G)},this.getCameraTexture=function(st){return m[st]};let nt=null;function dt(st,yt){if(u=yt.getViewerPose(c||o),p=yt,u!==null){let xt=u.views;f!==null&&(t.setRenderTargetFramebuffer(v,f.framebuffer),t.setRenderTarget(v));let Tt=!1;xt.length!==G.cameras.length&&(G.cameras.length=0,Tt=!0);for(let jt=0;jt<xt.length;jt++){let Te=xt[jt],Me=null;if(f!==null)Me=f.getViewport(Te);else{let xn=h.getViewSubImage(d,Te);Me=xn.viewport,jt===0&&(t.setRenderTargetTextures(v,xn.colorTexture,xn.depthStencilTexture),t.setRenderTarget(v))}let me=z[jt];me===void 0&&(me=new Ai,me.layers.enable(jt),me.viewport=new bn,z[jt]=me),me.matrix.fromArray(Te.transform.matrix),me.matrix.decompose(me.position,me.quaternion,me.scale),me.projectionMatrix.fromArray(Te.projectionMatrix),me.projectionMatrixInverse.copy(me.projectionMatrix).invert(),me.viewport.set(Me.x,Me.y,Me.width,Me.height),jt===0&&(G.matrix.copy(me.matrix),G.matrix.decompose(G.position,G.quaternion,G.scale)),Tt===!0&&G.cameras.push(me)}let At=s.enabledFeatures;if(At&&At.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&y){h=i.getBinding();let jt=h.getDepthInformation(xt[0]);jt&&jt.isValid&&jt.texture&&g.init(jt,s.renderState)}if(At&&At.includes("camera-access")&&y){t.state.unbindTexture(),h=i.getBinding();for(let jt=0;jt<xt.length;jt++){let Te=xt[jt].camera;if(Te){let Me=m[Te];Me||(Me=new kc,m[Te]=Me);let me=h.getCameraImage(Te);Me.sourceTexture=me}}}}for(let xt=0;xt<A.length;xt++){let Tt=S[xt],At=A[xt];Tt!==null&&At!==void 0&&At.update(Tt,yt,c||o)}nt&&nt(st,yt),yt.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:yt}),p=null}let ft=new Fv;ft.setAnimationLoop(dt),this.setAnimationLoop=function(st){nt=st},this.dispose=function(){}}},DI=new ye,Xv=new fe;Xv.set(-1,0,0,0,1,0,0,0,1);function NI(n,t){function e(g,m){g.matrixAutoUpdate===!0&&g.updateMatrix(),m.value.copy(g.matrix)}function i(g,m){m.color.getRGB(g.fogColor.value,Tg(n)),m.isFog?(g.fogNear.value=m.near,g.fogFar.value=m.far):m.isFogExp2&&(g.fogDensity.value=m.density)}function s(g,m,x,w,v){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?r(g,m):m.isMeshLambertMaterial?(r(g,m),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(r(g,m),h(g,m)):m.isMeshPhongMaterial?(r(g,m),u(g,m),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(r(g,m),d(g,m),m.isMeshPhysicalMaterial&&f(g,m,v)):m.isMeshMatcapMaterial?(r(g,m),p(g,m)):m.isMeshDepthMaterial?r(g,m):m.isMeshDistanceMaterial?(r(g,m),y(g,m)):m.isMeshNormalMaterial?r(g,m):m.isLineBasicMaterial?(o(g,m),m.isLineDashedMaterial&&a(g,m)):m.isPointsMaterial?l(g,m,x,w):m.isSpriteMaterial?c(g,m):m.isShadowMaterial?(g.color.value.copy(m.color),g.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function r(g,m){g.opacity.value=m.opacity,m.color&&g.diffuse.value.copy(m.color),m.emissive&&g.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(g.map.value=m.map,e(m.map,g.mapTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,e(m.alphaMap,g.alphaMapTransform)),m.bumpMap&&(g.bumpMap.value=m.bumpMap,e(m.bumpMap,g.bumpMapTransform),g.bumpScale.value=m.bumpScale,m.side===oi&&(g.bumpScale.value*=-1)),m.normalMap&&(g.normalMap.value=m.normalMap,e(m.normalMap,g.normalMapTransform),g.normalScale.value.copy(m.normalScale),m.side===oi&&g.normalScale.value.negate()),m.displacementMap&&(g.displacementMap.value=m.displacementMap,e(m.displacementMap,g.displacementMapTransform),g.displacementScale.value=m.displacementScale,g.displacementBias.value=m.displacementBias),m.emissiveMap&&(g.emissiveMap.value=m.emissiveMap,e(m.emissiveMap,g.emissiveMapTransform)),m.specularMap&&(g.specularMap.value=m.specularMap,e(m.specularMap,g.specularMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest);let x=t.get(m),w=x.envMap,v=x.envMapRotation;w&&(g.envMap.value=w,g.envMapRotation.value.setFromMatrix4(DI.makeRotationFromEuler(v)).transpose(),w.isCubeTexture&&w.isRenderTargetTexture===!1&&g.envMapRotation.value.premultiply(Xv),g.reflectivity.value=m.reflectivity,g.ior.value=m.ior,g.refractionRatio.value=m.refractionRatio),m.lightMap&&(g.lightMap.value=m.lightMap,g.lightMapIntensity.value=m.lightMapIntensity,e(m.lightMap,g.lightMapTransform)),m.aoMap&&(g.aoMap.value=m.aoMap,g.aoMapIntensity.value=m.aoMapIntensity,e(m.aoMap,g.aoMapTransform))}function o(g,m){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,m.map&&(g.map.value=m.map,e(m.map,g.mapTransform))}function a(g,m){g.dashSize.value=m.dashSize,g.totalSize.value=m.dashSize+m.gapSize,g.scale.value=m.scale}function l(g,m,x,w){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,g.size.value=m.size*x,g.scale.value=w*.5,m.map&&(g.map.value=m.map,e(m.map,g.uvTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,e(m.alphaMap,g.alphaMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest)}function c(g,m){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,g.rotation.value=m.rotation,m.map&&(g.map.value=m.map,e(m.map,g.mapTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,e(m.alphaMap,g.alphaMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest)}function u(g,m){g.specular.value.copy(m.specular),g.shininess.value=Math.max(m.shininess,1e-4)}function h(g,m){m.gradientMap&&(g.gradientMap.value=m.gradientMap)}function d(g,m){g.metalness.value=m.metalness,m.metalnessMap&&(g.metalnessMap.value=m.metalnessMap,e(m.metalnessMap,g.metalnessMapTransform)),g.roughness.value=m.roughness,m.roughnessMap&&(g.roughnessMap.value=m.roughnessMap,e(m.roughnessMap,g.roughnessMapTransform)),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)}function f(g,m,x){g.ior.value=m.ior,m.diffuseRoughness>0&&(g.diffuseRoughness.value=m.diffuseRoughness,m.diffuseRoughnessMap&&(g.diffuseRoughnessMap.value=m.diffuseRoughnessMap,e(m.diffuseRoughnessMap,g.diffuseRoughnessMapTransform))),m.sheen>0&&(g.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),g.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(g.sheenColorMap.value=m.sheenColorMap,e(m.sheenColorMap,g.sheenColorMapTransform)),m.sheenRoughnessMap&&(g.sheenRoughnessMap.value=m.sheenRoughnessMap,e(m.sheenRoughnessMap,g.sheenRoughnessMapTransform))),m.clearcoat>0&&(g.clearcoat.value=m.clearcoat,g.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(g.clearcoatMap.value=m.clearcoatMap,e(m.clearcoatMap,g.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,e(m.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(g.clearcoatNormalMap.value=m.clearcoatNormalMap,e(m.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===oi&&g.clearcoatNormalScale.value.negate())),m.dispersion>0&&(g.dispersion.value=m.dispersion),m.retroreflectivity>0&&(g.retroreflectivity.value=m.retroreflectivity),m.iridescence>0&&(g.iridescence.value=m.iridescence,g.iridescenceIOR.value=m.iridescenceIOR,g.iridescenceThicknessMinimum.value=m.iridescenceThicknessMinimum,g.iridescenceThicknessMaximum.value=m.iridescenceThicknessMaximum,m.iridescenceMap&&(g.iridescenceMap.value=m.iridescenceMap,e(m.iridescenceMap,g.iridescenceMapTransform)),m.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=m.iridescenceThicknessMap,e(m.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),m.transmission>0&&(g.transmission.value=m.transmission,g.transmissionSamplerMap.value=x.texture,g.transmissionSamplerSize.value.set(x.width,x.height),m.transmissionMap&&(g.transmissionMap.value=m.transmissionMap,e(m.transmissionMap,g.transmissionMapTransform)),g.thickness.value=m.thickness,m.thicknessMap&&(g.thicknessMap.value=m.thicknessMap,e(m.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=m.attenuationDistance,g.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(g.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(g.anisotropyMap.value=m.anisotropyMap,e(m.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=m.specularIntensity,g.specularColor.value.copy(m.specularColor),m.specularColorMap&&(g.specularColorMap.value=m.specularColorMap,e(m.specularColorMap,g.specularColorMapTransform)),m.specularIntensityMap&&(g.specularIntensityMap.value=m.specularIntensityMap,e(m.specularIntensityMap,g.specularIntensityMapTransform))}function p(g,m){m.matcap&&(g.matcap.value=m.matcap)}function y(g,m){let x=t.get(m).light;g.referencePosition.value.setFromMatrixPosition(x.matrixWorld),g.nearDistance.value=x.shadow.camera.near,g.farDistance.value=x.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function UI(n,t,e,i){let s={},r={};function o(x,w){let v=w.program;i.uniformBlockBinding(x,v,s[x.id])}function a(x,w){let v=s[x.id];v===void 0&&(p(x),v=l(x),s[x.id]=v,x.addEventListener("dispose",g));let A=w.program;i.updateUBOMapping(x,A);let S=t.render.frame;r[x.id]!==S&&(c(x),r[x.id]=S)}function l(x){let w=n.createBuffer(),v=x.__size,A=x.usage;return n.bindBuffer(n.UNIFORM_BUFFER,w),n.bufferData(n.UNIFORM_BUFFER,v,A),n.bindBuffer(n.UNIFORM_BUFFER,null),w}function c(x){let w=s[x.id],v=x.uniforms,A=x.__cache;n.bindBuffer(n.UNIFORM_BUFFER,w);for(let S=0,_=v.length;S<_;S++){let M=v[S];if(Array.isArray(M))for(let N=0,R=M.length;N<R;N++)u(M[N],S,N,A);else u(M,S,0,A)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(x,w,v,A){if(d(x,w,v,A)===!0){let S=x.__offset,_=x.value;if(Array.isArray(_)){let M=0;for(let N=0;N<_.length;N++){let R=_[N],L=y(R,!0);h(R,x.__data,M),M+=L.storage/Float32Array.BYTES_PER_ELEMENT}}else h(_,x.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,S,x.__data)}}function h(x,w,v){typeof x=="number"||typeof x=="boolean"?w[v]=x:x.isMatrix3?(w[v]=x.elements[0],w[v+1]=x.elements[1],w[v+2]=x.elements[2],w[v+3]=0,w[v+4]=x.elements[3],w[v+5]=x.elements[4],w[v+6]=x.elements[5],w[v+7]=0,w[v+8]=x.elements[6],w[v+9]=x.elements[7],w[v+10]=x.elements[8],w[v+11]=0):ArrayBuffer.isView(x)?w.set(x.subarray(0,w.length-v),v):x.toArray(w,v)}function d(x,w,v,A){let S=x.value,_=w+"_"+v;if(Array.isArray(S)){A[_]===void 0&&(A[_]=[]);let M=A[_],N=!1;for(let R=0;R<S.length;R++)f(S[R],M,R)===!0&&(N=!0);return N}return f(S,A,_)}function f(x,w,v){if(w[v]===void 0)return typeof x=="number"||typeof x=="boolean"?w[v]=x:ArrayBuffer.isView(x)?w[v]=x.slice():w[v]=x.clone(),!0;{let A=w[v];if(typeof x=="number"||typeof x=="boolean"){if(A!==x)return w[v]=x,!0}else{if(ArrayBuffer.isView(x))return!0;if(A.equals(x)===!1)return A.copy(x),!0}}return!1}function p(x){let w=x.uniforms,v=0,A=16;for(let _=0,M=w.length;_<M;_++){let N=Array.isArray(w[_])?w[_]:[w[_]];for(let R=0,L=N.length;R<L;R++){let z=N[R],G=Array.isArray(z.value)?z.value:[z.value],F=Array.isArray(w[_])||Array.isArray(z.value),U=v;for(let O=0,Z=G.length;O<Z;O++){let X=G[O],J=y(X,F),nt=v%A,dt=nt%J.boundary,ft=nt+dt;v+=dt,ft!==0&&A-ft<J.storage&&(v+=A-ft),O===0&&(U=v),v+=J.storage}let D=z.type==="int"?Int32Array:z.type==="uint"?Uint32Array:Float32Array;z.__data=new D((v-U)/Float32Array.BYTES_PER_ELEMENT),z.__offset=U}}let S=v%A;return S>0&&(v+=A-S),x.__size=v,x.__cache={},this}function y(x,w){let v={boundary:0,storage:0};return typeof x=="number"||typeof x=="boolean"?(v.boundary=4,v.storage=4):x.isVector2?(v.boundary=8,v.storage=8):x.isVector3||x.isColor?(v.boundary=16,v.storage=12):x.isVector4?(v.boundary=16,v.storage=16):x.isMatrix3?(v.boundary=16,v.storage=48):x.isMatrix4?(v.boundary=16,v.storage=64):x.isTexture?ie("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(x)?(v.boundary=16,v.storage=x.byteLength):ie("WebGLRenderer: Unsupported uniform value type.",x),w===!0&&(v.boundary=16,v.storage=Math.ceil(v.storage/16)*16),v}function g(x){let w=x.target;w.removeEventListener("dispose",g),n.deleteBuffer(s[w.id]),delete s[w.id],delete r[w.id]}function m(){for(let x in s)n.deleteBuffer(s[x]);s={},r={}}return{bind:o,update:a,dispose:m}}var OI=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),cr=null;function FI(){return cr===null&&(cr=new Uc(OI,16,16,xo,Os),cr.name="DFG_LUT",cr.minFilter=Ri,cr.magFilter=Ri,cr.wrapS=ir,cr.wrapT=ir,cr.generateMipmaps=!1,cr.needsUpdate=!0),cr}var af=class{constructor(t={}){let{canvas:e=lv(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:d=!1,outputBufferType:f=is}=t;this.isWebGLRenderer=!0;let p;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=i.getContextAttributes().alpha}else p=o;let y=f,g=new Set([Sd,Md,wd]),m=new Set([is,Us,dl,Ko,yd,vd]),x=new Uint32Array(4),w=new Int32Array(4),v={textures:[],min:[],max:[],resolution:[]},A=null,S=null,_=[],M=[],N=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=lr,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let R=this,L=!1,z=null,G=null,F=null,U=null;this._outputColorSpace=Ti;let D=0,O=0,Z=null,X=-1,J=null,nt=new bn,dt=new bn,ft=null,st=new ee(0),yt=0,xt=e.width,Tt=e.height,At=1,Jt=null,xe=null,jt=new bn(0,0,xt,Tt),Te=new bn(0,0,xt,Tt),Me=!1,me=new $o,xn=new Zh,on=!1,In=!1,Je=new ye,Zn=new V,Ue=new bn,kn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Mn=!1;function Ln(){return Z===null?At:1}let $=i;function Nt(I,q){return e.getContext(I,q)}let se,_e,Ct,tn,Yt,ne,B,C,j,mt,ut,Mt,St,rt,at,vt,W,ct,ot,Pt,wt,Rt,Zt;try{let I={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",$t,!1),e.addEventListener("webglcontextrestored",le,!1),e.addEventListener("webglcontextcreationerror",Dt,!1),$===null){let q="webgl2";if($=Nt(q,I),$===null)throw Nt(q)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}ae()}catch(I){throw e.removeEventListener("webglcontextlost",$t,!1),e.removeEventListener("webglcontextrestored",le,!1),e.removeEventListener("webglcontextcreationerror",Dt,!1),ce("WebGLRenderer: "+I.message),I}function ae(){se=new YC($),se.init(),wt=new PI($,se),_e=new FC($,se,t,wt),Ct=new RI($,se),_e.reversedDepthBuffer&&d&&Ct.buffers.depth.setReversed(!0),G=$.createFramebuffer(),F=$.createFramebuffer(),U=$.createFramebuffer(),tn=new JC($),Yt=new pI,ne=new CI($,se,Ct,Yt,_e,wt,tn),B=new XC(R),C=new QT($),Rt=new UC($,C),j=new jC($,C,tn,Rt),mt=new QC($,j,C,Rt,tn),ct=new KC($,_e,ne),at=new BC(Yt),ut=new fI(R,B,se,_e,Rt,at),Mt=new NI(R,Yt),St=new gI,rt=new wI(se),W=new NC(R,B,Ct,mt,p,l),vt=new AI(R,mt,_e),Zt=new UI($,tn,_e,Ct),ot=new OC($,se,tn),Pt=new ZC($,se,tn),tn.programs=ut.programs,R.capabilities=_e,R.extensions=se,R.properties=Yt,R.renderLists=St,R.shadowMap=vt,R.state=Ct,R.info=tn}y!==is&&(N=new eP(y,e.width,e.height,a,s,r));let pt=new kg(R,$);this.xr=pt,this.getContext=function(){return $},this.getContextAttributes=function(){return $.getContextAttributes()},this.forceContextLoss=function(){let I=se.get("WEBGL_lose_context");I&&I.loseContext()},this.forceContextRestore=function(){let I=se.get("WEBGL_lose_context");I&&I.restoreContext()},this.getPixelRatio=function(){return At},this.setPixelRatio=function(I){I!==void 0&&(At=I,this.setSize(xt,Tt,!1))},this.getSize=function(I){return I.set(xt,Tt)},this.setSize=function(I,q,it=!0){if(pt.isPresenting){ie("WebGLRenderer: Can't change size while VR device is presenting.");return}xt=I,Tt=q,e.width=Math.floor(I*At),e.height=Math.floor(q*At),it===!0&&(e.style.width=I+"px",e.style.height=q+"px"),N!==null&&N.setSize(e.width,e.height),this.setViewport(0,0,I,q)},this.getDrawingBufferSize=function(I){return I.set(xt*At,Tt*At).floor()},this.setDrawingBufferSize=function(I,q,it){xt=I,Tt=q,At=it,e.width=Math.floor(I*it),e.height=Math.floor(q*it),this.setViewport(0,0,I,q)},this.setEffects=function(I){if(y===is){ce("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(I){for(let q=0;q<I.length;q++)if(I[q].isOutputPass===!0){ie("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}N.setEffects(I||[])},this.getCurrentViewport=function(I){return I.copy(nt)},this.getViewport=function(I){return I.copy(jt)},this.setViewport=function(I,q,it,Q){I.isVector4?jt.set(I.x,I.y,I.z,I.w):jt.set(I,q,it,Q),Ct.viewport(nt.copy(jt).multiplyScalar(Ln()).round())},this.getScissor=function(I){return I.copy(Te)},this.setScissor=function(I,q,it,Q){I.isVector4?Te.set(I.x,I.y,I.z,I.w):Te.set(I,q,it,Q),Ct.scissor(dt.copy(Te).multiplyScalar(Ln()).round())},this.getScissorTest=function(){return Me},this.setScissorTest=function(I){Ct.setScissorTest(Me=I)},this.setOpaqueSort=function(I){Jt=I},this.setTransparentSort=function(I){xe=I},this.getClearColor=function(I){return I.copy(W.getClearColor())},this.setClearColor=function(){W.setClearColor(...arguments)},this.getClearAlpha=function(){return W.getClearAlpha()},this.setClearAlpha=function(){W.setClearAlpha(...arguments)},this.clear=function(I=!0,q=!0,it=!0){let Q=0;if(I){let tt=!1;if(Z!==null){let It=Z.texture.format;tt=g.has(It)}if(tt){let It=Z.texture.type,Ot=m.has(It),Lt=W.getClearColor(),Bt=W.getClearAlpha(),Xt=Lt.r,he=Lt.g,Re=Lt.b;Ot?(x[0]=Xt,x[1]=he,x[2]=Re,x[3]=Bt,$.clearBufferuiv($.COLOR,0,x)):(w[0]=Xt,w[1]=he,w[2]=Re,w[3]=Bt,$.clearBufferiv($.COLOR,0,w))}else Q|=$.COLOR_BUFFER_BIT}q&&(Q|=$.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),it&&(Q|=$.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Q!==0&&$.clear(Q)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(I){I.setRenderer(this),z=I},this.dispose=function(){e.removeEventListener("webglcontextlost",$t,!1),e.removeEventListener("webglcontextrestored",le,!1),e.removeEventListener("webglcontextcreationerror",Dt,!1),W.dispose(),St.dispose(),rt.dispose(),ne.dispose(),Yt.dispose(),B.dispose(),mt.dispose(),j.dispose(),Rt.dispose(),Zt.dispose(),ut.dispose(),pt.dispose(),pt.removeEventListener("sessionstart",Zu),pt.removeEventListener("sessionend",$s),xr.stop()};function $t(I){I.preventDefault(),Cc("WebGLRenderer: Context Lost."),L=!0}function le(){Cc("WebGLRenderer: Context Restored."),L=!1;let I=tn.autoReset,q=vt.enabled,it=vt.autoUpdate,Q=vt.needsUpdate,tt=vt.type;ae(),tn.autoReset=I,vt.enabled=q,vt.autoUpdate=it,vt.needsUpdate=Q,vt.type=tt}function Dt(I){ce("WebGLRenderer: A WebGL context could not be created. Reason: ",I.statusMessage)}function ve(I){let q=I.target;q.removeEventListener("dispose",ve),an(q)}function an(I){yi(I),Yt.remove(I)}function yi(I){let q=Yt.get(I).programs;q!==void 0&&(q.forEach(function(it){ut.releaseProgram(it)}),I.isShaderMaterial&&ut.releaseShaderCache(I))}this.renderBufferDirect=function(I,q,it,Q,tt,It){q===null&&(q=kn);let Ot=tt.isMesh&&tt.matrixWorld.determinantAffine()<0,Lt=rc(I,q,it,Q,tt);Ct.setMaterial(Q,Ot);let Bt=it.index,Xt=1;if(Q.wireframe===!0){if(Bt=j.getWireframeAttribute(it),Bt===void 0)return;Xt=2}let he=it.drawRange,Re=it.attributes.position,qt=he.start*Xt,Ce=(he.start+he.count)*Xt;It!==null&&(qt=Math.max(qt,It.start*Xt),Ce=Math.min(Ce,(It.start+It.count)*Xt)),Bt!==null?(qt=Math.max(qt,0),Ce=Math.min(Ce,Bt.count)):Re!=null&&(qt=Math.max(qt,0),Ce=Math.min(Ce,Re.count));let vn=Ce-qt;if(vn<0||vn===1/0)return;Rt.setup(tt,Q,Lt,it,Bt);let Xe,Ye=ot;if(Bt!==null&&(Xe=C.get(Bt),Ye=Pt,Ye.setIndex(Xe)),tt.isMesh)Q.wireframe===!0?(Ct.setLineWidth(Q.wireframeLinewidth*Ln()),Ye.setMode($.LINES)):Ye.setMode($.TRIANGLES);else if(tt.isLine){let zn=Q.linewidth;zn===void 0&&(zn=1),Ct.setLineWidth(zn*Ln()),tt.isLineSegments?Ye.setMode($.LINES):tt.isLineLoop?Ye.setMode($.LINE_LOOP):Ye.setMode($.LINE_STRIP)}else tt.isPoints?Ye.setMode($.POINTS):tt.isSprite&&Ye.setMode($.TRIANGLES);if(tt.isBatchedMesh)if(se.get("WEBGL_multi_draw"))Ye.renderMultiDraw(tt._multiDrawStarts,tt._multiDrawCounts,tt._multiDrawCount);else{let zn=tt._multiDrawStarts,Vt=tt._multiDrawCounts,Dn=tt._multiDrawCount,Le=Bt?C.get(Bt).bytesPerElement:1,yr=Yt.get(Q).currentProgram.getUniforms();for(let Nn=0;Nn<Dn;Nn++)yr.setValue($,"_gl_DrawID",Nn),Ye.render(zn[Nn]/Le,Vt[Nn])}else if(tt.isInstancedMesh)Ye.renderInstances(qt,vn,tt.count);else if(it.isInstancedBufferGeometry){let zn=it._maxInstanceCount!==void 0?it._maxInstanceCount:1/0,Vt=Math.min(it.instanceCount,zn);Ye.renderInstances(qt,vn,Vt)}else Ye.render(qt,vn)};function nc(I,q,it,Q){z!==null&&I.isNodeMaterial&&z.setObject(Q,I),on===!0&&at.setState(I,it,!1),I.transparent===!0&&I.side===mi&&I.forceSinglePass===!1?(I.side=oi,I.needsUpdate=!0,qs(I,q,Q),I.side=ar,I.needsUpdate=!0,qs(I,q,Q),I.side=mi):qs(I,q,Q)}this.compile=function(I,q,it=null){it===null&&(it=I),z!==null&&z.renderStart(I,q,it),S=rt.get(it),S.init(q),M.push(S),it.traverseVisible(function(tt){tt.isLight&&tt.layers.test(q.layers)&&(S.pushLight(tt),tt.castShadow&&S.pushShadow(tt))}),I!==it&&I.traverseVisible(function(tt){tt.isLight&&tt.layers.test(q.layers)&&(S.pushLight(tt),tt.castShadow&&S.pushShadow(tt))}),S.setupLights(),z!==null&&z.updateLights(S.state.lightsArray),In=this.localClippingEnabled,on=at.init(this.clippingPlanes,In),on===!0&&at.setGlobalState(this.clippingPlanes,q),z!==null&&vt.render(S.state.shadowsArray,it,q);let Q=new Set;return I.traverse(function(tt){if(!(tt.isMesh||tt.isPoints||tt.isLine||tt.isSprite))return;let It=tt.material;if(It)if(Array.isArray(It))for(let Ot=0;Ot<It.length;Ot++){let Lt=It[Ot];nc(Lt,it,q,tt),Q.add(Lt)}else nc(It,it,q,tt),Q.add(It)}),S=M.pop(),z!==null&&z.renderEnd(),Q},this.compileAsync=function(I,q,it=null){let Q=this.compile(I,q,it);return new Promise(tt=>{function It(){if(Q.forEach(function(Ot){let Bt=Yt.get(Ot).currentProgram;(Bt===void 0||Bt.isReady())&&Q.delete(Ot)}),Q.size===0){tt(I);return}setTimeout(It,10)}se.get("KHR_parallel_shader_compile")!==null?It():setTimeout(It,10)})};let va=null;function sm(I){va&&va(I)}function Zu(){xr.stop()}function $s(){xr.start()}let xr=new Fv;xr.setAnimationLoop(sm),typeof self<"u"&&xr.setContext(self),this.setAnimationLoop=function(I){va=I,pt.setAnimationLoop(I),I===null?xr.stop():xr.start()},pt.addEventListener("sessionstart",Zu),pt.addEventListener("sessionend",$s),this.render=function(I,q){if(q!==void 0&&q.isCamera!==!0){ce("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(L===!0)return;z!==null&&z.renderStart(I,q);let it=pt.enabled===!0&&pt.isPresenting===!0,Q=N!==null&&(Z===null||it)&&N.begin(R,Z);if(I.matrixWorldAutoUpdate===!0&&I.updateMatrixWorld(),q.parent===null&&q.matrixWorldAutoUpdate===!0&&q.updateMatrixWorld(),pt.enabled===!0&&pt.isPresenting===!0&&(N===null||N.isCompositing()===!1)&&(pt.cameraAutoUpdate===!0&&pt.updateCamera(q),q=pt.getCamera()),I.isScene===!0&&I.onBeforeRender(R,I,q,Z),S=rt.get(I,M.length),S.init(q),S.state.textureUnits=ne.getTextureUnits(),M.push(S),Je.multiplyMatrices(q.projectionMatrix,q.matrixWorldInverse),q.isArrayCamera?xn.setFromArrayCamera(q):me.setFromProjectionMatrix(Je,fs,q.reversedDepth),In=this.localClippingEnabled,on=at.init(this.clippingPlanes,In),A=St.get(I,_.length),A.init(),_.push(A),this.info.render.frame++,pt.enabled===!0&&pt.isPresenting===!0){let Ot=R.xr.getDepthSensingMesh();Ot!==null&&_r(Ot,q,-1/0,R.sortObjects)}_r(I,q,0,R.sortObjects),A.finish(),z!==null&&z.updateLights(S.state.lightsArray),R.sortObjects===!0&&A.sort(Jt,xe),Mn=pt.enabled===!1||pt.isPresenting===!1||pt.hasDepthSensing()===!1,Mn&&W.addToRenderList(A,I),this.info.autoReset===!0&&this.info.reset(),on===!0&&at.beginShadows();let tt=S.state.shadowsArray;if(vt.render(tt,I,q),on===!0&&at.endShadows(),(Q&&N.hasRenderPass())===!1){let Ot=A.opaque,Lt=A.transmissive;if(S.setupLights(),q.isArrayCamera){let Bt=q.cameras;if(Lt.length>0)for(let Xt=0,he=Bt.length;Xt<he;Xt++){let Re=Bt[Xt];Ss(Ot,Lt,I,Re)}Mn&&W.render(I);for(let Xt=0,he=Bt.length;Xt<he;Xt++){let Re=Bt[Xt];ic(A,I,Re,Re.viewport)}}else Lt.length>0&&Ss(Ot,Lt,I,q),Mn&&W.render(I),ic(A,I,q)}Z!==null&&O===0&&(ne.updateMultisampleRenderTarget(Z),ne.updateRenderTargetMipmap(Z)),Q&&N.end(R),I.isScene===!0&&I.onAfterRender(R,I,q),Rt.resetDefaultState(),X=-1,J=null,M.pop(),M.length>0?(S=M[M.length-1],ne.setTextureUnits(S.state.textureUnits),on===!0&&at.setGlobalState(R.clippingPlanes,S.state.camera)):S=null,_.pop(),_.length>0?A=_[_.length-1]:A=null,z!==null&&z.renderEnd()};function _r(I,q,it,Q){if(I.visible===!1)return;if(I.layers.test(q.layers)){if(I.isGroup)it=I.renderOrder;else if(I.isLOD)I.autoUpdate===!0&&I.update(q);else if(I.isLight)S.pushLight(I),I.castShadow&&S.pushShadow(I);else if(I.isSprite){let Ot=q.isArrayCamera?xn:me;if(!I.frustumCulled||I.intersectsFrustum(Ot)){Q&&Ue.setFromMatrixPosition(I.matrixWorld).applyMatrix4(Je);let Lt=mt.update(I),Bt=I.material;Bt.visible&&A.push(I,Lt,Bt,it,Ue.z,null,q)}}else if(I.isMesh||I.isLine||I.isPoints){let Ot=q.isArrayCamera?xn:me;if(!I.frustumCulled||I.intersectsFrustum(Ot)){let Lt=mt.update(I),Bt=I.material;if(Q&&(I.boundingSphere!==void 0?(I.boundingSphere===null&&I.computeBoundingSphere(),Ue.copy(I.boundingSphere.center)):(Lt.boundingSphere===null&&Lt.computeBoundingSphere(),Ue.copy(Lt.boundingSphere.center)),Ue.applyMatrix4(I.matrixWorld).applyMatrix4(Je)),Array.isArray(Bt)){let Xt=Lt.groups;for(let he=0,Re=Xt.length;he<Re;he++){let qt=Xt[he],Ce=Bt[qt.materialIndex];Ce&&Ce.visible&&A.push(I,Lt,Ce,it,Ue.z,qt,q)}}else Bt.visible&&A.push(I,Lt,Bt,it,Ue.z,null,q)}}}let It=I.children;for(let Ot=0,Lt=It.length;Ot<Lt;Ot++)_r(It[Ot],q,it,Q)}function ic(I,q,it,Q){let{opaque:tt,transmissive:It,transparent:Ot}=I;S.setupLightsView(it),on===!0&&at.setGlobalState(R.clippingPlanes,it),Q&&Ct.viewport(nt.copy(Q)),tt.length>0&&Sn(tt,q,it),It.length>0&&Sn(It,q,it),Ot.length>0&&Sn(Ot,q,it),Ct.buffers.depth.setTest(!0),Ct.buffers.depth.setMask(!0),Ct.buffers.color.setMask(!0),Ct.setPolygonOffset(!1)}function Ss(I,q,it,Q){if((it.isScene===!0?it.overrideMaterial:null)!==null)return;if(S.state.transmissionRenderTarget[Q.id]===void 0){let qt=se.has("EXT_color_buffer_half_float")||se.has("EXT_color_buffer_float");S.state.transmissionRenderTarget[Q.id]=new ts(1,1,{generateMipmaps:!0,type:qt?Os:is,minFilter:Or,samples:Math.max(4,_e.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:De.workingColorSpace})}let It=S.state.transmissionRenderTarget[Q.id],Ot=Q.viewport||nt;It.setSize(Ot.z*R.transmissionResolutionScale,Ot.w*R.transmissionResolutionScale);let Lt=R.getRenderTarget(),Bt=R.getActiveCubeFace(),Xt=R.getActiveMipmapLevel();R.setRenderTarget(It),R.getClearColor(st),yt=R.getClearAlpha(),yt<1&&R.setClearColor(16777215,.5),R.clear(),Mn&&W.render(it);let he=R.toneMapping;R.toneMapping=lr;let Re=Q.viewport;if(Q.viewport!==void 0&&(Q.viewport=void 0),S.setupLightsView(Q),on===!0&&at.setGlobalState(R.clippingPlanes,Q),Sn(I,it,Q),ne.updateMultisampleRenderTarget(It),ne.updateRenderTargetMipmap(It),se.has("WEBGL_multisampled_render_to_texture")===!1){let qt=!1;for(let Ce=0,vn=q.length;Ce<vn;Ce++){let Xe=q[Ce],{object:Ye,geometry:zn,material:Vt,group:Dn}=Xe;if(Vt.side===mi&&Ye.layers.test(Q.layers)){let Le=Vt.side;Vt.side=oi,Vt.needsUpdate=!0,Cn(Ye,it,Q,zn,Vt,Dn),Vt.side=Le,Vt.needsUpdate=!0,qt=!0}}qt===!0&&(ne.updateMultisampleRenderTarget(It),ne.updateRenderTargetMipmap(It))}R.setRenderTarget(Lt,Bt,Xt),R.setClearColor(st,yt),Re!==void 0&&(Q.viewport=Re),R.toneMapping=he}function Sn(I,q,it){let Q=q.isScene===!0?q.overrideMaterial:null;for(let tt=0,It=I.length;tt<It;tt++){let Ot=I[tt],{object:Lt,geometry:Bt,group:Xt}=Ot,he=Ot.material;he.allowOverride===!0&&Q!==null&&(he=Q),Lt.layers.test(it.layers)&&Cn(Lt,q,it,Bt,he,Xt)}}function Cn(I,q,it,Q,tt,It){z!==null&&tt.isNodeMaterial&&z.setObject(I,tt),I.onBeforeRender(R,q,it,Q,tt,It),I.modelViewMatrix.multiplyMatrices(it.matrixWorldInverse,I.matrixWorld),I.normalMatrix.getNormalMatrix(I.modelViewMatrix),tt.onBeforeRender(R,q,it,Q,I,It),tt.transparent===!0&&tt.side===mi&&tt.forceSinglePass===!1?(tt.side=oi,tt.needsUpdate=!0,R.renderBufferDirect(it,q,Q,tt,I,It),tt.side=ar,tt.needsUpdate=!0,R.renderBufferDirect(it,q,Q,tt,I,It),tt.side=mi):R.renderBufferDirect(it,q,Q,tt,I,It),I.onAfterRender(R,q,it,Q,tt,It)}function Pn(I){let q=0;for(let it of I)it.texture!==null&&q++;return q}function qs(I,q,it){q.isScene!==!0&&(q=kn);let Q=Yt.get(I),tt=S.state.lights,It=S.state.shadowsArray,Ot=tt.state.version,Lt=ut.getParameters(I,tt.state,It,q,it,S.state.lightProbeGridArray),Bt=ut.getProgramCacheKey(Lt),Xt=Q.programs;Q.environment=I.isMeshStandardMaterial||I.isMeshLambertMaterial||I.isMeshPhongMaterial?q.environment:null,Q.fog=q.fog;let he=I.isMeshStandardMaterial||I.isMeshLambertMaterial&&!I.envMap||I.isMeshPhongMaterial&&!I.envMap;Q.envMap=B.get(I.envMap||Q.environment,he),Q.envMapRotation=Q.environment!==null&&I.envMap===null?q.environmentRotation:I.envMapRotation,Xt===void 0&&(I.addEventListener("dispose",ve),Xt=new Map,Q.programs=Xt,Q.programVariants=new Map);let Re=Xt.get(Bt);if(Re!==void 0){if(Q.currentProgram===Re&&Q.lightsStateVersion===Ot)return sc(I,Lt),Re}else Lt.uniforms=ut.getUniforms(I),z!==null&&I.isNodeMaterial&&z.build(I,it,Lt),I.onBeforeCompile(Lt,R),Re=ut.acquireProgram(Lt,Bt),Xt.set(Bt,Re),Q.uniforms=Lt.uniforms;let qt=Q.uniforms;return(!I.isShaderMaterial&&!I.isRawShaderMaterial||I.clipping===!0)&&(qt.clippingPlanes=at.uniform),sc(I,Lt),Q.needsLights=Jr(I),Q.lightsStateVersion=Ot,Q.needsLights&&(qt.ambientLightColor.value=tt.state.ambient,qt.lightProbe.value=tt.state.probe,qt.sunLights.value=tt.state.sun,qt.sunLightShadows.value=tt.state.sunShadow,qt.directionalLights.value=tt.state.directional,qt.directionalLightShadows.value=tt.state.directionalShadow,qt.spotLights.value=tt.state.spot,qt.spotLightShadows.value=tt.state.spotShadow,qt.rectAreaLights.value=tt.state.rectArea,qt.ltc_1.value=tt.state.rectAreaLTC1,qt.ltc_2.value=tt.state.rectAreaLTC2,qt.pointLights.value=tt.state.point,qt.pointLightShadows.value=tt.state.pointShadow,qt.hemisphereLights.value=tt.state.hemi,qt.sunShadowMatrix.value=tt.state.sunShadowMatrix,qt.sunShadowCascade.value=tt.state.sunShadowCascade,qt.directionalShadowMatrix.value=tt.state.directionalShadowMatrix,qt.spotLightMatrix.value=tt.state.spotLightMatrix,qt.spotLightMap.value=tt.state.spotLightMap,qt.pointShadowMatrix.value=tt.state.pointShadowMatrix),Q.numLightProbeGrids=Pn(S.state.lightProbeGridArray),Q.currentProgram=Re,Q.uniformsList=null,Re}function Xi(I,q,it,Q,tt){let It=Yt.get(I),Ot=It.currentProgram.id+","+Q+","+tt,Lt=It.programVariants.get(Ot);return Lt===void 0?(Lt=qs(I,q,it),It.programVariants.set(Ot,Lt)):(It.currentProgram=Lt,It.uniformsList=null,It.outputColorSpace=Q,It.toneMapping=tt),Lt}function Zr(I){if(I.uniformsList===null){let q=I.currentProgram.getUniforms();I.uniformsList=fl.seqWithValue(q.seq,I.uniforms)}return I.uniformsList}function sc(I,q){let it=Yt.get(I);it.outputColorSpace=q.outputColorSpace,it.batching=q.batching,it.batchingColor=q.batchingColor,it.instancing=q.instancing,it.instancingColor=q.instancingColor,it.instancingMorph=q.instancingMorph,it.skinning=q.skinning,it.morphTargets=q.morphTargets,it.morphNormals=q.morphNormals,it.morphColors=q.morphColors,it.morphTargetsCount=q.morphTargetsCount,it.numClippingPlanes=q.numClippingPlanes,it.numIntersection=q.numClipIntersection,it.vertexAlphas=q.vertexAlphas,it.vertexTangents=q.vertexTangents,it.toneMapping=q.toneMapping}function rc(I,q,it,Q,tt){q.isScene!==!0&&(q=kn),ne.resetTextureUnits();let It=q.fog,Ot=Q.isMeshStandardMaterial||Q.isMeshLambertMaterial||Q.isMeshPhongMaterial?q.environment:null,Lt=Z===null?R.outputColorSpace:Z.isXRRenderTarget===!0?Z.texture.colorSpace:De.workingColorSpace,Bt=Q.isMeshStandardMaterial||Q.isMeshLambertMaterial&&!Q.envMap||Q.isMeshPhongMaterial&&!Q.envMap,Xt=B.get(Q.envMap||Ot,Bt),he=Q.vertexColors===!0&&!!it.attributes.color&&it.attributes.color.itemSize===4,Re=!!it.attributes.tangent&&(!!Q.normalMap||Q.anisotropy>0),qt=!!it.morphAttributes.position,Ce=!!it.morphAttributes.normal,vn=!!it.morphAttributes.color,Xe=lr;Q.toneMapped&&(Z===null||Z.isXRRenderTarget===!0)&&(Xe=R.toneMapping);let Ye=it.morphAttributes.position||it.morphAttributes.normal||it.morphAttributes.color,zn=Ye!==void 0?Ye.length:0,Vt=Yt.get(Q),Dn=S.state.lights;if(on===!0&&(In===!0||I!==J)){let je=I===J&&Q.id===X;at.setState(Q,I,je)}let Le=!1,yr=!1;Q.version===Vt.__version?Vt.needsLights&&Vt.lightsStateVersion!==Dn.state.version||tt.isBatchedMesh&&Vt.batching===!1||!tt.isBatchedMesh&&Vt.batching===!0||tt.isBatchedMesh&&Vt.batchingColor===!0&&tt._colorsTexture===null||tt.isBatchedMesh&&Vt.batchingColor===!1&&tt._colorsTexture!==null||tt.isInstancedMesh&&Vt.instancing===!1||!tt.isInstancedMesh&&Vt.instancing===!0||tt.isSkinnedMesh&&Vt.skinning===!1||!tt.isSkinnedMesh&&Vt.skinning===!0||tt.isInstancedMesh&&Vt.instancingColor===!0&&tt.instanceColor===null||tt.isInstancedMesh&&Vt.instancingColor===!1&&tt.instanceColor!==null||tt.isInstancedMesh&&Vt.instancingMorph===!0&&tt.morphTexture===null||tt.isInstancedMesh&&Vt.instancingMorph===!1&&tt.morphTexture!==null||Vt.envMap!==Xt||Q.fog===!0&&Vt.fog!==It||Vt.numClippingPlanes!==void 0&&(Vt.numClippingPlanes!==at.numPlanes||Vt.numIntersection!==at.numIntersection)||Vt.vertexAlphas!==he||Vt.vertexTangents!==Re||Vt.morphTargets!==qt||Vt.morphNormals!==Ce||Vt.morphColors!==vn||Vt.morphTargetsCount!==zn||Vt.numLightProbeGrids!==Pn(S.state.lightProbeGridArray)?Le=!0:(Vt.outputColorSpace!==Lt||Vt.toneMapping!==Xe)&&(yr=!0):(Le=!0,Vt.__version=Q.version);let Nn=Vt.currentProgram;(Le===!0||yr===!0)&&(Nn=yr===!0?Xi(Q,q,tt,Lt,Xe):qs(Q,q,tt),z&&Q.isNodeMaterial&&z.onUpdateProgram(Q,Nn,Vt));let Ma=!1,Xs=!1,vr=!1,Se=Nn.getUniforms(),En=Vt.uniforms;if(Ct.useProgram(Nn.program)&&(Ma=!0,Xs=!0,vr=!0),Q.id!==X&&(X=Q.id,Xs=!0),Ma||J!==I){Ct.buffers.depth.getReversed()&&I.reversedDepth!==!0&&(I._reversedDepth=!0,I.updateProjectionMatrix()),Se.setValue($,"projectionMatrix",I.projectionMatrix),Se.setValue($,"viewMatrix",I.matrixWorldInverse);let Un=Se.map.cameraPosition;Un!==void 0&&Un.setValue($,Zn.setFromMatrixPosition(I.matrixWorld)),_e.logarithmicDepthBuffer&&Se.setValue($,"logDepthBufFC",2/(Math.log(I.far+1)/Math.LN2)),(Q.isMeshPhongMaterial||Q.isMeshToonMaterial||Q.isMeshLambertMaterial||Q.isMeshBasicMaterial||Q.isMeshStandardMaterial||Q.isShaderMaterial)&&Se.setValue($,"isOrthographic",I.isOrthographicCamera===!0),J!==I&&(J=I,Xs=!0,vr=!0)}if(Vt.needsLights&&(Dn.state.sunShadowMap.length>0&&Se.setValue($,"sunShadowMap",Dn.state.sunShadowMap,ne),Dn.state.directionalShadowMap.length>0&&Se.setValue($,"directionalShadowMap",Dn.state.directionalShadowMap,ne),Dn.state.spotShadowMap.length>0&&Se.setValue($,"spotShadowMap",Dn.state.spotShadowMap,ne),Dn.state.pointShadowMap.length>0&&Se.setValue($,"pointShadowMap",Dn.state.pointShadowMap,ne)),tt.isSkinnedMesh){Se.setOptional($,tt,"bindMatrix"),Se.setOptional($,tt,"bindMatrixInverse");let je=tt.skeleton;je&&(je.boneTexture===null&&je.computeBoneTexture(),Se.setValue($,"boneTexture",je.boneTexture,ne))}tt.isBatchedMesh&&(Se.setOptional($,tt,"batchingTexture"),Se.setValue($,"batchingTexture",tt._matricesTexture,ne),Se.setOptional($,tt,"batchingIdTexture"),Se.setValue($,"batchingIdTexture",tt._indirectTexture,ne),Se.setOptional($,tt,"batchingColorTexture"),tt._colorsTexture!==null&&Se.setValue($,"batchingColorTexture",tt._colorsTexture,ne));let vi=it.morphAttributes;if((vi.position!==void 0||vi.normal!==void 0||vi.color!==void 0)&&ct.update(tt,it,Nn),(Xs||Vt.receiveShadow!==tt.receiveShadow)&&(Vt.receiveShadow=tt.receiveShadow,Se.setValue($,"receiveShadow",tt.receiveShadow)),(Q.isMeshStandardMaterial||Q.isMeshLambertMaterial||Q.isMeshPhongMaterial)&&Q.envMap===null&&q.environment!==null&&(En.envMapIntensity.value=q.environmentIntensity),En.dfgLUT!==void 0&&(En.dfgLUT.value=FI()),Xs){if(Se.setValue($,"toneMappingExposure",R.toneMappingExposure),Vt.needsLights&&ba(En,vr),It&&Q.fog===!0&&Mt.refreshFogUniforms(En,It),Mt.refreshMaterialUniforms(En,Q,At,Tt,S.state.transmissionRenderTarget[I.id]),Vt.needsLights&&Vt.numLightProbeGrids>0){let je=v,Un=0;for(let ui of S.state.lightProbeGridArray)ui.texture!==null&&(je.textures[Un]=ui.texture,je.min[Un]=ui.boundingBox.min,je.max[Un]=ui.boundingBox.max,je.resolution[Un]=ui.resolution,Un++);for(let ui in je)je[ui].length=Un;En.probesSH.value=je.textures,En.probesMin.value=je.min,En.probesMax.value=je.max,En.probesResolution.value=je.resolution}fl.upload($,Zr(Vt),En,ne)}if(Q.isShaderMaterial&&Q.uniformsNeedUpdate===!0&&(fl.upload($,Zr(Vt),En,ne),Q.uniformsNeedUpdate=!1),Q.isSpriteMaterial&&Se.setValue($,"center",tt.center),Se.setValue($,"modelViewMatrix",tt.modelViewMatrix),Se.setValue($,"normalMatrix",tt.normalMatrix),Se.setValue($,"modelMatrix",tt.matrixWorld),Q.uniformsGroups!==void 0){let je=Q.uniformsGroups;for(let Un=0,ui=je.length;Un<ui;Un++){let Ju=je[Un];Zt.update(Ju,Nn),Zt.bind(Ju,Nn)}}return Nn}function ba(I,q){I.ambientLightColor.needsUpdate=q,I.lightProbe.needsUpdate=q,I.sunLights.needsUpdate=q,I.sunLightShadows.needsUpdate=q,I.directionalLights.needsUpdate=q,I.directionalLightShadows.needsUpdate=q,I.pointLights.needsUpdate=q,I.pointLightShadows.needsUpdate=q,I.spotLights.needsUpdate=q,I.spotLightShadows.needsUpdate=q,I.rectAreaLights.needsUpdate=q,I.hemisphereLights.needsUpdate=q}function Jr(I){return I.isMeshLambertMaterial||I.isMeshToonMaterial||I.isMeshPhongMaterial||I.isMeshStandardMaterial||I.isShadowMaterial||I.isShaderMaterial&&I.lights===!0}this.getActiveCubeFace=function(){return D},this.getActiveMipmapLevel=function(){return O},this.getRenderTarget=function(){return Z},this.setRenderTargetTextures=function(I,q,it){let Q=Yt.get(I);Q.__autoAllocateDepthBuffer=I.resolveDepthBuffer===!1,Q.__autoAllocateDepthBuffer===!1&&(Q.__useRenderToTexture=!1),Yt.get(I.texture).__webglTexture=q,Yt.get(I.depthTexture).__webglTexture=Q.__autoAllocateDepthBuffer?void 0:it,Q.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(I,q){let it=Yt.get(I);it.__webglFramebuffer=q,it.__useDefaultFramebuffer=q===void 0},this.setRenderTarget=function(I,q=0,it=0){Z=I,D=q,O=it;let Q=null,tt=!1,It=!1;if(I){let Lt=Yt.get(I);if(Lt.__useDefaultFramebuffer!==void 0){Ct.bindFramebuffer($.FRAMEBUFFER,Lt.__webglFramebuffer),nt.copy(I.viewport),dt.copy(I.scissor),ft=I.scissorTest,Ct.viewport(nt),Ct.scissor(dt),Ct.setScissorTest(ft),X=-1;return}else if(Lt.__webglFramebuffer===void 0)ne.setupRenderTarget(I);else if(Lt.__hasExternalTextures)ne.rebindTextures(I,Yt.get(I.texture).__webglTexture,Yt.get(I.depthTexture).__webglTexture);else if(I.depthBuffer){let he=I.depthTexture;if(Lt.__boundDepthTexture!==he){if(he!==null&&Yt.has(he)&&(I.width!==he.image.width||I.height!==he.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");ne.setupDepthRenderbuffer(I)}}let Bt=I.texture;(Bt.isData3DTexture||Bt.isDataArrayTexture||Bt.isCompressedArrayTexture)&&(It=!0);let Xt=Yt.get(I).__webglFramebuffer;I.isWebGLCubeRenderTarget?(Array.isArray(Xt[q])?Q=Xt[q][it]:Q=Xt[q],tt=!0):I.samples>0&&ne.useMultisampledRTT(I)===!1?Q=Yt.get(I).__webglMultisampledFramebuffer:Array.isArray(Xt)?Q=Xt[it]:Q=Xt,nt.copy(I.viewport),dt.copy(I.scissor),ft=I.scissorTest}else nt.copy(jt).multiplyScalar(At).floor(),dt.copy(Te).multiplyScalar(At).floor(),ft=Me;if(it!==0&&(Q=G),Ct.bindFramebuffer($.FRAMEBUFFER,Q)&&Ct.drawBuffers(I,Q),Ct.viewport(nt),Ct.scissor(dt),Ct.setScissorTest(ft),tt){let Lt=Yt.get(I.texture);$.framebufferTexture2D($.FRAMEBUFFER,$.COLOR_ATTACHMENT0,$.TEXTURE_CUBE_MAP_POSITIVE_X+q,Lt.__webglTexture,it)}else if(It){let Lt=q;for(let Bt=0;Bt<I.textures.length;Bt++){let Xt=Yt.get(I.textures[Bt]);$.framebufferTextureLayer($.FRAMEBUFFER,$.COLOR_ATTACHMENT0+Bt,Xt.__webglTexture,it,Lt)}}else if(I!==null&&it!==0){let Lt=Yt.get(I.texture);$.framebufferTexture2D($.FRAMEBUFFER,$.COLOR_ATTACHMENT0,$.TEXTURE_2D,Lt.__webglTexture,it)}X=-1};function wa(I){let q=Yt.get(I);return(q.__readFormat!==I.format||q.__readType!==I.type)&&(q.__readFormat=I.format,q.__readType=I.type,q.__formatReadable=_e.textureFormatReadable(I.format),q.__typeReadable=_e.textureTypeReadable(I.type)),q}this.readRenderTargetPixels=function(I,q,it,Q,tt,It,Ot,Lt=0){if(!(I&&I.isWebGLRenderTarget)){ce("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Bt=Yt.get(I).__webglFramebuffer;if(I.isWebGLCubeRenderTarget&&Ot!==void 0&&(Bt=Bt[Ot],Array.isArray(Bt)&&(Bt=Bt[0])),Bt){Ct.bindFramebuffer($.FRAMEBUFFER,Bt);try{let Xt=I.textures[Lt],he=Xt.format,Re=Xt.type;I.textures.length>1&&$.readBuffer($.COLOR_ATTACHMENT0+Lt);let qt=wa(Xt);if(qt.__formatReadable===!1){ce("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(qt.__typeReadable===!1){ce("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}q>=0&&q<=I.width-Q&&it>=0&&it<=I.height-tt&&$.readPixels(q,it,Q,tt,wt.convert(he),wt.convert(Re),It)}finally{let Xt=Z!==null?Yt.get(Z).__webglFramebuffer:null;Ct.bindFramebuffer($.FRAMEBUFFER,Xt)}}},this.readRenderTargetPixelsAsync=async function(I,q,it,Q,tt,It,Ot,Lt=0){if(!(I&&I.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Bt=Yt.get(I).__webglFramebuffer;if(I.isWebGLCubeRenderTarget&&Ot!==void 0&&(Bt=Bt[Ot],Array.isArray(Bt)&&(Bt=Bt[0])),Bt)if(q>=0&&q<=I.width-Q&&it>=0&&it<=I.height-tt){Ct.bindFramebuffer($.FRAMEBUFFER,Bt);let Xt=I.textures[Lt],he=Xt.format,Re=Xt.type;I.textures.length>1&&$.readBuffer($.COLOR_ATTACHMENT0+Lt);let qt=wa(Xt);if(qt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(qt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let Ce=$.createBuffer();$.bindBuffer($.PIXEL_PACK_BUFFER,Ce),$.bufferData($.PIXEL_PACK_BUFFER,It.byteLength,$.STREAM_READ),$.readPixels(q,it,Q,tt,wt.convert(he),wt.convert(Re),0),$.bindBuffer($.PIXEL_PACK_BUFFER,null);let vn=Z!==null?Yt.get(Z).__webglFramebuffer:null;Ct.bindFramebuffer($.FRAMEBUFFER,vn);let Xe=$.fenceSync($.SYNC_GPU_COMMANDS_COMPLETE,0);return $.flush(),await uv($,Xe,4),$.bindBuffer($.PIXEL_PACK_BUFFER,Ce),$.getBufferSubData($.PIXEL_PACK_BUFFER,0,It),$.bindBuffer($.PIXEL_PACK_BUFFER,null),$.deleteBuffer(Ce),$.deleteSync(Xe),It}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(I,q=null,it=0){let Q=Math.pow(2,-it),tt=Math.floor(I.image.width*Q),It=Math.floor(I.image.height*Q),Ot=q!==null?q.x:0,Lt=q!==null?q.y:0;ne.setTexture2D(I,0),$.copyTexSubImage2D($.TEXTURE_2D,it,0,0,Ot,Lt,tt,It),Ct.unbindTexture()},this.copyTextureToTexture=function(I,q,it=null,Q=null,tt=0,It=0){let Ot,Lt,Bt,Xt,he,Re,qt,Ce,vn,Xe=I.isCompressedTexture?I.mipmaps[It]:I.image;if(it!==null)Ot=it.max.x-it.min.x,Lt=it.max.y-it.min.y,Bt=it.isBox3?it.max.z-it.min.z:1,Xt=it.min.x,he=it.min.y,Re=it.isBox3?it.min.z:0;else{let Se=Math.pow(2,-tt);Ot=Math.floor(Xe.width*Se),Lt=Math.floor(Xe.height*Se),I.isDataArrayTexture?Bt=Xe.depth:I.isData3DTexture?Bt=Math.floor(Xe.depth*Se):Bt=1,Xt=0,he=0,Re=0}Q!==null?(qt=Q.x,Ce=Q.y,vn=Q.z):(qt=0,Ce=0,vn=0);let Ye=wt.convert(q.format),zn=wt.convert(q.type),Vt;q.isData3DTexture?(ne.setTexture3D(q,0),Vt=$.TEXTURE_3D):q.isDataArrayTexture||q.isCompressedArrayTexture?(ne.setTexture2DArray(q,0),Vt=$.TEXTURE_2D_ARRAY):(ne.setTexture2D(q,0),Vt=$.TEXTURE_2D),Ct.activeTexture($.TEXTURE0),Ct.pixelStorei($.UNPACK_FLIP_Y_WEBGL,q.flipY),Ct.pixelStorei($.UNPACK_PREMULTIPLY_ALPHA_WEBGL,q.premultiplyAlpha),Ct.pixelStorei($.UNPACK_ALIGNMENT,q.unpackAlignment);let Dn=Ct.getParameter($.UNPACK_ROW_LENGTH),Le=Ct.getParameter($.UNPACK_IMAGE_HEIGHT),yr=Ct.getParameter($.UNPACK_SKIP_PIXELS),Nn=Ct.getParameter($.UNPACK_SKIP_ROWS),Ma=Ct.getParameter($.UNPACK_SKIP_IMAGES);Ct.pixelStorei($.UNPACK_ROW_LENGTH,Xe.width),Ct.pixelStorei($.UNPACK_IMAGE_HEIGHT,Xe.height),Ct.pixelStorei($.UNPACK_SKIP_PIXELS,Xt),Ct.pixelStorei($.UNPACK_SKIP_ROWS,he),Ct.pixelStorei($.UNPACK_SKIP_IMAGES,Re);let Xs=I.isDataArrayTexture||I.isData3DTexture,vr=q.isDataArrayTexture||q.isData3DTexture;if(I.isDepthTexture){let Se=Yt.get(I),En=Yt.get(q),vi=Yt.get(Se.__renderTarget),je=Yt.get(En.__renderTarget);Ct.bindFramebuffer($.READ_FRAMEBUFFER,vi.__webglFramebuffer),Ct.bindFramebuffer($.DRAW_FRAMEBUFFER,je.__webglFramebuffer);for(let Un=0;Un<Bt;Un++)Xs&&($.framebufferTextureLayer($.READ_FRAMEBUFFER,$.COLOR_ATTACHMENT0,Yt.get(I).__webglTexture,tt,Re+Un),$.framebufferTextureLayer($.DRAW_FRAMEBUFFER,$.COLOR_ATTACHMENT0,Yt.get(q).__webglTexture,It,vn+Un)),$.blitFramebuffer(Xt,he,Xt+Ot,he+Lt,qt,Ce,qt+Ot,Ce+Lt,$.DEPTH_BUFFER_BIT,$.NEAREST);Ct.bindFramebuffer($.READ_FRAMEBUFFER,null),Ct.bindFramebuffer($.DRAW_FRAMEBUFFER,null)}else if(tt!==0||I.isRenderTargetTexture||Yt.has(I)){let Se=Yt.get(I),En=Yt.get(q);Ct.bindFramebuffer($.READ_FRAMEBUFFER,F),Ct.bindFramebuffer($.DRAW_FRAMEBUFFER,U);for(let vi=0;vi<Bt;vi++)Xs?$.framebufferTextureLayer($.READ_FRAMEBUFFER,$.COLOR_ATTACHMENT0,Se.__webglTexture,tt,Re+vi):$.framebufferTexture2D($.READ_FRAMEBUFFER,$.COLOR_ATTACHMENT0,$.TEXTURE_2D,Se.__webglTexture,tt),vr?$.framebufferTextureLayer($.DRAW_FRAMEBUFFER,$.COLOR_ATTACHMENT0,En.__webglTexture,It,vn+vi):$.framebufferTexture2D($.DRAW_FRAMEBUFFER,$.COLOR_ATTACHMENT0,$.TEXTURE_2D,En.__webglTexture,It),tt!==0?$.blitFramebuffer(Xt,he,Xt+Ot,he+Lt,qt,Ce,qt+Ot,Ce+Lt,$.COLOR_BUFFER_BIT,$.NEAREST):vr?$.copyTexSubImage3D(Vt,It,qt,Ce,vn+vi,Xt,he,Ot,Lt):$.copyTexSubImage2D(Vt,It,qt,Ce,Xt,he,Ot,Lt);Ct.bindFramebuffer($.READ_FRAMEBUFFER,null),Ct.bindFramebuffer($.DRAW_FRAMEBUFFER,null)}else vr?I.isDataTexture||I.isData3DTexture?$.texSubImage3D(Vt,It,qt,Ce,vn,Ot,Lt,Bt,Ye,zn,Xe.data):q.isCompressedArrayTexture?$.compressedTexSubImage3D(Vt,It,qt,Ce,vn,Ot,Lt,Bt,Ye,Xe.data):$.texSubImage3D(Vt,It,qt,Ce,vn,Ot,Lt,Bt,Ye,zn,Xe):I.isDataTexture?$.texSubImage2D($.TEXTURE_2D,It,qt,Ce,Ot,Lt,Ye,zn,Xe.data):I.isCompressedTexture?$.compressedTexSubImage2D($.TEXTURE_2D,It,qt,Ce,Xe.width,Xe.height,Ye,Xe.data):$.texSubImage2D($.TEXTURE_2D,It,qt,Ce,Ot,Lt,Ye,zn,Xe);Ct.pixelStorei($.UNPACK_ROW_LENGTH,Dn),Ct.pixelStorei($.UNPACK_IMAGE_HEIGHT,Le),Ct.pixelStorei($.UNPACK_SKIP_PIXELS,yr),Ct.pixelStorei($.UNPACK_SKIP_ROWS,Nn),Ct.pixelStorei($.UNPACK_SKIP_IMAGES,Ma),It===0&&q.generateMipmaps===!0&&q.mipmapsAutoUpdate===!0&&$.generateMipmap(Vt),Ct.unbindTexture()},this.initRenderTarget=function(I){Yt.get(I).__webglFramebuffer===void 0&&ne.setupRenderTarget(I)},this.initTexture=function(I){I.isCubeTexture?ne.setTextureCube(I,0):I.isData3DTexture?ne.setTexture3D(I,0):I.isDataArrayTexture||I.isCompressedArrayTexture?ne.setTexture2DArray(I,0):ne.setTexture2D(I,0),Ct.unbindTexture()},this.resetState=function(){D=0,O=0,Z=null,Ct.reset(),Rt.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return fs}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=De._getDrawingBufferColorSpace(t),e.unpackColorSpace=De._getUnpackColorSpace()}};var uf={about:"One identity for the workbench, reports, figures and the site; read by document/identity.py and the page's build.",wordmark:"pieper",type:{sans:'"Inter Variable", Inter, system-ui, -apple-system, "Segoe UI", Roboto, "Noto Sans", "DejaVu Sans", sans-serif',serif:'"Source Serif 4", "Iowan Old Style", "Palatino Linotype", Palatino, "Noto Serif", Georgia, serif',mono:'ui-monospace, "SFMono-Regular", "JetBrains Mono", Menlo, Consolas, "DejaVu Sans Mono", monospace'},light:{colours:{paper:"#ffffff",panel:"#ffffff",ground:"#f3f4f6",soft:"#f0f2f5",softer:"#f7f8fa",ink:"#171c24",muted:"#566070",line:"#dde1e7",edge:"#8891a0",accent:"#c2410c",accentInk:"#b03a08",accentSoft:"#fdeee6",onAccent:"#ffffff",good:"#1a7f4b",wrong:"#b42318",wrongSoft:"#fdecea",onWrong:"#ffffff",link:"#d5d9e0",joint:"#39424f",ghost:"#5b6b84",trace:"#0072b2",gridFine:"#e3e6eb",gridCoarse:"#cfd4dc"},curves:["#0072b2","#d55e00","#009e73","#cc79a7","#8a6d00","#56b4e9","#4b4b4b","#7a3e9d"]},dark:{colours:{paper:"#12151a",panel:"#171b21",ground:"#101318",soft:"#222831",softer:"#1c2128",ink:"#e9ecf1",muted:"#a3acba",line:"#2b323c",edge:"#6d7787",accent:"#ff8a4c",accentInk:"#ff9d68",accentSoft:"#3a2419",onAccent:"#1a0f08",good:"#4cc38a",wrong:"#ff8f85",wrongSoft:"#3a1d1b",onWrong:"#2a0b08",link:"#9aa5b5",joint:"#4d5969",ghost:"#8fa6c8",trace:"#56b4e9",gridFine:"#1b2027",gridCoarse:"#2a313b"},curves:["#56b4e9","#ff9a4d","#2fd6a3","#f0a3cb","#f0e442","#8fb7ff","#d0d4da","#c9a0ff"]},axes:["#d55e00","#009e73","#0072b2"]};var Ft={},kI=["ground","gridFine","gridCoarse","link","joint","accent","ghost","ink","muted","line","trace","panel","wrong"],Yv=matchMedia("(prefers-color-scheme: dark)");function hf(){let n=b.theme==="dark"||b.theme==="auto"&&Yv.matches;document.documentElement.dataset.theme=n?"dark":"light",document.documentElement.style.setProperty("--text-size",String(ou()));let t=getComputedStyle(document.documentElement);for(let e of kI)Ft[e]=t.getPropertyValue(`--${e.replace(/[A-Z]/g,i=>`-${i.toLowerCase()}`)}`).trim();Ft.dark=n,Ft.curves=uf[n?"dark":"light"].curves}function df(n){b.theme=n,hf(),lt("theme")}var jv="pieper-text-size";function ou(){let n=Number(localStorage.getItem(jv));return n>=.5&&n<=3?n:1}function Zv(n){document.documentElement.style.setProperty("--text-size",String(n));try{localStorage.setItem(jv,String(n))}catch{}lt("theme"),dispatchEvent(new Event("resize"))}Yv.addEventListener("change",()=>{b.theme==="auto"&&(hf(),lt("theme"))});var Jv={type:"change"},Hg={type:"start"},Qv={type:"end"},ff=new Dr,Kv=new ri,zI=Math.cos(70*yo.DEG2RAD),qn=new V,Gi=2*Math.PI,Ve={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},zg=1e-6,pf=class extends Xc{constructor(t,e=null){super(t,e),this.state=Ve.NONE,this.target=new V,this.cursor=new V,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:mo.ROTATE,MIDDLE:mo.DOLLY,RIGHT:mo.PAN},this.touches={ONE:go.ROTATE,TWO:go.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new V,this._lastQuaternion=new fn,this._lastTargetPosition=new V,this._quat=new fn().setFromUnitVectors(t.up,new V(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new ll,this._sphericalDelta=new ll,this._scale=1,this._panOffset=new V,this._rotateStart=new Qt,this._rotateEnd=new Qt,this._rotateDelta=new Qt,this._panStart=new Qt,this._panEnd=new Qt,this._panDelta=new Qt,this._dollyStart=new Qt,this._dollyEnd=new Qt,this._dollyDelta=new Qt,this._dollyDirection=new V,this._mouse=new Qt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=GI.bind(this),this._onPointerDown=HI.bind(this),this._onPointerUp=VI.bind(this),this._onContextMenu=ZI.bind(this),this._onMouseWheel=qI.bind(this),this._onKeyDown=XI.bind(this),this._onTouchStart=YI.bind(this),this._onTouchMove=jI.bind(this),this._onMouseDown=WI.bind(this),this._onMouseMove=$I.bind(this),this._interceptControlDown=JI.bind(this),this._interceptControlUp=KI.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Ve.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(Jv),this.update(),this.state=Ve.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;qn.copy(e).sub(this.target),qn.applyQuaternion(this._quat),this._spherical.setFromVector3(qn),this.autoRotate&&this.state===Ve.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=Gi:i>Math.PI&&(i-=Gi),s<-Math.PI?s+=Gi:s>Math.PI&&(s-=Gi),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(qn.setFromSpherical(this._spherical),qn.applyQuaternion(this._quatInverse),e.copy(this.target).add(qn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=qn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new V(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new V(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=qn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(ff.origin.copy(this.object.position),ff.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(ff.direction))<zI?this.object.lookAt(this.target):(Kv.setFromNormalAndCoplanarPoint(this.object.up,this.target),ff.intersectPlane(Kv,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>zg||8*(1-this._lastQuaternion.dot(this.object.quaternion))>zg||this._lastTargetPosition.distanceToSquared(this.target)>zg?(this.dispatchEvent(Jv),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?Gi/60*this.autoRotateSpeed*t:Gi/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){qn.setFromMatrixColumn(e,0),qn.multiplyScalar(-t),this._panOffset.add(qn)}_panUp(t,e){this.screenSpacePanning===!0?qn.setFromMatrixColumn(e,1):(qn.setFromMatrixColumn(e,0),qn.crossVectors(this.object.up,qn)),qn.multiplyScalar(t),this._panOffset.add(qn)}_pan(t,e){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;qn.copy(s).sub(this.target);let r=qn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/i.clientHeight,this.object.matrix),this._panUp(2*e*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=t-i.left,r=e-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(Gi*this._rotateDelta.x/e.clientHeight),this._rotateUp(Gi*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(Gi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-Gi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(Gi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-Gi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(i,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let i=this._getSecondPointerPosition(t),s=.5*(t.pageX+i.x),r=.5*(t.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(Gi*this._rotateDelta.x/e.clientHeight),this._rotateUp(Gi*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new Qt,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,i={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function HI(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function GI(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function VI(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(Qv),this.state=Ve.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function WI(n){let t;switch(n.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case mo.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=Ve.DOLLY;break;case mo.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Ve.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Ve.ROTATE}break;case mo.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Ve.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Ve.PAN}break;default:this.state=Ve.NONE}this.state!==Ve.NONE&&this.dispatchEvent(Hg)}function $I(n){switch(this.state){case Ve.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case Ve.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case Ve.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function qI(n){this.enabled===!1||this.enableZoom===!1||this.state!==Ve.NONE||(n.preventDefault(),this.dispatchEvent(Hg),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(Qv))}function XI(n){this.enabled!==!1&&this._handleKeyDown(n)}function YI(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case go.ROTATE:if(this.enableRotate===!1){this.state=Ve.NONE;break}this._handleTouchStartRotate(n),this.state=Ve.TOUCH_ROTATE;break;case go.PAN:if(this.enablePan===!1){this.state=Ve.NONE;break}this._handleTouchStartPan(n),this.state=Ve.TOUCH_PAN;break;default:this.state=Ve.NONE}break;case 2:switch(this.touches.TWO){case go.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=Ve.TOUCH_DOLLY_PAN;break;case go.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=Ve.TOUCH_DOLLY_ROTATE;break;default:this.state=Ve.NONE}break;default:this.state=Ve.NONE}this.state!==Ve.NONE&&this.dispatchEvent(Hg)}function jI(n){switch(this._trackPointer(n),this.state){case Ve.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case Ve.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case Ve.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case Ve.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=Ve.NONE}}function ZI(n){this.enabled!==!1&&n.preventDefault()}function JI(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function KI(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var tb=[1,.75,.55,.42],QI=30,t3=17,e3=400,eb=6e6;function nb(n){let t=n.getExtension("WEBGL_debug_renderer_info");return/swiftshader|llvmpipe|software|basic render/i.test(String(n.getParameter(t?t.UNMASKED_RENDERER_WEBGL:n.RENDERER)))}var mf=class{constructor(t,e,i,s){this.software=t,this.renderer=e,this.draw=i,this.hurry=s,this.resting=!0,this.level=0,this.gaps=[],this.last=0,this.area=1}resized(t,e){this.area=t*e}get base(){return Math.min(devicePixelRatio,2,Math.sqrt(eb/this.area))}#t(t){Math.abs(this.renderer.getPixelRatio()-t)>.001&&this.renderer.setPixelRatio(t)}moving(t){if(!this.software){this.#t(this.base);return}let e=t-this.last;if(this.last=t,e<120&&this.gaps.push(e),this.gaps.length>=8){let i=this.gaps.sort((s,r)=>s-r)[4];this.gaps=[],i>QI&&this.level<tb.length-1?this.level+=1:i<t3&&this.level>0&&(this.level-=1)}this.resting&&this.hurry(!0),this.resting=!1,this.#t(this.base*tb[this.level]),clearTimeout(this.timer),this.timer=setTimeout(()=>{this.gaps=[],this.resting=!0,this.hurry(!1),this.#t(Math.min(2*this.base,Math.max(Math.sqrt(eb/this.area),.5))),this.draw()},e3)}};var rb=32,ob={iso:[1,-1.25,.62],front:[1,0,0],side:[0,-1,0],top:[0,-1e-4,1]},en=new Lc,Ie=new Ai(rb,1,.01,100);Ie.up.set(0,0,1);var ss,pn,ms,gf,Gg=!1,ab=!1,Wg=0;function ue(){Gg||!ab||(Gg=!0,requestAnimationFrame(lb))}function lb(n=performance.now()){Gg=!1,gf.moving(n),$g()}var cb=[],xf=n=>cb.push(n);function $g(){for(let n of cb)n();ss.render(en,Ie),Wg+=1}function ub(){ab=!0,ue()}function ml(n){return $g(),n(ss.domElement)}var hb=()=>Wg,db=()=>!!gf?.software;en.fog=new Ic("#fff",1,10);function ib(n){let t=document.createElement("canvas");t.width=ms.clientWidth||1,t.height=ms.clientHeight||1;let e=t.getContext("webgl2",{alpha:!1,antialias:n,stencil:!0,powerPreference:"high-performance"});if(!e)throw new Error("This browser offers no WebGL 2, which the picture needs.");let i=e.getExtension.bind(e);return e.getExtension=s=>n3.has(s)?i(s):null,e}var n3=new Set(["WEBGL_debug_renderer_info","WEBGL_lose_context"]);function fb(n){ms=n;let t=ib(!1),e=nb(t);e||(t.getExtension("WEBGL_lose_context")?.loseContext(),t=ib(!0)),ss=new af({canvas:t.canvas,context:t}),ss.debug.checkShaderErrors=!1,gf=new mf(e,ss,$g,i=>lt("hurry",i)),ss.domElement.setAttribute("aria-hidden","true"),ms.append(ss.domElement),pn=new pf(Ie,ss.domElement),pn.enableDamping=!1,pn.addEventListener("change",ue),pn.addEventListener("end",()=>{gl=!Xg(),dr=null}),new ResizeObserver(i3).observe(ms),ms.tabIndex=0,ms.setAttribute("role","application"),ms.setAttribute("aria-label","The arm in space. Arrow keys turn the view, plus and minus zoom, F fits, 1 to 4 are the standard views."),ms.addEventListener("keydown",s3)}function i3(){let n=ms.clientWidth,t=ms.clientHeight;!n||!t||(gf.resized(n,t),ss.setSize(n,t),Ie.aspect=n/t,Ie.updateProjectionMatrix(),Wg?lb():ue(),o3()||xl())}function s3(n){let t={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,-1],ArrowDown:[0,1]}[n.key],e={1:"iso",2:"front",3:"side",4:"top"}[n.key];if(t)r3(t[0]*.1,t[1]*.1);else if(n.key==="+"||n.key==="=")sb(1/1.15);else if(n.key==="-")sb(1.15);else if(n.key.toLowerCase()==="f")_f(ta);else if(e)qg(e);else return;n.preventDefault()}function r3(n,t){let e=Ie.position.clone().sub(pn.target),i=e.length(),s=Math.atan2(e.y,e.x)+n,r=Math.min(Math.max(Math.acos(e.z/i)+t,.02),Math.PI-.02);Ie.position.set(Math.sin(r)*Math.cos(s),Math.sin(r)*Math.sin(s),Math.cos(r)).multiplyScalar(i).add(pn.target),pn.update(),ue()}function sb(n){Ie.position.sub(pn.target).multiplyScalar(n).add(pn.target),pn.update(),ue()}var ta=[[0,0,0],[0,0,1]];function pb(n,t){let e=new zi().setFromPoints(n.map(u=>new V(...u))),i=e.getCenter(new V),s=new V(...t).normalize(),r=new V().crossVectors(Ie.up,s).normalize(),o=new V().crossVectors(s,r),a=Math.tan(yo.degToRad(rb/2))*.8,l=a*Ie.aspect,c=e.getSize(new V).length()*.4+.001;for(let u=0;u<3;u++){let h=0,d=1/0,f=-1/0,p=1/0,y=-1/0;for(let g of n){let m=new V(...g).sub(i),x=m.dot(r),w=m.dot(o),v=m.dot(s);h=Math.max(h,v+Math.abs(x)/l,v+Math.abs(w)/a),d=Math.min(d,w),f=Math.max(f,w),p=Math.min(p,x),y=Math.max(y,x)}c=Math.max(h,c*.2),u<2&&i.addScaledVector(o,(d+f)/2).addScaledVector(r,(p+y)/2)}return{target:i,position:i.clone().addScaledVector(s,c)}}var Vg=0;function au({target:n,position:t},e=.35){let i={t:pn.target.clone(),p:Ie.position.clone()},s=performance.now(),r=++Vg,o=matchMedia("(prefers-reduced-motion: reduce)").matches||e===0;(function a(l){if(r!==Vg)return;let c=o?1:Math.min((l-s)/(1e3*e),1),u=c*c*(3-2*c);pn.target.lerpVectors(i.t,n,u),Ie.position.lerpVectors(i.p,t,u);let h=Ie.position.distanceTo(pn.target);Ie.near=h/100,Ie.far=h*30,en.fog.near=h*1.3,en.fog.far=h*3.4,Ie.updateProjectionMatrix(),pn.update(),ue(),c<1&&requestAnimationFrame(a)})(s)}function _f(n,{instant:t=!1,view:e=null,byItself:i=!1}={}){ta=n,i||(dr=null),gl=!1;let s=e?ob[e]:Ie.position.clone().sub(pn.target).toArray();au(pb(n,s),t?0:.35)}function qg(n){gl=!1,dr=null,au(pb(ta,ob[n]))}var gl=!1;function Xg(){Ie.updateMatrixWorld();let n=new V;return ta.every(t=>(n.set(...t).project(Ie),Math.abs(n.x)<1&&Math.abs(n.y)<1&&n.z<1))}function xl(){gl||!pn.enabled||!ta.length||Xg()||(dr??={position:Ie.position.clone(),target:pn.target.clone()},_f(ta,{byItself:!0}))}var dr=null;function mb(){if(!dr||gl||!pn.enabled)return;let n=dr;dr=null,au(n),setTimeout(xl,500)}function o3(){if(!dr||gl||!pn.enabled)return!1;let n={position:Ie.position.clone(),target:pn.target.clone()},t=dr,e=({position:s,target:r})=>{Ie.position.copy(s),pn.target.copy(r),Ie.lookAt(r)};e(t);let i=Xg();return e(n),i?(dr=null,au(t,0),!0):!1}var yf=n=>{ta=n},_l=()=>[...Ie.position.toArray(),...pn.target.toArray()].map(n=>Number(n.toPrecision(5)));function gb(n){Vg+=1,au({position:new V(...n.slice(0,3)),target:new V(...n.slice(3))},0)}var hr=null,Yg={cell:.1};function jg(n){let t=n/6,e=10**Math.floor(Math.log10(t)),i=[1,2,5,10].map(u=>u*e).findLast(u=>u<=t*1.0001)??e;Yg.cell=i;let s=Math.ceil(n*2.2/i),r=[],o=[],a=new ee(Ft.gridFine),l=new ee(Ft.gridCoarse);for(let u=-s;u<=s;u++){let h=u%5===0?l:a,d=s*i;r.push(u*i,-d,0,u*i,d,0,-d,u*i,0,d,u*i,0);for(let f=0;f<4;f++)o.push(h.r,h.g,h.b)}hr?.geometry.dispose();let c=new we;c.setAttribute("position",new be(r,3)),c.setAttribute("color",new be(o,3)),hr?hr.geometry=c:(hr=new qo(c,new es({vertexColors:!0})),hr.renderOrder=-2,hr.material.depthWrite=!1,en.add(hr)),hr.userData.reach=n,ue()}function Zg(){en.background=new ee(Ft.ground),en.fog.color.set(Ft.ground),hr&&jg(hr.userData.reach),ue()}function Vi(n){Ie.updateMatrixWorld();let t=new V(...n).project(Ie),e=ms.getBoundingClientRect();return[e.x+(t.x+1)/2*e.width,e.y+(1-t.y)/2*e.height]}function vf(n){let t=n.joints.length,e=Gn(n),i=Math.min(.062,.075-.002*t)*e,s=n.joints.map((r,o)=>i*(1-.52*o/Math.max(t-1,1)));return{size:e,radius:s,rest:s[t-1]??i*.5}}function Jg(n,t,e,i=null){let s={rods:[],balls:[],drums:[],sleeves:[],flange:null},{radius:r,size:o}=e,a=n.joints.length,l=o*1e-6,c=pm(n,t),u=(d,f,p,y=!0,g=p)=>{Ui(Ni(f,d))<=l||(s.rods.push({a:d,b:f,r:p,far:g}),y&&s.balls.push({at:f,r:g}))};a&&(s.pedestal={at:te(t[0]),dir:Ks(t[0],2),r:r[0]*1.7,h:r[0]*.34});let h=null;if(c.forEach(({point:d,dir:f,x:p},y)=>{let g=r[y],m=n.joints[y],x=te(t[y]),w=te(t[y+1]),v=g*.62,A=g*.84,S=(r[y+1]??e.rest)*.62,_=(r[y-1]??g)*.84;if(n.convention==="standard"){let U=hc(x,f,uc(Ni(w,x),f));u(x,U,v),u(U,w,A,!0,S)}else u(x,d,_,!0,v),u(d,w,v);let M=d,N=uc(Ni(w,d),f);h&&Ui(Ni(d,h.at))<.5*g&&Math.abs(N)>l?M=hc(d,f,Math.sign(N)*Math.min(Math.abs(N)*.55,h.r+g*1.15)):y===0&&Math.abs(N)>2.2*g&&(M=hc(d,f,Math.sign(N)*g*1.25));let R=g*2.15,L=Ks(t[y+1],0),z=!!(i&&lu(m,i[y])),G=Ks(t[0],2),F=uc(Ni(M,te(t[0])),G)-R/2;y===0&&m.type==="R"&&Math.abs(uc(f,G))>.99&&F<0&&F>-R&&(M=hc(M,G,-F)),m.type==="R"?s.drums.push({at:M,dir:f,x:p,turned:L,r:g,h:R,beyond:z,joint:y}):s.sleeves.push({at:M,dir:f,x:p,r:g*.95,h:g*3.4,beyond:z,joint:y}),h={at:d,r:g}}),a){let d=t[a+1],f=te(t[a]);s.flange={at:f,dir:Ks(t[a],2),turned:Ks(t[a],0),r:e.rest*.85,h:e.rest*.5},u(f,te(d),e.rest*.34,!1),s.tip={at:te(d),r:e.rest*.42}}return s}function lu(n,t){return n.lower!==null&&t<n.lower-1e-9?t-n.lower:n.upper!==null&&t>n.upper+1e-9?t-n.upper:0}var Kg=.13;function Qg(n,t){let{radius:e,size:i}=vf(n),s=e[0]??.05,r=te(t[0]);if(!n.joints.length)return[-.4,.4].flatMap(c=>[[r[0]+c,r[1]+c,0],[r[0]+c,r[1]-c,1]]);let o=[[r[0],r[1],0],...t.map(te)];for(let{point:c}of pm(n,t))o.push(c);let a=t.at(-1);return[...[0,1,2].map(c=>[3,7,11].map(u=>a[u]+Kg*i*a[u-3+c])),...o.flatMap(c=>[[c[0]-s,c[1]-s,c[2]-s],[c[0]+s,c[1]+s,c[2]+s]])]}function l3(n,t){let i=a=>a.rotateX(Math.PI/2),s=[[0,-.5],[.9,-.5],[1,-.45],[1,.45],[.9,.5],[0,.5]],r=t>8?new Hc(s.map(([a,l])=>new Qt(a,l)),n):new Ci(1,1,1,n),o={rod:i(new Ci(1,1,1,n,1,!0)),ball:t>3?new Ns(1,n,t):new Gc(1,0),drum:i(r),box:new Hi(2,2,1)};return Object.fromEntries(Object.entries(o).map(([a,l])=>{let c=l.attributes.position,u=l.index?l.index.array:Uint16Array.from({length:c.count},(h,d)=>d);return[a,{at:c.array,normal:l.attributes.normal.array,index:u,count:c.count}]}))}var xb=new Map,i0=(n,t)=>xb.get(n)??xb.set(n,l3(n,t)).get(n),c3=()=>i0(26,12),t0=()=>i0(11,5),_b=()=>i0(6,3),cu=class{constructor(t){this.mesh=new Ge(new we,t),this.mesh.frustumCulled=!1,this.mesh.visible=!1,this.#t(1024,4096),this.clear()}#t(t,e){let i=this.mesh.geometry.attributes,s=new we,r=(a,l)=>{let c=new Float32Array(l*t);i[a]&&c.set(i[a].array);let u=new He(c,l).setUsage(ef);return s.setAttribute(a,u),c};this.at=r("position",3),this.normal=r("normal",3),this.paint=r("paint",1);let o=new Uint32Array(e);this.index&&o.set(this.index),this.index=o,s.setIndex(new He(o,1).setUsage(ef)),this.mesh.geometry.dispose(),this.mesh.geometry=s}clear(){this.corners=0,this.indices=0}put(t,e,i,s,r,o,a,l,c=a){let u=this.corners,h=u+t.count;(3*h>this.at.length||this.indices+t.index.length>this.index.length)&&this.#t(2*Math.max(h,this.at.length/3),2*Math.max(this.indices+t.index.length,this.index.length));for(let d=0,f=3*u;d<3*t.count;d+=3,f+=3){let p=t.at[d+2]>0?c:a,y=p*t.at[d],g=p*t.at[d+1],m=l*t.at[d+2],x=t.normal[d]/a,w=t.normal[d+1]/a,v=t.normal[d+2]/l;for(let A=0;A<3;A++)this.at[f+A]=i[A]+s[A]*y+r[A]*g+o[A]*m,this.normal[f+A]=s[A]*x+r[A]*w+o[A]*v}this.paint.fill(e,u,h);for(let d=0;d<t.index.length;d++)this.index[this.indices+d]=u+t.index[d];this.corners=h,this.indices+=t.index.length}done(){let t=this.mesh.geometry;for(let[e,i]of[[t.attributes.position,3*this.corners],[t.attributes.normal,3*this.corners],[t.attributes.paint,this.corners],[t.index,this.indices]])e.clearUpdateRanges(),e.addUpdateRange(0,i),e.needsUpdate=!0;t.setDrawRange(0,this.indices),this.mesh.visible=this.indices>0}},yb=[1,0,0],u3=[0,1,0],vb=[0,0,1];function h3(n,t=null){let e=t&&Math.abs(n[0]*t[0]+n[1]*t[1]+n[2]*t[2])<.5?t:th(n,Math.abs(n[2])<.9?vb:yb),i=th(n,e),s=Ui(i)||1,r=i.map(o=>o/s);return[th(r,n),r]}var bf=0,wf=1,e0=2,n0=3,yl=class{constructor(t,{shadow:e=null,veil:i=!1,rim:s=null}={}){this.group=new Rn,this.veil=i,this.moving=!1,this.seen=this.shadowSeen=!0,this.arms=[],this.body=new cu(t),this.group.add(this.body.mesh),s&&(this.rim=new cu(s),this.rim.mesh.renderOrder=1,this.group.add(this.rim.mesh)),e&&(this.flat=new cu(e.material),this.flat.mesh.matrixAutoUpdate=!1,this.flat.mesh.matrix.copy(e.matrix),this.flat.mesh.renderOrder=-1,this.group.add(this.flat.mesh))}shown(t,e){t===this.seen&&e===this.shadowSeen||(this.seen=t,this.shadowSeen=e,this.show(this.arms))}hurry(t){this.moving=t,this.show(this.arms)}show(t){this.arms=t,this.body.clear();let e=this.veil?this.moving?_b:t0:this.moving?t0:c3;for(let i of this.seen?t:[])this.#t(this.body,i,e());if(this.body.done(),this.rim){this.rim.clear();for(let i of this.seen&&!this.moving?t:[])this.#t(this.rim,i,e(),{rim:!0});this.rim.done()}if(this.flat){this.flat.clear();for(let i of this.shadowSeen?t:[])this.#t(this.flat,i,this.moving?_b():t0(),{flat:!0});this.flat.done()}}#t(t,e,i,{flat:s=!1,rim:r=!1}={}){let o=this.rim&&!this.moving&&!r?e.rim:0,a=!this.veil&&!s,l=f=>this.veil?Math.max(.96*f-o,.3*f):f,c=f=>2*l(f/2),u=f=>this.veil?e.outside?n0:bf:f,h=(f,p,y,g,m,x,w,v)=>t.put(f,u(p),y,...h3(g,w),g,m,x,v),d=(f,p,y)=>t.put(i.ball,u(f),p,yb,u3,vb,y,y);for(let{a:f,b:p,r:y,far:g}of e.rods){let m=Ni(p,f),x=Ui(m),w=[(f[0]+p[0])/2,(f[1]+p[1])/2,(f[2]+p[2])/2];h(i.rod,bf,w,m.map(v=>v/x),l(y),x,null,l(g??y))}for(let{at:f,r:p}of e.balls)d(bf,f,l(p));for(let{at:f,dir:p,turned:y,r:g,h:m,beyond:x}of e.drums){if(h(i.drum,x&&a?n0:wf,f,p,l(g),c(m)),!a)continue;h(i.rod,e0,f,p,g*1.012,m*.13);let w=[0,1,2].map(v=>f[v]+y[v]*g*.96);h(i.box,bf,w,p,g*.11,m*.86,y)}for(let{at:f,dir:p,x:y,r:g,h:m,beyond:x}of e.sleeves)h(i.box,x&&a?n0:wf,f,p,l(g),c(m),y);if(e.pedestal&&!this.veil){let{at:f,dir:p,r:y,h:g}=e.pedestal;h(i.drum,wf,[f[0]+p[0]*g/2,f[1]+p[1]*g/2,f[2]+p[2]*g/2],p,y,g)}if(e.flange&&h(i.drum,wf,e.flange.at,e.flange.dir,l(e.flange.r),c(e.flange.h)),e.flange&&a){let{at:f,dir:p,turned:y,r:g,h:m}=e.flange;h(i.box,e0,[0,1,2].map(x=>f[x]+y[x]*g*.95),p,g*.16,m*1.04,y)}e.tip&&a&&d(e0,e.tip.at,e.tip.r)}};var d3=`
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
  }`,bb=`
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
  }`,f3=`
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
  }`,p3=`
  uniform float opacity;
  varying vec3 vColour;
  void main() {
    gl_FragColor = vec4(vColour, opacity);
  }`;function Mf({opacity:n=1,gloss:t=.16,veil:e=!1}={}){let i=new pi({vertexShader:e?f3:d3,fragmentShader:e?p3:bb,transparent:n<1,uniforms:{colours:{value:[0,1,2,3].map(()=>new ee)},opacity:{value:n},gloss:{value:t},sky:{value:new ee(.46,.46,.47)},ground:{value:new ee(.2,.2,.21)}}});return i.repaint=(s,r,o,a,l=o)=>{[s,r,o,l].forEach((c,u)=>i.uniforms.colours.value[u].set(c)),i.uniforms.sky.value.setScalar(a?.36:.47),i.uniforms.ground.value.setScalar(a?.1:.2)},i}function wb(){let n=new pi({vertexShader:`
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
      }`,side:oi,transparent:!0,depthWrite:!1,uniforms:{colours:{value:[new ee,new ee]}}});return n.repaint=(...t)=>t.forEach((e,i)=>n.uniforms.colours.value[i].set(e)),n}function Mb(n){let t=new pi({vertexShader:`
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
      }`,fragmentShader:bb.replace("vec3 n = normalize(vNormal),","vec3 n = normalize(gl_FrontFacing ? vNormal : -vNormal),"),side:n?ar:mi,uniforms:{colour:{value:new ee},opacity:{value:1},gloss:{value:.14},sky:{value:new ee},ground:{value:new ee}}});return t.colour=t.uniforms.colour.value,t.see=(e,i)=>{t.uniforms.opacity.value=e,t.transparent=e<1,t.uniforms.sky.value.setScalar(i?.4:.47),t.uniforms.ground.value.setScalar(i?.13:.2)},t}function s0(n,t=!1){let e=n[0].index!==null,i=new Set(Object.keys(n[0].attributes)),s=new Set(Object.keys(n[0].morphAttributes)),r={},o={},a=n[0].morphTargetsRelative,l=new we;l.morphTargetsRelative=a;let c=0;for(let u=0;u<n.length;++u){let h=n[u],d=0,f=0;if(e!==(h.index!==null))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". All geometries must have compatible attributes; make sure index attribute exists among all geometries, or in none of them."),null;for(let p in h.attributes){if(!i.has(p))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+'. All geometries must have compatible attributes; make sure "'+p+'" attribute exists among all geometries, or in none of them.'),null;r[p]===void 0&&(r[p]=[]),r[p].push(h.attributes[p]),d++}if(d!==i.size)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". Make sure all geometries have the same number of attributes."),null;if(a!==h.morphTargetsRelative)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". .morphTargetsRelative must be consistent throughout all geometries."),null;for(let p in h.morphAttributes){if(!s.has(p))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+".  .morphAttributes must be consistent throughout all geometries."),null;if(h.morphAttributes[p].length!==n[0].morphAttributes[p].length)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+'. All geometries must have the same number of morph targets for the "'+p+'" morph attribute.'),null;o[p]===void 0&&(o[p]=[]),o[p].push(h.morphAttributes[p]),f++}if(f!==s.size)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". Make sure all geometries have the same number of morph attributes."),null;if(t){let p;if(e)p=h.index.count;else if(h.attributes.position!==void 0)p=h.attributes.position.count;else return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". The geometry must have either an index or a position attribute"),null;l.addGroup(c,p,u),c+=p}}if(e){let u=0,h=[];for(let d=0;d<n.length;++d){let f=n[d].index;for(let p=0;p<f.count;++p)h.push(f.getX(p)+u);u+=n[d].attributes.position.count}l.setIndex(h)}for(let u in r){let h=Sb(r[u]);if(!h)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+u+" attribute."),null;l.setAttribute(u,h)}for(let u in o){let h=o[u][0].length;if(h!==0){l.morphAttributes=l.morphAttributes||{},l.morphAttributes[u]=[];for(let d=0;d<h;++d){let f=[];for(let y=0;y<o[u].length;++y)f.push(o[u][y][d]);let p=Sb(f);if(!p)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+u+" morphAttribute."),null;l.morphAttributes[u].push(p)}}}return l}function Sb(n){let t,e,i,s=-1,r=0;for(let c=0;c<n.length;++c){let u=n[c];if(t===void 0&&(t=u.array.constructor),t!==u.array.constructor)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.array must be of consistent array types across matching attributes."),null;if(e===void 0&&(e=u.itemSize),e!==u.itemSize)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.itemSize must be consistent across matching attributes."),null;if(i===void 0&&(i=u.normalized),i!==u.normalized)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.normalized must be consistent across matching attributes."),null;if(s===-1&&(s=u.gpuType),s!==u.gpuType)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.gpuType must be consistent across matching attributes."),null;r+=u.count*e}let o=new t(r),a=new He(o,e,i),l=0;for(let c=0;c<n.length;++c){let u=n[c];if(u.isInterleavedBufferAttribute){let h=l/e;for(let d=0,f=u.count;d<f;d++)for(let p=0;p<e;p++){let y=u.getComponent(d,p);a.setComponent(d+h,p,y)}}else o.set(u.array,l);l+=u.count*e}return s!==void 0&&(a.gpuType=s),a}var m3=Array.from({length:12},(n,t)=>[Math.cos(t*Math.PI/6),Math.sin(t*Math.PI/6)]),g3=[.75,1.5,2.4],Eb=2,Sf=4,vl=E("div",{class:"labels","aria-hidden":"true"}),uu=new Map,vo=null;function Ab(n,t){let e=uu.get(n)??[],i=t.map(({text:s,at:r,wish:o},a)=>{let l=e[a]??{el:vl.appendChild(E("span",{class:"label"})),stands:null};return l.text!==s&&(l.text=l.el.textContent=s,l.width=null),Object.assign(l,{at:r,wish:o})});for(let s of e.slice(t.length))s.el.remove();uu.set(n,i),ue()}function Rb(n){n.prepend(vl),xf(x3),K("theme",()=>{for(let t of[...uu.values()].flat())t.width=null;vo=null}),new ResizeObserver(([t])=>{vo=[t.contentRect.width,t.contentRect.height],ue()}).observe(vl)}var Ef=new V;function Cb(n){return Ef.set(...n).project(Ie),Ef.z<1?[(Ef.x+1)/2*vo[0],(1-Ef.y)/2*vo[1]]:null}var Tb=(n,t)=>Math.max(0,Math.min(n[2],t[2])-Math.max(n[0],t[0]))*Math.max(0,Math.min(n[3],t[3])-Math.max(n[1],t[1]));function x3(){vo??=[vl.clientWidth,vl.clientHeight],Ie.updateMatrixWorld();let n=[...uu.values()].flat();for(let i of n)i.point=Cb(i.at),i.width===null&&(i.width=i.el.offsetWidth,i.height=i.el.offsetHeight);let t=n.filter(i=>i.point).map(({point:[i,s]})=>[i-Sf,s-Sf,i+Sf,s+Sf]),e=[];for(let i of n){let s=i.point&&_3(i,e,t);if(i.box=s?s.box:null,i.stands=s?s.key:null,i.el.hidden=!s,!s)continue;e.push(s.box.map((o,a)=>o+(a<2?-Eb:Eb)));let r=`translate(${Math.round(s.box[0])}px, ${Math.round(s.box[1])}px)`;r!==i.where&&i.el.style.setProperty("transform",i.where=r)}}function _3({point:n,width:t,height:e,wish:i,stands:s},r,o){let[a,l]=n;if(a<0||l<0||a>vo[0]||l>vo[1])return null;let c=i&&Cb(i),u=c&&Math.hypot(c[0]-a,c[1]-l)||1,h=c?[(c[0]-a)/u,(c[1]-l)/u]:[0,-1],d=null;return g3.forEach((f,p)=>{m3.forEach(([y,g],m)=>{let x=a+y*(f*e+t/2),w=l+g*f*e*1.35,v=[x-t/2,w-e/2,x+t/2,w+e/2],A=t*e-Tb(v,[0,0,...vo]),S=[...r,...o].reduce((N,R)=>N+Tb(v,R),A),_=`${p}.${m}`,M=100*S+2*p+(1-y*h[0]-g*h[1])-(_===s?.8:0);(!d||M<d.cost)&&(d={cost:M,box:v,key:_})})}),d}var r0=()=>[...uu.values()].flat().map(({text:n,box:t,point:e})=>({text:n,box:t,point:e}));function Pb(n,t){let e=getComputedStyle(vl);n.font=`600 ${parseFloat(e.fontSize)*t}px ${e.fontFamily}`,Object.assign(n,{textAlign:"center",textBaseline:"middle",lineJoin:"round",lineWidth:4*t}),n.strokeStyle=Ft.ground,n.fillStyle=Ft.ink;for(let{text:i,box:s}of r0()){if(!s)continue;let r=[(s[0]+s[2])/2*t,(s[1]+s[3])/2*t];n.strokeText(i,...r),n.fillText(i,...r)}}var kr=uf.axes;function o0(n,t){let e=new Ci(.028,.028,.82,8).translate(0,.41,0),i=new Yo(.085,.22,12).translate(0,.9,0),s=s0([e,i]).applyMatrix4(t),r=new ee(n),o=new Float32Array(s.attributes.position.count*3);for(let a=0;a<o.length;a+=3)o.set([r.r,r.g,r.b],a);return s.setAttribute("color",new He(o,3)),s}var a0=n=>new ye().makeRotationFromQuaternion(new fn().setFromUnitVectors(new V(0,1,0),new V(...n))),v3=s0([o0(kr[0],a0([1,0,0])),o0(kr[1],a0([0,1,0])),o0(kr[2],a0([0,0,1]))]),bl=class{constructor(){this.group=new Rn,this.mesh=new Oc(v3,new Vn({vertexColors:!0,fog:!1}),64),this.mesh.frustumCulled=!1,this.mesh.count=0,this.group.add(this.mesh)}show(t,e,i=[]){this.last=[t,e];let s=new ye;this.mesh.count=t.length,t.forEach(({T:o},a)=>this.mesh.setMatrixAt(a,s.set(...o).scale(new V(e,e,e))));let r=(o,a)=>o[a+3]-e*.4*(o[a]+o[a+1]+o[a+2]);Ab(this,[...t.map(({T:o,name:a})=>({text:a,at:[o[3],o[7],o[11]],wish:[0,4,8].map(l=>r(o,l))})),...i]),this.mesh.instanceMatrix.needsUpdate=!0,this.mesh.visible=t.length>0}};var c0=180/Math.PI,Wi={angle:"deg",length:"mm"},b3={deg:"\xB0",rad:"rad",mm:"mm",m:"m"},l0={deg:c0,rad:1,mm:1e3,m:1},w3={deg:2,rad:4,mm:2,m:5},M3={deg:1,rad:.02,mm:5,m:.005},gt={get angle(){return Wi.angle},get length(){return Wi.length},set(n,t){t in l0&&n in Wi&&(Wi[n]=t)},factor:n=>n in Wi?l0[Wi[n]]:1,symbol:n=>n in Wi?b3[Wi[n]]:"",digits:n=>n in Wi?w3[Wi[n]]:4,step:n=>n in Wi?M3[Wi[n]]/l0[Wi[n]]:.01,suffix:n=>n==="angle"?{deg:c0,"\xB0":c0,rad:1}:n==="length"?{mm:1e3,m:1,cm:100}:{}};function ii(n,t){if(!Number.isFinite(n))return n===1/0?"\u221E":n===-1/0?"\u2212\u221E":"\u2013";let e=n.toFixed(t);return Number(e)===0?e.replace("-",""):e.replace("-","\u2212")}var mn=(n,t,e=gt.digits(t))=>ii(n*gt.factor(t),e),re=(n,t,e)=>`${mn(n,t,e)}${t==="angle"&&Wi.angle==="deg"?"":" "}${gt.symbol(t)}`,hu=(n,t="plain")=>String(Number((n*gt.factor(t)).toPrecision(9))+0),Tf=n=>n===0?"0":n.toExponential(0).replace("-","\u2212");function wl(n,t){let e=n.map(s=>/^[-+−]?\d*[.,](\d+)$/.exec(s.trim())?.[1].length??0);return .5*10**-(Math.max(0,...e)||gt.digits(t))/gt.factor(t)}var du=n=>n===0?"0":Math.abs(n)>=.001&&Math.abs(n)<1e4?ii(n,4):n.toExponential(2).replace("-","\u2212");var S3={standard:["theta","d","a","alpha"],modified:["alpha","a","theta","d"]},E3={theta:(n,t,e)=>`turn by \u03B8${n} = ${re(t,"angle")} about z${e}`,d:(n,t,e)=>`go d${n} = ${re(t,"length")} along z${e}`,a:(n,t)=>`go a${n} = ${re(t,"length")} along x`,alpha:(n,t)=>`turn by \u03B1${n} = ${re(t,"angle")} about x`};function Ib(n,t,e){let i=Math.floor(e/4),s=e%4+1,r=S3[n.convention],o=wr(n.joints[i],Mr(n,t)[i]),a=Object.fromEntries(r.map((l,c)=>[l,c<s?o[l]:0]));return{i,key:r[s-1],value:o[r[s-1]],A:O_(n.convention,a.a,a.alpha,a.d,a.theta)}}function Lb(){let n=E("p",{class:"step-said",role:"status","data-testid":"dh-step-said"}),t=(o,a,l)=>Ut(o,{"aria-label":a},()=>i(l())),e=()=>4*b.table.joints.length-1,i=o=>{b.dhStep=o===null||o<0?null:Math.min(o,e()),r(),lt("frames")},s=E("details",{class:"fold","data-testid":"dh-steps"},E("summary",{text:"The frames, one step at a time"}),E("div",{class:"line"},t("First","To the base",()=>0),t("Back","One step back",()=>(b.dhStep??1)-1),t("On","One step on",()=>(b.dhStep??-1)+1),t("Last","To the end",e),n));s.addEventListener("toggle",()=>i(s.open?0:null));let r=()=>{if(b.dhStep===null||!b.table.joints.length){b.dhStep=null,bt(n,"");return}b.dhStep=Math.min(b.dhStep,e());let{i:o,key:a,value:l}=Ib(b.table,b.q,b.dhStep),c=b.table.convention==="standard"?o:o+1;bt(n,`Joint ${o+1}, ${b.dhStep%4+1} of 4: ${E3[a](o+1,l,c)}`)};return K(["q","table","units"],()=>b.dhStep!==null&&r()),K("panel",o=>{o!=="table"&&b.dhStep!==null&&(s.open=!1,i(null))}),s}function Af(){let{i:n,A:t}=Ib(b.table,b.q,b.dhStep);return[...b.frames.slice(0,n+1).map((i,s)=>({T:i,name:s===0?"base":String(s)})),{T:Hn(b.frames[n],t),name:`\u2192 ${n+1}`}]}var u0=(n,t,e)=>[n[0],t[0],e[0],0,n[1],t[1],e[1],0,n[2],t[2],e[2],0,0,0,0,1],Ml=n=>[Math.cos(n),Math.sin(n)];function T3([n,t,e]){let[i,s]=Ml(e),[r,o]=Ml(t),[a,l]=Ml(n);return u0([i*r,s*r,-o],[i*o*l-s*a,s*o*l+i*a,r*l],[i*o*a+s*l,s*o*a-i*l,r*a])}function A3(n){let t=Math.hypot(n[0],n[4]),e=Math.atan2(-n[8],t);return t>1e-9?[Math.atan2(n[9],n[10]),e,Math.atan2(n[4],n[0])]:[Math.atan2(-n[6],n[5]),e,0]}function R3([n,t,e]){let[i,s]=Ml(n),[r,o]=Ml(t),[a,l]=Ml(e);return u0([i*r*a-s*l,s*r*a+i*l,-o*a],[-i*r*l-s*a,-s*r*l+i*a,o*l],[i*o,s*o,r])}function C3(n){let t=Math.hypot(n[2],n[6]);return t<1e-9?n[10]>0?[0,0,Math.atan2(n[4],n[0])]:[0,Math.PI,Math.atan2(n[4],-n[0])||0]:[Math.atan2(n[6],n[2]),Math.atan2(t,n[10]),Math.atan2(n[9],-n[8])]}function Rf(n){let t=[n[0]+n[5]+n[10],n[0]-n[5]-n[10],n[5]-n[0]-n[10],n[10]-n[0]-n[5]],e=t.indexOf(Math.max(...t)),i=2*Math.sqrt(Math.max(t[e]+1,0)),s=n[9]-n[6],r=n[2]-n[8],o=n[4]-n[1],a=n[1]+n[4],l=n[2]+n[8],c=n[6]+n[9],h=[[i/4,s/i,r/i,o/i],[s/i,i/4,a/i,l/i],[r/i,a/i,i/4,c/i],[o/i,l/i,c/i,i/4]][e],d=h[0]<0?-1:1;return h.map(f=>d*f+0)}function fu(n){let t=Math.hypot(...n);if(t<1e-9)return null;let[e,i,s,r]=n.map(o=>o/t);return u0([1-2*(s*s+r*r),2*(i*s+e*r),2*(i*r-e*s)],[2*(i*s-e*r),1-2*(i*i+r*r),2*(s*r+e*i)],[2*(i*r+e*s),2*(s*r-e*i),1-2*(i*i+s*s)])}function P3(n){let[t,e,i,s]=Rf(n),r=Math.hypot(e,i,s);return r<1e-9?[0,0,1,0]:[e/r,i/r,s/r,2*Math.atan2(r,t)]}function I3([n,t,e,i]){let s=Math.hypot(n,t,e),r=Math.sin(i/2);return s<1e-9?null:fu([Math.cos(i/2),r*n/s,r*t/s,r*e/s])}var Bs={rpy:{title:"Roll, pitch, yaw",order:"R = Rz(yaw) Ry(pitch) Rx(roll)",names:["roll","pitch","yaw"],kinds:["angle","angle","angle"],to:A3,from:T3},zyz:{title:"ZYZ Euler angles",order:"R = Rz(\u03C6) Ry(\u03B8) Rz(\u03C8)",names:["\u03C6","\u03B8","\u03C8"],kinds:["angle","angle","angle"],to:C3,from:R3},axis:{title:"Axis and angle",order:"unit axis x y z, then the turn about it",names:["x","y","z","angle"],kinds:["plain","plain","plain","angle"],to:P3,from:I3},quaternion:{title:"Quaternion",order:"order w x y z, scalar first, w \u2265 0",names:["w","x","y","z"],kinds:["plain","plain","plain","plain"],to:Rf,from:fu}};function Db(n,t,e){let i=Bs[n].from(t);return i?(i[3]=e[0],i[7]=e[1],i[11]=e[2],i):null}function Cf(n,t,e){let i=Rf(n),s=Rf(t),r=i.reduce((h,d,f)=>h+d*s[f],0);r<0&&(s=s.map(h=>-h),r=-r);let o=Math.acos(Math.min(r,1)),a=Math.sin(o),[l,c]=a<1e-7?[1-e,e]:[Math.sin((1-e)*o)/a,Math.sin(e*o)/a],u=fu(i.map((h,d)=>l*h+c*s[d]));return[3,7,11].forEach(h=>{u[h]=n[h]+e*(t[h]-n[h])}),u}var Sl=.145,Lf=.105,_0=.165,Nb={mouse:13,pen:16,touch:28},L3=.2,Mo=["x","y","z"],mu=72,ea=new Rn,If=new Map,p0="both",Df="local",y0=0,zr=!1,m0=null,nn=null,na=()=>nn!==null,kb=()=>zr,bo=null,wo=null;function zb(){ea.visible=!1,en.add(ea),xf(v0),wo=document.getElementById("view"),bo=E("output",{class:"gizmo-readout","data-testid":"gizmo-readout",hidden:!0}),document.getElementById("overlay").append(bo),wo.addEventListener("pointerdown",k3,!0),wo.addEventListener("pointermove",H3,!0);for(let n of["pointerup","pointercancel"])wo.addEventListener(n,Yb,!0);addEventListener("keydown",n=>n.key==="Escape"&&nn&&V3()),K(["target","theme"],ue)}function pu(n,t,e=8){let i=new Vn({color:t,depthTest:!1,depthWrite:!1,transparent:!0,opacity:.95,fog:!1}),s=new Ge(n,i);return s.renderOrder=e,s.frustumCulled=!1,s.userData.colour=t,s}var D3=[new fn().setFromUnitVectors(new V(0,1,0),new V(1,0,0)),new fn,new fn().setFromUnitVectors(new V(0,1,0),new V(0,0,1))],N3=[new fn().setFromUnitVectors(new V(0,0,1),new V(1,0,0)),new fn().setFromUnitVectors(new V(0,0,1),new V(0,1,0)),new fn];function U3(){if(If.size)return;let n=(t,e)=>{If.set(t,e),ea.add(e)};Mo.forEach((t,e)=>{let i=new Ci(.0032,.0032,Sl*.8,8).translate(0,Sl*.45,0),s=new Yo(.0125,.034,14).translate(0,Sl*.9,0),r=new Rn;r.add(pu(i,kr[e]),pu(s,kr[e])),r.userData.turn=D3[e],n(`move-${t}`,r);let o=pu(new ol(Lf,.0026,6,mu),kr[e],7);o.userData.turn=N3[e],n(`turn-${t}`,o)}),n("turn-view",pu(new ol(_0,.0022,6,mu),"#8891a0",7)),n("move-view",pu(new Ns(.0115,14,10),"#8891a0",9))}var Pf=new V,So=new V,h0=new fn;function Nf(){return 2*Math.tan(yo.degToRad(Ie.fov/2))*Ie.position.distanceTo(Pf)}var xu=()=>Df==="world"?[0,1,2].map(n=>[0,1,2].map(t=>+(n===t))):O3(),O3=()=>[0,1,2].map(n=>Ks(b.target,n)),F3=new ye;function v0(){if(ea.visible=zr,!zr)return;Pf.set(...te(b.target)),So.copy(Ie.position).sub(Pf).normalize(),Df==="world"?h0.identity():h0.setFromRotationMatrix(F3.set(...b.target)),ea.position.copy(Pf),ea.scale.setScalar(Nf());let n=xu();for(let[t,e]of If){let[i,s]=t.split("-"),r=Mo.indexOf(s),o=p0==="both"||p0===i;e.visible=o&&B3(i,n[r])&&(!nn||nn.name===t),s==="view"?e.quaternion.copy(Ie.quaternion):e.quaternion.copy(h0).multiply(e.userData.turn);let a=t===(nn?.name??m0);e.traverse(l=>l.material?.color.set(a?Ft.accent:l.userData.colour))}}function B3(n,t){return!t||n!=="move"?!0:Math.hypot(...Hb(t,So.toArray()))>L3}var Hb=(n,t)=>[n[1]*t[2]-n[2]*t[1],n[2]*t[0]-n[0]*t[2],n[0]*t[1]-n[1]*t[0]],gu=(n,t)=>te(b.target).map((e,i)=>e+t*n[i]);function g0(n,t){let e=xu(),[i,s]=n<0?[Ub(Ie.matrixWorld,0),Ub(Ie.matrixWorld,1)]:[e[(n+1)%3],e[(n+2)%3]];return Array.from({length:mu+1},(r,o)=>{let a=2*Math.PI*o/mu,l=i.map((c,u)=>Math.cos(a)*c+Math.sin(a)*s[u]);return{p:gu(l,t),front:n<0||l.reduce((c,u,h)=>c+u*So.getComponent(h),0)>-.15}})}var Ub=(n,t)=>[n.elements[4*t],n.elements[4*t+1],n.elements[4*t+2]];function Ob(n,t,[e,i],[s,r]){let o=s-e,a=r-i,l=o*o+a*a,c=l>0?Math.min(Math.max(((n-e)*o+(t-i)*a)/l,0),1):0;return Math.hypot(n-e-c*o,t-i-c*a)}function x0(n,t){let e=Nf(),i=[];for(let[s,r]of If){if(!r.visible)continue;let[o,a]=s.split("-"),l=Mo.indexOf(a),c=1/0;if(o==="move"&&l<0){let[u,h]=Vi(te(b.target));c=Math.hypot(n-u,t-h)-3}else if(o==="move"){let u=xu()[l],h=Vi(gu(u,.92*Sl*e));c=Math.min(Ob(n,t,Vi(gu(u,.3*Sl*e)),h),Math.hypot(n-h[0],t-h[1])-4)}else{let u=g0(l,(l<0?_0:Lf)*e).map(h=>({...h,s:Vi(h.p)}));for(let h=0;h<mu;h++)u[h].front&&(c=Math.min(c,Ob(n,t,u[h].s,u[h+1].s)+(l<0?2:0)))}i.push([s,c])}return i.sort((s,r)=>s[1]-r[1])}function Gb(n){if(!zr)return null;v0();let[t]=x0(n.clientX,n.clientY);return t&&t[1]<=(Nb[n.pointerType]??Nb.mouse)?t[0]:null}function Vb(){if(!zr)return{};v0();let n=Nf(),t=xu(),e={"move-view":Vi(te(b.target))};return Mo.forEach((i,s)=>{let o=[.92,.85,.75,.6,.5].map(c=>Vi(gu(t[s],c*Sl*n))).find(([c,u])=>x0(c,u)[0]?.[0]===`move-${i}`);o&&(e[`move-${i}`]=o);let l=g0(s,Lf*n).filter(c=>c.front).map(c=>Vi(c.p)).filter(([c,u])=>x0(c,u)[0]?.[0]===`turn-${i}`);l.length&&(e[`turn-${i}`]=l[Math.floor(l.length/2)])}),e["turn-view"]=Vi(g0(-1,_0*n)[9].p),e}var Fb=new qc,Bb=new Qt;function Wb(n){let t=ss.domElement.getBoundingClientRect();return Bb.set((n.clientX-t.x)/t.width*2-1,1-(n.clientY-t.y)/t.height*2),Fb.setFromCamera(Bb,Ie),Fb.ray}function $b(n,t,e){let{origin:i,direction:s}=Wb(e),r=new V(...n),o=new V(...t).sub(i),a=r.dot(s),l=1-a*a;return l<1e-6?0:(a*s.dot(o)-r.dot(o))/l}function qb(n,t,e){let i=new ri().setFromNormalAndCoplanarPoint(n,new V(...t));return Wb(e).intersectPlane(i,new V)}function k3(n){if(n.button!==0)return;let t=Gb(n);if(!t)return;n.stopPropagation(),n.preventDefault(),wo.focus({preventScroll:!0}),wo.setPointerCapture(n.pointerId),pn.enabled=!1;let[e,i]=t.split("-"),s=Mo.indexOf(i),r=s<0?So.toArray():xu()[s].slice();nn={name:t,what:e,axis:r,i:s,T:b.target.slice(),x:n.clientX,y:n.clientY,total:0,before:null},nn.start=e==="turn"?Xb(n):s<0?qb(So,te(nn.T),n):$b(r,te(nn.T),n),ue()}function Xb(n){let[t,e]=Vi(te(nn.T)),i=nn.axis.reduce((h,d,f)=>h+d*So.getComponent(f),0);if(Math.abs(i)>.3)return-Math.sign(i)*Math.atan2(n.clientY-e,n.clientX-t);let s=Hb(nn.axis,So.toArray()),r=Nf(),o=Vi(te(nn.T)),a=Vi(gu(s,Lf*r)),l=a[0]-o[0],c=a[1]-o[1],u=Math.hypot(l,c)||1;return((n.clientX-nn.x)*l+(n.clientY-nn.y)*c)/(u*u)}var z3=n=>Math.atan2(Math.sin(n),Math.cos(n)),d0=(n,t,e)=>{let i=y0||(t.shiftKey?5:0);return i?Math.round(n/(i*e))*i*e:n};function H3(n){if(!nn){if(n.buttons||!zr)return;let l=Gb(n);l!==m0&&(m0=l,wo.style.setProperty("cursor",l?"grab":""),ue());return}n.stopPropagation();let{T:t,axis:e,what:i,i:s}=nn,r=Df==="world"||s<0?"":"tool ",o=t.slice(),a;if(i==="turn"){let l=Xb(n);nn.total+=z3(l-(nn.before??nn.start)),nn.before=l;let c=d0(nn.total,n,Math.PI/180),u=Math.sin(c/2);o=Hn(fu([Math.cos(c/2),u*e[0],u*e[1],u*e[2]]),t);for(let h of[3,7,11])o[h]=t[h];a=`${f0(c,"angle")} about ${s<0?"the line of sight":r+Mo[s]}`}else if(s<0){let l=qb(So,te(t),n);if(!l)return;let c=l.sub(nn.start);(y0||n.shiftKey)&&c.set(...c.toArray().map(u=>d0(u,n,.001))),[3,7,11].forEach((u,h)=>{o[u]=t[u]+c.getComponent(h)}),a=c.toArray().map((u,h)=>`${Mo[h]} ${f0(u,"length")}`).join(", ")}else{let l=d0($b(e,te(t),n)-nn.start,n,.001);[3,7,11].forEach((c,u)=>{o[c]=t[c]+l*e[u]}),a=`${f0(l,"length")} along ${r}${Mo[s]}`}Si(o,"drag"),G3(a,n),ue()}var f0=(n,t)=>`${n>=0?"+":""}${re(n,t,gt.digits(t))}`;function G3(n,t){let e=wo.getBoundingClientRect();bo.hidden=!1,bt(bo,n),bo.style.setProperty("left",`${Math.min(t.clientX-e.x+18,e.width-bo.offsetWidth-8)}px`),bo.style.setProperty("top",`${Math.max(t.clientY-e.y-34,8)}px`)}function Yb(n){nn&&(n.stopPropagation(),nn=null,bo.hidden=!0,pn.enabled=!0,Si(b.target,"dropped"),ue())}function V3(){let{T:n}=nn;Si(n,"drag"),Yb({stopPropagation(){}})}function jb(){zr&&U3(),ea.visible=zr,lt("frames"),ue()}function Zb(n){zr=n,jb()}function Jb(n){p0=n,jb()}function Kb(n){Df=n,ue()}function Qb(n){y0=n}var sw=Mf(),ew=[.32,-.4,1],kf=new Vn({color:"#000",transparent:!0,opacity:.1,side:mi,depthWrite:!1,fog:!1,stencilWrite:!0,stencilFunc:gg,stencilRef:1,stencilZPass:mg,polygonOffset:!0,polygonOffsetFactor:-1,polygonOffsetUnits:-1}),E0=new ye().set(1,0,-ew[0],0,0,1,-ew[1],0,0,0,0,5e-4,0,0,0,1),El=new Ge(new zc(1,40),new pi({transparent:!0,depthWrite:!1,polygonOffset:!0,polygonOffsetFactor:-1,polygonOffsetUnits:-1,uniforms:{strength:{value:.3}},vertexShader:"varying vec2 at; void main() { at = position.xy; gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }",fragmentShader:"uniform float strength; varying vec2 at; void main() { float d = 1.0 - length(at); gl_FragColor = vec4(0.0, 0.0, 0.0, strength * d * d); }"}));El.renderOrder=-1;function W3(){let n=b.frames[0],t=2*(ks.radius[0]??0);El.visible=b.table.joints.length>0&&Math.abs(n[11])<.02*ks.size&&n[10]>.99,El.position.set(n[3],n[7],4e-4*ks.size),El.scale.set(1.6*t,1.6*t,1)}var vu=new yl(sw,{shadow:{material:kf,matrix:E0}});function rw(n,t){vu.shown(n,n&&!t)}var w0=.1,T0=Mf({opacity:w0,veil:!0}),ow=wb(),yu=new yl(T0,{veil:!0,rim:ow}),aw=Mf({opacity:.62,gloss:.1}),M0=new yl(aw,{veil:!0}),A0=new bl,ks=vf(b.table),zf=[],Ff=null;function lw(){en.add(El,vu.group,yu.group,M0.group,A0.group),yu.group.renderOrder=1,K("table",n=>{ks=vf(b.table),jg(ks.size),zf=[],Ff=null,C0(),Wf(),n==="new"&&bu({instant:!0,view:"iso"}),ub()}),K("q",$3),K("frames",hw),K("theme",iw),K("hurry",n=>{T0.uniforms.opacity.value=n?2*w0:w0;for(let t of[vu,yu,M0])t.hurry(n)}),iw()}var nw=new Map,S0=[],b0=0;function Gr(n,t){if(nw.set(n,t),S0=[...nw.values()].flat(),!b.table.joints.length)return;let e=b0;b0=S0.length,yf(Gf()),t.length?R0():e>b0&&cw()}var Bf=()=>[],Uf=0;function Hf(n){let t=Uf;Bf=n,Uf=Bf(b.frames).length,b.table.joints.length&&(yf(Gf()),Uf<t?cw():Uf&&R0())}var Gf=()=>[...Qg(b.table,b.frames),...Bf(b.frames),...S0],cw=er(mb,120);function uw(n,t){let e=Math.max(1,Math.floor(t.length/24)),i=t.filter((s,r)=>r%e===0||r===t.length-1);Gr("motion",i.flatMap(s=>{let r=As(n,s);return[...Qg(n,r),...n===b.table?Bf(r):[]]}))}function bu(n){_f(Gf(),n)}var R0=er(xl,220);function $3(){let n=b.frames;vu.show(b.table.joints.length?[Jg(b.table,n,ks,b.q)]:[]),W3(),yf(Gf()),R0(),_w&&X3(te(n[n.length-1])),hw()}function hw(){let n=(b.shownFrames??[]).filter(t=>t<b.frames.length&&!(t===b.frames.length-1&&kb())).map(t=>({T:b.frames[t],name:Vf(t)}));A0.show(b.dhStep===null?n:Af(),ks.size*Kg),ue()}var dw=()=>vu.arms.flatMap(n=>[...n.drums,...n.sleeves].filter(t=>t.beyond).map(t=>t.joint+1)),fw=()=>(A0.last?.[0]??[]).map(n=>n.name);function Vf(n){let t=b.table.joints.length;return n===0?"base":n===t+1?"tool":String(n)}function pw(n){zf=n,C0()}function gs(n){Ff=n,C0()}var mw=()=>zf.length,gw=()=>yu.arms.filter(n=>n.outside).length,q3=.0035;function C0(){let n=t=>({...Jg(b.table,As(b.table,t),ks),outside:b.table.joints.some((e,i)=>lu(e,t[i])),rim:q3*ks.size});yu.show(zf.map(n)),M0.show(Ff?[n(Ff)]:[]),ue()}var xw=6e3,Of=new Float32Array(6*xw),Hr=new qo(new we,new es({fog:!1}));Hr.geometry.setAttribute("position",new He(Of,3));Hr.frustumCulled=!1;Hr.visible=!1;var Eo=0,_w=!0,_u=null;en.add(Hr);function X3(n){let t=_u?Ui(Ni(n,_u)):1/0;t<ks.size*.002||(t<ks.size*.2&&(Eo===xw&&(Of.copyWithin(0,6*1e3),Eo-=1e3),Of.set(_u,6*Eo),Of.set(n,6*Eo+3),Eo+=1,Hr.geometry.setDrawRange(0,2*Eo),Hr.geometry.attributes.position.needsUpdate=!0,Hr.visible=!0),_u=n)}function yw(n){_w=n,n||Wf(),ue()}function Wf(){Eo=0,_u=null,Hr.visible=!1,ue()}var vw=()=>Eo,wu=new rr(new we,new es({fog:!1}));wu.frustumCulled=!1;var Mu=new Nr(new we,new or({size:4,sizeAttenuation:!1,fog:!1}));Mu.frustumCulled=!1;wu.visible=Mu.visible=!1;en.add(wu,Mu);function ia(n){Gr("path",n);let t=new Float32Array(n.flat());for(let e of[wu,Mu])e.geometry.dispose(),e.geometry=new we,e.geometry.setAttribute("position",new He(t,3)),e.visible=n.length>0;ue()}function iw(){sw.repaint(Ft.link,Ft.joint,Ft.accent,Ft.dark,Ft.wrong),T0.repaint(Ft.ghost,Ft.ghost,Ft.ghost,Ft.dark,Ft.wrong),ow.repaint(Ft.ghost,Ft.wrong),aw.repaint(Ft.accent,Ft.accent,Ft.accent,Ft.dark),Hr.material.color.set(Ft.accent),wu.material.color.set(Ft.trace),Mu.material.color.set(Ft.trace),kf.opacity=Ft.dark?.28:.11,El.material.uniforms.strength.value=Ft.dark?.75:.34,ue()}var pe={follow:!0,ghosts:"all",task:null,redundancy:null},I0={answers:0},Yf=0,P0=0,$f=null,sa=()=>b.solutions!==null&&P0===Yf,ww=()=>sa()&&!b.solutions.brief&&b.solutions.self_motions!==null&&$f===null,qf=io(()=>{ra(),lt("late")}),Tl=qf.late,Xf=!1,Mw=Qs(async()=>{let n=Xf;Xf=!1;let t=Yf,e=b.target,i=b.table;try{let s=na()||L0,r=s?null:b.digits,{task:o,redundancy:a}=pe,l=await Oe("ik",{T:e,q:b.q,brief:s,task:o,redundancy:a,digits:r});if(i!==b.table||e!==b.target&&!s)return;I0.answers+=1,P0=t,b.solutions={...l,T:e,brief:s},qf(!sa()&&!s),n&&pe.follow&&l.nearest&&Oi(l.nearest,"follow"),ra(),lt("solutions"),!s&&!l.rows.some(c=>c.inside)&&Z3($f=e),l.self_motions===null&&!s&&j3(b.solutions)}catch(s){if(fc(s))return;P0=t,b.solutions={rows:[],self_motions:[],status:"REFUSED",why:s.message,nearest:null},qf(!sa()),ra(),lt("solutions")}}),L0=!1;function Sw(){L0=!0,Xf=!0,Yf+=1,Mw()}function zs({follow:n=!1}={}){L0=!1,Xf||=n,Yf+=1,na()||qf(!0),lt("asked"),Mw()}function bw(){b.solutions&&(b.solutions=null,lt("solutions"))}var j3=Qs(async n=>{try{let t={T:n.T,q:b.q,task:pe.task,redundancy:pe.redundancy},{self_motions:e}=await Oe("self_motions",t);if(b.solutions!==n||!e)return;n.self_motions=e,lt("solutions")}catch(t){if(fc(t)||b.solutions!==n)return;n.self_motions=[],n.untraced=t.message,lt("solutions")}}),Z3=Qs(async n=>{try{let t=await Oe("nearest",{T:n,task:pe.task});b.solutions&&b.solutions.T===n&&(b.solutions.near=t,lt("solutions"))}catch{}finally{$f===n&&($f=null)}}),J3=(n,t)=>n.every((e,i)=>Math.abs(Math.atan2(Math.sin(e-t[i]),Math.cos(e-t[i])))<1e-6||Math.abs(e-t[i])<1e-9);function ra(){let n=b.solutions?.rows??[],t=b.panel==="inverse"&&pe.ghosts!=="none"&&!Tl()?n.filter(e=>(pe.ghosts==="all"||e.inside)&&!J3(e.q,b.q)):[];pw(t.map(e=>e.q))}function Ew(){K("target",n=>{b.panel==="inverse"?zs({follow:H_.has(n)}):bw()}),K("task",()=>{lt("plan"),b.panel==="inverse"&&b.hasTarget?zs():bw()}),K("panel",n=>{gs(null),n==="inverse"&&b.hasTarget&&!sa()&&zs(),ra()}),K("moving",n=>{n||ra()}),K("table",n=>{pe.redundancy=null,n==="new"&&(pe.task=null),lt("solutions"),n!=="new"&&b.panel==="inverse"&&b.hasTarget&&zs()}),K("online",n=>{n&&b.panel==="inverse"&&b.hasTarget&&b.table.joints.length&&zs()})}var Su=0;function xi(){Su+=1,b.moving&&(b.moving=!1,lt("moving",!1))}function Ii(n,t=.8,e="move to a posture"){xi(),lt("let-go"),lt("did",{label:e});let i=b.q.slice(),s=Su,r=performance.now();return matchMedia("(prefers-reduced-motion: reduce)").matches&&(t=0),b.moving=!0,lt("moving",!0),new Promise(o=>{(function a(l){if(s!==Su||i.length!==b.q.length){o(!1);return}let c=t>0?Math.min(Math.max((l-r)/(1e3*t),0),1):1,u=c**3*(10-15*c+6*c*c);Oi(c<1?i.map((h,d)=>h+u*(n[d]-h)):n.slice(),"move"),c<1?requestAnimationFrame(a):(b.moving=!1,lt("moving",!1),o(!0))})(r)})}function Tw(n,t,e,i){xi();let s=Su,r=performance.now()-1e3*n*t;b.moving=!0,lt("moving",!0),requestAnimationFrame(function o(a){if(s!==Su){i?.(!1);return}let l=Math.min(Math.max((a-r)/(1e3*n),0),1);e(l),l<1?requestAnimationFrame(o):(b.moving=!1,lt("moving",!1),i?.(!0))})}var Q3=200,t2=1500,oa=[],Au=[],Tu=null,Eu={key:null,at:0,open:!1},D0=!1,jf=()=>({table:b.table,q:b.q,target:b.target,digits:b.digits,hasTarget:b.hasTarget,path:{...b.path},sequence:structuredClone(b.sequence),program:b.program,world:b.world,limits:b.limits,start:b.start,routing:b.routing,task:pe.task,redundancy:pe.redundancy});function N0(){D0||(D0=!0,queueMicrotask(()=>{D0=!1,Tu=jf()}))}var Al=null;function Ru(n,t){aa(),Al={label:n,open:!0};try{t()}finally{Al=null,aa()}}function e2(n){let{label:t,key:e=Symbol(t),open:i=!1}=Al?{...Al,key:Al}:n,s=performance.now();!(e===Eu.key&&(Eu.open||s-Eu.at<t2))&&Tu&&(oa.push({label:t,before:Tu}),oa.length>Q3&&oa.shift(),Au.length=0),Eu={key:e,at:s,open:i},N0(),lt("history")}function aa(){Al||(Eu={key:null,at:0,open:!1})}function n2(n){xi(),aa(),pe.task=n.task,n.table!==b.table?yn(n.table,{q:n.q,step:!1,what:"undo"}):Oi(n.q,"undo"),pe.redundancy=n.redundancy,Object.assign(b.path,n.path),b.sequence=structuredClone(n.sequence),b.program=n.program,b.world=n.world,b.limits=n.limits,b.start=n.start;let t=b.routing!==n.routing;b.routing=n.routing,b.hasTarget=n.hasTarget,n.target!==b.target&&Si(n.target,"restored",n.digits);for(let e of["path-loaded","sequence-loaded","program","world","task"])lt(e,"undo");t&&lt("routing","undo")}function Aw(n,t,e){let i=n.pop();if(!i)return;let s=jf();n2(i.before),t.push({label:i.label,before:s}),N0(),lt("history"),de(`${e}: ${i.label}`)}var U0=()=>Aw(oa,Au,"Undone"),O0=()=>Aw(Au,oa,"Redone"),Zf=()=>oa.at(-1)?.label??null,Jf=()=>Au.at(-1)?.label??null;function Kf(){oa.length=0,Au.length=0,aa(),Tu=jf(),lt("history")}function Rw(){Tu=jf(),K("did",e2),K("let-go",aa),K(["table","q","target","path","sequence","program","world","task","routing","panel"],N0)}var s2=[[64.3,"tablet"],[87.33,"narrow"],[103.02,"usual"]],r2=n=>ou()*Math.min(Math.max(14,8+.005*n),28),F0=()=>document.documentElement.dataset.layout;function Cw(){let n=innerWidth/r2(innerWidth),t=s2.find(([e])=>n<=e)?.[1]??"pinned";t!==F0()&&(document.documentElement.dataset.layout=t,lt("layout"))}function Pw(){Cw(),addEventListener("resize",Cw)}var B0={sqrt:Math.sqrt,sin:Math.sin,cos:Math.cos,tan:Math.tan,asin:Math.asin,acos:Math.acos,atan:Math.atan,abs:Math.abs},Iw={pi:Math.PI,\u03C0:Math.PI,tau:2*Math.PI},Qf=/\s*(?:(\d+\.?\d*(?:[eE][+-]?\d+)?|\.\d+(?:[eE][+-]?\d+)?)|([A-Za-zπ°]+)|(\*\*|[-+*/^()−·]))/y,Lw=80;function a2(n){let t=[];Qf.lastIndex=0;let e=n.trimEnd();for(;Qf.lastIndex<e.length;){let i=Qf.lastIndex,s=Qf.exec(e);if(!s)throw new Error(`cannot read \u201C${e.slice(i).trim().slice(0,8)}\u201D at character ${i+1}`);s[1]!==void 0?t.push({number:Number(s[1]),text:s[1]}):s[2]!==void 0?t.push({word:s[2]}):t.push({sign:{"\u2212":"-","\xB7":"*","**":"^"}[s[3]]??s[3]})}return t}function l2(n){if(!n.includes(","))return n;if(n.includes(".")||/\d,\d*,/.test(n))throw new Error("a comma is the decimal sign here: leave out the ones between thousands");return n.replace(/(\d),(?=\d)|(\d),(?!\d)|(^|\D),(?=\d)/g,"$1$2$3.")}function Rl(n,t="plain"){let e=l2(String(n));if(e.length>Lw)throw new Error(`longer than ${Lw} characters`);let i=a2(e);if(!i.length)throw new Error("empty: type a number, or an expression such as pi/2");let s=null,r=i[i.length-1];i.length>1&&r.word&&r.word in gt.suffix(t)&&(s=gt.suffix(t)[r.word],i.pop());let o=0,a=!1,l=m=>i[o]?.sign===m,c=m=>{if(!l(m))throw new Error(`\u201C${m}\u201D is missing`);o++};function u(){let m=h();for(;l("+")||l("-");){let x=i[o++].sign,w=h();m=x==="+"?m+w:m-w}return m}function h(){let m=d();for(;;)if(l("*"))o++,m*=d();else if(l("/"))o++,m/=d();else if(i[o]?.word||l("("))m*=f();else return m}function d(){return l("-")?(o++,-d()):l("+")?(o++,d()):f()}function f(){let m=p();return l("^")?(o++,m**d()):m}function p(){let m=i[o];if(!m)throw new Error("something is missing at the end");if(o++,m.number!==void 0)return m.number;if(m.sign==="("){let x=u();return c(")"),x}if(m.word){let x=m.word.toLowerCase();if(Object.hasOwn(Iw,x))return a=!0,Iw[x];if(Object.hasOwn(B0,x)){c("(");let w=u();return c(")"),B0[x](w)}throw new Error(`\u201C${m.word.slice(0,20)}\u201D is not known; allowed are pi, ${Object.keys(B0).join(", ")}`)}throw new Error(`\u201C${m.sign}\u201D is not expected here`)}let y=u();if(o<i.length)throw new Error(`\u201C${i[o].sign??i[o].word??i[o].text}\u201D is not expected here`);if(!Number.isFinite(y))throw new Error("not a finite number");let g=s??(t==="angle"&&a?1:gt.factor(t));return{value:y/g+0,symbolic:a||s!==null||i.length>2}}function wn({label:n,kind:t="plain",input:e,commit:i,empty:s,testid:r,title:o,check:a,key:l=r}){let c=typeof t=="function"?t:()=>t,u=E("input",{type:"text",class:"number",inputmode:"decimal",autocomplete:"off",spellcheck:"false","aria-label":n,"data-testid":r,title:o});u.key=l,u.mayBeEmpty=s!==void 0;let h=null,d=null,f="",p=!1,y=!1,g=()=>{if(u.value.trim()===""&&s!==void 0)return{value:s,symbolic:!1};let _=Rl(u.value,c()),M=a?.(_.value);if(M)throw new Error(M);return _},m=(_,M=!0)=>{u.classList.toggle("wrong",!!_),_?(u.setAttribute("aria-invalid","true"),u.title=_):(u.removeAttribute("aria-invalid"),u.title=o??""),M&&k0(u,_),u.dispatchEvent(new CustomEvent("verdict",{bubbles:!0,detail:_?{label:n,reason:_}:null}))},x=_=>{y=!1;try{let M=g();return m(null),_&&(h=M.value,d=M.symbolic?u.value.trim():null),_?.(M.value,{symbolic:M.symbolic,text:u.value.trim()}),!0}catch(M){return m(M.message),!1}};u.addEventListener("input",()=>{p=!0,x(e)}),u.addEventListener("change",()=>{p=!1,i||!e?x(i):y&&S(),lt("let-go")});let w="",v=()=>{try{g(),w=u.value}catch{}};u.addEventListener("focus",()=>{v(),u.classList.contains("wrong")&&k0(u,u.title),u.select()}),u.addEventListener("blur",()=>{p=!1,y&&S(),k0(u,null)}),u.addEventListener("keydown",_=>{let M=u.closest("table.dh");if(_.key==="Escape"&&u.value!==w){_.preventDefault(),u.value=w,p=!1,x(i??e),u.select();return}if(M&&h2(u,_))return;let N={ArrowUp:1,ArrowDown:-1}[_.key];if(_.key==="Enter"&&(p=!1,v(),u.select()),!(!N||M&&!_.altKey)){_.preventDefault();try{let R=g();u.value=hu((R.value??0)+N*gt.step(c())*(_.shiftKey?.1:1),c()),x(i??e)}catch{}}});let A=()=>u.classList.contains("wrong"),S=()=>{y=!1,f=d??(h==null?"":hu(h,c())),u.value=f,z0(u),A()&&m(null)};return u.put=(_,M=null,N=!1)=>{let R=_===h&&!N,L=R&&M===d;h=_,d=M;let z=document.activeElement===u&&!u.readOnly;if(z&&(p||A())){y||=!R;return}if(L&&(z||A()||u.value===f))return;let G=z&&u.selectionStart===0&&u.selectionEnd===u.value.length;S(),w=u.value,G&&u.select()},u.giveUp=S,u.leave=_=>{u.value=_;try{g()}catch(M){m(M.message,!1)}},u.addEventListener("input",()=>z0(u)),u2.observe(u),u.refresh=()=>{!A()&&document.activeElement!==u&&S()},u}function $i(n,t){rh(n,()=>c2(n,t))}function Dw(n){for(let t of n.querySelectorAll(".number.wrong"))t.giveUp()}function c2(n,t){let e=[...n.querySelectorAll(".number.wrong")];if(t(),!e.length)return;let i=new Map([...n.querySelectorAll(".number")].map(o=>[o.key,o])),r=e.filter(o=>{let a=i.get(o.key);return a&&a!==o&&a.leave(o.value),!a}).map(o=>`${o.getAttribute("aria-label")} (\u201C${o.value}\u201D)`).join(", ");r&&de(`Could not be read and is given up: ${r}.`,"wrong")}var u2=new ResizeObserver(n=>requestAnimationFrame(()=>n.forEach(({target:t})=>{let e=parseFloat(getComputedStyle(t).fontSize);t.sure=t.shrunk?0:Math.floor((t.clientWidth-14)/(.8*e)),z0(t)})));function z0(n){if(n.value.length<=n.sure&&!n.shrunk)return;let t=n.clientWidth;if(!t||(n.style.removeProperty("font-size"),n.shrunk=!1,n.scrollWidth<=t))return;let e=parseFloat(getComputedStyle(n).fontSize);n.style.setProperty("font-size",`${Math.max(.5*e,e*(t-14)/(n.scrollWidth-14)).toFixed(2)}px`),n.shrunk=!0}var Li=null;function k0(n,t){if(!t){Li&&Li.about===n&&(Li.hidden=!0),n.removeAttribute("aria-describedby");return}Li||(Li=E("div",{class:"why",id:"why",role:"alert","data-testid":"why"}),document.body.append(Li)),Li.about=n,Li.hidden=!1,Li.textContent!==t&&(Li.textContent=t),n.setAttribute("aria-describedby","why");let e=n.getBoundingClientRect();Li.style.setProperty("top",`${e.bottom+4}px`),Li.style.setProperty("left",`${Math.max(8,Math.min(e.left,innerWidth-Li.offsetWidth-8))}px`)}addEventListener("scroll",()=>Li&&(Li.hidden=!0),!0);function h2(n,t){let e=n.selectionStart===0&&n.selectionEnd===n.value.length,i={ArrowUp:-1,ArrowDown:1,Enter:t.shiftKey?-1:1}[t.key],s={ArrowLeft:e||n.selectionEnd===0?-1:0,ArrowRight:e||n.selectionStart===n.value.length?1:0}[t.key]??0;if(t.altKey||t.ctrlKey||t.metaKey||!i&&!s)return!1;let r=[...n.closest("tbody").rows].map(c=>[...c.querySelectorAll("input.number")]),o=r.findIndex(c=>c.includes(n)),a=r[o].indexOf(n),l=r[o+(i??0)]?.[a+s];return t.key==="Enter"&&n.dispatchEvent(new Event("change")),l?(t.preventDefault(),l.focus(),!0):t.key!=="Enter"}var Uw=1,Ow=30;function Cl(){let{table:n,q:t,target:e,hasTarget:i,notation:s,shownFrames:r,path:o,sequence:a,panel:l,theme:c}=b;return{pieper:Uw,table:n,q:t,target:i?e:null,digits:i?b.digits:null,task:pe.task,redundancy:pe.redundancy,follow:pe.follow,ghosts:pe.ghosts,notation:s,frames:r,path:o,sequence:a,program:{steps:b.program,start:b.start,limits:b.limits},world:b.world,routing:b.routing,look:b.look,panel:l,theme:c,units:[gt.angle,gt.length],camera:_l()}}var Xn=n=>typeof n=="number"&&Number.isFinite(n)&&Math.abs(n)<1e7,ys=(n,t)=>Array.isArray(n)&&n.length===t&&n.every(Xn),xs=(n,t)=>typeof n=="string"?n.slice(0,t):"",_s=n=>{if(!ys(n,16))return null;let t=eh(n);return t<1e-12?n.slice():t<.001?nh(n):null},d2=n=>n&&Xn(n.metres)&&Xn(n.radians)?{metres:n.metres,radians:n.radians}:null,f2=n=>n&&[n.lower,n.upper,n.value].every(Xn)&&n.lower<=n.upper?{name:xs(n.name,40),lower:n.lower,upper:n.upper,value:n.value,unit:xs(n.unit,10)}:null,p2=(n,t)=>Array.isArray(n)&&n.length===t&&n.every(e=>ys(e,t))?n:null;function m2(n){if(!n||!Array.isArray(n.joints)||n.joints.length>Ow||!["standard","modified"].includes(n.convention))return null;let t=n.joints.map((i,s)=>{if(!i||!["a","alpha","d","theta","offset"].every(o=>Xn(i[o]))||!["R","P"].includes(i.type)||![1,-1].includes(i.sign))return null;let r=Object.fromEntries(Object.entries(i.text??{}).filter(([,o])=>typeof o=="string"&&o.length<80));return{name:xs(i.name,40)||`joint_${s+1}`,type:i.type,a:i.a,alpha:i.alpha,d:i.d,theta:i.theta,lower:Xn(i.lower)?i.lower:null,upper:Xn(i.upper)?i.upper:null,sign:i.sign,offset:i.offset,text:r}});if(t.includes(null))return null;let e=Object.fromEntries(Object.entries(n.postures??{}).filter(([,i])=>ys(i,t.length)).slice(0,40));return{name:xs(n.name,60),convention:n.convention,joints:t,base:_s(n.base)??Ji(),tool:_s(n.tool)??Ji(),postures:e,manufacturer:xs(n.manufacturer,200),source:xs(n.source,2e3),notes:xs(n.notes,3e3),actuator:f2(n.actuator),catalog:xs(n.catalog,60)||void 0,derived:xs(n.derived,60)||void 0,coupling:p2(n.coupling,t.length)}}var Nw={joint:0,line:0,circle:0,spline:0,frame:0,call:0,wait:"seconds",gripper:"value",output:"port"};function g2(n,t){if(!n||!Object.hasOwn(Nw,n.kind))return null;let e=Nw[n.kind];if(e)return Xn(n[e])?{kind:n.kind,[e]:n[e],...n.kind==="output"?{value:!!n.value}:{}}:null;if(n.kind==="call")return[n.first,n.last,n.times].every(l=>Number.isInteger(l)&&l>=1&&l<=200)?{kind:"call",first:n.first,last:n.last,times:Math.min(n.times,50)}:null;if(n.kind==="frame")return _s(n.T)?{kind:"frame",T:_s(n.T)}:null;let i=n.kind==="joint"&&ys(n.q,t)?n.q.slice():null,s=_s(n.T),r=n.kind==="circle"&&ys(n.centre,3)?n.centre.slice():null;if(!s||n.kind==="circle"&&!r&&!_s(n.via))return null;let o=n.kind==="spline"&&Array.isArray(n.through)?n.through.slice(0,100).map(_s):null;if(n.kind==="spline"&&(!o?.length||o.includes(null)))return null;let a=(l,c)=>c===null?{}:{[l]:c};return{kind:n.kind,...a("q",i),T:s,...a("via",_s(n.via)),...a("through",o),...r?{centre:r,long_way:!!n.long_way}:{},...a("speed",Xn(n.speed)&&n.speed>0?n.speed:null),blend:Xn(n.blend)&&n.blend>=0?n.blend:0}}var H0={frame:[],box:["size"],cylinder:["r","h"]};function x2(n){if(!n||!Object.hasOwn(H0,n.kind))return null;let t=_s(n.T),e=xs(n.name,40),i=s=>s==="size"?ys(n.size,3)&&n.size.every(r=>r>0):Xn(n[s])&&n[s]>0;return!t||!e||!H0[n.kind].every(i)?null:{kind:n.kind,name:e,T:t,role:n.role==="object"?"object":"obstacle",...Object.fromEntries(H0[n.kind].map(s=>[s,n[s]]))}}function _2(n,t){if(!n||typeof n!="object")return null;let e=s=>s&&Xn(s.turn)&&ys(s.q,t)?{turn:s.turn,q:s.q.slice(),branch:xs(s.branch,80)}:null,i=(s,r)=>Xn(s)&&s>=0&&s<r?s:0;return{turn:ys(n.turn,2)?n.turn.slice():null,cone:i(n.cone,Math.PI/2),axis:["x","y","z"].includes(n.axis)?n.axis:"z",cost:n.cost==="time"?"time":"motion",singularity:i(n.singularity,1),clearance:i(n.clearance,1e3),start:e(n.start),end:e(n.end)}}function y2(n,t){let e=(s,r,o)=>Array.isArray(s)?s.slice(0,o).map(r).filter(Boolean):[],i=n.program??{};b.program=e(i.steps,s=>g2(s,t),200),b.start=ys(i.start,t)?i.start.slice():null,b.limits=Object.fromEntries(Object.entries(i.limits??{}).filter(([s,r])=>s.length<30&&(r===null||Xn(r)&&r>0))),b.world=e(n.world,x2,60),b.routing=_2(n.routing,t),["sketch","real","both"].includes(n.look?.mode)&&Xn(n.look.opacity)&&(b.look={mode:n.look.mode,opacity:Math.min(Math.max(n.look.opacity,.1),.9)})}function Cu(n,t,e=null){let i=n&&n.pieper===Uw?m2(n.table):null;if(!i)throw new Error("This is not a state of the workbench.");let s=i.joints.length;e&&lt("did",{label:e}),Dw(document),Array.isArray(n.units)&&(gt.set("angle",n.units[0]),gt.set("length",n.units[1])),Object.hasOwn(Bs,n.notation)&&(b.notation=n.notation),["auto","light","dark"].includes(n.theme)&&df(n.theme),b.shownFrames=Array.isArray(n.frames)?n.frames.filter(l=>Number.isInteger(l)&&l>=0&&l<s+2):null;let r=n.path??{};yn(i,{q:ys(n.q,s)?n.q:null,step:!1,what:"new"}),Object.assign(b.path,{from:_s(r.from),to:_s(r.to),n:Number.isInteger(r.n)&&r.n>=2&&r.n<=2e3?r.n:50,seconds:Xn(r.seconds)&&r.seconds>0?r.seconds:5}),b.sequence.postures=(Array.isArray(n.sequence?.postures)?n.sequence.postures:[]).filter(l=>l&&ys(l.q,s)&&Xn(l.seconds)&&Xn(l.hold)).slice(0,40).map(l=>({name:xs(l.name,20)||"P",q:l.q.slice(),seconds:l.seconds,hold:l.hold})),y2(n,s),["pose","position","position+axis"].includes(n.task)&&(pe.task=n.task);let o=Object.entries(n.redundancy??{}).filter(([l,c])=>l.length<80&&Xn(c));pe.redundancy=o.length?Object.fromEntries(o.slice(0,Ow)):null,typeof n.follow=="boolean"&&(pe.follow=n.follow),["all","inside","none"].includes(n.ghosts)&&(pe.ghosts=n.ghosts);let a=_s(n.target);b.hasTarget=!!a,a&&Si(a,"restored",d2(n.digits));for(let l of["units","notation","sequence-loaded","task","program","world"])lt(l);t(n.panel),lt("path-loaded"),lt("routing","loaded"),lt("look","loaded"),ys(n.camera,6)&&gb(n.camera),Oi(b.q,"restored"),e?aa():Kf()}async function Fw(n,t){return new Uint8Array(await new Response(new Blob([n]).stream().pipeThrough(new t("deflate-raw"))).arrayBuffer())}async function ep(){let n=await Fw(new TextEncoder().encode(JSON.stringify(Cl())),CompressionStream),t=btoa(String.fromCharCode(...n)).replaceAll("+","-").replaceAll("/","_").replace(/=+$/,"");return`${location.origin}${location.pathname}#s=${t}`}var Bw=async()=>v2()??await kw(location.hash);async function kw(n){let t=/^#s=([\w-]+)$/.exec(n);if(!t)return null;if(t[1].length>6e4)throw new Error("The link is too long.");let e=Uint8Array.from(atob(t[1].replaceAll("-","+").replaceAll("_","/")),s=>s.charCodeAt(0)),i=await Fw(e,DecompressionStream);if(i.length>5e5)throw new Error("The link unfolds to more than it should.");return JSON.parse(new TextDecoder().decode(i))}var zw="pieper-workbench";function v2(){try{let{address:n,shown:t}=JSON.parse(sessionStorage.getItem(zw)??"{}");return t&&n===location.href?t:null}catch{return null}}function b2(){if(b.table.joints.length)try{sessionStorage.setItem(zw,JSON.stringify({address:location.href,shown:Cl()}))}catch{}}var tp=null,G0=0,Hw=0,Gw=()=>Hw===G0,w2=er(async()=>{let n=G0,t=b.table.joints.length?await ep():tp;t!==tp&&(tp=t,history.replaceState(null,"",t)),Hw=n},600);function M2(){G0+=1,w2()}async function S2(n){if(location.href!==tp)try{let t=await kw(location.hash);t&&Cu(t,n,"open a link")}catch(t){de(`The link could not be read: ${t.message}`,"wrong")}}function Vw(n){addEventListener("pagehide",b2),addEventListener("hashchange",()=>S2(n)),K(["table","q","target","solutions","units","notation","panel","path","sequence","program","world","routing","look","theme","frames"],M2)}function Pu(n){if(n.length>2e4)throw new Error("longer than 20000 characters");let t=T2(n);return/[[\]{}]/.test(t)||Yw(t,t.search(/\S/))?I2(t):t.includes("	")?Xw(t,"	"):t.includes(";")?P2(t):qw(t)}function V0(n){if(n.length>2e4)return null;let t=Pu(n);return t.length>1||(t[0]?.length??0)>1?t:null}function T2(n){let t=n.replace(/\r\n?/g,`
`).replace(/[\u00a0\u202f\u2007]/g," ");return/\\begin\b|&/.test(t)&&(t=t.replace(/\\(?:begin|end)\s*\{[^}]*\}(?:\{[clr|]*\})?|\\(?:left|right)\s*[[\]().|]|\\hline|\$/g,"").replace(/[ \t]+/g," ").replace(/\\\\(?:\[[^\]]*\])?\s*/g,`
`).replaceAll("\\","").replace(/ ?& ?/g,"	")),t.replace(/^\s*[A-Za-z_][\w.]*\s*=\s*/,"").replace(/\b(?:np|numpy)\.(?:float|double|single|int)\w*\(([^()]*)\)/g,"$1").replace(/^\s*[A-Za-z_][\w.]*\s*\(\s*(?=[[{])/,"").replace(/(?:,\s*[A-Za-z_]\w*\s*=\s*[\w.'"]+\s*)*\)?\s*[;,]?\s*$/,e=>/[=;,]/.test(e)?"":e).replace(/^(?:[ ]*\n)+|\n\s*$/g,"")}var A2=/\s*,\s+|\s+,\s*|\s+/,W0=n=>n.trim().replace(/\s*([*/^·])\s*/g,"$1").replace(/(?<=[\w.)°π])\s+([-+−])\s+(?=\S)/g,"$1").replace(/(?<=[\d.)πi])\s+(?=(?:deg|rad|mm|cm|m|°)(?![\wπ]))/g,"").replace(/\(\s+/g,"(").replace(/\s+\)/g,")"),Ww=/^[-+−]?\d{1,3}(?:(?:,\d{3})+(?:\.\d*)?|(?:\.\d{3})+,\d*)$/,R2=n=>/\d,\d/.test(n)&&!/,(?!\d)|(?<!\d),|\./.test(n)&&/[\d)][ \t]+[-+−]?\d/.test(n);function $w(n){let t=n.filter(Boolean);if(t.some(i=>/,\s|\s,/.test(i.replace(/,$/,""))))return i=>i.split(/\s*,\s*|\s+/);if(t.some(i=>/\s/.test(i)))return i=>i.split(A2);if(t.every(i=>Ww.test(i)))return null;let e=i=>!Ww.test(i)&&(/,.*,/.test(i)||i.includes(",")&&/[.A-Za-zπ(]|,[-+−]/.test(i));return t.some(e)?i=>i.split(","):null}var C2=n=>{let t=n.map(e=>e.trim());return t.at(-1)===""&&t.pop(),t};function qw(n){let t=n.split(`
`).map(W0),e=$w(t);return e?t.filter(Boolean).map(i=>C2(e(i))):t.map(i=>[i.replace(/,$/,"")])}function Xw(n,t){let e=n.split(`
`).filter(i=>i.includes(t)||i.trim()).map(i=>i.split(t).map(s=>s.trim().replace(/^"(.*)"$/,"$1")));for(;e.length&&e.at(-1).every(i=>!i);)e.pop();return e}function P2(n){let t=n.split(`
`).filter(s=>s.trim()),e=n.split(/[;\n]/).map(W0).filter(Boolean);return t.length>1&&t.slice(0,-1).every(s=>/^[^;]*;\s*$/.test(s))||$w(e)?qw(e.join(`
`)):Xw(n,";")}function Yw(n,t){if(n[t]!=="("||/[\w)π°.*/^+−-]\s*$/.test(n.slice(0,t)))return!1;let e=0;for(let i=t;i<n.length;i++)if("([".includes(n[i]))e+=1;else{if(")]".includes(n[i])&&(e-=1)===0)return!1;if(n[i]===","&&e===1)return!0}return!1}function I2(n){let t=/[[({]\s*[[({]|[\])}]\s*,?\s*[[({]/.test(n),e=R2(n.replace(/[\])}]\s*,\s*(?=[[({])/g,";")),i=[],s=[],r="",o=()=>{let a=t?r.replaceAll(`
`," "):r.replace(/(,|\.\.\.)\s*\n/g,"$1 ");for(let l of a.replaceAll("..."," ").split(/[;\n]/)){let c=W0(l).split(e?/\s+/:/\s*,\s*|\s+/).filter(Boolean);c.some(u=>/[\wπ]/.test(u))&&i.push(c)}r=""};for(let a=0;a<n.length;a++){let l=n[a];"[{".includes(l)||l==="("&&Yw(n,a)?(s.push(!0),o()):l==="("?(s.push(!1),r+=l):"])}".includes(l)&&(s.pop()??l!==")")?o():r+=l}return o(),i}function jw(n,t,e,i){let s={filled:0,empty:0,lost:0};return i.forEach((r,o)=>r.forEach((a,l)=>{let c=n()[t+o]?.[e+l];c?!a&&!c.mayBeEmpty?s.empty+=1:(c.value=a,c.dispatchEvent(new Event("input",{bubbles:!0})),c.dispatchEvent(new Event("change",{bubbles:!0})),s.filled+=1):s.lost+=a?1:0})),s}function Zw({filled:n,empty:t,lost:e}){let i=[`Pasted ${n} number${n===1?"":"s"}`];t&&i.push(t===1?"an empty cell left what stood there":`${t} empty cells left what stood there`),e&&i.push(`${e} had no cell`),de(`${i.join("; ")}.`,t||e?"wrong":"plain")}function np(n,t,e=()=>{}){let i=()=>[...n.rows].map(s=>[...s.querySelectorAll("input.number")]);n.addEventListener("paste",s=>{let r=s.target.matches("input.number")&&V0(s.clipboardData.getData("text"));if(!r)return;s.preventDefault();let o=i().findIndex(l=>l.includes(s.target)),a=i()[o].indexOf(s.target);Ru(t,()=>{e(o+r.length),Zw(jw(i,o,a,r))})})}function ip(n,t,e){n.addEventListener("paste",i=>{let s=e(),r=s.indexOf(i.target),o=r>=0&&V0(i.clipboardData.getData("text"))?.flat();if(!o)return;i.preventDefault();let a=o.length===s.length?0:r;if(o.length>s.length-a){let l=s.length-a;de(`${o.length} numbers for ${l} field${l===1?"":"s"}: nothing was pasted.`,"wrong");return}Ru(t,()=>Zw(jw(()=>[e()],0,a,[o])))})}var Ze=n=>n.type==="R"?"angle":"length";function Jw(n){let t=n.type==="R"?Math.PI:Gn(b.table),e=n.lower??Math.min(-t,(n.upper??t)-2*t),i=n.upper??Math.max(t,e+2*t),s=Math.max((i-e)*.08,.001);return{lo:e,hi:i,min:n.lower===null?e:e-s,max:n.upper===null?i:i+s}}var L2=lu;function D2(n){let t=b.table.joints[n],e=Ze(t),{lo:i,hi:s,min:r,max:o}=Jw(t),a=`q${n+1}`,l=E("input",{type:"range",min:String(r),max:String(o),step:"any","aria-label":`${a}, ${t.name}`,"data-testid":`slider-${n+1}`}),c=y=>`${100*(y-r)/(o-r)}%`;l.style.setProperty("--lo",c(i)),l.style.setProperty("--hi",c(s)),l.addEventListener("input",()=>{xi(),ih(n,Number(l.value))}),l.addEventListener("change",()=>lt("let-go")),l.addEventListener("keydown",y=>{let g={ArrowRight:1,ArrowUp:1,ArrowLeft:-1,ArrowDown:-1,PageUp:10,PageDown:-10}[y.key],m={Home:i,End:s}[y.key];if(g===void 0&&m===void 0)return;y.preventDefault(),xi();let x=gt.step(e)*(y.shiftKey?.1:1);ih(n,m??Math.min(Math.max(Math.round((b.q[n]+g*x)/(x/10))*(x/10),r),o))});let u=wn({label:`${a} value`,kind:e,testid:`q-${n+1}`,key:`q/${t.name}`,input:y=>{xi(),ih(n,y)}}),h=E("span",{class:"out",role:"note"}),d=E("span",{class:"chain",title:"What this row of the table moves by"}),f=E("span",{class:"limits"}),p=E("div",{class:"joint","data-testid":`joint-${n+1}`},E("span",{class:"joint-name",title:`${t.name}, ${t.type==="R"?"revolute":"prismatic"}`},E("i",{text:"q"}),E("sub",{text:String(n+1)})),E("div",{class:"track"},l,E("div",{class:"under"},f,d,h)),u,E("span",{class:"unit"}));return{el:p,number:u,show(){let y=b.q[n],g=L2(t,y);(document.activeElement!==l||Number(l.value)!==y)&&(l.value=y),l.style.setProperty("--at",c(Math.min(Math.max(y,r),o))),l.setAttribute("aria-valuetext",re(y,e)),u.put(y,String(Number((y*gt.factor(e)).toFixed(gt.digits(e)+1))+0)),p.classList.toggle("outside",g!==0);let m=b.table.coupling?`chain ${re(Mr(b.table,b.q)[n],e)}`:"";bt(d,m),bt(h,g?`${re(Math.abs(g),e)} ${g>0?"above":"below"} the limit`:"")},relabel(){bt(p.lastChild,gt.symbol(e));let y=g=>g===null?"no limit":re(g,e,gt.angle==="deg"&&e==="angle"?0:void 0);bt(f,t.lower===null&&t.upper===null?"no limits":`${y(t.lower)} \u2026 ${y(t.upper)}`),u.refresh(),this.show()}}}var Kw={id:"joints",title:"Joints",build(n){let t=[],e=E("div",{class:"joints","data-testid":"joints"}),i=E("div",{class:"chips",role:"group","aria-label":"Postures"}),s=E("div",{class:"joints gripper"});n.append(e,s,i);let r=()=>{t=b.table.joints.map((o,a)=>D2(a)),Gt(e,t.map(o=>o.el)),t.length||e.append(E("p",{class:"hint",text:"This table has no joints yet. Add one in the DH table."})),t.forEach(o=>o.relabel()),Gt(s,b.table.actuator?N2(b.table.actuator):null),U2(i)};ip(e,"paste joint values",()=>t.map(o=>o.number)),K("table",o=>{o==="undo"||o==="new"?r():o!=="gripper"&&$i(e,r)}),K("q",()=>t.forEach(o=>o.show())),K("units",()=>t.forEach(o=>o.relabel())),r()}};function N2(n){let t=E("input",{type:"range",min:String(n.lower),max:String(n.upper),step:"any","aria-label":`${n.name}, ${n.unit}`,"data-testid":"actuator"}),e=E("output",{class:"quantity"}),i=()=>{t.style.setProperty("--at",`${100*(n.value-n.lower)/(n.upper-n.lower||1)}%`),bt(e,ii(n.value,1))};t.value=n.value,t.addEventListener("input",()=>{n={...n,value:Number(t.value)},yn({...b.table,actuator:n},{what:"gripper",label:`set the ${n.name}`,key:"actuator"}),i()}),i();let s=E("div",{class:"under"},E("span",{text:`${n.name}: moves no frame`}));return E("div",{class:"joint"},E("span",{class:"joint-name",text:"tool"}),E("div",{class:"track"},t,s),e,E("span",{class:"unit",text:n.unit}))}function U2(n){let t=b.table.joints.length,e=Object.entries(b.table.postures??{}),i=(r,o)=>Ut(r,{class:"chip",title:o.map((a,l)=>re(a,Ze(b.table.joints[l]))).join(", ")},()=>Ii(o,.8,`move to ${r}`)),s=e.map(([r,o])=>i(r,o));t&&!e.some(([,r])=>r.every(o=>o===0))&&s.unshift(i("zero",new Array(t).fill(0))),Gt(n,s,t?Ut("Random",{class:"chip quiet",title:"A posture inside the limits"},()=>Ii(O2(),.8,"move to a random posture")):null,t?Ut("Keep this one",{class:"chip quiet",title:"Add the present posture to the arm"},F2):null)}function O2(){return b.table.joints.map(n=>{let{lo:t,hi:e}=Jw(n);return t+Math.random()*(e-t)})}function F2(){let n={...b.table.postures},t=0;for(;`P${t}`in n;)t+=1;n[`P${t}`]=b.q.slice(),yn({...b.table,postures:n},{what:"postures",label:`keep the posture P${t}`}),de(`Kept as P${t}: ${b.q.map((e,i)=>hu(e,Ze(b.table.joints[i]))).join(", ")}`),lt("postures")}var tM=[["position","Position"],["joints","Joints"],["speeds","Joint speeds"],["accelerations","Accelerations"],["toolspeed","Tool speed"],["singularity","Distance to singularity"]];function fr({table:n,q:t,xs:e,xName:i,xEnd:s=null,seconds:r,dq:o,ddq:a,events:l=[],title:c,...u}){let h=t.map(p=>As(n,p)),d=h.map(p=>te(p[p.length-1])),f=o??$0(t,r);return{table:n,q:t,xs:e,xName:i,xEnd:s,seconds:r,events:l,title:c,...u,tool:d,speeds:f,accelerations:a??$0(f,r),toolspeeds:$0(d,r).map(Ui),least:t.map((p,y)=>dc(n,p,h[y])[0]??0)}}function $0(n,t){return n.map((e,i)=>{let s=Math.max(i-1,0),r=Math.min(i+1,n.length-1),o=t[r]-t[s];return n[i].map((a,l)=>o>0?(n[r][l]-n[s][l])/o:0)})}var B2=1e6;function k2(n,t,e){let i=n.table.joints[e];if(t==="joints")return[i.lower,i.upper];let s=n.limits?.[{speeds:"speed",accelerations:"acceleration"}[t]],r=Array.isArray(s)?s[e]:s??null;return r===null||r>=B2?[null,null]:[-r,r]}var z2={speeds:"speed",accelerations:"acceleration",toolspeed:"tool speed"},Qw=(n,t,e=null)=>(n.tight??[]).filter(i=>i.limit===z2[t]&&i.joint===e),eM=(n,t)=>(n.tight??[]).filter(e=>e.start-1e-9<=t&&t<=e.end+1e-9).map(e=>e.joint?`${e.limit} of ${e.joint}`:e.limit).join(", ");function q0(n,t){let{table:e}=n,i=gt.factor("length");if(t==="position")return{y:`tool, ${gt.length}`,list:["X","Y","Z"].map((c,u)=>sp(c,n.tool.map(h=>h[u]*i)))};if(t==="singularity")return{y:"smallest singular value",list:[sp("\u03C3 min",n.least)]};if(t==="toolspeed"){let c=n.limits?.tool_speed??null,u=n.toolspeeds.map(h=>h*i);return{y:`tool, ${gt.length}/s`,list:[sp("tool speed",u,[null,c&&c*i],Qw(n,t))]}}let s={joints:n.q,speeds:n.speeds,accelerations:n.accelerations}[t],r={joints:"",speeds:"/s",accelerations:"/s\xB2"}[t],a=[...new Set(e.joints.map(Ze))].map(c=>(c==="angle"?gt.angle:gt.length)+r).join(" or "),l=e.joints.map((c,u)=>{let h=gt.factor(Ze(c));return sp(`q${u+1}`,s.map(d=>d[u]*h),k2(n,t,u).map(d=>d===null?null:d*h),Qw(n,t,c.name))});return{y:a,list:l}}var sp=(n,t,e=[null,null],i=[])=>({name:n,values:t,limits:e,binds:i});function Iu(n){let t=n.flatMap((i,s)=>i.limits.filter(r=>r!==null).map(r=>({value:r,of:s}))),e=new Map;for(let i of t)e.set(i.value,[...e.get(i.value)??[],i.of]);return[...e].map(([i,s])=>({value:i,of:s.length===1&&n.length>1?s[0]:null}))}function nM(n){let t=gt.angle,e=gt.length,{table:i}=n,s=l=>Ze(l)==="angle"?t:e,r=[n.xName.replace(" ","_"),"time_s",`X_${e}`,`Y_${e}`,`Z_${e}`,...i.joints.map((l,c)=>`q${c+1}_${s(l)}`),...i.joints.map((l,c)=>`dq${c+1}_${s(l)}_per_s`),"sigma_min"],o=l=>String(Number(l.toPrecision(10))),a=n.q.map((l,c)=>[n.xs[c],n.seconds[c],...n.tool[c].map(u=>u*gt.factor("length")),...l.map((u,h)=>u*gt.factor(Ze(i.joints[h]))),...n.speeds[c].map((u,h)=>u*gt.factor(Ze(i.joints[h]))),n.least[c]].map(o).join(","));return[r.join(","),...a].join(`
`)+`
`}function iM(n,t,e){let{y:i,list:s}=q0(n,t),r=720,o=380,a={l:66,r:96,t:34,b:48},l=n.xs,c=s.flatMap(_=>_.values),u=n.xEnd??l[l.length-1],h=l[0],d=u>h?u:h+1,[f,p]=[Math.min(...c),Math.max(...c)];p-f>1e-9||(f-=1,p+=1);let y=_=>a.l+(_-h)/(d-h)*(r-a.l-a.r),g=_=>o-a.b-(_-f)/(p-f)*(o-a.t-a.b),m=(_,M)=>{let N=(M-_)/6,R=10**Math.floor(Math.log10(N)),L=[1,2,5,10].map(z=>z*R).find(z=>z>=N);return Array.from({length:12},(z,G)=>(Math.ceil(_/L)+G)*L).filter(z=>z<=M+L*1e-6)},x=_=>_.toFixed(2),w=_=>String(Number(_.toPrecision(6))),v=_=>_.replace(/[&<>"]/g,M=>({"&":"&amp;","<":"&lt;",">":"&gt;",'"':"&quot;"})[M]),A=["","7 3","2 3","9 3 2 3","5 2 1 2 1 2","12 4","1 2","6 6"],S=[`<rect width="${r}" height="${o}" fill="#fff"/>`,`<text x="${a.l}" y="20" font-weight="600">${v(n.title)}</text>`];for(let _ of m(f,p))S.push(`<path d="M${a.l} ${x(g(_))}H${r-a.r}" stroke="#ddd"/><text x="${a.l-8}" y="${x(g(_)+4)}" text-anchor="end">${w(_)}</text>`);for(let _ of m(h,d))S.push(`<path d="M${x(y(_))} ${o-a.b}v5" stroke="#333"/><text x="${x(y(_))}" y="${o-a.b+20}" text-anchor="middle">${w(_)}</text>`);S.push(`<path d="M${a.l} ${a.t}V${o-a.b}H${r-a.r}" fill="none" stroke="#333"/>`);for(let _ of n.events)Number.isFinite(_.x)&&S.push(`<path d="M${x(y(_.x))} ${a.t}V${o-a.b}" stroke="#b42318" stroke-dasharray="3 3"/><text x="${x(y(_.x)+4)}" y="${a.t+10}" fill="#b42318" font-size="11">${v(_.short)}</text>`);for(let{value:_,of:M}of Iu(s))_>=f&&_<=p&&S.push(`<path d="M${a.l} ${x(g(_))}H${r-a.r}" stroke="${M===null?"#333":e[M%e.length]}" stroke-dasharray="2 5"/>`);return s.forEach((_,M)=>{let N=e[M%e.length],R=_.values[_.values.length-1];S.push(`<polyline fill="none" stroke="${N}" stroke-width="1.8" stroke-dasharray="${A[M%A.length]}" points="${_.values.map((L,z)=>`${x(y(l[z]))},${x(g(L))}`).join(" ")}"/>`,`<path d="M${r-a.r+12} ${a.t+8+18*M}h22" stroke="${N}" stroke-width="2" stroke-dasharray="${A[M%A.length]}"/><text x="${r-a.r+40}" y="${a.t+12+18*M}"><title>${x(R)}</title>${v(_.name)}</text>`)}),S.push(`<text x="${(a.l+r-a.r)/2}" y="${o-8}" text-anchor="middle">${v(n.xName)}</text>`,`<text transform="translate(16 ${(a.t+o-a.b)/2}) rotate(-90)" text-anchor="middle">${v(i)}</text>`),`<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${r} ${o}" width="${r}" height="${o}" font-family="Inter, Helvetica, Arial, sans-serif" font-size="12" fill="#222">${S.join("")}</svg>
`}var H2="uplot",G2="u-hz",V2="u-vt",W2="u-title",$2="u-wrap",q2="u-under",X2="u-over",Y2="u-axis",ua="u-off",j2="u-select",Z2="u-cursor-x",J2="u-cursor-y",K2="u-cursor-pt",Q2="u-legend",tL="u-live",eL="u-inline",nL="u-series",iL="u-marker",sM="u-label",sL="u-value",Du="width",Nu="height";var rM="bottom",Pl="left",X0="right",ux="#000",oM=ux+"0",Y0="mousemove",aM="mousedown",j0="mouseup",lM="mouseenter",cM="mouseleave",uM="dblclick",rL="resize",oL="scroll",hM="change",cp="dppxchange",hx="--",Fl=typeof window<"u",tx=Fl?document:null,Ll=Fl?window:null,aL=Fl?navigator:null,We,rp;function ex(){let n=devicePixelRatio;We!=n&&(We=n,rp&&ix(hM,rp,ex),rp=matchMedia(`(min-resolution: ${We-.001}dppx) and (max-resolution: ${We+.001}dppx)`),ha(hM,rp,ex),Ll.dispatchEvent(new CustomEvent(cp)))}function rs(n,t){if(t!=null){let e=n.classList;!e.contains(t)&&e.add(t)}}function nx(n,t){let e=n.classList;e.contains(t)&&e.remove(t)}function gn(n,t,e){n.style[t]=e+"px"}function Hs(n,t,e,i){let s=tx.createElement(n);return t!=null&&rs(s,t),e?.insertBefore(s,i),s}function vs(n,t){return Hs("div",n,t)}var dM=new WeakMap;function pr(n,t,e,i,s){let r="translate("+t+"px,"+e+"px)",o=dM.get(n);r!=o&&(n.style.transform=r,dM.set(n,r),t<0||e<0||t>i||e>s?rs(n,ua):nx(n,ua))}var fM=new WeakMap;function pM(n,t,e){let i=t+e,s=fM.get(n);i!=s&&(fM.set(n,i),n.style.background=t,n.style.borderColor=e)}var mM=new WeakMap;function gM(n,t,e,i){let s=t+""+e,r=mM.get(n);s!=r&&(mM.set(n,s),n.style.height=e+"px",n.style.width=t+"px",n.style.marginLeft=i?-t/2+"px":0,n.style.marginTop=i?-e/2+"px":0)}var dx={passive:!0},lL={...dx,capture:!0};function ha(n,t,e,i){t.addEventListener(n,e,i?lL:dx)}function ix(n,t,e,i){t.removeEventListener(n,e,dx)}Fl&&ex();function Gs(n,t,e,i){let s;e=e||0,i=i||t.length-1;let r=i<=2147483647;for(;i-e>1;)s=r?e+i>>1:os((e+i)/2),t[s]<n?e=s:i=s;return n-t[e]<=t[i]-n?e:i}function WM(n){return(e,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(e[a])){r=a;break}for(let a=s;a>=i;a--)if(n(e[a])){o=a;break}return[r,o]}}var $M=n=>n!=null,qM=n=>n!=null&&n>0,dp=WM($M),cL=WM(qM);function uL(n,t,e,i=0,s=!1){let r=s?cL:dp,o=s?qM:$M;[t,e]=r(n,t,e);let a=n[t],l=n[t];if(t>-1)if(i==1)a=n[t],l=n[e];else if(i==-1)a=n[e],l=n[t];else for(let c=t;c<=e;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??sn,l??-sn]}function fp(n,t,e,i){let s=yM(n),r=yM(t);n==t&&(s==-1?(n*=e,t/=e):(n/=e,t*=e));let o=e==10?Vr:XM,a=s==1?os:bs,l=r==1?bs:os,c=a(o(jn(n))),u=l(o(jn(t))),h=Dl(e,c),d=Dl(e,u);return e==10&&(c<0&&(h=rn(h,-c)),u<0&&(d=rn(d,-u))),i||e==2?(n=h*s,t=d*r):(n=JM(n,h),t=pp(t,d)),[n,t]}function fx(n,t,e,i){let s=fp(n,t,e,i);return n==0&&(s[0]=0),t==0&&(s[1]=0),s}var px=.1,xM={mode:3,pad:px},Ou={pad:0,soft:null,mode:0},hL={min:Ou,max:Ou};function up(n,t,e,i){return mp(e)?_M(n,t,e):(Ou.pad=e,Ou.soft=i?0:null,Ou.mode=i?3:0,_M(n,t,hL))}function ke(n,t){return n??t}function dL(n,t,e){for(t=ke(t,0),e=ke(e,n.length-1);t<=e;){if(n[t]!=null)return!0;t++}return!1}function _M(n,t,e){let i=e.min,s=e.max,r=ke(i.pad,0),o=ke(s.pad,0),a=ke(i.hard,-sn),l=ke(s.hard,sn),c=ke(i.soft,sn),u=ke(s.soft,-sn),h=ke(i.mode,0),d=ke(s.mode,0),f=t-n,p=Vr(f),y=Di(jn(n),jn(t)),g=Vr(y),m=jn(g-p);(f<1e-24||m>10)&&(f=0,(n==0||t==0)&&(f=1e-24,h==2&&c!=sn&&(r=0),d==2&&u!=-sn&&(o=0)));let x=f||y||1e3,w=Vr(x),v=Dl(10,os(w)),A=x*(f==0?n==0?.1:1:r),S=rn(JM(n-A,v/10),24),_=n>=c&&(h==1||h==3&&S<=c||h==2&&S>=c)?c:sn,M=Di(a,S<_&&n>=_?_:Vs(_,S)),N=x*(f==0?t==0?.1:1:o),R=rn(pp(t+N,v/10),24),L=t<=u&&(d==1||d==3&&R>=u||d==2&&R<=u)?u:-sn,z=Vs(l,R>L&&t<=L?L:Di(L,R));return M==z&&M==0&&(z=100),[M,z]}var fL=new Intl.NumberFormat(Fl?aL.language:"en-US"),mx=n=>fL.format(n),as=Math,lp=as.PI,jn=as.abs,os=as.floor,Yn=as.round,bs=as.ceil,Vs=as.min,Di=as.max,Dl=as.pow,yM=as.sign,Vr=as.log10,XM=as.log2,pL=(n,t=1)=>as.sinh(n)*t,Z0=(n,t=1)=>as.asinh(n/t),sn=1/0;function vM(n){return(Vr((n^n>>31)-(n>>31))|0)+1}function sx(n,t,e){return Vs(Di(n,t),e)}function YM(n){return typeof n=="function"}function Ne(n){return YM(n)?n:()=>n}var mL=()=>{},jM=n=>n,ZM=(n,t)=>t,gL=n=>null,bM=n=>!0,wM=(n,t)=>n==t,xL=/\.\d*?(?=9{6,}|0{6,})/gm,da=n=>{if(QM(n)||Ao.has(n))return n;let t=`${n}`,e=t.match(xL);if(e==null)return n;let i=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${da(s)}e${r}`}return rn(n,i)};function la(n,t){return da(rn(da(n/t))*t)}function pp(n,t){return da(bs(da(n/t))*t)}function JM(n,t){return da(os(da(n/t))*t)}function rn(n,t=0){if(QM(n))return n;let e=10**t,i=n*e*(1+Number.EPSILON);return Yn(i)/e}var Ao=new Map;function KM(n){return((""+n).split(".")[1]||"").length}function Bu(n,t,e,i){let s=[],r=i.map(KM);for(let o=t;o<e;o++){let a=jn(o),l=rn(Dl(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,h=(o>=0?0:a)+(o>=r[c]?0:r[c]),d=n==10?u:rn(u,h);s.push(d),Ao.set(d,h)}}return s}var Fu={},gx=[],Nl=[null,null],To=Array.isArray,QM=Number.isInteger,_L=n=>n===void 0;function MM(n){return typeof n=="string"}function mp(n){let t=!1;if(n!=null){let e=n.constructor;t=e==null||e==Object}return t}function yL(n){return n!=null&&typeof n=="object"}var vL=Object.getPrototypeOf(Uint8Array),tS="__proto__";function Ul(n,t=mp){let e;if(To(n)){let i=n.find(s=>s!=null);if(To(i)||t(i)){e=Array(n.length);for(let s=0;s<n.length;s++)e[s]=Ul(n[s],t)}else e=n.slice()}else if(n instanceof vL)e=n.slice();else if(t(n)){e={};for(let i in n)i!=tS&&(e[i]=Ul(n[i],t))}else e=n;return e}function Bn(n){let t=arguments;for(let e=1;e<t.length;e++){let i=t[e];for(let s in i)s!=tS&&(mp(n[s])?Bn(n[s],Ul(i[s])):n[s]=Ul(i[s]))}return n}var bL=0,wL=1,ML=2;function SL(n,t,e){for(let i=0,s,r=-1;i<t.length;i++){let o=t[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<e&&n[s]==null;)n[r=s++]=null}}}function EL(n,t){if(RL(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return CL(o[0])||(o=AL(o)),o}let e=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)e.add(l[u])}let i=[Array.from(e).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(s).fill(void 0),d=t?t[o][c]:wL,f=[];for(let p=0;p<u.length;p++){let y=u[p],g=r.get(l[p]);y===null?d!=bL&&(h[g]=y,d==ML&&f.push(g)):h[g]=y}SL(h,f,s),i.push(h)}}return i}var TL=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function AL(n){let t=n[0],e=t.length,i=Array(e);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[i[l]];s.push(a)}return s}function RL(n){let t=n[0][0],e=t.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function CL(n,t=100){let e=n.length;if(e<=1)return!0;let i=0,s=e-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=Di(1,os((s-i+1)/t));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var eS=["January","February","March","April","May","June","July","August","September","October","November","December"],nS=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function iS(n){return n.slice(0,3)}var PL=nS.map(iS),IL=eS.map(iS),LL={MMMM:eS,MMM:IL,WWWW:nS,WWW:PL};function Lu(n){return(n<10?"0":"")+n}function DL(n){return(n<10?"00":n<100?"0":"")+n}var NL={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,t)=>t.MMMM[n.getMonth()],MMM:(n,t)=>t.MMM[n.getMonth()],MM:n=>Lu(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>Lu(n.getDate()),D:n=>n.getDate(),WWWW:(n,t)=>t.WWWW[n.getDay()],WWW:(n,t)=>t.WWW[n.getDay()],HH:n=>Lu(n.getHours()),H:n=>n.getHours(),h:n=>{let t=n.getHours();return t==0?12:t>12?t-12:t},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>Lu(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>Lu(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>DL(n.getMilliseconds())};function xx(n,t){t=t||LL;let e=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)e.push(s[0][0]=="{"?NL[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var UL=new Intl.DateTimeFormat().resolvedOptions().timeZone;function OL(n,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+n+n.getTimezoneOffset()*6e4):t==UL?e=n:(e=new Date(n.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(n.getMilliseconds())),e}var sS=n=>n%1==0,hp=[1,2,2.5,5],FL=Bu(10,-32,0,hp),rS=Bu(10,0,32,hp),BL=rS.filter(sS),ca=FL.concat(rS),_x=`
`,oS="{YYYY}",SM=_x+oS,aS="{M}/{D}",Uu=_x+aS,op=Uu+"/{YY}",lS="{aa}",kL="{h}:{mm}",Il=kL+lS,EM=_x+Il,TM=":{ss}",qe=null;function cS(n){let t=n*1e3,e=t*60,i=e*60,s=i*24,r=s*30,o=s*365,l=(n==1?Bu(10,0,3,hp).filter(sS):Bu(10,-3,0,hp)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,oS,qe,qe,qe,qe,qe,qe,1],[s*28,"{MMM}",SM,qe,qe,qe,qe,qe,1],[s,aS,SM,qe,qe,qe,qe,qe,1],[i,"{h}"+lS,op,qe,Uu,qe,qe,qe,1],[e,Il,op,qe,Uu,qe,qe,qe,1],[t,TM,op+" "+Il,qe,Uu+" "+Il,qe,EM,qe,1],[n,TM+".{fff}",op+" "+Il,qe,Uu+" "+Il,qe,EM,qe,1]];function u(h){return(d,f,p,y,g,m)=>{let x=[],w=g>=o,v=g>=r&&g<o,A=h(p),S=rn(A*n,3),_=J0(A.getFullYear(),w?0:A.getMonth(),v||w?1:A.getDate()),M=rn(_*n,3);if(v||w){let N=v?g/r:0,R=w?g/o:0,L=S==M?S:rn(J0(_.getFullYear()+R,_.getMonth()+N,1)*n,3),z=new Date(Yn(L/n)),G=z.getFullYear(),F=z.getMonth();for(let U=0;L<=y;U++){let D=J0(G+R*U,F+N*U,1),O=D-h(rn(D*n,3));L=rn((+D+O)*n,3),L<=y&&x.push(L)}}else{let N=g>=s?s:g,R=os(p)-os(S),L=M+R+pp(S-M,N);x.push(L);let z=h(L),G=z.getHours()+z.getMinutes()/e+z.getSeconds()/i,F=g/i,U=d.axes[f]._space,D=m/U;for(;L=rn(L+g,n==1?0:3),!(L>y);)if(F>1){let O=os(rn(G+F,6))%24,J=h(L).getHours()-O;J>1&&(J=-1),L-=J*i,G=(G+F)%24;let nt=x[x.length-1];rn((L-nt)/g,3)*D>=.7&&x.push(L)}else x.push(L)}return x}}return[l,c,u]}var[zL,HL,GL]=cS(1),[VL,WL,$L]=cS(.001);Bu(2,-53,53,[1]);function AM(n,t){return n.map(e=>e.map((i,s)=>s==0||s==8||i==null?i:t(s==1||e[8]==0?i:e[1]+i)))}function RM(n,t){return(e,i,s,r,o)=>{let a=t.find(p=>o>=p[0])||t[t.length-1],l,c,u,h,d,f;return i.map(p=>{let y=n(p),g=y.getFullYear(),m=y.getMonth(),x=y.getDate(),w=y.getHours(),v=y.getMinutes(),A=y.getSeconds(),S=g!=l&&a[2]||m!=c&&a[3]||x!=u&&a[4]||w!=h&&a[5]||v!=d&&a[6]||A!=f&&a[7]||a[1];return l=g,c=m,u=x,h=w,d=v,f=A,S(y)})}}function qL(n,t){let e=xx(t);return(i,s,r,o,a)=>s.map(l=>e(n(l)))}function J0(n,t,e){return new Date(n,t,e)}function CM(n,t){return t(n)}var XL="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function PM(n,t){return(e,i,s,r)=>r==null?hx:t(n(i))}function YL(n,t){let e=n.series[t];return e.width?e.stroke(n,t):e.points.width?e.points.stroke(n,t):null}function jL(n,t){return n.series[t].fill(n,t)}var ZL={show:!0,live:!0,isolate:!1,mount:mL,markers:{show:!0,width:2,stroke:YL,fill:jL,dash:"solid"},idx:null,idxs:null,values:[]};function JL(n,t){let e=n.cursor.points,i=vs(),s=e.size(n,t);gn(i,Du,s),gn(i,Nu,s);let r=s/-2;gn(i,"marginLeft",r),gn(i,"marginTop",r);let o=e.width(n,t,s);return o&&gn(i,"borderWidth",o),i}function KL(n,t){let e=n.series[t].points;return e._fill||e._stroke}function QL(n,t){let e=n.series[t].points;return e._stroke||e._fill}function tD(n,t){return n.series[t].points.size}var K0=[0,0];function eD(n,t,e){return K0[0]=t,K0[1]=e,K0}function ap(n,t,e,i=!0){return s=>{s.button==0&&(!i||s.target==t)&&e(s)}}function Q0(n,t,e,i=!0){return s=>{(!i||s.target==t)&&e(s)}}var nD={show:!0,x:!0,y:!0,lock:!1,move:eD,points:{one:!1,show:JL,size:tD,width:0,stroke:QL,fill:KL},bind:{mousedown:ap,mouseup:ap,click:ap,dblclick:ap,mousemove:Q0,mouseleave:Q0,mouseenter:Q0},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,t,e,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},uS={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},yx=Bn({},uS,{filter:ZM}),hS=Bn({},yx,{size:10}),dS=Bn({},uS,{show:!1}),vx='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',fS="bold "+vx,pS=1.5,IM={show:!0,scale:"x",stroke:ux,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:fS,side:2,grid:yx,ticks:hS,border:dS,font:vx,lineGap:pS,rotate:0},iD="Value",sD="Time",LM={show:!0,scale:"x",auto:!1,sorted:1,min:sn,max:-sn,idxs:[]};function rD(n,t,e,i,s){return t.map(r=>r==null?"":mx(r))}function oD(n,t,e,i,s,r,o){let a=[],l=Ao.get(s)||0;e=o?e:rn(pp(e,s),l);for(let c=e;c<=i;c=rn(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function rx(n,t,e,i,s,r,o){let a=[],l=n.scales[n.axes[t].scale].log,c=l==10?Vr:XM,u=os(c(e));s=Dl(l,u),l==10&&(s=ca[Gs(s,ca)]);let h=e,d=s*l;l==10&&(d=ca[Gs(d,ca)]);do a.push(h),h=h+s,l==10&&!Ao.has(h)&&(h=rn(h,Ao.get(s))),h>=d&&(s=h,d=s*l,l==10&&(d=ca[Gs(d,ca)]));while(h<=i);return a}function aD(n,t,e,i,s,r,o){let l=n.scales[n.axes[t].scale].asinh,c=i>l?rx(n,t,Di(l,e),i,s):[l],u=i>=0&&e<=0?[0]:[];return(e<-l?rx(n,t,Di(l,-i),-e,s):[l]).reverse().map(d=>-d).concat(u,c)}var mS=/./,lD=/[12357]/,cD=/[125]/,DM=/1/,ox=(n,t,e,i)=>n.map((s,r)=>t==4&&s==0||r%i==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function uD(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),h=l(9,o)-u>=c?mS:l(7,o)-u>=c?lD:l(5,o)-u>=c?cD:DM;if(h==DM){let d=jn(l(1,o)-u);if(d<c)return ox(t.slice().reverse(),a.distr,h,bs(c/d)).reverse()}return ox(t,a.distr,h,1)}function hD(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=r._space,l=n.valToPos,c=jn(l(1,o)-l(2,o));return c<a?ox(t.slice().reverse(),3,mS,bs(a/c)).reverse():t}function dD(n,t,e,i){return i==null?hx:t==null?"":mx(t)}var NM={show:!0,scale:"y",stroke:ux,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:fS,side:3,grid:yx,ticks:hS,border:dS,font:vx,lineGap:pS,rotate:0};function fD(n,t){let e=3+(n||1)*2;return rn(e*t,3)}function pD(n,t){let{scale:e,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],e,!0),o=n.valToPos(s[i[1]],e,!0),a=jn(o-r),l=n.series[t],c=a/(l.points.space*We);return i[1]-i[0]<=c}var UM={scale:null,auto:!0,sorted:0,min:sn,max:-sn},gS=(n,t,e,i,s)=>s,OM={show:!0,auto:!0,sorted:0,gaps:gS,alpha:1,facets:[Bn({},UM,{scale:"x"}),Bn({},UM,{scale:"y"})]},FM={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:gS,alpha:1,points:{show:pD,filter:null},values:null,min:sn,max:-sn,idxs:[],path:null,clip:null};function mD(n,t,e,i,s){return e/10}var xS={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},gD=Bn({},xS,{time:!1,ori:1}),BM={};function _S(n,t){let e=BM[n];return e||(e={key:n,plots:[],sub(i){e.plots.push(i)},unsub(i){e.plots=e.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<e.plots.length;u++)e.plots[u]!=s&&e.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&(BM[n]=e)),e}var Ol=1,ax=2;function fa(n,t,e){let i=n.mode,s=n.series[t],r=i==2?n._data[t]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[t],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],h=i==2?o[s.facets[1].scale]:o[s.scale],d=a.left,f=a.top,p=a.width,y=a.height,g=n.valToPosH,m=n.valToPosV;return u.ori==0?e(s,l,c,u,h,g,m,d,f,p,y,xp,Bl,yp,vS,wS):e(s,l,c,u,h,m,g,f,d,y,p,_p,kl,Mx,bS,MS)}function bx(n,t){let e=0,i=0,s=ke(n.bands,gx);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?i|=1:i|=2)}return[e,i==1?-1:i==2?1:i==3?2:0]}function xD(n,t,e,i,s){let r=n.mode,o=n.series[t],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Wr(n,t,e,i,s,r){return fa(n,t,(o,a,l,c,u,h,d,f,p,y,g)=>{let m=o.pxRound,x=c.dir*(c.ori==0?1:-1),w=c.ori==0?Bl:kl,v,A;x==1?(v=e,A=i):(v=i,A=e);let S=m(h(a[v],c,y,f)),_=m(d(l[v],u,g,p)),M=m(h(a[A],c,y,f)),N=m(d(r==1?u.max:u.min,u,g,p)),R=new Path2D(s);return w(R,M,N),w(R,S,N),w(R,S,_),R})}function gp(n,t,e,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=t==0?yp:Mx,l=e;for(let h=0;h<n.length;h++){let d=n[h];if(d[1]>d[0]){let f=d[0]-l;f>0&&a(o,l,i,f,i+r),l=d[1]}}let c=e+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function _D(n,t,e){let i=n[n.length-1];i&&i[0]==t?i[1]=e:n.push([t,e])}function wx(n,t,e,i,s,r,o){let a=[],l=n.length;for(let c=s==1?e:i;c>=e&&c<=i;c+=s)if(t[c]===null){let h=c,d=c;if(s==1)for(;++c<=i&&t[c]===null;)d=c;else for(;--c>=e&&t[c]===null;)d=c;let f=r(n[h]),p=d==h?f:r(n[d]),y=h-s;f=o<=0&&y>=0&&y<l?r(n[y]):f;let m=d+s;p=o>=0&&m>=0&&m<l?r(n[m]):p,p>=f&&a.push([f,p])}return a}function kM(n){return n==0?jM:n==1?Yn:t=>la(t,n)}function yS(n){let t=n==0?xp:_p,e=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=Vs(c,a/2,l/2),u=Vs(u,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,u),e(s,r,o+l,r,o,u),e(s,r,o,r+a,o,c),s.closePath())}}var xp=(n,t,e)=>{n.moveTo(t,e)},_p=(n,t,e)=>{n.moveTo(e,t)},Bl=(n,t,e)=>{n.lineTo(t,e)},kl=(n,t,e)=>{n.lineTo(e,t)},yp=yS(0),Mx=yS(1),vS=(n,t,e,i,s,r)=>{n.arc(t,e,i,s,r)},bS=(n,t,e,i,s,r)=>{n.arc(e,t,i,s,r)},wS=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(t,e,i,s,r,o)},MS=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(e,t,s,i,o,r)};function SS(n){return(t,e,i,s,r)=>fa(t,e,(o,a,l,c,u,h,d,f,p,y,g)=>{let{pxRound:m,points:x}=o,w,v;c.ori==0?(w=xp,v=vS):(w=_p,v=bS);let A=rn(x.width*We,3),S=(x.size-x.width)/2*We,_=rn(S*2,3),M=new Path2D,N=new Path2D,{left:R,top:L,width:z,height:G}=t.bbox;yp(N,R-_,L-_,z+_*2,G+_*2);let F=U=>{if(l[U]!=null){let D=m(h(a[U],c,y,f)),O=m(d(l[U],u,g,p));w(M,D+S,O),v(M,D,O,S,0,lp*2)}};if(r)r.forEach(F);else for(let U=i;U<=s;U++)F(U);return{stroke:A>0?M:null,fill:M,clip:N,flags:Ol|ax}})}function ES(n){return(t,e,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(t,e,i),r!=s&&o!=s&&n(t,e,s),n(t,e,o))}}var yD=ES(Bl),vD=ES(kl);function TS(n){let t=ke(n?.alignGaps,0);return(e,i,s,r)=>fa(e,i,(o,a,l,c,u,h,d,f,p,y,g)=>{[s,r]=dp(l,s,r);let m=o.pxRound,x=G=>m(h(G,c,y,f)),w=G=>m(d(G,u,g,p)),v,A;c.ori==0?(v=Bl,A=yD):(v=kl,A=vD);let S=c.dir*(c.ori==0?1:-1),_={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Ol},M=_.stroke,N=!1;if(r-s>=y*4){let G=ft=>e.posToVal(ft,c.key,!0),F=null,U=null,D,O,Z,X=x(a[S==1?s:r]),J=x(a[s]),nt=x(a[r]),dt=G(S==1?J+1:nt-1);for(let ft=S==1?s:r;ft>=s&&ft<=r;ft+=S){let st=a[ft],xt=(S==1?st<dt:st>dt)?X:x(st),Tt=l[ft];xt==X?Tt!=null?(O=Tt,F==null?(v(M,xt,w(O)),D=F=U=O):O<F?F=O:O>U&&(U=O)):Tt===null&&(N=!0):(F!=null&&A(M,X,w(F),w(U),w(D),w(O)),Tt!=null?(O=Tt,v(M,xt,w(O)),F=U=D=O):(F=U=null,Tt===null&&(N=!0)),X=xt,dt=G(X+S))}F!=null&&F!=U&&Z!=X&&A(M,X,w(F),w(U),w(D),w(O))}else for(let G=S==1?s:r;G>=s&&G<=r;G+=S){let F=l[G];F===null?N=!0:F!=null&&v(M,x(a[G]),w(F))}let[L,z]=bx(e,i);if(o.fill!=null||L!=0){let G=_.fill=new Path2D(M),F=o.fillTo(e,i,o.min,o.max,L),U=w(F),D=x(a[s]),O=x(a[r]);S==-1&&([O,D]=[D,O]),v(G,O,U),v(G,D,U)}if(!o.spanGaps){let G=[];N&&G.push(...wx(a,l,s,r,S,x,t)),_.gaps=G=o.gaps(e,i,s,r,G),_.clip=gp(G,c.ori,f,p,y,g)}return z!=0&&(_.band=z==2?[Wr(e,i,s,r,M,-1),Wr(e,i,s,r,M,1)]:Wr(e,i,s,r,M,z)),_})}function bD(n){let t=ke(n.align,1),e=ke(n.ascDesc,!1),i=ke(n.alignGaps,0),s=ke(n.extend,!1);return(r,o,a,l)=>fa(r,o,(c,u,h,d,f,p,y,g,m,x,w)=>{[a,l]=dp(h,a,l);let v=c.pxRound,{left:A,width:S}=r.bbox,_=J=>v(p(J,d,x,g)),M=J=>v(y(J,f,w,m)),N=d.ori==0?Bl:kl,R={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Ol},L=R.stroke,z=d.dir*(d.ori==0?1:-1),G=M(h[z==1?a:l]),F=_(u[z==1?a:l]),U=F,D=F;s&&t==-1&&(D=A,N(L,D,G)),N(L,F,G);for(let J=z==1?a:l;J>=a&&J<=l;J+=z){let nt=h[J];if(nt==null)continue;let dt=_(u[J]),ft=M(nt);t==1?N(L,dt,G):N(L,U,ft),N(L,dt,ft),G=ft,U=dt}let O=U;s&&t==1&&(O=A+S,N(L,O,G));let[Z,X]=bx(r,o);if(c.fill!=null||Z!=0){let J=R.fill=new Path2D(L),nt=c.fillTo(r,o,c.min,c.max,Z),dt=M(nt);N(J,O,dt),N(J,D,dt)}if(!c.spanGaps){let J=[];J.push(...wx(u,h,a,l,z,_,i));let nt=c.width*We/2,dt=e||t==1?nt:-nt,ft=e||t==-1?-nt:nt;J.forEach(st=>{st[0]+=dt,st[1]+=ft}),R.gaps=J=c.gaps(r,o,a,l,J),R.clip=gp(J,d.ori,g,m,x,w)}return X!=0&&(R.band=X==2?[Wr(r,o,a,l,L,-1),Wr(r,o,a,l,L,1)]:Wr(r,o,a,l,L,X)),R})}function zM(n,t,e,i,s,r,o=sn){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(t[l]!==void 0){if(a!=null){let u=jn(n[l]-n[a]);u<c&&(c=u,o=jn(e(n[l],i,s,r)-e(n[a],i,s,r)))}a=l}}return o}function wD(n){n=n||Fu;let t=ke(n.size,[.6,sn,1]),e=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=Ne(s),o=1-t[0],a=ke(t[1],sn),l=ke(t[2],1),c=ke(n.disp,Fu),u=ke(n.each,f=>{}),{fill:h,stroke:d}=c;return(f,p,y,g)=>fa(f,p,(m,x,w,v,A,S,_,M,N,R,L)=>{let z=m.pxRound,G=e,F=i*We,U=a*We,D=l*We,O,Z;v.ori==0?[O,Z]=r(f,p):[Z,O]=r(f,p);let X=v.dir*(v.ori==0?1:-1),J=v.ori==0?yp:Mx,nt=v.ori==0?u:(Nt,se,_e,Ct,tn,Yt,ne)=>{u(Nt,se,_e,tn,Ct,ne,Yt)},dt=ke(f.bands,gx).find(Nt=>Nt.series[0]==p),ft=dt!=null?dt.dir:0,st=m.fillTo(f,p,m.min,m.max,ft),yt=z(_(st,A,L,N)),xt,Tt,At,Jt=R,xe=z(m.width*We),jt=!1,Te=null,Me=null,me=null,xn=null;h!=null&&(xe==0||d!=null)&&(jt=!0,Te=h.values(f,p,y,g),Me=new Map,new Set(Te).forEach(Nt=>{Nt!=null&&Me.set(Nt,new Path2D)}),xe>0&&(me=d.values(f,p,y,g),xn=new Map,new Set(me).forEach(Nt=>{Nt!=null&&xn.set(Nt,new Path2D)})));let{x0:on,size:In}=c;if(on!=null&&In!=null){G=1,x=on.values(f,p,y,g),on.unit==2&&(x=x.map(_e=>f.posToVal(M+_e*R,v.key,!0)));let Nt=In.values(f,p,y,g);In.unit==2?Tt=Nt[0]*R:Tt=S(Nt[0],v,R,M)-S(0,v,R,M),Jt=zM(x,w,S,v,R,M,Jt),At=Jt-Tt+F}else Jt=zM(x,w,S,v,R,M,Jt),At=Jt*o+F,Tt=Jt-At;At<1&&(At=0),xe>=Tt/2&&(xe=0),At<5&&(z=jM);let Je=At>0,Zn=Jt-At-(Je?xe:0);Tt=z(sx(Zn,D,U)),xt=(G==0?Tt/2:G==X?0:Tt)-G*X*((G==0?F/2:0)+(Je?xe/2:0));let Ue={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},kn=jt?null:new Path2D,Mn=null;if(dt!=null)Mn=f.data[dt.series[1]];else{let{y0:Nt,y1:se}=c;Nt!=null&&se!=null&&(w=se.values(f,p,y,g),Mn=Nt.values(f,p,y,g))}let Ln=O*Tt,$=Z*Tt;for(let Nt=X==1?y:g;Nt>=y&&Nt<=g;Nt+=X){let se=w[Nt];if(se==null)continue;if(Mn!=null){let j=Mn[Nt]??0;if(se-j==0)continue;yt=_(j,A,L,N)}let _e=v.distr!=2||c!=null?x[Nt]:Nt,Ct=S(_e,v,R,M),tn=_(ke(se,st),A,L,N),Yt=z(Ct-xt),ne=z(Di(tn,yt)),B=z(Vs(tn,yt)),C=ne-B;if(se!=null){let j=se<0?$:Ln,mt=se<0?Ln:$;jt?(xe>0&&me[Nt]!=null&&J(xn.get(me[Nt]),Yt,B+os(xe/2),Tt,Di(0,C-xe),j,mt),Te[Nt]!=null&&J(Me.get(Te[Nt]),Yt,B+os(xe/2),Tt,Di(0,C-xe),j,mt)):J(kn,Yt,B+os(xe/2),Tt,Di(0,C-xe),j,mt),nt(f,p,Nt,Yt-xe/2,B,Tt+xe,C)}}return xe>0?Ue.stroke=jt?xn:kn:jt||(Ue._fill=m.width==0?m._fill:m._stroke??m._fill,Ue.width=0),Ue.fill=jt?Me:kn,Ue})}function MD(n,t){let e=ke(t?.alignGaps,0);return(i,s,r,o)=>fa(i,s,(a,l,c,u,h,d,f,p,y,g,m)=>{[r,o]=dp(c,r,o);let x=a.pxRound,w=O=>x(d(O,u,g,p)),v=O=>x(f(O,h,m,y)),A,S,_;u.ori==0?(A=xp,_=Bl,S=wS):(A=_p,_=kl,S=MS);let M=u.dir*(u.ori==0?1:-1),N=w(l[M==1?r:o]),R=N,L=[],z=[];for(let O=M==1?r:o;O>=r&&O<=o;O+=M)if(c[O]!=null){let X=l[O],J=w(X);L.push(R=J),z.push(v(c[O]))}let G={stroke:n(L,z,A,_,S,x),fill:null,clip:null,band:null,gaps:null,flags:Ol},F=G.stroke,[U,D]=bx(i,s);if(a.fill!=null||U!=0){let O=G.fill=new Path2D(F),Z=a.fillTo(i,s,a.min,a.max,U),X=v(Z);_(O,R,X),_(O,N,X)}if(!a.spanGaps){let O=[];O.push(...wx(l,c,r,o,M,w,e)),G.gaps=O=a.gaps(i,s,r,o,O),G.clip=gp(O,u.ori,p,y,g,m)}return D!=0&&(G.band=D==2?[Wr(i,s,r,o,F,-1),Wr(i,s,r,o,F,1)]:Wr(i,s,r,o,F,D)),G})}function SD(n){return MD(ED,n)}function ED(n,t,e,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(e(a,n[0],t[0]),o==2)i(a,n[1],t[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let d=0;d<o-1;d++)u[d]=t[d+1]-t[d],h[d]=n[d+1]-n[d],c[d]=u[d]/h[d];l[0]=c[0];for(let d=1;d<o-1;d++)c[d]===0||c[d-1]===0||c[d-1]>0!=c[d]>0?l[d]=0:(l[d]=3*(h[d-1]+h[d])/((2*h[d]+h[d-1])/c[d-1]+(h[d]+2*h[d-1])/c[d]),isFinite(l[d])||(l[d]=0));l[o-1]=c[o-2];for(let d=0;d<o-1;d++)s(a,n[d]+h[d]/3,t[d]+l[d]*h[d]/3,n[d+1]-h[d]/3,t[d+1]-l[d+1]*h[d]/3,n[d+1],t[d+1])}return a}var lx=new Set;function HM(){for(let n of lx)n.syncRect(!0)}Fl&&(ha(rL,Ll,HM),ha(oL,Ll,HM,!0),ha(cp,Ll,()=>{ai.pxRatio=We}));var TD=TS(),AD=SS();function GM(n,t,e,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>cx(r,o,t,e))}function RD(n,t){return n.map((e,i)=>i==0?{}:Bn({},t,e))}function cx(n,t,e,i){return Bn({},t==0?e:i,n)}function AS(n,t,e){return t==null?Nl:[t,e]}var CD=AS;function PD(n,t,e){return t==null?Nl:up(t,e,px,!0)}function RS(n,t,e,i){return t==null?Nl:fp(t,e,n.scales[i].log,!1)}var ID=RS;function CS(n,t,e,i){return t==null?Nl:fx(t,e,n.scales[i].log,!1)}var LD=CS;function DD(n,t,e,i,s){let r=Di(vM(n),vM(t)),o=t-n,a=Gs(s/i*o,e);do{let l=e[a],c=i*l/o;if(c>=s&&r+(l<5?Ao.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function VM(n){let t,e;return n=n.replace(/(\d+)px/,(i,s)=>(t=Yn((e=+s)*We))+"px"),[n,t,e]}function ND(n){n.show&&[n.font,n.labelFont].forEach(t=>{let e=rn(t[2]*We,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function ai(n,t,e){let i={mode:ke(n.mode,1)},s=i.mode;function r(T,P,k,H){let Y=P.valToPct(T);return H+k*(P.dir==-1?1-Y:Y)}function o(T,P,k,H){let Y=P.valToPct(T);return H+k*(P.dir==-1?Y:1-Y)}function a(T,P,k,H){return P.ori==0?r(T,P,k,H):o(T,P,k,H)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=vs(H2);if(n.id!=null&&(c.id=n.id),rs(c,n.class),n.title){let T=vs(W2,c);T.textContent=n.title}let u=Hs("canvas"),h=i.ctx=u.getContext("2d"),d=vs($2,c);ha("click",d,T=>{T.target===p&&(ln!=Ta||_n!=Aa)&&si.click(i,T)},!0);let f=i.under=vs(q2,d);d.appendChild(u);let p=i.over=vs(X2,d);n=Ul(n);let y=+ke(n.pxAlign,1),g=kM(y);(n.plugins||[]).forEach(T=>{T.opts&&(n=T.opts(i,n)||n)});let m=n.ms||.001,x=i.series=s==1?GM(n.series||[],LM,FM,!1):RD(n.series||[null],OM),w=i.axes=GM(n.axes||[],IM,NM,!0),v=i.scales={},A=i.bands=n.bands||[];A.forEach(T=>{T.fill=Ne(T.fill||null),T.dir=ke(T.dir,-1)});let S=s==2?x[1].facets[0].scale:x[0].scale,_={axes:vr,series:Ce},M=(n.drawOrder||["axes","series"]).map(T=>_[T]);function N(T){let P=T.distr==3?k=>Vr(k>0?k:T.clamp(i,k,T.min,T.max,T.key)):T.distr==4?k=>Z0(k,T.asinh):T.distr==100?k=>T.fwd(k):k=>k;return k=>{let H=P(k),{_min:Y,_max:et}=T,ht=et-Y;return(H-Y)/ht}}function R(T){let P=v[T];if(P==null){let k=(n.scales||Fu)[T]||Fu;if(k.from!=null){R(k.from);let H=Bn({},v[k.from],k,{key:T});H.valToPct=N(H),v[T]=H}else{P=v[T]=Bn({},T==S?xS:gD,k),P.key=T;let H=P.time,Y=P.range,et=To(Y);if((T!=S||s==2&&!H)&&(et&&(Y[0]==null||Y[1]==null)&&(Y={min:Y[0]==null?xM:{mode:1,hard:Y[0],soft:Y[0]},max:Y[1]==null?xM:{mode:1,hard:Y[1],soft:Y[1]}},et=!1),!et&&mp(Y))){let ht=Y;Y=(_t,Et,zt)=>Et==null?Nl:up(Et,zt,ht)}P.range=Ne(Y||(H?CD:T==S?P.distr==3?ID:P.distr==4?LD:AS:P.distr==3?RS:P.distr==4?CS:PD)),P.auto=Ne(et?!1:P.auto),P.clamp=Ne(P.clamp||mD),P._min=P._max=null,P.valToPct=N(P)}}}R("x"),R("y"),s==1&&x.forEach(T=>{R(T.scale)}),w.forEach(T=>{R(T.scale)});for(let T in n.scales)R(T);let L=v[S],z=L.distr,G,F;L.ori==0?(rs(c,G2),G=r,F=o):(rs(c,V2),G=o,F=r);let U={};for(let T in v){let P=v[T];(P.min!=null||P.max!=null)&&(U[T]={min:P.min,max:P.max},P.min=P.max=null)}let D=n.tzDate||(T=>new Date(Yn(T/m))),O=n.fmtDate||xx,Z=m==1?GL(D):$L(D),X=RM(D,AM(m==1?HL:WL,O)),J=PM(D,CM(XL,O)),nt=[],dt=i.legend=Bn({},ZL,n.legend),ft=i.cursor=Bn({},nD,{drag:{y:s==2}},n.cursor),st=dt.show,yt=ft.show,xt=dt.markers;dt.idxs=nt,xt.width=Ne(xt.width),xt.dash=Ne(xt.dash),xt.stroke=Ne(xt.stroke),xt.fill=Ne(xt.fill);let Tt,At,Jt,xe=[],jt=[],Te,Me=!1,me={};if(dt.live){let T=x[1]?x[1].values:null;Me=T!=null,Te=Me?T(i,1,0):{_:0};for(let P in Te)me[P]=hx}if(st)if(Tt=Hs("table",Q2,c),Jt=Hs("tbody",null,Tt),dt.mount(i,Tt),Me){At=Hs("thead",null,Tt,Jt);let T=Hs("tr",null,At);Hs("th",null,T);for(var xn in Te)Hs("th",sM,T).textContent=xn}else rs(Tt,eL),dt.live&&rs(Tt,tL);let on={show:!0},In={show:!1};function Je(T,P){if(P==0&&(Me||!dt.live||s==2))return Nl;let k=[],H=Hs("tr",nL,Jt,Jt.childNodes[P]);rs(H,T.class),T.show||rs(H,ua);let Y=Hs("th",null,H);if(xt.show){let _t=vs(iL,Y);if(P>0){let Et=xt.width(i,P);Et&&(_t.style.border=Et+"px "+xt.dash(i,P)+" "+xt.stroke(i,P)),_t.style.background=xt.fill(i,P)}}let et=vs(sM,Y);T.label instanceof HTMLElement?et.appendChild(T.label):et.textContent=T.label,P>0&&(xt.show||(et.style.color=T.width>0?xt.stroke(i,P):xt.fill(i,P)),Ue("click",Y,_t=>{if(ft._lock)return;ae(_t);let Et=x.indexOf(T);if((_t.ctrlKey||_t.metaKey)!=dt.isolate){let zt=x.some((Ht,Wt)=>Wt>0&&Wt!=Et&&Ht.show);x.forEach((Ht,Wt)=>{Wt>0&&Ys(Wt,zt?Wt==Et?on:In:on,!0,On.setSeries)})}else Ys(Et,{show:!T.show},!0,On.setSeries)},!1),le&&Ue(lM,Y,_t=>{ft._lock||(ae(_t),Ys(x.indexOf(T),Ca,!0,On.setSeries))},!1));for(var ht in Te){let _t=Hs("td",sL,H);_t.textContent="--",k.push(_t)}return[H,k]}let Zn=new Map;function Ue(T,P,k,H=!0){let Y=Zn.get(P)||{},et=ft.bind[T](i,P,k,H);et&&(ha(T,P,Y[T]=et),Zn.set(P,Y))}function kn(T,P,k){let H=Zn.get(P)||{};for(let Y in H)(T==null||Y==T)&&(ix(Y,P,H[Y]),delete H[Y]);T==null&&Zn.delete(P)}let Mn=0,Ln=0,$=0,Nt=0,se=0,_e=0,Ct=se,tn=_e,Yt=$,ne=Nt,B=0,C=0,j=0,mt=0;i.bbox={};let ut=!1,Mt=!1,St=!1,rt=!1,at=!1,vt=!1;function W(T,P,k){(k||T!=i.width||P!=i.height)&&ct(T,P),Se(!1),St=!0,Mt=!0,ui()}function ct(T,P){i.width=Mn=$=T,i.height=Ln=Nt=P,se=_e=0,Rt(),Zt();let k=i.bbox;B=k.left=la(se*We,.5),C=k.top=la(_e*We,.5),j=k.width=la($*We,.5),mt=k.height=la(Nt*We,.5)}let ot=3;function Pt(){let T=!1,P=0;for(;!T;){P++;let k=Ma(P),H=Xs(P);T=P==ot||k&&H,T||(ct(i.width,i.height),Mt=!0)}}function wt({width:T,height:P}){W(T,P)}i.setSize=wt;function Rt(){let T=!1,P=!1,k=!1,H=!1;w.forEach((Y,et)=>{if(Y.show&&Y._show){let{side:ht,_size:_t}=Y,Et=ht%2,zt=Y.label!=null?Y.labelSize:0,Ht=_t+zt;Ht>0&&(Et?($-=Ht,ht==3?(se+=Ht,H=!0):k=!0):(Nt-=Ht,ht==0?(_e+=Ht,T=!0):P=!0))}}),$s[0]=T,$s[1]=k,$s[2]=P,$s[3]=H,$-=Ss[1]+Ss[3],se+=Ss[3],Nt-=Ss[2]+Ss[0],_e+=Ss[0]}function Zt(){let T=se+$,P=_e+Nt,k=se,H=_e;function Y(et,ht){switch(et){case 1:return T+=ht,T-ht;case 2:return P+=ht,P-ht;case 3:return k-=ht,k+ht;case 0:return H-=ht,H+ht}}w.forEach((et,ht)=>{if(et.show&&et._show){let _t=et.side;et._pos=Y(_t,et._size),et.label!=null&&(et._lpos=Y(_t,et.labelSize))}})}if(ft.dataIdx==null){let T=ft.hover,P=T.skip=new Set(T.skip??[]);P.add(void 0);let k=T.prox=Ne(T.prox),H=T.bias??=0;ft.dataIdx=(Y,et,ht,_t)=>{if(et==0)return ht;let Et=ht,zt=k(Y,et,ht,_t)??sn,Ht=zt>=0&&zt<sn,Wt=L.ori==0?$:Nt,ge=ft.left,ze=t[0],Fe=t[et];if(P.has(Fe[ht])){Et=null;let Pe=null,oe=null,Kt;if(H==0||H==-1)for(Kt=ht;Pe==null&&Kt-- >0;)P.has(Fe[Kt])||(Pe=Kt);if(H==0||H==1)for(Kt=ht;oe==null&&Kt++<Fe.length;)P.has(Fe[Kt])||(oe=Kt);if(Pe!=null||oe!=null)if(Ht){let un=Pe==null?-1/0:G(ze[Pe],L,Wt,0),Tn=oe==null?1/0:G(ze[oe],L,Wt,0),ti=ge-un,Ke=Tn-ge;ti<=Ke?ti<=zt&&(Et=Pe):Ke<=zt&&(Et=oe)}else Et=oe==null?Pe:Pe==null?oe:ht-Pe<=oe-ht?Pe:oe}else Ht&&jn(ge-G(ze[ht],L,Wt,0))>zt&&(Et=null);return Et}}let ae=T=>{ft.event=T};ft.idxs=nt,ft._lock=!1;let pt=ft.points;pt.show=Ne(pt.show),pt.size=Ne(pt.size),pt.stroke=Ne(pt.stroke),pt.width=Ne(pt.width),pt.fill=Ne(pt.fill);let $t=i.focus=Bn({},n.focus||{alpha:.3},ft.focus),le=$t.prox>=0,Dt=le&&pt.one,ve=[],an=[],yi=[];function nc(T,P){let k=pt.show(i,P);if(k instanceof HTMLElement)return rs(k,K2),rs(k,T.class),pr(k,-10,-10,$,Nt),p.insertBefore(k,ve[P]),k}function va(T,P){if(s==1||P>0){let k=s==1&&v[T.scale].time,H=T.value;T.value=k?MM(H)?PM(D,CM(H,O)):H||J:H||dD,T.label=T.label||(k?sD:iD)}if(Dt||P>0){T.width=T.width==null?1:T.width,T.paths=T.paths||TD||gL,T.fillTo=Ne(T.fillTo||xD),T.pxAlign=+ke(T.pxAlign,y),T.pxRound=kM(T.pxAlign),T.stroke=Ne(T.stroke||null),T.fill=Ne(T.fill||null),T._stroke=T._fill=T._paths=T._focus=null;let k=fD(Di(1,T.width),1),H=T.points=Bn({},{size:k,width:Di(1,k*.2),stroke:T.stroke,space:k*2,paths:AD,_stroke:null,_fill:null},T.points);H.show=Ne(H.show),H.filter=Ne(H.filter),H.fill=Ne(H.fill),H.stroke=Ne(H.stroke),H.paths=Ne(H.paths),H.pxAlign=T.pxAlign}if(st){let k=Je(T,P);xe.splice(P,0,k[0]),jt.splice(P,0,k[1]),dt.values.push(null)}if(yt){nt.splice(P,0,null);let k=null;Dt?P==0&&(k=nc(T,P)):P>0&&(k=nc(T,P)),ve.splice(P,0,k),an.splice(P,0,0),yi.splice(P,0,0)}Qn("addSeries",P)}function sm(T,P){P=P??x.length,T=s==1?cx(T,P,LM,FM):cx(T,P,{},OM),x.splice(P,0,T),va(x[P],P)}i.addSeries=sm;function Zu(T){if(x.splice(T,1),st){dt.values.splice(T,1),jt.splice(T,1);let P=xe.splice(T,1)[0];kn(null,P.firstChild),P.remove()}yt&&(nt.splice(T,1),ve.splice(T,1)[0].remove(),an.splice(T,1),yi.splice(T,1)),Qn("delSeries",T)}i.delSeries=Zu;let $s=[!1,!1,!1,!1];function xr(T,P){if(T._show=T.show,T.show){let k=T.side%2,H=v[T.scale];H==null&&(T.scale=k?x[1].scale:S,H=v[T.scale]);let Y=H.time;T.size=Ne(T.size),T.space=Ne(T.space),T.rotate=Ne(T.rotate),To(T.incrs)&&T.incrs.forEach(ht=>{!Ao.has(ht)&&Ao.set(ht,KM(ht))}),T.incrs=Ne(T.incrs||(H.distr==2?BL:Y?m==1?zL:VL:ca)),T.splits=Ne(T.splits||(Y&&H.distr==1?Z:H.distr==3?rx:H.distr==4?aD:oD)),T.stroke=Ne(T.stroke),T.grid.stroke=Ne(T.grid.stroke),T.ticks.stroke=Ne(T.ticks.stroke),T.border.stroke=Ne(T.border.stroke);let et=T.values;T.values=To(et)&&!To(et[0])?Ne(et):Y?To(et)?RM(D,AM(et,O)):MM(et)?qL(D,et):et||X:et||rD,T.filter=Ne(T.filter||(H.distr>=3&&H.log==10?uD:H.distr==3&&H.log==2?hD:ZM)),T.font=VM(T.font),T.labelFont=VM(T.labelFont),T._size=T.size(i,null,P,0),T._space=T._rotate=T._incrs=T._found=T._splits=T._values=null,T._size>0&&($s[P]=!0,T._el=vs(Y2,d))}}function _r(T,P,k,H){let[Y,et,ht,_t]=k,Et=P%2,zt=0;return Et==0&&(_t||et)&&(zt=P==0&&!Y||P==2&&!ht?Yn(IM.size/3):0),Et==1&&(Y||ht)&&(zt=P==1&&!et||P==3&&!_t?Yn(NM.size/2):0),zt}let ic=i.padding=(n.padding||[_r,_r,_r,_r]).map(T=>Ne(ke(T,_r))),Ss=i._padding=ic.map((T,P)=>T(i,P,$s,0)),Sn,Cn=null,Pn=null,qs=s==1?x[0].idxs:null,Xi=null,Zr=!1;function sc(T,P){if(t=T??[],i.data=i._data=t,s==2){Sn=0;for(let k=1;k<x.length;k++)Sn+=t[k][0].length}else{t.length==0&&(i.data=i._data=t=[[]]),Xi=t[0],Sn=Xi.length;let k=t;if(z==2){k=t.slice();let H=k[0]=Array(Sn);for(let Y=0;Y<Sn;Y++)H[Y]=Y}i._data=t=k}if(Se(!0),Qn("setData"),z==2&&(St=!0),P!==!1){let k=L;k.auto(i,Zr)?rc():Qr(S,k.min,k.max),rt=rt||ft.left>=0,vt=!0,ui()}}i.setData=sc;function rc(){Zr=!0;let T,P;s==1&&(Sn>0?(Cn=qs[0]=0,Pn=qs[1]=Sn-1,T=t[0][Cn],P=t[0][Pn],z==2?(T=Cn,P=Pn):T==P&&(z==3?[T,P]=fp(T,T,L.log,!1):z==4?[T,P]=fx(T,T,L.log,!1):L.time?P=T+Yn(86400/m):[T,P]=up(T,P,px,!0))):(Cn=qs[0]=T=null,Pn=qs[1]=P=null)),Qr(S,T,P)}let ba,Jr,wa,I,q,it,Q,tt,It,Ot;function Lt(T,P,k,H,Y,et){T??=oM,k??=gx,H??="butt",Y??=oM,et??="round",T!=ba&&(h.strokeStyle=ba=T),Y!=Jr&&(h.fillStyle=Jr=Y),P!=wa&&(h.lineWidth=wa=P),et!=q&&(h.lineJoin=q=et),H!=it&&(h.lineCap=it=H),k!=I&&h.setLineDash(I=k)}function Bt(T,P,k,H){P!=Jr&&(h.fillStyle=Jr=P),T!=Q&&(h.font=Q=T),k!=tt&&(h.textAlign=tt=k),H!=It&&(h.textBaseline=It=H)}function Xt(T,P,k,H,Y=0){if(H.length>0&&T.auto(i,Zr)&&(P==null||P.min==null)){let et=ke(Cn,0),ht=ke(Pn,H.length-1),_t=k.min==null?uL(H,et,ht,Y,T.distr==3):[k.min,k.max];T.min=Vs(T.min,k.min=_t[0]),T.max=Di(T.max,k.max=_t[1])}}let he={min:null,max:null};function Re(){for(let H in v){let Y=v[H];U[H]==null&&(Y.min==null||U[S]!=null&&Y.auto(i,Zr))&&(U[H]=he)}for(let H in v){let Y=v[H];U[H]==null&&Y.from!=null&&U[Y.from]!=null&&(U[H]=he)}U[S]!=null&&Se(!0);let T={};for(let H in U){let Y=U[H];if(Y!=null){let et=T[H]=Ul(v[H],yL);if(Y.min!=null)Bn(et,Y);else if(H!=S||s==2)if(Sn==0&&et.from==null){let ht=et.range(i,null,null,H);et.min=ht[0],et.max=ht[1]}else et.min=sn,et.max=-sn}}if(Sn>0){x.forEach((H,Y)=>{if(s==1){let et=H.scale,ht=U[et];if(ht==null)return;let _t=T[et];if(Y==0){let Et=_t.range(i,_t.min,_t.max,et);_t.min=Et[0],_t.max=Et[1],Cn=Gs(_t.min,t[0]),Pn=Gs(_t.max,t[0]),Pn-Cn>1&&(t[0][Cn]<_t.min&&Cn++,t[0][Pn]>_t.max&&Pn--),H.min=Xi[Cn],H.max=Xi[Pn]}else H.show&&H.auto&&Xt(_t,ht,H,t[Y],H.sorted);H.idxs[0]=Cn,H.idxs[1]=Pn}else if(Y>0&&H.show&&H.auto){let[et,ht]=H.facets,_t=et.scale,Et=ht.scale,[zt,Ht]=t[Y],Wt=T[_t],ge=T[Et];Wt!=null&&Xt(Wt,U[_t],et,zt,et.sorted),ge!=null&&Xt(ge,U[Et],ht,Ht,ht.sorted),H.min=ht.min,H.max=ht.max}});for(let H in T){let Y=T[H],et=U[H];if(Y.from==null&&(et==null||et.min==null)){let ht=Y.range(i,Y.min==sn?null:Y.min,Y.max==-sn?null:Y.max,H);Y.min=ht[0],Y.max=ht[1]}}}for(let H in T){let Y=T[H];if(Y.from!=null){let et=T[Y.from];if(et.min==null)Y.min=Y.max=null;else{let ht=Y.range(i,et.min,et.max,H);Y.min=ht[0],Y.max=ht[1]}}}let P={},k=!1;for(let H in T){let Y=T[H],et=v[H];if(et.min!=Y.min||et.max!=Y.max){et.min=Y.min,et.max=Y.max;let ht=et.distr;et._min=ht==3?Vr(et.min):ht==4?Z0(et.min,et.asinh):ht==100?et.fwd(et.min):et.min,et._max=ht==3?Vr(et.max):ht==4?Z0(et.max,et.asinh):ht==100?et.fwd(et.max):et.max,P[H]=k=!0}}if(k){x.forEach((H,Y)=>{s==2?Y>0&&P.y&&(H._paths=null):P[H.scale]&&(H._paths=null)});for(let H in P)St=!0,Qn("setScale",H);yt&&ft.left>=0&&(rt=vt=!0)}for(let H in U)U[H]=null}function qt(T){let P=sx(Cn-1,0,Sn-1),k=sx(Pn+1,0,Sn-1);for(;T[P]==null&&P>0;)P--;for(;T[k]==null&&k<Sn-1;)k++;return[P,k]}function Ce(){if(Sn>0){let T=x.some(P=>P._focus)&&Ot!=$t.alpha;T&&(h.globalAlpha=Ot=$t.alpha),x.forEach((P,k)=>{if(k>0&&P.show&&(vn(k,!1),vn(k,!0),P._paths==null)){let H=Ot;Ot!=P.alpha&&(h.globalAlpha=Ot=P.alpha);let Y=s==2?[0,t[k][0].length-1]:qt(t[k]);P._paths=P.paths(i,k,Y[0],Y[1]),Ot!=H&&(h.globalAlpha=Ot=H)}}),x.forEach((P,k)=>{if(k>0&&P.show){let H=Ot;Ot!=P.alpha&&(h.globalAlpha=Ot=P.alpha),P._paths!=null&&Xe(k,!1);{let Y=P._paths!=null?P._paths.gaps:null,et=P.points.show(i,k,Cn,Pn,Y),ht=P.points.filter(i,k,et,Y);(et||ht)&&(P.points._paths=P.points.paths(i,k,Cn,Pn,ht),Xe(k,!0))}Ot!=H&&(h.globalAlpha=Ot=H),Qn("drawSeries",k)}}),T&&(h.globalAlpha=Ot=1)}}function vn(T,P){let k=P?x[T].points:x[T];k._stroke=k.stroke(i,T),k._fill=k.fill(i,T)}function Xe(T,P){let k=P?x[T].points:x[T],{stroke:H,fill:Y,clip:et,flags:ht,_stroke:_t=k._stroke,_fill:Et=k._fill,_width:zt=k.width}=k._paths;zt=rn(zt*We,3);let Ht=null,Wt=zt%2/2;P&&Et==null&&(Et=zt>0?"#fff":_t);let ge=k.pxAlign==1&&Wt>0;if(ge&&h.translate(Wt,Wt),!P){let ze=B-zt/2,Fe=C-zt/2,Pe=j+zt,oe=mt+zt;Ht=new Path2D,Ht.rect(ze,Fe,Pe,oe)}P?Vt(_t,zt,k.dash,k.cap,Et,H,Y,ht,et):Ye(T,_t,zt,k.dash,k.cap,Et,H,Y,ht,Ht,et),ge&&h.translate(-Wt,-Wt)}function Ye(T,P,k,H,Y,et,ht,_t,Et,zt,Ht){let Wt=!1;Et!=0&&A.forEach((ge,ze)=>{if(ge.series[0]==T){let Fe=x[ge.series[1]],Pe=t[ge.series[1]],oe=(Fe._paths||Fu).band;To(oe)&&(oe=ge.dir==1?oe[0]:oe[1]);let Kt,un=null;Fe.show&&oe&&dL(Pe,Cn,Pn)?(un=ge.fill(i,ze)||et,Kt=Fe._paths.clip):oe=null,Vt(P,k,H,Y,un,ht,_t,Et,zt,Ht,Kt,oe),Wt=!0}}),Wt||Vt(P,k,H,Y,et,ht,_t,Et,zt,Ht)}let zn=Ol|ax;function Vt(T,P,k,H,Y,et,ht,_t,Et,zt,Ht,Wt){Lt(T,P,k,H,Y),(Et||zt||Wt)&&(h.save(),Et&&h.clip(Et),zt&&h.clip(zt)),Wt?(_t&zn)==zn?(h.clip(Wt),Ht&&h.clip(Ht),Le(Y,ht),Dn(T,et,P)):_t&ax?(Le(Y,ht),h.clip(Wt),Dn(T,et,P)):_t&Ol&&(h.save(),h.clip(Wt),Ht&&h.clip(Ht),Le(Y,ht),h.restore(),Dn(T,et,P)):(Le(Y,ht),Dn(T,et,P)),(Et||zt||Wt)&&h.restore()}function Dn(T,P,k){k>0&&(P instanceof Map?P.forEach((H,Y)=>{h.strokeStyle=ba=Y,h.stroke(H)}):P!=null&&T&&h.stroke(P))}function Le(T,P){P instanceof Map?P.forEach((k,H)=>{h.fillStyle=Jr=H,h.fill(k)}):P!=null&&T&&h.fill(P)}function yr(T,P,k,H){let Y=w[T],et;if(H<=0)et=[0,0];else{let ht=Y._space=Y.space(i,T,P,k,H),_t=Y._incrs=Y.incrs(i,T,P,k,H,ht);et=DD(P,k,_t,H,ht)}return Y._found=et}function Nn(T,P,k,H,Y,et,ht,_t,Et,zt){let Ht=ht%2/2;y==1&&h.translate(Ht,Ht),Lt(_t,ht,Et,zt,_t),h.beginPath();let Wt,ge,ze,Fe,Pe=Y+(H==0||H==3?-et:et);k==0?(ge=Y,Fe=Pe):(Wt=Y,ze=Pe);for(let oe=0;oe<T.length;oe++)P[oe]!=null&&(k==0?Wt=ze=T[oe]:ge=Fe=T[oe],h.moveTo(Wt,ge),h.lineTo(ze,Fe));h.stroke(),y==1&&h.translate(-Ht,-Ht)}function Ma(T){let P=!0;return w.forEach((k,H)=>{if(!k.show)return;let Y=v[k.scale];if(Y.min==null){k._show&&(P=!1,k._show=!1,Se(!1));return}else k._show||(P=!1,k._show=!0,Se(!1));let et=k.side,ht=et%2,{min:_t,max:Et}=Y,[zt,Ht]=yr(H,_t,Et,ht==0?$:Nt);if(Ht==0)return;let Wt=Y.distr==2,ge=k._splits=k.splits(i,H,_t,Et,zt,Ht,Wt),ze=Y.distr==2?ge.map(Kt=>Xi[Kt]):ge,Fe=Y.distr==2?Xi[ge[1]]-Xi[ge[0]]:zt,Pe=k._values=k.values(i,k.filter(i,ze,H,Ht,Fe),H,Ht,Fe);k._rotate=et==2?k.rotate(i,Pe,H,Ht):0;let oe=k._size;k._size=bs(k.size(i,Pe,H,T)),oe!=null&&k._size!=oe&&(P=!1)}),P}function Xs(T){let P=!0;return ic.forEach((k,H)=>{let Y=k(i,H,$s,T);Y!=Ss[H]&&(P=!1),Ss[H]=Y}),P}function vr(){for(let T=0;T<w.length;T++){let P=w[T];if(!P.show||!P._show)continue;let k=P.side,H=k%2,Y,et,ht=P.stroke(i,T),_t=k==0||k==3?-1:1,[Et,zt]=P._found;if(P.label!=null){let wi=P.labelGap*_t,Zi=Yn((P._lpos+wi)*We);Bt(P.labelFont[0],ht,"center",k==2?"top":rM),h.save(),H==1?(Y=et=0,h.translate(Zi,Yn(C+mt/2)),h.rotate((k==3?-lp:lp)/2)):(Y=Yn(B+j/2),et=Zi);let Bo=YM(P.label)?P.label(i,T,Et,zt):P.label;h.fillText(Bo,Y,et),h.restore()}if(zt==0)continue;let Ht=v[P.scale],Wt=H==0?j:mt,ge=H==0?B:C,ze=P._splits,Fe=Ht.distr==2?ze.map(wi=>Xi[wi]):ze,Pe=Ht.distr==2?Xi[ze[1]]-Xi[ze[0]]:Et,oe=P.ticks,Kt=P.border,un=oe.show?oe.size:0,Tn=Yn(un*We),ti=Yn((P.alignTo==2?P._size-un-P.gap:P.gap)*We),Ke=P._rotate*-lp/180,An=g(P._pos*We),Yi=(Tn+ti)*_t,bi=An+Yi;et=H==0?bi:0,Y=H==1?bi:0;let us=P.font[0],Es=P.align==1?Pl:P.align==2?X0:Ke>0?Pl:Ke<0?X0:H==0?"center":k==3?X0:Pl,Zs=Ke||H==1?"middle":k==2?"top":rM;Bt(us,ht,Es,Zs);let ji=P.font[1]*P.lineGap,hs=ze.map(wi=>g(a(wi,Ht,Wt,ge))),Ts=P._values;for(let wi=0;wi<Ts.length;wi++){let Zi=Ts[wi];if(Zi!=null){H==0?Y=hs[wi]:et=hs[wi],Zi=""+Zi;let Bo=Zi.indexOf(`
`)==-1?[Zi]:Zi.split(/\n/gm);for(let Mi=0;Mi<Bo.length;Mi++){let D_=Bo[Mi];Ke?(h.save(),h.translate(Y,et+Mi*ji),h.rotate(Ke),h.fillText(D_,0,0),h.restore()):h.fillText(D_,Y,et+Mi*ji)}}}oe.show&&Nn(hs,oe.filter(i,Fe,T,zt,Pe),H,k,An,Tn,rn(oe.width*We,3),oe.stroke(i,T),oe.dash,oe.cap);let Js=P.grid;Js.show&&Nn(hs,Js.filter(i,Fe,T,zt,Pe),H,H==0?2:1,H==0?C:B,H==0?mt:j,rn(Js.width*We,3),Js.stroke(i,T),Js.dash,Js.cap),Kt.show&&Nn([An],[1],H==0?1:0,H==0?1:2,H==1?C:B,H==1?mt:j,rn(Kt.width*We,3),Kt.stroke(i,T),Kt.dash,Kt.cap)}Qn("drawAxes")}function Se(T){x.forEach((P,k)=>{k>0&&(P._paths=null,T&&(s==1?(P.min=null,P.max=null):P.facets.forEach(H=>{H.min=null,H.max=null})))})}let En=!1,vi=!1,je=[];function Un(){vi=!1;for(let T=0;T<je.length;T++)Qn(...je[T]);je.length=0}function ui(){En||(TL(m_),En=!0)}function Ju(T,P=!1){En=!0,vi=P,T(i),m_(),P&&je.length>0&&queueMicrotask(Un)}i.batch=Ju;function m_(){if(ut&&(Re(),ut=!1),St&&(Pt(),St=!1),Mt){if(gn(f,Pl,se),gn(f,"top",_e),gn(f,Du,$),gn(f,Nu,Nt),gn(p,Pl,se),gn(p,"top",_e),gn(p,Du,$),gn(p,Nu,Nt),gn(d,Du,Mn),gn(d,Nu,Ln),u.width=Yn(Mn*We),u.height=Yn(Ln*We),w.forEach(({_el:T,_show:P,_size:k,_pos:H,side:Y})=>{if(T!=null)if(P){let et=Y===3||Y===0?k:0,ht=Y%2==1;gn(T,ht?"left":"top",H-et),gn(T,ht?"width":"height",k),gn(T,ht?"top":"left",ht?_e:se),gn(T,ht?"height":"width",ht?Nt:$),nx(T,ua)}else rs(T,ua)}),ba=Jr=wa=q=it=Q=tt=It=I=null,Ot=1,lc(!0),se!=Ct||_e!=tn||$!=Yt||Nt!=ne){Se(!1);let T=$/Yt,P=Nt/ne;if(yt&&!rt&&ft.left>=0){ft.left*=T,ft.top*=P,Sa&&pr(Sa,Yn(ft.left),0,$,Nt),Ea&&pr(Ea,0,Yn(ft.top),$,Nt);for(let k=0;k<ve.length;k++){let H=ve[k];H!=null&&(an[k]*=T,yi[k]*=P,pr(H,bs(an[k]),bs(yi[k]),$,Nt))}}if(cn.show&&!at&&cn.left>=0&&cn.width>0){cn.left*=T,cn.width*=T,cn.top*=P,cn.height*=P;for(let k in um)gn(Ra,k,cn[k])}Ct=se,tn=_e,Yt=$,ne=Nt}Qn("setSize"),Mt=!1}Mn>0&&Ln>0&&(h.clearRect(0,0,u.width,u.height),Qn("drawClear"),M.forEach(T=>T()),Qn("draw")),cn.show&&at&&(Ku(cn),at=!1),yt&&rt&&(Fo(null,!0,!1),rt=!1),dt.show&&dt.live&&vt&&(lm(),vt=!1),l||(l=!0,i.status=1,Qn("ready")),Zr=!1,En=!1}i.redraw=(T,P)=>{St=P||!1,T!==!1?Qr(S,L.min,L.max):ui()};function rm(T,P){let k=v[T];if(k.from==null){if(Sn==0){let H=k.range(i,P.min,P.max,T);P.min=H[0],P.max=H[1]}if(P.min>P.max){let H=P.min;P.min=P.max,P.max=H}if(Sn>1&&P.min!=null&&P.max!=null&&P.max-P.min<1e-16)return;T==S&&k.distr==2&&Sn>0&&(P.min=Gs(P.min,t[0]),P.max=Gs(P.max,t[0]),P.min==P.max&&P.max++),U[T]=P,ut=!0,ui()}}i.setScale=rm;let om,am,Sa,Ea,g_,x_,Ta,Aa,__,y_,ln,_n,Kr=!1,si=ft.drag,Jn=si.x,Kn=si.y;yt&&(ft.x&&(om=vs(Z2,p)),ft.y&&(am=vs(J2,p)),L.ori==0?(Sa=om,Ea=am):(Sa=am,Ea=om),ln=ft.left,_n=ft.top);let cn=i.select=Bn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),Ra=cn.show?vs(j2,cn.over?p:f):null;function Ku(T,P){if(cn.show){for(let k in T)cn[k]=T[k],k in um&&gn(Ra,k,T[k]);P!==!1&&Qn("setSelect")}}i.setSelect=Ku;function kE(T){if(x[T].show)st&&nx(xe[T],ua);else if(st&&rs(xe[T],ua),yt){let k=Dt?ve[0]:ve[T];k!=null&&pr(k,-10,-10,$,Nt)}}function Qr(T,P,k){rm(T,{min:P,max:k})}function Ys(T,P,k,H){P.focus!=null&&WE(T),P.show!=null&&x.forEach((Y,et)=>{et>0&&(T==et||T==null)&&(Y.show=P.show,kE(et),s==2?(Qr(Y.facets[0].scale,null,null),Qr(Y.facets[1].scale,null,null)):Qr(Y.scale,null,null),ui())}),k!==!1&&Qn("setSeries",T,P),H&&cc("setSeries",i,T,P)}i.setSeries=Ys;function zE(T,P){Bn(A[T],P)}function HE(T,P){T.fill=Ne(T.fill||null),T.dir=ke(T.dir,-1),P=P??A.length,A.splice(P,0,T)}function GE(T){T==null?A.length=0:A.splice(T,1)}i.addBand=HE,i.setBand=zE,i.delBand=GE;function VE(T,P){x[T].alpha=P,yt&&ve[T]!=null&&(ve[T].style.opacity=P),st&&xe[T]&&(xe[T].style.opacity=P)}let br,to,Oo,Ca={focus:!0};function WE(T){if(T!=Oo){let P=T==null,k=$t.alpha!=1;x.forEach((H,Y)=>{if(s==1||Y>0){let et=P||Y==0||Y==T;H._focus=P?null:et,k&&VE(Y,et?1:$t.alpha)}}),Oo=T,k&&ui()}}st&&le&&Ue(cM,Tt,T=>{ft._lock||(ae(T),Oo!=null&&Ys(null,Ca,!0,On.setSeries))});function js(T,P,k){let H=v[P];k&&(T=T/We-(H.ori==1?_e:se));let Y=$;H.ori==1&&(Y=Nt,T=Y-T),H.dir==-1&&(T=Y-T);let et=H._min,ht=H._max,_t=T/Y,Et=et+(ht-et)*_t,zt=H.distr;return zt==3?Dl(10,Et):zt==4?pL(Et,H.asinh):zt==100?H.bwd(Et):Et}function $E(T,P){let k=js(T,S,P);return Gs(k,t[0],Cn,Pn)}i.valToIdx=T=>Gs(T,t[0]),i.posToIdx=$E,i.posToVal=js,i.valToPos=(T,P,k)=>v[P].ori==0?r(T,v[P],k?j:$,k?B:0):o(T,v[P],k?mt:Nt,k?C:0),i.setCursor=(T,P,k)=>{ln=T.left,_n=T.top,Fo(null,P,k)};function v_(T,P){gn(Ra,Pl,cn.left=T),gn(Ra,Du,cn.width=P)}function b_(T,P){gn(Ra,"top",cn.top=T),gn(Ra,Nu,cn.height=P)}let oc=L.ori==0?v_:b_,ac=L.ori==1?v_:b_;function qE(){if(st&&dt.live)for(let T=s==2?1:0;T<x.length;T++){if(T==0&&Me)continue;let P=dt.values[T],k=0;for(let H in P)jt[T][k++].firstChild.nodeValue=P[H]}}function lm(T,P){if(T!=null&&(T.idxs?T.idxs.forEach((k,H)=>{nt[H]=k}):_L(T.idx)||nt.fill(T.idx),dt.idx=nt[0]),st&&dt.live){for(let k=0;k<x.length;k++)(k>0||s==1&&!Me)&&XE(k,nt[k]);qE()}vt=!1,P!==!1&&Qn("setLegend")}i.setLegend=lm;function XE(T,P){let k=x[T],H=T==0&&z==2?Xi:t[T],Y;Me?Y=k.values(i,T,P)??me:(Y=k.value(i,P==null?null:H[P],T,P),Y=Y==null?me:{_:Y}),dt.values[T]=Y}function Fo(T,P,k){__=ln,y_=_n,[ln,_n]=ft.move(i,ln,_n),ft.left=ln,ft.top=_n,yt&&(Sa&&pr(Sa,Yn(ln),0,$,Nt),Ea&&pr(Ea,0,Yn(_n),$,Nt));let H,Y=Cn>Pn;br=sn,to=null;let et=L.ori==0?$:Nt,ht=L.ori==1?$:Nt;if(ln<0||Sn==0||Y){H=ft.idx=null;for(let _t=0;_t<x.length;_t++){let Et=ve[_t];Et!=null&&pr(Et,-10,-10,$,Nt)}le&&Ys(null,Ca,!0,T==null&&On.setSeries),dt.live&&(nt.fill(H),vt=!0)}else{let _t,Et,zt;s==1&&(_t=L.ori==0?ln:_n,Et=js(_t,S),H=ft.idx=Gs(Et,t[0],Cn,Pn),zt=G(t[0][H],L,et,0));let Ht=-10,Wt=-10,ge=0,ze=0,Fe=!0,Pe="",oe="";for(let Kt=s==2?1:0;Kt<x.length;Kt++){let un=x[Kt],Tn=nt[Kt],ti=Tn==null?null:s==1?t[Kt][Tn]:t[Kt][1][Tn],Ke=ft.dataIdx(i,Kt,H,Et),An=Ke==null?null:s==1?t[Kt][Ke]:t[Kt][1][Ke];if(vt=vt||An!=ti||Ke!=Tn,nt[Kt]=Ke,Kt>0&&un.show){let Yi=Ke==null?-10:Ke==H?zt:G(s==1?t[0][Ke]:t[Kt][0][Ke],L,et,0),bi=An==null?-10:F(An,s==1?v[un.scale]:v[un.facets[1].scale],ht,0);if(le&&An!=null){let us=L.ori==1?ln:_n,Es=jn($t.dist(i,Kt,Ke,bi,us));if(Es<br){let Zs=$t.bias;if(Zs!=0){let ji=js(us,un.scale),hs=An>=0?1:-1,Ts=ji>=0?1:-1;Ts==hs&&(Ts==1?Zs==1?An>=ji:An<=ji:Zs==1?An<=ji:An>=ji)&&(br=Es,to=Kt)}else br=Es,to=Kt}}if(vt||Dt){let us,Es;L.ori==0?(us=Yi,Es=bi):(us=bi,Es=Yi);let Zs,ji,hs,Ts,Js,wi,Zi=!0,Bo=pt.bbox;if(Bo!=null){Zi=!1;let Mi=Bo(i,Kt);hs=Mi.left,Ts=Mi.top,Zs=Mi.width,ji=Mi.height}else hs=us,Ts=Es,Zs=ji=pt.size(i,Kt);if(wi=pt.fill(i,Kt),Js=pt.stroke(i,Kt),Dt)Kt==to&&br<=$t.prox&&(Ht=hs,Wt=Ts,ge=Zs,ze=ji,Fe=Zi,Pe=wi,oe=Js);else{let Mi=ve[Kt];Mi!=null&&(an[Kt]=hs,yi[Kt]=Ts,gM(Mi,Zs,ji,Zi),pM(Mi,wi,Js),pr(Mi,bs(hs),bs(Ts),$,Nt))}}}}if(Dt){let Kt=$t.prox,un=Oo==null?br<=Kt:br>Kt||to!=Oo;if(vt||un){let Tn=ve[0];Tn!=null&&(an[0]=Ht,yi[0]=Wt,gM(Tn,ge,ze,Fe),pM(Tn,Pe,oe),pr(Tn,bs(Ht),bs(Wt),$,Nt))}}}if(cn.show&&Kr)if(T!=null){let[_t,Et]=On.scales,[zt,Ht]=On.match,[Wt,ge]=T.cursor.sync.scales,ze=T.cursor.drag;if(Jn=ze._x,Kn=ze._y,Jn||Kn){let{left:Fe,top:Pe,width:oe,height:Kt}=T.select,un=T.scales[Wt].ori,Tn=T.posToVal,ti,Ke,An,Yi,bi,us=_t!=null&&zt(_t,Wt),Es=Et!=null&&Ht(Et,ge);us&&Jn?(un==0?(ti=Fe,Ke=oe):(ti=Pe,Ke=Kt),An=v[_t],Yi=G(Tn(ti,Wt),An,et,0),bi=G(Tn(ti+Ke,Wt),An,et,0),oc(Vs(Yi,bi),jn(bi-Yi))):oc(0,et),Es&&Kn?(un==1?(ti=Fe,Ke=oe):(ti=Pe,Ke=Kt),An=v[Et],Yi=F(Tn(ti,ge),An,ht,0),bi=F(Tn(ti+Ke,ge),An,ht,0),ac(Vs(Yi,bi),jn(bi-Yi))):ac(0,ht)}else hm()}else{let _t=jn(__-g_),Et=jn(y_-x_);if(L.ori==1){let ge=_t;_t=Et,Et=ge}Jn=si.x&&_t>=si.dist,Kn=si.y&&Et>=si.dist;let zt=si.uni;zt!=null?Jn&&Kn&&(Jn=_t>=zt,Kn=Et>=zt,!Jn&&!Kn&&(Et>_t?Kn=!0:Jn=!0)):si.x&&si.y&&(Jn||Kn)&&(Jn=Kn=!0);let Ht,Wt;Jn&&(L.ori==0?(Ht=Ta,Wt=ln):(Ht=Aa,Wt=_n),oc(Vs(Ht,Wt),jn(Wt-Ht)),Kn||ac(0,ht)),Kn&&(L.ori==1?(Ht=Ta,Wt=ln):(Ht=Aa,Wt=_n),ac(Vs(Ht,Wt),jn(Wt-Ht)),Jn||oc(0,et)),!Jn&&!Kn&&(oc(0,0),ac(0,0))}if(si._x=Jn,si._y=Kn,T==null){if(k){if(L_!=null){let[_t,Et]=On.scales;On.values[0]=_t!=null?js(L.ori==0?ln:_n,_t):null,On.values[1]=Et!=null?js(L.ori==1?ln:_n,Et):null}cc(Y0,i,ln,_n,$,Nt,H)}if(le){let _t=k&&On.setSeries,Et=$t.prox;Oo==null?br<=Et&&Ys(to,Ca,!0,_t):br>Et?Ys(null,Ca,!0,_t):to!=Oo&&Ys(to,Ca,!0,_t)}}vt&&(dt.idx=H,lm()),P!==!1&&Qn("setCursor")}let eo=null;Object.defineProperty(i,"rect",{get(){return eo==null&&lc(!1),eo}});function lc(T=!1){T?eo=null:(eo=p.getBoundingClientRect(),Qn("syncRect",eo))}function w_(T,P,k,H,Y,et,ht){ft._lock||Kr&&T!=null&&T.movementX==0&&T.movementY==0||(cm(T,P,k,H,Y,et,ht,!1,T!=null),T!=null?Fo(null,!0,!0):Fo(P,!0,!1))}function cm(T,P,k,H,Y,et,ht,_t,Et){if(eo==null&&lc(!1),ae(T),T!=null)k=T.clientX-eo.left,H=T.clientY-eo.top;else{if(k<0||H<0){ln=-10,_n=-10;return}let[zt,Ht]=On.scales,Wt=P.cursor.sync,[ge,ze]=Wt.values,[Fe,Pe]=Wt.scales,[oe,Kt]=On.match,un=P.axes[0].side%2==1,Tn=L.ori==0?$:Nt,ti=L.ori==1?$:Nt,Ke=un?et:Y,An=un?Y:et,Yi=un?H:k,bi=un?k:H;if(Fe!=null?k=oe(zt,Fe)?a(ge,v[zt],Tn,0):-10:k=Tn*(Yi/Ke),Pe!=null?H=Kt(Ht,Pe)?a(ze,v[Ht],ti,0):-10:H=ti*(bi/An),L.ori==1){let us=k;k=H,H=us}}Et&&(P==null||P.cursor.event.type==Y0)&&((k<=1||k>=$-1)&&(k=la(k,$)),(H<=1||H>=Nt-1)&&(H=la(H,Nt))),_t?(g_=k,x_=H,[Ta,Aa]=ft.move(i,k,H)):(ln=k,_n=H)}let um={width:0,height:0,left:0,top:0};function hm(){Ku(um,!1)}let M_,S_,E_,T_;function A_(T,P,k,H,Y,et,ht){Kr=!0,Jn=Kn=si._x=si._y=!1,cm(T,P,k,H,Y,et,ht,!0,!1),T!=null&&(Ue(j0,tx,R_,!1),cc(aM,i,Ta,Aa,$,Nt,null));let{left:_t,top:Et,width:zt,height:Ht}=cn;M_=_t,S_=Et,E_=zt,T_=Ht}function R_(T,P,k,H,Y,et,ht){Kr=si._x=si._y=!1,cm(T,P,k,H,Y,et,ht,!1,!0);let{left:_t,top:Et,width:zt,height:Ht}=cn,Wt=zt>0||Ht>0,ge=M_!=_t||S_!=Et||E_!=zt||T_!=Ht;if(Wt&&ge&&Ku(cn),si.setScale&&Wt&&ge){let ze=_t,Fe=zt,Pe=Et,oe=Ht;if(L.ori==1&&(ze=Et,Fe=Ht,Pe=_t,oe=zt),Jn&&Qr(S,js(ze,S),js(ze+Fe,S)),Kn)for(let Kt in v){let un=v[Kt];Kt!=S&&un.from==null&&un.min!=sn&&Qr(Kt,js(Pe+oe,Kt),js(Pe,Kt))}hm()}else ft.lock&&(ft._lock=!ft._lock,Fo(P,!0,T!=null));T!=null&&(kn(j0,tx),cc(j0,i,ln,_n,$,Nt,null))}function YE(T,P,k,H,Y,et,ht){if(ft._lock)return;ae(T);let _t=Kr;if(Kr){let Et=!0,zt=!0,Ht=10,Wt,ge;L.ori==0?(Wt=Jn,ge=Kn):(Wt=Kn,ge=Jn),Wt&&ge&&(Et=ln<=Ht||ln>=$-Ht,zt=_n<=Ht||_n>=Nt-Ht),Wt&&Et&&(ln=ln<Ta?0:$),ge&&zt&&(_n=_n<Aa?0:Nt),Fo(null,!0,!0),Kr=!1}ln=-10,_n=-10,nt.fill(null),Fo(null,!0,!0),_t&&(Kr=_t)}function C_(T,P,k,H,Y,et,ht){ft._lock||(ae(T),rc(),hm(),T!=null&&cc(uM,i,ln,_n,$,Nt,null))}function P_(){w.forEach(ND),W(i.width,i.height,!0)}ha(cp,Ll,P_);let Pa={};Pa.mousedown=A_,Pa.mousemove=w_,Pa.mouseup=R_,Pa.dblclick=C_,Pa.setSeries=(T,P,k,H)=>{let Y=On.match[2];k=Y(i,P,k),k!=-1&&Ys(k,H,!0,!1)},yt&&(Ue(aM,p,A_),Ue(Y0,p,w_),Ue(lM,p,T=>{ae(T),lc(!1)}),Ue(cM,p,YE),Ue(uM,p,C_),lx.add(i),i.syncRect=lc);let Qu=i.hooks=n.hooks||{};function Qn(T,P,k){vi?je.push([T,P,k]):T in Qu&&Qu[T].forEach(H=>{H.call(null,i,P,k)})}(n.plugins||[]).forEach(T=>{for(let P in T.hooks)Qu[P]=(Qu[P]||[]).concat(T.hooks[P])});let I_=(T,P,k)=>k,On=Bn({key:null,setSeries:!1,filters:{pub:bM,sub:bM},scales:[S,x[1]?x[1].scale:null],match:[wM,wM,I_],values:[null,null]},ft.sync);On.match.length==2&&On.match.push(I_),ft.sync=On;let L_=On.key,dm=_S(L_);function cc(T,P,k,H,Y,et,ht){On.filters.pub(T,P,k,H,Y,et,ht)&&dm.pub(T,P,k,H,Y,et,ht)}dm.sub(i);function jE(T,P,k,H,Y,et,ht){On.filters.sub(T,P,k,H,Y,et,ht)&&Pa[T](null,P,k,H,Y,et,ht)}i.pub=jE;function ZE(){dm.unsub(i),lx.delete(i),Zn.clear(),ix(cp,Ll,P_),c.remove(),Tt?.remove(),Qn("destroy")}i.destroy=ZE;function fm(){Qn("init",n,t),sc(t||n.data,!1),U[S]?rm(S,U[S]):rc(),at=cn.show&&(cn.width>0||cn.height>0),rt=vt=!0,W(n.width,n.height)}return x.forEach(va),w.forEach(xr),e?e instanceof HTMLElement?(e.appendChild(c),fm()):e(i,fm):fm(),i}ai.assign=Bn;ai.fmtNum=mx;ai.rangeNum=up;ai.rangeLog=fp;ai.rangeAsinh=fx;ai.orient=fa;ai.pxRatio=We;ai.join=EL;ai.fmtDate=xx,ai.tzDate=OL;ai.sync=_S;{ai.addGap=_D,ai.clipGaps=gp;let n=ai.paths={points:SS};n.linear=TS,n.stepped=bD,n.bars=wD,n.spline=SD}var vp=()=>parseFloat(getComputedStyle(document.documentElement).fontSize),Sx=n=>Ft.curves[n%Ft.curves.length],UD=.06;function OD(n,t,e){let i=[n,t,...e.map(a=>a.value)],s=Math.min(...i),r=Math.max(...i),o=UD*(r-s);return r-s>1e-9?[s-o,r+o]:[s-1,r+1]}function FD(n,t,e,i){let{ctx:s}=n,r=devicePixelRatio;s.save(),s.beginPath(),s.rect(n.bbox.left,n.bbox.top,n.bbox.width,n.bbox.height),s.clip();for(let{value:o,of:a}of i){let l=n.valToPos(o,"y",!0);s.strokeStyle=a===null?Ft.ink:Sx(a),s.lineWidth=1.25*r,s.setLineDash([5*r,4*r]),s.beginPath(),s.moveTo(n.bbox.left,l),s.lineTo(n.bbox.left+n.bbox.width,l),s.stroke()}s.setLineDash([]),s.lineCap="round",s.lineWidth=4.5*r,e.forEach((o,a)=>{s.strokeStyle=Sx(a);for(let{start:l,end:c}of o.binds){let u=t.xs.map((h,d)=>[h,o.values[d]]).filter(([h])=>h>=l-1e-9&&h<=c+1e-9);s.beginPath();for(let[h,d]of u)s.lineTo(n.valToPos(h,"x",!0),n.valToPos(d,"y",!0));s.stroke()}}),s.restore()}function PS(n,t,{y:e,list:i},{withLimits:s,pick:r}){let o={stroke:Ft.line,width:1},a=`${Math.round(.78*vp())}px "Inter Variable", system-ui, sans-serif`,l=Iu(i),c={stroke:Ft.muted,grid:o,ticks:{...o,size:4},font:a,labelFont:a,labelSize:1.4*vp(),gap:4},u=new ai({width:n.clientWidth||600,height:n.clientHeight||180,pxAlign:0,legend:{show:!1},cursor:{drag:{x:!1,y:!1},points:{show:!1},y:!1},scales:{x:{time:!1,range:(f,p,y)=>[p,Math.max(y,t.xEnd??y,p+1e-6)]},y:{range:(f,p,y)=>OD(p,y,s?l:[])}},series:[{},...i.map((f,p)=>({label:f.name,stroke:Sx(p),width:1.75,pxAlign:0,points:{show:t.q.length<3}}))],axes:[{...c,label:t.xName==="point"?"point number":"time, s",size:2.1*vp()},{...c,label:e,size:4*vp()}],hooks:{draw:[f=>FD(f,t,i,l)],setSize:[()=>d()]}},[t.xs,...i.map(f=>f.values)],n);u.over.append(E("div",{class:"now"}),...t.events.map(f=>{let p=E("div",{class:`event ${f.stop?"stop":""}`,title:f.text},E("span",{text:f.short}));return p.x=f.x,p})),u.over.addEventListener("pointerdown",f=>{let p=g=>{let m=u.posToVal(g.clientX-u.over.getBoundingClientRect().left,"x");r(t.xs.reduce((x,w,v)=>Math.abs(w-m)<Math.abs(t.xs[x]-m)?v:x,0))};p(f);let y=()=>{removeEventListener("pointermove",p),removeEventListener("pointerup",y),removeEventListener("pointercancel",y)};addEventListener("pointermove",p),addEventListener("pointerup",y),addEventListener("pointercancel",y)});let h=0;function d(f=h){h=f;let p=u.over.clientWidth,y=[];for(let g of u.over.querySelectorAll(".now, .event")){let m=u.valToPos(g.x??t.xs[h],"x"),x=m>p*.7;g.style.setProperty("left",`${m}px`),g.classList.toggle("leftward",x);let w=g.firstElementChild;if(!w)continue;let[v,A]=x?[m-w.offsetWidth,m]:[m,m+w.offsetWidth],S=0;for(;y.some(_=>_.line===S&&v<_.to&&_.from<A);)S+=1;y.push({line:S,from:v,to:A}),w.style.setProperty("top",`${S*w.offsetHeight}px`)}}return{point:d,canvas:u.ctx.canvas,resize:()=>n.clientWidth&&u.setSize({width:n.clientWidth,height:n.clientHeight}),destroy:()=>u.destroy()}}var BD=1500,IS=400,kD={gif:"image/gif",webp:"image/webp",mp4:"video/mp4"};async function LS(n,t,e,i){let s=Math.max(1,Math.ceil(n.q.length/BD)),r=n.q.map((v,A)=>A).filter(v=>v%s===0||v===n.q.length-1),[o,a,l,c,u,h]=_l(),[d,f,p]=[o-c,a-u,l-h],y=[Math.atan2(p,Math.hypot(d,f)),Math.atan2(f,d)].map(v=>v*180/Math.PI),g=v=>Number(v.toPrecision(8)),m={kind:t,speed:e,view:y,q:r.map(v=>n.q[v].map(g)),t:r.map(v=>g(n.seconds[v]))},x=await Oe("film",m,({done:v,of:A})=>i(v,A));if(x.stopped)return null;let w=Uint8Array.from(atob(x.data),v=>v.charCodeAt(0));return{name:x.name,blob:new Blob([w],{type:kD[t]})}}async function DS(n,t){if(!window.MediaRecorder||!n.captureStream)throw new Error("This browser records no video.");let e=new MediaRecorder(n.captureStream(30),{mimeType:"video/webm",videoBitsPerSecond:8e6}),i=[];e.ondataavailable=({data:c})=>c.size&&i.push(c);let s=new Promise(c=>{e.onstop=c}),r=c=>new Promise(u=>setTimeout(u,c)),o=()=>i.reduce((c,u)=>c+u.size,0),a=async c=>{for(let u=0;u<100&&o()<=c;u++)ue(),await r(100)};e.start(100),await a(IS);let l=o();if(await t(),await r(400),await a(l),e.stop(),await s,o()<=IS)throw new Error("The browser recorded no pictures. GIF and MP4 are drawn without it.");return new Blob(i,{type:"video/webm"})}var Qe=null,$r=null,mr="joints",_i=0,Ex=1,li=null,Mp=new Set(["speeds","accelerations","toolspeed"]);function US(n){let t=Ut("Play",{class:"primary","data-testid":"play"},FS),e=E("input",{type:"range",min:"0",max:"1",step:"1",value:"0","aria-label":"Point of the motion","data-testid":"scrub",on:{input:()=>{xi(),Xr(Number(e.value))}}}),i=E("output",{class:"where","data-testid":"where"}),s=E("div",{class:"marks"}),r=E("div",{class:"chart","data-testid":"chart"}),o=E("div",{class:"legend"}),a=E("output",{class:"binds","data-testid":"binds"}),l=Ut("To the limits",{class:"quiet",title:"Scale the curves so that their limits, dashed, are seen; thick is where one binds","data-testid":"limits-shown"},()=>{Mp.delete(mr)||Mp.add(mr),wp()});n.append(E("div",{class:"dock-bar"},t,hn("Speed",[["0.25","\xBC\xD7"],["0.5","\xBD\xD7"],["1","1\xD7"],["2","2\xD7"],["4","4\xD7"],["10","10\xD7"]],"1",c=>{Ex=Number(c)},{"data-testid":"speed"}),E("div",{class:"scrubber"},e,s),i,Ut("\xD7",{class:"icon","aria-label":"Close the curves"},()=>ci(null))),E("div",{class:"dock-bar second"},Be("Curves",tM,mr,c=>{mr=c,wp()},"curves"),l,o,a,E("span",{class:"line saves"},...[["CSV",()=>hi("motion.csv",nM(Qe),"text/csv")],["PNG",HD],["Film",zD],["GIF",()=>NS("gif")],["MP4",()=>NS("mp4")],["SVG",()=>hi(`${mr}.svg`,iM(Qe,mr,Ft.curves),"image/svg+xml")]].map(([c,u])=>Ut(c,{class:"quiet","aria-label":`Save as ${c}`},()=>Qe&&u())))),r),li={root:n,toggle:t,scrub:e,where:i,marks:s,chart:r,legend:o,limits:l,binds:a},new ResizeObserver(tr(()=>$r?.resize())).observe(r),K(["units","theme"],wp),K("moving",c=>bt(t,c&&bp?"Pause":"Play")),K("table",c=>{Qe&&!["postures","name","gripper"].includes(c)&&ci(null)})}function ci(n){if(xi(),Qe=n,b.motion=n,li.root.hidden=!n,$r&&($r.destroy(),$r=null),uw(n?.table??null,n?.q??[]),!n){lt("motion");return}li.scrub.max=String(Math.max(n.q.length-1,0));let t=n.xs[n.xs.length-1]-n.xs[0]||1;Gt(li.marks,n.events.map(e=>{let i=E("span",{class:"event-mark",title:e.text});return i.style.setProperty("left",`${Math.min(100*(e.x-n.xs[0])/t,100)}%`),i}),(n.tight??[]).map(e=>{let i=E("span",{class:"tight-mark",title:e.text});return i.style.setProperty("left",`${100*(e.start-n.xs[0])/t}%`),i.style.setProperty("width",`${100*(e.end-e.start)/t}%`),i})),wp(),lt("motion"),n.q.length&&Xr(0),requestAnimationFrame(()=>xl())}var qr=n=>n&&n===Qe&&ci(null);var OS=()=>_i;function Xr(n){Qe?.q.length&&(_i=Math.min(Math.max(Math.round(n),0),Qe.q.length-1),li.scrub.value=String(_i),li.scrub.style.setProperty("--at",`${Qe.q.length>1?100*_i/(Qe.q.length-1):0}%`),bt(li.where,Qe.xName==="point"?`point ${_i+1} of ${Qe.q.length}`:`${ii(Qe.xs[_i],2)} s of ${ii(Qe.xs[Qe.xs.length-1],2)} s`),li.scrub.setAttribute("aria-valuetext",li.where.textContent),Oi(Qe.q[_i].slice(),"scrub"),lt("played",Qe.seconds[_i]),bt(li.binds,Qe.tight?`Binds: ${eM(Qe,Qe.seconds[_i])||"nothing"}`:""),$r?.point(_i))}var bp=!1;function FS(n,t){if(bp){xi();return}if(!Qe?.q.length)return;let e=Qe.seconds,i=e[e.length-1]||1,s=_i>=Qe.q.length-1?0:e[_i]/i;bp=!0,Tw(i/Ex,s,r=>{let o=_i<=Qe.q.length-1&&e[_i]<=r*i?_i:0;for(;o<e.length-1&&e[o+1]<=r*i+1e-9;)o+=1;Xr(o)},()=>{bp=!1,bt(li.toggle,"Play"),t?.()}),bt(li.toggle,"Pause")}function wp(){if(!Qe||!li)return;$r?.destroy();let n=q0(Qe,mr);Gt(li.legend,n.list.map((t,e)=>{let i=E("span",{class:"swatch"});return i.style.setProperty("background",Ft.curves[e%Ft.curves.length]),E("span",{},i,t.name)})),li.limits.hidden=!Iu(n.list).length,li.limits.setAttribute("aria-pressed",String(Mp.has(mr))),$r=PS(li.chart,Qe,n,{withLimits:Mp.has(mr),pick(t){xi(),Xr(t)}}),$r.point(_i)}async function NS(n){de(`Drawing the ${n.toUpperCase()} \u2026`);try{let t=await LS(Qe,n,Ex,(e,i)=>de(`Drawing the ${n.toUpperCase()}: ${e} of ${i} pictures`));t&&hi(t.name,t.blob)}catch(t){de(t.message,"wrong")}}async function zD(){xi(),Xr(0);try{let n=await ml(t=>DS(t,()=>new Promise(e=>FS(null,e))));hi("motion.webm",n)}catch(n){de(n.message,"wrong")}}function HD(){let n=$r.canvas,t=document.createElement("canvas"),e=t.getContext("2d");t.width=n.width,t.height=n.height,e.fillStyle=Ft.panel,e.fillRect(0,0,t.width,t.height),e.drawImage(n,0,0),t.toBlob(i=>hi(`${mr}.png`,i))}function Hl(n,t){let e=Array.from({length:16},(s,r)=>E("span",{role:"cell",class:r%4===3&&r<12?"p":r>=12?"last":""})),i=E("div",{class:"matrix",role:"table","aria-label":n,"data-testid":t},[0,4,8,12].map(s=>E("div",{role:"row",class:"matrix-row"},e.slice(s,s+4))));return i.show=s=>{for(let r=0;r<16;r++){let o=r%4===3&&r<12;bt(e[r],r>=12?String(s[r]):o?ii(s[r]*gt.factor("length"),gt.digits("length")):ii(s[r],4))}},i}var Sp=n=>[0,4,8,12].map(t=>`[${n.slice(t,t+4).map(e=>Number(e.toPrecision(12))+0).join(", ")}]`).join(`,
`);var Tx="pieper-panel-width",Ax=18,BS=70;function kS(n,t){let e=E("div",{class:"splitter",role:"separator","aria-orientation":"vertical","aria-label":"Width of the panels","aria-valuemin":String(Ax),"aria-valuemax":String(BS),tabindex:"0","data-testid":"splitter"});t.prepend(e);let i=()=>parseFloat(getComputedStyle(document.documentElement).fontSize),s=()=>document.getElementById("panels").offsetWidth/i(),r=a=>{let l=a===null?null:Math.min(Math.max(a,Ax),BS,.75*innerWidth/i());l===null?n.style.removeProperty("--panel-width"):n.style.setProperty("--panel-width",`${l}rem`),n.classList.toggle("split",l!==null),e.setAttribute("aria-valuenow",String(Math.round(l??s())));try{l===null?localStorage.removeItem(Tx):localStorage.setItem(Tx,String(l))}catch{}};e.addEventListener("pointerdown",a=>{e.setPointerCapture(a.pointerId);let l=a.clientX,c=s(),u=h=>r(c+(l-h.clientX)/i());e.addEventListener("pointermove",u),e.addEventListener("pointerup",()=>e.removeEventListener("pointermove",u),{once:!0})}),e.addEventListener("dblclick",()=>r(null)),e.addEventListener("keydown",a=>{let l={ArrowLeft:1,ArrowRight:-1}[a.key];if(l)r(s()+l*(a.shiftKey?5:1));else if(a.key==="Home")r(null);else return;a.preventDefault()});let o=Number(localStorage.getItem(Tx));o>=Ax?r(o):e.setAttribute("aria-valuenow","38")}function zS(n){let t=Hl("Pose of the tool, large","present-pose"),e=E("div",{class:"present-card",hidden:!0},t);n.parentElement.append(e);let i=document.documentElement,s=Ut("Present",{"aria-pressed":"false","data-testid":"present"},()=>o(i.dataset.present!=="yes")),r=()=>!e.hidden&&t.show(b.frames.at(-1));function o(a){a?i.dataset.present="yes":delete i.dataset.present,e.hidden=!a,s.setAttribute("aria-pressed",String(a)),r(),lt("units"),dispatchEvent(new Event("resize"))}return K(["q","units"],r),addEventListener("keydown",a=>a.key==="Escape"&&i.dataset.present&&!a.target.matches?.("input")&&o(!1)),s}function HS(){ml(n=>{let t=document.createElement("canvas"),e=t.getContext("2d");t.width=n.width,t.height=n.height,e.drawImage(n,0,0),Pb(e,n.width/n.clientWidth),t.toBlob(i=>i?hi(`${b.table.name||"arm"}.png`,i):de("The picture could not be read.","wrong"))})}var GD="http://www.w3.org/2000/svg";function VD(n){let t=n.map(([l,c,u])=>[.77*l+.62*c,.3*l-.38*c-.88*u]);t.unshift([t[0][0],t[0][1]]);let[e,i]=[0,1].map(l=>t.map(c=>c[l])),s=Math.max(Math.max(...e)-Math.min(...e),Math.max(...i)-Math.min(...i))||1,r=([l,c])=>[22+36*(l-(Math.max(...e)+Math.min(...e))/2)/s,22+36*(c-(Math.max(...i)+Math.min(...i))/2)/s],o=(l,c)=>{let u=document.createElementNS(GD,l);for(let[h,d]of Object.entries(c))u.setAttribute(h,d);return u},a=o("svg",{viewBox:"0 0 44 44",class:"thumb","aria-hidden":"true"});a.append(o("polyline",{points:t.map(l=>r(l).map(c=>c.toFixed(1)).join(",")).join(" ")}));for(let l of t.slice(1))a.append(o("circle",{cx:r(l)[0].toFixed(1),cy:r(l)[1].toFixed(1),r:1.7}));return a}var GS=n=>/^(.)\1*$/.test(n)?`${n.length}${n[0]}`:n;function WD(n){let t=/^>?(\d+(?:[.,]\d+)?)(kg|mm|m)$/.exec(n);if(!t)return null;let e=Number(t[1].replace(",","."));return t[2]==="kg"?{payload:e}:{reach:t[2]==="m"?e:e/1e3}}function $D(n,t){let e=`${n.name} ${n.maker} ${n.joints} ${GS(n.joints)}`.toLowerCase();return t.every(i=>{let s=/^(\d+)joints$/.exec(i);if(s)return n.joints.length===Number(s[1]);let r=WD(i);return r?Object.entries(r).every(([o,a])=>n[o]!==null&&n[o]>=a-1e-9):e.includes(i)})}var qD=({maker:n,joints:t,payload:e,reach:i})=>[n,GS(t),e===null?"":`${e} kg`,i===null?"":`${Math.round(i*1e3)} mm`].filter(Boolean);function VS(n){let t=null,e=E("div",{class:"arms",role:"listbox","aria-label":"Arms found","data-testid":"arms-found"}),i=E("span",{class:"hint",role:"status"}),s=E("input",{type:"text",placeholder:"Name, maker, joints (7R, 5 axes), payload (5 kg), reach (900 mm)","aria-label":"Search the catalogue","data-testid":"search-arms",autocomplete:"off",on:{input:()=>o(),keydown:a=>{if(a.key==="ArrowDown")e.firstElementChild?.focus();else if(a.key==="Enter")e.firstElementChild?.click();else return;a.preventDefault()}}}),r=E("dialog",{class:"catalogue","aria-label":"Catalogue"},E("div",{class:"line"},s,i,Ut("\xD7",{class:"icon","aria-label":"Close the catalogue"},()=>r.close())),e);document.body.append(r);function o(){let l=s.value.toLowerCase().replace(/(\d)\s+(kg|mm|m)\b/g,"$1$2").replace(/(\d)[\s-]*(joints?|ax[ei]s|axe|dof)\b/g,"$1joints").split(/\s+/).filter(Boolean),c=(t??[]).filter(u=>$D(u,l));i.textContent=t?`${c.length} of ${t.length} arms`:"Fetching the list \u2026",Gt(e,c.map(u=>E("button",{type:"button",role:"option",class:"arm-card","data-name":u.name,on:{click:()=>{r.close(),n(u.name)},keydown:h=>{let d={ArrowDown:"nextElementSibling",ArrowUp:"previousElementSibling"}[h.key];d&&(h.preventDefault(),(h.currentTarget[d]??s).focus())}}},VD(u.points),E("span",{},E("b",{text:u.name}),E("span",{class:"hint",text:qD(u).join(", ")})))))}return async()=>{if(r.showModal(),s.select(),!t){o();try{t=(await Fi("catalog")).arms,o()}catch(a){i.textContent=a.message}}}}var ku=n=>(n?.textContent.trim()??"").split(/\s+/).filter(Boolean).map(Number),Ro=(n,t)=>[...n.children].filter(e=>e.localName===t),XD=()=>[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1];function YD(n,t){let e=new Array(16).fill(0);for(let i=0;i<4;i++)for(let s=0;s<4;s++)for(let r=0;r<4;r++)e[4*i+s]+=n[4*i+r]*t[4*r+s];return e}function jD([n,t,e,i]){let s=Math.hypot(n,t,e)||1,r=i*Math.PI/180,o=Math.cos(r),a=Math.sin(r),l=1-o;return[n,t,e]=[n/s,t/s,e/s],[l*n*n+o,l*n*t-a*e,l*n*e+a*t,0,l*n*t+a*e,l*t*t+o,l*t*e-a*n,0,l*n*e-a*t,l*t*e+a*n,l*e*e+o,0,0,0,0,1]}var WS={matrix:n=>n,translate:([n,t,e])=>[1,0,0,n,0,1,0,t,0,0,1,e,0,0,0,1],scale:([n,t,e])=>[n,0,0,0,0,t,0,0,0,0,e,0,0,0,0,1],rotate:jD},ZD={X_UP:[0,-1,0,0,1,0,0,0,0,0,1,0,0,0,0,1],Y_UP:[1,0,0,0,0,0,-1,0,0,1,0,0,0,0,0,1]};function $S(n){let t=new DOMParser().parseFromString(n,"application/xml");if(t.querySelector("parsererror")||t.documentElement.localName!=="COLLADA")throw new Error("this is no DAE");let e=f=>[...t.getElementsByTagName("*")].filter(p=>p.localName===f),i=new Map([...t.getElementsByTagName("*")].filter(f=>f.id||f.getAttribute("id")).map(f=>[f.getAttribute("id"),f])),s=f=>i.get((f??"").replace(/^#/,"")),r=Number(e("unit")[0]?.getAttribute("meter")??1)||1,o=ZD[e("up_axis")[0]?.textContent.trim()]??XD(),a=[];function l(f){let p=s(Ro(s(f)??t.documentElement,"instance_effect")[0]?.getAttribute("url")),y=p&&[...p.getElementsByTagName("*")].find(m=>m.localName==="diffuse"),g=y?ku(Ro(y,"color")[0]):[];return g.length>=3?[g[0],g[1],g[2],g[3]??1]:null}function c(f){let p=Ro(f,"input").find(g=>g.getAttribute("semantic")==="POSITION"),y=s(p?.getAttribute("source"));return y?ku(Ro(y,"float_array")[0]):[]}function u(f,p,y){let g=f&&Ro(f,"mesh")[0];if(g)for(let m of g.children){if(!["triangles","polylist","polygons"].includes(m.localName))continue;let x=Ro(m,"input"),w=1+Math.max(...x.map(G=>Number(G.getAttribute("offset")??0))),v=x.find(G=>G.getAttribute("semantic")==="VERTEX");if(!v)continue;let A=Number(v.getAttribute("offset")??0),S=c(s(v.getAttribute("source"))),_=Ro(m,"p").map(ku),M=m.localName==="polylist"?ku(Ro(m,"vcount")[0]):m.localName==="polygons"?_.map(G=>G.length/w):new Array(_.reduce((G,F)=>G+F.length,0)/w/3).fill(3),N=_.flat(),R=[],L=0,z=G=>{let F=3*N[(L+G)*w+A],[U,D,O]=[S[F],S[F+1],S[F+2]];for(let Z=0;Z<3;Z++)R.push(r*(p[4*Z]*U+p[4*Z+1]*D+p[4*Z+2]*O+p[4*Z+3]))};for(let G of M){for(let F=2;F<G;F++)for(let U of[0,F-1,F])z(U);L+=G}R.length&&R.every(Number.isFinite)&&a.push({at:Float32Array.from(R),colour:l(y.get(m.getAttribute("material")))})}}function h(f,p,y){if(!(y>60)){for(let g of f.children)WS[g.localName]&&(p=YD(p,WS[g.localName](ku(g))));for(let g of f.children)if(g.localName==="instance_geometry"){let m=new Map([...g.getElementsByTagName("*")].filter(x=>x.localName==="instance_material").map(x=>[x.getAttribute("symbol"),x.getAttribute("target")]));u(s(g.getAttribute("url")),p,m)}else if(g.localName==="node")h(g,p,y+1);else if(g.localName==="instance_node"){let m=s(g.getAttribute("url"));m&&h(m,p,y+1)}}}let d=s(e("instance_visual_scene")[0]?.getAttribute("url"))??e("visual_scene")[0];if(d&&h(d,o,0),!a.length)throw new Error("there is no triangle in this DAE");return a}var Ep=[],zu=new Map,Tp=0;function JD(){if(Ep.length<2){let n=new Worker("meshes.js",{type:"module"});return n.onmessage=({data:{id:t,mesh:e,error:i}})=>{let{resolve:s,reject:r}=zu.get(t);zu.delete(t),i?r(new Error(i)):s(e)},n.onerror=()=>{for(let{reject:t}of zu.values())t(new Error("meshes cannot be read in this browser"));zu.clear()},Ep.push(n),n}return Ep[Tp%Ep.length]}function qS(n,t){return new Promise((e,i)=>{Tp+=1,zu.set(Tp,{resolve:e,reject:i}),JD().postMessage({id:Tp,...n},t)})}async function XS(n,t){let e=t.split(".").at(-1).toLowerCase(),i;if(n.file)i=await n.file.arrayBuffer();else{let s=await fetch(n.url);if(!s.ok)throw new Error(`${t} cannot be fetched`);i=await s.arrayBuffer()}if(e==="dae"){let s=$S(new TextDecoder().decode(i));return Promise.all(s.map(async({at:r,colour:o})=>({mesh:await qS({at:r},[r.buffer]),colour:o})))}return[{mesh:await qS({bytes:i,kind:e},[i]),colour:null}]}var YS={light:"#c9ced6",dark:"#8b96a6"},Vl=new Rn,ws=[],Hu=0,JS=!1,KS=n=>JSON.stringify([n.convention,n.coupling??null,n.joints.map(t=>[t.type,t.a,t.alpha,t.d,t.theta,t.sign,t.offset])]);function Wl(n,t,e=null){b.looks=n?.shapes.length?{...n,key:KS(t),files:e}:null,n?.notes.length&&de(`Of its looks: ${n.notes.join(" ")}`,n.shapes.length?"plain":"wrong"),KD()}var Ix=()=>!!(b.looks&&b.looks.key===KS(b.table)),Rp=()=>Ix()?b.look.mode:"sketch",Ap=null;function KD(){if(Ap===b.looks)return;Ap=b.looks;for(let t of ws)for(let e of new Set([t.fine,t.some,t.few]))e.dispose();ws=[],Vl.clear();let n=Ap;for(let t of n?.shapes??[]){if(t.kind!=="mesh"){ZS(t,[tN[t.kind](t.size)],t.colour);continue}let e=t.url?{url:t.url}:{file:n.files?.(t.file)};!e.url&&!e.file||(Hu+=1,XS(e,t.url??t.file).then(i=>{if(Ap===n)for(let{mesh:s,colour:r}of i){let o=Rx(s),a=s.some===s?o:Rx(s.some);ZS(t,[o,a,s.few===s.some?a:Rx(s.few)],t.colour??r,t.size,s.closed)}}).catch(i=>de(`${t.name}: ${i.message}`,"wrong")).finally(()=>{Hu-=1,Gl(),!Hu&&(Hf(Cx),lt("looks","loaded"))}))}lt("looks"),Gl(),Hf(Cx)}function Cx(n){return Rp()==="sketch"?[]:ws.filter(t=>n[t.on]).flatMap(t=>(Px.set(...n[t.on]),t.corners.map(e=>QD.copy(e).applyMatrix4(Px).toArray())))}var QD=new V,jS=n=>n.rotateX(Math.PI/2),tN={box:n=>new Hi(...n),cylinder:([n,t])=>jS(new Ci(n,n,t,36)),capsule:([n,t])=>jS(new Xo(n,t,8,24)),sphere:([n])=>new Ns(n,28,16)};function Rx(n){let t=new we;return t.setAttribute("position",new He(n.at,3)),t.setAttribute("normal",n.normal.length===n.at.length?new He(n.normal,3):eN(n.normal)),t.setIndex(new He(n.index,1)),t}function eN(n){return new sl(new il(n,4),3,0,!0)}function ZS(n,[t,e=t,i=e],s,r=null,o=!0){let a=Mb(o),l=new Ge(t,a),c=new Ge(i,kf),u=new ye().set(...n.T);r&&u.scale(new V(...r));for(let p of[l,c])p.matrixAutoUpdate=!1,p.frustumCulled=!1;c.renderOrder=-1,Vl.add(l,c),i.computeBoundingBox();let{min:h,max:d}=i.boundingBox,f=[h.x,d.x].flatMap(p=>[h.y,d.y].flatMap(y=>[h.z,d.z].map(g=>new V(p,y,g).applyMatrix4(u))));ws.push({on:n.on,T:u,fine:t,some:e,few:i,mesh:l,shadow:c,colour:s,corners:f}),Gu()}var Px=new ye;function Gl(){QS(),ue()}function QS(){let n=Rp();if(Vl.visible=n!=="sketch"&&ws.length>0,rw(n!=="real"||Hu>0,n!=="sketch"&&ws.length>0),!!Vl.visible)for(let t of ws){let e=b.frames[t.on];e&&(t.mesh.geometry=JS?t.few:db()?t.some:t.fine,t.mesh.matrix.copy(Px.set(...e)).multiply(t.T),t.shadow.matrix.copy(E0).multiply(t.mesh.matrix),t.mesh.matrixWorldNeedsUpdate=t.shadow.matrixWorldNeedsUpdate=!0)}}function Gu(){let n=Rp()==="both"?b.look.opacity:1;for(let{mesh:t,colour:e}of ws){let[i,s,r,o]=e??[];e?t.material.colour.setRGB(i,s,r,Ti):t.material.colour.set(Ft.dark?YS.dark:YS.light),t.material.see((o??1)*n,Ft.dark)}ue()}function Lx(n){b.look={...b.look,...n},Gu(),Gl(),Hf(Cx),lt("look")}function t1(){en.add(Vl),K("table",()=>{Gl(),Gu(),lt("looks")}),K("q",Gl),K("theme",Gu),K("look",n=>{n==="loaded"&&(Gu(),Gl())}),K("hurry",n=>{JS=n,QS()})}var e1=()=>({mode:Rp(),visible:Vl.visible,loading:Hu,shapes:ws.length,triangles:ws.reduce((n,t)=>n+(t.fine.index?.count??0)/3,0),few:ws.reduce((n,t)=>n+(t.few.index?.count??0)/3,0),places:ws.map(n=>n.mesh.matrix.clone().transpose().toArray())});function i1(){let n=Be("The arm as",[["sketch","Sketch"],["real","Real"],["both","Both"]],b.look.mode,s=>Lx({mode:s}),"look"),t=E("input",{type:"range",min:"0.1",max:"0.9",step:"0.05",value:String(b.look.opacity),"aria-label":"How opaque the real arm is over the sketch","data-testid":"look-opacity",on:{input:()=>Lx({opacity:Number(t.value)})}}),e=E("div",{class:"group look",hidden:!0},n,t),i=()=>{e.hidden=!Ix(),n.mark(b.look.mode),t.hidden=b.look.mode!=="both",t.value=String(b.look.opacity)};return K(["looks","look","table"],i),i(),e}function r1(n){let t=E("select",{"aria-label":"Arm from the catalogue","data-testid":"catalog",on:{change:()=>s1(t.value)}}),e=VS(s1),i=E("p",{class:"sentence","data-testid":"sentence"}),s=E("span",{class:"online",role:"status","data-testid":"online"}),r=(u,h,d,f)=>{let p=Ut(u,{"aria-label":h},d);return p.show=y=>{p.disabled=!y,p.title=y?`${h}: ${y} (${f})`:`Nothing to ${h.toLowerCase()}`,p.setAttribute("aria-description",y??"")},p},o=r("\u21B6","Undo",U0,"Ctrl+Z"),a=r("\u21B7","Redo",O0,"Ctrl+Shift+Z");K("history",()=>{o.show(Zf()),a.show(Jf())});let l=()=>{let{name:u,derived:h,catalog:d}=b.table,f=d?[]:[E("option",{value:"",text:h?`${u} (from ${h}, edited)`:u||"my-arm"})];Gt(t,f,(b.catalog??[]).map(p=>E("option",{value:p,text:p}))),t.value=d??""},c=E("span",{class:"group",role:"group","aria-label":"History"},o,a);n.append(E("h1",{class:"mark"},E("img",{src:"icon.svg",alt:"",width:"22",height:"22"}),E("span",{text:"pieper"})),t,Ut("Find\u2026",{class:"find","aria-label":"Find an arm in the catalogue","data-testid":"find-arm"},e),c,i,E("span",{class:"bar-end"},s,Be("Angles in",[["deg","\xB0"],["rad","rad"]],gt.angle,u=>{gt.set("angle",u),lt("units")},"unit-angle"),Be("Lengths in",[["mm","mm"],["m","m"]],gt.length,u=>{gt.set("length",u),lt("units")},"unit-length"),hn("Size of the letters",[1,1.15,1.3,1.5].map(u=>[String(u),`${Math.round(100*u)} %`]),String(ou()),u=>Zv(Number(u)),{"data-testid":"text-size"}),hn("Light or dark",[["auto","Auto"],["light","Light"],["dark","Dark"]],b.theme,df,{"data-testid":"theme"}))),lt("history"),K(["catalog","table"],l),K("plan",()=>{let u=[ch(b.plan),Z_(b.plan)].filter(Boolean).join(". ").replace("..",".");bt(i,b.plan?u:"Looking how it is solved \u2026"),i.title=b.plan?.explain??""}),K("online",u=>{bt(s,u?"":"Server away; reconnecting"),s.classList.toggle("away",!u)}),K(["units","theme"],()=>{n.querySelector("[data-testid=unit-angle]").mark(gt.angle),n.querySelector("[data-testid=unit-length]").mark(gt.length),n.querySelector("[data-testid=theme]").value=b.theme})}async function s1(n){if(n)try{let{table:t}=await Fi("load",{name:n});yn(t,{q:La(t),what:"new",label:`open ${n}`})}catch(t){lt("catalog"),de(t.message,"wrong")}}function o1(n,t,e,i){let s=E("div",{role:"tablist","aria-orientation":"vertical",class:"tabs"}),r=()=>F0()==="pinned";n.append(s);let o=new Map,a=i.map(c=>{let u=E("div",{role:"tabpanel",class:"panel",id:`panel-${c.id}`,"aria-labelledby":`tab-${c.id}`,"data-testid":`panel-${c.id}`,hidden:!0});for(let d of c.sections??[c]){let f=E("section",{class:"section"},E("h2",{text:d.title}));u.append(f),d.build(f,u)}let h=Ut(c.title,{role:"tab",id:`tab-${c.id}`,"aria-controls":u.id},()=>l(c.id));return c.group&&s.append(E("span",{class:"tab-group","aria-hidden":"true",text:c.group})),s.append(h),{...c,panel:u,tab:h}});function l(c){r()&&c==="move"&&(c="inverse"),o.set(b.panel,t.scrollTop),b.panel=c;for(let u of a){let h=r()&&u.id==="move",d=u.id===c||h;(h?e:t).append(u.panel),u.panel.hidden=!d,u.tab.hidden=h,u.tab.setAttribute("aria-selected",String(u.id===c)),u.tab.tabIndex=u.id===c?0:-1,u.id===c&&(document.getElementById("room").dataset.panel=c,document.getElementById("room").classList.toggle("wide",!!u.wide))}lt("panel",c),t.scrollTop=o.get(c)??0}return s.addEventListener("keydown",c=>{let u={ArrowDown:1,ArrowUp:-1,ArrowRight:1,ArrowLeft:-1}[c.key];if(!u)return;c.preventDefault();let h=a.filter(p=>!p.tab.hidden),d=h.findIndex(p=>p.id===b.panel),f=h[(d+u+h.length)%h.length];l(f.id),f.tab.focus()}),K("layout",()=>l(b.panel==="move"||!a.some(c=>c.id===b.panel)?"move":b.panel)),l(b.panel),l}function a1(n){let t=E("div",{class:"group",role:"group","aria-label":"Views"},[["iso","Iso"],["front","Front"],["side","Side"],["top","Top"]].map(([c,u])=>Ut(u,{},()=>qg(c))),Ut("Fit",{},()=>bu())),e=E("div",{class:"group frames",role:"group","aria-label":"Frames shown","data-testid":"frames"}),i=Ut("Trace",{"aria-pressed":"true"},()=>{let c=i.getAttribute("aria-pressed")!=="true";i.setAttribute("aria-pressed",String(c)),yw(c)}),s=Ut("Clear",{"aria-label":"Clear the trace"},Wf),r=E("span",{class:"scale"}),o=E("div",{class:"key","aria-label":"Axes: x red, y green, z blue"},["x","y","z"].map((c,u)=>{let h=E("span",{class:"dot"});return h.style.setProperty("background",kr[u]),E("span",{},h,c)}),r);n.append(E("div",{class:"corner top"},t,E("div",{class:"group",role:"group","aria-label":"Trace of the tool"},i,s),i1(),E("div",{class:"group",role:"group","aria-label":"The picture"},zS(n),Ut("PNG",{"aria-label":"Save the picture","data-testid":"save-picture"},HS))),E("div",{class:"corner bottom"},o,e));let a=-2,l=()=>{let c=b.table.joints.length,u=Array.from({length:c+2},(d,f)=>f);b.shownFrames=(b.shownFrames??[0,c+1]).map(d=>d===a+1?c+1:d).filter(d=>d<c+2),a=c;let h=d=>{b.shownFrames=d,l()};Gt(e,E("span",{class:"group-name",text:"Frames"}),u.map(d=>Ut(Vf(d),{"aria-pressed":String(b.shownFrames.includes(d)),"aria-label":`Frame ${Vf(d)}`},()=>h(b.shownFrames.includes(d)?b.shownFrames.filter(f=>f!==d):[...b.shownFrames,d]))),Ut(b.shownFrames.length===c+2?"none":"all",{"aria-label":"All frames or none"},()=>h(b.shownFrames.length===c+2?[]:u))),lt("frames"),bt(r,`grid ${re(Yg.cell,"length",gt.length==="mm"?0:2)}`)};K(["table","units"],l),l()}function l1(){addEventListener("keydown",n=>{if(!(n.ctrlKey||n.metaKey)||n.altKey)return;let t=n.key.toLowerCase();n.target.matches?.("input[type=text]:not(.number), textarea")||(t==="z"&&!n.shiftKey?(n.preventDefault(),n.target.blur?.(),U0()):(t==="y"||t==="z"&&n.shiftKey)&&(n.preventDefault(),n.target.blur?.(),O0()))})}var Dx=()=>b.frames[b.frames.length-1],u1={id:"pose",title:"Pose",build(n){let t=Hl("Pose of the tool in the base frame","pose"),e=["X","Y","Z"].map(u=>c1(u,"length",`pose-${u.toLowerCase()}`)),i=E("div",{class:"quantities","data-testid":"orientation"}),s=E("p",{class:"hint order"}),r=[],o=hn("Notation of the orientation",Object.entries(Bs).map(([u,h])=>[u,h.title]),b.notation,u=>{b.notation=u,lt("notation")}),a=E("span",{class:"copies"},Ut("Copy matrix",{class:"quiet",title:"As numbers in metres, row by row"},()=>no(Sp(Dx()))),Ut("Copy numbers",{class:"quiet",title:"Position and orientation, in the units shown"},()=>no(nN())));n.append(E("div",{class:"subhead"},E("span",{text:"Tool in the base frame"}),a),t,E("div",{class:"quantities"},e.map(u=>u.el)),E("div",{class:"line"},o,s),i);let l=()=>{let u=Bs[b.notation];o.value=b.notation,bt(s,u.order),r=u.names.map((h,d)=>c1(h,u.kinds[d],`turn-${d}`)),Gt(i,r.map(h=>h.el)),c()},c=()=>{let u=Dx();t.show(u),te(u).forEach((h,d)=>e[d].show(h)),Bs[b.notation].to(u).forEach((h,d)=>r[d].show(h))};K("q",c),K("notation",l),K("units",()=>{e.forEach(u=>u.relabel()),r.forEach(u=>u.relabel()),c()}),l()}};function nN(){let n=Dx(),t=Bs[b.notation],e=te(n).map((s,r)=>`${"XYZ"[r]} ${mn(s,"length")} ${gt.symbol("length")}`),i=t.to(n).map((s,r)=>`${t.names[r]} ${t.kinds[r]==="angle"?`${mn(s,"angle")} ${gt.symbol("angle")}`:ii(s,5)}`);return`${e.join(", ")}; ${i.join(", ")} (${t.order})`.replaceAll("\u2212","-")}function c1(n,t,e){let i=E("output",{"data-testid":e}),s=E("span",{class:"unit",text:gt.symbol(t)});return{el:E("div",{class:"quantity"},E("span",{class:"quantity-name",text:n}),i,s),show:o=>bt(i,t==="plain"?ii(o,5):mn(o,t)),relabel:()=>bt(s,gt.symbol(t))}}function iN(n,t){let e=[],i=n.joints.length,s=Mr(n,t),r=o=>n.convention==="standard"?n.joints[o].alpha:n.joints[o+1]?.alpha;for(let o=0;o<i-1;o++){let a=wr(n.joints[o],s[o]).theta,l=1,c=`${o+1}`;for(let u=o;u<i-1;u++){let h=r(u);if(Math.abs(Math.sin(h))>1e-9||n.joints[u+1].type!=="R"||n.joints[o].type!=="R")break;l*=Math.sign(Math.cos(h)),a+=l*wr(n.joints[u+1],s[u+1]).theta,c+=`${l>0?"":"\u2212"}${u+2}`,e.push({name:c,value:a})}}return e}var h1={id:"matrices",title:"Matrices",wide:!0,build(n){let t="links",e="now",i=0,s=0,r=[],o=E("div",{class:"cards","data-testid":"matrices"}),a=E("table",{class:"plain","data-testid":"angles","aria-label":"Intermediate angles"}),l=hn("Posture",[["now","present posture"]],"now",p=>{e=p,d()}),c=E("span",{class:"partial"});n.append(E("div",{class:"line"},Be("Matrices shown",[["links","Each A"],["products","Products from the base"],["partial","Between two frames"]],t,p=>{t=p,h()},"matrix-mode"),c),E("div",{class:"line"},E("span",{class:"field-name",text:"Numbers of the"}),l),o,E("h3",{text:"Intermediate angles"}),E("p",{class:"hint",text:"Each \u03B8 with the maker\u2019s sign and zero put in, and the sums of neighbouring joints whose axes are parallel, as a derivation uses them."}),a);let u=()=>e!=="now"&&b.solutions?.rows[Number(e)]?.q||b.q,h=()=>{let p=b.table.joints.length;i=Math.min(i,p),s=s===0||s>p?p:s;let y=t==="links"?b.table.joints.map((m,x)=>["A",String(x+1),""]):t==="products"?b.table.joints.map((m,x)=>["T",String(x+1),"0"]):[["T",String(s),String(i)]];t==="links"&&y.push(["T","tool","base"]);let g=Array.from({length:p+1},(m,x)=>[String(x),String(x)]);Gt(c,t==="partial"?[hn("From frame",g,String(i),m=>{i=Number(m),h()})," \u2192 ",hn("To frame",g,String(s),m=>{s=Number(m),h()})]:[]),r=y.map(([m,x,w])=>({grid:Hl(`${m} ${w} ${x}`,`matrix-${m}${w}${w?"-":""}${x}`),note:E("span",{class:"hint"}),sym:m,low:x,high:w})),Gt(o,r.map(({grid:m,note:x,sym:w,low:v,high:A})=>E("figure",{class:"card"},E("figcaption",{},E("span",{class:"symbol"},A?E("sup",{text:A}):null,E("i",{text:w}),E("sub",{text:v})),x),m))),d.now()},d=tr(()=>{if(n.closest(".panel").hidden||!b.table.joints.length)return;let p=u(),y=F_(b.table,p),g=y.length;r.forEach(({grid:w,note:v},A)=>{if(t==="links"&&A<g)w.show(y[A]),bt(v,`q${A+1} = ${re(p[A],Ze(b.table.joints[A]))}`);else if(t==="links")w.show(As(b.table,p)[g+1]);else if(t==="products")w.show(y.slice(0,A+1).reduce(Hn,Ji()));else{let S=_=>y.slice(0,_).reduce(Hn,Ji());w.show(Hn(Ia(S(i)),S(s)))}});let m=Mr(b.table,p),x=b.table.joints.map((w,v)=>[w.type==="R"?`\u03B8${v+1}`:`d${v+1}`,w.type==="R"?mn(wr(w,m[v]).theta,"angle"):mn(wr(w,m[v]).d,"length"),w.type==="R"?"angle":"length"]).concat(iN(b.table,p).map(({name:w,value:v})=>[`\u03B8${w}`,mn(v,"angle"),"angle"]));Gt(a,E("tbody",{},x.map(([w,v,A])=>E("tr",{},E("th",{scope:"row"},E("i",{text:w[0]}),E("sub",{text:w.slice(1)})),E("td",{text:v}),E("td",{class:"unit",text:gt.symbol(A)})))))}),f=()=>{if(n.closest(".panel").hidden)return;let p=b.solutions?.rows??[];Gt(l,E("option",{value:"now",text:"present posture"}),p.map((y,g)=>E("option",{value:String(g),text:`solution ${g+1}: ${y.label??""}`}))),e!=="now"&&!p[Number(e)]&&(e="now"),l.value=e,d()};K("table",h),K(["q","units"],d),K("panel",d.now),K(["solutions","panel"],f),h()}};var sN=.002,rN=1e-12;function Ws(n,t,e,i,s=t){let r=[],o="",a=null,l=E("div",{class:"pose-fields"}),c=()=>r.some(f=>f.f.classList.contains("wrong")),u=()=>{let f=Bs[b.notation],p=[["X","length"],["Y","length"],["Z","length"],...f.names.map((g,m)=>[g,f.kinds[m]])],y=()=>{if(c())return;let g=Db(b.notation,r.slice(3).map(m=>m.value),r.slice(0,3).map(m=>m.value));g&&(a=g,i(g,oN(r)))};r=p.map(([g,m],x)=>{let w={value:0,kind:m},v=(A,S)=>{w.value=A,w.text=S.text,y()};return w.f=wn({label:`${n}, ${g}`,kind:m,testid:`${t}-${x}`,key:`${s}-${x}`,input:v,commit:(A,S)=>{S.text!==w.text&&v(A,S),lt("let-go")}}),w.el=E("label",{class:"pose-field"},E("span",{text:g}),w.f,E("span",{class:"unit",text:gt.symbol(m)})),w}),Gt(l,r.map(g=>g.el)),l.style.setProperty("--half",Math.ceil(r.length/2)),o=b.notation},h=()=>{if(o!==b.notation){d();return}let f=e();if(!f)return;let p=!a||f.some((y,g)=>Math.abs(y-a[g])>rN);!p&&(c()||l.contains(document.activeElement))||(a=f,[...te(f),...Bs[b.notation].to(f)].forEach((y,g)=>{r[g].value=y,r[g].text=null,r[g].f.put(y,aN(y,r[g].kind),p)}))},d=()=>$i(l,()=>{u(),h()});return K("units",d),K("notation",h),u(),h(),ip(l,"paste a pose",()=>r.map(f=>f.f)),l.addEventListener("focusout",()=>setTimeout(h)),{el:E("fieldset",{class:"pose-editor"},E("legend",{text:n}),E("div",{class:"pose-room"},l)),show:h}}function oN(n){let t=s=>s.map(r=>r.text??""),e=n.slice(3).filter(s=>s.kind==="angle"),i=e.length>1?wl(t(e),"angle"):2*wl(t(n.slice(3)),"plain");return{metres:wl(t(n.slice(0,3)),"length"),radians:i}}var aN=(n,t)=>String(Number((n*gt.factor(t)).toFixed(t==="plain"||gt[t]==="m"||gt[t]==="rad"?6:3))+0),lN=n=>`row ${Math.floor(n/4)+1}, column ${n%4+1}`,Nx=n=>n%4===3&&n<12,d1=n=>Pu(n).flat().filter(Boolean);function f1(n){let t=d1(n).slice(0,12),e=t.filter((s,r)=>Nx(r)),i=t.filter((s,r)=>!Nx(r));return{metres:wl(e,"length"),radians:2*wl(i,"plain")}}function p1(n){let t=d1(n);if(t.length!==16&&t.length!==12)throw new Error(`${t.length===1?"1 number was":`${t.length} numbers were`} found; a pose has 16 (four rows) or 12 (three rows)`);let e=t.map((r,o)=>{try{return Rl(r,Nx(o)?"length":"plain").value}catch(a){throw new Error(`${lN(o)}: ${a.message}`)}}),i=e.length===16?e:[...e,0,0,0,1];if(Math.abs(i[12])+Math.abs(i[13])+Math.abs(i[14])+Math.abs(i[15]-1)>1e-9)throw new Error("the last row must be 0 0 0 1");let s=eh(i);if(s>sN)throw new Error(s===1/0?"the upper left block is left-handed, so it is no rotation":`the upper left block is no rotation: its rows miss being perpendicular unit vectors by ${s.toPrecision(2)}`);return nh(i)}var Co=2*Math.PI,m1=1e-9;function Cp(n){return n.map((t,e)=>b.table.joints[e].type==="R"?cN(t,b.table.joints[e],b.q[e]):t)}function cN(n,{lower:t,upper:e},i){let s=t??-1/0,r=e??1/0,o=Math.ceil((s-m1-n)/Co),a=Math.floor((r+m1-n)/Co),l=Math.round((i-n)/Co);return o>a?s-(n+Co*a)<n+Co*o-r?n+Co*a:n+Co*o:n+Co*Math.min(Math.max(l,o),a)}function Ux(n,t){let e=t?.self_motions??[],i=pe.task??b.plan?.task,s=i==="pose";n.classList.toggle("stale",t?.self_motions===null);for(let p of n.querySelectorAll("input"))p.disabled=t?.self_motions===null;if(t?.self_motions===null&&n.childElementCount)return;let r=t?.self_motions===null?"pending":t?.self_motions;if(n.drawn===r)return;n.drawn=r;let{open:o}=n.querySelector("details")??n.was??{};if(n.was={open:o},r==="pending"){Gt(n,E("p",{class:"hint",text:"Following the self-motions of this pose \u2026"}));return}let a=i==="position"?"the tool point stands still":i==="pose"?"the tool stands still":"the tool point and its axis stand still",l=p=>p.dimension>1?`one line in a surface of ${p.dimension} dimensions`:p.closed?"a closed curve":"an open curve",c=(p,y)=>{let g=p.moves.length>3?"most of its joints":p.moves.join(" and "),m=p.inside.length?dN(p):"All of it lies outside the limits.";return E("div",{class:"self-motion"},E("p",{},E("strong",{text:e.length>1?`Self-motion ${y+1} of ${e.length}`:"Self-motion"}),` by ${g}, ${l(p)}: the arm moves, ${a}. ${m}`),pN(p,y,t.T,s))},u=e.length?x1(e):-1;n.here=u;let h=e.map((p,y)=>y===u?null:c(p,y)).filter(Boolean),d=h.length?E("details",{class:"fold",open:o},E("summary",{text:h.length===1?"One other self-motion":`${h.length} other self-motions`}),h):null,f=t?.untraced?E("p",{class:"hint",text:`The self-motions are not known: ${t.untraced}`}):null;Gt(n,u>=0?c(e[u],u):null,d,f)}function g1(n,t){let e=t?.self_motions;if(!(!e?.length||n.drawn!==e||b.q.length!==e[0].q[0].length)){if(x1(e)!==n.here){n.drawn=null,Ux(n,t);return}for(let i of n.querySelectorAll("input"))i.stand()}}var uN=n=>n.reduce((t,e,i)=>t+Math.sin((e-b.q[i])/2)**2,0),x1=n=>{let t=n.map(e=>Math.min(...e.q.map(uN)));return t.indexOf(Math.min(...t))};function hN(n){let t=(s,r)=>s.map((o,a)=>b.table.joints[a]?.type==="P"?o-r[a]:Math.atan2(Math.sin(o-r[a]),Math.cos(o-r[a]))),e=n.s[0],i=1/0;for(let s=0;s+1<n.q.length;s++){let r=t(n.q[s+1],n.q[s]),o=t(b.q,n.q[s]),a=r.reduce((u,h)=>u+h*h,0),l=a>0?Math.min(Math.max(r.reduce((u,h,d)=>u+h*o[d],0)/a,0),1):0,c=r.reduce((u,h,d)=>u+(o[d]-l*h)**2,0);c<i&&([i,e]=[c,n.s[s]+l*(n.s[s+1]-n.s[s])])}return e}var dN=({inside:n})=>n.length===1&&n[0][0]<=1e-9&&n[0][1]>=1-1e-9?"":`Inside the limits: ${n.map(([t,e])=>`${(100*t).toFixed(1)} to ${(100*e).toFixed(1)} %`).join(", ")} of it.`;function fN(n){let t=[],e=0;for(let[i,s]of n)t.push(`var(--wrong-soft) ${100*e}% ${100*i}%`,`var(--good) ${100*i}% ${100*s}%`),e=s;return t.push(`var(--wrong-soft) ${100*e}% 100%`),`linear-gradient(to right, ${t.join(", ")})`}function pN(n,t,e,i){let s=E("input",{type:"range",min:"0",max:"1",step:"any",value:"0","aria-label":`Along self-motion ${t+1}`,"data-testid":`self-motion-${t+1}`}),r=()=>{xi();let o=Number(s.value),a=Math.max(n.s.findLastIndex(h=>h<=o),0),l=Math.min(a+1,n.q.length-1),c=l>a?(o-n.s[a])/(n.s[l]-n.s[a]):0;s.style.setProperty("--at",`${100*o}%`);let u=n.q[a].map((h,d)=>h+c*(n.q[l][d]-h));lt("did",{label:"slide along a self-motion",key:"self-motion"}),Oi(Cp(i?k_(b.table,u,e):u),"self-motion")};return s.stand=()=>{s.value=String(hN(n)),s.style.setProperty("--at",`${100*Number(s.value)}%`)},s.stand(),s.classList.add("parts"),s.style.setProperty("--parts",fN(n.inside)),s.dataset.inside=JSON.stringify(n.inside),s.addEventListener("input",r),s.addEventListener("keydown",o=>{let a={ArrowRight:1,ArrowUp:1,ArrowLeft:-1,ArrowDown:-1,PageUp:10,PageDown:-10}[o.key];if(!a)return;o.preventDefault();let l=Number(s.value)+a/100;s.value=String(n.closed?l-Math.floor(l):Math.min(Math.max(l,0),1)),r()}),s}function _1(){let n=[],t=[],e={},i=E("div",{class:"joints"}),s=E("details",{},E("summary",{class:"hint",text:"Hold by value"}),i),r=E("p",{class:"hint"}),o=Be("Redundant coordinates",[["free","Free"],["chosen","Chosen"]],"free",f=>l(f==="chosen"?n.filter(p=>!p.instead).map(p=>p.name):null),"spare-mode"),a=E("div",{class:"spare",role:"group","aria-label":"Redundant coordinates of the arm","data-testid":"spare",hidden:!0},E("div",{class:"line spread"},E("span",{class:"field-name",text:"Redundant coordinates"}),o),r,s);function l(f,{sliding:p=!1}={}){lt("did",{label:f?`hold ${f.join(" and ")}`:"free the redundant coordinates",key:"spare"}),pe.redundancy=f&&Object.fromEntries(f.map(y=>[y,e[y]])),d(),p?Sw():zs({follow:!0})}let c=f=>n.filter(p=>p.instead===f.instead).map(p=>p.name),u=f=>b.table.joints.findIndex(p=>p.name===f.name);function h(f,p){let y=f.kind==="angle"?Math.PI:Gn(b.table),g=f.lower??-y,m=f.upper??y,x=E("input",{type:"range",min:String(g),max:String(m),step:"any","aria-label":`Slide ${f.name}`,"data-testid":`spare-slider-${p+1}`}),w=!1,v=(M,N)=>{e[f.name]=M,l(c(f),{sliding:N})};x.addEventListener("input",()=>v(Number(x.value),!0)),x.addEventListener("change",()=>zs({follow:!0})),x.addEventListener("keydown",M=>{let N={ArrowRight:1,ArrowUp:1,ArrowLeft:-1,ArrowDown:-1,PageUp:10,PageDown:-10}[M.key];if(N===void 0)return;M.preventDefault(),w=!0;let R=N*gt.step(f.kind)*(M.shiftKey?.1:1);v(Math.min(Math.max(e[f.name]+R,g),m),!0)}),x.addEventListener("keyup",()=>{w&&zs({follow:!0}),w=!1});let A=wn({label:`Value of ${f.name}`,kind:f.kind,testid:`spare-${p+1}`,check:M=>M<g-1e-9&&f.lower!==null?`below the limit ${re(g,f.kind)}`:M>m+1e-9&&f.upper!==null?`above the limit ${re(m,f.kind)}`:null,commit:M=>v(M,!1)}),S=E("span",{class:"limits"}),_=E("div",{class:"joint"},E("span",{class:"joint-name",text:f.name}),E("div",{class:"track"},x,E("div",{class:"under"},S)),A,E("span",{class:"unit"}));return{line:_,show(){let M=e[f.name];x.value=M,x.style.setProperty("--at",`${100*(Math.min(Math.max(M,g),m)-g)/(m-g||1)}%`),x.setAttribute("aria-valuetext",re(M,f.kind)),_.classList.toggle("held",!!(pe.redundancy&&f.name in pe.redundancy)),A.put(Number((M*gt.factor(f.kind)).toFixed(gt.digits(f.kind)+1))/gt.factor(f.kind))},relabel(){bt(_.lastChild,gt.symbol(f.kind));let M=N=>N===null?"no limit":re(N,f.kind,f.kind==="angle"&&gt.angle==="deg"?0:void 0);bt(S,f.lower===null&&f.upper===null?"no limits":`${M(f.lower)} \u2026 ${M(f.upper)}`),A.refresh()}}}function d(){for(let f of n)pe.redundancy&&f.name in pe.redundancy?e[f.name]=pe.redundancy[f.name]:u(f)>=0?e[f.name]=b.q[u(f)]:f.instead&&Number.isFinite(b.solutions?.arm_angle)?e[f.name]=b.solutions.arm_angle:e[f.name]??=0;o.mark(pe.redundancy?"chosen":"free"),bt(r,pe.redundancy?"Held at these values; what is left has separate solutions.":"Free: the solutions form self-motions; the table has those at the present values.");for(let f of t)f.show()}return K("solutions",()=>{let f=b.solutions?.spare;if(!b.solutions||!f&&(b.solutions.brief||b.solutions.status==="REFUSED"))return;let p=JSON.stringify(f??[])!==JSON.stringify(n);if(p){n=f??[],e={},t=n.map(h),Gt(i,t.map(y=>y.line));for(let y of t)y.relabel()}a.hidden=n.length===0,p&&(s.open=n.filter(y=>!y.instead).length>1||!!pe.redundancy),d()}),K("table",f=>{f==="new"&&(n=[],a.hidden=!0)}),K("q",()=>!a.hidden&&!a.closest("[hidden]")&&!pe.redundancy&&d()),K("units",()=>{for(let f of t)f.relabel();d()}),a}function y1(){let n=E("thead"),t=E("tbody"),e=E("p",{class:"hint below",text:"Grey rows lie outside the limits; the joints in red exceed them."}),i=E("div",{class:"scroll"},E("table",{class:"plain solutions","data-testid":"solutions","aria-label":"Solutions"},n,t),e),s=[],r="",o=()=>{let l=`${b.table.joints.map(c=>c.type).join("")}${gt.angle}${gt.length}`;l!==r&&(r=l,s=[],i.classList.toggle("many",b.table.joints.length>6),Gt(t),Gt(n,E("tr",{},E("td"),E("th",{class:"left",text:"posture"}),b.table.joints.map((c,u)=>E("th",{},E("i",{text:"q"}),E("sub",{text:String(u+1)}),E("span",{class:"unit",text:` ${gt.symbol(Ze(c))}`}))),E("th",{text:"off, mm",title:"By how much forward kinematics misses the pose"}))))},a=l=>{let c=b.table.joints.map(()=>E("td")),u=E("span"),h=E("span",{class:"offscreen"}),d=E("td",{class:"unit"}),f=E("tr",{tabindex:"0","data-testid":`solution-${l+1}`},E("th",{scope:"row",text:String(l+1)}),E("td",{class:"left"},u,h),c,d),p=()=>b.solutions?.rows[l]?.q,y=()=>p()&&gs(p()),g=()=>gs(null),m=()=>{p()&&(gs(null),Ii(Cp(p()),.8,`move to solution ${l+1}`))};return f.addEventListener("pointerenter",y),f.addEventListener("pointerleave",g),f.addEventListener("focus",y),f.addEventListener("blur",g),f.addEventListener("click",m),f.addEventListener("keydown",x=>{(x.key==="Enter"||x.key===" ")&&(x.preventDefault(),m())}),{tr:f,cells:c,label:u,beyond:h,residual:d}};return{el:i,show(l){o();let c=l?.rows??[];for(;s.length<c.length;){let u=a(s.length);s.push(u),t.append(u.tr)}i.hidden=c.length===0,e.hidden=c.every(u=>u.inside),s.forEach((u,h)=>{let d=c[h];u.tr.hidden=!d,d&&(u.tr.classList.toggle("beyond",!d.inside),d.label!==null&&bt(u.label,`${d.label}${d.self_motion>=0?" (of a self-motion)":""}`),bt(u.beyond,d.inside?"":", outside the limits"),bt(u.residual,d.residual?Tf(d.residual[0]*1e3):""),u.residual.title=d.residual?`${Tf(d.residual[0])} m, ${Tf(d.residual[1])} rad by forward kinematics`:"",d.q.forEach((f,p)=>{let y=b.table.joints[p],g=y.lower!==null&&f<y.lower-1e-9||y.upper!==null&&f>y.upper+1e-9;bt(u.cells[p],mn(f,Ze(y))),u.cells[p].classList.toggle("out",g)}))}),this.mark()},mark(){let l=b.solutions?.rows??[];s.forEach((c,u)=>c.tr.classList.toggle("here",!!l[u]&&l[u].q.length===b.q.length&&l[u].q.every((h,d)=>Math.abs(Math.sin((h-b.q[d])/2))<1e-5)))}}}var mN={SOLVED:"good",SINGULAR:"note",REDUNDANT:"note",OUT_OF_REACH:"wrong",OUTSIDE_LIMITS:"wrong",UNCERTAIN:"wrong",REFUSED:"wrong"},Ox={OUT_OF_REACH:"Out of reach",OUTSIDE_LIMITS:"Outside the limits",UNCERTAIN:"Not certain",REFUSED:"Refused"},gN=new Set(["REDUNDANT","UNCERTAIN","SINGULAR"]),xN=(n,t)=>`Listed ${n===1?"is 1 posture":`are ${n} postures`}${t===n?"":`, ${t} inside the limits`}.`,Pp=120;function Fx(){Si(b.frames[b.frames.length-1].slice(),"taken")}var b1={id:"inverse",title:"Inverse",wide:!0,build(n,t){n.append(E("div",{class:"line spread"},Ut("Take the present pose",{"data-testid":"take-pose"},Fx),Be("Target as",[["numbers","Position and angles"],["matrix","Matrix"]],"numbers",m=>{i.hidden=m!=="numbers",s.hidden=m!=="matrix"},"target-as")));let e=Ws("Target","target",()=>b.target,(m,x)=>Si(m,"typed",x)),i=E("div",{},e.el),{el:s,show:r}=yN();n.append(i,s,vN());let o=E("p",{class:"verdict","data-testid":"ik-verdict",role:"status"}),a=E("div",{class:"near","data-testid":"ik-nearest"}),l=E("div",{class:"self-motions","data-testid":"self-motions"}),c=y1(),u=E("div",{class:"answer","data-testid":"ik-answer"},a,l,c.el);n.append(_1(),o,u);let h=zo(Pp,()=>{e.show(),r()}),d=zo(Pp,()=>{if(t.hidden)return;let m=b.solutions,x=!sa()&&!na();Na(x,o,u),u.classList.toggle("stale",x&&Tl()),u.inert=x,bN(o,x&&Tl()?null:m),SN(a,x&&Tl()?null:m),Ux(l,m),c.show(m)}),f=zo(Pp,()=>c.mark()),p=zo(Pp,()=>t.hidden||g1(l,b.solutions)),y=m=>()=>na()?m.soon():m();K("target",y(h)),K("notation",e.show),K(["solutions","units"],y(d)),K(["asked","late"],()=>{t.hidden||na()||sa()||(Tl()&&d(),Na(!0,o,u),u.inert=!0)}),K("q",y(f)),K("q",m=>m!=="self-motion"&&p.soon());let g=()=>Gr("target",b.panel==="inverse"?_N(te(b.target)):[]);K("target",m=>m!=="drag"&&g()),K("panel",m=>{Zb(m==="inverse"),(m!=="inverse"||b.hasTarget)&&g(),m==="inverse"&&(b.hasTarget?lt("solutions"):(b.hasTarget=!0,Fx()))}),K("table",m=>{m==="new"&&(b.hasTarget=b.panel==="inverse",b.hasTarget&&Fx())})}};function _N(n){let t=.25*Gn(b.table);return[0,1,2].flatMap(e=>[t,-t].map(i=>n.map((s,r)=>r===e?s+i:s)))}function yN(){let n=E("textarea",{rows:"4","aria-label":"Target as a matrix","data-testid":"target-matrix",spellcheck:"false"}),t=E("p",{class:"reason",role:"alert"}),e=E("p",{class:"hint"});n.addEventListener("input",()=>{try{Si(p1(n.value),"typed",f1(n.value)),bt(t,""),n.removeAttribute("aria-invalid")}catch(r){bt(t,r.message),n.setAttribute("aria-invalid","true")}});let i=null,s=()=>{if(bt(e,`Twelve or sixteen numbers, row by row; the last column in ${gt.length}.`),document.activeElement===n||n.hasAttribute("aria-invalid")&&i===b.target)return;i=b.target,bt(t,""),n.removeAttribute("aria-invalid");let r=b.target.map((o,a)=>a%4===3&&a<12?o*gt.factor("length"):o);n.value=Sp(r.map(o=>Number(o.toFixed(6)))).replaceAll(`,
`,`
`)};return K("units",s),s(),{el:E("div",{hidden:!0},n,e,t),show:s}}function vN(){let n=E("span",{class:"line"}),t=E("input",{type:"checkbox",checked:!0,"data-testid":"follow",on:{change:()=>{pe.follow=t.checked}}}),e=Be("Ghosts",[["all","All"],["inside","In limits"],["none","None"]],"all",i=>{pe.ghosts=i,ra()});return K("task",()=>{t.checked=pe.follow,e.mark(pe.ghosts)}),K("plan",()=>Gt(n,b.plan?.solvable?[E("span",{class:"field-name",text:"Task"}),hn("Task",[["",`${b.plan.task} (default)`],["pose","pose"],["position","position"],["position+axis","position + axis"]],pe.task??"",i=>{lt("did",{label:"choose the task"}),pe.task=i||null,pe.redundancy=null,zs()},{"data-testid":"task"})]:[])),E("div",{class:"line controls"},E("span",{class:"line"},E("span",{class:"field-name",text:"Handles"}),Be("Handles",[["both","Both"],["move","Move"],["turn","Turn"]],"both",Jb)),Be("Axes of the handles",[["local","Tool"],["world","World"]],"local",Kb),E("span",{class:"line"},E("span",{class:"field-name",text:"Snap"}),hn("Snap to whole steps",[["0","off"],["1","1 mm, 1\xB0"],["5","5 mm, 5\xB0"],["10","10 mm, 10\xB0"],["45","45 mm, 45\xB0"]],"0",i=>Qb(Number(i)),{"data-testid":"snap",title:"While dragging; Shift snaps to 5 at any time"})),E("span",{class:"line"},E("span",{class:"field-name",text:"Ghosts"}),e),E("label",{class:"check"},t,"Arm follows"),n)}function bN(n,t){if(!t){Gt(n,E("span",{text:"Solving \u2026"})),n.dataset.tone="note";return}let e=t.rows.length,i=t.rows.filter(a=>a.inside).length;n.dataset.tone=mN[t.status]??"note";let s=e>0&&gN.has(t.status),r=t.status==="SOLVED"&&e?v1(t.missed):[t.why,s&&(t.status==="SINGULAR"||i<e)?xN(e,i):"",v1(t.missed)].filter(Boolean).join(" "),o=Ox[t.status]&&!i?t.why.toLowerCase().includes(Ox[t.status].toLowerCase())?"":Ox[t.status]:s?"":`${e} solution${e===1?"":"s"}${i===e?"":`, ${i} inside the limits`}`;Gt(n,E("strong",{text:o})," ",E("span",{text:r}),t.ms===void 0?null:E("span",{class:"hint took",text:`${t.ms<1?`${Math.round(t.ms*1e3)} \xB5s`:`${t.ms.toFixed(1)} ms`}`}))}var v1=n=>n?`The pose was rounded by ${MN(n)||"less than its digits"} when typed; solved is the nearest one that the arm takes.`:"",wN=(n,t)=>re(n,t,gt.digits(t)+2),MN=n=>[[n.metres,"length"],[n.radians,"angle"]].filter(([t,e])=>t*gt.factor(e)>=.5*10**-(gt.digits(e)+2)).map(([t,e])=>wN(t,e)).join(" and ");function SN(n,t){let e=t?.near;if(!e){Gt(n);return}let i=te(e.T).map(s=>mn(s,"length")).join(", ");Gt(n,E("p",{},E("strong",{text:"Nearest reachable: "}),`${i} ${gt.symbol("length")}, ${re(e.metres,"length")} away`,e.radians>.001?`, turned by ${re(e.radians,"angle")}`:""),E("div",{class:"line"},Ut("Go there",{},()=>Ii(e.q)),Ut("Make it the target",{},()=>Si(e.T,"chosen"))))}var Bx=(n,t)=>{let e=Math.cos(t),i=Math.sin(t);return[1,0,0,n,0,e,-i,0,0,i,e,0,0,0,0,1]};function Ip(n){return Bx(n[3],Math.atan2(n[9],n[5])).every((e,i)=>Math.abs(e-n[i])<1e-12)?{a:n[3],alpha:Math.atan2(n[9],n[5])+0}:null}function Lp(n,t){if(n.convention===t||!n.joints.length)return{...n,convention:t};let e=n.joints,i=e.length,s=e.map(({a:l,alpha:c,text:u})=>({a:l,alpha:c,text:u})),{base:r,tool:o}=n,a;if(t==="modified"){let l=Ip(r)??{a:0,alpha:0};Ip(r)&&(r=Ji()),o=Hn(Bx(s[i-1].a,s[i-1].alpha),o),a=[l,...s.slice(0,-1)]}else{let l=Ip(o)??{a:0,alpha:0};Ip(o)&&(o=Ji()),r=Hn(r,Bx(s[0].a,s[0].alpha)),a=[...s.slice(1),l]}return{...n,convention:t,base:r,tool:o,joints:e.map((l,c)=>({...l,a:a[c].a,alpha:a[c].alpha,text:{...l.text,a:a[c].text?.a,alpha:a[c].text?.alpha}}))}}var w1=30,EN=n=>({name:`joint_${n+1}`,type:"R",a:0,alpha:0,d:0,theta:0,lower:null,upper:null,sign:1,offset:0}),TN={a:"a",alpha:"\u03B1",d:"d",theta:"\u03B8",lower:"lower limit",upper:"upper limit",offset:"zero"};function Dp(n,t,e,{symbolic:i,text:s},r){let o=b.table.joints.map((c,u)=>u!==n?c:{...c,[t]:e,text:{...c.text,[t]:i?s:void 0}}),a=Object.is(b.table.joints[n][t],e)&&b.table.joints[n].text?.[t]===o[n].text[t],l=`edit ${TN[t]??t} of joint ${n+1}`;a||yn({...b.table,joints:o},{what:"cell",label:l,key:`${n}/${t}`,open:!0}),r&&lt("let-go")}function $l(n,t,e){let{postures:i,coupling:s}=b.table,r=Object.fromEntries(Object.entries(i??{}).map(([l,c])=>[l,t(c,0)])),o=t(b.q,0),a=s?t(s,null).map((l,c)=>AN(l&&t(l,0),c,n.length)):null;yn({...b.table,joints:n,postures:r,coupling:a},{q:o,what:"rows",label:e})}var AN=(n,t,e)=>n??Array.from({length:e},(i,s)=>+(s===t));function M1(n,t,e){let i=b.table.joints[n];return e===null?null:t==="lower"&&i.upper!==null&&e>i.upper?"above the upper limit":t==="upper"&&i.lower!==null&&e<i.lower?"below the lower limit":null}function kx(){let n=b.table.joints.length;return n>=w1?(de(`At most ${w1} joints.`,"wrong"),!1):($l([...b.table.joints,EN(n)],(t,e)=>[...t,e],`add joint ${n+1}`),document.querySelector(`[data-testid="dh-${n+1}-a"]`)?.focus(),!0)}function S1(n,t){let e=i=>{let s=i.slice();return[s[n],s[t]]=[s[t],s[n]],s};$l(e(b.table.joints),e,`swap joints ${n+1} and ${t+1}`)}var RN=["did","table","path","path-loaded","program","routing","sequence","sequence-loaded","world"],Hx="The server was away and is back; this was not answered. Ask again.";function Yr(n){let t=E("p",{class:"verdict",role:"status","data-testid":n,hidden:!0});return t.say=(e,i="wrong")=>{t.hidden=!e,t.dataset.tone=i,bt(t,e)},t}var ls=()=>document.querySelector("#panel-table section"),Np=()=>document.querySelector("#panel-world section"),zx=(n,t)=>n.length===t.length&&n.every((e,i)=>Object.is(e,t[i]));async function Up({roots:n,about:t},e){let i=Sr(...n());if(i)throw new Error(`${i} Nothing was computed.`);let s=t(),r=await e();if(!zx(s,t()))throw new Error("What was asked was changed meanwhile, so the answer is not shown. Ask again.");return r}function Po({text:n,working:t,testid:e,verdict:i,roots:s,about:r,ask:o,show:a,forget:l,open:c=()=>!0}){let u=E("button",{type:"button",class:"primary",text:n,"data-testid":e}),h=io(m=>i.classList.toggle("stale",m)),d=null,f=0,p=!1;u.ask=async(...m)=>{let x=r(),w=d&&zx(d,x);d=x,p=!1,u.disabled=!0,f+=1,bt(u,t),Na(!0,i),h(!0);try{let v=await Up({roots:s,about:r},()=>o(...m));if(v.stopped)return;d=r(),a(v)}catch(v){p=v instanceof ko,d===x&&!w&&(d=null,l?.()),i.say(v.message)}finally{f-=1,f||y()}};function y(){Na(!1,i),h(!1),bt(u,n),u.show()}u.show=()=>{u.disabled=!c()},u.addEventListener("click",()=>u.ask());let g=()=>{!d||zx(d,r())||(d=null,i.say(""),l?.())};return K("online",m=>{m&&p&&i.say(Hx,"note"),p=!1}),K(RN,()=>queueMicrotask(g)),u}async function Op(){let n=Sr(ls());if(n){de(`${n} Nothing was written.`,"wrong");return}try{hi(`${b.table.name||"arm"}.toml`,(await Oe("save",{})).text,"application/toml")}catch(t){de(t.message,"wrong")}}function A1(){let n=(t,e,i)=>{let s=E("input",{type:"file",class:"offscreen",tabindex:"-1",...i,on:{change:()=>PN(s)}});return[Ut(t,{title:e},()=>s.click()),s]};return[...n("Open\u2026","A robot file (.toml) or a URDF",{accept:".toml,.urdf,.xml","aria-label":"Robot file","data-testid":"robot-file"}),...n("Folder\u2026","A folder with a URDF and the meshes that it names; they stay in this browser",{webkitdirectory:!0,multiple:!0,"aria-label":"Folder with a robot file and its meshes","data-testid":"robot-folder"})]}var CN=/\.(toml|urdf|xml)$/i,E1=2e5;async function PN(n){let t=[...n.files];if(n.value="",!t.length)return;let e=t.filter(s=>CN.test(s.name)),i=t.length===1?t[0]:e.find(s=>/\.urdf$/i.test(s.name))??e[0];if(!i){de("There is no robot file (.urdf or .toml) in this folder.","wrong");return}if(i.size>E1){de(`${i.name} has ${i.size} bytes; a robot file has at most ${E1.toLocaleString("en")}.`,"wrong");return}try{let{table:s,looks:r}=await Fi("open",{name:i.name.slice(-80),text:await i.text()});yn(s,{q:La(s),what:"new",label:`open ${i.name.slice(-40)}`}),Wl(r,s,a=>T1(t,a));let o=r?.shapes.filter(a=>a.file&&!T1(t,a.file)).length;o&&de(`${o} of its meshes were not opened with it: open the folder that holds them.`)}catch(s){de(s.message,"wrong")}}function T1(n,t){let e=t.replace(/^\w+:\/\//,"").split("/"),i=s=>{let r=(s.webkitRelativePath||s.name).split("/"),o=0;for(;o<e.length&&o<r.length&&e.at(-1-o)===r.at(-1-o);)o+=1;return o};return n.reduce((s,r)=>i(r)>(s?i(s):0)?r:s,null)}var Gx=(n,t,e,i=!1)=>Ut(n,{class:"icon","aria-label":t,disabled:i},e),Io=({k:n,n:t,name:e,move:i=null,remove:s})=>[...i?[Gx("\u2191",`Move ${e} up`,()=>i(n,n-1),n===0),Gx("\u2193",`Move ${e} down`,()=>i(n,n+1),n===t-1)]:[],Gx("\xD7",`Remove ${e}`,()=>s(n))];var Vx={geometry:[["a","a","length"],["alpha","\u03B1","angle"],["d","d","length"],["theta","\u03B8","angle"]],joint:[["lower","lower limit",null],["upper","upper limit",null],["offset","zero",null]]},IN=({catalog:n,...t})=>n?{...t,derived:n}:t,LN=n=>n.type==="R"?"angle":"length",C1={id:"table",title:"DH table",wide:!0,build(n){let t="geometry",e=[],i=E("thead"),s=E("tbody"),r=E("table",{class:"dh","data-testid":"dh-table","aria-label":"DH table"},i,s),o=E("p",{class:"reason",role:"alert","data-testid":"dh-wrong"}),a=E("p",{class:"verdict","data-testid":"arm-kind"}),l=Be("Convention",[["standard","Standard"],["modified","Modified (Craig)"]],b.table.convention,v=>{v!==b.table.convention&&yn(Lp(b.table,v),{what:"rows",label:`make the table ${v}`})},"convention"),c=E("p",{class:"hint order"}),u=E("input",{type:"text","aria-label":"Name of the arm","data-testid":"arm-name",maxlength:"60",on:{change:()=>yn({...IN(b.table),name:u.value||"my-arm"},{what:"name",label:"name the arm"})}}),h=Ws("Base","base",()=>b.table.base,v=>yn({...b.table,base:v},{what:"cell",label:"edit the base",key:"base",open:!0})),d=Ws("Tool","tool",()=>b.table.tool,v=>yn({...b.table,tool:v},{what:"cell",label:"edit the tool",key:"tool",open:!0}));n.append(E("div",{class:"line spread"},E("span",{class:"line"},u),E("span",{class:"line"},Ut("Blank",{title:"An empty table"},()=>yn(z_(b.table.convention),{q:[],what:"new",label:"begin a blank table"})),...A1(),Ut("Save",{title:"As a robot file"},Op))),E("div",{class:"line spread"},l,Be("Columns",[["geometry","Geometry"],["joint","Limits and zeros"]],t,v=>{t=v,m()},"dh-part")),c,r,E("div",{class:"line"},Ut("+ Add joint",{class:"add","data-testid":"add-joint"},()=>kx()),E("span",{class:"hint",text:"Numbers or expressions: pi/2, 90 deg, 0.5 m, 125+85. With pi, an angle is in radians. Arrows and Enter go from cell to cell, Alt and an arrow steps; a table can be pasted."})),o,a,Lb(),E("details",{class:"fold","data-testid":"base-tool"},E("summary",{text:"Base and tool"}),h.el,d.el)),np(s,"paste a table",v=>{for(;b.table.joints.length<v&&kx(););}),n.addEventListener("verdict",v=>{f(v.detail??R1(n))});let f=v=>bt(o,v?`${v.label}: ${v.reason}. The arm stays as it was.`:""),p=(v,A,[S,_,M])=>{let N=v.type==="R"&&S==="theta"||v.type==="P"&&S==="d",R=S==="lower"||S==="upper",L=wn({label:`Joint ${A+1}, ${_}`,kind:M??LN(v),testid:`dh-${A+1}-${S}`,key:`${v.name}/${S}`,empty:R?null:void 0,check:z=>R?M1(A,S,z):z!==null&&Math.abs(z)>1e6?"larger than a million":null,input:(z,G)=>Dp(A,S,z,G,!1),commit:(z,G)=>Dp(A,S,z,G,!0)});return R&&(L.placeholder="none"),e.push({f:L,i:A,key:S}),E("td",{class:N?"variable":""},N?E("span",{class:"plus"},E("i",{text:"q"}),E("sub",{text:String(A+1)})," +"):null,L)},y=(v,A)=>Ut(v.type,{class:`type type-${v.type}`,"data-testid":`dh-${A+1}-type`,"aria-label":`Joint ${A+1} is ${v.type==="R"?"revolute":"prismatic"}; press to change`,title:v.type==="R"?"Revolute: turns. Press for prismatic.":"Prismatic: slides. Press for revolute."},()=>$l(b.table.joints.map((S,_)=>_===A?{...S,type:S.type==="R"?"P":"R",lower:null,upper:null,offset:0,text:{...S.text,lower:void 0,upper:void 0,offset:void 0}}:S),S=>S.map((_,M)=>M===A&&typeof _=="number"?0:_),`make joint ${A+1} ${v.type==="R"?"prismatic":"revolute"}`)),g=(v,A)=>E("td",{class:"tools"},Io({k:v,n:A,name:`joint ${v+1}`,move:S1,remove:()=>$l(b.table.joints.filter((S,_)=>_!==v),S=>S.filter((_,M)=>M!==v),`remove joint ${v+1}`)})),m=v=>v==="undo"||v==="new"?x():$i(s,x),x=()=>{e=[];let{joints:v}=b.table,A=b.table.convention==="modified",S=t==="geometry"?Vx.geometry.map(([_,M,N])=>E("th",{scope:"col"},E("i",{text:M}),E("sub",{text:A&&(_==="a"||_==="alpha")?"i\u22121":"i"}),E("span",{class:"unit",text:` ${gt.symbol(N)}`}))):["name","lower limit","upper limit","zero","sense"].map(_=>E("th",{scope:"col",text:_}));Gt(i,E("tr",{},E("th",{scope:"col",text:"i"}),E("th",{scope:"col"},E("span",{class:"offscreen",text:"type"})),S,E("td"))),Gt(s,v.map((_,M)=>{let N=t==="geometry"?Vx.geometry.map(R=>p(_,M,R)):[E("td",{},E("input",{type:"text",class:"name",value:_.name,maxlength:"40","aria-label":`Joint ${M+1}, name`,on:{change:R=>Dp(M,"name",R.target.value||`joint_${M+1}`,{},!0)}})),...Vx.joint.map(R=>p(_,M,R)),E("td",{},Ut(_.sign>0?"+":"\u2212",{class:"type","aria-label":`Joint ${M+1}, sense of the maker: ${_.sign>0?"as the table":"against the table"}`},()=>$l(b.table.joints.map((R,L)=>L===M?{...R,sign:-R.sign}:R),R=>R,`turn the sense of joint ${M+1}`)))];return E("tr",{"data-testid":`dh-row-${M+1}`},E("th",{scope:"row",text:String(M+1)}),E("td",{},y(_,M)),N,g(M,v.length))})),v.length||s.append(E("tr",{},E("td",{colspan:"7",class:"hint",text:"No joints yet."}))),w()},w=()=>{for(let{f:v,i:A,key:S}of e){let _=b.table.joints[A];v.put(_[S],_.text?.[S]??null)}l.mark(b.table.convention),bt(c,b.table.convention==="standard"?"A\u1D62 = Rz(\u03B8) Tz(d) Tx(a) Rx(\u03B1)":"A\u1D62 = Rx(\u03B1) Tx(a) Rz(\u03B8) Tz(d), each row with the a and \u03B1 before its joint"),document.activeElement!==u&&(u.value=b.table.name),h.show(),d.show()};K("table",v=>{v==="cell"||v==="name"||v==="postures"?w():m(v),f(R1(n))}),K("units",m),K("notation",()=>{h.show(),d.show()}),K("plan",()=>{if(!b.plan){a.dataset.tone="note",Gt(a,E("span",{text:"Looking how it is solved \u2026"}));return}a.dataset.tone=b.plan.solvable?"good":"wrong",Gt(a,E("strong",{text:ch(b.plan)||(b.plan.refused?"Refused":"Not solved")})," ",E("span",{text:b.plan.explain??""}))}),m()}};function R1(n){let t=n.querySelector(".number.wrong");return t?{label:t.getAttribute("aria-label"),reason:t.title}:null}var DN=4,NN=n=>{let t=n.toFixed(DN);return Number(t)<0?`(${t})`:t.replace("-","")};function Fp(n,t,e){let i=Mr(t,e),s=t.joints.map((c,u)=>wr(c,i[u])),r=c=>c.reduce((u,[h,d])=>u+d*s[h-1].theta,0),o={cos:c=>Math.cos(r(c)),sin:c=>Math.sin(r(c)),slide:([[c]])=>s[c-1].d};return n.symbols.reduce((c,u)=>c.replaceAll(u.latex,NN(o[u.is](u.joints))),n.latex).replaceAll("\\left(","(").replaceAll("\\right)",")").replace(/(\d|\))\s+(?=\d|\()/g,"$1 \\cdot ")}var Bp=null;async function UN(){return Bp??=(await import("./katex-PEGWDONQ.js")).default,Bp}function ON(n,t){let e=E("span");try{n.render(t.latex,e,{throwOnError:!0,strict:!1,trust:!1})}catch{e.textContent=t.text}return e}function P1(n,t){let e=[[i=>typeof i=="string",i=>i],[i=>"latex"in i,i=>ON(n,i)],[i=>"code"in i,i=>E("code",{text:i.code})],[()=>!0,i=>E("em",{text:i.emphasis})]];return t.map(i=>e.find(([s])=>s(i))[1](i))}var FN=n=>n.map(t=>typeof t=="string"?t:t.latex?`$${t.latex}$`:t.code??t.emphasis).join("");function BN(n){let t=b.table.joints.map((e,i)=>E("th",{},E("i",{text:"q"}),E("sub",{text:String(i+1)}),E("span",{class:"unit",text:` ${gt.symbol(Ze(e))}`})));return[E("h3",{text:"The formulas at the present pose"}),E("table",{class:"plain","data-testid":"formula-values","aria-label":"Branches of the formulas at the present pose"},E("thead",{},E("tr",{},E("th",{text:"branch"}),t)),E("tbody",{},n.map((e,i)=>E("tr",{},E("th",{scope:"row",text:String(i+1)}),e.map((s,r)=>E("td",{text:mn(s,Ze(b.table.joints[r]))}))))))]}var I1={id:"equations",title:"Equations",wide:!0,build(n,t){let e="forward",i="symbols",s=null,r=[],o=[],a=E("p",{class:"hint",role:"status","data-testid":"equations-note"}),l=E("div",{class:"equations",tabindex:"0",role:"region","aria-label":"Equations","data-testid":"equations"}),c=Be("Written with",[["symbols","Symbols"],["numbers","Lengths"],["present","Numbers"]],i,S=>{i=S,m()},"equation-numbers"),u=E("div",{class:"scroll"});n.append(E("div",{class:"line spread"},E("span",{class:"line"},Be("Equations",[["forward","Forward"],["inverse","Inverse"],["singular","Singularities"]],e,S=>{e=S,m()},"which-equations"),c),Ut("Copy LaTeX",{class:"quiet"},()=>no(f()))),a,u,l);let h=S=>S.symbols&&i==="present"?Fp(S,b.table,b.q):S.latex,d=S=>S.number===void 0?"":` \\tag{${S.number}}`,f=()=>o.map(S=>S.kind==="equation"?`\\[ ${h(S)}${d(S)} \\]`:FN(S.pieces)).join(`

`);function p(){let S=[...l.querySelectorAll(".formula")];for(let M of S)M.classList.remove("broad");let _=S.map(M=>M.scrollWidth>M.clientWidth?M.scrollWidth:0);S.forEach((M,N)=>{M.classList.toggle("broad",_[N]>0),M.style.setProperty("--across",`${_[N]}px`),_[N]?M.tabIndex=0:M.removeAttribute("tabindex")})}let y=0;new ResizeObserver(()=>{l.clientWidth!==y&&(y=l.clientWidth,p())}).observe(l);function g(S){r=[],Gt(l,o.map(_=>x(S,_))),p(),w()}async function m(){if(t.hidden||!b.table.joints.length)return;let S=`${e}/${i}/${JSON.stringify(b.table.joints)}${b.table.convention}`;if(s!==S){s=S,bt(a,"Deriving \u2026"),o=[],Gt(l),Gt(u);try{let[_,M]=await Promise.all([UN(),Oe("equations",{which:e,numbers:i==="symbols"?i:"numbers"},N=>bt(a,N.note??""))]);if(s!==S)return;bt(a,M.note??""),o=M.blocks,g(_),c.hidden=e!=="forward",Gt(u),v()}catch(_){if(s!==S)return;s=null,bt(a,_.message)}}}function x(S,_){if(_.kind==="heading"||_.kind==="step")return E("h3",{},P1(S,_.pieces));if(_.kind!=="equation")return E("p",{class:"prose"},P1(S,_.pieces));let M=E("div",{class:"formula"});try{S.render(h(_),M,{displayMode:!0,throwOnError:!0,strict:!1,trust:!1,maxSize:20,maxExpand:1e3})}catch{M.replaceChildren(E("code",{text:h(_)}))}if(_.number!==void 0)return E("div",{class:"formula-row numbered"},M,E("span",{class:"hint",text:`(${_.number})`}));if(_.entry===void 0)return M;let N=E("output",{class:"value","data-entry":String(_.entry)});return r.push({value:N,entry:_.entry}),E("div",{class:"formula-row"},M,N)}let w=tr(()=>{if(t.hidden)return;let S=b.frames[b.frames.length-1];for(let{value:_,entry:M}of r)bt(_,`= ${M%4===3?`${ii(S[M]*gt.factor("length"),gt.digits("length"))} ${gt.length}`:ii(S[M],4)}`)}),v=er(async()=>{if(t.hidden||e!=="inverse"||!l.childElementCount)return;let S=b.frames.at(-1);try{let{rows:_}=await Oe("formulas",{T:S});if(S!==b.frames.at(-1))return;u.classList.remove("stale"),Gt(u,_.length&&e==="inverse"?BN(_):null)}catch{Gt(u)}},250),A=er(()=>{!t.hidden&&Bp&&o.length&&e==="forward"&&i==="present"&&g(Bp)},120);K("q",A),K("panel",A),K("q",()=>u.classList.add("stale")),K("q",v),K("units",v),K("panel",m),K("plan",m),K(["q","units"],w)}};var kN=()=>b.frames.at(-1).slice();function kp(n,t){let e=b.path,i=n==="path"?"":`${n}-`,s=(a,l,c,u)=>{lt("did",{label:c,key:u}),e[a]=l,t(),lt("path",n)},r=["from","to"].map(a=>{let l=Ws(a==="from"?"From":"To",`${n}-${a}`,()=>e[a],u=>s(a,u,`set \u201C${a}\u201D of the path`,`path-${a}`)),c=Ut("Take the present pose",{class:"quiet","data-testid":`${i}take-${a}`},()=>{s(a,kN(),`take \u201C${a}\u201D of the path`),l.show()});return{el:E("div",{class:"end"},c,l.el),show:l.show}}),o=()=>r.forEach(a=>a.show());return K("path",a=>a!==n&&o()),K("path-loaded",o),K("notation",o),{el:E("div",{},...r.map(a=>a.el)),show:o,showEnd:a=>r[a].show()}}var L1=()=>b.frames[b.frames.length-1].slice(),D1={id:"path",title:"Path",wide:!0,build(n,t){let e=b.path,i=null,s=kp("path",()=>d()),r=E("span",{class:"hint"}),o=wn({label:"Number of points N",testid:"path-n",check:w=>Number.isInteger(w)&&w>=2&&w<=2e3?null:"a whole number from 2 to 2000",input:w=>{lt("did",{label:"set the points of the path",key:"path-n"}),e.n=w}}),a=wn({label:"Seconds for the whole line",testid:"path-seconds",check:w=>w>0&&w<=3600?null:"more than 0, at most 3600",input:w=>{lt("did",{label:"set the seconds of the path",key:"path-seconds"}),e.seconds=w,qr(i)}}),l=Ut("Keep the orientation of \u201CFrom\u201D",{class:"quiet"},()=>{if(e.from&&e.to){let w=te(e.to);lt("did",{label:"keep the orientation of the path"}),e.to=e.from.slice(),[3,7,11].forEach((v,A)=>{e.to[v]=w[A]}),s.show(),lt("path","path"),d()}}),c=Yr("path-verdict"),u=Po({text:"Plan the line",working:"Planning \u2026",testid:"plan",verdict:c,roots:()=>[n,ls()],about:()=>[Cs(),e.from,e.to,e.n],ask:w=>Oe("follow",p(w??b.q)),show:y,forget:()=>{qr(i),Gt(h)}}),h=E("div",{class:"branches","data-testid":"branches"});n.append(s.el,E("div",{class:"line"},l,r),E("div",{class:"line"},E("label",{class:"field"},E("span",{class:"field-name",text:"Points N"}),o),E("label",{class:"field"},E("span",{class:"field-name",text:"Seconds"}),a),u,E("span",{class:"hint",text:"starts from the solution nearest to the present posture"})),c,h);let d=()=>{if(!e.from||!e.to){bt(r,"");return}let w=U_(e.from,e.to);bt(r,`${re(Ui(Ni(te(e.to),te(e.from))),"length")} long${w>1e-6?`, turning ${re(w,"angle")}`:", orientation kept"}`),ia(Array.from({length:33},(v,A)=>te(Cf(e.from,e.to,A/32))))},f=null,p=w=>f={T0:e.from,T1:e.to,n:e.n,start:w};function y(w){if(b.track=w,c.say(w.explain,w.complete?"good":"wrong"),w.complete||g(w),Gt(h,w.branches.length?E("h3",{text:"Branches that start at the first pose"}):null,w.branches.map((_,M)=>E("button",{type:"button",class:`branch ${M===w.chosen?"chosen":""}`,"aria-pressed":String(M===w.chosen),"data-testid":`branch-${M+1}`,disabled:!_.q,title:_.cause||"reaches the end",on:{click:async()=>{await Ii(_.q,.4,`take branch ${M+1}`),u.ask(_.q)}}},E("span",{class:"branch-name",text:`${M+1}  ${_.label}`}),m(_.s),E("span",{class:"branch-end",text:_.complete?"to the end":_.q?`${_.points} of ${e.n}`:"starts outside the limits"})))),ia(w.path.map(te)),!w.q.length){ci(null);return}let v=w.path.length,A=w.q.map((_,M)=>M+1),S=w.q.map((_,M)=>v>1?e.seconds*M/(v-1):0);i=fr({table:b.table,q:w.q,xs:A,xName:"point",xEnd:v,seconds:S,title:`${b.table.name}: straight line, ${w.q.length} of ${v} points`,events:w.events.map(_=>({..._,x:1+_.s*(v-1),short:_.cause}))}),ci(i)}function g(w){c.say(`${w.explain}
Looking for what would let it pass \u2026`,"wrong"),Oe("cures",f).then(v=>v.explain??w.explain).catch(()=>w.explain).then(v=>b.track===w&&!c.hidden&&c.say(v,"wrong"))}function m(w){let v=E("span",{class:"bar-fill"});return v.style.setProperty("width",`${100*w}%`),E("span",{class:"bar"},v)}let x=()=>{s.show(),o.put(e.n),a.put(e.seconds),d()};K("panel",w=>{w==="path"&&(e.from??=L1(),e.to??=L1(),x())}),K("path-loaded",x),K("units",d),K("table",w=>{["postures","name","gripper"].includes(w)||(ia([]),t.hidden||x())})}};var N1=Math.PI/180,zN=()=>({turn_speed:180*N1,turn_acceleration:600*N1,turn_jerk:null,slide_speed:.5,slide_acceleration:2,slide_jerk:null,tool_speed:.5});var HN=n=>b.program.slice(0,Math.max(n,0)).findLast(t=>t.kind==="frame")?.T??Ji(),Vu=n=>Hn(Ia(HN(n)),b.frames.at(-1));function zp(n,t){let e=(s,r)=>{for(;s>=1&&s<=t.length&&t[s-1]<0;)s+=r;return s>=1&&s<=t.length?t[s-1]+1:null},i=[];return n.forEach((s,r)=>{if(t[r]<0)return;if(s.kind!=="call"){i[t[r]]=s;return}let o=[e(s.first,1),e(s.last,-1)].filter(a=>a!==null);o.length===2&&s.first<=s.last&&(i[t[r]]={...s,first:Math.min(...o),last:Math.max(...o)})}),i.filter(Boolean)}var U1=(n,t)=>n.kind==="call"&&n.last>t?"Only steps before it can be done again: move it down, or name others.":null;function pa(n,t,{key:e,open:i}={}){lt("did",{label:t,key:e,open:i}),!b.program.length&&n.length&&(b.start??=b.q),b.program=n,lt("program")}var ma=(n,t,e,i)=>pa(b.program.map((s,r)=>r===n?{...s,...t}:s),e,i);function O1(n,t){lt("did",{label:t,key:"limits"}),b.limits={...Hp(),...n},lt("program","limits")}var Hp=()=>({...zN(),...b.limits});function F1(n,t="set the start of the program"){lt("did",{label:t}),b.start=n,lt("program")}var Gp=()=>b.start?.length===b.table.joints.length?b.start:b.q;function Lo(){let n=Hp(),t=b.table.joints,e=i=>t.every(s=>n[`${s.type==="R"?"turn":"slide"}_${i}`]===null)?null:t.map(s=>n[`${s.type==="R"?"turn":"slide"}_${i}`]??1e6);return{start:Gp(),limits:{speed:e("speed"),acceleration:e("acceleration"),jerk:e("jerk"),tool_speed:n.tool_speed},steps:b.program.map(({name:i,...s})=>s)}}var GN=()=>({turn:null,cone:0,axis:"z",cost:"motion",singularity:0,clearance:0,start:null,end:null}),jr=()=>b.routing??GN();function ql(n,t,e=t){lt("did",{label:t,key:e}),b.routing={...jr(),...n},lt("routing")}var Wx=()=>{let n=jr();return{turn:n.turn??"free",cone:n.cone,axis:n.axis}};function Vp(){let n=jr(),t=b.path,e=b.world.some(i=>i.role!=="object"&&i.kind!=="frame");return{T0:t.from,T1:t.to,n:t.n,free:Wx(),cost:n.cost,singularity:n.singularity,start:n.start?.q??null,end:n.end?.q??null,world:b.world,clearance:e?n.clearance:0}}function $x(n,t){let e=Uint8Array.from(atob(n.open[t]),i=>i.charCodeAt(0));return(i,s)=>{let r=i*n.turn.length+s;return e[r>>3]>>7-(r&7)&1}}var Xl=n=>{let t=n.turn[1]-n.turn[0];return Math.abs(t*n.turn.length-2*Math.PI)<1e-6};function B1(n,t,e){let i=n.turn[1]-n.turn[0],s=n.turn.length,r=Math.round((e-n.turn[0])/i);if(Xl(n)&&(r=(r%s+s)%s),r<0||r>=s)return[];let o=Math.round(t*(n.s.length-1));return n.branches.filter((a,l)=>$x(n,l)(o,r))}var ga=Math.PI/180,k1=3.4,VN=2.1,z1=.5,WN=.9;function H1({drag:n,drop:t,scrub:e}){let i=E("canvas",{"aria-hidden":"true"}),s=E("div",{class:"route-now",hidden:!0}),r=E("div",{class:"route-word",hidden:!0,"data-testid":"route-word"}),o=["start","end"].map(D=>E("div",{class:`route-end ${D}`,role:"slider",tabindex:"0","aria-orientation":"vertical","aria-label":D==="start"?"Turn of the tool where the route begins":"Turn of the tool where it ends","data-testid":`route-${D}`,hidden:!0})),a=E("div",{class:"route-map","data-testid":"route-map"},i,s,...o,r),l=null,c=null,u=null,h=null,d={start:!1,end:!1},f=[],p=()=>parseFloat(getComputedStyle(document.documentElement).fontSize);function y(){let D=p(),O=a.clientWidth,Z=a.clientHeight,X={l:k1*D,t:z1*D,w:O-(k1+WN)*D,h:Z-(z1+VN)*D},J=-Math.PI,nt=Math.PI;if(l.map&&!Xl(l.map))J=l.map.turn[0],nt=l.map.turn.at(-1);else if(l.turn.length){let dt=90*ga;J=Math.min(J,dt*Math.floor(Math.min(...l.turn)/dt)),nt=Math.max(nt,dt*Math.ceil(Math.max(...l.turn)/dt))}u={...X,lo:J,hi:nt,W:O,H:Z}}let g=D=>u.l+D*u.w,m=D=>u.t+(1-(D-u.lo)/(u.hi-u.lo))*u.h,x=D=>u.lo+(1-(D-u.t)/u.h)*(u.hi-u.lo),w=D=>Ft.curves[Math.max(l.branches.indexOf(D),0)%Ft.curves.length];function v(){f=(l.map?.branches??[]).map((D,O)=>{let Z=$x(l.map,O),X=l.map.s.length,J=l.map.turn.length,nt=E("canvas",{width:X,height:J}),dt=nt.getContext("2d"),ft=dt.createImageData(X,J),st=parseInt(w(D).slice(1),16);for(let yt=0;yt<X;yt++)for(let xt=0;xt<J;xt++){if(!Z(yt,xt))continue;let Tt=4*((J-1-xt)*X+yt);ft.data.set([st>>16,st>>8&255,st&255,255],Tt)}return dt.putImageData(ft,0,0),{name:D,c:nt}})}function A(){if(!l||!a.clientWidth)return;y();let D=Math.min(devicePixelRatio,2),O=i.getContext("2d");i.width=u.W*D,i.height=u.H*D,O.scale(D,D);let Z=.76*p();O.font=`${Z}px "Inter Variable", system-ui, sans-serif`,O.fillStyle=Ft.ground,O.fillRect(u.l,u.t,u.w,u.h),O.save(),O.beginPath(),O.rect(u.l,u.t,u.w,u.h),O.clip(),S(O),_(O),M(O),O.restore(),N(O,Z),L()}function S(D){let O=l.map;if(!O)return;let Z=O.turn[1]-O.turn[0],X=Xl(O),J=O.turn[0]-Z/2,nt=O.turn.at(-1)+Z/2,dt=X?Math.floor((u.lo-J)/(2*Math.PI)):0,ft=X?Math.ceil((u.hi-nt)/(2*Math.PI)):0;for(let{name:st,c:yt}of f)if(!(c&&c!==st)){D.globalAlpha=(c?.4:.3)*(Ft.dark?.8:1);for(let xt=dt;xt<=ft;xt++){let Tt=m(nt+2*Math.PI*xt),At=m(J+2*Math.PI*xt);D.drawImage(yt,u.l,Tt,u.w,At-Tt)}}D.globalAlpha=1}function _(D){if(!l.blocked)return;let[O,Z]=l.blocked.s,X=g(O),J=Math.max(g(Z)-X,3);D.fillStyle=Ft.wrong,D.globalAlpha=.75,D.fillRect(Math.min(X,u.l+u.w-J),u.t,J,u.h),D.globalAlpha=1}function M(D){if(!l.q.length)return;let O=[[0]];l.labels.forEach((Z,X)=>{X&&Z!==l.labels[X-1]&&O.push([X-1]),O.at(-1).push(X)});for(let[Z,X]of[[.38,!0],[.18,!1]])for(let J of O){D.beginPath();for(let nt of J)D.lineTo(g(l.s[nt]),m(l.turn[nt]));D.lineWidth=Z*p(),D.lineJoin=D.lineCap="round",D.strokeStyle=X?Ft.panel:Ft.curves[l.labels[J.at(-1)]%Ft.curves.length],D.stroke()}}function N(D,O){D.strokeStyle=Ft.line,D.strokeRect(u.l,u.t,u.w,u.h),D.fillStyle=Ft.muted,D.textBaseline="middle",D.textAlign="right";let Z=(u.hi-u.lo)/ga,X=[5,10,15,30,45,90,180].find(nt=>Z/nt<=6)??180;for(let nt=Math.ceil(u.lo/ga/X-1e-9)*X;nt<=u.hi/ga+1e-6;nt+=X){let dt=m(nt*ga);D.fillText(mn(nt*ga,"angle",gt.angle==="deg"?0:2),u.l-.45*O,dt),D.globalAlpha=.5,D.beginPath(),D.moveTo(u.l,dt),D.lineTo(u.l+u.w,dt),D.lineWidth=1,D.stroke(),D.globalAlpha=1}D.textBaseline="top",D.textAlign="center";let J=u.t+u.h+.45*O;for(let nt of[0,.25,.5,.75,1])D.fillText(String(nt),g(nt),J);D.fillText("path, from 0 to 1",g(.5),J+1.15*O),D.save(),D.translate(.5*O,u.t+u.h/2),D.rotate(-Math.PI/2),D.textBaseline="middle",D.fillText(`turn of the tool, ${gt.symbol("angle")}`,0,0),D.restore()}let R=D=>h?.which===D?h.turn:D==="start"?l.turn[0]:l.turn.at(-1);function L(){o.forEach((D,O)=>{let Z=O?"end":"start",X=!!(l?.turn.length&&l.map);if(D.hidden=!X,!X)return;let J=R(Z);D.style.setProperty("left",`${g(O)}px`),D.style.setProperty("top",`${m(J)}px`),D.classList.toggle("pinned",d[Z]),D.setAttribute("aria-valuemin",mn(u.lo,"angle",0).replace("\u2212","-")),D.setAttribute("aria-valuemax",mn(u.hi,"angle",0).replace("\u2212","-")),D.setAttribute("aria-valuenow",mn(J,"angle").replace("\u2212","-")),D.setAttribute("aria-valuetext",`${re(J,"angle")}${d[Z]?", held":""}`)})}let z=D=>Math.min(Math.max(D,u.lo),u.hi);function G(D,O){h={which:D,turn:z(O)},L();let Z=B1(l.map,D==="start"?0:1,h.turn);r.hidden=!1,bt(r,`${re(h.turn,"angle",1)}: ${Z.length?Z.join("; "):"closed on every branch"}`),r.dataset.tone=Z.length?"":"wrong",r.style.setProperty("top",`${Math.min(Math.max(m(h.turn),u.t+12),u.t+u.h-12)}px`),r.classList.toggle("right",D==="end"),n(D,h.turn)}function F(){if(!h)return;let{which:D,turn:O}=h;r.hidden=!0,t(D,O)}o.forEach((D,O)=>{let Z=O?"end":"start";D.addEventListener("pointerdown",X=>{X.preventDefault(),D.focus(),D.setPointerCapture(X.pointerId);let J=R(Z)-x(X.clientY-a.getBoundingClientRect().top),nt=ft=>G(Z,x(ft.clientY-a.getBoundingClientRect().top)+J);D.addEventListener("pointermove",nt);let dt=()=>{D.removeEventListener("pointermove",nt),F()};D.addEventListener("pointerup",dt,{once:!0}),D.addEventListener("pointercancel",dt,{once:!0})}),D.addEventListener("keydown",X=>{let J={ArrowUp:1,ArrowRight:1,ArrowDown:-1,ArrowLeft:-1,PageUp:10,PageDown:-10}[X.key];if(J)G(Z,R(Z)+J*ga*(X.shiftKey?.1:1));else if(X.key==="Enter")F();else if(X.key==="Escape"&&h)U(),n(Z,null);else return;X.preventDefault(),X.stopPropagation()}),D.addEventListener("blur",()=>h?.which===Z&&F())}),i.addEventListener("pointerdown",D=>{if(!l?.q.length)return;let O=X=>e(Math.min(Math.max((X.clientX-a.getBoundingClientRect().left-u.l)/u.w,0),1));i.setPointerCapture(D.pointerId),O(D),i.addEventListener("pointermove",O);let Z=()=>i.removeEventListener("pointermove",O);i.addEventListener("pointerup",Z,{once:!0}),i.addEventListener("pointercancel",Z,{once:!0})});function U(){h=null,r.hidden=!0,l&&L()}return new ResizeObserver(tr(A)).observe(a),{el:a,paint(){l&&v(),A()},cancel:U,show(D,O=null,Z={start:!1,end:!1}){l=D,d=Z,h=null,r.hidden=!0,a.hidden=!D,D&&(c=O,v(),A())},only(D){c=D,A()},at(D){s.hidden=D===null||!u||!l?.q.length,s.hidden||(s.style.setProperty("left",`${g(D)}px`),s.style.setProperty("top",`${u.t}px`),s.style.setProperty("height",`${u.h}px`))},place(D,O=null){let Z=a.getBoundingClientRect();return[Z.x+g(D==="end"?1:0),Z.y+m(O??R(D))]}}}var G1=Math.PI/180;function V1(){let n=(p,y,g)=>ql({...p,start:null,end:null},y,g),t=(p,y,g)=>{let m=E("span",{class:"field-name"}),x=E("label",{class:"field"},m,g);return x.label=()=>{m.textContent=y==="plain"?p:`${p}, ${gt.symbol(y)}`},x},e=(p,y,g,m,x)=>{let w=wn({label:p,kind:y,testid:g,check:m,input:x});return{f:w,el:t(p,y,w)}},i=Be("How far the tool may turn",[["free","All the way round"],["within","Within"]],"free",p=>{n({turn:p==="free"?null:[-45*G1,45*G1]},"free the turn of the route"),f()},"route-turn"),s=[0,1].map(p=>e(p?"to":"from","angle",`route-turn-${p}`,y=>Math.abs(y)<=4*Math.PI?null:"at most two turns",y=>{let g=jr().turn?.slice()??[0,0];g[p]=y,n({turn:g},"bound the turn of the route",`route-turn-${p}`)})),r=Be("About which axis of the tool",["x","y","z"].map(p=>[p,p]),"z",p=>n({axis:p},"set the axis of the route"),"route-axis"),o=e("Axis may tilt by","angle","route-cone",p=>p>=0&&p<Math.PI/2?null:"from 0 to less than 90 degrees",p=>n({cone:p},"set the cone of the route","route-cone")),a=hn("What is cheapest",[["motion","least motion of the joints"],["time","least time"]],"motion",p=>n({cost:p},"set the cost of the route"),{"data-testid":"route-cost"}),l=e("Keep the singular values\u2019 ratio above","plain","route-singularity",p=>p>=0&&p<1?null:"from 0 to less than 1",p=>n({singularity:p},"keep the route from singular postures","route-singularity")),c=e("Keep from obstacles","length","route-clearance",p=>p>=0?null:"0 or more",p=>n({clearance:p},"keep the route from obstacles","route-clearance")),u=E("details",{class:"fold"},E("summary",{text:"More that is free, and what must be kept"}),E("div",{class:"line"},o.el),E("div",{class:"line"},E("label",{class:"field"},E("span",{class:"field-name",text:"Cheapest"}),a)),E("div",{class:"line"},l.el),E("div",{class:"line"},c.el)),h=E("div",{},E("div",{class:"line"},E("span",{class:"field-name",text:"Turn"}),i,...s.map(p=>p.el),E("span",{class:"field-name",text:"about the tool\u2019s"}),r),u),d=[...s,o,l,c];function f(){let p=jr();i.mark(p.turn?"within":"free"),s.forEach((y,g)=>{y.el.hidden=!p.turn,y.f.put(p.turn?.[g]??0)}),r.mark(p.axis),o.f.put(p.cone),a.value=p.cost,l.f.put(p.singularity),c.f.put(p.clearance),c.el.hidden=!b.world.some(y=>y.role!=="object"&&y.kind!=="frame"),d.forEach(y=>y.el.label())}return K(["units","world"],f),K("routing",p=>["undo","loaded"].includes(p)&&f()),f(),{el:h,show:f}}var W1=n=>({id:"route",title:"Route",wide:!0,build(t){let e=b.path,i=null,s=null,r=null,o=kp("route",()=>w()),a=V1(),l=(U,D,O,Z={})=>Ut(U,{"data-testid":D,...Z},O),c=l("Let both ends free","free-ends",()=>{ql({start:null,end:null},"let the ends of the route free"),p.ask()}),u=l("Send to the program","route-to-program",z,{hidden:!0}),h=l("","route-others",L,{hidden:!0}),d=Yr("route-verdict"),f={roots:()=>[t,ls(),Np()],about:()=>[Cs(),e.from,e.to,e.n,b.routing,b.world]},p=Po({text:"Find the route",working:"Looking \u2026",testid:"find-route",verdict:d,...f,async ask(){let[U,D]=jr().turn??[0,0];if(U>D)throw new Error(`The turn must have its lower end first; it goes from ${re(U,"angle")} to ${re(D,"angle")}.`);try{return await Oe("route",Vp())}catch(O){throw m.cancel(),O}},show:v,forget:()=>F()}),y=E("div",{class:"chips",role:"group","aria-label":"Branches on the map"}),g=E("div",{class:"branches","data-testid":"route-list"}),m=H1({drag:(U,D)=>D===null?gs(null):N(U,D),drop:(U,D)=>R(U,D),scrub:U=>r&&b.motion===r&&Xr(S(U))}),x=E("details",{class:"fold",open:!0},E("summary",{text:"The line"}),o.el);m.el.hidden=!0,c.hidden=!0,t.append(E("p",{class:"hint",text:"The line of Path, with the tool free to turn about its own axis on the way. The map shows every turn at every place of the line and which branch is open there; drag the ends of the curve."}),x,a.el,E("div",{class:"line"},p,c,u),m.el,y,d,E("div",{class:"line"},h),g);let w=()=>{e.from&&e.to&&!i&&ia(Array.from({length:33},(U,D)=>te(Cf(e.from,e.to,D/32))))};function v(U){let D=jr();if(i=b.route={...U,turn:A(U,D),asked:[e.from,e.to]},s=U.found?U.branches[U.labels[0]]:null,U.found&&(x.open=!1),d.say(U.text,U.found?"good":U.verdict==="IMPOSSIBLE"?"wrong":"note"),m.show(i,s,{start:!!D.start,end:!!D.end}),gs(null),c.hidden=!(D.start||D.end),u.hidden=!U.found,h.hidden=!1,bt(h,U.found?"Routes that begin with other postures":"What would let it through?"),Gt(g),_(),ia(U.points),!U.found){r=null,ci(null);return}let O=U.q.length;r=fr({table:b.table,q:U.q,xs:U.q.map((Z,X)=>X+1),xName:"point",xEnd:O,seconds:U.s.map(Z=>e.seconds*Z),title:`${b.table.name}: route, ${O} points`}),ci(r)}function A(U,D){if(!U.found||!U.map||!Xl(U.map))return U.turn;let O=D.start?D.start.turn-U.turn[0]:D.end?D.end.turn-U.turn.at(-1):0;return U.turn.map(Z=>Z+2*Math.PI*Math.round(O/(2*Math.PI)))}let S=U=>i.s.reduce((D,O,Z)=>Math.abs(O-U)<Math.abs(i.s[D]-U)?Z:D,0);function _(){Gt(y,i.branches.map((U,D)=>{let O=E("span",{class:"swatch"});return O.style.setProperty("background",Ft.curves[D%Ft.curves.length]),E("button",{type:"button",class:"chip","aria-pressed":String(s===U),title:s===U?"Show all branches":"Show this branch alone","data-testid":`route-branch-${D+1}`,on:{click:()=>{s=s===U?null:U,m.only(s),_()}}},O,U)}))}let M=(U,D)=>{let O=U==="start",Z=O?0:i.q.length-1;return{T:O?e.from:e.to,turn:D,free:Wx(),near:i.q[Z],branch:i.branches[i.labels[Z]]}},N=Qs(async(U,D)=>{let O=await Oe("route_posture",M(U,D)).catch(()=>null);gs(O?.q??null)});async function R(U,D){try{let O=await Oe("route_posture",M(U,D));if(!O.q)throw new Error(`The route cannot ${U} there. ${O.why}`);ql({[U]:{turn:D,q:O.q,branch:O.label}},`turn the ${U} of the route to ${re(D,"angle",1)}`),await p.ask()}catch(O){gs(null),m.cancel(),de(O.message,"wrong")}}async function L(){h.disabled=!0,bt(h,"Looking \u2026");try{let U=await Up(f,()=>Oe("route_others",Vp()));if(U.stopped)return;let D=O=>`cost ${Number(O.toPrecision(3))}`;Gt(g,U.relaxations.map(O=>E("p",{class:"verdict","data-tone":"note",text:O})),U.alternatives.map((O,Z)=>E("button",{type:"button",class:"branch","data-testid":`route-other-${Z+1}`,on:{click:async()=>{ql({start:{turn:O.turn,q:O.q,branch:O.branch},end:null},`begin the route ${O.branch}`),await p.ask()}}},E("span",{class:"branch-name",text:O.branch}),E("span",{class:"hint",text:`begins turned ${re(O.turn,"angle",1)}`}),E("span",{class:"branch-end",text:D(O.cost)}))),U.relaxations.length+U.alternatives.length?null:E("p",{class:"hint",text:i?.found?"There is no other.":"No single change that was tried lets a route through."})),h.hidden=!0}catch(U){d.say(U.message)}finally{h.disabled=!1,i&&bt(h,i.found?"Routes that begin with other postures":"What would let it through?")}}async function z(){u.disabled=!0;try{let U=await Up(f,()=>Oe("route_program",Vp()));if(U.stopped)return;let D=!b.program.length,O=D?U.steps.slice(1):U.steps;D&&(b.start=U.steps[0].q),pa([...b.program,...O],"send the route to the program");let Z=`${re(U.metres,"length",3)} and ${re(U.radians,"angle",3)}`;de(`Sent as a spline through ${U.poses} poses; it strays by at most ${Z}.`),n()?.("program")}catch(U){d.say(U.message)}finally{u.disabled=!1}}let G=()=>{b.routing&&(b.routing={...b.routing,start:null,end:null})};function F(){i=b.route=null,qr(r),d.say(""),m.show(null),x.open=!0,u.hidden=h.hidden=c.hidden=!0,Gt(y),Gt(g),gs(null)}K("panel",U=>{if(U!=="route")return;let D=()=>b.frames.at(-1).slice();e.from??=D(),e.to??=D(),o.show(),w(),i&&m.paint()}),K("played",()=>{!r||b.motion!==r?m.at(null):m.at(i.s[OS()]??null)}),K("motion",()=>b.motion!==r&&m.at(null)),K("theme",()=>{m.paint(),i&&_()}),K("units",()=>m.paint()),K("routing",U=>{U==="undo"&&i&&p.ask()}),K(["path","path-loaded"],()=>{!i||i.asked[0]===e.from&&i.asked[1]===e.to||(G(),F())}),K("table",U=>{["postures","name","gripper"].includes(U)||(U!=="undo"&&G(),F())}),m.el.addEventListener("where",U=>Object.assign(U.detail,{at:m.place(U.detail.which,U.detail.turn)}))}});function $1(n){let t=u=>`edit step ${u+1}`,e=(u,h,d)=>ma(u,h,t(u),{key:`step-${u}-${d}`});function i(u,h,d,f){let p=wn({label:`Step ${u+1}, ${d}`,testid:`step-${u+1}-${h}`,...f,input:y=>{n(()=>e(u,{[h]:y},h))}});return p.put(b.program[u][h]??null),E("label",{class:"field"},E("span",{class:"field-name",text:f.unit?`${d}, ${f.unit}`:d}),p)}let s=(u,h)=>{let d=b.program[u];return d.kind==="spline"?{T:h,through:[...d.through.slice(0,-1),h]}:{T:h}},r=(u,h,d)=>Number.isInteger(u)&&u>=h&&u<=d,o=u=>(h,d)=>Ws(d,`step-${u+1}-${h}`,()=>b.program[u]?.[h],f=>{let p=b.program[u].kind==="frame"?{}:{q:null};n(()=>e(u,h==="T"?{...s(u,f),...p}:{[h]:f},h))}).el;function a(u,h){let d=Be("A circle by",[["via","a pose on it"],["centre","its centre"]],u.centre?"centre":"via",y=>ma(h,y==="centre"?{centre:te(u.via??u.T),long_way:!1}:{centre:null,via:u.via??u.T},t(h)),`step-${h+1}-by`);if(!u.centre)return E("div",{},E("div",{class:"line"},d),o(h)("via","Over"));let f=["X","Y","Z"].map((y,g)=>{let m=wn({label:`Step ${h+1}, centre ${y}`,kind:"length",testid:`step-${h+1}-centre-${g}`,input:x=>{let w=b.program[h].centre.slice();w[g]=x,n(()=>e(h,{centre:w},"centre"))}});return m.put(u.centre[g]),E("label",{class:"field"},E("span",{class:"field-name",text:y}),m)}),p=E("input",{type:"checkbox",checked:!!u.long_way,"data-testid":`step-${h+1}-far`,on:{change:()=>e(h,{long_way:p.checked},"far")}});return E("div",{},E("div",{class:"line"},d),E("div",{class:"line"},...f,E("span",{class:"unit",text:gt.length})),E("label",{class:"check"},p,"the longer way round"))}function l(u,h){let d=f=>ma(h,{through:f,T:f.at(-1)},t(h));return E("div",{class:"line"},E("span",{class:"field-name",text:u.through.length===1?"Goes to its target alone; add poses for it to go through":`Goes through ${u.through.length} poses, the last one its target`}),Ut("Add the present pose",{class:"quiet","data-testid":`step-${h+1}-through`},()=>d([...u.through,Vu(h)])),Ut("Take the last one out",{class:"quiet",disabled:u.through.length<2},()=>d(u.through.slice(0,-1))))}function c(u,h){return u.kind==="wait"?E("div",{class:"line step-editor"},i(h,"seconds","seconds",{check:d=>d>=0?null:"0 or more"})):u.kind==="gripper"?E("div",{class:"line step-editor"},i(h,"value","value",{check:d=>d>=0&&d<=1?null:"from 0, open, to 1, closed"})):u.kind==="call"?E("div",{class:"line step-editor"},i(h,"first","from step",{check:d=>r(d,1,h)?null:`from 1 to ${h}`}),i(h,"last","to step",{check:d=>r(d,u.first,h)?null:`from ${u.first} to ${h}`}),i(h,"times","times",{check:d=>r(d,1,50)?null:"a whole number from 1 to 50"})):u.kind==="frame"?E("div",{class:"step-editor"},o(h)("T","The frame, in the base"),E("div",{class:"line"},Ut("Take the present pose",{class:"quiet","data-testid":`step-${h+1}-teach`},()=>ma(h,{T:b.frames.at(-1).slice()},`teach step ${h+1}`)),Ut("The base",{class:"quiet",title:"The poses that follow are meant in the base again"},()=>ma(h,{T:Ji()},`end the frame at step ${h+1}`)))):u.kind==="output"?E("div",{class:"line step-editor"},i(h,"port","port",{check:d=>Number.isInteger(d)&&d>=0?null:"a whole number from 0"}),E("label",{class:"check"},E("input",{type:"checkbox",checked:u.value,on:{change:d=>e(h,{value:d.target.checked},"value")}}),"on")):E("div",{class:"step-editor"},E("div",{class:"line"},hn("Kind of move",[["joint","Joints"],["line","Line"],["circle","Circle"],["spline","Spline"]],u.kind,d=>e(h,{kind:d,q:d==="joint"?u.q??null:null,speed:null,...d==="circle"&&!u.via?{via:u.T}:{},...d==="spline"?{through:u.through??[...u.via?[u.via]:[],u.T]}:{}},"kind"),{"data-testid":`step-${h+1}-kind`}),i(h,"blend","blend",{kind:"length",unit:gt.length,check:d=>d>=0?null:"0 or more"}),u.kind==="joint"?i(h,"speed","part of the speed",{empty:null,check:d=>d===null||d>0&&d<=1?null:"above 0 to 1"}):i(h,"speed","speed",{kind:"length",unit:`${gt.length}/s`,empty:null,check:d=>d===null||d>0?null:"more than 0"})),u.kind==="circle"?a(u,h):null,u.kind==="spline"?l(u,h):null,o(h)("T",u.q?"To (a taught posture; typing makes it a pose)":"To"),E("div",{class:"line"},Ut("Take the present pose",{class:"quiet","data-testid":`step-${h+1}-teach`},()=>ma(h,{...s(h,Vu(h)),q:u.kind==="joint"?b.q.slice():null},`teach step ${h+1}`)),u.q?Ut("Go there",{class:"quiet"},()=>Ii(u.q.slice(),.8,`go to step ${h+1}`)):null))}return c}function q1(){let n=E("div",{class:"line limits-of"}),t=i=>i==="undo"?e():$i(n,e),e=()=>{let i=new Set(b.table.joints.map(o=>o.type)),s=(o,a,l,c,u)=>{let h=wn({label:a,kind:l,empty:u,testid:`limit-${o}`,check:d=>d===null||d>0?null:"more than 0",input:d=>O1({[o]:d},`limit the ${a.toLowerCase()}`)});return h.put(Hp()[o]),u===null&&(h.placeholder="none"),E("label",{class:"field"},E("span",{class:"field-name",text:`${a}, ${gt.symbol(l)}${c}`}),h)},r=(o,a,l)=>[s(`${a}_speed`,`${l}speed`,o,"/s"),s(`${a}_acceleration`,`${l}acceleration`,o,"/s\xB2"),s(`${a}_jerk`,`${l}jerk`,o,"/s\xB3",null)];Gt(n,i.has("R")?r("angle","turn","Joint "):null,i.has("P")?r("length","slide","Slide "):null,s("tool_speed","Tool speed","length","/s",null))};return K(["table","units"],t),K("program",i=>i!=="limits"&&t(i)),t(),n}var Wp={joint:"Joints to",line:"Line to",circle:"Circle to",wait:"Wait",gripper:"Gripper",output:"Output",spline:"Spline to",frame:"Work frame",call:"Again"};function qx(n){return n.kind==="wait"?`${n.seconds} s`:n.kind==="gripper"?n.value===0?"open":n.value===1?"closed":`${n.value}`:n.kind==="call"?`${n.first===n.last?`step ${n.first}`:`steps ${n.first} to ${n.last}`}${n.times>1?`, ${n.times} times`:""}`:n.kind==="output"?`${n.port} ${n.value?"on":"off"}`:n.kind==="joint"&&n.q?n.q.map((t,e)=>mn(t,Ze(b.table.joints[e]??{type:"R"}),1)).join(", "):`${te(n.T).map(t=>mn(t,"length",1)).join(", ")} ${gt.length}${n.kind==="spline"?`, ${n.through.length} ${n.through.length===1?"pose":"poses"}`:""}`}var X1=200,$N=[["rapid","ABB RAPID"],["urscript","URScript"],["krl","KUKA KRL"],["fanuc-ls","Fanuc LS"],["inform","Yaskawa INFORM"],["pacscript","Denso PacScript"],["ros","ROS trajectory"],["csv","CSV of the motion"]],Yl=()=>Vu($p()),$p=()=>b.program.length,Y1={id:"program",title:"Program",wide:!0,build(n){let t=-1,e=null,i=null,s=-1,r=E("ol",{class:"steps","data-testid":"program","aria-label":"Steps of the program"}),o=Yr("program-verdict"),a=Yr("save-verdict"),l=E("details",{class:"fold",hidden:!0},E("summary",{text:"What binds, and when"}),E("p",{class:"hint prose"})),c=(R,L,z,G)=>Ut(L,{title:z,"data-testid":`step-add-${R}`},()=>g(G())),u=Po({text:"Run the program",working:"Planning \u2026",testid:"run-program",verdict:o,roots:()=>[n,ls(),Np()],about:()=>[Cs(),b.program,b.limits,b.start,b.world],open:()=>b.program.length>0,ask:()=>Oe("program",{...Lo(),world:b.world}),show:M,forget:()=>{qr(i),l.hidden=!0}}),h=E("span",{class:"hint","data-testid":"program-start"}),d="rapid";n.append(E("div",{class:"line"},c("joint","+ Joints","All joints to the present posture",()=>({kind:"joint",q:b.q.slice(),T:Yl(),blend:0})),c("line","+ Line","The tool on a straight line to the present pose",()=>({kind:"line",T:Yl(),blend:0})),c("circle","+ Circle","Over a point on the way to the present pose; both can be typed",()=>({kind:"circle",via:f(),T:Yl(),blend:0})),c("spline","+ Spline","A smooth curve through taught poses, the first of them the present one",()=>({kind:"spline",through:[Yl()],T:Yl(),blend:0})),c("gripper","+ Gripper","From 0, open, to 1, closed",()=>({kind:"gripper",value:p()>.5?0:1})),c("wait","+ Wait","The arm rests",()=>({kind:"wait",seconds:.5})),c("output","+ Output","A digital output",()=>({kind:"output",port:1,value:!0})),c("frame","+ Frame","The poses that follow are meant in this frame, at first the present pose",()=>({kind:"frame",T:b.frames.at(-1).slice()})),c("call","+ Again","Earlier steps once more, in the frame that holds here",()=>({kind:"call",first:1,last:Math.max($p(),1),times:1}))),E("div",{class:"line spread"},h,E("span",{class:"line"},Ut("Start here",{class:"quiet","data-testid":"start-here",title:"The program begins in the present posture"},()=>F1(b.q.slice())),Ut("Go to the start",{class:"quiet"},()=>Ii(Gp().slice(),.8,"go to the start")))),r,q1(),E("div",{class:"line"},u,E("span",{class:"line"},hn("Language of the file",$N,d,R=>{d=R,a.say("")},{"data-testid":"dialect"}),Ut("Save the program",{"data-testid":"save-program"},N))),a,o,l),$p=()=>t>=0?t+1:b.program.length;let f=()=>b.program.slice(0,$p()).findLast(R=>R.T&&R.kind!=="frame")?.T??Yl(),p=()=>b.program.findLast(R=>R.kind==="gripper")?.value??0;function y(){let R=Sr(r);return R&&de(`${R} Escape puts back what was there.`,"wrong"),!!R}function g(R){if(y())return;if(b.program.length>=X1){de(`At most ${X1} steps.`,"wrong");return}let L=t>=0?t+1:b.program.length;t=L;let z=zp(b.program,b.program.map((G,F)=>F<L?F:F+1));if(R.kind==="call"&&!L){de("There is no step before it that could be done again.","wrong"),t=-1;return}pa([...z.slice(0,L),R,...z.slice(L)],`add a step: ${Wp[R.kind].toLowerCase()}`)}function m(R,L){if(L<0||L>=b.program.length||R===L||y())return;let z=b.program.map((F,U)=>U);z.splice(L,0,...z.splice(R,1));let G=zp(b.program,b.program.map((F,U)=>z.indexOf(U)));t=L,pa(G,`move step ${R+1} to ${L+1}`),r.children[L]?.querySelector(".step-name")?.focus()}function x(R){R!==t&&y()||(t=-1,pa(zp(b.program,b.program.map((L,z)=>z===R?-1:z<R?z:z-1)),`remove step ${R+1}`))}function w(R,L){let z=L===t,G=e?.step===L?e.text:U1(R,L),F=E("button",{type:"button",class:"step-name quiet","aria-expanded":String(z),"data-testid":`step-${L+1}`,title:"Press to edit; Alt and an arrow moves it",on:{click:()=>{y()||(t=z?-1:L,S())},keydown:D=>{let O={ArrowUp:-1,ArrowDown:1}[D.key];O&&D.altKey?(D.preventDefault(),m(L,L+O)):O?(D.preventDefault(),r.children[L+O]?.querySelector(".step-name")?.focus()):D.key==="Delete"&&x(L)}}},E("b",{text:Wp[R.kind]}),` ${qx(R)}`,R.blend?E("span",{class:"hint",text:`, blend ${re(R.blend,"length",0)}`}):null),U=E("li",{class:`step${G?" failed":""}${z?" open":""}`,draggable:"true","data-testid":`step-row-${L+1}`},E("div",{class:"step-line"},E("span",{class:"grip","aria-hidden":"true",text:"\u283F"}),E("span",{class:"hint",text:String(L+1)}),F,Io({k:L,n:b.program.length,name:`step ${L+1}`,move:m,remove:x})),G?E("p",{class:"reason",text:G}):null,z?A(R,L):null);return U.addEventListener("dragstart",D=>{s=L,D.dataTransfer.effectAllowed="move",D.dataTransfer.setData("text/plain",String(L))}),U.addEventListener("dragover",D=>{s<0||(D.preventDefault(),U.classList.add("target"))}),U.addEventListener("dragleave",()=>U.classList.remove("target")),U.addEventListener("drop",D=>{D.preventDefault();let O=s;s=-1,O>=0&&m(O,L)}),U}let v=!1,A=$1(R=>{v=!0,R(),v=!1}),S=R=>R==="undo"?_():$i(r,_);function _(){if(v){b.program.forEach((L,z)=>{let G=r.children[z]?.querySelector(".step-name");G&&Gt(G,E("b",{text:Wp[L.kind]}),document.createTextNode(` ${qx(L)}`))});return}t>=b.program.length&&(t=-1),Gt(r,b.program.map(w)),b.program.length||r.append(E("li",{class:"hint empty",text:"No steps yet. Move the arm and teach it: Joints or Line takes where it stands; every pose can be typed afterwards."})),u.show();let R=Gp();bt(h,b.program.length?`Starts at ${R.map((L,z)=>mn(L,Ze(b.table.joints[z]),1)).join(", ")}`:"")}function M(R){if(e=R.failed,e&&(t=e.step),o.say(e?`S${e.name.slice(1)} cannot be done: ${e.text}${R.duration>0?`
Shown is what comes before it.`:""}`:[R.explain,R.clear?.text].filter(Boolean).join(`
`),e||R.clear?.verdict==="HIT"?"wrong":R.clear?.verdict==="UNCERTAIN"?"note":"good"),l.hidden=!R.tight.length,bt(l.lastChild,R.tight.map(z=>z.text).join(`
`)),S(),!(R.duration>0)){ci(null);return}let L=R.events.map(([z,G,F])=>({x:z,s:0,text:`${G} ${F} at ${z.toFixed(2)} s`,short:G==="gripper"?F>.5?"close":"open":G,stop:!1}));i=fr({table:b.table,q:R.q,xs:R.t,xName:"time",seconds:R.t,dq:R.dq,ddq:R.ddq,events:L,title:`${b.table.name}: program, ${R.duration.toFixed(2)} s`,happens:R.events,tight:R.tight,limits:Lo().limits}),ci(i)}async function N(){let R=Sr(n,ls());if(R){a.say(`${R} Nothing was written.`);return}a.say("");try{let L="program",{text:z,name:G}=await Oe("program_file",{...Lo(),dialect:d,name:L});hi(G,z)}catch(L){a.say(L.message)}}K(["program","units","table"],R=>{a.say(""),R!=="limits"&&(e=null,S(R))}),S()}};var xa=new Rn,Yx=new bl,qN=new ye,XN=n=>new Vn({color:n,vertexColors:!0,transparent:!0,opacity:.86,fog:!1});function Xx(n){let t=n.attributes.normal,e=new Float32Array(3*t.count);for(let i=0;i<t.count;i++)e.fill(.72+.2*t.getZ(i)+.08*(t.getX(i)*.6-t.getY(i)*.8),3*i,3*i+3);return n.setAttribute("color",new He(e,3)),n}var j1=n=>n.rotateX(Math.PI/2),qp={box:n=>[Xx(new Hi(...n.size)),n.T],cylinder:n=>[Xx(j1(new Ci(n.r,n.r,n.h,40))),n.T],capsule(n){let t=new V(...n.a),e=new V(...n.b).sub(t),i=e.length(),s=new ye().makeRotationFromQuaternion(new fn().setFromUnitVectors(new V(0,0,1),i?e.clone().normalize():new V(0,0,1)));return s.setPosition(t.addScaledVector(e,.5)),[Xx(j1(new Xo(n.r,i,12,28))),s.clone().transpose().elements.slice()]}};function jx(n,t,e=.86){if(!qp[n.kind])return null;let[i,s]=qp[n.kind](n),r=XN(t);r.opacity=e,r.depthWrite=e>.5;let o=new Ge(i,r);return o.matrixAutoUpdate=!1,{mesh:o,T:s}}var J1=()=>[...b.world,...b.things??[]],K1=n=>{let t=jl.get(n.name)??n.T;return t?te(t):n.a.map((e,i)=>(e+n.b[i])/2)},YN=n=>K1(n).map((t,e)=>t+(e===2?1:0));function jN(n){if(n.kind==="curve")return n.points.filter((i,s)=>s%20===0||s===n.points.length-1);if(n.kind==="capsule")return[n.a,n.b];if(!n.T)return[];let t=te(n.T),e=n.kind==="box"?n.size.map(i=>i/2):n.kind==="cylinder"?[n.r,n.r,n.h/2]:[0,0,0];return[-1,1].flatMap(i=>[0,1,2].map(s=>t.map((r,o)=>r+i*e[s]*Ks(n.T,s)[o])))}function Q1(){en.add(xa,Yx.group),K(["world","table"],Z1),K("theme",Z1)}var jl=new Map;function Zx(n,t){if(t)jl.set(n,t);else if(!jl.delete(n))return;let e=xa.children.find(s=>s.userData.name===n),i=b.world.find(s=>s.name===n);e&&i&&e.matrix.set(...t??i.T),nE()}var tE=n=>jl.get(n)??null;function eE(){for(let n of[...jl.keys()])Zx(n,null)}function nE(){let n=J1();Yx.show(n.filter(t=>t.kind==="frame"),.11*Gn(b.table),n.filter(t=>qp[t.kind]).map(t=>({text:t.name,at:K1(t),wish:YN(t)})))}function Z1(){for(let t of xa.children)t.geometry.dispose();xa.clear();let n=J1();for(let t of n)if(t.kind==="curve"){let e=new we().setFromPoints(t.points.map(i=>new V(...i)));xa.add(new rr(e,new es({color:Ft.trace,fog:!1})))}else if(qp[t.kind]){let{mesh:e,T:i}=jx(t,t.role==="object"?Ft.accent:Ft.ghost);e.matrix.copy(qN.set(...jl.get(t.name)??i)),e.userData.name=t.name,xa.add(e)}nE(),Gr("world",n.flatMap(jN)),ue()}var iE=()=>xa.children.length+(Yx.last?.[0].length??0);var Jl=new rr(new we,new es({depthTest:!1,fog:!1})),Kl=new Nr(new we,new or({size:9,sizeAttenuation:!1,depthTest:!1,fog:!1}));Jl.renderOrder=Kl.renderOrder=6;Jl.frustumCulled=Kl.frustumCulled=!1;Jl.visible=Kl.visible=!1;var Zl=new Rn,Wu=null,sE="",oE=()=>b.watch||b.world.some(n=>n.role==="obstacle"&&n.kind!=="frame"),Xp=io(n=>n&&Jx({waiting:!0}));function Jx(n){b.clearance=n,aE(),lt("clearance")}var JN=Qs(async()=>{let{q:n,world:t}=b,e=()=>n===b.q&&t===b.world,i;try{i=await Oe("clearance",{q:n,world:t})}catch(s){if(fc(s))return;i={refused:s.message}}!oE()||!e()&&Xp.late()||(Xp(!e()),Jx(i))});function rE(){oE()&&b.table.joints.length?(Xp(!0),JN()):(Xp(!1),b.clearance&&Jx(null))}function aE(){let n=b.clearance,t=!!n?.points?.length;if(Jl.visible=Kl.visible=t,t){let e=n.points.map(i=>new V(...i));for(let i of[Jl,Kl])i.geometry.setFromPoints(e),i.material.color.set(n.metres>0?Ft.trace:Ft.wrong)}ue()}async function Kx(n){if(Wu=null,n){let{bodies:t,explain:e}=await Oe("bodies",{});Wu=t,sE=e}for(let t of Zl.children)t.geometry.dispose();Zl.clear();for(let t of Wu??[]){let e=jx(t,Ft.trace,.34);e&&(e.mesh.userData={on:t.on,T:e.T},Zl.add(e.mesh))}return cE(),sE}var lE=()=>Zl.children.length,KN=new ye;function cE(){for(let n of Zl.children){let{on:t,T:e}=n.userData;b.frames[t]&&n.matrix.copy(KN.set(...Hn(b.frames[t],e)))}ue()}function uE(){en.add(Jl,Kl,Zl),K(["q","world","watch"],rE),K("plan",rE),K("q",()=>Wu&&cE()),K("table",()=>Wu&&Kx(!1).then(()=>lt("bodies-gone"))),K("theme",aE)}var tU=60,eU={box:"Box",cylinder:"Cylinder",frame:"Frame"},nU={box:["x","y","z"],cylinder:["radius","height"],frame:[]};function Qx(n,t,e={}){lt("did",{label:t,...e}),b.world=n,lt("world")}var Yp=(n,t,e)=>Qx(b.world.map((i,s)=>s===n?{...i,...t}:i),e,{key:`world-${n}-${Object.keys(t)[0]}`});function iU(n,t){let e=t.value.trim(),i=b.world[n].name,s=b.world.some((r,o)=>o!==n&&r.name===e);if(e&&!s){e!==i&&Yp(n,{name:e},`name ${e}`);return}t.value=i,de(s?`There is a ${e} already; the name stays ${i}.`:`A thing needs a name; it stays ${i}.`,"wrong")}function sU(n,t){if(b.world.length>=tU)return;let e=te(b.frames.at(-1)),i=.06*Gn(b.table),s=c=>Math.round(c*1e3)/1e3||.001,r=[1,0,0,s(e[0]),0,1,0,s(e[1]),0,0,1,s(n==="frame"?e[2]:i/2),0,0,0,1];r[7]+=1.5*i*b.world.length;let o=t==="object"?"object":n,a=1;for(;b.world.some(c=>c.name===`${o} ${a}`);)a+=1;let l=n==="box"?{size:[s(i),s(i),s(i)]}:n==="cylinder"?{r:s(i/2),h:s(i)}:{};Qx([...b.world,{kind:n,role:t,name:`${o} ${a}`,T:r,...l}],`add ${o} ${a}`)}var hE={id:"world",title:"World",wide:!0,build(n){let t=E("p",{class:"verdict",role:"status","data-testid":"clearance",hidden:!0}),e=E("p",{class:"hint prose"}),i=E("input",{type:"checkbox","data-testid":"watch",on:{change:()=>{b.watch=i.checked,lt("watch")}}}),s=E("input",{type:"checkbox","data-testid":"show-bodies",on:{change:async()=>{try{let d=await Kx(s.checked);bt(e,s.checked?d:"")}catch(d){bt(e,d.message)}}}}),r=E("div",{class:"things","data-testid":"world"}),o=(d,f,p,y)=>Ut(d,{title:y,"data-testid":`add-${p}-${f}`},()=>sU(f,p));n.append(E("div",{class:"line"},o("+ Object","box","object","A box that the gripper can take"),o("+ Box","box","obstacle","A table, a wall"),o("+ Cylinder","cylinder","obstacle","A post, a can"),o("+ Frame","frame","obstacle","A place with a name")),E("p",{class:"hint",text:"An object is taken by a gripper that closes with the tool\u2019s point at it, and goes with the tool until it opens."}),E("div",{class:"line"},E("label",{class:"check"},i,"Distance, always"),E("label",{class:"check"},s,"Bodies it is measured of")),t,e,r),K(["clearance","units"],()=>{let d=b.clearance;if(t.hidden=!d,!d)return;if(d.waiting){t.dataset.tone="note",bt(t,"Measuring the distance \u2026");return}t.dataset.tone=d.refused||d.metres<=0?"wrong":"good";let[f,p]=d.pair??[];bt(t,d.refused??(d.metres===null?"There is nothing that could be touched.":d.metres>0?`Nearest: ${f} and ${p}, ${re(d.metres,"length")} apart.`:`${f} and ${p} overlap by ${re(-d.metres,"length")}.`))}),K("bodies-gone",()=>{s.checked=!1,bt(e,"")});let l=!1,c=d=>{l||d==="python"||(d==="undo"?u():$i(r,u))},u=()=>{let d=E("p",{class:"hint",text:"Nothing stands around the arm yet."});Gt(r,b.world.length?b.world.map(h):d)};function h(d,f){let p=x=>(...w)=>{l=!0,x(...w),l=!1},y=E("input",{type:"text",value:d.name,maxlength:"40","aria-label":`Name of ${d.name}`,on:{change:()=>iU(f,y)}}),g=nU[d.kind].map((x,w)=>{let v=wn({label:`${d.name}, ${x}`,kind:"length",testid:`world-${f+1}-size-${w}`,key:`${d.name}/${x}`,check:A=>A>0?null:"more than 0",input:p(A=>{let S=b.world[f],_=d.kind==="box"?{size:S.size.map((M,N)=>N===w?A:M)}:{[w?"h":"r"]:A};Yp(f,_,`size of ${d.name}`)})});return v.put(d.kind==="box"?d.size[w]:w?d.h:d.r),E("label",{class:"field"},E("span",{class:"field-name",text:`${x}, ${gt.length}`}),v)}),m=Ws(d.kind==="frame"?`Place of ${d.name}`:`Place of the middle of ${d.name}`,`world-${f+1}`,()=>b.world[f]?.T,p(x=>Yp(f,{T:x},`move ${d.name}`)),d.name);return E("section",{class:"thing","aria-label":d.name,"data-testid":`thing-${f+1}`},E("div",{class:"line spread"},E("span",{class:"line"},y,E("span",{class:"hint",text:eU[d.kind]}),d.kind==="frame"?null:hn(`What ${d.name} is`,[["object","object"],["obstacle","obstacle"]],d.role,x=>Yp(f,{role:x},`make ${d.name} an ${x}`))),Io({k:f,name:d.name,remove:()=>Qx(b.world.filter((x,w)=>w!==f),`remove ${d.name}`)})),g.length?E("div",{class:"line"},g):null,m.el)}K(["world","units"],c),c()}};var rU=40,dE={id:"sequence",title:"Sequence",wide:!0,build(n){let t={get postures(){return b.sequence.postures},set postures(x){b.sequence.postures=x},get rate(){return b.sequence.rate}},e=null,i=E("thead"),s=E("tbody"),r=Yr("sequence-verdict"),o=Po({text:"Run the sequence",working:"Planning \u2026",testid:"run-sequence",verdict:r,roots:()=>[n,ls()],about:()=>[Cs(),JSON.stringify(t.postures)],open:()=>t.postures.length>1,ask:()=>Oe("motion",g()),show:m,forget:()=>qr(e)}),a=Ut("Same times for all legs",{class:"quiet",title:"Copy the first leg\u2019s time and rest to the others"},()=>{let x=t.postures[1];if(x){lt("did",{label:"use the same times for all legs"});for(let w of t.postures.slice(2))w.seconds=x.seconds,w.hold=x.hold;p()}});n.append(E("p",{class:"hint",text:"Each leg is a quintic in time: all joints start and arrive together, at rest in every posture. After a leg the arm rests."}),E("div",{class:"scroll"},E("table",{class:"dh sequence","data-testid":"sequence","aria-label":"Postures of the sequence"},i,s)),E("div",{class:"line"},Ut("+ Present posture",{class:"add","data-testid":"add-posture"},()=>l(b.q.slice())),Ut("+ All named postures",{},()=>Ru("add all named postures",()=>Object.entries(b.table.postures??{}).forEach(([x,w])=>l(w.slice(),x)))),a),E("div",{class:"line"},o),r);function l(x,w){t.postures.length>=rU||(lt("did",{label:"add a posture to the sequence"}),t.postures.push({name:w??`P${t.postures.length}`,q:x,seconds:5,hold:0}),p(),lt("sequence"))}function c(x,w){lt("did",{label:`move ${t.postures[x].name} ${w<x?"up":"down"}`}),t.postures.splice(w,0,...t.postures.splice(x,1)),p(),lt("sequence")}function u(x){lt("did",{label:`remove ${t.postures[x].name}`}),t.postures.splice(x,1),p(),lt("sequence")}let h=new WeakMap,d=0,f=x=>h.get(x)??h.set(x,d+=1).get(x),p=()=>$i(s,y);function y(){let x=b.table.joints;t.postures=t.postures.filter(w=>w.q.length===x.length),o.show(),Gt(i,E("tr",{},E("td"),x.map((w,v)=>E("th",{},E("i",{text:"q"}),E("sub",{text:String(v+1)}),E("span",{class:"unit",text:` ${gt.symbol(Ze(w))}`}))),E("th",{text:"leg, s"}),E("th",{text:"rest, s"}),E("td"))),Gt(s,t.postures.map((w,v)=>{let A=x.map((_,M)=>{let N=wn({label:`${w.name}, q${M+1}`,kind:Ze(_),testid:`seq-${v}-q${M+1}`,key:`${f(w)}-q${M+1}`,input:R=>{lt("did",{label:`edit ${w.name} of the sequence`,key:`seq-${v}-${M}`}),w.q[M]=R,lt("sequence")}});return N.put(w.q[M],String(Number((w.q[M]*gt.factor(Ze(_))).toFixed(gt.digits(Ze(_))))+0)),E("td",{},N)}),S=(_,M,N)=>{if(v===0)return E("td");let R=wn({label:`${M} ${w.name}`,testid:`seq-${v}-${_}`,key:`${f(w)}-${_}`,check:N,input:L=>{lt("did",{label:`edit ${w.name} of the sequence`,key:`seq-${v}-${_}`}),w[_]=L,lt("sequence")}});return R.put(w[_]),E("td",{},R)};return E("tr",{"data-testid":`seq-row-${v}`},E("th",{scope:"row"},Ut(w.name,{class:"quiet",title:"Go there"},()=>Ii(w.q.slice()))),A,S("seconds","Seconds to",_=>_>0?null:"more than 0"),S("hold","Rest after",_=>_>=0?null:"0 or more"),E("td",{class:"tools"},Io({k:v,n:t.postures.length,name:w.name,move:c,remove:u})))})),t.postures.length||s.append(E("tr",{},E("td",{class:"hint",colspan:String(x.length+4),text:"No postures yet: add the present one, move the arm, add the next."})))}np(s,"paste into the sequence");let g=()=>({postures:t.postures.map(x=>x.q),seconds:t.postures.slice(1).map(x=>x.seconds),holds:t.postures.slice(1).map(x=>x.hold),rate:t.rate});function m(x){let w=t.postures,v=w.map((A,S)=>({x:x.arrivals[S],s:0,text:`${A.name} at ${x.arrivals[S].toFixed(2)} s`,short:A.name,stop:!1}));r.say(`${w.length} postures in ${x.t[x.t.length-1].toFixed(2)} s. ${oU(x.q)}`,"good"),e=fr({table:b.table,q:x.q,xs:x.t,xName:"time",seconds:x.t,dq:x.dq,events:v,title:`${b.table.name}: ${w.map(A=>A.name).join(" \u2013 ")}`}),ci(e)}K(["table","units","sequence-loaded"],p),p()}};function oU(n){let t=b.table.joints.filter((e,i)=>n.some(s=>e.lower!==null&&s[i]<e.lower-1e-9||e.upper!==null&&s[i]>e.upper+1e-9));return t.length?`Outside the limits on the way: ${t.map(e=>e.name).join(", ")}.`:"Inside all limits."}var aU=.14,Do=new Ge(new Ns(1,32,20),new Vn({transparent:!0,opacity:.3,depthWrite:!1,fog:!1}));Do.matrixAutoUpdate=!1;Do.visible=!1;Do.renderOrder=4;var $u="none";function lU(n,t,e){let i=B_(n,t,e).slice(0,3),s=i.map(o=>i.map(a=>o.reduce((l,c,u)=>l+c*a[u],0))),r=[[1,0,0],[0,1,0],[0,0,1]];for(let o=0;o<20;o++)for(let[a,l]of[[0,1],[0,2],[1,2]]){if(Math.abs(s[a][l])<1e-300)continue;let c=(s[l][l]-s[a][a])/(2*s[a][l]),u=Math.sign(c||1)/(Math.abs(c)+Math.sqrt(c*c+1)),h=1/Math.sqrt(u*u+1),d=u*h;for(let f=0;f<3;f++)[s[f][a],s[f][l]]=[h*s[f][a]-d*s[f][l],d*s[f][a]+h*s[f][l]];for(let f=0;f<3;f++)[s[a][f],s[l][f]]=[h*s[a][f]-d*s[l][f],d*s[a][f]+h*s[l][f]];for(let f=0;f<3;f++)[r[f][a],r[f][l]]=[h*r[f][a]-d*r[f][l],d*r[f][a]+h*r[f][l]]}return[0,1,2].map(o=>({axis:r.map(a=>a[o]),length:Math.sqrt(Math.max(s[o][o],0))})).sort((o,a)=>a.length-o.length)}function fE(n){$u=n,pE()}var jp=()=>b.ellipsoid??null;function pE(){let n=$u!=="none"&&b.table.joints.length>0;if(Do.visible=n,b.ellipsoid=null,n){let t=lU(b.table,b.q,b.frames),e=aU*Gn(b.table),i=t[0].length||1,s=.004,r=t.map(({axis:u,length:h})=>({axis:u,half:e*Math.max($u==="velocity"?h/i:Math.min(t[2].length/Math.max(h,1e-12),1),s)})),o=te(b.frames.at(-1)),[a,l]=r,c={...r[2]};Do.matrix.set(...[0,1,2].flatMap(u=>[a.half*a.axis[u],l.half*l.axis[u],c.half*c.axis[u],o[u]]),0,0,0,1),Do.material.color.set($u==="velocity"?Ft.trace:Ft.accent),Do.material.side=mi,b.ellipsoid=t}ue(),lt("ellipsoid")}function mE(){en.add(Do),K(["q","theme"],()=>$u!=="none"&&pE())}var tm={};N_(tm,{begin:()=>n_,clear:()=>pU,corners:()=>fU,cutAt:()=>dU,range:()=>e_,size:()=>tc,take:()=>i_});var Zp=["#440154","#414487","#2a788e","#22a884","#7ad151","#fde725"].map(n=>new ee(n)),gE=.02;function Jp(n){let t=Float32Array.from(n).sort(),e=t.length;return{lo:t[Math.floor(e*gE)]??0,hi:t[Math.max(Math.ceil(e*(1-gE))-1,0)]??1}}var uU=new ee;function Kp(n,{lo:t,hi:e}){let i=Math.min(Math.max((n-t)/(e-t||1),0),1)*(Zp.length-1),s=Math.min(Math.floor(i),Zp.length-2);return uU.lerpColors(Zp[s],Zp[s+1],i-s)}var Qp=n=>new Float32Array(Uint8Array.from(atob(n),t=>t.charCodeAt(0)).buffer);var t_=new or({size:2.2,sizeAttenuation:!1,vertexColors:!0,fog:!1}),qi=new Nr(new we,t_);qi.frustumCulled=!1;qi.visible=!1;en.add(qi);var Ql=null,qu=null,Ms=0,e_={lo:0,hi:1};function n_(n){Ql=new Float32Array(3*n),qu=new Float32Array(n),Ms=0,qi.geometry.dispose(),qi.geometry=new we,qi.geometry.setAttribute("position",new He(Ql,3)),qi.geometry.setAttribute("color",new He(new Float32Array(3*n),3)),qi.geometry.setDrawRange(0,0),qi.visible=!0,ue()}function i_(n){let t=Qp(n);for(let e=0;e<t.length&&Ms<qu.length;e+=4,Ms++)Ql.set(t.subarray(e,e+3),3*Ms),qu[Ms]=t[e+3];hU()}function hU(){Object.assign(e_,Jp(qu.subarray(0,Ms)));let n=qi.geometry.attributes.color.array;for(let t=0;t<Ms;t++)Kp(qu[t],e_).toArray(n,3*t);qi.geometry.setDrawRange(0,Ms),qi.geometry.attributes.position.needsUpdate=!0,qi.geometry.attributes.color.needsUpdate=!0,ue()}var tc=()=>Ms;function dU(n){ss.localClippingEnabled=n!==null,t_.clippingPlanes=n===null?null:[new ri(new V(0,1,0),-n)],t_.needsUpdate=!0,ue()}function fU(){let n=new zi;for(let i=0;i<Ms;i++)n.expandByPoint(new V(Ql[3*i],Ql[3*i+1],Ql[3*i+2]));let{min:t,max:e}=n;return Ms?[0,1,2,3,4,5,6,7].map(i=>[i&1?t.x:e.x,i&2?t.y:e.y,i&4?t.z:e.z]):[]}function pU(){Ms=0,qi.visible=!1,ue()}var nm={};N_(nm,{begin:()=>o_,clear:()=>l_,corners:()=>xU,cutAt:()=>gU,range:()=>r_,size:()=>No,take:()=>a_});var mU=[[[1,0,0],[1,0,0,1,1,0,1,1,1,1,0,1],.86],[[-1,0,0],[0,1,0,0,0,0,0,0,1,0,1,1],.7],[[0,1,0],[1,1,0,0,1,0,0,1,1,1,1,1],.66],[[0,-1,0],[0,0,0,1,0,0,1,0,1,0,0,1],.92],[[0,0,1],[0,0,1,1,0,1,1,1,1,0,1,1],1],[[0,0,-1],[0,1,0,1,1,0,1,0,0,0,0,0],.5]],gr=new Ge(new we,new Vn({vertexColors:!0,fog:!1}));gr.frustumCulled=!1;gr.visible=!1;en.add(gr);var cs=null,s_=null,r_={lo:0,hi:1};function o_({low:n,shape:t,step:e}){cs={low:n,shape:t,step:e,values:new Map},em()}var xE=(n,t,e)=>(n*cs.shape[1]+t)*cs.shape[2]+e;function a_(n){let t=Qp(n);for(let e=0;e<t.length;e+=4){let[i,s,r]=[0,1,2].map(o=>Math.floor((t[e+o]-cs.low[o])/cs.step));cs.values.set(xE(i,s,r),t[e+3])}em()}var No=()=>cs?.values.size??0;function gU(n){s_=n,em()}function xU(){if(!No())return[];let n=cs.low.map((t,e)=>t+cs.shape[e]*cs.step);return[0,1,2,3,4,5,6,7].map(t=>[0,1,2].map(e=>t&1<<e?n[e]:cs.low[e]))}function l_(){cs=null,em()}function em(){if(gr.visible=No()>0,gr.geometry.dispose(),gr.geometry=new we,!gr.visible){ue();return}let{low:n,shape:t,step:e,values:i}=cs,s=[],r=[],o=[];Object.assign(r_,Jp(i.values()));let a=(c,u,h)=>u>=0&&c>=0&&h>=0&&c<t[0]&&u<t[1]&&h<t[2]&&i.has(xE(c,u,h))&&l(u),l=c=>s_===null||n[1]+(c+.5)*e>=s_;for(let[c,u]of i){let h=c%t[2],d=Math.floor(c/t[2])%t[1],f=Math.floor(c/(t[1]*t[2]));if(!l(d))continue;let{r:p,g:y,b:g}=Kp(u,r_);for(let[[m,x,w],v,A]of mU){if(a(f+m,d+x,h+w))continue;let S=s.length/3;for(let _=0;_<12;_+=3)s.push(n[0]+(f+v[_])*e,n[1]+(d+v[_+1])*e,n[2]+(h+v[_+2])*e),r.push(p*A,y*A,g*A);o.push(S,S+1,S+2,S,S+2,S+3)}}gr.geometry.setAttribute("position",new be(s,3)),gr.geometry.setAttribute("color",new be(r,3)),gr.geometry.setIndex(o),ue()}var _a=n=>n.toLocaleString("en"),_U={coarse:12,middling:20,fine:32};function _E(n){let t=2*Gn(b.table)/_U[n],e=10**Math.floor(Math.log10(t));return[1,2,2.5,5,10].map(i=>i*e).findLast(i=>i<=t*1.0001)}var ec={cloud:{scene:tm,colours:[["manipulability","manipulability"],["height","height of the tool",n=>re(n,"length")],["condition","inverse condition number"],["limits","distance to the limits"]],sizes:[["20000","20,000 points"],["5000","5,000 points"],["100000","100,000 points"]],begin:n=>n_(Number(n)),asked:(n,t)=>({count:Number(n),colour:t,seed:1}),piece:n=>i_(n.points),progress:n=>`${_a(n.done)} of ${_a(n.of)} points`,stopped:()=>`Cancelled after ${_a(tc())} points.`,ended:(n,t)=>`${_a(n.done)} random postures inside the limits, coloured by ${t}.`},voxels:{scene:nm,colours:[["fraction","share of orientations"],["count","number of solutions in all orientations",n=>_a(Math.round(n))],["manipulability","best manipulability"],["margin","distance to the limits"]],sizes:[["middling","middling voxels"],["coarse","coarse voxels"],["fine","fine voxels"]],begin:()=>l_(),asked:(n,t)=>({step:_E(n),colour:t}),piece:n=>n.low?o_(n):a_(n.points),progress:n=>`${Math.round(100*n.done/n.of)} % solved`,stopped:()=>`Cancelled after ${_a(No())} voxels.`,ended:(n,t,e)=>`${_a(n.reached)} voxels of ${re(_E(e),"length",gt.length==="mm"?0:3)} are reached inside the limits in some of ${n.orientations} orientations, ${n.volume.toPrecision(3)} m\xB3 together; coloured by ${t}. Each is solved at its centre.`}};function yE(){let n="cloud",t=!1,e=!1,i=null,s={size:null,colour:null},r=Ut("",{class:"primary","data-testid":"reach-start"},()=>t?Fi("cancel",{kind:t}):w()),o=Ut("Clear",{},x),a=E("input",{type:"range",min:"-1",max:"1",step:"any",value:"0",hidden:!0,"aria-label":"Where it is cut","data-testid":"reach-cut-at",on:{input:u}}),l=!1,c=Be("Shown",[["whole","Whole"],["half","Cut open"]],"whole",S=>{l=S==="half",a.hidden=!l,u()},"reach-cut");function u(){let S=l?b.table.base[7]+Number(a.value)*Gn(b.table):null;a.style.setProperty("--at",`${50*(1+Number(a.value))}%`);for(let{scene:_}of Object.values(ec))_.cutAt(S)}let h=E("progress",{max:"1","aria-label":"Progress","data-testid":"reach-progress",hidden:!0}),d=E("p",{class:"hint",role:"status","data-testid":"reach-note"}),f=E("span"),p=E("span"),y=E("div",{class:"legend-scale",hidden:!0},f,E("span",{class:"scale-bar"}),p),g=E("div",{class:"line"});function m(){if(!i)return;let{range:S}=ec[i.kind].scene,_=ec[i.kind].colours.find(([M])=>M===i.colour)[2]??du;bt(f,`\u2264 ${_(S.lo)}`),bt(p,`\u2265 ${_(S.hi)}`)}K("units",m),K("online",S=>{S&&e&&bt(d,Hx),e=!1});function x(){i=null,e=!1;for(let{scene:S}of Object.values(ec))S.clear();Gr("reach",[]),y.hidden=!0,bt(d,"")}async function w(){let S=ec[n],_=Cs(),{size:M,colour:N}=s,R=S.colours.find(([L])=>L===N)[1];x(),t=n,i={kind:n,colour:N},bt(r,"Cancel"),h.hidden=y.hidden=!1,h.value=0,S.begin(M);try{let L=await Oe(n,S.asked(M,N),z=>{_===Cs()&&(S.piece(z),h.value=z.done/z.of,m(),bt(d,S.progress(z)))});bt(d,L.stopped?S.stopped():S.ended(L,R,M))}catch(L){e=L instanceof ko,bt(d,L.message)}t=!1,y.hidden=!S.scene.size(),Gr("reach",S.scene.corners()),bu(),v(),h.hidden=!0}let v=()=>t||bt(r,n==="cloud"?"Draw the cloud":"Draw the map");function A(){let{sizes:S,colours:_}=ec[n];s.size=S[0][0],s.colour=_[0][0];let M=N=>R=>{s[N]=R};Gt(g,hn("How many",S,s.size,M("size"),{"data-testid":"reach-size"}),E("span",{class:"field-name",text:"coloured by"}),hn("Coloured by",_,s.colour,M("colour"),{"data-testid":"reach-colour"})),v()}return K("table",S=>{S==="postures"||S==="name"||(t&&Fi("cancel",{kind:t}),(tc()||No())&&x())}),A(),E("div",{},Be("Drawn as",[["cloud","Cloud"],["voxels","Map"]],n,S=>{n=S,A()},"reach-kind"),E("p",{class:"hint",text:"A cloud is of random postures. A map asks every voxel completely, which takes minutes for arms without a closed form or with joints to spare."}),g,E("div",{class:"line"},r,o,c,a),h,y,d)}var yU=()=>b.plan?.task==="position"?3:6,vE={id:"analysis",title:"Analysis",build(n){let t=E("dl",{class:"facts","data-testid":"analysis"}),e=[["manipulability","Manipulability","\u221Adet(J J\u1D40) of the rows that the arm\u2019s task moves (J\u1D40J where joints are fewer); in metres and radians, as in the cloud and the map"],["condition","Condition number","the largest singular value over the smallest, lengths divided by the arm\u2019s; 1 is best"],["least","Smallest singular value","0 at a singularity; lengths divided by the arm\u2019s"]],i={};for(let[c,u,h]of e)t.append(E("div",{title:h},E("dt",{text:u}),i[c]=E("dd",{"data-testid":`fact-${c}`})));let s=E("div",{class:"distances","data-testid":"limit-distances"}),r=[],o=E("p",{class:"hint","data-testid":"ellipsoid-axes"});K("ellipsoid",()=>{let c=jp();bt(o,c?`Joint rates of norm 1 move the point at most ${c.map(u=>re(u.length,"length")).join(", ")} a second along the three axes; forces are greatest where speeds are least.`:"")}),n.append(t,E("h3",{text:"At the tool\u2019s point"}),Be("Ellipsoid at the tool",[["none","None"],["velocity","Velocities"],["force","Forces"]],"none",fE,"ellipsoid"),o,E("h3",{text:"Distance to the limits"}),s,E("h3",{text:"Where the tool can be"}),yE());let a=()=>{r=b.table.joints.map((c,u)=>{let h=E("span",{class:"bar-fill"}),d=E("span",{class:"bar-text"});return{el:E("div",{class:"distance"},E("span",{},E("i",{text:"q"}),E("sub",{text:String(u+1)})),E("span",{class:"bar"},h),d),fill:h,text:d}}),Gt(s,r.map(c=>c.el)),l.now()},l=tr(()=>{if(n.closest(".panel").hidden||!b.table.joints.length)return;let c=dc(b.table,b.q,b.frames),u=c[0],h=c[c.length-1];bt(i.manipulability,du(dc(b.table,b.q,b.frames,1,yU()).reduce((d,f)=>d*f,1))),bt(i.condition,u>1e-9?ii(h/u,1):"\u221E"),bt(i.least,du(u)),t.dataset.tone=u<.02?"wrong":"good",r.forEach(({el:d,fill:f,text:p},y)=>{let g=b.table.joints[y],m=b.q[y];if(g.lower===null||g.upper===null){f.style.setProperty("width","100%"),bt(p,"no limit");return}let x=Math.min(m-g.lower,g.upper-m),w=Math.max(2*x/(g.upper-g.lower||1),0);f.style.setProperty("width",`${100*w}%`),d.classList.toggle("outside",x<-1e-9),bt(p,x<-1e-9?`${re(-x,Ze(g))} beyond`:re(x,Ze(g)))})});K("table",a),K(["q","units","plan"],l),K("panel",l.now),a()}};var vU=["panel","table","q","target","path","path-loaded","program","sequence","sequence-loaded","world","task","routing","units","notation","history"],bE=n=>({id:"share",title:"Share",build(t,e){let i=E("input",{type:"text",readonly:!0,class:"address","aria-label":"Link to this state","data-testid":"link",on:{focus:p=>p.target.select()}}),s=E("input",{type:"file",accept:".json,application/json",class:"offscreen",tabindex:"-1","aria-label":"State file","data-testid":"state-file",on:{change:()=>f(s)}}),r=E("p",{class:"hint",role:"status","data-testid":"report-note"}),o=Ut("Write the report",{class:"primary","data-testid":"report"},d),a=E("textarea",{rows:"9",readonly:!0,class:"code",spellcheck:"false","aria-label":"The screen as a Python script","data-testid":"python"}),l=[Ut("Copy the script",{"data-testid":"copy-python"},()=>no(a.value)),Ut("Save the script",{"data-testid":"save-python"},()=>hi("workbench.py",a.value,"text/x-python"))];t.append(E("p",{class:"hint",text:"Arm, posture, target, path, sequence, units and view, all in the link: whoever opens it on their own workbench sees what you see."}),E("div",{class:"line share-link"},i,Ut("Copy the link",{"data-testid":"copy-link"},async()=>no(await ep()))),E("h3",{text:"As a file"}),E("div",{class:"line"},Ut("Save the state",{"data-testid":"save-state"},()=>hi(`${b.table.name||"arm"}.workbench.json`,JSON.stringify(Cl(),null,1),"application/json")),Ut("Open a state\u2026",{},()=>s.click()),s,Ut("Save the robot file",{"data-testid":"save-robot"},Op)),E("h3",{text:"As Python"}),E("p",{class:"hint",text:"A script that makes and computes what is on the screen, in metres and radians."}),a,E("div",{class:"line"},...l),E("h3",{text:"Report"}),E("p",{class:"hint",text:"One page that stands alone: the arm, its table and equations, the present pose with all its solutions, singularities and reach."}),E("div",{class:"line"},o),r);let c=0,u=async()=>{c+=1,a.value="",a.placeholder="Being written \u2026";for(let p of l)p.disabled=!0;e.hidden||!b.table.joints.length||(h(),i.value=await ep())},h=Qs(async()=>{let p=c;try{let{q:y,target:g,hasTarget:m,path:x,program:w,world:v}=b,{task:A,redundancy:S}=pe,_={q:y,target:m?g:null,path:x,task:A,redundancy:S,world:v,program:Lo()},{text:M}=await Oe("python",w.length?_:{..._,program:null});if(p!==c)return;a.value=M;for(let N of l)N.disabled=!1}catch(y){p===c&&(a.placeholder=y.message)}});K(vU,()=>queueMicrotask(u)),K("online",p=>p&&u());async function d(){let p=Sr(ls());if(p){bt(r,`${p} Nothing was written.`);return}o.disabled=!0;try{let y=x=>bt(r,x.note),{html:g,name:m}=await Oe("report",{q:b.q},y,{whichever:!0});hi(m,g,"text/html"),bt(r,`Written: ${m}, ${Math.round(g.length/1024)} kB.`)}catch(y){bt(r,y.message)}finally{o.disabled=!1}}async function f(p){let y=p.files[0];if(p.value="",!!y)try{if(y.size>5e5)throw new Error("A state file has at most 500 kB.");Cu(JSON.parse(await y.text()),n(),"open a state"),de("Opened")}catch(g){de(g instanceof SyntaxError?`${y.name} is not a state file.`:g.message,"wrong")}}}});var bU=40,EE=!1,TE=0,c_=!1,im=null,wE=[],ME="null",SE=null;function AE(n){n&&(EE=!0,im=b.table,RE(n),(b.program.length||b.world.length)&&CE.soon())}function RE(n){c_=!0,TE=n.said,n.table&&(yn(n.table,{q:n.q,what:"new",label:"open an arm from Python"}),im=b.table,Wl(n.looks??null,n.table)),n.things&&wU(n.things),n.target&&(b.hasTarget=!0,Si(n.target,"restored")),n.q&&n.q.length===b.table.joints.length&&(lt("did",{label:"move from Python",key:"python"}),Oi(n.q,"python")),c_=!1}function wU(n){b.things=n.filter(i=>i.kind!=="motion"),lt("world","python");let t=n.findLast(i=>i.kind==="motion")??null,e=JSON.stringify(t);if(e!==SE){if(SE=e,!t){ci(null);return}ci(fr({table:b.table,q:t.q,xs:t.t,xName:"time",seconds:t.t,title:`${b.table.name}: ${t.name}`,events:t.events.map(([i,s,r])=>({x:i,s:0,text:`${s} ${r} at ${i.toFixed(2)} s`,short:s,stop:!1}))}))}}var CE=zo(bU,()=>{if(!b.table.joints.length)return;let n=b.q,t=b.hasTarget?b.target:null,e=b.program.length?Lo():null,i={},s=JSON.stringify(e);b.table!==im&&(i.table=_m(b.table)),b.world!==wE&&(i.world=b.world),s!==ME&&(i.program=e),[im,wE,ME]=[b.table,b.world,s],Fi("shown",{q:n,target:t,said:TE,...i}).catch(()=>{})});function PE(){K("push",RE),K(["q","target","table","program","world"],()=>EE&&!c_&&CE.soon())}var ya=new Rn,LE=new Vn({fog:!1}),u_=new Vn({fog:!1}),h_=new Hi(1,1,1),d_=new Ge(h_,LE),DE=[new Ge(h_,u_),new Ge(h_,u_)];ya.add(d_,...DE);ya.matrixAutoUpdate=!1;ya.visible=!1;var Xu=null;function NE(){en.add(ya),K("q",()=>Xu!==null&&OE()),K("theme",IE),IE()}function IE(){LE.color.set(Ft.joint),u_.color.set(Ft.accent)}function f_(n){n===null&&Xu===null||(Xu=n,ya.visible=n!==null,n!==null&&OE(),ue())}var UE=()=>Xu;function OE(){let n=b.frames.at(-1),t=.075*Gn(b.table);d_.scale.set(.35*t,1.1*t,.25*t),d_.position.set(0,0,-.85*t),DE.forEach((e,i)=>{let s=(.08+.36*(1-Xu))*t;e.scale.set(.26*t,.13*t,.95*t),e.position.set(0,(i?1:-1)*s,-.3*t)}),ya.matrix.set(...n),ya.updateMatrixWorld(!0)}var EU=.25,p_=.5;function TU(n){let t=(n.happens??[]).filter(([,r])=>r==="gripper").map(([r,,o])=>({t:r,value:o})),e=new Map(b.world.filter(r=>r.role==="object").map(r=>[r.name,[{t:-1,T:r.T}]])),i=null,s=!1;for(let{t:r,value:o}of t){let a=CU(n,r);if(o>=p_&&!s){let l=[...e].map(([c,u])=>({name:c,T:u.at(-1).T,d:Ui(Ni(te(u.at(-1).T),te(a)))})).filter(({name:c,d:u})=>u<AU(b.world.find(h=>h.name===c))).sort((c,u)=>c.d-u.d)[0];l&&(i=l.name,e.get(i).push({t:r,held:Hn(Ia(a),l.T)}))}else o<p_&&s&&i&&(e.get(i).push({t:r,T:Hn(a,e.get(i).at(-1).held)}),i=null);s=o>=p_}return{grips:t,objects:e}}var AU=n=>.6*Math.max(...n.size??[2*(n.r??0),n.h??0])+.01;function RU(n,t){let e=0,i=n.length-1;for(;e<i;){let s=e+i+1>>1;n[s]<=t+1e-9?e=s:i=s-1}return e}var CU=(n,t)=>As(n.table,n.q[RU(n.seconds,t)]).at(-1),Uo=null,PU=n=>{let t=Uo.grips.length?1-Math.round(Uo.grips[0].value):0;for(let e of Uo.grips){if(e.t>n)break;let i=Math.min((n-e.t)/EU,1);t+=i*(e.value-t)}return t};function FE(){K("motion",()=>{eE(),Uo=b.motion?.happens?TU(b.motion):null,Uo||f_(null)}),K("played",n=>{if(!Uo)return;let t=b.frames.at(-1);Uo.grips.length&&f_(PU(n));for(let[e,i]of Uo.objects){let s=i.findLast(r=>r.t<=n)??i[0];Zx(e,s.held?Hn(t,s.held):s.T)}})}function BE(){let n={said:()=>structuredClone(Cl()),q:()=>b.q.slice(),frames:()=>structuredClone(b.frames),target:()=>b.target.slice(),table:()=>structuredClone(b.table),solutions:()=>structuredClone(b.solutions),camera:()=>_l(),pictures:()=>hb(),ghosts:()=>mw(),ghostsOutside:()=>gw(),labels:()=>r0(),history:()=>[Zf(),Jf()],beyond:()=>dw(),things:()=>iE(),looks:()=>e1(),program:()=>structuredClone(b.program),route:()=>structuredClone(b.route),motion:()=>structuredClone(b.motion),gripper:()=>UE(),stepFrame:()=>b.dhStep===null?null:Af().at(-1).T,clearance:()=>structuredClone(b.clearance),bodies:()=>lE(),ellipsoid:()=>structuredClone(jp()),world:()=>structuredClone(b.world),framesDrawn:()=>fw(),answers:()=>I0.answers,settled:()=>ww(),resting:()=>G_()===0&&Gw(),trace:()=>vw(),voxels:()=>No(),cloud:()=>tc()},t={routePlace(e,i){let s={which:e,turn:i};return document.querySelector(".route-map").dispatchEvent(new CustomEvent("where",{detail:s})),s.at},placeOf:e=>tE(e)??b.world.find(i=>i.name===e)?.T??null,go:Xr,toScreen:Vi,withPicture:e=>ml(e),handles:()=>Vb(),forward:(e,i)=>As(e,i),convert:(e,i)=>Lp(e,i),read:(e,i)=>Rl(e,i),block:e=>Pu(e),present:(e,i,s)=>Fp(e,i,s)};for(let[e,i]of Object.entries(n))Object.defineProperty(t,e,{get:i,enumerable:!0});window.workbench=Object.freeze(t)}hf();Pw();fb(Rs("#view"));K("theme",Zg);Zg();Rw();Rb(Rs("#overlay"));lw();zb();Q1();t1();uE();mE();NE();FE();PE();j_();Ew();r1(Rs("#bar"));a1(Rs("#overlay"));US(Rs("#dock"));l1();var ju,Yu=(n,t,...e)=>[{...t,group:n},...e];ju=o1(Rs("#rail"),Rs("#panels"),Rs("#pinned"),[...Yu("Drive",{id:"move",title:"Move",sections:[Kw,u1]},b1),...Yu("Describe",C1,hE),...Yu("Plan",D1,W1(()=>ju),Y1,dE),...Yu("Study",h1,I1,vE),...Yu("Hand on",bE(()=>ju))]);kS(Rs("#room"),Rs("#rail"));Vw(ju);var LU=Bw().then(n=>n&&Cu(n,ju)).catch(n=>de(`The link could not be read: ${n.message}`,"wrong"));K("online",async n=>{if(!n)return;await LU;let t=await V_();b.catalog=t.catalog,lt("catalog"),t.table&&(!b.table.joints.length||t.bench)&&(yn(t.table,{q:La(t.table),step:!1,what:"new"}),Kf()),t.looks&&Wl(t.looks,t.table),AE(t.bench),document.documentElement.dataset.ready="yes"});b.online&&lt("online",!0);document.fonts?.ready.then(()=>lt("theme"));BE();
