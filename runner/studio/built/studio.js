/*!
three 0.187.0

The MIT License

Copyright © 2010-2026 three.js authors

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in
all copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN
THE SOFTWARE.

uplot 1.6.32

The MIT License (MIT)

Copyright (c) 2022 Leon Sorokin

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in
all copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN
THE SOFTWARE.
*/
var Z_="uplot",$_="u-hz",K_="u-vt",j_="u-title",J_="u-wrap",Q_="u-under",ey="u-over",ty="u-axis",xr="u-off",ny="u-select",iy="u-cursor-x",sy="u-cursor-y",ry="u-cursor-pt",oy="u-legend",ay="u-live",ly="u-inline",cy="u-series",hy="u-marker",Xp="u-label",uy="u-value",da="width",fa="height";var qp="bottom",no="left",qu="right",cd="#000",Yp=cd+"0",Yu="mousemove",Zp="mousedown",Zu="mouseup",$p="mouseenter",Kp="mouseleave",jp="dblclick",dy="resize",fy="scroll",Jp="change",Hl="dppxchange",hd="--",co=typeof window<"u",Qu=co?document:null,so=co?window:null,py=co?navigator:null,Rt,Fl;function ed(){let i=devicePixelRatio;Rt!=i&&(Rt=i,Fl&&nd(Jp,Fl,ed),Fl=matchMedia(`(min-resolution: ${Rt-.001}dppx) and (max-resolution: ${Rt+.001}dppx)`),_r(Jp,Fl,ed),so.dispatchEvent(new CustomEvent(Hl)))}function mi(i,e){if(e!=null){let t=i.classList;!t.contains(e)&&t.add(e)}}function td(i,e){let t=i.classList;t.contains(e)&&t.remove(e)}function $t(i,e,t){i.style[e]=t+"px"}function ki(i,e,t,n){let s=Qu.createElement(i);return e!=null&&mi(s,e),t?.insertBefore(s,n),s}function wi(i,e){return ki("div",i,e)}var Qp=new WeakMap;function is(i,e,t,n,s){let r="translate("+e+"px,"+t+"px)",o=Qp.get(i);r!=o&&(i.style.transform=r,Qp.set(i,r),e<0||t<0||e>n||t>s?mi(i,xr):td(i,xr))}var em=new WeakMap;function tm(i,e,t){let n=e+t,s=em.get(i);n!=s&&(em.set(i,n),i.style.background=e,i.style.borderColor=t)}var nm=new WeakMap;function im(i,e,t,n){let s=e+""+t,r=nm.get(i);s!=r&&(nm.set(i,s),i.style.height=t+"px",i.style.width=e+"px",i.style.marginLeft=n?-e/2+"px":0,i.style.marginTop=n?-t/2+"px":0)}var ud={passive:!0},my={...ud,capture:!0};function _r(i,e,t,n){e.addEventListener(i,t,n?my:ud)}function nd(i,e,t,n){e.removeEventListener(i,t,ud)}co&&ed();function Bi(i,e,t,n){let s;t=t||0,n=n||e.length-1;let r=n<=2147483647;for(;n-t>1;)s=r?t+n>>1:gi((t+n)/2),e[s]<i?t=s:n=s;return i-e[t]<=e[n]-i?t:n}function Im(i){return(t,n,s)=>{let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(t[a])){r=a;break}for(let a=s;a>=n;a--)if(i(t[a])){o=a;break}return[r,o]}}var Lm=i=>i!=null,Dm=i=>i!=null&&i>0,Wl=Im(Lm),gy=Im(Dm);function xy(i,e,t,n=0,s=!1){let r=s?gy:Wl,o=s?Dm:Lm;[e,t]=r(i,e,t);let a=i[e],l=i[e];if(e>-1)if(n==1)a=i[e],l=i[t];else if(n==-1)a=i[t],l=i[e];else for(let c=e;c<=t;c++){let h=i[c];o(h)&&(h<a?a=h:h>l&&(l=h))}return[a??Bt,l??-Bt]}function Xl(i,e,t,n){let s=om(i),r=om(e);i==e&&(s==-1?(i*=t,e/=t):(i/=t,e*=t));let o=t==10?vs:Nm,a=s==1?gi:Ei,l=r==1?Ei:gi,c=a(o(An(i))),h=l(o(An(e))),d=ro(t,c),u=ro(t,h);return t==10&&(c<0&&(d=zt(d,-c)),h<0&&(u=zt(u,-h))),n||t==2?(i=d*s,e=u*r):(i=km(i,d),e=ql(e,u)),[i,e]}function dd(i,e,t,n){let s=Xl(i,e,t,n);return i==0&&(s[0]=0),e==0&&(s[1]=0),s}var fd=.1,sm={mode:3,pad:fd},ma={pad:0,soft:null,mode:0},_y={min:ma,max:ma};function Gl(i,e,t,n){return Yl(t)?rm(i,e,t):(ma.pad=t,ma.soft=n?0:null,ma.mode=n?3:0,rm(i,e,_y))}function Tt(i,e){return i??e}function yy(i,e,t){for(e=Tt(e,0),t=Tt(t,i.length-1);e<=t;){if(i[e]!=null)return!0;e++}return!1}function rm(i,e,t){let n=t.min,s=t.max,r=Tt(n.pad,0),o=Tt(s.pad,0),a=Tt(n.hard,-Bt),l=Tt(s.hard,Bt),c=Tt(n.soft,Bt),h=Tt(s.soft,-Bt),d=Tt(n.mode,0),u=Tt(s.mode,0),f=e-i,p=vs(f),v=ei(An(i),An(e)),g=vs(v),m=An(g-p);(f<1e-24||m>10)&&(f=0,(i==0||e==0)&&(f=1e-24,d==2&&c!=Bt&&(r=0),u==2&&h!=-Bt&&(o=0)));let _=f||v||1e3,T=vs(_),M=ro(10,gi(T)),C=_*(f==0?i==0?.1:1:r),S=zt(km(i-C,M/10),24),x=i>=c&&(d==1||d==3&&S<=c||d==2&&S>=c)?c:Bt,E=ei(a,S<x&&i>=x?x:zi(x,S)),O=_*(f==0?e==0?.1:1:o),P=zt(ql(e+O,M/10),24),D=e<=h&&(u==1||u==3&&P>=h||u==2&&P<=h)?h:-Bt,z=zi(l,P>D&&e<=D?D:ei(D,P));return E==z&&E==0&&(z=100),[E,z]}var vy=new Intl.NumberFormat(co?py.language:"en-US"),pd=i=>vy.format(i),xi=Math,zl=xi.PI,An=xi.abs,gi=xi.floor,Tn=xi.round,Ei=xi.ceil,zi=xi.min,ei=xi.max,ro=xi.pow,om=xi.sign,vs=xi.log10,Nm=xi.log2,by=(i,e=1)=>xi.sinh(i)*e,$u=(i,e=1)=>xi.asinh(i/e),Bt=1/0;function am(i){return(vs((i^i>>31)-(i>>31))|0)+1}function id(i,e,t){return zi(ei(i,e),t)}function Um(i){return typeof i=="function"}function bt(i){return Um(i)?i:()=>i}var My=()=>{},Om=i=>i,Fm=(i,e)=>e,Sy=i=>null,lm=i=>!0,cm=(i,e)=>i==e,wy=/\.\d*?(?=9{6,}|0{6,})/gm,yr=i=>{if(zm(i)||Xs.has(i))return i;let e=`${i}`,t=e.match(wy);if(t==null)return i;let n=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${yr(s)}e${r}`}return zt(i,n)};function mr(i,e){return yr(zt(yr(i/e))*e)}function ql(i,e){return yr(Ei(yr(i/e))*e)}function km(i,e){return yr(gi(yr(i/e))*e)}function zt(i,e=0){if(zm(i))return i;let t=10**e,n=i*t*(1+Number.EPSILON);return Tn(n)/t}var Xs=new Map;function Bm(i){return((""+i).split(".")[1]||"").length}function xa(i,e,t,n){let s=[],r=n.map(Bm);for(let o=e;o<t;o++){let a=An(o),l=zt(ro(i,o),a);for(let c=0;c<n.length;c++){let h=i==10?+`${n[c]}e${o}`:n[c]*l,d=(o>=0?0:a)+(o>=r[c]?0:r[c]),u=i==10?h:zt(h,d);s.push(u),Xs.set(u,d)}}return s}var ga={},md=[],oo=[null,null],Ws=Array.isArray,zm=Number.isInteger,Ey=i=>i===void 0;function hm(i){return typeof i=="string"}function Yl(i){let e=!1;if(i!=null){let t=i.constructor;e=t==null||t==Object}return e}function Ty(i){return i!=null&&typeof i=="object"}var Ay=Object.getPrototypeOf(Uint8Array),Hm="__proto__";function ao(i,e=Yl){let t;if(Ws(i)){let n=i.find(s=>s!=null);if(Ws(n)||e(n)){t=Array(i.length);for(let s=0;s<i.length;s++)t[s]=ao(i[s],e)}else t=i.slice()}else if(i instanceof Ay)t=i.slice();else if(e(i)){t={};for(let n in i)n!=Hm&&(t[n]=ao(i[n],e))}else t=i;return t}function vn(i){let e=arguments;for(let t=1;t<e.length;t++){let n=e[t];for(let s in n)s!=Hm&&(Yl(i[s])?vn(i[s],ao(n[s])):i[s]=ao(n[s]))}return i}var Ry=0,Cy=1,Py=2;function Iy(i,e,t){for(let n=0,s,r=-1;n<e.length;n++){let o=e[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<t&&i[s]==null;)i[r=s++]=null}}}function Ly(i,e){if(Uy(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return Oy(o[0])||(o=Ny(o)),o}let t=new Set;for(let o=0;o<i.length;o++){let l=i[o][0],c=l.length;for(let h=0;h<c;h++)t.add(l[h])}let n=[Array.from(t).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],l=a[0];for(let c=1;c<a.length;c++){let h=a[c],d=Array(s).fill(void 0),u=e?e[o][c]:Cy,f=[];for(let p=0;p<h.length;p++){let v=h[p],g=r.get(l[p]);v===null?u!=Ry&&(d[g]=v,u==Py&&f.push(g)):d[g]=v}Iy(d,f,s),n.push(d)}}return n}var Dy=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function Ny(i){let e=i[0],t=e.length,n=Array(t);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[n[l]];s.push(a)}return s}function Uy(i){let e=i[0][0],t=e.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function Oy(i,e=100){let t=i.length;if(t<=1)return!0;let n=0,s=t-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=ei(1,gi((s-n+1)/e));for(let o=i[n],a=n+r;a<=s;a+=r){let l=i[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var Gm=["January","February","March","April","May","June","July","August","September","October","November","December"],Vm=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function Wm(i){return i.slice(0,3)}var Fy=Vm.map(Wm),ky=Gm.map(Wm),By={MMMM:Gm,MMM:ky,WWWW:Vm,WWW:Fy};function ua(i){return(i<10?"0":"")+i}function zy(i){return(i<10?"00":i<100?"0":"")+i}var Hy={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,e)=>e.MMMM[i.getMonth()],MMM:(i,e)=>e.MMM[i.getMonth()],MM:i=>ua(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>ua(i.getDate()),D:i=>i.getDate(),WWWW:(i,e)=>e.WWWW[i.getDay()],WWW:(i,e)=>e.WWW[i.getDay()],HH:i=>ua(i.getHours()),H:i=>i.getHours(),h:i=>{let e=i.getHours();return e==0?12:e>12?e-12:e},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>ua(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>ua(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>zy(i.getMilliseconds())};function gd(i,e){e=e||By;let t=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)t.push(s[0][0]=="{"?Hy[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var Gy=new Intl.DateTimeFormat().resolvedOptions().timeZone;function Vy(i,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+i+i.getTimezoneOffset()*6e4):e==Gy?t=i:(t=new Date(i.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(i.getMilliseconds())),t}var Xm=i=>i%1==0,Vl=[1,2,2.5,5],Wy=xa(10,-32,0,Vl),qm=xa(10,0,32,Vl),Xy=qm.filter(Xm),gr=Wy.concat(qm),xd=`
`,Ym="{YYYY}",um=xd+Ym,Zm="{M}/{D}",pa=xd+Zm,kl=pa+"/{YY}",$m="{aa}",qy="{h}:{mm}",io=qy+$m,dm=xd+io,fm=":{ss}",Pt=null;function Km(i){let e=i*1e3,t=e*60,n=t*60,s=n*24,r=s*30,o=s*365,l=(i==1?xa(10,0,3,Vl).filter(Xm):xa(10,-3,0,Vl)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,Ym,Pt,Pt,Pt,Pt,Pt,Pt,1],[s*28,"{MMM}",um,Pt,Pt,Pt,Pt,Pt,1],[s,Zm,um,Pt,Pt,Pt,Pt,Pt,1],[n,"{h}"+$m,kl,Pt,pa,Pt,Pt,Pt,1],[t,io,kl,Pt,pa,Pt,Pt,Pt,1],[e,fm,kl+" "+io,Pt,pa+" "+io,Pt,dm,Pt,1],[i,fm+".{fff}",kl+" "+io,Pt,pa+" "+io,Pt,dm,Pt,1]];function h(d){return(u,f,p,v,g,m)=>{let _=[],T=g>=o,M=g>=r&&g<o,C=d(p),S=zt(C*i,3),x=Ku(C.getFullYear(),T?0:C.getMonth(),M||T?1:C.getDate()),E=zt(x*i,3);if(M||T){let O=M?g/r:0,P=T?g/o:0,D=S==E?S:zt(Ku(x.getFullYear()+P,x.getMonth()+O,1)*i,3),z=new Date(Tn(D/i)),W=z.getFullYear(),N=z.getMonth();for(let V=0;D<=v;V++){let Z=Ku(W+P*V,N+O*V,1),G=Z-d(zt(Z*i,3));D=zt((+Z+G)*i,3),D<=v&&_.push(D)}}else{let O=g>=s?s:g,P=gi(p)-gi(S),D=E+P+ql(S-E,O);_.push(D);let z=d(D),W=z.getHours()+z.getMinutes()/t+z.getSeconds()/n,N=g/n,V=u.axes[f]._space,Z=m/V;for(;D=zt(D+g,i==1?0:3),!(D>v);)if(N>1){let G=gi(zt(W+N,6))%24,Q=d(D).getHours()-G;Q>1&&(Q=-1),D-=Q*n,W=(W+N)%24;let ie=_[_.length-1];zt((D-ie)/g,3)*Z>=.7&&_.push(D)}else _.push(D)}return _}}return[l,c,h]}var[Yy,Zy,$y]=Km(1),[Ky,jy,Jy]=Km(.001);xa(2,-53,53,[1]);function pm(i,e){return i.map(t=>t.map((n,s)=>s==0||s==8||n==null?n:e(s==1||t[8]==0?n:t[1]+n)))}function mm(i,e){return(t,n,s,r,o)=>{let a=e.find(p=>o>=p[0])||e[e.length-1],l,c,h,d,u,f;return n.map(p=>{let v=i(p),g=v.getFullYear(),m=v.getMonth(),_=v.getDate(),T=v.getHours(),M=v.getMinutes(),C=v.getSeconds(),S=g!=l&&a[2]||m!=c&&a[3]||_!=h&&a[4]||T!=d&&a[5]||M!=u&&a[6]||C!=f&&a[7]||a[1];return l=g,c=m,h=_,d=T,u=M,f=C,S(v)})}}function Qy(i,e){let t=gd(e);return(n,s,r,o,a)=>s.map(l=>t(i(l)))}function Ku(i,e,t){return new Date(i,e,t)}function gm(i,e){return e(i)}var ev="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function xm(i,e){return(t,n,s,r)=>r==null?hd:e(i(n))}function tv(i,e){let t=i.series[e];return t.width?t.stroke(i,e):t.points.width?t.points.stroke(i,e):null}function nv(i,e){return i.series[e].fill(i,e)}var iv={show:!0,live:!0,isolate:!1,mount:My,markers:{show:!0,width:2,stroke:tv,fill:nv,dash:"solid"},idx:null,idxs:null,values:[]};function sv(i,e){let t=i.cursor.points,n=wi(),s=t.size(i,e);$t(n,da,s),$t(n,fa,s);let r=s/-2;$t(n,"marginLeft",r),$t(n,"marginTop",r);let o=t.width(i,e,s);return o&&$t(n,"borderWidth",o),n}function rv(i,e){let t=i.series[e].points;return t._fill||t._stroke}function ov(i,e){let t=i.series[e].points;return t._stroke||t._fill}function av(i,e){return i.series[e].points.size}var ju=[0,0];function lv(i,e,t){return ju[0]=e,ju[1]=t,ju}function Bl(i,e,t,n=!0){return s=>{s.button==0&&(!n||s.target==e)&&t(s)}}function Ju(i,e,t,n=!0){return s=>{(!n||s.target==e)&&t(s)}}var cv={show:!0,x:!0,y:!0,lock:!1,move:lv,points:{one:!1,show:sv,size:av,width:0,stroke:ov,fill:rv},bind:{mousedown:Bl,mouseup:Bl,click:Bl,dblclick:Bl,mousemove:Ju,mouseleave:Ju,mouseenter:Ju},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,e,t,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},jm={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},_d=vn({},jm,{filter:Fm}),Jm=vn({},_d,{size:10}),Qm=vn({},jm,{show:!1}),yd='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',eg="bold "+yd,tg=1.5,_m={show:!0,scale:"x",stroke:cd,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:eg,side:2,grid:_d,ticks:Jm,border:Qm,font:yd,lineGap:tg,rotate:0},hv="Value",uv="Time",ym={show:!0,scale:"x",auto:!1,sorted:1,min:Bt,max:-Bt,idxs:[]};function dv(i,e,t,n,s){return e.map(r=>r==null?"":pd(r))}function fv(i,e,t,n,s,r,o){let a=[],l=Xs.get(s)||0;t=o?t:zt(ql(t,s),l);for(let c=t;c<=n;c=zt(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function sd(i,e,t,n,s,r,o){let a=[],l=i.scales[i.axes[e].scale].log,c=l==10?vs:Nm,h=gi(c(t));s=ro(l,h),l==10&&(s=gr[Bi(s,gr)]);let d=t,u=s*l;l==10&&(u=gr[Bi(u,gr)]);do a.push(d),d=d+s,l==10&&!Xs.has(d)&&(d=zt(d,Xs.get(s))),d>=u&&(s=d,u=s*l,l==10&&(u=gr[Bi(u,gr)]));while(d<=n);return a}function pv(i,e,t,n,s,r,o){let l=i.scales[i.axes[e].scale].asinh,c=n>l?sd(i,e,ei(l,t),n,s):[l],h=n>=0&&t<=0?[0]:[];return(t<-l?sd(i,e,ei(l,-n),-t,s):[l]).reverse().map(u=>-u).concat(h,c)}var ng=/./,mv=/[12357]/,gv=/[125]/,vm=/1/,rd=(i,e,t,n)=>i.map((s,r)=>e==4&&s==0||r%n==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function xv(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=i.scales[o],l=i.valToPos,c=r._space,h=l(10,o),d=l(9,o)-h>=c?ng:l(7,o)-h>=c?mv:l(5,o)-h>=c?gv:vm;if(d==vm){let u=An(l(1,o)-h);if(u<c)return rd(e.slice().reverse(),a.distr,d,Ei(c/u)).reverse()}return rd(e,a.distr,d,1)}function _v(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=r._space,l=i.valToPos,c=An(l(1,o)-l(2,o));return c<a?rd(e.slice().reverse(),3,ng,Ei(a/c)).reverse():e}function yv(i,e,t,n){return n==null?hd:e==null?"":pd(e)}var bm={show:!0,scale:"y",stroke:cd,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:eg,side:3,grid:_d,ticks:Jm,border:Qm,font:yd,lineGap:tg,rotate:0};function vv(i,e){let t=3+(i||1)*2;return zt(t*e,3)}function bv(i,e){let{scale:t,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],t,!0),o=i.valToPos(s[n[1]],t,!0),a=An(o-r),l=i.series[e],c=a/(l.points.space*Rt);return n[1]-n[0]<=c}var Mm={scale:null,auto:!0,sorted:0,min:Bt,max:-Bt},ig=(i,e,t,n,s)=>s,Sm={show:!0,auto:!0,sorted:0,gaps:ig,alpha:1,facets:[vn({},Mm,{scale:"x"}),vn({},Mm,{scale:"y"})]},wm={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:ig,alpha:1,points:{show:bv,filter:null},values:null,min:Bt,max:-Bt,idxs:[],path:null,clip:null};function Mv(i,e,t,n,s){return t/10}var sg={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},Sv=vn({},sg,{time:!1,ori:1}),Em={};function rg(i,e){let t=Em[i];return t||(t={key:i,plots:[],sub(n){t.plots.push(n)},unsub(n){t.plots=t.plots.filter(s=>s!=n)},pub(n,s,r,o,a,l,c){for(let h=0;h<t.plots.length;h++)t.plots[h]!=s&&t.plots[h].pub(n,s,r,o,a,l,c)}},i!=null&&(Em[i]=t)),t}var lo=1,od=2;function vr(i,e,t){let n=i.mode,s=i.series[e],r=n==2?i._data[e]:i._data,o=i.scales,a=i.bbox,l=r[0],c=n==2?r[1]:r[e],h=n==2?o[s.facets[0].scale]:o[i.series[0].scale],d=n==2?o[s.facets[1].scale]:o[s.scale],u=a.left,f=a.top,p=a.width,v=a.height,g=i.valToPosH,m=i.valToPosV;return h.ori==0?t(s,l,c,h,d,g,m,u,f,p,v,$l,ho,jl,ag,cg):t(s,l,c,h,d,m,g,f,u,v,p,Kl,uo,Md,lg,hg)}function vd(i,e){let t=0,n=0,s=Tt(i.bands,md);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?n|=1:n|=2)}return[t,n==1?-1:n==2?1:n==3?2:0]}function wv(i,e,t,n,s){let r=i.mode,o=i.series[e],a=r==2?o.facets[1].scale:o.scale,l=i.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function bs(i,e,t,n,s,r){return vr(i,e,(o,a,l,c,h,d,u,f,p,v,g)=>{let m=o.pxRound,_=c.dir*(c.ori==0?1:-1),T=c.ori==0?ho:uo,M,C;_==1?(M=t,C=n):(M=n,C=t);let S=m(d(a[M],c,v,f)),x=m(u(l[M],h,g,p)),E=m(d(a[C],c,v,f)),O=m(u(r==1?h.max:h.min,h,g,p)),P=new Path2D(s);return T(P,E,O),T(P,S,O),T(P,S,x),P})}function Zl(i,e,t,n,s,r){let o=null;if(i.length>0){o=new Path2D;let a=e==0?jl:Md,l=t;for(let d=0;d<i.length;d++){let u=i[d];if(u[1]>u[0]){let f=u[0]-l;f>0&&a(o,l,n,f,n+r),l=u[1]}}let c=t+s-l,h=10;c>0&&a(o,l,n-h/2,c,n+r+h)}return o}function Ev(i,e,t){let n=i[i.length-1];n&&n[0]==e?n[1]=t:i.push([e,t])}function bd(i,e,t,n,s,r,o){let a=[],l=i.length;for(let c=s==1?t:n;c>=t&&c<=n;c+=s)if(e[c]===null){let d=c,u=c;if(s==1)for(;++c<=n&&e[c]===null;)u=c;else for(;--c>=t&&e[c]===null;)u=c;let f=r(i[d]),p=u==d?f:r(i[u]),v=d-s;f=o<=0&&v>=0&&v<l?r(i[v]):f;let m=u+s;p=o>=0&&m>=0&&m<l?r(i[m]):p,p>=f&&a.push([f,p])}return a}function Tm(i){return i==0?Om:i==1?Tn:e=>mr(e,i)}function og(i){let e=i==0?$l:Kl,t=i==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},n=i==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,h=0)=>{c==0&&h==0?n(s,r,o,a,l):(c=zi(c,a/2,l/2),h=zi(h,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,h),t(s,r,o+l,r,o,h),t(s,r,o,r+a,o,c),s.closePath())}}var $l=(i,e,t)=>{i.moveTo(e,t)},Kl=(i,e,t)=>{i.moveTo(t,e)},ho=(i,e,t)=>{i.lineTo(e,t)},uo=(i,e,t)=>{i.lineTo(t,e)},jl=og(0),Md=og(1),ag=(i,e,t,n,s,r)=>{i.arc(e,t,n,s,r)},lg=(i,e,t,n,s,r)=>{i.arc(t,e,n,s,r)},cg=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(e,t,n,s,r,o)},hg=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(t,e,s,n,o,r)};function ug(i){return(e,t,n,s,r)=>vr(e,t,(o,a,l,c,h,d,u,f,p,v,g)=>{let{pxRound:m,points:_}=o,T,M;c.ori==0?(T=$l,M=ag):(T=Kl,M=lg);let C=zt(_.width*Rt,3),S=(_.size-_.width)/2*Rt,x=zt(S*2,3),E=new Path2D,O=new Path2D,{left:P,top:D,width:z,height:W}=e.bbox;jl(O,P-x,D-x,z+x*2,W+x*2);let N=V=>{if(l[V]!=null){let Z=m(d(a[V],c,v,f)),G=m(u(l[V],h,g,p));T(E,Z+S,G),M(E,Z,G,S,0,zl*2)}};if(r)r.forEach(N);else for(let V=n;V<=s;V++)N(V);return{stroke:C>0?E:null,fill:E,clip:O,flags:lo|od}})}function dg(i){return(e,t,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(e,t,n),r!=s&&o!=s&&i(e,t,s),i(e,t,o))}}var Tv=dg(ho),Av=dg(uo);function fg(i){let e=Tt(i?.alignGaps,0);return(t,n,s,r)=>vr(t,n,(o,a,l,c,h,d,u,f,p,v,g)=>{[s,r]=Wl(l,s,r);let m=o.pxRound,_=W=>m(d(W,c,v,f)),T=W=>m(u(W,h,g,p)),M,C;c.ori==0?(M=ho,C=Tv):(M=uo,C=Av);let S=c.dir*(c.ori==0?1:-1),x={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:lo},E=x.stroke,O=!1;if(r-s>=v*4){let W=fe=>t.posToVal(fe,c.key,!0),N=null,V=null,Z,G,ce,Y=_(a[S==1?s:r]),Q=_(a[s]),ie=_(a[r]),de=W(S==1?Q+1:ie-1);for(let fe=S==1?s:r;fe>=s&&fe<=r;fe+=S){let ee=a[fe],ye=(S==1?ee<de:ee>de)?Y:_(ee),Re=l[fe];ye==Y?Re!=null?(G=Re,N==null?(M(E,ye,T(G)),Z=N=V=G):G<N?N=G:G>V&&(V=G)):Re===null&&(O=!0):(N!=null&&C(E,Y,T(N),T(V),T(Z),T(G)),Re!=null?(G=Re,M(E,ye,T(G)),N=V=Z=G):(N=V=null,Re===null&&(O=!0)),Y=ye,de=W(Y+S))}N!=null&&N!=V&&ce!=Y&&C(E,Y,T(N),T(V),T(Z),T(G))}else for(let W=S==1?s:r;W>=s&&W<=r;W+=S){let N=l[W];N===null?O=!0:N!=null&&M(E,_(a[W]),T(N))}let[D,z]=vd(t,n);if(o.fill!=null||D!=0){let W=x.fill=new Path2D(E),N=o.fillTo(t,n,o.min,o.max,D),V=T(N),Z=_(a[s]),G=_(a[r]);S==-1&&([G,Z]=[Z,G]),M(W,G,V),M(W,Z,V)}if(!o.spanGaps){let W=[];O&&W.push(...bd(a,l,s,r,S,_,e)),x.gaps=W=o.gaps(t,n,s,r,W),x.clip=Zl(W,c.ori,f,p,v,g)}return z!=0&&(x.band=z==2?[bs(t,n,s,r,E,-1),bs(t,n,s,r,E,1)]:bs(t,n,s,r,E,z)),x})}function Rv(i){let e=Tt(i.align,1),t=Tt(i.ascDesc,!1),n=Tt(i.alignGaps,0),s=Tt(i.extend,!1);return(r,o,a,l)=>vr(r,o,(c,h,d,u,f,p,v,g,m,_,T)=>{[a,l]=Wl(d,a,l);let M=c.pxRound,{left:C,width:S}=r.bbox,x=Q=>M(p(Q,u,_,g)),E=Q=>M(v(Q,f,T,m)),O=u.ori==0?ho:uo,P={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:lo},D=P.stroke,z=u.dir*(u.ori==0?1:-1),W=E(d[z==1?a:l]),N=x(h[z==1?a:l]),V=N,Z=N;s&&e==-1&&(Z=C,O(D,Z,W)),O(D,N,W);for(let Q=z==1?a:l;Q>=a&&Q<=l;Q+=z){let ie=d[Q];if(ie==null)continue;let de=x(h[Q]),fe=E(ie);e==1?O(D,de,W):O(D,V,fe),O(D,de,fe),W=fe,V=de}let G=V;s&&e==1&&(G=C+S,O(D,G,W));let[ce,Y]=vd(r,o);if(c.fill!=null||ce!=0){let Q=P.fill=new Path2D(D),ie=c.fillTo(r,o,c.min,c.max,ce),de=E(ie);O(Q,G,de),O(Q,Z,de)}if(!c.spanGaps){let Q=[];Q.push(...bd(h,d,a,l,z,x,n));let ie=c.width*Rt/2,de=t||e==1?ie:-ie,fe=t||e==-1?-ie:ie;Q.forEach(ee=>{ee[0]+=de,ee[1]+=fe}),P.gaps=Q=c.gaps(r,o,a,l,Q),P.clip=Zl(Q,u.ori,g,m,_,T)}return Y!=0&&(P.band=Y==2?[bs(r,o,a,l,D,-1),bs(r,o,a,l,D,1)]:bs(r,o,a,l,D,Y)),P})}function Am(i,e,t,n,s,r,o=Bt){if(i.length>1){let a=null;for(let l=0,c=1/0;l<i.length;l++)if(e[l]!==void 0){if(a!=null){let h=An(i[l]-i[a]);h<c&&(c=h,o=An(t(i[l],n,s,r)-t(i[a],n,s,r)))}a=l}}return o}function Cv(i){i=i||ga;let e=Tt(i.size,[.6,Bt,1]),t=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=bt(s),o=1-e[0],a=Tt(e[1],Bt),l=Tt(e[2],1),c=Tt(i.disp,ga),h=Tt(i.each,f=>{}),{fill:d,stroke:u}=c;return(f,p,v,g)=>vr(f,p,(m,_,T,M,C,S,x,E,O,P,D)=>{let z=m.pxRound,W=t,N=n*Rt,V=a*Rt,Z=l*Rt,G,ce;M.ori==0?[G,ce]=r(f,p):[ce,G]=r(f,p);let Y=M.dir*(M.ori==0?1:-1),Q=M.ori==0?jl:Md,ie=M.ori==0?h:(Ie,je,lt,we,kt,Ve,$e)=>{h(Ie,je,lt,kt,we,$e,Ve)},de=Tt(f.bands,md).find(Ie=>Ie.series[0]==p),fe=de!=null?de.dir:0,ee=m.fillTo(f,p,m.min,m.max,fe),ge=z(x(ee,C,D,O)),ye,Re,Se,Ye=P,at=z(m.width*Rt),Xe=!1,pt=null,ut=null,rt=null,Qt=null;d!=null&&(at==0||u!=null)&&(Xe=!0,pt=d.values(f,p,v,g),ut=new Map,new Set(pt).forEach(Ie=>{Ie!=null&&ut.set(Ie,new Path2D)}),at>0&&(rt=u.values(f,p,v,g),Qt=new Map,new Set(rt).forEach(Ie=>{Ie!=null&&Qt.set(Ie,new Path2D)})));let{x0:Gt,size:pn}=c;if(Gt!=null&&pn!=null){W=1,_=Gt.values(f,p,v,g),Gt.unit==2&&(_=_.map(lt=>f.posToVal(E+lt*P,M.key,!0)));let Ie=pn.values(f,p,v,g);pn.unit==2?Re=Ie[0]*P:Re=S(Ie[0],M,P,E)-S(0,M,P,E),Ye=Am(_,T,S,M,P,E,Ye),Se=Ye-Re+N}else Ye=Am(_,T,S,M,P,E,Ye),Se=Ye*o+N,Re=Ye-Se;Se<1&&(Se=0),at>=Re/2&&(at=0),Se<5&&(z=Om);let Ot=Se>0,Ln=Ye-Se-(Ot?at:0);Re=z(id(Ln,Z,V)),ye=(W==0?Re/2:W==Y?0:Re)-W*Y*((W==0?N/2:0)+(Ot?at/2:0));let St={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},wn=Xe?null:new Path2D,rn=null;if(de!=null)rn=f.data[de.series[1]];else{let{y0:Ie,y1:je}=c;Ie!=null&&je!=null&&(T=je.values(f,p,v,g),rn=Ie.values(f,p,v,g))}let mn=G*Re,B=ce*Re;for(let Ie=Y==1?v:g;Ie>=v&&Ie<=g;Ie+=Y){let je=T[Ie];if(je==null)continue;if(rn!=null){let q=rn[Ie]??0;if(je-q==0)continue;ge=x(q,C,D,O)}let lt=M.distr!=2||c!=null?_[Ie]:Ie,we=S(lt,M,P,E),kt=x(Tt(je,ee),C,D,O),Ve=z(we-ye),$e=z(ei(kt,ge)),I=z(zi(kt,ge)),w=$e-I;if(je!=null){let q=je<0?B:mn,ue=je<0?mn:B;Xe?(at>0&&rt[Ie]!=null&&Q(Qt.get(rt[Ie]),Ve,I+gi(at/2),Re,ei(0,w-at),q,ue),pt[Ie]!=null&&Q(ut.get(pt[Ie]),Ve,I+gi(at/2),Re,ei(0,w-at),q,ue)):Q(wn,Ve,I+gi(at/2),Re,ei(0,w-at),q,ue),ie(f,p,Ie,Ve-at/2,I,Re+at,w)}}return at>0?St.stroke=Xe?Qt:wn:Xe||(St._fill=m.width==0?m._fill:m._stroke??m._fill,St.width=0),St.fill=Xe?ut:wn,St})}function Pv(i,e){let t=Tt(e?.alignGaps,0);return(n,s,r,o)=>vr(n,s,(a,l,c,h,d,u,f,p,v,g,m)=>{[r,o]=Wl(c,r,o);let _=a.pxRound,T=G=>_(u(G,h,g,p)),M=G=>_(f(G,d,m,v)),C,S,x;h.ori==0?(C=$l,x=ho,S=cg):(C=Kl,x=uo,S=hg);let E=h.dir*(h.ori==0?1:-1),O=T(l[E==1?r:o]),P=O,D=[],z=[];for(let G=E==1?r:o;G>=r&&G<=o;G+=E)if(c[G]!=null){let Y=l[G],Q=T(Y);D.push(P=Q),z.push(M(c[G]))}let W={stroke:i(D,z,C,x,S,_),fill:null,clip:null,band:null,gaps:null,flags:lo},N=W.stroke,[V,Z]=vd(n,s);if(a.fill!=null||V!=0){let G=W.fill=new Path2D(N),ce=a.fillTo(n,s,a.min,a.max,V),Y=M(ce);x(G,P,Y),x(G,O,Y)}if(!a.spanGaps){let G=[];G.push(...bd(l,c,r,o,E,T,t)),W.gaps=G=a.gaps(n,s,r,o,G),W.clip=Zl(G,h.ori,p,v,g,m)}return Z!=0&&(W.band=Z==2?[bs(n,s,r,o,N,-1),bs(n,s,r,o,N,1)]:bs(n,s,r,o,N,Z)),W})}function Iv(i){return Pv(Lv,i)}function Lv(i,e,t,n,s,r){let o=i.length;if(o<2)return null;let a=new Path2D;if(t(a,i[0],e[0]),o==2)n(a,i[1],e[1]);else{let l=Array(o),c=Array(o-1),h=Array(o-1),d=Array(o-1);for(let u=0;u<o-1;u++)h[u]=e[u+1]-e[u],d[u]=i[u+1]-i[u],c[u]=h[u]/d[u];l[0]=c[0];for(let u=1;u<o-1;u++)c[u]===0||c[u-1]===0||c[u-1]>0!=c[u]>0?l[u]=0:(l[u]=3*(d[u-1]+d[u])/((2*d[u]+d[u-1])/c[u-1]+(d[u]+2*d[u-1])/c[u]),isFinite(l[u])||(l[u]=0));l[o-1]=c[o-2];for(let u=0;u<o-1;u++)s(a,i[u]+d[u]/3,e[u]+l[u]*d[u]/3,i[u+1]-d[u]/3,e[u+1]-l[u+1]*d[u]/3,i[u+1],e[u+1])}return a}var ad=new Set;function Rm(){for(let i of ad)i.syncRect(!0)}co&&(_r(dy,so,Rm),_r(fy,so,Rm,!0),_r(Hl,so,()=>{zn.pxRatio=Rt}));var Dv=fg(),Nv=ug();function Cm(i,e,t,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>ld(r,o,e,t))}function Uv(i,e){return i.map((t,n)=>n==0?{}:vn({},e,t))}function ld(i,e,t,n){return vn({},e==0?t:n,i)}function pg(i,e,t){return e==null?oo:[e,t]}var Ov=pg;function Fv(i,e,t){return e==null?oo:Gl(e,t,fd,!0)}function mg(i,e,t,n){return e==null?oo:Xl(e,t,i.scales[n].log,!1)}var kv=mg;function gg(i,e,t,n){return e==null?oo:dd(e,t,i.scales[n].log,!1)}var Bv=gg;function zv(i,e,t,n,s){let r=ei(am(i),am(e)),o=e-i,a=Bi(s/n*o,t);do{let l=t[a],c=n*l/o;if(c>=s&&r+(l<5?Xs.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function Pm(i){let e,t;return i=i.replace(/(\d+)px/,(n,s)=>(e=Tn((t=+s)*Rt))+"px"),[i,e,t]}function Hv(i){i.show&&[i.font,i.labelFont].forEach(e=>{let t=zt(e[2]*Rt,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function zn(i,e,t){let n={mode:Tt(i.mode,1)},s=n.mode;function r(y,A,L,F){let X=A.valToPct(y);return F+L*(A.dir==-1?1-X:X)}function o(y,A,L,F){let X=A.valToPct(y);return F+L*(A.dir==-1?X:1-X)}function a(y,A,L,F){return A.ori==0?r(y,A,L,F):o(y,A,L,F)}n.valToPosH=r,n.valToPosV=o;let l=!1;n.status=0;let c=n.root=wi(Z_);if(i.id!=null&&(c.id=i.id),mi(c,i.class),i.title){let y=wi(j_,c);y.textContent=i.title}let h=ki("canvas"),d=n.ctx=h.getContext("2d"),u=wi(J_,c);_r("click",u,y=>{y.target===p&&(qt!=jr||en!=Jr)&&Bn.click(n,y)},!0);let f=n.under=wi(Q_,u);u.appendChild(h);let p=n.over=wi(ey,u);i=ao(i);let v=+Tt(i.pxAlign,1),g=Tm(v);(i.plugins||[]).forEach(y=>{y.opts&&(i=y.opts(n,i)||i)});let m=i.ms||.001,_=n.series=s==1?Cm(i.series||[],ym,wm,!1):Uv(i.series||[null],Sm),T=n.axes=Cm(i.axes||[],_m,bm,!0),M=n.scales={},C=n.bands=i.bands||[];C.forEach(y=>{y.fill=bt(y.fill||null),y.dir=Tt(y.dir,-1)});let S=s==2?_[1].facets[0].scale:_[0].scale,x={axes:_s,series:gt},E=(i.drawOrder||["axes","series"]).map(y=>x[y]);function O(y){let A=y.distr==3?L=>vs(L>0?L:y.clamp(n,L,y.min,y.max,y.key)):y.distr==4?L=>$u(L,y.asinh):y.distr==100?L=>y.fwd(L):L=>L;return L=>{let F=A(L),{_min:X,_max:j}=y,le=j-X;return(F-X)/le}}function P(y){let A=M[y];if(A==null){let L=(i.scales||ga)[y]||ga;if(L.from!=null){P(L.from);let F=vn({},M[L.from],L,{key:y});F.valToPct=O(F),M[y]=F}else{A=M[y]=vn({},y==S?sg:Sv,L),A.key=y;let F=A.time,X=A.range,j=Ws(X);if((y!=S||s==2&&!F)&&(j&&(X[0]==null||X[1]==null)&&(X={min:X[0]==null?sm:{mode:1,hard:X[0],soft:X[0]},max:X[1]==null?sm:{mode:1,hard:X[1],soft:X[1]}},j=!1),!j&&Yl(X))){let le=X;X=(pe,be,Oe)=>be==null?oo:Gl(be,Oe,le)}A.range=bt(X||(F?Ov:y==S?A.distr==3?kv:A.distr==4?Bv:pg:A.distr==3?mg:A.distr==4?gg:Fv)),A.auto=bt(j?!1:A.auto),A.clamp=bt(A.clamp||Mv),A._min=A._max=null,A.valToPct=O(A)}}}P("x"),P("y"),s==1&&_.forEach(y=>{P(y.scale)}),T.forEach(y=>{P(y.scale)});for(let y in i.scales)P(y);let D=M[S],z=D.distr,W,N;D.ori==0?(mi(c,$_),W=r,N=o):(mi(c,K_),W=o,N=r);let V={};for(let y in M){let A=M[y];(A.min!=null||A.max!=null)&&(V[y]={min:A.min,max:A.max},A.min=A.max=null)}let Z=i.tzDate||(y=>new Date(Tn(y/m))),G=i.fmtDate||gd,ce=m==1?$y(Z):Jy(Z),Y=mm(Z,pm(m==1?Zy:jy,G)),Q=xm(Z,gm(ev,G)),ie=[],de=n.legend=vn({},iv,i.legend),fe=n.cursor=vn({},cv,{drag:{y:s==2}},i.cursor),ee=de.show,ge=fe.show,ye=de.markers;de.idxs=ie,ye.width=bt(ye.width),ye.dash=bt(ye.dash),ye.stroke=bt(ye.stroke),ye.fill=bt(ye.fill);let Re,Se,Ye,at=[],Xe=[],pt,ut=!1,rt={};if(de.live){let y=_[1]?_[1].values:null;ut=y!=null,pt=ut?y(n,1,0):{_:0};for(let A in pt)rt[A]=hd}if(ee)if(Re=ki("table",oy,c),Ye=ki("tbody",null,Re),de.mount(n,Re),ut){Se=ki("thead",null,Re,Ye);let y=ki("tr",null,Se);ki("th",null,y);for(var Qt in pt)ki("th",Xp,y).textContent=Qt}else mi(Re,ly),de.live&&mi(Re,ay);let Gt={show:!0},pn={show:!1};function Ot(y,A){if(A==0&&(ut||!de.live||s==2))return oo;let L=[],F=ki("tr",cy,Ye,Ye.childNodes[A]);mi(F,y.class),y.show||mi(F,xr);let X=ki("th",null,F);if(ye.show){let pe=wi(hy,X);if(A>0){let be=ye.width(n,A);be&&(pe.style.border=be+"px "+ye.dash(n,A)+" "+ye.stroke(n,A)),pe.style.background=ye.fill(n,A)}}let j=wi(Xp,X);y.label instanceof HTMLElement?j.appendChild(y.label):j.textContent=y.label,A>0&&(ye.show||(j.style.color=y.width>0?ye.stroke(n,A):ye.fill(n,A)),St("click",X,pe=>{if(fe._lock)return;tt(pe);let be=_.indexOf(y);if((pe.ctrlKey||pe.metaKey)!=de.isolate){let Oe=_.some((Fe,Be)=>Be>0&&Be!=be&&Fe.show);_.forEach((Fe,Be)=>{Be>0&&Qi(Be,Oe?Be==be?Gt:pn:Gt,!0,yn.setSeries)})}else Qi(be,{show:!y.show},!0,yn.setSeries)},!1),nt&&St($p,X,pe=>{fe._lock||(tt(pe),Qi(_.indexOf(y),eo,!0,yn.setSeries))},!1));for(var le in pt){let pe=ki("td",uy,F);pe.textContent="--",L.push(pe)}return[F,L]}let Ln=new Map;function St(y,A,L,F=!0){let X=Ln.get(A)||{},j=fe.bind[y](n,A,L,F);j&&(_r(y,A,X[y]=j),Ln.set(A,X))}function wn(y,A,L){let F=Ln.get(A)||{};for(let X in F)(y==null||X==y)&&(nd(X,A,F[X]),delete F[X]);y==null&&Ln.delete(A)}let rn=0,mn=0,B=0,Ie=0,je=0,lt=0,we=je,kt=lt,Ve=B,$e=Ie,I=0,w=0,q=0,ue=0;n.bbox={};let ae=!1,_e=!1,ve=!1,te=!1,se=!1,me=!1;function k(y,A,L){(L||y!=n.width||A!=n.height)&&oe(y,A),dt(!1),ve=!0,_e=!0,Wn()}function oe(y,A){n.width=rn=B=y,n.height=mn=Ie=A,je=lt=0,Me(),qe();let L=n.bbox;I=L.left=mr(je*Rt,.5),w=L.top=mr(lt*Rt,.5),q=L.width=mr(B*Rt,.5),ue=L.height=mr(Ie*Rt,.5)}let ne=3;function Ee(){let y=!1,A=0;for(;!y;){A++;let L=Zr(A),F=Ji(A);y=A==ne||L&&F,y||(oe(n.width,n.height),_e=!0)}}function xe({width:y,height:A}){k(y,A)}n.setSize=xe;function Me(){let y=!1,A=!1,L=!1,F=!1;T.forEach((X,j)=>{if(X.show&&X._show){let{side:le,_size:pe}=X,be=le%2,Oe=X.label!=null?X.labelSize:0,Fe=pe+Oe;Fe>0&&(be?(B-=Fe,le==3?(je+=Fe,F=!0):L=!0):(Ie-=Fe,le==0?(lt+=Fe,y=!0):A=!0))}}),Ki[0]=y,Ki[1]=L,Ki[2]=A,Ki[3]=F,B-=Ui[1]+Ui[3],je+=Ui[3],Ie-=Ui[2]+Ui[0],lt+=Ui[0]}function qe(){let y=je+B,A=lt+Ie,L=je,F=lt;function X(j,le){switch(j){case 1:return y+=le,y-le;case 2:return A+=le,A-le;case 3:return L-=le,L+le;case 0:return F-=le,F+le}}T.forEach((j,le)=>{if(j.show&&j._show){let pe=j.side;j._pos=X(pe,j._size),j.label!=null&&(j._lpos=X(pe,j.labelSize))}})}if(fe.dataIdx==null){let y=fe.hover,A=y.skip=new Set(y.skip??[]);A.add(void 0);let L=y.prox=bt(y.prox),F=y.bias??=0;fe.dataIdx=(X,j,le,pe)=>{if(j==0)return le;let be=le,Oe=L(X,j,le,pe)??Bt,Fe=Oe>=0&&Oe<Bt,Be=D.ori==0?B:Ie,ot=fe.left,At=e[0],Et=e[j];if(A.has(Et[le])){be=null;let _t=null,Qe=null,Ze;if(F==0||F==-1)for(Ze=le;_t==null&&Ze-- >0;)A.has(Et[Ze])||(_t=Ze);if(F==0||F==1)for(Ze=le;Qe==null&&Ze++<Et.length;)A.has(Et[Ze])||(Qe=Ze);if(_t!=null||Qe!=null)if(Fe){let Zt=_t==null?-1/0:W(At[_t],D,Be,0),ln=Qe==null?1/0:W(At[Qe],D,Be,0),On=ot-Zt,Ft=ln-ot;On<=Ft?On<=Oe&&(be=_t):Ft<=Oe&&(be=Qe)}else be=Qe==null?_t:_t==null?Qe:le-_t<=Qe-le?_t:Qe}else Fe&&An(ot-W(At[le],D,Be,0))>Oe&&(be=null);return be}}let tt=y=>{fe.event=y};fe.idxs=ie,fe._lock=!1;let he=fe.points;he.show=bt(he.show),he.size=bt(he.size),he.stroke=bt(he.stroke),he.width=bt(he.width),he.fill=bt(he.fill);let ze=n.focus=vn({},i.focus||{alpha:.3},fe.focus),nt=ze.prox>=0,Ce=nt&&he.one,ct=[],Xt=[],$n=[];function ia(y,A){let L=he.show(n,A);if(L instanceof HTMLElement)return mi(L,ry),mi(L,y.class),is(L,-10,-10,B,Ie),p.insertBefore(L,ct[A]),L}function Xr(y,A){if(s==1||A>0){let L=s==1&&M[y.scale].time,F=y.value;y.value=L?hm(F)?xm(Z,gm(F,G)):F||Q:F||yv,y.label=y.label||(L?uv:hv)}if(Ce||A>0){y.width=y.width==null?1:y.width,y.paths=y.paths||Dv||Sy,y.fillTo=bt(y.fillTo||wv),y.pxAlign=+Tt(y.pxAlign,v),y.pxRound=Tm(y.pxAlign),y.stroke=bt(y.stroke||null),y.fill=bt(y.fill||null),y._stroke=y._fill=y._paths=y._focus=null;let L=vv(ei(1,y.width),1),F=y.points=vn({},{size:L,width:ei(1,L*.2),stroke:y.stroke,space:L*2,paths:Nv,_stroke:null,_fill:null},y.points);F.show=bt(F.show),F.filter=bt(F.filter),F.fill=bt(F.fill),F.stroke=bt(F.stroke),F.paths=bt(F.paths),F.pxAlign=y.pxAlign}if(ee){let L=Ot(y,A);at.splice(A,0,L[0]),Xe.splice(A,0,L[1]),de.values.push(null)}if(ge){ie.splice(A,0,null);let L=null;Ce?A==0&&(L=ia(y,A)):A>0&&(L=ia(y,A)),ct.splice(A,0,L),Xt.splice(A,0,0),$n.splice(A,0,0)}Un("addSeries",A)}function Ou(y,A){A=A??_.length,y=s==1?ld(y,A,ym,wm):ld(y,A,{},Sm),_.splice(A,0,y),Xr(_[A],A)}n.addSeries=Ou;function Dl(y){if(_.splice(y,1),ee){de.values.splice(y,1),Xe.splice(y,1);let A=at.splice(y,1)[0];wn(null,A.firstChild),A.remove()}ge&&(ie.splice(y,1),ct.splice(y,1)[0].remove(),Xt.splice(y,1),$n.splice(y,1)),Un("delSeries",y)}n.delSeries=Dl;let Ki=[!1,!1,!1,!1];function ms(y,A){if(y._show=y.show,y.show){let L=y.side%2,F=M[y.scale];F==null&&(y.scale=L?_[1].scale:S,F=M[y.scale]);let X=F.time;y.size=bt(y.size),y.space=bt(y.space),y.rotate=bt(y.rotate),Ws(y.incrs)&&y.incrs.forEach(le=>{!Xs.has(le)&&Xs.set(le,Bm(le))}),y.incrs=bt(y.incrs||(F.distr==2?Xy:X?m==1?Yy:Ky:gr)),y.splits=bt(y.splits||(X&&F.distr==1?ce:F.distr==3?sd:F.distr==4?pv:fv)),y.stroke=bt(y.stroke),y.grid.stroke=bt(y.grid.stroke),y.ticks.stroke=bt(y.ticks.stroke),y.border.stroke=bt(y.border.stroke);let j=y.values;y.values=Ws(j)&&!Ws(j[0])?bt(j):X?Ws(j)?mm(Z,pm(j,G)):hm(j)?Qy(Z,j):j||Y:j||dv,y.filter=bt(y.filter||(F.distr>=3&&F.log==10?xv:F.distr==3&&F.log==2?_v:Fm)),y.font=Pm(y.font),y.labelFont=Pm(y.labelFont),y._size=y.size(n,null,A,0),y._space=y._rotate=y._incrs=y._found=y._splits=y._values=null,y._size>0&&(Ki[A]=!0,y._el=wi(ty,u))}}function gs(y,A,L,F){let[X,j,le,pe]=L,be=A%2,Oe=0;return be==0&&(pe||j)&&(Oe=A==0&&!X||A==2&&!le?Tn(_m.size/3):0),be==1&&(X||le)&&(Oe=A==1&&!j||A==3&&!pe?Tn(bm.size/2):0),Oe}let sa=n.padding=(i.padding||[gs,gs,gs,gs]).map(y=>bt(Tt(y,gs))),Ui=n._padding=sa.map((y,A)=>y(n,A,Ki,0)),on,dn=null,fn=null,ji=s==1?_[0].idxs:null,ui=null,ks=!1;function ra(y,A){if(e=y??[],n.data=n._data=e,s==2){on=0;for(let L=1;L<_.length;L++)on+=e[L][0].length}else{e.length==0&&(n.data=n._data=e=[[]]),ui=e[0],on=ui.length;let L=e;if(z==2){L=e.slice();let F=L[0]=Array(on);for(let X=0;X<on;X++)F[X]=X}n._data=e=L}if(dt(!0),Un("setData"),z==2&&(ve=!0),A!==!1){let L=D;L.auto(n,ks)?oa():Hs(S,L.min,L.max),te=te||fe.left>=0,me=!0,Wn()}}n.setData=ra;function oa(){ks=!0;let y,A;s==1&&(on>0?(dn=ji[0]=0,fn=ji[1]=on-1,y=e[0][dn],A=e[0][fn],z==2?(y=dn,A=fn):y==A&&(z==3?[y,A]=Xl(y,y,D.log,!1):z==4?[y,A]=dd(y,y,D.log,!1):D.time?A=y+Tn(86400/m):[y,A]=Gl(y,A,fd,!0))):(dn=ji[0]=y=null,fn=ji[1]=A=null)),Hs(S,y,A)}let qr,Bs,Yr,R,H,J,$,K,Te,Le;function Ae(y,A,L,F,X,j){y??=Yp,L??=md,F??="butt",X??=Yp,j??="round",y!=qr&&(d.strokeStyle=qr=y),X!=Bs&&(d.fillStyle=Bs=X),A!=Yr&&(d.lineWidth=Yr=A),j!=H&&(d.lineJoin=H=j),F!=J&&(d.lineCap=J=F),L!=R&&d.setLineDash(R=L)}function Ne(y,A,L,F){A!=Bs&&(d.fillStyle=Bs=A),y!=$&&(d.font=$=y),L!=K&&(d.textAlign=K=L),F!=Te&&(d.textBaseline=Te=F)}function Ge(y,A,L,F,X=0){if(F.length>0&&y.auto(n,ks)&&(A==null||A.min==null)){let j=Tt(dn,0),le=Tt(fn,F.length-1),pe=L.min==null?xy(F,j,le,X,y.distr==3):[L.min,L.max];y.min=zi(y.min,L.min=pe[0]),y.max=ei(y.max,L.max=pe[1])}}let it={min:null,max:null};function mt(){for(let F in M){let X=M[F];V[F]==null&&(X.min==null||V[S]!=null&&X.auto(n,ks))&&(V[F]=it)}for(let F in M){let X=M[F];V[F]==null&&X.from!=null&&V[X.from]!=null&&(V[F]=it)}V[S]!=null&&dt(!0);let y={};for(let F in V){let X=V[F];if(X!=null){let j=y[F]=ao(M[F],Ty);if(X.min!=null)vn(j,X);else if(F!=S||s==2)if(on==0&&j.from==null){let le=j.range(n,null,null,F);j.min=le[0],j.max=le[1]}else j.min=Bt,j.max=-Bt}}if(on>0){_.forEach((F,X)=>{if(s==1){let j=F.scale,le=V[j];if(le==null)return;let pe=y[j];if(X==0){let be=pe.range(n,pe.min,pe.max,j);pe.min=be[0],pe.max=be[1],dn=Bi(pe.min,e[0]),fn=Bi(pe.max,e[0]),fn-dn>1&&(e[0][dn]<pe.min&&dn++,e[0][fn]>pe.max&&fn--),F.min=ui[dn],F.max=ui[fn]}else F.show&&F.auto&&Ge(pe,le,F,e[X],F.sorted);F.idxs[0]=dn,F.idxs[1]=fn}else if(X>0&&F.show&&F.auto){let[j,le]=F.facets,pe=j.scale,be=le.scale,[Oe,Fe]=e[X],Be=y[pe],ot=y[be];Be!=null&&Ge(Be,V[pe],j,Oe,j.sorted),ot!=null&&Ge(ot,V[be],le,Fe,le.sorted),F.min=le.min,F.max=le.max}});for(let F in y){let X=y[F],j=V[F];if(X.from==null&&(j==null||j.min==null)){let le=X.range(n,X.min==Bt?null:X.min,X.max==-Bt?null:X.max,F);X.min=le[0],X.max=le[1]}}}for(let F in y){let X=y[F];if(X.from!=null){let j=y[X.from];if(j.min==null)X.min=X.max=null;else{let le=X.range(n,j.min,j.max,F);X.min=le[0],X.max=le[1]}}}let A={},L=!1;for(let F in y){let X=y[F],j=M[F];if(j.min!=X.min||j.max!=X.max){j.min=X.min,j.max=X.max;let le=j.distr;j._min=le==3?vs(j.min):le==4?$u(j.min,j.asinh):le==100?j.fwd(j.min):j.min,j._max=le==3?vs(j.max):le==4?$u(j.max,j.asinh):le==100?j.fwd(j.max):j.max,A[F]=L=!0}}if(L){_.forEach((F,X)=>{s==2?X>0&&A.y&&(F._paths=null):A[F.scale]&&(F._paths=null)});for(let F in A)ve=!0,Un("setScale",F);ge&&fe.left>=0&&(te=me=!0)}for(let F in V)V[F]=null}function He(y){let A=id(dn-1,0,on-1),L=id(fn+1,0,on-1);for(;y[A]==null&&A>0;)A--;for(;y[L]==null&&L<on-1;)L++;return[A,L]}function gt(){if(on>0){let y=_.some(A=>A._focus)&&Le!=ze.alpha;y&&(d.globalAlpha=Le=ze.alpha),_.forEach((A,L)=>{if(L>0&&A.show&&(sn(L,!1),sn(L,!0),A._paths==null)){let F=Le;Le!=A.alpha&&(d.globalAlpha=Le=A.alpha);let X=s==2?[0,e[L][0].length-1]:He(e[L]);A._paths=A.paths(n,L,X[0],X[1]),Le!=F&&(d.globalAlpha=Le=F)}}),_.forEach((A,L)=>{if(L>0&&A.show){let F=Le;Le!=A.alpha&&(d.globalAlpha=Le=A.alpha),A._paths!=null&&Dt(L,!1);{let X=A._paths!=null?A._paths.gaps:null,j=A.points.show(n,L,dn,fn,X),le=A.points.filter(n,L,j,X);(j||le)&&(A.points._paths=A.points.paths(n,L,dn,fn,le),Dt(L,!0))}Le!=F&&(d.globalAlpha=Le=F),Un("drawSeries",L)}}),y&&(d.globalAlpha=Le=1)}}function sn(y,A){let L=A?_[y].points:_[y];L._stroke=L.stroke(n,y),L._fill=L.fill(n,y)}function Dt(y,A){let L=A?_[y].points:_[y],{stroke:F,fill:X,clip:j,flags:le,_stroke:pe=L._stroke,_fill:be=L._fill,_width:Oe=L.width}=L._paths;Oe=zt(Oe*Rt,3);let Fe=null,Be=Oe%2/2;A&&be==null&&(be=Oe>0?"#fff":pe);let ot=L.pxAlign==1&&Be>0;if(ot&&d.translate(Be,Be),!A){let At=I-Oe/2,Et=w-Oe/2,_t=q+Oe,Qe=ue+Oe;Fe=new Path2D,Fe.rect(At,Et,_t,Qe)}A?ke(pe,Oe,L.dash,L.cap,be,F,X,le,j):Nt(y,pe,Oe,L.dash,L.cap,be,F,X,le,Fe,j),ot&&d.translate(-Be,-Be)}function Nt(y,A,L,F,X,j,le,pe,be,Oe,Fe){let Be=!1;be!=0&&C.forEach((ot,At)=>{if(ot.series[0]==y){let Et=_[ot.series[1]],_t=e[ot.series[1]],Qe=(Et._paths||ga).band;Ws(Qe)&&(Qe=ot.dir==1?Qe[0]:Qe[1]);let Ze,Zt=null;Et.show&&Qe&&yy(_t,dn,fn)?(Zt=ot.fill(n,At)||j,Ze=Et._paths.clip):Qe=null,ke(A,L,F,X,Zt,le,pe,be,Oe,Fe,Ze,Qe),Be=!0}}),Be||ke(A,L,F,X,j,le,pe,be,Oe,Fe)}let En=lo|od;function ke(y,A,L,F,X,j,le,pe,be,Oe,Fe,Be){Ae(y,A,L,F,X),(be||Oe||Be)&&(d.save(),be&&d.clip(be),Oe&&d.clip(Oe)),Be?(pe&En)==En?(d.clip(Be),Fe&&d.clip(Fe),vt(X,le),gn(y,j,A)):pe&od?(vt(X,le),d.clip(Be),gn(y,j,A)):pe&lo&&(d.save(),d.clip(Be),Fe&&d.clip(Fe),vt(X,le),d.restore(),gn(y,j,A)):(vt(X,le),gn(y,j,A)),(be||Oe||Be)&&d.restore()}function gn(y,A,L){L>0&&(A instanceof Map?A.forEach((F,X)=>{d.strokeStyle=qr=X,d.stroke(F)}):A!=null&&y&&d.stroke(A))}function vt(y,A){A instanceof Map?A.forEach((L,F)=>{d.fillStyle=Bs=F,d.fill(L)}):A!=null&&y&&d.fill(A)}function xs(y,A,L,F){let X=T[y],j;if(F<=0)j=[0,0];else{let le=X._space=X.space(n,y,A,L,F),pe=X._incrs=X.incrs(n,y,A,L,F,le);j=zv(A,L,pe,F,le)}return X._found=j}function xn(y,A,L,F,X,j,le,pe,be,Oe){let Fe=le%2/2;v==1&&d.translate(Fe,Fe),Ae(pe,le,be,Oe,pe),d.beginPath();let Be,ot,At,Et,_t=X+(F==0||F==3?-j:j);L==0?(ot=X,Et=_t):(Be=X,At=_t);for(let Qe=0;Qe<y.length;Qe++)A[Qe]!=null&&(L==0?Be=At=y[Qe]:ot=Et=y[Qe],d.moveTo(Be,ot),d.lineTo(At,Et));d.stroke(),v==1&&d.translate(-Fe,-Fe)}function Zr(y){let A=!0;return T.forEach((L,F)=>{if(!L.show)return;let X=M[L.scale];if(X.min==null){L._show&&(A=!1,L._show=!1,dt(!1));return}else L._show||(A=!1,L._show=!0,dt(!1));let j=L.side,le=j%2,{min:pe,max:be}=X,[Oe,Fe]=xs(F,pe,be,le==0?B:Ie);if(Fe==0)return;let Be=X.distr==2,ot=L._splits=L.splits(n,F,pe,be,Oe,Fe,Be),At=X.distr==2?ot.map(Ze=>ui[Ze]):ot,Et=X.distr==2?ui[ot[1]]-ui[ot[0]]:Oe,_t=L._values=L.values(n,L.filter(n,At,F,Fe,Et),F,Fe,Et);L._rotate=j==2?L.rotate(n,_t,F,Fe):0;let Qe=L._size;L._size=Ei(L.size(n,_t,F,y)),Qe!=null&&L._size!=Qe&&(A=!1)}),A}function Ji(y){let A=!0;return sa.forEach((L,F)=>{let X=L(n,F,Ki,y);X!=Ui[F]&&(A=!1),Ui[F]=X}),A}function _s(){for(let y=0;y<T.length;y++){let A=T[y];if(!A.show||!A._show)continue;let L=A.side,F=L%2,X,j,le=A.stroke(n,y),pe=L==0||L==3?-1:1,[be,Oe]=A._found;if(A.label!=null){let Jn=A.labelGap*pe,pi=Tn((A._lpos+Jn)*Rt);Ne(A.labelFont[0],le,"center",L==2?"top":qp),d.save(),F==1?(X=j=0,d.translate(pi,Tn(w+ue/2)),d.rotate((L==3?-zl:zl)/2)):(X=Tn(I+q/2),j=pi);let pr=Um(A.label)?A.label(n,y,be,Oe):A.label;d.fillText(pr,X,j),d.restore()}if(Oe==0)continue;let Fe=M[A.scale],Be=F==0?q:ue,ot=F==0?I:w,At=A._splits,Et=Fe.distr==2?At.map(Jn=>ui[Jn]):At,_t=Fe.distr==2?ui[At[1]]-ui[At[0]]:be,Qe=A.ticks,Ze=A.border,Zt=Qe.show?Qe.size:0,ln=Tn(Zt*Rt),On=Tn((A.alignTo==2?A._size-Zt-A.gap:A.gap)*Rt),Ft=A._rotate*-zl/180,cn=g(A._pos*Rt),di=(ln+On)*pe,jn=cn+di;j=F==0?jn:0,X=F==1?jn:0;let Mi=A.font[0],Oi=A.align==1?no:A.align==2?qu:Ft>0?no:Ft<0?qu:F==0?"center":L==3?qu:no,ts=Ft||F==1?"middle":L==2?"top":qp;Ne(Mi,le,Oi,ts);let fi=A.font[1]*A.lineGap,Si=At.map(Jn=>g(a(Jn,Fe,Be,ot))),Fi=A._values;for(let Jn=0;Jn<Fi.length;Jn++){let pi=Fi[Jn];if(pi!=null){F==0?X=Si[Jn]:j=Si[Jn],pi=""+pi;let pr=pi.indexOf(`
`)==-1?[pi]:pi.split(/\n/gm);for(let Qn=0;Qn<pr.length;Qn++){let Wp=pr[Qn];Ft?(d.save(),d.translate(X,j+Qn*fi),d.rotate(Ft),d.fillText(Wp,0,0),d.restore()):d.fillText(Wp,X,j+Qn*fi)}}}Qe.show&&xn(Si,Qe.filter(n,Et,y,Oe,_t),F,L,cn,ln,zt(Qe.width*Rt,3),Qe.stroke(n,y),Qe.dash,Qe.cap);let ns=A.grid;ns.show&&xn(Si,ns.filter(n,Et,y,Oe,_t),F,F==0?2:1,F==0?w:I,F==0?ue:q,zt(ns.width*Rt,3),ns.stroke(n,y),ns.dash,ns.cap),Ze.show&&xn([cn],[1],F==0?1:0,F==0?1:2,F==1?w:I,F==1?ue:q,zt(Ze.width*Rt,3),Ze.stroke(n,y),Ze.dash,Ze.cap)}Un("drawAxes")}function dt(y){_.forEach((A,L)=>{L>0&&(A._paths=null,y&&(s==1?(A.min=null,A.max=null):A.facets.forEach(F=>{F.min=null,F.max=null})))})}let an=!1,Kn=!1,Ut=[];function _n(){Kn=!1;for(let y=0;y<Ut.length;y++)Un(...Ut[y]);Ut.length=0}function Wn(){an||(Dy(Tp),an=!0)}function Nl(y,A=!1){an=!0,Kn=A,y(n),Tp(),A&&Ut.length>0&&queueMicrotask(_n)}n.batch=Nl;function Tp(){if(ae&&(mt(),ae=!1),ve&&(Ee(),ve=!1),_e){if($t(f,no,je),$t(f,"top",lt),$t(f,da,B),$t(f,fa,Ie),$t(p,no,je),$t(p,"top",lt),$t(p,da,B),$t(p,fa,Ie),$t(u,da,rn),$t(u,fa,mn),h.width=Tn(rn*Rt),h.height=Tn(mn*Rt),T.forEach(({_el:y,_show:A,_size:L,_pos:F,side:X})=>{if(y!=null)if(A){let j=X===3||X===0?L:0,le=X%2==1;$t(y,le?"left":"top",F-j),$t(y,le?"width":"height",L),$t(y,le?"top":"left",le?lt:je),$t(y,le?"height":"width",le?Ie:B),td(y,xr)}else mi(y,xr)}),qr=Bs=Yr=H=J=$=K=Te=R=null,Le=1,ca(!0),je!=we||lt!=kt||B!=Ve||Ie!=$e){dt(!1);let y=B/Ve,A=Ie/$e;if(ge&&!te&&fe.left>=0){fe.left*=y,fe.top*=A,$r&&is($r,Tn(fe.left),0,B,Ie),Kr&&is(Kr,0,Tn(fe.top),B,Ie);for(let L=0;L<ct.length;L++){let F=ct[L];F!=null&&(Xt[L]*=y,$n[L]*=A,is(F,Ei(Xt[L]),Ei($n[L]),B,Ie))}}if(Yt.show&&!se&&Yt.left>=0&&Yt.width>0){Yt.left*=y,Yt.width*=y,Yt.top*=A,Yt.height*=A;for(let L in Gu)$t(Qr,L,Yt[L])}we=je,kt=lt,Ve=B,$e=Ie}Un("setSize"),_e=!1}rn>0&&mn>0&&(d.clearRect(0,0,h.width,h.height),Un("drawClear"),E.forEach(y=>y()),Un("draw")),Yt.show&&se&&(Ul(Yt),se=!1),ge&&te&&(fr(null,!0,!1),te=!1),de.show&&de.live&&me&&(zu(),me=!1),l||(l=!0,n.status=1,Un("ready")),ks=!1,an=!1}n.redraw=(y,A)=>{ve=A||!1,y!==!1?Hs(S,D.min,D.max):Wn()};function Fu(y,A){let L=M[y];if(L.from==null){if(on==0){let F=L.range(n,A.min,A.max,y);A.min=F[0],A.max=F[1]}if(A.min>A.max){let F=A.min;A.min=A.max,A.max=F}if(on>1&&A.min!=null&&A.max!=null&&A.max-A.min<1e-16)return;y==S&&L.distr==2&&on>0&&(A.min=Bi(A.min,e[0]),A.max=Bi(A.max,e[0]),A.min==A.max&&A.max++),V[y]=A,ae=!0,Wn()}}n.setScale=Fu;let ku,Bu,$r,Kr,Ap,Rp,jr,Jr,Cp,Pp,qt,en,zs=!1,Bn=fe.drag,Dn=Bn.x,Nn=Bn.y;ge&&(fe.x&&(ku=wi(iy,p)),fe.y&&(Bu=wi(sy,p)),D.ori==0?($r=ku,Kr=Bu):($r=Bu,Kr=ku),qt=fe.left,en=fe.top);let Yt=n.select=vn({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),Qr=Yt.show?wi(ny,Yt.over?p:f):null;function Ul(y,A){if(Yt.show){for(let L in y)Yt[L]=y[L],L in Gu&&$t(Qr,L,y[L]);A!==!1&&Un("setSelect")}}n.setSelect=Ul;function O_(y){if(_[y].show)ee&&td(at[y],xr);else if(ee&&mi(at[y],xr),ge){let L=Ce?ct[0]:ct[y];L!=null&&is(L,-10,-10,B,Ie)}}function Hs(y,A,L){Fu(y,{min:A,max:L})}function Qi(y,A,L,F){A.focus!=null&&H_(y),A.show!=null&&_.forEach((X,j)=>{j>0&&(y==j||y==null)&&(X.show=A.show,O_(j),s==2?(Hs(X.facets[0].scale,null,null),Hs(X.facets[1].scale,null,null)):Hs(X.scale,null,null),Wn())}),L!==!1&&Un("setSeries",y,A),F&&ha("setSeries",n,y,A)}n.setSeries=Qi;function F_(y,A){vn(C[y],A)}function k_(y,A){y.fill=bt(y.fill||null),y.dir=Tt(y.dir,-1),A=A??C.length,C.splice(A,0,y)}function B_(y){y==null?C.length=0:C.splice(y,1)}n.addBand=k_,n.setBand=F_,n.delBand=B_;function z_(y,A){_[y].alpha=A,ge&&ct[y]!=null&&(ct[y].style.opacity=A),ee&&at[y]&&(at[y].style.opacity=A)}let ys,Gs,dr,eo={focus:!0};function H_(y){if(y!=dr){let A=y==null,L=ze.alpha!=1;_.forEach((F,X)=>{if(s==1||X>0){let j=A||X==0||X==y;F._focus=A?null:j,L&&z_(X,j?1:ze.alpha)}}),dr=y,L&&Wn()}}ee&&nt&&St(Kp,Re,y=>{fe._lock||(tt(y),dr!=null&&Qi(null,eo,!0,yn.setSeries))});function es(y,A,L){let F=M[A];L&&(y=y/Rt-(F.ori==1?lt:je));let X=B;F.ori==1&&(X=Ie,y=X-y),F.dir==-1&&(y=X-y);let j=F._min,le=F._max,pe=y/X,be=j+(le-j)*pe,Oe=F.distr;return Oe==3?ro(10,be):Oe==4?by(be,F.asinh):Oe==100?F.bwd(be):be}function G_(y,A){let L=es(y,S,A);return Bi(L,e[0],dn,fn)}n.valToIdx=y=>Bi(y,e[0]),n.posToIdx=G_,n.posToVal=es,n.valToPos=(y,A,L)=>M[A].ori==0?r(y,M[A],L?q:B,L?I:0):o(y,M[A],L?ue:Ie,L?w:0),n.setCursor=(y,A,L)=>{qt=y.left,en=y.top,fr(null,A,L)};function Ip(y,A){$t(Qr,no,Yt.left=y),$t(Qr,da,Yt.width=A)}function Lp(y,A){$t(Qr,"top",Yt.top=y),$t(Qr,fa,Yt.height=A)}let aa=D.ori==0?Ip:Lp,la=D.ori==1?Ip:Lp;function V_(){if(ee&&de.live)for(let y=s==2?1:0;y<_.length;y++){if(y==0&&ut)continue;let A=de.values[y],L=0;for(let F in A)Xe[y][L++].firstChild.nodeValue=A[F]}}function zu(y,A){if(y!=null&&(y.idxs?y.idxs.forEach((L,F)=>{ie[F]=L}):Ey(y.idx)||ie.fill(y.idx),de.idx=ie[0]),ee&&de.live){for(let L=0;L<_.length;L++)(L>0||s==1&&!ut)&&W_(L,ie[L]);V_()}me=!1,A!==!1&&Un("setLegend")}n.setLegend=zu;function W_(y,A){let L=_[y],F=y==0&&z==2?ui:e[y],X;ut?X=L.values(n,y,A)??rt:(X=L.value(n,A==null?null:F[A],y,A),X=X==null?rt:{_:X}),de.values[y]=X}function fr(y,A,L){Cp=qt,Pp=en,[qt,en]=fe.move(n,qt,en),fe.left=qt,fe.top=en,ge&&($r&&is($r,Tn(qt),0,B,Ie),Kr&&is(Kr,0,Tn(en),B,Ie));let F,X=dn>fn;ys=Bt,Gs=null;let j=D.ori==0?B:Ie,le=D.ori==1?B:Ie;if(qt<0||on==0||X){F=fe.idx=null;for(let pe=0;pe<_.length;pe++){let be=ct[pe];be!=null&&is(be,-10,-10,B,Ie)}nt&&Qi(null,eo,!0,y==null&&yn.setSeries),de.live&&(ie.fill(F),me=!0)}else{let pe,be,Oe;s==1&&(pe=D.ori==0?qt:en,be=es(pe,S),F=fe.idx=Bi(be,e[0],dn,fn),Oe=W(e[0][F],D,j,0));let Fe=-10,Be=-10,ot=0,At=0,Et=!0,_t="",Qe="";for(let Ze=s==2?1:0;Ze<_.length;Ze++){let Zt=_[Ze],ln=ie[Ze],On=ln==null?null:s==1?e[Ze][ln]:e[Ze][1][ln],Ft=fe.dataIdx(n,Ze,F,be),cn=Ft==null?null:s==1?e[Ze][Ft]:e[Ze][1][Ft];if(me=me||cn!=On||Ft!=ln,ie[Ze]=Ft,Ze>0&&Zt.show){let di=Ft==null?-10:Ft==F?Oe:W(s==1?e[0][Ft]:e[Ze][0][Ft],D,j,0),jn=cn==null?-10:N(cn,s==1?M[Zt.scale]:M[Zt.facets[1].scale],le,0);if(nt&&cn!=null){let Mi=D.ori==1?qt:en,Oi=An(ze.dist(n,Ze,Ft,jn,Mi));if(Oi<ys){let ts=ze.bias;if(ts!=0){let fi=es(Mi,Zt.scale),Si=cn>=0?1:-1,Fi=fi>=0?1:-1;Fi==Si&&(Fi==1?ts==1?cn>=fi:cn<=fi:ts==1?cn<=fi:cn>=fi)&&(ys=Oi,Gs=Ze)}else ys=Oi,Gs=Ze}}if(me||Ce){let Mi,Oi;D.ori==0?(Mi=di,Oi=jn):(Mi=jn,Oi=di);let ts,fi,Si,Fi,ns,Jn,pi=!0,pr=he.bbox;if(pr!=null){pi=!1;let Qn=pr(n,Ze);Si=Qn.left,Fi=Qn.top,ts=Qn.width,fi=Qn.height}else Si=Mi,Fi=Oi,ts=fi=he.size(n,Ze);if(Jn=he.fill(n,Ze),ns=he.stroke(n,Ze),Ce)Ze==Gs&&ys<=ze.prox&&(Fe=Si,Be=Fi,ot=ts,At=fi,Et=pi,_t=Jn,Qe=ns);else{let Qn=ct[Ze];Qn!=null&&(Xt[Ze]=Si,$n[Ze]=Fi,im(Qn,ts,fi,pi),tm(Qn,Jn,ns),is(Qn,Ei(Si),Ei(Fi),B,Ie))}}}}if(Ce){let Ze=ze.prox,Zt=dr==null?ys<=Ze:ys>Ze||Gs!=dr;if(me||Zt){let ln=ct[0];ln!=null&&(Xt[0]=Fe,$n[0]=Be,im(ln,ot,At,Et),tm(ln,_t,Qe),is(ln,Ei(Fe),Ei(Be),B,Ie))}}}if(Yt.show&&zs)if(y!=null){let[pe,be]=yn.scales,[Oe,Fe]=yn.match,[Be,ot]=y.cursor.sync.scales,At=y.cursor.drag;if(Dn=At._x,Nn=At._y,Dn||Nn){let{left:Et,top:_t,width:Qe,height:Ze}=y.select,Zt=y.scales[Be].ori,ln=y.posToVal,On,Ft,cn,di,jn,Mi=pe!=null&&Oe(pe,Be),Oi=be!=null&&Fe(be,ot);Mi&&Dn?(Zt==0?(On=Et,Ft=Qe):(On=_t,Ft=Ze),cn=M[pe],di=W(ln(On,Be),cn,j,0),jn=W(ln(On+Ft,Be),cn,j,0),aa(zi(di,jn),An(jn-di))):aa(0,j),Oi&&Nn?(Zt==1?(On=Et,Ft=Qe):(On=_t,Ft=Ze),cn=M[be],di=N(ln(On,ot),cn,le,0),jn=N(ln(On+Ft,ot),cn,le,0),la(zi(di,jn),An(jn-di))):la(0,le)}else Vu()}else{let pe=An(Cp-Ap),be=An(Pp-Rp);if(D.ori==1){let ot=pe;pe=be,be=ot}Dn=Bn.x&&pe>=Bn.dist,Nn=Bn.y&&be>=Bn.dist;let Oe=Bn.uni;Oe!=null?Dn&&Nn&&(Dn=pe>=Oe,Nn=be>=Oe,!Dn&&!Nn&&(be>pe?Nn=!0:Dn=!0)):Bn.x&&Bn.y&&(Dn||Nn)&&(Dn=Nn=!0);let Fe,Be;Dn&&(D.ori==0?(Fe=jr,Be=qt):(Fe=Jr,Be=en),aa(zi(Fe,Be),An(Be-Fe)),Nn||la(0,le)),Nn&&(D.ori==1?(Fe=jr,Be=qt):(Fe=Jr,Be=en),la(zi(Fe,Be),An(Be-Fe)),Dn||aa(0,j)),!Dn&&!Nn&&(aa(0,0),la(0,0))}if(Bn._x=Dn,Bn._y=Nn,y==null){if(L){if(Vp!=null){let[pe,be]=yn.scales;yn.values[0]=pe!=null?es(D.ori==0?qt:en,pe):null,yn.values[1]=be!=null?es(D.ori==1?qt:en,be):null}ha(Yu,n,qt,en,B,Ie,F)}if(nt){let pe=L&&yn.setSeries,be=ze.prox;dr==null?ys<=be&&Qi(Gs,eo,!0,pe):ys>be?Qi(null,eo,!0,pe):Gs!=dr&&Qi(Gs,eo,!0,pe)}}me&&(de.idx=F,zu()),A!==!1&&Un("setCursor")}let Vs=null;Object.defineProperty(n,"rect",{get(){return Vs==null&&ca(!1),Vs}});function ca(y=!1){y?Vs=null:(Vs=p.getBoundingClientRect(),Un("syncRect",Vs))}function Dp(y,A,L,F,X,j,le){fe._lock||zs&&y!=null&&y.movementX==0&&y.movementY==0||(Hu(y,A,L,F,X,j,le,!1,y!=null),y!=null?fr(null,!0,!0):fr(A,!0,!1))}function Hu(y,A,L,F,X,j,le,pe,be){if(Vs==null&&ca(!1),tt(y),y!=null)L=y.clientX-Vs.left,F=y.clientY-Vs.top;else{if(L<0||F<0){qt=-10,en=-10;return}let[Oe,Fe]=yn.scales,Be=A.cursor.sync,[ot,At]=Be.values,[Et,_t]=Be.scales,[Qe,Ze]=yn.match,Zt=A.axes[0].side%2==1,ln=D.ori==0?B:Ie,On=D.ori==1?B:Ie,Ft=Zt?j:X,cn=Zt?X:j,di=Zt?F:L,jn=Zt?L:F;if(Et!=null?L=Qe(Oe,Et)?a(ot,M[Oe],ln,0):-10:L=ln*(di/Ft),_t!=null?F=Ze(Fe,_t)?a(At,M[Fe],On,0):-10:F=On*(jn/cn),D.ori==1){let Mi=L;L=F,F=Mi}}be&&(A==null||A.cursor.event.type==Yu)&&((L<=1||L>=B-1)&&(L=mr(L,B)),(F<=1||F>=Ie-1)&&(F=mr(F,Ie))),pe?(Ap=L,Rp=F,[jr,Jr]=fe.move(n,L,F)):(qt=L,en=F)}let Gu={width:0,height:0,left:0,top:0};function Vu(){Ul(Gu,!1)}let Np,Up,Op,Fp;function kp(y,A,L,F,X,j,le){zs=!0,Dn=Nn=Bn._x=Bn._y=!1,Hu(y,A,L,F,X,j,le,!0,!1),y!=null&&(St(Zu,Qu,Bp,!1),ha(Zp,n,jr,Jr,B,Ie,null));let{left:pe,top:be,width:Oe,height:Fe}=Yt;Np=pe,Up=be,Op=Oe,Fp=Fe}function Bp(y,A,L,F,X,j,le){zs=Bn._x=Bn._y=!1,Hu(y,A,L,F,X,j,le,!1,!0);let{left:pe,top:be,width:Oe,height:Fe}=Yt,Be=Oe>0||Fe>0,ot=Np!=pe||Up!=be||Op!=Oe||Fp!=Fe;if(Be&&ot&&Ul(Yt),Bn.setScale&&Be&&ot){let At=pe,Et=Oe,_t=be,Qe=Fe;if(D.ori==1&&(At=be,Et=Fe,_t=pe,Qe=Oe),Dn&&Hs(S,es(At,S),es(At+Et,S)),Nn)for(let Ze in M){let Zt=M[Ze];Ze!=S&&Zt.from==null&&Zt.min!=Bt&&Hs(Ze,es(_t+Qe,Ze),es(_t,Ze))}Vu()}else fe.lock&&(fe._lock=!fe._lock,fr(A,!0,y!=null));y!=null&&(wn(Zu,Qu),ha(Zu,n,qt,en,B,Ie,null))}function X_(y,A,L,F,X,j,le){if(fe._lock)return;tt(y);let pe=zs;if(zs){let be=!0,Oe=!0,Fe=10,Be,ot;D.ori==0?(Be=Dn,ot=Nn):(Be=Nn,ot=Dn),Be&&ot&&(be=qt<=Fe||qt>=B-Fe,Oe=en<=Fe||en>=Ie-Fe),Be&&be&&(qt=qt<jr?0:B),ot&&Oe&&(en=en<Jr?0:Ie),fr(null,!0,!0),zs=!1}qt=-10,en=-10,ie.fill(null),fr(null,!0,!0),pe&&(zs=pe)}function zp(y,A,L,F,X,j,le){fe._lock||(tt(y),oa(),Vu(),y!=null&&ha(jp,n,qt,en,B,Ie,null))}function Hp(){T.forEach(Hv),k(n.width,n.height,!0)}_r(Hl,so,Hp);let to={};to.mousedown=kp,to.mousemove=Dp,to.mouseup=Bp,to.dblclick=zp,to.setSeries=(y,A,L,F)=>{let X=yn.match[2];L=X(n,A,L),L!=-1&&Qi(L,F,!0,!1)},ge&&(St(Zp,p,kp),St(Yu,p,Dp),St($p,p,y=>{tt(y),ca(!1)}),St(Kp,p,X_),St(jp,p,zp),ad.add(n),n.syncRect=ca);let Ol=n.hooks=i.hooks||{};function Un(y,A,L){Kn?Ut.push([y,A,L]):y in Ol&&Ol[y].forEach(F=>{F.call(null,n,A,L)})}(i.plugins||[]).forEach(y=>{for(let A in y.hooks)Ol[A]=(Ol[A]||[]).concat(y.hooks[A])});let Gp=(y,A,L)=>L,yn=vn({key:null,setSeries:!1,filters:{pub:lm,sub:lm},scales:[S,_[1]?_[1].scale:null],match:[cm,cm,Gp],values:[null,null]},fe.sync);yn.match.length==2&&yn.match.push(Gp),fe.sync=yn;let Vp=yn.key,Wu=rg(Vp);function ha(y,A,L,F,X,j,le){yn.filters.pub(y,A,L,F,X,j,le)&&Wu.pub(y,A,L,F,X,j,le)}Wu.sub(n);function q_(y,A,L,F,X,j,le){yn.filters.sub(y,A,L,F,X,j,le)&&to[y](null,A,L,F,X,j,le)}n.pub=q_;function Y_(){Wu.unsub(n),ad.delete(n),Ln.clear(),nd(Hl,so,Hp),c.remove(),Re?.remove(),Un("destroy")}n.destroy=Y_;function Xu(){Un("init",i,e),ra(e||i.data,!1),V[S]?Fu(S,V[S]):oa(),se=Yt.show&&(Yt.width>0||Yt.height>0),te=me=!0,k(i.width,i.height)}return _.forEach(Xr),T.forEach(ms),t?t instanceof HTMLElement?(t.appendChild(c),Xu()):t(n,Xu):Xu(),n}zn.assign=vn;zn.fmtNum=pd;zn.rangeNum=Gl;zn.rangeLog=Xl;zn.rangeAsinh=dd;zn.orient=vr;zn.pxRatio=Rt;zn.join=Ly;zn.fmtDate=gd,zn.tzDate=Vy;zn.sync=rg;{zn.addGap=Ev,zn.clipGaps=Zl;let i=zn.paths={points:ug};i.linear=fg,i.stepped=Rv,i.bars=Cv,i.spline=Iv}var Pe=i=>document.getElementById(i),re=(i,e={},...t)=>{let n=document.createElement(i);for(let[s,r]of Object.entries(e))typeof r=="function"?Object.assign(n,{[s]:r}):s==="text"?n.textContent=String(r):r===!0?n.setAttribute(s,""):r!==!1&&r!==void 0&&n.setAttribute(s,String(r));return n.append(...t),n},Gv=["onclick","onchange","oninput","onkeydown","onpointerdown"],xg=i=>i instanceof HTMLElement?`${i.tagName} ${i.dataset.id??i.getAttribute("aria-label")??""}`:i.nodeName,qs=(i,...e)=>{let t=i.firstChild;for(let n of e){let s=typeof n=="string"?document.createTextNode(n):n,r=t;for(;r&&xg(r)!==xg(s);)r=r.nextSibling;if(!r){i.insertBefore(s,t);continue}for(;t&&t!==r;){let{nextSibling:o}=t;t.remove(),t=o}Vv(r,s),t=r.nextSibling}for(;t;){let{nextSibling:n}=t;t.remove(),t=n}},Vv=(i,e)=>{if(!(i instanceof HTMLElement)||!(e instanceof HTMLElement)){i.textContent!==e.textContent&&(i.textContent=e.textContent);return}for(let{name:n}of[...i.attributes])n!=="data-typed"&&!e.hasAttribute(n)&&i.removeAttribute(n);for(let{name:n,value:s}of[...e.attributes])i.getAttribute(n)!==s&&i.setAttribute(n,s);for(let n of Gv)Object.assign(i,{[n]:e[n]});qs(i,...e.childNodes);let t=i.dataset.typed!==void 0||i===document.activeElement&&i.matches("[type=range]:active");if((i instanceof HTMLInputElement||i instanceof HTMLSelectElement)&&!t){let{value:n,checked:s}=e;i.value!==n&&(i.value=n),i instanceof HTMLInputElement&&(i.checked=s)}},br={play:"M7 4.5v15l12.500-7.500z",pause:"M6 4.5h4.200v15H6zM13.800 4.500H18v15h-4.200z",previous:"M5 5h2.4v14H5zM19 5v14L8.600 12z",next:"M16.600 5H19v14h-2.400zM5 5v14l10.400-7z",undo:"M9 5 3.500 10.500 9 16v-3.600h5a4 4 0 0 1 0 8h-3v2.100h3a6.100 6.100 0 0 0 0-12.200H9z",redo:"M15 5l5.500 5.500L15 16v-3.600h-5a4 4 0 0 0 0 8h3v2.100h-3a6.100 6.100 0 0 1 0-12.200h5z",save:"M4 4h12.500L20 7.500V20H4zM7 6v4.500h8V6zM12 12.800a2.700 2.700 0 1 0 0 5.400 2.700 2.700 0 0 0 0-5.400z",lock:"M6.500 10V8a5.500 5.500 0 0 1 11 0v2h1.500v11H5V10zM9 10h6V8a3 3 0 0 0-6 0z",menu:"M4 6h16v2.200H4zM4 11h16v2.200H4zM4 16h16v2.200H4z",theme:"M12 3a9 9 0 1 0 0 18zM12 5.200v13.600a6.800 6.800 0 0 0 0-13.600z",key:"M12 3.500 20.500 12 12 20.500 3.500 12z",bin:"M9 3h6l1 2h4v2.200H4V5h4zM5.500 8.500h13L17.500 21h-11z"},_a=i=>{let e=document.createElementNS("http://www.w3.org/2000/svg","svg");e.setAttribute("viewBox","0 0 24 24"),e.setAttribute("aria-hidden","true");let t=document.createElementNS("http://www.w3.org/2000/svg","path");return t.setAttribute("d",br[i]),t.setAttribute("fill-rule","evenodd"),e.append(t),e},Mr=(i,e)=>{i.textContent!==e&&(i.textContent=e)},_g=0,hn=(i,e="done")=>{if(!i)return;let t=Pe("toast");t.textContent=i,t.className=e,t.setAttribute("role",e==="wrong"?"alert":"status"),t.hidden=!1,window.clearTimeout(_g),_g=window.setTimeout(()=>{t.hidden=!0},e==="wrong"?9e3:2600)},Jl=(i,e,t,n)=>{let s=re("dialog",{class:"menu","aria-label":i}),r=l=>{s.isConnected&&(s.close(),s.remove(),n(l))};s.append(re("p",{class:"hint",text:i}),...t.map(l=>re("button",{type:"button",text:l,onclick:()=>r(l)}))),s.addEventListener("close",()=>r(null)),s.addEventListener("click",l=>{l.target===s&&r(null)}),document.body.append(s),s.showModal();let{width:o,height:a}=s.getBoundingClientRect();s.style.left=`${Math.max(4,Math.min(e.clientX,innerWidth-o-8))}px`,s.style.top=`${Math.max(4,Math.min(e.clientY,innerHeight-a-8))}px`,s.querySelector("button")?.focus()},Ms=(i,e=3)=>String(+i.toFixed(e)),ya=i=>{let e=!1;return()=>{e||(e=!0,requestAnimationFrame(()=>{e=!1,i()}))}},Wv=1e3,Xv=4,fo={field:"",at:-1/0,stroke:""},va=i=>{let e=performance.now();return(fo.field!==i||e-fo.at>Wv)&&(fo.stroke=String(Math.random())),fo={...fo,field:i,at:e},fo.stroke},Sd=i=>{let e=i.value.trim().replace(",",".");return e===""?NaN:Number(e)},Sr=(i,e,t,n,s=1,r=3)=>{let o=(a,l)=>{a.value=Ms(Sd(a)+l*s,r),delete a.dataset.typed,n(Sd(a),va(i))};return re("input",{type:"text",inputmode:"decimal",class:"number",value:Ms(e,r),"aria-label":`${i} [${t}]`,title:`${i} [${t}]; arrow keys or dragging change it`,oninput:({currentTarget:a})=>{a.dataset.typed=""},onchange:({currentTarget:a})=>{let l=a;l.dataset.typed!==void 0&&(delete l.dataset.typed,n(Sd(l)))},onkeydown:a=>{let l=a.currentTarget,{key:c,shiftKey:h}=a;c==="Enter"&&l.blur(),c==="Escape"&&(delete l.dataset.typed,l.value=Ms(e,r),l.blur(),a.stopPropagation()),!(c!=="ArrowUp"&&c!=="ArrowDown")&&(a.preventDefault(),o(l,(c==="ArrowUp"?1:-1)*(h?10:1)))},onpointerdown:a=>{let l=a.currentTarget,c=a.clientX;if(l===document.activeElement||a.button!==0)return;let h=0,d=!1,u=p=>{let v=Math.trunc((p.clientX-c)/Xv);v!==h&&(d=!0,o(l,(v-h)*(p.shiftKey?10:1)),h=v)},f=()=>{window.removeEventListener("pointermove",u),window.removeEventListener("pointerup",f),d&&l.blur()};window.addEventListener("pointermove",u),window.addEventListener("pointerup",f)}})};var sr={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},rr={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},e0=0,nf=1,t0=2;var sf=0,Dr=1,n0=2,Xo=3,cs=0,Gn=1,li=2,Nr=0,qo=1,rf=2,of=3,af=4,i0=5;var Ur=100,s0=101,r0=102,o0=103,a0=104,l0=200,c0=201,h0=202,u0=203,lf=204,cf=205,d0=206,f0=207,p0=208,m0=209,g0=210,x0=211,_0=212,y0=213,v0=214,Ic=0,Lc=1,Dc=2,Do=3,Nc=4,Uc=5,Oc=6,Fc=7,ch=0,b0=1,M0=2,hs=0,hf=1,uf=2,df=3,ff=4,pf=5,mf=6,il=7;var gf=300,Or=301,Yo=302,hh=303,uh=304,Rr=1e3,os=1001,kc=1002,kn=1003,S0=1004;var sl=1005;var si=1006,Zo=1007;var Ns=1008;var ci=1009,xf=1010,_f=1011,$o=1012,dh=1013,Xi=1014,qi=1015,Yi=1016,fh=1017,ph=1018,Fr=1020,yf=35902,vf=35899,bf=1021,Mf=1022,Zi=1023,Cs=1026,Us=1027,Sf=1028,mh=1029,or=1030,gh=1031;var xh=1033,rl=33776,ol=33777,al=33778,ll=33779,_h=35840,yh=35841,vh=35842,bh=35843,Mh=36196,Sh=37492,wh=37496,Eh=37488,Th=37489,cl=37490,Ah=37491,Rh=37808,Ch=37809,Ph=37810,Ih=37811,Lh=37812,Dh=37813,Nh=37814,Uh=37815,Oh=37816,Fh=37817,kh=37818,Bh=37819,zh=37820,Hh=37821,Gh=36492,Vh=36494,Wh=36495,Xh=36283,qh=36284,hl=36285,Yh=36286;var Ia=2300,Bc=2301,Cc=2302,Yd=2303,Zd=2400,$d=2401,Kd=2402;var w0=3200;var ul=0,E0=1,Os="",Mn="srgb",La="srgb-linear",Da="linear",It="srgb";var Pc=7680;var T0=519,A0=512,R0=513,C0=514,wf=515,P0=516,I0=517,Ef=518,Tf=519,Af=35044,Rf=35048;var Cf="300 es",Ai=2e3,No=2001;function qv(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function Yv(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function Na(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function L0(){let i=Na("canvas");return i.style.display="block",i}var yg={},Uo=null;function Ua(...i){let e="THREE."+i.shift();Uo?Uo("log",e,...i):console.log(e,...i)}function D0(i){let e=i[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=i[1];t&&t.isStackTrace?i[0]+=" "+t.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function Ke(...i){i=D0(i);let e="THREE."+i.shift();if(Uo)Uo("warn",e,...i);else{let t=i[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...i)}}function et(...i){i=D0(i);let e="THREE."+i.shift();if(Uo)Uo("error",e,...i);else{let t=i[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...i)}}function Ca(...i){let e=i.join(" ");e in yg||(yg[e]=!0,Ke(...i))}function N0(i,e,t){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:n()}}setTimeout(r,t)})}var U0={[Ic]:Ic,[Dc]:Oc,[Nc]:Nc,[Do]:Uc,[Lc]:Lc,[Oc]:Dc,[Fc]:Fc,[Uc]:Do},Wi=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let s=n[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},Xn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],vg=1234567,Io=Math.PI/180,Oo=180/Math.PI;function ar(){let i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(Xn[i&255]+Xn[i>>8&255]+Xn[i>>16&255]+Xn[i>>24&255]+"-"+Xn[e&255]+Xn[e>>8&255]+"-"+Xn[e>>16&15|64]+Xn[e>>24&255]+"-"+Xn[t&63|128]+Xn[t>>8&255]+"-"+Xn[t>>16&255]+Xn[t>>24&255]+Xn[n&255]+Xn[n>>8&255]+Xn[n>>16&255]+Xn[n>>24&255]).toLowerCase()}function xt(i,e,t){return Math.max(e,Math.min(t,i))}function Pf(i,e){return(i%e+e)%e}function Zv(i,e,t,n,s){return n+(i-e)*(s-n)/(t-e)}function $v(i,e,t){return i!==e?(t-i)/(e-i):0}function Pa(i,e,t){return(1-t)*i+t*e}function Kv(i,e,t,n){return Pa(i,e,1-Math.exp(-t*n))}function jv(i,e=1){return e-Math.abs(Pf(i,e*2)-e)}function Jv(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*(3-2*i))}function Qv(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*i*(i*(i*6-15)+10))}function eb(i,e){return i+Math.floor(Math.random()*(e-i+1))}function tb(i,e){return i+Math.random()*(e-i)}function nb(i){return i*(.5-Math.random())}function ib(i){i!==void 0&&(vg=i);let e=vg+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function sb(i){return i*Io}function rb(i){return i*Oo}function ob(i){return i>0&&Number.isInteger(i)&&2**Math.round(Math.log2(i))===i}function ab(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function If(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function lb(i,e,t,n,s){let r=Math.cos,o=Math.sin,a=r(t/2),l=o(t/2),c=r((e+n)/2),h=o((e+n)/2),d=r((e-n)/2),u=o((e-n)/2),f=r((n-e)/2),p=o((n-e)/2);switch(s){case"XYX":i.set(a*h,l*d,l*u,a*c);break;case"YZY":i.set(l*u,a*h,l*d,a*c);break;case"ZXZ":i.set(l*d,l*u,a*h,a*c);break;case"XZX":i.set(a*h,l*p,l*f,a*c);break;case"YXY":i.set(l*f,a*h,l*p,a*c);break;case"ZYZ":i.set(l*p,l*f,a*h,a*c);break;default:Ke("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Zh(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Lf(i,e){if(e.constructor===Float32Array)return i;let t=Zh(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/t,-1)}function Df(i,e){if(e.constructor===Float32Array)return i;let t=Zh(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*t)}var $h={DEG2RAD:Io,RAD2DEG:Oo,generateUUID:ar,clamp:xt,euclideanModulo:Pf,mapLinear:Zv,inverseLerp:$v,lerp:Pa,damp:Kv,pingpong:jv,smoothstep:Jv,smootherstep:Qv,randInt:eb,randFloat:tb,randFloatSpread:nb,seededRandom:ib,degToRad:sb,radToDeg:rb,isPowerOfTwo:ob,ceilPowerOfTwo:ab,floorPowerOfTwo:If,setQuaternionFromProperEuler:lb,normalize:Df,denormalize:Lf},We=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,s=e.elements;return this.x=s[0]*t+s[3]*n+s[6],this.y=s[1]*t+s[4]*n+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=xt(this.x,e.x,t.x),this.y=xt(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=xt(this.x,e,t),this.y=xt(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(xt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(xt(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*n-o*s+e.x,this.y=r*s+o*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},ht=class{constructor(e=0,t=0,n=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=s}static slerpFlat(e,t,n,s,r,o,a){let l=n[s+0],c=n[s+1],h=n[s+2],d=n[s+3],u=r[o+0],f=r[o+1],p=r[o+2],v=r[o+3];if(d!==v||l!==u||c!==f||h!==p){let g=l*u+c*f+h*p+d*v;g<0&&(u=-u,f=-f,p=-p,v=-v,g=-g);let m=1-a;if(g<.9995){let _=Math.acos(g),T=Math.sin(_);m=Math.sin(m*_)/T,a=Math.sin(a*_)/T,l=l*m+u*a,c=c*m+f*a,h=h*m+p*a,d=d*m+v*a}else{l=l*m+u*a,c=c*m+f*a,h=h*m+p*a,d=d*m+v*a;let _=1/Math.sqrt(l*l+c*c+h*h+d*d);l*=_,c*=_,h*=_,d*=_}}e[t]=l,e[t+1]=c,e[t+2]=h,e[t+3]=d}static multiplyQuaternionsFlat(e,t,n,s,r,o){let a=n[s],l=n[s+1],c=n[s+2],h=n[s+3],d=r[o],u=r[o+1],f=r[o+2],p=r[o+3];return e[t]=a*p+h*d+l*f-c*u,e[t+1]=l*p+h*u+c*d-a*f,e[t+2]=c*p+h*f+a*u-l*d,e[t+3]=h*p-a*d-l*u-c*f,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,s){return this._x=e,this._y=t,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(n/2),h=a(s/2),d=a(r/2),u=l(n/2),f=l(s/2),p=l(r/2);switch(o){case"XYZ":this._x=u*h*d+c*f*p,this._y=c*f*d-u*h*p,this._z=c*h*p+u*f*d,this._w=c*h*d-u*f*p;break;case"YXZ":this._x=u*h*d+c*f*p,this._y=c*f*d-u*h*p,this._z=c*h*p-u*f*d,this._w=c*h*d+u*f*p;break;case"ZXY":this._x=u*h*d-c*f*p,this._y=c*f*d+u*h*p,this._z=c*h*p+u*f*d,this._w=c*h*d-u*f*p;break;case"ZYX":this._x=u*h*d-c*f*p,this._y=c*f*d+u*h*p,this._z=c*h*p-u*f*d,this._w=c*h*d+u*f*p;break;case"YZX":this._x=u*h*d+c*f*p,this._y=c*f*d+u*h*p,this._z=c*h*p-u*f*d,this._w=c*h*d-u*f*p;break;case"XZY":this._x=u*h*d-c*f*p,this._y=c*f*d-u*h*p,this._z=c*h*p+u*f*d,this._w=c*h*d+u*f*p;break;default:Ke("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let n=t/2,s=Math.sin(n);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,n=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],h=t[6],d=t[10],u=n+a+d;if(u>0){let f=.5/Math.sqrt(u+1);this._w=.25/f,this._x=(h-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(n>a&&n>d){let f=2*Math.sqrt(1+n-a-d);this._w=(h-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>d){let f=2*Math.sqrt(1+a-n-d);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+h)/f}else{let f=2*Math.sqrt(1+d-n-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+h)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(xt(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let s=Math.min(1,t/n);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,h=t._w;return this._x=n*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-n*c,this._z=r*h+o*c+n*l-s*a,this._w=o*h-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(n=-n,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),h=Math.sin(c);l=Math.sin(l*c)/h,t=Math.sin(t*c)/h,this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},U=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,n=0){this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(bg.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(bg.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6]*s,this.y=r[1]*t+r[4]*n+r[7]*s,this.z=r[2]*t+r[5]*n+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,n=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*n),h=2*(a*t-r*s),d=2*(r*n-o*t);return this.x=t+l*c+o*d-a*h,this.y=n+l*h+a*c-r*d,this.z=s+l*d+r*h-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*n+r[8]*s,this.y=r[1]*t+r[5]*n+r[9]*s,this.z=r[2]*t+r[6]*n+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=xt(this.x,e.x,t.x),this.y=xt(this.y,e.y,t.y),this.z=xt(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=xt(this.x,e,t),this.y=xt(this.y,e,t),this.z=xt(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(xt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return wd.copy(this).projectOnVector(e),this.sub(wd)}reflect(e){return this.sub(wd.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(xt(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y,s=this.z-e.z;return t*t+n*n+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let s=Math.sin(t)*e;return this.x=s*Math.sin(n),this.y=Math.cos(t)*e,this.z=s*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},wd=new U,bg=new ht,st=class{static{this.prototype.isMatrix3=!0}constructor(e,t,n,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c)}set(e,t,n,s,r,o,a,l,c){let h=this.elements;return h[0]=e,h[1]=s,h[2]=a,h[3]=t,h[4]=r,h[5]=l,h[6]=n,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],h=n[4],d=n[7],u=n[2],f=n[5],p=n[8],v=s[0],g=s[3],m=s[6],_=s[1],T=s[4],M=s[7],C=s[2],S=s[5],x=s[8];return r[0]=o*v+a*_+l*C,r[3]=o*g+a*T+l*S,r[6]=o*m+a*M+l*x,r[1]=c*v+h*_+d*C,r[4]=c*g+h*T+d*S,r[7]=c*m+h*M+d*x,r[2]=u*v+f*_+p*C,r[5]=u*g+f*T+p*S,r[8]=u*m+f*M+p*x,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8];return t*o*h-t*a*c-n*r*h+n*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],d=h*o-a*c,u=a*l-h*r,f=c*r-o*l,p=t*d+n*u+s*f;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let v=1/p;return e[0]=d*v,e[1]=(s*c-h*n)*v,e[2]=(a*n-s*o)*v,e[3]=u*v,e[4]=(h*t-s*l)*v,e[5]=(s*r-a*t)*v,e[6]=f*v,e[7]=(n*l-c*t)*v,e[8]=(o*t-n*r)*v,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return Ca("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Ed.makeScale(e,t)),this}rotate(e){return Ca("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Ed.makeRotation(-e)),this}translate(e,t){return Ca("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Ed.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<9;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}},Ed=new st,Mg=new st().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Sg=new st().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function cb(){let i={enabled:!0,workingColorSpace:La,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===It&&(s.r=Rs(s.r),s.g=Rs(s.g),s.b=Rs(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===It&&(s.r=Lo(s.r),s.g=Lo(s.g),s.b=Lo(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Os?Da:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[La]:{primaries:e,whitePoint:n,transfer:Da,toXYZ:Mg,fromXYZ:Sg,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:Mn},outputColorSpaceConfig:{drawingBufferColorSpace:Mn}},[Mn]:{primaries:e,whitePoint:n,transfer:It,toXYZ:Mg,fromXYZ:Sg,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:Mn}}}),i}var Mt=cb();function Rs(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function Lo(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var po,zc=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{po===void 0&&(po=Na("canvas")),po.width=e.width,po.height=e.height;let s=po.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),n=po}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=Na("canvas");t.width=e.width,t.height=e.height;let n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);let s=n.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Rs(r[o]/255)*255;return n.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(Rs(t[n]/255)*255):t[n]=Rs(t[n]);return{data:t,width:e.width,height:e.height}}else return Ke("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},hb=0,Fo=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:hb++}),this.uuid=ar(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Td(s[o].image)):r.push(Td(s[o]))}else r=Td(s);n.url=r}return t||(e.images[this.uuid]=n),n}};function Td(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?zc.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(Ke("Texture: Unable to serialize Texture."),{})}var ub=0,Ad=new U,Hn=class i extends Wi{constructor(e=i.DEFAULT_IMAGE,t=i.DEFAULT_MAPPING,n=os,s=os,r=si,o=Ns,a=Zi,l=ci,c=i.DEFAULT_ANISOTROPY,h=Os){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:ub++}),this.uuid=ar(),this.name="",this.source=new Fo(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new We(0,0),this.repeat=new We(1,1),this.center=new We(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new st,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Ad).x}get height(){return this.source.getSize(Ad).y}get depth(){return this.source.getSize(Ad).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===void 0){Ke(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ke(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==gf)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case Rr:e.x=e.x-Math.floor(e.x);break;case os:e.x=e.x<0?0:1;break;case kc:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case Rr:e.y=e.y-Math.floor(e.y);break;case os:e.y=e.y<0?0:1;break;case kc:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};Hn.DEFAULT_IMAGE=null;Hn.DEFAULT_MAPPING=gf;Hn.DEFAULT_ANISOTROPY=1;var tn=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,n=0,s=1){this.x=e,this.y=t,this.z=n,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,s){return this.x=e,this.y=t,this.z=n,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*n+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,s,r,l=e.elements,c=l[0],h=l[4],d=l[8],u=l[1],f=l[5],p=l[9],v=l[2],g=l[6],m=l[10];if(Math.abs(h-u)<.01&&Math.abs(d-v)<.01&&Math.abs(p-g)<.01){if(Math.abs(h+u)<.1&&Math.abs(d+v)<.1&&Math.abs(p+g)<.1&&Math.abs(c+f+m-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let T=(c+1)/2,M=(f+1)/2,C=(m+1)/2,S=(h+u)/4,x=(d+v)/4,E=(p+g)/4;return T>M&&T>C?T<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(T),s=S/n,r=x/n):M>C?M<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(M),n=S/s,r=E/s):C<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(C),n=x/r,s=E/r),this.set(n,s,r,t),this}let _=Math.sqrt((g-p)*(g-p)+(d-v)*(d-v)+(u-h)*(u-h));return Math.abs(_)<.001&&(_=1),this.x=(g-p)/_,this.y=(d-v)/_,this.z=(u-h)/_,this.w=Math.acos((c+f+m-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=xt(this.x,e.x,t.x),this.y=xt(this.y,e.y,t.y),this.z=xt(this.z,e.z,t.z),this.w=xt(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=xt(this.x,e,t),this.y=xt(this.y,e,t),this.z=xt(this.z,e,t),this.w=xt(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(xt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Hc=class extends Wi{constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:si,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new tn(0,0,e,t),this.scissorTest=!1,this.viewport=new tn(0,0,e,t),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new Hn({width:e,height:t,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:si,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new Fo(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},vi=class extends Hc{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}},Oa=class extends Hn{constructor(e=null,t=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=kn,this.minFilter=kn,this.wrapR=os,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var Gc=class extends Hn{constructor(e=null,t=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=kn,this.minFilter=kn,this.wrapR=os,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var yt=class i{static{this.prototype.isMatrix4=!0}constructor(e,t,n,s,r,o,a,l,c,h,d,u,f,p,v,g){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c,h,d,u,f,p,v,g)}set(e,t,n,s,r,o,a,l,c,h,d,u,f,p,v,g){let m=this.elements;return m[0]=e,m[4]=t,m[8]=n,m[12]=s,m[1]=r,m[5]=o,m[9]=a,m[13]=l,m[2]=c,m[6]=h,m[10]=d,m[14]=u,m[3]=f,m[7]=p,m[11]=v,m[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),n.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,n=e.elements,s=1/mo.setFromMatrixColumn(e,0).length(),r=1/mo.setFromMatrixColumn(e,1).length(),o=1/mo.setFromMatrixColumn(e,2).length();return t[0]=n[0]*s,t[1]=n[1]*s,t[2]=n[2]*s,t[3]=0,t[4]=n[4]*r,t[5]=n[5]*r,t[6]=n[6]*r,t[7]=0,t[8]=n[8]*o,t[9]=n[9]*o,t[10]=n[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,n=e.x,s=e.y,r=e.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),d=Math.sin(r);if(e.order==="XYZ"){let u=o*h,f=o*d,p=a*h,v=a*d;t[0]=l*h,t[4]=-l*d,t[8]=c,t[1]=f+p*c,t[5]=u-v*c,t[9]=-a*l,t[2]=v-u*c,t[6]=p+f*c,t[10]=o*l}else if(e.order==="YXZ"){let u=l*h,f=l*d,p=c*h,v=c*d;t[0]=u+v*a,t[4]=p*a-f,t[8]=o*c,t[1]=o*d,t[5]=o*h,t[9]=-a,t[2]=f*a-p,t[6]=v+u*a,t[10]=o*l}else if(e.order==="ZXY"){let u=l*h,f=l*d,p=c*h,v=c*d;t[0]=u-v*a,t[4]=-o*d,t[8]=p+f*a,t[1]=f+p*a,t[5]=o*h,t[9]=v-u*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let u=o*h,f=o*d,p=a*h,v=a*d;t[0]=l*h,t[4]=p*c-f,t[8]=u*c+v,t[1]=l*d,t[5]=v*c+u,t[9]=f*c-p,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let u=o*l,f=o*c,p=a*l,v=a*c;t[0]=l*h,t[4]=v-u*d,t[8]=p*d+f,t[1]=d,t[5]=o*h,t[9]=-a*h,t[2]=-c*h,t[6]=f*d+p,t[10]=u-v*d}else if(e.order==="XZY"){let u=o*l,f=o*c,p=a*l,v=a*c;t[0]=l*h,t[4]=-d,t[8]=c*h,t[1]=u*d+v,t[5]=o*h,t[9]=f*d-p,t[2]=p*d-f,t[6]=a*h,t[10]=v*d+u}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(db,e,fb)}lookAt(e,t,n){let s=this.elements;return _i.subVectors(e,t),_i.lengthSq()===0&&(_i.z=1),_i.normalize(),Ys.crossVectors(n,_i),Ys.lengthSq()===0&&(Math.abs(n.z)===1?_i.x+=1e-4:_i.z+=1e-4,_i.normalize(),Ys.crossVectors(n,_i)),Ys.normalize(),Ql.crossVectors(_i,Ys),s[0]=Ys.x,s[4]=Ql.x,s[8]=_i.x,s[1]=Ys.y,s[5]=Ql.y,s[9]=_i.y,s[2]=Ys.z,s[6]=Ql.z,s[10]=_i.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],h=n[1],d=n[5],u=n[9],f=n[13],p=n[2],v=n[6],g=n[10],m=n[14],_=n[3],T=n[7],M=n[11],C=n[15],S=s[0],x=s[4],E=s[8],O=s[12],P=s[1],D=s[5],z=s[9],W=s[13],N=s[2],V=s[6],Z=s[10],G=s[14],ce=s[3],Y=s[7],Q=s[11],ie=s[15];return r[0]=o*S+a*P+l*N+c*ce,r[4]=o*x+a*D+l*V+c*Y,r[8]=o*E+a*z+l*Z+c*Q,r[12]=o*O+a*W+l*G+c*ie,r[1]=h*S+d*P+u*N+f*ce,r[5]=h*x+d*D+u*V+f*Y,r[9]=h*E+d*z+u*Z+f*Q,r[13]=h*O+d*W+u*G+f*ie,r[2]=p*S+v*P+g*N+m*ce,r[6]=p*x+v*D+g*V+m*Y,r[10]=p*E+v*z+g*Z+m*Q,r[14]=p*O+v*W+g*G+m*ie,r[3]=_*S+T*P+M*N+C*ce,r[7]=_*x+T*D+M*V+C*Y,r[11]=_*E+T*z+M*Z+C*Q,r[15]=_*O+T*W+M*G+C*ie,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],h=e[2],d=e[6],u=e[10],f=e[14],p=e[3],v=e[7],g=e[11],m=e[15],_=l*f-c*u,T=a*f-c*d,M=a*u-l*d,C=o*f-c*h,S=o*u-l*h,x=o*d-a*h;return t*(v*_-g*T+m*M)-n*(p*_-g*C+m*S)+s*(p*T-v*C+m*x)-r*(p*M-v*S+g*x)}determinantAffine(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],h=e[10];return t*(o*h-a*c)-n*(r*h-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],d=e[9],u=e[10],f=e[11],p=e[12],v=e[13],g=e[14],m=e[15],_=t*a-n*o,T=t*l-s*o,M=t*c-r*o,C=n*l-s*a,S=n*c-r*a,x=s*c-r*l,E=h*v-d*p,O=h*g-u*p,P=h*m-f*p,D=d*g-u*v,z=d*m-f*v,W=u*m-f*g,N=_*W-T*z+M*D+C*P-S*O+x*E;if(N===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let V=1/N;return e[0]=(a*W-l*z+c*D)*V,e[1]=(s*z-n*W-r*D)*V,e[2]=(v*x-g*S+m*C)*V,e[3]=(u*S-d*x-f*C)*V,e[4]=(l*P-o*W-c*O)*V,e[5]=(t*W-s*P+r*O)*V,e[6]=(g*M-p*x-m*T)*V,e[7]=(h*x-u*M+f*T)*V,e[8]=(o*z-a*P+c*E)*V,e[9]=(n*P-t*z-r*E)*V,e[10]=(p*S-v*M+m*_)*V,e[11]=(d*M-h*S-f*_)*V,e[12]=(a*O-o*D-l*E)*V,e[13]=(t*D-n*O+s*E)*V,e[14]=(v*T-p*C-g*_)*V,e[15]=(h*C-d*T+u*_)*V,this}scale(e){let t=this.elements,n=e.x,s=e.y,r=e.z;return t[0]*=n,t[4]*=s,t[8]*=r,t[1]*=n,t[5]*=s,t[9]*=r,t[2]*=n,t[6]*=s,t[10]*=r,t[3]*=n,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,s))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),s=Math.sin(t),r=1-n,o=e.x,a=e.y,l=e.z,c=r*o,h=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+n,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,s,r,o){return this.set(1,n,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,n){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,h=o+o,d=a+a,u=r*c,f=r*h,p=r*d,v=o*h,g=o*d,m=a*d,_=l*c,T=l*h,M=l*d,C=n.x,S=n.y,x=n.z;return s[0]=(1-(v+m))*C,s[1]=(f+M)*C,s[2]=(p-T)*C,s[3]=0,s[4]=(f-M)*S,s[5]=(1-(u+m))*S,s[6]=(g+_)*S,s[7]=0,s[8]=(p+T)*x,s[9]=(g-_)*x,s[10]=(1-(u+v))*x,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,n){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),t.identity(),this;let o=mo.set(s[0],s[1],s[2]).length(),a=mo.set(s[4],s[5],s[6]).length(),l=mo.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Hi.copy(this);let c=1/o,h=1/a,d=1/l;return Hi.elements[0]*=c,Hi.elements[1]*=c,Hi.elements[2]*=c,Hi.elements[4]*=h,Hi.elements[5]*=h,Hi.elements[6]*=h,Hi.elements[8]*=d,Hi.elements[9]*=d,Hi.elements[10]*=d,t.setFromRotationMatrix(Hi),n.x=o,n.y=a,n.z=l,this}makePerspective(e,t,n,s,r,o,a=Ai,l=!1){let c=this.elements,h=2*r/(t-e),d=2*r/(n-s),u=(t+e)/(t-e),f=(n+s)/(n-s),p,v;if(l)p=r/(o-r),v=o*r/(o-r);else if(a===Ai)p=-(o+r)/(o-r),v=-2*o*r/(o-r);else if(a===No)p=-o/(o-r),v=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=u,c[12]=0,c[1]=0,c[5]=d,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=p,c[14]=v,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,n,s,r,o,a=Ai,l=!1){let c=this.elements,h=2/(t-e),d=2/(n-s),u=-(t+e)/(t-e),f=-(n+s)/(n-s),p,v;if(l)p=1/(o-r),v=o/(o-r);else if(a===Ai)p=-2/(o-r),v=-(o+r)/(o-r);else if(a===No)p=-1/(o-r),v=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=u,c[1]=0,c[5]=d,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=p,c[14]=v,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<16;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}},mo=new U,Hi=new yt,db=new U(0,0,0),fb=new U(1,1,1),Ys=new U,Ql=new U,_i=new U,wg=new yt,Eg=new ht,Ri=class i{constructor(e=0,t=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,s=this._order){return this._x=e,this._y=t,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],d=s[2],u=s[6],f=s[10];switch(t){case"XYZ":this._y=Math.asin(xt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(u,c),this._z=0);break;case"YXZ":this._x=Math.asin(-xt(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-d,r),this._z=0);break;case"ZXY":this._x=Math.asin(xt(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(-d,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-xt(d,-1,1)),Math.abs(d)<.9999999?(this._x=Math.atan2(u,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(xt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-d,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-xt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(u,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,f),this._y=0);break;default:Ke("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return wg.makeRotationFromQuaternion(e),this.setFromRotationMatrix(wg,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return Eg.setFromEuler(this),this.setFromQuaternion(Eg,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Ri.DEFAULT_ORDER="XYZ";var ko=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},pb=0,Tg=new U,go=new ht,Ss=new yt,ec=new U,ba=new U,mb=new U,gb=new ht,Ag=new U(1,0,0),Rg=new U(0,1,0),Cg=new U(0,0,1),Pg={type:"added"},xb={type:"removed"},xo={type:"childadded",child:null},Rd={type:"childremoved",child:null},Jt=class i extends Wi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:pb++}),this.uuid=ar(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let e=new U,t=new Ri,n=new ht,s=new U(1,1,1);function r(){n.setFromEuler(t,!1)}function o(){t.setFromQuaternion(n,void 0,!1)}t._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new yt},normalMatrix:{value:new st}}),this.matrix=new yt,this.matrixWorld=new yt,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new ko,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return go.setFromAxisAngle(e,t),this.quaternion.multiply(go),this}rotateOnWorldAxis(e,t){return go.setFromAxisAngle(e,t),this.quaternion.premultiply(go),this}rotateX(e){return this.rotateOnAxis(Ag,e)}rotateY(e){return this.rotateOnAxis(Rg,e)}rotateZ(e){return this.rotateOnAxis(Cg,e)}translateOnAxis(e,t){return Tg.copy(e).applyQuaternion(this.quaternion),this.position.add(Tg.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(Ag,e)}translateY(e){return this.translateOnAxis(Rg,e)}translateZ(e){return this.translateOnAxis(Cg,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(Ss.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?ec.copy(e):ec.set(e,t,n);let s=this.parent;this.updateWorldMatrix(!0,!1),ba.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Ss.lookAt(ba,ec,this.up):Ss.lookAt(ec,ba,this.up),this.quaternion.setFromRotationMatrix(Ss),s&&(Ss.extractRotation(s.matrixWorld),go.setFromRotationMatrix(Ss),this.quaternion.premultiply(go.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(et("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(Pg),xo.child=e,this.dispatchEvent(xo),xo.child=null):et("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(xb),Rd.child=e,this.dispatchEvent(Rd),Rd.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),Ss.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),Ss.multiply(e.parent.matrixWorld)),e.applyMatrix4(Ss),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(Pg),xo.child=e,this.dispatchEvent(xo),xo.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ba,e,mb),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ba,gb,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,n=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*n-r[8]*s,r[13]+=n-r[1]*t-r[5]*n-r[9]*s,r[14]+=s-r[2]*t-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t,n=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,n)}}toJSON(e){let t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let d=l[c];r(e.shapes,d)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),h=o(e.images),d=o(e.shapes),u=o(e.skeletons),f=o(e.animations),p=o(e.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),h.length>0&&(n.images=h),d.length>0&&(n.shapes=d),u.length>0&&(n.skeletons=u),f.length>0&&(n.animations=f),p.length>0&&(n.nodes=p)}return n.object=s,n;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){let s=e.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Jt.DEFAULT_UP=new U(0,1,0);Jt.DEFAULT_MATRIX_AUTO_UPDATE=!0;Jt.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Yn=class extends Jt{constructor(){super(),this.isGroup=!0,this.type="Group"}},_b={type:"move"},Bo=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Yn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Yn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new U,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new U),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Yn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new U,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new U,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let v of e.hand.values()){let g=t.getJointPose(v,n),m=this._getHandJoint(c,v);g!==null&&(m.matrix.fromArray(g.transform.matrix),m.matrix.decompose(m.position,m.quaternion,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=g.radius),m.visible=g!==null}let h=c.joints["index-finger-tip"],d=c.joints["thumb-tip"],u=h.position.distanceTo(d.position),f=.02,p=.005;c.inputState.pinching&&u>f+p?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&u<=f-p&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(_b)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let n=new Yn;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}},O0={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Zs={h:0,s:0,l:0},tc={h:0,s:0,l:0};function Cd(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}var Je=class{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=Mn){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,Mt.colorSpaceToWorking(this,t),this}setRGB(e,t,n,s=Mt.workingColorSpace){return this.r=e,this.g=t,this.b=n,Mt.colorSpaceToWorking(this,s),this}setHSL(e,t,n,s=Mt.workingColorSpace){if(e=Pf(e,1),t=xt(t,0,1),n=xt(n,0,1),t===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+t):n+t-n*t,o=2*n-r;this.r=Cd(o,r,e+1/3),this.g=Cd(o,r,e),this.b=Cd(o,r,e-1/3)}return Mt.colorSpaceToWorking(this,s),this}setStyle(e,t=Mn){function n(r){r!==void 0&&parseFloat(r)<1&&Ke("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:Ke("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);Ke("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=Mn){let n=O0[e.toLowerCase()];return n!==void 0?this.setHex(n,t):Ke("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Rs(e.r),this.g=Rs(e.g),this.b=Rs(e.b),this}copyLinearToSRGB(e){return this.r=Lo(e.r),this.g=Lo(e.g),this.b=Lo(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=Mn){return Mt.workingToColorSpace(qn.copy(this),e),Math.round(xt(qn.r*255,0,255))*65536+Math.round(xt(qn.g*255,0,255))*256+Math.round(xt(qn.b*255,0,255))}getHexString(e=Mn){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=Mt.workingColorSpace){Mt.workingToColorSpace(qn.copy(this),t);let n=qn.r,s=qn.g,r=qn.b,o=Math.max(n,s,r),a=Math.min(n,s,r),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let d=o-a;switch(c=h<=.5?d/(o+a):d/(2-o-a),o){case n:l=(s-r)/d+(s<r?6:0);break;case s:l=(r-n)/d+2;break;case r:l=(n-s)/d+4;break}l/=6}return e.h=l,e.s=c,e.l=h,e}getRGB(e,t=Mt.workingColorSpace){return Mt.workingToColorSpace(qn.copy(this),t),e.r=qn.r,e.g=qn.g,e.b=qn.b,e}getStyle(e=Mn){Mt.workingToColorSpace(qn.copy(this),e);let t=qn.r,n=qn.g,s=qn.b;return e!==Mn?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(e,t,n){return this.getHSL(Zs),this.setHSL(Zs.h+e,Zs.s+t,Zs.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(Zs),e.getHSL(tc);let n=Pa(Zs.h,tc.h,t),s=Pa(Zs.s,tc.s,t),r=Pa(Zs.l,tc.l,t);return this.setHSL(n,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,n=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*n+r[6]*s,this.g=r[1]*t+r[4]*n+r[7]*s,this.b=r[2]*t+r[5]*n+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},qn=new Je;Je.NAMES=O0;var Fa=class i{constructor(e,t=1,n=1e3){this.isFog=!0,this.name="",this.color=new Je(e),this.near=t,this.far=n}clone(){return new i(this.color,this.near,this.far)}toJSON(){return{type:"Fog",name:this.name,color:this.color.getHex(),near:this.near,far:this.far}}},ka=class extends Jt{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Ri,this.environmentIntensity=1,this.environmentRotation=new Ri,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},Gi=new U,ws=new U,Pd=new U,Es=new U,_o=new U,yo=new U,Ig=new U,Id=new U,Ld=new U,Dd=new U,Nd=new tn,Ud=new tn,Od=new tn,rs=class i{constructor(e=new U,t=new U,n=new U){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,s){s.subVectors(n,t),Gi.subVectors(e,t),s.cross(Gi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,n,s,r){Gi.subVectors(s,t),ws.subVectors(n,t),Pd.subVectors(e,t);let o=Gi.dot(Gi),a=Gi.dot(ws),l=Gi.dot(Pd),c=ws.dot(ws),h=ws.dot(Pd),d=o*c-a*a;if(d===0)return r.set(0,0,0),null;let u=1/d,f=(c*l-a*h)*u,p=(o*h-a*l)*u;return r.set(1-f-p,p,f)}static containsPoint(e,t,n,s){return this.getBarycoord(e,t,n,s,Es)===null?!1:Es.x>=0&&Es.y>=0&&Es.x+Es.y<=1}static getInterpolation(e,t,n,s,r,o,a,l){return this.getBarycoord(e,t,n,s,Es)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Es.x),l.addScaledVector(o,Es.y),l.addScaledVector(a,Es.z),l)}static getInterpolatedAttribute(e,t,n,s,r,o){return Nd.setScalar(0),Ud.setScalar(0),Od.setScalar(0),Nd.fromBufferAttribute(e,t),Ud.fromBufferAttribute(e,n),Od.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(Nd,r.x),o.addScaledVector(Ud,r.y),o.addScaledVector(Od,r.z),o}static isFrontFacing(e,t,n,s){return Gi.subVectors(n,t),ws.subVectors(e,t),Gi.cross(ws).dot(s)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,s){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,n,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Gi.subVectors(this.c,this.b),ws.subVectors(this.a,this.b),Gi.cross(ws).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return i.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return i.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,s,r){return i.getInterpolation(e,this.a,this.b,this.c,t,n,s,r)}containsPoint(e){return i.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return i.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,s=this.b,r=this.c,o,a;_o.subVectors(s,n),yo.subVectors(r,n),Id.subVectors(e,n);let l=_o.dot(Id),c=yo.dot(Id);if(l<=0&&c<=0)return t.copy(n);Ld.subVectors(e,s);let h=_o.dot(Ld),d=yo.dot(Ld);if(h>=0&&d<=h)return t.copy(s);let u=l*d-h*c;if(u<=0&&l>=0&&h<=0&&l-h>0)return o=l/(l-h),t.copy(n).addScaledVector(_o,o);Dd.subVectors(e,r);let f=_o.dot(Dd),p=yo.dot(Dd);if(p>=0&&f<=p)return t.copy(r);let v=f*c-l*p;if(v<=0&&c>=0&&p<=0)return a=c/(c-p),t.copy(n).addScaledVector(yo,a);let g=h*p-f*d;if(g<=0&&d-h>=0&&f-p>=0)return Ig.subVectors(r,s),a=(d-h)/(d-h+(f-p)),t.copy(s).addScaledVector(Ig,a);let m=1/(g+v+u);return o=v*m,a=u*m,t.copy(n).addScaledVector(_o,o).addScaledVector(yo,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},Ci=class{constructor(e=new U(1/0,1/0,1/0),t=new U(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(Vi.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(Vi.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=Vi.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let r=n.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Vi):Vi.fromBufferAttribute(r,o),Vi.applyMatrix4(e.matrixWorld),this.expandByPoint(Vi);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),nc.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),nc.copy(n.boundingBox)),nc.applyMatrix4(e.matrixWorld),this.union(nc)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Vi),Vi.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Ma),ic.subVectors(this.max,Ma),vo.subVectors(e.a,Ma),bo.subVectors(e.b,Ma),Mo.subVectors(e.c,Ma),$s.subVectors(bo,vo),Ks.subVectors(Mo,bo),wr.subVectors(vo,Mo);let t=[0,-$s.z,$s.y,0,-Ks.z,Ks.y,0,-wr.z,wr.y,$s.z,0,-$s.x,Ks.z,0,-Ks.x,wr.z,0,-wr.x,-$s.y,$s.x,0,-Ks.y,Ks.x,0,-wr.y,wr.x,0];return!Fd(t,vo,bo,Mo,ic)||(t=[1,0,0,0,1,0,0,0,1],!Fd(t,vo,bo,Mo,ic))?!1:(sc.crossVectors($s,Ks),t=[sc.x,sc.y,sc.z],Fd(t,vo,bo,Mo,ic))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Vi).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Vi).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(Ts[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),Ts[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),Ts[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),Ts[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),Ts[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),Ts[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),Ts[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),Ts[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(Ts),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},Ts=[new U,new U,new U,new U,new U,new U,new U,new U],Vi=new U,nc=new Ci,vo=new U,bo=new U,Mo=new U,$s=new U,Ks=new U,wr=new U,Ma=new U,ic=new U,sc=new U,Er=new U;function Fd(i,e,t,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){Er.fromArray(i,r);let a=s.x*Math.abs(Er.x)+s.y*Math.abs(Er.y)+s.z*Math.abs(Er.z),l=e.dot(Er),c=t.dot(Er),h=n.dot(Er);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var bn=new U,rc=new We,yb=0,jt=class extends Wi{constructor(e,t,n=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:yb++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=Af,this.updateRanges=[],this.gpuType=qi,this.version=0,this._normalizationScale=e!==void 0?Zh(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[n+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)rc.fromBufferAttribute(this,t),rc.applyMatrix3(e),this.setXY(t,rc.x,rc.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)bn.fromBufferAttribute(this,t),bn.applyMatrix3(e),this.setXYZ(t,bn.x,bn.y,bn.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)bn.fromBufferAttribute(this,t),bn.applyMatrix4(e),this.setXYZ(t,bn.x,bn.y,bn.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)bn.fromBufferAttribute(this,t),bn.applyNormalMatrix(e),this.setXYZ(t,bn.x,bn.y,bn.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)bn.fromBufferAttribute(this,t),bn.transformDirection(e),this.setXYZ(t,bn.x,bn.y,bn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Lf(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Df(e,this.array)}};var Ba=class extends jt{constructor(e,t,n){super(new Uint16Array(e),t,n)}};var za=class extends jt{constructor(e,t,n){super(new Uint32Array(e),t,n)}};var wt=class extends jt{constructor(e,t,n){super(new Float32Array(e),t,n)}},vb=new Ci,Sa=new U,kd=new U,Js=class{constructor(e=new U,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t!==void 0?n.copy(t):vb.setFromPoints(e).getCenter(n);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,n.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;Sa.subVectors(e,this.center);let t=Sa.lengthSq();if(t>this.radius*this.radius){let n=Math.sqrt(t),s=(n-this.radius)*.5;this.center.addScaledVector(Sa,s/n),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(kd.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Sa.copy(e.center).add(kd)),this.expandByPoint(Sa.copy(e.center).sub(kd))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},bb=0,Ti=new yt,Bd=new Jt,So=new U,yi=new Ci,wa=new Ci,Fn=new U,Lt=class i extends Wi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:bb++}),this.uuid=ar(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(qv(e)?za:Ba)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new st().getNormalMatrix(e);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Ti.makeRotationFromQuaternion(e),this.applyMatrix4(Ti),this}rotateX(e){return Ti.makeRotationX(e),this.applyMatrix4(Ti),this}rotateY(e){return Ti.makeRotationY(e),this.applyMatrix4(Ti),this}rotateZ(e){return Ti.makeRotationZ(e),this.applyMatrix4(Ti),this}translate(e,t,n){return Ti.makeTranslation(e,t,n),this.applyMatrix4(Ti),this}scale(e,t,n){return Ti.makeScale(e,t,n),this.applyMatrix4(Ti),this}lookAt(e){return Bd.lookAt(e),Bd.updateMatrix(),this.applyMatrix4(Bd.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(So).negate(),this.translate(So.x,So.y,So.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let n=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new wt(n,3))}else{let n=Math.min(e.length,t.count);for(let s=0;s<n;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&Ke("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Ci);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){et("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new U(-1/0,-1/0,-1/0),new U(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,s=t.length;n<s;n++){let r=t[n];yi.setFromBufferAttribute(r),this.morphTargetsRelative?(Fn.addVectors(this.boundingBox.min,yi.min),this.boundingBox.expandByPoint(Fn),Fn.addVectors(this.boundingBox.max,yi.max),this.boundingBox.expandByPoint(Fn)):(this.boundingBox.expandByPoint(yi.min),this.boundingBox.expandByPoint(yi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&et('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Js);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){et("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new U,1/0);return}if(e){let n=this.boundingSphere.center;if(yi.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];wa.setFromBufferAttribute(a),this.morphTargetsRelative?(Fn.addVectors(yi.min,wa.min),yi.expandByPoint(Fn),Fn.addVectors(yi.max,wa.max),yi.expandByPoint(Fn)):(yi.expandByPoint(wa.min),yi.expandByPoint(wa.max))}yi.getCenter(n);let s=0;for(let r=0,o=e.count;r<o;r++)Fn.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(Fn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)Fn.fromBufferAttribute(a,c),l&&(So.fromBufferAttribute(e,c),Fn.add(So)),s=Math.max(s,n.distanceToSquared(Fn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&et('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){et("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new jt(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(n.count);for(let O=0;O<n.count;O++)a[O]=new U,l[O]=new U;let h=new U,d=new U,u=new U,f=new We,p=new We,v=new We,g=new U,m=new U;function _(O,P,D){c[O]=c[P]=c[D]=1,h.fromBufferAttribute(n,O),d.fromBufferAttribute(n,P),u.fromBufferAttribute(n,D),f.fromBufferAttribute(r,O),p.fromBufferAttribute(r,P),v.fromBufferAttribute(r,D),d.sub(h),u.sub(h),p.sub(f),v.sub(f);let z=1/(p.x*v.y-v.x*p.y);isFinite(z)&&(g.copy(d).multiplyScalar(v.y).addScaledVector(u,-p.y).multiplyScalar(z),m.copy(u).multiplyScalar(p.x).addScaledVector(d,-v.x).multiplyScalar(z),a[O].add(g),a[P].add(g),a[D].add(g),l[O].add(m),l[P].add(m),l[D].add(m))}let T=this.groups;T.length===0&&(T=[{start:0,count:e.count}]);for(let O=0,P=T.length;O<P;++O){let D=T[O],z=D.start,W=D.count;for(let N=z,V=z+W;N<V;N+=3)_(e.getX(N+0),e.getX(N+1),e.getX(N+2))}let M=new U,C=new U,S=new U,x=new U;function E(O){S.fromBufferAttribute(s,O),x.copy(S);let P=a[O];M.copy(P),M.sub(S.multiplyScalar(S.dot(P))).normalize(),C.crossVectors(x,P);let z=C.dot(l[O])<0?-1:1;o.setXYZW(O,M.x,M.y,M.z,z)}for(let O=0,P=n.count;O<P;++O)c[O]&&E(O);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==t.count)n=new jt(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let u=0,f=n.count;u<f;u++)n.setXYZ(u,0,0,0);let s=new U,r=new U,o=new U,a=new U,l=new U,c=new U,h=new U,d=new U;if(e)for(let u=0,f=e.count;u<f;u+=3){let p=e.getX(u+0),v=e.getX(u+1),g=e.getX(u+2);s.fromBufferAttribute(t,p),r.fromBufferAttribute(t,v),o.fromBufferAttribute(t,g),h.subVectors(o,r),d.subVectors(s,r),h.cross(d),a.fromBufferAttribute(n,p),l.fromBufferAttribute(n,v),c.fromBufferAttribute(n,g),a.add(h),l.add(h),c.add(h),n.setXYZ(p,a.x,a.y,a.z),n.setXYZ(v,l.x,l.y,l.z),n.setXYZ(g,c.x,c.y,c.z)}else for(let u=0,f=t.count;u<f;u+=3)s.fromBufferAttribute(t,u+0),r.fromBufferAttribute(t,u+1),o.fromBufferAttribute(t,u+2),h.subVectors(o,r),d.subVectors(s,r),h.cross(d),n.setXYZ(u+0,h.x,h.y,h.z),n.setXYZ(u+1,h.x,h.y,h.z),n.setXYZ(u+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)Fn.fromBufferAttribute(e,t),Fn.normalize(),e.setXYZ(t,Fn.x,Fn.y,Fn.z)}toNonIndexed(){function e(a,l){let c=a.array,h=a.itemSize,d=a.normalized,u=new c.constructor(l.length*h),f=0,p=0;for(let v=0,g=l.length;v<g;v++){a.isInterleavedBufferAttribute?f=l[v]*a.data.stride+a.offset:f=l[v]*h;for(let m=0;m<h;m++)u[p++]=c[f++]}return new jt(u,h,d)}if(this.index===null)return Ke("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new i,n=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,n);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let h=0,d=c.length;h<d;h++){let u=c[h],f=e(u,n);l.push(f)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let l in n){let c=n[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let d=0,u=c.length;d<u;d++){let f=c[d];h.push(f.toJSON(e.data))}h.length>0&&(s[l]=h,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;n!==null&&this.setIndex(n.clone());let s=e.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(t))}let r=e.morphAttributes;for(let c in r){let h=[],d=r[c];for(let u=0,f=d.length;u<f;u++)h.push(d[u].clone(t));this.morphAttributes[c]=h}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,h=o.length;c<h;c++){let d=o[c];this.addGroup(d.start,d.count,d.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},Ha=class{constructor(e,t){this.isInterleavedBuffer=!0,this.array=e,this.stride=t,this.count=e!==void 0?e.length/t:0,this.usage=Af,this.updateRanges=[],this.version=0,this.uuid=ar()}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.array=new e.array.constructor(e.array),this.count=e.count,this.stride=e.stride,this.usage=e.usage,this}copyAt(e,t,n){e*=this.stride,n*=t.stride;for(let s=0,r=this.stride;s<r;s++)this.array[e+s]=t.array[n+s];return this}set(e,t=0){return this.array.set(e,t),this}clone(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=Lg(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=this.array.slice(0).buffer);let n=new this.array.constructor(e.arrayBuffers[t]),s=new this.constructor(n,this.stride);return s.setUsage(this.usage),s}onUpload(e){return this.onUploadCallback=e,this}toJSON(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=Lg(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let n={uuid:this.uuid,buffer:t,type:this.array.constructor.name,stride:this.stride};return n.usage=this.usage,n}};function Lg(i){return i.buffer._uuid===void 0&&(i.buffer._uuid=ar()),i.byteOffset===0&&i.byteLength===i.buffer.byteLength?i.buffer._uuid:i.buffer._uuid+":"+i.byteOffset+":"+i.byteLength}var ti=new U,zo=class i{constructor(e,t,n,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=e,this.itemSize=t,this.offset=n,this.normalized=s,this._normalizationScale=e!==void 0?Zh(e.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(e){this.data.needsUpdate=e}applyMatrix4(e){for(let t=0,n=this.data.count;t<n;t++)ti.fromBufferAttribute(this,t),ti.applyMatrix4(e),this.setXYZ(t,ti.x,ti.y,ti.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)ti.fromBufferAttribute(this,t),ti.applyNormalMatrix(e),this.setXYZ(t,ti.x,ti.y,ti.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)ti.fromBufferAttribute(this,t),ti.transformDirection(e),this.setXYZ(t,ti.x,ti.y,ti.z);return this}getComponent(e,t){let n=this.array[e*this.data.stride+this.offset+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.data.array[e*this.data.stride+this.offset+t]=n,this}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset]=t,this}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+1]=t,this}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+2]=t,this}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+3]=t,this}getX(e){let t=this.data.array[e*this.data.stride+this.offset];return this.normalized&&(t=this._denormalize(t)),t}getY(e){let t=this.data.array[e*this.data.stride+this.offset+1];return this.normalized&&(t=this._denormalize(t)),t}getZ(e){let t=this.data.array[e*this.data.stride+this.offset+2];return this.normalized&&(t=this._denormalize(t)),t}getW(e){let t=this.data.array[e*this.data.stride+this.offset+3];return this.normalized&&(t=this._denormalize(t)),t}setXY(e,t,n){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.data.array[e+0]=t,this.data.array[e+1]=n,this}setXYZ(e,t,n,s){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.data.array[e+0]=t,this.data.array[e+1]=n,this.data.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.data.array[e+0]=t,this.data.array[e+1]=n,this.data.array[e+2]=s,this.data.array[e+3]=r,this}clone(e){if(e===void 0){Ua("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return new jt(new this.array.constructor(t),this.itemSize,this.normalized)}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.clone(e)),new i(e.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(e){if(e===void 0){Ua("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:t,normalized:this.normalized}}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.toJSON(e)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Lf(e,this.data.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Df(e,this.data.array)}},zd=new U,Mb=new U,Sb=new st,ni=class{constructor(e=new U(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,s){return this.normal.set(e,t,n),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let s=zd.subVectors(n,t).cross(Mb.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,n=!0){let s=e.delta(zd),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return n===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let n=t||Sb.getNormalMatrix(e),s=this.coplanarPoint(zd).applyMatrix4(e),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},wb=0,Pi=class extends Wi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:wb++}),this.uuid=ar(),this.name="",this.type="Material",this.blending=qo,this.side=cs,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=lf,this.blendDst=cf,this.blendEquation=Ur,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Je(0,0,0),this.blendAlpha=0,this.depthFunc=Do,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=T0,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Pc,this.stencilZFail=Pc,this.stencilZPass=Pc,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let n=e[t];if(n===void 0){Ke(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ke(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new Je().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(n=>new ni().fromJSON(n))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let n=e.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new We().fromArray(n)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new We().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,n=null;if(t!==null){let s=t.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=t[r].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}},Cr=class extends Pi{constructor(e){super(),this.isSpriteMaterial=!0,this.type="SpriteMaterial",this.color=new Je(16777215),this.map=null,this.alphaMap=null,this.rotation=0,this.sizeAttenuation=!0,this.transparent=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.alphaMap=e.alphaMap,this.rotation=e.rotation,this.sizeAttenuation=e.sizeAttenuation,this.fog=e.fog,this}},wo,Ea=new U,Eo=new U,To=new U,Ao=new We,Ta=new We,F0=new yt,oc=new U,Aa=new U,ac=new U,Dg=new We,Hd=new We,Ng=new We,Ga=class extends Jt{constructor(e=new Cr){if(super(),this.isSprite=!0,this.type="Sprite",wo===void 0){wo=new Lt;let t=new Float32Array([-.5,-.5,0,0,0,.5,-.5,0,1,0,.5,.5,0,1,1,-.5,.5,0,0,1]),n=new Ha(t,5);wo.setIndex([0,1,2,0,2,3]),wo.setAttribute("position",new zo(n,3,0,!1)),wo.setAttribute("uv",new zo(n,2,3,!1))}this.geometry=wo,this.material=e,this.center=new We(.5,.5),this.count=1}intersectsFrustum(e){return e.intersectsSprite(this)}raycast(e,t){e.camera===null&&et('Sprite: "Raycaster.camera" needs to be set in order to raycast against sprites.'),Eo.setFromMatrixScale(this.matrixWorld),F0.copy(e.camera.matrixWorld),this.modelViewMatrix.multiplyMatrices(e.camera.matrixWorldInverse,this.matrixWorld),To.setFromMatrixPosition(this.modelViewMatrix),e.camera.isPerspectiveCamera&&this.material.sizeAttenuation===!1&&Eo.multiplyScalar(-To.z);let n=this.material.rotation,s,r;n!==0&&(r=Math.cos(n),s=Math.sin(n));let o=this.center;lc(oc.set(-.5,-.5,0),To,o,Eo,s,r),lc(Aa.set(.5,-.5,0),To,o,Eo,s,r),lc(ac.set(.5,.5,0),To,o,Eo,s,r),Dg.set(0,0),Hd.set(1,0),Ng.set(1,1);let a=e.ray.intersectTriangle(oc,Aa,ac,!1,Ea);if(a===null&&(lc(Aa.set(-.5,.5,0),To,o,Eo,s,r),Hd.set(0,1),a=e.ray.intersectTriangle(oc,ac,Aa,!1,Ea),a===null))return;let l=e.ray.origin.distanceTo(Ea);l<e.near||l>e.far||t.push({distance:l,point:Ea.clone(),uv:rs.getInterpolation(Ea,oc,Aa,ac,Dg,Hd,Ng,new We),face:null,object:this})}copy(e,t){return super.copy(e,t),e.center!==void 0&&this.center.copy(e.center),this.material=e.material,this}toJSON(e){let t=super.toJSON(e);return t.object.center=this.center.toArray(),t}};function lc(i,e,t,n,s,r){Ao.subVectors(i,t).addScalar(.5).multiply(n),s!==void 0?(Ta.x=r*Ao.x-s*Ao.y,Ta.y=s*Ao.x+r*Ao.y):Ta.copy(Ao),i.copy(e),i.x+=Ta.x,i.y+=Ta.y,i.applyMatrix4(F0)}var As=new U,Gd=new U,cc=new U,hc=new U,Ps=class{constructor(e=new U,t=new U(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,As)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=As.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(As.copy(this.origin).addScaledVector(this.direction,t),As.distanceToSquared(e))}distanceSqToSegment(e,t,n,s){Gd.copy(e).add(t).multiplyScalar(.5),cc.copy(t).sub(e).normalize(),hc.copy(this.origin).sub(Gd);let r=e.distanceTo(t)*.5,o=-this.direction.dot(cc),a=hc.dot(this.direction),l=-hc.dot(cc),c=hc.lengthSq(),h=Math.abs(1-o*o),d,u,f,p;if(h>0)if(d=o*l-a,u=o*a-l,p=r*h,d>=0)if(u>=-p)if(u<=p){let v=1/h;d*=v,u*=v,f=d*(d+o*u+2*a)+u*(o*d+u+2*l)+c}else u=r,d=Math.max(0,-(o*u+a)),f=-d*d+u*(u+2*l)+c;else u=-r,d=Math.max(0,-(o*u+a)),f=-d*d+u*(u+2*l)+c;else u<=-p?(d=Math.max(0,-(-o*r+a)),u=d>0?-r:Math.min(Math.max(-r,-l),r),f=-d*d+u*(u+2*l)+c):u<=p?(d=0,u=Math.min(Math.max(-r,-l),r),f=u*(u+2*l)+c):(d=Math.max(0,-(o*r+a)),u=d>0?r:Math.min(Math.max(-r,-l),r),f=-d*d+u*(u+2*l)+c);else u=o>0?-r:r,d=Math.max(0,-(o*u+a)),f=-d*d+u*(u+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,d),s&&s.copy(Gd).addScaledVector(cc,u),f}intersectSphere(e,t){if(e.radius<0)return null;As.subVectors(e.center,this.origin);let n=As.dot(this.direction),s=As.dot(As)-n*n,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,s,r,o,a,l,c=1/this.direction.x,h=1/this.direction.y,d=1/this.direction.z,u=this.origin;return c>=0?(n=(e.min.x-u.x)*c,s=(e.max.x-u.x)*c):(n=(e.max.x-u.x)*c,s=(e.min.x-u.x)*c),h>=0?(r=(e.min.y-u.y)*h,o=(e.max.y-u.y)*h):(r=(e.max.y-u.y)*h,o=(e.min.y-u.y)*h),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),d>=0?(a=(e.min.z-u.z)*d,l=(e.max.z-u.z)*d):(a=(e.max.z-u.z)*d,l=(e.min.z-u.z)*d),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,t)}intersectsBox(e){return this.intersectBox(e,As)!==null}intersectTriangle(e,t,n,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,h=a.z,d=e.x-o.x,u=e.y-o.y,f=e.z-o.z,p=t.x-o.x,v=t.y-o.y,g=t.z-o.z,m=n.x-o.x,_=n.y-o.y,T=n.z-o.z,M=Math.abs(l),C=Math.abs(c),S=Math.abs(h),x,E,O,P,D,z,W,N,V,Z,G,ce;if(M>=C&&M>=S?(O=l,z=d,V=p,ce=m,l>=0?(x=c,E=h,P=u,D=f,W=v,N=g,Z=_,G=T):(x=h,E=c,P=f,D=u,W=g,N=v,Z=T,G=_)):C>=S?(O=c,z=u,V=v,ce=_,c>=0?(x=h,E=l,P=f,D=d,W=g,N=p,Z=T,G=m):(x=l,E=h,P=d,D=f,W=p,N=g,Z=m,G=T)):(O=h,z=f,V=g,ce=T,h>=0?(x=l,E=c,P=d,D=u,W=p,N=v,Z=m,G=_):(x=c,E=l,P=u,D=d,W=v,N=p,Z=_,G=m)),O===0)return null;let Y=x/O,Q=E/O,ie=1/O,de=P-Y*z,fe=D-Q*z,ee=W-Y*V,ge=N-Q*V,ye=Z-Y*ce,Re=G-Q*ce,Se=ye*ge-Re*ee,Ye=de*Re-fe*ye,at=ee*fe-ge*de;if(s){if(Se<0||Ye<0||at<0)return null}else if((Se<0||Ye<0||at<0)&&(Se>0||Ye>0||at>0))return null;let Xe=Se+Ye+at;if(Xe===0)return null;let pt=ie*(Se*z+Ye*V+at*ce);return(Xe>0?pt<0:pt>0)?null:this.at(pt/Xe,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},ri=class extends Pi{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Je(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ri,this.combine=ch,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},Ug=new yt,Tr=new Ps,uc=new Js,Og=new U,dc=new U,fc=new U,pc=new U,Vd=new U,mc=new U,Fg=new U,gc=new U,De=class extends Jt{constructor(e=new Lt,t=new ri){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){mc.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=a[l],d=r[l];h!==0&&(Vd.fromBufferAttribute(d,e),o?mc.addScaledVector(Vd,h):mc.addScaledVector(Vd.sub(t),h))}t.add(mc)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),uc.copy(n.boundingSphere),uc.applyMatrix4(r),Tr.copy(e.ray).recast(e.near),!(uc.containsPoint(Tr.origin)===!1&&(Tr.intersectSphere(uc,Og)===null||Tr.origin.distanceToSquared(Og)>(e.far-e.near)**2))&&(Ug.copy(r).invert(),Tr.copy(e.ray).applyMatrix4(Ug),!(n.boundingBox!==null&&Tr.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,Tr)))}_computeIntersections(e,t,n){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,d=r.attributes.normal,u=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,v=u.length;p<v;p++){let g=u[p],m=o[g.materialIndex],_=Math.max(g.start,f.start),T=Math.min(a.count,Math.min(g.start+g.count,f.start+f.count));for(let M=_,C=T;M<C;M+=3){let S=a.getX(M),x=a.getX(M+1),E=a.getX(M+2);s=xc(this,m,e,n,c,h,d,S,x,E),s&&(s.faceIndex=Math.floor(M/3),s.face.materialIndex=g.materialIndex,t.push(s))}}else{let p=Math.max(0,f.start),v=Math.min(a.count,f.start+f.count);for(let g=p,m=v;g<m;g+=3){let _=a.getX(g),T=a.getX(g+1),M=a.getX(g+2);s=xc(this,o,e,n,c,h,d,_,T,M),s&&(s.faceIndex=Math.floor(g/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let p=0,v=u.length;p<v;p++){let g=u[p],m=o[g.materialIndex],_=Math.max(g.start,f.start),T=Math.min(l.count,Math.min(g.start+g.count,f.start+f.count));for(let M=_,C=T;M<C;M+=3){let S=M,x=M+1,E=M+2;s=xc(this,m,e,n,c,h,d,S,x,E),s&&(s.faceIndex=Math.floor(M/3),s.face.materialIndex=g.materialIndex,t.push(s))}}else{let p=Math.max(0,f.start),v=Math.min(l.count,f.start+f.count);for(let g=p,m=v;g<m;g+=3){let _=g,T=g+1,M=g+2;s=xc(this,o,e,n,c,h,d,_,T,M),s&&(s.faceIndex=Math.floor(g/3),t.push(s))}}}};function Eb(i,e,t,n,s,r,o,a){let l;if(e.side===Gn?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,e.side===cs,a),l===null)return null;gc.copy(a),gc.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(gc);return c<t.near||c>t.far?null:{distance:c,point:gc.clone(),object:i}}function xc(i,e,t,n,s,r,o,a,l,c){i.getVertexPosition(a,dc),i.getVertexPosition(l,fc),i.getVertexPosition(c,pc);let h=Eb(i,e,t,n,dc,fc,pc,Fg);if(h){let d=new U;rs.getBarycoord(Fg,dc,fc,pc,d),s&&(h.uv=rs.getInterpolatedAttribute(s,a,l,c,d,new We)),r&&(h.uv1=rs.getInterpolatedAttribute(r,a,l,c,d,new We)),o&&(h.normal=rs.getInterpolatedAttribute(o,a,l,c,d,new U),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let u={a,b:l,c,normal:new U,materialIndex:0};rs.getNormal(dc,fc,pc,u.normal),h.face=u,h.barycoord=d}return h}var Vc=class extends Hn{constructor(e=null,t=1,n=1,s,r,o,a,l,c=kn,h=kn,d,u){super(null,o,a,l,c,h,s,r,d,u),this.isDataTexture=!0,this.image={data:e,width:t,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Ar=new Js,Tb=new We(.5,.5),_c=new U,Qs=class{constructor(e=new ni,t=new ni,n=new ni,s=new ni,r=new ni,o=new ni){this.planes=[e,t,n,s,r,o]}set(e,t,n,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=Ai,n=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],h=r[4],d=r[5],u=r[6],f=r[7],p=r[8],v=r[9],g=r[10],m=r[11],_=r[12],T=r[13],M=r[14],C=r[15];if(s[0].setComponents(c-o,f-h,m-p,C-_).normalize(),s[1].setComponents(c+o,f+h,m+p,C+_).normalize(),s[2].setComponents(c+a,f+d,m+v,C+T).normalize(),s[3].setComponents(c-a,f-d,m-v,C-T).normalize(),n)s[4].setComponents(l,u,g,M).normalize(),s[5].setComponents(c-l,f-u,m-g,C-M).normalize();else if(s[4].setComponents(c-l,f-u,m-g,C-M).normalize(),t===Ai)s[5].setComponents(c+l,f+u,m+g,C+M).normalize();else if(t===No)s[5].setComponents(l,u,g,M).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),Ar.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),Ar.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(Ar)}intersectsSprite(e){Ar.center.set(0,0,0);let t=Tb.distanceTo(e.center);return Ar.radius=.7071067811865476+t,Ar.applyMatrix4(e.matrixWorld),this.intersectsSphere(Ar)}intersectsSphere(e){let t=this.planes,n=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let s=t[n];if(_c.x=s.normal.x>0?e.max.x:e.min.x,_c.y=s.normal.y>0?e.max.y:e.min.y,_c.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(_c)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},kg=new yt,Wc=class i{constructor(){this.coordinateSystem=Ai,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,n=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];kg.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new Qs),n[s].setFromProjectionMatrix(kg,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,n=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new Qs),t[s].copy(n[s]);return this._count=e._count,this}clone(){return new i().copy(this)}};var as=class extends Pi{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new Je(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},Xc=new U,qc=new U,Bg=new yt,Ra=new Ps,yc=new Js,Wd=new U,zg=new U,oi=class extends Jt{constructor(e=new Lt,t=new as){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[0];for(let s=1,r=t.count;s<r;s++)Xc.fromBufferAttribute(t,s-1),qc.fromBufferAttribute(t,s),n[s]=n[s-1],n[s]+=Xc.distanceTo(qc);e.setAttribute("lineDistance",new wt(n,1))}else Ke("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),yc.copy(n.boundingSphere),yc.applyMatrix4(s),yc.radius+=r,e.ray.intersectsSphere(yc)===!1)return;Bg.copy(s).invert(),Ra.copy(e.ray).applyMatrix4(Bg);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,h=n.index,u=n.attributes.position;if(h!==null){let f=Math.max(0,o.start),p=Math.min(h.count,o.start+o.count);for(let v=f,g=p-1;v<g;v+=c){let m=h.getX(v),_=h.getX(v+1),T=vc(this,e,Ra,l,m,_,v);T&&t.push(T)}if(this.isLineLoop){let v=h.getX(p-1),g=h.getX(f),m=vc(this,e,Ra,l,v,g,p-1);m&&t.push(m)}}else{let f=Math.max(0,o.start),p=Math.min(u.count,o.start+o.count);for(let v=f,g=p-1;v<g;v+=c){let m=vc(this,e,Ra,l,v,v+1,v);m&&t.push(m)}if(this.isLineLoop){let v=vc(this,e,Ra,l,p-1,f,p-1);v&&t.push(v)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function vc(i,e,t,n,s,r,o){let a=i.geometry.attributes.position;if(Xc.fromBufferAttribute(a,s),qc.fromBufferAttribute(a,r),t.distanceSqToSegment(Xc,qc,Wd,zg)>n)return;Wd.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(Wd);if(!(c<e.near||c>e.far))return{distance:c,point:zg.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var Hg=new U,Gg=new U,Va=class extends oi{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[];for(let s=0,r=t.count;s<r;s+=2)Hg.fromBufferAttribute(t,s),Gg.fromBufferAttribute(t,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+Hg.distanceTo(Gg);e.setAttribute("lineDistance",new wt(n,1))}else Ke("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var Ho=class extends Pi{constructor(e){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new Je(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.alphaMap=e.alphaMap,this.size=e.size,this.sizeAttenuation=e.sizeAttenuation,this.fog=e.fog,this}},Vg=new yt,jd=new Ps,bc=new Js,Mc=new U,Wa=class extends Jt{constructor(e=new Lt,t=new Ho){super(),this.isPoints=!0,this.type="Points",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.matrixWorld,r=e.params.Points.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),bc.copy(n.boundingSphere),bc.applyMatrix4(s),bc.radius+=r,e.ray.intersectsSphere(bc)===!1)return;Vg.copy(s).invert(),jd.copy(e.ray).applyMatrix4(Vg);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=n.index,d=n.attributes.position;if(c!==null){let u=Math.max(0,o.start),f=Math.min(c.count,o.start+o.count);for(let p=u,v=f;p<v;p++){let g=c.getX(p);Mc.fromBufferAttribute(d,g),Wg(Mc,g,l,s,e,t,this)}}else{let u=Math.max(0,o.start),f=Math.min(d.count,o.start+o.count);for(let p=u,v=f;p<v;p++)Mc.fromBufferAttribute(d,p),Wg(Mc,p,l,s,e,t,this)}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Wg(i,e,t,n,s,r,o){let a=jd.distanceSqToPoint(i);if(a<t){let l=new U;jd.closestPointToPoint(i,l),l.applyMatrix4(n);let c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:e,face:null,faceIndex:null,barycoord:null,object:o})}}var Xa=class extends Hn{constructor(e=[],t=Or,n,s,r,o,a,l,c,h){super(e,t,n,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}},qa=class extends Hn{constructor(e,t,n,s,r,o,a,l,c){super(e,t,n,s,r,o,a,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}};var Is=class extends Hn{constructor(e,t,n=Xi,s,r,o,a=kn,l=kn,c,h=Cs,d=1){if(h!==Cs&&h!==Us)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let u={width:e,height:t,depth:d};super(u,s,r,o,a,l,h,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Fo(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},Ya=class extends Is{constructor(e,t=Xi,n=Or,s,r,o=kn,a=kn,l,c=Cs){let h={width:e,height:e,depth:1},d=[h,h,h,h,h,h];super(e,e,t,n,s,r,o,a,l,c),this.image=d,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},Za=class extends Hn{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},Vt=class i extends Lt{constructor(e=1,t=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],h=[],d=[],u=0,f=0;p("z","y","x",-1,-1,n,t,e,o,r,0),p("z","y","x",1,-1,n,t,-e,o,r,1),p("x","z","y",1,1,e,n,t,s,o,2),p("x","z","y",1,-1,e,n,-t,s,o,3),p("x","y","z",1,-1,e,t,n,s,r,4),p("x","y","z",-1,-1,e,t,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new wt(c,3)),this.setAttribute("normal",new wt(h,3)),this.setAttribute("uv",new wt(d,2));function p(v,g,m,_,T,M,C,S,x,E,O){let P=M/x,D=C/E,z=M/2,W=C/2,N=S/2,V=x+1,Z=E+1,G=0,ce=0,Y=new U;for(let Q=0;Q<Z;Q++){let ie=Q*D-W;for(let de=0;de<V;de++){let fe=de*P-z;Y[v]=fe*_,Y[g]=ie*T,Y[m]=N,c.push(Y.x,Y.y,Y.z),Y[v]=0,Y[g]=0,Y[m]=S>0?1:-1,h.push(Y.x,Y.y,Y.z),d.push(de/x),d.push(1-Q/E),G+=1}}for(let Q=0;Q<E;Q++)for(let ie=0;ie<x;ie++){let de=u+ie+V*Q,fe=u+ie+V*(Q+1),ee=u+(ie+1)+V*(Q+1),ge=u+(ie+1)+V*Q;l.push(de,fe,ge),l.push(fe,ee,ge),ce+=6}a.addGroup(f,ce,O),f+=ce,u+=G}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}},$a=class i extends Lt{constructor(e=1,t=1,n=4,s=8,r=1){super(),this.type="CapsuleGeometry",this.parameters={radius:e,height:t,capSegments:n,radialSegments:s,heightSegments:r},t=Math.max(0,t),n=Math.max(1,Math.floor(n)),s=Math.max(3,Math.floor(s)),r=Math.max(1,Math.floor(r));let o=[],a=[],l=[],c=[],h=t/2,d=Math.PI/2*e,u=t,f=2*d+u,p=n*2+r,v=s+1,g=new U,m=new U;for(let _=0;_<=p;_++){let T=0,M=0,C=0,S=0;if(_<=n){let O=_/n,P=O*Math.PI/2;M=-h-e*Math.cos(P),C=e*Math.sin(P),S=-e*Math.cos(P),T=O*d}else if(_<=n+r){let O=(_-n)/r;M=-h+O*t,C=e,S=0,T=d+O*u}else{let O=(_-n-r)/n,P=O*Math.PI/2;M=h+e*Math.sin(P),C=e*Math.cos(P),S=e*Math.sin(P),T=d+u+O*d}let x=Math.max(0,Math.min(1,T/f)),E=0;_===0?E=.5/s:_===p&&(E=-.5/s);for(let O=0;O<=s;O++){let P=O/s,D=P*Math.PI*2,z=Math.sin(D),W=Math.cos(D);m.x=-C*W,m.y=M,m.z=C*z,a.push(m.x,m.y,m.z),g.set(-C*W,S,C*z),g.normalize(),l.push(g.x,g.y,g.z),c.push(P+E,x)}if(_>0){let O=(_-1)*v;for(let P=0;P<s;P++){let D=O+P,z=O+P+1,W=_*v+P,N=_*v+P+1;o.push(D,z,W),o.push(z,N,W)}}}this.setIndex(o),this.setAttribute("position",new wt(a,3)),this.setAttribute("normal",new wt(l,3)),this.setAttribute("uv",new wt(c,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.height,e.capSegments,e.radialSegments,e.heightSegments)}};var Sn=class i extends Lt{constructor(e=1,t=1,n=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:n,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let h=[],d=[],u=[],f=[],p=0,v=[],g=n/2,m=0;_(),o===!1&&(e>0&&T(!0),t>0&&T(!1)),this.setIndex(h),this.setAttribute("position",new wt(d,3)),this.setAttribute("normal",new wt(u,3)),this.setAttribute("uv",new wt(f,2));function _(){let M=new U,C=new U,S=0,x=(t-e)/n;for(let E=0;E<=r;E++){let O=[],P=E/r,D=P*(t-e)+e;for(let z=0;z<=s;z++){let W=z/s,N=W*l+a,V=Math.sin(N),Z=Math.cos(N);C.x=D*V,C.y=-P*n+g,C.z=D*Z,d.push(C.x,C.y,C.z),M.set(V,x,Z).normalize(),u.push(M.x,M.y,M.z),f.push(W,1-P),O.push(p++)}v.push(O)}for(let E=0;E<s;E++)for(let O=0;O<r;O++){let P=v[O][E],D=v[O+1][E],z=v[O+1][E+1],W=v[O][E+1];(e>0||O!==0)&&(h.push(P,D,W),S+=3),(t>0||O!==r-1)&&(h.push(D,z,W),S+=3)}c.addGroup(m,S,0),m+=S}function T(M){let C=p,S=new We,x=new U,E=0,O=M===!0?e:t,P=M===!0?1:-1;for(let z=1;z<=s;z++)d.push(0,g*P,0),u.push(0,P,0),f.push(.5,.5),p++;let D=p;for(let z=0;z<=s;z++){let N=z/s*l+a,V=Math.cos(N),Z=Math.sin(N);x.x=O*Z,x.y=g*P,x.z=O*V,d.push(x.x,x.y,x.z),u.push(0,P,0),S.x=V*.5+.5,S.y=Z*.5*P+.5,f.push(S.x,S.y),p++}for(let z=0;z<s;z++){let W=C+z,N=D+z;M===!0?h.push(N,N+1,W):h.push(N+1,N,W),E+=3}c.addGroup(m,E,M===!0?1:2),m+=E}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var Yc=class i extends Lt{constructor(e=[],t=[],n=1,s=0){super(),this.type="PolyhedronGeometry",this.parameters={vertices:e,indices:t,radius:n,detail:s};let r=[],o=[];a(s),c(n),h(),this.setAttribute("position",new wt(r,3)),this.setAttribute("normal",new wt(r.slice(),3)),this.setAttribute("uv",new wt(o,2)),s===0?this.computeVertexNormals():this.normalizeNormals();function a(_){let T=new U,M=new U,C=new U;for(let S=0;S<t.length;S+=3)f(t[S+0],T),f(t[S+1],M),f(t[S+2],C),l(T,M,C,_)}function l(_,T,M,C){let S=C+1,x=[];for(let E=0;E<=S;E++){x[E]=[];let O=_.clone().lerp(M,E/S),P=T.clone().lerp(M,E/S),D=S-E;for(let z=0;z<=D;z++)z===0&&E===S?x[E][z]=O:x[E][z]=O.clone().lerp(P,z/D)}for(let E=0;E<S;E++)for(let O=0;O<2*(S-E)-1;O++){let P=Math.floor(O/2);O%2===0?(u(x[E][P+1]),u(x[E+1][P]),u(x[E][P])):(u(x[E][P+1]),u(x[E+1][P+1]),u(x[E+1][P]))}}function c(_){let T=new U;for(let M=0;M<r.length;M+=3)T.x=r[M+0],T.y=r[M+1],T.z=r[M+2],T.normalize().multiplyScalar(_),r[M+0]=T.x,r[M+1]=T.y,r[M+2]=T.z}function h(){let _=new U;for(let T=0;T<r.length;T+=3){_.x=r[T+0],_.y=r[T+1],_.z=r[T+2];let M=g(_)/2/Math.PI+.5,C=m(_)/Math.PI+.5;o.push(M,1-C)}p(),d()}function d(){for(let _=0;_<o.length;_+=6){let T=o[_+0],M=o[_+2],C=o[_+4],S=Math.max(T,M,C),x=Math.min(T,M,C);S>.9&&x<.1&&(T<.2&&(o[_+0]+=1),M<.2&&(o[_+2]+=1),C<.2&&(o[_+4]+=1))}}function u(_){r.push(_.x,_.y,_.z)}function f(_,T){let M=_*3;T.x=e[M+0],T.y=e[M+1],T.z=e[M+2]}function p(){let _=new U,T=new U,M=new U,C=new U,S=new We,x=new We,E=new We;for(let O=0,P=0;O<r.length;O+=9,P+=6){_.set(r[O+0],r[O+1],r[O+2]),T.set(r[O+3],r[O+4],r[O+5]),M.set(r[O+6],r[O+7],r[O+8]),S.set(o[P+0],o[P+1]),x.set(o[P+2],o[P+3]),E.set(o[P+4],o[P+5]),C.copy(_).add(T).add(M).divideScalar(3);let D=g(C);v(S,P+0,_,D),v(x,P+2,T,D),v(E,P+4,M,D)}}function v(_,T,M,C){C<0&&_.x===1&&(o[T]=_.x-1),M.x===0&&M.z===0&&(o[T]=C/2/Math.PI+.5)}function g(_){return Math.atan2(_.z,-_.x)}function m(_){return Math.atan2(-_.y,Math.sqrt(_.x*_.x+_.z*_.z))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.vertices,e.indices,e.radius,e.detail)}};var Sc=new U,wc=new U,Xd=new U,Ec=new rs,Ka=class extends Lt{constructor(e=null,t=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:e,thresholdAngle:t},e!==null){let s=Math.pow(10,4),r=Math.cos(Io*t),o=e.getIndex(),a=e.getAttribute("position"),l=o?o.count:a.count,c=[0,0,0],h=["a","b","c"],d=new Array(3),u=new Map,f=[];for(let p=0;p<l;p+=3){o?(c[0]=o.getX(p),c[1]=o.getX(p+1),c[2]=o.getX(p+2)):(c[0]=p,c[1]=p+1,c[2]=p+2);let{a:v,b:g,c:m}=Ec;if(v.fromBufferAttribute(a,c[0]),g.fromBufferAttribute(a,c[1]),m.fromBufferAttribute(a,c[2]),Ec.getNormal(Xd),d[0]=`${Math.round(v.x*s)},${Math.round(v.y*s)},${Math.round(v.z*s)}`,d[1]=`${Math.round(g.x*s)},${Math.round(g.y*s)},${Math.round(g.z*s)}`,d[2]=`${Math.round(m.x*s)},${Math.round(m.y*s)},${Math.round(m.z*s)}`,!(d[0]===d[1]||d[1]===d[2]||d[2]===d[0]))for(let _=0;_<3;_++){let T=(_+1)%3,M=d[_],C=d[T],S=Ec[h[_]],x=Ec[h[T]],E=`${M}_${C}`,O=`${C}_${M}`,P=u.get(O);P?(Xd.dot(P.normal)<=r&&(f.push(S.x,S.y,S.z),f.push(x.x,x.y,x.z)),u.set(O,null)):u.has(E)||u.set(E,{index0:c[_],index1:c[T],normal:Xd.clone()})}}for(let p of u.values())if(p){let{index0:v,index1:g}=p;Sc.fromBufferAttribute(a,v),wc.fromBufferAttribute(a,g),f.push(Sc.x,Sc.y,Sc.z),f.push(wc.x,wc.y,wc.z)}this.setAttribute("position",new wt(f,3))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}};var er=class i extends Yc{constructor(e=1,t=0){let n=[1,0,0,-1,0,0,0,1,0,0,-1,0,0,0,1,0,0,-1],s=[0,2,4,0,4,3,0,3,5,0,5,2,1,2,5,1,5,3,1,3,4,1,4,2];super(n,s,e,t),this.type="OctahedronGeometry",this.parameters={radius:e,detail:t}}static fromJSON(e){return new i(e.radius,e.detail)}},Ls=class i extends Lt{constructor(e=1,t=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(n),l=Math.floor(s),c=a+1,h=l+1,d=e/a,u=t/l,f=[],p=[],v=[],g=[];for(let m=0;m<h;m++){let _=m*u-o;for(let T=0;T<c;T++){let M=T*d-r;p.push(M,-_,0),v.push(0,0,1),g.push(T/a),g.push(1-m/l)}}for(let m=0;m<l;m++)for(let _=0;_<a;_++){let T=_+c*m,M=_+c*(m+1),C=_+1+c*(m+1),S=_+1+c*m;f.push(T,M,S),f.push(M,C,S)}this.setIndex(f),this.setAttribute("position",new wt(p,3)),this.setAttribute("normal",new wt(v,3)),this.setAttribute("uv",new wt(g,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.widthSegments,e.heightSegments)}};var Ii=class i extends Lt{constructor(e=1,t=32,n=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:n,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),n=Math.max(2,Math.floor(n));let l=Math.min(o+a,Math.PI),c=0,h=[],d=new U,u=new U,f=[],p=[],v=[],g=[];for(let m=0;m<=n;m++){let _=[],T=m/n,M=o+T*a,C=e*Math.cos(M),S=Math.sqrt(e*e-C*C),x=0;m===0&&o===0?x=.5/t:m===n&&l===Math.PI&&(x=-.5/t);for(let E=0;E<=t;E++){let O=E/t,P=s+O*r;d.x=-S*Math.cos(P),d.y=C,d.z=S*Math.sin(P),p.push(d.x,d.y,d.z),u.copy(d).normalize(),v.push(u.x,u.y,u.z),g.push(O+x,1-T),_.push(c++)}h.push(_)}for(let m=0;m<n;m++)for(let _=0;_<t;_++){let T=h[m][_+1],M=h[m][_],C=h[m+1][_],S=h[m+1][_+1];(m!==0||o>0)&&f.push(T,M,S),(m!==n-1||l<Math.PI)&&f.push(M,C,S)}this.setIndex(f),this.setAttribute("position",new wt(p,3)),this.setAttribute("normal",new wt(v,3)),this.setAttribute("uv",new wt(g,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};var Ds=class i extends Lt{constructor(e=1,t=.4,n=12,s=48,r=Math.PI*2,o=0,a=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:e,tube:t,radialSegments:n,tubularSegments:s,arc:r,thetaStart:o,thetaLength:a},n=Math.floor(n),s=Math.floor(s);let l=[],c=[],h=[],d=[],u=new U,f=new U,p=new U;for(let v=0;v<=n;v++){let g=o+v/n*a;for(let m=0;m<=s;m++){let _=m/s*r;f.x=(e+t*Math.cos(g))*Math.cos(_),f.y=(e+t*Math.cos(g))*Math.sin(_),f.z=t*Math.sin(g),c.push(f.x,f.y,f.z),u.x=e*Math.cos(_),u.y=e*Math.sin(_),p.subVectors(f,u).normalize(),h.push(p.x,p.y,p.z),d.push(m/s),d.push(v/n)}}for(let v=1;v<=n;v++)for(let g=1;g<=s;g++){let m=(s+1)*v+g-1,_=(s+1)*(v-1)+g-1,T=(s+1)*(v-1)+g,M=(s+1)*v+g;l.push(m,_,M),l.push(_,T,M)}this.setIndex(l),this.setAttribute("position",new wt(c,3)),this.setAttribute("normal",new wt(h,3)),this.setAttribute("uv",new wt(d,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.tube,e.radialSegments,e.tubularSegments,e.arc,e.thetaStart,e.thetaLength)}};function kr(i){let e={};for(let t in i){e[t]={};for(let n in i[t]){let s=i[t][n];if(Xg(s))s.isRenderTargetTexture?(Ke("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=s.clone();else if(Array.isArray(s))if(Xg(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][n]=r}else e[t][n]=s.slice();else e[t][n]=s}}return e}function Zn(i){let e={};for(let t=0;t<i.length;t++){let n=kr(i[t]);for(let s in n)e[s]=n[s]}return e}function Xg(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function Ab(i){let e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function Nf(i){let e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:Mt.workingColorSpace}var k0={clone:kr,merge:Zn},Rb=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Cb=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,ls=class extends Pi{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Rb,this.fragmentShader=Cb,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=kr(e.uniforms),this.uniformsGroups=Ab(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let n in e.uniforms){let s=e.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=t[s.value]||null;break;case"c":this.uniforms[n].value=new Je().setHex(s.value);break;case"v2":this.uniforms[n].value=new We().fromArray(s.value);break;case"v3":this.uniforms[n].value=new U().fromArray(s.value);break;case"v4":this.uniforms[n].value=new tn().fromArray(s.value);break;case"m3":this.uniforms[n].value=new st().fromArray(s.value);break;case"m4":this.uniforms[n].value=new yt().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let n in e.extensions)this.extensions[n]=e.extensions[n];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},Zc=class extends ls{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}},ja=class extends Pi{constructor(e){super(),this.isMeshStandardMaterial=!0,this.type="MeshStandardMaterial",this.defines={STANDARD:""},this.color=new Je(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Je(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=ul,this.normalScale=new We(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ri,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.defines={STANDARD:""},this.color.copy(e.color),this.roughness=e.roughness,this.metalness=e.metalness,this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.roughnessMap=e.roughnessMap,this.metalnessMap=e.metalnessMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.envMapIntensity=e.envMapIntensity,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}};var Pr=class extends Pi{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new Je(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Je(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=ul,this.normalScale=new We(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ri,this.combine=ch,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},$c=class extends Pi{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=w0,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},Kc=class extends Pi{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function Ro(i,e){return!i||i.constructor===e?i:typeof e.BYTES_PER_ELEMENT=="number"?new e(i):Array.prototype.slice.call(i)}function Tc(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var tr=class{constructor(e,t,n,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(n),this.sampleValues=t,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,s=t[n],r=t[n-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=n+2;;){if(s===void 0){if(e<r)break i;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=t[++n],e<s)break e}o=t.length;break t}if(!(e>=r)){let a=t[1];e<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=t[--n-1],e>=r)break e}o=n,n=0;break t}break n}for(;n<o;){let a=n+o>>>1;e<t[a]?o=a:n=a+1}if(s=t[n],r=t[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=n[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},jc=class extends tr{constructor(e,t,n,s){super(e,t,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Zd,endingEnd:Zd}}intervalChanged_(e,t,n){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case $d:r=e,a=2*t-n;break;case Kd:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case $d:o=e,l=2*n-t;break;case Kd:o=1,l=n+s[1]-s[0];break;default:o=e-1,l=t}let c=(n-t)*.5,h=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-n),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=this._offsetPrev,d=this._offsetNext,u=this._weightPrev,f=this._weightNext,p=(n-t)/(s-t),v=p*p,g=v*p,m=-u*g+2*u*v-u*p,_=(1+u)*g+(-1.5-2*u)*v+(-.5+u)*p+1,T=(-1-f)*g+(1.5+f)*v+.5*p,M=f*g-f*v;for(let C=0;C!==a;++C)r[C]=m*o[h+C]+_*o[c+C]+T*o[l+C]+M*o[d+C];return r}},Jc=class extends tr{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=(n-t)/(s-t),d=1-h;for(let u=0;u!==a;++u)r[u]=o[c+u]*d+o[l+u]*h;return r}},Qc=class extends tr{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e){return this.copySampleValue_(e-1)}},eh=class extends tr{interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=this.inTangents,d=this.outTangents;if(!h||!d){let p=(n-t)/(s-t),v=1-p;for(let g=0;g!==a;++g)r[g]=o[c+g]*v+o[l+g]*p;return r}let u=a*2,f=e-1;for(let p=0;p!==a;++p){let v=o[c+p],g=o[l+p],m=f*u+p*2,_=d[m],T=d[m+1],M=e*u+p*2,C=h[M],S=h[M+1],x=Ib(n,t,_,C,s);r[p]=B0(x,v,T,S,g)}return r}};function B0(i,e,t,n,s){let r=1-i;return r*r*r*e+3*r*r*i*t+3*r*i*i*n+i*i*i*s}function Pb(i,e,t,n,s){let r=1-i;return 3*r*r*(t-e)+6*r*i*(n-t)+3*i*i*(s-n)}function Ib(i,e,t,n,s){let r=(i-e)/(s-e);for(let o=0;o<8;o++){let a=B0(r,e,t,n,s)-i;if(Math.abs(a)<1e-10)break;let l=Pb(r,e,t,n,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var bi=class{constructor(e,t,n,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=Ro(t,this.TimeBufferType),this.values=Ro(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.toJSON(e);else{n={name:e.name,times:Ro(e.times,Array),values:Ro(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(n.interpolation=s),Tc(e.settings)&&(n.settings={inTangents:Ro(e.settings.inTangents,Array),outTangents:Ro(e.settings.outTangents,Array)})}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){return new Qc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new Jc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new jc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new eh(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case Ia:t=this.InterpolantFactoryMethodDiscrete;break;case Bc:t=this.InterpolantFactoryMethodLinear;break;case Cc:t=this.InterpolantFactoryMethodSmooth;break;case Yd:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return Ke("KeyframeTrack:",n),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Ia;case this.InterpolantFactoryMethodLinear:return Bc;case this.InterpolantFactoryMethodSmooth:return Cc;case this.InterpolantFactoryMethodBezier:return Yd}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]+=e;Tc(this.settings)&&(qg(this.settings.inTangents,e),qg(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]*=e;Tc(this.settings)&&(Yg(this.settings.inTangents,e),Yg(this.settings.outTangents,e))}return this}trim(e,t){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<e;)++r;for(;o!==-1&&n[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(et("KeyframeTrack: Invalid value size in track.",this),e=!1);let n=this.times,s=this.values,r=n.length;r===0&&(et("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){et("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){et("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&Yv(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){et("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===Cc,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],h=e[a+1];if(c!==h&&(a!==1||c!==e[0]))if(s)l=!0;else{let d=a*n,u=d-n,f=d+n;for(let p=0;p!==n;++p){let v=t[d+p];if(v!==t[u+p]||v!==t[f+p]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let d=a*n,u=o*n;for(let f=0;f!==n;++f)t[u+f]=t[d+f]}++o}}if(r>0){e[o]=e[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*n)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),n=this.constructor,s=new n(this.name,e,t);return s.createInterpolant=this.createInterpolant,Tc(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function qg(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]+=e}function Yg(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]*=e}bi.prototype.ValueTypeName="";bi.prototype.TimeBufferType=Float32Array;bi.prototype.ValueBufferType=Float32Array;bi.prototype.DefaultInterpolation=Bc;var nr=class extends bi{constructor(e,t,n){super(e,t,n)}};nr.prototype.ValueTypeName="bool";nr.prototype.ValueBufferType=Array;nr.prototype.DefaultInterpolation=Ia;nr.prototype.InterpolantFactoryMethodLinear=void 0;nr.prototype.InterpolantFactoryMethodSmooth=void 0;var th=class extends bi{constructor(e,t,n,s){super(e,t,n,s)}};th.prototype.ValueTypeName="color";var nh=class extends bi{constructor(e,t,n,s){super(e,t,n,s)}};nh.prototype.ValueTypeName="number";var ih=class extends tr{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-t)/(s-t),c=e*a;for(let h=c+a;c!==h;c+=4)ht.slerpFlat(r,0,o,c-a,o,c,l);return r}},Ja=class extends bi{constructor(e,t,n,s){super(e,t,n,s)}InterpolantFactoryMethodLinear(e){return new ih(this.times,this.values,this.getValueSize(),e)}};Ja.prototype.ValueTypeName="quaternion";Ja.prototype.InterpolantFactoryMethodSmooth=void 0;var ir=class extends bi{constructor(e,t,n){super(e,t,n)}};ir.prototype.ValueTypeName="string";ir.prototype.ValueBufferType=Array;ir.prototype.DefaultInterpolation=Ia;ir.prototype.InterpolantFactoryMethodLinear=void 0;ir.prototype.InterpolantFactoryMethodSmooth=void 0;var sh=class extends bi{constructor(e,t,n,s){super(e,t,n,s)}};sh.prototype.ValueTypeName="vector";var rh=class{constructor(e,t,n){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=n,this._abortController=null,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,d){return c.push(h,d),this},this.removeHandler=function(h){let d=c.indexOf(h);return d!==-1&&c.splice(d,2),this},this.getHandler=function(h){for(let d=0,u=c.length;d<u;d+=2){let f=c[d],p=c[d+1];if(f.global&&(f.lastIndex=0),f.test(h))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},z0=new rh,oh=class{constructor(e){this.manager=e!==void 0?e:z0,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let n=this;return new Promise(function(s,r){n.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};oh.DEFAULT_MATERIAL_NAME="__DEFAULT";var Qa=class extends Jt{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new Je(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}},el=class extends Qa{constructor(e,t,n){super(e,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Jt.DEFAULT_UP),this.updateMatrix(),this.groundColor=new Je(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}toJSON(e){let t=super.toJSON(e);return t.object.groundColor=this.groundColor.getHex(),t}},qd=new yt,Zg=new U,$g=new U,ah=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new We(512,512),this.mapType=ci,this.map=null,this.mapPass=null,this.matrix=new yt,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Qs,this._frameExtents=new We(1,1),this._viewportCount=1,this._viewports=[new tn(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;Zg.setFromMatrixPosition(e.matrixWorld),t.position.copy(Zg),$g.setFromMatrixPosition(e.target.matrixWorld),t.lookAt($g),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,n,s){qd.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),n.setFromProjectionMatrix(qd,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;e.coordinateSystem===No||e.reversedDepth?t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),t.multiply(qd)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},Ac=new U,Rc=new ht,ss=new U,tl=class extends Jt{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new yt,this.projectionMatrix=new yt,this.projectionMatrixInverse=new yt,this.coordinateSystem=Ai,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(Ac,Rc,ss),ss.x===1&&ss.y===1&&ss.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Ac,Rc,ss.set(1,1,1)).invert()}updateWorldMatrix(e,t,n=!1){super.updateWorldMatrix(e,t,n),this.matrixWorld.decompose(Ac,Rc,ss),ss.x===1&&ss.y===1&&ss.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Ac,Rc,ss.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},js=new U,Kg=new We,jg=new We,ii=class extends tl{constructor(e=50,t=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=Oo*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(Io*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Oo*2*Math.atan(Math.tan(Io*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){js.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(js.x,js.y).multiplyScalar(-e/js.z),js.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(js.x,js.y).multiplyScalar(-e/js.z)}getViewSize(e,t){return this.getViewBounds(e,Kg,jg),t.subVectors(jg,Kg)}setViewOffset(e,t,n,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(Io*.5*this.fov)/this.zoom,n=2*t,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var nl=class extends tl{constructor(e=-1,t=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-e,o=n+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},Jd=class extends ah{constructor(){super(new nl(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Go=class extends Qa{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Jt.DEFAULT_UP),this.updateMatrix(),this.target=new Jt,this.shadow=new Jd}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}};var Co=-90,Po=1,Vo=class extends Jt{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new ii(Co,Po,e,t);s.layers=this.layers,this.add(s);let r=new ii(Co,Po,e,t);r.layers=this.layers,this.add(r);let o=new ii(Co,Po,e,t);o.layers=this.layers,this.add(o);let a=new ii(Co,Po,e,t);a.layers=this.layers,this.add(a);let l=new ii(Co,Po,e,t);l.layers=this.layers,this.add(l);let c=new ii(Co,Po,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[n,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===Ai)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===No)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,h]=this.children,d=e.getRenderTarget(),u=e.getActiveCubeFace(),f=e.getActiveMipmapLevel(),p=e.xr.enabled;e.xr.enabled=!1;let v=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let g=!1;e.isWebGLRenderer===!0?g=e.state.buffers.depth.getReversed():g=e.reversedDepthBuffer,e.setRenderTarget(n,0,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(n,1,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(n,2,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(n,3,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(n,4,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),n.texture.mipmapsAutoUpdate=v,e.setRenderTarget(n,5,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,h),e.setRenderTarget(d,u,f),e.xr.enabled=p,n.texture.needsPMREMUpdate=!0}},lh=class extends ii{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var Uf="\\[\\]\\.:\\/",Lb=new RegExp("["+Uf+"]","g"),Of="[^"+Uf+"]",Db="[^"+Uf.replace("\\.","")+"]",Nb=/((?:WC+[\/:])*)/.source.replace("WC",Of),Ub=/(WCOD+)?/.source.replace("WCOD",Db),Ob=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Of),Fb=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Of),kb=new RegExp("^"+Nb+Ub+Ob+Fb+"$"),Bb=["material","materials","bones","map"],Qd=class{constructor(e,t,n){let s=n||Kt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},Kt=class i{constructor(e,t,n){this.path=t,this.parsedPath=n||i.parseTrackName(t),this.node=i.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,n){return e&&e.isAnimationObjectGroup?new i.Composite(e,t,n):new i(e,t,n)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(Lb,"")}static parseTrackName(e){let t=kb.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);Bb.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return n}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);if(n!==void 0)return n}if(e.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=n(a.children);if(l)return l}return null},s=n(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)e[t++]=n[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,n=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=i.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Ke("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=t.objectIndex;switch(n){case"materials":if(!e.material){et("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){et("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){et("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let h=0;h<e.length;h++)if(e[h].name===c){c=h;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){et("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){et("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[n]===void 0){et("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[n]}if(c!==void 0){if(e[c]===void 0){et("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;et("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){et("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){et("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Kt.Composite=Qd;Kt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Kt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Kt.prototype.GetterByBindingType=[Kt.prototype._getValue_direct,Kt.prototype._getValue_array,Kt.prototype._getValue_arrayElement,Kt.prototype._getValue_toArray];Kt.prototype.SetterByBindingTypeAndVersioning=[[Kt.prototype._setValue_direct,Kt.prototype._setValue_direct_setNeedsUpdate,Kt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Kt.prototype._setValue_array,Kt.prototype._setValue_array_setNeedsUpdate,Kt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Kt.prototype._setValue_arrayElement,Kt.prototype._setValue_arrayElement_setNeedsUpdate,Kt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Kt.prototype._setValue_fromArray,Kt.prototype._setValue_fromArray_setNeedsUpdate,Kt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var QT=new Float32Array(1);var Jg=new yt,Ir=class{constructor(e,t,n=0,s=1/0){this.ray=new Ps(e,t),this.near=n,this.far=s,this.camera=null,this.layers=new ko,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(e,t){this.ray.set(e,t)}setFromCamera(e,t){t.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(e.x,e.y,.5).unproject(t).sub(this.ray.origin).normalize(),this.camera=t):t.isOrthographicCamera?(this.ray.origin.set(e.x,e.y,t.projectionMatrix.elements[14]).unproject(t),this.ray.direction.set(0,0,-1).transformDirection(t.matrixWorld),this.camera=t):et("Raycaster: Unsupported camera type: "+t.type)}setFromXRController(e){return Jg.identity().extractRotation(e.matrixWorld),this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(Jg),this}intersectObject(e,t=!0,n=[]){return ef(e,this,n,t),n.sort(Qg),n}intersectObjects(e,t=!0,n=[]){for(let s=0,r=e.length;s<r;s++)ef(e[s],this,n,t);return n.sort(Qg),n}};function Qg(i,e){return i.distance-e.distance}function ef(i,e,t,n){let s=!0;if(i.layers.test(e.layers)&&i.raycast(e,t)===!1&&(s=!1),s===!0&&n===!0){let r=i.children;for(let o=0,a=r.length;o<a;o++)ef(r[o],e,t,!0)}}var Wo=class{constructor(e=1,t=0,n=0){this.radius=e,this.phi=t,this.theta=n}set(e,t,n){return this.radius=e,this.phi=t,this.theta=n,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=xt(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,n){return this.radius=Math.sqrt(e*e+t*t+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,n),this.phi=Math.acos(xt(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var tf=class{static{this.prototype.isMatrix2=!0}constructor(e,t,n,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let n=0;n<4;n++)this.elements[n]=e[n+t];return this}set(e,t,n,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=n,r[3]=s,this}};var Lr=class extends Wi{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function Ff(i,e,t,n){let s=zb(n);switch(t){case bf:return i*e;case Sf:return i*e/s.components*s.byteLength;case mh:return i*e/s.components*s.byteLength;case or:return i*e*2/s.components*s.byteLength;case gh:return i*e*2/s.components*s.byteLength;case Mf:return i*e*3/s.components*s.byteLength;case Zi:return i*e*4/s.components*s.byteLength;case xh:return i*e*4/s.components*s.byteLength;case rl:case ol:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case al:case ll:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case yh:case bh:return Math.max(i,16)*Math.max(e,8)/4;case _h:case vh:return Math.max(i,8)*Math.max(e,8)/2;case Mh:case Sh:case Eh:case Th:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case wh:case cl:case Ah:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Rh:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Ch:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case Ph:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case Ih:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case Lh:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case Dh:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case Nh:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case Uh:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case Oh:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case Fh:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case kh:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case Bh:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case zh:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case Hh:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case Gh:case Vh:case Wh:return Math.ceil(i/4)*Math.ceil(e/4)*16;case Xh:case qh:return Math.ceil(i/4)*Math.ceil(e/4)*8;case hl:case Yh:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function zb(i){switch(i){case ci:case xf:return{byteLength:1,components:1};case $o:case _f:case Yi:return{byteLength:2,components:1};case fh:case ph:return{byteLength:2,components:4};case Xi:case dh:case qi:return{byteLength:4,components:1};case yf:case vf:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Ke("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function lx(){let i=null,e=!1,t=null,n=null;function s(r,o){n=i.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&i!==null&&(n=i.requestAnimationFrame(s),e=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){i=r}}}function qb(i){let e=new WeakMap;function t(a,l){let c=a.array,h=a.usage,d=c.byteLength,u=i.createBuffer();i.bindBuffer(l,u),i.bufferData(l,c,h),a.onUploadCallback();let f;if(c instanceof Float32Array)f=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=i.HALF_FLOAT:f=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=i.SHORT;else if(c instanceof Uint32Array)f=i.UNSIGNED_INT;else if(c instanceof Int32Array)f=i.INT;else if(c instanceof Int8Array)f=i.BYTE;else if(c instanceof Uint8Array)f=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:u,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:d}}function n(a,l,c){let h=l.array,d=l.updateRanges;if(i.bindBuffer(c,a),d.length===0)i.bufferSubData(c,0,h);else{d.sort((f,p)=>f.start-p.start);let u=0;for(let f=1;f<d.length;f++){let p=d[u],v=d[f];v.start<=p.start+p.count+1?p.count=Math.max(p.count,v.start+v.count-p.start):(++u,d[u]=v)}d.length=u+1;for(let f=0,p=d.length;f<p;f++){let v=d[f];i.bufferSubData(c,v.start*h.BYTES_PER_ELEMENT,h,v.start,v.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(i.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=e.get(a);(!h||h.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var Yb=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,Zb=`#ifdef USE_ALPHAHASH
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
#endif`,$b=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,Kb=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,jb=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,Jb=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,Qb=`#ifdef USE_AOMAP
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
#endif`,eM=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,tM=`#ifdef USE_BATCHING
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
#endif`,nM=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,iM=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,sM=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,rM=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,oM=`#ifdef USE_IRIDESCENCE
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
#endif`,aM=`#ifdef USE_BUMPMAP
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
#endif`,lM=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,cM=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,hM=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,uM=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,dM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,fM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,pM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,mM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,gM=`#define PI 3.141592653589793
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
} // validated`,xM=`vec3 transformedNormal = objectNormal;
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
#endif`,_M=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,yM=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,vM=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,bM=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,MM="gl_FragColor = linearToOutputTexel( gl_FragColor );",SM=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,wM=`#ifdef USE_ENVMAP
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
#endif`,EM=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,TM=`#ifdef USE_ENVMAP
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
#endif`,AM=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,RM=`#ifdef USE_ENVMAP
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
#endif`,CM=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,PM=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,IM=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,LM=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,DM=`#ifdef USE_GRADIENTMAP
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
}`,NM=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,UM=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,OM=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,FM=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,kM=`#ifdef USE_ENVMAP
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
#endif`,BM=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,zM=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,HM=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,GM=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,VM=`PhysicalMaterial material;
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
#endif`,WM=`uniform sampler2D dfgLUT;
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
}`,XM=`
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
#endif`,qM=`#if defined( RE_IndirectDiffuse )
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
#endif`,YM=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,ZM=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,$M=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,KM=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,jM=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,JM=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,QM=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,eS=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,tS=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,nS=`#if defined( USE_POINTS_UV )
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
#endif`,iS=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,sS=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,rS=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,oS=`#if defined( USE_MORPHCOLORS )
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
#endif`,aS=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,lS=`#ifdef USE_MORPHTARGETS
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
#endif`,cS=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,hS=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,uS=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,dS=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,fS=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,pS=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,mS=`#ifdef USE_NORMALMAP
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
#endif`,gS=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,xS=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,_S=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,yS=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,vS=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,bS=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,MS=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,SS=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,wS=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,ES=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,TS=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,AS=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,RS=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,CS=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,PS=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,IS=`float getShadowMask() {
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
}`,LS=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,DS=`#ifdef USE_SKINNING
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
#endif`,NS=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,US=`#ifdef USE_SKINNING
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
#endif`,OS=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,FS=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,kS=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,BS=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,zS=`#ifdef USE_TRANSMISSION
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
#endif`,HS=`#ifdef USE_TRANSMISSION
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
#endif`,GS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,VS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,WS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,XS=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,qS=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,YS=`uniform sampler2D t2D;
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
}`,ZS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,$S=`uniform float backgroundBlurriness;
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
}`,KS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,jS=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,JS=`#include <common>
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
}`,QS=`#if DEPTH_PACKING == 3200
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
}`,ew=`#define DISTANCE
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
}`,tw=`#define DISTANCE
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
}`,nw=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,iw=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,sw=`uniform float scale;
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
}`,rw=`uniform vec3 diffuse;
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
}`,ow=`#include <common>
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
}`,aw=`uniform vec3 diffuse;
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
}`,lw=`#define LAMBERT
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
}`,cw=`#define LAMBERT
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
}`,hw=`#define MATCAP
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
}`,uw=`#define MATCAP
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
}`,dw=`#define NORMAL
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
}`,fw=`#define NORMAL
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
}`,pw=`#define PHONG
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
}`,mw=`#define PHONG
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
}`,gw=`#define STANDARD
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
}`,xw=`#define STANDARD
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
}`,_w=`#define TOON
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
}`,yw=`#define TOON
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
}`,vw=`uniform float size;
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
}`,bw=`uniform vec3 diffuse;
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
}`,Mw=`#include <common>
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
}`,Sw=`uniform vec3 color;
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
}`,ww=`uniform float rotation;
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
}`,Ew=`uniform vec3 diffuse;
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
}`,ft={alphahash_fragment:Yb,alphahash_pars_fragment:Zb,alphamap_fragment:$b,alphamap_pars_fragment:Kb,alphatest_fragment:jb,alphatest_pars_fragment:Jb,aomap_fragment:Qb,aomap_pars_fragment:eM,batching_pars_vertex:tM,batching_vertex:nM,begin_vertex:iM,beginnormal_vertex:sM,bsdfs:rM,iridescence_fragment:oM,bumpmap_pars_fragment:aM,clipping_planes_fragment:lM,clipping_planes_pars_fragment:cM,clipping_planes_pars_vertex:hM,clipping_planes_vertex:uM,color_fragment:dM,color_pars_fragment:fM,color_pars_vertex:pM,color_vertex:mM,common:gM,defaultnormal_vertex:xM,displacementmap_pars_vertex:_M,displacementmap_vertex:yM,emissivemap_fragment:vM,emissivemap_pars_fragment:bM,colorspace_fragment:MM,colorspace_pars_fragment:SM,envmap_fragment:wM,envmap_common_pars_fragment:EM,envmap_pars_fragment:TM,envmap_pars_vertex:AM,envmap_physical_pars_fragment:kM,envmap_vertex:RM,fog_vertex:CM,fog_pars_vertex:PM,fog_fragment:IM,fog_pars_fragment:LM,gradientmap_pars_fragment:DM,lightmap_pars_fragment:NM,lights_lambert_fragment:UM,lights_lambert_pars_fragment:OM,lights_pars_begin:FM,lights_toon_fragment:BM,lights_toon_pars_fragment:zM,lights_phong_fragment:HM,lights_phong_pars_fragment:GM,lights_physical_fragment:VM,lights_physical_pars_fragment:WM,lights_fragment_begin:XM,lights_fragment_maps:qM,lights_fragment_end:YM,lightprobes_pars_fragment:ZM,logdepthbuf_fragment:$M,logdepthbuf_pars_fragment:KM,logdepthbuf_pars_vertex:jM,logdepthbuf_vertex:JM,map_fragment:QM,map_pars_fragment:eS,map_particle_fragment:tS,map_particle_pars_fragment:nS,metalnessmap_fragment:iS,metalnessmap_pars_fragment:sS,morphinstance_vertex:rS,morphcolor_vertex:oS,morphnormal_vertex:aS,morphtarget_pars_vertex:lS,morphtarget_vertex:cS,normal_fragment_begin:hS,normal_fragment_maps:uS,normal_pars_fragment:dS,normal_pars_vertex:fS,normal_vertex:pS,normalmap_pars_fragment:mS,clearcoat_normal_fragment_begin:gS,clearcoat_normal_fragment_maps:xS,clearcoat_pars_fragment:_S,iridescence_pars_fragment:yS,opaque_fragment:vS,packing:bS,premultiplied_alpha_fragment:MS,project_vertex:SS,dithering_fragment:wS,dithering_pars_fragment:ES,roughnessmap_fragment:TS,roughnessmap_pars_fragment:AS,shadowmap_pars_fragment:RS,shadowmap_pars_vertex:CS,shadowmap_vertex:PS,shadowmask_pars_fragment:IS,skinbase_vertex:LS,skinning_pars_vertex:DS,skinning_vertex:NS,skinnormal_vertex:US,specularmap_fragment:OS,specularmap_pars_fragment:FS,tonemapping_fragment:kS,tonemapping_pars_fragment:BS,transmission_fragment:zS,transmission_pars_fragment:HS,uv_pars_fragment:GS,uv_pars_vertex:VS,uv_vertex:WS,worldpos_vertex:XS,background_vert:qS,background_frag:YS,backgroundCube_vert:ZS,backgroundCube_frag:$S,cube_vert:KS,cube_frag:jS,depth_vert:JS,depth_frag:QS,distance_vert:ew,distance_frag:tw,equirect_vert:nw,equirect_frag:iw,linedashed_vert:sw,linedashed_frag:rw,meshbasic_vert:ow,meshbasic_frag:aw,meshlambert_vert:lw,meshlambert_frag:cw,meshmatcap_vert:hw,meshmatcap_frag:uw,meshnormal_vert:dw,meshnormal_frag:fw,meshphong_vert:pw,meshphong_frag:mw,meshphysical_vert:gw,meshphysical_frag:xw,meshtoon_vert:_w,meshtoon_frag:yw,points_vert:vw,points_frag:bw,shadow_vert:Mw,shadow_frag:Sw,sprite_vert:ww,sprite_frag:Ew},Ue={common:{diffuse:{value:new Je(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new st},alphaMap:{value:null},alphaMapTransform:{value:new st},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new st}},envmap:{envMap:{value:null},envMapRotation:{value:new st},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new st}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new st}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new st},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new st},normalScale:{value:new We(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new st},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new st}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new st}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new st}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Je(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Je(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new st},alphaTest:{value:0},uvTransform:{value:new st}},sprite:{diffuse:{value:new Je(16777215)},opacity:{value:1},center:{value:new We(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new st},alphaMap:{value:null},alphaMapTransform:{value:new st},alphaTest:{value:0}}},ds={basic:{uniforms:Zn([Ue.common,Ue.specularmap,Ue.envmap,Ue.aomap,Ue.lightmap,Ue.fog]),vertexShader:ft.meshbasic_vert,fragmentShader:ft.meshbasic_frag},lambert:{uniforms:Zn([Ue.common,Ue.specularmap,Ue.envmap,Ue.aomap,Ue.lightmap,Ue.emissivemap,Ue.bumpmap,Ue.normalmap,Ue.displacementmap,Ue.fog,Ue.lights,{emissive:{value:new Je(0)},envMapIntensity:{value:1}}]),vertexShader:ft.meshlambert_vert,fragmentShader:ft.meshlambert_frag},phong:{uniforms:Zn([Ue.common,Ue.specularmap,Ue.envmap,Ue.aomap,Ue.lightmap,Ue.emissivemap,Ue.bumpmap,Ue.normalmap,Ue.displacementmap,Ue.fog,Ue.lights,{emissive:{value:new Je(0)},specular:{value:new Je(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:ft.meshphong_vert,fragmentShader:ft.meshphong_frag},standard:{uniforms:Zn([Ue.common,Ue.envmap,Ue.aomap,Ue.lightmap,Ue.emissivemap,Ue.bumpmap,Ue.normalmap,Ue.displacementmap,Ue.roughnessmap,Ue.metalnessmap,Ue.fog,Ue.lights,{emissive:{value:new Je(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ft.meshphysical_vert,fragmentShader:ft.meshphysical_frag},toon:{uniforms:Zn([Ue.common,Ue.aomap,Ue.lightmap,Ue.emissivemap,Ue.bumpmap,Ue.normalmap,Ue.displacementmap,Ue.gradientmap,Ue.fog,Ue.lights,{emissive:{value:new Je(0)}}]),vertexShader:ft.meshtoon_vert,fragmentShader:ft.meshtoon_frag},matcap:{uniforms:Zn([Ue.common,Ue.bumpmap,Ue.normalmap,Ue.displacementmap,Ue.fog,{matcap:{value:null}}]),vertexShader:ft.meshmatcap_vert,fragmentShader:ft.meshmatcap_frag},points:{uniforms:Zn([Ue.points,Ue.fog]),vertexShader:ft.points_vert,fragmentShader:ft.points_frag},dashed:{uniforms:Zn([Ue.common,Ue.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ft.linedashed_vert,fragmentShader:ft.linedashed_frag},depth:{uniforms:Zn([Ue.common,Ue.displacementmap]),vertexShader:ft.depth_vert,fragmentShader:ft.depth_frag},normal:{uniforms:Zn([Ue.common,Ue.bumpmap,Ue.normalmap,Ue.displacementmap,{opacity:{value:1}}]),vertexShader:ft.meshnormal_vert,fragmentShader:ft.meshnormal_frag},sprite:{uniforms:Zn([Ue.sprite,Ue.fog]),vertexShader:ft.sprite_vert,fragmentShader:ft.sprite_frag},background:{uniforms:{uvTransform:{value:new st},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ft.background_vert,fragmentShader:ft.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new st}},vertexShader:ft.backgroundCube_vert,fragmentShader:ft.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ft.cube_vert,fragmentShader:ft.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ft.equirect_vert,fragmentShader:ft.equirect_frag},distance:{uniforms:Zn([Ue.common,Ue.displacementmap,{referencePosition:{value:new U},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ft.distance_vert,fragmentShader:ft.distance_frag},shadow:{uniforms:Zn([Ue.lights,Ue.fog,{color:{value:new Je(0)},opacity:{value:1}}]),vertexShader:ft.shadow_vert,fragmentShader:ft.shadow_frag}};ds.physical={uniforms:Zn([ds.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new st},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new st},clearcoatNormalScale:{value:new We(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new st},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new st},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new st},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new st},sheen:{value:0},sheenColor:{value:new Je(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new st},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new st},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new st},transmissionSamplerSize:{value:new We},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new st},attenuationDistance:{value:0},attenuationColor:{value:new Je(0)},specularColor:{value:new Je(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new st},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new st},anisotropyVector:{value:new We},anisotropyMap:{value:null},anisotropyMapTransform:{value:new st}}]),vertexShader:ft.meshphysical_vert,fragmentShader:ft.meshphysical_frag};var Kh={r:0,b:0,g:0},Tw=new yt,cx=new st;cx.set(-1,0,0,0,1,0,0,0,1);function Aw(i,e,t,n,s,r){let o=new Je(0),a=s===!0?0:1,l,c,h=null,d=0,u=null;function f(_){let T=_.isScene===!0?_.background:null;if(T&&T.isTexture){let M=_.backgroundBlurriness>0;T=e.get(T,M)}return T}function p(_){let T=!1,M=f(_);M===null?g(o,a):M&&M.isColor&&(g(M,1),T=!0);let C=i.xr.getEnvironmentBlendMode();C==="additive"?t.buffers.color.setClear(0,0,0,1,r):C==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(i.autoClear||T)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function v(_,T){let M=f(T);M&&M.isCubeTexture?(c===void 0&&(c=new De(new Vt(1,1,1),new ls({name:"BackgroundCubeMaterial",uniforms:kr(ds.backgroundCube.uniforms),vertexShader:ds.backgroundCube.vertexShader,fragmentShader:ds.backgroundCube.fragmentShader,side:Gn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(C,S,x){this.matrixWorld.copyPosition(x.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=M,c.material.uniforms.backgroundBlurriness.value=T.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=T.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(Tw.makeRotationFromEuler(T.backgroundRotation)).transpose(),M.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(cx),c.material.toneMapped=Mt.getTransfer(M.colorSpace)!==It,(h!==M||d!==M.version||u!==i.toneMapping)&&(c.material.needsUpdate=!0,h=M,d=M.version,u=i.toneMapping),c.layers.enableAll(),_.unshift(c,c.geometry,c.material,0,0,null)):M&&M.isTexture&&(l===void 0&&(l=new De(new Ls(2,2),new ls({name:"BackgroundMaterial",uniforms:kr(ds.background.uniforms),vertexShader:ds.background.vertexShader,fragmentShader:ds.background.fragmentShader,side:cs,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=M,l.material.uniforms.backgroundIntensity.value=T.backgroundIntensity,l.material.toneMapped=Mt.getTransfer(M.colorSpace)!==It,M.matrixAutoUpdate===!0&&M.updateMatrix(),l.material.uniforms.uvTransform.value.copy(M.matrix),(h!==M||d!==M.version||u!==i.toneMapping)&&(l.material.needsUpdate=!0,h=M,d=M.version,u=i.toneMapping),l.layers.enableAll(),_.unshift(l,l.geometry,l.material,0,0,null))}function g(_,T){_.getRGB(Kh,Nf(i)),t.buffers.color.setClear(Kh.r,Kh.g,Kh.b,T,r)}function m(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(_,T=1){o.set(_),a=T,g(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(_){a=_,g(o,a)},render:p,addToRenderList:v,dispose:m}}function Rw(i,e){let t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=u(null),r=s,o=!1;function a(D,z,W,N,V){let Z=!1,G=d(D,N,W,z);r!==G&&(r=G,c(r.object)),Z=f(D,N,W,V),Z&&p(D,N,W,V),V!==null&&e.update(V,i.ELEMENT_ARRAY_BUFFER),(Z||o)&&(o=!1,M(D,z,W,N),V!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get(V).buffer))}function l(){return i.createVertexArray()}function c(D){return i.bindVertexArray(D)}function h(D){return i.deleteVertexArray(D)}function d(D,z,W,N){let V=N.wireframe===!0,Z=n[z.id];Z===void 0&&(Z={},n[z.id]=Z);let G=D.isInstancedMesh===!0?D.id:0,ce=Z[G];ce===void 0&&(ce={},Z[G]=ce);let Y=ce[W.id];Y===void 0&&(Y={},ce[W.id]=Y);let Q=Y[V];return Q===void 0&&(Q=u(l()),Y[V]=Q),Q}function u(D){let z=[],W=[],N=[];for(let V=0;V<t;V++)z[V]=0,W[V]=0,N[V]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:z,enabledAttributes:W,attributeDivisors:N,object:D,attributes:{},index:null}}function f(D,z,W,N){let V=r.attributes,Z=z.attributes,G=0,ce=W.getAttributes();for(let Y in ce)if(ce[Y].location>=0){let ie=V[Y],de=Z[Y];if(de===void 0&&(Y==="instanceMatrix"&&D.instanceMatrix&&(de=D.instanceMatrix),Y==="instanceColor"&&D.instanceColor&&(de=D.instanceColor)),ie===void 0||ie.attribute!==de||de&&ie.data!==de.data)return!0;G++}return r.attributesNum!==G||r.index!==N}function p(D,z,W,N){let V={},Z=z.attributes,G=0,ce=W.getAttributes();for(let Y in ce)if(ce[Y].location>=0){let ie=Z[Y];ie===void 0&&(Y==="instanceMatrix"&&D.instanceMatrix&&(ie=D.instanceMatrix),Y==="instanceColor"&&D.instanceColor&&(ie=D.instanceColor));let de={};de.attribute=ie,ie&&ie.data&&(de.data=ie.data),V[Y]=de,G++}r.attributes=V,r.attributesNum=G,r.index=N}function v(){let D=r.newAttributes;for(let z=0,W=D.length;z<W;z++)D[z]=0}function g(D){m(D,0)}function m(D,z){let W=r.newAttributes,N=r.enabledAttributes,V=r.attributeDivisors;W[D]=1,N[D]===0&&(i.enableVertexAttribArray(D),N[D]=1),V[D]!==z&&(i.vertexAttribDivisor(D,z),V[D]=z)}function _(){let D=r.newAttributes,z=r.enabledAttributes;for(let W=0,N=z.length;W<N;W++)z[W]!==D[W]&&(i.disableVertexAttribArray(W),z[W]=0)}function T(D,z,W,N,V,Z,G){G===!0?i.vertexAttribIPointer(D,z,W,V,Z):i.vertexAttribPointer(D,z,W,N,V,Z)}function M(D,z,W,N){v();let V=N.attributes,Z=W.getAttributes(),G=z.defaultAttributeValues;for(let ce in Z){let Y=Z[ce];if(Y.location>=0){let Q=V[ce];if(Q===void 0&&(ce==="instanceMatrix"&&D.instanceMatrix&&(Q=D.instanceMatrix),ce==="instanceColor"&&D.instanceColor&&(Q=D.instanceColor)),Q!==void 0){let ie=Q.normalized,de=Q.itemSize,fe=e.get(Q);if(fe===void 0)continue;let ee=fe.buffer,ge=fe.type,ye=fe.bytesPerElement,Re=ge===i.INT||ge===i.UNSIGNED_INT||Q.gpuType===dh;if(Q.isInterleavedBufferAttribute){let Se=Q.data,Ye=Se.isInterleavedBuffer===!0?Se.stride:Se.itemSize,at=Q.offset;if(Se.isInstancedInterleavedBuffer||Se.isInstancedBufferAttribute){for(let Xe=0;Xe<Y.locationSize;Xe++)m(Y.location+Xe,Se.meshPerAttribute);D.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=Se.meshPerAttribute*Se.count)}else for(let Xe=0;Xe<Y.locationSize;Xe++)g(Y.location+Xe);i.bindBuffer(i.ARRAY_BUFFER,ee);for(let Xe=0;Xe<Y.locationSize;Xe++)T(Y.location+Xe,de/Y.locationSize,ge,ie,Ye*ye,(at+de/Y.locationSize*Xe)*ye,Re)}else{if(Q.isInstancedBufferAttribute){for(let Se=0;Se<Y.locationSize;Se++)m(Y.location+Se,Q.meshPerAttribute);D.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let Se=0;Se<Y.locationSize;Se++)g(Y.location+Se);i.bindBuffer(i.ARRAY_BUFFER,ee);for(let Se=0;Se<Y.locationSize;Se++)T(Y.location+Se,de/Y.locationSize,ge,ie,de*ye,de/Y.locationSize*Se*ye,Re)}}else if(G!==void 0){let ie=G[ce];if(ie!==void 0)switch(ie.length){case 2:i.vertexAttrib2fv(Y.location,ie);break;case 3:i.vertexAttrib3fv(Y.location,ie);break;case 4:i.vertexAttrib4fv(Y.location,ie);break;default:i.vertexAttrib1fv(Y.location,ie)}}}}_()}function C(){O();for(let D in n){let z=n[D];for(let W in z){let N=z[W];for(let V in N){let Z=N[V];for(let G in Z)h(Z[G].object),delete Z[G];delete N[V]}}delete n[D]}}function S(D){if(n[D.id]===void 0)return;let z=n[D.id];for(let W in z){let N=z[W];for(let V in N){let Z=N[V];for(let G in Z)h(Z[G].object),delete Z[G];delete N[V]}}delete n[D.id]}function x(D){for(let z in n){let W=n[z];for(let N in W){let V=W[N];if(V[D.id]===void 0)continue;let Z=V[D.id];for(let G in Z)h(Z[G].object),delete Z[G];delete V[D.id]}}}function E(D){for(let z in n){let W=n[z],N=D.isInstancedMesh===!0?D.id:0,V=W[N];if(V!==void 0){for(let Z in V){let G=V[Z];for(let ce in G)h(G[ce].object),delete G[ce];delete V[Z]}delete W[N],Object.keys(W).length===0&&delete n[z]}}}function O(){P(),o=!0,r!==s&&(r=s,c(r.object))}function P(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:O,resetDefaultState:P,dispose:C,releaseStatesOfGeometry:S,releaseStatesOfObject:E,releaseStatesOfProgram:x,initAttributes:v,enableAttribute:g,disableUnusedAttributes:_}}function Cw(i,e,t){let n;function s(l){n=l}function r(l,c){i.drawArrays(n,l,c),t.update(c,n,1)}function o(l,c,h){h!==0&&(i.drawArraysInstanced(n,l,c,h),t.update(c,n,h))}function a(l,c,h){if(h===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,h);let u=0;for(let f=0;f<h;f++)u+=c[f];t.update(u,n,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function Pw(i,e,t,n){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let x=e.get("EXT_texture_filter_anisotropic");s=i.getParameter(x.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(x){return!(x!==Zi&&n.convert(x)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(x){let E=x===Yi&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(x!==ci&&x!==qi&&!E&&n.convert(x)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(x){if(x==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";x="mediump"}return x==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",h=l(c);h!==c&&(Ke("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let d=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),u=t.logarithmicDepthBuffer===!0&&d===!1;t.reversedDepthBuffer===!0&&d===!1&&Ke("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&d===!0&&Ke("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),p=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),v=i.getParameter(i.MAX_TEXTURE_SIZE),g=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),m=i.getParameter(i.MAX_VERTEX_ATTRIBS),_=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),T=i.getParameter(i.MAX_VARYING_VECTORS),M=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),C=i.getParameter(i.MAX_SAMPLES),S=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:u,reversedDepthBuffer:d,maxTextures:f,maxVertexTextures:p,maxTextureSize:v,maxCubemapSize:g,maxAttributes:m,maxVertexUniforms:_,maxVaryings:T,maxFragmentUniforms:M,maxSamples:C,samples:S}}function Iw(i){let e=this,t=null,n=0,s=!1,r=!1,o=new ni,a=new st,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(d,u){let f=d.length!==0||u||n!==0||s;return s=u,n=d.length,f},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(d,u){t=h(d,u,0)},this.setState=function(d,u,f){let p=d.clippingPlanes,v=d.clipIntersection,g=d.clipShadows,m=i.get(d);if(!s||p===null||p.length===0||r&&!g)r?h(null):c();else{let _=r?0:n,T=_*4,M=m.clippingState||null;l.value=M,M=h(p,u,T,f);for(let C=0;C!==T;++C)M[C]=t[C];m.clippingState=M,this.numIntersection=v?this.numPlanes:0,this.numPlanes+=_}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}function h(d,u,f,p){let v=d!==null?d.length:0,g=null;if(v!==0){if(g=l.value,p!==!0||g===null){let m=f+v*4,_=u.matrixWorldInverse;a.getNormalMatrix(_),(g===null||g.length<m)&&(g=new Float32Array(m));for(let T=0,M=f;T!==v;++T,M+=4)o.copy(d[T]).applyMatrix4(_,a),o.normal.toArray(g,M),g[M+3]=o.constant}l.value=g,l.needsUpdate=!0}return e.numPlanes=v,e.numIntersection=0,g}}var pl=class extends vi{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},s=[n,n,n,n,n,n];this.texture=new Xa(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new Vt(5,5,5),r=new ls({name:"CubemapFromEquirect",uniforms:kr(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:Gn,blending:Nr});r.uniforms.tEquirect.value=t;let o=new De(s,r),a=t.minFilter;return t.minFilter===Ns&&(t.minFilter=si),new Vo(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,n=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,n,s);e.setRenderTarget(r)}},H0=256,Lw=3,Dw=20,hx=256,ux=16,Nw=3,Uw=new U,Ow=new Je,Jh=class i{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Vo(1,10,null),this._boxMesh=new De(new Vt(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,n=.1,s=100,r={}){let{size:o=256,position:a=Uw}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),h=this._getSourceTarget(!0);t>0&&(h.texture.mipmapsAutoUpdate=!1);let d=l.autoClear,u=l.autoClearColor,f=l.autoClearDepth,p=l.autoClearStencil,v=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,v===null&&(e.background=l.getClearColor(Ow));let g=new Vo(n,s,h);return g.position.copy(a),g.update(l,e),l.autoClear=d,l.autoClearColor=u,l.autoClearDepth=f,l.autoClearStencil=p,e.background=v,t>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=W0(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=V0(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(H0,If(e))}_fromTexture(e,t){e.mapping===Or||e.mapping===Yo?this._setSize(e.image.length===0?H0:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let n=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(n),n}_allocateTarget(){let e=this._cubeSize,t=G0(e,!1,!1),n=Math.log2(e)-Lw;for(let s=0;s<=n;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==t||e&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=G0(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===Or||e.mapping===Yo?(this._cubemapMaterial===null&&(this._cubemapMaterial=W0()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=V0()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=Fw(),this._integrationMaterial=kw());let t=this._cubeSize,n=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/ux);for(let o=0;o<=n;o++){let a=i.lodToRoughness(o,n);if(o>n-Nw)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(hx*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=Bw());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,n),s.envMap.value=e.texture,this._renderCube(r,0,n)}};function G0(i,e,t){return new pl(i,{minFilter:Ns,generateMipmaps:e,type:Yi,colorSpace:La,depthBuffer:t})}function ml(i,e,t){return new ls({name:i,uniforms:e,vertexShader:ft.cube_vert,fragmentShader:t,side:Gn,blending:Nr,depthTest:!1,depthWrite:!1})}function Fw(){return ml("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${hx}u

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
	`)}function kw(){return ml("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:ux}},`

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
	`)}function Bw(){return ml("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${Dw}
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
	`)}function V0(){return ml("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function W0(){return ml("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function zw(i){let e=new WeakMap,t=new WeakMap,n=null;function s(u,f=!1){return u==null?null:f?o(u):r(u)}function r(u){if(u&&u.isTexture){let f=u.mapping;if(f===hh||f===uh)if(e.has(u)){let p=e.get(u).texture;return a(p,u.mapping)}else{let p=u.image;if(p&&p.height>0){let v=new pl(p.height);return v.fromEquirectangularTexture(i,u),e.set(u,v),u.addEventListener("dispose",c),a(v.texture,u.mapping)}else return null}}return u}function o(u){if(u&&u.isTexture&&u.isPMREMTexture!==!0){let f=u.mapping,p=f===hh||f===uh,v=f===Or||f===Yo;if(p||v){let g=t.get(u),m=g!==void 0?g.texture.pmremVersion:0;if(u.isRenderTargetTexture&&u.pmremVersion!==m)return n===null&&(n=new Jh(i)),g=p?n.fromEquirectangular(u,g):n.fromCubemap(u,g),g.texture.pmremVersion=u.pmremVersion,t.set(u,g),g.texture;if(g!==void 0)return g.texture;{let _=u.image;return p&&_&&_.height>0||v&&_&&l(_)?(n===null&&(n=new Jh(i)),g=p?n.fromEquirectangular(u):n.fromCubemap(u),g.texture.pmremVersion=u.pmremVersion,t.set(u,g),u.addEventListener("dispose",h),g.texture):null}}}return u}function a(u,f){return f===hh?u.mapping=Or:f===uh&&(u.mapping=Yo),u}function l(u){let f=0,p=6;for(let v=0;v<p;v++)u[v]!==void 0&&f++;return f===p}function c(u){let f=u.target;f.removeEventListener("dispose",c);let p=e.get(f);p!==void 0&&(e.delete(f),p.dispose())}function h(u){let f=u.target;f.removeEventListener("dispose",h);let p=t.get(f);p!==void 0&&(t.delete(f),p.dispose())}function d(){e=new WeakMap,t=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:d}}function Hw(i){let e={};function t(n){if(e[n]!==void 0)return e[n];let s=i.getExtension(n);return e[n]=s,s}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){let s=t(n);return s===null&&Ca("WebGLRenderer: "+n+" extension not supported."),s}}}function Gw(i,e,t,n){let s={},r=new WeakMap,o=new FinalizationRegistry(p=>delete s[p]);function a(p){l(p.target)}function l(p){p.index!==null&&e.remove(p.index);for(let g in p.attributes)e.remove(p.attributes[g]);p.removeEventListener("dispose",a),delete s[p.id],o.unregister(p);let v=r.get(p);v&&(e.remove(v),r.delete(p)),n.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,t.memory.geometries--}function c(p,v){return s[v.id]!==void 0||(v.addEventListener("dispose",a),s[v.id]=new WeakRef(v),o.register(v,v.id,v),t.memory.geometries++),v}function h(p){let v=p.attributes;for(let g in v)e.update(v[g],i.ARRAY_BUFFER)}function d(p){let v=p.index,g=p.attributes.position,m=0;if(g===void 0)return;let _=v!==null?v.array.length:g.array.length/3-1,T=g.count>=65535?za:Ba,M=new T(Math.ceil(_/3)*6,1),C=M.array;if(v!==null){let x=v.array;m=v.version;for(let E=0,O=0;E<_;E+=3){let P=x[E+0],D=x[E+1],z=x[E+2];C[O++]=P,C[O++]=D,C[O++]=D,C[O++]=z,C[O++]=z,C[O++]=P}}else{m=g.version;for(let x=0,E=0;x<_;x+=3){let O=x+0,P=x+1,D=x+2;C[E++]=O,C[E++]=P,C[E++]=P,C[E++]=D,C[E++]=D,C[E++]=O}}M.version=m;let S=r.get(p);S&&e.remove(S),r.set(p,M)}function u(p){let v=r.get(p);if(v){let g=p.index;g!==null&&v.version<g.version&&d(p)}else d(p);return r.get(p)}function f(){for(let p in s){let v=s[p].deref();v!==void 0&&l(v)}}return{get:c,update:h,getWireframeAttribute:u,dispose:f}}function Vw(i,e,t){let n;function s(d){n=d}let r,o;function a(d){r=d.type,o=d.bytesPerElement}function l(d,u){i.drawElements(n,u,r,d*o),t.update(u,n,1)}function c(d,u,f){f!==0&&(i.drawElementsInstanced(n,u,r,d*o,f),t.update(u,n,f))}function h(d,u,f){if(f===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,u,0,r,d,0,f);let v=0;for(let g=0;g<f;g++)v+=u[g];t.update(v,n,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function Ww(i){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(t.calls++,o){case i.TRIANGLES:t.triangles+=a*(r/3);break;case i.LINES:t.lines+=a*(r/2);break;case i.LINE_STRIP:t.lines+=a*(r-1);break;case i.LINE_LOOP:t.lines+=a*r;break;case i.POINTS:t.points+=a*r;break;default:et("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:n}}function Xw(i,e,t){let n=new WeakMap,s=new tn;function r(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,d=h!==void 0?h.length:0,u=n.get(a);if(u===void 0||u.count!==d){let O=function(){x.dispose(),n.delete(a),a.removeEventListener("dispose",O)};u!==void 0&&u.texture.dispose();let f=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,v=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],m=a.morphAttributes.normal||[],_=a.morphAttributes.color||[],T=0;f===!0&&(T=1),p===!0&&(T=2),v===!0&&(T=3);let M=a.attributes.position.count*T,C=1;M>e.maxTextureSize&&(C=Math.ceil(M/e.maxTextureSize),M=e.maxTextureSize);let S=new Float32Array(M*C*4*d),x=new Oa(S,M,C,d);x.type=qi,x.needsUpdate=!0;let E=T*4;for(let P=0;P<d;P++){let D=g[P],z=m[P],W=_[P],N=M*C*4*P;for(let V=0;V<D.count;V++){let Z=V*E;f===!0&&(s.fromBufferAttribute(D,V),S[N+Z+0]=s.x,S[N+Z+1]=s.y,S[N+Z+2]=s.z,S[N+Z+3]=0),p===!0&&(s.fromBufferAttribute(z,V),S[N+Z+4]=s.x,S[N+Z+5]=s.y,S[N+Z+6]=s.z,S[N+Z+7]=0),v===!0&&(s.fromBufferAttribute(W,V),S[N+Z+8]=s.x,S[N+Z+9]=s.y,S[N+Z+10]=s.z,S[N+Z+11]=W.itemSize===4?s.w:1)}}u={count:d,texture:x,size:new We(M,C)},n.set(a,u),a.addEventListener("dispose",O)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,t);else{let f=0;for(let v=0;v<c.length;v++)f+=c[v];let p=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(i,"morphTargetBaseInfluence",p),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",u.texture,t),l.getUniforms().setValue(i,"morphTargetsTextureSize",u.size)}return{update:r}}function qw(i,e,t,n,s){let r=new WeakMap;function o(c){let h=s.render.frame,d=c.geometry,u=e.get(c,d);if(r.get(u)!==h&&(e.update(u),r.set(u,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(t.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,i.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==h&&(f.update(),r.set(f,h))}return u}function a(){r=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),n.releaseStatesOfObject(h),t.remove(h.instanceMatrix),h.instanceColor!==null&&t.remove(h.instanceColor)}return{update:o,dispose:a}}var Yw={[hf]:"LINEAR_TONE_MAPPING",[uf]:"REINHARD_TONE_MAPPING",[df]:"CINEON_TONE_MAPPING",[ff]:"ACES_FILMIC_TONE_MAPPING",[mf]:"AGX_TONE_MAPPING",[il]:"NEUTRAL_TONE_MAPPING",[pf]:"CUSTOM_TONE_MAPPING"};function Zw(i,e,t,n,s,r){let o=new vi(e,t,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,h=new Lt;h.setAttribute("position",new wt([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new wt([0,2,0,0,2,0],2));let d=new Zc({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),u=new De(h,d),f=new nl(-1,1,1,-1,0,1),p=null,v=null,g=!1,m,_=null,T=[],M=!1;this.setSize=function(C,S){o.setSize(C,S),a!==null&&a.setSize(C,S),l!==null&&l.setSize(C,S);for(let x=0;x<T.length;x++){let E=T[x];E.setSize&&E.setSize(C,S)}},this.setEffects=function(C){T=C,M=T.length>0&&T[0].isRenderPass===!0;let S=o.width,x=o.height;T.length>0&&a===null&&(a=new vi(S,x,{type:Yi,depthBuffer:!1,stencilBuffer:!1}),l=new vi(S,x,{type:Yi,depthBuffer:!1,stencilBuffer:!1}));let E=s===!0&&T.some(O=>O.needsDepthTexture===!0);E!==(o.depthTexture!==null)&&(E===!0&&c===null&&(c=new Is(S,x),r===!0&&(c.format=Us,c.type=Fr)),o.dispose(),o.depthTexture=E?c:null,o.resolveDepthBuffer=E,o.storeMultisampledDepthBuffer=E);for(let O=0;O<T.length;O++){let P=T[O];P.setSize&&P.setSize(S,x),E&&P.needsDepthTexture===!0&&P.setDepthTexture&&P.setDepthTexture(c)}},this.begin=function(C,S){if(g||C.toneMapping===hs&&T.length===0)return!1;if(_=S,S!==null){let x=S.width,E=S.height;(o.width!==x||o.height!==E)&&this.setSize(x,E)}return M===!1&&C.setRenderTarget(o),m=C.toneMapping,C.toneMapping=hs,!0},this.hasRenderPass=function(){return M},this.end=function(C,S){C.toneMapping=m,g=!0;let x=o,E=a;for(let O=0;O<T.length;O++){let P=T[O];P.enabled!==!1&&(P.render(C,E,x,S),P.needsSwap!==!1&&(x=E,E=E===a?l:a))}if(p!==C.outputColorSpace||v!==C.toneMapping){p=C.outputColorSpace,v=C.toneMapping,d.defines={},Mt.getTransfer(p)===It&&(d.defines.SRGB_TRANSFER="");let O=Yw[v];O&&(d.defines[O]=""),d.needsUpdate=!0}d.uniforms.tDiffuse.value=x.texture,C.setRenderTarget(_),C.render(u,f),_=null,g=!1},this.isCompositing=function(){return g},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),h.dispose(),d.dispose()}}var dx=new Hn,fx=new Is(1,1),px=new Ya(1),mx=new Oa,gx=new Gc,xx=new Xa,X0=[],q0=[],Y0=new Float32Array(16),Z0=new Float32Array(9),$0=new Float32Array(4);function jo(i,e,t){let n=i[0];if(n<=0||n>0)return i;let s=e*t,r=X0[s];if(r===void 0&&(r=new Float32Array(s),X0[s]=r),e!==0){n.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,i[o].toArray(r,a)}return r}function Rn(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function Cn(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}function eu(i,e){let t=q0[e];t===void 0&&(t=new Int32Array(e),q0[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function $w(i,e){let t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function Kw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Rn(t,e))return;i.uniform2fv(this.addr,e),Cn(t,e)}}function jw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Rn(t,e))return;i.uniform3fv(this.addr,e),Cn(t,e)}}function Jw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Rn(t,e))return;i.uniform4fv(this.addr,e),Cn(t,e)}}function Qw(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(Rn(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),Cn(t,e)}else{if(Rn(t,n))return;$0.set(n),i.uniformMatrix2fv(this.addr,!1,$0),Cn(t,n)}}function eE(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(Rn(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),Cn(t,e)}else{if(Rn(t,n))return;Z0.set(n),i.uniformMatrix3fv(this.addr,!1,Z0),Cn(t,n)}}function tE(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(Rn(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),Cn(t,e)}else{if(Rn(t,n))return;Y0.set(n),i.uniformMatrix4fv(this.addr,!1,Y0),Cn(t,n)}}function nE(i,e){let t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}function iE(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Rn(t,e))return;i.uniform2iv(this.addr,e),Cn(t,e)}}function sE(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Rn(t,e))return;i.uniform3iv(this.addr,e),Cn(t,e)}}function rE(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Rn(t,e))return;i.uniform4iv(this.addr,e),Cn(t,e)}}function oE(i,e){let t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function aE(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Rn(t,e))return;i.uniform2uiv(this.addr,e),Cn(t,e)}}function lE(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Rn(t,e))return;i.uniform3uiv(this.addr,e),Cn(t,e)}}function cE(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Rn(t,e))return;i.uniform4uiv(this.addr,e),Cn(t,e)}}function tu(i){return i.version===0&&(i.compareFunction=Tf,i.needsUpdate=!0),i}function hE(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=tu(fx):r=dx,t.setTexture2D(e||r,s)}function uE(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture3D(e||gx,s)}function dE(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=tu(px):r=xx,t.setTextureCube(e||r,s)}function fE(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture2DArray(e||mx,s)}function pE(i){switch(i){case 5126:return $w;case 35664:return Kw;case 35665:return jw;case 35666:return Jw;case 35674:return Qw;case 35675:return eE;case 35676:return tE;case 5124:case 35670:return nE;case 35667:case 35671:return iE;case 35668:case 35672:return sE;case 35669:case 35673:return rE;case 5125:return oE;case 36294:return aE;case 36295:return lE;case 36296:return cE;case 35678:case 36198:case 36298:case 36306:case 35682:return hE;case 35679:case 36299:case 36307:return uE;case 35680:case 36300:case 36308:case 36293:return dE;case 36289:case 36303:case 36311:case 36292:return fE}}function mE(i,e){i.uniform1fv(this.addr,e)}function gE(i,e){let t=jo(e,this.size,2);i.uniform2fv(this.addr,t)}function xE(i,e){let t=jo(e,this.size,3);i.uniform3fv(this.addr,t)}function _E(i,e){let t=jo(e,this.size,4);i.uniform4fv(this.addr,t)}function yE(i,e){let t=jo(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function vE(i,e){let t=jo(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function bE(i,e){let t=jo(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function ME(i,e){i.uniform1iv(this.addr,e)}function SE(i,e){i.uniform2iv(this.addr,e)}function wE(i,e){i.uniform3iv(this.addr,e)}function EE(i,e){i.uniform4iv(this.addr,e)}function TE(i,e){i.uniform1uiv(this.addr,e)}function AE(i,e){i.uniform2uiv(this.addr,e)}function RE(i,e){i.uniform3uiv(this.addr,e)}function CE(i,e){i.uniform4uiv(this.addr,e)}function PE(i,e,t){let n=this.cache,s=e.length,r=eu(t,s);Rn(n,r)||(i.uniform1iv(this.addr,r),Cn(n,r));let o;this.type===i.SAMPLER_2D_SHADOW?o=tu(fx):o=dx;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function IE(i,e,t){let n=this.cache,s=e.length,r=eu(t,s);Rn(n,r)||(i.uniform1iv(this.addr,r),Cn(n,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||gx,r[o])}function LE(i,e,t){let n=this.cache,s=e.length,r=eu(t,s);Rn(n,r)||(i.uniform1iv(this.addr,r),Cn(n,r));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=tu(px):o=xx;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function DE(i,e,t){let n=this.cache,s=e.length,r=eu(t,s);Rn(n,r)||(i.uniform1iv(this.addr,r),Cn(n,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||mx,r[o])}function NE(i){switch(i){case 5126:return mE;case 35664:return gE;case 35665:return xE;case 35666:return _E;case 35674:return yE;case 35675:return vE;case 35676:return bE;case 5124:case 35670:return ME;case 35667:case 35671:return SE;case 35668:case 35672:return wE;case 35669:case 35673:return EE;case 5125:return TE;case 36294:return AE;case 36295:return RE;case 36296:return CE;case 35678:case 36198:case 36298:case 36306:case 35682:return PE;case 35679:case 36299:case 36307:return IE;case 35680:case 36300:case 36308:case 36293:return LE;case 36289:case 36303:case 36311:case 36292:return DE}}var zf=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=pE(t.type)}},Hf=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=NE(t.type)}},Gf=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],n)}}},kf=/(\w+)(\])?(\[|\.)?/g;function K0(i,e){i.seq.push(e),i.map[e.id]=e}function UE(i,e,t){let n=i.name,s=n.length;for(kf.lastIndex=0;;){let r=kf.exec(n),o=kf.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){K0(t,c===void 0?new zf(a,i,e):new Hf(a,i,e));break}else{let d=t.map[a];d===void 0&&(d=new Gf(a),K0(t,d)),t=d}}}var Ko=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);UE(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,n,s){let r=this.map[t];r!==void 0&&r.setValue(e,n,s)}setOptional(e,t,n){let s=t[n];s!==void 0&&this.setValue(e,n,s)}static upload(e,t,n,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let n=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&n.push(o)}return n}};function j0(i,e,t){let n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}var OE=37297,FE=0;function kE(i,e){let t=i.split(`
`),n=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return n.join(`
`)}var J0=new st;function BE(i){Mt._getMatrix(J0,Mt.workingColorSpace,i);let e=`mat3( ${J0.elements.map(t=>t.toFixed(4))} )`;switch(Mt.getTransfer(i)){case Da:return[e,"LinearTransferOETF"];case It:return[e,"sRGBTransferOETF"];default:return Ke("WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function Q0(i,e,t){let n=i.getShaderParameter(e,i.COMPILE_STATUS),r=(i.getShaderInfoLog(e)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+kE(i.getShaderSource(e),a)}else return r}function zE(i,e){let t=BE(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var HE={[hf]:"Linear",[uf]:"Reinhard",[df]:"Cineon",[ff]:"ACESFilmic",[mf]:"AgX",[il]:"Neutral",[pf]:"Custom"};function GE(i,e){let t=HE[e];return t===void 0?(Ke("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var jh=new U;function VE(){Mt.getLuminanceCoefficients(jh);let i=jh.x.toFixed(4),e=jh.y.toFixed(4),t=jh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function WE(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(fl).join(`
`)}function XE(i){let e=[];for(let t in i){let n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}function qE(i,e){let t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(e,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:i.getAttribLocation(e,o),locationSize:a}}return t}function fl(i){return i!==""}function ex(i,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function tx(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var YE=/^[ \t]*#include +<([\w\d./]+)>/gm;function Vf(i){return i.replace(YE,ZE)}function ZE(i,e){let t=ft[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return Vf(t)}var $E=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function nx(i){return i.replace($E,KE)}function KE(i,e,t,n){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function ix(i){let e=`precision ${i.precision} float;
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
#define LOW_PRECISION`),e}var jE={[Dr]:"SHADOWMAP_TYPE_PCF",[Xo]:"SHADOWMAP_TYPE_VSM"};function JE(i){return jE[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var QE={[Yo]:"ENVMAP_MODE_REFRACTION"};function e1(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":QE[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var t1={[ch]:"ENVMAP_BLENDING_MULTIPLY",[b0]:"ENVMAP_BLENDING_MIX",[M0]:"ENVMAP_BLENDING_ADD"};function n1(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":t1[i.combine]||"ENVMAP_BLENDING_NONE"}function i1(i,e,t,n){let s=i.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=JE(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=e1(t),d=n1(t),u=WE(t),f=XE(r),p=s.createProgram(),v,g,m=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(v=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(fl).join(`
`),v.length>0&&(v+=`
`),g=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(fl).join(`
`),g.length>0&&(g+=`
`)):(v=[ix(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+h:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(fl).join(`
`),g=[ix(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+h:"",t.envMap?"#define "+d:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==hs?"#define TONE_MAPPING":"",t.toneMapping!==hs?ft.tonemapping_pars_fragment:"",t.toneMapping!==hs?GE("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",ft.colorspace_pars_fragment,zE("linearToOutputTexel",t.outputColorSpace),VE(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(fl).join(`
`)),o=Vf(o),o=ex(o,t),o=tx(o,t),a=Vf(a),a=ex(a,t),a=tx(a,t),o=nx(o),a=nx(a),t.isRawShaderMaterial!==!0&&(m=`#version 300 es
`,v=[u,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+v,g=["#define varying in",t.glslVersion===Cf?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Cf?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+g);let _=m+v+o,T=m+g+a,M=j0(s,s.VERTEX_SHADER,_),C=j0(s,s.FRAGMENT_SHADER,T);s.attachShader(p,M),s.attachShader(p,C),t.index0AttributeName!==void 0?s.bindAttribLocation(p,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function S(P){if(i.debug.checkShaderErrors){let D=s.getProgramInfoLog(p)||"",z=s.getShaderInfoLog(M)||"",W=s.getShaderInfoLog(C)||"",N=D.trim(),V=z.trim(),Z=W.trim(),G=!0,ce=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(G=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,p,M,C);else{let Y=Q0(s,M,"vertex"),Q=Q0(s,C,"fragment");et("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+P.name+`
Material Type: `+P.type+`

Program Info Log: `+N+`
`+Y+`
`+Q)}else N!==""?Ke("WebGLProgram: Program Info Log:",N):(V===""||Z==="")&&(ce=!1);ce&&(P.diagnostics={runnable:G,programLog:N,vertexShader:{log:V,prefix:v},fragmentShader:{log:Z,prefix:g}})}s.deleteShader(M),s.deleteShader(C),x=new Ko(s,p),E=qE(s,p)}let x;this.getUniforms=function(){return x===void 0&&S(this),x};let E;this.getAttributes=function(){return E===void 0&&S(this),E};let O=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return O===!1&&(O=s.getProgramParameter(p,OE)),O},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=FE++,this.cacheKey=e,this.usedTimes=1,this.program=p,this.vertexShader=M,this.fragmentShader=C,this}var s1=0,Wf=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,n){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new Xf(e),t.set(e,n)),n}},Xf=class{constructor(e){this.id=s1++,this.code=e,this.usedTimes=0}};function r1(i){return i===or||i===cl||i===hl}function o1(i,e,t,n,s,r){let o=new ko,a=new Wf,l=new Set,c=[],h=new Map,d=n.logarithmicDepthBuffer,u={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(x){return l.add(x),x===0?"uv":`uv${x}`}function p(x,E,O,P,D,z){let W=P.fog,N=D.geometry,V=x.isMeshStandardMaterial||x.isMeshLambertMaterial||x.isMeshPhongMaterial?P.environment:null,Z=x.isMeshStandardMaterial||x.isMeshLambertMaterial&&!x.envMap||x.isMeshPhongMaterial&&!x.envMap,G=e.get(x.envMap||V,Z),ce=u[x.type],Y=n.precision;x.precision!==null&&(Y=n.getMaxPrecision(x.precision),Y!==x.precision&&Ke("WebGLProgram.getParameters:",x.precision,"not supported, using",Y,"instead."));let Q=N.morphAttributes.position||N.morphAttributes.normal||N.morphAttributes.color,ie=Q!==void 0?Q.length:0,de=0;N.morphAttributes.position!==void 0&&(de=1),N.morphAttributes.normal!==void 0&&(de=2),N.morphAttributes.color!==void 0&&(de=3);let fe,ee,ge,ye;if(ce){let Ce=ds[ce];fe=Ce.vertexShader,ee=Ce.fragmentShader}else{fe=x.vertexShader,ee=x.fragmentShader;let Ce=a.getVertexShaderStage(x),ct=a.getFragmentShaderStage(x);a.update(x,Ce,ct),ge=Ce.id,ye=ct.id}let Re=i.getRenderTarget(),Se=i.state.buffers.depth.getReversed(),Ye=D.isInstancedMesh===!0,at=D.isBatchedMesh===!0,Xe=!!x.map,pt=!!x.matcap,ut=!!G,rt=ut&&G.isPMREMTexture===!0,Qt=!!x.aoMap,Gt=!!x.lightMap,pn=!!x.bumpMap&&x.wireframe===!1,Ot=!!x.normalMap,Ln=!!x.displacementMap,St=!!x.emissiveMap,wn=!!x.metalnessMap,rn=!!x.roughnessMap,mn=x.anisotropy>0,B=x.clearcoat>0,Ie=x.diffuseRoughness>0,je=x.dispersion>0,lt=x.retroreflectivity>0,we=x.iridescence>0,kt=x.sheen>0,Ve=x.transmission>0,$e=mn&&!!x.anisotropyMap,I=B&&!!x.clearcoatMap,w=B&&!!x.clearcoatNormalMap,q=B&&!!x.clearcoatRoughnessMap,ue=Ie&&!!x.diffuseRoughnessMap,ae=we&&!!x.iridescenceMap,_e=we&&!!x.iridescenceThicknessMap,ve=kt&&!!x.sheenColorMap,te=kt&&!!x.sheenRoughnessMap,se=!!x.specularMap,me=!!x.specularColorMap,k=!!x.specularIntensityMap,oe=Ve&&!!x.transmissionMap,ne=Ve&&!!x.thicknessMap,Ee=!!x.gradientMap,xe=!!x.alphaMap,Me=x.alphaTest>0,qe=!!x.alphaHash,tt=!!x.extensions,he=hs;x.toneMapped&&(Re===null||Re.isXRRenderTarget===!0)&&(he=i.toneMapping);let ze=rt?G.isCompressedCubeTexture?G.image[0].mipmaps:G.mipmaps:null,nt={shaderID:ce,shaderType:x.type,shaderName:x.name,vertexShader:fe,fragmentShader:ee,defines:x.defines,customVertexShaderID:ge,customFragmentShaderID:ye,isRawShaderMaterial:x.isRawShaderMaterial===!0,glslVersion:x.glslVersion,precision:Y,batching:at,batchingColor:at&&D._colorsTexture!==null,instancing:Ye,instancingColor:Ye&&D.instanceColor!==null,instancingMorph:Ye&&D.morphTexture!==null,outputColorSpace:Re===null?i.outputColorSpace:Re.isXRRenderTarget===!0?Re.texture.colorSpace:Mt.workingColorSpace,alphaToCoverage:!!x.alphaToCoverage,map:Xe,matcap:pt,envMap:ut,envMapMode:ut&&G.mapping,envMapPMREM:rt,envMapMaxLod:rt?ze.length-1:null,envMapSize:rt?ze[0].width:null,aoMap:Qt,lightMap:Gt,bumpMap:pn,normalMap:Ot,displacementMap:Ln,emissiveMap:St,normalMapObjectSpace:Ot&&x.normalMapType===E0,normalMapTangentSpace:Ot&&x.normalMapType===ul,packedNormalMap:Ot&&x.normalMapType===ul&&r1(x.normalMap.format),metalnessMap:wn,roughnessMap:rn,anisotropy:mn,anisotropyMap:$e,clearcoat:B,clearcoatMap:I,clearcoatNormalMap:w,clearcoatRoughnessMap:q,diffuseRoughness:Ie,diffuseRoughnessMap:ue,dispersion:je,retroreflection:lt,iridescence:we,iridescenceMap:ae,iridescenceThicknessMap:_e,sheen:kt,sheenColorMap:ve,sheenRoughnessMap:te,specularMap:se,specularColorMap:me,specularIntensityMap:k,transmission:Ve,transmissionMap:oe,thicknessMap:ne,gradientMap:Ee,opaque:x.transparent===!1&&x.blending===qo&&x.alphaToCoverage===!1,alphaMap:xe,alphaTest:Me,alphaHash:qe,combine:x.combine,mapUv:Xe&&f(x.map.channel),aoMapUv:Qt&&f(x.aoMap.channel),lightMapUv:Gt&&f(x.lightMap.channel),bumpMapUv:pn&&f(x.bumpMap.channel),normalMapUv:Ot&&f(x.normalMap.channel),displacementMapUv:Ln&&f(x.displacementMap.channel),emissiveMapUv:St&&f(x.emissiveMap.channel),metalnessMapUv:wn&&f(x.metalnessMap.channel),roughnessMapUv:rn&&f(x.roughnessMap.channel),anisotropyMapUv:$e&&f(x.anisotropyMap.channel),clearcoatMapUv:I&&f(x.clearcoatMap.channel),clearcoatNormalMapUv:w&&f(x.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:q&&f(x.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ue&&f(x.diffuseRoughnessMap.channel),iridescenceMapUv:ae&&f(x.iridescenceMap.channel),iridescenceThicknessMapUv:_e&&f(x.iridescenceThicknessMap.channel),sheenColorMapUv:ve&&f(x.sheenColorMap.channel),sheenRoughnessMapUv:te&&f(x.sheenRoughnessMap.channel),specularMapUv:se&&f(x.specularMap.channel),specularColorMapUv:me&&f(x.specularColorMap.channel),specularIntensityMapUv:k&&f(x.specularIntensityMap.channel),transmissionMapUv:oe&&f(x.transmissionMap.channel),thicknessMapUv:ne&&f(x.thicknessMap.channel),alphaMapUv:xe&&f(x.alphaMap.channel),vertexTangents:!!N.attributes.tangent&&(Ot||mn),vertexNormals:!!N.attributes.normal,vertexColors:x.vertexColors,vertexAlphas:x.vertexColors===!0&&!!N.attributes.color&&N.attributes.color.itemSize===4,pointsUvs:D.isPoints===!0&&!!N.attributes.uv&&(Xe||xe),fog:!!W,useFog:x.fog===!0,fogExp2:!!W&&W.isFogExp2,flatShading:x.wireframe===!1&&(x.flatShading===!0||N.attributes.normal===void 0&&Ot===!1&&(x.isMeshLambertMaterial||x.isMeshPhongMaterial||x.isMeshStandardMaterial||x.isMeshPhysicalMaterial)),sizeAttenuation:x.sizeAttenuation===!0,logarithmicDepthBuffer:d,reversedDepthBuffer:Se,skinning:D.isSkinnedMesh===!0,hasPositionAttribute:N.attributes.position!==void 0,morphTargets:N.morphAttributes.position!==void 0,morphNormals:N.morphAttributes.normal!==void 0,morphColors:N.morphAttributes.color!==void 0,morphTargetsCount:ie,morphTextureStride:de,numSunLights:E.sun.length,numDirLights:E.directional.length,numPointLights:E.point.length,numSpotLights:E.spot.length,numSpotLightMaps:E.spotLightMap.length,numRectAreaLights:E.rectArea.length,numHemiLights:E.hemi.length,numSunLightShadows:E.sunShadowMap.length,numDirLightShadows:E.directionalShadowMap.length,numPointLightShadows:E.pointShadowMap.length,numSpotLightShadows:E.spotShadowMap.length,numSpotLightShadowsWithMaps:E.numSpotLightShadowsWithMaps,numLightProbes:E.numLightProbes,numLightProbeGrids:z.filter(Ce=>Ce.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:x.dithering,shadowMapEnabled:i.shadowMap.enabled&&O.length>0,shadowMapType:i.shadowMap.type,toneMapping:he,decodeVideoTexture:Xe&&x.map.isVideoTexture===!0&&Mt.getTransfer(x.map.colorSpace)===It,decodeVideoTextureEmissive:St&&x.emissiveMap.isVideoTexture===!0&&Mt.getTransfer(x.emissiveMap.colorSpace)===It,premultipliedAlpha:x.premultipliedAlpha,doubleSided:x.side===li,flipSided:x.side===Gn,useDepthPacking:x.depthPacking>=0,depthPacking:x.depthPacking||0,index0AttributeName:x.index0AttributeName,extensionClipCullDistance:tt&&x.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(tt&&x.extensions.multiDraw===!0||at)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:x.customProgramCacheKey()};return nt.vertexUv1s=l.has(1),nt.vertexUv2s=l.has(2),nt.vertexUv3s=l.has(3),l.clear(),nt}function v(x){let E=[];if(x.shaderID?E.push(x.shaderID):(E.push(x.customVertexShaderID),E.push(x.customFragmentShaderID)),x.defines!==void 0)for(let O in x.defines)E.push(O),E.push(x.defines[O]);return x.isRawShaderMaterial===!1&&(g(E,x),m(E,x),E.push(i.outputColorSpace)),E.push(x.customProgramCacheKey),E.join()}function g(x,E){x.push(E.precision),x.push(E.outputColorSpace),x.push(E.envMapMode),x.push(E.envMapPMREM),x.push(E.envMapMaxLod),x.push(E.envMapSize),x.push(E.mapUv),x.push(E.alphaMapUv),x.push(E.lightMapUv),x.push(E.aoMapUv),x.push(E.bumpMapUv),x.push(E.normalMapUv),x.push(E.displacementMapUv),x.push(E.emissiveMapUv),x.push(E.metalnessMapUv),x.push(E.roughnessMapUv),x.push(E.anisotropyMapUv),x.push(E.clearcoatMapUv),x.push(E.clearcoatNormalMapUv),x.push(E.clearcoatRoughnessMapUv),x.push(E.diffuseRoughnessMapUv),x.push(E.iridescenceMapUv),x.push(E.iridescenceThicknessMapUv),x.push(E.sheenColorMapUv),x.push(E.sheenRoughnessMapUv),x.push(E.specularMapUv),x.push(E.specularColorMapUv),x.push(E.specularIntensityMapUv),x.push(E.transmissionMapUv),x.push(E.thicknessMapUv),x.push(E.combine),x.push(E.fogExp2),x.push(E.sizeAttenuation),x.push(E.morphTargetsCount),x.push(E.numSunLights),x.push(E.numDirLights),x.push(E.numPointLights),x.push(E.numSpotLights),x.push(E.numSpotLightMaps),x.push(E.numHemiLights),x.push(E.numRectAreaLights),x.push(E.numSunLightShadows),x.push(E.numDirLightShadows),x.push(E.numPointLightShadows),x.push(E.numSpotLightShadows),x.push(E.numSpotLightShadowsWithMaps),x.push(E.numLightProbes),x.push(E.numLightProbeGrids),x.push(E.shadowMapType),x.push(E.toneMapping),x.push(E.numClippingPlanes),x.push(E.numClipIntersection),x.push(E.depthPacking)}function m(x,E){o.disableAll(),E.instancing&&o.enable(0),E.instancingColor&&o.enable(1),E.instancingMorph&&o.enable(2),E.matcap&&o.enable(3),E.envMap&&o.enable(4),E.normalMapObjectSpace&&o.enable(5),E.normalMapTangentSpace&&o.enable(6),E.clearcoat&&o.enable(7),E.iridescence&&o.enable(8),E.alphaTest&&o.enable(9),E.vertexColors&&o.enable(10),E.vertexAlphas&&o.enable(11),E.vertexUv1s&&o.enable(12),E.vertexUv2s&&o.enable(13),E.vertexUv3s&&o.enable(14),E.vertexTangents&&o.enable(15),E.anisotropy&&o.enable(16),E.alphaHash&&o.enable(17),E.batching&&o.enable(18),E.dispersion&&o.enable(19),E.retroreflection&&o.enable(24),E.diffuseRoughness&&o.enable(25),E.batchingColor&&o.enable(20),E.gradientMap&&o.enable(21),E.packedNormalMap&&o.enable(22),E.vertexNormals&&o.enable(23),x.push(o.mask),o.disableAll(),E.fog&&o.enable(0),E.useFog&&o.enable(1),E.flatShading&&o.enable(2),E.logarithmicDepthBuffer&&o.enable(3),E.reversedDepthBuffer&&o.enable(4),E.skinning&&o.enable(5),E.morphTargets&&o.enable(6),E.morphNormals&&o.enable(7),E.morphColors&&o.enable(8),E.premultipliedAlpha&&o.enable(9),E.shadowMapEnabled&&o.enable(10),E.doubleSided&&o.enable(11),E.flipSided&&o.enable(12),E.useDepthPacking&&o.enable(13),E.dithering&&o.enable(14),E.transmission&&o.enable(15),E.sheen&&o.enable(16),E.opaque&&o.enable(17),E.pointsUvs&&o.enable(18),E.decodeVideoTexture&&o.enable(19),E.decodeVideoTextureEmissive&&o.enable(20),E.alphaToCoverage&&o.enable(21),E.numLightProbeGrids>0&&o.enable(22),E.hasPositionAttribute&&o.enable(23),x.push(o.mask)}function _(x){let E=u[x.type],O;if(E){let P=ds[E];O=k0.clone(P.uniforms)}else O=x.uniforms;return O}function T(x,E){let O=h.get(E);return O!==void 0?++O.usedTimes:(O=new i1(i,E,x,s),c.push(O),h.set(E,O)),O}function M(x){if(--x.usedTimes===0){let E=c.indexOf(x);c[E]=c[c.length-1],c.pop(),h.delete(x.cacheKey),x.destroy()}}function C(x){a.remove(x)}function S(){a.dispose()}return{getParameters:p,getProgramCacheKey:v,getUniforms:_,acquireProgram:T,releaseProgram:M,releaseShaderCache:C,programs:c,dispose:S}}function a1(){let i=new WeakMap;function e(o){return i.has(o)}function t(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:e,get:t,remove:n,update:s,dispose:r}}function l1(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.materialVariant!==e.materialVariant?i.materialVariant-e.materialVariant:i.z!==e.z?i.z-e.z:i.id-e.id}function sx(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function rx(){let i=[],e=0,t=[],n=[],s=[];function r(){e=0,t.length=0,n.length=0,s.length=0}function o(u){let f=0;return u.isInstancedMesh&&(f+=2),u.isSkinnedMesh&&(f+=1),f}function a(u,f,p,v,g,m){let _=i[e];return _===void 0?(_={id:u.id,object:u,geometry:f,material:p,materialVariant:o(u),groupOrder:v,renderOrder:u.renderOrder,z:g,group:m},i[e]=_):(_.id=u.id,_.object=u,_.geometry=f,_.material=p,_.materialVariant=o(u),_.groupOrder=v,_.renderOrder=u.renderOrder,_.z=g,_.group=m),e++,_}function l(u,f,p,v,g,m,_){_.reversedDepth===!0&&(g=-g);let T=a(u,f,p,v,g,m);p.transmission>0?n.push(T):p.transparent===!0?s.push(T):t.push(T)}function c(u,f,p,v,g,m){let _=a(u,f,p,v,g,m);p.transmission>0?n.unshift(_):p.transparent===!0?s.unshift(_):t.unshift(_)}function h(u,f){t.length>1&&t.sort(u||l1),n.length>1&&n.sort(f||sx),s.length>1&&s.sort(f||sx)}function d(){for(let u=e,f=i.length;u<f;u++){let p=i[u];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:t,transmissive:n,transparent:s,init:r,push:l,unshift:c,finish:d,sort:h}}function c1(){let i=new WeakMap;function e(n,s){let r=i.get(n),o;return r===void 0?(o=new rx,i.set(n,[o])):s>=r.length?(o=new rx,r.push(o)):o=r[s],o}function t(){i=new WeakMap}return{get:e,dispose:t}}function h1(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new U,color:new Je};break;case"SpotLight":t={position:new U,direction:new U,color:new Je,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new U,color:new Je,distance:0,decay:0};break;case"HemisphereLight":t={direction:new U,skyColor:new Je,groundColor:new Je};break;case"RectAreaLight":t={color:new Je,position:new U,halfWidth:new U,halfHeight:new U};break}return i[e.id]=t,t}}}function u1(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new We};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new We};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new We,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t}}}var d1=0;function f1(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function p1(i){let e=new h1,t=u1(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new U);let s=new U,r=new yt,o=new yt;function a(c){let h=0,d=0,u=0;for(let z=0;z<9;z++)n.probe[z].set(0,0,0);let f=0,p=0,v=0,g=0,m=0,_=0,T=0,M=0,C=0,S=0,x=0,E=0,O=0,P=0;c.sort(f1);for(let z=0,W=c.length;z<W;z++){let N=c[z],V=N.color,Z=N.intensity,G=N.distance,ce=null;if(N.shadow&&N.shadow.map&&(N.shadow.map.texture.format===or?ce=N.shadow.map.texture:ce=N.shadow.map.depthTexture||N.shadow.map.texture),N.isAmbientLight)h+=V.r*Z,d+=V.g*Z,u+=V.b*Z;else if(N.isLightProbe){for(let Y=0;Y<9;Y++)n.probe[Y].addScaledVector(N.sh.coefficients[Y],Z);P++}else if(N.isSunLight){let Y=e.get(N);if(Y.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let Q=N.shadow,ie=t.get(N);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),n.sunShadow[p]=ie,n.sunShadowMap[p]=ce;let de=Q.getViewportCount();for(let fe=0;fe<de;fe++)n.sunShadowMatrix[v+fe]=Q.getMatrix(fe),n.sunShadowCascade[v+fe]=Q._cascadeData[fe];v+=de,p++}n.sun[f]=Y,f++}else if(N.isDirectionalLight){let Y=e.get(N);if(Y.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let Q=N.shadow,ie=t.get(N);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize=Q.mapSize,n.directionalShadow[g]=ie,n.directionalShadowMap[g]=ce,n.directionalShadowMatrix[g]=N.shadow.matrix,C++}n.directional[g]=Y,g++}else if(N.isSpotLight){let Y=e.get(N);Y.position.setFromMatrixPosition(N.matrixWorld),Y.color.copy(V).multiplyScalar(Z),Y.distance=G,Y.coneCos=Math.cos(N.angle),Y.penumbraCos=Math.cos(N.angle*(1-N.penumbra)),Y.decay=N.decay,n.spot[_]=Y;let Q=N.shadow;if(N.map&&(n.spotLightMap[E]=N.map,E++,Q.updateMatrices(N),N.castShadow&&O++),n.spotLightMatrix[_]=Q.matrix,N.castShadow){let ie=t.get(N);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize=Q.mapSize,n.spotShadow[_]=ie,n.spotShadowMap[_]=ce,x++}_++}else if(N.isRectAreaLight){let Y=e.get(N);Y.color.copy(V).multiplyScalar(Z),Y.halfWidth.set(N.width*.5,0,0),Y.halfHeight.set(0,N.height*.5,0),n.rectArea[T]=Y,T++}else if(N.isPointLight){let Y=e.get(N);if(Y.color.copy(N.color).multiplyScalar(N.intensity),Y.distance=N.distance,Y.decay=N.decay,N.castShadow){let Q=N.shadow,ie=t.get(N);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize=Q.mapSize,ie.shadowCameraNear=Q.camera.near,ie.shadowCameraFar=Q.camera.far,n.pointShadow[m]=ie,n.pointShadowMap[m]=ce,n.pointShadowMatrix[m]=N.shadow.matrix,S++}n.point[m]=Y,m++}else if(N.isHemisphereLight){let Y=e.get(N);Y.skyColor.copy(N.color).multiplyScalar(Z),Y.groundColor.copy(N.groundColor).multiplyScalar(Z),n.hemi[M]=Y,M++}}T>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Ue.LTC_FLOAT_1,n.rectAreaLTC2=Ue.LTC_FLOAT_2):(n.rectAreaLTC1=Ue.LTC_HALF_1,n.rectAreaLTC2=Ue.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=d,n.ambient[2]=u;let D=n.hash;(D.sunLength!==f||D.directionalLength!==g||D.pointLength!==m||D.spotLength!==_||D.rectAreaLength!==T||D.hemiLength!==M||D.numSunShadows!==p||D.numDirectionalShadows!==C||D.numPointShadows!==S||D.numSpotShadows!==x||D.numSpotMaps!==E||D.numLightProbes!==P)&&(n.sun.length=f,n.directional.length=g,n.spot.length=_,n.rectArea.length=T,n.point.length=m,n.hemi.length=M,n.sunShadow.length=p,n.sunShadowMap.length=p,n.sunShadowMatrix.length=v,n.sunShadowCascade.length=v,n.directionalShadow.length=C,n.directionalShadowMap.length=C,n.directionalShadowMatrix.length=C,n.pointShadow.length=S,n.pointShadowMap.length=S,n.pointShadowMatrix.length=S,n.spotShadow.length=x,n.spotShadowMap.length=x,n.spotLightMatrix.length=x+E-O,n.spotLightMap.length=E,n.numSpotLightShadowsWithMaps=O,n.numLightProbes=P,D.sunLength=f,D.directionalLength=g,D.pointLength=m,D.spotLength=_,D.rectAreaLength=T,D.hemiLength=M,D.numSunShadows=p,D.numDirectionalShadows=C,D.numPointShadows=S,D.numSpotShadows=x,D.numSpotMaps=E,D.numLightProbes=P,n.version=d1++)}function l(c,h){let d=0,u=0,f=0,p=0,v=0,g=0,m=h.matrixWorldInverse;for(let _=0,T=c.length;_<T;_++){let M=c[_];if(M.isSunLight){let C=n.sun[d];C.direction.setFromMatrixPosition(M.matrixWorld),C.direction.transformDirection(m),d++}else if(M.isDirectionalLight){let C=n.directional[u];C.direction.setFromMatrixPosition(M.matrixWorld),s.setFromMatrixPosition(M.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(m),u++}else if(M.isSpotLight){let C=n.spot[p];C.position.setFromMatrixPosition(M.matrixWorld),C.position.applyMatrix4(m),C.direction.setFromMatrixPosition(M.matrixWorld),s.setFromMatrixPosition(M.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(m),p++}else if(M.isRectAreaLight){let C=n.rectArea[v];C.position.setFromMatrixPosition(M.matrixWorld),C.position.applyMatrix4(m),o.identity(),r.copy(M.matrixWorld),r.premultiply(m),o.extractRotation(r),C.halfWidth.set(M.width*.5,0,0),C.halfHeight.set(0,M.height*.5,0),C.halfWidth.applyMatrix4(o),C.halfHeight.applyMatrix4(o),v++}else if(M.isPointLight){let C=n.point[f];C.position.setFromMatrixPosition(M.matrixWorld),C.position.applyMatrix4(m),f++}else if(M.isHemisphereLight){let C=n.hemi[g];C.direction.setFromMatrixPosition(M.matrixWorld),C.direction.transformDirection(m),g++}}}return{setup:a,setupView:l,state:n}}function ox(i){let e=new p1(i),t=[],n=[],s=[];function r(d){h.camera=d,t.length=0,n.length=0,s.length=0}function o(d){d.isLightProbeGrid?s.push(d):t.push(d)}function a(d){n.push(d)}function l(){e.setup(t),s.sort((d,u)=>d.priority-u.priority||d.id-u.id)}function c(d){e.setupView(t,d)}let h={lightsArray:t,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function m1(i){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new ox(i),e.set(s,[a])):r>=o.length?(a=new ox(i),o.push(a)):a=o[r],a}function n(){e=new WeakMap}return{get:t,dispose:n}}var g1=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,x1=`uniform sampler2D shadow_pass;
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
}`,_1=[new U(1,0,0),new U(-1,0,0),new U(0,1,0),new U(0,-1,0),new U(0,0,1),new U(0,0,-1)],y1=[new U(0,-1,0),new U(0,-1,0),new U(0,0,1),new U(0,0,-1),new U(0,-1,0),new U(0,-1,0)],ax=new yt,dl=new U,Bf=new U;function v1(i,e,t){let n=new Qs,s=new We,r=new We,o=new tn,a=new $c,l=new Kc,c={},h=t.maxTextureSize,d={[cs]:Gn,[Gn]:cs,[li]:li},u=new ls({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new We},radius:{value:4}},vertexShader:g1,fragmentShader:x1}),f=u.clone();f.defines.HORIZONTAL_PASS=1;let p=new Lt;p.setAttribute("position",new jt(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let v=new De(p,u),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Dr;let m=this.type;this.render=function(S,x,E){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||S.length===0)return;this.type===n0&&(Ke("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Dr);let O=i.getRenderTarget(),P=i.getActiveCubeFace(),D=i.getActiveMipmapLevel(),z=i.state;z.setBlending(Nr),z.buffers.depth.getReversed()===!0?z.buffers.color.setClear(0,0,0,0):z.buffers.color.setClear(1,1,1,1),z.buffers.depth.setTest(!0),z.setScissorTest(!1);let W=m!==this.type;W&&x.traverse(function(N){N.material&&(Array.isArray(N.material)?N.material.forEach(V=>V.needsUpdate=!0):N.material.needsUpdate=!0)});for(let N=0,V=S.length;N<V;N++){let Z=S[N],G=Z.shadow;if(G===void 0){Ke("WebGLShadowMap:",Z,"has no shadow.");continue}if(G.autoUpdate===!1&&G.needsUpdate===!1)continue;s.copy(G.mapSize);let ce=G.getFrameExtents();s.multiply(ce),r.copy(G.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/ce.x),s.x=r.x*ce.x,G.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/ce.y),s.y=r.y*ce.y,G.mapSize.y=r.y));let Y=i.state.buffers.depth.getReversed();if(G.camera._reversedDepth=Y,G.map===null||W===!0){if(G.map!==null&&(G.map.depthTexture!==null&&(G.map.depthTexture.dispose(),G.map.depthTexture=null),G.map.dispose()),this.type===Xo){if(Z.isPointLight){Ke("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}G.map=new vi(s.x,s.y,{format:or,type:Yi,minFilter:si,magFilter:si,generateMipmaps:!1}),G.map.texture.name=Z.name+".shadowMap",G.map.depthTexture=new Is(s.x,s.y,qi),G.map.depthTexture.name=Z.name+".shadowMapDepth",G.map.depthTexture.format=Cs,G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=kn,G.map.depthTexture.magFilter=kn}else Z.isPointLight?(G.map=new pl(s.x),G.map.depthTexture=new Ya(s.x,Xi)):(G.map=new vi(s.x,s.y),G.map.depthTexture=new Is(s.x,s.y,Xi)),G.map.depthTexture.name=Z.name+".shadowMap",G.map.depthTexture.format=Cs,this.type===Dr?(G.map.depthTexture.compareFunction=Y?Ef:wf,G.map.depthTexture.minFilter=si,G.map.depthTexture.magFilter=si):(G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=kn,G.map.depthTexture.magFilter=kn);G.camera.updateProjectionMatrix()}G.map.isWebGLCubeRenderTarget!==!0&&(G.map.width!==s.x||G.map.height!==s.y)&&G.map.setSize(s.x,s.y);let Q=G.map.isWebGLCubeRenderTarget?6:G.getViewportCount();Z.isPointLight!==!0&&G.updateMatrices(Z,E);let ie=(G.camera.layers.mask&4294967294)!==0?G.camera.layers:E.layers;for(let de=0;de<Q;de++){let fe=G.getCamera(de);if(Z.isPointLight){let ee=G.camera,ge=G.matrix,ye=Z.distance||ee.far;ye!==ee.far&&(ee.far=ye,ee.updateProjectionMatrix()),dl.setFromMatrixPosition(Z.matrixWorld),ee.position.copy(dl),Bf.copy(ee.position),Bf.add(_1[de]),ee.up.copy(y1[de]),ee.lookAt(Bf),ee.updateMatrixWorld(),ge.makeTranslation(-dl.x,-dl.y,-dl.z),ax.multiplyMatrices(ee.projectionMatrix,ee.matrixWorldInverse),G._frustum.setFromProjectionMatrix(ax,ee.coordinateSystem,ee.reversedDepth)}if(G.map.isWebGLCubeRenderTarget)i.setRenderTarget(G.map,de),i.clear();else{de===0&&(i.setRenderTarget(G.map),i.clear());let ee=G.getViewport(de);o.set(r.x*ee.x,r.y*ee.y,r.x*ee.z,r.y*ee.w),z.viewport(o)}n=G.getFrustum(de),M(x,E,fe,Z,ie,this.type)}G.isPointLightShadow!==!0&&this.type===Xo&&_(G,E),G.needsUpdate=!1}m=this.type,g.needsUpdate=!1,i.setRenderTarget(O,P,D)};function _(S,x){let E=e.update(v);u.defines.VSM_SAMPLES!==S.blurSamples&&(u.defines.VSM_SAMPLES=S.blurSamples,f.defines.VSM_SAMPLES=S.blurSamples,u.needsUpdate=!0,f.needsUpdate=!0),S.mapPass===null?S.mapPass=new vi(s.x,s.y,{format:or,type:Yi}):(S.mapPass.width!==S.map.width||S.mapPass.height!==S.map.height)&&S.mapPass.setSize(S.map.width,S.map.height),u.uniforms.shadow_pass.value=S.map.depthTexture,u.uniforms.resolution.value.set(S.map.width,S.map.height),u.uniforms.radius.value=S.radius,i.setRenderTarget(S.mapPass),i.clear(),i.renderBufferDirect(x,null,E,u,v,null),f.uniforms.shadow_pass.value=S.mapPass.texture,f.uniforms.resolution.value.set(S.map.width,S.map.height),f.uniforms.radius.value=S.radius,i.setRenderTarget(S.map),i.clear(),i.renderBufferDirect(x,null,E,f,v,null)}function T(S,x,E,O){let P=null,D=E.isPointLight===!0?S.customDistanceMaterial:S.customDepthMaterial;if(D!==void 0)P=D;else if(P=E.isPointLight===!0?l:a,i.localClippingEnabled&&x.clipShadows===!0&&Array.isArray(x.clippingPlanes)&&x.clippingPlanes.length!==0||x.displacementMap&&x.displacementScale!==0||x.alphaMap&&x.alphaTest>0||x.map&&x.alphaTest>0||x.alphaToCoverage===!0){let z=P.uuid,W=x.uuid,N=c[z];N===void 0&&(N={},c[z]=N);let V=N[W];V===void 0&&(V=P.clone(),N[W]=V,x.addEventListener("dispose",C)),P=V}if(P.visible=x.visible,P.wireframe=x.wireframe,O===Xo?P.side=x.shadowSide!==null?x.shadowSide:x.side:P.side=x.shadowSide!==null?x.shadowSide:d[x.side],P.alphaMap=x.alphaMap,P.alphaTest=x.alphaToCoverage===!0?.5:x.alphaTest,P.map=x.map,P.clipShadows=x.clipShadows,P.clippingPlanes=x.clippingPlanes,P.clipIntersection=x.clipIntersection,P.displacementMap=x.displacementMap,P.displacementScale=x.displacementScale,P.displacementBias=x.displacementBias,P.wireframeLinewidth=x.wireframeLinewidth,P.linewidth=x.linewidth,E.isPointLight===!0&&P.isMeshDistanceMaterial===!0){let z=i.properties.get(P);z.light=E}return P}function M(S,x,E,O,P,D){if(S.visible===!1)return;if(S.layers.test(P)&&(S.isMesh||S.isLine||S.isPoints)&&(S.castShadow||S.receiveShadow&&D===Xo)&&(!S.frustumCulled||S.intersectsFrustum(n))){S.modelViewMatrix.multiplyMatrices(E.matrixWorldInverse,S.matrixWorld);let N=e.update(S),V=S.material;if(Array.isArray(V)){let Z=N.groups;for(let G=0,ce=Z.length;G<ce;G++){let Y=Z[G],Q=V[Y.materialIndex];if(Q&&Q.visible){let ie=T(S,Q,O,D);S.onBeforeShadow(i,S,x,E,N,ie,Y),i.renderBufferDirect(E,null,N,ie,S,Y),S.onAfterShadow(i,S,x,E,N,ie,Y)}}}else if(V.visible){let Z=T(S,V,O,D);S.onBeforeShadow(i,S,x,E,N,Z,null),i.renderBufferDirect(E,null,N,Z,S,null),S.onAfterShadow(i,S,x,E,N,Z,null)}}let W=S.children;for(let N=0,V=W.length;N<V;N++)M(W[N],x,E,O,P,D)}function C(S){S.target.removeEventListener("dispose",C);for(let E in c){let O=c[E],P=S.target.uuid;P in O&&(O[P].dispose(),delete O[P])}}}function b1(i,e){function t(){let k=!1,oe=new tn,ne=null,Ee=new tn(0,0,0,0);return{setMask:function(xe){ne!==xe&&!k&&(i.colorMask(xe,xe,xe,xe),ne=xe)},setLocked:function(xe){k=xe},setClear:function(xe,Me,qe,tt,he){he===!0&&(xe*=tt,Me*=tt,qe*=tt),oe.set(xe,Me,qe,tt),Ee.equals(oe)===!1&&(i.clearColor(xe,Me,qe,tt),Ee.copy(oe))},reset:function(){k=!1,ne=null,Ee.set(-1,0,0,0)}}}function n(){let k=!1,oe=!1,ne=null,Ee=null,xe=null;return{setReversed:function(Me){if(oe!==Me){let qe=e.get("EXT_clip_control");Me?qe.clipControlEXT(qe.LOWER_LEFT_EXT,qe.ZERO_TO_ONE_EXT):qe.clipControlEXT(qe.LOWER_LEFT_EXT,qe.NEGATIVE_ONE_TO_ONE_EXT),oe=Me;let tt=xe;xe=null,this.setClear(tt)}},getReversed:function(){return oe},setTest:function(Me){Me?Se(i.DEPTH_TEST):Ye(i.DEPTH_TEST)},setMask:function(Me){ne!==Me&&!k&&(i.depthMask(Me),ne=Me)},setFunc:function(Me){if(oe&&(Me=U0[Me]),Ee!==Me){switch(Me){case Ic:i.depthFunc(i.NEVER);break;case Lc:i.depthFunc(i.ALWAYS);break;case Dc:i.depthFunc(i.LESS);break;case Do:i.depthFunc(i.LEQUAL);break;case Nc:i.depthFunc(i.EQUAL);break;case Uc:i.depthFunc(i.GEQUAL);break;case Oc:i.depthFunc(i.GREATER);break;case Fc:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}Ee=Me}},setLocked:function(Me){k=Me},setClear:function(Me){xe!==Me&&(xe=Me,oe&&(Me=1-Me),i.clearDepth(Me))},reset:function(){k=!1,ne=null,Ee=null,xe=null,oe=!1}}}function s(){let k=!1,oe=null,ne=null,Ee=null,xe=null,Me=null,qe=null,tt=null,he=null;return{setTest:function(ze){k||(ze?Se(i.STENCIL_TEST):Ye(i.STENCIL_TEST))},setMask:function(ze){oe!==ze&&!k&&(i.stencilMask(ze),oe=ze)},setFunc:function(ze,nt,Ce){(ne!==ze||Ee!==nt||xe!==Ce)&&(i.stencilFunc(ze,nt,Ce),ne=ze,Ee=nt,xe=Ce)},setOp:function(ze,nt,Ce){(Me!==ze||qe!==nt||tt!==Ce)&&(i.stencilOp(ze,nt,Ce),Me=ze,qe=nt,tt=Ce)},setLocked:function(ze){k=ze},setClear:function(ze){he!==ze&&(i.clearStencil(ze),he=ze)},reset:function(){k=!1,oe=null,ne=null,Ee=null,xe=null,Me=null,qe=null,tt=null,he=null}}}let r=new t,o=new n,a=new s,l={},c=new WeakMap,h={},d={},u={},f=new WeakMap,p=[],v=null,g=!1,m=null,_=null,T=null,M=null,C=null,S=null,x=null,E=new Je(0,0,0),O=0,P=!1,D=null,z=null,W=null,N=null,V=null,Z=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),G=!1,ce=0,Y=i.getParameter(i.VERSION);Y.indexOf("WebGL")!==-1?(ce=parseFloat(/^WebGL (\d)/.exec(Y)[1]),G=ce>=1):Y.indexOf("OpenGL ES")!==-1&&(ce=parseFloat(/^OpenGL ES (\d)/.exec(Y)[1]),G=ce>=2);let Q=null,ie={},de=i.getParameter(i.SCISSOR_BOX),fe=i.getParameter(i.VIEWPORT),ee=new tn().fromArray(de),ge=new tn().fromArray(fe);function ye(k,oe,ne,Ee){let xe=new Uint8Array(4),Me=i.createTexture();i.bindTexture(k,Me),i.texParameteri(k,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(k,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let qe=0;qe<ne;qe++)k===i.TEXTURE_3D||k===i.TEXTURE_2D_ARRAY?i.texImage3D(oe,0,i.RGBA,1,1,Ee,0,i.RGBA,i.UNSIGNED_BYTE,xe):i.texImage2D(oe+qe,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,xe);return Me}let Re={};Re[i.TEXTURE_2D]=ye(i.TEXTURE_2D,i.TEXTURE_2D,1),Re[i.TEXTURE_CUBE_MAP]=ye(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Re[i.TEXTURE_2D_ARRAY]=ye(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Re[i.TEXTURE_3D]=ye(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),Se(i.DEPTH_TEST),o.setFunc(Do),pn(!1),Ot(nf),Se(i.CULL_FACE),Qt(Nr);function Se(k){h[k]!==!0&&(i.enable(k),h[k]=!0)}function Ye(k){h[k]!==!1&&(i.disable(k),h[k]=!1)}function at(k,oe){return u[k]!==oe?(i.bindFramebuffer(k,oe),u[k]=oe,k===i.DRAW_FRAMEBUFFER&&(u[i.FRAMEBUFFER]=oe),k===i.FRAMEBUFFER&&(u[i.DRAW_FRAMEBUFFER]=oe),!0):!1}function Xe(k,oe){let ne=p,Ee=!1;if(k){ne=f.get(oe),ne===void 0&&(ne=[],f.set(oe,ne));let xe=k.textures;if(ne.length!==xe.length||ne[0]!==i.COLOR_ATTACHMENT0){for(let Me=0,qe=xe.length;Me<qe;Me++)ne[Me]=i.COLOR_ATTACHMENT0+Me;ne.length=xe.length,Ee=!0}}else ne[0]!==i.BACK&&(ne[0]=i.BACK,Ee=!0);Ee&&i.drawBuffers(ne)}function pt(k){return v!==k?(i.useProgram(k),v=k,!0):!1}let ut={[Ur]:i.FUNC_ADD,[s0]:i.FUNC_SUBTRACT,[r0]:i.FUNC_REVERSE_SUBTRACT};ut[o0]=i.MIN,ut[a0]=i.MAX;let rt={[l0]:i.ZERO,[c0]:i.ONE,[h0]:i.SRC_COLOR,[lf]:i.SRC_ALPHA,[g0]:i.SRC_ALPHA_SATURATE,[p0]:i.DST_COLOR,[d0]:i.DST_ALPHA,[u0]:i.ONE_MINUS_SRC_COLOR,[cf]:i.ONE_MINUS_SRC_ALPHA,[m0]:i.ONE_MINUS_DST_COLOR,[f0]:i.ONE_MINUS_DST_ALPHA,[x0]:i.CONSTANT_COLOR,[_0]:i.ONE_MINUS_CONSTANT_COLOR,[y0]:i.CONSTANT_ALPHA,[v0]:i.ONE_MINUS_CONSTANT_ALPHA};function Qt(k,oe,ne,Ee,xe,Me,qe,tt,he,ze){if(k===Nr){g===!0&&(Ye(i.BLEND),g=!1);return}if(g===!1&&(Se(i.BLEND),g=!0),k!==i0){if(k!==m||ze!==P){if((_!==Ur||C!==Ur)&&(i.blendEquation(i.FUNC_ADD),_=Ur,C=Ur),ze)switch(k){case qo:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case rf:i.blendFunc(i.ONE,i.ONE);break;case of:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case af:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:et("WebGLState: Invalid blending: ",k);break}else switch(k){case qo:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case rf:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case of:et("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case af:et("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:et("WebGLState: Invalid blending: ",k);break}T=null,M=null,S=null,x=null,E.set(0,0,0),O=0,m=k,P=ze}return}xe=xe||oe,Me=Me||ne,qe=qe||Ee,(oe!==_||xe!==C)&&(i.blendEquationSeparate(ut[oe],ut[xe]),_=oe,C=xe),(ne!==T||Ee!==M||Me!==S||qe!==x)&&(i.blendFuncSeparate(rt[ne],rt[Ee],rt[Me],rt[qe]),T=ne,M=Ee,S=Me,x=qe),(tt.equals(E)===!1||he!==O)&&(i.blendColor(tt.r,tt.g,tt.b,he),E.copy(tt),O=he),m=k,P=!1}function Gt(k,oe){k.side===li?Ye(i.CULL_FACE):Se(i.CULL_FACE);let ne=k.side===Gn;oe&&(ne=!ne),pn(ne),k.blending===qo&&k.transparent===!1?Qt(Nr):Qt(k.blending,k.blendEquation,k.blendSrc,k.blendDst,k.blendEquationAlpha,k.blendSrcAlpha,k.blendDstAlpha,k.blendColor,k.blendAlpha,k.premultipliedAlpha),o.setFunc(k.depthFunc),o.setTest(k.depthTest),o.setMask(k.depthWrite),r.setMask(k.colorWrite);let Ee=k.stencilWrite;a.setTest(Ee),Ee&&(a.setMask(k.stencilWriteMask),a.setFunc(k.stencilFunc,k.stencilRef,k.stencilFuncMask),a.setOp(k.stencilFail,k.stencilZFail,k.stencilZPass)),St(k.polygonOffset,k.polygonOffsetFactor,k.polygonOffsetUnits),k.alphaToCoverage===!0?Se(i.SAMPLE_ALPHA_TO_COVERAGE):Ye(i.SAMPLE_ALPHA_TO_COVERAGE)}function pn(k){D!==k&&(k?i.frontFace(i.CW):i.frontFace(i.CCW),D=k)}function Ot(k){k!==e0?(Se(i.CULL_FACE),k!==z&&(k===nf?i.cullFace(i.BACK):k===t0?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Ye(i.CULL_FACE),z=k}function Ln(k){k!==W&&(G&&i.lineWidth(k),W=k)}function St(k,oe,ne){k?(Se(i.POLYGON_OFFSET_FILL),(N!==oe||V!==ne)&&(N=oe,V=ne,o.getReversed()&&(oe=-oe,ne=-ne),i.polygonOffset(oe,ne))):Ye(i.POLYGON_OFFSET_FILL)}function wn(k){k?Se(i.SCISSOR_TEST):Ye(i.SCISSOR_TEST)}function rn(k){k===void 0&&(k=i.TEXTURE0+Z-1),Q!==k&&(i.activeTexture(k),Q=k)}function mn(k,oe,ne){ne===void 0&&(Q===null?ne=i.TEXTURE0+Z-1:ne=Q);let Ee=ie[ne];Ee===void 0&&(Ee={type:void 0,texture:void 0},ie[ne]=Ee),(Ee.type!==k||Ee.texture!==oe)&&(Q!==ne&&(i.activeTexture(ne),Q=ne),i.bindTexture(k,oe||Re[k]),Ee.type=k,Ee.texture=oe)}function B(){let k=ie[Q];k!==void 0&&k.type!==void 0&&(i.bindTexture(k.type,null),k.type=void 0,k.texture=void 0)}function Ie(){try{i.compressedTexImage2D(...arguments)}catch(k){et("WebGLState:",k)}}function je(){try{i.compressedTexImage3D(...arguments)}catch(k){et("WebGLState:",k)}}function lt(){try{i.texSubImage2D(...arguments)}catch(k){et("WebGLState:",k)}}function we(){try{i.texSubImage3D(...arguments)}catch(k){et("WebGLState:",k)}}function kt(){try{i.compressedTexSubImage2D(...arguments)}catch(k){et("WebGLState:",k)}}function Ve(){try{i.compressedTexSubImage3D(...arguments)}catch(k){et("WebGLState:",k)}}function $e(){try{i.texStorage2D(...arguments)}catch(k){et("WebGLState:",k)}}function I(){try{i.texStorage3D(...arguments)}catch(k){et("WebGLState:",k)}}function w(){try{i.texImage2D(...arguments)}catch(k){et("WebGLState:",k)}}function q(){try{i.texImage3D(...arguments)}catch(k){et("WebGLState:",k)}}function ue(k){return d[k]!==void 0?d[k]:i.getParameter(k)}function ae(k,oe){d[k]!==oe&&(i.pixelStorei(k,oe),d[k]=oe)}function _e(k){ee.equals(k)===!1&&(i.scissor(k.x,k.y,k.z,k.w),ee.copy(k))}function ve(k){ge.equals(k)===!1&&(i.viewport(k.x,k.y,k.z,k.w),ge.copy(k))}function te(k,oe){let ne=c.get(oe);ne===void 0&&(ne=new WeakMap,c.set(oe,ne));let Ee=ne.get(k);Ee===void 0&&(Ee=i.getUniformBlockIndex(oe,k.name),i.uniformBlockBinding(oe,Ee,Ee),ne.set(k,Ee))}function se(k,oe,ne){let xe=c.get(oe).get(k);l[xe]!==ne&&(i.bindBufferBase(i.UNIFORM_BUFFER,xe,ne),l[xe]=ne)}function me(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),h={},d={},Q=null,ie={},u={},l={},f=new WeakMap,p=[],v=null,g=!1,m=null,_=null,T=null,M=null,C=null,S=null,x=null,E=new Je(0,0,0),O=0,P=!1,D=null,z=null,W=null,N=null,V=null,ee.set(0,0,i.canvas.width,i.canvas.height),ge.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:Se,disable:Ye,bindFramebuffer:at,drawBuffers:Xe,useProgram:pt,setBlending:Qt,setMaterial:Gt,setFlipSided:pn,setCullFace:Ot,setLineWidth:Ln,setPolygonOffset:St,setScissorTest:wn,activeTexture:rn,bindTexture:mn,unbindTexture:B,compressedTexImage2D:Ie,compressedTexImage3D:je,texImage2D:w,texImage3D:q,pixelStorei:ae,getParameter:ue,updateUBOMapping:te,uniformBlockBinding:se,texStorage2D:$e,texStorage3D:I,texSubImage2D:lt,texSubImage3D:we,compressedTexSubImage2D:kt,compressedTexSubImage3D:Ve,scissor:_e,viewport:ve,reset:me}}function M1(i,e,t,n,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new We,h=new WeakMap,d=new Set,u,f=new WeakMap,p=new Set,v=new FinalizationRegistry(I=>p.delete(I)),g=!1;try{g=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(I,w){return g?new OffscreenCanvas(I,w):Na("canvas")}function _(I,w,q){let ue=1,ae=$e(I);if((ae.width>q||ae.height>q)&&(ue=q/Math.max(ae.width,ae.height)),ue<1)if(typeof HTMLImageElement<"u"&&I instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&I instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&I instanceof ImageBitmap||typeof VideoFrame<"u"&&I instanceof VideoFrame){let _e=Math.floor(ue*ae.width),ve=Math.floor(ue*ae.height);u===void 0&&(u=m(_e,ve));let te=w?m(_e,ve):u;return te.width=_e,te.height=ve,te.getContext("2d").drawImage(I,0,0,_e,ve),Ke("WebGLRenderer: Texture has been resized from ("+ae.width+"x"+ae.height+") to ("+_e+"x"+ve+")."),te}else return"data"in I&&Ke("WebGLRenderer: Image in DataTexture is too big ("+ae.width+"x"+ae.height+")."),I;return I}function T(I){return I.generateMipmaps}function M(I){i.generateMipmap(I)}function C(I){return I.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:I.isWebGL3DRenderTarget?i.TEXTURE_3D:I.isWebGLArrayRenderTarget||I.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function S(I,w,q,ue,ae,_e=!1){if(I!==null){if(i[I]!==void 0)return i[I];Ke("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+I+"'")}let ve;ue&&(ve=e.get("EXT_texture_norm16"),ve||Ke("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let te=w;if(w===i.RED&&(q===i.FLOAT&&(te=i.R32F),q===i.HALF_FLOAT&&(te=i.R16F),q===i.UNSIGNED_BYTE&&(te=i.R8),q===i.UNSIGNED_SHORT&&ve&&(te=ve.R16_EXT),q===i.SHORT&&ve&&(te=ve.R16_SNORM_EXT)),w===i.RED_INTEGER&&(q===i.UNSIGNED_BYTE&&(te=i.R8UI),q===i.UNSIGNED_SHORT&&(te=i.R16UI),q===i.UNSIGNED_INT&&(te=i.R32UI),q===i.BYTE&&(te=i.R8I),q===i.SHORT&&(te=i.R16I),q===i.INT&&(te=i.R32I)),w===i.RG&&(q===i.FLOAT&&(te=i.RG32F),q===i.HALF_FLOAT&&(te=i.RG16F),q===i.UNSIGNED_BYTE&&(te=i.RG8),q===i.UNSIGNED_SHORT&&ve&&(te=ve.RG16_EXT),q===i.SHORT&&ve&&(te=ve.RG16_SNORM_EXT)),w===i.RG_INTEGER&&(q===i.UNSIGNED_BYTE&&(te=i.RG8UI),q===i.UNSIGNED_SHORT&&(te=i.RG16UI),q===i.UNSIGNED_INT&&(te=i.RG32UI),q===i.BYTE&&(te=i.RG8I),q===i.SHORT&&(te=i.RG16I),q===i.INT&&(te=i.RG32I)),w===i.RGB_INTEGER&&(q===i.UNSIGNED_BYTE&&(te=i.RGB8UI),q===i.UNSIGNED_SHORT&&(te=i.RGB16UI),q===i.UNSIGNED_INT&&(te=i.RGB32UI),q===i.BYTE&&(te=i.RGB8I),q===i.SHORT&&(te=i.RGB16I),q===i.INT&&(te=i.RGB32I)),w===i.RGBA_INTEGER&&(q===i.UNSIGNED_BYTE&&(te=i.RGBA8UI),q===i.UNSIGNED_SHORT&&(te=i.RGBA16UI),q===i.UNSIGNED_INT&&(te=i.RGBA32UI),q===i.BYTE&&(te=i.RGBA8I),q===i.SHORT&&(te=i.RGBA16I),q===i.INT&&(te=i.RGBA32I)),w===i.RGB&&(q===i.UNSIGNED_SHORT&&ve&&(te=ve.RGB16_EXT),q===i.SHORT&&ve&&(te=ve.RGB16_SNORM_EXT),q===i.UNSIGNED_INT_5_9_9_9_REV&&(te=i.RGB9_E5),q===i.UNSIGNED_INT_10F_11F_11F_REV&&(te=i.R11F_G11F_B10F)),w===i.RGBA){let se=_e?Da:Mt.getTransfer(ae);q===i.FLOAT&&(te=i.RGBA32F),q===i.HALF_FLOAT&&(te=i.RGBA16F),q===i.UNSIGNED_BYTE&&(te=se===It?i.SRGB8_ALPHA8:i.RGBA8),q===i.UNSIGNED_SHORT&&ve&&(te=ve.RGBA16_EXT),q===i.SHORT&&ve&&(te=ve.RGBA16_SNORM_EXT),q===i.UNSIGNED_SHORT_4_4_4_4&&(te=i.RGBA4),q===i.UNSIGNED_SHORT_5_5_5_1&&(te=i.RGB5_A1)}return(te===i.R16F||te===i.R32F||te===i.RG16F||te===i.RG32F||te===i.RGBA16F||te===i.RGBA32F)&&e.get("EXT_color_buffer_float"),te}function x(I,w){let q;return I?w===null||w===Xi||w===Fr?q=i.DEPTH24_STENCIL8:w===qi?q=i.DEPTH32F_STENCIL8:w===$o&&(q=i.DEPTH24_STENCIL8,Ke("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):w===null||w===Xi||w===Fr?q=i.DEPTH_COMPONENT24:w===qi?q=i.DEPTH_COMPONENT32F:w===$o&&(q=i.DEPTH_COMPONENT16),q}function E(I,w){return T(I)===!0||I.isFramebufferTexture&&I.minFilter!==kn&&I.minFilter!==si?Math.log2(Math.max(w.width,w.height))+1:I.mipmaps.length>0?I.mipmaps.length:I.isCompressedTexture&&Array.isArray(I.image)?w.mipmaps.length:1}function O(I){let w=new WeakRef(I);n.get(I).__ref=w,p.add(w),v.register(I,w,w)}function P(I){let w=n.get(I).__ref;w!==void 0&&(p.delete(w),v.unregister(w))}function D(I){W(I.target)}function z(I){N(I.target)}function W(I){I.removeEventListener("dispose",D),P(I),Z(I),I.isVideoTexture&&h.delete(I),I.isHTMLTexture&&d.delete(I)}function N(I){I.removeEventListener("dispose",z),P(I),ce(I)}function V(){for(let I of p){let w=I.deref();w!==void 0&&(w.isRenderTarget===!0?N(w):W(w))}p.clear(),d.clear()}function Z(I){let w=n.get(I);if(w.__webglInit===void 0)return;let q=I.source,ue=f.get(q);if(ue){let ae=ue[w.__cacheKey];ae.usedTimes--,ae.usedTimes===0&&G(I),Object.keys(ue).length===0&&f.delete(q)}n.remove(I)}function G(I){let w=n.get(I);i.deleteTexture(w.__webglTexture);let q=I.source,ue=f.get(q);delete ue[w.__cacheKey],o.memory.textures--}function ce(I){let w=n.get(I);w.__depthDisposeCallback&&w.__depthDisposeCallback();let q=I.depthTexture;if(q&&q.renderTarget===I&&W(q),I.isWebGLCubeRenderTarget)for(let ae=0;ae<6;ae++){if(Array.isArray(w.__webglFramebuffer[ae]))for(let _e=0;_e<w.__webglFramebuffer[ae].length;_e++)i.deleteFramebuffer(w.__webglFramebuffer[ae][_e]);else i.deleteFramebuffer(w.__webglFramebuffer[ae]);w.__webglDepthbuffer&&i.deleteRenderbuffer(w.__webglDepthbuffer[ae])}else{if(Array.isArray(w.__webglFramebuffer))for(let ae=0;ae<w.__webglFramebuffer.length;ae++)i.deleteFramebuffer(w.__webglFramebuffer[ae]);else i.deleteFramebuffer(w.__webglFramebuffer);if(w.__webglDepthbuffer&&i.deleteRenderbuffer(w.__webglDepthbuffer),w.__webglMultisampledFramebuffer&&i.deleteFramebuffer(w.__webglMultisampledFramebuffer),w.__webglColorRenderbuffer)for(let ae=0;ae<w.__webglColorRenderbuffer.length;ae++)w.__webglColorRenderbuffer[ae]&&i.deleteRenderbuffer(w.__webglColorRenderbuffer[ae]);w.__webglDepthRenderbuffer&&i.deleteRenderbuffer(w.__webglDepthRenderbuffer)}let ue=I.textures;for(let ae=0,_e=ue.length;ae<_e;ae++){let ve=n.get(ue[ae]);ve.__webglTexture&&(i.deleteTexture(ve.__webglTexture),o.memory.textures--),n.remove(ue[ae])}n.remove(I)}let Y=0;function Q(){Y=0}function ie(){return Y}function de(I){Y=I}function fe(){let I=Y;return I>=s.maxTextures&&Ke("WebGLTextures: Trying to use "+(I+1)+" texture units while this GPU supports only "+s.maxTextures),Y+=1,I}function ee(I){let w=[];return w.push(I.wrapS),w.push(I.wrapT),w.push(I.wrapR||0),w.push(I.magFilter),w.push(I.minFilter),w.push(I.anisotropy),w.push(I.internalFormat),w.push(I.format),w.push(I.type),w.push(I.generateMipmaps),w.push(I.mipmapsAutoUpdate),w.push(I.premultiplyAlpha),w.push(I.flipY),w.push(I.unpackAlignment),w.push(I.colorSpace),w.join()}function ge(I,w){let q=n.get(I);if(I.isVideoTexture&&kt(I),I.isRenderTargetTexture===!1&&I.isExternalTexture!==!0&&I.version>0&&q.__version!==I.version){let ue=I.image;if(ue===null)Ke("WebGLRenderer: Texture marked for update but no image data found.");else if(ue.complete===!1)Ke("WebGLRenderer: Texture marked for update but image is incomplete");else{Gt(q,I,w);return}}else I.isExternalTexture&&(q.__webglTexture=I.sourceTexture?I.sourceTexture:null);t.bindTexture(i.TEXTURE_2D,q.__webglTexture,i.TEXTURE0+w)}function ye(I,w){let q=n.get(I);if(I.isRenderTargetTexture===!1&&I.version>0&&q.__version!==I.version){Gt(q,I,w);return}else I.isExternalTexture&&(q.__webglTexture=I.sourceTexture?I.sourceTexture:null);t.bindTexture(i.TEXTURE_2D_ARRAY,q.__webglTexture,i.TEXTURE0+w)}function Re(I,w){let q=n.get(I);if(I.isRenderTargetTexture===!1&&I.version>0&&q.__version!==I.version){Gt(q,I,w);return}t.bindTexture(i.TEXTURE_3D,q.__webglTexture,i.TEXTURE0+w)}function Se(I,w){let q=n.get(I);if(I.version>0&&q.__version!==I.version){pn(q,I,w);return}t.bindTexture(i.TEXTURE_CUBE_MAP,q.__webglTexture,i.TEXTURE0+w)}let Ye={[Rr]:i.REPEAT,[os]:i.CLAMP_TO_EDGE,[kc]:i.MIRRORED_REPEAT},at={[kn]:i.NEAREST,[S0]:i.NEAREST_MIPMAP_NEAREST,[sl]:i.NEAREST_MIPMAP_LINEAR,[si]:i.LINEAR,[Zo]:i.LINEAR_MIPMAP_NEAREST,[Ns]:i.LINEAR_MIPMAP_LINEAR},Xe={[A0]:i.NEVER,[Tf]:i.ALWAYS,[R0]:i.LESS,[wf]:i.LEQUAL,[C0]:i.EQUAL,[Ef]:i.GEQUAL,[P0]:i.GREATER,[I0]:i.NOTEQUAL};function pt(I,w){if(w.type===qi&&e.has("OES_texture_float_linear")===!1&&(w.magFilter===si||w.magFilter===Zo||w.magFilter===sl||w.magFilter===Ns||w.minFilter===si||w.minFilter===Zo||w.minFilter===sl||w.minFilter===Ns)&&Ke("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(I,i.TEXTURE_WRAP_S,Ye[w.wrapS]),i.texParameteri(I,i.TEXTURE_WRAP_T,Ye[w.wrapT]),(I===i.TEXTURE_3D||I===i.TEXTURE_2D_ARRAY)&&i.texParameteri(I,i.TEXTURE_WRAP_R,Ye[w.wrapR]),i.texParameteri(I,i.TEXTURE_MAG_FILTER,at[w.magFilter]),i.texParameteri(I,i.TEXTURE_MIN_FILTER,at[w.minFilter]),w.compareFunction&&(i.texParameteri(I,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(I,i.TEXTURE_COMPARE_FUNC,Xe[w.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(w.magFilter===kn||w.minFilter!==sl&&w.minFilter!==Ns||w.type===qi&&e.has("OES_texture_float_linear")===!1)return;if(w.anisotropy>1||n.get(w).__currentAnisotropy){let q=e.get("EXT_texture_filter_anisotropic");i.texParameterf(I,q.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(w.anisotropy,s.getMaxAnisotropy())),n.get(w).__currentAnisotropy=w.anisotropy}}}function ut(I,w){let q=!1;I.__webglInit===void 0&&(I.__webglInit=!0,w.addEventListener("dispose",D),O(w));let ue=w.source,ae=f.get(ue);ae===void 0&&(ae={},f.set(ue,ae));let _e=ee(w);if(_e!==I.__cacheKey){ae[_e]===void 0&&(ae[_e]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,q=!0),ae[_e].usedTimes++;let ve=ae[I.__cacheKey];ve!==void 0&&(ae[I.__cacheKey].usedTimes--,ve.usedTimes===0&&G(w)),I.__cacheKey=_e,I.__webglTexture=ae[_e].texture}return q}function rt(I,w,q){return Math.floor(Math.floor(I/q)/w)}function Qt(I,w,q,ue){let _e=I.updateRanges;if(_e.length===0)t.texSubImage2D(i.TEXTURE_2D,0,0,0,w.width,w.height,q,ue,w.data);else{_e.sort((k,oe)=>k.start-oe.start);let ve=0;for(let k=1;k<_e.length;k++){let oe=_e[ve],ne=_e[k],Ee=oe.start+oe.count,xe=rt(ne.start,w.width,4),Me=rt(oe.start,w.width,4);ne.start<=Ee+1&&xe===Me&&rt(ne.start+ne.count-1,w.width,4)===xe?oe.count=Math.max(oe.count,ne.start+ne.count-oe.start):(++ve,_e[ve]=ne)}_e.length=ve+1;let te=t.getParameter(i.UNPACK_ROW_LENGTH),se=t.getParameter(i.UNPACK_SKIP_PIXELS),me=t.getParameter(i.UNPACK_SKIP_ROWS);t.pixelStorei(i.UNPACK_ROW_LENGTH,w.width);for(let k=0,oe=_e.length;k<oe;k++){let ne=_e[k],Ee=Math.floor(ne.start/4),xe=Math.ceil(ne.count/4),Me=Ee%w.width,qe=Math.floor(Ee/w.width),tt=xe,he=1;t.pixelStorei(i.UNPACK_SKIP_PIXELS,Me),t.pixelStorei(i.UNPACK_SKIP_ROWS,qe),t.texSubImage2D(i.TEXTURE_2D,0,Me,qe,tt,he,q,ue,w.data)}I.clearUpdateRanges(),t.pixelStorei(i.UNPACK_ROW_LENGTH,te),t.pixelStorei(i.UNPACK_SKIP_PIXELS,se),t.pixelStorei(i.UNPACK_SKIP_ROWS,me)}}function Gt(I,w,q){let ue=i.TEXTURE_2D;(w.isDataArrayTexture||w.isCompressedArrayTexture)&&(ue=i.TEXTURE_2D_ARRAY),w.isData3DTexture&&(ue=i.TEXTURE_3D);let ae=ut(I,w),_e=w.source;t.bindTexture(ue,I.__webglTexture,i.TEXTURE0+q);let ve=n.get(_e);if(_e.version!==ve.__version||ae===!0){if(t.activeTexture(i.TEXTURE0+q),(typeof ImageBitmap<"u"&&w.image instanceof ImageBitmap)===!1){let he=Mt.getPrimaries(Mt.workingColorSpace),ze=w.colorSpace===Os?null:Mt.getPrimaries(w.colorSpace),nt=w.colorSpace===Os||he===ze?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,w.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,nt)}t.pixelStorei(i.UNPACK_ALIGNMENT,w.unpackAlignment);let se=_(w.image,!1,s.maxTextureSize);se=Ve(w,se);let me=r.convert(w.format,w.colorSpace),k=r.convert(w.type),oe=S(w.internalFormat,me,k,w.normalized,w.colorSpace,w.isVideoTexture);pt(ue,w);let ne,Ee=w.mipmaps,xe=w.isVideoTexture!==!0,Me=ve.__version===void 0||ae===!0,qe=_e.dataReady,tt=E(w,se);if(w.isDepthTexture)oe=x(w.format===Us,w.type),Me&&(xe?t.texStorage2D(i.TEXTURE_2D,1,oe,se.width,se.height):t.texImage2D(i.TEXTURE_2D,0,oe,se.width,se.height,0,me,k,null));else if(w.isDataTexture)if(Ee.length>0){xe&&Me&&t.texStorage2D(i.TEXTURE_2D,tt,oe,Ee[0].width,Ee[0].height);for(let he=0,ze=Ee.length;he<ze;he++)ne=Ee[he],xe?qe&&t.texSubImage2D(i.TEXTURE_2D,he,0,0,ne.width,ne.height,me,k,ne.data):t.texImage2D(i.TEXTURE_2D,he,oe,ne.width,ne.height,0,me,k,ne.data);w.generateMipmaps=!1}else xe?(Me&&t.texStorage2D(i.TEXTURE_2D,tt,oe,se.width,se.height),qe&&Qt(w,se,me,k)):t.texImage2D(i.TEXTURE_2D,0,oe,se.width,se.height,0,me,k,se.data);else if(w.isCompressedTexture)if(w.isCompressedArrayTexture){xe&&Me&&t.texStorage3D(i.TEXTURE_2D_ARRAY,tt,oe,Ee[0].width,Ee[0].height,se.depth);for(let he=0,ze=Ee.length;he<ze;he++)if(ne=Ee[he],w.format!==Zi)if(me!==null)if(xe){if(qe)if(w.layerUpdates.size>0){let nt=Ff(ne.width,ne.height,w.format,w.type);for(let Ce of w.layerUpdates){let ct=ne.data.subarray(Ce*nt/ne.data.BYTES_PER_ELEMENT,(Ce+1)*nt/ne.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,he,0,0,Ce,ne.width,ne.height,1,me,ct)}}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,he,0,0,0,ne.width,ne.height,se.depth,me,ne.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,he,oe,ne.width,ne.height,se.depth,0,ne.data,0,0);else Ke("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else xe?qe&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,he,0,0,0,ne.width,ne.height,se.depth,me,k,ne.data):t.texImage3D(i.TEXTURE_2D_ARRAY,he,oe,ne.width,ne.height,se.depth,0,me,k,ne.data);w.layerUpdates.size>0&&w.clearLayerUpdates()}else{xe&&Me&&t.texStorage2D(i.TEXTURE_2D,tt,oe,Ee[0].width,Ee[0].height);for(let he=0,ze=Ee.length;he<ze;he++)ne=Ee[he],w.format!==Zi?me!==null?xe?qe&&t.compressedTexSubImage2D(i.TEXTURE_2D,he,0,0,ne.width,ne.height,me,ne.data):t.compressedTexImage2D(i.TEXTURE_2D,he,oe,ne.width,ne.height,0,ne.data):Ke("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):xe?qe&&t.texSubImage2D(i.TEXTURE_2D,he,0,0,ne.width,ne.height,me,k,ne.data):t.texImage2D(i.TEXTURE_2D,he,oe,ne.width,ne.height,0,me,k,ne.data)}else if(w.isDataArrayTexture)if(xe){if(Me&&t.texStorage3D(i.TEXTURE_2D_ARRAY,tt,oe,se.width,se.height,se.depth),qe)if(w.layerUpdates.size>0){let he=Ff(se.width,se.height,w.format,w.type);for(let ze of w.layerUpdates){let nt=se.data.subarray(ze*he/se.data.BYTES_PER_ELEMENT,(ze+1)*he/se.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,ze,se.width,se.height,1,me,k,nt)}w.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,se.width,se.height,se.depth,me,k,se.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,oe,se.width,se.height,se.depth,0,me,k,se.data);else if(w.isData3DTexture)xe?(Me&&t.texStorage3D(i.TEXTURE_3D,tt,oe,se.width,se.height,se.depth),qe&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,se.width,se.height,se.depth,me,k,se.data)):t.texImage3D(i.TEXTURE_3D,0,oe,se.width,se.height,se.depth,0,me,k,se.data);else if(w.isFramebufferTexture){if(Me)if(xe)t.texStorage2D(i.TEXTURE_2D,tt,oe,se.width,se.height);else{let he=se.width,ze=se.height;for(let nt=0;nt<tt;nt++)t.texImage2D(i.TEXTURE_2D,nt,oe,he,ze,0,me,k,null),he>>=1,ze>>=1}}else if(w.isHTMLTexture){if("texElementImage2D"in i){let he=i.canvas;if(he.hasAttribute("layoutsubtree")||he.setAttribute("layoutsubtree","true"),se.parentNode!==he){he.appendChild(se),d.add(w),he.onpaint=ze=>{let nt=ze.changedElements;for(let Ce of d)nt.includes(Ce.image)&&(Ce.needsUpdate=!0)},he.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,se);else{let nt=i.RGBA,Ce=i.RGBA,ct=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,nt,Ce,ct,se)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(Ee.length>0){if(xe&&Me){let he=$e(Ee[0]);t.texStorage2D(i.TEXTURE_2D,tt,oe,he.width,he.height)}for(let he=0,ze=Ee.length;he<ze;he++)ne=Ee[he],xe?qe&&t.texSubImage2D(i.TEXTURE_2D,he,0,0,me,k,ne):t.texImage2D(i.TEXTURE_2D,he,oe,me,k,ne);w.generateMipmaps=!1}else if(xe){if(Me){let he=$e(se);t.texStorage2D(i.TEXTURE_2D,tt,oe,he.width,he.height)}qe&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,me,k,se)}else t.texImage2D(i.TEXTURE_2D,0,oe,me,k,se);T(w)&&w.mipmapsAutoUpdate===!0&&M(ue),ve.__version=_e.version,w.onUpdate&&w.onUpdate(w)}I.__version=w.version}function pn(I,w,q){if(w.image.length!==6)return;let ue=ut(I,w),ae=w.source;t.bindTexture(i.TEXTURE_CUBE_MAP,I.__webglTexture,i.TEXTURE0+q);let _e=n.get(ae);if(ae.version!==_e.__version||ue===!0){t.activeTexture(i.TEXTURE0+q);let ve=Mt.getPrimaries(Mt.workingColorSpace),te=w.colorSpace===Os?null:Mt.getPrimaries(w.colorSpace),se=w.colorSpace===Os||ve===te?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,w.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),t.pixelStorei(i.UNPACK_ALIGNMENT,w.unpackAlignment),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,se);let me=w.isCompressedTexture||w.image[0].isCompressedTexture,k=w.image[0]&&w.image[0].isDataTexture,oe=[];for(let Ce=0;Ce<6;Ce++)!me&&!k?oe[Ce]=_(w.image[Ce],!0,s.maxCubemapSize):oe[Ce]=k?w.image[Ce].image:w.image[Ce],oe[Ce]=Ve(w,oe[Ce]);let ne=oe[0],Ee=r.convert(w.format,w.colorSpace),xe=r.convert(w.type),Me=S(w.internalFormat,Ee,xe,w.normalized,w.colorSpace),qe=w.isVideoTexture!==!0,tt=_e.__version===void 0||ue===!0,he=ae.dataReady,ze=E(w,ne);pt(i.TEXTURE_CUBE_MAP,w);let nt;if(w.isDepthTexture){if(Me=x(w.format===Us,w.type),tt)if(qe)t.texStorage2D(i.TEXTURE_CUBE_MAP,1,Me,ne.width,ne.height);else for(let Ce=0;Ce<6;Ce++)t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,Me,ne.width,ne.height,0,Ee,xe,null)}else if(me){qe&&tt&&t.texStorage2D(i.TEXTURE_CUBE_MAP,ze,Me,ne.width,ne.height);for(let Ce=0;Ce<6;Ce++){nt=oe[Ce].mipmaps;for(let ct=0;ct<nt.length;ct++){let Xt=nt[ct];w.format!==Zi?Ee!==null?qe?he&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ct,0,0,Xt.width,Xt.height,Ee,Xt.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ct,Me,Xt.width,Xt.height,0,Xt.data):Ke("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):qe?he&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ct,0,0,Xt.width,Xt.height,Ee,xe,Xt.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ct,Me,Xt.width,Xt.height,0,Ee,xe,Xt.data)}}}else{if(nt=w.mipmaps,qe&&tt){nt.length>0&&ze++;let Ce=$e(oe[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,ze,Me,Ce.width,Ce.height)}for(let Ce=0;Ce<6;Ce++)if(k){qe?he&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,0,0,oe[Ce].width,oe[Ce].height,Ee,xe,oe[Ce].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,Me,oe[Ce].width,oe[Ce].height,0,Ee,xe,oe[Ce].data);for(let ct=0;ct<nt.length;ct++){let $n=nt[ct].image[Ce].image;qe?he&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ct+1,0,0,$n.width,$n.height,Ee,xe,$n.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ct+1,Me,$n.width,$n.height,0,Ee,xe,$n.data)}}else{qe?he&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,0,0,Ee,xe,oe[Ce]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,Me,Ee,xe,oe[Ce]);for(let ct=0;ct<nt.length;ct++){let Xt=nt[ct];qe?he&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ct+1,0,0,Ee,xe,Xt.image[Ce]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ct+1,Me,Ee,xe,Xt.image[Ce])}}}T(w)&&w.mipmapsAutoUpdate===!0&&M(i.TEXTURE_CUBE_MAP),_e.__version=ae.version,w.onUpdate&&w.onUpdate(w)}I.__version=w.version}function Ot(I,w,q,ue,ae,_e){let ve=r.convert(q.format,q.colorSpace),te=r.convert(q.type),se=S(q.internalFormat,ve,te,q.normalized,q.colorSpace),me=n.get(w),k=n.get(q);if(k.__renderTarget=w,!me.__hasExternalTextures){let oe=Math.max(1,w.width>>_e),ne=Math.max(1,w.height>>_e);ae===i.TEXTURE_3D||ae===i.TEXTURE_2D_ARRAY?t.texImage3D(ae,_e,se,oe,ne,w.depth,0,ve,te,null):t.texImage2D(ae,_e,se,oe,ne,0,ve,te,null)}t.bindFramebuffer(i.FRAMEBUFFER,I),we(w)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ue,ae,k.__webglTexture,0,lt(w)):(ae===i.TEXTURE_2D||ae>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&ae<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,ue,ae,k.__webglTexture,_e),t.bindFramebuffer(i.FRAMEBUFFER,null)}function Ln(I,w,q){if(i.bindRenderbuffer(i.RENDERBUFFER,I),w.depthBuffer){let ue=w.depthTexture,ae=ue&&ue.isDepthTexture?ue.type:null,_e=x(w.stencilBuffer,ae),ve=w.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;we(w)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,lt(w),_e,w.width,w.height):q?i.renderbufferStorageMultisample(i.RENDERBUFFER,lt(w),_e,w.width,w.height):i.renderbufferStorage(i.RENDERBUFFER,_e,w.width,w.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,ve,i.RENDERBUFFER,I)}else{let ue=w.textures;for(let ae=0;ae<ue.length;ae++){let _e=ue[ae],ve=r.convert(_e.format,_e.colorSpace),te=r.convert(_e.type),se=S(_e.internalFormat,ve,te,_e.normalized,_e.colorSpace);we(w)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,lt(w),se,w.width,w.height):q?i.renderbufferStorageMultisample(i.RENDERBUFFER,lt(w),se,w.width,w.height):i.renderbufferStorage(i.RENDERBUFFER,se,w.width,w.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function St(I,w,q){let ue=w.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(i.FRAMEBUFFER,I),!(w.depthTexture&&w.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ae=n.get(w.depthTexture);ae.__renderTarget=w;let _e=ue?w.depthTexture.image[0]:w.depthTexture.image;(!ae.__webglTexture||_e.width!==w.width||_e.height!==w.height)&&(_e.width=w.width,_e.height=w.height,w.depthTexture.needsUpdate=!0),ue?Se(w.depthTexture,0):ge(w.depthTexture,0);let ve=ae.__webglTexture,te=lt(w),se=ue?i.TEXTURE_CUBE_MAP_POSITIVE_X+q:i.TEXTURE_2D,me=w.depthTexture.format===Us?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(w.depthTexture.format===Cs)we(w)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,me,se,ve,0,te):i.framebufferTexture2D(i.FRAMEBUFFER,me,se,ve,0);else if(w.depthTexture.format===Us)we(w)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,me,se,ve,0,te):i.framebufferTexture2D(i.FRAMEBUFFER,me,se,ve,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function wn(I){let w=n.get(I),q=I.isWebGLCubeRenderTarget===!0;if(w.__boundDepthTexture!==I.depthTexture){let ue=I.depthTexture;if(w.__depthDisposeCallback&&w.__depthDisposeCallback(),ue){let ae=()=>{delete w.__boundDepthTexture,delete w.__depthDisposeCallback,ue.removeEventListener("dispose",ae)};ue.addEventListener("dispose",ae),w.__depthDisposeCallback=ae}w.__boundDepthTexture=ue}if(I.depthTexture&&!w.__autoAllocateDepthBuffer)if(q)for(let ue=0;ue<6;ue++)St(w.__webglFramebuffer[ue],I,ue);else I.texture.mipmaps.length>0?St(w.__webglFramebuffer[0],I,0):St(w.__webglFramebuffer,I,0);else if(q){w.__webglDepthbuffer=[];for(let ue=0;ue<6;ue++)if(t.bindFramebuffer(i.FRAMEBUFFER,w.__webglFramebuffer[ue]),w.__webglDepthbuffer[ue]===void 0)w.__webglDepthbuffer[ue]=i.createRenderbuffer(),Ln(w.__webglDepthbuffer[ue],I,!1);else{let ae=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,_e=w.__webglDepthbuffer[ue];i.bindRenderbuffer(i.RENDERBUFFER,_e),i.framebufferRenderbuffer(i.FRAMEBUFFER,ae,i.RENDERBUFFER,_e)}}else if(I.texture.mipmaps.length>0?t.bindFramebuffer(i.FRAMEBUFFER,w.__webglFramebuffer[0]):t.bindFramebuffer(i.FRAMEBUFFER,w.__webglFramebuffer),w.__webglDepthbuffer===void 0)w.__webglDepthbuffer=i.createRenderbuffer(),Ln(w.__webglDepthbuffer,I,!1);else{let ae=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,_e=w.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,_e),i.framebufferRenderbuffer(i.FRAMEBUFFER,ae,i.RENDERBUFFER,_e)}t.bindFramebuffer(i.FRAMEBUFFER,null)}function rn(I,w,q){let ue=n.get(I);w!==void 0&&Ot(ue.__webglFramebuffer,I,I.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),q!==void 0&&wn(I)}function mn(I){let w=I.texture,q=n.get(I),ue=n.get(w);I.addEventListener("dispose",z),O(I);let ae=I.textures,_e=I.isWebGLCubeRenderTarget===!0,ve=ae.length>1;if(ve||(ue.__webglTexture===void 0&&(ue.__webglTexture=i.createTexture()),ue.__version=w.version,o.memory.textures++),_e){q.__webglFramebuffer=[];for(let te=0;te<6;te++)if(w.mipmaps.length>0){q.__webglFramebuffer[te]=[];for(let se=0;se<w.mipmaps.length;se++)q.__webglFramebuffer[te][se]=i.createFramebuffer()}else q.__webglFramebuffer[te]=i.createFramebuffer()}else{if(w.mipmaps.length>0){q.__webglFramebuffer=[];for(let te=0;te<w.mipmaps.length;te++)q.__webglFramebuffer[te]=i.createFramebuffer()}else q.__webglFramebuffer=i.createFramebuffer();if(ve)for(let te=0,se=ae.length;te<se;te++){let me=n.get(ae[te]);me.__webglTexture===void 0&&(me.__webglTexture=i.createTexture(),o.memory.textures++)}if(I.samples>0&&we(I)===!1){q.__webglMultisampledFramebuffer=i.createFramebuffer(),q.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,q.__webglMultisampledFramebuffer);for(let te=0;te<ae.length;te++){let se=ae[te];q.__webglColorRenderbuffer[te]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,q.__webglColorRenderbuffer[te]);let me=r.convert(se.format,se.colorSpace),k=r.convert(se.type),oe=S(se.internalFormat,me,k,se.normalized,se.colorSpace,I.isXRRenderTarget===!0),ne=lt(I);i.renderbufferStorageMultisample(i.RENDERBUFFER,ne,oe,I.width,I.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+te,i.RENDERBUFFER,q.__webglColorRenderbuffer[te])}i.bindRenderbuffer(i.RENDERBUFFER,null),I.depthBuffer&&(q.__webglDepthRenderbuffer=i.createRenderbuffer(),Ln(q.__webglDepthRenderbuffer,I,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(_e){t.bindTexture(i.TEXTURE_CUBE_MAP,ue.__webglTexture),pt(i.TEXTURE_CUBE_MAP,w);for(let te=0;te<6;te++)if(w.mipmaps.length>0)for(let se=0;se<w.mipmaps.length;se++)Ot(q.__webglFramebuffer[te][se],I,w,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+te,se);else Ot(q.__webglFramebuffer[te],I,w,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+te,0);T(w)?M(i.TEXTURE_CUBE_MAP):w.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,w.mipmaps.length-1),t.unbindTexture()}else if(ve){for(let te=0,se=ae.length;te<se;te++){let me=ae[te],k=n.get(me),oe=i.TEXTURE_2D;(I.isWebGL3DRenderTarget||I.isWebGLArrayRenderTarget)&&(oe=I.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(oe,k.__webglTexture),pt(oe,me),Ot(q.__webglFramebuffer,I,me,i.COLOR_ATTACHMENT0+te,oe,0),T(me)&&M(oe)}t.unbindTexture()}else{let te=i.TEXTURE_2D;if((I.isWebGL3DRenderTarget||I.isWebGLArrayRenderTarget)&&(te=I.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(te,ue.__webglTexture),pt(te,w),w.mipmaps.length>0)for(let se=0;se<w.mipmaps.length;se++)Ot(q.__webglFramebuffer[se],I,w,i.COLOR_ATTACHMENT0,te,se);else Ot(q.__webglFramebuffer,I,w,i.COLOR_ATTACHMENT0,te,0);T(w)?M(te):w.mipmaps.length>0&&i.texParameteri(te,i.TEXTURE_MAX_LEVEL,w.mipmaps.length-1),t.unbindTexture()}I.depthBuffer&&wn(I)}function B(I){let w=I.textures;for(let q=0,ue=w.length;q<ue;q++){let ae=w[q];if(T(ae)&&ae.mipmapsAutoUpdate===!0){let _e=C(I),ve=n.get(ae).__webglTexture;t.bindTexture(_e,ve),M(_e),t.unbindTexture()}}}let Ie=[];function je(I){if(I.samples>0){if(we(I)===!1){let w=I.textures,q=I.width,ue=I.height,ae=i.COLOR_BUFFER_BIT,_e=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ve=n.get(I),te=w.length>1;if(te)for(let me=0;me<w.length;me++)t.bindFramebuffer(i.FRAMEBUFFER,ve.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+me,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,ve.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+me,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,ve.__webglMultisampledFramebuffer),I.texture.mipmaps.length>0?t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ve.__webglFramebuffer[0]):t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ve.__webglFramebuffer);for(let me=0;me<w.length;me++){if(I.resolveDepthBuffer&&(I.depthBuffer&&(ae|=i.DEPTH_BUFFER_BIT),I.stencilBuffer&&I.resolveStencilBuffer&&(ae|=i.STENCIL_BUFFER_BIT)),te){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,ve.__webglColorRenderbuffer[me]);let k=n.get(w[me]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,k,0)}i.blitFramebuffer(0,0,q,ue,0,0,q,ue,ae,i.NEAREST),l===!0&&(Ie.length=0,Ie.push(i.COLOR_ATTACHMENT0+me),I.depthBuffer&&I.storeMultisampledDepthBuffer===!1&&Ie.push(_e),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Ie))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),te)for(let me=0;me<w.length;me++){t.bindFramebuffer(i.FRAMEBUFFER,ve.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+me,i.RENDERBUFFER,ve.__webglColorRenderbuffer[me]);let k=n.get(w[me]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,ve.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+me,i.TEXTURE_2D,k,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ve.__webglMultisampledFramebuffer)}else if(I.depthBuffer&&I.storeMultisampledDepthBuffer===!1&&l){let w=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[w])}}}function lt(I){return Math.min(s.maxSamples,I.samples)}function we(I){let w=n.get(I);return I.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&w.__useRenderToTexture!==!1}function kt(I){let w=o.render.frame;h.get(I)!==w&&(h.set(I,w),I.update())}function Ve(I,w){let q=I.colorSpace,ue=I.format,ae=I.type;return I.isCompressedTexture===!0||I.isVideoTexture===!0||q!==La&&q!==Os&&(Mt.getTransfer(q)===It?(ue!==Zi||ae!==ci)&&Ke("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):et("WebGLTextures: Unsupported texture color space:",q)),w}function $e(I){return typeof HTMLImageElement<"u"&&I instanceof HTMLImageElement?(c.width=I.naturalWidth||I.width,c.height=I.naturalHeight||I.height):typeof VideoFrame<"u"&&I instanceof VideoFrame?(c.width=I.displayWidth,c.height=I.displayHeight):(c.width=I.width,c.height=I.height),c}this.allocateTextureUnit=fe,this.resetTextureUnits=Q,this.getTextureUnits=ie,this.setTextureUnits=de,this.setTexture2D=ge,this.setTexture2DArray=ye,this.setTexture3D=Re,this.setTextureCube=Se,this.rebindTextures=rn,this.setupRenderTarget=mn,this.updateRenderTargetMipmap=B,this.updateMultisampleRenderTarget=je,this.setupDepthRenderbuffer=wn,this.setupFrameBufferTexture=Ot,this.useMultisampledRTT=we,this.dispose=V}function S1(i,e){function t(n,s=Os){let r,o=Mt.getTransfer(s);if(n===ci)return i.UNSIGNED_BYTE;if(n===fh)return i.UNSIGNED_SHORT_4_4_4_4;if(n===ph)return i.UNSIGNED_SHORT_5_5_5_1;if(n===yf)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===vf)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===xf)return i.BYTE;if(n===_f)return i.SHORT;if(n===$o)return i.UNSIGNED_SHORT;if(n===dh)return i.INT;if(n===Xi)return i.UNSIGNED_INT;if(n===qi)return i.FLOAT;if(n===Yi)return i.HALF_FLOAT;if(n===bf)return i.ALPHA;if(n===Mf)return i.RGB;if(n===Zi)return i.RGBA;if(n===Cs)return i.DEPTH_COMPONENT;if(n===Us)return i.DEPTH_STENCIL;if(n===Sf)return i.RED;if(n===mh)return i.RED_INTEGER;if(n===or)return i.RG;if(n===gh)return i.RG_INTEGER;if(n===xh)return i.RGBA_INTEGER;if(n===rl||n===ol||n===al||n===ll)if(o===It)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===rl)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===ol)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===al)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===ll)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===rl)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===ol)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===al)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===ll)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===_h||n===yh||n===vh||n===bh)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===_h)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===yh)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===vh)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===bh)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===Mh||n===Sh||n===wh||n===Eh||n===Th||n===cl||n===Ah)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(n===Mh||n===Sh)return o===It?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===wh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===Eh)return r.COMPRESSED_R11_EAC;if(n===Th)return r.COMPRESSED_SIGNED_R11_EAC;if(n===cl)return r.COMPRESSED_RG11_EAC;if(n===Ah)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===Rh||n===Ch||n===Ph||n===Ih||n===Lh||n===Dh||n===Nh||n===Uh||n===Oh||n===Fh||n===kh||n===Bh||n===zh||n===Hh)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(n===Rh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===Ch)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===Ph)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===Ih)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===Lh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===Dh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===Nh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===Uh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===Oh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===Fh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===kh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===Bh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===zh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===Hh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===Gh||n===Vh||n===Wh)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(n===Gh)return o===It?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===Vh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===Wh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===Xh||n===qh||n===hl||n===Yh)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(n===Xh)return r.COMPRESSED_RED_RGTC1_EXT;if(n===qh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===hl)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===Yh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===Fr?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:t}}var w1=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,E1=`
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

}`,qf=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new Za(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new ls({vertexShader:w1,fragmentShader:E1,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new De(new Ls(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Yf=class extends Wi{constructor(e,t){super();let n=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,d=null,u=null,f=null,p=null,v=typeof XRWebGLBinding<"u",g=new qf,m={},_=t.getContextAttributes(),T=null,M=null,C=[],S=[],x=new We,E=null,O=null,P=new ii;P.viewport=new tn;let D=new ii;D.viewport=new tn;let z=[P,D],W=new lh,N=null,V=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(ee){let ge=C[ee];return ge===void 0&&(ge=new Bo,C[ee]=ge),ge.getTargetRaySpace()},this.getControllerGrip=function(ee){let ge=C[ee];return ge===void 0&&(ge=new Bo,C[ee]=ge),ge.getGripSpace()},this.getHand=function(ee){let ge=C[ee];return ge===void 0&&(ge=new Bo,C[ee]=ge),ge.getHandSpace()};function Z(ee){let ge=S.indexOf(ee.inputSource);if(ge===-1)return;let ye=C[ge];ye!==void 0&&(ye.update(ee.inputSource,ee.frame,c||o),ye.dispatchEvent({type:ee.type,data:ee.inputSource}))}function G(){s.removeEventListener("select",Z),s.removeEventListener("selectstart",Z),s.removeEventListener("selectend",Z),s.removeEventListener("squeeze",Z),s.removeEventListener("squeezestart",Z),s.removeEventListener("squeezeend",Z),s.removeEventListener("end",G),s.removeEventListener("inputsourceschange",ce);for(let ee=0;ee<C.length;ee++){let ge=S[ee];ge!==null&&(S[ee]=null,C[ee].disconnect(ge))}N=null,V=null,g.reset();for(let ee in m)delete m[ee];if(e.setRenderTarget(T),f=null,u=null,d=null,s=null,M=null,fe.stop(),n.isPresenting=!1,e.setPixelRatio(E),e.setSize(x.width,x.height,!1),O!==null){let ee=O.camera;ee.fov=O.fov,ee.zoom=O.zoom,ee.updateProjectionMatrix(),O=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(ee){r=ee,n.isPresenting===!0&&Ke("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(ee){a=ee,n.isPresenting===!0&&Ke("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(ee){c=ee},this.getBaseLayer=function(){return u!==null?u:f},this.getBinding=function(){return d===null&&v&&(d=new XRWebGLBinding(s,t)),d},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(ee){if(s=ee,s!==null){if(T=e.getRenderTarget(),s.addEventListener("select",Z),s.addEventListener("selectstart",Z),s.addEventListener("selectend",Z),s.addEventListener("squeeze",Z),s.addEventListener("squeezestart",Z),s.addEventListener("squeezeend",Z),s.addEventListener("end",G),s.addEventListener("inputsourceschange",ce),_.xrCompatible!==!0&&await t.makeXRCompatible(),E=e.getPixelRatio(),e.getSize(x),v&&"createProjectionLayer"in XRWebGLBinding.prototype){let ye=null,Re=null,Se=null;_.depth&&(Se=_.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,ye=_.stencil?Us:Cs,Re=_.stencil?Fr:Xi);let Ye={colorFormat:t.RGBA8,depthFormat:Se,scaleFactor:r};d=this.getBinding(),u=d.createProjectionLayer(Ye),s.updateRenderState({layers:[u]}),e.setPixelRatio(1),e.setSize(u.textureWidth,u.textureHeight,!1),M=new vi(u.textureWidth,u.textureHeight,{format:Zi,type:ci,depthTexture:new Is(u.textureWidth,u.textureHeight,Re,void 0,void 0,void 0,void 0,void 0,void 0,ye),stencilBuffer:_.stencil,colorSpace:e.outputColorSpace,samples:_.antialias?4:0,resolveDepthBuffer:u.ignoreDepthValues===!1,resolveStencilBuffer:u.ignoreDepthValues===!1,storeMultisampledDepthBuffer:u.ignoreDepthValues===!1,storeMultisampledStencilBuffer:u.ignoreDepthValues===!1})}else{let ye={antialias:_.antialias,alpha:!0,depth:_.depth,stencil:_.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,t,ye),s.updateRenderState({baseLayer:f}),e.setPixelRatio(1),e.setSize(f.framebufferWidth,f.framebufferHeight,!1),M=new vi(f.framebufferWidth,f.framebufferHeight,{format:Zi,type:ci,colorSpace:e.outputColorSpace,stencilBuffer:_.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}M.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),fe.setContext(s),fe.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function ce(ee){for(let ge=0;ge<ee.removed.length;ge++){let ye=ee.removed[ge],Re=S.indexOf(ye);Re>=0&&(S[Re]=null,C[Re].disconnect(ye))}for(let ge=0;ge<ee.added.length;ge++){let ye=ee.added[ge],Re=S.indexOf(ye);if(Re===-1){for(let Ye=0;Ye<C.length;Ye++)if(Ye>=S.length){S.push(ye),Re=Ye;break}else if(S[Ye]===null){S[Ye]=ye,Re=Ye;break}if(Re===-1)break}let Se=C[Re];Se&&Se.connect(ye)}}function Y(ee,ge){ge===null?ee.matrixWorld.copy(ee.matrix):ee.matrixWorld.multiplyMatrices(ge.matrixWorld,ee.matrix),ee.matrixWorldInverse.copy(ee.matrixWorld).invert()}this.updateCamera=function(ee){if(s===null)return;let ge=ee.near,ye=ee.far;g.texture!==null&&(g.depthNear>0&&(ge=g.depthNear),g.depthFar>0&&(ye=g.depthFar)),W.near=D.near=P.near=ge,W.far=D.far=P.far=ye,(N!==W.near||V!==W.far)&&(s.updateRenderState({depthNear:W.near,depthFar:W.far}),N=W.near,V=W.far),W.layers.mask=ee.layers.mask|6,P.layers.mask=W.layers.mask&-5,D.layers.mask=W.layers.mask&-3;let Re=ee.parent,Se=W.cameras;Y(W,Re);for(let Ye=0;Ye<Se.length;Ye++)Y(Se[Ye],Re);W.projectionMatrix.copy(P.projectionMatrix),W.projectionMatrixInverse.copy(P.projectionMatrixInverse),O===null&&ee.isPerspectiveCamera&&(O={camera:ee,fov:ee.fov,zoom:ee.zoom}),Q(ee,W,Re)};function Q(ee,ge,ye){ye===null?ee.matrix.copy(ge.matrixWorld):(ee.matrix.copy(ye.matrixWorld),ee.matrix.invert(),ee.matrix.multiply(ge.matrixWorld)),ee.matrix.decompose(ee.position,ee.quaternion,ee.scale),ee.updateMatrixWorld(!0),ee.projectionMatrix.copy(ge.projectionMatrix),ee.projectionMatrixInverse.copy(ge.projectionMatrixInverse),ee.isPerspectiveCamera&&(ee.fov=Oo*2*Math.atan(1/ee.projectionMatrix.elements[5]),ee.zoom=1)}this.getCamera=function(){return W},this.getFoveation=function(){if(!(u===null&&f===null))return l},this.setFoveation=function(ee){l=ee,u!==null&&(u.fixedFoveation=ee),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=ee)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(W)},this.getCameraTexture=function(ee){return m[ee]};let ie=null;function de(ee,ge){if(h=ge.getViewerPose(c||o),p=ge,h!==null){let ye=h.views;f!==null&&(e.setRenderTargetFramebuffer(M,f.framebuffer),e.setRenderTarget(M));let Re=!1;ye.length!==W.cameras.length&&(W.cameras.length=0,Re=!0);for(let Xe=0;Xe<ye.length;Xe++){let pt=ye[Xe],ut=null;if(f!==null)ut=f.getViewport(pt);else{let Qt=d.getViewSubImage(u,pt);ut=Qt.viewport,Xe===0&&(e.setRenderTargetTextures(M,Qt.colorTexture,Qt.depthStencilTexture),e.setRenderTarget(M))}let rt=z[Xe];rt===void 0&&(rt=new ii,rt.layers.enable(Xe),rt.viewport=new tn,z[Xe]=rt),rt.matrix.fromArray(pt.transform.matrix),rt.matrix.decompose(rt.position,rt.quaternion,rt.scale),rt.projectionMatrix.fromArray(pt.projectionMatrix),rt.projectionMatrixInverse.copy(rt.projectionMatrix).invert(),rt.viewport.set(ut.x,ut.y,ut.width,ut.height),Xe===0&&(W.matrix.copy(rt.matrix),W.matrix.decompose(W.position,W.quaternion,W.scale)),Re===!0&&W.cameras.push(rt)}let Se=s.enabledFeatures;if(Se&&Se.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&v){d=n.getBinding();let Xe=d.getDepthInformation(ye[0]);Xe&&Xe.isValid&&Xe.texture&&g.init(Xe,s.renderState)}if(Se&&Se.includes("camera-access")&&v){e.state.unbindTexture(),d=n.getBinding();for(let Xe=0;Xe<ye.length;Xe++){let pt=ye[Xe].camera;if(pt){let ut=m[pt];ut||(ut=new Za,m[pt]=ut);let rt=d.getCameraImage(pt);ut.sourceTexture=rt}}}}for(let ye=0;ye<C.length;ye++){let Re=S[ye],Se=C[ye];Re!==null&&Se!==void 0&&Se.update(Re,ge,c||o)}ie&&ie(ee,ge),ge.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:ge}),p=null}let fe=new lx;fe.setAnimationLoop(de),this.setAnimationLoop=function(ee){ie=ee},this.dispose=function(){}}},T1=new yt,_x=new st;_x.set(-1,0,0,0,1,0,0,0,1);function A1(i,e){function t(g,m){g.matrixAutoUpdate===!0&&g.updateMatrix(),m.value.copy(g.matrix)}function n(g,m){m.color.getRGB(g.fogColor.value,Nf(i)),m.isFog?(g.fogNear.value=m.near,g.fogFar.value=m.far):m.isFogExp2&&(g.fogDensity.value=m.density)}function s(g,m,_,T,M){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?r(g,m):m.isMeshLambertMaterial?(r(g,m),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(r(g,m),d(g,m)):m.isMeshPhongMaterial?(r(g,m),h(g,m),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(r(g,m),u(g,m),m.isMeshPhysicalMaterial&&f(g,m,M)):m.isMeshMatcapMaterial?(r(g,m),p(g,m)):m.isMeshDepthMaterial?r(g,m):m.isMeshDistanceMaterial?(r(g,m),v(g,m)):m.isMeshNormalMaterial?r(g,m):m.isLineBasicMaterial?(o(g,m),m.isLineDashedMaterial&&a(g,m)):m.isPointsMaterial?l(g,m,_,T):m.isSpriteMaterial?c(g,m):m.isShadowMaterial?(g.color.value.copy(m.color),g.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function r(g,m){g.opacity.value=m.opacity,m.color&&g.diffuse.value.copy(m.color),m.emissive&&g.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(g.map.value=m.map,t(m.map,g.mapTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,t(m.alphaMap,g.alphaMapTransform)),m.bumpMap&&(g.bumpMap.value=m.bumpMap,t(m.bumpMap,g.bumpMapTransform),g.bumpScale.value=m.bumpScale,m.side===Gn&&(g.bumpScale.value*=-1)),m.normalMap&&(g.normalMap.value=m.normalMap,t(m.normalMap,g.normalMapTransform),g.normalScale.value.copy(m.normalScale),m.side===Gn&&g.normalScale.value.negate()),m.displacementMap&&(g.displacementMap.value=m.displacementMap,t(m.displacementMap,g.displacementMapTransform),g.displacementScale.value=m.displacementScale,g.displacementBias.value=m.displacementBias),m.emissiveMap&&(g.emissiveMap.value=m.emissiveMap,t(m.emissiveMap,g.emissiveMapTransform)),m.specularMap&&(g.specularMap.value=m.specularMap,t(m.specularMap,g.specularMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest);let _=e.get(m),T=_.envMap,M=_.envMapRotation;T&&(g.envMap.value=T,g.envMapRotation.value.setFromMatrix4(T1.makeRotationFromEuler(M)).transpose(),T.isCubeTexture&&T.isRenderTargetTexture===!1&&g.envMapRotation.value.premultiply(_x),g.reflectivity.value=m.reflectivity,g.ior.value=m.ior,g.refractionRatio.value=m.refractionRatio),m.lightMap&&(g.lightMap.value=m.lightMap,g.lightMapIntensity.value=m.lightMapIntensity,t(m.lightMap,g.lightMapTransform)),m.aoMap&&(g.aoMap.value=m.aoMap,g.aoMapIntensity.value=m.aoMapIntensity,t(m.aoMap,g.aoMapTransform))}function o(g,m){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,m.map&&(g.map.value=m.map,t(m.map,g.mapTransform))}function a(g,m){g.dashSize.value=m.dashSize,g.totalSize.value=m.dashSize+m.gapSize,g.scale.value=m.scale}function l(g,m,_,T){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,g.size.value=m.size*_,g.scale.value=T*.5,m.map&&(g.map.value=m.map,t(m.map,g.uvTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,t(m.alphaMap,g.alphaMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest)}function c(g,m){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,g.rotation.value=m.rotation,m.map&&(g.map.value=m.map,t(m.map,g.mapTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,t(m.alphaMap,g.alphaMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest)}function h(g,m){g.specular.value.copy(m.specular),g.shininess.value=Math.max(m.shininess,1e-4)}function d(g,m){m.gradientMap&&(g.gradientMap.value=m.gradientMap)}function u(g,m){g.metalness.value=m.metalness,m.metalnessMap&&(g.metalnessMap.value=m.metalnessMap,t(m.metalnessMap,g.metalnessMapTransform)),g.roughness.value=m.roughness,m.roughnessMap&&(g.roughnessMap.value=m.roughnessMap,t(m.roughnessMap,g.roughnessMapTransform)),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)}function f(g,m,_){g.ior.value=m.ior,m.diffuseRoughness>0&&(g.diffuseRoughness.value=m.diffuseRoughness,m.diffuseRoughnessMap&&(g.diffuseRoughnessMap.value=m.diffuseRoughnessMap,t(m.diffuseRoughnessMap,g.diffuseRoughnessMapTransform))),m.sheen>0&&(g.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),g.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(g.sheenColorMap.value=m.sheenColorMap,t(m.sheenColorMap,g.sheenColorMapTransform)),m.sheenRoughnessMap&&(g.sheenRoughnessMap.value=m.sheenRoughnessMap,t(m.sheenRoughnessMap,g.sheenRoughnessMapTransform))),m.clearcoat>0&&(g.clearcoat.value=m.clearcoat,g.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(g.clearcoatMap.value=m.clearcoatMap,t(m.clearcoatMap,g.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,t(m.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(g.clearcoatNormalMap.value=m.clearcoatNormalMap,t(m.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===Gn&&g.clearcoatNormalScale.value.negate())),m.dispersion>0&&(g.dispersion.value=m.dispersion),m.retroreflectivity>0&&(g.retroreflectivity.value=m.retroreflectivity),m.iridescence>0&&(g.iridescence.value=m.iridescence,g.iridescenceIOR.value=m.iridescenceIOR,g.iridescenceThicknessMinimum.value=m.iridescenceThicknessMinimum,g.iridescenceThicknessMaximum.value=m.iridescenceThicknessMaximum,m.iridescenceMap&&(g.iridescenceMap.value=m.iridescenceMap,t(m.iridescenceMap,g.iridescenceMapTransform)),m.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=m.iridescenceThicknessMap,t(m.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),m.transmission>0&&(g.transmission.value=m.transmission,g.transmissionSamplerMap.value=_.texture,g.transmissionSamplerSize.value.set(_.width,_.height),m.transmissionMap&&(g.transmissionMap.value=m.transmissionMap,t(m.transmissionMap,g.transmissionMapTransform)),g.thickness.value=m.thickness,m.thicknessMap&&(g.thicknessMap.value=m.thicknessMap,t(m.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=m.attenuationDistance,g.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(g.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(g.anisotropyMap.value=m.anisotropyMap,t(m.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=m.specularIntensity,g.specularColor.value.copy(m.specularColor),m.specularColorMap&&(g.specularColorMap.value=m.specularColorMap,t(m.specularColorMap,g.specularColorMapTransform)),m.specularIntensityMap&&(g.specularIntensityMap.value=m.specularIntensityMap,t(m.specularIntensityMap,g.specularIntensityMapTransform))}function p(g,m){m.matcap&&(g.matcap.value=m.matcap)}function v(g,m){let _=e.get(m).light;g.referencePosition.value.setFromMatrixPosition(_.matrixWorld),g.nearDistance.value=_.shadow.camera.near,g.farDistance.value=_.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function R1(i,e,t,n){let s={},r={};function o(_,T){let M=T.program;n.uniformBlockBinding(_,M,s[_.id])}function a(_,T){let M=s[_.id];M===void 0&&(p(_),M=l(_),s[_.id]=M,_.addEventListener("dispose",g));let C=T.program;n.updateUBOMapping(_,C);let S=e.render.frame;r[_.id]!==S&&(c(_),r[_.id]=S)}function l(_){let T=i.createBuffer(),M=_.__size,C=_.usage;return i.bindBuffer(i.UNIFORM_BUFFER,T),i.bufferData(i.UNIFORM_BUFFER,M,C),i.bindBuffer(i.UNIFORM_BUFFER,null),T}function c(_){let T=s[_.id],M=_.uniforms,C=_.__cache;i.bindBuffer(i.UNIFORM_BUFFER,T);for(let S=0,x=M.length;S<x;S++){let E=M[S];if(Array.isArray(E))for(let O=0,P=E.length;O<P;O++)h(E[O],S,O,C);else h(E,S,0,C)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function h(_,T,M,C){if(u(_,T,M,C)===!0){let S=_.__offset,x=_.value;if(Array.isArray(x)){let E=0;for(let O=0;O<x.length;O++){let P=x[O],D=v(P,!0);d(P,_.__data,E),E+=D.storage/Float32Array.BYTES_PER_ELEMENT}}else d(x,_.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,S,_.__data)}}function d(_,T,M){typeof _=="number"||typeof _=="boolean"?T[M]=_:_.isMatrix3?(T[M]=_.elements[0],T[M+1]=_.elements[1],T[M+2]=_.elements[2],T[M+3]=0,T[M+4]=_.elements[3],T[M+5]=_.elements[4],T[M+6]=_.elements[5],T[M+7]=0,T[M+8]=_.elements[6],T[M+9]=_.elements[7],T[M+10]=_.elements[8],T[M+11]=0):ArrayBuffer.isView(_)?T.set(_.subarray(0,T.length-M),M):_.toArray(T,M)}function u(_,T,M,C){let S=_.value,x=T+"_"+M;if(Array.isArray(S)){C[x]===void 0&&(C[x]=[]);let E=C[x],O=!1;for(let P=0;P<S.length;P++)f(S[P],E,P)===!0&&(O=!0);return O}return f(S,C,x)}function f(_,T,M){if(T[M]===void 0)return typeof _=="number"||typeof _=="boolean"?T[M]=_:ArrayBuffer.isView(_)?T[M]=_.slice():T[M]=_.clone(),!0;{let C=T[M];if(typeof _=="number"||typeof _=="boolean"){if(C!==_)return T[M]=_,!0}else{if(ArrayBuffer.isView(_))return!0;if(C.equals(_)===!1)return C.copy(_),!0}}return!1}function p(_){let T=_.uniforms,M=0,C=16;for(let x=0,E=T.length;x<E;x++){let O=Array.isArray(T[x])?T[x]:[T[x]];for(let P=0,D=O.length;P<D;P++){let z=O[P],W=Array.isArray(z.value)?z.value:[z.value],N=Array.isArray(T[x])||Array.isArray(z.value),V=M;for(let G=0,ce=W.length;G<ce;G++){let Y=W[G],Q=v(Y,N),ie=M%C,de=ie%Q.boundary,fe=ie+de;M+=de,fe!==0&&C-fe<Q.storage&&(M+=C-fe),G===0&&(V=M),M+=Q.storage}let Z=z.type==="int"?Int32Array:z.type==="uint"?Uint32Array:Float32Array;z.__data=new Z((M-V)/Float32Array.BYTES_PER_ELEMENT),z.__offset=V}}let S=M%C;return S>0&&(M+=C-S),_.__size=M,_.__cache={},this}function v(_,T){let M={boundary:0,storage:0};return typeof _=="number"||typeof _=="boolean"?(M.boundary=4,M.storage=4):_.isVector2?(M.boundary=8,M.storage=8):_.isVector3||_.isColor?(M.boundary=16,M.storage=12):_.isVector4?(M.boundary=16,M.storage=16):_.isMatrix3?(M.boundary=16,M.storage=48):_.isMatrix4?(M.boundary=16,M.storage=64):_.isTexture?Ke("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(_)?(M.boundary=16,M.storage=_.byteLength):Ke("WebGLRenderer: Unsupported uniform value type.",_),T===!0&&(M.boundary=16,M.storage=Math.ceil(M.storage/16)*16),M}function g(_){let T=_.target;T.removeEventListener("dispose",g),i.deleteBuffer(s[T.id]),delete s[T.id],delete r[T.id]}function m(){for(let _ in s)i.deleteBuffer(s[_]);s={},r={}}return{bind:o,update:a,dispose:m}}var C1=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),us=null;function P1(){return us===null&&(us=new Vc(C1,16,16,or,Yi),us.name="DFG_LUT",us.minFilter=si,us.magFilter=si,us.wrapS=os,us.wrapT=os,us.generateMipmaps=!1,us.needsUpdate=!0),us}var Qh=class{constructor(e={}){let{canvas:t=L0(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:d=!1,reversedDepthBuffer:u=!1,outputBufferType:f=ci}=e;this.isWebGLRenderer=!0;let p;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=n.getContextAttributes().alpha}else p=o;let v=f,g=new Set([xh,gh,mh]),m=new Set([ci,Xi,$o,Fr,fh,ph]),_=new Uint32Array(4),T=new Int32Array(4),M={textures:[],min:[],max:[],resolution:[]},C=null,S=null,x=[],E=[],O=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=hs,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let P=this,D=!1,z=null,W=null,N=null,V=null;this._outputColorSpace=Mn;let Z=0,G=0,ce=null,Y=-1,Q=null,ie=new tn,de=new tn,fe=null,ee=new Je(0),ge=0,ye=t.width,Re=t.height,Se=1,Ye=null,at=null,Xe=new tn(0,0,ye,Re),pt=new tn(0,0,ye,Re),ut=!1,rt=new Qs,Qt=new Wc,Gt=!1,pn=!1,Ot=new yt,Ln=new U,St=new tn,wn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},rn=!1;function mn(){return ce===null?Se:1}let B=n;function Ie(R,H){return t.getContext(R,H)}let je,lt,we,kt,Ve,$e,I,w,q,ue,ae,_e,ve,te,se,me,k,oe,ne,Ee,xe,Me,qe;try{let R={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:d};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",ze,!1),t.addEventListener("webglcontextrestored",nt,!1),t.addEventListener("webglcontextcreationerror",Ce,!1),B===null){let H="webgl2";if(B=Ie(H,R),B===null)throw Ie(H)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}tt()}catch(R){throw t.removeEventListener("webglcontextlost",ze,!1),t.removeEventListener("webglcontextrestored",nt,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),et("WebGLRenderer: "+R.message),R}function tt(){je=new Hw(B),je.init(),xe=new S1(B,je),lt=new Pw(B,je,e,xe),we=new b1(B,je),lt.reversedDepthBuffer&&u&&we.buffers.depth.setReversed(!0),W=B.createFramebuffer(),N=B.createFramebuffer(),V=B.createFramebuffer(),kt=new Ww(B),Ve=new a1,$e=new M1(B,je,we,Ve,lt,xe,kt),I=new zw(P),w=new qb(B),Me=new Rw(B,w),q=new Gw(B,w,kt,Me),ue=new qw(B,q,w,Me,kt),oe=new Xw(B,lt,$e),se=new Iw(Ve),ae=new o1(P,I,je,lt,Me,se),_e=new A1(P,Ve),ve=new c1,te=new m1(je),k=new Aw(P,I,we,ue,p,l),me=new v1(P,ue,lt),qe=new R1(B,kt,lt,we),ne=new Cw(B,je,kt),Ee=new Vw(B,je,kt),kt.programs=ae.programs,P.capabilities=lt,P.extensions=je,P.properties=Ve,P.renderLists=ve,P.shadowMap=me,P.state=we,P.info=kt}v!==ci&&(O=new Zw(v,t.width,t.height,a,s,r));let he=new Yf(P,B);this.xr=he,this.getContext=function(){return B},this.getContextAttributes=function(){return B.getContextAttributes()},this.forceContextLoss=function(){let R=je.get("WEBGL_lose_context");R&&R.loseContext()},this.forceContextRestore=function(){let R=je.get("WEBGL_lose_context");R&&R.restoreContext()},this.getPixelRatio=function(){return Se},this.setPixelRatio=function(R){R!==void 0&&(Se=R,this.setSize(ye,Re,!1))},this.getSize=function(R){return R.set(ye,Re)},this.setSize=function(R,H,J=!0){if(he.isPresenting){Ke("WebGLRenderer: Can't change size while VR device is presenting.");return}ye=R,Re=H,t.width=Math.floor(R*Se),t.height=Math.floor(H*Se),J===!0&&(t.style.width=R+"px",t.style.height=H+"px"),O!==null&&O.setSize(t.width,t.height),this.setViewport(0,0,R,H)},this.getDrawingBufferSize=function(R){return R.set(ye*Se,Re*Se).floor()},this.setDrawingBufferSize=function(R,H,J){ye=R,Re=H,Se=J,t.width=Math.floor(R*J),t.height=Math.floor(H*J),this.setViewport(0,0,R,H)},this.setEffects=function(R){if(v===ci){et("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(R){for(let H=0;H<R.length;H++)if(R[H].isOutputPass===!0){Ke("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}O.setEffects(R||[])},this.getCurrentViewport=function(R){return R.copy(ie)},this.getViewport=function(R){return R.copy(Xe)},this.setViewport=function(R,H,J,$){R.isVector4?Xe.set(R.x,R.y,R.z,R.w):Xe.set(R,H,J,$),we.viewport(ie.copy(Xe).multiplyScalar(mn()).round())},this.getScissor=function(R){return R.copy(pt)},this.setScissor=function(R,H,J,$){R.isVector4?pt.set(R.x,R.y,R.z,R.w):pt.set(R,H,J,$),we.scissor(de.copy(pt).multiplyScalar(mn()).round())},this.getScissorTest=function(){return ut},this.setScissorTest=function(R){we.setScissorTest(ut=R)},this.setOpaqueSort=function(R){Ye=R},this.setTransparentSort=function(R){at=R},this.getClearColor=function(R){return R.copy(k.getClearColor())},this.setClearColor=function(){k.setClearColor(...arguments)},this.getClearAlpha=function(){return k.getClearAlpha()},this.setClearAlpha=function(){k.setClearAlpha(...arguments)},this.clear=function(R=!0,H=!0,J=!0){let $=0;if(R){let K=!1;if(ce!==null){let Te=ce.texture.format;K=g.has(Te)}if(K){let Te=ce.texture.type,Le=m.has(Te),Ae=k.getClearColor(),Ne=k.getClearAlpha(),Ge=Ae.r,it=Ae.g,mt=Ae.b;Le?(_[0]=Ge,_[1]=it,_[2]=mt,_[3]=Ne,B.clearBufferuiv(B.COLOR,0,_)):(T[0]=Ge,T[1]=it,T[2]=mt,T[3]=Ne,B.clearBufferiv(B.COLOR,0,T))}else $|=B.COLOR_BUFFER_BIT}H&&($|=B.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),J&&($|=B.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),$!==0&&B.clear($)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(R){R.setRenderer(this),z=R},this.dispose=function(){t.removeEventListener("webglcontextlost",ze,!1),t.removeEventListener("webglcontextrestored",nt,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),k.dispose(),ve.dispose(),te.dispose(),$e.dispose(),Ve.dispose(),I.dispose(),ue.dispose(),q.dispose(),Me.dispose(),qe.dispose(),ae.dispose(),he.dispose(),he.removeEventListener("sessionstart",Dl),he.removeEventListener("sessionend",Ki),ms.stop()};function ze(R){R.preventDefault(),Ua("WebGLRenderer: Context Lost."),D=!0}function nt(){Ua("WebGLRenderer: Context Restored."),D=!1;let R=kt.autoReset,H=me.enabled,J=me.autoUpdate,$=me.needsUpdate,K=me.type;tt(),kt.autoReset=R,me.enabled=H,me.autoUpdate=J,me.needsUpdate=$,me.type=K}function Ce(R){et("WebGLRenderer: A WebGL context could not be created. Reason: ",R.statusMessage)}function ct(R){let H=R.target;H.removeEventListener("dispose",ct),Xt(H)}function Xt(R){$n(R),Ve.remove(R)}function $n(R){let H=Ve.get(R).programs;H!==void 0&&(H.forEach(function(J){ae.releaseProgram(J)}),R.isShaderMaterial&&ae.releaseShaderCache(R))}this.renderBufferDirect=function(R,H,J,$,K,Te){H===null&&(H=wn);let Le=K.isMesh&&K.matrixWorld.determinantAffine()<0,Ae=oa(R,H,J,$,K);we.setMaterial($,Le);let Ne=J.index,Ge=1;if($.wireframe===!0){if(Ne=q.getWireframeAttribute(J),Ne===void 0)return;Ge=2}let it=J.drawRange,mt=J.attributes.position,He=it.start*Ge,gt=(it.start+it.count)*Ge;Te!==null&&(He=Math.max(He,Te.start*Ge),gt=Math.min(gt,(Te.start+Te.count)*Ge)),Ne!==null?(He=Math.max(He,0),gt=Math.min(gt,Ne.count)):mt!=null&&(He=Math.max(He,0),gt=Math.min(gt,mt.count));let sn=gt-He;if(sn<0||sn===1/0)return;Me.setup(K,$,Ae,J,Ne);let Dt,Nt=ne;if(Ne!==null&&(Dt=w.get(Ne),Nt=Ee,Nt.setIndex(Dt)),K.isMesh)$.wireframe===!0?(we.setLineWidth($.wireframeLinewidth*mn()),Nt.setMode(B.LINES)):Nt.setMode(B.TRIANGLES);else if(K.isLine){let En=$.linewidth;En===void 0&&(En=1),we.setLineWidth(En*mn()),K.isLineSegments?Nt.setMode(B.LINES):K.isLineLoop?Nt.setMode(B.LINE_LOOP):Nt.setMode(B.LINE_STRIP)}else K.isPoints?Nt.setMode(B.POINTS):K.isSprite&&Nt.setMode(B.TRIANGLES);if(K.isBatchedMesh)if(je.get("WEBGL_multi_draw"))Nt.renderMultiDraw(K._multiDrawStarts,K._multiDrawCounts,K._multiDrawCount);else{let En=K._multiDrawStarts,ke=K._multiDrawCounts,gn=K._multiDrawCount,vt=Ne?w.get(Ne).bytesPerElement:1,xs=Ve.get($).currentProgram.getUniforms();for(let xn=0;xn<gn;xn++)xs.setValue(B,"_gl_DrawID",xn),Nt.render(En[xn]/vt,ke[xn])}else if(K.isInstancedMesh)Nt.renderInstances(He,sn,K.count);else if(J.isInstancedBufferGeometry){let En=J._maxInstanceCount!==void 0?J._maxInstanceCount:1/0,ke=Math.min(J.instanceCount,En);Nt.renderInstances(He,sn,ke)}else Nt.render(He,sn)};function ia(R,H,J,$){z!==null&&R.isNodeMaterial&&z.setObject($,R),Gt===!0&&se.setState(R,J,!1),R.transparent===!0&&R.side===li&&R.forceSinglePass===!1?(R.side=Gn,R.needsUpdate=!0,ji(R,H,$),R.side=cs,R.needsUpdate=!0,ji(R,H,$),R.side=li):ji(R,H,$)}this.compile=function(R,H,J=null){J===null&&(J=R),z!==null&&z.renderStart(R,H,J),S=te.get(J),S.init(H),E.push(S),J.traverseVisible(function(K){K.isLight&&K.layers.test(H.layers)&&(S.pushLight(K),K.castShadow&&S.pushShadow(K))}),R!==J&&R.traverseVisible(function(K){K.isLight&&K.layers.test(H.layers)&&(S.pushLight(K),K.castShadow&&S.pushShadow(K))}),S.setupLights(),z!==null&&z.updateLights(S.state.lightsArray),pn=this.localClippingEnabled,Gt=se.init(this.clippingPlanes,pn),Gt===!0&&se.setGlobalState(this.clippingPlanes,H),z!==null&&me.render(S.state.shadowsArray,J,H);let $=new Set;return R.traverse(function(K){if(!(K.isMesh||K.isPoints||K.isLine||K.isSprite))return;let Te=K.material;if(Te)if(Array.isArray(Te))for(let Le=0;Le<Te.length;Le++){let Ae=Te[Le];ia(Ae,J,H,K),$.add(Ae)}else ia(Te,J,H,K),$.add(Te)}),S=E.pop(),z!==null&&z.renderEnd(),$},this.compileAsync=function(R,H,J=null){let $=this.compile(R,H,J);return new Promise(K=>{function Te(){if($.forEach(function(Le){let Ne=Ve.get(Le).currentProgram;(Ne===void 0||Ne.isReady())&&$.delete(Le)}),$.size===0){K(R);return}setTimeout(Te,10)}je.get("KHR_parallel_shader_compile")!==null?Te():setTimeout(Te,10)})};let Xr=null;function Ou(R){Xr&&Xr(R)}function Dl(){ms.stop()}function Ki(){ms.start()}let ms=new lx;ms.setAnimationLoop(Ou),typeof self<"u"&&ms.setContext(self),this.setAnimationLoop=function(R){Xr=R,he.setAnimationLoop(R),R===null?ms.stop():ms.start()},he.addEventListener("sessionstart",Dl),he.addEventListener("sessionend",Ki),this.render=function(R,H){if(H!==void 0&&H.isCamera!==!0){et("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(D===!0)return;z!==null&&z.renderStart(R,H);let J=he.enabled===!0&&he.isPresenting===!0,$=O!==null&&(ce===null||J)&&O.begin(P,ce);if(R.matrixWorldAutoUpdate===!0&&R.updateMatrixWorld(),H.parent===null&&H.matrixWorldAutoUpdate===!0&&H.updateMatrixWorld(),he.enabled===!0&&he.isPresenting===!0&&(O===null||O.isCompositing()===!1)&&(he.cameraAutoUpdate===!0&&he.updateCamera(H),H=he.getCamera()),R.isScene===!0&&R.onBeforeRender(P,R,H,ce),S=te.get(R,E.length),S.init(H),S.state.textureUnits=$e.getTextureUnits(),E.push(S),Ot.multiplyMatrices(H.projectionMatrix,H.matrixWorldInverse),H.isArrayCamera?Qt.setFromArrayCamera(H):rt.setFromProjectionMatrix(Ot,Ai,H.reversedDepth),pn=this.localClippingEnabled,Gt=se.init(this.clippingPlanes,pn),C=ve.get(R,x.length),C.init(),x.push(C),this.info.render.frame++,he.enabled===!0&&he.isPresenting===!0){let Le=P.xr.getDepthSensingMesh();Le!==null&&gs(Le,H,-1/0,P.sortObjects)}gs(R,H,0,P.sortObjects),C.finish(),z!==null&&z.updateLights(S.state.lightsArray),P.sortObjects===!0&&C.sort(Ye,at),rn=he.enabled===!1||he.isPresenting===!1||he.hasDepthSensing()===!1,rn&&k.addToRenderList(C,R),this.info.autoReset===!0&&this.info.reset(),Gt===!0&&se.beginShadows();let K=S.state.shadowsArray;if(me.render(K,R,H),Gt===!0&&se.endShadows(),($&&O.hasRenderPass())===!1){let Le=C.opaque,Ae=C.transmissive;if(S.setupLights(),H.isArrayCamera){let Ne=H.cameras;if(Ae.length>0)for(let Ge=0,it=Ne.length;Ge<it;Ge++){let mt=Ne[Ge];Ui(Le,Ae,R,mt)}rn&&k.render(R);for(let Ge=0,it=Ne.length;Ge<it;Ge++){let mt=Ne[Ge];sa(C,R,mt,mt.viewport)}}else Ae.length>0&&Ui(Le,Ae,R,H),rn&&k.render(R),sa(C,R,H)}ce!==null&&G===0&&($e.updateMultisampleRenderTarget(ce),$e.updateRenderTargetMipmap(ce)),$&&O.end(P),R.isScene===!0&&R.onAfterRender(P,R,H),Me.resetDefaultState(),Y=-1,Q=null,E.pop(),E.length>0?(S=E[E.length-1],$e.setTextureUnits(S.state.textureUnits),Gt===!0&&se.setGlobalState(P.clippingPlanes,S.state.camera)):S=null,x.pop(),x.length>0?C=x[x.length-1]:C=null,z!==null&&z.renderEnd()};function gs(R,H,J,$){if(R.visible===!1)return;if(R.layers.test(H.layers)){if(R.isGroup)J=R.renderOrder;else if(R.isLOD)R.autoUpdate===!0&&R.update(H);else if(R.isLight)S.pushLight(R),R.castShadow&&S.pushShadow(R);else if(R.isSprite){let Le=H.isArrayCamera?Qt:rt;if(!R.frustumCulled||R.intersectsFrustum(Le)){$&&St.setFromMatrixPosition(R.matrixWorld).applyMatrix4(Ot);let Ae=ue.update(R),Ne=R.material;Ne.visible&&C.push(R,Ae,Ne,J,St.z,null,H)}}else if(R.isMesh||R.isLine||R.isPoints){let Le=H.isArrayCamera?Qt:rt;if(!R.frustumCulled||R.intersectsFrustum(Le)){let Ae=ue.update(R),Ne=R.material;if($&&(R.boundingSphere!==void 0?(R.boundingSphere===null&&R.computeBoundingSphere(),St.copy(R.boundingSphere.center)):(Ae.boundingSphere===null&&Ae.computeBoundingSphere(),St.copy(Ae.boundingSphere.center)),St.applyMatrix4(R.matrixWorld).applyMatrix4(Ot)),Array.isArray(Ne)){let Ge=Ae.groups;for(let it=0,mt=Ge.length;it<mt;it++){let He=Ge[it],gt=Ne[He.materialIndex];gt&&gt.visible&&C.push(R,Ae,gt,J,St.z,He,H)}}else Ne.visible&&C.push(R,Ae,Ne,J,St.z,null,H)}}}let Te=R.children;for(let Le=0,Ae=Te.length;Le<Ae;Le++)gs(Te[Le],H,J,$)}function sa(R,H,J,$){let{opaque:K,transmissive:Te,transparent:Le}=R;S.setupLightsView(J),Gt===!0&&se.setGlobalState(P.clippingPlanes,J),$&&we.viewport(ie.copy($)),K.length>0&&on(K,H,J),Te.length>0&&on(Te,H,J),Le.length>0&&on(Le,H,J),we.buffers.depth.setTest(!0),we.buffers.depth.setMask(!0),we.buffers.color.setMask(!0),we.setPolygonOffset(!1)}function Ui(R,H,J,$){if((J.isScene===!0?J.overrideMaterial:null)!==null)return;if(S.state.transmissionRenderTarget[$.id]===void 0){let He=je.has("EXT_color_buffer_half_float")||je.has("EXT_color_buffer_float");S.state.transmissionRenderTarget[$.id]=new vi(1,1,{generateMipmaps:!0,type:He?Yi:ci,minFilter:Ns,samples:Math.max(4,lt.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:Mt.workingColorSpace})}let Te=S.state.transmissionRenderTarget[$.id],Le=$.viewport||ie;Te.setSize(Le.z*P.transmissionResolutionScale,Le.w*P.transmissionResolutionScale);let Ae=P.getRenderTarget(),Ne=P.getActiveCubeFace(),Ge=P.getActiveMipmapLevel();P.setRenderTarget(Te),P.getClearColor(ee),ge=P.getClearAlpha(),ge<1&&P.setClearColor(16777215,.5),P.clear(),rn&&k.render(J);let it=P.toneMapping;P.toneMapping=hs;let mt=$.viewport;if($.viewport!==void 0&&($.viewport=void 0),S.setupLightsView($),Gt===!0&&se.setGlobalState(P.clippingPlanes,$),on(R,J,$),$e.updateMultisampleRenderTarget(Te),$e.updateRenderTargetMipmap(Te),je.has("WEBGL_multisampled_render_to_texture")===!1){let He=!1;for(let gt=0,sn=H.length;gt<sn;gt++){let Dt=H[gt],{object:Nt,geometry:En,material:ke,group:gn}=Dt;if(ke.side===li&&Nt.layers.test($.layers)){let vt=ke.side;ke.side=Gn,ke.needsUpdate=!0,dn(Nt,J,$,En,ke,gn),ke.side=vt,ke.needsUpdate=!0,He=!0}}He===!0&&($e.updateMultisampleRenderTarget(Te),$e.updateRenderTargetMipmap(Te))}P.setRenderTarget(Ae,Ne,Ge),P.setClearColor(ee,ge),mt!==void 0&&($.viewport=mt),P.toneMapping=it}function on(R,H,J){let $=H.isScene===!0?H.overrideMaterial:null;for(let K=0,Te=R.length;K<Te;K++){let Le=R[K],{object:Ae,geometry:Ne,group:Ge}=Le,it=Le.material;it.allowOverride===!0&&$!==null&&(it=$),Ae.layers.test(J.layers)&&dn(Ae,H,J,Ne,it,Ge)}}function dn(R,H,J,$,K,Te){z!==null&&K.isNodeMaterial&&z.setObject(R,K),R.onBeforeRender(P,H,J,$,K,Te),R.modelViewMatrix.multiplyMatrices(J.matrixWorldInverse,R.matrixWorld),R.normalMatrix.getNormalMatrix(R.modelViewMatrix),K.onBeforeRender(P,H,J,$,R,Te),K.transparent===!0&&K.side===li&&K.forceSinglePass===!1?(K.side=Gn,K.needsUpdate=!0,P.renderBufferDirect(J,H,$,K,R,Te),K.side=cs,K.needsUpdate=!0,P.renderBufferDirect(J,H,$,K,R,Te),K.side=li):P.renderBufferDirect(J,H,$,K,R,Te),R.onAfterRender(P,H,J,$,K,Te)}function fn(R){let H=0;for(let J of R)J.texture!==null&&H++;return H}function ji(R,H,J){H.isScene!==!0&&(H=wn);let $=Ve.get(R),K=S.state.lights,Te=S.state.shadowsArray,Le=K.state.version,Ae=ae.getParameters(R,K.state,Te,H,J,S.state.lightProbeGridArray),Ne=ae.getProgramCacheKey(Ae),Ge=$.programs;$.environment=R.isMeshStandardMaterial||R.isMeshLambertMaterial||R.isMeshPhongMaterial?H.environment:null,$.fog=H.fog;let it=R.isMeshStandardMaterial||R.isMeshLambertMaterial&&!R.envMap||R.isMeshPhongMaterial&&!R.envMap;$.envMap=I.get(R.envMap||$.environment,it),$.envMapRotation=$.environment!==null&&R.envMap===null?H.environmentRotation:R.envMapRotation,Ge===void 0&&(R.addEventListener("dispose",ct),Ge=new Map,$.programs=Ge,$.programVariants=new Map);let mt=Ge.get(Ne);if(mt!==void 0){if($.currentProgram===mt&&$.lightsStateVersion===Le)return ra(R,Ae),mt}else Ae.uniforms=ae.getUniforms(R),z!==null&&R.isNodeMaterial&&z.build(R,J,Ae),R.onBeforeCompile(Ae,P),mt=ae.acquireProgram(Ae,Ne),Ge.set(Ne,mt),$.uniforms=Ae.uniforms;let He=$.uniforms;return(!R.isShaderMaterial&&!R.isRawShaderMaterial||R.clipping===!0)&&(He.clippingPlanes=se.uniform),ra(R,Ae),$.needsLights=Bs(R),$.lightsStateVersion=Le,$.needsLights&&(He.ambientLightColor.value=K.state.ambient,He.lightProbe.value=K.state.probe,He.sunLights.value=K.state.sun,He.sunLightShadows.value=K.state.sunShadow,He.directionalLights.value=K.state.directional,He.directionalLightShadows.value=K.state.directionalShadow,He.spotLights.value=K.state.spot,He.spotLightShadows.value=K.state.spotShadow,He.rectAreaLights.value=K.state.rectArea,He.ltc_1.value=K.state.rectAreaLTC1,He.ltc_2.value=K.state.rectAreaLTC2,He.pointLights.value=K.state.point,He.pointLightShadows.value=K.state.pointShadow,He.hemisphereLights.value=K.state.hemi,He.sunShadowMatrix.value=K.state.sunShadowMatrix,He.sunShadowCascade.value=K.state.sunShadowCascade,He.directionalShadowMatrix.value=K.state.directionalShadowMatrix,He.spotLightMatrix.value=K.state.spotLightMatrix,He.spotLightMap.value=K.state.spotLightMap,He.pointShadowMatrix.value=K.state.pointShadowMatrix),$.numLightProbeGrids=fn(S.state.lightProbeGridArray),$.currentProgram=mt,$.uniformsList=null,mt}function ui(R,H,J,$,K){let Te=Ve.get(R),Le=Te.currentProgram.id+","+$+","+K,Ae=Te.programVariants.get(Le);return Ae===void 0?(Ae=ji(R,H,J),Te.programVariants.set(Le,Ae)):(Te.currentProgram=Ae,Te.uniformsList=null,Te.outputColorSpace=$,Te.toneMapping=K),Ae}function ks(R){if(R.uniformsList===null){let H=R.currentProgram.getUniforms();R.uniformsList=Ko.seqWithValue(H.seq,R.uniforms)}return R.uniformsList}function ra(R,H){let J=Ve.get(R);J.outputColorSpace=H.outputColorSpace,J.batching=H.batching,J.batchingColor=H.batchingColor,J.instancing=H.instancing,J.instancingColor=H.instancingColor,J.instancingMorph=H.instancingMorph,J.skinning=H.skinning,J.morphTargets=H.morphTargets,J.morphNormals=H.morphNormals,J.morphColors=H.morphColors,J.morphTargetsCount=H.morphTargetsCount,J.numClippingPlanes=H.numClippingPlanes,J.numIntersection=H.numClipIntersection,J.vertexAlphas=H.vertexAlphas,J.vertexTangents=H.vertexTangents,J.toneMapping=H.toneMapping}function oa(R,H,J,$,K){H.isScene!==!0&&(H=wn),$e.resetTextureUnits();let Te=H.fog,Le=$.isMeshStandardMaterial||$.isMeshLambertMaterial||$.isMeshPhongMaterial?H.environment:null,Ae=ce===null?P.outputColorSpace:ce.isXRRenderTarget===!0?ce.texture.colorSpace:Mt.workingColorSpace,Ne=$.isMeshStandardMaterial||$.isMeshLambertMaterial&&!$.envMap||$.isMeshPhongMaterial&&!$.envMap,Ge=I.get($.envMap||Le,Ne),it=$.vertexColors===!0&&!!J.attributes.color&&J.attributes.color.itemSize===4,mt=!!J.attributes.tangent&&(!!$.normalMap||$.anisotropy>0),He=!!J.morphAttributes.position,gt=!!J.morphAttributes.normal,sn=!!J.morphAttributes.color,Dt=hs;$.toneMapped&&(ce===null||ce.isXRRenderTarget===!0)&&(Dt=P.toneMapping);let Nt=J.morphAttributes.position||J.morphAttributes.normal||J.morphAttributes.color,En=Nt!==void 0?Nt.length:0,ke=Ve.get($),gn=S.state.lights;if(Gt===!0&&(pn===!0||R!==Q)){let Ut=R===Q&&$.id===Y;se.setState($,R,Ut)}let vt=!1,xs=!1;$.version===ke.__version?ke.needsLights&&ke.lightsStateVersion!==gn.state.version||K.isBatchedMesh&&ke.batching===!1||!K.isBatchedMesh&&ke.batching===!0||K.isBatchedMesh&&ke.batchingColor===!0&&K._colorsTexture===null||K.isBatchedMesh&&ke.batchingColor===!1&&K._colorsTexture!==null||K.isInstancedMesh&&ke.instancing===!1||!K.isInstancedMesh&&ke.instancing===!0||K.isSkinnedMesh&&ke.skinning===!1||!K.isSkinnedMesh&&ke.skinning===!0||K.isInstancedMesh&&ke.instancingColor===!0&&K.instanceColor===null||K.isInstancedMesh&&ke.instancingColor===!1&&K.instanceColor!==null||K.isInstancedMesh&&ke.instancingMorph===!0&&K.morphTexture===null||K.isInstancedMesh&&ke.instancingMorph===!1&&K.morphTexture!==null||ke.envMap!==Ge||$.fog===!0&&ke.fog!==Te||ke.numClippingPlanes!==void 0&&(ke.numClippingPlanes!==se.numPlanes||ke.numIntersection!==se.numIntersection)||ke.vertexAlphas!==it||ke.vertexTangents!==mt||ke.morphTargets!==He||ke.morphNormals!==gt||ke.morphColors!==sn||ke.morphTargetsCount!==En||ke.numLightProbeGrids!==fn(S.state.lightProbeGridArray)?vt=!0:(ke.outputColorSpace!==Ae||ke.toneMapping!==Dt)&&(xs=!0):(vt=!0,ke.__version=$.version);let xn=ke.currentProgram;(vt===!0||xs===!0)&&(xn=xs===!0?ui($,H,K,Ae,Dt):ji($,H,K),z&&$.isNodeMaterial&&z.onUpdateProgram($,xn,ke));let Zr=!1,Ji=!1,_s=!1,dt=xn.getUniforms(),an=ke.uniforms;if(we.useProgram(xn.program)&&(Zr=!0,Ji=!0,_s=!0),$.id!==Y&&(Y=$.id,Ji=!0),Zr||Q!==R){we.buffers.depth.getReversed()&&R.reversedDepth!==!0&&(R._reversedDepth=!0,R.updateProjectionMatrix()),dt.setValue(B,"projectionMatrix",R.projectionMatrix),dt.setValue(B,"viewMatrix",R.matrixWorldInverse);let _n=dt.map.cameraPosition;_n!==void 0&&_n.setValue(B,Ln.setFromMatrixPosition(R.matrixWorld)),lt.logarithmicDepthBuffer&&dt.setValue(B,"logDepthBufFC",2/(Math.log(R.far+1)/Math.LN2)),($.isMeshPhongMaterial||$.isMeshToonMaterial||$.isMeshLambertMaterial||$.isMeshBasicMaterial||$.isMeshStandardMaterial||$.isShaderMaterial)&&dt.setValue(B,"isOrthographic",R.isOrthographicCamera===!0),Q!==R&&(Q=R,Ji=!0,_s=!0)}if(ke.needsLights&&(gn.state.sunShadowMap.length>0&&dt.setValue(B,"sunShadowMap",gn.state.sunShadowMap,$e),gn.state.directionalShadowMap.length>0&&dt.setValue(B,"directionalShadowMap",gn.state.directionalShadowMap,$e),gn.state.spotShadowMap.length>0&&dt.setValue(B,"spotShadowMap",gn.state.spotShadowMap,$e),gn.state.pointShadowMap.length>0&&dt.setValue(B,"pointShadowMap",gn.state.pointShadowMap,$e)),K.isSkinnedMesh){dt.setOptional(B,K,"bindMatrix"),dt.setOptional(B,K,"bindMatrixInverse");let Ut=K.skeleton;Ut&&(Ut.boneTexture===null&&Ut.computeBoneTexture(),dt.setValue(B,"boneTexture",Ut.boneTexture,$e))}K.isBatchedMesh&&(dt.setOptional(B,K,"batchingTexture"),dt.setValue(B,"batchingTexture",K._matricesTexture,$e),dt.setOptional(B,K,"batchingIdTexture"),dt.setValue(B,"batchingIdTexture",K._indirectTexture,$e),dt.setOptional(B,K,"batchingColorTexture"),K._colorsTexture!==null&&dt.setValue(B,"batchingColorTexture",K._colorsTexture,$e));let Kn=J.morphAttributes;if((Kn.position!==void 0||Kn.normal!==void 0||Kn.color!==void 0)&&oe.update(K,J,xn),(Ji||ke.receiveShadow!==K.receiveShadow)&&(ke.receiveShadow=K.receiveShadow,dt.setValue(B,"receiveShadow",K.receiveShadow)),($.isMeshStandardMaterial||$.isMeshLambertMaterial||$.isMeshPhongMaterial)&&$.envMap===null&&H.environment!==null&&(an.envMapIntensity.value=H.environmentIntensity),an.dfgLUT!==void 0&&(an.dfgLUT.value=P1()),Ji){if(dt.setValue(B,"toneMappingExposure",P.toneMappingExposure),ke.needsLights&&qr(an,_s),Te&&$.fog===!0&&_e.refreshFogUniforms(an,Te),_e.refreshMaterialUniforms(an,$,Se,Re,S.state.transmissionRenderTarget[R.id]),ke.needsLights&&ke.numLightProbeGrids>0){let Ut=M,_n=0;for(let Wn of S.state.lightProbeGridArray)Wn.texture!==null&&(Ut.textures[_n]=Wn.texture,Ut.min[_n]=Wn.boundingBox.min,Ut.max[_n]=Wn.boundingBox.max,Ut.resolution[_n]=Wn.resolution,_n++);for(let Wn in Ut)Ut[Wn].length=_n;an.probesSH.value=Ut.textures,an.probesMin.value=Ut.min,an.probesMax.value=Ut.max,an.probesResolution.value=Ut.resolution}Ko.upload(B,ks(ke),an,$e)}if($.isShaderMaterial&&$.uniformsNeedUpdate===!0&&(Ko.upload(B,ks(ke),an,$e),$.uniformsNeedUpdate=!1),$.isSpriteMaterial&&dt.setValue(B,"center",K.center),dt.setValue(B,"modelViewMatrix",K.modelViewMatrix),dt.setValue(B,"normalMatrix",K.normalMatrix),dt.setValue(B,"modelMatrix",K.matrixWorld),$.uniformsGroups!==void 0){let Ut=$.uniformsGroups;for(let _n=0,Wn=Ut.length;_n<Wn;_n++){let Nl=Ut[_n];qe.update(Nl,xn),qe.bind(Nl,xn)}}return xn}function qr(R,H){R.ambientLightColor.needsUpdate=H,R.lightProbe.needsUpdate=H,R.sunLights.needsUpdate=H,R.sunLightShadows.needsUpdate=H,R.directionalLights.needsUpdate=H,R.directionalLightShadows.needsUpdate=H,R.pointLights.needsUpdate=H,R.pointLightShadows.needsUpdate=H,R.spotLights.needsUpdate=H,R.spotLightShadows.needsUpdate=H,R.rectAreaLights.needsUpdate=H,R.hemisphereLights.needsUpdate=H}function Bs(R){return R.isMeshLambertMaterial||R.isMeshToonMaterial||R.isMeshPhongMaterial||R.isMeshStandardMaterial||R.isShadowMaterial||R.isShaderMaterial&&R.lights===!0}this.getActiveCubeFace=function(){return Z},this.getActiveMipmapLevel=function(){return G},this.getRenderTarget=function(){return ce},this.setRenderTargetTextures=function(R,H,J){let $=Ve.get(R);$.__autoAllocateDepthBuffer=R.resolveDepthBuffer===!1,$.__autoAllocateDepthBuffer===!1&&($.__useRenderToTexture=!1),Ve.get(R.texture).__webglTexture=H,Ve.get(R.depthTexture).__webglTexture=$.__autoAllocateDepthBuffer?void 0:J,$.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(R,H){let J=Ve.get(R);J.__webglFramebuffer=H,J.__useDefaultFramebuffer=H===void 0},this.setRenderTarget=function(R,H=0,J=0){ce=R,Z=H,G=J;let $=null,K=!1,Te=!1;if(R){let Ae=Ve.get(R);if(Ae.__useDefaultFramebuffer!==void 0){we.bindFramebuffer(B.FRAMEBUFFER,Ae.__webglFramebuffer),ie.copy(R.viewport),de.copy(R.scissor),fe=R.scissorTest,we.viewport(ie),we.scissor(de),we.setScissorTest(fe),Y=-1;return}else if(Ae.__webglFramebuffer===void 0)$e.setupRenderTarget(R);else if(Ae.__hasExternalTextures)$e.rebindTextures(R,Ve.get(R.texture).__webglTexture,Ve.get(R.depthTexture).__webglTexture);else if(R.depthBuffer){let it=R.depthTexture;if(Ae.__boundDepthTexture!==it){if(it!==null&&Ve.has(it)&&(R.width!==it.image.width||R.height!==it.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");$e.setupDepthRenderbuffer(R)}}let Ne=R.texture;(Ne.isData3DTexture||Ne.isDataArrayTexture||Ne.isCompressedArrayTexture)&&(Te=!0);let Ge=Ve.get(R).__webglFramebuffer;R.isWebGLCubeRenderTarget?(Array.isArray(Ge[H])?$=Ge[H][J]:$=Ge[H],K=!0):R.samples>0&&$e.useMultisampledRTT(R)===!1?$=Ve.get(R).__webglMultisampledFramebuffer:Array.isArray(Ge)?$=Ge[J]:$=Ge,ie.copy(R.viewport),de.copy(R.scissor),fe=R.scissorTest}else ie.copy(Xe).multiplyScalar(Se).floor(),de.copy(pt).multiplyScalar(Se).floor(),fe=ut;if(J!==0&&($=W),we.bindFramebuffer(B.FRAMEBUFFER,$)&&we.drawBuffers(R,$),we.viewport(ie),we.scissor(de),we.setScissorTest(fe),K){let Ae=Ve.get(R.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_CUBE_MAP_POSITIVE_X+H,Ae.__webglTexture,J)}else if(Te){let Ae=H;for(let Ne=0;Ne<R.textures.length;Ne++){let Ge=Ve.get(R.textures[Ne]);B.framebufferTextureLayer(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0+Ne,Ge.__webglTexture,J,Ae)}}else if(R!==null&&J!==0){let Ae=Ve.get(R.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,Ae.__webglTexture,J)}Y=-1};function Yr(R){let H=Ve.get(R);return(H.__readFormat!==R.format||H.__readType!==R.type)&&(H.__readFormat=R.format,H.__readType=R.type,H.__formatReadable=lt.textureFormatReadable(R.format),H.__typeReadable=lt.textureTypeReadable(R.type)),H}this.readRenderTargetPixels=function(R,H,J,$,K,Te,Le,Ae=0){if(!(R&&R.isWebGLRenderTarget)){et("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ne=Ve.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&Le!==void 0&&(Ne=Ne[Le],Array.isArray(Ne)&&(Ne=Ne[0])),Ne){we.bindFramebuffer(B.FRAMEBUFFER,Ne);try{let Ge=R.textures[Ae],it=Ge.format,mt=Ge.type;R.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+Ae);let He=Yr(Ge);if(He.__formatReadable===!1){et("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(He.__typeReadable===!1){et("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}H>=0&&H<=R.width-$&&J>=0&&J<=R.height-K&&B.readPixels(H,J,$,K,xe.convert(it),xe.convert(mt),Te)}finally{let Ge=ce!==null?Ve.get(ce).__webglFramebuffer:null;we.bindFramebuffer(B.FRAMEBUFFER,Ge)}}},this.readRenderTargetPixelsAsync=async function(R,H,J,$,K,Te,Le,Ae=0){if(!(R&&R.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ne=Ve.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&Le!==void 0&&(Ne=Ne[Le],Array.isArray(Ne)&&(Ne=Ne[0])),Ne)if(H>=0&&H<=R.width-$&&J>=0&&J<=R.height-K){we.bindFramebuffer(B.FRAMEBUFFER,Ne);let Ge=R.textures[Ae],it=Ge.format,mt=Ge.type;R.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+Ae);let He=Yr(Ge);if(He.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(He.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let gt=B.createBuffer();B.bindBuffer(B.PIXEL_PACK_BUFFER,gt),B.bufferData(B.PIXEL_PACK_BUFFER,Te.byteLength,B.STREAM_READ),B.readPixels(H,J,$,K,xe.convert(it),xe.convert(mt),0),B.bindBuffer(B.PIXEL_PACK_BUFFER,null);let sn=ce!==null?Ve.get(ce).__webglFramebuffer:null;we.bindFramebuffer(B.FRAMEBUFFER,sn);let Dt=B.fenceSync(B.SYNC_GPU_COMMANDS_COMPLETE,0);return B.flush(),await N0(B,Dt,4),B.bindBuffer(B.PIXEL_PACK_BUFFER,gt),B.getBufferSubData(B.PIXEL_PACK_BUFFER,0,Te),B.bindBuffer(B.PIXEL_PACK_BUFFER,null),B.deleteBuffer(gt),B.deleteSync(Dt),Te}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(R,H=null,J=0){let $=Math.pow(2,-J),K=Math.floor(R.image.width*$),Te=Math.floor(R.image.height*$),Le=H!==null?H.x:0,Ae=H!==null?H.y:0;$e.setTexture2D(R,0),B.copyTexSubImage2D(B.TEXTURE_2D,J,0,0,Le,Ae,K,Te),we.unbindTexture()},this.copyTextureToTexture=function(R,H,J=null,$=null,K=0,Te=0){let Le,Ae,Ne,Ge,it,mt,He,gt,sn,Dt=R.isCompressedTexture?R.mipmaps[Te]:R.image;if(J!==null)Le=J.max.x-J.min.x,Ae=J.max.y-J.min.y,Ne=J.isBox3?J.max.z-J.min.z:1,Ge=J.min.x,it=J.min.y,mt=J.isBox3?J.min.z:0;else{let dt=Math.pow(2,-K);Le=Math.floor(Dt.width*dt),Ae=Math.floor(Dt.height*dt),R.isDataArrayTexture?Ne=Dt.depth:R.isData3DTexture?Ne=Math.floor(Dt.depth*dt):Ne=1,Ge=0,it=0,mt=0}$!==null?(He=$.x,gt=$.y,sn=$.z):(He=0,gt=0,sn=0);let Nt=xe.convert(H.format),En=xe.convert(H.type),ke;H.isData3DTexture?($e.setTexture3D(H,0),ke=B.TEXTURE_3D):H.isDataArrayTexture||H.isCompressedArrayTexture?($e.setTexture2DArray(H,0),ke=B.TEXTURE_2D_ARRAY):($e.setTexture2D(H,0),ke=B.TEXTURE_2D),we.activeTexture(B.TEXTURE0),we.pixelStorei(B.UNPACK_FLIP_Y_WEBGL,H.flipY),we.pixelStorei(B.UNPACK_PREMULTIPLY_ALPHA_WEBGL,H.premultiplyAlpha),we.pixelStorei(B.UNPACK_ALIGNMENT,H.unpackAlignment);let gn=we.getParameter(B.UNPACK_ROW_LENGTH),vt=we.getParameter(B.UNPACK_IMAGE_HEIGHT),xs=we.getParameter(B.UNPACK_SKIP_PIXELS),xn=we.getParameter(B.UNPACK_SKIP_ROWS),Zr=we.getParameter(B.UNPACK_SKIP_IMAGES);we.pixelStorei(B.UNPACK_ROW_LENGTH,Dt.width),we.pixelStorei(B.UNPACK_IMAGE_HEIGHT,Dt.height),we.pixelStorei(B.UNPACK_SKIP_PIXELS,Ge),we.pixelStorei(B.UNPACK_SKIP_ROWS,it),we.pixelStorei(B.UNPACK_SKIP_IMAGES,mt);let Ji=R.isDataArrayTexture||R.isData3DTexture,_s=H.isDataArrayTexture||H.isData3DTexture;if(R.isDepthTexture){let dt=Ve.get(R),an=Ve.get(H),Kn=Ve.get(dt.__renderTarget),Ut=Ve.get(an.__renderTarget);we.bindFramebuffer(B.READ_FRAMEBUFFER,Kn.__webglFramebuffer),we.bindFramebuffer(B.DRAW_FRAMEBUFFER,Ut.__webglFramebuffer);for(let _n=0;_n<Ne;_n++)Ji&&(B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,Ve.get(R).__webglTexture,K,mt+_n),B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,Ve.get(H).__webglTexture,Te,sn+_n)),B.blitFramebuffer(Ge,it,Ge+Le,it+Ae,He,gt,He+Le,gt+Ae,B.DEPTH_BUFFER_BIT,B.NEAREST);we.bindFramebuffer(B.READ_FRAMEBUFFER,null),we.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else if(K!==0||R.isRenderTargetTexture||Ve.has(R)){let dt=Ve.get(R),an=Ve.get(H);we.bindFramebuffer(B.READ_FRAMEBUFFER,N),we.bindFramebuffer(B.DRAW_FRAMEBUFFER,V);for(let Kn=0;Kn<Ne;Kn++)Ji?B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,dt.__webglTexture,K,mt+Kn):B.framebufferTexture2D(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,dt.__webglTexture,K),_s?B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,an.__webglTexture,Te,sn+Kn):B.framebufferTexture2D(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,an.__webglTexture,Te),K!==0?B.blitFramebuffer(Ge,it,Ge+Le,it+Ae,He,gt,He+Le,gt+Ae,B.COLOR_BUFFER_BIT,B.NEAREST):_s?B.copyTexSubImage3D(ke,Te,He,gt,sn+Kn,Ge,it,Le,Ae):B.copyTexSubImage2D(ke,Te,He,gt,Ge,it,Le,Ae);we.bindFramebuffer(B.READ_FRAMEBUFFER,null),we.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else _s?R.isDataTexture||R.isData3DTexture?B.texSubImage3D(ke,Te,He,gt,sn,Le,Ae,Ne,Nt,En,Dt.data):H.isCompressedArrayTexture?B.compressedTexSubImage3D(ke,Te,He,gt,sn,Le,Ae,Ne,Nt,Dt.data):B.texSubImage3D(ke,Te,He,gt,sn,Le,Ae,Ne,Nt,En,Dt):R.isDataTexture?B.texSubImage2D(B.TEXTURE_2D,Te,He,gt,Le,Ae,Nt,En,Dt.data):R.isCompressedTexture?B.compressedTexSubImage2D(B.TEXTURE_2D,Te,He,gt,Dt.width,Dt.height,Nt,Dt.data):B.texSubImage2D(B.TEXTURE_2D,Te,He,gt,Le,Ae,Nt,En,Dt);we.pixelStorei(B.UNPACK_ROW_LENGTH,gn),we.pixelStorei(B.UNPACK_IMAGE_HEIGHT,vt),we.pixelStorei(B.UNPACK_SKIP_PIXELS,xs),we.pixelStorei(B.UNPACK_SKIP_ROWS,xn),we.pixelStorei(B.UNPACK_SKIP_IMAGES,Zr),Te===0&&H.generateMipmaps===!0&&H.mipmapsAutoUpdate===!0&&B.generateMipmap(ke),we.unbindTexture()},this.initRenderTarget=function(R){Ve.get(R).__webglFramebuffer===void 0&&$e.setupRenderTarget(R)},this.initTexture=function(R){R.isCubeTexture?$e.setTextureCube(R,0):R.isData3DTexture?$e.setTexture3D(R,0):R.isDataArrayTexture||R.isCompressedArrayTexture?$e.setTexture2DArray(R,0):$e.setTexture2D(R,0),we.unbindTexture()},this.resetState=function(){Z=0,G=0,ce=null,we.reset(),Me.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Ai}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=Mt._getDrawingBufferColorSpace(e),t.unpackColorSpace=Mt._getUnpackColorSpace()}};function vx(i,e=!1){let t=i[0].index!==null,n=new Set(Object.keys(i[0].attributes)),s=new Set(Object.keys(i[0].morphAttributes)),r={},o={},a=i[0].morphTargetsRelative,l=new Lt;l.morphTargetsRelative=a;let c=0;for(let h=0;h<i.length;++h){let d=i[h],u=0,f=0;if(t!==(d.index!==null))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". All geometries must have compatible attributes; make sure index attribute exists among all geometries, or in none of them."),null;for(let p in d.attributes){if(!n.has(p))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+'. All geometries must have compatible attributes; make sure "'+p+'" attribute exists among all geometries, or in none of them.'),null;r[p]===void 0&&(r[p]=[]),r[p].push(d.attributes[p]),u++}if(u!==n.size)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". Make sure all geometries have the same number of attributes."),null;if(a!==d.morphTargetsRelative)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". .morphTargetsRelative must be consistent throughout all geometries."),null;for(let p in d.morphAttributes){if(!s.has(p))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+".  .morphAttributes must be consistent throughout all geometries."),null;if(d.morphAttributes[p].length!==i[0].morphAttributes[p].length)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+'. All geometries must have the same number of morph targets for the "'+p+'" morph attribute.'),null;o[p]===void 0&&(o[p]=[]),o[p].push(d.morphAttributes[p]),f++}if(f!==s.size)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". Make sure all geometries have the same number of morph attributes."),null;if(e){let p;if(t)p=d.index.count;else if(d.attributes.position!==void 0)p=d.attributes.position.count;else return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". The geometry must have either an index or a position attribute"),null;l.addGroup(c,p,h),c+=p}}if(t){let h=0,d=[];for(let u=0;u<i.length;++u){let f=i[u].index;for(let p=0;p<f.count;++p)d.push(f.getX(p)+h);h+=i[u].attributes.position.count}l.setIndex(d)}for(let h in r){let d=yx(r[h]);if(!d)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+h+" attribute."),null;l.setAttribute(h,d)}for(let h in o){let d=o[h][0].length;if(d!==0){l.morphAttributes=l.morphAttributes||{},l.morphAttributes[h]=[];for(let u=0;u<d;++u){let f=[];for(let v=0;v<o[h].length;++v)f.push(o[h][v][u]);let p=yx(f);if(!p)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+h+" morphAttribute."),null;l.morphAttributes[h].push(p)}}}return l}function yx(i){let e,t,n,s=-1,r=0;for(let c=0;c<i.length;++c){let h=i[c];if(e===void 0&&(e=h.array.constructor),e!==h.array.constructor)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.array must be of consistent array types across matching attributes."),null;if(t===void 0&&(t=h.itemSize),t!==h.itemSize)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.itemSize must be consistent across matching attributes."),null;if(n===void 0&&(n=h.normalized),n!==h.normalized)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.normalized must be consistent across matching attributes."),null;if(s===-1&&(s=h.gpuType),s!==h.gpuType)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.gpuType must be consistent across matching attributes."),null;r+=h.count*t}let o=new e(r),a=new jt(o,t,n),l=0;for(let c=0;c<i.length;++c){let h=i[c];if(h.isInterleavedBufferAttribute){let d=l/t;for(let u=0,f=h.count;u<f;u++)for(let p=0;p<t;p++){let v=h.getComponent(u,p);a.setComponent(u+d,p,v)}}else o.set(h.array,l);l+=h.count*t}return s!==void 0&&(a.gpuType=s),a}var Mx=i=>{let e=atob(i),t=new Uint8Array(e.length);for(let n=0;n<t.length;n++)t[n]=e.charCodeAt(n);return t.buffer},bx=i=>new Float32Array(Mx(i)),Zf={sag:6e-4,least:10,most:40,faces:4e4,plain:!1},Sx={sag:.004,least:6,most:12,faces:1e3,plain:!0},$f=(i,e,t,n)=>{let s=[1/0,1/0,1/0],r=[-1/0,-1/0,-1/0];i.forEach((C,S)=>{s[S%3]=Math.min(s[S%3],C),r[S%3]=Math.max(r[S%3],C)});let o=r.map((C,S)=>Math.max(C-s[S],1e-6)),[a,l,c]=o,h=Math.sqrt(2*(a*l+l*c+c*a)*2/t),d=new Map,u=[],f=[],p=[],v=new Map,g=C=>{if(!n)return 0;let S=(Math.round(1e3*n[C])*1024+Math.round(1e3*n[C+1]))*1024+Math.round(1e3*n[C+2]),x=v.get(S);return x===void 0&&v.set(S,x=v.size),x},m=o.map(C=>Math.floor(C/h)+1),_=new Uint32Array(i.length/3);for(let C=0,S=0;S<i.length;C++,S+=3){let x=Math.floor((i[S]-s[0])/h),E=Math.floor((i[S+1]-s[1])/h),O=Math.floor((i[S+2]-s[2])/h),P=((g(S)*m[2]+O)*m[1]+E)*m[0]+x,D=d.get(P);D===void 0&&(D=d.size,d.set(P,D),u.push(0,0,0),f.push(0),n&&p.push(n[S],n[S+1],n[S+2]));for(let z=0;z<3;z++)u[3*D+z]+=i[S+z];f[D]+=1,_[C]=D}let T=[];for(let C=0;C<e.length;C+=3){let[S,x,E]=[_[e[C]],_[e[C+1]],_[e[C+2]]];S!==x&&x!==E&&E!==S&&T.push(S,x,E)}let M=new Lt;return M.setAttribute("position",new jt(Float32Array.from(u,(C,S)=>C/f[Math.floor(S/3)]),3)),n&&M.setAttribute("color",new jt(Float32Array.from(p),3)),M.setIndex(T),M.computeVertexNormals(),M},nu=class{constructor(e,t,n,s=Zf){this.drawn=e;this.fineness=s;this.pictures=e.pictures.map(r=>{let o=new Hn(new Image);Object.assign(o,{wrapS:Rr,wrapT:Rr,colorSpace:Mn,anisotropy:t});let a=o.image;return a.onload=()=>{o.needsUpdate=!0,n()},a.src=r,o})}drawn;fineness;known=new Map;looks=new Map;pictures;joined=new Map;parts(e){let t=new Map;for(let r of e){let o=r.colour[3]<1||r.picture!==void 0||r.kind==="hfield"||r.kind==="plane",a=`${r.body}|${o?r.name:Math.round(2*r.gloss)}`;t.set(a,[...t.get(a)??[],r])}let n=[...t.values()].map(r=>r.map(o=>o.name).join()).join("|"),s=this.joined.get(n);return s||this.joined.set(n,s=[...t.values()].map(r=>this.part(r))),s}part(e){let t=e[0],n=t.kind!=="plane"&&t.colour[3]===1;if(t.colour[3]<1||t.picture!==void 0||t.kind==="hfield"||t.kind==="plane"){let c=this.look(t),h=this.moved(t,!0),d=c.map,u=t.kind==="plane"&&t.colour[3]===1?new ri({map:d&&this.cheaper(d)}):void 0;return u&&(u.userData.own=c.color),{body:t.body,geometry:h,material:c,casts:n,joined:!1,plain:u}}let r=vx(e.map(c=>this.moved(c,!1))),o=Math.max(.3,1-.75*(e.reduce((c,h)=>c+h.gloss,0)/e.length)),a=`joined|${o.toFixed(1)}`,l=this.looks.get(a);return l||this.looks.set(a,l=this.painted({vertexColors:!0},o)),{body:t.body,geometry:r,material:l,casts:n,joined:!0}}cheaper(e){let t=e.image,n=e.clone();return n.minFilter=Zo,t.complete?n.needsUpdate=!0:t.addEventListener("load",()=>{n.needsUpdate=!0}),this.pictures.push(n),n}moved(e,t){let n=this.shape(e).clone(),s=new ht().fromArray(e.rotation);if(n.applyMatrix4(new yt().compose(new U().fromArray(e.position),s,new U(1,1,1))),t)return n;n.deleteAttribute("uv");let r=new Je().setRGB(e.colour[0],e.colour[1],e.colour[2],Mn),o=new Float32Array(3*n.attributes.position.count);for(let a=0;a<o.length;a+=3)r.toArray(o,a);return n.setAttribute("color",new jt(o,3)),n}dispose(){let e=[...this.joined.values()].flat().flatMap(({geometry:t,plain:n})=>n?[t,n]:[t]);for(let t of[...this.known.values(),...this.looks.values(),...this.pictures,...e])t.dispose()}shape(e){let t=[e.kind,e.size,e.mesh??"",e.repeat??""].join("|"),n=this.known.get(t);return n||this.known.set(t,n=this.made(e)),n}painted(e,t){return this.fineness.plain?new Pr(e):new ja({...e,roughness:t})}look(e){let t=JSON.stringify([e.colour,e.gloss,e.picture]),n=this.looks.get(t);if(!n){let[s,r,o,a]=e.colour;n=this.painted({color:new Je().setRGB(s,r,o,Mn),transparent:a<1,opacity:a,map:e.picture===void 0?null:this.pictures[e.picture],side:e.kind==="hfield"?li:cs},Math.max(.3,1-.75*e.gloss)),this.looks.set(t,n)}return n}made({kind:e,size:t,mesh:n,repeat:s}){let[r,o,a]=t,l=h=>{let{sag:d,least:u,most:f}=this.fineness;return Math.min(f,Math.max(u,2*Math.ceil(Math.PI/Math.sqrt(2*d/h)/2)))},c=Math.PI/2;switch(e){case"plane":{let h=new Ls(2*r,2*o);if(s){let d=h.attributes.position,u=h.attributes.uv;for(let f=0;f<4;f++)u.setXY(f,d.getX(f)*s[0],d.getY(f)*s[1])}return h}case"box":return new Vt(2*r,2*o,2*a);case"sphere":return new Ii(r,l(r),l(r)/2).rotateX(c);case"ellipsoid":{let h=l(Math.max(r,o,a));return new Ii(1,h,h/2).rotateX(c).scale(r,o,a)}case"capsule":return new $a(r,2*o,Math.max(2,Math.floor(l(r)/5)),l(r)).rotateX(c);case"cylinder":return new Sn(r,r,2*o,l(r)).rotateX(c);default:{let h=this.drawn.meshes[n??0],d=new Lt,u=bx(h.points),f=new Uint32Array(Mx(h.faces));return e==="mesh"&&f.length>3*this.fineness.faces?$f(u,f,this.fineness.faces):(d.setAttribute("position",new jt(u,3)),d.setAttribute("normal",new jt(bx(h.normals),3)),d.setIndex(new jt(f,1)),d)}}}};var gl=class{mesh;spans=[];points;normals;constructor(e,t,n=1/0){let s=e.map(u=>({body:u.body,geometry:I1(u.geometry,n)})),r=s.reduce((u,f)=>u+f.geometry.attributes.position.count,0);this.points=new Float32Array(3*r),this.normals=new Float32Array(3*r);let o=new Float32Array(3*r),a=[],l=0;for(let{body:u,geometry:f}of s){let{position:p,normal:v,color:g}=f.attributes,m=l+p.count;this.points.set(p.array,3*l),this.normals.set(v.array,3*l),g&&o.set(g.array,3*l);let _=f.index?Array.from(f.index.array):Array.from({length:p.count},(T,M)=>M);for(let T of _)a.push(l+T);this.spans.push({body:u,begin:l,end:m}),l=m}let c=new Lt;for(let u of["position","normal"])c.setAttribute(u,new jt(new Float32Array(3*r),3).setUsage(Rf));c.setAttribute("color",new jt(o,3)),c.setIndex(a);let h=t.length===1,d=t.map((u,f)=>Object.assign(new De(c,u),{castShadow:h,receiveShadow:h,frustumCulled:!1,matrixAutoUpdate:!1,renderOrder:h?0:1+f,raycast:()=>{}}));this.mesh=d[0];for(let u of d.slice(1))this.mesh.add(u)}put(e){let{position:t,normal:n}=this.mesh.geometry.attributes,s=new yt,r=new ht;for(let{body:o,begin:a,end:l}of this.spans){s.makeRotationFromQuaternion(r.fromArray(e.rotation,4*o));let[c,h,d,,u,f,p,,v,g,m]=s.elements,_=e.position[3*o],T=e.position[3*o+1],M=e.position[3*o+2];wx(this.points,t.array,a,l,c,h,d,u,f,p,v,g,m,_,T,M),wx(this.normals,n.array,a,l,c,h,d,u,f,p,v,g,m,0,0,0)}t.needsUpdate=n.needsUpdate=!0}dispose(){this.mesh.geometry.dispose()}},I1=(i,e)=>{let{position:t,color:n}=i.attributes,s=i.index?.array??Uint32Array.from({length:t.count},(r,o)=>o);return s.length<=3*e?i:i.userData[e]??=$f(t.array,Uint32Array.from(s),e,n?.array)},wx=(i,e,t,n,s,r,o,a,l,c,h,d,u,f,p,v)=>{for(let g=3*t;g<3*n;g+=3){let m=i[g],_=i[g+1],T=i[g+2];e[g]=s*m+a*_+h*T+f,e[g+1]=r*m+l*_+d*T+p,e[g+2]=o*m+c*_+u*T+v}};var Kf=1,Ex=new ht,iu=(i,e,t=.05)=>{let n=[new ri({colorWrite:!1,transparent:!0}),new Pr({color:i,transparent:!0,opacity:e,depthWrite:!1})];for(let s of n)s.onBeforeCompile=r=>{r.vertexShader=r.vertexShader.replace("#include <project_vertex>",`#include <project_vertex>
      vec4 behind = projectionMatrix * vec4(mvPosition.xyz + ${t.toFixed(3)} * normalize(mvPosition.xyz), 1.0);
      gl_Position.z = behind.z / behind.w * gl_Position.w;`)};return n},lr=class{root=new Yn;groups;planes=[];merged=null;rough=null;constructor(e,t,n,s,r=0){this.groups=e.map((l,c)=>Object.assign(new Yn,{name:l,userData:{body:c}}));let o=n.parts(t),a=r?o.filter(l=>l.joined):[];if(a.length){this.merged=s?null:new gl(a,[a[0].material]),this.rough=new gl(a,s??[a[0].material],r);for(let l of[this.merged,this.rough])l&&this.root.add(l.mesh);this.isRough=s!==void 0}for(let l of s?o.filter(c=>!a.includes(c)):o)(s??[l.material]).forEach((c,h)=>{let d=new De(l.geometry,c);s&&(d.renderOrder=1+h),d.castShadow=!s&&l.casts,d.receiveShadow=!s,a.includes(l)&&d.layers.set(Kf),l.plain&&this.planes.push({mesh:d,part:l}),this.groups[l.body].add(d)});this.root.add(...this.groups)}dispose(){this.root.removeFromParent(),this.merged?.dispose(),this.rough?.dispose()}set isRough(e){this.merged&&(this.merged.mesh.visible=!e),this.rough&&(this.rough.mesh.visible=e)}put(e){this.groups.forEach((t,n)=>{t.position.fromArray(e.position,3*n),t.quaternion.fromArray(e.rotation,4*n)});for(let t of[this.merged,this.rough])t?.mesh.visible&&t.put(e)}},Br=({position:i,rotation:e},{body:t,offset:n},s=0)=>new U().fromArray(n).applyQuaternion(Ex.fromArray(e,4*(s+t))).add(new U().fromArray(i,3*(s+t))),Tx=(i,e,t,n)=>{let s=new ht;for(let r=0;r<n.position.length;r++)n.position[r]=i.position[r]+t*(e.position[r]-i.position[r]);for(let r=0;r<n.rotation.length;r+=4)Ex.fromArray(i.rotation,r).slerp(s.fromArray(e.rotation,r),t).toArray(n.rotation,r)};var su=class{constructor(e,t,n,s,r,o,a,l){this.first=e;this.last=t;this.rate=n;this.count=s;this.bodies=r;this.position=o;this.rotation=a;this.centre=l;this.out={position:new Float32Array(3*r),rotation:new Float32Array(4*r)}}first;last;rate;count;bodies;position;rotation;centre;out;timeOf(e){return e>=this.count-1?this.last:this.first+e/this.rate}found(e){let t=Math.min(Math.max(e,this.first),this.last),n=Math.min(Math.floor((t-this.first)*this.rate+1e-9),this.count-2);if(n<0)return[0,0];let s=this.timeOf(n),r=this.timeOf(n+1);return[n,r>s?Math.min(1,(t-s)/(r-s)):0]}at(e){let[t,n]=this.found(e),s=3*this.bodies,r=4*this.bodies,o=Math.min(t+1,this.count-1);return Tx({position:this.position.subarray(t*s,(t+1)*s),rotation:this.rotation.subarray(t*r,(t+1)*r)},{position:this.position.subarray(o*s,(o+1)*s),rotation:this.rotation.subarray(o*r,(o+1)*r)},n,this.out),this.out}centreAt(e){let[t,n]=this.found(e),s=Math.min(t+1,this.count-1),r=this.centre;return[0,1,2].map(o=>r[3*t+o]+n*(r[3*s+o]-r[3*t+o]))}};var L1=/hand|grip|palm|wrist|finger|tool/i;var jf=class{document=null;loaded=null;stage=null;now=null;raw=null;snapshot=null;course=null;violations=[];overshoots=[];kinds=[];curves=null;poses=[];status={state:"loading",go:!0};time=0;range=[-1/0,1/0];playing=!1;speed=1;loop=!0;follow=!0;which="after";ghosts="";trails=!1;partial=!1;frames=0;keys=new Set;bar=null;joints=[];obstacle=null;resizes=!1;fk=new Set;locks=new Set;ears=new Map;on(e,t){for(let n of[e].flat())this.ears.set(n,[...this.ears.get(n)??[],t])}tell(e){for(let t of this.ears.get(e)??[])t()}get joint(){return this.joints.at(-1)??null}get locked(){return(this.stage?.bodies??[]).flatMap((e,t)=>this.locks.has(e)?[t]:[])}get first(){return this.now?.first??this.document?.keys[0]?.time??0}get last(){return this.now?.last??this.document?.keys.at(-1)?.time??1}get played(){let e=Math.max(this.first,this.range[0]),t=Math.min(this.last,this.range[1]);return e<t?[e,t]:[this.first,this.last]}setRange(e,t){let n=[-1/0,1/0];this.range[e]=this.first<t&&t<this.last?t:n[e],this.range[0]>=this.range[1]&&(this.range[1-e]=n[1-e]),this.tell("range")}get fps(){return this.document?.fps??30}get moment(){return this.here===null?Math.round(this.time*1e4)/1e4:this.document.keys[this.here].time}get here(){return this.at([this.time])[0]??null}poseOf(e){let{qpos:t,fixed:n}=this.loaded.keys[e],s=this.course?.keys??[],r=s.length===this.loaded.keys.length?s[e]:t;return t.map((o,a)=>n[a]?o:r[a]??o)}get limb(){let{stage:e}=this,t=e?.limbs.find(s=>this.joint!==null&&s.joints.includes(this.joint));if(!e||!t)return null;let n=new Set(e.joints.filter(s=>t.joints.includes(s.name)).map(s=>s.body));return{joints:t.joints,hands:e.sites.filter(s=>n.has(s.body)&&L1.test(s.name)).map(s=>s.name),bodies:n}}seek(e){this.time=Math.max(e,Math.min(0,this.first));let t=this.here===null?[]:[this.here];this.keys.size<=1&&String([...this.keys])!==String(t)&&this.bar===null&&this.select(t),this.tell("time")}visit(e,t){this.playing=!1,e!==null&&this.seek(e),this.choose(this.stage?.joints.find(({name:n})=>n===t)?.name??this.joint)}choose(e,t=!1){let n=t?this.joints.filter(s=>s!==e):[];this.joints=e===null||t&&this.joints.includes(e)?n:[...n,e],this.obstacle=null,this.tell("joint")}pick(e){this.obstacle=e&&{kind:e.kind,index:e.index},this.joints=[],this.tell("joint")}at(e){let t=n=>e.some(s=>Math.abs(n.time-s)<1e-4);return(this.document?.keys??[]).flatMap((n,s)=>t(n)?[s]:[])}select(e){this.keys=new Set(e),this.bar=null,this.tell("selection")}},b=new jf;var D1=["root","roots","joints","sites","bodies"],N1=i=>{let e=new U().fromArray(i).multiplyScalar(Math.PI/180),t=e.length(),{x:n,y:s,z:r,w:o}=new ht().setFromAxisAngle(e.normalize(),t);return[o,n,s,r]},Qf=(i,e)=>{let t={...i};for(let[n,s]of Object.entries(e))if(D1.includes(n)&&s!==null&&typeof s=="object"){if(t[n]=n==="roots"?{...t[n]}:Qf(t[n]??{},s),n==="roots")for(let[r,o]of Object.entries(s))t[n][r]={...t[n][r],...o}}else s===null?delete t[n]:t[n]=s;return t},Rx=(i,e)=>e.reduce((t,{name:n,args:s})=>{let r={...t,dirty:!0,undo:t.undo??n},o=(h,d)=>h.map((u,f)=>d(u,f)?Qf(u,s.entries):u),[a,...l]=s.at??[],c=l.at(-1);if(n==="move_keys"){let h=new Map(s.moves);r.keys=r.keys.map((d,u)=>({...d,time:h.get(u)??d.time}))}else n==="change"&&a==="keyframe"?r.keys=o(r.keys,(h,d)=>d===c):n==="change"&&a==="contact"?r.contacts=o(r.contacts,(h,d)=>d===c):n==="change"&&a==="grasp"?r.grasps=o(r.grasps,(h,d)=>d===c):n==="change"&&a==="scene"?r.obstacles=o(r.obstacles,({kind:h,index:d})=>h===l[0]&&(l.length===1||d===c)):n==="change"&&a==="solve"&&(r.solve=Qf(r.solve,s.entries));return r},i),Cx=(i,e,t)=>{let n=[...i.keys];for(let{name:s,args:r}of e){if(s!=="change"||r.at[0]!=="keyframe"||!n[r.at[1]])continue;let o=n[r.at[1]]={...n[r.at[1]],qpos:[...n[r.at[1]].qpos],fixed:[...n[r.at[1]].fixed]},a=r.entries,l=t.joints.find(c=>c.kind==="free");for(let c of t.joints){let h=a.joints?.[c.name],d=c===l?a.root:a.roots?.[c.name];if(c.kind!=="free")Jf(o,c.qpos,c.kind==="ball"?Ax(h):typeof h=="number"?[c.kind==="hinge"?h*Math.PI/180:h]:h);else if(d){let{position:u,rotation:f}=d;(Array.isArray(u)?u:[u,u,u]).forEach((p,v)=>Jf(o,c.qpos+v,typeof p=="number"?[p]:p)),Jf(o,c.qpos+3,Ax(f))}}}return{...i,keys:n}},Ax=i=>typeof i=="object"&&i?.rotvec?N1(i.rotvec):i==="free"?i:void 0,Jf=(i,e,t)=>{t==="free"?i.fixed[e]=!1:Array.isArray(t)&&t.forEach((n,s)=>{i.qpos[e+s]=n,i.fixed[e+s]=!0})};var U1=new URLSearchParams(location.search).get("token")??"",Hr=new Map,au=null,ru=0,ou=250,O1=new Set(["edit","pin","free","mirror"]),F1=sessionStorage["dynsplines-tab"]??=String(Math.random()),k1=4409,B1=new Set(["grip","drag","turn"]),Px=0,tp=0,Ix=()=>Hr.size>0,Lx=()=>Hr.has(Px),Jo=new Set,$i=null,cr={document:null,loaded:null},Dx=i=>typeof i=="number"?Number.isFinite(i):i===null||typeof i!="object"||Object.values(i).every(Dx),xl=()=>{let i=[...Jo].filter(({args:e})=>Dx(e));b.document=cr.document&&Rx(cr.document,i),b.loaded=cr.loaded&&b.stage?Cx(cr.loaded,i,b.stage):cr.loaded,b.tell("document")},Pn=(i,e={})=>(np(),Nx(i,e)),Nx=(i,e)=>new Promise(t=>{if(!au||au.readyState!==WebSocket.OPEN){t({ok:!1,words:"no connection to the studio; try again"});return}ru+=1,Hr.set(ru,t),B1.has(i)||(Px=ru,tp=performance.now());let n=O1.has(i)?{revision:b.document?.revision}:{};au.send(JSON.stringify({do:i,id:ru,...n,...e},(s,r)=>Number.isNaN(r)?"NaN":r))}),Ux=i=>(i.ok?i.words&&hn(i.words):hn(i.words??"the request failed","wrong"),i),Wt=async(i,e={})=>Ux(await Pn(i,e)),_l=async(i,e="nothing has moved: locked bodies and joint ranges stay")=>{let{ok:t,words:n}=await Wt("drop",{time:i,partial:b.partial});t&&!n&&hn(e,"note")},np=()=>{let i=$i;$i=null,i&&Ox(i)},Ox=i=>{let{name:e,args:t,stroke:n}=i;Nx("edit",{name:e,...t,stroke:n}).then(s=>{Jo.delete(i),$i?.stroke===n&&np(),xl(),i.settle(Ux(s))})},Vn=(i,e,t)=>{let n={revision:b.document?.revision,...e};if($i&&t&&$i.stroke===t&&$i.name===i&&String($i.args.at)===String(n.at))return $i.args=n,xl(),$i.done;np();let s=()=>{},r=new Promise(a=>{s=a}),o={name:i,args:n,stroke:t,done:r,settle:s};return t&&[...Jo].some(a=>a.stroke===t)&&($i=o),Jo.add(o),$i!==o&&Ox(o),xl(),r},Li=(i,e,t=b.document?.revision,n)=>Vn("change",{at:i,entries:e,revision:t},n),hr=async(i,e=b.document?.revision,t)=>{let{here:n}=b,s=i.find(([o])=>o===n)?.[1],r=Vn("move_keys",{moves:i,revision:e},t);n===null||s===void 0||!Number.isFinite(s)||(b.seek(s),(await r).ok||b.seek(b.document.keys[n].time))},yl=({kind:i,index:e})=>i==="step"?["scene",i]:["scene",i,e],z1=i=>{let e=new DataView(i).getUint32(0,!0),t=JSON.parse(new TextDecoder().decode(new Uint8Array(i,4,e))),{count:n,bodies:s}=t,r=4+e,o=l=>{let c=new Float32Array(i,r,l);return r+=4*l,c},a=new su(t.first,t.last,t.rate,n,s,o(3*n*s),o(4*n*s),o(3*n));t.kind==="raw"?b.raw=a:(b.now=a,b.course=t,b.frames+=1),b.tell("path")},ep=({is:i,words:e,loads:t})=>{Pe(i).hidden=e===null,Pe(`${i}-words`).textContent=e??"",i==="outside"&&(Pe("outside-reload").hidden=!t),b.tell(i)},H1={stage:i=>{b.stage=i.stage,b.tell("stage")},document:i=>{let e=cr.document,t=i,n=(...r)=>r.some(o=>e?.[o].length!==t[o].length);cr.document=t;let s=[...b.keys].map(r=>e?.keys[r]?.time??NaN);n("contacts","grasps")&&(b.bar=null),b.obstacle&&n("obstacles")&&(b.obstacle=null,b.tell("joint")),xl(),n("keys")&&b.select(b.at(b.keys.size>1?s:[b.time]))},loaded:i=>{cr.loaded=i,xl(),b.tell("loaded")},settled:i=>{b.violations=i.violations,b.overshoots=i.overshoots,b.tell("settled")},status:i=>{b.status=i,b.tell("status")},kinds:i=>{b.kinds=i.kinds,b.tell("kinds")},curves:i=>{b.curves=i.curves,b.tell("curves")},poses:i=>{b.poses=i.names,b.tell("poses")},task:ep,offer:ep,outside:ep,note:i=>hn(i.words,"note"),refused:i=>hn(i.words,"wrong"),gone:i=>hn(i.words,"wrong"),answer:i=>{Hr.get(i.id)?.(i),Hr.delete(i.id)}},zr="lost",vl=(i=!1)=>{let e=new WebSocket(`ws${location.protocol==="https:"?"s":""}://${location.host}/line?token=${encodeURIComponent(U1)}&tab=${F1}${i?"&take":""}`);e.binaryType="arraybuffer",au=e,e.onopen=()=>{zr="open",Pe("elsewhere").hidden=!0,ou=250,b.tell("line")},e.onmessage=({data:t})=>{if(t instanceof ArrayBuffer){z1(t);return}let n=JSON.parse(t);H1[n.is]?.(n)},e.onclose=({code:t})=>{zr=t===k1?"elsewhere":"lost";for(let n of Hr.values())n({ok:!1,words:"connection to the studio lost; check whether the change was applied"});Hr.clear(),Pe("elsewhere").hidden=zr!=="elsewhere",b.tell("line"),zr!=="elsewhere"&&(window.setTimeout(vl,ou),ou=Math.min(2*ou,4e3))}};var Fx=(i,...e)=>{let t=re("dialog",{"aria-label":i});return t.append(re("form",{method:"dialog"},re("h2",{text:i}),...e)),t.addEventListener("close",()=>t.remove()),document.body.append(t),t.showModal(),t},Fs=(i,e)=>re("label",{class:"line"},re("span",{text:i}),e),kx=(i,e,t)=>{let n=re("button",{type:"submit",class:"main",text:e}),s=r=>{r.preventDefault(),!n.disabled&&(n.disabled=!0,t().then(o=>{n.disabled=!1,o&&i().close()}))};return n.addEventListener("click",s),queueMicrotask(()=>i().addEventListener("keydown",r=>{r.key==="Enter"&&!r.target.matches("button")&&s(r)})),re("div",{class:"buttons end"},re("button",{type:"button",text:"Cancel",onclick:()=>i().close()}),n)},Bx=(i,e)=>{let t=new Promise(n=>{zx=()=>n(!0)});return Promise.race([Wt(i,e).then(({ok:n})=>n),t])},zx=()=>{};b.on("task",()=>{Pe("task").hidden||zx()});var sp=()=>(b.document?.name??"clip").replace(/[^\w.-]+/g,"_"),lu=(i,e,t,n,s)=>{let r=re("input",{type:"checkbox"}),o=Fx(i,...n,re("label",{class:"line"},r," overwrite an existing file"),kx(()=>o,e,()=>s({name:t.value,overwrite:r.checked})));t.select()},bl=(i,e="file name")=>re("input",{type:"text",value:i,"aria-label":e}),rp=async(i,e)=>(await Wt(i,{...e})).ok,ip=()=>{let i=bl(`${sp()}.toml`);lu("Save as","Save",i,[Fs("name",i)],e=>rp("save",e))},cu=(i=b.moment)=>{let e=bl("","name of the pose");lu("Save pose","Save",e,[Fs("name",e)],t=>rp("save_pose",{time:i,...t}))},G1=async()=>{let i=await Pn("figures");if(!i.ok)return;let e=re("select",{"aria-label":"figure"},...i.figures.map(n=>re("option",{value:n,text:n}))),t=Fx("New",Fs("figure",e),kx(()=>t,"Create",async()=>{let n=await rp("new",{figure:e.value});return n&&b.seek(0),n}))},V1=async()=>{let i=await Pn("formats");if(!i.ok)return;let e=i.formats,t=re("select",{"aria-label":"format"},...e.map(r=>re("option",{value:r.name,text:`${r.name} – ${r.description}`}))),n=bl(""),s=()=>{n.value=`${sp()}${e.find(r=>r.name===t.value)?.ending.split(/[ ,]/)[0]??""}`};t.addEventListener("change",s),s(),lu("Export","Export",n,[Fs("format",t),Fs("name",n)],r=>Bx("export",{to:t.value,...r}))},W1=()=>{let i=bl(`${sp()}.mp4`,"file name of the video"),e=bl("1280x720","size, pixels"),t=re("select",{"aria-label":"camera"},...["side","left","front","three_quarter","back"].map(s=>re("option",{value:s,text:s}))),n=re("select",{"aria-label":"view"},re("option",{value:"after",text:"the motion"}),re("option",{value:"",text:"before | after"}));lu("Render","Render",i,[Fs("name, .mp4 .webm .gif .png",i),Fs("size",e),Fs("camera",t),Fs("what",n)],s=>Bx("render",{size:e.value,camera:t.value,only:n.value,...s}))},Hx=()=>{let i={"outside-reload":()=>Wt("reload"),"outside-keep":()=>Wt("keep"),"outside-save-as":ip,"task-stop":()=>Wt("stop"),"offer-take":()=>Wt("take_offer",{yes:!0}),"offer-drop":()=>Wt("take_offer",{yes:!1}),"take-over":()=>vl(!0)};for(let[s,r]of Object.entries(i))Pe(s).addEventListener("click",r);let e=Pe("files");e.addEventListener("save-as",ip);let n=re("div",{class:"menu",role:"menu",hidden:!0},...[["New …",()=>{G1()}],["Save as …",ip],["Export …",()=>{V1()}],["Render …",W1]].map(([s,r])=>re("button",{type:"button",role:"menuitem",text:s,onclick:()=>{n.hidden=!0,e.setAttribute("aria-expanded","false"),r()}})));e.after(n),e.addEventListener("click",()=>{n.hidden=!n.hidden,e.setAttribute("aria-expanded",String(!n.hidden)),n.hidden||n.querySelector("button").focus()}),n.addEventListener("keydown",s=>{let r=[...n.querySelectorAll("button")],o=r.indexOf(document.activeElement);s.key==="Escape"&&(n.hidden=!0,e.focus(),s.stopPropagation()),s.key==="ArrowDown"&&r[(o+1)%r.length].focus(),s.key==="ArrowUp"&&r[(o+r.length-1)%r.length].focus()}),document.addEventListener("pointerdown",s=>{!n.contains(s.target)&&s.target!==e&&!e.contains(s.target)&&(n.hidden=!0)})};var X1=30,q1=[.1,.25,.5,1,1.5,2],Y1={loading:"loading …",searching:"optimising",settled:"converged",refused:"refused",gone:"gone"},Z1={INTERRUPTED:"stopped",paused:"paused",MAX_EVALUATIONS:"evaluation limit reached",NO_PROGRESS:"no progress",CONVERGED:"converged"},uu=(i=!b.playing)=>{let[e,t]=b.played;i&&(b.time<e||b.time>=t-1e-6)&&b.seek(e),b.playing=i,b.tell("time")},op=i=>{uu(!1),b.seek(b.first+(Math.round((b.time-b.first)*b.fps)+i)/b.fps)},ap=i=>{uu(!1);let e=(b.document?.keys??[]).map(s=>s.time),t=1e-4,n=i>0?e.find(s=>s>b.time+t):e.findLast(s=>s<b.time-t);b.seek(n??(i>0?b.last:b.first))},Gx=async()=>{b.document?.file?await Wt("save"):Pe("files").dispatchEvent(new CustomEvent("save-as"))},Vx=async()=>{await Wt("key",{time:b.moment,...b.partial&&b.limb?{limb:b.limb.joints}:{}})},hu=[],lp=i=>{i.length&&(hu=i.map(e=>b.document.keys[e]),hn(`copied ${i.length} keyframe${i.length>1?"s":""}`))},cp=async()=>{let i=b.moment;(await Vn("paste_keys",{copied:hu,time:i})).ok&&b.select(b.at(hu.map(e=>e.time-hu[0].time+i)))},du=i=>{Wt("pose",{time:b.moment,name:i||null,partial:b.partial})},Wx=async()=>{if(b.bar){let{kind:e,index:t}=b.bar;b.bar=null,await Vn("remove",{at:[e,t]});return}let i=b.keys.size?[...b.keys]:b.here===null?[]:[b.here];i.length&&await Vn("delete_keys",{keys:i})},Xx=i=>{let e=Pe("play").querySelector("path"),t=Pe("speed");for(let c of q1)t.append(re("option",{value:c,text:`${c}×`,selected:c===1}));t.addEventListener("change",()=>{b.speed=Number(t.value)});for(let[c,h]of[["loop","loop"],["follow","follow"],["trails","trails"],["partial","partial"]]){let d=Pe(c);d.checked=b[h],d.addEventListener("change",()=>{b[h]=d.checked,b.tell("shown")})}let n=Pe("ghosts");n.addEventListener("change",()=>{b.ghosts=n.value,b.tell("shown")});let s=Pe("which");b.on("which",()=>{Pe("sides").hidden=b.which!=="side"}),s.addEventListener("change",()=>{s.value==="take"&&(b.snapshot=b.now,s.value="snapshot"),b.which=s.value,b.tell("which")}),Pe("views").addEventListener("change",c=>i.aim(c.target.value));let r=re("b"),o=re("span");Pe("clock").replaceChildren(r,o);let a=-1/0;b.on(["time","path"],()=>{let c=br[b.playing?"pause":"play"];if(e.getAttribute("d")!==c)e.setAttribute("d",c);else if(b.playing&&performance.now()-a<X1)return;a=performance.now(),Mr(r,b.time.toFixed(2)),Mr(o,` / ${b.last.toFixed(2)} s`),Mr(Pe("image"),`frame ${Math.round((b.time-b.first)*b.fps)}`)});let l=()=>{let{status:c,course:h}=b,d=c.state==="settled"?Z1[c.stop??""]??"converged":Y1[c.state]??c.state;Mr(Pe("state"),zr==="open"?d:"no connection to the studio"),Pe("state").dataset.state=zr==="open"?c.state:"gone",Mr(Pe("energy"),h?.value===void 0?"":`E ${h.value>=1e3?h.value.toExponential(2):Ms(h.value)}`),Mr(Pe("go"),c.go?"Stop":"Continue"),Pe("go").title=c.go?"stop optimising, now and after edits (G)":"optimise, now and after edits (G)"};b.on(["status","path","line"],l),b.on("document",()=>{let{document:c}=b;if(c){Pe("name").textContent=c.file??`${c.name} (no file yet)`,Pe("dirty").hidden=!c.dirty,window.document.title=`${c.dirty?"• ":""}${c.name} – dynsplines studio`;for(let[h,d]of[["undo","Ctrl-Z"],["redo","Ctrl-Shift-Z"]])Pe(h).disabled=!c[h],Pe(h).title=c[h]?`${h}: ${c[h]} (${d})`:`nothing to ${h}`}})};var fu=188,Ml=16,pu="text/x-pose",$1=6,qx=7,K1=.08,j1=[.001,.002,.005,.01,.02,.05,.1,.2,.5,1,2,5,10,30,60],Yx=(i,{clientX:e})=>{let{left:t,right:n}=i.getBoundingClientRect();return e-t<qx?"from":n-e<qx?"to":""},mu=class{box=Pe("timeline");head=re("div",{class:"playhead","aria-hidden":"true"});rows=re("div",{class:"rows"});ruler=re("div",{class:"ruler"});frames=re("div",{class:"frames"});band=re("div",{class:"band",hidden:!0});begin=0;end=1;fitted="";unfolded=!1;drag=null;preview=new Map;redraw=0;wide=0;ticked="";constructor(){this.box.append(this.ruler,this.rows,this.band,this.head),b.on(["document","loaded","selection","stage","joint","range","settled"],()=>this.draw());let e="";b.on("path",()=>{let t=`${b.first}|${b.last}`;t!==e?this.draw():this.ticks(),e=t}),b.on("time",()=>this.point()),new ResizeObserver(()=>{this.wide=0,this.draw()}).observe(this.box),this.box.addEventListener("wheel",t=>this.wheel(t),{passive:!1}),this.box.addEventListener("pointerdown",t=>this.down(t)),this.box.addEventListener("dragover",t=>{t.dataTransfer?.types.includes(pu)&&t.preventDefault()}),this.box.addEventListener("drop",t=>{t.preventDefault(),b.playing=!1,b.seek(this.snapped(this.timeAt(t),t,!0)),du(t.dataTransfer.getData(pu))}),window.addEventListener("pointermove",t=>this.drag?.move(this.timeAt(t),t)),window.addEventListener("pointerup",t=>{let{drag:n}=this;this.drag=null,n?.up(this.timeAt(t),t)})}get width(){return this.wide||=this.box.clientWidth,Math.max(50,this.wide-fu-2*Ml)}x(e){return fu+Ml+(e-this.begin)/(this.end-this.begin)*this.width}timeAt(e){let t=this.box.getBoundingClientRect().left;return this.begin+(e.clientX-t-fu-Ml)/this.width*(this.end-this.begin)}snapped(e,t,n=!1){if(t.altKey)return Math.max(Math.round(e*1e4)/1e4,Math.min(0,b.first));let s=$1/this.width*(this.end-this.begin),o=[b.time,...n?(b.document?.keys??[]).map(a=>a.time):[]].filter(a=>Math.abs(a-e)<s).sort((a,l)=>Math.abs(a-e)-Math.abs(l-e))[0];return o!==void 0?o:Math.max(Math.round(Math.round(e*b.fps)/b.fps*1e4)/1e4,Math.min(0,b.first))}fit(){let[e,t]=b.played;this.show(e,t+(t<b.last?0:K1*Math.max(t-e,.1)))}show(e,t){let n=Math.max(0,Math.min(0,b.first)-e);[this.begin,this.end]=[e+n,t+n],this.draw()}zoom(e,t=b.time){let n=Math.min(Math.max((this.end-this.begin)*e,.02),3*(b.last-b.first)+1),s=(t-this.begin)/(this.end-this.begin);this.show(t-s*n,t-s*n+n)}wheel(e){if(e.ctrlKey||e.metaKey)e.preventDefault(),this.zoom(Math.exp(e.deltaY*.002),this.timeAt(e));else if(e.shiftKey||Math.abs(e.deltaX)>Math.abs(e.deltaY)){e.preventDefault();let t=(e.deltaX||e.deltaY)/this.width*(this.end-this.begin);this.show(this.begin+t,this.end+t)}}point(){this.head.style.transform=`translateX(${this.x(b.time)}px)`;let e=b.here;for(let t of this.rows.querySelectorAll(".keys .diamond"))t.classList.toggle("here",Number(t.dataset.key)===e);this.ruler.setAttribute("aria-valuenow",b.time.toFixed(3)),this.ruler.setAttribute("aria-valuetext",`${b.time.toFixed(2)} seconds`)}draw(){this.redraw||(this.redraw=requestAnimationFrame(()=>{this.redraw=0,this.drawn()}))}drawn(){let{document:e}=b;if(!e)return;let t=this.begin<=b.first&&b.last<=this.end,n=t?e.name:`${e.name}|${b.first}|${b.last}`;(!n.startsWith(this.fitted)||!t&&n!==this.fitted)&&this.fit(),this.fitted=n;let s=window.document.activeElement?.dataset.id;this.rows.replaceChildren(this.keysRow(),...this.unfolded?this.limbRows():[],...this.barRows()),this.drawRuler(),this.point(),b.tell("zoom"),s&&this.rows.querySelector(`[data-id="${CSS.escape(s)}"]`)?.focus()}drawRuler(){let e=(this.end-this.begin)/this.width*70,t=j1.find(r=>r>=e)??60,n=[];for(let r=Math.ceil((this.begin-1e-9)/t);r*t<=this.end+1e-9;r++){let o=re("span",{class:"tick",text:(r*t).toFixed(t<.01?3:t<1?2:0)});o.style.left=`${this.x(r*t)}px`,n.push(o)}let s=this.placed(re("span",{class:"range",title:"playback range: drag its ends, double-click it to play all",ondblclick:()=>{b.range=[-1/0,1/0],b.tell("range")}}),...b.played);this.ruler.replaceChildren(re("span",{class:"label",text:"s"}),s,...n),Object.entries({role:"slider",tabindex:"0","aria-label":"time","aria-valuemin":b.first.toFixed(3),"aria-valuemax":b.last.toFixed(3)}).forEach(([r,o])=>this.ruler.setAttribute(r,o))}label(e,t){let n=re("span",{class:"label",title:e});return t&&n.append(t),n.append(re("span",{text:e})),n}keysRow(){let e=re("button",{type:"button",class:"fold","aria-expanded":String(this.unfolded),"aria-label":"limbs",title:"limbs (U)",onclick:()=>{this.unfolded=!this.unfolded,this.draw()}},this.unfolded?"▾":"▸"),t=re("div",{class:"row keys"},this.label("keyframes",e));t.append(this.frames),this.ticks();for(let{time:n,joint:s,text:r}of b.overshoots.filter(({time:o})=>o>=this.begin&&o<=this.end)){let o=re("button",{type:"button",class:"overshoot",text:"▲",title:r,"aria-label":r,onclick:()=>b.visit(n,s)});o.style.left=`${this.x(n)}px`,t.append(o)}return b.document.keys.forEach((n,s)=>{let r=b.loaded?.keys[s],o=r?!r.fixed.every(Boolean):!1,a=this.preview.get(s)??n.time;a<this.begin-1e-6||a>this.end+1e-6||t.append(this.diamond(s,a,o,`keyframe ${s+1} at ${n.time.toFixed(3)} s${o?", partial":""}`))}),t}ticks(){let e=(b.course?.frames??[]).filter(n=>n>=this.begin&&n<=this.end),t=`${e}|${this.begin}|${this.end}|${this.width}`;t!==this.ticked&&(this.ticked=t,this.frames.replaceChildren(...e.map(n=>{let s=re("i",{class:"frame"});return s.style.left=`${this.x(n)}px`,s})))}diamond(e,t,n,s){let r=b.keys.has(e),o=re("button",{type:"button",class:`diamond${n?" hollow":""}${r?" selected":""}`,title:s,"aria-label":s,"aria-pressed":String(r),"data-key":e,"data-id":`key${e}`});return o.style.left=`${this.x(t)}px`,o.addEventListener("keydown",a=>{(a.key==="Enter"||a.key===" ")&&(a.preventDefault(),a.stopPropagation(),this.choose(e,a),b.seek(b.document.keys[e].time))}),o}limbRows(){let{stage:e,loaded:t,document:n}=b,s=n.revision;return!e||!t?[]:e.limbs.map(r=>{let o=re("div",{class:"row limb"},this.label(r.name)),a=r.joints.map(l=>e.joints.find(c=>c.name===l)).filter(Boolean);return n.keys.forEach((l,c)=>{let h=t.keys[c];if(!h||l.time<this.begin||l.time>this.end)return;let d=a.map(m=>h.fixed[m.kind==="free"?m.qpos+3:m.qpos]),u=!d.every(Boolean),f=!d.some(Boolean),p=()=>{Wt(f?"pin":"free",{key:c,revision:s,joints:r.joints})},v=`${r.name}, keyframe ${c+1}: ${f?"free":u?"partly free":"fixed"}; Enter or double click ${f?"pins":"frees"} it`,g=re("button",{type:"button",class:`diamond small${u?" hollow":""}${f?" none":""}`,title:v,"aria-label":v,"data-id":`limb${r.name}${c}`,ondblclick:()=>p(),onkeydown:m=>{m.key==="Enter"&&p()}});g.style.left=`${this.x(l.time)}px`,o.append(g)}),o})}barRows(){let{document:e,loaded:t,stage:n}=b,s=[...new Set([...(n?.soles??[]).map(a=>a.name),...e.contacts.map(a=>a.point)])],r=[...new Set([...b.limb?.hands??[],...e.grasps.map(a=>a.hand)])],o=s.slice(0,24).map(a=>{let l=re("div",{class:"row bars","data-point":a},this.label(a));for(let c of t?.stances.filter(h=>h.point===a)??[])l.append(this.told(c.from,c.to,`${a}: stance inferred from keyframes`));return e.contacts.forEach((c,h)=>{c.point===a&&l.append(this.bar("contact",h,c,`contact of ${a}`))}),l});for(let a of r){let l=re("div",{class:"row bars","data-hand":a,title:"drag here for a new grasp"},this.label(`${a} holds`));e.grasps.forEach((c,h)=>{c.hand===a&&l.append(this.bar("grasp",h,c,`${a} holds ${c.body}`))}),o.push(l)}if(t?.flights.length){let a=re("div",{class:"row bars"},this.label("flights"));for(let[l,c]of t.flights)a.append(this.told(l,c,"flight inferred from keyframes","flight"));o.push(a)}return o}placed(e,t,n){let s=this.x(Math.max(t,this.begin)),r=this.x(Math.min(n,this.end));return e.style.left=`${s}px`,e.style.width=`${Math.max(3,r-s)}px`,e}told(e,t,n,s="stance"){return this.placed(re("span",{class:`bar ${s}`,title:`${n}: ${e.toFixed(2)} to ${t.toFixed(2)} s`}),e,t)}bar(e,t,n,s){let r=b.bar?.kind===e&&b.bar.index===t,o=`${s}, ${n.from.toFixed(2)} to ${n.to.toFixed(2)} s`,a=re("button",{type:"button",class:`bar ${e}${r?" selected":""}`,title:`${o}; drag it or its ends`,"aria-label":o,"data-bar":e,"data-index":t,"data-id":`${e}${t}`,"aria-pressed":String(r),onfocus:()=>{(b.bar?.index!==t||b.bar.kind!==e)&&(b.bar={kind:e,index:t},b.keys.clear(),b.tell("selection"))}});return this.placed(a,n.from,n.to)}down(e){if(e.button!==0)return;let t=e.target,n=this.timeAt(e),s=e.clientX-this.box.getBoundingClientRect().left;if(t.closest(".fold")||s<fu)return;let r=t.matches(".range")?Yx(t,e):"";if(r){this.drag={move:(c,h)=>b.setRange(r==="from"?0:1,this.snapped(c,h,!0)),up:()=>{}};return}if(t.closest(".ruler")){b.playing=!1;let c=(h,d)=>b.seek(this.snapped(h,d,!0));c(n,e),this.drag={move:c,up:()=>{}};return}let o=t.closest(".keys .diamond"),a=t.closest("[data-bar]"),l=t.closest("[data-point], [data-hand]");o?this.grabKey(Number(o.dataset.key),n,e):a?this.grabBar(a,n,e):l?this.drawBar(l,n,e):t.closest("button")||this.boxSelect(n,e)}choose(e,t){let n=new Set(b.keys);if(t.ctrlKey||t.metaKey)n.has(e)?n.delete(e):n.add(e);else if(t.shiftKey&&n.size){let s=[...n,e];for(let r=Math.min(...s);r<=Math.max(...s);r++)n.add(r)}else n.has(e)||(n.clear(),n.add(e));b.select(n)}grabKey(e,t,n){let s=b.document.keys.map(u=>u.time),{revision:r}=b.document,o=b.keys.has(e);this.choose(e,n);let a=[...b.keys];b.playing=!1,b.seek(s[e]);let l=Pe("panel-pose"),c=u=>l.contains(document.elementFromPoint(u.clientX,u.clientY)),h=!1,d=(u,f)=>{if(c(f))return new Map;let p=this.snapped(s[e]+u-t,f);return new Map(a.map(v=>[v,Math.round((s[v]+p-s[e])*1e4)/1e4]))};this.drag={move:(u,f)=>{!h&&Math.abs(this.x(u)-this.x(t))<3||(h=!0,this.preview=d(u,f),l.classList.toggle("dropping",c(f)),this.draw())},up:(u,f)=>{if(this.preview.clear(),l.classList.remove("dropping"),this.draw(),!h){o&&b.keys.size>1&&!f.shiftKey&&!f.ctrlKey&&b.select([e]);return}c(f)?cu(s[e]):hr([...d(u,f)],r)}}}grabBar(e,t,n){let s=e.dataset.bar,r=Number(e.dataset.index),{revision:o}=b.document,a=(s==="contact"?b.document.contacts:b.document.grasps)[r],l=Yx(e,n);b.bar={kind:s,index:r},b.keys.clear(),b.tell("selection");let c=(d,u)=>{if(l==="from")return[this.snapped(d,u,!0),a.to];if(l==="to")return[a.from,this.snapped(d,u,!0)];let f=this.snapped(a.from+d-t,u,!0);return[f,f+a.to-a.from]},h=!1;this.drag={move:(d,u)=>{if(!h&&Math.abs(this.x(d)-this.x(t))<3)return;h=!0;let f=this.rows.querySelector(`[data-id="${s}${r}"]`);f&&this.placed(f,...c(d,u))},up:(d,u)=>{if(!h)return;let[f,p]=c(d,u);Li([s,r],{from:f,to:p},o)}}}drawBar(e,t,n){let{point:s,hand:r}=e.dataset,o=s?"contact":"grasp",a=this.snapped(t,n,!0),l=re("span",{class:`bar ${o} new`}),c=!1;this.drag={move:(h,d)=>{if(!c&&Math.abs(this.x(h)-this.x(t))<5)return;c||this.rows.querySelector(`[data-${s?"point":"hand"}="${CSS.escape(s??r)}"]`)?.append(l),c=!0;let u=this.snapped(h,d,!0);this.placed(l,Math.min(a,u),Math.max(a,u))},up:(h,d)=>{let u=this.snapped(h,d,!0),f={from:Math.min(a,u),to:Math.max(a,u)};if(!c||u===a){l.remove(),b.select([]),b.seek(this.snapped(t,d,!0));return}if(s){l.remove(),Vn("add",{at:["contact"],entries:{point:s,...f}});return}this.graspable(r,f.from,d,p=>{l.remove(),p!==null&&Vn("add",{at:["grasp"],entries:{hand:r,body:p,...f}})})}}}graspable(e,t,n,s){let{stage:r,now:o}=b,a=r?.sites.find(f=>f.name===e);if(!r||!o||!a){s(null);return}let l=o.at(t),c=f=>r.parents[f]?c(r.parents[f]):f,h=Br(l,a),d=r.limbs.find(f=>r.joints.some(p=>p.body===a.body&&f.joints.includes(p.name))),u=r.bodies.map((f,p)=>({name:f,body:p,away:h.distanceTo(Br(l,{body:p,offset:[0,0,0]})),other:c(p)!==c(a.body)})).filter(({name:f,body:p})=>p&&f&&!r.still[p]&&p!==a.body&&r.joints.some(v=>v.body===p)&&!d?.joints.some(v=>r.joints.find(g=>g.name===v)?.body===p)).sort((f,p)=>Number(p.other)-Number(f.other)||f.away-p.away).slice(0,8);if(!u.length){hn("there is no free body to grasp","note"),s(null);return}Jl(`${e} holds`,n,u.map(({name:f})=>f),s)}boxSelect(e,t){let n=!1,s=t.shiftKey?new Set(b.keys):new Set;this.drag={move:r=>{n||=Math.abs(this.x(r)-this.x(e))>4,this.band.hidden=!n,this.placed(this.band,Math.min(e,r),Math.max(e,r))},up:(r,o)=>{if(this.band.hidden=!0,!n){b.select(s),b.playing=!1,b.seek(this.snapped(e,o,!0));return}let[a,l]=[Math.min(e,r),Math.max(e,r)];b.document.keys.forEach((c,h)=>{c.time>=a&&c.time<=l&&s.add(h)}),b.select(s),s.size||hn("no keyframe there","note")}}}};var Qo=["pose","problems","weights","scene"],Gr=i=>{for(let e of Qo){let t=e===i;Pe(`tab-${e}`).setAttribute("aria-selected",String(t)),Pe(`tab-${e}`).tabIndex=t?0:-1,Pe(`panel-${e}`).hidden=!t}(i==="weights"||i==="scene")&&Sl[i]()},Zx=([i,e,t,n])=>{let s=i<0?-1:1,r=Math.hypot(e,t,n),o=2*Math.atan2(r,Math.abs(i))*(180/Math.PI);return[e,t,n].map(a=>r>1e-12?s*a*o/r:0)},wl=(i,e)=>i.kind==="free"?[...e.slice(i.qpos,i.qpos+3),...Zx(e.slice(i.qpos+3,i.qpos+7))]:i.kind==="ball"?Zx(e.slice(i.qpos,i.qpos+4)):[i.kind==="hinge"?e[i.qpos]*180/Math.PI:e[i.qpos]],Jx=i=>i===b.stage.joints.find(e=>e.kind==="free"),Qx=(i,e)=>Jx(i)?{root:e}:{roots:{[i.name]:e}},$x=(i,e=t=>!0)=>[i,...b.stage.joints.filter(t=>t!==i&&[i,t].every(({kind:n,name:s})=>n!=="free"&&b.joints.includes(s))&&e(t))],hp=(i,e,t,n,s)=>{let[[r,o]]=e,a=c=>c!==t&&!b.loaded.keys[i].fixed[r.qpos+c],l={joints:Object.fromEntries(e.map(([c,h])=>[c.name,c.kind==="ball"?{rotvec:h}:h[t]]))};return r.kind==="free"&&(l=Qx(r,t>=3?{rotation:{rotvec:o.slice(3)}}:{position:o.slice(0,3).map((c,h)=>a(h)?"free":c)})),Vn("change",{at:["keyframe",i],entries:l,revision:n,plant:Jx(r),locks:b.locked},s)},J1=(i,e)=>{let{loaded:t,document:n}=b,s=n.revision,r=t.keys[i],o=n.keys[i],a=e.kind==="free"?e.qpos+3:e.qpos,l=r.fixed[a],c=wl(e,b.poseOf(i)),h=["keyframe",i],d=e.kind==="free"||o.joints?.[e.name]!==void 0,u=l?"pin":"free",f=re("select",{class:"mode","aria-label":`${e.name}: pinned, free, or by the keyframe's rule for other joints`,title:"pinned: fixed at this value; free: chosen by the optimiser; others: by the keyframe's rule for other joints",onchange:({currentTarget:T})=>{let{value:M}=T,C=$x(e).map(({name:S})=>S);M==="none"?Li(h,{joints:Object.fromEntries(C.map(S=>[S,null]))},s):Wt(M,{key:i,revision:s,joints:C})}});for(let[T,M]of[["pin","pinned"],["free","free"],...e.kind==="free"?[]:[["none",`others (${o.others})`]]])f.append(re("option",{value:T,text:M,selected:T===(d?u:"none")}));let p=re("div",{"data-id":e.name,class:`joint${b.joints.includes(e.name)?" selected":""}${l?"":" free"}`},re("button",{type:"button",class:"name",text:e.name,title:e.range?`range ${e.range.map(T=>Ms(T,1)).join(" to ")}`:e.kind,onclick:T=>{let{shiftKey:M}=T;b.choose(!M&&String(b.joints)===e.name?null:e.name,M)}}),f),v=re("div",{class:"numbers"}),g=(T,M,C)=>{let S=b.poseOf(i),x=M-wl(e,S)[T];hp(i,$x(e,({kind:E})=>E===e.kind).map(E=>{let O=wl(E,S);return O[T]=E===e||!C?M:O[T]+x,[E,O]}),T,s,C)},m=e.kind==="free"?["x","y","z","turn x","turn y","turn z"]:e.kind==="ball"?["x","y","z"]:[""],_=[];return c.forEach((T,M)=>{let C=e.kind==="free"&&M<3,S=e.kind==="slide"||C,x=`${e.name} ${m[M]}`.trim(),E=Sr(x,T,S?"m":"degrees",(D,z)=>g(M,D,z),...S?[.01,3]:[1,1]),O=C?r.fixed[e.qpos+M]:l;E.classList.toggle("loose",!O);let P=re("label",{class:"axis-name","data-unit":S?"m":"°"},m[M].replace("turn ",""),E);P.style.order=String(2*M),v.append(P),C&&_.push(re("button",{type:"button",class:"axis",text:O?"•":"○","aria-pressed":String(!O),"data-id":x,"aria-label":`${x}: ${O?"pinned; press to free it":"free; press to pin it"}`,title:O?"free this axis":"pin this axis",onclick:()=>{let D=c.slice(0,3).map((z,W)=>(W===M?O:!r.fixed[e.qpos+W])?"free":z);Li(h,Qx(e,{position:D}),s)}}))}),_.forEach((T,M)=>{T.style.order=String(2*M+1)}),v.append(..._),p.append(v),p},Kx=()=>re("div",{class:"buttons"},...["",...b.poses].map(i=>re("button",{type:"button",class:"pose",text:i||"rest","data-id":`pose ${i}`,draggable:"true",title:"apply this pose here; or drag it to a time",onclick:()=>du(i),ondragstart:e=>e.dataTransfer.setData(pu,i)})),re("button",{type:"button",text:"save pose …",title:"save the present pose as a file; or drag a keyframe here",onclick:()=>cu()})),jx=null,e_=0,Q1=()=>{if(b.playing)return;e_=b.time;let i=Pe("panel-pose"),{stage:e,loaded:t,document:n}=b,s=b.here;if(!e||!t||!n||t.revision!==n.revision)return;if(s===null||!t.keys[s]){qs(i,re("p",{class:"hint"},"No keyframe here. Drag any point of the figure, or press ",re("kbd",{text:"K"}),", to make one from the path, or apply a pose."),Kx());return}let r=n.keys[s],{revision:o}=n,a=e.joints.map(d=>d.name),l=re("select",{"aria-label":"joints that this keyframe does not name",onchange:({currentTarget:d})=>{let{value:u}=d;Li(["keyframe",s],{others:u==="free"?null:u},o)}});for(let d of new Set(["free","rest","previous",r.others]))l.append(re("option",{value:d,text:d,selected:d===r.others}));let c=Sr("time",r.time,"s",(d,u)=>{hr([[s,d]],o,u)},1/b.fps,4),h=(d,u,f,p)=>re("button",{type:"button",text:d,title:u,onclick:()=>{Wt(f,{key:s,revision:o,...p})}});qs(i,re("div",{class:"heading"},re("h2",{text:`Keyframe ${s+1}`}),re("label",{},"at ",c," s")),re("div",{class:"buttons"},re("button",{type:"button",text:"mirror",title:"mirror left and right (M)",onclick:()=>{Wt("mirror",{keys:[s],revision:o})}}),h("pin all","pin every joint","pin",{joints:a}),h("free all","free every joint","free",{joints:a})),Kx(),re("label",{class:"line"},"other joints: ",l),...["sites","bodies"].flatMap(d=>Object.entries(r[d]??{}).map(([u,f])=>re("div",{class:"line place","data-id":`${d} ${u}`},re("span",{text:`${u} → ${JSON.stringify(f)}`}),...d==="sites"?[re("button",{type:"button",text:"remove target",onclick:()=>{Li(["keyframe",s],{sites:{[u]:null}},o)}})]:[]))),...e.joints.map(d=>J1(s,d))),b.joint!==jx&&(jx=b.joint,i.querySelector(".joint.selected")?.scrollIntoView({block:"nearest"}))},eT=()=>{let{violations:i}=b,e=i.length,t=(b.loaded?.notes??[]).map(s=>re("p",{class:"hint",text:s}));Pe("count").textContent=e?String(e):"",Pe("count").hidden=!e;let n=Pe("panel-problems");if(!e){qs(n,re("p",{class:"hint good",id:"nothing-wrong",text:b.status.state==="settled"?"No problems.":"No problems so far."}),...t);return}qs(n,...t,re("p",{class:"hint",text:"Worst first. Click one to go there."}),re("ol",{class:"violations"},...i.map(s=>re("li",{},re("button",{type:"button",class:s.keyframe===null?"":"own",text:s.text,onclick:()=>{b.visit(s.time,s.name),s.keyframe!==null&&b.select([s.keyframe-1]),s.time===null&&hn("it concerns the whole motion","note")}})))))},gu=4,t_=()=>{let{kinds:i,document:e,loaded:t,course:n}=b;if(!i.length||!e||Pe("panel-weights").hidden)return;let s=n?.parts??{},r=Object.values(s).reduce((c,h)=>c+h,0),o=i.map(({kind:c,part:h,term:d,weight:u,quantity:f,"is on":p})=>{let v=e.weights[d]??t?.weights[d]??(p?u:0),g=(C,S)=>{Vn("set_weight",{kind:c,part:h,weight:C},S)},m=Sr(`weight of ${d}`,v,"",g,.1,4),_=re("input",{type:"range",min:-gu,max:gu,step:.05,"aria-label":`weight of ${d}`,value:v>0?Math.log10(v/u):-gu,oninput:({currentTarget:C})=>{let S=Number(C.value);g(S<=-gu?0:Number((u*10**S).toPrecision(3)),va(d))}}),T=r>0?(s[d]??0)/r:0,M=re("i",{class:"share"});return M.style.width=`${100*T}%`,re("div",{"data-id":d,class:`weight${d in(t?.weights??{})?"":" off"}`,title:`penalises ${f}`},re("span",{class:"name"},re("b",{text:d}),re("small",{text:f})),_,m,re("button",{type:"button",class:"axis",text:"↺",disabled:!(d in e.weights),title:"its default","aria-label":`default weight of ${d}`,onclick:()=>g(null)}),re("span",{class:"part",title:"its share of E"},M,re("small",{text:s[d]===void 0?"":s[d].toPrecision(2)})))}),a=Sr("tolerance of the search",Number(e.solve.tolerance??.001),"",(c,h)=>{Li(["solve"],{tolerance:c},void 0,h)},.001,6),l=re("input",{type:"checkbox",checked:(e.weights.prior??t?.weights.prior??0)>0,onchange:({currentTarget:c})=>{Vn("set_weight",{kind:"prior",weight:c.checked?i.find(({term:h})=>h==="prior")?.weight:0})}});qs(Pe("panel-weights"),re("label",{class:"line",title:"stay near the poses of people between such keyframes"},l," as people move"),re("label",{class:"line"},"tolerance of the search ",a),...o)},tT={box:{position:[0,0,.2],size:[.4,.4,.4]},step:{x:0,height:.2},sphere:{position:[0,0,.2],radius:.2},capsule:{position:[0,0,.9],length:1,radius:.03},cylinder:{position:[0,0,.25],length:.5,radius:.15}},nT=()=>{let{document:i}=b;if(!i||Pe("panel-scene").hidden)return;let{revision:e,obstacles:t}=i,n=Object.entries(tT).map(([r,o])=>re("button",{type:"button",text:`+ ${r}`,disabled:r==="step"&&t.some(a=>a.kind===r),onclick:()=>{let a=Math.round(100*(b.now?b.now.centreAt(b.time)[0]+.8:.6))/100,l=t.filter(h=>h.kind===r).length;(r==="step"?Li(["scene"],{step:{...o,x:a}}):Vn("add",{at:["scene",r],entries:{...o,position:[a,0,o.position[2]]}})).then(({ok:h})=>{h&&b.pick({kind:r,index:l})})}})),s=t.map(r=>{let o=b.obstacle?.kind===r.kind&&b.obstacle.index===r.index,a=r.name?`${r.kind} ‘${r.name}’`:`${r.kind}${r.kind==="step"?"":` ${r.index+1}`}`,l=re("div",{"data-id":`${r.kind} ${r.index}`,class:`joint${o?" selected":""}`},re("button",{type:"button",class:"name",text:a,title:"select it on the stage",onclick:()=>b.pick(o?null:r)}),re("button",{type:"button",class:"axis",text:"✕","aria-label":`delete the ${a}`,onclick:()=>{b.pick(null),Vn("remove",{at:yl(r),revision:e})}})),c=re("div",{class:"numbers"}),h=u=>[(b.document?.obstacles.find(({kind:f,index:p})=>f===r.kind&&p===r.index)??r)[u]].flat(),d=(u,f)=>{if(r.kind!=="box"||u!=="size"||r.rotation||!r.position)return{};let[p,v,g]=h("position");return{position:[p,v,Number((g+(f[2]-h("size")[2])/2).toFixed(6))]}};for(let[u,f]of Object.entries(r)){if(["kind","index","color","mass"].includes(u))continue;let p=(g,m)=>{Li(yl(r),{[u]:g,...d(u,g)},e,m)},v=(g,m)=>c.append(re("label",{class:"axis-name","data-unit":"m"},g,m));typeof f=="number"?v(u,Sr(`${a} ${u}`,f,"m",p,.01)):Array.isArray(f)&&f.forEach((g,m)=>v(m?"xyz"[m]:`${u} x`,Sr(`${a} ${u} ${"xyz"[m]}`,g,"m",(_,T)=>p(h(u).map((M,C)=>C===m?_:M),T),.01)))}return l.append(c),l});qs(Pe("panel-scene"),re("div",{class:"buttons"},...n),...s.length?s:[re("p",{class:"hint",text:"Nothing but the floor. Add something to step on or to run into."})])},Sl={pose:ya(Q1),problems:ya(eT),weights:ya(t_),scene:ya(nT)},n_=()=>{for(let e of Qo)Pe(`tab-${e}`).addEventListener("click",()=>Gr(e)),Pe(`tab-${e}`).addEventListener("keydown",t=>{let n=t.key==="ArrowRight"?1:t.key==="ArrowLeft"?-1:0;if(!n)return;t.stopPropagation();let s=Qo[(Qo.indexOf(e)+n+Qo.length)%Qo.length];Gr(s),Pe(`tab-${s}`).focus()});b.on(["time","joint","loaded","stage","document","poses","settled"],Sl.pose),Pe("panel-pose").addEventListener("focusin",()=>{b.playing&&(b.playing=!1,b.seek(e_))}),b.on(["settled","status","loaded"],Sl.problems),b.on(["kinds","document","loaded","settled"],Sl.weights);let i=0;b.on("path",()=>{i||(i=window.setTimeout(()=>{i=0,t_()},300))}),b.on(["document","joint"],Sl.scene),Gr("pose")};var i_=["#58a6ff","#f0883e","#56d364","#ff7b9c","#bc8cff","#e3b341","#39c5cf","#a5b1c2"],s_=14,iT=56,sT=8,r_=8,ai=null,xu="angle",El=new Set,Ni=!1,Tl=[],Di=null,o_=()=>[b.first,b.last],a_=()=>{Ni=!Ni,Pe("curves").hidden=!Ni,Pe("show-curves").setAttribute("aria-pressed",String(Ni)),Pn("want_curves",{on:Ni}),Ni&&ea()},up=i=>getComputedStyle(document.documentElement).getPropertyValue(i).trim(),dp=i=>i.series.filter(({joint:e})=>b.joints.includes(e)),l_=({after:i},e)=>{let t=b.curves.time,n=(e-t[0])/(t.at(-1)-t[0])*(i.length-1),s=Math.min(Math.max(Math.floor(n),0),i.length-2);return i[s]+(n-s)*(i[s+1]-i[s])},yu=()=>Tl.flatMap(i=>{let e=b.stage?.joints.find(({name:r})=>r===i.joint),{axis:t}=i;if(!e||t===null||!b.loaded)return[];let n=e.qpos+(e.kind!=="free"?0:Math.min(t,3));return b.document.keys.flatMap(({time:r},o)=>b.loaded.keys[o]?.fixed[n]?[{key:o,joint:e,series:i,time:r,value:l_(i,r)}]:[]).map(r=>Di?.key===r.key&&Di.series===i?Di:r)}),_u=({time:i,value:e})=>[ai.valToPos(i,"x"),ai.valToPos(e,"y")],rT=async(i,e)=>{let{key:t,joint:n,series:s,time:r,value:o}=i,{revision:a}=b.document,l=String(Math.random()),c=wl(n,b.poseOf(t));if(!(s.axis<3&&n.kind==="free"))for(let d of Tl.filter(u=>u.joint===n.name))c[d.axis]=l_(d,e.time);c[s.axis]=Number(o.toFixed(3)),o!==e.value&&await hp(t,[[n,c]],s.axis,a,l),r!==e.time&&await hr([[t,r]],b.document.revision,l)},oT=i=>{let e=({clientX:l,clientY:c})=>{let{left:h,top:d}=ai.over.getBoundingClientRect();return[l-h,c-d]},[t,n]=e(i),s=l=>Math.hypot(_u(l)[0]-t,_u(l)[1]-n),r=yu().sort((l,c)=>s(l)-s(c))[0];b.playing=!1,Di=r&&s(r)<r_?{...r}:null;let o=l=>{let[c,h]=e(l),d=ai.posToVal(c,"x");if(!Di){b.seek(d);return}(Math.abs(c-t)>r_||Di.time!==r.time)&&(Di.time=Math.round(Math.round(d*b.fps)/b.fps*1e4)/1e4),(Math.abs(h-n)>2||Di.value!==r.value)&&(Di.value=r.value+ai.posToVal(h,"y")-ai.posToVal(n,"y")),ai.redraw(!1)},a=()=>{window.removeEventListener("pointermove",o),window.removeEventListener("pointerup",a);let l=Di;Di=null,l&&rT(l,r)};Di||o(i),window.addEventListener("pointermove",o),window.addEventListener("pointerup",a)},ea=()=>{let{curves:i}=b;if(!Ni||!i)return;let e=Pe("plot"),t=i.groups.find(c=>c.name===xu)??i.groups[0];Tl=dp(t).length?dp(t):t.series.filter(({name:c})=>!El.has(`${xu}|${c}`));let n=b.which!=="after"||Pe("curves-before").checked,s=[i.time],r=[{label:"time"}];for(let c of Tl){let h=fp(t,c);s.push(c.after),r.push({label:c.name,stroke:h,width:1.5,points:{show:!1}}),n&&c.before&&(s.push(c.before),r.push({label:`${c.name}, before`,stroke:h,width:1,dash:[4,4],points:{show:!1}}))}let o=up("--soft"),a=up("--line"),l={stroke:o,grid:{stroke:a,width:1},ticks:{stroke:a},font:"11px system-ui"};ai?.destroy(),ai=new zn({width:Math.max(200,e.clientWidth),height:Math.max(90,e.clientHeight),series:r,padding:[10,Ml,0,0],scales:{x:{time:!1,range:()=>o_()}},axes:[{...l,size:26},{...l,size:iT-s_,label:t.unit,labelSize:s_,labelFont:"11px system-ui"}],legend:{show:!1},cursor:{drag:{x:!1,y:!1}},hooks:{draw:[c=>aT(c,t)]}},s,e),ai.over.addEventListener("pointerdown",oT),lT(t)},fp=(i,e)=>i_[i.series.indexOf(e)%i_.length],aT=(i,e)=>{let t=i.valToPos(b.time,"x",!0),{ctx:n,bbox:s}=i,r=4*devicePixelRatio;n.save(),n.strokeStyle=up("--accent"),n.lineWidth=1.5,n.beginPath(),n.moveTo(t,s.top),n.lineTo(t,s.top+s.height),n.stroke();for(let{series:o,time:a,value:l}of yu())n.fillStyle=fp(e,o),n.beginPath(),n.arc(i.valToPos(a,"x",!0),i.valToPos(l,"y",!0),r,0,2*Math.PI),n.fill();n.restore()},lT=i=>{let e=dp(i).length>0;Pe("curve-names").replaceChildren(...(e?Tl:i.series).map(t=>{let n=`${xu}|${t.name}`,s=e||!El.has(n),r=re("input",{type:"checkbox",checked:s,disabled:e,onchange:()=>{s?El.add(n):El.delete(n),ea()}}),o=re("i",{class:"dot"});return o.style.background=fp(i,t),re("label",{},r,o,t.name)}))},c_=i=>{o_=()=>[i.begin,i.end],b.on("zoom",()=>{Ni&&ai&&ai.setScale("x",{min:i.begin,max:i.end})});let e=Pe("curve-group");e.addEventListener("change",()=>{xu=e.value,ea()}),Pe("curves-before").addEventListener("change",ea);let t=!0;b.on("curves",()=>{let{curves:n}=b;if(t&&n){t=!1,e.replaceChildren(...n.groups.map(s=>re("option",{value:s.name,text:s.name})));for(let s of n.groups)s.series.slice(sT).forEach(r=>El.add(`${s.name}|${r.name}`))}ea()}),b.on("time",()=>{Ni&&ai?.redraw(!1)}),b.on("document",()=>{Ni&&ai?.redraw(!1)}),b.on(["theme","which","joint"],ea),new ResizeObserver(()=>{Ni&&ai?.setSize({width:Math.max(200,Pe("plot").clientWidth),height:Math.max(90,Pe("plot").clientHeight)})}).observe(Pe("plot")),b.on("line",()=>{Ni&&Pn("want_curves",{on:!0})})};var Vr=new Ir,un=new U,ur=new U,nn=new ht,h_={X:new U(1,0,0),Y:new U(0,1,0),Z:new U(0,0,1)},pp={type:"change"},u_={type:"mouseDown",mode:null},d_={type:"mouseUp",mode:null},f_={type:"objectChange"},wu=class extends Lr{constructor(e,t=null){super(void 0,t);let n=new gp(this);this._root=n;let s=new xp;this._gizmo=s,n.add(s);let r=new _p;this._plane=r,n.add(r);let o=this;function a(T,M){let C=M;Object.defineProperty(o,T,{get:function(){return C!==void 0?C:M},set:function(S){C!==S&&(C=S,r[T]=S,s[T]=S,o.dispatchEvent({type:T+"-changed",value:S}),o.dispatchEvent(pp))}}),o[T]=M,r[T]=M,s[T]=M}a("camera",e),a("object",void 0),a("enabled",!0),a("axis",null),a("mode","translate"),a("translationSnap",null),a("rotationSnap",null),a("scaleSnap",null),a("space","world"),a("size",1),this.viewport=null,a("dragging",!1),a("showX",!0),a("showY",!0),a("showZ",!0),a("showXY",!0),a("showYZ",!0),a("showXZ",!0),a("showXYZE",!0),a("showE",!0),a("minX",-1/0),a("maxX",1/0),a("minY",-1/0),a("maxY",1/0),a("minZ",-1/0),a("maxZ",1/0);let l=new U,c=new U,h=new ht,d=new ht,u=new U,f=new ht,p=new U,v=new U,g=new U,m=0,_=new U;a("worldPosition",l),a("worldPositionStart",c),a("worldQuaternion",h),a("worldQuaternionStart",d),a("cameraPosition",u),a("cameraQuaternion",f),a("pointStart",p),a("pointEnd",v),a("rotationAxis",g),a("rotationAngle",m),a("eye",_),this._offset=new U,this._startNorm=new U,this._endNorm=new U,this._cameraScale=new U,this._parentPosition=new U,this._parentQuaternion=new ht,this._parentQuaternionInv=new ht,this._parentScale=new U,this._worldScaleStart=new U,this._worldQuaternionInv=new ht,this._worldScale=new U,this._positionStart=new U,this._quaternionStart=new ht,this._scaleStart=new U,this._getPointer=cT.bind(this),this._onPointerDown=uT.bind(this),this._onPointerHover=hT.bind(this),this._onPointerMove=dT.bind(this),this._onPointerUp=fT.bind(this),t!==null&&this.connect(t)}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointermove",this._onPointerHover),this.domElement.addEventListener("pointerup",this._onPointerUp),this.domElement.style.touchAction="none"}disconnect(){this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.removeEventListener("pointermove",this._onPointerHover),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.domElement.removeEventListener("pointerup",this._onPointerUp),this.domElement.style.touchAction=""}getHelper(){return this._root}pointerHover(e){if(this.object===void 0||this.dragging===!0)return;e!==null&&Vr.setFromCamera(e,this.camera);let t=mp(this._gizmo.picker[this.mode],Vr);t?this.axis=t.object.name:this.axis=null}pointerDown(e){if(!(this.object===void 0||this.dragging===!0||e!=null&&e.button!==0)&&this.axis!==null){e!==null&&Vr.setFromCamera(e,this.camera);let t=mp(this._plane,Vr,!0);t&&(this.object.updateMatrixWorld(),this.object.parent.updateMatrixWorld(),this._positionStart.copy(this.object.position),this._quaternionStart.copy(this.object.quaternion),this._scaleStart.copy(this.object.scale),this.object.matrixWorld.decompose(this.worldPositionStart,this.worldQuaternionStart,this._worldScaleStart),this.pointStart.copy(t.point).sub(this.worldPositionStart)),this.dragging=!0,u_.mode=this.mode,this.dispatchEvent(u_)}}pointerMove(e){let t=this.axis,n=this.mode,s=this.object,r=this.space;if(n==="scale"?r="local":(t==="E"||t==="XYZE"||t==="XYZ")&&(r="world"),s===void 0||t===null||this.dragging===!1||e!==null&&e.button!==-1)return;e!==null&&Vr.setFromCamera(e,this.camera);let o=mp(this._plane,Vr,!0);if(o){if(this.pointEnd.copy(o.point).sub(this.worldPositionStart),n==="translate")this._offset.copy(this.pointEnd).sub(this.pointStart),r==="local"&&t!=="XYZ"&&this._offset.applyQuaternion(this._worldQuaternionInv),t.indexOf("X")===-1&&(this._offset.x=0),t.indexOf("Y")===-1&&(this._offset.y=0),t.indexOf("Z")===-1&&(this._offset.z=0),r==="local"&&t!=="XYZ"?this._offset.applyQuaternion(this._quaternionStart).divide(this._parentScale):this._offset.applyQuaternion(this._parentQuaternionInv).divide(this._parentScale),s.position.copy(this._offset).add(this._positionStart),this.translationSnap&&(r==="local"&&(s.position.applyQuaternion(nn.copy(this._quaternionStart).invert()),t.search("X")!==-1&&(s.position.x=Math.round(s.position.x/this.translationSnap)*this.translationSnap),t.search("Y")!==-1&&(s.position.y=Math.round(s.position.y/this.translationSnap)*this.translationSnap),t.search("Z")!==-1&&(s.position.z=Math.round(s.position.z/this.translationSnap)*this.translationSnap),s.position.applyQuaternion(this._quaternionStart)),r==="world"&&(s.getWorldPosition(un),t.search("X")!==-1&&(un.x=Math.round(un.x/this.translationSnap)*this.translationSnap),t.search("Y")!==-1&&(un.y=Math.round(un.y/this.translationSnap)*this.translationSnap),t.search("Z")!==-1&&(un.z=Math.round(un.z/this.translationSnap)*this.translationSnap),s.position.copy(s.parent.worldToLocal(un)))),s.position.x=Math.max(this.minX,Math.min(this.maxX,s.position.x)),s.position.y=Math.max(this.minY,Math.min(this.maxY,s.position.y)),s.position.z=Math.max(this.minZ,Math.min(this.maxZ,s.position.z));else if(n==="scale"){if(t.search("XYZ")!==-1){let a=this.pointEnd.length()/this.pointStart.length();this.pointEnd.dot(this.pointStart)<0&&(a*=-1),ur.set(a,a,a)}else un.copy(this.pointStart),ur.copy(this.pointEnd),un.applyQuaternion(this._worldQuaternionInv),ur.applyQuaternion(this._worldQuaternionInv),ur.divide(un),t.search("X")===-1&&(ur.x=1),t.search("Y")===-1&&(ur.y=1),t.search("Z")===-1&&(ur.z=1);s.scale.copy(this._scaleStart).multiply(ur),this.scaleSnap&&(t.search("X")!==-1&&(s.scale.x=Math.round(s.scale.x/this.scaleSnap)*this.scaleSnap||this.scaleSnap),t.search("Y")!==-1&&(s.scale.y=Math.round(s.scale.y/this.scaleSnap)*this.scaleSnap||this.scaleSnap),t.search("Z")!==-1&&(s.scale.z=Math.round(s.scale.z/this.scaleSnap)*this.scaleSnap||this.scaleSnap))}else if(n==="rotate"){this._offset.copy(this.pointEnd).sub(this.pointStart);let a=20/this.worldPosition.distanceTo(un.setFromMatrixPosition(this.camera.matrixWorld)),l=!1;t==="XYZE"?(this.rotationAxis.copy(this._offset).cross(this.eye).normalize(),this.rotationAngle=this._offset.dot(un.copy(this.rotationAxis).cross(this.eye))*a):(t==="X"||t==="Y"||t==="Z")&&(this.rotationAxis.copy(h_[t]),un.copy(h_[t]),r==="local"&&un.applyQuaternion(this.worldQuaternion),un.cross(this.eye),un.length()===0?l=!0:this.rotationAngle=this._offset.dot(un.normalize())*a),(t==="E"||l)&&(this.rotationAxis.copy(this.eye),this.rotationAngle=this.pointEnd.angleTo(this.pointStart),this._startNorm.copy(this.pointStart).normalize(),this._endNorm.copy(this.pointEnd).normalize(),this.rotationAngle*=this._endNorm.cross(this._startNorm).dot(this.eye)<0?1:-1),this.rotationSnap&&(this.rotationAngle=Math.round(this.rotationAngle/this.rotationSnap)*this.rotationSnap),r==="local"&&t!=="E"&&t!=="XYZE"?(s.quaternion.copy(this._quaternionStart),s.quaternion.multiply(nn.setFromAxisAngle(this.rotationAxis,this.rotationAngle)).normalize()):(this.rotationAxis.applyQuaternion(this._parentQuaternionInv),s.quaternion.copy(nn.setFromAxisAngle(this.rotationAxis,this.rotationAngle)),s.quaternion.multiply(this._quaternionStart).normalize())}this.dispatchEvent(pp),this.dispatchEvent(f_)}}pointerUp(e){e!==null&&e.button!==0||(this.dragging&&this.axis!==null&&(d_.mode=this.mode,this.dispatchEvent(d_)),this.dragging=!1,this.axis=null)}dispose(){this.disconnect(),this._root.dispose()}attach(e){return this.object=e,this._root.visible=!0,this}detach(){return this.object=void 0,this.axis=null,this._root.visible=!1,this}reset(){this.enabled&&this.dragging&&(this.object.position.copy(this._positionStart),this.object.quaternion.copy(this._quaternionStart),this.object.scale.copy(this._scaleStart),this.dispatchEvent(pp),this.dispatchEvent(f_),this.pointStart.copy(this.pointEnd))}getRaycaster(){return Vr}getMode(){return this.mode}setMode(e){this.mode=e}setTranslationSnap(e){this.translationSnap=e}setRotationSnap(e){this.rotationSnap=e}setScaleSnap(e){this.scaleSnap=e}setSize(e){this.size=e}setSpace(e){this.space=e}setColors(e,t,n,s){let r=this._gizmo.materialLib;r.xAxis.color.set(e),r.yAxis.color.set(t),r.zAxis.color.set(n),r.active.color.set(s),r.xAxisTransparent.color.set(e),r.yAxisTransparent.color.set(t),r.zAxisTransparent.color.set(n),r.activeTransparent.color.set(s),r.xAxis._color&&r.xAxis._color.set(e),r.yAxis._color&&r.yAxis._color.set(t),r.zAxis._color&&r.zAxis._color.set(n),r.active._color&&r.active._color.set(s),r.xAxisTransparent._color&&r.xAxisTransparent._color.set(e),r.yAxisTransparent._color&&r.yAxisTransparent._color.set(t),r.zAxisTransparent._color&&r.zAxisTransparent._color.set(n),r.activeTransparent._color&&r.activeTransparent._color.set(s)}};function cT(i){if(this.domElement.ownerDocument.pointerLockElement)return{x:0,y:0,button:i.button};{let e=this.domElement.getBoundingClientRect(),t=this.viewport,n,s,r,o;return t!==null?(n=t.x,s=e.height-t.y-t.w,r=t.z,o=t.w):(n=0,s=0,r=e.width,o=e.height),{x:(i.clientX-e.left-n)/r*2-1,y:-(i.clientY-e.top-s)/o*2+1,button:i.button}}}function hT(i){if(this.enabled)switch(i.pointerType){case"mouse":case"pen":this.pointerHover(this._getPointer(i));break}}function uT(i){this.enabled&&(document.pointerLockElement||this.domElement.setPointerCapture(i.pointerId),this.domElement.addEventListener("pointermove",this._onPointerMove),this.pointerHover(this._getPointer(i)),this.pointerDown(this._getPointer(i)))}function dT(i){this.enabled&&this.pointerMove(this._getPointer(i))}function fT(i){this.enabled&&(this.domElement.releasePointerCapture(i.pointerId),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.pointerUp(this._getPointer(i)))}function mp(i,e,t){let n=e.intersectObject(i,!0);for(let s=0;s<n.length;s++)if(n[s].object.visible||t)return n[s];return!1}var vu=new Ri,Ht=new U(0,1,0),p_=new U(0,0,0),m_=new yt,bu=new ht,Su=new ht,ps=new U,Eu=new yt,Cl=new U(1,0,0),Wr=new U(0,1,0),Pl=new U(0,0,1),Mu=new U,Al=new U,Rl=new U,gp=class extends Jt{constructor(e){super(),this.isTransformControlsRoot=!0,this.controls=e,this.visible=!1}updateMatrixWorld(e){let t=this.controls;t.object!==void 0&&(t.object.updateMatrixWorld(),t.object.parent===null?console.error("TransformControls: The attached 3D object must be a part of the scene graph."):t.object.parent.matrixWorld.decompose(t._parentPosition,t._parentQuaternion,t._parentScale),t.object.matrixWorld.decompose(t.worldPosition,t.worldQuaternion,t._worldScale),t._parentQuaternionInv.copy(t._parentQuaternion).invert(),t._worldQuaternionInv.copy(t.worldQuaternion).invert()),t.camera.updateMatrixWorld(),t.camera.matrixWorld.decompose(t.cameraPosition,t.cameraQuaternion,t._cameraScale),t.camera.isOrthographicCamera?t.camera.getWorldDirection(t.eye).negate():t.eye.copy(t.cameraPosition).sub(t.worldPosition).normalize(),this.parent&&(Eu.copy(this.parent.matrixWorld).invert(),Eu.decompose(this.position,this.quaternion,this.scale)),super.updateMatrixWorld(e)}dispose(){this.traverse(function(e){e.geometry&&e.geometry.dispose(),e.material&&e.material.dispose()})}},xp=class extends Jt{constructor(){super(),this.isTransformControlsGizmo=!0,this.type="TransformControlsGizmo";let e=new ri({depthTest:!1,depthWrite:!1,fog:!1,toneMapped:!1,transparent:!0}),t=new as({depthTest:!1,depthWrite:!1,fog:!1,toneMapped:!1,transparent:!0}),n=e.clone();n.opacity=.15;let s=t.clone();s.opacity=.5;let r=e.clone();r.color.setHex(16711680);let o=e.clone();o.color.setHex(65280);let a=e.clone();a.color.setHex(255);let l=e.clone();l.color.setHex(16711680),l.opacity=.5;let c=e.clone();c.color.setHex(65280),c.opacity=.5;let h=e.clone();h.color.setHex(255),h.opacity=.5;let d=e.clone();d.opacity=.25;let u=e.clone();u.color.setHex(16776960),u.opacity=.25;let f=e.clone();f.color.setHex(16776960);let p=e.clone();p.color.setHex(7895160),this.materialLib={xAxis:r,yAxis:o,zAxis:a,active:f,xAxisTransparent:l,yAxisTransparent:c,zAxisTransparent:h,activeTransparent:u};let v=new Sn(0,.04,.1,12);v.translate(0,.05,0);let g=new Vt(.08,.08,.08);g.translate(0,.04,0);let m=new Lt;m.setAttribute("position",new wt([0,0,0,1,0,0],3));let _=new Sn(.0075,.0075,.5,3);_.translate(0,.25,0);function T(V,Z){let G=new Ds(V,.0075,3,64,Z*Math.PI*2);return G.rotateY(Math.PI/2),G.rotateX(Math.PI/2),G}function M(){let V=new Lt;return V.setAttribute("position",new wt([0,0,0,1,1,1],3)),V}let C={X:[[new De(v,r),[.5,0,0],[0,0,-Math.PI/2]],[new De(v,r),[-.5,0,0],[0,0,Math.PI/2]],[new De(_,r),[0,0,0],[0,0,-Math.PI/2]]],Y:[[new De(v,o),[0,.5,0]],[new De(v,o),[0,-.5,0],[Math.PI,0,0]],[new De(_,o)]],Z:[[new De(v,a),[0,0,.5],[Math.PI/2,0,0]],[new De(v,a),[0,0,-.5],[-Math.PI/2,0,0]],[new De(_,a),null,[Math.PI/2,0,0]]],XYZ:[[new De(new er(.1,0),d),[0,0,0]]],XY:[[new De(new Vt(.15,.15,.01),h),[.15,.15,0]]],YZ:[[new De(new Vt(.15,.15,.01),l),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new De(new Vt(.15,.15,.01),c),[.15,0,.15],[-Math.PI/2,0,0]]]},S={X:[[new De(new Sn(.2,0,.6,4),n),[.3,0,0],[0,0,-Math.PI/2]],[new De(new Sn(.2,0,.6,4),n),[-.3,0,0],[0,0,Math.PI/2]]],Y:[[new De(new Sn(.2,0,.6,4),n),[0,.3,0]],[new De(new Sn(.2,0,.6,4),n),[0,-.3,0],[0,0,Math.PI]]],Z:[[new De(new Sn(.2,0,.6,4),n),[0,0,.3],[Math.PI/2,0,0]],[new De(new Sn(.2,0,.6,4),n),[0,0,-.3],[-Math.PI/2,0,0]]],XYZ:[[new De(new er(.2,0),n)]],XY:[[new De(new Vt(.2,.2,.01),n),[.15,.15,0]]],YZ:[[new De(new Vt(.2,.2,.01),n),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new De(new Vt(.2,.2,.01),n),[.15,0,.15],[-Math.PI/2,0,0]]]},x={START:[[new De(new er(.01,2),s),null,null,null,"helper"]],END:[[new De(new er(.01,2),s),null,null,null,"helper"]],DELTA:[[new oi(M(),s),null,null,null,"helper"]],X:[[new oi(m,s),[-1e3,0,0],null,[1e6,1,1],"helper"]],Y:[[new oi(m,s),[0,-1e3,0],[0,0,Math.PI/2],[1e6,1,1],"helper"]],Z:[[new oi(m,s),[0,0,-1e3],[0,-Math.PI/2,0],[1e6,1,1],"helper"]]},E={XYZE:[[new De(T(.5,1),p),null,[0,Math.PI/2,0]]],X:[[new De(T(.5,.5),r)]],Y:[[new De(T(.5,.5),o),null,[0,0,-Math.PI/2]]],Z:[[new De(T(.5,.5),a),null,[0,Math.PI/2,0]]],E:[[new De(T(.75,1),u),null,[0,Math.PI/2,0]]]},O={AXIS:[[new oi(m,s),[-1e3,0,0],null,[1e6,1,1],"helper"]]},P={XYZE:[[new De(new Ii(.25,10,8),n)]],X:[[new De(new Ds(.5,.1,4,24),n),[0,0,0],[0,-Math.PI/2,-Math.PI/2]]],Y:[[new De(new Ds(.5,.1,4,24),n),[0,0,0],[Math.PI/2,0,0]]],Z:[[new De(new Ds(.5,.1,4,24),n),[0,0,0],[0,0,-Math.PI/2]]],E:[[new De(new Ds(.75,.1,2,24),n)]]},D={X:[[new De(g,r),[.5,0,0],[0,0,-Math.PI/2]],[new De(_,r),[0,0,0],[0,0,-Math.PI/2]],[new De(g,r),[-.5,0,0],[0,0,Math.PI/2]]],Y:[[new De(g,o),[0,.5,0]],[new De(_,o)],[new De(g,o),[0,-.5,0],[0,0,Math.PI]]],Z:[[new De(g,a),[0,0,.5],[Math.PI/2,0,0]],[new De(_,a),[0,0,0],[Math.PI/2,0,0]],[new De(g,a),[0,0,-.5],[-Math.PI/2,0,0]]],XY:[[new De(new Vt(.15,.15,.01),h),[.15,.15,0]]],YZ:[[new De(new Vt(.15,.15,.01),l),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new De(new Vt(.15,.15,.01),c),[.15,0,.15],[-Math.PI/2,0,0]]],XYZ:[[new De(new Vt(.1,.1,.1),d)]]},z={X:[[new De(new Sn(.2,0,.6,4),n),[.3,0,0],[0,0,-Math.PI/2]],[new De(new Sn(.2,0,.6,4),n),[-.3,0,0],[0,0,Math.PI/2]]],Y:[[new De(new Sn(.2,0,.6,4),n),[0,.3,0]],[new De(new Sn(.2,0,.6,4),n),[0,-.3,0],[0,0,Math.PI]]],Z:[[new De(new Sn(.2,0,.6,4),n),[0,0,.3],[Math.PI/2,0,0]],[new De(new Sn(.2,0,.6,4),n),[0,0,-.3],[-Math.PI/2,0,0]]],XY:[[new De(new Vt(.2,.2,.01),n),[.15,.15,0]]],YZ:[[new De(new Vt(.2,.2,.01),n),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new De(new Vt(.2,.2,.01),n),[.15,0,.15],[-Math.PI/2,0,0]]],XYZ:[[new De(new Vt(.2,.2,.2),n),[0,0,0]]]},W={X:[[new oi(m,s),[-1e3,0,0],null,[1e6,1,1],"helper"]],Y:[[new oi(m,s),[0,-1e3,0],[0,0,Math.PI/2],[1e6,1,1],"helper"]],Z:[[new oi(m,s),[0,0,-1e3],[0,-Math.PI/2,0],[1e6,1,1],"helper"]]};function N(V){let Z=new Jt;for(let G in V)for(let ce=V[G].length;ce--;){let Y=V[G][ce][0].clone(),Q=V[G][ce][1],ie=V[G][ce][2],de=V[G][ce][3],fe=V[G][ce][4];Y.name=G,Y.tag=fe,Q&&Y.position.set(Q[0],Q[1],Q[2]),ie&&Y.rotation.set(ie[0],ie[1],ie[2]),de&&Y.scale.set(de[0],de[1],de[2]),Y.updateMatrix();let ee=Y.geometry.clone();ee.applyMatrix4(Y.matrix),Y.geometry=ee,Y.renderOrder=1/0,Y.position.set(0,0,0),Y.rotation.set(0,0,0),Y.scale.set(1,1,1),Z.add(Y)}return Z}this.gizmo={},this.picker={},this.helper={},this.add(this.gizmo.translate=N(C)),this.add(this.gizmo.rotate=N(E)),this.add(this.gizmo.scale=N(D)),this.add(this.picker.translate=N(S)),this.add(this.picker.rotate=N(P)),this.add(this.picker.scale=N(z)),this.add(this.helper.translate=N(x)),this.add(this.helper.rotate=N(O)),this.add(this.helper.scale=N(W)),this.picker.translate.visible=!1,this.picker.rotate.visible=!1,this.picker.scale.visible=!1}updateMatrixWorld(e){let n=(this.mode==="scale"?"local":this.space)==="local"?this.worldQuaternion:Su;this.gizmo.translate.visible=this.mode==="translate",this.gizmo.rotate.visible=this.mode==="rotate",this.gizmo.scale.visible=this.mode==="scale",this.helper.translate.visible=this.mode==="translate",this.helper.rotate.visible=this.mode==="rotate",this.helper.scale.visible=this.mode==="scale";let s=[];s=s.concat(this.picker[this.mode].children),s=s.concat(this.gizmo[this.mode].children),s=s.concat(this.helper[this.mode].children);for(let r=0;r<s.length;r++){let o=s[r];o.visible=!0,o.rotation.set(0,0,0),o.position.copy(this.worldPosition);let a;if(this.camera.isOrthographicCamera?a=(this.camera.top-this.camera.bottom)/this.camera.zoom:a=this.worldPosition.distanceTo(this.cameraPosition)*Math.min(1.9*Math.tan(Math.PI*this.camera.fov/360)/this.camera.zoom,7),o.scale.set(1,1,1).multiplyScalar(a*this.size/4),o.tag==="helper"){o.visible=!1,o.name==="AXIS"?(o.visible=!!this.axis,this.axis==="X"&&(nn.setFromEuler(vu.set(0,0,0)),o.quaternion.copy(n).multiply(nn),Math.abs(Ht.copy(Cl).applyQuaternion(n).dot(this.eye))>.9&&(o.visible=!1)),this.axis==="Y"&&(nn.setFromEuler(vu.set(0,0,Math.PI/2)),o.quaternion.copy(n).multiply(nn),Math.abs(Ht.copy(Wr).applyQuaternion(n).dot(this.eye))>.9&&(o.visible=!1)),this.axis==="Z"&&(nn.setFromEuler(vu.set(0,Math.PI/2,0)),o.quaternion.copy(n).multiply(nn),Math.abs(Ht.copy(Pl).applyQuaternion(n).dot(this.eye))>.9&&(o.visible=!1)),this.axis==="XYZE"&&(nn.setFromEuler(vu.set(0,Math.PI/2,0)),Ht.copy(this.rotationAxis),o.quaternion.setFromRotationMatrix(m_.lookAt(p_,Ht,Wr)),o.quaternion.multiply(nn),o.visible=this.dragging),this.axis==="E"&&(o.visible=!1)):o.name==="START"?(o.position.copy(this.worldPositionStart),o.visible=this.dragging):o.name==="END"?(o.position.copy(this.worldPosition),o.visible=this.dragging):o.name==="DELTA"?(o.position.copy(this.worldPositionStart),o.quaternion.copy(this.worldQuaternionStart),un.set(1e-10,1e-10,1e-10).add(this.worldPositionStart).sub(this.worldPosition).multiplyScalar(-1),un.applyQuaternion(this.worldQuaternionStart.clone().invert()),o.scale.copy(un),o.visible=this.dragging):(o.quaternion.copy(n),this.dragging?o.position.copy(this.worldPositionStart):o.position.copy(this.worldPosition),this.axis&&(o.visible=this.axis.search(o.name)!==-1));continue}o.quaternion.copy(n),this.mode==="translate"||this.mode==="scale"?(o.name==="X"&&Math.abs(Ht.copy(Cl).applyQuaternion(n).dot(this.eye))>.99&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="Y"&&Math.abs(Ht.copy(Wr).applyQuaternion(n).dot(this.eye))>.99&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="Z"&&Math.abs(Ht.copy(Pl).applyQuaternion(n).dot(this.eye))>.99&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="XY"&&Math.abs(Ht.copy(Pl).applyQuaternion(n).dot(this.eye))<.2&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="YZ"&&Math.abs(Ht.copy(Cl).applyQuaternion(n).dot(this.eye))<.2&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="XZ"&&Math.abs(Ht.copy(Wr).applyQuaternion(n).dot(this.eye))<.2&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1)):this.mode==="rotate"&&(bu.copy(n),Ht.copy(this.eye).applyQuaternion(nn.copy(n).invert()),o.name.search("E")!==-1&&o.quaternion.setFromRotationMatrix(m_.lookAt(this.eye,p_,Wr)),o.name==="X"&&(nn.setFromAxisAngle(Cl,Math.atan2(-Ht.y,Ht.z)),nn.multiplyQuaternions(bu,nn),o.quaternion.copy(nn)),o.name==="Y"&&(nn.setFromAxisAngle(Wr,Math.atan2(Ht.x,Ht.z)),nn.multiplyQuaternions(bu,nn),o.quaternion.copy(nn)),o.name==="Z"&&(nn.setFromAxisAngle(Pl,Math.atan2(Ht.y,Ht.x)),nn.multiplyQuaternions(bu,nn),o.quaternion.copy(nn))),o.visible=o.visible&&(o.name.indexOf("X")===-1||this.showX),o.visible=o.visible&&(o.name.indexOf("Y")===-1||this.showY),o.visible=o.visible&&(o.name.indexOf("Z")===-1||this.showZ),o.visible=o.visible&&(o.name.indexOf("E")===-1||this.showX&&this.showY&&this.showZ),o.visible=o.visible&&(o.name.indexOf("XY")===-1||this.showXY),o.visible=o.visible&&(o.name.indexOf("YZ")===-1||this.showYZ),o.visible=o.visible&&(o.name.indexOf("XZ")===-1||this.showXZ),o.visible=o.visible&&(o.name!=="E"||this.showE),o.visible=o.visible&&(o.name!=="XYZE"||this.showXYZE),o.material._color=o.material._color||o.material.color.clone(),o.material._opacity=o.material._opacity||o.material.opacity,o.material.color.copy(o.material._color),o.material.opacity=o.material._opacity,this.enabled&&this.axis&&(o.name===this.axis?(o.material.color.copy(this.materialLib.active.color),o.material.opacity=1):this.axis.split("").some(function(l){return o.name===l})&&(o.material.color.copy(this.materialLib.active.color),o.material.opacity=1))}super.updateMatrixWorld(e)}},_p=class extends De{constructor(){super(new Ls(1e5,1e5,2,2),new ri({visible:!1,wireframe:!0,side:li,transparent:!0,opacity:.1,toneMapped:!1})),this.isTransformControlsPlane=!0,this.type="TransformControlsPlane"}updateMatrixWorld(e){let t=this.space;switch(this.position.copy(this.worldPosition),this.mode==="scale"&&(t="local"),Mu.copy(Cl).applyQuaternion(t==="local"?this.worldQuaternion:Su),Al.copy(Wr).applyQuaternion(t==="local"?this.worldQuaternion:Su),Rl.copy(Pl).applyQuaternion(t==="local"?this.worldQuaternion:Su),Ht.copy(Al),this.mode){case"translate":case"scale":switch(this.axis){case"X":Ht.copy(this.eye).cross(Mu),ps.copy(Mu).cross(Ht);break;case"Y":Ht.copy(this.eye).cross(Al),ps.copy(Al).cross(Ht);break;case"Z":Ht.copy(this.eye).cross(Rl),ps.copy(Rl).cross(Ht);break;case"XY":ps.copy(Rl);break;case"YZ":ps.copy(Mu);break;case"XZ":Ht.copy(Rl),ps.copy(Al);break;case"XYZ":case"E":ps.set(0,0,0);break}break;default:ps.set(0,0,0)}ps.length()===0?this.quaternion.copy(this.cameraQuaternion):(Eu.lookAt(un.set(0,0,0),ps,Ht),this.quaternion.setFromRotationMatrix(Eu)),super.updateMatrixWorld(e)}};var ta=(i,e)=>{let t=new U().fromArray(e.position??[0,0,0]),n=b.stage?.pieces??[],s=h=>t.distanceTo(new U().fromArray(h))<1e-4,r=n.find(h=>h.kind===e.kind&&h.name===e.name)??n.find(h=>h.kind===e.kind&&s(h.position)),o=e.body===void 0||e.body===null?-1:b.stage?.bodies.indexOf(e.body)??-1,a=i.figure?.groups[o],l=a?a.quaternion.clone():new ht,c=a?a.position.clone():new U;return{turn:new ht().fromArray(r?.rotation??[0,0,0,1]),within:l,out:h=>h.clone().applyQuaternion(l).add(c),into:h=>h.clone().sub(c).applyQuaternion(l.clone().invert())}};var Il=i=>i.toArray().map(e=>Math.round(1e3*e)/1e3),Ll=({from:i,to:e})=>[i,e].map(t=>new U().fromArray(t)),Tu=i=>{if(i.kind==="step")return new U(i.x,i.y??0,i.height);if(i.position)return new U().fromArray(i.position);if(!i.from||!i.to)return;let[e,t]=Ll(i);return e.add(t).multiplyScalar(.5)},pT=(i,e)=>{let[t,n,s]=Il(e);if(i.kind==="step")return{x:t,y:n,height:Math.max(.02,s)};if(i.position)return{position:[t,n,s]};let r=e.clone().sub(Tu(i)),[o,a]=Ll(i);return{from:Il(o.add(r)),to:Il(a.add(r))}},mT=.02,g_=new U(0,0,1),x_=i=>{let{height:e=.2,length:t=3,width:n=2.4,radius:s=0}=i;if(i.kind==="step")return{sides:[t,n,e],middle:[t/2,0,-e/2]};if(i.kind==="box")return{sides:i.size,middle:[0,0,i.size[2]/2]};let[r,o]=i.from?Ll(i):[];return{sides:[2*s,2*s,i.kind==="sphere"?2*s:r?r.distanceTo(o):t],middle:[0,0,0]}},gT=(i,e,t)=>{let{sides:n}=x_(i),[s,r,o]=n.map((u,f)=>Math.max(mT,u*Math.abs(e.getComponent(f)))),a=u=>Math.round(1e3*u)/1e3;if(i.kind==="step")return Object.fromEntries([["length",s],["width",r],["height",o]].filter((u,f)=>e.getComponent(f)!==1));if(i.kind==="box"){let u=g_.clone().applyQuaternion(t).multiplyScalar((o-n[2])/2);return{size:[s,r,o].map(a),position:Il(Tu(i).add(u))}}let l=e.x===1?r:s;if(i.kind==="sphere")return{radius:a((l===n[0]?o:l)/2)};if(!i.from)return{radius:a(l/2),length:a(o)};let c=Tu(i),[h,d]=Ll(i).map(u=>Il(u.sub(c).multiplyScalar(o/n[2]).add(c)));return{radius:a(l/2),from:h,to:d}},Au=class{constructor(e){this.stage=e;this.controls=new wu(e.camera,e.canvas),this.controls.setSize(.7),e.extra.add(this.handle.add(this.frame),this.controls.getHelper()),this.controls.getHelper().visible=!1,this.controls.enabled=!1,this.controls.addEventListener("change",()=>e.draw()),this.controls.addEventListener("mouseDown",()=>this.start()),this.controls.addEventListener("mouseUp",()=>{this.end()}),this.controls.addEventListener("objectChange",()=>this.changed()),b.on(["joint","time","path","selection"],()=>this.place()),e.sights.push(()=>{e.canvas.dataset.gizmo=this.controls.axis?"on":"",this.held||this.place()})}stage;controls;handle=new Jt;begin=new ht;held=null;frame=new Va(new Ka(new Vt),new as({color:16757844,depthTest:!1,transparent:!0}));place(){let{figure:e}=this.stage,t=b.joint===null?this.obstacle():void 0,n=t&&Tu(t),s=t&&n&&ta(this.stage,t).out(n),r=b.stage?.joints.find(o=>o.name===b.joint);if(b.playing||!e||!(r??s)){this.hide();return}if(!this.held){if(this.frame.visible=!r&&b.resizes,r){let o=e.groups[r.body];this.handle.position.copy(this.stage.placeOf(r.body,r.anchor)),this.handle.quaternion.copy(o.quaternion),this.controls.setMode("rotate");let a=r.kind==="hinge"?r.axis.map(Math.abs):null,l=a?a.indexOf(Math.max(...a)):-1;this.controls.showX=!a||l===0,this.controls.showY=!a||l===1,this.controls.showZ=!a||l===2,this.controls.setSpace("local")}else if(s&&t){let{turn:o,within:a}=ta(this.stage,t),{sides:l,middle:c}=x_(t),h=t.from?Ll(t):null;h&&o.setFromUnitVectors(g_,h[1].sub(h[0]).normalize()),this.handle.position.copy(s),this.handle.scale.setScalar(1),this.handle.quaternion.identity(),b.resizes&&t.kind!=="step"&&this.handle.quaternion.copy(a).multiply(o),b.resizes&&t.kind==="box"&&this.handle.translateZ(-l[2]/2),this.frame.scale.fromArray(l),this.frame.position.fromArray(c),this.controls.setMode(b.resizes?"scale":"translate"),Object.assign(this.controls,{showX:!0,showY:!0,showZ:!0}),this.controls.setSpace("world")}this.controls.object!==this.handle&&this.controls.attach(this.handle),this.controls.enabled=!0}}hide(){let{held:e}=this;this.held=null,this.frame.visible=!1,e&&this.controls.pointerUp(null),this.controls.object&&(this.controls.detach(),this.controls.enabled=!1),e&&(this.stage.orbit.enabled=!0,this.stage.override=null,Pn("cancel"),this.stage.draw())}obstacle(){let{obstacle:e,document:t}=b;return t?.obstacles.find(n=>n.kind===e?.kind&&n.index===e?.index)}start(){this.held={obstacle:this.obstacle(),revision:b.document?.revision??0,time:b.time,waits:!1,again:!1},this.stage.orbit.enabled=!1,this.begin.copy(this.handle.quaternion)}changed(){let{held:e}=this;e?.obstacle&&b.resizes&&b.joint===null&&hn(this.entries(e.obstacle).map(([t,n])=>`${t} ${[n].flat().map(s=>Ms(s)).join(" ")} m`).join(", "),"note"),!(!e||b.joint===null)&&(e.again=!0,e.waits||this.turn(e))}turn(e){if(!e.again)return;let t=this.handle.quaternion.clone().multiply(this.begin.clone().invert());e.again=!1,e.waits=!0,Pn("turn",{time:e.time,joint:b.joint,turn:[t.w,t.x,t.y,t.z],locks:b.locked}).then(n=>{e.waits=!1,this.held===e&&(n.ok?this.stage.show(n):hn(n.words,"wrong"),this.turn(e))})}entries(e){let{turn:t,into:n}=ta(this.stage,e),s=b.resizes?gT(e,this.handle.scale,t):pT(e,n(this.handle.position));return Object.entries(s).filter(([r,o])=>String(o)!==String(e[r]))}async end(){let{held:e}=this;e&&(b.joint!==null&&this.turn(e),this.held=null,this.stage.orbit.enabled=!0,b.joint!==null?await(this.handle.quaternion.equals(this.begin)?Pn("cancel"):_l(e.time)):b.obstacle&&e.obstacle&&await Li(yl(b.obstacle),Object.fromEntries(this.entries(e.obstacle)),e.revision),this.held||(this.stage.override=null),this.stage.draw())}};var __=4,xT=.05,y_=6,_T=()=>{let i=re("canvas",{width:64,height:64}),e=i.getContext("2d"),t=new Path2D(br.lock);return e.scale(2.6,2.6),Object.assign(e,{fillStyle:"#ffb454",strokeStyle:"#14171c",lineWidth:3}),e.stroke(t),e.fill(t,"evenodd"),new qa(i)},yT=(i,e,t)=>{let{turn:n,out:s,within:r}=ta(i,e),{x:o=0,y:a=0,height:l=0,radius:c=0,length:h=e.kind==="step"?3:0,width:d=2.4}=e,u=m=>new U().fromArray(m??[0,0,0]);if(e.kind!=="box"&&e.kind!=="step"){let m=e.from&&e.to?[u(e.from),u(e.to)]:[-1,1].map(T=>new U(0,0,T*h/2).applyQuaternion(n).add(u(e.position))),_=new U;return t.distanceSqToSegment(s(m[0]),s(m[1]),_)<c**2?_:null}let f=e.kind==="step",p=f?new U(o+h/2,a,l/2):s(u(e.position)),v=new yt().compose(p,f?new ht:r.clone().multiply(n),new U(1,1,1)),g=new Ci().setFromCenterAndSize(new U,f?new U(h,d,l):u(e.size));return t.clone().applyMatrix4(v.clone().invert()).intersectBox(g,new U)?.applyMatrix4(v)??null},Ru=class{constructor(e){this.stage=e;let{canvas:t}=e;this.mark.visible=!1,this.mark.renderOrder=10,e.extra.add(this.mark,this.signs),e.sights.push(()=>this.showSigns()),t.addEventListener("pointermove",s=>this.move(s)),t.addEventListener("pointerdown",s=>this.down(s),!0),window.addEventListener("pointerup",s=>{this.up(s)}),t.addEventListener("pointerleave",()=>{this.held||this.light(null)});let n={x:NaN,y:NaN};t.addEventListener("pointerdown",({clientX:s,clientY:r})=>{n={x:s,y:r}}),t.addEventListener("pointerup",s=>{Math.hypot(s.clientX-n.x,s.clientY-n.y)>=__||t.dataset.gizmo==="on"||(s.button===0?this.choose(s):s.button===2&&this.offer(s))})}stage;held=null;mark=new De(new Ii(.022,16,12),new ri({color:16757844,depthTest:!1,transparent:!0,opacity:.95}));signs=new Yn;lockPaint=new Cr({map:_T(),depthTest:!1,sizeAttenuation:!1});jointPaint=new Cr({color:16757844,rotation:Math.PI/4,depthTest:!1,sizeAttenuation:!1});over=null;get busy(){return this.held!==null}async cancel(){this.held&&(this.held.ended=!0,this.held=null,this.stage.orbit.enabled=!0,await Pn("cancel"),this.held||(this.stage.override=null),this.stage.draw())}get chosen(){return b.stage?.joints.filter(({name:e})=>b.joints.includes(e))??[]}lock(e=this.over){let t=this.chosen.map(o=>o.body),s=(e===null||t.includes(e)?t:[e]).filter(o=>!b.stage.still[o]).map(o=>b.stage.bodies[o]);if(!s.length){hn("point at a body, or select a joint","note");return}let r=s.some(o=>!b.locks.has(o));for(let o of s)r?b.locks.add(o):b.locks.delete(o);hn(`${s.join(", ")}: ${r?"locked":"not locked any more"}`),this.stage.draw()}offer(e){let t=this.hit(e)?.body,n=b.stage?.bodies[t??-1];if(!n)return;let s=b.stage.soles.filter(l=>l.body===t),r=this.limbOf(t),a=[[b.locks.has(n)?"Unlock":"Lock",!0,()=>this.lock(t)],["Unlock all",b.locks.size>0,()=>{b.locks.clear(),this.stage.draw()}],["Flat on the ground",s.length>0,()=>{this.flatten(t)}],["Plant from here",s.length>0,()=>{this.plant(s)}],[`${r}: drag by joints (FK)`,r!==void 0&&!b.fk.has(r),()=>b.fk.add(r)],[`${r}: drag by its end (IK)`,r!==void 0&&b.fk.has(r),()=>b.fk.delete(r)]].filter(([,l])=>l);Jl(n,e,a.map(([l])=>l),l=>a.find(([c])=>c===l)?.[2]())}jointOf(e){let{joints:t,parents:n}=b.stage;return t.find(s=>s.body===e)??(e?this.jointOf(n[e]):void 0)}limbOf(e){let t=this.jointOf(e);return t&&b.stage.limbs.find(n=>n.joints.includes(t.name))?.name}async plant(e){this.toKey();let t=b.moment,n=b.document.keys.map(c=>c.time).filter(c=>c>t),s=String(Math.random()),r=c=>Br(b.now.at(c),e[0]),o=r(t),a=n.findIndex(c=>r(c).distanceTo(o)>xT),l=n[Math.max(a===-1?n.length-1:a-1,0)];if(l===void 0){hn("no keyframe follows, up to which the foot could stay","note");return}for(let{name:c}of e)await Vn("add",{at:["contact"],entries:{point:c,from:t,to:l}},s)}async flatten(e){this.toKey();let{time:t}=b,n=this.stage.placeOf(e,[0,0,0]).toArray();!(await Wt("grip",{time:t,body:e,offset:[0,0,0],locks:b.locked})).ok||!(await Pn("drag",{position:n})).ok||await _l(t,"this foot is not near the ground, or flat already")}toKey(){b.playing=!1;let e=b.document?.keys.find(t=>Math.abs(t.time-b.time)<.5/b.fps);e&&b.seek(e.time)}showSigns(){let{locked:e}=b,{chosen:t,stage:n}=this,s=e.map(o=>({body:o,offset:b.stage.sites.findLast(a=>a.body===o)?.offset??[0,0,0],paint:this.lockPaint,size:.03})),r=t.length<2?[]:t.map(({body:o,anchor:a})=>({body:o,offset:a,paint:this.jointPaint,size:.012}));this.signs.clear();for(let{body:o,offset:a,paint:l,size:c}of[...s,...r]){let h=new Ga(l);h.scale.setScalar(c),h.renderOrder=12,h.position.copy(n.placeOf(o,a)),this.signs.add(h)}}hit({clientX:e,clientY:t}){let{figure:n}=this.stage;if(!n||!n.root.visible)return null;for(let s of[0,y_/2,y_])for(let r=0;r<(s?8:1);r++){this.stage.through({clientX:e+s*Math.cos(r*Math.PI/4),clientY:t+s*Math.sin(r*Math.PI/4)});let o=this.stage.caster.intersectObject(n.root,!0)[0],a=o?.object??null;for(;a&&a.userData.body===void 0;)a=a.parent;if(a)return{body:a.userData.body,point:o.point}}return null}choose(e){if(e.shiftKey){b.choose(this.jointOf(this.hit(e)?.body??0)?.name??null,!0);return}let t=this.stage.through(e),n=r=>yT(this.stage,r,t)?.distanceTo(t.origin)??1/0,s=(b.document?.obstacles??[]).map(r=>({obstacle:r,far:n(r)})).filter(({far:r})=>r<1/0).sort((r,o)=>r.far-o.far)[0]?.obstacle;!s&&!b.obstacle&&b.joint===null||(b.pick(s??null),s&&Gr("scene"))}light(e,t){let n=e!==null,s=Pe("hover");this.over=e?.body??null,this.stage.canvas.style.cursor=n?"grab":"",(this.mark.visible!==n||n)&&this.stage.draw(),this.mark.visible=n,e&&this.mark.position.copy(e.point),s.hidden=!e||!t,!(!e||!t)&&(s.textContent=`${b.stage?.bodies[e.body]??""}${b.locked.includes(e.body)?", locked":""}`,s.style.transform=`translate(${t.offsetX+14}px, ${t.offsetY+10}px)`)}down(e){if(e.button!==0||e.shiftKey||this.stage.canvas.dataset.gizmo==="on")return;let t=this.hit(e);if(!t)return;e.stopImmediatePropagation(),this.stage.orbit.enabled=!1,this.stage.canvas.setPointerCapture(e.pointerId),this.toKey();let n=this.stage.figure.groups[t.body],s=t.point.clone().sub(n.position).applyQuaternion(n.quaternion.clone().invert()).toArray(),r=new ni().setFromNormalAndCoplanarPoint(this.stage.camera.getWorldDirection(new U),t.point),o=this.limbOf(t.body),a=o!==void 0&&b.fk.has(o)?this.jointOf(t.body):null;this.held={body:t.body,joint:a,begin:t.point.clone(),pivot:a?this.stage.placeOf(a.body,a.anchor):t.point,offset:s,plane:r,x:e.clientX,y:e.clientY,clientX:e.clientX,clientY:e.clientY,time:b.time,moved:!1,waits:!1,next:null,ended:!1},this.stage.canvas.style.cursor="grabbing",Pe("hover").hidden=!0}move(e){let{held:t}=this;if(!t){e.buttons===0&&this.light(this.hit(e),e);return}!t.moved&&Math.hypot(e.clientX-t.x,e.clientY-t.y)<__||(t.moved||(t.moved=!0,t.waits=!t.joint,t.joint||Pn("grip",{time:t.time,body:t.body,offset:t.offset,plant:!e.altKey,alone:b.partial&&b.here===null,locks:b.locked}).then(n=>this.answered(t,n.ok,n.words))),e.ctrlKey?t.plane.constant+=(e.clientY-t.y)*this.stage.perPixel(t.plane):(t.clientX+=e.clientX-t.x,t.clientY+=e.clientY-t.y),t.x=e.clientX,t.y=e.clientY,t.next=this.stage.through(t).intersectPlane(t.plane,new U),t.waits||this.pull(t))}answered(e,t,n=""){e.waits=!1,!t&&!e.ended&&(hn(n,"wrong"),e.ended=!0),this.held===e&&(t?this.pull(e):this.cancel())}turnOf({begin:e,pivot:t},n){let[s,r]=[e,n].map(h=>h.clone().sub(t).normalize()),{x:o,y:a,z:l,w:c}=new ht().setFromUnitVectors(s,r);return[c,o,a,l]}pull(e){if(!e.next)return;let t=e.next.toArray(),n=e.joint?Pn("turn",{time:e.time,joint:e.joint.name,turn:this.turnOf(e,e.next),locks:b.locked}):Pn("drag",{position:t});e.next=null,e.waits=!0,n.then(s=>{s.ok&&!e.ended&&(this.held===e||!this.held)&&(this.stage.show(s),this.stage.figure.put(this.stage.override),this.mark.visible=this.held===e,this.mark.position.copy(this.stage.placeOf(e.body,e.offset)),this.mark.material.color.set(s.missed>.005?16735324:16757844)),this.answered(e,s.ok,s.words)})}async up(e){let{held:t}=this;if(!(!t||e.button!==0)){if(this.held=null,this.stage.orbit.enabled=!0,this.stage.canvas.style.cursor="",this.mark.visible=!1,!t.moved){b.choose(this.jointOf(t.body)?.name??null);return}this.pull(t),await _l(t.time),t.ended=!0,this.held||(this.stage.override=null),this.stage.draw()}}};var Cu=i=>()=>Pe(i).click(),v_=(i,e)=>{let t=Pe(i);t.selectedIndex=(t.selectedIndex+1)%e,t.dispatchEvent(new Event("change"))},na=()=>b.keys.size?[...b.keys].sort((i,e)=>i-e):b.here===null?[]:[b.here],S_=i=>{let e=na(),t=e.map(n=>b.document.keys[n].time);e.length&&hr(e.map((n,s)=>[n,Math.round(i(t[s],t[0])*1e4)/1e4]),void 0,va(`keyframes ${e}`))},b_=i=>S_(e=>e+i/b.fps),M_=i=>{na().length>1&&S_((e,t)=>t+i*(e-t))},yp=(i,e,t)=>[["Space","play or pause",()=>uu(),"play"],["ArrowLeft","previous frame",()=>op(-1)],["ArrowRight","next frame",()=>op(1)],["PageUp","previous keyframe",()=>ap(-1),"previous"],["PageDown","next keyframe",()=>ap(1),"next"],["Home","first frame",()=>b.seek(b.played[0])],["End","last frame",()=>b.seek(b.played[1])],["Ctrl-Home","play from here; at the first frame: from the beginning",()=>b.setRange(0,b.time)],["Ctrl-End","play up to here; at the last frame: to the end",()=>b.setRange(1,b.time)],["L","loop",Cu("loop")],["F","camera follows the figure",Cu("follow")],...[...Pe("views").options].slice(0,-1).map(({value:n,text:s},r)=>[String(r+1),`view: ${s}`,()=>i.aim(n)]),["0","view: fit figure and obstacles",()=>{let n=Pe("views").value;i.aim(n==="free"?"quarter":n,!0)}],["B","before, both, side by side, after",()=>v_("which",4)],["H","onion skin: none, keyframes, every 5, every 10 frames",()=>v_("ghosts",4)],["T","motion paths",Cu("trails")],["C","curves",a_,"show-curves"],["U","limb rows on the timeline",()=>{e.unfolded=!e.unfolded,e.draw()}],["Z","show all of the timeline",()=>e.fit(),"fit"],["[","timeline: zoom out",()=>e.zoom(1.4),"zoom-out"],["]","timeline: zoom in",()=>e.zoom(.7),"zoom-in"],["K","insert a keyframe from the path",()=>{Vx()},"key"],["N","new keyframes: of one limb, or of the whole figure",Cu("partial")],["Delete","delete keyframes, a contact or grasp",()=>{Wx()},"bin"],["Alt-ArrowLeft","move the keyframe one frame earlier",()=>b_(-1)],["Alt-ArrowRight","move the keyframe one frame later",()=>b_(1)],["Alt-ArrowUp","spread selected keyframes by 10 %",()=>M_(1.1)],["Alt-ArrowDown","compress selected keyframes by 10 %",()=>M_(1/1.1)],["M","mirror keyframes",()=>{let n=na();n.length&&Wt("mirror",{keys:n})}],["Ctrl-A","select all keyframes",()=>b.select(b.document?.keys.keys()??[])],["Ctrl-C","copy keyframes",()=>lp(na())],["Ctrl-V","paste keyframes here, in place of those that are there",()=>{cp()}],["Ctrl-D","duplicate keyframes to here",()=>{na().length&&(lp(na()),cp())}],["Ctrl-Z","undo",()=>{Wt("undo")},"undo"],["Ctrl-Shift-Z","redo",()=>{Wt("redo")},"redo"],["Ctrl-S","save",()=>{Gx()},"save"],["G","stop or continue optimising",()=>{Wt("search",{go:!b.status.go})},"go"],...[["P","pose"],["O","problems"],["W","weights"],["S","scene"]].map(([n,s])=>[n,`panel: ${s}`,()=>{Gr(s),Pe(`tab-${s}`).focus()}]),["J","next joint, with rotation rings",()=>{let n=b.stage?.joints.map(s=>s.name)??[];b.choose(n[(n.indexOf(b.joint??"")+1)%n.length]??null)}],["R","arrows of an obstacle: move or resize it",()=>{b.resizes=!b.resizes,b.tell("joint")}],["X","lock or unlock the body at the pointer, or those of the selected joints",()=>t.lock()],["Escape","cancel a drag; deselect",()=>{if(t.busy){t.cancel();return}b.joint!==null||b.obstacle!==null?b.pick(null):b.select([])}],["?","this list",()=>bT(i,e,t),"help"]],vT=[["drag the figure","pose it: the limb bends, then the whole figure follows; planted soles stay (Alt: they may move; Ctrl: nearer or farther)"],["click the figure","select a joint and rotate it by its rings; Shift: select more, of which numbers, modes and locks change together"],["select an obstacle in the panel Scene","arrows move it, or resize it (R)"],["right button on the figure","lock a body: it stays where it is while others are posed; plant a foot; drag a limb by its joints (FK)"],["drag the background","orbit; right button or Shift: pan; wheel: zoom"],["drag the ends of the bar above the keyframes","playback range; double-click it to play all"],["drag a pose of the panel Pose","to a keyframe or another time on the timeline"],["drag a diamond","move keyframes; Shift or Ctrl: select more; Alt: do not snap"],["drag over a point's row","new contact; drag it or its ends; on a hand's row (select a joint of its arm): new grasp"],["Ctrl-wheel, Shift-wheel","zoom and move the timeline"]],bT=(i,e,t)=>{let n=o=>o.replace("Arrow","").replace("Left","←").replace("Right","→").replace("Up","↑").replace("Down","↓").replace("Page↑","PgUp").replace("Page↓","PgDn"),s=(o,a)=>re("div",{},re("kbd",{text:o}),re("span",{text:a})),r=re("dialog",{class:"help","aria-label":"keys"},re("h2",{text:"Keys"}),re("div",{class:"columns"},...yp(i,e,t).map(([o,a])=>s(n(o),a))),re("h2",{text:"Mouse"}),re("div",{class:"columns wide"},...vT.map(([o,a])=>s(o,a))),re("form",{method:"dialog"},re("div",{class:"buttons end"},re("button",{type:"submit",class:"main",text:"Close"}))));r.addEventListener("close",()=>r.remove()),document.body.append(r),r.showModal(),r.scrollTop=0},w_=(i,e,t)=>{let n=new Map(yp(i,e,t).map(([s,,r])=>[s,r]));for(let[s,r,o,a]of yp(i,e,t)){if(!a)continue;let l=Pe(a);Object.assign(l,{title:`${r} (${s})`,onclick:o}),l.textContent||l.setAttribute("aria-label",r),br[a]&&l.append(_a(a))}window.addEventListener("keydown",s=>{let r=s.target;if(document.querySelector("dialog[open]"))return;let o=r.matches("input[type=text], select, textarea"),a=r.matches("input[type=range]"),l=s.ctrlKey||s.metaKey;if(o&&!(l&&"zs".includes(s.key.toLowerCase()))&&s.key!=="Escape"||a&&s.key.startsWith("Arrow")||r.matches("button, summary, input[type=checkbox], [role=tab]")&&(s.key===" "||s.key==="Enter")||r.matches("[role=tab]")&&s.key.startsWith("Arrow"))return;let c=s.key===" "?"Space":s.key.length===1?s.key.toUpperCase():s.key==="Backspace"?"Delete":s.key,h=s.shiftKey&&l?"Shift-":"",d=`${l?"Ctrl-":""}${h}${s.altKey?"Alt-":""}${c}`,u=n.get(d==="Ctrl-Y"?"Ctrl-Shift-Z":d);u&&(l&&c==="C"&&String(getSelection())||(s.preventDefault(),u()))})};var E_={type:"change"},bp={type:"start"},A_={type:"end"},Pu=new Ps,T_=new ni,MT=Math.cos(70*$h.DEG2RAD),In=new U,hi=2*Math.PI,Ct={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},vp=1e-6,Iu=class extends Lr{constructor(e,t=null){super(e,t),this.state=Ct.NONE,this.target=new U,this.cursor=new U,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:sr.ROTATE,MIDDLE:sr.DOLLY,RIGHT:sr.PAN},this.touches={ONE:rr.ROTATE,TWO:rr.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new U,this._lastQuaternion=new ht,this._lastTargetPosition=new U,this._quat=new ht().setFromUnitVectors(e.up,new U(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new Wo,this._sphericalDelta=new Wo,this._scale=1,this._panOffset=new U,this._rotateStart=new We,this._rotateEnd=new We,this._rotateDelta=new We,this._panStart=new We,this._panEnd=new We,this._panDelta=new We,this._dollyStart=new We,this._dollyEnd=new We,this._dollyDelta=new We,this._dollyDirection=new U,this._mouse=new We,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=wT.bind(this),this._onPointerDown=ST.bind(this),this._onPointerUp=ET.bind(this),this._onContextMenu=LT.bind(this),this._onMouseWheel=RT.bind(this),this._onKeyDown=CT.bind(this),this._onTouchStart=PT.bind(this),this._onTouchMove=IT.bind(this),this._onMouseDown=TT.bind(this),this._onMouseMove=AT.bind(this),this._interceptControlDown=DT.bind(this),this._interceptControlUp=NT.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(e){this._cursorStyle=e,e==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Ct.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(E_),this.update(),this.state=Ct.NONE}pan(e,t){this._pan(e,t),this.update()}dollyIn(e){this._dollyIn(e),this.update()}dollyOut(e){this._dollyOut(e),this.update()}rotateLeft(e){this._rotateLeft(e),this.update()}rotateUp(e){this._rotateUp(e),this.update()}update(e=null){let t=this.object.position;In.copy(t).sub(this.target),In.applyQuaternion(this._quat),this._spherical.setFromVector3(In),this.autoRotate&&this.state===Ct.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(n)&&isFinite(s)&&(n<-Math.PI?n+=hi:n>Math.PI&&(n-=hi),s<-Math.PI?s+=hi:s>Math.PI&&(s-=hi),n<=s?this._spherical.theta=Math.max(n,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+s)/2?Math.max(n,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(In.setFromSpherical(this._spherical),In.applyQuaternion(this._quatInverse),t.copy(this.target).add(In),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=In.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new U(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new U(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=In.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(Pu.origin.copy(this.object.position),Pu.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Pu.direction))<MT?this.object.lookAt(this.target):(T_.setFromNormalAndCoplanarPoint(this.object.up,this.target),Pu.intersectPlane(T_,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>vp||8*(1-this._lastQuaternion.dot(this.object.quaternion))>vp||this._lastTargetPosition.distanceToSquared(this.target)>vp?(this.dispatchEvent(E_),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?hi/60*this.autoRotateSpeed*e:hi/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){In.setFromMatrixColumn(t,0),In.multiplyScalar(-e),this._panOffset.add(In)}_panUp(e,t){this.screenSpacePanning===!0?In.setFromMatrixColumn(t,1):(In.setFromMatrixColumn(t,0),In.crossVectors(this.object.up,In)),In.multiplyScalar(e),this._panOffset.add(In)}_pan(e,t){let n=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;In.copy(s).sub(this.target);let r=In.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*r/n.clientHeight,this.object.matrix),this._panUp(2*t*r/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),s=e-n.left,r=t-n.top,o=n.width,a=n.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientY),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(hi*this._rotateDelta.x/t.clientHeight),this._rotateUp(hi*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(hi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-hi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(hi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-hi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(n,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(n,s)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(n*n+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let n=this._getSecondPointerPosition(e),s=.5*(e.pageX+n.x),r=.5*(e.pageY+n.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(hi*this._rotateDelta.x/t.clientHeight),this._rotateUp(hi*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(n,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(n*n+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(e.pageX+t.x)*.5,a=(e.pageY+t.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new We,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,n={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function ST(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function wT(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function ET(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(A_),this.state=Ct.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function TT(i){let e;switch(i.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case sr.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=Ct.DOLLY;break;case sr.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Ct.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Ct.ROTATE}break;case sr.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Ct.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Ct.PAN}break;default:this.state=Ct.NONE}this.state!==Ct.NONE&&this.dispatchEvent(bp)}function AT(i){switch(this.state){case Ct.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case Ct.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case Ct.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function RT(i){this.enabled===!1||this.enableZoom===!1||this.state!==Ct.NONE||(i.preventDefault(),this.dispatchEvent(bp),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(A_))}function CT(i){this.enabled!==!1&&this._handleKeyDown(i)}function PT(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case rr.ROTATE:if(this.enableRotate===!1){this.state=Ct.NONE;break}this._handleTouchStartRotate(i),this.state=Ct.TOUCH_ROTATE;break;case rr.PAN:if(this.enablePan===!1){this.state=Ct.NONE;break}this._handleTouchStartPan(i),this.state=Ct.TOUCH_PAN;break;default:this.state=Ct.NONE}break;case 2:switch(this.touches.TWO){case rr.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=Ct.TOUCH_DOLLY_PAN;break;case rr.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=Ct.TOUCH_DOLLY_ROTATE;break;default:this.state=Ct.NONE}break;default:this.state=Ct.NONE}this.state!==Ct.NONE&&this.dispatchEvent(bp)}function IT(i){switch(this._trackPointer(i),this.state){case Ct.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case Ct.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case Ct.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case Ct.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=Ct.NONE}}function LT(i){this.enabled!==!1&&i.preventDefault()}function DT(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function NT(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var Mp={haze:[.9,.915,.93],zenith:[.6,.69,.78],ground:12168090,sky:16054527,bright:1},Sp={haze:[.17,.185,.21],zenith:[.07,.08,.1],ground:9274488,sky:14674165,bright:.78},P_=i=>{let e={alpha:!1,antialias:!1,stencil:!1,powerPreference:"high-performance"},t=a=>{let l=a.getExtension("WEBGL_debug_renderer_info");return/swiftshader|llvmpipe|softpipe|software|basic render/i.test(String(a.getParameter(l?l.UNMASKED_RENDERER_WEBGL:a.RENDERER)))},n=i,s=i.getContext("webgl2",e);if(!s)throw new Error("no WebGL 2");let r=t(s);r||(n=i.cloneNode(),i.replaceWith(n),s.getExtension("WEBGL_lose_context")?.loseContext(),s=n.getContext("webgl2",{...e,antialias:!0}));let o=new Qh({canvas:n,context:s});return o.debug.checkShaderErrors=!1,r||o.setPixelRatio(Math.min(window.devicePixelRatio,2)),o.shadowMap.enabled=!0,o.shadowMap.type=r?sf:Dr,o.toneMapping=il,{canvas:n,renderer:o,software:r}},R_=new U(2.6,-3.2,5.2),C_=new U(-2,3,2.5),Lu=class{scene=new ka;sun=new Go(16774370,2.3);sky=new el(16054527,12168090,1.9);fill=new Go(14674431,.5);dome;constructor(e,t=Mp,n=!1){this.dome=new Ii(150+20*e,32,24).rotateX(Math.PI/2),this.dome.setAttribute("color",new jt(new Float32Array(this.dome.attributes.position.count*3),3));let s={vertexColors:!0,side:Gn,fog:!1,toneMapped:!1},r=new De(this.dome,new ri(s));r.renderOrder=1,this.scene.add(r),this.scene.fog=new Fa(0,4+2*e,22+6*e);let{sun:o}=this;o.castShadow=!0,o.shadow.mapSize.setScalar(n?1024:2048),Object.assign(o.shadow,{bias:-4e-4,normalBias:.012,radius:2.5}),Object.assign(o.shadow.camera,{left:-2.6,right:2.6,top:2.6,bottom:-2.6,near:.5,far:16}),this.fill.position.copy(C_),this.scene.add(this.sky,o,o.target,this.fill),this.light(t)}light(e){let t=new Je().setRGB(...e.haze,Mn),n=new Je().setRGB(...e.zenith,Mn);this.scene.background=t,this.scene.fog.color.copy(t),this.sun.intensity=2.3*(.4+.6*e.bright),this.sky.intensity=1.9*e.bright,this.sky.color.set(e.sky),this.sky.groundColor.set(e.ground);let s=this.dome.attributes.position,r=this.dome.attributes.color,o=new Je;for(let a=0;a<s.count;a++){let l=Math.max(0,s.getZ(a))/this.dome.parameters.radius;o.copy(t).lerp(n,Math.min(1,1.3*l)).toArray(r.array,3*a)}r.needsUpdate=!0}follow(e){this.sun.target.position.copy(e),this.sun.position.copy(e).add(R_)}set shadows(e){this.sun.castShadow=e}onGround(){let e=(r,o)=>r.color.clone().multiplyScalar(r.intensity*o.z/o.length()),{sky:t}=this,n=.5+.5*t.position.clone().normalize().z;return t.groundColor.clone().lerp(t.color,n).multiplyScalar(t.intensity).add(e(this.fill,C_)).add(e(this.sun,R_)).multiplyScalar(1/Math.PI)}};var wp={quarter:[.62,-1,.32],side:[0,-1,.08],left:[0,1,.08],front:[1,0,.08],back:[-1,0,.08],top:[-.001,0,1]};var I_=14,L_=45,UT=18,OT=30,Ep=220,FT=900,kT=90,BT=130,Du=[.4,.55,.75,1],zT=240,HT=80,GT=.75,VT=1.12,WT=.05,D_="dynsplines-view",XT=1.4,Nu=class{drawing=P_(Pe("view"));canvas=this.drawing.canvas;software=this.drawing.software;renderer=this.drawing.renderer;around=new Lu(4,Sp,this.software);camera=new ii(32,1,.03,900);orbit;extra=new Yn;caster=new Ir;figure=null;override=null;sights=[];images=0;shapes=null;still=null;sides={};ghosts=[];wanted=!0;isAwake=!1;step=this.software?1:Du.length-1;quick=0;drawnAt=Du[this.step];box=[0,0];stamp=0;moved=0;then=null;centre=new U;aimed=!1;fitted=0;constructor(){let{camera:e}=this;e.up.set(0,0,1),this.orbit=new Iu(e,this.canvas),Object.assign(this.orbit,{enableDamping:!0,dampingFactor:.15,minDistance:.25,maxDistance:90,maxPolarAngle:.97*Math.PI}),this.orbit.addEventListener("change",()=>{this.nameView(),this.draw()}),window.addEventListener("pagehide",()=>{sessionStorage[D_]=JSON.stringify({at:location.search,time:b.time,range:b.range.map(String),camera:e.position.toArray(),locks:[...b.locks],fk:[...b.fk],target:this.orbit.target.toArray()})}),this.around.scene.add(this.extra),this.caster.layers.enable(Kf),b.on("stage",()=>this.build()),b.on("path",()=>this.arrived()),b.on(["time","which","selection","document","joint"],()=>this.draw()),b.on("loaded",()=>this.haunt()),b.on("shown",()=>this.haunt()),b.on("theme",()=>{this.around.light(document.documentElement.dataset.theme==="light"?Mp:Sp),this.draw()}),new ResizeObserver(()=>this.resize()).observe(this.canvas.parentElement),this.resize(),this.wake()}draw(){this.wanted=!0,this.wake()}wake(){this.isAwake||requestAnimationFrame(this.tick),this.isAwake=!0}aim(e,t=!1){let{orbit:n,camera:s,figure:r,still:o}=this,a=new Ci,l=s.position.distanceTo(n.target);b.now?.bodies===r?.groups.length&&r.put(b.now.at(b.time));for(let f of r?.groups??[])a.expandByObject(f);for(let f of t?o?.groups??[]:[])for(let p of f.children)o.planes.some(v=>v.mesh===p)||a.expandByObject(p);this.centre.copy(this.middle()),a.isEmpty()?n.target.copy(this.centre):a.getCenter(n.target);let c=Math.max(.3,a.getSize(new U).length()/2),h=Math.min(1,s.aspect),d=VT*c/Math.sin(Math.atan(h*Math.tan(s.fov*Math.PI/360))),u=!t&&this.fitted>0&&Math.abs(l-this.fitted)>.001*l;u||(this.fitted=d),s.position.copy(n.target).addScaledVector(new U(...wp[e]).normalize(),u?l:d),this.nameView(),this.draw()}nameView(){let e=this.camera.position.clone().sub(this.orbit.target).normalize(),t=Object.entries(wp).find(([,n])=>e.dot(new U(...n).normalize())>1-1e-5);Pe("views").value=t?.[0]??"free"}restored(){let e=JSON.parse(sessionStorage[D_]??"null");if(e?.at!==location.search)return!1;b.seek(e.time),b.range=e.range.map(Number),b.tell("range");for(let t of e.locks)b.locks.add(t);for(let t of e.fk)b.fk.add(t);return this.centre.copy(this.middle()),this.orbit.target.fromArray(e.target),this.camera.position.fromArray(e.camera),this.fitted=1/0,!0}perPixel(e){let{camera:t,canvas:n}=this;return 2*Math.abs(e.distanceToPoint(t.position))*Math.tan(t.fov*Math.PI/360)/n.clientHeight}through({clientX:e,clientY:t}){let n=this.canvas.getBoundingClientRect();return this.caster.setFromCamera(new We((e-n.left)/n.width*2-1,1-(t-n.top)/n.height*2),this.camera),this.caster.ray}show(e){this.override={position:e.position,rotation:e.rotation},this.draw()}placeOf(e,t){let n=this.figure.groups[e];return new U().fromArray(t).applyQuaternion(n.quaternion).add(n.position)}build(){let{stage:e}=b;if(!e)return;for(let r of[this.figure,this.still,...Object.values(this.sides).map(o=>o.figure),...this.ghosts])r?.dispose();this.shapes?.dispose();let t=this.shapes=new nu(e,this.software?1:this.renderer.capabilities.getMaxAnisotropy(),()=>this.draw(),this.software?Sx:Zf),n=e.pieces.filter(r=>!r.still),s=this.software?zT:0;this.still=new lr(e.bodies,e.pieces.filter(r=>r.still),t),this.figure=new lr(e.bodies,n,t,void 0,s),this.sides={before:{figure:new lr(e.bodies,n,t,iu(14706239,.42),s),path:()=>b.raw},snapshot:{figure:new lr(e.bodies,n,t,iu(5218272,.45),s),path:()=>b.snapshot}},this.ghosts=[],this.around.scene.add(this.still.root,this.figure.root,...Object.values(this.sides).map(r=>r.figure.root)),this.haunt()}haunt(){for(let s of this.ghosts)b.ghosts?s.root.visible=!1:s.dispose();b.ghosts||(this.ghosts=[]);let{stage:e,document:t,now:n}=b;if(b.ghosts&&e&&this.shapes&&t&&n){let s=Number(b.ghosts)/b.fps,r=b.ghosts==="keys"?t.keys.map(({time:l})=>l):Array.from({length:Math.floor((n.last-n.first)/s+1e-6)+1},(l,c)=>n.first+c*s),o=Math.ceil(r.length/(this.software?I_/2:I_)),a=e.pieces.filter(l=>!l.still);r.filter((l,c)=>c%o===0).forEach((l,c)=>{this.ghosts[c]||(this.ghosts[c]=new lr(e.bodies,a,this.shapes,iu(9417945,.2,.08),this.software?HT:0),this.around.scene.add(this.ghosts[c].root)),this.ghosts[c].root.visible=!0,this.ghosts[c].put(n.at(l))})}this.draw()}arrived(){b.now&&b.stage&&!this.aimed&&(this.aimed=!0,this.restored()||this.aim("quarter")),this.haunt()}pose(){let{now:e}=b;return this.override??(e?.bodies===this.figure?.groups.length?e.at(b.time):null)}middle(){let{now:e}=b;if(!e)return new U(0,0,.8);let[t,n,s]=e.centreAt(b.time);return new U(t,n,s)}tick=e=>{this.isAwake=!1;let t=this.advance(e);this.stamp=e,(t||b.playing||this.wanted||this.drawnAt<this.finest||e-this.moved<Ep)&&this.wake()};advance(e){if(b.playing){if(this.then!==null){let c=e-this.then,h=b.time+Math.min(250,c)/1e3*b.speed,[d,u]=b.played;h>u&&!b.loop?(b.playing=!1,b.seek(u)):b.seek(h>u?d+(h-d)%Math.max(.001,u-d):h)}this.then=b.playing?e:null}else this.then=null;let{orbit:t,camera:n}=this,s=(WT-t.target.z)/n.position.distanceTo(t.target);this.still?.planes.length&&(t.maxPolarAngle=Math.acos(Math.min(Math.max(s,-1),1)));let r=t.update(),o=this.software&&(b.status.state==="searching"||b.status.state==="loaded"||Ix()),a=this.software&&b.status.state==="loading",l=o&&(!this.override||Lx())&&e-Math.max(this.moved,tp)<(b.playing?kT:BT);return!this.figure||!(b.now||this.override)||l||(this.wanted?(this.pace(e),this.render(Du[this.step]),this.moved=e):this.drawnAt<this.finest&&e-this.moved>(o||a?FT:Ep)&&this.render(this.finest)),r}get finest(){return this.software?XT:1}pace(e){let t=e-this.stamp;e-this.moved>Ep||(this.quick=t<UT?this.quick+1:0,t>L_?this.step=Math.max(0,this.step-(t>2.5*L_?2:1)):this.quick>=OT&&(this.quick=0,this.step=Math.min(Du.length-1,this.step+1)))}simplified(e){let{still:t,around:n}=this;if(!this.software||!t)return;n.shadows=!e;let s=n.onGround();for(let{mesh:r,part:o}of t.planes)o.plain.color.copy(o.plain.userData.own).multiply(s),r.material=e?o.plain:o.material}render(e){this.wanted=!1,this.take(e);let t=this.pose();if(this.figure&&t){this.figure.isRough=this.software&&e<=GT,this.figure.put(t),this.still?.put(t),this.figure.root.visible=b.which!=="before"||this.override!==null;for(let[o,a]of Object.entries(this.sides)){let l=a.path(),c=o==="before"?b.which==="before"||b.which==="both":b.which==="snapshot";a.figure.root.visible=c&&l!==null&&l.bodies===a.figure.groups.length,a.figure.root.visible&&a.figure.put(l.at(b.time))}}let n=this.middle();if(b.follow&&!this.override&&b.stage?.joints.some(({kind:o})=>o==="free")){let o=n.clone().sub(this.centre);this.camera.position.add(o),this.orbit.target.add(o)}this.centre.copy(n),this.around.follow(n);for(let o of this.sights)o();this.simplified(e<this.finest);let{renderer:s}=this,r=this.around.scene;b.which==="side"?this.renderHalves(...s.getSize(new We).toArray()):s.render(r,this.camera),this.images+=1}renderHalves(e,t){let{renderer:n,camera:s}=this,r=Math.floor(e/2);n.setScissorTest(!0),s.aspect=r/t,s.updateProjectionMatrix();let o=this.sides.before?.figure,a=this.figure;for(let[l,c]of[[0,!0],[r,!1]])n.setViewport(l,0,r,t),n.setScissor(l,0,r,t),c&&o&&a&&b.raw?a.put(b.raw.at(b.time)):a&&b.now&&a.put(b.now.at(b.time)),n.render(this.around.scene,s);n.setScissorTest(!1),n.setViewport(0,0,e,t),s.aspect=e/t,s.updateProjectionMatrix()}take(e){e!==this.drawnAt&&(this.drawnAt=e,this.sized())}sized(){let[e,t]=this.box,n=this.drawnAt*(this.software?1:Math.min(window.devicePixelRatio,2));e&&t&&this.renderer.setDrawingBufferSize(e,t,n)}resize(){let e=this.canvas.parentElement.getBoundingClientRect();!e.width||!e.height||e.width===this.box[0]&&e.height===this.box[1]||(this.box=[e.width,e.height],this.sized(),this.camera.aspect=e.width/e.height,this.camera.updateProjectionMatrix(),this.draw())}};var N_=[7128319,16753756,9167499,16748467,13215999,16769162,8380628],qT=16119285,Uu=class{constructor(e){this.stage=e;e.extra.add(this.lines),b.on(["path","shown","stage","document"],()=>this.draw())}stage;lines=new Yn;ends(){let{stage:e}=b;if(!e)return[];let t=n=>e.sites.filter(s=>s.body===n).at(-1);return e.limbs.filter(n=>n.name!=="root and trunk").map(n=>t(n.end)??e.soles.find(s=>s.body===n.end)??{name:n.name,body:n.end,offset:[0,0,0]})}draw(){for(let n of[...this.lines.children])n.removeFromParent(),n.geometry.dispose(),n.material.dispose();let{now:e,stage:t}=b;b.trails&&e&&t&&e.bodies===t.bodies.length&&(this.ends().forEach((n,s)=>this.line(this.places(e,n),N_[s%N_.length])),this.line(Array.from({length:e.count},(n,s)=>new U().fromArray(e.centre,3*s)),qT)),this.stage.draw()}places(e,t){return Array.from({length:e.count},(n,s)=>Br(e,t,s*e.bodies))}line(e,t){let n=new as({color:t,transparent:!0,opacity:.85});this.lines.add(new oi(new Lt().setFromPoints(e),n));let{now:s,document:r}=b;if(!s||!r)return;let o=r.keys.map(l=>e[Math.min(e.length-1,Math.max(0,Math.round((l.time-s.first)*s.rate)))]),a=new Ho({color:t,size:5,sizeAttenuation:!1});this.lines.add(new Wa(new Lt().setFromPoints(o),a))}};var U_=()=>{let i=localStorage.getItem("dynsplines-theme")??"dark";document.documentElement.dataset.theme=i};U_();vl();try{let i=new Nu,e=new Au(i),t=new Ru(i),n=new mu;new Uu(i),n_(),c_(n),Hx(),w_(i,n,t),Xx(i),Pe("files").prepend(_a("menu")),Pe("theme").append(_a("theme")),Pe("theme").addEventListener("click",()=>{localStorage.setItem("dynsplines-theme",document.documentElement.dataset.theme==="light"?"dark":"light"),U_(),b.tell("theme")}),b.on("stage",()=>{Pe("waiting").hidden=!0}),b.on("status",()=>{!b.stage&&b.status.words&&(Pe("waiting").textContent=b.status.words,Pe("waiting").hidden=!1)}),b.tell("theme"),Object.assign(window,{studio:{ask:Pn,pending:Jo,model:b,stage:i,hands:t,gizmo:e,timeline:n,dots:yu,onPlot:_u}})}catch(i){Pe("waiting").replaceChildren(re("p",{text:`This browser cannot draw in three dimensions: WebGL 2 is missing or switched off. (${i})`}))}
