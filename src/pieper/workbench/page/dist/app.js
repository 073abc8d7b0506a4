import{A as b,B as Oi,C as Fu,D as _a,E as yn,F as Qx,G as Si,H as t_,I as Bu,K as Fi,L as Zs,a as Zi,b as Hn,c as xa,d as te,e as js,f as jl,g as Ni,h as Zl,i as Du,j as Ui,k as Nu,l as Uu,m as Xx,n as Yx,o as yr,p as vr,q as jx,r as ws,s as Up,t as Zx,u as Gn,v as Ou,w as Jx,x as Kx,y as et,z as ut}from"./chunk-YTOPIUNI.js";import{a as qx}from"./chunk-WOT6VMZA.js";function M(n,t={},...e){let i=document.createElement(n);for(let[s,r]of Object.entries(t))if(!(r==null||r===!1))if(s==="text")i.textContent=r;else if(s==="on")for(let[o,a]of Object.entries(r))i.addEventListener(o,a);else s==="value"?i.value=r:s==="checked"||s==="disabled"||s==="hidden"?i[s]=r:i.setAttribute(s,r===!0?"":r);return i.append(...e.flat().filter(s=>s!=null&&s!==!1)),i}var Ut=(n,t,e)=>M("button",{type:"button",text:n,...t,on:{click:e}}),Es=(n,t=document)=>t.querySelector(n),Gt=(n,...t)=>n.replaceChildren(...t.flat().filter(Boolean));function bt(n,t){n.textContent!==t&&(n.textContent=t)}function Be(n,t,e,i,s){let r=M("div",{class:"choice",role:"group","aria-label":n,"data-testid":s}),o=a=>{for(let c of r.children)c.setAttribute("aria-pressed",String(c.dataset.value===a))};for(let[a,c]of t)r.append(M("button",{type:"button",text:c,"data-value":a,on:{click:()=>{o(a),i(a)}}}));return o(e),r.mark=o,r}function hn(n,t,e,i,s={}){let r=M("select",{"aria-label":n,...s,on:{change:()=>i(r.value)}},t.map(([o,a])=>M("option",{value:o,text:a})));return r.value=e,r}function Js(n){let t=!1;return()=>{t||(t=!0,requestAnimationFrame(()=>{t=!1,n()}))}}function ya(n,t){let e=null,i=-1/0,s=()=>{clearTimeout(e),e=null,i=performance.now(),t()};return s.soon=()=>{let r=i+n-performance.now();r<=0?s():e??=setTimeout(s,r)},s}function Ks(n,t){let e,i=(...s)=>{clearTimeout(e),e=setTimeout(()=>n(...s),t)};return i.cancel=()=>clearTimeout(e),i}function ui(n,t,e="text/plain"){let i=URL.createObjectURL(t instanceof Blob?t:new Blob([t],{type:e})),s=M("a",{href:i,download:n});document.body.append(s),s.click(),s.remove(),setTimeout(()=>URL.revokeObjectURL(i),1e4)}async function jr(n){try{await navigator.clipboard.writeText(n)}catch{let t=M("textarea",{class:"offscreen"});t.value=n,document.body.append(t),t.select(),document.execCommand("copy"),t.remove()}we("Copied")}var e_;function we(n,t="plain"){let e=document.getElementById("remark");e.textContent=n,e.dataset.tone=t,e.classList.add("shown"),clearTimeout(e_),e_=setTimeout(()=>e.classList.remove("shown"),t==="wrong"?8e3:2500)}function n_(n){let t=[...n.querySelectorAll(".number.wrong")].find(e=>!e.closest("[hidden]"));return t?(t.focus(),`${t.getAttribute("aria-label")} cannot be read (${t.title}). Nothing was computed.`):null}var va=0,Bp=-1,Op=[];function kp(n){return{...n,joints:n.joints.map(({text:t,...e})=>e)}}async function Fp(){let n=va;if(!b.table.joints.length){b.plan={solvable:!1,explain:"The table is empty: add a joint.",max_solutions:0},ut("plan");return}try{let{plan:t}=await Fi("arm",{table:kp(b.table)});if(n!==va)return;Bp=n,b.plan=t,i_()}catch(t){if(n!==va||t instanceof Bu)return;b.plan={solvable:!1,refused:!0,explain:t.message,max_solutions:0},i_(t)}ut("plan")}function i_(n){let t=Op;Op=[];for(let{resolve:e,reject:i}of t)n?i(n):e()}var s_=Ks(Fp,60);function r_(){et("table",n=>{va+=1,n==="postures"&&(Bp=-1),n==="cell"?s_():(s_.cancel(),Fp())}),et("online",n=>{n&&(va+=1,Fp())})}function H1(){return Bp===va?Promise.resolve():new Promise((n,t)=>Op.push({resolve:n,reject:t}))}async function Oe(n,t,e){return await H1(),Fi(n,t,e)}function o_(n){if(!n)return"";let t=n.explain.split(`
`).map(s=>s.trim()),e=t.find(s=>s.startsWith("Solved by:")),i=(e??t.filter(Boolean)[0]??"").replace(/\s+/g," ");return e||i.length<200?i:`${i.slice(0,200)} \u2026`}function ku(n){if(!n?.solvable)return"";let t=n.max_solutions;return t==null?"":t===1?"One solution":`Up to ${t} solutions`}var oo={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},ao={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},z_=0,pm=1,H_=2;var Ic=1,G_=2,Ya=3,sr=0,oi=1,pi=2,zo=0,ja=1,mm=2,gm=3,xm=4,V_=5;var Ho=100,W_=101,$_=102,q_=103,X_=104,Y_=200,j_=201,Z_=202,J_=203,_m=204,ym=205,K_=206,Q_=207,ty=208,ey=209,ny=210,iy=211,sy=212,ry=213,oy=214,fh=0,ph=1,mh=2,Oa=3,gh=4,xh=5,_h=6,yh=7,vm=0,ay=1,ly=2,rr=0,bm=1,Mm=2,Sm=3,wm=4,Em=5,Tm=6,Am=7;var Rm=300,Go=301,Za=302,$h=303,qh=304,vh=1e3,tr=1001,bh=1002,ni=1003,cy=1004;var Lc=1005;var Ai=1006,Xh=1007;var Lr=1008;var ns=1009,Cm=1010,Pm=1011,Ja=1012,Yh=1013,Is=1014,ds=1015,Ls=1016,jh=1017,Zh=1018,Vo=1020,Im=35902,Lm=35899,Dm=1021,Nm=1022,Ds=1023,Ar=1026,Dr=1027,Jh=1028,Kh=1029,lo=1030,Qh=1031;var td=1033,Dc=33776,Nc=33777,Uc=33778,Oc=33779,ed=35840,nd=35841,id=35842,sd=35843,rd=36196,od=37492,ad=37496,ld=37488,cd=37489,Fc=37490,ud=37491,hd=37808,dd=37809,fd=37810,pd=37811,md=37812,gd=37813,xd=37814,_d=37815,yd=37816,vd=37817,bd=37818,Md=37819,Sd=37820,wd=37821,Ed=36492,Td=36494,Ad=36495,Rd=36283,Cd=36284,Bc=36285,Pd=36286;var ac=2300,Mh=2301,hh=2302,om=2303,am=2400,lm=2401,cm=2402;var uy=3200;var Um=0,hy=1,Nr="",Ei="srgb",lc="srgb-linear",cc="linear",$e="srgb";var dh=7680,Om=7681;var Fm=517;var dy=519,fy=512,py=513,my=514,Bm=515,gy=516,xy=517,km=518,zm=519,Hm=35044,Id=35048;var Gm="300 es",hs=2e3,uc=2001;function V1(n){for(let t=n.length-1;t>=0;--t)if(n[t]>=65535)return!0;return!1}function W1(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function hc(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function _y(){let n=hc("canvas");return n.style.display="block",n}var a_={},Fa=null;function dc(...n){let t="THREE."+n.shift();Fa?Fa("log",t,...n):console.log(t,...n)}function yy(n){let t=n[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=n[1];e&&e.isStackTrace?n[0]+=" "+e.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function ie(...n){n=yy(n);let t="THREE."+n.shift();if(Fa)Fa("warn",t,...n);else{let e=n[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...n)}}function le(...n){n=yy(n);let t="THREE."+n.shift();if(Fa)Fa("error",t,...n);else{let e=n[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...n)}}function sc(...n){let t=n.join(" ");t in a_||(a_[t]=!0,ie(...n))}function vy(n,t,e){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(t,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:i()}}setTimeout(r,e)})}var by={[fh]:fh,[mh]:_h,[gh]:gh,[Oa]:xh,[ph]:ph,[_h]:mh,[yh]:yh,[xh]:Oa},Cs=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[t]===void 0&&(i[t]=[]),i[t].indexOf(e)===-1&&i[t].push(e)}hasEventListener(t,e){let i=this._listeners;return i===void 0?!1:i[t]!==void 0&&i[t].indexOf(e)!==-1}removeEventListener(t,e){let i=this._listeners;if(i===void 0)return;let s=i[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let i=e[t.type];if(i!==void 0){t.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},hi=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],l_=1234567,rc=Math.PI/180,Ba=180/Math.PI;function co(){let n=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(hi[n&255]+hi[n>>8&255]+hi[n>>16&255]+hi[n>>24&255]+"-"+hi[t&255]+hi[t>>8&255]+"-"+hi[t>>16&15|64]+hi[t>>24&255]+"-"+hi[e&63|128]+hi[e>>8&255]+"-"+hi[e>>16&255]+hi[e>>24&255]+hi[i&255]+hi[i>>8&255]+hi[i>>16&255]+hi[i>>24&255]).toLowerCase()}function Ae(n,t,e){return Math.max(t,Math.min(e,n))}function Vm(n,t){return(n%t+t)%t}function $1(n,t,e,i,s){return i+(n-t)*(s-i)/(e-t)}function q1(n,t,e){return n!==t?(e-n)/(t-n):0}function oc(n,t,e){return(1-e)*n+e*t}function X1(n,t,e,i){return oc(n,t,1-Math.exp(-e*i))}function Y1(n,t=1){return t-Math.abs(Vm(n,t*2)-t)}function j1(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*(3-2*n))}function Z1(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*n*(n*(n*6-15)+10))}function J1(n,t){return n+Math.floor(Math.random()*(t-n+1))}function K1(n,t){return n+Math.random()*(t-n)}function Q1(n){return n*(.5-Math.random())}function tE(n){n!==void 0&&(l_=n);let t=l_+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function eE(n){return n*rc}function nE(n){return n*Ba}function iE(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function sE(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function Wm(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function rE(n,t,e,i,s){let r=Math.cos,o=Math.sin,a=r(e/2),c=o(e/2),l=r((t+i)/2),u=o((t+i)/2),h=r((t-i)/2),d=o((t-i)/2),f=r((i-t)/2),p=o((i-t)/2);switch(s){case"XYX":n.set(a*u,c*h,c*d,a*l);break;case"YZY":n.set(c*d,a*u,c*h,a*l);break;case"ZXZ":n.set(c*h,c*d,a*u,a*l);break;case"XZX":n.set(a*u,c*p,c*f,a*l);break;case"YXY":n.set(c*f,a*u,c*p,a*l);break;case"ZYZ":n.set(c*p,c*f,a*u,a*l);break;default:ie("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Ld(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function $m(n,t){if(t.constructor===Float32Array)return n;let e=Ld(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/e,-1)}function qm(n,t){if(t.constructor===Float32Array)return n;let e=Ld(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*e)}var uo={DEG2RAD:rc,RAD2DEG:Ba,generateUUID:co,clamp:Ae,euclideanModulo:Vm,mapLinear:$1,inverseLerp:q1,lerp:oc,damp:X1,pingpong:Y1,smoothstep:j1,smootherstep:Z1,randInt:J1,randFloat:K1,randFloatSpread:Q1,seededRandom:tE,degToRad:eE,radToDeg:nE,isPowerOfTwo:iE,ceilPowerOfTwo:sE,floorPowerOfTwo:Wm,setQuaternionFromProperEuler:rE,normalize:qm,denormalize:$m},Qt=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,i=this.y,s=t.elements;return this.x=s[0]*e+s[3]*i+s[6],this.y=s[1]*e+s[4]*i+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=Ae(this.x,t.x,e.x),this.y=Ae(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=Ae(this.x,t,e),this.y=Ae(this.y,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Ae(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(Ae(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y;return e*e+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let i=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*i-o*s+t.x,this.y=r*s+o*i+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},fn=class{constructor(t=0,e=0,i=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=i,this._w=s}static slerpFlat(t,e,i,s,r,o,a){let c=i[s+0],l=i[s+1],u=i[s+2],h=i[s+3],d=r[o+0],f=r[o+1],p=r[o+2],_=r[o+3];if(h!==_||c!==d||l!==f||u!==p){let m=c*d+l*f+u*p+h*_;m<0&&(d=-d,f=-f,p=-p,_=-_,m=-m);let g=1-a;if(m<.9995){let x=Math.acos(m),S=Math.sin(x);g=Math.sin(g*x)/S,a=Math.sin(a*x)/S,c=c*g+d*a,l=l*g+f*a,u=u*g+p*a,h=h*g+_*a}else{c=c*g+d*a,l=l*g+f*a,u=u*g+p*a,h=h*g+_*a;let x=1/Math.sqrt(c*c+l*l+u*u+h*h);c*=x,l*=x,u*=x,h*=x}}t[e]=c,t[e+1]=l,t[e+2]=u,t[e+3]=h}static multiplyQuaternionsFlat(t,e,i,s,r,o){let a=i[s],c=i[s+1],l=i[s+2],u=i[s+3],h=r[o],d=r[o+1],f=r[o+2],p=r[o+3];return t[e]=a*p+u*h+c*f-l*d,t[e+1]=c*p+u*d+l*h-a*f,t[e+2]=l*p+u*f+a*d-c*h,t[e+3]=u*p-a*h-c*d-l*f,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,i,s){return this._x=t,this._y=e,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let i=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,c=Math.sin,l=a(i/2),u=a(s/2),h=a(r/2),d=c(i/2),f=c(s/2),p=c(r/2);switch(o){case"XYZ":this._x=d*u*h+l*f*p,this._y=l*f*h-d*u*p,this._z=l*u*p+d*f*h,this._w=l*u*h-d*f*p;break;case"YXZ":this._x=d*u*h+l*f*p,this._y=l*f*h-d*u*p,this._z=l*u*p-d*f*h,this._w=l*u*h+d*f*p;break;case"ZXY":this._x=d*u*h-l*f*p,this._y=l*f*h+d*u*p,this._z=l*u*p+d*f*h,this._w=l*u*h-d*f*p;break;case"ZYX":this._x=d*u*h-l*f*p,this._y=l*f*h+d*u*p,this._z=l*u*p-d*f*h,this._w=l*u*h+d*f*p;break;case"YZX":this._x=d*u*h+l*f*p,this._y=l*f*h+d*u*p,this._z=l*u*p-d*f*h,this._w=l*u*h-d*f*p;break;case"XZY":this._x=d*u*h-l*f*p,this._y=l*f*h-d*u*p,this._z=l*u*p+d*f*h,this._w=l*u*h+d*f*p;break;default:ie("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let i=e/2,s=Math.sin(i);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,i=e[0],s=e[4],r=e[8],o=e[1],a=e[5],c=e[9],l=e[2],u=e[6],h=e[10],d=i+a+h;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(u-c)*f,this._y=(r-l)*f,this._z=(o-s)*f}else if(i>a&&i>h){let f=2*Math.sqrt(1+i-a-h);this._w=(u-c)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+l)/f}else if(a>h){let f=2*Math.sqrt(1+a-i-h);this._w=(r-l)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(c+u)/f}else{let f=2*Math.sqrt(1+h-i-a);this._w=(o-s)/f,this._x=(r+l)/f,this._y=(c+u)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let i=t.dot(e)+1;return i<1e-8?(i=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=i):(this._x=0,this._y=-t.z,this._z=t.y,this._w=i)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=i),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(Ae(this.dot(t),-1,1)))}rotateTowards(t,e){let i=this.angleTo(t);if(i===0)return this;let s=Math.min(1,e/i);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=e._x,c=e._y,l=e._z,u=e._w;return this._x=i*u+o*a+s*l-r*c,this._y=s*u+o*c+r*a-i*l,this._z=r*u+o*l+i*c-s*a,this._w=o*u-i*a-s*c-r*l,this._onChangeCallback(),this}slerp(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let c=1-e;if(a<.9995){let l=Math.acos(a),u=Math.sin(l);c=Math.sin(c*l)/u,e=Math.sin(e*l)/u,this._x=this._x*c+i*e,this._y=this._y*c+s*e,this._z=this._z*c+r*e,this._w=this._w*c+o*e,this._onChangeCallback()}else this._x=this._x*c+i*e,this._y=this._y*c+s*e,this._z=this._z*c+r*e,this._w=this._w*c+o*e,this.normalize();return this}slerpQuaternions(t,e,i){return this.copy(t).slerp(e,i)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},G=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,i=0){this.x=t,this.y=e,this.z=i}set(t,e,i){return i===void 0&&(i=this.z),this.x=t,this.y=e,this.z=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(c_.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(c_.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*i+r[6]*s,this.y=r[1]*e+r[4]*i+r[7]*s,this.z=r[2]*e+r[5]*i+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,i=this.y,s=this.z,r=t.x,o=t.y,a=t.z,c=t.w,l=2*(o*s-a*i),u=2*(a*e-r*s),h=2*(r*i-o*e);return this.x=e+c*l+o*h-a*u,this.y=i+c*u+a*l-r*h,this.z=s+c*h+r*u-o*l,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*i+r[8]*s,this.y=r[1]*e+r[5]*i+r[9]*s,this.z=r[2]*e+r[6]*i+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=Ae(this.x,t.x,e.x),this.y=Ae(this.y,t.y,e.y),this.z=Ae(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=Ae(this.x,t,e),this.y=Ae(this.y,t,e),this.z=Ae(this.z,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Ae(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let i=t.x,s=t.y,r=t.z,o=e.x,a=e.y,c=e.z;return this.x=s*c-r*a,this.y=r*o-i*c,this.z=i*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let i=t.dot(this)/e;return this.copy(t).multiplyScalar(i)}projectOnPlane(t){return zp.copy(this).projectOnVector(t),this.sub(zp)}reflect(t){return this.sub(zp.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(Ae(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y,s=this.z-t.z;return e*e+i*i+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,i){let s=Math.sin(e)*t;return this.x=s*Math.sin(i),this.y=Math.cos(e)*t,this.z=s*Math.cos(i),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,i){return this.x=t*Math.sin(e),this.y=i,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),i=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=i,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,i=Math.sqrt(1-e*e);return this.x=i*Math.cos(t),this.y=e,this.z=i*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},zp=new G,c_=new fn,he=class{static{this.prototype.isMatrix3=!0}constructor(t,e,i,s,r,o,a,c,l){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,c,l)}set(t,e,i,s,r,o,a,c,l){let u=this.elements;return u[0]=t,u[1]=s,u[2]=a,u[3]=e,u[4]=r,u[5]=c,u[6]=i,u[7]=o,u[8]=l,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],this}extractBasis(t,e,i){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[3],c=i[6],l=i[1],u=i[4],h=i[7],d=i[2],f=i[5],p=i[8],_=s[0],m=s[3],g=s[6],x=s[1],S=s[4],v=s[7],A=s[2],w=s[5],y=s[8];return r[0]=o*_+a*x+c*A,r[3]=o*m+a*S+c*w,r[6]=o*g+a*v+c*y,r[1]=l*_+u*x+h*A,r[4]=l*m+u*S+h*w,r[7]=l*g+u*v+h*y,r[2]=d*_+f*x+p*A,r[5]=d*m+f*S+p*w,r[8]=d*g+f*v+p*y,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],c=t[6],l=t[7],u=t[8];return e*o*u-e*a*l-i*r*u+i*a*c+s*r*l-s*o*c}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],c=t[6],l=t[7],u=t[8],h=u*o-a*l,d=a*c-u*r,f=l*r-o*c,p=e*h+i*d+s*f;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let _=1/p;return t[0]=h*_,t[1]=(s*l-u*i)*_,t[2]=(a*i-s*o)*_,t[3]=d*_,t[4]=(u*e-s*c)*_,t[5]=(s*r-a*e)*_,t[6]=f*_,t[7]=(i*c-l*e)*_,t[8]=(o*e-i*r)*_,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,i,s,r,o,a){let c=Math.cos(r),l=Math.sin(r);return this.set(i*c,i*l,-i*(c*o+l*a)+o+t,-s*l,s*c,-s*(-l*o+c*a)+a+e,0,0,1),this}scale(t,e){return sc("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Hp.makeScale(t,e)),this}rotate(t){return sc("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Hp.makeRotation(-t)),this}translate(t,e){return sc("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Hp.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,i,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<9;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<9;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t}clone(){return new this.constructor().fromArray(this.elements)}},Hp=new he,u_=new he().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),h_=new he().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function oE(){let n={enabled:!0,workingColorSpace:lc,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===$e&&(s.r=Tr(s.r),s.g=Tr(s.g),s.b=Tr(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===$e&&(s.r=Ua(s.r),s.g=Ua(s.g),s.b=Ua(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Nr?cc:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[lc]:{primaries:t,whitePoint:i,transfer:cc,toXYZ:u_,fromXYZ:h_,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:Ei},outputColorSpaceConfig:{drawingBufferColorSpace:Ei}},[Ei]:{primaries:t,whitePoint:i,transfer:$e,toXYZ:u_,fromXYZ:h_,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:Ei}}}),n}var De=oE();function Tr(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function Ua(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var ba,Sh=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let i;if(t instanceof HTMLCanvasElement)i=t;else{ba===void 0&&(ba=hc("canvas")),ba.width=t.width,ba.height=t.height;let s=ba.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),i=ba}return i.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=hc("canvas");e.width=t.width,e.height=t.height;let i=e.getContext("2d");i.drawImage(t,0,0,t.width,t.height);let s=i.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Tr(r[o]/255)*255;return i.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let i=0;i<e.length;i++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[i]=Math.floor(Tr(e[i]/255)*255):e[i]=Tr(e[i]);return{data:e,width:t.width,height:t.height}}else return ie("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},aE=0,ka=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:aE++}),this.uuid=co(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Gp(s[o].image)):r.push(Gp(s[o]))}else r=Gp(s);i.url=r}return e||(t.images[this.uuid]=i),i}};function Gp(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?Sh.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(ie("Texture: Unable to serialize Texture."),{})}var lE=0,Vp=new G,Bi=class n extends Cs{constructor(t=n.DEFAULT_IMAGE,e=n.DEFAULT_MAPPING,i=tr,s=tr,r=Ai,o=Lr,a=Ds,c=ns,l=n.DEFAULT_ANISOTROPY,u=Nr){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:lE++}),this.uuid=co(),this.name="",this.source=new ka(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=l,this.format=a,this.internalFormat=null,this.type=c,this.offset=new Qt(0,0),this.repeat=new Qt(1,1),this.center=new Qt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new he,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Vp).x}get height(){return this.source.getSize(Vp).y}get depth(){return this.source.getSize(Vp).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let i=t[e];if(i===void 0){ie(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){ie(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),e||(t.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==Rm)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case vh:t.x=t.x-Math.floor(t.x);break;case tr:t.x=t.x<0?0:1;break;case bh:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case vh:t.y=t.y-Math.floor(t.y);break;case tr:t.y=t.y<0?0:1;break;case bh:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};Bi.DEFAULT_IMAGE=null;Bi.DEFAULT_MAPPING=Rm;Bi.DEFAULT_ANISOTROPY=1;var bn=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,i=0,s=1){this.x=t,this.y=e,this.z=i,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,i,s){return this.x=t,this.y=e,this.z=i,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*i+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,i,s,r,c=t.elements,l=c[0],u=c[4],h=c[8],d=c[1],f=c[5],p=c[9],_=c[2],m=c[6],g=c[10];if(Math.abs(u-d)<.01&&Math.abs(h-_)<.01&&Math.abs(p-m)<.01){if(Math.abs(u+d)<.1&&Math.abs(h+_)<.1&&Math.abs(p+m)<.1&&Math.abs(l+f+g-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let S=(l+1)/2,v=(f+1)/2,A=(g+1)/2,w=(u+d)/4,y=(h+_)/4,E=(p+m)/4;return S>v&&S>A?S<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(S),s=w/i,r=y/i):v>A?v<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(v),i=w/s,r=E/s):A<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(A),i=y/r,s=E/r),this.set(i,s,r,e),this}let x=Math.sqrt((m-p)*(m-p)+(h-_)*(h-_)+(d-u)*(d-u));return Math.abs(x)<.001&&(x=1),this.x=(m-p)/x,this.y=(h-_)/x,this.z=(d-u)/x,this.w=Math.acos((l+f+g-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=Ae(this.x,t.x,e.x),this.y=Ae(this.y,t.y,e.y),this.z=Ae(this.z,t.z,e.z),this.w=Ae(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=Ae(this.x,t,e),this.y=Ae(this.y,t,e),this.z=Ae(this.z,t,e),this.w=Ae(this.w,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Ae(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this.w=t.w+(e.w-t.w)*i,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},wh=class extends Cs{constructor(t=1,e=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Ai,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=i.depth,this.scissor=new bn(0,0,t,e),this.scissorTest=!1,this.viewport=new bn(0,0,t,e),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new Bi({width:t,height:e,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:Ai,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,i=1){if(this.width!==t||this.height!==e||this.depth!==i){this.width=t,this.height=e,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,i=t.textures.length;e<i;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new ka(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},Qi=class extends wh{constructor(t=1,e=1,i={}){super(t,e,i),this.isWebGLRenderTarget=!0}},fc=class extends Bi{constructor(t=null,e=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=ni,this.minFilter=ni,this.wrapR=tr,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var Eh=class extends Bi{constructor(t=null,e=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=ni,this.minFilter=ni,this.wrapR=tr,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var _e=class n{static{this.prototype.isMatrix4=!0}constructor(t,e,i,s,r,o,a,c,l,u,h,d,f,p,_,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,c,l,u,h,d,f,p,_,m)}set(t,e,i,s,r,o,a,c,l,u,h,d,f,p,_,m){let g=this.elements;return g[0]=t,g[4]=e,g[8]=i,g[12]=s,g[1]=r,g[5]=o,g[9]=a,g[13]=c,g[2]=l,g[6]=u,g[10]=h,g[14]=d,g[3]=f,g[7]=p,g[11]=_,g[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],e[9]=i[9],e[10]=i[10],e[11]=i[11],e[12]=i[12],e[13]=i[13],e[14]=i[14],e[15]=i[15],this}copyPosition(t){let e=this.elements,i=t.elements;return e[12]=i[12],e[13]=i[13],e[14]=i[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,i){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),i.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(t,e,i){return this.set(t.x,e.x,i.x,0,t.y,e.y,i.y,0,t.z,e.z,i.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,i=t.elements,s=1/Ma.setFromMatrixColumn(t,0).length(),r=1/Ma.setFromMatrixColumn(t,1).length(),o=1/Ma.setFromMatrixColumn(t,2).length();return e[0]=i[0]*s,e[1]=i[1]*s,e[2]=i[2]*s,e[3]=0,e[4]=i[4]*r,e[5]=i[5]*r,e[6]=i[6]*r,e[7]=0,e[8]=i[8]*o,e[9]=i[9]*o,e[10]=i[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,i=t.x,s=t.y,r=t.z,o=Math.cos(i),a=Math.sin(i),c=Math.cos(s),l=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(t.order==="XYZ"){let d=o*u,f=o*h,p=a*u,_=a*h;e[0]=c*u,e[4]=-c*h,e[8]=l,e[1]=f+p*l,e[5]=d-_*l,e[9]=-a*c,e[2]=_-d*l,e[6]=p+f*l,e[10]=o*c}else if(t.order==="YXZ"){let d=c*u,f=c*h,p=l*u,_=l*h;e[0]=d+_*a,e[4]=p*a-f,e[8]=o*l,e[1]=o*h,e[5]=o*u,e[9]=-a,e[2]=f*a-p,e[6]=_+d*a,e[10]=o*c}else if(t.order==="ZXY"){let d=c*u,f=c*h,p=l*u,_=l*h;e[0]=d-_*a,e[4]=-o*h,e[8]=p+f*a,e[1]=f+p*a,e[5]=o*u,e[9]=_-d*a,e[2]=-o*l,e[6]=a,e[10]=o*c}else if(t.order==="ZYX"){let d=o*u,f=o*h,p=a*u,_=a*h;e[0]=c*u,e[4]=p*l-f,e[8]=d*l+_,e[1]=c*h,e[5]=_*l+d,e[9]=f*l-p,e[2]=-l,e[6]=a*c,e[10]=o*c}else if(t.order==="YZX"){let d=o*c,f=o*l,p=a*c,_=a*l;e[0]=c*u,e[4]=_-d*h,e[8]=p*h+f,e[1]=h,e[5]=o*u,e[9]=-a*u,e[2]=-l*u,e[6]=f*h+p,e[10]=d-_*h}else if(t.order==="XZY"){let d=o*c,f=o*l,p=a*c,_=a*l;e[0]=c*u,e[4]=-h,e[8]=l*u,e[1]=d*h+_,e[5]=o*u,e[9]=f*h-p,e[2]=p*h-f,e[6]=a*u,e[10]=_*h+d}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(cE,t,uE)}lookAt(t,e,i){let s=this.elements;return Ji.subVectors(t,e),Ji.lengthSq()===0&&(Ji.z=1),Ji.normalize(),Zr.crossVectors(i,Ji),Zr.lengthSq()===0&&(Math.abs(i.z)===1?Ji.x+=1e-4:Ji.z+=1e-4,Ji.normalize(),Zr.crossVectors(i,Ji)),Zr.normalize(),zu.crossVectors(Ji,Zr),s[0]=Zr.x,s[4]=zu.x,s[8]=Ji.x,s[1]=Zr.y,s[5]=zu.y,s[9]=Ji.y,s[2]=Zr.z,s[6]=zu.z,s[10]=Ji.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[4],c=i[8],l=i[12],u=i[1],h=i[5],d=i[9],f=i[13],p=i[2],_=i[6],m=i[10],g=i[14],x=i[3],S=i[7],v=i[11],A=i[15],w=s[0],y=s[4],E=s[8],U=s[12],L=s[1],N=s[5],H=s[9],$=s[13],P=s[2],z=s[6],D=s[10],B=s[14],Q=s[3],Y=s[7],Z=s[11],nt=s[15];return r[0]=o*w+a*L+c*P+l*Q,r[4]=o*y+a*N+c*z+l*Y,r[8]=o*E+a*H+c*D+l*Z,r[12]=o*U+a*$+c*B+l*nt,r[1]=u*w+h*L+d*P+f*Q,r[5]=u*y+h*N+d*z+f*Y,r[9]=u*E+h*H+d*D+f*Z,r[13]=u*U+h*$+d*B+f*nt,r[2]=p*w+_*L+m*P+g*Q,r[6]=p*y+_*N+m*z+g*Y,r[10]=p*E+_*H+m*D+g*Z,r[14]=p*U+_*$+m*B+g*nt,r[3]=x*w+S*L+v*P+A*Q,r[7]=x*y+S*N+v*z+A*Y,r[11]=x*E+S*H+v*D+A*Z,r[15]=x*U+S*$+v*B+A*nt,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[12],o=t[1],a=t[5],c=t[9],l=t[13],u=t[2],h=t[6],d=t[10],f=t[14],p=t[3],_=t[7],m=t[11],g=t[15],x=c*f-l*d,S=a*f-l*h,v=a*d-c*h,A=o*f-l*u,w=o*d-c*u,y=o*h-a*u;return e*(_*x-m*S+g*v)-i*(p*x-m*A+g*w)+s*(p*S-_*A+g*y)-r*(p*v-_*w+m*y)}determinantAffine(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[1],o=t[5],a=t[9],c=t[2],l=t[6],u=t[10];return e*(o*u-a*l)-i*(r*u-a*c)+s*(r*l-o*c)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,i){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=i),this}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],c=t[6],l=t[7],u=t[8],h=t[9],d=t[10],f=t[11],p=t[12],_=t[13],m=t[14],g=t[15],x=e*a-i*o,S=e*c-s*o,v=e*l-r*o,A=i*c-s*a,w=i*l-r*a,y=s*l-r*c,E=u*_-h*p,U=u*m-d*p,L=u*g-f*p,N=h*m-d*_,H=h*g-f*_,$=d*g-f*m,P=x*$-S*H+v*N+A*L-w*U+y*E;if(P===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let z=1/P;return t[0]=(a*$-c*H+l*N)*z,t[1]=(s*H-i*$-r*N)*z,t[2]=(_*y-m*w+g*A)*z,t[3]=(d*w-h*y-f*A)*z,t[4]=(c*L-o*$-l*U)*z,t[5]=(e*$-s*L+r*U)*z,t[6]=(m*v-p*y-g*S)*z,t[7]=(u*y-d*v+f*S)*z,t[8]=(o*H-a*L+l*E)*z,t[9]=(i*L-e*H-r*E)*z,t[10]=(p*w-_*v+g*x)*z,t[11]=(h*v-u*w-f*x)*z,t[12]=(a*U-o*N-c*E)*z,t[13]=(e*N-i*U+s*E)*z,t[14]=(_*S-p*A-m*x)*z,t[15]=(u*A-h*S+d*x)*z,this}scale(t){let e=this.elements,i=t.x,s=t.y,r=t.z;return e[0]*=i,e[4]*=s,e[8]*=r,e[1]*=i,e[5]*=s,e[9]*=r,e[2]*=i,e[6]*=s,e[10]*=r,e[3]*=i,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],i=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,i,s))}makeTranslation(t,e,i){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,i,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),i=Math.sin(t);return this.set(1,0,0,0,0,e,-i,0,0,i,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,0,i,0,0,1,0,0,-i,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,0,i,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let i=Math.cos(e),s=Math.sin(e),r=1-i,o=t.x,a=t.y,c=t.z,l=r*o,u=r*a;return this.set(l*o+i,l*a-s*c,l*c+s*a,0,l*a+s*c,u*a+i,u*c-s*o,0,l*c-s*a,u*c+s*o,r*c*c+i,0,0,0,0,1),this}makeScale(t,e,i){return this.set(t,0,0,0,0,e,0,0,0,0,i,0,0,0,0,1),this}makeShear(t,e,i,s,r,o){return this.set(1,i,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,i){let s=this.elements,r=e._x,o=e._y,a=e._z,c=e._w,l=r+r,u=o+o,h=a+a,d=r*l,f=r*u,p=r*h,_=o*u,m=o*h,g=a*h,x=c*l,S=c*u,v=c*h,A=i.x,w=i.y,y=i.z;return s[0]=(1-(_+g))*A,s[1]=(f+v)*A,s[2]=(p-S)*A,s[3]=0,s[4]=(f-v)*w,s[5]=(1-(d+g))*w,s[6]=(m+x)*w,s[7]=0,s[8]=(p+S)*y,s[9]=(m-x)*y,s[10]=(1-(d+_))*y,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,i){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),e.identity(),this;let o=Ma.set(s[0],s[1],s[2]).length(),a=Ma.set(s[4],s[5],s[6]).length(),c=Ma.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Ts.copy(this);let l=1/o,u=1/a,h=1/c;return Ts.elements[0]*=l,Ts.elements[1]*=l,Ts.elements[2]*=l,Ts.elements[4]*=u,Ts.elements[5]*=u,Ts.elements[6]*=u,Ts.elements[8]*=h,Ts.elements[9]*=h,Ts.elements[10]*=h,e.setFromRotationMatrix(Ts),i.x=o,i.y=a,i.z=c,this}makePerspective(t,e,i,s,r,o,a=hs,c=!1){let l=this.elements,u=2*r/(e-t),h=2*r/(i-s),d=(e+t)/(e-t),f=(i+s)/(i-s),p,_;if(c)p=r/(o-r),_=o*r/(o-r);else if(a===hs)p=-(o+r)/(o-r),_=-2*o*r/(o-r);else if(a===uc)p=-o/(o-r),_=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return l[0]=u,l[4]=0,l[8]=d,l[12]=0,l[1]=0,l[5]=h,l[9]=f,l[13]=0,l[2]=0,l[6]=0,l[10]=p,l[14]=_,l[3]=0,l[7]=0,l[11]=-1,l[15]=0,this}makeOrthographic(t,e,i,s,r,o,a=hs,c=!1){let l=this.elements,u=2/(e-t),h=2/(i-s),d=-(e+t)/(e-t),f=-(i+s)/(i-s),p,_;if(c)p=1/(o-r),_=o/(o-r);else if(a===hs)p=-2/(o-r),_=-(o+r)/(o-r);else if(a===uc)p=-1/(o-r),_=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return l[0]=u,l[4]=0,l[8]=0,l[12]=d,l[1]=0,l[5]=h,l[9]=0,l[13]=f,l[2]=0,l[6]=0,l[10]=p,l[14]=_,l[3]=0,l[7]=0,l[11]=0,l[15]=1,this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<16;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<16;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t[e+9]=i[9],t[e+10]=i[10],t[e+11]=i[11],t[e+12]=i[12],t[e+13]=i[13],t[e+14]=i[14],t[e+15]=i[15],t}},Ma=new G,Ts=new _e,cE=new G(0,0,0),uE=new G(1,1,1),Zr=new G,zu=new G,Ji=new G,d_=new _e,f_=new fn,no=class n{constructor(t=0,e=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=i,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,i,s=this._order){return this._x=t,this._y=e,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,i=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],c=s[1],l=s[5],u=s[9],h=s[2],d=s[6],f=s[10];switch(e){case"XYZ":this._y=Math.asin(Ae(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,l),this._z=0);break;case"YXZ":this._x=Math.asin(-Ae(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(c,l)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(Ae(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-h,f),this._z=Math.atan2(-o,l)):(this._y=0,this._z=Math.atan2(c,r));break;case"ZYX":this._y=Math.asin(-Ae(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(c,r)):(this._x=0,this._z=Math.atan2(-o,l));break;case"YZX":this._z=Math.asin(Ae(c,-1,1)),Math.abs(c)<.9999999?(this._x=Math.atan2(-u,l),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-Ae(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,l),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,f),this._y=0);break;default:ie("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,i===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,i){return d_.makeRotationFromQuaternion(t),this.setFromRotationMatrix(d_,e,i)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return f_.setFromEuler(this),this.setFromQuaternion(f_,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};no.DEFAULT_ORDER="XYZ";var za=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},hE=0,p_=new G,Sa=new fn,br=new _e,Hu=new G,Jl=new G,dE=new G,fE=new fn,m_=new G(1,0,0),g_=new G(0,1,0),x_=new G(0,0,1),__={type:"added"},pE={type:"removed"},wa={type:"childadded",child:null},Wp={type:"childremoved",child:null},ki=class n extends Cs{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:hE++}),this.uuid=co(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let t=new G,e=new no,i=new fn,s=new G(1,1,1);function r(){i.setFromEuler(e,!1)}function o(){e.setFromQuaternion(i,void 0,!1)}e._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new _e},normalMatrix:{value:new he}}),this.matrix=new _e,this.matrixWorld=new _e,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new za,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return Sa.setFromAxisAngle(t,e),this.quaternion.multiply(Sa),this}rotateOnWorldAxis(t,e){return Sa.setFromAxisAngle(t,e),this.quaternion.premultiply(Sa),this}rotateX(t){return this.rotateOnAxis(m_,t)}rotateY(t){return this.rotateOnAxis(g_,t)}rotateZ(t){return this.rotateOnAxis(x_,t)}translateOnAxis(t,e){return p_.copy(t).applyQuaternion(this.quaternion),this.position.add(p_.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(m_,t)}translateY(t){return this.translateOnAxis(g_,t)}translateZ(t){return this.translateOnAxis(x_,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(br.copy(this.matrixWorld).invert())}lookAt(t,e,i){t.isVector3?Hu.copy(t):Hu.set(t,e,i);let s=this.parent;this.updateWorldMatrix(!0,!1),Jl.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?br.lookAt(Jl,Hu,this.up):br.lookAt(Hu,Jl,this.up),this.quaternion.setFromRotationMatrix(br),s&&(br.extractRotation(s.matrixWorld),Sa.setFromRotationMatrix(br),this.quaternion.premultiply(Sa.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(le("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(__),wa.child=t,this.dispatchEvent(wa),wa.child=null):le("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(pE),Wp.child=t,this.dispatchEvent(Wp),Wp.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),br.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),br.multiply(t.parent.matrixWorld)),t.applyMatrix4(br),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(__),wa.child=t,this.dispatchEvent(wa),wa.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,i=[]){this[t]===e&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,i);return i}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Jl,t,dE),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Jl,fE,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,i=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*i-r[8]*s,r[13]+=i-r[1]*e-r[5]*i-r[9]*s,r[14]+=s-r[2]*e-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].updateMatrixWorld(t)}updateWorldMatrix(t,e,i=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(t){let e=t===void 0||typeof t=="string",i={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,c){return a[c.uuid]===void 0&&(a[c.uuid]=c.toJSON(t)),c.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let c=a.shapes;if(Array.isArray(c))for(let l=0,u=c.length;l<u;l++){let h=c[l];r(t.shapes,h)}else r(t.shapes,c)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let c=0,l=this.material.length;c<l;c++)a.push(r(t.materials,this.material[c]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let c=this.animations[a];s.animations.push(r(t.animations,c))}}if(e){let a=o(t.geometries),c=o(t.materials),l=o(t.textures),u=o(t.images),h=o(t.shapes),d=o(t.skeletons),f=o(t.animations),p=o(t.nodes);a.length>0&&(i.geometries=a),c.length>0&&(i.materials=c),l.length>0&&(i.textures=l),u.length>0&&(i.images=u),h.length>0&&(i.shapes=h),d.length>0&&(i.skeletons=d),f.length>0&&(i.animations=f),p.length>0&&(i.nodes=p)}return i.object=s,i;function o(a){let c=[];for(let l in a){let u=a[l];delete u.metadata,c.push(u)}return c}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let i=0;i<t.children.length;i++){let s=t.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};ki.DEFAULT_UP=new G(0,1,0);ki.DEFAULT_MATRIX_AUTO_UPDATE=!0;ki.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Rn=class extends ki{constructor(){super(),this.isGroup=!0,this.type="Group"}},mE={type:"move"},Ha=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Rn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Rn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new G,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new G),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Rn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new G,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new G,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let i of t.hand.values())this._getHandJoint(e,i)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,i){let s=null,r=null,o=null,a=this._targetRay,c=this._grip,l=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(l&&t.hand){o=!0;for(let _ of t.hand.values()){let m=e.getJointPose(_,i),g=this._getHandJoint(l,_);m!==null&&(g.matrix.fromArray(m.transform.matrix),g.matrix.decompose(g.position,g.quaternion,g.scale),g.matrixWorldNeedsUpdate=!0,g.jointRadius=m.radius),g.visible=m!==null}let u=l.joints["index-finger-tip"],h=l.joints["thumb-tip"],d=u.position.distanceTo(h.position),f=.02,p=.005;l.inputState.pinching&&d>f+p?(l.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!l.inputState.pinching&&d<=f-p&&(l.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else c!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,i),r!==null&&(c.matrix.fromArray(r.transform.matrix),c.matrix.decompose(c.position,c.quaternion,c.scale),c.matrixWorldNeedsUpdate=!0,r.linearVelocity?(c.hasLinearVelocity=!0,c.linearVelocity.copy(r.linearVelocity)):c.hasLinearVelocity=!1,r.angularVelocity?(c.hasAngularVelocity=!0,c.angularVelocity.copy(r.angularVelocity)):c.hasAngularVelocity=!1,c.eventsEnabled&&c.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(mE)))}return a!==null&&(a.visible=s!==null),c!==null&&(c.visible=r!==null),l!==null&&(l.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let i=new Rn;i.matrixAutoUpdate=!1,i.visible=!1,t.joints[e.jointName]=i,t.add(i)}return t.joints[e.jointName]}},My={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Jr={h:0,s:0,l:0},Gu={h:0,s:0,l:0};function $p(n,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?n+(t-n)*6*e:e<1/2?t:e<2/3?n+(t-n)*6*(2/3-e):n}var ee=class{constructor(t,e,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,i)}set(t,e,i){if(e===void 0&&i===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,i);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=Ei){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,De.colorSpaceToWorking(this,e),this}setRGB(t,e,i,s=De.workingColorSpace){return this.r=t,this.g=e,this.b=i,De.colorSpaceToWorking(this,s),this}setHSL(t,e,i,s=De.workingColorSpace){if(t=Vm(t,1),e=Ae(e,0,1),i=Ae(i,0,1),e===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+e):i+e-i*e,o=2*i-r;this.r=$p(o,r,t+1/3),this.g=$p(o,r,t),this.b=$p(o,r,t-1/3)}return De.colorSpaceToWorking(this,s),this}setStyle(t,e=Ei){function i(r){r!==void 0&&parseFloat(r)<1&&ie("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:ie("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);ie("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=Ei){let i=My[t.toLowerCase()];return i!==void 0?this.setHex(i,e):ie("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=Tr(t.r),this.g=Tr(t.g),this.b=Tr(t.b),this}copyLinearToSRGB(t){return this.r=Ua(t.r),this.g=Ua(t.g),this.b=Ua(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=Ei){return De.workingToColorSpace(di.copy(this),t),Math.round(Ae(di.r*255,0,255))*65536+Math.round(Ae(di.g*255,0,255))*256+Math.round(Ae(di.b*255,0,255))}getHexString(t=Ei){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=De.workingColorSpace){De.workingToColorSpace(di.copy(this),e);let i=di.r,s=di.g,r=di.b,o=Math.max(i,s,r),a=Math.min(i,s,r),c,l,u=(a+o)/2;if(a===o)c=0,l=0;else{let h=o-a;switch(l=u<=.5?h/(o+a):h/(2-o-a),o){case i:c=(s-r)/h+(s<r?6:0);break;case s:c=(r-i)/h+2;break;case r:c=(i-s)/h+4;break}c/=6}return t.h=c,t.s=l,t.l=u,t}getRGB(t,e=De.workingColorSpace){return De.workingToColorSpace(di.copy(this),e),t.r=di.r,t.g=di.g,t.b=di.b,t}getStyle(t=Ei){De.workingToColorSpace(di.copy(this),t);let e=di.r,i=di.g,s=di.b;return t!==Ei?`color(${t} ${e.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(t,e,i){return this.getHSL(Jr),this.setHSL(Jr.h+t,Jr.s+e,Jr.l+i)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,i){return this.r=t.r+(e.r-t.r)*i,this.g=t.g+(e.g-t.g)*i,this.b=t.b+(e.b-t.b)*i,this}lerpHSL(t,e){this.getHSL(Jr),t.getHSL(Gu);let i=oc(Jr.h,Gu.h,e),s=oc(Jr.s,Gu.s,e),r=oc(Jr.l,Gu.l,e);return this.setHSL(i,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,i=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*i+r[6]*s,this.g=r[1]*e+r[4]*i+r[7]*s,this.b=r[2]*e+r[5]*i+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},di=new ee;ee.NAMES=My;var pc=class n{constructor(t,e=1,i=1e3){this.isFog=!0,this.name="",this.color=new ee(t),this.near=e,this.far=i}clone(){return new n(this.color,this.near,this.far)}toJSON(){return{type:"Fog",name:this.name,color:this.color.getHex(),near:this.near,far:this.far}}},mc=class extends ki{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new no,this.environmentIntensity=1,this.environmentRotation=new no,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},As=new G,Mr=new G,qp=new G,Sr=new G,Ea=new G,Ta=new G,y_=new G,Xp=new G,Yp=new G,jp=new G,Zp=new bn,Jp=new bn,Kp=new bn,eo=class n{constructor(t=new G,e=new G,i=new G){this.a=t,this.b=e,this.c=i}static getNormal(t,e,i,s){s.subVectors(i,e),As.subVectors(t,e),s.cross(As);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,i,s,r){As.subVectors(s,e),Mr.subVectors(i,e),qp.subVectors(t,e);let o=As.dot(As),a=As.dot(Mr),c=As.dot(qp),l=Mr.dot(Mr),u=Mr.dot(qp),h=o*l-a*a;if(h===0)return r.set(0,0,0),null;let d=1/h,f=(l*c-a*u)*d,p=(o*u-a*c)*d;return r.set(1-f-p,p,f)}static containsPoint(t,e,i,s){return this.getBarycoord(t,e,i,s,Sr)===null?!1:Sr.x>=0&&Sr.y>=0&&Sr.x+Sr.y<=1}static getInterpolation(t,e,i,s,r,o,a,c){return this.getBarycoord(t,e,i,s,Sr)===null?(c.x=0,c.y=0,"z"in c&&(c.z=0),"w"in c&&(c.w=0),null):(c.setScalar(0),c.addScaledVector(r,Sr.x),c.addScaledVector(o,Sr.y),c.addScaledVector(a,Sr.z),c)}static getInterpolatedAttribute(t,e,i,s,r,o){return Zp.setScalar(0),Jp.setScalar(0),Kp.setScalar(0),Zp.fromBufferAttribute(t,e),Jp.fromBufferAttribute(t,i),Kp.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(Zp,r.x),o.addScaledVector(Jp,r.y),o.addScaledVector(Kp,r.z),o}static isFrontFacing(t,e,i,s){return As.subVectors(i,e),Mr.subVectors(t,e),As.cross(Mr).dot(s)<0}set(t,e,i){return this.a.copy(t),this.b.copy(e),this.c.copy(i),this}setFromPointsAndIndices(t,e,i,s){return this.a.copy(t[e]),this.b.copy(t[i]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,i,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,i),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return As.subVectors(this.c,this.b),Mr.subVectors(this.a,this.b),As.cross(Mr).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return n.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return n.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,i,s,r){return n.getInterpolation(t,this.a,this.b,this.c,e,i,s,r)}containsPoint(t){return n.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return n.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let i=this.a,s=this.b,r=this.c,o,a;Ea.subVectors(s,i),Ta.subVectors(r,i),Xp.subVectors(t,i);let c=Ea.dot(Xp),l=Ta.dot(Xp);if(c<=0&&l<=0)return e.copy(i);Yp.subVectors(t,s);let u=Ea.dot(Yp),h=Ta.dot(Yp);if(u>=0&&h<=u)return e.copy(s);let d=c*h-u*l;if(d<=0&&c>=0&&u<=0&&c-u>0)return o=c/(c-u),e.copy(i).addScaledVector(Ea,o);jp.subVectors(t,r);let f=Ea.dot(jp),p=Ta.dot(jp);if(p>=0&&f<=p)return e.copy(r);let _=f*l-c*p;if(_<=0&&l>=0&&p<=0)return a=l/(l-p),e.copy(i).addScaledVector(Ta,a);let m=u*p-f*h;if(m<=0&&h-u>=0&&f-p>=0)return y_.subVectors(r,s),a=(h-u)/(h-u+(f-p)),e.copy(s).addScaledVector(y_,a);let g=1/(m+_+d);return o=_*g,a=d*g,e.copy(i).addScaledVector(Ea,o).addScaledVector(Ta,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},zi=class{constructor(t=new G(1/0,1/0,1/0),e=new G(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e+=3)this.expandByPoint(Rs.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,i=t.count;e<i;e++)this.expandByPoint(Rs.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let i=Rs.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(i),this.max.copy(t).add(i),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let i=t.geometry;if(i!==void 0){let r=i.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,Rs):Rs.fromBufferAttribute(r,o),Rs.applyMatrix4(t.matrixWorld),this.expandByPoint(Rs);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),Vu.copy(t.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),Vu.copy(i.boundingBox)),Vu.applyMatrix4(t.matrixWorld),this.union(Vu)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Rs),Rs.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,i;return t.normal.x>0?(e=t.normal.x*this.min.x,i=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,i=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,i+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,i+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,i+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,i+=t.normal.z*this.min.z),e<=-t.constant&&i>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(Kl),Wu.subVectors(this.max,Kl),Aa.subVectors(t.a,Kl),Ra.subVectors(t.b,Kl),Ca.subVectors(t.c,Kl),Kr.subVectors(Ra,Aa),Qr.subVectors(Ca,Ra),Lo.subVectors(Aa,Ca);let e=[0,-Kr.z,Kr.y,0,-Qr.z,Qr.y,0,-Lo.z,Lo.y,Kr.z,0,-Kr.x,Qr.z,0,-Qr.x,Lo.z,0,-Lo.x,-Kr.y,Kr.x,0,-Qr.y,Qr.x,0,-Lo.y,Lo.x,0];return!Qp(e,Aa,Ra,Ca,Wu)||(e=[1,0,0,0,1,0,0,0,1],!Qp(e,Aa,Ra,Ca,Wu))?!1:($u.crossVectors(Kr,Qr),e=[$u.x,$u.y,$u.z],Qp(e,Aa,Ra,Ca,Wu))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Rs).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Rs).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(wr[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),wr[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),wr[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),wr[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),wr[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),wr[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),wr[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),wr[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(wr),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},wr=[new G,new G,new G,new G,new G,new G,new G,new G],Rs=new G,Vu=new zi,Aa=new G,Ra=new G,Ca=new G,Kr=new G,Qr=new G,Lo=new G,Kl=new G,Wu=new G,$u=new G,Do=new G;function Qp(n,t,e,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){Do.fromArray(n,r);let a=s.x*Math.abs(Do.x)+s.y*Math.abs(Do.y)+s.z*Math.abs(Do.z),c=t.dot(Do),l=e.dot(Do),u=i.dot(Do);if(Math.max(-Math.max(c,l,u),Math.min(c,l,u))>a)return!1}return!0}var Fn=new G,qu=new Qt,gE=0,He=class extends Cs{constructor(t,e,i=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:gE++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=i,this.usage=Hm,this.updateRanges=[],this.gpuType=ds,this.version=0,this._normalizationScale=t!==void 0?Ld(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,i){t*=this.itemSize,i*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[i+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,i=this.count;e<i;e++)qu.fromBufferAttribute(this,e),qu.applyMatrix3(t),this.setXY(e,qu.x,qu.y);else if(this.itemSize===3)for(let e=0,i=this.count;e<i;e++)Fn.fromBufferAttribute(this,e),Fn.applyMatrix3(t),this.setXYZ(e,Fn.x,Fn.y,Fn.z);return this}applyMatrix4(t){for(let e=0,i=this.count;e<i;e++)Fn.fromBufferAttribute(this,e),Fn.applyMatrix4(t),this.setXYZ(e,Fn.x,Fn.y,Fn.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)Fn.fromBufferAttribute(this,e),Fn.applyNormalMatrix(t),this.setXYZ(e,Fn.x,Fn.y,Fn.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)Fn.fromBufferAttribute(this,e),Fn.transformDirection(t),this.setXYZ(e,Fn.x,Fn.y,Fn.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let i=this.array[t*this.itemSize+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.array[t*this.itemSize+e]=i,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,i){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.array[t+0]=e,this.array[t+1]=i,this}setXYZ(t,e,i,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):$m(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):qm(t,this.array)}};var gc=class extends He{constructor(t,e,i){super(new Uint16Array(t),e,i)}};var xc=class extends He{constructor(t,e,i){super(new Uint32Array(t),e,i)}};var ve=class extends He{constructor(t,e,i){super(new Float32Array(t),e,i)}},xE=new zi,Ql=new G,tm=new G,er=class{constructor(t=new G,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let i=this.center;e!==void 0?i.copy(e):xE.setFromPoints(t).getCenter(i);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,i.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let i=this.center.distanceToSquared(t);return e.copy(t),i>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;Ql.subVectors(t,this.center);let e=Ql.lengthSq();if(e>this.radius*this.radius){let i=Math.sqrt(e),s=(i-this.radius)*.5;this.center.addScaledVector(Ql,s/i),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(tm.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(Ql.copy(t.center).add(tm)),this.expandByPoint(Ql.copy(t.center).sub(tm))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},_E=0,us=new _e,em=new ki,Pa=new G,Ki=new zi,tc=new zi,ei=new G,be=class n extends Cs{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:_E++}),this.uuid=co(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(V1(t)?xc:gc)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,i=0){this.groups.push({start:t,count:e,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new he().getNormalMatrix(t);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return us.makeRotationFromQuaternion(t),this.applyMatrix4(us),this}rotateX(t){return us.makeRotationX(t),this.applyMatrix4(us),this}rotateY(t){return us.makeRotationY(t),this.applyMatrix4(us),this}rotateZ(t){return us.makeRotationZ(t),this.applyMatrix4(us),this}translate(t,e,i){return us.makeTranslation(t,e,i),this.applyMatrix4(us),this}scale(t,e,i){return us.makeScale(t,e,i),this.applyMatrix4(us),this}lookAt(t){return em.lookAt(t),em.updateMatrix(),this.applyMatrix4(em.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Pa).negate(),this.translate(Pa.x,Pa.y,Pa.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let i=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new ve(i,3))}else{let i=Math.min(t.length,e.count);for(let s=0;s<i;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&ie("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new zi);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){le("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new G(-1/0,-1/0,-1/0),new G(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let i=0,s=e.length;i<s;i++){let r=e[i];Ki.setFromBufferAttribute(r),this.morphTargetsRelative?(ei.addVectors(this.boundingBox.min,Ki.min),this.boundingBox.expandByPoint(ei),ei.addVectors(this.boundingBox.max,Ki.max),this.boundingBox.expandByPoint(ei)):(this.boundingBox.expandByPoint(Ki.min),this.boundingBox.expandByPoint(Ki.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&le('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new er);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){le("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new G,1/0);return}if(t){let i=this.boundingSphere.center;if(Ki.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];tc.setFromBufferAttribute(a),this.morphTargetsRelative?(ei.addVectors(Ki.min,tc.min),Ki.expandByPoint(ei),ei.addVectors(Ki.max,tc.max),Ki.expandByPoint(ei)):(Ki.expandByPoint(tc.min),Ki.expandByPoint(tc.max))}Ki.getCenter(i);let s=0;for(let r=0,o=t.count;r<o;r++)ei.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(ei));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],c=this.morphTargetsRelative;for(let l=0,u=a.count;l<u;l++)ei.fromBufferAttribute(a,l),c&&(Pa.fromBufferAttribute(t,l),ei.add(Pa)),s=Math.max(s,i.distanceToSquared(ei))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&le('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){le("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new He(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],c=[],l=new Uint8Array(i.count);for(let U=0;U<i.count;U++)a[U]=new G,c[U]=new G;let u=new G,h=new G,d=new G,f=new Qt,p=new Qt,_=new Qt,m=new G,g=new G;function x(U,L,N){l[U]=l[L]=l[N]=1,u.fromBufferAttribute(i,U),h.fromBufferAttribute(i,L),d.fromBufferAttribute(i,N),f.fromBufferAttribute(r,U),p.fromBufferAttribute(r,L),_.fromBufferAttribute(r,N),h.sub(u),d.sub(u),p.sub(f),_.sub(f);let H=1/(p.x*_.y-_.x*p.y);isFinite(H)&&(m.copy(h).multiplyScalar(_.y).addScaledVector(d,-p.y).multiplyScalar(H),g.copy(d).multiplyScalar(p.x).addScaledVector(h,-_.x).multiplyScalar(H),a[U].add(m),a[L].add(m),a[N].add(m),c[U].add(g),c[L].add(g),c[N].add(g))}let S=this.groups;S.length===0&&(S=[{start:0,count:t.count}]);for(let U=0,L=S.length;U<L;++U){let N=S[U],H=N.start,$=N.count;for(let P=H,z=H+$;P<z;P+=3)x(t.getX(P+0),t.getX(P+1),t.getX(P+2))}let v=new G,A=new G,w=new G,y=new G;function E(U){w.fromBufferAttribute(s,U),y.copy(w);let L=a[U];v.copy(L),v.sub(w.multiplyScalar(w.dot(L))).normalize(),A.crossVectors(y,L);let H=A.dot(c[U])<0?-1:1;o.setXYZW(U,v.x,v.y,v.z,H)}for(let U=0,L=i.count;U<L;++U)l[U]&&E(U);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==e.count)i=new He(new Float32Array(e.count*3),3),this.setAttribute("normal",i);else for(let d=0,f=i.count;d<f;d++)i.setXYZ(d,0,0,0);let s=new G,r=new G,o=new G,a=new G,c=new G,l=new G,u=new G,h=new G;if(t)for(let d=0,f=t.count;d<f;d+=3){let p=t.getX(d+0),_=t.getX(d+1),m=t.getX(d+2);s.fromBufferAttribute(e,p),r.fromBufferAttribute(e,_),o.fromBufferAttribute(e,m),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(i,p),c.fromBufferAttribute(i,_),l.fromBufferAttribute(i,m),a.add(u),c.add(u),l.add(u),i.setXYZ(p,a.x,a.y,a.z),i.setXYZ(_,c.x,c.y,c.z),i.setXYZ(m,l.x,l.y,l.z)}else for(let d=0,f=e.count;d<f;d+=3)s.fromBufferAttribute(e,d+0),r.fromBufferAttribute(e,d+1),o.fromBufferAttribute(e,d+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),i.setXYZ(d+0,u.x,u.y,u.z),i.setXYZ(d+1,u.x,u.y,u.z),i.setXYZ(d+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,i=t.count;e<i;e++)ei.fromBufferAttribute(t,e),ei.normalize(),t.setXYZ(e,ei.x,ei.y,ei.z)}toNonIndexed(){function t(a,c){let l=a.array,u=a.itemSize,h=a.normalized,d=new l.constructor(c.length*u),f=0,p=0;for(let _=0,m=c.length;_<m;_++){a.isInterleavedBufferAttribute?f=c[_]*a.data.stride+a.offset:f=c[_]*u;for(let g=0;g<u;g++)d[p++]=l[f++]}return new He(d,u,h)}if(this.index===null)return ie("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new n,i=this.index.array,s=this.attributes;for(let a in s){let c=s[a],l=t(c,i);e.setAttribute(a,l)}let r=this.morphAttributes;for(let a in r){let c=[],l=r[a];for(let u=0,h=l.length;u<h;u++){let d=l[u],f=t(d,i);c.push(f)}e.morphAttributes[a]=c}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,c=o.length;a<c;a++){let l=o[a];e.addGroup(l.start,l.count,l.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let c=this.parameters;for(let l in c)c[l]!==void 0&&(t[l]=c[l]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let i=this.attributes;for(let c in i){let l=i[c];t.data.attributes[c]=l.toJSON(t.data)}let s={},r=!1;for(let c in this.morphAttributes){let l=this.morphAttributes[c],u=[];for(let h=0,d=l.length;h<d;h++){let f=l[h];u.push(f.toJSON(t.data))}u.length>0&&(s[c]=u,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let i=t.index;i!==null&&this.setIndex(i.clone());let s=t.attributes;for(let l in s){let u=s[l];this.setAttribute(l,u.clone(e))}let r=t.morphAttributes;for(let l in r){let u=[],h=r[l];for(let d=0,f=h.length;d<f;d++)u.push(h[d].clone(e));this.morphAttributes[l]=u}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let l=0,u=o.length;l<u;l++){let h=o[l];this.addGroup(h.start,h.count,h.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let c=t.boundingSphere;return c!==null&&(this.boundingSphere=c.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},Ga=class{constructor(t,e){this.isInterleavedBuffer=!0,this.array=t,this.stride=e,this.count=t!==void 0?t.length/e:0,this.usage=Hm,this.updateRanges=[],this.version=0,this.uuid=co()}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.array=new t.array.constructor(t.array),this.count=t.count,this.stride=t.stride,this.usage=t.usage,this}copyAt(t,e,i){t*=this.stride,i*=e.stride;for(let s=0,r=this.stride;s<r;s++)this.array[t+s]=e.array[i+s];return this}set(t,e=0){return this.array.set(t,e),this}clone(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=v_(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=this.array.slice(0).buffer);let i=new this.array.constructor(t.arrayBuffers[e]),s=new this.constructor(i,this.stride);return s.setUsage(this.usage),s}onUpload(t){return this.onUploadCallback=t,this}toJSON(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=v_(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let i={uuid:this.uuid,buffer:e,type:this.array.constructor.name,stride:this.stride};return i.usage=this.usage,i}};function v_(n){return n.buffer._uuid===void 0&&(n.buffer._uuid=co()),n.byteOffset===0&&n.byteLength===n.buffer.byteLength?n.buffer._uuid:n.buffer._uuid+":"+n.byteOffset+":"+n.byteLength}var wi=new G,Va=class n{constructor(t,e,i,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=t,this.itemSize=e,this.offset=i,this.normalized=s,this._normalizationScale=t!==void 0?Ld(t.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(t){this.data.needsUpdate=t}applyMatrix4(t){for(let e=0,i=this.data.count;e<i;e++)wi.fromBufferAttribute(this,e),wi.applyMatrix4(t),this.setXYZ(e,wi.x,wi.y,wi.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)wi.fromBufferAttribute(this,e),wi.applyNormalMatrix(t),this.setXYZ(e,wi.x,wi.y,wi.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)wi.fromBufferAttribute(this,e),wi.transformDirection(t),this.setXYZ(e,wi.x,wi.y,wi.z);return this}getComponent(t,e){let i=this.array[t*this.data.stride+this.offset+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.data.array[t*this.data.stride+this.offset+e]=i,this}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset]=e,this}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+1]=e,this}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+2]=e,this}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+3]=e,this}getX(t){let e=this.data.array[t*this.data.stride+this.offset];return this.normalized&&(e=this._denormalize(e)),e}getY(t){let e=this.data.array[t*this.data.stride+this.offset+1];return this.normalized&&(e=this._denormalize(e)),e}getZ(t){let e=this.data.array[t*this.data.stride+this.offset+2];return this.normalized&&(e=this._denormalize(e)),e}getW(t){let e=this.data.array[t*this.data.stride+this.offset+3];return this.normalized&&(e=this._denormalize(e)),e}setXY(t,e,i){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.data.array[t+0]=e,this.data.array[t+1]=i,this}setXYZ(t,e,i,s){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.data.array[t+0]=e,this.data.array[t+1]=i,this.data.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.data.array[t+0]=e,this.data.array[t+1]=i,this.data.array[t+2]=s,this.data.array[t+3]=r,this}clone(t){if(t===void 0){dc("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return new He(new this.array.constructor(e),this.itemSize,this.normalized)}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.clone(t)),new n(t.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(t){if(t===void 0){dc("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:e,normalized:this.normalized}}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.toJSON(t)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):$m(t,this.data.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):qm(t,this.data.array)}},nm=new G,yE=new G,vE=new he,ri=class{constructor(t=new G(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,i,s){return this.normal.set(t,e,i),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,i){let s=nm.subVectors(i,e).cross(yE.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,i=!0){let s=t.delta(nm),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),i=this.distanceToPoint(t.end);return e<0&&i>0||i<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let i=e||vE.getNormalMatrix(t),s=this.coplanarPoint(nm).applyMatrix4(t),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},bE=0,Rr=class extends Cs{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:bE++}),this.uuid=co(),this.name="",this.type="Material",this.blending=ja,this.side=sr,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=_m,this.blendDst=ym,this.blendEquation=Ho,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new ee(0,0,0),this.blendAlpha=0,this.depthFunc=Oa,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=dy,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=dh,this.stencilZFail=dh,this.stencilZPass=dh,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let i=t[e];if(i===void 0){ie(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){ie(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(t).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(t).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(t).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(t).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(t).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let c=r[a];delete c.metadata,o.push(c)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new ee().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(i=>new ri().fromJSON(i))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let i=t.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new Qt().fromArray(i)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Qt().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,i=null;if(e!==null){let s=e.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=e[r].clone()}return this.clippingPlanes=i,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}};var Er=new G,im=new G,Xu=new G,Yu=new G,Cr=class{constructor(t=new G,e=new G(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,Er)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let i=e.dot(this.direction);return i<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=Er.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(Er.copy(this.origin).addScaledVector(this.direction,e),Er.distanceToSquared(t))}distanceSqToSegment(t,e,i,s){im.copy(t).add(e).multiplyScalar(.5),Xu.copy(e).sub(t).normalize(),Yu.copy(this.origin).sub(im);let r=t.distanceTo(e)*.5,o=-this.direction.dot(Xu),a=Yu.dot(this.direction),c=-Yu.dot(Xu),l=Yu.lengthSq(),u=Math.abs(1-o*o),h,d,f,p;if(u>0)if(h=o*c-a,d=o*a-c,p=r*u,h>=0)if(d>=-p)if(d<=p){let _=1/u;h*=_,d*=_,f=h*(h+o*d+2*a)+d*(o*h+d+2*c)+l}else d=r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*c)+l;else d=-r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*c)+l;else d<=-p?(h=Math.max(0,-(-o*r+a)),d=h>0?-r:Math.min(Math.max(-r,-c),r),f=-h*h+d*(d+2*c)+l):d<=p?(h=0,d=Math.min(Math.max(-r,-c),r),f=d*(d+2*c)+l):(h=Math.max(0,-(o*r+a)),d=h>0?r:Math.min(Math.max(-r,-c),r),f=-h*h+d*(d+2*c)+l);else d=o>0?-r:r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*c)+l;return i&&i.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(im).addScaledVector(Xu,d),f}intersectSphere(t,e){if(t.radius<0)return null;Er.subVectors(t.center,this.origin);let i=Er.dot(this.direction),s=Er.dot(Er)-i*i,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,c=i+o;return c<0?null:a<0?this.at(c,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(t.normal)+t.constant)/e;return i>=0?i:null}intersectPlane(t,e){let i=this.distanceToPlane(t);return i===null?null:this.at(i,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let i,s,r,o,a,c,l=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,d=this.origin;return l>=0?(i=(t.min.x-d.x)*l,s=(t.max.x-d.x)*l):(i=(t.max.x-d.x)*l,s=(t.min.x-d.x)*l),u>=0?(r=(t.min.y-d.y)*u,o=(t.max.y-d.y)*u):(r=(t.max.y-d.y)*u,o=(t.min.y-d.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(t.min.z-d.z)*h,c=(t.max.z-d.z)*h):(a=(t.max.z-d.z)*h,c=(t.min.z-d.z)*h),i>c||a>s)||((a>i||i!==i)&&(i=a),(c<s||s!==s)&&(s=c),s<0)?null:this.at(i>=0?i:s,e)}intersectsBox(t){return this.intersectBox(t,Er)!==null}intersectTriangle(t,e,i,s,r){let o=this.origin,a=this.direction,c=a.x,l=a.y,u=a.z,h=t.x-o.x,d=t.y-o.y,f=t.z-o.z,p=e.x-o.x,_=e.y-o.y,m=e.z-o.z,g=i.x-o.x,x=i.y-o.y,S=i.z-o.z,v=Math.abs(c),A=Math.abs(l),w=Math.abs(u),y,E,U,L,N,H,$,P,z,D,B,Q;if(v>=A&&v>=w?(U=c,H=h,z=p,Q=g,c>=0?(y=l,E=u,L=d,N=f,$=_,P=m,D=x,B=S):(y=u,E=l,L=f,N=d,$=m,P=_,D=S,B=x)):A>=w?(U=l,H=d,z=_,Q=x,l>=0?(y=u,E=c,L=f,N=h,$=m,P=p,D=S,B=g):(y=c,E=u,L=h,N=f,$=p,P=m,D=g,B=S)):(U=u,H=f,z=m,Q=S,u>=0?(y=c,E=l,L=h,N=d,$=p,P=_,D=g,B=x):(y=l,E=c,L=d,N=h,$=_,P=p,D=x,B=g)),U===0)return null;let Y=y/U,Z=E/U,nt=1/U,dt=L-Y*H,ft=N-Z*H,st=$-Y*z,yt=P-Z*z,xt=D-Y*Q,Tt=B-Z*Q,At=xt*yt-Tt*st,Jt=dt*Tt-ft*xt,ge=st*ft-yt*dt;if(s){if(At<0||Jt<0||ge<0)return null}else if((At<0||Jt<0||ge<0)&&(At>0||Jt>0||ge>0))return null;let jt=At+Jt+ge;if(jt===0)return null;let Te=nt*(At*H+Jt*z+ge*Q);return(jt>0?Te<0:Te>0)?null:this.at(Te/jt,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Vn=class extends Rr{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new ee(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new no,this.combine=vm,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},b_=new _e,No=new Cr,ju=new er,M_=new G,Zu=new G,Ju=new G,Ku=new G,sm=new G,Qu=new G,S_=new G,th=new G,Ge=class extends ki{constructor(t=new be,e=new Vn){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){Qu.set(0,0,0);for(let c=0,l=r.length;c<l;c++){let u=a[c],h=r[c];u!==0&&(sm.fromBufferAttribute(h,t),o?Qu.addScaledVector(sm,u):Qu.addScaledVector(sm.sub(e),u))}e.add(Qu)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),ju.copy(i.boundingSphere),ju.applyMatrix4(r),No.copy(t.ray).recast(t.near),!(ju.containsPoint(No.origin)===!1&&(No.intersectSphere(ju,M_)===null||No.origin.distanceToSquared(M_)>(t.far-t.near)**2))&&(b_.copy(r).invert(),No.copy(t.ray).applyMatrix4(b_),!(i.boundingBox!==null&&No.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(t,e,No)))}_computeIntersections(t,e,i){let s,r=this.geometry,o=this.material,a=r.index,c=r.attributes.position,l=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,_=d.length;p<_;p++){let m=d[p],g=o[m.materialIndex],x=Math.max(m.start,f.start),S=Math.min(a.count,Math.min(m.start+m.count,f.start+f.count));for(let v=x,A=S;v<A;v+=3){let w=a.getX(v),y=a.getX(v+1),E=a.getX(v+2);s=eh(this,g,t,i,l,u,h,w,y,E),s&&(s.faceIndex=Math.floor(v/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let p=Math.max(0,f.start),_=Math.min(a.count,f.start+f.count);for(let m=p,g=_;m<g;m+=3){let x=a.getX(m),S=a.getX(m+1),v=a.getX(m+2);s=eh(this,o,t,i,l,u,h,x,S,v),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}else if(c!==void 0)if(Array.isArray(o))for(let p=0,_=d.length;p<_;p++){let m=d[p],g=o[m.materialIndex],x=Math.max(m.start,f.start),S=Math.min(c.count,Math.min(m.start+m.count,f.start+f.count));for(let v=x,A=S;v<A;v+=3){let w=v,y=v+1,E=v+2;s=eh(this,g,t,i,l,u,h,w,y,E),s&&(s.faceIndex=Math.floor(v/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let p=Math.max(0,f.start),_=Math.min(c.count,f.start+f.count);for(let m=p,g=_;m<g;m+=3){let x=m,S=m+1,v=m+2;s=eh(this,o,t,i,l,u,h,x,S,v),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}}};function ME(n,t,e,i,s,r,o,a){let c;if(t.side===oi?c=i.intersectTriangle(o,r,s,!0,a):c=i.intersectTriangle(s,r,o,t.side===sr,a),c===null)return null;th.copy(a),th.applyMatrix4(n.matrixWorld);let l=e.ray.origin.distanceTo(th);return l<e.near||l>e.far?null:{distance:l,point:th.clone(),object:n}}function eh(n,t,e,i,s,r,o,a,c,l){n.getVertexPosition(a,Zu),n.getVertexPosition(c,Ju),n.getVertexPosition(l,Ku);let u=ME(n,t,e,i,Zu,Ju,Ku,S_);if(u){let h=new G;eo.getBarycoord(S_,Zu,Ju,Ku,h),s&&(u.uv=eo.getInterpolatedAttribute(s,a,c,l,h,new Qt)),r&&(u.uv1=eo.getInterpolatedAttribute(r,a,c,l,h,new Qt)),o&&(u.normal=eo.getInterpolatedAttribute(o,a,c,l,h,new G),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let d={a,b:c,c:l,normal:new G,materialIndex:0};eo.getNormal(Zu,Ju,Ku,d.normal),u.face=d,u.barycoord=h}return u}var _c=class extends Bi{constructor(t=null,e=1,i=1,s,r,o,a,c,l=ni,u=ni,h,d){super(null,o,a,c,l,u,s,r,h,d),this.isDataTexture=!0,this.image={data:t,width:e,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Wa=class extends He{constructor(t,e,i,s=1){super(t,e,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}toJSON(){let t=super.toJSON();return t.meshPerAttribute=this.meshPerAttribute,t.isInstancedBufferAttribute=!0,t}},Ia=new _e,w_=new _e,nh=[],E_=new zi,SE=new _e,ec=new Ge,nc=new er,yc=class extends Ge{constructor(t,e,i){super(t,e),this.isInstancedMesh=!0,this.instanceMatrix=new Wa(new Float32Array(i*16),16),this.instanceColor=null,this.morphTexture=null,this.count=i,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<i;s++)this.setMatrixAt(s,SE)}computeBoundingBox(){let t=this.geometry,e=this.count;this.boundingBox===null&&(this.boundingBox=new zi),t.boundingBox===null&&t.computeBoundingBox(),this.boundingBox.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,Ia),E_.copy(t.boundingBox).applyMatrix4(Ia),this.boundingBox.union(E_)}computeBoundingSphere(){let t=this.geometry,e=this.count;this.boundingSphere===null&&(this.boundingSphere=new er),t.boundingSphere===null&&t.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,Ia),nc.copy(t.boundingSphere).applyMatrix4(Ia),this.boundingSphere.union(nc)}copy(t,e){return super.copy(t,e),this.instanceMatrix.copy(t.instanceMatrix),this.morphTexture=t.morphTexture!==null?t.morphTexture.clone():null,this.instanceColor=t.instanceColor!==null?t.instanceColor.clone():null,this.count=t.count,this.boundingBox=t.boundingBox!==null?t.boundingBox.clone():null,this.boundingSphere=t.boundingSphere!==null?t.boundingSphere.clone():null,this}getColorAt(t,e){return this.instanceColor===null?e.setRGB(1,1,1):e.fromArray(this.instanceColor.array,t*3)}getMatrixAt(t,e){return e.fromArray(this.instanceMatrix.array,t*16)}getMorphAt(t,e){let i=e.morphTargetInfluences,s=this.morphTexture.source.data.data,r=i.length+1,o=t*r+1;for(let a=0;a<i.length;a++)i[a]=s[o+a]}raycast(t,e){let i=this.matrixWorld,s=this.count;if(ec.geometry=this.geometry,ec.material=this.material,ec.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),nc.copy(this.boundingSphere),nc.applyMatrix4(i),t.ray.intersectsSphere(nc)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,Ia),w_.multiplyMatrices(i,Ia),ec.matrixWorld=w_,ec.raycast(t,nh);for(let o=0,a=nh.length;o<a;o++){let c=nh[o];c.instanceId=r,c.object=this,e.push(c)}nh.length=0}}setColorAt(t,e){return this.instanceColor===null&&(this.instanceColor=new Wa(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),e.toArray(this.instanceColor.array,t*3),this}setMatrixAt(t,e){return e.toArray(this.instanceMatrix.array,t*16),this}setMorphAt(t,e){let i=e.morphTargetInfluences,s=i.length+1;this.morphTexture===null&&(this.morphTexture=new _c(new Float32Array(s*this.count),s,this.count,Jh,ds));let r=this.morphTexture.source.data.data,o=0;for(let l=0;l<i.length;l++)o+=i[l];let a=this.geometry.morphTargetsRelative?1:1-o,c=s*t;return r[c]=a,r.set(i,c+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},Uo=new er,wE=new Qt(.5,.5),ih=new G,Oo=class{constructor(t=new ri,e=new ri,i=new ri,s=new ri,r=new ri,o=new ri){this.planes=[t,e,i,s,r,o]}set(t,e,i,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let i=0;i<6;i++)e[i].copy(t.planes[i]);return this}setFromProjectionMatrix(t,e=hs,i=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],c=r[2],l=r[3],u=r[4],h=r[5],d=r[6],f=r[7],p=r[8],_=r[9],m=r[10],g=r[11],x=r[12],S=r[13],v=r[14],A=r[15];if(s[0].setComponents(l-o,f-u,g-p,A-x).normalize(),s[1].setComponents(l+o,f+u,g+p,A+x).normalize(),s[2].setComponents(l+a,f+h,g+_,A+S).normalize(),s[3].setComponents(l-a,f-h,g-_,A-S).normalize(),i)s[4].setComponents(c,d,m,v).normalize(),s[5].setComponents(l-c,f-d,g-m,A-v).normalize();else if(s[4].setComponents(l-c,f-d,g-m,A-v).normalize(),e===hs)s[5].setComponents(l+c,f+d,g+m,A+v).normalize();else if(e===uc)s[5].setComponents(c,d,m,v).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),Uo.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),Uo.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(Uo)}intersectsSprite(t){Uo.center.set(0,0,0);let e=wE.distanceTo(t.center);return Uo.radius=.7071067811865476+e,Uo.applyMatrix4(t.matrixWorld),this.intersectsSphere(Uo)}intersectsSphere(t){let e=this.planes,i=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let i=0;i<6;i++){let s=e[i];if(ih.x=s.normal.x>0?t.max.x:t.min.x,ih.y=s.normal.y>0?t.max.y:t.min.y,ih.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(ih)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let i=0;i<6;i++)if(e[i].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},T_=new _e,Th=class n{constructor(){this.coordinateSystem=hs,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,i=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];T_.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new Oo),i[s].setFromProjectionMatrix(T_,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,i=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new Oo),e[s].copy(i[s]);return this._count=t._count,this}clone(){return new n().copy(this)}};var ts=class extends Rr{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new ee(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},Ah=new G,Rh=new G,A_=new _e,ic=new Cr,sh=new er,rm=new G,R_=new G,nr=class extends ki{constructor(t=new be,e=new ts){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[0];for(let s=1,r=e.count;s<r;s++)Ah.fromBufferAttribute(e,s-1),Rh.fromBufferAttribute(e,s),i[s]=i[s-1],i[s]+=Ah.distanceTo(Rh);t.setAttribute("lineDistance",new ve(i,1))}else ie("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),sh.copy(i.boundingSphere),sh.applyMatrix4(s),sh.radius+=r,t.ray.intersectsSphere(sh)===!1)return;A_.copy(s).invert(),ic.copy(t.ray).applyMatrix4(A_);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),c=a*a,l=this.isLineSegments?2:1,u=i.index,d=i.attributes.position;if(u!==null){let f=Math.max(0,o.start),p=Math.min(u.count,o.start+o.count);for(let _=f,m=p-1;_<m;_+=l){let g=u.getX(_),x=u.getX(_+1),S=rh(this,t,ic,c,g,x,_);S&&e.push(S)}if(this.isLineLoop){let _=u.getX(p-1),m=u.getX(f),g=rh(this,t,ic,c,_,m,p-1);g&&e.push(g)}}else{let f=Math.max(0,o.start),p=Math.min(d.count,o.start+o.count);for(let _=f,m=p-1;_<m;_+=l){let g=rh(this,t,ic,c,_,_+1,_);g&&e.push(g)}if(this.isLineLoop){let _=rh(this,t,ic,c,p-1,f,p-1);_&&e.push(_)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function rh(n,t,e,i,s,r,o){let a=n.geometry.attributes.position;if(Ah.fromBufferAttribute(a,s),Rh.fromBufferAttribute(a,r),e.distanceSqToSegment(Ah,Rh,rm,R_)>i)return;rm.applyMatrix4(n.matrixWorld);let l=t.ray.origin.distanceTo(rm);if(!(l<t.near||l>t.far))return{distance:l,point:R_.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var C_=new G,P_=new G,Fo=class extends nr{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[];for(let s=0,r=e.count;s<r;s+=2)C_.fromBufferAttribute(e,s),P_.fromBufferAttribute(e,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+C_.distanceTo(P_);t.setAttribute("lineDistance",new ve(i,1))}else ie("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var ir=class extends Rr{constructor(t){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new ee(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.size=t.size,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},I_=new _e,um=new Cr,oh=new er,ah=new G,Pr=class extends ki{constructor(t=new be,e=new ir){super(),this.isPoints=!0,this.type="Points",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Points.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),oh.copy(i.boundingSphere),oh.applyMatrix4(s),oh.radius+=r,t.ray.intersectsSphere(oh)===!1)return;I_.copy(s).invert(),um.copy(t.ray).applyMatrix4(I_);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),c=a*a,l=i.index,h=i.attributes.position;if(l!==null){let d=Math.max(0,o.start),f=Math.min(l.count,o.start+o.count);for(let p=d,_=f;p<_;p++){let m=l.getX(p);ah.fromBufferAttribute(h,m),L_(ah,m,c,s,t,e,this)}}else{let d=Math.max(0,o.start),f=Math.min(h.count,o.start+o.count);for(let p=d,_=f;p<_;p++)ah.fromBufferAttribute(h,p),L_(ah,p,c,s,t,e,this)}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function L_(n,t,e,i,s,r,o){let a=um.distanceSqToPoint(n);if(a<e){let c=new G;um.closestPointToPoint(n,c),c.applyMatrix4(i);let l=s.ray.origin.distanceTo(c);if(l<s.near||l>s.far)return;r.push({distance:l,distanceToRay:Math.sqrt(a),point:c,index:t,face:null,faceIndex:null,barycoord:null,object:o})}}var vc=class extends Bi{constructor(t=[],e=Go,i,s,r,o,a,c,l,u){super(t,e,i,s,r,o,a,c,l,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}};var Ir=class extends Bi{constructor(t,e,i=Is,s,r,o,a=ni,c=ni,l,u=Ar,h=1){if(u!==Ar&&u!==Dr)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:t,height:e,depth:h};super(d,s,r,o,a,c,u,i,l),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new ka(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},bc=class extends Ir{constructor(t,e=Is,i=Go,s,r,o=ni,a=ni,c,l=Ar){let u={width:t,height:t,depth:1},h=[u,u,u,u,u,u];super(t,t,e,i,s,r,o,a,c,l),this.image=h,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},Mc=class extends Bi{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},Hi=class n extends be{constructor(t=1,e=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let c=[],l=[],u=[],h=[],d=0,f=0;p("z","y","x",-1,-1,i,e,t,o,r,0),p("z","y","x",1,-1,i,e,-t,o,r,1),p("x","z","y",1,1,t,i,e,s,o,2),p("x","z","y",1,-1,t,i,-e,s,o,3),p("x","y","z",1,-1,t,e,i,s,r,4),p("x","y","z",-1,-1,t,e,-i,s,r,5),this.setIndex(c),this.setAttribute("position",new ve(l,3)),this.setAttribute("normal",new ve(u,3)),this.setAttribute("uv",new ve(h,2));function p(_,m,g,x,S,v,A,w,y,E,U){let L=v/y,N=A/E,H=v/2,$=A/2,P=w/2,z=y+1,D=E+1,B=0,Q=0,Y=new G;for(let Z=0;Z<D;Z++){let nt=Z*N-$;for(let dt=0;dt<z;dt++){let ft=dt*L-H;Y[_]=ft*x,Y[m]=nt*S,Y[g]=P,l.push(Y.x,Y.y,Y.z),Y[_]=0,Y[m]=0,Y[g]=w>0?1:-1,u.push(Y.x,Y.y,Y.z),h.push(dt/y),h.push(1-Z/E),B+=1}}for(let Z=0;Z<E;Z++)for(let nt=0;nt<y;nt++){let dt=d+nt+z*Z,ft=d+nt+z*(Z+1),st=d+(nt+1)+z*(Z+1),yt=d+(nt+1)+z*Z;c.push(dt,ft,yt),c.push(ft,st,yt),Q+=6}a.addGroup(f,Q,U),f+=Q,d+=B}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}},Bo=class n extends be{constructor(t=1,e=1,i=4,s=8,r=1){super(),this.type="CapsuleGeometry",this.parameters={radius:t,height:e,capSegments:i,radialSegments:s,heightSegments:r},e=Math.max(0,e),i=Math.max(1,Math.floor(i)),s=Math.max(3,Math.floor(s)),r=Math.max(1,Math.floor(r));let o=[],a=[],c=[],l=[],u=e/2,h=Math.PI/2*t,d=e,f=2*h+d,p=i*2+r,_=s+1,m=new G,g=new G;for(let x=0;x<=p;x++){let S=0,v=0,A=0,w=0;if(x<=i){let U=x/i,L=U*Math.PI/2;v=-u-t*Math.cos(L),A=t*Math.sin(L),w=-t*Math.cos(L),S=U*h}else if(x<=i+r){let U=(x-i)/r;v=-u+U*e,A=t,w=0,S=h+U*d}else{let U=(x-i-r)/i,L=U*Math.PI/2;v=u+t*Math.sin(L),A=t*Math.cos(L),w=t*Math.sin(L),S=h+d+U*h}let y=Math.max(0,Math.min(1,S/f)),E=0;x===0?E=.5/s:x===p&&(E=-.5/s);for(let U=0;U<=s;U++){let L=U/s,N=L*Math.PI*2,H=Math.sin(N),$=Math.cos(N);g.x=-A*$,g.y=v,g.z=A*H,a.push(g.x,g.y,g.z),m.set(-A*$,w,A*H),m.normalize(),c.push(m.x,m.y,m.z),l.push(L+E,y)}if(x>0){let U=(x-1)*_;for(let L=0;L<s;L++){let N=U+L,H=U+L+1,$=x*_+L,P=x*_+L+1;o.push(N,H,$),o.push(H,P,$)}}}this.setIndex(o),this.setAttribute("position",new ve(a,3)),this.setAttribute("normal",new ve(c,3)),this.setAttribute("uv",new ve(l,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.height,t.capSegments,t.radialSegments,t.heightSegments)}},Sc=class n extends be{constructor(t=1,e=32,i=0,s=Math.PI*2){super(),this.type="CircleGeometry",this.parameters={radius:t,segments:e,thetaStart:i,thetaLength:s},e=Math.max(3,e);let r=[],o=[],a=[],c=[],l=new G,u=new Qt;o.push(0,0,0),a.push(0,0,1),c.push(.5,.5);for(let h=0,d=3;h<=e;h++,d+=3){let f=i+h/e*s;l.x=t*Math.cos(f),l.y=t*Math.sin(f),o.push(l.x,l.y,l.z),a.push(0,0,1),u.x=(o[d]/t+1)/2,u.y=(o[d+1]/t+1)/2,c.push(u.x,u.y)}for(let h=1;h<=e;h++)r.push(h,h+1,0);this.setIndex(r),this.setAttribute("position",new ve(o,3)),this.setAttribute("normal",new ve(a,3)),this.setAttribute("uv",new ve(c,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.segments,t.thetaStart,t.thetaLength)}},Ri=class n extends be{constructor(t=1,e=1,i=1,s=32,r=1,o=!1,a=0,c=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:c};let l=this;s=Math.floor(s),r=Math.floor(r);let u=[],h=[],d=[],f=[],p=0,_=[],m=i/2,g=0;x(),o===!1&&(t>0&&S(!0),e>0&&S(!1)),this.setIndex(u),this.setAttribute("position",new ve(h,3)),this.setAttribute("normal",new ve(d,3)),this.setAttribute("uv",new ve(f,2));function x(){let v=new G,A=new G,w=0,y=(e-t)/i;for(let E=0;E<=r;E++){let U=[],L=E/r,N=L*(e-t)+t;for(let H=0;H<=s;H++){let $=H/s,P=$*c+a,z=Math.sin(P),D=Math.cos(P);A.x=N*z,A.y=-L*i+m,A.z=N*D,h.push(A.x,A.y,A.z),v.set(z,y,D).normalize(),d.push(v.x,v.y,v.z),f.push($,1-L),U.push(p++)}_.push(U)}for(let E=0;E<s;E++)for(let U=0;U<r;U++){let L=_[U][E],N=_[U+1][E],H=_[U+1][E+1],$=_[U][E+1];(t>0||U!==0)&&(u.push(L,N,$),w+=3),(e>0||U!==r-1)&&(u.push(N,H,$),w+=3)}l.addGroup(g,w,0),g+=w}function S(v){let A=p,w=new Qt,y=new G,E=0,U=v===!0?t:e,L=v===!0?1:-1;for(let H=1;H<=s;H++)h.push(0,m*L,0),d.push(0,L,0),f.push(.5,.5),p++;let N=p;for(let H=0;H<=s;H++){let P=H/s*c+a,z=Math.cos(P),D=Math.sin(P);y.x=U*D,y.y=m*L,y.z=U*z,h.push(y.x,y.y,y.z),d.push(0,L,0),w.x=z*.5+.5,w.y=D*.5*L+.5,f.push(w.x,w.y),p++}for(let H=0;H<s;H++){let $=A+H,P=N+H;v===!0?u.push(P,P+1,$):u.push(P+1,P,$),E+=3}l.addGroup(g,E,v===!0?1:2),g+=E}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},ko=class n extends Ri{constructor(t=1,e=1,i=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,t,e,i,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:i,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(t){return new n(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},Ch=class n extends be{constructor(t=[],e=[],i=1,s=0){super(),this.type="PolyhedronGeometry",this.parameters={vertices:t,indices:e,radius:i,detail:s};let r=[],o=[];a(s),l(i),u(),this.setAttribute("position",new ve(r,3)),this.setAttribute("normal",new ve(r.slice(),3)),this.setAttribute("uv",new ve(o,2)),s===0?this.computeVertexNormals():this.normalizeNormals();function a(x){let S=new G,v=new G,A=new G;for(let w=0;w<e.length;w+=3)f(e[w+0],S),f(e[w+1],v),f(e[w+2],A),c(S,v,A,x)}function c(x,S,v,A){let w=A+1,y=[];for(let E=0;E<=w;E++){y[E]=[];let U=x.clone().lerp(v,E/w),L=S.clone().lerp(v,E/w),N=w-E;for(let H=0;H<=N;H++)H===0&&E===w?y[E][H]=U:y[E][H]=U.clone().lerp(L,H/N)}for(let E=0;E<w;E++)for(let U=0;U<2*(w-E)-1;U++){let L=Math.floor(U/2);U%2===0?(d(y[E][L+1]),d(y[E+1][L]),d(y[E][L])):(d(y[E][L+1]),d(y[E+1][L+1]),d(y[E+1][L]))}}function l(x){let S=new G;for(let v=0;v<r.length;v+=3)S.x=r[v+0],S.y=r[v+1],S.z=r[v+2],S.normalize().multiplyScalar(x),r[v+0]=S.x,r[v+1]=S.y,r[v+2]=S.z}function u(){let x=new G;for(let S=0;S<r.length;S+=3){x.x=r[S+0],x.y=r[S+1],x.z=r[S+2];let v=m(x)/2/Math.PI+.5,A=g(x)/Math.PI+.5;o.push(v,1-A)}p(),h()}function h(){for(let x=0;x<o.length;x+=6){let S=o[x+0],v=o[x+2],A=o[x+4],w=Math.max(S,v,A),y=Math.min(S,v,A);w>.9&&y<.1&&(S<.2&&(o[x+0]+=1),v<.2&&(o[x+2]+=1),A<.2&&(o[x+4]+=1))}}function d(x){r.push(x.x,x.y,x.z)}function f(x,S){let v=x*3;S.x=t[v+0],S.y=t[v+1],S.z=t[v+2]}function p(){let x=new G,S=new G,v=new G,A=new G,w=new Qt,y=new Qt,E=new Qt;for(let U=0,L=0;U<r.length;U+=9,L+=6){x.set(r[U+0],r[U+1],r[U+2]),S.set(r[U+3],r[U+4],r[U+5]),v.set(r[U+6],r[U+7],r[U+8]),w.set(o[L+0],o[L+1]),y.set(o[L+2],o[L+3]),E.set(o[L+4],o[L+5]),A.copy(x).add(S).add(v).divideScalar(3);let N=m(A);_(w,L+0,x,N),_(y,L+2,S,N),_(E,L+4,v,N)}}function _(x,S,v,A){A<0&&x.x===1&&(o[S]=x.x-1),v.x===0&&v.z===0&&(o[S]=A/2/Math.PI+.5)}function m(x){return Math.atan2(x.z,-x.x)}function g(x){return Math.atan2(-x.y,Math.sqrt(x.x*x.x+x.z*x.z))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.vertices,t.indices,t.radius,t.detail)}};var wc=class n extends be{constructor(t=[new Qt(0,-.5),new Qt(.5,0),new Qt(0,.5)],e=12,i=0,s=Math.PI*2){super(),this.type="LatheGeometry",this.parameters={points:t,segments:e,phiStart:i,phiLength:s},e=Math.floor(e),s=Ae(s,0,Math.PI*2);let r=[],o=[],a=[],c=[],l=[],u=1/e,h=new G,d=new Qt,f=new G,p=new G,_=new G,m=0,g=0;for(let x=0;x<=t.length-1;x++)switch(x){case 0:m=t[x+1].x-t[x].x,g=t[x+1].y-t[x].y,f.x=g*1,f.y=-m,f.z=g*0,_.copy(f),f.normalize(),c.push(f.x,f.y,f.z);break;case t.length-1:_.normalize(),c.push(_.x,_.y,_.z);break;default:m=t[x+1].x-t[x].x,g=t[x+1].y-t[x].y,f.x=g*1,f.y=-m,f.z=g*0,p.copy(f),f.x+=_.x,f.y+=_.y,f.z+=_.z,f.normalize(),c.push(f.x,f.y,f.z),_.copy(p)}for(let x=0;x<=e;x++){let S=i+x*u*s,v=Math.sin(S),A=Math.cos(S);for(let w=0;w<=t.length-1;w++){h.x=t[w].x*v,h.y=t[w].y,h.z=t[w].x*A,o.push(h.x,h.y,h.z),d.x=x/e,d.y=w/(t.length-1),a.push(d.x,d.y);let y=c[3*w+0]*v,E=c[3*w+1],U=c[3*w+0]*A;l.push(y,E,U)}}for(let x=0;x<e;x++)for(let S=0;S<t.length-1;S++){let v=S+x*t.length,A=v,w=v+t.length,y=v+t.length+1,E=v+1;r.push(A,w,E),r.push(y,E,w)}this.setIndex(r),this.setAttribute("position",new ve(o,3)),this.setAttribute("uv",new ve(a,2)),this.setAttribute("normal",new ve(l,3))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.points,t.segments,t.phiStart,t.phiLength)}},Ec=class n extends Ch{constructor(t=1,e=0){let i=[1,0,0,-1,0,0,0,1,0,0,-1,0,0,0,1,0,0,-1],s=[0,2,4,0,4,3,0,3,5,0,5,2,1,2,5,1,5,3,1,3,4,1,4,2];super(i,s,t,e),this.type="OctahedronGeometry",this.parameters={radius:t,detail:e}}static fromJSON(t){return new n(t.radius,t.detail)}},Tc=class n extends be{constructor(t=1,e=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:i,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(i),c=Math.floor(s),l=a+1,u=c+1,h=t/a,d=e/c,f=[],p=[],_=[],m=[];for(let g=0;g<u;g++){let x=g*d-o;for(let S=0;S<l;S++){let v=S*h-r;p.push(v,-x,0),_.push(0,0,1),m.push(S/a),m.push(1-g/c)}}for(let g=0;g<c;g++)for(let x=0;x<a;x++){let S=x+l*g,v=x+l*(g+1),A=x+1+l*(g+1),w=x+1+l*g;f.push(S,v,w),f.push(v,A,w)}this.setIndex(f),this.setAttribute("position",new ve(p,3)),this.setAttribute("normal",new ve(_,3)),this.setAttribute("uv",new ve(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.widthSegments,t.heightSegments)}};var Ps=class n extends be{constructor(t=1,e=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),i=Math.max(2,Math.floor(i));let c=Math.min(o+a,Math.PI),l=0,u=[],h=new G,d=new G,f=[],p=[],_=[],m=[];for(let g=0;g<=i;g++){let x=[],S=g/i,v=o+S*a,A=t*Math.cos(v),w=Math.sqrt(t*t-A*A),y=0;g===0&&o===0?y=.5/e:g===i&&c===Math.PI&&(y=-.5/e);for(let E=0;E<=e;E++){let U=E/e,L=s+U*r;h.x=-w*Math.cos(L),h.y=A,h.z=w*Math.sin(L),p.push(h.x,h.y,h.z),d.copy(h).normalize(),_.push(d.x,d.y,d.z),m.push(U+y,1-S),x.push(l++)}u.push(x)}for(let g=0;g<i;g++)for(let x=0;x<e;x++){let S=u[g][x+1],v=u[g][x],A=u[g+1][x],w=u[g+1][x+1];(g!==0||o>0)&&f.push(S,v,w),(g!==i-1||c<Math.PI)&&f.push(v,A,w)}this.setIndex(f),this.setAttribute("position",new ve(p,3)),this.setAttribute("normal",new ve(_,3)),this.setAttribute("uv",new ve(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};var $a=class n extends be{constructor(t=1,e=.4,i=12,s=48,r=Math.PI*2,o=0,a=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:t,tube:e,radialSegments:i,tubularSegments:s,arc:r,thetaStart:o,thetaLength:a},i=Math.floor(i),s=Math.floor(s);let c=[],l=[],u=[],h=[],d=new G,f=new G,p=new G;for(let _=0;_<=i;_++){let m=o+_/i*a;for(let g=0;g<=s;g++){let x=g/s*r;f.x=(t+e*Math.cos(m))*Math.cos(x),f.y=(t+e*Math.cos(m))*Math.sin(x),f.z=e*Math.sin(m),l.push(f.x,f.y,f.z),d.x=t*Math.cos(x),d.y=t*Math.sin(x),p.subVectors(f,d).normalize(),u.push(p.x,p.y,p.z),h.push(g/s),h.push(_/i)}}for(let _=1;_<=i;_++)for(let m=1;m<=s;m++){let g=(s+1)*_+m-1,x=(s+1)*(_-1)+m-1,S=(s+1)*(_-1)+m,v=(s+1)*_+m;c.push(g,x,v),c.push(x,S,v)}this.setIndex(c),this.setAttribute("position",new ve(l,3)),this.setAttribute("normal",new ve(u,3)),this.setAttribute("uv",new ve(h,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.tube,t.radialSegments,t.tubularSegments,t.arc,t.thetaStart,t.thetaLength)}};function Wo(n){let t={};for(let e in n){t[e]={};for(let i in n[e]){let s=n[e][i];if(D_(s))s.isRenderTargetTexture?(ie("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][i]=null):t[e][i]=s.clone();else if(Array.isArray(s))if(D_(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][i]=r}else t[e][i]=s.slice();else t[e][i]=s}}return t}function mi(n){let t={};for(let e=0;e<n.length;e++){let i=Wo(n[e]);for(let s in i)t[s]=i[s]}return t}function D_(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function EE(n){let t=[];for(let e=0;e<n.length;e++)t.push(n[e].clone());return t}function Xm(n){let t=n.getRenderTarget();return t===null?n.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:De.workingColorSpace}var Sy={clone:Wo,merge:mi},TE=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,AE=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,fi=class extends Rr{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=TE,this.fragmentShader=AE,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=Wo(t.uniforms),this.uniformsGroups=EE(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(e.extensions=i),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let i in t.uniforms){let s=t.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=e[s.value]||null;break;case"c":this.uniforms[i].value=new ee().setHex(s.value);break;case"v2":this.uniforms[i].value=new Qt().fromArray(s.value);break;case"v3":this.uniforms[i].value=new G().fromArray(s.value);break;case"v4":this.uniforms[i].value=new bn().fromArray(s.value);break;case"m3":this.uniforms[i].value=new he().fromArray(s.value);break;case"m4":this.uniforms[i].value=new _e().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let i in t.extensions)this.extensions[i]=t.extensions[i];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},Ph=class extends fi{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Ih=class extends Rr{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=uy,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},Lh=class extends Rr{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function La(n,t){return!n||n.constructor===t?n:typeof t.BYTES_PER_ELEMENT=="number"?new t(n):Array.prototype.slice.call(n)}function lh(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var io=class{constructor(t,e,i,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(i),this.sampleValues=e,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,i=this._cachedIndex,s=e[i],r=e[i-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=i+2;;){if(s===void 0){if(t<r)break i;return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=e[++i],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(i=2,r=a);for(let c=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===c)break;if(s=r,r=e[--i-1],t>=r)break t}o=i,i=0;break e}break n}for(;i<o;){let a=i+o>>>1;t<e[a]?o=a:i=a+1}if(s=e[i],r=e[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=i[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Dh=class extends io{constructor(t,e,i,s){super(t,e,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:am,endingEnd:am}}intervalChanged_(t,e,i){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],c=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case lm:r=t,a=2*e-i;break;case cm:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=i}if(c===void 0)switch(this.getSettings_().endingEnd){case lm:o=t,c=2*i-e;break;case cm:o=1,c=i+s[1]-s[0];break;default:o=t-1,c=e}let l=(i-e)*.5,u=this.valueSize;this._weightPrev=l/(e-a),this._weightNext=l/(c-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=t*a,l=c-a,u=this._offsetPrev,h=this._offsetNext,d=this._weightPrev,f=this._weightNext,p=(i-e)/(s-e),_=p*p,m=_*p,g=-d*m+2*d*_-d*p,x=(1+d)*m+(-1.5-2*d)*_+(-.5+d)*p+1,S=(-1-f)*m+(1.5+f)*_+.5*p,v=f*m-f*_;for(let A=0;A!==a;++A)r[A]=g*o[u+A]+x*o[l+A]+S*o[c+A]+v*o[h+A];return r}},Nh=class extends io{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=t*a,l=c-a,u=(i-e)/(s-e),h=1-u;for(let d=0;d!==a;++d)r[d]=o[l+d]*h+o[c+d]*u;return r}},Uh=class extends io{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t){return this.copySampleValue_(t-1)}},Oh=class extends io{interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=t*a,l=c-a,u=this.inTangents,h=this.outTangents;if(!u||!h){let p=(i-e)/(s-e),_=1-p;for(let m=0;m!==a;++m)r[m]=o[l+m]*_+o[c+m]*p;return r}let d=a*2,f=t-1;for(let p=0;p!==a;++p){let _=o[l+p],m=o[c+p],g=f*d+p*2,x=h[g],S=h[g+1],v=t*d+p*2,A=u[v],w=u[v+1],y=CE(i,e,x,A,s);r[p]=wy(y,_,S,w,m)}return r}};function wy(n,t,e,i,s){let r=1-n;return r*r*r*t+3*r*r*n*e+3*r*n*n*i+n*n*n*s}function RE(n,t,e,i,s){let r=1-n;return 3*r*r*(e-t)+6*r*n*(i-e)+3*n*n*(s-i)}function CE(n,t,e,i,s){let r=(n-t)/(s-t);for(let o=0;o<8;o++){let a=wy(r,t,e,i,s)-n;if(Math.abs(a)<1e-10)break;let c=RE(r,t,e,i,s);if(Math.abs(c)<1e-10)break;r=Math.max(0,Math.min(1,r-a/c))}return r}var es=class{constructor(t,e,i,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=La(e,this.TimeBufferType),this.values=La(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,i;if(e.toJSON!==this.toJSON)i=e.toJSON(t);else{i={name:t.name,times:La(t.times,Array),values:La(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(i.interpolation=s),lh(t.settings)&&(i.settings={inTangents:La(t.settings.inTangents,Array),outTangents:La(t.settings.outTangents,Array)})}return i.type=t.ValueTypeName,i}InterpolantFactoryMethodDiscrete(t){return new Uh(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new Nh(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new Dh(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new Oh(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case ac:e=this.InterpolantFactoryMethodDiscrete;break;case Mh:e=this.InterpolantFactoryMethodLinear;break;case hh:e=this.InterpolantFactoryMethodSmooth;break;case om:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return ie("KeyframeTrack:",i),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return ac;case this.InterpolantFactoryMethodLinear:return Mh;case this.InterpolantFactoryMethodSmooth:return hh;case this.InterpolantFactoryMethodBezier:return om}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]+=t;lh(this.settings)&&(N_(this.settings.inTangents,t),N_(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]*=t;lh(this.settings)&&(U_(this.settings.inTangents,t),U_(this.settings.outTangents,t))}return this}trim(t,e){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<t;)++r;for(;o!==-1&&i[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(le("KeyframeTrack: Invalid value size in track.",this),t=!1);let i=this.times,s=this.values,r=i.length;r===0&&(le("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let c=i[a];if(typeof c=="number"&&isNaN(c)){le("KeyframeTrack: Time is not a valid number.",this,a,c),t=!1;break}if(o!==null&&o>c){le("KeyframeTrack: Out of order keys.",this,a,c,o),t=!1;break}o=c}if(s!==void 0&&W1(s))for(let a=0,c=s.length;a!==c;++a){let l=s[a];if(isNaN(l)){le("KeyframeTrack: Value is not a valid number.",this,a,l),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===hh,r=t.length-1,o=1;for(let a=1;a<r;++a){let c=!1,l=t[a],u=t[a+1];if(l!==u&&(a!==1||l!==t[0]))if(s)c=!0;else{let h=a*i,d=h-i,f=h+i;for(let p=0;p!==i;++p){let _=e[h+p];if(_!==e[d+p]||_!==e[f+p]){c=!0;break}}}if(c){if(a!==o){t[o]=t[a];let h=a*i,d=o*i;for(let f=0;f!==i;++f)e[d+f]=e[h+f]}++o}}if(r>0){t[o]=t[r];for(let a=r*i,c=o*i,l=0;l!==i;++l)e[c+l]=e[a+l];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*i)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),i=this.constructor,s=new i(this.name,t,e);return s.createInterpolant=this.createInterpolant,lh(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function N_(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]+=t}function U_(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]*=t}es.prototype.ValueTypeName="";es.prototype.TimeBufferType=Float32Array;es.prototype.ValueBufferType=Float32Array;es.prototype.DefaultInterpolation=Mh;var so=class extends es{constructor(t,e,i){super(t,e,i)}};so.prototype.ValueTypeName="bool";so.prototype.ValueBufferType=Array;so.prototype.DefaultInterpolation=ac;so.prototype.InterpolantFactoryMethodLinear=void 0;so.prototype.InterpolantFactoryMethodSmooth=void 0;var Fh=class extends es{constructor(t,e,i,s){super(t,e,i,s)}};Fh.prototype.ValueTypeName="color";var Bh=class extends es{constructor(t,e,i,s){super(t,e,i,s)}};Bh.prototype.ValueTypeName="number";var kh=class extends io{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=(i-e)/(s-e),l=t*a;for(let u=l+a;l!==u;l+=4)fn.slerpFlat(r,0,o,l-a,o,l,c);return r}},Ac=class extends es{constructor(t,e,i,s){super(t,e,i,s)}InterpolantFactoryMethodLinear(t){return new kh(this.times,this.values,this.getValueSize(),t)}};Ac.prototype.ValueTypeName="quaternion";Ac.prototype.InterpolantFactoryMethodSmooth=void 0;var ro=class extends es{constructor(t,e,i){super(t,e,i)}};ro.prototype.ValueTypeName="string";ro.prototype.ValueBufferType=Array;ro.prototype.DefaultInterpolation=ac;ro.prototype.InterpolantFactoryMethodLinear=void 0;ro.prototype.InterpolantFactoryMethodSmooth=void 0;var zh=class extends es{constructor(t,e,i,s){super(t,e,i,s)}};zh.prototype.ValueTypeName="vector";var Hh=class{constructor(t,e,i){let s=this,r=!1,o=0,a=0,c,l=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),c?c(u):u},this.setURLModifier=function(u){return c=u,this},this.addHandler=function(u,h){return l.push(u,h),this},this.removeHandler=function(u){let h=l.indexOf(u);return h!==-1&&l.splice(h,2),this},this.getHandler=function(u){for(let h=0,d=l.length;h<d;h+=2){let f=l[h],p=l[h+1];if(f.global&&(f.lastIndex=0),f.test(u))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Ey=new Hh,Gh=class{constructor(t){this.manager=t!==void 0?t:Ey,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let i=this;return new Promise(function(s,r){i.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};Gh.DEFAULT_MATERIAL_NAME="__DEFAULT";var ch=new G,uh=new fn,Qs=new G,Rc=class extends ki{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new _e,this.projectionMatrix=new _e,this.projectionMatrixInverse=new _e,this.coordinateSystem=hs,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(ch,uh,Qs),Qs.x===1&&Qs.y===1&&Qs.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(ch,uh,Qs.set(1,1,1)).invert()}updateWorldMatrix(t,e,i=!1){super.updateWorldMatrix(t,e,i),this.matrixWorld.decompose(ch,uh,Qs),Qs.x===1&&Qs.y===1&&Qs.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(ch,uh,Qs.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},to=new G,O_=new Qt,F_=new Qt,Ti=class extends Rc{constructor(t=50,e=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=Ba*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(rc*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return Ba*2*Math.atan(Math.tan(rc*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,i){to.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(to.x,to.y).multiplyScalar(-t/to.z),to.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(to.x,to.y).multiplyScalar(-t/to.z)}getViewSize(t,e){return this.getViewBounds(t,O_,F_),e.subVectors(F_,O_)}setViewOffset(t,e,i,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(rc*.5*this.fov)/this.zoom,i=2*e,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let c=o.fullWidth,l=o.fullHeight;r+=o.offsetX*s/c,e-=o.offsetY*i/l,s*=o.width/c,i*=o.height/l}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-i,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var Vh=class extends Rc{constructor(t=-1,e=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-t,o=i+t,a=s+e,c=s-e;if(this.view!==null&&this.view.enabled){let l=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=l*this.view.offsetX,o=r+l*this.view.width,a-=u*this.view.offsetY,c=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,c,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}};var Da=-90,Na=1,qa=class extends ki{constructor(t,e,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Ti(Da,Na,t,e);s.layers=this.layers,this.add(s);let r=new Ti(Da,Na,t,e);r.layers=this.layers,this.add(r);let o=new Ti(Da,Na,t,e);o.layers=this.layers,this.add(o);let a=new Ti(Da,Na,t,e);a.layers=this.layers,this.add(a);let c=new Ti(Da,Na,t,e);c.layers=this.layers,this.add(c);let l=new Ti(Da,Na,t,e);l.layers=this.layers,this.add(l)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[i,s,r,o,a,c]=e;for(let l of e)this.remove(l);if(t===hs)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),c.up.set(0,1,0),c.lookAt(0,0,-1);else if(t===uc)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),c.up.set(0,-1,0),c.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let l of e)this.add(l),l.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,c,l,u]=this.children,h=t.getRenderTarget(),d=t.getActiveCubeFace(),f=t.getActiveMipmapLevel(),p=t.xr.enabled;t.xr.enabled=!1;let _=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let m=!1;t.isWebGLRenderer===!0?m=t.state.buffers.depth.getReversed():m=t.reversedDepthBuffer,t.setRenderTarget(i,0,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(i,1,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(i,2,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(i,3,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),t.setRenderTarget(i,4,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),i.texture.mipmapsAutoUpdate=_,t.setRenderTarget(i,5,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,u),t.setRenderTarget(h,d,f),t.xr.enabled=p,i.texture.needsPMREMUpdate=!0}},Wh=class extends Ti{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var Ym="\\[\\]\\.:\\/",PE=new RegExp("["+Ym+"]","g"),jm="[^"+Ym+"]",IE="[^"+Ym.replace("\\.","")+"]",LE=/((?:WC+[\/:])*)/.source.replace("WC",jm),DE=/(WCOD+)?/.source.replace("WCOD",IE),NE=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",jm),UE=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",jm),OE=new RegExp("^"+LE+DE+NE+UE+"$"),FE=["material","materials","bones","map"],hm=class{constructor(t,e,i){let s=i||dn.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(t,e)}setValue(t,e){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].unbind()}},dn=class n{constructor(t,e,i){this.path=e,this.parsedPath=i||n.parseTrackName(e),this.node=n.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,i){return t&&t.isAnimationObjectGroup?new n.Composite(t,e,i):new n(t,e,i)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(PE,"")}static parseTrackName(t){let e=OE.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let i={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);FE.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return i}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let i=t.skeleton.getBoneByName(e);if(i!==void 0)return i}if(t.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let c=i(a.children);if(c)return c}return null},s=i(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)t[e++]=i[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,i=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=n.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){ie("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let l=e.objectIndex;switch(i){case"materials":if(!t.material){le("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){le("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){le("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let u=0;u<t.length;u++)if(t[u].name===l){l=u;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){le("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){le("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[i]===void 0){le("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[i]}if(l!==void 0){if(t[l]===void 0){le("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[l]}}let o=t[s];if(o===void 0){let l=e.nodeName;le("PropertyBinding: Trying to update property for track: "+l+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let c=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){le("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){le("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}c=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(c=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(c=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[c],this.setValue=this.SetterByBindingTypeAndVersioning[c][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};dn.Composite=hm;dn.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};dn.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};dn.prototype.GetterByBindingType=[dn.prototype._getValue_direct,dn.prototype._getValue_array,dn.prototype._getValue_arrayElement,dn.prototype._getValue_toArray];dn.prototype.SetterByBindingTypeAndVersioning=[[dn.prototype._setValue_direct,dn.prototype._setValue_direct_setNeedsUpdate,dn.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[dn.prototype._setValue_array,dn.prototype._setValue_array_setNeedsUpdate,dn.prototype._setValue_array_setMatrixWorldNeedsUpdate],[dn.prototype._setValue_arrayElement,dn.prototype._setValue_arrayElement_setNeedsUpdate,dn.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[dn.prototype._setValue_fromArray,dn.prototype._setValue_fromArray_setNeedsUpdate,dn.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var hN=new Float32Array(1);var B_=new _e,Cc=class{constructor(t,e,i=0,s=1/0){this.ray=new Cr(t,e),this.near=i,this.far=s,this.camera=null,this.layers=new za,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(t,e){this.ray.set(t,e)}setFromCamera(t,e){e.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(t.x,t.y,.5).unproject(e).sub(this.ray.origin).normalize(),this.camera=e):e.isOrthographicCamera?(this.ray.origin.set(t.x,t.y,e.projectionMatrix.elements[14]).unproject(e),this.ray.direction.set(0,0,-1).transformDirection(e.matrixWorld),this.camera=e):le("Raycaster: Unsupported camera type: "+e.type)}setFromXRController(t){return B_.identity().extractRotation(t.matrixWorld),this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(B_),this}intersectObject(t,e=!0,i=[]){return dm(t,this,i,e),i.sort(k_),i}intersectObjects(t,e=!0,i=[]){for(let s=0,r=t.length;s<r;s++)dm(t[s],this,i,e);return i.sort(k_),i}};function k_(n,t){return n.distance-t.distance}function dm(n,t,e,i){let s=!0;if(n.layers.test(t.layers)&&n.raycast(t,e)===!1&&(s=!1),s===!0&&i===!0){let r=n.children;for(let o=0,a=r.length;o<a;o++)dm(r[o],t,e,!0)}}var Xa=class{constructor(t=1,e=0,i=0){this.radius=t,this.phi=e,this.theta=i}set(t,e,i){return this.radius=t,this.phi=e,this.theta=i,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=Ae(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,i){return this.radius=Math.sqrt(t*t+e*e+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,i),this.phi=Math.acos(Ae(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var fm=class{static{this.prototype.isMatrix2=!0}constructor(t,e,i,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let i=0;i<4;i++)this.elements[i]=t[i+e];return this}set(t,e,i,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=i,r[3]=s,this}};var Pc=class extends Cs{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function Zm(n,t,e,i){let s=BE(i);switch(e){case Dm:return n*t;case Jh:return n*t/s.components*s.byteLength;case Kh:return n*t/s.components*s.byteLength;case lo:return n*t*2/s.components*s.byteLength;case Qh:return n*t*2/s.components*s.byteLength;case Nm:return n*t*3/s.components*s.byteLength;case Ds:return n*t*4/s.components*s.byteLength;case td:return n*t*4/s.components*s.byteLength;case Dc:case Nc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case Uc:case Oc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case nd:case sd:return Math.max(n,16)*Math.max(t,8)/4;case ed:case id:return Math.max(n,8)*Math.max(t,8)/2;case rd:case od:case ld:case cd:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case ad:case Fc:case ud:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case hd:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case dd:return Math.floor((n+4)/5)*Math.floor((t+3)/4)*16;case fd:return Math.floor((n+4)/5)*Math.floor((t+4)/5)*16;case pd:return Math.floor((n+5)/6)*Math.floor((t+4)/5)*16;case md:return Math.floor((n+5)/6)*Math.floor((t+5)/6)*16;case gd:return Math.floor((n+7)/8)*Math.floor((t+4)/5)*16;case xd:return Math.floor((n+7)/8)*Math.floor((t+5)/6)*16;case _d:return Math.floor((n+7)/8)*Math.floor((t+7)/8)*16;case yd:return Math.floor((n+9)/10)*Math.floor((t+4)/5)*16;case vd:return Math.floor((n+9)/10)*Math.floor((t+5)/6)*16;case bd:return Math.floor((n+9)/10)*Math.floor((t+7)/8)*16;case Md:return Math.floor((n+9)/10)*Math.floor((t+9)/10)*16;case Sd:return Math.floor((n+11)/12)*Math.floor((t+9)/10)*16;case wd:return Math.floor((n+11)/12)*Math.floor((t+11)/12)*16;case Ed:case Td:case Ad:return Math.ceil(n/4)*Math.ceil(t/4)*16;case Rd:case Cd:return Math.ceil(n/4)*Math.ceil(t/4)*8;case Bc:case Pd:return Math.ceil(n/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function BE(n){switch(n){case ns:case Cm:return{byteLength:1,components:1};case Ja:case Pm:case Ls:return{byteLength:2,components:1};case jh:case Zh:return{byteLength:2,components:4};case Is:case Yh:case ds:return{byteLength:4,components:1};case Im:case Lm:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?ie("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Xy(){let n=null,t=!1,e=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&n!==null&&(i=n.requestAnimationFrame(s),t=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){n=r}}}function VE(n){let t=new WeakMap;function e(a,c){let l=a.array,u=a.usage,h=l.byteLength,d=n.createBuffer();n.bindBuffer(c,d),n.bufferData(c,l,u),a.onUploadCallback();let f;if(l instanceof Float32Array)f=n.FLOAT;else if(typeof Float16Array<"u"&&l instanceof Float16Array)f=n.HALF_FLOAT;else if(l instanceof Uint16Array)a.isFloat16BufferAttribute?f=n.HALF_FLOAT:f=n.UNSIGNED_SHORT;else if(l instanceof Int16Array)f=n.SHORT;else if(l instanceof Uint32Array)f=n.UNSIGNED_INT;else if(l instanceof Int32Array)f=n.INT;else if(l instanceof Int8Array)f=n.BYTE;else if(l instanceof Uint8Array)f=n.UNSIGNED_BYTE;else if(l instanceof Uint8ClampedArray)f=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+l);return{buffer:d,type:f,bytesPerElement:l.BYTES_PER_ELEMENT,version:a.version,size:h}}function i(a,c,l){let u=c.array,h=c.updateRanges;if(n.bindBuffer(l,a),h.length===0)n.bufferSubData(l,0,u);else{h.sort((f,p)=>f.start-p.start);let d=0;for(let f=1;f<h.length;f++){let p=h[d],_=h[f];_.start<=p.start+p.count+1?p.count=Math.max(p.count,_.start+_.count-p.start):(++d,h[d]=_)}h.length=d+1;for(let f=0,p=h.length;f<p;f++){let _=h[f];n.bufferSubData(l,_.start*u.BYTES_PER_ELEMENT,u,_.start,_.count)}c.clearUpdateRanges()}c.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let c=t.get(a);c&&(n.deleteBuffer(c.buffer),t.delete(a))}function o(a,c){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=t.get(a);(!u||u.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let l=t.get(a);if(l===void 0)t.set(a,e(a,c));else if(l.version<a.version){if(l.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(l.buffer,a,c),l.version=a.version}}return{get:s,remove:r,update:o}}var WE=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,$E=`#ifdef USE_ALPHAHASH
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
#endif`,qE=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,XE=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,YE=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,jE=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,ZE=`#ifdef USE_AOMAP
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
#endif`,JE=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,KE=`#ifdef USE_BATCHING
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
#endif`,QE=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,tT=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,eT=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,nT=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,iT=`#ifdef USE_IRIDESCENCE
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
#endif`,sT=`#ifdef USE_BUMPMAP
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
#endif`,rT=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,oT=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,aT=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,lT=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,cT=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,uT=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,hT=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,dT=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,fT=`#define PI 3.141592653589793
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
} // validated`,pT=`vec3 transformedNormal = objectNormal;
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
#endif`,mT=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,gT=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,xT=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,_T=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,yT="gl_FragColor = linearToOutputTexel( gl_FragColor );",vT=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,bT=`#ifdef USE_ENVMAP
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
#endif`,MT=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,ST=`#ifdef USE_ENVMAP
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
#endif`,wT=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,ET=`#ifdef USE_ENVMAP
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
#endif`,TT=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,AT=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,RT=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,CT=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,PT=`#ifdef USE_GRADIENTMAP
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
}`,IT=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,LT=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,DT=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,NT=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,UT=`#ifdef USE_ENVMAP
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
#endif`,OT=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,FT=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,BT=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,kT=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,zT=`PhysicalMaterial material;
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
#endif`,HT=`uniform sampler2D dfgLUT;
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
}`,GT=`
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
#endif`,VT=`#if defined( RE_IndirectDiffuse )
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
#endif`,WT=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,$T=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,qT=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,XT=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,YT=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,jT=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,ZT=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,JT=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,KT=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,QT=`#if defined( USE_POINTS_UV )
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
#endif`,tA=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,eA=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,nA=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,iA=`#if defined( USE_MORPHCOLORS )
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
#endif`,sA=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,rA=`#ifdef USE_MORPHTARGETS
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
#endif`,oA=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,aA=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,lA=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,cA=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,uA=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,hA=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,dA=`#ifdef USE_NORMALMAP
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
#endif`,fA=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,pA=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,mA=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,gA=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,xA=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,_A=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,yA=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,vA=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,bA=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,MA=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,SA=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,wA=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,EA=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,TA=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,AA=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,RA=`float getShadowMask() {
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
}`,CA=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,PA=`#ifdef USE_SKINNING
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
#endif`,IA=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,LA=`#ifdef USE_SKINNING
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
#endif`,DA=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,NA=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,UA=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,OA=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,FA=`#ifdef USE_TRANSMISSION
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
#endif`,BA=`#ifdef USE_TRANSMISSION
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
#endif`,kA=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,zA=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,HA=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,GA=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,VA=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,WA=`uniform sampler2D t2D;
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
}`,$A=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,qA=`uniform float backgroundBlurriness;
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
}`,XA=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,YA=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,jA=`#include <common>
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
}`,ZA=`#if DEPTH_PACKING == 3200
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
}`,JA=`#define DISTANCE
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
}`,KA=`#define DISTANCE
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
}`,QA=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,tR=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,eR=`uniform float scale;
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
}`,nR=`uniform vec3 diffuse;
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
}`,iR=`#include <common>
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
}`,sR=`uniform vec3 diffuse;
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
}`,rR=`#define LAMBERT
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
}`,oR=`#define LAMBERT
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
}`,aR=`#define MATCAP
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
}`,lR=`#define MATCAP
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
}`,cR=`#define NORMAL
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
}`,uR=`#define NORMAL
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
}`,hR=`#define PHONG
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
}`,dR=`#define PHONG
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
}`,fR=`#define STANDARD
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
}`,pR=`#define STANDARD
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
}`,mR=`#define TOON
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
}`,gR=`#define TOON
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
}`,xR=`uniform float size;
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
}`,_R=`uniform vec3 diffuse;
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
}`,yR=`#include <common>
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
}`,vR=`uniform vec3 color;
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
}`,bR=`uniform float rotation;
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
}`,MR=`uniform vec3 diffuse;
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
}`,Ee={alphahash_fragment:WE,alphahash_pars_fragment:$E,alphamap_fragment:qE,alphamap_pars_fragment:XE,alphatest_fragment:YE,alphatest_pars_fragment:jE,aomap_fragment:ZE,aomap_pars_fragment:JE,batching_pars_vertex:KE,batching_vertex:QE,begin_vertex:tT,beginnormal_vertex:eT,bsdfs:nT,iridescence_fragment:iT,bumpmap_pars_fragment:sT,clipping_planes_fragment:rT,clipping_planes_pars_fragment:oT,clipping_planes_pars_vertex:aT,clipping_planes_vertex:lT,color_fragment:cT,color_pars_fragment:uT,color_pars_vertex:hT,color_vertex:dT,common:fT,defaultnormal_vertex:pT,displacementmap_pars_vertex:mT,displacementmap_vertex:gT,emissivemap_fragment:xT,emissivemap_pars_fragment:_T,colorspace_fragment:yT,colorspace_pars_fragment:vT,envmap_fragment:bT,envmap_common_pars_fragment:MT,envmap_pars_fragment:ST,envmap_pars_vertex:wT,envmap_physical_pars_fragment:UT,envmap_vertex:ET,fog_vertex:TT,fog_pars_vertex:AT,fog_fragment:RT,fog_pars_fragment:CT,gradientmap_pars_fragment:PT,lightmap_pars_fragment:IT,lights_lambert_fragment:LT,lights_lambert_pars_fragment:DT,lights_pars_begin:NT,lights_toon_fragment:OT,lights_toon_pars_fragment:FT,lights_phong_fragment:BT,lights_phong_pars_fragment:kT,lights_physical_fragment:zT,lights_physical_pars_fragment:HT,lights_fragment_begin:GT,lights_fragment_maps:VT,lights_fragment_end:WT,lightprobes_pars_fragment:$T,logdepthbuf_fragment:qT,logdepthbuf_pars_fragment:XT,logdepthbuf_pars_vertex:YT,logdepthbuf_vertex:jT,map_fragment:ZT,map_pars_fragment:JT,map_particle_fragment:KT,map_particle_pars_fragment:QT,metalnessmap_fragment:tA,metalnessmap_pars_fragment:eA,morphinstance_vertex:nA,morphcolor_vertex:iA,morphnormal_vertex:sA,morphtarget_pars_vertex:rA,morphtarget_vertex:oA,normal_fragment_begin:aA,normal_fragment_maps:lA,normal_pars_fragment:cA,normal_pars_vertex:uA,normal_vertex:hA,normalmap_pars_fragment:dA,clearcoat_normal_fragment_begin:fA,clearcoat_normal_fragment_maps:pA,clearcoat_pars_fragment:mA,iridescence_pars_fragment:gA,opaque_fragment:xA,packing:_A,premultiplied_alpha_fragment:yA,project_vertex:vA,dithering_fragment:bA,dithering_pars_fragment:MA,roughnessmap_fragment:SA,roughnessmap_pars_fragment:wA,shadowmap_pars_fragment:EA,shadowmap_pars_vertex:TA,shadowmap_vertex:AA,shadowmask_pars_fragment:RA,skinbase_vertex:CA,skinning_pars_vertex:PA,skinning_vertex:IA,skinnormal_vertex:LA,specularmap_fragment:DA,specularmap_pars_fragment:NA,tonemapping_fragment:UA,tonemapping_pars_fragment:OA,transmission_fragment:FA,transmission_pars_fragment:BA,uv_pars_fragment:kA,uv_pars_vertex:zA,uv_vertex:HA,worldpos_vertex:GA,background_vert:VA,background_frag:WA,backgroundCube_vert:$A,backgroundCube_frag:qA,cube_vert:XA,cube_frag:YA,depth_vert:jA,depth_frag:ZA,distance_vert:JA,distance_frag:KA,equirect_vert:QA,equirect_frag:tR,linedashed_vert:eR,linedashed_frag:nR,meshbasic_vert:iR,meshbasic_frag:sR,meshlambert_vert:rR,meshlambert_frag:oR,meshmatcap_vert:aR,meshmatcap_frag:lR,meshnormal_vert:cR,meshnormal_frag:uR,meshphong_vert:hR,meshphong_frag:dR,meshphysical_vert:fR,meshphysical_frag:pR,meshtoon_vert:mR,meshtoon_frag:gR,points_vert:xR,points_frag:_R,shadow_vert:yR,shadow_frag:vR,sprite_vert:bR,sprite_frag:MR},kt={common:{diffuse:{value:new ee(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new he},alphaMap:{value:null},alphaMapTransform:{value:new he},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new he}},envmap:{envMap:{value:null},envMapRotation:{value:new he},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new he}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new he}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new he},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new he},normalScale:{value:new Qt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new he},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new he}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new he}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new he}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new ee(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new ee(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new he},alphaTest:{value:0},uvTransform:{value:new he}},sprite:{diffuse:{value:new ee(16777215)},opacity:{value:1},center:{value:new Qt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new he},alphaMap:{value:null},alphaMapTransform:{value:new he},alphaTest:{value:0}}},ar={basic:{uniforms:mi([kt.common,kt.specularmap,kt.envmap,kt.aomap,kt.lightmap,kt.fog]),vertexShader:Ee.meshbasic_vert,fragmentShader:Ee.meshbasic_frag},lambert:{uniforms:mi([kt.common,kt.specularmap,kt.envmap,kt.aomap,kt.lightmap,kt.emissivemap,kt.bumpmap,kt.normalmap,kt.displacementmap,kt.fog,kt.lights,{emissive:{value:new ee(0)},envMapIntensity:{value:1}}]),vertexShader:Ee.meshlambert_vert,fragmentShader:Ee.meshlambert_frag},phong:{uniforms:mi([kt.common,kt.specularmap,kt.envmap,kt.aomap,kt.lightmap,kt.emissivemap,kt.bumpmap,kt.normalmap,kt.displacementmap,kt.fog,kt.lights,{emissive:{value:new ee(0)},specular:{value:new ee(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:Ee.meshphong_vert,fragmentShader:Ee.meshphong_frag},standard:{uniforms:mi([kt.common,kt.envmap,kt.aomap,kt.lightmap,kt.emissivemap,kt.bumpmap,kt.normalmap,kt.displacementmap,kt.roughnessmap,kt.metalnessmap,kt.fog,kt.lights,{emissive:{value:new ee(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:Ee.meshphysical_vert,fragmentShader:Ee.meshphysical_frag},toon:{uniforms:mi([kt.common,kt.aomap,kt.lightmap,kt.emissivemap,kt.bumpmap,kt.normalmap,kt.displacementmap,kt.gradientmap,kt.fog,kt.lights,{emissive:{value:new ee(0)}}]),vertexShader:Ee.meshtoon_vert,fragmentShader:Ee.meshtoon_frag},matcap:{uniforms:mi([kt.common,kt.bumpmap,kt.normalmap,kt.displacementmap,kt.fog,{matcap:{value:null}}]),vertexShader:Ee.meshmatcap_vert,fragmentShader:Ee.meshmatcap_frag},points:{uniforms:mi([kt.points,kt.fog]),vertexShader:Ee.points_vert,fragmentShader:Ee.points_frag},dashed:{uniforms:mi([kt.common,kt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:Ee.linedashed_vert,fragmentShader:Ee.linedashed_frag},depth:{uniforms:mi([kt.common,kt.displacementmap]),vertexShader:Ee.depth_vert,fragmentShader:Ee.depth_frag},normal:{uniforms:mi([kt.common,kt.bumpmap,kt.normalmap,kt.displacementmap,{opacity:{value:1}}]),vertexShader:Ee.meshnormal_vert,fragmentShader:Ee.meshnormal_frag},sprite:{uniforms:mi([kt.sprite,kt.fog]),vertexShader:Ee.sprite_vert,fragmentShader:Ee.sprite_frag},background:{uniforms:{uvTransform:{value:new he},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:Ee.background_vert,fragmentShader:Ee.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new he}},vertexShader:Ee.backgroundCube_vert,fragmentShader:Ee.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:Ee.cube_vert,fragmentShader:Ee.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:Ee.equirect_vert,fragmentShader:Ee.equirect_frag},distance:{uniforms:mi([kt.common,kt.displacementmap,{referencePosition:{value:new G},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:Ee.distance_vert,fragmentShader:Ee.distance_frag},shadow:{uniforms:mi([kt.lights,kt.fog,{color:{value:new ee(0)},opacity:{value:1}}]),vertexShader:Ee.shadow_vert,fragmentShader:Ee.shadow_frag}};ar.physical={uniforms:mi([ar.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new he},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new he},clearcoatNormalScale:{value:new Qt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new he},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new he},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new he},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new he},sheen:{value:0},sheenColor:{value:new ee(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new he},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new he},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new he},transmissionSamplerSize:{value:new Qt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new he},attenuationDistance:{value:0},attenuationColor:{value:new ee(0)},specularColor:{value:new ee(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new he},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new he},anisotropyVector:{value:new Qt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new he}}]),vertexShader:Ee.meshphysical_vert,fragmentShader:Ee.meshphysical_frag};var Dd={r:0,b:0,g:0},SR=new _e,Yy=new he;Yy.set(-1,0,0,0,1,0,0,0,1);function wR(n,t,e,i,s,r){let o=new ee(0),a=s===!0?0:1,c,l,u=null,h=0,d=null;function f(x){let S=x.isScene===!0?x.background:null;if(S&&S.isTexture){let v=x.backgroundBlurriness>0;S=t.get(S,v)}return S}function p(x){let S=!1,v=f(x);v===null?m(o,a):v&&v.isColor&&(m(v,1),S=!0);let A=n.xr.getEnvironmentBlendMode();A==="additive"?e.buffers.color.setClear(0,0,0,1,r):A==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(n.autoClear||S)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function _(x,S){let v=f(S);v&&v.isCubeTexture?(l===void 0&&(l=new Ge(new Hi(1,1,1),new fi({name:"BackgroundCubeMaterial",uniforms:Wo(ar.backgroundCube.uniforms),vertexShader:ar.backgroundCube.vertexShader,fragmentShader:ar.backgroundCube.fragmentShader,side:oi,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),l.geometry.deleteAttribute("uv"),l.onBeforeRender=function(A,w,y){this.matrixWorld.copyPosition(y.matrixWorld)},Object.defineProperty(l.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(l)),l.material.uniforms.envMap.value=v,l.material.uniforms.backgroundBlurriness.value=S.backgroundBlurriness,l.material.uniforms.backgroundIntensity.value=S.backgroundIntensity,l.material.uniforms.backgroundRotation.value.setFromMatrix4(SR.makeRotationFromEuler(S.backgroundRotation)).transpose(),v.isRenderTargetTexture===!1&&l.material.uniforms.backgroundRotation.value.premultiply(Yy),l.material.toneMapped=De.getTransfer(v.colorSpace)!==$e,(u!==v||h!==v.version||d!==n.toneMapping)&&(l.material.needsUpdate=!0,u=v,h=v.version,d=n.toneMapping),l.layers.enableAll(),x.unshift(l,l.geometry,l.material,0,0,null)):v&&v.isTexture&&(c===void 0&&(c=new Ge(new Tc(2,2),new fi({name:"BackgroundMaterial",uniforms:Wo(ar.background.uniforms),vertexShader:ar.background.vertexShader,fragmentShader:ar.background.fragmentShader,side:sr,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(c)),c.material.uniforms.t2D.value=v,c.material.uniforms.backgroundIntensity.value=S.backgroundIntensity,c.material.toneMapped=De.getTransfer(v.colorSpace)!==$e,v.matrixAutoUpdate===!0&&v.updateMatrix(),c.material.uniforms.uvTransform.value.copy(v.matrix),(u!==v||h!==v.version||d!==n.toneMapping)&&(c.material.needsUpdate=!0,u=v,h=v.version,d=n.toneMapping),c.layers.enableAll(),x.unshift(c,c.geometry,c.material,0,0,null))}function m(x,S){x.getRGB(Dd,Xm(n)),e.buffers.color.setClear(Dd.r,Dd.g,Dd.b,S,r)}function g(){l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0),c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0)}return{getClearColor:function(){return o},setClearColor:function(x,S=1){o.set(x),a=S,m(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(x){a=x,m(o,a)},render:p,addToRenderList:_,dispose:g}}function ER(n,t){let e=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=d(null),r=s,o=!1;function a(N,H,$,P,z){let D=!1,B=h(N,P,$,H);r!==B&&(r=B,l(r.object)),D=f(N,P,$,z),D&&p(N,P,$,z),z!==null&&t.update(z,n.ELEMENT_ARRAY_BUFFER),(D||o)&&(o=!1,v(N,H,$,P),z!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,t.get(z).buffer))}function c(){return n.createVertexArray()}function l(N){return n.bindVertexArray(N)}function u(N){return n.deleteVertexArray(N)}function h(N,H,$,P){let z=P.wireframe===!0,D=i[H.id];D===void 0&&(D={},i[H.id]=D);let B=N.isInstancedMesh===!0?N.id:0,Q=D[B];Q===void 0&&(Q={},D[B]=Q);let Y=Q[$.id];Y===void 0&&(Y={},Q[$.id]=Y);let Z=Y[z];return Z===void 0&&(Z=d(c()),Y[z]=Z),Z}function d(N){let H=[],$=[],P=[];for(let z=0;z<e;z++)H[z]=0,$[z]=0,P[z]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:H,enabledAttributes:$,attributeDivisors:P,object:N,attributes:{},index:null}}function f(N,H,$,P){let z=r.attributes,D=H.attributes,B=0,Q=$.getAttributes();for(let Y in Q)if(Q[Y].location>=0){let nt=z[Y],dt=D[Y];if(dt===void 0&&(Y==="instanceMatrix"&&N.instanceMatrix&&(dt=N.instanceMatrix),Y==="instanceColor"&&N.instanceColor&&(dt=N.instanceColor)),nt===void 0||nt.attribute!==dt||dt&&nt.data!==dt.data)return!0;B++}return r.attributesNum!==B||r.index!==P}function p(N,H,$,P){let z={},D=H.attributes,B=0,Q=$.getAttributes();for(let Y in Q)if(Q[Y].location>=0){let nt=D[Y];nt===void 0&&(Y==="instanceMatrix"&&N.instanceMatrix&&(nt=N.instanceMatrix),Y==="instanceColor"&&N.instanceColor&&(nt=N.instanceColor));let dt={};dt.attribute=nt,nt&&nt.data&&(dt.data=nt.data),z[Y]=dt,B++}r.attributes=z,r.attributesNum=B,r.index=P}function _(){let N=r.newAttributes;for(let H=0,$=N.length;H<$;H++)N[H]=0}function m(N){g(N,0)}function g(N,H){let $=r.newAttributes,P=r.enabledAttributes,z=r.attributeDivisors;$[N]=1,P[N]===0&&(n.enableVertexAttribArray(N),P[N]=1),z[N]!==H&&(n.vertexAttribDivisor(N,H),z[N]=H)}function x(){let N=r.newAttributes,H=r.enabledAttributes;for(let $=0,P=H.length;$<P;$++)H[$]!==N[$]&&(n.disableVertexAttribArray($),H[$]=0)}function S(N,H,$,P,z,D,B){B===!0?n.vertexAttribIPointer(N,H,$,z,D):n.vertexAttribPointer(N,H,$,P,z,D)}function v(N,H,$,P){_();let z=P.attributes,D=$.getAttributes(),B=H.defaultAttributeValues;for(let Q in D){let Y=D[Q];if(Y.location>=0){let Z=z[Q];if(Z===void 0&&(Q==="instanceMatrix"&&N.instanceMatrix&&(Z=N.instanceMatrix),Q==="instanceColor"&&N.instanceColor&&(Z=N.instanceColor)),Z!==void 0){let nt=Z.normalized,dt=Z.itemSize,ft=t.get(Z);if(ft===void 0)continue;let st=ft.buffer,yt=ft.type,xt=ft.bytesPerElement,Tt=yt===n.INT||yt===n.UNSIGNED_INT||Z.gpuType===Yh;if(Z.isInterleavedBufferAttribute){let At=Z.data,Jt=At.isInterleavedBuffer===!0?At.stride:At.itemSize,ge=Z.offset;if(At.isInstancedInterleavedBuffer||At.isInstancedBufferAttribute){for(let jt=0;jt<Y.locationSize;jt++)g(Y.location+jt,At.meshPerAttribute);N.isInstancedMesh!==!0&&P._maxInstanceCount===void 0&&(P._maxInstanceCount=At.meshPerAttribute*At.count)}else for(let jt=0;jt<Y.locationSize;jt++)m(Y.location+jt);n.bindBuffer(n.ARRAY_BUFFER,st);for(let jt=0;jt<Y.locationSize;jt++)S(Y.location+jt,dt/Y.locationSize,yt,nt,Jt*xt,(ge+dt/Y.locationSize*jt)*xt,Tt)}else{if(Z.isInstancedBufferAttribute){for(let At=0;At<Y.locationSize;At++)g(Y.location+At,Z.meshPerAttribute);N.isInstancedMesh!==!0&&P._maxInstanceCount===void 0&&(P._maxInstanceCount=Z.meshPerAttribute*Z.count)}else for(let At=0;At<Y.locationSize;At++)m(Y.location+At);n.bindBuffer(n.ARRAY_BUFFER,st);for(let At=0;At<Y.locationSize;At++)S(Y.location+At,dt/Y.locationSize,yt,nt,dt*xt,dt/Y.locationSize*At*xt,Tt)}}else if(B!==void 0){let nt=B[Q];if(nt!==void 0)switch(nt.length){case 2:n.vertexAttrib2fv(Y.location,nt);break;case 3:n.vertexAttrib3fv(Y.location,nt);break;case 4:n.vertexAttrib4fv(Y.location,nt);break;default:n.vertexAttrib1fv(Y.location,nt)}}}}x()}function A(){U();for(let N in i){let H=i[N];for(let $ in H){let P=H[$];for(let z in P){let D=P[z];for(let B in D)u(D[B].object),delete D[B];delete P[z]}}delete i[N]}}function w(N){if(i[N.id]===void 0)return;let H=i[N.id];for(let $ in H){let P=H[$];for(let z in P){let D=P[z];for(let B in D)u(D[B].object),delete D[B];delete P[z]}}delete i[N.id]}function y(N){for(let H in i){let $=i[H];for(let P in $){let z=$[P];if(z[N.id]===void 0)continue;let D=z[N.id];for(let B in D)u(D[B].object),delete D[B];delete z[N.id]}}}function E(N){for(let H in i){let $=i[H],P=N.isInstancedMesh===!0?N.id:0,z=$[P];if(z!==void 0){for(let D in z){let B=z[D];for(let Q in B)u(B[Q].object),delete B[Q];delete z[D]}delete $[P],Object.keys($).length===0&&delete i[H]}}}function U(){L(),o=!0,r!==s&&(r=s,l(r.object))}function L(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:U,resetDefaultState:L,dispose:A,releaseStatesOfGeometry:w,releaseStatesOfObject:E,releaseStatesOfProgram:y,initAttributes:_,enableAttribute:m,disableUnusedAttributes:x}}function TR(n,t,e){let i;function s(c){i=c}function r(c,l){n.drawArrays(i,c,l),e.update(l,i,1)}function o(c,l,u){u!==0&&(n.drawArraysInstanced(i,c,l,u),e.update(l,i,u))}function a(c,l,u){if(u===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,c,0,l,0,u);let d=0;for(let f=0;f<u;f++)d+=l[f];e.update(d,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function AR(n,t,e,i){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let y=t.get("EXT_texture_filter_anisotropic");s=n.getParameter(y.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(y){return!(y!==Ds&&i.convert(y)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(y){let E=y===Ls&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(y!==ns&&y!==ds&&!E&&i.convert(y)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function c(y){if(y==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";y="mediump"}return y==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let l=e.precision!==void 0?e.precision:"highp",u=c(l);u!==l&&(ie("WebGLRenderer:",l,"not supported, using",u,"instead."),l=u);let h=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),d=e.logarithmicDepthBuffer===!0&&h===!1;e.reversedDepthBuffer===!0&&h===!1&&ie("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&h===!0&&ie("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),p=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),_=n.getParameter(n.MAX_TEXTURE_SIZE),m=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),g=n.getParameter(n.MAX_VERTEX_ATTRIBS),x=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),S=n.getParameter(n.MAX_VARYING_VECTORS),v=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),A=n.getParameter(n.MAX_SAMPLES),w=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:c,textureFormatReadable:o,textureTypeReadable:a,precision:l,logarithmicDepthBuffer:d,reversedDepthBuffer:h,maxTextures:f,maxVertexTextures:p,maxTextureSize:_,maxCubemapSize:m,maxAttributes:g,maxVertexUniforms:x,maxVaryings:S,maxFragmentUniforms:v,maxSamples:A,samples:w}}function RR(n){let t=this,e=null,i=0,s=!1,r=!1,o=new ri,a=new he,c={value:null,needsUpdate:!1};this.uniform=c,this.numPlanes=0,this.numIntersection=0,this.init=function(h,d){let f=h.length!==0||d||i!==0||s;return s=d,i=h.length,f},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,d){e=u(h,d,0)},this.setState=function(h,d,f){let p=h.clippingPlanes,_=h.clipIntersection,m=h.clipShadows,g=n.get(h);if(!s||p===null||p.length===0||r&&!m)r?u(null):l();else{let x=r?0:i,S=x*4,v=g.clippingState||null;c.value=v,v=u(p,d,S,f);for(let A=0;A!==S;++A)v[A]=e[A];g.clippingState=v,this.numIntersection=_?this.numPlanes:0,this.numPlanes+=x}};function l(){c.value!==e&&(c.value=e,c.needsUpdate=i>0),t.numPlanes=i,t.numIntersection=0}function u(h,d,f,p){let _=h!==null?h.length:0,m=null;if(_!==0){if(m=c.value,p!==!0||m===null){let g=f+_*4,x=d.matrixWorldInverse;a.getNormalMatrix(x),(m===null||m.length<g)&&(m=new Float32Array(g));for(let S=0,v=f;S!==_;++S,v+=4)o.copy(h[S]).applyMatrix4(x,a),o.normal.toArray(m,v),m[v+3]=o.constant}c.value=m,c.needsUpdate=!0}return t.numPlanes=_,t.numIntersection=0,m}}var Hc=class extends Qi{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let i={width:t,height:t,depth:1},s=[i,i,i,i,i,i];this.texture=new vc(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new Hi(5,5,5),r=new fi({name:"CubemapFromEquirect",uniforms:Wo(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:oi,blending:zo});r.uniforms.tEquirect.value=e;let o=new Ge(s,r),a=e.minFilter;return e.minFilter===Lr&&(e.minFilter=Ai),new qa(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,i=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,i,s);t.setRenderTarget(r)}},Ty=256,CR=3,PR=20,jy=256,Zy=16,IR=3,LR=new G,DR=new ee,Ud=class n{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new qa(1,10,null),this._boxMesh=new Ge(new Hi(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,i=.1,s=100,r={}){let{size:o=256,position:a=LR}=r,c=this._renderer;this._setSize(o);let l=this._allocateTarget(),u=this._getSourceTarget(!0);e>0&&(u.texture.mipmapsAutoUpdate=!1);let h=c.autoClear,d=c.autoClearColor,f=c.autoClearDepth,p=c.autoClearStencil,_=t.background;c.autoClear=!0,c.autoClearColor=!0,c.autoClearDepth=!0,c.autoClearStencil=!0,_===null&&(t.background=c.getClearColor(DR));let m=new qa(i,s,u);return m.position.copy(a),m.update(c,t),c.autoClear=h,c.autoClearColor=d,c.autoClearDepth=f,c.autoClearStencil=p,t.background=_,e>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(l,e)),this._applyPMREM(l),l}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Cy(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Ry(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(Ty,Wm(t))}_fromTexture(t,e){t.mapping===Go||t.mapping===Za?this._setSize(t.image.length===0?Ty:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let i=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(i),i}_allocateTarget(){let t=this._cubeSize,e=Ay(t,!1,!1),i=Math.log2(t)-CR;for(let s=0;s<=i;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==e||t&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=Ay(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===Go||t.mapping===Za?(this._cubemapMaterial===null&&(this._cubemapMaterial=Cy()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Ry()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=NR(),this._integrationMaterial=UR());let e=this._cubeSize,i=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/Zy);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-IR)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let c=a>0?Math.log2(e)+.5*Math.log2(6/(jy*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=c,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=OR());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,i),s.envMap.value=t.texture,this._renderCube(r,0,i)}};function Ay(n,t,e){return new Hc(n,{minFilter:Lr,generateMipmaps:t,type:Ls,colorSpace:lc,depthBuffer:e})}function Gc(n,t,e){return new fi({name:n,uniforms:t,vertexShader:Ee.cube_vert,fragmentShader:e,side:oi,blending:zo,depthTest:!1,depthWrite:!1})}function NR(){return Gc("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${jy}u

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
	`)}function UR(){return Gc("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Zy}},`

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
	`)}function OR(){return Gc("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${PR}
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
	`)}function Ry(){return Gc("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function Cy(){return Gc("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function FR(n){let t=new WeakMap,e=new WeakMap,i=null;function s(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===$h||f===qh)if(t.has(d)){let p=t.get(d).texture;return a(p,d.mapping)}else{let p=d.image;if(p&&p.height>0){let _=new Hc(p.height);return _.fromEquirectangularTexture(n,d),t.set(d,_),d.addEventListener("dispose",l),a(_.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,p=f===$h||f===qh,_=f===Go||f===Za;if(p||_){let m=e.get(d),g=m!==void 0?m.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==g)return i===null&&(i=new Ud(n)),m=p?i.fromEquirectangular(d,m):i.fromCubemap(d,m),m.texture.pmremVersion=d.pmremVersion,e.set(d,m),m.texture;if(m!==void 0)return m.texture;{let x=d.image;return p&&x&&x.height>0||_&&x&&c(x)?(i===null&&(i=new Ud(n)),m=p?i.fromEquirectangular(d):i.fromCubemap(d),m.texture.pmremVersion=d.pmremVersion,e.set(d,m),d.addEventListener("dispose",u),m.texture):null}}}return d}function a(d,f){return f===$h?d.mapping=Go:f===qh&&(d.mapping=Za),d}function c(d){let f=0,p=6;for(let _=0;_<p;_++)d[_]!==void 0&&f++;return f===p}function l(d){let f=d.target;f.removeEventListener("dispose",l);let p=t.get(f);p!==void 0&&(t.delete(f),p.dispose())}function u(d){let f=d.target;f.removeEventListener("dispose",u);let p=e.get(f);p!==void 0&&(e.delete(f),p.dispose())}function h(){t=new WeakMap,e=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:h}}function BR(n){let t={};function e(i){if(t[i]!==void 0)return t[i];let s=n.getExtension(i);return t[i]=s,s}return{has:function(i){return e(i)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(i){let s=e(i);return s===null&&sc("WebGLRenderer: "+i+" extension not supported."),s}}}function kR(n,t,e,i){let s={},r=new WeakMap,o=new FinalizationRegistry(p=>delete s[p]);function a(p){c(p.target)}function c(p){p.index!==null&&t.remove(p.index);for(let m in p.attributes)t.remove(p.attributes[m]);p.removeEventListener("dispose",a),delete s[p.id],o.unregister(p);let _=r.get(p);_&&(t.remove(_),r.delete(p)),i.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,e.memory.geometries--}function l(p,_){return s[_.id]!==void 0||(_.addEventListener("dispose",a),s[_.id]=new WeakRef(_),o.register(_,_.id,_),e.memory.geometries++),_}function u(p){let _=p.attributes;for(let m in _)t.update(_[m],n.ARRAY_BUFFER)}function h(p){let _=p.index,m=p.attributes.position,g=0;if(m===void 0)return;let x=_!==null?_.array.length:m.array.length/3-1,S=m.count>=65535?xc:gc,v=new S(Math.ceil(x/3)*6,1),A=v.array;if(_!==null){let y=_.array;g=_.version;for(let E=0,U=0;E<x;E+=3){let L=y[E+0],N=y[E+1],H=y[E+2];A[U++]=L,A[U++]=N,A[U++]=N,A[U++]=H,A[U++]=H,A[U++]=L}}else{g=m.version;for(let y=0,E=0;y<x;y+=3){let U=y+0,L=y+1,N=y+2;A[E++]=U,A[E++]=L,A[E++]=L,A[E++]=N,A[E++]=N,A[E++]=U}}v.version=g;let w=r.get(p);w&&t.remove(w),r.set(p,v)}function d(p){let _=r.get(p);if(_){let m=p.index;m!==null&&_.version<m.version&&h(p)}else h(p);return r.get(p)}function f(){for(let p in s){let _=s[p].deref();_!==void 0&&c(_)}}return{get:l,update:u,getWireframeAttribute:d,dispose:f}}function zR(n,t,e){let i;function s(h){i=h}let r,o;function a(h){r=h.type,o=h.bytesPerElement}function c(h,d){n.drawElements(i,d,r,h*o),e.update(d,i,1)}function l(h,d,f){f!==0&&(n.drawElementsInstanced(i,d,r,h*o,f),e.update(d,i,f))}function u(h,d,f){if(f===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,d,0,r,h,0,f);let _=0;for(let m=0;m<f;m++)_+=d[m];e.update(_,i,1)}this.setMode=s,this.setIndex=a,this.render=c,this.renderInstances=l,this.renderMultiDraw=u}function HR(n){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(e.calls++,o){case n.TRIANGLES:e.triangles+=a*(r/3);break;case n.LINES:e.lines+=a*(r/2);break;case n.LINE_STRIP:e.lines+=a*(r-1);break;case n.LINE_LOOP:e.lines+=a*r;break;case n.POINTS:e.points+=a*r;break;default:le("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:i}}function GR(n,t,e){let i=new WeakMap,s=new bn;function r(o,a,c){let l=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,d=i.get(a);if(d===void 0||d.count!==h){let U=function(){y.dispose(),i.delete(a),a.removeEventListener("dispose",U)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,_=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],g=a.morphAttributes.normal||[],x=a.morphAttributes.color||[],S=0;f===!0&&(S=1),p===!0&&(S=2),_===!0&&(S=3);let v=a.attributes.position.count*S,A=1;v>t.maxTextureSize&&(A=Math.ceil(v/t.maxTextureSize),v=t.maxTextureSize);let w=new Float32Array(v*A*4*h),y=new fc(w,v,A,h);y.type=ds,y.needsUpdate=!0;let E=S*4;for(let L=0;L<h;L++){let N=m[L],H=g[L],$=x[L],P=v*A*4*L;for(let z=0;z<N.count;z++){let D=z*E;f===!0&&(s.fromBufferAttribute(N,z),w[P+D+0]=s.x,w[P+D+1]=s.y,w[P+D+2]=s.z,w[P+D+3]=0),p===!0&&(s.fromBufferAttribute(H,z),w[P+D+4]=s.x,w[P+D+5]=s.y,w[P+D+6]=s.z,w[P+D+7]=0),_===!0&&(s.fromBufferAttribute($,z),w[P+D+8]=s.x,w[P+D+9]=s.y,w[P+D+10]=s.z,w[P+D+11]=$.itemSize===4?s.w:1)}}d={count:h,texture:y,size:new Qt(v,A)},i.set(a,d),a.addEventListener("dispose",U)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)c.getUniforms().setValue(n,"morphTexture",o.morphTexture,e);else{let f=0;for(let _=0;_<l.length;_++)f+=l[_];let p=a.morphTargetsRelative?1:1-f;c.getUniforms().setValue(n,"morphTargetBaseInfluence",p),c.getUniforms().setValue(n,"morphTargetInfluences",l)}c.getUniforms().setValue(n,"morphTargetsTexture",d.texture,e),c.getUniforms().setValue(n,"morphTargetsTextureSize",d.size)}return{update:r}}function VR(n,t,e,i,s){let r=new WeakMap;function o(l){let u=s.render.frame,h=l.geometry,d=t.get(l,h);if(r.get(d)!==u&&(t.update(d),r.set(d,u)),l.isInstancedMesh&&(l.hasEventListener("dispose",c)===!1&&l.addEventListener("dispose",c),r.get(l)!==u&&(e.update(l.instanceMatrix,n.ARRAY_BUFFER),l.instanceColor!==null&&e.update(l.instanceColor,n.ARRAY_BUFFER),r.set(l,u))),l.isSkinnedMesh){let f=l.skeleton;r.get(f)!==u&&(f.update(),r.set(f,u))}return d}function a(){r=new WeakMap}function c(l){let u=l.target;u.removeEventListener("dispose",c),i.releaseStatesOfObject(u),e.remove(u.instanceMatrix),u.instanceColor!==null&&e.remove(u.instanceColor)}return{update:o,dispose:a}}var WR={[bm]:"LINEAR_TONE_MAPPING",[Mm]:"REINHARD_TONE_MAPPING",[Sm]:"CINEON_TONE_MAPPING",[wm]:"ACES_FILMIC_TONE_MAPPING",[Tm]:"AGX_TONE_MAPPING",[Am]:"NEUTRAL_TONE_MAPPING",[Em]:"CUSTOM_TONE_MAPPING"};function $R(n,t,e,i,s,r){let o=new Qi(t,e,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,c=null,l=null,u=new be;u.setAttribute("position",new ve([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new ve([0,2,0,0,2,0],2));let h=new Ph({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),d=new Ge(u,h),f=new Vh(-1,1,1,-1,0,1),p=null,_=null,m=!1,g,x=null,S=[],v=!1;this.setSize=function(A,w){o.setSize(A,w),a!==null&&a.setSize(A,w),c!==null&&c.setSize(A,w);for(let y=0;y<S.length;y++){let E=S[y];E.setSize&&E.setSize(A,w)}},this.setEffects=function(A){S=A,v=S.length>0&&S[0].isRenderPass===!0;let w=o.width,y=o.height;S.length>0&&a===null&&(a=new Qi(w,y,{type:Ls,depthBuffer:!1,stencilBuffer:!1}),c=new Qi(w,y,{type:Ls,depthBuffer:!1,stencilBuffer:!1}));let E=s===!0&&S.some(U=>U.needsDepthTexture===!0);E!==(o.depthTexture!==null)&&(E===!0&&l===null&&(l=new Ir(w,y),r===!0&&(l.format=Dr,l.type=Vo)),o.dispose(),o.depthTexture=E?l:null,o.resolveDepthBuffer=E,o.storeMultisampledDepthBuffer=E);for(let U=0;U<S.length;U++){let L=S[U];L.setSize&&L.setSize(w,y),E&&L.needsDepthTexture===!0&&L.setDepthTexture&&L.setDepthTexture(l)}},this.begin=function(A,w){if(m||A.toneMapping===rr&&S.length===0)return!1;if(x=w,w!==null){let y=w.width,E=w.height;(o.width!==y||o.height!==E)&&this.setSize(y,E)}return v===!1&&A.setRenderTarget(o),g=A.toneMapping,A.toneMapping=rr,!0},this.hasRenderPass=function(){return v},this.end=function(A,w){A.toneMapping=g,m=!0;let y=o,E=a;for(let U=0;U<S.length;U++){let L=S[U];L.enabled!==!1&&(L.render(A,E,y,w),L.needsSwap!==!1&&(y=E,E=E===a?c:a))}if(p!==A.outputColorSpace||_!==A.toneMapping){p=A.outputColorSpace,_=A.toneMapping,h.defines={},De.getTransfer(p)===$e&&(h.defines.SRGB_TRANSFER="");let U=WR[_];U&&(h.defines[U]=""),h.needsUpdate=!0}h.uniforms.tDiffuse.value=y.texture,A.setRenderTarget(x),A.render(d,f),x=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),c!==null&&c.dispose(),u.dispose(),h.dispose()}}var Jy=new Bi,Ky=new Ir(1,1),Qy=new bc(1),tv=new fc,ev=new Eh,nv=new vc,Py=[],Iy=[],Ly=new Float32Array(16),Dy=new Float32Array(9),Ny=new Float32Array(4);function Qa(n,t,e){let i=n[0];if(i<=0||i>0)return n;let s=t*e,r=Py[s];if(r===void 0&&(r=new Float32Array(s),Py[s]=r),t!==0){i.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,n[o].toArray(r,a)}return r}function Wn(n,t){if(n.length!==t.length)return!1;for(let e=0,i=n.length;e<i;e++)if(n[e]!==t[e])return!1;return!0}function $n(n,t){for(let e=0,i=t.length;e<i;e++)n[e]=t[e]}function Fd(n,t){let e=Iy[t];e===void 0&&(e=new Int32Array(t),Iy[t]=e);for(let i=0;i!==t;++i)e[i]=n.allocateTextureUnit();return e}function qR(n,t){let e=this.cache;e[0]!==t&&(n.uniform1f(this.addr,t),e[0]=t)}function XR(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Wn(e,t))return;n.uniform2fv(this.addr,t),$n(e,t)}}function YR(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(n.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(Wn(e,t))return;n.uniform3fv(this.addr,t),$n(e,t)}}function jR(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Wn(e,t))return;n.uniform4fv(this.addr,t),$n(e,t)}}function ZR(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Wn(e,t))return;n.uniformMatrix2fv(this.addr,!1,t),$n(e,t)}else{if(Wn(e,i))return;Ny.set(i),n.uniformMatrix2fv(this.addr,!1,Ny),$n(e,i)}}function JR(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Wn(e,t))return;n.uniformMatrix3fv(this.addr,!1,t),$n(e,t)}else{if(Wn(e,i))return;Dy.set(i),n.uniformMatrix3fv(this.addr,!1,Dy),$n(e,i)}}function KR(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Wn(e,t))return;n.uniformMatrix4fv(this.addr,!1,t),$n(e,t)}else{if(Wn(e,i))return;Ly.set(i),n.uniformMatrix4fv(this.addr,!1,Ly),$n(e,i)}}function QR(n,t){let e=this.cache;e[0]!==t&&(n.uniform1i(this.addr,t),e[0]=t)}function tC(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Wn(e,t))return;n.uniform2iv(this.addr,t),$n(e,t)}}function eC(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Wn(e,t))return;n.uniform3iv(this.addr,t),$n(e,t)}}function nC(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Wn(e,t))return;n.uniform4iv(this.addr,t),$n(e,t)}}function iC(n,t){let e=this.cache;e[0]!==t&&(n.uniform1ui(this.addr,t),e[0]=t)}function sC(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Wn(e,t))return;n.uniform2uiv(this.addr,t),$n(e,t)}}function rC(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Wn(e,t))return;n.uniform3uiv(this.addr,t),$n(e,t)}}function oC(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Wn(e,t))return;n.uniform4uiv(this.addr,t),$n(e,t)}}function Bd(n){return n.version===0&&(n.compareFunction=zm,n.needsUpdate=!0),n}function aC(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=Bd(Ky):r=Jy,e.setTexture2D(t||r,s)}function lC(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture3D(t||ev,s)}function cC(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=Bd(Qy):r=nv,e.setTextureCube(t||r,s)}function uC(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture2DArray(t||tv,s)}function hC(n){switch(n){case 5126:return qR;case 35664:return XR;case 35665:return YR;case 35666:return jR;case 35674:return ZR;case 35675:return JR;case 35676:return KR;case 5124:case 35670:return QR;case 35667:case 35671:return tC;case 35668:case 35672:return eC;case 35669:case 35673:return nC;case 5125:return iC;case 36294:return sC;case 36295:return rC;case 36296:return oC;case 35678:case 36198:case 36298:case 36306:case 35682:return aC;case 35679:case 36299:case 36307:return lC;case 35680:case 36300:case 36308:case 36293:return cC;case 36289:case 36303:case 36311:case 36292:return uC}}function dC(n,t){n.uniform1fv(this.addr,t)}function fC(n,t){let e=Qa(t,this.size,2);n.uniform2fv(this.addr,e)}function pC(n,t){let e=Qa(t,this.size,3);n.uniform3fv(this.addr,e)}function mC(n,t){let e=Qa(t,this.size,4);n.uniform4fv(this.addr,e)}function gC(n,t){let e=Qa(t,this.size,4);n.uniformMatrix2fv(this.addr,!1,e)}function xC(n,t){let e=Qa(t,this.size,9);n.uniformMatrix3fv(this.addr,!1,e)}function _C(n,t){let e=Qa(t,this.size,16);n.uniformMatrix4fv(this.addr,!1,e)}function yC(n,t){n.uniform1iv(this.addr,t)}function vC(n,t){n.uniform2iv(this.addr,t)}function bC(n,t){n.uniform3iv(this.addr,t)}function MC(n,t){n.uniform4iv(this.addr,t)}function SC(n,t){n.uniform1uiv(this.addr,t)}function wC(n,t){n.uniform2uiv(this.addr,t)}function EC(n,t){n.uniform3uiv(this.addr,t)}function TC(n,t){n.uniform4uiv(this.addr,t)}function AC(n,t,e){let i=this.cache,s=t.length,r=Fd(e,s);Wn(i,r)||(n.uniform1iv(this.addr,r),$n(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=Bd(Ky):o=Jy;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function RC(n,t,e){let i=this.cache,s=t.length,r=Fd(e,s);Wn(i,r)||(n.uniform1iv(this.addr,r),$n(i,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||ev,r[o])}function CC(n,t,e){let i=this.cache,s=t.length,r=Fd(e,s);Wn(i,r)||(n.uniform1iv(this.addr,r),$n(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=Bd(Qy):o=nv;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function PC(n,t,e){let i=this.cache,s=t.length,r=Fd(e,s);Wn(i,r)||(n.uniform1iv(this.addr,r),$n(i,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||tv,r[o])}function IC(n){switch(n){case 5126:return dC;case 35664:return fC;case 35665:return pC;case 35666:return mC;case 35674:return gC;case 35675:return xC;case 35676:return _C;case 5124:case 35670:return yC;case 35667:case 35671:return vC;case 35668:case 35672:return bC;case 35669:case 35673:return MC;case 5125:return SC;case 36294:return wC;case 36295:return EC;case 36296:return TC;case 35678:case 36198:case 36298:case 36306:case 35682:return AC;case 35679:case 36299:case 36307:return RC;case 35680:case 36300:case 36308:case 36293:return CC;case 36289:case 36303:case 36311:case 36292:return PC}}var Qm=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.setValue=hC(e.type)}},tg=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=IC(e.type)}},eg=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],i)}}},Jm=/(\w+)(\])?(\[|\.)?/g;function Uy(n,t){n.seq.push(t),n.map[t.id]=t}function LC(n,t,e){let i=n.name,s=i.length;for(Jm.lastIndex=0;;){let r=Jm.exec(i),o=Jm.lastIndex,a=r[1],c=r[2]==="]",l=r[3];if(c&&(a=a|0),l===void 0||l==="["&&o+2===s){Uy(e,l===void 0?new Qm(a,n,t):new tg(a,n,t));break}else{let h=e.map[a];h===void 0&&(h=new eg(a),Uy(e,h)),e=h}}}var Ka=class{constructor(t,e){this.seq=[],this.map={};let i=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=t.getActiveUniform(e,o),c=t.getUniformLocation(e,a.name);LC(a,c,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,i,s){let r=this.map[e];r!==void 0&&r.setValue(t,i,s)}setOptional(t,e,i){let s=e[i];s!==void 0&&this.setValue(t,i,s)}static upload(t,e,i,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],c=i[a.id];c.needsUpdate!==!1&&a.setValue(t,c.value,s)}}static seqWithValue(t,e){let i=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&i.push(o)}return i}};function Oy(n,t,e){let i=n.createShader(t);return n.shaderSource(i,e),n.compileShader(i),i}var DC=37297,NC=0;function UC(n,t){let e=n.split(`
`),i=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return i.join(`
`)}var Fy=new he;function OC(n){De._getMatrix(Fy,De.workingColorSpace,n);let t=`mat3( ${Fy.elements.map(e=>e.toFixed(4))} )`;switch(De.getTransfer(n)){case cc:return[t,"LinearTransferOETF"];case $e:return[t,"sRGBTransferOETF"];default:return ie("WebGLProgram: Unsupported color space: ",n),[t,"LinearTransferOETF"]}}function By(n,t,e){let i=n.getShaderParameter(t,n.COMPILE_STATUS),r=(n.getShaderInfoLog(t)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+UC(n.getShaderSource(t),a)}else return r}function FC(n,t){let e=OC(t);return[`vec4 ${n}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var BC={[bm]:"Linear",[Mm]:"Reinhard",[Sm]:"Cineon",[wm]:"ACESFilmic",[Tm]:"AgX",[Am]:"Neutral",[Em]:"Custom"};function kC(n,t){let e=BC[t];return e===void 0?(ie("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var Nd=new G;function zC(){De.getLuminanceCoefficients(Nd);let n=Nd.x.toFixed(4),t=Nd.y.toFixed(4),e=Nd.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function HC(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(zc).join(`
`)}function GC(n){let t=[];for(let e in n){let i=n[e];i!==!1&&t.push("#define "+e+" "+i)}return t.join(`
`)}function VC(n,t){let e={},i=n.getProgramParameter(t,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(t,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:n.getAttribLocation(t,o),locationSize:a}}return e}function zc(n){return n!==""}function ky(n,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function zy(n,t){return n.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var WC=/^[ \t]*#include +<([\w\d./]+)>/gm;function ng(n){return n.replace(WC,$C)}function $C(n,t){let e=Ee[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return ng(e)}var qC=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Hy(n){return n.replace(qC,XC)}function XC(n,t,e,i){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Gy(n){let t=`precision ${n.precision} float;
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
#define LOW_PRECISION`),t}var YC={[Ic]:"SHADOWMAP_TYPE_PCF",[Ya]:"SHADOWMAP_TYPE_VSM"};function jC(n){return YC[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var ZC={[Za]:"ENVMAP_MODE_REFRACTION"};function JC(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":ZC[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var KC={[vm]:"ENVMAP_BLENDING_MULTIPLY",[ay]:"ENVMAP_BLENDING_MIX",[ly]:"ENVMAP_BLENDING_ADD"};function QC(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":KC[n.combine]||"ENVMAP_BLENDING_NONE"}function tP(n,t,e,i){let s=n.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,c=jC(e),l=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=JC(e),h=QC(e),d=HC(e),f=GC(r),p=s.createProgram(),_,m,g=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(_=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(zc).join(`
`),_.length>0&&(_+=`
`),m=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(zc).join(`
`),m.length>0&&(m+=`
`)):(_=[Gy(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+u:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+c:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(zc).join(`
`),m=[Gy(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+l:"",e.envMap?"#define "+u:"",e.envMap?"#define "+h:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+c:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==rr?"#define TONE_MAPPING":"",e.toneMapping!==rr?Ee.tonemapping_pars_fragment:"",e.toneMapping!==rr?kC("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",Ee.colorspace_pars_fragment,FC("linearToOutputTexel",e.outputColorSpace),zC(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(zc).join(`
`)),o=ng(o),o=ky(o,e),o=zy(o,e),a=ng(a),a=ky(a,e),a=zy(a,e),o=Hy(o),a=Hy(a),e.isRawShaderMaterial!==!0&&(g=`#version 300 es
`,_=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+_,m=["#define varying in",e.glslVersion===Gm?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===Gm?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let x=g+_+o,S=g+m+a,v=Oy(s,s.VERTEX_SHADER,x),A=Oy(s,s.FRAGMENT_SHADER,S);s.attachShader(p,v),s.attachShader(p,A),e.index0AttributeName!==void 0?s.bindAttribLocation(p,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function w(L){if(n.debug.checkShaderErrors){let N=s.getProgramInfoLog(p)||"",H=s.getShaderInfoLog(v)||"",$=s.getShaderInfoLog(A)||"",P=N.trim(),z=H.trim(),D=$.trim(),B=!0,Q=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(B=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,p,v,A);else{let Y=By(s,v,"vertex"),Z=By(s,A,"fragment");le("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+L.name+`
Material Type: `+L.type+`

Program Info Log: `+P+`
`+Y+`
`+Z)}else P!==""?ie("WebGLProgram: Program Info Log:",P):(z===""||D==="")&&(Q=!1);Q&&(L.diagnostics={runnable:B,programLog:P,vertexShader:{log:z,prefix:_},fragmentShader:{log:D,prefix:m}})}s.deleteShader(v),s.deleteShader(A),y=new Ka(s,p),E=VC(s,p)}let y;this.getUniforms=function(){return y===void 0&&w(this),y};let E;this.getAttributes=function(){return E===void 0&&w(this),E};let U=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return U===!1&&(U=s.getProgramParameter(p,DC)),U},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=NC++,this.cacheKey=t,this.usedTimes=1,this.program=p,this.vertexShader=v,this.fragmentShader=A,this}var eP=0,ig=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,i){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let i of e)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,i=e.get(t);return i===void 0&&(i=new Set,e.set(t,i)),i}_getShaderStage(t){let e=this.shaderCache,i=e.get(t);return i===void 0&&(i=new sg(t),e.set(t,i)),i}},sg=class{constructor(t){this.id=eP++,this.code=t,this.usedTimes=0}};function nP(n){return n===lo||n===Fc||n===Bc}function iP(n,t,e,i,s,r){let o=new za,a=new ig,c=new Set,l=[],u=new Map,h=i.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(y){return c.add(y),y===0?"uv":`uv${y}`}function p(y,E,U,L,N,H){let $=L.fog,P=N.geometry,z=y.isMeshStandardMaterial||y.isMeshLambertMaterial||y.isMeshPhongMaterial?L.environment:null,D=y.isMeshStandardMaterial||y.isMeshLambertMaterial&&!y.envMap||y.isMeshPhongMaterial&&!y.envMap,B=t.get(y.envMap||z,D),Q=d[y.type],Y=i.precision;y.precision!==null&&(Y=i.getMaxPrecision(y.precision),Y!==y.precision&&ie("WebGLProgram.getParameters:",y.precision,"not supported, using",Y,"instead."));let Z=P.morphAttributes.position||P.morphAttributes.normal||P.morphAttributes.color,nt=Z!==void 0?Z.length:0,dt=0;P.morphAttributes.position!==void 0&&(dt=1),P.morphAttributes.normal!==void 0&&(dt=2),P.morphAttributes.color!==void 0&&(dt=3);let ft,st,yt,xt;if(Q){let Dt=ar[Q];ft=Dt.vertexShader,st=Dt.fragmentShader}else{ft=y.vertexShader,st=y.fragmentShader;let Dt=a.getVertexShaderStage(y),ye=a.getFragmentShaderStage(y);a.update(y,Dt,ye),yt=Dt.id,xt=ye.id}let Tt=n.getRenderTarget(),At=n.state.buffers.depth.getReversed(),Jt=N.isInstancedMesh===!0,ge=N.isBatchedMesh===!0,jt=!!y.map,Te=!!y.matcap,Me=!!B,pe=Me&&B.isPMREMTexture===!0,xn=!!y.aoMap,on=!!y.lightMap,In=!!y.bumpMap&&y.wireframe===!1,Je=!!y.normalMap,Zn=!!y.displacementMap,Ue=!!y.emissiveMap,kn=!!y.metalnessMap,Sn=!!y.roughnessMap,Ln=y.anisotropy>0,W=y.clearcoat>0,Nt=y.diffuseRoughness>0,se=y.dispersion>0,xe=y.retroreflectivity>0,Ct=y.iridescence>0,Qe=y.sheen>0,Yt=y.transmission>0,ne=Ln&&!!y.anisotropyMap,O=W&&!!y.clearcoatMap,R=W&&!!y.clearcoatNormalMap,j=W&&!!y.clearcoatRoughnessMap,gt=Nt&&!!y.diffuseRoughnessMap,ct=Ct&&!!y.iridescenceMap,St=Ct&&!!y.iridescenceThicknessMap,wt=Qe&&!!y.sheenColorMap,rt=Qe&&!!y.sheenRoughnessMap,at=!!y.specularMap,vt=!!y.specularColorMap,V=!!y.specularIntensityMap,lt=Yt&&!!y.transmissionMap,ot=Yt&&!!y.thicknessMap,Pt=!!y.gradientMap,Mt=!!y.alphaMap,Rt=y.alphaTest>0,Zt=!!y.alphaHash,oe=!!y.extensions,pt=rr;y.toneMapped&&(Tt===null||Tt.isXRRenderTarget===!0)&&(pt=n.toneMapping);let $t=pe?B.isCompressedCubeTexture?B.image[0].mipmaps:B.mipmaps:null,ae={shaderID:Q,shaderType:y.type,shaderName:y.name,vertexShader:ft,fragmentShader:st,defines:y.defines,customVertexShaderID:yt,customFragmentShaderID:xt,isRawShaderMaterial:y.isRawShaderMaterial===!0,glslVersion:y.glslVersion,precision:Y,batching:ge,batchingColor:ge&&N._colorsTexture!==null,instancing:Jt,instancingColor:Jt&&N.instanceColor!==null,instancingMorph:Jt&&N.morphTexture!==null,outputColorSpace:Tt===null?n.outputColorSpace:Tt.isXRRenderTarget===!0?Tt.texture.colorSpace:De.workingColorSpace,alphaToCoverage:!!y.alphaToCoverage,map:jt,matcap:Te,envMap:Me,envMapMode:Me&&B.mapping,envMapPMREM:pe,envMapMaxLod:pe?$t.length-1:null,envMapSize:pe?$t[0].width:null,aoMap:xn,lightMap:on,bumpMap:In,normalMap:Je,displacementMap:Zn,emissiveMap:Ue,normalMapObjectSpace:Je&&y.normalMapType===hy,normalMapTangentSpace:Je&&y.normalMapType===Um,packedNormalMap:Je&&y.normalMapType===Um&&nP(y.normalMap.format),metalnessMap:kn,roughnessMap:Sn,anisotropy:Ln,anisotropyMap:ne,clearcoat:W,clearcoatMap:O,clearcoatNormalMap:R,clearcoatRoughnessMap:j,diffuseRoughness:Nt,diffuseRoughnessMap:gt,dispersion:se,retroreflection:xe,iridescence:Ct,iridescenceMap:ct,iridescenceThicknessMap:St,sheen:Qe,sheenColorMap:wt,sheenRoughnessMap:rt,specularMap:at,specularColorMap:vt,specularIntensityMap:V,transmission:Yt,transmissionMap:lt,thicknessMap:ot,gradientMap:Pt,opaque:y.transparent===!1&&y.blending===ja&&y.alphaToCoverage===!1,alphaMap:Mt,alphaTest:Rt,alphaHash:Zt,combine:y.combine,mapUv:jt&&f(y.map.channel),aoMapUv:xn&&f(y.aoMap.channel),lightMapUv:on&&f(y.lightMap.channel),bumpMapUv:In&&f(y.bumpMap.channel),normalMapUv:Je&&f(y.normalMap.channel),displacementMapUv:Zn&&f(y.displacementMap.channel),emissiveMapUv:Ue&&f(y.emissiveMap.channel),metalnessMapUv:kn&&f(y.metalnessMap.channel),roughnessMapUv:Sn&&f(y.roughnessMap.channel),anisotropyMapUv:ne&&f(y.anisotropyMap.channel),clearcoatMapUv:O&&f(y.clearcoatMap.channel),clearcoatNormalMapUv:R&&f(y.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:j&&f(y.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:gt&&f(y.diffuseRoughnessMap.channel),iridescenceMapUv:ct&&f(y.iridescenceMap.channel),iridescenceThicknessMapUv:St&&f(y.iridescenceThicknessMap.channel),sheenColorMapUv:wt&&f(y.sheenColorMap.channel),sheenRoughnessMapUv:rt&&f(y.sheenRoughnessMap.channel),specularMapUv:at&&f(y.specularMap.channel),specularColorMapUv:vt&&f(y.specularColorMap.channel),specularIntensityMapUv:V&&f(y.specularIntensityMap.channel),transmissionMapUv:lt&&f(y.transmissionMap.channel),thicknessMapUv:ot&&f(y.thicknessMap.channel),alphaMapUv:Mt&&f(y.alphaMap.channel),vertexTangents:!!P.attributes.tangent&&(Je||Ln),vertexNormals:!!P.attributes.normal,vertexColors:y.vertexColors,vertexAlphas:y.vertexColors===!0&&!!P.attributes.color&&P.attributes.color.itemSize===4,pointsUvs:N.isPoints===!0&&!!P.attributes.uv&&(jt||Mt),fog:!!$,useFog:y.fog===!0,fogExp2:!!$&&$.isFogExp2,flatShading:y.wireframe===!1&&(y.flatShading===!0||P.attributes.normal===void 0&&Je===!1&&(y.isMeshLambertMaterial||y.isMeshPhongMaterial||y.isMeshStandardMaterial||y.isMeshPhysicalMaterial)),sizeAttenuation:y.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:At,skinning:N.isSkinnedMesh===!0,hasPositionAttribute:P.attributes.position!==void 0,morphTargets:P.morphAttributes.position!==void 0,morphNormals:P.morphAttributes.normal!==void 0,morphColors:P.morphAttributes.color!==void 0,morphTargetsCount:nt,morphTextureStride:dt,numSunLights:E.sun.length,numDirLights:E.directional.length,numPointLights:E.point.length,numSpotLights:E.spot.length,numSpotLightMaps:E.spotLightMap.length,numRectAreaLights:E.rectArea.length,numHemiLights:E.hemi.length,numSunLightShadows:E.sunShadowMap.length,numDirLightShadows:E.directionalShadowMap.length,numPointLightShadows:E.pointShadowMap.length,numSpotLightShadows:E.spotShadowMap.length,numSpotLightShadowsWithMaps:E.numSpotLightShadowsWithMaps,numLightProbes:E.numLightProbes,numLightProbeGrids:H.filter(Dt=>Dt.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:y.dithering,shadowMapEnabled:n.shadowMap.enabled&&U.length>0,shadowMapType:n.shadowMap.type,toneMapping:pt,decodeVideoTexture:jt&&y.map.isVideoTexture===!0&&De.getTransfer(y.map.colorSpace)===$e,decodeVideoTextureEmissive:Ue&&y.emissiveMap.isVideoTexture===!0&&De.getTransfer(y.emissiveMap.colorSpace)===$e,premultipliedAlpha:y.premultipliedAlpha,doubleSided:y.side===pi,flipSided:y.side===oi,useDepthPacking:y.depthPacking>=0,depthPacking:y.depthPacking||0,index0AttributeName:y.index0AttributeName,extensionClipCullDistance:oe&&y.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(oe&&y.extensions.multiDraw===!0||ge)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:y.customProgramCacheKey()};return ae.vertexUv1s=c.has(1),ae.vertexUv2s=c.has(2),ae.vertexUv3s=c.has(3),c.clear(),ae}function _(y){let E=[];if(y.shaderID?E.push(y.shaderID):(E.push(y.customVertexShaderID),E.push(y.customFragmentShaderID)),y.defines!==void 0)for(let U in y.defines)E.push(U),E.push(y.defines[U]);return y.isRawShaderMaterial===!1&&(m(E,y),g(E,y),E.push(n.outputColorSpace)),E.push(y.customProgramCacheKey),E.join()}function m(y,E){y.push(E.precision),y.push(E.outputColorSpace),y.push(E.envMapMode),y.push(E.envMapPMREM),y.push(E.envMapMaxLod),y.push(E.envMapSize),y.push(E.mapUv),y.push(E.alphaMapUv),y.push(E.lightMapUv),y.push(E.aoMapUv),y.push(E.bumpMapUv),y.push(E.normalMapUv),y.push(E.displacementMapUv),y.push(E.emissiveMapUv),y.push(E.metalnessMapUv),y.push(E.roughnessMapUv),y.push(E.anisotropyMapUv),y.push(E.clearcoatMapUv),y.push(E.clearcoatNormalMapUv),y.push(E.clearcoatRoughnessMapUv),y.push(E.diffuseRoughnessMapUv),y.push(E.iridescenceMapUv),y.push(E.iridescenceThicknessMapUv),y.push(E.sheenColorMapUv),y.push(E.sheenRoughnessMapUv),y.push(E.specularMapUv),y.push(E.specularColorMapUv),y.push(E.specularIntensityMapUv),y.push(E.transmissionMapUv),y.push(E.thicknessMapUv),y.push(E.combine),y.push(E.fogExp2),y.push(E.sizeAttenuation),y.push(E.morphTargetsCount),y.push(E.numSunLights),y.push(E.numDirLights),y.push(E.numPointLights),y.push(E.numSpotLights),y.push(E.numSpotLightMaps),y.push(E.numHemiLights),y.push(E.numRectAreaLights),y.push(E.numSunLightShadows),y.push(E.numDirLightShadows),y.push(E.numPointLightShadows),y.push(E.numSpotLightShadows),y.push(E.numSpotLightShadowsWithMaps),y.push(E.numLightProbes),y.push(E.numLightProbeGrids),y.push(E.shadowMapType),y.push(E.toneMapping),y.push(E.numClippingPlanes),y.push(E.numClipIntersection),y.push(E.depthPacking)}function g(y,E){o.disableAll(),E.instancing&&o.enable(0),E.instancingColor&&o.enable(1),E.instancingMorph&&o.enable(2),E.matcap&&o.enable(3),E.envMap&&o.enable(4),E.normalMapObjectSpace&&o.enable(5),E.normalMapTangentSpace&&o.enable(6),E.clearcoat&&o.enable(7),E.iridescence&&o.enable(8),E.alphaTest&&o.enable(9),E.vertexColors&&o.enable(10),E.vertexAlphas&&o.enable(11),E.vertexUv1s&&o.enable(12),E.vertexUv2s&&o.enable(13),E.vertexUv3s&&o.enable(14),E.vertexTangents&&o.enable(15),E.anisotropy&&o.enable(16),E.alphaHash&&o.enable(17),E.batching&&o.enable(18),E.dispersion&&o.enable(19),E.retroreflection&&o.enable(24),E.diffuseRoughness&&o.enable(25),E.batchingColor&&o.enable(20),E.gradientMap&&o.enable(21),E.packedNormalMap&&o.enable(22),E.vertexNormals&&o.enable(23),y.push(o.mask),o.disableAll(),E.fog&&o.enable(0),E.useFog&&o.enable(1),E.flatShading&&o.enable(2),E.logarithmicDepthBuffer&&o.enable(3),E.reversedDepthBuffer&&o.enable(4),E.skinning&&o.enable(5),E.morphTargets&&o.enable(6),E.morphNormals&&o.enable(7),E.morphColors&&o.enable(8),E.premultipliedAlpha&&o.enable(9),E.shadowMapEnabled&&o.enable(10),E.doubleSided&&o.enable(11),E.flipSided&&o.enable(12),E.useDepthPacking&&o.enable(13),E.dithering&&o.enable(14),E.transmission&&o.enable(15),E.sheen&&o.enable(16),E.opaque&&o.enable(17),E.pointsUvs&&o.enable(18),E.decodeVideoTexture&&o.enable(19),E.decodeVideoTextureEmissive&&o.enable(20),E.alphaToCoverage&&o.enable(21),E.numLightProbeGrids>0&&o.enable(22),E.hasPositionAttribute&&o.enable(23),y.push(o.mask)}function x(y){let E=d[y.type],U;if(E){let L=ar[E];U=Sy.clone(L.uniforms)}else U=y.uniforms;return U}function S(y,E){let U=u.get(E);return U!==void 0?++U.usedTimes:(U=new tP(n,E,y,s),l.push(U),u.set(E,U)),U}function v(y){if(--y.usedTimes===0){let E=l.indexOf(y);l[E]=l[l.length-1],l.pop(),u.delete(y.cacheKey),y.destroy()}}function A(y){a.remove(y)}function w(){a.dispose()}return{getParameters:p,getProgramCacheKey:_,getUniforms:x,acquireProgram:S,releaseProgram:v,releaseShaderCache:A,programs:l,dispose:w}}function sP(){let n=new WeakMap;function t(o){return n.has(o)}function e(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,c){n.get(o)[a]=c}function r(){n=new WeakMap}return{has:t,get:e,remove:i,update:s,dispose:r}}function rP(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.material.id!==t.material.id?n.material.id-t.material.id:n.materialVariant!==t.materialVariant?n.materialVariant-t.materialVariant:n.z!==t.z?n.z-t.z:n.id-t.id}function Vy(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.z!==t.z?t.z-n.z:n.id-t.id}function Wy(){let n=[],t=0,e=[],i=[],s=[];function r(){t=0,e.length=0,i.length=0,s.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,p,_,m,g){let x=n[t];return x===void 0?(x={id:d.id,object:d,geometry:f,material:p,materialVariant:o(d),groupOrder:_,renderOrder:d.renderOrder,z:m,group:g},n[t]=x):(x.id=d.id,x.object=d,x.geometry=f,x.material=p,x.materialVariant=o(d),x.groupOrder=_,x.renderOrder=d.renderOrder,x.z=m,x.group=g),t++,x}function c(d,f,p,_,m,g,x){x.reversedDepth===!0&&(m=-m);let S=a(d,f,p,_,m,g);p.transmission>0?i.push(S):p.transparent===!0?s.push(S):e.push(S)}function l(d,f,p,_,m,g){let x=a(d,f,p,_,m,g);p.transmission>0?i.unshift(x):p.transparent===!0?s.unshift(x):e.unshift(x)}function u(d,f){e.length>1&&e.sort(d||rP),i.length>1&&i.sort(f||Vy),s.length>1&&s.sort(f||Vy)}function h(){for(let d=t,f=n.length;d<f;d++){let p=n[d];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:e,transmissive:i,transparent:s,init:r,push:c,unshift:l,finish:h,sort:u}}function oP(){let n=new WeakMap;function t(i,s){let r=n.get(i),o;return r===void 0?(o=new Wy,n.set(i,[o])):s>=r.length?(o=new Wy,r.push(o)):o=r[s],o}function e(){n=new WeakMap}return{get:t,dispose:e}}function aP(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new G,color:new ee};break;case"SpotLight":e={position:new G,direction:new G,color:new ee,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new G,color:new ee,distance:0,decay:0};break;case"HemisphereLight":e={direction:new G,skyColor:new ee,groundColor:new ee};break;case"RectAreaLight":e={color:new ee,position:new G,halfWidth:new G,halfHeight:new G};break}return n[t.id]=e,e}}}function lP(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Qt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Qt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Qt,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[t.id]=e,e}}}var cP=0;function uP(n,t){return(t.castShadow?2:0)-(n.castShadow?2:0)+(t.map?1:0)-(n.map?1:0)}function hP(n){let t=new aP,e=lP(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let l=0;l<9;l++)i.probe.push(new G);let s=new G,r=new _e,o=new _e;function a(l){let u=0,h=0,d=0;for(let H=0;H<9;H++)i.probe[H].set(0,0,0);let f=0,p=0,_=0,m=0,g=0,x=0,S=0,v=0,A=0,w=0,y=0,E=0,U=0,L=0;l.sort(uP);for(let H=0,$=l.length;H<$;H++){let P=l[H],z=P.color,D=P.intensity,B=P.distance,Q=null;if(P.shadow&&P.shadow.map&&(P.shadow.map.texture.format===lo?Q=P.shadow.map.texture:Q=P.shadow.map.depthTexture||P.shadow.map.texture),P.isAmbientLight)u+=z.r*D,h+=z.g*D,d+=z.b*D;else if(P.isLightProbe){for(let Y=0;Y<9;Y++)i.probe[Y].addScaledVector(P.sh.coefficients[Y],D);L++}else if(P.isSunLight){let Y=t.get(P);if(Y.color.copy(P.color).multiplyScalar(P.intensity),P.castShadow){let Z=P.shadow,nt=e.get(P);nt.shadowIntensity=Z.intensity,nt.shadowBias=Z.bias,nt.shadowNormalBias=Z.normalBias,nt.shadowRadius=Z.radius,nt.shadowMapSize.copy(Z.mapSize).multiply(Z.getFrameExtents()),i.sunShadow[p]=nt,i.sunShadowMap[p]=Q;let dt=Z.getViewportCount();for(let ft=0;ft<dt;ft++)i.sunShadowMatrix[_+ft]=Z.getMatrix(ft),i.sunShadowCascade[_+ft]=Z._cascadeData[ft];_+=dt,p++}i.sun[f]=Y,f++}else if(P.isDirectionalLight){let Y=t.get(P);if(Y.color.copy(P.color).multiplyScalar(P.intensity),P.castShadow){let Z=P.shadow,nt=e.get(P);nt.shadowIntensity=Z.intensity,nt.shadowBias=Z.bias,nt.shadowNormalBias=Z.normalBias,nt.shadowRadius=Z.radius,nt.shadowMapSize=Z.mapSize,i.directionalShadow[m]=nt,i.directionalShadowMap[m]=Q,i.directionalShadowMatrix[m]=P.shadow.matrix,A++}i.directional[m]=Y,m++}else if(P.isSpotLight){let Y=t.get(P);Y.position.setFromMatrixPosition(P.matrixWorld),Y.color.copy(z).multiplyScalar(D),Y.distance=B,Y.coneCos=Math.cos(P.angle),Y.penumbraCos=Math.cos(P.angle*(1-P.penumbra)),Y.decay=P.decay,i.spot[x]=Y;let Z=P.shadow;if(P.map&&(i.spotLightMap[E]=P.map,E++,Z.updateMatrices(P),P.castShadow&&U++),i.spotLightMatrix[x]=Z.matrix,P.castShadow){let nt=e.get(P);nt.shadowIntensity=Z.intensity,nt.shadowBias=Z.bias,nt.shadowNormalBias=Z.normalBias,nt.shadowRadius=Z.radius,nt.shadowMapSize=Z.mapSize,i.spotShadow[x]=nt,i.spotShadowMap[x]=Q,y++}x++}else if(P.isRectAreaLight){let Y=t.get(P);Y.color.copy(z).multiplyScalar(D),Y.halfWidth.set(P.width*.5,0,0),Y.halfHeight.set(0,P.height*.5,0),i.rectArea[S]=Y,S++}else if(P.isPointLight){let Y=t.get(P);if(Y.color.copy(P.color).multiplyScalar(P.intensity),Y.distance=P.distance,Y.decay=P.decay,P.castShadow){let Z=P.shadow,nt=e.get(P);nt.shadowIntensity=Z.intensity,nt.shadowBias=Z.bias,nt.shadowNormalBias=Z.normalBias,nt.shadowRadius=Z.radius,nt.shadowMapSize=Z.mapSize,nt.shadowCameraNear=Z.camera.near,nt.shadowCameraFar=Z.camera.far,i.pointShadow[g]=nt,i.pointShadowMap[g]=Q,i.pointShadowMatrix[g]=P.shadow.matrix,w++}i.point[g]=Y,g++}else if(P.isHemisphereLight){let Y=t.get(P);Y.skyColor.copy(P.color).multiplyScalar(D),Y.groundColor.copy(P.groundColor).multiplyScalar(D),i.hemi[v]=Y,v++}}S>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=kt.LTC_FLOAT_1,i.rectAreaLTC2=kt.LTC_FLOAT_2):(i.rectAreaLTC1=kt.LTC_HALF_1,i.rectAreaLTC2=kt.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=h,i.ambient[2]=d;let N=i.hash;(N.sunLength!==f||N.directionalLength!==m||N.pointLength!==g||N.spotLength!==x||N.rectAreaLength!==S||N.hemiLength!==v||N.numSunShadows!==p||N.numDirectionalShadows!==A||N.numPointShadows!==w||N.numSpotShadows!==y||N.numSpotMaps!==E||N.numLightProbes!==L)&&(i.sun.length=f,i.directional.length=m,i.spot.length=x,i.rectArea.length=S,i.point.length=g,i.hemi.length=v,i.sunShadow.length=p,i.sunShadowMap.length=p,i.sunShadowMatrix.length=_,i.sunShadowCascade.length=_,i.directionalShadow.length=A,i.directionalShadowMap.length=A,i.directionalShadowMatrix.length=A,i.pointShadow.length=w,i.pointShadowMap.length=w,i.pointShadowMatrix.length=w,i.spotShadow.length=y,i.spotShadowMap.length=y,i.spotLightMatrix.length=y+E-U,i.spotLightMap.length=E,i.numSpotLightShadowsWithMaps=U,i.numLightProbes=L,N.sunLength=f,N.directionalLength=m,N.pointLength=g,N.spotLength=x,N.rectAreaLength=S,N.hemiLength=v,N.numSunShadows=p,N.numDirectionalShadows=A,N.numPointShadows=w,N.numSpotShadows=y,N.numSpotMaps=E,N.numLightProbes=L,i.version=cP++)}function c(l,u){let h=0,d=0,f=0,p=0,_=0,m=0,g=u.matrixWorldInverse;for(let x=0,S=l.length;x<S;x++){let v=l[x];if(v.isSunLight){let A=i.sun[h];A.direction.setFromMatrixPosition(v.matrixWorld),A.direction.transformDirection(g),h++}else if(v.isDirectionalLight){let A=i.directional[d];A.direction.setFromMatrixPosition(v.matrixWorld),s.setFromMatrixPosition(v.target.matrixWorld),A.direction.sub(s),A.direction.transformDirection(g),d++}else if(v.isSpotLight){let A=i.spot[p];A.position.setFromMatrixPosition(v.matrixWorld),A.position.applyMatrix4(g),A.direction.setFromMatrixPosition(v.matrixWorld),s.setFromMatrixPosition(v.target.matrixWorld),A.direction.sub(s),A.direction.transformDirection(g),p++}else if(v.isRectAreaLight){let A=i.rectArea[_];A.position.setFromMatrixPosition(v.matrixWorld),A.position.applyMatrix4(g),o.identity(),r.copy(v.matrixWorld),r.premultiply(g),o.extractRotation(r),A.halfWidth.set(v.width*.5,0,0),A.halfHeight.set(0,v.height*.5,0),A.halfWidth.applyMatrix4(o),A.halfHeight.applyMatrix4(o),_++}else if(v.isPointLight){let A=i.point[f];A.position.setFromMatrixPosition(v.matrixWorld),A.position.applyMatrix4(g),f++}else if(v.isHemisphereLight){let A=i.hemi[m];A.direction.setFromMatrixPosition(v.matrixWorld),A.direction.transformDirection(g),m++}}}return{setup:a,setupView:c,state:i}}function $y(n){let t=new hP(n),e=[],i=[],s=[];function r(h){u.camera=h,e.length=0,i.length=0,s.length=0}function o(h){h.isLightProbeGrid?s.push(h):e.push(h)}function a(h){i.push(h)}function c(){t.setup(e),s.sort((h,d)=>h.priority-d.priority||h.id-d.id)}function l(h){t.setupView(e,h)}let u={lightsArray:e,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:c,setupLightsView:l,pushLight:o,pushShadow:a}}function dP(n){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new $y(n),t.set(s,[a])):r>=o.length?(a=new $y(n),o.push(a)):a=o[r],a}function i(){t=new WeakMap}return{get:e,dispose:i}}var fP=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,pP=`uniform sampler2D shadow_pass;
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
}`,mP=[new G(1,0,0),new G(-1,0,0),new G(0,1,0),new G(0,-1,0),new G(0,0,1),new G(0,0,-1)],gP=[new G(0,-1,0),new G(0,-1,0),new G(0,0,1),new G(0,0,-1),new G(0,-1,0),new G(0,-1,0)],qy=new _e,kc=new G,Km=new G;function xP(n,t,e){let i=new Oo,s=new Qt,r=new Qt,o=new bn,a=new Ih,c=new Lh,l={},u=e.maxTextureSize,h={[sr]:oi,[oi]:sr,[pi]:pi},d=new fi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Qt},radius:{value:4}},vertexShader:fP,fragmentShader:pP}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let p=new be;p.setAttribute("position",new He(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let _=new Ge(p,d),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Ic;let g=this.type;this.render=function(w,y,E){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||w.length===0)return;this.type===G_&&(ie("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Ic);let U=n.getRenderTarget(),L=n.getActiveCubeFace(),N=n.getActiveMipmapLevel(),H=n.state;H.setBlending(zo),H.buffers.depth.getReversed()===!0?H.buffers.color.setClear(0,0,0,0):H.buffers.color.setClear(1,1,1,1),H.buffers.depth.setTest(!0),H.setScissorTest(!1);let $=g!==this.type;$&&y.traverse(function(P){P.material&&(Array.isArray(P.material)?P.material.forEach(z=>z.needsUpdate=!0):P.material.needsUpdate=!0)});for(let P=0,z=w.length;P<z;P++){let D=w[P],B=D.shadow;if(B===void 0){ie("WebGLShadowMap:",D,"has no shadow.");continue}if(B.autoUpdate===!1&&B.needsUpdate===!1)continue;s.copy(B.mapSize);let Q=B.getFrameExtents();s.multiply(Q),r.copy(B.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/Q.x),s.x=r.x*Q.x,B.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/Q.y),s.y=r.y*Q.y,B.mapSize.y=r.y));let Y=n.state.buffers.depth.getReversed();if(B.camera._reversedDepth=Y,B.map===null||$===!0){if(B.map!==null&&(B.map.depthTexture!==null&&(B.map.depthTexture.dispose(),B.map.depthTexture=null),B.map.dispose()),this.type===Ya){if(D.isPointLight){ie("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}B.map=new Qi(s.x,s.y,{format:lo,type:Ls,minFilter:Ai,magFilter:Ai,generateMipmaps:!1}),B.map.texture.name=D.name+".shadowMap",B.map.depthTexture=new Ir(s.x,s.y,ds),B.map.depthTexture.name=D.name+".shadowMapDepth",B.map.depthTexture.format=Ar,B.map.depthTexture.compareFunction=null,B.map.depthTexture.minFilter=ni,B.map.depthTexture.magFilter=ni}else D.isPointLight?(B.map=new Hc(s.x),B.map.depthTexture=new bc(s.x,Is)):(B.map=new Qi(s.x,s.y),B.map.depthTexture=new Ir(s.x,s.y,Is)),B.map.depthTexture.name=D.name+".shadowMap",B.map.depthTexture.format=Ar,this.type===Ic?(B.map.depthTexture.compareFunction=Y?km:Bm,B.map.depthTexture.minFilter=Ai,B.map.depthTexture.magFilter=Ai):(B.map.depthTexture.compareFunction=null,B.map.depthTexture.minFilter=ni,B.map.depthTexture.magFilter=ni);B.camera.updateProjectionMatrix()}B.map.isWebGLCubeRenderTarget!==!0&&(B.map.width!==s.x||B.map.height!==s.y)&&B.map.setSize(s.x,s.y);let Z=B.map.isWebGLCubeRenderTarget?6:B.getViewportCount();D.isPointLight!==!0&&B.updateMatrices(D,E);let nt=(B.camera.layers.mask&4294967294)!==0?B.camera.layers:E.layers;for(let dt=0;dt<Z;dt++){let ft=B.getCamera(dt);if(D.isPointLight){let st=B.camera,yt=B.matrix,xt=D.distance||st.far;xt!==st.far&&(st.far=xt,st.updateProjectionMatrix()),kc.setFromMatrixPosition(D.matrixWorld),st.position.copy(kc),Km.copy(st.position),Km.add(mP[dt]),st.up.copy(gP[dt]),st.lookAt(Km),st.updateMatrixWorld(),yt.makeTranslation(-kc.x,-kc.y,-kc.z),qy.multiplyMatrices(st.projectionMatrix,st.matrixWorldInverse),B._frustum.setFromProjectionMatrix(qy,st.coordinateSystem,st.reversedDepth)}if(B.map.isWebGLCubeRenderTarget)n.setRenderTarget(B.map,dt),n.clear();else{dt===0&&(n.setRenderTarget(B.map),n.clear());let st=B.getViewport(dt);o.set(r.x*st.x,r.y*st.y,r.x*st.z,r.y*st.w),H.viewport(o)}i=B.getFrustum(dt),v(y,E,ft,D,nt,this.type)}B.isPointLightShadow!==!0&&this.type===Ya&&x(B,E),B.needsUpdate=!1}g=this.type,m.needsUpdate=!1,n.setRenderTarget(U,L,N)};function x(w,y){let E=t.update(_);d.defines.VSM_SAMPLES!==w.blurSamples&&(d.defines.VSM_SAMPLES=w.blurSamples,f.defines.VSM_SAMPLES=w.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),w.mapPass===null?w.mapPass=new Qi(s.x,s.y,{format:lo,type:Ls}):(w.mapPass.width!==w.map.width||w.mapPass.height!==w.map.height)&&w.mapPass.setSize(w.map.width,w.map.height),d.uniforms.shadow_pass.value=w.map.depthTexture,d.uniforms.resolution.value.set(w.map.width,w.map.height),d.uniforms.radius.value=w.radius,n.setRenderTarget(w.mapPass),n.clear(),n.renderBufferDirect(y,null,E,d,_,null),f.uniforms.shadow_pass.value=w.mapPass.texture,f.uniforms.resolution.value.set(w.map.width,w.map.height),f.uniforms.radius.value=w.radius,n.setRenderTarget(w.map),n.clear(),n.renderBufferDirect(y,null,E,f,_,null)}function S(w,y,E,U){let L=null,N=E.isPointLight===!0?w.customDistanceMaterial:w.customDepthMaterial;if(N!==void 0)L=N;else if(L=E.isPointLight===!0?c:a,n.localClippingEnabled&&y.clipShadows===!0&&Array.isArray(y.clippingPlanes)&&y.clippingPlanes.length!==0||y.displacementMap&&y.displacementScale!==0||y.alphaMap&&y.alphaTest>0||y.map&&y.alphaTest>0||y.alphaToCoverage===!0){let H=L.uuid,$=y.uuid,P=l[H];P===void 0&&(P={},l[H]=P);let z=P[$];z===void 0&&(z=L.clone(),P[$]=z,y.addEventListener("dispose",A)),L=z}if(L.visible=y.visible,L.wireframe=y.wireframe,U===Ya?L.side=y.shadowSide!==null?y.shadowSide:y.side:L.side=y.shadowSide!==null?y.shadowSide:h[y.side],L.alphaMap=y.alphaMap,L.alphaTest=y.alphaToCoverage===!0?.5:y.alphaTest,L.map=y.map,L.clipShadows=y.clipShadows,L.clippingPlanes=y.clippingPlanes,L.clipIntersection=y.clipIntersection,L.displacementMap=y.displacementMap,L.displacementScale=y.displacementScale,L.displacementBias=y.displacementBias,L.wireframeLinewidth=y.wireframeLinewidth,L.linewidth=y.linewidth,E.isPointLight===!0&&L.isMeshDistanceMaterial===!0){let H=n.properties.get(L);H.light=E}return L}function v(w,y,E,U,L,N){if(w.visible===!1)return;if(w.layers.test(L)&&(w.isMesh||w.isLine||w.isPoints)&&(w.castShadow||w.receiveShadow&&N===Ya)&&(!w.frustumCulled||w.intersectsFrustum(i))){w.modelViewMatrix.multiplyMatrices(E.matrixWorldInverse,w.matrixWorld);let P=t.update(w),z=w.material;if(Array.isArray(z)){let D=P.groups;for(let B=0,Q=D.length;B<Q;B++){let Y=D[B],Z=z[Y.materialIndex];if(Z&&Z.visible){let nt=S(w,Z,U,N);w.onBeforeShadow(n,w,y,E,P,nt,Y),n.renderBufferDirect(E,null,P,nt,w,Y),w.onAfterShadow(n,w,y,E,P,nt,Y)}}}else if(z.visible){let D=S(w,z,U,N);w.onBeforeShadow(n,w,y,E,P,D,null),n.renderBufferDirect(E,null,P,D,w,null),w.onAfterShadow(n,w,y,E,P,D,null)}}let $=w.children;for(let P=0,z=$.length;P<z;P++)v($[P],y,E,U,L,N)}function A(w){w.target.removeEventListener("dispose",A);for(let E in l){let U=l[E],L=w.target.uuid;L in U&&(U[L].dispose(),delete U[L])}}}function _P(n,t){function e(){let V=!1,lt=new bn,ot=null,Pt=new bn(0,0,0,0);return{setMask:function(Mt){ot!==Mt&&!V&&(n.colorMask(Mt,Mt,Mt,Mt),ot=Mt)},setLocked:function(Mt){V=Mt},setClear:function(Mt,Rt,Zt,oe,pt){pt===!0&&(Mt*=oe,Rt*=oe,Zt*=oe),lt.set(Mt,Rt,Zt,oe),Pt.equals(lt)===!1&&(n.clearColor(Mt,Rt,Zt,oe),Pt.copy(lt))},reset:function(){V=!1,ot=null,Pt.set(-1,0,0,0)}}}function i(){let V=!1,lt=!1,ot=null,Pt=null,Mt=null;return{setReversed:function(Rt){if(lt!==Rt){let Zt=t.get("EXT_clip_control");Rt?Zt.clipControlEXT(Zt.LOWER_LEFT_EXT,Zt.ZERO_TO_ONE_EXT):Zt.clipControlEXT(Zt.LOWER_LEFT_EXT,Zt.NEGATIVE_ONE_TO_ONE_EXT),lt=Rt;let oe=Mt;Mt=null,this.setClear(oe)}},getReversed:function(){return lt},setTest:function(Rt){Rt?At(n.DEPTH_TEST):Jt(n.DEPTH_TEST)},setMask:function(Rt){ot!==Rt&&!V&&(n.depthMask(Rt),ot=Rt)},setFunc:function(Rt){if(lt&&(Rt=by[Rt]),Pt!==Rt){switch(Rt){case fh:n.depthFunc(n.NEVER);break;case ph:n.depthFunc(n.ALWAYS);break;case mh:n.depthFunc(n.LESS);break;case Oa:n.depthFunc(n.LEQUAL);break;case gh:n.depthFunc(n.EQUAL);break;case xh:n.depthFunc(n.GEQUAL);break;case _h:n.depthFunc(n.GREATER);break;case yh:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Pt=Rt}},setLocked:function(Rt){V=Rt},setClear:function(Rt){Mt!==Rt&&(Mt=Rt,lt&&(Rt=1-Rt),n.clearDepth(Rt))},reset:function(){V=!1,ot=null,Pt=null,Mt=null,lt=!1}}}function s(){let V=!1,lt=null,ot=null,Pt=null,Mt=null,Rt=null,Zt=null,oe=null,pt=null;return{setTest:function($t){V||($t?At(n.STENCIL_TEST):Jt(n.STENCIL_TEST))},setMask:function($t){lt!==$t&&!V&&(n.stencilMask($t),lt=$t)},setFunc:function($t,ae,Dt){(ot!==$t||Pt!==ae||Mt!==Dt)&&(n.stencilFunc($t,ae,Dt),ot=$t,Pt=ae,Mt=Dt)},setOp:function($t,ae,Dt){(Rt!==$t||Zt!==ae||oe!==Dt)&&(n.stencilOp($t,ae,Dt),Rt=$t,Zt=ae,oe=Dt)},setLocked:function($t){V=$t},setClear:function($t){pt!==$t&&(n.clearStencil($t),pt=$t)},reset:function(){V=!1,lt=null,ot=null,Pt=null,Mt=null,Rt=null,Zt=null,oe=null,pt=null}}}let r=new e,o=new i,a=new s,c={},l=new WeakMap,u={},h={},d={},f=new WeakMap,p=[],_=null,m=!1,g=null,x=null,S=null,v=null,A=null,w=null,y=null,E=new ee(0,0,0),U=0,L=!1,N=null,H=null,$=null,P=null,z=null,D=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),B=!1,Q=0,Y=n.getParameter(n.VERSION);Y.indexOf("WebGL")!==-1?(Q=parseFloat(/^WebGL (\d)/.exec(Y)[1]),B=Q>=1):Y.indexOf("OpenGL ES")!==-1&&(Q=parseFloat(/^OpenGL ES (\d)/.exec(Y)[1]),B=Q>=2);let Z=null,nt={},dt=n.getParameter(n.SCISSOR_BOX),ft=n.getParameter(n.VIEWPORT),st=new bn().fromArray(dt),yt=new bn().fromArray(ft);function xt(V,lt,ot,Pt){let Mt=new Uint8Array(4),Rt=n.createTexture();n.bindTexture(V,Rt),n.texParameteri(V,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(V,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Zt=0;Zt<ot;Zt++)V===n.TEXTURE_3D||V===n.TEXTURE_2D_ARRAY?n.texImage3D(lt,0,n.RGBA,1,1,Pt,0,n.RGBA,n.UNSIGNED_BYTE,Mt):n.texImage2D(lt+Zt,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,Mt);return Rt}let Tt={};Tt[n.TEXTURE_2D]=xt(n.TEXTURE_2D,n.TEXTURE_2D,1),Tt[n.TEXTURE_CUBE_MAP]=xt(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Tt[n.TEXTURE_2D_ARRAY]=xt(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Tt[n.TEXTURE_3D]=xt(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),At(n.DEPTH_TEST),o.setFunc(Oa),In(!1),Je(pm),At(n.CULL_FACE),xn(zo);function At(V){u[V]!==!0&&(n.enable(V),u[V]=!0)}function Jt(V){u[V]!==!1&&(n.disable(V),u[V]=!1)}function ge(V,lt){return d[V]!==lt?(n.bindFramebuffer(V,lt),d[V]=lt,V===n.DRAW_FRAMEBUFFER&&(d[n.FRAMEBUFFER]=lt),V===n.FRAMEBUFFER&&(d[n.DRAW_FRAMEBUFFER]=lt),!0):!1}function jt(V,lt){let ot=p,Pt=!1;if(V){ot=f.get(lt),ot===void 0&&(ot=[],f.set(lt,ot));let Mt=V.textures;if(ot.length!==Mt.length||ot[0]!==n.COLOR_ATTACHMENT0){for(let Rt=0,Zt=Mt.length;Rt<Zt;Rt++)ot[Rt]=n.COLOR_ATTACHMENT0+Rt;ot.length=Mt.length,Pt=!0}}else ot[0]!==n.BACK&&(ot[0]=n.BACK,Pt=!0);Pt&&n.drawBuffers(ot)}function Te(V){return _!==V?(n.useProgram(V),_=V,!0):!1}let Me={[Ho]:n.FUNC_ADD,[W_]:n.FUNC_SUBTRACT,[$_]:n.FUNC_REVERSE_SUBTRACT};Me[q_]=n.MIN,Me[X_]=n.MAX;let pe={[Y_]:n.ZERO,[j_]:n.ONE,[Z_]:n.SRC_COLOR,[_m]:n.SRC_ALPHA,[ny]:n.SRC_ALPHA_SATURATE,[ty]:n.DST_COLOR,[K_]:n.DST_ALPHA,[J_]:n.ONE_MINUS_SRC_COLOR,[ym]:n.ONE_MINUS_SRC_ALPHA,[ey]:n.ONE_MINUS_DST_COLOR,[Q_]:n.ONE_MINUS_DST_ALPHA,[iy]:n.CONSTANT_COLOR,[sy]:n.ONE_MINUS_CONSTANT_COLOR,[ry]:n.CONSTANT_ALPHA,[oy]:n.ONE_MINUS_CONSTANT_ALPHA};function xn(V,lt,ot,Pt,Mt,Rt,Zt,oe,pt,$t){if(V===zo){m===!0&&(Jt(n.BLEND),m=!1);return}if(m===!1&&(At(n.BLEND),m=!0),V!==V_){if(V!==g||$t!==L){if((x!==Ho||A!==Ho)&&(n.blendEquation(n.FUNC_ADD),x=Ho,A=Ho),$t)switch(V){case ja:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case mm:n.blendFunc(n.ONE,n.ONE);break;case gm:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case xm:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:le("WebGLState: Invalid blending: ",V);break}else switch(V){case ja:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case mm:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case gm:le("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case xm:le("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:le("WebGLState: Invalid blending: ",V);break}S=null,v=null,w=null,y=null,E.set(0,0,0),U=0,g=V,L=$t}return}Mt=Mt||lt,Rt=Rt||ot,Zt=Zt||Pt,(lt!==x||Mt!==A)&&(n.blendEquationSeparate(Me[lt],Me[Mt]),x=lt,A=Mt),(ot!==S||Pt!==v||Rt!==w||Zt!==y)&&(n.blendFuncSeparate(pe[ot],pe[Pt],pe[Rt],pe[Zt]),S=ot,v=Pt,w=Rt,y=Zt),(oe.equals(E)===!1||pt!==U)&&(n.blendColor(oe.r,oe.g,oe.b,pt),E.copy(oe),U=pt),g=V,L=!1}function on(V,lt){V.side===pi?Jt(n.CULL_FACE):At(n.CULL_FACE);let ot=V.side===oi;lt&&(ot=!ot),In(ot),V.blending===ja&&V.transparent===!1?xn(zo):xn(V.blending,V.blendEquation,V.blendSrc,V.blendDst,V.blendEquationAlpha,V.blendSrcAlpha,V.blendDstAlpha,V.blendColor,V.blendAlpha,V.premultipliedAlpha),o.setFunc(V.depthFunc),o.setTest(V.depthTest),o.setMask(V.depthWrite),r.setMask(V.colorWrite);let Pt=V.stencilWrite;a.setTest(Pt),Pt&&(a.setMask(V.stencilWriteMask),a.setFunc(V.stencilFunc,V.stencilRef,V.stencilFuncMask),a.setOp(V.stencilFail,V.stencilZFail,V.stencilZPass)),Ue(V.polygonOffset,V.polygonOffsetFactor,V.polygonOffsetUnits),V.alphaToCoverage===!0?At(n.SAMPLE_ALPHA_TO_COVERAGE):Jt(n.SAMPLE_ALPHA_TO_COVERAGE)}function In(V){N!==V&&(V?n.frontFace(n.CW):n.frontFace(n.CCW),N=V)}function Je(V){V!==z_?(At(n.CULL_FACE),V!==H&&(V===pm?n.cullFace(n.BACK):V===H_?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Jt(n.CULL_FACE),H=V}function Zn(V){V!==$&&(B&&n.lineWidth(V),$=V)}function Ue(V,lt,ot){V?(At(n.POLYGON_OFFSET_FILL),(P!==lt||z!==ot)&&(P=lt,z=ot,o.getReversed()&&(lt=-lt,ot=-ot),n.polygonOffset(lt,ot))):Jt(n.POLYGON_OFFSET_FILL)}function kn(V){V?At(n.SCISSOR_TEST):Jt(n.SCISSOR_TEST)}function Sn(V){V===void 0&&(V=n.TEXTURE0+D-1),Z!==V&&(n.activeTexture(V),Z=V)}function Ln(V,lt,ot){ot===void 0&&(Z===null?ot=n.TEXTURE0+D-1:ot=Z);let Pt=nt[ot];Pt===void 0&&(Pt={type:void 0,texture:void 0},nt[ot]=Pt),(Pt.type!==V||Pt.texture!==lt)&&(Z!==ot&&(n.activeTexture(ot),Z=ot),n.bindTexture(V,lt||Tt[V]),Pt.type=V,Pt.texture=lt)}function W(){let V=nt[Z];V!==void 0&&V.type!==void 0&&(n.bindTexture(V.type,null),V.type=void 0,V.texture=void 0)}function Nt(){try{n.compressedTexImage2D(...arguments)}catch(V){le("WebGLState:",V)}}function se(){try{n.compressedTexImage3D(...arguments)}catch(V){le("WebGLState:",V)}}function xe(){try{n.texSubImage2D(...arguments)}catch(V){le("WebGLState:",V)}}function Ct(){try{n.texSubImage3D(...arguments)}catch(V){le("WebGLState:",V)}}function Qe(){try{n.compressedTexSubImage2D(...arguments)}catch(V){le("WebGLState:",V)}}function Yt(){try{n.compressedTexSubImage3D(...arguments)}catch(V){le("WebGLState:",V)}}function ne(){try{n.texStorage2D(...arguments)}catch(V){le("WebGLState:",V)}}function O(){try{n.texStorage3D(...arguments)}catch(V){le("WebGLState:",V)}}function R(){try{n.texImage2D(...arguments)}catch(V){le("WebGLState:",V)}}function j(){try{n.texImage3D(...arguments)}catch(V){le("WebGLState:",V)}}function gt(V){return h[V]!==void 0?h[V]:n.getParameter(V)}function ct(V,lt){h[V]!==lt&&(n.pixelStorei(V,lt),h[V]=lt)}function St(V){st.equals(V)===!1&&(n.scissor(V.x,V.y,V.z,V.w),st.copy(V))}function wt(V){yt.equals(V)===!1&&(n.viewport(V.x,V.y,V.z,V.w),yt.copy(V))}function rt(V,lt){let ot=l.get(lt);ot===void 0&&(ot=new WeakMap,l.set(lt,ot));let Pt=ot.get(V);Pt===void 0&&(Pt=n.getUniformBlockIndex(lt,V.name),n.uniformBlockBinding(lt,Pt,Pt),ot.set(V,Pt))}function at(V,lt,ot){let Mt=l.get(lt).get(V);c[Mt]!==ot&&(n.bindBufferBase(n.UNIFORM_BUFFER,Mt,ot),c[Mt]=ot)}function vt(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},h={},Z=null,nt={},d={},c={},f=new WeakMap,p=[],_=null,m=!1,g=null,x=null,S=null,v=null,A=null,w=null,y=null,E=new ee(0,0,0),U=0,L=!1,N=null,H=null,$=null,P=null,z=null,st.set(0,0,n.canvas.width,n.canvas.height),yt.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:At,disable:Jt,bindFramebuffer:ge,drawBuffers:jt,useProgram:Te,setBlending:xn,setMaterial:on,setFlipSided:In,setCullFace:Je,setLineWidth:Zn,setPolygonOffset:Ue,setScissorTest:kn,activeTexture:Sn,bindTexture:Ln,unbindTexture:W,compressedTexImage2D:Nt,compressedTexImage3D:se,texImage2D:R,texImage3D:j,pixelStorei:ct,getParameter:gt,updateUBOMapping:rt,uniformBlockBinding:at,texStorage2D:ne,texStorage3D:O,texSubImage2D:xe,texSubImage3D:Ct,compressedTexSubImage2D:Qe,compressedTexSubImage3D:Yt,scissor:St,viewport:wt,reset:vt}}function yP(n,t,e,i,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,c=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),l=new Qt,u=new WeakMap,h=new Set,d,f=new WeakMap,p=new Set,_=new FinalizationRegistry(O=>p.delete(O)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(O,R){return m?new OffscreenCanvas(O,R):hc("canvas")}function x(O,R,j){let gt=1,ct=ne(O);if((ct.width>j||ct.height>j)&&(gt=j/Math.max(ct.width,ct.height)),gt<1)if(typeof HTMLImageElement<"u"&&O instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&O instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&O instanceof ImageBitmap||typeof VideoFrame<"u"&&O instanceof VideoFrame){let St=Math.floor(gt*ct.width),wt=Math.floor(gt*ct.height);d===void 0&&(d=g(St,wt));let rt=R?g(St,wt):d;return rt.width=St,rt.height=wt,rt.getContext("2d").drawImage(O,0,0,St,wt),ie("WebGLRenderer: Texture has been resized from ("+ct.width+"x"+ct.height+") to ("+St+"x"+wt+")."),rt}else return"data"in O&&ie("WebGLRenderer: Image in DataTexture is too big ("+ct.width+"x"+ct.height+")."),O;return O}function S(O){return O.generateMipmaps}function v(O){n.generateMipmap(O)}function A(O){return O.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:O.isWebGL3DRenderTarget?n.TEXTURE_3D:O.isWebGLArrayRenderTarget||O.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function w(O,R,j,gt,ct,St=!1){if(O!==null){if(n[O]!==void 0)return n[O];ie("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+O+"'")}let wt;gt&&(wt=t.get("EXT_texture_norm16"),wt||ie("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let rt=R;if(R===n.RED&&(j===n.FLOAT&&(rt=n.R32F),j===n.HALF_FLOAT&&(rt=n.R16F),j===n.UNSIGNED_BYTE&&(rt=n.R8),j===n.UNSIGNED_SHORT&&wt&&(rt=wt.R16_EXT),j===n.SHORT&&wt&&(rt=wt.R16_SNORM_EXT)),R===n.RED_INTEGER&&(j===n.UNSIGNED_BYTE&&(rt=n.R8UI),j===n.UNSIGNED_SHORT&&(rt=n.R16UI),j===n.UNSIGNED_INT&&(rt=n.R32UI),j===n.BYTE&&(rt=n.R8I),j===n.SHORT&&(rt=n.R16I),j===n.INT&&(rt=n.R32I)),R===n.RG&&(j===n.FLOAT&&(rt=n.RG32F),j===n.HALF_FLOAT&&(rt=n.RG16F),j===n.UNSIGNED_BYTE&&(rt=n.RG8),j===n.UNSIGNED_SHORT&&wt&&(rt=wt.RG16_EXT),j===n.SHORT&&wt&&(rt=wt.RG16_SNORM_EXT)),R===n.RG_INTEGER&&(j===n.UNSIGNED_BYTE&&(rt=n.RG8UI),j===n.UNSIGNED_SHORT&&(rt=n.RG16UI),j===n.UNSIGNED_INT&&(rt=n.RG32UI),j===n.BYTE&&(rt=n.RG8I),j===n.SHORT&&(rt=n.RG16I),j===n.INT&&(rt=n.RG32I)),R===n.RGB_INTEGER&&(j===n.UNSIGNED_BYTE&&(rt=n.RGB8UI),j===n.UNSIGNED_SHORT&&(rt=n.RGB16UI),j===n.UNSIGNED_INT&&(rt=n.RGB32UI),j===n.BYTE&&(rt=n.RGB8I),j===n.SHORT&&(rt=n.RGB16I),j===n.INT&&(rt=n.RGB32I)),R===n.RGBA_INTEGER&&(j===n.UNSIGNED_BYTE&&(rt=n.RGBA8UI),j===n.UNSIGNED_SHORT&&(rt=n.RGBA16UI),j===n.UNSIGNED_INT&&(rt=n.RGBA32UI),j===n.BYTE&&(rt=n.RGBA8I),j===n.SHORT&&(rt=n.RGBA16I),j===n.INT&&(rt=n.RGBA32I)),R===n.RGB&&(j===n.UNSIGNED_SHORT&&wt&&(rt=wt.RGB16_EXT),j===n.SHORT&&wt&&(rt=wt.RGB16_SNORM_EXT),j===n.UNSIGNED_INT_5_9_9_9_REV&&(rt=n.RGB9_E5),j===n.UNSIGNED_INT_10F_11F_11F_REV&&(rt=n.R11F_G11F_B10F)),R===n.RGBA){let at=St?cc:De.getTransfer(ct);j===n.FLOAT&&(rt=n.RGBA32F),j===n.HALF_FLOAT&&(rt=n.RGBA16F),j===n.UNSIGNED_BYTE&&(rt=at===$e?n.SRGB8_ALPHA8:n.RGBA8),j===n.UNSIGNED_SHORT&&wt&&(rt=wt.RGBA16_EXT),j===n.SHORT&&wt&&(rt=wt.RGBA16_SNORM_EXT),j===n.UNSIGNED_SHORT_4_4_4_4&&(rt=n.RGBA4),j===n.UNSIGNED_SHORT_5_5_5_1&&(rt=n.RGB5_A1)}return(rt===n.R16F||rt===n.R32F||rt===n.RG16F||rt===n.RG32F||rt===n.RGBA16F||rt===n.RGBA32F)&&t.get("EXT_color_buffer_float"),rt}function y(O,R){let j;return O?R===null||R===Is||R===Vo?j=n.DEPTH24_STENCIL8:R===ds?j=n.DEPTH32F_STENCIL8:R===Ja&&(j=n.DEPTH24_STENCIL8,ie("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):R===null||R===Is||R===Vo?j=n.DEPTH_COMPONENT24:R===ds?j=n.DEPTH_COMPONENT32F:R===Ja&&(j=n.DEPTH_COMPONENT16),j}function E(O,R){return S(O)===!0||O.isFramebufferTexture&&O.minFilter!==ni&&O.minFilter!==Ai?Math.log2(Math.max(R.width,R.height))+1:O.mipmaps.length>0?O.mipmaps.length:O.isCompressedTexture&&Array.isArray(O.image)?R.mipmaps.length:1}function U(O){let R=new WeakRef(O);i.get(O).__ref=R,p.add(R),_.register(O,R,R)}function L(O){let R=i.get(O).__ref;R!==void 0&&(p.delete(R),_.unregister(R))}function N(O){$(O.target)}function H(O){P(O.target)}function $(O){O.removeEventListener("dispose",N),L(O),D(O),O.isVideoTexture&&u.delete(O),O.isHTMLTexture&&h.delete(O)}function P(O){O.removeEventListener("dispose",H),L(O),Q(O)}function z(){for(let O of p){let R=O.deref();R!==void 0&&(R.isRenderTarget===!0?P(R):$(R))}p.clear(),h.clear()}function D(O){let R=i.get(O);if(R.__webglInit===void 0)return;let j=O.source,gt=f.get(j);if(gt){let ct=gt[R.__cacheKey];ct.usedTimes--,ct.usedTimes===0&&B(O),Object.keys(gt).length===0&&f.delete(j)}i.remove(O)}function B(O){let R=i.get(O);n.deleteTexture(R.__webglTexture);let j=O.source,gt=f.get(j);delete gt[R.__cacheKey],o.memory.textures--}function Q(O){let R=i.get(O);R.__depthDisposeCallback&&R.__depthDisposeCallback();let j=O.depthTexture;if(j&&j.renderTarget===O&&$(j),O.isWebGLCubeRenderTarget)for(let ct=0;ct<6;ct++){if(Array.isArray(R.__webglFramebuffer[ct]))for(let St=0;St<R.__webglFramebuffer[ct].length;St++)n.deleteFramebuffer(R.__webglFramebuffer[ct][St]);else n.deleteFramebuffer(R.__webglFramebuffer[ct]);R.__webglDepthbuffer&&n.deleteRenderbuffer(R.__webglDepthbuffer[ct])}else{if(Array.isArray(R.__webglFramebuffer))for(let ct=0;ct<R.__webglFramebuffer.length;ct++)n.deleteFramebuffer(R.__webglFramebuffer[ct]);else n.deleteFramebuffer(R.__webglFramebuffer);if(R.__webglDepthbuffer&&n.deleteRenderbuffer(R.__webglDepthbuffer),R.__webglMultisampledFramebuffer&&n.deleteFramebuffer(R.__webglMultisampledFramebuffer),R.__webglColorRenderbuffer)for(let ct=0;ct<R.__webglColorRenderbuffer.length;ct++)R.__webglColorRenderbuffer[ct]&&n.deleteRenderbuffer(R.__webglColorRenderbuffer[ct]);R.__webglDepthRenderbuffer&&n.deleteRenderbuffer(R.__webglDepthRenderbuffer)}let gt=O.textures;for(let ct=0,St=gt.length;ct<St;ct++){let wt=i.get(gt[ct]);wt.__webglTexture&&(n.deleteTexture(wt.__webglTexture),o.memory.textures--),i.remove(gt[ct])}i.remove(O)}let Y=0;function Z(){Y=0}function nt(){return Y}function dt(O){Y=O}function ft(){let O=Y;return O>=s.maxTextures&&ie("WebGLTextures: Trying to use "+(O+1)+" texture units while this GPU supports only "+s.maxTextures),Y+=1,O}function st(O){let R=[];return R.push(O.wrapS),R.push(O.wrapT),R.push(O.wrapR||0),R.push(O.magFilter),R.push(O.minFilter),R.push(O.anisotropy),R.push(O.internalFormat),R.push(O.format),R.push(O.type),R.push(O.generateMipmaps),R.push(O.mipmapsAutoUpdate),R.push(O.premultiplyAlpha),R.push(O.flipY),R.push(O.unpackAlignment),R.push(O.colorSpace),R.join()}function yt(O,R){let j=i.get(O);if(O.isVideoTexture&&Qe(O),O.isRenderTargetTexture===!1&&O.isExternalTexture!==!0&&O.version>0&&j.__version!==O.version){let gt=O.image;if(gt===null)ie("WebGLRenderer: Texture marked for update but no image data found.");else if(gt.complete===!1)ie("WebGLRenderer: Texture marked for update but image is incomplete");else{on(j,O,R);return}}else O.isExternalTexture&&(j.__webglTexture=O.sourceTexture?O.sourceTexture:null);e.bindTexture(n.TEXTURE_2D,j.__webglTexture,n.TEXTURE0+R)}function xt(O,R){let j=i.get(O);if(O.isRenderTargetTexture===!1&&O.version>0&&j.__version!==O.version){on(j,O,R);return}else O.isExternalTexture&&(j.__webglTexture=O.sourceTexture?O.sourceTexture:null);e.bindTexture(n.TEXTURE_2D_ARRAY,j.__webglTexture,n.TEXTURE0+R)}function Tt(O,R){let j=i.get(O);if(O.isRenderTargetTexture===!1&&O.version>0&&j.__version!==O.version){on(j,O,R);return}e.bindTexture(n.TEXTURE_3D,j.__webglTexture,n.TEXTURE0+R)}function At(O,R){let j=i.get(O);if(O.version>0&&j.__version!==O.version){In(j,O,R);return}e.bindTexture(n.TEXTURE_CUBE_MAP,j.__webglTexture,n.TEXTURE0+R)}let Jt={[vh]:n.REPEAT,[tr]:n.CLAMP_TO_EDGE,[bh]:n.MIRRORED_REPEAT},ge={[ni]:n.NEAREST,[cy]:n.NEAREST_MIPMAP_NEAREST,[Lc]:n.NEAREST_MIPMAP_LINEAR,[Ai]:n.LINEAR,[Xh]:n.LINEAR_MIPMAP_NEAREST,[Lr]:n.LINEAR_MIPMAP_LINEAR},jt={[fy]:n.NEVER,[zm]:n.ALWAYS,[py]:n.LESS,[Bm]:n.LEQUAL,[my]:n.EQUAL,[km]:n.GEQUAL,[gy]:n.GREATER,[xy]:n.NOTEQUAL};function Te(O,R){if(R.type===ds&&t.has("OES_texture_float_linear")===!1&&(R.magFilter===Ai||R.magFilter===Xh||R.magFilter===Lc||R.magFilter===Lr||R.minFilter===Ai||R.minFilter===Xh||R.minFilter===Lc||R.minFilter===Lr)&&ie("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(O,n.TEXTURE_WRAP_S,Jt[R.wrapS]),n.texParameteri(O,n.TEXTURE_WRAP_T,Jt[R.wrapT]),(O===n.TEXTURE_3D||O===n.TEXTURE_2D_ARRAY)&&n.texParameteri(O,n.TEXTURE_WRAP_R,Jt[R.wrapR]),n.texParameteri(O,n.TEXTURE_MAG_FILTER,ge[R.magFilter]),n.texParameteri(O,n.TEXTURE_MIN_FILTER,ge[R.minFilter]),R.compareFunction&&(n.texParameteri(O,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(O,n.TEXTURE_COMPARE_FUNC,jt[R.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(R.magFilter===ni||R.minFilter!==Lc&&R.minFilter!==Lr||R.type===ds&&t.has("OES_texture_float_linear")===!1)return;if(R.anisotropy>1||i.get(R).__currentAnisotropy){let j=t.get("EXT_texture_filter_anisotropic");n.texParameterf(O,j.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(R.anisotropy,s.getMaxAnisotropy())),i.get(R).__currentAnisotropy=R.anisotropy}}}function Me(O,R){let j=!1;O.__webglInit===void 0&&(O.__webglInit=!0,R.addEventListener("dispose",N),U(R));let gt=R.source,ct=f.get(gt);ct===void 0&&(ct={},f.set(gt,ct));let St=st(R);if(St!==O.__cacheKey){ct[St]===void 0&&(ct[St]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,j=!0),ct[St].usedTimes++;let wt=ct[O.__cacheKey];wt!==void 0&&(ct[O.__cacheKey].usedTimes--,wt.usedTimes===0&&B(R)),O.__cacheKey=St,O.__webglTexture=ct[St].texture}return j}function pe(O,R,j){return Math.floor(Math.floor(O/j)/R)}function xn(O,R,j,gt){let St=O.updateRanges;if(St.length===0)e.texSubImage2D(n.TEXTURE_2D,0,0,0,R.width,R.height,j,gt,R.data);else{St.sort((V,lt)=>V.start-lt.start);let wt=0;for(let V=1;V<St.length;V++){let lt=St[wt],ot=St[V],Pt=lt.start+lt.count,Mt=pe(ot.start,R.width,4),Rt=pe(lt.start,R.width,4);ot.start<=Pt+1&&Mt===Rt&&pe(ot.start+ot.count-1,R.width,4)===Mt?lt.count=Math.max(lt.count,ot.start+ot.count-lt.start):(++wt,St[wt]=ot)}St.length=wt+1;let rt=e.getParameter(n.UNPACK_ROW_LENGTH),at=e.getParameter(n.UNPACK_SKIP_PIXELS),vt=e.getParameter(n.UNPACK_SKIP_ROWS);e.pixelStorei(n.UNPACK_ROW_LENGTH,R.width);for(let V=0,lt=St.length;V<lt;V++){let ot=St[V],Pt=Math.floor(ot.start/4),Mt=Math.ceil(ot.count/4),Rt=Pt%R.width,Zt=Math.floor(Pt/R.width),oe=Mt,pt=1;e.pixelStorei(n.UNPACK_SKIP_PIXELS,Rt),e.pixelStorei(n.UNPACK_SKIP_ROWS,Zt),e.texSubImage2D(n.TEXTURE_2D,0,Rt,Zt,oe,pt,j,gt,R.data)}O.clearUpdateRanges(),e.pixelStorei(n.UNPACK_ROW_LENGTH,rt),e.pixelStorei(n.UNPACK_SKIP_PIXELS,at),e.pixelStorei(n.UNPACK_SKIP_ROWS,vt)}}function on(O,R,j){let gt=n.TEXTURE_2D;(R.isDataArrayTexture||R.isCompressedArrayTexture)&&(gt=n.TEXTURE_2D_ARRAY),R.isData3DTexture&&(gt=n.TEXTURE_3D);let ct=Me(O,R),St=R.source;e.bindTexture(gt,O.__webglTexture,n.TEXTURE0+j);let wt=i.get(St);if(St.version!==wt.__version||ct===!0){if(e.activeTexture(n.TEXTURE0+j),(typeof ImageBitmap<"u"&&R.image instanceof ImageBitmap)===!1){let pt=De.getPrimaries(De.workingColorSpace),$t=R.colorSpace===Nr?null:De.getPrimaries(R.colorSpace),ae=R.colorSpace===Nr||pt===$t?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,R.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,R.premultiplyAlpha),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,ae)}e.pixelStorei(n.UNPACK_ALIGNMENT,R.unpackAlignment);let at=x(R.image,!1,s.maxTextureSize);at=Yt(R,at);let vt=r.convert(R.format,R.colorSpace),V=r.convert(R.type),lt=w(R.internalFormat,vt,V,R.normalized,R.colorSpace,R.isVideoTexture);Te(gt,R);let ot,Pt=R.mipmaps,Mt=R.isVideoTexture!==!0,Rt=wt.__version===void 0||ct===!0,Zt=St.dataReady,oe=E(R,at);if(R.isDepthTexture)lt=y(R.format===Dr,R.type),Rt&&(Mt?e.texStorage2D(n.TEXTURE_2D,1,lt,at.width,at.height):e.texImage2D(n.TEXTURE_2D,0,lt,at.width,at.height,0,vt,V,null));else if(R.isDataTexture)if(Pt.length>0){Mt&&Rt&&e.texStorage2D(n.TEXTURE_2D,oe,lt,Pt[0].width,Pt[0].height);for(let pt=0,$t=Pt.length;pt<$t;pt++)ot=Pt[pt],Mt?Zt&&e.texSubImage2D(n.TEXTURE_2D,pt,0,0,ot.width,ot.height,vt,V,ot.data):e.texImage2D(n.TEXTURE_2D,pt,lt,ot.width,ot.height,0,vt,V,ot.data);R.generateMipmaps=!1}else Mt?(Rt&&e.texStorage2D(n.TEXTURE_2D,oe,lt,at.width,at.height),Zt&&xn(R,at,vt,V)):e.texImage2D(n.TEXTURE_2D,0,lt,at.width,at.height,0,vt,V,at.data);else if(R.isCompressedTexture)if(R.isCompressedArrayTexture){Mt&&Rt&&e.texStorage3D(n.TEXTURE_2D_ARRAY,oe,lt,Pt[0].width,Pt[0].height,at.depth);for(let pt=0,$t=Pt.length;pt<$t;pt++)if(ot=Pt[pt],R.format!==Ds)if(vt!==null)if(Mt){if(Zt)if(R.layerUpdates.size>0){let ae=Zm(ot.width,ot.height,R.format,R.type);for(let Dt of R.layerUpdates){let ye=ot.data.subarray(Dt*ae/ot.data.BYTES_PER_ELEMENT,(Dt+1)*ae/ot.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,pt,0,0,Dt,ot.width,ot.height,1,vt,ye)}}else e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,pt,0,0,0,ot.width,ot.height,at.depth,vt,ot.data)}else e.compressedTexImage3D(n.TEXTURE_2D_ARRAY,pt,lt,ot.width,ot.height,at.depth,0,ot.data,0,0);else ie("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else Mt?Zt&&e.texSubImage3D(n.TEXTURE_2D_ARRAY,pt,0,0,0,ot.width,ot.height,at.depth,vt,V,ot.data):e.texImage3D(n.TEXTURE_2D_ARRAY,pt,lt,ot.width,ot.height,at.depth,0,vt,V,ot.data);R.layerUpdates.size>0&&R.clearLayerUpdates()}else{Mt&&Rt&&e.texStorage2D(n.TEXTURE_2D,oe,lt,Pt[0].width,Pt[0].height);for(let pt=0,$t=Pt.length;pt<$t;pt++)ot=Pt[pt],R.format!==Ds?vt!==null?Mt?Zt&&e.compressedTexSubImage2D(n.TEXTURE_2D,pt,0,0,ot.width,ot.height,vt,ot.data):e.compressedTexImage2D(n.TEXTURE_2D,pt,lt,ot.width,ot.height,0,ot.data):ie("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):Mt?Zt&&e.texSubImage2D(n.TEXTURE_2D,pt,0,0,ot.width,ot.height,vt,V,ot.data):e.texImage2D(n.TEXTURE_2D,pt,lt,ot.width,ot.height,0,vt,V,ot.data)}else if(R.isDataArrayTexture)if(Mt){if(Rt&&e.texStorage3D(n.TEXTURE_2D_ARRAY,oe,lt,at.width,at.height,at.depth),Zt)if(R.layerUpdates.size>0){let pt=Zm(at.width,at.height,R.format,R.type);for(let $t of R.layerUpdates){let ae=at.data.subarray($t*pt/at.data.BYTES_PER_ELEMENT,($t+1)*pt/at.data.BYTES_PER_ELEMENT);e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,$t,at.width,at.height,1,vt,V,ae)}R.clearLayerUpdates()}else e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,at.width,at.height,at.depth,vt,V,at.data)}else e.texImage3D(n.TEXTURE_2D_ARRAY,0,lt,at.width,at.height,at.depth,0,vt,V,at.data);else if(R.isData3DTexture)Mt?(Rt&&e.texStorage3D(n.TEXTURE_3D,oe,lt,at.width,at.height,at.depth),Zt&&e.texSubImage3D(n.TEXTURE_3D,0,0,0,0,at.width,at.height,at.depth,vt,V,at.data)):e.texImage3D(n.TEXTURE_3D,0,lt,at.width,at.height,at.depth,0,vt,V,at.data);else if(R.isFramebufferTexture){if(Rt)if(Mt)e.texStorage2D(n.TEXTURE_2D,oe,lt,at.width,at.height);else{let pt=at.width,$t=at.height;for(let ae=0;ae<oe;ae++)e.texImage2D(n.TEXTURE_2D,ae,lt,pt,$t,0,vt,V,null),pt>>=1,$t>>=1}}else if(R.isHTMLTexture){if("texElementImage2D"in n){let pt=n.canvas;if(pt.hasAttribute("layoutsubtree")||pt.setAttribute("layoutsubtree","true"),at.parentNode!==pt){pt.appendChild(at),h.add(R),pt.onpaint=$t=>{let ae=$t.changedElements;for(let Dt of h)ae.includes(Dt.image)&&(Dt.needsUpdate=!0)},pt.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,at);else{let ae=n.RGBA,Dt=n.RGBA,ye=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,ae,Dt,ye,at)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Pt.length>0){if(Mt&&Rt){let pt=ne(Pt[0]);e.texStorage2D(n.TEXTURE_2D,oe,lt,pt.width,pt.height)}for(let pt=0,$t=Pt.length;pt<$t;pt++)ot=Pt[pt],Mt?Zt&&e.texSubImage2D(n.TEXTURE_2D,pt,0,0,vt,V,ot):e.texImage2D(n.TEXTURE_2D,pt,lt,vt,V,ot);R.generateMipmaps=!1}else if(Mt){if(Rt){let pt=ne(at);e.texStorage2D(n.TEXTURE_2D,oe,lt,pt.width,pt.height)}Zt&&e.texSubImage2D(n.TEXTURE_2D,0,0,0,vt,V,at)}else e.texImage2D(n.TEXTURE_2D,0,lt,vt,V,at);S(R)&&R.mipmapsAutoUpdate===!0&&v(gt),wt.__version=St.version,R.onUpdate&&R.onUpdate(R)}O.__version=R.version}function In(O,R,j){if(R.image.length!==6)return;let gt=Me(O,R),ct=R.source;e.bindTexture(n.TEXTURE_CUBE_MAP,O.__webglTexture,n.TEXTURE0+j);let St=i.get(ct);if(ct.version!==St.__version||gt===!0){e.activeTexture(n.TEXTURE0+j);let wt=De.getPrimaries(De.workingColorSpace),rt=R.colorSpace===Nr?null:De.getPrimaries(R.colorSpace),at=R.colorSpace===Nr||wt===rt?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,R.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,R.premultiplyAlpha),e.pixelStorei(n.UNPACK_ALIGNMENT,R.unpackAlignment),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,at);let vt=R.isCompressedTexture||R.image[0].isCompressedTexture,V=R.image[0]&&R.image[0].isDataTexture,lt=[];for(let Dt=0;Dt<6;Dt++)!vt&&!V?lt[Dt]=x(R.image[Dt],!0,s.maxCubemapSize):lt[Dt]=V?R.image[Dt].image:R.image[Dt],lt[Dt]=Yt(R,lt[Dt]);let ot=lt[0],Pt=r.convert(R.format,R.colorSpace),Mt=r.convert(R.type),Rt=w(R.internalFormat,Pt,Mt,R.normalized,R.colorSpace),Zt=R.isVideoTexture!==!0,oe=St.__version===void 0||gt===!0,pt=ct.dataReady,$t=E(R,ot);Te(n.TEXTURE_CUBE_MAP,R);let ae;if(R.isDepthTexture){if(Rt=y(R.format===Dr,R.type),oe)if(Zt)e.texStorage2D(n.TEXTURE_CUBE_MAP,1,Rt,ot.width,ot.height);else for(let Dt=0;Dt<6;Dt++)e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,0,Rt,ot.width,ot.height,0,Pt,Mt,null)}else if(vt){Zt&&oe&&e.texStorage2D(n.TEXTURE_CUBE_MAP,$t,Rt,ot.width,ot.height);for(let Dt=0;Dt<6;Dt++){ae=lt[Dt].mipmaps;for(let ye=0;ye<ae.length;ye++){let an=ae[ye];R.format!==Ds?Pt!==null?Zt?pt&&e.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,ye,0,0,an.width,an.height,Pt,an.data):e.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,ye,Rt,an.width,an.height,0,an.data):ie("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Zt?pt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,ye,0,0,an.width,an.height,Pt,Mt,an.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,ye,Rt,an.width,an.height,0,Pt,Mt,an.data)}}}else{if(ae=R.mipmaps,Zt&&oe){ae.length>0&&$t++;let Dt=ne(lt[0]);e.texStorage2D(n.TEXTURE_CUBE_MAP,$t,Rt,Dt.width,Dt.height)}for(let Dt=0;Dt<6;Dt++)if(V){Zt?pt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,0,0,0,lt[Dt].width,lt[Dt].height,Pt,Mt,lt[Dt].data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,0,Rt,lt[Dt].width,lt[Dt].height,0,Pt,Mt,lt[Dt].data);for(let ye=0;ye<ae.length;ye++){let _i=ae[ye].image[Dt].image;Zt?pt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,ye+1,0,0,_i.width,_i.height,Pt,Mt,_i.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,ye+1,Rt,_i.width,_i.height,0,Pt,Mt,_i.data)}}else{Zt?pt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,0,0,0,Pt,Mt,lt[Dt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,0,Rt,Pt,Mt,lt[Dt]);for(let ye=0;ye<ae.length;ye++){let an=ae[ye];Zt?pt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,ye+1,0,0,Pt,Mt,an.image[Dt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,ye+1,Rt,Pt,Mt,an.image[Dt])}}}S(R)&&R.mipmapsAutoUpdate===!0&&v(n.TEXTURE_CUBE_MAP),St.__version=ct.version,R.onUpdate&&R.onUpdate(R)}O.__version=R.version}function Je(O,R,j,gt,ct,St){let wt=r.convert(j.format,j.colorSpace),rt=r.convert(j.type),at=w(j.internalFormat,wt,rt,j.normalized,j.colorSpace),vt=i.get(R),V=i.get(j);if(V.__renderTarget=R,!vt.__hasExternalTextures){let lt=Math.max(1,R.width>>St),ot=Math.max(1,R.height>>St);ct===n.TEXTURE_3D||ct===n.TEXTURE_2D_ARRAY?e.texImage3D(ct,St,at,lt,ot,R.depth,0,wt,rt,null):e.texImage2D(ct,St,at,lt,ot,0,wt,rt,null)}e.bindFramebuffer(n.FRAMEBUFFER,O),Ct(R)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,gt,ct,V.__webglTexture,0,xe(R)):(ct===n.TEXTURE_2D||ct>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&ct<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,gt,ct,V.__webglTexture,St),e.bindFramebuffer(n.FRAMEBUFFER,null)}function Zn(O,R,j){if(n.bindRenderbuffer(n.RENDERBUFFER,O),R.depthBuffer){let gt=R.depthTexture,ct=gt&&gt.isDepthTexture?gt.type:null,St=y(R.stencilBuffer,ct),wt=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;Ct(R)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,xe(R),St,R.width,R.height):j?n.renderbufferStorageMultisample(n.RENDERBUFFER,xe(R),St,R.width,R.height):n.renderbufferStorage(n.RENDERBUFFER,St,R.width,R.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,wt,n.RENDERBUFFER,O)}else{let gt=R.textures;for(let ct=0;ct<gt.length;ct++){let St=gt[ct],wt=r.convert(St.format,St.colorSpace),rt=r.convert(St.type),at=w(St.internalFormat,wt,rt,St.normalized,St.colorSpace);Ct(R)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,xe(R),at,R.width,R.height):j?n.renderbufferStorageMultisample(n.RENDERBUFFER,xe(R),at,R.width,R.height):n.renderbufferStorage(n.RENDERBUFFER,at,R.width,R.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function Ue(O,R,j){let gt=R.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(n.FRAMEBUFFER,O),!(R.depthTexture&&R.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ct=i.get(R.depthTexture);ct.__renderTarget=R;let St=gt?R.depthTexture.image[0]:R.depthTexture.image;(!ct.__webglTexture||St.width!==R.width||St.height!==R.height)&&(St.width=R.width,St.height=R.height,R.depthTexture.needsUpdate=!0),gt?At(R.depthTexture,0):yt(R.depthTexture,0);let wt=ct.__webglTexture,rt=xe(R),at=gt?n.TEXTURE_CUBE_MAP_POSITIVE_X+j:n.TEXTURE_2D,vt=R.depthTexture.format===Dr?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(R.depthTexture.format===Ar)Ct(R)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,vt,at,wt,0,rt):n.framebufferTexture2D(n.FRAMEBUFFER,vt,at,wt,0);else if(R.depthTexture.format===Dr)Ct(R)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,vt,at,wt,0,rt):n.framebufferTexture2D(n.FRAMEBUFFER,vt,at,wt,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function kn(O){let R=i.get(O),j=O.isWebGLCubeRenderTarget===!0;if(R.__boundDepthTexture!==O.depthTexture){let gt=O.depthTexture;if(R.__depthDisposeCallback&&R.__depthDisposeCallback(),gt){let ct=()=>{delete R.__boundDepthTexture,delete R.__depthDisposeCallback,gt.removeEventListener("dispose",ct)};gt.addEventListener("dispose",ct),R.__depthDisposeCallback=ct}R.__boundDepthTexture=gt}if(O.depthTexture&&!R.__autoAllocateDepthBuffer)if(j)for(let gt=0;gt<6;gt++)Ue(R.__webglFramebuffer[gt],O,gt);else O.texture.mipmaps.length>0?Ue(R.__webglFramebuffer[0],O,0):Ue(R.__webglFramebuffer,O,0);else if(j){R.__webglDepthbuffer=[];for(let gt=0;gt<6;gt++)if(e.bindFramebuffer(n.FRAMEBUFFER,R.__webglFramebuffer[gt]),R.__webglDepthbuffer[gt]===void 0)R.__webglDepthbuffer[gt]=n.createRenderbuffer(),Zn(R.__webglDepthbuffer[gt],O,!1);else{let ct=O.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,St=R.__webglDepthbuffer[gt];n.bindRenderbuffer(n.RENDERBUFFER,St),n.framebufferRenderbuffer(n.FRAMEBUFFER,ct,n.RENDERBUFFER,St)}}else if(O.texture.mipmaps.length>0?e.bindFramebuffer(n.FRAMEBUFFER,R.__webglFramebuffer[0]):e.bindFramebuffer(n.FRAMEBUFFER,R.__webglFramebuffer),R.__webglDepthbuffer===void 0)R.__webglDepthbuffer=n.createRenderbuffer(),Zn(R.__webglDepthbuffer,O,!1);else{let ct=O.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,St=R.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,St),n.framebufferRenderbuffer(n.FRAMEBUFFER,ct,n.RENDERBUFFER,St)}e.bindFramebuffer(n.FRAMEBUFFER,null)}function Sn(O,R,j){let gt=i.get(O);R!==void 0&&Je(gt.__webglFramebuffer,O,O.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),j!==void 0&&kn(O)}function Ln(O){let R=O.texture,j=i.get(O),gt=i.get(R);O.addEventListener("dispose",H),U(O);let ct=O.textures,St=O.isWebGLCubeRenderTarget===!0,wt=ct.length>1;if(wt||(gt.__webglTexture===void 0&&(gt.__webglTexture=n.createTexture()),gt.__version=R.version,o.memory.textures++),St){j.__webglFramebuffer=[];for(let rt=0;rt<6;rt++)if(R.mipmaps.length>0){j.__webglFramebuffer[rt]=[];for(let at=0;at<R.mipmaps.length;at++)j.__webglFramebuffer[rt][at]=n.createFramebuffer()}else j.__webglFramebuffer[rt]=n.createFramebuffer()}else{if(R.mipmaps.length>0){j.__webglFramebuffer=[];for(let rt=0;rt<R.mipmaps.length;rt++)j.__webglFramebuffer[rt]=n.createFramebuffer()}else j.__webglFramebuffer=n.createFramebuffer();if(wt)for(let rt=0,at=ct.length;rt<at;rt++){let vt=i.get(ct[rt]);vt.__webglTexture===void 0&&(vt.__webglTexture=n.createTexture(),o.memory.textures++)}if(O.samples>0&&Ct(O)===!1){j.__webglMultisampledFramebuffer=n.createFramebuffer(),j.__webglColorRenderbuffer=[],e.bindFramebuffer(n.FRAMEBUFFER,j.__webglMultisampledFramebuffer);for(let rt=0;rt<ct.length;rt++){let at=ct[rt];j.__webglColorRenderbuffer[rt]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,j.__webglColorRenderbuffer[rt]);let vt=r.convert(at.format,at.colorSpace),V=r.convert(at.type),lt=w(at.internalFormat,vt,V,at.normalized,at.colorSpace,O.isXRRenderTarget===!0),ot=xe(O);n.renderbufferStorageMultisample(n.RENDERBUFFER,ot,lt,O.width,O.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+rt,n.RENDERBUFFER,j.__webglColorRenderbuffer[rt])}n.bindRenderbuffer(n.RENDERBUFFER,null),O.depthBuffer&&(j.__webglDepthRenderbuffer=n.createRenderbuffer(),Zn(j.__webglDepthRenderbuffer,O,!0)),e.bindFramebuffer(n.FRAMEBUFFER,null)}}if(St){e.bindTexture(n.TEXTURE_CUBE_MAP,gt.__webglTexture),Te(n.TEXTURE_CUBE_MAP,R);for(let rt=0;rt<6;rt++)if(R.mipmaps.length>0)for(let at=0;at<R.mipmaps.length;at++)Je(j.__webglFramebuffer[rt][at],O,R,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,at);else Je(j.__webglFramebuffer[rt],O,R,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,0);S(R)?v(n.TEXTURE_CUBE_MAP):R.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,R.mipmaps.length-1),e.unbindTexture()}else if(wt){for(let rt=0,at=ct.length;rt<at;rt++){let vt=ct[rt],V=i.get(vt),lt=n.TEXTURE_2D;(O.isWebGL3DRenderTarget||O.isWebGLArrayRenderTarget)&&(lt=O.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(lt,V.__webglTexture),Te(lt,vt),Je(j.__webglFramebuffer,O,vt,n.COLOR_ATTACHMENT0+rt,lt,0),S(vt)&&v(lt)}e.unbindTexture()}else{let rt=n.TEXTURE_2D;if((O.isWebGL3DRenderTarget||O.isWebGLArrayRenderTarget)&&(rt=O.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(rt,gt.__webglTexture),Te(rt,R),R.mipmaps.length>0)for(let at=0;at<R.mipmaps.length;at++)Je(j.__webglFramebuffer[at],O,R,n.COLOR_ATTACHMENT0,rt,at);else Je(j.__webglFramebuffer,O,R,n.COLOR_ATTACHMENT0,rt,0);S(R)?v(rt):R.mipmaps.length>0&&n.texParameteri(rt,n.TEXTURE_MAX_LEVEL,R.mipmaps.length-1),e.unbindTexture()}O.depthBuffer&&kn(O)}function W(O){let R=O.textures;for(let j=0,gt=R.length;j<gt;j++){let ct=R[j];if(S(ct)&&ct.mipmapsAutoUpdate===!0){let St=A(O),wt=i.get(ct).__webglTexture;e.bindTexture(St,wt),v(St),e.unbindTexture()}}}let Nt=[];function se(O){if(O.samples>0){if(Ct(O)===!1){let R=O.textures,j=O.width,gt=O.height,ct=n.COLOR_BUFFER_BIT,St=O.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,wt=i.get(O),rt=R.length>1;if(rt)for(let vt=0;vt<R.length;vt++)e.bindFramebuffer(n.FRAMEBUFFER,wt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+vt,n.RENDERBUFFER,null),e.bindFramebuffer(n.FRAMEBUFFER,wt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+vt,n.TEXTURE_2D,null,0);e.bindFramebuffer(n.READ_FRAMEBUFFER,wt.__webglMultisampledFramebuffer),O.texture.mipmaps.length>0?e.bindFramebuffer(n.DRAW_FRAMEBUFFER,wt.__webglFramebuffer[0]):e.bindFramebuffer(n.DRAW_FRAMEBUFFER,wt.__webglFramebuffer);for(let vt=0;vt<R.length;vt++){if(O.resolveDepthBuffer&&(O.depthBuffer&&(ct|=n.DEPTH_BUFFER_BIT),O.stencilBuffer&&O.resolveStencilBuffer&&(ct|=n.STENCIL_BUFFER_BIT)),rt){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,wt.__webglColorRenderbuffer[vt]);let V=i.get(R[vt]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,V,0)}n.blitFramebuffer(0,0,j,gt,0,0,j,gt,ct,n.NEAREST),c===!0&&(Nt.length=0,Nt.push(n.COLOR_ATTACHMENT0+vt),O.depthBuffer&&O.storeMultisampledDepthBuffer===!1&&Nt.push(St),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Nt))}if(e.bindFramebuffer(n.READ_FRAMEBUFFER,null),e.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),rt)for(let vt=0;vt<R.length;vt++){e.bindFramebuffer(n.FRAMEBUFFER,wt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+vt,n.RENDERBUFFER,wt.__webglColorRenderbuffer[vt]);let V=i.get(R[vt]).__webglTexture;e.bindFramebuffer(n.FRAMEBUFFER,wt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+vt,n.TEXTURE_2D,V,0)}e.bindFramebuffer(n.DRAW_FRAMEBUFFER,wt.__webglMultisampledFramebuffer)}else if(O.depthBuffer&&O.storeMultisampledDepthBuffer===!1&&c){let R=O.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[R])}}}function xe(O){return Math.min(s.maxSamples,O.samples)}function Ct(O){let R=i.get(O);return O.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&R.__useRenderToTexture!==!1}function Qe(O){let R=o.render.frame;u.get(O)!==R&&(u.set(O,R),O.update())}function Yt(O,R){let j=O.colorSpace,gt=O.format,ct=O.type;return O.isCompressedTexture===!0||O.isVideoTexture===!0||j!==lc&&j!==Nr&&(De.getTransfer(j)===$e?(gt!==Ds||ct!==ns)&&ie("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):le("WebGLTextures: Unsupported texture color space:",j)),R}function ne(O){return typeof HTMLImageElement<"u"&&O instanceof HTMLImageElement?(l.width=O.naturalWidth||O.width,l.height=O.naturalHeight||O.height):typeof VideoFrame<"u"&&O instanceof VideoFrame?(l.width=O.displayWidth,l.height=O.displayHeight):(l.width=O.width,l.height=O.height),l}this.allocateTextureUnit=ft,this.resetTextureUnits=Z,this.getTextureUnits=nt,this.setTextureUnits=dt,this.setTexture2D=yt,this.setTexture2DArray=xt,this.setTexture3D=Tt,this.setTextureCube=At,this.rebindTextures=Sn,this.setupRenderTarget=Ln,this.updateRenderTargetMipmap=W,this.updateMultisampleRenderTarget=se,this.setupDepthRenderbuffer=kn,this.setupFrameBufferTexture=Je,this.useMultisampledRTT=Ct,this.dispose=z}function vP(n,t){function e(i,s=Nr){let r,o=De.getTransfer(s);if(i===ns)return n.UNSIGNED_BYTE;if(i===jh)return n.UNSIGNED_SHORT_4_4_4_4;if(i===Zh)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Im)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Lm)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===Cm)return n.BYTE;if(i===Pm)return n.SHORT;if(i===Ja)return n.UNSIGNED_SHORT;if(i===Yh)return n.INT;if(i===Is)return n.UNSIGNED_INT;if(i===ds)return n.FLOAT;if(i===Ls)return n.HALF_FLOAT;if(i===Dm)return n.ALPHA;if(i===Nm)return n.RGB;if(i===Ds)return n.RGBA;if(i===Ar)return n.DEPTH_COMPONENT;if(i===Dr)return n.DEPTH_STENCIL;if(i===Jh)return n.RED;if(i===Kh)return n.RED_INTEGER;if(i===lo)return n.RG;if(i===Qh)return n.RG_INTEGER;if(i===td)return n.RGBA_INTEGER;if(i===Dc||i===Nc||i===Uc||i===Oc)if(o===$e)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===Dc)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===Nc)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Uc)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===Oc)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===Dc)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===Nc)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Uc)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===Oc)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===ed||i===nd||i===id||i===sd)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===ed)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===nd)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===id)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===sd)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===rd||i===od||i===ad||i===ld||i===cd||i===Fc||i===ud)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(i===rd||i===od)return o===$e?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===ad)return o===$e?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===ld)return r.COMPRESSED_R11_EAC;if(i===cd)return r.COMPRESSED_SIGNED_R11_EAC;if(i===Fc)return r.COMPRESSED_RG11_EAC;if(i===ud)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===hd||i===dd||i===fd||i===pd||i===md||i===gd||i===xd||i===_d||i===yd||i===vd||i===bd||i===Md||i===Sd||i===wd)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(i===hd)return o===$e?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===dd)return o===$e?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===fd)return o===$e?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===pd)return o===$e?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===md)return o===$e?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===gd)return o===$e?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===xd)return o===$e?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===_d)return o===$e?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===yd)return o===$e?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===vd)return o===$e?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===bd)return o===$e?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Md)return o===$e?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===Sd)return o===$e?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===wd)return o===$e?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Ed||i===Td||i===Ad)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(i===Ed)return o===$e?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Td)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Ad)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Rd||i===Cd||i===Bc||i===Pd)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(i===Rd)return r.COMPRESSED_RED_RGTC1_EXT;if(i===Cd)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Bc)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===Pd)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Vo?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:e}}var bP=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,MP=`
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

}`,rg=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let i=new Mc(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=i}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,i=new fi({vertexShader:bP,fragmentShader:MP,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new Ge(new Tc(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},og=class extends Cs{constructor(t,e){super();let i=this,s=null,r=1,o=null,a="local-floor",c=1,l=null,u=null,h=null,d=null,f=null,p=null,_=typeof XRWebGLBinding<"u",m=new rg,g={},x=e.getContextAttributes(),S=null,v=null,A=[],w=[],y=new Qt,E=null,U=null,L=new Ti;L.viewport=new bn;let N=new Ti;N.viewport=new bn;let H=[L,N],$=new Wh,P=null,z=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(st){let yt=A[st];return yt===void 0&&(yt=new Ha,A[st]=yt),yt.getTargetRaySpace()},this.getControllerGrip=function(st){let yt=A[st];return yt===void 0&&(yt=new Ha,A[st]=yt),yt.getGripSpace()},this.getHand=function(st){let yt=A[st];return yt===void 0&&(yt=new Ha,A[st]=yt),yt.getHandSpace()};function D(st){let yt=w.indexOf(st.inputSource);if(yt===-1)return;let xt=A[yt];xt!==void 0&&(xt.update(st.inputSource,st.frame,l||o),xt.dispatchEvent({type:st.type,data:st.inputSource}))}function B(){s.removeEventListener("select",D),s.removeEventListener("selectstart",D),s.removeEventListener("selectend",D),s.removeEventListener("squeeze",D),s.removeEventListener("squeezestart",D),s.removeEventListener("squeezeend",D),s.removeEventListener("end",B),s.removeEventListener("inputsourceschange",Q);for(let st=0;st<A.length;st++){let yt=w[st];yt!==null&&(w[st]=null,A[st].disconnect(yt))}P=null,z=null,m.reset();for(let st in g)delete g[st];if(t.setRenderTarget(S),f=null,d=null,h=null,s=null,v=null,ft.stop(),i.isPresenting=!1,t.setPixelRatio(E),t.setSize(y.width,y.height,!1),U!==null){let st=U.camera;st.fov=U.fov,st.zoom=U.zoom,st.updateProjectionMatrix(),U=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(st){r=st,i.isPresenting===!0&&ie("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(st){a=st,i.isPresenting===!0&&ie("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return l||o},this.setReferenceSpace=function(st){l=st},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return h===null&&_&&(h=new XRWebGLBinding(s,e)),h},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(st){if(s=st,s!==null){if(S=t.getRenderTarget(),s.addEventListener("select",D),s.addEventListener("selectstart",D),s.addEventListener("selectend",D),s.addEventListener("squeeze",D),s.addEventListener("squeezestart",D),s.addEventListener("squeezeend",D),s.addEventListener("end",B),s.addEventListener("inputsourceschange",Q),x.xrCompatible!==!0&&await e.makeXRCompatible(),E=t.getPixelRatio(),t.getSize(y),_&&"createProjectionLayer"in XRWebGLBinding.prototype){let xt=null,Tt=null,At=null;x.depth&&(At=x.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,xt=x.stencil?Dr:Ar,Tt=x.stencil?Vo:Is);let Jt={colorFormat:e.RGBA8,depthFormat:At,scaleFactor:r};h=this.getBinding(),d=h.createProjectionLayer(Jt),s.updateRenderState({layers:[d]}),t.setPixelRatio(1),t.setSize(d.textureWidth,d.textureHeight,!1),v=new Qi(d.textureWidth,d.textureHeight,{format:Ds,type:ns,depthTexture:new Ir(d.textureWidth,d.textureHeight,Tt,void 0,void 0,void 0,void 0,void 0,void 0,xt),stencilBuffer:x.stencil,colorSpace:t.outputColorSpace,samples:x.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let xt={antialias:x.antialias,alpha:!0,depth:x.depth,stencil:x.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,e,xt),s.updateRenderState({baseLayer:f}),t.setPixelRatio(1),t.setSize(f.framebufferWidth,f.framebufferHeight,!1),v=new Qi(f.framebufferWidth,f.framebufferHeight,{format:Ds,type:ns,colorSpace:t.outputColorSpace,stencilBuffer:x.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}v.isXRRenderTarget=!0,this.setFoveation(c),l=null,o=await s.requestReferenceSpace(a),ft.setContext(s),ft.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function Q(st){for(let yt=0;yt<st.removed.length;yt++){let xt=st.removed[yt],Tt=w.indexOf(xt);Tt>=0&&(w[Tt]=null,A[Tt].disconnect(xt))}for(let yt=0;yt<st.added.length;yt++){let xt=st.added[yt],Tt=w.indexOf(xt);if(Tt===-1){for(let Jt=0;Jt<A.length;Jt++)if(Jt>=w.length){w.push(xt),Tt=Jt;break}else if(w[Jt]===null){w[Jt]=xt,Tt=Jt;break}if(Tt===-1)break}let At=A[Tt];At&&At.connect(xt)}}function Y(st,yt){yt===null?st.matrixWorld.copy(st.matrix):st.matrixWorld.multiplyMatrices(yt.matrixWorld,st.matrix),st.matrixWorldInverse.copy(st.matrixWorld).invert()}this.updateCamera=function(st){if(s===null)return;let yt=st.near,xt=st.far;m.texture!==null&&(m.depthNear>0&&(yt=m.depthNear),m.depthFar>0&&(xt=m.depthFar)),$.near=N.near=L.near=yt,$.far=N.far=L.far=xt,(P!==$.near||z!==$.far)&&(s.updateRenderState({depthNear:$.near,depthFar:$.far}),P=$.near,z=$.far),$.layers.mask=st.layers.mask|6,L.layers.mask=$.layers.mask&-5,N.layers.mask=$.layers.mask&-3;let Tt=st.parent,At=$.cameras;Y($,Tt);for(let Jt=0;Jt<At.length;Jt++)Y(At[Jt],Tt);$.projectionMatrix.copy(L.projectionMatrix),$.projectionMatrixInverse.copy(L.projectionMatrixInverse),U===null&&st.isPerspectiveCamera&&(U={camera:st,fov:st.fov,zoom:st.zoom}),Z(st,$,Tt)};function Z(st,yt,xt){xt===null?st.matrix.copy(yt.matrixWorld):(st.matrix.copy(xt.matrixWorld),st.matrix.invert(),st.matrix.multiply(yt.matrixWorld)),st.matrix.decompose(st.position,st.quaternion,st.scale),st.updateMatrixWorld(!0),st.projectionMatrix.copy(yt.projectionMatrix),st.projectionMatrixInverse.copy(yt.projectionMatrixInverse),st.isPerspectiveCamera&&(st.fov=Ba*2*Math.atan(1/st.projectionMatrix.elements[5]),st.zoom=1)}this.getCamera=function(){return $},this.getFoveation=function(){if(!(d===null&&f===null))return c},this.setFoveation=function(st){c=st,d!==null&&(d.fixedFoveation=st),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=st)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh($)},this.getCameraTexture=function(st){return g[st]};let nt=null;function dt(st,yt){if(u=yt.getViewerPose(l||o),p=yt,u!==null){let xt=u.views;f!==null&&(t.setRenderTargetFramebuffer(v,f.framebuffer),t.setRenderTarget(v));let Tt=!1;xt.length!==$.cameras.length&&($.cameras.length=0,Tt=!0);for(let jt=0;jt<xt.length;jt++){let Te=xt[jt],Me=null;if(f!==null)Me=f.getViewport(Te);else{let xn=h.getViewSubImage(d,Te);Me=xn.viewport,jt===0&&(t.setRenderTargetTextures(v,xn.colorTexture,xn.depthStencilTexture),t.setRenderTarget(v))}let pe=H[jt];pe===void 0&&(pe=new Ti,pe.layers.enable(jt),pe.viewport=new bn,H[jt]=pe),pe.matrix.fromArray(Te.transform.matrix),pe.matrix.decompose(pe.position,pe.quaternion,pe.scale),pe.projectionMatrix.fromArray(Te.projectionMatrix),pe.projectionMatrixInverse.copy(pe.projectionMatrix).invert(),pe.viewport.set(Me.x,Me.y,Me.width,Me.height),jt===0&&($.matrix.copy(pe.matrix),$.matrix.decompose($.position,$.quaternion,$.scale)),Tt===!0&&$.cameras.push(pe)}let At=s.enabledFeatures;if(At&&At.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&_){h=i.getBinding();let jt=h.getDepthInformation(xt[0]);jt&&jt.isValid&&jt.texture&&m.init(jt,s.renderState)}if(At&&At.includes("camera-access")&&_){t.state.unbindTexture(),h=i.getBinding();for(let jt=0;jt<xt.length;jt++){let Te=xt[jt].camera;if(Te){let Me=g[Te];Me||(Me=new Mc,g[Te]=Me);let pe=h.getCameraImage(Te);Me.sourceTexture=pe}}}}for(let xt=0;xt<A.length;xt++){let Tt=w[xt],At=A[xt];Tt!==null&&At!==void 0&&At.update(Tt,yt,l||o)}nt&&nt(st,yt),yt.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:yt}),p=null}let ft=new Xy;ft.setAnimationLoop(dt),this.setAnimationLoop=function(st){nt=st},this.dispose=function(){}}},SP=new _e,iv=new he;iv.set(-1,0,0,0,1,0,0,0,1);function wP(n,t){function e(m,g){m.matrixAutoUpdate===!0&&m.updateMatrix(),g.value.copy(m.matrix)}function i(m,g){g.color.getRGB(m.fogColor.value,Xm(n)),g.isFog?(m.fogNear.value=g.near,m.fogFar.value=g.far):g.isFogExp2&&(m.fogDensity.value=g.density)}function s(m,g,x,S,v){g.isNodeMaterial?g.uniformsNeedUpdate=!1:g.isMeshBasicMaterial?r(m,g):g.isMeshLambertMaterial?(r(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshToonMaterial?(r(m,g),h(m,g)):g.isMeshPhongMaterial?(r(m,g),u(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshStandardMaterial?(r(m,g),d(m,g),g.isMeshPhysicalMaterial&&f(m,g,v)):g.isMeshMatcapMaterial?(r(m,g),p(m,g)):g.isMeshDepthMaterial?r(m,g):g.isMeshDistanceMaterial?(r(m,g),_(m,g)):g.isMeshNormalMaterial?r(m,g):g.isLineBasicMaterial?(o(m,g),g.isLineDashedMaterial&&a(m,g)):g.isPointsMaterial?c(m,g,x,S):g.isSpriteMaterial?l(m,g):g.isShadowMaterial?(m.color.value.copy(g.color),m.opacity.value=g.opacity):g.isShaderMaterial&&(g.uniformsNeedUpdate=!1)}function r(m,g){m.opacity.value=g.opacity,g.color&&m.diffuse.value.copy(g.color),g.emissive&&m.emissive.value.copy(g.emissive).multiplyScalar(g.emissiveIntensity),g.map&&(m.map.value=g.map,e(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.bumpMap&&(m.bumpMap.value=g.bumpMap,e(g.bumpMap,m.bumpMapTransform),m.bumpScale.value=g.bumpScale,g.side===oi&&(m.bumpScale.value*=-1)),g.normalMap&&(m.normalMap.value=g.normalMap,e(g.normalMap,m.normalMapTransform),m.normalScale.value.copy(g.normalScale),g.side===oi&&m.normalScale.value.negate()),g.displacementMap&&(m.displacementMap.value=g.displacementMap,e(g.displacementMap,m.displacementMapTransform),m.displacementScale.value=g.displacementScale,m.displacementBias.value=g.displacementBias),g.emissiveMap&&(m.emissiveMap.value=g.emissiveMap,e(g.emissiveMap,m.emissiveMapTransform)),g.specularMap&&(m.specularMap.value=g.specularMap,e(g.specularMap,m.specularMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest);let x=t.get(g),S=x.envMap,v=x.envMapRotation;S&&(m.envMap.value=S,m.envMapRotation.value.setFromMatrix4(SP.makeRotationFromEuler(v)).transpose(),S.isCubeTexture&&S.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(iv),m.reflectivity.value=g.reflectivity,m.ior.value=g.ior,m.refractionRatio.value=g.refractionRatio),g.lightMap&&(m.lightMap.value=g.lightMap,m.lightMapIntensity.value=g.lightMapIntensity,e(g.lightMap,m.lightMapTransform)),g.aoMap&&(m.aoMap.value=g.aoMap,m.aoMapIntensity.value=g.aoMapIntensity,e(g.aoMap,m.aoMapTransform))}function o(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,g.map&&(m.map.value=g.map,e(g.map,m.mapTransform))}function a(m,g){m.dashSize.value=g.dashSize,m.totalSize.value=g.dashSize+g.gapSize,m.scale.value=g.scale}function c(m,g,x,S){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.size.value=g.size*x,m.scale.value=S*.5,g.map&&(m.map.value=g.map,e(g.map,m.uvTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function l(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.rotation.value=g.rotation,g.map&&(m.map.value=g.map,e(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function u(m,g){m.specular.value.copy(g.specular),m.shininess.value=Math.max(g.shininess,1e-4)}function h(m,g){g.gradientMap&&(m.gradientMap.value=g.gradientMap)}function d(m,g){m.metalness.value=g.metalness,g.metalnessMap&&(m.metalnessMap.value=g.metalnessMap,e(g.metalnessMap,m.metalnessMapTransform)),m.roughness.value=g.roughness,g.roughnessMap&&(m.roughnessMap.value=g.roughnessMap,e(g.roughnessMap,m.roughnessMapTransform)),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)}function f(m,g,x){m.ior.value=g.ior,g.diffuseRoughness>0&&(m.diffuseRoughness.value=g.diffuseRoughness,g.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=g.diffuseRoughnessMap,e(g.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),g.sheen>0&&(m.sheenColor.value.copy(g.sheenColor).multiplyScalar(g.sheen),m.sheenRoughness.value=g.sheenRoughness,g.sheenColorMap&&(m.sheenColorMap.value=g.sheenColorMap,e(g.sheenColorMap,m.sheenColorMapTransform)),g.sheenRoughnessMap&&(m.sheenRoughnessMap.value=g.sheenRoughnessMap,e(g.sheenRoughnessMap,m.sheenRoughnessMapTransform))),g.clearcoat>0&&(m.clearcoat.value=g.clearcoat,m.clearcoatRoughness.value=g.clearcoatRoughness,g.clearcoatMap&&(m.clearcoatMap.value=g.clearcoatMap,e(g.clearcoatMap,m.clearcoatMapTransform)),g.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=g.clearcoatRoughnessMap,e(g.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),g.clearcoatNormalMap&&(m.clearcoatNormalMap.value=g.clearcoatNormalMap,e(g.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(g.clearcoatNormalScale),g.side===oi&&m.clearcoatNormalScale.value.negate())),g.dispersion>0&&(m.dispersion.value=g.dispersion),g.retroreflectivity>0&&(m.retroreflectivity.value=g.retroreflectivity),g.iridescence>0&&(m.iridescence.value=g.iridescence,m.iridescenceIOR.value=g.iridescenceIOR,m.iridescenceThicknessMinimum.value=g.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=g.iridescenceThicknessMaximum,g.iridescenceMap&&(m.iridescenceMap.value=g.iridescenceMap,e(g.iridescenceMap,m.iridescenceMapTransform)),g.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=g.iridescenceThicknessMap,e(g.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),g.transmission>0&&(m.transmission.value=g.transmission,m.transmissionSamplerMap.value=x.texture,m.transmissionSamplerSize.value.set(x.width,x.height),g.transmissionMap&&(m.transmissionMap.value=g.transmissionMap,e(g.transmissionMap,m.transmissionMapTransform)),m.thickness.value=g.thickness,g.thicknessMap&&(m.thicknessMap.value=g.thicknessMap,e(g.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=g.attenuationDistance,m.attenuationColor.value.copy(g.attenuationColor)),g.anisotropy>0&&(m.anisotropyVector.value.set(g.anisotropy*Math.cos(g.anisotropyRotation),g.anisotropy*Math.sin(g.anisotropyRotation)),g.anisotropyMap&&(m.anisotropyMap.value=g.anisotropyMap,e(g.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=g.specularIntensity,m.specularColor.value.copy(g.specularColor),g.specularColorMap&&(m.specularColorMap.value=g.specularColorMap,e(g.specularColorMap,m.specularColorMapTransform)),g.specularIntensityMap&&(m.specularIntensityMap.value=g.specularIntensityMap,e(g.specularIntensityMap,m.specularIntensityMapTransform))}function p(m,g){g.matcap&&(m.matcap.value=g.matcap)}function _(m,g){let x=t.get(g).light;m.referencePosition.value.setFromMatrixPosition(x.matrixWorld),m.nearDistance.value=x.shadow.camera.near,m.farDistance.value=x.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function EP(n,t,e,i){let s={},r={};function o(x,S){let v=S.program;i.uniformBlockBinding(x,v,s[x.id])}function a(x,S){let v=s[x.id];v===void 0&&(p(x),v=c(x),s[x.id]=v,x.addEventListener("dispose",m));let A=S.program;i.updateUBOMapping(x,A);let w=t.render.frame;r[x.id]!==w&&(l(x),r[x.id]=w)}function c(x){let S=n.createBuffer(),v=x.__size,A=x.usage;return n.bindBuffer(n.UNIFORM_BUFFER,S),n.bufferData(n.UNIFORM_BUFFER,v,A),n.bindBuffer(n.UNIFORM_BUFFER,null),S}function l(x){let S=s[x.id],v=x.uniforms,A=x.__cache;n.bindBuffer(n.UNIFORM_BUFFER,S);for(let w=0,y=v.length;w<y;w++){let E=v[w];if(Array.isArray(E))for(let U=0,L=E.length;U<L;U++)u(E[U],w,U,A);else u(E,w,0,A)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(x,S,v,A){if(d(x,S,v,A)===!0){let w=x.__offset,y=x.value;if(Array.isArray(y)){let E=0;for(let U=0;U<y.length;U++){let L=y[U],N=_(L,!0);h(L,x.__data,E),E+=N.storage/Float32Array.BYTES_PER_ELEMENT}}else h(y,x.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,w,x.__data)}}function h(x,S,v){typeof x=="number"||typeof x=="boolean"?S[v]=x:x.isMatrix3?(S[v]=x.elements[0],S[v+1]=x.elements[1],S[v+2]=x.elements[2],S[v+3]=0,S[v+4]=x.elements[3],S[v+5]=x.elements[4],S[v+6]=x.elements[5],S[v+7]=0,S[v+8]=x.elements[6],S[v+9]=x.elements[7],S[v+10]=x.elements[8],S[v+11]=0):ArrayBuffer.isView(x)?S.set(x.subarray(0,S.length-v),v):x.toArray(S,v)}function d(x,S,v,A){let w=x.value,y=S+"_"+v;if(Array.isArray(w)){A[y]===void 0&&(A[y]=[]);let E=A[y],U=!1;for(let L=0;L<w.length;L++)f(w[L],E,L)===!0&&(U=!0);return U}return f(w,A,y)}function f(x,S,v){if(S[v]===void 0)return typeof x=="number"||typeof x=="boolean"?S[v]=x:ArrayBuffer.isView(x)?S[v]=x.slice():S[v]=x.clone(),!0;{let A=S[v];if(typeof x=="number"||typeof x=="boolean"){if(A!==x)return S[v]=x,!0}else{if(ArrayBuffer.isView(x))return!0;if(A.equals(x)===!1)return A.copy(x),!0}}return!1}function p(x){let S=x.uniforms,v=0,A=16;for(let y=0,E=S.length;y<E;y++){let U=Array.isArray(S[y])?S[y]:[S[y]];for(let L=0,N=U.length;L<N;L++){let H=U[L],$=Array.isArray(H.value)?H.value:[H.value],P=Array.isArray(S[y])||Array.isArray(H.value),z=v;for(let B=0,Q=$.length;B<Q;B++){let Y=$[B],Z=_(Y,P),nt=v%A,dt=nt%Z.boundary,ft=nt+dt;v+=dt,ft!==0&&A-ft<Z.storage&&(v+=A-ft),B===0&&(z=v),v+=Z.storage}let D=H.type==="int"?Int32Array:H.type==="uint"?Uint32Array:Float32Array;H.__data=new D((v-z)/Float32Array.BYTES_PER_ELEMENT),H.__offset=z}}let w=v%A;return w>0&&(v+=A-w),x.__size=v,x.__cache={},this}function _(x,S){let v={boundary:0,storage:0};return typeof x=="number"||typeof x=="boolean"?(v.boundary=4,v.storage=4):x.isVector2?(v.boundary=8,v.storage=8):x.isVector3||x.isColor?(v.boundary=16,v.storage=12):x.isVector4?(v.boundary=16,v.storage=16):x.isMatrix3?(v.boundary=16,v.storage=48):x.isMatrix4?(v.boundary=16,v.storage=64):x.isTexture?ie("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(x)?(v.boundary=16,v.storage=x.byteLength):ie("WebGLRenderer: Unsupported uniform value type.",x),S===!0&&(v.boundary=16,v.storage=Math.ceil(v.storage/16)*16),v}function m(x){let S=x.target;S.removeEventListener("dispose",m),n.deleteBuffer(s[S.id]),delete s[S.id],delete r[S.id]}function g(){for(let x in s)n.deleteBuffer(s[x]);s={},r={}}return{bind:o,update:a,dispose:g}}var TP=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),or=null;function AP(){return or===null&&(or=new _c(TP,16,16,lo,Ls),or.name="DFG_LUT",or.minFilter=Ai,or.magFilter=Ai,or.wrapS=tr,or.wrapT=tr,or.generateMipmaps=!1,or.needsUpdate=!0),or}var Od=class{constructor(t={}){let{canvas:e=_y(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:c=!0,preserveDrawingBuffer:l=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:d=!1,outputBufferType:f=ns}=t;this.isWebGLRenderer=!0;let p;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=i.getContextAttributes().alpha}else p=o;let _=f,m=new Set([td,Qh,Kh]),g=new Set([ns,Is,Ja,Vo,jh,Zh]),x=new Uint32Array(4),S=new Int32Array(4),v={textures:[],min:[],max:[],resolution:[]},A=null,w=null,y=[],E=[],U=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=rr,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let L=this,N=!1,H=null,$=null,P=null,z=null;this._outputColorSpace=Ei;let D=0,B=0,Q=null,Y=-1,Z=null,nt=new bn,dt=new bn,ft=null,st=new ee(0),yt=0,xt=e.width,Tt=e.height,At=1,Jt=null,ge=null,jt=new bn(0,0,xt,Tt),Te=new bn(0,0,xt,Tt),Me=!1,pe=new Oo,xn=new Th,on=!1,In=!1,Je=new _e,Zn=new G,Ue=new bn,kn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Sn=!1;function Ln(){return Q===null?At:1}let W=i;function Nt(I,q){return e.getContext(I,q)}let se,xe,Ct,Qe,Yt,ne,O,R,j,gt,ct,St,wt,rt,at,vt,V,lt,ot,Pt,Mt,Rt,Zt;try{let I={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:c,preserveDrawingBuffer:l,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",$t,!1),e.addEventListener("webglcontextrestored",ae,!1),e.addEventListener("webglcontextcreationerror",Dt,!1),W===null){let q="webgl2";if(W=Nt(q,I),W===null)throw Nt(q)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}oe()}catch(I){throw e.removeEventListener("webglcontextlost",$t,!1),e.removeEventListener("webglcontextrestored",ae,!1),e.removeEventListener("webglcontextcreationerror",Dt,!1),le("WebGLRenderer: "+I.message),I}function oe(){se=new BR(W),se.init(),Mt=new vP(W,se),xe=new AR(W,se,t,Mt),Ct=new _P(W,se),xe.reversedDepthBuffer&&d&&Ct.buffers.depth.setReversed(!0),$=W.createFramebuffer(),P=W.createFramebuffer(),z=W.createFramebuffer(),Qe=new HR(W),Yt=new sP,ne=new yP(W,se,Ct,Yt,xe,Mt,Qe),O=new FR(L),R=new VE(W),Rt=new ER(W,R),j=new kR(W,R,Qe,Rt),gt=new VR(W,j,R,Rt,Qe),lt=new GR(W,xe,ne),at=new RR(Yt),ct=new iP(L,O,se,xe,Rt,at),St=new wP(L,Yt),wt=new oP,rt=new dP(se),V=new wR(L,O,Ct,gt,p,c),vt=new xP(L,gt,xe),Zt=new EP(W,Qe,xe,Ct),ot=new TR(W,se,Qe),Pt=new zR(W,se,Qe),Qe.programs=ct.programs,L.capabilities=xe,L.extensions=se,L.properties=Yt,L.renderLists=wt,L.shadowMap=vt,L.state=Ct,L.info=Qe}_!==ns&&(U=new $R(_,e.width,e.height,a,s,r));let pt=new og(L,W);this.xr=pt,this.getContext=function(){return W},this.getContextAttributes=function(){return W.getContextAttributes()},this.forceContextLoss=function(){let I=se.get("WEBGL_lose_context");I&&I.loseContext()},this.forceContextRestore=function(){let I=se.get("WEBGL_lose_context");I&&I.restoreContext()},this.getPixelRatio=function(){return At},this.setPixelRatio=function(I){I!==void 0&&(At=I,this.setSize(xt,Tt,!1))},this.getSize=function(I){return I.set(xt,Tt)},this.setSize=function(I,q,it=!0){if(pt.isPresenting){ie("WebGLRenderer: Can't change size while VR device is presenting.");return}xt=I,Tt=q,e.width=Math.floor(I*At),e.height=Math.floor(q*At),it===!0&&(e.style.width=I+"px",e.style.height=q+"px"),U!==null&&U.setSize(e.width,e.height),this.setViewport(0,0,I,q)},this.getDrawingBufferSize=function(I){return I.set(xt*At,Tt*At).floor()},this.setDrawingBufferSize=function(I,q,it){xt=I,Tt=q,At=it,e.width=Math.floor(I*it),e.height=Math.floor(q*it),this.setViewport(0,0,I,q)},this.setEffects=function(I){if(_===ns){le("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(I){for(let q=0;q<I.length;q++)if(I[q].isOutputPass===!0){ie("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}U.setEffects(I||[])},this.getCurrentViewport=function(I){return I.copy(nt)},this.getViewport=function(I){return I.copy(jt)},this.setViewport=function(I,q,it,J){I.isVector4?jt.set(I.x,I.y,I.z,I.w):jt.set(I,q,it,J),Ct.viewport(nt.copy(jt).multiplyScalar(Ln()).round())},this.getScissor=function(I){return I.copy(Te)},this.setScissor=function(I,q,it,J){I.isVector4?Te.set(I.x,I.y,I.z,I.w):Te.set(I,q,it,J),Ct.scissor(dt.copy(Te).multiplyScalar(Ln()).round())},this.getScissorTest=function(){return Me},this.setScissorTest=function(I){Ct.setScissorTest(Me=I)},this.setOpaqueSort=function(I){Jt=I},this.setTransparentSort=function(I){ge=I},this.getClearColor=function(I){return I.copy(V.getClearColor())},this.setClearColor=function(){V.setClearColor(...arguments)},this.getClearAlpha=function(){return V.getClearAlpha()},this.setClearAlpha=function(){V.setClearAlpha(...arguments)},this.clear=function(I=!0,q=!0,it=!0){let J=0;if(I){let K=!1;if(Q!==null){let It=Q.texture.format;K=m.has(It)}if(K){let It=Q.texture.type,Ot=g.has(It),Lt=V.getClearColor(),Bt=V.getClearAlpha(),Xt=Lt.r,ue=Lt.g,Re=Lt.b;Ot?(x[0]=Xt,x[1]=ue,x[2]=Re,x[3]=Bt,W.clearBufferuiv(W.COLOR,0,x)):(S[0]=Xt,S[1]=ue,S[2]=Re,S[3]=Bt,W.clearBufferiv(W.COLOR,0,S))}else J|=W.COLOR_BUFFER_BIT}q&&(J|=W.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),it&&(J|=W.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),J!==0&&W.clear(J)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(I){I.setRenderer(this),H=I},this.dispose=function(){e.removeEventListener("webglcontextlost",$t,!1),e.removeEventListener("webglcontextrestored",ae,!1),e.removeEventListener("webglcontextcreationerror",Dt,!1),V.dispose(),wt.dispose(),rt.dispose(),ne.dispose(),Yt.dispose(),O.dispose(),gt.dispose(),j.dispose(),Rt.dispose(),Zt.dispose(),ct.dispose(),pt.dispose(),pt.removeEventListener("sessionstart",Cu),pt.removeEventListener("sessionend",Gs),pr.stop()};function $t(I){I.preventDefault(),dc("WebGLRenderer: Context Lost."),N=!0}function ae(){dc("WebGLRenderer: Context Restored."),N=!1;let I=Qe.autoReset,q=vt.enabled,it=vt.autoUpdate,J=vt.needsUpdate,K=vt.type;oe(),Qe.autoReset=I,vt.enabled=q,vt.autoUpdate=it,vt.needsUpdate=J,vt.type=K}function Dt(I){le("WebGLRenderer: A WebGL context could not be created. Reason: ",I.statusMessage)}function ye(I){let q=I.target;q.removeEventListener("dispose",ye),an(q)}function an(I){_i(I),Yt.remove(I)}function _i(I){let q=Yt.get(I).programs;q!==void 0&&(q.forEach(function(it){ct.releaseProgram(it)}),I.isShaderMaterial&&ct.releaseShaderCache(I))}this.renderBufferDirect=function(I,q,it,J,K,It){q===null&&(q=kn);let Ot=K.isMesh&&K.matrixWorld.determinantAffine()<0,Lt=Wl(I,q,it,J,K);Ct.setMaterial(J,Ot);let Bt=it.index,Xt=1;if(J.wireframe===!0){if(Bt=j.getWireframeAttribute(it),Bt===void 0)return;Xt=2}let ue=it.drawRange,Re=it.attributes.position,qt=ue.start*Xt,Ce=(ue.start+ue.count)*Xt;It!==null&&(qt=Math.max(qt,It.start*Xt),Ce=Math.min(Ce,(It.start+It.count)*Xt)),Bt!==null?(qt=Math.max(qt,0),Ce=Math.min(Ce,Bt.count)):Re!=null&&(qt=Math.max(qt,0),Ce=Math.min(Ce,Re.count));let vn=Ce-qt;if(vn<0||vn===1/0)return;Rt.setup(K,J,Lt,it,Bt);let Xe,Ye=ot;if(Bt!==null&&(Xe=R.get(Bt),Ye=Pt,Ye.setIndex(Xe)),K.isMesh)J.wireframe===!0?(Ct.setLineWidth(J.wireframeLinewidth*Ln()),Ye.setMode(W.LINES)):Ye.setMode(W.TRIANGLES);else if(K.isLine){let zn=J.linewidth;zn===void 0&&(zn=1),Ct.setLineWidth(zn*Ln()),K.isLineSegments?Ye.setMode(W.LINES):K.isLineLoop?Ye.setMode(W.LINE_LOOP):Ye.setMode(W.LINE_STRIP)}else K.isPoints?Ye.setMode(W.POINTS):K.isSprite&&Ye.setMode(W.TRIANGLES);if(K.isBatchedMesh)if(se.get("WEBGL_multi_draw"))Ye.renderMultiDraw(K._multiDrawStarts,K._multiDrawCounts,K._multiDrawCount);else{let zn=K._multiDrawStarts,Vt=K._multiDrawCounts,Dn=K._multiDrawCount,Le=Bt?R.get(Bt).bytesPerElement:1,gr=Yt.get(J).currentProgram.getUniforms();for(let Nn=0;Nn<Dn;Nn++)gr.setValue(W,"_gl_DrawID",Nn),Ye.render(zn[Nn]/Le,Vt[Nn])}else if(K.isInstancedMesh)Ye.renderInstances(qt,vn,K.count);else if(it.isInstancedBufferGeometry){let zn=it._maxInstanceCount!==void 0?it._maxInstanceCount:1/0,Vt=Math.min(it.instanceCount,zn);Ye.renderInstances(qt,vn,Vt)}else Ye.render(qt,vn)};function Hl(I,q,it,J){H!==null&&I.isNodeMaterial&&H.setObject(J,I),on===!0&&at.setState(I,it,!1),I.transparent===!0&&I.side===pi&&I.forceSinglePass===!1?(I.side=oi,I.needsUpdate=!0,Vs(I,q,J),I.side=sr,I.needsUpdate=!0,Vs(I,q,J),I.side=pi):Vs(I,q,J)}this.compile=function(I,q,it=null){it===null&&(it=I),H!==null&&H.renderStart(I,q,it),w=rt.get(it),w.init(q),E.push(w),it.traverseVisible(function(K){K.isLight&&K.layers.test(q.layers)&&(w.pushLight(K),K.castShadow&&w.pushShadow(K))}),I!==it&&I.traverseVisible(function(K){K.isLight&&K.layers.test(q.layers)&&(w.pushLight(K),K.castShadow&&w.pushShadow(K))}),w.setupLights(),H!==null&&H.updateLights(w.state.lightsArray),In=this.localClippingEnabled,on=at.init(this.clippingPlanes,In),on===!0&&at.setGlobalState(this.clippingPlanes,q),H!==null&&vt.render(w.state.shadowsArray,it,q);let J=new Set;return I.traverse(function(K){if(!(K.isMesh||K.isPoints||K.isLine||K.isSprite))return;let It=K.material;if(It)if(Array.isArray(It))for(let Ot=0;Ot<It.length;Ot++){let Lt=It[Ot];Hl(Lt,it,q,K),J.add(Lt)}else Hl(It,it,q,K),J.add(It)}),w=E.pop(),H!==null&&H.renderEnd(),J},this.compileAsync=function(I,q,it=null){let J=this.compile(I,q,it);return new Promise(K=>{function It(){if(J.forEach(function(Ot){let Bt=Yt.get(Ot).currentProgram;(Bt===void 0||Bt.isReady())&&J.delete(Ot)}),J.size===0){K(I);return}setTimeout(It,10)}se.get("KHR_parallel_shader_compile")!==null?It():setTimeout(It,10)})};let oa=null;function Ep(I){oa&&oa(I)}function Cu(){pr.stop()}function Gs(){pr.start()}let pr=new Xy;pr.setAnimationLoop(Ep),typeof self<"u"&&pr.setContext(self),this.setAnimationLoop=function(I){oa=I,pt.setAnimationLoop(I),I===null?pr.stop():pr.start()},pt.addEventListener("sessionstart",Cu),pt.addEventListener("sessionend",Gs),this.render=function(I,q){if(q!==void 0&&q.isCamera!==!0){le("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(N===!0)return;H!==null&&H.renderStart(I,q);let it=pt.enabled===!0&&pt.isPresenting===!0,J=U!==null&&(Q===null||it)&&U.begin(L,Q);if(I.matrixWorldAutoUpdate===!0&&I.updateMatrixWorld(),q.parent===null&&q.matrixWorldAutoUpdate===!0&&q.updateMatrixWorld(),pt.enabled===!0&&pt.isPresenting===!0&&(U===null||U.isCompositing()===!1)&&(pt.cameraAutoUpdate===!0&&pt.updateCamera(q),q=pt.getCamera()),I.isScene===!0&&I.onBeforeRender(L,I,q,Q),w=rt.get(I,E.length),w.init(q),w.state.textureUnits=ne.getTextureUnits(),E.push(w),Je.multiplyMatrices(q.projectionMatrix,q.matrixWorldInverse),q.isArrayCamera?xn.setFromArrayCamera(q):pe.setFromProjectionMatrix(Je,hs,q.reversedDepth),In=this.localClippingEnabled,on=at.init(this.clippingPlanes,In),A=wt.get(I,y.length),A.init(),y.push(A),this.info.render.frame++,pt.enabled===!0&&pt.isPresenting===!0){let Ot=L.xr.getDepthSensingMesh();Ot!==null&&mr(Ot,q,-1/0,L.sortObjects)}mr(I,q,0,L.sortObjects),A.finish(),H!==null&&H.updateLights(w.state.lightsArray),L.sortObjects===!0&&A.sort(Jt,ge),Sn=pt.enabled===!1||pt.isPresenting===!1||pt.hasDepthSensing()===!1,Sn&&V.addToRenderList(A,I),this.info.autoReset===!0&&this.info.reset(),on===!0&&at.beginShadows();let K=w.state.shadowsArray;if(vt.render(K,I,q),on===!0&&at.endShadows(),(J&&U.hasRenderPass())===!1){let Ot=A.opaque,Lt=A.transmissive;if(w.setupLights(),q.isArrayCamera){let Bt=q.cameras;if(Lt.length>0)for(let Xt=0,ue=Bt.length;Xt<ue;Xt++){let Re=Bt[Xt];bs(Ot,Lt,I,Re)}Sn&&V.render(I);for(let Xt=0,ue=Bt.length;Xt<ue;Xt++){let Re=Bt[Xt];Gl(A,I,Re,Re.viewport)}}else Lt.length>0&&bs(Ot,Lt,I,q),Sn&&V.render(I),Gl(A,I,q)}Q!==null&&B===0&&(ne.updateMultisampleRenderTarget(Q),ne.updateRenderTargetMipmap(Q)),J&&U.end(L),I.isScene===!0&&I.onAfterRender(L,I,q),Rt.resetDefaultState(),Y=-1,Z=null,E.pop(),E.length>0?(w=E[E.length-1],ne.setTextureUnits(w.state.textureUnits),on===!0&&at.setGlobalState(L.clippingPlanes,w.state.camera)):w=null,y.pop(),y.length>0?A=y[y.length-1]:A=null,H!==null&&H.renderEnd()};function mr(I,q,it,J){if(I.visible===!1)return;if(I.layers.test(q.layers)){if(I.isGroup)it=I.renderOrder;else if(I.isLOD)I.autoUpdate===!0&&I.update(q);else if(I.isLight)w.pushLight(I),I.castShadow&&w.pushShadow(I);else if(I.isSprite){let Ot=q.isArrayCamera?xn:pe;if(!I.frustumCulled||I.intersectsFrustum(Ot)){J&&Ue.setFromMatrixPosition(I.matrixWorld).applyMatrix4(Je);let Lt=gt.update(I),Bt=I.material;Bt.visible&&A.push(I,Lt,Bt,it,Ue.z,null,q)}}else if(I.isMesh||I.isLine||I.isPoints){let Ot=q.isArrayCamera?xn:pe;if(!I.frustumCulled||I.intersectsFrustum(Ot)){let Lt=gt.update(I),Bt=I.material;if(J&&(I.boundingSphere!==void 0?(I.boundingSphere===null&&I.computeBoundingSphere(),Ue.copy(I.boundingSphere.center)):(Lt.boundingSphere===null&&Lt.computeBoundingSphere(),Ue.copy(Lt.boundingSphere.center)),Ue.applyMatrix4(I.matrixWorld).applyMatrix4(Je)),Array.isArray(Bt)){let Xt=Lt.groups;for(let ue=0,Re=Xt.length;ue<Re;ue++){let qt=Xt[ue],Ce=Bt[qt.materialIndex];Ce&&Ce.visible&&A.push(I,Lt,Ce,it,Ue.z,qt,q)}}else Bt.visible&&A.push(I,Lt,Bt,it,Ue.z,null,q)}}}let It=I.children;for(let Ot=0,Lt=It.length;Ot<Lt;Ot++)mr(It[Ot],q,it,J)}function Gl(I,q,it,J){let{opaque:K,transmissive:It,transparent:Ot}=I;w.setupLightsView(it),on===!0&&at.setGlobalState(L.clippingPlanes,it),J&&Ct.viewport(nt.copy(J)),K.length>0&&wn(K,q,it),It.length>0&&wn(It,q,it),Ot.length>0&&wn(Ot,q,it),Ct.buffers.depth.setTest(!0),Ct.buffers.depth.setMask(!0),Ct.buffers.color.setMask(!0),Ct.setPolygonOffset(!1)}function bs(I,q,it,J){if((it.isScene===!0?it.overrideMaterial:null)!==null)return;if(w.state.transmissionRenderTarget[J.id]===void 0){let qt=se.has("EXT_color_buffer_half_float")||se.has("EXT_color_buffer_float");w.state.transmissionRenderTarget[J.id]=new Qi(1,1,{generateMipmaps:!0,type:qt?Ls:ns,minFilter:Lr,samples:Math.max(4,xe.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:De.workingColorSpace})}let It=w.state.transmissionRenderTarget[J.id],Ot=J.viewport||nt;It.setSize(Ot.z*L.transmissionResolutionScale,Ot.w*L.transmissionResolutionScale);let Lt=L.getRenderTarget(),Bt=L.getActiveCubeFace(),Xt=L.getActiveMipmapLevel();L.setRenderTarget(It),L.getClearColor(st),yt=L.getClearAlpha(),yt<1&&L.setClearColor(16777215,.5),L.clear(),Sn&&V.render(it);let ue=L.toneMapping;L.toneMapping=rr;let Re=J.viewport;if(J.viewport!==void 0&&(J.viewport=void 0),w.setupLightsView(J),on===!0&&at.setGlobalState(L.clippingPlanes,J),wn(I,it,J),ne.updateMultisampleRenderTarget(It),ne.updateRenderTargetMipmap(It),se.has("WEBGL_multisampled_render_to_texture")===!1){let qt=!1;for(let Ce=0,vn=q.length;Ce<vn;Ce++){let Xe=q[Ce],{object:Ye,geometry:zn,material:Vt,group:Dn}=Xe;if(Vt.side===pi&&Ye.layers.test(J.layers)){let Le=Vt.side;Vt.side=oi,Vt.needsUpdate=!0,Cn(Ye,it,J,zn,Vt,Dn),Vt.side=Le,Vt.needsUpdate=!0,qt=!0}}qt===!0&&(ne.updateMultisampleRenderTarget(It),ne.updateRenderTargetMipmap(It))}L.setRenderTarget(Lt,Bt,Xt),L.setClearColor(st,yt),Re!==void 0&&(J.viewport=Re),L.toneMapping=ue}function wn(I,q,it){let J=q.isScene===!0?q.overrideMaterial:null;for(let K=0,It=I.length;K<It;K++){let Ot=I[K],{object:Lt,geometry:Bt,group:Xt}=Ot,ue=Ot.material;ue.allowOverride===!0&&J!==null&&(ue=J),Lt.layers.test(it.layers)&&Cn(Lt,q,it,Bt,ue,Xt)}}function Cn(I,q,it,J,K,It){H!==null&&K.isNodeMaterial&&H.setObject(I,K),I.onBeforeRender(L,q,it,J,K,It),I.modelViewMatrix.multiplyMatrices(it.matrixWorldInverse,I.matrixWorld),I.normalMatrix.getNormalMatrix(I.modelViewMatrix),K.onBeforeRender(L,q,it,J,I,It),K.transparent===!0&&K.side===pi&&K.forceSinglePass===!1?(K.side=oi,K.needsUpdate=!0,L.renderBufferDirect(it,q,J,K,I,It),K.side=sr,K.needsUpdate=!0,L.renderBufferDirect(it,q,J,K,I,It),K.side=pi):L.renderBufferDirect(it,q,J,K,I,It),I.onAfterRender(L,q,it,J,K,It)}function Pn(I){let q=0;for(let it of I)it.texture!==null&&q++;return q}function Vs(I,q,it){q.isScene!==!0&&(q=kn);let J=Yt.get(I),K=w.state.lights,It=w.state.shadowsArray,Ot=K.state.version,Lt=ct.getParameters(I,K.state,It,q,it,w.state.lightProbeGridArray),Bt=ct.getProgramCacheKey(Lt),Xt=J.programs;J.environment=I.isMeshStandardMaterial||I.isMeshLambertMaterial||I.isMeshPhongMaterial?q.environment:null,J.fog=q.fog;let ue=I.isMeshStandardMaterial||I.isMeshLambertMaterial&&!I.envMap||I.isMeshPhongMaterial&&!I.envMap;J.envMap=O.get(I.envMap||J.environment,ue),J.envMapRotation=J.environment!==null&&I.envMap===null?q.environmentRotation:I.envMapRotation,Xt===void 0&&(I.addEventListener("dispose",ye),Xt=new Map,J.programs=Xt,J.programVariants=new Map);let Re=Xt.get(Bt);if(Re!==void 0){if(J.currentProgram===Re&&J.lightsStateVersion===Ot)return Vl(I,Lt),Re}else Lt.uniforms=ct.getUniforms(I),H!==null&&I.isNodeMaterial&&H.build(I,it,Lt),I.onBeforeCompile(Lt,L),Re=ct.acquireProgram(Lt,Bt),Xt.set(Bt,Re),J.uniforms=Lt.uniforms;let qt=J.uniforms;return(!I.isShaderMaterial&&!I.isRawShaderMaterial||I.clipping===!0)&&(qt.clippingPlanes=at.uniform),Vl(I,Lt),J.needsLights=Wr(I),J.lightsStateVersion=Ot,J.needsLights&&(qt.ambientLightColor.value=K.state.ambient,qt.lightProbe.value=K.state.probe,qt.sunLights.value=K.state.sun,qt.sunLightShadows.value=K.state.sunShadow,qt.directionalLights.value=K.state.directional,qt.directionalLightShadows.value=K.state.directionalShadow,qt.spotLights.value=K.state.spot,qt.spotLightShadows.value=K.state.spotShadow,qt.rectAreaLights.value=K.state.rectArea,qt.ltc_1.value=K.state.rectAreaLTC1,qt.ltc_2.value=K.state.rectAreaLTC2,qt.pointLights.value=K.state.point,qt.pointLightShadows.value=K.state.pointShadow,qt.hemisphereLights.value=K.state.hemi,qt.sunShadowMatrix.value=K.state.sunShadowMatrix,qt.sunShadowCascade.value=K.state.sunShadowCascade,qt.directionalShadowMatrix.value=K.state.directionalShadowMatrix,qt.spotLightMatrix.value=K.state.spotLightMatrix,qt.spotLightMap.value=K.state.spotLightMap,qt.pointShadowMatrix.value=K.state.pointShadowMatrix),J.numLightProbeGrids=Pn(w.state.lightProbeGridArray),J.currentProgram=Re,J.uniformsList=null,Re}function qi(I,q,it,J,K){let It=Yt.get(I),Ot=It.currentProgram.id+","+J+","+K,Lt=It.programVariants.get(Ot);return Lt===void 0?(Lt=Vs(I,q,it),It.programVariants.set(Ot,Lt)):(It.currentProgram=Lt,It.uniformsList=null,It.outputColorSpace=J,It.toneMapping=K),Lt}function Vr(I){if(I.uniformsList===null){let q=I.currentProgram.getUniforms();I.uniformsList=Ka.seqWithValue(q.seq,I.uniforms)}return I.uniformsList}function Vl(I,q){let it=Yt.get(I);it.outputColorSpace=q.outputColorSpace,it.batching=q.batching,it.batchingColor=q.batchingColor,it.instancing=q.instancing,it.instancingColor=q.instancingColor,it.instancingMorph=q.instancingMorph,it.skinning=q.skinning,it.morphTargets=q.morphTargets,it.morphNormals=q.morphNormals,it.morphColors=q.morphColors,it.morphTargetsCount=q.morphTargetsCount,it.numClippingPlanes=q.numClippingPlanes,it.numIntersection=q.numClipIntersection,it.vertexAlphas=q.vertexAlphas,it.vertexTangents=q.vertexTangents,it.toneMapping=q.toneMapping}function Wl(I,q,it,J,K){q.isScene!==!0&&(q=kn),ne.resetTextureUnits();let It=q.fog,Ot=J.isMeshStandardMaterial||J.isMeshLambertMaterial||J.isMeshPhongMaterial?q.environment:null,Lt=Q===null?L.outputColorSpace:Q.isXRRenderTarget===!0?Q.texture.colorSpace:De.workingColorSpace,Bt=J.isMeshStandardMaterial||J.isMeshLambertMaterial&&!J.envMap||J.isMeshPhongMaterial&&!J.envMap,Xt=O.get(J.envMap||Ot,Bt),ue=J.vertexColors===!0&&!!it.attributes.color&&it.attributes.color.itemSize===4,Re=!!it.attributes.tangent&&(!!J.normalMap||J.anisotropy>0),qt=!!it.morphAttributes.position,Ce=!!it.morphAttributes.normal,vn=!!it.morphAttributes.color,Xe=rr;J.toneMapped&&(Q===null||Q.isXRRenderTarget===!0)&&(Xe=L.toneMapping);let Ye=it.morphAttributes.position||it.morphAttributes.normal||it.morphAttributes.color,zn=Ye!==void 0?Ye.length:0,Vt=Yt.get(J),Dn=w.state.lights;if(on===!0&&(In===!0||I!==Z)){let je=I===Z&&J.id===Y;at.setState(J,I,je)}let Le=!1,gr=!1;J.version===Vt.__version?Vt.needsLights&&Vt.lightsStateVersion!==Dn.state.version||K.isBatchedMesh&&Vt.batching===!1||!K.isBatchedMesh&&Vt.batching===!0||K.isBatchedMesh&&Vt.batchingColor===!0&&K._colorsTexture===null||K.isBatchedMesh&&Vt.batchingColor===!1&&K._colorsTexture!==null||K.isInstancedMesh&&Vt.instancing===!1||!K.isInstancedMesh&&Vt.instancing===!0||K.isSkinnedMesh&&Vt.skinning===!1||!K.isSkinnedMesh&&Vt.skinning===!0||K.isInstancedMesh&&Vt.instancingColor===!0&&K.instanceColor===null||K.isInstancedMesh&&Vt.instancingColor===!1&&K.instanceColor!==null||K.isInstancedMesh&&Vt.instancingMorph===!0&&K.morphTexture===null||K.isInstancedMesh&&Vt.instancingMorph===!1&&K.morphTexture!==null||Vt.envMap!==Xt||J.fog===!0&&Vt.fog!==It||Vt.numClippingPlanes!==void 0&&(Vt.numClippingPlanes!==at.numPlanes||Vt.numIntersection!==at.numIntersection)||Vt.vertexAlphas!==ue||Vt.vertexTangents!==Re||Vt.morphTargets!==qt||Vt.morphNormals!==Ce||Vt.morphColors!==vn||Vt.morphTargetsCount!==zn||Vt.numLightProbeGrids!==Pn(w.state.lightProbeGridArray)?Le=!0:(Vt.outputColorSpace!==Lt||Vt.toneMapping!==Xe)&&(gr=!0):(Le=!0,Vt.__version=J.version);let Nn=Vt.currentProgram;(Le===!0||gr===!0)&&(Nn=gr===!0?qi(J,q,K,Lt,Xe):Vs(J,q,K),H&&J.isNodeMaterial&&H.onUpdateProgram(J,Nn,Vt));let ca=!1,Ws=!1,xr=!1,Se=Nn.getUniforms(),En=Vt.uniforms;if(Ct.useProgram(Nn.program)&&(ca=!0,Ws=!0,xr=!0),J.id!==Y&&(Y=J.id,Ws=!0),ca||Z!==I){Ct.buffers.depth.getReversed()&&I.reversedDepth!==!0&&(I._reversedDepth=!0,I.updateProjectionMatrix()),Se.setValue(W,"projectionMatrix",I.projectionMatrix),Se.setValue(W,"viewMatrix",I.matrixWorldInverse);let Un=Se.map.cameraPosition;Un!==void 0&&Un.setValue(W,Zn.setFromMatrixPosition(I.matrixWorld)),xe.logarithmicDepthBuffer&&Se.setValue(W,"logDepthBufFC",2/(Math.log(I.far+1)/Math.LN2)),(J.isMeshPhongMaterial||J.isMeshToonMaterial||J.isMeshLambertMaterial||J.isMeshBasicMaterial||J.isMeshStandardMaterial||J.isShaderMaterial)&&Se.setValue(W,"isOrthographic",I.isOrthographicCamera===!0),Z!==I&&(Z=I,Ws=!0,xr=!0)}if(Vt.needsLights&&(Dn.state.sunShadowMap.length>0&&Se.setValue(W,"sunShadowMap",Dn.state.sunShadowMap,ne),Dn.state.directionalShadowMap.length>0&&Se.setValue(W,"directionalShadowMap",Dn.state.directionalShadowMap,ne),Dn.state.spotShadowMap.length>0&&Se.setValue(W,"spotShadowMap",Dn.state.spotShadowMap,ne),Dn.state.pointShadowMap.length>0&&Se.setValue(W,"pointShadowMap",Dn.state.pointShadowMap,ne)),K.isSkinnedMesh){Se.setOptional(W,K,"bindMatrix"),Se.setOptional(W,K,"bindMatrixInverse");let je=K.skeleton;je&&(je.boneTexture===null&&je.computeBoneTexture(),Se.setValue(W,"boneTexture",je.boneTexture,ne))}K.isBatchedMesh&&(Se.setOptional(W,K,"batchingTexture"),Se.setValue(W,"batchingTexture",K._matricesTexture,ne),Se.setOptional(W,K,"batchingIdTexture"),Se.setValue(W,"batchingIdTexture",K._indirectTexture,ne),Se.setOptional(W,K,"batchingColorTexture"),K._colorsTexture!==null&&Se.setValue(W,"batchingColorTexture",K._colorsTexture,ne));let yi=it.morphAttributes;if((yi.position!==void 0||yi.normal!==void 0||yi.color!==void 0)&&lt.update(K,it,Nn),(Ws||Vt.receiveShadow!==K.receiveShadow)&&(Vt.receiveShadow=K.receiveShadow,Se.setValue(W,"receiveShadow",K.receiveShadow)),(J.isMeshStandardMaterial||J.isMeshLambertMaterial||J.isMeshPhongMaterial)&&J.envMap===null&&q.environment!==null&&(En.envMapIntensity.value=q.environmentIntensity),En.dfgLUT!==void 0&&(En.dfgLUT.value=AP()),Ws){if(Se.setValue(W,"toneMappingExposure",L.toneMappingExposure),Vt.needsLights&&aa(En,xr),It&&J.fog===!0&&St.refreshFogUniforms(En,It),St.refreshMaterialUniforms(En,J,At,Tt,w.state.transmissionRenderTarget[I.id]),Vt.needsLights&&Vt.numLightProbeGrids>0){let je=v,Un=0;for(let ci of w.state.lightProbeGridArray)ci.texture!==null&&(je.textures[Un]=ci.texture,je.min[Un]=ci.boundingBox.min,je.max[Un]=ci.boundingBox.max,je.resolution[Un]=ci.resolution,Un++);for(let ci in je)je[ci].length=Un;En.probesSH.value=je.textures,En.probesMin.value=je.min,En.probesMax.value=je.max,En.probesResolution.value=je.resolution}Ka.upload(W,Vr(Vt),En,ne)}if(J.isShaderMaterial&&J.uniformsNeedUpdate===!0&&(Ka.upload(W,Vr(Vt),En,ne),J.uniformsNeedUpdate=!1),J.isSpriteMaterial&&Se.setValue(W,"center",K.center),Se.setValue(W,"modelViewMatrix",K.modelViewMatrix),Se.setValue(W,"normalMatrix",K.normalMatrix),Se.setValue(W,"modelMatrix",K.matrixWorld),J.uniformsGroups!==void 0){let je=J.uniformsGroups;for(let Un=0,ci=je.length;Un<ci;Un++){let Pu=je[Un];Zt.update(Pu,Nn),Zt.bind(Pu,Nn)}}return Nn}function aa(I,q){I.ambientLightColor.needsUpdate=q,I.lightProbe.needsUpdate=q,I.sunLights.needsUpdate=q,I.sunLightShadows.needsUpdate=q,I.directionalLights.needsUpdate=q,I.directionalLightShadows.needsUpdate=q,I.pointLights.needsUpdate=q,I.pointLightShadows.needsUpdate=q,I.spotLights.needsUpdate=q,I.spotLightShadows.needsUpdate=q,I.rectAreaLights.needsUpdate=q,I.hemisphereLights.needsUpdate=q}function Wr(I){return I.isMeshLambertMaterial||I.isMeshToonMaterial||I.isMeshPhongMaterial||I.isMeshStandardMaterial||I.isShadowMaterial||I.isShaderMaterial&&I.lights===!0}this.getActiveCubeFace=function(){return D},this.getActiveMipmapLevel=function(){return B},this.getRenderTarget=function(){return Q},this.setRenderTargetTextures=function(I,q,it){let J=Yt.get(I);J.__autoAllocateDepthBuffer=I.resolveDepthBuffer===!1,J.__autoAllocateDepthBuffer===!1&&(J.__useRenderToTexture=!1),Yt.get(I.texture).__webglTexture=q,Yt.get(I.depthTexture).__webglTexture=J.__autoAllocateDepthBuffer?void 0:it,J.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(I,q){let it=Yt.get(I);it.__webglFramebuffer=q,it.__useDefaultFramebuffer=q===void 0},this.setRenderTarget=function(I,q=0,it=0){Q=I,D=q,B=it;let J=null,K=!1,It=!1;if(I){let Lt=Yt.get(I);if(Lt.__useDefaultFramebuffer!==void 0){Ct.bindFramebuffer(W.FRAMEBUFFER,Lt.__webglFramebuffer),nt.copy(I.viewport),dt.copy(I.scissor),ft=I.scissorTest,Ct.viewport(nt),Ct.scissor(dt),Ct.setScissorTest(ft),Y=-1;return}else if(Lt.__webglFramebuffer===void 0)ne.setupRenderTarget(I);else if(Lt.__hasExternalTextures)ne.rebindTextures(I,Yt.get(I.texture).__webglTexture,Yt.get(I.depthTexture).__webglTexture);else if(I.depthBuffer){let ue=I.depthTexture;if(Lt.__boundDepthTexture!==ue){if(ue!==null&&Yt.has(ue)&&(I.width!==ue.image.width||I.height!==ue.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");ne.setupDepthRenderbuffer(I)}}let Bt=I.texture;(Bt.isData3DTexture||Bt.isDataArrayTexture||Bt.isCompressedArrayTexture)&&(It=!0);let Xt=Yt.get(I).__webglFramebuffer;I.isWebGLCubeRenderTarget?(Array.isArray(Xt[q])?J=Xt[q][it]:J=Xt[q],K=!0):I.samples>0&&ne.useMultisampledRTT(I)===!1?J=Yt.get(I).__webglMultisampledFramebuffer:Array.isArray(Xt)?J=Xt[it]:J=Xt,nt.copy(I.viewport),dt.copy(I.scissor),ft=I.scissorTest}else nt.copy(jt).multiplyScalar(At).floor(),dt.copy(Te).multiplyScalar(At).floor(),ft=Me;if(it!==0&&(J=$),Ct.bindFramebuffer(W.FRAMEBUFFER,J)&&Ct.drawBuffers(I,J),Ct.viewport(nt),Ct.scissor(dt),Ct.setScissorTest(ft),K){let Lt=Yt.get(I.texture);W.framebufferTexture2D(W.FRAMEBUFFER,W.COLOR_ATTACHMENT0,W.TEXTURE_CUBE_MAP_POSITIVE_X+q,Lt.__webglTexture,it)}else if(It){let Lt=q;for(let Bt=0;Bt<I.textures.length;Bt++){let Xt=Yt.get(I.textures[Bt]);W.framebufferTextureLayer(W.FRAMEBUFFER,W.COLOR_ATTACHMENT0+Bt,Xt.__webglTexture,it,Lt)}}else if(I!==null&&it!==0){let Lt=Yt.get(I.texture);W.framebufferTexture2D(W.FRAMEBUFFER,W.COLOR_ATTACHMENT0,W.TEXTURE_2D,Lt.__webglTexture,it)}Y=-1};function la(I){let q=Yt.get(I);return(q.__readFormat!==I.format||q.__readType!==I.type)&&(q.__readFormat=I.format,q.__readType=I.type,q.__formatReadable=xe.textureFormatReadable(I.format),q.__typeReadable=xe.textureTypeReadable(I.type)),q}this.readRenderTargetPixels=function(I,q,it,J,K,It,Ot,Lt=0){if(!(I&&I.isWebGLRenderTarget)){le("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Bt=Yt.get(I).__webglFramebuffer;if(I.isWebGLCubeRenderTarget&&Ot!==void 0&&(Bt=Bt[Ot],Array.isArray(Bt)&&(Bt=Bt[0])),Bt){Ct.bindFramebuffer(W.FRAMEBUFFER,Bt);try{let Xt=I.textures[Lt],ue=Xt.format,Re=Xt.type;I.textures.length>1&&W.readBuffer(W.COLOR_ATTACHMENT0+Lt);let qt=la(Xt);if(qt.__formatReadable===!1){le("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(qt.__typeReadable===!1){le("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}q>=0&&q<=I.width-J&&it>=0&&it<=I.height-K&&W.readPixels(q,it,J,K,Mt.convert(ue),Mt.convert(Re),It)}finally{let Xt=Q!==null?Yt.get(Q).__webglFramebuffer:null;Ct.bindFramebuffer(W.FRAMEBUFFER,Xt)}}},this.readRenderTargetPixelsAsync=async function(I,q,it,J,K,It,Ot,Lt=0){if(!(I&&I.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Bt=Yt.get(I).__webglFramebuffer;if(I.isWebGLCubeRenderTarget&&Ot!==void 0&&(Bt=Bt[Ot],Array.isArray(Bt)&&(Bt=Bt[0])),Bt)if(q>=0&&q<=I.width-J&&it>=0&&it<=I.height-K){Ct.bindFramebuffer(W.FRAMEBUFFER,Bt);let Xt=I.textures[Lt],ue=Xt.format,Re=Xt.type;I.textures.length>1&&W.readBuffer(W.COLOR_ATTACHMENT0+Lt);let qt=la(Xt);if(qt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(qt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let Ce=W.createBuffer();W.bindBuffer(W.PIXEL_PACK_BUFFER,Ce),W.bufferData(W.PIXEL_PACK_BUFFER,It.byteLength,W.STREAM_READ),W.readPixels(q,it,J,K,Mt.convert(ue),Mt.convert(Re),0),W.bindBuffer(W.PIXEL_PACK_BUFFER,null);let vn=Q!==null?Yt.get(Q).__webglFramebuffer:null;Ct.bindFramebuffer(W.FRAMEBUFFER,vn);let Xe=W.fenceSync(W.SYNC_GPU_COMMANDS_COMPLETE,0);return W.flush(),await vy(W,Xe,4),W.bindBuffer(W.PIXEL_PACK_BUFFER,Ce),W.getBufferSubData(W.PIXEL_PACK_BUFFER,0,It),W.bindBuffer(W.PIXEL_PACK_BUFFER,null),W.deleteBuffer(Ce),W.deleteSync(Xe),It}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(I,q=null,it=0){let J=Math.pow(2,-it),K=Math.floor(I.image.width*J),It=Math.floor(I.image.height*J),Ot=q!==null?q.x:0,Lt=q!==null?q.y:0;ne.setTexture2D(I,0),W.copyTexSubImage2D(W.TEXTURE_2D,it,0,0,Ot,Lt,K,It),Ct.unbindTexture()},this.copyTextureToTexture=function(I,q,it=null,J=null,K=0,It=0){let Ot,Lt,Bt,Xt,ue,Re,qt,Ce,vn,Xe=I.isCompressedTexture?I.mipmaps[It]:I.image;if(it!==null)Ot=it.max.x-it.min.x,Lt=it.max.y-it.min.y,Bt=it.isBox3?it.max.z-it.min.z:1,Xt=it.min.x,ue=it.min.y,Re=it.isBox3?it.min.z:0;else{let Se=Math.pow(2,-K);Ot=Math.floor(Xe.width*Se),Lt=Math.floor(Xe.height*Se),I.isDataArrayTexture?Bt=Xe.depth:I.isData3DTexture?Bt=Math.floor(Xe.depth*Se):Bt=1,Xt=0,ue=0,Re=0}J!==null?(qt=J.x,Ce=J.y,vn=J.z):(qt=0,Ce=0,vn=0);let Ye=Mt.convert(q.format),zn=Mt.convert(q.type),Vt;q.isData3DTexture?(ne.setTexture3D(q,0),Vt=W.TEXTURE_3D):q.isDataArrayTexture||q.isCompressedArrayTexture?(ne.setTexture2DArray(q,0),Vt=W.TEXTURE_2D_ARRAY):(ne.setTexture2D(q,0),Vt=W.TEXTURE_2D),Ct.activeTexture(W.TEXTURE0),Ct.pixelStorei(W.UNPACK_FLIP_Y_WEBGL,q.flipY),Ct.pixelStorei(W.UNPACK_PREMULTIPLY_ALPHA_WEBGL,q.premultiplyAlpha),Ct.pixelStorei(W.UNPACK_ALIGNMENT,q.unpackAlignment);let Dn=Ct.getParameter(W.UNPACK_ROW_LENGTH),Le=Ct.getParameter(W.UNPACK_IMAGE_HEIGHT),gr=Ct.getParameter(W.UNPACK_SKIP_PIXELS),Nn=Ct.getParameter(W.UNPACK_SKIP_ROWS),ca=Ct.getParameter(W.UNPACK_SKIP_IMAGES);Ct.pixelStorei(W.UNPACK_ROW_LENGTH,Xe.width),Ct.pixelStorei(W.UNPACK_IMAGE_HEIGHT,Xe.height),Ct.pixelStorei(W.UNPACK_SKIP_PIXELS,Xt),Ct.pixelStorei(W.UNPACK_SKIP_ROWS,ue),Ct.pixelStorei(W.UNPACK_SKIP_IMAGES,Re);let Ws=I.isDataArrayTexture||I.isData3DTexture,xr=q.isDataArrayTexture||q.isData3DTexture;if(I.isDepthTexture){let Se=Yt.get(I),En=Yt.get(q),yi=Yt.get(Se.__renderTarget),je=Yt.get(En.__renderTarget);Ct.bindFramebuffer(W.READ_FRAMEBUFFER,yi.__webglFramebuffer),Ct.bindFramebuffer(W.DRAW_FRAMEBUFFER,je.__webglFramebuffer);for(let Un=0;Un<Bt;Un++)Ws&&(W.framebufferTextureLayer(W.READ_FRAMEBUFFER,W.COLOR_ATTACHMENT0,Yt.get(I).__webglTexture,K,Re+Un),W.framebufferTextureLayer(W.DRAW_FRAMEBUFFER,W.COLOR_ATTACHMENT0,Yt.get(q).__webglTexture,It,vn+Un)),W.blitFramebuffer(Xt,ue,Xt+Ot,ue+Lt,qt,Ce,qt+Ot,Ce+Lt,W.DEPTH_BUFFER_BIT,W.NEAREST);Ct.bindFramebuffer(W.READ_FRAMEBUFFER,null),Ct.bindFramebuffer(W.DRAW_FRAMEBUFFER,null)}else if(K!==0||I.isRenderTargetTexture||Yt.has(I)){let Se=Yt.get(I),En=Yt.get(q);Ct.bindFramebuffer(W.READ_FRAMEBUFFER,P),Ct.bindFramebuffer(W.DRAW_FRAMEBUFFER,z);for(let yi=0;yi<Bt;yi++)Ws?W.framebufferTextureLayer(W.READ_FRAMEBUFFER,W.COLOR_ATTACHMENT0,Se.__webglTexture,K,Re+yi):W.framebufferTexture2D(W.READ_FRAMEBUFFER,W.COLOR_ATTACHMENT0,W.TEXTURE_2D,Se.__webglTexture,K),xr?W.framebufferTextureLayer(W.DRAW_FRAMEBUFFER,W.COLOR_ATTACHMENT0,En.__webglTexture,It,vn+yi):W.framebufferTexture2D(W.DRAW_FRAMEBUFFER,W.COLOR_ATTACHMENT0,W.TEXTURE_2D,En.__webglTexture,It),K!==0?W.blitFramebuffer(Xt,ue,Xt+Ot,ue+Lt,qt,Ce,qt+Ot,Ce+Lt,W.COLOR_BUFFER_BIT,W.NEAREST):xr?W.copyTexSubImage3D(Vt,It,qt,Ce,vn+yi,Xt,ue,Ot,Lt):W.copyTexSubImage2D(Vt,It,qt,Ce,Xt,ue,Ot,Lt);Ct.bindFramebuffer(W.READ_FRAMEBUFFER,null),Ct.bindFramebuffer(W.DRAW_FRAMEBUFFER,null)}else xr?I.isDataTexture||I.isData3DTexture?W.texSubImage3D(Vt,It,qt,Ce,vn,Ot,Lt,Bt,Ye,zn,Xe.data):q.isCompressedArrayTexture?W.compressedTexSubImage3D(Vt,It,qt,Ce,vn,Ot,Lt,Bt,Ye,Xe.data):W.texSubImage3D(Vt,It,qt,Ce,vn,Ot,Lt,Bt,Ye,zn,Xe):I.isDataTexture?W.texSubImage2D(W.TEXTURE_2D,It,qt,Ce,Ot,Lt,Ye,zn,Xe.data):I.isCompressedTexture?W.compressedTexSubImage2D(W.TEXTURE_2D,It,qt,Ce,Xe.width,Xe.height,Ye,Xe.data):W.texSubImage2D(W.TEXTURE_2D,It,qt,Ce,Ot,Lt,Ye,zn,Xe);Ct.pixelStorei(W.UNPACK_ROW_LENGTH,Dn),Ct.pixelStorei(W.UNPACK_IMAGE_HEIGHT,Le),Ct.pixelStorei(W.UNPACK_SKIP_PIXELS,gr),Ct.pixelStorei(W.UNPACK_SKIP_ROWS,Nn),Ct.pixelStorei(W.UNPACK_SKIP_IMAGES,ca),It===0&&q.generateMipmaps===!0&&q.mipmapsAutoUpdate===!0&&W.generateMipmap(Vt),Ct.unbindTexture()},this.initRenderTarget=function(I){Yt.get(I).__webglFramebuffer===void 0&&ne.setupRenderTarget(I)},this.initTexture=function(I){I.isCubeTexture?ne.setTextureCube(I,0):I.isData3DTexture?ne.setTexture3D(I,0):I.isDataArrayTexture||I.isCompressedArrayTexture?ne.setTexture2DArray(I,0):ne.setTexture2D(I,0),Ct.unbindTexture()},this.resetState=function(){D=0,B=0,Q=null,Ct.reset(),Rt.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return hs}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=De._getDrawingBufferColorSpace(t),e.unpackColorSpace=De._getUnpackColorSpace()}};var kd={about:"One identity for the workbench, reports, figures and the site; read by document/identity.py and the page's build.",wordmark:"pieper",type:{sans:'"Inter Variable", Inter, system-ui, -apple-system, "Segoe UI", Roboto, "Noto Sans", "DejaVu Sans", sans-serif',serif:'"Source Serif 4", "Iowan Old Style", "Palatino Linotype", Palatino, "Noto Serif", Georgia, serif',mono:'ui-monospace, "SFMono-Regular", "JetBrains Mono", Menlo, Consolas, "DejaVu Sans Mono", monospace'},light:{colours:{paper:"#ffffff",panel:"#ffffff",ground:"#f3f4f6",soft:"#f0f2f5",softer:"#f7f8fa",ink:"#171c24",muted:"#566070",line:"#dde1e7",edge:"#8891a0",accent:"#c2410c",accentInk:"#b03a08",accentSoft:"#fdeee6",onAccent:"#ffffff",good:"#1a7f4b",wrong:"#b42318",wrongSoft:"#fdecea",onWrong:"#ffffff",link:"#d5d9e0",joint:"#39424f",ghost:"#5b6b84",trace:"#0072b2",gridFine:"#e3e6eb",gridCoarse:"#cfd4dc"},curves:["#0072b2","#d55e00","#009e73","#cc79a7","#8a6d00","#56b4e9","#4b4b4b","#7a3e9d"]},dark:{colours:{paper:"#12151a",panel:"#171b21",ground:"#101318",soft:"#222831",softer:"#1c2128",ink:"#e9ecf1",muted:"#a3acba",line:"#2b323c",edge:"#6d7787",accent:"#ff8a4c",accentInk:"#ff9d68",accentSoft:"#3a2419",onAccent:"#1a0f08",good:"#4cc38a",wrong:"#ff8f85",wrongSoft:"#3a1d1b",onWrong:"#2a0b08",link:"#9aa5b5",joint:"#4d5969",ghost:"#8fa6c8",trace:"#56b4e9",gridFine:"#1b2027",gridCoarse:"#2a313b"},curves:["#56b4e9","#ff9a4d","#2fd6a3","#f0a3cb","#f0e442","#8fb7ff","#d0d4da","#c9a0ff"]},axes:["#d55e00","#009e73","#0072b2"]};var Ft={},CP=["ground","gridFine","gridCoarse","link","joint","accent","ghost","ink","muted","line","trace","panel","wrong"],sv=matchMedia("(prefers-color-scheme: dark)");function zd(){let n=b.theme==="dark"||b.theme==="auto"&&sv.matches;document.documentElement.dataset.theme=n?"dark":"light",document.documentElement.style.setProperty("--text-size",String(ag()));let t=getComputedStyle(document.documentElement);for(let e of CP)Ft[e]=t.getPropertyValue(`--${e.replace(/[A-Z]/g,i=>`-${i.toLowerCase()}`)}`).trim();Ft.dark=n,Ft.curves=kd[n?"dark":"light"].curves}function Hd(n){b.theme=n,zd(),ut("theme")}var rv="pieper-text-size";function ag(){let n=Number(localStorage.getItem(rv));return n>=.5&&n<=3?n:1}function ov(n){document.documentElement.style.setProperty("--text-size",String(n));try{localStorage.setItem(rv,String(n))}catch{}ut("theme"),dispatchEvent(new Event("resize"))}sv.addEventListener("change",()=>{b.theme==="auto"&&(zd(),ut("theme"))});var av={type:"change"},cg={type:"start"},cv={type:"end"},Gd=new Cr,lv=new ri,PP=Math.cos(70*uo.DEG2RAD),qn=new G,Gi=2*Math.PI,Ve={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},lg=1e-6,Vd=class extends Pc{constructor(t,e=null){super(t,e),this.state=Ve.NONE,this.target=new G,this.cursor=new G,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:oo.ROTATE,MIDDLE:oo.DOLLY,RIGHT:oo.PAN},this.touches={ONE:ao.ROTATE,TWO:ao.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new G,this._lastQuaternion=new fn,this._lastTargetPosition=new G,this._quat=new fn().setFromUnitVectors(t.up,new G(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new Xa,this._sphericalDelta=new Xa,this._scale=1,this._panOffset=new G,this._rotateStart=new Qt,this._rotateEnd=new Qt,this._rotateDelta=new Qt,this._panStart=new Qt,this._panEnd=new Qt,this._panDelta=new Qt,this._dollyStart=new Qt,this._dollyEnd=new Qt,this._dollyDelta=new Qt,this._dollyDirection=new G,this._mouse=new Qt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=LP.bind(this),this._onPointerDown=IP.bind(this),this._onPointerUp=DP.bind(this),this._onContextMenu=zP.bind(this),this._onMouseWheel=OP.bind(this),this._onKeyDown=FP.bind(this),this._onTouchStart=BP.bind(this),this._onTouchMove=kP.bind(this),this._onMouseDown=NP.bind(this),this._onMouseMove=UP.bind(this),this._interceptControlDown=HP.bind(this),this._interceptControlUp=GP.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Ve.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(av),this.update(),this.state=Ve.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;qn.copy(e).sub(this.target),qn.applyQuaternion(this._quat),this._spherical.setFromVector3(qn),this.autoRotate&&this.state===Ve.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=Gi:i>Math.PI&&(i-=Gi),s<-Math.PI?s+=Gi:s>Math.PI&&(s-=Gi),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(qn.setFromSpherical(this._spherical),qn.applyQuaternion(this._quatInverse),e.copy(this.target).add(qn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=qn.length();o=this._clampDistance(a*this._scale);let c=a-o;this.object.position.addScaledVector(this._dollyDirection,c),this.object.updateMatrixWorld(),r=!!c}else if(this.object.isOrthographicCamera){let a=new G(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let c=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=c!==this.object.zoom;let l=new G(this._mouse.x,this._mouse.y,0);l.unproject(this.object),this.object.position.sub(l).add(a),this.object.updateMatrixWorld(),o=qn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(Gd.origin.copy(this.object.position),Gd.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Gd.direction))<PP?this.object.lookAt(this.target):(lv.setFromNormalAndCoplanarPoint(this.object.up,this.target),Gd.intersectPlane(lv,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>lg||8*(1-this._lastQuaternion.dot(this.object.quaternion))>lg||this._lastTargetPosition.distanceToSquared(this.target)>lg?(this.dispatchEvent(av),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?Gi/60*this.autoRotateSpeed*t:Gi/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){qn.setFromMatrixColumn(e,0),qn.multiplyScalar(-t),this._panOffset.add(qn)}_panUp(t,e){this.screenSpacePanning===!0?qn.setFromMatrixColumn(e,1):(qn.setFromMatrixColumn(e,0),qn.crossVectors(this.object.up,qn)),qn.multiplyScalar(t),this._panOffset.add(qn)}_pan(t,e){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;qn.copy(s).sub(this.target);let r=qn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/i.clientHeight,this.object.matrix),this._panUp(2*e*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=t-i.left,r=e-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(Gi*this._rotateDelta.x/e.clientHeight),this._rotateUp(Gi*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(Gi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-Gi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(Gi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-Gi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(i,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let i=this._getSecondPointerPosition(t),s=.5*(t.pageX+i.x),r=.5*(t.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(Gi*this._rotateDelta.x/e.clientHeight),this._rotateUp(Gi*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new Qt,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,i={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function IP(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function LP(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function DP(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(cv),this.state=Ve.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function NP(n){let t;switch(n.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case oo.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=Ve.DOLLY;break;case oo.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Ve.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Ve.ROTATE}break;case oo.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Ve.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Ve.PAN}break;default:this.state=Ve.NONE}this.state!==Ve.NONE&&this.dispatchEvent(cg)}function UP(n){switch(this.state){case Ve.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case Ve.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case Ve.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function OP(n){this.enabled===!1||this.enableZoom===!1||this.state!==Ve.NONE||(n.preventDefault(),this.dispatchEvent(cg),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(cv))}function FP(n){this.enabled!==!1&&this._handleKeyDown(n)}function BP(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case ao.ROTATE:if(this.enableRotate===!1){this.state=Ve.NONE;break}this._handleTouchStartRotate(n),this.state=Ve.TOUCH_ROTATE;break;case ao.PAN:if(this.enablePan===!1){this.state=Ve.NONE;break}this._handleTouchStartPan(n),this.state=Ve.TOUCH_PAN;break;default:this.state=Ve.NONE}break;case 2:switch(this.touches.TWO){case ao.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=Ve.TOUCH_DOLLY_PAN;break;case ao.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=Ve.TOUCH_DOLLY_ROTATE;break;default:this.state=Ve.NONE}break;default:this.state=Ve.NONE}this.state!==Ve.NONE&&this.dispatchEvent(cg)}function kP(n){switch(this._trackPointer(n),this.state){case Ve.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case Ve.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case Ve.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case Ve.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=Ve.NONE}}function zP(n){this.enabled!==!1&&n.preventDefault()}function HP(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function GP(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var uv=[1,.75,.55,.42],VP=30,WP=17,$P=400,hv=6e6;function dv(n){let t=n.getExtension("WEBGL_debug_renderer_info");return/swiftshader|llvmpipe|software|basic render/i.test(String(n.getParameter(t?t.UNMASKED_RENDERER_WEBGL:n.RENDERER)))}var Wd=class{constructor(t,e,i,s){this.software=t,this.renderer=e,this.draw=i,this.hurry=s,this.resting=!0,this.level=0,this.gaps=[],this.last=0,this.area=1}resized(t,e){this.area=t*e}get base(){return Math.min(devicePixelRatio,2,Math.sqrt(hv/this.area))}#t(t){Math.abs(this.renderer.getPixelRatio()-t)>.001&&this.renderer.setPixelRatio(t)}moving(t){if(!this.software){this.#t(this.base);return}let e=t-this.last;if(this.last=t,e<120&&this.gaps.push(e),this.gaps.length>=8){let i=this.gaps.sort((s,r)=>s-r)[4];this.gaps=[],i>VP&&this.level<uv.length-1?this.level+=1:i<WP&&this.level>0&&(this.level-=1)}this.resting&&this.hurry(!0),this.resting=!1,this.#t(this.base*uv[this.level]),clearTimeout(this.timer),this.timer=setTimeout(()=>{this.gaps=[],this.resting=!0,this.hurry(!1),this.#t(Math.min(2*this.base,Math.max(Math.sqrt(hv/this.area),.5))),this.draw()},$P)}};var mv=32,gv={iso:[1,-1.25,.62],front:[1,0,0],side:[0,-1,0],top:[0,-1e-4,1]},tn=new mc,Ie=new Ti(mv,1,.01,100);Ie.up.set(0,0,1);var is,pn,fs,$d,ug=!1,xv=!1,dg=0;function de(){ug||!xv||(ug=!0,requestAnimationFrame(_v))}function _v(n=performance.now()){ug=!1,$d.moving(n),fg()}var yv=[],qd=n=>yv.push(n);function fg(){for(let n of yv)n();is.render(tn,Ie),dg+=1}function vv(){xv=!0,de()}function tl(n){return fg(),n(is.domElement)}var bv=()=>dg,Mv=()=>!!$d?.software;tn.fog=new pc("#fff",1,10);function fv(n){let t=document.createElement("canvas");t.width=fs.clientWidth||1,t.height=fs.clientHeight||1;let e=t.getContext("webgl2",{alpha:!1,antialias:n,stencil:!0,powerPreference:"high-performance"});if(!e)throw new Error("This browser offers no WebGL 2, which the picture needs.");let i=e.getExtension.bind(e);return e.getExtension=s=>qP.has(s)?i(s):null,e}var qP=new Set(["WEBGL_debug_renderer_info","WEBGL_lose_context"]);function Sv(n){fs=n;let t=fv(!1),e=dv(t);e||(t.getExtension("WEBGL_lose_context")?.loseContext(),t=fv(!0)),is=new Od({canvas:t.canvas,context:t}),is.debug.checkShaderErrors=!1,$d=new Wd(e,is,fg,i=>ut("hurry",i)),is.domElement.setAttribute("aria-hidden","true"),fs.append(is.domElement),pn=new Vd(Ie,is.domElement),pn.enableDamping=!1,pn.addEventListener("change",de),pn.addEventListener("end",()=>{el=!mg(),cr=null}),new ResizeObserver(XP).observe(fs),fs.tabIndex=0,fs.setAttribute("role","application"),fs.setAttribute("aria-label","The arm in space. Arrow keys turn the view, plus and minus zoom, F fits, 1 to 4 are the standard views."),fs.addEventListener("keydown",YP)}function XP(){let n=fs.clientWidth,t=fs.clientHeight;!n||!t||($d.resized(n,t),is.setSize(n,t),Ie.aspect=n/t,Ie.updateProjectionMatrix(),dg?_v():de(),ZP()||nl())}function YP(n){let t={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,-1],ArrowDown:[0,1]}[n.key],e={1:"iso",2:"front",3:"side",4:"top"}[n.key];if(t)jP(t[0]*.1,t[1]*.1);else if(n.key==="+"||n.key==="=")pv(1/1.15);else if(n.key==="-")pv(1.15);else if(n.key.toLowerCase()==="f")Xd($o);else if(e)pg(e);else return;n.preventDefault()}function jP(n,t){let e=Ie.position.clone().sub(pn.target),i=e.length(),s=Math.atan2(e.y,e.x)+n,r=Math.min(Math.max(Math.acos(e.z/i)+t,.02),Math.PI-.02);Ie.position.set(Math.sin(r)*Math.cos(s),Math.sin(r)*Math.sin(s),Math.cos(r)).multiplyScalar(i).add(pn.target),pn.update(),de()}function pv(n){Ie.position.sub(pn.target).multiplyScalar(n).add(pn.target),pn.update(),de()}var $o=[[0,0,0],[0,0,1]];function wv(n,t){let e=new zi().setFromPoints(n.map(u=>new G(...u))),i=e.getCenter(new G),s=new G(...t).normalize(),r=new G().crossVectors(Ie.up,s).normalize(),o=new G().crossVectors(s,r),a=Math.tan(uo.degToRad(mv/2))*.8,c=a*Ie.aspect,l=e.getSize(new G).length()*.4+.001;for(let u=0;u<3;u++){let h=0,d=1/0,f=-1/0,p=1/0,_=-1/0;for(let m of n){let g=new G(...m).sub(i),x=g.dot(r),S=g.dot(o),v=g.dot(s);h=Math.max(h,v+Math.abs(x)/c,v+Math.abs(S)/a),d=Math.min(d,S),f=Math.max(f,S),p=Math.min(p,x),_=Math.max(_,x)}l=Math.max(h,l*.2),u<2&&i.addScaledVector(o,(d+f)/2).addScaledVector(r,(p+_)/2)}return{target:i,position:i.clone().addScaledVector(s,l)}}var hg=0;function Vc({target:n,position:t},e=.35){let i={t:pn.target.clone(),p:Ie.position.clone()},s=performance.now(),r=++hg,o=matchMedia("(prefers-reduced-motion: reduce)").matches||e===0;(function a(c){if(r!==hg)return;let l=o?1:Math.min((c-s)/(1e3*e),1),u=l*l*(3-2*l);pn.target.lerpVectors(i.t,n,u),Ie.position.lerpVectors(i.p,t,u);let h=Ie.position.distanceTo(pn.target);Ie.near=h/100,Ie.far=h*30,tn.fog.near=h*1.3,tn.fog.far=h*3.4,Ie.updateProjectionMatrix(),pn.update(),de(),l<1&&requestAnimationFrame(a)})(s)}function Xd(n,{instant:t=!1,view:e=null,byItself:i=!1}={}){$o=n,i||(cr=null),el=!1;let s=e?gv[e]:Ie.position.clone().sub(pn.target).toArray();Vc(wv(n,s),t?0:.35)}function pg(n){el=!1,cr=null,Vc(wv($o,gv[n]))}var el=!1;function mg(){Ie.updateMatrixWorld();let n=new G;return $o.every(t=>(n.set(...t).project(Ie),Math.abs(n.x)<1&&Math.abs(n.y)<1&&n.z<1))}function nl(){el||!pn.enabled||!$o.length||mg()||(cr??={position:Ie.position.clone(),target:pn.target.clone()},Xd($o,{byItself:!0}))}var cr=null;function Ev(){if(!cr||el||!pn.enabled)return;let n=cr;cr=null,Vc(n),setTimeout(nl,500)}function ZP(){if(!cr||el||!pn.enabled)return!1;let n={position:Ie.position.clone(),target:pn.target.clone()},t=cr,e=({position:s,target:r})=>{Ie.position.copy(s),pn.target.copy(r),Ie.lookAt(r)};e(t);let i=mg();return e(n),i?(cr=null,Vc(t,0),!0):!1}var gg=n=>{$o=n},il=()=>[...Ie.position.toArray(),...pn.target.toArray()].map(n=>Number(n.toPrecision(5)));function Tv(n){hg+=1,Vc({position:new G(...n.slice(0,3)),target:new G(...n.slice(3))},0)}var lr=null,xg={cell:.1};function _g(n){let t=n/6,e=10**Math.floor(Math.log10(t)),i=[1,2,5,10].map(u=>u*e).findLast(u=>u<=t*1.0001)??e;xg.cell=i;let s=Math.ceil(n*2.2/i),r=[],o=[],a=new ee(Ft.gridFine),c=new ee(Ft.gridCoarse);for(let u=-s;u<=s;u++){let h=u%5===0?c:a,d=s*i;r.push(u*i,-d,0,u*i,d,0,-d,u*i,0,d,u*i,0);for(let f=0;f<4;f++)o.push(h.r,h.g,h.b)}lr?.geometry.dispose();let l=new be;l.setAttribute("position",new ve(r,3)),l.setAttribute("color",new ve(o,3)),lr?lr.geometry=l:(lr=new Fo(l,new ts({vertexColors:!0})),lr.renderOrder=-2,lr.material.depthWrite=!1,tn.add(lr)),lr.userData.reach=n,de()}function yg(){tn.background=new ee(Ft.ground),tn.fog.color.set(Ft.ground),lr&&_g(lr.userData.reach),de()}function Vi(n){Ie.updateMatrixWorld();let t=new G(...n).project(Ie),e=fs.getBoundingClientRect();return[e.x+(t.x+1)/2*e.width,e.y+(1-t.y)/2*e.height]}function Yd(n){let t=n.joints.length,e=Gn(n),i=Math.min(.062,.075-.002*t)*e,s=n.joints.map((r,o)=>i*(1-.52*o/Math.max(t-1,1)));return{size:e,radius:s,rest:s[t-1]??i*.5}}function vg(n,t,e,i=null){let s={rods:[],balls:[],drums:[],sleeves:[],flange:null},{radius:r,size:o}=e,a=n.joints.length,c=o*1e-6,l=Up(n,t),u=(d,f,p,_=!0,m=p)=>{Ui(Ni(f,d))<=c||(s.rods.push({a:d,b:f,r:p,far:m}),_&&s.balls.push({at:f,r:m}))};a&&(s.pedestal={at:te(t[0]),dir:js(t[0],2),r:r[0]*1.7,h:r[0]*.34});let h=null;if(l.forEach(({point:d,dir:f,x:p},_)=>{let m=r[_],g=n.joints[_],x=te(t[_]),S=te(t[_+1]),v=m*.62,A=m*.84,w=(r[_+1]??e.rest)*.62,y=(r[_-1]??m)*.84;if(n.convention==="standard"){let z=Zl(x,f,jl(Ni(S,x),f));u(x,z,v),u(z,S,A,!0,w)}else u(x,d,y,!0,v),u(d,S,v);let E=d,U=jl(Ni(S,d),f);h&&Ui(Ni(d,h.at))<.5*m&&Math.abs(U)>c?E=Zl(d,f,Math.sign(U)*Math.min(Math.abs(U)*.55,h.r+m*1.15)):_===0&&Math.abs(U)>2.2*m&&(E=Zl(d,f,Math.sign(U)*m*1.25));let L=m*2.15,N=js(t[_+1],0),H=!!(i&&Wc(g,i[_])),$=js(t[0],2),P=jl(Ni(E,te(t[0])),$)-L/2;_===0&&g.type==="R"&&Math.abs(jl(f,$))>.99&&P<0&&P>-L&&(E=Zl(E,$,-P)),g.type==="R"?s.drums.push({at:E,dir:f,x:p,turned:N,r:m,h:L,beyond:H,joint:_}):s.sleeves.push({at:E,dir:f,x:p,r:m*.95,h:m*3.4,beyond:H,joint:_}),h={at:d,r:m}}),a){let d=t[a+1],f=te(t[a]);s.flange={at:f,dir:js(t[a],2),turned:js(t[a],0),r:e.rest*.85,h:e.rest*.5},u(f,te(d),e.rest*.34,!1),s.tip={at:te(d),r:e.rest*.42}}return s}function Wc(n,t){return n.lower!==null&&t<n.lower-1e-9?t-n.lower:n.upper!==null&&t>n.upper+1e-9?t-n.upper:0}var bg=.13;function $c(n,t){let{radius:e,size:i}=Yd(n),s=e[0]??.05,r=te(t[0]);if(!n.joints.length)return[-.4,.4].flatMap(l=>[[r[0]+l,r[1]+l,0],[r[0]+l,r[1]-l,1]]);let o=[[r[0],r[1],0],...t.map(te)];for(let{point:l}of Up(n,t))o.push(l);let a=t.at(-1);return[...[0,1,2].map(l=>[3,7,11].map(u=>a[u]+bg*i*a[u-3+l])),...o.flatMap(l=>[[l[0]-s,l[1]-s,l[2]-s],[l[0]+s,l[1]+s,l[2]+s]])]}function KP(n,t){let i=a=>a.rotateX(Math.PI/2),s=[[0,-.5],[.9,-.5],[1,-.45],[1,.45],[.9,.5],[0,.5]],r=t>8?new wc(s.map(([a,c])=>new Qt(a,c)),n):new Ri(1,1,1,n),o={rod:i(new Ri(1,1,1,n,1,!0)),ball:t>3?new Ps(1,n,t):new Ec(1,0),drum:i(r),box:new Hi(2,2,1)};return Object.fromEntries(Object.entries(o).map(([a,c])=>{let l=c.attributes.position,u=c.index?c.index.array:Uint16Array.from({length:l.count},(h,d)=>d);return[a,{at:l.array,normal:c.attributes.normal.array,index:u,count:l.count}]}))}var Av=new Map,Eg=(n,t)=>Av.get(n)??Av.set(n,KP(n,t)).get(n),QP=()=>Eg(26,12),Mg=()=>Eg(11,5),Rv=()=>Eg(6,3),qc=class{constructor(t){this.mesh=new Ge(new be,t),this.mesh.frustumCulled=!1,this.mesh.visible=!1,this.#t(1024,4096),this.clear()}#t(t,e){let i=this.mesh.geometry.attributes,s=new be,r=(a,c)=>{let l=new Float32Array(c*t);i[a]&&l.set(i[a].array);let u=new He(l,c).setUsage(Id);return s.setAttribute(a,u),l};this.at=r("position",3),this.normal=r("normal",3),this.paint=r("paint",1);let o=new Uint32Array(e);this.index&&o.set(this.index),this.index=o,s.setIndex(new He(o,1).setUsage(Id)),this.mesh.geometry.dispose(),this.mesh.geometry=s}clear(){this.corners=0,this.indices=0}put(t,e,i,s,r,o,a,c,l=a){let u=this.corners,h=u+t.count;(3*h>this.at.length||this.indices+t.index.length>this.index.length)&&this.#t(2*Math.max(h,this.at.length/3),2*Math.max(this.indices+t.index.length,this.index.length));for(let d=0,f=3*u;d<3*t.count;d+=3,f+=3){let p=t.at[d+2]>0?l:a,_=p*t.at[d],m=p*t.at[d+1],g=c*t.at[d+2],x=t.normal[d]/a,S=t.normal[d+1]/a,v=t.normal[d+2]/c;for(let A=0;A<3;A++)this.at[f+A]=i[A]+s[A]*_+r[A]*m+o[A]*g,this.normal[f+A]=s[A]*x+r[A]*S+o[A]*v}this.paint.fill(e,u,h);for(let d=0;d<t.index.length;d++)this.index[this.indices+d]=u+t.index[d];this.corners=h,this.indices+=t.index.length}done(){let t=this.mesh.geometry;for(let[e,i]of[[t.attributes.position,3*this.corners],[t.attributes.normal,3*this.corners],[t.attributes.paint,this.corners],[t.index,this.indices]])e.clearUpdateRanges(),e.addUpdateRange(0,i),e.needsUpdate=!0;t.setDrawRange(0,this.indices),this.mesh.visible=this.indices>0}},Cv=[1,0,0],tI=[0,1,0],Pv=[0,0,1];function eI(n,t=null){let e=t&&Math.abs(n[0]*t[0]+n[1]*t[1]+n[2]*t[2])<.5?t:Du(n,Math.abs(n[2])<.9?Pv:Cv),i=Du(n,e),s=Ui(i)||1,r=i.map(o=>o/s);return[Du(r,n),r]}var jd=0,Zd=1,Sg=2,wg=3,sl=class{constructor(t,{shadow:e=null,veil:i=!1,rim:s=null}={}){this.group=new Rn,this.veil=i,this.moving=!1,this.seen=this.shadowSeen=!0,this.arms=[],this.body=new qc(t),this.group.add(this.body.mesh),s&&(this.rim=new qc(s),this.rim.mesh.renderOrder=1,this.group.add(this.rim.mesh)),e&&(this.flat=new qc(e.material),this.flat.mesh.matrixAutoUpdate=!1,this.flat.mesh.matrix.copy(e.matrix),this.flat.mesh.renderOrder=-1,this.group.add(this.flat.mesh))}shown(t,e){t===this.seen&&e===this.shadowSeen||(this.seen=t,this.shadowSeen=e,this.show(this.arms))}hurry(t){this.moving=t,this.show(this.arms)}show(t){this.arms=t,this.body.clear();let e=this.veil?this.moving?Rv:Mg:this.moving?Mg:QP;for(let i of this.seen?t:[])this.#t(this.body,i,e());if(this.body.done(),this.rim){this.rim.clear();for(let i of this.seen&&!this.moving?t:[])this.#t(this.rim,i,e(),{rim:!0});this.rim.done()}if(this.flat){this.flat.clear();for(let i of this.shadowSeen?t:[])this.#t(this.flat,i,this.moving?Rv():Mg(),{flat:!0});this.flat.done()}}#t(t,e,i,{flat:s=!1,rim:r=!1}={}){let o=this.rim&&!this.moving&&!r?e.rim:0,a=!this.veil&&!s,c=f=>this.veil?Math.max(.96*f-o,.3*f):f,l=f=>2*c(f/2),u=f=>this.veil?e.outside?wg:jd:f,h=(f,p,_,m,g,x,S,v)=>t.put(f,u(p),_,...eI(m,S),m,g,x,v),d=(f,p,_)=>t.put(i.ball,u(f),p,Cv,tI,Pv,_,_);for(let{a:f,b:p,r:_,far:m}of e.rods){let g=Ni(p,f),x=Ui(g),S=[(f[0]+p[0])/2,(f[1]+p[1])/2,(f[2]+p[2])/2];h(i.rod,jd,S,g.map(v=>v/x),c(_),x,null,c(m??_))}for(let{at:f,r:p}of e.balls)d(jd,f,c(p));for(let{at:f,dir:p,turned:_,r:m,h:g,beyond:x}of e.drums){if(h(i.drum,x&&a?wg:Zd,f,p,c(m),l(g)),!a)continue;h(i.rod,Sg,f,p,m*1.012,g*.13);let S=[0,1,2].map(v=>f[v]+_[v]*m*.96);h(i.box,jd,S,p,m*.11,g*.86,_)}for(let{at:f,dir:p,x:_,r:m,h:g,beyond:x}of e.sleeves)h(i.box,x&&a?wg:Zd,f,p,c(m),l(g),_);if(e.pedestal&&!this.veil){let{at:f,dir:p,r:_,h:m}=e.pedestal;h(i.drum,Zd,[f[0]+p[0]*m/2,f[1]+p[1]*m/2,f[2]+p[2]*m/2],p,_,m)}if(e.flange&&h(i.drum,Zd,e.flange.at,e.flange.dir,c(e.flange.r),l(e.flange.h)),e.flange&&a){let{at:f,dir:p,turned:_,r:m,h:g}=e.flange;h(i.box,Sg,[0,1,2].map(x=>f[x]+_[x]*m*.95),p,m*.16,g*1.04,_)}e.tip&&a&&d(Sg,e.tip.at,e.tip.r)}};var nI=`
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
  }`,Iv=`
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
  }`,iI=`
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
  }`,sI=`
  uniform float opacity;
  varying vec3 vColour;
  void main() {
    gl_FragColor = vec4(vColour, opacity);
  }`;function Jd({opacity:n=1,gloss:t=.16,veil:e=!1}={}){let i=new fi({vertexShader:e?iI:nI,fragmentShader:e?sI:Iv,transparent:n<1,uniforms:{colours:{value:[0,1,2,3].map(()=>new ee)},opacity:{value:n},gloss:{value:t},sky:{value:new ee(.46,.46,.47)},ground:{value:new ee(.2,.2,.21)}}});return i.repaint=(s,r,o,a,c=o)=>{[s,r,o,c].forEach((l,u)=>i.uniforms.colours.value[u].set(l)),i.uniforms.sky.value.setScalar(a?.36:.47),i.uniforms.ground.value.setScalar(a?.1:.2)},i}function Lv(){let n=new fi({vertexShader:`
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
      }`,side:oi,transparent:!0,depthWrite:!1,uniforms:{colours:{value:[new ee,new ee]}}});return n.repaint=(...t)=>t.forEach((e,i)=>n.uniforms.colours.value[i].set(e)),n}function Dv(n){let t=new fi({vertexShader:`
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
      }`,fragmentShader:Iv.replace("vec3 n = normalize(vNormal),","vec3 n = normalize(gl_FrontFacing ? vNormal : -vNormal),"),side:n?sr:pi,uniforms:{colour:{value:new ee},opacity:{value:1},gloss:{value:.14},sky:{value:new ee},ground:{value:new ee}}});return t.colour=t.uniforms.colour.value,t.see=(e,i)=>{t.uniforms.opacity.value=e,t.transparent=e<1,t.uniforms.sky.value.setScalar(i?.4:.47),t.uniforms.ground.value.setScalar(i?.13:.2)},t}function Tg(n,t=!1){let e=n[0].index!==null,i=new Set(Object.keys(n[0].attributes)),s=new Set(Object.keys(n[0].morphAttributes)),r={},o={},a=n[0].morphTargetsRelative,c=new be;c.morphTargetsRelative=a;let l=0;for(let u=0;u<n.length;++u){let h=n[u],d=0,f=0;if(e!==(h.index!==null))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". All geometries must have compatible attributes; make sure index attribute exists among all geometries, or in none of them."),null;for(let p in h.attributes){if(!i.has(p))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+'. All geometries must have compatible attributes; make sure "'+p+'" attribute exists among all geometries, or in none of them.'),null;r[p]===void 0&&(r[p]=[]),r[p].push(h.attributes[p]),d++}if(d!==i.size)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". Make sure all geometries have the same number of attributes."),null;if(a!==h.morphTargetsRelative)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". .morphTargetsRelative must be consistent throughout all geometries."),null;for(let p in h.morphAttributes){if(!s.has(p))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+".  .morphAttributes must be consistent throughout all geometries."),null;if(h.morphAttributes[p].length!==n[0].morphAttributes[p].length)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+'. All geometries must have the same number of morph targets for the "'+p+'" morph attribute.'),null;o[p]===void 0&&(o[p]=[]),o[p].push(h.morphAttributes[p]),f++}if(f!==s.size)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". Make sure all geometries have the same number of morph attributes."),null;if(t){let p;if(e)p=h.index.count;else if(h.attributes.position!==void 0)p=h.attributes.position.count;else return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". The geometry must have either an index or a position attribute"),null;c.addGroup(l,p,u),l+=p}}if(e){let u=0,h=[];for(let d=0;d<n.length;++d){let f=n[d].index;for(let p=0;p<f.count;++p)h.push(f.getX(p)+u);u+=n[d].attributes.position.count}c.setIndex(h)}for(let u in r){let h=Nv(r[u]);if(!h)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+u+" attribute."),null;c.setAttribute(u,h)}for(let u in o){let h=o[u][0].length;if(h!==0){c.morphAttributes=c.morphAttributes||{},c.morphAttributes[u]=[];for(let d=0;d<h;++d){let f=[];for(let _=0;_<o[u].length;++_)f.push(o[u][_][d]);let p=Nv(f);if(!p)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+u+" morphAttribute."),null;c.morphAttributes[u].push(p)}}}return c}function Nv(n){let t,e,i,s=-1,r=0;for(let l=0;l<n.length;++l){let u=n[l];if(t===void 0&&(t=u.array.constructor),t!==u.array.constructor)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.array must be of consistent array types across matching attributes."),null;if(e===void 0&&(e=u.itemSize),e!==u.itemSize)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.itemSize must be consistent across matching attributes."),null;if(i===void 0&&(i=u.normalized),i!==u.normalized)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.normalized must be consistent across matching attributes."),null;if(s===-1&&(s=u.gpuType),s!==u.gpuType)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.gpuType must be consistent across matching attributes."),null;r+=u.count*e}let o=new t(r),a=new He(o,e,i),c=0;for(let l=0;l<n.length;++l){let u=n[l];if(u.isInterleavedBufferAttribute){let h=c/e;for(let d=0,f=u.count;d<f;d++)for(let p=0;p<e;p++){let _=u.getComponent(d,p);a.setComponent(d+h,p,_)}}else o.set(u.array,c);c+=u.count*e}return s!==void 0&&(a.gpuType=s),a}var rI=Array.from({length:12},(n,t)=>[Math.cos(t*Math.PI/6),Math.sin(t*Math.PI/6)]),oI=[.75,1.5,2.4],Uv=2,Kd=4,rl=M("div",{class:"labels","aria-hidden":"true"}),Xc=new Map,ho=null;function Fv(n,t){let e=Xc.get(n)??[],i=t.map(({text:s,at:r,wish:o},a)=>{let c=e[a]??{el:rl.appendChild(M("span",{class:"label"})),stands:null};return c.text!==s&&(c.text=c.el.textContent=s,c.width=null),Object.assign(c,{at:r,wish:o})});for(let s of e.slice(t.length))s.el.remove();Xc.set(n,i),de()}function Bv(n){n.prepend(rl),qd(aI),et("theme",()=>{for(let t of[...Xc.values()].flat())t.width=null;ho=null}),new ResizeObserver(([t])=>{ho=[t.contentRect.width,t.contentRect.height],de()}).observe(rl)}var Qd=new G;function kv(n){return Qd.set(...n).project(Ie),Qd.z<1?[(Qd.x+1)/2*ho[0],(1-Qd.y)/2*ho[1]]:null}var Ov=(n,t)=>Math.max(0,Math.min(n[2],t[2])-Math.max(n[0],t[0]))*Math.max(0,Math.min(n[3],t[3])-Math.max(n[1],t[1]));function aI(){ho??=[rl.clientWidth,rl.clientHeight],Ie.updateMatrixWorld();let n=[...Xc.values()].flat();for(let i of n)i.point=kv(i.at),i.width===null&&(i.width=i.el.offsetWidth,i.height=i.el.offsetHeight);let t=n.filter(i=>i.point).map(({point:[i,s]})=>[i-Kd,s-Kd,i+Kd,s+Kd]),e=[];for(let i of n){let s=i.point&&lI(i,e,t);if(i.box=s?s.box:null,i.stands=s?s.key:null,i.el.hidden=!s,!s)continue;e.push(s.box.map((o,a)=>o+(a<2?-Uv:Uv)));let r=`translate(${Math.round(s.box[0])}px, ${Math.round(s.box[1])}px)`;r!==i.where&&i.el.style.setProperty("transform",i.where=r)}}function lI({point:n,width:t,height:e,wish:i,stands:s},r,o){let[a,c]=n;if(a<0||c<0||a>ho[0]||c>ho[1])return null;let l=i&&kv(i),u=l&&Math.hypot(l[0]-a,l[1]-c)||1,h=l?[(l[0]-a)/u,(l[1]-c)/u]:[0,-1],d=null;return oI.forEach((f,p)=>{rI.forEach(([_,m],g)=>{let x=a+_*(f*e+t/2),S=c+m*f*e*1.35,v=[x-t/2,S-e/2,x+t/2,S+e/2],A=t*e-Ov(v,[0,0,...ho]),w=[...r,...o].reduce((U,L)=>U+Ov(v,L),A),y=`${p}.${g}`,E=100*w+2*p+(1-_*h[0]-m*h[1])-(y===s?.8:0);(!d||E<d.cost)&&(d={cost:E,box:v,key:y})})}),d}var Ag=()=>[...Xc.values()].flat().map(({text:n,box:t,point:e})=>({text:n,box:t,point:e}));function zv(n,t){let e=getComputedStyle(rl);n.font=`600 ${parseFloat(e.fontSize)*t}px ${e.fontFamily}`,Object.assign(n,{textAlign:"center",textBaseline:"middle",lineJoin:"round",lineWidth:4*t}),n.strokeStyle=Ft.ground,n.fillStyle=Ft.ink;for(let{text:i,box:s}of Ag()){if(!s)continue;let r=[(s[0]+s[2])/2*t,(s[1]+s[3])/2*t];n.strokeText(i,...r),n.fillText(i,...r)}}var Ur=kd.axes;function Rg(n,t){let e=new Ri(.028,.028,.82,8).translate(0,.41,0),i=new ko(.085,.22,12).translate(0,.9,0),s=Tg([e,i]).applyMatrix4(t),r=new ee(n),o=new Float32Array(s.attributes.position.count*3);for(let a=0;a<o.length;a+=3)o.set([r.r,r.g,r.b],a);return s.setAttribute("color",new He(o,3)),s}var Cg=n=>new _e().makeRotationFromQuaternion(new fn().setFromUnitVectors(new G(0,1,0),new G(...n))),uI=Tg([Rg(Ur[0],Cg([1,0,0])),Rg(Ur[1],Cg([0,1,0])),Rg(Ur[2],Cg([0,0,1]))]),ol=class{constructor(){this.group=new Rn,this.mesh=new yc(uI,new Vn({vertexColors:!0,fog:!1}),64),this.mesh.frustumCulled=!1,this.mesh.count=0,this.group.add(this.mesh)}show(t,e,i=[]){this.last=[t,e];let s=new _e;this.mesh.count=t.length,t.forEach(({T:o},a)=>this.mesh.setMatrixAt(a,s.set(...o).scale(new G(e,e,e))));let r=(o,a)=>o[a+3]-e*.4*(o[a]+o[a+1]+o[a+2]);Fv(this,[...t.map(({T:o,name:a})=>({text:a,at:[o[3],o[7],o[11]],wish:[0,4,8].map(c=>r(o,c))})),...i]),this.mesh.instanceMatrix.needsUpdate=!0,this.mesh.visible=t.length>0}};var Ig=180/Math.PI,Wi={angle:"deg",length:"mm"},hI={deg:"\xB0",rad:"rad",mm:"mm",m:"m"},Pg={deg:Ig,rad:1,mm:1e3,m:1},dI={deg:2,rad:4,mm:2,m:5},fI={deg:1,rad:.02,mm:5,m:.005},mt={get angle(){return Wi.angle},get length(){return Wi.length},set(n,t){t in Pg&&n in Wi&&(Wi[n]=t)},factor:n=>n in Wi?Pg[Wi[n]]:1,symbol:n=>n in Wi?hI[Wi[n]]:"",digits:n=>n in Wi?dI[Wi[n]]:4,step:n=>n in Wi?fI[Wi[n]]/Pg[Wi[n]]:.01,suffix:n=>n==="angle"?{deg:Ig,"\xB0":Ig,rad:1}:n==="length"?{mm:1e3,m:1,cm:100}:{}};function ii(n,t){if(!Number.isFinite(n))return n===1/0?"\u221E":n===-1/0?"\u2212\u221E":"\u2013";let e=n.toFixed(t);return Number(e)===0?e.replace("-",""):e.replace("-","\u2212")}var mn=(n,t,e=mt.digits(t))=>ii(n*mt.factor(t),e),ce=(n,t,e)=>`${mn(n,t,e)}${t==="angle"&&Wi.angle==="deg"?"":" "}${mt.symbol(t)}`,Yc=(n,t="plain")=>String(Number((n*mt.factor(t)).toPrecision(9))+0),tf=n=>n===0?"0":n.toExponential(0).replace("-","\u2212");function al(n,t){let e=n.map(s=>/^[-+−]?\d*[.,](\d+)$/.exec(s.trim())?.[1].length??0);return .5*10**-(Math.max(0,...e)||mt.digits(t))/mt.factor(t)}var ll=n=>n===0?"0":Math.abs(n)>=.001&&Math.abs(n)<1e4?ii(n,4):n.toExponential(2).replace("-","\u2212");var pI={standard:["theta","d","a","alpha"],modified:["alpha","a","theta","d"]},mI={theta:(n,t,e)=>`turn by \u03B8${n} = ${ce(t,"angle")} about z${e}`,d:(n,t,e)=>`go d${n} = ${ce(t,"length")} along z${e}`,a:(n,t)=>`go a${n} = ${ce(t,"length")} along x`,alpha:(n,t)=>`turn by \u03B1${n} = ${ce(t,"angle")} about x`};function Hv(n,t,e){let i=Math.floor(e/4),s=e%4+1,r=pI[n.convention],o=yr(n.joints[i],vr(n,t)[i]),a=Object.fromEntries(r.map((c,l)=>[c,l<s?o[c]:0]));return{i,key:r[s-1],value:o[r[s-1]],A:Yx(n.convention,a.a,a.alpha,a.d,a.theta)}}function Gv(){let n=M("p",{class:"step-said",role:"status","data-testid":"dh-step-said"}),t=(o,a,c)=>Ut(o,{"aria-label":a},()=>i(c())),e=()=>4*b.table.joints.length-1,i=o=>{b.dhStep=o===null||o<0?null:Math.min(o,e()),r(),ut("frames")},s=M("details",{class:"fold","data-testid":"dh-steps"},M("summary",{text:"The frames, one step at a time"}),M("div",{class:"line"},t("First","To the base",()=>0),t("Back","One step back",()=>(b.dhStep??1)-1),t("On","One step on",()=>(b.dhStep??-1)+1),t("Last","To the end",e),n));s.addEventListener("toggle",()=>i(s.open?0:null));let r=()=>{if(b.dhStep===null||!b.table.joints.length){b.dhStep=null,bt(n,"");return}b.dhStep=Math.min(b.dhStep,e());let{i:o,key:a,value:c}=Hv(b.table,b.q,b.dhStep),l=b.table.convention==="standard"?o:o+1;bt(n,`Joint ${o+1}, ${b.dhStep%4+1} of 4: ${mI[a](o+1,c,l)}`)};return et(["q","table","units"],()=>b.dhStep!==null&&r()),et("panel",o=>{o!=="table"&&b.dhStep!==null&&(s.open=!1,i(null))}),s}function ef(){let{i:n,A:t}=Hv(b.table,b.q,b.dhStep);return[...b.frames.slice(0,n+1).map((i,s)=>({T:i,name:s===0?"base":String(s)})),{T:Hn(b.frames[n],t),name:`\u2192 ${n+1}`}]}var Lg=(n,t,e)=>[n[0],t[0],e[0],0,n[1],t[1],e[1],0,n[2],t[2],e[2],0,0,0,0,1],cl=n=>[Math.cos(n),Math.sin(n)];function gI([n,t,e]){let[i,s]=cl(e),[r,o]=cl(t),[a,c]=cl(n);return Lg([i*r,s*r,-o],[i*o*c-s*a,s*o*c+i*a,r*c],[i*o*a+s*c,s*o*a-i*c,r*a])}function xI(n){let t=Math.hypot(n[0],n[4]),e=Math.atan2(-n[8],t);return t>1e-9?[Math.atan2(n[9],n[10]),e,Math.atan2(n[4],n[0])]:[Math.atan2(-n[6],n[5]),e,0]}function _I([n,t,e]){let[i,s]=cl(n),[r,o]=cl(t),[a,c]=cl(e);return Lg([i*r*a-s*c,s*r*a+i*c,-o*a],[-i*r*c-s*a,-s*r*c+i*a,o*c],[i*o,s*o,r])}function yI(n){let t=Math.hypot(n[2],n[6]);return t<1e-9?n[10]>0?[0,0,Math.atan2(n[4],n[0])]:[0,Math.PI,Math.atan2(n[4],-n[0])||0]:[Math.atan2(n[6],n[2]),Math.atan2(t,n[10]),Math.atan2(n[9],-n[8])]}function nf(n){let t=[n[0]+n[5]+n[10],n[0]-n[5]-n[10],n[5]-n[0]-n[10],n[10]-n[0]-n[5]],e=t.indexOf(Math.max(...t)),i=2*Math.sqrt(Math.max(t[e]+1,0)),s=n[9]-n[6],r=n[2]-n[8],o=n[4]-n[1],a=n[1]+n[4],c=n[2]+n[8],l=n[6]+n[9],h=[[i/4,s/i,r/i,o/i],[s/i,i/4,a/i,c/i],[r/i,a/i,i/4,l/i],[o/i,c/i,l/i,i/4]][e],d=h[0]<0?-1:1;return h.map(f=>d*f+0)}function jc(n){let t=Math.hypot(...n);if(t<1e-9)return null;let[e,i,s,r]=n.map(o=>o/t);return Lg([1-2*(s*s+r*r),2*(i*s+e*r),2*(i*r-e*s)],[2*(i*s-e*r),1-2*(i*i+r*r),2*(s*r+e*i)],[2*(i*r+e*s),2*(s*r-e*i),1-2*(i*i+s*s)])}function vI(n){let[t,e,i,s]=nf(n),r=Math.hypot(e,i,s);return r<1e-9?[0,0,1,0]:[e/r,i/r,s/r,2*Math.atan2(r,t)]}function bI([n,t,e,i]){let s=Math.hypot(n,t,e),r=Math.sin(i/2);return s<1e-9?null:jc([Math.cos(i/2),r*n/s,r*t/s,r*e/s])}var Ns={rpy:{title:"Roll, pitch, yaw",order:"R = Rz(yaw) Ry(pitch) Rx(roll)",names:["roll","pitch","yaw"],kinds:["angle","angle","angle"],to:xI,from:gI},zyz:{title:"ZYZ Euler angles",order:"R = Rz(\u03C6) Ry(\u03B8) Rz(\u03C8)",names:["\u03C6","\u03B8","\u03C8"],kinds:["angle","angle","angle"],to:yI,from:_I},axis:{title:"Axis and angle",order:"unit axis x y z, then the turn about it",names:["x","y","z","angle"],kinds:["plain","plain","plain","angle"],to:vI,from:bI},quaternion:{title:"Quaternion",order:"order w x y z, scalar first, w \u2265 0",names:["w","x","y","z"],kinds:["plain","plain","plain","plain"],to:nf,from:jc}};function Vv(n,t,e){let i=Ns[n].from(t);return i?(i[3]=e[0],i[7]=e[1],i[11]=e[2],i):null}function sf(n,t,e){let i=nf(n),s=nf(t),r=i.reduce((h,d,f)=>h+d*s[f],0);r<0&&(s=s.map(h=>-h),r=-r);let o=Math.acos(Math.min(r,1)),a=Math.sin(o),[c,l]=a<1e-7?[1-e,e]:[Math.sin((1-e)*o)/a,Math.sin(e*o)/a],u=jc(i.map((h,d)=>c*h+l*s[d]));return[3,7,11].forEach(h=>{u[h]=n[h]+e*(t[h]-n[h])}),u}var ul=.145,af=.105,zg=.165,Wv={mouse:13,pen:16,touch:28},MI=.2,mo=["x","y","z"],Jc=72,qo=new Rn,of=new Map,Og="both",lf="local",Hg=0,Or=!1,Fg=null,en=null,cf=()=>en!==null,jv=()=>Or,fo=null,po=null;function Zv(){qo.visible=!1,tn.add(qo),qd(Gg),po=document.getElementById("view"),fo=M("output",{class:"gizmo-readout","data-testid":"gizmo-readout",hidden:!0}),document.getElementById("overlay").append(fo),po.addEventListener("pointerdown",CI,!0),po.addEventListener("pointermove",II,!0);for(let n of["pointerup","pointercancel"])po.addEventListener(n,sb,!0);addEventListener("keydown",n=>n.key==="Escape"&&en&&DI()),et(["target","theme"],de)}function Zc(n,t,e=8){let i=new Vn({color:t,depthTest:!1,depthWrite:!1,transparent:!0,opacity:.95,fog:!1}),s=new Ge(n,i);return s.renderOrder=e,s.frustumCulled=!1,s.userData.colour=t,s}var SI=[new fn().setFromUnitVectors(new G(0,1,0),new G(1,0,0)),new fn,new fn().setFromUnitVectors(new G(0,1,0),new G(0,0,1))],wI=[new fn().setFromUnitVectors(new G(0,0,1),new G(1,0,0)),new fn().setFromUnitVectors(new G(0,0,1),new G(0,1,0)),new fn];function EI(){if(of.size)return;let n=(t,e)=>{of.set(t,e),qo.add(e)};mo.forEach((t,e)=>{let i=new Ri(.0032,.0032,ul*.8,8).translate(0,ul*.45,0),s=new ko(.0125,.034,14).translate(0,ul*.9,0),r=new Rn;r.add(Zc(i,Ur[e]),Zc(s,Ur[e])),r.userData.turn=SI[e],n(`move-${t}`,r);let o=Zc(new $a(af,.0026,6,Jc),Ur[e],7);o.userData.turn=wI[e],n(`turn-${t}`,o)}),n("turn-view",Zc(new $a(zg,.0022,6,Jc),"#8891a0",7)),n("move-view",Zc(new Ps(.0115,14,10),"#8891a0",9))}var rf=new G,go=new G,Dg=new fn;function uf(){return 2*Math.tan(uo.degToRad(Ie.fov/2))*Ie.position.distanceTo(rf)}var Qc=()=>lf==="world"?[0,1,2].map(n=>[0,1,2].map(t=>+(n===t))):TI(),TI=()=>[0,1,2].map(n=>js(b.target,n)),AI=new _e;function Gg(){if(qo.visible=Or,!Or)return;rf.set(...te(b.target)),go.copy(Ie.position).sub(rf).normalize(),lf==="world"?Dg.identity():Dg.setFromRotationMatrix(AI.set(...b.target)),qo.position.copy(rf),qo.scale.setScalar(uf());let n=Qc();for(let[t,e]of of){let[i,s]=t.split("-"),r=mo.indexOf(s),o=Og==="both"||Og===i;e.visible=o&&RI(i,n[r])&&(!en||en.name===t),s==="view"?e.quaternion.copy(Ie.quaternion):e.quaternion.copy(Dg).multiply(e.userData.turn);let a=t===(en?.name??Fg);e.traverse(c=>c.material?.color.set(a?Ft.accent:c.userData.colour))}}function RI(n,t){return!t||n!=="move"?!0:Math.hypot(...Jv(t,go.toArray()))>MI}var Jv=(n,t)=>[n[1]*t[2]-n[2]*t[1],n[2]*t[0]-n[0]*t[2],n[0]*t[1]-n[1]*t[0]],Kc=(n,t)=>te(b.target).map((e,i)=>e+t*n[i]);function Bg(n,t){let e=Qc(),[i,s]=n<0?[$v(Ie.matrixWorld,0),$v(Ie.matrixWorld,1)]:[e[(n+1)%3],e[(n+2)%3]];return Array.from({length:Jc+1},(r,o)=>{let a=2*Math.PI*o/Jc,c=i.map((l,u)=>Math.cos(a)*l+Math.sin(a)*s[u]);return{p:Kc(c,t),front:n<0||c.reduce((l,u,h)=>l+u*go.getComponent(h),0)>-.15}})}var $v=(n,t)=>[n.elements[4*t],n.elements[4*t+1],n.elements[4*t+2]];function qv(n,t,[e,i],[s,r]){let o=s-e,a=r-i,c=o*o+a*a,l=c>0?Math.min(Math.max(((n-e)*o+(t-i)*a)/c,0),1):0;return Math.hypot(n-e-l*o,t-i-l*a)}function kg(n,t){let e=uf(),i=[];for(let[s,r]of of){if(!r.visible)continue;let[o,a]=s.split("-"),c=mo.indexOf(a),l=1/0;if(o==="move"&&c<0){let[u,h]=Vi(te(b.target));l=Math.hypot(n-u,t-h)-3}else if(o==="move"){let u=Qc()[c],h=Vi(Kc(u,.92*ul*e));l=Math.min(qv(n,t,Vi(Kc(u,.3*ul*e)),h),Math.hypot(n-h[0],t-h[1])-4)}else{let u=Bg(c,(c<0?zg:af)*e).map(h=>({...h,s:Vi(h.p)}));for(let h=0;h<Jc;h++)u[h].front&&(l=Math.min(l,qv(n,t,u[h].s,u[h+1].s)+(c<0?2:0)))}i.push([s,l])}return i.sort((s,r)=>s[1]-r[1])}function Kv(n){if(!Or)return null;Gg();let[t]=kg(n.clientX,n.clientY);return t&&t[1]<=(Wv[n.pointerType]??Wv.mouse)?t[0]:null}function Qv(){if(!Or)return{};Gg();let n=uf(),t=Qc(),e={"move-view":Vi(te(b.target))};return mo.forEach((i,s)=>{let o=[.92,.85,.75,.6,.5].map(l=>Vi(Kc(t[s],l*ul*n))).find(([l,u])=>kg(l,u)[0]?.[0]===`move-${i}`);o&&(e[`move-${i}`]=o);let c=Bg(s,af*n).filter(l=>l.front).map(l=>Vi(l.p)).filter(([l,u])=>kg(l,u)[0]?.[0]===`turn-${i}`);c.length&&(e[`turn-${i}`]=c[Math.floor(c.length/2)])}),e["turn-view"]=Vi(Bg(-1,zg*n)[9].p),e}var Xv=new Cc,Yv=new Qt;function tb(n){let t=is.domElement.getBoundingClientRect();return Yv.set((n.clientX-t.x)/t.width*2-1,1-(n.clientY-t.y)/t.height*2),Xv.setFromCamera(Yv,Ie),Xv.ray}function eb(n,t,e){let{origin:i,direction:s}=tb(e),r=new G(...n),o=new G(...t).sub(i),a=r.dot(s),c=1-a*a;return c<1e-6?0:(a*s.dot(o)-r.dot(o))/c}function nb(n,t,e){let i=new ri().setFromNormalAndCoplanarPoint(n,new G(...t));return tb(e).intersectPlane(i,new G)}function CI(n){if(n.button!==0)return;let t=Kv(n);if(!t)return;n.stopPropagation(),n.preventDefault(),po.focus({preventScroll:!0}),po.setPointerCapture(n.pointerId),pn.enabled=!1;let[e,i]=t.split("-"),s=mo.indexOf(i),r=s<0?go.toArray():Qc()[s].slice();en={name:t,what:e,axis:r,i:s,T:b.target.slice(),x:n.clientX,y:n.clientY,total:0,before:null},en.start=e==="turn"?ib(n):s<0?nb(go,te(en.T),n):eb(r,te(en.T),n),de()}function ib(n){let[t,e]=Vi(te(en.T)),i=en.axis.reduce((h,d,f)=>h+d*go.getComponent(f),0);if(Math.abs(i)>.3)return-Math.sign(i)*Math.atan2(n.clientY-e,n.clientX-t);let s=Jv(en.axis,go.toArray()),r=uf(),o=Vi(te(en.T)),a=Vi(Kc(s,af*r)),c=a[0]-o[0],l=a[1]-o[1],u=Math.hypot(c,l)||1;return((n.clientX-en.x)*c+(n.clientY-en.y)*l)/(u*u)}var PI=n=>Math.atan2(Math.sin(n),Math.cos(n)),Ng=(n,t,e)=>{let i=Hg||(t.shiftKey?5:0);return i?Math.round(n/(i*e))*i*e:n};function II(n){if(!en){if(n.buttons||!Or)return;let c=Kv(n);c!==Fg&&(Fg=c,po.style.setProperty("cursor",c?"grab":""),de());return}n.stopPropagation();let{T:t,axis:e,what:i,i:s}=en,r=lf==="world"||s<0?"":"tool ",o=t.slice(),a;if(i==="turn"){let c=ib(n);en.total+=PI(c-(en.before??en.start)),en.before=c;let l=Ng(en.total,n,Math.PI/180),u=Math.sin(l/2);o=Hn(jc([Math.cos(l/2),u*e[0],u*e[1],u*e[2]]),t);for(let h of[3,7,11])o[h]=t[h];a=`${Ug(l,"angle")} about ${s<0?"the line of sight":r+mo[s]}`}else if(s<0){let c=nb(go,te(t),n);if(!c)return;let l=c.sub(en.start);(Hg||n.shiftKey)&&l.set(...l.toArray().map(u=>Ng(u,n,.001))),[3,7,11].forEach((u,h)=>{o[u]=t[u]+l.getComponent(h)}),a=l.toArray().map((u,h)=>`${mo[h]} ${Ug(u,"length")}`).join(", ")}else{let c=Ng(eb(e,te(t),n)-en.start,n,.001);[3,7,11].forEach((l,u)=>{o[l]=t[l]+c*e[u]}),a=`${Ug(c,"length")} along ${r}${mo[s]}`}Si(o,"drag"),LI(a,n),de()}var Ug=(n,t)=>`${n>=0?"+":""}${ce(n,t,mt.digits(t))}`;function LI(n,t){let e=po.getBoundingClientRect();fo.hidden=!1,bt(fo,n),fo.style.setProperty("left",`${Math.min(t.clientX-e.x+18,e.width-fo.offsetWidth-8)}px`),fo.style.setProperty("top",`${Math.max(t.clientY-e.y-34,8)}px`)}function sb(n){en&&(n.stopPropagation(),en=null,fo.hidden=!0,pn.enabled=!0,Si(b.target,"dropped"),de())}function DI(){let{T:n}=en;Si(n,"drag"),sb({stopPropagation(){}})}function rb(){Or&&EI(),qo.visible=Or,ut("frames"),de()}function ob(n){Or=n,rb()}function ab(n){Og=n,rb()}function lb(n){lf=n,de()}function cb(n){Hg=n}var pb=Jd(),hb=[.32,-.4,1],ff=new Vn({color:"#000",transparent:!0,opacity:.1,side:pi,depthWrite:!1,fog:!1,stencilWrite:!0,stencilFunc:Fm,stencilRef:1,stencilZPass:Om,polygonOffset:!0,polygonOffsetFactor:-1,polygonOffsetUnits:-1}),qg=new _e().set(1,0,-hb[0],0,0,1,-hb[1],0,0,0,0,5e-4,0,0,0,1),hl=new Ge(new Sc(1,40),new fi({transparent:!0,depthWrite:!1,polygonOffset:!0,polygonOffsetFactor:-1,polygonOffsetUnits:-1,uniforms:{strength:{value:.3}},vertexShader:"varying vec2 at; void main() { at = position.xy; gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }",fragmentShader:"uniform float strength; varying vec2 at; void main() { float d = 1.0 - length(at); gl_FragColor = vec4(0.0, 0.0, 0.0, strength * d * d); }"}));hl.renderOrder=-1;function NI(){let n=b.frames[0],t=2*(Us.radius[0]??0);hl.visible=b.table.joints.length>0&&Math.abs(n[11])<.02*Us.size&&n[10]>.99,hl.position.set(n[3],n[7],4e-4*Us.size),hl.scale.set(1.6*t,1.6*t,1)}var iu=new sl(pb,{shadow:{material:ff,matrix:qg}});function mb(n,t){iu.shown(n,n&&!t)}var Wg=.1,Xg=Jd({opacity:Wg,veil:!0}),gb=Lv(),eu=new sl(Xg,{veil:!0,rim:gb}),xb=Jd({opacity:.62,gloss:.1}),$g=new sl(xb,{veil:!0}),Yg=new ol,Us=Yd(b.table),pf=[],df=null;function _b(){tn.add(hl,iu.group,eu.group,$g.group,Yg.group),eu.group.renderOrder=1,et("table",n=>{Us=Yd(b.table),_g(Us.size),pf=[],df=null,jg(),gf(),n==="new"&&su({instant:!0,view:"iso"}),vv()}),et("q",OI),et("frames",bb),et("theme",fb),et("hurry",n=>{Xg.uniforms.opacity.value=n?2*Wg:Wg;for(let t of[iu,eu,$g])t.hurry(n)}),fb()}var db=new Map,nu=[],Vg=0;function Br(n,t){if(db.set(n,t),nu=[...db.values()].flat(),!b.table.joints.length)return;let e=Vg;Vg=nu.length,gg([...$c(b.table,b.frames),...nu]),t.length?vb():e>Vg&&UI()}var UI=Ks(Ev,120);function yb(n,t){let e=Math.max(1,Math.floor(t.length/24)),i=t.filter((s,r)=>r%e===0||r===t.length-1);Br("motion",i.flatMap(s=>$c(n,ws(n,s))))}function su(n){Xd([...$c(b.table,b.frames),...nu],n)}var vb=Ks(nl,220);function OI(){let n=b.frames;iu.show(b.table.joints.length?[vg(b.table,n,Us,b.q)]:[]),NI(),gg([...$c(b.table,n),...nu]),vb(),Rb&&BI(te(n[n.length-1])),bb()}function bb(){let n=(b.shownFrames??[]).filter(t=>t<b.frames.length&&!(t===b.frames.length-1&&jv())).map(t=>({T:b.frames[t],name:mf(t)}));Yg.show(b.dhStep===null?n:ef(),Us.size*bg),de()}var Mb=()=>iu.arms.flatMap(n=>[...n.drums,...n.sleeves].filter(t=>t.beyond).map(t=>t.joint+1)),Sb=()=>(Yg.last?.[0]??[]).map(n=>n.name);function mf(n){let t=b.table.joints.length;return n===0?"base":n===t+1?"tool":String(n)}function wb(n){pf=n,jg()}function ps(n){df=n,jg()}var Eb=()=>pf.length,Tb=()=>eu.arms.filter(n=>n.outside).length,FI=.0035;function jg(){let n=t=>({...vg(b.table,ws(b.table,t),Us),outside:b.table.joints.some((e,i)=>Wc(e,t[i])),rim:FI*Us.size});eu.show(pf.map(n)),$g.show(df?[n(df)]:[]),de()}var Ab=6e3,hf=new Float32Array(6*Ab),Fr=new Fo(new be,new ts({fog:!1}));Fr.geometry.setAttribute("position",new He(hf,3));Fr.frustumCulled=!1;Fr.visible=!1;var xo=0,Rb=!0,tu=null;tn.add(Fr);function BI(n){let t=tu?Ui(Ni(n,tu)):1/0;t<Us.size*.002||(t<Us.size*.2&&(xo===Ab&&(hf.copyWithin(0,6*1e3),xo-=1e3),hf.set(tu,6*xo),hf.set(n,6*xo+3),xo+=1,Fr.geometry.setDrawRange(0,2*xo),Fr.geometry.attributes.position.needsUpdate=!0,Fr.visible=!0),tu=n)}function Cb(n){Rb=n,n||gf(),de()}function gf(){xo=0,tu=null,Fr.visible=!1,de()}var Pb=()=>xo,ru=new nr(new be,new ts({fog:!1}));ru.frustumCulled=!1;var ou=new Pr(new be,new ir({size:4,sizeAttenuation:!1,fog:!1}));ou.frustumCulled=!1;ru.visible=ou.visible=!1;tn.add(ru,ou);function Xo(n){Br("path",n);let t=new Float32Array(n.flat());for(let e of[ru,ou])e.geometry.dispose(),e.geometry=new be,e.geometry.setAttribute("position",new He(t,3)),e.visible=n.length>0;de()}function fb(){pb.repaint(Ft.link,Ft.joint,Ft.accent,Ft.dark,Ft.wrong),Xg.repaint(Ft.ghost,Ft.ghost,Ft.ghost,Ft.dark,Ft.wrong),gb.repaint(Ft.ghost,Ft.wrong),xb.repaint(Ft.accent,Ft.accent,Ft.accent,Ft.dark),Fr.material.color.set(Ft.accent),ru.material.color.set(Ft.trace),ou.material.color.set(Ft.trace),ff.opacity=Ft.dark?.28:.11,hl.material.uniforms.strength.value=Ft.dark?.75:.34,de()}var fe={follow:!0,ghosts:"all",task:null,redundancy:null},Zg={answers:0},xf=!1,Ib=Zs(async()=>{let n=xf;xf=!1;let t=b.target,e=b.table;try{let i=cf()||Jg,s=i?null:b.digits,{task:r,redundancy:o}=fe,a=await Oe("ik",{T:t,q:b.q,brief:i,task:r,redundancy:o,digits:s});if(e!==b.table||t!==b.target&&!i)return;Zg.answers+=1,b.solutions={...a,T:t,brief:i},n&&fe.follow&&a.nearest&&Oi(a.nearest,"follow"),dl(),ut("solutions"),!i&&!a.rows.some(c=>c.inside)&&HI(t),a.self_motions===null&&!i&&zI(b.solutions)}catch(i){if(i instanceof Bu)return;b.solutions={rows:[],self_motions:[],status:"REFUSED",why:i.message,nearest:null},dl(),ut("solutions")}}),Jg=!1;function Lb(){Jg=!0,xf=!0,Ib()}function Os({follow:n=!1}={}){Jg=!1,xf||=n,Ib()}var zI=Zs(async n=>{try{let t={T:n.T,q:b.q,task:fe.task,redundancy:fe.redundancy},{self_motions:e}=await Oe("self_motions",t);if(b.solutions!==n||!e)return;n.self_motions=e,ut("solutions")}catch{}}),HI=Zs(async n=>{try{let t=await Oe("nearest",{T:n,task:fe.task});b.solutions&&b.solutions.T===n&&(b.solutions.near=t,ut("solutions"))}catch{}}),GI=(n,t)=>n.every((e,i)=>Math.abs(Math.atan2(Math.sin(e-t[i]),Math.cos(e-t[i])))<1e-6||Math.abs(e-t[i])<1e-9);function dl(){let n=b.solutions?.rows??[],t=b.panel==="inverse"&&fe.ghosts!=="none"?n.filter(e=>(fe.ghosts==="all"||e.inside)&&!GI(e.q,b.q)):[];wb(t.map(e=>e.q))}function Db(){et("target",n=>{b.panel==="inverse"&&Os({follow:Qx.has(n)})}),et("task",()=>{ut("plan"),b.panel==="inverse"&&b.hasTarget&&Os()}),et("panel",n=>{ps(null),n==="inverse"&&b.hasTarget&&!b.solutions&&Os(),dl()}),et("moving",n=>{n||dl()}),et("table",n=>{fe.redundancy=null,n==="new"&&(fe.task=null),ut("solutions"),n!=="new"&&b.panel==="inverse"&&b.hasTarget&&Os()}),et("online",n=>{n&&b.panel==="inverse"&&b.hasTarget&&b.table.joints.length&&Os()})}var au=0;function gi(){au+=1,b.moving&&(b.moving=!1,ut("moving",!1))}function Pi(n,t=.8,e="move to a posture"){gi(),ut("let-go"),ut("did",{label:e});let i=b.q.slice(),s=au,r=performance.now();return matchMedia("(prefers-reduced-motion: reduce)").matches&&(t=0),b.moving=!0,ut("moving",!0),new Promise(o=>{(function a(c){if(s!==au||i.length!==b.q.length){o(!1);return}let l=t>0?Math.min(Math.max((c-r)/(1e3*t),0),1):1,u=l**3*(10-15*l+6*l*l);Oi(l<1?i.map((h,d)=>h+u*(n[d]-h)):n.slice(),"move"),l<1?requestAnimationFrame(a):(b.moving=!1,ut("moving",!1),o(!0))})(r)})}function Nb(n,t,e,i){gi();let s=au,r=performance.now()-1e3*n*t;b.moving=!0,ut("moving",!0),requestAnimationFrame(function o(a){if(s!==au){i?.(!1);return}let c=Math.min(Math.max((a-r)/(1e3*n),0),1);e(c),c<1?requestAnimationFrame(o):(b.moving=!1,ut("moving",!1),i?.(!0))})}var WI=200,$I=1500,Yo=[],uu=[],cu=null,lu={key:null,at:0,open:!1},Kg=!1,_f=()=>({table:b.table,q:b.q,target:b.target,digits:b.digits,hasTarget:b.hasTarget,path:{...b.path},sequence:structuredClone(b.sequence),program:b.program,world:b.world,limits:b.limits,start:b.start,routing:b.routing,task:fe.task,redundancy:fe.redundancy});function Qg(){Kg||(Kg=!0,queueMicrotask(()=>{Kg=!1,cu=_f()}))}function qI({label:n,key:t=n,open:e=!1}){let i=performance.now();!(t===lu.key&&(lu.open||i-lu.at<$I))&&cu&&(Yo.push({label:n,before:cu}),Yo.length>WI&&Yo.shift(),uu.length=0),lu={key:t,at:i,open:e},Qg(),ut("history")}function t0(){lu={key:null,at:0,open:!1}}function XI(n){gi(),t0(),fe.task=n.task,n.table!==b.table?yn(n.table,{q:n.q,step:!1,what:"undo"}):Oi(n.q,"undo"),fe.redundancy=n.redundancy,Object.assign(b.path,n.path),b.sequence=structuredClone(n.sequence),b.program=n.program,b.world=n.world,b.limits=n.limits,b.start=n.start;let t=b.routing!==n.routing;b.routing=n.routing,b.hasTarget=n.hasTarget,n.target!==b.target&&Si(n.target,"restored",n.digits);for(let e of["path-loaded","sequence-loaded","program","world","task"])ut(e,"undo");t&&ut("routing","undo")}function Ub(n,t,e){let i=n.pop();if(!i)return;let s=_f();XI(i.before),t.push({label:i.label,before:s}),Qg(),ut("history"),we(`${e}: ${i.label}`)}var e0=()=>Ub(Yo,uu,"Undone"),n0=()=>Ub(uu,Yo,"Redone"),yf=()=>Yo.at(-1)?.label??null,vf=()=>uu.at(-1)?.label??null;function bf(){Yo.length=0,uu.length=0,t0(),cu=_f(),ut("history")}function Ob(){cu=_f(),et("did",qI),et("let-go",t0),et(["table","q","target","path","sequence","program","world","task","routing","panel"],Qg)}var kb=1,zb=30;function fl(){let{table:n,q:t,target:e,hasTarget:i,notation:s,shownFrames:r,path:o,sequence:a,panel:c,theme:l}=b;return{pieper:kb,table:n,q:t,target:i?e:null,digits:i?b.digits:null,task:fe.task,redundancy:fe.redundancy,follow:fe.follow,ghosts:fe.ghosts,notation:s,frames:r,path:o,sequence:a,program:{steps:b.program,start:b.start,limits:b.limits},world:b.world,routing:b.routing,look:b.look,panel:c,theme:l,units:[mt.angle,mt.length],camera:il()}}var Xn=n=>typeof n=="number"&&Number.isFinite(n)&&Math.abs(n)<1e7,xs=(n,t)=>Array.isArray(n)&&n.length===t&&n.every(Xn),ms=(n,t)=>typeof n=="string"?n.slice(0,t):"",gs=n=>{if(!xs(n,16))return null;let t=Nu(n);return t<1e-12?n.slice():t<.001?Uu(n):null},jI=n=>n&&Xn(n.metres)&&Xn(n.radians)?{metres:n.metres,radians:n.radians}:null,ZI=n=>n&&[n.lower,n.upper,n.value].every(Xn)&&n.lower<=n.upper?{name:ms(n.name,40),lower:n.lower,upper:n.upper,value:n.value,unit:ms(n.unit,10)}:null,JI=(n,t)=>Array.isArray(n)&&n.length===t&&n.every(e=>xs(e,t))?n:null;function KI(n){if(!n||!Array.isArray(n.joints)||n.joints.length>zb||!["standard","modified"].includes(n.convention))return null;let t=n.joints.map((i,s)=>{if(!i||!["a","alpha","d","theta","offset"].every(o=>Xn(i[o]))||!["R","P"].includes(i.type)||![1,-1].includes(i.sign))return null;let r=Object.fromEntries(Object.entries(i.text??{}).filter(([,o])=>typeof o=="string"&&o.length<80));return{name:ms(i.name,40)||`joint_${s+1}`,type:i.type,a:i.a,alpha:i.alpha,d:i.d,theta:i.theta,lower:Xn(i.lower)?i.lower:null,upper:Xn(i.upper)?i.upper:null,sign:i.sign,offset:i.offset,text:r}});if(t.includes(null))return null;let e=Object.fromEntries(Object.entries(n.postures??{}).filter(([,i])=>xs(i,t.length)).slice(0,40));return{name:ms(n.name,60),convention:n.convention,joints:t,base:gs(n.base)??Zi(),tool:gs(n.tool)??Zi(),postures:e,manufacturer:ms(n.manufacturer,200),source:ms(n.source,2e3),notes:ms(n.notes,3e3),actuator:ZI(n.actuator),catalog:ms(n.catalog,60)||void 0,derived:ms(n.derived,60)||void 0,coupling:JI(n.coupling,t.length)}}var Fb={joint:0,line:0,circle:0,spline:0,frame:0,call:0,wait:"seconds",gripper:"value",output:"port"};function QI(n,t){if(!n||!Object.hasOwn(Fb,n.kind))return null;let e=Fb[n.kind];if(e)return Xn(n[e])?{kind:n.kind,[e]:n[e],...n.kind==="output"?{value:!!n.value}:{}}:null;if(n.kind==="call")return[n.first,n.last,n.times].every(c=>Number.isInteger(c)&&c>=1&&c<=200)?{kind:"call",first:n.first,last:n.last,times:Math.min(n.times,50)}:null;if(n.kind==="frame")return gs(n.T)?{kind:"frame",T:gs(n.T)}:null;let i=n.kind==="joint"&&xs(n.q,t)?n.q.slice():null,s=gs(n.T),r=n.kind==="circle"&&xs(n.centre,3)?n.centre.slice():null;if(!s||n.kind==="circle"&&!r&&!gs(n.via))return null;let o=n.kind==="spline"&&Array.isArray(n.through)?n.through.slice(0,100).map(gs):null;if(n.kind==="spline"&&(!o?.length||o.includes(null)))return null;let a=(c,l)=>l===null?{}:{[c]:l};return{kind:n.kind,...a("q",i),T:s,...a("via",gs(n.via)),...a("through",o),...r?{centre:r,long_way:!!n.long_way}:{},...a("speed",Xn(n.speed)&&n.speed>0?n.speed:null),blend:Xn(n.blend)&&n.blend>=0?n.blend:0}}var i0={frame:[],box:["size"],cylinder:["r","h"]};function t3(n){if(!n||!Object.hasOwn(i0,n.kind))return null;let t=gs(n.T),e=ms(n.name,40),i=s=>s==="size"?xs(n.size,3)&&n.size.every(r=>r>0):Xn(n[s])&&n[s]>0;return!t||!e||!i0[n.kind].every(i)?null:{kind:n.kind,name:e,T:t,role:n.role==="object"?"object":"obstacle",...Object.fromEntries(i0[n.kind].map(s=>[s,n[s]]))}}function e3(n,t){if(!n||typeof n!="object")return null;let e=s=>s&&Xn(s.turn)&&xs(s.q,t)?{turn:s.turn,q:s.q.slice(),branch:ms(s.branch,80)}:null,i=(s,r)=>Xn(s)&&s>=0&&s<r?s:0;return{turn:xs(n.turn,2)?n.turn.slice():null,cone:i(n.cone,Math.PI/2),axis:["x","y","z"].includes(n.axis)?n.axis:"z",cost:n.cost==="time"?"time":"motion",singularity:i(n.singularity,1),clearance:i(n.clearance,1e3),start:e(n.start),end:e(n.end)}}function n3(n,t){let e=(s,r,o)=>Array.isArray(s)?s.slice(0,o).map(r).filter(Boolean):[],i=n.program??{};b.program=e(i.steps,s=>QI(s,t),200),b.start=xs(i.start,t)?i.start.slice():null,b.limits=Object.fromEntries(Object.entries(i.limits??{}).filter(([s,r])=>s.length<30&&(r===null||Xn(r)&&r>0))),b.world=e(n.world,t3,60),b.routing=e3(n.routing,t),["sketch","real","both"].includes(n.look?.mode)&&Xn(n.look.opacity)&&(b.look={mode:n.look.mode,opacity:Math.min(Math.max(n.look.opacity,.1),.9)})}function Mf(n,t){let e=n&&n.pieper===kb?KI(n.table):null;if(!e)throw new Error("This is not a state of the workbench.");let i=e.joints.length;Array.isArray(n.units)&&(mt.set("angle",n.units[0]),mt.set("length",n.units[1])),Object.hasOwn(Ns,n.notation)&&(b.notation=n.notation),["auto","light","dark"].includes(n.theme)&&Hd(n.theme),b.shownFrames=Array.isArray(n.frames)?n.frames.filter(a=>Number.isInteger(a)&&a>=0&&a<i+2):null;let s=n.path??{};yn(e,{q:xs(n.q,i)?n.q:null,step:!1,what:"new"}),Object.assign(b.path,{from:gs(s.from),to:gs(s.to),n:Number.isInteger(s.n)&&s.n>=2&&s.n<=2e3?s.n:50,seconds:Xn(s.seconds)&&s.seconds>0?s.seconds:5}),b.sequence.postures=(Array.isArray(n.sequence?.postures)?n.sequence.postures:[]).filter(a=>a&&xs(a.q,i)&&Xn(a.seconds)&&Xn(a.hold)).slice(0,40).map(a=>({name:ms(a.name,20)||"P",q:a.q.slice(),seconds:a.seconds,hold:a.hold})),n3(n,i),["pose","position","position+axis"].includes(n.task)&&(fe.task=n.task);let r=Object.entries(n.redundancy??{}).filter(([a,c])=>a.length<80&&Xn(c));fe.redundancy=r.length?Object.fromEntries(r.slice(0,zb)):null,typeof n.follow=="boolean"&&(fe.follow=n.follow),["all","inside","none"].includes(n.ghosts)&&(fe.ghosts=n.ghosts);let o=gs(n.target);b.hasTarget=!!o,o&&Si(o,"restored",jI(n.digits));for(let a of["units","notation","sequence-loaded","task","program","world"])ut(a);t(n.panel),ut("path-loaded"),ut("routing","loaded"),ut("look","loaded"),xs(n.camera,6)&&Tv(n.camera),Oi(b.q,"restored"),bf()}async function Hb(n,t){return new Uint8Array(await new Response(new Blob([n]).stream().pipeThrough(new t("deflate-raw"))).arrayBuffer())}async function Sf(){let n=await Hb(new TextEncoder().encode(JSON.stringify(fl())),CompressionStream),t=btoa(String.fromCharCode(...n)).replaceAll("+","-").replaceAll("/","_").replace(/=+$/,"");return`${location.origin}${location.pathname}#s=${t}`}async function Gb(){let n=i3();if(n)return n;let t=/^#s=([\w-]+)$/.exec(location.hash);if(!t)return null;if(t[1].length>6e4)throw new Error("The link is too long.");let e=Uint8Array.from(atob(t[1].replaceAll("-","+").replaceAll("_","/")),s=>s.charCodeAt(0)),i=await Hb(e,DecompressionStream);if(i.length>5e5)throw new Error("The link unfolds to more than it should.");return JSON.parse(new TextDecoder().decode(i))}var Vb="pieper-workbench";function i3(){try{let{address:n,shown:t}=JSON.parse(sessionStorage.getItem(Vb)??"{}");return t&&n===location.href?t:null}catch{return null}}function s3(){if(b.table.joints.length)try{sessionStorage.setItem(Vb,JSON.stringify({address:location.href,shown:fl()}))}catch{}}var Bb=null,r3=Ks(async()=>{if(!b.table.joints.length)return;let n=await Sf();n!==Bb&&(Bb=n,history.replaceState(null,"",n))},600);function Wb(){addEventListener("pagehide",s3),et(["table","q","target","solutions","units","notation","panel","path","sequence","program","world","routing","look","theme","frames"],r3)}var s0={sqrt:Math.sqrt,sin:Math.sin,cos:Math.cos,tan:Math.tan,asin:Math.asin,acos:Math.acos,atan:Math.atan,abs:Math.abs},$b={pi:Math.PI,\u03C0:Math.PI,tau:2*Math.PI},wf=/\s*(?:(\d+\.?\d*(?:[eE][+-]?\d+)?|\.\d+(?:[eE][+-]?\d+)?)|([A-Za-zπ°]+)|(\*\*|[-+*/^()−·]))/y,qb=80;function a3(n){let t=[];wf.lastIndex=0;let e=n.trimEnd();for(;wf.lastIndex<e.length;){let i=wf.lastIndex,s=wf.exec(e);if(!s)throw new Error(`cannot read \u201C${e.slice(i).trim().slice(0,8)}\u201D at character ${i+1}`);s[1]!==void 0?t.push({number:Number(s[1]),text:s[1]}):s[2]!==void 0?t.push({word:s[2]}):t.push({sign:{"\u2212":"-","\xB7":"*","**":"^"}[s[3]]??s[3]})}return t}function l3(n){if(!n.includes(","))return n;if(n.includes(".")||/\d,\d*,/.test(n))throw new Error("a comma is the decimal sign here: leave out the ones between thousands");return n.replace(/(\d),(?=\d)|(\d),(?!\d)|(^|\D),(?=\d)/g,"$1$2$3.")}function Ef(n,t="plain"){let e=l3(String(n));if(e.length>qb)throw new Error(`longer than ${qb} characters`);let i=a3(e);if(!i.length)throw new Error("empty: type a number, or an expression such as pi/2");let s=null,r=i[i.length-1];i.length>1&&r.word&&r.word in mt.suffix(t)&&(s=mt.suffix(t)[r.word],i.pop());let o=0,a=!1,c=g=>i[o]?.sign===g,l=g=>{if(!c(g))throw new Error(`\u201C${g}\u201D is missing`);o++};function u(){let g=h();for(;c("+")||c("-");){let x=i[o++].sign,S=h();g=x==="+"?g+S:g-S}return g}function h(){let g=d();for(;;)if(c("*"))o++,g*=d();else if(c("/"))o++,g/=d();else if(i[o]?.word||c("("))g*=f();else return g}function d(){return c("-")?(o++,-d()):c("+")?(o++,d()):f()}function f(){let g=p();return c("^")?(o++,g**d()):g}function p(){let g=i[o];if(!g)throw new Error("something is missing at the end");if(o++,g.number!==void 0)return g.number;if(g.sign==="("){let x=u();return l(")"),x}if(g.word){let x=g.word.toLowerCase();if(Object.hasOwn($b,x))return a=!0,$b[x];if(Object.hasOwn(s0,x)){l("(");let S=u();return l(")"),s0[x](S)}throw new Error(`\u201C${g.word.slice(0,20)}\u201D is not known; allowed are pi, ${Object.keys(s0).join(", ")}`)}throw new Error(`\u201C${g.sign}\u201D is not expected here`)}let _=u();if(o<i.length)throw new Error(`\u201C${i[o].sign??i[o].word??i[o].text}\u201D is not expected here`);if(!Number.isFinite(_))throw new Error("not a finite number");let m=s??(t==="angle"&&a?1:mt.factor(t));return{value:_/m+0,symbolic:a||s!==null||i.length>2}}function Mn({label:n,kind:t="plain",input:e,commit:i,empty:s,testid:r,title:o,check:a}){let c=typeof t=="function"?t:()=>t,l=M("input",{type:"text",class:"number",inputmode:"decimal",autocomplete:"off",spellcheck:"false","aria-label":n,"data-testid":r,title:o}),u=null,h=null,d=()=>{if(l.value.trim()===""&&s!==void 0)return{value:s,symbolic:!1};let g=Ef(l.value,c()),x=a?.(g.value);if(x)throw new Error(x);return g},f=g=>{l.classList.toggle("wrong",!!g),g?(l.setAttribute("aria-invalid","true"),l.title=g):(l.removeAttribute("aria-invalid"),l.title=o??""),r0(l,g),l.dispatchEvent(new CustomEvent("verdict",{bubbles:!0,detail:g?{label:n,reason:g}:null}))},p=g=>{try{let x=d();return f(null),g?.(x.value,{symbolic:x.symbolic,text:l.value.trim()}),!0}catch(x){return f(x.message),!1}};l.addEventListener("input",()=>p(e)),l.addEventListener("change",()=>{p(i??e)&&l.blurred?.()});let _="",m=()=>{try{d(),_=l.value}catch{}};return l.addEventListener("focus",()=>{m(),l.classList.contains("wrong")&&r0(l,l.title),l.select()}),l.addEventListener("blur",()=>r0(l,null)),l.addEventListener("keydown",g=>{let x=l.closest("table.dh");if(g.key==="Escape"&&l.value!==_){g.preventDefault(),l.value=_,p(i??e),l.select();return}if(x&&c3(l,g))return;let S={ArrowUp:1,ArrowDown:-1}[g.key];if(g.key==="Enter"&&(m(),l.select()),!(!S||x&&!g.altKey)){g.preventDefault();try{let v=d();l.value=Yc((v.value??0)+S*mt.step(c())*(g.shiftKey?.1:1),c()),p(i??e)}catch{}}}),l.put=(g,x=null)=>{document.activeElement===l&&!l.readOnly||g===u&&x===h&&!l.classList.contains("wrong")||(u=g,h=x,l.value=x??(g==null?"":Yc(g,c())),o0(l),l.classList.contains("wrong")&&f(null))},l.addEventListener("input",()=>o0(l)),l.refresh=()=>{let g=u,x=h;u=NaN,l.put(g,x)},l}function o0(n){if(n.value.length<7&&!n.shrunk)return;let t=n.clientWidth;if(!t){n.waits||requestAnimationFrame(()=>{n.waits=!1,n.clientWidth&&o0(n)}),n.waits=!0;return}if(n.style.removeProperty("font-size"),n.shrunk=!1,n.scrollWidth<=t)return;let e=parseFloat(getComputedStyle(n).fontSize);n.style.setProperty("font-size",`${Math.max(.58*e,e*(t-14)/(n.scrollWidth-14)).toFixed(2)}px`),n.shrunk=!0}var Ii=null;function r0(n,t){if(!t){Ii&&Ii.about===n&&(Ii.hidden=!0),n.removeAttribute("aria-describedby");return}Ii||(Ii=M("div",{class:"why",id:"why",role:"alert","data-testid":"why"}),document.body.append(Ii)),Ii.about=n,Ii.hidden=!1,Ii.textContent!==t&&(Ii.textContent=t),n.setAttribute("aria-describedby","why");let e=n.getBoundingClientRect();Ii.style.setProperty("top",`${e.bottom+4}px`),Ii.style.setProperty("left",`${Math.max(8,Math.min(e.left,innerWidth-Ii.offsetWidth-8))}px`)}addEventListener("scroll",()=>Ii&&(Ii.hidden=!0),!0);function c3(n,t){let e=n.selectionStart===0&&n.selectionEnd===n.value.length,i={ArrowUp:-1,ArrowDown:1,Enter:t.shiftKey?-1:1}[t.key],s={ArrowLeft:e||n.selectionEnd===0?-1:0,ArrowRight:e||n.selectionStart===n.value.length?1:0}[t.key]??0;if(t.altKey||t.ctrlKey||t.metaKey||!i&&!s)return!1;let r=[...n.closest("tbody").rows].map(l=>[...l.querySelectorAll("input.number")]),o=r.findIndex(l=>l.includes(n)),a=r[o].indexOf(n),c=r[o+(i??0)]?.[a+s];return t.key==="Enter"&&n.dispatchEvent(new Event("change")),c?(t.preventDefault(),c.focus(),!0):t.key!=="Enter"}function Tf(n){let t=n.trim().replace(/^\[\s*\[|\]\s*\]$/g,"").split(/\]\s*,?\s*\[|[;\r\n]+/).map(e=>e.replace(/^[\s[(,]+|[\s\]),]+$/g,"")).filter(Boolean).map(e=>{let i=e.split("	");return(i.length>1?i:e.split(/\s*,\s+|\s+|,(?=[^,]*\.)|,(?=[A-Za-z(-])/)).map(s=>s.trim()).filter(Boolean)});return t.length>1||(t[0]?.length??0)>1?t:null}function Af(n,t,e,i){let s=0;return i.forEach((r,o)=>r.forEach((a,c)=>{let l=n[t+o]?.[e+c];l&&(l.value=a,l.dispatchEvent(new Event("input",{bubbles:!0})),l.dispatchEvent(new Event("change",{bubbles:!0})),s+=1)})),s}var Ze=n=>n.type==="R"?"angle":"length";function Xb(n){let t=n.type==="R"?Math.PI:Gn(b.table),e=n.lower??Math.min(-t,(n.upper??t)-2*t),i=n.upper??Math.max(t,e+2*t),s=Math.max((i-e)*.08,.001);return{lo:e,hi:i,min:n.lower===null?e:e-s,max:n.upper===null?i:i+s}}var u3=Wc;function h3(n){let t=b.table.joints[n],e=Ze(t),{lo:i,hi:s,min:r,max:o}=Xb(t),a=`q${n+1}`,c=M("input",{type:"range",min:String(r),max:String(o),step:"any","aria-label":`${a}, ${t.name}`,"data-testid":`slider-${n+1}`}),l=_=>`${100*(_-r)/(o-r)}%`;c.style.setProperty("--lo",l(i)),c.style.setProperty("--hi",l(s)),c.addEventListener("input",()=>{gi(),Fu(n,Number(c.value))}),c.addEventListener("keydown",_=>{let m={ArrowRight:1,ArrowUp:1,ArrowLeft:-1,ArrowDown:-1,PageUp:10,PageDown:-10}[_.key],g={Home:i,End:s}[_.key];if(m===void 0&&g===void 0)return;_.preventDefault(),gi();let x=mt.step(e)*(_.shiftKey?.1:1);Fu(n,g??Math.min(Math.max(Math.round((b.q[n]+m*x)/(x/10))*(x/10),r),o))});let u=Mn({label:`${a} value`,kind:e,testid:`q-${n+1}`,input:_=>{gi(),Fu(n,_)}}),h=M("span",{class:"out",role:"note"}),d=M("span",{class:"chain",title:"What this row of the table moves by"}),f=M("span",{class:"limits"}),p=M("div",{class:"joint","data-testid":`joint-${n+1}`},M("span",{class:"joint-name",title:`${t.name}, ${t.type==="R"?"revolute":"prismatic"}`},M("i",{text:"q"}),M("sub",{text:String(n+1)})),M("div",{class:"track"},c,M("div",{class:"under"},f,d,h)),u,M("span",{class:"unit"}));return{el:p,number:u,show(){let _=b.q[n],m=u3(t,_);(document.activeElement!==c||Number(c.value)!==_)&&(c.value=_),c.style.setProperty("--at",l(Math.min(Math.max(_,r),o))),c.setAttribute("aria-valuetext",ce(_,e)),u.put(Number((_*mt.factor(e)).toFixed(mt.digits(e)+1))/mt.factor(e)),p.classList.toggle("outside",m!==0);let g=b.table.coupling?`chain ${ce(vr(b.table,b.q)[n],e)}`:"";bt(d,g),bt(h,m?`${ce(Math.abs(m),e)} ${m>0?"above":"below"} the limit`:"")},relabel(){bt(p.lastChild,mt.symbol(e));let _=m=>m===null?"no limit":ce(m,e,mt.angle==="deg"&&e==="angle"?0:void 0);bt(f,t.lower===null&&t.upper===null?"no limits":`${_(t.lower)} \u2026 ${_(t.upper)}`),u.refresh(),this.show()}}}var Yb={id:"joints",title:"Joints",build(n){let t=[],e=M("div",{class:"joints","data-testid":"joints"}),i=M("div",{class:"chips",role:"group","aria-label":"Postures"}),s=M("div",{class:"joints gripper"});n.append(e,s,i);let r=()=>{t=b.table.joints.map((o,a)=>h3(a)),Gt(e,t.map(o=>o.el)),t.length||e.append(M("p",{class:"hint",text:"This table has no joints yet. Add one in the DH table."})),t.forEach(o=>o.relabel()),Gt(s,b.table.actuator?d3(b.table.actuator):null),f3(i)};et("table",o=>o!=="gripper"&&r()),et("q",()=>t.forEach(o=>o.show())),et("units",()=>t.forEach(o=>o.relabel())),r()}};function d3(n){let t=M("input",{type:"range",min:String(n.lower),max:String(n.upper),step:"any","aria-label":`${n.name}, ${n.unit}`,"data-testid":"actuator"}),e=M("output",{class:"quantity"}),i=()=>{t.style.setProperty("--at",`${100*(n.value-n.lower)/(n.upper-n.lower||1)}%`),bt(e,ii(n.value,1))};t.value=n.value,t.addEventListener("input",()=>{n={...n,value:Number(t.value)},yn({...b.table,actuator:n},{what:"gripper",label:`set the ${n.name}`,key:"actuator"}),i()}),i();let s=M("div",{class:"under"},M("span",{text:`${n.name}: moves no frame`}));return M("div",{class:"joint"},M("span",{class:"joint-name",text:"tool"}),M("div",{class:"track"},t,s),e,M("span",{class:"unit",text:n.unit}))}function f3(n){let t=b.table.joints.length,e=Object.entries(b.table.postures??{}),i=(r,o)=>Ut(r,{class:"chip",title:o.map((a,c)=>ce(a,Ze(b.table.joints[c]))).join(", ")},()=>Pi(o,.8,`move to ${r}`)),s=e.map(([r,o])=>i(r,o));t&&!e.some(([,r])=>r.every(o=>o===0))&&s.unshift(i("zero",new Array(t).fill(0))),Gt(n,s,t?Ut("Random",{class:"chip quiet",title:"A posture inside the limits"},()=>Pi(p3(),.8,"move to a random posture")):null,t?Ut("Keep this one",{class:"chip quiet",title:"Add the present posture to the arm"},m3):null)}function p3(){return b.table.joints.map(n=>{let{lo:t,hi:e}=Xb(n);return t+Math.random()*(e-t)})}function m3(){let n={...b.table.postures},t=0;for(;`P${t}`in n;)t+=1;n[`P${t}`]=b.q.slice(),yn({...b.table,postures:n},{what:"postures",label:`keep the posture P${t}`}),we(`Kept as P${t}: ${b.q.map((e,i)=>Yc(e,Ze(b.table.joints[i]))).join(", ")}`),ut("postures")}var Zb=[["position","Position"],["joints","Joints"],["speeds","Joint speeds"],["accelerations","Accelerations"],["toolspeed","Tool speed"],["singularity","Distance to singularity"]];function ur({table:n,q:t,xs:e,xName:i,xEnd:s=null,seconds:r,dq:o,ddq:a,events:c=[],title:l,...u}){let h=t.map(p=>ws(n,p)),d=h.map(p=>te(p[p.length-1])),f=o??a0(t,r);return{table:n,q:t,xs:e,xName:i,xEnd:s,seconds:r,events:c,title:l,...u,tool:d,speeds:f,accelerations:a??a0(f,r),toolspeeds:a0(d,r).map(Ui),least:t.map((p,_)=>Ou(n,p,h[_])[0]??0)}}function a0(n,t){return n.map((e,i)=>{let s=Math.max(i-1,0),r=Math.min(i+1,n.length-1),o=t[r]-t[s];return n[i].map((a,c)=>o>0?(n[r][c]-n[s][c])/o:0)})}var g3=1e6;function x3(n,t,e){let i=n.table.joints[e];if(t==="joints")return[i.lower,i.upper];let s=n.limits?.[{speeds:"speed",accelerations:"acceleration"}[t]],r=Array.isArray(s)?s[e]:s??null;return r===null||r>=g3?[null,null]:[-r,r]}var _3={speeds:"speed",accelerations:"acceleration",toolspeed:"tool speed"},jb=(n,t,e=null)=>(n.tight??[]).filter(i=>i.limit===_3[t]&&i.joint===e),Jb=(n,t)=>(n.tight??[]).filter(e=>e.start-1e-9<=t&&t<=e.end+1e-9).map(e=>e.joint?`${e.limit} of ${e.joint}`:e.limit).join(", ");function l0(n,t){let{table:e}=n,i=mt.factor("length");if(t==="position")return{y:`tool, ${mt.length}`,list:["X","Y","Z"].map((l,u)=>Rf(l,n.tool.map(h=>h[u]*i)))};if(t==="singularity")return{y:"smallest singular value",list:[Rf("\u03C3 min",n.least)]};if(t==="toolspeed"){let l=n.limits?.tool_speed??null,u=n.toolspeeds.map(h=>h*i);return{y:`tool, ${mt.length}/s`,list:[Rf("tool speed",u,[null,l&&l*i],jb(n,t))]}}let s={joints:n.q,speeds:n.speeds,accelerations:n.accelerations}[t],r={joints:"",speeds:"/s",accelerations:"/s\xB2"}[t],a=[...new Set(e.joints.map(Ze))].map(l=>(l==="angle"?mt.angle:mt.length)+r).join(" or "),c=e.joints.map((l,u)=>{let h=mt.factor(Ze(l));return Rf(`q${u+1}`,s.map(d=>d[u]*h),x3(n,t,u).map(d=>d===null?null:d*h),jb(n,t,l.name))});return{y:a,list:c}}var Rf=(n,t,e=[null,null],i=[])=>({name:n,values:t,limits:e,binds:i});function hu(n){let t=n.flatMap((i,s)=>i.limits.filter(r=>r!==null).map(r=>({value:r,of:s}))),e=new Map;for(let i of t)e.set(i.value,[...e.get(i.value)??[],i.of]);return[...e].map(([i,s])=>({value:i,of:s.length===1&&n.length>1?s[0]:null}))}function Kb(n){let t=mt.angle,e=mt.length,{table:i}=n,s=c=>Ze(c)==="angle"?t:e,r=[n.xName.replace(" ","_"),"time_s",`X_${e}`,`Y_${e}`,`Z_${e}`,...i.joints.map((c,l)=>`q${l+1}_${s(c)}`),...i.joints.map((c,l)=>`dq${l+1}_${s(c)}_per_s`),"sigma_min"],o=c=>String(Number(c.toPrecision(10))),a=n.q.map((c,l)=>[n.xs[l],n.seconds[l],...n.tool[l].map(u=>u*mt.factor("length")),...c.map((u,h)=>u*mt.factor(Ze(i.joints[h]))),...n.speeds[l].map((u,h)=>u*mt.factor(Ze(i.joints[h]))),n.least[l]].map(o).join(","));return[r.join(","),...a].join(`
`)+`
`}function Qb(n,t,e){let{y:i,list:s}=l0(n,t),r=720,o=380,a={l:66,r:96,t:34,b:48},c=n.xs,l=s.flatMap(y=>y.values),u=n.xEnd??c[c.length-1],h=c[0],d=u>h?u:h+1,[f,p]=[Math.min(...l),Math.max(...l)];p-f>1e-9||(f-=1,p+=1);let _=y=>a.l+(y-h)/(d-h)*(r-a.l-a.r),m=y=>o-a.b-(y-f)/(p-f)*(o-a.t-a.b),g=(y,E)=>{let U=(E-y)/6,L=10**Math.floor(Math.log10(U)),N=[1,2,5,10].map(H=>H*L).find(H=>H>=U);return Array.from({length:12},(H,$)=>(Math.ceil(y/N)+$)*N).filter(H=>H<=E+N*1e-6)},x=y=>y.toFixed(2),S=y=>String(Number(y.toPrecision(6))),v=y=>y.replace(/[&<>"]/g,E=>({"&":"&amp;","<":"&lt;",">":"&gt;",'"':"&quot;"})[E]),A=["","7 3","2 3","9 3 2 3","5 2 1 2 1 2","12 4","1 2","6 6"],w=[`<rect width="${r}" height="${o}" fill="#fff"/>`,`<text x="${a.l}" y="20" font-weight="600">${v(n.title)}</text>`];for(let y of g(f,p))w.push(`<path d="M${a.l} ${x(m(y))}H${r-a.r}" stroke="#ddd"/><text x="${a.l-8}" y="${x(m(y)+4)}" text-anchor="end">${S(y)}</text>`);for(let y of g(h,d))w.push(`<path d="M${x(_(y))} ${o-a.b}v5" stroke="#333"/><text x="${x(_(y))}" y="${o-a.b+20}" text-anchor="middle">${S(y)}</text>`);w.push(`<path d="M${a.l} ${a.t}V${o-a.b}H${r-a.r}" fill="none" stroke="#333"/>`);for(let y of n.events)Number.isFinite(y.x)&&w.push(`<path d="M${x(_(y.x))} ${a.t}V${o-a.b}" stroke="#b42318" stroke-dasharray="3 3"/><text x="${x(_(y.x)+4)}" y="${a.t+10}" fill="#b42318" font-size="11">${v(y.short)}</text>`);for(let{value:y,of:E}of hu(s))y>=f&&y<=p&&w.push(`<path d="M${a.l} ${x(m(y))}H${r-a.r}" stroke="${E===null?"#333":e[E%e.length]}" stroke-dasharray="2 5"/>`);return s.forEach((y,E)=>{let U=e[E%e.length],L=y.values[y.values.length-1];w.push(`<polyline fill="none" stroke="${U}" stroke-width="1.8" stroke-dasharray="${A[E%A.length]}" points="${y.values.map((N,H)=>`${x(_(c[H]))},${x(m(N))}`).join(" ")}"/>`,`<path d="M${r-a.r+12} ${a.t+8+18*E}h22" stroke="${U}" stroke-width="2" stroke-dasharray="${A[E%A.length]}"/><text x="${r-a.r+40}" y="${a.t+12+18*E}"><title>${x(L)}</title>${v(y.name)}</text>`)}),w.push(`<text x="${(a.l+r-a.r)/2}" y="${o-8}" text-anchor="middle">${v(n.xName)}</text>`,`<text transform="translate(16 ${(a.t+o-a.b)/2}) rotate(-90)" text-anchor="middle">${v(i)}</text>`),`<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${r} ${o}" width="${r}" height="${o}" font-family="Inter, Helvetica, Arial, sans-serif" font-size="12" fill="#222">${w.join("")}</svg>
`}var y3="uplot",v3="u-hz",b3="u-vt",M3="u-title",S3="u-wrap",w3="u-under",E3="u-over",T3="u-axis",Jo="u-off",A3="u-select",R3="u-cursor-x",C3="u-cursor-y",P3="u-cursor-pt",I3="u-legend",L3="u-live",D3="u-inline",N3="u-series",U3="u-marker",tM="u-label",O3="u-value",fu="width",pu="height";var eM="bottom",pl="left",c0="right",T0="#000",nM=T0+"0",u0="mousemove",iM="mousedown",h0="mouseup",sM="mouseenter",rM="mouseleave",oM="dblclick",F3="resize",B3="scroll",aM="change",Df="dppxchange",A0="--",bl=typeof window<"u",g0=bl?document:null,gl=bl?window:null,k3=bl?navigator:null,We,Cf;function x0(){let n=devicePixelRatio;We!=n&&(We=n,Cf&&y0(aM,Cf,x0),Cf=matchMedia(`(min-resolution: ${We-.001}dppx) and (max-resolution: ${We+.001}dppx)`),Ko(aM,Cf,x0),gl.dispatchEvent(new CustomEvent(Df)))}function ss(n,t){if(t!=null){let e=n.classList;!e.contains(t)&&e.add(t)}}function _0(n,t){let e=n.classList;e.contains(t)&&e.remove(t)}function gn(n,t,e){n.style[t]=e+"px"}function Fs(n,t,e,i){let s=g0.createElement(n);return t!=null&&ss(s,t),e?.insertBefore(s,i),s}function _s(n,t){return Fs("div",n,t)}var lM=new WeakMap;function hr(n,t,e,i,s){let r="translate("+t+"px,"+e+"px)",o=lM.get(n);r!=o&&(n.style.transform=r,lM.set(n,r),t<0||e<0||t>i||e>s?ss(n,Jo):_0(n,Jo))}var cM=new WeakMap;function uM(n,t,e){let i=t+e,s=cM.get(n);i!=s&&(cM.set(n,i),n.style.background=t,n.style.borderColor=e)}var hM=new WeakMap;function dM(n,t,e,i){let s=t+""+e,r=hM.get(n);s!=r&&(hM.set(n,s),n.style.height=e+"px",n.style.width=t+"px",n.style.marginLeft=i?-t/2+"px":0,n.style.marginTop=i?-e/2+"px":0)}var R0={passive:!0},z3={...R0,capture:!0};function Ko(n,t,e,i){t.addEventListener(n,e,i?z3:R0)}function y0(n,t,e,i){t.removeEventListener(n,e,R0)}bl&&x0();function Bs(n,t,e,i){let s;e=e||0,i=i||t.length-1;let r=i<=2147483647;for(;i-e>1;)s=r?e+i>>1:rs((e+i)/2),t[s]<n?e=s:i=s;return n-t[e]<=t[i]-n?e:i}function zM(n){return(e,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(e[a])){r=a;break}for(let a=s;a>=i;a--)if(n(e[a])){o=a;break}return[r,o]}}var HM=n=>n!=null,GM=n=>n!=null&&n>0,Of=zM(HM),H3=zM(GM);function G3(n,t,e,i=0,s=!1){let r=s?H3:Of,o=s?GM:HM;[t,e]=r(n,t,e);let a=n[t],c=n[t];if(t>-1)if(i==1)a=n[t],c=n[e];else if(i==-1)a=n[e],c=n[t];else for(let l=t;l<=e;l++){let u=n[l];o(u)&&(u<a?a=u:u>c&&(c=u))}return[a??nn,c??-nn]}function Ff(n,t,e,i){let s=mM(n),r=mM(t);n==t&&(s==-1?(n*=e,t/=e):(n/=e,t*=e));let o=e==10?kr:VM,a=s==1?rs:ys,c=r==1?ys:rs,l=a(o(jn(n))),u=c(o(jn(t))),h=xl(e,l),d=xl(e,u);return e==10&&(l<0&&(h=sn(h,-l)),u<0&&(d=sn(d,-u))),i||e==2?(n=h*s,t=d*r):(n=XM(n,h),t=Bf(t,d)),[n,t]}function C0(n,t,e,i){let s=Ff(n,t,e,i);return n==0&&(s[0]=0),t==0&&(s[1]=0),s}var P0=.1,fM={mode:3,pad:P0},gu={pad:0,soft:null,mode:0},V3={min:gu,max:gu};function Nf(n,t,e,i){return kf(e)?pM(n,t,e):(gu.pad=e,gu.soft=i?0:null,gu.mode=i?3:0,pM(n,t,V3))}function ke(n,t){return n??t}function W3(n,t,e){for(t=ke(t,0),e=ke(e,n.length-1);t<=e;){if(n[t]!=null)return!0;t++}return!1}function pM(n,t,e){let i=e.min,s=e.max,r=ke(i.pad,0),o=ke(s.pad,0),a=ke(i.hard,-nn),c=ke(s.hard,nn),l=ke(i.soft,nn),u=ke(s.soft,-nn),h=ke(i.mode,0),d=ke(s.mode,0),f=t-n,p=kr(f),_=Li(jn(n),jn(t)),m=kr(_),g=jn(m-p);(f<1e-24||g>10)&&(f=0,(n==0||t==0)&&(f=1e-24,h==2&&l!=nn&&(r=0),d==2&&u!=-nn&&(o=0)));let x=f||_||1e3,S=kr(x),v=xl(10,rs(S)),A=x*(f==0?n==0?.1:1:r),w=sn(XM(n-A,v/10),24),y=n>=l&&(h==1||h==3&&w<=l||h==2&&w>=l)?l:nn,E=Li(a,w<y&&n>=y?y:ks(y,w)),U=x*(f==0?t==0?.1:1:o),L=sn(Bf(t+U,v/10),24),N=t<=u&&(d==1||d==3&&L>=u||d==2&&L<=u)?u:-nn,H=ks(c,L>N&&t<=N?N:Li(N,L));return E==H&&E==0&&(H=100),[E,H]}var $3=new Intl.NumberFormat(bl?k3.language:"en-US"),I0=n=>$3.format(n),os=Math,Lf=os.PI,jn=os.abs,rs=os.floor,Yn=os.round,ys=os.ceil,ks=os.min,Li=os.max,xl=os.pow,mM=os.sign,kr=os.log10,VM=os.log2,q3=(n,t=1)=>os.sinh(n)*t,d0=(n,t=1)=>os.asinh(n/t),nn=1/0;function gM(n){return(kr((n^n>>31)-(n>>31))|0)+1}function v0(n,t,e){return ks(Li(n,t),e)}function WM(n){return typeof n=="function"}function Ne(n){return WM(n)?n:()=>n}var X3=()=>{},$M=n=>n,qM=(n,t)=>t,Y3=n=>null,xM=n=>!0,_M=(n,t)=>n==t,j3=/\.\d*?(?=9{6,}|0{6,})/gm,Qo=n=>{if(jM(n)||yo.has(n))return n;let t=`${n}`,e=t.match(j3);if(e==null)return n;let i=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${Qo(s)}e${r}`}return sn(n,i)};function jo(n,t){return Qo(sn(Qo(n/t))*t)}function Bf(n,t){return Qo(ys(Qo(n/t))*t)}function XM(n,t){return Qo(rs(Qo(n/t))*t)}function sn(n,t=0){if(jM(n))return n;let e=10**t,i=n*e*(1+Number.EPSILON);return Yn(i)/e}var yo=new Map;function YM(n){return((""+n).split(".")[1]||"").length}function _u(n,t,e,i){let s=[],r=i.map(YM);for(let o=t;o<e;o++){let a=jn(o),c=sn(xl(n,o),a);for(let l=0;l<i.length;l++){let u=n==10?+`${i[l]}e${o}`:i[l]*c,h=(o>=0?0:a)+(o>=r[l]?0:r[l]),d=n==10?u:sn(u,h);s.push(d),yo.set(d,h)}}return s}var xu={},L0=[],_l=[null,null],_o=Array.isArray,jM=Number.isInteger,Z3=n=>n===void 0;function yM(n){return typeof n=="string"}function kf(n){let t=!1;if(n!=null){let e=n.constructor;t=e==null||e==Object}return t}function J3(n){return n!=null&&typeof n=="object"}var K3=Object.getPrototypeOf(Uint8Array),ZM="__proto__";function yl(n,t=kf){let e;if(_o(n)){let i=n.find(s=>s!=null);if(_o(i)||t(i)){e=Array(n.length);for(let s=0;s<n.length;s++)e[s]=yl(n[s],t)}else e=n.slice()}else if(n instanceof K3)e=n.slice();else if(t(n)){e={};for(let i in n)i!=ZM&&(e[i]=yl(n[i],t))}else e=n;return e}function Bn(n){let t=arguments;for(let e=1;e<t.length;e++){let i=t[e];for(let s in i)s!=ZM&&(kf(n[s])?Bn(n[s],yl(i[s])):n[s]=yl(i[s]))}return n}var Q3=0,t2=1,e2=2;function n2(n,t,e){for(let i=0,s,r=-1;i<t.length;i++){let o=t[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<e&&n[s]==null;)n[r=s++]=null}}}function i2(n,t){if(o2(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return a2(o[0])||(o=r2(o)),o}let e=new Set;for(let o=0;o<n.length;o++){let c=n[o][0],l=c.length;for(let u=0;u<l;u++)e.add(c[u])}let i=[Array.from(e).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],c=a[0];for(let l=1;l<a.length;l++){let u=a[l],h=Array(s).fill(void 0),d=t?t[o][l]:t2,f=[];for(let p=0;p<u.length;p++){let _=u[p],m=r.get(c[p]);_===null?d!=Q3&&(h[m]=_,d==e2&&f.push(m)):h[m]=_}n2(h,f,s),i.push(h)}}return i}var s2=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function r2(n){let t=n[0],e=t.length,i=Array(e);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(e);for(let c=0;c<e;c++)a[c]=o[i[c]];s.push(a)}return s}function o2(n){let t=n[0][0],e=t.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function a2(n,t=100){let e=n.length;if(e<=1)return!0;let i=0,s=e-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=Li(1,rs((s-i+1)/t));for(let o=n[i],a=i+r;a<=s;a+=r){let c=n[a];if(c!=null){if(c<=o)return!1;o=c}}return!0}var JM=["January","February","March","April","May","June","July","August","September","October","November","December"],KM=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function QM(n){return n.slice(0,3)}var l2=KM.map(QM),c2=JM.map(QM),u2={MMMM:JM,MMM:c2,WWWW:KM,WWW:l2};function du(n){return(n<10?"0":"")+n}function h2(n){return(n<10?"00":n<100?"0":"")+n}var d2={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,t)=>t.MMMM[n.getMonth()],MMM:(n,t)=>t.MMM[n.getMonth()],MM:n=>du(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>du(n.getDate()),D:n=>n.getDate(),WWWW:(n,t)=>t.WWWW[n.getDay()],WWW:(n,t)=>t.WWW[n.getDay()],HH:n=>du(n.getHours()),H:n=>n.getHours(),h:n=>{let t=n.getHours();return t==0?12:t>12?t-12:t},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>du(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>du(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>h2(n.getMilliseconds())};function D0(n,t){t=t||u2;let e=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)e.push(s[0][0]=="{"?d2[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var f2=new Intl.DateTimeFormat().resolvedOptions().timeZone;function p2(n,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+n+n.getTimezoneOffset()*6e4):t==f2?e=n:(e=new Date(n.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(n.getMilliseconds())),e}var tS=n=>n%1==0,Uf=[1,2,2.5,5],m2=_u(10,-32,0,Uf),eS=_u(10,0,32,Uf),g2=eS.filter(tS),Zo=m2.concat(eS),N0=`
`,nS="{YYYY}",vM=N0+nS,iS="{M}/{D}",mu=N0+iS,Pf=mu+"/{YY}",sS="{aa}",x2="{h}:{mm}",ml=x2+sS,bM=N0+ml,MM=":{ss}",qe=null;function rS(n){let t=n*1e3,e=t*60,i=e*60,s=i*24,r=s*30,o=s*365,c=(n==1?_u(10,0,3,Uf).filter(tS):_u(10,-3,0,Uf)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),l=[[o,nS,qe,qe,qe,qe,qe,qe,1],[s*28,"{MMM}",vM,qe,qe,qe,qe,qe,1],[s,iS,vM,qe,qe,qe,qe,qe,1],[i,"{h}"+sS,Pf,qe,mu,qe,qe,qe,1],[e,ml,Pf,qe,mu,qe,qe,qe,1],[t,MM,Pf+" "+ml,qe,mu+" "+ml,qe,bM,qe,1],[n,MM+".{fff}",Pf+" "+ml,qe,mu+" "+ml,qe,bM,qe,1]];function u(h){return(d,f,p,_,m,g)=>{let x=[],S=m>=o,v=m>=r&&m<o,A=h(p),w=sn(A*n,3),y=f0(A.getFullYear(),S?0:A.getMonth(),v||S?1:A.getDate()),E=sn(y*n,3);if(v||S){let U=v?m/r:0,L=S?m/o:0,N=w==E?w:sn(f0(y.getFullYear()+L,y.getMonth()+U,1)*n,3),H=new Date(Yn(N/n)),$=H.getFullYear(),P=H.getMonth();for(let z=0;N<=_;z++){let D=f0($+L*z,P+U*z,1),B=D-h(sn(D*n,3));N=sn((+D+B)*n,3),N<=_&&x.push(N)}}else{let U=m>=s?s:m,L=rs(p)-rs(w),N=E+L+Bf(w-E,U);x.push(N);let H=h(N),$=H.getHours()+H.getMinutes()/e+H.getSeconds()/i,P=m/i,z=d.axes[f]._space,D=g/z;for(;N=sn(N+m,n==1?0:3),!(N>_);)if(P>1){let B=rs(sn($+P,6))%24,Z=h(N).getHours()-B;Z>1&&(Z=-1),N-=Z*i,$=($+P)%24;let nt=x[x.length-1];sn((N-nt)/m,3)*D>=.7&&x.push(N)}else x.push(N)}return x}}return[c,l,u]}var[_2,y2,v2]=rS(1),[b2,M2,S2]=rS(.001);_u(2,-53,53,[1]);function SM(n,t){return n.map(e=>e.map((i,s)=>s==0||s==8||i==null?i:t(s==1||e[8]==0?i:e[1]+i)))}function wM(n,t){return(e,i,s,r,o)=>{let a=t.find(p=>o>=p[0])||t[t.length-1],c,l,u,h,d,f;return i.map(p=>{let _=n(p),m=_.getFullYear(),g=_.getMonth(),x=_.getDate(),S=_.getHours(),v=_.getMinutes(),A=_.getSeconds(),w=m!=c&&a[2]||g!=l&&a[3]||x!=u&&a[4]||S!=h&&a[5]||v!=d&&a[6]||A!=f&&a[7]||a[1];return c=m,l=g,u=x,h=S,d=v,f=A,w(_)})}}function w2(n,t){let e=D0(t);return(i,s,r,o,a)=>s.map(c=>e(n(c)))}function f0(n,t,e){return new Date(n,t,e)}function EM(n,t){return t(n)}var E2="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function TM(n,t){return(e,i,s,r)=>r==null?A0:t(n(i))}function T2(n,t){let e=n.series[t];return e.width?e.stroke(n,t):e.points.width?e.points.stroke(n,t):null}function A2(n,t){return n.series[t].fill(n,t)}var R2={show:!0,live:!0,isolate:!1,mount:X3,markers:{show:!0,width:2,stroke:T2,fill:A2,dash:"solid"},idx:null,idxs:null,values:[]};function C2(n,t){let e=n.cursor.points,i=_s(),s=e.size(n,t);gn(i,fu,s),gn(i,pu,s);let r=s/-2;gn(i,"marginLeft",r),gn(i,"marginTop",r);let o=e.width(n,t,s);return o&&gn(i,"borderWidth",o),i}function P2(n,t){let e=n.series[t].points;return e._fill||e._stroke}function I2(n,t){let e=n.series[t].points;return e._stroke||e._fill}function L2(n,t){return n.series[t].points.size}var p0=[0,0];function D2(n,t,e){return p0[0]=t,p0[1]=e,p0}function If(n,t,e,i=!0){return s=>{s.button==0&&(!i||s.target==t)&&e(s)}}function m0(n,t,e,i=!0){return s=>{(!i||s.target==t)&&e(s)}}var N2={show:!0,x:!0,y:!0,lock:!1,move:D2,points:{one:!1,show:C2,size:L2,width:0,stroke:I2,fill:P2},bind:{mousedown:If,mouseup:If,click:If,dblclick:If,mousemove:m0,mouseleave:m0,mouseenter:m0},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,t,e,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},oS={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},U0=Bn({},oS,{filter:qM}),aS=Bn({},U0,{size:10}),lS=Bn({},oS,{show:!1}),O0='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',cS="bold "+O0,uS=1.5,AM={show:!0,scale:"x",stroke:T0,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:cS,side:2,grid:U0,ticks:aS,border:lS,font:O0,lineGap:uS,rotate:0},U2="Value",O2="Time",RM={show:!0,scale:"x",auto:!1,sorted:1,min:nn,max:-nn,idxs:[]};function F2(n,t,e,i,s){return t.map(r=>r==null?"":I0(r))}function B2(n,t,e,i,s,r,o){let a=[],c=yo.get(s)||0;e=o?e:sn(Bf(e,s),c);for(let l=e;l<=i;l=sn(l+s,c))a.push(Object.is(l,-0)?0:l);return a}function b0(n,t,e,i,s,r,o){let a=[],c=n.scales[n.axes[t].scale].log,l=c==10?kr:VM,u=rs(l(e));s=xl(c,u),c==10&&(s=Zo[Bs(s,Zo)]);let h=e,d=s*c;c==10&&(d=Zo[Bs(d,Zo)]);do a.push(h),h=h+s,c==10&&!yo.has(h)&&(h=sn(h,yo.get(s))),h>=d&&(s=h,d=s*c,c==10&&(d=Zo[Bs(d,Zo)]));while(h<=i);return a}function k2(n,t,e,i,s,r,o){let c=n.scales[n.axes[t].scale].asinh,l=i>c?b0(n,t,Li(c,e),i,s):[c],u=i>=0&&e<=0?[0]:[];return(e<-c?b0(n,t,Li(c,-i),-e,s):[c]).reverse().map(d=>-d).concat(u,l)}var hS=/./,z2=/[12357]/,H2=/[125]/,CM=/1/,M0=(n,t,e,i)=>n.map((s,r)=>t==4&&s==0||r%i==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function G2(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=n.scales[o],c=n.valToPos,l=r._space,u=c(10,o),h=c(9,o)-u>=l?hS:c(7,o)-u>=l?z2:c(5,o)-u>=l?H2:CM;if(h==CM){let d=jn(c(1,o)-u);if(d<l)return M0(t.slice().reverse(),a.distr,h,ys(l/d)).reverse()}return M0(t,a.distr,h,1)}function V2(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=r._space,c=n.valToPos,l=jn(c(1,o)-c(2,o));return l<a?M0(t.slice().reverse(),3,hS,ys(a/l)).reverse():t}function W2(n,t,e,i){return i==null?A0:t==null?"":I0(t)}var PM={show:!0,scale:"y",stroke:T0,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:cS,side:3,grid:U0,ticks:aS,border:lS,font:O0,lineGap:uS,rotate:0};function $2(n,t){let e=3+(n||1)*2;return sn(e*t,3)}function q2(n,t){let{scale:e,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],e,!0),o=n.valToPos(s[i[1]],e,!0),a=jn(o-r),c=n.series[t],l=a/(c.points.space*We);return i[1]-i[0]<=l}var IM={scale:null,auto:!0,sorted:0,min:nn,max:-nn},dS=(n,t,e,i,s)=>s,LM={show:!0,auto:!0,sorted:0,gaps:dS,alpha:1,facets:[Bn({},IM,{scale:"x"}),Bn({},IM,{scale:"y"})]},DM={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:dS,alpha:1,points:{show:q2,filter:null},values:null,min:nn,max:-nn,idxs:[],path:null,clip:null};function X2(n,t,e,i,s){return e/10}var fS={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},Y2=Bn({},fS,{time:!1,ori:1}),NM={};function pS(n,t){let e=NM[n];return e||(e={key:n,plots:[],sub(i){e.plots.push(i)},unsub(i){e.plots=e.plots.filter(s=>s!=i)},pub(i,s,r,o,a,c,l){for(let u=0;u<e.plots.length;u++)e.plots[u]!=s&&e.plots[u].pub(i,s,r,o,a,c,l)}},n!=null&&(NM[n]=e)),e}var vl=1,S0=2;function ta(n,t,e){let i=n.mode,s=n.series[t],r=i==2?n._data[t]:n._data,o=n.scales,a=n.bbox,c=r[0],l=i==2?r[1]:r[t],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],h=i==2?o[s.facets[1].scale]:o[s.scale],d=a.left,f=a.top,p=a.width,_=a.height,m=n.valToPosH,g=n.valToPosV;return u.ori==0?e(s,c,l,u,h,m,g,d,f,p,_,Hf,Ml,Vf,gS,_S):e(s,c,l,u,h,g,m,f,d,_,p,Gf,Sl,k0,xS,yS)}function F0(n,t){let e=0,i=0,s=ke(n.bands,L0);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?i|=1:i|=2)}return[e,i==1?-1:i==2?1:i==3?2:0]}function j2(n,t,e,i,s){let r=n.mode,o=n.series[t],a=r==2?o.facets[1].scale:o.scale,c=n.scales[a];return s==-1?c.min:s==1?c.max:c.distr==3?c.dir==1?c.min:c.max:0}function zr(n,t,e,i,s,r){return ta(n,t,(o,a,c,l,u,h,d,f,p,_,m)=>{let g=o.pxRound,x=l.dir*(l.ori==0?1:-1),S=l.ori==0?Ml:Sl,v,A;x==1?(v=e,A=i):(v=i,A=e);let w=g(h(a[v],l,_,f)),y=g(d(c[v],u,m,p)),E=g(h(a[A],l,_,f)),U=g(d(r==1?u.max:u.min,u,m,p)),L=new Path2D(s);return S(L,E,U),S(L,w,U),S(L,w,y),L})}function zf(n,t,e,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=t==0?Vf:k0,c=e;for(let h=0;h<n.length;h++){let d=n[h];if(d[1]>d[0]){let f=d[0]-c;f>0&&a(o,c,i,f,i+r),c=d[1]}}let l=e+s-c,u=10;l>0&&a(o,c,i-u/2,l,i+r+u)}return o}function Z2(n,t,e){let i=n[n.length-1];i&&i[0]==t?i[1]=e:n.push([t,e])}function B0(n,t,e,i,s,r,o){let a=[],c=n.length;for(let l=s==1?e:i;l>=e&&l<=i;l+=s)if(t[l]===null){let h=l,d=l;if(s==1)for(;++l<=i&&t[l]===null;)d=l;else for(;--l>=e&&t[l]===null;)d=l;let f=r(n[h]),p=d==h?f:r(n[d]),_=h-s;f=o<=0&&_>=0&&_<c?r(n[_]):f;let g=d+s;p=o>=0&&g>=0&&g<c?r(n[g]):p,p>=f&&a.push([f,p])}return a}function UM(n){return n==0?$M:n==1?Yn:t=>jo(t,n)}function mS(n){let t=n==0?Hf:Gf,e=n==0?(s,r,o,a,c,l)=>{s.arcTo(r,o,a,c,l)}:(s,r,o,a,c,l)=>{s.arcTo(o,r,c,a,l)},i=n==0?(s,r,o,a,c)=>{s.rect(r,o,a,c)}:(s,r,o,a,c)=>{s.rect(o,r,c,a)};return(s,r,o,a,c,l=0,u=0)=>{l==0&&u==0?i(s,r,o,a,c):(l=ks(l,a/2,c/2),u=ks(u,a/2,c/2),t(s,r+l,o),e(s,r+a,o,r+a,o+c,l),e(s,r+a,o+c,r,o+c,u),e(s,r,o+c,r,o,u),e(s,r,o,r+a,o,l),s.closePath())}}var Hf=(n,t,e)=>{n.moveTo(t,e)},Gf=(n,t,e)=>{n.moveTo(e,t)},Ml=(n,t,e)=>{n.lineTo(t,e)},Sl=(n,t,e)=>{n.lineTo(e,t)},Vf=mS(0),k0=mS(1),gS=(n,t,e,i,s,r)=>{n.arc(t,e,i,s,r)},xS=(n,t,e,i,s,r)=>{n.arc(e,t,i,s,r)},_S=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(t,e,i,s,r,o)},yS=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(e,t,s,i,o,r)};function vS(n){return(t,e,i,s,r)=>ta(t,e,(o,a,c,l,u,h,d,f,p,_,m)=>{let{pxRound:g,points:x}=o,S,v;l.ori==0?(S=Hf,v=gS):(S=Gf,v=xS);let A=sn(x.width*We,3),w=(x.size-x.width)/2*We,y=sn(w*2,3),E=new Path2D,U=new Path2D,{left:L,top:N,width:H,height:$}=t.bbox;Vf(U,L-y,N-y,H+y*2,$+y*2);let P=z=>{if(c[z]!=null){let D=g(h(a[z],l,_,f)),B=g(d(c[z],u,m,p));S(E,D+w,B),v(E,D,B,w,0,Lf*2)}};if(r)r.forEach(P);else for(let z=i;z<=s;z++)P(z);return{stroke:A>0?E:null,fill:E,clip:U,flags:vl|S0}})}function bS(n){return(t,e,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(t,e,i),r!=s&&o!=s&&n(t,e,s),n(t,e,o))}}var J2=bS(Ml),K2=bS(Sl);function MS(n){let t=ke(n?.alignGaps,0);return(e,i,s,r)=>ta(e,i,(o,a,c,l,u,h,d,f,p,_,m)=>{[s,r]=Of(c,s,r);let g=o.pxRound,x=$=>g(h($,l,_,f)),S=$=>g(d($,u,m,p)),v,A;l.ori==0?(v=Ml,A=J2):(v=Sl,A=K2);let w=l.dir*(l.ori==0?1:-1),y={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:vl},E=y.stroke,U=!1;if(r-s>=_*4){let $=ft=>e.posToVal(ft,l.key,!0),P=null,z=null,D,B,Q,Y=x(a[w==1?s:r]),Z=x(a[s]),nt=x(a[r]),dt=$(w==1?Z+1:nt-1);for(let ft=w==1?s:r;ft>=s&&ft<=r;ft+=w){let st=a[ft],xt=(w==1?st<dt:st>dt)?Y:x(st),Tt=c[ft];xt==Y?Tt!=null?(B=Tt,P==null?(v(E,xt,S(B)),D=P=z=B):B<P?P=B:B>z&&(z=B)):Tt===null&&(U=!0):(P!=null&&A(E,Y,S(P),S(z),S(D),S(B)),Tt!=null?(B=Tt,v(E,xt,S(B)),P=z=D=B):(P=z=null,Tt===null&&(U=!0)),Y=xt,dt=$(Y+w))}P!=null&&P!=z&&Q!=Y&&A(E,Y,S(P),S(z),S(D),S(B))}else for(let $=w==1?s:r;$>=s&&$<=r;$+=w){let P=c[$];P===null?U=!0:P!=null&&v(E,x(a[$]),S(P))}let[N,H]=F0(e,i);if(o.fill!=null||N!=0){let $=y.fill=new Path2D(E),P=o.fillTo(e,i,o.min,o.max,N),z=S(P),D=x(a[s]),B=x(a[r]);w==-1&&([B,D]=[D,B]),v($,B,z),v($,D,z)}if(!o.spanGaps){let $=[];U&&$.push(...B0(a,c,s,r,w,x,t)),y.gaps=$=o.gaps(e,i,s,r,$),y.clip=zf($,l.ori,f,p,_,m)}return H!=0&&(y.band=H==2?[zr(e,i,s,r,E,-1),zr(e,i,s,r,E,1)]:zr(e,i,s,r,E,H)),y})}function Q2(n){let t=ke(n.align,1),e=ke(n.ascDesc,!1),i=ke(n.alignGaps,0),s=ke(n.extend,!1);return(r,o,a,c)=>ta(r,o,(l,u,h,d,f,p,_,m,g,x,S)=>{[a,c]=Of(h,a,c);let v=l.pxRound,{left:A,width:w}=r.bbox,y=Z=>v(p(Z,d,x,m)),E=Z=>v(_(Z,f,S,g)),U=d.ori==0?Ml:Sl,L={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:vl},N=L.stroke,H=d.dir*(d.ori==0?1:-1),$=E(h[H==1?a:c]),P=y(u[H==1?a:c]),z=P,D=P;s&&t==-1&&(D=A,U(N,D,$)),U(N,P,$);for(let Z=H==1?a:c;Z>=a&&Z<=c;Z+=H){let nt=h[Z];if(nt==null)continue;let dt=y(u[Z]),ft=E(nt);t==1?U(N,dt,$):U(N,z,ft),U(N,dt,ft),$=ft,z=dt}let B=z;s&&t==1&&(B=A+w,U(N,B,$));let[Q,Y]=F0(r,o);if(l.fill!=null||Q!=0){let Z=L.fill=new Path2D(N),nt=l.fillTo(r,o,l.min,l.max,Q),dt=E(nt);U(Z,B,dt),U(Z,D,dt)}if(!l.spanGaps){let Z=[];Z.push(...B0(u,h,a,c,H,y,i));let nt=l.width*We/2,dt=e||t==1?nt:-nt,ft=e||t==-1?-nt:nt;Z.forEach(st=>{st[0]+=dt,st[1]+=ft}),L.gaps=Z=l.gaps(r,o,a,c,Z),L.clip=zf(Z,d.ori,m,g,x,S)}return Y!=0&&(L.band=Y==2?[zr(r,o,a,c,N,-1),zr(r,o,a,c,N,1)]:zr(r,o,a,c,N,Y)),L})}function OM(n,t,e,i,s,r,o=nn){if(n.length>1){let a=null;for(let c=0,l=1/0;c<n.length;c++)if(t[c]!==void 0){if(a!=null){let u=jn(n[c]-n[a]);u<l&&(l=u,o=jn(e(n[c],i,s,r)-e(n[a],i,s,r)))}a=c}}return o}function tL(n){n=n||xu;let t=ke(n.size,[.6,nn,1]),e=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=Ne(s),o=1-t[0],a=ke(t[1],nn),c=ke(t[2],1),l=ke(n.disp,xu),u=ke(n.each,f=>{}),{fill:h,stroke:d}=l;return(f,p,_,m)=>ta(f,p,(g,x,S,v,A,w,y,E,U,L,N)=>{let H=g.pxRound,$=e,P=i*We,z=a*We,D=c*We,B,Q;v.ori==0?[B,Q]=r(f,p):[Q,B]=r(f,p);let Y=v.dir*(v.ori==0?1:-1),Z=v.ori==0?Vf:k0,nt=v.ori==0?u:(Nt,se,xe,Ct,Qe,Yt,ne)=>{u(Nt,se,xe,Qe,Ct,ne,Yt)},dt=ke(f.bands,L0).find(Nt=>Nt.series[0]==p),ft=dt!=null?dt.dir:0,st=g.fillTo(f,p,g.min,g.max,ft),yt=H(y(st,A,N,U)),xt,Tt,At,Jt=L,ge=H(g.width*We),jt=!1,Te=null,Me=null,pe=null,xn=null;h!=null&&(ge==0||d!=null)&&(jt=!0,Te=h.values(f,p,_,m),Me=new Map,new Set(Te).forEach(Nt=>{Nt!=null&&Me.set(Nt,new Path2D)}),ge>0&&(pe=d.values(f,p,_,m),xn=new Map,new Set(pe).forEach(Nt=>{Nt!=null&&xn.set(Nt,new Path2D)})));let{x0:on,size:In}=l;if(on!=null&&In!=null){$=1,x=on.values(f,p,_,m),on.unit==2&&(x=x.map(xe=>f.posToVal(E+xe*L,v.key,!0)));let Nt=In.values(f,p,_,m);In.unit==2?Tt=Nt[0]*L:Tt=w(Nt[0],v,L,E)-w(0,v,L,E),Jt=OM(x,S,w,v,L,E,Jt),At=Jt-Tt+P}else Jt=OM(x,S,w,v,L,E,Jt),At=Jt*o+P,Tt=Jt-At;At<1&&(At=0),ge>=Tt/2&&(ge=0),At<5&&(H=$M);let Je=At>0,Zn=Jt-At-(Je?ge:0);Tt=H(v0(Zn,D,z)),xt=($==0?Tt/2:$==Y?0:Tt)-$*Y*(($==0?P/2:0)+(Je?ge/2:0));let Ue={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},kn=jt?null:new Path2D,Sn=null;if(dt!=null)Sn=f.data[dt.series[1]];else{let{y0:Nt,y1:se}=l;Nt!=null&&se!=null&&(S=se.values(f,p,_,m),Sn=Nt.values(f,p,_,m))}let Ln=B*Tt,W=Q*Tt;for(let Nt=Y==1?_:m;Nt>=_&&Nt<=m;Nt+=Y){let se=S[Nt];if(se==null)continue;if(Sn!=null){let j=Sn[Nt]??0;if(se-j==0)continue;yt=y(j,A,N,U)}let xe=v.distr!=2||l!=null?x[Nt]:Nt,Ct=w(xe,v,L,E),Qe=y(ke(se,st),A,N,U),Yt=H(Ct-xt),ne=H(Li(Qe,yt)),O=H(ks(Qe,yt)),R=ne-O;if(se!=null){let j=se<0?W:Ln,gt=se<0?Ln:W;jt?(ge>0&&pe[Nt]!=null&&Z(xn.get(pe[Nt]),Yt,O+rs(ge/2),Tt,Li(0,R-ge),j,gt),Te[Nt]!=null&&Z(Me.get(Te[Nt]),Yt,O+rs(ge/2),Tt,Li(0,R-ge),j,gt)):Z(kn,Yt,O+rs(ge/2),Tt,Li(0,R-ge),j,gt),nt(f,p,Nt,Yt-ge/2,O,Tt+ge,R)}}return ge>0?Ue.stroke=jt?xn:kn:jt||(Ue._fill=g.width==0?g._fill:g._stroke??g._fill,Ue.width=0),Ue.fill=jt?Me:kn,Ue})}function eL(n,t){let e=ke(t?.alignGaps,0);return(i,s,r,o)=>ta(i,s,(a,c,l,u,h,d,f,p,_,m,g)=>{[r,o]=Of(l,r,o);let x=a.pxRound,S=B=>x(d(B,u,m,p)),v=B=>x(f(B,h,g,_)),A,w,y;u.ori==0?(A=Hf,y=Ml,w=_S):(A=Gf,y=Sl,w=yS);let E=u.dir*(u.ori==0?1:-1),U=S(c[E==1?r:o]),L=U,N=[],H=[];for(let B=E==1?r:o;B>=r&&B<=o;B+=E)if(l[B]!=null){let Y=c[B],Z=S(Y);N.push(L=Z),H.push(v(l[B]))}let $={stroke:n(N,H,A,y,w,x),fill:null,clip:null,band:null,gaps:null,flags:vl},P=$.stroke,[z,D]=F0(i,s);if(a.fill!=null||z!=0){let B=$.fill=new Path2D(P),Q=a.fillTo(i,s,a.min,a.max,z),Y=v(Q);y(B,L,Y),y(B,U,Y)}if(!a.spanGaps){let B=[];B.push(...B0(c,l,r,o,E,S,e)),$.gaps=B=a.gaps(i,s,r,o,B),$.clip=zf(B,u.ori,p,_,m,g)}return D!=0&&($.band=D==2?[zr(i,s,r,o,P,-1),zr(i,s,r,o,P,1)]:zr(i,s,r,o,P,D)),$})}function nL(n){return eL(iL,n)}function iL(n,t,e,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(e(a,n[0],t[0]),o==2)i(a,n[1],t[1]);else{let c=Array(o),l=Array(o-1),u=Array(o-1),h=Array(o-1);for(let d=0;d<o-1;d++)u[d]=t[d+1]-t[d],h[d]=n[d+1]-n[d],l[d]=u[d]/h[d];c[0]=l[0];for(let d=1;d<o-1;d++)l[d]===0||l[d-1]===0||l[d-1]>0!=l[d]>0?c[d]=0:(c[d]=3*(h[d-1]+h[d])/((2*h[d]+h[d-1])/l[d-1]+(h[d]+2*h[d-1])/l[d]),isFinite(c[d])||(c[d]=0));c[o-1]=l[o-2];for(let d=0;d<o-1;d++)s(a,n[d]+h[d]/3,t[d]+c[d]*h[d]/3,n[d+1]-h[d]/3,t[d+1]-c[d+1]*h[d]/3,n[d+1],t[d+1])}return a}var w0=new Set;function FM(){for(let n of w0)n.syncRect(!0)}bl&&(Ko(F3,gl,FM),Ko(B3,gl,FM,!0),Ko(Df,gl,()=>{ai.pxRatio=We}));var sL=MS(),rL=vS();function BM(n,t,e,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>E0(r,o,t,e))}function oL(n,t){return n.map((e,i)=>i==0?{}:Bn({},t,e))}function E0(n,t,e,i){return Bn({},t==0?e:i,n)}function SS(n,t,e){return t==null?_l:[t,e]}var aL=SS;function lL(n,t,e){return t==null?_l:Nf(t,e,P0,!0)}function wS(n,t,e,i){return t==null?_l:Ff(t,e,n.scales[i].log,!1)}var cL=wS;function ES(n,t,e,i){return t==null?_l:C0(t,e,n.scales[i].log,!1)}var uL=ES;function hL(n,t,e,i,s){let r=Li(gM(n),gM(t)),o=t-n,a=Bs(s/i*o,e);do{let c=e[a],l=i*c/o;if(l>=s&&r+(c<5?yo.get(c):0)<=17)return[c,l]}while(++a<e.length);return[0,0]}function kM(n){let t,e;return n=n.replace(/(\d+)px/,(i,s)=>(t=Yn((e=+s)*We))+"px"),[n,t,e]}function dL(n){n.show&&[n.font,n.labelFont].forEach(t=>{let e=sn(t[2]*We,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function ai(n,t,e){let i={mode:ke(n.mode,1)},s=i.mode;function r(T,C,F,k){let X=C.valToPct(T);return k+F*(C.dir==-1?1-X:X)}function o(T,C,F,k){let X=C.valToPct(T);return k+F*(C.dir==-1?X:1-X)}function a(T,C,F,k){return C.ori==0?r(T,C,F,k):o(T,C,F,k)}i.valToPosH=r,i.valToPosV=o;let c=!1;i.status=0;let l=i.root=_s(y3);if(n.id!=null&&(l.id=n.id),ss(l,n.class),n.title){let T=_s(M3,l);T.textContent=n.title}let u=Fs("canvas"),h=i.ctx=u.getContext("2d"),d=_s(S3,l);Ko("click",d,T=>{T.target===p&&(ln!=da||_n!=fa)&&si.click(i,T)},!0);let f=i.under=_s(w3,d);d.appendChild(u);let p=i.over=_s(E3,d);n=yl(n);let _=+ke(n.pxAlign,1),m=UM(_);(n.plugins||[]).forEach(T=>{T.opts&&(n=T.opts(i,n)||n)});let g=n.ms||.001,x=i.series=s==1?BM(n.series||[],RM,DM,!1):oL(n.series||[null],LM),S=i.axes=BM(n.axes||[],AM,PM,!0),v=i.scales={},A=i.bands=n.bands||[];A.forEach(T=>{T.fill=Ne(T.fill||null),T.dir=ke(T.dir,-1)});let w=s==2?x[1].facets[0].scale:x[0].scale,y={axes:xr,series:Ce},E=(n.drawOrder||["axes","series"]).map(T=>y[T]);function U(T){let C=T.distr==3?F=>kr(F>0?F:T.clamp(i,F,T.min,T.max,T.key)):T.distr==4?F=>d0(F,T.asinh):T.distr==100?F=>T.fwd(F):F=>F;return F=>{let k=C(F),{_min:X,_max:tt}=T,ht=tt-X;return(k-X)/ht}}function L(T){let C=v[T];if(C==null){let F=(n.scales||xu)[T]||xu;if(F.from!=null){L(F.from);let k=Bn({},v[F.from],F,{key:T});k.valToPct=U(k),v[T]=k}else{C=v[T]=Bn({},T==w?fS:Y2,F),C.key=T;let k=C.time,X=C.range,tt=_o(X);if((T!=w||s==2&&!k)&&(tt&&(X[0]==null||X[1]==null)&&(X={min:X[0]==null?fM:{mode:1,hard:X[0],soft:X[0]},max:X[1]==null?fM:{mode:1,hard:X[1],soft:X[1]}},tt=!1),!tt&&kf(X))){let ht=X;X=(_t,Et,zt)=>Et==null?_l:Nf(Et,zt,ht)}C.range=Ne(X||(k?aL:T==w?C.distr==3?cL:C.distr==4?uL:SS:C.distr==3?wS:C.distr==4?ES:lL)),C.auto=Ne(tt?!1:C.auto),C.clamp=Ne(C.clamp||X2),C._min=C._max=null,C.valToPct=U(C)}}}L("x"),L("y"),s==1&&x.forEach(T=>{L(T.scale)}),S.forEach(T=>{L(T.scale)});for(let T in n.scales)L(T);let N=v[w],H=N.distr,$,P;N.ori==0?(ss(l,v3),$=r,P=o):(ss(l,b3),$=o,P=r);let z={};for(let T in v){let C=v[T];(C.min!=null||C.max!=null)&&(z[T]={min:C.min,max:C.max},C.min=C.max=null)}let D=n.tzDate||(T=>new Date(Yn(T/g))),B=n.fmtDate||D0,Q=g==1?v2(D):S2(D),Y=wM(D,SM(g==1?y2:M2,B)),Z=TM(D,EM(E2,B)),nt=[],dt=i.legend=Bn({},R2,n.legend),ft=i.cursor=Bn({},N2,{drag:{y:s==2}},n.cursor),st=dt.show,yt=ft.show,xt=dt.markers;dt.idxs=nt,xt.width=Ne(xt.width),xt.dash=Ne(xt.dash),xt.stroke=Ne(xt.stroke),xt.fill=Ne(xt.fill);let Tt,At,Jt,ge=[],jt=[],Te,Me=!1,pe={};if(dt.live){let T=x[1]?x[1].values:null;Me=T!=null,Te=Me?T(i,1,0):{_:0};for(let C in Te)pe[C]=A0}if(st)if(Tt=Fs("table",I3,l),Jt=Fs("tbody",null,Tt),dt.mount(i,Tt),Me){At=Fs("thead",null,Tt,Jt);let T=Fs("tr",null,At);Fs("th",null,T);for(var xn in Te)Fs("th",tM,T).textContent=xn}else ss(Tt,D3),dt.live&&ss(Tt,L3);let on={show:!0},In={show:!1};function Je(T,C){if(C==0&&(Me||!dt.live||s==2))return _l;let F=[],k=Fs("tr",N3,Jt,Jt.childNodes[C]);ss(k,T.class),T.show||ss(k,Jo);let X=Fs("th",null,k);if(xt.show){let _t=_s(U3,X);if(C>0){let Et=xt.width(i,C);Et&&(_t.style.border=Et+"px "+xt.dash(i,C)+" "+xt.stroke(i,C)),_t.style.background=xt.fill(i,C)}}let tt=_s(tM,X);T.label instanceof HTMLElement?tt.appendChild(T.label):tt.textContent=T.label,C>0&&(xt.show||(tt.style.color=T.width>0?xt.stroke(i,C):xt.fill(i,C)),Ue("click",X,_t=>{if(ft._lock)return;oe(_t);let Et=x.indexOf(T);if((_t.ctrlKey||_t.metaKey)!=dt.isolate){let zt=x.some((Ht,Wt)=>Wt>0&&Wt!=Et&&Ht.show);x.forEach((Ht,Wt)=>{Wt>0&&$s(Wt,zt?Wt==Et?on:In:on,!0,On.setSeries)})}else $s(Et,{show:!T.show},!0,On.setSeries)},!1),ae&&Ue(sM,X,_t=>{ft._lock||(oe(_t),$s(x.indexOf(T),ma,!0,On.setSeries))},!1));for(var ht in Te){let _t=Fs("td",O3,k);_t.textContent="--",F.push(_t)}return[k,F]}let Zn=new Map;function Ue(T,C,F,k=!0){let X=Zn.get(C)||{},tt=ft.bind[T](i,C,F,k);tt&&(Ko(T,C,X[T]=tt),Zn.set(C,X))}function kn(T,C,F){let k=Zn.get(C)||{};for(let X in k)(T==null||X==T)&&(y0(X,C,k[X]),delete k[X]);T==null&&Zn.delete(C)}let Sn=0,Ln=0,W=0,Nt=0,se=0,xe=0,Ct=se,Qe=xe,Yt=W,ne=Nt,O=0,R=0,j=0,gt=0;i.bbox={};let ct=!1,St=!1,wt=!1,rt=!1,at=!1,vt=!1;function V(T,C,F){(F||T!=i.width||C!=i.height)&&lt(T,C),Se(!1),wt=!0,St=!0,ci()}function lt(T,C){i.width=Sn=W=T,i.height=Ln=Nt=C,se=xe=0,Rt(),Zt();let F=i.bbox;O=F.left=jo(se*We,.5),R=F.top=jo(xe*We,.5),j=F.width=jo(W*We,.5),gt=F.height=jo(Nt*We,.5)}let ot=3;function Pt(){let T=!1,C=0;for(;!T;){C++;let F=ca(C),k=Ws(C);T=C==ot||F&&k,T||(lt(i.width,i.height),St=!0)}}function Mt({width:T,height:C}){V(T,C)}i.setSize=Mt;function Rt(){let T=!1,C=!1,F=!1,k=!1;S.forEach((X,tt)=>{if(X.show&&X._show){let{side:ht,_size:_t}=X,Et=ht%2,zt=X.label!=null?X.labelSize:0,Ht=_t+zt;Ht>0&&(Et?(W-=Ht,ht==3?(se+=Ht,k=!0):F=!0):(Nt-=Ht,ht==0?(xe+=Ht,T=!0):C=!0))}}),Gs[0]=T,Gs[1]=F,Gs[2]=C,Gs[3]=k,W-=bs[1]+bs[3],se+=bs[3],Nt-=bs[2]+bs[0],xe+=bs[0]}function Zt(){let T=se+W,C=xe+Nt,F=se,k=xe;function X(tt,ht){switch(tt){case 1:return T+=ht,T-ht;case 2:return C+=ht,C-ht;case 3:return F-=ht,F+ht;case 0:return k-=ht,k+ht}}S.forEach((tt,ht)=>{if(tt.show&&tt._show){let _t=tt.side;tt._pos=X(_t,tt._size),tt.label!=null&&(tt._lpos=X(_t,tt.labelSize))}})}if(ft.dataIdx==null){let T=ft.hover,C=T.skip=new Set(T.skip??[]);C.add(void 0);let F=T.prox=Ne(T.prox),k=T.bias??=0;ft.dataIdx=(X,tt,ht,_t)=>{if(tt==0)return ht;let Et=ht,zt=F(X,tt,ht,_t)??nn,Ht=zt>=0&&zt<nn,Wt=N.ori==0?W:Nt,me=ft.left,ze=t[0],Fe=t[tt];if(C.has(Fe[ht])){Et=null;let Pe=null,re=null,Kt;if(k==0||k==-1)for(Kt=ht;Pe==null&&Kt-- >0;)C.has(Fe[Kt])||(Pe=Kt);if(k==0||k==1)for(Kt=ht;re==null&&Kt++<Fe.length;)C.has(Fe[Kt])||(re=Kt);if(Pe!=null||re!=null)if(Ht){let un=Pe==null?-1/0:$(ze[Pe],N,Wt,0),Tn=re==null?1/0:$(ze[re],N,Wt,0),ti=me-un,Ke=Tn-me;ti<=Ke?ti<=zt&&(Et=Pe):Ke<=zt&&(Et=re)}else Et=re==null?Pe:Pe==null?re:ht-Pe<=re-ht?Pe:re}else Ht&&jn(me-$(ze[ht],N,Wt,0))>zt&&(Et=null);return Et}}let oe=T=>{ft.event=T};ft.idxs=nt,ft._lock=!1;let pt=ft.points;pt.show=Ne(pt.show),pt.size=Ne(pt.size),pt.stroke=Ne(pt.stroke),pt.width=Ne(pt.width),pt.fill=Ne(pt.fill);let $t=i.focus=Bn({},n.focus||{alpha:.3},ft.focus),ae=$t.prox>=0,Dt=ae&&pt.one,ye=[],an=[],_i=[];function Hl(T,C){let F=pt.show(i,C);if(F instanceof HTMLElement)return ss(F,P3),ss(F,T.class),hr(F,-10,-10,W,Nt),p.insertBefore(F,ye[C]),F}function oa(T,C){if(s==1||C>0){let F=s==1&&v[T.scale].time,k=T.value;T.value=F?yM(k)?TM(D,EM(k,B)):k||Z:k||W2,T.label=T.label||(F?O2:U2)}if(Dt||C>0){T.width=T.width==null?1:T.width,T.paths=T.paths||sL||Y3,T.fillTo=Ne(T.fillTo||j2),T.pxAlign=+ke(T.pxAlign,_),T.pxRound=UM(T.pxAlign),T.stroke=Ne(T.stroke||null),T.fill=Ne(T.fill||null),T._stroke=T._fill=T._paths=T._focus=null;let F=$2(Li(1,T.width),1),k=T.points=Bn({},{size:F,width:Li(1,F*.2),stroke:T.stroke,space:F*2,paths:rL,_stroke:null,_fill:null},T.points);k.show=Ne(k.show),k.filter=Ne(k.filter),k.fill=Ne(k.fill),k.stroke=Ne(k.stroke),k.paths=Ne(k.paths),k.pxAlign=T.pxAlign}if(st){let F=Je(T,C);ge.splice(C,0,F[0]),jt.splice(C,0,F[1]),dt.values.push(null)}if(yt){nt.splice(C,0,null);let F=null;Dt?C==0&&(F=Hl(T,C)):C>0&&(F=Hl(T,C)),ye.splice(C,0,F),an.splice(C,0,0),_i.splice(C,0,0)}Qn("addSeries",C)}function Ep(T,C){C=C??x.length,T=s==1?E0(T,C,RM,DM):E0(T,C,{},LM),x.splice(C,0,T),oa(x[C],C)}i.addSeries=Ep;function Cu(T){if(x.splice(T,1),st){dt.values.splice(T,1),jt.splice(T,1);let C=ge.splice(T,1)[0];kn(null,C.firstChild),C.remove()}yt&&(nt.splice(T,1),ye.splice(T,1)[0].remove(),an.splice(T,1),_i.splice(T,1)),Qn("delSeries",T)}i.delSeries=Cu;let Gs=[!1,!1,!1,!1];function pr(T,C){if(T._show=T.show,T.show){let F=T.side%2,k=v[T.scale];k==null&&(T.scale=F?x[1].scale:w,k=v[T.scale]);let X=k.time;T.size=Ne(T.size),T.space=Ne(T.space),T.rotate=Ne(T.rotate),_o(T.incrs)&&T.incrs.forEach(ht=>{!yo.has(ht)&&yo.set(ht,YM(ht))}),T.incrs=Ne(T.incrs||(k.distr==2?g2:X?g==1?_2:b2:Zo)),T.splits=Ne(T.splits||(X&&k.distr==1?Q:k.distr==3?b0:k.distr==4?k2:B2)),T.stroke=Ne(T.stroke),T.grid.stroke=Ne(T.grid.stroke),T.ticks.stroke=Ne(T.ticks.stroke),T.border.stroke=Ne(T.border.stroke);let tt=T.values;T.values=_o(tt)&&!_o(tt[0])?Ne(tt):X?_o(tt)?wM(D,SM(tt,B)):yM(tt)?w2(D,tt):tt||Y:tt||F2,T.filter=Ne(T.filter||(k.distr>=3&&k.log==10?G2:k.distr==3&&k.log==2?V2:qM)),T.font=kM(T.font),T.labelFont=kM(T.labelFont),T._size=T.size(i,null,C,0),T._space=T._rotate=T._incrs=T._found=T._splits=T._values=null,T._size>0&&(Gs[C]=!0,T._el=_s(T3,d))}}function mr(T,C,F,k){let[X,tt,ht,_t]=F,Et=C%2,zt=0;return Et==0&&(_t||tt)&&(zt=C==0&&!X||C==2&&!ht?Yn(AM.size/3):0),Et==1&&(X||ht)&&(zt=C==1&&!tt||C==3&&!_t?Yn(PM.size/2):0),zt}let Gl=i.padding=(n.padding||[mr,mr,mr,mr]).map(T=>Ne(ke(T,mr))),bs=i._padding=Gl.map((T,C)=>T(i,C,Gs,0)),wn,Cn=null,Pn=null,Vs=s==1?x[0].idxs:null,qi=null,Vr=!1;function Vl(T,C){if(t=T??[],i.data=i._data=t,s==2){wn=0;for(let F=1;F<x.length;F++)wn+=t[F][0].length}else{t.length==0&&(i.data=i._data=t=[[]]),qi=t[0],wn=qi.length;let F=t;if(H==2){F=t.slice();let k=F[0]=Array(wn);for(let X=0;X<wn;X++)k[X]=X}i._data=t=F}if(Se(!0),Qn("setData"),H==2&&(wt=!0),C!==!1){let F=N;F.auto(i,Vr)?Wl():qr(w,F.min,F.max),rt=rt||ft.left>=0,vt=!0,ci()}}i.setData=Vl;function Wl(){Vr=!0;let T,C;s==1&&(wn>0?(Cn=Vs[0]=0,Pn=Vs[1]=wn-1,T=t[0][Cn],C=t[0][Pn],H==2?(T=Cn,C=Pn):T==C&&(H==3?[T,C]=Ff(T,T,N.log,!1):H==4?[T,C]=C0(T,T,N.log,!1):N.time?C=T+Yn(86400/g):[T,C]=Nf(T,C,P0,!0))):(Cn=Vs[0]=T=null,Pn=Vs[1]=C=null)),qr(w,T,C)}let aa,Wr,la,I,q,it,J,K,It,Ot;function Lt(T,C,F,k,X,tt){T??=nM,F??=L0,k??="butt",X??=nM,tt??="round",T!=aa&&(h.strokeStyle=aa=T),X!=Wr&&(h.fillStyle=Wr=X),C!=la&&(h.lineWidth=la=C),tt!=q&&(h.lineJoin=q=tt),k!=it&&(h.lineCap=it=k),F!=I&&h.setLineDash(I=F)}function Bt(T,C,F,k){C!=Wr&&(h.fillStyle=Wr=C),T!=J&&(h.font=J=T),F!=K&&(h.textAlign=K=F),k!=It&&(h.textBaseline=It=k)}function Xt(T,C,F,k,X=0){if(k.length>0&&T.auto(i,Vr)&&(C==null||C.min==null)){let tt=ke(Cn,0),ht=ke(Pn,k.length-1),_t=F.min==null?G3(k,tt,ht,X,T.distr==3):[F.min,F.max];T.min=ks(T.min,F.min=_t[0]),T.max=Li(T.max,F.max=_t[1])}}let ue={min:null,max:null};function Re(){for(let k in v){let X=v[k];z[k]==null&&(X.min==null||z[w]!=null&&X.auto(i,Vr))&&(z[k]=ue)}for(let k in v){let X=v[k];z[k]==null&&X.from!=null&&z[X.from]!=null&&(z[k]=ue)}z[w]!=null&&Se(!0);let T={};for(let k in z){let X=z[k];if(X!=null){let tt=T[k]=yl(v[k],J3);if(X.min!=null)Bn(tt,X);else if(k!=w||s==2)if(wn==0&&tt.from==null){let ht=tt.range(i,null,null,k);tt.min=ht[0],tt.max=ht[1]}else tt.min=nn,tt.max=-nn}}if(wn>0){x.forEach((k,X)=>{if(s==1){let tt=k.scale,ht=z[tt];if(ht==null)return;let _t=T[tt];if(X==0){let Et=_t.range(i,_t.min,_t.max,tt);_t.min=Et[0],_t.max=Et[1],Cn=Bs(_t.min,t[0]),Pn=Bs(_t.max,t[0]),Pn-Cn>1&&(t[0][Cn]<_t.min&&Cn++,t[0][Pn]>_t.max&&Pn--),k.min=qi[Cn],k.max=qi[Pn]}else k.show&&k.auto&&Xt(_t,ht,k,t[X],k.sorted);k.idxs[0]=Cn,k.idxs[1]=Pn}else if(X>0&&k.show&&k.auto){let[tt,ht]=k.facets,_t=tt.scale,Et=ht.scale,[zt,Ht]=t[X],Wt=T[_t],me=T[Et];Wt!=null&&Xt(Wt,z[_t],tt,zt,tt.sorted),me!=null&&Xt(me,z[Et],ht,Ht,ht.sorted),k.min=ht.min,k.max=ht.max}});for(let k in T){let X=T[k],tt=z[k];if(X.from==null&&(tt==null||tt.min==null)){let ht=X.range(i,X.min==nn?null:X.min,X.max==-nn?null:X.max,k);X.min=ht[0],X.max=ht[1]}}}for(let k in T){let X=T[k];if(X.from!=null){let tt=T[X.from];if(tt.min==null)X.min=X.max=null;else{let ht=X.range(i,tt.min,tt.max,k);X.min=ht[0],X.max=ht[1]}}}let C={},F=!1;for(let k in T){let X=T[k],tt=v[k];if(tt.min!=X.min||tt.max!=X.max){tt.min=X.min,tt.max=X.max;let ht=tt.distr;tt._min=ht==3?kr(tt.min):ht==4?d0(tt.min,tt.asinh):ht==100?tt.fwd(tt.min):tt.min,tt._max=ht==3?kr(tt.max):ht==4?d0(tt.max,tt.asinh):ht==100?tt.fwd(tt.max):tt.max,C[k]=F=!0}}if(F){x.forEach((k,X)=>{s==2?X>0&&C.y&&(k._paths=null):C[k.scale]&&(k._paths=null)});for(let k in C)wt=!0,Qn("setScale",k);yt&&ft.left>=0&&(rt=vt=!0)}for(let k in z)z[k]=null}function qt(T){let C=v0(Cn-1,0,wn-1),F=v0(Pn+1,0,wn-1);for(;T[C]==null&&C>0;)C--;for(;T[F]==null&&F<wn-1;)F++;return[C,F]}function Ce(){if(wn>0){let T=x.some(C=>C._focus)&&Ot!=$t.alpha;T&&(h.globalAlpha=Ot=$t.alpha),x.forEach((C,F)=>{if(F>0&&C.show&&(vn(F,!1),vn(F,!0),C._paths==null)){let k=Ot;Ot!=C.alpha&&(h.globalAlpha=Ot=C.alpha);let X=s==2?[0,t[F][0].length-1]:qt(t[F]);C._paths=C.paths(i,F,X[0],X[1]),Ot!=k&&(h.globalAlpha=Ot=k)}}),x.forEach((C,F)=>{if(F>0&&C.show){let k=Ot;Ot!=C.alpha&&(h.globalAlpha=Ot=C.alpha),C._paths!=null&&Xe(F,!1);{let X=C._paths!=null?C._paths.gaps:null,tt=C.points.show(i,F,Cn,Pn,X),ht=C.points.filter(i,F,tt,X);(tt||ht)&&(C.points._paths=C.points.paths(i,F,Cn,Pn,ht),Xe(F,!0))}Ot!=k&&(h.globalAlpha=Ot=k),Qn("drawSeries",F)}}),T&&(h.globalAlpha=Ot=1)}}function vn(T,C){let F=C?x[T].points:x[T];F._stroke=F.stroke(i,T),F._fill=F.fill(i,T)}function Xe(T,C){let F=C?x[T].points:x[T],{stroke:k,fill:X,clip:tt,flags:ht,_stroke:_t=F._stroke,_fill:Et=F._fill,_width:zt=F.width}=F._paths;zt=sn(zt*We,3);let Ht=null,Wt=zt%2/2;C&&Et==null&&(Et=zt>0?"#fff":_t);let me=F.pxAlign==1&&Wt>0;if(me&&h.translate(Wt,Wt),!C){let ze=O-zt/2,Fe=R-zt/2,Pe=j+zt,re=gt+zt;Ht=new Path2D,Ht.rect(ze,Fe,Pe,re)}C?Vt(_t,zt,F.dash,F.cap,Et,k,X,ht,tt):Ye(T,_t,zt,F.dash,F.cap,Et,k,X,ht,Ht,tt),me&&h.translate(-Wt,-Wt)}function Ye(T,C,F,k,X,tt,ht,_t,Et,zt,Ht){let Wt=!1;Et!=0&&A.forEach((me,ze)=>{if(me.series[0]==T){let Fe=x[me.series[1]],Pe=t[me.series[1]],re=(Fe._paths||xu).band;_o(re)&&(re=me.dir==1?re[0]:re[1]);let Kt,un=null;Fe.show&&re&&W3(Pe,Cn,Pn)?(un=me.fill(i,ze)||tt,Kt=Fe._paths.clip):re=null,Vt(C,F,k,X,un,ht,_t,Et,zt,Ht,Kt,re),Wt=!0}}),Wt||Vt(C,F,k,X,tt,ht,_t,Et,zt,Ht)}let zn=vl|S0;function Vt(T,C,F,k,X,tt,ht,_t,Et,zt,Ht,Wt){Lt(T,C,F,k,X),(Et||zt||Wt)&&(h.save(),Et&&h.clip(Et),zt&&h.clip(zt)),Wt?(_t&zn)==zn?(h.clip(Wt),Ht&&h.clip(Ht),Le(X,ht),Dn(T,tt,C)):_t&S0?(Le(X,ht),h.clip(Wt),Dn(T,tt,C)):_t&vl&&(h.save(),h.clip(Wt),Ht&&h.clip(Ht),Le(X,ht),h.restore(),Dn(T,tt,C)):(Le(X,ht),Dn(T,tt,C)),(Et||zt||Wt)&&h.restore()}function Dn(T,C,F){F>0&&(C instanceof Map?C.forEach((k,X)=>{h.strokeStyle=aa=X,h.stroke(k)}):C!=null&&T&&h.stroke(C))}function Le(T,C){C instanceof Map?C.forEach((F,k)=>{h.fillStyle=Wr=k,h.fill(F)}):C!=null&&T&&h.fill(C)}function gr(T,C,F,k){let X=S[T],tt;if(k<=0)tt=[0,0];else{let ht=X._space=X.space(i,T,C,F,k),_t=X._incrs=X.incrs(i,T,C,F,k,ht);tt=hL(C,F,_t,k,ht)}return X._found=tt}function Nn(T,C,F,k,X,tt,ht,_t,Et,zt){let Ht=ht%2/2;_==1&&h.translate(Ht,Ht),Lt(_t,ht,Et,zt,_t),h.beginPath();let Wt,me,ze,Fe,Pe=X+(k==0||k==3?-tt:tt);F==0?(me=X,Fe=Pe):(Wt=X,ze=Pe);for(let re=0;re<T.length;re++)C[re]!=null&&(F==0?Wt=ze=T[re]:me=Fe=T[re],h.moveTo(Wt,me),h.lineTo(ze,Fe));h.stroke(),_==1&&h.translate(-Ht,-Ht)}function ca(T){let C=!0;return S.forEach((F,k)=>{if(!F.show)return;let X=v[F.scale];if(X.min==null){F._show&&(C=!1,F._show=!1,Se(!1));return}else F._show||(C=!1,F._show=!0,Se(!1));let tt=F.side,ht=tt%2,{min:_t,max:Et}=X,[zt,Ht]=gr(k,_t,Et,ht==0?W:Nt);if(Ht==0)return;let Wt=X.distr==2,me=F._splits=F.splits(i,k,_t,Et,zt,Ht,Wt),ze=X.distr==2?me.map(Kt=>qi[Kt]):me,Fe=X.distr==2?qi[me[1]]-qi[me[0]]:zt,Pe=F._values=F.values(i,F.filter(i,ze,k,Ht,Fe),k,Ht,Fe);F._rotate=tt==2?F.rotate(i,Pe,k,Ht):0;let re=F._size;F._size=ys(F.size(i,Pe,k,T)),re!=null&&F._size!=re&&(C=!1)}),C}function Ws(T){let C=!0;return Gl.forEach((F,k)=>{let X=F(i,k,Gs,T);X!=bs[k]&&(C=!1),bs[k]=X}),C}function xr(){for(let T=0;T<S.length;T++){let C=S[T];if(!C.show||!C._show)continue;let F=C.side,k=F%2,X,tt,ht=C.stroke(i,T),_t=F==0||F==3?-1:1,[Et,zt]=C._found;if(C.label!=null){let bi=C.labelGap*_t,ji=Yn((C._lpos+bi)*We);Bt(C.labelFont[0],ht,"center",F==2?"top":eM),h.save(),k==1?(X=tt=0,h.translate(ji,Yn(R+gt/2)),h.rotate((F==3?-Lf:Lf)/2)):(X=Yn(O+j/2),tt=ji);let Io=WM(C.label)?C.label(i,T,Et,zt):C.label;h.fillText(Io,X,tt),h.restore()}if(zt==0)continue;let Ht=v[C.scale],Wt=k==0?j:gt,me=k==0?O:R,ze=C._splits,Fe=Ht.distr==2?ze.map(bi=>qi[bi]):ze,Pe=Ht.distr==2?qi[ze[1]]-qi[ze[0]]:Et,re=C.ticks,Kt=C.border,un=re.show?re.size:0,Tn=Yn(un*We),ti=Yn((C.alignTo==2?C._size-un-C.gap:C.gap)*We),Ke=C._rotate*-Lf/180,An=m(C._pos*We),Xi=(Tn+ti)*_t,vi=An+Xi;tt=k==0?vi:0,X=k==1?vi:0;let ls=C.font[0],Ms=C.align==1?pl:C.align==2?c0:Ke>0?pl:Ke<0?c0:k==0?"center":F==3?c0:pl,Xs=Ke||k==1?"middle":F==2?"top":eM;Bt(ls,ht,Ms,Xs);let Yi=C.font[1]*C.lineGap,cs=ze.map(bi=>m(a(bi,Ht,Wt,me))),Ss=C._values;for(let bi=0;bi<Ss.length;bi++){let ji=Ss[bi];if(ji!=null){k==0?X=cs[bi]:tt=cs[bi],ji=""+ji;let Io=ji.indexOf(`
`)==-1?[ji]:ji.split(/\n/gm);for(let Mi=0;Mi<Io.length;Mi++){let $x=Io[Mi];Ke?(h.save(),h.translate(X,tt+Mi*Yi),h.rotate(Ke),h.fillText($x,0,0),h.restore()):h.fillText($x,X,tt+Mi*Yi)}}}re.show&&Nn(cs,re.filter(i,Fe,T,zt,Pe),k,F,An,Tn,sn(re.width*We,3),re.stroke(i,T),re.dash,re.cap);let Ys=C.grid;Ys.show&&Nn(cs,Ys.filter(i,Fe,T,zt,Pe),k,k==0?2:1,k==0?R:O,k==0?gt:j,sn(Ys.width*We,3),Ys.stroke(i,T),Ys.dash,Ys.cap),Kt.show&&Nn([An],[1],k==0?1:0,k==0?1:2,k==1?R:O,k==1?gt:j,sn(Kt.width*We,3),Kt.stroke(i,T),Kt.dash,Kt.cap)}Qn("drawAxes")}function Se(T){x.forEach((C,F)=>{F>0&&(C._paths=null,T&&(s==1?(C.min=null,C.max=null):C.facets.forEach(k=>{k.min=null,k.max=null})))})}let En=!1,yi=!1,je=[];function Un(){yi=!1;for(let T=0;T<je.length;T++)Qn(...je[T]);je.length=0}function ci(){En||(s2(Ax),En=!0)}function Pu(T,C=!1){En=!0,yi=C,T(i),Ax(),C&&je.length>0&&queueMicrotask(Un)}i.batch=Pu;function Ax(){if(ct&&(Re(),ct=!1),wt&&(Pt(),wt=!1),St){if(gn(f,pl,se),gn(f,"top",xe),gn(f,fu,W),gn(f,pu,Nt),gn(p,pl,se),gn(p,"top",xe),gn(p,fu,W),gn(p,pu,Nt),gn(d,fu,Sn),gn(d,pu,Ln),u.width=Yn(Sn*We),u.height=Yn(Ln*We),S.forEach(({_el:T,_show:C,_size:F,_pos:k,side:X})=>{if(T!=null)if(C){let tt=X===3||X===0?F:0,ht=X%2==1;gn(T,ht?"left":"top",k-tt),gn(T,ht?"width":"height",F),gn(T,ht?"top":"left",ht?xe:se),gn(T,ht?"height":"width",ht?Nt:W),_0(T,Jo)}else ss(T,Jo)}),aa=Wr=la=q=it=J=K=It=I=null,Ot=1,Xl(!0),se!=Ct||xe!=Qe||W!=Yt||Nt!=ne){Se(!1);let T=W/Yt,C=Nt/ne;if(yt&&!rt&&ft.left>=0){ft.left*=T,ft.top*=C,ua&&hr(ua,Yn(ft.left),0,W,Nt),ha&&hr(ha,0,Yn(ft.top),W,Nt);for(let F=0;F<ye.length;F++){let k=ye[F];k!=null&&(an[F]*=T,_i[F]*=C,hr(k,ys(an[F]),ys(_i[F]),W,Nt))}}if(cn.show&&!at&&cn.left>=0&&cn.width>0){cn.left*=T,cn.width*=T,cn.top*=C,cn.height*=C;for(let F in Ip)gn(pa,F,cn[F])}Ct=se,Qe=xe,Yt=W,ne=Nt}Qn("setSize"),St=!1}Sn>0&&Ln>0&&(h.clearRect(0,0,u.width,u.height),Qn("drawClear"),E.forEach(T=>T()),Qn("draw")),cn.show&&at&&(Iu(cn),at=!1),yt&&rt&&(Po(null,!0,!1),rt=!1),dt.show&&dt.live&&vt&&(Cp(),vt=!1),c||(c=!0,i.status=1,Qn("ready")),Vr=!1,En=!1}i.redraw=(T,C)=>{wt=C||!1,T!==!1?qr(w,N.min,N.max):ci()};function Tp(T,C){let F=v[T];if(F.from==null){if(wn==0){let k=F.range(i,C.min,C.max,T);C.min=k[0],C.max=k[1]}if(C.min>C.max){let k=C.min;C.min=C.max,C.max=k}if(wn>1&&C.min!=null&&C.max!=null&&C.max-C.min<1e-16)return;T==w&&F.distr==2&&wn>0&&(C.min=Bs(C.min,t[0]),C.max=Bs(C.max,t[0]),C.min==C.max&&C.max++),z[T]=C,ct=!0,ci()}}i.setScale=Tp;let Ap,Rp,ua,ha,Rx,Cx,da,fa,Px,Ix,ln,_n,$r=!1,si=ft.drag,Jn=si.x,Kn=si.y;yt&&(ft.x&&(Ap=_s(R3,p)),ft.y&&(Rp=_s(C3,p)),N.ori==0?(ua=Ap,ha=Rp):(ua=Rp,ha=Ap),ln=ft.left,_n=ft.top);let cn=i.select=Bn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),pa=cn.show?_s(A3,cn.over?p:f):null;function Iu(T,C){if(cn.show){for(let F in T)cn[F]=T[F],F in Ip&&gn(pa,F,T[F]);C!==!1&&Qn("setSelect")}}i.setSelect=Iu;function C1(T){if(x[T].show)st&&_0(ge[T],Jo);else if(st&&ss(ge[T],Jo),yt){let F=Dt?ye[0]:ye[T];F!=null&&hr(F,-10,-10,W,Nt)}}function qr(T,C,F){Tp(T,{min:C,max:F})}function $s(T,C,F,k){C.focus!=null&&N1(T),C.show!=null&&x.forEach((X,tt)=>{tt>0&&(T==tt||T==null)&&(X.show=C.show,C1(tt),s==2?(qr(X.facets[0].scale,null,null),qr(X.facets[1].scale,null,null)):qr(X.scale,null,null),ci())}),F!==!1&&Qn("setSeries",T,C),k&&Yl("setSeries",i,T,C)}i.setSeries=$s;function P1(T,C){Bn(A[T],C)}function I1(T,C){T.fill=Ne(T.fill||null),T.dir=ke(T.dir,-1),C=C??A.length,A.splice(C,0,T)}function L1(T){T==null?A.length=0:A.splice(T,1)}i.addBand=I1,i.setBand=P1,i.delBand=L1;function D1(T,C){x[T].alpha=C,yt&&ye[T]!=null&&(ye[T].style.opacity=C),st&&ge[T]&&(ge[T].style.opacity=C)}let _r,Xr,Co,ma={focus:!0};function N1(T){if(T!=Co){let C=T==null,F=$t.alpha!=1;x.forEach((k,X)=>{if(s==1||X>0){let tt=C||X==0||X==T;k._focus=C?null:tt,F&&D1(X,tt?1:$t.alpha)}}),Co=T,F&&ci()}}st&&ae&&Ue(rM,Tt,T=>{ft._lock||(oe(T),Co!=null&&$s(null,ma,!0,On.setSeries))});function qs(T,C,F){let k=v[C];F&&(T=T/We-(k.ori==1?xe:se));let X=W;k.ori==1&&(X=Nt,T=X-T),k.dir==-1&&(T=X-T);let tt=k._min,ht=k._max,_t=T/X,Et=tt+(ht-tt)*_t,zt=k.distr;return zt==3?xl(10,Et):zt==4?q3(Et,k.asinh):zt==100?k.bwd(Et):Et}function U1(T,C){let F=qs(T,w,C);return Bs(F,t[0],Cn,Pn)}i.valToIdx=T=>Bs(T,t[0]),i.posToIdx=U1,i.posToVal=qs,i.valToPos=(T,C,F)=>v[C].ori==0?r(T,v[C],F?j:W,F?O:0):o(T,v[C],F?gt:Nt,F?R:0),i.setCursor=(T,C,F)=>{ln=T.left,_n=T.top,Po(null,C,F)};function Lx(T,C){gn(pa,pl,cn.left=T),gn(pa,fu,cn.width=C)}function Dx(T,C){gn(pa,"top",cn.top=T),gn(pa,pu,cn.height=C)}let $l=N.ori==0?Lx:Dx,ql=N.ori==1?Lx:Dx;function O1(){if(st&&dt.live)for(let T=s==2?1:0;T<x.length;T++){if(T==0&&Me)continue;let C=dt.values[T],F=0;for(let k in C)jt[T][F++].firstChild.nodeValue=C[k]}}function Cp(T,C){if(T!=null&&(T.idxs?T.idxs.forEach((F,k)=>{nt[k]=F}):Z3(T.idx)||nt.fill(T.idx),dt.idx=nt[0]),st&&dt.live){for(let F=0;F<x.length;F++)(F>0||s==1&&!Me)&&F1(F,nt[F]);O1()}vt=!1,C!==!1&&Qn("setLegend")}i.setLegend=Cp;function F1(T,C){let F=x[T],k=T==0&&H==2?qi:t[T],X;Me?X=F.values(i,T,C)??pe:(X=F.value(i,C==null?null:k[C],T,C),X=X==null?pe:{_:X}),dt.values[T]=X}function Po(T,C,F){Px=ln,Ix=_n,[ln,_n]=ft.move(i,ln,_n),ft.left=ln,ft.top=_n,yt&&(ua&&hr(ua,Yn(ln),0,W,Nt),ha&&hr(ha,0,Yn(_n),W,Nt));let k,X=Cn>Pn;_r=nn,Xr=null;let tt=N.ori==0?W:Nt,ht=N.ori==1?W:Nt;if(ln<0||wn==0||X){k=ft.idx=null;for(let _t=0;_t<x.length;_t++){let Et=ye[_t];Et!=null&&hr(Et,-10,-10,W,Nt)}ae&&$s(null,ma,!0,T==null&&On.setSeries),dt.live&&(nt.fill(k),vt=!0)}else{let _t,Et,zt;s==1&&(_t=N.ori==0?ln:_n,Et=qs(_t,w),k=ft.idx=Bs(Et,t[0],Cn,Pn),zt=$(t[0][k],N,tt,0));let Ht=-10,Wt=-10,me=0,ze=0,Fe=!0,Pe="",re="";for(let Kt=s==2?1:0;Kt<x.length;Kt++){let un=x[Kt],Tn=nt[Kt],ti=Tn==null?null:s==1?t[Kt][Tn]:t[Kt][1][Tn],Ke=ft.dataIdx(i,Kt,k,Et),An=Ke==null?null:s==1?t[Kt][Ke]:t[Kt][1][Ke];if(vt=vt||An!=ti||Ke!=Tn,nt[Kt]=Ke,Kt>0&&un.show){let Xi=Ke==null?-10:Ke==k?zt:$(s==1?t[0][Ke]:t[Kt][0][Ke],N,tt,0),vi=An==null?-10:P(An,s==1?v[un.scale]:v[un.facets[1].scale],ht,0);if(ae&&An!=null){let ls=N.ori==1?ln:_n,Ms=jn($t.dist(i,Kt,Ke,vi,ls));if(Ms<_r){let Xs=$t.bias;if(Xs!=0){let Yi=qs(ls,un.scale),cs=An>=0?1:-1,Ss=Yi>=0?1:-1;Ss==cs&&(Ss==1?Xs==1?An>=Yi:An<=Yi:Xs==1?An<=Yi:An>=Yi)&&(_r=Ms,Xr=Kt)}else _r=Ms,Xr=Kt}}if(vt||Dt){let ls,Ms;N.ori==0?(ls=Xi,Ms=vi):(ls=vi,Ms=Xi);let Xs,Yi,cs,Ss,Ys,bi,ji=!0,Io=pt.bbox;if(Io!=null){ji=!1;let Mi=Io(i,Kt);cs=Mi.left,Ss=Mi.top,Xs=Mi.width,Yi=Mi.height}else cs=ls,Ss=Ms,Xs=Yi=pt.size(i,Kt);if(bi=pt.fill(i,Kt),Ys=pt.stroke(i,Kt),Dt)Kt==Xr&&_r<=$t.prox&&(Ht=cs,Wt=Ss,me=Xs,ze=Yi,Fe=ji,Pe=bi,re=Ys);else{let Mi=ye[Kt];Mi!=null&&(an[Kt]=cs,_i[Kt]=Ss,dM(Mi,Xs,Yi,ji),uM(Mi,bi,Ys),hr(Mi,ys(cs),ys(Ss),W,Nt))}}}}if(Dt){let Kt=$t.prox,un=Co==null?_r<=Kt:_r>Kt||Xr!=Co;if(vt||un){let Tn=ye[0];Tn!=null&&(an[0]=Ht,_i[0]=Wt,dM(Tn,me,ze,Fe),uM(Tn,Pe,re),hr(Tn,ys(Ht),ys(Wt),W,Nt))}}}if(cn.show&&$r)if(T!=null){let[_t,Et]=On.scales,[zt,Ht]=On.match,[Wt,me]=T.cursor.sync.scales,ze=T.cursor.drag;if(Jn=ze._x,Kn=ze._y,Jn||Kn){let{left:Fe,top:Pe,width:re,height:Kt}=T.select,un=T.scales[Wt].ori,Tn=T.posToVal,ti,Ke,An,Xi,vi,ls=_t!=null&&zt(_t,Wt),Ms=Et!=null&&Ht(Et,me);ls&&Jn?(un==0?(ti=Fe,Ke=re):(ti=Pe,Ke=Kt),An=v[_t],Xi=$(Tn(ti,Wt),An,tt,0),vi=$(Tn(ti+Ke,Wt),An,tt,0),$l(ks(Xi,vi),jn(vi-Xi))):$l(0,tt),Ms&&Kn?(un==1?(ti=Fe,Ke=re):(ti=Pe,Ke=Kt),An=v[Et],Xi=P(Tn(ti,me),An,ht,0),vi=P(Tn(ti+Ke,me),An,ht,0),ql(ks(Xi,vi),jn(vi-Xi))):ql(0,ht)}else Lp()}else{let _t=jn(Px-Rx),Et=jn(Ix-Cx);if(N.ori==1){let me=_t;_t=Et,Et=me}Jn=si.x&&_t>=si.dist,Kn=si.y&&Et>=si.dist;let zt=si.uni;zt!=null?Jn&&Kn&&(Jn=_t>=zt,Kn=Et>=zt,!Jn&&!Kn&&(Et>_t?Kn=!0:Jn=!0)):si.x&&si.y&&(Jn||Kn)&&(Jn=Kn=!0);let Ht,Wt;Jn&&(N.ori==0?(Ht=da,Wt=ln):(Ht=fa,Wt=_n),$l(ks(Ht,Wt),jn(Wt-Ht)),Kn||ql(0,ht)),Kn&&(N.ori==1?(Ht=da,Wt=ln):(Ht=fa,Wt=_n),ql(ks(Ht,Wt),jn(Wt-Ht)),Jn||$l(0,tt)),!Jn&&!Kn&&($l(0,0),ql(0,0))}if(si._x=Jn,si._y=Kn,T==null){if(F){if(Wx!=null){let[_t,Et]=On.scales;On.values[0]=_t!=null?qs(N.ori==0?ln:_n,_t):null,On.values[1]=Et!=null?qs(N.ori==1?ln:_n,Et):null}Yl(u0,i,ln,_n,W,Nt,k)}if(ae){let _t=F&&On.setSeries,Et=$t.prox;Co==null?_r<=Et&&$s(Xr,ma,!0,_t):_r>Et?$s(null,ma,!0,_t):Xr!=Co&&$s(Xr,ma,!0,_t)}}vt&&(dt.idx=k,Cp()),C!==!1&&Qn("setCursor")}let Yr=null;Object.defineProperty(i,"rect",{get(){return Yr==null&&Xl(!1),Yr}});function Xl(T=!1){T?Yr=null:(Yr=p.getBoundingClientRect(),Qn("syncRect",Yr))}function Nx(T,C,F,k,X,tt,ht){ft._lock||$r&&T!=null&&T.movementX==0&&T.movementY==0||(Pp(T,C,F,k,X,tt,ht,!1,T!=null),T!=null?Po(null,!0,!0):Po(C,!0,!1))}function Pp(T,C,F,k,X,tt,ht,_t,Et){if(Yr==null&&Xl(!1),oe(T),T!=null)F=T.clientX-Yr.left,k=T.clientY-Yr.top;else{if(F<0||k<0){ln=-10,_n=-10;return}let[zt,Ht]=On.scales,Wt=C.cursor.sync,[me,ze]=Wt.values,[Fe,Pe]=Wt.scales,[re,Kt]=On.match,un=C.axes[0].side%2==1,Tn=N.ori==0?W:Nt,ti=N.ori==1?W:Nt,Ke=un?tt:X,An=un?X:tt,Xi=un?k:F,vi=un?F:k;if(Fe!=null?F=re(zt,Fe)?a(me,v[zt],Tn,0):-10:F=Tn*(Xi/Ke),Pe!=null?k=Kt(Ht,Pe)?a(ze,v[Ht],ti,0):-10:k=ti*(vi/An),N.ori==1){let ls=F;F=k,k=ls}}Et&&(C==null||C.cursor.event.type==u0)&&((F<=1||F>=W-1)&&(F=jo(F,W)),(k<=1||k>=Nt-1)&&(k=jo(k,Nt))),_t?(Rx=F,Cx=k,[da,fa]=ft.move(i,F,k)):(ln=F,_n=k)}let Ip={width:0,height:0,left:0,top:0};function Lp(){Iu(Ip,!1)}let Ux,Ox,Fx,Bx;function kx(T,C,F,k,X,tt,ht){$r=!0,Jn=Kn=si._x=si._y=!1,Pp(T,C,F,k,X,tt,ht,!0,!1),T!=null&&(Ue(h0,g0,zx,!1),Yl(iM,i,da,fa,W,Nt,null));let{left:_t,top:Et,width:zt,height:Ht}=cn;Ux=_t,Ox=Et,Fx=zt,Bx=Ht}function zx(T,C,F,k,X,tt,ht){$r=si._x=si._y=!1,Pp(T,C,F,k,X,tt,ht,!1,!0);let{left:_t,top:Et,width:zt,height:Ht}=cn,Wt=zt>0||Ht>0,me=Ux!=_t||Ox!=Et||Fx!=zt||Bx!=Ht;if(Wt&&me&&Iu(cn),si.setScale&&Wt&&me){let ze=_t,Fe=zt,Pe=Et,re=Ht;if(N.ori==1&&(ze=Et,Fe=Ht,Pe=_t,re=zt),Jn&&qr(w,qs(ze,w),qs(ze+Fe,w)),Kn)for(let Kt in v){let un=v[Kt];Kt!=w&&un.from==null&&un.min!=nn&&qr(Kt,qs(Pe+re,Kt),qs(Pe,Kt))}Lp()}else ft.lock&&(ft._lock=!ft._lock,Po(C,!0,T!=null));T!=null&&(kn(h0,g0),Yl(h0,i,ln,_n,W,Nt,null))}function B1(T,C,F,k,X,tt,ht){if(ft._lock)return;oe(T);let _t=$r;if($r){let Et=!0,zt=!0,Ht=10,Wt,me;N.ori==0?(Wt=Jn,me=Kn):(Wt=Kn,me=Jn),Wt&&me&&(Et=ln<=Ht||ln>=W-Ht,zt=_n<=Ht||_n>=Nt-Ht),Wt&&Et&&(ln=ln<da?0:W),me&&zt&&(_n=_n<fa?0:Nt),Po(null,!0,!0),$r=!1}ln=-10,_n=-10,nt.fill(null),Po(null,!0,!0),_t&&($r=_t)}function Hx(T,C,F,k,X,tt,ht){ft._lock||(oe(T),Wl(),Lp(),T!=null&&Yl(oM,i,ln,_n,W,Nt,null))}function Gx(){S.forEach(dL),V(i.width,i.height,!0)}Ko(Df,gl,Gx);let ga={};ga.mousedown=kx,ga.mousemove=Nx,ga.mouseup=zx,ga.dblclick=Hx,ga.setSeries=(T,C,F,k)=>{let X=On.match[2];F=X(i,C,F),F!=-1&&$s(F,k,!0,!1)},yt&&(Ue(iM,p,kx),Ue(u0,p,Nx),Ue(sM,p,T=>{oe(T),Xl(!1)}),Ue(rM,p,B1),Ue(oM,p,Hx),w0.add(i),i.syncRect=Xl);let Lu=i.hooks=n.hooks||{};function Qn(T,C,F){yi?je.push([T,C,F]):T in Lu&&Lu[T].forEach(k=>{k.call(null,i,C,F)})}(n.plugins||[]).forEach(T=>{for(let C in T.hooks)Lu[C]=(Lu[C]||[]).concat(T.hooks[C])});let Vx=(T,C,F)=>F,On=Bn({key:null,setSeries:!1,filters:{pub:xM,sub:xM},scales:[w,x[1]?x[1].scale:null],match:[_M,_M,Vx],values:[null,null]},ft.sync);On.match.length==2&&On.match.push(Vx),ft.sync=On;let Wx=On.key,Dp=pS(Wx);function Yl(T,C,F,k,X,tt,ht){On.filters.pub(T,C,F,k,X,tt,ht)&&Dp.pub(T,C,F,k,X,tt,ht)}Dp.sub(i);function k1(T,C,F,k,X,tt,ht){On.filters.sub(T,C,F,k,X,tt,ht)&&ga[T](null,C,F,k,X,tt,ht)}i.pub=k1;function z1(){Dp.unsub(i),w0.delete(i),Zn.clear(),y0(Df,gl,Gx),l.remove(),Tt?.remove(),Qn("destroy")}i.destroy=z1;function Np(){Qn("init",n,t),Vl(t||n.data,!1),z[w]?Tp(w,z[w]):Wl(),at=cn.show&&(cn.width>0||cn.height>0),rt=vt=!0,V(n.width,n.height)}return x.forEach(oa),S.forEach(pr),e?e instanceof HTMLElement?(e.appendChild(l),Np()):e(i,Np):Np(),i}ai.assign=Bn;ai.fmtNum=I0;ai.rangeNum=Nf;ai.rangeLog=Ff;ai.rangeAsinh=C0;ai.orient=ta;ai.pxRatio=We;ai.join=i2;ai.fmtDate=D0,ai.tzDate=p2;ai.sync=pS;{ai.addGap=Z2,ai.clipGaps=zf;let n=ai.paths={points:vS};n.linear=MS,n.stepped=Q2,n.bars=tL,n.spline=nL}var Wf=()=>parseFloat(getComputedStyle(document.documentElement).fontSize),z0=n=>Ft.curves[n%Ft.curves.length],fL=.06;function pL(n,t,e){let i=[n,t,...e.map(a=>a.value)],s=Math.min(...i),r=Math.max(...i),o=fL*(r-s);return r-s>1e-9?[s-o,r+o]:[s-1,r+1]}function mL(n,t,e,i){let{ctx:s}=n,r=devicePixelRatio;s.save(),s.beginPath(),s.rect(n.bbox.left,n.bbox.top,n.bbox.width,n.bbox.height),s.clip();for(let{value:o,of:a}of i){let c=n.valToPos(o,"y",!0);s.strokeStyle=a===null?Ft.ink:z0(a),s.lineWidth=1.25*r,s.setLineDash([5*r,4*r]),s.beginPath(),s.moveTo(n.bbox.left,c),s.lineTo(n.bbox.left+n.bbox.width,c),s.stroke()}s.setLineDash([]),s.lineCap="round",s.lineWidth=4.5*r,e.forEach((o,a)=>{s.strokeStyle=z0(a);for(let{start:c,end:l}of o.binds){let u=t.xs.map((h,d)=>[h,o.values[d]]).filter(([h])=>h>=c-1e-9&&h<=l+1e-9);s.beginPath();for(let[h,d]of u)s.lineTo(n.valToPos(h,"x",!0),n.valToPos(d,"y",!0));s.stroke()}}),s.restore()}function TS(n,t,{y:e,list:i},{withLimits:s,pick:r}){let o={stroke:Ft.line,width:1},a=`${Math.round(.78*Wf())}px "Inter Variable", system-ui, sans-serif`,c=hu(i),l={stroke:Ft.muted,grid:o,ticks:{...o,size:4},font:a,labelFont:a,labelSize:1.4*Wf(),gap:4},u=new ai({width:n.clientWidth||600,height:n.clientHeight||180,pxAlign:0,legend:{show:!1},cursor:{drag:{x:!1,y:!1},points:{show:!1},y:!1},scales:{x:{time:!1,range:(f,p,_)=>[p,Math.max(_,t.xEnd??_,p+1e-6)]},y:{range:(f,p,_)=>pL(p,_,s?c:[])}},series:[{},...i.map((f,p)=>({label:f.name,stroke:z0(p),width:1.75,pxAlign:0,points:{show:t.q.length<3}}))],axes:[{...l,label:t.xName==="point"?"point number":"time, s",size:2.1*Wf()},{...l,label:e,size:4*Wf()}],hooks:{draw:[f=>mL(f,t,i,c)],setSize:[()=>d()]}},[t.xs,...i.map(f=>f.values)],n);u.over.append(M("div",{class:"now"}),...t.events.map(f=>{let p=M("div",{class:`event ${f.stop?"stop":""}`,title:f.text},M("span",{text:f.short}));return p.x=f.x,p})),u.over.addEventListener("pointerdown",f=>{let p=m=>{let g=u.posToVal(m.clientX-u.over.getBoundingClientRect().left,"x");r(t.xs.reduce((x,S,v)=>Math.abs(S-g)<Math.abs(t.xs[x]-g)?v:x,0))};p(f);let _=()=>{removeEventListener("pointermove",p),removeEventListener("pointerup",_),removeEventListener("pointercancel",_)};addEventListener("pointermove",p),addEventListener("pointerup",_),addEventListener("pointercancel",_)});let h=0;function d(f=h){h=f;let p=u.over.clientWidth;for(let _ of u.over.querySelectorAll(".now, .event")){let m=u.valToPos(_.x??t.xs[h],"x");_.style.setProperty("left",`${m}px`),_.classList.toggle("leftward",m>p*.7)}}return{point:d,canvas:u.ctx.canvas,resize:()=>n.clientWidth&&u.setSize({width:n.clientWidth,height:n.clientHeight}),destroy:()=>u.destroy()}}var gL=1500,xL={gif:"image/gif",webp:"image/webp",mp4:"video/mp4"};async function AS(n,t,e,i){let s=Math.max(1,Math.ceil(n.q.length/gL)),r=n.q.map((v,A)=>A).filter(v=>v%s===0||v===n.q.length-1),[o,a,c,l,u,h]=il(),[d,f,p]=[o-l,a-u,c-h],_=[Math.atan2(p,Math.hypot(d,f)),Math.atan2(f,d)].map(v=>v*180/Math.PI),m=v=>Number(v.toPrecision(8)),g={kind:t,speed:e,view:_,q:r.map(v=>n.q[v].map(m)),t:r.map(v=>m(n.seconds[v]))},x=await Oe("film",g,({done:v,of:A})=>i(v,A));if(x.stopped)return null;let S=Uint8Array.from(atob(x.data),v=>v.charCodeAt(0));return{name:x.name,blob:new Blob([S],{type:xL[t]})}}async function RS(n,t){if(!window.MediaRecorder||!n.captureStream)throw new Error("This browser records no video.");let e=new MediaRecorder(n.captureStream(30),{mimeType:"video/webm",videoBitsPerSecond:8e6}),i=[];e.ondataavailable=({data:r})=>r.size&&i.push(r);let s=new Promise(r=>{e.onstop=r});return e.start(),await t(),await new Promise(r=>setTimeout(r,400)),e.stop(),await s,new Blob(i,{type:"video/webm"})}var rn=null,Hr=null,dr="joints",xi=0,H0=1,li=null,Xf=new Set(["speeds","accelerations","toolspeed"]);function PS(n){let t=Ut("Play",{class:"primary","data-testid":"play"},LS),e=M("input",{type:"range",min:"0",max:"1",step:"1",value:"0","aria-label":"Point of the motion","data-testid":"scrub",on:{input:()=>{gi(),Gr(Number(e.value))}}}),i=M("output",{class:"where","data-testid":"where"}),s=M("div",{class:"marks"}),r=M("div",{class:"chart","data-testid":"chart"}),o=M("div",{class:"legend"}),a=M("output",{class:"binds","data-testid":"binds"}),c=Ut("To the limits",{class:"quiet",title:"Scale the curves so that their limits, dashed, are seen; thick is where one binds","data-testid":"limits-shown"},()=>{Xf.delete(dr)||Xf.add(dr),qf()});n.append(M("div",{class:"dock-bar"},t,hn("Speed",[["0.25","\xBC\xD7"],["0.5","\xBD\xD7"],["1","1\xD7"],["2","2\xD7"],["4","4\xD7"],["10","10\xD7"]],"1",l=>{H0=Number(l)},{"data-testid":"speed"}),M("div",{class:"scrubber"},e,s),i,Ut("\xD7",{class:"icon","aria-label":"Close the curves"},()=>Di(null))),M("div",{class:"dock-bar second"},Be("Curves",Zb,dr,l=>{dr=l,qf()},"curves"),c,o,a,M("span",{class:"line saves"},...[["CSV",()=>ui("motion.csv",Kb(rn),"text/csv")],["PNG",yL],["Film",_L],["GIF",()=>CS("gif")],["MP4",()=>CS("mp4")],["SVG",()=>ui(`${dr}.svg`,Qb(rn,dr,Ft.curves),"image/svg+xml")]].map(([l,u])=>Ut(l,{class:"quiet","aria-label":`Save as ${l}`},()=>rn&&u())))),r),li={root:n,toggle:t,scrub:e,where:i,marks:s,chart:r,legend:o,limits:c,binds:a},new ResizeObserver(Js(()=>Hr?.resize())).observe(r),et(["units","theme"],qf),et("moving",l=>bt(t,l&&$f?"Pause":"Play")),et("table",l=>{rn&&!["postures","name","gripper"].includes(l)&&Di(null)})}function Di(n){if(gi(),rn=n,b.motion=n,li.root.hidden=!n,Hr&&(Hr.destroy(),Hr=null),yb(n?.table??null,n?.q??[]),!n){ut("motion");return}li.scrub.max=String(Math.max(n.q.length-1,0));let t=n.xs[n.xs.length-1]-n.xs[0]||1;Gt(li.marks,n.events.map(e=>{let i=M("span",{class:"event-mark",title:e.text});return i.style.setProperty("left",`${Math.min(100*(e.x-n.xs[0])/t,100)}%`),i}),(n.tight??[]).map(e=>{let i=M("span",{class:"tight-mark",title:e.text});return i.style.setProperty("left",`${100*(e.start-n.xs[0])/t}%`),i.style.setProperty("width",`${100*(e.end-e.start)/t}%`),i})),qf(),ut("motion"),n.q.length&&Gr(0),requestAnimationFrame(()=>nl())}var IS=()=>xi;function Gr(n){rn?.q.length&&(xi=Math.min(Math.max(Math.round(n),0),rn.q.length-1),li.scrub.value=String(xi),li.scrub.style.setProperty("--at",`${rn.q.length>1?100*xi/(rn.q.length-1):0}%`),bt(li.where,rn.xName==="point"?`point ${xi+1} of ${rn.q.length}`:`${ii(rn.xs[xi],2)} s of ${ii(rn.xs[rn.xs.length-1],2)} s`),li.scrub.setAttribute("aria-valuetext",li.where.textContent),Oi(rn.q[xi].slice(),"scrub"),ut("played",rn.seconds[xi]),bt(li.binds,rn.tight?`Binds: ${Jb(rn,rn.seconds[xi])||"nothing"}`:""),Hr?.point(xi))}var $f=!1;function LS(n,t){if($f){gi();return}if(!rn?.q.length)return;let e=rn.seconds,i=e[e.length-1]||1,s=xi>=rn.q.length-1?0:e[xi]/i;$f=!0,Nb(i/H0,s,r=>{let o=xi<=rn.q.length-1&&e[xi]<=r*i?xi:0;for(;o<e.length-1&&e[o+1]<=r*i+1e-9;)o+=1;Gr(o)},()=>{$f=!1,bt(li.toggle,"Play"),t?.()}),bt(li.toggle,"Pause")}function qf(){if(!rn||!li)return;Hr?.destroy();let n=l0(rn,dr);Gt(li.legend,n.list.map((t,e)=>{let i=M("span",{class:"swatch"});return i.style.setProperty("background",Ft.curves[e%Ft.curves.length]),M("span",{},i,t.name)})),li.limits.hidden=!hu(n.list).length,li.limits.setAttribute("aria-pressed",String(Xf.has(dr))),Hr=TS(li.chart,rn,n,{withLimits:Xf.has(dr),pick(t){gi(),Gr(t)}}),Hr.point(xi)}async function CS(n){we(`Drawing the ${n.toUpperCase()} \u2026`);try{let t=await AS(rn,n,H0,(e,i)=>we(`Drawing the ${n.toUpperCase()}: ${e} of ${i} pictures`));t&&ui(t.name,t.blob)}catch(t){we(t.message,"wrong")}}async function _L(){gi(),Gr(0);try{let n=await tl(t=>RS(t,()=>new Promise(e=>LS(null,e))));ui("motion.webm",n)}catch(n){we(n.message,"wrong")}}function yL(){let n=Hr.canvas,t=document.createElement("canvas"),e=t.getContext("2d");t.width=n.width,t.height=n.height,e.fillStyle=Ft.panel,e.fillRect(0,0,t.width,t.height),e.drawImage(n,0,0),t.toBlob(i=>ui(`${dr}.png`,i))}function El(n,t){let e=Array.from({length:16},(s,r)=>M("span",{role:"cell",class:r%4===3&&r<12?"p":r>=12?"last":""})),i=M("div",{class:"matrix",role:"table","aria-label":n,"data-testid":t},[0,4,8,12].map(s=>M("div",{role:"row",class:"matrix-row"},e.slice(s,s+4))));return i.show=s=>{for(let r=0;r<16;r++){let o=r%4===3&&r<12;bt(e[r],r>=12?String(s[r]):o?ii(s[r]*mt.factor("length"),mt.digits("length")):ii(s[r],4))}},i}var Yf=n=>[0,4,8,12].map(t=>`[${n.slice(t,t+4).map(e=>Number(e.toPrecision(12))+0).join(", ")}]`).join(`,
`);var G0="pieper-panel-width",V0=18,DS=70;function NS(n,t){let e=M("div",{class:"splitter",role:"separator","aria-orientation":"vertical","aria-label":"Width of the panels","aria-valuemin":String(V0),"aria-valuemax":String(DS),tabindex:"0","data-testid":"splitter"});t.prepend(e);let i=()=>parseFloat(getComputedStyle(document.documentElement).fontSize),s=()=>document.getElementById("panels").offsetWidth/i(),r=a=>{let c=a===null?null:Math.min(Math.max(a,V0),DS,.75*innerWidth/i());c===null?n.style.removeProperty("--panel-width"):n.style.setProperty("--panel-width",`${c}rem`),n.classList.toggle("split",c!==null),e.setAttribute("aria-valuenow",String(Math.round(c??s())));try{c===null?localStorage.removeItem(G0):localStorage.setItem(G0,String(c))}catch{}};e.addEventListener("pointerdown",a=>{e.setPointerCapture(a.pointerId);let c=a.clientX,l=s(),u=h=>r(l+(c-h.clientX)/i());e.addEventListener("pointermove",u),e.addEventListener("pointerup",()=>e.removeEventListener("pointermove",u),{once:!0})}),e.addEventListener("dblclick",()=>r(null)),e.addEventListener("keydown",a=>{let c={ArrowLeft:1,ArrowRight:-1}[a.key];if(c)r(s()+c*(a.shiftKey?5:1));else if(a.key==="Home")r(null);else return;a.preventDefault()});let o=Number(localStorage.getItem(G0));o>=V0?r(o):e.setAttribute("aria-valuenow","38")}function US(n){let t=El("Pose of the tool, large","present-pose"),e=M("div",{class:"present-card",hidden:!0},t);n.append(e);let i=document.documentElement,s=Ut("Present",{"aria-pressed":"false","data-testid":"present"},()=>o(i.dataset.present!=="yes")),r=()=>!e.hidden&&t.show(b.frames.at(-1));function o(a){a?i.dataset.present="yes":delete i.dataset.present,e.hidden=!a,s.setAttribute("aria-pressed",String(a)),r(),ut("units"),dispatchEvent(new Event("resize"))}return et(["q","units"],r),addEventListener("keydown",a=>a.key==="Escape"&&i.dataset.present&&!a.target.matches?.("input")&&o(!1)),s}function OS(){tl(n=>{let t=document.createElement("canvas"),e=t.getContext("2d");t.width=n.width,t.height=n.height,e.drawImage(n,0,0),zv(e,n.width/n.clientWidth),t.toBlob(i=>i?ui(`${b.table.name||"arm"}.png`,i):we("The picture could not be read.","wrong"))})}var vL="http://www.w3.org/2000/svg";function bL(n){let t=n.map(([c,l,u])=>[.77*c+.62*l,.3*c-.38*l-.88*u]);t.unshift([t[0][0],t[0][1]]);let[e,i]=[0,1].map(c=>t.map(l=>l[c])),s=Math.max(Math.max(...e)-Math.min(...e),Math.max(...i)-Math.min(...i))||1,r=([c,l])=>[22+36*(c-(Math.max(...e)+Math.min(...e))/2)/s,22+36*(l-(Math.max(...i)+Math.min(...i))/2)/s],o=(c,l)=>{let u=document.createElementNS(vL,c);for(let[h,d]of Object.entries(l))u.setAttribute(h,d);return u},a=o("svg",{viewBox:"0 0 44 44",class:"thumb","aria-hidden":"true"});a.append(o("polyline",{points:t.map(c=>r(c).map(l=>l.toFixed(1)).join(",")).join(" ")}));for(let c of t.slice(1))a.append(o("circle",{cx:r(c)[0].toFixed(1),cy:r(c)[1].toFixed(1),r:1.7}));return a}var FS=n=>/^(.)\1*$/.test(n)?`${n.length}${n[0]}`:n;function ML(n){let t=/^>?(\d+(?:[.,]\d+)?)(kg|mm|m)$/.exec(n);if(!t)return null;let e=Number(t[1].replace(",","."));return t[2]==="kg"?{payload:e}:{reach:t[2]==="m"?e:e/1e3}}function SL(n,t){let e=`${n.name} ${n.maker} ${n.joints} ${FS(n.joints)}`.toLowerCase();return t.every(i=>{let s=ML(i);return s?Object.entries(s).every(([r,o])=>n[r]!==null&&n[r]>=o-1e-9):e.includes(i)})}var wL=({maker:n,joints:t,payload:e,reach:i})=>[n,FS(t),e===null?"":`${e} kg`,i===null?"":`${Math.round(i*1e3)} mm`].filter(Boolean);function BS(n){let t=null,e=M("div",{class:"arms",role:"listbox","aria-label":"Arms found","data-testid":"arms-found"}),i=M("span",{class:"hint",role:"status"}),s=M("input",{type:"text",placeholder:"Name, maker, joints (7R), payload (5 kg), reach (900 mm)","aria-label":"Search the catalogue","data-testid":"search-arms",autocomplete:"off",on:{input:()=>o(),keydown:a=>{if(a.key==="ArrowDown")e.firstElementChild?.focus();else if(a.key==="Enter")e.firstElementChild?.click();else return;a.preventDefault()}}}),r=M("dialog",{class:"catalogue","aria-label":"Catalogue"},M("div",{class:"line"},s,i,Ut("\xD7",{class:"icon","aria-label":"Close the catalogue"},()=>r.close())),e);document.body.append(r);function o(){let c=s.value.toLowerCase().replace(/(\d)\s+(kg|mm|m)\b/g,"$1$2").split(/\s+/).filter(Boolean),l=(t??[]).filter(u=>SL(u,c));i.textContent=`${l.length} of ${t?.length??0} arms`,Gt(e,l.map(u=>M("button",{type:"button",role:"option",class:"arm-card","data-name":u.name,on:{click:()=>{r.close(),n(u.name)},keydown:h=>{let d={ArrowDown:"nextElementSibling",ArrowUp:"previousElementSibling"}[h.key];d&&(h.preventDefault(),(h.currentTarget[d]??s).focus())}}},bL(u.points),M("span",{},M("b",{text:u.name}),M("span",{class:"hint",text:wL(u).join(", ")})))))}return async()=>{if(r.showModal(),s.select(),!t)try{t=(await Fi("catalog")).arms,o()}catch(a){we(a.message,"wrong")}}}var yu=n=>(n?.textContent.trim()??"").split(/\s+/).filter(Boolean).map(Number),vo=(n,t)=>[...n.children].filter(e=>e.localName===t),EL=()=>[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1];function TL(n,t){let e=new Array(16).fill(0);for(let i=0;i<4;i++)for(let s=0;s<4;s++)for(let r=0;r<4;r++)e[4*i+s]+=n[4*i+r]*t[4*r+s];return e}function AL([n,t,e,i]){let s=Math.hypot(n,t,e)||1,r=i*Math.PI/180,o=Math.cos(r),a=Math.sin(r),c=1-o;return[n,t,e]=[n/s,t/s,e/s],[c*n*n+o,c*n*t-a*e,c*n*e+a*t,0,c*n*t+a*e,c*t*t+o,c*t*e-a*n,0,c*n*e-a*t,c*t*e+a*n,c*e*e+o,0,0,0,0,1]}var kS={matrix:n=>n,translate:([n,t,e])=>[1,0,0,n,0,1,0,t,0,0,1,e,0,0,0,1],scale:([n,t,e])=>[n,0,0,0,0,t,0,0,0,0,e,0,0,0,0,1],rotate:AL},RL={X_UP:[0,-1,0,0,1,0,0,0,0,0,1,0,0,0,0,1],Y_UP:[1,0,0,0,0,0,-1,0,0,1,0,0,0,0,0,1]};function zS(n){let t=new DOMParser().parseFromString(n,"application/xml");if(t.querySelector("parsererror")||t.documentElement.localName!=="COLLADA")throw new Error("this is no DAE");let e=f=>[...t.getElementsByTagName("*")].filter(p=>p.localName===f),i=new Map([...t.getElementsByTagName("*")].filter(f=>f.id||f.getAttribute("id")).map(f=>[f.getAttribute("id"),f])),s=f=>i.get((f??"").replace(/^#/,"")),r=Number(e("unit")[0]?.getAttribute("meter")??1)||1,o=RL[e("up_axis")[0]?.textContent.trim()]??EL(),a=[];function c(f){let p=s(vo(s(f)??t.documentElement,"instance_effect")[0]?.getAttribute("url")),_=p&&[...p.getElementsByTagName("*")].find(g=>g.localName==="diffuse"),m=_?yu(vo(_,"color")[0]):[];return m.length>=3?[m[0],m[1],m[2],m[3]??1]:null}function l(f){let p=vo(f,"input").find(m=>m.getAttribute("semantic")==="POSITION"),_=s(p?.getAttribute("source"));return _?yu(vo(_,"float_array")[0]):[]}function u(f,p,_){let m=f&&vo(f,"mesh")[0];if(m)for(let g of m.children){if(!["triangles","polylist","polygons"].includes(g.localName))continue;let x=vo(g,"input"),S=1+Math.max(...x.map($=>Number($.getAttribute("offset")??0))),v=x.find($=>$.getAttribute("semantic")==="VERTEX");if(!v)continue;let A=Number(v.getAttribute("offset")??0),w=l(s(v.getAttribute("source"))),y=vo(g,"p").map(yu),E=g.localName==="polylist"?yu(vo(g,"vcount")[0]):g.localName==="polygons"?y.map($=>$.length/S):new Array(y.reduce(($,P)=>$+P.length,0)/S/3).fill(3),U=y.flat(),L=[],N=0,H=$=>{let P=3*U[(N+$)*S+A],[z,D,B]=[w[P],w[P+1],w[P+2]];for(let Q=0;Q<3;Q++)L.push(r*(p[4*Q]*z+p[4*Q+1]*D+p[4*Q+2]*B+p[4*Q+3]))};for(let $ of E){for(let P=2;P<$;P++)for(let z of[0,P-1,P])H(z);N+=$}L.length&&L.every(Number.isFinite)&&a.push({at:Float32Array.from(L),colour:c(_.get(g.getAttribute("material")))})}}function h(f,p,_){if(!(_>60)){for(let m of f.children)kS[m.localName]&&(p=TL(p,kS[m.localName](yu(m))));for(let m of f.children)if(m.localName==="instance_geometry"){let g=new Map([...m.getElementsByTagName("*")].filter(x=>x.localName==="instance_material").map(x=>[x.getAttribute("symbol"),x.getAttribute("target")]));u(s(m.getAttribute("url")),p,g)}else if(m.localName==="node")h(m,p,_+1);else if(m.localName==="instance_node"){let g=s(m.getAttribute("url"));g&&h(g,p,_+1)}}}let d=s(e("instance_visual_scene")[0]?.getAttribute("url"))??e("visual_scene")[0];if(d&&h(d,o,0),!a.length)throw new Error("there is no triangle in this DAE");return a}var jf=[],vu=new Map,Zf=0;function CL(){if(jf.length<2){let n=new Worker("meshes.js",{type:"module"});return n.onmessage=({data:{id:t,mesh:e,error:i}})=>{let{resolve:s,reject:r}=vu.get(t);vu.delete(t),i?r(new Error(i)):s(e)},n.onerror=()=>{for(let{reject:t}of vu.values())t(new Error("meshes cannot be read in this browser"));vu.clear()},jf.push(n),n}return jf[Zf%jf.length]}function HS(n,t){return new Promise((e,i)=>{Zf+=1,vu.set(Zf,{resolve:e,reject:i}),CL().postMessage({id:Zf,...n},t)})}async function GS(n,t){let e=t.split(".").at(-1).toLowerCase(),i;if(n.file)i=await n.file.arrayBuffer();else{let s=await fetch(n.url);if(!s.ok)throw new Error(`${t} cannot be fetched`);i=await s.arrayBuffer()}if(e==="dae"){let s=zS(new TextDecoder().decode(i));return Promise.all(s.map(async({at:r,colour:o})=>({mesh:await HS({at:r},[r.buffer]),colour:o})))}return[{mesh:await HS({bytes:i,kind:e},[i]),colour:null}]}var VS={light:"#c9ced6",dark:"#8b96a6"},Al=new Rn,zs=[],bu=0,qS=!1,XS=n=>JSON.stringify([n.convention,n.coupling??null,n.joints.map(t=>[t.type,t.a,t.alpha,t.d,t.theta,t.sign,t.offset])]);function Rl(n,t,e=null){b.looks=n?.shapes.length?{...n,key:XS(t),files:e}:null,n?.notes.length&&we(`Of its looks: ${n.notes.join(" ")}`,n.shapes.length?"plain":"wrong"),PL()}var $0=()=>!!(b.looks&&b.looks.key===XS(b.table)),q0=()=>$0()?b.look.mode:"sketch",Jf=null;function PL(){if(Jf===b.looks)return;Jf=b.looks;for(let t of zs)for(let e of new Set([t.fine,t.some,t.few]))e.dispose();zs=[],Al.clear();let n=Jf;for(let t of n?.shapes??[]){if(t.kind!=="mesh"){$S(t,[IL[t.kind](t.size)],t.colour);continue}let e=t.url?{url:t.url}:{file:n.files?.(t.file)};!e.url&&!e.file||(bu+=1,GS(e,t.url??t.file).then(i=>{if(Jf===n)for(let{mesh:s,colour:r}of i){let o=W0(s),a=s.some===s?o:W0(s.some);$S(t,[o,a,s.few===s.some?a:W0(s.few)],t.colour??r,t.size,s.closed)}}).catch(i=>we(`${t.name}: ${i.message}`,"wrong")).finally(()=>{bu-=1,Tl(),bu||ut("looks","loaded")}))}ut("looks"),Tl()}var WS=n=>n.rotateX(Math.PI/2),IL={box:n=>new Hi(...n),cylinder:([n,t])=>WS(new Ri(n,n,t,36)),capsule:([n,t])=>WS(new Bo(n,t,8,24)),sphere:([n])=>new Ps(n,28,16)};function W0(n){let t=new be;return t.setAttribute("position",new He(n.at,3)),t.setAttribute("normal",n.normal.length===n.at.length?new He(n.normal,3):LL(n.normal)),t.setIndex(new He(n.index,1)),t}function LL(n){return new Va(new Ga(n,4),3,0,!0)}function $S(n,[t,e=t,i=e],s,r=null,o=!0){let a=Dv(o),c=new Ge(t,a),l=new Ge(i,ff),u=new _e().set(...n.T);r&&u.scale(new G(...r));for(let h of[c,l])h.matrixAutoUpdate=!1,h.frustumCulled=!1;l.renderOrder=-1,Al.add(c,l),zs.push({on:n.on,T:u,fine:t,some:e,few:i,mesh:c,shadow:l,colour:s}),Mu()}var DL=new _e;function Tl(){YS(),de()}function YS(){let n=q0();if(Al.visible=n!=="sketch"&&zs.length>0,mb(n!=="real"||bu>0,n!=="sketch"&&zs.length>0),!!Al.visible)for(let t of zs){let e=b.frames[t.on];e&&(t.mesh.geometry=qS?t.few:Mv()?t.some:t.fine,t.mesh.matrix.copy(DL.set(...e)).multiply(t.T),t.shadow.matrix.copy(qg).multiply(t.mesh.matrix),t.mesh.matrixWorldNeedsUpdate=t.shadow.matrixWorldNeedsUpdate=!0)}}function Mu(){let n=q0()==="both"?b.look.opacity:1;for(let{mesh:t,colour:e}of zs){let[i,s,r,o]=e??[];e?t.material.colour.setRGB(i,s,r,Ei):t.material.colour.set(Ft.dark?VS.dark:VS.light),t.material.see((o??1)*n,Ft.dark)}de()}function X0(n){b.look={...b.look,...n},Mu(),Tl(),ut("look")}function jS(){tn.add(Al),et("table",()=>{Tl(),Mu(),ut("looks")}),et("q",Tl),et("theme",Mu),et("look",n=>{n==="loaded"&&(Mu(),Tl())}),et("hurry",n=>{qS=n,YS()})}var ZS=()=>({mode:q0(),visible:Al.visible,loading:bu,shapes:zs.length,triangles:zs.reduce((n,t)=>n+(t.fine.index?.count??0)/3,0),few:zs.reduce((n,t)=>n+(t.few.index?.count??0)/3,0),places:zs.map(n=>n.mesh.matrix.clone().transpose().toArray())});function KS(){let n=Be("The arm as",[["sketch","Sketch"],["real","Real"],["both","Both"]],b.look.mode,s=>X0({mode:s}),"look"),t=M("input",{type:"range",min:"0.1",max:"0.9",step:"0.05",value:String(b.look.opacity),"aria-label":"How opaque the real arm is over the sketch","data-testid":"look-opacity",on:{input:()=>X0({opacity:Number(t.value)})}}),e=M("div",{class:"group look",hidden:!0},n,t),i=()=>{e.hidden=!$0(),n.mark(b.look.mode),t.hidden=b.look.mode!=="both",t.value=String(b.look.opacity)};return et(["looks","look","table"],i),i(),e}function tw(n){let t=M("select",{"aria-label":"Arm from the catalogue","data-testid":"catalog",on:{change:()=>QS(t.value)}}),e=BS(QS),i=M("p",{class:"sentence","data-testid":"sentence"}),s=M("span",{class:"online",role:"status","data-testid":"online"}),r=(u,h,d,f)=>{let p=Ut(u,{"aria-label":h},d);return p.show=_=>{p.disabled=!_,p.title=_?`${h}: ${_} (${f})`:`Nothing to ${h.toLowerCase()}`,p.setAttribute("aria-description",_??"")},p},o=r("\u21B6","Undo",e0,"Ctrl+Z"),a=r("\u21B7","Redo",n0,"Ctrl+Shift+Z");et("history",()=>{o.show(yf()),a.show(vf())});let c=()=>{let{name:u,derived:h,catalog:d}=b.table,f=d?[]:[M("option",{value:"",text:h?`${u} (from ${h}, edited)`:u||"my-arm"})];Gt(t,f,(b.catalog??[]).map(p=>M("option",{value:p,text:p}))),t.value=d??""},l=M("span",{class:"group",role:"group","aria-label":"History"},o,a);n.append(M("h1",{class:"mark"},M("img",{src:"icon.svg",alt:"",width:"22",height:"22"}),M("span",{text:"pieper"})),t,Ut("Find\u2026",{class:"find","aria-label":"Find an arm in the catalogue","data-testid":"find-arm"},e),l,i,M("span",{class:"bar-end"},s,Be("Angles in",[["deg","\xB0"],["rad","rad"]],mt.angle,u=>{mt.set("angle",u),ut("units")},"unit-angle"),Be("Lengths in",[["mm","mm"],["m","m"]],mt.length,u=>{mt.set("length",u),ut("units")},"unit-length"),hn("Size of the letters",[1,1.15,1.3,1.5].map(u=>[String(u),`${Math.round(100*u)} %`]),String(ag()),u=>ov(Number(u)),{"data-testid":"text-size"}),hn("Light or dark",[["auto","Auto"],["light","Light"],["dark","Dark"]],b.theme,Hd,{"data-testid":"theme"}))),ut("history"),et(["catalog","table"],c),et("plan",()=>{bt(i,[ku(b.plan),o_(b.plan)].filter(Boolean).join(". ").replace("..",".")),i.title=b.plan?.explain??""}),et("online",u=>{bt(s,u?"":"Server away; reconnecting"),s.classList.toggle("away",!u)}),et(["units","theme"],()=>{n.querySelector("[data-testid=unit-angle]").mark(mt.angle),n.querySelector("[data-testid=unit-length]").mark(mt.length),n.querySelector("[data-testid=theme]").value=b.theme})}async function QS(n){if(n)try{let{table:t}=await Fi("load",{name:n});yn(t,{q:_a(t),what:"new",label:`open ${n}`})}catch(t){we(t.message,"wrong")}}function ew(n,t,e,i){let s=M("div",{role:"tablist","aria-orientation":"vertical",class:"tabs"}),r=matchMedia("(min-width: 1700px)");n.append(s);let o=new Map,a=i.map(l=>{let u=M("div",{role:"tabpanel",class:"panel",id:`panel-${l.id}`,"aria-labelledby":`tab-${l.id}`,"data-testid":`panel-${l.id}`,hidden:!0});for(let d of l.sections??[l]){let f=M("section",{class:"section"},M("h2",{text:d.title}));u.append(f),d.build(f,u)}let h=Ut(l.title,{role:"tab",id:`tab-${l.id}`,"aria-controls":u.id},()=>c(l.id));return l.group&&s.append(M("span",{class:"tab-group","aria-hidden":"true",text:l.group})),s.append(h),{...l,panel:u,tab:h}});function c(l){r.matches&&l==="move"&&(l="inverse"),o.set(b.panel,t.scrollTop),b.panel=l;for(let u of a){let h=r.matches&&u.id==="move",d=u.id===l||h;(h?e:t).append(u.panel),u.panel.hidden=!d,u.tab.hidden=h,u.tab.setAttribute("aria-selected",String(u.id===l)),u.tab.tabIndex=u.id===l?0:-1,u.id===l&&(document.getElementById("room").dataset.panel=l,document.getElementById("room").classList.toggle("wide",!!u.wide))}ut("panel",l),t.scrollTop=o.get(l)??0}return s.addEventListener("keydown",l=>{let u={ArrowDown:1,ArrowUp:-1,ArrowRight:1,ArrowLeft:-1}[l.key];if(!u)return;l.preventDefault();let h=a.filter(p=>!p.tab.hidden),d=h.findIndex(p=>p.id===b.panel),f=h[(d+u+h.length)%h.length];c(f.id),f.tab.focus()}),r.addEventListener("change",()=>c(b.panel==="move"||!a.some(l=>l.id===b.panel)?"move":b.panel)),c(b.panel),c}function nw(n){let t=M("div",{class:"group",role:"group","aria-label":"Views"},[["iso","Iso"],["front","Front"],["side","Side"],["top","Top"]].map(([l,u])=>Ut(u,{},()=>pg(l))),Ut("Fit",{},()=>su())),e=M("div",{class:"group frames",role:"group","aria-label":"Frames shown","data-testid":"frames"}),i=Ut("Trace",{"aria-pressed":"true"},()=>{let l=i.getAttribute("aria-pressed")!=="true";i.setAttribute("aria-pressed",String(l)),Cb(l)}),s=Ut("Clear",{"aria-label":"Clear the trace"},gf),r=M("span",{class:"scale"}),o=M("div",{class:"key","aria-label":"Axes: x red, y green, z blue"},["x","y","z"].map((l,u)=>{let h=M("span",{class:"dot"});return h.style.setProperty("background",Ur[u]),M("span",{},h,l)}),r);n.append(M("div",{class:"corner top"},t,M("div",{class:"group",role:"group","aria-label":"Trace of the tool"},i,s),KS(),M("div",{class:"group",role:"group","aria-label":"The picture"},US(n),Ut("PNG",{"aria-label":"Save the picture","data-testid":"save-picture"},OS))),M("div",{class:"corner bottom"},o,e));let a=-2,c=()=>{let l=b.table.joints.length,u=Array.from({length:l+2},(d,f)=>f);b.shownFrames=(b.shownFrames??[0,l+1]).map(d=>d===a+1?l+1:d).filter(d=>d<l+2),a=l;let h=d=>{b.shownFrames=d,c()};Gt(e,M("span",{class:"group-name",text:"Frames"}),u.map(d=>Ut(mf(d),{"aria-pressed":String(b.shownFrames.includes(d)),"aria-label":`Frame ${mf(d)}`},()=>h(b.shownFrames.includes(d)?b.shownFrames.filter(f=>f!==d):[...b.shownFrames,d]))),Ut(b.shownFrames.length===l+2?"none":"all",{"aria-label":"All frames or none"},()=>h(b.shownFrames.length===l+2?[]:u))),ut("frames"),bt(r,`grid ${ce(xg.cell,"length",mt.length==="mm"?0:2)}`)};et(["table","units"],c),c()}function iw(){addEventListener("keydown",n=>{if(!(n.ctrlKey||n.metaKey)||n.altKey)return;let t=n.key.toLowerCase();n.target.matches?.("input[type=text]:not(.number), textarea")||(t==="z"&&!n.shiftKey?(n.preventDefault(),n.target.blur?.(),e0()):(t==="y"||t==="z"&&n.shiftKey)&&(n.preventDefault(),n.target.blur?.(),n0()))})}var Y0=()=>b.frames[b.frames.length-1],rw={id:"pose",title:"Pose",build(n){let t=El("Pose of the tool in the base frame","pose"),e=["X","Y","Z"].map(u=>sw(u,"length",`pose-${u.toLowerCase()}`)),i=M("div",{class:"quantities","data-testid":"orientation"}),s=M("p",{class:"hint order"}),r=[],o=hn("Notation of the orientation",Object.entries(Ns).map(([u,h])=>[u,h.title]),b.notation,u=>{b.notation=u,ut("notation")}),a=M("span",{class:"copies"},Ut("Copy matrix",{class:"quiet",title:"As numbers in metres, row by row"},()=>jr(Yf(Y0()))),Ut("Copy numbers",{class:"quiet",title:"Position and orientation, in the units shown"},()=>jr(NL())));n.append(M("div",{class:"subhead"},M("span",{text:"Tool in the base frame"}),a),t,M("div",{class:"quantities"},e.map(u=>u.el)),M("div",{class:"line"},o,s),i);let c=()=>{let u=Ns[b.notation];o.value=b.notation,bt(s,u.order),r=u.names.map((h,d)=>sw(h,u.kinds[d],`turn-${d}`)),Gt(i,r.map(h=>h.el)),l()},l=()=>{let u=Y0();t.show(u),te(u).forEach((h,d)=>e[d].show(h)),Ns[b.notation].to(u).forEach((h,d)=>r[d].show(h))};et("q",l),et("notation",c),et("units",()=>{e.forEach(u=>u.relabel()),r.forEach(u=>u.relabel()),l()}),c()}};function NL(){let n=Y0(),t=Ns[b.notation],e=te(n).map((s,r)=>`${"XYZ"[r]} ${mn(s,"length")} ${mt.symbol("length")}`),i=t.to(n).map((s,r)=>`${t.names[r]} ${t.kinds[r]==="angle"?`${mn(s,"angle")} ${mt.symbol("angle")}`:ii(s,5)}`);return`${e.join(", ")}; ${i.join(", ")} (${t.order})`.replaceAll("\u2212","-")}function sw(n,t,e){let i=M("output",{"data-testid":e}),s=M("span",{class:"unit",text:mt.symbol(t)});return{el:M("div",{class:"quantity"},M("span",{class:"quantity-name",text:n}),i,s),show:o=>bt(i,t==="plain"?ii(o,5):mn(o,t)),relabel:()=>bt(s,mt.symbol(t))}}function UL(n,t){let e=[],i=n.joints.length,s=vr(n,t),r=o=>n.convention==="standard"?n.joints[o].alpha:n.joints[o+1]?.alpha;for(let o=0;o<i-1;o++){let a=yr(n.joints[o],s[o]).theta,c=1,l=`${o+1}`;for(let u=o;u<i-1;u++){let h=r(u);if(Math.abs(Math.sin(h))>1e-9||n.joints[u+1].type!=="R"||n.joints[o].type!=="R")break;c*=Math.sign(Math.cos(h)),a+=c*yr(n.joints[u+1],s[u+1]).theta,l+=`${c>0?"":"\u2212"}${u+2}`,e.push({name:l,value:a})}}return e}var ow={id:"matrices",title:"Matrices",wide:!0,build(n){let t="links",e="now",i=0,s=0,r=[],o=M("div",{class:"cards","data-testid":"matrices"}),a=M("table",{class:"plain","data-testid":"angles","aria-label":"Intermediate angles"}),c=hn("Posture",[["now","present posture"]],"now",p=>{e=p,d()}),l=M("span",{class:"partial"});n.append(M("div",{class:"line"},Be("Matrices shown",[["links","Each A"],["products","Products from the base"],["partial","Between two frames"]],t,p=>{t=p,h()},"matrix-mode"),l),M("div",{class:"line"},M("span",{class:"field-name",text:"Numbers of the"}),c),o,M("h3",{text:"Intermediate angles"}),M("p",{class:"hint",text:"Each \u03B8 with the maker\u2019s sign and zero put in, and the sums of neighbouring joints whose axes are parallel, as a derivation uses them."}),a);let u=()=>e!=="now"&&b.solutions?.rows[Number(e)]?.q||b.q,h=()=>{let p=b.table.joints.length;i=Math.min(i,p),s=s===0||s>p?p:s;let _=t==="links"?b.table.joints.map((g,x)=>["A",String(x+1),""]):t==="products"?b.table.joints.map((g,x)=>["T",String(x+1),"0"]):[["T",String(s),String(i)]];t==="links"&&_.push(["T","tool","base"]);let m=Array.from({length:p+1},(g,x)=>[String(x),String(x)]);Gt(l,t==="partial"?[hn("From frame",m,String(i),g=>{i=Number(g),h()})," \u2192 ",hn("To frame",m,String(s),g=>{s=Number(g),h()})]:[]),r=_.map(([g,x,S])=>({grid:El(`${g} ${S} ${x}`,`matrix-${g}${S}${S?"-":""}${x}`),note:M("span",{class:"hint"}),sym:g,low:x,high:S})),Gt(o,r.map(({grid:g,note:x,sym:S,low:v,high:A})=>M("figure",{class:"card"},M("figcaption",{},M("span",{class:"symbol"},A?M("sup",{text:A}):null,M("i",{text:S}),M("sub",{text:v})),x),g))),d()},d=Js(()=>{if(n.closest(".panel").hidden||!b.table.joints.length)return;let p=u(),_=jx(b.table,p),m=_.length;r.forEach(({grid:S,note:v},A)=>{if(t==="links"&&A<m)S.show(_[A]),bt(v,`q${A+1} = ${ce(p[A],Ze(b.table.joints[A]))}`);else if(t==="links")S.show(ws(b.table,p)[m+1]);else if(t==="products")S.show(_.slice(0,A+1).reduce(Hn,Zi()));else{let w=y=>_.slice(0,y).reduce(Hn,Zi());S.show(Hn(xa(w(i)),w(s)))}});let g=vr(b.table,p),x=b.table.joints.map((S,v)=>[S.type==="R"?`\u03B8${v+1}`:`d${v+1}`,S.type==="R"?mn(yr(S,g[v]).theta,"angle"):mn(yr(S,g[v]).d,"length"),S.type==="R"?"angle":"length"]).concat(UL(b.table,p).map(({name:S,value:v})=>[`\u03B8${S}`,mn(v,"angle"),"angle"]));Gt(a,M("tbody",{},x.map(([S,v,A])=>M("tr",{},M("th",{scope:"row"},M("i",{text:S[0]}),M("sub",{text:S.slice(1)})),M("td",{text:v}),M("td",{class:"unit",text:mt.symbol(A)})))))}),f=()=>{if(n.closest(".panel").hidden)return;let p=b.solutions?.rows??[];Gt(c,M("option",{value:"now",text:"present posture"}),p.map((_,m)=>M("option",{value:String(m),text:`solution ${m+1}: ${_.label??""}`}))),e!=="now"&&!p[Number(e)]&&(e="now"),c.value=e,d()};et("table",h),et(["q","units","panel"],d),et(["solutions","panel"],f),h()}};var OL=.002;function Hs(n,t,e,i){let s=[],r="",o=M("div",{class:"pose-fields"}),a=()=>s.some(u=>u.f.classList.contains("wrong")),c=()=>{let u=Ns[b.notation],h=[["X","length"],["Y","length"],["Z","length"],...u.names.map((f,p)=>[f,u.kinds[p]])],d=()=>{if(a())return;let f=Vv(b.notation,s.slice(3).map(p=>p.value),s.slice(0,3).map(p=>p.value));f&&i(f,FL(s))};s=h.map(([f,p],_)=>{let m={value:0,kind:p},g=(x,S)=>{m.value=x,m.text=S.text,d()};return m.f=Mn({label:`${n}, ${f}`,kind:p,testid:`${t}-${_}`,input:g,commit:(x,S)=>{g(x,S),ut("let-go")}}),m.el=M("label",{class:"pose-field"},M("span",{text:f}),m.f,M("span",{class:"unit",text:mt.symbol(p)})),m}),Gt(o,s.map(f=>f.el)),r=b.notation},l=()=>{r!==b.notation&&c();let u=e();!u||o.contains(document.activeElement)||[...te(u),...Ns[b.notation].to(u)].forEach((h,d)=>{s[d].value=h,s[d].text=null,s[d].f.put(h,BL(h,s[d].kind))})};return et("units",()=>{c(),l()}),et("notation",l),c(),l(),o.addEventListener("paste",u=>{let h=Tf(u.clipboardData.getData("text"))?.flat(),d=s.findIndex(f=>f.f===u.target);!h||d<0||(u.preventDefault(),Af([s.map(f=>f.f)],0,h.length===s.length?0:d,[h]))}),o.addEventListener("focusout",()=>{setTimeout(()=>a()||l())}),{el:M("fieldset",{class:"pose-editor"},M("legend",{text:n}),o),show:l}}function FL(n){let t=s=>s.map(r=>r.text??""),e=n.slice(3).filter(s=>s.kind==="angle"),i=e.length>1?al(t(e),"angle"):2*al(t(n.slice(3)),"plain");return{metres:al(t(n.slice(0,3)),"length"),radians:i}}var BL=(n,t)=>String(Number((n*mt.factor(t)).toFixed(t==="plain"||mt[t]==="m"||mt[t]==="rad"?6:3))+0);function aw(n){let t=n.match(lw)??[],e=t.filter((s,r)=>r%4===3&&r<12),i=t.filter((s,r)=>r%4!==3&&r<12);return{metres:al(e,"length"),radians:2*al(i,"plain")}}var lw=/[-+−]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?/g;function cw(n){let t=(n.replaceAll("\u2212","-").match(lw)??[]).map(Number);if(t.length!==16&&t.length!==12)throw new Error(`${t.length===1?"1 number was":`${t.length} numbers were`} found; a pose has 16 (four rows) or 12 (three rows)`);let e=t.length===16?t:[...t,0,0,0,1];if(Math.abs(e[12])+Math.abs(e[13])+Math.abs(e[14])+Math.abs(e[15]-1)>1e-9)throw new Error("the last row must be 0 0 0 1");if(!e.every(Number.isFinite))throw new Error("a number is not finite");let i=Nu(e);if(i>OL)throw new Error(i===1/0?"the upper left block is left-handed, so it is no rotation":`the upper left block is no rotation: its rows miss being perpendicular unit vectors by ${i.toPrecision(2)}`);for(let s of[3,7,11])e[s]/=mt.factor("length");return Uu(e)}function Kf(n){return n.map((t,e)=>{let i=b.table.joints[e];if(i.type!=="R")return t;let s=t+2*Math.PI*Math.round((b.q[e]-t)/(2*Math.PI));return(i.lower===null||s>=i.lower-1e-9)&&(i.upper===null||s<=i.upper+1e-9)?s:t})}function uw(n,t){let e=t?.self_motions??[],i=fe.task??b.plan?.task,s=i==="pose";n.classList.toggle("stale",t?.self_motions===null);for(let d of n.querySelectorAll("input"))d.disabled=t?.self_motions===null;if(t?.self_motions===null&&n.childElementCount)return;let r=t?.self_motions===null?"pending":t?.self_motions;if(n.drawn===r)return;if(n.drawn=r,r==="pending"){Gt(n,M("p",{class:"hint",text:"Following the self-motions of this pose \u2026"}));return}let o=i==="position"?"the tool point stands still":i==="pose"?"the tool stands still":"the tool point and its axis stand still",a=d=>d.dimension>1?`one line in a surface of ${d.dimension} dimensions`:d.closed?"a closed curve":"an open curve",c=(d,f)=>{let p=d.moves.length>3?"most of its joints":d.moves.join(" and "),_=d.inside.length?GL(d):"All of it lies outside the limits.";return M("div",{class:"self-motion"},M("p",{},M("strong",{text:e.length>1?`Self-motion ${f+1} of ${e.length}`:"Self-motion"}),` by ${p}, ${a(d)}: the arm moves, ${o}. ${_}`),WL(d,f,t.T,s))},l=e.length?zL(e):-1,u=e.map((d,f)=>f===l?null:c(d,f)).filter(Boolean),h=u.length?M("details",{class:"fold"},M("summary",{text:u.length===1?"One other self-motion":`${u.length} other self-motions`}),u):null;Gt(n,l>=0?c(e[l],l):null,h)}var kL=n=>n.reduce((t,e,i)=>t+Math.sin((e-b.q[i])/2)**2,0),zL=n=>{let t=n.map(e=>Math.min(...e.q.map(kL)));return t.indexOf(Math.min(...t))};function HL(n){let t=(s,r)=>s.map((o,a)=>b.table.joints[a]?.type==="P"?o-r[a]:Math.atan2(Math.sin(o-r[a]),Math.cos(o-r[a]))),e=n.s[0],i=1/0;for(let s=0;s+1<n.q.length;s++){let r=t(n.q[s+1],n.q[s]),o=t(b.q,n.q[s]),a=r.reduce((u,h)=>u+h*h,0),c=a>0?Math.min(Math.max(r.reduce((u,h,d)=>u+h*o[d],0)/a,0),1):0,l=r.reduce((u,h,d)=>u+(o[d]-c*h)**2,0);l<i&&([i,e]=[l,n.s[s]+c*(n.s[s+1]-n.s[s])])}return e}var GL=({inside:n})=>n.length===1&&n[0][0]<=1e-9&&n[0][1]>=1-1e-9?"":`Inside the limits: ${n.map(([t,e])=>`${(100*t).toFixed(1)} to ${(100*e).toFixed(1)} %`).join(", ")} of it.`;function VL(n){let t=[],e=0;for(let[i,s]of n)t.push(`var(--wrong-soft) ${100*e}% ${100*i}%`,`var(--good) ${100*i}% ${100*s}%`),e=s;return t.push(`var(--wrong-soft) ${100*e}% 100%`),`linear-gradient(to right, ${t.join(", ")})`}function WL(n,t,e,i){let s=M("input",{type:"range",min:"0",max:"1",step:"any",value:"0","aria-label":`Along self-motion ${t+1}`,"data-testid":`self-motion-${t+1}`}),r=()=>{gi();let o=Number(s.value),a=Math.max(n.s.findLastIndex(h=>h<=o),0),c=Math.min(a+1,n.q.length-1),l=c>a?(o-n.s[a])/(n.s[c]-n.s[a]):0;s.style.setProperty("--at",`${100*o}%`);let u=n.q[a].map((h,d)=>h+l*(n.q[c][d]-h));ut("did",{label:"slide along a self-motion",key:"self-motion"}),Oi(Kf(i?Jx(b.table,u,e):u),"self-motion")};return s.value=String(HL(n)),s.style.setProperty("--at",`${100*Number(s.value)}%`),s.classList.add("parts"),s.style.setProperty("--parts",VL(n.inside)),s.dataset.inside=JSON.stringify(n.inside),s.addEventListener("input",r),s.addEventListener("keydown",o=>{let a={ArrowRight:1,ArrowUp:1,ArrowLeft:-1,ArrowDown:-1,PageUp:10,PageDown:-10}[o.key];if(!a)return;o.preventDefault();let c=Number(s.value)+a/100;s.value=String(n.closed?c-Math.floor(c):Math.min(Math.max(c,0),1)),r()}),s}function hw(){let n=[],t=[],e={},i=M("div",{class:"joints"}),s=M("details",{},M("summary",{class:"hint",text:"Hold by value"}),i),r=M("p",{class:"hint"}),o=Be("Redundant coordinates",[["free","Free"],["chosen","Chosen"]],"free",f=>c(f==="chosen"?n.filter(p=>!p.instead).map(p=>p.name):null),"spare-mode"),a=M("div",{class:"spare",role:"group","aria-label":"Redundant coordinates of the arm","data-testid":"spare",hidden:!0},M("div",{class:"line spread"},M("span",{class:"field-name",text:"Redundant coordinates"}),o),r,s);function c(f,{sliding:p=!1}={}){ut("did",{label:f?`hold ${f.join(" and ")}`:"free the redundant coordinates",key:"spare"}),fe.redundancy=f&&Object.fromEntries(f.map(_=>[_,e[_]])),d(),p?Lb():Os({follow:!0})}let l=f=>n.filter(p=>p.instead===f.instead).map(p=>p.name),u=f=>b.table.joints.findIndex(p=>p.name===f.name);function h(f,p){let _=f.kind==="angle"?Math.PI:Gn(b.table),m=f.lower??-_,g=f.upper??_,x=M("input",{type:"range",min:String(m),max:String(g),step:"any","aria-label":`Slide ${f.name}`,"data-testid":`spare-slider-${p+1}`}),S=!1,v=(E,U)=>{e[f.name]=E,c(l(f),{sliding:U})};x.addEventListener("input",()=>v(Number(x.value),!0)),x.addEventListener("change",()=>Os({follow:!0})),x.addEventListener("keydown",E=>{let U={ArrowRight:1,ArrowUp:1,ArrowLeft:-1,ArrowDown:-1,PageUp:10,PageDown:-10}[E.key];if(U===void 0)return;E.preventDefault(),S=!0;let L=U*mt.step(f.kind)*(E.shiftKey?.1:1);v(Math.min(Math.max(e[f.name]+L,m),g),!0)}),x.addEventListener("keyup",()=>{S&&Os({follow:!0}),S=!1});let A=Mn({label:`Value of ${f.name}`,kind:f.kind,testid:`spare-${p+1}`,check:E=>E<m-1e-9&&f.lower!==null?`below the limit ${ce(m,f.kind)}`:E>g+1e-9&&f.upper!==null?`above the limit ${ce(g,f.kind)}`:null,commit:E=>v(E,!1)}),w=M("span",{class:"limits"}),y=M("div",{class:"joint"},M("span",{class:"joint-name",text:f.name}),M("div",{class:"track"},x,M("div",{class:"under"},w)),A,M("span",{class:"unit"}));return{line:y,show(){let E=e[f.name];x.value=E,x.style.setProperty("--at",`${100*(Math.min(Math.max(E,m),g)-m)/(g-m||1)}%`),x.setAttribute("aria-valuetext",ce(E,f.kind)),y.classList.toggle("held",!!(fe.redundancy&&f.name in fe.redundancy)),A.put(Number((E*mt.factor(f.kind)).toFixed(mt.digits(f.kind)+1))/mt.factor(f.kind))},relabel(){bt(y.lastChild,mt.symbol(f.kind));let E=U=>U===null?"no limit":ce(U,f.kind,f.kind==="angle"&&mt.angle==="deg"?0:void 0);bt(w,f.lower===null&&f.upper===null?"no limits":`${E(f.lower)} \u2026 ${E(f.upper)}`),A.refresh()}}}function d(){for(let f of n)fe.redundancy&&f.name in fe.redundancy?e[f.name]=fe.redundancy[f.name]:u(f)>=0?e[f.name]=b.q[u(f)]:f.instead&&Number.isFinite(b.solutions?.arm_angle)?e[f.name]=b.solutions.arm_angle:e[f.name]??=0;o.mark(fe.redundancy?"chosen":"free"),bt(r,fe.redundancy?"Held at these values; what is left has separate solutions.":"Free: the solutions form self-motions; the table has those at the present values.");for(let f of t)f.show()}return et("solutions",()=>{let f=b.solutions?.spare;if(!b.solutions||!f&&(b.solutions.brief||b.solutions.status==="REFUSED"))return;let p=JSON.stringify(f??[])!==JSON.stringify(n);if(p){n=f??[],e={},t=n.map(h),Gt(i,t.map(_=>_.line));for(let _ of t)_.relabel()}a.hidden=n.length===0,p&&(s.open=n.filter(_=>!_.instead).length>1||!!fe.redundancy),d()}),et("q",()=>!a.hidden&&!a.closest("[hidden]")&&!fe.redundancy&&d()),et("units",()=>{for(let f of t)f.relabel();d()}),a}function dw(){let n=M("thead"),t=M("tbody"),e=M("p",{class:"hint below",text:"Grey rows lie outside the limits; the joints in red exceed them."}),i=M("div",{class:"scroll"},M("table",{class:"plain solutions","data-testid":"solutions","aria-label":"Solutions"},n,t),e),s=[],r="",o=()=>{let c=`${b.table.joints.map(l=>l.type).join("")}${mt.angle}${mt.length}`;c!==r&&(r=c,s=[],i.classList.toggle("many",b.table.joints.length>6),Gt(t),Gt(n,M("tr",{},M("td"),M("th",{class:"left",text:"posture"}),b.table.joints.map((l,u)=>M("th",{},M("i",{text:"q"}),M("sub",{text:String(u+1)}),M("span",{class:"unit",text:` ${mt.symbol(Ze(l))}`}))),M("th",{text:"off, mm",title:"By how much forward kinematics misses the pose"}))))},a=c=>{let l=b.table.joints.map(()=>M("td")),u=M("span"),h=M("span",{class:"offscreen"}),d=M("td",{class:"unit"}),f=M("tr",{tabindex:"0","data-testid":`solution-${c+1}`},M("th",{scope:"row",text:String(c+1)}),M("td",{class:"left"},u,h),l,d),p=()=>b.solutions?.rows[c]?.q,_=()=>p()&&ps(p()),m=()=>ps(null),g=()=>{p()&&(ps(null),Pi(Kf(p()),.8,`move to solution ${c+1}`))};return f.addEventListener("pointerenter",_),f.addEventListener("pointerleave",m),f.addEventListener("focus",_),f.addEventListener("blur",m),f.addEventListener("click",g),f.addEventListener("keydown",x=>{(x.key==="Enter"||x.key===" ")&&(x.preventDefault(),g())}),{tr:f,cells:l,label:u,beyond:h,residual:d}};return{el:i,show(c){o();let l=c?.rows??[];for(;s.length<l.length;){let u=a(s.length);s.push(u),t.append(u.tr)}i.hidden=l.length===0,e.hidden=l.every(u=>u.inside),s.forEach((u,h)=>{let d=l[h];u.tr.hidden=!d,d&&(u.tr.classList.toggle("beyond",!d.inside),d.label!==null&&bt(u.label,`${d.label}${d.self_motion>=0?" (of a self-motion)":""}`),bt(u.beyond,d.inside?"":", outside the limits"),bt(u.residual,d.residual?tf(d.residual[0]*1e3):""),u.residual.title=d.residual?`${tf(d.residual[0])} m, ${tf(d.residual[1])} rad by forward kinematics`:"",d.q.forEach((f,p)=>{let _=b.table.joints[p],m=_.lower!==null&&f<_.lower-1e-9||_.upper!==null&&f>_.upper+1e-9;bt(u.cells[p],mn(f,Ze(_))),u.cells[p].classList.toggle("out",m)}))}),this.mark()},mark(){let c=b.solutions?.rows??[];s.forEach((l,u)=>l.tr.classList.toggle("here",!!c[u]&&c[u].q.length===b.q.length&&c[u].q.every((h,d)=>Math.abs(Math.sin((h-b.q[d])/2))<1e-5)))}}}var $L={SOLVED:"good",SINGULAR:"note",REDUNDANT:"note",OUT_OF_REACH:"wrong",OUTSIDE_LIMITS:"wrong",UNCERTAIN:"wrong",REFUSED:"wrong"},j0={OUT_OF_REACH:"Out of reach",OUTSIDE_LIMITS:"Outside the limits",UNCERTAIN:"Not certain",REFUSED:"Refused"},qL=new Set(["REDUNDANT","UNCERTAIN","SINGULAR"]),XL=(n,t)=>`Listed ${n===1?"is 1 posture":`are ${n} postures`}${t===n?"":`, ${t} inside the limits`}.`,Z0=120;function J0(){Si(b.frames[b.frames.length-1].slice(),"taken")}var pw={id:"inverse",title:"Inverse",wide:!0,build(n,t){n.append(M("div",{class:"line spread"},Ut("Take the present pose",{"data-testid":"take-pose"},J0),Be("Target as",[["numbers","Position and angles"],["matrix","Matrix"]],"numbers",_=>{i.hidden=_!=="numbers",s.hidden=_!=="matrix"},"target-as")));let e=Hs("Target","target",()=>b.target,(_,m)=>Si(_,"typed",m)),i=M("div",{},e.el),{el:s,show:r}=jL();n.append(i,s,ZL());let o=M("p",{class:"verdict","data-testid":"ik-verdict",role:"status"}),a=M("div",{class:"near","data-testid":"ik-nearest"}),c=M("div",{class:"self-motions","data-testid":"self-motions"}),l=dw();n.append(hw(),o,a,c,l.el);let u=ya(Z0,()=>{e.show(),r()}),h=ya(Z0,()=>{if(t.hidden)return;let _=b.solutions;JL(o,_),tD(a,_),uw(c,_),l.show(_)}),d=ya(Z0,()=>l.mark()),f=_=>()=>cf()?_.soon():_();et("target",f(u)),et("notation",e.show),et(["solutions","units"],f(h)),et("q",f(d));let p=()=>Br("target",b.panel==="inverse"?YL(te(b.target)):[]);et("target",_=>_!=="drag"&&p()),et("panel",_=>{ob(_==="inverse"),(_!=="inverse"||b.hasTarget)&&p(),_==="inverse"&&(b.hasTarget?ut("solutions"):(b.hasTarget=!0,J0()))}),et("table",_=>{_==="new"&&(b.hasTarget=b.panel==="inverse",b.hasTarget&&J0())})}};function YL(n){let t=.25*Gn(b.table);return[0,1,2].flatMap(e=>[t,-t].map(i=>n.map((s,r)=>r===e?s+i:s)))}function jL(){let n=M("textarea",{rows:"4","aria-label":"Target as a matrix","data-testid":"target-matrix",spellcheck:"false"}),t=M("p",{class:"reason",role:"alert"}),e=M("p",{class:"hint"});n.addEventListener("input",()=>{try{Si(cw(n.value),"typed",aw(n.value)),bt(t,""),n.removeAttribute("aria-invalid")}catch(s){bt(t,s.message),n.setAttribute("aria-invalid","true")}});let i=()=>{if(bt(e,`Twelve or sixteen numbers, row by row; the last column in ${mt.length}.`),document.activeElement===n)return;let s=b.target.map((r,o)=>o%4===3&&o<12?r*mt.factor("length"):r);n.value=Yf(s.map(r=>Number(r.toFixed(6)))).replaceAll(`,
`,`
`)};return et("units",i),i(),{el:M("div",{hidden:!0},n,e,t),show:i}}function ZL(){let n=M("span",{class:"line"}),t=M("input",{type:"checkbox",checked:!0,"data-testid":"follow",on:{change:()=>{fe.follow=t.checked}}}),e=Be("Ghosts",[["all","All"],["inside","In limits"],["none","None"]],"all",i=>{fe.ghosts=i,dl()});return et("task",()=>{t.checked=fe.follow,e.mark(fe.ghosts)}),et("plan",()=>Gt(n,b.plan?.solvable?[M("span",{class:"field-name",text:"Task"}),hn("Task",[["",`${b.plan.task} (default)`],["pose","pose"],["position","position"],["position+axis","position + axis"]],fe.task??"",i=>{ut("did",{label:"choose the task"}),fe.task=i||null,fe.redundancy=null,Os()},{"data-testid":"task"})]:[])),M("div",{class:"line controls"},M("span",{class:"line"},M("span",{class:"field-name",text:"Handles"}),Be("Handles",[["both","Both"],["move","Move"],["turn","Turn"]],"both",ab)),Be("Axes of the handles",[["local","Tool"],["world","World"]],"local",lb),M("span",{class:"line"},M("span",{class:"field-name",text:"Snap"}),hn("Snap to whole steps",[["0","off"],["1","1 mm, 1\xB0"],["5","5 mm, 5\xB0"],["10","10 mm, 10\xB0"],["45","45 mm, 45\xB0"]],"0",i=>cb(Number(i)),{"data-testid":"snap",title:"While dragging; Shift snaps to 5 at any time"})),M("span",{class:"line"},M("span",{class:"field-name",text:"Ghosts"}),e),M("label",{class:"check"},t,"Arm follows"),n)}function JL(n,t){if(!t){Gt(n,M("span",{text:"Solving \u2026"})),n.dataset.tone="note";return}let e=t.rows.length,i=t.rows.filter(a=>a.inside).length;n.dataset.tone=$L[t.status]??"note";let s=e>0&&qL.has(t.status),r=t.status==="SOLVED"&&e?fw(t.missed):[t.why,s&&(t.status==="SINGULAR"||i<e)?XL(e,i):"",fw(t.missed)].filter(Boolean).join(" "),o=j0[t.status]&&!i?t.why.toLowerCase().includes(j0[t.status].toLowerCase())?"":j0[t.status]:s?"":`${e} solution${e===1?"":"s"}${i===e?"":`, ${i} inside the limits`}`;Gt(n,M("strong",{text:o})," ",M("span",{text:r}),t.ms===void 0?null:M("span",{class:"hint took",text:`${t.ms<1?`${Math.round(t.ms*1e3)} \xB5s`:`${t.ms.toFixed(1)} ms`}`}))}var fw=n=>n?`The pose was rounded by ${QL(n)||"less than its digits"} when typed; solved is the nearest one that the arm takes.`:"",KL=(n,t)=>ce(n,t,mt.digits(t)+2),QL=n=>[[n.metres,"length"],[n.radians,"angle"]].filter(([t,e])=>t*mt.factor(e)>=.5*10**-(mt.digits(e)+2)).map(([t,e])=>KL(t,e)).join(" and ");function tD(n,t){let e=t?.near;if(!e){Gt(n);return}let i=te(e.T).map(s=>mn(s,"length")).join(", ");Gt(n,M("p",{},M("strong",{text:"Nearest reachable: "}),`${i} ${mt.symbol("length")}, ${ce(e.metres,"length")} away`,e.radians>.001?`, turned by ${ce(e.radians,"angle")}`:""),M("div",{class:"line"},Ut("Go there",{},()=>Pi(e.q)),Ut("Make it the target",{},()=>Si(e.T,"chosen"))))}var K0=(n,t)=>{let e=Math.cos(t),i=Math.sin(t);return[1,0,0,n,0,e,-i,0,0,i,e,0,0,0,0,1]};function Qf(n){return K0(n[3],Math.atan2(n[9],n[5])).every((e,i)=>Math.abs(e-n[i])<1e-12)?{a:n[3],alpha:Math.atan2(n[9],n[5])+0}:null}function tp(n,t){if(n.convention===t||!n.joints.length)return{...n,convention:t};let e=n.joints,i=e.length,s=e.map(({a:c,alpha:l,text:u})=>({a:c,alpha:l,text:u})),{base:r,tool:o}=n,a;if(t==="modified"){let c=Qf(r)??{a:0,alpha:0};Qf(r)&&(r=Zi()),o=Hn(K0(s[i-1].a,s[i-1].alpha),o),a=[c,...s.slice(0,-1)]}else{let c=Qf(o)??{a:0,alpha:0};Qf(o)&&(o=Zi()),r=Hn(r,K0(s[0].a,s[0].alpha)),a=[...s.slice(1),c]}return{...n,convention:t,base:r,tool:o,joints:e.map((c,l)=>({...c,a:a[l].a,alpha:a[l].alpha,text:{...c.text,a:a[l].text?.a,alpha:a[l].text?.alpha}}))}}var mw=30,eD=n=>({name:`joint_${n+1}`,type:"R",a:0,alpha:0,d:0,theta:0,lower:null,upper:null,sign:1,offset:0}),nD={a:"a",alpha:"\u03B1",d:"d",theta:"\u03B8",lower:"lower limit",upper:"upper limit",offset:"zero"},Cl=null;function gw(n,t){Cl={label:n,key:"paste",open:!0};try{t(Cl)}finally{Cl=null,ut("let-go")}}function ep(n,t,e,{symbolic:i,text:s},r){let o=b.table.joints.map((u,h)=>h!==n?u:{...u,[t]:e,text:{...u.text,[t]:i?s:void 0}}),a=Object.is(b.table.joints[n][t],e)&&b.table.joints[n].text?.[t]===o[n].text[t],l={what:"cell",label:`edit ${nD[t]??t} of joint ${n+1}`,key:`${n}/${t}`,open:!0};a||yn({...b.table,joints:o},Cl?{...l,...Cl}:l),r&&!Cl&&ut("let-go")}function Pl(n,t,e,{key:i,open:s}={}){let{postures:r,coupling:o}=b.table,a=Object.fromEntries(Object.entries(r??{}).map(([u,h])=>[u,t(h,0)])),c=t(b.q,0),l=o?t(o,null).map((u,h)=>iD(u&&t(u,0),h,n.length)):null;yn({...b.table,joints:n,postures:a,coupling:l},{q:c,what:"rows",label:e,key:i,open:s})}var iD=(n,t,e)=>n??Array.from({length:e},(i,s)=>+(s===t));function xw(n,t,e){let i=b.table.joints[n];return e===null?null:t==="lower"&&i.upper!==null&&e>i.upper?"above the upper limit":t==="upper"&&i.lower!==null&&e<i.lower?"below the lower limit":null}function Q0({label:n,key:t,open:e}={}){let i=b.table.joints.length;return i>=mw?(we(`At most ${mw} joints.`,"wrong"),!1):(Pl([...b.table.joints,eD(i)],(s,r)=>[...s,r],n??`add joint ${i+1}`,{key:t,open:e}),document.querySelector(`[data-testid="dh-${i+1}-a"]`)?.focus(),!0)}function _w(n,t){let e=i=>{let s=i.slice();return[s[n],s[t]]=[s[t],s[n]],s};Pl(e(b.table.joints),e,`swap joints ${n+1} and ${t+1}`)}async function np(){try{ui(`${b.table.name||"arm"}.toml`,(await Oe("save",{})).text,"application/toml")}catch(n){we(n.message,"wrong")}}function bw(){let n=(t,e,i)=>{let s=M("input",{type:"file",class:"offscreen",tabindex:"-1",...i,on:{change:()=>rD(s)}});return[Ut(t,{title:e},()=>s.click()),s]};return[...n("Open\u2026","A robot file (.toml) or a URDF",{accept:".toml,.urdf,.xml","aria-label":"Robot file","data-testid":"robot-file"}),...n("Folder\u2026","A folder with a URDF and the meshes that it names; they stay in this browser",{webkitdirectory:!0,multiple:!0,"aria-label":"Folder with a robot file and its meshes","data-testid":"robot-folder"})]}var sD=/\.(toml|urdf|xml)$/i,yw=2e5;async function rD(n){let t=[...n.files];if(n.value="",!t.length)return;let e=t.filter(s=>sD.test(s.name)),i=t.length===1?t[0]:e.find(s=>/\.urdf$/i.test(s.name))??e[0];if(!i){we("There is no robot file (.urdf or .toml) in this folder.","wrong");return}if(i.size>yw){we(`${i.name} has ${i.size} bytes; a robot file has at most ${yw.toLocaleString("en")}.`,"wrong");return}try{let{table:s,looks:r}=await Fi("open",{name:i.name.slice(-80),text:await i.text()});yn(s,{q:_a(s),what:"new",label:`open ${i.name.slice(-40)}`}),Rl(r,s,a=>vw(t,a));let o=r?.shapes.filter(a=>a.file&&!vw(t,a.file)).length;o&&we(`${o} of its meshes were not opened with it: open the folder that holds them.`)}catch(s){we(s.message,"wrong")}}function vw(n,t){let e=t.replace(/^\w+:\/\//,"").split("/"),i=s=>{let r=(s.webkitRelativePath||s.name).split("/"),o=0;for(;o<e.length&&o<r.length&&e.at(-1-o)===r.at(-1-o);)o+=1;return o};return n.reduce((s,r)=>i(r)>(s?i(s):0)?r:s,null)}var tx=(n,t,e,i=!1)=>Ut(n,{class:"icon","aria-label":t,disabled:i},e),bo=({k:n,n:t,name:e,move:i=null,remove:s})=>[...i?[tx("\u2191",`Move ${e} up`,()=>i(n,n-1),n===0),tx("\u2193",`Move ${e} down`,()=>i(n,n+1),n===t-1)]:[],tx("\xD7",`Remove ${e}`,()=>s(n))];var ex={geometry:[["a","a","length"],["alpha","\u03B1","angle"],["d","d","length"],["theta","\u03B8","angle"]],joint:[["lower","lower limit",null],["upper","upper limit",null],["offset","zero",null]]},oD=({catalog:n,...t})=>n?{...t,derived:n}:t,aD=n=>n.type==="R"?"angle":"length",Mw={id:"table",title:"DH table",wide:!0,build(n){let t="geometry",e=[],i=M("thead"),s=M("tbody"),r=M("table",{class:"dh","data-testid":"dh-table","aria-label":"DH table"},i,s),o=M("p",{class:"reason",role:"alert","data-testid":"dh-wrong"}),a=M("p",{class:"verdict","data-testid":"arm-kind"}),c=Be("Convention",[["standard","Standard"],["modified","Modified (Craig)"]],b.table.convention,x=>{x!==b.table.convention&&yn(tp(b.table,x),{what:"rows",label:`make the table ${x}`})},"convention"),l=M("p",{class:"hint order"}),u=M("input",{type:"text","aria-label":"Name of the arm","data-testid":"arm-name",maxlength:"60",on:{change:()=>yn({...oD(b.table),name:u.value||"my-arm"},{what:"name",label:"name the arm"})}}),h=Hs("Base","base",()=>b.table.base,x=>yn({...b.table,base:x},{what:"cell",label:"edit the base",key:"base",open:!0})),d=Hs("Tool","tool",()=>b.table.tool,x=>yn({...b.table,tool:x},{what:"cell",label:"edit the tool",key:"tool",open:!0}));n.append(M("div",{class:"line spread"},M("span",{class:"line"},u),M("span",{class:"line"},Ut("Blank",{title:"An empty table"},()=>yn(Kx(b.table.convention),{q:[],what:"new",label:"begin a blank table"})),...bw(),Ut("Save",{title:"As a robot file"},np))),M("div",{class:"line spread"},c,Be("Columns",[["geometry","Geometry"],["joint","Limits and zeros"]],t,x=>{t=x,m()},"dh-part")),l,r,M("div",{class:"line"},Ut("+ Add joint",{class:"add","data-testid":"add-joint"},()=>Q0()),M("span",{class:"hint",text:"Numbers or expressions: pi/2, 90 deg, 0.5 m, 125+85. With pi, an angle is in radians. Arrows and Enter go from cell to cell, Alt and an arrow steps; a table can be pasted."})),o,a,Gv(),M("details",{class:"fold","data-testid":"base-tool"},M("summary",{text:"Base and tool"}),h.el,d.el)),s.addEventListener("paste",x=>{let S=Tf(x.clipboardData.getData("text")),v=()=>[...s.rows].map(y=>[...y.querySelectorAll("input.number")]);if(!S||!x.target.matches("input.number"))return;x.preventDefault();let A=v().findIndex(y=>y.includes(x.target)),w=v()[A].indexOf(x.target);gw("paste a table",y=>{for(;b.table.joints.length<A+S.length&&Q0(y););let E=Af(v(),A,w,S),U=S.flat().length;we(`Pasted ${E} number${E===1?"":"s"}${E<U?`; ${U-E} had no cell`:""}`)})}),n.addEventListener("verdict",x=>{let S=x.detail??lD(n);bt(o,S?`${S.label}: ${S.reason}. The arm stays as it was.`:"")});let f=(x,S,[v,A,w])=>{let y=x.type==="R"&&v==="theta"||x.type==="P"&&v==="d",E=v==="lower"||v==="upper",U=Mn({label:`Joint ${S+1}, ${A}`,kind:w??aD(x),testid:`dh-${S+1}-${v}`,empty:E?null:void 0,check:L=>E?xw(S,v,L):L!==null&&Math.abs(L)>1e6?"larger than a million":null,input:(L,N)=>ep(S,v,L,N,!1),commit:(L,N)=>ep(S,v,L,N,!0)});return E&&(U.placeholder="none"),e.push({f:U,i:S,key:v}),M("td",{class:y?"variable":""},y?M("span",{class:"plus"},M("i",{text:"q"}),M("sub",{text:String(S+1)})," +"):null,U)},p=(x,S)=>Ut(x.type,{class:`type type-${x.type}`,"data-testid":`dh-${S+1}-type`,"aria-label":`Joint ${S+1} is ${x.type==="R"?"revolute":"prismatic"}; press to change`,title:x.type==="R"?"Revolute: turns. Press for prismatic.":"Prismatic: slides. Press for revolute."},()=>Pl(b.table.joints.map((v,A)=>A===S?{...v,type:v.type==="R"?"P":"R",lower:null,upper:null,offset:0,text:{...v.text,lower:void 0,upper:void 0,offset:void 0}}:v),v=>v.map((A,w)=>w===S&&typeof A=="number"?0:A),`make joint ${S+1} ${x.type==="R"?"prismatic":"revolute"}`)),_=(x,S)=>M("td",{class:"tools"},bo({k:x,n:S,name:`joint ${x+1}`,move:_w,remove:()=>Pl(b.table.joints.filter((v,A)=>A!==x),v=>v.filter((A,w)=>w!==x),`remove joint ${x+1}`)})),m=()=>{e=[];let{joints:x}=b.table,S=b.table.convention==="modified",v=t==="geometry"?ex.geometry.map(([A,w,y])=>M("th",{scope:"col"},M("i",{text:w}),M("sub",{text:S&&(A==="a"||A==="alpha")?"i\u22121":"i"}),M("span",{class:"unit",text:` ${mt.symbol(y)}`}))):["name","lower limit","upper limit","zero","sense"].map(A=>M("th",{scope:"col",text:A}));Gt(i,M("tr",{},M("th",{scope:"col",text:"i"}),M("th",{scope:"col"},M("span",{class:"offscreen",text:"type"})),v,M("td"))),Gt(s,x.map((A,w)=>{let y=t==="geometry"?ex.geometry.map(E=>f(A,w,E)):[M("td",{},M("input",{type:"text",class:"name",value:A.name,maxlength:"40","aria-label":`Joint ${w+1}, name`,on:{change:E=>ep(w,"name",E.target.value||`joint_${w+1}`,{},!0)}})),...ex.joint.map(E=>f(A,w,E)),M("td",{},Ut(A.sign>0?"+":"\u2212",{class:"type","aria-label":`Joint ${w+1}, sense of the maker: ${A.sign>0?"as the table":"against the table"}`},()=>Pl(b.table.joints.map((E,U)=>U===w?{...E,sign:-E.sign}:E),E=>E,`turn the sense of joint ${w+1}`)))];return M("tr",{"data-testid":`dh-row-${w+1}`},M("th",{scope:"row",text:String(w+1)}),M("td",{},p(A,w)),y,_(w,x.length))})),x.length||s.append(M("tr",{},M("td",{colspan:"7",class:"hint",text:"No joints yet."}))),g()},g=()=>{for(let{f:x,i:S,key:v}of e){let A=b.table.joints[S];x.put(A[v],A.text?.[v]??null)}c.mark(b.table.convention),bt(l,b.table.convention==="standard"?"A\u1D62 = Rz(\u03B8) Tz(d) Tx(a) Rx(\u03B1)":"A\u1D62 = Rx(\u03B1) Tx(a) Rz(\u03B8) Tz(d), each row with the a and \u03B1 before its joint"),document.activeElement!==u&&(u.value=b.table.name),h.show(),d.show()};et("table",x=>{bt(o,""),x==="cell"||x==="name"||x==="postures"?g():m()}),et("units",m),et("notation",()=>{h.show(),d.show()}),et("plan",()=>{a.dataset.tone=b.plan?.solvable?"good":"wrong",Gt(a,M("strong",{text:ku(b.plan)||(b.plan?.refused?"Refused":"Not solved")})," ",M("span",{text:b.plan?.explain??""}))}),m()}};function lD(n){let t=n.querySelector(".number.wrong");return t?{label:t.getAttribute("aria-label"),reason:t.title}:null}var cD=4,uD=n=>{let t=n.toFixed(cD);return Number(t)<0?`(${t})`:t.replace("-","")};function ip(n,t,e){let i=vr(t,e),s=t.joints.map((l,u)=>yr(l,i[u])),r=l=>l.reduce((u,[h,d])=>u+d*s[h-1].theta,0),o={cos:l=>Math.cos(r(l)),sin:l=>Math.sin(r(l)),slide:([[l]])=>s[l-1].d};return n.symbols.reduce((l,u)=>l.replaceAll(u.latex,uD(o[u.is](u.joints))),n.latex).replaceAll("\\left(","(").replaceAll("\\right)",")").replace(/(\d|\))\s+(?=\d|\()/g,"$1 \\cdot ")}var sp=null;async function hD(){return sp??=(await import("./katex-PEGWDONQ.js")).default,sp}function dD(n,t){let e=M("span");try{n.render(t.latex,e,{throwOnError:!0,strict:!1,trust:!1})}catch{e.textContent=t.text}return e}function Sw(n,t){let e=[[i=>typeof i=="string",i=>i],[i=>"latex"in i,i=>dD(n,i)],[i=>"code"in i,i=>M("code",{text:i.code})],[()=>!0,i=>M("em",{text:i.emphasis})]];return t.map(i=>e.find(([s])=>s(i))[1](i))}var fD=n=>n.map(t=>typeof t=="string"?t:t.latex?`$${t.latex}$`:t.code??t.emphasis).join("");function pD(n){let t=b.table.joints.map((e,i)=>M("th",{},M("i",{text:"q"}),M("sub",{text:String(i+1)}),M("span",{class:"unit",text:` ${mt.symbol(Ze(e))}`})));return[M("h3",{text:"The formulas at the present pose"}),M("table",{class:"plain","data-testid":"formula-values","aria-label":"Branches of the formulas at the present pose"},M("thead",{},M("tr",{},M("th",{text:"branch"}),t)),M("tbody",{},n.map((e,i)=>M("tr",{},M("th",{scope:"row",text:String(i+1)}),e.map((s,r)=>M("td",{text:mn(s,Ze(b.table.joints[r]))}))))))]}var ww={id:"equations",title:"Equations",wide:!0,build(n,t){let e="forward",i="symbols",s=null,r=[],o=[],a=M("p",{class:"hint",role:"status","data-testid":"equations-note"}),c=M("div",{class:"equations",tabindex:"0",role:"region","aria-label":"Equations","data-testid":"equations"}),l=Be("Written with",[["symbols","Symbols"],["numbers","Lengths"],["present","Numbers"]],i,v=>{i=v,_()},"equation-numbers"),u=M("div",{class:"scroll"});n.append(M("div",{class:"line spread"},M("span",{class:"line"},Be("Equations",[["forward","Forward"],["inverse","Inverse"],["singular","Singularities"]],e,v=>{e=v,_()},"which-equations"),l),Ut("Copy LaTeX",{class:"quiet"},()=>jr(f()))),a,u,c);let h=v=>v.symbols&&i==="present"?ip(v,b.table,b.q):v.latex,d=v=>v.number===void 0?"":` \\tag{${v.number}}`,f=()=>o.map(v=>v.kind==="equation"?`\\[ ${h(v)}${d(v)} \\]`:fD(v.pieces)).join(`

`);function p(v){r=[],Gt(c,o.map(A=>m(v,A))),g()}async function _(){if(t.hidden||!b.table.joints.length)return;let v=`${e}/${i}/${JSON.stringify(b.table.joints)}${b.table.convention}`;if(s!==v){s=v,bt(a,"Deriving \u2026"),Gt(c);try{let[A,w]=await Promise.all([hD(),Oe("equations",{which:e,numbers:i==="symbols"?i:"numbers"},y=>bt(a,y.note??""))]);if(s!==v)return;bt(a,w.note??""),o=w.blocks,p(A),l.hidden=e!=="forward",Gt(u),x()}catch(A){if(s!==v)return;s=null,bt(a,A.message)}}}function m(v,A){if(A.kind==="heading"||A.kind==="step")return M("h3",{},Sw(v,A.pieces));if(A.kind!=="equation")return M("p",{class:"prose"},Sw(v,A.pieces));let w=M("div",{class:"formula"});try{v.render(h(A),w,{displayMode:!0,throwOnError:!0,strict:!1,trust:!1,maxSize:20,maxExpand:1e3})}catch{w.replaceChildren(M("code",{text:h(A)}))}if(A.number!==void 0)return M("div",{class:"formula-row numbered"},w,M("span",{class:"hint",text:`(${A.number})`}));if(A.entry===void 0)return w;let y=M("output",{class:"value","data-entry":String(A.entry)});return r.push({value:y,entry:A.entry}),M("div",{class:"formula-row"},w,y)}let g=Js(()=>{if(t.hidden)return;let v=b.frames[b.frames.length-1];for(let{value:A,entry:w}of r)bt(A,`= ${w%4===3?`${ii(v[w]*mt.factor("length"),mt.digits("length"))} ${mt.length}`:ii(v[w],4)}`)}),x=Ks(async()=>{if(!(t.hidden||e!=="inverse"||!c.childElementCount))try{let{rows:v}=await Oe("formulas",{T:b.frames.at(-1)});Gt(u,v.length&&e==="inverse"?pD(v):null)}catch{Gt(u)}},250),S=Ks(()=>{!t.hidden&&sp&&o.length&&e==="forward"&&i==="present"&&p(sp)},120);et("q",S),et("panel",S),et("q",x),et("units",x),et("panel",_),et("plan",_),et(["q","units"],g)}};function Mo(n){let t=M("p",{class:"verdict",role:"status","data-testid":n,hidden:!0});return t.say=(e,i="wrong")=>{t.hidden=!e,t.dataset.tone=i,bt(t,e)},t}function So({text:n,working:t,testid:e,verdict:i,root:s,open:r=()=>!0,ask:o}){let a=M("button",{type:"button",class:"primary",text:n,"data-testid":e});return a.ask=async(...c)=>{let l=n_(s);if(l){i.say(l);return}a.disabled=!0,bt(a,t);try{await o(...c)}catch(u){i.say(u.message)}finally{bt(a,n),a.show()}},a.show=()=>{a.disabled=!r()},a.addEventListener("click",()=>a.ask()),a}var mD=()=>b.frames.at(-1).slice();function rp(n,t){let e=b.path,i=n==="path"?"":`${n}-`,s=(a,c,l,u)=>{ut("did",{label:l,key:u}),e[a]=c,t(),ut("path",n)},r=["from","to"].map(a=>{let c=Hs(a==="from"?"From":"To",`${n}-${a}`,()=>e[a],u=>s(a,u,`set \u201C${a}\u201D of the path`,`path-${a}`)),l=Ut("Take the present pose",{class:"quiet","data-testid":`${i}take-${a}`},()=>{s(a,mD(),`take \u201C${a}\u201D of the path`),c.show()});return{el:M("div",{class:"end"},l,c.el),show:c.show}}),o=()=>r.forEach(a=>a.show());return et("path",a=>a!==n&&o()),et("path-loaded",o),et("notation",o),{el:M("div",{},...r.map(a=>a.el)),show:o,showEnd:a=>r[a].show()}}var Ew=()=>b.frames[b.frames.length-1].slice(),Tw={id:"path",title:"Path",wide:!0,build(n,t){let e=b.path,i=rp("path",()=>h()),s=M("span",{class:"hint"}),r=Mn({label:"Number of points N",testid:"path-n",check:m=>Number.isInteger(m)&&m>=2&&m<=2e3?null:"a whole number from 2 to 2000",input:m=>{ut("did",{label:"set the points of the path",key:"path-n"}),e.n=m}}),o=Mn({label:"Seconds for the whole line",testid:"path-seconds",check:m=>m>0&&m<=3600?null:"more than 0, at most 3600",input:m=>{ut("did",{label:"set the seconds of the path",key:"path-seconds"}),e.seconds=m}}),a=Ut("Keep the orientation of \u201CFrom\u201D",{class:"quiet"},()=>{if(e.from&&e.to){let m=te(e.to);ut("did",{label:"keep the orientation of the path"}),e.to=e.from.slice(),[3,7,11].forEach((g,x)=>{e.to[g]=m[x]}),i.show(),ut("path","path"),h()}}),c=Mo("path-verdict"),l=So({text:"Plan the line",working:"Planning \u2026",testid:"plan",verdict:c,root:n,ask:m=>d(m??b.q)}),u=M("div",{class:"branches","data-testid":"branches"});n.append(i.el,M("div",{class:"line"},a,s),M("div",{class:"line"},M("label",{class:"field"},M("span",{class:"field-name",text:"Points N"}),r),M("label",{class:"field"},M("span",{class:"field-name",text:"Seconds"}),o),l,M("span",{class:"hint",text:"starts from the solution nearest to the present posture"})),c,u);let h=()=>{if(!e.from||!e.to){bt(s,"");return}let m=Xx(e.from,e.to);bt(s,`${ce(Ui(Ni(te(e.to),te(e.from))),"length")} long${m>1e-6?`, turning ${ce(m,"angle")}`:", orientation kept"}`),Xo(Array.from({length:33},(g,x)=>te(sf(e.from,e.to,x/32))))};async function d(m){let g={T0:e.from,T1:e.to,n:e.n,start:m},x=await Oe("follow",g);b.track=x,f(x),!x.complete&&(c.say(`${x.explain}
Looking for what would let it pass \u2026`,"wrong"),Oe("cures",g).then(S=>S.explain??x.explain).catch(()=>x.explain).then(S=>b.track===x&&c.say(S,"wrong")))}function f(m){if(c.say(m.explain,m.complete?"good":"wrong"),Gt(u,m.branches.length?M("h3",{text:"Branches that start at the first pose"}):null,m.branches.map((v,A)=>M("button",{type:"button",class:`branch ${A===m.chosen?"chosen":""}`,"aria-pressed":String(A===m.chosen),"data-testid":`branch-${A+1}`,disabled:!v.q,title:v.cause||"reaches the end",on:{click:async()=>{await Pi(v.q,.4,`take branch ${A+1}`),l.ask(v.q)}}},M("span",{class:"branch-name",text:`${A+1}  ${v.label}`}),p(v.s),M("span",{class:"branch-end",text:v.complete?"to the end":v.q?`${v.points} of ${e.n}`:"starts outside the limits"})))),Xo(m.path.map(te)),!m.q.length){Di(null);return}let g=m.path.length,x=m.q.map((v,A)=>A+1),S=m.q.map((v,A)=>g>1?e.seconds*A/(g-1):0);Di(ur({table:b.table,q:m.q,xs:x,xName:"point",xEnd:g,seconds:S,title:`${b.table.name}: straight line, ${m.q.length} of ${g} points`,events:m.events.map(v=>({...v,x:1+v.s*(g-1),short:v.cause}))}))}function p(m){let g=M("span",{class:"bar-fill"});return g.style.setProperty("width",`${100*m}%`),M("span",{class:"bar"},g)}let _=()=>{i.show(),r.put(e.n),o.put(e.seconds),h()};et("panel",m=>{m==="path"&&(e.from??=Ew(),e.to??=Ew(),_())}),et("path-loaded",_),et("units",h),et("table",m=>{["postures","name","gripper"].includes(m)||(c.say(""),Gt(u),Xo([]),t.hidden||_())})}};var Aw=Math.PI/180,gD=()=>({turn_speed:180*Aw,turn_acceleration:600*Aw,turn_jerk:null,slide_speed:.5,slide_acceleration:2,slide_jerk:null,tool_speed:.5});var xD=n=>b.program.slice(0,Math.max(n,0)).findLast(t=>t.kind==="frame")?.T??Zi(),Su=n=>Hn(xa(xD(n)),b.frames.at(-1));function op(n,t){let e=(s,r)=>{for(;s>=1&&s<=t.length&&t[s-1]<0;)s+=r;return s>=1&&s<=t.length?t[s-1]+1:null},i=[];return n.forEach((s,r)=>{if(t[r]<0)return;if(s.kind!=="call"){i[t[r]]=s;return}let o=[e(s.first,1),e(s.last,-1)].filter(l=>l!==null),a=Math.min(...o),c=Math.min(Math.max(...o),t[r]);o.length===2&&a<=c&&(i[t[r]]={...s,first:a,last:c})}),i.filter(Boolean)}function ea(n,t,{key:e,open:i}={}){ut("did",{label:t,key:e,open:i}),!b.program.length&&n.length&&(b.start??=b.q),b.program=n,ut("program")}var na=(n,t,e,i)=>ea(b.program.map((s,r)=>r===n?{...s,...t}:s),e,i);function Rw(n,t){ut("did",{label:t,key:"limits"}),b.limits={...ap(),...n},ut("program","limits")}var ap=()=>({...gD(),...b.limits});function Cw(n,t="set the start of the program"){ut("did",{label:t}),b.start=n,ut("program")}var lp=()=>b.start?.length===b.table.joints.length?b.start:b.q;function wo(){let n=ap(),t=b.table.joints,e=i=>t.every(s=>n[`${s.type==="R"?"turn":"slide"}_${i}`]===null)?null:t.map(s=>n[`${s.type==="R"?"turn":"slide"}_${i}`]??1e6);return{start:lp(),limits:{speed:e("speed"),acceleration:e("acceleration"),jerk:e("jerk"),tool_speed:n.tool_speed},steps:b.program.map(({name:i,...s})=>s)}}var _D=()=>({turn:null,cone:0,axis:"z",cost:"motion",singularity:0,clearance:0,start:null,end:null}),Eo=()=>b.routing??_D();function Il(n,t,e=t){ut("did",{label:t,key:e}),b.routing={...Eo(),...n},ut("routing")}var nx=()=>{let n=Eo();return{turn:n.turn??"free",cone:n.cone,axis:n.axis}};function cp(){let n=Eo(),t=b.path,e=b.world.some(i=>i.role!=="object"&&i.kind!=="frame");return{T0:t.from,T1:t.to,n:t.n,free:nx(),cost:n.cost,singularity:n.singularity,start:n.start?.q??null,end:n.end?.q??null,world:b.world,clearance:e?n.clearance:0}}function ix(n,t){let e=Uint8Array.from(atob(n.open[t]),i=>i.charCodeAt(0));return(i,s)=>{let r=i*n.turn.length+s;return e[r>>3]>>7-(r&7)&1}}var Ll=n=>{let t=n.turn[1]-n.turn[0];return Math.abs(t*n.turn.length-2*Math.PI)<1e-6};function Pw(n,t,e){let i=n.turn[1]-n.turn[0],s=n.turn.length,r=Math.round((e-n.turn[0])/i);if(Ll(n)&&(r=(r%s+s)%s),r<0||r>=s)return[];let o=Math.round(t*(n.s.length-1));return n.branches.filter((a,c)=>ix(n,c)(o,r))}var ia=Math.PI/180,Iw=3.4,yD=2.1,Lw=.5,vD=.9;function Dw({drag:n,drop:t,scrub:e}){let i=M("canvas",{"aria-hidden":"true"}),s=M("div",{class:"route-now",hidden:!0}),r=M("div",{class:"route-word",hidden:!0,"data-testid":"route-word"}),o=["start","end"].map(D=>M("div",{class:`route-end ${D}`,role:"slider",tabindex:"0","aria-orientation":"vertical","aria-label":D==="start"?"Turn of the tool where the route begins":"Turn of the tool where it ends","data-testid":`route-${D}`,hidden:!0})),a=M("div",{class:"route-map","data-testid":"route-map"},i,s,...o,r),c=null,l=null,u=null,h=null,d={start:!1,end:!1},f=[],p=()=>parseFloat(getComputedStyle(document.documentElement).fontSize);function _(){let D=p(),B=a.clientWidth,Q=a.clientHeight,Y={l:Iw*D,t:Lw*D,w:B-(Iw+vD)*D,h:Q-(Lw+yD)*D},Z=-Math.PI,nt=Math.PI;if(c.map&&!Ll(c.map))Z=c.map.turn[0],nt=c.map.turn.at(-1);else if(c.turn.length){let dt=90*ia;Z=Math.min(Z,dt*Math.floor(Math.min(...c.turn)/dt)),nt=Math.max(nt,dt*Math.ceil(Math.max(...c.turn)/dt))}u={...Y,lo:Z,hi:nt,W:B,H:Q}}let m=D=>u.l+D*u.w,g=D=>u.t+(1-(D-u.lo)/(u.hi-u.lo))*u.h,x=D=>u.lo+(1-(D-u.t)/u.h)*(u.hi-u.lo),S=D=>Ft.curves[Math.max(c.branches.indexOf(D),0)%Ft.curves.length];function v(){f=(c.map?.branches??[]).map((D,B)=>{let Q=ix(c.map,B),Y=c.map.s.length,Z=c.map.turn.length,nt=M("canvas",{width:Y,height:Z}),dt=nt.getContext("2d"),ft=dt.createImageData(Y,Z),st=parseInt(S(D).slice(1),16);for(let yt=0;yt<Y;yt++)for(let xt=0;xt<Z;xt++){if(!Q(yt,xt))continue;let Tt=4*((Z-1-xt)*Y+yt);ft.data.set([st>>16,st>>8&255,st&255,255],Tt)}return dt.putImageData(ft,0,0),{name:D,c:nt}})}function A(){if(!c||!a.clientWidth)return;_();let D=Math.min(devicePixelRatio,2),B=i.getContext("2d");i.width=u.W*D,i.height=u.H*D,B.scale(D,D);let Q=.76*p();B.font=`${Q}px "Inter Variable", system-ui, sans-serif`,B.fillStyle=Ft.ground,B.fillRect(u.l,u.t,u.w,u.h),B.save(),B.beginPath(),B.rect(u.l,u.t,u.w,u.h),B.clip(),w(B),y(B),E(B),B.restore(),U(B,Q),N()}function w(D){let B=c.map;if(!B)return;let Q=B.turn[1]-B.turn[0],Y=Ll(B),Z=B.turn[0]-Q/2,nt=B.turn.at(-1)+Q/2,dt=Y?Math.floor((u.lo-Z)/(2*Math.PI)):0,ft=Y?Math.ceil((u.hi-nt)/(2*Math.PI)):0;for(let{name:st,c:yt}of f)if(!(l&&l!==st)){D.globalAlpha=(l?.4:.3)*(Ft.dark?.8:1);for(let xt=dt;xt<=ft;xt++){let Tt=g(nt+2*Math.PI*xt),At=g(Z+2*Math.PI*xt);D.drawImage(yt,u.l,Tt,u.w,At-Tt)}}D.globalAlpha=1}function y(D){if(!c.blocked)return;let[B,Q]=c.blocked.s,Y=m(B),Z=Math.max(m(Q)-Y,3);D.fillStyle=Ft.wrong,D.globalAlpha=.75,D.fillRect(Math.min(Y,u.l+u.w-Z),u.t,Z,u.h),D.globalAlpha=1}function E(D){if(!c.q.length)return;let B=[[0]];c.labels.forEach((Q,Y)=>{Y&&Q!==c.labels[Y-1]&&B.push([Y-1]),B.at(-1).push(Y)});for(let[Q,Y]of[[.38,!0],[.18,!1]])for(let Z of B){D.beginPath();for(let nt of Z)D.lineTo(m(c.s[nt]),g(c.turn[nt]));D.lineWidth=Q*p(),D.lineJoin=D.lineCap="round",D.strokeStyle=Y?Ft.panel:Ft.curves[c.labels[Z.at(-1)]%Ft.curves.length],D.stroke()}}function U(D,B){D.strokeStyle=Ft.line,D.strokeRect(u.l,u.t,u.w,u.h),D.fillStyle=Ft.muted,D.textBaseline="middle",D.textAlign="right";let Q=(u.hi-u.lo)/ia,Y=[5,10,15,30,45,90,180].find(nt=>Q/nt<=6)??180;for(let nt=Math.ceil(u.lo/ia/Y-1e-9)*Y;nt<=u.hi/ia+1e-6;nt+=Y){let dt=g(nt*ia);D.fillText(mn(nt*ia,"angle",mt.angle==="deg"?0:2),u.l-.45*B,dt),D.globalAlpha=.5,D.beginPath(),D.moveTo(u.l,dt),D.lineTo(u.l+u.w,dt),D.lineWidth=1,D.stroke(),D.globalAlpha=1}D.textBaseline="top",D.textAlign="center";let Z=u.t+u.h+.45*B;for(let nt of[0,.25,.5,.75,1])D.fillText(String(nt),m(nt),Z);D.fillText("path, from 0 to 1",m(.5),Z+1.15*B),D.save(),D.translate(.5*B,u.t+u.h/2),D.rotate(-Math.PI/2),D.textBaseline="middle",D.fillText(`turn of the tool, ${mt.symbol("angle")}`,0,0),D.restore()}let L=D=>h?.which===D?h.turn:D==="start"?c.turn[0]:c.turn.at(-1);function N(){o.forEach((D,B)=>{let Q=B?"end":"start",Y=!!(c?.turn.length&&c.map);if(D.hidden=!Y,!Y)return;let Z=L(Q);D.style.setProperty("left",`${m(B)}px`),D.style.setProperty("top",`${g(Z)}px`),D.classList.toggle("pinned",d[Q]),D.setAttribute("aria-valuemin",mn(u.lo,"angle",0).replace("\u2212","-")),D.setAttribute("aria-valuemax",mn(u.hi,"angle",0).replace("\u2212","-")),D.setAttribute("aria-valuenow",mn(Z,"angle").replace("\u2212","-")),D.setAttribute("aria-valuetext",`${ce(Z,"angle")}${d[Q]?", held":""}`)})}let H=D=>Math.min(Math.max(D,u.lo),u.hi);function $(D,B){h={which:D,turn:H(B)},N();let Q=Pw(c.map,D==="start"?0:1,h.turn);r.hidden=!1,bt(r,`${ce(h.turn,"angle",1)}: ${Q.length?Q.join("; "):"closed on every branch"}`),r.dataset.tone=Q.length?"":"wrong",r.style.setProperty("top",`${Math.min(Math.max(g(h.turn),u.t+12),u.t+u.h-12)}px`),r.classList.toggle("right",D==="end"),n(D,h.turn)}function P(){if(!h)return;let{which:D,turn:B}=h;r.hidden=!0,t(D,B)}o.forEach((D,B)=>{let Q=B?"end":"start";D.addEventListener("pointerdown",Y=>{Y.preventDefault(),D.focus(),D.setPointerCapture(Y.pointerId);let Z=L(Q)-x(Y.clientY-a.getBoundingClientRect().top),nt=ft=>$(Q,x(ft.clientY-a.getBoundingClientRect().top)+Z);D.addEventListener("pointermove",nt);let dt=()=>{D.removeEventListener("pointermove",nt),P()};D.addEventListener("pointerup",dt,{once:!0}),D.addEventListener("pointercancel",dt,{once:!0})}),D.addEventListener("keydown",Y=>{let Z={ArrowUp:1,ArrowRight:1,ArrowDown:-1,ArrowLeft:-1,PageUp:10,PageDown:-10}[Y.key];if(Z)$(Q,L(Q)+Z*ia*(Y.shiftKey?.1:1));else if(Y.key==="Enter")P();else if(Y.key==="Escape"&&h)z(),n(Q,null);else return;Y.preventDefault(),Y.stopPropagation()}),D.addEventListener("blur",()=>h?.which===Q&&P())}),i.addEventListener("pointerdown",D=>{if(!c?.q.length)return;let B=Y=>e(Math.min(Math.max((Y.clientX-a.getBoundingClientRect().left-u.l)/u.w,0),1));i.setPointerCapture(D.pointerId),B(D),i.addEventListener("pointermove",B);let Q=()=>i.removeEventListener("pointermove",B);i.addEventListener("pointerup",Q,{once:!0}),i.addEventListener("pointercancel",Q,{once:!0})});function z(){h=null,r.hidden=!0,c&&N()}return new ResizeObserver(Js(A)).observe(a),{el:a,paint(){c&&v(),A()},cancel:z,show(D,B=null,Q={start:!1,end:!1}){c=D,d=Q,h=null,r.hidden=!0,a.hidden=!D,D&&(l=B,v(),A())},only(D){l=D,A()},at(D){s.hidden=D===null||!u||!c?.q.length,s.hidden||(s.style.setProperty("left",`${m(D)}px`),s.style.setProperty("top",`${u.t}px`),s.style.setProperty("height",`${u.h}px`))},place(D,B=null){let Q=a.getBoundingClientRect();return[Q.x+m(D==="end"?1:0),Q.y+g(B??L(D))]}}}var Nw=Math.PI/180;function Uw(){let n=(p,_,m)=>Il({...p,start:null,end:null},_,m),t=(p,_,m)=>{let g=M("span",{class:"field-name"}),x=M("label",{class:"field"},g,m);return x.label=()=>{g.textContent=_==="plain"?p:`${p}, ${mt.symbol(_)}`},x},e=(p,_,m,g,x)=>{let S=Mn({label:p,kind:_,testid:m,check:g,input:x});return{f:S,el:t(p,_,S)}},i=Be("How far the tool may turn",[["free","All the way round"],["within","Within"]],"free",p=>{n({turn:p==="free"?null:[-45*Nw,45*Nw]},"free the turn of the route"),f()},"route-turn"),s=[0,1].map(p=>e(p?"to":"from","angle",`route-turn-${p}`,_=>Math.abs(_)<=4*Math.PI?null:"at most two turns",_=>{let m=Eo().turn?.slice()??[0,0];m[p]=_,n({turn:m},"bound the turn of the route",`route-turn-${p}`)})),r=Be("About which axis of the tool",["x","y","z"].map(p=>[p,p]),"z",p=>n({axis:p},"set the axis of the route"),"route-axis"),o=e("Axis may tilt by","angle","route-cone",p=>p>=0&&p<Math.PI/2?null:"from 0 to less than 90 degrees",p=>n({cone:p},"set the cone of the route","route-cone")),a=hn("What is cheapest",[["motion","least motion of the joints"],["time","least time"]],"motion",p=>n({cost:p},"set the cost of the route"),{"data-testid":"route-cost"}),c=e("Keep the singular values\u2019 ratio above","plain","route-singularity",p=>p>=0&&p<1?null:"from 0 to less than 1",p=>n({singularity:p},"keep the route from singular postures","route-singularity")),l=e("Keep from obstacles","length","route-clearance",p=>p>=0?null:"0 or more",p=>n({clearance:p},"keep the route from obstacles","route-clearance")),u=M("details",{class:"fold"},M("summary",{text:"More that is free, and what must be kept"}),M("div",{class:"line"},o.el),M("div",{class:"line"},M("label",{class:"field"},M("span",{class:"field-name",text:"Cheapest"}),a)),M("div",{class:"line"},c.el),M("div",{class:"line"},l.el)),h=M("div",{},M("div",{class:"line"},M("span",{class:"field-name",text:"Turn"}),i,...s.map(p=>p.el),M("span",{class:"field-name",text:"about the tool\u2019s"}),r),u),d=[...s,o,c,l];function f(){let p=Eo();i.mark(p.turn?"within":"free"),s.forEach((_,m)=>{_.el.hidden=!p.turn,_.f.put(p.turn?.[m]??0)}),r.mark(p.axis),o.f.put(p.cone),a.value=p.cost,c.f.put(p.singularity),l.f.put(p.clearance),l.el.hidden=!b.world.some(_=>_.role!=="object"&&_.kind!=="frame"),d.forEach(_=>_.el.label())}return et(["units","world"],f),et("routing",p=>["undo","loaded"].includes(p)&&f()),f(),{el:h,show:f}}var Ow=n=>({id:"route",title:"Route",wide:!0,build(t){let e=b.path,i=null,s=null,r=null,o=rp("route",()=>x()),a=Uw(),c=(P,z,D,B={})=>Ut(P,{"data-testid":z,...B},D),l=c("Let both ends free","free-ends",()=>{Il({start:null,end:null},"let the ends of the route free"),f.ask()}),u=c("Send to the program","route-to-program",N,{hidden:!0}),h=c("","route-others",L,{hidden:!0}),d=Mo("route-verdict"),f=So({text:"Find the route",working:"Looking \u2026",testid:"find-route",verdict:d,root:t,async ask(){try{let P=await Oe("route",cp());P.stopped||S(P)}catch(P){throw m.cancel(),P}}}),p=M("div",{class:"chips",role:"group","aria-label":"Branches on the map"}),_=M("div",{class:"branches","data-testid":"route-list"}),m=Dw({drag:(P,z)=>z===null?ps(null):E(P,z),drop:(P,z)=>U(P,z),scrub:P=>r&&b.motion===r&&Gr(A(P))}),g=M("details",{class:"fold",open:!0},M("summary",{text:"The line"}),o.el);m.el.hidden=!0,l.hidden=!0,t.append(M("p",{class:"hint",text:"The line of Path, with the tool free to turn about its own axis on the way. The map shows every turn at every place of the line and which branch is open there; drag the ends of the curve."}),g,a.el,M("div",{class:"line"},f,l,u),m.el,p,d,M("div",{class:"line"},h),_);let x=()=>{e.from&&e.to&&!i&&Xo(Array.from({length:33},(P,z)=>te(sf(e.from,e.to,z/32))))};function S(P){let z=Eo();if(i=b.route={...P,turn:v(P,z),asked:[e.from,e.to]},s=P.found?P.branches[P.labels[0]]:null,P.found&&(g.open=!1),d.say(P.text,P.found?"good":P.verdict==="IMPOSSIBLE"?"wrong":"note"),m.show(i,s,{start:!!z.start,end:!!z.end}),ps(null),l.hidden=!(z.start||z.end),u.hidden=!P.found,h.hidden=!1,bt(h,P.found?"Routes that begin with other postures":"What would let it through?"),Gt(_),w(),Xo(P.points),!P.found){r=null,Di(null);return}let D=P.q.length;r=ur({table:b.table,q:P.q,xs:P.q.map((B,Q)=>Q+1),xName:"point",xEnd:D,seconds:P.s.map(B=>e.seconds*B),title:`${b.table.name}: route, ${D} points`}),Di(r)}function v(P,z){if(!P.found||!P.map||!Ll(P.map))return P.turn;let D=z.start?z.start.turn-P.turn[0]:z.end?z.end.turn-P.turn.at(-1):0;return P.turn.map(B=>B+2*Math.PI*Math.round(D/(2*Math.PI)))}let A=P=>i.s.reduce((z,D,B)=>Math.abs(D-P)<Math.abs(i.s[z]-P)?B:z,0);function w(){Gt(p,i.branches.map((P,z)=>{let D=M("span",{class:"swatch"});return D.style.setProperty("background",Ft.curves[z%Ft.curves.length]),M("button",{type:"button",class:"chip","aria-pressed":String(s===P),title:s===P?"Show all branches":"Show this branch alone","data-testid":`route-branch-${z+1}`,on:{click:()=>{s=s===P?null:P,m.only(s),w()}}},D,P)}))}let y=(P,z)=>{let D=P==="start",B=D?0:i.q.length-1;return{T:D?e.from:e.to,turn:z,free:nx(),near:i.q[B],branch:i.branches[i.labels[B]]}},E=Zs(async(P,z)=>{let D=await Oe("route_posture",y(P,z)).catch(()=>null);ps(D?.q??null)});async function U(P,z){try{let D=await Oe("route_posture",y(P,z));if(!D.q)throw new Error(`The route cannot ${P} there. ${D.why}`);Il({[P]:{turn:z,q:D.q,branch:D.label}},`turn the ${P} of the route to ${ce(z,"angle",1)}`),await f.ask()}catch(D){ps(null),m.cancel(),we(D.message,"wrong")}}async function L(){h.disabled=!0,bt(h,"Looking \u2026");try{let P=await Oe("route_others",cp());if(P.stopped)return;let z=D=>`cost ${Number(D.toPrecision(3))}`;Gt(_,P.relaxations.map(D=>M("p",{class:"verdict","data-tone":"note",text:D})),P.alternatives.map((D,B)=>M("button",{type:"button",class:"branch","data-testid":`route-other-${B+1}`,on:{click:async()=>{Il({start:{turn:D.turn,q:D.q,branch:D.branch},end:null},`begin the route ${D.branch}`),await f.ask()}}},M("span",{class:"branch-name",text:D.branch}),M("span",{class:"hint",text:`begins turned ${ce(D.turn,"angle",1)}`}),M("span",{class:"branch-end",text:z(D.cost)}))),P.relaxations.length+P.alternatives.length?null:M("p",{class:"hint",text:i?.found?"There is no other.":"No single change that was tried lets a route through."})),h.hidden=!0}catch(P){d.say(P.message)}finally{h.disabled=!1,i&&bt(h,i.found?"Routes that begin with other postures":"What would let it through?")}}async function N(){u.disabled=!0;try{let P=await Oe("route_program",cp());if(P.stopped)return;let z=!b.program.length,D=z?P.steps.slice(1):P.steps;z&&(b.start=P.steps[0].q),ea([...b.program,...D],"send the route to the program");let B=`${ce(P.metres,"length",3)} and ${ce(P.radians,"angle",3)}`;we(`Sent as a spline through ${P.poses} poses; it strays by at most ${B}.`),n()?.("program")}catch(P){d.say(P.message)}finally{u.disabled=!1}}let H=()=>{b.routing&&(b.routing={...b.routing,start:null,end:null})};function $(){i=b.route=null,d.say(""),m.show(null),u.hidden=h.hidden=l.hidden=!0,Gt(p),Gt(_),ps(null)}et("panel",P=>{if(P!=="route")return;let z=()=>b.frames.at(-1).slice();e.from??=z(),e.to??=z(),o.show(),x(),i&&m.paint()}),et("played",()=>{!r||b.motion!==r?m.at(null):m.at(i.s[IS()]??null)}),et("motion",()=>b.motion!==r&&m.at(null)),et("theme",()=>{m.paint(),i&&w()}),et("units",()=>m.paint()),et("routing",P=>{P==="undo"&&i&&f.ask()}),et(["path","path-loaded"],()=>{!i||i.asked[0]===e.from&&i.asked[1]===e.to||(H(),$())}),et("table",P=>{["postures","name","gripper"].includes(P)||(P!=="undo"&&H(),$())}),m.el.addEventListener("where",P=>Object.assign(P.detail,{at:m.place(P.detail.which,P.detail.turn)}))}});function Fw(n){let t=u=>`edit step ${u+1}`,e=(u,h,d)=>na(u,h,t(u),{key:`step-${u}-${d}`});function i(u,h,d,f){let p=Mn({label:`Step ${u+1}, ${d}`,testid:`step-${u+1}-${h}`,...f,input:_=>{n(()=>e(u,{[h]:_},h))}});return p.put(b.program[u][h]??null),M("label",{class:"field"},M("span",{class:"field-name",text:f.unit?`${d}, ${f.unit}`:d}),p)}let s=(u,h)=>{let d=b.program[u];return d.kind==="spline"?{T:h,through:[...d.through.slice(0,-1),h]}:{T:h}},r=(u,h,d)=>Number.isInteger(u)&&u>=h&&u<=d,o=u=>(h,d)=>Hs(d,`step-${u+1}-${h}`,()=>b.program[u]?.[h],f=>{let p=b.program[u].kind==="frame"?{}:{q:null};n(()=>e(u,h==="T"?{...s(u,f),...p}:{[h]:f},h))}).el;function a(u,h){let d=Be("A circle by",[["via","a pose on it"],["centre","its centre"]],u.centre?"centre":"via",_=>na(h,_==="centre"?{centre:te(u.via??u.T),long_way:!1}:{centre:null,via:u.via??u.T},t(h)),`step-${h+1}-by`);if(!u.centre)return M("div",{},M("div",{class:"line"},d),o(h)("via","Over"));let f=["X","Y","Z"].map((_,m)=>{let g=Mn({label:`Step ${h+1}, centre ${_}`,kind:"length",testid:`step-${h+1}-centre-${m}`,input:x=>{let S=b.program[h].centre.slice();S[m]=x,n(()=>e(h,{centre:S},"centre"))}});return g.put(u.centre[m]),M("label",{class:"field"},M("span",{class:"field-name",text:_}),g)}),p=M("input",{type:"checkbox",checked:!!u.long_way,"data-testid":`step-${h+1}-far`,on:{change:()=>e(h,{long_way:p.checked},"far")}});return M("div",{},M("div",{class:"line"},d),M("div",{class:"line"},...f,M("span",{class:"unit",text:mt.length})),M("label",{class:"check"},p,"the longer way round"))}function c(u,h){let d=f=>na(h,{through:f,T:f.at(-1)},t(h));return M("div",{class:"line"},M("span",{class:"field-name",text:`Goes through ${u.through.length} poses, the last one its target`}),Ut("Add the present pose",{class:"quiet","data-testid":`step-${h+1}-through`},()=>d([...u.through,Su(h)])),Ut("Take the last one out",{class:"quiet",disabled:u.through.length<2},()=>d(u.through.slice(0,-1))))}function l(u,h){return u.kind==="wait"?M("div",{class:"line step-editor"},i(h,"seconds","seconds",{check:d=>d>=0?null:"0 or more"})):u.kind==="gripper"?M("div",{class:"line step-editor"},i(h,"value","value",{check:d=>d>=0&&d<=1?null:"from 0, open, to 1, closed"})):u.kind==="call"?M("div",{class:"line step-editor"},i(h,"first","from step",{check:d=>r(d,1,h)?null:`from 1 to ${h}`}),i(h,"last","to step",{check:d=>r(d,u.first,h)?null:`from ${u.first} to ${h}`}),i(h,"times","times",{check:d=>r(d,1,50)?null:"a whole number from 1 to 50"})):u.kind==="frame"?M("div",{class:"step-editor"},o(h)("T","The frame, in the base"),M("div",{class:"line"},Ut("Take the present pose",{class:"quiet","data-testid":`step-${h+1}-teach`},()=>na(h,{T:b.frames.at(-1).slice()},`teach step ${h+1}`)),Ut("The base",{class:"quiet",title:"The poses that follow are meant in the base again"},()=>na(h,{T:Zi()},`end the frame at step ${h+1}`)))):u.kind==="output"?M("div",{class:"line step-editor"},i(h,"port","port",{check:d=>Number.isInteger(d)&&d>=0?null:"a whole number from 0"}),M("label",{class:"check"},M("input",{type:"checkbox",checked:u.value,on:{change:d=>e(h,{value:d.target.checked},"value")}}),"on")):M("div",{class:"step-editor"},M("div",{class:"line"},hn("Kind of move",[["joint","Joints"],["line","Line"],["circle","Circle"],["spline","Spline"]],u.kind,d=>e(h,{kind:d,q:d==="joint"?u.q??null:null,speed:null,...d==="circle"&&!u.via?{via:u.T}:{},...d==="spline"?{through:u.through??[...u.via?[u.via]:[],u.T]}:{}},"kind"),{"data-testid":`step-${h+1}-kind`}),i(h,"blend","blend",{kind:"length",unit:mt.length,check:d=>d>=0?null:"0 or more"}),u.kind==="joint"?i(h,"speed","part of the speed",{empty:null,check:d=>d===null||d>0&&d<=1?null:"above 0 to 1"}):i(h,"speed","speed",{kind:"length",unit:`${mt.length}/s`,empty:null,check:d=>d===null||d>0?null:"more than 0"})),u.kind==="circle"?a(u,h):null,u.kind==="spline"?c(u,h):null,o(h)("T",u.q?"To (a taught posture; typing makes it a pose)":"To"),M("div",{class:"line"},Ut("Take the present pose",{class:"quiet","data-testid":`step-${h+1}-teach`},()=>na(h,{...s(h,Su(h)),q:u.kind==="joint"?b.q.slice():null},`teach step ${h+1}`)),u.q?Ut("Go there",{class:"quiet"},()=>Pi(u.q.slice(),.8,`go to step ${h+1}`)):null))}return l}function Bw(){let n=M("div",{class:"line limits-of"}),t=()=>{let e=new Set(b.table.joints.map(r=>r.type)),i=(r,o,a,c,l)=>{let u=Mn({label:o,kind:a,empty:l,testid:`limit-${r}`,check:h=>h===null||h>0?null:"more than 0",input:h=>Rw({[r]:h},`limit the ${o.toLowerCase()}`)});return u.put(ap()[r]),l===null&&(u.placeholder="none"),M("label",{class:"field"},M("span",{class:"field-name",text:`${o}, ${mt.symbol(a)}${c}`}),u)},s=(r,o,a)=>[i(`${o}_speed`,`${a}speed`,r,"/s"),i(`${o}_acceleration`,`${a}acceleration`,r,"/s\xB2"),i(`${o}_jerk`,`${a}jerk`,r,"/s\xB3",null)];Gt(n,e.has("R")?s("angle","turn","Joint "):null,e.has("P")?s("length","slide","Slide "):null,i("tool_speed","Tool speed","length","/s",null))};return et(["table","units"],t),et("program",e=>e!=="limits"&&t()),t(),n}var up={joint:"Joints to",line:"Line to",circle:"Circle to",wait:"Wait",gripper:"Gripper",output:"Output",spline:"Spline to",frame:"Work frame",call:"Again"};function sx(n){return n.kind==="wait"?`${n.seconds} s`:n.kind==="gripper"?n.value===0?"open":n.value===1?"closed":`${n.value}`:n.kind==="call"?`${n.first===n.last?`step ${n.first}`:`steps ${n.first} to ${n.last}`}${n.times>1?`, ${n.times} times`:""}`:n.kind==="output"?`${n.port} ${n.value?"on":"off"}`:n.kind==="joint"&&n.q?n.q.map((t,e)=>mn(t,Ze(b.table.joints[e]??{type:"R"}),1)).join(", "):`${te(n.T).map(t=>mn(t,"length",1)).join(", ")} ${mt.length}${n.kind==="spline"?`, ${n.through.length} poses`:""}`}var kw=200,bD=[["rapid","ABB RAPID"],["urscript","URScript"],["krl","KUKA KRL"],["fanuc-ls","Fanuc LS"],["inform","Yaskawa INFORM"],["pacscript","Denso PacScript"],["ros","ROS trajectory"],["csv","CSV of the motion"]],Dl=()=>Su(hp()),hp=()=>b.program.length,zw={id:"program",title:"Program",wide:!0,build(n){let t=-1,e=null,i=-1,s=M("ol",{class:"steps","data-testid":"program","aria-label":"Steps of the program"}),r=Mo("program-verdict"),o=M("details",{class:"fold",hidden:!0},M("summary",{text:"What binds, and when"}),M("p",{class:"hint prose"})),a=(w,y,E,U)=>Ut(y,{title:E,"data-testid":`step-add-${w}`},()=>f(U())),c=So({text:"Run the program",working:"Planning \u2026",testid:"run-program",verdict:r,root:n,open:()=>b.program.length>0,ask:v}),l=M("span",{class:"hint","data-testid":"program-start"}),u="rapid";n.append(M("div",{class:"line"},a("joint","+ Joints","All joints to the present posture",()=>({kind:"joint",q:b.q.slice(),T:Dl(),blend:0})),a("line","+ Line","The tool on a straight line to the present pose",()=>({kind:"line",T:Dl(),blend:0})),a("circle","+ Circle","Over a point on the way to the present pose; both can be typed",()=>({kind:"circle",via:h(),T:Dl(),blend:0})),a("spline","+ Spline","A smooth curve through taught poses, the first of them the present one",()=>({kind:"spline",through:[Dl()],T:Dl(),blend:0})),a("gripper","+ Gripper","From 0, open, to 1, closed",()=>({kind:"gripper",value:d()>.5?0:1})),a("wait","+ Wait","The arm rests",()=>({kind:"wait",seconds:.5})),a("output","+ Output","A digital output",()=>({kind:"output",port:1,value:!0})),a("frame","+ Frame","The poses that follow are meant in this frame, at first the present pose",()=>({kind:"frame",T:b.frames.at(-1).slice()})),a("call","+ Again","Earlier steps once more, in the frame that holds here",()=>({kind:"call",first:1,last:Math.max(hp(),1),times:1}))),M("div",{class:"line spread"},l,M("span",{class:"line"},Ut("Start here",{class:"quiet","data-testid":"start-here",title:"The program begins in the present posture"},()=>Cw(b.q.slice())),Ut("Go to the start",{class:"quiet"},()=>Pi(lp().slice(),.8,"go to the start")))),s,Bw(),M("div",{class:"line"},c,M("span",{class:"line"},hn("Language of the file",bD,u,w=>{u=w},{"data-testid":"dialect"}),Ut("Save the program",{"data-testid":"save-program"},A))),r,o),hp=()=>t>=0?t+1:b.program.length;let h=()=>b.program.slice(0,hp()).findLast(w=>w.T&&w.kind!=="frame")?.T??Dl(),d=()=>b.program.findLast(w=>w.kind==="gripper")?.value??0;function f(w){if(b.program.length>=kw){we(`At most ${kw} steps.`,"wrong");return}let y=t>=0?t+1:b.program.length;t=y;let E=op(b.program,b.program.map((U,L)=>L<y?L:L+1));if(w.kind==="call"&&!y){we("There is no step before it that could be done again.","wrong"),t=-1;return}ea([...E.slice(0,y),w,...E.slice(y)],`add a step: ${up[w.kind].toLowerCase()}`)}function p(w,y){if(y<0||y>=b.program.length||w===y)return;let E=b.program.map((L,N)=>N);E.splice(y,0,...E.splice(w,1));let U=op(b.program,b.program.map((L,N)=>E.indexOf(N)));t=y,ea(U,`move step ${w+1} to ${y+1}`),s.children[y]?.querySelector(".step-name")?.focus()}function _(w){t=-1,ea(op(b.program,b.program.map((y,E)=>E===w?-1:E<w?E:E-1)),`remove step ${w+1}`)}function m(w,y){let E=y===t,U=M("button",{type:"button",class:"step-name quiet","aria-expanded":String(E),"data-testid":`step-${y+1}`,title:"Press to edit; Alt and an arrow moves it",on:{click:()=>{t=E?-1:y,S()},keydown:N=>{let H={ArrowUp:-1,ArrowDown:1}[N.key];H&&N.altKey?(N.preventDefault(),p(y,y+H)):H?(N.preventDefault(),s.children[y+H]?.querySelector(".step-name")?.focus()):N.key==="Delete"&&_(y)}}},M("b",{text:up[w.kind]}),` ${sx(w)}`,w.blend?M("span",{class:"hint",text:`, blend ${ce(w.blend,"length",0)}`}):null),L=M("li",{class:`step${e?.step===y?" failed":""}${E?" open":""}`,draggable:"true","data-testid":`step-row-${y+1}`},M("div",{class:"step-line"},M("span",{class:"grip","aria-hidden":"true",text:"\u283F"}),M("span",{class:"hint",text:String(y+1)}),U,bo({k:y,n:b.program.length,name:`step ${y+1}`,move:p,remove:_})),e?.step===y?M("p",{class:"reason",text:e.text}):null,E?x(w,y):null);return L.addEventListener("dragstart",N=>{i=y,N.dataTransfer.effectAllowed="move",N.dataTransfer.setData("text/plain",String(y))}),L.addEventListener("dragover",N=>{i<0||(N.preventDefault(),L.classList.add("target"))}),L.addEventListener("dragleave",()=>L.classList.remove("target")),L.addEventListener("drop",N=>{N.preventDefault();let H=i;i=-1,H>=0&&p(H,y)}),L}let g=!1,x=Fw(w=>{g=!0,w(),g=!1});function S(){if(g){b.program.forEach((y,E)=>{let U=s.children[E]?.querySelector(".step-name");U&&Gt(U,M("b",{text:up[y.kind]}),document.createTextNode(` ${sx(y)}`))});return}t>=b.program.length&&(t=-1),Gt(s,b.program.map(m)),b.program.length||s.append(M("li",{class:"hint empty",text:"No steps yet. Move the arm and teach it: Joints or Line takes where it stands; every pose can be typed afterwards."})),c.show();let w=lp();bt(l,b.program.length?`Starts at ${w.map((y,E)=>mn(y,Ze(b.table.joints[E]),1)).join(", ")}`:"")}async function v(){let w=await Oe("program",{...wo(),world:b.world});e=w.failed,e&&(t=e.step),r.say(e?`Step ${e.step+1} cannot be done: ${e.text}
Shown is what comes before it.`:[w.explain,w.clear?.text].filter(Boolean).join(`
`),e||w.clear?.verdict==="HIT"?"wrong":w.clear?.verdict==="UNCERTAIN"?"note":"good"),o.hidden=!w.tight.length,bt(o.lastChild,w.tight.map(E=>E.text).join(`
`)),S();let y=w.events.map(([E,U,L])=>({x:E,s:0,text:`${U} ${L} at ${E.toFixed(2)} s`,short:U==="gripper"?L>.5?"close":"open":U,stop:!1}));Di(ur({table:b.table,q:w.q,xs:w.t,xName:"time",seconds:w.t,dq:w.dq,ddq:w.ddq,events:y,title:`${b.table.name}: program, ${w.duration.toFixed(2)} s`,happens:w.events,tight:w.tight,limits:wo().limits}))}async function A(){try{let w="program",{text:y,name:E}=await Oe("program_file",{...wo(),dialect:u,name:w});ui(E,y)}catch(w){r.say(w.message)}}et(["program","units","table"],w=>{w!=="limits"&&(e=null,S())}),S()}};var sa=new Rn,ox=new ol,MD=new _e,SD=n=>new Vn({color:n,vertexColors:!0,transparent:!0,opacity:.86,fog:!1});function rx(n){let t=n.attributes.normal,e=new Float32Array(3*t.count);for(let i=0;i<t.count;i++)e.fill(.72+.2*t.getZ(i)+.08*(t.getX(i)*.6-t.getY(i)*.8),3*i,3*i+3);return n.setAttribute("color",new He(e,3)),n}var Hw=n=>n.rotateX(Math.PI/2),dp={box:n=>[rx(new Hi(...n.size)),n.T],cylinder:n=>[rx(Hw(new Ri(n.r,n.r,n.h,40))),n.T],capsule(n){let t=new G(...n.a),e=new G(...n.b).sub(t),i=e.length(),s=new _e().makeRotationFromQuaternion(new fn().setFromUnitVectors(new G(0,0,1),i?e.clone().normalize():new G(0,0,1)));return s.setPosition(t.addScaledVector(e,.5)),[rx(Hw(new Bo(n.r,i,12,28))),s.clone().transpose().elements.slice()]}};function ax(n,t,e=.86){if(!dp[n.kind])return null;let[i,s]=dp[n.kind](n),r=SD(t);r.opacity=e,r.depthWrite=e>.5;let o=new Ge(i,r);return o.matrixAutoUpdate=!1,{mesh:o,T:s}}var Vw=()=>[...b.world,...b.things??[]],Ww=n=>{let t=Nl.get(n.name)??n.T;return t?te(t):n.a.map((e,i)=>(e+n.b[i])/2)},wD=n=>Ww(n).map((t,e)=>t+(e===2?1:0));function ED(n){if(n.kind==="curve")return n.points.filter((i,s)=>s%20===0||s===n.points.length-1);if(n.kind==="capsule")return[n.a,n.b];if(!n.T)return[];let t=te(n.T),e=n.kind==="box"?n.size.map(i=>i/2):n.kind==="cylinder"?[n.r,n.r,n.h/2]:[0,0,0];return[-1,1].flatMap(i=>[0,1,2].map(s=>t.map((r,o)=>r+i*e[s]*js(n.T,s)[o])))}function $w(){tn.add(sa,ox.group),et(["world","table"],Gw),et("theme",Gw)}var Nl=new Map;function lx(n,t){if(t)Nl.set(n,t);else if(!Nl.delete(n))return;let e=sa.children.find(s=>s.userData.name===n),i=b.world.find(s=>s.name===n);e&&i&&e.matrix.set(...t??i.T),Yw()}var qw=n=>Nl.get(n)??null;function Xw(){for(let n of[...Nl.keys()])lx(n,null)}function Yw(){let n=Vw();ox.show(n.filter(t=>t.kind==="frame"),.11*Gn(b.table),n.filter(t=>dp[t.kind]).map(t=>({text:t.name,at:Ww(t),wish:wD(t)})))}function Gw(){for(let t of sa.children)t.geometry.dispose();sa.clear();let n=Vw();for(let t of n)if(t.kind==="curve"){let e=new be().setFromPoints(t.points.map(i=>new G(...i)));sa.add(new nr(e,new ts({color:Ft.trace,fog:!1})))}else if(dp[t.kind]){let{mesh:e,T:i}=ax(t,t.role==="object"?Ft.accent:Ft.ghost);e.matrix.copy(MD.set(...Nl.get(t.name)??i)),e.userData.name=t.name,sa.add(e)}Yw(),Br("world",n.flatMap(ED)),de()}var jw=()=>sa.children.length+(ox.last?.[0].length??0);var Ol=new nr(new be,new ts({depthTest:!1,fog:!1})),Fl=new Pr(new be,new ir({size:9,sizeAttenuation:!1,depthTest:!1,fog:!1}));Ol.renderOrder=Fl.renderOrder=6;Ol.frustumCulled=Fl.frustumCulled=!1;Ol.visible=Fl.visible=!1;var Ul=new Rn,wu=null,Zw="",AD=()=>b.watch||b.world.some(n=>n.role==="obstacle"&&n.kind!=="frame"),RD=Zs(async()=>{try{let n=await Oe("clearance",{q:b.q,world:b.world});b.clearance=n}catch(n){b.clearance={refused:n.message}}cx(),ut("clearance")});function Jw(){AD()&&b.table.joints.length?RD():b.clearance&&(b.clearance=null,cx(),ut("clearance"))}function cx(){let n=b.clearance,t=!!n?.points?.length;if(Ol.visible=Fl.visible=t,t){let e=n.points.map(i=>new G(...i));for(let i of[Ol,Fl])i.geometry.setFromPoints(e),i.material.color.set(n.metres>0?Ft.trace:Ft.wrong)}de()}async function ux(n){if(wu=null,n){let{bodies:t,explain:e}=await Oe("bodies",{});wu=t,Zw=e}for(let t of Ul.children)t.geometry.dispose();Ul.clear();for(let t of wu??[]){let e=ax(t,Ft.trace,.34);e&&(e.mesh.userData={on:t.on,T:e.T},Ul.add(e.mesh))}return Qw(),Zw}var Kw=()=>Ul.children.length,CD=new _e;function Qw(){for(let n of Ul.children){let{on:t,T:e}=n.userData;b.frames[t]&&n.matrix.copy(CD.set(...Hn(b.frames[t],e)))}de()}function t1(){tn.add(Ol,Fl,Ul),et(["q","world","watch"],Jw),et("plan",Jw),et("q",()=>wu&&Qw()),et("table",()=>wu&&ux(!1).then(()=>ut("bodies-gone"))),et("theme",cx)}var ID=60,LD={box:"Box",cylinder:"Cylinder",frame:"Frame"},DD={box:["x","y","z"],cylinder:["radius","height"],frame:[]};function hx(n,t,e={}){ut("did",{label:t,...e}),b.world=n,ut("world")}var fp=(n,t,e)=>hx(b.world.map((i,s)=>s===n?{...i,...t}:i),e,{key:`world-${n}-${Object.keys(t)[0]}`});function ND(n,t){if(b.world.length>=ID)return;let e=te(b.frames.at(-1)),i=.06*Gn(b.table),s=l=>Math.round(l*1e3)/1e3||.001,r=[1,0,0,s(e[0]),0,1,0,s(e[1]),0,0,1,s(n==="frame"?e[2]:i/2),0,0,0,1];r[7]+=1.5*i*b.world.length;let o=t==="object"?"object":n,a=1;for(;b.world.some(l=>l.name===`${o} ${a}`);)a+=1;let c=n==="box"?{size:[s(i),s(i),s(i)]}:n==="cylinder"?{r:s(i/2),h:s(i)}:{};hx([...b.world,{kind:n,role:t,name:`${o} ${a}`,T:r,...c}],`add ${o} ${a}`)}var e1={id:"world",title:"World",wide:!0,build(n){let t=M("p",{class:"verdict",role:"status","data-testid":"clearance",hidden:!0}),e=M("p",{class:"hint prose"}),i=M("input",{type:"checkbox","data-testid":"watch",on:{change:()=>{b.watch=i.checked,ut("watch")}}}),s=M("input",{type:"checkbox","data-testid":"show-bodies",on:{change:async()=>{try{let h=await ux(s.checked);bt(e,s.checked?h:"")}catch(h){bt(e,h.message)}}}}),r=M("div",{class:"things","data-testid":"world"}),o=(h,d,f,p)=>Ut(h,{title:p,"data-testid":`add-${f}-${d}`},()=>ND(d,f));n.append(M("div",{class:"line"},o("+ Object","box","object","A box that the gripper can take"),o("+ Box","box","obstacle","A table, a wall"),o("+ Cylinder","cylinder","obstacle","A post, a can"),o("+ Frame","frame","obstacle","A place with a name")),M("p",{class:"hint",text:"An object is taken by a gripper that closes with the tool\u2019s point at it, and goes with the tool until it opens."}),M("div",{class:"line"},M("label",{class:"check"},i,"Distance, always"),M("label",{class:"check"},s,"Bodies it is measured of")),t,e,r),et(["clearance","units"],()=>{let h=b.clearance;if(t.hidden=!h,!h)return;t.dataset.tone=h.refused||h.metres<=0?"wrong":"good";let[d,f]=h.pair??[];bt(t,h.refused??(h.metres===null?"There is nothing that could be touched.":h.metres>0?`Nearest: ${d} and ${f}, ${ce(h.metres,"length")} apart.`:`${d} and ${f} overlap by ${ce(-h.metres,"length")}.`))}),et("bodies-gone",()=>{s.checked=!1,bt(e,"")});let c=!1,l=()=>{c||(Gt(r,b.world.map(u)),b.world.length||r.append(M("p",{class:"hint",text:"Nothing stands around the arm yet."})))};function u(h,d){let f=g=>(...x)=>{c=!0,g(...x),c=!1},p=M("input",{type:"text",value:h.name,maxlength:"40","aria-label":`Name of ${h.name}`,on:{change:()=>p.value&&fp(d,{name:p.value},`name ${p.value}`)}}),_=DD[h.kind].map((g,x)=>{let S=Mn({label:`${h.name}, ${g}`,kind:"length",testid:`world-${d+1}-size-${x}`,check:v=>v>0?null:"more than 0",input:f(v=>{let A=b.world[d],w=h.kind==="box"?{size:A.size.map((y,E)=>E===x?v:y)}:{[x?"h":"r"]:v};fp(d,w,`size of ${h.name}`)})});return S.put(h.kind==="box"?h.size[x]:x?h.h:h.r),M("label",{class:"field"},M("span",{class:"field-name",text:`${g}, ${mt.length}`}),S)}),m=Hs("Place of its middle",`world-${d+1}`,()=>b.world[d]?.T,f(g=>fp(d,{T:g},`move ${h.name}`)));return M("section",{class:"thing","aria-label":h.name,"data-testid":`thing-${d+1}`},M("div",{class:"line spread"},M("span",{class:"line"},p,M("span",{class:"hint",text:LD[h.kind]}),h.kind==="frame"?null:hn(`What ${h.name} is`,[["object","object"],["obstacle","obstacle"]],h.role,g=>fp(d,{role:g},`make ${h.name} an ${g}`))),bo({k:d,name:h.name,remove:()=>hx(b.world.filter((g,x)=>x!==d),`remove ${h.name}`)})),_.length?M("div",{class:"line"},_):null,m.el)}et(["world","units"],h=>h!=="python"&&l()),l()}};var UD=40,n1={id:"sequence",title:"Sequence",wide:!0,build(n){let t={get postures(){return b.sequence.postures},set postures(d){b.sequence.postures=d},get rate(){return b.sequence.rate}},e=M("thead"),i=M("tbody"),s=Mo("sequence-verdict"),r=So({text:"Run the sequence",working:"Planning \u2026",testid:"run-sequence",verdict:s,root:n,open:()=>t.postures.length>1,ask:h}),o=Ut("Same times for all legs",{class:"quiet",title:"Copy the first leg\u2019s time and rest to the others"},()=>{let d=t.postures[1];if(d){ut("did",{label:"use the same times for all legs"});for(let f of t.postures.slice(2))f.seconds=d.seconds,f.hold=d.hold;u()}});n.append(M("p",{class:"hint",text:"Each leg is a quintic in time: all joints start and arrive together, at rest in every posture. After a leg the arm rests."}),M("div",{class:"scroll"},M("table",{class:"dh sequence","data-testid":"sequence","aria-label":"Postures of the sequence"},e,i)),M("div",{class:"line"},Ut("+ Present posture",{class:"add","data-testid":"add-posture"},()=>a(b.q.slice())),Ut("+ All named postures",{},()=>Object.entries(b.table.postures??{}).forEach(([d,f])=>a(f.slice(),d))),o),M("div",{class:"line"},r),s);function a(d,f){t.postures.length>=UD||(ut("did",{label:"add a posture to the sequence"}),t.postures.push({name:f??`P${t.postures.length}`,q:d,seconds:5,hold:0}),u(),ut("sequence"))}function c(d,f){ut("did",{label:`move ${t.postures[d].name} ${f<d?"up":"down"}`}),t.postures.splice(f,0,...t.postures.splice(d,1)),u(),ut("sequence")}function l(d){ut("did",{label:`remove ${t.postures[d].name}`}),t.postures.splice(d,1),u(),ut("sequence")}function u(){let d=b.table.joints;t.postures=t.postures.filter(f=>f.q.length===d.length),r.show(),Gt(e,M("tr",{},M("td"),d.map((f,p)=>M("th",{},M("i",{text:"q"}),M("sub",{text:String(p+1)}),M("span",{class:"unit",text:` ${mt.symbol(Ze(f))}`}))),M("th",{text:"leg, s"}),M("th",{text:"rest, s"}),M("td"))),Gt(i,t.postures.map((f,p)=>{let _=d.map((g,x)=>{let S=Mn({label:`${f.name}, q${x+1}`,kind:Ze(g),testid:`seq-${p}-q${x+1}`,input:v=>{ut("did",{label:`edit ${f.name} of the sequence`,key:`seq-${p}-${x}`}),f.q[x]=v,ut("sequence")}});return S.put(f.q[x],String(Number((f.q[x]*mt.factor(Ze(g))).toFixed(mt.digits(Ze(g))))+0)),M("td",{},S)}),m=(g,x,S)=>{if(p===0)return M("td");let v=Mn({label:`${x} ${f.name}`,testid:`seq-${p}-${g}`,check:S,input:A=>{ut("did",{label:`edit ${f.name} of the sequence`,key:`seq-${p}-${g}`}),f[g]=A,ut("sequence")}});return v.put(f[g]),M("td",{},v)};return M("tr",{"data-testid":`seq-row-${p}`},M("th",{scope:"row"},Ut(f.name,{class:"quiet",title:"Go there"},()=>Pi(f.q.slice()))),_,m("seconds","Seconds to",g=>g>0?null:"more than 0"),m("hold","Rest after",g=>g>=0?null:"0 or more"),M("td",{class:"tools"},bo({k:p,n:t.postures.length,name:f.name,move:c,remove:l})))})),t.postures.length||i.append(M("tr",{},M("td",{class:"hint",colspan:String(d.length+4),text:"No postures yet: add the present one, move the arm, add the next."})))}async function h(){let d=t.postures,f=await Oe("motion",{postures:d.map(_=>_.q),seconds:d.slice(1).map(_=>_.seconds),holds:d.slice(1).map(_=>_.hold),rate:t.rate}),p=d.map((_,m)=>({x:f.arrivals[m],s:0,text:`${_.name} at ${f.arrivals[m].toFixed(2)} s`,short:_.name,stop:!1}));s.say(`${d.length} postures in ${f.t[f.t.length-1].toFixed(2)} s. ${OD(f.q)}`,"good"),Di(ur({table:b.table,q:f.q,xs:f.t,xName:"time",seconds:f.t,dq:f.dq,events:p,title:`${b.table.name}: ${d.map(_=>_.name).join(" \u2013 ")}`}))}et(["table","units","sequence-loaded"],u),u()}};function OD(n){let t=b.table.joints.filter((e,i)=>n.some(s=>e.lower!==null&&s[i]<e.lower-1e-9||e.upper!==null&&s[i]>e.upper+1e-9));return t.length?`Outside the limits on the way: ${t.map(e=>e.name).join(", ")}.`:"Inside all limits."}var FD=.14,To=new Ge(new Ps(1,32,20),new Vn({transparent:!0,opacity:.3,depthWrite:!1,fog:!1}));To.matrixAutoUpdate=!1;To.visible=!1;To.renderOrder=4;var Eu="none";function BD(n,t,e){let i=Zx(n,t,e).slice(0,3),s=i.map(o=>i.map(a=>o.reduce((c,l,u)=>c+l*a[u],0))),r=[[1,0,0],[0,1,0],[0,0,1]];for(let o=0;o<20;o++)for(let[a,c]of[[0,1],[0,2],[1,2]]){if(Math.abs(s[a][c])<1e-300)continue;let l=(s[c][c]-s[a][a])/(2*s[a][c]),u=Math.sign(l||1)/(Math.abs(l)+Math.sqrt(l*l+1)),h=1/Math.sqrt(u*u+1),d=u*h;for(let f=0;f<3;f++)[s[f][a],s[f][c]]=[h*s[f][a]-d*s[f][c],d*s[f][a]+h*s[f][c]];for(let f=0;f<3;f++)[s[a][f],s[c][f]]=[h*s[a][f]-d*s[c][f],d*s[a][f]+h*s[c][f]];for(let f=0;f<3;f++)[r[f][a],r[f][c]]=[h*r[f][a]-d*r[f][c],d*r[f][a]+h*r[f][c]]}return[0,1,2].map(o=>({axis:r.map(a=>a[o]),length:Math.sqrt(Math.max(s[o][o],0))})).sort((o,a)=>a.length-o.length)}function i1(n){Eu=n,s1()}var pp=()=>b.ellipsoid??null;function s1(){let n=Eu!=="none"&&b.table.joints.length>0;if(To.visible=n,b.ellipsoid=null,n){let t=BD(b.table,b.q,b.frames),e=FD*Gn(b.table),i=t[0].length||1,s=.004,r=t.map(({axis:u,length:h})=>({axis:u,half:e*Math.max(Eu==="velocity"?h/i:Math.min(t[2].length/Math.max(h,1e-12),1),s)})),o=te(b.frames.at(-1)),[a,c]=r,l={...r[2]};To.matrix.set(...[0,1,2].flatMap(u=>[a.half*a.axis[u],c.half*c.axis[u],l.half*l.axis[u],o[u]]),0,0,0,1),To.material.color.set(Eu==="velocity"?Ft.trace:Ft.accent),To.material.side=pi,b.ellipsoid=t}de(),ut("ellipsoid")}function r1(){tn.add(To),et(["q","theme"],()=>Eu!=="none"&&s1())}var yp={};qx(yp,{begin:()=>px,clear:()=>WD,corners:()=>VD,cutAt:()=>GD,range:()=>fx,size:()=>kl,take:()=>mx});var mp=["#440154","#414487","#2a788e","#22a884","#7ad151","#fde725"].map(n=>new ee(n)),o1=.02;function gp(n){let t=Float32Array.from(n).sort(),e=t.length;return{lo:t[Math.floor(e*o1)]??0,hi:t[Math.max(Math.ceil(e*(1-o1))-1,0)]??1}}var zD=new ee;function xp(n,{lo:t,hi:e}){let i=Math.min(Math.max((n-t)/(e-t||1),0),1)*(mp.length-1),s=Math.min(Math.floor(i),mp.length-2);return zD.lerpColors(mp[s],mp[s+1],i-s)}var _p=n=>new Float32Array(Uint8Array.from(atob(n),t=>t.charCodeAt(0)).buffer);var dx=new ir({size:2.2,sizeAttenuation:!1,vertexColors:!0,fog:!1}),$i=new Pr(new be,dx);$i.frustumCulled=!1;$i.visible=!1;tn.add($i);var Bl=null,Tu=null,vs=0,fx={lo:0,hi:1};function px(n){Bl=new Float32Array(3*n),Tu=new Float32Array(n),vs=0,$i.geometry.dispose(),$i.geometry=new be,$i.geometry.setAttribute("position",new He(Bl,3)),$i.geometry.setAttribute("color",new He(new Float32Array(3*n),3)),$i.geometry.setDrawRange(0,0),$i.visible=!0,de()}function mx(n){let t=_p(n);for(let e=0;e<t.length&&vs<Tu.length;e+=4,vs++)Bl.set(t.subarray(e,e+3),3*vs),Tu[vs]=t[e+3];HD()}function HD(){Object.assign(fx,gp(Tu.subarray(0,vs)));let n=$i.geometry.attributes.color.array;for(let t=0;t<vs;t++)xp(Tu[t],fx).toArray(n,3*t);$i.geometry.setDrawRange(0,vs),$i.geometry.attributes.position.needsUpdate=!0,$i.geometry.attributes.color.needsUpdate=!0,de()}var kl=()=>vs;function GD(n){is.localClippingEnabled=n!==null,dx.clippingPlanes=n===null?null:[new ri(new G(0,1,0),-n)],dx.needsUpdate=!0,de()}function VD(){let n=new zi;for(let i=0;i<vs;i++)n.expandByPoint(new G(Bl[3*i],Bl[3*i+1],Bl[3*i+2]));let{min:t,max:e}=n;return vs?[0,1,2,3,4,5,6,7].map(i=>[i&1?t.x:e.x,i&2?t.y:e.y,i&4?t.z:e.z]):[]}function WD(){vs=0,$i.visible=!1,de()}var bp={};qx(bp,{begin:()=>_x,clear:()=>vx,corners:()=>XD,cutAt:()=>qD,range:()=>xx,size:()=>Ao,take:()=>yx});var $D=[[[1,0,0],[1,0,0,1,1,0,1,1,1,1,0,1],.86],[[-1,0,0],[0,1,0,0,0,0,0,0,1,0,1,1],.7],[[0,1,0],[1,1,0,0,1,0,0,1,1,1,1,1],.66],[[0,-1,0],[0,0,0,1,0,0,1,0,1,0,0,1],.92],[[0,0,1],[0,0,1,1,0,1,1,1,1,0,1,1],1],[[0,0,-1],[0,1,0,1,1,0,1,0,0,0,0,0],.5]],fr=new Ge(new be,new Vn({vertexColors:!0,fog:!1}));fr.frustumCulled=!1;fr.visible=!1;tn.add(fr);var as=null,gx=null,xx={lo:0,hi:1};function _x({low:n,shape:t,step:e}){as={low:n,shape:t,step:e,values:new Map},vp()}var a1=(n,t,e)=>(n*as.shape[1]+t)*as.shape[2]+e;function yx(n){let t=_p(n);for(let e=0;e<t.length;e+=4){let[i,s,r]=[0,1,2].map(o=>Math.floor((t[e+o]-as.low[o])/as.step));as.values.set(a1(i,s,r),t[e+3])}vp()}var Ao=()=>as?.values.size??0;function qD(n){gx=n,vp()}function XD(){if(!Ao())return[];let n=as.low.map((t,e)=>t+as.shape[e]*as.step);return[0,1,2,3,4,5,6,7].map(t=>[0,1,2].map(e=>t&1<<e?n[e]:as.low[e]))}function vx(){as=null,vp()}function vp(){if(fr.visible=Ao()>0,fr.geometry.dispose(),fr.geometry=new be,!fr.visible){de();return}let{low:n,shape:t,step:e,values:i}=as,s=[],r=[],o=[];Object.assign(xx,gp(i.values()));let a=(l,u,h)=>u>=0&&l>=0&&h>=0&&l<t[0]&&u<t[1]&&h<t[2]&&i.has(a1(l,u,h))&&c(u),c=l=>gx===null||n[1]+(l+.5)*e>=gx;for(let[l,u]of i){let h=l%t[2],d=Math.floor(l/t[2])%t[1],f=Math.floor(l/(t[1]*t[2]));if(!c(d))continue;let{r:p,g:_,b:m}=xp(u,xx);for(let[[g,x,S],v,A]of $D){if(a(f+g,d+x,h+S))continue;let w=s.length/3;for(let y=0;y<12;y+=3)s.push(n[0]+(f+v[y])*e,n[1]+(d+v[y+1])*e,n[2]+(h+v[y+2])*e),r.push(p*A,_*A,m*A);o.push(w,w+1,w+2,w,w+2,w+3)}}fr.geometry.setAttribute("position",new ve(s,3)),fr.geometry.setAttribute("color",new ve(r,3)),fr.geometry.setIndex(o),de()}var zl=n=>n.toLocaleString("en"),YD={coarse:12,middling:20,fine:32};function l1(n){let t=2*Gn(b.table)/YD[n],e=10**Math.floor(Math.log10(t));return[1,2,2.5,5,10].map(i=>i*e).findLast(i=>i<=t*1.0001)}var Mp={cloud:{scene:yp,colours:[["manipulability","manipulability"],["height","height of the tool"],["condition","inverse condition number"],["limits","distance to the limits"]],sizes:[["20000","20,000 points"],["5000","5,000 points"],["100000","100,000 points"]],begin:n=>px(Number(n)),asked:(n,t)=>({count:Number(n),colour:t,seed:1}),piece:n=>mx(n.points),progress:n=>`${zl(n.done)} of ${zl(n.of)} points`,stopped:()=>`Cancelled after ${zl(kl())} points.`,ended:(n,t)=>`${zl(n.done)} random postures inside the limits, coloured by ${t}${t.startsWith("height")?" (m)":""}.`},voxels:{scene:bp,colours:[["fraction","share of orientations"],["count","number of solutions"],["manipulability","best manipulability"],["margin","distance to the limits"]],sizes:[["middling","middling voxels"],["coarse","coarse voxels"],["fine","fine voxels"]],begin:()=>vx(),asked:(n,t)=>({step:l1(n),colour:t}),piece:n=>n.low?_x(n):yx(n.points),progress:n=>`${Math.round(100*n.done/n.of)} % solved`,stopped:()=>`Cancelled after ${zl(Ao())} voxels.`,ended:(n,t,e)=>`${zl(n.reached)} voxels of ${ce(l1(e),"length",mt.length==="mm"?0:3)} are reached inside the limits in some of ${n.orientations} orientations, ${n.volume.toPrecision(3)} m\xB3 together; coloured by ${t}. Each is solved at its centre.`}};function c1(){let n="cloud",t=!1,e={size:null,colour:null},i=Ut("",{class:"primary","data-testid":"reach-start"},()=>t?Fi("cancel",{kind:t}):m()),s=Ut("Clear",{},_),r=M("input",{type:"range",min:"-1",max:"1",step:"any",value:"0",hidden:!0,"aria-label":"Where it is cut","data-testid":"reach-cut-at",on:{input:c}}),o=!1,a=Be("Shown",[["whole","Whole"],["half","Cut open"]],"whole",S=>{o=S==="half",r.hidden=!o,c()},"reach-cut");function c(){let S=o?b.table.base[7]+Number(r.value)*Gn(b.table):null;r.style.setProperty("--at",`${50*(1+Number(r.value))}%`);for(let{scene:v}of Object.values(Mp))v.cutAt(S)}let l=M("progress",{max:"1","aria-label":"Progress","data-testid":"reach-progress",hidden:!0}),u=M("p",{class:"hint",role:"status","data-testid":"reach-note"}),h=M("span"),d=M("span"),f=M("div",{class:"legend-scale",hidden:!0},h,M("span",{class:"scale-bar"}),d),p=M("div",{class:"line"});function _(){for(let{scene:S}of Object.values(Mp))S.clear();Br("reach",[]),f.hidden=!0,bt(u,"")}async function m(){let S=Mp[n],{size:v,colour:A}=e,w=S.colours.find(([y])=>y===A)[1];_(),t=n,bt(i,"Cancel"),l.hidden=f.hidden=!1,l.value=0,S.begin(v);try{let y=await Oe(n,S.asked(v,A),E=>{S.piece(E),l.value=E.done/E.of,bt(h,ll(S.scene.range.lo)),bt(d,ll(S.scene.range.hi)),bt(u,S.progress(E))});bt(u,y.stopped?S.stopped():S.ended(y,w,v))}catch(y){bt(u,y.message)}t=!1,f.hidden=!S.scene.size(),Br("reach",S.scene.corners()),su(),g(),l.hidden=!0}let g=()=>t||bt(i,n==="cloud"?"Draw the cloud":"Draw the map");function x(){let{sizes:S,colours:v}=Mp[n];e.size=S[0][0],e.colour=v[0][0];let A=w=>y=>{e[w]=y};Gt(p,hn("How many",S,e.size,A("size"),{"data-testid":"reach-size"}),M("span",{class:"field-name",text:"coloured by"}),hn("Coloured by",v,e.colour,A("colour"),{"data-testid":"reach-colour"})),g()}return et("table",S=>{S==="postures"||S==="name"||(t&&Fi("cancel",{kind:t}),(kl()||Ao())&&_())}),x(),M("div",{},Be("Drawn as",[["cloud","Cloud"],["voxels","Map"]],n,S=>{n=S,x()},"reach-kind"),M("p",{class:"hint",text:"A cloud is of random postures. A map asks every voxel completely, which takes minutes for arms without a closed form or with joints to spare."}),p,M("div",{class:"line"},i,s,a,r),l,f,u)}var u1={id:"analysis",title:"Analysis",build(n){let t=M("dl",{class:"facts","data-testid":"analysis"}),e=[["manipulability","Manipulability","the product of the singular values of the Jacobian, lengths divided by the arm\u2019s"],["condition","Condition number","the largest singular value over the smallest; 1 is best"],["least","Smallest singular value","0 at a singularity"]],i={};for(let[l,u,h]of e)t.append(M("div",{title:h},M("dt",{text:u}),i[l]=M("dd",{"data-testid":`fact-${l}`})));let s=M("div",{class:"distances","data-testid":"limit-distances"}),r=[],o=M("p",{class:"hint","data-testid":"ellipsoid-axes"});et("ellipsoid",()=>{let l=pp();bt(o,l?`Joint rates of norm 1 move the point at most ${l.map(u=>ce(u.length,"length")).join(", ")} a second along the three axes; forces are greatest where speeds are least.`:"")}),n.append(t,M("h3",{text:"At the tool\u2019s point"}),Be("Ellipsoid at the tool",[["none","None"],["velocity","Velocities"],["force","Forces"]],"none",i1,"ellipsoid"),o,M("h3",{text:"Distance to the limits"}),s,M("h3",{text:"Where the tool can be"}),c1());let a=()=>{r=b.table.joints.map((l,u)=>{let h=M("span",{class:"bar-fill"}),d=M("span",{class:"bar-text"});return{el:M("div",{class:"distance"},M("span",{},M("i",{text:"q"}),M("sub",{text:String(u+1)})),M("span",{class:"bar"},h),d),fill:h,text:d}}),Gt(s,r.map(l=>l.el)),c()},c=Js(()=>{if(n.closest(".panel").hidden||!b.table.joints.length)return;let l=Ou(b.table,b.q,b.frames),u=l[0],h=l[l.length-1];bt(i.manipulability,ll(l.reduce((d,f)=>d*f,1))),bt(i.condition,u>1e-9?ii(h/u,1):"\u221E"),bt(i.least,ll(u)),t.dataset.tone=u<.02?"wrong":"good",r.forEach(({el:d,fill:f,text:p},_)=>{let m=b.table.joints[_],g=b.q[_];if(m.lower===null||m.upper===null){f.style.setProperty("width","100%"),bt(p,"no limit");return}let x=Math.min(g-m.lower,m.upper-g),S=Math.max(2*x/(m.upper-m.lower||1),0);f.style.setProperty("width",`${100*S}%`),d.classList.toggle("outside",x<-1e-9),bt(p,x<-1e-9?`${ce(-x,Ze(m))} beyond`:ce(x,Ze(m)))})});et("table",a),et(["q","units","panel"],c),a()}};var h1=n=>({id:"share",title:"Share",build(t,e){let i=M("input",{type:"text",readonly:!0,class:"address","aria-label":"Link to this state","data-testid":"link",on:{focus:d=>d.target.select()}}),s=M("input",{type:"file",accept:".json,application/json",class:"offscreen",tabindex:"-1","aria-label":"State file","data-testid":"state-file",on:{change:()=>h(s)}}),r=M("p",{class:"hint",role:"status","data-testid":"report-note"}),o=Ut("Write the report",{class:"primary","data-testid":"report"},u),a=M("textarea",{rows:"9",readonly:!0,class:"code",spellcheck:"false","aria-label":"The screen as a Python script","data-testid":"python"});t.append(M("p",{class:"hint",text:"Arm, posture, target, path, sequence, units and view, all in the link: whoever opens it on their own workbench sees what you see."}),M("div",{class:"line share-link"},i,Ut("Copy the link",{"data-testid":"copy-link"},async()=>jr(await Sf()))),M("h3",{text:"As a file"}),M("div",{class:"line"},Ut("Save the state",{"data-testid":"save-state"},()=>ui(`${b.table.name||"arm"}.workbench.json`,JSON.stringify(fl(),null,1),"application/json")),Ut("Open a state\u2026",{},()=>s.click()),s,Ut("Save the robot file",{"data-testid":"save-robot"},np)),M("h3",{text:"As Python"}),M("p",{class:"hint",text:"A script that makes and computes what is on the screen, in metres and radians."}),a,M("div",{class:"line"},Ut("Copy the script",{"data-testid":"copy-python"},()=>jr(a.value)),Ut("Save the script",{},()=>ui("workbench.py",a.value,"text/x-python"))),M("h3",{text:"Report"}),M("p",{class:"hint",text:"One page that stands alone: the arm, its table and equations, the present pose with all its solutions, singularities and reach."}),M("div",{class:"line"},o),r);let c=async()=>{!e.hidden&&b.table.joints.length&&(i.value=await Sf()),!e.hidden&&b.table.joints.length&&l()},l=Zs(async()=>{try{let{q:d,target:f,hasTarget:p,path:_,program:m}=b,{task:g,redundancy:x}=fe,S={q:d,target:p?f:null,path:_,task:g,redundancy:x,program:wo()};a.value=(await Oe("python",m.length?S:{...S,program:null})).text}catch(d){a.value=`# ${d.message}`}});et(["panel","table","q","units","notation"],c);async function u(){o.disabled=!0;try{let{html:d,name:f}=await Oe("report",{q:b.q},p=>bt(r,p.note));ui(f,d,"text/html"),bt(r,`Written: ${f}, ${Math.round(d.length/1024)} kB.`)}catch(d){bt(r,d.message)}finally{o.disabled=!1}}async function h(d){let f=d.files[0];if(d.value="",!!f)try{if(f.size>5e5)throw new Error("A state file has at most 500 kB.");Mf(JSON.parse(await f.text()),n()),we("Opened")}catch(p){we(p instanceof SyntaxError?`${f.name} is not a state file.`:p.message,"wrong")}}}});var jD=40,m1=!1,g1=0,bx=!1,Sp=null,d1=[],f1="null",p1=null;function x1(n){n&&(m1=!0,Sp=b.table,_1(n),(b.program.length||b.world.length)&&y1.soon())}function _1(n){bx=!0,g1=n.said,n.table&&(yn(n.table,{q:n.q,what:"new",label:"open an arm from Python"}),Sp=b.table,Rl(n.looks??null,n.table)),n.things&&ZD(n.things),n.target&&(b.hasTarget=!0,Si(n.target,"restored")),n.q&&n.q.length===b.table.joints.length&&(ut("did",{label:"move from Python",key:"python"}),Oi(n.q,"python")),bx=!1}function ZD(n){b.things=n.filter(i=>i.kind!=="motion"),ut("world","python");let t=n.findLast(i=>i.kind==="motion")??null,e=JSON.stringify(t);if(e!==p1){if(p1=e,!t){Di(null);return}Di(ur({table:b.table,q:t.q,xs:t.t,xName:"time",seconds:t.t,title:`${b.table.name}: ${t.name}`,events:t.events.map(([i,s,r])=>({x:i,s:0,text:`${s} ${r} at ${i.toFixed(2)} s`,short:s,stop:!1}))}))}}var y1=ya(jD,()=>{if(!b.table.joints.length)return;let n=b.q,t=b.hasTarget?b.target:null,e=b.program.length?wo():null,i={},s=JSON.stringify(e);b.table!==Sp&&(i.table=kp(b.table)),b.world!==d1&&(i.world=b.world),s!==f1&&(i.program=e),[Sp,d1,f1]=[b.table,b.world,s],Fi("shown",{q:n,target:t,said:g1,...i}).catch(()=>{})});function v1(){et("push",_1),et(["q","target","table","program","world"],()=>m1&&!bx&&y1.soon())}var ra=new Rn,M1=new Vn({fog:!1}),Mx=new Vn({fog:!1}),Sx=new Hi(1,1,1),wx=new Ge(Sx,M1),S1=[new Ge(Sx,Mx),new Ge(Sx,Mx)];ra.add(wx,...S1);ra.matrixAutoUpdate=!1;ra.visible=!1;var Au=null;function w1(){tn.add(ra),et("q",()=>Au!==null&&T1()),et("theme",b1),b1()}function b1(){M1.color.set(Ft.joint),Mx.color.set(Ft.accent)}function Ex(n){n===null&&Au===null||(Au=n,ra.visible=n!==null,n!==null&&T1(),de())}var E1=()=>Au;function T1(){let n=b.frames.at(-1),t=.075*Gn(b.table);wx.scale.set(.35*t,1.1*t,.25*t),wx.position.set(0,0,-.85*t),S1.forEach((e,i)=>{let s=(.08+.36*(1-Au))*t;e.scale.set(.26*t,.13*t,.95*t),e.position.set(0,(i?1:-1)*s,-.3*t)}),ra.matrix.set(...n),ra.updateMatrixWorld(!0)}var QD=.25,Tx=.5;function tN(n){let t=(n.happens??[]).filter(([,r])=>r==="gripper").map(([r,,o])=>({t:r,value:o})),e=new Map(b.world.filter(r=>r.role==="object").map(r=>[r.name,[{t:-1,T:r.T}]])),i=null,s=!1;for(let{t:r,value:o}of t){let a=iN(n,r);if(o>=Tx&&!s){let c=[...e].map(([l,u])=>({name:l,T:u.at(-1).T,d:Ui(Ni(te(u.at(-1).T),te(a)))})).filter(({name:l,d:u})=>u<eN(b.world.find(h=>h.name===l))).sort((l,u)=>l.d-u.d)[0];c&&(i=c.name,e.get(i).push({t:r,held:Hn(xa(a),c.T)}))}else o<Tx&&s&&i&&(e.get(i).push({t:r,T:Hn(a,e.get(i).at(-1).held)}),i=null);s=o>=Tx}return{grips:t,objects:e}}var eN=n=>.6*Math.max(...n.size??[2*(n.r??0),n.h??0])+.01;function nN(n,t){let e=0,i=n.length-1;for(;e<i;){let s=e+i+1>>1;n[s]<=t+1e-9?e=s:i=s-1}return e}var iN=(n,t)=>ws(n.table,n.q[nN(n.seconds,t)]).at(-1),Ro=null,sN=n=>{let t=Ro.grips.length?1-Math.round(Ro.grips[0].value):0;for(let e of Ro.grips){if(e.t>n)break;let i=Math.min((n-e.t)/QD,1);t+=i*(e.value-t)}return t};function A1(){et("motion",()=>{Xw(),Ro=b.motion?.happens?tN(b.motion):null,Ro||Ex(null)}),et("played",n=>{if(!Ro)return;let t=b.frames.at(-1);Ro.grips.length&&Ex(sN(n));for(let[e,i]of Ro.objects){let s=i.findLast(r=>r.t<=n)??i[0];lx(e,s.held?Hn(t,s.held):s.T)}})}function R1(){let n={said:()=>structuredClone(fl()),q:()=>b.q.slice(),frames:()=>structuredClone(b.frames),target:()=>b.target.slice(),table:()=>structuredClone(b.table),solutions:()=>structuredClone(b.solutions),camera:()=>il(),pictures:()=>bv(),ghosts:()=>Eb(),ghostsOutside:()=>Tb(),labels:()=>Ag(),history:()=>[yf(),vf()],beyond:()=>Mb(),things:()=>jw(),looks:()=>ZS(),program:()=>structuredClone(b.program),route:()=>structuredClone(b.route),motion:()=>structuredClone(b.motion),gripper:()=>E1(),stepFrame:()=>b.dhStep===null?null:ef().at(-1).T,clearance:()=>structuredClone(b.clearance),bodies:()=>Kw(),ellipsoid:()=>structuredClone(pp()),world:()=>structuredClone(b.world),framesDrawn:()=>Sb(),answers:()=>Zg.answers,trace:()=>Pb(),voxels:()=>Ao(),cloud:()=>kl()},t={routePlace(e,i){let s={which:e,turn:i};return document.querySelector(".route-map").dispatchEvent(new CustomEvent("where",{detail:s})),s.at},placeOf:e=>qw(e)??b.world.find(i=>i.name===e)?.T??null,go:Gr,toScreen:Vi,withPicture:e=>tl(e),handles:()=>Qv(),forward:(e,i)=>ws(e,i),convert:(e,i)=>tp(e,i),read:(e,i)=>Ef(e,i),present:(e,i,s)=>ip(e,i,s)};for(let[e,i]of Object.entries(n))Object.defineProperty(t,e,{get:i,enumerable:!0});window.workbench=Object.freeze(t)}zd();Sv(Es("#view"));et("theme",yg);yg();Ob();Bv(Es("#overlay"));_b();Zv();$w();jS();t1();r1();w1();A1();v1();r_();Db();tw(Es("#bar"));nw(Es("#overlay"));PS(Es("#dock"));iw();var wp,Ru=(n,t,...e)=>[{...t,group:n},...e];wp=ew(Es("#rail"),Es("#panels"),Es("#pinned"),[...Ru("Drive",{id:"move",title:"Move",sections:[Yb,rw]},pw),...Ru("Describe",Mw,e1),...Ru("Plan",Tw,Ow(()=>wp),zw,n1),...Ru("Study",ow,ww,u1),...Ru("Hand on",h1(()=>wp))]);NS(Es("#room"),Es("#rail"));Wb();var oN=Gb().then(n=>n&&Mf(n,wp)).catch(n=>we(`The link could not be read: ${n.message}`,"wrong"));et("online",async n=>{if(!n)return;await oN;let t=await t_();b.catalog=t.catalog,ut("catalog"),t.table&&(!b.table.joints.length||t.bench)&&(yn(t.table,{q:_a(t.table),step:!1,what:"new"}),bf()),t.looks&&Rl(t.looks,t.table),x1(t.bench),document.documentElement.dataset.ready="yes"});b.online&&ut("online",!0);document.fonts?.ready.then(()=>ut("theme"));R1();
