const Ws=[["k",1e3],["",1],["m",.001],["µ",1e-6],["n",1e-9]];function Ns(i,e){if(e==="1")return{name:"",factor:1};if(e==="rad"||e.startsWith("rad/"))return{name:e.replace("rad","deg"),factor:180/Math.PI};const t=e==="1/s"?"Hz":e,n=/^(m|s|Hz)(\^2)?(\/.*)?$/.exec(t);if(!n)return{name:e,factor:1};const s=n[2]?2:1,r=Math.abs(i)*(1+1e-9),[a,o]=Ws.find(([l,c])=>r>=c**s&&(l!=="k"||n[1]==="Hz"))??(r>0?Ws[Ws.length-1]:Ws[1]);return{name:a+t,factor:1/o**s}}function nn(i,e=3){if(i===0)return"0";const t=Math.abs(i),n=i.toPrecision(e);return t>=1e6||t<1e-4?Number(n).toExponential():String(Number(n))}function Re(i,e,t=3,n=Ns(i??0,e)){return i==null||!Number.isFinite(i)?"not observed":`${nn(i*n.factor,t)} ${wh(n.name)}`.trim()}const wh=i=>i.replace(/\^(-?\d+)/g,(e,t)=>[...t].map(n=>n==="-"?"⁻":"⁰¹²³⁴⁵⁶⁷⁸⁹"[Number(n)]).join(""));function Br(i,e,t=Ns(i,e)){const n=t.name.startsWith("1/")?"":t.name;return`${nn(i*t.factor,5)} ${n}`.trim()}const Is=i=>`${nn(100*i,2)} %`,Bt=(i,e)=>`${i} ${e}${i===1?"":"s"}`,dd={k:1e3,"":1,c:.01,m:.001,µ:1e-6,u:1e-6,n:1e-9};function Zi(i,e){const t=/^\s*([-+]?[\d.]+(?:e[-+]?\d+)?)\s*(log)?\s*(\S*)\s*$/i.exec(i);if(!t)return NaN;const[,n,s,r]=t,a=s?10**Number(n):Number(n);if(!r||r===e)return a;if(e.startsWith("rad"))return r===e.replace("rad","deg")?a*Math.PI/180:NaN;const o=e==="1/s"?"Hz":e,l=o.includes("^2")?2:1,c=r.endsWith(o)?r.slice(0,r.length-o.length):"?";return a*(dd[c]??NaN)**l}function fd(i,e,t){if(i==="log10")return{name:t==="1"?"log₁₀":`log₁₀ ${t}`,of:s=>s>0?nn(Math.log10(s),4):""};const n=i==="si"?{name:t==="1"?"":t,factor:1}:Ns(e,t);return{name:n.name,of:s=>nn(s*n.factor)}}var ai=(i=>(i[i.blind=0]="blind",i[i.value=1]="value",i[i.inside=2]="inside",i[i.gained=3]="gained",i[i.lost=4]="lost",i))(ai||{});function Eh(i){const e=new DataView(i);if(String.fromCharCode(...new Uint8Array(i,0,4))!=="DLF1")throw new Error("the field is of another version; reload the page");const n=e.getUint32(4,!0),s=JSON.parse(new TextDecoder().decode(new Uint8Array(i,8,n))),r=8+n,a=s.parts.map(o=>{if(o.positions===void 0)return o;const l=new Float32Array(i,r+o.positions,3*o.count);return o.kind==="surface"?{...o,positions:l,triangles:new Uint32Array(i,r+o.triangles,o.corners)}:{...o,positions:l}});return{revision:s.revision,level:s.level,largerIsBetter:s.larger_is_better,definition:s.definition,summary:s.summary,values:new Float32Array(i,r+s.values.at,s.values.count),mask:new Uint8Array(i,r+s.mask.at,s.mask.count),parts:a,leaves:s.leaves}}function ca(i,e){switch(i.kind){case"grid":{const[t,n]=i.counts;return[e%t,Math.floor(e/t)%n,Math.floor(e/(t*n))].map((r,a)=>i.origin[a]+r*i.step[a])}case"plane":{const[t,n]=i.counts,s=e%t/Math.max(1,t-1),r=Math.floor(e/t)/Math.max(1,n-1);return i.origin.map((a,o)=>a+s*i.u[o]+r*i.v[o])}default:return[0,1,2].map(t=>i.positions[3*e+t])}}const el=i=>i.kind==="points"||i.kind==="surface";function Th({summary:i}){const{metric:e,min:t,max:n,samples:s,finite:r}=i;return`The room: ${t&&n?`${e.name} from ${Re(t.value,e.unit)} to ${Re(n.value,e.unit)}`:`${e.name} is finite nowhere`}; ${s-r} of ${Bt(s,"sample")} blind`}const pd={shapes:[]},tl=i=>JSON.stringify(i),md=i=>({asked:tl(i),meshes:[],leaves:null}),gd=({shapes:i,leaves:e})=>i.length===0&&!e;function _d(i,e){if(String.fromCharCode(...new Uint8Array(i,0,4))!=="DLS1")throw new Error("the shapes are of another version; reload the page");const n=new DataView(i).getUint32(4,!0),s=JSON.parse(new TextDecoder().decode(new Uint8Array(i,8,n))),r=8+n,a=(c,h)=>new Float32Array(i,r+c,h),o=s.meshes.map(c=>({asked:e.shapes[c.shape],positions:a(c.positions,3*c.vertices),normals:a(c.normals,3*c.vertices),values:a(c.values,c.vertices),triangles:new Uint32Array(i,r+c.triangles,c.corners),caps:c.caps,area:c.area})),l=s.leaves&&{count:s.leaves.count,positions:a(s.leaves.positions,6*s.leaves.lines)};return{asked:tl(e),meshes:o,leaves:l}}/**
 * @license
 * Copyright 2010-2026 Three.js Authors
 * SPDX-License-Identifier: MIT
 */const nl="187",Vi={ROTATE:0,DOLLY:1,PAN:2},Hi={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},vd=0,Bl=1,xd=2,Pr=1,Md=2,_s=3,yi=0,Yt=1,Ft=2,Wi=0,bs=1,kl=2,zl=3,Hl=4,yd=5,zi=100,bd=101,Sd=102,wd=103,Ed=104,Td=200,Ad=201,Rd=202,Cd=203,Ah=204,Rh=205,Pd=206,Ld=207,Dd=208,Nd=209,Id=210,Ud=211,Fd=212,Od=213,Bd=214,eo=0,to=1,no=2,Es=3,io=4,so=5,ro=6,ao=7,il=0,kd=1,zd=2,Wn=0,Ch=1,Ph=2,Lh=3,Dh=4,Nh=5,Ih=6,Uh=7,Fh=300,Ki=301,Ts=302,ha=303,ua=304,oo=1e3,Vn=1001,lo=1002,Ot=1003,Hd=1004,Xs=1005,qt=1006,da=1007,si=1008,tn=1009,Oh=1010,Bh=1011,As=1012,sl=1013,An=1014,pn=1015,Un=1016,rl=1017,al=1018,Ji=1020,kh=35902,zh=35899,Hh=1021,Gh=1022,wn=1023,oi=1026,ri=1027,Vh=1028,ol=1029,li=1030,ll=1031,cl=1033,Lr=33776,Dr=33777,Nr=33778,Ir=33779,co=35840,ho=35841,uo=35842,fo=35843,po=36196,mo=37492,go=37496,_o=37488,vo=37489,kr=37490,xo=37491,Mo=37808,yo=37809,bo=37810,So=37811,wo=37812,Eo=37813,To=37814,Ao=37815,Ro=37816,Co=37817,Po=37818,Lo=37819,Do=37820,No=37821,Io=36492,Uo=36494,Fo=36495,Oo=36283,Bo=36284,zr=36285,ko=36286,Gd=3200,Hr=0,Vd=1,ti="",dn="srgb",Gr="srgb-linear",Vr="linear",tt="srgb",fa=7680,Wd=519,Xd=512,$d=513,qd=514,Wh=515,Yd=516,Zd=517,Xh=518,$h=519,Kd=35044,ji="300 es",En=2e3,Rs=2001;function Jd(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function Wr(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function jd(){const i=Wr("canvas");return i.style.display="block",i}const Gl={};function Vl(...i){const e="THREE."+i.shift();console.log(e,...i)}function qh(i){const e=i[0];if(typeof e=="string"&&e.startsWith("TSL:")){const t=i[1];t&&t.isStackTrace?i[0]+=" "+t.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function De(...i){i=qh(i);const e="THREE."+i.shift();{const t=i[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...i)}}function Ke(...i){i=qh(i);const e="THREE."+i.shift();{const t=i[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...i)}}function Ur(...i){const e=i.join(" ");e in Gl||(Gl[e]=!0,De(...i))}function Qd(i,e,t){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:n()}}setTimeout(r,t)})}const ef={[eo]:eo,[no]:ro,[io]:io,[Es]:so,[to]:to,[ro]:no,[ao]:ao,[so]:Es};class ci{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});const n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){const n=this._listeners;return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){const n=this._listeners;if(n===void 0)return;const s=n[e];if(s!==void 0){const r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){const t=this._listeners;if(t===void 0)return;const n=t[e.type];if(n!==void 0){e.target=this;const s=n.slice(0);for(let r=0,a=s.length;r<a;r++)s[r].call(this,e);e.target=null}}}const Ht=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Ss=Math.PI/180,zo=180/Math.PI;function Us(){const i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(Ht[i&255]+Ht[i>>8&255]+Ht[i>>16&255]+Ht[i>>24&255]+"-"+Ht[e&255]+Ht[e>>8&255]+"-"+Ht[e>>16&15|64]+Ht[e>>24&255]+"-"+Ht[t&63|128]+Ht[t>>8&255]+"-"+Ht[t>>16&255]+Ht[t>>24&255]+Ht[n&255]+Ht[n>>8&255]+Ht[n>>16&255]+Ht[n>>24&255]).toLowerCase()}function Ve(i,e,t){return Math.max(e,Math.min(t,i))}function tf(i,e){return(i%e+e)%e}function pa(i,e,t){return(1-t)*i+t*e}function nf(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function hl(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function sf(i,e){if(e.constructor===Float32Array)return i;const t=hl(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/t,-1)}function rf(i,e){if(e.constructor===Float32Array)return i;const t=hl(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*t)}const af={DEG2RAD:Ss};class Ee{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){const t=this.x,n=this.y,s=e.elements;return this.x=s[0]*t+s[3]*n+s[6],this.y=s[1]*t+s[4]*n+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=Ve(this.x,e.x,t.x),this.y=Ve(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=Ve(this.x,e,t),this.y=Ve(this.y,e,t),this}clampLength(e,t){const n=this.length();return this.divideScalar(n||1).multiplyScalar(Ve(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){const t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;const n=this.dot(e)/t;return Math.acos(Ve(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){const t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){const n=Math.cos(t),s=Math.sin(t),r=this.x-e.x,a=this.y-e.y;return this.x=r*n-a*s+e.x,this.y=r*s+a*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}}class pt{constructor(e=0,t=0,n=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=s}static slerpFlat(e,t,n,s,r,a,o){let l=n[s+0],c=n[s+1],h=n[s+2],d=n[s+3],u=r[a+0],m=r[a+1],g=r[a+2],v=r[a+3];if(d!==v||l!==u||c!==m||h!==g){let f=l*u+c*m+h*g+d*v;f<0&&(u=-u,m=-m,g=-g,v=-v,f=-f);let p=1-o;if(f<.9995){const x=Math.acos(f),E=Math.sin(x);p=Math.sin(p*x)/E,o=Math.sin(o*x)/E,l=l*p+u*o,c=c*p+m*o,h=h*p+g*o,d=d*p+v*o}else{l=l*p+u*o,c=c*p+m*o,h=h*p+g*o,d=d*p+v*o;const x=1/Math.sqrt(l*l+c*c+h*h+d*d);l*=x,c*=x,h*=x,d*=x}}e[t]=l,e[t+1]=c,e[t+2]=h,e[t+3]=d}static multiplyQuaternionsFlat(e,t,n,s,r,a){const o=n[s],l=n[s+1],c=n[s+2],h=n[s+3],d=r[a],u=r[a+1],m=r[a+2],g=r[a+3];return e[t]=o*g+h*d+l*m-c*u,e[t+1]=l*g+h*u+c*d-o*m,e[t+2]=c*g+h*m+o*u-l*d,e[t+3]=h*g-o*d-l*u-c*m,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,s){return this._x=e,this._y=t,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){const n=e._x,s=e._y,r=e._z,a=e._order,o=Math.cos,l=Math.sin,c=o(n/2),h=o(s/2),d=o(r/2),u=l(n/2),m=l(s/2),g=l(r/2);switch(a){case"XYZ":this._x=u*h*d+c*m*g,this._y=c*m*d-u*h*g,this._z=c*h*g+u*m*d,this._w=c*h*d-u*m*g;break;case"YXZ":this._x=u*h*d+c*m*g,this._y=c*m*d-u*h*g,this._z=c*h*g-u*m*d,this._w=c*h*d+u*m*g;break;case"ZXY":this._x=u*h*d-c*m*g,this._y=c*m*d+u*h*g,this._z=c*h*g+u*m*d,this._w=c*h*d-u*m*g;break;case"ZYX":this._x=u*h*d-c*m*g,this._y=c*m*d+u*h*g,this._z=c*h*g-u*m*d,this._w=c*h*d+u*m*g;break;case"YZX":this._x=u*h*d+c*m*g,this._y=c*m*d+u*h*g,this._z=c*h*g-u*m*d,this._w=c*h*d-u*m*g;break;case"XZY":this._x=u*h*d-c*m*g,this._y=c*m*d-u*h*g,this._z=c*h*g+u*m*d,this._w=c*h*d+u*m*g;break;default:De("Quaternion: .setFromEuler() encountered an unknown order: "+a)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){const n=t/2,s=Math.sin(n);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){const t=e.elements,n=t[0],s=t[4],r=t[8],a=t[1],o=t[5],l=t[9],c=t[2],h=t[6],d=t[10],u=n+o+d;if(u>0){const m=.5/Math.sqrt(u+1);this._w=.25/m,this._x=(h-l)*m,this._y=(r-c)*m,this._z=(a-s)*m}else if(n>o&&n>d){const m=2*Math.sqrt(1+n-o-d);this._w=(h-l)/m,this._x=.25*m,this._y=(s+a)/m,this._z=(r+c)/m}else if(o>d){const m=2*Math.sqrt(1+o-n-d);this._w=(r-c)/m,this._x=(s+a)/m,this._y=.25*m,this._z=(l+h)/m}else{const m=2*Math.sqrt(1+d-n-o);this._w=(a-s)/m,this._x=(r+c)/m,this._y=(l+h)/m,this._z=.25*m}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(Ve(this.dot(e),-1,1)))}rotateTowards(e,t){const n=this.angleTo(e);if(n===0)return this;const s=Math.min(1,t/n);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){const n=e._x,s=e._y,r=e._z,a=e._w,o=t._x,l=t._y,c=t._z,h=t._w;return this._x=n*h+a*o+s*c-r*l,this._y=s*h+a*l+r*o-n*c,this._z=r*h+a*c+n*l-s*o,this._w=a*h-n*o-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let n=e._x,s=e._y,r=e._z,a=e._w,o=this.dot(e);o<0&&(n=-n,s=-s,r=-r,a=-a,o=-o);let l=1-t;if(o<.9995){const c=Math.acos(o),h=Math.sin(c);l=Math.sin(l*c)/h,t=Math.sin(t*c)/h,this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+a*t,this._onChangeCallback()}else this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+a*t,this.normalize();return this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){const e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}}class T{static{this.prototype.isVector3=!0}constructor(e=0,t=0,n=0){this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(Wl.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(Wl.setFromAxisAngle(e,t))}applyMatrix3(e){const t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6]*s,this.y=r[1]*t+r[4]*n+r[7]*s,this.z=r[2]*t+r[5]*n+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){const t=this.x,n=this.y,s=this.z,r=e.elements,a=1/(r[3]*t+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*n+r[8]*s+r[12])*a,this.y=(r[1]*t+r[5]*n+r[9]*s+r[13])*a,this.z=(r[2]*t+r[6]*n+r[10]*s+r[14])*a,this}applyQuaternion(e){const t=this.x,n=this.y,s=this.z,r=e.x,a=e.y,o=e.z,l=e.w,c=2*(a*s-o*n),h=2*(o*t-r*s),d=2*(r*n-a*t);return this.x=t+l*c+a*d-o*h,this.y=n+l*h+o*c-r*d,this.z=s+l*d+r*h-a*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){const t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*n+r[8]*s,this.y=r[1]*t+r[5]*n+r[9]*s,this.z=r[2]*t+r[6]*n+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=Ve(this.x,e.x,t.x),this.y=Ve(this.y,e.y,t.y),this.z=Ve(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=Ve(this.x,e,t),this.y=Ve(this.y,e,t),this.z=Ve(this.z,e,t),this}clampLength(e,t){const n=this.length();return this.divideScalar(n||1).multiplyScalar(Ve(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){const n=e.x,s=e.y,r=e.z,a=t.x,o=t.y,l=t.z;return this.x=s*l-r*o,this.y=r*a-n*l,this.z=n*o-s*a,this}projectOnVector(e){const t=e.lengthSq();if(t===0)return this.set(0,0,0);const n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return ma.copy(this).projectOnVector(e),this.sub(ma)}reflect(e){return this.sub(ma.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){const t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;const n=this.dot(e)/t;return Math.acos(Ve(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){const t=this.x-e.x,n=this.y-e.y,s=this.z-e.z;return t*t+n*n+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){const s=Math.sin(t)*e;return this.x=s*Math.sin(n),this.y=Math.cos(t)*e,this.z=s*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){const t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){const t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){const e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}}const ma=new T,Wl=new pt;class Be{static{this.prototype.isMatrix3=!0}constructor(e,t,n,s,r,a,o,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,a,o,l,c)}set(e,t,n,s,r,a,o,l,c){const h=this.elements;return h[0]=e,h[1]=s,h[2]=o,h[3]=t,h[4]=r,h[5]=l,h[6]=n,h[7]=a,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){const t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){const t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){const n=e.elements,s=t.elements,r=this.elements,a=n[0],o=n[3],l=n[6],c=n[1],h=n[4],d=n[7],u=n[2],m=n[5],g=n[8],v=s[0],f=s[3],p=s[6],x=s[1],E=s[4],S=s[7],C=s[2],A=s[5],_=s[8];return r[0]=a*v+o*x+l*C,r[3]=a*f+o*E+l*A,r[6]=a*p+o*S+l*_,r[1]=c*v+h*x+d*C,r[4]=c*f+h*E+d*A,r[7]=c*p+h*S+d*_,r[2]=u*v+m*x+g*C,r[5]=u*f+m*E+g*A,r[8]=u*p+m*S+g*_,this}multiplyScalar(e){const t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){const e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],a=e[4],o=e[5],l=e[6],c=e[7],h=e[8];return t*a*h-t*o*c-n*r*h+n*o*l+s*r*c-s*a*l}invert(){const e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],a=e[4],o=e[5],l=e[6],c=e[7],h=e[8],d=h*a-o*c,u=o*l-h*r,m=c*r-a*l,g=t*d+n*u+s*m;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);const v=1/g;return e[0]=d*v,e[1]=(s*c-h*n)*v,e[2]=(o*n-s*a)*v,e[3]=u*v,e[4]=(h*t-s*l)*v,e[5]=(s*r-o*t)*v,e[6]=m*v,e[7]=(n*l-c*t)*v,e[8]=(a*t-n*r)*v,this}transpose(){let e;const t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){const t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,s,r,a,o){const l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*a+c*o)+a+e,-s*c,s*l,-s*(-c*a+l*o)+o+t,0,0,1),this}scale(e,t){return Ur("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(ga.makeScale(e,t)),this}rotate(e){return Ur("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(ga.makeRotation(-e)),this}translate(e,t){return Ur("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(ga.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){const t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){const t=this.elements,n=e.elements;for(let s=0;s<9;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){const n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}}const ga=new Be,Xl=new Be().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),$l=new Be().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function of(){const i={enabled:!0,workingColorSpace:Gr,spaces:{},convert:function(s,r,a){return this.enabled===!1||r===a||!r||!a||(this.spaces[r].transfer===tt&&(s.r=Xn(s.r),s.g=Xn(s.g),s.b=Xn(s.b)),this.spaces[r].primaries!==this.spaces[a].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[a].fromXYZ)),this.spaces[a].transfer===tt&&(s.r=Xi(s.r),s.g=Xi(s.g),s.b=Xi(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===ti?Vr:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,a){return s.copy(this.spaces[a].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[Gr]:{primaries:e,whitePoint:n,transfer:Vr,toXYZ:Xl,fromXYZ:$l,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:dn},outputColorSpaceConfig:{drawingBufferColorSpace:dn}},[dn]:{primaries:e,whitePoint:n,transfer:tt,toXYZ:Xl,fromXYZ:$l,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:dn}}}),i}const qe=of();function Xn(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function Xi(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}let Ei;class lf{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{Ei===void 0&&(Ei=Wr("canvas")),Ei.width=e.width,Ei.height=e.height;const s=Ei.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),n=Ei}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){const t=Wr("canvas");t.width=e.width,t.height=e.height;const n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);const s=n.getImageData(0,0,e.width,e.height),r=s.data;for(let a=0;a<r.length;a++)r[a]=Xn(r[a]/255)*255;return n.putImageData(s,0,0),t}else if(e.data){const t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(Xn(t[n]/255)*255):t[n]=Xn(t[n]);return{data:t,width:e.width,height:e.height}}else return De("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}}let cf=0;class ul{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:cf++}),this.uuid=Us(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){const t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){const t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];const n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let a=0,o=s.length;a<o;a++)s[a].isDataTexture?r.push(_a(s[a].image)):r.push(_a(s[a]))}else r=_a(s);n.url=r}return t||(e.images[this.uuid]=n),n}}function _a(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?lf.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(De("Texture: Unable to serialize Texture."),{})}let hf=0;const va=new T;class Zt extends ci{constructor(e=Zt.DEFAULT_IMAGE,t=Zt.DEFAULT_MAPPING,n=Vn,s=Vn,r=qt,a=si,o=wn,l=tn,c=Zt.DEFAULT_ANISOTROPY,h=ti){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:hf++}),this.uuid=Us(),this.name="",this.source=new ul(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=a,this.anisotropy=c,this.format=o,this.internalFormat=null,this.type=l,this.offset=new Ee(0,0),this.repeat=new Ee(1,1),this.center=new Ee(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new Be,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(va).x}get height(){return this.source.getSize(va).y}get depth(){return this.source.getSize(va).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(const t in e){const n=e[t];if(n===void 0){De(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}const s=this[t];if(s===void 0){De(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[t]=n}}toJSON(e){const t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];const n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==Fh)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case oo:e.x=e.x-Math.floor(e.x);break;case Vn:e.x=e.x<0?0:1;break;case lo:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case oo:e.y=e.y-Math.floor(e.y);break;case Vn:e.y=e.y<0?0:1;break;case lo:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}}Zt.DEFAULT_IMAGE=null;Zt.DEFAULT_MAPPING=Fh;Zt.DEFAULT_ANISOTROPY=1;class _t{static{this.prototype.isVector4=!0}constructor(e=0,t=0,n=0,s=1){this.x=e,this.y=t,this.z=n,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,s){return this.x=e,this.y=t,this.z=n,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){const t=this.x,n=this.y,s=this.z,r=this.w,a=e.elements;return this.x=a[0]*t+a[4]*n+a[8]*s+a[12]*r,this.y=a[1]*t+a[5]*n+a[9]*s+a[13]*r,this.z=a[2]*t+a[6]*n+a[10]*s+a[14]*r,this.w=a[3]*t+a[7]*n+a[11]*s+a[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);const t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,s,r;const l=e.elements,c=l[0],h=l[4],d=l[8],u=l[1],m=l[5],g=l[9],v=l[2],f=l[6],p=l[10];if(Math.abs(h-u)<.01&&Math.abs(d-v)<.01&&Math.abs(g-f)<.01){if(Math.abs(h+u)<.1&&Math.abs(d+v)<.1&&Math.abs(g+f)<.1&&Math.abs(c+m+p-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;const E=(c+1)/2,S=(m+1)/2,C=(p+1)/2,A=(h+u)/4,_=(d+v)/4,w=(g+f)/4;return E>S&&E>C?E<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(E),s=A/n,r=_/n):S>C?S<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(S),n=A/s,r=w/s):C<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(C),n=_/r,s=w/r),this.set(n,s,r,t),this}let x=Math.sqrt((f-g)*(f-g)+(d-v)*(d-v)+(u-h)*(u-h));return Math.abs(x)<.001&&(x=1),this.x=(f-g)/x,this.y=(d-v)/x,this.z=(u-h)/x,this.w=Math.acos((c+m+p-1)/2),this}setFromMatrixPosition(e){const t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=Ve(this.x,e.x,t.x),this.y=Ve(this.y,e.y,t.y),this.z=Ve(this.z,e.z,t.z),this.w=Ve(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=Ve(this.x,e,t),this.y=Ve(this.y,e,t),this.z=Ve(this.z,e,t),this.w=Ve(this.w,e,t),this}clampLength(e,t){const n=this.length();return this.divideScalar(n||1).multiplyScalar(Ve(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}}class uf extends ci{constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:qt,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new _t(0,0,e,t),this.scissorTest=!1,this.viewport=new _t(0,0,e,t),this.textures=[];const s=n.count;for(let r=0;r<s;r++)this.textures[r]=new Zt({width:e,height:t,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(e={}){const t={minFilter:qt,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;const s=Object.assign({},e.textures[t].image);this.textures[t].source=new ul(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){const t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}}class Tn extends uf{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}}class Yh extends Zt{constructor(e=null,t=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=Ot,this.minFilter=Ot,this.wrapR=Vn,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}}class Zh extends Zt{constructor(e=null,t=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=Ot,this.minFilter=Ot,this.wrapR=Vn,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}}class Ge{static{this.prototype.isMatrix4=!0}constructor(e,t,n,s,r,a,o,l,c,h,d,u,m,g,v,f){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,a,o,l,c,h,d,u,m,g,v,f)}set(e,t,n,s,r,a,o,l,c,h,d,u,m,g,v,f){const p=this.elements;return p[0]=e,p[4]=t,p[8]=n,p[12]=s,p[1]=r,p[5]=a,p[9]=o,p[13]=l,p[2]=c,p[6]=h,p[10]=d,p[14]=u,p[3]=m,p[7]=g,p[11]=v,p[15]=f,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new Ge().fromArray(this.elements)}copy(e){const t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){const t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){const t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),n.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();const t=this.elements,n=e.elements,s=1/Ti.setFromMatrixColumn(e,0).length(),r=1/Ti.setFromMatrixColumn(e,1).length(),a=1/Ti.setFromMatrixColumn(e,2).length();return t[0]=n[0]*s,t[1]=n[1]*s,t[2]=n[2]*s,t[3]=0,t[4]=n[4]*r,t[5]=n[5]*r,t[6]=n[6]*r,t[7]=0,t[8]=n[8]*a,t[9]=n[9]*a,t[10]=n[10]*a,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){const t=this.elements,n=e.x,s=e.y,r=e.z,a=Math.cos(n),o=Math.sin(n),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),d=Math.sin(r);if(e.order==="XYZ"){const u=a*h,m=a*d,g=o*h,v=o*d;t[0]=l*h,t[4]=-l*d,t[8]=c,t[1]=m+g*c,t[5]=u-v*c,t[9]=-o*l,t[2]=v-u*c,t[6]=g+m*c,t[10]=a*l}else if(e.order==="YXZ"){const u=l*h,m=l*d,g=c*h,v=c*d;t[0]=u+v*o,t[4]=g*o-m,t[8]=a*c,t[1]=a*d,t[5]=a*h,t[9]=-o,t[2]=m*o-g,t[6]=v+u*o,t[10]=a*l}else if(e.order==="ZXY"){const u=l*h,m=l*d,g=c*h,v=c*d;t[0]=u-v*o,t[4]=-a*d,t[8]=g+m*o,t[1]=m+g*o,t[5]=a*h,t[9]=v-u*o,t[2]=-a*c,t[6]=o,t[10]=a*l}else if(e.order==="ZYX"){const u=a*h,m=a*d,g=o*h,v=o*d;t[0]=l*h,t[4]=g*c-m,t[8]=u*c+v,t[1]=l*d,t[5]=v*c+u,t[9]=m*c-g,t[2]=-c,t[6]=o*l,t[10]=a*l}else if(e.order==="YZX"){const u=a*l,m=a*c,g=o*l,v=o*c;t[0]=l*h,t[4]=v-u*d,t[8]=g*d+m,t[1]=d,t[5]=a*h,t[9]=-o*h,t[2]=-c*h,t[6]=m*d+g,t[10]=u-v*d}else if(e.order==="XZY"){const u=a*l,m=a*c,g=o*l,v=o*c;t[0]=l*h,t[4]=-d,t[8]=c*h,t[1]=u*d+v,t[5]=a*h,t[9]=m*d-g,t[2]=g*d-m,t[6]=o*h,t[10]=v*d+u}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(df,e,ff)}lookAt(e,t,n){const s=this.elements;return Qt.subVectors(e,t),Qt.lengthSq()===0&&(Qt.z=1),Qt.normalize(),Yn.crossVectors(n,Qt),Yn.lengthSq()===0&&(Math.abs(n.z)===1?Qt.x+=1e-4:Qt.z+=1e-4,Qt.normalize(),Yn.crossVectors(n,Qt)),Yn.normalize(),$s.crossVectors(Qt,Yn),s[0]=Yn.x,s[4]=$s.x,s[8]=Qt.x,s[1]=Yn.y,s[5]=$s.y,s[9]=Qt.y,s[2]=Yn.z,s[6]=$s.z,s[10]=Qt.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){const n=e.elements,s=t.elements,r=this.elements,a=n[0],o=n[4],l=n[8],c=n[12],h=n[1],d=n[5],u=n[9],m=n[13],g=n[2],v=n[6],f=n[10],p=n[14],x=n[3],E=n[7],S=n[11],C=n[15],A=s[0],_=s[4],w=s[8],I=s[12],P=s[1],U=s[5],O=s[9],X=s[13],D=s[2],G=s[6],Y=s[10],B=s[14],te=s[3],V=s[7],Q=s[11],ee=s[15];return r[0]=a*A+o*P+l*D+c*te,r[4]=a*_+o*U+l*G+c*V,r[8]=a*w+o*O+l*Y+c*Q,r[12]=a*I+o*X+l*B+c*ee,r[1]=h*A+d*P+u*D+m*te,r[5]=h*_+d*U+u*G+m*V,r[9]=h*w+d*O+u*Y+m*Q,r[13]=h*I+d*X+u*B+m*ee,r[2]=g*A+v*P+f*D+p*te,r[6]=g*_+v*U+f*G+p*V,r[10]=g*w+v*O+f*Y+p*Q,r[14]=g*I+v*X+f*B+p*ee,r[3]=x*A+E*P+S*D+C*te,r[7]=x*_+E*U+S*G+C*V,r[11]=x*w+E*O+S*Y+C*Q,r[15]=x*I+E*X+S*B+C*ee,this}multiplyScalar(e){const t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){const e=this.elements,t=e[0],n=e[4],s=e[8],r=e[12],a=e[1],o=e[5],l=e[9],c=e[13],h=e[2],d=e[6],u=e[10],m=e[14],g=e[3],v=e[7],f=e[11],p=e[15],x=l*m-c*u,E=o*m-c*d,S=o*u-l*d,C=a*m-c*h,A=a*u-l*h,_=a*d-o*h;return t*(v*x-f*E+p*S)-n*(g*x-f*C+p*A)+s*(g*E-v*C+p*_)-r*(g*S-v*A+f*_)}determinantAffine(){const e=this.elements,t=e[0],n=e[4],s=e[8],r=e[1],a=e[5],o=e[9],l=e[2],c=e[6],h=e[10];return t*(a*h-o*c)-n*(r*h-o*l)+s*(r*c-a*l)}transpose(){const e=this.elements;let t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){const s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=n),this}invert(){const e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],a=e[4],o=e[5],l=e[6],c=e[7],h=e[8],d=e[9],u=e[10],m=e[11],g=e[12],v=e[13],f=e[14],p=e[15],x=t*o-n*a,E=t*l-s*a,S=t*c-r*a,C=n*l-s*o,A=n*c-r*o,_=s*c-r*l,w=h*v-d*g,I=h*f-u*g,P=h*p-m*g,U=d*f-u*v,O=d*p-m*v,X=u*p-m*f,D=x*X-E*O+S*U+C*P-A*I+_*w;if(D===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);const G=1/D;return e[0]=(o*X-l*O+c*U)*G,e[1]=(s*O-n*X-r*U)*G,e[2]=(v*_-f*A+p*C)*G,e[3]=(u*A-d*_-m*C)*G,e[4]=(l*P-a*X-c*I)*G,e[5]=(t*X-s*P+r*I)*G,e[6]=(f*S-g*_-p*E)*G,e[7]=(h*_-u*S+m*E)*G,e[8]=(a*O-o*P+c*w)*G,e[9]=(n*P-t*O-r*w)*G,e[10]=(g*A-v*S+p*x)*G,e[11]=(d*S-h*A-m*x)*G,e[12]=(o*I-a*U-l*w)*G,e[13]=(t*U-n*I+s*w)*G,e[14]=(v*E-g*C-f*x)*G,e[15]=(h*C-d*E+u*x)*G,this}scale(e){const t=this.elements,n=e.x,s=e.y,r=e.z;return t[0]*=n,t[4]*=s,t[8]*=r,t[1]*=n,t[5]*=s,t[9]*=r,t[2]*=n,t[6]*=s,t[10]*=r,t[3]*=n,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){const e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,s))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){const t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){const t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){const t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){const n=Math.cos(t),s=Math.sin(t),r=1-n,a=e.x,o=e.y,l=e.z,c=r*a,h=r*o;return this.set(c*a+n,c*o-s*l,c*l+s*o,0,c*o+s*l,h*o+n,h*l-s*a,0,c*l-s*o,h*l+s*a,r*l*l+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,s,r,a){return this.set(1,n,r,0,e,1,a,0,t,s,1,0,0,0,0,1),this}compose(e,t,n){const s=this.elements,r=t._x,a=t._y,o=t._z,l=t._w,c=r+r,h=a+a,d=o+o,u=r*c,m=r*h,g=r*d,v=a*h,f=a*d,p=o*d,x=l*c,E=l*h,S=l*d,C=n.x,A=n.y,_=n.z;return s[0]=(1-(v+p))*C,s[1]=(m+S)*C,s[2]=(g-E)*C,s[3]=0,s[4]=(m-S)*A,s[5]=(1-(u+p))*A,s[6]=(f+x)*A,s[7]=0,s[8]=(g+E)*_,s[9]=(f-x)*_,s[10]=(1-(u+v))*_,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,n){const s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];const r=this.determinantAffine();if(r===0)return n.set(1,1,1),t.identity(),this;let a=Ti.set(s[0],s[1],s[2]).length();const o=Ti.set(s[4],s[5],s[6]).length(),l=Ti.set(s[8],s[9],s[10]).length();r<0&&(a=-a),xn.copy(this);const c=1/a,h=1/o,d=1/l;return xn.elements[0]*=c,xn.elements[1]*=c,xn.elements[2]*=c,xn.elements[4]*=h,xn.elements[5]*=h,xn.elements[6]*=h,xn.elements[8]*=d,xn.elements[9]*=d,xn.elements[10]*=d,t.setFromRotationMatrix(xn),n.x=a,n.y=o,n.z=l,this}makePerspective(e,t,n,s,r,a,o=En,l=!1){const c=this.elements,h=2*r/(t-e),d=2*r/(n-s),u=(t+e)/(t-e),m=(n+s)/(n-s);let g,v;if(l)g=r/(a-r),v=a*r/(a-r);else if(o===En)g=-(a+r)/(a-r),v=-2*a*r/(a-r);else if(o===Rs)g=-a/(a-r),v=-a*r/(a-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+o);return c[0]=h,c[4]=0,c[8]=u,c[12]=0,c[1]=0,c[5]=d,c[9]=m,c[13]=0,c[2]=0,c[6]=0,c[10]=g,c[14]=v,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,n,s,r,a,o=En,l=!1){const c=this.elements,h=2/(t-e),d=2/(n-s),u=-(t+e)/(t-e),m=-(n+s)/(n-s);let g,v;if(l)g=1/(a-r),v=a/(a-r);else if(o===En)g=-2/(a-r),v=-(a+r)/(a-r);else if(o===Rs)g=-1/(a-r),v=-r/(a-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+o);return c[0]=h,c[4]=0,c[8]=0,c[12]=u,c[1]=0,c[5]=d,c[9]=0,c[13]=m,c[2]=0,c[6]=0,c[10]=g,c[14]=v,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){const t=this.elements,n=e.elements;for(let s=0;s<16;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){const n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}}const Ti=new T,xn=new Ge,df=new T(0,0,0),ff=new T(1,1,1),Yn=new T,$s=new T,Qt=new T,ql=new Ge,Yl=new pt;class _n{constructor(e=0,t=0,n=0,s=_n.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,s=this._order){return this._x=e,this._y=t,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){const s=e.elements,r=s[0],a=s[4],o=s[8],l=s[1],c=s[5],h=s[9],d=s[2],u=s[6],m=s[10];switch(t){case"XYZ":this._y=Math.asin(Ve(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(-h,m),this._z=Math.atan2(-a,r)):(this._x=Math.atan2(u,c),this._z=0);break;case"YXZ":this._x=Math.asin(-Ve(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(o,m),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-d,r),this._z=0);break;case"ZXY":this._x=Math.asin(Ve(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(-d,m),this._z=Math.atan2(-a,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-Ve(d,-1,1)),Math.abs(d)<.9999999?(this._x=Math.atan2(u,m),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-a,c));break;case"YZX":this._z=Math.asin(Ve(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-d,r)):(this._x=0,this._y=Math.atan2(o,m));break;case"XZY":this._z=Math.asin(-Ve(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(u,c),this._y=Math.atan2(o,r)):(this._x=Math.atan2(-h,m),this._y=0);break;default:De("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return ql.makeRotationFromQuaternion(e),this.setFromRotationMatrix(ql,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return Yl.setFromEuler(this),this.setFromQuaternion(Yl,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}}_n.DEFAULT_ORDER="XYZ";class dl{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}}let pf=0;const Zl=new T,Ai=new pt,Bn=new Ge,qs=new T,cs=new T,mf=new T,gf=new pt,Kl=new T(1,0,0),Jl=new T(0,1,0),jl=new T(0,0,1),Ql={type:"added"},_f={type:"removed"},Ri={type:"childadded",child:null},xa={type:"childremoved",child:null};class ht extends ci{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:pf++}),this.uuid=Us(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=ht.DEFAULT_UP.clone();const e=new T,t=new _n,n=new pt,s=new T(1,1,1);function r(){n.setFromEuler(t,!1)}function a(){t.setFromQuaternion(n,void 0,!1)}t._onChange(r),n._onChange(a),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Ge},normalMatrix:{value:new Be}}),this.matrix=new Ge,this.matrixWorld=new Ge,this.matrixAutoUpdate=ht.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=ht.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new dl,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Ai.setFromAxisAngle(e,t),this.quaternion.multiply(Ai),this}rotateOnWorldAxis(e,t){return Ai.setFromAxisAngle(e,t),this.quaternion.premultiply(Ai),this}rotateX(e){return this.rotateOnAxis(Kl,e)}rotateY(e){return this.rotateOnAxis(Jl,e)}rotateZ(e){return this.rotateOnAxis(jl,e)}translateOnAxis(e,t){return Zl.copy(e).applyQuaternion(this.quaternion),this.position.add(Zl.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(Kl,e)}translateY(e){return this.translateOnAxis(Jl,e)}translateZ(e){return this.translateOnAxis(jl,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(Bn.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?qs.copy(e):qs.set(e,t,n);const s=this.parent;this.updateWorldMatrix(!0,!1),cs.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Bn.lookAt(cs,qs,this.up):Bn.lookAt(qs,cs,this.up),this.quaternion.setFromRotationMatrix(Bn),s&&(Bn.extractRotation(s.matrixWorld),Ai.setFromRotationMatrix(Bn),this.quaternion.premultiply(Ai.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(Ke("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(Ql),Ri.child=e,this.dispatchEvent(Ri),Ri.child=null):Ke("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}const t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(_f),xa.child=e,this.dispatchEvent(xa),xa.child=null),this}removeFromParent(){const e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),Bn.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),Bn.multiply(e.parent.matrixWorld)),e.applyMatrix4(Bn),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(Ql),Ri.child=e,this.dispatchEvent(Ri),Ri.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,s=this.children.length;n<s;n++){const a=this.children[n].getObjectByProperty(e,t);if(a!==void 0)return a}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);const s=this.children;for(let r=0,a=s.length;r<a;r++)s[r].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(cs,e,mf),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(cs,gf,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);const t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);const t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);const t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverseVisible(e)}traverseAncestors(e){const t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);const e=this.pivot;if(e!==null){const t=e.x,n=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*n-r[8]*s,r[13]+=n-r[1]*t-r[5]*n-r[9]*s,r[14]+=s-r[2]*t-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);const t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t,n=!1){const s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),t===!0){const r=this.children;for(let a=0,o=r.length;a<o;a++)r[a].updateWorldMatrix(!1,!0,n)}}toJSON(e){const t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});const s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(o=>({...o,boundingBox:o.boundingBox?o.boundingBox.toJSON():void 0,boundingSphere:o.boundingSphere?o.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(o=>({...o})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(o,l){return o[l.uuid]===void 0&&(o[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);const o=this.geometry.parameters;if(o!==void 0&&o.shapes!==void 0){const l=o.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){const d=l[c];r(e.shapes,d)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){const o=[];for(let l=0,c=this.material.length;l<c;l++)o.push(r(e.materials,this.material[l]));s.material=o}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let o=0;o<this.children.length;o++)s.children.push(this.children[o].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let o=0;o<this.animations.length;o++){const l=this.animations[o];s.animations.push(r(e.animations,l))}}if(t){const o=a(e.geometries),l=a(e.materials),c=a(e.textures),h=a(e.images),d=a(e.shapes),u=a(e.skeletons),m=a(e.animations),g=a(e.nodes);o.length>0&&(n.geometries=o),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),h.length>0&&(n.images=h),d.length>0&&(n.shapes=d),u.length>0&&(n.skeletons=u),m.length>0&&(n.animations=m),g.length>0&&(n.nodes=g)}return n.object=s,n;function a(o){const l=[];for(const c in o){const h=o[c];delete h.metadata,l.push(h)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){const s=e.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}}ht.DEFAULT_UP=new T(0,1,0);ht.DEFAULT_MATRIX_AUTO_UPDATE=!0;ht.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;class Tt extends ht{constructor(){super(),this.isGroup=!0,this.type="Group"}}const vf={type:"move"};class Ma{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Tt,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Tt,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new T,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new T),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Tt,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new T,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new T,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){const t=this._hand;if(t)for(const n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let s=null,r=null,a=null;const o=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){a=!0;for(const v of e.hand.values()){const f=t.getJointPose(v,n),p=this._getHandJoint(c,v);f!==null&&(p.matrix.fromArray(f.transform.matrix),p.matrix.decompose(p.position,p.quaternion,p.scale),p.matrixWorldNeedsUpdate=!0,p.jointRadius=f.radius),p.visible=f!==null}const h=c.joints["index-finger-tip"],d=c.joints["thumb-tip"],u=h.position.distanceTo(d.position),m=.02,g=.005;c.inputState.pinching&&u>m+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&u<=m-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));o!==null&&(s=t.getPose(e.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(o.matrix.fromArray(s.transform.matrix),o.matrix.decompose(o.position,o.quaternion,o.scale),o.matrixWorldNeedsUpdate=!0,s.linearVelocity?(o.hasLinearVelocity=!0,o.linearVelocity.copy(s.linearVelocity)):o.hasLinearVelocity=!1,s.angularVelocity?(o.hasAngularVelocity=!0,o.angularVelocity.copy(s.angularVelocity)):o.hasAngularVelocity=!1,this.dispatchEvent(vf)))}return o!==null&&(o.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=a!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){const n=new Tt;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}}const Kh={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Zn={h:0,s:0,l:0},Ys={h:0,s:0,l:0};function ya(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}class Ue{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){const s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=dn){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,qe.colorSpaceToWorking(this,t),this}setRGB(e,t,n,s=qe.workingColorSpace){return this.r=e,this.g=t,this.b=n,qe.colorSpaceToWorking(this,s),this}setHSL(e,t,n,s=qe.workingColorSpace){if(e=tf(e,1),t=Ve(t,0,1),n=Ve(n,0,1),t===0)this.r=this.g=this.b=n;else{const r=n<=.5?n*(1+t):n+t-n*t,a=2*n-r;this.r=ya(a,r,e+1/3),this.g=ya(a,r,e),this.b=ya(a,r,e-1/3)}return qe.colorSpaceToWorking(this,s),this}setStyle(e,t=dn){function n(r){r!==void 0&&parseFloat(r)<1&&De("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r;const a=s[1],o=s[2];switch(a){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:De("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){const r=s[1],a=r.length;if(a===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(a===6)return this.setHex(parseInt(r,16),t);De("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=dn){const n=Kh[e.toLowerCase()];return n!==void 0?this.setHex(n,t):De("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Xn(e.r),this.g=Xn(e.g),this.b=Xn(e.b),this}copyLinearToSRGB(e){return this.r=Xi(e.r),this.g=Xi(e.g),this.b=Xi(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=dn){return qe.workingToColorSpace(Gt.copy(this),e),Math.round(Ve(Gt.r*255,0,255))*65536+Math.round(Ve(Gt.g*255,0,255))*256+Math.round(Ve(Gt.b*255,0,255))}getHexString(e=dn){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=qe.workingColorSpace){qe.workingToColorSpace(Gt.copy(this),t);const n=Gt.r,s=Gt.g,r=Gt.b,a=Math.max(n,s,r),o=Math.min(n,s,r);let l,c;const h=(o+a)/2;if(o===a)l=0,c=0;else{const d=a-o;switch(c=h<=.5?d/(a+o):d/(2-a-o),a){case n:l=(s-r)/d+(s<r?6:0);break;case s:l=(r-n)/d+2;break;case r:l=(n-s)/d+4;break}l/=6}return e.h=l,e.s=c,e.l=h,e}getRGB(e,t=qe.workingColorSpace){return qe.workingToColorSpace(Gt.copy(this),t),e.r=Gt.r,e.g=Gt.g,e.b=Gt.b,e}getStyle(e=dn){qe.workingToColorSpace(Gt.copy(this),e);const t=Gt.r,n=Gt.g,s=Gt.b;return e!==dn?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(e,t,n){return this.getHSL(Zn),this.setHSL(Zn.h+e,Zn.s+t,Zn.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(Zn),e.getHSL(Ys);const n=pa(Zn.h,Ys.h,t),s=pa(Zn.s,Ys.s,t),r=pa(Zn.l,Ys.l,t);return this.setHSL(n,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){const t=this.r,n=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*n+r[6]*s,this.g=r[1]*t+r[4]*n+r[7]*s,this.b=r[2]*t+r[5]*n+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}}const Gt=new Ue;Ue.NAMES=Kh;class xf extends ht{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new _n,this.environmentIntensity=1,this.environmentRotation=new _n,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){const t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}}const Mn=new T,kn=new T,ba=new T,zn=new T,Ci=new T,Pi=new T,ec=new T,Sa=new T,wa=new T,Ea=new T,Ta=new _t,Aa=new _t,Ra=new _t;class fn{constructor(e=new T,t=new T,n=new T){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,s){s.subVectors(n,t),Mn.subVectors(e,t),s.cross(Mn);const r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,n,s,r){Mn.subVectors(s,t),kn.subVectors(n,t),ba.subVectors(e,t);const a=Mn.dot(Mn),o=Mn.dot(kn),l=Mn.dot(ba),c=kn.dot(kn),h=kn.dot(ba),d=a*c-o*o;if(d===0)return r.set(0,0,0),null;const u=1/d,m=(c*l-o*h)*u,g=(a*h-o*l)*u;return r.set(1-m-g,g,m)}static containsPoint(e,t,n,s){return this.getBarycoord(e,t,n,s,zn)===null?!1:zn.x>=0&&zn.y>=0&&zn.x+zn.y<=1}static getInterpolation(e,t,n,s,r,a,o,l){return this.getBarycoord(e,t,n,s,zn)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,zn.x),l.addScaledVector(a,zn.y),l.addScaledVector(o,zn.z),l)}static getInterpolatedAttribute(e,t,n,s,r,a){return Ta.setScalar(0),Aa.setScalar(0),Ra.setScalar(0),Ta.fromBufferAttribute(e,t),Aa.fromBufferAttribute(e,n),Ra.fromBufferAttribute(e,s),a.setScalar(0),a.addScaledVector(Ta,r.x),a.addScaledVector(Aa,r.y),a.addScaledVector(Ra,r.z),a}static isFrontFacing(e,t,n,s){return Mn.subVectors(n,t),kn.subVectors(e,t),Mn.cross(kn).dot(s)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,s){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,n,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Mn.subVectors(this.c,this.b),kn.subVectors(this.a,this.b),Mn.cross(kn).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return fn.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return fn.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,s,r){return fn.getInterpolation(e,this.a,this.b,this.c,t,n,s,r)}containsPoint(e){return fn.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return fn.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){const n=this.a,s=this.b,r=this.c;let a,o;Ci.subVectors(s,n),Pi.subVectors(r,n),Sa.subVectors(e,n);const l=Ci.dot(Sa),c=Pi.dot(Sa);if(l<=0&&c<=0)return t.copy(n);wa.subVectors(e,s);const h=Ci.dot(wa),d=Pi.dot(wa);if(h>=0&&d<=h)return t.copy(s);const u=l*d-h*c;if(u<=0&&l>=0&&h<=0&&l-h>0)return a=l/(l-h),t.copy(n).addScaledVector(Ci,a);Ea.subVectors(e,r);const m=Ci.dot(Ea),g=Pi.dot(Ea);if(g>=0&&m<=g)return t.copy(r);const v=m*c-l*g;if(v<=0&&c>=0&&g<=0)return o=c/(c-g),t.copy(n).addScaledVector(Pi,o);const f=h*g-m*d;if(f<=0&&d-h>=0&&m-g>=0)return ec.subVectors(r,s),o=(d-h)/(d-h+(m-g)),t.copy(s).addScaledVector(ec,o);const p=1/(f+v+u);return a=v*p,o=u*p,t.copy(n).addScaledVector(Ci,a).addScaledVector(Pi,o)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}}class Si{constructor(e=new T(1/0,1/0,1/0),t=new T(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(yn.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(yn.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){const n=yn.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);const n=e.geometry;if(n!==void 0){const r=n.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let a=0,o=r.count;a<o;a++)e.isMesh===!0?e.getVertexPosition(a,yn):yn.fromBufferAttribute(r,a),yn.applyMatrix4(e.matrixWorld),this.expandByPoint(yn);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Zs.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),Zs.copy(n.boundingBox)),Zs.applyMatrix4(e.matrixWorld),this.union(Zs)}const s=e.children;for(let r=0,a=s.length;r<a;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,yn),yn.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(hs),Ks.subVectors(this.max,hs),Li.subVectors(e.a,hs),Di.subVectors(e.b,hs),Ni.subVectors(e.c,hs),Kn.subVectors(Di,Li),Jn.subVectors(Ni,Di),pi.subVectors(Li,Ni);let t=[0,-Kn.z,Kn.y,0,-Jn.z,Jn.y,0,-pi.z,pi.y,Kn.z,0,-Kn.x,Jn.z,0,-Jn.x,pi.z,0,-pi.x,-Kn.y,Kn.x,0,-Jn.y,Jn.x,0,-pi.y,pi.x,0];return!Ca(t,Li,Di,Ni,Ks)||(t=[1,0,0,0,1,0,0,0,1],!Ca(t,Li,Di,Ni,Ks))?!1:(Js.crossVectors(Kn,Jn),t=[Js.x,Js.y,Js.z],Ca(t,Li,Di,Ni,Ks))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,yn).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(yn).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(Hn[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),Hn[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),Hn[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),Hn[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),Hn[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),Hn[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),Hn[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),Hn[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(Hn),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}}const Hn=[new T,new T,new T,new T,new T,new T,new T,new T],yn=new T,Zs=new Si,Li=new T,Di=new T,Ni=new T,Kn=new T,Jn=new T,pi=new T,hs=new T,Ks=new T,Js=new T,mi=new T;function Ca(i,e,t,n,s){for(let r=0,a=i.length-3;r<=a;r+=3){mi.fromArray(i,r);const o=s.x*Math.abs(mi.x)+s.y*Math.abs(mi.y)+s.z*Math.abs(mi.z),l=e.dot(mi),c=t.dot(mi),h=n.dot(mi);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>o)return!1}return!0}const yt=new T,js=new Ee;let Mf=0;class vt extends ci{constructor(e,t,n=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Mf++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=Kd,this.updateRanges=[],this.gpuType=pn,this.version=0,this._normalizationScale=e!==void 0?hl(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[n+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)js.fromBufferAttribute(this,t),js.applyMatrix3(e),this.setXY(t,js.x,js.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)yt.fromBufferAttribute(this,t),yt.applyMatrix3(e),this.setXYZ(t,yt.x,yt.y,yt.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)yt.fromBufferAttribute(this,t),yt.applyMatrix4(e),this.setXYZ(t,yt.x,yt.y,yt.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)yt.fromBufferAttribute(this,t),yt.applyNormalMatrix(e),this.setXYZ(t,yt.x,yt.y,yt.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)yt.fromBufferAttribute(this,t),yt.transformDirection(e),this.setXYZ(t,yt.x,yt.y,yt.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){const e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){const t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):sf(e,this.array)}_normalize(e){const t=this._normalizationScale;return t!==void 0?Math.round(e*t):rf(e,this.array)}}class Jh extends vt{constructor(e,t,n){super(new Uint16Array(e),t,n)}}class jh extends vt{constructor(e,t,n){super(new Uint32Array(e),t,n)}}class nt extends vt{constructor(e,t,n){super(new Float32Array(e),t,n)}}const yf=new Si,us=new T,Pa=new T;class Fs{constructor(e=new T,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){const n=this.center;t!==void 0?n.copy(t):yf.setFromPoints(e).getCenter(n);let s=0;for(let r=0,a=e.length;r<a;r++)s=Math.max(s,n.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){const t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){const n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;us.subVectors(e,this.center);const t=us.lengthSq();if(t>this.radius*this.radius){const n=Math.sqrt(t),s=(n-this.radius)*.5;this.center.addScaledVector(us,s/n),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Pa.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(us.copy(e.center).add(Pa)),this.expandByPoint(us.copy(e.center).sub(Pa))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}}let bf=0;const hn=new Ge,La=new ht,Ii=new T,en=new Si,ds=new Si,Dt=new T;class Ye extends ci{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:bf++}),this.uuid=Us(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(Jd(e)?jh:Jh)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){const t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);const n=this.attributes.normal;if(n!==void 0){const r=new Be().getNormalMatrix(e);n.applyNormalMatrix(r),n.needsUpdate=!0}const s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return hn.makeRotationFromQuaternion(e),this.applyMatrix4(hn),this}rotateX(e){return hn.makeRotationX(e),this.applyMatrix4(hn),this}rotateY(e){return hn.makeRotationY(e),this.applyMatrix4(hn),this}rotateZ(e){return hn.makeRotationZ(e),this.applyMatrix4(hn),this}translate(e,t,n){return hn.makeTranslation(e,t,n),this.applyMatrix4(hn),this}scale(e,t,n){return hn.makeScale(e,t,n),this.applyMatrix4(hn),this}lookAt(e){return La.lookAt(e),La.updateMatrix(),this.applyMatrix4(La.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Ii).negate(),this.translate(Ii.x,Ii.y,Ii.z),this}setFromPoints(e){const t=this.getAttribute("position");if(t===void 0){const n=[];for(let s=0,r=e.length;s<r;s++){const a=e[s];n.push(a.x,a.y,a.z||0)}this.setAttribute("position",new nt(n,3))}else{const n=Math.min(e.length,t.count);for(let s=0;s<n;s++){const r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&De("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Si);const e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Ke("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new T(-1/0,-1/0,-1/0),new T(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,s=t.length;n<s;n++){const r=t[n];en.setFromBufferAttribute(r),this.morphTargetsRelative?(Dt.addVectors(this.boundingBox.min,en.min),this.boundingBox.expandByPoint(Dt),Dt.addVectors(this.boundingBox.max,en.max),this.boundingBox.expandByPoint(Dt)):(this.boundingBox.expandByPoint(en.min),this.boundingBox.expandByPoint(en.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&Ke('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Fs);const e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Ke("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new T,1/0);return}if(e){const n=this.boundingSphere.center;if(en.setFromBufferAttribute(e),t)for(let r=0,a=t.length;r<a;r++){const o=t[r];ds.setFromBufferAttribute(o),this.morphTargetsRelative?(Dt.addVectors(en.min,ds.min),en.expandByPoint(Dt),Dt.addVectors(en.max,ds.max),en.expandByPoint(Dt)):(en.expandByPoint(ds.min),en.expandByPoint(ds.max))}en.getCenter(n);let s=0;for(let r=0,a=e.count;r<a;r++)Dt.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(Dt));if(t)for(let r=0,a=t.length;r<a;r++){const o=t[r],l=this.morphTargetsRelative;for(let c=0,h=o.count;c<h;c++)Dt.fromBufferAttribute(o,c),l&&(Ii.fromBufferAttribute(e,c),Dt.add(Ii)),s=Math.max(s,n.distanceToSquared(Dt))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&Ke('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){const e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){Ke("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}const n=t.position,s=t.normal,r=t.uv;let a=this.getAttribute("tangent");(a===void 0||a.count!==n.count)&&(a=new vt(new Float32Array(4*n.count),4),this.setAttribute("tangent",a));const o=[],l=[],c=new Uint8Array(n.count);for(let I=0;I<n.count;I++)o[I]=new T,l[I]=new T;const h=new T,d=new T,u=new T,m=new Ee,g=new Ee,v=new Ee,f=new T,p=new T;function x(I,P,U){c[I]=c[P]=c[U]=1,h.fromBufferAttribute(n,I),d.fromBufferAttribute(n,P),u.fromBufferAttribute(n,U),m.fromBufferAttribute(r,I),g.fromBufferAttribute(r,P),v.fromBufferAttribute(r,U),d.sub(h),u.sub(h),g.sub(m),v.sub(m);const O=1/(g.x*v.y-v.x*g.y);isFinite(O)&&(f.copy(d).multiplyScalar(v.y).addScaledVector(u,-g.y).multiplyScalar(O),p.copy(u).multiplyScalar(g.x).addScaledVector(d,-v.x).multiplyScalar(O),o[I].add(f),o[P].add(f),o[U].add(f),l[I].add(p),l[P].add(p),l[U].add(p))}let E=this.groups;E.length===0&&(E=[{start:0,count:e.count}]);for(let I=0,P=E.length;I<P;++I){const U=E[I],O=U.start,X=U.count;for(let D=O,G=O+X;D<G;D+=3)x(e.getX(D+0),e.getX(D+1),e.getX(D+2))}const S=new T,C=new T,A=new T,_=new T;function w(I){A.fromBufferAttribute(s,I),_.copy(A);const P=o[I];S.copy(P),S.sub(A.multiplyScalar(A.dot(P))).normalize(),C.crossVectors(_,P);const O=C.dot(l[I])<0?-1:1;a.setXYZW(I,S.x,S.y,S.z,O)}for(let I=0,P=n.count;I<P;++I)c[I]&&w(I);this._transformed=!0}computeVertexNormals(){const e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==t.count)n=new vt(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let u=0,m=n.count;u<m;u++)n.setXYZ(u,0,0,0);const s=new T,r=new T,a=new T,o=new T,l=new T,c=new T,h=new T,d=new T;if(e)for(let u=0,m=e.count;u<m;u+=3){const g=e.getX(u+0),v=e.getX(u+1),f=e.getX(u+2);s.fromBufferAttribute(t,g),r.fromBufferAttribute(t,v),a.fromBufferAttribute(t,f),h.subVectors(a,r),d.subVectors(s,r),h.cross(d),o.fromBufferAttribute(n,g),l.fromBufferAttribute(n,v),c.fromBufferAttribute(n,f),o.add(h),l.add(h),c.add(h),n.setXYZ(g,o.x,o.y,o.z),n.setXYZ(v,l.x,l.y,l.z),n.setXYZ(f,c.x,c.y,c.z)}else for(let u=0,m=t.count;u<m;u+=3)s.fromBufferAttribute(t,u+0),r.fromBufferAttribute(t,u+1),a.fromBufferAttribute(t,u+2),h.subVectors(a,r),d.subVectors(s,r),h.cross(d),n.setXYZ(u+0,h.x,h.y,h.z),n.setXYZ(u+1,h.x,h.y,h.z),n.setXYZ(u+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){const e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)Dt.fromBufferAttribute(e,t),Dt.normalize(),e.setXYZ(t,Dt.x,Dt.y,Dt.z)}toNonIndexed(){function e(o,l){const c=o.array,h=o.itemSize,d=o.normalized,u=new c.constructor(l.length*h);let m=0,g=0;for(let v=0,f=l.length;v<f;v++){o.isInterleavedBufferAttribute?m=l[v]*o.data.stride+o.offset:m=l[v]*h;for(let p=0;p<h;p++)u[g++]=c[m++]}return new vt(u,h,d)}if(this.index===null)return De("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;const t=new Ye,n=this.index.array,s=this.attributes;for(const o in s){const l=s[o],c=e(l,n);t.setAttribute(o,c)}const r=this.morphAttributes;for(const o in r){const l=[],c=r[o];for(let h=0,d=c.length;h<d;h++){const u=c[h],m=e(u,n);l.push(m)}t.morphAttributes[o]=l}t.morphTargetsRelative=this.morphTargetsRelative;const a=this.groups;for(let o=0,l=a.length;o<l;o++){const c=a[o];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){const e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){const l=this.parameters;for(const c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};const t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});const n=this.attributes;for(const l in n){const c=n[l];e.data.attributes[l]=c.toJSON(e.data)}const s={};let r=!1;for(const l in this.morphAttributes){const c=this.morphAttributes[l],h=[];for(let d=0,u=c.length;d<u;d++){const m=c[d];h.push(m.toJSON(e.data))}h.length>0&&(s[l]=h,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);const a=this.groups;a.length>0&&(e.data.groups=JSON.parse(JSON.stringify(a)));const o=this.boundingSphere;return o!==null&&(e.data.boundingSphere=o.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;const t={};this.name=e.name;const n=e.index;n!==null&&this.setIndex(n.clone());const s=e.attributes;for(const c in s){const h=s[c];this.setAttribute(c,h.clone(t))}const r=e.morphAttributes;for(const c in r){const h=[],d=r[c];for(let u=0,m=d.length;u<m;u++)h.push(d[u].clone(t));this.morphAttributes[c]=h}this.morphTargetsRelative=e.morphTargetsRelative;const a=e.groups;for(let c=0,h=a.length;c<h;c++){const d=a[c];this.addGroup(d.start,d.count,d.materialIndex)}const o=e.boundingBox;o!==null&&(this.boundingBox=o.clone());const l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}}const Da=new T,Sf=new T,wf=new Be;class bn{constructor(e=new T(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,s){return this.normal.set(e,t,n),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){const s=Da.subVectors(n,t).cross(Sf.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){const e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,n=!0){const s=e.delta(Da),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;const a=-(e.start.dot(this.normal)+this.constant)/r;return n===!0&&(a<0||a>1)?null:t.copy(e.start).addScaledVector(s,a)}intersectsLine(e){const t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){const n=t||wf.getNormalMatrix(e),s=this.coplanarPoint(Da).applyMatrix4(e),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}}let Ef=0;class hi extends ci{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Ef++}),this.uuid=Us(),this.name="",this.type="Material",this.blending=bs,this.side=yi,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Ah,this.blendDst=Rh,this.blendEquation=zi,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Ue(0,0,0),this.blendAlpha=0,this.depthFunc=Es,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Wd,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=fa,this.stencilZFail=fa,this.stencilZPass=fa,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(const t in e){const n=e[t];if(n===void 0){De(`Material: parameter '${t}' has value of undefined.`);continue}const s=this[t];if(s===void 0){De(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[t]=n}}toJSON(e){const t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});const n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){const a=[];for(const o in r){const l=r[o];delete l.metadata,a.push(l)}return a}if(t){const r=s(e.textures),a=s(e.images);r.length>0&&(n.textures=r),a.length>0&&(n.images=a)}return n}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new Ue().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(n=>new bn().fromJSON(n))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let n=e.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new Ee().fromArray(n)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Ee().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;const t=e.clippingPlanes;let n=null;if(t!==null){const s=t.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=t[r].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}}const Gn=new T,Na=new T,Qs=new T,er=new T;class Os{constructor(e=new T,t=new T(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Gn)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);const n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){const t=Gn.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Gn.copy(this.origin).addScaledVector(this.direction,t),Gn.distanceToSquared(e))}distanceSqToSegment(e,t,n,s){Na.copy(e).add(t).multiplyScalar(.5),Qs.copy(t).sub(e).normalize(),er.copy(this.origin).sub(Na);const r=e.distanceTo(t)*.5,a=-this.direction.dot(Qs),o=er.dot(this.direction),l=-er.dot(Qs),c=er.lengthSq(),h=Math.abs(1-a*a);let d,u,m,g;if(h>0)if(d=a*l-o,u=a*o-l,g=r*h,d>=0)if(u>=-g)if(u<=g){const v=1/h;d*=v,u*=v,m=d*(d+a*u+2*o)+u*(a*d+u+2*l)+c}else u=r,d=Math.max(0,-(a*u+o)),m=-d*d+u*(u+2*l)+c;else u=-r,d=Math.max(0,-(a*u+o)),m=-d*d+u*(u+2*l)+c;else u<=-g?(d=Math.max(0,-(-a*r+o)),u=d>0?-r:Math.min(Math.max(-r,-l),r),m=-d*d+u*(u+2*l)+c):u<=g?(d=0,u=Math.min(Math.max(-r,-l),r),m=u*(u+2*l)+c):(d=Math.max(0,-(a*r+o)),u=d>0?r:Math.min(Math.max(-r,-l),r),m=-d*d+u*(u+2*l)+c);else u=a>0?-r:r,d=Math.max(0,-(a*u+o)),m=-d*d+u*(u+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,d),s&&s.copy(Na).addScaledVector(Qs,u),m}intersectSphere(e,t){if(e.radius<0)return null;Gn.subVectors(e.center,this.origin);const n=Gn.dot(this.direction),s=Gn.dot(Gn)-n*n,r=e.radius*e.radius;if(s>r)return null;const a=Math.sqrt(r-s),o=n-a,l=n+a;return l<0?null:o<0?this.at(l,t):this.at(o,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){const t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;const n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){const n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){const t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,s,r,a,o,l;const c=1/this.direction.x,h=1/this.direction.y,d=1/this.direction.z,u=this.origin;return c>=0?(n=(e.min.x-u.x)*c,s=(e.max.x-u.x)*c):(n=(e.max.x-u.x)*c,s=(e.min.x-u.x)*c),h>=0?(r=(e.min.y-u.y)*h,a=(e.max.y-u.y)*h):(r=(e.max.y-u.y)*h,a=(e.min.y-u.y)*h),n>a||r>s||((r>n||isNaN(n))&&(n=r),(a<s||isNaN(s))&&(s=a),d>=0?(o=(e.min.z-u.z)*d,l=(e.max.z-u.z)*d):(o=(e.max.z-u.z)*d,l=(e.min.z-u.z)*d),n>l||o>s)||((o>n||n!==n)&&(n=o),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,t)}intersectsBox(e){return this.intersectBox(e,Gn)!==null}intersectTriangle(e,t,n,s,r){const a=this.origin,o=this.direction,l=o.x,c=o.y,h=o.z,d=e.x-a.x,u=e.y-a.y,m=e.z-a.z,g=t.x-a.x,v=t.y-a.y,f=t.z-a.z,p=n.x-a.x,x=n.y-a.y,E=n.z-a.z,S=Math.abs(l),C=Math.abs(c),A=Math.abs(h);let _,w,I,P,U,O,X,D,G,Y,B,te;if(S>=C&&S>=A?(I=l,O=d,G=g,te=p,l>=0?(_=c,w=h,P=u,U=m,X=v,D=f,Y=x,B=E):(_=h,w=c,P=m,U=u,X=f,D=v,Y=E,B=x)):C>=A?(I=c,O=u,G=v,te=x,c>=0?(_=h,w=l,P=m,U=d,X=f,D=g,Y=E,B=p):(_=l,w=h,P=d,U=m,X=g,D=f,Y=p,B=E)):(I=h,O=m,G=f,te=E,h>=0?(_=l,w=c,P=d,U=u,X=g,D=v,Y=p,B=x):(_=c,w=l,P=u,U=d,X=v,D=g,Y=x,B=p)),I===0)return null;const V=_/I,Q=w/I,ee=1/I,xe=P-V*O,Ne=U-Q*O,Z=X-V*G,ge=D-Q*G,ye=Y-V*te,Ce=B-Q*te,_e=ye*ge-Ce*Z,Oe=xe*Ce-Ne*ye,xt=Z*Ne-ge*xe;if(s){if(_e<0||Oe<0||xt<0)return null}else if((_e<0||Oe<0||xt<0)&&(_e>0||Oe>0||xt>0))return null;const Le=_e+Oe+xt;if(Le===0)return null;const Qe=ee*(_e*O+Oe*G+xt*te);return(Le>0?Qe<0:Qe>0)?null:this.at(Qe/Le,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}}class as extends hi{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Ue(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new _n,this.combine=il,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}}const tc=new Ge,gi=new Os,tr=new Fs,nc=new T,nr=new T,ir=new T,sr=new T,Ia=new T,rr=new T,ic=new T,ar=new T;class fe extends ht{constructor(e=new Ye,t=new as){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){const t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){const s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,a=s.length;r<a;r++){const o=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[o]=r}}}}getVertexPosition(e,t){const n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,a=n.morphTargetsRelative;t.fromBufferAttribute(s,e);const o=this.morphTargetInfluences;if(r&&o){rr.set(0,0,0);for(let l=0,c=r.length;l<c;l++){const h=o[l],d=r[l];h!==0&&(Ia.fromBufferAttribute(d,e),a?rr.addScaledVector(Ia,h):rr.addScaledVector(Ia.sub(t),h))}t.add(rr)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){const n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),tr.copy(n.boundingSphere),tr.applyMatrix4(r),gi.copy(e.ray).recast(e.near),!(tr.containsPoint(gi.origin)===!1&&(gi.intersectSphere(tr,nc)===null||gi.origin.distanceToSquared(nc)>(e.far-e.near)**2))&&(tc.copy(r).invert(),gi.copy(e.ray).applyMatrix4(tc),!(n.boundingBox!==null&&gi.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,gi)))}_computeIntersections(e,t,n){let s;const r=this.geometry,a=this.material,o=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,d=r.attributes.normal,u=r.groups,m=r.drawRange;if(o!==null)if(Array.isArray(a))for(let g=0,v=u.length;g<v;g++){const f=u[g],p=a[f.materialIndex],x=Math.max(f.start,m.start),E=Math.min(o.count,Math.min(f.start+f.count,m.start+m.count));for(let S=x,C=E;S<C;S+=3){const A=o.getX(S),_=o.getX(S+1),w=o.getX(S+2);s=or(this,p,e,n,c,h,d,A,_,w),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=f.materialIndex,t.push(s))}}else{const g=Math.max(0,m.start),v=Math.min(o.count,m.start+m.count);for(let f=g,p=v;f<p;f+=3){const x=o.getX(f),E=o.getX(f+1),S=o.getX(f+2);s=or(this,a,e,n,c,h,d,x,E,S),s&&(s.faceIndex=Math.floor(f/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(a))for(let g=0,v=u.length;g<v;g++){const f=u[g],p=a[f.materialIndex],x=Math.max(f.start,m.start),E=Math.min(l.count,Math.min(f.start+f.count,m.start+m.count));for(let S=x,C=E;S<C;S+=3){const A=S,_=S+1,w=S+2;s=or(this,p,e,n,c,h,d,A,_,w),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=f.materialIndex,t.push(s))}}else{const g=Math.max(0,m.start),v=Math.min(l.count,m.start+m.count);for(let f=g,p=v;f<p;f+=3){const x=f,E=f+1,S=f+2;s=or(this,a,e,n,c,h,d,x,E,S),s&&(s.faceIndex=Math.floor(f/3),t.push(s))}}}}function Tf(i,e,t,n,s,r,a,o){let l;if(e.side===Yt?l=n.intersectTriangle(a,r,s,!0,o):l=n.intersectTriangle(s,r,a,e.side===yi,o),l===null)return null;ar.copy(o),ar.applyMatrix4(i.matrixWorld);const c=t.ray.origin.distanceTo(ar);return c<t.near||c>t.far?null:{distance:c,point:ar.clone(),object:i}}function or(i,e,t,n,s,r,a,o,l,c){i.getVertexPosition(o,nr),i.getVertexPosition(l,ir),i.getVertexPosition(c,sr);const h=Tf(i,e,t,n,nr,ir,sr,ic);if(h){const d=new T;fn.getBarycoord(ic,nr,ir,sr,d),s&&(h.uv=fn.getInterpolatedAttribute(s,o,l,c,d,new Ee)),r&&(h.uv1=fn.getInterpolatedAttribute(r,o,l,c,d,new Ee)),a&&(h.normal=fn.getInterpolatedAttribute(a,o,l,c,d,new T),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));const u={a:o,b:l,c,normal:new T,materialIndex:0};fn.getNormal(nr,ir,sr,u.normal),h.face=u,h.barycoord=d}return h}class Qh extends Zt{constructor(e=null,t=1,n=1,s,r,a,o,l,c=Ot,h=Ot,d,u){super(null,a,o,l,c,h,s,r,d,u),this.isDataTexture=!0,this.image={data:e,width:t,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}}const _i=new Fs,Af=new Ee(.5,.5),lr=new T;class Cs{constructor(e=new bn,t=new bn,n=new bn,s=new bn,r=new bn,a=new bn){this.planes=[e,t,n,s,r,a]}set(e,t,n,s,r,a){const o=this.planes;return o[0].copy(e),o[1].copy(t),o[2].copy(n),o[3].copy(s),o[4].copy(r),o[5].copy(a),this}copy(e){const t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=En,n=!1){const s=this.planes,r=e.elements,a=r[0],o=r[1],l=r[2],c=r[3],h=r[4],d=r[5],u=r[6],m=r[7],g=r[8],v=r[9],f=r[10],p=r[11],x=r[12],E=r[13],S=r[14],C=r[15];if(s[0].setComponents(c-a,m-h,p-g,C-x).normalize(),s[1].setComponents(c+a,m+h,p+g,C+x).normalize(),s[2].setComponents(c+o,m+d,p+v,C+E).normalize(),s[3].setComponents(c-o,m-d,p-v,C-E).normalize(),n)s[4].setComponents(l,u,f,S).normalize(),s[5].setComponents(c-l,m-u,p-f,C-S).normalize();else if(s[4].setComponents(c-l,m-u,p-f,C-S).normalize(),t===En)s[5].setComponents(c+l,m+u,p+f,C+S).normalize();else if(t===Rs)s[5].setComponents(l,u,f,S).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),_i.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{const t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),_i.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(_i)}intersectsSprite(e){_i.center.set(0,0,0);const t=Af.distanceTo(e.center);return _i.radius=.7071067811865476+t,_i.applyMatrix4(e.matrixWorld),this.intersectsSphere(_i)}intersectsSphere(e){const t=this.planes,n=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(e){const t=this.planes;for(let n=0;n<6;n++){const s=t[n];if(lr.x=s.normal.x>0?e.max.x:e.min.x,lr.y=s.normal.y>0?e.max.y:e.min.y,lr.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(lr)<0)return!1}return!0}containsPoint(e){const t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}}const sc=new Ge;class fl{constructor(){this.coordinateSystem=En,this._frustums=[],this._count=0}setFromArrayCamera(e){const t=e.cameras,n=this._frustums;for(let s=0;s<t.length;s++){const r=t[s];sc.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new Cs),n[s].setFromProjectionMatrix(sc,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){const t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsObject(e))return!0;return!1}intersectsSprite(e){const t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSprite(e))return!0;return!1}intersectsSphere(e){const t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSphere(e))return!0;return!1}intersectsBox(e){const t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsBox(e))return!0;return!1}containsPoint(e){const t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;const t=this._frustums,n=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new Cs),t[s].copy(n[s]);return this._count=e._count,this}clone(){return new fl().copy(this)}}class Fn extends hi{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new Ue(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}}const Xr=new T,$r=new T,rc=new Ge,fs=new Os,cr=new Fs,Ua=new T,ac=new T;class un extends ht{constructor(e=new Ye,t=new Fn){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){const e=this.geometry;if(e.index===null){const t=e.attributes.position,n=[0];for(let s=1,r=t.count;s<r;s++)Xr.fromBufferAttribute(t,s-1),$r.fromBufferAttribute(t,s),n[s]=n[s-1],n[s]+=Xr.distanceTo($r);e.setAttribute("lineDistance",new nt(n,1))}else De("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){const n=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,a=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),cr.copy(n.boundingSphere),cr.applyMatrix4(s),cr.radius+=r,e.ray.intersectsSphere(cr)===!1)return;rc.copy(s).invert(),fs.copy(e.ray).applyMatrix4(rc);const o=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=o*o,c=this.isLineSegments?2:1,h=n.index,u=n.attributes.position;if(h!==null){const m=Math.max(0,a.start),g=Math.min(h.count,a.start+a.count);for(let v=m,f=g-1;v<f;v+=c){const p=h.getX(v),x=h.getX(v+1),E=hr(this,e,fs,l,p,x,v);E&&t.push(E)}if(this.isLineLoop){const v=h.getX(g-1),f=h.getX(m),p=hr(this,e,fs,l,v,f,g-1);p&&t.push(p)}}else{const m=Math.max(0,a.start),g=Math.min(u.count,a.start+a.count);for(let v=m,f=g-1;v<f;v+=c){const p=hr(this,e,fs,l,v,v+1,v);p&&t.push(p)}if(this.isLineLoop){const v=hr(this,e,fs,l,g-1,m,g-1);v&&t.push(v)}}}updateMorphTargets(){const t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){const s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,a=s.length;r<a;r++){const o=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[o]=r}}}}}function hr(i,e,t,n,s,r,a){const o=i.geometry.attributes.position;if(Xr.fromBufferAttribute(o,s),$r.fromBufferAttribute(o,r),t.distanceSqToSegment(Xr,$r,Ua,ac)>n)return;Ua.applyMatrix4(i.matrixWorld);const c=e.ray.origin.distanceTo(Ua);if(!(c<e.near||c>e.far))return{distance:c,point:ac.clone().applyMatrix4(i.matrixWorld),index:a,face:null,faceIndex:null,barycoord:null,object:i}}const oc=new T,lc=new T;class wi extends un{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){const e=this.geometry;if(e.index===null){const t=e.attributes.position,n=[];for(let s=0,r=t.count;s<r;s+=2)oc.fromBufferAttribute(t,s),lc.fromBufferAttribute(t,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+oc.distanceTo(lc);e.setAttribute("lineDistance",new nt(n,1))}else De("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}}class pl extends un{constructor(e,t){super(e,t),this.isLineLoop=!0,this.type="LineLoop"}}class eu extends hi{constructor(e){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new Ue(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.alphaMap=e.alphaMap,this.size=e.size,this.sizeAttenuation=e.sizeAttenuation,this.fog=e.fog,this}}const cc=new Ge,Ho=new Os,ur=new Fs,dr=new T;class tu extends ht{constructor(e=new Ye,t=new eu){super(),this.isPoints=!0,this.type="Points",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){const n=this.geometry,s=this.matrixWorld,r=e.params.Points.threshold,a=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),ur.copy(n.boundingSphere),ur.applyMatrix4(s),ur.radius+=r,e.ray.intersectsSphere(ur)===!1)return;cc.copy(s).invert(),Ho.copy(e.ray).applyMatrix4(cc);const o=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=o*o,c=n.index,d=n.attributes.position;if(c!==null){const u=Math.max(0,a.start),m=Math.min(c.count,a.start+a.count);for(let g=u,v=m;g<v;g++){const f=c.getX(g);dr.fromBufferAttribute(d,f),hc(dr,f,l,s,e,t,this)}}else{const u=Math.max(0,a.start),m=Math.min(d.count,a.start+a.count);for(let g=u,v=m;g<v;g++)dr.fromBufferAttribute(d,g),hc(dr,g,l,s,e,t,this)}}updateMorphTargets(){const t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){const s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,a=s.length;r<a;r++){const o=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[o]=r}}}}}function hc(i,e,t,n,s,r,a){const o=Ho.distanceSqToPoint(i);if(o<t){const l=new T;Ho.closestPointToPoint(i,l),l.applyMatrix4(n);const c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(o),point:l,index:e,face:null,faceIndex:null,barycoord:null,object:a})}}class nu extends Zt{constructor(e=[],t=Ki,n,s,r,a,o,l,c,h){super(e,t,n,s,r,a,o,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}}class bi extends Zt{constructor(e,t,n=An,s,r,a,o=Ot,l=Ot,c,h=oi,d=1){if(h!==oi&&h!==ri)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");const u={width:e,height:t,depth:d};super(u,s,r,a,o,l,h,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new ul(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){const t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}}class iu extends bi{constructor(e,t=An,n=Ki,s,r,a=Ot,o=Ot,l,c=oi){const h={width:e,height:e,depth:1},d=[h,h,h,h,h,h];super(e,e,t,n,s,r,a,o,l,c),this.image=d,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}}class su extends Zt{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}}class gt extends Ye{constructor(e=1,t=1,n=1,s=1,r=1,a=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:s,heightSegments:r,depthSegments:a};const o=this;s=Math.floor(s),r=Math.floor(r),a=Math.floor(a);const l=[],c=[],h=[],d=[];let u=0,m=0;g("z","y","x",-1,-1,n,t,e,a,r,0),g("z","y","x",1,-1,n,t,-e,a,r,1),g("x","z","y",1,1,e,n,t,s,a,2),g("x","z","y",1,-1,e,n,-t,s,a,3),g("x","y","z",1,-1,e,t,n,s,r,4),g("x","y","z",-1,-1,e,t,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new nt(c,3)),this.setAttribute("normal",new nt(h,3)),this.setAttribute("uv",new nt(d,2));function g(v,f,p,x,E,S,C,A,_,w,I){const P=S/_,U=C/w,O=S/2,X=C/2,D=A/2,G=_+1,Y=w+1;let B=0,te=0;const V=new T;for(let Q=0;Q<Y;Q++){const ee=Q*U-X;for(let xe=0;xe<G;xe++){const Ne=xe*P-O;V[v]=Ne*x,V[f]=ee*E,V[p]=D,c.push(V.x,V.y,V.z),V[v]=0,V[f]=0,V[p]=A>0?1:-1,h.push(V.x,V.y,V.z),d.push(xe/_),d.push(1-Q/w),B+=1}}for(let Q=0;Q<w;Q++)for(let ee=0;ee<_;ee++){const xe=u+ee+G*Q,Ne=u+ee+G*(Q+1),Z=u+(ee+1)+G*(Q+1),ge=u+(ee+1)+G*Q;l.push(xe,Ne,ge),l.push(Ne,Z,ge),te+=6}o.addGroup(m,te,I),m+=te,u+=B}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new gt(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}}class Ut extends Ye{constructor(e=1,t=1,n=1,s=32,r=1,a=!1,o=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:n,radialSegments:s,heightSegments:r,openEnded:a,thetaStart:o,thetaLength:l};const c=this;s=Math.floor(s),r=Math.floor(r);const h=[],d=[],u=[],m=[];let g=0;const v=[],f=n/2;let p=0;x(),a===!1&&(e>0&&E(!0),t>0&&E(!1)),this.setIndex(h),this.setAttribute("position",new nt(d,3)),this.setAttribute("normal",new nt(u,3)),this.setAttribute("uv",new nt(m,2));function x(){const S=new T,C=new T;let A=0;const _=(t-e)/n;for(let w=0;w<=r;w++){const I=[],P=w/r,U=P*(t-e)+e;for(let O=0;O<=s;O++){const X=O/s,D=X*l+o,G=Math.sin(D),Y=Math.cos(D);C.x=U*G,C.y=-P*n+f,C.z=U*Y,d.push(C.x,C.y,C.z),S.set(G,_,Y).normalize(),u.push(S.x,S.y,S.z),m.push(X,1-P),I.push(g++)}v.push(I)}for(let w=0;w<s;w++)for(let I=0;I<r;I++){const P=v[I][w],U=v[I+1][w],O=v[I+1][w+1],X=v[I][w+1];(e>0||I!==0)&&(h.push(P,U,X),A+=3),(t>0||I!==r-1)&&(h.push(U,O,X),A+=3)}c.addGroup(p,A,0),p+=A}function E(S){const C=g,A=new Ee,_=new T;let w=0;const I=S===!0?e:t,P=S===!0?1:-1;for(let O=1;O<=s;O++)d.push(0,f*P,0),u.push(0,P,0),m.push(.5,.5),g++;const U=g;for(let O=0;O<=s;O++){const D=O/s*l+o,G=Math.cos(D),Y=Math.sin(D);_.x=I*Y,_.y=f*P,_.z=I*G,d.push(_.x,_.y,_.z),u.push(0,P,0),A.x=G*.5+.5,A.y=Y*.5*P+.5,m.push(A.x,A.y),g++}for(let O=0;O<s;O++){const X=C+O,D=U+O;S===!0?h.push(D,D+1,X):h.push(D+1,D,X),w+=3}c.addGroup(p,w,S===!0?1:2),p+=w}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new Ut(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}}class Qr extends Ut{constructor(e=1,t=1,n=32,s=1,r=!1,a=0,o=Math.PI*2){super(0,e,t,n,s,r,a,o),this.type="ConeGeometry",this.parameters={radius:e,height:t,radialSegments:n,heightSegments:s,openEnded:r,thetaStart:a,thetaLength:o}}static fromJSON(e){return new Qr(e.radius,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}}class ml extends Ye{constructor(e=[],t=[],n=1,s=0){super(),this.type="PolyhedronGeometry",this.parameters={vertices:e,indices:t,radius:n,detail:s};const r=[],a=[];o(s),c(n),h(),this.setAttribute("position",new nt(r,3)),this.setAttribute("normal",new nt(r.slice(),3)),this.setAttribute("uv",new nt(a,2)),s===0?this.computeVertexNormals():this.normalizeNormals();function o(x){const E=new T,S=new T,C=new T;for(let A=0;A<t.length;A+=3)m(t[A+0],E),m(t[A+1],S),m(t[A+2],C),l(E,S,C,x)}function l(x,E,S,C){const A=C+1,_=[];for(let w=0;w<=A;w++){_[w]=[];const I=x.clone().lerp(S,w/A),P=E.clone().lerp(S,w/A),U=A-w;for(let O=0;O<=U;O++)O===0&&w===A?_[w][O]=I:_[w][O]=I.clone().lerp(P,O/U)}for(let w=0;w<A;w++)for(let I=0;I<2*(A-w)-1;I++){const P=Math.floor(I/2);I%2===0?(u(_[w][P+1]),u(_[w+1][P]),u(_[w][P])):(u(_[w][P+1]),u(_[w+1][P+1]),u(_[w+1][P]))}}function c(x){const E=new T;for(let S=0;S<r.length;S+=3)E.x=r[S+0],E.y=r[S+1],E.z=r[S+2],E.normalize().multiplyScalar(x),r[S+0]=E.x,r[S+1]=E.y,r[S+2]=E.z}function h(){const x=new T;for(let E=0;E<r.length;E+=3){x.x=r[E+0],x.y=r[E+1],x.z=r[E+2];const S=f(x)/2/Math.PI+.5,C=p(x)/Math.PI+.5;a.push(S,1-C)}g(),d()}function d(){for(let x=0;x<a.length;x+=6){const E=a[x+0],S=a[x+2],C=a[x+4],A=Math.max(E,S,C),_=Math.min(E,S,C);A>.9&&_<.1&&(E<.2&&(a[x+0]+=1),S<.2&&(a[x+2]+=1),C<.2&&(a[x+4]+=1))}}function u(x){r.push(x.x,x.y,x.z)}function m(x,E){const S=x*3;E.x=e[S+0],E.y=e[S+1],E.z=e[S+2]}function g(){const x=new T,E=new T,S=new T,C=new T,A=new Ee,_=new Ee,w=new Ee;for(let I=0,P=0;I<r.length;I+=9,P+=6){x.set(r[I+0],r[I+1],r[I+2]),E.set(r[I+3],r[I+4],r[I+5]),S.set(r[I+6],r[I+7],r[I+8]),A.set(a[P+0],a[P+1]),_.set(a[P+2],a[P+3]),w.set(a[P+4],a[P+5]),C.copy(x).add(E).add(S).divideScalar(3);const U=f(C);v(A,P+0,x,U),v(_,P+2,E,U),v(w,P+4,S,U)}}function v(x,E,S,C){C<0&&x.x===1&&(a[E]=x.x-1),S.x===0&&S.z===0&&(a[E]=C/2/Math.PI+.5)}function f(x){return Math.atan2(x.z,-x.x)}function p(x){return Math.atan2(-x.y,Math.sqrt(x.x*x.x+x.z*x.z))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new ml(e.vertices,e.indices,e.radius,e.detail)}}const fr=new T,pr=new T,Fa=new T,mr=new fn;class ru extends Ye{constructor(e=null,t=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:e,thresholdAngle:t},e!==null){const s=Math.pow(10,4),r=Math.cos(Ss*t),a=e.getIndex(),o=e.getAttribute("position"),l=a?a.count:o.count,c=[0,0,0],h=["a","b","c"],d=new Array(3),u=new Map,m=[];for(let g=0;g<l;g+=3){a?(c[0]=a.getX(g),c[1]=a.getX(g+1),c[2]=a.getX(g+2)):(c[0]=g,c[1]=g+1,c[2]=g+2);const{a:v,b:f,c:p}=mr;if(v.fromBufferAttribute(o,c[0]),f.fromBufferAttribute(o,c[1]),p.fromBufferAttribute(o,c[2]),mr.getNormal(Fa),d[0]=`${Math.round(v.x*s)},${Math.round(v.y*s)},${Math.round(v.z*s)}`,d[1]=`${Math.round(f.x*s)},${Math.round(f.y*s)},${Math.round(f.z*s)}`,d[2]=`${Math.round(p.x*s)},${Math.round(p.y*s)},${Math.round(p.z*s)}`,!(d[0]===d[1]||d[1]===d[2]||d[2]===d[0]))for(let x=0;x<3;x++){const E=(x+1)%3,S=d[x],C=d[E],A=mr[h[x]],_=mr[h[E]],w=`${S}_${C}`,I=`${C}_${S}`,P=u.get(I);P?(Fa.dot(P.normal)<=r&&(m.push(A.x,A.y,A.z),m.push(_.x,_.y,_.z)),u.set(I,null)):u.has(w)||u.set(w,{index0:c[x],index1:c[E],normal:Fa.clone()})}}for(const g of u.values())if(g){const{index0:v,index1:f}=g;fr.fromBufferAttribute(o,v),pr.fromBufferAttribute(o,f),m.push(fr.x,fr.y,fr.z),m.push(pr.x,pr.y,pr.z)}this.setAttribute("position",new nt(m,3))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}}class Gi extends ml{constructor(e=1,t=0){const n=[1,0,0,-1,0,0,0,1,0,0,-1,0,0,0,1,0,0,-1],s=[0,2,4,0,4,3,0,3,5,0,5,2,1,2,5,1,5,3,1,3,4,1,4,2];super(n,s,e,t),this.type="OctahedronGeometry",this.parameters={radius:e,detail:t}}static fromJSON(e){return new Gi(e.radius,e.detail)}}class Bs extends Ye{constructor(e=1,t=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:s};const r=e/2,a=t/2,o=Math.floor(n),l=Math.floor(s),c=o+1,h=l+1,d=e/o,u=t/l,m=[],g=[],v=[],f=[];for(let p=0;p<h;p++){const x=p*u-a;for(let E=0;E<c;E++){const S=E*d-r;g.push(S,-x,0),v.push(0,0,1),f.push(E/o),f.push(1-p/l)}}for(let p=0;p<l;p++)for(let x=0;x<o;x++){const E=x+c*p,S=x+c*(p+1),C=x+1+c*(p+1),A=x+1+c*p;m.push(E,S,A),m.push(S,C,A)}this.setIndex(m),this.setAttribute("position",new nt(g,3)),this.setAttribute("normal",new nt(v,3)),this.setAttribute("uv",new nt(f,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new Bs(e.width,e.height,e.widthSegments,e.heightSegments)}}class Qi extends Ye{constructor(e=1,t=32,n=16,s=0,r=Math.PI*2,a=0,o=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:n,phiStart:s,phiLength:r,thetaStart:a,thetaLength:o},t=Math.max(3,Math.floor(t)),n=Math.max(2,Math.floor(n));const l=Math.min(a+o,Math.PI);let c=0;const h=[],d=new T,u=new T,m=[],g=[],v=[],f=[];for(let p=0;p<=n;p++){const x=[],E=p/n,S=a+E*o,C=e*Math.cos(S),A=Math.sqrt(e*e-C*C);let _=0;p===0&&a===0?_=.5/t:p===n&&l===Math.PI&&(_=-.5/t);for(let w=0;w<=t;w++){const I=w/t,P=s+I*r;d.x=-A*Math.cos(P),d.y=C,d.z=A*Math.sin(P),g.push(d.x,d.y,d.z),u.copy(d).normalize(),v.push(u.x,u.y,u.z),f.push(I+_,1-E),x.push(c++)}h.push(x)}for(let p=0;p<n;p++)for(let x=0;x<t;x++){const E=h[p][x+1],S=h[p][x],C=h[p+1][x],A=h[p+1][x+1];(p!==0||a>0)&&m.push(E,S,A),(p!==n-1||l<Math.PI)&&m.push(S,C,A)}this.setIndex(m),this.setAttribute("position",new nt(g,3)),this.setAttribute("normal",new nt(v,3)),this.setAttribute("uv",new nt(f,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new Qi(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}}class Mi extends Ye{constructor(e=1,t=.4,n=12,s=48,r=Math.PI*2,a=0,o=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:e,tube:t,radialSegments:n,tubularSegments:s,arc:r,thetaStart:a,thetaLength:o},n=Math.floor(n),s=Math.floor(s);const l=[],c=[],h=[],d=[],u=new T,m=new T,g=new T;for(let v=0;v<=n;v++){const f=a+v/n*o;for(let p=0;p<=s;p++){const x=p/s*r;m.x=(e+t*Math.cos(f))*Math.cos(x),m.y=(e+t*Math.cos(f))*Math.sin(x),m.z=t*Math.sin(f),c.push(m.x,m.y,m.z),u.x=e*Math.cos(x),u.y=e*Math.sin(x),g.subVectors(m,u).normalize(),h.push(g.x,g.y,g.z),d.push(p/s),d.push(v/n)}}for(let v=1;v<=n;v++)for(let f=1;f<=s;f++){const p=(s+1)*v+f-1,x=(s+1)*(v-1)+f-1,E=(s+1)*(v-1)+f,S=(s+1)*v+f;l.push(p,x,S),l.push(x,E,S)}this.setIndex(l),this.setAttribute("position",new nt(c,3)),this.setAttribute("normal",new nt(h,3)),this.setAttribute("uv",new nt(d,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new Mi(e.radius,e.tube,e.radialSegments,e.tubularSegments,e.arc,e.thetaStart,e.thetaLength)}}function es(i){const e={};for(const t in i){e[t]={};for(const n in i[t]){const s=i[t][n];if(uc(s))s.isRenderTargetTexture?(De("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=s.clone();else if(Array.isArray(s))if(uc(s[0])){const r=[];for(let a=0,o=s.length;a<o;a++)r[a]=s[a].clone();e[t][n]=r}else e[t][n]=s.slice();else e[t][n]=s}}return e}function $t(i){const e={};for(let t=0;t<i.length;t++){const n=es(i[t]);for(const s in n)e[s]=n[s]}return e}function uc(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function Rf(i){const e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function au(i){const e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:qe.workingColorSpace}const Cf={clone:es,merge:$t};var Pf=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Lf=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`;class Rn extends hi{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Pf,this.fragmentShader=Lf,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=es(e.uniforms),this.uniformsGroups=Rf(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){const t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(const s in this.uniforms){const a=this.uniforms[s].value;a&&a.isTexture?t.uniforms[s]={type:"t",value:a.toJSON(e).uuid}:a&&a.isColor?t.uniforms[s]={type:"c",value:a.getHex()}:a&&a.isVector2?t.uniforms[s]={type:"v2",value:a.toArray()}:a&&a.isVector3?t.uniforms[s]={type:"v3",value:a.toArray()}:a&&a.isVector4?t.uniforms[s]={type:"v4",value:a.toArray()}:a&&a.isMatrix3?t.uniforms[s]={type:"m3",value:a.toArray()}:a&&a.isMatrix4?t.uniforms[s]={type:"m4",value:a.toArray()}:t.uniforms[s]={value:a}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;const n={};for(const s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(const n in e.uniforms){const s=e.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=t[s.value]||null;break;case"c":this.uniforms[n].value=new Ue().setHex(s.value);break;case"v2":this.uniforms[n].value=new Ee().fromArray(s.value);break;case"v3":this.uniforms[n].value=new T().fromArray(s.value);break;case"v4":this.uniforms[n].value=new _t().fromArray(s.value);break;case"m3":this.uniforms[n].value=new Be().fromArray(s.value);break;case"m4":this.uniforms[n].value=new Ge().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(const n in e.extensions)this.extensions[n]=e.extensions[n];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}}class Df extends Rn{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}}class Nf extends hi{constructor(e){super(),this.isMeshStandardMaterial=!0,this.type="MeshStandardMaterial",this.defines={STANDARD:""},this.color=new Ue(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Ue(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Hr,this.normalScale=new Ee(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new _n,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.defines={STANDARD:""},this.color.copy(e.color),this.roughness=e.roughness,this.metalness=e.metalness,this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.roughnessMap=e.roughnessMap,this.metalnessMap=e.metalnessMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.envMapIntensity=e.envMapIntensity,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}}class ou extends hi{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new Ue(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Ue(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Hr,this.normalScale=new Ee(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new _n,this.combine=il,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}}class If extends hi{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Gd,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}}class Uf extends hi{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}}class lu extends ht{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new Ue(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){const t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}}const Oa=new Ge,dc=new T,fc=new T;class Ff{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Ee(512,512),this.mapType=tn,this.map=null,this.mapPass=null,this.matrix=new Ge,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Cs,this._frameExtents=new Ee(1,1),this._viewportCount=1,this._viewports=[new _t(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){const t=this.camera;dc.setFromMatrixPosition(e.matrixWorld),t.position.copy(dc),fc.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(fc),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,n,s){Oa.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),n.setFromProjectionMatrix(Oa,e.coordinateSystem,e.reversedDepth);const r=this._frameExtents,a=s?s.z/r.x:1,o=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;e.coordinateSystem===Rs||e.reversedDepth?t.set(.5*a,0,0,.5*a+l,0,.5*o,0,.5*o+c,0,0,1,0,0,0,0,1):t.set(.5*a,0,0,.5*a+l,0,.5*o,0,.5*o+c,0,0,.5,.5,0,0,0,1),t.multiply(Oa)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){const e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}}const gr=new T,_r=new pt,Pn=new T;class cu extends ht{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Ge,this.projectionMatrix=new Ge,this.projectionMatrixInverse=new Ge,this.coordinateSystem=En,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(gr,_r,Pn),Pn.x===1&&Pn.y===1&&Pn.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(gr,_r,Pn.set(1,1,1)).invert()}updateWorldMatrix(e,t,n=!1){super.updateWorldMatrix(e,t,n),this.matrixWorld.decompose(gr,_r,Pn),Pn.x===1&&Pn.y===1&&Pn.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(gr,_r,Pn.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}}const jn=new T,pc=new Ee,mc=new Ee;class Sn extends cu{constructor(e=50,t=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){const t=.5*this.getFilmHeight()/e;this.fov=zo*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){const e=Math.tan(Ss*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return zo*2*Math.atan(Math.tan(Ss*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){jn.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(jn.x,jn.y).multiplyScalar(-e/jn.z),jn.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(jn.x,jn.y).multiplyScalar(-e/jn.z)}getViewSize(e,t){return this.getViewBounds(e,pc,mc),t.subVectors(mc,pc)}setViewOffset(e,t,n,s,r,a){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=a,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){const e=this.near;let t=e*Math.tan(Ss*.5*this.fov)/this.zoom,n=2*t,s=this.aspect*n,r=-.5*s;const a=this.view;if(this.view!==null&&this.view.enabled){const l=a.fullWidth,c=a.fullHeight;r+=a.offsetX*s/l,t-=a.offsetY*n/c,s*=a.width/l,n*=a.height/c}const o=this.filmOffset;o!==0&&(r+=e*o/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){const t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}}class ea extends cu{constructor(e=-1,t=1,n=1,s=-1,r=.1,a=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=s,this.near=r,this.far=a,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,s,r,a){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=a,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){const e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2;let r=n-e,a=n+e,o=s+t,l=s-t;if(this.view!==null&&this.view.enabled){const c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,a=r+c*this.view.width,o-=h*this.view.offsetY,l=o-h*this.view.height}this.projectionMatrix.makeOrthographic(r,a,o,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){const t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}}class Of extends Ff{constructor(){super(new ea(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}}class gc extends lu{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(ht.DEFAULT_UP),this.updateMatrix(),this.target=new ht,this.shadow=new Of}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){const t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}}class Bf extends lu{constructor(e,t){super(e,t),this.isAmbientLight=!0,this.type="AmbientLight"}}const Ui=-90,Fi=1;class Go extends ht{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;const s=new Sn(Ui,Fi,e,t);s.layers=this.layers,this.add(s);const r=new Sn(Ui,Fi,e,t);r.layers=this.layers,this.add(r);const a=new Sn(Ui,Fi,e,t);a.layers=this.layers,this.add(a);const o=new Sn(Ui,Fi,e,t);o.layers=this.layers,this.add(o);const l=new Sn(Ui,Fi,e,t);l.layers=this.layers,this.add(l);const c=new Sn(Ui,Fi,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){const e=this.coordinateSystem,t=this.children.concat(),[n,s,r,a,o,l]=t;for(const c of t)this.remove(c);if(e===En)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),a.up.set(0,0,1),a.lookAt(0,-1,0),o.up.set(0,1,0),o.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===Rs)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),a.up.set(0,0,-1),a.lookAt(0,-1,0),o.up.set(0,-1,0),o.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(const c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();const{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());const[r,a,o,l,c,h]=this.children,d=e.getRenderTarget(),u=e.getActiveCubeFace(),m=e.getActiveMipmapLevel(),g=e.xr.enabled;e.xr.enabled=!1;const v=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let f=!1;e.isWebGLRenderer===!0?f=e.state.buffers.depth.getReversed():f=e.reversedDepthBuffer,e.setRenderTarget(n,0,s),f&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(n,1,s),f&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(n,2,s),f&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(n,3,s),f&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(n,4,s),f&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),n.texture.mipmapsAutoUpdate=v,e.setRenderTarget(n,5,s),f&&e.autoClear===!1&&e.clearDepth(),e.render(t,h),e.setRenderTarget(d,u,m),e.xr.enabled=g,n.texture.needsPMREMUpdate=!0}}class kf extends Sn{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}}const _c=new Ge;class gl{constructor(e,t,n=0,s=1/0){this.ray=new Os(e,t),this.near=n,this.far=s,this.camera=null,this.layers=new dl,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(e,t){this.ray.set(e,t)}setFromCamera(e,t){t.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(e.x,e.y,.5).unproject(t).sub(this.ray.origin).normalize(),this.camera=t):t.isOrthographicCamera?(this.ray.origin.set(e.x,e.y,t.projectionMatrix.elements[14]).unproject(t),this.ray.direction.set(0,0,-1).transformDirection(t.matrixWorld),this.camera=t):Ke("Raycaster: Unsupported camera type: "+t.type)}setFromXRController(e){return _c.identity().extractRotation(e.matrixWorld),this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(_c),this}intersectObject(e,t=!0,n=[]){return Vo(e,this,n,t),n.sort(vc),n}intersectObjects(e,t=!0,n=[]){for(let s=0,r=e.length;s<r;s++)Vo(e[s],this,n,t);return n.sort(vc),n}}function vc(i,e){return i.distance-e.distance}function Vo(i,e,t,n){let s=!0;if(i.layers.test(e.layers)&&i.raycast(e,t)===!1&&(s=!1),s===!0&&n===!0){const r=i.children;for(let a=0,o=r.length;a<o;a++)Vo(r[a],e,t,!0)}}class Wo{constructor(e=1,t=0,n=0){this.radius=e,this.phi=t,this.theta=n}set(e,t,n){return this.radius=e,this.phi=t,this.theta=n,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=Ve(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,n){return this.radius=Math.sqrt(e*e+t*t+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,n),this.phi=Math.acos(Ve(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}}class hu extends wi{constructor(e,t=16776960){const n=new Uint16Array([0,1,1,2,2,3,3,0,4,5,5,6,6,7,7,4,0,4,1,5,2,6,3,7]),s=[1,1,1,-1,1,1,-1,-1,1,1,-1,1,1,1,-1,-1,1,-1,-1,-1,-1,1,-1,-1],r=new Ye;r.setIndex(new vt(n,1)),r.setAttribute("position",new nt(s,3)),super(r,new Fn({color:t,toneMapped:!1})),this.box=e,this.type="Box3Helper",this.geometry.computeBoundingSphere()}updateMatrixWorld(e){const t=this.box;t.isEmpty()||(t.getCenter(this.position),t.getSize(this.scale),this.scale.multiplyScalar(.5),super.updateMatrixWorld(e))}dispose(){super.dispose(),this.geometry.dispose(),this.material.dispose()}}const xc=new T;let vr,Ba;class zf extends ht{constructor(e=new T(0,0,1),t=new T(0,0,0),n=1,s=16776960,r=n*.2,a=r*.2){super(),this.type="ArrowHelper",vr===void 0&&(vr=new Ye,vr.setAttribute("position",new nt([0,0,0,0,1,0],3)),Ba=new Qr(.5,1,5,1),Ba.translate(0,-.5,0)),this.position.copy(t),this.line=new un(vr,new Fn({color:s,toneMapped:!1})),this.line.matrixAutoUpdate=!1,this.add(this.line),this.cone=new fe(Ba,new as({color:s,toneMapped:!1})),this.cone.matrixAutoUpdate=!1,this.add(this.cone),this.setDirection(e),this.setLength(n,r,a)}setDirection(e){if(e.y>.99999)this.quaternion.set(0,0,0,1);else if(e.y<-.99999)this.quaternion.set(1,0,0,0);else{xc.set(e.z,0,-e.x).normalize();const t=Math.acos(e.y);this.quaternion.setFromAxisAngle(xc,t)}}setLength(e,t=e*.2,n=t*.2){this.line.scale.set(1,Math.max(1e-4,e-t),1),this.line.updateMatrix(),this.cone.scale.set(n,t,n),this.cone.position.y=e,this.cone.updateMatrix()}setColor(e){this.line.material.color.set(e),this.cone.material.color.set(e)}copy(e){return super.copy(e,!1),this.line.copy(e.line),this.cone.copy(e.cone),this}dispose(){super.dispose(),this.line.geometry.dispose(),this.line.material.dispose(),this.cone.geometry.dispose(),this.cone.material.dispose()}}class uu extends ci{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}}function Mc(i,e,t,n){const s=Hf(n);switch(t){case Hh:return i*e;case Vh:return i*e/s.components*s.byteLength;case ol:return i*e/s.components*s.byteLength;case li:return i*e*2/s.components*s.byteLength;case ll:return i*e*2/s.components*s.byteLength;case Gh:return i*e*3/s.components*s.byteLength;case wn:return i*e*4/s.components*s.byteLength;case cl:return i*e*4/s.components*s.byteLength;case Lr:case Dr:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Nr:case Ir:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case ho:case fo:return Math.max(i,16)*Math.max(e,8)/4;case co:case uo:return Math.max(i,8)*Math.max(e,8)/2;case po:case mo:case _o:case vo:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case go:case kr:case xo:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Mo:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case yo:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case bo:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case So:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case wo:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case Eo:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case To:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case Ao:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case Ro:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case Co:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case Po:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case Lo:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case Do:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case No:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case Io:case Uo:case Fo:return Math.ceil(i/4)*Math.ceil(e/4)*16;case Oo:case Bo:return Math.ceil(i/4)*Math.ceil(e/4)*8;case zr:case ko:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function Hf(i){switch(i){case tn:case Oh:return{byteLength:1,components:1};case As:case Bh:case Un:return{byteLength:2,components:1};case rl:case al:return{byteLength:2,components:4};case An:case sl:case pn:return{byteLength:4,components:1};case kh:case zh:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:nl}}));typeof window<"u"&&(window.__THREE__?De("WARNING: Multiple instances of Three.js being imported."):window.__THREE__=nl);/**
 * @license
 * Copyright 2010-2026 Three.js Authors
 * SPDX-License-Identifier: MIT
 */function du(){let i=null,e=!1,t=null,n=null;function s(r,a){n=i.requestAnimationFrame(s),t(r,a)}return{start:function(){e!==!0&&t!==null&&i!==null&&(n=i.requestAnimationFrame(s),e=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){i=r}}}function Gf(i){const e=new WeakMap;function t(o,l){const c=o.array,h=o.usage,d=c.byteLength,u=i.createBuffer();i.bindBuffer(l,u),i.bufferData(l,c,h),o.onUploadCallback();let m;if(c instanceof Float32Array)m=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)m=i.HALF_FLOAT;else if(c instanceof Uint16Array)o.isFloat16BufferAttribute?m=i.HALF_FLOAT:m=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)m=i.SHORT;else if(c instanceof Uint32Array)m=i.UNSIGNED_INT;else if(c instanceof Int32Array)m=i.INT;else if(c instanceof Int8Array)m=i.BYTE;else if(c instanceof Uint8Array)m=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)m=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:u,type:m,bytesPerElement:c.BYTES_PER_ELEMENT,version:o.version,size:d}}function n(o,l,c){const h=l.array,d=l.updateRanges;if(i.bindBuffer(c,o),d.length===0)i.bufferSubData(c,0,h);else{d.sort((m,g)=>m.start-g.start);let u=0;for(let m=1;m<d.length;m++){const g=d[u],v=d[m];v.start<=g.start+g.count+1?g.count=Math.max(g.count,v.start+v.count-g.start):(++u,d[u]=v)}d.length=u+1;for(let m=0,g=d.length;m<g;m++){const v=d[m];i.bufferSubData(c,v.start*h.BYTES_PER_ELEMENT,h,v.start,v.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(o){return o.isInterleavedBufferAttribute&&(o=o.data),e.get(o)}function r(o){o.isInterleavedBufferAttribute&&(o=o.data);const l=e.get(o);l&&(i.deleteBuffer(l.buffer),e.delete(o))}function a(o,l){if(o.isInterleavedBufferAttribute&&(o=o.data),o.isGLBufferAttribute){const h=e.get(o);(!h||h.version<o.version)&&e.set(o,{buffer:o.buffer,type:o.type,bytesPerElement:o.elementSize,version:o.version});return}const c=e.get(o);if(c===void 0)e.set(o,t(o,l));else if(c.version<o.version){if(c.size!==o.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,o,l),c.version=o.version}}return{get:s,remove:r,update:a}}var Vf=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,Wf=`#ifdef USE_ALPHAHASH
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
#endif`,Xf=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,$f=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,qf=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,Yf=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,Zf=`#ifdef USE_AOMAP
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
#endif`,Kf=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,Jf=`#ifdef USE_BATCHING
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
#endif`,jf=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,Qf=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,ep=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,tp=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,np=`#ifdef USE_IRIDESCENCE
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
#endif`,ip=`#ifdef USE_BUMPMAP
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
#endif`,sp=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,rp=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,ap=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,op=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,lp=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,cp=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,hp=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,up=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,dp=`#define PI 3.141592653589793
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
} // validated`,fp=`vec3 transformedNormal = objectNormal;
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
#endif`,pp=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,mp=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,gp=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,_p=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,vp="gl_FragColor = linearToOutputTexel( gl_FragColor );",xp=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,Mp=`#ifdef USE_ENVMAP
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
#endif`,yp=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,bp=`#ifdef USE_ENVMAP
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
#endif`,Sp=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,wp=`#ifdef USE_ENVMAP
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
#endif`,Ep=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,Tp=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,Ap=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,Rp=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Cp=`#ifdef USE_GRADIENTMAP
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
}`,Pp=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Lp=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,Dp=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Np=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,Ip=`#ifdef USE_ENVMAP
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
#endif`,Up=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,Fp=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Op=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Bp=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,kp=`PhysicalMaterial material;
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
#endif`,zp=`uniform sampler2D dfgLUT;
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
}`,Hp=`
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
#endif`,Gp=`#if defined( RE_IndirectDiffuse )
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
#endif`,Vp=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Wp=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,Xp=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,$p=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,qp=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Yp=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Zp=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Kp=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Jp=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,jp=`#if defined( USE_POINTS_UV )
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
#endif`,Qp=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,em=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,tm=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,nm=`#if defined( USE_MORPHCOLORS )
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
#endif`,im=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,sm=`#ifdef USE_MORPHTARGETS
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
#endif`,rm=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,am=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,om=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,lm=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,cm=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,hm=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,um=`#ifdef USE_NORMALMAP
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
#endif`,dm=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,fm=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,pm=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,mm=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,gm=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,_m=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,vm=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,xm=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,Mm=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,ym=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,bm=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,Sm=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,wm=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,Em=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,Tm=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,Am=`float getShadowMask() {
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
}`,Rm=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,Cm=`#ifdef USE_SKINNING
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
#endif`,Pm=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,Lm=`#ifdef USE_SKINNING
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
#endif`,Dm=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,Nm=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,Im=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,Um=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,Fm=`#ifdef USE_TRANSMISSION
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
#endif`,Om=`#ifdef USE_TRANSMISSION
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
#endif`,Bm=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,km=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,zm=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,Hm=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`;const Gm=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,Vm=`uniform sampler2D t2D;
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
}`,Wm=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Xm=`uniform float backgroundBlurriness;
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
}`,$m=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,qm=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Ym=`#include <common>
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
}`,Zm=`#if DEPTH_PACKING == 3200
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
}`,Km=`#define DISTANCE
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
}`,Jm=`#define DISTANCE
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
}`,jm=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,Qm=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,eg=`uniform float scale;
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
}`,tg=`uniform vec3 diffuse;
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
}`,ng=`#include <common>
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
}`,ig=`uniform vec3 diffuse;
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
}`,sg=`#define LAMBERT
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
}`,rg=`#define LAMBERT
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
}`,ag=`#define MATCAP
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
}`,og=`#define MATCAP
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
}`,lg=`#define NORMAL
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
}`,cg=`#define NORMAL
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
}`,hg=`#define PHONG
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
}`,ug=`#define PHONG
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
}`,dg=`#define STANDARD
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
}`,fg=`#define STANDARD
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
}`,pg=`#define TOON
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
}`,mg=`#define TOON
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
}`,gg=`uniform float size;
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
}`,_g=`uniform vec3 diffuse;
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
}`,vg=`#include <common>
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
}`,xg=`uniform vec3 color;
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
}`,Mg=`uniform float rotation;
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
}`,yg=`uniform vec3 diffuse;
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
}`,He={alphahash_fragment:Vf,alphahash_pars_fragment:Wf,alphamap_fragment:Xf,alphamap_pars_fragment:$f,alphatest_fragment:qf,alphatest_pars_fragment:Yf,aomap_fragment:Zf,aomap_pars_fragment:Kf,batching_pars_vertex:Jf,batching_vertex:jf,begin_vertex:Qf,beginnormal_vertex:ep,bsdfs:tp,iridescence_fragment:np,bumpmap_pars_fragment:ip,clipping_planes_fragment:sp,clipping_planes_pars_fragment:rp,clipping_planes_pars_vertex:ap,clipping_planes_vertex:op,color_fragment:lp,color_pars_fragment:cp,color_pars_vertex:hp,color_vertex:up,common:dp,defaultnormal_vertex:fp,displacementmap_pars_vertex:pp,displacementmap_vertex:mp,emissivemap_fragment:gp,emissivemap_pars_fragment:_p,colorspace_fragment:vp,colorspace_pars_fragment:xp,envmap_fragment:Mp,envmap_common_pars_fragment:yp,envmap_pars_fragment:bp,envmap_pars_vertex:Sp,envmap_physical_pars_fragment:Ip,envmap_vertex:wp,fog_vertex:Ep,fog_pars_vertex:Tp,fog_fragment:Ap,fog_pars_fragment:Rp,gradientmap_pars_fragment:Cp,lightmap_pars_fragment:Pp,lights_lambert_fragment:Lp,lights_lambert_pars_fragment:Dp,lights_pars_begin:Np,lights_toon_fragment:Up,lights_toon_pars_fragment:Fp,lights_phong_fragment:Op,lights_phong_pars_fragment:Bp,lights_physical_fragment:kp,lights_physical_pars_fragment:zp,lights_fragment_begin:Hp,lights_fragment_maps:Gp,lights_fragment_end:Vp,lightprobes_pars_fragment:Wp,logdepthbuf_fragment:Xp,logdepthbuf_pars_fragment:$p,logdepthbuf_pars_vertex:qp,logdepthbuf_vertex:Yp,map_fragment:Zp,map_pars_fragment:Kp,map_particle_fragment:Jp,map_particle_pars_fragment:jp,metalnessmap_fragment:Qp,metalnessmap_pars_fragment:em,morphinstance_vertex:tm,morphcolor_vertex:nm,morphnormal_vertex:im,morphtarget_pars_vertex:sm,morphtarget_vertex:rm,normal_fragment_begin:am,normal_fragment_maps:om,normal_pars_fragment:lm,normal_pars_vertex:cm,normal_vertex:hm,normalmap_pars_fragment:um,clearcoat_normal_fragment_begin:dm,clearcoat_normal_fragment_maps:fm,clearcoat_pars_fragment:pm,iridescence_pars_fragment:mm,opaque_fragment:gm,packing:_m,premultiplied_alpha_fragment:vm,project_vertex:xm,dithering_fragment:Mm,dithering_pars_fragment:ym,roughnessmap_fragment:bm,roughnessmap_pars_fragment:Sm,shadowmap_pars_fragment:wm,shadowmap_pars_vertex:Em,shadowmap_vertex:Tm,shadowmask_pars_fragment:Am,skinbase_vertex:Rm,skinning_pars_vertex:Cm,skinning_vertex:Pm,skinnormal_vertex:Lm,specularmap_fragment:Dm,specularmap_pars_fragment:Nm,tonemapping_fragment:Im,tonemapping_pars_fragment:Um,transmission_fragment:Fm,transmission_pars_fragment:Om,uv_pars_fragment:Bm,uv_pars_vertex:km,uv_vertex:zm,worldpos_vertex:Hm,background_vert:Gm,background_frag:Vm,backgroundCube_vert:Wm,backgroundCube_frag:Xm,cube_vert:$m,cube_frag:qm,depth_vert:Ym,depth_frag:Zm,distance_vert:Km,distance_frag:Jm,equirect_vert:jm,equirect_frag:Qm,linedashed_vert:eg,linedashed_frag:tg,meshbasic_vert:ng,meshbasic_frag:ig,meshlambert_vert:sg,meshlambert_frag:rg,meshmatcap_vert:ag,meshmatcap_frag:og,meshnormal_vert:lg,meshnormal_frag:cg,meshphong_vert:hg,meshphong_frag:ug,meshphysical_vert:dg,meshphysical_frag:fg,meshtoon_vert:pg,meshtoon_frag:mg,points_vert:gg,points_frag:_g,shadow_vert:vg,shadow_frag:xg,sprite_vert:Mg,sprite_frag:yg},me={common:{diffuse:{value:new Ue(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new Be},alphaMap:{value:null},alphaMapTransform:{value:new Be},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new Be}},envmap:{envMap:{value:null},envMapRotation:{value:new Be},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new Be}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new Be}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new Be},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new Be},normalScale:{value:new Ee(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new Be},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new Be}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new Be}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new Be}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Ue(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Ue(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new Be},alphaTest:{value:0},uvTransform:{value:new Be}},sprite:{diffuse:{value:new Ue(16777215)},opacity:{value:1},center:{value:new Ee(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new Be},alphaMap:{value:null},alphaMapTransform:{value:new Be},alphaTest:{value:0}}},Nn={basic:{uniforms:$t([me.common,me.specularmap,me.envmap,me.aomap,me.lightmap,me.fog]),vertexShader:He.meshbasic_vert,fragmentShader:He.meshbasic_frag},lambert:{uniforms:$t([me.common,me.specularmap,me.envmap,me.aomap,me.lightmap,me.emissivemap,me.bumpmap,me.normalmap,me.displacementmap,me.fog,me.lights,{emissive:{value:new Ue(0)},envMapIntensity:{value:1}}]),vertexShader:He.meshlambert_vert,fragmentShader:He.meshlambert_frag},phong:{uniforms:$t([me.common,me.specularmap,me.envmap,me.aomap,me.lightmap,me.emissivemap,me.bumpmap,me.normalmap,me.displacementmap,me.fog,me.lights,{emissive:{value:new Ue(0)},specular:{value:new Ue(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:He.meshphong_vert,fragmentShader:He.meshphong_frag},standard:{uniforms:$t([me.common,me.envmap,me.aomap,me.lightmap,me.emissivemap,me.bumpmap,me.normalmap,me.displacementmap,me.roughnessmap,me.metalnessmap,me.fog,me.lights,{emissive:{value:new Ue(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:He.meshphysical_vert,fragmentShader:He.meshphysical_frag},toon:{uniforms:$t([me.common,me.aomap,me.lightmap,me.emissivemap,me.bumpmap,me.normalmap,me.displacementmap,me.gradientmap,me.fog,me.lights,{emissive:{value:new Ue(0)}}]),vertexShader:He.meshtoon_vert,fragmentShader:He.meshtoon_frag},matcap:{uniforms:$t([me.common,me.bumpmap,me.normalmap,me.displacementmap,me.fog,{matcap:{value:null}}]),vertexShader:He.meshmatcap_vert,fragmentShader:He.meshmatcap_frag},points:{uniforms:$t([me.points,me.fog]),vertexShader:He.points_vert,fragmentShader:He.points_frag},dashed:{uniforms:$t([me.common,me.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:He.linedashed_vert,fragmentShader:He.linedashed_frag},depth:{uniforms:$t([me.common,me.displacementmap]),vertexShader:He.depth_vert,fragmentShader:He.depth_frag},normal:{uniforms:$t([me.common,me.bumpmap,me.normalmap,me.displacementmap,{opacity:{value:1}}]),vertexShader:He.meshnormal_vert,fragmentShader:He.meshnormal_frag},sprite:{uniforms:$t([me.sprite,me.fog]),vertexShader:He.sprite_vert,fragmentShader:He.sprite_frag},background:{uniforms:{uvTransform:{value:new Be},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:He.background_vert,fragmentShader:He.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new Be}},vertexShader:He.backgroundCube_vert,fragmentShader:He.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:He.cube_vert,fragmentShader:He.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:He.equirect_vert,fragmentShader:He.equirect_frag},distance:{uniforms:$t([me.common,me.displacementmap,{referencePosition:{value:new T},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:He.distance_vert,fragmentShader:He.distance_frag},shadow:{uniforms:$t([me.lights,me.fog,{color:{value:new Ue(0)},opacity:{value:1}}]),vertexShader:He.shadow_vert,fragmentShader:He.shadow_frag}};Nn.physical={uniforms:$t([Nn.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new Be},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new Be},clearcoatNormalScale:{value:new Ee(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new Be},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new Be},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new Be},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new Be},sheen:{value:0},sheenColor:{value:new Ue(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new Be},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new Be},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new Be},transmissionSamplerSize:{value:new Ee},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new Be},attenuationDistance:{value:0},attenuationColor:{value:new Ue(0)},specularColor:{value:new Ue(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new Be},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new Be},anisotropyVector:{value:new Ee},anisotropyMap:{value:null},anisotropyMapTransform:{value:new Be}}]),vertexShader:He.meshphysical_vert,fragmentShader:He.meshphysical_frag};const xr={r:0,b:0,g:0},bg=new Ge,fu=new Be;fu.set(-1,0,0,0,1,0,0,0,1);function Sg(i,e,t,n,s,r){const a=new Ue(0);let o=s===!0?0:1,l,c,h=null,d=0,u=null;function m(x){let E=x.isScene===!0?x.background:null;if(E&&E.isTexture){const S=x.backgroundBlurriness>0;E=e.get(E,S)}return E}function g(x){let E=!1;const S=m(x);S===null?f(a,o):S&&S.isColor&&(f(S,1),E=!0);const C=i.xr.getEnvironmentBlendMode();C==="additive"?t.buffers.color.setClear(0,0,0,1,r):C==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(i.autoClear||E)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function v(x,E){const S=m(E);S&&S.isCubeTexture?(c===void 0&&(c=new fe(new gt(1,1,1),new Rn({name:"BackgroundCubeMaterial",uniforms:es(Nn.backgroundCube.uniforms),vertexShader:Nn.backgroundCube.vertexShader,fragmentShader:Nn.backgroundCube.fragmentShader,side:Yt,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(C,A,_){this.matrixWorld.copyPosition(_.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=S,c.material.uniforms.backgroundBlurriness.value=E.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=E.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(bg.makeRotationFromEuler(E.backgroundRotation)).transpose(),S.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(fu),c.material.toneMapped=qe.getTransfer(S.colorSpace)!==tt,(h!==S||d!==S.version||u!==i.toneMapping)&&(c.material.needsUpdate=!0,h=S,d=S.version,u=i.toneMapping),c.layers.enableAll(),x.unshift(c,c.geometry,c.material,0,0,null)):S&&S.isTexture&&(l===void 0&&(l=new fe(new Bs(2,2),new Rn({name:"BackgroundMaterial",uniforms:es(Nn.background.uniforms),vertexShader:Nn.background.vertexShader,fragmentShader:Nn.background.fragmentShader,side:yi,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=S,l.material.uniforms.backgroundIntensity.value=E.backgroundIntensity,l.material.toneMapped=qe.getTransfer(S.colorSpace)!==tt,S.matrixAutoUpdate===!0&&S.updateMatrix(),l.material.uniforms.uvTransform.value.copy(S.matrix),(h!==S||d!==S.version||u!==i.toneMapping)&&(l.material.needsUpdate=!0,h=S,d=S.version,u=i.toneMapping),l.layers.enableAll(),x.unshift(l,l.geometry,l.material,0,0,null))}function f(x,E){x.getRGB(xr,au(i)),t.buffers.color.setClear(xr.r,xr.g,xr.b,E,r)}function p(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return a},setClearColor:function(x,E=1){a.set(x),o=E,f(a,o)},getClearAlpha:function(){return o},setClearAlpha:function(x){o=x,f(a,o)},render:g,addToRenderList:v,dispose:p}}function wg(i,e){const t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=u(null);let r=s,a=!1;function o(U,O,X,D,G){let Y=!1;const B=d(U,D,X,O);r!==B&&(r=B,c(r.object)),Y=m(U,D,X,G),Y&&g(U,D,X,G),G!==null&&e.update(G,i.ELEMENT_ARRAY_BUFFER),(Y||a)&&(a=!1,S(U,O,X,D),G!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get(G).buffer))}function l(){return i.createVertexArray()}function c(U){return i.bindVertexArray(U)}function h(U){return i.deleteVertexArray(U)}function d(U,O,X,D){const G=D.wireframe===!0;let Y=n[O.id];Y===void 0&&(Y={},n[O.id]=Y);const B=U.isInstancedMesh===!0?U.id:0;let te=Y[B];te===void 0&&(te={},Y[B]=te);let V=te[X.id];V===void 0&&(V={},te[X.id]=V);let Q=V[G];return Q===void 0&&(Q=u(l()),V[G]=Q),Q}function u(U){const O=[],X=[],D=[];for(let G=0;G<t;G++)O[G]=0,X[G]=0,D[G]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:O,enabledAttributes:X,attributeDivisors:D,object:U,attributes:{},index:null}}function m(U,O,X,D){const G=r.attributes,Y=O.attributes;let B=0;const te=X.getAttributes();for(const V in te)if(te[V].location>=0){const ee=G[V];let xe=Y[V];if(xe===void 0&&(V==="instanceMatrix"&&U.instanceMatrix&&(xe=U.instanceMatrix),V==="instanceColor"&&U.instanceColor&&(xe=U.instanceColor)),ee===void 0||ee.attribute!==xe||xe&&ee.data!==xe.data)return!0;B++}return r.attributesNum!==B||r.index!==D}function g(U,O,X,D){const G={},Y=O.attributes;let B=0;const te=X.getAttributes();for(const V in te)if(te[V].location>=0){let ee=Y[V];ee===void 0&&(V==="instanceMatrix"&&U.instanceMatrix&&(ee=U.instanceMatrix),V==="instanceColor"&&U.instanceColor&&(ee=U.instanceColor));const xe={};xe.attribute=ee,ee&&ee.data&&(xe.data=ee.data),G[V]=xe,B++}r.attributes=G,r.attributesNum=B,r.index=D}function v(){const U=r.newAttributes;for(let O=0,X=U.length;O<X;O++)U[O]=0}function f(U){p(U,0)}function p(U,O){const X=r.newAttributes,D=r.enabledAttributes,G=r.attributeDivisors;X[U]=1,D[U]===0&&(i.enableVertexAttribArray(U),D[U]=1),G[U]!==O&&(i.vertexAttribDivisor(U,O),G[U]=O)}function x(){const U=r.newAttributes,O=r.enabledAttributes;for(let X=0,D=O.length;X<D;X++)O[X]!==U[X]&&(i.disableVertexAttribArray(X),O[X]=0)}function E(U,O,X,D,G,Y,B){B===!0?i.vertexAttribIPointer(U,O,X,G,Y):i.vertexAttribPointer(U,O,X,D,G,Y)}function S(U,O,X,D){v();const G=D.attributes,Y=X.getAttributes(),B=O.defaultAttributeValues;for(const te in Y){const V=Y[te];if(V.location>=0){let Q=G[te];if(Q===void 0&&(te==="instanceMatrix"&&U.instanceMatrix&&(Q=U.instanceMatrix),te==="instanceColor"&&U.instanceColor&&(Q=U.instanceColor)),Q!==void 0){const ee=Q.normalized,xe=Q.itemSize,Ne=e.get(Q);if(Ne===void 0)continue;const Z=Ne.buffer,ge=Ne.type,ye=Ne.bytesPerElement,Ce=ge===i.INT||ge===i.UNSIGNED_INT||Q.gpuType===sl;if(Q.isInterleavedBufferAttribute){const _e=Q.data,Oe=_e.isInterleavedBuffer===!0?_e.stride:_e.itemSize,xt=Q.offset;if(_e.isInstancedInterleavedBuffer||_e.isInstancedBufferAttribute){for(let Le=0;Le<V.locationSize;Le++)p(V.location+Le,_e.meshPerAttribute);U.isInstancedMesh!==!0&&D._maxInstanceCount===void 0&&(D._maxInstanceCount=_e.meshPerAttribute*_e.count)}else for(let Le=0;Le<V.locationSize;Le++)f(V.location+Le);i.bindBuffer(i.ARRAY_BUFFER,Z);for(let Le=0;Le<V.locationSize;Le++)E(V.location+Le,xe/V.locationSize,ge,ee,Oe*ye,(xt+xe/V.locationSize*Le)*ye,Ce)}else{if(Q.isInstancedBufferAttribute){for(let _e=0;_e<V.locationSize;_e++)p(V.location+_e,Q.meshPerAttribute);U.isInstancedMesh!==!0&&D._maxInstanceCount===void 0&&(D._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let _e=0;_e<V.locationSize;_e++)f(V.location+_e);i.bindBuffer(i.ARRAY_BUFFER,Z);for(let _e=0;_e<V.locationSize;_e++)E(V.location+_e,xe/V.locationSize,ge,ee,xe*ye,xe/V.locationSize*_e*ye,Ce)}}else if(B!==void 0){const ee=B[te];if(ee!==void 0)switch(ee.length){case 2:i.vertexAttrib2fv(V.location,ee);break;case 3:i.vertexAttrib3fv(V.location,ee);break;case 4:i.vertexAttrib4fv(V.location,ee);break;default:i.vertexAttrib1fv(V.location,ee)}}}}x()}function C(){I();for(const U in n){const O=n[U];for(const X in O){const D=O[X];for(const G in D){const Y=D[G];for(const B in Y)h(Y[B].object),delete Y[B];delete D[G]}}delete n[U]}}function A(U){if(n[U.id]===void 0)return;const O=n[U.id];for(const X in O){const D=O[X];for(const G in D){const Y=D[G];for(const B in Y)h(Y[B].object),delete Y[B];delete D[G]}}delete n[U.id]}function _(U){for(const O in n){const X=n[O];for(const D in X){const G=X[D];if(G[U.id]===void 0)continue;const Y=G[U.id];for(const B in Y)h(Y[B].object),delete Y[B];delete G[U.id]}}}function w(U){for(const O in n){const X=n[O],D=U.isInstancedMesh===!0?U.id:0,G=X[D];if(G!==void 0){for(const Y in G){const B=G[Y];for(const te in B)h(B[te].object),delete B[te];delete G[Y]}delete X[D],Object.keys(X).length===0&&delete n[O]}}}function I(){P(),a=!0,r!==s&&(r=s,c(r.object))}function P(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:o,reset:I,resetDefaultState:P,dispose:C,releaseStatesOfGeometry:A,releaseStatesOfObject:w,releaseStatesOfProgram:_,initAttributes:v,enableAttribute:f,disableUnusedAttributes:x}}function Eg(i,e,t){let n;function s(l){n=l}function r(l,c){i.drawArrays(n,l,c),t.update(c,n,1)}function a(l,c,h){h!==0&&(i.drawArraysInstanced(n,l,c,h),t.update(c,n,h))}function o(l,c,h){if(h===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,h);let u=0;for(let m=0;m<h;m++)u+=c[m];t.update(u,n,1)}this.setMode=s,this.render=r,this.renderInstances=a,this.renderMultiDraw=o}function Tg(i,e,t,n){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){const _=e.get("EXT_texture_filter_anisotropic");s=i.getParameter(_.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function a(_){return!(_!==wn&&n.convert(_)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function o(_){const w=_===Un&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(_!==tn&&_!==pn&&!w&&n.convert(_)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(_){if(_==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";_="mediump"}return _==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp";const h=l(c);h!==c&&(De("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);const d=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),u=t.logarithmicDepthBuffer===!0&&d===!1;t.reversedDepthBuffer===!0&&d===!1&&De("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&d===!0&&De("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");const m=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),g=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),v=i.getParameter(i.MAX_TEXTURE_SIZE),f=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),p=i.getParameter(i.MAX_VERTEX_ATTRIBS),x=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),E=i.getParameter(i.MAX_VARYING_VECTORS),S=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),C=i.getParameter(i.MAX_SAMPLES),A=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:a,textureTypeReadable:o,precision:c,logarithmicDepthBuffer:u,reversedDepthBuffer:d,maxTextures:m,maxVertexTextures:g,maxTextureSize:v,maxCubemapSize:f,maxAttributes:p,maxVertexUniforms:x,maxVaryings:E,maxFragmentUniforms:S,maxSamples:C,samples:A}}function Ag(i){const e=this;let t=null,n=0,s=!1,r=!1;const a=new bn,o=new Be,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(d,u){const m=d.length!==0||u||n!==0||s;return s=u,n=d.length,m},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(d,u){t=h(d,u,0)},this.setState=function(d,u,m){const g=d.clippingPlanes,v=d.clipIntersection,f=d.clipShadows,p=i.get(d);if(!s||g===null||g.length===0||r&&!f)r?h(null):c();else{const x=r?0:n,E=x*4;let S=p.clippingState||null;l.value=S,S=h(g,u,E,m);for(let C=0;C!==E;++C)S[C]=t[C];p.clippingState=S,this.numIntersection=v?this.numPlanes:0,this.numPlanes+=x}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}function h(d,u,m,g){const v=d!==null?d.length:0;let f=null;if(v!==0){if(f=l.value,g!==!0||f===null){const p=m+v*4,x=u.matrixWorldInverse;o.getNormalMatrix(x),(f===null||f.length<p)&&(f=new Float32Array(p));for(let E=0,S=m;E!==v;++E,S+=4)a.copy(d[E]).applyMatrix4(x,o),a.normal.toArray(f,S),f[S+3]=a.constant}l.value=f,l.needsUpdate=!0}return e.numPlanes=v,e.numIntersection=0,f}}class _l extends Tn{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;const n={width:e,height:e,depth:1},s=[n,n,n,n,n,n];this.texture=new nu(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;const n={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new gt(5,5,5),r=new Rn({name:"CubemapFromEquirect",uniforms:es(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:Yt,blending:Wi});r.uniforms.tEquirect.value=t;const a=new fe(s,r),o=t.minFilter;return t.minFilter===si&&(t.minFilter=qt),new Go(1,10,this).update(e,a),t.minFilter=o,a.geometry.dispose(),a.material.dispose(),this}clear(e,t=!0,n=!0,s=!0){const r=e.getRenderTarget();for(let a=0;a<6;a++)e.setRenderTarget(this,a),e.clear(t,n,s);e.setRenderTarget(r)}}const yc=256,Rg=3,Cg=20,pu=256,mu=16,Pg=3,Lg=new T,Dg=new Ue;class qr{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Go(1,10,null),this._boxMesh=new fe(new gt(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,n=.1,s=100,r={}){const{size:a=256,position:o=Lg}=r,l=this._renderer;this._setSize(a);const c=this._allocateTarget(),h=this._getSourceTarget(!0);t>0&&(h.texture.mipmapsAutoUpdate=!1);const d=l.autoClear,u=l.autoClearColor,m=l.autoClearDepth,g=l.autoClearStencil,v=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,v===null&&(e.background=l.getClearColor(Dg));const f=new Go(n,s,h);return f.position.copy(o),f.update(l,e),l.autoClear=d,l.autoClearColor=u,l.autoClearDepth=m,l.autoClearStencil=g,e.background=v,t>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=wc(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Sc(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(yc,nf(e))}_fromTexture(e,t){e.mapping===Ki||e.mapping===Ts?this._setSize(e.image.length===0?yc:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);const n=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(n),n}_allocateTarget(){const e=this._cubeSize,t=bc(e,!1,!1),n=Math.log2(e)-Rg;for(let s=0;s<=n;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){const t=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==t||e&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=bc(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,n){const s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=e,r.activeMipmapLevel=t;const a=e.width>>t;e.viewport.set(0,0,a,a),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===Ki||e.mapping===Ts?(this._cubemapMaterial===null&&(this._cubemapMaterial=wc()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Sc()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=Ng(),this._integrationMaterial=Ig());const t=this._cubeSize,n=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;const r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/mu);for(let a=0;a<=n;a++){const o=qr.lodToRoughness(a,n);if(a>n-Pg)r.roughness.value=o,this._renderCube(e,a,this._integrationMaterial);else{const l=o>0?Math.log2(t)+.5*Math.log2(6/(pu*Math.pow(o,4)))+.5:0;s.roughness.value=o,s.lodBias.value=l,this._renderCube(e,a,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=Ug());const n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,n),s.envMap.value=e.texture,this._renderCube(r,0,n)}}function bc(i,e,t){return new _l(i,{minFilter:si,generateMipmaps:e,type:Un,colorSpace:Gr,depthBuffer:t})}function ks(i,e,t){return new Rn({name:i,uniforms:e,vertexShader:He.cube_vert,fragmentShader:t,side:Yt,blending:Wi,depthTest:!1,depthWrite:!1})}function Ng(){return ks("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${pu}u

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
	`)}function Ig(){return ks("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:mu}},`

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
	`)}function Ug(){return ks("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${Cg}
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
	`)}function Sc(){return ks("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function wc(){return ks("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function Fg(i){let e=new WeakMap,t=new WeakMap,n=null;function s(u,m=!1){return u==null?null:m?a(u):r(u)}function r(u){if(u&&u.isTexture){const m=u.mapping;if(m===ha||m===ua)if(e.has(u)){const g=e.get(u).texture;return o(g,u.mapping)}else{const g=u.image;if(g&&g.height>0){const v=new _l(g.height);return v.fromEquirectangularTexture(i,u),e.set(u,v),u.addEventListener("dispose",c),o(v.texture,u.mapping)}else return null}}return u}function a(u){if(u&&u.isTexture&&u.isPMREMTexture!==!0){const m=u.mapping,g=m===ha||m===ua,v=m===Ki||m===Ts;if(g||v){let f=t.get(u);const p=f!==void 0?f.texture.pmremVersion:0;if(u.isRenderTargetTexture&&u.pmremVersion!==p)return n===null&&(n=new qr(i)),f=g?n.fromEquirectangular(u,f):n.fromCubemap(u,f),f.texture.pmremVersion=u.pmremVersion,t.set(u,f),f.texture;if(f!==void 0)return f.texture;{const x=u.image;return g&&x&&x.height>0||v&&x&&l(x)?(n===null&&(n=new qr(i)),f=g?n.fromEquirectangular(u):n.fromCubemap(u),f.texture.pmremVersion=u.pmremVersion,t.set(u,f),u.addEventListener("dispose",h),f.texture):null}}}return u}function o(u,m){return m===ha?u.mapping=Ki:m===ua&&(u.mapping=Ts),u}function l(u){let m=0;const g=6;for(let v=0;v<g;v++)u[v]!==void 0&&m++;return m===g}function c(u){const m=u.target;m.removeEventListener("dispose",c);const g=e.get(m);g!==void 0&&(e.delete(m),g.dispose())}function h(u){const m=u.target;m.removeEventListener("dispose",h);const g=t.get(m);g!==void 0&&(t.delete(m),g.dispose())}function d(){e=new WeakMap,t=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:d}}function Og(i){const e={};function t(n){if(e[n]!==void 0)return e[n];const s=i.getExtension(n);return e[n]=s,s}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){const s=t(n);return s===null&&Ur("WebGLRenderer: "+n+" extension not supported."),s}}}function Bg(i,e,t,n){const s={},r=new WeakMap,a=new FinalizationRegistry(g=>delete s[g]);function o(g){l(g.target)}function l(g){g.index!==null&&e.remove(g.index);for(const f in g.attributes)e.remove(g.attributes[f]);g.removeEventListener("dispose",o),delete s[g.id],a.unregister(g);const v=r.get(g);v&&(e.remove(v),r.delete(g)),n.releaseStatesOfGeometry(g),g.isInstancedBufferGeometry===!0&&delete g._maxInstanceCount,t.memory.geometries--}function c(g,v){return s[v.id]!==void 0||(v.addEventListener("dispose",o),s[v.id]=new WeakRef(v),a.register(v,v.id,v),t.memory.geometries++),v}function h(g){const v=g.attributes;for(const f in v)e.update(v[f],i.ARRAY_BUFFER)}function d(g){const v=g.index,f=g.attributes.position;let p=0;if(f===void 0)return;const x=v!==null?v.array.length:f.array.length/3-1,E=f.count>=65535?jh:Jh,S=new E(Math.ceil(x/3)*6,1),C=S.array;if(v!==null){const _=v.array;p=v.version;for(let w=0,I=0;w<x;w+=3){const P=_[w+0],U=_[w+1],O=_[w+2];C[I++]=P,C[I++]=U,C[I++]=U,C[I++]=O,C[I++]=O,C[I++]=P}}else{p=f.version;for(let _=0,w=0;_<x;_+=3){const I=_+0,P=_+1,U=_+2;C[w++]=I,C[w++]=P,C[w++]=P,C[w++]=U,C[w++]=U,C[w++]=I}}S.version=p;const A=r.get(g);A&&e.remove(A),r.set(g,S)}function u(g){const v=r.get(g);if(v){const f=g.index;f!==null&&v.version<f.version&&d(g)}else d(g);return r.get(g)}function m(){for(const g in s){const v=s[g].deref();v!==void 0&&l(v)}}return{get:c,update:h,getWireframeAttribute:u,dispose:m}}function kg(i,e,t){let n;function s(d){n=d}let r,a;function o(d){r=d.type,a=d.bytesPerElement}function l(d,u){i.drawElements(n,u,r,d*a),t.update(u,n,1)}function c(d,u,m){m!==0&&(i.drawElementsInstanced(n,u,r,d*a,m),t.update(u,n,m))}function h(d,u,m){if(m===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,u,0,r,d,0,m);let v=0;for(let f=0;f<m;f++)v+=u[f];t.update(v,n,1)}this.setMode=s,this.setIndex=o,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function zg(i){const e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,a,o){switch(t.calls++,a){case i.TRIANGLES:t.triangles+=o*(r/3);break;case i.LINES:t.lines+=o*(r/2);break;case i.LINE_STRIP:t.lines+=o*(r-1);break;case i.LINE_LOOP:t.lines+=o*r;break;case i.POINTS:t.points+=o*r;break;default:Ke("WebGLInfo: Unknown draw mode:",a);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:n}}function Hg(i,e,t){const n=new WeakMap,s=new _t;function r(a,o,l){const c=a.morphTargetInfluences,h=o.morphAttributes.position||o.morphAttributes.normal||o.morphAttributes.color,d=h!==void 0?h.length:0;let u=n.get(o);if(u===void 0||u.count!==d){let P=function(){w.dispose(),n.delete(o),o.removeEventListener("dispose",P)};var m=P;u!==void 0&&u.texture.dispose();const g=o.morphAttributes.position!==void 0,v=o.morphAttributes.normal!==void 0,f=o.morphAttributes.color!==void 0,p=o.morphAttributes.position||[],x=o.morphAttributes.normal||[],E=o.morphAttributes.color||[];let S=0;g===!0&&(S=1),v===!0&&(S=2),f===!0&&(S=3);let C=o.attributes.position.count*S,A=1;C>e.maxTextureSize&&(A=Math.ceil(C/e.maxTextureSize),C=e.maxTextureSize);const _=new Float32Array(C*A*4*d),w=new Yh(_,C,A,d);w.type=pn,w.needsUpdate=!0;const I=S*4;for(let U=0;U<d;U++){const O=p[U],X=x[U],D=E[U],G=C*A*4*U;for(let Y=0;Y<O.count;Y++){const B=Y*I;g===!0&&(s.fromBufferAttribute(O,Y),_[G+B+0]=s.x,_[G+B+1]=s.y,_[G+B+2]=s.z,_[G+B+3]=0),v===!0&&(s.fromBufferAttribute(X,Y),_[G+B+4]=s.x,_[G+B+5]=s.y,_[G+B+6]=s.z,_[G+B+7]=0),f===!0&&(s.fromBufferAttribute(D,Y),_[G+B+8]=s.x,_[G+B+9]=s.y,_[G+B+10]=s.z,_[G+B+11]=D.itemSize===4?s.w:1)}}u={count:d,texture:w,size:new Ee(C,A)},n.set(o,u),o.addEventListener("dispose",P)}if(a.isInstancedMesh===!0&&a.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",a.morphTexture,t);else{let g=0;for(let f=0;f<c.length;f++)g+=c[f];const v=o.morphTargetsRelative?1:1-g;l.getUniforms().setValue(i,"morphTargetBaseInfluence",v),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",u.texture,t),l.getUniforms().setValue(i,"morphTargetsTextureSize",u.size)}return{update:r}}function Gg(i,e,t,n,s){let r=new WeakMap;function a(c){const h=s.render.frame,d=c.geometry,u=e.get(c,d);if(r.get(u)!==h&&(e.update(u),r.set(u,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(t.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,i.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){const m=c.skeleton;r.get(m)!==h&&(m.update(),r.set(m,h))}return u}function o(){r=new WeakMap}function l(c){const h=c.target;h.removeEventListener("dispose",l),n.releaseStatesOfObject(h),t.remove(h.instanceMatrix),h.instanceColor!==null&&t.remove(h.instanceColor)}return{update:a,dispose:o}}const Vg={[Ch]:"LINEAR_TONE_MAPPING",[Ph]:"REINHARD_TONE_MAPPING",[Lh]:"CINEON_TONE_MAPPING",[Dh]:"ACES_FILMIC_TONE_MAPPING",[Ih]:"AGX_TONE_MAPPING",[Uh]:"NEUTRAL_TONE_MAPPING",[Nh]:"CUSTOM_TONE_MAPPING"};function Wg(i,e,t,n,s,r){const a=new Tn(e,t,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1});let o=null,l=null,c=null;const h=new Ye;h.setAttribute("position",new nt([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new nt([0,2,0,0,2,0],2));const d=new Df({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),u=new fe(h,d),m=new ea(-1,1,1,-1,0,1);let g=null,v=null,f=!1,p,x=null,E=[],S=!1;this.setSize=function(C,A){a.setSize(C,A),o!==null&&o.setSize(C,A),l!==null&&l.setSize(C,A);for(let _=0;_<E.length;_++){const w=E[_];w.setSize&&w.setSize(C,A)}},this.setEffects=function(C){E=C,S=E.length>0&&E[0].isRenderPass===!0;const A=a.width,_=a.height;E.length>0&&o===null&&(o=new Tn(A,_,{type:Un,depthBuffer:!1,stencilBuffer:!1}),l=new Tn(A,_,{type:Un,depthBuffer:!1,stencilBuffer:!1}));const w=s===!0&&E.some(I=>I.needsDepthTexture===!0);w!==(a.depthTexture!==null)&&(w===!0&&c===null&&(c=new bi(A,_),r===!0&&(c.format=ri,c.type=Ji)),a.dispose(),a.depthTexture=w?c:null,a.resolveDepthBuffer=w,a.storeMultisampledDepthBuffer=w);for(let I=0;I<E.length;I++){const P=E[I];P.setSize&&P.setSize(A,_),w&&P.needsDepthTexture===!0&&P.setDepthTexture&&P.setDepthTexture(c)}},this.begin=function(C,A){if(f||C.toneMapping===Wn&&E.length===0)return!1;if(x=A,A!==null){const _=A.width,w=A.height;(a.width!==_||a.height!==w)&&this.setSize(_,w)}return S===!1&&C.setRenderTarget(a),p=C.toneMapping,C.toneMapping=Wn,!0},this.hasRenderPass=function(){return S},this.end=function(C,A){C.toneMapping=p,f=!0;let _=a,w=o;for(let I=0;I<E.length;I++){const P=E[I];P.enabled!==!1&&(P.render(C,w,_,A),P.needsSwap!==!1&&(_=w,w=w===o?l:o))}if(g!==C.outputColorSpace||v!==C.toneMapping){g=C.outputColorSpace,v=C.toneMapping,d.defines={},qe.getTransfer(g)===tt&&(d.defines.SRGB_TRANSFER="");const I=Vg[v];I&&(d.defines[I]=""),d.needsUpdate=!0}d.uniforms.tDiffuse.value=_.texture,C.setRenderTarget(x),C.render(u,m),x=null,f=!1},this.isCompositing=function(){return f},this.dispose=function(){a.dispose(),o!==null&&o.dispose(),l!==null&&l.dispose(),h.dispose(),d.dispose()}}const gu=new Zt,_u=new bi(1,1),vu=new iu(1),xu=new Yh,Mu=new Zh,yu=new nu,Ec=[],Tc=[],Ac=new Float32Array(16),Rc=new Float32Array(9),Cc=new Float32Array(4);function os(i,e,t){const n=i[0];if(n<=0||n>0)return i;const s=e*t;let r=Ec[s];if(r===void 0&&(r=new Float32Array(s),Ec[s]=r),e!==0){n.toArray(r,0);for(let a=1,o=0;a!==e;++a)o+=t,i[a].toArray(r,o)}return r}function At(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function Rt(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}function ta(i,e){let t=Tc[e];t===void 0&&(t=new Int32Array(e),Tc[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function Xg(i,e){const t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function $g(i,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(At(t,e))return;i.uniform2fv(this.addr,e),Rt(t,e)}}function qg(i,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(At(t,e))return;i.uniform3fv(this.addr,e),Rt(t,e)}}function Yg(i,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(At(t,e))return;i.uniform4fv(this.addr,e),Rt(t,e)}}function Zg(i,e){const t=this.cache,n=e.elements;if(n===void 0){if(At(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),Rt(t,e)}else{if(At(t,n))return;Cc.set(n),i.uniformMatrix2fv(this.addr,!1,Cc),Rt(t,n)}}function Kg(i,e){const t=this.cache,n=e.elements;if(n===void 0){if(At(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),Rt(t,e)}else{if(At(t,n))return;Rc.set(n),i.uniformMatrix3fv(this.addr,!1,Rc),Rt(t,n)}}function Jg(i,e){const t=this.cache,n=e.elements;if(n===void 0){if(At(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),Rt(t,e)}else{if(At(t,n))return;Ac.set(n),i.uniformMatrix4fv(this.addr,!1,Ac),Rt(t,n)}}function jg(i,e){const t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}function Qg(i,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(At(t,e))return;i.uniform2iv(this.addr,e),Rt(t,e)}}function e0(i,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(At(t,e))return;i.uniform3iv(this.addr,e),Rt(t,e)}}function t0(i,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(At(t,e))return;i.uniform4iv(this.addr,e),Rt(t,e)}}function n0(i,e){const t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function i0(i,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(At(t,e))return;i.uniform2uiv(this.addr,e),Rt(t,e)}}function s0(i,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(At(t,e))return;i.uniform3uiv(this.addr,e),Rt(t,e)}}function r0(i,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(At(t,e))return;i.uniform4uiv(this.addr,e),Rt(t,e)}}function na(i){return i.version===0&&(i.compareFunction=$h,i.needsUpdate=!0),i}function a0(i,e,t){const n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=na(_u):r=gu,t.setTexture2D(e||r,s)}function o0(i,e,t){const n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture3D(e||Mu,s)}function l0(i,e,t){const n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=na(vu):r=yu,t.setTextureCube(e||r,s)}function c0(i,e,t){const n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture2DArray(e||xu,s)}function h0(i){switch(i){case 5126:return Xg;case 35664:return $g;case 35665:return qg;case 35666:return Yg;case 35674:return Zg;case 35675:return Kg;case 35676:return Jg;case 5124:case 35670:return jg;case 35667:case 35671:return Qg;case 35668:case 35672:return e0;case 35669:case 35673:return t0;case 5125:return n0;case 36294:return i0;case 36295:return s0;case 36296:return r0;case 35678:case 36198:case 36298:case 36306:case 35682:return a0;case 35679:case 36299:case 36307:return o0;case 35680:case 36300:case 36308:case 36293:return l0;case 36289:case 36303:case 36311:case 36292:return c0}}function u0(i,e){i.uniform1fv(this.addr,e)}function d0(i,e){const t=os(e,this.size,2);i.uniform2fv(this.addr,t)}function f0(i,e){const t=os(e,this.size,3);i.uniform3fv(this.addr,t)}function p0(i,e){const t=os(e,this.size,4);i.uniform4fv(this.addr,t)}function m0(i,e){const t=os(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function g0(i,e){const t=os(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function _0(i,e){const t=os(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function v0(i,e){i.uniform1iv(this.addr,e)}function x0(i,e){i.uniform2iv(this.addr,e)}function M0(i,e){i.uniform3iv(this.addr,e)}function y0(i,e){i.uniform4iv(this.addr,e)}function b0(i,e){i.uniform1uiv(this.addr,e)}function S0(i,e){i.uniform2uiv(this.addr,e)}function w0(i,e){i.uniform3uiv(this.addr,e)}function E0(i,e){i.uniform4uiv(this.addr,e)}function T0(i,e,t){const n=this.cache,s=e.length,r=ta(t,s);At(n,r)||(i.uniform1iv(this.addr,r),Rt(n,r));let a;this.type===i.SAMPLER_2D_SHADOW?a=na(_u):a=gu;for(let o=0;o!==s;++o)t.setTexture2D(e[o]||a,r[o])}function A0(i,e,t){const n=this.cache,s=e.length,r=ta(t,s);At(n,r)||(i.uniform1iv(this.addr,r),Rt(n,r));for(let a=0;a!==s;++a)t.setTexture3D(e[a]||Mu,r[a])}function R0(i,e,t){const n=this.cache,s=e.length,r=ta(t,s);At(n,r)||(i.uniform1iv(this.addr,r),Rt(n,r));let a;this.type===i.SAMPLER_CUBE_SHADOW?a=na(vu):a=yu;for(let o=0;o!==s;++o)t.setTextureCube(e[o]||a,r[o])}function C0(i,e,t){const n=this.cache,s=e.length,r=ta(t,s);At(n,r)||(i.uniform1iv(this.addr,r),Rt(n,r));for(let a=0;a!==s;++a)t.setTexture2DArray(e[a]||xu,r[a])}function P0(i){switch(i){case 5126:return u0;case 35664:return d0;case 35665:return f0;case 35666:return p0;case 35674:return m0;case 35675:return g0;case 35676:return _0;case 5124:case 35670:return v0;case 35667:case 35671:return x0;case 35668:case 35672:return M0;case 35669:case 35673:return y0;case 5125:return b0;case 36294:return S0;case 36295:return w0;case 36296:return E0;case 35678:case 36198:case 36298:case 36306:case 35682:return T0;case 35679:case 36299:case 36307:return A0;case 35680:case 36300:case 36308:case 36293:return R0;case 36289:case 36303:case 36311:case 36292:return C0}}class L0{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=h0(t.type)}}class D0{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=P0(t.type)}}class N0{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){const s=this.seq;for(let r=0,a=s.length;r!==a;++r){const o=s[r];o.setValue(e,t[o.id],n)}}}const ka=/(\w+)(\])?(\[|\.)?/g;function Pc(i,e){i.seq.push(e),i.map[e.id]=e}function I0(i,e,t){const n=i.name,s=n.length;for(ka.lastIndex=0;;){const r=ka.exec(n),a=ka.lastIndex;let o=r[1];const l=r[2]==="]",c=r[3];if(l&&(o=o|0),c===void 0||c==="["&&a+2===s){Pc(t,c===void 0?new L0(o,i,e):new D0(o,i,e));break}else{let d=t.map[o];d===void 0&&(d=new N0(o),Pc(t,d)),t=d}}}class Fr{constructor(e,t){this.seq=[],this.map={};const n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let a=0;a<n;++a){const o=e.getActiveUniform(t,a),l=e.getUniformLocation(t,o.name);I0(o,l,this)}const s=[],r=[];for(const a of this.seq)a.type===e.SAMPLER_2D_SHADOW||a.type===e.SAMPLER_CUBE_SHADOW||a.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(a):r.push(a);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,n,s){const r=this.map[t];r!==void 0&&r.setValue(e,n,s)}setOptional(e,t,n){const s=t[n];s!==void 0&&this.setValue(e,n,s)}static upload(e,t,n,s){for(let r=0,a=t.length;r!==a;++r){const o=t[r],l=n[o.id];l.needsUpdate!==!1&&o.setValue(e,l.value,s)}}static seqWithValue(e,t){const n=[];for(let s=0,r=e.length;s!==r;++s){const a=e[s];a.id in t&&n.push(a)}return n}}function Lc(i,e,t){const n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}const U0=37297;let F0=0;function O0(i,e){const t=i.split(`
`),n=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let a=s;a<r;a++){const o=a+1;n.push(`${o===e?">":" "} ${o}: ${t[a]}`)}return n.join(`
`)}const Dc=new Be;function B0(i){qe._getMatrix(Dc,qe.workingColorSpace,i);const e=`mat3( ${Dc.elements.map(t=>t.toFixed(4))} )`;switch(qe.getTransfer(i)){case Vr:return[e,"LinearTransferOETF"];case tt:return[e,"sRGBTransferOETF"];default:return De("WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function Nc(i,e,t){const n=i.getShaderParameter(e,i.COMPILE_STATUS),r=(i.getShaderInfoLog(e)||"").trim();if(n&&r==="")return"";const a=/ERROR: 0:(\d+)/.exec(r);if(a){const o=parseInt(a[1]);return t.toUpperCase()+`

`+r+`

`+O0(i.getShaderSource(e),o)}else return r}function k0(i,e){const t=B0(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}const z0={[Ch]:"Linear",[Ph]:"Reinhard",[Lh]:"Cineon",[Dh]:"ACESFilmic",[Ih]:"AgX",[Uh]:"Neutral",[Nh]:"Custom"};function H0(i,e){const t=z0[e];return t===void 0?(De("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}const Mr=new T;function G0(){qe.getLuminanceCoefficients(Mr);const i=Mr.x.toFixed(4),e=Mr.y.toFixed(4),t=Mr.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function V0(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(vs).join(`
`)}function W0(i){const e=[];for(const t in i){const n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}function X0(i,e){const t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){const r=i.getActiveAttrib(e,s),a=r.name;let o=1;r.type===i.FLOAT_MAT2&&(o=2),r.type===i.FLOAT_MAT3&&(o=3),r.type===i.FLOAT_MAT4&&(o=4),t[a]={type:r.type,location:i.getAttribLocation(e,a),locationSize:o}}return t}function vs(i){return i!==""}function Ic(i,e){const t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function Uc(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}const $0=/^[ \t]*#include +<([\w\d./]+)>/gm;function Xo(i){return i.replace($0,q0)}function q0(i,e){const t=He[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return Xo(t)}const Y0=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Fc(i){return i.replace(Y0,Z0)}function Z0(i,e,t,n){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Oc(i){let e=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?e+=`
#define HIGH_PRECISION`:i.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}const K0={[Pr]:"SHADOWMAP_TYPE_PCF",[_s]:"SHADOWMAP_TYPE_VSM"};function J0(i){return K0[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}const j0={[Ts]:"ENVMAP_MODE_REFRACTION"};function Q0(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":j0[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}const e_={[il]:"ENVMAP_BLENDING_MULTIPLY",[kd]:"ENVMAP_BLENDING_MIX",[zd]:"ENVMAP_BLENDING_ADD"};function t_(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":e_[i.combine]||"ENVMAP_BLENDING_NONE"}function n_(i,e,t,n){const s=i.getContext(),r=t.defines;let a=t.vertexShader,o=t.fragmentShader;const l=J0(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=Q0(t),d=t_(t),u=V0(t),m=W0(r),g=s.createProgram();let v,f,p=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(v=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,m].filter(vs).join(`
`),v.length>0&&(v+=`
`),f=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,m].filter(vs).join(`
`),f.length>0&&(f+=`
`)):(v=[Oc(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,m,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+h:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(vs).join(`
`),f=[Oc(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,m,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+h:"",t.envMap?"#define "+d:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==Wn?"#define TONE_MAPPING":"",t.toneMapping!==Wn?He.tonemapping_pars_fragment:"",t.toneMapping!==Wn?H0("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",He.colorspace_pars_fragment,k0("linearToOutputTexel",t.outputColorSpace),G0(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(vs).join(`
`)),a=Xo(a),a=Ic(a,t),a=Uc(a,t),o=Xo(o),o=Ic(o,t),o=Uc(o,t),a=Fc(a),o=Fc(o),t.isRawShaderMaterial!==!0&&(p=`#version 300 es
`,v=[u,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+v,f=["#define varying in",t.glslVersion===ji?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===ji?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+f);const x=p+v+a,E=p+f+o,S=Lc(s,s.VERTEX_SHADER,x),C=Lc(s,s.FRAGMENT_SHADER,E);s.attachShader(g,S),s.attachShader(g,C),t.index0AttributeName!==void 0?s.bindAttribLocation(g,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(g,0,"position"),s.linkProgram(g);function A(P){if(i.debug.checkShaderErrors){const U=s.getProgramInfoLog(g)||"",O=s.getShaderInfoLog(S)||"",X=s.getShaderInfoLog(C)||"",D=U.trim(),G=O.trim(),Y=X.trim();let B=!0,te=!0;if(s.getProgramParameter(g,s.LINK_STATUS)===!1)if(B=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,g,S,C);else{const V=Nc(s,S,"vertex"),Q=Nc(s,C,"fragment");Ke("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(g,s.VALIDATE_STATUS)+`

Material Name: `+P.name+`
Material Type: `+P.type+`

Program Info Log: `+D+`
`+V+`
`+Q)}else D!==""?De("WebGLProgram: Program Info Log:",D):(G===""||Y==="")&&(te=!1);te&&(P.diagnostics={runnable:B,programLog:D,vertexShader:{log:G,prefix:v},fragmentShader:{log:Y,prefix:f}})}s.deleteShader(S),s.deleteShader(C),_=new Fr(s,g),w=X0(s,g)}let _;this.getUniforms=function(){return _===void 0&&A(this),_};let w;this.getAttributes=function(){return w===void 0&&A(this),w};let I=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return I===!1&&(I=s.getProgramParameter(g,U0)),I},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(g),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=F0++,this.cacheKey=e,this.usedTimes=1,this.program=g,this.vertexShader=S,this.fragmentShader=C,this}let i_=0;class s_{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,n){const s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(e){const t=this.materialCache.get(e);for(const n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){const t=this.materialCache;let n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){const t=this.shaderCache;let n=t.get(e);return n===void 0&&(n=new r_(e),t.set(e,n)),n}}class r_{constructor(e){this.id=i_++,this.code=e,this.usedTimes=0}}function a_(i){return i===li||i===kr||i===zr}function o_(i,e,t,n,s,r){const a=new dl,o=new s_,l=new Set,c=[],h=new Map,d=n.logarithmicDepthBuffer,u={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function m(_){return l.add(_),_===0?"uv":`uv${_}`}function g(_,w,I,P,U,O){const X=P.fog,D=U.geometry,G=_.isMeshStandardMaterial||_.isMeshLambertMaterial||_.isMeshPhongMaterial?P.environment:null,Y=_.isMeshStandardMaterial||_.isMeshLambertMaterial&&!_.envMap||_.isMeshPhongMaterial&&!_.envMap,B=e.get(_.envMap||G,Y),te=u[_.type];let V=n.precision;_.precision!==null&&(V=n.getMaxPrecision(_.precision),V!==_.precision&&De("WebGLProgram.getParameters:",_.precision,"not supported, using",V,"instead."));const Q=D.morphAttributes.position||D.morphAttributes.normal||D.morphAttributes.color,ee=Q!==void 0?Q.length:0;let xe=0;D.morphAttributes.position!==void 0&&(xe=1),D.morphAttributes.normal!==void 0&&(xe=2),D.morphAttributes.color!==void 0&&(xe=3);let Ne,Z,ge,ye;if(te){const pe=Nn[te];Ne=pe.vertexShader,Z=pe.fragmentShader}else{Ne=_.vertexShader,Z=_.fragmentShader;const pe=o.getVertexShaderStage(_),et=o.getFragmentShaderStage(_);o.update(_,pe,et),ge=pe.id,ye=et.id}const Ce=i.getRenderTarget(),_e=i.state.buffers.depth.getReversed(),Oe=U.isInstancedMesh===!0,xt=U.isBatchedMesh===!0,Le=!!_.map,Qe=!!_.matcap,it=!!B,We=it&&B.isPMREMTexture===!0,Nt=!!_.aoMap,St=!!_.lightMap,Kt=!!_.bumpMap&&_.wireframe===!1,ut=!!_.normalMap,Cn=!!_.displacementMap,Ct=!!_.emissiveMap,an=!!_.metalnessMap,on=!!_.roughnessMap,ln=_.anisotropy>0,F=_.clearcoat>0,cn=_.diffuseRoughness>0,ot=_.dispersion>0,lt=_.retroreflectivity>0,de=_.iridescence>0,wt=_.sheen>0,Pe=_.transmission>0,Ie=ln&&!!_.anisotropyMap,R=F&&!!_.clearcoatMap,M=F&&!!_.clearcoatNormalMap,z=F&&!!_.clearcoatRoughnessMap,ne=cn&&!!_.diffuseRoughnessMap,j=de&&!!_.iridescenceMap,re=de&&!!_.iridescenceThicknessMap,he=wt&&!!_.sheenColorMap,q=wt&&!!_.sheenRoughnessMap,K=!!_.specularMap,oe=!!_.specularColorMap,L=!!_.specularIntensityMap,J=Pe&&!!_.transmissionMap,$=Pe&&!!_.thicknessMap,le=!!_.gradientMap,se=!!_.alphaMap,ae=_.alphaTest>0,Te=!!_.alphaHash,ze=!!_.extensions;let ie=Wn;_.toneMapped&&(Ce===null||Ce.isXRRenderTarget===!0)&&(ie=i.toneMapping);const Ae=We?B.isCompressedCubeTexture?B.image[0].mipmaps:B.mipmaps:null,ke={shaderID:te,shaderType:_.type,shaderName:_.name,vertexShader:Ne,fragmentShader:Z,defines:_.defines,customVertexShaderID:ge,customFragmentShaderID:ye,isRawShaderMaterial:_.isRawShaderMaterial===!0,glslVersion:_.glslVersion,precision:V,batching:xt,batchingColor:xt&&U._colorsTexture!==null,instancing:Oe,instancingColor:Oe&&U.instanceColor!==null,instancingMorph:Oe&&U.morphTexture!==null,outputColorSpace:Ce===null?i.outputColorSpace:Ce.isXRRenderTarget===!0?Ce.texture.colorSpace:qe.workingColorSpace,alphaToCoverage:!!_.alphaToCoverage,map:Le,matcap:Qe,envMap:it,envMapMode:it&&B.mapping,envMapPMREM:We,envMapMaxLod:We?Ae.length-1:null,envMapSize:We?Ae[0].width:null,aoMap:Nt,lightMap:St,bumpMap:Kt,normalMap:ut,displacementMap:Cn,emissiveMap:Ct,normalMapObjectSpace:ut&&_.normalMapType===Vd,normalMapTangentSpace:ut&&_.normalMapType===Hr,packedNormalMap:ut&&_.normalMapType===Hr&&a_(_.normalMap.format),metalnessMap:an,roughnessMap:on,anisotropy:ln,anisotropyMap:Ie,clearcoat:F,clearcoatMap:R,clearcoatNormalMap:M,clearcoatRoughnessMap:z,diffuseRoughness:cn,diffuseRoughnessMap:ne,dispersion:ot,retroreflection:lt,iridescence:de,iridescenceMap:j,iridescenceThicknessMap:re,sheen:wt,sheenColorMap:he,sheenRoughnessMap:q,specularMap:K,specularColorMap:oe,specularIntensityMap:L,transmission:Pe,transmissionMap:J,thicknessMap:$,gradientMap:le,opaque:_.transparent===!1&&_.blending===bs&&_.alphaToCoverage===!1,alphaMap:se,alphaTest:ae,alphaHash:Te,combine:_.combine,mapUv:Le&&m(_.map.channel),aoMapUv:Nt&&m(_.aoMap.channel),lightMapUv:St&&m(_.lightMap.channel),bumpMapUv:Kt&&m(_.bumpMap.channel),normalMapUv:ut&&m(_.normalMap.channel),displacementMapUv:Cn&&m(_.displacementMap.channel),emissiveMapUv:Ct&&m(_.emissiveMap.channel),metalnessMapUv:an&&m(_.metalnessMap.channel),roughnessMapUv:on&&m(_.roughnessMap.channel),anisotropyMapUv:Ie&&m(_.anisotropyMap.channel),clearcoatMapUv:R&&m(_.clearcoatMap.channel),clearcoatNormalMapUv:M&&m(_.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:z&&m(_.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ne&&m(_.diffuseRoughnessMap.channel),iridescenceMapUv:j&&m(_.iridescenceMap.channel),iridescenceThicknessMapUv:re&&m(_.iridescenceThicknessMap.channel),sheenColorMapUv:he&&m(_.sheenColorMap.channel),sheenRoughnessMapUv:q&&m(_.sheenRoughnessMap.channel),specularMapUv:K&&m(_.specularMap.channel),specularColorMapUv:oe&&m(_.specularColorMap.channel),specularIntensityMapUv:L&&m(_.specularIntensityMap.channel),transmissionMapUv:J&&m(_.transmissionMap.channel),thicknessMapUv:$&&m(_.thicknessMap.channel),alphaMapUv:se&&m(_.alphaMap.channel),vertexTangents:!!D.attributes.tangent&&(ut||ln),vertexNormals:!!D.attributes.normal,vertexColors:_.vertexColors,vertexAlphas:_.vertexColors===!0&&!!D.attributes.color&&D.attributes.color.itemSize===4,pointsUvs:U.isPoints===!0&&!!D.attributes.uv&&(Le||se),fog:!!X,useFog:_.fog===!0,fogExp2:!!X&&X.isFogExp2,flatShading:_.wireframe===!1&&(_.flatShading===!0||D.attributes.normal===void 0&&ut===!1&&(_.isMeshLambertMaterial||_.isMeshPhongMaterial||_.isMeshStandardMaterial||_.isMeshPhysicalMaterial)),sizeAttenuation:_.sizeAttenuation===!0,logarithmicDepthBuffer:d,reversedDepthBuffer:_e,skinning:U.isSkinnedMesh===!0,hasPositionAttribute:D.attributes.position!==void 0,morphTargets:D.morphAttributes.position!==void 0,morphNormals:D.morphAttributes.normal!==void 0,morphColors:D.morphAttributes.color!==void 0,morphTargetsCount:ee,morphTextureStride:xe,numSunLights:w.sun.length,numDirLights:w.directional.length,numPointLights:w.point.length,numSpotLights:w.spot.length,numSpotLightMaps:w.spotLightMap.length,numRectAreaLights:w.rectArea.length,numHemiLights:w.hemi.length,numSunLightShadows:w.sunShadowMap.length,numDirLightShadows:w.directionalShadowMap.length,numPointLightShadows:w.pointShadowMap.length,numSpotLightShadows:w.spotShadowMap.length,numSpotLightShadowsWithMaps:w.numSpotLightShadowsWithMaps,numLightProbes:w.numLightProbes,numLightProbeGrids:O.filter(pe=>pe.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:_.dithering,shadowMapEnabled:i.shadowMap.enabled&&I.length>0,shadowMapType:i.shadowMap.type,toneMapping:ie,decodeVideoTexture:Le&&_.map.isVideoTexture===!0&&qe.getTransfer(_.map.colorSpace)===tt,decodeVideoTextureEmissive:Ct&&_.emissiveMap.isVideoTexture===!0&&qe.getTransfer(_.emissiveMap.colorSpace)===tt,premultipliedAlpha:_.premultipliedAlpha,doubleSided:_.side===Ft,flipSided:_.side===Yt,useDepthPacking:_.depthPacking>=0,depthPacking:_.depthPacking||0,index0AttributeName:_.index0AttributeName,extensionClipCullDistance:ze&&_.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(ze&&_.extensions.multiDraw===!0||xt)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:_.customProgramCacheKey()};return ke.vertexUv1s=l.has(1),ke.vertexUv2s=l.has(2),ke.vertexUv3s=l.has(3),l.clear(),ke}function v(_){const w=[];if(_.shaderID?w.push(_.shaderID):(w.push(_.customVertexShaderID),w.push(_.customFragmentShaderID)),_.defines!==void 0)for(const I in _.defines)w.push(I),w.push(_.defines[I]);return _.isRawShaderMaterial===!1&&(f(w,_),p(w,_),w.push(i.outputColorSpace)),w.push(_.customProgramCacheKey),w.join()}function f(_,w){_.push(w.precision),_.push(w.outputColorSpace),_.push(w.envMapMode),_.push(w.envMapPMREM),_.push(w.envMapMaxLod),_.push(w.envMapSize),_.push(w.mapUv),_.push(w.alphaMapUv),_.push(w.lightMapUv),_.push(w.aoMapUv),_.push(w.bumpMapUv),_.push(w.normalMapUv),_.push(w.displacementMapUv),_.push(w.emissiveMapUv),_.push(w.metalnessMapUv),_.push(w.roughnessMapUv),_.push(w.anisotropyMapUv),_.push(w.clearcoatMapUv),_.push(w.clearcoatNormalMapUv),_.push(w.clearcoatRoughnessMapUv),_.push(w.diffuseRoughnessMapUv),_.push(w.iridescenceMapUv),_.push(w.iridescenceThicknessMapUv),_.push(w.sheenColorMapUv),_.push(w.sheenRoughnessMapUv),_.push(w.specularMapUv),_.push(w.specularColorMapUv),_.push(w.specularIntensityMapUv),_.push(w.transmissionMapUv),_.push(w.thicknessMapUv),_.push(w.combine),_.push(w.fogExp2),_.push(w.sizeAttenuation),_.push(w.morphTargetsCount),_.push(w.numSunLights),_.push(w.numDirLights),_.push(w.numPointLights),_.push(w.numSpotLights),_.push(w.numSpotLightMaps),_.push(w.numHemiLights),_.push(w.numRectAreaLights),_.push(w.numSunLightShadows),_.push(w.numDirLightShadows),_.push(w.numPointLightShadows),_.push(w.numSpotLightShadows),_.push(w.numSpotLightShadowsWithMaps),_.push(w.numLightProbes),_.push(w.numLightProbeGrids),_.push(w.shadowMapType),_.push(w.toneMapping),_.push(w.numClippingPlanes),_.push(w.numClipIntersection),_.push(w.depthPacking)}function p(_,w){a.disableAll(),w.instancing&&a.enable(0),w.instancingColor&&a.enable(1),w.instancingMorph&&a.enable(2),w.matcap&&a.enable(3),w.envMap&&a.enable(4),w.normalMapObjectSpace&&a.enable(5),w.normalMapTangentSpace&&a.enable(6),w.clearcoat&&a.enable(7),w.iridescence&&a.enable(8),w.alphaTest&&a.enable(9),w.vertexColors&&a.enable(10),w.vertexAlphas&&a.enable(11),w.vertexUv1s&&a.enable(12),w.vertexUv2s&&a.enable(13),w.vertexUv3s&&a.enable(14),w.vertexTangents&&a.enable(15),w.anisotropy&&a.enable(16),w.alphaHash&&a.enable(17),w.batching&&a.enable(18),w.dispersion&&a.enable(19),w.retroreflection&&a.enable(24),w.diffuseRoughness&&a.enable(25),w.batchingColor&&a.enable(20),w.gradientMap&&a.enable(21),w.packedNormalMap&&a.enable(22),w.vertexNormals&&a.enable(23),_.push(a.mask),a.disableAll(),w.fog&&a.enable(0),w.useFog&&a.enable(1),w.flatShading&&a.enable(2),w.logarithmicDepthBuffer&&a.enable(3),w.reversedDepthBuffer&&a.enable(4),w.skinning&&a.enable(5),w.morphTargets&&a.enable(6),w.morphNormals&&a.enable(7),w.morphColors&&a.enable(8),w.premultipliedAlpha&&a.enable(9),w.shadowMapEnabled&&a.enable(10),w.doubleSided&&a.enable(11),w.flipSided&&a.enable(12),w.useDepthPacking&&a.enable(13),w.dithering&&a.enable(14),w.transmission&&a.enable(15),w.sheen&&a.enable(16),w.opaque&&a.enable(17),w.pointsUvs&&a.enable(18),w.decodeVideoTexture&&a.enable(19),w.decodeVideoTextureEmissive&&a.enable(20),w.alphaToCoverage&&a.enable(21),w.numLightProbeGrids>0&&a.enable(22),w.hasPositionAttribute&&a.enable(23),_.push(a.mask)}function x(_){const w=u[_.type];let I;if(w){const P=Nn[w];I=Cf.clone(P.uniforms)}else I=_.uniforms;return I}function E(_,w){let I=h.get(w);return I!==void 0?++I.usedTimes:(I=new n_(i,w,_,s),c.push(I),h.set(w,I)),I}function S(_){if(--_.usedTimes===0){const w=c.indexOf(_);c[w]=c[c.length-1],c.pop(),h.delete(_.cacheKey),_.destroy()}}function C(_){o.remove(_)}function A(){o.dispose()}return{getParameters:g,getProgramCacheKey:v,getUniforms:x,acquireProgram:E,releaseProgram:S,releaseShaderCache:C,programs:c,dispose:A}}function l_(){let i=new WeakMap;function e(a){return i.has(a)}function t(a){let o=i.get(a);return o===void 0&&(o={},i.set(a,o)),o}function n(a){i.delete(a)}function s(a,o,l){i.get(a)[o]=l}function r(){i=new WeakMap}return{has:e,get:t,remove:n,update:s,dispose:r}}function c_(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.materialVariant!==e.materialVariant?i.materialVariant-e.materialVariant:i.z!==e.z?i.z-e.z:i.id-e.id}function Bc(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function kc(){const i=[];let e=0;const t=[],n=[],s=[];function r(){e=0,t.length=0,n.length=0,s.length=0}function a(u){let m=0;return u.isInstancedMesh&&(m+=2),u.isSkinnedMesh&&(m+=1),m}function o(u,m,g,v,f,p){let x=i[e];return x===void 0?(x={id:u.id,object:u,geometry:m,material:g,materialVariant:a(u),groupOrder:v,renderOrder:u.renderOrder,z:f,group:p},i[e]=x):(x.id=u.id,x.object=u,x.geometry=m,x.material=g,x.materialVariant=a(u),x.groupOrder=v,x.renderOrder=u.renderOrder,x.z=f,x.group=p),e++,x}function l(u,m,g,v,f,p,x){x.reversedDepth===!0&&(f=-f);const E=o(u,m,g,v,f,p);g.transmission>0?n.push(E):g.transparent===!0?s.push(E):t.push(E)}function c(u,m,g,v,f,p){const x=o(u,m,g,v,f,p);g.transmission>0?n.unshift(x):g.transparent===!0?s.unshift(x):t.unshift(x)}function h(u,m){t.length>1&&t.sort(u||c_),n.length>1&&n.sort(m||Bc),s.length>1&&s.sort(m||Bc)}function d(){for(let u=e,m=i.length;u<m;u++){const g=i[u];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:t,transmissive:n,transparent:s,init:r,push:l,unshift:c,finish:d,sort:h}}function h_(){let i=new WeakMap;function e(n,s){const r=i.get(n);let a;return r===void 0?(a=new kc,i.set(n,[a])):s>=r.length?(a=new kc,r.push(a)):a=r[s],a}function t(){i=new WeakMap}return{get:e,dispose:t}}function u_(){const i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new T,color:new Ue};break;case"SpotLight":t={position:new T,direction:new T,color:new Ue,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new T,color:new Ue,distance:0,decay:0};break;case"HemisphereLight":t={direction:new T,skyColor:new Ue,groundColor:new Ue};break;case"RectAreaLight":t={color:new Ue,position:new T,halfWidth:new T,halfHeight:new T};break}return i[e.id]=t,t}}}function d_(){const i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ee};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ee};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ee,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t}}}let f_=0;function p_(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function m_(i){const e=new u_,t=d_(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new T);const s=new T,r=new Ge,a=new Ge;function o(c){let h=0,d=0,u=0;for(let O=0;O<9;O++)n.probe[O].set(0,0,0);let m=0,g=0,v=0,f=0,p=0,x=0,E=0,S=0,C=0,A=0,_=0,w=0,I=0,P=0;c.sort(p_);for(let O=0,X=c.length;O<X;O++){const D=c[O],G=D.color,Y=D.intensity,B=D.distance;let te=null;if(D.shadow&&D.shadow.map&&(D.shadow.map.texture.format===li?te=D.shadow.map.texture:te=D.shadow.map.depthTexture||D.shadow.map.texture),D.isAmbientLight)h+=G.r*Y,d+=G.g*Y,u+=G.b*Y;else if(D.isLightProbe){for(let V=0;V<9;V++)n.probe[V].addScaledVector(D.sh.coefficients[V],Y);P++}else if(D.isSunLight){const V=e.get(D);if(V.color.copy(D.color).multiplyScalar(D.intensity),D.castShadow){const Q=D.shadow,ee=t.get(D);ee.shadowIntensity=Q.intensity,ee.shadowBias=Q.bias,ee.shadowNormalBias=Q.normalBias,ee.shadowRadius=Q.radius,ee.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),n.sunShadow[g]=ee,n.sunShadowMap[g]=te;const xe=Q.getViewportCount();for(let Ne=0;Ne<xe;Ne++)n.sunShadowMatrix[v+Ne]=Q.getMatrix(Ne),n.sunShadowCascade[v+Ne]=Q._cascadeData[Ne];v+=xe,g++}n.sun[m]=V,m++}else if(D.isDirectionalLight){const V=e.get(D);if(V.color.copy(D.color).multiplyScalar(D.intensity),D.castShadow){const Q=D.shadow,ee=t.get(D);ee.shadowIntensity=Q.intensity,ee.shadowBias=Q.bias,ee.shadowNormalBias=Q.normalBias,ee.shadowRadius=Q.radius,ee.shadowMapSize=Q.mapSize,n.directionalShadow[f]=ee,n.directionalShadowMap[f]=te,n.directionalShadowMatrix[f]=D.shadow.matrix,C++}n.directional[f]=V,f++}else if(D.isSpotLight){const V=e.get(D);V.position.setFromMatrixPosition(D.matrixWorld),V.color.copy(G).multiplyScalar(Y),V.distance=B,V.coneCos=Math.cos(D.angle),V.penumbraCos=Math.cos(D.angle*(1-D.penumbra)),V.decay=D.decay,n.spot[x]=V;const Q=D.shadow;if(D.map&&(n.spotLightMap[w]=D.map,w++,Q.updateMatrices(D),D.castShadow&&I++),n.spotLightMatrix[x]=Q.matrix,D.castShadow){const ee=t.get(D);ee.shadowIntensity=Q.intensity,ee.shadowBias=Q.bias,ee.shadowNormalBias=Q.normalBias,ee.shadowRadius=Q.radius,ee.shadowMapSize=Q.mapSize,n.spotShadow[x]=ee,n.spotShadowMap[x]=te,_++}x++}else if(D.isRectAreaLight){const V=e.get(D);V.color.copy(G).multiplyScalar(Y),V.halfWidth.set(D.width*.5,0,0),V.halfHeight.set(0,D.height*.5,0),n.rectArea[E]=V,E++}else if(D.isPointLight){const V=e.get(D);if(V.color.copy(D.color).multiplyScalar(D.intensity),V.distance=D.distance,V.decay=D.decay,D.castShadow){const Q=D.shadow,ee=t.get(D);ee.shadowIntensity=Q.intensity,ee.shadowBias=Q.bias,ee.shadowNormalBias=Q.normalBias,ee.shadowRadius=Q.radius,ee.shadowMapSize=Q.mapSize,ee.shadowCameraNear=Q.camera.near,ee.shadowCameraFar=Q.camera.far,n.pointShadow[p]=ee,n.pointShadowMap[p]=te,n.pointShadowMatrix[p]=D.shadow.matrix,A++}n.point[p]=V,p++}else if(D.isHemisphereLight){const V=e.get(D);V.skyColor.copy(D.color).multiplyScalar(Y),V.groundColor.copy(D.groundColor).multiplyScalar(Y),n.hemi[S]=V,S++}}E>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=me.LTC_FLOAT_1,n.rectAreaLTC2=me.LTC_FLOAT_2):(n.rectAreaLTC1=me.LTC_HALF_1,n.rectAreaLTC2=me.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=d,n.ambient[2]=u;const U=n.hash;(U.sunLength!==m||U.directionalLength!==f||U.pointLength!==p||U.spotLength!==x||U.rectAreaLength!==E||U.hemiLength!==S||U.numSunShadows!==g||U.numDirectionalShadows!==C||U.numPointShadows!==A||U.numSpotShadows!==_||U.numSpotMaps!==w||U.numLightProbes!==P)&&(n.sun.length=m,n.directional.length=f,n.spot.length=x,n.rectArea.length=E,n.point.length=p,n.hemi.length=S,n.sunShadow.length=g,n.sunShadowMap.length=g,n.sunShadowMatrix.length=v,n.sunShadowCascade.length=v,n.directionalShadow.length=C,n.directionalShadowMap.length=C,n.directionalShadowMatrix.length=C,n.pointShadow.length=A,n.pointShadowMap.length=A,n.pointShadowMatrix.length=A,n.spotShadow.length=_,n.spotShadowMap.length=_,n.spotLightMatrix.length=_+w-I,n.spotLightMap.length=w,n.numSpotLightShadowsWithMaps=I,n.numLightProbes=P,U.sunLength=m,U.directionalLength=f,U.pointLength=p,U.spotLength=x,U.rectAreaLength=E,U.hemiLength=S,U.numSunShadows=g,U.numDirectionalShadows=C,U.numPointShadows=A,U.numSpotShadows=_,U.numSpotMaps=w,U.numLightProbes=P,n.version=f_++)}function l(c,h){let d=0,u=0,m=0,g=0,v=0,f=0;const p=h.matrixWorldInverse;for(let x=0,E=c.length;x<E;x++){const S=c[x];if(S.isSunLight){const C=n.sun[d];C.direction.setFromMatrixPosition(S.matrixWorld),C.direction.transformDirection(p),d++}else if(S.isDirectionalLight){const C=n.directional[u];C.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(p),u++}else if(S.isSpotLight){const C=n.spot[g];C.position.setFromMatrixPosition(S.matrixWorld),C.position.applyMatrix4(p),C.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(p),g++}else if(S.isRectAreaLight){const C=n.rectArea[v];C.position.setFromMatrixPosition(S.matrixWorld),C.position.applyMatrix4(p),a.identity(),r.copy(S.matrixWorld),r.premultiply(p),a.extractRotation(r),C.halfWidth.set(S.width*.5,0,0),C.halfHeight.set(0,S.height*.5,0),C.halfWidth.applyMatrix4(a),C.halfHeight.applyMatrix4(a),v++}else if(S.isPointLight){const C=n.point[m];C.position.setFromMatrixPosition(S.matrixWorld),C.position.applyMatrix4(p),m++}else if(S.isHemisphereLight){const C=n.hemi[f];C.direction.setFromMatrixPosition(S.matrixWorld),C.direction.transformDirection(p),f++}}}return{setup:o,setupView:l,state:n}}function zc(i){const e=new m_(i),t=[],n=[],s=[];function r(d){h.camera=d,t.length=0,n.length=0,s.length=0}function a(d){d.isLightProbeGrid?s.push(d):t.push(d)}function o(d){n.push(d)}function l(){e.setup(t),s.sort((d,u)=>d.priority-u.priority||d.id-u.id)}function c(d){e.setupView(t,d)}const h={lightsArray:t,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:a,pushShadow:o}}function g_(i){let e=new WeakMap;function t(s,r=0){const a=e.get(s);let o;return a===void 0?(o=new zc(i),e.set(s,[o])):r>=a.length?(o=new zc(i),a.push(o)):o=a[r],o}function n(){e=new WeakMap}return{get:t,dispose:n}}const __=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,v_=`uniform sampler2D shadow_pass;
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
}`,x_=[new T(1,0,0),new T(-1,0,0),new T(0,1,0),new T(0,-1,0),new T(0,0,1),new T(0,0,-1)],M_=[new T(0,-1,0),new T(0,-1,0),new T(0,0,1),new T(0,0,-1),new T(0,-1,0),new T(0,-1,0)],Hc=new Ge,ps=new T,za=new T;function y_(i,e,t){let n=new Cs;const s=new Ee,r=new Ee,a=new _t,o=new If,l=new Uf,c={},h=t.maxTextureSize,d={[yi]:Yt,[Yt]:yi,[Ft]:Ft},u=new Rn({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Ee},radius:{value:4}},vertexShader:__,fragmentShader:v_}),m=u.clone();m.defines.HORIZONTAL_PASS=1;const g=new Ye;g.setAttribute("position",new vt(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));const v=new fe(g,u),f=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Pr;let p=this.type;this.render=function(A,_,w){if(f.enabled===!1||f.autoUpdate===!1&&f.needsUpdate===!1||A.length===0)return;this.type===Md&&(De("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Pr);const I=i.getRenderTarget(),P=i.getActiveCubeFace(),U=i.getActiveMipmapLevel(),O=i.state;O.setBlending(Wi),O.buffers.depth.getReversed()===!0?O.buffers.color.setClear(0,0,0,0):O.buffers.color.setClear(1,1,1,1),O.buffers.depth.setTest(!0),O.setScissorTest(!1);const X=p!==this.type;X&&_.traverse(function(D){D.material&&(Array.isArray(D.material)?D.material.forEach(G=>G.needsUpdate=!0):D.material.needsUpdate=!0)});for(let D=0,G=A.length;D<G;D++){const Y=A[D],B=Y.shadow;if(B===void 0){De("WebGLShadowMap:",Y,"has no shadow.");continue}if(B.autoUpdate===!1&&B.needsUpdate===!1)continue;s.copy(B.mapSize);const te=B.getFrameExtents();s.multiply(te),r.copy(B.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/te.x),s.x=r.x*te.x,B.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/te.y),s.y=r.y*te.y,B.mapSize.y=r.y));const V=i.state.buffers.depth.getReversed();if(B.camera._reversedDepth=V,B.map===null||X===!0){if(B.map!==null&&(B.map.depthTexture!==null&&(B.map.depthTexture.dispose(),B.map.depthTexture=null),B.map.dispose()),this.type===_s){if(Y.isPointLight){De("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}B.map=new Tn(s.x,s.y,{format:li,type:Un,minFilter:qt,magFilter:qt,generateMipmaps:!1}),B.map.texture.name=Y.name+".shadowMap",B.map.depthTexture=new bi(s.x,s.y,pn),B.map.depthTexture.name=Y.name+".shadowMapDepth",B.map.depthTexture.format=oi,B.map.depthTexture.compareFunction=null,B.map.depthTexture.minFilter=Ot,B.map.depthTexture.magFilter=Ot}else Y.isPointLight?(B.map=new _l(s.x),B.map.depthTexture=new iu(s.x,An)):(B.map=new Tn(s.x,s.y),B.map.depthTexture=new bi(s.x,s.y,An)),B.map.depthTexture.name=Y.name+".shadowMap",B.map.depthTexture.format=oi,this.type===Pr?(B.map.depthTexture.compareFunction=V?Xh:Wh,B.map.depthTexture.minFilter=qt,B.map.depthTexture.magFilter=qt):(B.map.depthTexture.compareFunction=null,B.map.depthTexture.minFilter=Ot,B.map.depthTexture.magFilter=Ot);B.camera.updateProjectionMatrix()}B.map.isWebGLCubeRenderTarget!==!0&&(B.map.width!==s.x||B.map.height!==s.y)&&B.map.setSize(s.x,s.y);const Q=B.map.isWebGLCubeRenderTarget?6:B.getViewportCount();Y.isPointLight!==!0&&B.updateMatrices(Y,w);const ee=(B.camera.layers.mask&4294967294)!==0?B.camera.layers:w.layers;for(let xe=0;xe<Q;xe++){const Ne=B.getCamera(xe);if(Y.isPointLight){const Z=B.camera,ge=B.matrix,ye=Y.distance||Z.far;ye!==Z.far&&(Z.far=ye,Z.updateProjectionMatrix()),ps.setFromMatrixPosition(Y.matrixWorld),Z.position.copy(ps),za.copy(Z.position),za.add(x_[xe]),Z.up.copy(M_[xe]),Z.lookAt(za),Z.updateMatrixWorld(),ge.makeTranslation(-ps.x,-ps.y,-ps.z),Hc.multiplyMatrices(Z.projectionMatrix,Z.matrixWorldInverse),B._frustum.setFromProjectionMatrix(Hc,Z.coordinateSystem,Z.reversedDepth)}if(B.map.isWebGLCubeRenderTarget)i.setRenderTarget(B.map,xe),i.clear();else{xe===0&&(i.setRenderTarget(B.map),i.clear());const Z=B.getViewport(xe);a.set(r.x*Z.x,r.y*Z.y,r.x*Z.z,r.y*Z.w),O.viewport(a)}n=B.getFrustum(xe),S(_,w,Ne,Y,ee,this.type)}B.isPointLightShadow!==!0&&this.type===_s&&x(B,w),B.needsUpdate=!1}p=this.type,f.needsUpdate=!1,i.setRenderTarget(I,P,U)};function x(A,_){const w=e.update(v);u.defines.VSM_SAMPLES!==A.blurSamples&&(u.defines.VSM_SAMPLES=A.blurSamples,m.defines.VSM_SAMPLES=A.blurSamples,u.needsUpdate=!0,m.needsUpdate=!0),A.mapPass===null?A.mapPass=new Tn(s.x,s.y,{format:li,type:Un}):(A.mapPass.width!==A.map.width||A.mapPass.height!==A.map.height)&&A.mapPass.setSize(A.map.width,A.map.height),u.uniforms.shadow_pass.value=A.map.depthTexture,u.uniforms.resolution.value.set(A.map.width,A.map.height),u.uniforms.radius.value=A.radius,i.setRenderTarget(A.mapPass),i.clear(),i.renderBufferDirect(_,null,w,u,v,null),m.uniforms.shadow_pass.value=A.mapPass.texture,m.uniforms.resolution.value.set(A.map.width,A.map.height),m.uniforms.radius.value=A.radius,i.setRenderTarget(A.map),i.clear(),i.renderBufferDirect(_,null,w,m,v,null)}function E(A,_,w,I){let P=null;const U=w.isPointLight===!0?A.customDistanceMaterial:A.customDepthMaterial;if(U!==void 0)P=U;else if(P=w.isPointLight===!0?l:o,i.localClippingEnabled&&_.clipShadows===!0&&Array.isArray(_.clippingPlanes)&&_.clippingPlanes.length!==0||_.displacementMap&&_.displacementScale!==0||_.alphaMap&&_.alphaTest>0||_.map&&_.alphaTest>0||_.alphaToCoverage===!0){const O=P.uuid,X=_.uuid;let D=c[O];D===void 0&&(D={},c[O]=D);let G=D[X];G===void 0&&(G=P.clone(),D[X]=G,_.addEventListener("dispose",C)),P=G}if(P.visible=_.visible,P.wireframe=_.wireframe,I===_s?P.side=_.shadowSide!==null?_.shadowSide:_.side:P.side=_.shadowSide!==null?_.shadowSide:d[_.side],P.alphaMap=_.alphaMap,P.alphaTest=_.alphaToCoverage===!0?.5:_.alphaTest,P.map=_.map,P.clipShadows=_.clipShadows,P.clippingPlanes=_.clippingPlanes,P.clipIntersection=_.clipIntersection,P.displacementMap=_.displacementMap,P.displacementScale=_.displacementScale,P.displacementBias=_.displacementBias,P.wireframeLinewidth=_.wireframeLinewidth,P.linewidth=_.linewidth,w.isPointLight===!0&&P.isMeshDistanceMaterial===!0){const O=i.properties.get(P);O.light=w}return P}function S(A,_,w,I,P,U){if(A.visible===!1)return;if(A.layers.test(P)&&(A.isMesh||A.isLine||A.isPoints)&&(A.castShadow||A.receiveShadow&&U===_s)&&(!A.frustumCulled||A.intersectsFrustum(n))){A.modelViewMatrix.multiplyMatrices(w.matrixWorldInverse,A.matrixWorld);const D=e.update(A),G=A.material;if(Array.isArray(G)){const Y=D.groups;for(let B=0,te=Y.length;B<te;B++){const V=Y[B],Q=G[V.materialIndex];if(Q&&Q.visible){const ee=E(A,Q,I,U);A.onBeforeShadow(i,A,_,w,D,ee,V),i.renderBufferDirect(w,null,D,ee,A,V),A.onAfterShadow(i,A,_,w,D,ee,V)}}}else if(G.visible){const Y=E(A,G,I,U);A.onBeforeShadow(i,A,_,w,D,Y,null),i.renderBufferDirect(w,null,D,Y,A,null),A.onAfterShadow(i,A,_,w,D,Y,null)}}const X=A.children;for(let D=0,G=X.length;D<G;D++)S(X[D],_,w,I,P,U)}function C(A){A.target.removeEventListener("dispose",C);for(const w in c){const I=c[w],P=A.target.uuid;P in I&&(I[P].dispose(),delete I[P])}}}function b_(i,e){function t(){let L=!1;const J=new _t;let $=null;const le=new _t(0,0,0,0);return{setMask:function(se){$!==se&&!L&&(i.colorMask(se,se,se,se),$=se)},setLocked:function(se){L=se},setClear:function(se,ae,Te,ze,ie){ie===!0&&(se*=ze,ae*=ze,Te*=ze),J.set(se,ae,Te,ze),le.equals(J)===!1&&(i.clearColor(se,ae,Te,ze),le.copy(J))},reset:function(){L=!1,$=null,le.set(-1,0,0,0)}}}function n(){let L=!1,J=!1,$=null,le=null,se=null;return{setReversed:function(ae){if(J!==ae){const Te=e.get("EXT_clip_control");ae?Te.clipControlEXT(Te.LOWER_LEFT_EXT,Te.ZERO_TO_ONE_EXT):Te.clipControlEXT(Te.LOWER_LEFT_EXT,Te.NEGATIVE_ONE_TO_ONE_EXT),J=ae;const ze=se;se=null,this.setClear(ze)}},getReversed:function(){return J},setTest:function(ae){ae?_e(i.DEPTH_TEST):Oe(i.DEPTH_TEST)},setMask:function(ae){$!==ae&&!L&&(i.depthMask(ae),$=ae)},setFunc:function(ae){if(J&&(ae=ef[ae]),le!==ae){switch(ae){case eo:i.depthFunc(i.NEVER);break;case to:i.depthFunc(i.ALWAYS);break;case no:i.depthFunc(i.LESS);break;case Es:i.depthFunc(i.LEQUAL);break;case io:i.depthFunc(i.EQUAL);break;case so:i.depthFunc(i.GEQUAL);break;case ro:i.depthFunc(i.GREATER);break;case ao:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}le=ae}},setLocked:function(ae){L=ae},setClear:function(ae){se!==ae&&(se=ae,J&&(ae=1-ae),i.clearDepth(ae))},reset:function(){L=!1,$=null,le=null,se=null,J=!1}}}function s(){let L=!1,J=null,$=null,le=null,se=null,ae=null,Te=null,ze=null,ie=null;return{setTest:function(Ae){L||(Ae?_e(i.STENCIL_TEST):Oe(i.STENCIL_TEST))},setMask:function(Ae){J!==Ae&&!L&&(i.stencilMask(Ae),J=Ae)},setFunc:function(Ae,ke,pe){($!==Ae||le!==ke||se!==pe)&&(i.stencilFunc(Ae,ke,pe),$=Ae,le=ke,se=pe)},setOp:function(Ae,ke,pe){(ae!==Ae||Te!==ke||ze!==pe)&&(i.stencilOp(Ae,ke,pe),ae=Ae,Te=ke,ze=pe)},setLocked:function(Ae){L=Ae},setClear:function(Ae){ie!==Ae&&(i.clearStencil(Ae),ie=Ae)},reset:function(){L=!1,J=null,$=null,le=null,se=null,ae=null,Te=null,ze=null,ie=null}}}const r=new t,a=new n,o=new s;let l={};const c=new WeakMap;let h={},d={},u={},m=new WeakMap,g=[],v=null,f=!1,p=null,x=null,E=null,S=null,C=null,A=null,_=null,w=new Ue(0,0,0),I=0,P=!1,U=null,O=null,X=null,D=null,G=null;const Y=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS);let B=!1,te=0;const V=i.getParameter(i.VERSION);V.indexOf("WebGL")!==-1?(te=parseFloat(/^WebGL (\d)/.exec(V)[1]),B=te>=1):V.indexOf("OpenGL ES")!==-1&&(te=parseFloat(/^OpenGL ES (\d)/.exec(V)[1]),B=te>=2);let Q=null,ee={};const xe=i.getParameter(i.SCISSOR_BOX),Ne=i.getParameter(i.VIEWPORT),Z=new _t().fromArray(xe),ge=new _t().fromArray(Ne);function ye(L,J,$,le){const se=new Uint8Array(4),ae=i.createTexture();i.bindTexture(L,ae),i.texParameteri(L,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(L,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Te=0;Te<$;Te++)L===i.TEXTURE_3D||L===i.TEXTURE_2D_ARRAY?i.texImage3D(J,0,i.RGBA,1,1,le,0,i.RGBA,i.UNSIGNED_BYTE,se):i.texImage2D(J+Te,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,se);return ae}const Ce={};Ce[i.TEXTURE_2D]=ye(i.TEXTURE_2D,i.TEXTURE_2D,1),Ce[i.TEXTURE_CUBE_MAP]=ye(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Ce[i.TEXTURE_2D_ARRAY]=ye(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Ce[i.TEXTURE_3D]=ye(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),a.setClear(1),o.setClear(0),_e(i.DEPTH_TEST),a.setFunc(Es),Kt(!1),ut(Bl),_e(i.CULL_FACE),Nt(Wi);function _e(L){h[L]!==!0&&(i.enable(L),h[L]=!0)}function Oe(L){h[L]!==!1&&(i.disable(L),h[L]=!1)}function xt(L,J){return u[L]!==J?(i.bindFramebuffer(L,J),u[L]=J,L===i.DRAW_FRAMEBUFFER&&(u[i.FRAMEBUFFER]=J),L===i.FRAMEBUFFER&&(u[i.DRAW_FRAMEBUFFER]=J),!0):!1}function Le(L,J){let $=g,le=!1;if(L){$=m.get(J),$===void 0&&($=[],m.set(J,$));const se=L.textures;if($.length!==se.length||$[0]!==i.COLOR_ATTACHMENT0){for(let ae=0,Te=se.length;ae<Te;ae++)$[ae]=i.COLOR_ATTACHMENT0+ae;$.length=se.length,le=!0}}else $[0]!==i.BACK&&($[0]=i.BACK,le=!0);le&&i.drawBuffers($)}function Qe(L){return v!==L?(i.useProgram(L),v=L,!0):!1}const it={[zi]:i.FUNC_ADD,[bd]:i.FUNC_SUBTRACT,[Sd]:i.FUNC_REVERSE_SUBTRACT};it[wd]=i.MIN,it[Ed]=i.MAX;const We={[Td]:i.ZERO,[Ad]:i.ONE,[Rd]:i.SRC_COLOR,[Ah]:i.SRC_ALPHA,[Id]:i.SRC_ALPHA_SATURATE,[Dd]:i.DST_COLOR,[Pd]:i.DST_ALPHA,[Cd]:i.ONE_MINUS_SRC_COLOR,[Rh]:i.ONE_MINUS_SRC_ALPHA,[Nd]:i.ONE_MINUS_DST_COLOR,[Ld]:i.ONE_MINUS_DST_ALPHA,[Ud]:i.CONSTANT_COLOR,[Fd]:i.ONE_MINUS_CONSTANT_COLOR,[Od]:i.CONSTANT_ALPHA,[Bd]:i.ONE_MINUS_CONSTANT_ALPHA};function Nt(L,J,$,le,se,ae,Te,ze,ie,Ae){if(L===Wi){f===!0&&(Oe(i.BLEND),f=!1);return}if(f===!1&&(_e(i.BLEND),f=!0),L!==yd){if(L!==p||Ae!==P){if((x!==zi||C!==zi)&&(i.blendEquation(i.FUNC_ADD),x=zi,C=zi),Ae)switch(L){case bs:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case kl:i.blendFunc(i.ONE,i.ONE);break;case zl:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case Hl:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:Ke("WebGLState: Invalid blending: ",L);break}else switch(L){case bs:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case kl:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case zl:Ke("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Hl:Ke("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:Ke("WebGLState: Invalid blending: ",L);break}E=null,S=null,A=null,_=null,w.set(0,0,0),I=0,p=L,P=Ae}return}se=se||J,ae=ae||$,Te=Te||le,(J!==x||se!==C)&&(i.blendEquationSeparate(it[J],it[se]),x=J,C=se),($!==E||le!==S||ae!==A||Te!==_)&&(i.blendFuncSeparate(We[$],We[le],We[ae],We[Te]),E=$,S=le,A=ae,_=Te),(ze.equals(w)===!1||ie!==I)&&(i.blendColor(ze.r,ze.g,ze.b,ie),w.copy(ze),I=ie),p=L,P=!1}function St(L,J){L.side===Ft?Oe(i.CULL_FACE):_e(i.CULL_FACE);let $=L.side===Yt;J&&($=!$),Kt($),L.blending===bs&&L.transparent===!1?Nt(Wi):Nt(L.blending,L.blendEquation,L.blendSrc,L.blendDst,L.blendEquationAlpha,L.blendSrcAlpha,L.blendDstAlpha,L.blendColor,L.blendAlpha,L.premultipliedAlpha),a.setFunc(L.depthFunc),a.setTest(L.depthTest),a.setMask(L.depthWrite),r.setMask(L.colorWrite);const le=L.stencilWrite;o.setTest(le),le&&(o.setMask(L.stencilWriteMask),o.setFunc(L.stencilFunc,L.stencilRef,L.stencilFuncMask),o.setOp(L.stencilFail,L.stencilZFail,L.stencilZPass)),Ct(L.polygonOffset,L.polygonOffsetFactor,L.polygonOffsetUnits),L.alphaToCoverage===!0?_e(i.SAMPLE_ALPHA_TO_COVERAGE):Oe(i.SAMPLE_ALPHA_TO_COVERAGE)}function Kt(L){U!==L&&(L?i.frontFace(i.CW):i.frontFace(i.CCW),U=L)}function ut(L){L!==vd?(_e(i.CULL_FACE),L!==O&&(L===Bl?i.cullFace(i.BACK):L===xd?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Oe(i.CULL_FACE),O=L}function Cn(L){L!==X&&(B&&i.lineWidth(L),X=L)}function Ct(L,J,$){L?(_e(i.POLYGON_OFFSET_FILL),(D!==J||G!==$)&&(D=J,G=$,a.getReversed()&&(J=-J,$=-$),i.polygonOffset(J,$))):Oe(i.POLYGON_OFFSET_FILL)}function an(L){L?_e(i.SCISSOR_TEST):Oe(i.SCISSOR_TEST)}function on(L){L===void 0&&(L=i.TEXTURE0+Y-1),Q!==L&&(i.activeTexture(L),Q=L)}function ln(L,J,$){$===void 0&&(Q===null?$=i.TEXTURE0+Y-1:$=Q);let le=ee[$];le===void 0&&(le={type:void 0,texture:void 0},ee[$]=le),(le.type!==L||le.texture!==J)&&(Q!==$&&(i.activeTexture($),Q=$),i.bindTexture(L,J||Ce[L]),le.type=L,le.texture=J)}function F(){const L=ee[Q];L!==void 0&&L.type!==void 0&&(i.bindTexture(L.type,null),L.type=void 0,L.texture=void 0)}function cn(){try{i.compressedTexImage2D(...arguments)}catch(L){Ke("WebGLState:",L)}}function ot(){try{i.compressedTexImage3D(...arguments)}catch(L){Ke("WebGLState:",L)}}function lt(){try{i.texSubImage2D(...arguments)}catch(L){Ke("WebGLState:",L)}}function de(){try{i.texSubImage3D(...arguments)}catch(L){Ke("WebGLState:",L)}}function wt(){try{i.compressedTexSubImage2D(...arguments)}catch(L){Ke("WebGLState:",L)}}function Pe(){try{i.compressedTexSubImage3D(...arguments)}catch(L){Ke("WebGLState:",L)}}function Ie(){try{i.texStorage2D(...arguments)}catch(L){Ke("WebGLState:",L)}}function R(){try{i.texStorage3D(...arguments)}catch(L){Ke("WebGLState:",L)}}function M(){try{i.texImage2D(...arguments)}catch(L){Ke("WebGLState:",L)}}function z(){try{i.texImage3D(...arguments)}catch(L){Ke("WebGLState:",L)}}function ne(L){return d[L]!==void 0?d[L]:i.getParameter(L)}function j(L,J){d[L]!==J&&(i.pixelStorei(L,J),d[L]=J)}function re(L){Z.equals(L)===!1&&(i.scissor(L.x,L.y,L.z,L.w),Z.copy(L))}function he(L){ge.equals(L)===!1&&(i.viewport(L.x,L.y,L.z,L.w),ge.copy(L))}function q(L,J){let $=c.get(J);$===void 0&&($=new WeakMap,c.set(J,$));let le=$.get(L);le===void 0&&(le=i.getUniformBlockIndex(J,L.name),i.uniformBlockBinding(J,le,le),$.set(L,le))}function K(L,J,$){const se=c.get(J).get(L);l[se]!==$&&(i.bindBufferBase(i.UNIFORM_BUFFER,se,$),l[se]=$)}function oe(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),a.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),h={},d={},Q=null,ee={},u={},l={},m=new WeakMap,g=[],v=null,f=!1,p=null,x=null,E=null,S=null,C=null,A=null,_=null,w=new Ue(0,0,0),I=0,P=!1,U=null,O=null,X=null,D=null,G=null,Z.set(0,0,i.canvas.width,i.canvas.height),ge.set(0,0,i.canvas.width,i.canvas.height),r.reset(),a.reset(),o.reset()}return{buffers:{color:r,depth:a,stencil:o},enable:_e,disable:Oe,bindFramebuffer:xt,drawBuffers:Le,useProgram:Qe,setBlending:Nt,setMaterial:St,setFlipSided:Kt,setCullFace:ut,setLineWidth:Cn,setPolygonOffset:Ct,setScissorTest:an,activeTexture:on,bindTexture:ln,unbindTexture:F,compressedTexImage2D:cn,compressedTexImage3D:ot,texImage2D:M,texImage3D:z,pixelStorei:j,getParameter:ne,updateUBOMapping:q,uniformBlockBinding:K,texStorage2D:Ie,texStorage3D:R,texSubImage2D:lt,texSubImage3D:de,compressedTexSubImage2D:wt,compressedTexSubImage3D:Pe,scissor:re,viewport:he,reset:oe}}function S_(i,e,t,n,s,r,a){const o=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Ee,h=new WeakMap,d=new Set;let u;const m=new WeakMap,g=new Set,v=new FinalizationRegistry(R=>g.delete(R));let f=!1;try{f=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function p(R,M){return f?new OffscreenCanvas(R,M):Wr("canvas")}function x(R,M,z){let ne=1;const j=Ie(R);if((j.width>z||j.height>z)&&(ne=z/Math.max(j.width,j.height)),ne<1)if(typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&R instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&R instanceof ImageBitmap||typeof VideoFrame<"u"&&R instanceof VideoFrame){const re=Math.floor(ne*j.width),he=Math.floor(ne*j.height);u===void 0&&(u=p(re,he));const q=M?p(re,he):u;return q.width=re,q.height=he,q.getContext("2d").drawImage(R,0,0,re,he),De("WebGLRenderer: Texture has been resized from ("+j.width+"x"+j.height+") to ("+re+"x"+he+")."),q}else return"data"in R&&De("WebGLRenderer: Image in DataTexture is too big ("+j.width+"x"+j.height+")."),R;return R}function E(R){return R.generateMipmaps}function S(R){i.generateMipmap(R)}function C(R){return R.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:R.isWebGL3DRenderTarget?i.TEXTURE_3D:R.isWebGLArrayRenderTarget||R.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function A(R,M,z,ne,j,re=!1){if(R!==null){if(i[R]!==void 0)return i[R];De("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+R+"'")}let he;ne&&(he=e.get("EXT_texture_norm16"),he||De("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let q=M;if(M===i.RED&&(z===i.FLOAT&&(q=i.R32F),z===i.HALF_FLOAT&&(q=i.R16F),z===i.UNSIGNED_BYTE&&(q=i.R8),z===i.UNSIGNED_SHORT&&he&&(q=he.R16_EXT),z===i.SHORT&&he&&(q=he.R16_SNORM_EXT)),M===i.RED_INTEGER&&(z===i.UNSIGNED_BYTE&&(q=i.R8UI),z===i.UNSIGNED_SHORT&&(q=i.R16UI),z===i.UNSIGNED_INT&&(q=i.R32UI),z===i.BYTE&&(q=i.R8I),z===i.SHORT&&(q=i.R16I),z===i.INT&&(q=i.R32I)),M===i.RG&&(z===i.FLOAT&&(q=i.RG32F),z===i.HALF_FLOAT&&(q=i.RG16F),z===i.UNSIGNED_BYTE&&(q=i.RG8),z===i.UNSIGNED_SHORT&&he&&(q=he.RG16_EXT),z===i.SHORT&&he&&(q=he.RG16_SNORM_EXT)),M===i.RG_INTEGER&&(z===i.UNSIGNED_BYTE&&(q=i.RG8UI),z===i.UNSIGNED_SHORT&&(q=i.RG16UI),z===i.UNSIGNED_INT&&(q=i.RG32UI),z===i.BYTE&&(q=i.RG8I),z===i.SHORT&&(q=i.RG16I),z===i.INT&&(q=i.RG32I)),M===i.RGB_INTEGER&&(z===i.UNSIGNED_BYTE&&(q=i.RGB8UI),z===i.UNSIGNED_SHORT&&(q=i.RGB16UI),z===i.UNSIGNED_INT&&(q=i.RGB32UI),z===i.BYTE&&(q=i.RGB8I),z===i.SHORT&&(q=i.RGB16I),z===i.INT&&(q=i.RGB32I)),M===i.RGBA_INTEGER&&(z===i.UNSIGNED_BYTE&&(q=i.RGBA8UI),z===i.UNSIGNED_SHORT&&(q=i.RGBA16UI),z===i.UNSIGNED_INT&&(q=i.RGBA32UI),z===i.BYTE&&(q=i.RGBA8I),z===i.SHORT&&(q=i.RGBA16I),z===i.INT&&(q=i.RGBA32I)),M===i.RGB&&(z===i.UNSIGNED_SHORT&&he&&(q=he.RGB16_EXT),z===i.SHORT&&he&&(q=he.RGB16_SNORM_EXT),z===i.UNSIGNED_INT_5_9_9_9_REV&&(q=i.RGB9_E5),z===i.UNSIGNED_INT_10F_11F_11F_REV&&(q=i.R11F_G11F_B10F)),M===i.RGBA){const K=re?Vr:qe.getTransfer(j);z===i.FLOAT&&(q=i.RGBA32F),z===i.HALF_FLOAT&&(q=i.RGBA16F),z===i.UNSIGNED_BYTE&&(q=K===tt?i.SRGB8_ALPHA8:i.RGBA8),z===i.UNSIGNED_SHORT&&he&&(q=he.RGBA16_EXT),z===i.SHORT&&he&&(q=he.RGBA16_SNORM_EXT),z===i.UNSIGNED_SHORT_4_4_4_4&&(q=i.RGBA4),z===i.UNSIGNED_SHORT_5_5_5_1&&(q=i.RGB5_A1)}return(q===i.R16F||q===i.R32F||q===i.RG16F||q===i.RG32F||q===i.RGBA16F||q===i.RGBA32F)&&e.get("EXT_color_buffer_float"),q}function _(R,M){let z;return R?M===null||M===An||M===Ji?z=i.DEPTH24_STENCIL8:M===pn?z=i.DEPTH32F_STENCIL8:M===As&&(z=i.DEPTH24_STENCIL8,De("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):M===null||M===An||M===Ji?z=i.DEPTH_COMPONENT24:M===pn?z=i.DEPTH_COMPONENT32F:M===As&&(z=i.DEPTH_COMPONENT16),z}function w(R,M){return E(R)===!0||R.isFramebufferTexture&&R.minFilter!==Ot&&R.minFilter!==qt?Math.log2(Math.max(M.width,M.height))+1:R.mipmaps.length>0?R.mipmaps.length:R.isCompressedTexture&&Array.isArray(R.image)?M.mipmaps.length:1}function I(R){const M=new WeakRef(R);n.get(R).__ref=M,g.add(M),v.register(R,M,M)}function P(R){const M=n.get(R).__ref;M!==void 0&&(g.delete(M),v.unregister(M))}function U(R){X(R.target)}function O(R){D(R.target)}function X(R){R.removeEventListener("dispose",U),P(R),Y(R),R.isVideoTexture&&h.delete(R),R.isHTMLTexture&&d.delete(R)}function D(R){R.removeEventListener("dispose",O),P(R),te(R)}function G(){for(const R of g){const M=R.deref();M!==void 0&&(M.isRenderTarget===!0?D(M):X(M))}g.clear(),d.clear()}function Y(R){const M=n.get(R);if(M.__webglInit===void 0)return;const z=R.source,ne=m.get(z);if(ne){const j=ne[M.__cacheKey];j.usedTimes--,j.usedTimes===0&&B(R),Object.keys(ne).length===0&&m.delete(z)}n.remove(R)}function B(R){const M=n.get(R);i.deleteTexture(M.__webglTexture);const z=R.source,ne=m.get(z);delete ne[M.__cacheKey],a.memory.textures--}function te(R){const M=n.get(R);M.__depthDisposeCallback&&M.__depthDisposeCallback();const z=R.depthTexture;if(z&&z.renderTarget===R&&X(z),R.isWebGLCubeRenderTarget)for(let j=0;j<6;j++){if(Array.isArray(M.__webglFramebuffer[j]))for(let re=0;re<M.__webglFramebuffer[j].length;re++)i.deleteFramebuffer(M.__webglFramebuffer[j][re]);else i.deleteFramebuffer(M.__webglFramebuffer[j]);M.__webglDepthbuffer&&i.deleteRenderbuffer(M.__webglDepthbuffer[j])}else{if(Array.isArray(M.__webglFramebuffer))for(let j=0;j<M.__webglFramebuffer.length;j++)i.deleteFramebuffer(M.__webglFramebuffer[j]);else i.deleteFramebuffer(M.__webglFramebuffer);if(M.__webglDepthbuffer&&i.deleteRenderbuffer(M.__webglDepthbuffer),M.__webglMultisampledFramebuffer&&i.deleteFramebuffer(M.__webglMultisampledFramebuffer),M.__webglColorRenderbuffer)for(let j=0;j<M.__webglColorRenderbuffer.length;j++)M.__webglColorRenderbuffer[j]&&i.deleteRenderbuffer(M.__webglColorRenderbuffer[j]);M.__webglDepthRenderbuffer&&i.deleteRenderbuffer(M.__webglDepthRenderbuffer)}const ne=R.textures;for(let j=0,re=ne.length;j<re;j++){const he=n.get(ne[j]);he.__webglTexture&&(i.deleteTexture(he.__webglTexture),a.memory.textures--),n.remove(ne[j])}n.remove(R)}let V=0;function Q(){V=0}function ee(){return V}function xe(R){V=R}function Ne(){const R=V;return R>=s.maxTextures&&De("WebGLTextures: Trying to use "+(R+1)+" texture units while this GPU supports only "+s.maxTextures),V+=1,R}function Z(R){const M=[];return M.push(R.wrapS),M.push(R.wrapT),M.push(R.wrapR||0),M.push(R.magFilter),M.push(R.minFilter),M.push(R.anisotropy),M.push(R.internalFormat),M.push(R.format),M.push(R.type),M.push(R.generateMipmaps),M.push(R.mipmapsAutoUpdate),M.push(R.premultiplyAlpha),M.push(R.flipY),M.push(R.unpackAlignment),M.push(R.colorSpace),M.join()}function ge(R,M){const z=n.get(R);if(R.isVideoTexture&&wt(R),R.isRenderTargetTexture===!1&&R.isExternalTexture!==!0&&R.version>0&&z.__version!==R.version){const ne=R.image;if(ne===null)De("WebGLRenderer: Texture marked for update but no image data found.");else if(ne.complete===!1)De("WebGLRenderer: Texture marked for update but image is incomplete");else{St(z,R,M);return}}else R.isExternalTexture&&(z.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(i.TEXTURE_2D,z.__webglTexture,i.TEXTURE0+M)}function ye(R,M){const z=n.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&z.__version!==R.version){St(z,R,M);return}else R.isExternalTexture&&(z.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(i.TEXTURE_2D_ARRAY,z.__webglTexture,i.TEXTURE0+M)}function Ce(R,M){const z=n.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&z.__version!==R.version){St(z,R,M);return}t.bindTexture(i.TEXTURE_3D,z.__webglTexture,i.TEXTURE0+M)}function _e(R,M){const z=n.get(R);if(R.version>0&&z.__version!==R.version){Kt(z,R,M);return}t.bindTexture(i.TEXTURE_CUBE_MAP,z.__webglTexture,i.TEXTURE0+M)}const Oe={[oo]:i.REPEAT,[Vn]:i.CLAMP_TO_EDGE,[lo]:i.MIRRORED_REPEAT},xt={[Ot]:i.NEAREST,[Hd]:i.NEAREST_MIPMAP_NEAREST,[Xs]:i.NEAREST_MIPMAP_LINEAR,[qt]:i.LINEAR,[da]:i.LINEAR_MIPMAP_NEAREST,[si]:i.LINEAR_MIPMAP_LINEAR},Le={[Xd]:i.NEVER,[$h]:i.ALWAYS,[$d]:i.LESS,[Wh]:i.LEQUAL,[qd]:i.EQUAL,[Xh]:i.GEQUAL,[Yd]:i.GREATER,[Zd]:i.NOTEQUAL};function Qe(R,M){if(M.type===pn&&e.has("OES_texture_float_linear")===!1&&(M.magFilter===qt||M.magFilter===da||M.magFilter===Xs||M.magFilter===si||M.minFilter===qt||M.minFilter===da||M.minFilter===Xs||M.minFilter===si)&&De("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(R,i.TEXTURE_WRAP_S,Oe[M.wrapS]),i.texParameteri(R,i.TEXTURE_WRAP_T,Oe[M.wrapT]),(R===i.TEXTURE_3D||R===i.TEXTURE_2D_ARRAY)&&i.texParameteri(R,i.TEXTURE_WRAP_R,Oe[M.wrapR]),i.texParameteri(R,i.TEXTURE_MAG_FILTER,xt[M.magFilter]),i.texParameteri(R,i.TEXTURE_MIN_FILTER,xt[M.minFilter]),M.compareFunction&&(i.texParameteri(R,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(R,i.TEXTURE_COMPARE_FUNC,Le[M.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(M.magFilter===Ot||M.minFilter!==Xs&&M.minFilter!==si||M.type===pn&&e.has("OES_texture_float_linear")===!1)return;if(M.anisotropy>1||n.get(M).__currentAnisotropy){const z=e.get("EXT_texture_filter_anisotropic");i.texParameterf(R,z.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(M.anisotropy,s.getMaxAnisotropy())),n.get(M).__currentAnisotropy=M.anisotropy}}}function it(R,M){let z=!1;R.__webglInit===void 0&&(R.__webglInit=!0,M.addEventListener("dispose",U),I(M));const ne=M.source;let j=m.get(ne);j===void 0&&(j={},m.set(ne,j));const re=Z(M);if(re!==R.__cacheKey){j[re]===void 0&&(j[re]={texture:i.createTexture(),usedTimes:0},a.memory.textures++,z=!0),j[re].usedTimes++;const he=j[R.__cacheKey];he!==void 0&&(j[R.__cacheKey].usedTimes--,he.usedTimes===0&&B(M)),R.__cacheKey=re,R.__webglTexture=j[re].texture}return z}function We(R,M,z){return Math.floor(Math.floor(R/z)/M)}function Nt(R,M,z,ne){const re=R.updateRanges;if(re.length===0)t.texSubImage2D(i.TEXTURE_2D,0,0,0,M.width,M.height,z,ne,M.data);else{re.sort((L,J)=>L.start-J.start);let he=0;for(let L=1;L<re.length;L++){const J=re[he],$=re[L],le=J.start+J.count,se=We($.start,M.width,4),ae=We(J.start,M.width,4);$.start<=le+1&&se===ae&&We($.start+$.count-1,M.width,4)===se?J.count=Math.max(J.count,$.start+$.count-J.start):(++he,re[he]=$)}re.length=he+1;const q=t.getParameter(i.UNPACK_ROW_LENGTH),K=t.getParameter(i.UNPACK_SKIP_PIXELS),oe=t.getParameter(i.UNPACK_SKIP_ROWS);t.pixelStorei(i.UNPACK_ROW_LENGTH,M.width);for(let L=0,J=re.length;L<J;L++){const $=re[L],le=Math.floor($.start/4),se=Math.ceil($.count/4),ae=le%M.width,Te=Math.floor(le/M.width),ze=se,ie=1;t.pixelStorei(i.UNPACK_SKIP_PIXELS,ae),t.pixelStorei(i.UNPACK_SKIP_ROWS,Te),t.texSubImage2D(i.TEXTURE_2D,0,ae,Te,ze,ie,z,ne,M.data)}R.clearUpdateRanges(),t.pixelStorei(i.UNPACK_ROW_LENGTH,q),t.pixelStorei(i.UNPACK_SKIP_PIXELS,K),t.pixelStorei(i.UNPACK_SKIP_ROWS,oe)}}function St(R,M,z){let ne=i.TEXTURE_2D;(M.isDataArrayTexture||M.isCompressedArrayTexture)&&(ne=i.TEXTURE_2D_ARRAY),M.isData3DTexture&&(ne=i.TEXTURE_3D);const j=it(R,M),re=M.source;t.bindTexture(ne,R.__webglTexture,i.TEXTURE0+z);const he=n.get(re);if(re.version!==he.__version||j===!0){if(t.activeTexture(i.TEXTURE0+z),(typeof ImageBitmap<"u"&&M.image instanceof ImageBitmap)===!1){const ie=qe.getPrimaries(qe.workingColorSpace),Ae=M.colorSpace===ti?null:qe.getPrimaries(M.colorSpace),ke=M.colorSpace===ti||ie===Ae?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,M.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,ke)}t.pixelStorei(i.UNPACK_ALIGNMENT,M.unpackAlignment);let K=x(M.image,!1,s.maxTextureSize);K=Pe(M,K);const oe=r.convert(M.format,M.colorSpace),L=r.convert(M.type);let J=A(M.internalFormat,oe,L,M.normalized,M.colorSpace,M.isVideoTexture);Qe(ne,M);let $;const le=M.mipmaps,se=M.isVideoTexture!==!0,ae=he.__version===void 0||j===!0,Te=re.dataReady,ze=w(M,K);if(M.isDepthTexture)J=_(M.format===ri,M.type),ae&&(se?t.texStorage2D(i.TEXTURE_2D,1,J,K.width,K.height):t.texImage2D(i.TEXTURE_2D,0,J,K.width,K.height,0,oe,L,null));else if(M.isDataTexture)if(le.length>0){se&&ae&&t.texStorage2D(i.TEXTURE_2D,ze,J,le[0].width,le[0].height);for(let ie=0,Ae=le.length;ie<Ae;ie++)$=le[ie],se?Te&&t.texSubImage2D(i.TEXTURE_2D,ie,0,0,$.width,$.height,oe,L,$.data):t.texImage2D(i.TEXTURE_2D,ie,J,$.width,$.height,0,oe,L,$.data);M.generateMipmaps=!1}else se?(ae&&t.texStorage2D(i.TEXTURE_2D,ze,J,K.width,K.height),Te&&Nt(M,K,oe,L)):t.texImage2D(i.TEXTURE_2D,0,J,K.width,K.height,0,oe,L,K.data);else if(M.isCompressedTexture)if(M.isCompressedArrayTexture){se&&ae&&t.texStorage3D(i.TEXTURE_2D_ARRAY,ze,J,le[0].width,le[0].height,K.depth);for(let ie=0,Ae=le.length;ie<Ae;ie++)if($=le[ie],M.format!==wn)if(oe!==null)if(se){if(Te)if(M.layerUpdates.size>0){const ke=Mc($.width,$.height,M.format,M.type);for(const pe of M.layerUpdates){const et=$.data.subarray(pe*ke/$.data.BYTES_PER_ELEMENT,(pe+1)*ke/$.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ie,0,0,pe,$.width,$.height,1,oe,et)}}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ie,0,0,0,$.width,$.height,K.depth,oe,$.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,ie,J,$.width,$.height,K.depth,0,$.data,0,0);else De("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else se?Te&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,ie,0,0,0,$.width,$.height,K.depth,oe,L,$.data):t.texImage3D(i.TEXTURE_2D_ARRAY,ie,J,$.width,$.height,K.depth,0,oe,L,$.data);M.layerUpdates.size>0&&M.clearLayerUpdates()}else{se&&ae&&t.texStorage2D(i.TEXTURE_2D,ze,J,le[0].width,le[0].height);for(let ie=0,Ae=le.length;ie<Ae;ie++)$=le[ie],M.format!==wn?oe!==null?se?Te&&t.compressedTexSubImage2D(i.TEXTURE_2D,ie,0,0,$.width,$.height,oe,$.data):t.compressedTexImage2D(i.TEXTURE_2D,ie,J,$.width,$.height,0,$.data):De("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):se?Te&&t.texSubImage2D(i.TEXTURE_2D,ie,0,0,$.width,$.height,oe,L,$.data):t.texImage2D(i.TEXTURE_2D,ie,J,$.width,$.height,0,oe,L,$.data)}else if(M.isDataArrayTexture)if(se){if(ae&&t.texStorage3D(i.TEXTURE_2D_ARRAY,ze,J,K.width,K.height,K.depth),Te)if(M.layerUpdates.size>0){const ie=Mc(K.width,K.height,M.format,M.type);for(const Ae of M.layerUpdates){const ke=K.data.subarray(Ae*ie/K.data.BYTES_PER_ELEMENT,(Ae+1)*ie/K.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,Ae,K.width,K.height,1,oe,L,ke)}M.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,K.width,K.height,K.depth,oe,L,K.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,J,K.width,K.height,K.depth,0,oe,L,K.data);else if(M.isData3DTexture)se?(ae&&t.texStorage3D(i.TEXTURE_3D,ze,J,K.width,K.height,K.depth),Te&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,K.width,K.height,K.depth,oe,L,K.data)):t.texImage3D(i.TEXTURE_3D,0,J,K.width,K.height,K.depth,0,oe,L,K.data);else if(M.isFramebufferTexture){if(ae)if(se)t.texStorage2D(i.TEXTURE_2D,ze,J,K.width,K.height);else{let ie=K.width,Ae=K.height;for(let ke=0;ke<ze;ke++)t.texImage2D(i.TEXTURE_2D,ke,J,ie,Ae,0,oe,L,null),ie>>=1,Ae>>=1}}else if(M.isHTMLTexture){if("texElementImage2D"in i){const ie=i.canvas;if(ie.hasAttribute("layoutsubtree")||ie.setAttribute("layoutsubtree","true"),K.parentNode!==ie){ie.appendChild(K),d.add(M),ie.onpaint=Ae=>{const ke=Ae.changedElements;for(const pe of d)ke.includes(pe.image)&&(pe.needsUpdate=!0)},ie.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,K);else{const ke=i.RGBA,pe=i.RGBA,et=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,ke,pe,et,K)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(le.length>0){if(se&&ae){const ie=Ie(le[0]);t.texStorage2D(i.TEXTURE_2D,ze,J,ie.width,ie.height)}for(let ie=0,Ae=le.length;ie<Ae;ie++)$=le[ie],se?Te&&t.texSubImage2D(i.TEXTURE_2D,ie,0,0,oe,L,$):t.texImage2D(i.TEXTURE_2D,ie,J,oe,L,$);M.generateMipmaps=!1}else if(se){if(ae){const ie=Ie(K);t.texStorage2D(i.TEXTURE_2D,ze,J,ie.width,ie.height)}Te&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,oe,L,K)}else t.texImage2D(i.TEXTURE_2D,0,J,oe,L,K);E(M)&&M.mipmapsAutoUpdate===!0&&S(ne),he.__version=re.version,M.onUpdate&&M.onUpdate(M)}R.__version=M.version}function Kt(R,M,z){if(M.image.length!==6)return;const ne=it(R,M),j=M.source;t.bindTexture(i.TEXTURE_CUBE_MAP,R.__webglTexture,i.TEXTURE0+z);const re=n.get(j);if(j.version!==re.__version||ne===!0){t.activeTexture(i.TEXTURE0+z);const he=qe.getPrimaries(qe.workingColorSpace),q=M.colorSpace===ti?null:qe.getPrimaries(M.colorSpace),K=M.colorSpace===ti||he===q?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,M.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),t.pixelStorei(i.UNPACK_ALIGNMENT,M.unpackAlignment),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,K);const oe=M.isCompressedTexture||M.image[0].isCompressedTexture,L=M.image[0]&&M.image[0].isDataTexture,J=[];for(let pe=0;pe<6;pe++)!oe&&!L?J[pe]=x(M.image[pe],!0,s.maxCubemapSize):J[pe]=L?M.image[pe].image:M.image[pe],J[pe]=Pe(M,J[pe]);const $=J[0],le=r.convert(M.format,M.colorSpace),se=r.convert(M.type);let ae=A(M.internalFormat,le,se,M.normalized,M.colorSpace);const Te=M.isVideoTexture!==!0,ze=re.__version===void 0||ne===!0,ie=j.dataReady;let Ae=w(M,$);Qe(i.TEXTURE_CUBE_MAP,M);let ke;if(M.isDepthTexture){if(ae=_(M.format===ri,M.type),ze)if(Te)t.texStorage2D(i.TEXTURE_CUBE_MAP,1,ae,$.width,$.height);else for(let pe=0;pe<6;pe++)t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+pe,0,ae,$.width,$.height,0,le,se,null)}else if(oe){Te&&ze&&t.texStorage2D(i.TEXTURE_CUBE_MAP,Ae,ae,$.width,$.height);for(let pe=0;pe<6;pe++){ke=J[pe].mipmaps;for(let et=0;et<ke.length;et++){const Pt=ke[et];M.format!==wn?le!==null?Te?ie&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+pe,et,0,0,Pt.width,Pt.height,le,Pt.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+pe,et,ae,Pt.width,Pt.height,0,Pt.data):De("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Te?ie&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+pe,et,0,0,Pt.width,Pt.height,le,se,Pt.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+pe,et,ae,Pt.width,Pt.height,0,le,se,Pt.data)}}}else{if(ke=M.mipmaps,Te&&ze){ke.length>0&&Ae++;const pe=Ie(J[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,Ae,ae,pe.width,pe.height)}for(let pe=0;pe<6;pe++)if(L){Te?ie&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+pe,0,0,0,J[pe].width,J[pe].height,le,se,J[pe].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+pe,0,ae,J[pe].width,J[pe].height,0,le,se,J[pe].data);for(let et=0;et<ke.length;et++){const $n=ke[et].image[pe].image;Te?ie&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+pe,et+1,0,0,$n.width,$n.height,le,se,$n.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+pe,et+1,ae,$n.width,$n.height,0,le,se,$n.data)}}else{Te?ie&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+pe,0,0,0,le,se,J[pe]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+pe,0,ae,le,se,J[pe]);for(let et=0;et<ke.length;et++){const Pt=ke[et];Te?ie&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+pe,et+1,0,0,le,se,Pt.image[pe]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+pe,et+1,ae,le,se,Pt.image[pe])}}}E(M)&&M.mipmapsAutoUpdate===!0&&S(i.TEXTURE_CUBE_MAP),re.__version=j.version,M.onUpdate&&M.onUpdate(M)}R.__version=M.version}function ut(R,M,z,ne,j,re){const he=r.convert(z.format,z.colorSpace),q=r.convert(z.type),K=A(z.internalFormat,he,q,z.normalized,z.colorSpace),oe=n.get(M),L=n.get(z);if(L.__renderTarget=M,!oe.__hasExternalTextures){const J=Math.max(1,M.width>>re),$=Math.max(1,M.height>>re);j===i.TEXTURE_3D||j===i.TEXTURE_2D_ARRAY?t.texImage3D(j,re,K,J,$,M.depth,0,he,q,null):t.texImage2D(j,re,K,J,$,0,he,q,null)}t.bindFramebuffer(i.FRAMEBUFFER,R),de(M)?o.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ne,j,L.__webglTexture,0,lt(M)):(j===i.TEXTURE_2D||j>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&j<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,ne,j,L.__webglTexture,re),t.bindFramebuffer(i.FRAMEBUFFER,null)}function Cn(R,M,z){if(i.bindRenderbuffer(i.RENDERBUFFER,R),M.depthBuffer){const ne=M.depthTexture,j=ne&&ne.isDepthTexture?ne.type:null,re=_(M.stencilBuffer,j),he=M.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;de(M)?o.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,lt(M),re,M.width,M.height):z?i.renderbufferStorageMultisample(i.RENDERBUFFER,lt(M),re,M.width,M.height):i.renderbufferStorage(i.RENDERBUFFER,re,M.width,M.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,he,i.RENDERBUFFER,R)}else{const ne=M.textures;for(let j=0;j<ne.length;j++){const re=ne[j],he=r.convert(re.format,re.colorSpace),q=r.convert(re.type),K=A(re.internalFormat,he,q,re.normalized,re.colorSpace);de(M)?o.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,lt(M),K,M.width,M.height):z?i.renderbufferStorageMultisample(i.RENDERBUFFER,lt(M),K,M.width,M.height):i.renderbufferStorage(i.RENDERBUFFER,K,M.width,M.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function Ct(R,M,z){const ne=M.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(i.FRAMEBUFFER,R),!(M.depthTexture&&M.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");const j=n.get(M.depthTexture);j.__renderTarget=M;const re=ne?M.depthTexture.image[0]:M.depthTexture.image;(!j.__webglTexture||re.width!==M.width||re.height!==M.height)&&(re.width=M.width,re.height=M.height,M.depthTexture.needsUpdate=!0),ne?_e(M.depthTexture,0):ge(M.depthTexture,0);const he=j.__webglTexture,q=lt(M),K=ne?i.TEXTURE_CUBE_MAP_POSITIVE_X+z:i.TEXTURE_2D,oe=M.depthTexture.format===ri?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(M.depthTexture.format===oi)de(M)?o.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,oe,K,he,0,q):i.framebufferTexture2D(i.FRAMEBUFFER,oe,K,he,0);else if(M.depthTexture.format===ri)de(M)?o.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,oe,K,he,0,q):i.framebufferTexture2D(i.FRAMEBUFFER,oe,K,he,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function an(R){const M=n.get(R),z=R.isWebGLCubeRenderTarget===!0;if(M.__boundDepthTexture!==R.depthTexture){const ne=R.depthTexture;if(M.__depthDisposeCallback&&M.__depthDisposeCallback(),ne){const j=()=>{delete M.__boundDepthTexture,delete M.__depthDisposeCallback,ne.removeEventListener("dispose",j)};ne.addEventListener("dispose",j),M.__depthDisposeCallback=j}M.__boundDepthTexture=ne}if(R.depthTexture&&!M.__autoAllocateDepthBuffer)if(z)for(let ne=0;ne<6;ne++)Ct(M.__webglFramebuffer[ne],R,ne);else R.texture.mipmaps.length>0?Ct(M.__webglFramebuffer[0],R,0):Ct(M.__webglFramebuffer,R,0);else if(z){M.__webglDepthbuffer=[];for(let ne=0;ne<6;ne++)if(t.bindFramebuffer(i.FRAMEBUFFER,M.__webglFramebuffer[ne]),M.__webglDepthbuffer[ne]===void 0)M.__webglDepthbuffer[ne]=i.createRenderbuffer(),Cn(M.__webglDepthbuffer[ne],R,!1);else{const j=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,re=M.__webglDepthbuffer[ne];i.bindRenderbuffer(i.RENDERBUFFER,re),i.framebufferRenderbuffer(i.FRAMEBUFFER,j,i.RENDERBUFFER,re)}}else if(R.texture.mipmaps.length>0?t.bindFramebuffer(i.FRAMEBUFFER,M.__webglFramebuffer[0]):t.bindFramebuffer(i.FRAMEBUFFER,M.__webglFramebuffer),M.__webglDepthbuffer===void 0)M.__webglDepthbuffer=i.createRenderbuffer(),Cn(M.__webglDepthbuffer,R,!1);else{const j=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,re=M.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,re),i.framebufferRenderbuffer(i.FRAMEBUFFER,j,i.RENDERBUFFER,re)}t.bindFramebuffer(i.FRAMEBUFFER,null)}function on(R,M,z){const ne=n.get(R);M!==void 0&&ut(ne.__webglFramebuffer,R,R.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),z!==void 0&&an(R)}function ln(R){const M=R.texture,z=n.get(R),ne=n.get(M);R.addEventListener("dispose",O),I(R);const j=R.textures,re=R.isWebGLCubeRenderTarget===!0,he=j.length>1;if(he||(ne.__webglTexture===void 0&&(ne.__webglTexture=i.createTexture()),ne.__version=M.version,a.memory.textures++),re){z.__webglFramebuffer=[];for(let q=0;q<6;q++)if(M.mipmaps.length>0){z.__webglFramebuffer[q]=[];for(let K=0;K<M.mipmaps.length;K++)z.__webglFramebuffer[q][K]=i.createFramebuffer()}else z.__webglFramebuffer[q]=i.createFramebuffer()}else{if(M.mipmaps.length>0){z.__webglFramebuffer=[];for(let q=0;q<M.mipmaps.length;q++)z.__webglFramebuffer[q]=i.createFramebuffer()}else z.__webglFramebuffer=i.createFramebuffer();if(he)for(let q=0,K=j.length;q<K;q++){const oe=n.get(j[q]);oe.__webglTexture===void 0&&(oe.__webglTexture=i.createTexture(),a.memory.textures++)}if(R.samples>0&&de(R)===!1){z.__webglMultisampledFramebuffer=i.createFramebuffer(),z.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,z.__webglMultisampledFramebuffer);for(let q=0;q<j.length;q++){const K=j[q];z.__webglColorRenderbuffer[q]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,z.__webglColorRenderbuffer[q]);const oe=r.convert(K.format,K.colorSpace),L=r.convert(K.type),J=A(K.internalFormat,oe,L,K.normalized,K.colorSpace,R.isXRRenderTarget===!0),$=lt(R);i.renderbufferStorageMultisample(i.RENDERBUFFER,$,J,R.width,R.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+q,i.RENDERBUFFER,z.__webglColorRenderbuffer[q])}i.bindRenderbuffer(i.RENDERBUFFER,null),R.depthBuffer&&(z.__webglDepthRenderbuffer=i.createRenderbuffer(),Cn(z.__webglDepthRenderbuffer,R,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(re){t.bindTexture(i.TEXTURE_CUBE_MAP,ne.__webglTexture),Qe(i.TEXTURE_CUBE_MAP,M);for(let q=0;q<6;q++)if(M.mipmaps.length>0)for(let K=0;K<M.mipmaps.length;K++)ut(z.__webglFramebuffer[q][K],R,M,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+q,K);else ut(z.__webglFramebuffer[q],R,M,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+q,0);E(M)?S(i.TEXTURE_CUBE_MAP):M.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),t.unbindTexture()}else if(he){for(let q=0,K=j.length;q<K;q++){const oe=j[q],L=n.get(oe);let J=i.TEXTURE_2D;(R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(J=R.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(J,L.__webglTexture),Qe(J,oe),ut(z.__webglFramebuffer,R,oe,i.COLOR_ATTACHMENT0+q,J,0),E(oe)&&S(J)}t.unbindTexture()}else{let q=i.TEXTURE_2D;if((R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(q=R.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(q,ne.__webglTexture),Qe(q,M),M.mipmaps.length>0)for(let K=0;K<M.mipmaps.length;K++)ut(z.__webglFramebuffer[K],R,M,i.COLOR_ATTACHMENT0,q,K);else ut(z.__webglFramebuffer,R,M,i.COLOR_ATTACHMENT0,q,0);E(M)?S(q):M.mipmaps.length>0&&i.texParameteri(q,i.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),t.unbindTexture()}R.depthBuffer&&an(R)}function F(R){const M=R.textures;for(let z=0,ne=M.length;z<ne;z++){const j=M[z];if(E(j)&&j.mipmapsAutoUpdate===!0){const re=C(R),he=n.get(j).__webglTexture;t.bindTexture(re,he),S(re),t.unbindTexture()}}}const cn=[];function ot(R){if(R.samples>0){if(de(R)===!1){const M=R.textures,z=R.width,ne=R.height;let j=i.COLOR_BUFFER_BIT;const re=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,he=n.get(R),q=M.length>1;if(q)for(let oe=0;oe<M.length;oe++)t.bindFramebuffer(i.FRAMEBUFFER,he.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+oe,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,he.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+oe,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,he.__webglMultisampledFramebuffer),R.texture.mipmaps.length>0?t.bindFramebuffer(i.DRAW_FRAMEBUFFER,he.__webglFramebuffer[0]):t.bindFramebuffer(i.DRAW_FRAMEBUFFER,he.__webglFramebuffer);for(let oe=0;oe<M.length;oe++){if(R.resolveDepthBuffer&&(R.depthBuffer&&(j|=i.DEPTH_BUFFER_BIT),R.stencilBuffer&&R.resolveStencilBuffer&&(j|=i.STENCIL_BUFFER_BIT)),q){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,he.__webglColorRenderbuffer[oe]);const L=n.get(M[oe]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,L,0)}i.blitFramebuffer(0,0,z,ne,0,0,z,ne,j,i.NEAREST),l===!0&&(cn.length=0,cn.push(i.COLOR_ATTACHMENT0+oe),R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&cn.push(re),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,cn))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),q)for(let oe=0;oe<M.length;oe++){t.bindFramebuffer(i.FRAMEBUFFER,he.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+oe,i.RENDERBUFFER,he.__webglColorRenderbuffer[oe]);const L=n.get(M[oe]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,he.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+oe,i.TEXTURE_2D,L,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,he.__webglMultisampledFramebuffer)}else if(R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&l){const M=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[M])}}}function lt(R){return Math.min(s.maxSamples,R.samples)}function de(R){const M=n.get(R);return R.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&M.__useRenderToTexture!==!1}function wt(R){const M=a.render.frame;h.get(R)!==M&&(h.set(R,M),R.update())}function Pe(R,M){const z=R.colorSpace,ne=R.format,j=R.type;return R.isCompressedTexture===!0||R.isVideoTexture===!0||z!==Gr&&z!==ti&&(qe.getTransfer(z)===tt?(ne!==wn||j!==tn)&&De("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):Ke("WebGLTextures: Unsupported texture color space:",z)),M}function Ie(R){return typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement?(c.width=R.naturalWidth||R.width,c.height=R.naturalHeight||R.height):typeof VideoFrame<"u"&&R instanceof VideoFrame?(c.width=R.displayWidth,c.height=R.displayHeight):(c.width=R.width,c.height=R.height),c}this.allocateTextureUnit=Ne,this.resetTextureUnits=Q,this.getTextureUnits=ee,this.setTextureUnits=xe,this.setTexture2D=ge,this.setTexture2DArray=ye,this.setTexture3D=Ce,this.setTextureCube=_e,this.rebindTextures=on,this.setupRenderTarget=ln,this.updateRenderTargetMipmap=F,this.updateMultisampleRenderTarget=ot,this.setupDepthRenderbuffer=an,this.setupFrameBufferTexture=ut,this.useMultisampledRTT=de,this.dispose=G}function w_(i,e){function t(n,s=ti){let r;const a=qe.getTransfer(s);if(n===tn)return i.UNSIGNED_BYTE;if(n===rl)return i.UNSIGNED_SHORT_4_4_4_4;if(n===al)return i.UNSIGNED_SHORT_5_5_5_1;if(n===kh)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===zh)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===Oh)return i.BYTE;if(n===Bh)return i.SHORT;if(n===As)return i.UNSIGNED_SHORT;if(n===sl)return i.INT;if(n===An)return i.UNSIGNED_INT;if(n===pn)return i.FLOAT;if(n===Un)return i.HALF_FLOAT;if(n===Hh)return i.ALPHA;if(n===Gh)return i.RGB;if(n===wn)return i.RGBA;if(n===oi)return i.DEPTH_COMPONENT;if(n===ri)return i.DEPTH_STENCIL;if(n===Vh)return i.RED;if(n===ol)return i.RED_INTEGER;if(n===li)return i.RG;if(n===ll)return i.RG_INTEGER;if(n===cl)return i.RGBA_INTEGER;if(n===Lr||n===Dr||n===Nr||n===Ir)if(a===tt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===Lr)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===Dr)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Nr)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===Ir)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===Lr)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===Dr)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Nr)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===Ir)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===co||n===ho||n===uo||n===fo)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===co)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===ho)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===uo)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===fo)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===po||n===mo||n===go||n===_o||n===vo||n===kr||n===xo)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(n===po||n===mo)return a===tt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===go)return a===tt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===_o)return r.COMPRESSED_R11_EAC;if(n===vo)return r.COMPRESSED_SIGNED_R11_EAC;if(n===kr)return r.COMPRESSED_RG11_EAC;if(n===xo)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===Mo||n===yo||n===bo||n===So||n===wo||n===Eo||n===To||n===Ao||n===Ro||n===Co||n===Po||n===Lo||n===Do||n===No)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(n===Mo)return a===tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===yo)return a===tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===bo)return a===tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===So)return a===tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===wo)return a===tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===Eo)return a===tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===To)return a===tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===Ao)return a===tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===Ro)return a===tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===Co)return a===tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===Po)return a===tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===Lo)return a===tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===Do)return a===tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===No)return a===tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===Io||n===Uo||n===Fo)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(n===Io)return a===tt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===Uo)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===Fo)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===Oo||n===Bo||n===zr||n===ko)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(n===Oo)return r.COMPRESSED_RED_RGTC1_EXT;if(n===Bo)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===zr)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===ko)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===Ji?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:t}}const E_=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,T_=`
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

}`;class A_{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){const n=new su(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){const t=e.cameras[0].viewport,n=new Rn({vertexShader:E_,fragmentShader:T_,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new fe(new Bs(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}}class R_ extends ci{constructor(e,t){super();const n=this;let s=null,r=1,a=null,o="local-floor",l=1,c=null,h=null,d=null,u=null,m=null,g=null;const v=typeof XRWebGLBinding<"u",f=new A_,p={},x=t.getContextAttributes();let E=null,S=null;const C=[],A=[],_=new Ee;let w=null,I=null;const P=new Sn;P.viewport=new _t;const U=new Sn;U.viewport=new _t;const O=[P,U],X=new kf;let D=null,G=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(Z){let ge=C[Z];return ge===void 0&&(ge=new Ma,C[Z]=ge),ge.getTargetRaySpace()},this.getControllerGrip=function(Z){let ge=C[Z];return ge===void 0&&(ge=new Ma,C[Z]=ge),ge.getGripSpace()},this.getHand=function(Z){let ge=C[Z];return ge===void 0&&(ge=new Ma,C[Z]=ge),ge.getHandSpace()};function Y(Z){const ge=A.indexOf(Z.inputSource);if(ge===-1)return;const ye=C[ge];ye!==void 0&&(ye.update(Z.inputSource,Z.frame,c||a),ye.dispatchEvent({type:Z.type,data:Z.inputSource}))}function B(){s.removeEventListener("select",Y),s.removeEventListener("selectstart",Y),s.removeEventListener("selectend",Y),s.removeEventListener("squeeze",Y),s.removeEventListener("squeezestart",Y),s.removeEventListener("squeezeend",Y),s.removeEventListener("end",B),s.removeEventListener("inputsourceschange",te);for(let Z=0;Z<C.length;Z++){const ge=A[Z];ge!==null&&(A[Z]=null,C[Z].disconnect(ge))}D=null,G=null,f.reset();for(const Z in p)delete p[Z];if(e.setRenderTarget(E),m=null,u=null,d=null,s=null,S=null,Ne.stop(),n.isPresenting=!1,e.setPixelRatio(w),e.setSize(_.width,_.height,!1),I!==null){const Z=I.camera;Z.fov=I.fov,Z.zoom=I.zoom,Z.updateProjectionMatrix(),I=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(Z){r=Z,n.isPresenting===!0&&De("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(Z){o=Z,n.isPresenting===!0&&De("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||a},this.setReferenceSpace=function(Z){c=Z},this.getBaseLayer=function(){return u!==null?u:m},this.getBinding=function(){return d===null&&v&&(d=new XRWebGLBinding(s,t)),d},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(Z){if(s=Z,s!==null){if(E=e.getRenderTarget(),s.addEventListener("select",Y),s.addEventListener("selectstart",Y),s.addEventListener("selectend",Y),s.addEventListener("squeeze",Y),s.addEventListener("squeezestart",Y),s.addEventListener("squeezeend",Y),s.addEventListener("end",B),s.addEventListener("inputsourceschange",te),x.xrCompatible!==!0&&await t.makeXRCompatible(),w=e.getPixelRatio(),e.getSize(_),v&&"createProjectionLayer"in XRWebGLBinding.prototype){let ye=null,Ce=null,_e=null;x.depth&&(_e=x.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,ye=x.stencil?ri:oi,Ce=x.stencil?Ji:An);const Oe={colorFormat:t.RGBA8,depthFormat:_e,scaleFactor:r};d=this.getBinding(),u=d.createProjectionLayer(Oe),s.updateRenderState({layers:[u]}),e.setPixelRatio(1),e.setSize(u.textureWidth,u.textureHeight,!1),S=new Tn(u.textureWidth,u.textureHeight,{format:wn,type:tn,depthTexture:new bi(u.textureWidth,u.textureHeight,Ce,void 0,void 0,void 0,void 0,void 0,void 0,ye),stencilBuffer:x.stencil,colorSpace:e.outputColorSpace,samples:x.antialias?4:0,resolveDepthBuffer:u.ignoreDepthValues===!1,resolveStencilBuffer:u.ignoreDepthValues===!1,storeMultisampledDepthBuffer:u.ignoreDepthValues===!1,storeMultisampledStencilBuffer:u.ignoreDepthValues===!1})}else{const ye={antialias:x.antialias,alpha:!0,depth:x.depth,stencil:x.stencil,framebufferScaleFactor:r};m=new XRWebGLLayer(s,t,ye),s.updateRenderState({baseLayer:m}),e.setPixelRatio(1),e.setSize(m.framebufferWidth,m.framebufferHeight,!1),S=new Tn(m.framebufferWidth,m.framebufferHeight,{format:wn,type:tn,colorSpace:e.outputColorSpace,stencilBuffer:x.stencil,resolveDepthBuffer:m.ignoreDepthValues===!1,resolveStencilBuffer:m.ignoreDepthValues===!1,storeMultisampledDepthBuffer:m.ignoreDepthValues===!1,storeMultisampledStencilBuffer:m.ignoreDepthValues===!1})}S.isXRRenderTarget=!0,this.setFoveation(l),c=null,a=await s.requestReferenceSpace(o),Ne.setContext(s),Ne.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return f.getDepthTexture()};function te(Z){for(let ge=0;ge<Z.removed.length;ge++){const ye=Z.removed[ge],Ce=A.indexOf(ye);Ce>=0&&(A[Ce]=null,C[Ce].disconnect(ye))}for(let ge=0;ge<Z.added.length;ge++){const ye=Z.added[ge];let Ce=A.indexOf(ye);if(Ce===-1){for(let Oe=0;Oe<C.length;Oe++)if(Oe>=A.length){A.push(ye),Ce=Oe;break}else if(A[Oe]===null){A[Oe]=ye,Ce=Oe;break}if(Ce===-1)break}const _e=C[Ce];_e&&_e.connect(ye)}}function V(Z,ge){ge===null?Z.matrixWorld.copy(Z.matrix):Z.matrixWorld.multiplyMatrices(ge.matrixWorld,Z.matrix),Z.matrixWorldInverse.copy(Z.matrixWorld).invert()}this.updateCamera=function(Z){if(s===null)return;let ge=Z.near,ye=Z.far;f.texture!==null&&(f.depthNear>0&&(ge=f.depthNear),f.depthFar>0&&(ye=f.depthFar)),X.near=U.near=P.near=ge,X.far=U.far=P.far=ye,(D!==X.near||G!==X.far)&&(s.updateRenderState({depthNear:X.near,depthFar:X.far}),D=X.near,G=X.far),X.layers.mask=Z.layers.mask|6,P.layers.mask=X.layers.mask&-5,U.layers.mask=X.layers.mask&-3;const Ce=Z.parent,_e=X.cameras;V(X,Ce);for(let Oe=0;Oe<_e.length;Oe++)V(_e[Oe],Ce);X.projectionMatrix.copy(P.projectionMatrix),X.projectionMatrixInverse.copy(P.projectionMatrixInverse),I===null&&Z.isPerspectiveCamera&&(I={camera:Z,fov:Z.fov,zoom:Z.zoom}),Q(Z,X,Ce)};function Q(Z,ge,ye){ye===null?Z.matrix.copy(ge.matrixWorld):(Z.matrix.copy(ye.matrixWorld),Z.matrix.invert(),Z.matrix.multiply(ge.matrixWorld)),Z.matrix.decompose(Z.position,Z.quaternion,Z.scale),Z.updateMatrixWorld(!0),Z.projectionMatrix.copy(ge.projectionMatrix),Z.projectionMatrixInverse.copy(ge.projectionMatrixInverse),Z.isPerspectiveCamera&&(Z.fov=zo*2*Math.atan(1/Z.projectionMatrix.elements[5]),Z.zoom=1)}this.getCamera=function(){return X},this.getFoveation=function(){if(!(u===null&&m===null))return l},this.setFoveation=function(Z){l=Z,u!==null&&(u.fixedFoveation=Z),m!==null&&m.fixedFoveation!==void 0&&(m.fixedFoveation=Z)},this.hasDepthSensing=function(){return f.texture!==null},this.getDepthSensingMesh=function(){return f.getMesh(X)},this.getCameraTexture=function(Z){return p[Z]};let ee=null;function xe(Z,ge){if(h=ge.getViewerPose(c||a),g=ge,h!==null){const ye=h.views;m!==null&&(e.setRenderTargetFramebuffer(S,m.framebuffer),e.setRenderTarget(S));let Ce=!1;ye.length!==X.cameras.length&&(X.cameras.length=0,Ce=!0);for(let Le=0;Le<ye.length;Le++){const Qe=ye[Le];let it=null;if(m!==null)it=m.getViewport(Qe);else{const Nt=d.getViewSubImage(u,Qe);it=Nt.viewport,Le===0&&(e.setRenderTargetTextures(S,Nt.colorTexture,Nt.depthStencilTexture),e.setRenderTarget(S))}let We=O[Le];We===void 0&&(We=new Sn,We.layers.enable(Le),We.viewport=new _t,O[Le]=We),We.matrix.fromArray(Qe.transform.matrix),We.matrix.decompose(We.position,We.quaternion,We.scale),We.projectionMatrix.fromArray(Qe.projectionMatrix),We.projectionMatrixInverse.copy(We.projectionMatrix).invert(),We.viewport.set(it.x,it.y,it.width,it.height),Le===0&&(X.matrix.copy(We.matrix),X.matrix.decompose(X.position,X.quaternion,X.scale)),Ce===!0&&X.cameras.push(We)}const _e=s.enabledFeatures;if(_e&&_e.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&v){d=n.getBinding();const Le=d.getDepthInformation(ye[0]);Le&&Le.isValid&&Le.texture&&f.init(Le,s.renderState)}if(_e&&_e.includes("camera-access")&&v){e.state.unbindTexture(),d=n.getBinding();for(let Le=0;Le<ye.length;Le++){const Qe=ye[Le].camera;if(Qe){let it=p[Qe];it||(it=new su,p[Qe]=it);const We=d.getCameraImage(Qe);it.sourceTexture=We}}}}for(let ye=0;ye<C.length;ye++){const Ce=A[ye],_e=C[ye];Ce!==null&&_e!==void 0&&_e.update(Ce,ge,c||a)}ee&&ee(Z,ge),ge.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:ge}),g=null}const Ne=new du;Ne.setAnimationLoop(xe),this.setAnimationLoop=function(Z){ee=Z},this.dispose=function(){}}}const C_=new Ge,bu=new Be;bu.set(-1,0,0,0,1,0,0,0,1);function P_(i,e){function t(f,p){f.matrixAutoUpdate===!0&&f.updateMatrix(),p.value.copy(f.matrix)}function n(f,p){p.color.getRGB(f.fogColor.value,au(i)),p.isFog?(f.fogNear.value=p.near,f.fogFar.value=p.far):p.isFogExp2&&(f.fogDensity.value=p.density)}function s(f,p,x,E,S){p.isNodeMaterial?p.uniformsNeedUpdate=!1:p.isMeshBasicMaterial?r(f,p):p.isMeshLambertMaterial?(r(f,p),p.envMap&&(f.envMapIntensity.value=p.envMapIntensity)):p.isMeshToonMaterial?(r(f,p),d(f,p)):p.isMeshPhongMaterial?(r(f,p),h(f,p),p.envMap&&(f.envMapIntensity.value=p.envMapIntensity)):p.isMeshStandardMaterial?(r(f,p),u(f,p),p.isMeshPhysicalMaterial&&m(f,p,S)):p.isMeshMatcapMaterial?(r(f,p),g(f,p)):p.isMeshDepthMaterial?r(f,p):p.isMeshDistanceMaterial?(r(f,p),v(f,p)):p.isMeshNormalMaterial?r(f,p):p.isLineBasicMaterial?(a(f,p),p.isLineDashedMaterial&&o(f,p)):p.isPointsMaterial?l(f,p,x,E):p.isSpriteMaterial?c(f,p):p.isShadowMaterial?(f.color.value.copy(p.color),f.opacity.value=p.opacity):p.isShaderMaterial&&(p.uniformsNeedUpdate=!1)}function r(f,p){f.opacity.value=p.opacity,p.color&&f.diffuse.value.copy(p.color),p.emissive&&f.emissive.value.copy(p.emissive).multiplyScalar(p.emissiveIntensity),p.map&&(f.map.value=p.map,t(p.map,f.mapTransform)),p.alphaMap&&(f.alphaMap.value=p.alphaMap,t(p.alphaMap,f.alphaMapTransform)),p.bumpMap&&(f.bumpMap.value=p.bumpMap,t(p.bumpMap,f.bumpMapTransform),f.bumpScale.value=p.bumpScale,p.side===Yt&&(f.bumpScale.value*=-1)),p.normalMap&&(f.normalMap.value=p.normalMap,t(p.normalMap,f.normalMapTransform),f.normalScale.value.copy(p.normalScale),p.side===Yt&&f.normalScale.value.negate()),p.displacementMap&&(f.displacementMap.value=p.displacementMap,t(p.displacementMap,f.displacementMapTransform),f.displacementScale.value=p.displacementScale,f.displacementBias.value=p.displacementBias),p.emissiveMap&&(f.emissiveMap.value=p.emissiveMap,t(p.emissiveMap,f.emissiveMapTransform)),p.specularMap&&(f.specularMap.value=p.specularMap,t(p.specularMap,f.specularMapTransform)),p.alphaTest>0&&(f.alphaTest.value=p.alphaTest);const x=e.get(p),E=x.envMap,S=x.envMapRotation;E&&(f.envMap.value=E,f.envMapRotation.value.setFromMatrix4(C_.makeRotationFromEuler(S)).transpose(),E.isCubeTexture&&E.isRenderTargetTexture===!1&&f.envMapRotation.value.premultiply(bu),f.reflectivity.value=p.reflectivity,f.ior.value=p.ior,f.refractionRatio.value=p.refractionRatio),p.lightMap&&(f.lightMap.value=p.lightMap,f.lightMapIntensity.value=p.lightMapIntensity,t(p.lightMap,f.lightMapTransform)),p.aoMap&&(f.aoMap.value=p.aoMap,f.aoMapIntensity.value=p.aoMapIntensity,t(p.aoMap,f.aoMapTransform))}function a(f,p){f.diffuse.value.copy(p.color),f.opacity.value=p.opacity,p.map&&(f.map.value=p.map,t(p.map,f.mapTransform))}function o(f,p){f.dashSize.value=p.dashSize,f.totalSize.value=p.dashSize+p.gapSize,f.scale.value=p.scale}function l(f,p,x,E){f.diffuse.value.copy(p.color),f.opacity.value=p.opacity,f.size.value=p.size*x,f.scale.value=E*.5,p.map&&(f.map.value=p.map,t(p.map,f.uvTransform)),p.alphaMap&&(f.alphaMap.value=p.alphaMap,t(p.alphaMap,f.alphaMapTransform)),p.alphaTest>0&&(f.alphaTest.value=p.alphaTest)}function c(f,p){f.diffuse.value.copy(p.color),f.opacity.value=p.opacity,f.rotation.value=p.rotation,p.map&&(f.map.value=p.map,t(p.map,f.mapTransform)),p.alphaMap&&(f.alphaMap.value=p.alphaMap,t(p.alphaMap,f.alphaMapTransform)),p.alphaTest>0&&(f.alphaTest.value=p.alphaTest)}function h(f,p){f.specular.value.copy(p.specular),f.shininess.value=Math.max(p.shininess,1e-4)}function d(f,p){p.gradientMap&&(f.gradientMap.value=p.gradientMap)}function u(f,p){f.metalness.value=p.metalness,p.metalnessMap&&(f.metalnessMap.value=p.metalnessMap,t(p.metalnessMap,f.metalnessMapTransform)),f.roughness.value=p.roughness,p.roughnessMap&&(f.roughnessMap.value=p.roughnessMap,t(p.roughnessMap,f.roughnessMapTransform)),p.envMap&&(f.envMapIntensity.value=p.envMapIntensity)}function m(f,p,x){f.ior.value=p.ior,p.diffuseRoughness>0&&(f.diffuseRoughness.value=p.diffuseRoughness,p.diffuseRoughnessMap&&(f.diffuseRoughnessMap.value=p.diffuseRoughnessMap,t(p.diffuseRoughnessMap,f.diffuseRoughnessMapTransform))),p.sheen>0&&(f.sheenColor.value.copy(p.sheenColor).multiplyScalar(p.sheen),f.sheenRoughness.value=p.sheenRoughness,p.sheenColorMap&&(f.sheenColorMap.value=p.sheenColorMap,t(p.sheenColorMap,f.sheenColorMapTransform)),p.sheenRoughnessMap&&(f.sheenRoughnessMap.value=p.sheenRoughnessMap,t(p.sheenRoughnessMap,f.sheenRoughnessMapTransform))),p.clearcoat>0&&(f.clearcoat.value=p.clearcoat,f.clearcoatRoughness.value=p.clearcoatRoughness,p.clearcoatMap&&(f.clearcoatMap.value=p.clearcoatMap,t(p.clearcoatMap,f.clearcoatMapTransform)),p.clearcoatRoughnessMap&&(f.clearcoatRoughnessMap.value=p.clearcoatRoughnessMap,t(p.clearcoatRoughnessMap,f.clearcoatRoughnessMapTransform)),p.clearcoatNormalMap&&(f.clearcoatNormalMap.value=p.clearcoatNormalMap,t(p.clearcoatNormalMap,f.clearcoatNormalMapTransform),f.clearcoatNormalScale.value.copy(p.clearcoatNormalScale),p.side===Yt&&f.clearcoatNormalScale.value.negate())),p.dispersion>0&&(f.dispersion.value=p.dispersion),p.retroreflectivity>0&&(f.retroreflectivity.value=p.retroreflectivity),p.iridescence>0&&(f.iridescence.value=p.iridescence,f.iridescenceIOR.value=p.iridescenceIOR,f.iridescenceThicknessMinimum.value=p.iridescenceThicknessMinimum,f.iridescenceThicknessMaximum.value=p.iridescenceThicknessMaximum,p.iridescenceMap&&(f.iridescenceMap.value=p.iridescenceMap,t(p.iridescenceMap,f.iridescenceMapTransform)),p.iridescenceThicknessMap&&(f.iridescenceThicknessMap.value=p.iridescenceThicknessMap,t(p.iridescenceThicknessMap,f.iridescenceThicknessMapTransform))),p.transmission>0&&(f.transmission.value=p.transmission,f.transmissionSamplerMap.value=x.texture,f.transmissionSamplerSize.value.set(x.width,x.height),p.transmissionMap&&(f.transmissionMap.value=p.transmissionMap,t(p.transmissionMap,f.transmissionMapTransform)),f.thickness.value=p.thickness,p.thicknessMap&&(f.thicknessMap.value=p.thicknessMap,t(p.thicknessMap,f.thicknessMapTransform)),f.attenuationDistance.value=p.attenuationDistance,f.attenuationColor.value.copy(p.attenuationColor)),p.anisotropy>0&&(f.anisotropyVector.value.set(p.anisotropy*Math.cos(p.anisotropyRotation),p.anisotropy*Math.sin(p.anisotropyRotation)),p.anisotropyMap&&(f.anisotropyMap.value=p.anisotropyMap,t(p.anisotropyMap,f.anisotropyMapTransform))),f.specularIntensity.value=p.specularIntensity,f.specularColor.value.copy(p.specularColor),p.specularColorMap&&(f.specularColorMap.value=p.specularColorMap,t(p.specularColorMap,f.specularColorMapTransform)),p.specularIntensityMap&&(f.specularIntensityMap.value=p.specularIntensityMap,t(p.specularIntensityMap,f.specularIntensityMapTransform))}function g(f,p){p.matcap&&(f.matcap.value=p.matcap)}function v(f,p){const x=e.get(p).light;f.referencePosition.value.setFromMatrixPosition(x.matrixWorld),f.nearDistance.value=x.shadow.camera.near,f.farDistance.value=x.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function L_(i,e,t,n){let s={},r={};function a(x,E){const S=E.program;n.uniformBlockBinding(x,S,s[x.id])}function o(x,E){let S=s[x.id];S===void 0&&(g(x),S=l(x),s[x.id]=S,x.addEventListener("dispose",f));const C=E.program;n.updateUBOMapping(x,C);const A=e.render.frame;r[x.id]!==A&&(c(x),r[x.id]=A)}function l(x){const E=i.createBuffer(),S=x.__size,C=x.usage;return i.bindBuffer(i.UNIFORM_BUFFER,E),i.bufferData(i.UNIFORM_BUFFER,S,C),i.bindBuffer(i.UNIFORM_BUFFER,null),E}function c(x){const E=s[x.id],S=x.uniforms,C=x.__cache;i.bindBuffer(i.UNIFORM_BUFFER,E);for(let A=0,_=S.length;A<_;A++){const w=S[A];if(Array.isArray(w))for(let I=0,P=w.length;I<P;I++)h(w[I],A,I,C);else h(w,A,0,C)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function h(x,E,S,C){if(u(x,E,S,C)===!0){const A=x.__offset,_=x.value;if(Array.isArray(_)){let w=0;for(let I=0;I<_.length;I++){const P=_[I],U=v(P,!0);d(P,x.__data,w),w+=U.storage/Float32Array.BYTES_PER_ELEMENT}}else d(_,x.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,A,x.__data)}}function d(x,E,S){typeof x=="number"||typeof x=="boolean"?E[S]=x:x.isMatrix3?(E[S]=x.elements[0],E[S+1]=x.elements[1],E[S+2]=x.elements[2],E[S+3]=0,E[S+4]=x.elements[3],E[S+5]=x.elements[4],E[S+6]=x.elements[5],E[S+7]=0,E[S+8]=x.elements[6],E[S+9]=x.elements[7],E[S+10]=x.elements[8],E[S+11]=0):ArrayBuffer.isView(x)?E.set(x.subarray(0,E.length-S),S):x.toArray(E,S)}function u(x,E,S,C){const A=x.value,_=E+"_"+S;if(Array.isArray(A)){C[_]===void 0&&(C[_]=[]);const w=C[_];let I=!1;for(let P=0;P<A.length;P++)m(A[P],w,P)===!0&&(I=!0);return I}return m(A,C,_)}function m(x,E,S){if(E[S]===void 0)return typeof x=="number"||typeof x=="boolean"?E[S]=x:ArrayBuffer.isView(x)?E[S]=x.slice():E[S]=x.clone(),!0;{const C=E[S];if(typeof x=="number"||typeof x=="boolean"){if(C!==x)return E[S]=x,!0}else{if(ArrayBuffer.isView(x))return!0;if(C.equals(x)===!1)return C.copy(x),!0}}return!1}function g(x){const E=x.uniforms;let S=0;const C=16;for(let _=0,w=E.length;_<w;_++){const I=Array.isArray(E[_])?E[_]:[E[_]];for(let P=0,U=I.length;P<U;P++){const O=I[P],X=Array.isArray(O.value)?O.value:[O.value],D=Array.isArray(E[_])||Array.isArray(O.value);let G=S;for(let B=0,te=X.length;B<te;B++){const V=X[B],Q=v(V,D),ee=S%C,xe=ee%Q.boundary,Ne=ee+xe;S+=xe,Ne!==0&&C-Ne<Q.storage&&(S+=C-Ne),B===0&&(G=S),S+=Q.storage}const Y=O.type==="int"?Int32Array:O.type==="uint"?Uint32Array:Float32Array;O.__data=new Y((S-G)/Float32Array.BYTES_PER_ELEMENT),O.__offset=G}}const A=S%C;return A>0&&(S+=C-A),x.__size=S,x.__cache={},this}function v(x,E){const S={boundary:0,storage:0};return typeof x=="number"||typeof x=="boolean"?(S.boundary=4,S.storage=4):x.isVector2?(S.boundary=8,S.storage=8):x.isVector3||x.isColor?(S.boundary=16,S.storage=12):x.isVector4?(S.boundary=16,S.storage=16):x.isMatrix3?(S.boundary=16,S.storage=48):x.isMatrix4?(S.boundary=16,S.storage=64):x.isTexture?De("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(x)?(S.boundary=16,S.storage=x.byteLength):De("WebGLRenderer: Unsupported uniform value type.",x),E===!0&&(S.boundary=16,S.storage=Math.ceil(S.storage/16)*16),S}function f(x){const E=x.target;E.removeEventListener("dispose",f),i.deleteBuffer(s[E.id]),delete s[E.id],delete r[E.id]}function p(){for(const x in s)i.deleteBuffer(s[x]);s={},r={}}return{bind:a,update:o,dispose:p}}const D_=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]);let Ln=null;function N_(){return Ln===null&&(Ln=new Qh(D_,16,16,li,Un),Ln.name="DFG_LUT",Ln.minFilter=qt,Ln.magFilter=qt,Ln.wrapS=Vn,Ln.wrapT=Vn,Ln.generateMipmaps=!1,Ln.needsUpdate=!0),Ln}class I_{constructor(e={}){const{canvas:t=jd(),context:n=null,depth:s=!0,stencil:r=!1,alpha:a=!1,antialias:o=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:d=!1,reversedDepthBuffer:u=!1,outputBufferType:m=tn}=e;this.isWebGLRenderer=!0;let g;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=n.getContextAttributes().alpha}else g=a;const v=m,f=new Set([cl,ll,ol]),p=new Set([tn,An,As,Ji,rl,al]),x=new Uint32Array(4),E=new Int32Array(4),S={textures:[],min:[],max:[],resolution:[]};let C=null,A=null;const _=[],w=[];let I=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=Wn,this.toneMappingExposure=1,this.transmissionResolutionScale=1;const P=this;let U=!1,O=null,X=null,D=null,G=null;this._outputColorSpace=dn;let Y=0,B=0,te=null,V=-1,Q=null;const ee=new _t,xe=new _t;let Ne=null;const Z=new Ue(0);let ge=0,ye=t.width,Ce=t.height,_e=1,Oe=null,xt=null;const Le=new _t(0,0,ye,Ce),Qe=new _t(0,0,ye,Ce);let it=!1;const We=new Cs,Nt=new fl;let St=!1,Kt=!1;const ut=new Ge,Cn=new T,Ct=new _t,an={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0};let on=!1;function ln(){return te===null?_e:1}let F=n;function cn(b,N){return t.getContext(b,N)}let ot,lt,de,wt,Pe,Ie,R,M,z,ne,j,re,he,q,K,oe,L,J,$,le,se,ae,Te;try{const b={alpha:!0,depth:s,stencil:r,antialias:o,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:d};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${nl}`),t.addEventListener("webglcontextlost",Ae,!1),t.addEventListener("webglcontextrestored",ke,!1),t.addEventListener("webglcontextcreationerror",pe,!1),F===null){const N="webgl2";if(F=cn(N,b),F===null)throw cn(N)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}ze()}catch(b){throw t.removeEventListener("webglcontextlost",Ae,!1),t.removeEventListener("webglcontextrestored",ke,!1),t.removeEventListener("webglcontextcreationerror",pe,!1),Ke("WebGLRenderer: "+b.message),b}function ze(){ot=new Og(F),ot.init(),se=new w_(F,ot),lt=new Tg(F,ot,e,se),de=new b_(F,ot),lt.reversedDepthBuffer&&u&&de.buffers.depth.setReversed(!0),X=F.createFramebuffer(),D=F.createFramebuffer(),G=F.createFramebuffer(),wt=new zg(F),Pe=new l_,Ie=new S_(F,ot,de,Pe,lt,se,wt),R=new Fg(P),M=new Gf(F),ae=new wg(F,M),z=new Bg(F,M,wt,ae),ne=new Gg(F,z,M,ae,wt),J=new Hg(F,lt,Ie),K=new Ag(Pe),j=new o_(P,R,ot,lt,ae,K),re=new P_(P,Pe),he=new h_,q=new g_(ot),L=new Sg(P,R,de,ne,g,l),oe=new y_(P,ne,lt),Te=new L_(F,wt,lt,de),$=new Eg(F,ot,wt),le=new kg(F,ot,wt),wt.programs=j.programs,P.capabilities=lt,P.extensions=ot,P.properties=Pe,P.renderLists=he,P.shadowMap=oe,P.state=de,P.info=wt}v!==tn&&(I=new Wg(v,t.width,t.height,o,s,r));const ie=new R_(P,F);this.xr=ie,this.getContext=function(){return F},this.getContextAttributes=function(){return F.getContextAttributes()},this.forceContextLoss=function(){const b=ot.get("WEBGL_lose_context");b&&b.loseContext()},this.forceContextRestore=function(){const b=ot.get("WEBGL_lose_context");b&&b.restoreContext()},this.getPixelRatio=function(){return _e},this.setPixelRatio=function(b){b!==void 0&&(_e=b,this.setSize(ye,Ce,!1))},this.getSize=function(b){return b.set(ye,Ce)},this.setSize=function(b,N,W=!0){if(ie.isPresenting){De("WebGLRenderer: Can't change size while VR device is presenting.");return}ye=b,Ce=N,t.width=Math.floor(b*_e),t.height=Math.floor(N*_e),W===!0&&(t.style.width=b+"px",t.style.height=N+"px"),I!==null&&I.setSize(t.width,t.height),this.setViewport(0,0,b,N)},this.getDrawingBufferSize=function(b){return b.set(ye*_e,Ce*_e).floor()},this.setDrawingBufferSize=function(b,N,W){ye=b,Ce=N,_e=W,t.width=Math.floor(b*W),t.height=Math.floor(N*W),this.setViewport(0,0,b,N)},this.setEffects=function(b){if(v===tn){Ke("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(b){for(let N=0;N<b.length;N++)if(b[N].isOutputPass===!0){De("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}I.setEffects(b||[])},this.getCurrentViewport=function(b){return b.copy(ee)},this.getViewport=function(b){return b.copy(Le)},this.setViewport=function(b,N,W,k){b.isVector4?Le.set(b.x,b.y,b.z,b.w):Le.set(b,N,W,k),de.viewport(ee.copy(Le).multiplyScalar(ln()).round())},this.getScissor=function(b){return b.copy(Qe)},this.setScissor=function(b,N,W,k){b.isVector4?Qe.set(b.x,b.y,b.z,b.w):Qe.set(b,N,W,k),de.scissor(xe.copy(Qe).multiplyScalar(ln()).round())},this.getScissorTest=function(){return it},this.setScissorTest=function(b){de.setScissorTest(it=b)},this.setOpaqueSort=function(b){Oe=b},this.setTransparentSort=function(b){xt=b},this.getClearColor=function(b){return b.copy(L.getClearColor())},this.setClearColor=function(){L.setClearColor(...arguments)},this.getClearAlpha=function(){return L.getClearAlpha()},this.setClearAlpha=function(){L.setClearAlpha(...arguments)},this.clear=function(b=!0,N=!0,W=!0){let k=0;if(b){let H=!1;if(te!==null){const ue=te.texture.format;H=f.has(ue)}if(H){const ue=te.texture.type,Me=p.has(ue),ce=L.getClearColor(),ve=L.getClearAlpha(),we=ce.r,Fe=ce.g,Xe=ce.b;Me?(x[0]=we,x[1]=Fe,x[2]=Xe,x[3]=ve,F.clearBufferuiv(F.COLOR,0,x)):(E[0]=we,E[1]=Fe,E[2]=Xe,E[3]=ve,F.clearBufferiv(F.COLOR,0,E))}else k|=F.COLOR_BUFFER_BIT}N&&(k|=F.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),W&&(k|=F.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),k!==0&&F.clear(k)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(b){b.setRenderer(this),O=b},this.dispose=function(){t.removeEventListener("webglcontextlost",Ae,!1),t.removeEventListener("webglcontextrestored",ke,!1),t.removeEventListener("webglcontextcreationerror",pe,!1),L.dispose(),he.dispose(),q.dispose(),Ie.dispose(),Pe.dispose(),R.dispose(),ne.dispose(),z.dispose(),ae.dispose(),Te.dispose(),j.dispose(),ie.dispose(),ie.removeEventListener("sessionstart",Rl),ie.removeEventListener("sessionend",Cl),ui.stop()};function Ae(b){b.preventDefault(),Vl("WebGLRenderer: Context Lost."),U=!0}function ke(){Vl("WebGLRenderer: Context Restored."),U=!1;const b=wt.autoReset,N=oe.enabled,W=oe.autoUpdate,k=oe.needsUpdate,H=oe.type;ze(),wt.autoReset=b,oe.enabled=N,oe.autoUpdate=W,oe.needsUpdate=k,oe.type=H}function pe(b){Ke("WebGLRenderer: A WebGL context could not be created. Reason: ",b.statusMessage)}function et(b){const N=b.target;N.removeEventListener("dispose",et),Pt(N)}function Pt(b){$n(b),Pe.remove(b)}function $n(b){const N=Pe.get(b).programs;N!==void 0&&(N.forEach(function(W){j.releaseProgram(W)}),b.isShaderMaterial&&j.releaseShaderCache(b))}this.renderBufferDirect=function(b,N,W,k,H,ue){N===null&&(N=an);const Me=H.isMesh&&H.matrixWorld.determinantAffine()<0,ce=cd(b,N,W,k,H);de.setMaterial(k,Me);let ve=W.index,we=1;if(k.wireframe===!0){if(ve=z.getWireframeAttribute(W),ve===void 0)return;we=2}const Fe=W.drawRange,Xe=W.attributes.position;let be=Fe.start*we,$e=(Fe.start+Fe.count)*we;ue!==null&&(be=Math.max(be,ue.start*we),$e=Math.min($e,(ue.start+ue.count)*we)),ve!==null?(be=Math.max(be,0),$e=Math.min($e,ve.count)):Xe!=null&&(be=Math.max(be,0),$e=Math.min($e,Xe.count));const Mt=$e-be;if(Mt<0||Mt===1/0)return;ae.setup(H,k,ce,W,ve);let at,st=$;if(ve!==null&&(at=M.get(ve),st=le,st.setIndex(at)),H.isMesh)k.wireframe===!0?(de.setLineWidth(k.wireframeLinewidth*ln()),st.setMode(F.LINES)):st.setMode(F.TRIANGLES);else if(H.isLine){let kt=k.linewidth;kt===void 0&&(kt=1),de.setLineWidth(kt*ln()),H.isLineSegments?st.setMode(F.LINES):H.isLineLoop?st.setMode(F.LINE_LOOP):st.setMode(F.LINE_STRIP)}else H.isPoints?st.setMode(F.POINTS):H.isSprite&&st.setMode(F.TRIANGLES);if(H.isBatchedMesh)if(ot.get("WEBGL_multi_draw"))st.renderMultiDraw(H._multiDrawStarts,H._multiDrawCounts,H._multiDrawCount);else{const kt=H._multiDrawStarts,Se=H._multiDrawCounts,Xt=H._multiDrawCount,Je=ve?M.get(ve).bytesPerElement:1,di=Pe.get(k).currentProgram.getUniforms();for(let zt=0;zt<Xt;zt++)di.setValue(F,"_gl_DrawID",zt),st.render(kt[zt]/Je,Se[zt])}else if(H.isInstancedMesh)st.renderInstances(be,Mt,H.count);else if(W.isInstancedBufferGeometry){const kt=W._maxInstanceCount!==void 0?W._maxInstanceCount:1/0,Se=Math.min(W.instanceCount,kt);st.renderInstances(be,Mt,Se)}else st.render(be,Mt)};function Al(b,N,W,k){O!==null&&b.isNodeMaterial&&O.setObject(k,b),St===!0&&K.setState(b,W,!1),b.transparent===!0&&b.side===Ft&&b.forceSinglePass===!1?(b.side=Yt,b.needsUpdate=!0,ls(b,N,k),b.side=yi,b.needsUpdate=!0,ls(b,N,k),b.side=Ft):ls(b,N,k)}this.compile=function(b,N,W=null){W===null&&(W=b),O!==null&&O.renderStart(b,N,W),A=q.get(W),A.init(N),w.push(A),W.traverseVisible(function(H){H.isLight&&H.layers.test(N.layers)&&(A.pushLight(H),H.castShadow&&A.pushShadow(H))}),b!==W&&b.traverseVisible(function(H){H.isLight&&H.layers.test(N.layers)&&(A.pushLight(H),H.castShadow&&A.pushShadow(H))}),A.setupLights(),O!==null&&O.updateLights(A.state.lightsArray),Kt=this.localClippingEnabled,St=K.init(this.clippingPlanes,Kt),St===!0&&K.setGlobalState(this.clippingPlanes,N),O!==null&&oe.render(A.state.shadowsArray,W,N);const k=new Set;return b.traverse(function(H){if(!(H.isMesh||H.isPoints||H.isLine||H.isSprite))return;const ue=H.material;if(ue)if(Array.isArray(ue))for(let Me=0;Me<ue.length;Me++){const ce=ue[Me];Al(ce,W,N,H),k.add(ce)}else Al(ue,W,N,H),k.add(ue)}),A=w.pop(),O!==null&&O.renderEnd(),k},this.compileAsync=function(b,N,W=null){const k=this.compile(b,N,W);return new Promise(H=>{function ue(){if(k.forEach(function(Me){const ve=Pe.get(Me).currentProgram;(ve===void 0||ve.isReady())&&k.delete(Me)}),k.size===0){H(b);return}setTimeout(ue,10)}ot.get("KHR_parallel_shader_compile")!==null?ue():setTimeout(ue,10)})};let oa=null;function od(b){oa&&oa(b)}function Rl(){ui.stop()}function Cl(){ui.start()}const ui=new du;ui.setAnimationLoop(od),typeof self<"u"&&ui.setContext(self),this.setAnimationLoop=function(b){oa=b,ie.setAnimationLoop(b),b===null?ui.stop():ui.start()},ie.addEventListener("sessionstart",Rl),ie.addEventListener("sessionend",Cl),this.render=function(b,N){if(N!==void 0&&N.isCamera!==!0){Ke("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(U===!0)return;O!==null&&O.renderStart(b,N);const W=ie.enabled===!0&&ie.isPresenting===!0,k=I!==null&&(te===null||W)&&I.begin(P,te);if(b.matrixWorldAutoUpdate===!0&&b.updateMatrixWorld(),N.parent===null&&N.matrixWorldAutoUpdate===!0&&N.updateMatrixWorld(),ie.enabled===!0&&ie.isPresenting===!0&&(I===null||I.isCompositing()===!1)&&(ie.cameraAutoUpdate===!0&&ie.updateCamera(N),N=ie.getCamera()),b.isScene===!0&&b.onBeforeRender(P,b,N,te),A=q.get(b,w.length),A.init(N),A.state.textureUnits=Ie.getTextureUnits(),w.push(A),ut.multiplyMatrices(N.projectionMatrix,N.matrixWorldInverse),N.isArrayCamera?Nt.setFromArrayCamera(N):We.setFromProjectionMatrix(ut,En,N.reversedDepth),Kt=this.localClippingEnabled,St=K.init(this.clippingPlanes,Kt),C=he.get(b,_.length),C.init(),_.push(C),this.info.render.frame++,ie.enabled===!0&&ie.isPresenting===!0){const Me=P.xr.getDepthSensingMesh();Me!==null&&la(Me,N,-1/0,P.sortObjects)}la(b,N,0,P.sortObjects),C.finish(),O!==null&&O.updateLights(A.state.lightsArray),P.sortObjects===!0&&C.sort(Oe,xt),on=ie.enabled===!1||ie.isPresenting===!1||ie.hasDepthSensing()===!1,on&&L.addToRenderList(C,b),this.info.autoReset===!0&&this.info.reset(),St===!0&&K.beginShadows();const H=A.state.shadowsArray;if(oe.render(H,b,N),St===!0&&K.endShadows(),(k&&I.hasRenderPass())===!1){const Me=C.opaque,ce=C.transmissive;if(A.setupLights(),N.isArrayCamera){const ve=N.cameras;if(ce.length>0)for(let we=0,Fe=ve.length;we<Fe;we++){const Xe=ve[we];Ll(Me,ce,b,Xe)}on&&L.render(b);for(let we=0,Fe=ve.length;we<Fe;we++){const Xe=ve[we];Pl(C,b,Xe,Xe.viewport)}}else ce.length>0&&Ll(Me,ce,b,N),on&&L.render(b),Pl(C,b,N)}te!==null&&B===0&&(Ie.updateMultisampleRenderTarget(te),Ie.updateRenderTargetMipmap(te)),k&&I.end(P),b.isScene===!0&&b.onAfterRender(P,b,N),ae.resetDefaultState(),V=-1,Q=null,w.pop(),w.length>0?(A=w[w.length-1],Ie.setTextureUnits(A.state.textureUnits),St===!0&&K.setGlobalState(P.clippingPlanes,A.state.camera)):A=null,_.pop(),_.length>0?C=_[_.length-1]:C=null,O!==null&&O.renderEnd()};function la(b,N,W,k){if(b.visible===!1)return;if(b.layers.test(N.layers)){if(b.isGroup)W=b.renderOrder;else if(b.isLOD)b.autoUpdate===!0&&b.update(N);else if(b.isLight)A.pushLight(b),b.castShadow&&A.pushShadow(b);else if(b.isSprite){const Me=N.isArrayCamera?Nt:We;if(!b.frustumCulled||b.intersectsFrustum(Me)){k&&Ct.setFromMatrixPosition(b.matrixWorld).applyMatrix4(ut);const ce=ne.update(b),ve=b.material;ve.visible&&C.push(b,ce,ve,W,Ct.z,null,N)}}else if(b.isMesh||b.isLine||b.isPoints){const Me=N.isArrayCamera?Nt:We;if(!b.frustumCulled||b.intersectsFrustum(Me)){const ce=ne.update(b),ve=b.material;if(k&&(b.boundingSphere!==void 0?(b.boundingSphere===null&&b.computeBoundingSphere(),Ct.copy(b.boundingSphere.center)):(ce.boundingSphere===null&&ce.computeBoundingSphere(),Ct.copy(ce.boundingSphere.center)),Ct.applyMatrix4(b.matrixWorld).applyMatrix4(ut)),Array.isArray(ve)){const we=ce.groups;for(let Fe=0,Xe=we.length;Fe<Xe;Fe++){const be=we[Fe],$e=ve[be.materialIndex];$e&&$e.visible&&C.push(b,ce,$e,W,Ct.z,be,N)}}else ve.visible&&C.push(b,ce,ve,W,Ct.z,null,N)}}}const ue=b.children;for(let Me=0,ce=ue.length;Me<ce;Me++)la(ue[Me],N,W,k)}function Pl(b,N,W,k){const{opaque:H,transmissive:ue,transparent:Me}=b;A.setupLightsView(W),St===!0&&K.setGlobalState(P.clippingPlanes,W),k&&de.viewport(ee.copy(k)),H.length>0&&Gs(H,N,W),ue.length>0&&Gs(ue,N,W),Me.length>0&&Gs(Me,N,W),de.buffers.depth.setTest(!0),de.buffers.depth.setMask(!0),de.buffers.color.setMask(!0),de.setPolygonOffset(!1)}function Ll(b,N,W,k){if((W.isScene===!0?W.overrideMaterial:null)!==null)return;if(A.state.transmissionRenderTarget[k.id]===void 0){const be=ot.has("EXT_color_buffer_half_float")||ot.has("EXT_color_buffer_float");A.state.transmissionRenderTarget[k.id]=new Tn(1,1,{generateMipmaps:!0,type:be?Un:tn,minFilter:si,samples:Math.max(4,lt.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:qe.workingColorSpace})}const ue=A.state.transmissionRenderTarget[k.id],Me=k.viewport||ee;ue.setSize(Me.z*P.transmissionResolutionScale,Me.w*P.transmissionResolutionScale);const ce=P.getRenderTarget(),ve=P.getActiveCubeFace(),we=P.getActiveMipmapLevel();P.setRenderTarget(ue),P.getClearColor(Z),ge=P.getClearAlpha(),ge<1&&P.setClearColor(16777215,.5),P.clear(),on&&L.render(W);const Fe=P.toneMapping;P.toneMapping=Wn;const Xe=k.viewport;if(k.viewport!==void 0&&(k.viewport=void 0),A.setupLightsView(k),St===!0&&K.setGlobalState(P.clippingPlanes,k),Gs(b,W,k),Ie.updateMultisampleRenderTarget(ue),Ie.updateRenderTargetMipmap(ue),ot.has("WEBGL_multisampled_render_to_texture")===!1){let be=!1;for(let $e=0,Mt=N.length;$e<Mt;$e++){const at=N[$e],{object:st,geometry:kt,material:Se,group:Xt}=at;if(Se.side===Ft&&st.layers.test(k.layers)){const Je=Se.side;Se.side=Yt,Se.needsUpdate=!0,Dl(st,W,k,kt,Se,Xt),Se.side=Je,Se.needsUpdate=!0,be=!0}}be===!0&&(Ie.updateMultisampleRenderTarget(ue),Ie.updateRenderTargetMipmap(ue))}P.setRenderTarget(ce,ve,we),P.setClearColor(Z,ge),Xe!==void 0&&(k.viewport=Xe),P.toneMapping=Fe}function Gs(b,N,W){const k=N.isScene===!0?N.overrideMaterial:null;for(let H=0,ue=b.length;H<ue;H++){const Me=b[H],{object:ce,geometry:ve,group:we}=Me;let Fe=Me.material;Fe.allowOverride===!0&&k!==null&&(Fe=k),ce.layers.test(W.layers)&&Dl(ce,N,W,ve,Fe,we)}}function Dl(b,N,W,k,H,ue){O!==null&&H.isNodeMaterial&&O.setObject(b,H),b.onBeforeRender(P,N,W,k,H,ue),b.modelViewMatrix.multiplyMatrices(W.matrixWorldInverse,b.matrixWorld),b.normalMatrix.getNormalMatrix(b.modelViewMatrix),H.onBeforeRender(P,N,W,k,b,ue),H.transparent===!0&&H.side===Ft&&H.forceSinglePass===!1?(H.side=Yt,H.needsUpdate=!0,P.renderBufferDirect(W,N,k,H,b,ue),H.side=yi,H.needsUpdate=!0,P.renderBufferDirect(W,N,k,H,b,ue),H.side=Ft):P.renderBufferDirect(W,N,k,H,b,ue),b.onAfterRender(P,N,W,k,H,ue)}function Nl(b){let N=0;for(const W of b)W.texture!==null&&N++;return N}function ls(b,N,W){N.isScene!==!0&&(N=an);const k=Pe.get(b),H=A.state.lights,ue=A.state.shadowsArray,Me=H.state.version,ce=j.getParameters(b,H.state,ue,N,W,A.state.lightProbeGridArray),ve=j.getProgramCacheKey(ce);let we=k.programs;k.environment=b.isMeshStandardMaterial||b.isMeshLambertMaterial||b.isMeshPhongMaterial?N.environment:null,k.fog=N.fog;const Fe=b.isMeshStandardMaterial||b.isMeshLambertMaterial&&!b.envMap||b.isMeshPhongMaterial&&!b.envMap;k.envMap=R.get(b.envMap||k.environment,Fe),k.envMapRotation=k.environment!==null&&b.envMap===null?N.environmentRotation:b.envMapRotation,we===void 0&&(b.addEventListener("dispose",et),we=new Map,k.programs=we,k.programVariants=new Map);let Xe=we.get(ve);if(Xe!==void 0){if(k.currentProgram===Xe&&k.lightsStateVersion===Me)return Ul(b,ce),Xe}else ce.uniforms=j.getUniforms(b),O!==null&&b.isNodeMaterial&&O.build(b,W,ce),b.onBeforeCompile(ce,P),Xe=j.acquireProgram(ce,ve),we.set(ve,Xe),k.uniforms=ce.uniforms;const be=k.uniforms;return(!b.isShaderMaterial&&!b.isRawShaderMaterial||b.clipping===!0)&&(be.clippingPlanes=K.uniform),Ul(b,ce),k.needsLights=ud(b),k.lightsStateVersion=Me,k.needsLights&&(be.ambientLightColor.value=H.state.ambient,be.lightProbe.value=H.state.probe,be.sunLights.value=H.state.sun,be.sunLightShadows.value=H.state.sunShadow,be.directionalLights.value=H.state.directional,be.directionalLightShadows.value=H.state.directionalShadow,be.spotLights.value=H.state.spot,be.spotLightShadows.value=H.state.spotShadow,be.rectAreaLights.value=H.state.rectArea,be.ltc_1.value=H.state.rectAreaLTC1,be.ltc_2.value=H.state.rectAreaLTC2,be.pointLights.value=H.state.point,be.pointLightShadows.value=H.state.pointShadow,be.hemisphereLights.value=H.state.hemi,be.sunShadowMatrix.value=H.state.sunShadowMatrix,be.sunShadowCascade.value=H.state.sunShadowCascade,be.directionalShadowMatrix.value=H.state.directionalShadowMatrix,be.spotLightMatrix.value=H.state.spotLightMatrix,be.spotLightMap.value=H.state.spotLightMap,be.pointShadowMatrix.value=H.state.pointShadowMatrix),k.numLightProbeGrids=Nl(A.state.lightProbeGridArray),k.currentProgram=Xe,k.uniformsList=null,Xe}function ld(b,N,W,k,H){const ue=Pe.get(b),Me=ue.currentProgram.id+","+k+","+H;let ce=ue.programVariants.get(Me);return ce===void 0?(ce=ls(b,N,W),ue.programVariants.set(Me,ce)):(ue.currentProgram=ce,ue.uniformsList=null,ue.outputColorSpace=k,ue.toneMapping=H),ce}function Il(b){if(b.uniformsList===null){const N=b.currentProgram.getUniforms();b.uniformsList=Fr.seqWithValue(N.seq,b.uniforms)}return b.uniformsList}function Ul(b,N){const W=Pe.get(b);W.outputColorSpace=N.outputColorSpace,W.batching=N.batching,W.batchingColor=N.batchingColor,W.instancing=N.instancing,W.instancingColor=N.instancingColor,W.instancingMorph=N.instancingMorph,W.skinning=N.skinning,W.morphTargets=N.morphTargets,W.morphNormals=N.morphNormals,W.morphColors=N.morphColors,W.morphTargetsCount=N.morphTargetsCount,W.numClippingPlanes=N.numClippingPlanes,W.numIntersection=N.numClipIntersection,W.vertexAlphas=N.vertexAlphas,W.vertexTangents=N.vertexTangents,W.toneMapping=N.toneMapping}function cd(b,N,W,k,H){N.isScene!==!0&&(N=an),Ie.resetTextureUnits();const ue=N.fog,Me=k.isMeshStandardMaterial||k.isMeshLambertMaterial||k.isMeshPhongMaterial?N.environment:null,ce=te===null?P.outputColorSpace:te.isXRRenderTarget===!0?te.texture.colorSpace:qe.workingColorSpace,ve=k.isMeshStandardMaterial||k.isMeshLambertMaterial&&!k.envMap||k.isMeshPhongMaterial&&!k.envMap,we=R.get(k.envMap||Me,ve),Fe=k.vertexColors===!0&&!!W.attributes.color&&W.attributes.color.itemSize===4,Xe=!!W.attributes.tangent&&(!!k.normalMap||k.anisotropy>0),be=!!W.morphAttributes.position,$e=!!W.morphAttributes.normal,Mt=!!W.morphAttributes.color;let at=Wn;k.toneMapped&&(te===null||te.isXRRenderTarget===!0)&&(at=P.toneMapping);const st=W.morphAttributes.position||W.morphAttributes.normal||W.morphAttributes.color,kt=st!==void 0?st.length:0,Se=Pe.get(k),Xt=A.state.lights;if(St===!0&&(Kt===!0||b!==Q)){const dt=b===Q&&k.id===V;K.setState(k,b,dt)}let Je=!1,di=!1;k.version===Se.__version?Se.needsLights&&Se.lightsStateVersion!==Xt.state.version||H.isBatchedMesh&&Se.batching===!1||!H.isBatchedMesh&&Se.batching===!0||H.isBatchedMesh&&Se.batchingColor===!0&&H._colorsTexture===null||H.isBatchedMesh&&Se.batchingColor===!1&&H._colorsTexture!==null||H.isInstancedMesh&&Se.instancing===!1||!H.isInstancedMesh&&Se.instancing===!0||H.isSkinnedMesh&&Se.skinning===!1||!H.isSkinnedMesh&&Se.skinning===!0||H.isInstancedMesh&&Se.instancingColor===!0&&H.instanceColor===null||H.isInstancedMesh&&Se.instancingColor===!1&&H.instanceColor!==null||H.isInstancedMesh&&Se.instancingMorph===!0&&H.morphTexture===null||H.isInstancedMesh&&Se.instancingMorph===!1&&H.morphTexture!==null||Se.envMap!==we||k.fog===!0&&Se.fog!==ue||Se.numClippingPlanes!==void 0&&(Se.numClippingPlanes!==K.numPlanes||Se.numIntersection!==K.numIntersection)||Se.vertexAlphas!==Fe||Se.vertexTangents!==Xe||Se.morphTargets!==be||Se.morphNormals!==$e||Se.morphColors!==Mt||Se.morphTargetsCount!==kt||Se.numLightProbeGrids!==Nl(A.state.lightProbeGridArray)?Je=!0:(Se.outputColorSpace!==ce||Se.toneMapping!==at)&&(di=!0):(Je=!0,Se.__version=k.version);let zt=Se.currentProgram;(Je===!0||di===!0)&&(zt=di===!0?ld(k,N,H,ce,at):ls(k,N,H),O&&k.isNodeMaterial&&O.onUpdateProgram(k,zt,Se));let Vs=!1,qn=!1,fi=!1;const Ze=zt.getUniforms(),It=Se.uniforms;if(de.useProgram(zt.program)&&(Vs=!0,qn=!0,fi=!0),k.id!==V&&(V=k.id,qn=!0),Vs||Q!==b){de.buffers.depth.getReversed()&&b.reversedDepth!==!0&&(b._reversedDepth=!0,b.updateProjectionMatrix()),Ze.setValue(F,"projectionMatrix",b.projectionMatrix),Ze.setValue(F,"viewMatrix",b.matrixWorldInverse);const Lt=Ze.map.cameraPosition;Lt!==void 0&&Lt.setValue(F,Cn.setFromMatrixPosition(b.matrixWorld)),lt.logarithmicDepthBuffer&&Ze.setValue(F,"logDepthBufFC",2/(Math.log(b.far+1)/Math.LN2)),(k.isMeshPhongMaterial||k.isMeshToonMaterial||k.isMeshLambertMaterial||k.isMeshBasicMaterial||k.isMeshStandardMaterial||k.isShaderMaterial)&&Ze.setValue(F,"isOrthographic",b.isOrthographicCamera===!0),Q!==b&&(Q=b,qn=!0,fi=!0)}if(Se.needsLights&&(Xt.state.sunShadowMap.length>0&&Ze.setValue(F,"sunShadowMap",Xt.state.sunShadowMap,Ie),Xt.state.directionalShadowMap.length>0&&Ze.setValue(F,"directionalShadowMap",Xt.state.directionalShadowMap,Ie),Xt.state.spotShadowMap.length>0&&Ze.setValue(F,"spotShadowMap",Xt.state.spotShadowMap,Ie),Xt.state.pointShadowMap.length>0&&Ze.setValue(F,"pointShadowMap",Xt.state.pointShadowMap,Ie)),H.isSkinnedMesh){Ze.setOptional(F,H,"bindMatrix"),Ze.setOptional(F,H,"bindMatrixInverse");const dt=H.skeleton;dt&&(dt.boneTexture===null&&dt.computeBoneTexture(),Ze.setValue(F,"boneTexture",dt.boneTexture,Ie))}H.isBatchedMesh&&(Ze.setOptional(F,H,"batchingTexture"),Ze.setValue(F,"batchingTexture",H._matricesTexture,Ie),Ze.setOptional(F,H,"batchingIdTexture"),Ze.setValue(F,"batchingIdTexture",H._indirectTexture,Ie),Ze.setOptional(F,H,"batchingColorTexture"),H._colorsTexture!==null&&Ze.setValue(F,"batchingColorTexture",H._colorsTexture,Ie));const vn=W.morphAttributes;if((vn.position!==void 0||vn.normal!==void 0||vn.color!==void 0)&&J.update(H,W,zt),(qn||Se.receiveShadow!==H.receiveShadow)&&(Se.receiveShadow=H.receiveShadow,Ze.setValue(F,"receiveShadow",H.receiveShadow)),(k.isMeshStandardMaterial||k.isMeshLambertMaterial||k.isMeshPhongMaterial)&&k.envMap===null&&N.environment!==null&&(It.envMapIntensity.value=N.environmentIntensity),It.dfgLUT!==void 0&&(It.dfgLUT.value=N_()),qn){if(Ze.setValue(F,"toneMappingExposure",P.toneMappingExposure),Se.needsLights&&hd(It,fi),ue&&k.fog===!0&&re.refreshFogUniforms(It,ue),re.refreshMaterialUniforms(It,k,_e,Ce,A.state.transmissionRenderTarget[b.id]),Se.needsLights&&Se.numLightProbeGrids>0){const dt=S;let Lt=0;for(const On of A.state.lightProbeGridArray)On.texture!==null&&(dt.textures[Lt]=On.texture,dt.min[Lt]=On.boundingBox.min,dt.max[Lt]=On.boundingBox.max,dt.resolution[Lt]=On.resolution,Lt++);for(const On in dt)dt[On].length=Lt;It.probesSH.value=dt.textures,It.probesMin.value=dt.min,It.probesMax.value=dt.max,It.probesResolution.value=dt.resolution}Fr.upload(F,Il(Se),It,Ie)}if(k.isShaderMaterial&&k.uniformsNeedUpdate===!0&&(Fr.upload(F,Il(Se),It,Ie),k.uniformsNeedUpdate=!1),k.isSpriteMaterial&&Ze.setValue(F,"center",H.center),Ze.setValue(F,"modelViewMatrix",H.modelViewMatrix),Ze.setValue(F,"normalMatrix",H.normalMatrix),Ze.setValue(F,"modelMatrix",H.matrixWorld),k.uniformsGroups!==void 0){const dt=k.uniformsGroups;for(let Lt=0,On=dt.length;Lt<On;Lt++){const Ol=dt[Lt];Te.update(Ol,zt),Te.bind(Ol,zt)}}return zt}function hd(b,N){b.ambientLightColor.needsUpdate=N,b.lightProbe.needsUpdate=N,b.sunLights.needsUpdate=N,b.sunLightShadows.needsUpdate=N,b.directionalLights.needsUpdate=N,b.directionalLightShadows.needsUpdate=N,b.pointLights.needsUpdate=N,b.pointLightShadows.needsUpdate=N,b.spotLights.needsUpdate=N,b.spotLightShadows.needsUpdate=N,b.rectAreaLights.needsUpdate=N,b.hemisphereLights.needsUpdate=N}function ud(b){return b.isMeshLambertMaterial||b.isMeshToonMaterial||b.isMeshPhongMaterial||b.isMeshStandardMaterial||b.isShadowMaterial||b.isShaderMaterial&&b.lights===!0}this.getActiveCubeFace=function(){return Y},this.getActiveMipmapLevel=function(){return B},this.getRenderTarget=function(){return te},this.setRenderTargetTextures=function(b,N,W){const k=Pe.get(b);k.__autoAllocateDepthBuffer=b.resolveDepthBuffer===!1,k.__autoAllocateDepthBuffer===!1&&(k.__useRenderToTexture=!1),Pe.get(b.texture).__webglTexture=N,Pe.get(b.depthTexture).__webglTexture=k.__autoAllocateDepthBuffer?void 0:W,k.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(b,N){const W=Pe.get(b);W.__webglFramebuffer=N,W.__useDefaultFramebuffer=N===void 0},this.setRenderTarget=function(b,N=0,W=0){te=b,Y=N,B=W;let k=null,H=!1,ue=!1;if(b){const ce=Pe.get(b);if(ce.__useDefaultFramebuffer!==void 0){de.bindFramebuffer(F.FRAMEBUFFER,ce.__webglFramebuffer),ee.copy(b.viewport),xe.copy(b.scissor),Ne=b.scissorTest,de.viewport(ee),de.scissor(xe),de.setScissorTest(Ne),V=-1;return}else if(ce.__webglFramebuffer===void 0)Ie.setupRenderTarget(b);else if(ce.__hasExternalTextures)Ie.rebindTextures(b,Pe.get(b.texture).__webglTexture,Pe.get(b.depthTexture).__webglTexture);else if(b.depthBuffer){const Fe=b.depthTexture;if(ce.__boundDepthTexture!==Fe){if(Fe!==null&&Pe.has(Fe)&&(b.width!==Fe.image.width||b.height!==Fe.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Ie.setupDepthRenderbuffer(b)}}const ve=b.texture;(ve.isData3DTexture||ve.isDataArrayTexture||ve.isCompressedArrayTexture)&&(ue=!0);const we=Pe.get(b).__webglFramebuffer;b.isWebGLCubeRenderTarget?(Array.isArray(we[N])?k=we[N][W]:k=we[N],H=!0):b.samples>0&&Ie.useMultisampledRTT(b)===!1?k=Pe.get(b).__webglMultisampledFramebuffer:Array.isArray(we)?k=we[W]:k=we,ee.copy(b.viewport),xe.copy(b.scissor),Ne=b.scissorTest}else ee.copy(Le).multiplyScalar(_e).floor(),xe.copy(Qe).multiplyScalar(_e).floor(),Ne=it;if(W!==0&&(k=X),de.bindFramebuffer(F.FRAMEBUFFER,k)&&de.drawBuffers(b,k),de.viewport(ee),de.scissor(xe),de.setScissorTest(Ne),H){const ce=Pe.get(b.texture);F.framebufferTexture2D(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_CUBE_MAP_POSITIVE_X+N,ce.__webglTexture,W)}else if(ue){const ce=N;for(let ve=0;ve<b.textures.length;ve++){const we=Pe.get(b.textures[ve]);F.framebufferTextureLayer(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0+ve,we.__webglTexture,W,ce)}}else if(b!==null&&W!==0){const ce=Pe.get(b.texture);F.framebufferTexture2D(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,ce.__webglTexture,W)}V=-1};function Fl(b){const N=Pe.get(b);return(N.__readFormat!==b.format||N.__readType!==b.type)&&(N.__readFormat=b.format,N.__readType=b.type,N.__formatReadable=lt.textureFormatReadable(b.format),N.__typeReadable=lt.textureTypeReadable(b.type)),N}this.readRenderTargetPixels=function(b,N,W,k,H,ue,Me,ce=0){if(!(b&&b.isWebGLRenderTarget)){Ke("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let ve=Pe.get(b).__webglFramebuffer;if(b.isWebGLCubeRenderTarget&&Me!==void 0&&(ve=ve[Me],Array.isArray(ve)&&(ve=ve[0])),ve){de.bindFramebuffer(F.FRAMEBUFFER,ve);try{const we=b.textures[ce],Fe=we.format,Xe=we.type;b.textures.length>1&&F.readBuffer(F.COLOR_ATTACHMENT0+ce);const be=Fl(we);if(be.__formatReadable===!1){Ke("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(be.__typeReadable===!1){Ke("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}N>=0&&N<=b.width-k&&W>=0&&W<=b.height-H&&F.readPixels(N,W,k,H,se.convert(Fe),se.convert(Xe),ue)}finally{const we=te!==null?Pe.get(te).__webglFramebuffer:null;de.bindFramebuffer(F.FRAMEBUFFER,we)}}},this.readRenderTargetPixelsAsync=async function(b,N,W,k,H,ue,Me,ce=0){if(!(b&&b.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let ve=Pe.get(b).__webglFramebuffer;if(b.isWebGLCubeRenderTarget&&Me!==void 0&&(ve=ve[Me],Array.isArray(ve)&&(ve=ve[0])),ve)if(N>=0&&N<=b.width-k&&W>=0&&W<=b.height-H){de.bindFramebuffer(F.FRAMEBUFFER,ve);const we=b.textures[ce],Fe=we.format,Xe=we.type;b.textures.length>1&&F.readBuffer(F.COLOR_ATTACHMENT0+ce);const be=Fl(we);if(be.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(be.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");const $e=F.createBuffer();F.bindBuffer(F.PIXEL_PACK_BUFFER,$e),F.bufferData(F.PIXEL_PACK_BUFFER,ue.byteLength,F.STREAM_READ),F.readPixels(N,W,k,H,se.convert(Fe),se.convert(Xe),0),F.bindBuffer(F.PIXEL_PACK_BUFFER,null);const Mt=te!==null?Pe.get(te).__webglFramebuffer:null;de.bindFramebuffer(F.FRAMEBUFFER,Mt);const at=F.fenceSync(F.SYNC_GPU_COMMANDS_COMPLETE,0);return F.flush(),await Qd(F,at,4),F.bindBuffer(F.PIXEL_PACK_BUFFER,$e),F.getBufferSubData(F.PIXEL_PACK_BUFFER,0,ue),F.bindBuffer(F.PIXEL_PACK_BUFFER,null),F.deleteBuffer($e),F.deleteSync(at),ue}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(b,N=null,W=0){const k=Math.pow(2,-W),H=Math.floor(b.image.width*k),ue=Math.floor(b.image.height*k),Me=N!==null?N.x:0,ce=N!==null?N.y:0;Ie.setTexture2D(b,0),F.copyTexSubImage2D(F.TEXTURE_2D,W,0,0,Me,ce,H,ue),de.unbindTexture()},this.copyTextureToTexture=function(b,N,W=null,k=null,H=0,ue=0){let Me,ce,ve,we,Fe,Xe,be,$e,Mt;const at=b.isCompressedTexture?b.mipmaps[ue]:b.image;if(W!==null)Me=W.max.x-W.min.x,ce=W.max.y-W.min.y,ve=W.isBox3?W.max.z-W.min.z:1,we=W.min.x,Fe=W.min.y,Xe=W.isBox3?W.min.z:0;else{const Ze=Math.pow(2,-H);Me=Math.floor(at.width*Ze),ce=Math.floor(at.height*Ze),b.isDataArrayTexture?ve=at.depth:b.isData3DTexture?ve=Math.floor(at.depth*Ze):ve=1,we=0,Fe=0,Xe=0}k!==null?(be=k.x,$e=k.y,Mt=k.z):(be=0,$e=0,Mt=0);const st=se.convert(N.format),kt=se.convert(N.type);let Se;N.isData3DTexture?(Ie.setTexture3D(N,0),Se=F.TEXTURE_3D):N.isDataArrayTexture||N.isCompressedArrayTexture?(Ie.setTexture2DArray(N,0),Se=F.TEXTURE_2D_ARRAY):(Ie.setTexture2D(N,0),Se=F.TEXTURE_2D),de.activeTexture(F.TEXTURE0),de.pixelStorei(F.UNPACK_FLIP_Y_WEBGL,N.flipY),de.pixelStorei(F.UNPACK_PREMULTIPLY_ALPHA_WEBGL,N.premultiplyAlpha),de.pixelStorei(F.UNPACK_ALIGNMENT,N.unpackAlignment);const Xt=de.getParameter(F.UNPACK_ROW_LENGTH),Je=de.getParameter(F.UNPACK_IMAGE_HEIGHT),di=de.getParameter(F.UNPACK_SKIP_PIXELS),zt=de.getParameter(F.UNPACK_SKIP_ROWS),Vs=de.getParameter(F.UNPACK_SKIP_IMAGES);de.pixelStorei(F.UNPACK_ROW_LENGTH,at.width),de.pixelStorei(F.UNPACK_IMAGE_HEIGHT,at.height),de.pixelStorei(F.UNPACK_SKIP_PIXELS,we),de.pixelStorei(F.UNPACK_SKIP_ROWS,Fe),de.pixelStorei(F.UNPACK_SKIP_IMAGES,Xe);const qn=b.isDataArrayTexture||b.isData3DTexture,fi=N.isDataArrayTexture||N.isData3DTexture;if(b.isDepthTexture){const Ze=Pe.get(b),It=Pe.get(N),vn=Pe.get(Ze.__renderTarget),dt=Pe.get(It.__renderTarget);de.bindFramebuffer(F.READ_FRAMEBUFFER,vn.__webglFramebuffer),de.bindFramebuffer(F.DRAW_FRAMEBUFFER,dt.__webglFramebuffer);for(let Lt=0;Lt<ve;Lt++)qn&&(F.framebufferTextureLayer(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,Pe.get(b).__webglTexture,H,Xe+Lt),F.framebufferTextureLayer(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,Pe.get(N).__webglTexture,ue,Mt+Lt)),F.blitFramebuffer(we,Fe,we+Me,Fe+ce,be,$e,be+Me,$e+ce,F.DEPTH_BUFFER_BIT,F.NEAREST);de.bindFramebuffer(F.READ_FRAMEBUFFER,null),de.bindFramebuffer(F.DRAW_FRAMEBUFFER,null)}else if(H!==0||b.isRenderTargetTexture||Pe.has(b)){const Ze=Pe.get(b),It=Pe.get(N);de.bindFramebuffer(F.READ_FRAMEBUFFER,D),de.bindFramebuffer(F.DRAW_FRAMEBUFFER,G);for(let vn=0;vn<ve;vn++)qn?F.framebufferTextureLayer(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,Ze.__webglTexture,H,Xe+vn):F.framebufferTexture2D(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,Ze.__webglTexture,H),fi?F.framebufferTextureLayer(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,It.__webglTexture,ue,Mt+vn):F.framebufferTexture2D(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,It.__webglTexture,ue),H!==0?F.blitFramebuffer(we,Fe,we+Me,Fe+ce,be,$e,be+Me,$e+ce,F.COLOR_BUFFER_BIT,F.NEAREST):fi?F.copyTexSubImage3D(Se,ue,be,$e,Mt+vn,we,Fe,Me,ce):F.copyTexSubImage2D(Se,ue,be,$e,we,Fe,Me,ce);de.bindFramebuffer(F.READ_FRAMEBUFFER,null),de.bindFramebuffer(F.DRAW_FRAMEBUFFER,null)}else fi?b.isDataTexture||b.isData3DTexture?F.texSubImage3D(Se,ue,be,$e,Mt,Me,ce,ve,st,kt,at.data):N.isCompressedArrayTexture?F.compressedTexSubImage3D(Se,ue,be,$e,Mt,Me,ce,ve,st,at.data):F.texSubImage3D(Se,ue,be,$e,Mt,Me,ce,ve,st,kt,at):b.isDataTexture?F.texSubImage2D(F.TEXTURE_2D,ue,be,$e,Me,ce,st,kt,at.data):b.isCompressedTexture?F.compressedTexSubImage2D(F.TEXTURE_2D,ue,be,$e,at.width,at.height,st,at.data):F.texSubImage2D(F.TEXTURE_2D,ue,be,$e,Me,ce,st,kt,at);de.pixelStorei(F.UNPACK_ROW_LENGTH,Xt),de.pixelStorei(F.UNPACK_IMAGE_HEIGHT,Je),de.pixelStorei(F.UNPACK_SKIP_PIXELS,di),de.pixelStorei(F.UNPACK_SKIP_ROWS,zt),de.pixelStorei(F.UNPACK_SKIP_IMAGES,Vs),ue===0&&N.generateMipmaps===!0&&N.mipmapsAutoUpdate===!0&&F.generateMipmap(Se),de.unbindTexture()},this.initRenderTarget=function(b){Pe.get(b).__webglFramebuffer===void 0&&Ie.setupRenderTarget(b)},this.initTexture=function(b){b.isCubeTexture?Ie.setTextureCube(b,0):b.isData3DTexture?Ie.setTexture3D(b,0):b.isDataArrayTexture||b.isCompressedArrayTexture?Ie.setTexture2DArray(b,0):Ie.setTexture2D(b,0),de.unbindTexture()},this.resetState=function(){Y=0,B=0,te=null,de.reset(),ae.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return En}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;const t=this.getContext();t.drawingBufferColorSpace=qe._getDrawingBufferColorSpace(e),t.unpackColorSpace=qe._getUnpackColorSpace()}}const U_=Date.now().toString(36);let F_=0;const mn=()=>`${U_} ${++F_}`,vi=new gl,mt=new T,Qn=new T,ct=new pt,Gc={X:new T(1,0,0),Y:new T(0,1,0),Z:new T(0,0,1)},Ha={type:"change"},Vc={type:"mouseDown",mode:null},Wc={type:"mouseUp",mode:null},Xc={type:"objectChange"};class O_ extends uu{constructor(e,t=null){super(void 0,t);const n=new V_(this);this._root=n;const s=new W_;this._gizmo=s,n.add(s);const r=new X_;this._plane=r,n.add(r);const a=this;function o(E,S){let C=S;Object.defineProperty(a,E,{get:function(){return C!==void 0?C:S},set:function(A){C!==A&&(C=A,r[E]=A,s[E]=A,a.dispatchEvent({type:E+"-changed",value:A}),a.dispatchEvent(Ha))}}),a[E]=S,r[E]=S,s[E]=S}o("camera",e),o("object",void 0),o("enabled",!0),o("axis",null),o("mode","translate"),o("translationSnap",null),o("rotationSnap",null),o("scaleSnap",null),o("space","world"),o("size",1),this.viewport=null,o("dragging",!1),o("showX",!0),o("showY",!0),o("showZ",!0),o("showXY",!0),o("showYZ",!0),o("showXZ",!0),o("showXYZE",!0),o("showE",!0),o("minX",-1/0),o("maxX",1/0),o("minY",-1/0),o("maxY",1/0),o("minZ",-1/0),o("maxZ",1/0);const l=new T,c=new T,h=new pt,d=new pt,u=new T,m=new pt,g=new T,v=new T,f=new T,p=0,x=new T;o("worldPosition",l),o("worldPositionStart",c),o("worldQuaternion",h),o("worldQuaternionStart",d),o("cameraPosition",u),o("cameraQuaternion",m),o("pointStart",g),o("pointEnd",v),o("rotationAxis",f),o("rotationAngle",p),o("eye",x),this._offset=new T,this._startNorm=new T,this._endNorm=new T,this._cameraScale=new T,this._parentPosition=new T,this._parentQuaternion=new pt,this._parentQuaternionInv=new pt,this._parentScale=new T,this._worldScaleStart=new T,this._worldQuaternionInv=new pt,this._worldScale=new T,this._positionStart=new T,this._quaternionStart=new pt,this._scaleStart=new T,this._getPointer=B_.bind(this),this._onPointerDown=z_.bind(this),this._onPointerHover=k_.bind(this),this._onPointerMove=H_.bind(this),this._onPointerUp=G_.bind(this),t!==null&&this.connect(t)}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointermove",this._onPointerHover),this.domElement.addEventListener("pointerup",this._onPointerUp),this.domElement.style.touchAction="none"}disconnect(){this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.removeEventListener("pointermove",this._onPointerHover),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.domElement.removeEventListener("pointerup",this._onPointerUp),this.domElement.style.touchAction=""}getHelper(){return this._root}pointerHover(e){if(this.object===void 0||this.dragging===!0)return;e!==null&&vi.setFromCamera(e,this.camera);const t=Ga(this._gizmo.picker[this.mode],vi);t?this.axis=t.object.name:this.axis=null}pointerDown(e){if(!(this.object===void 0||this.dragging===!0||e!=null&&e.button!==0)&&this.axis!==null){e!==null&&vi.setFromCamera(e,this.camera);const t=Ga(this._plane,vi,!0);t&&(this.object.updateMatrixWorld(),this.object.parent.updateMatrixWorld(),this._positionStart.copy(this.object.position),this._quaternionStart.copy(this.object.quaternion),this._scaleStart.copy(this.object.scale),this.object.matrixWorld.decompose(this.worldPositionStart,this.worldQuaternionStart,this._worldScaleStart),this.pointStart.copy(t.point).sub(this.worldPositionStart)),this.dragging=!0,Vc.mode=this.mode,this.dispatchEvent(Vc)}}pointerMove(e){const t=this.axis,n=this.mode,s=this.object;let r=this.space;if(n==="scale"?r="local":(t==="E"||t==="XYZE"||t==="XYZ")&&(r="world"),s===void 0||t===null||this.dragging===!1||e!==null&&e.button!==-1)return;e!==null&&vi.setFromCamera(e,this.camera);const a=Ga(this._plane,vi,!0);if(a){if(this.pointEnd.copy(a.point).sub(this.worldPositionStart),n==="translate")this._offset.copy(this.pointEnd).sub(this.pointStart),r==="local"&&t!=="XYZ"&&this._offset.applyQuaternion(this._worldQuaternionInv),t.indexOf("X")===-1&&(this._offset.x=0),t.indexOf("Y")===-1&&(this._offset.y=0),t.indexOf("Z")===-1&&(this._offset.z=0),r==="local"&&t!=="XYZ"?this._offset.applyQuaternion(this._quaternionStart).divide(this._parentScale):this._offset.applyQuaternion(this._parentQuaternionInv).divide(this._parentScale),s.position.copy(this._offset).add(this._positionStart),this.translationSnap&&(r==="local"&&(s.position.applyQuaternion(ct.copy(this._quaternionStart).invert()),t.search("X")!==-1&&(s.position.x=Math.round(s.position.x/this.translationSnap)*this.translationSnap),t.search("Y")!==-1&&(s.position.y=Math.round(s.position.y/this.translationSnap)*this.translationSnap),t.search("Z")!==-1&&(s.position.z=Math.round(s.position.z/this.translationSnap)*this.translationSnap),s.position.applyQuaternion(this._quaternionStart)),r==="world"&&(s.getWorldPosition(mt),t.search("X")!==-1&&(mt.x=Math.round(mt.x/this.translationSnap)*this.translationSnap),t.search("Y")!==-1&&(mt.y=Math.round(mt.y/this.translationSnap)*this.translationSnap),t.search("Z")!==-1&&(mt.z=Math.round(mt.z/this.translationSnap)*this.translationSnap),s.position.copy(s.parent.worldToLocal(mt)))),s.position.x=Math.max(this.minX,Math.min(this.maxX,s.position.x)),s.position.y=Math.max(this.minY,Math.min(this.maxY,s.position.y)),s.position.z=Math.max(this.minZ,Math.min(this.maxZ,s.position.z));else if(n==="scale"){if(t.search("XYZ")!==-1){let o=this.pointEnd.length()/this.pointStart.length();this.pointEnd.dot(this.pointStart)<0&&(o*=-1),Qn.set(o,o,o)}else mt.copy(this.pointStart),Qn.copy(this.pointEnd),mt.applyQuaternion(this._worldQuaternionInv),Qn.applyQuaternion(this._worldQuaternionInv),Qn.divide(mt),t.search("X")===-1&&(Qn.x=1),t.search("Y")===-1&&(Qn.y=1),t.search("Z")===-1&&(Qn.z=1);s.scale.copy(this._scaleStart).multiply(Qn),this.scaleSnap&&(t.search("X")!==-1&&(s.scale.x=Math.round(s.scale.x/this.scaleSnap)*this.scaleSnap||this.scaleSnap),t.search("Y")!==-1&&(s.scale.y=Math.round(s.scale.y/this.scaleSnap)*this.scaleSnap||this.scaleSnap),t.search("Z")!==-1&&(s.scale.z=Math.round(s.scale.z/this.scaleSnap)*this.scaleSnap||this.scaleSnap))}else if(n==="rotate"){this._offset.copy(this.pointEnd).sub(this.pointStart);const o=20/this.worldPosition.distanceTo(mt.setFromMatrixPosition(this.camera.matrixWorld));let l=!1;t==="XYZE"?(this.rotationAxis.copy(this._offset).cross(this.eye).normalize(),this.rotationAngle=this._offset.dot(mt.copy(this.rotationAxis).cross(this.eye))*o):(t==="X"||t==="Y"||t==="Z")&&(this.rotationAxis.copy(Gc[t]),mt.copy(Gc[t]),r==="local"&&mt.applyQuaternion(this.worldQuaternion),mt.cross(this.eye),mt.length()===0?l=!0:this.rotationAngle=this._offset.dot(mt.normalize())*o),(t==="E"||l)&&(this.rotationAxis.copy(this.eye),this.rotationAngle=this.pointEnd.angleTo(this.pointStart),this._startNorm.copy(this.pointStart).normalize(),this._endNorm.copy(this.pointEnd).normalize(),this.rotationAngle*=this._endNorm.cross(this._startNorm).dot(this.eye)<0?1:-1),this.rotationSnap&&(this.rotationAngle=Math.round(this.rotationAngle/this.rotationSnap)*this.rotationSnap),r==="local"&&t!=="E"&&t!=="XYZE"?(s.quaternion.copy(this._quaternionStart),s.quaternion.multiply(ct.setFromAxisAngle(this.rotationAxis,this.rotationAngle)).normalize()):(this.rotationAxis.applyQuaternion(this._parentQuaternionInv),s.quaternion.copy(ct.setFromAxisAngle(this.rotationAxis,this.rotationAngle)),s.quaternion.multiply(this._quaternionStart).normalize())}this.dispatchEvent(Ha),this.dispatchEvent(Xc)}}pointerUp(e){e!==null&&e.button!==0||(this.dragging&&this.axis!==null&&(Wc.mode=this.mode,this.dispatchEvent(Wc)),this.dragging=!1,this.axis=null)}dispose(){this.disconnect(),this._root.dispose()}attach(e){return this.object=e,this._root.visible=!0,this}detach(){return this.object=void 0,this.axis=null,this._root.visible=!1,this}reset(){this.enabled&&this.dragging&&(this.object.position.copy(this._positionStart),this.object.quaternion.copy(this._quaternionStart),this.object.scale.copy(this._scaleStart),this.dispatchEvent(Ha),this.dispatchEvent(Xc),this.pointStart.copy(this.pointEnd))}getRaycaster(){return vi}getMode(){return this.mode}setMode(e){this.mode=e}setTranslationSnap(e){this.translationSnap=e}setRotationSnap(e){this.rotationSnap=e}setScaleSnap(e){this.scaleSnap=e}setSize(e){this.size=e}setSpace(e){this.space=e}setColors(e,t,n,s){const r=this._gizmo.materialLib;r.xAxis.color.set(e),r.yAxis.color.set(t),r.zAxis.color.set(n),r.active.color.set(s),r.xAxisTransparent.color.set(e),r.yAxisTransparent.color.set(t),r.zAxisTransparent.color.set(n),r.activeTransparent.color.set(s),r.xAxis._color&&r.xAxis._color.set(e),r.yAxis._color&&r.yAxis._color.set(t),r.zAxis._color&&r.zAxis._color.set(n),r.active._color&&r.active._color.set(s),r.xAxisTransparent._color&&r.xAxisTransparent._color.set(e),r.yAxisTransparent._color&&r.yAxisTransparent._color.set(t),r.zAxisTransparent._color&&r.zAxisTransparent._color.set(n),r.activeTransparent._color&&r.activeTransparent._color.set(s)}}function B_(i){if(this.domElement.ownerDocument.pointerLockElement)return{x:0,y:0,button:i.button};{const e=this.domElement.getBoundingClientRect(),t=this.viewport;let n,s,r,a;return t!==null?(n=t.x,s=e.height-t.y-t.w,r=t.z,a=t.w):(n=0,s=0,r=e.width,a=e.height),{x:(i.clientX-e.left-n)/r*2-1,y:-(i.clientY-e.top-s)/a*2+1,button:i.button}}}function k_(i){if(this.enabled)switch(i.pointerType){case"mouse":case"pen":this.pointerHover(this._getPointer(i));break}}function z_(i){this.enabled&&(document.pointerLockElement||this.domElement.setPointerCapture(i.pointerId),this.domElement.addEventListener("pointermove",this._onPointerMove),this.pointerHover(this._getPointer(i)),this.pointerDown(this._getPointer(i)))}function H_(i){this.enabled&&this.pointerMove(this._getPointer(i))}function G_(i){this.enabled&&(this.domElement.releasePointerCapture(i.pointerId),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.pointerUp(this._getPointer(i)))}function Ga(i,e,t){const n=e.intersectObject(i,!0);for(let s=0;s<n.length;s++)if(n[s].object.visible||t)return n[s];return!1}const yr=new _n,rt=new T(0,1,0),$c=new T(0,0,0),qc=new Ge,br=new pt,Or=new pt,Dn=new T,Yr=new Ge,xs=new T(1,0,0),xi=new T(0,1,0),Ms=new T(0,0,1),Sr=new T,ms=new T,gs=new T;class V_ extends ht{constructor(e){super(),this.isTransformControlsRoot=!0,this.controls=e,this.visible=!1}updateMatrixWorld(e){const t=this.controls;t.object!==void 0&&(t.object.updateMatrixWorld(),t.object.parent===null?console.error("TransformControls: The attached 3D object must be a part of the scene graph."):t.object.parent.matrixWorld.decompose(t._parentPosition,t._parentQuaternion,t._parentScale),t.object.matrixWorld.decompose(t.worldPosition,t.worldQuaternion,t._worldScale),t._parentQuaternionInv.copy(t._parentQuaternion).invert(),t._worldQuaternionInv.copy(t.worldQuaternion).invert()),t.camera.updateMatrixWorld(),t.camera.matrixWorld.decompose(t.cameraPosition,t.cameraQuaternion,t._cameraScale),t.camera.isOrthographicCamera?t.camera.getWorldDirection(t.eye).negate():t.eye.copy(t.cameraPosition).sub(t.worldPosition).normalize(),this.parent&&(Yr.copy(this.parent.matrixWorld).invert(),Yr.decompose(this.position,this.quaternion,this.scale)),super.updateMatrixWorld(e)}dispose(){this.traverse(function(e){e.geometry&&e.geometry.dispose(),e.material&&e.material.dispose()})}}class W_ extends ht{constructor(){super(),this.isTransformControlsGizmo=!0,this.type="TransformControlsGizmo";const e=new as({depthTest:!1,depthWrite:!1,fog:!1,toneMapped:!1,transparent:!0}),t=new Fn({depthTest:!1,depthWrite:!1,fog:!1,toneMapped:!1,transparent:!0}),n=e.clone();n.opacity=.15;const s=t.clone();s.opacity=.5;const r=e.clone();r.color.setHex(16711680);const a=e.clone();a.color.setHex(65280);const o=e.clone();o.color.setHex(255);const l=e.clone();l.color.setHex(16711680),l.opacity=.5;const c=e.clone();c.color.setHex(65280),c.opacity=.5;const h=e.clone();h.color.setHex(255),h.opacity=.5;const d=e.clone();d.opacity=.25;const u=e.clone();u.color.setHex(16776960),u.opacity=.25;const m=e.clone();m.color.setHex(16776960);const g=e.clone();g.color.setHex(7895160),this.materialLib={xAxis:r,yAxis:a,zAxis:o,active:m,xAxisTransparent:l,yAxisTransparent:c,zAxisTransparent:h,activeTransparent:u};const v=new Ut(0,.04,.1,12);v.translate(0,.05,0);const f=new gt(.08,.08,.08);f.translate(0,.04,0);const p=new Ye;p.setAttribute("position",new nt([0,0,0,1,0,0],3));const x=new Ut(.0075,.0075,.5,3);x.translate(0,.25,0);function E(G,Y){const B=new Mi(G,.0075,3,64,Y*Math.PI*2);return B.rotateY(Math.PI/2),B.rotateX(Math.PI/2),B}function S(){const G=new Ye;return G.setAttribute("position",new nt([0,0,0,1,1,1],3)),G}const C={X:[[new fe(v,r),[.5,0,0],[0,0,-Math.PI/2]],[new fe(v,r),[-.5,0,0],[0,0,Math.PI/2]],[new fe(x,r),[0,0,0],[0,0,-Math.PI/2]]],Y:[[new fe(v,a),[0,.5,0]],[new fe(v,a),[0,-.5,0],[Math.PI,0,0]],[new fe(x,a)]],Z:[[new fe(v,o),[0,0,.5],[Math.PI/2,0,0]],[new fe(v,o),[0,0,-.5],[-Math.PI/2,0,0]],[new fe(x,o),null,[Math.PI/2,0,0]]],XYZ:[[new fe(new Gi(.1,0),d),[0,0,0]]],XY:[[new fe(new gt(.15,.15,.01),h),[.15,.15,0]]],YZ:[[new fe(new gt(.15,.15,.01),l),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new fe(new gt(.15,.15,.01),c),[.15,0,.15],[-Math.PI/2,0,0]]]},A={X:[[new fe(new Ut(.2,0,.6,4),n),[.3,0,0],[0,0,-Math.PI/2]],[new fe(new Ut(.2,0,.6,4),n),[-.3,0,0],[0,0,Math.PI/2]]],Y:[[new fe(new Ut(.2,0,.6,4),n),[0,.3,0]],[new fe(new Ut(.2,0,.6,4),n),[0,-.3,0],[0,0,Math.PI]]],Z:[[new fe(new Ut(.2,0,.6,4),n),[0,0,.3],[Math.PI/2,0,0]],[new fe(new Ut(.2,0,.6,4),n),[0,0,-.3],[-Math.PI/2,0,0]]],XYZ:[[new fe(new Gi(.2,0),n)]],XY:[[new fe(new gt(.2,.2,.01),n),[.15,.15,0]]],YZ:[[new fe(new gt(.2,.2,.01),n),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new fe(new gt(.2,.2,.01),n),[.15,0,.15],[-Math.PI/2,0,0]]]},_={START:[[new fe(new Gi(.01,2),s),null,null,null,"helper"]],END:[[new fe(new Gi(.01,2),s),null,null,null,"helper"]],DELTA:[[new un(S(),s),null,null,null,"helper"]],X:[[new un(p,s),[-1e3,0,0],null,[1e6,1,1],"helper"]],Y:[[new un(p,s),[0,-1e3,0],[0,0,Math.PI/2],[1e6,1,1],"helper"]],Z:[[new un(p,s),[0,0,-1e3],[0,-Math.PI/2,0],[1e6,1,1],"helper"]]},w={XYZE:[[new fe(E(.5,1),g),null,[0,Math.PI/2,0]]],X:[[new fe(E(.5,.5),r)]],Y:[[new fe(E(.5,.5),a),null,[0,0,-Math.PI/2]]],Z:[[new fe(E(.5,.5),o),null,[0,Math.PI/2,0]]],E:[[new fe(E(.75,1),u),null,[0,Math.PI/2,0]]]},I={AXIS:[[new un(p,s),[-1e3,0,0],null,[1e6,1,1],"helper"]]},P={XYZE:[[new fe(new Qi(.25,10,8),n)]],X:[[new fe(new Mi(.5,.1,4,24),n),[0,0,0],[0,-Math.PI/2,-Math.PI/2]]],Y:[[new fe(new Mi(.5,.1,4,24),n),[0,0,0],[Math.PI/2,0,0]]],Z:[[new fe(new Mi(.5,.1,4,24),n),[0,0,0],[0,0,-Math.PI/2]]],E:[[new fe(new Mi(.75,.1,2,24),n)]]},U={X:[[new fe(f,r),[.5,0,0],[0,0,-Math.PI/2]],[new fe(x,r),[0,0,0],[0,0,-Math.PI/2]],[new fe(f,r),[-.5,0,0],[0,0,Math.PI/2]]],Y:[[new fe(f,a),[0,.5,0]],[new fe(x,a)],[new fe(f,a),[0,-.5,0],[0,0,Math.PI]]],Z:[[new fe(f,o),[0,0,.5],[Math.PI/2,0,0]],[new fe(x,o),[0,0,0],[Math.PI/2,0,0]],[new fe(f,o),[0,0,-.5],[-Math.PI/2,0,0]]],XY:[[new fe(new gt(.15,.15,.01),h),[.15,.15,0]]],YZ:[[new fe(new gt(.15,.15,.01),l),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new fe(new gt(.15,.15,.01),c),[.15,0,.15],[-Math.PI/2,0,0]]],XYZ:[[new fe(new gt(.1,.1,.1),d)]]},O={X:[[new fe(new Ut(.2,0,.6,4),n),[.3,0,0],[0,0,-Math.PI/2]],[new fe(new Ut(.2,0,.6,4),n),[-.3,0,0],[0,0,Math.PI/2]]],Y:[[new fe(new Ut(.2,0,.6,4),n),[0,.3,0]],[new fe(new Ut(.2,0,.6,4),n),[0,-.3,0],[0,0,Math.PI]]],Z:[[new fe(new Ut(.2,0,.6,4),n),[0,0,.3],[Math.PI/2,0,0]],[new fe(new Ut(.2,0,.6,4),n),[0,0,-.3],[-Math.PI/2,0,0]]],XY:[[new fe(new gt(.2,.2,.01),n),[.15,.15,0]]],YZ:[[new fe(new gt(.2,.2,.01),n),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new fe(new gt(.2,.2,.01),n),[.15,0,.15],[-Math.PI/2,0,0]]],XYZ:[[new fe(new gt(.2,.2,.2),n),[0,0,0]]]},X={X:[[new un(p,s),[-1e3,0,0],null,[1e6,1,1],"helper"]],Y:[[new un(p,s),[0,-1e3,0],[0,0,Math.PI/2],[1e6,1,1],"helper"]],Z:[[new un(p,s),[0,0,-1e3],[0,-Math.PI/2,0],[1e6,1,1],"helper"]]};function D(G){const Y=new ht;for(const B in G)for(let te=G[B].length;te--;){const V=G[B][te][0].clone(),Q=G[B][te][1],ee=G[B][te][2],xe=G[B][te][3],Ne=G[B][te][4];V.name=B,V.tag=Ne,Q&&V.position.set(Q[0],Q[1],Q[2]),ee&&V.rotation.set(ee[0],ee[1],ee[2]),xe&&V.scale.set(xe[0],xe[1],xe[2]),V.updateMatrix();const Z=V.geometry.clone();Z.applyMatrix4(V.matrix),V.geometry=Z,V.renderOrder=1/0,V.position.set(0,0,0),V.rotation.set(0,0,0),V.scale.set(1,1,1),Y.add(V)}return Y}this.gizmo={},this.picker={},this.helper={},this.add(this.gizmo.translate=D(C)),this.add(this.gizmo.rotate=D(w)),this.add(this.gizmo.scale=D(U)),this.add(this.picker.translate=D(A)),this.add(this.picker.rotate=D(P)),this.add(this.picker.scale=D(O)),this.add(this.helper.translate=D(_)),this.add(this.helper.rotate=D(I)),this.add(this.helper.scale=D(X)),this.picker.translate.visible=!1,this.picker.rotate.visible=!1,this.picker.scale.visible=!1}updateMatrixWorld(e){const n=(this.mode==="scale"?"local":this.space)==="local"?this.worldQuaternion:Or;this.gizmo.translate.visible=this.mode==="translate",this.gizmo.rotate.visible=this.mode==="rotate",this.gizmo.scale.visible=this.mode==="scale",this.helper.translate.visible=this.mode==="translate",this.helper.rotate.visible=this.mode==="rotate",this.helper.scale.visible=this.mode==="scale";let s=[];s=s.concat(this.picker[this.mode].children),s=s.concat(this.gizmo[this.mode].children),s=s.concat(this.helper[this.mode].children);for(let r=0;r<s.length;r++){const a=s[r];a.visible=!0,a.rotation.set(0,0,0),a.position.copy(this.worldPosition);let o;if(this.camera.isOrthographicCamera?o=(this.camera.top-this.camera.bottom)/this.camera.zoom:o=this.worldPosition.distanceTo(this.cameraPosition)*Math.min(1.9*Math.tan(Math.PI*this.camera.fov/360)/this.camera.zoom,7),a.scale.set(1,1,1).multiplyScalar(o*this.size/4),a.tag==="helper"){a.visible=!1,a.name==="AXIS"?(a.visible=!!this.axis,this.axis==="X"&&(ct.setFromEuler(yr.set(0,0,0)),a.quaternion.copy(n).multiply(ct),Math.abs(rt.copy(xs).applyQuaternion(n).dot(this.eye))>.9&&(a.visible=!1)),this.axis==="Y"&&(ct.setFromEuler(yr.set(0,0,Math.PI/2)),a.quaternion.copy(n).multiply(ct),Math.abs(rt.copy(xi).applyQuaternion(n).dot(this.eye))>.9&&(a.visible=!1)),this.axis==="Z"&&(ct.setFromEuler(yr.set(0,Math.PI/2,0)),a.quaternion.copy(n).multiply(ct),Math.abs(rt.copy(Ms).applyQuaternion(n).dot(this.eye))>.9&&(a.visible=!1)),this.axis==="XYZE"&&(ct.setFromEuler(yr.set(0,Math.PI/2,0)),rt.copy(this.rotationAxis),a.quaternion.setFromRotationMatrix(qc.lookAt($c,rt,xi)),a.quaternion.multiply(ct),a.visible=this.dragging),this.axis==="E"&&(a.visible=!1)):a.name==="START"?(a.position.copy(this.worldPositionStart),a.visible=this.dragging):a.name==="END"?(a.position.copy(this.worldPosition),a.visible=this.dragging):a.name==="DELTA"?(a.position.copy(this.worldPositionStart),a.quaternion.copy(this.worldQuaternionStart),mt.set(1e-10,1e-10,1e-10).add(this.worldPositionStart).sub(this.worldPosition).multiplyScalar(-1),mt.applyQuaternion(this.worldQuaternionStart.clone().invert()),a.scale.copy(mt),a.visible=this.dragging):(a.quaternion.copy(n),this.dragging?a.position.copy(this.worldPositionStart):a.position.copy(this.worldPosition),this.axis&&(a.visible=this.axis.search(a.name)!==-1));continue}a.quaternion.copy(n),this.mode==="translate"||this.mode==="scale"?(a.name==="X"&&Math.abs(rt.copy(xs).applyQuaternion(n).dot(this.eye))>.99&&(a.scale.set(1e-10,1e-10,1e-10),a.visible=!1),a.name==="Y"&&Math.abs(rt.copy(xi).applyQuaternion(n).dot(this.eye))>.99&&(a.scale.set(1e-10,1e-10,1e-10),a.visible=!1),a.name==="Z"&&Math.abs(rt.copy(Ms).applyQuaternion(n).dot(this.eye))>.99&&(a.scale.set(1e-10,1e-10,1e-10),a.visible=!1),a.name==="XY"&&Math.abs(rt.copy(Ms).applyQuaternion(n).dot(this.eye))<.2&&(a.scale.set(1e-10,1e-10,1e-10),a.visible=!1),a.name==="YZ"&&Math.abs(rt.copy(xs).applyQuaternion(n).dot(this.eye))<.2&&(a.scale.set(1e-10,1e-10,1e-10),a.visible=!1),a.name==="XZ"&&Math.abs(rt.copy(xi).applyQuaternion(n).dot(this.eye))<.2&&(a.scale.set(1e-10,1e-10,1e-10),a.visible=!1)):this.mode==="rotate"&&(br.copy(n),rt.copy(this.eye).applyQuaternion(ct.copy(n).invert()),a.name.search("E")!==-1&&a.quaternion.setFromRotationMatrix(qc.lookAt(this.eye,$c,xi)),a.name==="X"&&(ct.setFromAxisAngle(xs,Math.atan2(-rt.y,rt.z)),ct.multiplyQuaternions(br,ct),a.quaternion.copy(ct)),a.name==="Y"&&(ct.setFromAxisAngle(xi,Math.atan2(rt.x,rt.z)),ct.multiplyQuaternions(br,ct),a.quaternion.copy(ct)),a.name==="Z"&&(ct.setFromAxisAngle(Ms,Math.atan2(rt.y,rt.x)),ct.multiplyQuaternions(br,ct),a.quaternion.copy(ct))),a.visible=a.visible&&(a.name.indexOf("X")===-1||this.showX),a.visible=a.visible&&(a.name.indexOf("Y")===-1||this.showY),a.visible=a.visible&&(a.name.indexOf("Z")===-1||this.showZ),a.visible=a.visible&&(a.name.indexOf("E")===-1||this.showX&&this.showY&&this.showZ),a.visible=a.visible&&(a.name.indexOf("XY")===-1||this.showXY),a.visible=a.visible&&(a.name.indexOf("YZ")===-1||this.showYZ),a.visible=a.visible&&(a.name.indexOf("XZ")===-1||this.showXZ),a.visible=a.visible&&(a.name!=="E"||this.showE),a.visible=a.visible&&(a.name!=="XYZE"||this.showXYZE),a.material._color=a.material._color||a.material.color.clone(),a.material._opacity=a.material._opacity||a.material.opacity,a.material.color.copy(a.material._color),a.material.opacity=a.material._opacity,this.enabled&&this.axis&&(a.name===this.axis?(a.material.color.copy(this.materialLib.active.color),a.material.opacity=1):this.axis.split("").some(function(l){return a.name===l})&&(a.material.color.copy(this.materialLib.active.color),a.material.opacity=1))}super.updateMatrixWorld(e)}}class X_ extends fe{constructor(){super(new Bs(1e5,1e5,2,2),new as({visible:!1,wireframe:!0,side:Ft,transparent:!0,opacity:.1,toneMapped:!1})),this.isTransformControlsPlane=!0,this.type="TransformControlsPlane"}updateMatrixWorld(e){let t=this.space;switch(this.position.copy(this.worldPosition),this.mode==="scale"&&(t="local"),Sr.copy(xs).applyQuaternion(t==="local"?this.worldQuaternion:Or),ms.copy(xi).applyQuaternion(t==="local"?this.worldQuaternion:Or),gs.copy(Ms).applyQuaternion(t==="local"?this.worldQuaternion:Or),rt.copy(ms),this.mode){case"translate":case"scale":switch(this.axis){case"X":rt.copy(this.eye).cross(Sr),Dn.copy(Sr).cross(rt);break;case"Y":rt.copy(this.eye).cross(ms),Dn.copy(ms).cross(rt);break;case"Z":rt.copy(this.eye).cross(gs),Dn.copy(gs).cross(rt);break;case"XY":Dn.copy(gs);break;case"YZ":Dn.copy(Sr);break;case"XZ":rt.copy(gs),Dn.copy(ms);break;case"XYZ":case"E":Dn.set(0,0,0);break}break;case"rotate":default:Dn.set(0,0,0)}Dn.length()===0?this.quaternion.copy(this.cameraQuaternion):(Yr.lookAt(mt.set(0,0,0),Dn,rt),this.quaternion.setFromRotationMatrix(Yr)),super.updateMatrixWorld(e)}}const $_={X:new T(1,0,0),Y:new T(0,1,0),Z:new T(0,0,1)},q_=.35;class Y_ extends O_{turn=null;pointerDown(e){super.pointerDown(e),this.turn=this.dragging&&e&&this.mode==="rotate"?this.ringAt(e):null}pointerMove(e){if(!this.turn||!e||!this.dragging)return super.pointerMove(e);const{axis:t,plane:n,center:s,first:r,orientation:a}=this.turn,o=this.towards(e,n,s);if(!o)return;const l=Math.atan2(r.clone().cross(o).dot(n.normal),r.dot(o)),c=this.rotationSnap,h=c?Math.round(l/c)*c:l;this.object.quaternion.copy(a).multiply(new pt().setFromAxisAngle(t,h)).normalize(),this.dispatchEvent({type:"change"}),this.dispatchEvent({type:"objectChange"})}pointerUp(e){this.turn=null,super.pointerUp(e)}ringAt(e){const t=$_[this.axis];if(!t)return null;const n=this.object.quaternion.clone(),s=this.object.getWorldPosition(new T),r=t.clone().applyQuaternion(this.object.getWorldQuaternion(new pt)),a=new bn().setFromNormalAndCoplanarPoint(r,s),o=this.towards(e,a,s);return o&&{axis:t,plane:a,center:s,first:o,orientation:n}}towards(e,t,n){const s=new gl;return s.setFromCamera(new Ee(e.x,e.y),this.camera),Math.abs(s.ray.direction.dot(t.normal))<q_?null:s.ray.intersectPlane(t,new T)?.sub(n)??null}}class Z_{constructor(e,t,n,s){this.stage=e,this.controls=new Y_(e.camera,e.canvas),this.controls.setSize(.8),t.add(this.controls.getHelper()),this.controls.addEventListener("change",()=>e.draw()),this.controls.addEventListener("axis-changed",()=>{e.canvas.style.cursor=this.hovered?"grab":""}),this.controls.addEventListener("dragging-changed",({value:r})=>{e.orbit.enabled=!r,this.gesture=r?mn():"",r||s()}),e.canvas.addEventListener("pointermove",r=>this.pointer=r,!0),this.controls.addEventListener("objectChange",()=>{const{object:r,mode:a}=this.controls;if(a==="translate")n({p:K_(r.position),...this.ray()},this.gesture);else if(a==="scale")n({size:this.size.map((o,l)=>Number(Math.abs(o*r.scale.getComponent(l)).toFixed(4)))},this.gesture);else{const{w:o,x:l,y:c,z:h}=r.quaternion;n({q:[o,l,c,h]},this.gesture)}})}controls;gesture="";size=null;pointer=null;ray(){if(this.controls.axis!=="XYZ"||!this.pointer)return{};const{origin:e,direction:t}=this.stage.ray(this.pointer).ray;return{ray:{from:e.toArray(),along:t.toArray()}}}snap(e){this.controls.setTranslationSnap(e?.05:null),this.controls.setRotationSnap(e?Math.PI/36:null)}take({key:e},t){if(!this.dragging)return!1;const n=e.toUpperCase();if(/^[XYZ]$/.test(n))this.controls.axis=n;else{if(e!=="Escape")return!1;this.controls.reset(),this.controls.pointerUp(null),t()}return!0}get dragging(){return this.controls.dragging}get hovered(){return this.controls.axis!==null}get mode(){return this.controls.mode==="translate"?"translate":"rotate"}hold(e,t){this.size=t??null;const n=t===void 0?"rotate":t?"scale":"translate";this.controls.setMode(this.mode==="translate"?"translate":n),this.controls.setSpace(this.mode==="translate"?"world":"local"),this.controls.camera=this.stage.camera,this.controls.viewport=this.stage.designPart,e?this.controls.attach(e):this.controls.detach()}use(e){this.controls.setMode(e==="rotate"&&this.size?"scale":e),this.controls.setSpace(e==="translate"?"world":"local"),this.stage.draw()}}const K_=i=>i.toArray().map(e=>Math.round(e*1e4)/1e4),ia={viridis:[[.2777273272234177,.005407344544966578,.3340998053353061],[.1050930431085774,1.404613529898575,1.384590162594685],[-.3308618287255563,.214847559468213,.09509516302823659],[-4.634230498983486,-5.799100973351585,-19.33244095627987],[6.228269936347081,14.17993336680509,56.69055260068105],[4.776384997670288,-13.74514537774601,-65.35303263337234],[-5.435455855934631,4.645852612178535,26.3124352495832]],plasma:[[.05873234392399702,.02333670892565664,.5433401826748754],[2.176514634195958,.2383834171260182,.7539604599784036],[-2.689460476458034,-7.455851135738909,3.110799939717086],[6.130348345893603,42.3461881477227,-28.51885465332158],[-11.10743619062271,-82.66631109428045,60.13984767418263],[10.02306557647065,71.4136177009535,-54.07218655560067],[-3.658713842777788,-22.93153465461149,18.19190778539828]],inferno:[[.0002189403691192265,.001651004631001012,-.01948089843709184],[.1065134194856116,.5639564367884091,3.932712388889277],[11.60249308247187,-3.972853965665698,-15.9423941062914],[-41.70399613139459,17.43639888205313,44.35414519872813],[77.162935699427,-33.40235894210092,-81.80730925738993],[-71.31942824499214,32.62606426397723,73.20951985803202],[25.13112622477341,-12.24266895238567,-23.07032500287172]],magma:[[-.002136485053939582,-.000749655052795221,-.005386127855323933],[.2516605407371642,.6775232436837668,2.494026599312351],[8.353717279216625,-3.577719514958484,.3144679030132573],[-27.66873308576866,14.26473078096533,-13.64921318813922],[52.17613981234068,-27.94360607168351,12.94416944238394],[-50.76852536473588,29.04658282127291,4.23415299384598],[18.65570506591883,-11.48977351997711,-5.601961508734096]]},$o=i=>Math.min(1,Math.max(0,i));function J_(i,e){const t=$o(e);return[0,1,2].map(n=>$o(ia[i].reduceRight((s,r)=>s*t+r[n],0)))}const $i={worse:[.7,.35,.02],same:[.94,.94,.94],better:[.05,.38,.68]};function j_(i){const e=$o(i),[t,n]=e<.5?[$i.worse,1-2*e]:[$i.better,2*e-1];return $i.same.map((s,r)=>s+n*(t[r]-s))}const Va=i=>`vec3(${i.map(e=>e.toFixed(6)).join(", ")})`,sa=`
uniform vec2 range;
uniform bool logarithmic;
uniform bool brightIsLarge;
uniform bool difference;
uniform vec3 powers[7];
float partOf(float value) {
  float t = logarithmic
      ? log(max(value, range.x) / range.x) / max(log(range.y / range.x), 1e-20)
      : (value - range.x) / max(range.y - range.x, 1e-30);
  return clamp(t, 0.0, 1.0);
}
vec3 colourOf(float value) {
  float t = partOf(value);
  t = brightIsLarge ? t : 1.0 - t;
  if (difference) {
    vec3 far = t < 0.5 ? ${Va($i.worse)} : ${Va($i.better)};
    return mix(${Va($i.same)}, far, abs(2.0 * t - 1.0));
  }
  vec3 c = powers[6];
  for (int i = 5; i >= 0; --i) c = c * t + powers[i];
  return clamp(c, 0.0, 1.0);
}
`;class ts{constructor(e,t,n,s,r="viridis",a=!1){this.min=e,this.max=t,this.logarithmic=n,this.brightIsLarge=s,this.map=r,this.difference=a}static of(e,t){const n=t.low??e.min,s=Math.max(n,t.high??e.max);return new ts(n,s,t.logarithmic&&n>0,e.largerIsBetter!==t.reversed,t.map)}static ofDifference(e,t,n){const s=Math.max(Math.abs(e),Math.abs(t),1e-12);return new ts(-s,s,!1,n,"viridis",!0)}part(e){return this.max>this.min?this.logarithmic?Math.log(e/this.min)/Math.log(this.max/this.min):(e-this.min)/(this.max-this.min):.5}at(e){return this.logarithmic?this.min*(this.max/this.min)**e:this.min+e*(this.max-this.min)}colour(e){const t=this.part(e),n=this.brightIsLarge?t:1-t;return this.difference?j_(n):J_(this.map,n)}css(e){return`rgb(${this.colour(e).map(t=>Math.round(255*t)).join(" ")})`}powers(){return Yc(Math.log10(this.min),Math.log10(this.max)).map(e=>10**e)}ticks(e){const t=this.min*e,n=this.max*e;if(!(n>t))return[this.min];const s=[];if(this.logarithmic&&n/t>8)for(let r=Math.floor(Math.log10(t));r<=Math.ceil(Math.log10(n));++r)for(const a of n/t>1e3?[1]:[1,2,5])s.push(a*10**r);else s.push(...Yc(t,n));return s.filter(r=>r>=t&&r<=n).map(r=>r/e)}}function Yc(i,e){const t=(e-i)/5;if(!(t>0))return[];const n=10**Math.floor(Math.log10(t)),s=[1,2,5,10].find(a=>a*n>=t)*n,r=[];for(let a=Math.ceil(i/s);a*s<=e;++a)r.push(a*s);return r}class Su extends ht{constructor(e=document.createElement("div")){super(),this.isCSS2DObject=!0,this.element=e,this.element.style.position="absolute",this.element.style.userSelect="none",this.element.setAttribute("draggable",!1),this.center=new Ee(.5,.5),this.rotation2D=0,this.addEventListener("removed",function(){this.traverse(function(t){t.element&&t.element instanceof t.element.ownerDocument.defaultView.Element&&t.element.parentNode!==null&&t.element.remove()})})}copy(e,t){return super.copy(e,t),this.element=e.element.cloneNode(!0),this.center=e.center,this.rotation2D=e.rotation2D,this}}const Oi=new T,Zc=new Ge,Kc=new Ge,Jc=new T,jc=new T;class Q_{constructor(e={}){const t=this;let n,s,r,a;const o={objects:new WeakMap},l=e.element!==void 0?e.element:document.createElement("div");l.style.overflow="hidden",this.domElement=l,this.sortObjects=!0,this.getSize=function(){return{width:n,height:s}},this.render=function(g,v){g.matrixWorldAutoUpdate===!0&&g.updateMatrixWorld(),v.parent===null&&v.matrixWorldAutoUpdate===!0&&v.updateMatrixWorld(),Zc.copy(v.matrixWorldInverse),Kc.multiplyMatrices(v.projectionMatrix,Zc),h(g,g,v),this.sortObjects&&m(g)},this.setSize=function(g,v){n=g,s=v,r=n/2,a=s/2,l.style.width=g+"px",l.style.height=v+"px"};function c(g){g.isCSS2DObject&&(g.element.style.display="none");for(let v=0,f=g.children.length;v<f;v++)c(g.children[v])}function h(g,v,f){if(g.visible===!1){c(g);return}if(g.isCSS2DObject){Oi.setFromMatrixPosition(g.matrixWorld),Oi.applyMatrix4(Kc);const p=Oi.z>=-1&&Oi.z<=1&&g.layers.test(f.layers)===!0,x=g.element;if(x.style.display=p===!0?"":"none",p===!0){g.onBeforeRender(t,v,f);const S=100*g.center.x,C=100*g.center.y;x.style.transformOrigin=`${S}% ${C}%`;const A=-g.rotation2D,_=Oi.x*r+r,w=-Oi.y*a+a;x.style.transform=`translate(${-S}%, ${-C}%) translate(${_}px, ${w}px) rotate(${A}rad)`,x.parentNode!==l&&l.appendChild(x),g.onAfterRender(t,v,f)}const E={distanceToCameraSquared:d(f,g)};o.objects.set(g,E)}for(let p=0,x=g.children.length;p<x;p++)h(g.children[p],v,f)}function d(g,v){return Jc.setFromMatrixPosition(g.matrixWorld),jc.setFromMatrixPosition(v.matrixWorld),Jc.distanceToSquared(jc)}function u(g){const v=[];return g.traverseVisible(function(f){f.isCSS2DObject&&v.push(f)}),v}function m(g){const v=u(g).sort(function(p,x){if(p.renderOrder!==x.renderOrder)return x.renderOrder-p.renderOrder;const E=o.objects.get(p).distanceToCameraSquared,S=o.objects.get(x).distanceToCameraSquared;return E-S}),f=v.length;for(let p=0,x=v.length;p<x;p++)v[p].element.style.zIndex=f-p}}}function ev({regions:i},e){const t=new Tt;return i.forEach(({box:n,why:s},r)=>{const a=new Si(new T(...n.min),new T(...n.max)).expandByScalar(.001);t.add(new hu(a,new Ue(e)));const o=document.createElement("div");o.className="tag blind",o.textContent=`${r+1}`,o.title=s;const l=new Su(o);l.position.copy(a.getCenter(new T)),t.add(l)}),t}const Qc=new Map;function jt(i,e){let t=Qc.get(i);return t||Qc.set(i,t=e()),t}function wu(i,e){if(!(i>0))return 0;const t=e/i,n=10**Math.floor(Math.log10(t));return[5,2,1].find(s=>s*n<=t)*n}function Eu(i,{axes:e,sigma:t},n,s,r=!0){const a=new fe(r?new Qi(1,40,24):new Qi(1,16,10),jt(`ellipsoid ${s}`,()=>new ou({color:s,transparent:!0,opacity:.6}))),[o,l,c]=e.map((h,d)=>new T(...h).multiplyScalar(Math.max(1e-4,n*t[d])));return a.matrixAutoUpdate=!1,a.matrix=new Ge().makeBasis(o,l,c).setPosition(...i),a}function Tu(i,e,t,n){const s=new Tt,r=.3*t;for(const a of e)for(const o of[1,-1]){const l=new T(...a).multiplyScalar(o);s.add(new zf(l,new T(...i),t,n,r,.6*r))}return s}function tv(i,e,t,n,s){const r=new Tt,a=Math.max(0,...i.points.flatMap(({ellipsoid:l})=>l?.sigma??[])),o=wu(e*a,.45*t);for(const l of i.points)l.ellipsoid?r.add(Eu(l.at,l.ellipsoid,o*e,n,!1)):r.add(Tu(l.at,l.lost,.4*t,s));return{group:r,scale:o}}function zs(i){i.traverse(e=>{e.geometry?.dispose(),e.element?.remove()}),i.removeFromParent()}function nv(i){const e=i/10,t=10**Math.floor(Math.log10(e));return[1,2,5,10].find(n=>n*t>=e)*t}const ra=i=>jt(`line ${i}`,()=>new Fn({color:i}));function iv(i,e){const t=Math.max(i.max[0]-i.min[0],i.max[1]-i.min[1],.001),n=nv(t),s=[0,1].map(c=>Math.floor(i.min[c]/n)*n),r=[0,1].map(c=>Math.ceil(i.max[c]/n)*n),a=i.min[2]-t/100,o=[];for(let c=s[0];c<=r[0]+n/2;c+=n)o.push(new T(c,s[1],a),new T(c,r[1],a));for(let c=s[1];c<=r[1]+n/2;c+=n)o.push(new T(s[0],c,a),new T(r[0],c,a));const l=ra(e.faint);return{lines:new wi(new Ye().setFromPoints(o),l),step:n}}function sv(i,e){const t=new Ye;t.setAttribute("position",new vt(new Float32Array(i.vertices),3)),t.setIndex(i.triangles);const n=jt(`region ${e}`,()=>new as({color:e,side:Ft,transparent:!0,opacity:.08,depthWrite:!1})),s=new Tt;return s.add(new fe(t,n),new wi(new ru(t,30),ra(e))),s}function rv(i,e,t){const n=e?t.selected:t.bodies,s=new Ye;s.setAttribute("position",new vt(new Float32Array(i.vertices),3)),s.setIndex(i.triangles);const r=s.toNonIndexed();r.computeVertexNormals();const a=new Tt;return i.room||a.add(new fe(r,jt(`body ${n}`,()=>new ou({color:n,side:Ft,transparent:!0,opacity:.55,depthWrite:!1,polygonOffset:!0,polygonOffsetFactor:4,polygonOffsetUnits:4})))),a.add(new wi(new ru(s,30),ra(e?t.selected:t.lines))),a}class av{group=new Tt;step=1;show(e,t,n,s,r){for(const h of[...this.group.children])zs(h);const a=new Si(new T(...e.min),new T(...e.max)),o=new hu(a,new Ue(r.lines)),{lines:l,step:c}=iv(t,r);this.step=c,this.group.add(o,l);for(const h of n.occluders)h.carried||this.add(rv(h,h.path!==""&&h.path===s,r),h.path);for(const h of n.regions)this.add(sv(h,h.path===s?r.selected:r.region),h.path);for(const h of n.surfaces)h.length>1&&this.group.add(new un(new Ye().setFromPoints(h.map(d=>new T(...d))),ra(r.region)));n.beacons.length>0&&this.group.add(new tu(new Ye().setFromPoints(n.beacons.map(h=>new T(...h))),jt(`beacons ${r.beacons}`,()=>new eu({color:r.beacons,size:3,sizeAttenuation:!1}))))}add(e,t){e.userData.path=t,this.group.add(e)}pick(e){for(const{object:t,distance:n}of e.intersectObject(this.group,!0)){const s=t.parent?.userData.path;if(s&&t.isMesh)return{path:s,distance:n}}return null}}const ni={a:new Ue("#5b6270"),b:new Ue("#2b303b"),solid:new Ue("#14161c"),gained:new Ue("#2f7fd0"),lost:new Ue("#d0691f")},vl=`
uniform vec3 blindA, blindB, solid, gained, lost;
vec3 withoutValue(float drawn) {
  if (drawn > 1.5 && drawn < 2.5) return solid;
  float stripe = mod(gl_FragCoord.x + gl_FragCoord.y, 12.0);
  vec3 a = drawn < 0.5 ? blindA : drawn < 3.5 ? gained : lost;
  return stripe < 5.0 ? a : blindB;
}
`;function aa(){return{range:{value:new Ee(0,1)},logarithmic:{value:!1},brightIsLarge:{value:!1},difference:{value:!1},powers:{value:ia.viridis.map(i=>new T(...i))},blindA:{value:ni.a},blindB:{value:ni.b},solid:{value:ni.solid},gained:{value:ni.gained},lost:{value:ni.lost}}}function Zr({uniforms:i},e){i.range.value.set(e.min,e.max),i.logarithmic.value=e.logarithmic,i.brightIsLarge.value=e.brightIsLarge,i.difference.value=e.difference,ia[e.map].forEach((t,n)=>i.powers.value[n].set(...t))}const ov=`
in float sampleValue;
in float sampleDrawn;
out float value, valid;
flat out float drawn;
out vec3 toEye;
uniform float size;
uniform bool ringed;
void main() {
  value = sampleValue;
  valid = sampleDrawn == 1.0 ? 1.0 : 0.0;
  drawn = sampleDrawn;
  vec4 eye = modelViewMatrix * vec4(position, 1.0);
  toEye = eye.xyz;
  gl_PointSize = size;
  gl_Position = projectionMatrix * eye;
  if (ringed) gl_Position.z -= 2e-3 * gl_Position.w;  // before what they lie on
}
`,Au=`
precision highp float;
in float value, valid;
flat in float drawn;
in vec3 toEye;
out vec4 colour;
${sa}
${vl}
`,lv=`
${Au}
uniform bool ringed;
void main() {
  float r = length(gl_PointCoord - 0.5);
  if (r > 0.5 || (valid < 0.5 && r < 0.28)) discard;
  if (ringed && r > 0.38) {
    colour = vec4(blindB, 1.0);
    return;
  }
  colour = vec4(valid < 0.5 ? (drawn < 0.5 ? blindA : withoutValue(drawn)) : colourOf(value), 1.0);
}
`,cv=`
${Au}
void main() {
  vec3 normal = normalize(cross(dFdx(toEye), dFdy(toEye)));
  float light = 0.78 + 0.22 * abs(normal.z);
  if (valid < 0.999) {
    colour = vec4(light * withoutValue(drawn == 1.0 ? 0.0 : drawn), 1.0);
  } else {
    colour = vec4(light * colourOf(value), 1.0);
  }
}
`;function hv(i,e){const t=e.first+e.count,n=Float32Array.from(i.mask.subarray(e.first,t)),s=i.values.slice(e.first,t);for(let a=0;a<s.length;++a)n[a]!==ai.value&&(s[a]=0);const r=new Ye;return r.setAttribute("position",new vt(e.positions,3)),r.setAttribute("sampleValue",new vt(s,1)),r.setAttribute("sampleDrawn",new vt(n,1)),e.kind==="surface"&&r.setIndex(new vt(e.triangles,1)),r}function uv(i,e,t=!1){const n=e.kind==="surface",s=(e.count>2e3?5:9)+(t?2:0),r=jt(`samples ${e.kind} ${s} ${t}`,()=>new Rn({glslVersion:ji,vertexShader:ov,fragmentShader:n?cv:lv,side:Ft,uniforms:{...aa(),size:{value:s},ringed:{value:t}}})),a=hv(i,e);return n?new fe(a,r):new tu(a,r)}const dv=`
in float sampleValue;
out float value;
out vec3 toEye, across;
void main() {
  value = sampleValue;
  across = normalMatrix * normal;
  vec4 eye = modelViewMatrix * vec4(position, 1.0);
  toEye = eye.xyz;
  gl_Position = projectionMatrix * eye;
}
`,fv=`
precision highp float;
uniform bool facets;
in float value;
in vec3 toEye, across;
out vec4 colour;
${sa}
void main() {
  vec3 normal = facets || dot(across, across) < 1e-6 ? cross(dFdx(toEye), dFdy(toEye)) : across;
  float light = 0.45 + 0.55 * abs(normalize(normal).z);
  colour = vec4(light * colourOf(value), 1.0);
}
`,eh=i=>jt(`shape ${i}`,()=>new Rn({glslVersion:ji,vertexShader:dv,fragmentShader:fv,side:Ft,uniforms:{...aa(),facets:{value:i}}}));function pv(i,e){const t=new Ye;t.setAttribute("position",new vt(i.positions,3)),t.setAttribute("normal",new vt(i.normals,3)),t.setAttribute("sampleValue",new vt(i.values,1)),t.setIndex(new vt(i.triangles,1));const{length:n}=i.triangles;i.caps>0&&t.addGroup(0,i.caps,0),i.caps<n&&t.addGroup(i.caps,n-i.caps,1);const s=[eh(!1),eh(!0)];for(const r of s)Zr(r,e);return new fe(t,s)}function mv({positions:i},e){const t=new Ye;return t.setAttribute("position",new vt(i,3)),new wi(t,jt(`cells ${e}`,()=>new Fn({color:e,transparent:!0,opacity:.35,depthWrite:!1})))}const gv=`
out vec2 at;
out vec3 place;
void main() {
  at = uv;
  place = position;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}
`,_v=`
precision highp float;
precision highp sampler2D;
uniform sampler2D samples;  // value, Drawn
uniform vec2 counts;
uniform bool blend, raised;
uniform vec3 low, high;  // of what it is shown within, metres
in vec2 at;
in vec3 place;
out vec4 colour;
${sa}
${vl}
void main() {
  if (any(lessThan(place, low)) || any(greaterThan(place, high))) discard;
  vec2 s = clamp(at, 0.0, 1.0) * (counts - 1.0);
  ivec2 last = ivec2(counts) - 1;
  vec2 nearest = texelFetch(samples, min(ivec2(s + 0.5), last), 0).xy;
  if (nearest.y < 0.5 || nearest.y > 1.5) {
    colour = vec4(withoutValue(nearest.y), 1.0);
    return;
  }
  if (raised) discard;  // it stands above
  float value = nearest.x;
  if (blend) {
    ivec2 low = ivec2(s);
    vec2 part = s - vec2(low);
    float sum = 0.0, weights = 0.0;
    for (int j = 0; j < 2; ++j)
      for (int i = 0; i < 2; ++i) {
        vec2 corner = texelFetch(samples, min(low + ivec2(i, j), last), 0).xy;
        float w = (i == 1 ? part.x : 1.0 - part.x) * (j == 1 ? part.y : 1.0 - part.y);
        if (corner.y > 0.5 && corner.y < 1.5) {
          sum += w * corner.x;
          weights += w;
        }
      }
    value = sum / weights;
  }
  colour = vec4(colourOf(value), 1.0);
  // Where there is no difference runs a line.
  float slope = fwidth(value);
  if (difference && slope > 0.0 && abs(value) < slope) colour.rgb *= 0.25;
}
`;class vv{mesh;data=null;constructor(){const e=new Rn({glslVersion:ji,vertexShader:gv,fragmentShader:_v,side:Ft,uniforms:{...aa(),samples:{value:null},counts:{value:new Ee(1,1)},blend:{value:!0},raised:{value:!1},low:{value:new T},high:{value:new T}},polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1});this.mesh=new fe(new Ye,e)}show(e,t,n,s,r,a){this.data=e;const{low:o,high:l}=this.mesh.material.uniforms,c=1e30;o.value.set(...r?.min??[-c,-c,-c]).addScalar(-1e-6),l.value.set(...r?.max??[c,c,c]).addScalar(1e-6);const[h,d]=e.counts,u=new Float32Array(2*h*d);for(let v=0,f=0;v<d;++v)for(let p=0;p<h;++p){const x=e.index(p,v),E=n[x];u[f++]=E===ai.value?t[x]:0,u[f++]=E}const m=new Qh(u,h,d,li,pn);m.needsUpdate=!0;const{uniforms:g}=this.mesh.material;g.samples.value?.dispose(),g.samples.value=m,g.counts.value.set(h,d),g.blend.value=s,g.raised.value=a,this.place(e)}nearest(e){const[t,n]=this.data.counts;return this.data.index(Math.round(Math.min(1,Math.max(0,e.x))*(t-1)),Math.round(Math.min(1,Math.max(0,e.y))*(n-1)))}place({origin:e,u:t,v:n}){const s=[e,e.clone().add(t),e.clone().add(t).add(n),e.clone().add(n)],r=new Ye().setFromPoints(s);r.setAttribute("uv",new vt(new Float32Array([0,0,1,0,1,1,0,1]),2)),r.setIndex([0,1,2,0,2,3]),this.mesh.geometry.dispose(),this.mesh.geometry=r}}const xv={corner:new T(-.75,-1,.62),top:new T(0,-1e-4,1),front:new T(0,-1,0),side:new T(1,0,0),below:new T(0,-1e-4,-1),back:new T(0,1,0),left:new T(-1,0,0)},qo=40,Mv=110,Wa=Math.tan(qo*Math.PI/360);class yv{perspective=new Sn(qo,1,.01,100);parallel=new ea;target=new T;flat=!1;through=!1;aspect=1;center=new T;radius=1;constructor(){for(const e of[this.perspective,this.parallel])e.up.set(0,0,1)}get camera(){return this.flat&&!this.through?this.parallel:this.perspective}get asDevice(){return this.through}get orthographic(){return this.flat}get size(){return this.radius}setOrthographic(e){if(e===this.flat)return;const{target:t,parallel:n,perspective:s}=this,r=this.camera;if(this.flat=e,this.through)return;const a=r.position.clone().sub(t),o=e?a.length()*Wa:n.top/n.zoom;s.position.copy(t).addScaledVector(a.normalize(),o/Wa),n.position.copy(s.position);for(const l of[n,s])l.quaternion.copy(r.quaternion);this.spread(o)}spread(e){const{parallel:t,aspect:n}=this;[t.top,t.bottom]=[e,-e],[t.left,t.right]=[-e*n,e*n],t.zoom=1,t.updateProjectionMatrix()}look(e,t){if(this.through=!1,this.setFov(qo),t){const c=new T(...t.min),h=new T(...t.max);this.center=c.clone().add(h).multiplyScalar(.5),this.radius=Math.max(.001,c.distanceTo(h)/2)}const{radius:n,center:s,perspective:r,parallel:a}=this,o=Math.min(1,this.aspect),l=1.12*n/Math.sin(Math.atan(Wa*o));r.near=n/200,a.near=-40*n;for(const c of[r,a])c.far=40*n,c.position.copy(xv[e]).normalize().multiplyScalar(l).add(s),c.lookAt(s);this.target.copy(s),r.updateProjectionMatrix(),this.spread(1.12*n/o)}lookThrough({pose:e,outline:t}){const[n,s,r]=[0,1,2].map(l=>new T(...e.R.map(c=>c[l])));this.through=!0;const{perspective:a}=this;a.position.set(...e.p),a.quaternion.setFromRotationMatrix(new Ge().makeBasis(n,s.negate(),r.negate()));const o=Math.max(.2,...(t??[]).map(l=>Math.max(Math.abs(l[1]),Math.abs(l[0])/this.aspect)/l[2]));this.setFov(360/Math.PI*Math.atan(1.05*o))}turn(e,t){const{camera:n,target:s}=this,{x:r,y:a,z:o}=n.position.clone().sub(s),l=new Wo().setFromVector3(new T(a,o,r));l.theta-=e,l.phi=Math.min(Math.PI-1e-4,Math.max(1e-4,l.phi-t));const c=new T().setFromSpherical(l);n.position.set(s.x+c.z,s.y+c.x,s.z+c.y),n.lookAt(s)}frame(e,t){this.aspect=e/t,this.perspective.aspect=this.aspect;for(const s of[this.perspective,this.parallel])s.setViewOffset(e,t,Mv/2,0,e,t);const{zoom:n}=this.parallel;this.spread(this.parallel.top),this.parallel.zoom=n,this.parallel.updateProjectionMatrix()}comeNearer(e){if(this.through)return;const t=s=>Math.min(1,s),n=t(this.aspect)/t(this.aspect*e);this.perspective.position.sub(this.target).multiplyScalar(n).add(this.target),this.parallel.zoom/=n,this.parallel.updateProjectionMatrix()}setFov(e){this.perspective.fov=e,this.perspective.updateProjectionMatrix()}}const bv=i=>new T(0,0,-1).transformDirection(i.matrixWorld),Sv=`
out vec3 place;  // in the box, from 0 to 1
void main() {
  place = position;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}
`,wv=`
precision highp float;
precision highp sampler2D;
precision highp sampler3D;
uniform sampler3D samples;
uniform sampler2D opaqueDepth;
uniform vec2 picture, corner;    // pixels
uniform vec3 counts, size;
uniform vec3 camera, sight;  // in the box: where it is, which way it looks
uniform bool parallel;       // all rays are
uniform mat4 toBox;
in vec3 place;
out vec4 colour;
${sa}
${vl}
uniform int steps;
vec3 eye;  // where the ray begins

/** The value at a place of the box, and how much of the weight has one; less than 0: it is
 * within a solid. */
vec2 look(vec3 at) {
  vec3 s = (clamp(at, 0.0, 1.0) * (counts - 1.0) + 0.5) / counts;
  vec4 sum = texture(samples, s);
  return vec2(sum.x / max(sum.y, 1e-6), sum.z > 0.5 ? -1.0 : sum.y);
}

/** Where along the ray the opaque begins: in units of its direction. */
float opaque(vec3 direction) {
  vec2 at = (gl_FragCoord.xy - corner) / picture;
  float depth = texture(opaqueDepth, gl_FragCoord.xy / vec2(textureSize(opaqueDepth, 0))).x;
  vec4 p = toBox * vec4(2.0 * vec3(at, depth) - 1.0, 1.0);
  return dot(p.xyz / p.w - eye, direction) / dot(direction, direction);
}

void main() {
  vec3 direction = parallel ? normalize(sight) : normalize(place - camera);
  eye = parallel ? place - 2.0 * direction : camera;
  vec3 a = -eye / direction, b = (1.0 - eye) / direction;
  vec3 near = min(a, b), far = max(a, b);
  float begin = max(max(near.x, max(near.y, near.z)), 0.0);
  float end = min(min(far.x, min(far.y, far.z)), opaque(direction));
  if (end <= begin) discard;
  float stride = (end - begin) / float(steps);
  float way = length(direction * stride * size) / length(size);
  vec4 sum = vec4(0.0);
  for (int i = 0; i < steps; ++i) {
    vec2 v = look(eye + (begin + (float(i) + 0.5) * stride) * direction);
    if (v.y < 0.0) continue;
    bool finite = v.y >= 0.5;
    float good = brightIsLarge ? partOf(v.x) : 1.0 - partOf(v.x);
    float density = finite ? 0.6 + 9.0 * pow(good, 3.0) : 1.6;
    float alpha = 1.0 - exp(-density * way);
    sum += (1.0 - sum.a) * alpha * vec4(finite ? colourOf(v.x) : blindA, 1.0);
    if (sum.a > 0.99) break;
  }
  if (sum.a < 0.004) discard;
  colour = vec4(sum.rgb / sum.a, sum.a);
}
`;function Ev(i,e){const t=new Float32Array(4*e.count);for(let s=0;s<e.count;++s){const r=i.mask[e.first+s];r===ai.value?t.set([i.values[e.first+s],1],4*s):r===ai.inside&&(t[4*s+2]=1)}const n=new Zh(t,...e.counts);return n.format=wn,n.type=pn,n.minFilter=n.magFilter=qt,n.needsUpdate=!0,n}const Tv=new gt().translate(.5,.5,.5);class Av{mesh;clip=new Ge;constructor(){const e=new Rn({glslVersion:ji,vertexShader:Sv,fragmentShader:wv,side:Yt,transparent:!0,depthTest:!1,depthWrite:!1,uniforms:{...aa(),samples:{value:null},opaqueDepth:{value:null},picture:{value:new Ee(1,1)},corner:{value:new Ee},counts:{value:new T},size:{value:new T(1,1,1)},camera:{value:new T},sight:{value:new T},parallel:{value:!1},toBox:{value:new Ge},steps:{value:64}}});this.mesh=new fe(Tv,e),this.mesh.frustumCulled=!1,this.mesh.renderOrder=1,this.mesh.visible=!1}hide(){this.mesh.visible=!1}show(e,t,n){const{uniforms:s}=this.mesh.material;s.samples.value?.dispose(),s.samples.value=Ev(e,t);const r=t.counts.map((a,o)=>Math.max(a-1,.001)*t.step[o]);s.counts.value.set(...t.counts),s.size.value.set(...r),s.steps.value=Math.min(96,Math.max(40,1.5*Math.max(...t.counts))),Zr(this.mesh.material,n),this.mesh.position.set(...t.origin),this.mesh.scale.set(r[0],r[1],r[2]),this.mesh.updateMatrixWorld(),this.mesh.visible=!0}prepare(e,t,n,s){const{uniforms:r}=this.mesh.material;this.clip.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse).multiply(this.mesh.matrixWorld),r.toBox.value.copy(this.clip).invert();const a=this.mesh.matrixWorld.clone().invert();r.camera.value.setFromMatrixPosition(e.matrixWorld).applyMatrix4(a),r.sight.value.copy(bv(e)).add(this.mesh.position).applyMatrix4(a),r.parallel.value=e instanceof ea,r.opaqueDepth.value=t,r.corner.value.copy(n),r.picture.value.copy(s)}}const Rv=500;function Yo(i,e,t){const n=Math.round((t-i.origin[e])/i.step[e]);return Math.min(i.counts[e]-1,Math.max(0,n))}function Cv(i,e,t){const[n,s]=[0,1,2].filter(l=>l!==e),r=[1,i.counts[0],i.counts[0]*i.counts[1]],a=new T(...i.origin);a.setComponent(e,i.origin[e]+t*i.step[e]);const o=l=>{const c=i.counts[l];return c===1&&a.setComponent(l,a.getComponent(l)-i.step[l]/2),new T().setComponent(l,Math.max(1,c-1)*i.step[l])};return{origin:a,u:o(n),v:o(s),counts:[i.counts[n],i.counts[s]],index:(l,c)=>i.first+t*r[e]+l*r[n]+c*r[s]}}const th=i=>({origin:new T(...i.origin),u:new T(...i.u),v:new T(...i.v),counts:i.counts,index:(e,t)=>i.first+e+t*i.counts[0]}),Pv=(i,e)=>!i||e.toArray().every((t,n)=>t>=i.min[n]-1e-6&&t<=i.max[n]+1e-6);class nh{group=new Tt;field=null;sheets=new Map;volume=new Av;spare=[];scattered=new Map;constructor(){this.group.add(this.volume.mesh)}show(e,t,n,s){for(const r of[...this.group.children])r!==this.volume.mesh&&zs(r);this.spare.push(...[...this.sheets.values()].map(({sheet:r})=>r)),this.volume.hide(),this.sheets.clear(),this.scattered.clear(),this.field=e;for(const r of e.parts)if(r.kind==="grid"){for(const{axis:a,at:o}of t.slices)this.sheet(e,Cv(r,a,Yo(r,a,o)),n,s,t.raised);n&&t.cloud&&this.volume.show(e,r,n)}else r.kind==="plane"?this.sheet(e,th(r),n,s,t.raised):this.withoutGrid(e,r,n);for(const r of t.through?.parts??[])(r.kind==="surface"||r.kind==="points"&&r.count<=Rv)&&this.withoutGrid(t.through,r,n);for(const r of t.sections?.parts??[])r.kind==="plane"&&this.sheet(t.sections,th(r),n,s,t.raised,t.box);if(n)for(const r of t.meshes)this.group.add(pv(r,n));t.leaves&&this.group.add(mv(t.leaves,s))}withoutGrid(e,t,n){const s=uv(e,t,e!==this.field&&t.kind==="points");n&&Zr(s.material,n),this.scattered.set(s,{part:t,of:e}),this.group.add(s)}pick(e){const t=[...this.sheets.keys(),...this.scattered.keys()],n=e.intersectObjects(t,!1).filter(({object:h,point:d})=>Pv(this.sheets.get(h)?.within??null,d)),s=n[0];if(!s||!this.field)return null;const r=this.scattered.get(s.object);if(r&&r.of!==this.field)return this.under(s.point,r.of);const a=n.filter(({object:h})=>h===s.object&&s.distanceToRay!==void 0).reduce((h,d)=>d.distanceToRay<h.distanceToRay?d:h,s),o=this.sheets.get(s.object)?.field??this.field,l=this.sampleOf(a),c=o.parts.find(h=>l>=h.first&&l<h.first+h.count);return c?ca(c,l-c.first):null}under(e,t){const n="xyz".indexOf(t.summary.through.over),s=this.field.parts.filter(el).flatMap(a=>Array.from({length:a.count},(o,l)=>ca(a,l))),r=a=>Math.hypot(...e.toArray().map((o,l)=>l===n?0:o-a[l]));return s.reduce((a,o)=>a&&r(a)<=r(o)?a:o,null)}sampleOf(e){const t=this.sheets.get(e.object)?.sheet;if(t)return t.nearest(e.uv);const{part:n}=this.scattered.get(e.object);if(!e.face)return n.first+e.index;const s=a=>e.point.distanceToSquared(new T(...ca(n,a))),r=[e.face.a,e.face.b,e.face.c].sort((a,o)=>s(a)-s(o));return n.first+r[0]}sheet(e,t,n,s,r,a=null){const{values:o,mask:l,summary:c}=e,h=this.spare.pop()??new vv;if(h.show(t,o,l,c.metric.name!=="coverage",a,r),n&&Zr(h.mesh.material,n),this.sheets.set(h.mesh,{sheet:h,field:e,within:a}),this.group.add(h.mesh),a)return;const{origin:d,u,v:m}=t,g=[d,d.clone().add(u),d.clone().add(u).add(m),d.clone().add(m)],v=new pl(new Ye().setFromPoints(g),jt(`line ${s}`,()=>new Fn({color:s})));this.group.add(v)}}const ih={all:.28,selected:1};function Lv(i,e,t){const n=new Tt;if(!i.outline||i.outline.length===0)return n.add(new fe(new Qi(.42*e,20,14),t)),n;const s=new fe(new gt(.8*e,.6*e,.9*e),t);s.position.z=-.6*e;const r=new fe(new Qr(.38*e,.55*e,20,1,!0),t);return r.rotation.x=-Math.PI/2,r.position.z=.05*e,n.add(s,r),n}function Dv(i){const e=i.map(a=>Math.hypot(a.x,a.y)),t=Math.min(...e),n=i.length,s=3,r=i.filter((a,o)=>{for(let l=-s;l<=s;++l)if(l!==0&&e[(o+l+n)%n]>e[o]-(l<0?1e-9:0))return!1;return e[o]>1.02*t});return r.length>=3?r:i.filter((a,o)=>o%(n/6)===0)}function Nv(i,e,t){const n=e?ih.selected:ih.all,s=i.map(c=>c.clone().multiplyScalar(n)),r=e?t.selected:t.sight,a=jt(`sight ${r}`,()=>new Fn({color:r,transparent:!0,opacity:e?.95:.5})),o=Dv(s).flatMap(c=>[new T,c]),l=new Tt;if(l.add(new pl(new Ye().setFromPoints(s),a),new wi(new Ye().setFromPoints(o),a)),e){const c=[new T,...s],h=new Ye().setFromPoints(c);h.setIndex(s.flatMap((d,u)=>[0,u+1,(u+1)%s.length+1])),l.add(new fe(h,jt(`seen ${r}`,()=>new as({color:r,transparent:!0,opacity:.07,side:Ft,depthWrite:!1}))))}return l}function Iv(i,e,t){const n=document.createElement("div");n.className=t?"tag selected":"tag",n.textContent=i.name;const s=new Su(n);return s.position.set(0,0,0),s.center.set(.5,2),s.userData.size=e,s}class sh{group=new Tt;byName=new Map;show(e,t,n){for(const c of[...this.group.children])zs(c);this.byName.clear();const{min:s,max:r}=e.room,a=.032*Math.max(.001,Math.hypot(...r.map((c,h)=>c-s[h]))),o=e.devices.filter(c=>c.pose),l=t.labels&&o.length<=40;for(const c of o){const h=c.name===t.selected,d=new Tt;d.name=c.name;const u=h?n.selected:n.device,m=jt(`device ${u}`,()=>new Nf({color:u,roughness:.55,side:Ft}));d.add(Lv(c,o.length>60?a/2:a,m)),c.outline.length>0&&(h||t.frusta&&o.length<=60)&&d.add(Nv(c.outline.map(g=>new T(...g)),h,n)),(l||h)&&d.add(Iv(c,a,h)),this.group.add(d),this.byName.set(c.name,d),rh(d,c)}}move(e,t){for(const n of e.devices){const s=this.byName.get(n.name);!s||!n.pose||(n.name===t?Ru(s,n):rh(s,n))}}find(e){return e===null?null:this.byName.get(e)??null}hide(e){const t=this.find(e);t&&(t.visible=!1)}nameOf(e){for(let t=e;t;t=t.parent)if(t.parent===this.group)return t.name;return null}}function Ru(i,e){const[t,n,s]=e.pose.R,r=new Ge().set(...t,0,...n,0,...s,0,0,0,0,1);i.quaternion.setFromRotationMatrix(r)}function rh(i,e){i.position.set(...e.pose.p),Ru(i,e)}class Uv{group=new Tt;clear(){for(const e of[...this.group.children])zs(e)}show(e,t,n,s,r){const a=r.probe;this.clear();const o=.018*n,l=[0,1,2].flatMap(u=>[-o,o].map(m=>{const g=new T(...e);return g.setComponent(u,g.getComponent(u)+m)})),c=new wi(new Ye().setFromPoints(l),jt(`cross ${a}`,()=>new Fn({color:a,depthTest:!1})));if(c.renderOrder=2,this.group.add(c),!t)return 0;this.group.add(Tu(e,t.lost,.06*n,r.lost));const{ellipsoid:h}=t;if(!h)return 0;const d=wu(s*Math.max(...h.sigma),.05*n);return d>0&&this.group.add(Eu(e,h,d*s,r.probe)),d}}const ah={type:"change"},xl={type:"start"},Cu={type:"end"},wr=new Os,oh=new bn,Fv=Math.cos(70*af.DEG2RAD),Et=new T,Jt=2*Math.PI,je={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Xa=1e-6;class Ov extends uu{constructor(e,t=null){super(e,t),this.state=je.NONE,this.target=new T,this.cursor=new T,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Vi.ROTATE,MIDDLE:Vi.DOLLY,RIGHT:Vi.PAN},this.touches={ONE:Hi.ROTATE,TWO:Hi.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new T,this._lastQuaternion=new pt,this._lastTargetPosition=new T,this._quat=new pt().setFromUnitVectors(e.up,new T(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new Wo,this._sphericalDelta=new Wo,this._scale=1,this._panOffset=new T,this._rotateStart=new Ee,this._rotateEnd=new Ee,this._rotateDelta=new Ee,this._panStart=new Ee,this._panEnd=new Ee,this._panDelta=new Ee,this._dollyStart=new Ee,this._dollyEnd=new Ee,this._dollyDelta=new Ee,this._dollyDirection=new T,this._mouse=new Ee,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=kv.bind(this),this._onPointerDown=Bv.bind(this),this._onPointerUp=zv.bind(this),this._onContextMenu=qv.bind(this),this._onMouseWheel=Vv.bind(this),this._onKeyDown=Wv.bind(this),this._onTouchStart=Xv.bind(this),this._onTouchMove=$v.bind(this),this._onMouseDown=Hv.bind(this),this._onMouseMove=Gv.bind(this),this._interceptControlDown=Yv.bind(this),this._interceptControlUp=Zv.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(e){this._cursorStyle=e,e==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=je.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(ah),this.update(),this.state=je.NONE}pan(e,t){this._pan(e,t),this.update()}dollyIn(e){this._dollyIn(e),this.update()}dollyOut(e){this._dollyOut(e),this.update()}rotateLeft(e){this._rotateLeft(e),this.update()}rotateUp(e){this._rotateUp(e),this.update()}update(e=null){const t=this.object.position;Et.copy(t).sub(this.target),Et.applyQuaternion(this._quat),this._spherical.setFromVector3(Et),this.autoRotate&&this.state===je.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(n)&&isFinite(s)&&(n<-Math.PI?n+=Jt:n>Math.PI&&(n-=Jt),s<-Math.PI?s+=Jt:s>Math.PI&&(s-=Jt),n<=s?this._spherical.theta=Math.max(n,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+s)/2?Math.max(n,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{const a=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=a!=this._spherical.radius}if(Et.setFromSpherical(this._spherical),Et.applyQuaternion(this._quatInverse),t.copy(this.target).add(Et),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let a=null;if(this.object.isPerspectiveCamera){const o=Et.length();a=this._clampDistance(o*this._scale);const l=o-a;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){const o=new T(this._mouse.x,this._mouse.y,0);o.unproject(this.object);const l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;const c=new T(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(o),this.object.updateMatrixWorld(),a=Et.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;a!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(a).add(this.object.position):(wr.origin.copy(this.object.position),wr.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(wr.direction))<Fv?this.object.lookAt(this.target):(oh.setFromNormalAndCoplanarPoint(this.object.up,this.target),wr.intersectPlane(oh,this.target))))}else if(this.object.isOrthographicCamera){const a=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),a!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Xa||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Xa||this._lastTargetPosition.distanceToSquared(this.target)>Xa?(this.dispatchEvent(ah),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?Jt/60*this.autoRotateSpeed*e:Jt/60/60*this.autoRotateSpeed}_getZoomScale(e){const t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){Et.setFromMatrixColumn(t,0),Et.multiplyScalar(-e),this._panOffset.add(Et)}_panUp(e,t){this.screenSpacePanning===!0?Et.setFromMatrixColumn(t,1):(Et.setFromMatrixColumn(t,0),Et.crossVectors(this.object.up,Et)),Et.multiplyScalar(e),this._panOffset.add(Et)}_pan(e,t){const n=this.domElement;if(this.object.isPerspectiveCamera){const s=this.object.position;Et.copy(s).sub(this.target);let r=Et.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*r/n.clientHeight,this.object.matrix),this._panUp(2*t*r/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;const n=this.domElement.getBoundingClientRect(),s=e-n.left,r=t-n.top,a=n.width,o=n.height;this._mouse.x=s/a*2-1,this._mouse.y=-(r/o)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientY),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);const t=this.domElement;this._rotateLeft(Jt*this._rotateDelta.x/t.clientHeight),this._rotateUp(Jt*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(Jt*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-Jt*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(Jt*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-Jt*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{const t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(n,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{const t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(n,s)}}_handleTouchStartDolly(e){const t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(n*n+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{const n=this._getSecondPointerPosition(e),s=.5*(e.pageX+n.x),r=.5*(e.pageY+n.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);const t=this.domElement;this._rotateLeft(Jt*this._rotateDelta.x/t.clientHeight),this._rotateUp(Jt*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{const t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(n,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){const t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(n*n+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);const a=(e.pageX+t.x)*.5,o=(e.pageY+t.y)*.5;this._updateZoomParameters(a,o)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new Ee,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){const t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){const t=e.deltaMode,n={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}}function Bv(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function kv(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function zv(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(Cu),this.state=je.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:const e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function Hv(i){let e;switch(i.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case Vi.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=je.DOLLY;break;case Vi.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=je.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=je.ROTATE}break;case Vi.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=je.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=je.PAN}break;default:this.state=je.NONE}this.state!==je.NONE&&this.dispatchEvent(xl)}function Gv(i){switch(this.state){case je.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case je.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case je.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function Vv(i){this.enabled===!1||this.enableZoom===!1||this.state!==je.NONE||(i.preventDefault(),this.dispatchEvent(xl),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(Cu))}function Wv(i){this.enabled!==!1&&this._handleKeyDown(i)}function Xv(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case Hi.ROTATE:if(this.enableRotate===!1){this.state=je.NONE;break}this._handleTouchStartRotate(i),this.state=je.TOUCH_ROTATE;break;case Hi.PAN:if(this.enablePan===!1){this.state=je.NONE;break}this._handleTouchStartPan(i),this.state=je.TOUCH_PAN;break;default:this.state=je.NONE}break;case 2:switch(this.touches.TWO){case Hi.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=je.TOUCH_DOLLY_PAN;break;case Hi.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=je.TOUCH_DOLLY_ROTATE;break;default:this.state=je.NONE}break;default:this.state=je.NONE}this.state!==je.NONE&&this.dispatchEvent(xl)}function $v(i){switch(this._trackPointer(i),this.state){case je.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case je.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case je.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case je.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=je.NONE}}function qv(i){this.enabled!==!1&&i.preventDefault()}function Yv(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function Zv(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}class Kv{constructor(e){this.host=e,this.renderer=new I_({antialias:!0,preserveDrawingBuffer:!0}),this.renderer.setPixelRatio(Math.min(2,window.devicePixelRatio)),this.canvas=this.renderer.domElement,this.canvas.tabIndex=0,this.canvas.setAttribute("role","img"),this.describe("The room"),this.labels.domElement.className="labels",e.append(this.canvas,this.labels.domElement),this.orbit=new Ov(this.camera,this.canvas),this.orbit.target=this.eye.target,this.orbit.zoomToCursor=!0,this.orbit.addEventListener("change",()=>this.draw());const t=new gc(16777215,2);t.position.set(-1,-2,3);const n=new gc(16777215,.7);n.position.set(2,1,-1),this.scene.add(t,n,new Bf(16777215,1.1)),new ResizeObserver(()=>this.resize()).observe(e),this.resize()}scene=new xf;eye=new yv;orbit;canvas;renderer;labels=new Q_;opaque=new Tn(1,1,{depthTexture:new bi(1,1,An)});beside=null;volumes=[];pending=!1;size=new Ee;drew=[];draw(){this.pending||(this.pending=!0,requestAnimationFrame(()=>{this.pending=!1,this.renderNow()}))}through(...e){this.volumes=e}split(e){const t=e===null!=(this.beside===null);this.beside=e,t&&(this.eye.comeNearer(e?.5:2),this.resize())}get camera(){return this.eye.camera}get halved(){return this.beside!==null}get designPart(){const{x:e,y:t}=this.size;return this.beside&&new _t(e/2,0,e/2,t)}renderNow(){const{x:e,y:t}=this.size,n=e/2;if(this.renderer.setScissorTest(this.beside!==null),this.beside){const{left:s,right:r}=this.beside;[s.visible,r.visible]=[!0,!1],this.renderPart(0,n,t),[s.visible,r.visible]=[!1,!0],this.renderPart(n,n,t)}else this.renderPart(0,e,t);this.labels.render(this.scene,this.camera);for(const s of this.drew)s()}renderPart(e,t,n){const{renderer:s,camera:r}=this;s.setViewport(e,0,t,n),s.setScissor(e,0,t,n);const a=this.volumes.filter(({mesh:o})=>Jv(o));if(a.length>0){const o=s.getPixelRatio(),l=new Ee(e,0).multiplyScalar(o).floor(),c=new Ee(t,n).multiplyScalar(o).floor();this.depthBelow(a,l,c),r.updateMatrixWorld();for(const h of a)h.prepare(r,this.opaque.depthTexture,l,c)}s.render(this.scene,r)}depthBelow(e,t,n){const{renderer:s,opaque:r}=this,{x:a,y:o}=s.getDrawingBufferSize(new Ee);r.setSize(a,o),r.viewport.set(t.x,t.y,n.x,n.y),r.scissor.set(t.x,t.y,n.x,n.y),r.scissorTest=!0;for(const{mesh:l}of e)l.visible=!1;s.setRenderTarget(r),s.render(this.scene,this.camera),s.setRenderTarget(null);for(const{mesh:l}of e)l.visible=!0}describe(e){this.canvas.setAttribute("aria-label",e)}background(e){this.scene.background=new Ue(e),this.draw()}lookThrough(e){this.eye.lookThrough(e),this.orbit.enabled=!1,this.draw()}look(e,t){this.eye.look(e,t),this.freely()}turn(e,t){this.eye.asDevice||(this.eye.turn(e,t),this.freely())}setOrthographic(e){this.eye.setOrthographic(e),!this.eye.asDevice&&this.freely()}freely(){this.orbit.object=this.camera,this.orbit.enabled=!0,this.orbit.update(),this.draw()}ray(e){const t=this.canvas.getBoundingClientRect(),n=this.beside?t.width/2:t.width,s=new Ee(2*((e.clientX-t.left)%n)/n-1,1-2*(e.clientY-t.top)/t.height),r=new gl;return r.setFromCamera(s,this.camera),r.params.Points={threshold:this.eye.size/60},r}resize(){const{clientWidth:e,clientHeight:t}=this.host;if(e===0||t===0)return;this.size.set(e,t),this.renderer.setSize(e,t);const n=this.beside?e/2:e;this.labels.setSize(n,t),this.labels.domElement.style.left=`${e-n}px`,this.eye.frame(n,t),this.draw()}}function Jv(i){for(let e=i;e;e=e.parent)if(!e.visible)return!1;return!0}const Ml=({min:i,max:e})=>i.map((t,n)=>(t+e[n])/2),Zo=()=>({slices:[!1,!1,!0],at:[0,0,0],slants:[],relief:!1,reliefPart:.2,cells:!1,through:{method:"none",over:"z",relief:0,power:2,radius:0},surface:!1,level:.35,body:"none",between:[0,.3],units:"auto",compare:"design",lattice:!1,sensitivity:"",blind:!1,sigmas:1,logarithmic:!1,map:"viridis",reversed:!1,low:null,high:null,frusta:!0,names:!0}),Ko=({between:[i,e]},t)=>[i===0?null:t.at(i),e===1?null:t.at(e)];function jv({azimuth:i,tilt:e}){const[t,n,s,r]=[Math.cos(i),Math.sin(i),Math.cos(e),Math.sin(e)];return{normal:[r*t,r*n,s],u:[-n,t,0],v:[-s*t,-s*n,r]}}function Qv(i,e){const{normal:t,u:n,v:s}=jv(i),r=(E,S)=>E[0]*S[0]+E[1]*S[1]+E[2]*S[2],a=[0,1,2,3,4,5,6,7].map(E=>[0,1,2].map(S=>(E>>S&1?e.max:e.min)[S])),o=a.map(E=>r(E,t)),l=Math.min(...o),c=l+i.part*(Math.max(...o)-l),h=[];if(a.forEach((E,S)=>[1,2,4].forEach(C=>{if(S&C)return;const A=a[S|C],[_,w]=[o[S]-c,o[S|C]-c];if(_*w>0||_===w)return;const I=_/(_-w);h.push(E.map((P,U)=>P+I*(A[U]-P)))})),h.length<3)return null;const d=E=>h.map(S=>r(S,E)),[u,m]=[d(n),d(s)],[g,v,f,p]=[Math.min(...u),Math.max(...u),Math.min(...m),Math.max(...m)];if(!(v-g>1e-9&&p-f>1e-9))return null;const x=(E,S,C)=>[0,1,2].map(A=>E*n[A]+S*s[A]+C*t[A]);return{origin:x(g,f,c),u:x(v-g,0,0),v:x(0,p-f,0)}}const Pu=({sensitivity:i,compare:e},{description:t})=>i?"sensitivity":e==="difference"&&t.pinned!==null?"difference":"field",Kr=()=>({description:null,around:{occluders:[],regions:[],surfaces:[],beacons:[]},field:null,slopes:null,difference:null,pinned:null,sections:null,shapes:null,through:null,lattice:null,blind:null,selected:null,body:null,asked:null,report:null}),ys=({room:{min:i,max:e}})=>Math.hypot(...e.map((t,n)=>t-i[n]));function ex(...i){const e=i.flatMap(({summary:{min:t,max:n}})=>t&&n?[t.value,n.value]:[]);return e.length===0?null:{min:Math.min(...e),max:Math.max(...e),largerIsBetter:i[0].largerIsBetter}}class Lu{constructor(e,t,n,s){this.viewing=t,this.place=n,this.stage=new Kv(e),this.design.add(this.fieldView.group,this.icons.group,this.probe.group,this.uncertainty),this.baseline.add(this.baselineView.group,this.baselineIcons.group),this.baseline.visible=!1,this.stage.scene.add(this.room.group,this.design,this.baseline),this.stage.through(this.fieldView.volume,this.baselineView.volume),this.gizmo=new Z_(this.stage,this.design,n??(()=>{}),s)}stage;gizmo;room=new av;design=new Tt;baseline=new Tt;uncertainty=new Tt;fieldView=new nh;icons=new sh;probe=new Uv;baselineView=new nh;baselineIcons=new sh;handle=new ht;sticking=!1;enlarged=0;latticeEnlarged=0;drawRoom({description:e,around:t,body:n},s){const{box:r,room:a}=e;return this.room.show(r,a,t,n,s),this.room.step}holdBody({around:e,body:t}){const n=[...e.occluders,...e.regions].find(s=>s.path===t);return!t||!n?!1:(this.gizmo.dragging||(this.design.add(this.handle),tx(this.handle,n),this.gizmo.hold(this.handle,n.size)),!0)}besides({pinned:e}){return this.viewing.compare==="beside"&&e!==null}get heldBody(){const{x:e,y:t,z:n}=this.handle.position,[s,r,a]=[0,1,2].map(l=>new T().setFromMatrixColumn(new Ge().makeRotationFromQuaternion(this.handle.quaternion),l)),o=l=>[s[l],r[l],a[l]];return{pose:{p:[e,t,n],R:[o("x"),o("y"),o("z")]}}}drawDevices(e,t){const{description:n,selected:s,pinned:r}=e;if(!n)return;if(this.gizmo.dragging){this.icons.move(n,this.sticking?null:s);return}const{frusta:a,names:o}=this.viewing;this.icons.show(n,{selected:s,frusta:a,labels:o},t),r&&this.baselineIcons.show(r.description,{selected:null,frusta:a,labels:!1},t);const l=n.devices.find(c=>c.name===s);this.holdBody(e)||this.gizmo.hold(!this.place||l?.surface||this.stage.eye.asDevice?null:this.icons.find(s))}drawProbe({asked:e,report:t,description:n},s){if(!e||!n)return this.probe.clear();this.enlarged=this.probe.show(e,t,ys(n),this.viewing.sigmas,s)}drawUncertainty({lattice:e,blind:t},n){for(const l of[...this.uncertainty.children])zs(l);const{viewing:s}=this;if(s.blind&&t&&this.uncertainty.add(ev(t,n.lost)),!s.lattice||!e||e.points.length===0)return;const r=ix(e.points.map(l=>l.at)),{group:a,scale:o}=tv(e,s.sigmas,r,n.edge,n.lost);this.latticeEnlarged=o,this.uncertainty.add(a)}coloured(e){const{viewing:t}=this,[n,s]=t.sensitivity?["sensitivity",e.slopes]:["difference",t.compare==="difference"?e.difference:null],r=s??e.field,a=ex(r,...this.besides(e)?[e.pinned.field]:[]),o=a&&(s?ts.ofDifference(a.min,a.max,a.largerIsBetter):ts.of(a,t));return{drawn:r,kind:s?n:"field",scale:o}}shapesAsked(e){if(!e.field||!e.description)return pd;const{viewing:t}=this,{drawn:n,kind:s,scale:r}=this.coloured(e),a=this.besides(e)?[s,"pinned"]:[s],o=r?a.flatMap(c=>this.shapesOf(c,n,r,ys(e.description))):[];if(r&&e.sections&&t.relief&&!t.sensitivity&&o.push(this.relief("sections",r,ys(e.description))),!t.cells||e.field.leaves===0)return{shapes:o};const l=t.slices.indexOf(!0);return{shapes:o,leaves:l<0?{}:{axis:l,at:t.at[l]}}}shapesOf(e,t,n,s){const{viewing:r}=this,a=[],o=l=>t.parts.some(c=>c.kind===l);if(o("grid")&&r.surface&&a.push({of:e,level:n.at(r.level)}),o("grid")&&r.body==="between"&&a.push({of:e,between:Ko(r,n)}),!r.relief)return a;if(o("grid"))for(const l of[0,1,2].filter(c=>r.slices[c]))a.push(this.relief(e,n,s,{axis:l,at:r.at[l]}));return o("plane")&&a.push(this.relief(e,n,s)),a}relief(e,t,n,s={}){const r=t.difference?0:t.min;return{of:e,relief:{...s,low:r,high:t.max,log10:t.logarithmic,size:this.viewing.reliefPart*n}}}drawField(e,t){const{viewing:n}=this,{drawn:s,scale:r}=this.coloured(e),a=this.besides(e),o=this.optionsOf(s,e.description.box),l=h=>(e.shapes?.meshes??[]).filter(({asked:d})=>d.of==="pinned"===h),c=n.sensitivity?null:e.sections;return this.fieldView.show(s,{...o,sections:c,through:this.throughOf(e),meshes:l(!1),leaves:e.shapes?.leaves??null},r,t.edge),a&&this.baselineView.show(e.pinned.field,{...o,meshes:l(!0)},r,t.edge),this.stage.split(a?{left:this.baseline,right:this.design}:null),this.baseline.visible=a,this.design.visible=!0,{drawn:s,scale:r,marks:r?this.marks(s,r):[]}}marks(e,t){const{viewing:n}=this;if(!e.parts.some(r=>r.kind==="grid"))return[];const s=n.body==="between"?Ko(n,t).filter(r=>r!==null):[];return[...n.surface?[t.at(n.level)]:[],...s]}throughOf(e){const{viewing:t}=this;return t.through.method!=="none"&&e.through?.of===Pu(t,e)?e.through:null}optionsOf(e,t){const{viewing:n}=this;return{slices:[0,1,2].filter(s=>n.slices[s]).map(s=>({axis:s,at:n.at[s]})),raised:n.relief,cloud:n.body==="volume"&&e.parts.some(s=>s.kind==="grid"),meshes:[],leaves:null,sections:null,through:null,box:t}}pick(e){const t=e.intersectObject(this.icons.group,!0).find(({object:a})=>"isMesh"in a&&!nx(a));if(t)return{device:this.icons.nameOf(t.object)};const n=this.fieldView.pick(e),s=this.room.pick(e);return s&&(!n||s.distance<e.ray.origin.distanceTo(new T(...n)))?{body:s.path}:n&&{at:n}}stepBeside({description:e}){return Number((.06*ys(e)).toPrecision(1))}hasIcon(e){return this.icons.find(e)!==null}lookThrough(e){this.gizmo.hold(null);for(const t of[this.icons,this.baselineIcons])t.hide(e.name);this.stage.lookThrough(e)}}function tx(i,{vertices:e,R:t}){const n=o=>e.filter((l,c)=>c%3===o).reduce(([l,c],h)=>[Math.min(l,h),Math.max(c,h)],[1/0,-1/0]);i.position.set(...[0,1,2].map(o=>(n(o)[0]+n(o)[1])/2));const[s,r,a]=t;i.quaternion.setFromRotationMatrix(new Ge().set(...s,0,...r,0,...a,0,0,0,0,1)),i.scale.set(1,1,1)}const nx=i=>i.material?.transparent===!0;function ix(i){const e=i[0];return Math.min(1/0,...i.slice(1).map(t=>Math.hypot(...t.map((n,s)=>n-e[s]))))||1}class ws extends Error{constructor(e,t){super(t),this.status=e}}async function Er(i,e,t){const n=await fetch(`/api/${i}`,{method:"POST",headers:{"Content-Type":"application/json"},body:JSON.stringify(e),...t?{signal:t}:{}});if(n.ok)return n;const s=await n.text();let r=s;try{const{error:a}=JSON.parse(s),o=a.findings.map(l=>l.message);r=o.length>0?o.join(`
`):a.message}catch{}throw new ws(n.status,r)}async function lh(){return(await fetch("/api/scenes")).json()}class Ps{constructor(e){this.name=e}static async open(e){const t=await(await Er("open",{scene:e})).json();return[new Ps(t.session),t]}static async resume(e){const t=new Ps(e);return[t,await t.ask("describe")]}async ask(e,t={},n){return(await Er(e,{session:this.name,...t},n)).json()}async bytes(e,t,n){return(await Er(e,{session:this.name,...t},n)).arrayBuffer()}async text(){return(await Er("text",{session:this.name})).text()}}const sx=2e4,ch={coarse:1500,full:1e4},rx=150;class ax{constructor(e,t,n){this.shown=e,this.viewing=t,this.heard=n}async draw(e,t){await this.fields(e,sx,ch.coarse,t),this.heard.drawn()}async rest(e,t){const{shown:n,viewing:s}=this;(n.field.level==="coarse"||this.sectionsAsked().length>0)&&(await this.fields(e,0,ch.full,t),this.heard.drawn()),this.pinned&&s.compare!=="difference"&&(n.difference=await this.field(e,"difference",{most:0},t),this.heard.drawn()),n.asked&&await this.point(e,n.asked,t),n.lattice=s.lattice?await e.ask("lattice",{most:rx},t):null,n.blind=s.blind?await e.ask("blind",{},t):null,(s.lattice||s.blind)&&this.heard.uncertain(),this.heard.valued(await e.ask("worth",{},t))}get lacking(){const{shown:e,viewing:t}=this;return t.lattice&&!e.lattice||t.blind&&!e.blind||this.pinned&&(t.compare==="difference"&&!e.difference||t.compare==="beside"&&!e.pinned)||e.field!==null&&JSON.stringify(this.throughAsked(e.field))!==this.throughKnown||t.sensitivity!==(e.slopes?.summary.sensitivity?.path??"")||JSON.stringify([this.sectionsAsked(),this.pinned&&t.compare==="difference"?{of:"difference"}:{}])!==this.sectionsKnown}sectionsKnown="[[],{}]";throughKnown="null";get pinned(){return this.shown.description.pinned!==null}sectionsAsked(){const{box:e}=this.shown.description;return this.viewing.slants.flatMap(t=>Qv(t,e)??[])}throughAsked(e){const{sensitivity:t,through:n}=this.viewing;return n.method==="none"||!e.parts.some(el)?null:{...n,of:Pu(this.viewing,this.shown),path:t}}async field(e,t,n,s){return Eh(await e.bytes(t,n,s))}async fields(e,t,n,s){const{shown:r,viewing:a}=this,o=await this.field(e,"field",{most:t},s),l=this.sectionsAsked(),c=this.pinned&&a.compare==="difference",h=c?{of:"difference"}:{},d=l.length>0?await this.field(e,"sections",{sections:l,most:n,...h},s):null;await this.slopes(e,t,s),c&&(r.difference=await this.field(e,"difference",{most:t},s)),this.pinned&&a.compare==="beside"&&await this.baseline(e,s);const u=this.throughAsked(o),m=u&&await this.through(e,{...u,most:t},s);[r.field,r.sections,this.sectionsKnown]=[o,d,JSON.stringify([l,h])],[r.through,this.throughKnown]=[m&&{...m,of:u.of},JSON.stringify(m&&u)],await this.shape(e,s)}async through(e,t,n){try{return await this.field(e,"through",t,n)}catch(s){if(!(s instanceof ws)||s.status!==422)throw s;return this.viewing.through.method="none",this.heard.refused(s),null}}async shape(e,t){const n=this.heard.shapes();this.shown.shapes=gd(n)?md(n):_d(await e.bytes("shapes",n,t),n)}reshaping=new AbortController;async reshape(e){if(tl(this.heard.shapes())!==(this.shown.shapes?.asked??"")){this.reshaping.abort(),this.reshaping=new AbortController;try{await this.shape(e,this.reshaping.signal),this.heard.drawn()}catch(t){if(!(this.reshaping.signal.aborted||t instanceof DOMException&&t.name==="AbortError"||t instanceof ws&&t.status===409))throw t}}}async slopes(e,t,n){const{shown:s,viewing:r}=this,a=r.sensitivity;if(!a)return void(s.slopes=null);try{s.slopes=await this.field(e,"sensitivity",{path:a,most:t},n)}catch(o){throw o instanceof ws&&o.status===422&&([r.sensitivity,s.slopes]=["",null]),o}}async baseline(e,t){if(this.shown.pinned)return;const n=await e.ask("pinned",{},t);this.shown.pinned={description:n,field:await this.field(e,"field",{most:0,of:"pinned"},t)}}async point(e,t,n){this.shown.report=await e.ask("point",{at:t},n),this.heard.answered()}}function ox(i){const e=i.key.toLowerCase(),t=i.shiftKey&&(e.length>1||/[a-z]/.test(e));return`${i.ctrlKey||i.metaKey?"ctrl+":""}${i.altKey?"alt+":""}${t?"shift+":""}${e}`}const Du=i=>i.split("+").filter(Boolean).map(e=>e[0].toUpperCase()+e.slice(1)).join(" ")||i,lx=i=>i instanceof HTMLInputElement&&i.type==="text"||i instanceof HTMLSelectElement||i instanceof HTMLTextAreaElement;function cx(i,e){document.addEventListener("keydown",t=>{if(document.querySelector("dialog[open]"))return;const{target:n}=t,s=lx(n),r=n instanceof HTMLInputElement&&s&&n.value!==n.defaultValue,a=ox(t);if(s&&(r||!a.startsWith("ctrl+")))return;if(!s&&e(t))return t.preventDefault();const o=i.find(l=>l.keys.includes(a)&&(l.ready?.()??!0));o&&(t.preventDefault(),o.run())})}function Nu(i){const[e,t,n]=i,s=new Ge().set(...e,0,...t,0,...n,0,0,0,0,1),r=new _n().setFromRotationMatrix(s,"ZYX");return[r.x,r.y,r.z]}function Iu([i,e,t]){const{w:n,x:s,y:r,z:a}=new pt().setFromEuler(new _n(i,e,t,"ZYX"));return[n,s,r,a]}const hh=["x","y","z"];class hx{constructor(e){this.hand=e}mode=null;device=null;axis=0;constrained=!1;local=!1;text="";gesture="";changed=!1;begin(e,t){this.end(),t?.pose&&([this.mode,this.device,this.text,this.changed]=[e,t,"",!1],this.axis=e==="translate"?0:2,this.local=this.constrained=!1,this.gesture=mn(),this.show())}end(){this.mode&&this.hand.say(""),this.mode=null}take({key:e,ctrlKey:t,metaKey:n,altKey:s}){if(!this.mode||t||n||s)return!1;const r=hh.indexOf(e.toLowerCase());if(r>=0)this.constrain(r);else if(/^[-\d.]$/.test(e))this.type(this.text+e);else if(e==="Backspace")this.type(this.text.slice(0,-1));else if(e==="Enter")this.end();else if(e==="Escape")this.cancel();else return!1;return!0}constrain(e){this.local=e===this.axis&&this.constrained&&!this.local,this.constrained=!0,this.axis=e,this.type(this.text)}cancel(){this.changed&&this.hand.back(),this.end()}type(e){this.text=e,this.show();const t=Number(e);if(e===""||!Number.isFinite(t))return;this.changed=!0;const{p:n,R:s}=this.device.pose,r=this.local?new T(...s.map(d=>d[this.axis])):new T().setComponent(this.axis,1);if(this.mode==="translate"){const d=new T(...n).addScaledVector(r,t).toArray();return this.hand.place({p:d.map(u=>Number(u.toFixed(6)))},this.gesture)}const a=new pt().setFromAxisAngle(r,t*Math.PI/180),{w:o,x:l,y:c,z:h}=a.multiply(ux(this.device));this.hand.place({q:[o,l,c,h]},this.gesture)}show(){const e=this.mode==="translate"?"Move along":"Turn about",t=this.mode==="translate"?"m":"°",n=this.local?" of the device":"";this.hand.say(`${e} ${hh[this.axis]}${n}: ${this.text||"…"} ${t}   X, Y, Z choose the axis, twice for the device's own; Enter, Esc`)}}function ux(i){const[e,t,n,s]=Iu(Nu(i.pose.R));return new pt(t,n,s,e)}class dx{constructor(e,t,n,s,r){this.layout=e,this.picture=t,this.shown=n,this.rooming=s,this.steps=r,this.typed=new hx({place:(a,o)=>this.place(a,o),back:()=>r.undo(),say:a=>e.handSays(a)})}typed;snapping={on:!1,turning:!1};get held(){return this.picture.hasIcon(this.shown.selected)||this.shown.body!==null}end(){this.typed.end()}take(e){return this.rooming.take(e)||this.picture.gizmo.take(e,()=>this.steps.undo())||this.typed.take(e)}move(e){const{picture:t,shown:n}=this;t.gizmo.use(e),this.layout.gizmoMode(e,this.held);const s=n.body?t.heldBody:n.description.devices.find(r=>r.name===n.selected);(!n.body||e==="translate")&&this.typed.begin(e,s??null)}drag({ray:e,...t},n){const{on:s,turning:r}=this.snapping,a=s&&t.p?{stick:{turn:r,...e?{ray:e}:{}}}:{};this.place({...t,...a},n)}place(e,t){const{body:n,selected:s}=this.shown,{stick:r,...a}=e;n?this.rooming.shape(a,t):s&&this.steps.change(`place ${s}`,"place",{device:s,gesture:t,...e})}snap(){this.set({on:!this.snapping.on})}turnToFaces(){this.set({on:!0,turning:!this.snapping.turning})}set(e){Object.assign(this.snapping,e);const{on:t,turning:n}=this.snapping;this.picture.gizmo.snap(t),this.picture.sticking=t,this.layout.snapping(t,t&&n)}}function y(i,e={},...t){const n=document.createElement(i);for(const[s,r]of Object.entries(e))r!=null&&(/^(aria-|data-|role$|for$)/.test(s)?n.setAttribute(s,String(r)):n[s]=r);return n.append(...t.filter(s=>s!==null&&s!==!1)),n}const fx={undo:"M5 3 2 6l3 3M2 6h7a4 4 0 0 1 0 8H6",redo:"M11 3l3 3-3 3M14 6H7a4 4 0 0 0 0 8h3",save:"M8 2v8M5 7l3 3 3-3M2 12v2h12v-2",open:"M2 13V3h4l2 2h6v8z",theme:"M8 2a6 6 0 1 0 0 12zM8 2a6 6 0 0 1 0 12",help:"M6 6a2 2 0 1 1 2.6 1.9c-.4.2-.6.5-.6 1.1v.5M8 12v.5",move:"M8 1v14M1 8h14M8 1 6 3M8 1l2 2M8 15l-2-2M8 15l2-2M1 8l2-2M1 8l2 2M15 8l-2-2M15 8l-2 2",turn:"M13 5A6 6 0 1 0 14 9M13 1v4H9",fit:"M2 6V2h4M10 2h4v4M14 10v4h-4M6 14H2v-4",close:"M3 3l10 10M13 3 3 13"};function px(i){const e="http://www.w3.org/2000/svg",t=document.createElementNS(e,"svg");t.setAttribute("viewBox","0 0 16 16"),t.setAttribute("aria-hidden","true");const n=document.createElementNS(e,"path");return n.setAttribute("d",fx[i]),t.append(n),t}function bt(i,e,t,n="icon"){return y("button",{type:"button",className:n,title:e,"aria-label":e,onclick:t},px(i))}const Ls=(i,e,...t)=>y("details",{open:e,className:"part"},y("summary",{},i),...t);function In(i,e,t){const n=y("input",{type:"checkbox",id:i,onchange:()=>t(n.checked)});return[y("label",{htmlFor:i},n,e),n]}function ns(i,e,t,n){const s=y("select",{id:i,onchange:()=>n(s.value)},...Object.entries(t).map(([r,a])=>y("option",{value:r},a)));return[y("div",{className:"pair"},y("label",{htmlFor:i},e),s),s]}const Uu={none:"no","natural-neighbour":"natural neighbours",linear:"linear",nearest:"nearest","inverse-distance":"inverse distance","minimum-curvature":"minimum curvature"};class mx{constructor(e,t){this.viewing=e;const n=f=>{Object.assign(e.through,f),t()},[s,r]=ns("through-method","As a surface",Uu,f=>n({method:f})),[a,o]=ns("through-over","over",{z:"x and y",y:"x and z",x:"y and z"},f=>n({over:f})),l=(f,p,x)=>{const E=y("input",{type:"text",id:f,spellcheck:!1,autocomplete:"off",onchange:()=>x(E.value)});return[y("div",{className:"pair"},y("label",{htmlFor:f},p),E),E]},c=f=>p=>{const x=Zi(p,"m");x>=0?n({[f]:x}):t()},[h,d]=l("through-relief","greatest lifted by",c("relief")),[u,m]=l("through-radius","radius (0: none)",c("radius")),[g,v]=l("through-power","power",f=>{const p=Number(f);p>=1&&p<=20?n({power:p}):t()});[this.method,this.over,this.relief,this.radius,this.power]=[r,o,d,m,v],this.weights=y("div",{},g,u),this.how=y("div",{},a,h,this.weights,this.words),this.element=y("div",{},s,this.how)}element;method;over;relief;power;radius;how;weights;words=y("p",{className:"hint",id:"through-words"});show(e,t){const{through:n}=this.viewing;this.element.hidden=!e.parts.some(el),this.how.hidden=n.method==="none",this.weights.hidden=n.method!=="inverse-distance",this.method.value=n.method,this.over.value=n.over;const s=(c,h)=>document.activeElement===c||(c.value=h);s(this.relief,Re(n.relief,"m")),s(this.radius,Re(n.radius,"m")),s(this.power,String(n.power));const r=t?.through;if(!r)return void(this.words.textContent="");const{unit:a}=t.metric,o=r.min===null?"blind":`${Re(r.min,a)} to ${Re(r.max,a)}`,l=r.blind>0?`, ${Is(r.blind/r.places)} blind`:"";Object.assign(this.words.dataset,{method:r.method,min:r.min??"",max:r.max??"",places:r.places,blind:r.blind}),this.words.textContent=`Between ${Bt(r.samples,"sample")}: ${o}${l}`}}const gx=Object.keys(Uu),_x=["none","volume","between"],vx=["design","difference","beside"],xx=[["corner","f","Look at the whole room"],["top","7","Look from above"],["below","ctrl+7","Look from below"],["front","1","Look from the front"],["back","ctrl+1","Look from the back"],["side","3","Look from the right"],["left","ctrl+3","Look from the left"]],$a=(i,e)=>i[(i.indexOf(e)+1)%i.length];function Mx(i){const{viewing:e,hasScene:t,hasDevice:n,hasPin:s}=i,r=(d,u,m)=>({name:d,keys:u,ready:t,run:()=>{m(),i.viewed()}}),a=(d,u,m)=>r(d,u?[u]:[],()=>e[m]=!e[m]),o=(d,u,m)=>({name:d,keys:u,run:m,ready:n}),l=(d,u,m)=>({name:d,keys:u,run:m,ready:()=>n()||i.hasBody()}),c=(d,u,m)=>({name:d,keys:u,run:m,ready:t}),h=d=>()=>e.level=Math.min(1,Math.max(0,e.level+d));return[{name:"All commands",keys:["ctrl+k","/"],run:i.commands},c("Undo",["ctrl+z"],i.undo),c("Redo",["ctrl+y","ctrl+shift+z"],i.redo),{name:"Open a scene",keys:["o"],run:i.open},c("Save as a scene file",["ctrl+s"],i.save),c("Choose the next device",["j"],()=>i.next(1)),c("Choose the device before",["k"],()=>i.next(-1)),c("Let go",["escape"],i.letGo),c("Add a device",["a"],i.add),o("Copy the chosen device",["d"],i.copy),o("Copy the chosen device along a row or around a circle",["shift+d"],i.array),o("Mirror the chosen device across x",["m"],()=>i.mirror("x")),o("Mirror the chosen device across y",["shift+m"],()=>i.mirror("y")),o("Remove the chosen device",["delete"],i.remove),l("Move the chosen device or body",["g"],()=>i.move("translate")),l("Turn the chosen device, size the chosen box",["r"],()=>i.move("rotate")),o("Look through the chosen device",["0"],i.lookThrough),c("Snap to 5 cm, 5 degrees and faces",["n"],i.snap),c("Turn a device to the face that it snaps to, or not",["t"],i.turnToFaces),c("The room: open, close",["w"],i.room),c("Draw a box on the slice or the floor",["shift+b"],i.paint),c("Choose the next body or region",["shift+j"],()=>i.nextBody(1)),c("Choose the body or region before",[],()=>i.nextBody(-1)),...xx.map(([d,u,m])=>c(m,[u],()=>i.look(d))),c("Without perspective, or with",["5"],i.orthographic),...["x","y","z"].map((d,u)=>c(`Slice across ${d}`,[d],()=>i.slice(u))),c("Add a slanted slice",["shift+x"],i.slant),a("Heights: slices as high as their values","h","relief"),a("Octree cells","shift+c","cells"),a("Surface","i","surface"),r("Raise the level of the surface",["]"],h(.02)),r("Lower the level of the surface",["["],h(-.02)),r("Samples as a surface: by the next method",["shift+i"],()=>e.through.method=$a(gx,e.through.method)),r("Volume: not drawn, a cloud, between two values",["v"],()=>e.body=$a(_x,e.body)),a("Logarithmic colours","l","logarithmic"),a("Dark is good","","reversed"),a("Ellipsoids and lost directions","e","lattice"),a("Blind regions","b","blind"),a("Frusta","shift+f","frusta"),a("Names","shift+n","names"),c("Pin this design, or unpin",["p"],()=>i.pin(!s())),{...r("Compare: the design, the difference, side by side",["c"],()=>e.compare=$a(vx,e.compare)),ready:s},c("Search for a better design: open, close",["s"],i.search),c("Begin the search",["ctrl+enter"],i.beginSearch),c("Pause the search, or go on",["shift+s"],i.pauseSearch),c("Keep the best that the search found",["shift+k"],i.keepSearch),c("Take back what the search found",["shift+r"],i.rejectSearch),{name:"Dark or light",keys:["shift+t"],run:i.theme},{name:"Keys and mouse",keys:["?"],run:i.help}]}class Fu{element;title=y("div",{className:"bar-title"});strip=y("div",{className:"strip"});ticks=y("div",{className:"ticks"});blind=y("div",{className:"blind-key"});constructor(){this.element=y("figure",{className:"colour-bar",id:"colour-bar","aria-label":"Colour bar"},this.title,y("div",{className:"bar-body"},this.strip,this.ticks),this.blind)}show(e,t,n,s){const{summary:r}=e;this.element.dataset.min=t?String(t.min):"",this.element.dataset.max=t?String(t.max):"",this.element.dataset.level=e.level;const a=r.samples-r.finite,{gained:o,lost:l}=r,c=(S,C)=>[y("span",{className:S,"aria-hidden":"true"}),C];if(this.blind.replaceChildren(...o===void 0||l===void 0?c("hatch",a>0?`blind: ${a} of ${r.samples}`:"blind: none"):[...c("hatch",`${r.sensitivity?"no slope":"blind in both"}: ${a-o-l}`),...c("hatch gained",`seen only ${r.sensitivity?"with more":"now"}: ${o}`),...c("hatch lost",`seen only ${r.sensitivity?"with less":"before"}: ${l}`)]),!t){this.title.replaceChildren(y("b",{},r.metric.name)," is finite nowhere"),this.strip.style.background="",this.ticks.replaceChildren();return}const h=Ns(t.max,r.metric.unit),{name:d,of:u}=fd(t.difference&&s==="log10"?"si":s,t.max,r.metric.unit);this.title.replaceChildren(r.sensitivity?"slope of ":t.difference?"change of ":"",y("b",{},r.metric.name),d?` in ${wh(d)}`:"");const m=Array.from({length:25},(S,C)=>t.css(t.at(C/24)));this.strip.style.background=`linear-gradient(to top, ${m.join(", ")})`;const g=(S,C,A)=>{const _=y("span",{className:C},A);return _.style.bottom=`${100*t.part(S)}%`,_},v=t.max>t.min?[t.min,t.max]:[t.min],f=[...t.difference?[0]:[],...n],p=S=>C=>S.every(A=>Math.abs(t.part(C)-t.part(A))>.06),E=(s==="log10"&&t.min>0?t.powers():t.ticks(h.factor)).filter(p([...v,...f]));this.ticks.replaceChildren(...E.map(S=>g(S,"tick",u(S))),...v.filter(p(f)).map(S=>g(S,"tick end",u(S))),...t.difference?[g(0,"level zero","0")]:[],...n.map(S=>g(S,"level",u(S))))}}const Ou=1e-6,Bi=(i,e)=>Math.max(0,i.blinded/Math.max(1,e)+Math.max(0,i.rise??0));function uh(i,e){const t=i.rise??0,n=Math.abs(t)<Ou?"":`the mean of ${e} gets ${t>0?"worse":"better"} by ${Is(Math.abs(t))}`,s=i.blinded>0?`${Bt(i.blinded,"sample")} more go blind`:"";return[n,s].filter(Boolean).join(" and ")}class Bu{constructor(e,t){this.select=e,this.element=y("section",{className:"panel grow"},y("header",{},y("h2",{},"Devices"),t&&y("button",{type:"button",id:"add-device",title:"Add a device (A)",onclick:t},"Add…")),this.verdict,this.list)}element;list=y("ul",{className:"devices","aria-label":"Devices"});verdict=y("p",{className:"verdict",id:"verdict",role:"status"});worth=null;description=null;selected=null;show(e,t){const n=a=>a&&[a.name,a.metric.name,...a.devices.map(o=>o.name)].join(`
`),s=n(e)!==n(this.description);s&&(this.worth=null);const r=!s&&t===this.selected;this.description=e,this.selected=t,r||this.render()}value(e){this.worth=e,this.element.dataset.stale="false",this.render()}unweighed(){this.verdict.hidden=!0,this.element.dataset.weighed="false"}stale(){this.element.dataset.stale="true"}verdictOn(e,t){if(this.worth?.devices.length===0)return["Its only device is worth all."];if(e.length===0)return[];const n=uh(e[0],t)||"nothing changes",s=e.slice(0,4).flatMap((r,a)=>[a>0?", ":"",y("b",{},r.name)]);return e.length===1?[...s," is worth least: without it ",n,"."]:[...s,e.length>4?", … ":" ","are worth least, each the same: without it ",n,"."]}render(){if(!this.description)return;const{devices:e,metric:t}=this.description,n=this.list.contains(document.activeElement),s=new Map(this.worth?.devices.map(c=>[c.name,c])),r=this.worth?.samples??1,[a]=[...s.values()].sort((c,h)=>Bi(c,r)-Bi(h,r)),o=Math.max(1e-12,...[...s.values()].map(c=>Bi(c,r))),l=a?[...s.values()].filter(c=>Bi(c,r)-Bi(a,r)<Ou):[];this.verdict.replaceChildren(...this.verdictOn(l,t.name)),this.verdict.dataset.least=a?.name??"",this.list.replaceChildren(...e.map(c=>{const h=s.get(c.name),d=y("span",{className:"bar","aria-hidden":"true"});h&&d.style.setProperty("--part",String(Bi(h,r)/o));const u=h?`Without ${c.name} ${uh(h,t.name)||"nothing changes"}`:c.type,m=y("button",{type:"button",title:u,className:h&&l.includes(h)?"least":"","aria-pressed":String(c.name===this.selected),"data-device":c.name,onclick:()=>this.select(c.name===this.selected?null:c.name)},y("span",{className:"name"},c.name),y("span",{className:"type"},c.type.replaceAll("_"," ")),d);return y("li",{},m)})),n&&this.list.querySelector(`[data-device="${CSS.escape(this.selected??"")}"]`)?.focus()}}class yx{constructor(e){this.add=e,this.element=y("dialog",{className:"start","aria-label":"Add a device"},bt("close","Close",()=>this.element.close()),y("h1",{},"Add a device"),y("p",{className:"lead"},"It stands at the chosen point, or above the middle of the samples, and looks at their middle. What it needs to know has first values, which you then change."),this.grid)}element;grid=y("div",{className:"scenes types"});show({types:e,presets:t}){this.grid.replaceChildren(...e.map(({id:n,summary:s,ready:r})=>y("div",{className:"type-card"},this.button(n,"",n.replaceAll("_"," "),s,r),...t.filter(a=>a.type===n).map(a=>this.button(n,a.name,a.name,a.source,!0))))),this.element.open||this.element.showModal(),this.grid.querySelector("button")?.focus()}button(e,t,n,s,r){return y("button",{type:"button",className:t?"preset":"",disabled:!r,title:s,"data-type":e,"data-preset":t,onclick:()=>{this.element.close(),this.add(e,t)}},y("b",{},n),t?null:y("span",{},s))}}const bx=["x","y","z"];class Sx{constructor(e){this.make=e;const t=y("form",{method:"dialog",onsubmit:n=>this.submit(n)},this.title,y("div",{className:"pair"},y("label",{htmlFor:"array-copies"},"Copies"),this.copies),y("label",{htmlFor:"array-circle"},this.circle,"around a circle"),this.words,y("div",{className:"row wide"},...this.numbers),this.problem,y("button",{type:"submit"},"Make them"));this.element=y("dialog",{className:"help","aria-label":"Array of devices"},bt("close","Close",()=>this.element.close()),t)}element;title=y("h2");copies=y("input",{type:"text",id:"array-copies",inputMode:"numeric"});circle=y("input",{type:"checkbox",id:"array-circle",onchange:()=>this.begin()});words=y("p",{className:"hint"});numbers=bx.map(e=>y("input",{type:"text",className:"level","aria-label":e,spellcheck:!1}));problem=y("p",{className:"hint",role:"alert"});description=null;show(e,t){this.description=e,this.title.textContent=`${t}, more times`,this.copies.value="3",this.circle.checked=!1,this.begin(),this.element.showModal(),this.copies.select()}begin(){const e=this.circle.checked;this.words.textContent=e?"Evenly around the upright axis through this point, each turned with it:":"Each so far from the one before:";const{box:t}=this.description,n=e?Ml(t):[1,0,0];this.numbers.forEach((s,r)=>s.value=`${Number(n[r].toFixed(3))} m`),this.problem.textContent=""}submit(e){e.preventDefault();const t=this.numbers.map(s=>Zi(s.value,"m")),n=Number(this.copies.value);t.every(Number.isFinite)?!Number.isInteger(n)||n<1?this.problem.textContent="Copies are a whole number from 1 on.":(this.element.close(),this.make(this.circle.checked?{copies:n,around:t}:{copies:n,by:t})):this.problem.textContent="Lengths are such as 0.5 m or 20 cm."}}function wx(i){const e=/^\s*([\w.*+-][^=]*?)\s*=\s*(.+?)\s*$/.exec(i);return e?{path:e[1],value:e[2]}:null}class Ex{constructor(e,t){this.commands=e,this.set=t,this.box=y("input",{type:"text",placeholder:"A command, or PATH = VALUE of the scene","aria-label":"Command","aria-controls":"commands",role:"combobox","aria-expanded":"true",spellcheck:!1,autocomplete:"off",oninput:()=>this.search(),onkeydown:n=>this.key(n)}),this.element=y("dialog",{className:"command","aria-label":"Commands"},this.box,this.list)}element;box;list=y("ul",{className:"commands",role:"listbox",id:"commands","aria-label":"Commands"});found=[];chosen=0;show(){this.box.value="",this.search(),this.element.showModal(),this.box.focus()}search(){const e=this.box.value.toLowerCase().split(/\s+/).filter(Boolean),t=wx(this.box.value);this.found=t?[{name:`Set ${t.path} to ${t.value}`,keys:[],run:()=>this.set(t)}]:this.commands.filter(n=>(n.ready?.()??!0)&&e.every(s=>n.name.toLowerCase().includes(s))),this.chosen=0,this.render()}render(){this.list.replaceChildren(...this.found.map((e,t)=>y("li",{role:"option",id:`command-${t}`,"aria-selected":String(t===this.chosen),onclick:()=>this.run(e)},y("span",{},e.name),y("kbd",{},e.keys[0]?Du(e.keys[0]):"")))),this.box.setAttribute("aria-activedescendant",this.found.length>0?`command-${this.chosen}`:""),this.list.children[this.chosen]?.scrollIntoView({block:"nearest"})}key(e){const t={ArrowDown:1,ArrowUp:-1}[e.key];if(t&&this.found.length>0)this.chosen=(this.chosen+t+this.found.length)%this.found.length,this.render();else if(e.key==="Enter"&&this.found[this.chosen])this.run(this.found[this.chosen]);else return;e.preventDefault()}run(e){this.element.close(),e.run()}}const Tx=[["design","design","The design alone"],["difference","difference","The design minus what is pinned"],["beside","side by side","What is pinned at the left, the design at the right"]];class ku{constructor(e,t,n){this.viewing=e,this.pin=y("button",{type:"button",id:"pin",title:"Keep this design to compare with (P)",hidden:!n,onclick:()=>n?.(!this.pinned)},"Pin"),this.buttons=Tx.map(([s,r,a])=>y("button",{type:"button",title:a,"data-compare":s,onclick:()=>{e.compare=s,t()}},r)),this.group=y("div",{className:"segments three",role:"group","aria-label":"Compare"},...this.buttons),this.element=y("div",{className:"compare"},this.pin,this.group,this.words)}element;pin;buttons;group;words=y("p",{className:"difference",id:"difference",role:"status"});pinned=!1;show(e,t){if(this.pinned=e,this.pin.textContent=e?"Unpin":"Pin",this.pin.setAttribute("aria-pressed",String(e)),this.group.hidden=!e,this.buttons.forEach(g=>g.setAttribute("aria-pressed",String(g.dataset.compare===this.viewing.compare))),this.words.hidden=!e||!t,!e||!t)return;const{mean:n,min:s,max:r,metric:a,better:o,gained:l,lost:c,definition:h,pinned_definition:d}=t,u=g=>`${g!==null&&g>0?"+":""}${Re(g,a.unit)}`,m=(g,v,f)=>y("span",{"data-difference":g,"data-value":v??""},`${g} `,y("b",{},f));this.words.replaceChildren(this.pin.hidden?"against the design before: ":"against what is pinned: ",m("mean",n,u(n)),...s&&r?[" from ",m("least",s.value,u(s.value))," to ",m("greatest",r.value,u(r.value))]:[],", ",m("better",o,Is(o??0)),", ",m("gained",l,String(l)),", ",m("lost",c,String(c)),d?y("b",{className:"unlike"},`. Not alike: of the ${h}, what is pinned of the ${d}`):`; of the ${h}`)}}let Ax=0;const qa=1e3;function Rx(i,e){const t=i.lower??-1/0,n=i.upper??1/0;if(!i.logarithmic){const s=Math.max(1,2*Math.abs(e));return{low:Number.isFinite(t)?t:e-s,high:Number.isFinite(n)?n:e+s,log:!1}}return e>0?{low:Math.max(t,e/8),high:Math.min(n,e*8),log:!0}:{low:Math.max(t,0),high:Math.min(n,1),log:!1}}class yl{constructor(e,t){this.spec=e,this.value=t,this.range=Rx(e,t);const n=`number-${++Ax}`,{low:s,high:r}=this.range,a=`${Re(s,e.unit)} to ${Re(r,e.unit)}`;this.as=o=>e.display??Ns(o,e.unit),this.slider=y("input",{type:"range",min:"0",max:String(qa),step:"1","aria-label":`${e.label}, ${a}`,title:a,oninput:()=>this.slide(),onchange:()=>this.gesture=""}),this.box=y("input",{type:"text",id:n,spellcheck:!1,autocomplete:"off",onchange:()=>this.type(),onkeydown:o=>{o.key==="Escape"&&this.reset()}}),this.element=y("div",{className:"number"},y("label",{htmlFor:n,title:e.help},e.label),this.slider,this.box),this.show()}element;slider;box;range;as;gesture="";sent="";update(e){this.value=e,this.show()}shown(){return Br(this.value,this.spec.unit,this.as(this.value))}show(){const{low:e,high:t,log:n}=this.range,s=n?Math.log(this.value/e)/Math.log(t/e):(this.value-e)/(t-e);this.gesture===""&&(this.slider.value=String(Math.round(qa*s)));const{box:r}=this;(!(document.activeElement===r&&r.value!==r.defaultValue)||r.value.trim()===this.sent)&&this.reset(),this.slider.setAttribute("aria-valuetext",Re(this.value,this.spec.unit,4))}reset(){this.sent="",this.box.value=this.box.defaultValue=this.shown()}slide(){this.gesture===""&&(this.gesture=mn());const{low:e,high:t,log:n}=this.range,s=Number(this.slider.value)/qa,r=n?e*(t/e)**s:e+s*(t-e),a=Math.min(t,Math.max(e,Number(r.toPrecision(4))));this.value=a,this.reset(),this.spec.set(String(a),this.gesture)}type(){const e=this.box.value.trim();e===""?this.reset():(this.sent=e,this.spec.set(e,""))}}const bl=["x","y","z"],zu={"":[],aim:bl,rpy:["roll","pitch","yaw"],quaternion_wxyz:["w","x","y","z"]},Sl={aim:"looks at",rpy:"turned by",quaternion_wxyz:"turned by","":""},Hu={name:"m",factor:1};function Ds(i,e,t,n,s){const r=(o,l)=>n([{path:t,value:o}],l),a=new yl({...s,set:r},i(e));return{element:a.element,update:o=>a.update(i(o))}}const Gu=i=>Array.isArray(i)?`[${i.map(e=>Gu(e)).join(", ")}]`:String(i??"");function Cx(i,e,t,n){const s=`text-${t}`,r=()=>n([{path:t,value:a.value}],""),a=i.kind==="choice"?y("select",{id:s,onchange:r},...i.choices.split("|").map(c=>y("option",{value:c},c))):y("input",{id:s,type:"text",spellcheck:!1,autocomplete:"off",onchange:r}),o=c=>{(document.activeElement!==a||i.kind==="choice")&&(a.value=Gu(c.params[i.name]))};o(e);const l=y("label",{htmlFor:s,title:i.help},i.name);return{element:y("div",{className:"number wide"},l,a),update:o}}function Px(i,e,t){const n=`devices.${e.name}.params.${i.name}`;return i.kind!=="number"?Cx(i,e,n,t):Ds(s=>s.params[i.name],e,n,t,{label:i.name,help:i.help,unit:i.unit,lower:i.lower,upper:i.upper,logarithmic:i.scale==="log"||i.upper===null||i.lower===0})}function Lx(i,e,t){const n=`devices.${i.name}`,s=Math.max(...e.max.map((a,o)=>a-e.min[o]),.001),r=a=>({lower:a-s/2,upper:a+s/2});return i.coordinates?i.coordinates.map((a,o)=>Ds(l=>l.coordinates[o],i,`${n}.coordinates.${o}`,t,{label:`${i.surface} ${o}`,help:"Where on its surface it is mounted, from 0 to 1",unit:"1",lower:0,upper:1,logarithmic:!1})):bl.map((a,o)=>Ds(l=>l.at[o],i,`${n}.at.${a}`,t,{label:a,help:`Its place along ${a}${i.group?`, in the frame of ${i.group}`:""}`,unit:"m",display:Hu,...r(i.at[o]),logarithmic:!1}))}function Dx(i,e){const t=n=>Nu(n.pose.R);return zu.rpy.map((n,s)=>{const r=new yl({label:n,help:`${Sl.rpy}, ${n}`,unit:"rad",lower:-Math.PI,upper:Math.PI,logarithmic:!1,set:(l,c)=>{const h=/^\s*(\S+)\s*deg\s*$/.exec(l),d=h?Number(h[1])*Math.PI/180:Number(l);if(!Number.isFinite(d))return r.update(t(a)[s]);const u=t(a);u[s]=d,e({q:Iu(u)},c)}},t(i)[s]);let a=i;const o=l=>r.update(t(a=l)[s]);return{element:r.element,update:o}})}function Nx(i,e,t,n){const s=i.facing;if(s==="")return[];if(s==="quaternion_wxyz"&&i.pose)return Dx(i,n);const r=Math.max(...e.max.map((o,l)=>o-e.min[l]),.001),a={aim:o=>[o-r,o+r],rpy:()=>[-Math.PI,Math.PI],quaternion_wxyz:()=>[-1,1]}[s];return zu[s].map((o,l)=>{const[c,h]=a(i.value[l]);return Ds(d=>d.value[l],i,`devices.${i.name}.${s}.${o}`,t,{label:o,help:`${Sl[s]}, ${o}`,unit:{aim:"m",rpy:"rad",quaternion_wxyz:"1"}[s],...s==="aim"?{display:Hu}:{},lower:c,upper:h,logarithmic:!1})})}const Ya=(i,e)=>e.length>0&&y("section",{className:"fields","aria-label":i},y("h3",{},i),...e.map(t=>t.element)),Ix={"":1,m:1,cm:.01,mm:.001,ft:.3048,in:.0254};function Ux(i){const e=/^\s*([-+.\de]+)\s*([a-z]*)\s*$/i.exec(i);return e?Number(e[1])*(Ix[e[2]]??NaN):NaN}function Fx(i,e,t){const n=`devices.${e.name}.`,s=bl.indexOf(/^at\.([xyz])$/.exec(i.path.slice(n.length))?.[1]??""),r=s<0?NaN:Ux(i.value)-e.at[s];return t.filter(a=>a.type===e.type).map(a=>({path:`devices.${a.name}.${i.path.slice(n.length)}`,value:Number.isFinite(r)?String(Number((a.at[s]+r).toFixed(6))):i.value}))}class Ox{constructor(e,t,n){this.changeOne=e,this.place=t,this.whole=n}element=y("div",{className:"inspector"});all=y("input",{type:"checkbox",id:"all-of-type"});description=null;device=null;fields=[];shown="";change=(e,t)=>{const{device:n}=this,s=n&&this.all.checked&&!/\.(aim|rpy|quaternion_wxyz|coordinates)\./.test(e[0].path);this.changeOne(s?e.flatMap(r=>Fx(r,n,this.description.devices)):e,t)};show(e,t){const n=e.devices.find(h=>h.name===t);this.description=e,this.device=n??null;const s=n?`${n.name} ${n.type} ${n.facing} ${e.name}`:"";if(s!==""&&s===this.shown){for(const h of this.fields)h.update(n);return}if(this.shown=s,this.all.checked=!1,!n){this.fields=[],this.element.replaceChildren(y("p",{className:"hint"},"Choose a device in the list or in the picture to change it."));return}const r=e.types[n.type],a=Lx(n,e.room,this.change),o=Nx(n,e.room,this.change,this.place),l=Ds(h=>h.rate,n,`devices.${n.name}.rate`,this.change,{label:"rate",help:"Updates a second",unit:"1/s",lower:null,upper:null,logarithmic:!0}),c=r.params.map(h=>Px(h,n,this.change));this.fields=[...a,...o,l,...c],this.element.replaceChildren(y("header",{},y("h2",{},n.name),y("p",{className:"type"},r.id)),y("p",{className:"summary"},r.summary),this.actionsOn(),...this.allOf(e,n),Ya(n.mount==="target"?"Place on the target":"Place",a)||"",Ya(Sl[n.facing],o)||"",Ya("Readings",[l,...c])||"")}actionsOn(){const{copy:e,array:t,mirror:n,remove:s}=this.whole,r=(a,o,l)=>y("button",{type:"button",title:o,onclick:l},a);return y("div",{className:"actions",role:"group","aria-label":"This device"},r("Copy","Once more, beside it (D)",e),r("Array…","More times, along a row or around a circle (Shift D)",t),r("Mirror x","Once more, mirrored across x through the middle of the samples (M)",()=>n("x")),r("Mirror y","Once more, mirrored across y through the middle of the samples (Shift M)",()=>n("y")),r("Remove","Take it away (Delete)",s))}allOf(e,t){const n=e.devices.filter(r=>r.type===t.type).length;return n<2?[]:[y("label",{className:"all",title:"Places move by as much; rates and parameters become the same"},this.all,`change all ${n} of this type`)]}}const Bx=(i,e)=>i.visible?i.share===null?e?"lost without it":"sees it":`+${Is(i.share)}`:"doesn't see it";class kx{element;body=y("div",{className:"report",id:"report","aria-live":"polite"});inputs;constructor(e,t){this.inputs=["x","y","z"].map(s=>y("input",{type:"text","aria-label":`${s} of the point, metres`,placeholder:s,inputMode:"decimal"}));const n=y("form",{className:"at",onsubmit:s=>{s.preventDefault();const r=this.inputs.map(a=>Number(a.value));this.inputs.every(a=>a.value.trim()!=="")&&r.every(Number.isFinite)&&e(r)}},...this.inputs,y("button",{type:"submit"},"Probe"));this.element=y("section",{className:"panel probe"},y("h2",{},"One point"),n,this.body),this.clear(),this.inputs[0].addEventListener("keydown",s=>{s.key==="Escape"&&t()})}clear(){this.body.replaceChildren(y("p",{className:"hint"},"Click a place in the picture, or type one, to ask all about it."));for(const e of this.inputs)e.value=""}show(e,t,n,s){const{point:r,words:a}=e;r.at.forEach((h,d)=>this.inputs[d].value=nn(h,4));const o=Object.entries(r.metrics).filter(([h,d])=>h!=="footprint"||d.value!==null).map(([h,d])=>y("tr",{className:h===t.name?"chosen":"","data-metric":h,"data-value":d.value??""},y("th",{scope:"row"},h),y("td",{},Re(d.value,d.unit)))),l=Math.max(1e-12,...r.devices.map(h=>h.share??0)),c=r.devices.map(h=>{const d=y("span",{className:"bar","aria-hidden":"true"});return d.style.setProperty("--part",String(h.visible?(h.share??(r.observable?l:0))/l:0)),y("tr",{className:h.visible?"":"unseen"},y("th",{scope:"row"},h.name,d),y("td",{},Bx(h,r.observable)))});this.body.replaceChildren(y("p",{className:r.observable?"state good":"state bad"},r.inside?"Inside a solid: no target can be here.":r.observable?"Every direction is observed.":"Some directions are not observed."),...a.map(h=>y("p",{className:"lost"},h)),y("table",{},y("tbody",{},...o)),y("h3",{},`Without this device alone ${t.name} gets worse by`),y("table",{className:"shares"},y("tbody",{},...c)),...n>0?[y("p",{className:"hint"},`The ellipsoid is ${s} σ of the position, drawn ${nn(n,1)} times as large.`)]:[],...e.lost.length>0?[y("p",{className:"hint"},"Arrows point along what is lost of the position.")]:[])}}const zx={name:"m",factor:1},Vu=i=>[i.path,i.kind,i.known,i.add?.map(e=>e.path+e.label),i.members?.map(Vu)],Hx=i=>i.path.split(".").length>2&&!i.copy;let dh=0;class Wu{constructor(e){this.actions=e}element=y("div",{className:"form"});opened=new Set;shown=[];key="";room={min:[0,0,0],max:[1,1,1]};show(e,t){this.room=t;const n=JSON.stringify(e.map(Vu));if(n===this.key)return e.forEach((r,a)=>this.shown[a].update(r));this.key=n;const s=this.element.contains(document.activeElement)?document.activeElement.getAttribute("data-field"):null;this.shown=e.map(r=>this.field(r)),this.element.replaceChildren(...this.shown.map(r=>r.element)),s&&this.element.querySelector(`[data-field="${CSS.escape(s)}"]`)?.focus()}reveal(e){const t=e.split(".");t.forEach((n,s)=>this.opened.add(t.slice(0,s+1).join(".")));for(const n of this.element.querySelectorAll("details[data-part]"))this.opened.has(n.dataset.part)&&(n.open=!0),n.dataset.part===e&&n.scrollIntoView({block:"nearest"})}field(e){switch(e.kind){case"number":case"integer":return e.value===null?this.text(e):this.number(e);case"choice":return this.choice(e);case"group":return this.group(e);case"many":return{element:y("p",{className:"hint"},`${e.name}: ${e.value} of them, too many to be shown`),update:()=>{}};default:return this.text(e)}}set(e,t,n=""){this.actions.edit([{path:e.path,value:t}],n)}number(e){const t=e.value,n=e.unit==="m"&&/\.[xyz]$/.test(e.path),s=Math.max(...this.room.max.map((o,l)=>o-this.room.min[l]),.001),r=e.kind==="integer",a=new yl({label:e.name,help:e.help,unit:e.unit,lower:e.lower??(n?t-s/2:null),upper:e.upper??(n?t+s/2:null),logarithmic:e.lower===0&&e.upper===null&&!r,...n?{display:zx}:{},set:(o,l)=>this.set(e,r&&l?String(Math.round(Number(o))):o,l)},t);return{element:this.removable(e,a.element),update:o=>a.update(o.value)}}choice(e){const t=`form-${++dh}`,n=y("select",{id:t,"data-field":e.path,onchange:()=>this.set(e,n.value)},...e.words.map(r=>y("option",{value:r},r))),s=r=>n.value=String(r.value);return s(e),{element:this.row(e,t,n),update:s}}text(e){const t=`form-${++dh}`,n=e.known??[],s=y("input",{type:"text",id:t,"data-field":e.path,spellcheck:!1,autocomplete:"off",onchange:()=>this.set(e,s.value)}),r=o=>{document.activeElement===s&&s.value!==s.defaultValue&&s.value!==String(o.value)||(s.value=s.defaultValue=String(o.value??""))};if(r(e),n.length===0)return{element:this.row(e,t,s),update:r};s.setAttribute("list",`${t}-known`);const a=y("datalist",{id:`${t}-known`},...n.map(o=>y("option",{value:o})));return{element:this.row(e,t,s,a),update:r}}row(e,t,...n){const s=y("label",{htmlFor:t,title:e.help},e.name);return this.removable(e,y("div",{className:"number wide"},s,...n))}removable(e,t){const{remove:n}=e;return n?y("div",{className:"removable"},t,bt("close",`Leave out ${e.path}`,()=>this.actions.edit([n],""))):t}group(e){const t=(e.members??[]).map(o=>this.field(o)),n=o=>t.forEach((l,c)=>l.update(o.members[c])),s=[this.doings(e),...t.map(o=>o.element),this.adding(e)].filter(o=>o!==null);if(t.length>0&&t.length<=4&&e.members.every(o=>o.kind==="number")&&!e.rename)return{element:y("fieldset",{className:"vector"},y("legend",{title:e.help},e.name),...s),update:n};const a=y("details",{className:"part",open:this.opened.has(e.path)||Hx(e),"data-part":e.path,ontoggle:()=>{a.open!==this.opened.has(e.path)&&(a.open?this.opened.add(e.path):this.opened.delete(e.path),a.open&&this.actions.open(e.path))}},y("summary",{title:e.help},e.name),...s);return{element:a,update:n}}doings(e){const{actions:t}=this,{path:n,remove:s}=e;if(!s&&!e.copy&&!e.rename)return null;if(s&&!e.copy&&!e.rename)return bt("close",`Leave out ${n}`,()=>t.edit([s],""),"icon leave");const r=y("input",{type:"text",value:e.name,defaultValue:e.name,"aria-label":`Name of ${n}`,spellcheck:!1,autocomplete:"off",onchange:()=>t.renamePart(n,r.value)}),a=(o,l,c)=>y("button",{type:"button",title:l,"aria-label":l,onclick:c},o);return y("div",{className:"actions",role:"group","aria-label":n},e.rename?r:null,e.copy?a("Copy",`Copy ${n}`,()=>t.copyPart(n)):null,s?a("Remove",`Remove ${n}`,()=>t.edit([s],"")):null)}adding(e){const t=e.add??[];if(t.length===0)return null;const n=y("select",{"aria-label":`What to add to ${e.path}`,"data-field":`${e.path} add`},...t.map((s,r)=>y("option",{value:String(r),title:s.help},s.label)));return y("form",{className:"vary",onsubmit:s=>{s.preventDefault();const r=t[Number(n.value)];this.opened.add(e.path),this.opened.add(r.path),this.actions.edit([{path:r.path,value:r.value}],"")}},n,y("button",{type:"submit","aria-label":`Add to ${e.path}`},"Add"))}}const Gx={region:"a region",occluder:"an occluder",samples:"a set of samples"},Vx=["objective","constraints","selection"];class Wx{element;form;what;constructor(e){this.form=new Wu(e),this.what=y("select",{id:"paint-what","aria-label":"What to draw"},...Object.entries(Gx).map(([n,s])=>y("option",{value:n},s)));const t=y("button",{type:"button",id:"paint",title:"Drag a rectangle on the slice across z, or on the floor (Shift B)",onclick:()=>e.paint(this.chosen)},"Draw");this.element=y("section",{className:"panel grow room-panel",id:"room",hidden:!0,"aria-label":"The room",tabIndex:0},y("header",{},y("h2",{},"Room"),bt("close","Close the room (W)",e.close)),y("div",{className:"vary"},this.what,t),this.form.element)}get open(){return!this.element.hidden}get chosen(){return this.what.value}show(e,t){this.form.show(e.filter(n=>!Vx.includes(n.path)),t)}reveal(e){this.form.reveal(e)}}const Xx="http://www.w3.org/2000/svg";function ft(i,e,...t){const n=document.createElementNS(Xx,i);for(const[s,r]of Object.entries(e))n.setAttribute(s,String(r));return n.append(...t),n}const ki={left:4,right:4,top:14,bottom:14};function is({width:i,height:e,x:t,y:n},[s,r]){const a=(o,[l,c])=>c>l?(o-l)/(c-l):.5;return[ki.left+a(s,t)*(i-ki.left-ki.right),e-ki.bottom-a(r,n)*(e-ki.top-ki.bottom)]}const Jo=i=>i.map(e=>e.toFixed(1)).join(",");function Xu(i,e,t,n){let s="";return e.forEach(([r,a],o)=>{const l=e[o+1]?.[0]??t;s+=`${o===0?"M":"L"}${Jo(is(i,[r,a]))}L${Jo(is(i,[l,a]))}`}),ft("path",{d:s,class:n})}function Hs(i,e,...t){const{width:n,height:s}=i;return ft("svg",{viewBox:`0 0 ${n} ${s}`,class:"plot",role:"img","aria-label":e},...t)}const Wt=(i,e,t,n="start")=>ft("text",{x:i,y:e,"text-anchor":n},t);function ss(i){const e=i.filter(Number.isFinite);if(e.length===0)return[0,1];const[t,n]=[Math.min(...e),Math.max(...e)],s=n>t?.04*(n-t):Math.abs(n)*.02||1;return[t-s,n+s]}const $x={width:220,height:130},ii={left:8,right:8,top:8,bottom:24},qx=6,fh=i=>i.replace(/^devices\./,"").replace(".params.",".");function ph(i,e,t,n,s){const r=i.values.map((a,o)=>{const[l,c]=[e.lower[o],e.upper[o]],h=a??l,d=e.logarithmic[o]?Math.log(h/l)/Math.log(c/l):(h-l)/(c-l);return Jo([s(o),n-ii.bottom-d*(n-ii.top-ii.bottom)])});return ft("path",{d:`M${r.join("L")}`,class:t})}function $u(i,e,t=$x){const n=i.rounds[i.rounds.length-1];if(!n)return null;const s=n.variables.length,{width:r,height:a}=t,o=g=>ii.left+(s>1?g/(s-1):.5)*(r-ii.left-ii.right),l=n.variables.map((g,v)=>{const f=`${fh(g)}: ${Re(n.lower[v],e(g))} to ${Re(n.upper[v],e(g))}`;return ft("line",{x1:o(v),x2:o(v),y1:ii.top,y2:a-ii.bottom,class:"axis"},ft("title",{},f))}),c=g=>g.filter(v=>v.round===n.round),h=c(i.incumbents),d=[...c(i.designs).map(g=>ph(g,n,g.feasible?"looked":"missed",a,o)),...h.map((g,v)=>ph(g,n,v===h.length-1?"best":"incumbent",a,o))],u=s>qx?[]:n.variables.map((g,v)=>Wt(o(v),a-(v%2?3:13),fh(g),v===0?"start":v===s-1?"end":"middle")),m={...t};return Hs(m,`${h.length} designs that were the best of their time, over ${s} variables`,...l,...d,...u)}const Yx={width:220,height:110};function qu(i,e,t,n){const s={...n,x:ss(i.map(c=>c.x)),y:ss(i.map(c=>c.objective))},r=i.map(c=>{const[h,d]=is(s,[c.x,c.objective]);return ft("circle",{cx:h,cy:d,r:4,class:c.kept?c.dominated?"looked point":"best point":"missed point"})}),a=i.map(c=>`${Re(c.x,t.unit)}: ${Re(c.objective,e.unit)}`),o=`${e.name} against ${t.name}: ${a.join("; ")}`,l=[Wt(4,10,Re(s.y[1],e.unit)),Wt(n.width-4,n.height-3,`${t.name} ${Re(s.x[1],t.unit)}`,"end")];return{figure:Hs(s,o,...r,...l),circles:r}}class Zx{constructor(e){this.actions=e,this.element=y("div",{},y("form",{className:"front-form",onsubmit:t=>this.submit(t)},this.constraint,this.from,this.to,this.levels,y("button",{type:"submit",id:"front-start"},"Trade off")),this.plot)}element;constraint=y("select",{id:"front-constraint","aria-label":"Constraint",onchange:()=>this.propose()});from=y("input",{type:"text",id:"front-from","aria-label":"Limit from",autocomplete:"off"});to=y("input",{type:"text",id:"front-to","aria-label":"Limit to",autocomplete:"off"});levels=y("input",{type:"text",id:"front-levels","aria-label":"Number of limits",value:"5",defaultValue:"5",inputMode:"numeric"});plot=y("div",{className:"front"});task=null;offer(e){const t=s=>s?.constraints.map(r=>r.name).join(`
`),n=t(e)!==t(this.task);this.task=e,n&&(this.constraint.replaceChildren(...e.constraints.map(s=>y("option",{value:s.name},s.name))),this.propose())}propose(){const e=this.task?.constraints.find(t=>t.name===this.constraint.value);!e||e.limit===null||(this.from.value=Br(.5*e.limit,e.unit),this.to.value=Br(e.limit,e.unit))}submit(e){e.preventDefault();const t=this.task?.constraints.find(s=>s.name===this.constraint.value);if(!t)return;const{unit:n}=t;this.actions.start({constraint:t.name,from:Zi(this.from.value,n),to:Zi(this.to.value,n),levels:Number(this.levels.value)})}show(e){this.element.hidden=(this.task?.constraints.length??0)===0,this.plot.replaceChildren(...e?this.drawn(e):[])}drawn({search:e,front:t,done:n,of:s,phase:r}){if(!t)return[y("p",{className:"hint",role:"status"},r==="running"?`search ${n+1} of ${s}`:"")];const{points:a,objective:o,limit:l}=t,c=a.map((u,m)=>({...u,k:m,x:u.used})).filter(u=>u.objective!==null),h=qu(c.map(u=>({...u,objective:u.objective})),o,{name:l.constraint,unit:l.unit},Yx);h.circles.forEach((u,m)=>u.addEventListener("click",()=>this.actions.reinstate(e,c[m].k)));const d=u=>`${Re(u.used,l.unit)}: ${Re(u.objective,o.unit)}`;return[h.figure,y("div",{className:"incumbents"},...c.map(u=>y("button",{type:"button",title:"Take this design","data-point":u.k,onclick:()=>this.actions.reinstate(e,u.k)},d(u),u.kept?"":" ✗")))]}}const Kx=40;class Jx{constructor(e){this.reinstate=e}element=y("ol",{className:"history","aria-label":"Searches",reversed:!0});show(e){const t=[...e.all.values()].reverse(),n=this.element.contains(document.activeElement)?document.activeElement.dataset.incumbent:void 0;this.element.replaceChildren(...t.map(s=>y("li",{value:s.search},...this.words(s)))),n&&this.element.querySelector(`[data-incumbent="${n}"]`)?.focus()}words(e){if(e.kind==="selection"){const{result:t,unit:n}=e;return[t?`chose ${Bt(t.chosen.length,"candidate")}: ${Re(t.value,n)}`:"a choice"]}return e.kind==="front"?[`trade-off${e.front?` against ${e.front.limit.constraint}`:""}`]:[`${e.objective.name}, ${Bt(e.evaluations,"evaluation")}${e.study?`, in ${e.study}`:""}`,this.incumbents(e)]}incumbents({search:e,incumbents:t,objective:n}){return y("div",{className:"incumbents"},...[...t].reverse().slice(0,Kx).map(s=>y("button",{type:"button",title:`Take this design again: after ${Bt(s.evaluation,"evaluation")}, round ${s.round}`,"data-incumbent":`${e} ${s.number}`,onclick:()=>this.reinstate(e,s.number)},Re(s.objective,n.unit,4))))}}const qi=i=>i?.phase==="running"||i?.phase==="waiting",jx=400;class Qx{all=new Map;get now(){return[...this.all.values()].pop()??null}clear(){this.all.clear()}take(e,t){const n=this.all.get(e.search)??null;if(!t&&n?.kind==="search"&&e.kind==="search")for(e.rounds=[...n.rounds,...e.rounds],e.incumbents=[...n.incumbents,...e.incumbents],e.designs=[...n.designs,...e.designs];e.designs.length>jx;)e.designs=e.designs.filter((s,r)=>r%2===1);return this.all.set(e.search,e),n}}class eM{constructor(e){this.hear=e}socket=null;again=0;open(e){this.close();const t=new WebSocket(`ws://${location.host}/api/watch?session=${encodeURIComponent(e)}`),n=new Set;t.onmessage=({data:s})=>{const r=JSON.parse(s);this.hear(r,!n.has(r.search)),n.add(r.search)},t.onclose=()=>{this.socket===t&&(this.again=window.setTimeout(()=>this.open(e),2e3))},this.socket=t}close(){clearTimeout(this.again);const{socket:e}=this;this.socket=null,e?.close()}}const Yu={width:220,height:110};function Zu(i,e=Yu,t=[]){const{objective:n,incumbents:s,designs:r,evaluations:a}=i,o=s[s.length-1]?.round??0,l=s.map(f=>f.objective??NaN),c=r.map(f=>f.objective??NaN).filter(f=>l.length>0&&f<=Math.max(...l)),h={...e,x:[0,Math.max(1,a)],y:ss([...l,...c])},d=r.flatMap(f=>{if(f.objective===null||f.objective>h.y[1]||f.objective<h.y[0])return[];const[p,x]=is(h,[f.evaluation,f.objective]);return[ft("circle",{cx:p,cy:x,r:1.5,class:f.soft?"soft":f.feasible?"looked":"missed"})]}),m=[...new Set(s.map(f=>f.round))].map(f=>{const p=s.filter(E=>E.round===f),x=s.find(E=>E.round>f);return Xu(h,p.map(E=>[E.evaluation,E.objective??NaN]),x?.evaluation??a,"best")}),g=i.best===null?"nothing that keeps the constraints yet":`best ${Re(i.best,n.unit,4)}`,v=`${n.name}: ${g} after ${a} evaluations, round ${o}`;return Hs(h,v,...d,...m,...t.flatMap((f,p)=>nM(h,f,p)),...Ku(h,n.unit,`${a} evaluations`))}function tM(i){const{curve:e,unit:t}=i,n=e[e.length-1],s={...Yu,x:[0,Math.max(.1,n?.seconds??0)],y:ss(e.flatMap(o=>[o.value??NaN,o.bound??NaN]))},r=(o,l)=>Xu(s,e.flatMap(c=>c[o]===null?[]:[[c.seconds,c[o]]]),s.x[1],l),a=n?`best ${Re(n.value,t,4)}, no choice is below ${Re(n.bound,t,4)}`:"nothing is chosen yet";return Hs(s,a,r("value","best"),r("bound","bound"),...Ku(s,t,`${(n?.seconds??0).toFixed(1)} s`))}function nM(i,{evaluation:e,text:t},n){const[s]=is(i,[e,0]),r=s>i.width/2;return[ft("line",{x1:s,x2:s,y1:0,y2:i.height,class:"act"}),Wt(s+(r?-4:4),24+12*(n%8),t,r?"end":"start")]}function Ku({width:i,height:e,y:t},n,s){return[Wt(4,10,Re(t[1],n)),Wt(4,e-3,Re(t[0],n)),Wt(i-4,10,s,"end")]}const iM={mean:"mean",maximum:"greatest",percentile:"95 % are below",cvar:"mean of the worst 5 %",p_norm:"8-norm"};class sM{constructor(e){this.actions=e,this.element=y("section",{className:"search-column","aria-label":"Search"},y("div",{className:"pair"},y("label",{htmlFor:"objective"},"Minimize"),this.objective),y("div",{className:"actions",role:"toolbar","aria-label":"Search"},...Object.values(this.buttons)),this.status,this.curve,Ls("How",!1,y("div",{className:"search-options"},...[this.evaluations,this.seconds,this.starts,this.seed,this.study].map(([t])=>t))))}element;objective=y("select",{id:"objective",onchange:()=>this.actions.minimize(this.objective.value)});evaluations=this.option("search-evaluations","Evaluations","by size");seconds=this.option("search-seconds","Seconds","no limit");starts=this.option("search-starts","Starts","by kind");seed=this.option("search-seed","Seed","1");study=this.option("search-study","Study","not kept");buttons={start:this.button("search-start","Search","Begin a search (Ctrl Enter)",()=>this.start()),pause:this.button("search-pause","Pause","Stop, with the best so far",()=>this.actions.pause()),resume:this.button("search-resume","Go on","Go on where it was",()=>this.resume()),accept:this.button("search-accept","Keep","Keep the best: one step that can be undone",()=>this.keep()),reject:this.button("search-reject","Take back","All variables as they were when it began",()=>this.actions.reject())};status=y("p",{className:"search-status",id:"search-status",role:"status"});curve=y("div",{className:"curve"});task=null;now=null;keeping=!1;option(e,t,n){const s=y("input",{type:"text",id:e,placeholder:n,autocomplete:"off",spellcheck:!1});return[y("label",{htmlFor:e},t,s),s]}button(e,t,n,s){return y("button",{type:"button",id:e,title:n,onclick:s},t)}offer(e){this.task=e;const{name:t}=e.objective;this.objective.replaceChildren(y("option",{value:""},t),...Object.entries(iM).map(([n,s])=>y("option",{value:n},s))),this.render()}wishes(){const e={},t={evaluations:this.evaluations,seconds:this.seconds,starts:this.starts,seed:this.seed};for(const[s,[,r]]of Object.entries(t))r.value.trim()!==""&&(e[s]=Number(r.value));const n=this.study[1].value.trim();return n!==""&&(e.study=n),e}start(){if(this.buttons.start.disabled)return;const{selection:e}=this.task;e?this.actions.select(this.wishes()):this.actions.start(this.wishes())}resume(){const{evaluations:e,...t}=this.wishes(),n=this.now?.kind==="search"?e??Math.max(this.now.of,100):void 0;this.actions.resume(n===void 0?t:{evaluations:n})}keep(){if(!qi(this.now))return this.actions.accept();this.keeping=!0,this.actions.pause()}show(e){this.now=e,this.keeping&&e&&!qi(e)&&(this.keeping=!1,this.actions.accept()),this.render()}render(){const{now:e,task:t,buttons:n}=this,s=qi(e);n.start.textContent=t?.selection?"Choose":"Search",n.start.disabled=s||!t||t.variables.length===0&&!t.selection,n.pause.disabled=!s,n.resume.disabled=!e||s||e.kind!=="search"&&e.phase==="ended",n.accept.disabled=!e||e.kind==="front"||(e.kind==="search"?e.incumbents.length===0:s||!e.result),n.reject.disabled=e?.kind!=="search",this.status.textContent=e?rM(e):t?.selection?`A choice by ${t.selection}.`:"",this.status.dataset.phase=e?.phase??"",this.status.dataset.mood=e?.phase==="failed"?"bad":"";const r=e?.kind==="search"?Zu(e):e?.kind==="selection"?tM(e):null;this.curve.replaceChildren(...r?[r]:[])}}function rM(i){const{phase:e}=i;if(e==="failed")return i.message;if(e==="waiting")return"Waits for its turn.";const t={running:"Searching",paused:"Paused",ended:"Ended"}[e];if(i.kind==="front")return`${t}: trade-off, ${i.done} of ${i.of} searches.`;if(i.kind==="selection"){if(i.ready<1)return`${t}: candidates asked what they see, ${nn(100*i.ready,2)} %.`;const u=i.curve[i.curve.length-1],m=i.result?`, ${Bt(i.result.chosen.length,"candidate")}, at most ${nn(100*i.result.gap,2)} % from the best`:"";return u?`${t}: ${Re(u.value,i.unit)}, at best ${Re(u.bound,i.unit)}${m}.`:`${t}.`}const{objective:n,best:s,result:r,judged:a,evaluations:o,incumbents:l}=i,c=l.length>0?"from the design as it is now":"none keeps the constraints yet",h=r&&a?`${Re(r.initial,n.unit)} → ${Re(r.best,n.unit,4)}`:Re(s,n.unit,4),d=e==="ended"&&r?`, ${r.stop}`:"";return`${t}: ${n.name} ${s===null&&!a?c:h} after ${Bt(o,"evaluation")}${d}.`}const Tr={width:220,height:130};class aM{constructor(e){this.actions=e;const t=n=>y("select",{"aria-label":n,hidden:!0,onchange:()=>this.draw()});this.axes=[t("Term across"),t("Term upwards")],this.element=y("form",{hidden:!0,className:"terms",onsubmit:n=>{n.preventDefault(),this.ask()}},y("div",{className:"vary"},...this.axes,y("button",{type:"submit",id:"plot-terms",title:"What each term is worth of the designs that were the best of their time"},"Plot terms")),this.plot)}element;axes;plot=y("div",{className:"terms-plot"});search=null;found=null;several(e){this.element.hidden=!e}show(e){this.search=e}async ask(){const{search:e}=this;if(!e||e.incumbents.length===0)return;const t=e.incumbents.slice(-60).map(s=>s.number),n=await this.actions.terms(e.search,t);n&&(this.found={search:e.search,numbers:t,terms:n},this.axes.forEach((s,r)=>{const a=s.value||String(r);s.replaceChildren(...n.terms.map((o,l)=>y("option",{value:String(l)},`${l+1}: ${o.name}`))),s.value=Number(a)<n.terms.length?a:String(r),s.hidden=!1}),this.draw())}draw(){if(!this.found)return;const{search:e,numbers:t,terms:n}=this.found,[s,r]=this.axes.map(u=>Number(u.value)),a=n.values.flatMap((u,m)=>{const[g,v]=[u[s],u[r]];return g==null||v==null?[]:[{x:g,y:v,number:t[m]}]}),o={...Tr,x:ss(a.map(u=>u.x)),y:ss(a.map(u=>u.y))},[l,c]=[n.terms[s],n.terms[r]],h=a.map((u,m)=>{const[g,v]=is(o,[u.x,u.y]),f=ft("circle",{cx:g,cy:v,r:4,class:m===a.length-1?"best point":"looked point","data-x":u.x,"data-y":u.y});return f.append(ft("title",{},`design ${u.number}: ${Re(u.x,l.unit,4)}, ${Re(u.y,c.unit,4)}`)),f.addEventListener("click",()=>this.actions.reinstate(e,u.number)),f}),d=`${c.name} against ${l.name} of ${a.length} designs that were the best of their time`;this.plot.replaceChildren(Hs(o,d,...h,Wt(4,10,`${c.name} ${Re(o.y[1],c.unit)}`),Wt(4,Tr.height-3,Re(o.x[0],l.unit)),Wt(Tr.width-4,Tr.height-3,`${l.name} ${Re(o.x[1],l.unit)}`,"end")))}}const mh=i=>i.split(".").slice(0,2).join(".");function oM(i,e){const t=i.surface?["coordinates"]:["at"],n=i.facing?[i.facing]:[],s=(e?.params??[]).filter(r=>r.kind==="number").map(r=>`params.${r.name}`);return[...t,...n,...s,"rate"]}class lM{constructor(e){this.actions=e,this.element=y("section",{className:"search-column","aria-label":"What may change"},y("h3",{},"What may change"),this.list,y("form",{className:"vary",onsubmit:t=>{t.preventDefault(),e.vary({path:`${this.whose.value}.${this.what.value}`})}},this.whose,this.what,y("button",{type:"submit",id:"vary"},"Let it change")))}element;list=y("div",{className:"variables"});whose=y("select",{id:"vary-whose","aria-label":"Whose number may change"});what=y("select",{id:"vary-what","aria-label":"Which number may change"});shown="";offer(e,t,n,s){const r=e??n[0];if(!r)return;const a=this.what.value,o=n.filter(c=>c.type===r.type).length>1;this.whose.replaceChildren(y("option",{value:`devices.${r.name}`},r.name),...o?[y("option",{value:"devices.*"},"all devices")]:[]);const l=oM(r,t??s[r.type]);this.what.replaceChildren(...l.map(c=>y("option",{value:c},c.replace("params.","")))),l.includes(a)&&(this.what.value=a)}show(e,t){const n=JSON.stringify([e.variables,t]);if(n===this.shown)return;const{activeElement:s}=document,r=this.list.contains(s)?s.id:"";this.shown=n;const a=[...new Set(e.variables.map(o=>mh(o.path)))];this.list.replaceChildren(...a.map(o=>this.group(o,e.variables.filter(l=>mh(l.path)===o),t)),...a.length===0?[y("p",{className:"hint"},"Nothing may change yet: choose a number below.")]:[]),r&&document.getElementById(r)?.focus()}group(e,t,n){const s=a=>n.includes(a.path),r=t.every(s);return y("fieldset",{className:"owner","data-owner":e},y("legend",{},this.check(e,r,`Lock all of ${e.split(".")[1]}`),y("b",{},e.split(".")[1]??e)),...t.map(a=>this.row(a,s(a))))}check(e,t,n){const s=y("input",{type:"checkbox",id:`lock ${e}`,checked:t,title:n,"aria-label":n,"data-lock":e,onchange:()=>this.actions.lock(e,s.checked)});return s}row(e,t){const n=e.path.split(".").slice(2).join(".").replace(/^(params|at)\./,"").replace("coordinates.","on it "),s=(r,a)=>{const o=e[r]===null?"":Br(e[r],e.unit),l=y("input",{type:"text",id:`${r} ${e.path}`,value:o,defaultValue:o,"aria-label":`${a} of ${e.path}`,autocomplete:"off",spellcheck:!1});return l.onchange=()=>this.actions.vary({path:e.path,[r]:l.value}),l};return y("div",{className:t?"variable locked":"variable","data-variable":e.path},this.check(e.path,t,`Lock ${e.path}`),y("span",{className:"name",title:e.followers>0?`${e.path}, which ${e.followers} more follow`:e.path},n),s("lower","Least value"),y("output",{},e.value===null?"":Re(e.value,e.unit)),s("upper","Greatest value"),bt("close",`${e.path} may not change any more`,()=>this.actions.fix(e.path)))}}class cM{constructor(e){this.actions=e,this.variables=new lM({...e,lock:(t,n)=>this.lock(t,n)}),this.run=new sM({...e,start:t=>e.start({...t,locked:this.lockedNow()})}),this.history=new Jx((t,n)=>e.reinstate(t,{incumbent:n})),this.front=new Zx({start:e.front,reinstate:(t,n)=>e.reinstate(t,{point:n})}),this.aims=new Wu(e.form),this.terms=new aM({terms:e.terms,reinstate:(t,n)=>e.reinstate(t,{incumbent:n})}),this.variables.element.append(this.aims.element),this.element=y("section",{className:"search",id:"search",hidden:!0,"aria-label":"Search for a better design"},this.variables.element,this.run.element,y("section",{className:"search-column","aria-label":"What was found",tabIndex:0},y("h3",{},"What was found"),this.designs,this.history.element,this.front.element,this.terms.element),bt("close","Close the search",()=>this.toggle(),"icon close-search"))}element;variables;run;history;front;aims;terms;designs=y("div",{className:"designs"});offered=null;searches=null;locked=new Set;get open(){return!this.element.hidden}toggle(){this.element.hidden=!this.element.hidden,document.getElementById("search-open")?.setAttribute("aria-pressed",String(this.open))}choose(e,t,n){this.variables.offer(e,e?n[e.type]:void 0,t,n)}task(e){this.offered=e,this.run.offer(e),this.front.offer(e),this.searches?this.show(this.searches):this.variables.show(e,[...this.locked])}form(e,t){const n=e.find(s=>s.path==="objective")?.members?.find(s=>s.name==="terms");this.terms.several((n?.members?.length??0)>1),this.aims.show(e.filter(s=>s.path==="objective"||s.path==="constraints"),t)}begin(){this.run.start()}keep(){this.run.keep()}lockedNow(){const e=this.searches?.now;return e?.kind==="search"?e.locked:[...this.locked]}show(e){this.searches=e;const{now:t}=e;this.run.show(t),this.offered&&this.variables.show(this.offered,this.lockedNow());const n=new Map(this.offered?.variables.map(a=>[a.path,a.unit])),s=t?.kind==="search"?$u(t,a=>n.get(a)??"1"):null;this.designs.replaceChildren(...s?[s]:[]),this.history.show(e),this.terms.show(t?.kind==="search"?t:null);const r=[...e.all.values()].filter(a=>a.kind==="front").pop();this.front.show(r?.kind==="front"?r:null)}lock(e,t){if(this.searches?.now?.kind==="search")return this.actions.lock(e,t);for(const{path:n}of this.offered?.variables??[])n!==e&&!n.startsWith(`${e}.`)||(t?this.locked.add(n):this.locked.delete(n));this.offered&&this.variables.show(this.offered,[...this.locked])}}class hM{constructor(e){this.open=e,this.element=y("dialog",{className:"start","aria-label":"Choose a scene"},bt("close","Close",()=>this.element.close()),y("h1",{},"Delos"),y("p",{className:"lead"},"The best accuracy that any algorithm could reach with a tracking system, throughout its room. Choose one to begin with."),this.grid)}element;grid=y("div",{className:"scenes"});show(e){this.grid.replaceChildren(...e.scenes.map(({id:t,about:n})=>y("button",{type:"button","data-scene":t,onclick:()=>{this.element.close(),this.open(t)}},y("b",{},t.replace(/^(.*\/)?\d+-/,"$1").replaceAll("-"," ")),y("span",{},n)))),this.element.open||this.element.showModal(),this.grid.querySelector("button")?.focus()}}class gh{slider;box;scale=null;unit="1";constructor(e,t,n){this.slider=y("input",{type:"range",min:"0",max:"1",step:"0.0025",id:e,"aria-label":t}),this.slider.oninput=()=>n(Number(this.slider.value)),this.box=y("input",{type:"text",className:"level",spellcheck:!1,autocomplete:"off","aria-label":`${t}, value`}),this.box.onchange=()=>{const s=Zi(this.box.value,this.unit);this.scale&&Number.isFinite(s)&&n(Math.min(1,Math.max(0,this.scale.part(s))))}}show(e,t,n){this.scale=t,this.unit=n,this.slider.value=String(e);const s=Re(t.at(e),n,4);this.slider.setAttribute("aria-valuetext",s),document.activeElement!==this.box&&(this.box.value=s)}}function uM(i,e,t){let n=0,s=0;return i.values.forEach((r,a)=>{i.mask[a]!==ai.inside&&++s,i.mask[a]===ai.value&&r>=e&&r<=t&&++n}),{inside:n,all:s}}class dM{constructor(e,t){this.viewing=e;const n=c=>{Object.assign(e,c),t()},[s,r]=In("view-surface","Surface at",c=>n({surface:c}));this.surface=r,this.level=new gh("level","Level of the surface",c=>n({level:c,surface:!0}));const[a,o]=ns("view-body","Volume",{none:"not drawn",volume:"as a cloud",between:"between two values"},c=>n({body:c}));this.body=o;const l=c=>new gh(`between-${c}`,c===0?"Least value of the interval":"Greatest value of the interval",h=>{const d=[...e.between];d[c]=h,n({between:[Math.min(...d),Math.max(...d)],body:"between"})});this.ends=[l(0),l(1)],this.interval=y("div",{},...this.ends.map((c,h)=>y("div",{className:"row wide"},y("span",{},h===0?"from":"to"),c.slider,c.box)),this.count),this.surfaceRow=y("div",{className:"row wide"},s,this.level.slider,this.level.box),this.element=y("div",{},this.surfaceRow,this.area,a,this.interval)}element;surface;surfaceRow;level;body;ends;interval;area=y("p",{className:"hint",id:"surface-area"});count=y("p",{className:"hint",id:"between-count"});show(e,t,n){const{viewing:s}=this;this.element.hidden=!t;const r=e.parts.some(m=>m.kind==="grid");if(this.surfaceRow.hidden=!r,this.surface.checked=s.surface,this.body.value=s.body,this.interval.hidden=s.body!=="between",!t)return;const{unit:a}=e.summary.metric,o=(n?.meshes??[]).filter(({asked:m})=>"level"in m&&m.of!=="pinned"),l=o.reduce((m,g)=>m+g.area,0);if(this.area.hidden=o.length===0,this.area.dataset.area=String(l),this.area.textContent=Re(l,"m^2",4),this.level.show(s.level,t,a),this.ends.forEach((m,g)=>m.show(s.between[g],t,a)),s.body!=="between")return;const[c,h]=Ko(s,t),{inside:d,all:u}=uM(e,c??-1/0,h??1/0);this.count.dataset.count=String(d),this.count.textContent=`${d} of ${nn(u,9)} samples, ${Is(d/Math.max(1,u))}`}}class Ju{constructor(e,t){this.viewing=e,this.changed=t;const[n,s]=In("view-logarithmic","log scale",u=>this.set({logarithmic:u})),[r,a]=In("view-reversed","dark is good",u=>this.set({reversed:u})),o=Object.fromEntries(Object.keys(ia).map(u=>[u,u])),[l,c]=ns("view-map","Map",o,u=>this.set({map:u})),[h,d]=ns("view-units","Units",{auto:"with prefixes",si:"SI",log10:"log₁₀ of SI"},u=>this.set({units:u}));[this.logarithmic,this.reversed,this.map,this.units]=[s,a,c,d],this.ends=[this.end("low","Colours from"),this.end("high","Colours to")],this.element=y("div",{},y("div",{className:"checks"},n,r),l,h,y("div",{className:"pair"},y("span",{},"Range"),y("span",{className:"ends"},...this.ends)))}element;logarithmic;reversed;map;units;ends;unit="1";set(e){Object.assign(this.viewing,e),this.changed()}show(e){const{viewing:t}=this;this.unit=e.summary.metric.unit,this.logarithmic.checked=t.logarithmic,this.reversed.checked=t.reversed,this.map.value=t.map,this.units.value=t.units,[t.low,t.high].forEach((n,s)=>{document.activeElement!==this.ends[s]&&(this.ends[s].value=n===null?"":Re(n,this.unit,5))})}end(e,t){const n=y("input",{type:"text",placeholder:e==="low"?"least":"greatest","aria-label":t,spellcheck:!1,autocomplete:"off"});return n.onchange=()=>{const s=Zi(n.value,this.unit);this.set({[e]:Number.isFinite(s)?s:null})},n}}class fM{constructor(e,t){this.viewing=e;const[n,s]=In("view-relief","Heights",r=>{e.relief=r,t()});this.raised=s,this.size=y("input",{type:"range",min:"-1",max:"1",step:"0.02",id:"relief-size","aria-label":"How high the end of the bar is"}),this.size.oninput=()=>{Object.assign(e,{relief:!0,reliefPart:Number(this.size.value)}),t()},this.element=y("div",{className:"row wide"},n,this.size,this.text)}element;raised;size;text=y("output",{});show(e,t){const{viewing:n}=this;this.element.hidden=!t,this.raised.checked=n.relief,this.size.value=String(n.reliefPart);const s=Re(n.reliefPart*e,"m",2);this.text.textContent=s,this.size.setAttribute("aria-valuetext",s)}}function pM(i,e){const t=i.devices.find(a=>a.name===e)??i.devices[0];if(!t)return[];const n=`devices.${t.name}`,s=i.types[t.type].params.filter(({kind:a})=>a==="number"),r=t.coordinates?[]:["x","y","z"].map(a=>`${n}.at.${a}`);return[...s.map(a=>`${n}.params.${a.name}`),...r,`${n}.rate`]}class mM{constructor(e,t){this.viewing=e,this.path=y("input",{id:"sensitivity",type:"text",spellcheck:!1,autocomplete:"off",placeholder:"devices.NAME.at.z",title:"How much the metric rises with a number: its path, or one of the chosen device; empty: the metric itself",oninput:()=>this.typing=!0,onchange:()=>{this.typing=!1,e.sensitivity=this.path.value.trim(),t()}}),this.path.setAttribute("list","sensitivity-numbers"),this.element=y("div",{className:"pair"},y("label",{htmlFor:"sensitivity"},"Slope"),this.path,this.known)}element;path;typing=!1;known=y("datalist",{id:"sensitivity-numbers"});show(e,t){this.typing||(this.path.value=this.viewing.sensitivity);const n=pM(e,t);this.known.dataset.paths!==n.join()&&(this.known.dataset.paths=n.join(),this.known.replaceChildren(...n.map(s=>y("option",{value:s}))))}}const Ar=["x","y","z"];function _h(i,e,t,n,s,r){const a=y("input",{type:"range",min:"0",max:String(n),step:String(s),"aria-label":i,"aria-valuetext":e});return a.value=String(t),a.oninput=()=>r(Number(a.value)),a}function gM(i,e,t,n){const s=[1,e.counts[0],e.counts[0]*e.counts[1]];let[r,a]=[1/0,-1/0];for(let o=0;o<e.count;++o){if(Math.floor(o/s[t])%e.counts[t]!==n||i.mask[e.first+o]!==ai.value)continue;const l=i.values[e.first+o];[r,a]=[Math.min(r,l),Math.max(a,l)]}return r<=a?[r,a]:null}class ju{constructor(e,t,n=!0){this.viewing=e,this.changed=t,this.buttons=Ar.map((r,a)=>y("button",{type:"button",onclick:()=>this.toggle(a),"aria-label":`Slice across ${r}`},r));const s=y("button",{type:"button","aria-label":"Add a slanted slice",onclick:()=>this.addSlant()},"+ /");this.element=y("div",{},y("div",{className:"row"},y("span",{},"Slices"),y("div",{className:"segments",role:"group","aria-label":"Slices"},...this.buttons,n&&s)),this.layers,this.slants)}element;buttons;layers=y("div");slants=y("div");shown="";field=null;tellers=[];toggle(e){this.viewing.slices[e]=!this.viewing.slices[e],this.changed()}addSlant(){this.viewing.slants.length>=4||(this.viewing.slants.push({azimuth:Math.PI/4,tilt:Math.PI/4,part:.5}),this.changed())}show(e){const{viewing:t}=this,n=e.parts.find(r=>r.kind==="grid")??null;if(this.element.hidden=n===null,!n)return;this.buttons.forEach((r,a)=>r.setAttribute("aria-pressed",String(t.slices[a])));const s=JSON.stringify([t.slices,n.origin,n.step,n.counts,t.slants.length]);s!==this.shown&&(this.shown=s,this.tellers=[],this.layers.replaceChildren(...[0,1,2].filter(r=>t.slices[r]).map(r=>this.layer(n,r))),this.slants.replaceChildren(...t.slants.map((r,a)=>this.slant(r,a)))),this.field=e;for(const r of this.tellers)r()}layer(e,t){const{viewing:n}=this,s=d=>e.origin[t]+d*e.step[t],r=d=>`${Ar[t]} ${nn(s(d),3)} m`,a=Yo(e,t,n.at[t]),o=y("output",{},r(a)),l=y("p",{className:"hint slice-range","data-axis":Ar[t]}),c=d=>{const u=gM(this.field,e,t,d),{unit:m}=this.field.summary.metric;l.dataset.min=String(u?.[0]??""),l.dataset.max=String(u?.[1]??""),l.textContent=u?`${Re(u[0],m,4)} to ${Re(u[1],m,4)}`:"blind"};this.tellers.push(()=>c(Yo(e,t,n.at[t])));const h=_h(`Place of the slice across ${Ar[t]}`,r(a),a,e.counts[t]-1,1,d=>{n.at[t]=s(d),o.textContent=r(d),h.setAttribute("aria-valuetext",r(d)),this.changed()});return y("div",{},y("div",{className:"row"},y("span",{},"at"),h,o),l)}slant(e,t){const n=(r,a,o,l,c)=>{const h=y("output",{},c()),d=_h(`${a} of slanted slice ${t+1}`,c(),e[r],o,l,u=>{e[r]=u,h.textContent=c(),d.setAttribute("aria-valuetext",c()),this.changed()});return y("div",{className:"row"},y("span",{},a),d,h)},s=r=>`${Math.round(r*180/Math.PI)}°`;return y("fieldset",{className:"slant"},y("legend",{},`slanted ${t+1} `,bt("close",`Take slanted slice ${t+1} away`,()=>{this.viewing.slants.splice(t,1),this.shown="",this.changed()})),n("azimuth","turn",2*Math.PI,Math.PI/36,()=>s(e.azimuth)),n("tilt","tilt",Math.PI,Math.PI/36,()=>s(e.tilt)),n("part","at",1,.01,()=>`${Math.round(100*e.part)} %`))}}class Qu{constructor(e,t){this.viewing=e;const n=h=>{Object.assign(e,h),t()},[s,r]=In("view-lattice","ellipsoids and lost directions",h=>n({lattice:h})),[a,o]=In("view-blind","blind regions",h=>n({blind:h})),[l,c]=ns("view-sigmas","Ellipsoids of",{1:"1 σ (20 %)",2:"2 σ (74 %)",3:"3 σ (97 %)"},h=>n({sigmas:Number(h)}));[this.lattice,this.blind,this.sigmas]=[r,o,c],this.element=y("div",{},y("div",{className:"checks"},s,a),l,this.enlarged,this.regions)}element;lattice;blind;sigmas;enlarged=y("p",{className:"hint"});regions=y("ol",{className:"regions",id:"blind-regions"});show(e,t){const{viewing:n}=this;this.lattice.checked=n.lattice,this.blind.checked=n.blind,this.sigmas.value=String(n.sigmas),this.enlarged.textContent=n.lattice&&t>0?`Ellipsoids are drawn ${nn(t,1)} times as large.`:"",this.regions.hidden=!n.blind||!e,e&&this.regions.replaceChildren(...e.regions.length===0?[y("li",{},"nothing is blind")]:[],...e.regions.map(s=>y("li",{},y("b",{},Bt(s.samples,"sample")),` ${s.why}`)))}}class _M{constructor(e,t){this.viewing=e,this.changed=t,this.slices=new ju(e,t),this.sensitivity=new mM(e,t),this.relief=new fM(e,t),this.through=new mx(e,t),this.bodies=new dM(e,t),this.colouring=new Ju(e,t),this.uncertainty=new Qu(e,t);const[n,s]=In("view-frusta","frusta",c=>this.set({frusta:c})),[r,a]=In("view-names","names",c=>this.set({names:c})),[o,l]=In("view-cells","octree cells",c=>this.set({cells:c}));[this.frusta,this.names,this.cells,this.cellsLabel]=[s,a,l,o],o.append(this.cellCount),this.element=y("section",{className:"panel viewing"},y("h2",{},"View"),this.slices.element,this.relief.element,this.through.element,this.bodies.element,this.sensitivity.element,y("div",{className:"checks"},n,r,o),Ls("Colours",!0,this.colouring.element),Ls("Uncertainty",!1,this.uncertainty.element))}element;slices;sensitivity;through;bodies;colouring;uncertainty;relief;frusta;names;cells;cellsLabel;cellCount=y("span",{id:"cell-count"});set(e){Object.assign(this.viewing,e),this.changed()}show(e,t,n,s,r,a,o){this.slices.show(e),this.through.show(e,t?.summary??null);const l=e.parts.some(({kind:c})=>c==="grid"||c==="plane");this.relief.show(a,l&&n!==null),this.bodies.show(e,n,o),this.colouring.show(e),this.uncertainty.show(s,r),this.frusta.checked=this.viewing.frusta,this.names.checked=this.viewing.names,this.cells.checked=this.viewing.cells,this.cellsLabel.hidden=e.leaves===0,this.cellCount.textContent=o?.leaves?` (${o.leaves.count} of ${e.leaves})`:""}}const vM=["stacked","continuous","periodic","sequential","artemis"],xM=[["drag, wheel","turn, come nearer; right button: shift"],["G or R, then X, Y or Z and a number","move or turn by as much; twice the axis: the device's own"]];class MM{constructor(e,t,n,s){this.actions=n,this.start=new hM(n.open),this.devices=new Bu(n.select,n.askPalette),this.inspector=new Ox(n.change,n.place,n),this.addDevice=new yx(n.add),this.array=new Sx(n.makeArray),this.palette=new Ex(s,n.set),this.compare=new ku(t,n.viewed,n.pin),this.search=new cM(n.searching),this.room=new Wx(n.rooming),this.report=new kx(n.ask,n.clear),this.viewingPanel=new _M(t,n.viewed),this.scene=y("button",{type:"button",className:"scene",id:"scene",title:"Open another scene",onclick:n.chooseScene},"Open a scene"),this.metric=y("select",{id:"metric",onchange:()=>n.change([{path:"metric",value:this.metric.value}],"")}),this.fusion=y("select",{id:"fusion",title:"How the readings of several devices come together",onchange:()=>n.change([{path:"fusion",value:this.fusion.value}],"")},...vM.map(r=>y("option",{value:r},r))),this.undo=bt("undo","Undo (Ctrl Z)",n.undo),this.redo=bt("redo","Redo (Ctrl Y)",n.redo),this.modes={translate:bt("move","Move the chosen device (G)",()=>n.gizmo("translate")),rotate:bt("turn","Turn the chosen device (R)",()=>n.gizmo("rotate"))},this.help=y("dialog",{className:"help","aria-label":"Keys"},bt("close","Close",()=>this.help.close()),y("h2",{},"Keys and mouse"),y("dl",{},...s.filter(r=>r.keys.length>0).flatMap(r=>[y("dt",{},r.keys.map(Du).join(", ")),y("dd",{},r.name)]),...xM.flatMap(([r,a])=>[y("dt",{},r),y("dd",{},a)]))),this.snap=y("button",{type:"button",className:"word",title:"Snap to 5 cm, 5° and faces (N); turned to them (T)","aria-pressed":"false",onclick:n.snap},"snap"),this.tools=y("div",{className:"tools",role:"toolbar","aria-label":"View"},this.modes.translate,this.modes.rotate,this.snap,bt("fit","Look at the whole room (F)",()=>n.look("corner"))),e.append(this.header(),this.main(),this.start.element,this.addDevice.element,this.array.element,this.palette.element,this.help)}viewport=y("div",{className:"viewport",id:"viewport"});start;devices;report;viewingPanel;addDevice;array;palette;search;room;help;inspector;compare;snap;hand=y("div",{className:"hand",id:"hand",role:"status"});bar=new Fu;scene;metric;fusion;undo;redo;modes;tools;numbers=y("div",{className:"numbers",id:"numbers"});message=y("div",{className:"message",role:"alert"});scaleNote=y("div",{className:"scale-note"});silence=0;header(){const{actions:e}=this;return y("header",{className:"top"},y("span",{className:"brand"},"Delos"),this.scene,y("label",{className:"metric",htmlFor:"metric"},"Metric",this.metric),y("label",{className:"metric",htmlFor:"fusion"},"Fusion",this.fusion),y("span",{className:"space"}),this.undo,this.redo,y("button",{type:"button",className:"word",id:"room-open",title:"What the room is made of (W)",onclick:e.room},"Room"),y("button",{type:"button",className:"word",id:"search-open",title:"Search for a better design (S)","aria-pressed":"false",onclick:e.search},"Search"),bt("save","Save as a scene file",e.save),bt("theme","Dark or light",e.toggleTheme),y("button",{type:"button",className:"word",title:"All commands (Ctrl K)",onclick:()=>this.palette.show()},"Commands"),bt("help","Keys and mouse (?)",()=>this.help.showModal()))}main(){return y("main",{},y("aside",{"aria-label":"Devices and view"},this.devices.element,this.viewingPanel.element),y("div",{className:"centre"},y("div",{className:"middle"},this.viewport,y("div",{className:"top-left"},this.tools,this.compare.element),this.bar.element,y("div",{className:"bottom-left"},this.message,this.hand,this.scaleNote,this.numbers)),this.search.element),y("aside",{"aria-label":"Chosen device and point"},y("section",{className:"panel grow"},this.inspector.element),this.room.element,this.report.element))}describe(e,t){document.title=`${e.name} · Delos`,this.scene.textContent=e.name,this.undo.disabled=e.undo===0,this.redo.disabled=e.redo===0,this.metric.dataset.names!==e.metrics.join()&&(this.metric.dataset.names=e.metrics.join(),this.metric.replaceChildren(...e.metrics.map(n=>y("option",{value:n},n)))),this.metric.value=e.metric.name,this.metric.title=e.definition,this.fusion.value=e.fusion,this.devices.show(e,t),this.viewingPanel.sensitivity.show(e,t),this.inspector.show(e,t)}field(e,t,n,s,r,a){const o=e.field,{summary:l}=o;this.bar.show(t,n,s,r.units),this.viewingPanel.show(t,e.through,n,e.blind,a,ys(e.description),e.shapes),this.compare.show(e.description.pinned!==null,e.difference?.summary??null);const c=l.metric.unit,h=o.largerIsBetter?l.max:l.min,d=o.largerIsBetter?l.min:l.max,u=(m,g)=>y("span",{"data-number":m,"data-value":g??""},`${m} `,y("b",{},Re(g,c)));this.numbers.dataset.level=o.level,this.numbers.dataset.revision=String(o.revision),this.numbers.title=o.definition,this.numbers.replaceChildren(u("best",h?.value),u("mean",l.mean),u("median",l.median),u("worst",d?.value),y("span",{},Bt(l.samples,"sample"),o.level==="coarse"?", refining…":""))}overPicture(e){this.viewport.after(e)}floor(e){this.scaleNote.textContent=`floor squares ${Re(e,"m")}`}gizmoMode(e,t){for(const[n,s]of Object.entries(this.modes))s.disabled=!t,s.setAttribute("aria-pressed",String(n===e))}busy(e){document.body.dataset.busy=String(e)}say(e,t){this.message.textContent=e,this.message.dataset.mood=t,clearTimeout(this.silence),this.silence=window.setTimeout(()=>this.message.textContent="",t==="bad"?12e3:4e3)}handSays(e){this.hand.textContent=e}snapping(e,t){this.snap.textContent=t?"snap, turned":"snap",this.snap.setAttribute("aria-pressed",String(e))}}function ed(i,e){let t=null;const{stage:n,gizmo:s}=i;n.canvas.addEventListener("pointerdown",r=>{e.pressed(),t=s.hovered||r.button!==0?null:{x:r.clientX,y:r.clientY}}),n.canvas.addEventListener("pointerup",r=>{const a=t&&Math.hypot(r.clientX-t.x,r.clientY-t.y)<4;t=null;const o=a&&i.pick(n.ray(r));o&&("device"in o?e.device(o.device):"body"in o?e.body(o.body):e.place(o.at))})}function yM(i,e){const t=document.createElement("a");return t.href=URL.createObjectURL(new Blob([i],{type:"application/yaml"})),t.download=`${e.replace(/[^\w-]+/g,"-").toLowerCase()}.yaml`,t.click(),URL.revokeObjectURL(t.href),t.download}const bM={dark:{background:"#14171f",blindA:"#6a7180",blindB:"#343a47",solid:"#0a0b10",lines:"#8791a5",faint:"#2a303d",bodies:"#8d99b3",beacons:"#ffb454",region:"#6fc3d0",device:"#d5dbe8",selected:"#ff8f4a",sight:"#a9b4c9",probe:"#ff5d8f",lost:"#ff5d5d",edge:"#e8ecf4"},light:{background:"#f4f5f8",blindA:"#a4abb8",blindB:"#dfe3ea",solid:"#ffffff",lines:"#6b7486",faint:"#d5dae3",bodies:"#7d879b",beacons:"#b45f00",region:"#0f7285",device:"#3c4454",selected:"#ad4207",sight:"#76809a",probe:"#c2185b",lost:"#c01818",edge:"#2b3140"}};function SM(){const i=localStorage.getItem("delos-theme");return i==="dark"||i==="light"?i:matchMedia("(prefers-color-scheme: light)").matches?"light":"dark"}function rs(i){document.documentElement.dataset.theme=i;const e=bM[i];return ni.a.setStyle(e.blindA,""),ni.b.setStyle(e.blindB,""),ni.solid.setStyle(e.solid,""),e}class wM{constructor(e){this.stage=e,this.line.frustumCulled=!1;const{canvas:t}=e;t.addEventListener("pointerdown",n=>this.begin(n),!0),t.addEventListener("pointermove",n=>this.move(n),!0),t.addEventListener("pointerup",n=>this.end(n),!0)}line=new pl(new Ye().setAttribute("position",new vt(new Float32Array(12),3)));plane=null;first=null;drawn=null;get at(){return this.drawn!==null}start(e,t,n){this.cancel(),this.plane=new bn(new T(0,0,1),-e),this.drawn=n,this.line.material=jt(`line ${t}`,()=>new Fn({color:t})),this.stage.orbit.enabled=!1,this.stage.canvas.style.cursor="crosshair"}cancel(){this.drawn&&this.finish(null)}finish(e){const{drawn:t}=this;[this.plane,this.first,this.drawn]=[null,null,null],this.line.removeFromParent(),this.stage.orbit.enabled=!0,this.stage.canvas.style.cursor="",this.stage.draw(),t?.(e)}meet(e){return this.plane&&this.stage.ray(e).ray.intersectPlane(this.plane,new T)}begin(e){!this.plane||e.button!==0||(e.stopImmediatePropagation(),this.first=this.meet(e))}move(e){const t=this.first&&this.meet(e);if(!t)return;const{x:n,y:s,z:r}=this.first,a=this.line.geometry.getAttribute("position");a.set([n,s,r,t.x,s,r,t.x,t.y,r,n,t.y,r]),a.needsUpdate=!0,this.stage.scene.add(this.line),this.stage.draw()}end(e){if(!this.plane)return;e.stopImmediatePropagation();const t=this.first&&this.meet(e);if(!t||t.distanceTo(this.first)<.001){this.first=null;return}const{x:n,y:s,z:r}=this.first,a=o=>Number(o.toFixed(3));this.finish({min:[Math.min(n,t.x),Math.min(s,t.y),r].map(a),max:[Math.max(n,t.x),Math.max(s,t.y),r].map(a)})}}class EM{constructor(e,t,n,s,r){this.panel=e,this.search=t,this.shown=s,this.steps=r,this.painter=new wM(n.stage)}painter;session=null;asked=-1;paths=[];open(e){this.session=e,this.asked=-1,this.paths=this.pathsNow(),this.painter.cancel()}describe(){const{description:e}=this.shown;this.follow(),!(!e||!this.panel.open&&!this.search.open||this.asked===e.revision)&&(this.asked=e.revision,this.ask())}follow(){const e=this.paths,t=this.paths=this.pathsNow(),n=t.filter(o=>!e.includes(o)),{body:s}=this.shown,r=s!==null&&!t.includes(s);r&&(this.shown.body=null),(t.length===e.length+1||r&&t.length===e.length)&&n.length===1?this.choose(n[0]):r&&this.steps.chosen()}pathsNow(){const{around:e}=this.shown;return[...e.occluders,...e.regions].map(t=>t.path).filter(Boolean)}async ask(){const{session:e}=this;try{const{sections:t}=await e.ask("form");if(e!==this.session)return;const{room:n}=this.shown.description;this.panel.show(t,n),this.search.form(t,n),this.shown.body&&this.panel.reveal(this.shown.body)}catch(t){this.steps.failed(t)}}toggle(){this.panel.element.hidden=!this.panel.element.hidden,this.panel.open?(this.describe(),this.panel.element.focus()):this.choose(null)}opened(e){this.pathsNow().includes(e)&&this.choose(e)}choose(e){e!==this.shown.body&&(this.shown.body=e,e&&(this.shown.selected=null,this.panel.element.hidden=!1,this.panel.reveal(e)),this.steps.chosen())}next(e){const t=this.pathsNow(),n=t.indexOf(this.shown.body??"");t.length>0&&this.choose(t[n<0?0:(n+e+t.length)%t.length])}shape(e,t){const n=this.shown.body;this.steps.change(`shape ${n}`,"shape",{path:n,gesture:t,...e})}paint(e,t,n){const{box:s}=this.shown.description,r=t.slices[2]&&t.at[2]>s.min[2]?t.at[2]:s.min[2];this.steps.say(`Drag a rectangle at z = ${Number(r.toFixed(3))} m; Esc gives it up`),this.painter.start(r,n,a=>{this.steps.say(""),a&&this.steps.change(mn(),"paint",{what:e,...a})})}take({key:e}){return!this.painter.at||e!=="Escape"?!1:(this.painter.cancel(),!0)}}const TM=(i,e)=>({edit:(t,n)=>e(`edit ${t.map(s=>s.path).join()}${n?"":mn()}`,"edit",{set:t,gesture:n}),copyPart:t=>e(mn(),"copy_part",{path:t}),renamePart:(t,n)=>e(mn(),"rename_part",{path:t,name:n}),open:t=>i().opened(t)});class AM{constructor(e,t){this.panel=e,this.steps=t}searches=new Qx;line=new eM((e,t)=>this.heard(e,t));session=null;description=null;asked=-1;async open(e){this.session=e,this.asked=-1,this.searches.clear();const{searches:t}=await e.ask("searches");for(const n of t)this.searches.take(n,!0);this.panel.show(this.searches),this.line.open(e.name)}describe(e,t){this.description=e;const{devices:n,types:s}=e;this.panel.choose(n.find(r=>r.name===t)??null,n,s),!(!this.panel.open||this.asked===e.revision)&&(this.asked=e.revision,this.attempt(async r=>this.panel.task(await r.ask("task"))))}toggle(e){this.panel.toggle(),this.description&&this.panel.open&&this.describe(this.description,e)}begin(){this.panel.open&&this.panel.begin()}pauseOrResume(){const{now:e}=this.searches;e&&this.do(qi(e)?"search_pause":"search_resume")}do(e,t={}){this.attempt(async n=>{const s=await n.ask(e,t);n===this.session&&this.heard(s,!0)})}change(e,t={}){this.steps.change(mn(),e,t)}async terms(e,t){let n=null;return await this.attempt(async s=>{n=await s.ask("terms",{search:e,incumbents:t})}),n}async attempt(e){try{this.session&&await e(this.session)}catch(t){this.steps.failed(t)}}heard(e,t){const n=this.searches.take(e,t);if(this.panel.show(this.searches),e.kind!=="search")return;const s=e.incumbents.length>(n?.kind==="search"?n.incumbents.length:0);(qi(e)?s:qi(n)&&e.judged)&&this.steps.change("search follow","search_follow",{})}}const RM=(i,e)=>({form:e,terms:(t,n)=>i().terms(t,n),vary:t=>i().change("vary",t),fix:t=>i().change("fix",{path:t}),lock:(t,n)=>i().do("search_lock",{path:t,locked:n}),start:t=>i().do("search_start",t),select:t=>i().do("select_start",t),front:t=>i().do("front_start",t),pause:()=>i().do("search_pause"),resume:t=>i().do("search_resume",t),accept:()=>i().change("search_accept"),reject:()=>i().change("search_reject"),minimize:t=>{t&&i().change("change",{set:[{path:"objective",value:`{minimize: ${t}}`}],gesture:""})},reinstate:(t,n)=>i().change("search_reinstate",{search:t,...n})}),CM=46,Rr=Math.PI/12,vh=[{view:"top",word:"top",name:"Look from above (7)",normal:new T(0,0,1),right:new T(1,0,0)},{view:"front",word:"front",name:"Look from the front (1)",normal:new T(0,-1,0),right:new T(1,0,0)},{view:"side",word:"right",name:"Look from the right (3)",normal:new T(1,0,0),right:new T(0,1,0)},{view:"back",word:"back",name:"Look from the back (Ctrl 1)",normal:new T(0,1,0),right:new T(-1,0,0)},{view:"left",word:"left",name:"Look from the left (Ctrl 3)",normal:new T(-1,0,0),right:new T(0,-1,0)},{view:"below",word:"below",name:"Look from below (Ctrl 7)",normal:new T(0,0,-1),right:new T(1,0,0)}],PM={ArrowLeft:[-Rr,0],ArrowRight:[Rr,0],ArrowUp:[0,Rr],ArrowDown:[0,-Rr]};class td{constructor(e,t,n){this.stage=e,this.buttons=vh.map(({view:r,word:a,name:o})=>y("button",{type:"button",className:"face",title:o,"aria-label":o,"data-view":r,onclick:()=>t(r)},a)),this.flat=y("button",{type:"button",className:"flat",id:"orthographic",title:"Without perspective (5)","aria-pressed":"false",onclick:n},"orthographic");const s=y("div",{className:"cube",role:"group","aria-label":"View from; arrow keys turn"},...this.buttons);s.addEventListener("keydown",r=>{const a=PM[r.key];a&&(r.preventDefault(),e.turn(...a))}),this.element=y("div",{className:"view-cube"},s,this.flat),e.drew.push(()=>this.turnFaces())}element;buttons;flat;turnFaces(){const{camera:e,eye:t}=this.stage;this.flat.setAttribute("aria-pressed",String(t.orthographic));const n=new Ge().makeRotationFromQuaternion(e.quaternion).transpose(),s=r=>{const{x:a,y:o,z:l}=r.clone().applyMatrix4(n);return new T(a,-o,l)};vh.forEach(({normal:r,right:a},o)=>{const l=s(r),c=s(a),h=s(a.clone().cross(r)),d=l.clone().multiplyScalar(CM/2),u=[c,h,l,d].flatMap((g,v)=>[...g.toArray(),v===3?1:0]),m=this.buttons[o];m.style.transform=`matrix3d(${u.map(g=>g.toFixed(4)).join(",")})`,m.dataset.away=String(l.z<.05)})}}const LM=150,DM=i=>new Promise((e,t)=>{i.throwIfAborted();const n=setTimeout(e,LM);i.addEventListener("abort",()=>{clearTimeout(n),t(i.reason)})});class NM{constructor(e){this.steps=e}waiting=new Map;running=!1;abort=new AbortController;gone=new AbortController;stale=!1;change(e,t,n){const s=this.waiting.get(e);this.waiting.delete(e),this.waiting.set(e,{verb:t,body:{...s?.body,...n}}),this.start()}forget(){this.waiting.clear(),this.abort.abort(),this.gone.abort(),this.gone=new AbortController}refresh(){this.stale=!0,this.start()}start(){this.abort.abort(),this.running||this.run()}async run(){for(this.running=!0,this.steps.busy(!0);this.waiting.size>0||this.stale;){const e=this.waiting.entries().next().value;try{e&&(this.waiting.delete(e[0]),await this.steps.change(e[1].verb,e[1].body)),this.stale=!1,this.abort=new AbortController;const{signal:t}=this.abort;await this.steps.draw(this.gone.signal),e&&"gesture"in e[1].body&&e[1].body.gesture!==""&&await DM(t),this.waiting.size===0&&!this.stale&&await this.steps.rest(t)}catch(t){t instanceof DOMException&&t.name==="AbortError"||t instanceof ws&&t.status===409||this.steps.failed(t)}}this.running=!1,this.steps.busy(!1)}}const Za="delos-session",IM=60;class UM{layout;picture;work;answers;holding;searching;rooming;viewing=Zo();shown=Kr();theme=SM();colours=rs(this.theme);session=null;waiting=0;awaited=null;constructor(e){const t={viewing:this.viewing,viewed:()=>this.viewed(),look:r=>this.look(r),lookThrough:()=>this.lookThrough(),orthographic:()=>this.picture.stage.setOrthographic(!this.picture.stage.eye.orthographic),move:r=>this.holding.move(r),letGo:()=>this.letGo(),next:r=>this.chooseNext(r),add:()=>void this.askPalette(),copy:()=>this.make("copy",{device:this.shown.selected,by:this.besideIt()}),array:()=>this.layout.array.show(this.shown.description,this.shown.selected),mirror:r=>this.make("mirror",{device:this.shown.selected,axis:r}),remove:()=>this.work.change(mn(),"remove",{device:this.shown.selected}),pin:r=>this.pin(r),undo:()=>this.step("undo"),redo:()=>this.step("redo"),save:()=>void this.save(),open:()=>void this.chooseScene(),theme:()=>this.toggleTheme(),snap:()=>this.holding.snap(),turnToFaces:()=>this.holding.turnToFaces(),room:()=>this.rooming.toggle(),paint:()=>this.rooming.paint(this.layout.room.chosen,this.viewing,this.colours.selected),nextBody:r=>this.rooming.next(r),search:()=>{this.searching.toggle(this.shown.selected),this.rooming.describe()},beginSearch:()=>this.searching.begin(),pauseSearch:()=>this.searching.pauseOrResume(),keepSearch:()=>this.layout.search.keep(),rejectSearch:()=>this.searching.change("search_reject"),slice:r=>this.layout.viewingPanel.slices.toggle(r),slant:()=>this.layout.viewingPanel.slices.addSlant(),commands:()=>this.layout.palette.show(),help:()=>this.layout.help.showModal(),hasScene:()=>this.session!==null,hasDevice:()=>this.shown.selected!==null,hasBody:()=>this.shown.body!==null,hasPin:()=>this.shown.description?.pinned!=null},n=Mx(t),s=TM(()=>this.rooming,(r,a,o)=>this.work.change(r,a,o));this.layout=new MM(e,this.viewing,{...t,open:r=>void this.open(r),chooseScene:t.open,select:r=>this.select(r),change:(r,a)=>this.work.change(r.map(o=>o.path).join(),"change",{set:r,gesture:a}),place:(r,a)=>this.holding.place(r,a),toggleTheme:t.theme,ask:r=>this.ask(r),clear:()=>this.ask(null),gizmo:t.move,askPalette:t.add,makeArray:r=>this.make("array",{device:this.shown.selected,...r}),add:(r,a)=>this.make("add",{type:r,preset:a,...this.shown.asked?{at:this.shown.asked}:{}}),set:r=>this.work.change(r.path,"change",{set:[r],gesture:""}),searching:RM(()=>this.searching,s),rooming:{...s,paint:t.paint,close:t.room}},n),this.picture=new Lu(this.layout.viewport,this.viewing,(r,a)=>this.holding.drag(r,a),()=>this.described()),this.picture.stage.background(this.colours.background),this.answers=new ax(this.shown,this.viewing,{drawn:()=>{this.described(!1),this.render()},answered:()=>this.showProbe(),uncertain:()=>this.showUncertainty(),valued:r=>this.layout.devices.value(r),shapes:()=>this.picture.shapesAsked(this.shown),refused:r=>this.failed(r)}),this.work=new NM({change:(r,a)=>this.change(r,a),draw:r=>this.answers.draw(this.session,r),rest:r=>this.answers.rest(this.session,r),failed:r=>this.failed(r),busy:r=>this.layout.busy(r)}),this.searching=new AM(this.layout.search,{change:(r,a,o)=>this.work.change(r,a,o),failed:r=>this.failed(r)}),this.rooming=new EM(this.layout.room,this.layout.search,this.picture,this.shown,{change:(r,a,o)=>this.work.change(r,a,o),failed:r=>this.failed(r),say:r=>this.layout.handSays(r),chosen:()=>{this.drawRoom(),this.described()}}),this.holding=new dx(this.layout,this.picture,this.shown,this.rooming,{change:(r,a,o)=>this.work.change(r,a,o),undo:()=>this.step("undo")}),ed(this.picture,{pressed:()=>this.holding.end(),device:r=>this.select(r),body:r=>this.rooming.choose(r),place:r=>this.ask(r)}),this.layout.overPicture(new td(this.picture.stage,t.look,t.orthographic).element),cx(n,r=>this.holding.take(r))}async start(){const e=sessionStorage.getItem(Za);if(e)try{return await this.opened(...await Ps.resume(e))}catch{sessionStorage.removeItem(Za)}const{first:t}=await lh();t?await this.open(t):await this.chooseScene()}async chooseScene(){await this.attempt(async()=>this.layout.start.show(await lh()))}async open(e){await this.attempt(async()=>this.opened(...await Ps.open(e)))}async askPalette(){await this.attempt(async()=>this.layout.addDevice.show(await this.session.ask("palette")))}async attempt(e){try{await e()}catch(t){this.failed(t)}}async opened(e,t){this.work.forget(),this.session=e,sessionStorage.setItem(Za,e.name),Object.assign(this.shown,Kr(),{description:t}),this.ask(null),Object.assign(this.viewing,{slices:[!1,!1,!0],at:Ml(t.box),slants:[],relief:!1,cells:!1,through:Zo().through,surface:!1,body:"none",compare:"design",sensitivity:"",low:null,high:null}),this.shown.around=await e.ask("around"),this.rooming.open(e),this.drawRoom(),this.picture.stage.look("corner",t.room),this.described(),this.work.refresh(),await this.searching.open(e)}async change(e,t){const{session:n}=this,s=await n.ask(e,t),r=s.surroundings!==this.shown.description.surroundings,a=r?await n.ask("around"):this.shown.around;n===this.session&&(this.layout.devices.stale(),this.shown.around=a,this.take(s),r&&this.drawRoom())}take(e){const{shown:t}=this;e.pinned!==t.description.pinned&&([t.pinned,t.difference]=[null,null]),e.pinned===null&&(this.viewing.compare="design");const n=new Set(e.devices.map(r=>r.name)),s=this.awaited&&[...n].find(r=>!this.awaited.has(r));s&&(t.selected=s),t.selected&&!n.has(t.selected)&&(t.selected=null),this.awaited=null,t.description=e,clearTimeout(this.waiting),this.waiting=window.setTimeout(()=>this.described(),IM)}described(e=!0){const{shown:t,picture:n}=this;clearTimeout(this.waiting),t.description&&(this.layout.describe(t.description,t.selected),this.searching.describe(t.description,t.selected),this.rooming.describe(),n.drawDevices(t,this.colours),n.stage.eye.asDevice&&this.lookThrough(),this.layout.gizmoMode(n.gizmo.mode,this.holding.held),e&&n.stage.draw())}render(){const{shown:e,picture:t}=this;if(!e.field||!e.description)return;const{drawn:n,scale:s,marks:r}=t.drawField(e,this.colours);this.layout.field(e,n,s,r,this.viewing,t.latticeEnlarged),t.stage.describe(Th(n)),t.stage.draw()}viewed(){this.render(),this.described(),this.showProbe(),this.showUncertainty(),this.shown.description&&this.answers.lacking?this.work.refresh():this.shown.field&&this.reshape()}reshapes=0;async reshape(){document.body.dataset.shaping=String(++this.reshapes>0),await this.attempt(()=>this.answers.reshape(this.session)),document.body.dataset.shaping=String(--this.reshapes>0)}drawRoom(){this.layout.floor(this.picture.drawRoom(this.shown,this.colours)),this.showProbe()}select(e){this.holding.end(),this.shown.selected=e,e&&this.rooming.choose(null),this.described()}chooseNext(e){const t=this.shown.description.devices.map(s=>s.name),n=t.indexOf(this.shown.selected??"");this.select(t[n<0?0:(n+e+t.length)%t.length]??null)}letGo(){this.picture.stage.eye.asDevice?this.look("corner"):this.shown.selected?this.select(null):this.shown.body?this.rooming.choose(null):this.ask(null)}ask(e){Object.assign(this.shown,{asked:e,report:null}),this.showProbe(),e?this.work.refresh():this.layout.report.clear()}showProbe(){const{shown:e,picture:t,viewing:n}=this;t.drawProbe(e,this.colours),e.asked&&e.report&&this.layout.report.show(e.report,e.description.metric,t.enlarged,n.sigmas),t.stage.draw()}showUncertainty(){this.picture.drawUncertainty(this.shown,this.colours),this.shown.field&&this.render(),this.picture.stage.draw()}look(e){this.picture.stage.look(e),this.described()}lookThrough(){const e=this.shown.description.devices.find(t=>t.name===this.shown.selected);e?.pose?this.picture.lookThrough(e):this.picture.stage.look("corner")}step(e){this.session&&this.work.change(mn(),e,{})}pin(e){e&&(this.viewing.compare="difference"),this.work.change(mn(),e?"pin":"unpin",{})}make(e,t){this.awaited=new Set(this.shown.description.devices.map(n=>n.name)),this.work.change(mn(),e,t)}besideIt(){return[this.picture.stepBeside(this.shown),0,0]}toggleTheme(){this.theme=this.theme==="dark"?"light":"dark",localStorage.setItem("delos-theme",this.theme),this.colours=rs(this.theme),this.picture.stage.background(this.colours.background),this.shown.description&&(this.drawRoom(),this.viewed())}async save(){await this.attempt(async()=>{const e=yM(await this.session.text(),this.shown.description.name);this.layout.say(`Saved as ${e}`,"good")})}failed(e){const t=e instanceof TypeError;this.awaited=null,this.layout.say(t?"The server has ended: start delos explore again.":e.message,"bad"),this.described()}}function FM(){const i=document.getElementById("frozen")?.textContent;return i?JSON.parse(i):null}const Cr=i=>Eh(Uint8Array.from(atob(i),e=>e.charCodeAt(0)).buffer),Ka=(i,e)=>({...i,revision:0,undo:0,redo:0,surroundings:0,pinned:e});function OM(i){if(i.kind==="scene"){const{design:s,lattice:r,blind:a}=i;return{...Kr(),description:Ka(s.description,null),around:s.around,field:Cr(s.field),lattice:r,blind:a}}const{before:e,after:t,difference:n}=i;return{...Kr(),description:Ka(t.description,0),around:t.around,field:Cr(t.field),difference:Cr(n),pinned:{description:Ka(e.description,null),field:Cr(e.field)}}}const Ja=i=>`${i.map(e=>Number(e.toFixed(4))).join(", ")} m`,nd=(i,e)=>typeof i=="number"?Re(i,e,5):Array.isArray(i)?`[${i.map(t=>nd(t,"1")).join(", ")}]`:String(i??"");function BM(i,e){const t=i.pose?["place",Ja(i.pose.p)]:["on the target",Ja(i.at)],n=s=>e.types[i.type].params.find(r=>r.name===s)?.unit??"1";return[t,...i.facing==="aim"?[["looks at",Ja(i.value)]]:[],["rate",Re(i.rate,"1/s",5)],...Object.entries(i.params).map(([s,r])=>[s,nd(r,n(s))])]}class kM{element=y("section",{className:"panel grow",id:"chosen","aria-label":"Chosen device",tabIndex:0});show(e,t){const n=e.devices.find(r=>r.name===t);if(!n)return this.element.replaceChildren(y("p",{className:"hint"},"Choose a device in the list or in the picture to read its numbers."));const s=e.types[n.type];this.element.replaceChildren(y("h2",{},n.name),y("p",{className:"type"},s.id),y("p",{className:"summary"},s.summary),y("table",{},y("tbody",{},...BM(n,e).map(([r,a])=>y("tr",{},y("th",{scope:"row"},r),y("td",{},a))))))}}const zM=20;class HM{constructor(e,t,n){this.shown=e;const{viewing:s}=this,{min:r}=e.field.summary,a=e.field.summary.max?.value??0;s.logarithmic=r!==null&&r.value>0&&a>zM*r.value,s.at=Ml(e.description.box),this.colours=rs(n);const o=()=>this.viewed();this.devices=new Bu(c=>this.select(c),null),this.slices=new ju(s,o,!1),this.colouring=new Ju(s,o),this.uncertainty=new Qu(s,o),this.compare=new ku(s,o,null),this.picture=new Lu(this.viewport,s,null,()=>{});const{stage:l}=this.picture;l.background(this.colours.background),l.orbit.enableZoom=!1,l.canvas.addEventListener("focus",()=>l.orbit.enableZoom=!0),l.canvas.addEventListener("blur",()=>l.orbit.enableZoom=!1),ed(this.picture,{pressed:()=>l.canvas.focus({preventScroll:!0}),device:c=>this.select(c),body:()=>{},place:()=>{}}),this.compare.element.hidden=e.pinned===null,this.element=this.laidOut(),this.devices.show(e.description,null),t?this.devices.value(t):this.devices.unweighed()}element;viewing=Zo();picture;viewport=y("div",{className:"viewport",id:"viewport"});bar=new Fu;devices;chosen=new kM;slices;colouring;uncertainty;compare;floor=y("div",{className:"scale-note"});colours;laidOut(){const{viewing:e,picture:t,shown:n}=this,s=l=>In(`view-${l}`,l,c=>{e[l]=c,this.viewed()}),r=["frusta","names"].map(l=>{const[c,h]=s(l);return h.checked=e[l],c}),a=new td(t.stage,l=>t.stage.look(l),()=>t.stage.setOrthographic(!t.stage.eye.orthographic)),o=y("section",{className:"panel viewing",tabIndex:0,"aria-label":"View"},y("h2",{},"View"),this.slices.element,y("div",{className:"checks"},...r),Ls("Colours",!1,this.colouring.element),...n.lattice?[Ls("Uncertainty",!1,this.uncertainty.element)]:[]);return y("section",{className:"interactive","aria-label":"Picture"},y("div",{className:"side"},this.devices.element,o),y("div",{className:"middle"},this.viewport,a.element,y("div",{className:"top-left"},y("div",{className:"tools"},bt("fit","Look at the whole room",()=>t.stage.look("corner")))),this.bar.element,y("div",{className:"bottom-left"},this.compare.element,this.floor)),y("div",{className:"side"},this.chosen.element))}begin(){this.room(),this.picture.stage.look("corner",this.shown.description.room),this.viewed()}paint(e){this.colours=rs(e),this.picture.stage.background(this.colours.background),this.room(),this.viewed()}room(){this.floor.textContent=`floor squares ${Re(this.picture.drawRoom(this.shown,this.colours),"m")}`}select(e){this.shown.selected=e,this.described()}described(){const{shown:e,picture:t}=this;this.devices.show(e.description,e.selected),this.chosen.show(e.description,e.selected),t.drawDevices(e,this.colours),t.stage.draw()}viewed(){const{shown:e,picture:t,viewing:n}=this;t.drawUncertainty(e,this.colours);const{drawn:s,scale:r,marks:a}=t.drawField(e,this.colours);this.bar.show(s,r,a,n.units),this.slices.show(s),this.colouring.show(s),this.uncertainty.show(e.blind,t.latticeEnlarged),this.compare.show(e.pinned!==null,e.difference?.summary??null),t.stage.describe(Th(s)),this.described()}}const jo=i=>typeof i=="object"&&!(i instanceof Node),gn=(i,e,t=3,n="none")=>i==null||!Number.isFinite(i)?{text:n,value:null}:{text:Re(i,e,t),value:i},wl=i=>({text:String(i),value:i});function El(i,e=""){if(i==null||!Number.isFinite(i))return{text:e,value:null};const t=Number((100*Math.abs(i)).toPrecision(3));return{text:t===0?"0 %":`${i<0?"−":"+"}${t} %`,value:i}}const Tl=(i,e)=>y("span",{className:i?"good":"bad"},e);function GM(i,e,t){return jo(e)?y(i,{className:"n","data-column":t,"data-value":e.value??""},e.text):y(i,{},e)}function sn(i,e,t,n){const s=o=>n.some(l=>jo(l[o])),r=t.map((o,l)=>o===""?y("td"):y("th",{scope:"col",className:s(l)?"n":""},o)),a=n.map(o=>{const[l,...c]=o,h=y("th",{scope:"row"},jo(l)?l.text:l);return y("tr",{"data-row":h.textContent},h,...c.map((d,u)=>GM("td",d,t[u+1])))});return y("div",{className:"wide",role:"region","aria-label":e.split(".")[0],tabIndex:0},y("table",{id:i},y("caption",{},e),t.some(Boolean)&&y("thead",{},y("tr",{},...r)),y("tbody",{},...a)))}const Vt=(i,...e)=>y("section",{"aria-label":i},y("h2",{},i),...e),rn=(i,e="")=>y("p",{className:e},i),Jr=(i,e)=>y("pre",{tabIndex:0,role:"region","aria-label":i},e),Qo=i=>(Math.abs(i)<5e-4?0:i).toFixed(3),xh=i=>i.map(Qo).join(", "),ja=i=>i===null?"":{text:`${(i*180/Math.PI).toFixed(1)}°`,value:i},Yi={width:860,height:430},ei={left:52,right:14,top:30,bottom:44};function VM(i){const e=[...i].sort((n,s)=>n[0]-s[0]||n[1]-s[1]),t=n=>{const s=[];for(const r of n){for(let a=s.length;a>=2;a=s.length){const[o,l]=[s[a-2],s[a-1]];if((l[0]-o[0])*(r[1]-l[1])-(l[1]-o[1])*(r[0]-l[0])>0)break;s.pop()}s.push(r)}return s.slice(0,-1)};return[...t(e),...t(e.reverse())]}function WM({walls:i,samples:e,devices:t}){const n=[...i?[i.min,i.max]:[],e.min,e.max,...t.map(l=>l.at)].filter(l=>l.every(Number.isFinite)),s=l=>[0,1,2].map(c=>l(...n.map(h=>h[c]))),[r,a]=[s(Math.min),s(Math.max)],o=.06*Math.max(.1,Math.hypot(...a.map((l,c)=>l-r[c])));return{min:r.map(l=>l-o),max:a.map(l=>l+o)}}class XM{constructor(e,t){this.installation=e,this.wide=t,this.extent=WM(e);const[n,s,r]=this.extent.max.map((a,o)=>a-this.extent.min[o]);this.scale=Math.min((t-ei.left-ei.right)/n,(Yi.height-ei.top-ei.bottom)/Math.max(s,r))}scale;extent;on({axes:[e,t],left:n},s){const{min:r}=this.extent;return[n+ei.left+(s[e]-r[e])*this.scale,Yi.height-ei.bottom-(s[t]-r[t])*this.scale]}box(e,{min:t,max:n},s){const[[r,a],[o,l]]=[this.on(e,t),this.on(e,n)];return ft("rect",{x:r.toFixed(1),y:l.toFixed(1),width:(o-r).toFixed(1),height:(a-l).toFixed(1),class:s})}axes(e){const{min:t,max:n}=this.extent,s=this.installation.walls?.min??[0,0,0],r=Yi.height-ei.bottom,a=e.left+ei.left,o=this.on(e,n)[1],l=this.on(e,n)[0],[c,h]=e.axes,d=v=>new ts(t[v]-s[v],n[v]-s[v],!1,!0).ticks(1),u=(v,f)=>t.map((p,x)=>x===v?f+s[v]:p),m=(o+r)/2,g=Wt(e.left+12,m,e.names[1],"middle");return g.setAttribute("transform",`rotate(-90 ${e.left+12} ${m.toFixed(1)})`),[ft("rect",{x:a,y:o.toFixed(1),width:(l-a).toFixed(1),height:(r-o).toFixed(1),class:"frame"}),...d(c).flatMap(v=>{const[f]=this.on(e,u(c,v));return[ft("line",{x1:f,x2:f,y1:r,y2:r+4,class:"tick"}),Wt(f,r+16,String(Number(v.toFixed(6))),"middle")]}),...d(h).flatMap(v=>{const[,f]=this.on(e,u(h,v));return[ft("line",{x1:a-4,x2:a,y1:f,y2:f,class:"tick"}),Wt(a-7,f+4,String(Number(v.toFixed(6))),"end")]}),Wt(a,o-8,e.title),Wt((a+l)/2,r+34,e.names[0],"middle"),g]}sight(e,t,n){if(n.length===0)return[];const s=VM([t,...n].map(r=>this.on(e,r)));return[ft("polygon",{points:s.map(r=>r.map(a=>a.toFixed(1)).join()).join(" "),class:"sight"})]}arrow(e,t,n){const s=n?.map((u,m)=>u-t[m])??[0,0,0],r=Math.hypot(...s);if(r===0)return[];const[a,o]=this.on(e,t),[l,c]=e.axes,[h,d]=[26*s[l]/r,26*s[c]/r];return[ft("line",{x1:a,y1:o,x2:a+h,y2:o-d,class:"arrow"})]}numbers(e){const t=[];this.installation.devices.forEach(({at:s},r)=>{const[a,o]=this.on(e,s),l=t.find(c=>Math.hypot(c.at[0]-a,c.at[1]-o)<12);l?l.numbers.push(r+1):t.push({at:[a,o],numbers:[r+1]})});const n=e.left+this.wide/2;return t.map(({at:[s,r],numbers:a})=>Wt(s+(s>n?-8:8),r-7,a.join(", "),s>n?"end":"start"))}view(e){const{walls:t,samples:n,devices:s}=this.installation,r=`within-${e.left}`,a=ft("g",{"clip-path":`url(#${r})`},...s.flatMap(l=>this.sight(e,l.at,l.view))),o=ft("g",{class:"numbers-of-devices"},...this.numbers(e));return[ft("clipPath",{id:r},this.box(e,this.extent,"")),a,...t?[this.box(e,t,"walls")]:[],...n.min.every(Number.isFinite)?[this.box(e,n,"samples")]:[],...this.axes(e),...s.flatMap((l,c)=>{const[h,d]=this.on(e,l.at);return[...this.arrow(e,l.at,l.aim),ft("circle",{cx:h,cy:d,r:4,class:"device"},ft("title",{},`${c+1}: ${l.name}`))]}),o]}}function $M(i){const e=Yi.width/2,t=new XM(i,e),n=i.walls?["m from the left wall","m from the front wall","m above the floor"]:["x, m","y, m","z, m"],s=[{title:"plan, from above",axes:[0,1],names:[n[0],n[1]],left:0},{title:"elevation, from the front",axes:[0,2],names:[n[0],n[2]],left:e}],r=ft("svg",{viewBox:`0 0 ${Yi.width} ${Yi.height}`,class:"rig",role:"img","aria-label":"Where the devices stand and which way they look, from above and from the front, numbered as in the table; what they see half of the way to the samples"},...s.flatMap(o=>t.view(o))),a=`Numbers are those of the table${i.walls?"; the walls are drawn thick":""}. The dashed box holds the samples. Shaded: what a device sees, half of the way to them.`;return y("figure",{},r,y("figcaption",{},a))}function id(i){const{devices:e,walls:t}=i;if(e.length===0)return rn("The target carries all devices.");const n=["no.","device","x, y, z [m]",...t?["from the walls [m]"]:[],"aim [m]","pan","tilt","roll"],s=e.map((a,o)=>[String(o+1),a.name,xh(a.at),...t?[a.from.map(({wall:l,distance:c})=>l==="floor"?`${Qo(c)} up`:`${Qo(c)} ${l}`).join(", ")]:[],a.aim?xh(a.aim):"all around",ja(a.pan),ja(a.tilt),ja(a.roll)]),r=t?" Walls are those of the scene’s room: left and right across x, front and back across y, the nearer one of each; heights are above its floor.":" The scene has no room: measure from where its x, y and z begin.";return y("div",{},$M(i),sn("installation",`Where each device is to stand and look. Pan is from x towards y, tilt above the horizon, roll clockwise as seen from behind; the aim is the point of its axis nearest to what it looks at.${r}`,n,s))}function sd(i,e){const t=i.map(c=>c.summary),n=i[0].largerIsBetter,{name:s,unit:r}=t[0].metric,a=(c,h)=>{if(c==null||h===null||h===void 0||c===0)return"";const d=h/c-1;return d===0?"0 %":Tl(n?d>0:d<0,El(d).text)},o=(c,h)=>{const d=t.map(h);return[c,...d.map(u=>gn(u,r)),...t.length===2?[a(d[0],d[1])]:[]]},l=(c,h)=>{const d=t.map(h),u=d[d.length-1]-d[0];return[c,...d.map(wl),...t.length===2?[u===0?"":`${u>0?"+":"−"}${Math.abs(u)}`]:[]]};return sn("figures",`${s}, over the samples at which it is finite`,["",...e,...t.length===2?["change"]:[]],[o("least",c=>c.min?.value),o("median",c=>c.median),o("mean",c=>c.mean),o(n?"95 % at least":"95 % at most",c=>c.p95),o("greatest",c=>c.max?.value),l("samples",c=>c.samples),l("observable samples",c=>c.observable),l("one direction short",c=>c.one_short??0)])}const rd=i=>sn("versions","Versions",["part","version"],i.map(e=>[e.part,e.version])),qM=i=>/^[\w./=,:+-]+$/.test(i)?i:`'${i.replaceAll("'","'\\''")}'`,jr=i=>`(${i.map(e=>Number(e.toPrecision(3))).join(", ")})`,ad=({min:i,max:e})=>`${jr(i)} to ${jr(e)} m`;function YM({devices:i}){const e=new Map;for(const{type:t}of i)e.set(t,(e.get(t)??0)+1);return[...e].map(([t,n])=>`${n} ${t}`).join(", ")}function ZM({design:{description:i,around:e}},t){const{summary:n}=t,s=[["metric",`${n.metric.name} of the ${t.definition}`],["devices",YM(i)],["samples",`${n.samples} within ${ad(i.box)}`],["hides the view",e.occluders.length>0?e.occluders.map(r=>r.name).join(", "):"nothing"],...e.beacons.length>0?[["beacons",Bt(e.beacons.length,"beacon")]]:[]];return sn("facts","The scene",["",""],s)}function KM({design:{description:i},sees:e,worth:t}){const n=new Map(t.devices.map(o=>[o.name,o])),s=o=>{const l=n.get(o);return l?l.rise===null?{text:l.blinded>0?"all is lost":"undefined",value:null}:El(l.rise):""},r=i.devices.map(o=>[o.name,o.type,o.pose?`${jr(o.pose.p)} m`:`on the target, ${jr(o.at)} m`,{text:`${Number((100*(e[o.name]??0)).toPrecision(3))} %`,value:e[o.name]??0},n.has(o.name)?wl(n.get(o.name).lost):"",s(o.name)]),a=t.devices.length===0?". There is but one, which is worth all":`, both over ${Bt(t.samples,"sample")}`;return sn("devices",`What each device sees, and what its failure alone would cost: samples that are no longer observable, and by how much the mean of ${i.metric.name} over those that remain gets worse${a}`,["device","type","at","sees","samples lost","mean"],r)}function Qa({samples:i,views:e},t){const n=e.filter(s=>s[t]>0).map(s=>s.device+(s[t]===i?"":` (${s[t]})`));return n.length>0?n.join(", "):"—"}function JM({blind:i}){const{regions:e}=i;if(e.length===0)return[rn("None: every sample outside solids is observable.")];const t=e.map(s=>[String(s.samples),ad(s.box),s.why,Qa(s,"sees"),Qa(s,"hidden"),Qa(s,"beyond")]),n=i.samples-e.reduce((s,r)=>s+r.samples,0);return[sn("blind","Neighbouring samples that aren’t observable, the largest region first. Numbers in brackets: samples of the region, where it isn’t all of it",["samples","from, to","why","seen by","hidden from","outside the view of"],t),...n>0?[rn(`And ${Bt(i.count-e.length,"smaller region")} with ${Bt(n,"sample")}.`,"note")]:[]]}function jM(i,e,t){const n=qM(i.file),s=e.values.length<e.summary.samples?rn(`The picture is of ${e.values.length} samples; the figures are of all.`,"note"):null;return y("article",{},Vt("The field",ZM(i,e),t,s,sd([e],[e.summary.metric.name])),Vt("Devices",KM(i)),Vt("To install it",id(i.installation)),Vt("Blind regions, and why",...JM(i)),Vt("To compute it again",Jr("Commands",`delos field ${n}
delos report ${n} -o report.html`),rd(i.versions),y("h3",{},"The scene, in SI units"),Jr("Scene file",i.text)))}const QM={width:760,height:260};function ey({across:i,of_limit:e,objective:t,points:n,cheapest:s}){const r=n.map(o=>[gn(o.across,i.unit,4).text,gn(o.used,e?i.unit:"1",4),gn(o.objective,t.unit,4),o.kept?o.dominated?"yes, but no better than a tighter limit":"yes":Tl(!1,"no")]),a=n.map(o=>({...o,x:e&&o.kept?o.used:o.across}));return Vt(e?`Accuracy against ${i.name}`:"Accuracy against the number of devices",n.length>0&&y("figure",{},qu(a,t,i,QM).figure,y("figcaption",{},"Each point is a search of its own.")),!e&&rn(s?`The cheapest kit that keeps all constraints has ${s.devices} devices, at a price of ${nn(s.price)}.`:"None of these kits keeps all constraints.","answer"),sn(`front-${i.name}`,"Best designs",[e?`${i.name} at the limit`:"devices",e?"used":"price",t.name,"all constraints kept"],r))}const Mh=(i,e)=>y("figure",{},i,y("figcaption",{},e)),yh={width:760,height:260};function ty({objective:i,variables:e,constraints:t,after:n}){const s=e.filter(a=>a.locked).length,r=`Make the ${i.name} ${i.maximize?"large":"small"} by changing ${Bt(e.length-s,"variable")} of ${Bt(n.description.devices.length,"device")}${s>0?` (${s} more are locked)`:""}`;return t.length===0?[rn(`${r}.`)]:[rn(`${r}, such that`),y("ul",{},...t.map(a=>y("li",{},y("b",{},a.name),`: ${a.words}.`)))]}function ny({study:{rounds:i,acts:e}}){const t=n=>i.filter(s=>s.round<=n).reduce((s,r)=>s+r.evaluations,0);return e.map(n=>({evaluation:t(n.after_round),text:`${n.verb} ${n.argument}`}))}function iy(i){const{search:e,study:t,variables:n}=i;if(e.designs.length===0)return[rn("Nothing has been evaluated so far.")];const s=o=>n.find(l=>l.path===o)?.unit??"1",r=t.rounds.length>1?" Every round begins anew; dashed lines are acts of a person.":"",a=$u(e,s,yh);return[Mh(Zu(e,yh,ny(i)),`${e.objective.name}: what was best as steps, designs that were looked at as dots, start after start, on the samples of the search. Designs that were looked at with soft edges (faint), or that break a constraint, don’t count as best.${r}`),...a?[Mh(a,"Variables from their least to their greatest value: all designs faint, those that were the best of their time clearer, the best strong.")]:[]]}function sy(i){const e=i.constraints.map(t=>[t.name,t.words,Tl(t.satisfied,t.satisfied?"kept":"NOT kept"),gn(t.slack,t.unit)]);return sn("constraints","On all samples; below zero, so much is missing",["constraint","demand","","slack"],e)}const ry=(i,e)=>`−${Re(i.down,e)}${i.down_is_bound?" (bound)":""} to +${Re(i.up,e)}${i.up_is_bound?" (bound)":""}`;function ay({variables:i,answers:e,objective:t}){const n=i.map(r=>{const a=r.locked?" (locked)":r.after===r.lower?" (least)":r.after===r.upper?" (greatest)":"",o=gn(r.after,r.unit,4),l=[r.path,gn(r.before,r.unit,4),{...o,text:o.text+a},`${Re(r.lower,r.unit,4)} to ${Re(r.upper,r.unit,4)}`];if(!e)return l;const c=e.variables[r.path],h=c&&c.slope!==null&&t.after?c.slope*(r.upper-r.lower)/Math.abs(t.after):null;return[...l,c?ry(c,r.unit):"",h===null?"":{text:`${Number((100*h).toPrecision(2))} %`,value:h}]}),s=e?`. May move by: alone, for under ${Number((100*e.loss).toPrecision(3))} % loss and with all constraints kept. Slope: of the objective, relative to it, times the variable’s whole range`:"";return sn("variables",`All variables${s}`,["variable","before","after","bounds",...e?["may move by","slope"]:[]],n)}function oy({answers:i}){const e=Object.entries(i?.without??{});if(e.length===0)return null;const t=e.map(([n,s])=>[n,El(s,"undefined")]);return Vt("If one device fails",sn("failures","Rise of the objective where a device alone is missing",["device","objective"],t))}function ly({consensus:i,objective:e}){if(!i)return null;const t=i.layouts.map((s,r)=>[String(r+1),gn(s.objective,e.unit),gn(s.distance,"m")]),n=Object.entries(i.devices).map(([s,r])=>[s,r.pose,{text:`${Number((100*r.part_of_chance).toPrecision(2))} %`,value:r.part_of_chance},gn(r.shift,"m"),gn(r.turn,"rad"),`(${r.at.map(a=>Number(a.toPrecision(3))).join(", ")}) m`]);return Vt("What the best layouts have in common",sn("layouts",`Distinct layouts among the best designs of ${Bt(i.starts,"start")}; devices of one kind are interchangeable`,["layout","objective","from the best"],t),t.length<2?rn("One layout says nothing of what is settled."):sn("settled","Settled: a device varies over these layouts less than a quarter as much as over random designs; free: more than three fifths",["device","pose","varies","moves by","turns by","in the best, at"],n))}function cy({study:{rounds:i,acts:e,waiting:t},objective:n}){const s=a=>a.map(o=>`${o.verb} ${o.argument}`).join("; "),r=i.map(a=>{const o=l=>a.ended?gn(l,n.unit):"not at its end";return[String(a.round),s(e.filter(l=>l.after_round===a.round-1))||"—",wl(a.evaluations),o(a.initial),o(a.best)]});return[sn("rounds","Rounds, each with the acts that it began with",["round","acts","evaluations","from","to"],r),...t.length>0?[rn(`For the next round: ${s(t)}.`)]:[]]}function hy(i,e,t,n){return y("article",{},Vt("The question",...ty(i)),Vt("Before and after",sd([e,t],["before","after"]),n),Vt("Convergence",...iy(i)),i.constraints.length>0&&Vt("Constraints",sy(i)),Vt("The design",ay(i)),oy(i),Vt("To install it",id(i.installation)),ly(i),...i.tradeoffs.map(ey),Vt("Rounds and acts",...cy(i)),Vt("To compute it again",rn("Acts hold from the end of a round here, and a round that was cut short by an act ends where it was."),Jr("Commands",i.commands),rd(i.versions),y("h3",{},"The best scene, in SI units"),Jr("Scene file",i.text)))}function uy(i,e,t){try{return new HM(e,i.kind==="scene"?i.worth:null,t)}catch{return null}}function dy(i,e){let t=matchMedia("(prefers-color-scheme: light)").matches?"light":"dark";rs(t);const n=OM(e),{name:s}=n.description,r=uy(e,n,t),a=document.getElementById("stills");document.body.classList.toggle("live",r!==null);const o=()=>{t=t==="dark"?"light":"dark",rs(t),r?.paint(t)},l=e.kind==="scene"?jM(e,n.field,a):hy(e,n.pinned.field,n.field,a);i.append(y("header",{className:"top"},y("span",{className:"brand"},"Delos"),y("span",{className:"hint"},e.file),y("span",{className:"space"}),bt("theme","Dark or light",o)),y("main",{},y("h1",{},s),rn(e.headline,"answer"),r?.element??rn("This browser draws no WebGL: pictures stand below instead.","note"),l)),r?.begin()}const bh=document.getElementById("app"),Sh=FM();Sh?dy(bh,Sh):new UM(bh).start();
