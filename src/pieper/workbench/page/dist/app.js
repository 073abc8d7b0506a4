import{A as zc,B as Vo,C as _n,D as i0,E as Di,F as s0,G as Hc,I as Ys,J as Gc,a as qs,b as Xs,c as jg,d as ye,e as br,f as rl,g as qi,h as ol,i as Fc,j as As,k as Oc,l as Bc,m as Qg,n as Qr,o as to,p as t0,q as $s,r as Sd,s as Mr,t as kc,u as e0,v as n0,w as gt,x as Dt,y as P,z as Xi}from"./chunk-RGT4CGZ2.js";function E(n,t={},...e){let i=document.createElement(n);for(let[s,r]of Object.entries(t))if(!(r==null||r===!1))if(s==="text")i.textContent=r;else if(s==="on")for(let[o,a]of Object.entries(r))i.addEventListener(o,a);else s==="value"?i.value=r:s==="checked"||s==="disabled"||s==="hidden"?i[s]=r:i.setAttribute(s,r===!0?"":r);return i.append(...e.flat().filter(s=>s!=null&&s!==!1)),i}var Sr=(n,t=document)=>t.querySelector(n),te=(n,...t)=>n.replaceChildren(...t.flat().filter(Boolean));function Ut(n,t){n.textContent!==t&&(n.textContent=t)}function xn(n,t,e,i,s){let r=E("div",{class:"choice",role:"group","aria-label":n,"data-testid":s}),o=a=>{for(let c of r.children)c.setAttribute("aria-pressed",String(c.dataset.value===a))};for(let[a,c]of t)r.append(E("button",{type:"button",text:c,"data-value":a,on:{click:()=>{o(a),i(a)}}}));return o(e),r.mark=o,r}function jn(n,t,e,i,s={}){let r=E("select",{"aria-label":n,...s,on:{change:()=>i(r.value)}},t.map(([o,a])=>E("option",{value:o,text:a})));return r.value=e,r}function wr(n){let t=!1;return()=>{t||(t=!0,requestAnimationFrame(()=>{t=!1,n()}))}}function Vc(n,t){let e=null,i=-1/0,s=()=>{clearTimeout(e),e=null,i=performance.now(),t()};return s.soon=()=>{let r=i+n-performance.now();r<=0?s():e??=setTimeout(s,r)},s}function Rs(n,t){let e,i=(...s)=>{clearTimeout(e),e=setTimeout(()=>n(...s),t)};return i.cancel=()=>clearTimeout(e),i}function Zs(n,t,e="text/plain"){let i=URL.createObjectURL(t instanceof Blob?t:new Blob([t],{type:e})),s=E("a",{href:i,download:n});document.body.append(s),s.click(),s.remove(),setTimeout(()=>URL.revokeObjectURL(i),1e4)}async function eo(n){try{await navigator.clipboard.writeText(n)}catch{let t=E("textarea",{class:"offscreen"});t.value=n,document.body.append(t),t.select(),document.execCommand("copy"),t.remove()}Rn("Copied")}var r0;function Rn(n,t="plain"){let e=document.getElementById("remark");e.textContent=n,e.dataset.tone=t,e.classList.add("shown"),clearTimeout(r0),r0=setTimeout(()=>e.classList.remove("shown"),t==="wrong"?8e3:2500)}function Wc(n){let t=[...n.querySelectorAll(".number.wrong")].find(e=>!e.closest("[hidden]"));return t?(t.focus(),`${t.getAttribute("aria-label")} cannot be read (${t.title}). Nothing was computed.`):null}var Wo=0,Td=-1,wd=[];function mM(n){return{...n,joints:n.joints.map(({text:t,...e})=>e)}}async function Ed(){let n=Wo;if(!P.table.joints.length){P.plan={solvable:!1,explain:"The table is empty: add a joint.",max_solutions:0},Dt("plan");return}try{let{plan:t}=await Ys("arm",{table:mM(P.table)});if(n!==Wo)return;Td=n,P.plan=t,o0()}catch(t){if(n!==Wo||t instanceof Hc)return;P.plan={solvable:!1,refused:!0,explain:t.message,max_solutions:0},o0(t)}Dt("plan")}function o0(n){let t=wd;wd=[];for(let{resolve:e,reject:i}of t)n?i(n):e()}var a0=Rs(Ed,60);function l0(){gt("table",n=>{Wo+=1,n==="postures"&&(Td=-1),n==="cell"?a0():(a0.cancel(),Ed())}),gt("online",n=>{n&&(Wo+=1,Ed())})}function gM(){return Td===Wo?Promise.resolve():new Promise((n,t)=>wd.push({resolve:n,reject:t}))}async function Yn(n,t,e){return await gM(),Ys(n,t,e)}function c0(n){if(!n)return"";let t=n.explain.split(`
`).map(s=>s.trim()),e=t.find(s=>s.startsWith("Solved by:")),i=(e??t.filter(Boolean)[0]??"").replace(/\s+/g," ");return e||i.length<200?i:`${i.slice(0,200)} \u2026`}function qc(n){if(!n?.solvable)return"";let t=n.max_solutions;return t==null?"":t===1?"One solution":`Up to ${t} solutions`}var Fr={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},Or={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},q0=0,np=1,X0=2;var Xl=1,$0=2,Sa=3,Br=0,mi=1,Ji=2,ho=0,wa=1,ip=2,sp=3,rp=4,Y0=5;var fo=100,Z0=101,J0=102,K0=103,j0=104,Q0=200,t_=201,e_=202,n_=203,op=204,ap=205,i_=206,s_=207,r_=208,o_=209,a_=210,l_=211,c_=212,u_=213,h_=214,Mu=0,Su=1,wu=2,ua=3,Eu=4,Tu=5,Au=6,Ru=7,lp=0,f_=1,d_=2,Ns=0,cp=1,up=2,hp=3,fp=4,dp=5,pp=6,mp=7;var gp=300,po=301,Ea=302,th=303,eh=304,Cu=1e3,Ps=1001,Pu=1002,qn=1003,p_=1004;var $l=1005;var fi=1006,nh=1007;var ar=1008;var Bi=1009,_p=1010,xp=1011,Ta=1012,ih=1013,us=1014,Ki=1015,hs=1016,sh=1017,rh=1018,mo=1020,yp=35902,vp=35899,bp=1021,Mp=1022,fs=1023,ir=1026,lr=1027,oh=1028,ah=1029,kr=1030,lh=1031;var ch=1033,Yl=33776,Zl=33777,Jl=33778,Kl=33779,uh=35840,hh=35841,fh=35842,dh=35843,ph=36196,mh=37492,gh=37496,_h=37488,xh=37489,jl=37490,yh=37491,vh=37808,bh=37809,Mh=37810,Sh=37811,wh=37812,Eh=37813,Th=37814,Ah=37815,Rh=37816,Ch=37817,Ph=37818,Ih=37819,Lh=37820,Dh=37821,Nh=36492,Uh=36494,Fh=36495,Oh=36283,Bh=36284,Ql=36285,kh=36286;var vl=2300,Iu=2301,vu=2302,Yd=2303,Zd=2400,Jd=2401,Kd=2402;var m_=3200;var Sp=0,g_=1,cr="",ui="srgb",bl="srgb-linear",Ml="linear",Oe="srgb";var bu=7680,wp=7681;var Ep=517;var __=519,x_=512,y_=513,v_=514,Tp=515,b_=516,M_=517,Ap=518,Rp=519,Cp=35044,zh=35048;var Pp="300 es",Yi=2e3,Sl=2001;function xM(n){for(let t=n.length-1;t>=0;--t)if(n[t]>=65535)return!0;return!1}function yM(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function wl(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function S_(){let n=wl("canvas");return n.style.display="block",n}var u0={},ha=null;function El(...n){let t="THREE."+n.shift();ha?ha("log",t,...n):console.log(t,...n)}function w_(n){let t=n[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=n[1];e&&e.isStackTrace?n[0]+=" "+e.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function jt(...n){n=w_(n);let t="THREE."+n.shift();if(ha)ha("warn",t,...n);else{let e=n[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...n)}}function ie(...n){n=w_(n);let t="THREE."+n.shift();if(ha)ha("error",t,...n);else{let e=n[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...n)}}function _l(...n){let t=n.join(" ");t in u0||(u0[t]=!0,jt(...n))}function E_(n,t,e){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(t,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:i()}}setTimeout(r,e)})}var T_={[Mu]:Mu,[wu]:Au,[Eu]:Eu,[ua]:Tu,[Su]:Su,[Au]:wu,[Ru]:Ru,[Tu]:ua},ls=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[t]===void 0&&(i[t]=[]),i[t].indexOf(e)===-1&&i[t].push(e)}hasEventListener(t,e){let i=this._listeners;return i===void 0?!1:i[t]!==void 0&&i[t].indexOf(e)!==-1}removeEventListener(t,e){let i=this._listeners;if(i===void 0)return;let s=i[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let i=e[t.type];if(i!==void 0){t.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},Qn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],h0=1234567,xl=Math.PI/180,fa=180/Math.PI;function zr(){let n=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Qn[n&255]+Qn[n>>8&255]+Qn[n>>16&255]+Qn[n>>24&255]+"-"+Qn[t&255]+Qn[t>>8&255]+"-"+Qn[t>>16&15|64]+Qn[t>>24&255]+"-"+Qn[e&63|128]+Qn[e>>8&255]+"-"+Qn[e>>16&255]+Qn[e>>24&255]+Qn[i&255]+Qn[i>>8&255]+Qn[i>>16&255]+Qn[i>>24&255]).toLowerCase()}function ve(n,t,e){return Math.max(t,Math.min(e,n))}function Ip(n,t){return(n%t+t)%t}function vM(n,t,e,i,s){return i+(n-t)*(s-i)/(e-t)}function bM(n,t,e){return n!==t?(e-n)/(t-n):0}function yl(n,t,e){return(1-e)*n+e*t}function MM(n,t,e,i){return yl(n,t,1-Math.exp(-e*i))}function SM(n,t=1){return t-Math.abs(Ip(n,t*2)-t)}function wM(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*(3-2*n))}function EM(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*n*(n*(n*6-15)+10))}function TM(n,t){return n+Math.floor(Math.random()*(t-n+1))}function AM(n,t){return n+Math.random()*(t-n)}function RM(n){return n*(.5-Math.random())}function CM(n){n!==void 0&&(h0=n);let t=h0+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function PM(n){return n*xl}function IM(n){return n*fa}function LM(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function DM(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function Lp(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function NM(n,t,e,i,s){let r=Math.cos,o=Math.sin,a=r(e/2),c=o(e/2),l=r((t+i)/2),u=o((t+i)/2),h=r((t-i)/2),f=o((t-i)/2),d=r((i-t)/2),g=o((i-t)/2);switch(s){case"XYX":n.set(a*u,c*h,c*f,a*l);break;case"YZY":n.set(c*f,a*u,c*h,a*l);break;case"ZXZ":n.set(c*h,c*f,a*u,a*l);break;case"XZX":n.set(a*u,c*g,c*d,a*l);break;case"YXY":n.set(c*d,a*u,c*g,a*l);break;case"ZYZ":n.set(c*g,c*d,a*u,a*l);break;default:jt("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Hh(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Dp(n,t){if(t.constructor===Float32Array)return n;let e=Hh(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/e,-1)}function Np(n,t){if(t.constructor===Float32Array)return n;let e=Hh(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*e)}var Hr={DEG2RAD:xl,RAD2DEG:fa,generateUUID:zr,clamp:ve,euclideanModulo:Ip,mapLinear:vM,inverseLerp:bM,lerp:yl,damp:MM,pingpong:SM,smoothstep:wM,smootherstep:EM,randInt:TM,randFloat:AM,randFloatSpread:RM,seededRandom:CM,degToRad:PM,radToDeg:IM,isPowerOfTwo:LM,ceilPowerOfTwo:DM,floorPowerOfTwo:Lp,setQuaternionFromProperEuler:NM,normalize:Np,denormalize:Dp},qt=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,i=this.y,s=t.elements;return this.x=s[0]*e+s[3]*i+s[6],this.y=s[1]*e+s[4]*i+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=ve(this.x,t.x,e.x),this.y=ve(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=ve(this.x,t,e),this.y=ve(this.y,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ve(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(ve(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y;return e*e+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let i=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*i-o*s+t.x,this.y=r*s+o*i+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},un=class{constructor(t=0,e=0,i=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=i,this._w=s}static slerpFlat(t,e,i,s,r,o,a){let c=i[s+0],l=i[s+1],u=i[s+2],h=i[s+3],f=r[o+0],d=r[o+1],g=r[o+2],_=r[o+3];if(h!==_||c!==f||l!==d||u!==g){let p=c*f+l*d+u*g+h*_;p<0&&(f=-f,d=-d,g=-g,_=-_,p=-p);let m=1-a;if(p<.9995){let x=Math.acos(p),M=Math.sin(x);m=Math.sin(m*x)/M,a=Math.sin(a*x)/M,c=c*m+f*a,l=l*m+d*a,u=u*m+g*a,h=h*m+_*a}else{c=c*m+f*a,l=l*m+d*a,u=u*m+g*a,h=h*m+_*a;let x=1/Math.sqrt(c*c+l*l+u*u+h*h);c*=x,l*=x,u*=x,h*=x}}t[e]=c,t[e+1]=l,t[e+2]=u,t[e+3]=h}static multiplyQuaternionsFlat(t,e,i,s,r,o){let a=i[s],c=i[s+1],l=i[s+2],u=i[s+3],h=r[o],f=r[o+1],d=r[o+2],g=r[o+3];return t[e]=a*g+u*h+c*d-l*f,t[e+1]=c*g+u*f+l*h-a*d,t[e+2]=l*g+u*d+a*f-c*h,t[e+3]=u*g-a*h-c*f-l*d,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,i,s){return this._x=t,this._y=e,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let i=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,c=Math.sin,l=a(i/2),u=a(s/2),h=a(r/2),f=c(i/2),d=c(s/2),g=c(r/2);switch(o){case"XYZ":this._x=f*u*h+l*d*g,this._y=l*d*h-f*u*g,this._z=l*u*g+f*d*h,this._w=l*u*h-f*d*g;break;case"YXZ":this._x=f*u*h+l*d*g,this._y=l*d*h-f*u*g,this._z=l*u*g-f*d*h,this._w=l*u*h+f*d*g;break;case"ZXY":this._x=f*u*h-l*d*g,this._y=l*d*h+f*u*g,this._z=l*u*g+f*d*h,this._w=l*u*h-f*d*g;break;case"ZYX":this._x=f*u*h-l*d*g,this._y=l*d*h+f*u*g,this._z=l*u*g-f*d*h,this._w=l*u*h+f*d*g;break;case"YZX":this._x=f*u*h+l*d*g,this._y=l*d*h+f*u*g,this._z=l*u*g-f*d*h,this._w=l*u*h-f*d*g;break;case"XZY":this._x=f*u*h-l*d*g,this._y=l*d*h-f*u*g,this._z=l*u*g+f*d*h,this._w=l*u*h+f*d*g;break;default:jt("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let i=e/2,s=Math.sin(i);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,i=e[0],s=e[4],r=e[8],o=e[1],a=e[5],c=e[9],l=e[2],u=e[6],h=e[10],f=i+a+h;if(f>0){let d=.5/Math.sqrt(f+1);this._w=.25/d,this._x=(u-c)*d,this._y=(r-l)*d,this._z=(o-s)*d}else if(i>a&&i>h){let d=2*Math.sqrt(1+i-a-h);this._w=(u-c)/d,this._x=.25*d,this._y=(s+o)/d,this._z=(r+l)/d}else if(a>h){let d=2*Math.sqrt(1+a-i-h);this._w=(r-l)/d,this._x=(s+o)/d,this._y=.25*d,this._z=(c+u)/d}else{let d=2*Math.sqrt(1+h-i-a);this._w=(o-s)/d,this._x=(r+l)/d,this._y=(c+u)/d,this._z=.25*d}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let i=t.dot(e)+1;return i<1e-8?(i=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=i):(this._x=0,this._y=-t.z,this._z=t.y,this._w=i)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=i),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(ve(this.dot(t),-1,1)))}rotateTowards(t,e){let i=this.angleTo(t);if(i===0)return this;let s=Math.min(1,e/i);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=e._x,c=e._y,l=e._z,u=e._w;return this._x=i*u+o*a+s*l-r*c,this._y=s*u+o*c+r*a-i*l,this._z=r*u+o*l+i*c-s*a,this._w=o*u-i*a-s*c-r*l,this._onChangeCallback(),this}slerp(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let c=1-e;if(a<.9995){let l=Math.acos(a),u=Math.sin(l);c=Math.sin(c*l)/u,e=Math.sin(e*l)/u,this._x=this._x*c+i*e,this._y=this._y*c+s*e,this._z=this._z*c+r*e,this._w=this._w*c+o*e,this._onChangeCallback()}else this._x=this._x*c+i*e,this._y=this._y*c+s*e,this._z=this._z*c+r*e,this._w=this._w*c+o*e,this.normalize();return this}slerpQuaternions(t,e,i){return this.copy(t).slerp(e,i)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},H=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,i=0){this.x=t,this.y=e,this.z=i}set(t,e,i){return i===void 0&&(i=this.z),this.x=t,this.y=e,this.z=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(f0.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(f0.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*i+r[6]*s,this.y=r[1]*e+r[4]*i+r[7]*s,this.z=r[2]*e+r[5]*i+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,i=this.y,s=this.z,r=t.x,o=t.y,a=t.z,c=t.w,l=2*(o*s-a*i),u=2*(a*e-r*s),h=2*(r*i-o*e);return this.x=e+c*l+o*h-a*u,this.y=i+c*u+a*l-r*h,this.z=s+c*h+r*u-o*l,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*i+r[8]*s,this.y=r[1]*e+r[5]*i+r[9]*s,this.z=r[2]*e+r[6]*i+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=ve(this.x,t.x,e.x),this.y=ve(this.y,t.y,e.y),this.z=ve(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=ve(this.x,t,e),this.y=ve(this.y,t,e),this.z=ve(this.z,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ve(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let i=t.x,s=t.y,r=t.z,o=e.x,a=e.y,c=e.z;return this.x=s*c-r*a,this.y=r*o-i*c,this.z=i*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let i=t.dot(this)/e;return this.copy(t).multiplyScalar(i)}projectOnPlane(t){return Ad.copy(this).projectOnVector(t),this.sub(Ad)}reflect(t){return this.sub(Ad.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(ve(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y,s=this.z-t.z;return e*e+i*i+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,i){let s=Math.sin(e)*t;return this.x=s*Math.sin(i),this.y=Math.cos(e)*t,this.z=s*Math.cos(i),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,i){return this.x=t*Math.sin(e),this.y=i,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),i=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=i,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,i=Math.sqrt(1-e*e);return this.x=i*Math.cos(t),this.y=e,this.z=i*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Ad=new H,f0=new un,ae=class{static{this.prototype.isMatrix3=!0}constructor(t,e,i,s,r,o,a,c,l){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,c,l)}set(t,e,i,s,r,o,a,c,l){let u=this.elements;return u[0]=t,u[1]=s,u[2]=a,u[3]=e,u[4]=r,u[5]=c,u[6]=i,u[7]=o,u[8]=l,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],this}extractBasis(t,e,i){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[3],c=i[6],l=i[1],u=i[4],h=i[7],f=i[2],d=i[5],g=i[8],_=s[0],p=s[3],m=s[6],x=s[1],M=s[4],v=s[7],A=s[2],S=s[5],y=s[8];return r[0]=o*_+a*x+c*A,r[3]=o*p+a*M+c*S,r[6]=o*m+a*v+c*y,r[1]=l*_+u*x+h*A,r[4]=l*p+u*M+h*S,r[7]=l*m+u*v+h*y,r[2]=f*_+d*x+g*A,r[5]=f*p+d*M+g*S,r[8]=f*m+d*v+g*y,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],c=t[6],l=t[7],u=t[8];return e*o*u-e*a*l-i*r*u+i*a*c+s*r*l-s*o*c}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],c=t[6],l=t[7],u=t[8],h=u*o-a*l,f=a*c-u*r,d=l*r-o*c,g=e*h+i*f+s*d;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let _=1/g;return t[0]=h*_,t[1]=(s*l-u*i)*_,t[2]=(a*i-s*o)*_,t[3]=f*_,t[4]=(u*e-s*c)*_,t[5]=(s*r-a*e)*_,t[6]=d*_,t[7]=(i*c-l*e)*_,t[8]=(o*e-i*r)*_,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,i,s,r,o,a){let c=Math.cos(r),l=Math.sin(r);return this.set(i*c,i*l,-i*(c*o+l*a)+o+t,-s*l,s*c,-s*(-l*o+c*a)+a+e,0,0,1),this}scale(t,e){return _l("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Rd.makeScale(t,e)),this}rotate(t){return _l("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Rd.makeRotation(-t)),this}translate(t,e){return _l("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Rd.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,i,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<9;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<9;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t}clone(){return new this.constructor().fromArray(this.elements)}},Rd=new ae,d0=new ae().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),p0=new ae().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function UM(){let n={enabled:!0,workingColorSpace:bl,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Oe&&(s.r=nr(s.r),s.g=nr(s.g),s.b=nr(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Oe&&(s.r=ca(s.r),s.g=ca(s.g),s.b=ca(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===cr?Ml:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[bl]:{primaries:t,whitePoint:i,transfer:Ml,toXYZ:d0,fromXYZ:p0,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:ui},outputColorSpaceConfig:{drawingBufferColorSpace:ui}},[ui]:{primaries:t,whitePoint:i,transfer:Oe,toXYZ:d0,fromXYZ:p0,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:ui}}}),n}var Ee=UM();function nr(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function ca(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var qo,Lu=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let i;if(t instanceof HTMLCanvasElement)i=t;else{qo===void 0&&(qo=wl("canvas")),qo.width=t.width,qo.height=t.height;let s=qo.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),i=qo}return i.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=wl("canvas");e.width=t.width,e.height=t.height;let i=e.getContext("2d");i.drawImage(t,0,0,t.width,t.height);let s=i.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=nr(r[o]/255)*255;return i.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let i=0;i<e.length;i++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[i]=Math.floor(nr(e[i]/255)*255):e[i]=nr(e[i]);return{data:e,width:t.width,height:t.height}}else return jt("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},FM=0,da=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:FM++}),this.uuid=zr(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Cd(s[o].image)):r.push(Cd(s[o]))}else r=Cd(s);i.url=r}return e||(t.images[this.uuid]=i),i}};function Cd(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?Lu.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(jt("Texture: Unable to serialize Texture."),{})}var OM=0,Pd=new H,di=class n extends ls{constructor(t=n.DEFAULT_IMAGE,e=n.DEFAULT_MAPPING,i=Ps,s=Ps,r=fi,o=ar,a=fs,c=Bi,l=n.DEFAULT_ANISOTROPY,u=cr){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:OM++}),this.uuid=zr(),this.name="",this.source=new da(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=l,this.format=a,this.internalFormat=null,this.type=c,this.offset=new qt(0,0),this.repeat=new qt(1,1),this.center=new qt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new ae,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Pd).x}get height(){return this.source.getSize(Pd).y}get depth(){return this.source.getSize(Pd).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let i=t[e];if(i===void 0){jt(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){jt(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),e||(t.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==gp)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case Cu:t.x=t.x-Math.floor(t.x);break;case Ps:t.x=t.x<0?0:1;break;case Pu:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case Cu:t.y=t.y-Math.floor(t.y);break;case Ps:t.y=t.y<0?0:1;break;case Pu:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};di.DEFAULT_IMAGE=null;di.DEFAULT_MAPPING=gp;di.DEFAULT_ANISOTROPY=1;var hn=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,i=0,s=1){this.x=t,this.y=e,this.z=i,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,i,s){return this.x=t,this.y=e,this.z=i,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*i+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,i,s,r,c=t.elements,l=c[0],u=c[4],h=c[8],f=c[1],d=c[5],g=c[9],_=c[2],p=c[6],m=c[10];if(Math.abs(u-f)<.01&&Math.abs(h-_)<.01&&Math.abs(g-p)<.01){if(Math.abs(u+f)<.1&&Math.abs(h+_)<.1&&Math.abs(g+p)<.1&&Math.abs(l+d+m-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let M=(l+1)/2,v=(d+1)/2,A=(m+1)/2,S=(u+f)/4,y=(h+_)/4,w=(g+p)/4;return M>v&&M>A?M<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(M),s=S/i,r=y/i):v>A?v<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(v),i=S/s,r=w/s):A<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(A),i=y/r,s=w/r),this.set(i,s,r,e),this}let x=Math.sqrt((p-g)*(p-g)+(h-_)*(h-_)+(f-u)*(f-u));return Math.abs(x)<.001&&(x=1),this.x=(p-g)/x,this.y=(h-_)/x,this.z=(f-u)/x,this.w=Math.acos((l+d+m-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=ve(this.x,t.x,e.x),this.y=ve(this.y,t.y,e.y),this.z=ve(this.z,t.z,e.z),this.w=ve(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=ve(this.x,t,e),this.y=ve(this.y,t,e),this.z=ve(this.z,t,e),this.w=ve(this.w,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ve(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this.w=t.w+(e.w-t.w)*i,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Du=class extends ls{constructor(t=1,e=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:fi,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=i.depth,this.scissor=new hn(0,0,t,e),this.scissorTest=!1,this.viewport=new hn(0,0,t,e),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new di({width:t,height:e,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:fi,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,i=1){if(this.width!==t||this.height!==e||this.depth!==i){this.width=t,this.height=e,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,i=t.textures.length;e<i;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new da(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},Fi=class extends Du{constructor(t=1,e=1,i={}){super(t,e,i),this.isWebGLRenderTarget=!0}},Tl=class extends di{constructor(t=null,e=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=qn,this.minFilter=qn,this.wrapR=Ps,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var Nu=class extends di{constructor(t=null,e=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=qn,this.minFilter=qn,this.wrapR=Ps,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var Te=class n{static{this.prototype.isMatrix4=!0}constructor(t,e,i,s,r,o,a,c,l,u,h,f,d,g,_,p){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,c,l,u,h,f,d,g,_,p)}set(t,e,i,s,r,o,a,c,l,u,h,f,d,g,_,p){let m=this.elements;return m[0]=t,m[4]=e,m[8]=i,m[12]=s,m[1]=r,m[5]=o,m[9]=a,m[13]=c,m[2]=l,m[6]=u,m[10]=h,m[14]=f,m[3]=d,m[7]=g,m[11]=_,m[15]=p,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],e[9]=i[9],e[10]=i[10],e[11]=i[11],e[12]=i[12],e[13]=i[13],e[14]=i[14],e[15]=i[15],this}copyPosition(t){let e=this.elements,i=t.elements;return e[12]=i[12],e[13]=i[13],e[14]=i[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,i){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),i.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(t,e,i){return this.set(t.x,e.x,i.x,0,t.y,e.y,i.y,0,t.z,e.z,i.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,i=t.elements,s=1/Xo.setFromMatrixColumn(t,0).length(),r=1/Xo.setFromMatrixColumn(t,1).length(),o=1/Xo.setFromMatrixColumn(t,2).length();return e[0]=i[0]*s,e[1]=i[1]*s,e[2]=i[2]*s,e[3]=0,e[4]=i[4]*r,e[5]=i[5]*r,e[6]=i[6]*r,e[7]=0,e[8]=i[8]*o,e[9]=i[9]*o,e[10]=i[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,i=t.x,s=t.y,r=t.z,o=Math.cos(i),a=Math.sin(i),c=Math.cos(s),l=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(t.order==="XYZ"){let f=o*u,d=o*h,g=a*u,_=a*h;e[0]=c*u,e[4]=-c*h,e[8]=l,e[1]=d+g*l,e[5]=f-_*l,e[9]=-a*c,e[2]=_-f*l,e[6]=g+d*l,e[10]=o*c}else if(t.order==="YXZ"){let f=c*u,d=c*h,g=l*u,_=l*h;e[0]=f+_*a,e[4]=g*a-d,e[8]=o*l,e[1]=o*h,e[5]=o*u,e[9]=-a,e[2]=d*a-g,e[6]=_+f*a,e[10]=o*c}else if(t.order==="ZXY"){let f=c*u,d=c*h,g=l*u,_=l*h;e[0]=f-_*a,e[4]=-o*h,e[8]=g+d*a,e[1]=d+g*a,e[5]=o*u,e[9]=_-f*a,e[2]=-o*l,e[6]=a,e[10]=o*c}else if(t.order==="ZYX"){let f=o*u,d=o*h,g=a*u,_=a*h;e[0]=c*u,e[4]=g*l-d,e[8]=f*l+_,e[1]=c*h,e[5]=_*l+f,e[9]=d*l-g,e[2]=-l,e[6]=a*c,e[10]=o*c}else if(t.order==="YZX"){let f=o*c,d=o*l,g=a*c,_=a*l;e[0]=c*u,e[4]=_-f*h,e[8]=g*h+d,e[1]=h,e[5]=o*u,e[9]=-a*u,e[2]=-l*u,e[6]=d*h+g,e[10]=f-_*h}else if(t.order==="XZY"){let f=o*c,d=o*l,g=a*c,_=a*l;e[0]=c*u,e[4]=-h,e[8]=l*u,e[1]=f*h+_,e[5]=o*u,e[9]=d*h-g,e[2]=g*h-d,e[6]=a*u,e[10]=_*h+f}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(BM,t,kM)}lookAt(t,e,i){let s=this.elements;return Ni.subVectors(t,e),Ni.lengthSq()===0&&(Ni.z=1),Ni.normalize(),Er.crossVectors(i,Ni),Er.lengthSq()===0&&(Math.abs(i.z)===1?Ni.x+=1e-4:Ni.z+=1e-4,Ni.normalize(),Er.crossVectors(i,Ni)),Er.normalize(),Xc.crossVectors(Ni,Er),s[0]=Er.x,s[4]=Xc.x,s[8]=Ni.x,s[1]=Er.y,s[5]=Xc.y,s[9]=Ni.y,s[2]=Er.z,s[6]=Xc.z,s[10]=Ni.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[4],c=i[8],l=i[12],u=i[1],h=i[5],f=i[9],d=i[13],g=i[2],_=i[6],p=i[10],m=i[14],x=i[3],M=i[7],v=i[11],A=i[15],S=s[0],y=s[4],w=s[8],U=s[12],L=s[1],N=s[5],z=s[9],W=s[13],O=s[2],X=s[6],Z=s[10],q=s[14],ut=s[3],j=s[7],tt=s[11],rt=s[15];return r[0]=o*S+a*L+c*O+l*ut,r[4]=o*y+a*N+c*X+l*j,r[8]=o*w+a*z+c*Z+l*tt,r[12]=o*U+a*W+c*q+l*rt,r[1]=u*S+h*L+f*O+d*ut,r[5]=u*y+h*N+f*X+d*j,r[9]=u*w+h*z+f*Z+d*tt,r[13]=u*U+h*W+f*q+d*rt,r[2]=g*S+_*L+p*O+m*ut,r[6]=g*y+_*N+p*X+m*j,r[10]=g*w+_*z+p*Z+m*tt,r[14]=g*U+_*W+p*q+m*rt,r[3]=x*S+M*L+v*O+A*ut,r[7]=x*y+M*N+v*X+A*j,r[11]=x*w+M*z+v*Z+A*tt,r[15]=x*U+M*W+v*q+A*rt,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[12],o=t[1],a=t[5],c=t[9],l=t[13],u=t[2],h=t[6],f=t[10],d=t[14],g=t[3],_=t[7],p=t[11],m=t[15],x=c*d-l*f,M=a*d-l*h,v=a*f-c*h,A=o*d-l*u,S=o*f-c*u,y=o*h-a*u;return e*(_*x-p*M+m*v)-i*(g*x-p*A+m*S)+s*(g*M-_*A+m*y)-r*(g*v-_*S+p*y)}determinantAffine(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[1],o=t[5],a=t[9],c=t[2],l=t[6],u=t[10];return e*(o*u-a*l)-i*(r*u-a*c)+s*(r*l-o*c)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,i){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=i),this}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],c=t[6],l=t[7],u=t[8],h=t[9],f=t[10],d=t[11],g=t[12],_=t[13],p=t[14],m=t[15],x=e*a-i*o,M=e*c-s*o,v=e*l-r*o,A=i*c-s*a,S=i*l-r*a,y=s*l-r*c,w=u*_-h*g,U=u*p-f*g,L=u*m-d*g,N=h*p-f*_,z=h*m-d*_,W=f*m-d*p,O=x*W-M*z+v*N+A*L-S*U+y*w;if(O===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let X=1/O;return t[0]=(a*W-c*z+l*N)*X,t[1]=(s*z-i*W-r*N)*X,t[2]=(_*y-p*S+m*A)*X,t[3]=(f*S-h*y-d*A)*X,t[4]=(c*L-o*W-l*U)*X,t[5]=(e*W-s*L+r*U)*X,t[6]=(p*v-g*y-m*M)*X,t[7]=(u*y-f*v+d*M)*X,t[8]=(o*z-a*L+l*w)*X,t[9]=(i*L-e*z-r*w)*X,t[10]=(g*S-_*v+m*x)*X,t[11]=(h*v-u*S-d*x)*X,t[12]=(a*U-o*N-c*w)*X,t[13]=(e*N-i*U+s*w)*X,t[14]=(_*M-g*A-p*x)*X,t[15]=(u*A-h*M+f*x)*X,this}scale(t){let e=this.elements,i=t.x,s=t.y,r=t.z;return e[0]*=i,e[4]*=s,e[8]*=r,e[1]*=i,e[5]*=s,e[9]*=r,e[2]*=i,e[6]*=s,e[10]*=r,e[3]*=i,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],i=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,i,s))}makeTranslation(t,e,i){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,i,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),i=Math.sin(t);return this.set(1,0,0,0,0,e,-i,0,0,i,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,0,i,0,0,1,0,0,-i,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,0,i,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let i=Math.cos(e),s=Math.sin(e),r=1-i,o=t.x,a=t.y,c=t.z,l=r*o,u=r*a;return this.set(l*o+i,l*a-s*c,l*c+s*a,0,l*a+s*c,u*a+i,u*c-s*o,0,l*c-s*a,u*c+s*o,r*c*c+i,0,0,0,0,1),this}makeScale(t,e,i){return this.set(t,0,0,0,0,e,0,0,0,0,i,0,0,0,0,1),this}makeShear(t,e,i,s,r,o){return this.set(1,i,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,i){let s=this.elements,r=e._x,o=e._y,a=e._z,c=e._w,l=r+r,u=o+o,h=a+a,f=r*l,d=r*u,g=r*h,_=o*u,p=o*h,m=a*h,x=c*l,M=c*u,v=c*h,A=i.x,S=i.y,y=i.z;return s[0]=(1-(_+m))*A,s[1]=(d+v)*A,s[2]=(g-M)*A,s[3]=0,s[4]=(d-v)*S,s[5]=(1-(f+m))*S,s[6]=(p+x)*S,s[7]=0,s[8]=(g+M)*y,s[9]=(p-x)*y,s[10]=(1-(f+_))*y,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,i){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),e.identity(),this;let o=Xo.set(s[0],s[1],s[2]).length(),a=Xo.set(s[4],s[5],s[6]).length(),c=Xo.set(s[8],s[9],s[10]).length();r<0&&(o=-o),rs.copy(this);let l=1/o,u=1/a,h=1/c;return rs.elements[0]*=l,rs.elements[1]*=l,rs.elements[2]*=l,rs.elements[4]*=u,rs.elements[5]*=u,rs.elements[6]*=u,rs.elements[8]*=h,rs.elements[9]*=h,rs.elements[10]*=h,e.setFromRotationMatrix(rs),i.x=o,i.y=a,i.z=c,this}makePerspective(t,e,i,s,r,o,a=Yi,c=!1){let l=this.elements,u=2*r/(e-t),h=2*r/(i-s),f=(e+t)/(e-t),d=(i+s)/(i-s),g,_;if(c)g=r/(o-r),_=o*r/(o-r);else if(a===Yi)g=-(o+r)/(o-r),_=-2*o*r/(o-r);else if(a===Sl)g=-o/(o-r),_=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return l[0]=u,l[4]=0,l[8]=f,l[12]=0,l[1]=0,l[5]=h,l[9]=d,l[13]=0,l[2]=0,l[6]=0,l[10]=g,l[14]=_,l[3]=0,l[7]=0,l[11]=-1,l[15]=0,this}makeOrthographic(t,e,i,s,r,o,a=Yi,c=!1){let l=this.elements,u=2/(e-t),h=2/(i-s),f=-(e+t)/(e-t),d=-(i+s)/(i-s),g,_;if(c)g=1/(o-r),_=o/(o-r);else if(a===Yi)g=-2/(o-r),_=-(o+r)/(o-r);else if(a===Sl)g=-1/(o-r),_=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return l[0]=u,l[4]=0,l[8]=0,l[12]=f,l[1]=0,l[5]=h,l[9]=0,l[13]=d,l[2]=0,l[6]=0,l[10]=g,l[14]=_,l[3]=0,l[7]=0,l[11]=0,l[15]=1,this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<16;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<16;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t[e+9]=i[9],t[e+10]=i[10],t[e+11]=i[11],t[e+12]=i[12],t[e+13]=i[13],t[e+14]=i[14],t[e+15]=i[15],t}},Xo=new H,rs=new Te,BM=new H(0,0,0),kM=new H(1,1,1),Er=new H,Xc=new H,Ni=new H,m0=new Te,g0=new un,Pr=class n{constructor(t=0,e=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=i,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,i,s=this._order){return this._x=t,this._y=e,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,i=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],c=s[1],l=s[5],u=s[9],h=s[2],f=s[6],d=s[10];switch(e){case"XYZ":this._y=Math.asin(ve(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,d),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(f,l),this._z=0);break;case"YXZ":this._x=Math.asin(-ve(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,d),this._z=Math.atan2(c,l)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(ve(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-h,d),this._z=Math.atan2(-o,l)):(this._y=0,this._z=Math.atan2(c,r));break;case"ZYX":this._y=Math.asin(-ve(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(f,d),this._z=Math.atan2(c,r)):(this._x=0,this._z=Math.atan2(-o,l));break;case"YZX":this._z=Math.asin(ve(c,-1,1)),Math.abs(c)<.9999999?(this._x=Math.atan2(-u,l),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,d));break;case"XZY":this._z=Math.asin(-ve(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(f,l),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,d),this._y=0);break;default:jt("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,i===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,i){return m0.makeRotationFromQuaternion(t),this.setFromRotationMatrix(m0,e,i)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return g0.setFromEuler(this),this.setFromQuaternion(g0,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Pr.DEFAULT_ORDER="XYZ";var pa=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},zM=0,_0=new H,$o=new un,Js=new Te,$c=new H,al=new H,HM=new H,GM=new un,x0=new H(1,0,0),y0=new H(0,1,0),v0=new H(0,0,1),b0={type:"added"},VM={type:"removed"},Yo={type:"childadded",child:null},Id={type:"childremoved",child:null},pi=class n extends ls{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:zM++}),this.uuid=zr(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let t=new H,e=new Pr,i=new un,s=new H(1,1,1);function r(){i.setFromEuler(e,!1)}function o(){e.setFromQuaternion(i,void 0,!1)}e._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Te},normalMatrix:{value:new ae}}),this.matrix=new Te,this.matrixWorld=new Te,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new pa,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return $o.setFromAxisAngle(t,e),this.quaternion.multiply($o),this}rotateOnWorldAxis(t,e){return $o.setFromAxisAngle(t,e),this.quaternion.premultiply($o),this}rotateX(t){return this.rotateOnAxis(x0,t)}rotateY(t){return this.rotateOnAxis(y0,t)}rotateZ(t){return this.rotateOnAxis(v0,t)}translateOnAxis(t,e){return _0.copy(t).applyQuaternion(this.quaternion),this.position.add(_0.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(x0,t)}translateY(t){return this.translateOnAxis(y0,t)}translateZ(t){return this.translateOnAxis(v0,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(Js.copy(this.matrixWorld).invert())}lookAt(t,e,i){t.isVector3?$c.copy(t):$c.set(t,e,i);let s=this.parent;this.updateWorldMatrix(!0,!1),al.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Js.lookAt(al,$c,this.up):Js.lookAt($c,al,this.up),this.quaternion.setFromRotationMatrix(Js),s&&(Js.extractRotation(s.matrixWorld),$o.setFromRotationMatrix(Js),this.quaternion.premultiply($o.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(ie("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(b0),Yo.child=t,this.dispatchEvent(Yo),Yo.child=null):ie("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(VM),Id.child=t,this.dispatchEvent(Id),Id.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),Js.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),Js.multiply(t.parent.matrixWorld)),t.applyMatrix4(Js),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(b0),Yo.child=t,this.dispatchEvent(Yo),Yo.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,i=[]){this[t]===e&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,i);return i}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(al,t,HM),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(al,GM,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,i=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*i-r[8]*s,r[13]+=i-r[1]*e-r[5]*i-r[9]*s,r[14]+=s-r[2]*e-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].updateMatrixWorld(t)}updateWorldMatrix(t,e,i=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(t){let e=t===void 0||typeof t=="string",i={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,c){return a[c.uuid]===void 0&&(a[c.uuid]=c.toJSON(t)),c.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let c=a.shapes;if(Array.isArray(c))for(let l=0,u=c.length;l<u;l++){let h=c[l];r(t.shapes,h)}else r(t.shapes,c)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let c=0,l=this.material.length;c<l;c++)a.push(r(t.materials,this.material[c]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let c=this.animations[a];s.animations.push(r(t.animations,c))}}if(e){let a=o(t.geometries),c=o(t.materials),l=o(t.textures),u=o(t.images),h=o(t.shapes),f=o(t.skeletons),d=o(t.animations),g=o(t.nodes);a.length>0&&(i.geometries=a),c.length>0&&(i.materials=c),l.length>0&&(i.textures=l),u.length>0&&(i.images=u),h.length>0&&(i.shapes=h),f.length>0&&(i.skeletons=f),d.length>0&&(i.animations=d),g.length>0&&(i.nodes=g)}return i.object=s,i;function o(a){let c=[];for(let l in a){let u=a[l];delete u.metadata,c.push(u)}return c}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let i=0;i<t.children.length;i++){let s=t.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};pi.DEFAULT_UP=new H(0,1,0);pi.DEFAULT_MATRIX_AUTO_UPDATE=!0;pi.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var bi=class extends pi{constructor(){super(),this.isGroup=!0,this.type="Group"}},WM={type:"move"},ma=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new bi,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new bi,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new H,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new H),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new bi,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new H,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new H,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let i of t.hand.values())this._getHandJoint(e,i)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,i){let s=null,r=null,o=null,a=this._targetRay,c=this._grip,l=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(l&&t.hand){o=!0;for(let _ of t.hand.values()){let p=e.getJointPose(_,i),m=this._getHandJoint(l,_);p!==null&&(m.matrix.fromArray(p.transform.matrix),m.matrix.decompose(m.position,m.quaternion,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=p.radius),m.visible=p!==null}let u=l.joints["index-finger-tip"],h=l.joints["thumb-tip"],f=u.position.distanceTo(h.position),d=.02,g=.005;l.inputState.pinching&&f>d+g?(l.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!l.inputState.pinching&&f<=d-g&&(l.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else c!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,i),r!==null&&(c.matrix.fromArray(r.transform.matrix),c.matrix.decompose(c.position,c.quaternion,c.scale),c.matrixWorldNeedsUpdate=!0,r.linearVelocity?(c.hasLinearVelocity=!0,c.linearVelocity.copy(r.linearVelocity)):c.hasLinearVelocity=!1,r.angularVelocity?(c.hasAngularVelocity=!0,c.angularVelocity.copy(r.angularVelocity)):c.hasAngularVelocity=!1,c.eventsEnabled&&c.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(WM)))}return a!==null&&(a.visible=s!==null),c!==null&&(c.visible=r!==null),l!==null&&(l.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let i=new bi;i.matrixAutoUpdate=!1,i.visible=!1,t.joints[e.jointName]=i,t.add(i)}return t.joints[e.jointName]}},A_={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Tr={h:0,s:0,l:0},Yc={h:0,s:0,l:0};function Ld(n,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?n+(t-n)*6*e:e<1/2?t:e<2/3?n+(t-n)*6*(2/3-e):n}var ee=class{constructor(t,e,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,i)}set(t,e,i){if(e===void 0&&i===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,i);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=ui){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,Ee.colorSpaceToWorking(this,e),this}setRGB(t,e,i,s=Ee.workingColorSpace){return this.r=t,this.g=e,this.b=i,Ee.colorSpaceToWorking(this,s),this}setHSL(t,e,i,s=Ee.workingColorSpace){if(t=Ip(t,1),e=ve(e,0,1),i=ve(i,0,1),e===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+e):i+e-i*e,o=2*i-r;this.r=Ld(o,r,t+1/3),this.g=Ld(o,r,t),this.b=Ld(o,r,t-1/3)}return Ee.colorSpaceToWorking(this,s),this}setStyle(t,e=ui){function i(r){r!==void 0&&parseFloat(r)<1&&jt("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:jt("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);jt("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=ui){let i=A_[t.toLowerCase()];return i!==void 0?this.setHex(i,e):jt("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=nr(t.r),this.g=nr(t.g),this.b=nr(t.b),this}copyLinearToSRGB(t){return this.r=ca(t.r),this.g=ca(t.g),this.b=ca(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=ui){return Ee.workingToColorSpace(ti.copy(this),t),Math.round(ve(ti.r*255,0,255))*65536+Math.round(ve(ti.g*255,0,255))*256+Math.round(ve(ti.b*255,0,255))}getHexString(t=ui){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=Ee.workingColorSpace){Ee.workingToColorSpace(ti.copy(this),e);let i=ti.r,s=ti.g,r=ti.b,o=Math.max(i,s,r),a=Math.min(i,s,r),c,l,u=(a+o)/2;if(a===o)c=0,l=0;else{let h=o-a;switch(l=u<=.5?h/(o+a):h/(2-o-a),o){case i:c=(s-r)/h+(s<r?6:0);break;case s:c=(r-i)/h+2;break;case r:c=(i-s)/h+4;break}c/=6}return t.h=c,t.s=l,t.l=u,t}getRGB(t,e=Ee.workingColorSpace){return Ee.workingToColorSpace(ti.copy(this),e),t.r=ti.r,t.g=ti.g,t.b=ti.b,t}getStyle(t=ui){Ee.workingToColorSpace(ti.copy(this),t);let e=ti.r,i=ti.g,s=ti.b;return t!==ui?`color(${t} ${e.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(t,e,i){return this.getHSL(Tr),this.setHSL(Tr.h+t,Tr.s+e,Tr.l+i)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,i){return this.r=t.r+(e.r-t.r)*i,this.g=t.g+(e.g-t.g)*i,this.b=t.b+(e.b-t.b)*i,this}lerpHSL(t,e){this.getHSL(Tr),t.getHSL(Yc);let i=yl(Tr.h,Yc.h,e),s=yl(Tr.s,Yc.s,e),r=yl(Tr.l,Yc.l,e);return this.setHSL(i,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,i=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*i+r[6]*s,this.g=r[1]*e+r[4]*i+r[7]*s,this.b=r[2]*e+r[5]*i+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},ti=new ee;ee.NAMES=A_;var Al=class n{constructor(t,e=1,i=1e3){this.isFog=!0,this.name="",this.color=new ee(t),this.near=e,this.far=i}clone(){return new n(this.color,this.near,this.far)}toJSON(){return{type:"Fog",name:this.name,color:this.color.getHex(),near:this.near,far:this.far}}},Rl=class extends pi{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Pr,this.environmentIntensity=1,this.environmentRotation=new Pr,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},os=new H,Ks=new H,Dd=new H,js=new H,Zo=new H,Jo=new H,M0=new H,Nd=new H,Ud=new H,Fd=new H,Od=new hn,Bd=new hn,kd=new hn,er=class n{constructor(t=new H,e=new H,i=new H){this.a=t,this.b=e,this.c=i}static getNormal(t,e,i,s){s.subVectors(i,e),os.subVectors(t,e),s.cross(os);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,i,s,r){os.subVectors(s,e),Ks.subVectors(i,e),Dd.subVectors(t,e);let o=os.dot(os),a=os.dot(Ks),c=os.dot(Dd),l=Ks.dot(Ks),u=Ks.dot(Dd),h=o*l-a*a;if(h===0)return r.set(0,0,0),null;let f=1/h,d=(l*c-a*u)*f,g=(o*u-a*c)*f;return r.set(1-d-g,g,d)}static containsPoint(t,e,i,s){return this.getBarycoord(t,e,i,s,js)===null?!1:js.x>=0&&js.y>=0&&js.x+js.y<=1}static getInterpolation(t,e,i,s,r,o,a,c){return this.getBarycoord(t,e,i,s,js)===null?(c.x=0,c.y=0,"z"in c&&(c.z=0),"w"in c&&(c.w=0),null):(c.setScalar(0),c.addScaledVector(r,js.x),c.addScaledVector(o,js.y),c.addScaledVector(a,js.z),c)}static getInterpolatedAttribute(t,e,i,s,r,o){return Od.setScalar(0),Bd.setScalar(0),kd.setScalar(0),Od.fromBufferAttribute(t,e),Bd.fromBufferAttribute(t,i),kd.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(Od,r.x),o.addScaledVector(Bd,r.y),o.addScaledVector(kd,r.z),o}static isFrontFacing(t,e,i,s){return os.subVectors(i,e),Ks.subVectors(t,e),os.cross(Ks).dot(s)<0}set(t,e,i){return this.a.copy(t),this.b.copy(e),this.c.copy(i),this}setFromPointsAndIndices(t,e,i,s){return this.a.copy(t[e]),this.b.copy(t[i]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,i,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,i),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return os.subVectors(this.c,this.b),Ks.subVectors(this.a,this.b),os.cross(Ks).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return n.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return n.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,i,s,r){return n.getInterpolation(t,this.a,this.b,this.c,e,i,s,r)}containsPoint(t){return n.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return n.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let i=this.a,s=this.b,r=this.c,o,a;Zo.subVectors(s,i),Jo.subVectors(r,i),Nd.subVectors(t,i);let c=Zo.dot(Nd),l=Jo.dot(Nd);if(c<=0&&l<=0)return e.copy(i);Ud.subVectors(t,s);let u=Zo.dot(Ud),h=Jo.dot(Ud);if(u>=0&&h<=u)return e.copy(s);let f=c*h-u*l;if(f<=0&&c>=0&&u<=0&&c-u>0)return o=c/(c-u),e.copy(i).addScaledVector(Zo,o);Fd.subVectors(t,r);let d=Zo.dot(Fd),g=Jo.dot(Fd);if(g>=0&&d<=g)return e.copy(r);let _=d*l-c*g;if(_<=0&&l>=0&&g<=0)return a=l/(l-g),e.copy(i).addScaledVector(Jo,a);let p=u*g-d*h;if(p<=0&&h-u>=0&&d-g>=0)return M0.subVectors(r,s),a=(h-u)/(h-u+(d-g)),e.copy(s).addScaledVector(M0,a);let m=1/(p+_+f);return o=_*m,a=f*m,e.copy(i).addScaledVector(Zo,o).addScaledVector(Jo,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},Mi=class{constructor(t=new H(1/0,1/0,1/0),e=new H(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e+=3)this.expandByPoint(as.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,i=t.count;e<i;e++)this.expandByPoint(as.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let i=as.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(i),this.max.copy(t).add(i),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let i=t.geometry;if(i!==void 0){let r=i.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,as):as.fromBufferAttribute(r,o),as.applyMatrix4(t.matrixWorld),this.expandByPoint(as);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),Zc.copy(t.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),Zc.copy(i.boundingBox)),Zc.applyMatrix4(t.matrixWorld),this.union(Zc)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,as),as.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,i;return t.normal.x>0?(e=t.normal.x*this.min.x,i=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,i=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,i+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,i+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,i+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,i+=t.normal.z*this.min.z),e<=-t.constant&&i>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(ll),Jc.subVectors(this.max,ll),Ko.subVectors(t.a,ll),jo.subVectors(t.b,ll),Qo.subVectors(t.c,ll),Ar.subVectors(jo,Ko),Rr.subVectors(Qo,jo),no.subVectors(Ko,Qo);let e=[0,-Ar.z,Ar.y,0,-Rr.z,Rr.y,0,-no.z,no.y,Ar.z,0,-Ar.x,Rr.z,0,-Rr.x,no.z,0,-no.x,-Ar.y,Ar.x,0,-Rr.y,Rr.x,0,-no.y,no.x,0];return!zd(e,Ko,jo,Qo,Jc)||(e=[1,0,0,0,1,0,0,0,1],!zd(e,Ko,jo,Qo,Jc))?!1:(Kc.crossVectors(Ar,Rr),e=[Kc.x,Kc.y,Kc.z],zd(e,Ko,jo,Qo,Jc))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,as).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(as).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(Qs[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),Qs[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),Qs[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),Qs[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),Qs[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),Qs[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),Qs[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),Qs[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(Qs),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},Qs=[new H,new H,new H,new H,new H,new H,new H,new H],as=new H,Zc=new Mi,Ko=new H,jo=new H,Qo=new H,Ar=new H,Rr=new H,no=new H,ll=new H,Jc=new H,Kc=new H,io=new H;function zd(n,t,e,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){io.fromArray(n,r);let a=s.x*Math.abs(io.x)+s.y*Math.abs(io.y)+s.z*Math.abs(io.z),c=t.dot(io),l=e.dot(io),u=i.dot(io);if(Math.max(-Math.max(c,l,u),Math.min(c,l,u))>a)return!1}return!0}var Cn=new H,jc=new qt,qM=0,sn=class extends ls{constructor(t,e,i=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:qM++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=i,this.usage=Cp,this.updateRanges=[],this.gpuType=Ki,this.version=0,this._normalizationScale=t!==void 0?Hh(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,i){t*=this.itemSize,i*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[i+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,i=this.count;e<i;e++)jc.fromBufferAttribute(this,e),jc.applyMatrix3(t),this.setXY(e,jc.x,jc.y);else if(this.itemSize===3)for(let e=0,i=this.count;e<i;e++)Cn.fromBufferAttribute(this,e),Cn.applyMatrix3(t),this.setXYZ(e,Cn.x,Cn.y,Cn.z);return this}applyMatrix4(t){for(let e=0,i=this.count;e<i;e++)Cn.fromBufferAttribute(this,e),Cn.applyMatrix4(t),this.setXYZ(e,Cn.x,Cn.y,Cn.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)Cn.fromBufferAttribute(this,e),Cn.applyNormalMatrix(t),this.setXYZ(e,Cn.x,Cn.y,Cn.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)Cn.fromBufferAttribute(this,e),Cn.transformDirection(t),this.setXYZ(e,Cn.x,Cn.y,Cn.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let i=this.array[t*this.itemSize+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.array[t*this.itemSize+e]=i,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,i){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.array[t+0]=e,this.array[t+1]=i,this}setXYZ(t,e,i,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):Dp(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):Np(t,this.array)}};var Cl=class extends sn{constructor(t,e,i){super(new Uint16Array(t),e,i)}};var Pl=class extends sn{constructor(t,e,i){super(new Uint32Array(t),e,i)}};var Ce=class extends sn{constructor(t,e,i){super(new Float32Array(t),e,i)}},XM=new Mi,cl=new H,Hd=new H,Is=class{constructor(t=new H,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let i=this.center;e!==void 0?i.copy(e):XM.setFromPoints(t).getCenter(i);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,i.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let i=this.center.distanceToSquared(t);return e.copy(t),i>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;cl.subVectors(t,this.center);let e=cl.lengthSq();if(e>this.radius*this.radius){let i=Math.sqrt(e),s=(i-this.radius)*.5;this.center.addScaledVector(cl,s/i),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(Hd.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(cl.copy(t.center).add(Hd)),this.expandByPoint(cl.copy(t.center).sub(Hd))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},$M=0,$i=new Te,Gd=new pi,ta=new H,Ui=new Mi,ul=new Mi,Wn=new H,De=class n extends ls{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:$M++}),this.uuid=zr(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(xM(t)?Pl:Cl)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,i=0){this.groups.push({start:t,count:e,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new ae().getNormalMatrix(t);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return $i.makeRotationFromQuaternion(t),this.applyMatrix4($i),this}rotateX(t){return $i.makeRotationX(t),this.applyMatrix4($i),this}rotateY(t){return $i.makeRotationY(t),this.applyMatrix4($i),this}rotateZ(t){return $i.makeRotationZ(t),this.applyMatrix4($i),this}translate(t,e,i){return $i.makeTranslation(t,e,i),this.applyMatrix4($i),this}scale(t,e,i){return $i.makeScale(t,e,i),this.applyMatrix4($i),this}lookAt(t){return Gd.lookAt(t),Gd.updateMatrix(),this.applyMatrix4(Gd.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(ta).negate(),this.translate(ta.x,ta.y,ta.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let i=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Ce(i,3))}else{let i=Math.min(t.length,e.count);for(let s=0;s<i;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&jt("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Mi);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){ie("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new H(-1/0,-1/0,-1/0),new H(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let i=0,s=e.length;i<s;i++){let r=e[i];Ui.setFromBufferAttribute(r),this.morphTargetsRelative?(Wn.addVectors(this.boundingBox.min,Ui.min),this.boundingBox.expandByPoint(Wn),Wn.addVectors(this.boundingBox.max,Ui.max),this.boundingBox.expandByPoint(Wn)):(this.boundingBox.expandByPoint(Ui.min),this.boundingBox.expandByPoint(Ui.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&ie('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Is);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){ie("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new H,1/0);return}if(t){let i=this.boundingSphere.center;if(Ui.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];ul.setFromBufferAttribute(a),this.morphTargetsRelative?(Wn.addVectors(Ui.min,ul.min),Ui.expandByPoint(Wn),Wn.addVectors(Ui.max,ul.max),Ui.expandByPoint(Wn)):(Ui.expandByPoint(ul.min),Ui.expandByPoint(ul.max))}Ui.getCenter(i);let s=0;for(let r=0,o=t.count;r<o;r++)Wn.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(Wn));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],c=this.morphTargetsRelative;for(let l=0,u=a.count;l<u;l++)Wn.fromBufferAttribute(a,l),c&&(ta.fromBufferAttribute(t,l),Wn.add(ta)),s=Math.max(s,i.distanceToSquared(Wn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&ie('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){ie("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new sn(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],c=[],l=new Uint8Array(i.count);for(let U=0;U<i.count;U++)a[U]=new H,c[U]=new H;let u=new H,h=new H,f=new H,d=new qt,g=new qt,_=new qt,p=new H,m=new H;function x(U,L,N){l[U]=l[L]=l[N]=1,u.fromBufferAttribute(i,U),h.fromBufferAttribute(i,L),f.fromBufferAttribute(i,N),d.fromBufferAttribute(r,U),g.fromBufferAttribute(r,L),_.fromBufferAttribute(r,N),h.sub(u),f.sub(u),g.sub(d),_.sub(d);let z=1/(g.x*_.y-_.x*g.y);isFinite(z)&&(p.copy(h).multiplyScalar(_.y).addScaledVector(f,-g.y).multiplyScalar(z),m.copy(f).multiplyScalar(g.x).addScaledVector(h,-_.x).multiplyScalar(z),a[U].add(p),a[L].add(p),a[N].add(p),c[U].add(m),c[L].add(m),c[N].add(m))}let M=this.groups;M.length===0&&(M=[{start:0,count:t.count}]);for(let U=0,L=M.length;U<L;++U){let N=M[U],z=N.start,W=N.count;for(let O=z,X=z+W;O<X;O+=3)x(t.getX(O+0),t.getX(O+1),t.getX(O+2))}let v=new H,A=new H,S=new H,y=new H;function w(U){S.fromBufferAttribute(s,U),y.copy(S);let L=a[U];v.copy(L),v.sub(S.multiplyScalar(S.dot(L))).normalize(),A.crossVectors(y,L);let z=A.dot(c[U])<0?-1:1;o.setXYZW(U,v.x,v.y,v.z,z)}for(let U=0,L=i.count;U<L;++U)l[U]&&w(U);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==e.count)i=new sn(new Float32Array(e.count*3),3),this.setAttribute("normal",i);else for(let f=0,d=i.count;f<d;f++)i.setXYZ(f,0,0,0);let s=new H,r=new H,o=new H,a=new H,c=new H,l=new H,u=new H,h=new H;if(t)for(let f=0,d=t.count;f<d;f+=3){let g=t.getX(f+0),_=t.getX(f+1),p=t.getX(f+2);s.fromBufferAttribute(e,g),r.fromBufferAttribute(e,_),o.fromBufferAttribute(e,p),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(i,g),c.fromBufferAttribute(i,_),l.fromBufferAttribute(i,p),a.add(u),c.add(u),l.add(u),i.setXYZ(g,a.x,a.y,a.z),i.setXYZ(_,c.x,c.y,c.z),i.setXYZ(p,l.x,l.y,l.z)}else for(let f=0,d=e.count;f<d;f+=3)s.fromBufferAttribute(e,f+0),r.fromBufferAttribute(e,f+1),o.fromBufferAttribute(e,f+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),i.setXYZ(f+0,u.x,u.y,u.z),i.setXYZ(f+1,u.x,u.y,u.z),i.setXYZ(f+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,i=t.count;e<i;e++)Wn.fromBufferAttribute(t,e),Wn.normalize(),t.setXYZ(e,Wn.x,Wn.y,Wn.z)}toNonIndexed(){function t(a,c){let l=a.array,u=a.itemSize,h=a.normalized,f=new l.constructor(c.length*u),d=0,g=0;for(let _=0,p=c.length;_<p;_++){a.isInterleavedBufferAttribute?d=c[_]*a.data.stride+a.offset:d=c[_]*u;for(let m=0;m<u;m++)f[g++]=l[d++]}return new sn(f,u,h)}if(this.index===null)return jt("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new n,i=this.index.array,s=this.attributes;for(let a in s){let c=s[a],l=t(c,i);e.setAttribute(a,l)}let r=this.morphAttributes;for(let a in r){let c=[],l=r[a];for(let u=0,h=l.length;u<h;u++){let f=l[u],d=t(f,i);c.push(d)}e.morphAttributes[a]=c}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,c=o.length;a<c;a++){let l=o[a];e.addGroup(l.start,l.count,l.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let c=this.parameters;for(let l in c)c[l]!==void 0&&(t[l]=c[l]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let i=this.attributes;for(let c in i){let l=i[c];t.data.attributes[c]=l.toJSON(t.data)}let s={},r=!1;for(let c in this.morphAttributes){let l=this.morphAttributes[c],u=[];for(let h=0,f=l.length;h<f;h++){let d=l[h];u.push(d.toJSON(t.data))}u.length>0&&(s[c]=u,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let i=t.index;i!==null&&this.setIndex(i.clone());let s=t.attributes;for(let l in s){let u=s[l];this.setAttribute(l,u.clone(e))}let r=t.morphAttributes;for(let l in r){let u=[],h=r[l];for(let f=0,d=h.length;f<d;f++)u.push(h[f].clone(e));this.morphAttributes[l]=u}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let l=0,u=o.length;l<u;l++){let h=o[l];this.addGroup(h.start,h.count,h.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let c=t.boundingSphere;return c!==null&&(this.boundingSphere=c.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},Il=class{constructor(t,e){this.isInterleavedBuffer=!0,this.array=t,this.stride=e,this.count=t!==void 0?t.length/e:0,this.usage=Cp,this.updateRanges=[],this.version=0,this.uuid=zr()}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.array=new t.array.constructor(t.array),this.count=t.count,this.stride=t.stride,this.usage=t.usage,this}copyAt(t,e,i){t*=this.stride,i*=e.stride;for(let s=0,r=this.stride;s<r;s++)this.array[t+s]=e.array[i+s];return this}set(t,e=0){return this.array.set(t,e),this}clone(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=S0(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=this.array.slice(0).buffer);let i=new this.array.constructor(t.arrayBuffers[e]),s=new this.constructor(i,this.stride);return s.setUsage(this.usage),s}onUpload(t){return this.onUploadCallback=t,this}toJSON(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=S0(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let i={uuid:this.uuid,buffer:e,type:this.array.constructor.name,stride:this.stride};return i.usage=this.usage,i}};function S0(n){return n.buffer._uuid===void 0&&(n.buffer._uuid=zr()),n.byteOffset===0&&n.byteLength===n.buffer.byteLength?n.buffer._uuid:n.buffer._uuid+":"+n.byteOffset+":"+n.byteLength}var ci=new H,ga=class n{constructor(t,e,i,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=t,this.itemSize=e,this.offset=i,this.normalized=s,this._normalizationScale=t!==void 0?Hh(t.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(t){this.data.needsUpdate=t}applyMatrix4(t){for(let e=0,i=this.data.count;e<i;e++)ci.fromBufferAttribute(this,e),ci.applyMatrix4(t),this.setXYZ(e,ci.x,ci.y,ci.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)ci.fromBufferAttribute(this,e),ci.applyNormalMatrix(t),this.setXYZ(e,ci.x,ci.y,ci.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)ci.fromBufferAttribute(this,e),ci.transformDirection(t),this.setXYZ(e,ci.x,ci.y,ci.z);return this}getComponent(t,e){let i=this.array[t*this.data.stride+this.offset+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.data.array[t*this.data.stride+this.offset+e]=i,this}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset]=e,this}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+1]=e,this}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+2]=e,this}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+3]=e,this}getX(t){let e=this.data.array[t*this.data.stride+this.offset];return this.normalized&&(e=this._denormalize(e)),e}getY(t){let e=this.data.array[t*this.data.stride+this.offset+1];return this.normalized&&(e=this._denormalize(e)),e}getZ(t){let e=this.data.array[t*this.data.stride+this.offset+2];return this.normalized&&(e=this._denormalize(e)),e}getW(t){let e=this.data.array[t*this.data.stride+this.offset+3];return this.normalized&&(e=this._denormalize(e)),e}setXY(t,e,i){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.data.array[t+0]=e,this.data.array[t+1]=i,this}setXYZ(t,e,i,s){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.data.array[t+0]=e,this.data.array[t+1]=i,this.data.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.data.array[t+0]=e,this.data.array[t+1]=i,this.data.array[t+2]=s,this.data.array[t+3]=r,this}clone(t){if(t===void 0){El("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return new sn(new this.array.constructor(e),this.itemSize,this.normalized)}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.clone(t)),new n(t.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(t){if(t===void 0){El("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:e,normalized:this.normalized}}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.toJSON(t)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):Dp(t,this.data.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):Np(t,this.data.array)}},Vd=new H,YM=new H,ZM=new ae,Zn=class{constructor(t=new H(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,i,s){return this.normal.set(t,e,i),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,i){let s=Vd.subVectors(i,e).cross(YM.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,i=!0){let s=t.delta(Vd),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),i=this.distanceToPoint(t.end);return e<0&&i>0||i<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let i=e||ZM.getNormalMatrix(t),s=this.coplanarPoint(Vd).applyMatrix4(t),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},JM=0,Ls=class extends ls{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:JM++}),this.uuid=zr(),this.name="",this.type="Material",this.blending=wa,this.side=Br,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=op,this.blendDst=ap,this.blendEquation=fo,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new ee(0,0,0),this.blendAlpha=0,this.depthFunc=ua,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=__,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=bu,this.stencilZFail=bu,this.stencilZPass=bu,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let i=t[e];if(i===void 0){jt(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){jt(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(t).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(t).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(t).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(t).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(t).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let c=r[a];delete c.metadata,o.push(c)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new ee().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(i=>new Zn().fromJSON(i))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let i=t.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new qt().fromArray(i)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new qt().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,i=null;if(e!==null){let s=e.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=e[r].clone()}return this.clippingPlanes=i,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}},_a=class extends Ls{constructor(t){super(),this.isSpriteMaterial=!0,this.type="SpriteMaterial",this.color=new ee(16777215),this.map=null,this.alphaMap=null,this.rotation=0,this.sizeAttenuation=!0,this.transparent=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.rotation=t.rotation,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},ea,hl=new H,na=new H,ia=new H,sa=new qt,fl=new qt,R_=new Te,Qc=new H,dl=new H,tu=new H,w0=new qt,Wd=new qt,E0=new qt,Ll=class extends pi{constructor(t=new _a){if(super(),this.isSprite=!0,this.type="Sprite",ea===void 0){ea=new De;let e=new Float32Array([-.5,-.5,0,0,0,.5,-.5,0,1,0,.5,.5,0,1,1,-.5,.5,0,0,1]),i=new Il(e,5);ea.setIndex([0,1,2,0,2,3]),ea.setAttribute("position",new ga(i,3,0,!1)),ea.setAttribute("uv",new ga(i,2,3,!1))}this.geometry=ea,this.material=t,this.center=new qt(.5,.5),this.count=1}intersectsFrustum(t){return t.intersectsSprite(this)}raycast(t,e){t.camera===null&&ie('Sprite: "Raycaster.camera" needs to be set in order to raycast against sprites.'),na.setFromMatrixScale(this.matrixWorld),R_.copy(t.camera.matrixWorld),this.modelViewMatrix.multiplyMatrices(t.camera.matrixWorldInverse,this.matrixWorld),ia.setFromMatrixPosition(this.modelViewMatrix),t.camera.isPerspectiveCamera&&this.material.sizeAttenuation===!1&&na.multiplyScalar(-ia.z);let i=this.material.rotation,s,r;i!==0&&(r=Math.cos(i),s=Math.sin(i));let o=this.center;eu(Qc.set(-.5,-.5,0),ia,o,na,s,r),eu(dl.set(.5,-.5,0),ia,o,na,s,r),eu(tu.set(.5,.5,0),ia,o,na,s,r),w0.set(0,0),Wd.set(1,0),E0.set(1,1);let a=t.ray.intersectTriangle(Qc,dl,tu,!1,hl);if(a===null&&(eu(dl.set(-.5,.5,0),ia,o,na,s,r),Wd.set(0,1),a=t.ray.intersectTriangle(Qc,tu,dl,!1,hl),a===null))return;let c=t.ray.origin.distanceTo(hl);c<t.near||c>t.far||e.push({distance:c,point:hl.clone(),uv:er.getInterpolation(hl,Qc,dl,tu,w0,Wd,E0,new qt),face:null,object:this})}copy(t,e){return super.copy(t,e),t.center!==void 0&&this.center.copy(t.center),this.material=t.material,this}toJSON(t){let e=super.toJSON(t);return e.object.center=this.center.toArray(),e}};function eu(n,t,e,i,s,r){sa.subVectors(n,e).addScalar(.5).multiply(i),s!==void 0?(fl.x=r*sa.x-s*sa.y,fl.y=s*sa.x+r*sa.y):fl.copy(sa),n.copy(t),n.x+=fl.x,n.y+=fl.y,n.applyMatrix4(R_)}var tr=new H,qd=new H,nu=new H,iu=new H,sr=class{constructor(t=new H,e=new H(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,tr)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let i=e.dot(this.direction);return i<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=tr.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(tr.copy(this.origin).addScaledVector(this.direction,e),tr.distanceToSquared(t))}distanceSqToSegment(t,e,i,s){qd.copy(t).add(e).multiplyScalar(.5),nu.copy(e).sub(t).normalize(),iu.copy(this.origin).sub(qd);let r=t.distanceTo(e)*.5,o=-this.direction.dot(nu),a=iu.dot(this.direction),c=-iu.dot(nu),l=iu.lengthSq(),u=Math.abs(1-o*o),h,f,d,g;if(u>0)if(h=o*c-a,f=o*a-c,g=r*u,h>=0)if(f>=-g)if(f<=g){let _=1/u;h*=_,f*=_,d=h*(h+o*f+2*a)+f*(o*h+f+2*c)+l}else f=r,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*c)+l;else f=-r,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*c)+l;else f<=-g?(h=Math.max(0,-(-o*r+a)),f=h>0?-r:Math.min(Math.max(-r,-c),r),d=-h*h+f*(f+2*c)+l):f<=g?(h=0,f=Math.min(Math.max(-r,-c),r),d=f*(f+2*c)+l):(h=Math.max(0,-(o*r+a)),f=h>0?r:Math.min(Math.max(-r,-c),r),d=-h*h+f*(f+2*c)+l);else f=o>0?-r:r,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*c)+l;return i&&i.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(qd).addScaledVector(nu,f),d}intersectSphere(t,e){if(t.radius<0)return null;tr.subVectors(t.center,this.origin);let i=tr.dot(this.direction),s=tr.dot(tr)-i*i,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,c=i+o;return c<0?null:a<0?this.at(c,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(t.normal)+t.constant)/e;return i>=0?i:null}intersectPlane(t,e){let i=this.distanceToPlane(t);return i===null?null:this.at(i,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let i,s,r,o,a,c,l=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,f=this.origin;return l>=0?(i=(t.min.x-f.x)*l,s=(t.max.x-f.x)*l):(i=(t.max.x-f.x)*l,s=(t.min.x-f.x)*l),u>=0?(r=(t.min.y-f.y)*u,o=(t.max.y-f.y)*u):(r=(t.max.y-f.y)*u,o=(t.min.y-f.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(t.min.z-f.z)*h,c=(t.max.z-f.z)*h):(a=(t.max.z-f.z)*h,c=(t.min.z-f.z)*h),i>c||a>s)||((a>i||i!==i)&&(i=a),(c<s||s!==s)&&(s=c),s<0)?null:this.at(i>=0?i:s,e)}intersectsBox(t){return this.intersectBox(t,tr)!==null}intersectTriangle(t,e,i,s,r){let o=this.origin,a=this.direction,c=a.x,l=a.y,u=a.z,h=t.x-o.x,f=t.y-o.y,d=t.z-o.z,g=e.x-o.x,_=e.y-o.y,p=e.z-o.z,m=i.x-o.x,x=i.y-o.y,M=i.z-o.z,v=Math.abs(c),A=Math.abs(l),S=Math.abs(u),y,w,U,L,N,z,W,O,X,Z,q,ut;if(v>=A&&v>=S?(U=c,z=h,X=g,ut=m,c>=0?(y=l,w=u,L=f,N=d,W=_,O=p,Z=x,q=M):(y=u,w=l,L=d,N=f,W=p,O=_,Z=M,q=x)):A>=S?(U=l,z=f,X=_,ut=x,l>=0?(y=u,w=c,L=d,N=h,W=p,O=g,Z=M,q=m):(y=c,w=u,L=h,N=d,W=g,O=p,Z=m,q=M)):(U=u,z=d,X=p,ut=M,u>=0?(y=c,w=l,L=h,N=f,W=g,O=_,Z=m,q=x):(y=l,w=c,L=f,N=h,W=_,O=g,Z=x,q=m)),U===0)return null;let j=y/U,tt=w/U,rt=1/U,dt=L-j*z,ft=N-tt*z,et=W-j*X,_t=O-tt*X,bt=Z-j*ut,Pt=q-tt*ut,Et=bt*_t-Pt*et,Zt=dt*Pt-ft*bt,ue=et*ft-_t*dt;if(s){if(Et<0||Zt<0||ue<0)return null}else if((Et<0||Zt<0||ue<0)&&(Et>0||Zt>0||ue>0))return null;let $t=Et+Zt+ue;if($t===0)return null;let xe=rt*(Et*z+Zt*X+ue*ut);return($t>0?xe<0:xe>0)?null:this.at(xe/$t,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Ds=class extends Ls{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new ee(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Pr,this.combine=lp,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},T0=new Te,so=new sr,su=new Is,A0=new H,ru=new H,ou=new H,au=new H,Xd=new H,lu=new H,R0=new H,cu=new H,ei=class extends pi{constructor(t=new De,e=new Ds){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){lu.set(0,0,0);for(let c=0,l=r.length;c<l;c++){let u=a[c],h=r[c];u!==0&&(Xd.fromBufferAttribute(h,t),o?lu.addScaledVector(Xd,u):lu.addScaledVector(Xd.sub(e),u))}e.add(lu)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),su.copy(i.boundingSphere),su.applyMatrix4(r),so.copy(t.ray).recast(t.near),!(su.containsPoint(so.origin)===!1&&(so.intersectSphere(su,A0)===null||so.origin.distanceToSquared(A0)>(t.far-t.near)**2))&&(T0.copy(r).invert(),so.copy(t.ray).applyMatrix4(T0),!(i.boundingBox!==null&&so.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(t,e,so)))}_computeIntersections(t,e,i){let s,r=this.geometry,o=this.material,a=r.index,c=r.attributes.position,l=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,f=r.groups,d=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,_=f.length;g<_;g++){let p=f[g],m=o[p.materialIndex],x=Math.max(p.start,d.start),M=Math.min(a.count,Math.min(p.start+p.count,d.start+d.count));for(let v=x,A=M;v<A;v+=3){let S=a.getX(v),y=a.getX(v+1),w=a.getX(v+2);s=uu(this,m,t,i,l,u,h,S,y,w),s&&(s.faceIndex=Math.floor(v/3),s.face.materialIndex=p.materialIndex,e.push(s))}}else{let g=Math.max(0,d.start),_=Math.min(a.count,d.start+d.count);for(let p=g,m=_;p<m;p+=3){let x=a.getX(p),M=a.getX(p+1),v=a.getX(p+2);s=uu(this,o,t,i,l,u,h,x,M,v),s&&(s.faceIndex=Math.floor(p/3),e.push(s))}}else if(c!==void 0)if(Array.isArray(o))for(let g=0,_=f.length;g<_;g++){let p=f[g],m=o[p.materialIndex],x=Math.max(p.start,d.start),M=Math.min(c.count,Math.min(p.start+p.count,d.start+d.count));for(let v=x,A=M;v<A;v+=3){let S=v,y=v+1,w=v+2;s=uu(this,m,t,i,l,u,h,S,y,w),s&&(s.faceIndex=Math.floor(v/3),s.face.materialIndex=p.materialIndex,e.push(s))}}else{let g=Math.max(0,d.start),_=Math.min(c.count,d.start+d.count);for(let p=g,m=_;p<m;p+=3){let x=p,M=p+1,v=p+2;s=uu(this,o,t,i,l,u,h,x,M,v),s&&(s.faceIndex=Math.floor(p/3),e.push(s))}}}};function KM(n,t,e,i,s,r,o,a){let c;if(t.side===mi?c=i.intersectTriangle(o,r,s,!0,a):c=i.intersectTriangle(s,r,o,t.side===Br,a),c===null)return null;cu.copy(a),cu.applyMatrix4(n.matrixWorld);let l=e.ray.origin.distanceTo(cu);return l<e.near||l>e.far?null:{distance:l,point:cu.clone(),object:n}}function uu(n,t,e,i,s,r,o,a,c,l){n.getVertexPosition(a,ru),n.getVertexPosition(c,ou),n.getVertexPosition(l,au);let u=KM(n,t,e,i,ru,ou,au,R0);if(u){let h=new H;er.getBarycoord(R0,ru,ou,au,h),s&&(u.uv=er.getInterpolatedAttribute(s,a,c,l,h,new qt)),r&&(u.uv1=er.getInterpolatedAttribute(r,a,c,l,h,new qt)),o&&(u.normal=er.getInterpolatedAttribute(o,a,c,l,h,new H),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let f={a,b:c,c:l,normal:new H,materialIndex:0};er.getNormal(ru,ou,au,f.normal),u.face=f,u.barycoord=h}return u}var Dl=class extends di{constructor(t=null,e=1,i=1,s,r,o,a,c,l=qn,u=qn,h,f){super(null,o,a,c,l,u,s,r,h,f),this.isDataTexture=!0,this.image={data:t,width:e,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var xa=class extends sn{constructor(t,e,i,s=1){super(t,e,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}toJSON(){let t=super.toJSON();return t.meshPerAttribute=this.meshPerAttribute,t.isInstancedBufferAttribute=!0,t}},ra=new Te,C0=new Te,hu=[],P0=new Mi,jM=new Te,pl=new ei,ml=new Is,Nl=class extends ei{constructor(t,e,i){super(t,e),this.isInstancedMesh=!0,this.instanceMatrix=new xa(new Float32Array(i*16),16),this.instanceColor=null,this.morphTexture=null,this.count=i,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<i;s++)this.setMatrixAt(s,jM)}computeBoundingBox(){let t=this.geometry,e=this.count;this.boundingBox===null&&(this.boundingBox=new Mi),t.boundingBox===null&&t.computeBoundingBox(),this.boundingBox.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,ra),P0.copy(t.boundingBox).applyMatrix4(ra),this.boundingBox.union(P0)}computeBoundingSphere(){let t=this.geometry,e=this.count;this.boundingSphere===null&&(this.boundingSphere=new Is),t.boundingSphere===null&&t.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,ra),ml.copy(t.boundingSphere).applyMatrix4(ra),this.boundingSphere.union(ml)}copy(t,e){return super.copy(t,e),this.instanceMatrix.copy(t.instanceMatrix),this.morphTexture=t.morphTexture!==null?t.morphTexture.clone():null,this.instanceColor=t.instanceColor!==null?t.instanceColor.clone():null,this.count=t.count,this.boundingBox=t.boundingBox!==null?t.boundingBox.clone():null,this.boundingSphere=t.boundingSphere!==null?t.boundingSphere.clone():null,this}getColorAt(t,e){return this.instanceColor===null?e.setRGB(1,1,1):e.fromArray(this.instanceColor.array,t*3)}getMatrixAt(t,e){return e.fromArray(this.instanceMatrix.array,t*16)}getMorphAt(t,e){let i=e.morphTargetInfluences,s=this.morphTexture.source.data.data,r=i.length+1,o=t*r+1;for(let a=0;a<i.length;a++)i[a]=s[o+a]}raycast(t,e){let i=this.matrixWorld,s=this.count;if(pl.geometry=this.geometry,pl.material=this.material,pl.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),ml.copy(this.boundingSphere),ml.applyMatrix4(i),t.ray.intersectsSphere(ml)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,ra),C0.multiplyMatrices(i,ra),pl.matrixWorld=C0,pl.raycast(t,hu);for(let o=0,a=hu.length;o<a;o++){let c=hu[o];c.instanceId=r,c.object=this,e.push(c)}hu.length=0}}setColorAt(t,e){return this.instanceColor===null&&(this.instanceColor=new xa(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),e.toArray(this.instanceColor.array,t*3),this}setMatrixAt(t,e){return e.toArray(this.instanceMatrix.array,t*16),this}setMorphAt(t,e){let i=e.morphTargetInfluences,s=i.length+1;this.morphTexture===null&&(this.morphTexture=new Dl(new Float32Array(s*this.count),s,this.count,oh,Ki));let r=this.morphTexture.source.data.data,o=0;for(let l=0;l<i.length;l++)o+=i[l];let a=this.geometry.morphTargetsRelative?1:1-o,c=s*t;return r[c]=a,r.set(i,c+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},ro=new Is,QM=new qt(.5,.5),fu=new H,oo=class{constructor(t=new Zn,e=new Zn,i=new Zn,s=new Zn,r=new Zn,o=new Zn){this.planes=[t,e,i,s,r,o]}set(t,e,i,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let i=0;i<6;i++)e[i].copy(t.planes[i]);return this}setFromProjectionMatrix(t,e=Yi,i=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],c=r[2],l=r[3],u=r[4],h=r[5],f=r[6],d=r[7],g=r[8],_=r[9],p=r[10],m=r[11],x=r[12],M=r[13],v=r[14],A=r[15];if(s[0].setComponents(l-o,d-u,m-g,A-x).normalize(),s[1].setComponents(l+o,d+u,m+g,A+x).normalize(),s[2].setComponents(l+a,d+h,m+_,A+M).normalize(),s[3].setComponents(l-a,d-h,m-_,A-M).normalize(),i)s[4].setComponents(c,f,p,v).normalize(),s[5].setComponents(l-c,d-f,m-p,A-v).normalize();else if(s[4].setComponents(l-c,d-f,m-p,A-v).normalize(),e===Yi)s[5].setComponents(l+c,d+f,m+p,A+v).normalize();else if(e===Sl)s[5].setComponents(c,f,p,v).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),ro.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),ro.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(ro)}intersectsSprite(t){ro.center.set(0,0,0);let e=QM.distanceTo(t.center);return ro.radius=.7071067811865476+e,ro.applyMatrix4(t.matrixWorld),this.intersectsSphere(ro)}intersectsSphere(t){let e=this.planes,i=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let i=0;i<6;i++){let s=e[i];if(fu.x=s.normal.x>0?t.max.x:t.min.x,fu.y=s.normal.y>0?t.max.y:t.min.y,fu.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(fu)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let i=0;i<6;i++)if(e[i].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},I0=new Te,Uu=class n{constructor(){this.coordinateSystem=Yi,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,i=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];I0.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new oo),i[s].setFromProjectionMatrix(I0,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,i=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new oo),e[s].copy(i[s]);return this._count=t._count,this}clone(){return new n().copy(this)}};var rr=class extends Ls{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new ee(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},Fu=new H,Ou=new H,L0=new Te,gl=new sr,du=new Is,$d=new H,D0=new H,ya=class extends pi{constructor(t=new De,e=new rr){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[0];for(let s=1,r=e.count;s<r;s++)Fu.fromBufferAttribute(e,s-1),Ou.fromBufferAttribute(e,s),i[s]=i[s-1],i[s]+=Fu.distanceTo(Ou);t.setAttribute("lineDistance",new Ce(i,1))}else jt("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),du.copy(i.boundingSphere),du.applyMatrix4(s),du.radius+=r,t.ray.intersectsSphere(du)===!1)return;L0.copy(s).invert(),gl.copy(t.ray).applyMatrix4(L0);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),c=a*a,l=this.isLineSegments?2:1,u=i.index,f=i.attributes.position;if(u!==null){let d=Math.max(0,o.start),g=Math.min(u.count,o.start+o.count);for(let _=d,p=g-1;_<p;_+=l){let m=u.getX(_),x=u.getX(_+1),M=pu(this,t,gl,c,m,x,_);M&&e.push(M)}if(this.isLineLoop){let _=u.getX(g-1),p=u.getX(d),m=pu(this,t,gl,c,_,p,g-1);m&&e.push(m)}}else{let d=Math.max(0,o.start),g=Math.min(f.count,o.start+o.count);for(let _=d,p=g-1;_<p;_+=l){let m=pu(this,t,gl,c,_,_+1,_);m&&e.push(m)}if(this.isLineLoop){let _=pu(this,t,gl,c,g-1,d,g-1);_&&e.push(_)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function pu(n,t,e,i,s,r,o){let a=n.geometry.attributes.position;if(Fu.fromBufferAttribute(a,s),Ou.fromBufferAttribute(a,r),e.distanceSqToSegment(Fu,Ou,$d,D0)>i)return;$d.applyMatrix4(n.matrixWorld);let l=t.ray.origin.distanceTo($d);if(!(l<t.near||l>t.far))return{distance:l,point:D0.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var N0=new H,U0=new H,ao=class extends ya{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[];for(let s=0,r=e.count;s<r;s+=2)N0.fromBufferAttribute(e,s),U0.fromBufferAttribute(e,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+N0.distanceTo(U0);t.setAttribute("lineDistance",new Ce(i,1))}else jt("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var Ir=class extends Ls{constructor(t){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new ee(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.size=t.size,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},F0=new Te,jd=new sr,mu=new Is,gu=new H,lo=class extends pi{constructor(t=new De,e=new Ir){super(),this.isPoints=!0,this.type="Points",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Points.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),mu.copy(i.boundingSphere),mu.applyMatrix4(s),mu.radius+=r,t.ray.intersectsSphere(mu)===!1)return;F0.copy(s).invert(),jd.copy(t.ray).applyMatrix4(F0);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),c=a*a,l=i.index,h=i.attributes.position;if(l!==null){let f=Math.max(0,o.start),d=Math.min(l.count,o.start+o.count);for(let g=f,_=d;g<_;g++){let p=l.getX(g);gu.fromBufferAttribute(h,p),O0(gu,p,c,s,t,e,this)}}else{let f=Math.max(0,o.start),d=Math.min(h.count,o.start+o.count);for(let g=f,_=d;g<_;g++)gu.fromBufferAttribute(h,g),O0(gu,g,c,s,t,e,this)}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function O0(n,t,e,i,s,r,o){let a=jd.distanceSqToPoint(n);if(a<e){let c=new H;jd.closestPointToPoint(n,c),c.applyMatrix4(i);let l=s.ray.origin.distanceTo(c);if(l<s.near||l>s.far)return;r.push({distance:l,distanceToRay:Math.sqrt(a),point:c,index:t,face:null,faceIndex:null,barycoord:null,object:o})}}var Ul=class extends di{constructor(t=[],e=po,i,s,r,o,a,c,l,u){super(t,e,i,s,r,o,a,c,l,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}},Fl=class extends di{constructor(t,e,i,s,r,o,a,c,l){super(t,e,i,s,r,o,a,c,l),this.isCanvasTexture=!0,this.needsUpdate=!0}};var or=class extends di{constructor(t,e,i=us,s,r,o,a=qn,c=qn,l,u=ir,h=1){if(u!==ir&&u!==lr)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let f={width:t,height:e,depth:h};super(f,s,r,o,a,c,u,i,l),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new da(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},Ol=class extends or{constructor(t,e=us,i=po,s,r,o=qn,a=qn,c,l=ir){let u={width:t,height:t,depth:1},h=[u,u,u,u,u,u];super(t,t,e,i,s,r,o,a,c,l),this.image=h,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},Bl=class extends di{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},Lr=class n extends De{constructor(t=1,e=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let c=[],l=[],u=[],h=[],f=0,d=0;g("z","y","x",-1,-1,i,e,t,o,r,0),g("z","y","x",1,-1,i,e,-t,o,r,1),g("x","z","y",1,1,t,i,e,s,o,2),g("x","z","y",1,-1,t,i,-e,s,o,3),g("x","y","z",1,-1,t,e,i,s,r,4),g("x","y","z",-1,-1,t,e,-i,s,r,5),this.setIndex(c),this.setAttribute("position",new Ce(l,3)),this.setAttribute("normal",new Ce(u,3)),this.setAttribute("uv",new Ce(h,2));function g(_,p,m,x,M,v,A,S,y,w,U){let L=v/y,N=A/w,z=v/2,W=A/2,O=S/2,X=y+1,Z=w+1,q=0,ut=0,j=new H;for(let tt=0;tt<Z;tt++){let rt=tt*N-W;for(let dt=0;dt<X;dt++){let ft=dt*L-z;j[_]=ft*x,j[p]=rt*M,j[m]=O,l.push(j.x,j.y,j.z),j[_]=0,j[p]=0,j[m]=S>0?1:-1,u.push(j.x,j.y,j.z),h.push(dt/y),h.push(1-tt/w),q+=1}}for(let tt=0;tt<w;tt++)for(let rt=0;rt<y;rt++){let dt=f+rt+X*tt,ft=f+rt+X*(tt+1),et=f+(rt+1)+X*(tt+1),_t=f+(rt+1)+X*tt;c.push(dt,ft,_t),c.push(ft,et,_t),ut+=6}a.addGroup(d,ut,U),d+=ut,f+=q}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var cs=class n extends De{constructor(t=1,e=1,i=1,s=32,r=1,o=!1,a=0,c=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:c};let l=this;s=Math.floor(s),r=Math.floor(r);let u=[],h=[],f=[],d=[],g=0,_=[],p=i/2,m=0;x(),o===!1&&(t>0&&M(!0),e>0&&M(!1)),this.setIndex(u),this.setAttribute("position",new Ce(h,3)),this.setAttribute("normal",new Ce(f,3)),this.setAttribute("uv",new Ce(d,2));function x(){let v=new H,A=new H,S=0,y=(e-t)/i;for(let w=0;w<=r;w++){let U=[],L=w/r,N=L*(e-t)+t;for(let z=0;z<=s;z++){let W=z/s,O=W*c+a,X=Math.sin(O),Z=Math.cos(O);A.x=N*X,A.y=-L*i+p,A.z=N*Z,h.push(A.x,A.y,A.z),v.set(X,y,Z).normalize(),f.push(v.x,v.y,v.z),d.push(W,1-L),U.push(g++)}_.push(U)}for(let w=0;w<s;w++)for(let U=0;U<r;U++){let L=_[U][w],N=_[U+1][w],z=_[U+1][w+1],W=_[U][w+1];(t>0||U!==0)&&(u.push(L,N,W),S+=3),(e>0||U!==r-1)&&(u.push(N,z,W),S+=3)}l.addGroup(m,S,0),m+=S}function M(v){let A=g,S=new qt,y=new H,w=0,U=v===!0?t:e,L=v===!0?1:-1;for(let z=1;z<=s;z++)h.push(0,p*L,0),f.push(0,L,0),d.push(.5,.5),g++;let N=g;for(let z=0;z<=s;z++){let O=z/s*c+a,X=Math.cos(O),Z=Math.sin(O);y.x=U*Z,y.y=p*L,y.z=U*X,h.push(y.x,y.y,y.z),f.push(0,L,0),S.x=X*.5+.5,S.y=Z*.5*L+.5,d.push(S.x,S.y),g++}for(let z=0;z<s;z++){let W=A+z,O=N+z;v===!0?u.push(O,O+1,W):u.push(O+1,O,W),w+=3}l.addGroup(m,w,v===!0?1:2),m+=w}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},co=class n extends cs{constructor(t=1,e=1,i=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,t,e,i,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:i,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(t){return new n(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},Bu=class n extends De{constructor(t=[],e=[],i=1,s=0){super(),this.type="PolyhedronGeometry",this.parameters={vertices:t,indices:e,radius:i,detail:s};let r=[],o=[];a(s),l(i),u(),this.setAttribute("position",new Ce(r,3)),this.setAttribute("normal",new Ce(r.slice(),3)),this.setAttribute("uv",new Ce(o,2)),s===0?this.computeVertexNormals():this.normalizeNormals();function a(x){let M=new H,v=new H,A=new H;for(let S=0;S<e.length;S+=3)d(e[S+0],M),d(e[S+1],v),d(e[S+2],A),c(M,v,A,x)}function c(x,M,v,A){let S=A+1,y=[];for(let w=0;w<=S;w++){y[w]=[];let U=x.clone().lerp(v,w/S),L=M.clone().lerp(v,w/S),N=S-w;for(let z=0;z<=N;z++)z===0&&w===S?y[w][z]=U:y[w][z]=U.clone().lerp(L,z/N)}for(let w=0;w<S;w++)for(let U=0;U<2*(S-w)-1;U++){let L=Math.floor(U/2);U%2===0?(f(y[w][L+1]),f(y[w+1][L]),f(y[w][L])):(f(y[w][L+1]),f(y[w+1][L+1]),f(y[w+1][L]))}}function l(x){let M=new H;for(let v=0;v<r.length;v+=3)M.x=r[v+0],M.y=r[v+1],M.z=r[v+2],M.normalize().multiplyScalar(x),r[v+0]=M.x,r[v+1]=M.y,r[v+2]=M.z}function u(){let x=new H;for(let M=0;M<r.length;M+=3){x.x=r[M+0],x.y=r[M+1],x.z=r[M+2];let v=p(x)/2/Math.PI+.5,A=m(x)/Math.PI+.5;o.push(v,1-A)}g(),h()}function h(){for(let x=0;x<o.length;x+=6){let M=o[x+0],v=o[x+2],A=o[x+4],S=Math.max(M,v,A),y=Math.min(M,v,A);S>.9&&y<.1&&(M<.2&&(o[x+0]+=1),v<.2&&(o[x+2]+=1),A<.2&&(o[x+4]+=1))}}function f(x){r.push(x.x,x.y,x.z)}function d(x,M){let v=x*3;M.x=t[v+0],M.y=t[v+1],M.z=t[v+2]}function g(){let x=new H,M=new H,v=new H,A=new H,S=new qt,y=new qt,w=new qt;for(let U=0,L=0;U<r.length;U+=9,L+=6){x.set(r[U+0],r[U+1],r[U+2]),M.set(r[U+3],r[U+4],r[U+5]),v.set(r[U+6],r[U+7],r[U+8]),S.set(o[L+0],o[L+1]),y.set(o[L+2],o[L+3]),w.set(o[L+4],o[L+5]),A.copy(x).add(M).add(v).divideScalar(3);let N=p(A);_(S,L+0,x,N),_(y,L+2,M,N),_(w,L+4,v,N)}}function _(x,M,v,A){A<0&&x.x===1&&(o[M]=x.x-1),v.x===0&&v.z===0&&(o[M]=A/2/Math.PI+.5)}function p(x){return Math.atan2(x.z,-x.x)}function m(x){return Math.atan2(-x.y,Math.sqrt(x.x*x.x+x.z*x.z))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.vertices,t.indices,t.radius,t.detail)}};var kl=class n extends De{constructor(t=[new qt(0,-.5),new qt(.5,0),new qt(0,.5)],e=12,i=0,s=Math.PI*2){super(),this.type="LatheGeometry",this.parameters={points:t,segments:e,phiStart:i,phiLength:s},e=Math.floor(e),s=ve(s,0,Math.PI*2);let r=[],o=[],a=[],c=[],l=[],u=1/e,h=new H,f=new qt,d=new H,g=new H,_=new H,p=0,m=0;for(let x=0;x<=t.length-1;x++)switch(x){case 0:p=t[x+1].x-t[x].x,m=t[x+1].y-t[x].y,d.x=m*1,d.y=-p,d.z=m*0,_.copy(d),d.normalize(),c.push(d.x,d.y,d.z);break;case t.length-1:_.normalize(),c.push(_.x,_.y,_.z);break;default:p=t[x+1].x-t[x].x,m=t[x+1].y-t[x].y,d.x=m*1,d.y=-p,d.z=m*0,g.copy(d),d.x+=_.x,d.y+=_.y,d.z+=_.z,d.normalize(),c.push(d.x,d.y,d.z),_.copy(g)}for(let x=0;x<=e;x++){let M=i+x*u*s,v=Math.sin(M),A=Math.cos(M);for(let S=0;S<=t.length-1;S++){h.x=t[S].x*v,h.y=t[S].y,h.z=t[S].x*A,o.push(h.x,h.y,h.z),f.x=x/e,f.y=S/(t.length-1),a.push(f.x,f.y);let y=c[3*S+0]*v,w=c[3*S+1],U=c[3*S+0]*A;l.push(y,w,U)}}for(let x=0;x<e;x++)for(let M=0;M<t.length-1;M++){let v=M+x*t.length,A=v,S=v+t.length,y=v+t.length+1,w=v+1;r.push(A,S,w),r.push(y,w,S)}this.setIndex(r),this.setAttribute("position",new Ce(o,3)),this.setAttribute("uv",new Ce(a,2)),this.setAttribute("normal",new Ce(l,3))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.points,t.segments,t.phiStart,t.phiLength)}},zl=class n extends Bu{constructor(t=1,e=0){let i=[1,0,0,-1,0,0,0,1,0,0,-1,0,0,0,1,0,0,-1],s=[0,2,4,0,4,3,0,3,5,0,5,2,1,2,5,1,5,3,1,3,4,1,4,2];super(i,s,t,e),this.type="OctahedronGeometry",this.parameters={radius:t,detail:e}}static fromJSON(t){return new n(t.radius,t.detail)}},Hl=class n extends De{constructor(t=1,e=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:i,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(i),c=Math.floor(s),l=a+1,u=c+1,h=t/a,f=e/c,d=[],g=[],_=[],p=[];for(let m=0;m<u;m++){let x=m*f-o;for(let M=0;M<l;M++){let v=M*h-r;g.push(v,-x,0),_.push(0,0,1),p.push(M/a),p.push(1-m/c)}}for(let m=0;m<c;m++)for(let x=0;x<a;x++){let M=x+l*m,v=x+l*(m+1),A=x+1+l*(m+1),S=x+1+l*m;d.push(M,v,S),d.push(v,A,S)}this.setIndex(d),this.setAttribute("position",new Ce(g,3)),this.setAttribute("normal",new Ce(_,3)),this.setAttribute("uv",new Ce(p,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.widthSegments,t.heightSegments)}};var uo=class n extends De{constructor(t=1,e=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),i=Math.max(2,Math.floor(i));let c=Math.min(o+a,Math.PI),l=0,u=[],h=new H,f=new H,d=[],g=[],_=[],p=[];for(let m=0;m<=i;m++){let x=[],M=m/i,v=o+M*a,A=t*Math.cos(v),S=Math.sqrt(t*t-A*A),y=0;m===0&&o===0?y=.5/e:m===i&&c===Math.PI&&(y=-.5/e);for(let w=0;w<=e;w++){let U=w/e,L=s+U*r;h.x=-S*Math.cos(L),h.y=A,h.z=S*Math.sin(L),g.push(h.x,h.y,h.z),f.copy(h).normalize(),_.push(f.x,f.y,f.z),p.push(U+y,1-M),x.push(l++)}u.push(x)}for(let m=0;m<i;m++)for(let x=0;x<e;x++){let M=u[m][x+1],v=u[m][x],A=u[m+1][x],S=u[m+1][x+1];(m!==0||o>0)&&d.push(M,v,S),(m!==i-1||c<Math.PI)&&d.push(v,A,S)}this.setIndex(d),this.setAttribute("position",new Ce(g,3)),this.setAttribute("normal",new Ce(_,3)),this.setAttribute("uv",new Ce(p,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};var va=class n extends De{constructor(t=1,e=.4,i=12,s=48,r=Math.PI*2,o=0,a=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:t,tube:e,radialSegments:i,tubularSegments:s,arc:r,thetaStart:o,thetaLength:a},i=Math.floor(i),s=Math.floor(s);let c=[],l=[],u=[],h=[],f=new H,d=new H,g=new H;for(let _=0;_<=i;_++){let p=o+_/i*a;for(let m=0;m<=s;m++){let x=m/s*r;d.x=(t+e*Math.cos(p))*Math.cos(x),d.y=(t+e*Math.cos(p))*Math.sin(x),d.z=e*Math.sin(p),l.push(d.x,d.y,d.z),f.x=t*Math.cos(x),f.y=t*Math.sin(x),g.subVectors(d,f).normalize(),u.push(g.x,g.y,g.z),h.push(m/s),h.push(_/i)}}for(let _=1;_<=i;_++)for(let p=1;p<=s;p++){let m=(s+1)*_+p-1,x=(s+1)*(_-1)+p-1,M=(s+1)*(_-1)+p,v=(s+1)*_+p;c.push(m,x,v),c.push(x,M,v)}this.setIndex(c),this.setAttribute("position",new Ce(l,3)),this.setAttribute("normal",new Ce(u,3)),this.setAttribute("uv",new Ce(h,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.tube,t.radialSegments,t.tubularSegments,t.arc,t.thetaStart,t.thetaLength)}};function go(n){let t={};for(let e in n){t[e]={};for(let i in n[e]){let s=n[e][i];if(B0(s))s.isRenderTargetTexture?(jt("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][i]=null):t[e][i]=s.clone();else if(Array.isArray(s))if(B0(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][i]=r}else t[e][i]=s.slice();else t[e][i]=s}}return t}function ni(n){let t={};for(let e=0;e<n.length;e++){let i=go(n[e]);for(let s in i)t[s]=i[s]}return t}function B0(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function tS(n){let t=[];for(let e=0;e<n.length;e++)t.push(n[e].clone());return t}function Up(n){let t=n.getRenderTarget();return t===null?n.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:Ee.workingColorSpace}var C_={clone:go,merge:ni},eS=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,nS=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Zi=class extends Ls{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=eS,this.fragmentShader=nS,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=go(t.uniforms),this.uniformsGroups=tS(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(e.extensions=i),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let i in t.uniforms){let s=t.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=e[s.value]||null;break;case"c":this.uniforms[i].value=new ee().setHex(s.value);break;case"v2":this.uniforms[i].value=new qt().fromArray(s.value);break;case"v3":this.uniforms[i].value=new H().fromArray(s.value);break;case"v4":this.uniforms[i].value=new hn().fromArray(s.value);break;case"m3":this.uniforms[i].value=new ae().fromArray(s.value);break;case"m4":this.uniforms[i].value=new Te().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let i in t.extensions)this.extensions[i]=t.extensions[i];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},ku=class extends Zi{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var zu=class extends Ls{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=m_,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},Hu=class extends Ls{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function oa(n,t){return!n||n.constructor===t?n:typeof t.BYTES_PER_ELEMENT=="number"?new t(n):Array.prototype.slice.call(n)}function _u(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var Dr=class{constructor(t,e,i,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(i),this.sampleValues=e,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,i=this._cachedIndex,s=e[i],r=e[i-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=i+2;;){if(s===void 0){if(t<r)break i;return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=e[++i],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(i=2,r=a);for(let c=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===c)break;if(s=r,r=e[--i-1],t>=r)break t}o=i,i=0;break e}break n}for(;i<o;){let a=i+o>>>1;t<e[a]?o=a:i=a+1}if(s=e[i],r=e[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=i[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Gu=class extends Dr{constructor(t,e,i,s){super(t,e,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Zd,endingEnd:Zd}}intervalChanged_(t,e,i){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],c=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Jd:r=t,a=2*e-i;break;case Kd:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=i}if(c===void 0)switch(this.getSettings_().endingEnd){case Jd:o=t,c=2*i-e;break;case Kd:o=1,c=i+s[1]-s[0];break;default:o=t-1,c=e}let l=(i-e)*.5,u=this.valueSize;this._weightPrev=l/(e-a),this._weightNext=l/(c-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=t*a,l=c-a,u=this._offsetPrev,h=this._offsetNext,f=this._weightPrev,d=this._weightNext,g=(i-e)/(s-e),_=g*g,p=_*g,m=-f*p+2*f*_-f*g,x=(1+f)*p+(-1.5-2*f)*_+(-.5+f)*g+1,M=(-1-d)*p+(1.5+d)*_+.5*g,v=d*p-d*_;for(let A=0;A!==a;++A)r[A]=m*o[u+A]+x*o[l+A]+M*o[c+A]+v*o[h+A];return r}},Vu=class extends Dr{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=t*a,l=c-a,u=(i-e)/(s-e),h=1-u;for(let f=0;f!==a;++f)r[f]=o[l+f]*h+o[c+f]*u;return r}},Wu=class extends Dr{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t){return this.copySampleValue_(t-1)}},qu=class extends Dr{interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=t*a,l=c-a,u=this.inTangents,h=this.outTangents;if(!u||!h){let g=(i-e)/(s-e),_=1-g;for(let p=0;p!==a;++p)r[p]=o[l+p]*_+o[c+p]*g;return r}let f=a*2,d=t-1;for(let g=0;g!==a;++g){let _=o[l+g],p=o[c+g],m=d*f+g*2,x=h[m],M=h[m+1],v=t*f+g*2,A=u[v],S=u[v+1],y=sS(i,e,x,A,s);r[g]=P_(y,_,M,S,p)}return r}};function P_(n,t,e,i,s){let r=1-n;return r*r*r*t+3*r*r*n*e+3*r*n*n*i+n*n*n*s}function iS(n,t,e,i,s){let r=1-n;return 3*r*r*(e-t)+6*r*n*(i-e)+3*n*n*(s-i)}function sS(n,t,e,i,s){let r=(n-t)/(s-t);for(let o=0;o<8;o++){let a=P_(r,t,e,i,s)-n;if(Math.abs(a)<1e-10)break;let c=iS(r,t,e,i,s);if(Math.abs(c)<1e-10)break;r=Math.max(0,Math.min(1,r-a/c))}return r}var Oi=class{constructor(t,e,i,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=oa(e,this.TimeBufferType),this.values=oa(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,i;if(e.toJSON!==this.toJSON)i=e.toJSON(t);else{i={name:t.name,times:oa(t.times,Array),values:oa(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(i.interpolation=s),_u(t.settings)&&(i.settings={inTangents:oa(t.settings.inTangents,Array),outTangents:oa(t.settings.outTangents,Array)})}return i.type=t.ValueTypeName,i}InterpolantFactoryMethodDiscrete(t){return new Wu(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new Vu(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new Gu(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new qu(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case vl:e=this.InterpolantFactoryMethodDiscrete;break;case Iu:e=this.InterpolantFactoryMethodLinear;break;case vu:e=this.InterpolantFactoryMethodSmooth;break;case Yd:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return jt("KeyframeTrack:",i),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return vl;case this.InterpolantFactoryMethodLinear:return Iu;case this.InterpolantFactoryMethodSmooth:return vu;case this.InterpolantFactoryMethodBezier:return Yd}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]+=t;_u(this.settings)&&(k0(this.settings.inTangents,t),k0(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]*=t;_u(this.settings)&&(z0(this.settings.inTangents,t),z0(this.settings.outTangents,t))}return this}trim(t,e){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<t;)++r;for(;o!==-1&&i[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(ie("KeyframeTrack: Invalid value size in track.",this),t=!1);let i=this.times,s=this.values,r=i.length;r===0&&(ie("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let c=i[a];if(typeof c=="number"&&isNaN(c)){ie("KeyframeTrack: Time is not a valid number.",this,a,c),t=!1;break}if(o!==null&&o>c){ie("KeyframeTrack: Out of order keys.",this,a,c,o),t=!1;break}o=c}if(s!==void 0&&yM(s))for(let a=0,c=s.length;a!==c;++a){let l=s[a];if(isNaN(l)){ie("KeyframeTrack: Value is not a valid number.",this,a,l),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===vu,r=t.length-1,o=1;for(let a=1;a<r;++a){let c=!1,l=t[a],u=t[a+1];if(l!==u&&(a!==1||l!==t[0]))if(s)c=!0;else{let h=a*i,f=h-i,d=h+i;for(let g=0;g!==i;++g){let _=e[h+g];if(_!==e[f+g]||_!==e[d+g]){c=!0;break}}}if(c){if(a!==o){t[o]=t[a];let h=a*i,f=o*i;for(let d=0;d!==i;++d)e[f+d]=e[h+d]}++o}}if(r>0){t[o]=t[r];for(let a=r*i,c=o*i,l=0;l!==i;++l)e[c+l]=e[a+l];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*i)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),i=this.constructor,s=new i(this.name,t,e);return s.createInterpolant=this.createInterpolant,_u(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function k0(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]+=t}function z0(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]*=t}Oi.prototype.ValueTypeName="";Oi.prototype.TimeBufferType=Float32Array;Oi.prototype.ValueBufferType=Float32Array;Oi.prototype.DefaultInterpolation=Iu;var Nr=class extends Oi{constructor(t,e,i){super(t,e,i)}};Nr.prototype.ValueTypeName="bool";Nr.prototype.ValueBufferType=Array;Nr.prototype.DefaultInterpolation=vl;Nr.prototype.InterpolantFactoryMethodLinear=void 0;Nr.prototype.InterpolantFactoryMethodSmooth=void 0;var Xu=class extends Oi{constructor(t,e,i,s){super(t,e,i,s)}};Xu.prototype.ValueTypeName="color";var $u=class extends Oi{constructor(t,e,i,s){super(t,e,i,s)}};$u.prototype.ValueTypeName="number";var Yu=class extends Dr{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=(i-e)/(s-e),l=t*a;for(let u=l+a;l!==u;l+=4)un.slerpFlat(r,0,o,l-a,o,l,c);return r}},Gl=class extends Oi{constructor(t,e,i,s){super(t,e,i,s)}InterpolantFactoryMethodLinear(t){return new Yu(this.times,this.values,this.getValueSize(),t)}};Gl.prototype.ValueTypeName="quaternion";Gl.prototype.InterpolantFactoryMethodSmooth=void 0;var Ur=class extends Oi{constructor(t,e,i){super(t,e,i)}};Ur.prototype.ValueTypeName="string";Ur.prototype.ValueBufferType=Array;Ur.prototype.DefaultInterpolation=vl;Ur.prototype.InterpolantFactoryMethodLinear=void 0;Ur.prototype.InterpolantFactoryMethodSmooth=void 0;var Zu=class extends Oi{constructor(t,e,i,s){super(t,e,i,s)}};Zu.prototype.ValueTypeName="vector";var Ju=class{constructor(t,e,i){let s=this,r=!1,o=0,a=0,c,l=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),c?c(u):u},this.setURLModifier=function(u){return c=u,this},this.addHandler=function(u,h){return l.push(u,h),this},this.removeHandler=function(u){let h=l.indexOf(u);return h!==-1&&l.splice(h,2),this},this.getHandler=function(u){for(let h=0,f=l.length;h<f;h+=2){let d=l[h],g=l[h+1];if(d.global&&(d.lastIndex=0),d.test(u))return g}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},I_=new Ju,Ku=class{constructor(t){this.manager=t!==void 0?t:I_,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let i=this;return new Promise(function(s,r){i.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};Ku.DEFAULT_MATERIAL_NAME="__DEFAULT";var xu=new H,yu=new un,Cs=new H,Vl=class extends pi{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Te,this.projectionMatrix=new Te,this.projectionMatrixInverse=new Te,this.coordinateSystem=Yi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(xu,yu,Cs),Cs.x===1&&Cs.y===1&&Cs.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(xu,yu,Cs.set(1,1,1)).invert()}updateWorldMatrix(t,e,i=!1){super.updateWorldMatrix(t,e,i),this.matrixWorld.decompose(xu,yu,Cs),Cs.x===1&&Cs.y===1&&Cs.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(xu,yu,Cs.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Cr=new H,H0=new qt,G0=new qt,hi=class extends Vl{constructor(t=50,e=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=fa*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(xl*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return fa*2*Math.atan(Math.tan(xl*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,i){Cr.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(Cr.x,Cr.y).multiplyScalar(-t/Cr.z),Cr.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(Cr.x,Cr.y).multiplyScalar(-t/Cr.z)}getViewSize(t,e){return this.getViewBounds(t,H0,G0),e.subVectors(G0,H0)}setViewOffset(t,e,i,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(xl*.5*this.fov)/this.zoom,i=2*e,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let c=o.fullWidth,l=o.fullHeight;r+=o.offsetX*s/c,e-=o.offsetY*i/l,s*=o.width/c,i*=o.height/l}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-i,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var ju=class extends Vl{constructor(t=-1,e=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-t,o=i+t,a=s+e,c=s-e;if(this.view!==null&&this.view.enabled){let l=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=l*this.view.offsetX,o=r+l*this.view.width,a-=u*this.view.offsetY,c=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,c,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}};var aa=-90,la=1,ba=class extends pi{constructor(t,e,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new hi(aa,la,t,e);s.layers=this.layers,this.add(s);let r=new hi(aa,la,t,e);r.layers=this.layers,this.add(r);let o=new hi(aa,la,t,e);o.layers=this.layers,this.add(o);let a=new hi(aa,la,t,e);a.layers=this.layers,this.add(a);let c=new hi(aa,la,t,e);c.layers=this.layers,this.add(c);let l=new hi(aa,la,t,e);l.layers=this.layers,this.add(l)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[i,s,r,o,a,c]=e;for(let l of e)this.remove(l);if(t===Yi)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),c.up.set(0,1,0),c.lookAt(0,0,-1);else if(t===Sl)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),c.up.set(0,-1,0),c.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let l of e)this.add(l),l.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,c,l,u]=this.children,h=t.getRenderTarget(),f=t.getActiveCubeFace(),d=t.getActiveMipmapLevel(),g=t.xr.enabled;t.xr.enabled=!1;let _=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let p=!1;t.isWebGLRenderer===!0?p=t.state.buffers.depth.getReversed():p=t.reversedDepthBuffer,t.setRenderTarget(i,0,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(i,1,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(i,2,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(i,3,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),t.setRenderTarget(i,4,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),i.texture.mipmapsAutoUpdate=_,t.setRenderTarget(i,5,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,u),t.setRenderTarget(h,f,d),t.xr.enabled=g,i.texture.needsPMREMUpdate=!0}},Qu=class extends hi{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var Fp="\\[\\]\\.:\\/",rS=new RegExp("["+Fp+"]","g"),Op="[^"+Fp+"]",oS="[^"+Fp.replace("\\.","")+"]",aS=/((?:WC+[\/:])*)/.source.replace("WC",Op),lS=/(WCOD+)?/.source.replace("WCOD",oS),cS=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Op),uS=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Op),hS=new RegExp("^"+aS+lS+cS+uS+"$"),fS=["material","materials","bones","map"],Qd=class{constructor(t,e,i){let s=i||nn.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(t,e)}setValue(t,e){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].unbind()}},nn=class n{constructor(t,e,i){this.path=e,this.parsedPath=i||n.parseTrackName(e),this.node=n.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,i){return t&&t.isAnimationObjectGroup?new n.Composite(t,e,i):new n(t,e,i)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(rS,"")}static parseTrackName(t){let e=hS.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let i={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);fS.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return i}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let i=t.skeleton.getBoneByName(e);if(i!==void 0)return i}if(t.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let c=i(a.children);if(c)return c}return null},s=i(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)t[e++]=i[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,i=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=n.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){jt("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let l=e.objectIndex;switch(i){case"materials":if(!t.material){ie("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){ie("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){ie("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let u=0;u<t.length;u++)if(t[u].name===l){l=u;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){ie("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){ie("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[i]===void 0){ie("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[i]}if(l!==void 0){if(t[l]===void 0){ie("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[l]}}let o=t[s];if(o===void 0){let l=e.nodeName;ie("PropertyBinding: Trying to update property for track: "+l+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let c=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){ie("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){ie("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}c=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(c=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(c=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[c],this.setValue=this.SetterByBindingTypeAndVersioning[c][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};nn.Composite=Qd;nn.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};nn.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};nn.prototype.GetterByBindingType=[nn.prototype._getValue_direct,nn.prototype._getValue_array,nn.prototype._getValue_arrayElement,nn.prototype._getValue_toArray];nn.prototype.SetterByBindingTypeAndVersioning=[[nn.prototype._setValue_direct,nn.prototype._setValue_direct_setNeedsUpdate,nn.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[nn.prototype._setValue_array,nn.prototype._setValue_array_setNeedsUpdate,nn.prototype._setValue_array_setMatrixWorldNeedsUpdate],[nn.prototype._setValue_arrayElement,nn.prototype._setValue_arrayElement_setNeedsUpdate,nn.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[nn.prototype._setValue_fromArray,nn.prototype._setValue_fromArray_setNeedsUpdate,nn.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var vI=new Float32Array(1);var V0=new Te,Wl=class{constructor(t,e,i=0,s=1/0){this.ray=new sr(t,e),this.near=i,this.far=s,this.camera=null,this.layers=new pa,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(t,e){this.ray.set(t,e)}setFromCamera(t,e){e.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(t.x,t.y,.5).unproject(e).sub(this.ray.origin).normalize(),this.camera=e):e.isOrthographicCamera?(this.ray.origin.set(t.x,t.y,e.projectionMatrix.elements[14]).unproject(e),this.ray.direction.set(0,0,-1).transformDirection(e.matrixWorld),this.camera=e):ie("Raycaster: Unsupported camera type: "+e.type)}setFromXRController(t){return V0.identity().extractRotation(t.matrixWorld),this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(V0),this}intersectObject(t,e=!0,i=[]){return tp(t,this,i,e),i.sort(W0),i}intersectObjects(t,e=!0,i=[]){for(let s=0,r=t.length;s<r;s++)tp(t[s],this,i,e);return i.sort(W0),i}};function W0(n,t){return n.distance-t.distance}function tp(n,t,e,i){let s=!0;if(n.layers.test(t.layers)&&n.raycast(t,e)===!1&&(s=!1),s===!0&&i===!0){let r=n.children;for(let o=0,a=r.length;o<a;o++)tp(r[o],t,e,!0)}}var Ma=class{constructor(t=1,e=0,i=0){this.radius=t,this.phi=e,this.theta=i}set(t,e,i){return this.radius=t,this.phi=e,this.theta=i,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=ve(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,i){return this.radius=Math.sqrt(t*t+e*e+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,i),this.phi=Math.acos(ve(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var ep=class{static{this.prototype.isMatrix2=!0}constructor(t,e,i,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let i=0;i<4;i++)this.elements[i]=t[i+e];return this}set(t,e,i,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=i,r[3]=s,this}};var ql=class extends ls{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function Bp(n,t,e,i){let s=dS(i);switch(e){case bp:return n*t;case oh:return n*t/s.components*s.byteLength;case ah:return n*t/s.components*s.byteLength;case kr:return n*t*2/s.components*s.byteLength;case lh:return n*t*2/s.components*s.byteLength;case Mp:return n*t*3/s.components*s.byteLength;case fs:return n*t*4/s.components*s.byteLength;case ch:return n*t*4/s.components*s.byteLength;case Yl:case Zl:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case Jl:case Kl:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case hh:case dh:return Math.max(n,16)*Math.max(t,8)/4;case uh:case fh:return Math.max(n,8)*Math.max(t,8)/2;case ph:case mh:case _h:case xh:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case gh:case jl:case yh:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case vh:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case bh:return Math.floor((n+4)/5)*Math.floor((t+3)/4)*16;case Mh:return Math.floor((n+4)/5)*Math.floor((t+4)/5)*16;case Sh:return Math.floor((n+5)/6)*Math.floor((t+4)/5)*16;case wh:return Math.floor((n+5)/6)*Math.floor((t+5)/6)*16;case Eh:return Math.floor((n+7)/8)*Math.floor((t+4)/5)*16;case Th:return Math.floor((n+7)/8)*Math.floor((t+5)/6)*16;case Ah:return Math.floor((n+7)/8)*Math.floor((t+7)/8)*16;case Rh:return Math.floor((n+9)/10)*Math.floor((t+4)/5)*16;case Ch:return Math.floor((n+9)/10)*Math.floor((t+5)/6)*16;case Ph:return Math.floor((n+9)/10)*Math.floor((t+7)/8)*16;case Ih:return Math.floor((n+9)/10)*Math.floor((t+9)/10)*16;case Lh:return Math.floor((n+11)/12)*Math.floor((t+9)/10)*16;case Dh:return Math.floor((n+11)/12)*Math.floor((t+11)/12)*16;case Nh:case Uh:case Fh:return Math.ceil(n/4)*Math.ceil(t/4)*16;case Oh:case Bh:return Math.ceil(n/4)*Math.ceil(t/4)*8;case Ql:case kh:return Math.ceil(n/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function dS(n){switch(n){case Bi:case _p:return{byteLength:1,components:1};case Ta:case xp:case hs:return{byteLength:2,components:1};case sh:case rh:return{byteLength:2,components:4};case us:case ih:case Ki:return{byteLength:4,components:1};case yp:case vp:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?jt("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Q_(){let n=null,t=!1,e=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&n!==null&&(i=n.requestAnimationFrame(s),t=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){n=r}}}function xS(n){let t=new WeakMap;function e(a,c){let l=a.array,u=a.usage,h=l.byteLength,f=n.createBuffer();n.bindBuffer(c,f),n.bufferData(c,l,u),a.onUploadCallback();let d;if(l instanceof Float32Array)d=n.FLOAT;else if(typeof Float16Array<"u"&&l instanceof Float16Array)d=n.HALF_FLOAT;else if(l instanceof Uint16Array)a.isFloat16BufferAttribute?d=n.HALF_FLOAT:d=n.UNSIGNED_SHORT;else if(l instanceof Int16Array)d=n.SHORT;else if(l instanceof Uint32Array)d=n.UNSIGNED_INT;else if(l instanceof Int32Array)d=n.INT;else if(l instanceof Int8Array)d=n.BYTE;else if(l instanceof Uint8Array)d=n.UNSIGNED_BYTE;else if(l instanceof Uint8ClampedArray)d=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+l);return{buffer:f,type:d,bytesPerElement:l.BYTES_PER_ELEMENT,version:a.version,size:h}}function i(a,c,l){let u=c.array,h=c.updateRanges;if(n.bindBuffer(l,a),h.length===0)n.bufferSubData(l,0,u);else{h.sort((d,g)=>d.start-g.start);let f=0;for(let d=1;d<h.length;d++){let g=h[f],_=h[d];_.start<=g.start+g.count+1?g.count=Math.max(g.count,_.start+_.count-g.start):(++f,h[f]=_)}h.length=f+1;for(let d=0,g=h.length;d<g;d++){let _=h[d];n.bufferSubData(l,_.start*u.BYTES_PER_ELEMENT,u,_.start,_.count)}c.clearUpdateRanges()}c.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let c=t.get(a);c&&(n.deleteBuffer(c.buffer),t.delete(a))}function o(a,c){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=t.get(a);(!u||u.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let l=t.get(a);if(l===void 0)t.set(a,e(a,c));else if(l.version<a.version){if(l.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(l.buffer,a,c),l.version=a.version}}return{get:s,remove:r,update:o}}var yS=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,vS=`#ifdef USE_ALPHAHASH
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
#endif`,bS=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,MS=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,SS=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,wS=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,ES=`#ifdef USE_AOMAP
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
#endif`,TS=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,AS=`#ifdef USE_BATCHING
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
#endif`,RS=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,CS=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,PS=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,IS=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,LS=`#ifdef USE_IRIDESCENCE
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
#endif`,DS=`#ifdef USE_BUMPMAP
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
#endif`,NS=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,US=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,FS=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,OS=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,BS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,kS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,zS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,HS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,GS=`#define PI 3.141592653589793
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
} // validated`,VS=`vec3 transformedNormal = objectNormal;
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
#endif`,WS=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,qS=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,XS=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,$S=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,YS="gl_FragColor = linearToOutputTexel( gl_FragColor );",ZS=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,JS=`#ifdef USE_ENVMAP
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
#endif`,KS=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,jS=`#ifdef USE_ENVMAP
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
#endif`,QS=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,tw=`#ifdef USE_ENVMAP
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
#endif`,ew=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,nw=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,iw=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,sw=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,rw=`#ifdef USE_GRADIENTMAP
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
}`,ow=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,aw=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,lw=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,cw=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,uw=`#ifdef USE_ENVMAP
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
#endif`,hw=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,fw=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,dw=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,pw=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,mw=`PhysicalMaterial material;
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
#endif`,gw=`uniform sampler2D dfgLUT;
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
}`,_w=`
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
#endif`,xw=`#if defined( RE_IndirectDiffuse )
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
#endif`,yw=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,vw=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,bw=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Mw=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Sw=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,ww=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Ew=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Tw=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Aw=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,Rw=`#if defined( USE_POINTS_UV )
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
#endif`,Cw=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Pw=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,Iw=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,Lw=`#if defined( USE_MORPHCOLORS )
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
#endif`,Dw=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Nw=`#ifdef USE_MORPHTARGETS
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
#endif`,Uw=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Fw=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,Ow=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,Bw=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,kw=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,zw=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,Hw=`#ifdef USE_NORMALMAP
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
#endif`,Gw=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,Vw=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,Ww=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,qw=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,Xw=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,$w=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,Yw=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,Zw=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,Jw=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,Kw=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,jw=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,Qw=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,tE=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,eE=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,nE=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,iE=`float getShadowMask() {
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
}`,sE=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,rE=`#ifdef USE_SKINNING
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
#endif`,oE=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,aE=`#ifdef USE_SKINNING
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
#endif`,lE=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,cE=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,uE=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,hE=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,fE=`#ifdef USE_TRANSMISSION
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
#endif`,dE=`#ifdef USE_TRANSMISSION
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
#endif`,pE=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,mE=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,gE=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,_E=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,xE=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,yE=`uniform sampler2D t2D;
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
}`,vE=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,bE=`uniform float backgroundBlurriness;
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
}`,ME=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,SE=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,wE=`#include <common>
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
}`,EE=`#if DEPTH_PACKING == 3200
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
}`,TE=`#define DISTANCE
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
}`,AE=`#define DISTANCE
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
}`,RE=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,CE=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,PE=`uniform float scale;
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
}`,IE=`uniform vec3 diffuse;
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
}`,LE=`#include <common>
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
}`,DE=`uniform vec3 diffuse;
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
}`,NE=`#define LAMBERT
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
}`,UE=`#define LAMBERT
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
}`,FE=`#define MATCAP
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
}`,OE=`#define MATCAP
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
}`,BE=`#define NORMAL
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
}`,kE=`#define NORMAL
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
}`,zE=`#define PHONG
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
}`,HE=`#define PHONG
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
}`,GE=`#define STANDARD
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
}`,VE=`#define STANDARD
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
}`,WE=`#define TOON
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
}`,qE=`#define TOON
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
}`,XE=`uniform float size;
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
}`,$E=`uniform vec3 diffuse;
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
}`,YE=`#include <common>
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
}`,ZE=`uniform vec3 color;
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
}`,JE=`uniform float rotation;
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
}`,KE=`uniform vec3 diffuse;
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
}`,_e={alphahash_fragment:yS,alphahash_pars_fragment:vS,alphamap_fragment:bS,alphamap_pars_fragment:MS,alphatest_fragment:SS,alphatest_pars_fragment:wS,aomap_fragment:ES,aomap_pars_fragment:TS,batching_pars_vertex:AS,batching_vertex:RS,begin_vertex:CS,beginnormal_vertex:PS,bsdfs:IS,iridescence_fragment:LS,bumpmap_pars_fragment:DS,clipping_planes_fragment:NS,clipping_planes_pars_fragment:US,clipping_planes_pars_vertex:FS,clipping_planes_vertex:OS,color_fragment:BS,color_pars_fragment:kS,color_pars_vertex:zS,color_vertex:HS,common:GS,defaultnormal_vertex:VS,displacementmap_pars_vertex:WS,displacementmap_vertex:qS,emissivemap_fragment:XS,emissivemap_pars_fragment:$S,colorspace_fragment:YS,colorspace_pars_fragment:ZS,envmap_fragment:JS,envmap_common_pars_fragment:KS,envmap_pars_fragment:jS,envmap_pars_vertex:QS,envmap_physical_pars_fragment:uw,envmap_vertex:tw,fog_vertex:ew,fog_pars_vertex:nw,fog_fragment:iw,fog_pars_fragment:sw,gradientmap_pars_fragment:rw,lightmap_pars_fragment:ow,lights_lambert_fragment:aw,lights_lambert_pars_fragment:lw,lights_pars_begin:cw,lights_toon_fragment:hw,lights_toon_pars_fragment:fw,lights_phong_fragment:dw,lights_phong_pars_fragment:pw,lights_physical_fragment:mw,lights_physical_pars_fragment:gw,lights_fragment_begin:_w,lights_fragment_maps:xw,lights_fragment_end:yw,lightprobes_pars_fragment:vw,logdepthbuf_fragment:bw,logdepthbuf_pars_fragment:Mw,logdepthbuf_pars_vertex:Sw,logdepthbuf_vertex:ww,map_fragment:Ew,map_pars_fragment:Tw,map_particle_fragment:Aw,map_particle_pars_fragment:Rw,metalnessmap_fragment:Cw,metalnessmap_pars_fragment:Pw,morphinstance_vertex:Iw,morphcolor_vertex:Lw,morphnormal_vertex:Dw,morphtarget_pars_vertex:Nw,morphtarget_vertex:Uw,normal_fragment_begin:Fw,normal_fragment_maps:Ow,normal_pars_fragment:Bw,normal_pars_vertex:kw,normal_vertex:zw,normalmap_pars_fragment:Hw,clearcoat_normal_fragment_begin:Gw,clearcoat_normal_fragment_maps:Vw,clearcoat_pars_fragment:Ww,iridescence_pars_fragment:qw,opaque_fragment:Xw,packing:$w,premultiplied_alpha_fragment:Yw,project_vertex:Zw,dithering_fragment:Jw,dithering_pars_fragment:Kw,roughnessmap_fragment:jw,roughnessmap_pars_fragment:Qw,shadowmap_pars_fragment:tE,shadowmap_pars_vertex:eE,shadowmap_vertex:nE,shadowmask_pars_fragment:iE,skinbase_vertex:sE,skinning_pars_vertex:rE,skinning_vertex:oE,skinnormal_vertex:aE,specularmap_fragment:lE,specularmap_pars_fragment:cE,tonemapping_fragment:uE,tonemapping_pars_fragment:hE,transmission_fragment:fE,transmission_pars_fragment:dE,uv_pars_fragment:pE,uv_pars_vertex:mE,uv_vertex:gE,worldpos_vertex:_E,background_vert:xE,background_frag:yE,backgroundCube_vert:vE,backgroundCube_frag:bE,cube_vert:ME,cube_frag:SE,depth_vert:wE,depth_frag:EE,distance_vert:TE,distance_frag:AE,equirect_vert:RE,equirect_frag:CE,linedashed_vert:PE,linedashed_frag:IE,meshbasic_vert:LE,meshbasic_frag:DE,meshlambert_vert:NE,meshlambert_frag:UE,meshmatcap_vert:FE,meshmatcap_frag:OE,meshnormal_vert:BE,meshnormal_frag:kE,meshphong_vert:zE,meshphong_frag:HE,meshphysical_vert:GE,meshphysical_frag:VE,meshtoon_vert:WE,meshtoon_frag:qE,points_vert:XE,points_frag:$E,shadow_vert:YE,shadow_frag:ZE,sprite_vert:JE,sprite_frag:KE},Ot={common:{diffuse:{value:new ee(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new ae},alphaMap:{value:null},alphaMapTransform:{value:new ae},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new ae}},envmap:{envMap:{value:null},envMapRotation:{value:new ae},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new ae}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new ae}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new ae},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new ae},normalScale:{value:new qt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new ae},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new ae}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new ae}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new ae}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new ee(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new ee(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new ae},alphaTest:{value:0},uvTransform:{value:new ae}},sprite:{diffuse:{value:new ee(16777215)},opacity:{value:1},center:{value:new qt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new ae},alphaMap:{value:null},alphaMapTransform:{value:new ae},alphaTest:{value:0}}},Fs={basic:{uniforms:ni([Ot.common,Ot.specularmap,Ot.envmap,Ot.aomap,Ot.lightmap,Ot.fog]),vertexShader:_e.meshbasic_vert,fragmentShader:_e.meshbasic_frag},lambert:{uniforms:ni([Ot.common,Ot.specularmap,Ot.envmap,Ot.aomap,Ot.lightmap,Ot.emissivemap,Ot.bumpmap,Ot.normalmap,Ot.displacementmap,Ot.fog,Ot.lights,{emissive:{value:new ee(0)},envMapIntensity:{value:1}}]),vertexShader:_e.meshlambert_vert,fragmentShader:_e.meshlambert_frag},phong:{uniforms:ni([Ot.common,Ot.specularmap,Ot.envmap,Ot.aomap,Ot.lightmap,Ot.emissivemap,Ot.bumpmap,Ot.normalmap,Ot.displacementmap,Ot.fog,Ot.lights,{emissive:{value:new ee(0)},specular:{value:new ee(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:_e.meshphong_vert,fragmentShader:_e.meshphong_frag},standard:{uniforms:ni([Ot.common,Ot.envmap,Ot.aomap,Ot.lightmap,Ot.emissivemap,Ot.bumpmap,Ot.normalmap,Ot.displacementmap,Ot.roughnessmap,Ot.metalnessmap,Ot.fog,Ot.lights,{emissive:{value:new ee(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:_e.meshphysical_vert,fragmentShader:_e.meshphysical_frag},toon:{uniforms:ni([Ot.common,Ot.aomap,Ot.lightmap,Ot.emissivemap,Ot.bumpmap,Ot.normalmap,Ot.displacementmap,Ot.gradientmap,Ot.fog,Ot.lights,{emissive:{value:new ee(0)}}]),vertexShader:_e.meshtoon_vert,fragmentShader:_e.meshtoon_frag},matcap:{uniforms:ni([Ot.common,Ot.bumpmap,Ot.normalmap,Ot.displacementmap,Ot.fog,{matcap:{value:null}}]),vertexShader:_e.meshmatcap_vert,fragmentShader:_e.meshmatcap_frag},points:{uniforms:ni([Ot.points,Ot.fog]),vertexShader:_e.points_vert,fragmentShader:_e.points_frag},dashed:{uniforms:ni([Ot.common,Ot.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:_e.linedashed_vert,fragmentShader:_e.linedashed_frag},depth:{uniforms:ni([Ot.common,Ot.displacementmap]),vertexShader:_e.depth_vert,fragmentShader:_e.depth_frag},normal:{uniforms:ni([Ot.common,Ot.bumpmap,Ot.normalmap,Ot.displacementmap,{opacity:{value:1}}]),vertexShader:_e.meshnormal_vert,fragmentShader:_e.meshnormal_frag},sprite:{uniforms:ni([Ot.sprite,Ot.fog]),vertexShader:_e.sprite_vert,fragmentShader:_e.sprite_frag},background:{uniforms:{uvTransform:{value:new ae},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:_e.background_vert,fragmentShader:_e.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new ae}},vertexShader:_e.backgroundCube_vert,fragmentShader:_e.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:_e.cube_vert,fragmentShader:_e.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:_e.equirect_vert,fragmentShader:_e.equirect_frag},distance:{uniforms:ni([Ot.common,Ot.displacementmap,{referencePosition:{value:new H},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:_e.distance_vert,fragmentShader:_e.distance_frag},shadow:{uniforms:ni([Ot.lights,Ot.fog,{color:{value:new ee(0)},opacity:{value:1}}]),vertexShader:_e.shadow_vert,fragmentShader:_e.shadow_frag}};Fs.physical={uniforms:ni([Fs.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new ae},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new ae},clearcoatNormalScale:{value:new qt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new ae},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new ae},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new ae},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new ae},sheen:{value:0},sheenColor:{value:new ee(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new ae},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new ae},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new ae},transmissionSamplerSize:{value:new qt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new ae},attenuationDistance:{value:0},attenuationColor:{value:new ee(0)},specularColor:{value:new ee(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new ae},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new ae},anisotropyVector:{value:new qt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new ae}}]),vertexShader:_e.meshphysical_vert,fragmentShader:_e.meshphysical_frag};var Gh={r:0,b:0,g:0},jE=new Te,tx=new ae;tx.set(-1,0,0,0,1,0,0,0,1);function QE(n,t,e,i,s,r){let o=new ee(0),a=s===!0?0:1,c,l,u=null,h=0,f=null;function d(x){let M=x.isScene===!0?x.background:null;if(M&&M.isTexture){let v=x.backgroundBlurriness>0;M=t.get(M,v)}return M}function g(x){let M=!1,v=d(x);v===null?p(o,a):v&&v.isColor&&(p(v,1),M=!0);let A=n.xr.getEnvironmentBlendMode();A==="additive"?e.buffers.color.setClear(0,0,0,1,r):A==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(n.autoClear||M)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function _(x,M){let v=d(M);v&&v.isCubeTexture?(l===void 0&&(l=new ei(new Lr(1,1,1),new Zi({name:"BackgroundCubeMaterial",uniforms:go(Fs.backgroundCube.uniforms),vertexShader:Fs.backgroundCube.vertexShader,fragmentShader:Fs.backgroundCube.fragmentShader,side:mi,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),l.geometry.deleteAttribute("uv"),l.onBeforeRender=function(A,S,y){this.matrixWorld.copyPosition(y.matrixWorld)},Object.defineProperty(l.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(l)),l.material.uniforms.envMap.value=v,l.material.uniforms.backgroundBlurriness.value=M.backgroundBlurriness,l.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,l.material.uniforms.backgroundRotation.value.setFromMatrix4(jE.makeRotationFromEuler(M.backgroundRotation)).transpose(),v.isRenderTargetTexture===!1&&l.material.uniforms.backgroundRotation.value.premultiply(tx),l.material.toneMapped=Ee.getTransfer(v.colorSpace)!==Oe,(u!==v||h!==v.version||f!==n.toneMapping)&&(l.material.needsUpdate=!0,u=v,h=v.version,f=n.toneMapping),l.layers.enableAll(),x.unshift(l,l.geometry,l.material,0,0,null)):v&&v.isTexture&&(c===void 0&&(c=new ei(new Hl(2,2),new Zi({name:"BackgroundMaterial",uniforms:go(Fs.background.uniforms),vertexShader:Fs.background.vertexShader,fragmentShader:Fs.background.fragmentShader,side:Br,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(c)),c.material.uniforms.t2D.value=v,c.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,c.material.toneMapped=Ee.getTransfer(v.colorSpace)!==Oe,v.matrixAutoUpdate===!0&&v.updateMatrix(),c.material.uniforms.uvTransform.value.copy(v.matrix),(u!==v||h!==v.version||f!==n.toneMapping)&&(c.material.needsUpdate=!0,u=v,h=v.version,f=n.toneMapping),c.layers.enableAll(),x.unshift(c,c.geometry,c.material,0,0,null))}function p(x,M){x.getRGB(Gh,Up(n)),e.buffers.color.setClear(Gh.r,Gh.g,Gh.b,M,r)}function m(){l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0),c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0)}return{getClearColor:function(){return o},setClearColor:function(x,M=1){o.set(x),a=M,p(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(x){a=x,p(o,a)},render:g,addToRenderList:_,dispose:m}}function t1(n,t){let e=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=f(null),r=s,o=!1;function a(N,z,W,O,X){let Z=!1,q=h(N,O,W,z);r!==q&&(r=q,l(r.object)),Z=d(N,O,W,X),Z&&g(N,O,W,X),X!==null&&t.update(X,n.ELEMENT_ARRAY_BUFFER),(Z||o)&&(o=!1,v(N,z,W,O),X!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,t.get(X).buffer))}function c(){return n.createVertexArray()}function l(N){return n.bindVertexArray(N)}function u(N){return n.deleteVertexArray(N)}function h(N,z,W,O){let X=O.wireframe===!0,Z=i[z.id];Z===void 0&&(Z={},i[z.id]=Z);let q=N.isInstancedMesh===!0?N.id:0,ut=Z[q];ut===void 0&&(ut={},Z[q]=ut);let j=ut[W.id];j===void 0&&(j={},ut[W.id]=j);let tt=j[X];return tt===void 0&&(tt=f(c()),j[X]=tt),tt}function f(N){let z=[],W=[],O=[];for(let X=0;X<e;X++)z[X]=0,W[X]=0,O[X]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:z,enabledAttributes:W,attributeDivisors:O,object:N,attributes:{},index:null}}function d(N,z,W,O){let X=r.attributes,Z=z.attributes,q=0,ut=W.getAttributes();for(let j in ut)if(ut[j].location>=0){let rt=X[j],dt=Z[j];if(dt===void 0&&(j==="instanceMatrix"&&N.instanceMatrix&&(dt=N.instanceMatrix),j==="instanceColor"&&N.instanceColor&&(dt=N.instanceColor)),rt===void 0||rt.attribute!==dt||dt&&rt.data!==dt.data)return!0;q++}return r.attributesNum!==q||r.index!==O}function g(N,z,W,O){let X={},Z=z.attributes,q=0,ut=W.getAttributes();for(let j in ut)if(ut[j].location>=0){let rt=Z[j];rt===void 0&&(j==="instanceMatrix"&&N.instanceMatrix&&(rt=N.instanceMatrix),j==="instanceColor"&&N.instanceColor&&(rt=N.instanceColor));let dt={};dt.attribute=rt,rt&&rt.data&&(dt.data=rt.data),X[j]=dt,q++}r.attributes=X,r.attributesNum=q,r.index=O}function _(){let N=r.newAttributes;for(let z=0,W=N.length;z<W;z++)N[z]=0}function p(N){m(N,0)}function m(N,z){let W=r.newAttributes,O=r.enabledAttributes,X=r.attributeDivisors;W[N]=1,O[N]===0&&(n.enableVertexAttribArray(N),O[N]=1),X[N]!==z&&(n.vertexAttribDivisor(N,z),X[N]=z)}function x(){let N=r.newAttributes,z=r.enabledAttributes;for(let W=0,O=z.length;W<O;W++)z[W]!==N[W]&&(n.disableVertexAttribArray(W),z[W]=0)}function M(N,z,W,O,X,Z,q){q===!0?n.vertexAttribIPointer(N,z,W,X,Z):n.vertexAttribPointer(N,z,W,O,X,Z)}function v(N,z,W,O){_();let X=O.attributes,Z=W.getAttributes(),q=z.defaultAttributeValues;for(let ut in Z){let j=Z[ut];if(j.location>=0){let tt=X[ut];if(tt===void 0&&(ut==="instanceMatrix"&&N.instanceMatrix&&(tt=N.instanceMatrix),ut==="instanceColor"&&N.instanceColor&&(tt=N.instanceColor)),tt!==void 0){let rt=tt.normalized,dt=tt.itemSize,ft=t.get(tt);if(ft===void 0)continue;let et=ft.buffer,_t=ft.type,bt=ft.bytesPerElement,Pt=_t===n.INT||_t===n.UNSIGNED_INT||tt.gpuType===ih;if(tt.isInterleavedBufferAttribute){let Et=tt.data,Zt=Et.isInterleavedBuffer===!0?Et.stride:Et.itemSize,ue=tt.offset;if(Et.isInstancedInterleavedBuffer||Et.isInstancedBufferAttribute){for(let $t=0;$t<j.locationSize;$t++)m(j.location+$t,Et.meshPerAttribute);N.isInstancedMesh!==!0&&O._maxInstanceCount===void 0&&(O._maxInstanceCount=Et.meshPerAttribute*Et.count)}else for(let $t=0;$t<j.locationSize;$t++)p(j.location+$t);n.bindBuffer(n.ARRAY_BUFFER,et);for(let $t=0;$t<j.locationSize;$t++)M(j.location+$t,dt/j.locationSize,_t,rt,Zt*bt,(ue+dt/j.locationSize*$t)*bt,Pt)}else{if(tt.isInstancedBufferAttribute){for(let Et=0;Et<j.locationSize;Et++)m(j.location+Et,tt.meshPerAttribute);N.isInstancedMesh!==!0&&O._maxInstanceCount===void 0&&(O._maxInstanceCount=tt.meshPerAttribute*tt.count)}else for(let Et=0;Et<j.locationSize;Et++)p(j.location+Et);n.bindBuffer(n.ARRAY_BUFFER,et);for(let Et=0;Et<j.locationSize;Et++)M(j.location+Et,dt/j.locationSize,_t,rt,dt*bt,dt/j.locationSize*Et*bt,Pt)}}else if(q!==void 0){let rt=q[ut];if(rt!==void 0)switch(rt.length){case 2:n.vertexAttrib2fv(j.location,rt);break;case 3:n.vertexAttrib3fv(j.location,rt);break;case 4:n.vertexAttrib4fv(j.location,rt);break;default:n.vertexAttrib1fv(j.location,rt)}}}}x()}function A(){U();for(let N in i){let z=i[N];for(let W in z){let O=z[W];for(let X in O){let Z=O[X];for(let q in Z)u(Z[q].object),delete Z[q];delete O[X]}}delete i[N]}}function S(N){if(i[N.id]===void 0)return;let z=i[N.id];for(let W in z){let O=z[W];for(let X in O){let Z=O[X];for(let q in Z)u(Z[q].object),delete Z[q];delete O[X]}}delete i[N.id]}function y(N){for(let z in i){let W=i[z];for(let O in W){let X=W[O];if(X[N.id]===void 0)continue;let Z=X[N.id];for(let q in Z)u(Z[q].object),delete Z[q];delete X[N.id]}}}function w(N){for(let z in i){let W=i[z],O=N.isInstancedMesh===!0?N.id:0,X=W[O];if(X!==void 0){for(let Z in X){let q=X[Z];for(let ut in q)u(q[ut].object),delete q[ut];delete X[Z]}delete W[O],Object.keys(W).length===0&&delete i[z]}}}function U(){L(),o=!0,r!==s&&(r=s,l(r.object))}function L(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:U,resetDefaultState:L,dispose:A,releaseStatesOfGeometry:S,releaseStatesOfObject:w,releaseStatesOfProgram:y,initAttributes:_,enableAttribute:p,disableUnusedAttributes:x}}function e1(n,t,e){let i;function s(c){i=c}function r(c,l){n.drawArrays(i,c,l),e.update(l,i,1)}function o(c,l,u){u!==0&&(n.drawArraysInstanced(i,c,l,u),e.update(l,i,u))}function a(c,l,u){if(u===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,c,0,l,0,u);let f=0;for(let d=0;d<u;d++)f+=l[d];e.update(f,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function n1(n,t,e,i){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let y=t.get("EXT_texture_filter_anisotropic");s=n.getParameter(y.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(y){return!(y!==fs&&i.convert(y)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(y){let w=y===hs&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(y!==Bi&&y!==Ki&&!w&&i.convert(y)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function c(y){if(y==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";y="mediump"}return y==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let l=e.precision!==void 0?e.precision:"highp",u=c(l);u!==l&&(jt("WebGLRenderer:",l,"not supported, using",u,"instead."),l=u);let h=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),f=e.logarithmicDepthBuffer===!0&&h===!1;e.reversedDepthBuffer===!0&&h===!1&&jt("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&h===!0&&jt("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let d=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),g=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),_=n.getParameter(n.MAX_TEXTURE_SIZE),p=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),m=n.getParameter(n.MAX_VERTEX_ATTRIBS),x=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),M=n.getParameter(n.MAX_VARYING_VECTORS),v=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),A=n.getParameter(n.MAX_SAMPLES),S=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:c,textureFormatReadable:o,textureTypeReadable:a,precision:l,logarithmicDepthBuffer:f,reversedDepthBuffer:h,maxTextures:d,maxVertexTextures:g,maxTextureSize:_,maxCubemapSize:p,maxAttributes:m,maxVertexUniforms:x,maxVaryings:M,maxFragmentUniforms:v,maxSamples:A,samples:S}}function i1(n){let t=this,e=null,i=0,s=!1,r=!1,o=new Zn,a=new ae,c={value:null,needsUpdate:!1};this.uniform=c,this.numPlanes=0,this.numIntersection=0,this.init=function(h,f){let d=h.length!==0||f||i!==0||s;return s=f,i=h.length,d},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,f){e=u(h,f,0)},this.setState=function(h,f,d){let g=h.clippingPlanes,_=h.clipIntersection,p=h.clipShadows,m=n.get(h);if(!s||g===null||g.length===0||r&&!p)r?u(null):l();else{let x=r?0:i,M=x*4,v=m.clippingState||null;c.value=v,v=u(g,f,M,d);for(let A=0;A!==M;++A)v[A]=e[A];m.clippingState=v,this.numIntersection=_?this.numPlanes:0,this.numPlanes+=x}};function l(){c.value!==e&&(c.value=e,c.needsUpdate=i>0),t.numPlanes=i,t.numIntersection=0}function u(h,f,d,g){let _=h!==null?h.length:0,p=null;if(_!==0){if(p=c.value,g!==!0||p===null){let m=d+_*4,x=f.matrixWorldInverse;a.getNormalMatrix(x),(p===null||p.length<m)&&(p=new Float32Array(m));for(let M=0,v=d;M!==_;++M,v+=4)o.copy(h[M]).applyMatrix4(x,a),o.normal.toArray(p,v),p[v+3]=o.constant}c.value=p,c.needsUpdate=!0}return t.numPlanes=_,t.numIntersection=0,p}}var nc=class extends Fi{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let i={width:t,height:t,depth:1},s=[i,i,i,i,i,i];this.texture=new Ul(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new Lr(5,5,5),r=new Zi({name:"CubemapFromEquirect",uniforms:go(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:mi,blending:ho});r.uniforms.tEquirect.value=e;let o=new ei(s,r),a=e.minFilter;return e.minFilter===ar&&(e.minFilter=fi),new ba(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,i=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,i,s);t.setRenderTarget(r)}},L_=256,s1=3,r1=20,ex=256,nx=16,o1=3,a1=new H,l1=new ee,Wh=class n{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new ba(1,10,null),this._boxMesh=new ei(new Lr(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,i=.1,s=100,r={}){let{size:o=256,position:a=a1}=r,c=this._renderer;this._setSize(o);let l=this._allocateTarget(),u=this._getSourceTarget(!0);e>0&&(u.texture.mipmapsAutoUpdate=!1);let h=c.autoClear,f=c.autoClearColor,d=c.autoClearDepth,g=c.autoClearStencil,_=t.background;c.autoClear=!0,c.autoClearColor=!0,c.autoClearDepth=!0,c.autoClearStencil=!0,_===null&&(t.background=c.getClearColor(l1));let p=new ba(i,s,u);return p.position.copy(a),p.update(c,t),c.autoClear=h,c.autoClearColor=f,c.autoClearDepth=d,c.autoClearStencil=g,t.background=_,e>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(l,e)),this._applyPMREM(l),l}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=U_(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=N_(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(L_,Lp(t))}_fromTexture(t,e){t.mapping===po||t.mapping===Ea?this._setSize(t.image.length===0?L_:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let i=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(i),i}_allocateTarget(){let t=this._cubeSize,e=D_(t,!1,!1),i=Math.log2(t)-s1;for(let s=0;s<=i;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==e||t&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=D_(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===po||t.mapping===Ea?(this._cubemapMaterial===null&&(this._cubemapMaterial=U_()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=N_()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=c1(),this._integrationMaterial=u1());let e=this._cubeSize,i=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/nx);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-o1)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let c=a>0?Math.log2(e)+.5*Math.log2(6/(ex*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=c,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=h1());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,i),s.envMap.value=t.texture,this._renderCube(r,0,i)}};function D_(n,t,e){return new nc(n,{minFilter:ar,generateMipmaps:t,type:hs,colorSpace:bl,depthBuffer:e})}function ic(n,t,e){return new Zi({name:n,uniforms:t,vertexShader:_e.cube_vert,fragmentShader:e,side:mi,blending:ho,depthTest:!1,depthWrite:!1})}function c1(){return ic("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${ex}u

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
	`)}function u1(){return ic("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:nx}},`

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
	`)}function h1(){return ic("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${r1}
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
	`)}function N_(){return ic("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function U_(){return ic("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function f1(n){let t=new WeakMap,e=new WeakMap,i=null;function s(f,d=!1){return f==null?null:d?o(f):r(f)}function r(f){if(f&&f.isTexture){let d=f.mapping;if(d===th||d===eh)if(t.has(f)){let g=t.get(f).texture;return a(g,f.mapping)}else{let g=f.image;if(g&&g.height>0){let _=new nc(g.height);return _.fromEquirectangularTexture(n,f),t.set(f,_),f.addEventListener("dispose",l),a(_.texture,f.mapping)}else return null}}return f}function o(f){if(f&&f.isTexture&&f.isPMREMTexture!==!0){let d=f.mapping,g=d===th||d===eh,_=d===po||d===Ea;if(g||_){let p=e.get(f),m=p!==void 0?p.texture.pmremVersion:0;if(f.isRenderTargetTexture&&f.pmremVersion!==m)return i===null&&(i=new Wh(n)),p=g?i.fromEquirectangular(f,p):i.fromCubemap(f,p),p.texture.pmremVersion=f.pmremVersion,e.set(f,p),p.texture;if(p!==void 0)return p.texture;{let x=f.image;return g&&x&&x.height>0||_&&x&&c(x)?(i===null&&(i=new Wh(n)),p=g?i.fromEquirectangular(f):i.fromCubemap(f),p.texture.pmremVersion=f.pmremVersion,e.set(f,p),f.addEventListener("dispose",u),p.texture):null}}}return f}function a(f,d){return d===th?f.mapping=po:d===eh&&(f.mapping=Ea),f}function c(f){let d=0,g=6;for(let _=0;_<g;_++)f[_]!==void 0&&d++;return d===g}function l(f){let d=f.target;d.removeEventListener("dispose",l);let g=t.get(d);g!==void 0&&(t.delete(d),g.dispose())}function u(f){let d=f.target;d.removeEventListener("dispose",u);let g=e.get(d);g!==void 0&&(e.delete(d),g.dispose())}function h(){t=new WeakMap,e=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:h}}function d1(n){let t={};function e(i){if(t[i]!==void 0)return t[i];let s=n.getExtension(i);return t[i]=s,s}return{has:function(i){return e(i)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(i){let s=e(i);return s===null&&_l("WebGLRenderer: "+i+" extension not supported."),s}}}function p1(n,t,e,i){let s={},r=new WeakMap,o=new FinalizationRegistry(g=>delete s[g]);function a(g){c(g.target)}function c(g){g.index!==null&&t.remove(g.index);for(let p in g.attributes)t.remove(g.attributes[p]);g.removeEventListener("dispose",a),delete s[g.id],o.unregister(g);let _=r.get(g);_&&(t.remove(_),r.delete(g)),i.releaseStatesOfGeometry(g),g.isInstancedBufferGeometry===!0&&delete g._maxInstanceCount,e.memory.geometries--}function l(g,_){return s[_.id]!==void 0||(_.addEventListener("dispose",a),s[_.id]=new WeakRef(_),o.register(_,_.id,_),e.memory.geometries++),_}function u(g){let _=g.attributes;for(let p in _)t.update(_[p],n.ARRAY_BUFFER)}function h(g){let _=g.index,p=g.attributes.position,m=0;if(p===void 0)return;let x=_!==null?_.array.length:p.array.length/3-1,M=p.count>=65535?Pl:Cl,v=new M(Math.ceil(x/3)*6,1),A=v.array;if(_!==null){let y=_.array;m=_.version;for(let w=0,U=0;w<x;w+=3){let L=y[w+0],N=y[w+1],z=y[w+2];A[U++]=L,A[U++]=N,A[U++]=N,A[U++]=z,A[U++]=z,A[U++]=L}}else{m=p.version;for(let y=0,w=0;y<x;y+=3){let U=y+0,L=y+1,N=y+2;A[w++]=U,A[w++]=L,A[w++]=L,A[w++]=N,A[w++]=N,A[w++]=U}}v.version=m;let S=r.get(g);S&&t.remove(S),r.set(g,v)}function f(g){let _=r.get(g);if(_){let p=g.index;p!==null&&_.version<p.version&&h(g)}else h(g);return r.get(g)}function d(){for(let g in s){let _=s[g].deref();_!==void 0&&c(_)}}return{get:l,update:u,getWireframeAttribute:f,dispose:d}}function m1(n,t,e){let i;function s(h){i=h}let r,o;function a(h){r=h.type,o=h.bytesPerElement}function c(h,f){n.drawElements(i,f,r,h*o),e.update(f,i,1)}function l(h,f,d){d!==0&&(n.drawElementsInstanced(i,f,r,h*o,d),e.update(f,i,d))}function u(h,f,d){if(d===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,f,0,r,h,0,d);let _=0;for(let p=0;p<d;p++)_+=f[p];e.update(_,i,1)}this.setMode=s,this.setIndex=a,this.render=c,this.renderInstances=l,this.renderMultiDraw=u}function g1(n){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(e.calls++,o){case n.TRIANGLES:e.triangles+=a*(r/3);break;case n.LINES:e.lines+=a*(r/2);break;case n.LINE_STRIP:e.lines+=a*(r-1);break;case n.LINE_LOOP:e.lines+=a*r;break;case n.POINTS:e.points+=a*r;break;default:ie("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:i}}function _1(n,t,e){let i=new WeakMap,s=new hn;function r(o,a,c){let l=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,f=i.get(a);if(f===void 0||f.count!==h){let U=function(){y.dispose(),i.delete(a),a.removeEventListener("dispose",U)};f!==void 0&&f.texture.dispose();let d=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,_=a.morphAttributes.color!==void 0,p=a.morphAttributes.position||[],m=a.morphAttributes.normal||[],x=a.morphAttributes.color||[],M=0;d===!0&&(M=1),g===!0&&(M=2),_===!0&&(M=3);let v=a.attributes.position.count*M,A=1;v>t.maxTextureSize&&(A=Math.ceil(v/t.maxTextureSize),v=t.maxTextureSize);let S=new Float32Array(v*A*4*h),y=new Tl(S,v,A,h);y.type=Ki,y.needsUpdate=!0;let w=M*4;for(let L=0;L<h;L++){let N=p[L],z=m[L],W=x[L],O=v*A*4*L;for(let X=0;X<N.count;X++){let Z=X*w;d===!0&&(s.fromBufferAttribute(N,X),S[O+Z+0]=s.x,S[O+Z+1]=s.y,S[O+Z+2]=s.z,S[O+Z+3]=0),g===!0&&(s.fromBufferAttribute(z,X),S[O+Z+4]=s.x,S[O+Z+5]=s.y,S[O+Z+6]=s.z,S[O+Z+7]=0),_===!0&&(s.fromBufferAttribute(W,X),S[O+Z+8]=s.x,S[O+Z+9]=s.y,S[O+Z+10]=s.z,S[O+Z+11]=W.itemSize===4?s.w:1)}}f={count:h,texture:y,size:new qt(v,A)},i.set(a,f),a.addEventListener("dispose",U)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)c.getUniforms().setValue(n,"morphTexture",o.morphTexture,e);else{let d=0;for(let _=0;_<l.length;_++)d+=l[_];let g=a.morphTargetsRelative?1:1-d;c.getUniforms().setValue(n,"morphTargetBaseInfluence",g),c.getUniforms().setValue(n,"morphTargetInfluences",l)}c.getUniforms().setValue(n,"morphTargetsTexture",f.texture,e),c.getUniforms().setValue(n,"morphTargetsTextureSize",f.size)}return{update:r}}function x1(n,t,e,i,s){let r=new WeakMap;function o(l){let u=s.render.frame,h=l.geometry,f=t.get(l,h);if(r.get(f)!==u&&(t.update(f),r.set(f,u)),l.isInstancedMesh&&(l.hasEventListener("dispose",c)===!1&&l.addEventListener("dispose",c),r.get(l)!==u&&(e.update(l.instanceMatrix,n.ARRAY_BUFFER),l.instanceColor!==null&&e.update(l.instanceColor,n.ARRAY_BUFFER),r.set(l,u))),l.isSkinnedMesh){let d=l.skeleton;r.get(d)!==u&&(d.update(),r.set(d,u))}return f}function a(){r=new WeakMap}function c(l){let u=l.target;u.removeEventListener("dispose",c),i.releaseStatesOfObject(u),e.remove(u.instanceMatrix),u.instanceColor!==null&&e.remove(u.instanceColor)}return{update:o,dispose:a}}var y1={[cp]:"LINEAR_TONE_MAPPING",[up]:"REINHARD_TONE_MAPPING",[hp]:"CINEON_TONE_MAPPING",[fp]:"ACES_FILMIC_TONE_MAPPING",[pp]:"AGX_TONE_MAPPING",[mp]:"NEUTRAL_TONE_MAPPING",[dp]:"CUSTOM_TONE_MAPPING"};function v1(n,t,e,i,s,r){let o=new Fi(t,e,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,c=null,l=null,u=new De;u.setAttribute("position",new Ce([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new Ce([0,2,0,0,2,0],2));let h=new ku({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),f=new ei(u,h),d=new ju(-1,1,1,-1,0,1),g=null,_=null,p=!1,m,x=null,M=[],v=!1;this.setSize=function(A,S){o.setSize(A,S),a!==null&&a.setSize(A,S),c!==null&&c.setSize(A,S);for(let y=0;y<M.length;y++){let w=M[y];w.setSize&&w.setSize(A,S)}},this.setEffects=function(A){M=A,v=M.length>0&&M[0].isRenderPass===!0;let S=o.width,y=o.height;M.length>0&&a===null&&(a=new Fi(S,y,{type:hs,depthBuffer:!1,stencilBuffer:!1}),c=new Fi(S,y,{type:hs,depthBuffer:!1,stencilBuffer:!1}));let w=s===!0&&M.some(U=>U.needsDepthTexture===!0);w!==(o.depthTexture!==null)&&(w===!0&&l===null&&(l=new or(S,y),r===!0&&(l.format=lr,l.type=mo)),o.dispose(),o.depthTexture=w?l:null,o.resolveDepthBuffer=w,o.storeMultisampledDepthBuffer=w);for(let U=0;U<M.length;U++){let L=M[U];L.setSize&&L.setSize(S,y),w&&L.needsDepthTexture===!0&&L.setDepthTexture&&L.setDepthTexture(l)}},this.begin=function(A,S){if(p||A.toneMapping===Ns&&M.length===0)return!1;if(x=S,S!==null){let y=S.width,w=S.height;(o.width!==y||o.height!==w)&&this.setSize(y,w)}return v===!1&&A.setRenderTarget(o),m=A.toneMapping,A.toneMapping=Ns,!0},this.hasRenderPass=function(){return v},this.end=function(A,S){A.toneMapping=m,p=!0;let y=o,w=a;for(let U=0;U<M.length;U++){let L=M[U];L.enabled!==!1&&(L.render(A,w,y,S),L.needsSwap!==!1&&(y=w,w=w===a?c:a))}if(g!==A.outputColorSpace||_!==A.toneMapping){g=A.outputColorSpace,_=A.toneMapping,h.defines={},Ee.getTransfer(g)===Oe&&(h.defines.SRGB_TRANSFER="");let U=y1[_];U&&(h.defines[U]=""),h.needsUpdate=!0}h.uniforms.tDiffuse.value=y.texture,A.setRenderTarget(x),A.render(f,d),x=null,p=!1},this.isCompositing=function(){return p},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),c!==null&&c.dispose(),u.dispose(),h.dispose()}}var ix=new di,sx=new or(1,1),rx=new Ol(1),ox=new Tl,ax=new Nu,lx=new Ul,F_=[],O_=[],B_=new Float32Array(16),k_=new Float32Array(9),z_=new Float32Array(4);function Ra(n,t,e){let i=n[0];if(i<=0||i>0)return n;let s=t*e,r=F_[s];if(r===void 0&&(r=new Float32Array(s),F_[s]=r),t!==0){i.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,n[o].toArray(r,a)}return r}function Dn(n,t){if(n.length!==t.length)return!1;for(let e=0,i=n.length;e<i;e++)if(n[e]!==t[e])return!1;return!0}function Nn(n,t){for(let e=0,i=t.length;e<i;e++)n[e]=t[e]}function Xh(n,t){let e=O_[t];e===void 0&&(e=new Int32Array(t),O_[t]=e);for(let i=0;i!==t;++i)e[i]=n.allocateTextureUnit();return e}function b1(n,t){let e=this.cache;e[0]!==t&&(n.uniform1f(this.addr,t),e[0]=t)}function M1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Dn(e,t))return;n.uniform2fv(this.addr,t),Nn(e,t)}}function S1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(n.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(Dn(e,t))return;n.uniform3fv(this.addr,t),Nn(e,t)}}function w1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Dn(e,t))return;n.uniform4fv(this.addr,t),Nn(e,t)}}function E1(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Dn(e,t))return;n.uniformMatrix2fv(this.addr,!1,t),Nn(e,t)}else{if(Dn(e,i))return;z_.set(i),n.uniformMatrix2fv(this.addr,!1,z_),Nn(e,i)}}function T1(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Dn(e,t))return;n.uniformMatrix3fv(this.addr,!1,t),Nn(e,t)}else{if(Dn(e,i))return;k_.set(i),n.uniformMatrix3fv(this.addr,!1,k_),Nn(e,i)}}function A1(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Dn(e,t))return;n.uniformMatrix4fv(this.addr,!1,t),Nn(e,t)}else{if(Dn(e,i))return;B_.set(i),n.uniformMatrix4fv(this.addr,!1,B_),Nn(e,i)}}function R1(n,t){let e=this.cache;e[0]!==t&&(n.uniform1i(this.addr,t),e[0]=t)}function C1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Dn(e,t))return;n.uniform2iv(this.addr,t),Nn(e,t)}}function P1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Dn(e,t))return;n.uniform3iv(this.addr,t),Nn(e,t)}}function I1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Dn(e,t))return;n.uniform4iv(this.addr,t),Nn(e,t)}}function L1(n,t){let e=this.cache;e[0]!==t&&(n.uniform1ui(this.addr,t),e[0]=t)}function D1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Dn(e,t))return;n.uniform2uiv(this.addr,t),Nn(e,t)}}function N1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Dn(e,t))return;n.uniform3uiv(this.addr,t),Nn(e,t)}}function U1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Dn(e,t))return;n.uniform4uiv(this.addr,t),Nn(e,t)}}function $h(n){return n.version===0&&(n.compareFunction=Rp,n.needsUpdate=!0),n}function F1(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=$h(sx):r=ix,e.setTexture2D(t||r,s)}function O1(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture3D(t||ax,s)}function B1(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=$h(rx):r=lx,e.setTextureCube(t||r,s)}function k1(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture2DArray(t||ox,s)}function z1(n){switch(n){case 5126:return b1;case 35664:return M1;case 35665:return S1;case 35666:return w1;case 35674:return E1;case 35675:return T1;case 35676:return A1;case 5124:case 35670:return R1;case 35667:case 35671:return C1;case 35668:case 35672:return P1;case 35669:case 35673:return I1;case 5125:return L1;case 36294:return D1;case 36295:return N1;case 36296:return U1;case 35678:case 36198:case 36298:case 36306:case 35682:return F1;case 35679:case 36299:case 36307:return O1;case 35680:case 36300:case 36308:case 36293:return B1;case 36289:case 36303:case 36311:case 36292:return k1}}function H1(n,t){n.uniform1fv(this.addr,t)}function G1(n,t){let e=Ra(t,this.size,2);n.uniform2fv(this.addr,e)}function V1(n,t){let e=Ra(t,this.size,3);n.uniform3fv(this.addr,e)}function W1(n,t){let e=Ra(t,this.size,4);n.uniform4fv(this.addr,e)}function q1(n,t){let e=Ra(t,this.size,4);n.uniformMatrix2fv(this.addr,!1,e)}function X1(n,t){let e=Ra(t,this.size,9);n.uniformMatrix3fv(this.addr,!1,e)}function $1(n,t){let e=Ra(t,this.size,16);n.uniformMatrix4fv(this.addr,!1,e)}function Y1(n,t){n.uniform1iv(this.addr,t)}function Z1(n,t){n.uniform2iv(this.addr,t)}function J1(n,t){n.uniform3iv(this.addr,t)}function K1(n,t){n.uniform4iv(this.addr,t)}function j1(n,t){n.uniform1uiv(this.addr,t)}function Q1(n,t){n.uniform2uiv(this.addr,t)}function tT(n,t){n.uniform3uiv(this.addr,t)}function eT(n,t){n.uniform4uiv(this.addr,t)}function nT(n,t,e){let i=this.cache,s=t.length,r=Xh(e,s);Dn(i,r)||(n.uniform1iv(this.addr,r),Nn(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=$h(sx):o=ix;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function iT(n,t,e){let i=this.cache,s=t.length,r=Xh(e,s);Dn(i,r)||(n.uniform1iv(this.addr,r),Nn(i,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||ax,r[o])}function sT(n,t,e){let i=this.cache,s=t.length,r=Xh(e,s);Dn(i,r)||(n.uniform1iv(this.addr,r),Nn(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=$h(rx):o=lx;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function rT(n,t,e){let i=this.cache,s=t.length,r=Xh(e,s);Dn(i,r)||(n.uniform1iv(this.addr,r),Nn(i,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||ox,r[o])}function oT(n){switch(n){case 5126:return H1;case 35664:return G1;case 35665:return V1;case 35666:return W1;case 35674:return q1;case 35675:return X1;case 35676:return $1;case 5124:case 35670:return Y1;case 35667:case 35671:return Z1;case 35668:case 35672:return J1;case 35669:case 35673:return K1;case 5125:return j1;case 36294:return Q1;case 36295:return tT;case 36296:return eT;case 35678:case 36198:case 36298:case 36306:case 35682:return nT;case 35679:case 36299:case 36307:return iT;case 35680:case 36300:case 36308:case 36293:return sT;case 36289:case 36303:case 36311:case 36292:return rT}}var Hp=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.setValue=z1(e.type)}},Gp=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=oT(e.type)}},Vp=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],i)}}},kp=/(\w+)(\])?(\[|\.)?/g;function H_(n,t){n.seq.push(t),n.map[t.id]=t}function aT(n,t,e){let i=n.name,s=i.length;for(kp.lastIndex=0;;){let r=kp.exec(i),o=kp.lastIndex,a=r[1],c=r[2]==="]",l=r[3];if(c&&(a=a|0),l===void 0||l==="["&&o+2===s){H_(e,l===void 0?new Hp(a,n,t):new Gp(a,n,t));break}else{let h=e.map[a];h===void 0&&(h=new Vp(a),H_(e,h)),e=h}}}var Aa=class{constructor(t,e){this.seq=[],this.map={};let i=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=t.getActiveUniform(e,o),c=t.getUniformLocation(e,a.name);aT(a,c,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,i,s){let r=this.map[e];r!==void 0&&r.setValue(t,i,s)}setOptional(t,e,i){let s=e[i];s!==void 0&&this.setValue(t,i,s)}static upload(t,e,i,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],c=i[a.id];c.needsUpdate!==!1&&a.setValue(t,c.value,s)}}static seqWithValue(t,e){let i=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&i.push(o)}return i}};function G_(n,t,e){let i=n.createShader(t);return n.shaderSource(i,e),n.compileShader(i),i}var lT=37297,cT=0;function uT(n,t){let e=n.split(`
`),i=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return i.join(`
`)}var V_=new ae;function hT(n){Ee._getMatrix(V_,Ee.workingColorSpace,n);let t=`mat3( ${V_.elements.map(e=>e.toFixed(4))} )`;switch(Ee.getTransfer(n)){case Ml:return[t,"LinearTransferOETF"];case Oe:return[t,"sRGBTransferOETF"];default:return jt("WebGLProgram: Unsupported color space: ",n),[t,"LinearTransferOETF"]}}function W_(n,t,e){let i=n.getShaderParameter(t,n.COMPILE_STATUS),r=(n.getShaderInfoLog(t)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+uT(n.getShaderSource(t),a)}else return r}function fT(n,t){let e=hT(t);return[`vec4 ${n}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var dT={[cp]:"Linear",[up]:"Reinhard",[hp]:"Cineon",[fp]:"ACESFilmic",[pp]:"AgX",[mp]:"Neutral",[dp]:"Custom"};function pT(n,t){let e=dT[t];return e===void 0?(jt("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var Vh=new H;function mT(){Ee.getLuminanceCoefficients(Vh);let n=Vh.x.toFixed(4),t=Vh.y.toFixed(4),e=Vh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function gT(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(ec).join(`
`)}function _T(n){let t=[];for(let e in n){let i=n[e];i!==!1&&t.push("#define "+e+" "+i)}return t.join(`
`)}function xT(n,t){let e={},i=n.getProgramParameter(t,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(t,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:n.getAttribLocation(t,o),locationSize:a}}return e}function ec(n){return n!==""}function q_(n,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function X_(n,t){return n.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var yT=/^[ \t]*#include +<([\w\d./]+)>/gm;function Wp(n){return n.replace(yT,vT)}function vT(n,t){let e=_e[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return Wp(e)}var bT=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function $_(n){return n.replace(bT,MT)}function MT(n,t,e,i){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Y_(n){let t=`precision ${n.precision} float;
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
#define LOW_PRECISION`),t}var ST={[Xl]:"SHADOWMAP_TYPE_PCF",[Sa]:"SHADOWMAP_TYPE_VSM"};function wT(n){return ST[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var ET={[Ea]:"ENVMAP_MODE_REFRACTION"};function TT(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":ET[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var AT={[lp]:"ENVMAP_BLENDING_MULTIPLY",[f_]:"ENVMAP_BLENDING_MIX",[d_]:"ENVMAP_BLENDING_ADD"};function RT(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":AT[n.combine]||"ENVMAP_BLENDING_NONE"}function CT(n,t,e,i){let s=n.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,c=wT(e),l=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=TT(e),h=RT(e),f=gT(e),d=_T(r),g=s.createProgram(),_,p,m=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(_=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d].filter(ec).join(`
`),_.length>0&&(_+=`
`),p=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d].filter(ec).join(`
`),p.length>0&&(p+=`
`)):(_=[Y_(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+u:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+c:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(ec).join(`
`),p=[Y_(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+l:"",e.envMap?"#define "+u:"",e.envMap?"#define "+h:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+c:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==Ns?"#define TONE_MAPPING":"",e.toneMapping!==Ns?_e.tonemapping_pars_fragment:"",e.toneMapping!==Ns?pT("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",_e.colorspace_pars_fragment,fT("linearToOutputTexel",e.outputColorSpace),mT(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(ec).join(`
`)),o=Wp(o),o=q_(o,e),o=X_(o,e),a=Wp(a),a=q_(a,e),a=X_(a,e),o=$_(o),a=$_(a),e.isRawShaderMaterial!==!0&&(m=`#version 300 es
`,_=[f,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+_,p=["#define varying in",e.glslVersion===Pp?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===Pp?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);let x=m+_+o,M=m+p+a,v=G_(s,s.VERTEX_SHADER,x),A=G_(s,s.FRAGMENT_SHADER,M);s.attachShader(g,v),s.attachShader(g,A),e.index0AttributeName!==void 0?s.bindAttribLocation(g,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(g,0,"position"),s.linkProgram(g);function S(L){if(n.debug.checkShaderErrors){let N=s.getProgramInfoLog(g)||"",z=s.getShaderInfoLog(v)||"",W=s.getShaderInfoLog(A)||"",O=N.trim(),X=z.trim(),Z=W.trim(),q=!0,ut=!0;if(s.getProgramParameter(g,s.LINK_STATUS)===!1)if(q=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,g,v,A);else{let j=W_(s,v,"vertex"),tt=W_(s,A,"fragment");ie("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(g,s.VALIDATE_STATUS)+`

Material Name: `+L.name+`
Material Type: `+L.type+`

Program Info Log: `+O+`
`+j+`
`+tt)}else O!==""?jt("WebGLProgram: Program Info Log:",O):(X===""||Z==="")&&(ut=!1);ut&&(L.diagnostics={runnable:q,programLog:O,vertexShader:{log:X,prefix:_},fragmentShader:{log:Z,prefix:p}})}s.deleteShader(v),s.deleteShader(A),y=new Aa(s,g),w=xT(s,g)}let y;this.getUniforms=function(){return y===void 0&&S(this),y};let w;this.getAttributes=function(){return w===void 0&&S(this),w};let U=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return U===!1&&(U=s.getProgramParameter(g,lT)),U},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(g),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=cT++,this.cacheKey=t,this.usedTimes=1,this.program=g,this.vertexShader=v,this.fragmentShader=A,this}var PT=0,qp=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,i){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let i of e)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,i=e.get(t);return i===void 0&&(i=new Set,e.set(t,i)),i}_getShaderStage(t){let e=this.shaderCache,i=e.get(t);return i===void 0&&(i=new Xp(t),e.set(t,i)),i}},Xp=class{constructor(t){this.id=PT++,this.code=t,this.usedTimes=0}};function IT(n){return n===kr||n===jl||n===Ql}function LT(n,t,e,i,s,r){let o=new pa,a=new qp,c=new Set,l=[],u=new Map,h=i.logarithmicDepthBuffer,f={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function d(y){return c.add(y),y===0?"uv":`uv${y}`}function g(y,w,U,L,N,z){let W=L.fog,O=N.geometry,X=y.isMeshStandardMaterial||y.isMeshLambertMaterial||y.isMeshPhongMaterial?L.environment:null,Z=y.isMeshStandardMaterial||y.isMeshLambertMaterial&&!y.envMap||y.isMeshPhongMaterial&&!y.envMap,q=t.get(y.envMap||X,Z),ut=f[y.type],j=i.precision;y.precision!==null&&(j=i.getMaxPrecision(y.precision),j!==y.precision&&jt("WebGLProgram.getParameters:",y.precision,"not supported, using",j,"instead."));let tt=O.morphAttributes.position||O.morphAttributes.normal||O.morphAttributes.color,rt=tt!==void 0?tt.length:0,dt=0;O.morphAttributes.position!==void 0&&(dt=1),O.morphAttributes.normal!==void 0&&(dt=2),O.morphAttributes.color!==void 0&&(dt=3);let ft,et,_t,bt;if(ut){let It=Fs[ut];ft=It.vertexShader,et=It.fragmentShader}else{ft=y.vertexShader,et=y.fragmentShader;let It=a.getVertexShaderStage(y),fe=a.getFragmentShaderStage(y);a.update(y,It,fe),_t=It.id,bt=fe.id}let Pt=n.getRenderTarget(),Et=n.state.buffers.depth.getReversed(),Zt=N.isInstancedMesh===!0,ue=N.isBatchedMesh===!0,$t=!!y.map,xe=!!y.matcap,me=!!q,le=me&&q.isPMREMTexture===!0,an=!!y.aoMap,Ke=!!y.lightMap,Mn=!!y.bumpMap&&y.wireframe===!1,Ve=!!y.normalMap,kn=!!y.displacementMap,Re=!!y.emissiveMap,In=!!y.metalnessMap,fn=!!y.roughnessMap,Sn=y.anisotropy>0,k=y.clearcoat>0,Lt=y.diffuseRoughness>0,Qt=y.dispersion>0,he=y.retroreflectivity>0,Tt=y.iridescence>0,Xe=y.sheen>0,Xt=y.transmission>0,Kt=Sn&&!!y.anisotropyMap,I=k&&!!y.clearcoatMap,T=k&&!!y.clearcoatNormalMap,$=k&&!!y.clearcoatRoughnessMap,ht=Lt&&!!y.diffuseRoughnessMap,at=Tt&&!!y.iridescenceMap,vt=Tt&&!!y.iridescenceThicknessMap,Mt=Xe&&!!y.sheenColorMap,nt=Xe&&!!y.sheenRoughnessMap,st=!!y.specularMap,mt=!!y.specularColorMap,B=!!y.specularIntensityMap,ot=Xt&&!!y.transmissionMap,it=Xt&&!!y.thicknessMap,At=!!y.gradientMap,xt=!!y.alphaMap,wt=y.alphaTest>0,Yt=!!y.alphaHash,se=!!y.extensions,ct=Ns;y.toneMapped&&(Pt===null||Pt.isXRRenderTarget===!0)&&(ct=n.toneMapping);let Gt=le?q.isCompressedCubeTexture?q.image[0].mipmaps:q.mipmaps:null,re={shaderID:ut,shaderType:y.type,shaderName:y.name,vertexShader:ft,fragmentShader:et,defines:y.defines,customVertexShaderID:_t,customFragmentShaderID:bt,isRawShaderMaterial:y.isRawShaderMaterial===!0,glslVersion:y.glslVersion,precision:j,batching:ue,batchingColor:ue&&N._colorsTexture!==null,instancing:Zt,instancingColor:Zt&&N.instanceColor!==null,instancingMorph:Zt&&N.morphTexture!==null,outputColorSpace:Pt===null?n.outputColorSpace:Pt.isXRRenderTarget===!0?Pt.texture.colorSpace:Ee.workingColorSpace,alphaToCoverage:!!y.alphaToCoverage,map:$t,matcap:xe,envMap:me,envMapMode:me&&q.mapping,envMapPMREM:le,envMapMaxLod:le?Gt.length-1:null,envMapSize:le?Gt[0].width:null,aoMap:an,lightMap:Ke,bumpMap:Mn,normalMap:Ve,displacementMap:kn,emissiveMap:Re,normalMapObjectSpace:Ve&&y.normalMapType===g_,normalMapTangentSpace:Ve&&y.normalMapType===Sp,packedNormalMap:Ve&&y.normalMapType===Sp&&IT(y.normalMap.format),metalnessMap:In,roughnessMap:fn,anisotropy:Sn,anisotropyMap:Kt,clearcoat:k,clearcoatMap:I,clearcoatNormalMap:T,clearcoatRoughnessMap:$,diffuseRoughness:Lt,diffuseRoughnessMap:ht,dispersion:Qt,retroreflection:he,iridescence:Tt,iridescenceMap:at,iridescenceThicknessMap:vt,sheen:Xe,sheenColorMap:Mt,sheenRoughnessMap:nt,specularMap:st,specularColorMap:mt,specularIntensityMap:B,transmission:Xt,transmissionMap:ot,thicknessMap:it,gradientMap:At,opaque:y.transparent===!1&&y.blending===wa&&y.alphaToCoverage===!1,alphaMap:xt,alphaTest:wt,alphaHash:Yt,combine:y.combine,mapUv:$t&&d(y.map.channel),aoMapUv:an&&d(y.aoMap.channel),lightMapUv:Ke&&d(y.lightMap.channel),bumpMapUv:Mn&&d(y.bumpMap.channel),normalMapUv:Ve&&d(y.normalMap.channel),displacementMapUv:kn&&d(y.displacementMap.channel),emissiveMapUv:Re&&d(y.emissiveMap.channel),metalnessMapUv:In&&d(y.metalnessMap.channel),roughnessMapUv:fn&&d(y.roughnessMap.channel),anisotropyMapUv:Kt&&d(y.anisotropyMap.channel),clearcoatMapUv:I&&d(y.clearcoatMap.channel),clearcoatNormalMapUv:T&&d(y.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:$&&d(y.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ht&&d(y.diffuseRoughnessMap.channel),iridescenceMapUv:at&&d(y.iridescenceMap.channel),iridescenceThicknessMapUv:vt&&d(y.iridescenceThicknessMap.channel),sheenColorMapUv:Mt&&d(y.sheenColorMap.channel),sheenRoughnessMapUv:nt&&d(y.sheenRoughnessMap.channel),specularMapUv:st&&d(y.specularMap.channel),specularColorMapUv:mt&&d(y.specularColorMap.channel),specularIntensityMapUv:B&&d(y.specularIntensityMap.channel),transmissionMapUv:ot&&d(y.transmissionMap.channel),thicknessMapUv:it&&d(y.thicknessMap.channel),alphaMapUv:xt&&d(y.alphaMap.channel),vertexTangents:!!O.attributes.tangent&&(Ve||Sn),vertexNormals:!!O.attributes.normal,vertexColors:y.vertexColors,vertexAlphas:y.vertexColors===!0&&!!O.attributes.color&&O.attributes.color.itemSize===4,pointsUvs:N.isPoints===!0&&!!O.attributes.uv&&($t||xt),fog:!!W,useFog:y.fog===!0,fogExp2:!!W&&W.isFogExp2,flatShading:y.wireframe===!1&&(y.flatShading===!0||O.attributes.normal===void 0&&Ve===!1&&(y.isMeshLambertMaterial||y.isMeshPhongMaterial||y.isMeshStandardMaterial||y.isMeshPhysicalMaterial)),sizeAttenuation:y.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:Et,skinning:N.isSkinnedMesh===!0,hasPositionAttribute:O.attributes.position!==void 0,morphTargets:O.morphAttributes.position!==void 0,morphNormals:O.morphAttributes.normal!==void 0,morphColors:O.morphAttributes.color!==void 0,morphTargetsCount:rt,morphTextureStride:dt,numSunLights:w.sun.length,numDirLights:w.directional.length,numPointLights:w.point.length,numSpotLights:w.spot.length,numSpotLightMaps:w.spotLightMap.length,numRectAreaLights:w.rectArea.length,numHemiLights:w.hemi.length,numSunLightShadows:w.sunShadowMap.length,numDirLightShadows:w.directionalShadowMap.length,numPointLightShadows:w.pointShadowMap.length,numSpotLightShadows:w.spotShadowMap.length,numSpotLightShadowsWithMaps:w.numSpotLightShadowsWithMaps,numLightProbes:w.numLightProbes,numLightProbeGrids:z.filter(It=>It.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:y.dithering,shadowMapEnabled:n.shadowMap.enabled&&U.length>0,shadowMapType:n.shadowMap.type,toneMapping:ct,decodeVideoTexture:$t&&y.map.isVideoTexture===!0&&Ee.getTransfer(y.map.colorSpace)===Oe,decodeVideoTextureEmissive:Re&&y.emissiveMap.isVideoTexture===!0&&Ee.getTransfer(y.emissiveMap.colorSpace)===Oe,premultipliedAlpha:y.premultipliedAlpha,doubleSided:y.side===Ji,flipSided:y.side===mi,useDepthPacking:y.depthPacking>=0,depthPacking:y.depthPacking||0,index0AttributeName:y.index0AttributeName,extensionClipCullDistance:se&&y.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(se&&y.extensions.multiDraw===!0||ue)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:y.customProgramCacheKey()};return re.vertexUv1s=c.has(1),re.vertexUv2s=c.has(2),re.vertexUv3s=c.has(3),c.clear(),re}function _(y){let w=[];if(y.shaderID?w.push(y.shaderID):(w.push(y.customVertexShaderID),w.push(y.customFragmentShaderID)),y.defines!==void 0)for(let U in y.defines)w.push(U),w.push(y.defines[U]);return y.isRawShaderMaterial===!1&&(p(w,y),m(w,y),w.push(n.outputColorSpace)),w.push(y.customProgramCacheKey),w.join()}function p(y,w){y.push(w.precision),y.push(w.outputColorSpace),y.push(w.envMapMode),y.push(w.envMapPMREM),y.push(w.envMapMaxLod),y.push(w.envMapSize),y.push(w.mapUv),y.push(w.alphaMapUv),y.push(w.lightMapUv),y.push(w.aoMapUv),y.push(w.bumpMapUv),y.push(w.normalMapUv),y.push(w.displacementMapUv),y.push(w.emissiveMapUv),y.push(w.metalnessMapUv),y.push(w.roughnessMapUv),y.push(w.anisotropyMapUv),y.push(w.clearcoatMapUv),y.push(w.clearcoatNormalMapUv),y.push(w.clearcoatRoughnessMapUv),y.push(w.diffuseRoughnessMapUv),y.push(w.iridescenceMapUv),y.push(w.iridescenceThicknessMapUv),y.push(w.sheenColorMapUv),y.push(w.sheenRoughnessMapUv),y.push(w.specularMapUv),y.push(w.specularColorMapUv),y.push(w.specularIntensityMapUv),y.push(w.transmissionMapUv),y.push(w.thicknessMapUv),y.push(w.combine),y.push(w.fogExp2),y.push(w.sizeAttenuation),y.push(w.morphTargetsCount),y.push(w.numSunLights),y.push(w.numDirLights),y.push(w.numPointLights),y.push(w.numSpotLights),y.push(w.numSpotLightMaps),y.push(w.numHemiLights),y.push(w.numRectAreaLights),y.push(w.numSunLightShadows),y.push(w.numDirLightShadows),y.push(w.numPointLightShadows),y.push(w.numSpotLightShadows),y.push(w.numSpotLightShadowsWithMaps),y.push(w.numLightProbes),y.push(w.numLightProbeGrids),y.push(w.shadowMapType),y.push(w.toneMapping),y.push(w.numClippingPlanes),y.push(w.numClipIntersection),y.push(w.depthPacking)}function m(y,w){o.disableAll(),w.instancing&&o.enable(0),w.instancingColor&&o.enable(1),w.instancingMorph&&o.enable(2),w.matcap&&o.enable(3),w.envMap&&o.enable(4),w.normalMapObjectSpace&&o.enable(5),w.normalMapTangentSpace&&o.enable(6),w.clearcoat&&o.enable(7),w.iridescence&&o.enable(8),w.alphaTest&&o.enable(9),w.vertexColors&&o.enable(10),w.vertexAlphas&&o.enable(11),w.vertexUv1s&&o.enable(12),w.vertexUv2s&&o.enable(13),w.vertexUv3s&&o.enable(14),w.vertexTangents&&o.enable(15),w.anisotropy&&o.enable(16),w.alphaHash&&o.enable(17),w.batching&&o.enable(18),w.dispersion&&o.enable(19),w.retroreflection&&o.enable(24),w.diffuseRoughness&&o.enable(25),w.batchingColor&&o.enable(20),w.gradientMap&&o.enable(21),w.packedNormalMap&&o.enable(22),w.vertexNormals&&o.enable(23),y.push(o.mask),o.disableAll(),w.fog&&o.enable(0),w.useFog&&o.enable(1),w.flatShading&&o.enable(2),w.logarithmicDepthBuffer&&o.enable(3),w.reversedDepthBuffer&&o.enable(4),w.skinning&&o.enable(5),w.morphTargets&&o.enable(6),w.morphNormals&&o.enable(7),w.morphColors&&o.enable(8),w.premultipliedAlpha&&o.enable(9),w.shadowMapEnabled&&o.enable(10),w.doubleSided&&o.enable(11),w.flipSided&&o.enable(12),w.useDepthPacking&&o.enable(13),w.dithering&&o.enable(14),w.transmission&&o.enable(15),w.sheen&&o.enable(16),w.opaque&&o.enable(17),w.pointsUvs&&o.enable(18),w.decodeVideoTexture&&o.enable(19),w.decodeVideoTextureEmissive&&o.enable(20),w.alphaToCoverage&&o.enable(21),w.numLightProbeGrids>0&&o.enable(22),w.hasPositionAttribute&&o.enable(23),y.push(o.mask)}function x(y){let w=f[y.type],U;if(w){let L=Fs[w];U=C_.clone(L.uniforms)}else U=y.uniforms;return U}function M(y,w){let U=u.get(w);return U!==void 0?++U.usedTimes:(U=new CT(n,w,y,s),l.push(U),u.set(w,U)),U}function v(y){if(--y.usedTimes===0){let w=l.indexOf(y);l[w]=l[l.length-1],l.pop(),u.delete(y.cacheKey),y.destroy()}}function A(y){a.remove(y)}function S(){a.dispose()}return{getParameters:g,getProgramCacheKey:_,getUniforms:x,acquireProgram:M,releaseProgram:v,releaseShaderCache:A,programs:l,dispose:S}}function DT(){let n=new WeakMap;function t(o){return n.has(o)}function e(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,c){n.get(o)[a]=c}function r(){n=new WeakMap}return{has:t,get:e,remove:i,update:s,dispose:r}}function NT(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.material.id!==t.material.id?n.material.id-t.material.id:n.materialVariant!==t.materialVariant?n.materialVariant-t.materialVariant:n.z!==t.z?n.z-t.z:n.id-t.id}function Z_(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.z!==t.z?t.z-n.z:n.id-t.id}function J_(){let n=[],t=0,e=[],i=[],s=[];function r(){t=0,e.length=0,i.length=0,s.length=0}function o(f){let d=0;return f.isInstancedMesh&&(d+=2),f.isSkinnedMesh&&(d+=1),d}function a(f,d,g,_,p,m){let x=n[t];return x===void 0?(x={id:f.id,object:f,geometry:d,material:g,materialVariant:o(f),groupOrder:_,renderOrder:f.renderOrder,z:p,group:m},n[t]=x):(x.id=f.id,x.object=f,x.geometry=d,x.material=g,x.materialVariant=o(f),x.groupOrder=_,x.renderOrder=f.renderOrder,x.z=p,x.group=m),t++,x}function c(f,d,g,_,p,m,x){x.reversedDepth===!0&&(p=-p);let M=a(f,d,g,_,p,m);g.transmission>0?i.push(M):g.transparent===!0?s.push(M):e.push(M)}function l(f,d,g,_,p,m){let x=a(f,d,g,_,p,m);g.transmission>0?i.unshift(x):g.transparent===!0?s.unshift(x):e.unshift(x)}function u(f,d){e.length>1&&e.sort(f||NT),i.length>1&&i.sort(d||Z_),s.length>1&&s.sort(d||Z_)}function h(){for(let f=t,d=n.length;f<d;f++){let g=n[f];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:e,transmissive:i,transparent:s,init:r,push:c,unshift:l,finish:h,sort:u}}function UT(){let n=new WeakMap;function t(i,s){let r=n.get(i),o;return r===void 0?(o=new J_,n.set(i,[o])):s>=r.length?(o=new J_,r.push(o)):o=r[s],o}function e(){n=new WeakMap}return{get:t,dispose:e}}function FT(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new H,color:new ee};break;case"SpotLight":e={position:new H,direction:new H,color:new ee,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new H,color:new ee,distance:0,decay:0};break;case"HemisphereLight":e={direction:new H,skyColor:new ee,groundColor:new ee};break;case"RectAreaLight":e={color:new ee,position:new H,halfWidth:new H,halfHeight:new H};break}return n[t.id]=e,e}}}function OT(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new qt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new qt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new qt,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[t.id]=e,e}}}var BT=0;function kT(n,t){return(t.castShadow?2:0)-(n.castShadow?2:0)+(t.map?1:0)-(n.map?1:0)}function zT(n){let t=new FT,e=OT(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let l=0;l<9;l++)i.probe.push(new H);let s=new H,r=new Te,o=new Te;function a(l){let u=0,h=0,f=0;for(let z=0;z<9;z++)i.probe[z].set(0,0,0);let d=0,g=0,_=0,p=0,m=0,x=0,M=0,v=0,A=0,S=0,y=0,w=0,U=0,L=0;l.sort(kT);for(let z=0,W=l.length;z<W;z++){let O=l[z],X=O.color,Z=O.intensity,q=O.distance,ut=null;if(O.shadow&&O.shadow.map&&(O.shadow.map.texture.format===kr?ut=O.shadow.map.texture:ut=O.shadow.map.depthTexture||O.shadow.map.texture),O.isAmbientLight)u+=X.r*Z,h+=X.g*Z,f+=X.b*Z;else if(O.isLightProbe){for(let j=0;j<9;j++)i.probe[j].addScaledVector(O.sh.coefficients[j],Z);L++}else if(O.isSunLight){let j=t.get(O);if(j.color.copy(O.color).multiplyScalar(O.intensity),O.castShadow){let tt=O.shadow,rt=e.get(O);rt.shadowIntensity=tt.intensity,rt.shadowBias=tt.bias,rt.shadowNormalBias=tt.normalBias,rt.shadowRadius=tt.radius,rt.shadowMapSize.copy(tt.mapSize).multiply(tt.getFrameExtents()),i.sunShadow[g]=rt,i.sunShadowMap[g]=ut;let dt=tt.getViewportCount();for(let ft=0;ft<dt;ft++)i.sunShadowMatrix[_+ft]=tt.getMatrix(ft),i.sunShadowCascade[_+ft]=tt._cascadeData[ft];_+=dt,g++}i.sun[d]=j,d++}else if(O.isDirectionalLight){let j=t.get(O);if(j.color.copy(O.color).multiplyScalar(O.intensity),O.castShadow){let tt=O.shadow,rt=e.get(O);rt.shadowIntensity=tt.intensity,rt.shadowBias=tt.bias,rt.shadowNormalBias=tt.normalBias,rt.shadowRadius=tt.radius,rt.shadowMapSize=tt.mapSize,i.directionalShadow[p]=rt,i.directionalShadowMap[p]=ut,i.directionalShadowMatrix[p]=O.shadow.matrix,A++}i.directional[p]=j,p++}else if(O.isSpotLight){let j=t.get(O);j.position.setFromMatrixPosition(O.matrixWorld),j.color.copy(X).multiplyScalar(Z),j.distance=q,j.coneCos=Math.cos(O.angle),j.penumbraCos=Math.cos(O.angle*(1-O.penumbra)),j.decay=O.decay,i.spot[x]=j;let tt=O.shadow;if(O.map&&(i.spotLightMap[w]=O.map,w++,tt.updateMatrices(O),O.castShadow&&U++),i.spotLightMatrix[x]=tt.matrix,O.castShadow){let rt=e.get(O);rt.shadowIntensity=tt.intensity,rt.shadowBias=tt.bias,rt.shadowNormalBias=tt.normalBias,rt.shadowRadius=tt.radius,rt.shadowMapSize=tt.mapSize,i.spotShadow[x]=rt,i.spotShadowMap[x]=ut,y++}x++}else if(O.isRectAreaLight){let j=t.get(O);j.color.copy(X).multiplyScalar(Z),j.halfWidth.set(O.width*.5,0,0),j.halfHeight.set(0,O.height*.5,0),i.rectArea[M]=j,M++}else if(O.isPointLight){let j=t.get(O);if(j.color.copy(O.color).multiplyScalar(O.intensity),j.distance=O.distance,j.decay=O.decay,O.castShadow){let tt=O.shadow,rt=e.get(O);rt.shadowIntensity=tt.intensity,rt.shadowBias=tt.bias,rt.shadowNormalBias=tt.normalBias,rt.shadowRadius=tt.radius,rt.shadowMapSize=tt.mapSize,rt.shadowCameraNear=tt.camera.near,rt.shadowCameraFar=tt.camera.far,i.pointShadow[m]=rt,i.pointShadowMap[m]=ut,i.pointShadowMatrix[m]=O.shadow.matrix,S++}i.point[m]=j,m++}else if(O.isHemisphereLight){let j=t.get(O);j.skyColor.copy(O.color).multiplyScalar(Z),j.groundColor.copy(O.groundColor).multiplyScalar(Z),i.hemi[v]=j,v++}}M>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Ot.LTC_FLOAT_1,i.rectAreaLTC2=Ot.LTC_FLOAT_2):(i.rectAreaLTC1=Ot.LTC_HALF_1,i.rectAreaLTC2=Ot.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=h,i.ambient[2]=f;let N=i.hash;(N.sunLength!==d||N.directionalLength!==p||N.pointLength!==m||N.spotLength!==x||N.rectAreaLength!==M||N.hemiLength!==v||N.numSunShadows!==g||N.numDirectionalShadows!==A||N.numPointShadows!==S||N.numSpotShadows!==y||N.numSpotMaps!==w||N.numLightProbes!==L)&&(i.sun.length=d,i.directional.length=p,i.spot.length=x,i.rectArea.length=M,i.point.length=m,i.hemi.length=v,i.sunShadow.length=g,i.sunShadowMap.length=g,i.sunShadowMatrix.length=_,i.sunShadowCascade.length=_,i.directionalShadow.length=A,i.directionalShadowMap.length=A,i.directionalShadowMatrix.length=A,i.pointShadow.length=S,i.pointShadowMap.length=S,i.pointShadowMatrix.length=S,i.spotShadow.length=y,i.spotShadowMap.length=y,i.spotLightMatrix.length=y+w-U,i.spotLightMap.length=w,i.numSpotLightShadowsWithMaps=U,i.numLightProbes=L,N.sunLength=d,N.directionalLength=p,N.pointLength=m,N.spotLength=x,N.rectAreaLength=M,N.hemiLength=v,N.numSunShadows=g,N.numDirectionalShadows=A,N.numPointShadows=S,N.numSpotShadows=y,N.numSpotMaps=w,N.numLightProbes=L,i.version=BT++)}function c(l,u){let h=0,f=0,d=0,g=0,_=0,p=0,m=u.matrixWorldInverse;for(let x=0,M=l.length;x<M;x++){let v=l[x];if(v.isSunLight){let A=i.sun[h];A.direction.setFromMatrixPosition(v.matrixWorld),A.direction.transformDirection(m),h++}else if(v.isDirectionalLight){let A=i.directional[f];A.direction.setFromMatrixPosition(v.matrixWorld),s.setFromMatrixPosition(v.target.matrixWorld),A.direction.sub(s),A.direction.transformDirection(m),f++}else if(v.isSpotLight){let A=i.spot[g];A.position.setFromMatrixPosition(v.matrixWorld),A.position.applyMatrix4(m),A.direction.setFromMatrixPosition(v.matrixWorld),s.setFromMatrixPosition(v.target.matrixWorld),A.direction.sub(s),A.direction.transformDirection(m),g++}else if(v.isRectAreaLight){let A=i.rectArea[_];A.position.setFromMatrixPosition(v.matrixWorld),A.position.applyMatrix4(m),o.identity(),r.copy(v.matrixWorld),r.premultiply(m),o.extractRotation(r),A.halfWidth.set(v.width*.5,0,0),A.halfHeight.set(0,v.height*.5,0),A.halfWidth.applyMatrix4(o),A.halfHeight.applyMatrix4(o),_++}else if(v.isPointLight){let A=i.point[d];A.position.setFromMatrixPosition(v.matrixWorld),A.position.applyMatrix4(m),d++}else if(v.isHemisphereLight){let A=i.hemi[p];A.direction.setFromMatrixPosition(v.matrixWorld),A.direction.transformDirection(m),p++}}}return{setup:a,setupView:c,state:i}}function K_(n){let t=new zT(n),e=[],i=[],s=[];function r(h){u.camera=h,e.length=0,i.length=0,s.length=0}function o(h){h.isLightProbeGrid?s.push(h):e.push(h)}function a(h){i.push(h)}function c(){t.setup(e),s.sort((h,f)=>h.priority-f.priority||h.id-f.id)}function l(h){t.setupView(e,h)}let u={lightsArray:e,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:c,setupLightsView:l,pushLight:o,pushShadow:a}}function HT(n){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new K_(n),t.set(s,[a])):r>=o.length?(a=new K_(n),o.push(a)):a=o[r],a}function i(){t=new WeakMap}return{get:e,dispose:i}}var GT=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,VT=`uniform sampler2D shadow_pass;
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
}`,WT=[new H(1,0,0),new H(-1,0,0),new H(0,1,0),new H(0,-1,0),new H(0,0,1),new H(0,0,-1)],qT=[new H(0,-1,0),new H(0,-1,0),new H(0,0,1),new H(0,0,-1),new H(0,-1,0),new H(0,-1,0)],j_=new Te,tc=new H,zp=new H;function XT(n,t,e){let i=new oo,s=new qt,r=new qt,o=new hn,a=new zu,c=new Hu,l={},u=e.maxTextureSize,h={[Br]:mi,[mi]:Br,[Ji]:Ji},f=new Zi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new qt},radius:{value:4}},vertexShader:GT,fragmentShader:VT}),d=f.clone();d.defines.HORIZONTAL_PASS=1;let g=new De;g.setAttribute("position",new sn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let _=new ei(g,f),p=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Xl;let m=this.type;this.render=function(S,y,w){if(p.enabled===!1||p.autoUpdate===!1&&p.needsUpdate===!1||S.length===0)return;this.type===$0&&(jt("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Xl);let U=n.getRenderTarget(),L=n.getActiveCubeFace(),N=n.getActiveMipmapLevel(),z=n.state;z.setBlending(ho),z.buffers.depth.getReversed()===!0?z.buffers.color.setClear(0,0,0,0):z.buffers.color.setClear(1,1,1,1),z.buffers.depth.setTest(!0),z.setScissorTest(!1);let W=m!==this.type;W&&y.traverse(function(O){O.material&&(Array.isArray(O.material)?O.material.forEach(X=>X.needsUpdate=!0):O.material.needsUpdate=!0)});for(let O=0,X=S.length;O<X;O++){let Z=S[O],q=Z.shadow;if(q===void 0){jt("WebGLShadowMap:",Z,"has no shadow.");continue}if(q.autoUpdate===!1&&q.needsUpdate===!1)continue;s.copy(q.mapSize);let ut=q.getFrameExtents();s.multiply(ut),r.copy(q.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/ut.x),s.x=r.x*ut.x,q.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/ut.y),s.y=r.y*ut.y,q.mapSize.y=r.y));let j=n.state.buffers.depth.getReversed();if(q.camera._reversedDepth=j,q.map===null||W===!0){if(q.map!==null&&(q.map.depthTexture!==null&&(q.map.depthTexture.dispose(),q.map.depthTexture=null),q.map.dispose()),this.type===Sa){if(Z.isPointLight){jt("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}q.map=new Fi(s.x,s.y,{format:kr,type:hs,minFilter:fi,magFilter:fi,generateMipmaps:!1}),q.map.texture.name=Z.name+".shadowMap",q.map.depthTexture=new or(s.x,s.y,Ki),q.map.depthTexture.name=Z.name+".shadowMapDepth",q.map.depthTexture.format=ir,q.map.depthTexture.compareFunction=null,q.map.depthTexture.minFilter=qn,q.map.depthTexture.magFilter=qn}else Z.isPointLight?(q.map=new nc(s.x),q.map.depthTexture=new Ol(s.x,us)):(q.map=new Fi(s.x,s.y),q.map.depthTexture=new or(s.x,s.y,us)),q.map.depthTexture.name=Z.name+".shadowMap",q.map.depthTexture.format=ir,this.type===Xl?(q.map.depthTexture.compareFunction=j?Ap:Tp,q.map.depthTexture.minFilter=fi,q.map.depthTexture.magFilter=fi):(q.map.depthTexture.compareFunction=null,q.map.depthTexture.minFilter=qn,q.map.depthTexture.magFilter=qn);q.camera.updateProjectionMatrix()}q.map.isWebGLCubeRenderTarget!==!0&&(q.map.width!==s.x||q.map.height!==s.y)&&q.map.setSize(s.x,s.y);let tt=q.map.isWebGLCubeRenderTarget?6:q.getViewportCount();Z.isPointLight!==!0&&q.updateMatrices(Z,w);let rt=(q.camera.layers.mask&4294967294)!==0?q.camera.layers:w.layers;for(let dt=0;dt<tt;dt++){let ft=q.getCamera(dt);if(Z.isPointLight){let et=q.camera,_t=q.matrix,bt=Z.distance||et.far;bt!==et.far&&(et.far=bt,et.updateProjectionMatrix()),tc.setFromMatrixPosition(Z.matrixWorld),et.position.copy(tc),zp.copy(et.position),zp.add(WT[dt]),et.up.copy(qT[dt]),et.lookAt(zp),et.updateMatrixWorld(),_t.makeTranslation(-tc.x,-tc.y,-tc.z),j_.multiplyMatrices(et.projectionMatrix,et.matrixWorldInverse),q._frustum.setFromProjectionMatrix(j_,et.coordinateSystem,et.reversedDepth)}if(q.map.isWebGLCubeRenderTarget)n.setRenderTarget(q.map,dt),n.clear();else{dt===0&&(n.setRenderTarget(q.map),n.clear());let et=q.getViewport(dt);o.set(r.x*et.x,r.y*et.y,r.x*et.z,r.y*et.w),z.viewport(o)}i=q.getFrustum(dt),v(y,w,ft,Z,rt,this.type)}q.isPointLightShadow!==!0&&this.type===Sa&&x(q,w),q.needsUpdate=!1}m=this.type,p.needsUpdate=!1,n.setRenderTarget(U,L,N)};function x(S,y){let w=t.update(_);f.defines.VSM_SAMPLES!==S.blurSamples&&(f.defines.VSM_SAMPLES=S.blurSamples,d.defines.VSM_SAMPLES=S.blurSamples,f.needsUpdate=!0,d.needsUpdate=!0),S.mapPass===null?S.mapPass=new Fi(s.x,s.y,{format:kr,type:hs}):(S.mapPass.width!==S.map.width||S.mapPass.height!==S.map.height)&&S.mapPass.setSize(S.map.width,S.map.height),f.uniforms.shadow_pass.value=S.map.depthTexture,f.uniforms.resolution.value.set(S.map.width,S.map.height),f.uniforms.radius.value=S.radius,n.setRenderTarget(S.mapPass),n.clear(),n.renderBufferDirect(y,null,w,f,_,null),d.uniforms.shadow_pass.value=S.mapPass.texture,d.uniforms.resolution.value.set(S.map.width,S.map.height),d.uniforms.radius.value=S.radius,n.setRenderTarget(S.map),n.clear(),n.renderBufferDirect(y,null,w,d,_,null)}function M(S,y,w,U){let L=null,N=w.isPointLight===!0?S.customDistanceMaterial:S.customDepthMaterial;if(N!==void 0)L=N;else if(L=w.isPointLight===!0?c:a,n.localClippingEnabled&&y.clipShadows===!0&&Array.isArray(y.clippingPlanes)&&y.clippingPlanes.length!==0||y.displacementMap&&y.displacementScale!==0||y.alphaMap&&y.alphaTest>0||y.map&&y.alphaTest>0||y.alphaToCoverage===!0){let z=L.uuid,W=y.uuid,O=l[z];O===void 0&&(O={},l[z]=O);let X=O[W];X===void 0&&(X=L.clone(),O[W]=X,y.addEventListener("dispose",A)),L=X}if(L.visible=y.visible,L.wireframe=y.wireframe,U===Sa?L.side=y.shadowSide!==null?y.shadowSide:y.side:L.side=y.shadowSide!==null?y.shadowSide:h[y.side],L.alphaMap=y.alphaMap,L.alphaTest=y.alphaToCoverage===!0?.5:y.alphaTest,L.map=y.map,L.clipShadows=y.clipShadows,L.clippingPlanes=y.clippingPlanes,L.clipIntersection=y.clipIntersection,L.displacementMap=y.displacementMap,L.displacementScale=y.displacementScale,L.displacementBias=y.displacementBias,L.wireframeLinewidth=y.wireframeLinewidth,L.linewidth=y.linewidth,w.isPointLight===!0&&L.isMeshDistanceMaterial===!0){let z=n.properties.get(L);z.light=w}return L}function v(S,y,w,U,L,N){if(S.visible===!1)return;if(S.layers.test(L)&&(S.isMesh||S.isLine||S.isPoints)&&(S.castShadow||S.receiveShadow&&N===Sa)&&(!S.frustumCulled||S.intersectsFrustum(i))){S.modelViewMatrix.multiplyMatrices(w.matrixWorldInverse,S.matrixWorld);let O=t.update(S),X=S.material;if(Array.isArray(X)){let Z=O.groups;for(let q=0,ut=Z.length;q<ut;q++){let j=Z[q],tt=X[j.materialIndex];if(tt&&tt.visible){let rt=M(S,tt,U,N);S.onBeforeShadow(n,S,y,w,O,rt,j),n.renderBufferDirect(w,null,O,rt,S,j),S.onAfterShadow(n,S,y,w,O,rt,j)}}}else if(X.visible){let Z=M(S,X,U,N);S.onBeforeShadow(n,S,y,w,O,Z,null),n.renderBufferDirect(w,null,O,Z,S,null),S.onAfterShadow(n,S,y,w,O,Z,null)}}let W=S.children;for(let O=0,X=W.length;O<X;O++)v(W[O],y,w,U,L,N)}function A(S){S.target.removeEventListener("dispose",A);for(let w in l){let U=l[w],L=S.target.uuid;L in U&&(U[L].dispose(),delete U[L])}}}function $T(n,t){function e(){let B=!1,ot=new hn,it=null,At=new hn(0,0,0,0);return{setMask:function(xt){it!==xt&&!B&&(n.colorMask(xt,xt,xt,xt),it=xt)},setLocked:function(xt){B=xt},setClear:function(xt,wt,Yt,se,ct){ct===!0&&(xt*=se,wt*=se,Yt*=se),ot.set(xt,wt,Yt,se),At.equals(ot)===!1&&(n.clearColor(xt,wt,Yt,se),At.copy(ot))},reset:function(){B=!1,it=null,At.set(-1,0,0,0)}}}function i(){let B=!1,ot=!1,it=null,At=null,xt=null;return{setReversed:function(wt){if(ot!==wt){let Yt=t.get("EXT_clip_control");wt?Yt.clipControlEXT(Yt.LOWER_LEFT_EXT,Yt.ZERO_TO_ONE_EXT):Yt.clipControlEXT(Yt.LOWER_LEFT_EXT,Yt.NEGATIVE_ONE_TO_ONE_EXT),ot=wt;let se=xt;xt=null,this.setClear(se)}},getReversed:function(){return ot},setTest:function(wt){wt?Et(n.DEPTH_TEST):Zt(n.DEPTH_TEST)},setMask:function(wt){it!==wt&&!B&&(n.depthMask(wt),it=wt)},setFunc:function(wt){if(ot&&(wt=T_[wt]),At!==wt){switch(wt){case Mu:n.depthFunc(n.NEVER);break;case Su:n.depthFunc(n.ALWAYS);break;case wu:n.depthFunc(n.LESS);break;case ua:n.depthFunc(n.LEQUAL);break;case Eu:n.depthFunc(n.EQUAL);break;case Tu:n.depthFunc(n.GEQUAL);break;case Au:n.depthFunc(n.GREATER);break;case Ru:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}At=wt}},setLocked:function(wt){B=wt},setClear:function(wt){xt!==wt&&(xt=wt,ot&&(wt=1-wt),n.clearDepth(wt))},reset:function(){B=!1,it=null,At=null,xt=null,ot=!1}}}function s(){let B=!1,ot=null,it=null,At=null,xt=null,wt=null,Yt=null,se=null,ct=null;return{setTest:function(Gt){B||(Gt?Et(n.STENCIL_TEST):Zt(n.STENCIL_TEST))},setMask:function(Gt){ot!==Gt&&!B&&(n.stencilMask(Gt),ot=Gt)},setFunc:function(Gt,re,It){(it!==Gt||At!==re||xt!==It)&&(n.stencilFunc(Gt,re,It),it=Gt,At=re,xt=It)},setOp:function(Gt,re,It){(wt!==Gt||Yt!==re||se!==It)&&(n.stencilOp(Gt,re,It),wt=Gt,Yt=re,se=It)},setLocked:function(Gt){B=Gt},setClear:function(Gt){ct!==Gt&&(n.clearStencil(Gt),ct=Gt)},reset:function(){B=!1,ot=null,it=null,At=null,xt=null,wt=null,Yt=null,se=null,ct=null}}}let r=new e,o=new i,a=new s,c={},l=new WeakMap,u={},h={},f={},d=new WeakMap,g=[],_=null,p=!1,m=null,x=null,M=null,v=null,A=null,S=null,y=null,w=new ee(0,0,0),U=0,L=!1,N=null,z=null,W=null,O=null,X=null,Z=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),q=!1,ut=0,j=n.getParameter(n.VERSION);j.indexOf("WebGL")!==-1?(ut=parseFloat(/^WebGL (\d)/.exec(j)[1]),q=ut>=1):j.indexOf("OpenGL ES")!==-1&&(ut=parseFloat(/^OpenGL ES (\d)/.exec(j)[1]),q=ut>=2);let tt=null,rt={},dt=n.getParameter(n.SCISSOR_BOX),ft=n.getParameter(n.VIEWPORT),et=new hn().fromArray(dt),_t=new hn().fromArray(ft);function bt(B,ot,it,At){let xt=new Uint8Array(4),wt=n.createTexture();n.bindTexture(B,wt),n.texParameteri(B,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(B,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Yt=0;Yt<it;Yt++)B===n.TEXTURE_3D||B===n.TEXTURE_2D_ARRAY?n.texImage3D(ot,0,n.RGBA,1,1,At,0,n.RGBA,n.UNSIGNED_BYTE,xt):n.texImage2D(ot+Yt,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,xt);return wt}let Pt={};Pt[n.TEXTURE_2D]=bt(n.TEXTURE_2D,n.TEXTURE_2D,1),Pt[n.TEXTURE_CUBE_MAP]=bt(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Pt[n.TEXTURE_2D_ARRAY]=bt(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Pt[n.TEXTURE_3D]=bt(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),Et(n.DEPTH_TEST),o.setFunc(ua),Mn(!1),Ve(np),Et(n.CULL_FACE),an(ho);function Et(B){u[B]!==!0&&(n.enable(B),u[B]=!0)}function Zt(B){u[B]!==!1&&(n.disable(B),u[B]=!1)}function ue(B,ot){return f[B]!==ot?(n.bindFramebuffer(B,ot),f[B]=ot,B===n.DRAW_FRAMEBUFFER&&(f[n.FRAMEBUFFER]=ot),B===n.FRAMEBUFFER&&(f[n.DRAW_FRAMEBUFFER]=ot),!0):!1}function $t(B,ot){let it=g,At=!1;if(B){it=d.get(ot),it===void 0&&(it=[],d.set(ot,it));let xt=B.textures;if(it.length!==xt.length||it[0]!==n.COLOR_ATTACHMENT0){for(let wt=0,Yt=xt.length;wt<Yt;wt++)it[wt]=n.COLOR_ATTACHMENT0+wt;it.length=xt.length,At=!0}}else it[0]!==n.BACK&&(it[0]=n.BACK,At=!0);At&&n.drawBuffers(it)}function xe(B){return _!==B?(n.useProgram(B),_=B,!0):!1}let me={[fo]:n.FUNC_ADD,[Z0]:n.FUNC_SUBTRACT,[J0]:n.FUNC_REVERSE_SUBTRACT};me[K0]=n.MIN,me[j0]=n.MAX;let le={[Q0]:n.ZERO,[t_]:n.ONE,[e_]:n.SRC_COLOR,[op]:n.SRC_ALPHA,[a_]:n.SRC_ALPHA_SATURATE,[r_]:n.DST_COLOR,[i_]:n.DST_ALPHA,[n_]:n.ONE_MINUS_SRC_COLOR,[ap]:n.ONE_MINUS_SRC_ALPHA,[o_]:n.ONE_MINUS_DST_COLOR,[s_]:n.ONE_MINUS_DST_ALPHA,[l_]:n.CONSTANT_COLOR,[c_]:n.ONE_MINUS_CONSTANT_COLOR,[u_]:n.CONSTANT_ALPHA,[h_]:n.ONE_MINUS_CONSTANT_ALPHA};function an(B,ot,it,At,xt,wt,Yt,se,ct,Gt){if(B===ho){p===!0&&(Zt(n.BLEND),p=!1);return}if(p===!1&&(Et(n.BLEND),p=!0),B!==Y0){if(B!==m||Gt!==L){if((x!==fo||A!==fo)&&(n.blendEquation(n.FUNC_ADD),x=fo,A=fo),Gt)switch(B){case wa:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case ip:n.blendFunc(n.ONE,n.ONE);break;case sp:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case rp:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:ie("WebGLState: Invalid blending: ",B);break}else switch(B){case wa:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case ip:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case sp:ie("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case rp:ie("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:ie("WebGLState: Invalid blending: ",B);break}M=null,v=null,S=null,y=null,w.set(0,0,0),U=0,m=B,L=Gt}return}xt=xt||ot,wt=wt||it,Yt=Yt||At,(ot!==x||xt!==A)&&(n.blendEquationSeparate(me[ot],me[xt]),x=ot,A=xt),(it!==M||At!==v||wt!==S||Yt!==y)&&(n.blendFuncSeparate(le[it],le[At],le[wt],le[Yt]),M=it,v=At,S=wt,y=Yt),(se.equals(w)===!1||ct!==U)&&(n.blendColor(se.r,se.g,se.b,ct),w.copy(se),U=ct),m=B,L=!1}function Ke(B,ot){B.side===Ji?Zt(n.CULL_FACE):Et(n.CULL_FACE);let it=B.side===mi;ot&&(it=!it),Mn(it),B.blending===wa&&B.transparent===!1?an(ho):an(B.blending,B.blendEquation,B.blendSrc,B.blendDst,B.blendEquationAlpha,B.blendSrcAlpha,B.blendDstAlpha,B.blendColor,B.blendAlpha,B.premultipliedAlpha),o.setFunc(B.depthFunc),o.setTest(B.depthTest),o.setMask(B.depthWrite),r.setMask(B.colorWrite);let At=B.stencilWrite;a.setTest(At),At&&(a.setMask(B.stencilWriteMask),a.setFunc(B.stencilFunc,B.stencilRef,B.stencilFuncMask),a.setOp(B.stencilFail,B.stencilZFail,B.stencilZPass)),Re(B.polygonOffset,B.polygonOffsetFactor,B.polygonOffsetUnits),B.alphaToCoverage===!0?Et(n.SAMPLE_ALPHA_TO_COVERAGE):Zt(n.SAMPLE_ALPHA_TO_COVERAGE)}function Mn(B){N!==B&&(B?n.frontFace(n.CW):n.frontFace(n.CCW),N=B)}function Ve(B){B!==q0?(Et(n.CULL_FACE),B!==z&&(B===np?n.cullFace(n.BACK):B===X0?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Zt(n.CULL_FACE),z=B}function kn(B){B!==W&&(q&&n.lineWidth(B),W=B)}function Re(B,ot,it){B?(Et(n.POLYGON_OFFSET_FILL),(O!==ot||X!==it)&&(O=ot,X=it,o.getReversed()&&(ot=-ot,it=-it),n.polygonOffset(ot,it))):Zt(n.POLYGON_OFFSET_FILL)}function In(B){B?Et(n.SCISSOR_TEST):Zt(n.SCISSOR_TEST)}function fn(B){B===void 0&&(B=n.TEXTURE0+Z-1),tt!==B&&(n.activeTexture(B),tt=B)}function Sn(B,ot,it){it===void 0&&(tt===null?it=n.TEXTURE0+Z-1:it=tt);let At=rt[it];At===void 0&&(At={type:void 0,texture:void 0},rt[it]=At),(At.type!==B||At.texture!==ot)&&(tt!==it&&(n.activeTexture(it),tt=it),n.bindTexture(B,ot||Pt[B]),At.type=B,At.texture=ot)}function k(){let B=rt[tt];B!==void 0&&B.type!==void 0&&(n.bindTexture(B.type,null),B.type=void 0,B.texture=void 0)}function Lt(){try{n.compressedTexImage2D(...arguments)}catch(B){ie("WebGLState:",B)}}function Qt(){try{n.compressedTexImage3D(...arguments)}catch(B){ie("WebGLState:",B)}}function he(){try{n.texSubImage2D(...arguments)}catch(B){ie("WebGLState:",B)}}function Tt(){try{n.texSubImage3D(...arguments)}catch(B){ie("WebGLState:",B)}}function Xe(){try{n.compressedTexSubImage2D(...arguments)}catch(B){ie("WebGLState:",B)}}function Xt(){try{n.compressedTexSubImage3D(...arguments)}catch(B){ie("WebGLState:",B)}}function Kt(){try{n.texStorage2D(...arguments)}catch(B){ie("WebGLState:",B)}}function I(){try{n.texStorage3D(...arguments)}catch(B){ie("WebGLState:",B)}}function T(){try{n.texImage2D(...arguments)}catch(B){ie("WebGLState:",B)}}function $(){try{n.texImage3D(...arguments)}catch(B){ie("WebGLState:",B)}}function ht(B){return h[B]!==void 0?h[B]:n.getParameter(B)}function at(B,ot){h[B]!==ot&&(n.pixelStorei(B,ot),h[B]=ot)}function vt(B){et.equals(B)===!1&&(n.scissor(B.x,B.y,B.z,B.w),et.copy(B))}function Mt(B){_t.equals(B)===!1&&(n.viewport(B.x,B.y,B.z,B.w),_t.copy(B))}function nt(B,ot){let it=l.get(ot);it===void 0&&(it=new WeakMap,l.set(ot,it));let At=it.get(B);At===void 0&&(At=n.getUniformBlockIndex(ot,B.name),n.uniformBlockBinding(ot,At,At),it.set(B,At))}function st(B,ot,it){let xt=l.get(ot).get(B);c[xt]!==it&&(n.bindBufferBase(n.UNIFORM_BUFFER,xt,it),c[xt]=it)}function mt(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},h={},tt=null,rt={},f={},c={},d=new WeakMap,g=[],_=null,p=!1,m=null,x=null,M=null,v=null,A=null,S=null,y=null,w=new ee(0,0,0),U=0,L=!1,N=null,z=null,W=null,O=null,X=null,et.set(0,0,n.canvas.width,n.canvas.height),_t.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:Et,disable:Zt,bindFramebuffer:ue,drawBuffers:$t,useProgram:xe,setBlending:an,setMaterial:Ke,setFlipSided:Mn,setCullFace:Ve,setLineWidth:kn,setPolygonOffset:Re,setScissorTest:In,activeTexture:fn,bindTexture:Sn,unbindTexture:k,compressedTexImage2D:Lt,compressedTexImage3D:Qt,texImage2D:T,texImage3D:$,pixelStorei:at,getParameter:ht,updateUBOMapping:nt,uniformBlockBinding:st,texStorage2D:Kt,texStorage3D:I,texSubImage2D:he,texSubImage3D:Tt,compressedTexSubImage2D:Xe,compressedTexSubImage3D:Xt,scissor:vt,viewport:Mt,reset:mt}}function YT(n,t,e,i,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,c=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),l=new qt,u=new WeakMap,h=new Set,f,d=new WeakMap,g=new Set,_=new FinalizationRegistry(I=>g.delete(I)),p=!1;try{p=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(I,T){return p?new OffscreenCanvas(I,T):wl("canvas")}function x(I,T,$){let ht=1,at=Kt(I);if((at.width>$||at.height>$)&&(ht=$/Math.max(at.width,at.height)),ht<1)if(typeof HTMLImageElement<"u"&&I instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&I instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&I instanceof ImageBitmap||typeof VideoFrame<"u"&&I instanceof VideoFrame){let vt=Math.floor(ht*at.width),Mt=Math.floor(ht*at.height);f===void 0&&(f=m(vt,Mt));let nt=T?m(vt,Mt):f;return nt.width=vt,nt.height=Mt,nt.getContext("2d").drawImage(I,0,0,vt,Mt),jt("WebGLRenderer: Texture has been resized from ("+at.width+"x"+at.height+") to ("+vt+"x"+Mt+")."),nt}else return"data"in I&&jt("WebGLRenderer: Image in DataTexture is too big ("+at.width+"x"+at.height+")."),I;return I}function M(I){return I.generateMipmaps}function v(I){n.generateMipmap(I)}function A(I){return I.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:I.isWebGL3DRenderTarget?n.TEXTURE_3D:I.isWebGLArrayRenderTarget||I.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function S(I,T,$,ht,at,vt=!1){if(I!==null){if(n[I]!==void 0)return n[I];jt("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+I+"'")}let Mt;ht&&(Mt=t.get("EXT_texture_norm16"),Mt||jt("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let nt=T;if(T===n.RED&&($===n.FLOAT&&(nt=n.R32F),$===n.HALF_FLOAT&&(nt=n.R16F),$===n.UNSIGNED_BYTE&&(nt=n.R8),$===n.UNSIGNED_SHORT&&Mt&&(nt=Mt.R16_EXT),$===n.SHORT&&Mt&&(nt=Mt.R16_SNORM_EXT)),T===n.RED_INTEGER&&($===n.UNSIGNED_BYTE&&(nt=n.R8UI),$===n.UNSIGNED_SHORT&&(nt=n.R16UI),$===n.UNSIGNED_INT&&(nt=n.R32UI),$===n.BYTE&&(nt=n.R8I),$===n.SHORT&&(nt=n.R16I),$===n.INT&&(nt=n.R32I)),T===n.RG&&($===n.FLOAT&&(nt=n.RG32F),$===n.HALF_FLOAT&&(nt=n.RG16F),$===n.UNSIGNED_BYTE&&(nt=n.RG8),$===n.UNSIGNED_SHORT&&Mt&&(nt=Mt.RG16_EXT),$===n.SHORT&&Mt&&(nt=Mt.RG16_SNORM_EXT)),T===n.RG_INTEGER&&($===n.UNSIGNED_BYTE&&(nt=n.RG8UI),$===n.UNSIGNED_SHORT&&(nt=n.RG16UI),$===n.UNSIGNED_INT&&(nt=n.RG32UI),$===n.BYTE&&(nt=n.RG8I),$===n.SHORT&&(nt=n.RG16I),$===n.INT&&(nt=n.RG32I)),T===n.RGB_INTEGER&&($===n.UNSIGNED_BYTE&&(nt=n.RGB8UI),$===n.UNSIGNED_SHORT&&(nt=n.RGB16UI),$===n.UNSIGNED_INT&&(nt=n.RGB32UI),$===n.BYTE&&(nt=n.RGB8I),$===n.SHORT&&(nt=n.RGB16I),$===n.INT&&(nt=n.RGB32I)),T===n.RGBA_INTEGER&&($===n.UNSIGNED_BYTE&&(nt=n.RGBA8UI),$===n.UNSIGNED_SHORT&&(nt=n.RGBA16UI),$===n.UNSIGNED_INT&&(nt=n.RGBA32UI),$===n.BYTE&&(nt=n.RGBA8I),$===n.SHORT&&(nt=n.RGBA16I),$===n.INT&&(nt=n.RGBA32I)),T===n.RGB&&($===n.UNSIGNED_SHORT&&Mt&&(nt=Mt.RGB16_EXT),$===n.SHORT&&Mt&&(nt=Mt.RGB16_SNORM_EXT),$===n.UNSIGNED_INT_5_9_9_9_REV&&(nt=n.RGB9_E5),$===n.UNSIGNED_INT_10F_11F_11F_REV&&(nt=n.R11F_G11F_B10F)),T===n.RGBA){let st=vt?Ml:Ee.getTransfer(at);$===n.FLOAT&&(nt=n.RGBA32F),$===n.HALF_FLOAT&&(nt=n.RGBA16F),$===n.UNSIGNED_BYTE&&(nt=st===Oe?n.SRGB8_ALPHA8:n.RGBA8),$===n.UNSIGNED_SHORT&&Mt&&(nt=Mt.RGBA16_EXT),$===n.SHORT&&Mt&&(nt=Mt.RGBA16_SNORM_EXT),$===n.UNSIGNED_SHORT_4_4_4_4&&(nt=n.RGBA4),$===n.UNSIGNED_SHORT_5_5_5_1&&(nt=n.RGB5_A1)}return(nt===n.R16F||nt===n.R32F||nt===n.RG16F||nt===n.RG32F||nt===n.RGBA16F||nt===n.RGBA32F)&&t.get("EXT_color_buffer_float"),nt}function y(I,T){let $;return I?T===null||T===us||T===mo?$=n.DEPTH24_STENCIL8:T===Ki?$=n.DEPTH32F_STENCIL8:T===Ta&&($=n.DEPTH24_STENCIL8,jt("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):T===null||T===us||T===mo?$=n.DEPTH_COMPONENT24:T===Ki?$=n.DEPTH_COMPONENT32F:T===Ta&&($=n.DEPTH_COMPONENT16),$}function w(I,T){return M(I)===!0||I.isFramebufferTexture&&I.minFilter!==qn&&I.minFilter!==fi?Math.log2(Math.max(T.width,T.height))+1:I.mipmaps.length>0?I.mipmaps.length:I.isCompressedTexture&&Array.isArray(I.image)?T.mipmaps.length:1}function U(I){let T=new WeakRef(I);i.get(I).__ref=T,g.add(T),_.register(I,T,T)}function L(I){let T=i.get(I).__ref;T!==void 0&&(g.delete(T),_.unregister(T))}function N(I){W(I.target)}function z(I){O(I.target)}function W(I){I.removeEventListener("dispose",N),L(I),Z(I),I.isVideoTexture&&u.delete(I),I.isHTMLTexture&&h.delete(I)}function O(I){I.removeEventListener("dispose",z),L(I),ut(I)}function X(){for(let I of g){let T=I.deref();T!==void 0&&(T.isRenderTarget===!0?O(T):W(T))}g.clear(),h.clear()}function Z(I){let T=i.get(I);if(T.__webglInit===void 0)return;let $=I.source,ht=d.get($);if(ht){let at=ht[T.__cacheKey];at.usedTimes--,at.usedTimes===0&&q(I),Object.keys(ht).length===0&&d.delete($)}i.remove(I)}function q(I){let T=i.get(I);n.deleteTexture(T.__webglTexture);let $=I.source,ht=d.get($);delete ht[T.__cacheKey],o.memory.textures--}function ut(I){let T=i.get(I);T.__depthDisposeCallback&&T.__depthDisposeCallback();let $=I.depthTexture;if($&&$.renderTarget===I&&W($),I.isWebGLCubeRenderTarget)for(let at=0;at<6;at++){if(Array.isArray(T.__webglFramebuffer[at]))for(let vt=0;vt<T.__webglFramebuffer[at].length;vt++)n.deleteFramebuffer(T.__webglFramebuffer[at][vt]);else n.deleteFramebuffer(T.__webglFramebuffer[at]);T.__webglDepthbuffer&&n.deleteRenderbuffer(T.__webglDepthbuffer[at])}else{if(Array.isArray(T.__webglFramebuffer))for(let at=0;at<T.__webglFramebuffer.length;at++)n.deleteFramebuffer(T.__webglFramebuffer[at]);else n.deleteFramebuffer(T.__webglFramebuffer);if(T.__webglDepthbuffer&&n.deleteRenderbuffer(T.__webglDepthbuffer),T.__webglMultisampledFramebuffer&&n.deleteFramebuffer(T.__webglMultisampledFramebuffer),T.__webglColorRenderbuffer)for(let at=0;at<T.__webglColorRenderbuffer.length;at++)T.__webglColorRenderbuffer[at]&&n.deleteRenderbuffer(T.__webglColorRenderbuffer[at]);T.__webglDepthRenderbuffer&&n.deleteRenderbuffer(T.__webglDepthRenderbuffer)}let ht=I.textures;for(let at=0,vt=ht.length;at<vt;at++){let Mt=i.get(ht[at]);Mt.__webglTexture&&(n.deleteTexture(Mt.__webglTexture),o.memory.textures--),i.remove(ht[at])}i.remove(I)}let j=0;function tt(){j=0}function rt(){return j}function dt(I){j=I}function ft(){let I=j;return I>=s.maxTextures&&jt("WebGLTextures: Trying to use "+(I+1)+" texture units while this GPU supports only "+s.maxTextures),j+=1,I}function et(I){let T=[];return T.push(I.wrapS),T.push(I.wrapT),T.push(I.wrapR||0),T.push(I.magFilter),T.push(I.minFilter),T.push(I.anisotropy),T.push(I.internalFormat),T.push(I.format),T.push(I.type),T.push(I.generateMipmaps),T.push(I.mipmapsAutoUpdate),T.push(I.premultiplyAlpha),T.push(I.flipY),T.push(I.unpackAlignment),T.push(I.colorSpace),T.join()}function _t(I,T){let $=i.get(I);if(I.isVideoTexture&&Xe(I),I.isRenderTargetTexture===!1&&I.isExternalTexture!==!0&&I.version>0&&$.__version!==I.version){let ht=I.image;if(ht===null)jt("WebGLRenderer: Texture marked for update but no image data found.");else if(ht.complete===!1)jt("WebGLRenderer: Texture marked for update but image is incomplete");else{Ke($,I,T);return}}else I.isExternalTexture&&($.__webglTexture=I.sourceTexture?I.sourceTexture:null);e.bindTexture(n.TEXTURE_2D,$.__webglTexture,n.TEXTURE0+T)}function bt(I,T){let $=i.get(I);if(I.isRenderTargetTexture===!1&&I.version>0&&$.__version!==I.version){Ke($,I,T);return}else I.isExternalTexture&&($.__webglTexture=I.sourceTexture?I.sourceTexture:null);e.bindTexture(n.TEXTURE_2D_ARRAY,$.__webglTexture,n.TEXTURE0+T)}function Pt(I,T){let $=i.get(I);if(I.isRenderTargetTexture===!1&&I.version>0&&$.__version!==I.version){Ke($,I,T);return}e.bindTexture(n.TEXTURE_3D,$.__webglTexture,n.TEXTURE0+T)}function Et(I,T){let $=i.get(I);if(I.version>0&&$.__version!==I.version){Mn($,I,T);return}e.bindTexture(n.TEXTURE_CUBE_MAP,$.__webglTexture,n.TEXTURE0+T)}let Zt={[Cu]:n.REPEAT,[Ps]:n.CLAMP_TO_EDGE,[Pu]:n.MIRRORED_REPEAT},ue={[qn]:n.NEAREST,[p_]:n.NEAREST_MIPMAP_NEAREST,[$l]:n.NEAREST_MIPMAP_LINEAR,[fi]:n.LINEAR,[nh]:n.LINEAR_MIPMAP_NEAREST,[ar]:n.LINEAR_MIPMAP_LINEAR},$t={[x_]:n.NEVER,[Rp]:n.ALWAYS,[y_]:n.LESS,[Tp]:n.LEQUAL,[v_]:n.EQUAL,[Ap]:n.GEQUAL,[b_]:n.GREATER,[M_]:n.NOTEQUAL};function xe(I,T){if(T.type===Ki&&t.has("OES_texture_float_linear")===!1&&(T.magFilter===fi||T.magFilter===nh||T.magFilter===$l||T.magFilter===ar||T.minFilter===fi||T.minFilter===nh||T.minFilter===$l||T.minFilter===ar)&&jt("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(I,n.TEXTURE_WRAP_S,Zt[T.wrapS]),n.texParameteri(I,n.TEXTURE_WRAP_T,Zt[T.wrapT]),(I===n.TEXTURE_3D||I===n.TEXTURE_2D_ARRAY)&&n.texParameteri(I,n.TEXTURE_WRAP_R,Zt[T.wrapR]),n.texParameteri(I,n.TEXTURE_MAG_FILTER,ue[T.magFilter]),n.texParameteri(I,n.TEXTURE_MIN_FILTER,ue[T.minFilter]),T.compareFunction&&(n.texParameteri(I,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(I,n.TEXTURE_COMPARE_FUNC,$t[T.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(T.magFilter===qn||T.minFilter!==$l&&T.minFilter!==ar||T.type===Ki&&t.has("OES_texture_float_linear")===!1)return;if(T.anisotropy>1||i.get(T).__currentAnisotropy){let $=t.get("EXT_texture_filter_anisotropic");n.texParameterf(I,$.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(T.anisotropy,s.getMaxAnisotropy())),i.get(T).__currentAnisotropy=T.anisotropy}}}function me(I,T){let $=!1;I.__webglInit===void 0&&(I.__webglInit=!0,T.addEventListener("dispose",N),U(T));let ht=T.source,at=d.get(ht);at===void 0&&(at={},d.set(ht,at));let vt=et(T);if(vt!==I.__cacheKey){at[vt]===void 0&&(at[vt]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,$=!0),at[vt].usedTimes++;let Mt=at[I.__cacheKey];Mt!==void 0&&(at[I.__cacheKey].usedTimes--,Mt.usedTimes===0&&q(T)),I.__cacheKey=vt,I.__webglTexture=at[vt].texture}return $}function le(I,T,$){return Math.floor(Math.floor(I/$)/T)}function an(I,T,$,ht){let vt=I.updateRanges;if(vt.length===0)e.texSubImage2D(n.TEXTURE_2D,0,0,0,T.width,T.height,$,ht,T.data);else{vt.sort((B,ot)=>B.start-ot.start);let Mt=0;for(let B=1;B<vt.length;B++){let ot=vt[Mt],it=vt[B],At=ot.start+ot.count,xt=le(it.start,T.width,4),wt=le(ot.start,T.width,4);it.start<=At+1&&xt===wt&&le(it.start+it.count-1,T.width,4)===xt?ot.count=Math.max(ot.count,it.start+it.count-ot.start):(++Mt,vt[Mt]=it)}vt.length=Mt+1;let nt=e.getParameter(n.UNPACK_ROW_LENGTH),st=e.getParameter(n.UNPACK_SKIP_PIXELS),mt=e.getParameter(n.UNPACK_SKIP_ROWS);e.pixelStorei(n.UNPACK_ROW_LENGTH,T.width);for(let B=0,ot=vt.length;B<ot;B++){let it=vt[B],At=Math.floor(it.start/4),xt=Math.ceil(it.count/4),wt=At%T.width,Yt=Math.floor(At/T.width),se=xt,ct=1;e.pixelStorei(n.UNPACK_SKIP_PIXELS,wt),e.pixelStorei(n.UNPACK_SKIP_ROWS,Yt),e.texSubImage2D(n.TEXTURE_2D,0,wt,Yt,se,ct,$,ht,T.data)}I.clearUpdateRanges(),e.pixelStorei(n.UNPACK_ROW_LENGTH,nt),e.pixelStorei(n.UNPACK_SKIP_PIXELS,st),e.pixelStorei(n.UNPACK_SKIP_ROWS,mt)}}function Ke(I,T,$){let ht=n.TEXTURE_2D;(T.isDataArrayTexture||T.isCompressedArrayTexture)&&(ht=n.TEXTURE_2D_ARRAY),T.isData3DTexture&&(ht=n.TEXTURE_3D);let at=me(I,T),vt=T.source;e.bindTexture(ht,I.__webglTexture,n.TEXTURE0+$);let Mt=i.get(vt);if(vt.version!==Mt.__version||at===!0){if(e.activeTexture(n.TEXTURE0+$),(typeof ImageBitmap<"u"&&T.image instanceof ImageBitmap)===!1){let ct=Ee.getPrimaries(Ee.workingColorSpace),Gt=T.colorSpace===cr?null:Ee.getPrimaries(T.colorSpace),re=T.colorSpace===cr||ct===Gt?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,T.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,T.premultiplyAlpha),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,re)}e.pixelStorei(n.UNPACK_ALIGNMENT,T.unpackAlignment);let st=x(T.image,!1,s.maxTextureSize);st=Xt(T,st);let mt=r.convert(T.format,T.colorSpace),B=r.convert(T.type),ot=S(T.internalFormat,mt,B,T.normalized,T.colorSpace,T.isVideoTexture);xe(ht,T);let it,At=T.mipmaps,xt=T.isVideoTexture!==!0,wt=Mt.__version===void 0||at===!0,Yt=vt.dataReady,se=w(T,st);if(T.isDepthTexture)ot=y(T.format===lr,T.type),wt&&(xt?e.texStorage2D(n.TEXTURE_2D,1,ot,st.width,st.height):e.texImage2D(n.TEXTURE_2D,0,ot,st.width,st.height,0,mt,B,null));else if(T.isDataTexture)if(At.length>0){xt&&wt&&e.texStorage2D(n.TEXTURE_2D,se,ot,At[0].width,At[0].height);for(let ct=0,Gt=At.length;ct<Gt;ct++)it=At[ct],xt?Yt&&e.texSubImage2D(n.TEXTURE_2D,ct,0,0,it.width,it.height,mt,B,it.data):e.texImage2D(n.TEXTURE_2D,ct,ot,it.width,it.height,0,mt,B,it.data);T.generateMipmaps=!1}else xt?(wt&&e.texStorage2D(n.TEXTURE_2D,se,ot,st.width,st.height),Yt&&an(T,st,mt,B)):e.texImage2D(n.TEXTURE_2D,0,ot,st.width,st.height,0,mt,B,st.data);else if(T.isCompressedTexture)if(T.isCompressedArrayTexture){xt&&wt&&e.texStorage3D(n.TEXTURE_2D_ARRAY,se,ot,At[0].width,At[0].height,st.depth);for(let ct=0,Gt=At.length;ct<Gt;ct++)if(it=At[ct],T.format!==fs)if(mt!==null)if(xt){if(Yt)if(T.layerUpdates.size>0){let re=Bp(it.width,it.height,T.format,T.type);for(let It of T.layerUpdates){let fe=it.data.subarray(It*re/it.data.BYTES_PER_ELEMENT,(It+1)*re/it.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ct,0,0,It,it.width,it.height,1,mt,fe)}}else e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ct,0,0,0,it.width,it.height,st.depth,mt,it.data)}else e.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ct,ot,it.width,it.height,st.depth,0,it.data,0,0);else jt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else xt?Yt&&e.texSubImage3D(n.TEXTURE_2D_ARRAY,ct,0,0,0,it.width,it.height,st.depth,mt,B,it.data):e.texImage3D(n.TEXTURE_2D_ARRAY,ct,ot,it.width,it.height,st.depth,0,mt,B,it.data);T.layerUpdates.size>0&&T.clearLayerUpdates()}else{xt&&wt&&e.texStorage2D(n.TEXTURE_2D,se,ot,At[0].width,At[0].height);for(let ct=0,Gt=At.length;ct<Gt;ct++)it=At[ct],T.format!==fs?mt!==null?xt?Yt&&e.compressedTexSubImage2D(n.TEXTURE_2D,ct,0,0,it.width,it.height,mt,it.data):e.compressedTexImage2D(n.TEXTURE_2D,ct,ot,it.width,it.height,0,it.data):jt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):xt?Yt&&e.texSubImage2D(n.TEXTURE_2D,ct,0,0,it.width,it.height,mt,B,it.data):e.texImage2D(n.TEXTURE_2D,ct,ot,it.width,it.height,0,mt,B,it.data)}else if(T.isDataArrayTexture)if(xt){if(wt&&e.texStorage3D(n.TEXTURE_2D_ARRAY,se,ot,st.width,st.height,st.depth),Yt)if(T.layerUpdates.size>0){let ct=Bp(st.width,st.height,T.format,T.type);for(let Gt of T.layerUpdates){let re=st.data.subarray(Gt*ct/st.data.BYTES_PER_ELEMENT,(Gt+1)*ct/st.data.BYTES_PER_ELEMENT);e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Gt,st.width,st.height,1,mt,B,re)}T.clearLayerUpdates()}else e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,st.width,st.height,st.depth,mt,B,st.data)}else e.texImage3D(n.TEXTURE_2D_ARRAY,0,ot,st.width,st.height,st.depth,0,mt,B,st.data);else if(T.isData3DTexture)xt?(wt&&e.texStorage3D(n.TEXTURE_3D,se,ot,st.width,st.height,st.depth),Yt&&e.texSubImage3D(n.TEXTURE_3D,0,0,0,0,st.width,st.height,st.depth,mt,B,st.data)):e.texImage3D(n.TEXTURE_3D,0,ot,st.width,st.height,st.depth,0,mt,B,st.data);else if(T.isFramebufferTexture){if(wt)if(xt)e.texStorage2D(n.TEXTURE_2D,se,ot,st.width,st.height);else{let ct=st.width,Gt=st.height;for(let re=0;re<se;re++)e.texImage2D(n.TEXTURE_2D,re,ot,ct,Gt,0,mt,B,null),ct>>=1,Gt>>=1}}else if(T.isHTMLTexture){if("texElementImage2D"in n){let ct=n.canvas;if(ct.hasAttribute("layoutsubtree")||ct.setAttribute("layoutsubtree","true"),st.parentNode!==ct){ct.appendChild(st),h.add(T),ct.onpaint=Gt=>{let re=Gt.changedElements;for(let It of h)re.includes(It.image)&&(It.needsUpdate=!0)},ct.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,st);else{let re=n.RGBA,It=n.RGBA,fe=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,re,It,fe,st)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(At.length>0){if(xt&&wt){let ct=Kt(At[0]);e.texStorage2D(n.TEXTURE_2D,se,ot,ct.width,ct.height)}for(let ct=0,Gt=At.length;ct<Gt;ct++)it=At[ct],xt?Yt&&e.texSubImage2D(n.TEXTURE_2D,ct,0,0,mt,B,it):e.texImage2D(n.TEXTURE_2D,ct,ot,mt,B,it);T.generateMipmaps=!1}else if(xt){if(wt){let ct=Kt(st);e.texStorage2D(n.TEXTURE_2D,se,ot,ct.width,ct.height)}Yt&&e.texSubImage2D(n.TEXTURE_2D,0,0,0,mt,B,st)}else e.texImage2D(n.TEXTURE_2D,0,ot,mt,B,st);M(T)&&T.mipmapsAutoUpdate===!0&&v(ht),Mt.__version=vt.version,T.onUpdate&&T.onUpdate(T)}I.__version=T.version}function Mn(I,T,$){if(T.image.length!==6)return;let ht=me(I,T),at=T.source;e.bindTexture(n.TEXTURE_CUBE_MAP,I.__webglTexture,n.TEXTURE0+$);let vt=i.get(at);if(at.version!==vt.__version||ht===!0){e.activeTexture(n.TEXTURE0+$);let Mt=Ee.getPrimaries(Ee.workingColorSpace),nt=T.colorSpace===cr?null:Ee.getPrimaries(T.colorSpace),st=T.colorSpace===cr||Mt===nt?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,T.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,T.premultiplyAlpha),e.pixelStorei(n.UNPACK_ALIGNMENT,T.unpackAlignment),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,st);let mt=T.isCompressedTexture||T.image[0].isCompressedTexture,B=T.image[0]&&T.image[0].isDataTexture,ot=[];for(let It=0;It<6;It++)!mt&&!B?ot[It]=x(T.image[It],!0,s.maxCubemapSize):ot[It]=B?T.image[It].image:T.image[It],ot[It]=Xt(T,ot[It]);let it=ot[0],At=r.convert(T.format,T.colorSpace),xt=r.convert(T.type),wt=S(T.internalFormat,At,xt,T.normalized,T.colorSpace),Yt=T.isVideoTexture!==!0,se=vt.__version===void 0||ht===!0,ct=at.dataReady,Gt=w(T,it);xe(n.TEXTURE_CUBE_MAP,T);let re;if(T.isDepthTexture){if(wt=y(T.format===lr,T.type),se)if(Yt)e.texStorage2D(n.TEXTURE_CUBE_MAP,1,wt,it.width,it.height);else for(let It=0;It<6;It++)e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+It,0,wt,it.width,it.height,0,At,xt,null)}else if(mt){Yt&&se&&e.texStorage2D(n.TEXTURE_CUBE_MAP,Gt,wt,it.width,it.height);for(let It=0;It<6;It++){re=ot[It].mipmaps;for(let fe=0;fe<re.length;fe++){let je=re[fe];T.format!==fs?At!==null?Yt?ct&&e.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+It,fe,0,0,je.width,je.height,At,je.data):e.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+It,fe,wt,je.width,je.height,0,je.data):jt("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Yt?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+It,fe,0,0,je.width,je.height,At,xt,je.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+It,fe,wt,je.width,je.height,0,At,xt,je.data)}}}else{if(re=T.mipmaps,Yt&&se){re.length>0&&Gt++;let It=Kt(ot[0]);e.texStorage2D(n.TEXTURE_CUBE_MAP,Gt,wt,It.width,It.height)}for(let It=0;It<6;It++)if(B){Yt?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+It,0,0,0,ot[It].width,ot[It].height,At,xt,ot[It].data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+It,0,wt,ot[It].width,ot[It].height,0,At,xt,ot[It].data);for(let fe=0;fe<re.length;fe++){let si=re[fe].image[It].image;Yt?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+It,fe+1,0,0,si.width,si.height,At,xt,si.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+It,fe+1,wt,si.width,si.height,0,At,xt,si.data)}}else{Yt?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+It,0,0,0,At,xt,ot[It]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+It,0,wt,At,xt,ot[It]);for(let fe=0;fe<re.length;fe++){let je=re[fe];Yt?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+It,fe+1,0,0,At,xt,je.image[It]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+It,fe+1,wt,At,xt,je.image[It])}}}M(T)&&T.mipmapsAutoUpdate===!0&&v(n.TEXTURE_CUBE_MAP),vt.__version=at.version,T.onUpdate&&T.onUpdate(T)}I.__version=T.version}function Ve(I,T,$,ht,at,vt){let Mt=r.convert($.format,$.colorSpace),nt=r.convert($.type),st=S($.internalFormat,Mt,nt,$.normalized,$.colorSpace),mt=i.get(T),B=i.get($);if(B.__renderTarget=T,!mt.__hasExternalTextures){let ot=Math.max(1,T.width>>vt),it=Math.max(1,T.height>>vt);at===n.TEXTURE_3D||at===n.TEXTURE_2D_ARRAY?e.texImage3D(at,vt,st,ot,it,T.depth,0,Mt,nt,null):e.texImage2D(at,vt,st,ot,it,0,Mt,nt,null)}e.bindFramebuffer(n.FRAMEBUFFER,I),Tt(T)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ht,at,B.__webglTexture,0,he(T)):(at===n.TEXTURE_2D||at>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&at<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,ht,at,B.__webglTexture,vt),e.bindFramebuffer(n.FRAMEBUFFER,null)}function kn(I,T,$){if(n.bindRenderbuffer(n.RENDERBUFFER,I),T.depthBuffer){let ht=T.depthTexture,at=ht&&ht.isDepthTexture?ht.type:null,vt=y(T.stencilBuffer,at),Mt=T.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;Tt(T)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,he(T),vt,T.width,T.height):$?n.renderbufferStorageMultisample(n.RENDERBUFFER,he(T),vt,T.width,T.height):n.renderbufferStorage(n.RENDERBUFFER,vt,T.width,T.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,Mt,n.RENDERBUFFER,I)}else{let ht=T.textures;for(let at=0;at<ht.length;at++){let vt=ht[at],Mt=r.convert(vt.format,vt.colorSpace),nt=r.convert(vt.type),st=S(vt.internalFormat,Mt,nt,vt.normalized,vt.colorSpace);Tt(T)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,he(T),st,T.width,T.height):$?n.renderbufferStorageMultisample(n.RENDERBUFFER,he(T),st,T.width,T.height):n.renderbufferStorage(n.RENDERBUFFER,st,T.width,T.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function Re(I,T,$){let ht=T.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(n.FRAMEBUFFER,I),!(T.depthTexture&&T.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let at=i.get(T.depthTexture);at.__renderTarget=T;let vt=ht?T.depthTexture.image[0]:T.depthTexture.image;(!at.__webglTexture||vt.width!==T.width||vt.height!==T.height)&&(vt.width=T.width,vt.height=T.height,T.depthTexture.needsUpdate=!0),ht?Et(T.depthTexture,0):_t(T.depthTexture,0);let Mt=at.__webglTexture,nt=he(T),st=ht?n.TEXTURE_CUBE_MAP_POSITIVE_X+$:n.TEXTURE_2D,mt=T.depthTexture.format===lr?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(T.depthTexture.format===ir)Tt(T)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,mt,st,Mt,0,nt):n.framebufferTexture2D(n.FRAMEBUFFER,mt,st,Mt,0);else if(T.depthTexture.format===lr)Tt(T)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,mt,st,Mt,0,nt):n.framebufferTexture2D(n.FRAMEBUFFER,mt,st,Mt,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function In(I){let T=i.get(I),$=I.isWebGLCubeRenderTarget===!0;if(T.__boundDepthTexture!==I.depthTexture){let ht=I.depthTexture;if(T.__depthDisposeCallback&&T.__depthDisposeCallback(),ht){let at=()=>{delete T.__boundDepthTexture,delete T.__depthDisposeCallback,ht.removeEventListener("dispose",at)};ht.addEventListener("dispose",at),T.__depthDisposeCallback=at}T.__boundDepthTexture=ht}if(I.depthTexture&&!T.__autoAllocateDepthBuffer)if($)for(let ht=0;ht<6;ht++)Re(T.__webglFramebuffer[ht],I,ht);else I.texture.mipmaps.length>0?Re(T.__webglFramebuffer[0],I,0):Re(T.__webglFramebuffer,I,0);else if($){T.__webglDepthbuffer=[];for(let ht=0;ht<6;ht++)if(e.bindFramebuffer(n.FRAMEBUFFER,T.__webglFramebuffer[ht]),T.__webglDepthbuffer[ht]===void 0)T.__webglDepthbuffer[ht]=n.createRenderbuffer(),kn(T.__webglDepthbuffer[ht],I,!1);else{let at=I.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,vt=T.__webglDepthbuffer[ht];n.bindRenderbuffer(n.RENDERBUFFER,vt),n.framebufferRenderbuffer(n.FRAMEBUFFER,at,n.RENDERBUFFER,vt)}}else if(I.texture.mipmaps.length>0?e.bindFramebuffer(n.FRAMEBUFFER,T.__webglFramebuffer[0]):e.bindFramebuffer(n.FRAMEBUFFER,T.__webglFramebuffer),T.__webglDepthbuffer===void 0)T.__webglDepthbuffer=n.createRenderbuffer(),kn(T.__webglDepthbuffer,I,!1);else{let at=I.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,vt=T.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,vt),n.framebufferRenderbuffer(n.FRAMEBUFFER,at,n.RENDERBUFFER,vt)}e.bindFramebuffer(n.FRAMEBUFFER,null)}function fn(I,T,$){let ht=i.get(I);T!==void 0&&Ve(ht.__webglFramebuffer,I,I.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),$!==void 0&&In(I)}function Sn(I){let T=I.texture,$=i.get(I),ht=i.get(T);I.addEventListener("dispose",z),U(I);let at=I.textures,vt=I.isWebGLCubeRenderTarget===!0,Mt=at.length>1;if(Mt||(ht.__webglTexture===void 0&&(ht.__webglTexture=n.createTexture()),ht.__version=T.version,o.memory.textures++),vt){$.__webglFramebuffer=[];for(let nt=0;nt<6;nt++)if(T.mipmaps.length>0){$.__webglFramebuffer[nt]=[];for(let st=0;st<T.mipmaps.length;st++)$.__webglFramebuffer[nt][st]=n.createFramebuffer()}else $.__webglFramebuffer[nt]=n.createFramebuffer()}else{if(T.mipmaps.length>0){$.__webglFramebuffer=[];for(let nt=0;nt<T.mipmaps.length;nt++)$.__webglFramebuffer[nt]=n.createFramebuffer()}else $.__webglFramebuffer=n.createFramebuffer();if(Mt)for(let nt=0,st=at.length;nt<st;nt++){let mt=i.get(at[nt]);mt.__webglTexture===void 0&&(mt.__webglTexture=n.createTexture(),o.memory.textures++)}if(I.samples>0&&Tt(I)===!1){$.__webglMultisampledFramebuffer=n.createFramebuffer(),$.__webglColorRenderbuffer=[],e.bindFramebuffer(n.FRAMEBUFFER,$.__webglMultisampledFramebuffer);for(let nt=0;nt<at.length;nt++){let st=at[nt];$.__webglColorRenderbuffer[nt]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,$.__webglColorRenderbuffer[nt]);let mt=r.convert(st.format,st.colorSpace),B=r.convert(st.type),ot=S(st.internalFormat,mt,B,st.normalized,st.colorSpace,I.isXRRenderTarget===!0),it=he(I);n.renderbufferStorageMultisample(n.RENDERBUFFER,it,ot,I.width,I.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+nt,n.RENDERBUFFER,$.__webglColorRenderbuffer[nt])}n.bindRenderbuffer(n.RENDERBUFFER,null),I.depthBuffer&&($.__webglDepthRenderbuffer=n.createRenderbuffer(),kn($.__webglDepthRenderbuffer,I,!0)),e.bindFramebuffer(n.FRAMEBUFFER,null)}}if(vt){e.bindTexture(n.TEXTURE_CUBE_MAP,ht.__webglTexture),xe(n.TEXTURE_CUBE_MAP,T);for(let nt=0;nt<6;nt++)if(T.mipmaps.length>0)for(let st=0;st<T.mipmaps.length;st++)Ve($.__webglFramebuffer[nt][st],I,T,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+nt,st);else Ve($.__webglFramebuffer[nt],I,T,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+nt,0);M(T)?v(n.TEXTURE_CUBE_MAP):T.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,T.mipmaps.length-1),e.unbindTexture()}else if(Mt){for(let nt=0,st=at.length;nt<st;nt++){let mt=at[nt],B=i.get(mt),ot=n.TEXTURE_2D;(I.isWebGL3DRenderTarget||I.isWebGLArrayRenderTarget)&&(ot=I.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(ot,B.__webglTexture),xe(ot,mt),Ve($.__webglFramebuffer,I,mt,n.COLOR_ATTACHMENT0+nt,ot,0),M(mt)&&v(ot)}e.unbindTexture()}else{let nt=n.TEXTURE_2D;if((I.isWebGL3DRenderTarget||I.isWebGLArrayRenderTarget)&&(nt=I.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(nt,ht.__webglTexture),xe(nt,T),T.mipmaps.length>0)for(let st=0;st<T.mipmaps.length;st++)Ve($.__webglFramebuffer[st],I,T,n.COLOR_ATTACHMENT0,nt,st);else Ve($.__webglFramebuffer,I,T,n.COLOR_ATTACHMENT0,nt,0);M(T)?v(nt):T.mipmaps.length>0&&n.texParameteri(nt,n.TEXTURE_MAX_LEVEL,T.mipmaps.length-1),e.unbindTexture()}I.depthBuffer&&In(I)}function k(I){let T=I.textures;for(let $=0,ht=T.length;$<ht;$++){let at=T[$];if(M(at)&&at.mipmapsAutoUpdate===!0){let vt=A(I),Mt=i.get(at).__webglTexture;e.bindTexture(vt,Mt),v(vt),e.unbindTexture()}}}let Lt=[];function Qt(I){if(I.samples>0){if(Tt(I)===!1){let T=I.textures,$=I.width,ht=I.height,at=n.COLOR_BUFFER_BIT,vt=I.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,Mt=i.get(I),nt=T.length>1;if(nt)for(let mt=0;mt<T.length;mt++)e.bindFramebuffer(n.FRAMEBUFFER,Mt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+mt,n.RENDERBUFFER,null),e.bindFramebuffer(n.FRAMEBUFFER,Mt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+mt,n.TEXTURE_2D,null,0);e.bindFramebuffer(n.READ_FRAMEBUFFER,Mt.__webglMultisampledFramebuffer),I.texture.mipmaps.length>0?e.bindFramebuffer(n.DRAW_FRAMEBUFFER,Mt.__webglFramebuffer[0]):e.bindFramebuffer(n.DRAW_FRAMEBUFFER,Mt.__webglFramebuffer);for(let mt=0;mt<T.length;mt++){if(I.resolveDepthBuffer&&(I.depthBuffer&&(at|=n.DEPTH_BUFFER_BIT),I.stencilBuffer&&I.resolveStencilBuffer&&(at|=n.STENCIL_BUFFER_BIT)),nt){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,Mt.__webglColorRenderbuffer[mt]);let B=i.get(T[mt]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,B,0)}n.blitFramebuffer(0,0,$,ht,0,0,$,ht,at,n.NEAREST),c===!0&&(Lt.length=0,Lt.push(n.COLOR_ATTACHMENT0+mt),I.depthBuffer&&I.storeMultisampledDepthBuffer===!1&&Lt.push(vt),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Lt))}if(e.bindFramebuffer(n.READ_FRAMEBUFFER,null),e.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),nt)for(let mt=0;mt<T.length;mt++){e.bindFramebuffer(n.FRAMEBUFFER,Mt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+mt,n.RENDERBUFFER,Mt.__webglColorRenderbuffer[mt]);let B=i.get(T[mt]).__webglTexture;e.bindFramebuffer(n.FRAMEBUFFER,Mt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+mt,n.TEXTURE_2D,B,0)}e.bindFramebuffer(n.DRAW_FRAMEBUFFER,Mt.__webglMultisampledFramebuffer)}else if(I.depthBuffer&&I.storeMultisampledDepthBuffer===!1&&c){let T=I.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[T])}}}function he(I){return Math.min(s.maxSamples,I.samples)}function Tt(I){let T=i.get(I);return I.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&T.__useRenderToTexture!==!1}function Xe(I){let T=o.render.frame;u.get(I)!==T&&(u.set(I,T),I.update())}function Xt(I,T){let $=I.colorSpace,ht=I.format,at=I.type;return I.isCompressedTexture===!0||I.isVideoTexture===!0||$!==bl&&$!==cr&&(Ee.getTransfer($)===Oe?(ht!==fs||at!==Bi)&&jt("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):ie("WebGLTextures: Unsupported texture color space:",$)),T}function Kt(I){return typeof HTMLImageElement<"u"&&I instanceof HTMLImageElement?(l.width=I.naturalWidth||I.width,l.height=I.naturalHeight||I.height):typeof VideoFrame<"u"&&I instanceof VideoFrame?(l.width=I.displayWidth,l.height=I.displayHeight):(l.width=I.width,l.height=I.height),l}this.allocateTextureUnit=ft,this.resetTextureUnits=tt,this.getTextureUnits=rt,this.setTextureUnits=dt,this.setTexture2D=_t,this.setTexture2DArray=bt,this.setTexture3D=Pt,this.setTextureCube=Et,this.rebindTextures=fn,this.setupRenderTarget=Sn,this.updateRenderTargetMipmap=k,this.updateMultisampleRenderTarget=Qt,this.setupDepthRenderbuffer=In,this.setupFrameBufferTexture=Ve,this.useMultisampledRTT=Tt,this.dispose=X}function ZT(n,t){function e(i,s=cr){let r,o=Ee.getTransfer(s);if(i===Bi)return n.UNSIGNED_BYTE;if(i===sh)return n.UNSIGNED_SHORT_4_4_4_4;if(i===rh)return n.UNSIGNED_SHORT_5_5_5_1;if(i===yp)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===vp)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===_p)return n.BYTE;if(i===xp)return n.SHORT;if(i===Ta)return n.UNSIGNED_SHORT;if(i===ih)return n.INT;if(i===us)return n.UNSIGNED_INT;if(i===Ki)return n.FLOAT;if(i===hs)return n.HALF_FLOAT;if(i===bp)return n.ALPHA;if(i===Mp)return n.RGB;if(i===fs)return n.RGBA;if(i===ir)return n.DEPTH_COMPONENT;if(i===lr)return n.DEPTH_STENCIL;if(i===oh)return n.RED;if(i===ah)return n.RED_INTEGER;if(i===kr)return n.RG;if(i===lh)return n.RG_INTEGER;if(i===ch)return n.RGBA_INTEGER;if(i===Yl||i===Zl||i===Jl||i===Kl)if(o===Oe)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===Yl)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===Zl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Jl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===Kl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===Yl)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===Zl)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Jl)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===Kl)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===uh||i===hh||i===fh||i===dh)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===uh)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===hh)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===fh)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===dh)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===ph||i===mh||i===gh||i===_h||i===xh||i===jl||i===yh)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(i===ph||i===mh)return o===Oe?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===gh)return o===Oe?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===_h)return r.COMPRESSED_R11_EAC;if(i===xh)return r.COMPRESSED_SIGNED_R11_EAC;if(i===jl)return r.COMPRESSED_RG11_EAC;if(i===yh)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===vh||i===bh||i===Mh||i===Sh||i===wh||i===Eh||i===Th||i===Ah||i===Rh||i===Ch||i===Ph||i===Ih||i===Lh||i===Dh)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(i===vh)return o===Oe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===bh)return o===Oe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Mh)return o===Oe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===Sh)return o===Oe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===wh)return o===Oe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Eh)return o===Oe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Th)return o===Oe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Ah)return o===Oe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Rh)return o===Oe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===Ch)return o===Oe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===Ph)return o===Oe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Ih)return o===Oe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===Lh)return o===Oe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Dh)return o===Oe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Nh||i===Uh||i===Fh)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(i===Nh)return o===Oe?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Uh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Fh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Oh||i===Bh||i===Ql||i===kh)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(i===Oh)return r.COMPRESSED_RED_RGTC1_EXT;if(i===Bh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Ql)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===kh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===mo?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:e}}var JT=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,KT=`
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

}`,$p=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let i=new Bl(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=i}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,i=new Zi({vertexShader:JT,fragmentShader:KT,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new ei(new Hl(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Yp=class extends ls{constructor(t,e){super();let i=this,s=null,r=1,o=null,a="local-floor",c=1,l=null,u=null,h=null,f=null,d=null,g=null,_=typeof XRWebGLBinding<"u",p=new $p,m={},x=e.getContextAttributes(),M=null,v=null,A=[],S=[],y=new qt,w=null,U=null,L=new hi;L.viewport=new hn;let N=new hi;N.viewport=new hn;let z=[L,N],W=new Qu,O=null,X=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(et){let _t=A[et];return _t===void 0&&(_t=new ma,A[et]=_t),_t.getTargetRaySpace()},this.getControllerGrip=function(et){let _t=A[et];return _t===void 0&&(_t=new ma,A[et]=_t),_t.getGripSpace()},this.getHand=function(et){let _t=A[et];return _t===void 0&&(_t=new ma,A[et]=_t),_t.getHandSpace()};function Z(et){let _t=S.indexOf(et.inputSource);if(_t===-1)return;let bt=A[_t];bt!==void 0&&(bt.update(et.inputSource,et.frame,l||o),bt.dispatchEvent({type:et.type,data:et.inputSource}))}function q(){s.removeEventListener("select",Z),s.removeEventListener("selectstart",Z),s.removeEventListener("selectend",Z),s.removeEventListener("squeeze",Z),s.removeEventListener("squeezestart",Z),s.removeEventListener("squeezeend",Z),s.removeEventListener("end",q),s.removeEventListener("inputsourceschange",ut);for(let et=0;et<A.length;et++){let _t=S[et];_t!==null&&(S[et]=null,A[et].disconnect(_t))}O=null,X=null,p.reset();for(let et in m)delete m[et];if(t.setRenderTarget(M),d=null,f=null,h=null,s=null,v=null,ft.stop(),i.isPresenting=!1,t.setPixelRatio(w),t.setSize(y.width,y.height,!1),U!==null){let et=U.camera;et.fov=U.fov,et.zoom=U.zoom,et.updateProjectionMatrix(),U=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(et){r=et,i.isPresenting===!0&&jt("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(et){a=et,i.isPresenting===!0&&jt("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return l||o},this.setReferenceSpace=function(et){l=et},this.getBaseLayer=function(){return f!==null?f:d},this.getBinding=function(){return h===null&&_&&(h=new XRWebGLBinding(s,e)),h},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(et){if(s=et,s!==null){if(M=t.getRenderTarget(),s.addEventListener("select",Z),s.addEventListener("selectstart",Z),s.addEventListener("selectend",Z),s.addEventListener("squeeze",Z),s.addEventListener("squeezestart",Z),s.addEventListener("squeezeend",Z),s.addEventListener("end",q),s.addEventListener("inputsourceschange",ut),x.xrCompatible!==!0&&await e.makeXRCompatible(),w=t.getPixelRatio(),t.getSize(y),_&&"createProjectionLayer"in XRWebGLBinding.prototype){let bt=null,Pt=null,Et=null;x.depth&&(Et=x.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,bt=x.stencil?lr:ir,Pt=x.stencil?mo:us);let Zt={colorFormat:e.RGBA8,depthFormat:Et,scaleFactor:r};h=this.getBinding(),f=h.createProjectionLayer(Zt),s.updateRenderState({layers:[f]}),t.setPixelRatio(1),t.setSize(f.textureWidth,f.textureHeight,!1),v=new Fi(f.textureWidth,f.textureHeight,{format:fs,type:Bi,depthTexture:new or(f.textureWidth,f.textureHeight,Pt,void 0,void 0,void 0,void 0,void 0,void 0,bt),stencilBuffer:x.stencil,colorSpace:t.outputColorSpace,samples:x.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}else{let bt={antialias:x.antialias,alpha:!0,depth:x.depth,stencil:x.stencil,framebufferScaleFactor:r};d=new XRWebGLLayer(s,e,bt),s.updateRenderState({baseLayer:d}),t.setPixelRatio(1),t.setSize(d.framebufferWidth,d.framebufferHeight,!1),v=new Fi(d.framebufferWidth,d.framebufferHeight,{format:fs,type:Bi,colorSpace:t.outputColorSpace,stencilBuffer:x.stencil,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}v.isXRRenderTarget=!0,this.setFoveation(c),l=null,o=await s.requestReferenceSpace(a),ft.setContext(s),ft.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return p.getDepthTexture()};function ut(et){for(let _t=0;_t<et.removed.length;_t++){let bt=et.removed[_t],Pt=S.indexOf(bt);Pt>=0&&(S[Pt]=null,A[Pt].disconnect(bt))}for(let _t=0;_t<et.added.length;_t++){let bt=et.added[_t],Pt=S.indexOf(bt);if(Pt===-1){for(let Zt=0;Zt<A.length;Zt++)if(Zt>=S.length){S.push(bt),Pt=Zt;break}else if(S[Zt]===null){S[Zt]=bt,Pt=Zt;break}if(Pt===-1)break}let Et=A[Pt];Et&&Et.connect(bt)}}function j(et,_t){_t===null?et.matrixWorld.copy(et.matrix):et.matrixWorld.multiplyMatrices(_t.matrixWorld,et.matrix),et.matrixWorldInverse.copy(et.matrixWorld).invert()}this.updateCamera=function(et){if(s===null)return;let _t=et.near,bt=et.far;p.texture!==null&&(p.depthNear>0&&(_t=p.depthNear),p.depthFar>0&&(bt=p.depthFar)),W.near=N.near=L.near=_t,W.far=N.far=L.far=bt,(O!==W.near||X!==W.far)&&(s.updateRenderState({depthNear:W.near,depthFar:W.far}),O=W.near,X=W.far),W.layers.mask=et.layers.mask|6,L.layers.mask=W.layers.mask&-5,N.layers.mask=W.layers.mask&-3;let Pt=et.parent,Et=W.cameras;j(W,Pt);for(let Zt=0;Zt<Et.length;Zt++)j(Et[Zt],Pt);W.projectionMatrix.copy(L.projectionMatrix),W.projectionMatrixInverse.copy(L.projectionMatrixInverse),U===null&&et.isPerspectiveCamera&&(U={camera:et,fov:et.fov,zoom:et.zoom}),tt(et,W,Pt)};function tt(et,_t,bt){bt===null?et.matrix.copy(_t.matrixWorld):(et.matrix.copy(bt.matrixWorld),et.matrix.invert(),et.matrix.multiply(_t.matrixWorld)),et.matrix.decompose(et.position,et.quaternion,et.scale),et.updateMatrixWorld(!0),et.projectionMatrix.copy(_t.projectionMatrix),et.projectionMatrixInverse.copy(_t.projectionMatrixInverse),et.isPerspectiveCamera&&(et.fov=fa*2*Math.atan(1/et.projectionMatrix.elements[5]),et.zoom=1)}this.getCamera=function(){return W},this.getFoveation=function(){if(!(f===null&&d===null))return c},this.setFoveation=function(et){c=et,f!==null&&(f.fixedFoveation=et),d!==null&&d.fixedFoveation!==void 0&&(d.fixedFoveation=et)},this.hasDepthSensing=function(){return p.texture!==null},this.getDepthSensingMesh=function(){return p.getMesh(W)},this.getCameraTexture=function(et){return m[et]};let rt=null;function dt(et,_t){if(u=_t.getViewerPose(l||o),g=_t,u!==null){let bt=u.views;d!==null&&(t.setRenderTargetFramebuffer(v,d.framebuffer),t.setRenderTarget(v));let Pt=!1;bt.length!==W.cameras.length&&(W.cameras.length=0,Pt=!0);for(let $t=0;$t<bt.length;$t++){let xe=bt[$t],me=null;if(d!==null)me=d.getViewport(xe);else{let an=h.getViewSubImage(f,xe);me=an.viewport,$t===0&&(t.setRenderTargetTextures(v,an.colorTexture,an.depthStencilTexture),t.setRenderTarget(v))}let le=z[$t];le===void 0&&(le=new hi,le.layers.enable($t),le.viewport=new hn,z[$t]=le),le.matrix.fromArray(xe.transform.matrix),le.matrix.decompose(le.position,le.quaternion,le.scale),le.projectionMatrix.fromArray(xe.projectionMatrix),le.projectionMatrixInverse.copy(le.projectionMatrix).invert(),le.viewport.set(me.x,me.y,me.width,me.height),$t===0&&(W.matrix.copy(le.matrix),W.matrix.decompose(W.position,W.quaternion,W.scale)),Pt===!0&&W.cameras.push(le)}let Et=s.enabledFeatures;if(Et&&Et.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&_){h=i.getBinding();let $t=h.getDepthInformation(bt[0]);$t&&$t.isValid&&$t.texture&&p.init($t,s.renderState)}if(Et&&Et.includes("camera-access")&&_){t.state.unbindTexture(),h=i.getBinding();for(let $t=0;$t<bt.length;$t++){let xe=bt[$t].camera;if(xe){let me=m[xe];me||(me=new Bl,m[xe]=me);let le=h.getCameraImage(xe);me.sourceTexture=le}}}}for(let bt=0;bt<A.length;bt++){let Pt=S[bt],Et=A[bt];Pt!==null&&Et!==void 0&&Et.update(Pt,_t,l||o)}rt&&rt(et,_t),_t.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:_t}),g=null}let ft=new Q_;ft.setAnimationLoop(dt),this.setAnimationLoop=function(et){rt=et},this.dispose=function(){}}},jT=new Te,cx=new ae;cx.set(-1,0,0,0,1,0,0,0,1);function QT(n,t){function e(p,m){p.matrixAutoUpdate===!0&&p.updateMatrix(),m.value.copy(p.matrix)}function i(p,m){m.color.getRGB(p.fogColor.value,Up(n)),m.isFog?(p.fogNear.value=m.near,p.fogFar.value=m.far):m.isFogExp2&&(p.fogDensity.value=m.density)}function s(p,m,x,M,v){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?r(p,m):m.isMeshLambertMaterial?(r(p,m),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(r(p,m),h(p,m)):m.isMeshPhongMaterial?(r(p,m),u(p,m),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(r(p,m),f(p,m),m.isMeshPhysicalMaterial&&d(p,m,v)):m.isMeshMatcapMaterial?(r(p,m),g(p,m)):m.isMeshDepthMaterial?r(p,m):m.isMeshDistanceMaterial?(r(p,m),_(p,m)):m.isMeshNormalMaterial?r(p,m):m.isLineBasicMaterial?(o(p,m),m.isLineDashedMaterial&&a(p,m)):m.isPointsMaterial?c(p,m,x,M):m.isSpriteMaterial?l(p,m):m.isShadowMaterial?(p.color.value.copy(m.color),p.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function r(p,m){p.opacity.value=m.opacity,m.color&&p.diffuse.value.copy(m.color),m.emissive&&p.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(p.map.value=m.map,e(m.map,p.mapTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,e(m.alphaMap,p.alphaMapTransform)),m.bumpMap&&(p.bumpMap.value=m.bumpMap,e(m.bumpMap,p.bumpMapTransform),p.bumpScale.value=m.bumpScale,m.side===mi&&(p.bumpScale.value*=-1)),m.normalMap&&(p.normalMap.value=m.normalMap,e(m.normalMap,p.normalMapTransform),p.normalScale.value.copy(m.normalScale),m.side===mi&&p.normalScale.value.negate()),m.displacementMap&&(p.displacementMap.value=m.displacementMap,e(m.displacementMap,p.displacementMapTransform),p.displacementScale.value=m.displacementScale,p.displacementBias.value=m.displacementBias),m.emissiveMap&&(p.emissiveMap.value=m.emissiveMap,e(m.emissiveMap,p.emissiveMapTransform)),m.specularMap&&(p.specularMap.value=m.specularMap,e(m.specularMap,p.specularMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest);let x=t.get(m),M=x.envMap,v=x.envMapRotation;M&&(p.envMap.value=M,p.envMapRotation.value.setFromMatrix4(jT.makeRotationFromEuler(v)).transpose(),M.isCubeTexture&&M.isRenderTargetTexture===!1&&p.envMapRotation.value.premultiply(cx),p.reflectivity.value=m.reflectivity,p.ior.value=m.ior,p.refractionRatio.value=m.refractionRatio),m.lightMap&&(p.lightMap.value=m.lightMap,p.lightMapIntensity.value=m.lightMapIntensity,e(m.lightMap,p.lightMapTransform)),m.aoMap&&(p.aoMap.value=m.aoMap,p.aoMapIntensity.value=m.aoMapIntensity,e(m.aoMap,p.aoMapTransform))}function o(p,m){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,m.map&&(p.map.value=m.map,e(m.map,p.mapTransform))}function a(p,m){p.dashSize.value=m.dashSize,p.totalSize.value=m.dashSize+m.gapSize,p.scale.value=m.scale}function c(p,m,x,M){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,p.size.value=m.size*x,p.scale.value=M*.5,m.map&&(p.map.value=m.map,e(m.map,p.uvTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,e(m.alphaMap,p.alphaMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest)}function l(p,m){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,p.rotation.value=m.rotation,m.map&&(p.map.value=m.map,e(m.map,p.mapTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,e(m.alphaMap,p.alphaMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest)}function u(p,m){p.specular.value.copy(m.specular),p.shininess.value=Math.max(m.shininess,1e-4)}function h(p,m){m.gradientMap&&(p.gradientMap.value=m.gradientMap)}function f(p,m){p.metalness.value=m.metalness,m.metalnessMap&&(p.metalnessMap.value=m.metalnessMap,e(m.metalnessMap,p.metalnessMapTransform)),p.roughness.value=m.roughness,m.roughnessMap&&(p.roughnessMap.value=m.roughnessMap,e(m.roughnessMap,p.roughnessMapTransform)),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)}function d(p,m,x){p.ior.value=m.ior,m.diffuseRoughness>0&&(p.diffuseRoughness.value=m.diffuseRoughness,m.diffuseRoughnessMap&&(p.diffuseRoughnessMap.value=m.diffuseRoughnessMap,e(m.diffuseRoughnessMap,p.diffuseRoughnessMapTransform))),m.sheen>0&&(p.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),p.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(p.sheenColorMap.value=m.sheenColorMap,e(m.sheenColorMap,p.sheenColorMapTransform)),m.sheenRoughnessMap&&(p.sheenRoughnessMap.value=m.sheenRoughnessMap,e(m.sheenRoughnessMap,p.sheenRoughnessMapTransform))),m.clearcoat>0&&(p.clearcoat.value=m.clearcoat,p.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(p.clearcoatMap.value=m.clearcoatMap,e(m.clearcoatMap,p.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(p.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,e(m.clearcoatRoughnessMap,p.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(p.clearcoatNormalMap.value=m.clearcoatNormalMap,e(m.clearcoatNormalMap,p.clearcoatNormalMapTransform),p.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===mi&&p.clearcoatNormalScale.value.negate())),m.dispersion>0&&(p.dispersion.value=m.dispersion),m.retroreflectivity>0&&(p.retroreflectivity.value=m.retroreflectivity),m.iridescence>0&&(p.iridescence.value=m.iridescence,p.iridescenceIOR.value=m.iridescenceIOR,p.iridescenceThicknessMinimum.value=m.iridescenceThicknessMinimum,p.iridescenceThicknessMaximum.value=m.iridescenceThicknessMaximum,m.iridescenceMap&&(p.iridescenceMap.value=m.iridescenceMap,e(m.iridescenceMap,p.iridescenceMapTransform)),m.iridescenceThicknessMap&&(p.iridescenceThicknessMap.value=m.iridescenceThicknessMap,e(m.iridescenceThicknessMap,p.iridescenceThicknessMapTransform))),m.transmission>0&&(p.transmission.value=m.transmission,p.transmissionSamplerMap.value=x.texture,p.transmissionSamplerSize.value.set(x.width,x.height),m.transmissionMap&&(p.transmissionMap.value=m.transmissionMap,e(m.transmissionMap,p.transmissionMapTransform)),p.thickness.value=m.thickness,m.thicknessMap&&(p.thicknessMap.value=m.thicknessMap,e(m.thicknessMap,p.thicknessMapTransform)),p.attenuationDistance.value=m.attenuationDistance,p.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(p.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(p.anisotropyMap.value=m.anisotropyMap,e(m.anisotropyMap,p.anisotropyMapTransform))),p.specularIntensity.value=m.specularIntensity,p.specularColor.value.copy(m.specularColor),m.specularColorMap&&(p.specularColorMap.value=m.specularColorMap,e(m.specularColorMap,p.specularColorMapTransform)),m.specularIntensityMap&&(p.specularIntensityMap.value=m.specularIntensityMap,e(m.specularIntensityMap,p.specularIntensityMapTransform))}function g(p,m){m.matcap&&(p.matcap.value=m.matcap)}function _(p,m){let x=t.get(m).light;p.referencePosition.value.setFromMatrixPosition(x.matrixWorld),p.nearDistance.value=x.shadow.camera.near,p.farDistance.value=x.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function tA(n,t,e,i){let s={},r={};function o(x,M){let v=M.program;i.uniformBlockBinding(x,v,s[x.id])}function a(x,M){let v=s[x.id];v===void 0&&(g(x),v=c(x),s[x.id]=v,x.addEventListener("dispose",p));let A=M.program;i.updateUBOMapping(x,A);let S=t.render.frame;r[x.id]!==S&&(l(x),r[x.id]=S)}function c(x){let M=n.createBuffer(),v=x.__size,A=x.usage;return n.bindBuffer(n.UNIFORM_BUFFER,M),n.bufferData(n.UNIFORM_BUFFER,v,A),n.bindBuffer(n.UNIFORM_BUFFER,null),M}function l(x){let M=s[x.id],v=x.uniforms,A=x.__cache;n.bindBuffer(n.UNIFORM_BUFFER,M);for(let S=0,y=v.length;S<y;S++){let w=v[S];if(Array.isArray(w))for(let U=0,L=w.length;U<L;U++)u(w[U],S,U,A);else u(w,S,0,A)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(x,M,v,A){if(f(x,M,v,A)===!0){let S=x.__offset,y=x.value;if(Array.isArray(y)){let w=0;for(let U=0;U<y.length;U++){let L=y[U],N=_(L,!0);h(L,x.__data,w),w+=N.storage/Float32Array.BYTES_PER_ELEMENT}}else h(y,x.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,S,x.__data)}}function h(x,M,v){typeof x=="number"||typeof x=="boolean"?M[v]=x:x.isMatrix3?(M[v]=x.elements[0],M[v+1]=x.elements[1],M[v+2]=x.elements[2],M[v+3]=0,M[v+4]=x.elements[3],M[v+5]=x.elements[4],M[v+6]=x.elements[5],M[v+7]=0,M[v+8]=x.elements[6],M[v+9]=x.elements[7],M[v+10]=x.elements[8],M[v+11]=0):ArrayBuffer.isView(x)?M.set(x.subarray(0,M.length-v),v):x.toArray(M,v)}function f(x,M,v,A){let S=x.value,y=M+"_"+v;if(Array.isArray(S)){A[y]===void 0&&(A[y]=[]);let w=A[y],U=!1;for(let L=0;L<S.length;L++)d(S[L],w,L)===!0&&(U=!0);return U}return d(S,A,y)}function d(x,M,v){if(M[v]===void 0)return typeof x=="number"||typeof x=="boolean"?M[v]=x:ArrayBuffer.isView(x)?M[v]=x.slice():M[v]=x.clone(),!0;{let A=M[v];if(typeof x=="number"||typeof x=="boolean"){if(A!==x)return M[v]=x,!0}else{if(ArrayBuffer.isView(x))return!0;if(A.equals(x)===!1)return A.copy(x),!0}}return!1}function g(x){let M=x.uniforms,v=0,A=16;for(let y=0,w=M.length;y<w;y++){let U=Array.isArray(M[y])?M[y]:[M[y]];for(let L=0,N=U.length;L<N;L++){let z=U[L],W=Array.isArray(z.value)?z.value:[z.value],O=Array.isArray(M[y])||Array.isArray(z.value),X=v;for(let q=0,ut=W.length;q<ut;q++){let j=W[q],tt=_(j,O),rt=v%A,dt=rt%tt.boundary,ft=rt+dt;v+=dt,ft!==0&&A-ft<tt.storage&&(v+=A-ft),q===0&&(X=v),v+=tt.storage}let Z=z.type==="int"?Int32Array:z.type==="uint"?Uint32Array:Float32Array;z.__data=new Z((v-X)/Float32Array.BYTES_PER_ELEMENT),z.__offset=X}}let S=v%A;return S>0&&(v+=A-S),x.__size=v,x.__cache={},this}function _(x,M){let v={boundary:0,storage:0};return typeof x=="number"||typeof x=="boolean"?(v.boundary=4,v.storage=4):x.isVector2?(v.boundary=8,v.storage=8):x.isVector3||x.isColor?(v.boundary=16,v.storage=12):x.isVector4?(v.boundary=16,v.storage=16):x.isMatrix3?(v.boundary=16,v.storage=48):x.isMatrix4?(v.boundary=16,v.storage=64):x.isTexture?jt("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(x)?(v.boundary=16,v.storage=x.byteLength):jt("WebGLRenderer: Unsupported uniform value type.",x),M===!0&&(v.boundary=16,v.storage=Math.ceil(v.storage/16)*16),v}function p(x){let M=x.target;M.removeEventListener("dispose",p),n.deleteBuffer(s[M.id]),delete s[M.id],delete r[M.id]}function m(){for(let x in s)n.deleteBuffer(s[x]);s={},r={}}return{bind:o,update:a,dispose:m}}var eA=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),Us=null;function nA(){return Us===null&&(Us=new Dl(eA,16,16,kr,hs),Us.name="DFG_LUT",Us.minFilter=fi,Us.magFilter=fi,Us.wrapS=Ps,Us.wrapT=Ps,Us.generateMipmaps=!1,Us.needsUpdate=!0),Us}var qh=class{constructor(t={}){let{canvas:e=S_(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:c=!0,preserveDrawingBuffer:l=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:f=!1,outputBufferType:d=Bi}=t;this.isWebGLRenderer=!0;let g;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=i.getContextAttributes().alpha}else g=o;let _=d,p=new Set([ch,lh,ah]),m=new Set([Bi,us,Ta,mo,sh,rh]),x=new Uint32Array(4),M=new Int32Array(4),v={textures:[],min:[],max:[],resolution:[]},A=null,S=null,y=[],w=[],U=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=Ns,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let L=this,N=!1,z=null,W=null,O=null,X=null;this._outputColorSpace=ui;let Z=0,q=0,ut=null,j=-1,tt=null,rt=new hn,dt=new hn,ft=null,et=new ee(0),_t=0,bt=e.width,Pt=e.height,Et=1,Zt=null,ue=null,$t=new hn(0,0,bt,Pt),xe=new hn(0,0,bt,Pt),me=!1,le=new oo,an=new Uu,Ke=!1,Mn=!1,Ve=new Te,kn=new H,Re=new hn,In={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},fn=!1;function Sn(){return ut===null?Et:1}let k=i;function Lt(C,G){return e.getContext(C,G)}let Qt,he,Tt,Xe,Xt,Kt,I,T,$,ht,at,vt,Mt,nt,st,mt,B,ot,it,At,xt,wt,Yt;try{let C={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:c,preserveDrawingBuffer:l,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",Gt,!1),e.addEventListener("webglcontextrestored",re,!1),e.addEventListener("webglcontextcreationerror",It,!1),k===null){let G="webgl2";if(k=Lt(G,C),k===null)throw Lt(G)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}se()}catch(C){throw e.removeEventListener("webglcontextlost",Gt,!1),e.removeEventListener("webglcontextrestored",re,!1),e.removeEventListener("webglcontextcreationerror",It,!1),ie("WebGLRenderer: "+C.message),C}function se(){Qt=new d1(k),Qt.init(),xt=new ZT(k,Qt),he=new n1(k,Qt,t,xt),Tt=new $T(k,Qt),he.reversedDepthBuffer&&f&&Tt.buffers.depth.setReversed(!0),W=k.createFramebuffer(),O=k.createFramebuffer(),X=k.createFramebuffer(),Xe=new g1(k),Xt=new DT,Kt=new YT(k,Qt,Tt,Xt,he,xt,Xe),I=new f1(L),T=new xS(k),wt=new t1(k,T),$=new p1(k,T,Xe,wt),ht=new x1(k,$,T,wt,Xe),ot=new _1(k,he,Kt),st=new i1(Xt),at=new LT(L,I,Qt,he,wt,st),vt=new QT(L,Xt),Mt=new UT,nt=new HT(Qt),B=new QE(L,I,Tt,ht,g,c),mt=new XT(L,ht,he),Yt=new tA(k,Xe,he,Tt),it=new e1(k,Qt,Xe),At=new m1(k,Qt,Xe),Xe.programs=at.programs,L.capabilities=he,L.extensions=Qt,L.properties=Xt,L.renderLists=Mt,L.shadowMap=mt,L.state=Tt,L.info=Xe}_!==Bi&&(U=new v1(_,e.width,e.height,a,s,r));let ct=new Yp(L,k);this.xr=ct,this.getContext=function(){return k},this.getContextAttributes=function(){return k.getContextAttributes()},this.forceContextLoss=function(){let C=Qt.get("WEBGL_lose_context");C&&C.loseContext()},this.forceContextRestore=function(){let C=Qt.get("WEBGL_lose_context");C&&C.restoreContext()},this.getPixelRatio=function(){return Et},this.setPixelRatio=function(C){C!==void 0&&(Et=C,this.setSize(bt,Pt,!1))},this.getSize=function(C){return C.set(bt,Pt)},this.setSize=function(C,G,Q=!0){if(ct.isPresenting){jt("WebGLRenderer: Can't change size while VR device is presenting.");return}bt=C,Pt=G,e.width=Math.floor(C*Et),e.height=Math.floor(G*Et),Q===!0&&(e.style.width=C+"px",e.style.height=G+"px"),U!==null&&U.setSize(e.width,e.height),this.setViewport(0,0,C,G)},this.getDrawingBufferSize=function(C){return C.set(bt*Et,Pt*Et).floor()},this.setDrawingBufferSize=function(C,G,Q){bt=C,Pt=G,Et=Q,e.width=Math.floor(C*Q),e.height=Math.floor(G*Q),this.setViewport(0,0,C,G)},this.setEffects=function(C){if(_===Bi){ie("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(C){for(let G=0;G<C.length;G++)if(C[G].isOutputPass===!0){jt("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}U.setEffects(C||[])},this.getCurrentViewport=function(C){return C.copy(rt)},this.getViewport=function(C){return C.copy($t)},this.setViewport=function(C,G,Q,Y){C.isVector4?$t.set(C.x,C.y,C.z,C.w):$t.set(C,G,Q,Y),Tt.viewport(rt.copy($t).multiplyScalar(Sn()).round())},this.getScissor=function(C){return C.copy(xe)},this.setScissor=function(C,G,Q,Y){C.isVector4?xe.set(C.x,C.y,C.z,C.w):xe.set(C,G,Q,Y),Tt.scissor(dt.copy(xe).multiplyScalar(Sn()).round())},this.getScissorTest=function(){return me},this.setScissorTest=function(C){Tt.setScissorTest(me=C)},this.setOpaqueSort=function(C){Zt=C},this.setTransparentSort=function(C){ue=C},this.getClearColor=function(C){return C.copy(B.getClearColor())},this.setClearColor=function(){B.setClearColor(...arguments)},this.getClearAlpha=function(){return B.getClearAlpha()},this.setClearAlpha=function(){B.setClearAlpha(...arguments)},this.clear=function(C=!0,G=!0,Q=!0){let Y=0;if(C){let J=!1;if(ut!==null){let Rt=ut.texture.format;J=p.has(Rt)}if(J){let Rt=ut.texture.type,Nt=m.has(Rt),Ct=B.getClearColor(),Ft=B.getClearAlpha(),Wt=Ct.r,oe=Ct.g,be=Ct.b;Nt?(x[0]=Wt,x[1]=oe,x[2]=be,x[3]=Ft,k.clearBufferuiv(k.COLOR,0,x)):(M[0]=Wt,M[1]=oe,M[2]=be,M[3]=Ft,k.clearBufferiv(k.COLOR,0,M))}else Y|=k.COLOR_BUFFER_BIT}G&&(Y|=k.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),Q&&(Y|=k.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Y!==0&&k.clear(Y)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(C){C.setRenderer(this),z=C},this.dispose=function(){e.removeEventListener("webglcontextlost",Gt,!1),e.removeEventListener("webglcontextrestored",re,!1),e.removeEventListener("webglcontextcreationerror",It,!1),B.dispose(),Mt.dispose(),nt.dispose(),Kt.dispose(),Xt.dispose(),I.dispose(),ht.dispose(),$.dispose(),wt.dispose(),Yt.dispose(),at.dispose(),ct.dispose(),ct.removeEventListener("sessionstart",Lc),ct.removeEventListener("sessionend",vs),zs.stop()};function Gt(C){C.preventDefault(),El("WebGLRenderer: Context Lost."),N=!0}function re(){El("WebGLRenderer: Context Restored."),N=!1;let C=Xe.autoReset,G=mt.enabled,Q=mt.autoUpdate,Y=mt.needsUpdate,J=mt.type;se(),Xe.autoReset=C,mt.enabled=G,mt.autoUpdate=Q,mt.needsUpdate=Y,mt.type=J}function It(C){ie("WebGLRenderer: A WebGL context could not be created. Reason: ",C.statusMessage)}function fe(C){let G=C.target;G.removeEventListener("dispose",fe),je(G)}function je(C){si(C),Xt.remove(C)}function si(C){let G=Xt.get(C).programs;G!==void 0&&(G.forEach(function(Q){at.releaseProgram(Q)}),C.isShaderMaterial&&at.releaseShaderCache(C))}this.renderBufferDirect=function(C,G,Q,Y,J,Rt){G===null&&(G=In);let Nt=J.isMesh&&J.matrixWorld.determinantAffine()<0,Ct=tl(C,G,Q,Y,J);Tt.setMaterial(Y,Nt);let Ft=Q.index,Wt=1;if(Y.wireframe===!0){if(Ft=$.getWireframeAttribute(Q),Ft===void 0)return;Wt=2}let oe=Q.drawRange,be=Q.attributes.position,Vt=oe.start*Wt,Me=(oe.start+oe.count)*Wt;Rt!==null&&(Vt=Math.max(Vt,Rt.start*Wt),Me=Math.min(Me,(Rt.start+Rt.count)*Wt)),Ft!==null?(Vt=Math.max(Vt,0),Me=Math.min(Me,Ft.count)):be!=null&&(Vt=Math.max(Vt,0),Me=Math.min(Me,be.count));let cn=Me-Vt;if(cn<0||cn===1/0)return;wt.setup(J,Y,Ct,Q,Ft);let ke,ze=it;if(Ft!==null&&(ke=T.get(Ft),ze=At,ze.setIndex(ke)),J.isMesh)Y.wireframe===!0?(Tt.setLineWidth(Y.wireframeLinewidth*Sn()),ze.setMode(k.LINES)):ze.setMode(k.TRIANGLES);else if(J.isLine){let Ln=Y.linewidth;Ln===void 0&&(Ln=1),Tt.setLineWidth(Ln*Sn()),J.isLineSegments?ze.setMode(k.LINES):J.isLineLoop?ze.setMode(k.LINE_LOOP):ze.setMode(k.LINE_STRIP)}else J.isPoints?ze.setMode(k.POINTS):J.isSprite&&ze.setMode(k.TRIANGLES);if(J.isBatchedMesh)if(Qt.get("WEBGL_multi_draw"))ze.renderMultiDraw(J._multiDrawStarts,J._multiDrawCounts,J._multiDrawCount);else{let Ln=J._multiDrawStarts,zt=J._multiDrawCounts,wn=J._multiDrawCount,we=Ft?T.get(Ft).bytesPerElement:1,Gs=Xt.get(Y).currentProgram.getUniforms();for(let En=0;En<wn;En++)Gs.setValue(k,"_gl_DrawID",En),ze.render(Ln[En]/we,zt[En])}else if(J.isInstancedMesh)ze.renderInstances(Vt,cn,J.count);else if(Q.isInstancedBufferGeometry){let Ln=Q._maxInstanceCount!==void 0?Q._maxInstanceCount:1/0,zt=Math.min(Q.instanceCount,Ln);ze.renderInstances(Vt,cn,zt)}else ze.render(Vt,cn)};function Ka(C,G,Q,Y){z!==null&&C.isNodeMaterial&&z.setObject(Y,C),Ke===!0&&st.setState(C,Q,!1),C.transparent===!0&&C.side===Ji&&C.forceSinglePass===!1?(C.side=mi,C.needsUpdate=!0,bs(C,G,Y),C.side=Br,C.needsUpdate=!0,bs(C,G,Y),C.side=Ji):bs(C,G,Y)}this.compile=function(C,G,Q=null){Q===null&&(Q=C),z!==null&&z.renderStart(C,G,Q),S=nt.get(Q),S.init(G),w.push(S),Q.traverseVisible(function(J){J.isLight&&J.layers.test(G.layers)&&(S.pushLight(J),J.castShadow&&S.pushShadow(J))}),C!==Q&&C.traverseVisible(function(J){J.isLight&&J.layers.test(G.layers)&&(S.pushLight(J),J.castShadow&&S.pushShadow(J))}),S.setupLights(),z!==null&&z.updateLights(S.state.lightsArray),Mn=this.localClippingEnabled,Ke=st.init(this.clippingPlanes,Mn),Ke===!0&&st.setGlobalState(this.clippingPlanes,G),z!==null&&mt.render(S.state.shadowsArray,Q,G);let Y=new Set;return C.traverse(function(J){if(!(J.isMesh||J.isPoints||J.isLine||J.isSprite))return;let Rt=J.material;if(Rt)if(Array.isArray(Rt))for(let Nt=0;Nt<Rt.length;Nt++){let Ct=Rt[Nt];Ka(Ct,Q,G,J),Y.add(Ct)}else Ka(Rt,Q,G,J),Y.add(Rt)}),S=w.pop(),z!==null&&z.renderEnd(),Y},this.compileAsync=function(C,G,Q=null){let Y=this.compile(C,G,Q);return new Promise(J=>{function Rt(){if(Y.forEach(function(Nt){let Ft=Xt.get(Nt).currentProgram;(Ft===void 0||Ft.isReady())&&Y.delete(Nt)}),Y.size===0){J(C);return}setTimeout(Rt,10)}Qt.get("KHR_parallel_shader_compile")!==null?Rt():setTimeout(Rt,10)})};let Lo=null;function dd(C){Lo&&Lo(C)}function Lc(){zs.stop()}function vs(){zs.start()}let zs=new Q_;zs.setAnimationLoop(dd),typeof self<"u"&&zs.setContext(self),this.setAnimationLoop=function(C){Lo=C,ct.setAnimationLoop(C),C===null?zs.stop():zs.start()},ct.addEventListener("sessionstart",Lc),ct.addEventListener("sessionend",vs),this.render=function(C,G){if(G!==void 0&&G.isCamera!==!0){ie("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(N===!0)return;z!==null&&z.renderStart(C,G);let Q=ct.enabled===!0&&ct.isPresenting===!0,Y=U!==null&&(ut===null||Q)&&U.begin(L,ut);if(C.matrixWorldAutoUpdate===!0&&C.updateMatrixWorld(),G.parent===null&&G.matrixWorldAutoUpdate===!0&&G.updateMatrixWorld(),ct.enabled===!0&&ct.isPresenting===!0&&(U===null||U.isCompositing()===!1)&&(ct.cameraAutoUpdate===!0&&ct.updateCamera(G),G=ct.getCamera()),C.isScene===!0&&C.onBeforeRender(L,C,G,ut),S=nt.get(C,w.length),S.init(G),S.state.textureUnits=Kt.getTextureUnits(),w.push(S),Ve.multiplyMatrices(G.projectionMatrix,G.matrixWorldInverse),G.isArrayCamera?an.setFromArrayCamera(G):le.setFromProjectionMatrix(Ve,Yi,G.reversedDepth),Mn=this.localClippingEnabled,Ke=st.init(this.clippingPlanes,Mn),A=Mt.get(C,y.length),A.init(),y.push(A),this.info.render.frame++,ct.enabled===!0&&ct.isPresenting===!0){let Nt=L.xr.getDepthSensingMesh();Nt!==null&&Hs(Nt,G,-1/0,L.sortObjects)}Hs(C,G,0,L.sortObjects),A.finish(),z!==null&&z.updateLights(S.state.lightsArray),L.sortObjects===!0&&A.sort(Zt,ue),fn=ct.enabled===!1||ct.isPresenting===!1||ct.hasDepthSensing()===!1,fn&&B.addToRenderList(A,C),this.info.autoReset===!0&&this.info.reset(),Ke===!0&&st.beginShadows();let J=S.state.shadowsArray;if(mt.render(J,C,G),Ke===!0&&st.endShadows(),(Y&&U.hasRenderPass())===!1){let Nt=A.opaque,Ct=A.transmissive;if(S.setupLights(),G.isArrayCamera){let Ft=G.cameras;if(Ct.length>0)for(let Wt=0,oe=Ft.length;Wt<oe;Wt++){let be=Ft[Wt];ns(Nt,Ct,C,be)}fn&&B.render(C);for(let Wt=0,oe=Ft.length;Wt<oe;Wt++){let be=Ft[Wt];ja(A,C,be,be.viewport)}}else Ct.length>0&&ns(Nt,Ct,C,G),fn&&B.render(C),ja(A,C,G)}ut!==null&&q===0&&(Kt.updateMultisampleRenderTarget(ut),Kt.updateRenderTargetMipmap(ut)),Y&&U.end(L),C.isScene===!0&&C.onAfterRender(L,C,G),wt.resetDefaultState(),j=-1,tt=null,w.pop(),w.length>0?(S=w[w.length-1],Kt.setTextureUnits(S.state.textureUnits),Ke===!0&&st.setGlobalState(L.clippingPlanes,S.state.camera)):S=null,y.pop(),y.length>0?A=y[y.length-1]:A=null,z!==null&&z.renderEnd()};function Hs(C,G,Q,Y){if(C.visible===!1)return;if(C.layers.test(G.layers)){if(C.isGroup)Q=C.renderOrder;else if(C.isLOD)C.autoUpdate===!0&&C.update(G);else if(C.isLight)S.pushLight(C),C.castShadow&&S.pushShadow(C);else if(C.isSprite){let Nt=G.isArrayCamera?an:le;if(!C.frustumCulled||C.intersectsFrustum(Nt)){Y&&Re.setFromMatrixPosition(C.matrixWorld).applyMatrix4(Ve);let Ct=ht.update(C),Ft=C.material;Ft.visible&&A.push(C,Ct,Ft,Q,Re.z,null,G)}}else if(C.isMesh||C.isLine||C.isPoints){let Nt=G.isArrayCamera?an:le;if(!C.frustumCulled||C.intersectsFrustum(Nt)){let Ct=ht.update(C),Ft=C.material;if(Y&&(C.boundingSphere!==void 0?(C.boundingSphere===null&&C.computeBoundingSphere(),Re.copy(C.boundingSphere.center)):(Ct.boundingSphere===null&&Ct.computeBoundingSphere(),Re.copy(Ct.boundingSphere.center)),Re.applyMatrix4(C.matrixWorld).applyMatrix4(Ve)),Array.isArray(Ft)){let Wt=Ct.groups;for(let oe=0,be=Wt.length;oe<be;oe++){let Vt=Wt[oe],Me=Ft[Vt.materialIndex];Me&&Me.visible&&A.push(C,Ct,Me,Q,Re.z,Vt,G)}}else Ft.visible&&A.push(C,Ct,Ft,Q,Re.z,null,G)}}}let Rt=C.children;for(let Nt=0,Ct=Rt.length;Nt<Ct;Nt++)Hs(Rt[Nt],G,Q,Y)}function ja(C,G,Q,Y){let{opaque:J,transmissive:Rt,transparent:Nt}=C;S.setupLightsView(Q),Ke===!0&&st.setGlobalState(L.clippingPlanes,Q),Y&&Tt.viewport(rt.copy(Y)),J.length>0&&dn(J,G,Q),Rt.length>0&&dn(Rt,G,Q),Nt.length>0&&dn(Nt,G,Q),Tt.buffers.depth.setTest(!0),Tt.buffers.depth.setMask(!0),Tt.buffers.color.setMask(!0),Tt.setPolygonOffset(!1)}function ns(C,G,Q,Y){if((Q.isScene===!0?Q.overrideMaterial:null)!==null)return;if(S.state.transmissionRenderTarget[Y.id]===void 0){let Vt=Qt.has("EXT_color_buffer_half_float")||Qt.has("EXT_color_buffer_float");S.state.transmissionRenderTarget[Y.id]=new Fi(1,1,{generateMipmaps:!0,type:Vt?hs:Bi,minFilter:ar,samples:Math.max(4,he.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:Ee.workingColorSpace})}let Rt=S.state.transmissionRenderTarget[Y.id],Nt=Y.viewport||rt;Rt.setSize(Nt.z*L.transmissionResolutionScale,Nt.w*L.transmissionResolutionScale);let Ct=L.getRenderTarget(),Ft=L.getActiveCubeFace(),Wt=L.getActiveMipmapLevel();L.setRenderTarget(Rt),L.getClearColor(et),_t=L.getClearAlpha(),_t<1&&L.setClearColor(16777215,.5),L.clear(),fn&&B.render(Q);let oe=L.toneMapping;L.toneMapping=Ns;let be=Y.viewport;if(Y.viewport!==void 0&&(Y.viewport=void 0),S.setupLightsView(Y),Ke===!0&&st.setGlobalState(L.clippingPlanes,Y),dn(C,Q,Y),Kt.updateMultisampleRenderTarget(Rt),Kt.updateRenderTargetMipmap(Rt),Qt.has("WEBGL_multisampled_render_to_texture")===!1){let Vt=!1;for(let Me=0,cn=G.length;Me<cn;Me++){let ke=G[Me],{object:ze,geometry:Ln,material:zt,group:wn}=ke;if(zt.side===Ji&&ze.layers.test(Y.layers)){let we=zt.side;zt.side=mi,zt.needsUpdate=!0,vn(ze,Q,Y,Ln,zt,wn),zt.side=we,zt.needsUpdate=!0,Vt=!0}}Vt===!0&&(Kt.updateMultisampleRenderTarget(Rt),Kt.updateRenderTargetMipmap(Rt))}L.setRenderTarget(Ct,Ft,Wt),L.setClearColor(et,_t),be!==void 0&&(Y.viewport=be),L.toneMapping=oe}function dn(C,G,Q){let Y=G.isScene===!0?G.overrideMaterial:null;for(let J=0,Rt=C.length;J<Rt;J++){let Nt=C[J],{object:Ct,geometry:Ft,group:Wt}=Nt,oe=Nt.material;oe.allowOverride===!0&&Y!==null&&(oe=Y),Ct.layers.test(Q.layers)&&vn(Ct,G,Q,Ft,oe,Wt)}}function vn(C,G,Q,Y,J,Rt){z!==null&&J.isNodeMaterial&&z.setObject(C,J),C.onBeforeRender(L,G,Q,Y,J,Rt),C.modelViewMatrix.multiplyMatrices(Q.matrixWorldInverse,C.matrixWorld),C.normalMatrix.getNormalMatrix(C.modelViewMatrix),J.onBeforeRender(L,G,Q,Y,C,Rt),J.transparent===!0&&J.side===Ji&&J.forceSinglePass===!1?(J.side=mi,J.needsUpdate=!0,L.renderBufferDirect(Q,G,Y,J,C,Rt),J.side=Br,J.needsUpdate=!0,L.renderBufferDirect(Q,G,Y,J,C,Rt),J.side=Ji):L.renderBufferDirect(Q,G,Y,J,C,Rt),C.onAfterRender(L,G,Q,Y,J,Rt)}function bn(C){let G=0;for(let Q of C)Q.texture!==null&&G++;return G}function bs(C,G,Q){G.isScene!==!0&&(G=In);let Y=Xt.get(C),J=S.state.lights,Rt=S.state.shadowsArray,Nt=J.state.version,Ct=at.getParameters(C,J.state,Rt,G,Q,S.state.lightProbeGridArray),Ft=at.getProgramCacheKey(Ct),Wt=Y.programs;Y.environment=C.isMeshStandardMaterial||C.isMeshLambertMaterial||C.isMeshPhongMaterial?G.environment:null,Y.fog=G.fog;let oe=C.isMeshStandardMaterial||C.isMeshLambertMaterial&&!C.envMap||C.isMeshPhongMaterial&&!C.envMap;Y.envMap=I.get(C.envMap||Y.environment,oe),Y.envMapRotation=Y.environment!==null&&C.envMap===null?G.environmentRotation:C.envMapRotation,Wt===void 0&&(C.addEventListener("dispose",fe),Wt=new Map,Y.programs=Wt,Y.programVariants=new Map);let be=Wt.get(Ft);if(be!==void 0){if(Y.currentProgram===be&&Y.lightsStateVersion===Nt)return Qa(C,Ct),be}else Ct.uniforms=at.getUniforms(C),z!==null&&C.isNodeMaterial&&z.build(C,Q,Ct),C.onBeforeCompile(Ct,L),be=at.acquireProgram(Ct,Ft),Wt.set(Ft,be),Y.uniforms=Ct.uniforms;let Vt=Y.uniforms;return(!C.isShaderMaterial&&!C.isRawShaderMaterial||C.clipping===!0)&&(Vt.clippingPlanes=st.uniform),Qa(C,Ct),Y.needsLights=gr(C),Y.lightsStateVersion=Nt,Y.needsLights&&(Vt.ambientLightColor.value=J.state.ambient,Vt.lightProbe.value=J.state.probe,Vt.sunLights.value=J.state.sun,Vt.sunLightShadows.value=J.state.sunShadow,Vt.directionalLights.value=J.state.directional,Vt.directionalLightShadows.value=J.state.directionalShadow,Vt.spotLights.value=J.state.spot,Vt.spotLightShadows.value=J.state.spotShadow,Vt.rectAreaLights.value=J.state.rectArea,Vt.ltc_1.value=J.state.rectAreaLTC1,Vt.ltc_2.value=J.state.rectAreaLTC2,Vt.pointLights.value=J.state.point,Vt.pointLightShadows.value=J.state.pointShadow,Vt.hemisphereLights.value=J.state.hemi,Vt.sunShadowMatrix.value=J.state.sunShadowMatrix,Vt.sunShadowCascade.value=J.state.sunShadowCascade,Vt.directionalShadowMatrix.value=J.state.directionalShadowMatrix,Vt.spotLightMatrix.value=J.state.spotLightMatrix,Vt.spotLightMap.value=J.state.spotLightMap,Vt.pointShadowMatrix.value=J.state.pointShadowMatrix),Y.numLightProbeGrids=bn(S.state.lightProbeGridArray),Y.currentProgram=be,Y.uniformsList=null,be}function Ci(C,G,Q,Y,J){let Rt=Xt.get(C),Nt=Rt.currentProgram.id+","+Y+","+J,Ct=Rt.programVariants.get(Nt);return Ct===void 0?(Ct=bs(C,G,Q),Rt.programVariants.set(Nt,Ct)):(Rt.currentProgram=Ct,Rt.uniformsList=null,Rt.outputColorSpace=Y,Rt.toneMapping=J),Ct}function mr(C){if(C.uniformsList===null){let G=C.currentProgram.getUniforms();C.uniformsList=Aa.seqWithValue(G.seq,C.uniforms)}return C.uniformsList}function Qa(C,G){let Q=Xt.get(C);Q.outputColorSpace=G.outputColorSpace,Q.batching=G.batching,Q.batchingColor=G.batchingColor,Q.instancing=G.instancing,Q.instancingColor=G.instancingColor,Q.instancingMorph=G.instancingMorph,Q.skinning=G.skinning,Q.morphTargets=G.morphTargets,Q.morphNormals=G.morphNormals,Q.morphColors=G.morphColors,Q.morphTargetsCount=G.morphTargetsCount,Q.numClippingPlanes=G.numClippingPlanes,Q.numIntersection=G.numClipIntersection,Q.vertexAlphas=G.vertexAlphas,Q.vertexTangents=G.vertexTangents,Q.toneMapping=G.toneMapping}function tl(C,G,Q,Y,J){G.isScene!==!0&&(G=In),Kt.resetTextureUnits();let Rt=G.fog,Nt=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial?G.environment:null,Ct=ut===null?L.outputColorSpace:ut.isXRRenderTarget===!0?ut.texture.colorSpace:Ee.workingColorSpace,Ft=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial&&!Y.envMap||Y.isMeshPhongMaterial&&!Y.envMap,Wt=I.get(Y.envMap||Nt,Ft),oe=Y.vertexColors===!0&&!!Q.attributes.color&&Q.attributes.color.itemSize===4,be=!!Q.attributes.tangent&&(!!Y.normalMap||Y.anisotropy>0),Vt=!!Q.morphAttributes.position,Me=!!Q.morphAttributes.normal,cn=!!Q.morphAttributes.color,ke=Ns;Y.toneMapped&&(ut===null||ut.isXRRenderTarget===!0)&&(ke=L.toneMapping);let ze=Q.morphAttributes.position||Q.morphAttributes.normal||Q.morphAttributes.color,Ln=ze!==void 0?ze.length:0,zt=Xt.get(Y),wn=S.state.lights;if(Ke===!0&&(Mn===!0||C!==tt)){let He=C===tt&&Y.id===j;st.setState(Y,C,He)}let we=!1,Gs=!1;Y.version===zt.__version?zt.needsLights&&zt.lightsStateVersion!==wn.state.version||J.isBatchedMesh&&zt.batching===!1||!J.isBatchedMesh&&zt.batching===!0||J.isBatchedMesh&&zt.batchingColor===!0&&J._colorsTexture===null||J.isBatchedMesh&&zt.batchingColor===!1&&J._colorsTexture!==null||J.isInstancedMesh&&zt.instancing===!1||!J.isInstancedMesh&&zt.instancing===!0||J.isSkinnedMesh&&zt.skinning===!1||!J.isSkinnedMesh&&zt.skinning===!0||J.isInstancedMesh&&zt.instancingColor===!0&&J.instanceColor===null||J.isInstancedMesh&&zt.instancingColor===!1&&J.instanceColor!==null||J.isInstancedMesh&&zt.instancingMorph===!0&&J.morphTexture===null||J.isInstancedMesh&&zt.instancingMorph===!1&&J.morphTexture!==null||zt.envMap!==Wt||Y.fog===!0&&zt.fog!==Rt||zt.numClippingPlanes!==void 0&&(zt.numClippingPlanes!==st.numPlanes||zt.numIntersection!==st.numIntersection)||zt.vertexAlphas!==oe||zt.vertexTangents!==be||zt.morphTargets!==Vt||zt.morphNormals!==Me||zt.morphColors!==cn||zt.morphTargetsCount!==Ln||zt.numLightProbeGrids!==bn(S.state.lightProbeGridArray)?we=!0:(zt.outputColorSpace!==Ct||zt.toneMapping!==ke)&&(Gs=!0):(we=!0,zt.__version=Y.version);let En=zt.currentProgram;(we===!0||Gs===!0)&&(En=Gs===!0?Ci(Y,G,J,Ct,ke):bs(Y,G,J),z&&Y.isNodeMaterial&&z.onUpdateProgram(Y,En,zt));let Uo=!1,Ms=!1,Vs=!1,ge=En.getUniforms(),pn=zt.uniforms;if(Tt.useProgram(En.program)&&(Uo=!0,Ms=!0,Vs=!0),Y.id!==j&&(j=Y.id,Ms=!0),Uo||tt!==C){Tt.buffers.depth.getReversed()&&C.reversedDepth!==!0&&(C._reversedDepth=!0,C.updateProjectionMatrix()),ge.setValue(k,"projectionMatrix",C.projectionMatrix),ge.setValue(k,"viewMatrix",C.matrixWorldInverse);let Tn=ge.map.cameraPosition;Tn!==void 0&&Tn.setValue(k,kn.setFromMatrixPosition(C.matrixWorld)),he.logarithmicDepthBuffer&&ge.setValue(k,"logDepthBufFC",2/(Math.log(C.far+1)/Math.LN2)),(Y.isMeshPhongMaterial||Y.isMeshToonMaterial||Y.isMeshLambertMaterial||Y.isMeshBasicMaterial||Y.isMeshStandardMaterial||Y.isShaderMaterial)&&ge.setValue(k,"isOrthographic",C.isOrthographicCamera===!0),tt!==C&&(tt=C,Ms=!0,Vs=!0)}if(zt.needsLights&&(wn.state.sunShadowMap.length>0&&ge.setValue(k,"sunShadowMap",wn.state.sunShadowMap,Kt),wn.state.directionalShadowMap.length>0&&ge.setValue(k,"directionalShadowMap",wn.state.directionalShadowMap,Kt),wn.state.spotShadowMap.length>0&&ge.setValue(k,"spotShadowMap",wn.state.spotShadowMap,Kt),wn.state.pointShadowMap.length>0&&ge.setValue(k,"pointShadowMap",wn.state.pointShadowMap,Kt)),J.isSkinnedMesh){ge.setOptional(k,J,"bindMatrix"),ge.setOptional(k,J,"bindMatrixInverse");let He=J.skeleton;He&&(He.boneTexture===null&&He.computeBoneTexture(),ge.setValue(k,"boneTexture",He.boneTexture,Kt))}J.isBatchedMesh&&(ge.setOptional(k,J,"batchingTexture"),ge.setValue(k,"batchingTexture",J._matricesTexture,Kt),ge.setOptional(k,J,"batchingIdTexture"),ge.setValue(k,"batchingIdTexture",J._indirectTexture,Kt),ge.setOptional(k,J,"batchingColorTexture"),J._colorsTexture!==null&&ge.setValue(k,"batchingColorTexture",J._colorsTexture,Kt));let ri=Q.morphAttributes;if((ri.position!==void 0||ri.normal!==void 0||ri.color!==void 0)&&ot.update(J,Q,En),(Ms||zt.receiveShadow!==J.receiveShadow)&&(zt.receiveShadow=J.receiveShadow,ge.setValue(k,"receiveShadow",J.receiveShadow)),(Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial)&&Y.envMap===null&&G.environment!==null&&(pn.envMapIntensity.value=G.environmentIntensity),pn.dfgLUT!==void 0&&(pn.dfgLUT.value=nA()),Ms){if(ge.setValue(k,"toneMappingExposure",L.toneMappingExposure),zt.needsLights&&Do(pn,Vs),Rt&&Y.fog===!0&&vt.refreshFogUniforms(pn,Rt),vt.refreshMaterialUniforms(pn,Y,Et,Pt,S.state.transmissionRenderTarget[C.id]),zt.needsLights&&zt.numLightProbeGrids>0){let He=v,Tn=0;for(let Kn of S.state.lightProbeGridArray)Kn.texture!==null&&(He.textures[Tn]=Kn.texture,He.min[Tn]=Kn.boundingBox.min,He.max[Tn]=Kn.boundingBox.max,He.resolution[Tn]=Kn.resolution,Tn++);for(let Kn in He)He[Kn].length=Tn;pn.probesSH.value=He.textures,pn.probesMin.value=He.min,pn.probesMax.value=He.max,pn.probesResolution.value=He.resolution}Aa.upload(k,mr(zt),pn,Kt)}if(Y.isShaderMaterial&&Y.uniformsNeedUpdate===!0&&(Aa.upload(k,mr(zt),pn,Kt),Y.uniformsNeedUpdate=!1),Y.isSpriteMaterial&&ge.setValue(k,"center",J.center),ge.setValue(k,"modelViewMatrix",J.modelViewMatrix),ge.setValue(k,"normalMatrix",J.normalMatrix),ge.setValue(k,"modelMatrix",J.matrixWorld),Y.uniformsGroups!==void 0){let He=Y.uniformsGroups;for(let Tn=0,Kn=He.length;Tn<Kn;Tn++){let Dc=He[Tn];Yt.update(Dc,En),Yt.bind(Dc,En)}}return En}function Do(C,G){C.ambientLightColor.needsUpdate=G,C.lightProbe.needsUpdate=G,C.sunLights.needsUpdate=G,C.sunLightShadows.needsUpdate=G,C.directionalLights.needsUpdate=G,C.directionalLightShadows.needsUpdate=G,C.pointLights.needsUpdate=G,C.pointLightShadows.needsUpdate=G,C.spotLights.needsUpdate=G,C.spotLightShadows.needsUpdate=G,C.rectAreaLights.needsUpdate=G,C.hemisphereLights.needsUpdate=G}function gr(C){return C.isMeshLambertMaterial||C.isMeshToonMaterial||C.isMeshPhongMaterial||C.isMeshStandardMaterial||C.isShadowMaterial||C.isShaderMaterial&&C.lights===!0}this.getActiveCubeFace=function(){return Z},this.getActiveMipmapLevel=function(){return q},this.getRenderTarget=function(){return ut},this.setRenderTargetTextures=function(C,G,Q){let Y=Xt.get(C);Y.__autoAllocateDepthBuffer=C.resolveDepthBuffer===!1,Y.__autoAllocateDepthBuffer===!1&&(Y.__useRenderToTexture=!1),Xt.get(C.texture).__webglTexture=G,Xt.get(C.depthTexture).__webglTexture=Y.__autoAllocateDepthBuffer?void 0:Q,Y.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(C,G){let Q=Xt.get(C);Q.__webglFramebuffer=G,Q.__useDefaultFramebuffer=G===void 0},this.setRenderTarget=function(C,G=0,Q=0){ut=C,Z=G,q=Q;let Y=null,J=!1,Rt=!1;if(C){let Ct=Xt.get(C);if(Ct.__useDefaultFramebuffer!==void 0){Tt.bindFramebuffer(k.FRAMEBUFFER,Ct.__webglFramebuffer),rt.copy(C.viewport),dt.copy(C.scissor),ft=C.scissorTest,Tt.viewport(rt),Tt.scissor(dt),Tt.setScissorTest(ft),j=-1;return}else if(Ct.__webglFramebuffer===void 0)Kt.setupRenderTarget(C);else if(Ct.__hasExternalTextures)Kt.rebindTextures(C,Xt.get(C.texture).__webglTexture,Xt.get(C.depthTexture).__webglTexture);else if(C.depthBuffer){let oe=C.depthTexture;if(Ct.__boundDepthTexture!==oe){if(oe!==null&&Xt.has(oe)&&(C.width!==oe.image.width||C.height!==oe.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Kt.setupDepthRenderbuffer(C)}}let Ft=C.texture;(Ft.isData3DTexture||Ft.isDataArrayTexture||Ft.isCompressedArrayTexture)&&(Rt=!0);let Wt=Xt.get(C).__webglFramebuffer;C.isWebGLCubeRenderTarget?(Array.isArray(Wt[G])?Y=Wt[G][Q]:Y=Wt[G],J=!0):C.samples>0&&Kt.useMultisampledRTT(C)===!1?Y=Xt.get(C).__webglMultisampledFramebuffer:Array.isArray(Wt)?Y=Wt[Q]:Y=Wt,rt.copy(C.viewport),dt.copy(C.scissor),ft=C.scissorTest}else rt.copy($t).multiplyScalar(Et).floor(),dt.copy(xe).multiplyScalar(Et).floor(),ft=me;if(Q!==0&&(Y=W),Tt.bindFramebuffer(k.FRAMEBUFFER,Y)&&Tt.drawBuffers(C,Y),Tt.viewport(rt),Tt.scissor(dt),Tt.setScissorTest(ft),J){let Ct=Xt.get(C.texture);k.framebufferTexture2D(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_CUBE_MAP_POSITIVE_X+G,Ct.__webglTexture,Q)}else if(Rt){let Ct=G;for(let Ft=0;Ft<C.textures.length;Ft++){let Wt=Xt.get(C.textures[Ft]);k.framebufferTextureLayer(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0+Ft,Wt.__webglTexture,Q,Ct)}}else if(C!==null&&Q!==0){let Ct=Xt.get(C.texture);k.framebufferTexture2D(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,Ct.__webglTexture,Q)}j=-1};function No(C){let G=Xt.get(C);return(G.__readFormat!==C.format||G.__readType!==C.type)&&(G.__readFormat=C.format,G.__readType=C.type,G.__formatReadable=he.textureFormatReadable(C.format),G.__typeReadable=he.textureTypeReadable(C.type)),G}this.readRenderTargetPixels=function(C,G,Q,Y,J,Rt,Nt,Ct=0){if(!(C&&C.isWebGLRenderTarget)){ie("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ft=Xt.get(C).__webglFramebuffer;if(C.isWebGLCubeRenderTarget&&Nt!==void 0&&(Ft=Ft[Nt],Array.isArray(Ft)&&(Ft=Ft[0])),Ft){Tt.bindFramebuffer(k.FRAMEBUFFER,Ft);try{let Wt=C.textures[Ct],oe=Wt.format,be=Wt.type;C.textures.length>1&&k.readBuffer(k.COLOR_ATTACHMENT0+Ct);let Vt=No(Wt);if(Vt.__formatReadable===!1){ie("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Vt.__typeReadable===!1){ie("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}G>=0&&G<=C.width-Y&&Q>=0&&Q<=C.height-J&&k.readPixels(G,Q,Y,J,xt.convert(oe),xt.convert(be),Rt)}finally{let Wt=ut!==null?Xt.get(ut).__webglFramebuffer:null;Tt.bindFramebuffer(k.FRAMEBUFFER,Wt)}}},this.readRenderTargetPixelsAsync=async function(C,G,Q,Y,J,Rt,Nt,Ct=0){if(!(C&&C.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ft=Xt.get(C).__webglFramebuffer;if(C.isWebGLCubeRenderTarget&&Nt!==void 0&&(Ft=Ft[Nt],Array.isArray(Ft)&&(Ft=Ft[0])),Ft)if(G>=0&&G<=C.width-Y&&Q>=0&&Q<=C.height-J){Tt.bindFramebuffer(k.FRAMEBUFFER,Ft);let Wt=C.textures[Ct],oe=Wt.format,be=Wt.type;C.textures.length>1&&k.readBuffer(k.COLOR_ATTACHMENT0+Ct);let Vt=No(Wt);if(Vt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Vt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let Me=k.createBuffer();k.bindBuffer(k.PIXEL_PACK_BUFFER,Me),k.bufferData(k.PIXEL_PACK_BUFFER,Rt.byteLength,k.STREAM_READ),k.readPixels(G,Q,Y,J,xt.convert(oe),xt.convert(be),0),k.bindBuffer(k.PIXEL_PACK_BUFFER,null);let cn=ut!==null?Xt.get(ut).__webglFramebuffer:null;Tt.bindFramebuffer(k.FRAMEBUFFER,cn);let ke=k.fenceSync(k.SYNC_GPU_COMMANDS_COMPLETE,0);return k.flush(),await E_(k,ke,4),k.bindBuffer(k.PIXEL_PACK_BUFFER,Me),k.getBufferSubData(k.PIXEL_PACK_BUFFER,0,Rt),k.bindBuffer(k.PIXEL_PACK_BUFFER,null),k.deleteBuffer(Me),k.deleteSync(ke),Rt}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(C,G=null,Q=0){let Y=Math.pow(2,-Q),J=Math.floor(C.image.width*Y),Rt=Math.floor(C.image.height*Y),Nt=G!==null?G.x:0,Ct=G!==null?G.y:0;Kt.setTexture2D(C,0),k.copyTexSubImage2D(k.TEXTURE_2D,Q,0,0,Nt,Ct,J,Rt),Tt.unbindTexture()},this.copyTextureToTexture=function(C,G,Q=null,Y=null,J=0,Rt=0){let Nt,Ct,Ft,Wt,oe,be,Vt,Me,cn,ke=C.isCompressedTexture?C.mipmaps[Rt]:C.image;if(Q!==null)Nt=Q.max.x-Q.min.x,Ct=Q.max.y-Q.min.y,Ft=Q.isBox3?Q.max.z-Q.min.z:1,Wt=Q.min.x,oe=Q.min.y,be=Q.isBox3?Q.min.z:0;else{let ge=Math.pow(2,-J);Nt=Math.floor(ke.width*ge),Ct=Math.floor(ke.height*ge),C.isDataArrayTexture?Ft=ke.depth:C.isData3DTexture?Ft=Math.floor(ke.depth*ge):Ft=1,Wt=0,oe=0,be=0}Y!==null?(Vt=Y.x,Me=Y.y,cn=Y.z):(Vt=0,Me=0,cn=0);let ze=xt.convert(G.format),Ln=xt.convert(G.type),zt;G.isData3DTexture?(Kt.setTexture3D(G,0),zt=k.TEXTURE_3D):G.isDataArrayTexture||G.isCompressedArrayTexture?(Kt.setTexture2DArray(G,0),zt=k.TEXTURE_2D_ARRAY):(Kt.setTexture2D(G,0),zt=k.TEXTURE_2D),Tt.activeTexture(k.TEXTURE0),Tt.pixelStorei(k.UNPACK_FLIP_Y_WEBGL,G.flipY),Tt.pixelStorei(k.UNPACK_PREMULTIPLY_ALPHA_WEBGL,G.premultiplyAlpha),Tt.pixelStorei(k.UNPACK_ALIGNMENT,G.unpackAlignment);let wn=Tt.getParameter(k.UNPACK_ROW_LENGTH),we=Tt.getParameter(k.UNPACK_IMAGE_HEIGHT),Gs=Tt.getParameter(k.UNPACK_SKIP_PIXELS),En=Tt.getParameter(k.UNPACK_SKIP_ROWS),Uo=Tt.getParameter(k.UNPACK_SKIP_IMAGES);Tt.pixelStorei(k.UNPACK_ROW_LENGTH,ke.width),Tt.pixelStorei(k.UNPACK_IMAGE_HEIGHT,ke.height),Tt.pixelStorei(k.UNPACK_SKIP_PIXELS,Wt),Tt.pixelStorei(k.UNPACK_SKIP_ROWS,oe),Tt.pixelStorei(k.UNPACK_SKIP_IMAGES,be);let Ms=C.isDataArrayTexture||C.isData3DTexture,Vs=G.isDataArrayTexture||G.isData3DTexture;if(C.isDepthTexture){let ge=Xt.get(C),pn=Xt.get(G),ri=Xt.get(ge.__renderTarget),He=Xt.get(pn.__renderTarget);Tt.bindFramebuffer(k.READ_FRAMEBUFFER,ri.__webglFramebuffer),Tt.bindFramebuffer(k.DRAW_FRAMEBUFFER,He.__webglFramebuffer);for(let Tn=0;Tn<Ft;Tn++)Ms&&(k.framebufferTextureLayer(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,Xt.get(C).__webglTexture,J,be+Tn),k.framebufferTextureLayer(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,Xt.get(G).__webglTexture,Rt,cn+Tn)),k.blitFramebuffer(Wt,oe,Wt+Nt,oe+Ct,Vt,Me,Vt+Nt,Me+Ct,k.DEPTH_BUFFER_BIT,k.NEAREST);Tt.bindFramebuffer(k.READ_FRAMEBUFFER,null),Tt.bindFramebuffer(k.DRAW_FRAMEBUFFER,null)}else if(J!==0||C.isRenderTargetTexture||Xt.has(C)){let ge=Xt.get(C),pn=Xt.get(G);Tt.bindFramebuffer(k.READ_FRAMEBUFFER,O),Tt.bindFramebuffer(k.DRAW_FRAMEBUFFER,X);for(let ri=0;ri<Ft;ri++)Ms?k.framebufferTextureLayer(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,ge.__webglTexture,J,be+ri):k.framebufferTexture2D(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,ge.__webglTexture,J),Vs?k.framebufferTextureLayer(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,pn.__webglTexture,Rt,cn+ri):k.framebufferTexture2D(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,pn.__webglTexture,Rt),J!==0?k.blitFramebuffer(Wt,oe,Wt+Nt,oe+Ct,Vt,Me,Vt+Nt,Me+Ct,k.COLOR_BUFFER_BIT,k.NEAREST):Vs?k.copyTexSubImage3D(zt,Rt,Vt,Me,cn+ri,Wt,oe,Nt,Ct):k.copyTexSubImage2D(zt,Rt,Vt,Me,Wt,oe,Nt,Ct);Tt.bindFramebuffer(k.READ_FRAMEBUFFER,null),Tt.bindFramebuffer(k.DRAW_FRAMEBUFFER,null)}else Vs?C.isDataTexture||C.isData3DTexture?k.texSubImage3D(zt,Rt,Vt,Me,cn,Nt,Ct,Ft,ze,Ln,ke.data):G.isCompressedArrayTexture?k.compressedTexSubImage3D(zt,Rt,Vt,Me,cn,Nt,Ct,Ft,ze,ke.data):k.texSubImage3D(zt,Rt,Vt,Me,cn,Nt,Ct,Ft,ze,Ln,ke):C.isDataTexture?k.texSubImage2D(k.TEXTURE_2D,Rt,Vt,Me,Nt,Ct,ze,Ln,ke.data):C.isCompressedTexture?k.compressedTexSubImage2D(k.TEXTURE_2D,Rt,Vt,Me,ke.width,ke.height,ze,ke.data):k.texSubImage2D(k.TEXTURE_2D,Rt,Vt,Me,Nt,Ct,ze,Ln,ke);Tt.pixelStorei(k.UNPACK_ROW_LENGTH,wn),Tt.pixelStorei(k.UNPACK_IMAGE_HEIGHT,we),Tt.pixelStorei(k.UNPACK_SKIP_PIXELS,Gs),Tt.pixelStorei(k.UNPACK_SKIP_ROWS,En),Tt.pixelStorei(k.UNPACK_SKIP_IMAGES,Uo),Rt===0&&G.generateMipmaps===!0&&G.mipmapsAutoUpdate===!0&&k.generateMipmap(zt),Tt.unbindTexture()},this.initRenderTarget=function(C){Xt.get(C).__webglFramebuffer===void 0&&Kt.setupRenderTarget(C)},this.initTexture=function(C){C.isCubeTexture?Kt.setTextureCube(C,0):C.isData3DTexture?Kt.setTexture3D(C,0):C.isDataArrayTexture||C.isCompressedArrayTexture?Kt.setTexture2DArray(C,0):Kt.setTexture2D(C,0),Tt.unbindTexture()},this.resetState=function(){Z=0,q=0,ut=null,Tt.reset(),wt.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Yi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=Ee._getDrawingBufferColorSpace(t),e.unpackColorSpace=Ee._getUnpackColorSpace()}};var pe={},iA=["ground","gridFine","gridCoarse","link","joint","accent","ghost","ink","muted","line","trace","panel","wrong"],sA={light:["#0072b2","#d55e00","#009e73","#cc79a7","#8a6d00","#56b4e9","#4b4b4b","#7a3e9d"],dark:["#56b4e9","#ff9a4d","#2fd6a3","#f0a3cb","#f0e442","#8fb7ff","#d0d4da","#c9a0ff"]},ux=matchMedia("(prefers-color-scheme: dark)");function Yh(){let n=P.theme==="dark"||P.theme==="auto"&&ux.matches;document.documentElement.dataset.theme=n?"dark":"light";let t=getComputedStyle(document.documentElement);for(let e of iA)pe[e]=t.getPropertyValue(`--${e.replace(/[A-Z]/g,i=>`-${i.toLowerCase()}`)}`).trim();pe.dark=n,pe.curves=sA[n?"dark":"light"]}function Zh(n){P.theme=n,Yh(),Dt("theme")}ux.addEventListener("change",()=>{P.theme==="auto"&&(Yh(),Dt("theme"))});var hx={type:"change"},Jp={type:"start"},dx={type:"end"},Jh=new sr,fx=new Zn,rA=Math.cos(70*Hr.DEG2RAD),Un=new H,Si=2*Math.PI,Ne={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Zp=1e-6,Kh=class extends ql{constructor(t,e=null){super(t,e),this.state=Ne.NONE,this.target=new H,this.cursor=new H,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Fr.ROTATE,MIDDLE:Fr.DOLLY,RIGHT:Fr.PAN},this.touches={ONE:Or.ROTATE,TWO:Or.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new H,this._lastQuaternion=new un,this._lastTargetPosition=new H,this._quat=new un().setFromUnitVectors(t.up,new H(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new Ma,this._sphericalDelta=new Ma,this._scale=1,this._panOffset=new H,this._rotateStart=new qt,this._rotateEnd=new qt,this._rotateDelta=new qt,this._panStart=new qt,this._panEnd=new qt,this._panDelta=new qt,this._dollyStart=new qt,this._dollyEnd=new qt,this._dollyDelta=new qt,this._dollyDirection=new H,this._mouse=new qt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=aA.bind(this),this._onPointerDown=oA.bind(this),this._onPointerUp=lA.bind(this),this._onContextMenu=mA.bind(this),this._onMouseWheel=hA.bind(this),this._onKeyDown=fA.bind(this),this._onTouchStart=dA.bind(this),this._onTouchMove=pA.bind(this),this._onMouseDown=cA.bind(this),this._onMouseMove=uA.bind(this),this._interceptControlDown=gA.bind(this),this._interceptControlUp=_A.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Ne.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(hx),this.update(),this.state=Ne.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;Un.copy(e).sub(this.target),Un.applyQuaternion(this._quat),this._spherical.setFromVector3(Un),this.autoRotate&&this.state===Ne.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=Si:i>Math.PI&&(i-=Si),s<-Math.PI?s+=Si:s>Math.PI&&(s-=Si),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Un.setFromSpherical(this._spherical),Un.applyQuaternion(this._quatInverse),e.copy(this.target).add(Un),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Un.length();o=this._clampDistance(a*this._scale);let c=a-o;this.object.position.addScaledVector(this._dollyDirection,c),this.object.updateMatrixWorld(),r=!!c}else if(this.object.isOrthographicCamera){let a=new H(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let c=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=c!==this.object.zoom;let l=new H(this._mouse.x,this._mouse.y,0);l.unproject(this.object),this.object.position.sub(l).add(a),this.object.updateMatrixWorld(),o=Un.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(Jh.origin.copy(this.object.position),Jh.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Jh.direction))<rA?this.object.lookAt(this.target):(fx.setFromNormalAndCoplanarPoint(this.object.up,this.target),Jh.intersectPlane(fx,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Zp||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Zp||this._lastTargetPosition.distanceToSquared(this.target)>Zp?(this.dispatchEvent(hx),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?Si/60*this.autoRotateSpeed*t:Si/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){Un.setFromMatrixColumn(e,0),Un.multiplyScalar(-t),this._panOffset.add(Un)}_panUp(t,e){this.screenSpacePanning===!0?Un.setFromMatrixColumn(e,1):(Un.setFromMatrixColumn(e,0),Un.crossVectors(this.object.up,Un)),Un.multiplyScalar(t),this._panOffset.add(Un)}_pan(t,e){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Un.copy(s).sub(this.target);let r=Un.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/i.clientHeight,this.object.matrix),this._panUp(2*e*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=t-i.left,r=e-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(Si*this._rotateDelta.x/e.clientHeight),this._rotateUp(Si*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(Si*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-Si*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(Si*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-Si*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(i,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let i=this._getSecondPointerPosition(t),s=.5*(t.pageX+i.x),r=.5*(t.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(Si*this._rotateDelta.x/e.clientHeight),this._rotateUp(Si*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new qt,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,i={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function oA(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function aA(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function lA(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(dx),this.state=Ne.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function cA(n){let t;switch(n.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case Fr.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=Ne.DOLLY;break;case Fr.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Ne.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Ne.ROTATE}break;case Fr.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Ne.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Ne.PAN}break;default:this.state=Ne.NONE}this.state!==Ne.NONE&&this.dispatchEvent(Jp)}function uA(n){switch(this.state){case Ne.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case Ne.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case Ne.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function hA(n){this.enabled===!1||this.enableZoom===!1||this.state!==Ne.NONE||(n.preventDefault(),this.dispatchEvent(Jp),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(dx))}function fA(n){this.enabled!==!1&&this._handleKeyDown(n)}function dA(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case Or.ROTATE:if(this.enableRotate===!1){this.state=Ne.NONE;break}this._handleTouchStartRotate(n),this.state=Ne.TOUCH_ROTATE;break;case Or.PAN:if(this.enablePan===!1){this.state=Ne.NONE;break}this._handleTouchStartPan(n),this.state=Ne.TOUCH_PAN;break;default:this.state=Ne.NONE}break;case 2:switch(this.touches.TWO){case Or.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=Ne.TOUCH_DOLLY_PAN;break;case Or.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=Ne.TOUCH_DOLLY_ROTATE;break;default:this.state=Ne.NONE}break;default:this.state=Ne.NONE}this.state!==Ne.NONE&&this.dispatchEvent(Jp)}function pA(n){switch(this._trackPointer(n),this.state){case Ne.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case Ne.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case Ne.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case Ne.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=Ne.NONE}}function mA(n){this.enabled!==!1&&n.preventDefault()}function gA(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function _A(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var px=[1,.75,.55,.42],xA=30,yA=17,vA=400,mx=6e6;function gx(n){let t=n.getExtension("WEBGL_debug_renderer_info");return/swiftshader|llvmpipe|software|basic render/i.test(String(n.getParameter(t?t.UNMASKED_RENDERER_WEBGL:n.RENDERER)))}var jh=class{constructor(t,e,i,s){this.software=t,this.renderer=e,this.draw=i,this.hurry=s,this.resting=!0,this.level=0,this.gaps=[],this.last=0,this.area=1}resized(t,e){this.area=t*e}get base(){return Math.min(devicePixelRatio,2,Math.sqrt(mx/this.area))}#t(t){Math.abs(this.renderer.getPixelRatio()-t)>.001&&this.renderer.setPixelRatio(t)}moving(t){if(!this.software){this.#t(this.base);return}let e=t-this.last;if(this.last=t,e<120&&this.gaps.push(e),this.gaps.length>=8){let i=this.gaps.sort((s,r)=>s-r)[4];this.gaps=[],i>xA&&this.level<px.length-1?this.level+=1:i<yA&&this.level>0&&(this.level-=1)}this.resting&&this.hurry(!0),this.resting=!1,this.#t(this.base*px[this.level]),clearTimeout(this.timer),this.timer=setTimeout(()=>{this.gaps=[],this.resting=!0,this.hurry(!1),this.#t(Math.min(2*this.base,Math.max(Math.sqrt(mx/this.area),.5))),this.draw()},vA)}};var yx=32,vx={iso:[1,-1.25,.62],front:[1,0,0],side:[0,-1,0],top:[0,-1e-4,1]},gi=new Rl,Ue=new hi(yx,1,.01,100);Ue.up.set(0,0,1);var ki,yn,ji,Qp,Kp=!1,bx=!1,tm=0;function qe(){Kp||!bx||(Kp=!0,requestAnimationFrame(Mx))}function Mx(n=performance.now()){Kp=!1,Qp.moving(n),em()}var Sx=[],wx=n=>Sx.push(n);function em(){for(let n of Sx)n();ki.render(gi,Ue),tm+=1}function Ex(){bx=!0,qe()}function Tx(n){return em(),n(ki.domElement)}var Ax=()=>tm;gi.fog=new Al("#fff",1,10);function _x(n){let t=document.createElement("canvas");t.width=ji.clientWidth||1,t.height=ji.clientHeight||1;let e=t.getContext("webgl2",{alpha:!1,antialias:n,stencil:!0,powerPreference:"high-performance"});if(!e)throw new Error("This browser offers no WebGL 2, which the picture needs.");let i=e.getExtension.bind(e);return e.getExtension=s=>bA.has(s)?i(s):null,e}var bA=new Set(["WEBGL_debug_renderer_info","WEBGL_lose_context"]);function Rx(n){ji=n;let t=_x(!1),e=gx(t);e||(t.getExtension("WEBGL_lose_context")?.loseContext(),t=_x(!0)),ki=new qh({canvas:t.canvas,context:t}),ki.debug.checkShaderErrors=!1,Qp=new jh(e,ki,em,i=>Dt("hurry",i)),ki.domElement.setAttribute("aria-hidden","true"),ji.append(ki.domElement),yn=new Kh(Ue,ki.domElement),yn.enableDamping=!1,yn.addEventListener("change",qe),yn.addEventListener("end",()=>{sc=!Px(),xo=null}),new ResizeObserver(MA).observe(ji),ji.tabIndex=0,ji.setAttribute("role","application"),ji.setAttribute("aria-label","The arm in space. Arrow keys turn the view, plus and minus zoom, F fits, 1 to 4 are the standard views."),ji.addEventListener("keydown",SA)}function MA(){let n=ji.clientWidth,t=ji.clientHeight;!n||!t||(Qp.resized(n,t),ki.setSize(n,t),Ue.aspect=n/t,Ue.updateProjectionMatrix(),tm?Mx():qe(),Ca())}function SA(n){let t={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,-1],ArrowDown:[0,1]}[n.key],e={1:"iso",2:"front",3:"side",4:"top"}[n.key];if(t)wA(t[0]*.1,t[1]*.1);else if(n.key==="+"||n.key==="=")xx(1/1.15);else if(n.key==="-")xx(1.15);else if(n.key.toLowerCase()==="f")tf(yo);else if(e)nm(e);else return;n.preventDefault()}function wA(n,t){let e=Ue.position.clone().sub(yn.target),i=e.length(),s=Math.atan2(e.y,e.x)+n,r=Math.min(Math.max(Math.acos(e.z/i)+t,.02),Math.PI-.02);Ue.position.set(Math.sin(r)*Math.cos(s),Math.sin(r)*Math.sin(s),Math.cos(r)).multiplyScalar(i).add(yn.target),yn.update(),qe()}function xx(n){Ue.position.sub(yn.target).multiplyScalar(n).add(yn.target),yn.update(),qe()}var yo=[[0,0,0],[0,0,1]];function Cx(n,t){let e=new Mi().setFromPoints(n.map(u=>new H(...u))),i=e.getCenter(new H),s=new H(...t).normalize(),r=new H().crossVectors(Ue.up,s).normalize(),o=new H().crossVectors(s,r),a=Math.tan(Hr.degToRad(yx/2))*.8,c=a*Ue.aspect,l=e.getSize(new H).length()*.4+.001;for(let u=0;u<3;u++){let h=0,f=1/0,d=-1/0,g=1/0,_=-1/0;for(let p of n){let m=new H(...p).sub(i),x=m.dot(r),M=m.dot(o),v=m.dot(s);h=Math.max(h,v+Math.abs(x)/c,v+Math.abs(M)/a),f=Math.min(f,M),d=Math.max(d,M),g=Math.min(g,x),_=Math.max(_,x)}l=Math.max(h,l*.2),u<2&&i.addScaledVector(o,(f+d)/2).addScaledVector(r,(g+_)/2)}return{target:i,position:i.clone().addScaledVector(s,l)}}var jp=0;function Qh({target:n,position:t},e=.35){let i={t:yn.target.clone(),p:Ue.position.clone()},s=performance.now(),r=++jp,o=matchMedia("(prefers-reduced-motion: reduce)").matches||e===0;(function a(c){if(r!==jp)return;let l=o?1:Math.min((c-s)/(1e3*e),1),u=l*l*(3-2*l);yn.target.lerpVectors(i.t,n,u),Ue.position.lerpVectors(i.p,t,u);let h=Ue.position.distanceTo(yn.target);Ue.near=h/100,Ue.far=h*30,gi.fog.near=h*1.3,gi.fog.far=h*3.4,Ue.updateProjectionMatrix(),yn.update(),qe(),l<1&&requestAnimationFrame(a)})(s)}function tf(n,{instant:t=!1,view:e=null,byItself:i=!1}={}){yo=n,i||(xo=null),sc=!1;let s=e?vx[e]:Ue.position.clone().sub(yn.target).toArray();Qh(Cx(n,s),t?0:.35)}function nm(n){sc=!1,xo=null,Qh(Cx(yo,vx[n]))}var sc=!1;function Px(){Ue.updateMatrixWorld();let n=new H;return yo.every(t=>(n.set(...t).project(Ue),Math.abs(n.x)<1&&Math.abs(n.y)<1&&n.z<1))}function Ca(){sc||!yn.enabled||!yo.length||Px()||(xo??={position:Ue.position.clone(),target:yn.target.clone()},tf(yo,{byItself:!0}))}var xo=null;function Ix(){if(!xo||sc||!yn.enabled)return;let n=xo;xo=null,Qh(n),setTimeout(Ca,500)}var im=n=>{yo=n},ef=()=>[...Ue.position.toArray(),...yn.target.toArray()].map(n=>Number(n.toPrecision(5)));function Lx(n){jp+=1,Qh({position:new H(...n.slice(0,3)),target:new H(...n.slice(3))},0)}var Os=null,sm={cell:.1};function rm(n){let t=n/6,e=10**Math.floor(Math.log10(t)),i=[1,2,5,10].map(u=>u*e).findLast(u=>u<=t*1.0001)??e;sm.cell=i;let s=Math.ceil(n*2.2/i),r=[],o=[],a=new ee(pe.gridFine),c=new ee(pe.gridCoarse);for(let u=-s;u<=s;u++){let h=u%5===0?c:a,f=s*i;r.push(u*i,-f,0,u*i,f,0,-f,u*i,0,f,u*i,0);for(let d=0;d<4;d++)o.push(h.r,h.g,h.b)}Os?.geometry.dispose();let l=new De;l.setAttribute("position",new Ce(r,3)),l.setAttribute("color",new Ce(o,3)),Os?Os.geometry=l:(Os=new ao(l,new rr({vertexColors:!0})),Os.renderOrder=-2,Os.material.depthWrite=!1,gi.add(Os)),Os.userData.reach=n,qe()}function om(){gi.background=new ee(pe.ground),gi.fog.color.set(pe.ground),Os&&rm(Os.userData.reach),qe()}function wi(n){Ue.updateMatrixWorld();let t=new H(...n).project(Ue),e=ji.getBoundingClientRect();return[e.x+(t.x+1)/2*e.width,e.y+(1-t.y)/2*e.height]}function nf(n){let t=n.joints.length,e=Mr(n),i=Math.min(.062,.075-.002*t)*e,s=n.joints.map((r,o)=>i*(1-.52*o/Math.max(t-1,1)));return{size:e,radius:s,rest:s[t-1]??i*.5}}function am(n,t,e,i=null){let s={rods:[],balls:[],drums:[],sleeves:[],flange:null},{radius:r,size:o}=e,a=n.joints.length,c=o*1e-6,l=Sd(n,t),u=(f,d,g,_=!0)=>{As(qi(d,f))<=c||(s.rods.push({a:f,b:d,r:g}),_&&s.balls.push({at:d,r:g}))};a&&(s.pedestal={at:ye(t[0]),dir:br(t[0],2),r:r[0]*1.7,h:r[0]*.34});let h=null;if(l.forEach(({point:f,dir:d,x:g},_)=>{let p=r[_],m=n.joints[_],x=ye(t[_]),M=ye(t[_+1]),v=p*.62;if(n.convention==="standard"){let z=ol(x,d,rl(qi(M,x),d));u(x,z,v),u(z,M,v)}else u(x,f,v),u(f,M,v);let A=f,S=rl(qi(M,f),d);h&&As(qi(f,h.at))<.5*p&&Math.abs(S)>c?A=ol(f,d,Math.sign(S)*Math.min(Math.abs(S)*.55,h.r+p*1.15)):_===0&&Math.abs(S)>2.2*p&&(A=ol(f,d,Math.sign(S)*p*1.25));let y=p*2.15,w=br(t[_+1],0),U=!!(i&&lm(m,i[_])),L=br(t[0],2),N=rl(qi(A,ye(t[0])),L)-y/2;_===0&&m.type==="R"&&Math.abs(rl(d,L))>.99&&N<0&&N>-y&&(A=ol(A,L,-N)),m.type==="R"?s.drums.push({at:A,dir:d,x:g,turned:w,r:p,h:y,beyond:U,joint:_}):s.sleeves.push({at:A,dir:d,x:g,r:p*.95,h:p*3.4,beyond:U,joint:_}),h={at:f,r:p}}),a){let f=t[a+1],d=ye(t[a]);s.flange={at:d,dir:br(t[a],2),turned:br(t[a],0),r:e.rest*.85,h:e.rest*.5},u(d,ye(f),e.rest*.34,!1),s.tip={at:ye(f),r:e.rest*.42}}return s}function lm(n,t){return n.lower!==null&&t<n.lower-1e-9?t-n.lower:n.upper!==null&&t>n.upper+1e-9?t-n.upper:0}function rc(n,t){let e=nf(n).radius[0]??.05,i=ye(t[0]);if(!n.joints.length)return[-.4,.4].flatMap(r=>[[i[0]+r,i[1]+r,0],[i[0]+r,i[1]-r,1]]);let s=[[i[0],i[1],0],...t.map(ye)];for(let{point:r}of Sd(n,t))s.push(r);return s.flatMap(r=>[[r[0]-e,r[1]-e,r[2]-e],[r[0]+e,r[1]+e,r[2]+e]])}function TA(n,t){let i=a=>a.rotateX(Math.PI/2),s=[[0,-.5],[.9,-.5],[1,-.45],[1,.45],[.9,.5],[0,.5]],r=t>8?new kl(s.map(([a,c])=>new qt(a,c)),n):new cs(1,1,1,n),o={rod:i(new cs(1,1,1,n,1,!0)),ball:t>3?new uo(1,n,t):new zl(1,0),drum:i(r),box:new Lr(2,2,1)};return Object.fromEntries(Object.entries(o).map(([a,c])=>{let l=c.attributes.position,u=c.index?c.index.array:Uint16Array.from({length:l.count},(h,f)=>f);return[a,{at:l.array,normal:c.attributes.normal.array,index:u,count:l.count}]}))}var Dx=new Map,fm=(n,t)=>Dx.get(n)??Dx.set(n,TA(n,t)).get(n),AA=()=>fm(26,12),cm=()=>fm(11,5),Nx=()=>fm(6,3),rf=class{constructor(t){this.mesh=new ei(new De,t),this.mesh.frustumCulled=!1,this.mesh.visible=!1,this.#t(1024,4096),this.clear()}#t(t,e){let i=this.mesh.geometry.attributes,s=new De,r=(a,c)=>{let l=new Float32Array(c*t);i[a]&&l.set(i[a].array);let u=new sn(l,c).setUsage(zh);return s.setAttribute(a,u),l};this.at=r("position",3),this.normal=r("normal",3),this.paint=r("paint",1);let o=new Uint32Array(e);this.index&&o.set(this.index),this.index=o,s.setIndex(new sn(o,1).setUsage(zh)),this.mesh.geometry.dispose(),this.mesh.geometry=s}clear(){this.corners=0,this.indices=0}put(t,e,i,s,r,o,a,c){let l=this.corners,u=l+t.count;(3*u>this.at.length||this.indices+t.index.length>this.index.length)&&this.#t(2*Math.max(u,this.at.length/3),2*Math.max(this.indices+t.index.length,this.index.length));for(let h=0,f=3*l;h<3*t.count;h+=3,f+=3){let d=a*t.at[h],g=a*t.at[h+1],_=c*t.at[h+2],p=t.normal[h]/a,m=t.normal[h+1]/a,x=t.normal[h+2]/c;for(let M=0;M<3;M++)this.at[f+M]=i[M]+s[M]*d+r[M]*g+o[M]*_,this.normal[f+M]=s[M]*p+r[M]*m+o[M]*x}this.paint.fill(e,l,u);for(let h=0;h<t.index.length;h++)this.index[this.indices+h]=l+t.index[h];this.corners=u,this.indices+=t.index.length}done(){let t=this.mesh.geometry;for(let[e,i]of[[t.attributes.position,3*this.corners],[t.attributes.normal,3*this.corners],[t.attributes.paint,this.corners],[t.index,this.indices]])e.clearUpdateRanges(),e.addUpdateRange(0,i),e.needsUpdate=!0;t.setDrawRange(0,this.indices),this.mesh.visible=this.indices>0}},Fx=[1,0,0],RA=[0,1,0],Ox=[0,0,1];function CA(n,t=null){let e=t&&Math.abs(n[0]*t[0]+n[1]*t[1]+n[2]*t[2])<.5?t:Fc(n,Math.abs(n[2])<.9?Ox:Fx),i=Fc(n,e),s=As(i)||1,r=i.map(o=>o/s);return[Fc(r,n),r]}var um=0,sf=1,hm=2,Ux=3,Pa=class{constructor(t,{shadow:e=null,veil:i=!1}={}){this.group=new bi,this.veil=i,this.moving=!1,this.arms=[],this.body=new rf(t),this.group.add(this.body.mesh),e&&(this.flat=new rf(e.material),this.flat.mesh.matrixAutoUpdate=!1,this.flat.mesh.matrix.copy(e.matrix),this.flat.mesh.renderOrder=-1,this.group.add(this.flat.mesh))}hurry(t){this.moving=t,this.show(this.arms)}show(t){this.arms=t,this.body.clear();let e=this.veil?this.moving?Nx:cm:this.moving?cm:AA;for(let i of t)this.#t(this.body,i,e());if(this.body.done(),!!this.flat){this.flat.clear();for(let i of t)this.#t(this.flat,i,this.moving?Nx():cm(),!0);this.flat.done()}}#t(t,e,i,s=!1){let r=this.veil?.95:1,o=!this.veil&&!s,a=(l,u,h,f,d,g,_)=>t.put(l,u,h,...CA(f,_),f,d,g),c=(l,u,h)=>t.put(i.ball,l,u,Fx,RA,Ox,h,h);for(let{a:l,b:u,r:h}of e.rods){let f=qi(u,l),d=As(f),g=[(l[0]+u[0])/2,(l[1]+u[1])/2,(l[2]+u[2])/2];a(i.rod,um,g,f.map(_=>_/d),r*h,d)}for(let{at:l,r:u}of e.balls)c(um,l,r*u);for(let{at:l,dir:u,turned:h,r:f,h:d,beyond:g}of e.drums){if(a(i.drum,g&&o?Ux:sf,l,u,r*f,r*d),!o)continue;a(i.rod,hm,l,u,f*1.012,d*.13);let _=[0,1,2].map(p=>l[p]+h[p]*f*.96);a(i.box,um,_,u,f*.11,d*.86,h)}for(let{at:l,dir:u,x:h,r:f,h:d,beyond:g}of e.sleeves)a(i.box,g&&o?Ux:sf,l,u,r*f,r*d,h);if(e.pedestal&&!this.veil){let{at:l,dir:u,r:h,h:f}=e.pedestal;a(i.drum,sf,[l[0]+u[0]*f/2,l[1]+u[1]*f/2,l[2]+u[2]*f/2],u,h,f)}if(e.flange&&a(i.drum,sf,e.flange.at,e.flange.dir,e.flange.r,e.flange.h),e.flange&&o){let{at:l,dir:u,turned:h,r:f,h:d}=e.flange;a(i.box,hm,[0,1,2].map(g=>l[g]+h[g]*f*.95),u,f*.16,d*1.04,h)}e.tip&&o&&c(hm,e.tip.at,e.tip.r)}};var PA=`
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
  }`,IA=`
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
  }`,LA=`
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
  }`,DA=`
  uniform float opacity;
  varying vec3 vColour;
  void main() {
    gl_FragColor = vec4(vColour, opacity);
  }`;function of({opacity:n=1,gloss:t=.16,veil:e=!1}={}){let i=new Zi({vertexShader:e?LA:PA,fragmentShader:e?DA:IA,transparent:n<1,uniforms:{colours:{value:[0,1,2,3].map(()=>new ee)},opacity:{value:n},gloss:{value:t},sky:{value:new ee(.46,.46,.47)},ground:{value:new ee(.2,.2,.21)}}});return i.repaint=(s,r,o,a,c=o)=>{[s,r,o,c].forEach((l,u)=>i.uniforms.colours.value[u].set(l)),i.uniforms.sky.value.setScalar(a?.36:.47),i.uniforms.ground.value.setScalar(a?.1:.2)},i}function dm(n,t=!1){let e=n[0].index!==null,i=new Set(Object.keys(n[0].attributes)),s=new Set(Object.keys(n[0].morphAttributes)),r={},o={},a=n[0].morphTargetsRelative,c=new De;c.morphTargetsRelative=a;let l=0;for(let u=0;u<n.length;++u){let h=n[u],f=0,d=0;if(e!==(h.index!==null))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". All geometries must have compatible attributes; make sure index attribute exists among all geometries, or in none of them."),null;for(let g in h.attributes){if(!i.has(g))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+'. All geometries must have compatible attributes; make sure "'+g+'" attribute exists among all geometries, or in none of them.'),null;r[g]===void 0&&(r[g]=[]),r[g].push(h.attributes[g]),f++}if(f!==i.size)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". Make sure all geometries have the same number of attributes."),null;if(a!==h.morphTargetsRelative)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". .morphTargetsRelative must be consistent throughout all geometries."),null;for(let g in h.morphAttributes){if(!s.has(g))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+".  .morphAttributes must be consistent throughout all geometries."),null;if(h.morphAttributes[g].length!==n[0].morphAttributes[g].length)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+'. All geometries must have the same number of morph targets for the "'+g+'" morph attribute.'),null;o[g]===void 0&&(o[g]=[]),o[g].push(h.morphAttributes[g]),d++}if(d!==s.size)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". Make sure all geometries have the same number of morph attributes."),null;if(t){let g;if(e)g=h.index.count;else if(h.attributes.position!==void 0)g=h.attributes.position.count;else return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". The geometry must have either an index or a position attribute"),null;c.addGroup(l,g,u),l+=g}}if(e){let u=0,h=[];for(let f=0;f<n.length;++f){let d=n[f].index;for(let g=0;g<d.count;++g)h.push(d.getX(g)+u);u+=n[f].attributes.position.count}c.setIndex(h)}for(let u in r){let h=Bx(r[u]);if(!h)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+u+" attribute."),null;c.setAttribute(u,h)}for(let u in o){let h=o[u][0].length;if(h!==0){c.morphAttributes=c.morphAttributes||{},c.morphAttributes[u]=[];for(let f=0;f<h;++f){let d=[];for(let _=0;_<o[u].length;++_)d.push(o[u][_][f]);let g=Bx(d);if(!g)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+u+" morphAttribute."),null;c.morphAttributes[u].push(g)}}}return c}function Bx(n){let t,e,i,s=-1,r=0;for(let l=0;l<n.length;++l){let u=n[l];if(t===void 0&&(t=u.array.constructor),t!==u.array.constructor)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.array must be of consistent array types across matching attributes."),null;if(e===void 0&&(e=u.itemSize),e!==u.itemSize)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.itemSize must be consistent across matching attributes."),null;if(i===void 0&&(i=u.normalized),i!==u.normalized)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.normalized must be consistent across matching attributes."),null;if(s===-1&&(s=u.gpuType),s!==u.gpuType)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.gpuType must be consistent across matching attributes."),null;r+=u.count*e}let o=new t(r),a=new sn(o,e,i),c=0;for(let l=0;l<n.length;++l){let u=n[l];if(u.isInterleavedBufferAttribute){let h=c/e;for(let f=0,d=u.count;f<d;f++)for(let g=0;g<e;g++){let _=u.getComponent(f,g);a.setComponent(f+h,g,_)}}else o.set(u.array,c);c+=u.count*e}return s!==void 0&&(a.gpuType=s),a}var ur=["#d8343f","#1b9a50","#2f6fe0"];function pm(n,t){let e=new cs(.028,.028,.82,8).translate(0,.41,0),i=new co(.085,.22,12).translate(0,.9,0),s=dm([e,i]).applyMatrix4(t),r=new ee(n),o=new Float32Array(s.attributes.position.count*3);for(let a=0;a<o.length;a+=3)o.set([r.r,r.g,r.b],a);return s.setAttribute("color",new sn(o,3)),s}var mm=n=>new Te().makeRotationFromQuaternion(new un().setFromUnitVectors(new H(0,1,0),new H(...n))),NA=dm([pm(ur[0],mm([1,0,0])),pm(ur[1],mm([0,1,0])),pm(ur[2],mm([0,0,1]))]),kx=.021,oc=new Map;function UA(n){let t=`${n}/${pe.dark}`;if(oc.has(t))return oc.get(t);let e=document.createElement("canvas"),i=4,s=e.getContext("2d",{willReadFrequently:!0}),r=`600 ${13*i}px "Inter Variable", system-ui, sans-serif`;s.font=r,e.width=s.measureText(n).width+12*i,e.height=20*i,s.font=r,s.textAlign="center",s.textBaseline="middle",s.lineWidth=4*i,s.lineJoin="round",s.strokeStyle=pe.ground,s.strokeText(n,e.width/2,e.height/2),s.fillStyle=pe.ink,s.fillText(n,e.width/2,e.height/2);let o=new Fl(e);o.colorSpace=ui;let a=new _a({map:o,depthTest:!1,sizeAttenuation:!1,fog:!1});return a.userData.aspect=e.width/e.height,oc.set(t,a),a}var af=class{constructor(){this.group=new bi,this.mesh=new Nl(NA,new Ds({vertexColors:!0,fog:!1}),64),this.mesh.frustumCulled=!1,this.mesh.count=0,this.sprites=[],this.group.add(this.mesh)}show(t,e){this.last=[t,e];let i=new Te;this.mesh.count=t.length,this.sprites.forEach((s,r)=>{s.visible=r<t.length}),t.forEach(({T:s,name:r},o)=>{this.mesh.setMatrixAt(o,i.set(...s).scale(new H(e,e,e)));let a=this.sprites[o]??(this.sprites[o]=new Ll);a.parent||this.group.add(a),a.material=UA(r),a.scale.set(kx*a.material.userData.aspect,kx,1),a.renderOrder=5;let c=e*.16;a.position.set(s[3]-c*(s[0]+s[1]+s[2]),s[7]-c*(s[4]+s[5]+s[6]),s[11]-c*(s[8]+s[9]+s[10]))}),this.mesh.instanceMatrix.needsUpdate=!0,this.mesh.visible=t.length>0}paint(){for(let t of oc.values())t.map.dispose(),t.dispose();oc.clear(),this.last&&this.show(...this.last)}};var _m=180/Math.PI,Ei={angle:"deg",length:"mm"},FA={deg:"\xB0",rad:"rad",mm:"mm",m:"m"},gm={deg:_m,rad:1,mm:1e3,m:1},OA={deg:2,rad:4,mm:2,m:5},BA={deg:1,rad:.02,mm:5,m:.005},yt={get angle(){return Ei.angle},get length(){return Ei.length},set(n,t){t in gm&&n in Ei&&(Ei[n]=t)},factor:n=>n in Ei?gm[Ei[n]]:1,symbol:n=>n in Ei?FA[Ei[n]]:"",digits:n=>n in Ei?OA[Ei[n]]:4,step:n=>n in Ei?BA[Ei[n]]/gm[Ei[n]]:.01,suffix:n=>n==="angle"?{deg:_m,"\xB0":_m,rad:1}:n==="length"?{mm:1e3,m:1,cm:100}:{}};function Xn(n,t){if(!Number.isFinite(n))return n===1/0?"\u221E":n===-1/0?"\u2212\u221E":"\u2013";let e=n.toFixed(t);return Number(e)===0?e.replace("-",""):e.replace("-","\u2212")}var _i=(n,t,e=yt.digits(t))=>Xn(n*yt.factor(t),e),$e=(n,t,e)=>`${_i(n,t,e)}${t==="angle"&&Ei.angle==="deg"?"":" "}${yt.symbol(t)}`,ac=(n,t="plain")=>String(Number((n*yt.factor(t)).toPrecision(9))+0),lf=n=>n===0?"0":n.toExponential(0).replace("-","\u2212");function Ia(n,t){let e=n.map(s=>/^[-+−]?\d*[.,](\d+)$/.exec(s.trim())?.[1].length??0);return .5*10**-(Math.max(0,...e)||yt.digits(t))/yt.factor(t)}var xm=(n,t,e)=>[n[0],t[0],e[0],0,n[1],t[1],e[1],0,n[2],t[2],e[2],0,0,0,0,1],La=n=>[Math.cos(n),Math.sin(n)];function kA([n,t,e]){let[i,s]=La(e),[r,o]=La(t),[a,c]=La(n);return xm([i*r,s*r,-o],[i*o*c-s*a,s*o*c+i*a,r*c],[i*o*a+s*c,s*o*a-i*c,r*a])}function zA(n){let t=Math.hypot(n[0],n[4]),e=Math.atan2(-n[8],t);return t>1e-9?[Math.atan2(n[9],n[10]),e,Math.atan2(n[4],n[0])]:[Math.atan2(-n[6],n[5]),e,0]}function HA([n,t,e]){let[i,s]=La(n),[r,o]=La(t),[a,c]=La(e);return xm([i*r*a-s*c,s*r*a+i*c,-o*a],[-i*r*c-s*a,-s*r*c+i*a,o*c],[i*o,s*o,r])}function GA(n){let t=Math.hypot(n[2],n[6]);return t<1e-9?n[10]>0?[0,0,Math.atan2(n[4],n[0])]:[0,Math.PI,Math.atan2(n[4],-n[0])||0]:[Math.atan2(n[6],n[2]),Math.atan2(t,n[10]),Math.atan2(n[9],-n[8])]}function cf(n){let t=[n[0]+n[5]+n[10],n[0]-n[5]-n[10],n[5]-n[0]-n[10],n[10]-n[0]-n[5]],e=t.indexOf(Math.max(...t)),i=2*Math.sqrt(Math.max(t[e]+1,0)),s=n[9]-n[6],r=n[2]-n[8],o=n[4]-n[1],a=n[1]+n[4],c=n[2]+n[8],l=n[6]+n[9],h=[[i/4,s/i,r/i,o/i],[s/i,i/4,a/i,c/i],[r/i,a/i,i/4,l/i],[o/i,c/i,l/i,i/4]][e],f=h[0]<0?-1:1;return h.map(d=>f*d+0)}function lc(n){let t=Math.hypot(...n);if(t<1e-9)return null;let[e,i,s,r]=n.map(o=>o/t);return xm([1-2*(s*s+r*r),2*(i*s+e*r),2*(i*r-e*s)],[2*(i*s-e*r),1-2*(i*i+r*r),2*(s*r+e*i)],[2*(i*r+e*s),2*(s*r-e*i),1-2*(i*i+s*s)])}function VA(n){let[t,e,i,s]=cf(n),r=Math.hypot(e,i,s);return r<1e-9?[0,0,1,0]:[e/r,i/r,s/r,2*Math.atan2(r,t)]}function WA([n,t,e,i]){let s=Math.hypot(n,t,e),r=Math.sin(i/2);return s<1e-9?null:lc([Math.cos(i/2),r*n/s,r*t/s,r*e/s])}var ds={rpy:{title:"Roll, pitch, yaw",order:"R = Rz(yaw) Ry(pitch) Rx(roll)",names:["roll","pitch","yaw"],kinds:["angle","angle","angle"],to:zA,from:kA},zyz:{title:"ZYZ Euler angles",order:"R = Rz(\u03C6) Ry(\u03B8) Rz(\u03C8)",names:["\u03C6","\u03B8","\u03C8"],kinds:["angle","angle","angle"],to:GA,from:HA},axis:{title:"Axis and angle",order:"unit axis x y z, then the turn about it",names:["x","y","z","angle"],kinds:["plain","plain","plain","angle"],to:VA,from:WA},quaternion:{title:"Quaternion",order:"order w x y z, scalar first, w \u2265 0",names:["w","x","y","z"],kinds:["plain","plain","plain","plain"],to:cf,from:lc}};function zx(n,t,e){let i=ds[n].from(t);return i?(i[3]=e[0],i[7]=e[1],i[11]=e[2],i):null}function Hx(n,t,e){let i=cf(n),s=cf(t),r=i.reduce((h,f,d)=>h+f*s[d],0);r<0&&(s=s.map(h=>-h),r=-r);let o=Math.acos(Math.min(r,1)),a=Math.sin(o),[c,l]=a<1e-7?[1-e,e]:[Math.sin((1-e)*o)/a,Math.sin(e*o)/a],u=lc(i.map((h,f)=>c*h+l*s[f]));return[3,7,11].forEach(h=>{u[h]=n[h]+e*(t[h]-n[h])}),u}var Da=.145,ff=.105,Tm=.165,Gx={mouse:13,pen:16,touch:28},qA=.2,Wr=["x","y","z"],uc=72,vo=new bi,hf=new Map,Mm="both",df="local",Am=0,hr=!1,Sm=null,Ye=null,pf=()=>Ye!==null,$x=()=>hr,Gr=null,Vr=null;function Yx(){vo.visible=!1,gi.add(vo),wx(Rm),Vr=document.getElementById("view"),Gr=E("output",{class:"gizmo-readout","data-testid":"gizmo-readout",hidden:!0}),document.getElementById("overlay").append(Gr),Vr.addEventListener("pointerdown",jA,!0),Vr.addEventListener("pointermove",tR,!0);for(let n of["pointerup","pointercancel"])Vr.addEventListener(n,ny,!0);addEventListener("keydown",n=>n.key==="Escape"&&Ye&&nR()),gt(["target","theme"],qe)}function cc(n,t,e=8){let i=new Ds({color:t,depthTest:!1,depthWrite:!1,transparent:!0,opacity:.95,fog:!1}),s=new ei(n,i);return s.renderOrder=e,s.frustumCulled=!1,s.userData.colour=t,s}var XA=[new un().setFromUnitVectors(new H(0,1,0),new H(1,0,0)),new un,new un().setFromUnitVectors(new H(0,1,0),new H(0,0,1))],$A=[new un().setFromUnitVectors(new H(0,0,1),new H(1,0,0)),new un().setFromUnitVectors(new H(0,0,1),new H(0,1,0)),new un];function YA(){if(hf.size)return;let n=(t,e)=>{hf.set(t,e),vo.add(e)};Wr.forEach((t,e)=>{let i=new cs(.0032,.0032,Da*.8,8).translate(0,Da*.45,0),s=new co(.0125,.034,14).translate(0,Da*.9,0),r=new bi;r.add(cc(i,ur[e]),cc(s,ur[e])),r.userData.turn=XA[e],n(`move-${t}`,r);let o=cc(new va(ff,.0026,6,uc),ur[e],7);o.userData.turn=$A[e],n(`turn-${t}`,o)}),n("turn-view",cc(new va(Tm,.0022,6,uc),"#8891a0",7)),n("move-view",cc(new uo(.0115,14,10),"#8891a0",9))}var uf=new H,qr=new H,ym=new un;function mf(){return 2*Math.tan(Hr.degToRad(Ue.fov/2))*Ue.position.distanceTo(uf)}var fc=()=>df==="world"?[0,1,2].map(n=>[0,1,2].map(t=>+(n===t))):ZA(),ZA=()=>[0,1,2].map(n=>br(P.target,n)),JA=new Te;function Rm(){if(vo.visible=hr,!hr)return;uf.set(...ye(P.target)),qr.copy(Ue.position).sub(uf).normalize(),df==="world"?ym.identity():ym.setFromRotationMatrix(JA.set(...P.target)),vo.position.copy(uf),vo.scale.setScalar(mf());let n=fc();for(let[t,e]of hf){let[i,s]=t.split("-"),r=Wr.indexOf(s),o=Mm==="both"||Mm===i;e.visible=o&&KA(i,n[r])&&(!Ye||Ye.name===t),s==="view"?e.quaternion.copy(Ue.quaternion):e.quaternion.copy(ym).multiply(e.userData.turn);let a=t===(Ye?.name??Sm);e.traverse(c=>c.material?.color.set(a?pe.accent:c.userData.colour))}}function KA(n,t){return!t||n!=="move"?!0:Math.hypot(...Zx(t,qr.toArray()))>qA}var Zx=(n,t)=>[n[1]*t[2]-n[2]*t[1],n[2]*t[0]-n[0]*t[2],n[0]*t[1]-n[1]*t[0]],hc=(n,t)=>ye(P.target).map((e,i)=>e+t*n[i]);function wm(n,t){let e=fc(),[i,s]=n<0?[Vx(Ue.matrixWorld,0),Vx(Ue.matrixWorld,1)]:[e[(n+1)%3],e[(n+2)%3]];return Array.from({length:uc+1},(r,o)=>{let a=2*Math.PI*o/uc,c=i.map((l,u)=>Math.cos(a)*l+Math.sin(a)*s[u]);return{p:hc(c,t),front:n<0||c.reduce((l,u,h)=>l+u*qr.getComponent(h),0)>-.15}})}var Vx=(n,t)=>[n.elements[4*t],n.elements[4*t+1],n.elements[4*t+2]];function Wx(n,t,[e,i],[s,r]){let o=s-e,a=r-i,c=o*o+a*a,l=c>0?Math.min(Math.max(((n-e)*o+(t-i)*a)/c,0),1):0;return Math.hypot(n-e-l*o,t-i-l*a)}function Em(n,t){let e=mf(),i=[];for(let[s,r]of hf){if(!r.visible)continue;let[o,a]=s.split("-"),c=Wr.indexOf(a),l=1/0;if(o==="move"&&c<0){let[u,h]=wi(ye(P.target));l=Math.hypot(n-u,t-h)-3}else if(o==="move"){let u=fc()[c],h=wi(hc(u,.92*Da*e));l=Math.min(Wx(n,t,wi(hc(u,.3*Da*e)),h),Math.hypot(n-h[0],t-h[1])-4)}else{let u=wm(c,(c<0?Tm:ff)*e).map(h=>({...h,s:wi(h.p)}));for(let h=0;h<uc;h++)u[h].front&&(l=Math.min(l,Wx(n,t,u[h].s,u[h+1].s)+(c<0?2:0)))}i.push([s,l])}return i.sort((s,r)=>s[1]-r[1])}function Jx(n){if(!hr)return null;Rm();let[t]=Em(n.clientX,n.clientY);return t&&t[1]<=(Gx[n.pointerType]??Gx.mouse)?t[0]:null}function Kx(){if(!hr)return{};Rm();let n=mf(),t=fc(),e={"move-view":wi(ye(P.target))};return Wr.forEach((i,s)=>{let o=[.92,.85,.75,.6,.5].map(l=>wi(hc(t[s],l*Da*n))).find(([l,u])=>Em(l,u)[0]?.[0]===`move-${i}`);o&&(e[`move-${i}`]=o);let c=wm(s,ff*n).filter(l=>l.front).map(l=>wi(l.p)).filter(([l,u])=>Em(l,u)[0]?.[0]===`turn-${i}`);c.length&&(e[`turn-${i}`]=c[Math.floor(c.length/2)])}),e["turn-view"]=wi(wm(-1,Tm*n)[9].p),e}var qx=new Wl,Xx=new qt;function jx(n){let t=ki.domElement.getBoundingClientRect();return Xx.set((n.clientX-t.x)/t.width*2-1,1-(n.clientY-t.y)/t.height*2),qx.setFromCamera(Xx,Ue),qx.ray}function Qx(n,t,e){let{origin:i,direction:s}=jx(e),r=new H(...n),o=new H(...t).sub(i),a=r.dot(s),c=1-a*a;return c<1e-6?0:(a*s.dot(o)-r.dot(o))/c}function ty(n,t,e){let i=new Zn().setFromNormalAndCoplanarPoint(n,new H(...t));return jx(e).intersectPlane(i,new H)}function jA(n){if(n.button!==0)return;let t=Jx(n);if(!t)return;n.stopPropagation(),n.preventDefault(),Vr.focus({preventScroll:!0}),Vr.setPointerCapture(n.pointerId),yn.enabled=!1;let[e,i]=t.split("-"),s=Wr.indexOf(i),r=s<0?qr.toArray():fc()[s].slice();Ye={name:t,what:e,axis:r,i:s,T:P.target.slice(),x:n.clientX,y:n.clientY,total:0,before:null},Ye.start=e==="turn"?ey(n):s<0?ty(qr,ye(Ye.T),n):Qx(r,ye(Ye.T),n),qe()}function ey(n){let[t,e]=wi(ye(Ye.T)),i=Ye.axis.reduce((h,f,d)=>h+f*qr.getComponent(d),0);if(Math.abs(i)>.3)return-Math.sign(i)*Math.atan2(n.clientY-e,n.clientX-t);let s=Zx(Ye.axis,qr.toArray()),r=mf(),o=wi(ye(Ye.T)),a=wi(hc(s,ff*r)),c=a[0]-o[0],l=a[1]-o[1],u=Math.hypot(c,l)||1;return((n.clientX-Ye.x)*c+(n.clientY-Ye.y)*l)/(u*u)}var QA=n=>Math.atan2(Math.sin(n),Math.cos(n)),vm=(n,t,e)=>{let i=Am||(t.shiftKey?5:0);return i?Math.round(n/(i*e))*i*e:n};function tR(n){if(!Ye){if(n.buttons||!hr)return;let c=Jx(n);c!==Sm&&(Sm=c,Vr.style.setProperty("cursor",c?"grab":""),qe());return}n.stopPropagation();let{T:t,axis:e,what:i,i:s}=Ye,r=df==="world"||s<0?"":"tool ",o=t.slice(),a;if(i==="turn"){let c=ey(n);Ye.total+=QA(c-(Ye.before??Ye.start)),Ye.before=c;let l=vm(Ye.total,n,Math.PI/180),u=Math.sin(l/2);o=Xs(lc([Math.cos(l/2),u*e[0],u*e[1],u*e[2]]),t);for(let h of[3,7,11])o[h]=t[h];a=`${bm(l,"angle")} about ${s<0?"the line of sight":r+Wr[s]}`}else if(s<0){let c=ty(qr,ye(t),n);if(!c)return;let l=c.sub(Ye.start);(Am||n.shiftKey)&&l.set(...l.toArray().map(u=>vm(u,n,.001))),[3,7,11].forEach((u,h)=>{o[u]=t[u]+l.getComponent(h)}),a=l.toArray().map((u,h)=>`${Wr[h]} ${bm(u,"length")}`).join(", ")}else{let c=vm(Qx(e,ye(t),n)-Ye.start,n,.001);[3,7,11].forEach((l,u)=>{o[l]=t[l]+c*e[u]}),a=`${bm(c,"length")} along ${r}${Wr[s]}`}Di(o,"drag"),eR(a,n),qe()}var bm=(n,t)=>`${n>=0?"+":""}${$e(n,t,yt.digits(t))}`;function eR(n,t){let e=Vr.getBoundingClientRect();Gr.hidden=!1,Ut(Gr,n),Gr.style.setProperty("left",`${Math.min(t.clientX-e.x+18,e.width-Gr.offsetWidth-8)}px`),Gr.style.setProperty("top",`${Math.max(t.clientY-e.y-34,8)}px`)}function ny(n){Ye&&(n.stopPropagation(),Ye=null,Gr.hidden=!0,yn.enabled=!0,Di(P.target,"dropped"),qe())}function nR(){let{T:n}=Ye;Di(n,"drag"),ny({stopPropagation(){}})}function iy(){hr&&YA(),vo.visible=hr,Dt("frames"),qe()}function sy(n){hr=n,iy()}function ry(n){Mm=n,iy()}function oy(n){df=n,qe()}function ay(n){Am=n}var fy=of(),cy=[.32,-.4,1],dy=new Ds({color:"#000",transparent:!0,opacity:.1,side:Ji,depthWrite:!1,fog:!1,stencilWrite:!0,stencilFunc:Ep,stencilRef:1,stencilZPass:wp,polygonOffset:!0,polygonOffsetFactor:-1,polygonOffsetUnits:-1}),iR=new Te().set(1,0,-cy[0],0,0,1,-cy[1],0,0,0,0,5e-4,0,0,0,1),xf=new Pa(fy,{shadow:{material:dy,matrix:iR}}),py=of({opacity:.2,veil:!0}),gf=new Pa(py,{veil:!0}),my=of({opacity:.62,gloss:.1}),Pm=new Pa(my,{veil:!0}),vf=new af,bo=nf(P.table),bf=[],yf=null;function gy(){gi.add(xf.group,gf.group,Pm.group,vf.group),gf.group.renderOrder=1,gt("table",n=>{bo=nf(P.table),rm(bo.size),bf=[],yf=null,Im(),Sf(),n==="new"&&mc({instant:!0,view:"iso"}),Ex()}),gt("q",rR),gt("frames",yy),gt("theme",hy),gt("hurry",n=>{for(let t of[xf,gf,Pm])t.hurry(n)}),hy()}var uy=new Map,pc=[],Cm=0;function Mo(n,t){if(uy.set(n,t),pc=[...uy.values()].flat(),!P.table.joints.length)return;let e=Cm;Cm=pc.length,im([...rc(P.table,P.frames),...pc]),t.length?xy():e>Cm&&sR()}var sR=Rs(Ix,120);function _y(n,t){let e=Math.max(1,Math.floor(t.length/40)),i=t.filter((r,o)=>o%e===0||o===t.length-1).flatMap(r=>rc(n,$s(n,r))),s=[0,1,2].map(r=>[Math.min(...i.map(o=>o[r])),Math.max(...i.map(o=>o[r]))]);Mo("motion",i.length?s[0].flatMap(r=>s[1].flatMap(o=>s[2].map(a=>[r,o,a]))):[])}function mc(n){tf([...rc(P.table,P.frames),...pc],n)}var xy=Rs(Ca,220);function rR(){let n=P.frames;xf.show(P.table.joints.length?[am(P.table,n,bo,P.q)]:[]),im([...rc(P.table,n),...pc]),xy(),Ey&&oR(ye(n[n.length-1])),yy()}function yy(){vf.show((P.shownFrames??[]).filter(n=>n<P.frames.length&&!(n===P.frames.length-1&&$x())).map(n=>({T:P.frames[n],name:Mf(n)})),bo.size*.13),qe()}var vy=()=>xf.arms.flatMap(n=>[...n.drums,...n.sleeves].filter(t=>t.beyond).map(t=>t.joint+1)),by=()=>(vf.last?.[0]??[]).map(n=>n.name);function Mf(n){let t=P.table.joints.length;return n===0?"base":n===t+1?"tool":String(n)}function My(n){bf=n,Im()}function Na(n){yf=n,Im()}var Sy=()=>bf.length;function Im(){let n=t=>am(P.table,$s(P.table,t),bo);gf.show(bf.map(n)),Pm.show(yf?[n(yf)]:[]),qe()}var wy=6e3,_f=new Float32Array(6*wy),fr=new ao(new De,new rr({fog:!1}));fr.geometry.setAttribute("position",new sn(_f,3));fr.frustumCulled=!1;fr.visible=!1;var Xr=0,Ey=!0,dc=null;gi.add(fr);function oR(n){let t=dc?As(qi(n,dc)):1/0;t<bo.size*.002||(t<bo.size*.2&&(Xr===wy&&(_f.copyWithin(0,6*1e3),Xr-=1e3),_f.set(dc,6*Xr),_f.set(n,6*Xr+3),Xr+=1,fr.geometry.setDrawRange(0,2*Xr),fr.geometry.attributes.position.needsUpdate=!0,fr.visible=!0),dc=n)}function Ty(n){Ey=n,n||Sf(),qe()}function Sf(){Xr=0,dc=null,fr.visible=!1,qe()}var Ay=()=>Xr,gc=new ya(new De,new rr({fog:!1}));gc.frustumCulled=!1;var _c=new lo(new De,new Ir({size:4,sizeAttenuation:!1,fog:!1}));_c.frustumCulled=!1;gc.visible=_c.visible=!1;gi.add(gc,_c);function wf(n){Mo("path",n);let t=new Float32Array(n.flat());for(let e of[gc,_c])e.geometry.dispose(),e.geometry=new De,e.geometry.setAttribute("position",new sn(t,3)),e.visible=n.length>0;qe()}function hy(){fy.repaint(pe.link,pe.joint,pe.accent,pe.dark,pe.wrong),py.repaint(pe.ghost,pe.ghost,pe.ghost,pe.dark),my.repaint(pe.accent,pe.accent,pe.accent,pe.dark),fr.material.color.set(pe.accent),gc.material.color.set(pe.trace),_c.material.color.set(pe.trace),dy.opacity=pe.dark?.28:.11,vf.paint(),qe()}var de={follow:!0,ghosts:"all",task:null,redundancy:null},Lm={answers:0},Ef=!1,Ry=Gc(async()=>{let n=Ef;Ef=!1;let t=P.target,e=P.table;try{let i=pf()||Dm,s=i?null:P.digits,{task:r,redundancy:o}=de,a=await Yn("ik",{T:t,q:P.q,brief:i,task:r,redundancy:o,digits:s});if(e!==P.table||t!==P.target&&!i)return;Lm.answers+=1,P.solutions={...a,T:t,brief:i},n&&de.follow&&a.nearest&&Xi(a.nearest,"follow"),Ua(),Dt("solutions"),!i&&!a.rows.some(c=>c.inside)&&cR(t),a.self_motions===null&&!i&&lR(P.solutions)}catch(i){if(i instanceof Hc)return;P.solutions={rows:[],self_motions:[],status:"REFUSED",why:i.message,nearest:null},Ua(),Dt("solutions")}}),Dm=!1;function Cy(){Dm=!0,Ef=!0,Ry()}function ps({follow:n=!1}={}){Dm=!1,Ef||=n,Ry()}var lR=Gc(async n=>{try{let t={T:n.T,q:P.q,task:de.task,redundancy:de.redundancy},{self_motions:e}=await Yn("self_motions",t);if(P.solutions!==n||!e)return;n.self_motions=e,Dt("solutions")}catch{}}),cR=Gc(async n=>{try{let t=await Yn("nearest",{T:n,task:de.task});P.solutions&&P.solutions.T===n&&(P.solutions.near=t,Dt("solutions"))}catch{}}),uR=(n,t)=>n.every((e,i)=>Math.abs(Math.atan2(Math.sin(e-t[i]),Math.cos(e-t[i])))<1e-6||Math.abs(e-t[i])<1e-9);function Ua(){let n=P.solutions?.rows??[],t=P.panel==="inverse"&&de.ghosts!=="none"?n.filter(e=>(de.ghosts==="all"||e.inside)&&!uR(e.q,P.q)):[];My(t.map(e=>e.q))}function Py(){gt("target",n=>{P.panel==="inverse"&&ps({follow:i0.has(n)})}),gt("task",()=>{Dt("plan"),P.panel==="inverse"&&P.hasTarget&&ps()}),gt("panel",n=>{Na(null),n==="inverse"&&P.hasTarget&&!P.solutions&&ps(),Ua()}),gt("moving",n=>{n||Ua()}),gt("table",n=>{de.redundancy=null,n==="new"&&(de.task=null),Dt("solutions"),n!=="new"&&P.panel==="inverse"&&P.hasTarget&&ps()}),gt("online",n=>{n&&P.panel==="inverse"&&P.hasTarget&&P.table.joints.length&&ps()})}var xc=0;function xi(){xc+=1,P.moving&&(P.moving=!1,Dt("moving",!1))}function ms(n,t=.8,e="move to a posture"){xi(),Dt("let-go"),Dt("did",{label:e});let i=P.q.slice(),s=xc,r=performance.now();return matchMedia("(prefers-reduced-motion: reduce)").matches&&(t=0),P.moving=!0,Dt("moving",!0),new Promise(o=>{(function a(c){if(s!==xc||i.length!==P.q.length){o(!1);return}let l=t>0?Math.min(Math.max((c-r)/(1e3*t),0),1):1,u=l**3*(10-15*l+6*l*l);Xi(l<1?i.map((h,f)=>h+u*(n[f]-h)):n.slice(),"move"),l<1?requestAnimationFrame(a):(P.moving=!1,Dt("moving",!1),o(!0))})(r)})}function Iy(n,t,e,i){xi();let s=xc,r=performance.now()-1e3*n*t;P.moving=!0,Dt("moving",!0),requestAnimationFrame(function o(a){if(s!==xc){i?.(!1);return}let c=Math.min(Math.max((a-r)/(1e3*n),0),1);e(c),c<1?requestAnimationFrame(o):(P.moving=!1,Dt("moving",!1),i?.(!0))})}var fR=200,dR=1500,So=[],bc=[],vc=null,yc={key:null,at:0,open:!1},Nm=!1,Tf=()=>({table:P.table,q:P.q,target:P.target,digits:P.digits,hasTarget:P.hasTarget,path:{...P.path},sequence:structuredClone(P.sequence),program:P.program,world:P.world,task:de.task,redundancy:de.redundancy});function Um(){Nm||(Nm=!0,queueMicrotask(()=>{Nm=!1,vc=Tf()}))}function pR({label:n,key:t=n,open:e=!1}){let i=performance.now();!(t===yc.key&&(yc.open||i-yc.at<dR))&&vc&&(So.push({label:n,before:vc}),So.length>fR&&So.shift(),bc.length=0),yc={key:t,at:i,open:e},Um(),Dt("history")}function Fm(){yc={key:null,at:0,open:!1}}function mR(n){xi(),Fm(),de.task=n.task,n.table!==P.table?_n(n.table,{q:n.q,step:!1,what:"undo"}):Xi(n.q,"undo"),de.redundancy=n.redundancy,Object.assign(P.path,n.path),P.sequence=structuredClone(n.sequence),P.program=n.program,P.world=n.world,P.hasTarget=n.hasTarget,n.target!==P.target&&Di(n.target,"restored",n.digits);for(let t of["path-loaded","sequence-loaded","program","world","task"])Dt(t,"undo")}function Ly(n,t,e){let i=n.pop();if(!i)return;let s=Tf();mR(i.before),t.push({label:i.label,before:s}),Um(),Dt("history"),Rn(`${e}: ${i.label}`)}var Om=()=>Ly(So,bc,"Undone"),Bm=()=>Ly(bc,So,"Redone"),Af=()=>So.at(-1)?.label??null,Rf=()=>bc.at(-1)?.label??null;function Cf(){So.length=0,bc.length=0,Fm(),vc=Tf(),Dt("history")}function Dy(){vc=Tf(),gt("did",pR),gt("let-go",Fm),gt(["table","q","target","path","sequence","program","world","task"],Um)}var Uy=1,Fy=30;function Pf(){let{table:n,q:t,target:e,hasTarget:i,notation:s,shownFrames:r,path:o,sequence:a,panel:c,theme:l}=P;return{pieper:Uy,table:n,q:t,target:i?e:null,digits:P.digits,task:de.task,redundancy:de.redundancy,follow:de.follow,ghosts:de.ghosts,notation:s,frames:r,path:o,sequence:a,panel:c,theme:l,units:[yt.angle,yt.length],camera:ef()}}var gs=n=>typeof n=="number"&&Number.isFinite(n)&&Math.abs(n)<1e7,Fa=(n,t)=>Array.isArray(n)&&n.length===t&&n.every(gs),Bs=(n,t)=>typeof n=="string"?n.slice(0,t):"",Mc=n=>{if(!Fa(n,16))return null;let t=Oc(n);return t<1e-12?n.slice():t<.001?Bc(n):null},_R=n=>n&&gs(n.metres)&&gs(n.radians)?{metres:n.metres,radians:n.radians}:null,xR=n=>n&&[n.lower,n.upper,n.value].every(gs)&&n.lower<=n.upper?{name:Bs(n.name,40),lower:n.lower,upper:n.upper,value:n.value,unit:Bs(n.unit,10)}:null,yR=(n,t)=>Array.isArray(n)&&n.length===t&&n.every(e=>Fa(e,t))?n:null;function vR(n){if(!n||!Array.isArray(n.joints)||n.joints.length>Fy||!["standard","modified"].includes(n.convention))return null;let t=n.joints.map((i,s)=>{if(!i||!["a","alpha","d","theta","offset"].every(o=>gs(i[o]))||!["R","P"].includes(i.type)||![1,-1].includes(i.sign))return null;let r=Object.fromEntries(Object.entries(i.text??{}).filter(([,o])=>typeof o=="string"&&o.length<80));return{name:Bs(i.name,40)||`joint_${s+1}`,type:i.type,a:i.a,alpha:i.alpha,d:i.d,theta:i.theta,lower:gs(i.lower)?i.lower:null,upper:gs(i.upper)?i.upper:null,sign:i.sign,offset:i.offset,text:r}});if(t.includes(null))return null;let e=Object.fromEntries(Object.entries(n.postures??{}).filter(([,i])=>Fa(i,t.length)).slice(0,40));return{name:Bs(n.name,60),convention:n.convention,joints:t,base:Mc(n.base)??qs(),tool:Mc(n.tool)??qs(),postures:e,manufacturer:Bs(n.manufacturer,200),source:Bs(n.source,2e3),notes:Bs(n.notes,3e3),actuator:xR(n.actuator),catalog:Bs(n.catalog,60)||void 0,derived:Bs(n.derived,60)||void 0,coupling:yR(n.coupling,t.length)}}function If(n,t){let e=n&&n.pieper===Uy?vR(n.table):null;if(!e)throw new Error("This is not a state of the workbench.");let i=e.joints.length;Array.isArray(n.units)&&(yt.set("angle",n.units[0]),yt.set("length",n.units[1])),Object.hasOwn(ds,n.notation)&&(P.notation=n.notation),["auto","light","dark"].includes(n.theme)&&Zh(n.theme),P.shownFrames=Array.isArray(n.frames)?n.frames.filter(a=>Number.isInteger(a)&&a>=0&&a<i+2):null;let s=n.path??{};_n(e,{q:Fa(n.q,i)?n.q:null,step:!1,what:"new"}),Object.assign(P.path,{from:Mc(s.from),to:Mc(s.to),n:Number.isInteger(s.n)&&s.n>=2&&s.n<=2e3?s.n:50,seconds:gs(s.seconds)&&s.seconds>0?s.seconds:5}),P.sequence.postures=(Array.isArray(n.sequence?.postures)?n.sequence.postures:[]).filter(a=>a&&Fa(a.q,i)&&gs(a.seconds)&&gs(a.hold)).slice(0,40).map(a=>({name:Bs(a.name,20)||"P",q:a.q.slice(),seconds:a.seconds,hold:a.hold})),["pose","position","position+axis"].includes(n.task)&&(de.task=n.task);let r=Object.entries(n.redundancy??{}).filter(([a,c])=>a.length<80&&gs(c));de.redundancy=r.length?Object.fromEntries(r.slice(0,Fy)):null,typeof n.follow=="boolean"&&(de.follow=n.follow),["all","inside","none"].includes(n.ghosts)&&(de.ghosts=n.ghosts);let o=Mc(n.target);P.hasTarget=!!o,o&&Di(o,"restored",_R(n.digits));for(let a of["units","notation","sequence-loaded","task"])Dt(a);t(n.panel),Dt("path-loaded"),Fa(n.camera,6)&&Lx(n.camera),Xi(P.q,"restored"),Cf()}async function Oy(n,t){return new Uint8Array(await new Response(new Blob([n]).stream().pipeThrough(new t("deflate-raw"))).arrayBuffer())}async function Lf(){let n=await Oy(new TextEncoder().encode(JSON.stringify(Pf())),CompressionStream),t=btoa(String.fromCharCode(...n)).replaceAll("+","-").replaceAll("/","_").replace(/=+$/,"");return`${location.origin}${location.pathname}#s=${t}`}async function By(){let n=bR();if(n)return n;let t=/^#s=([\w-]+)$/.exec(location.hash);if(!t)return null;if(t[1].length>6e4)throw new Error("The link is too long.");let e=Uint8Array.from(atob(t[1].replaceAll("-","+").replaceAll("_","/")),s=>s.charCodeAt(0)),i=await Oy(e,DecompressionStream);if(i.length>5e5)throw new Error("The link unfolds to more than it should.");return JSON.parse(new TextDecoder().decode(i))}var ky="pieper-workbench";function bR(){try{let{address:n,shown:t}=JSON.parse(sessionStorage.getItem(ky)??"{}");return t&&n===location.href?t:null}catch{return null}}function MR(){if(P.table.joints.length)try{sessionStorage.setItem(ky,JSON.stringify({address:location.href,shown:Pf()}))}catch{}}var Ny=null,SR=Rs(async()=>{if(!P.table.joints.length)return;let n=await Lf();n!==Ny&&(Ny=n,history.replaceState(null,"",n))},600);function zy(){addEventListener("pagehide",MR),gt(["table","q","target","solutions","units","notation","panel","path","sequence","theme","frames"],SR)}var ER="uplot",TR="u-hz",AR="u-vt",RR="u-title",CR="u-wrap",PR="u-under",IR="u-over",LR="u-axis",To="u-off",DR="u-select",NR="u-cursor-x",UR="u-cursor-y",FR="u-cursor-pt",OR="u-legend",BR="u-live",kR="u-inline",zR="u-series",HR="u-marker",Hy="u-label",GR="u-value",wc="width",Ec="height";var Gy="bottom",Oa="left",km="right",ng="#000",Vy=ng+"0",zm="mousemove",Wy="mousedown",Hm="mouseup",qy="mouseenter",Xy="mouseleave",$y="dblclick",VR="resize",WR="scroll",Yy="change",Of="dppxchange",ig="--",Wa=typeof window<"u",Xm=Wa?document:null,ka=Wa?window:null,qR=Wa?navigator:null,Fe,Df;function $m(){let n=devicePixelRatio;Fe!=n&&(Fe=n,Df&&Zm(Yy,Df,$m),Df=matchMedia(`(min-resolution: ${Fe-.001}dppx) and (max-resolution: ${Fe+.001}dppx)`),Ao(Yy,Df,$m),ka.dispatchEvent(new CustomEvent(Of)))}function zi(n,t){if(t!=null){let e=n.classList;!e.contains(t)&&e.add(t)}}function Ym(n,t){let e=n.classList;e.contains(t)&&e.remove(t)}function rn(n,t,e){n.style[t]=e+"px"}function _s(n,t,e,i){let s=Xm.createElement(n);return t!=null&&zi(s,t),e?.insertBefore(s,i),s}function Qi(n,t){return _s("div",n,t)}var Zy=new WeakMap;function ks(n,t,e,i,s){let r="translate("+t+"px,"+e+"px)",o=Zy.get(n);r!=o&&(n.style.transform=r,Zy.set(n,r),t<0||e<0||t>i||e>s?zi(n,To):Ym(n,To))}var Jy=new WeakMap;function Ky(n,t,e){let i=t+e,s=Jy.get(n);i!=s&&(Jy.set(n,i),n.style.background=t,n.style.borderColor=e)}var jy=new WeakMap;function Qy(n,t,e,i){let s=t+""+e,r=jy.get(n);s!=r&&(jy.set(n,s),n.style.height=e+"px",n.style.width=t+"px",n.style.marginLeft=i?-t/2+"px":0,n.style.marginTop=i?-e/2+"px":0)}var sg={passive:!0},XR={...sg,capture:!0};function Ao(n,t,e,i){t.addEventListener(n,e,i?XR:sg)}function Zm(n,t,e,i){t.removeEventListener(n,e,sg)}Wa&&$m();function xs(n,t,e,i){let s;e=e||0,i=i||t.length-1;let r=i<=2147483647;for(;i-e>1;)s=r?e+i>>1:Hi((e+i)/2),t[s]<n?e=s:i=s;return n-t[e]<=t[i]-n?e:i}function Av(n){return(e,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(e[a])){r=a;break}for(let a=s;a>=i;a--)if(n(e[a])){o=a;break}return[r,o]}}var Rv=n=>n!=null,Cv=n=>n!=null&&n>0,zf=Av(Rv),$R=Av(Cv);function YR(n,t,e,i=0,s=!1){let r=s?$R:zf,o=s?Cv:Rv;[t,e]=r(n,t,e);let a=n[t],c=n[t];if(t>-1)if(i==1)a=n[t],c=n[e];else if(i==-1)a=n[e],c=n[t];else for(let l=t;l<=e;l++){let u=n[l];o(u)&&(u<a?a=u:u>c&&(c=u))}return[a??Ze,c??-Ze]}function Hf(n,t,e,i){let s=nv(n),r=nv(t);n==t&&(s==-1?(n*=e,t/=e):(n/=e,t*=e));let o=e==10?dr:Pv,a=s==1?Hi:ts,c=r==1?ts:Hi,l=a(o(On(n))),u=c(o(On(t))),h=za(e,l),f=za(e,u);return e==10&&(l<0&&(h=Je(h,-l)),u<0&&(f=Je(f,-u))),i||e==2?(n=h*s,t=f*r):(n=Nv(n,h),t=Gf(t,f)),[n,t]}function rg(n,t,e,i){let s=Hf(n,t,e,i);return n==0&&(s[0]=0),t==0&&(s[1]=0),s}var og=.1,tv={mode:3,pad:og},Ac={pad:0,soft:null,mode:0},ZR={min:Ac,max:Ac};function Bf(n,t,e,i){return Vf(e)?ev(n,t,e):(Ac.pad=e,Ac.soft=i?0:null,Ac.mode=i?3:0,ev(n,t,ZR))}function Ie(n,t){return n??t}function JR(n,t,e){for(t=Ie(t,0),e=Ie(e,n.length-1);t<=e;){if(n[t]!=null)return!0;t++}return!1}function ev(n,t,e){let i=e.min,s=e.max,r=Ie(i.pad,0),o=Ie(s.pad,0),a=Ie(i.hard,-Ze),c=Ie(s.hard,Ze),l=Ie(i.soft,Ze),u=Ie(s.soft,-Ze),h=Ie(i.mode,0),f=Ie(s.mode,0),d=t-n,g=dr(d),_=yi(On(n),On(t)),p=dr(_),m=On(p-g);(d<1e-24||m>10)&&(d=0,(n==0||t==0)&&(d=1e-24,h==2&&l!=Ze&&(r=0),f==2&&u!=-Ze&&(o=0)));let x=d||_||1e3,M=dr(x),v=za(10,Hi(M)),A=x*(d==0?n==0?.1:1:r),S=Je(Nv(n-A,v/10),24),y=n>=l&&(h==1||h==3&&S<=l||h==2&&S>=l)?l:Ze,w=yi(a,S<y&&n>=y?y:ys(y,S)),U=x*(d==0?t==0?.1:1:o),L=Je(Gf(t+U,v/10),24),N=t<=u&&(f==1||f==3&&L>=u||f==2&&L<=u)?u:-Ze,z=ys(c,L>N&&t<=N?N:yi(N,L));return w==z&&w==0&&(z=100),[w,z]}var KR=new Intl.NumberFormat(Wa?qR.language:"en-US"),ag=n=>KR.format(n),Gi=Math,Ff=Gi.PI,On=Gi.abs,Hi=Gi.floor,Fn=Gi.round,ts=Gi.ceil,ys=Gi.min,yi=Gi.max,za=Gi.pow,nv=Gi.sign,dr=Gi.log10,Pv=Gi.log2,jR=(n,t=1)=>Gi.sinh(n)*t,Gm=(n,t=1)=>Gi.asinh(n/t),Ze=1/0;function iv(n){return(dr((n^n>>31)-(n>>31))|0)+1}function Jm(n,t,e){return ys(yi(n,t),e)}function Iv(n){return typeof n=="function"}function Ae(n){return Iv(n)?n:()=>n}var QR=()=>{},Lv=n=>n,Dv=(n,t)=>t,tC=n=>null,sv=n=>!0,rv=(n,t)=>n==t,eC=/\.\d*?(?=9{6,}|0{6,})/gm,Ro=n=>{if(Fv(n)||Yr.has(n))return n;let t=`${n}`,e=t.match(eC);if(e==null)return n;let i=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${Ro(s)}e${r}`}return Je(n,i)};function wo(n,t){return Ro(Je(Ro(n/t))*t)}function Gf(n,t){return Ro(ts(Ro(n/t))*t)}function Nv(n,t){return Ro(Hi(Ro(n/t))*t)}function Je(n,t=0){if(Fv(n))return n;let e=10**t,i=n*e*(1+Number.EPSILON);return Fn(i)/e}var Yr=new Map;function Uv(n){return((""+n).split(".")[1]||"").length}function Cc(n,t,e,i){let s=[],r=i.map(Uv);for(let o=t;o<e;o++){let a=On(o),c=Je(za(n,o),a);for(let l=0;l<i.length;l++){let u=n==10?+`${i[l]}e${o}`:i[l]*c,h=(o>=0?0:a)+(o>=r[l]?0:r[l]),f=n==10?u:Je(u,h);s.push(f),Yr.set(f,h)}}return s}var Rc={},lg=[],Ha=[null,null],$r=Array.isArray,Fv=Number.isInteger,nC=n=>n===void 0;function ov(n){return typeof n=="string"}function Vf(n){let t=!1;if(n!=null){let e=n.constructor;t=e==null||e==Object}return t}function iC(n){return n!=null&&typeof n=="object"}var sC=Object.getPrototypeOf(Uint8Array),Ov="__proto__";function Ga(n,t=Vf){let e;if($r(n)){let i=n.find(s=>s!=null);if($r(i)||t(i)){e=Array(n.length);for(let s=0;s<n.length;s++)e[s]=Ga(n[s],t)}else e=n.slice()}else if(n instanceof sC)e=n.slice();else if(t(n)){e={};for(let i in n)i!=Ov&&(e[i]=Ga(n[i],t))}else e=n;return e}function Pn(n){let t=arguments;for(let e=1;e<t.length;e++){let i=t[e];for(let s in i)s!=Ov&&(Vf(n[s])?Pn(n[s],Ga(i[s])):n[s]=Ga(i[s]))}return n}var rC=0,oC=1,aC=2;function lC(n,t,e){for(let i=0,s,r=-1;i<t.length;i++){let o=t[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<e&&n[s]==null;)n[r=s++]=null}}}function cC(n,t){if(fC(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return dC(o[0])||(o=hC(o)),o}let e=new Set;for(let o=0;o<n.length;o++){let c=n[o][0],l=c.length;for(let u=0;u<l;u++)e.add(c[u])}let i=[Array.from(e).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],c=a[0];for(let l=1;l<a.length;l++){let u=a[l],h=Array(s).fill(void 0),f=t?t[o][l]:oC,d=[];for(let g=0;g<u.length;g++){let _=u[g],p=r.get(c[g]);_===null?f!=rC&&(h[p]=_,f==aC&&d.push(p)):h[p]=_}lC(h,d,s),i.push(h)}}return i}var uC=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function hC(n){let t=n[0],e=t.length,i=Array(e);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(e);for(let c=0;c<e;c++)a[c]=o[i[c]];s.push(a)}return s}function fC(n){let t=n[0][0],e=t.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function dC(n,t=100){let e=n.length;if(e<=1)return!0;let i=0,s=e-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=yi(1,Hi((s-i+1)/t));for(let o=n[i],a=i+r;a<=s;a+=r){let c=n[a];if(c!=null){if(c<=o)return!1;o=c}}return!0}var Bv=["January","February","March","April","May","June","July","August","September","October","November","December"],kv=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function zv(n){return n.slice(0,3)}var pC=kv.map(zv),mC=Bv.map(zv),gC={MMMM:Bv,MMM:mC,WWWW:kv,WWW:pC};function Sc(n){return(n<10?"0":"")+n}function _C(n){return(n<10?"00":n<100?"0":"")+n}var xC={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,t)=>t.MMMM[n.getMonth()],MMM:(n,t)=>t.MMM[n.getMonth()],MM:n=>Sc(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>Sc(n.getDate()),D:n=>n.getDate(),WWWW:(n,t)=>t.WWWW[n.getDay()],WWW:(n,t)=>t.WWW[n.getDay()],HH:n=>Sc(n.getHours()),H:n=>n.getHours(),h:n=>{let t=n.getHours();return t==0?12:t>12?t-12:t},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>Sc(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>Sc(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>_C(n.getMilliseconds())};function cg(n,t){t=t||gC;let e=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)e.push(s[0][0]=="{"?xC[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var yC=new Intl.DateTimeFormat().resolvedOptions().timeZone;function vC(n,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+n+n.getTimezoneOffset()*6e4):t==yC?e=n:(e=new Date(n.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(n.getMilliseconds())),e}var Hv=n=>n%1==0,kf=[1,2,2.5,5],bC=Cc(10,-32,0,kf),Gv=Cc(10,0,32,kf),MC=Gv.filter(Hv),Eo=bC.concat(Gv),ug=`
`,Vv="{YYYY}",av=ug+Vv,Wv="{M}/{D}",Tc=ug+Wv,Nf=Tc+"/{YY}",qv="{aa}",SC="{h}:{mm}",Ba=SC+qv,lv=ug+Ba,cv=":{ss}",Be=null;function Xv(n){let t=n*1e3,e=t*60,i=e*60,s=i*24,r=s*30,o=s*365,c=(n==1?Cc(10,0,3,kf).filter(Hv):Cc(10,-3,0,kf)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),l=[[o,Vv,Be,Be,Be,Be,Be,Be,1],[s*28,"{MMM}",av,Be,Be,Be,Be,Be,1],[s,Wv,av,Be,Be,Be,Be,Be,1],[i,"{h}"+qv,Nf,Be,Tc,Be,Be,Be,1],[e,Ba,Nf,Be,Tc,Be,Be,Be,1],[t,cv,Nf+" "+Ba,Be,Tc+" "+Ba,Be,lv,Be,1],[n,cv+".{fff}",Nf+" "+Ba,Be,Tc+" "+Ba,Be,lv,Be,1]];function u(h){return(f,d,g,_,p,m)=>{let x=[],M=p>=o,v=p>=r&&p<o,A=h(g),S=Je(A*n,3),y=Vm(A.getFullYear(),M?0:A.getMonth(),v||M?1:A.getDate()),w=Je(y*n,3);if(v||M){let U=v?p/r:0,L=M?p/o:0,N=S==w?S:Je(Vm(y.getFullYear()+L,y.getMonth()+U,1)*n,3),z=new Date(Fn(N/n)),W=z.getFullYear(),O=z.getMonth();for(let X=0;N<=_;X++){let Z=Vm(W+L*X,O+U*X,1),q=Z-h(Je(Z*n,3));N=Je((+Z+q)*n,3),N<=_&&x.push(N)}}else{let U=p>=s?s:p,L=Hi(g)-Hi(S),N=w+L+Gf(S-w,U);x.push(N);let z=h(N),W=z.getHours()+z.getMinutes()/e+z.getSeconds()/i,O=p/i,X=f.axes[d]._space,Z=m/X;for(;N=Je(N+p,n==1?0:3),!(N>_);)if(O>1){let q=Hi(Je(W+O,6))%24,tt=h(N).getHours()-q;tt>1&&(tt=-1),N-=tt*i,W=(W+O)%24;let rt=x[x.length-1];Je((N-rt)/p,3)*Z>=.7&&x.push(N)}else x.push(N)}return x}}return[c,l,u]}var[wC,EC,TC]=Xv(1),[AC,RC,CC]=Xv(.001);Cc(2,-53,53,[1]);function uv(n,t){return n.map(e=>e.map((i,s)=>s==0||s==8||i==null?i:t(s==1||e[8]==0?i:e[1]+i)))}function hv(n,t){return(e,i,s,r,o)=>{let a=t.find(g=>o>=g[0])||t[t.length-1],c,l,u,h,f,d;return i.map(g=>{let _=n(g),p=_.getFullYear(),m=_.getMonth(),x=_.getDate(),M=_.getHours(),v=_.getMinutes(),A=_.getSeconds(),S=p!=c&&a[2]||m!=l&&a[3]||x!=u&&a[4]||M!=h&&a[5]||v!=f&&a[6]||A!=d&&a[7]||a[1];return c=p,l=m,u=x,h=M,f=v,d=A,S(_)})}}function PC(n,t){let e=cg(t);return(i,s,r,o,a)=>s.map(c=>e(n(c)))}function Vm(n,t,e){return new Date(n,t,e)}function fv(n,t){return t(n)}var IC="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function dv(n,t){return(e,i,s,r)=>r==null?ig:t(n(i))}function LC(n,t){let e=n.series[t];return e.width?e.stroke(n,t):e.points.width?e.points.stroke(n,t):null}function DC(n,t){return n.series[t].fill(n,t)}var NC={show:!0,live:!0,isolate:!1,mount:QR,markers:{show:!0,width:2,stroke:LC,fill:DC,dash:"solid"},idx:null,idxs:null,values:[]};function UC(n,t){let e=n.cursor.points,i=Qi(),s=e.size(n,t);rn(i,wc,s),rn(i,Ec,s);let r=s/-2;rn(i,"marginLeft",r),rn(i,"marginTop",r);let o=e.width(n,t,s);return o&&rn(i,"borderWidth",o),i}function FC(n,t){let e=n.series[t].points;return e._fill||e._stroke}function OC(n,t){let e=n.series[t].points;return e._stroke||e._fill}function BC(n,t){return n.series[t].points.size}var Wm=[0,0];function kC(n,t,e){return Wm[0]=t,Wm[1]=e,Wm}function Uf(n,t,e,i=!0){return s=>{s.button==0&&(!i||s.target==t)&&e(s)}}function qm(n,t,e,i=!0){return s=>{(!i||s.target==t)&&e(s)}}var zC={show:!0,x:!0,y:!0,lock:!1,move:kC,points:{one:!1,show:UC,size:BC,width:0,stroke:OC,fill:FC},bind:{mousedown:Uf,mouseup:Uf,click:Uf,dblclick:Uf,mousemove:qm,mouseleave:qm,mouseenter:qm},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,t,e,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},$v={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},hg=Pn({},$v,{filter:Dv}),Yv=Pn({},hg,{size:10}),Zv=Pn({},$v,{show:!1}),fg='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',Jv="bold "+fg,Kv=1.5,pv={show:!0,scale:"x",stroke:ng,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Jv,side:2,grid:hg,ticks:Yv,border:Zv,font:fg,lineGap:Kv,rotate:0},HC="Value",GC="Time",mv={show:!0,scale:"x",auto:!1,sorted:1,min:Ze,max:-Ze,idxs:[]};function VC(n,t,e,i,s){return t.map(r=>r==null?"":ag(r))}function WC(n,t,e,i,s,r,o){let a=[],c=Yr.get(s)||0;e=o?e:Je(Gf(e,s),c);for(let l=e;l<=i;l=Je(l+s,c))a.push(Object.is(l,-0)?0:l);return a}function Km(n,t,e,i,s,r,o){let a=[],c=n.scales[n.axes[t].scale].log,l=c==10?dr:Pv,u=Hi(l(e));s=za(c,u),c==10&&(s=Eo[xs(s,Eo)]);let h=e,f=s*c;c==10&&(f=Eo[xs(f,Eo)]);do a.push(h),h=h+s,c==10&&!Yr.has(h)&&(h=Je(h,Yr.get(s))),h>=f&&(s=h,f=s*c,c==10&&(f=Eo[xs(f,Eo)]));while(h<=i);return a}function qC(n,t,e,i,s,r,o){let c=n.scales[n.axes[t].scale].asinh,l=i>c?Km(n,t,yi(c,e),i,s):[c],u=i>=0&&e<=0?[0]:[];return(e<-c?Km(n,t,yi(c,-i),-e,s):[c]).reverse().map(f=>-f).concat(u,l)}var jv=/./,XC=/[12357]/,$C=/[125]/,gv=/1/,jm=(n,t,e,i)=>n.map((s,r)=>t==4&&s==0||r%i==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function YC(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=n.scales[o],c=n.valToPos,l=r._space,u=c(10,o),h=c(9,o)-u>=l?jv:c(7,o)-u>=l?XC:c(5,o)-u>=l?$C:gv;if(h==gv){let f=On(c(1,o)-u);if(f<l)return jm(t.slice().reverse(),a.distr,h,ts(l/f)).reverse()}return jm(t,a.distr,h,1)}function ZC(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=r._space,c=n.valToPos,l=On(c(1,o)-c(2,o));return l<a?jm(t.slice().reverse(),3,jv,ts(a/l)).reverse():t}function JC(n,t,e,i){return i==null?ig:t==null?"":ag(t)}var _v={show:!0,scale:"y",stroke:ng,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Jv,side:3,grid:hg,ticks:Yv,border:Zv,font:fg,lineGap:Kv,rotate:0};function KC(n,t){let e=3+(n||1)*2;return Je(e*t,3)}function jC(n,t){let{scale:e,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],e,!0),o=n.valToPos(s[i[1]],e,!0),a=On(o-r),c=n.series[t],l=a/(c.points.space*Fe);return i[1]-i[0]<=l}var xv={scale:null,auto:!0,sorted:0,min:Ze,max:-Ze},Qv=(n,t,e,i,s)=>s,yv={show:!0,auto:!0,sorted:0,gaps:Qv,alpha:1,facets:[Pn({},xv,{scale:"x"}),Pn({},xv,{scale:"y"})]},vv={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Qv,alpha:1,points:{show:jC,filter:null},values:null,min:Ze,max:-Ze,idxs:[],path:null,clip:null};function QC(n,t,e,i,s){return e/10}var tb={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},tP=Pn({},tb,{time:!1,ori:1}),bv={};function eb(n,t){let e=bv[n];return e||(e={key:n,plots:[],sub(i){e.plots.push(i)},unsub(i){e.plots=e.plots.filter(s=>s!=i)},pub(i,s,r,o,a,c,l){for(let u=0;u<e.plots.length;u++)e.plots[u]!=s&&e.plots[u].pub(i,s,r,o,a,c,l)}},n!=null&&(bv[n]=e)),e}var Va=1,Qm=2;function Co(n,t,e){let i=n.mode,s=n.series[t],r=i==2?n._data[t]:n._data,o=n.scales,a=n.bbox,c=r[0],l=i==2?r[1]:r[t],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],h=i==2?o[s.facets[1].scale]:o[s.scale],f=a.left,d=a.top,g=a.width,_=a.height,p=n.valToPosH,m=n.valToPosV;return u.ori==0?e(s,c,l,u,h,p,m,f,d,g,_,qf,qa,$f,ib,rb):e(s,c,l,u,h,m,p,d,f,_,g,Xf,Xa,mg,sb,ob)}function dg(n,t){let e=0,i=0,s=Ie(n.bands,lg);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?i|=1:i|=2)}return[e,i==1?-1:i==2?1:i==3?2:0]}function eP(n,t,e,i,s){let r=n.mode,o=n.series[t],a=r==2?o.facets[1].scale:o.scale,c=n.scales[a];return s==-1?c.min:s==1?c.max:c.distr==3?c.dir==1?c.min:c.max:0}function pr(n,t,e,i,s,r){return Co(n,t,(o,a,c,l,u,h,f,d,g,_,p)=>{let m=o.pxRound,x=l.dir*(l.ori==0?1:-1),M=l.ori==0?qa:Xa,v,A;x==1?(v=e,A=i):(v=i,A=e);let S=m(h(a[v],l,_,d)),y=m(f(c[v],u,p,g)),w=m(h(a[A],l,_,d)),U=m(f(r==1?u.max:u.min,u,p,g)),L=new Path2D(s);return M(L,w,U),M(L,S,U),M(L,S,y),L})}function Wf(n,t,e,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=t==0?$f:mg,c=e;for(let h=0;h<n.length;h++){let f=n[h];if(f[1]>f[0]){let d=f[0]-c;d>0&&a(o,c,i,d,i+r),c=f[1]}}let l=e+s-c,u=10;l>0&&a(o,c,i-u/2,l,i+r+u)}return o}function nP(n,t,e){let i=n[n.length-1];i&&i[0]==t?i[1]=e:n.push([t,e])}function pg(n,t,e,i,s,r,o){let a=[],c=n.length;for(let l=s==1?e:i;l>=e&&l<=i;l+=s)if(t[l]===null){let h=l,f=l;if(s==1)for(;++l<=i&&t[l]===null;)f=l;else for(;--l>=e&&t[l]===null;)f=l;let d=r(n[h]),g=f==h?d:r(n[f]),_=h-s;d=o<=0&&_>=0&&_<c?r(n[_]):d;let m=f+s;g=o>=0&&m>=0&&m<c?r(n[m]):g,g>=d&&a.push([d,g])}return a}function Mv(n){return n==0?Lv:n==1?Fn:t=>wo(t,n)}function nb(n){let t=n==0?qf:Xf,e=n==0?(s,r,o,a,c,l)=>{s.arcTo(r,o,a,c,l)}:(s,r,o,a,c,l)=>{s.arcTo(o,r,c,a,l)},i=n==0?(s,r,o,a,c)=>{s.rect(r,o,a,c)}:(s,r,o,a,c)=>{s.rect(o,r,c,a)};return(s,r,o,a,c,l=0,u=0)=>{l==0&&u==0?i(s,r,o,a,c):(l=ys(l,a/2,c/2),u=ys(u,a/2,c/2),t(s,r+l,o),e(s,r+a,o,r+a,o+c,l),e(s,r+a,o+c,r,o+c,u),e(s,r,o+c,r,o,u),e(s,r,o,r+a,o,l),s.closePath())}}var qf=(n,t,e)=>{n.moveTo(t,e)},Xf=(n,t,e)=>{n.moveTo(e,t)},qa=(n,t,e)=>{n.lineTo(t,e)},Xa=(n,t,e)=>{n.lineTo(e,t)},$f=nb(0),mg=nb(1),ib=(n,t,e,i,s,r)=>{n.arc(t,e,i,s,r)},sb=(n,t,e,i,s,r)=>{n.arc(e,t,i,s,r)},rb=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(t,e,i,s,r,o)},ob=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(e,t,s,i,o,r)};function ab(n){return(t,e,i,s,r)=>Co(t,e,(o,a,c,l,u,h,f,d,g,_,p)=>{let{pxRound:m,points:x}=o,M,v;l.ori==0?(M=qf,v=ib):(M=Xf,v=sb);let A=Je(x.width*Fe,3),S=(x.size-x.width)/2*Fe,y=Je(S*2,3),w=new Path2D,U=new Path2D,{left:L,top:N,width:z,height:W}=t.bbox;$f(U,L-y,N-y,z+y*2,W+y*2);let O=X=>{if(c[X]!=null){let Z=m(h(a[X],l,_,d)),q=m(f(c[X],u,p,g));M(w,Z+S,q),v(w,Z,q,S,0,Ff*2)}};if(r)r.forEach(O);else for(let X=i;X<=s;X++)O(X);return{stroke:A>0?w:null,fill:w,clip:U,flags:Va|Qm}})}function lb(n){return(t,e,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(t,e,i),r!=s&&o!=s&&n(t,e,s),n(t,e,o))}}var iP=lb(qa),sP=lb(Xa);function cb(n){let t=Ie(n?.alignGaps,0);return(e,i,s,r)=>Co(e,i,(o,a,c,l,u,h,f,d,g,_,p)=>{[s,r]=zf(c,s,r);let m=o.pxRound,x=W=>m(h(W,l,_,d)),M=W=>m(f(W,u,p,g)),v,A;l.ori==0?(v=qa,A=iP):(v=Xa,A=sP);let S=l.dir*(l.ori==0?1:-1),y={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Va},w=y.stroke,U=!1;if(r-s>=_*4){let W=ft=>e.posToVal(ft,l.key,!0),O=null,X=null,Z,q,ut,j=x(a[S==1?s:r]),tt=x(a[s]),rt=x(a[r]),dt=W(S==1?tt+1:rt-1);for(let ft=S==1?s:r;ft>=s&&ft<=r;ft+=S){let et=a[ft],bt=(S==1?et<dt:et>dt)?j:x(et),Pt=c[ft];bt==j?Pt!=null?(q=Pt,O==null?(v(w,bt,M(q)),Z=O=X=q):q<O?O=q:q>X&&(X=q)):Pt===null&&(U=!0):(O!=null&&A(w,j,M(O),M(X),M(Z),M(q)),Pt!=null?(q=Pt,v(w,bt,M(q)),O=X=Z=q):(O=X=null,Pt===null&&(U=!0)),j=bt,dt=W(j+S))}O!=null&&O!=X&&ut!=j&&A(w,j,M(O),M(X),M(Z),M(q))}else for(let W=S==1?s:r;W>=s&&W<=r;W+=S){let O=c[W];O===null?U=!0:O!=null&&v(w,x(a[W]),M(O))}let[N,z]=dg(e,i);if(o.fill!=null||N!=0){let W=y.fill=new Path2D(w),O=o.fillTo(e,i,o.min,o.max,N),X=M(O),Z=x(a[s]),q=x(a[r]);S==-1&&([q,Z]=[Z,q]),v(W,q,X),v(W,Z,X)}if(!o.spanGaps){let W=[];U&&W.push(...pg(a,c,s,r,S,x,t)),y.gaps=W=o.gaps(e,i,s,r,W),y.clip=Wf(W,l.ori,d,g,_,p)}return z!=0&&(y.band=z==2?[pr(e,i,s,r,w,-1),pr(e,i,s,r,w,1)]:pr(e,i,s,r,w,z)),y})}function rP(n){let t=Ie(n.align,1),e=Ie(n.ascDesc,!1),i=Ie(n.alignGaps,0),s=Ie(n.extend,!1);return(r,o,a,c)=>Co(r,o,(l,u,h,f,d,g,_,p,m,x,M)=>{[a,c]=zf(h,a,c);let v=l.pxRound,{left:A,width:S}=r.bbox,y=tt=>v(g(tt,f,x,p)),w=tt=>v(_(tt,d,M,m)),U=f.ori==0?qa:Xa,L={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Va},N=L.stroke,z=f.dir*(f.ori==0?1:-1),W=w(h[z==1?a:c]),O=y(u[z==1?a:c]),X=O,Z=O;s&&t==-1&&(Z=A,U(N,Z,W)),U(N,O,W);for(let tt=z==1?a:c;tt>=a&&tt<=c;tt+=z){let rt=h[tt];if(rt==null)continue;let dt=y(u[tt]),ft=w(rt);t==1?U(N,dt,W):U(N,X,ft),U(N,dt,ft),W=ft,X=dt}let q=X;s&&t==1&&(q=A+S,U(N,q,W));let[ut,j]=dg(r,o);if(l.fill!=null||ut!=0){let tt=L.fill=new Path2D(N),rt=l.fillTo(r,o,l.min,l.max,ut),dt=w(rt);U(tt,q,dt),U(tt,Z,dt)}if(!l.spanGaps){let tt=[];tt.push(...pg(u,h,a,c,z,y,i));let rt=l.width*Fe/2,dt=e||t==1?rt:-rt,ft=e||t==-1?-rt:rt;tt.forEach(et=>{et[0]+=dt,et[1]+=ft}),L.gaps=tt=l.gaps(r,o,a,c,tt),L.clip=Wf(tt,f.ori,p,m,x,M)}return j!=0&&(L.band=j==2?[pr(r,o,a,c,N,-1),pr(r,o,a,c,N,1)]:pr(r,o,a,c,N,j)),L})}function Sv(n,t,e,i,s,r,o=Ze){if(n.length>1){let a=null;for(let c=0,l=1/0;c<n.length;c++)if(t[c]!==void 0){if(a!=null){let u=On(n[c]-n[a]);u<l&&(l=u,o=On(e(n[c],i,s,r)-e(n[a],i,s,r)))}a=c}}return o}function oP(n){n=n||Rc;let t=Ie(n.size,[.6,Ze,1]),e=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=Ae(s),o=1-t[0],a=Ie(t[1],Ze),c=Ie(t[2],1),l=Ie(n.disp,Rc),u=Ie(n.each,d=>{}),{fill:h,stroke:f}=l;return(d,g,_,p)=>Co(d,g,(m,x,M,v,A,S,y,w,U,L,N)=>{let z=m.pxRound,W=e,O=i*Fe,X=a*Fe,Z=c*Fe,q,ut;v.ori==0?[q,ut]=r(d,g):[ut,q]=r(d,g);let j=v.dir*(v.ori==0?1:-1),tt=v.ori==0?$f:mg,rt=v.ori==0?u:(Lt,Qt,he,Tt,Xe,Xt,Kt)=>{u(Lt,Qt,he,Xe,Tt,Kt,Xt)},dt=Ie(d.bands,lg).find(Lt=>Lt.series[0]==g),ft=dt!=null?dt.dir:0,et=m.fillTo(d,g,m.min,m.max,ft),_t=z(y(et,A,N,U)),bt,Pt,Et,Zt=L,ue=z(m.width*Fe),$t=!1,xe=null,me=null,le=null,an=null;h!=null&&(ue==0||f!=null)&&($t=!0,xe=h.values(d,g,_,p),me=new Map,new Set(xe).forEach(Lt=>{Lt!=null&&me.set(Lt,new Path2D)}),ue>0&&(le=f.values(d,g,_,p),an=new Map,new Set(le).forEach(Lt=>{Lt!=null&&an.set(Lt,new Path2D)})));let{x0:Ke,size:Mn}=l;if(Ke!=null&&Mn!=null){W=1,x=Ke.values(d,g,_,p),Ke.unit==2&&(x=x.map(he=>d.posToVal(w+he*L,v.key,!0)));let Lt=Mn.values(d,g,_,p);Mn.unit==2?Pt=Lt[0]*L:Pt=S(Lt[0],v,L,w)-S(0,v,L,w),Zt=Sv(x,M,S,v,L,w,Zt),Et=Zt-Pt+O}else Zt=Sv(x,M,S,v,L,w,Zt),Et=Zt*o+O,Pt=Zt-Et;Et<1&&(Et=0),ue>=Pt/2&&(ue=0),Et<5&&(z=Lv);let Ve=Et>0,kn=Zt-Et-(Ve?ue:0);Pt=z(Jm(kn,Z,X)),bt=(W==0?Pt/2:W==j?0:Pt)-W*j*((W==0?O/2:0)+(Ve?ue/2:0));let Re={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},In=$t?null:new Path2D,fn=null;if(dt!=null)fn=d.data[dt.series[1]];else{let{y0:Lt,y1:Qt}=l;Lt!=null&&Qt!=null&&(M=Qt.values(d,g,_,p),fn=Lt.values(d,g,_,p))}let Sn=q*Pt,k=ut*Pt;for(let Lt=j==1?_:p;Lt>=_&&Lt<=p;Lt+=j){let Qt=M[Lt];if(Qt==null)continue;if(fn!=null){let $=fn[Lt]??0;if(Qt-$==0)continue;_t=y($,A,N,U)}let he=v.distr!=2||l!=null?x[Lt]:Lt,Tt=S(he,v,L,w),Xe=y(Ie(Qt,et),A,N,U),Xt=z(Tt-bt),Kt=z(yi(Xe,_t)),I=z(ys(Xe,_t)),T=Kt-I;if(Qt!=null){let $=Qt<0?k:Sn,ht=Qt<0?Sn:k;$t?(ue>0&&le[Lt]!=null&&tt(an.get(le[Lt]),Xt,I+Hi(ue/2),Pt,yi(0,T-ue),$,ht),xe[Lt]!=null&&tt(me.get(xe[Lt]),Xt,I+Hi(ue/2),Pt,yi(0,T-ue),$,ht)):tt(In,Xt,I+Hi(ue/2),Pt,yi(0,T-ue),$,ht),rt(d,g,Lt,Xt-ue/2,I,Pt+ue,T)}}return ue>0?Re.stroke=$t?an:In:$t||(Re._fill=m.width==0?m._fill:m._stroke??m._fill,Re.width=0),Re.fill=$t?me:In,Re})}function aP(n,t){let e=Ie(t?.alignGaps,0);return(i,s,r,o)=>Co(i,s,(a,c,l,u,h,f,d,g,_,p,m)=>{[r,o]=zf(l,r,o);let x=a.pxRound,M=q=>x(f(q,u,p,g)),v=q=>x(d(q,h,m,_)),A,S,y;u.ori==0?(A=qf,y=qa,S=rb):(A=Xf,y=Xa,S=ob);let w=u.dir*(u.ori==0?1:-1),U=M(c[w==1?r:o]),L=U,N=[],z=[];for(let q=w==1?r:o;q>=r&&q<=o;q+=w)if(l[q]!=null){let j=c[q],tt=M(j);N.push(L=tt),z.push(v(l[q]))}let W={stroke:n(N,z,A,y,S,x),fill:null,clip:null,band:null,gaps:null,flags:Va},O=W.stroke,[X,Z]=dg(i,s);if(a.fill!=null||X!=0){let q=W.fill=new Path2D(O),ut=a.fillTo(i,s,a.min,a.max,X),j=v(ut);y(q,L,j),y(q,U,j)}if(!a.spanGaps){let q=[];q.push(...pg(c,l,r,o,w,M,e)),W.gaps=q=a.gaps(i,s,r,o,q),W.clip=Wf(q,u.ori,g,_,p,m)}return Z!=0&&(W.band=Z==2?[pr(i,s,r,o,O,-1),pr(i,s,r,o,O,1)]:pr(i,s,r,o,O,Z)),W})}function lP(n){return aP(cP,n)}function cP(n,t,e,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(e(a,n[0],t[0]),o==2)i(a,n[1],t[1]);else{let c=Array(o),l=Array(o-1),u=Array(o-1),h=Array(o-1);for(let f=0;f<o-1;f++)u[f]=t[f+1]-t[f],h[f]=n[f+1]-n[f],l[f]=u[f]/h[f];c[0]=l[0];for(let f=1;f<o-1;f++)l[f]===0||l[f-1]===0||l[f-1]>0!=l[f]>0?c[f]=0:(c[f]=3*(h[f-1]+h[f])/((2*h[f]+h[f-1])/l[f-1]+(h[f]+2*h[f-1])/l[f]),isFinite(c[f])||(c[f]=0));c[o-1]=l[o-2];for(let f=0;f<o-1;f++)s(a,n[f]+h[f]/3,t[f]+c[f]*h[f]/3,n[f+1]-h[f]/3,t[f+1]-c[f+1]*h[f]/3,n[f+1],t[f+1])}return a}var tg=new Set;function wv(){for(let n of tg)n.syncRect(!0)}Wa&&(Ao(VR,ka,wv),Ao(WR,ka,wv,!0),Ao(Of,ka,()=>{Jn.pxRatio=Fe}));var uP=cb(),hP=ab();function Ev(n,t,e,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>eg(r,o,t,e))}function fP(n,t){return n.map((e,i)=>i==0?{}:Pn({},t,e))}function eg(n,t,e,i){return Pn({},t==0?e:i,n)}function ub(n,t,e){return t==null?Ha:[t,e]}var dP=ub;function pP(n,t,e){return t==null?Ha:Bf(t,e,og,!0)}function hb(n,t,e,i){return t==null?Ha:Hf(t,e,n.scales[i].log,!1)}var mP=hb;function fb(n,t,e,i){return t==null?Ha:rg(t,e,n.scales[i].log,!1)}var gP=fb;function _P(n,t,e,i,s){let r=yi(iv(n),iv(t)),o=t-n,a=xs(s/i*o,e);do{let c=e[a],l=i*c/o;if(l>=s&&r+(c<5?Yr.get(c):0)<=17)return[c,l]}while(++a<e.length);return[0,0]}function Tv(n){let t,e;return n=n.replace(/(\d+)px/,(i,s)=>(t=Fn((e=+s)*Fe))+"px"),[n,t,e]}function xP(n){n.show&&[n.font,n.labelFont].forEach(t=>{let e=Je(t[2]*Fe,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function Jn(n,t,e){let i={mode:Ie(n.mode,1)},s=i.mode;function r(b,R,D,F){let V=R.valToPct(b);return F+D*(R.dir==-1?1-V:V)}function o(b,R,D,F){let V=R.valToPct(b);return F+D*(R.dir==-1?V:1-V)}function a(b,R,D,F){return R.ori==0?r(b,R,D,F):o(b,R,D,F)}i.valToPosH=r,i.valToPosV=o;let c=!1;i.status=0;let l=i.root=Qi(ER);if(n.id!=null&&(l.id=n.id),zi(l,n.class),n.title){let b=Qi(RR,l);b.textContent=n.title}let u=_s("canvas"),h=i.ctx=u.getContext("2d"),f=Qi(CR,l);Ao("click",f,b=>{b.target===g&&(Qe!=Bo||ln!=ko)&&$n.click(i,b)},!0);let d=i.under=Qi(PR,f);f.appendChild(u);let g=i.over=Qi(IR,f);n=Ga(n);let _=+Ie(n.pxAlign,1),p=Mv(_);(n.plugins||[]).forEach(b=>{b.opts&&(n=b.opts(i,n)||n)});let m=n.ms||.001,x=i.series=s==1?Ev(n.series||[],mv,vv,!1):fP(n.series||[null],yv),M=i.axes=Ev(n.axes||[],pv,_v,!0),v=i.scales={},A=i.bands=n.bands||[];A.forEach(b=>{b.fill=Ae(b.fill||null),b.dir=Ie(b.dir,-1)});let S=s==2?x[1].facets[0].scale:x[0].scale,y={axes:Vs,series:Me},w=(n.drawOrder||["axes","series"]).map(b=>y[b]);function U(b){let R=b.distr==3?D=>dr(D>0?D:b.clamp(i,D,b.min,b.max,b.key)):b.distr==4?D=>Gm(D,b.asinh):b.distr==100?D=>b.fwd(D):D=>D;return D=>{let F=R(D),{_min:V,_max:K}=b,lt=K-V;return(F-V)/lt}}function L(b){let R=v[b];if(R==null){let D=(n.scales||Rc)[b]||Rc;if(D.from!=null){L(D.from);let F=Pn({},v[D.from],D,{key:b});F.valToPct=U(F),v[b]=F}else{R=v[b]=Pn({},b==S?tb:tP,D),R.key=b;let F=R.time,V=R.range,K=$r(V);if((b!=S||s==2&&!F)&&(K&&(V[0]==null||V[1]==null)&&(V={min:V[0]==null?tv:{mode:1,hard:V[0],soft:V[0]},max:V[1]==null?tv:{mode:1,hard:V[1],soft:V[1]}},K=!1),!K&&Vf(V))){let lt=V;V=(pt,St,Bt)=>St==null?Ha:Bf(St,Bt,lt)}R.range=Ae(V||(F?dP:b==S?R.distr==3?mP:R.distr==4?gP:ub:R.distr==3?hb:R.distr==4?fb:pP)),R.auto=Ae(K?!1:R.auto),R.clamp=Ae(R.clamp||QC),R._min=R._max=null,R.valToPct=U(R)}}}L("x"),L("y"),s==1&&x.forEach(b=>{L(b.scale)}),M.forEach(b=>{L(b.scale)});for(let b in n.scales)L(b);let N=v[S],z=N.distr,W,O;N.ori==0?(zi(l,TR),W=r,O=o):(zi(l,AR),W=o,O=r);let X={};for(let b in v){let R=v[b];(R.min!=null||R.max!=null)&&(X[b]={min:R.min,max:R.max},R.min=R.max=null)}let Z=n.tzDate||(b=>new Date(Fn(b/m))),q=n.fmtDate||cg,ut=m==1?TC(Z):CC(Z),j=hv(Z,uv(m==1?EC:RC,q)),tt=dv(Z,fv(IC,q)),rt=[],dt=i.legend=Pn({},NC,n.legend),ft=i.cursor=Pn({},zC,{drag:{y:s==2}},n.cursor),et=dt.show,_t=ft.show,bt=dt.markers;dt.idxs=rt,bt.width=Ae(bt.width),bt.dash=Ae(bt.dash),bt.stroke=Ae(bt.stroke),bt.fill=Ae(bt.fill);let Pt,Et,Zt,ue=[],$t=[],xe,me=!1,le={};if(dt.live){let b=x[1]?x[1].values:null;me=b!=null,xe=me?b(i,1,0):{_:0};for(let R in xe)le[R]=ig}if(et)if(Pt=_s("table",OR,l),Zt=_s("tbody",null,Pt),dt.mount(i,Pt),me){Et=_s("thead",null,Pt,Zt);let b=_s("tr",null,Et);_s("th",null,b);for(var an in xe)_s("th",Hy,b).textContent=an}else zi(Pt,kR),dt.live&&zi(Pt,BR);let Ke={show:!0},Mn={show:!1};function Ve(b,R){if(R==0&&(me||!dt.live||s==2))return Ha;let D=[],F=_s("tr",zR,Zt,Zt.childNodes[R]);zi(F,b.class),b.show||zi(F,To);let V=_s("th",null,F);if(bt.show){let pt=Qi(HR,V);if(R>0){let St=bt.width(i,R);St&&(pt.style.border=St+"px "+bt.dash(i,R)+" "+bt.stroke(i,R)),pt.style.background=bt.fill(i,R)}}let K=Qi(Hy,V);b.label instanceof HTMLElement?K.appendChild(b.label):K.textContent=b.label,R>0&&(bt.show||(K.style.color=b.width>0?bt.stroke(i,R):bt.fill(i,R)),Re("click",V,pt=>{if(ft._lock)return;se(pt);let St=x.indexOf(b);if((pt.ctrlKey||pt.metaKey)!=dt.isolate){let Bt=x.some((kt,Ht)=>Ht>0&&Ht!=St&&kt.show);x.forEach((kt,Ht)=>{Ht>0&&Ss(Ht,Bt?Ht==St?Ke:Mn:Ke,!0,An.setSeries)})}else Ss(St,{show:!b.show},!0,An.setSeries)},!1),re&&Re(qy,V,pt=>{ft._lock||(se(pt),Ss(x.indexOf(b),Ho,!0,An.setSeries))},!1));for(var lt in xe){let pt=_s("td",GR,F);pt.textContent="--",D.push(pt)}return[F,D]}let kn=new Map;function Re(b,R,D,F=!0){let V=kn.get(R)||{},K=ft.bind[b](i,R,D,F);K&&(Ao(b,R,V[b]=K),kn.set(R,V))}function In(b,R,D){let F=kn.get(R)||{};for(let V in F)(b==null||V==b)&&(Zm(V,R,F[V]),delete F[V]);b==null&&kn.delete(R)}let fn=0,Sn=0,k=0,Lt=0,Qt=0,he=0,Tt=Qt,Xe=he,Xt=k,Kt=Lt,I=0,T=0,$=0,ht=0;i.bbox={};let at=!1,vt=!1,Mt=!1,nt=!1,st=!1,mt=!1;function B(b,R,D){(D||b!=i.width||R!=i.height)&&ot(b,R),ge(!1),Mt=!0,vt=!0,Kn()}function ot(b,R){i.width=fn=k=b,i.height=Sn=Lt=R,Qt=he=0,wt(),Yt();let D=i.bbox;I=D.left=wo(Qt*Fe,.5),T=D.top=wo(he*Fe,.5),$=D.width=wo(k*Fe,.5),ht=D.height=wo(Lt*Fe,.5)}let it=3;function At(){let b=!1,R=0;for(;!b;){R++;let D=Uo(R),F=Ms(R);b=R==it||D&&F,b||(ot(i.width,i.height),vt=!0)}}function xt({width:b,height:R}){B(b,R)}i.setSize=xt;function wt(){let b=!1,R=!1,D=!1,F=!1;M.forEach((V,K)=>{if(V.show&&V._show){let{side:lt,_size:pt}=V,St=lt%2,Bt=V.label!=null?V.labelSize:0,kt=pt+Bt;kt>0&&(St?(k-=kt,lt==3?(Qt+=kt,F=!0):D=!0):(Lt-=kt,lt==0?(he+=kt,b=!0):R=!0))}}),vs[0]=b,vs[1]=D,vs[2]=R,vs[3]=F,k-=ns[1]+ns[3],Qt+=ns[3],Lt-=ns[2]+ns[0],he+=ns[0]}function Yt(){let b=Qt+k,R=he+Lt,D=Qt,F=he;function V(K,lt){switch(K){case 1:return b+=lt,b-lt;case 2:return R+=lt,R-lt;case 3:return D-=lt,D+lt;case 0:return F-=lt,F+lt}}M.forEach((K,lt)=>{if(K.show&&K._show){let pt=K.side;K._pos=V(pt,K._size),K.label!=null&&(K._lpos=V(pt,K.labelSize))}})}if(ft.dataIdx==null){let b=ft.hover,R=b.skip=new Set(b.skip??[]);R.add(void 0);let D=b.prox=Ae(b.prox),F=b.bias??=0;ft.dataIdx=(V,K,lt,pt)=>{if(K==0)return lt;let St=lt,Bt=D(V,K,lt,pt)??Ze,kt=Bt>=0&&Bt<Ze,Ht=N.ori==0?k:Lt,ce=ft.left,Le=t[0],Pe=t[K];if(R.has(Pe[lt])){St=null;let Se=null,ne=null,Jt;if(F==0||F==-1)for(Jt=lt;Se==null&&Jt-- >0;)R.has(Pe[Jt])||(Se=Jt);if(F==0||F==1)for(Jt=lt;ne==null&&Jt++<Pe.length;)R.has(Pe[Jt])||(ne=Jt);if(Se!=null||ne!=null)if(kt){let en=Se==null?-1/0:W(Le[Se],N,Ht,0),mn=ne==null?1/0:W(Le[ne],N,Ht,0),Vn=ce-en,We=mn-ce;Vn<=We?Vn<=Bt&&(St=Se):We<=Bt&&(St=ne)}else St=ne==null?Se:Se==null?ne:lt-Se<=ne-lt?Se:ne}else kt&&On(ce-W(Le[lt],N,Ht,0))>Bt&&(St=null);return St}}let se=b=>{ft.event=b};ft.idxs=rt,ft._lock=!1;let ct=ft.points;ct.show=Ae(ct.show),ct.size=Ae(ct.size),ct.stroke=Ae(ct.stroke),ct.width=Ae(ct.width),ct.fill=Ae(ct.fill);let Gt=i.focus=Pn({},n.focus||{alpha:.3},ft.focus),re=Gt.prox>=0,It=re&&ct.one,fe=[],je=[],si=[];function Ka(b,R){let D=ct.show(i,R);if(D instanceof HTMLElement)return zi(D,FR),zi(D,b.class),ks(D,-10,-10,k,Lt),g.insertBefore(D,fe[R]),D}function Lo(b,R){if(s==1||R>0){let D=s==1&&v[b.scale].time,F=b.value;b.value=D?ov(F)?dv(Z,fv(F,q)):F||tt:F||JC,b.label=b.label||(D?GC:HC)}if(It||R>0){b.width=b.width==null?1:b.width,b.paths=b.paths||uP||tC,b.fillTo=Ae(b.fillTo||eP),b.pxAlign=+Ie(b.pxAlign,_),b.pxRound=Mv(b.pxAlign),b.stroke=Ae(b.stroke||null),b.fill=Ae(b.fill||null),b._stroke=b._fill=b._paths=b._focus=null;let D=KC(yi(1,b.width),1),F=b.points=Pn({},{size:D,width:yi(1,D*.2),stroke:b.stroke,space:D*2,paths:hP,_stroke:null,_fill:null},b.points);F.show=Ae(F.show),F.filter=Ae(F.filter),F.fill=Ae(F.fill),F.stroke=Ae(F.stroke),F.paths=Ae(F.paths),F.pxAlign=b.pxAlign}if(et){let D=Ve(b,R);ue.splice(R,0,D[0]),$t.splice(R,0,D[1]),dt.values.push(null)}if(_t){rt.splice(R,0,null);let D=null;It?R==0&&(D=Ka(b,R)):R>0&&(D=Ka(b,R)),fe.splice(R,0,D),je.splice(R,0,0),si.splice(R,0,0)}Gn("addSeries",R)}function dd(b,R){R=R??x.length,b=s==1?eg(b,R,mv,vv):eg(b,R,{},yv),x.splice(R,0,b),Lo(x[R],R)}i.addSeries=dd;function Lc(b){if(x.splice(b,1),et){dt.values.splice(b,1),$t.splice(b,1);let R=ue.splice(b,1)[0];In(null,R.firstChild),R.remove()}_t&&(rt.splice(b,1),fe.splice(b,1)[0].remove(),je.splice(b,1),si.splice(b,1)),Gn("delSeries",b)}i.delSeries=Lc;let vs=[!1,!1,!1,!1];function zs(b,R){if(b._show=b.show,b.show){let D=b.side%2,F=v[b.scale];F==null&&(b.scale=D?x[1].scale:S,F=v[b.scale]);let V=F.time;b.size=Ae(b.size),b.space=Ae(b.space),b.rotate=Ae(b.rotate),$r(b.incrs)&&b.incrs.forEach(lt=>{!Yr.has(lt)&&Yr.set(lt,Uv(lt))}),b.incrs=Ae(b.incrs||(F.distr==2?MC:V?m==1?wC:AC:Eo)),b.splits=Ae(b.splits||(V&&F.distr==1?ut:F.distr==3?Km:F.distr==4?qC:WC)),b.stroke=Ae(b.stroke),b.grid.stroke=Ae(b.grid.stroke),b.ticks.stroke=Ae(b.ticks.stroke),b.border.stroke=Ae(b.border.stroke);let K=b.values;b.values=$r(K)&&!$r(K[0])?Ae(K):V?$r(K)?hv(Z,uv(K,q)):ov(K)?PC(Z,K):K||j:K||VC,b.filter=Ae(b.filter||(F.distr>=3&&F.log==10?YC:F.distr==3&&F.log==2?ZC:Dv)),b.font=Tv(b.font),b.labelFont=Tv(b.labelFont),b._size=b.size(i,null,R,0),b._space=b._rotate=b._incrs=b._found=b._splits=b._values=null,b._size>0&&(vs[R]=!0,b._el=Qi(LR,f))}}function Hs(b,R,D,F){let[V,K,lt,pt]=D,St=R%2,Bt=0;return St==0&&(pt||K)&&(Bt=R==0&&!V||R==2&&!lt?Fn(pv.size/3):0),St==1&&(V||lt)&&(Bt=R==1&&!K||R==3&&!pt?Fn(_v.size/2):0),Bt}let ja=i.padding=(n.padding||[Hs,Hs,Hs,Hs]).map(b=>Ae(Ie(b,Hs))),ns=i._padding=ja.map((b,R)=>b(i,R,vs,0)),dn,vn=null,bn=null,bs=s==1?x[0].idxs:null,Ci=null,mr=!1;function Qa(b,R){if(t=b??[],i.data=i._data=t,s==2){dn=0;for(let D=1;D<x.length;D++)dn+=t[D][0].length}else{t.length==0&&(i.data=i._data=t=[[]]),Ci=t[0],dn=Ci.length;let D=t;if(z==2){D=t.slice();let F=D[0]=Array(dn);for(let V=0;V<dn;V++)F[V]=V}i._data=t=D}if(ge(!0),Gn("setData"),z==2&&(Mt=!0),R!==!1){let D=N;D.auto(i,mr)?tl():xr(S,D.min,D.max),nt=nt||ft.left>=0,mt=!0,Kn()}}i.setData=Qa;function tl(){mr=!0;let b,R;s==1&&(dn>0?(vn=bs[0]=0,bn=bs[1]=dn-1,b=t[0][vn],R=t[0][bn],z==2?(b=vn,R=bn):b==R&&(z==3?[b,R]=Hf(b,b,N.log,!1):z==4?[b,R]=rg(b,b,N.log,!1):N.time?R=b+Fn(86400/m):[b,R]=Bf(b,R,og,!0))):(vn=bs[0]=b=null,bn=bs[1]=R=null)),xr(S,b,R)}let Do,gr,No,C,G,Q,Y,J,Rt,Nt;function Ct(b,R,D,F,V,K){b??=Vy,D??=lg,F??="butt",V??=Vy,K??="round",b!=Do&&(h.strokeStyle=Do=b),V!=gr&&(h.fillStyle=gr=V),R!=No&&(h.lineWidth=No=R),K!=G&&(h.lineJoin=G=K),F!=Q&&(h.lineCap=Q=F),D!=C&&h.setLineDash(C=D)}function Ft(b,R,D,F){R!=gr&&(h.fillStyle=gr=R),b!=Y&&(h.font=Y=b),D!=J&&(h.textAlign=J=D),F!=Rt&&(h.textBaseline=Rt=F)}function Wt(b,R,D,F,V=0){if(F.length>0&&b.auto(i,mr)&&(R==null||R.min==null)){let K=Ie(vn,0),lt=Ie(bn,F.length-1),pt=D.min==null?YR(F,K,lt,V,b.distr==3):[D.min,D.max];b.min=ys(b.min,D.min=pt[0]),b.max=yi(b.max,D.max=pt[1])}}let oe={min:null,max:null};function be(){for(let F in v){let V=v[F];X[F]==null&&(V.min==null||X[S]!=null&&V.auto(i,mr))&&(X[F]=oe)}for(let F in v){let V=v[F];X[F]==null&&V.from!=null&&X[V.from]!=null&&(X[F]=oe)}X[S]!=null&&ge(!0);let b={};for(let F in X){let V=X[F];if(V!=null){let K=b[F]=Ga(v[F],iC);if(V.min!=null)Pn(K,V);else if(F!=S||s==2)if(dn==0&&K.from==null){let lt=K.range(i,null,null,F);K.min=lt[0],K.max=lt[1]}else K.min=Ze,K.max=-Ze}}if(dn>0){x.forEach((F,V)=>{if(s==1){let K=F.scale,lt=X[K];if(lt==null)return;let pt=b[K];if(V==0){let St=pt.range(i,pt.min,pt.max,K);pt.min=St[0],pt.max=St[1],vn=xs(pt.min,t[0]),bn=xs(pt.max,t[0]),bn-vn>1&&(t[0][vn]<pt.min&&vn++,t[0][bn]>pt.max&&bn--),F.min=Ci[vn],F.max=Ci[bn]}else F.show&&F.auto&&Wt(pt,lt,F,t[V],F.sorted);F.idxs[0]=vn,F.idxs[1]=bn}else if(V>0&&F.show&&F.auto){let[K,lt]=F.facets,pt=K.scale,St=lt.scale,[Bt,kt]=t[V],Ht=b[pt],ce=b[St];Ht!=null&&Wt(Ht,X[pt],K,Bt,K.sorted),ce!=null&&Wt(ce,X[St],lt,kt,lt.sorted),F.min=lt.min,F.max=lt.max}});for(let F in b){let V=b[F],K=X[F];if(V.from==null&&(K==null||K.min==null)){let lt=V.range(i,V.min==Ze?null:V.min,V.max==-Ze?null:V.max,F);V.min=lt[0],V.max=lt[1]}}}for(let F in b){let V=b[F];if(V.from!=null){let K=b[V.from];if(K.min==null)V.min=V.max=null;else{let lt=V.range(i,K.min,K.max,F);V.min=lt[0],V.max=lt[1]}}}let R={},D=!1;for(let F in b){let V=b[F],K=v[F];if(K.min!=V.min||K.max!=V.max){K.min=V.min,K.max=V.max;let lt=K.distr;K._min=lt==3?dr(K.min):lt==4?Gm(K.min,K.asinh):lt==100?K.fwd(K.min):K.min,K._max=lt==3?dr(K.max):lt==4?Gm(K.max,K.asinh):lt==100?K.fwd(K.max):K.max,R[F]=D=!0}}if(D){x.forEach((F,V)=>{s==2?V>0&&R.y&&(F._paths=null):R[F.scale]&&(F._paths=null)});for(let F in R)Mt=!0,Gn("setScale",F);_t&&ft.left>=0&&(nt=mt=!0)}for(let F in X)X[F]=null}function Vt(b){let R=Jm(vn-1,0,dn-1),D=Jm(bn+1,0,dn-1);for(;b[R]==null&&R>0;)R--;for(;b[D]==null&&D<dn-1;)D++;return[R,D]}function Me(){if(dn>0){let b=x.some(R=>R._focus)&&Nt!=Gt.alpha;b&&(h.globalAlpha=Nt=Gt.alpha),x.forEach((R,D)=>{if(D>0&&R.show&&(cn(D,!1),cn(D,!0),R._paths==null)){let F=Nt;Nt!=R.alpha&&(h.globalAlpha=Nt=R.alpha);let V=s==2?[0,t[D][0].length-1]:Vt(t[D]);R._paths=R.paths(i,D,V[0],V[1]),Nt!=F&&(h.globalAlpha=Nt=F)}}),x.forEach((R,D)=>{if(D>0&&R.show){let F=Nt;Nt!=R.alpha&&(h.globalAlpha=Nt=R.alpha),R._paths!=null&&ke(D,!1);{let V=R._paths!=null?R._paths.gaps:null,K=R.points.show(i,D,vn,bn,V),lt=R.points.filter(i,D,K,V);(K||lt)&&(R.points._paths=R.points.paths(i,D,vn,bn,lt),ke(D,!0))}Nt!=F&&(h.globalAlpha=Nt=F),Gn("drawSeries",D)}}),b&&(h.globalAlpha=Nt=1)}}function cn(b,R){let D=R?x[b].points:x[b];D._stroke=D.stroke(i,b),D._fill=D.fill(i,b)}function ke(b,R){let D=R?x[b].points:x[b],{stroke:F,fill:V,clip:K,flags:lt,_stroke:pt=D._stroke,_fill:St=D._fill,_width:Bt=D.width}=D._paths;Bt=Je(Bt*Fe,3);let kt=null,Ht=Bt%2/2;R&&St==null&&(St=Bt>0?"#fff":pt);let ce=D.pxAlign==1&&Ht>0;if(ce&&h.translate(Ht,Ht),!R){let Le=I-Bt/2,Pe=T-Bt/2,Se=$+Bt,ne=ht+Bt;kt=new Path2D,kt.rect(Le,Pe,Se,ne)}R?zt(pt,Bt,D.dash,D.cap,St,F,V,lt,K):ze(b,pt,Bt,D.dash,D.cap,St,F,V,lt,kt,K),ce&&h.translate(-Ht,-Ht)}function ze(b,R,D,F,V,K,lt,pt,St,Bt,kt){let Ht=!1;St!=0&&A.forEach((ce,Le)=>{if(ce.series[0]==b){let Pe=x[ce.series[1]],Se=t[ce.series[1]],ne=(Pe._paths||Rc).band;$r(ne)&&(ne=ce.dir==1?ne[0]:ne[1]);let Jt,en=null;Pe.show&&ne&&JR(Se,vn,bn)?(en=ce.fill(i,Le)||K,Jt=Pe._paths.clip):ne=null,zt(R,D,F,V,en,lt,pt,St,Bt,kt,Jt,ne),Ht=!0}}),Ht||zt(R,D,F,V,K,lt,pt,St,Bt,kt)}let Ln=Va|Qm;function zt(b,R,D,F,V,K,lt,pt,St,Bt,kt,Ht){Ct(b,R,D,F,V),(St||Bt||Ht)&&(h.save(),St&&h.clip(St),Bt&&h.clip(Bt)),Ht?(pt&Ln)==Ln?(h.clip(Ht),kt&&h.clip(kt),we(V,lt),wn(b,K,R)):pt&Qm?(we(V,lt),h.clip(Ht),wn(b,K,R)):pt&Va&&(h.save(),h.clip(Ht),kt&&h.clip(kt),we(V,lt),h.restore(),wn(b,K,R)):(we(V,lt),wn(b,K,R)),(St||Bt||Ht)&&h.restore()}function wn(b,R,D){D>0&&(R instanceof Map?R.forEach((F,V)=>{h.strokeStyle=Do=V,h.stroke(F)}):R!=null&&b&&h.stroke(R))}function we(b,R){R instanceof Map?R.forEach((D,F)=>{h.fillStyle=gr=F,h.fill(D)}):R!=null&&b&&h.fill(R)}function Gs(b,R,D,F){let V=M[b],K;if(F<=0)K=[0,0];else{let lt=V._space=V.space(i,b,R,D,F),pt=V._incrs=V.incrs(i,b,R,D,F,lt);K=_P(R,D,pt,F,lt)}return V._found=K}function En(b,R,D,F,V,K,lt,pt,St,Bt){let kt=lt%2/2;_==1&&h.translate(kt,kt),Ct(pt,lt,St,Bt,pt),h.beginPath();let Ht,ce,Le,Pe,Se=V+(F==0||F==3?-K:K);D==0?(ce=V,Pe=Se):(Ht=V,Le=Se);for(let ne=0;ne<b.length;ne++)R[ne]!=null&&(D==0?Ht=Le=b[ne]:ce=Pe=b[ne],h.moveTo(Ht,ce),h.lineTo(Le,Pe));h.stroke(),_==1&&h.translate(-kt,-kt)}function Uo(b){let R=!0;return M.forEach((D,F)=>{if(!D.show)return;let V=v[D.scale];if(V.min==null){D._show&&(R=!1,D._show=!1,ge(!1));return}else D._show||(R=!1,D._show=!0,ge(!1));let K=D.side,lt=K%2,{min:pt,max:St}=V,[Bt,kt]=Gs(F,pt,St,lt==0?k:Lt);if(kt==0)return;let Ht=V.distr==2,ce=D._splits=D.splits(i,F,pt,St,Bt,kt,Ht),Le=V.distr==2?ce.map(Jt=>Ci[Jt]):ce,Pe=V.distr==2?Ci[ce[1]]-Ci[ce[0]]:Bt,Se=D._values=D.values(i,D.filter(i,Le,F,kt,Pe),F,kt,Pe);D._rotate=K==2?D.rotate(i,Se,F,kt):0;let ne=D._size;D._size=ts(D.size(i,Se,F,b)),ne!=null&&D._size!=ne&&(R=!1)}),R}function Ms(b){let R=!0;return ja.forEach((D,F)=>{let V=D(i,F,vs,b);V!=ns[F]&&(R=!1),ns[F]=V}),R}function Vs(){for(let b=0;b<M.length;b++){let R=M[b];if(!R.show||!R._show)continue;let D=R.side,F=D%2,V,K,lt=R.stroke(i,b),pt=D==0||D==3?-1:1,[St,Bt]=R._found;if(R.label!=null){let ai=R.labelGap*pt,Li=Fn((R._lpos+ai)*Fe);Ft(R.labelFont[0],lt,"center",D==2?"top":Gy),h.save(),F==1?(V=K=0,h.translate(Li,Fn(T+ht/2)),h.rotate((D==3?-Ff:Ff)/2)):(V=Fn(I+$/2),K=Li);let jr=Iv(R.label)?R.label(i,b,St,Bt):R.label;h.fillText(jr,V,K),h.restore()}if(Bt==0)continue;let kt=v[R.scale],Ht=F==0?$:ht,ce=F==0?I:T,Le=R._splits,Pe=kt.distr==2?Le.map(ai=>Ci[ai]):Le,Se=kt.distr==2?Ci[Le[1]]-Ci[Le[0]]:St,ne=R.ticks,Jt=R.border,en=ne.show?ne.size:0,mn=Fn(en*Fe),Vn=Fn((R.alignTo==2?R._size-en-R.gap:R.gap)*Fe),We=R._rotate*-Ff/180,gn=p(R._pos*Fe),Pi=(mn+Vn)*pt,oi=gn+Pi;K=F==0?oi:0,V=F==1?oi:0;let Vi=R.font[0],is=R.align==1?Oa:R.align==2?km:We>0?Oa:We<0?km:F==0?"center":D==3?km:Oa,Es=We||F==1?"middle":D==2?"top":Gy;Ft(Vi,lt,is,Es);let Ii=R.font[1]*R.lineGap,Wi=Le.map(ai=>p(a(ai,kt,Ht,ce))),ss=R._values;for(let ai=0;ai<ss.length;ai++){let Li=ss[ai];if(Li!=null){F==0?V=Wi[ai]:K=Wi[ai],Li=""+Li;let jr=Li.indexOf(`
`)==-1?[Li]:Li.split(/\n/gm);for(let li=0;li<jr.length;li++){let Kg=jr[li];We?(h.save(),h.translate(V,K+li*Ii),h.rotate(We),h.fillText(Kg,0,0),h.restore()):h.fillText(Kg,V,K+li*Ii)}}}ne.show&&En(Wi,ne.filter(i,Pe,b,Bt,Se),F,D,gn,mn,Je(ne.width*Fe,3),ne.stroke(i,b),ne.dash,ne.cap);let Ts=R.grid;Ts.show&&En(Wi,Ts.filter(i,Pe,b,Bt,Se),F,F==0?2:1,F==0?T:I,F==0?ht:$,Je(Ts.width*Fe,3),Ts.stroke(i,b),Ts.dash,Ts.cap),Jt.show&&En([gn],[1],F==0?1:0,F==0?1:2,F==1?T:I,F==1?ht:$,Je(Jt.width*Fe,3),Jt.stroke(i,b),Jt.dash,Jt.cap)}Gn("drawAxes")}function ge(b){x.forEach((R,D)=>{D>0&&(R._paths=null,b&&(s==1?(R.min=null,R.max=null):R.facets.forEach(F=>{F.min=null,F.max=null})))})}let pn=!1,ri=!1,He=[];function Tn(){ri=!1;for(let b=0;b<He.length;b++)Gn(...He[b]);He.length=0}function Kn(){pn||(uC(Dg),pn=!0)}function Dc(b,R=!1){pn=!0,ri=R,b(i),Dg(),R&&He.length>0&&queueMicrotask(Tn)}i.batch=Dc;function Dg(){if(at&&(be(),at=!1),Mt&&(At(),Mt=!1),vt){if(rn(d,Oa,Qt),rn(d,"top",he),rn(d,wc,k),rn(d,Ec,Lt),rn(g,Oa,Qt),rn(g,"top",he),rn(g,wc,k),rn(g,Ec,Lt),rn(f,wc,fn),rn(f,Ec,Sn),u.width=Fn(fn*Fe),u.height=Fn(Sn*Fe),M.forEach(({_el:b,_show:R,_size:D,_pos:F,side:V})=>{if(b!=null)if(R){let K=V===3||V===0?D:0,lt=V%2==1;rn(b,lt?"left":"top",F-K),rn(b,lt?"width":"height",D),rn(b,lt?"top":"left",lt?he:Qt),rn(b,lt?"height":"width",lt?Lt:k),Ym(b,To)}else zi(b,To)}),Do=gr=No=G=Q=Y=J=Rt=C=null,Nt=1,il(!0),Qt!=Tt||he!=Xe||k!=Xt||Lt!=Kt){ge(!1);let b=k/Xt,R=Lt/Kt;if(_t&&!nt&&ft.left>=0){ft.left*=b,ft.top*=R,Fo&&ks(Fo,Fn(ft.left),0,k,Lt),Oo&&ks(Oo,0,Fn(ft.top),k,Lt);for(let D=0;D<fe.length;D++){let F=fe[D];F!=null&&(je[D]*=b,si[D]*=R,ks(F,ts(je[D]),ts(si[D]),k,Lt))}}if(tn.show&&!st&&tn.left>=0&&tn.width>0){tn.left*=b,tn.width*=b,tn.top*=R,tn.height*=R;for(let D in yd)rn(zo,D,tn[D])}Tt=Qt,Xe=he,Xt=k,Kt=Lt}Gn("setSize"),vt=!1}fn>0&&Sn>0&&(h.clearRect(0,0,u.width,u.height),Gn("drawClear"),w.forEach(b=>b()),Gn("draw")),tn.show&&st&&(Nc(tn),st=!1),_t&&nt&&(Kr(null,!0,!1),nt=!1),dt.show&&dt.live&&mt&&(_d(),mt=!1),c||(c=!0,i.status=1,Gn("ready")),mr=!1,pn=!1}i.redraw=(b,R)=>{Mt=R||!1,b!==!1?xr(S,N.min,N.max):Kn()};function pd(b,R){let D=v[b];if(D.from==null){if(dn==0){let F=D.range(i,R.min,R.max,b);R.min=F[0],R.max=F[1]}if(R.min>R.max){let F=R.min;R.min=R.max,R.max=F}if(dn>1&&R.min!=null&&R.max!=null&&R.max-R.min<1e-16)return;b==S&&D.distr==2&&dn>0&&(R.min=xs(R.min,t[0]),R.max=xs(R.max,t[0]),R.min==R.max&&R.max++),X[b]=R,at=!0,Kn()}}i.setScale=pd;let md,gd,Fo,Oo,Ng,Ug,Bo,ko,Fg,Og,Qe,ln,_r=!1,$n=ft.drag,zn=$n.x,Hn=$n.y;_t&&(ft.x&&(md=Qi(NR,g)),ft.y&&(gd=Qi(UR,g)),N.ori==0?(Fo=md,Oo=gd):(Fo=gd,Oo=md),Qe=ft.left,ln=ft.top);let tn=i.select=Pn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),zo=tn.show?Qi(DR,tn.over?g:d):null;function Nc(b,R){if(tn.show){for(let D in b)tn[D]=b[D],D in yd&&rn(zo,D,b[D]);R!==!1&&Gn("setSelect")}}i.setSelect=Nc;function iM(b){if(x[b].show)et&&Ym(ue[b],To);else if(et&&zi(ue[b],To),_t){let D=It?fe[0]:fe[b];D!=null&&ks(D,-10,-10,k,Lt)}}function xr(b,R,D){pd(b,{min:R,max:D})}function Ss(b,R,D,F){R.focus!=null&&lM(b),R.show!=null&&x.forEach((V,K)=>{K>0&&(b==K||b==null)&&(V.show=R.show,iM(K),s==2?(xr(V.facets[0].scale,null,null),xr(V.facets[1].scale,null,null)):xr(V.scale,null,null),Kn())}),D!==!1&&Gn("setSeries",b,R),F&&sl("setSeries",i,b,R)}i.setSeries=Ss;function sM(b,R){Pn(A[b],R)}function rM(b,R){b.fill=Ae(b.fill||null),b.dir=Ie(b.dir,-1),R=R??A.length,A.splice(R,0,b)}function oM(b){b==null?A.length=0:A.splice(b,1)}i.addBand=rM,i.setBand=sM,i.delBand=oM;function aM(b,R){x[b].alpha=R,_t&&fe[b]!=null&&(fe[b].style.opacity=R),et&&ue[b]&&(ue[b].style.opacity=R)}let Ws,yr,Jr,Ho={focus:!0};function lM(b){if(b!=Jr){let R=b==null,D=Gt.alpha!=1;x.forEach((F,V)=>{if(s==1||V>0){let K=R||V==0||V==b;F._focus=R?null:K,D&&aM(V,K?1:Gt.alpha)}}),Jr=b,D&&Kn()}}et&&re&&Re(Xy,Pt,b=>{ft._lock||(se(b),Jr!=null&&Ss(null,Ho,!0,An.setSeries))});function ws(b,R,D){let F=v[R];D&&(b=b/Fe-(F.ori==1?he:Qt));let V=k;F.ori==1&&(V=Lt,b=V-b),F.dir==-1&&(b=V-b);let K=F._min,lt=F._max,pt=b/V,St=K+(lt-K)*pt,Bt=F.distr;return Bt==3?za(10,St):Bt==4?jR(St,F.asinh):Bt==100?F.bwd(St):St}function cM(b,R){let D=ws(b,S,R);return xs(D,t[0],vn,bn)}i.valToIdx=b=>xs(b,t[0]),i.posToIdx=cM,i.posToVal=ws,i.valToPos=(b,R,D)=>v[R].ori==0?r(b,v[R],D?$:k,D?I:0):o(b,v[R],D?ht:Lt,D?T:0),i.setCursor=(b,R,D)=>{Qe=b.left,ln=b.top,Kr(null,R,D)};function Bg(b,R){rn(zo,Oa,tn.left=b),rn(zo,wc,tn.width=R)}function kg(b,R){rn(zo,"top",tn.top=b),rn(zo,Ec,tn.height=R)}let el=N.ori==0?Bg:kg,nl=N.ori==1?Bg:kg;function uM(){if(et&&dt.live)for(let b=s==2?1:0;b<x.length;b++){if(b==0&&me)continue;let R=dt.values[b],D=0;for(let F in R)$t[b][D++].firstChild.nodeValue=R[F]}}function _d(b,R){if(b!=null&&(b.idxs?b.idxs.forEach((D,F)=>{rt[F]=D}):nC(b.idx)||rt.fill(b.idx),dt.idx=rt[0]),et&&dt.live){for(let D=0;D<x.length;D++)(D>0||s==1&&!me)&&hM(D,rt[D]);uM()}mt=!1,R!==!1&&Gn("setLegend")}i.setLegend=_d;function hM(b,R){let D=x[b],F=b==0&&z==2?Ci:t[b],V;me?V=D.values(i,b,R)??le:(V=D.value(i,R==null?null:F[R],b,R),V=V==null?le:{_:V}),dt.values[b]=V}function Kr(b,R,D){Fg=Qe,Og=ln,[Qe,ln]=ft.move(i,Qe,ln),ft.left=Qe,ft.top=ln,_t&&(Fo&&ks(Fo,Fn(Qe),0,k,Lt),Oo&&ks(Oo,0,Fn(ln),k,Lt));let F,V=vn>bn;Ws=Ze,yr=null;let K=N.ori==0?k:Lt,lt=N.ori==1?k:Lt;if(Qe<0||dn==0||V){F=ft.idx=null;for(let pt=0;pt<x.length;pt++){let St=fe[pt];St!=null&&ks(St,-10,-10,k,Lt)}re&&Ss(null,Ho,!0,b==null&&An.setSeries),dt.live&&(rt.fill(F),mt=!0)}else{let pt,St,Bt;s==1&&(pt=N.ori==0?Qe:ln,St=ws(pt,S),F=ft.idx=xs(St,t[0],vn,bn),Bt=W(t[0][F],N,K,0));let kt=-10,Ht=-10,ce=0,Le=0,Pe=!0,Se="",ne="";for(let Jt=s==2?1:0;Jt<x.length;Jt++){let en=x[Jt],mn=rt[Jt],Vn=mn==null?null:s==1?t[Jt][mn]:t[Jt][1][mn],We=ft.dataIdx(i,Jt,F,St),gn=We==null?null:s==1?t[Jt][We]:t[Jt][1][We];if(mt=mt||gn!=Vn||We!=mn,rt[Jt]=We,Jt>0&&en.show){let Pi=We==null?-10:We==F?Bt:W(s==1?t[0][We]:t[Jt][0][We],N,K,0),oi=gn==null?-10:O(gn,s==1?v[en.scale]:v[en.facets[1].scale],lt,0);if(re&&gn!=null){let Vi=N.ori==1?Qe:ln,is=On(Gt.dist(i,Jt,We,oi,Vi));if(is<Ws){let Es=Gt.bias;if(Es!=0){let Ii=ws(Vi,en.scale),Wi=gn>=0?1:-1,ss=Ii>=0?1:-1;ss==Wi&&(ss==1?Es==1?gn>=Ii:gn<=Ii:Es==1?gn<=Ii:gn>=Ii)&&(Ws=is,yr=Jt)}else Ws=is,yr=Jt}}if(mt||It){let Vi,is;N.ori==0?(Vi=Pi,is=oi):(Vi=oi,is=Pi);let Es,Ii,Wi,ss,Ts,ai,Li=!0,jr=ct.bbox;if(jr!=null){Li=!1;let li=jr(i,Jt);Wi=li.left,ss=li.top,Es=li.width,Ii=li.height}else Wi=Vi,ss=is,Es=Ii=ct.size(i,Jt);if(ai=ct.fill(i,Jt),Ts=ct.stroke(i,Jt),It)Jt==yr&&Ws<=Gt.prox&&(kt=Wi,Ht=ss,ce=Es,Le=Ii,Pe=Li,Se=ai,ne=Ts);else{let li=fe[Jt];li!=null&&(je[Jt]=Wi,si[Jt]=ss,Qy(li,Es,Ii,Li),Ky(li,ai,Ts),ks(li,ts(Wi),ts(ss),k,Lt))}}}}if(It){let Jt=Gt.prox,en=Jr==null?Ws<=Jt:Ws>Jt||yr!=Jr;if(mt||en){let mn=fe[0];mn!=null&&(je[0]=kt,si[0]=Ht,Qy(mn,ce,Le,Pe),Ky(mn,Se,ne),ks(mn,ts(kt),ts(Ht),k,Lt))}}}if(tn.show&&_r)if(b!=null){let[pt,St]=An.scales,[Bt,kt]=An.match,[Ht,ce]=b.cursor.sync.scales,Le=b.cursor.drag;if(zn=Le._x,Hn=Le._y,zn||Hn){let{left:Pe,top:Se,width:ne,height:Jt}=b.select,en=b.scales[Ht].ori,mn=b.posToVal,Vn,We,gn,Pi,oi,Vi=pt!=null&&Bt(pt,Ht),is=St!=null&&kt(St,ce);Vi&&zn?(en==0?(Vn=Pe,We=ne):(Vn=Se,We=Jt),gn=v[pt],Pi=W(mn(Vn,Ht),gn,K,0),oi=W(mn(Vn+We,Ht),gn,K,0),el(ys(Pi,oi),On(oi-Pi))):el(0,K),is&&Hn?(en==1?(Vn=Pe,We=ne):(Vn=Se,We=Jt),gn=v[St],Pi=O(mn(Vn,ce),gn,lt,0),oi=O(mn(Vn+We,ce),gn,lt,0),nl(ys(Pi,oi),On(oi-Pi))):nl(0,lt)}else vd()}else{let pt=On(Fg-Ng),St=On(Og-Ug);if(N.ori==1){let ce=pt;pt=St,St=ce}zn=$n.x&&pt>=$n.dist,Hn=$n.y&&St>=$n.dist;let Bt=$n.uni;Bt!=null?zn&&Hn&&(zn=pt>=Bt,Hn=St>=Bt,!zn&&!Hn&&(St>pt?Hn=!0:zn=!0)):$n.x&&$n.y&&(zn||Hn)&&(zn=Hn=!0);let kt,Ht;zn&&(N.ori==0?(kt=Bo,Ht=Qe):(kt=ko,Ht=ln),el(ys(kt,Ht),On(Ht-kt)),Hn||nl(0,lt)),Hn&&(N.ori==1?(kt=Bo,Ht=Qe):(kt=ko,Ht=ln),nl(ys(kt,Ht),On(Ht-kt)),zn||el(0,K)),!zn&&!Hn&&(el(0,0),nl(0,0))}if($n._x=zn,$n._y=Hn,b==null){if(D){if(Jg!=null){let[pt,St]=An.scales;An.values[0]=pt!=null?ws(N.ori==0?Qe:ln,pt):null,An.values[1]=St!=null?ws(N.ori==1?Qe:ln,St):null}sl(zm,i,Qe,ln,k,Lt,F)}if(re){let pt=D&&An.setSeries,St=Gt.prox;Jr==null?Ws<=St&&Ss(yr,Ho,!0,pt):Ws>St?Ss(null,Ho,!0,pt):yr!=Jr&&Ss(yr,Ho,!0,pt)}}mt&&(dt.idx=F,_d()),R!==!1&&Gn("setCursor")}let vr=null;Object.defineProperty(i,"rect",{get(){return vr==null&&il(!1),vr}});function il(b=!1){b?vr=null:(vr=g.getBoundingClientRect(),Gn("syncRect",vr))}function zg(b,R,D,F,V,K,lt){ft._lock||_r&&b!=null&&b.movementX==0&&b.movementY==0||(xd(b,R,D,F,V,K,lt,!1,b!=null),b!=null?Kr(null,!0,!0):Kr(R,!0,!1))}function xd(b,R,D,F,V,K,lt,pt,St){if(vr==null&&il(!1),se(b),b!=null)D=b.clientX-vr.left,F=b.clientY-vr.top;else{if(D<0||F<0){Qe=-10,ln=-10;return}let[Bt,kt]=An.scales,Ht=R.cursor.sync,[ce,Le]=Ht.values,[Pe,Se]=Ht.scales,[ne,Jt]=An.match,en=R.axes[0].side%2==1,mn=N.ori==0?k:Lt,Vn=N.ori==1?k:Lt,We=en?K:V,gn=en?V:K,Pi=en?F:D,oi=en?D:F;if(Pe!=null?D=ne(Bt,Pe)?a(ce,v[Bt],mn,0):-10:D=mn*(Pi/We),Se!=null?F=Jt(kt,Se)?a(Le,v[kt],Vn,0):-10:F=Vn*(oi/gn),N.ori==1){let Vi=D;D=F,F=Vi}}St&&(R==null||R.cursor.event.type==zm)&&((D<=1||D>=k-1)&&(D=wo(D,k)),(F<=1||F>=Lt-1)&&(F=wo(F,Lt))),pt?(Ng=D,Ug=F,[Bo,ko]=ft.move(i,D,F)):(Qe=D,ln=F)}let yd={width:0,height:0,left:0,top:0};function vd(){Nc(yd,!1)}let Hg,Gg,Vg,Wg;function qg(b,R,D,F,V,K,lt){_r=!0,zn=Hn=$n._x=$n._y=!1,xd(b,R,D,F,V,K,lt,!0,!1),b!=null&&(Re(Hm,Xm,Xg,!1),sl(Wy,i,Bo,ko,k,Lt,null));let{left:pt,top:St,width:Bt,height:kt}=tn;Hg=pt,Gg=St,Vg=Bt,Wg=kt}function Xg(b,R,D,F,V,K,lt){_r=$n._x=$n._y=!1,xd(b,R,D,F,V,K,lt,!1,!0);let{left:pt,top:St,width:Bt,height:kt}=tn,Ht=Bt>0||kt>0,ce=Hg!=pt||Gg!=St||Vg!=Bt||Wg!=kt;if(Ht&&ce&&Nc(tn),$n.setScale&&Ht&&ce){let Le=pt,Pe=Bt,Se=St,ne=kt;if(N.ori==1&&(Le=St,Pe=kt,Se=pt,ne=Bt),zn&&xr(S,ws(Le,S),ws(Le+Pe,S)),Hn)for(let Jt in v){let en=v[Jt];Jt!=S&&en.from==null&&en.min!=Ze&&xr(Jt,ws(Se+ne,Jt),ws(Se,Jt))}vd()}else ft.lock&&(ft._lock=!ft._lock,Kr(R,!0,b!=null));b!=null&&(In(Hm,Xm),sl(Hm,i,Qe,ln,k,Lt,null))}function fM(b,R,D,F,V,K,lt){if(ft._lock)return;se(b);let pt=_r;if(_r){let St=!0,Bt=!0,kt=10,Ht,ce;N.ori==0?(Ht=zn,ce=Hn):(Ht=Hn,ce=zn),Ht&&ce&&(St=Qe<=kt||Qe>=k-kt,Bt=ln<=kt||ln>=Lt-kt),Ht&&St&&(Qe=Qe<Bo?0:k),ce&&Bt&&(ln=ln<ko?0:Lt),Kr(null,!0,!0),_r=!1}Qe=-10,ln=-10,rt.fill(null),Kr(null,!0,!0),pt&&(_r=pt)}function $g(b,R,D,F,V,K,lt){ft._lock||(se(b),tl(),vd(),b!=null&&sl($y,i,Qe,ln,k,Lt,null))}function Yg(){M.forEach(xP),B(i.width,i.height,!0)}Ao(Of,ka,Yg);let Go={};Go.mousedown=qg,Go.mousemove=zg,Go.mouseup=Xg,Go.dblclick=$g,Go.setSeries=(b,R,D,F)=>{let V=An.match[2];D=V(i,R,D),D!=-1&&Ss(D,F,!0,!1)},_t&&(Re(Wy,g,qg),Re(zm,g,zg),Re(qy,g,b=>{se(b),il(!1)}),Re(Xy,g,fM),Re($y,g,$g),tg.add(i),i.syncRect=il);let Uc=i.hooks=n.hooks||{};function Gn(b,R,D){ri?He.push([b,R,D]):b in Uc&&Uc[b].forEach(F=>{F.call(null,i,R,D)})}(n.plugins||[]).forEach(b=>{for(let R in b.hooks)Uc[R]=(Uc[R]||[]).concat(b.hooks[R])});let Zg=(b,R,D)=>D,An=Pn({key:null,setSeries:!1,filters:{pub:sv,sub:sv},scales:[S,x[1]?x[1].scale:null],match:[rv,rv,Zg],values:[null,null]},ft.sync);An.match.length==2&&An.match.push(Zg),ft.sync=An;let Jg=An.key,bd=eb(Jg);function sl(b,R,D,F,V,K,lt){An.filters.pub(b,R,D,F,V,K,lt)&&bd.pub(b,R,D,F,V,K,lt)}bd.sub(i);function dM(b,R,D,F,V,K,lt){An.filters.sub(b,R,D,F,V,K,lt)&&Go[b](null,R,D,F,V,K,lt)}i.pub=dM;function pM(){bd.unsub(i),tg.delete(i),kn.clear(),Zm(Of,ka,Yg),l.remove(),Pt?.remove(),Gn("destroy")}i.destroy=pM;function Md(){Gn("init",n,t),Qa(t||n.data,!1),X[S]?pd(S,X[S]):tl(),st=tn.show&&(tn.width>0||tn.height>0),nt=mt=!0,B(n.width,n.height)}return x.forEach(Lo),M.forEach(zs),e?e instanceof HTMLElement?(e.appendChild(l),Md()):e(i,Md):Md(),i}Jn.assign=Pn;Jn.fmtNum=ag;Jn.rangeNum=Bf;Jn.rangeLog=Hf;Jn.rangeAsinh=rg;Jn.orient=Co;Jn.pxRatio=Fe;Jn.join=cC;Jn.fmtDate=cg,Jn.tzDate=vC;Jn.sync=eb;{Jn.addGap=nP,Jn.clipGaps=Wf;let n=Jn.paths={points:ab};n.linear=cb,n.stepped=rP,n.bars=oP,n.spline=lP}var gg={sqrt:Math.sqrt,sin:Math.sin,cos:Math.cos,tan:Math.tan,asin:Math.asin,acos:Math.acos,atan:Math.atan,abs:Math.abs},db={pi:Math.PI,\u03C0:Math.PI,tau:2*Math.PI},Yf=/\s*(?:(\d+\.?\d*(?:[eE][+-]?\d+)?|\.\d+(?:[eE][+-]?\d+)?)|([A-Za-zπ°]+)|(\*\*|[-+*/^()−·]))/y,pb=80;function yP(n){let t=[];Yf.lastIndex=0;let e=n.trimEnd();for(;Yf.lastIndex<e.length;){let i=Yf.lastIndex,s=Yf.exec(e);if(!s)throw new Error(`cannot read \u201C${e.slice(i).trim().slice(0,8)}\u201D at character ${i+1}`);s[1]!==void 0?t.push({number:Number(s[1])}):s[2]!==void 0?t.push({word:s[2]}):t.push({sign:{"\u2212":"-","\xB7":"*","**":"^"}[s[3]]??s[3]})}return t}function vP(n){if(!n.includes(","))return n;if(n.includes(".")||/\d,\d*,/.test(n))throw new Error("a comma is the decimal sign here: leave out the ones between thousands");return n.replace(/(\d),(?=\d)|(\d),(?!\d)|(^|\D),(?=\d)/g,"$1$2$3.")}function Zf(n,t="plain"){let e=vP(String(n));if(e.length>pb)throw new Error(`longer than ${pb} characters`);let i=yP(e);if(!i.length)throw new Error("empty: type a number, or an expression such as pi/2");let s=null,r=i[i.length-1];i.length>1&&r.word&&r.word in yt.suffix(t)&&(s=yt.suffix(t)[r.word],i.pop());let o=0,a=!1,c=m=>i[o]?.sign===m,l=m=>{if(!c(m))throw new Error(`\u201C${m}\u201D is missing`);o++};function u(){let m=h();for(;c("+")||c("-");){let x=i[o++].sign,M=h();m=x==="+"?m+M:m-M}return m}function h(){let m=f();for(;;)if(c("*"))o++,m*=f();else if(c("/"))o++,m/=f();else if(i[o]?.word||c("("))m*=d();else return m}function f(){return c("-")?(o++,-f()):c("+")?(o++,f()):d()}function d(){let m=g();return c("^")?(o++,m**f()):m}function g(){let m=i[o];if(!m)throw new Error("something is missing at the end");if(o++,m.number!==void 0)return m.number;if(m.sign==="("){let x=u();return l(")"),x}if(m.word){let x=m.word.toLowerCase();if(Object.hasOwn(db,x))return a=!0,db[x];if(Object.hasOwn(gg,x)){l("(");let M=u();return l(")"),gg[x](M)}throw new Error(`\u201C${m.word.slice(0,20)}\u201D is not known; allowed are pi, ${Object.keys(gg).join(", ")}`)}throw new Error(`\u201C${m.sign}\u201D is not expected here`)}let _=u();if(o<i.length)throw new Error(`\u201C${i[o].sign??i[o].word??i[o].number}\u201D is not expected here`);if(!Number.isFinite(_))throw new Error("not a finite number");let p=s??(t==="angle"&&a?1:yt.factor(t));return{value:_/p+0,symbolic:a||s!==null||i.length>2}}function Ti({label:n,kind:t="plain",input:e,commit:i,empty:s,testid:r,title:o,check:a}){let c=typeof t=="function"?t:()=>t,l=E("input",{type:"text",class:"number",inputmode:"decimal",autocomplete:"off",spellcheck:"false","aria-label":n,"data-testid":r,title:o}),u=null,h=null,f=()=>{if(l.value.trim()===""&&s!==void 0)return{value:s,symbolic:!1};let p=Zf(l.value,c()),m=a?.(p.value);if(m)throw new Error(m);return p},d=p=>{l.classList.toggle("wrong",!!p),p?(l.setAttribute("aria-invalid","true"),l.title=p):(l.removeAttribute("aria-invalid"),l.title=o??""),_g(l,p),l.dispatchEvent(new CustomEvent("verdict",{bubbles:!0,detail:p?{label:n,reason:p}:null}))},g=p=>{try{let m=f();return d(null),p?.(m.value,{symbolic:m.symbolic,text:l.value.trim()}),!0}catch(m){return d(m.message),!1}};l.addEventListener("input",()=>g(e)),l.addEventListener("change",()=>{g(i??e)&&l.blurred?.()});let _="";return l.addEventListener("focus",()=>{_=l.value,l.classList.contains("wrong")&&_g(l,l.title),l.select()}),l.addEventListener("blur",()=>_g(l,null)),l.addEventListener("keydown",p=>{let m=l.closest("table.dh");if(p.key==="Escape"&&l.value!==_){p.preventDefault(),l.value=_,g(i??e),l.select();return}if(m&&bP(l,p))return;let x={ArrowUp:1,ArrowDown:-1}[p.key];if(p.key==="Enter"&&(_=l.value,l.select()),!(!x||m&&!p.altKey)){p.preventDefault();try{let M=f();l.value=ac((M.value??0)+x*yt.step(c())*(p.shiftKey?.1:1),c()),g(i??e)}catch{}}}),l.put=(p,m=null)=>{document.activeElement===l&&!l.readOnly||p===u&&m===h&&!l.classList.contains("wrong")||(u=p,h=m,l.value=m??(p==null?"":ac(p,c())),mb(l),l.classList.contains("wrong")&&d(null))},l.addEventListener("input",()=>mb(l)),l.refresh=()=>{let p=u,m=h;u=NaN,l.put(p,m)},l}function mb(n){let t=n.clientWidth;if(n.value.length<7&&!n.shrunk||(n.style.removeProperty("font-size"),n.shrunk=!1,!t||n.scrollWidth<=t))return;let e=parseFloat(getComputedStyle(n).fontSize);n.style.setProperty("font-size",`${Math.max(.58*e,e*(t-14)/(n.scrollWidth-14)).toFixed(2)}px`),n.shrunk=!0}var vi=null;function _g(n,t){if(!t){vi&&vi.about===n&&(vi.hidden=!0),n.removeAttribute("aria-describedby");return}vi||(vi=E("div",{class:"why",id:"why",role:"alert","data-testid":"why"}),document.body.append(vi)),vi.about=n,vi.hidden=!1,vi.textContent!==t&&(vi.textContent=t),n.setAttribute("aria-describedby","why");let e=n.getBoundingClientRect();vi.style.setProperty("top",`${e.bottom+4}px`),vi.style.setProperty("left",`${Math.max(8,Math.min(e.left,innerWidth-vi.offsetWidth-8))}px`)}addEventListener("scroll",()=>vi&&(vi.hidden=!0),!0);function bP(n,t){let e=n.selectionStart===0&&n.selectionEnd===n.value.length,i={ArrowUp:-1,ArrowDown:1,Enter:t.shiftKey?-1:1}[t.key],s={ArrowLeft:e||n.selectionEnd===0?-1:0,ArrowRight:e||n.selectionStart===n.value.length?1:0}[t.key]??0;if(t.altKey||t.ctrlKey||t.metaKey||!i&&!s)return!1;let r=[...n.closest("tbody").rows].map(l=>[...l.querySelectorAll("input.number")]),o=r.findIndex(l=>l.includes(n)),a=r[o].indexOf(n),c=r[o+(i??0)]?.[a+s];return t.key==="Enter"&&n.dispatchEvent(new Event("change")),c?(t.preventDefault(),c.focus(),!0):t.key!=="Enter"}function Jf(n){let t=n.trim().replace(/^\[\s*\[|\]\s*\]$/g,"").split(/\]\s*,?\s*\[|[;\r\n]+/).map(e=>e.replace(/^[\s[(,]+|[\s\]),]+$/g,"")).filter(Boolean).map(e=>{let i=e.split("	");return(i.length>1?i:e.split(/\s*,\s+|\s+|,(?=[^,]*\.)|,(?=[A-Za-z(-])/)).map(s=>s.trim()).filter(Boolean)});return t.length>1||(t[0]?.length??0)>1?t:null}function Kf(n,t,e,i){let s=0;return i.forEach((r,o)=>r.forEach((a,c)=>{let l=n[t+o]?.[e+c];l&&(l.value=a,l.dispatchEvent(new Event("input",{bubbles:!0})),l.dispatchEvent(new Event("change",{bubbles:!0})),s+=1)})),s}var on=n=>n.type==="R"?"angle":"length";function gb(n){let t=n.type==="R"?Math.PI:Mr(P.table),e=n.lower??Math.min(-t,(n.upper??t)-2*t),i=n.upper??Math.max(t,e+2*t),s=Math.max((i-e)*.08,.001);return{lo:e,hi:i,min:n.lower===null?e:e-s,max:n.upper===null?i:i+s}}var MP=lm;function SP(n){let t=P.table.joints[n],e=on(t),{lo:i,hi:s,min:r,max:o}=gb(t),a=`q${n+1}`,c=E("input",{type:"range",min:String(r),max:String(o),step:"any","aria-label":`${a}, ${t.name}`,"data-testid":`slider-${n+1}`}),l=_=>`${100*(_-r)/(o-r)}%`;c.style.setProperty("--lo",l(i)),c.style.setProperty("--hi",l(s)),c.addEventListener("input",()=>{xi(),zc(n,Number(c.value))}),c.addEventListener("keydown",_=>{let p={ArrowRight:1,ArrowUp:1,ArrowLeft:-1,ArrowDown:-1,PageUp:10,PageDown:-10}[_.key],m={Home:i,End:s}[_.key];if(p===void 0&&m===void 0)return;_.preventDefault(),xi();let x=yt.step(e)*(_.shiftKey?.1:1);zc(n,m??Math.min(Math.max(Math.round((P.q[n]+p*x)/(x/10))*(x/10),r),o))});let u=Ti({label:`${a} value`,kind:e,testid:`q-${n+1}`,input:_=>{xi(),zc(n,_)}}),h=E("span",{class:"out",role:"note"}),f=E("span",{class:"chain",title:"What this row of the table moves by"}),d=E("span",{class:"limits"}),g=E("div",{class:"joint","data-testid":`joint-${n+1}`},E("span",{class:"joint-name",title:`${t.name}, ${t.type==="R"?"revolute":"prismatic"}`},E("i",{text:"q"}),E("sub",{text:String(n+1)})),E("div",{class:"track"},c,E("div",{class:"under"},d,f,h)),u,E("span",{class:"unit"}));return{el:g,number:u,show(){let _=P.q[n],p=MP(t,_);(document.activeElement!==c||Number(c.value)!==_)&&(c.value=_),c.style.setProperty("--at",l(Math.min(Math.max(_,r),o))),c.setAttribute("aria-valuetext",$e(_,e)),u.put(Number((_*yt.factor(e)).toFixed(yt.digits(e)+1))/yt.factor(e)),g.classList.toggle("outside",p!==0);let m=P.table.coupling?`chain ${$e(to(P.table,P.q)[n],e)}`:"";Ut(f,m),Ut(h,p?`${$e(Math.abs(p),e)} ${p>0?"above":"below"} the limit`:"")},relabel(){Ut(g.lastChild,yt.symbol(e));let _=p=>p===null?"no limit":$e(p,e,yt.angle==="deg"&&e==="angle"?0:void 0);Ut(d,t.lower===null&&t.upper===null?"no limits":`${_(t.lower)} \u2026 ${_(t.upper)}`),u.refresh(),this.show()}}}var _b={id:"joints",title:"Joints",build(n){let t=[],e=E("div",{class:"joints","data-testid":"joints"}),i=E("div",{class:"chips",role:"group","aria-label":"Postures"}),s=E("div",{class:"joints gripper"});n.append(e,s,i);let r=()=>{t=P.table.joints.map((o,a)=>SP(a)),te(e,t.map(o=>o.el)),t.length||e.append(E("p",{class:"hint",text:"This table has no joints yet. Add one in the DH table."})),t.forEach(o=>o.relabel()),te(s,P.table.actuator?wP(P.table.actuator):null),EP(i)};gt("table",o=>o!=="gripper"&&r()),gt("q",()=>t.forEach(o=>o.show())),gt("units",()=>t.forEach(o=>o.relabel())),r()}};function wP(n){let t=E("input",{type:"range",min:String(n.lower),max:String(n.upper),step:"any","aria-label":`${n.name}, ${n.unit}`,"data-testid":"actuator"}),e=E("output",{class:"quantity"}),i=()=>{t.style.setProperty("--at",`${100*(n.value-n.lower)/(n.upper-n.lower||1)}%`),Ut(e,Xn(n.value,1))};t.value=n.value,t.addEventListener("input",()=>{n={...n,value:Number(t.value)},_n({...P.table,actuator:n},{what:"gripper",label:`set the ${n.name}`,key:"actuator"}),i()}),i();let s=E("div",{class:"under"},E("span",{text:`${n.name}: moves no frame`}));return E("div",{class:"joint"},E("span",{class:"joint-name",text:"tool"}),E("div",{class:"track"},t,s),e,E("span",{class:"unit",text:n.unit}))}function EP(n){let t=P.table.joints.length,e=Object.entries(P.table.postures??{}),i=(r,o)=>E("button",{type:"button",class:"chip",text:r,title:o.map((a,c)=>$e(a,on(P.table.joints[c]))).join(", "),on:{click:()=>ms(o,.8,`move to ${r}`)}}),s=e.map(([r,o])=>i(r,o));t&&!e.some(([,r])=>r.every(o=>o===0))&&s.unshift(i("zero",new Array(t).fill(0))),te(n,s,t?E("button",{type:"button",class:"chip quiet",text:"Random",title:"A posture inside the limits",on:{click:()=>ms(TP(),.8,"move to a random posture")}}):null,t?E("button",{type:"button",class:"chip quiet",text:"Keep this one",title:"Add the present posture to the arm",on:{click:AP}}):null)}function TP(){return P.table.joints.map(n=>{let{lo:t,hi:e}=gb(n);return t+Math.random()*(e-t)})}function AP(){let n={...P.table.postures},t=0;for(;`P${t}`in n;)t+=1;n[`P${t}`]=P.q.slice(),_n({...P.table,postures:n},{what:"postures",label:`keep the posture P${t}`}),Rn(`Kept as P${t}: ${P.q.map((e,i)=>ac(e,on(P.table.joints[i]))).join(", ")}`),Dt("postures")}var xb=[["position","Position"],["joints","Joints"],["speeds","Joint speeds"],["singularity","Distance to singularity"]];function jf({table:n,q:t,xs:e,xName:i,xEnd:s=null,seconds:r,dq:o=null,events:a=[],title:c}){let l=t.map(u=>$s(n,u));return{table:n,q:t,xs:e,xName:i,xEnd:s,seconds:r,events:a,title:c,tool:l.map(u=>ye(u[u.length-1])),speeds:o??RP(t,r),least:t.map((u,h)=>kc(n,u,l[h])[0]??0)}}function RP(n,t){return n.map((e,i)=>{let s=Math.max(i-1,0),r=Math.min(i+1,n.length-1),o=t[r]-t[s];return n[i].map((a,c)=>o>0?(n[r][c]-n[s][c])/o:0)})}function xg(n,t){let{table:e}=n,i=yt.factor("length");if(t==="position")return{y:`tool, ${yt.length}`,list:["X","Y","Z"].map((c,l)=>({name:c,values:n.tool.map(u=>u[l]*i)}))};if(t==="singularity")return{y:"smallest singular value",list:[{name:"\u03C3 min",values:n.least}]};let s=t==="joints"?n.q:n.speeds,r=t==="joints"?"":"/s";return{y:[...new Set(e.joints.map(on))].map(c=>(c==="angle"?yt.angle:yt.length)+r).join(" or "),list:e.joints.map((c,l)=>({name:`q${l+1}`,values:s.map(u=>u[l]*yt.factor(on(c)))}))}}function yb(n){let t=yt.angle,e=yt.length,{table:i}=n,s=c=>on(c)==="angle"?t:e,r=[n.xName.replace(" ","_"),"time_s",`X_${e}`,`Y_${e}`,`Z_${e}`,...i.joints.map((c,l)=>`q${l+1}_${s(c)}`),...i.joints.map((c,l)=>`dq${l+1}_${s(c)}_per_s`),"sigma_min"],o=c=>String(Number(c.toPrecision(10))),a=n.q.map((c,l)=>[n.xs[l],n.seconds[l],...n.tool[l].map(u=>u*yt.factor("length")),...c.map((u,h)=>u*yt.factor(on(i.joints[h]))),...n.speeds[l].map((u,h)=>u*yt.factor(on(i.joints[h]))),n.least[l]].map(o).join(","));return[r.join(","),...a].join(`
`)+`
`}function vb(n,t,e){let{y:i,list:s}=xg(n,t),r=720,o=380,a={l:66,r:96,t:34,b:48},c=n.xs,l=s.flatMap(y=>y.values),u=n.xEnd??c[c.length-1],h=c[0],f=u>h?u:h+1,[d,g]=[Math.min(...l),Math.max(...l)];g-d>1e-9||(d-=1,g+=1);let _=y=>a.l+(y-h)/(f-h)*(r-a.l-a.r),p=y=>o-a.b-(y-d)/(g-d)*(o-a.t-a.b),m=(y,w)=>{let U=(w-y)/6,L=10**Math.floor(Math.log10(U)),N=[1,2,5,10].map(z=>z*L).find(z=>z>=U);return Array.from({length:12},(z,W)=>(Math.ceil(y/N)+W)*N).filter(z=>z<=w+N*1e-6)},x=y=>y.toFixed(2),M=y=>String(Number(y.toPrecision(6))),v=y=>y.replace(/[&<>"]/g,w=>({"&":"&amp;","<":"&lt;",">":"&gt;",'"':"&quot;"})[w]),A=["","7 3","2 3","9 3 2 3","5 2 1 2 1 2","12 4","1 2","6 6"],S=[`<rect width="${r}" height="${o}" fill="#fff"/>`,`<text x="${a.l}" y="20" font-weight="600">${v(n.title)}</text>`];for(let y of m(d,g))S.push(`<path d="M${a.l} ${x(p(y))}H${r-a.r}" stroke="#ddd"/><text x="${a.l-8}" y="${x(p(y)+4)}" text-anchor="end">${M(y)}</text>`);for(let y of m(h,f))S.push(`<path d="M${x(_(y))} ${o-a.b}v5" stroke="#333"/><text x="${x(_(y))}" y="${o-a.b+20}" text-anchor="middle">${M(y)}</text>`);S.push(`<path d="M${a.l} ${a.t}V${o-a.b}H${r-a.r}" fill="none" stroke="#333"/>`);for(let y of n.events)Number.isFinite(y.x)&&S.push(`<path d="M${x(_(y.x))} ${a.t}V${o-a.b}" stroke="#b42318" stroke-dasharray="3 3"/><text x="${x(_(y.x)+4)}" y="${a.t+10}" fill="#b42318" font-size="11">${v(y.short)}</text>`);return s.forEach((y,w)=>{let U=e[w%e.length],L=y.values[y.values.length-1];S.push(`<polyline fill="none" stroke="${U}" stroke-width="1.8" stroke-dasharray="${A[w%A.length]}" points="${y.values.map((N,z)=>`${x(_(c[z]))},${x(p(N))}`).join(" ")}"/>`,`<path d="M${r-a.r+12} ${a.t+8+18*w}h22" stroke="${U}" stroke-width="2" stroke-dasharray="${A[w%A.length]}"/><text x="${r-a.r+40}" y="${a.t+12+18*w}"><title>${x(L)}</title>${v(y.name)}</text>`)}),S.push(`<text x="${(a.l+r-a.r)/2}" y="${o-8}" text-anchor="middle">${v(n.xName)}</text>`,`<text transform="translate(16 ${(a.t+o-a.b)/2}) rotate(-90)" text-anchor="middle">${v(i)}</text>`),`<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${r} ${o}" width="${r}" height="${o}" font-family="Inter, Helvetica, Arial, sans-serif" font-size="12" fill="#222">${S.join("")}</svg>
`}var Ge=null,Bn=null,$a="joints",es=0,bb=1,ii=null;function Mb(n){let t=E("button",{type:"button",class:"primary",text:"Play","data-testid":"play",on:{click:CP}}),e=E("input",{type:"range",min:"0",max:"1",step:"1",value:"0","aria-label":"Point of the motion","data-testid":"scrub",on:{input:()=>{xi(),ed(Number(e.value))}}}),i=E("output",{class:"where","data-testid":"where"}),s=E("div",{class:"marks"}),r=E("div",{class:"chart","data-testid":"chart"}),o=E("div",{class:"legend"});n.append(E("div",{class:"dock-bar"},t,jn("Speed",[["0.25","\xBC\xD7"],["0.5","\xBD\xD7"],["1","1\xD7"],["2","2\xD7"],["4","4\xD7"],["10","10\xD7"]],"1",a=>{bb=Number(a)},{"data-testid":"speed"}),E("div",{class:"scrubber"},e,s),i,E("span",{class:"line"},...[["CSV",()=>Zs("motion.csv",yb(Ge),"text/csv")],["PNG",IP],["SVG",()=>Zs(`${$a}.svg`,vb(Ge,$a,pe.curves),"image/svg+xml")]].map(([a,c])=>E("button",{type:"button",class:"quiet",text:a,"aria-label":`Save as ${a}`,on:{click:()=>Ge&&c()}})),E("button",{type:"button",class:"icon",text:"\xD7","aria-label":"Close the curves",on:{click:()=>Po(null)}}))),E("div",{class:"dock-bar second"},xn("Curves",xb,$a,a=>{$a=a,yg()},"curves"),o),r),ii={root:n,toggle:t,scrub:e,where:i,marks:s,chart:r,legend:o},new ResizeObserver(wr(()=>Bn&&r.clientWidth&&Bn.setSize({width:r.clientWidth,height:r.clientHeight}))).observe(r),gt(["units","theme"],yg),gt("moving",a=>Ut(t,a&&td?"Pause":"Play")),gt("table",a=>{Ge&&!["postures","name","gripper"].includes(a)&&Po(null)})}function Po(n){if(xi(),Ge=n,P.motion=n,ii.root.hidden=!n,Bn&&(Bn.destroy(),Bn=null),_y(n?.table??null,n?.q??[]),!n){Dt("motion");return}ii.scrub.max=String(Math.max(n.q.length-1,0));let t=n.xs[n.xs.length-1]-n.xs[0]||1;te(ii.marks,n.events.map(e=>{let i=E("span",{class:"event-mark",title:e.text});return i.style.setProperty("left",`${Math.min(100*(e.x-n.xs[0])/t,100)}%`),i})),yg(),n.q.length&&ed(0),requestAnimationFrame(()=>Ca()),Dt("motion")}function ed(n){Ge?.q.length&&(es=Math.min(Math.max(Math.round(n),0),Ge.q.length-1),ii.scrub.value=String(es),ii.scrub.style.setProperty("--at",`${Ge.q.length>1?100*es/(Ge.q.length-1):0}%`),Ut(ii.where,Ge.xName==="point"?`point ${es+1} of ${Ge.q.length}`:`${Xn(Ge.xs[es],2)} s of ${Xn(Ge.xs[Ge.xs.length-1],2)} s`),ii.scrub.setAttribute("aria-valuetext",ii.where.textContent),Xi(Ge.q[es].slice(),"scrub"),vg())}var td=!1;function CP(){if(td){xi();return}if(!Ge?.q.length)return;let n=Ge.seconds,t=n[n.length-1]||1,e=es>=Ge.q.length-1?0:n[es]/t;td=!0,Iy(t/bb,e,i=>{let s=es<=Ge.q.length-1&&n[es]<=i*t?es:0;for(;s<n.length-1&&n[s+1]<=i*t+1e-9;)s+=1;ed(s)},()=>{td=!1,Ut(ii.toggle,"Play")}),Ut(ii.toggle,"Pause")}function yg(){if(!Ge||!ii)return;Bn&&(Bn.destroy(),Bn=null);let{y:n,list:t}=xg(Ge,$a),e={stroke:pe.line,width:1},i=`${Math.round(.78*Qf())}px "Inter Variable", system-ui, sans-serif`;te(ii.legend,t.map((o,a)=>{let c=E("span",{class:"swatch"});return c.style.setProperty("background",pe.curves[a%pe.curves.length]),E("span",{},c,o.name)}));let s={stroke:pe.muted,grid:e,ticks:{...e,size:4},font:i,labelFont:i,labelSize:1.4*Qf(),gap:4};Bn=new Jn({width:ii.chart.clientWidth||600,height:ii.chart.clientHeight||180,pxAlign:0,legend:{show:!1},cursor:{drag:{x:!1,y:!1},points:{show:!1},y:!1},scales:{x:{time:!1,range:(o,a,c)=>[a,Math.max(c,Ge.xEnd??c,a+1e-6)]},y:{range:(o,a,c)=>c-a>1e-9?[a-.06*(c-a),c+.06*(c-a)]:[a-1,c+1]}},series:[{},...t.map((o,a)=>({label:o.name,stroke:pe.curves[a%pe.curves.length],width:1.75,pxAlign:0,points:{show:Ge.q.length<3}}))],axes:[{...s,label:Ge.xName==="point"?"point number":"time, s",size:2.1*Qf()},{...s,label:n,size:4*Qf()}]},[Ge.xs,...t.map(o=>o.values)],ii.chart);let r=E("div",{class:"now"});Bn.over.append(r,...Ge.events.map(o=>{let a=E("div",{class:`event ${o.stop?"stop":""}`,title:o.text},E("span",{text:o.short}));return a.x=o.x,a})),Bn.over.addEventListener("pointerdown",o=>{let a=u=>ed(PP(Bn.posToVal(u.clientX-Bn.over.getBoundingClientRect().left,"x")));xi(),a(o);let c=u=>a(u),l=()=>{removeEventListener("pointermove",c),removeEventListener("pointerup",l)};addEventListener("pointermove",c),addEventListener("pointerup",l)}),Bn.hooks.setSize=[vg],vg()}var Qf=()=>parseFloat(getComputedStyle(document.documentElement).fontSize),PP=n=>Ge.xs.reduce((t,e,i)=>Math.abs(e-n)<Math.abs(Ge.xs[t]-n)?i:t,0);function vg(){if(!Bn)return;let n=Bn.over.clientWidth;for(let t of Bn.over.querySelectorAll(".now, .event")){let e=Bn.valToPos(t.x??Ge.xs[es],"x");t.style.setProperty("left",`${e}px`),t.classList.toggle("leftward",e>n*.7)}}function IP(){let n=Bn.ctx.canvas,t=document.createElement("canvas"),e=t.getContext("2d");t.width=n.width,t.height=n.height,e.fillStyle=pe.panel,e.fillRect(0,0,t.width,t.height),e.drawImage(n,0,0),t.toBlob(i=>Zs(`${$a}.png`,i))}function Sb(n){let t=E("select",{"aria-label":"Arm from the catalogue","data-testid":"catalog",on:{change:()=>LP(t.value)}}),e=E("p",{class:"sentence","data-testid":"sentence"}),i=E("span",{class:"online",role:"status","data-testid":"online"}),s=(l,u,h,f)=>{let d=E("button",{type:"button",text:l,"aria-label":u,on:{click:h}});return d.show=g=>{d.disabled=!g,d.title=g?`${u}: ${g} (${f})`:`Nothing to ${u.toLowerCase()}`,d.setAttribute("aria-description",g??"")},d},r=s("\u21B6","Undo",Om,"Ctrl+Z"),o=s("\u21B7","Redo",Bm,"Ctrl+Shift+Z");gt("history",()=>{r.show(Af()),o.show(Rf())});let a=()=>{let{name:l,derived:u,catalog:h}=P.table,f=h?[]:[E("option",{value:"",text:u?`${l} (from ${u}, edited)`:l||"my-arm"})];te(t,f,(P.catalog??[]).map(d=>E("option",{value:d,text:d}))),t.value=h??""},c=E("span",{class:"group",role:"group","aria-label":"History"},r,o);n.append(E("span",{class:"mark"},E("img",{src:"icon.svg",alt:"",width:"22",height:"22"}),E("b",{text:"pieper"})),t,c,e,E("span",{class:"bar-end"},i,xn("Angles in",[["deg","\xB0"],["rad","rad"]],yt.angle,l=>{yt.set("angle",l),Dt("units")},"unit-angle"),xn("Lengths in",[["mm","mm"],["m","m"]],yt.length,l=>{yt.set("length",l),Dt("units")},"unit-length"),jn("Light or dark",[["auto","Auto"],["light","Light"],["dark","Dark"]],P.theme,Zh,{"data-testid":"theme"}))),Dt("history"),gt(["catalog","table"],a),gt("plan",()=>{Ut(e,[qc(P.plan),c0(P.plan)].filter(Boolean).join(". ").replace("..",".")),e.title=P.plan?.explain??""}),gt("online",l=>{Ut(i,l?"":"Server away; reconnecting"),i.classList.toggle("away",!l)}),gt(["units","theme"],()=>{n.querySelector("[data-testid=unit-angle]").mark(yt.angle),n.querySelector("[data-testid=unit-length]").mark(yt.length),n.querySelector("[data-testid=theme]").value=P.theme})}async function LP(n){if(n)try{let{table:t}=await Ys("load",{name:n});_n(t,{q:Vo(t),what:"new",label:`open ${n}`})}catch(t){Rn(t.message,"wrong")}}function wb(n,t,e,i){let s=E("div",{role:"tablist","aria-orientation":"vertical",class:"tabs"}),r=matchMedia("(min-width: 1700px)");n.append(s);let o=new Map,a=i.map(l=>{let u=E("div",{role:"tabpanel",class:"panel",id:`panel-${l.id}`,"aria-labelledby":`tab-${l.id}`,"data-testid":`panel-${l.id}`,hidden:!0});for(let f of l.sections??[l]){let d=E("section",{class:"section"},E("h2",{text:f.title}));u.append(d),f.build(d,u)}let h=E("button",{type:"button",role:"tab",id:`tab-${l.id}`,"aria-controls":u.id,text:l.title,on:{click:()=>c(l.id)}});return s.append(h),{...l,panel:u,tab:h}});function c(l){r.matches&&l==="move"&&(l="inverse"),o.set(P.panel,t.scrollTop),P.panel=l;for(let u of a){let h=r.matches&&u.id==="move",f=u.id===l||h;(h?e:t).append(u.panel),u.panel.hidden=!f,u.tab.hidden=h,u.tab.setAttribute("aria-selected",String(u.id===l)),u.tab.tabIndex=u.id===l?0:-1,u.id===l&&(document.getElementById("room").dataset.panel=l,document.getElementById("room").classList.toggle("wide",!!u.wide))}Dt("panel",l),t.scrollTop=o.get(l)??0}return s.addEventListener("keydown",l=>{let u={ArrowDown:1,ArrowUp:-1,ArrowRight:1,ArrowLeft:-1}[l.key];if(!u)return;l.preventDefault();let h=a.filter(g=>!g.tab.hidden),f=h.findIndex(g=>g.id===P.panel),d=h[(f+u+h.length)%h.length];c(d.id),d.tab.focus()}),r.addEventListener("change",()=>c(P.panel==="move"||!a.some(l=>l.id===P.panel)?"move":P.panel)),c(P.panel),c}function Eb(n){let t=E("div",{class:"group",role:"group","aria-label":"Views"},[["iso","Iso"],["front","Front"],["side","Side"],["top","Top"]].map(([l,u])=>E("button",{type:"button",text:u,on:{click:()=>nm(l)}})),E("button",{type:"button",text:"Fit",on:{click:()=>mc()}})),e=E("div",{class:"group frames",role:"group","aria-label":"Frames shown","data-testid":"frames"}),i=E("button",{type:"button",text:"Trace","aria-pressed":"true",on:{click:()=>{let l=i.getAttribute("aria-pressed")!=="true";i.setAttribute("aria-pressed",String(l)),Ty(l)}}}),s=E("button",{type:"button",text:"Clear","aria-label":"Clear the trace",on:{click:Sf}}),r=E("span",{class:"scale"}),o=E("div",{class:"key","aria-label":"Axes: x red, y green, z blue"},["x","y","z"].map((l,u)=>{let h=E("span",{class:"dot"});return h.style.setProperty("background",ur[u]),E("span",{},h,l)}),r);n.append(E("div",{class:"corner top"},t,E("div",{class:"group",role:"group","aria-label":"Trace of the tool"},i,s)),E("div",{class:"corner bottom"},o,e));let a=-2,c=()=>{let l=P.table.joints.length,u=Array.from({length:l+2},(f,d)=>d);P.shownFrames=(P.shownFrames??[0,l+1]).map(f=>f===a+1?l+1:f).filter(f=>f<l+2),a=l;let h=f=>{P.shownFrames=f,c()};te(e,E("span",{class:"group-name",text:"Frames"}),u.map(f=>E("button",{type:"button",text:Mf(f),"aria-pressed":String(P.shownFrames.includes(f)),"aria-label":`Frame ${Mf(f)}`,on:{click:()=>h(P.shownFrames.includes(f)?P.shownFrames.filter(d=>d!==f):[...P.shownFrames,f])}})),E("button",{type:"button",text:P.shownFrames.length===l+2?"none":"all","aria-label":"All frames or none",on:{click:()=>h(P.shownFrames.length===l+2?[]:u)}})),Dt("frames"),Ut(r,`grid ${$e(sm.cell,"length",yt.length==="mm"?0:2)}`)};gt(["table","units"],c),c()}function Tb(){addEventListener("keydown",n=>{if(!(n.ctrlKey||n.metaKey)||n.altKey)return;let t=n.key.toLowerCase();n.target.matches?.("input[type=text]:not(.number), textarea")||(t==="z"&&!n.shiftKey?(n.preventDefault(),n.target.blur?.(),Om()):(t==="y"||t==="z"&&n.shiftKey)&&(n.preventDefault(),n.target.blur?.(),Bm()))})}function nd(n,t){let e=Array.from({length:16},(s,r)=>E("span",{role:"cell",class:r%4===3&&r<12?"p":r>=12?"last":""})),i=E("div",{class:"matrix",role:"table","aria-label":n,"data-testid":t},[0,4,8,12].map(s=>E("div",{role:"row",class:"matrix-row"},e.slice(s,s+4))));return i.show=s=>{for(let r=0;r<16;r++){let o=r%4===3&&r<12;Ut(e[r],r>=12?String(s[r]):o?Xn(s[r]*yt.factor("length"),yt.digits("length")):Xn(s[r],4))}},i}var id=n=>[0,4,8,12].map(t=>`[${n.slice(t,t+4).map(e=>Number(e.toPrecision(12))+0).join(", ")}]`).join(`,
`);var Mg=()=>P.frames[P.frames.length-1],Rb={id:"pose",title:"Pose",build(n){let t=nd("Pose of the tool in the base frame","pose"),e=["X","Y","Z"].map(u=>Ab(u,"length",`pose-${u.toLowerCase()}`)),i=E("div",{class:"quantities","data-testid":"orientation"}),s=E("p",{class:"hint order"}),r=[],o=jn("Notation of the orientation",Object.entries(ds).map(([u,h])=>[u,h.title]),P.notation,u=>{P.notation=u,Dt("notation")}),a=E("span",{class:"copies"},E("button",{type:"button",class:"quiet",text:"Copy matrix",title:"As numbers in metres, row by row",on:{click:()=>eo(id(Mg()))}}),E("button",{type:"button",class:"quiet",text:"Copy numbers",title:"Position and orientation, in the units shown",on:{click:()=>eo(DP())}}));n.append(E("div",{class:"subhead"},E("span",{text:"Tool in the base frame"}),a),t,E("div",{class:"quantities"},e.map(u=>u.el)),E("div",{class:"line"},o,s),i);let c=()=>{let u=ds[P.notation];o.value=P.notation,Ut(s,u.order),r=u.names.map((h,f)=>Ab(h,u.kinds[f],`turn-${f}`)),te(i,r.map(h=>h.el)),l()},l=()=>{let u=Mg();t.show(u),ye(u).forEach((h,f)=>e[f].show(h)),ds[P.notation].to(u).forEach((h,f)=>r[f].show(h))};gt("q",l),gt("notation",c),gt("units",()=>{e.forEach(u=>u.relabel()),r.forEach(u=>u.relabel()),l()}),c()}};function DP(){let n=Mg(),t=ds[P.notation],e=ye(n).map((s,r)=>`${"XYZ"[r]} ${_i(s,"length")} ${yt.symbol("length")}`),i=t.to(n).map((s,r)=>`${t.names[r]} ${t.kinds[r]==="angle"?`${_i(s,"angle")} ${yt.symbol("angle")}`:Xn(s,5)}`);return`${e.join(", ")}; ${i.join(", ")} (${t.order})`.replaceAll("\u2212","-")}function Ab(n,t,e){let i=E("output",{"data-testid":e}),s=E("span",{class:"unit",text:yt.symbol(t)});return{el:E("div",{class:"quantity"},E("span",{class:"quantity-name",text:n}),i,s),show:o=>Ut(i,t==="plain"?Xn(o,5):_i(o,t)),relabel:()=>Ut(s,yt.symbol(t))}}function NP(n,t){let e=[],i=n.joints.length,s=to(n,t),r=o=>n.convention==="standard"?n.joints[o].alpha:n.joints[o+1]?.alpha;for(let o=0;o<i-1;o++){let a=Qr(n.joints[o],s[o]).theta,c=1,l=`${o+1}`;for(let u=o;u<i-1;u++){let h=r(u);if(Math.abs(Math.sin(h))>1e-9||n.joints[u+1].type!=="R"||n.joints[o].type!=="R")break;c*=Math.sign(Math.cos(h)),a+=c*Qr(n.joints[u+1],s[u+1]).theta,l+=`${c>0?"":"\u2212"}${u+2}`,e.push({name:l,value:a})}}return e}var Cb={id:"matrices",title:"Matrices",wide:!0,build(n){let t="links",e="now",i=0,s=0,r=[],o=E("div",{class:"cards","data-testid":"matrices"}),a=E("table",{class:"plain","data-testid":"angles","aria-label":"Intermediate angles"}),c=jn("Posture",[["now","present posture"]],"now",g=>{e=g,f()}),l=E("span",{class:"partial"});n.append(E("div",{class:"line"},xn("Matrices shown",[["links","Each A"],["products","Products from the base"],["partial","Between two frames"]],t,g=>{t=g,h()},"matrix-mode"),l),E("div",{class:"line"},E("span",{class:"field-name",text:"Numbers of the"}),c),o,E("h3",{text:"Intermediate angles"}),E("p",{class:"hint",text:"Each \u03B8 with the maker\u2019s sign and zero put in, and the sums of neighbouring joints whose axes are parallel, as a derivation uses them."}),a);let u=()=>e!=="now"&&P.solutions?.rows[Number(e)]?.q||P.q,h=()=>{let g=P.table.joints.length;i=Math.min(i,g),s=s===0||s>g?g:s;let _=t==="links"?P.table.joints.map((m,x)=>["A",String(x+1),""]):t==="products"?P.table.joints.map((m,x)=>["T",String(x+1),"0"]):[["T",String(s),String(i)]];t==="links"&&_.push(["T","tool","base"]);let p=Array.from({length:g+1},(m,x)=>[String(x),String(x)]);te(l,t==="partial"?[jn("From frame",p,String(i),m=>{i=Number(m),h()})," \u2192 ",jn("To frame",p,String(s),m=>{s=Number(m),h()})]:[]),r=_.map(([m,x,M])=>({grid:nd(`${m} ${M} ${x}`,`matrix-${m}${M}${M?"-":""}${x}`),note:E("span",{class:"hint"}),sym:m,low:x,high:M})),te(o,r.map(({grid:m,note:x,sym:M,low:v,high:A})=>E("figure",{class:"card"},E("figcaption",{},E("span",{class:"symbol"},A?E("sup",{text:A}):null,E("i",{text:M}),E("sub",{text:v})),x),m))),f()},f=wr(()=>{if(n.closest(".panel").hidden||!P.table.joints.length)return;let g=u(),_=t0(P.table,g),p=_.length;r.forEach(({grid:M,note:v},A)=>{if(t==="links"&&A<p)M.show(_[A]),Ut(v,`q${A+1} = ${$e(g[A],on(P.table.joints[A]))}`);else if(t==="links")M.show($s(P.table,g)[p+1]);else if(t==="products")M.show(_.slice(0,A+1).reduce(Xs,qs()));else{let S=y=>_.slice(0,y).reduce(Xs,qs());M.show(Xs(jg(S(i)),S(s)))}});let m=to(P.table,g),x=P.table.joints.map((M,v)=>[M.type==="R"?`\u03B8${v+1}`:`d${v+1}`,M.type==="R"?_i(Qr(M,m[v]).theta,"angle"):_i(Qr(M,m[v]).d,"length"),M.type==="R"?"angle":"length"]).concat(NP(P.table,g).map(({name:M,value:v})=>[`\u03B8${M}`,_i(v,"angle"),"angle"]));te(a,E("tbody",{},x.map(([M,v,A])=>E("tr",{},E("th",{scope:"row"},E("i",{text:M[0]}),E("sub",{text:M.slice(1)})),E("td",{text:v}),E("td",{class:"unit",text:yt.symbol(A)})))))}),d=()=>{if(n.closest(".panel").hidden)return;let g=P.solutions?.rows??[];te(c,E("option",{value:"now",text:"present posture"}),g.map((_,p)=>E("option",{value:String(p),text:`solution ${p+1}: ${_.label??""}`}))),e!=="now"&&!g[Number(e)]&&(e="now"),c.value=e,f()};gt("table",h),gt(["q","units","panel"],f),gt(["solutions","panel"],d),h()}};var UP=.002;function Io(n,t,e,i){let s=[],r="",o=E("div",{class:"pose-fields"}),a=()=>{let l=ds[P.notation],u=[["X","length"],["Y","length"],["Z","length"],...l.names.map((f,d)=>[f,l.kinds[d]])],h=()=>{let f=zx(P.notation,s.slice(3).map(d=>d.value),s.slice(0,3).map(d=>d.value));f&&i(f,FP(s))};s=u.map(([f,d],g)=>{let _={value:0,kind:d},p=(m,x)=>{_.value=m,_.text=x.text,h()};return _.f=Ti({label:`${n}, ${f}`,kind:d,testid:`${t}-${g}`,input:p,commit:(m,x)=>{p(m,x),Dt("let-go")}}),_.el=E("label",{class:"pose-field"},E("span",{text:f}),_.f,E("span",{class:"unit",text:yt.symbol(d)})),_}),te(o,s.map(f=>f.el)),r=P.notation},c=()=>{r!==P.notation&&a();let l=e();!l||o.contains(document.activeElement)||[...ye(l),...ds[P.notation].to(l)].forEach((u,h)=>{s[h].value=u,s[h].text=null,s[h].f.put(u,OP(u,s[h].kind))})};return gt("units",()=>{a(),c()}),gt("notation",c),a(),c(),o.addEventListener("paste",l=>{let u=Jf(l.clipboardData.getData("text"))?.flat(),h=s.findIndex(f=>f.f===l.target);!u||h<0||(l.preventDefault(),Kf([s.map(f=>f.f)],0,u.length===s.length?0:h,[u]))}),o.addEventListener("focusout",()=>{setTimeout(c)}),{el:E("fieldset",{class:"pose-editor"},E("legend",{text:n}),o),show:c}}function FP(n){let t=s=>s.map(r=>r.text??""),e=n.slice(3).filter(s=>s.kind==="angle"),i=e.length>1?Ia(t(e),"angle"):2*Ia(t(n.slice(3)),"plain");return{metres:Ia(t(n.slice(0,3)),"length"),radians:i}}var OP=(n,t)=>String(Number((n*yt.factor(t)).toFixed(t==="plain"||yt[t]==="m"||yt[t]==="rad"?6:3))+0);function Pb(n){let t=n.match(Ib)??[],e=t.filter((s,r)=>r%4===3&&r<12),i=t.filter((s,r)=>r%4!==3&&r<12);return{metres:Ia(e,"length"),radians:2*Ia(i,"plain")}}var Ib=/[-+−]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?/g;function Lb(n){let t=(n.replaceAll("\u2212","-").match(Ib)??[]).map(Number);if(t.length!==16&&t.length!==12)throw new Error(`${t.length===1?"1 number was":`${t.length} numbers were`} found; a pose has 16 (four rows) or 12 (three rows)`);let e=t.length===16?t:[...t,0,0,0,1];if(Math.abs(e[12])+Math.abs(e[13])+Math.abs(e[14])+Math.abs(e[15]-1)>1e-9)throw new Error("the last row must be 0 0 0 1");if(!e.every(Number.isFinite))throw new Error("a number is not finite");let i=Oc(e);if(i>UP)throw new Error(i===1/0?"the upper left block is left-handed, so it is no rotation":`the upper left block is no rotation: its rows miss being perpendicular unit vectors by ${i.toPrecision(2)}`);for(let s of[3,7,11])e[s]/=yt.factor("length");return Bc(e)}function sd(n){return n.map((t,e)=>{let i=P.table.joints[e];if(i.type!=="R")return t;let s=t+2*Math.PI*Math.round((P.q[e]-t)/(2*Math.PI));return(i.lower===null||s>=i.lower-1e-9)&&(i.upper===null||s<=i.upper+1e-9)?s:t})}function Db(n,t){let e=t?.self_motions??[],i=de.task??P.plan?.task,s=i==="pose";n.classList.toggle("stale",t?.self_motions===null);for(let f of n.querySelectorAll("input"))f.disabled=t?.self_motions===null;if(t?.self_motions===null&&n.childElementCount)return;let r=t?.self_motions===null?"pending":t?.self_motions;if(n.drawn===r)return;if(n.drawn=r,r==="pending"){te(n,E("p",{class:"hint",text:"Following the self-motions of this pose \u2026"}));return}let o=i==="position"?"the tool point stands still":i==="pose"?"the tool stands still":"the tool point and its axis stand still",a=f=>f.dimension>1?`one line in a surface of ${f.dimension} dimensions`:f.closed?"a closed curve":"an open curve",c=(f,d)=>{let g=f.moves.length>3?"most of its joints":f.moves.join(" and "),_=f.inside.length?HP(f):"All of it lies outside the limits.";return E("div",{class:"self-motion"},E("p",{},E("strong",{text:e.length>1?`Self-motion ${d+1} of ${e.length}`:"Self-motion"}),` by ${g}, ${a(f)}: the arm moves, ${o}. ${_}`),VP(f,d,t.T,s))},l=e.length?kP(e):-1,u=e.map((f,d)=>d===l?null:c(f,d)).filter(Boolean),h=u.length?E("details",{class:"fold"},E("summary",{text:u.length===1?"One other self-motion":`${u.length} other self-motions`}),u):null;te(n,l>=0?c(e[l],l):null,h)}var BP=n=>n.reduce((t,e,i)=>t+Math.sin((e-P.q[i])/2)**2,0),kP=n=>{let t=n.map(e=>Math.min(...e.q.map(BP)));return t.indexOf(Math.min(...t))};function zP(n){let t=(s,r)=>s.map((o,a)=>P.table.joints[a]?.type==="P"?o-r[a]:Math.atan2(Math.sin(o-r[a]),Math.cos(o-r[a]))),e=n.s[0],i=1/0;for(let s=0;s+1<n.q.length;s++){let r=t(n.q[s+1],n.q[s]),o=t(P.q,n.q[s]),a=r.reduce((u,h)=>u+h*h,0),c=a>0?Math.min(Math.max(r.reduce((u,h,f)=>u+h*o[f],0)/a,0),1):0,l=r.reduce((u,h,f)=>u+(o[f]-c*h)**2,0);l<i&&([i,e]=[l,n.s[s]+c*(n.s[s+1]-n.s[s])])}return e}var HP=({inside:n})=>n.length===1&&n[0][0]<=1e-9&&n[0][1]>=1-1e-9?"":`Inside the limits: ${n.map(([t,e])=>`${(100*t).toFixed(1)} to ${(100*e).toFixed(1)} %`).join(", ")} of it.`;function GP(n){let t=[],e=0;for(let[i,s]of n)t.push(`var(--wrong-soft) ${100*e}% ${100*i}%`,`var(--good) ${100*i}% ${100*s}%`),e=s;return t.push(`var(--wrong-soft) ${100*e}% 100%`),`linear-gradient(to right, ${t.join(", ")})`}function VP(n,t,e,i){let s=E("input",{type:"range",min:"0",max:"1",step:"any",value:"0","aria-label":`Along self-motion ${t+1}`,"data-testid":`self-motion-${t+1}`}),r=()=>{xi();let o=Number(s.value),a=Math.max(n.s.findLastIndex(h=>h<=o),0),c=Math.min(a+1,n.q.length-1),l=c>a?(o-n.s[a])/(n.s[c]-n.s[a]):0;s.style.setProperty("--at",`${100*o}%`);let u=n.q[a].map((h,f)=>h+l*(n.q[c][f]-h));Dt("did",{label:"slide along a self-motion",key:"self-motion"}),Xi(sd(i?e0(P.table,u,e):u),"self-motion")};return s.value=String(zP(n)),s.style.setProperty("--at",`${100*Number(s.value)}%`),s.classList.add("parts"),s.style.setProperty("--parts",GP(n.inside)),s.dataset.inside=JSON.stringify(n.inside),s.addEventListener("input",r),s.addEventListener("keydown",o=>{let a={ArrowRight:1,ArrowUp:1,ArrowLeft:-1,ArrowDown:-1,PageUp:10,PageDown:-10}[o.key];if(!a)return;o.preventDefault();let c=Number(s.value)+a/100;s.value=String(n.closed?c-Math.floor(c):Math.min(Math.max(c,0),1)),r()}),s}function Nb(){let n=[],t=[],e={},i=E("div",{class:"joints"}),s=E("details",{},E("summary",{class:"hint",text:"Hold by value"}),i),r=E("p",{class:"hint"}),o=xn("Redundant coordinates",[["free","Free"],["chosen","Chosen"]],"free",d=>c(d==="chosen"?n.filter(g=>!g.instead).map(g=>g.name):null),"spare-mode"),a=E("div",{class:"spare",role:"group","aria-label":"Redundant coordinates of the arm","data-testid":"spare",hidden:!0},E("div",{class:"line spread"},E("span",{class:"field-name",text:"Redundant coordinates"}),o),r,s);function c(d,{sliding:g=!1}={}){Dt("did",{label:d?`hold ${d.join(" and ")}`:"free the redundant coordinates",key:"spare"}),de.redundancy=d&&Object.fromEntries(d.map(_=>[_,e[_]])),f(),g?Cy():ps({follow:!0})}let l=d=>n.filter(g=>g.instead===d.instead).map(g=>g.name),u=d=>P.table.joints.findIndex(g=>g.name===d.name);function h(d,g){let _=d.kind==="angle"?Math.PI:Mr(P.table),p=d.lower??-_,m=d.upper??_,x=E("input",{type:"range",min:String(p),max:String(m),step:"any","aria-label":`Slide ${d.name}`,"data-testid":`spare-slider-${g+1}`}),M=!1,v=(w,U)=>{e[d.name]=w,c(l(d),{sliding:U})};x.addEventListener("input",()=>v(Number(x.value),!0)),x.addEventListener("change",()=>ps({follow:!0})),x.addEventListener("keydown",w=>{let U={ArrowRight:1,ArrowUp:1,ArrowLeft:-1,ArrowDown:-1,PageUp:10,PageDown:-10}[w.key];if(U===void 0)return;w.preventDefault(),M=!0;let L=U*yt.step(d.kind)*(w.shiftKey?.1:1);v(Math.min(Math.max(e[d.name]+L,p),m),!0)}),x.addEventListener("keyup",()=>{M&&ps({follow:!0}),M=!1});let A=Ti({label:`Value of ${d.name}`,kind:d.kind,testid:`spare-${g+1}`,check:w=>w<p-1e-9&&d.lower!==null?`below the limit ${$e(p,d.kind)}`:w>m+1e-9&&d.upper!==null?`above the limit ${$e(m,d.kind)}`:null,commit:w=>v(w,!1)}),S=E("span",{class:"limits"}),y=E("div",{class:"joint"},E("span",{class:"joint-name",text:d.name}),E("div",{class:"track"},x,E("div",{class:"under"},S)),A,E("span",{class:"unit"}));return{line:y,show(){let w=e[d.name];x.value=w,x.style.setProperty("--at",`${100*(Math.min(Math.max(w,p),m)-p)/(m-p||1)}%`),x.setAttribute("aria-valuetext",$e(w,d.kind)),y.classList.toggle("held",!!(de.redundancy&&d.name in de.redundancy)),A.put(Number((w*yt.factor(d.kind)).toFixed(yt.digits(d.kind)+1))/yt.factor(d.kind))},relabel(){Ut(y.lastChild,yt.symbol(d.kind));let w=U=>U===null?"no limit":$e(U,d.kind,d.kind==="angle"&&yt.angle==="deg"?0:void 0);Ut(S,d.lower===null&&d.upper===null?"no limits":`${w(d.lower)} \u2026 ${w(d.upper)}`),A.refresh()}}}function f(){for(let d of n)de.redundancy&&d.name in de.redundancy?e[d.name]=de.redundancy[d.name]:u(d)>=0?e[d.name]=P.q[u(d)]:d.instead&&Number.isFinite(P.solutions?.arm_angle)?e[d.name]=P.solutions.arm_angle:e[d.name]??=0;o.mark(de.redundancy?"chosen":"free"),Ut(r,de.redundancy?"Held at these values; what is left has separate solutions.":"Free: the solutions form self-motions; the table has those at the present values.");for(let d of t)d.show()}return gt("solutions",()=>{let d=P.solutions?.spare;if(!P.solutions||!d&&(P.solutions.brief||P.solutions.status==="REFUSED"))return;let g=JSON.stringify(d??[])!==JSON.stringify(n);if(g){n=d??[],e={},t=n.map(h),te(i,t.map(_=>_.line));for(let _ of t)_.relabel()}a.hidden=n.length===0,g&&(s.open=n.filter(_=>!_.instead).length>1||!!de.redundancy),f()}),gt("q",()=>!a.hidden&&!a.closest("[hidden]")&&!de.redundancy&&f()),gt("units",()=>{for(let d of t)d.relabel();f()}),a}function Ub(){let n=E("thead"),t=E("tbody"),e=E("p",{class:"hint below",text:"Grey rows lie outside the limits; the joints in red exceed them."}),i=E("div",{class:"scroll"},E("table",{class:"plain solutions","data-testid":"solutions","aria-label":"Solutions"},n,t),e),s=[],r="",o=()=>{let c=`${P.table.joints.map(l=>l.type).join("")}${yt.angle}${yt.length}`;c!==r&&(r=c,s=[],te(t),te(n,E("tr",{},E("th",{text:""}),E("th",{class:"left",text:"posture"}),P.table.joints.map((l,u)=>E("th",{},E("i",{text:"q"}),E("sub",{text:String(u+1)}),E("span",{class:"unit",text:` ${yt.symbol(on(l))}`}))),E("th",{text:"off, mm",title:"By how much forward kinematics misses the pose"}))))},a=c=>{let l=P.table.joints.map(()=>E("td")),u=E("span"),h=E("span",{class:"offscreen"}),f=E("td",{class:"unit"}),d=E("tr",{tabindex:"0","data-testid":`solution-${c+1}`},E("th",{scope:"row",text:String(c+1)}),E("td",{class:"left"},u,h),l,f),g=()=>P.solutions?.rows[c]?.q,_=()=>g()&&Na(g()),p=()=>Na(null),m=()=>{g()&&(Na(null),ms(sd(g()),.8,`move to solution ${c+1}`))};return d.addEventListener("pointerenter",_),d.addEventListener("pointerleave",p),d.addEventListener("focus",_),d.addEventListener("blur",p),d.addEventListener("click",m),d.addEventListener("keydown",x=>{(x.key==="Enter"||x.key===" ")&&(x.preventDefault(),m())}),{tr:d,cells:l,label:u,beyond:h,residual:f}};return{el:i,show(c){o();let l=c?.rows??[];for(;s.length<l.length;){let u=a(s.length);s.push(u),t.append(u.tr)}i.hidden=l.length===0,e.hidden=l.every(u=>u.inside),s.forEach((u,h)=>{let f=l[h];u.tr.hidden=!f,f&&(u.tr.classList.toggle("beyond",!f.inside),f.label!==null&&Ut(u.label,`${f.label}${f.self_motion>=0?" (of a self-motion)":""}`),Ut(u.beyond,f.inside?"":", outside the limits"),Ut(u.residual,f.residual?lf(f.residual[0]*1e3):""),u.residual.title=f.residual?`${lf(f.residual[0])} m, ${lf(f.residual[1])} rad by forward kinematics`:"",f.q.forEach((d,g)=>{let _=P.table.joints[g],p=_.lower!==null&&d<_.lower-1e-9||_.upper!==null&&d>_.upper+1e-9;Ut(u.cells[g],_i(d,on(_))),u.cells[g].classList.toggle("out",p)}))}),this.mark()},mark(){let c=P.solutions?.rows??[];s.forEach((l,u)=>l.tr.classList.toggle("here",!!c[u]&&c[u].q.length===P.q.length&&c[u].q.every((h,f)=>Math.abs(Math.sin((h-P.q[f])/2))<1e-5)))}}}var WP={SOLVED:"good",SINGULAR:"note",REDUNDANT:"note",OUT_OF_REACH:"wrong",OUTSIDE_LIMITS:"wrong",UNCERTAIN:"wrong",REFUSED:"wrong"},Sg={OUT_OF_REACH:"Out of reach",OUTSIDE_LIMITS:"Outside the limits",UNCERTAIN:"Not certain",REFUSED:"Refused"},qP=new Set(["REDUNDANT","UNCERTAIN"]),wg=120;function Eg(){Di(P.frames[P.frames.length-1].slice(),"taken")}var Ob={id:"inverse",title:"Inverse",wide:!0,build(n,t){n.append(E("div",{class:"line spread"},E("button",{type:"button",text:"Take the present pose","data-testid":"take-pose",on:{click:Eg}}),xn("Target as",[["numbers","Position and angles"],["matrix","Matrix"]],"numbers",_=>{i.hidden=_!=="numbers",s.hidden=_!=="matrix"},"target-as")));let e=Io("Target","target",()=>P.target,(_,p)=>Di(_,"typed",p)),i=E("div",{},e.el),{el:s,show:r}=$P();n.append(i,s,YP());let o=E("p",{class:"verdict","data-testid":"ik-verdict",role:"status"}),a=E("div",{class:"near","data-testid":"ik-nearest"}),c=E("div",{class:"self-motions","data-testid":"self-motions"}),l=Ub();n.append(Nb(),o,a,c,l.el);let u=Vc(wg,()=>{e.show(),r()}),h=Vc(wg,()=>{if(t.hidden)return;let _=P.solutions;ZP(o,_),jP(a,_),Db(c,_),l.show(_)}),f=Vc(wg,()=>l.mark()),d=_=>()=>pf()?_.soon():_();gt("target",d(u)),gt("notation",e.show),gt(["solutions","units"],d(h)),gt("q",d(f));let g=()=>Mo("target",P.panel==="inverse"?XP(ye(P.target)):[]);gt("target",_=>_!=="drag"&&g()),gt("panel",_=>{sy(_==="inverse"),(_!=="inverse"||P.hasTarget)&&g(),_==="inverse"&&(P.hasTarget?Dt("solutions"):(P.hasTarget=!0,Eg()))}),gt("table",_=>{_==="new"&&(P.hasTarget=P.panel==="inverse",P.hasTarget&&Eg())})}};function XP(n){let t=.25*Mr(P.table);return[0,1,2].flatMap(e=>[t,-t].map(i=>n.map((s,r)=>r===e?s+i:s)))}function $P(){let n=E("textarea",{rows:"4","aria-label":"Target as a matrix","data-testid":"target-matrix",spellcheck:"false"}),t=E("p",{class:"reason",role:"alert"}),e=E("p",{class:"hint"});n.addEventListener("input",()=>{try{Di(Lb(n.value),"typed",Pb(n.value)),Ut(t,""),n.removeAttribute("aria-invalid")}catch(s){Ut(t,s.message),n.setAttribute("aria-invalid","true")}});let i=()=>{if(Ut(e,`Twelve or sixteen numbers, row by row; the last column in ${yt.length}.`),document.activeElement===n)return;let s=P.target.map((r,o)=>o%4===3&&o<12?r*yt.factor("length"):r);n.value=id(s.map(r=>Number(r.toFixed(6)))).replaceAll(`,
`,`
`)};return gt("units",i),i(),{el:E("div",{hidden:!0},n,e,t),show:i}}function YP(){let n=E("span",{class:"line"}),t=E("input",{type:"checkbox",checked:!0,"data-testid":"follow",on:{change:()=>{de.follow=t.checked}}});return gt("plan",()=>te(n,P.plan?.solvable?[E("span",{class:"field-name",text:"Task"}),jn("Task",[["",`${P.plan.task} (default)`],["pose","pose"],["position","position"],["position+axis","position + axis"]],de.task??"",e=>{Dt("did",{label:"choose the task"}),de.task=e||null,de.redundancy=null,ps()},{"data-testid":"task"})]:[])),E("div",{class:"line controls"},E("span",{class:"line"},E("span",{class:"field-name",text:"Handles"}),xn("Handles",[["both","Both"],["move","Move"],["turn","Turn"]],"both",ry)),xn("Axes of the handles",[["local","Tool"],["world","World"]],"local",oy),E("span",{class:"line"},E("span",{class:"field-name",text:"Snap"}),jn("Snap to whole steps",[["0","off"],["1","1 mm, 1\xB0"],["5","5 mm, 5\xB0"],["10","10 mm, 10\xB0"],["45","45 mm, 45\xB0"]],"0",e=>ay(Number(e)),{"data-testid":"snap",title:"While dragging; Shift snaps to 5 at any time"})),E("span",{class:"line"},E("span",{class:"field-name",text:"Ghosts"}),xn("Ghosts",[["all","All"],["inside","In limits"],["none","None"]],"all",e=>{de.ghosts=e,Ua()})),E("label",{class:"check"},t,"Arm follows"),n)}function ZP(n,t){if(!t){te(n,E("span",{text:"Solving \u2026"})),n.dataset.tone="note";return}let e=t.rows.length,i=t.rows.filter(o=>o.inside).length;n.dataset.tone=WP[t.status]??"note";let s=t.status==="SOLVED"&&e?Fb(t.missed):[t.why,Fb(t.missed)].filter(Boolean).join(" "),r=Sg[t.status]&&!i?t.why.toLowerCase().includes(Sg[t.status].toLowerCase())?"":Sg[t.status]:qP.has(t.status)&&i===e?"":`${e} solution${e===1?"":"s"}${i===e?"":`, ${i} inside the limits`}`;te(n,E("strong",{text:r})," ",E("span",{text:s}),t.ms===void 0?null:E("span",{class:"hint took",text:`${t.ms<1?`${Math.round(t.ms*1e3)} \xB5s`:`${t.ms.toFixed(1)} ms`}`}))}var Fb=n=>n?`The pose was rounded by ${KP(n)||"less than its digits"} when typed; solved is the nearest one that the arm takes.`:"",JP=(n,t)=>$e(n,t,yt.digits(t)+2),KP=n=>[[n.metres,"length"],[n.radians,"angle"]].filter(([t,e])=>t*yt.factor(e)>=.5*10**-(yt.digits(e)+2)).map(([t,e])=>JP(t,e)).join(" and ");function jP(n,t){let e=t?.near;if(!e){te(n);return}let i=ye(e.T).map(s=>_i(s,"length")).join(", ");te(n,E("p",{},E("strong",{text:"Nearest reachable: "}),`${i} ${yt.symbol("length")}, ${$e(e.metres,"length")} away`,e.radians>.001?`, turned by ${$e(e.radians,"angle")}`:""),E("div",{class:"line"},E("button",{type:"button",text:"Go there",on:{click:()=>ms(e.q)}}),E("button",{type:"button",text:"Make it the target",on:{click:()=>Di(e.T,"chosen")}})))}var Tg=(n,t)=>{let e=Math.cos(t),i=Math.sin(t);return[1,0,0,n,0,e,-i,0,0,i,e,0,0,0,0,1]};function rd(n){return Tg(n[3],Math.atan2(n[9],n[5])).every((e,i)=>Math.abs(e-n[i])<1e-12)?{a:n[3],alpha:Math.atan2(n[9],n[5])+0}:null}function od(n,t){if(n.convention===t||!n.joints.length)return{...n,convention:t};let e=n.joints,i=e.length,s=e.map(({a:c,alpha:l,text:u})=>({a:c,alpha:l,text:u})),{base:r,tool:o}=n,a;if(t==="modified"){let c=rd(r)??{a:0,alpha:0};rd(r)&&(r=qs()),o=Xs(Tg(s[i-1].a,s[i-1].alpha),o),a=[c,...s.slice(0,-1)]}else{let c=rd(o)??{a:0,alpha:0};rd(o)&&(o=qs()),r=Xs(r,Tg(s[0].a,s[0].alpha)),a=[...s.slice(1),c]}return{...n,convention:t,base:r,tool:o,joints:e.map((c,l)=>({...c,a:a[l].a,alpha:a[l].alpha,text:{...c.text,a:a[l].text?.a,alpha:a[l].text?.alpha}}))}}var Bb=30,QP=n=>({name:`joint_${n+1}`,type:"R",a:0,alpha:0,d:0,theta:0,lower:null,upper:null,sign:1,offset:0}),tI={a:"a",alpha:"\u03B1",d:"d",theta:"\u03B8",lower:"lower limit",upper:"upper limit",offset:"zero"},Ya=null;function kb(n,t){Ya={label:n,key:"paste",open:!0};try{t(Ya)}finally{Ya=null,Dt("let-go")}}function ad(n,t,e,{symbolic:i,text:s},r){let o=P.table.joints.map((u,h)=>h!==n?u:{...u,[t]:e,text:{...u.text,[t]:i?s:void 0}}),a=Object.is(P.table.joints[n][t],e)&&P.table.joints[n].text?.[t]===o[n].text[t],l={what:"cell",label:`edit ${tI[t]??t} of joint ${n+1}`,key:`${n}/${t}`,open:!0};a||_n({...P.table,joints:o},Ya?{...l,...Ya}:l),r&&!Ya&&Dt("let-go")}function Za(n,t,e,{key:i,open:s}={}){let{postures:r,coupling:o}=P.table,a=Object.fromEntries(Object.entries(r??{}).map(([u,h])=>[u,t(h,0)])),c=t(P.q,0),l=o?t(o,null).map((u,h)=>eI(u&&t(u,0),h,n.length)):null;_n({...P.table,joints:n,postures:a,coupling:l},{q:c,what:"rows",label:e,key:i,open:s})}var eI=(n,t,e)=>n??Array.from({length:e},(i,s)=>+(s===t));function zb(n,t,e){let i=P.table.joints[n];return e===null?null:t==="lower"&&i.upper!==null&&e>i.upper?"above the upper limit":t==="upper"&&i.lower!==null&&e<i.lower?"below the lower limit":null}function Ag({label:n,key:t,open:e}={}){let i=P.table.joints.length;return i>=Bb?(Rn(`At most ${Bb} joints.`,"wrong"),!1):(Za([...P.table.joints,QP(i)],(s,r)=>[...s,r],n??`add joint ${i+1}`,{key:t,open:e}),document.querySelector(`[data-testid="dh-${i+1}-a"]`)?.focus(),!0)}function Rg(n,t){let e=i=>{let s=i.slice();return[s[n],s[t]]=[s[t],s[n]],s};Za(e(P.table.joints),e,`swap joints ${n+1} and ${t+1}`)}async function ld(){try{Zs(`${P.table.name||"arm"}.toml`,(await Yn("save",{})).text,"application/toml")}catch(n){Rn(n.message,"wrong")}}async function Hb(n){let t=n.files[0];if(n.value="",!!t){if(t.size>2e5){Rn(`${t.name} has ${t.size} bytes; a robot file has at most 200,000.`,"wrong");return}try{let{table:e}=await Ys("open",{name:t.name.slice(-80),text:await t.text()});_n(e,{q:Vo(e),what:"new",label:`open ${t.name.slice(-40)}`})}catch(e){Rn(e.message,"wrong")}}}var Cg={geometry:[["a","a","length"],["alpha","\u03B1","angle"],["d","d","length"],["theta","\u03B8","angle"]],joint:[["lower","lower limit",null],["upper","upper limit",null],["offset","zero",null]]},nI=({catalog:n,...t})=>n?{...t,derived:n}:t,iI=n=>n.type==="R"?"angle":"length",Gb={id:"table",title:"DH table",wide:!0,build(n){let t="geometry",e=[],i=E("thead"),s=E("tbody"),r=E("table",{class:"dh","data-testid":"dh-table","aria-label":"DH table"},i,s),o=E("p",{class:"reason",role:"alert","data-testid":"dh-wrong"}),a=E("p",{class:"verdict","data-testid":"arm-kind"}),c=xn("Convention",[["standard","Standard"],["modified","Modified (Craig)"]],P.table.convention,M=>{M!==P.table.convention&&_n(od(P.table,M),{what:"rows",label:`make the table ${M}`})},"convention"),l=E("p",{class:"hint order"}),u=E("input",{type:"text","aria-label":"Name of the arm","data-testid":"arm-name",maxlength:"60",on:{change:()=>_n({...nI(P.table),name:u.value||"my-arm"},{what:"name",label:"name the arm"})}}),h=E("input",{type:"file",accept:".toml,.urdf,.xml",class:"offscreen","aria-label":"Robot file","data-testid":"robot-file",tabindex:"-1",on:{change:()=>Hb(h)}}),f=Io("Base","base",()=>P.table.base,M=>_n({...P.table,base:M},{what:"cell",label:"edit the base",key:"base",open:!0})),d=Io("Tool","tool",()=>P.table.tool,M=>_n({...P.table,tool:M},{what:"cell",label:"edit the tool",key:"tool",open:!0}));n.append(E("div",{class:"line spread"},E("span",{class:"line"},u),E("span",{class:"line"},E("button",{type:"button",text:"Blank",title:"An empty table",on:{click:()=>_n(n0(P.table.convention),{q:[],what:"new",label:"begin a blank table"})}}),E("button",{type:"button",text:"Open\u2026",title:"A robot file (.toml) or a URDF",on:{click:()=>h.click()}}),h,E("button",{type:"button",text:"Save",title:"As a robot file",on:{click:ld}}))),E("div",{class:"line spread"},c,xn("Columns",[["geometry","Geometry"],["joint","Limits and zeros"]],t,M=>{t=M,m()},"dh-part")),l,r,E("div",{class:"line"},E("button",{type:"button",class:"add",text:"+ Add joint","data-testid":"add-joint",on:{click:()=>Ag()}}),E("span",{class:"hint",text:"Numbers or expressions: pi/2, 90 deg, 0.5 m, 125+85. With pi, an angle is in radians. Arrows and Enter go from cell to cell, Alt and an arrow steps; a table can be pasted."})),o,a,E("details",{class:"fold","data-testid":"base-tool"},E("summary",{text:"Base and tool"}),f.el,d.el)),s.addEventListener("paste",M=>{let v=Jf(M.clipboardData.getData("text")),A=()=>[...s.rows].map(w=>[...w.querySelectorAll("input.number")]);if(!v||!M.target.matches("input.number"))return;M.preventDefault();let S=A().findIndex(w=>w.includes(M.target)),y=A()[S].indexOf(M.target);kb("paste a table",w=>{for(;P.table.joints.length<S+v.length&&Ag(w););let U=Kf(A(),S,y,v),L=v.flat().length;Rn(`Pasted ${U} number${U===1?"":"s"}${U<L?`; ${L-U} had no cell`:""}`)})}),n.addEventListener("verdict",M=>{let v=M.detail??sI(n);Ut(o,v?`${v.label}: ${v.reason}. The arm stays as it was.`:"")});let g=(M,v,[A,S,y])=>{let w=M.type==="R"&&A==="theta"||M.type==="P"&&A==="d",U=A==="lower"||A==="upper",L=Ti({label:`Joint ${v+1}, ${S}`,kind:y??iI(M),testid:`dh-${v+1}-${A}`,empty:U?null:void 0,check:N=>U?zb(v,A,N):N!==null&&Math.abs(N)>1e6?"larger than a million":null,input:(N,z)=>ad(v,A,N,z,!1),commit:(N,z)=>ad(v,A,N,z,!0)});return U&&(L.placeholder="none"),e.push({f:L,i:v,key:A}),E("td",{class:w?"variable":""},w?E("span",{class:"plus"},E("i",{text:"q"}),E("sub",{text:String(v+1)})," +"):null,L)},_=(M,v)=>E("button",{type:"button",class:`type type-${M.type}`,text:M.type,"data-testid":`dh-${v+1}-type`,"aria-label":`Joint ${v+1} is ${M.type==="R"?"revolute":"prismatic"}; press to change`,title:M.type==="R"?"Revolute: turns. Press for prismatic.":"Prismatic: slides. Press for revolute.",on:{click:()=>Za(P.table.joints.map((A,S)=>S===v?{...A,type:A.type==="R"?"P":"R",lower:null,upper:null,offset:0,text:{...A.text,lower:void 0,upper:void 0,offset:void 0}}:A),A=>A.map((S,y)=>y===v&&typeof S=="number"?0:S),`make joint ${v+1} ${M.type==="R"?"prismatic":"revolute"}`)}}),p=(M,v)=>E("td",{class:"tools"},E("button",{type:"button",class:"icon",text:"\u2191","aria-label":`Move joint ${M+1} up`,disabled:M===0,on:{click:()=>Rg(M,M-1)}}),E("button",{type:"button",class:"icon",text:"\u2193","aria-label":`Move joint ${M+1} down`,disabled:M===v-1,on:{click:()=>Rg(M,M+1)}}),E("button",{type:"button",class:"icon",text:"\xD7","aria-label":`Remove joint ${M+1}`,on:{click:()=>Za(P.table.joints.filter((A,S)=>S!==M),A=>A.filter((S,y)=>y!==M),`remove joint ${M+1}`)}})),m=()=>{e=[];let{joints:M}=P.table,v=P.table.convention==="modified",A=t==="geometry"?Cg.geometry.map(([S,y,w])=>E("th",{scope:"col"},E("i",{text:y}),E("sub",{text:v&&(S==="a"||S==="alpha")?"i\u22121":"i"}),E("span",{class:"unit",text:` ${yt.symbol(w)}`}))):["name","lower limit","upper limit","zero","sense"].map(S=>E("th",{scope:"col",text:S}));te(i,E("tr",{},E("th",{scope:"col",text:"i"}),E("th",{scope:"col","aria-label":"type"}),A,E("th",{"aria-label":"row tools"}))),te(s,M.map((S,y)=>{let w=t==="geometry"?Cg.geometry.map(U=>g(S,y,U)):[E("td",{},E("input",{type:"text",class:"name",value:S.name,maxlength:"40","aria-label":`Joint ${y+1}, name`,on:{change:U=>ad(y,"name",U.target.value||`joint_${y+1}`,{},!0)}})),...Cg.joint.map(U=>g(S,y,U)),E("td",{},E("button",{type:"button",class:"type",text:S.sign>0?"+":"\u2212","aria-label":`Joint ${y+1}, sense of the maker: ${S.sign>0?"as the table":"against the table"}`,on:{click:()=>Za(P.table.joints.map((U,L)=>L===y?{...U,sign:-U.sign}:U),U=>U,`turn the sense of joint ${y+1}`)}}))];return E("tr",{"data-testid":`dh-row-${y+1}`},E("th",{scope:"row",text:String(y+1)}),E("td",{},_(S,y)),w,p(y,M.length))})),M.length||s.append(E("tr",{},E("td",{colspan:"7",class:"hint",text:"No joints yet."}))),x()},x=()=>{for(let{f:M,i:v,key:A}of e){let S=P.table.joints[v];M.put(S[A],S.text?.[A]??null)}c.mark(P.table.convention),Ut(l,P.table.convention==="standard"?"A\u1D62 = Rz(\u03B8) Tz(d) Tx(a) Rx(\u03B1)":"A\u1D62 = Rx(\u03B1) Tx(a) Rz(\u03B8) Tz(d), each row with the a and \u03B1 before its joint"),document.activeElement!==u&&(u.value=P.table.name),f.show(),d.show()};gt("table",M=>{Ut(o,""),M==="cell"||M==="name"||M==="postures"?x():m()}),gt("units",m),gt("notation",()=>{f.show(),d.show()}),gt("plan",()=>{a.dataset.tone=P.plan?.solvable?"good":"wrong",te(a,E("strong",{text:qc(P.plan)||(P.plan?.refused?"Refused":"Not solved")})," ",E("span",{text:P.plan?.explain??""}))}),m()}};function sI(n){let t=n.querySelector(".number.wrong");return t?{label:t.getAttribute("aria-label"),reason:t.title}:null}var rI=4,oI=n=>{let t=n.toFixed(rI);return Number(t)<0?`(${t})`:t.replace("-","")};function cd(n,t,e){let i=to(t,e),s=t.joints.map((l,u)=>Qr(l,i[u])),r=l=>l.reduce((u,[h,f])=>u+f*s[h-1].theta,0),o={cos:l=>Math.cos(r(l)),sin:l=>Math.sin(r(l)),slide:([[l]])=>s[l-1].d};return n.symbols.reduce((l,u)=>l.replaceAll(u.latex,oI(o[u.is](u.joints))),n.latex).replaceAll("\\left(","(").replaceAll("\\right)",")").replace(/(\d|\))\s+(?=\d|\()/g,"$1 \\cdot ")}var ud=null;async function aI(){return ud??=(await import("./katex-OJEVB6AI.js")).default,ud}function lI(n,t){let e=E("span");try{n.render(t.latex,e,{throwOnError:!0,strict:!1,trust:!1})}catch{e.textContent=t.text}return e}function Vb(n,t){let e=[[i=>typeof i=="string",i=>i],[i=>"latex"in i,i=>lI(n,i)],[i=>"code"in i,i=>E("code",{text:i.code})],[()=>!0,i=>E("em",{text:i.emphasis})]];return t.map(i=>e.find(([s])=>s(i))[1](i))}var cI=n=>n.map(t=>typeof t=="string"?t:t.latex?`$${t.latex}$`:t.code??t.emphasis).join("");function uI(n){let t=P.table.joints.map((e,i)=>E("th",{},E("i",{text:"q"}),E("sub",{text:String(i+1)}),E("span",{class:"unit",text:` ${yt.symbol(on(e))}`})));return[E("h3",{text:"The formulas at the present pose"}),E("table",{class:"plain","data-testid":"formula-values","aria-label":"Branches of the formulas at the present pose"},E("thead",{},E("tr",{},E("th",{text:"branch"}),t)),E("tbody",{},n.map((e,i)=>E("tr",{},E("th",{scope:"row",text:String(i+1)}),e.map((s,r)=>E("td",{text:_i(s,on(P.table.joints[r]))}))))))]}var Wb={id:"equations",title:"Equations",wide:!0,build(n,t){let e="forward",i="symbols",s=null,r=[],o=[],a=E("p",{class:"hint",role:"status","data-testid":"equations-note"}),c=E("div",{class:"equations","data-testid":"equations"}),l=xn("Written with",[["symbols","Symbols"],["numbers","Lengths"],["present","Numbers"]],i,v=>{i=v,_()},"equation-numbers"),u=E("div",{class:"scroll"});n.append(E("div",{class:"line spread"},E("span",{class:"line"},xn("Equations",[["forward","Forward"],["inverse","Inverse"],["singular","Singularities"]],e,v=>{e=v,_()},"which-equations"),l),E("button",{type:"button",class:"quiet",text:"Copy LaTeX",on:{click:()=>eo(d())}})),a,u,c);let h=v=>v.symbols&&i==="present"?cd(v,P.table,P.q):v.latex,f=v=>v.number===void 0?"":` \\tag{${v.number}}`,d=()=>o.map(v=>v.kind==="equation"?`\\[ ${h(v)}${f(v)} \\]`:cI(v.pieces)).join(`

`);function g(v){r=[],te(c,o.map(A=>p(v,A))),m()}async function _(){if(t.hidden||!P.table.joints.length)return;let v=`${e}/${i}/${JSON.stringify(P.table.joints)}${P.table.convention}`;if(s!==v){s=v,Ut(a,"Deriving \u2026"),te(c);try{let[A,S]=await Promise.all([aI(),Yn("equations",{which:e,numbers:i==="symbols"?i:"numbers"},y=>Ut(a,y.note??""))]);if(s!==v)return;Ut(a,S.note??""),o=S.blocks,g(A),l.hidden=e!=="forward",te(u),x()}catch(A){if(s!==v)return;s=null,Ut(a,A.message)}}}function p(v,A){if(A.kind==="heading"||A.kind==="step")return E("h3",{},Vb(v,A.pieces));if(A.kind!=="equation")return E("p",{class:"prose"},Vb(v,A.pieces));let S=E("div",{class:"formula"});try{v.render(h(A),S,{displayMode:!0,throwOnError:!0,strict:!1,trust:!1,maxSize:20,maxExpand:1e3})}catch{S.replaceChildren(E("code",{text:h(A)}))}if(A.number!==void 0)return E("div",{class:"formula-row numbered"},S,E("span",{class:"hint",text:`(${A.number})`}));if(A.entry===void 0)return S;let y=E("output",{class:"value","data-entry":String(A.entry)});return r.push({value:y,entry:A.entry}),E("div",{class:"formula-row"},S,y)}let m=wr(()=>{if(t.hidden)return;let v=P.frames[P.frames.length-1];for(let{value:A,entry:S}of r)Ut(A,`= ${S%4===3?`${Xn(v[S]*yt.factor("length"),yt.digits("length"))} ${yt.length}`:Xn(v[S],4)}`)}),x=Rs(async()=>{if(!(t.hidden||e!=="inverse"||!c.childElementCount))try{let{rows:v}=await Yn("formulas",{T:P.frames.at(-1)});te(u,v.length&&e==="inverse"?uI(v):null)}catch{te(u)}},250),M=Rs(()=>{!t.hidden&&ud&&o.length&&e==="forward"&&i==="present"&&g(ud)},120);gt("q",M),gt("panel",M),gt("q",x),gt("units",x),gt("panel",_),gt("plan",_),gt(["q","units"],m)}};var Pg=()=>P.frames[P.frames.length-1].slice(),qb={id:"path",title:"Path",wide:!0,build(n,t){let e=P.path,i=["from","to"].map(p=>{let m=Io(p==="from"?"From":"To",`path-${p}`,()=>e[p],v=>{Dt("did",{label:`set \u201C${p}\u201D of the path`,key:`path-${p}`}),e[p]=v,h(),Dt("path")}),x=E("button",{type:"button",class:"quiet",text:"Take the present pose","data-testid":`take-${p}`,on:{click:()=>{Dt("did",{label:`take \u201C${p}\u201D of the path`}),e[p]=Pg(),m.show(),h(),Dt("path")}}});return{el:E("div",{class:"end"},x,m.el),show:m.show}}),s=E("span",{class:"hint"}),r=Ti({label:"Number of points N",testid:"path-n",check:p=>Number.isInteger(p)&&p>=2&&p<=2e3?null:"a whole number from 2 to 2000",input:p=>{Dt("did",{label:"set the points of the path",key:"path-n"}),e.n=p}}),o=Ti({label:"Seconds for the whole line",testid:"path-seconds",check:p=>p>0&&p<=3600?null:"more than 0, at most 3600",input:p=>{Dt("did",{label:"set the seconds of the path",key:"path-seconds"}),e.seconds=p}}),a=E("button",{type:"button",class:"quiet",text:"Keep the orientation of \u201CFrom\u201D",on:{click:()=>{if(e.from&&e.to){let p=ye(e.to);Dt("did",{label:"keep the orientation of the path"}),e.to=e.from.slice(),[3,7,11].forEach((m,x)=>{e.to[m]=p[x]}),i[1].show(),h()}}}}),c=E("button",{type:"button",class:"primary",text:"Plan the line","data-testid":"plan",on:{click:()=>f(P.q)}}),l=E("p",{class:"verdict",role:"status","data-testid":"path-verdict",hidden:!0}),u=E("div",{class:"branches","data-testid":"branches"});n.append(...i.map(p=>p.el),E("div",{class:"line"},a,s),E("div",{class:"line"},E("label",{class:"field"},E("span",{class:"field-name",text:"Points N"}),r),E("label",{class:"field"},E("span",{class:"field-name",text:"Seconds"}),o),c,E("span",{class:"hint",text:"starts from the solution nearest to the present posture"})),l,u);let h=()=>{if(!e.from||!e.to){Ut(s,"");return}let p=Qg(e.from,e.to);Ut(s,`${$e(As(qi(ye(e.to),ye(e.from))),"length")} long${p>1e-6?`, turning ${$e(p,"angle")}`:", orientation kept"}`),wf(Array.from({length:33},(m,x)=>ye(Hx(e.from,e.to,x/32))))};async function f(p){let m=Wc(n);if(m){l.hidden=!1,l.dataset.tone="wrong",Ut(l,m);return}Ut(c,"Planning \u2026"),c.disabled=!0;try{let x=await Yn("follow",{T0:e.from,T1:e.to,n:e.n,start:p});P.track=x,d(x,p)}catch(x){l.hidden=!1,l.dataset.tone="wrong",Ut(l,x.message)}finally{Ut(c,"Plan the line"),c.disabled=!1}}function d(p){if(l.hidden=!1,l.dataset.tone=p.complete?"good":"wrong",Ut(l,p.explain),te(u,p.branches.length?E("h3",{text:"Branches that start at the first pose"}):null,p.branches.map((v,A)=>E("button",{type:"button",class:`branch ${A===p.chosen?"chosen":""}`,"aria-pressed":String(A===p.chosen),"data-testid":`branch-${A+1}`,disabled:!v.q,title:v.cause||"reaches the end",on:{click:async()=>{await ms(v.q,.4,`take branch ${A+1}`),f(v.q)}}},E("span",{class:"branch-name",text:`${A+1}  ${v.label}`}),g(v.s),E("span",{class:"branch-end",text:v.complete?"to the end":v.q?`${v.points} of ${e.n}`:"starts outside the limits"})))),wf(p.path.map(ye)),!p.q.length){Po(null);return}let m=p.path.length,x=p.q.map((v,A)=>A+1),M=p.q.map((v,A)=>m>1?e.seconds*A/(m-1):0);Po(jf({table:P.table,q:p.q,xs:x,xName:"point",xEnd:m,seconds:M,title:`${P.table.name}: straight line, ${p.q.length} of ${m} points`,events:p.events.map(v=>({...v,x:1+v.s*(m-1),short:v.cause}))}))}function g(p){let m=E("span",{class:"bar-fill"});return m.style.setProperty("width",`${100*p}%`),E("span",{class:"bar"},m)}let _=()=>{i.forEach(p=>p.show()),r.put(e.n),o.put(e.seconds),h()};gt("panel",p=>{p==="path"&&(e.from??=Pg(),e.to??=Pg(),_())}),gt("path-loaded",_),gt("notation",_),gt("units",h),gt("table",p=>{["postures","name","gripper"].includes(p)||(l.hidden=!0,te(u),wf([]),t.hidden||_())})}};var hI=40,Xb={id:"sequence",title:"Sequence",wide:!0,build(n){let t={get postures(){return P.sequence.postures},set postures(u){P.sequence.postures=u},get rate(){return P.sequence.rate}},e=E("thead"),i=E("tbody"),s=E("p",{class:"verdict",role:"status","data-testid":"sequence-verdict",hidden:!0}),r=E("button",{type:"button",class:"primary",text:"Run the sequence","data-testid":"run-sequence",on:{click:l}}),o=E("button",{type:"button",class:"quiet",text:"Same times for all legs",title:"Copy the first leg\u2019s time and rest to the others",on:{click:()=>{let u=t.postures[1];if(u){Dt("did",{label:"use the same times for all legs"});for(let h of t.postures.slice(2))h.seconds=u.seconds,h.hold=u.hold;c()}}}});n.append(E("p",{class:"hint",text:"Each leg is a quintic in time: all joints start and arrive together, at rest in every posture. After a leg the arm rests."}),E("div",{class:"scroll"},E("table",{class:"dh sequence","data-testid":"sequence","aria-label":"Postures of the sequence"},e,i)),E("div",{class:"line"},E("button",{type:"button",class:"add",text:"+ Present posture","data-testid":"add-posture",on:{click:()=>a(P.q.slice())}}),E("button",{type:"button",text:"+ All named postures",on:{click:()=>Object.entries(P.table.postures??{}).forEach(([u,h])=>a(h.slice(),u))}}),o),E("div",{class:"line"},r),s);function a(u,h){t.postures.length>=hI||(Dt("did",{label:"add a posture to the sequence"}),t.postures.push({name:h??`P${t.postures.length}`,q:u,seconds:5,hold:0}),c(),Dt("sequence"))}function c(){let u=P.table.joints;t.postures=t.postures.filter(h=>h.q.length===u.length),r.disabled=t.postures.length<2,te(e,E("tr",{},E("th",{text:""}),u.map((h,f)=>E("th",{},E("i",{text:"q"}),E("sub",{text:String(f+1)}),E("span",{class:"unit",text:` ${yt.symbol(on(h))}`}))),E("th",{text:"leg, s"}),E("th",{text:"rest, s"}),E("th",{"aria-label":"row tools"}))),te(i,t.postures.map((h,f)=>{let d=u.map((_,p)=>{let m=Ti({label:`${h.name}, q${p+1}`,kind:on(_),testid:`seq-${f}-q${p+1}`,input:x=>{Dt("did",{label:`edit ${h.name} of the sequence`,key:`seq-${f}-${p}`}),h.q[p]=x,Dt("sequence")}});return m.put(h.q[p],String(Number((h.q[p]*yt.factor(on(_))).toFixed(yt.digits(on(_))))+0)),E("td",{},m)}),g=(_,p,m)=>{if(f===0)return E("td");let x=Ti({label:`${p} ${h.name}`,testid:`seq-${f}-${_}`,check:m,input:M=>{Dt("did",{label:`edit ${h.name} of the sequence`,key:`seq-${f}-${_}`}),h[_]=M,Dt("sequence")}});return x.put(h[_]),E("td",{},x)};return E("tr",{"data-testid":`seq-row-${f}`},E("th",{scope:"row"},E("button",{type:"button",class:"quiet",text:h.name,title:"Go there",on:{click:()=>ms(h.q.slice())}})),d,g("seconds","Seconds to",_=>_>0?null:"more than 0"),g("hold","Rest after",_=>_>=0?null:"0 or more"),E("td",{class:"tools"},E("button",{type:"button",class:"icon",text:"\u2191",disabled:f===0,"aria-label":`Move ${h.name} up`,on:{click:()=>{Dt("did",{label:`move ${h.name} up`}),t.postures.splice(f-1,0,...t.postures.splice(f,1)),c()}}}),E("button",{type:"button",class:"icon",text:"\xD7","aria-label":`Remove ${h.name}`,on:{click:()=>{Dt("did",{label:`remove ${h.name}`}),t.postures.splice(f,1),c(),Dt("sequence")}}})))})),t.postures.length||i.append(E("tr",{},E("td",{class:"hint",colspan:String(u.length+4),text:"No postures yet: add the present one, move the arm, add the next."})))}async function l(){s.hidden=!1;let u=Wc(n);if(u){s.dataset.tone="wrong",Ut(s,u);return}r.disabled=!0;try{let h=t.postures,f=await Yn("motion",{postures:h.map(g=>g.q),seconds:h.slice(1).map(g=>g.seconds),holds:h.slice(1).map(g=>g.hold),rate:t.rate}),d=h.map((g,_)=>({x:f.arrivals[_],s:0,text:`${g.name} at ${f.arrivals[_].toFixed(2)} s`,short:g.name,stop:!1}));s.dataset.tone="good",Ut(s,`${h.length} postures in ${f.t[f.t.length-1].toFixed(2)} s. ${fI(f.q)}`),Po(jf({table:P.table,q:f.q,xs:f.t,xName:"time",seconds:f.t,dq:f.dq,events:d,title:`${P.table.name}: ${h.map(g=>g.name).join(" \u2013 ")}`}))}catch(h){s.dataset.tone="wrong",Ut(s,h.message)}finally{r.disabled=t.postures.length<2}}gt(["table","units","sequence-loaded"],c),c()}};function fI(n){let t=P.table.joints.filter((e,i)=>n.some(s=>e.lower!==null&&s[i]<e.lower-1e-9||e.upper!==null&&s[i]>e.upper+1e-9));return t.length?`Outside the limits on the way: ${t.map(e=>e.name).join(", ")}.`:"Inside all limits."}var hd=["#440154","#414487","#2a788e","#22a884","#7ad151","#fde725"].map(n=>new ee(n)),Ig=new Ir({size:2.2,sizeAttenuation:!1,vertexColors:!0,fog:!1}),Ai=new lo(new De,Ig);Ai.frustumCulled=!1;Ai.visible=!1;gi.add(Ai);var Ja=null,Pc=null,Ri=0,Zr={lo:0,hi:1};function $b(n){Ja=new Float32Array(3*n),Pc=new Float32Array(n),Ri=0,Ai.geometry.dispose(),Ai.geometry=new De,Ai.geometry.setAttribute("position",new sn(Ja,3)),Ai.geometry.setAttribute("color",new sn(new Float32Array(3*n),3)),Ai.geometry.setDrawRange(0,0),Ai.visible=!0,qe()}function Yb(n){let t=Uint8Array.from(atob(n),i=>i.charCodeAt(0)),e=new Float32Array(t.buffer);for(let i=0;i<e.length&&Ri<Pc.length;i+=4,Ri++)Ja.set(e.subarray(i,i+3),3*Ri),Pc[Ri]=e[i+3];dI()}function dI(){let n=Pc.slice(0,Ri).sort();Zr.lo=n[Math.floor(Ri*.02)]??0,Zr.hi=n[Math.max(Math.ceil(Ri*.98)-1,0)]??1;let t=new ee,e=Ai.geometry.attributes.color.array,i=Zr.hi-Zr.lo||1;for(let s=0;s<Ri;s++){let r=Math.min(Math.max((Pc[s]-Zr.lo)/i,0),1)*(hd.length-1),o=Math.min(Math.floor(r),hd.length-2);t.lerpColors(hd[o],hd[o+1],r-o),e[3*s]=t.r,e[3*s+1]=t.g,e[3*s+2]=t.b}Ai.geometry.setDrawRange(0,Ri),Ai.geometry.attributes.position.needsUpdate=!0,Ai.geometry.attributes.color.needsUpdate=!0,qe()}var Ic=()=>Ri;function Zb(n){ki.localClippingEnabled=n!==null,Ig.clippingPlanes=n===null?null:[new Zn(new H(0,1,0),-n)],Ig.needsUpdate=!0,qe()}function Jb(){let n=new Mi;for(let i=0;i<Ri;i++)n.expandByPoint(new H(Ja[3*i],Ja[3*i+1],Ja[3*i+2]));let{min:t,max:e}=n;return Ri?[0,1,2,3,4,5,6,7].map(i=>[i&1?t.x:e.x,i&2?t.y:e.y,i&4?t.z:e.z]):[]}function Kb(){Ri=0,Ai.visible=!1,qe()}var Qb=[["height","height of the tool"],["manipulability","manipulability"],["condition","inverse condition number"],["limits","distance to the limits"]],fd=n=>n===0?"0":Math.abs(n)>=.001&&Math.abs(n)<1e4?Xn(n,4):n.toExponential(2).replace("-","\u2212"),tM={id:"analysis",title:"Analysis",build(n){let t=E("dl",{class:"facts","data-testid":"analysis"}),e=[["manipulability","Manipulability","the product of the singular values of the Jacobian, lengths divided by the arm\u2019s"],["condition","Condition number","the largest singular value over the smallest; 1 is best"],["least","Smallest singular value","0 at a singularity"]],i={};for(let[c,l,u]of e)t.append(E("div",{title:u},E("dt",{text:l}),i[c]=E("dd",{"data-testid":`fact-${c}`})));let s=E("div",{class:"distances","data-testid":"limit-distances"}),r=[];n.append(t,E("h3",{text:"Distance to the limits"}),s,E("h3",{text:"Reachable points"}),pI());let o=()=>{r=P.table.joints.map((c,l)=>{let u=E("span",{class:"bar-fill"}),h=E("span",{class:"bar-text"});return{el:E("div",{class:"distance"},E("span",{},E("i",{text:"q"}),E("sub",{text:String(l+1)})),E("span",{class:"bar"},u),h),fill:u,text:h}}),te(s,r.map(c=>c.el)),a()},a=wr(()=>{if(n.closest(".panel").hidden||!P.table.joints.length)return;let c=kc(P.table,P.q,P.frames),l=c[0],u=c[c.length-1];Ut(i.manipulability,fd(c.reduce((h,f)=>h*f,1))),Ut(i.condition,l>1e-9?Xn(u/l,1):"\u221E"),Ut(i.least,fd(l)),t.dataset.tone=l<.02?"wrong":"good",r.forEach(({el:h,fill:f,text:d},g)=>{let _=P.table.joints[g],p=P.q[g];if(_.lower===null||_.upper===null){f.style.setProperty("width","100%"),Ut(d,"no limit");return}let m=Math.min(p-_.lower,_.upper-p),x=Math.max(2*m/(_.upper-_.lower||1),0);f.style.setProperty("width",`${100*x}%`),h.classList.toggle("outside",m<-1e-9),Ut(d,m<-1e-9?`${$e(-m,on(_))} beyond`:$e(m,on(_)))})});gt("table",o),gt(["q","units","panel"],a),o()}};function pI(){let n="20000",t="manipulability",e=!1,i=E("button",{type:"button",class:"primary",text:"Draw the cloud","data-testid":"cloud-start",on:{click:()=>e?Ys("cancel",{kind:"cloud"}):f()}}),s=E("button",{type:"button",text:"Clear",on:{click:h}}),r=xn("Cloud shown",[["whole","Whole"],["half","Cut open"]],"whole",d=>Zb(d==="half"?P.table.base[7]:null),"cloud-cut"),o=E("progress",{max:"1","aria-label":"Progress of the cloud","data-testid":"cloud-progress",hidden:!0}),a=E("p",{class:"hint",role:"status","data-testid":"cloud-note"}),c=E("span"),l=E("span"),u=E("div",{class:"legend-scale",hidden:!0},c,E("span",{class:"scale-bar"}),l);function h(){Kb(),Mo("cloud",[]),u.hidden=!0,Ut(a,"")}async function f(){e=!0,Ut(i,"Cancel"),o.hidden=!1,o.value=0,u.hidden=!1,$b(Number(n));try{let d=await Yn("cloud",{count:Number(n),colour:t,seed:1},g=>{Yb(g.points),o.value=g.done/g.of,Ut(c,fd(Zr.lo)),Ut(l,fd(Zr.hi)),Ut(a,`${g.done.toLocaleString("en")} of ${g.of.toLocaleString("en")} points`)});Ut(a,d.stopped?`Cancelled after ${Ic().toLocaleString("en")} points.`:`${d.done.toLocaleString("en")} random postures inside the limits, coloured by ${Qb.find(([g])=>g===t)[1]}${t==="height"?" (m)":""}.`)}catch(d){Ut(a,d.message)}e=!1,Mo("cloud",Jb()),mc(),Ut(i,"Draw the cloud"),o.hidden=!0}return gt("table",d=>{d!=="postures"&&d!=="name"&&Ic()&&h()}),E("div",{},E("div",{class:"line"},jn("Number of points",[["5000","5,000 points"],["20000","20,000 points"],["100000","100,000 points"]],n,d=>{n=d},{"data-testid":"cloud-count"}),E("span",{class:"field-name",text:"coloured by"}),jn("Coloured by",Qb,t,d=>{t=d},{"data-testid":"cloud-colour"})),E("div",{class:"line"},i,s,r),o,u,a)}var eM=n=>({id:"share",title:"Share",build(t,e){let i=E("input",{type:"text",readonly:!0,class:"address","aria-label":"Link to this state","data-testid":"link",on:{focus:u=>u.target.select()}}),s=E("input",{type:"file",accept:".json,application/json",class:"offscreen",tabindex:"-1","aria-label":"State file","data-testid":"state-file",on:{change:()=>l(s)}}),r=E("p",{class:"hint",role:"status","data-testid":"report-note"}),o=E("button",{type:"button",class:"primary",text:"Write the report","data-testid":"report",on:{click:c}});t.append(E("p",{class:"hint",text:"Arm, posture, target, path, sequence, units and view, all in the link: whoever opens it on their own workbench sees what you see."}),E("div",{class:"line share-link"},i,E("button",{type:"button",text:"Copy the link","data-testid":"copy-link",on:{click:async()=>eo(await Lf())}})),E("h3",{text:"As a file"}),E("div",{class:"line"},E("button",{type:"button",text:"Save the state","data-testid":"save-state",on:{click:()=>Zs(`${P.table.name||"arm"}.workbench.json`,JSON.stringify(Pf(),null,1),"application/json")}}),E("button",{type:"button",text:"Open a state\u2026",on:{click:()=>s.click()}}),s,E("button",{type:"button",text:"Save the robot file","data-testid":"save-robot",on:{click:ld}})),E("h3",{text:"Report"}),E("p",{class:"hint",text:"One page that stands alone: the arm, its table and equations, the present pose with all its solutions, singularities and reach."}),E("div",{class:"line"},o),r),gt(["panel","table","q","units","notation"],async()=>{!e.hidden&&P.table.joints.length&&(i.value=await Lf())});async function c(){o.disabled=!0;try{let{html:u,name:h}=await Yn("report",{q:P.q},f=>Ut(r,f.note));Zs(h,u,"text/html"),Ut(r,`Written: ${h}, ${Math.round(u.length/1024)} kB.`)}catch(u){Ut(r,u.message)}finally{o.disabled=!1}}async function l(u){let h=u.files[0];if(u.value="",!!h)try{if(h.size>5e5)throw new Error("A state file has at most 500 kB.");If(JSON.parse(await h.text()),n()),Rn("Opened")}catch(f){Rn(f instanceof SyntaxError?`${h.name} is not a state file.`:f.message,"wrong")}}}});function nM(){window.workbench=Object.freeze({get q(){return P.q.slice()},get frames(){return structuredClone(P.frames)},get target(){return P.target.slice()},get table(){return structuredClone(P.table)},get solutions(){return structuredClone(P.solutions)},get camera(){return ef()},get pictures(){return Ax()},get ghosts(){return Sy()},get history(){return[Af(),Rf()]},get beyond(){return vy()},get framesDrawn(){return by()},get answers(){return Lm.answers},get trace(){return Ay()},get cloud(){return Ic()},toScreen:wi,withPicture:n=>Tx(n),handles:()=>Kx(),forward:(n,t)=>$s(n,t),convert:(n,t)=>od(n,t),read:(n,t)=>Zf(n,t),present:(n,t,e)=>cd(n,t,e)})}Yh();Rx(Sr("#view"));gt("theme",om);om();Dy();gy();Yx();l0();Py();Sb(Sr("#bar"));Eb(Sr("#overlay"));Mb(Sr("#dock"));Tb();var Lg;Lg=wb(Sr("#rail"),Sr("#panels"),Sr("#pinned"),[{id:"move",title:"Move",sections:[_b,Rb]},Ob,Gb,Cb,Wb,qb,Xb,tM,eM(()=>Lg)]);zy();var mI=By().then(n=>n&&If(n,Lg)).catch(n=>Rn(`The link could not be read: ${n.message}`,"wrong"));gt("online",async n=>{if(!n)return;await mI;let t=await s0();P.catalog=t.catalog,Dt("catalog"),t.table&&!P.table.joints.length&&(_n(t.table,{q:Vo(t.table),step:!1,what:"new"}),Cf()),document.documentElement.dataset.ready="yes"});P.online&&Dt("online",!0);document.fonts?.ready.then(()=>Dt("theme"));nM();
