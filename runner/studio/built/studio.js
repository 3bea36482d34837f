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
var k_="uplot",z_="u-hz",H_="u-vt",G_="u-title",V_="u-wrap",W_="u-under",X_="u-over",q_="u-axis",mr="u-off",Y_="u-select",Z_="u-cursor-x",$_="u-cursor-y",K_="u-cursor-pt",J_="u-legend",j_="u-live",Q_="u-inline",ex="u-series",tx="u-marker",dp="u-label",nx="u-value",na="width",ia="height";var fp="bottom",$r="left",fu="right",Pu="#000",pp=Pu+"0",pu="mousemove",mp="mousedown",mu="mouseup",gp="mouseenter",_p="mouseleave",xp="dblclick",ix="resize",sx="scroll",yp="change",gl="dppxchange",Iu="--",no=typeof window<"u",vu=no?document:null,Jr=no?window:null,rx=no?navigator:null,Ct,dl;function bu(){let i=devicePixelRatio;Ct!=i&&(Ct=i,dl&&Su(yp,dl,bu),dl=matchMedia(`(min-resolution: ${Ct-.001}dppx) and (max-resolution: ${Ct+.001}dppx)`),gr(yp,dl,bu),Jr.dispatchEvent(new CustomEvent(gl)))}function mi(i,e){if(e!=null){let t=i.classList;!t.contains(e)&&t.add(e)}}function Mu(i,e){let t=i.classList;t.contains(e)&&t.remove(e)}function Kt(i,e,t){i.style[e]=t+"px"}function Di(i,e,t,n){let s=vu.createElement(i);return e!=null&&mi(s,e),t?.insertBefore(s,n),s}function wi(i,e){return Di("div",i,e)}var vp=new WeakMap;function ts(i,e,t,n,s){let r="translate("+e+"px,"+t+"px)",o=vp.get(i);r!=o&&(i.style.transform=r,vp.set(i,r),e<0||t<0||e>n||t>s?mi(i,mr):Mu(i,mr))}var bp=new WeakMap;function Mp(i,e,t){let n=e+t,s=bp.get(i);n!=s&&(bp.set(i,n),i.style.background=e,i.style.borderColor=t)}var Sp=new WeakMap;function wp(i,e,t,n){let s=e+""+t,r=Sp.get(i);s!=r&&(Sp.set(i,s),i.style.height=t+"px",i.style.width=e+"px",i.style.marginLeft=n?-e/2+"px":0,i.style.marginTop=n?-t/2+"px":0)}var Lu={passive:!0},ox={...Lu,capture:!0};function gr(i,e,t,n){e.addEventListener(i,t,n?ox:Lu)}function Su(i,e,t,n){e.removeEventListener(i,t,Lu)}no&&bu();function Ni(i,e,t,n){let s;t=t||0,n=n||e.length-1;let r=n<=2147483647;for(;n-t>1;)s=r?t+n>>1:gi((t+n)/2),e[s]<i?t=s:n=s;return i-e[t]<=e[n]-i?t:n}function jp(i){return(t,n,s)=>{let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(t[a])){r=a;break}for(let a=s;a>=n;a--)if(i(t[a])){o=a;break}return[r,o]}}var Qp=i=>i!=null,em=i=>i!=null&&i>0,yl=jp(Qp),ax=jp(em);function lx(i,e,t,n=0,s=!1){let r=s?ax:yl,o=s?em:Qp;[e,t]=r(i,e,t);let a=i[e],l=i[e];if(e>-1)if(n==1)a=i[e],l=i[t];else if(n==-1)a=i[t],l=i[e];else for(let c=e;c<=t;c++){let h=i[c];o(h)&&(h<a?a=h:h>l&&(l=h))}return[a??zt,l??-zt]}function vl(i,e,t,n){let s=Ap(i),r=Ap(e);i==e&&(s==-1?(i*=t,e/=t):(i/=t,e*=t));let o=t==10?ms:tm,a=s==1?gi:Ei,l=r==1?Ei:gi,c=a(o(An(i))),h=l(o(An(e))),u=jr(t,c),d=jr(t,h);return t==10&&(c<0&&(u=Ht(u,-c)),h<0&&(d=Ht(d,-h))),n||t==2?(i=u*s,e=d*r):(i=rm(i,u),e=bl(e,d)),[i,e]}function Du(i,e,t,n){let s=vl(i,e,t,n);return i==0&&(s[0]=0),e==0&&(s[1]=0),s}var Nu=.1,Ep={mode:3,pad:Nu},ra={pad:0,soft:null,mode:0},cx={min:ra,max:ra};function _l(i,e,t,n){return Ml(t)?Tp(i,e,t):(ra.pad=t,ra.soft=n?0:null,ra.mode=n?3:0,Tp(i,e,cx))}function At(i,e){return i??e}function hx(i,e,t){for(e=At(e,0),t=At(t,i.length-1);e<=t;){if(i[e]!=null)return!0;e++}return!1}function Tp(i,e,t){let n=t.min,s=t.max,r=At(n.pad,0),o=At(s.pad,0),a=At(n.hard,-zt),l=At(s.hard,zt),c=At(n.soft,zt),h=At(s.soft,-zt),u=At(n.mode,0),d=At(s.mode,0),f=e-i,p=ms(f),v=ii(An(i),An(e)),g=ms(v),m=An(g-p);(f<1e-24||m>10)&&(f=0,(i==0||e==0)&&(f=1e-24,u==2&&c!=zt&&(r=0),d==2&&h!=-zt&&(o=0)));let _=f||v||1e3,E=ms(_),b=jr(10,gi(E)),C=_*(f==0?i==0?.1:1:r),M=Ht(rm(i-C,b/10),24),x=i>=c&&(u==1||u==3&&M<=c||u==2&&M>=c)?c:zt,w=ii(a,M<x&&i>=x?x:Ui(x,M)),O=_*(f==0?e==0?.1:1:o),P=Ht(bl(e+O,b/10),24),D=e<=h&&(d==1||d==3&&P>=h||d==2&&P<=h)?h:-zt,z=Ui(l,P>D&&e<=D?D:ii(D,P));return w==z&&w==0&&(z=100),[w,z]}var ux=new Intl.NumberFormat(no?rx.language:"en-US"),Uu=i=>ux.format(i),_i=Math,ml=_i.PI,An=_i.abs,gi=_i.floor,Tn=_i.round,Ei=_i.ceil,Ui=_i.min,ii=_i.max,jr=_i.pow,Ap=_i.sign,ms=_i.log10,tm=_i.log2,dx=(i,e=1)=>_i.sinh(i)*e,gu=(i,e=1)=>_i.asinh(i/e),zt=1/0;function Rp(i){return(ms((i^i>>31)-(i>>31))|0)+1}function wu(i,e,t){return Ui(ii(i,e),t)}function nm(i){return typeof i=="function"}function bt(i){return nm(i)?i:()=>i}var fx=()=>{},im=i=>i,sm=(i,e)=>e,px=i=>null,Cp=i=>!0,Pp=(i,e)=>i==e,mx=/\.\d*?(?=9{6,}|0{6,})/gm,_r=i=>{if(am(i)||Vs.has(i))return i;let e=`${i}`,t=e.match(mx);if(t==null)return i;let n=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${_r(s)}e${r}`}return Ht(i,n)};function fr(i,e){return _r(Ht(_r(i/e))*e)}function bl(i,e){return _r(Ei(_r(i/e))*e)}function rm(i,e){return _r(gi(_r(i/e))*e)}function Ht(i,e=0){if(am(i))return i;let t=10**e,n=i*t*(1+Number.EPSILON);return Tn(n)/t}var Vs=new Map;function om(i){return((""+i).split(".")[1]||"").length}function aa(i,e,t,n){let s=[],r=n.map(om);for(let o=e;o<t;o++){let a=An(o),l=Ht(jr(i,o),a);for(let c=0;c<n.length;c++){let h=i==10?+`${n[c]}e${o}`:n[c]*l,u=(o>=0?0:a)+(o>=r[c]?0:r[c]),d=i==10?h:Ht(h,u);s.push(d),Vs.set(d,u)}}return s}var oa={},Fu=[],Qr=[null,null],Gs=Array.isArray,am=Number.isInteger,gx=i=>i===void 0;function Ip(i){return typeof i=="string"}function Ml(i){let e=!1;if(i!=null){let t=i.constructor;e=t==null||t==Object}return e}function _x(i){return i!=null&&typeof i=="object"}var xx=Object.getPrototypeOf(Uint8Array),lm="__proto__";function eo(i,e=Ml){let t;if(Gs(i)){let n=i.find(s=>s!=null);if(Gs(n)||e(n)){t=Array(i.length);for(let s=0;s<i.length;s++)t[s]=eo(i[s],e)}else t=i.slice()}else if(i instanceof xx)t=i.slice();else if(e(i)){t={};for(let n in i)n!=lm&&(t[n]=eo(i[n],e))}else t=i;return t}function bn(i){let e=arguments;for(let t=1;t<e.length;t++){let n=e[t];for(let s in n)s!=lm&&(Ml(i[s])?bn(i[s],eo(n[s])):i[s]=eo(n[s]))}return i}var yx=0,vx=1,bx=2;function Mx(i,e,t){for(let n=0,s,r=-1;n<e.length;n++){let o=e[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<t&&i[s]==null;)i[r=s++]=null}}}function Sx(i,e){if(Tx(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return Ax(o[0])||(o=Ex(o)),o}let t=new Set;for(let o=0;o<i.length;o++){let l=i[o][0],c=l.length;for(let h=0;h<c;h++)t.add(l[h])}let n=[Array.from(t).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],l=a[0];for(let c=1;c<a.length;c++){let h=a[c],u=Array(s).fill(void 0),d=e?e[o][c]:vx,f=[];for(let p=0;p<h.length;p++){let v=h[p],g=r.get(l[p]);v===null?d!=yx&&(u[g]=v,d==bx&&f.push(g)):u[g]=v}Mx(u,f,s),n.push(u)}}return n}var wx=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function Ex(i){let e=i[0],t=e.length,n=Array(t);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[n[l]];s.push(a)}return s}function Tx(i){let e=i[0][0],t=e.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function Ax(i,e=100){let t=i.length;if(t<=1)return!0;let n=0,s=t-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=ii(1,gi((s-n+1)/e));for(let o=i[n],a=n+r;a<=s;a+=r){let l=i[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var cm=["January","February","March","April","May","June","July","August","September","October","November","December"],hm=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function um(i){return i.slice(0,3)}var Rx=hm.map(um),Cx=cm.map(um),Px={MMMM:cm,MMM:Cx,WWWW:hm,WWW:Rx};function ta(i){return(i<10?"0":"")+i}function Ix(i){return(i<10?"00":i<100?"0":"")+i}var Lx={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,e)=>e.MMMM[i.getMonth()],MMM:(i,e)=>e.MMM[i.getMonth()],MM:i=>ta(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>ta(i.getDate()),D:i=>i.getDate(),WWWW:(i,e)=>e.WWWW[i.getDay()],WWW:(i,e)=>e.WWW[i.getDay()],HH:i=>ta(i.getHours()),H:i=>i.getHours(),h:i=>{let e=i.getHours();return e==0?12:e>12?e-12:e},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>ta(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>ta(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>Ix(i.getMilliseconds())};function Ou(i,e){e=e||Px;let t=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)t.push(s[0][0]=="{"?Lx[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var Dx=new Intl.DateTimeFormat().resolvedOptions().timeZone;function Nx(i,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+i+i.getTimezoneOffset()*6e4):e==Dx?t=i:(t=new Date(i.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(i.getMilliseconds())),t}var dm=i=>i%1==0,xl=[1,2,2.5,5],Ux=aa(10,-32,0,xl),fm=aa(10,0,32,xl),Fx=fm.filter(dm),pr=Ux.concat(fm),Bu=`
`,pm="{YYYY}",Lp=Bu+pm,mm="{M}/{D}",sa=Bu+mm,fl=sa+"/{YY}",gm="{aa}",Ox="{h}:{mm}",Kr=Ox+gm,Dp=Bu+Kr,Np=":{ss}",Lt=null;function _m(i){let e=i*1e3,t=e*60,n=t*60,s=n*24,r=s*30,o=s*365,l=(i==1?aa(10,0,3,xl).filter(dm):aa(10,-3,0,xl)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,pm,Lt,Lt,Lt,Lt,Lt,Lt,1],[s*28,"{MMM}",Lp,Lt,Lt,Lt,Lt,Lt,1],[s,mm,Lp,Lt,Lt,Lt,Lt,Lt,1],[n,"{h}"+gm,fl,Lt,sa,Lt,Lt,Lt,1],[t,Kr,fl,Lt,sa,Lt,Lt,Lt,1],[e,Np,fl+" "+Kr,Lt,sa+" "+Kr,Lt,Dp,Lt,1],[i,Np+".{fff}",fl+" "+Kr,Lt,sa+" "+Kr,Lt,Dp,Lt,1]];function h(u){return(d,f,p,v,g,m)=>{let _=[],E=g>=o,b=g>=r&&g<o,C=u(p),M=Ht(C*i,3),x=_u(C.getFullYear(),E?0:C.getMonth(),b||E?1:C.getDate()),w=Ht(x*i,3);if(b||E){let O=b?g/r:0,P=E?g/o:0,D=M==w?M:Ht(_u(x.getFullYear()+P,x.getMonth()+O,1)*i,3),z=new Date(Tn(D/i)),W=z.getFullYear(),N=z.getMonth();for(let V=0;D<=v;V++){let Z=_u(W+P*V,N+O*V,1),G=Z-u(Ht(Z*i,3));D=Ht((+Z+G)*i,3),D<=v&&_.push(D)}}else{let O=g>=s?s:g,P=gi(p)-gi(M),D=w+P+bl(M-w,O);_.push(D);let z=u(D),W=z.getHours()+z.getMinutes()/t+z.getSeconds()/n,N=g/n,V=d.axes[f]._space,Z=m/V;for(;D=Ht(D+g,i==1?0:3),!(D>v);)if(N>1){let G=gi(Ht(W+N,6))%24,Q=u(D).getHours()-G;Q>1&&(Q=-1),D-=Q*n,W=(W+N)%24;let ie=_[_.length-1];Ht((D-ie)/g,3)*Z>=.7&&_.push(D)}else _.push(D)}return _}}return[l,c,h]}var[Bx,kx,zx]=_m(1),[Hx,Gx,Vx]=_m(.001);aa(2,-53,53,[1]);function Up(i,e){return i.map(t=>t.map((n,s)=>s==0||s==8||n==null?n:e(s==1||t[8]==0?n:t[1]+n)))}function Fp(i,e){return(t,n,s,r,o)=>{let a=e.find(p=>o>=p[0])||e[e.length-1],l,c,h,u,d,f;return n.map(p=>{let v=i(p),g=v.getFullYear(),m=v.getMonth(),_=v.getDate(),E=v.getHours(),b=v.getMinutes(),C=v.getSeconds(),M=g!=l&&a[2]||m!=c&&a[3]||_!=h&&a[4]||E!=u&&a[5]||b!=d&&a[6]||C!=f&&a[7]||a[1];return l=g,c=m,h=_,u=E,d=b,f=C,M(v)})}}function Wx(i,e){let t=Ou(e);return(n,s,r,o,a)=>s.map(l=>t(i(l)))}function _u(i,e,t){return new Date(i,e,t)}function Op(i,e){return e(i)}var Xx="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Bp(i,e){return(t,n,s,r)=>r==null?Iu:e(i(n))}function qx(i,e){let t=i.series[e];return t.width?t.stroke(i,e):t.points.width?t.points.stroke(i,e):null}function Yx(i,e){return i.series[e].fill(i,e)}var Zx={show:!0,live:!0,isolate:!1,mount:fx,markers:{show:!0,width:2,stroke:qx,fill:Yx,dash:"solid"},idx:null,idxs:null,values:[]};function $x(i,e){let t=i.cursor.points,n=wi(),s=t.size(i,e);Kt(n,na,s),Kt(n,ia,s);let r=s/-2;Kt(n,"marginLeft",r),Kt(n,"marginTop",r);let o=t.width(i,e,s);return o&&Kt(n,"borderWidth",o),n}function Kx(i,e){let t=i.series[e].points;return t._fill||t._stroke}function Jx(i,e){let t=i.series[e].points;return t._stroke||t._fill}function jx(i,e){return i.series[e].points.size}var xu=[0,0];function Qx(i,e,t){return xu[0]=e,xu[1]=t,xu}function pl(i,e,t,n=!0){return s=>{s.button==0&&(!n||s.target==e)&&t(s)}}function yu(i,e,t,n=!0){return s=>{(!n||s.target==e)&&t(s)}}var ey={show:!0,x:!0,y:!0,lock:!1,move:Qx,points:{one:!1,show:$x,size:jx,width:0,stroke:Jx,fill:Kx},bind:{mousedown:pl,mouseup:pl,click:pl,dblclick:pl,mousemove:yu,mouseleave:yu,mouseenter:yu},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,e,t,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},xm={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},ku=bn({},xm,{filter:sm}),ym=bn({},ku,{size:10}),vm=bn({},xm,{show:!1}),zu='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',bm="bold "+zu,Mm=1.5,kp={show:!0,scale:"x",stroke:Pu,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:bm,side:2,grid:ku,ticks:ym,border:vm,font:zu,lineGap:Mm,rotate:0},ty="Value",ny="Time",zp={show:!0,scale:"x",auto:!1,sorted:1,min:zt,max:-zt,idxs:[]};function iy(i,e,t,n,s){return e.map(r=>r==null?"":Uu(r))}function sy(i,e,t,n,s,r,o){let a=[],l=Vs.get(s)||0;t=o?t:Ht(bl(t,s),l);for(let c=t;c<=n;c=Ht(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Eu(i,e,t,n,s,r,o){let a=[],l=i.scales[i.axes[e].scale].log,c=l==10?ms:tm,h=gi(c(t));s=jr(l,h),l==10&&(s=pr[Ni(s,pr)]);let u=t,d=s*l;l==10&&(d=pr[Ni(d,pr)]);do a.push(u),u=u+s,l==10&&!Vs.has(u)&&(u=Ht(u,Vs.get(s))),u>=d&&(s=u,d=s*l,l==10&&(d=pr[Ni(d,pr)]));while(u<=n);return a}function ry(i,e,t,n,s,r,o){let l=i.scales[i.axes[e].scale].asinh,c=n>l?Eu(i,e,ii(l,t),n,s):[l],h=n>=0&&t<=0?[0]:[];return(t<-l?Eu(i,e,ii(l,-n),-t,s):[l]).reverse().map(d=>-d).concat(h,c)}var Sm=/./,oy=/[12357]/,ay=/[125]/,Hp=/1/,Tu=(i,e,t,n)=>i.map((s,r)=>e==4&&s==0||r%n==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function ly(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=i.scales[o],l=i.valToPos,c=r._space,h=l(10,o),u=l(9,o)-h>=c?Sm:l(7,o)-h>=c?oy:l(5,o)-h>=c?ay:Hp;if(u==Hp){let d=An(l(1,o)-h);if(d<c)return Tu(e.slice().reverse(),a.distr,u,Ei(c/d)).reverse()}return Tu(e,a.distr,u,1)}function cy(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=r._space,l=i.valToPos,c=An(l(1,o)-l(2,o));return c<a?Tu(e.slice().reverse(),3,Sm,Ei(a/c)).reverse():e}function hy(i,e,t,n){return n==null?Iu:e==null?"":Uu(e)}var Gp={show:!0,scale:"y",stroke:Pu,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:bm,side:3,grid:ku,ticks:ym,border:vm,font:zu,lineGap:Mm,rotate:0};function uy(i,e){let t=3+(i||1)*2;return Ht(t*e,3)}function dy(i,e){let{scale:t,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],t,!0),o=i.valToPos(s[n[1]],t,!0),a=An(o-r),l=i.series[e],c=a/(l.points.space*Ct);return n[1]-n[0]<=c}var Vp={scale:null,auto:!0,sorted:0,min:zt,max:-zt},wm=(i,e,t,n,s)=>s,Wp={show:!0,auto:!0,sorted:0,gaps:wm,alpha:1,facets:[bn({},Vp,{scale:"x"}),bn({},Vp,{scale:"y"})]},Xp={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:wm,alpha:1,points:{show:dy,filter:null},values:null,min:zt,max:-zt,idxs:[],path:null,clip:null};function fy(i,e,t,n,s){return t/10}var Em={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},py=bn({},Em,{time:!1,ori:1}),qp={};function Tm(i,e){let t=qp[i];return t||(t={key:i,plots:[],sub(n){t.plots.push(n)},unsub(n){t.plots=t.plots.filter(s=>s!=n)},pub(n,s,r,o,a,l,c){for(let h=0;h<t.plots.length;h++)t.plots[h]!=s&&t.plots[h].pub(n,s,r,o,a,l,c)}},i!=null&&(qp[i]=t)),t}var to=1,Au=2;function xr(i,e,t){let n=i.mode,s=i.series[e],r=n==2?i._data[e]:i._data,o=i.scales,a=i.bbox,l=r[0],c=n==2?r[1]:r[e],h=n==2?o[s.facets[0].scale]:o[i.series[0].scale],u=n==2?o[s.facets[1].scale]:o[s.scale],d=a.left,f=a.top,p=a.width,v=a.height,g=i.valToPosH,m=i.valToPosV;return h.ori==0?t(s,l,c,h,u,g,m,d,f,p,v,wl,io,Tl,Rm,Pm):t(s,l,c,h,u,m,g,f,d,v,p,El,so,Vu,Cm,Im)}function Hu(i,e){let t=0,n=0,s=At(i.bands,Fu);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?n|=1:n|=2)}return[t,n==1?-1:n==2?1:n==3?2:0]}function my(i,e,t,n,s){let r=i.mode,o=i.series[e],a=r==2?o.facets[1].scale:o.scale,l=i.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function gs(i,e,t,n,s,r){return xr(i,e,(o,a,l,c,h,u,d,f,p,v,g)=>{let m=o.pxRound,_=c.dir*(c.ori==0?1:-1),E=c.ori==0?io:so,b,C;_==1?(b=t,C=n):(b=n,C=t);let M=m(u(a[b],c,v,f)),x=m(d(l[b],h,g,p)),w=m(u(a[C],c,v,f)),O=m(d(r==1?h.max:h.min,h,g,p)),P=new Path2D(s);return E(P,w,O),E(P,M,O),E(P,M,x),P})}function Sl(i,e,t,n,s,r){let o=null;if(i.length>0){o=new Path2D;let a=e==0?Tl:Vu,l=t;for(let u=0;u<i.length;u++){let d=i[u];if(d[1]>d[0]){let f=d[0]-l;f>0&&a(o,l,n,f,n+r),l=d[1]}}let c=t+s-l,h=10;c>0&&a(o,l,n-h/2,c,n+r+h)}return o}function gy(i,e,t){let n=i[i.length-1];n&&n[0]==e?n[1]=t:i.push([e,t])}function Gu(i,e,t,n,s,r,o){let a=[],l=i.length;for(let c=s==1?t:n;c>=t&&c<=n;c+=s)if(e[c]===null){let u=c,d=c;if(s==1)for(;++c<=n&&e[c]===null;)d=c;else for(;--c>=t&&e[c]===null;)d=c;let f=r(i[u]),p=d==u?f:r(i[d]),v=u-s;f=o<=0&&v>=0&&v<l?r(i[v]):f;let m=d+s;p=o>=0&&m>=0&&m<l?r(i[m]):p,p>=f&&a.push([f,p])}return a}function Yp(i){return i==0?im:i==1?Tn:e=>fr(e,i)}function Am(i){let e=i==0?wl:El,t=i==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},n=i==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,h=0)=>{c==0&&h==0?n(s,r,o,a,l):(c=Ui(c,a/2,l/2),h=Ui(h,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,h),t(s,r,o+l,r,o,h),t(s,r,o,r+a,o,c),s.closePath())}}var wl=(i,e,t)=>{i.moveTo(e,t)},El=(i,e,t)=>{i.moveTo(t,e)},io=(i,e,t)=>{i.lineTo(e,t)},so=(i,e,t)=>{i.lineTo(t,e)},Tl=Am(0),Vu=Am(1),Rm=(i,e,t,n,s,r)=>{i.arc(e,t,n,s,r)},Cm=(i,e,t,n,s,r)=>{i.arc(t,e,n,s,r)},Pm=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(e,t,n,s,r,o)},Im=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(t,e,s,n,o,r)};function Lm(i){return(e,t,n,s,r)=>xr(e,t,(o,a,l,c,h,u,d,f,p,v,g)=>{let{pxRound:m,points:_}=o,E,b;c.ori==0?(E=wl,b=Rm):(E=El,b=Cm);let C=Ht(_.width*Ct,3),M=(_.size-_.width)/2*Ct,x=Ht(M*2,3),w=new Path2D,O=new Path2D,{left:P,top:D,width:z,height:W}=e.bbox;Tl(O,P-x,D-x,z+x*2,W+x*2);let N=V=>{if(l[V]!=null){let Z=m(u(a[V],c,v,f)),G=m(d(l[V],h,g,p));E(w,Z+M,G),b(w,Z,G,M,0,ml*2)}};if(r)r.forEach(N);else for(let V=n;V<=s;V++)N(V);return{stroke:C>0?w:null,fill:w,clip:O,flags:to|Au}})}function Dm(i){return(e,t,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(e,t,n),r!=s&&o!=s&&i(e,t,s),i(e,t,o))}}var _y=Dm(io),xy=Dm(so);function Nm(i){let e=At(i?.alignGaps,0);return(t,n,s,r)=>xr(t,n,(o,a,l,c,h,u,d,f,p,v,g)=>{[s,r]=yl(l,s,r);let m=o.pxRound,_=W=>m(u(W,c,v,f)),E=W=>m(d(W,h,g,p)),b,C;c.ori==0?(b=io,C=_y):(b=so,C=xy);let M=c.dir*(c.ori==0?1:-1),x={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:to},w=x.stroke,O=!1;if(r-s>=v*4){let W=fe=>t.posToVal(fe,c.key,!0),N=null,V=null,Z,G,ce,Y=_(a[M==1?s:r]),Q=_(a[s]),ie=_(a[r]),de=W(M==1?Q+1:ie-1);for(let fe=M==1?s:r;fe>=s&&fe<=r;fe+=M){let ee=a[fe],ye=(M==1?ee<de:ee>de)?Y:_(ee),Pe=l[fe];ye==Y?Pe!=null?(G=Pe,N==null?(b(w,ye,E(G)),Z=N=V=G):G<N?N=G:G>V&&(V=G)):Pe===null&&(O=!0):(N!=null&&C(w,Y,E(N),E(V),E(Z),E(G)),Pe!=null?(G=Pe,b(w,ye,E(G)),N=V=Z=G):(N=V=null,Pe===null&&(O=!0)),Y=ye,de=W(Y+M))}N!=null&&N!=V&&ce!=Y&&C(w,Y,E(N),E(V),E(Z),E(G))}else for(let W=M==1?s:r;W>=s&&W<=r;W+=M){let N=l[W];N===null?O=!0:N!=null&&b(w,_(a[W]),E(N))}let[D,z]=Hu(t,n);if(o.fill!=null||D!=0){let W=x.fill=new Path2D(w),N=o.fillTo(t,n,o.min,o.max,D),V=E(N),Z=_(a[s]),G=_(a[r]);M==-1&&([G,Z]=[Z,G]),b(W,G,V),b(W,Z,V)}if(!o.spanGaps){let W=[];O&&W.push(...Gu(a,l,s,r,M,_,e)),x.gaps=W=o.gaps(t,n,s,r,W),x.clip=Sl(W,c.ori,f,p,v,g)}return z!=0&&(x.band=z==2?[gs(t,n,s,r,w,-1),gs(t,n,s,r,w,1)]:gs(t,n,s,r,w,z)),x})}function yy(i){let e=At(i.align,1),t=At(i.ascDesc,!1),n=At(i.alignGaps,0),s=At(i.extend,!1);return(r,o,a,l)=>xr(r,o,(c,h,u,d,f,p,v,g,m,_,E)=>{[a,l]=yl(u,a,l);let b=c.pxRound,{left:C,width:M}=r.bbox,x=Q=>b(p(Q,d,_,g)),w=Q=>b(v(Q,f,E,m)),O=d.ori==0?io:so,P={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:to},D=P.stroke,z=d.dir*(d.ori==0?1:-1),W=w(u[z==1?a:l]),N=x(h[z==1?a:l]),V=N,Z=N;s&&e==-1&&(Z=C,O(D,Z,W)),O(D,N,W);for(let Q=z==1?a:l;Q>=a&&Q<=l;Q+=z){let ie=u[Q];if(ie==null)continue;let de=x(h[Q]),fe=w(ie);e==1?O(D,de,W):O(D,V,fe),O(D,de,fe),W=fe,V=de}let G=V;s&&e==1&&(G=C+M,O(D,G,W));let[ce,Y]=Hu(r,o);if(c.fill!=null||ce!=0){let Q=P.fill=new Path2D(D),ie=c.fillTo(r,o,c.min,c.max,ce),de=w(ie);O(Q,G,de),O(Q,Z,de)}if(!c.spanGaps){let Q=[];Q.push(...Gu(h,u,a,l,z,x,n));let ie=c.width*Ct/2,de=t||e==1?ie:-ie,fe=t||e==-1?-ie:ie;Q.forEach(ee=>{ee[0]+=de,ee[1]+=fe}),P.gaps=Q=c.gaps(r,o,a,l,Q),P.clip=Sl(Q,d.ori,g,m,_,E)}return Y!=0&&(P.band=Y==2?[gs(r,o,a,l,D,-1),gs(r,o,a,l,D,1)]:gs(r,o,a,l,D,Y)),P})}function Zp(i,e,t,n,s,r,o=zt){if(i.length>1){let a=null;for(let l=0,c=1/0;l<i.length;l++)if(e[l]!==void 0){if(a!=null){let h=An(i[l]-i[a]);h<c&&(c=h,o=An(t(i[l],n,s,r)-t(i[a],n,s,r)))}a=l}}return o}function vy(i){i=i||oa;let e=At(i.size,[.6,zt,1]),t=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=bt(s),o=1-e[0],a=At(e[1],zt),l=At(e[2],1),c=At(i.disp,oa),h=At(i.each,f=>{}),{fill:u,stroke:d}=c;return(f,p,v,g)=>xr(f,p,(m,_,E,b,C,M,x,w,O,P,D)=>{let z=m.pxRound,W=t,N=n*Ct,V=a*Ct,Z=l*Ct,G,ce;b.ori==0?[G,ce]=r(f,p):[ce,G]=r(f,p);let Y=b.dir*(b.ori==0?1:-1),Q=b.ori==0?Tl:Vu,ie=b.ori==0?h:(Le,Je,lt,Ee,kt,Ve,$e)=>{h(Le,Je,lt,kt,Ee,$e,Ve)},de=At(f.bands,Fu).find(Le=>Le.series[0]==p),fe=de!=null?de.dir:0,ee=m.fillTo(f,p,m.min,m.max,fe),ge=z(x(ee,C,D,O)),ye,Pe,we,Ye=P,at=z(m.width*Ct),Xe=!1,pt=null,ut=null,rt=null,jt=null;u!=null&&(at==0||d!=null)&&(Xe=!0,pt=u.values(f,p,v,g),ut=new Map,new Set(pt).forEach(Le=>{Le!=null&&ut.set(Le,new Path2D)}),at>0&&(rt=d.values(f,p,v,g),jt=new Map,new Set(rt).forEach(Le=>{Le!=null&&jt.set(Le,new Path2D)})));let{x0:Wt,size:mn}=c;if(Wt!=null&&mn!=null){W=1,_=Wt.values(f,p,v,g),Wt.unit==2&&(_=_.map(lt=>f.posToVal(w+lt*P,b.key,!0)));let Le=mn.values(f,p,v,g);mn.unit==2?Pe=Le[0]*P:Pe=M(Le[0],b,P,w)-M(0,b,P,w),Ye=Zp(_,E,M,b,P,w,Ye),we=Ye-Pe+N}else Ye=Zp(_,E,M,b,P,w,Ye),we=Ye*o+N,Pe=Ye-we;we<1&&(we=0),at>=Pe/2&&(at=0),we<5&&(z=im);let Ot=we>0,Ln=Ye-we-(Ot?at:0);Pe=z(wu(Ln,Z,V)),ye=(W==0?Pe/2:W==Y?0:Pe)-W*Y*((W==0?N/2:0)+(Ot?at/2:0));let St={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},wn=Xe?null:new Path2D,rn=null;if(de!=null)rn=f.data[de.series[1]];else{let{y0:Le,y1:Je}=c;Le!=null&&Je!=null&&(E=Je.values(f,p,v,g),rn=Le.values(f,p,v,g))}let gn=G*Pe,k=ce*Pe;for(let Le=Y==1?v:g;Le>=v&&Le<=g;Le+=Y){let Je=E[Le];if(Je==null)continue;if(rn!=null){let q=rn[Le]??0;if(Je-q==0)continue;ge=x(q,C,D,O)}let lt=b.distr!=2||c!=null?_[Le]:Le,Ee=M(lt,b,P,w),kt=x(At(Je,ee),C,D,O),Ve=z(Ee-ye),$e=z(ii(kt,ge)),I=z(Ui(kt,ge)),S=$e-I;if(Je!=null){let q=Je<0?k:gn,ue=Je<0?gn:k;Xe?(at>0&&rt[Le]!=null&&Q(jt.get(rt[Le]),Ve,I+gi(at/2),Pe,ii(0,S-at),q,ue),pt[Le]!=null&&Q(ut.get(pt[Le]),Ve,I+gi(at/2),Pe,ii(0,S-at),q,ue)):Q(wn,Ve,I+gi(at/2),Pe,ii(0,S-at),q,ue),ie(f,p,Le,Ve-at/2,I,Pe+at,S)}}return at>0?St.stroke=Xe?jt:wn:Xe||(St._fill=m.width==0?m._fill:m._stroke??m._fill,St.width=0),St.fill=Xe?ut:wn,St})}function by(i,e){let t=At(e?.alignGaps,0);return(n,s,r,o)=>xr(n,s,(a,l,c,h,u,d,f,p,v,g,m)=>{[r,o]=yl(c,r,o);let _=a.pxRound,E=G=>_(d(G,h,g,p)),b=G=>_(f(G,u,m,v)),C,M,x;h.ori==0?(C=wl,x=io,M=Pm):(C=El,x=so,M=Im);let w=h.dir*(h.ori==0?1:-1),O=E(l[w==1?r:o]),P=O,D=[],z=[];for(let G=w==1?r:o;G>=r&&G<=o;G+=w)if(c[G]!=null){let Y=l[G],Q=E(Y);D.push(P=Q),z.push(b(c[G]))}let W={stroke:i(D,z,C,x,M,_),fill:null,clip:null,band:null,gaps:null,flags:to},N=W.stroke,[V,Z]=Hu(n,s);if(a.fill!=null||V!=0){let G=W.fill=new Path2D(N),ce=a.fillTo(n,s,a.min,a.max,V),Y=b(ce);x(G,P,Y),x(G,O,Y)}if(!a.spanGaps){let G=[];G.push(...Gu(l,c,r,o,w,E,t)),W.gaps=G=a.gaps(n,s,r,o,G),W.clip=Sl(G,h.ori,p,v,g,m)}return Z!=0&&(W.band=Z==2?[gs(n,s,r,o,N,-1),gs(n,s,r,o,N,1)]:gs(n,s,r,o,N,Z)),W})}function My(i){return by(Sy,i)}function Sy(i,e,t,n,s,r){let o=i.length;if(o<2)return null;let a=new Path2D;if(t(a,i[0],e[0]),o==2)n(a,i[1],e[1]);else{let l=Array(o),c=Array(o-1),h=Array(o-1),u=Array(o-1);for(let d=0;d<o-1;d++)h[d]=e[d+1]-e[d],u[d]=i[d+1]-i[d],c[d]=h[d]/u[d];l[0]=c[0];for(let d=1;d<o-1;d++)c[d]===0||c[d-1]===0||c[d-1]>0!=c[d]>0?l[d]=0:(l[d]=3*(u[d-1]+u[d])/((2*u[d]+u[d-1])/c[d-1]+(u[d]+2*u[d-1])/c[d]),isFinite(l[d])||(l[d]=0));l[o-1]=c[o-2];for(let d=0;d<o-1;d++)s(a,i[d]+u[d]/3,e[d]+l[d]*u[d]/3,i[d+1]-u[d]/3,e[d+1]-l[d+1]*u[d]/3,i[d+1],e[d+1])}return a}var Ru=new Set;function $p(){for(let i of Ru)i.syncRect(!0)}no&&(gr(ix,Jr,$p),gr(sx,Jr,$p,!0),gr(gl,Jr,()=>{zn.pxRatio=Ct}));var wy=Nm(),Ey=Lm();function Kp(i,e,t,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>Cu(r,o,e,t))}function Ty(i,e){return i.map((t,n)=>n==0?{}:bn({},e,t))}function Cu(i,e,t,n){return bn({},e==0?t:n,i)}function Um(i,e,t){return e==null?Qr:[e,t]}var Ay=Um;function Ry(i,e,t){return e==null?Qr:_l(e,t,Nu,!0)}function Fm(i,e,t,n){return e==null?Qr:vl(e,t,i.scales[n].log,!1)}var Cy=Fm;function Om(i,e,t,n){return e==null?Qr:Du(e,t,i.scales[n].log,!1)}var Py=Om;function Iy(i,e,t,n,s){let r=ii(Rp(i),Rp(e)),o=e-i,a=Ni(s/n*o,t);do{let l=t[a],c=n*l/o;if(c>=s&&r+(l<5?Vs.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function Jp(i){let e,t;return i=i.replace(/(\d+)px/,(n,s)=>(e=Tn((t=+s)*Ct))+"px"),[i,e,t]}function Ly(i){i.show&&[i.font,i.labelFont].forEach(e=>{let t=Ht(e[2]*Ct,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function zn(i,e,t){let n={mode:At(i.mode,1)},s=n.mode;function r(y,T,L,U){let X=T.valToPct(y);return U+L*(T.dir==-1?1-X:X)}function o(y,T,L,U){let X=T.valToPct(y);return U+L*(T.dir==-1?X:1-X)}function a(y,T,L,U){return T.ori==0?r(y,T,L,U):o(y,T,L,U)}n.valToPosH=r,n.valToPosV=o;let l=!1;n.status=0;let c=n.root=wi(k_);if(i.id!=null&&(c.id=i.id),mi(c,i.class),i.title){let y=wi(G_,c);y.textContent=i.title}let h=Di("canvas"),u=n.ctx=h.getContext("2d"),d=wi(V_,c);gr("click",d,y=>{y.target===p&&(Yt!=Wr||Qt!=Xr)&&kn.click(n,y)},!0);let f=n.under=wi(W_,d);d.appendChild(h);let p=n.over=wi(X_,d);i=eo(i);let v=+At(i.pxAlign,1),g=Yp(v);(i.plugins||[]).forEach(y=>{y.opts&&(i=y.opts(n,i)||i)});let m=i.ms||.001,_=n.series=s==1?Kp(i.series||[],zp,Xp,!1):Ty(i.series||[null],Wp),E=n.axes=Kp(i.axes||[],kp,Gp,!0),b=n.scales={},C=n.bands=i.bands||[];C.forEach(y=>{y.fill=bt(y.fill||null),y.dir=At(y.dir,-1)});let M=s==2?_[1].facets[0].scale:_[0].scale,x={axes:fs,series:gt},w=(i.drawOrder||["axes","series"]).map(y=>x[y]);function O(y){let T=y.distr==3?L=>ms(L>0?L:y.clamp(n,L,y.min,y.max,y.key)):y.distr==4?L=>gu(L,y.asinh):y.distr==100?L=>y.fwd(L):L=>L;return L=>{let U=T(L),{_min:X,_max:J}=y,le=J-X;return(U-X)/le}}function P(y){let T=b[y];if(T==null){let L=(i.scales||oa)[y]||oa;if(L.from!=null){P(L.from);let U=bn({},b[L.from],L,{key:y});U.valToPct=O(U),b[y]=U}else{T=b[y]=bn({},y==M?Em:py,L),T.key=y;let U=T.time,X=T.range,J=Gs(X);if((y!=M||s==2&&!U)&&(J&&(X[0]==null||X[1]==null)&&(X={min:X[0]==null?Ep:{mode:1,hard:X[0],soft:X[0]},max:X[1]==null?Ep:{mode:1,hard:X[1],soft:X[1]}},J=!1),!J&&Ml(X))){let le=X;X=(pe,be,Fe)=>be==null?Qr:_l(be,Fe,le)}T.range=bt(X||(U?Ay:y==M?T.distr==3?Cy:T.distr==4?Py:Um:T.distr==3?Fm:T.distr==4?Om:Ry)),T.auto=bt(J?!1:T.auto),T.clamp=bt(T.clamp||fy),T._min=T._max=null,T.valToPct=O(T)}}}P("x"),P("y"),s==1&&_.forEach(y=>{P(y.scale)}),E.forEach(y=>{P(y.scale)});for(let y in i.scales)P(y);let D=b[M],z=D.distr,W,N;D.ori==0?(mi(c,z_),W=r,N=o):(mi(c,H_),W=o,N=r);let V={};for(let y in b){let T=b[y];(T.min!=null||T.max!=null)&&(V[y]={min:T.min,max:T.max},T.min=T.max=null)}let Z=i.tzDate||(y=>new Date(Tn(y/m))),G=i.fmtDate||Ou,ce=m==1?zx(Z):Vx(Z),Y=Fp(Z,Up(m==1?kx:Gx,G)),Q=Bp(Z,Op(Xx,G)),ie=[],de=n.legend=bn({},Zx,i.legend),fe=n.cursor=bn({},ey,{drag:{y:s==2}},i.cursor),ee=de.show,ge=fe.show,ye=de.markers;de.idxs=ie,ye.width=bt(ye.width),ye.dash=bt(ye.dash),ye.stroke=bt(ye.stroke),ye.fill=bt(ye.fill);let Pe,we,Ye,at=[],Xe=[],pt,ut=!1,rt={};if(de.live){let y=_[1]?_[1].values:null;ut=y!=null,pt=ut?y(n,1,0):{_:0};for(let T in pt)rt[T]=Iu}if(ee)if(Pe=Di("table",J_,c),Ye=Di("tbody",null,Pe),de.mount(n,Pe),ut){we=Di("thead",null,Pe,Ye);let y=Di("tr",null,we);Di("th",null,y);for(var jt in pt)Di("th",dp,y).textContent=jt}else mi(Pe,Q_),de.live&&mi(Pe,j_);let Wt={show:!0},mn={show:!1};function Ot(y,T){if(T==0&&(ut||!de.live||s==2))return Qr;let L=[],U=Di("tr",ex,Ye,Ye.childNodes[T]);mi(U,y.class),y.show||mi(U,mr);let X=Di("th",null,U);if(ye.show){let pe=wi(tx,X);if(T>0){let be=ye.width(n,T);be&&(pe.style.border=be+"px "+ye.dash(n,T)+" "+ye.stroke(n,T)),pe.style.background=ye.fill(n,T)}}let J=wi(dp,X);y.label instanceof HTMLElement?J.appendChild(y.label):J.textContent=y.label,T>0&&(ye.show||(J.style.color=y.width>0?ye.stroke(n,T):ye.fill(n,T)),St("click",X,pe=>{if(fe._lock)return;et(pe);let be=_.indexOf(y);if((pe.ctrlKey||pe.metaKey)!=de.isolate){let Fe=_.some((Oe,ke)=>ke>0&&ke!=be&&Oe.show);_.forEach((Oe,ke)=>{ke>0&&Ji(ke,Fe?ke==be?Wt:mn:Wt,!0,vn.setSeries)})}else Ji(be,{show:!y.show},!0,vn.setSeries)},!1),tt&&St(gp,X,pe=>{fe._lock||(et(pe),Ji(_.indexOf(y),Yr,!0,vn.setSeries))},!1));for(var le in pt){let pe=Di("td",nx,U);pe.textContent="--",L.push(pe)}return[U,L]}let Ln=new Map;function St(y,T,L,U=!0){let X=Ln.get(T)||{},J=fe.bind[y](n,T,L,U);J&&(gr(y,T,X[y]=J),Ln.set(T,X))}function wn(y,T,L){let U=Ln.get(T)||{};for(let X in U)(y==null||X==y)&&(Su(X,T,U[X]),delete U[X]);y==null&&Ln.delete(T)}let rn=0,gn=0,k=0,Le=0,Je=0,lt=0,Ee=Je,kt=lt,Ve=k,$e=Le,I=0,S=0,q=0,ue=0;n.bbox={};let oe=!1,xe=!1,ve=!1,te=!1,se=!1,me=!1;function B(y,T,L){(L||y!=n.width||T!=n.height)&&re(y,T),dt(!1),ve=!0,xe=!0,Wn()}function re(y,T){n.width=rn=k=y,n.height=gn=Le=T,Je=lt=0,Se(),qe();let L=n.bbox;I=L.left=fr(Je*Ct,.5),S=L.top=fr(lt*Ct,.5),q=L.width=fr(k*Ct,.5),ue=L.height=fr(Le*Ct,.5)}let ne=3;function Te(){let y=!1,T=0;for(;!y;){T++;let L=Hr(T),U=Ki(T);y=T==ne||L&&U,y||(re(n.width,n.height),xe=!0)}}function _e({width:y,height:T}){B(y,T)}n.setSize=_e;function Se(){let y=!1,T=!1,L=!1,U=!1;E.forEach((X,J)=>{if(X.show&&X._show){let{side:le,_size:pe}=X,be=le%2,Fe=X.label!=null?X.labelSize:0,Oe=pe+Fe;Oe>0&&(be?(k-=Oe,le==3?(Je+=Oe,U=!0):L=!0):(Le-=Oe,le==0?(lt+=Oe,y=!0):T=!0))}}),Zi[0]=y,Zi[1]=L,Zi[2]=T,Zi[3]=U,k-=Pi[1]+Pi[3],Je+=Pi[3],Le-=Pi[2]+Pi[0],lt+=Pi[0]}function qe(){let y=Je+k,T=lt+Le,L=Je,U=lt;function X(J,le){switch(J){case 1:return y+=le,y-le;case 2:return T+=le,T-le;case 3:return L-=le,L+le;case 0:return U-=le,U+le}}E.forEach((J,le)=>{if(J.show&&J._show){let pe=J.side;J._pos=X(pe,J._size),J.label!=null&&(J._lpos=X(pe,J.labelSize))}})}if(fe.dataIdx==null){let y=fe.hover,T=y.skip=new Set(y.skip??[]);T.add(void 0);let L=y.prox=bt(y.prox),U=y.bias??=0;fe.dataIdx=(X,J,le,pe)=>{if(J==0)return le;let be=le,Fe=L(X,J,le,pe)??zt,Oe=Fe>=0&&Fe<zt,ke=D.ori==0?k:Le,ot=fe.left,Rt=e[0],Tt=e[J];if(T.has(Tt[le])){be=null;let yt=null,je=null,Ze;if(U==0||U==-1)for(Ze=le;yt==null&&Ze-- >0;)T.has(Tt[Ze])||(yt=Ze);if(U==0||U==1)for(Ze=le;je==null&&Ze++<Tt.length;)T.has(Tt[Ze])||(je=Ze);if(yt!=null||je!=null)if(Oe){let $t=yt==null?-1/0:W(Rt[yt],D,ke,0),ln=je==null?1/0:W(Rt[je],D,ke,0),Fn=ot-$t,Bt=ln-ot;Fn<=Bt?Fn<=Fe&&(be=yt):Bt<=Fe&&(be=je)}else be=je==null?yt:yt==null?je:le-yt<=je-le?yt:je}else Oe&&An(ot-W(Rt[le],D,ke,0))>Fe&&(be=null);return be}}let et=y=>{fe.event=y};fe.idxs=ie,fe._lock=!1;let he=fe.points;he.show=bt(he.show),he.size=bt(he.size),he.stroke=bt(he.stroke),he.width=bt(he.width),he.fill=bt(he.fill);let ze=n.focus=bn({},i.focus||{alpha:.3},fe.focus),tt=ze.prox>=0,Ie=tt&&he.one,ht=[],qt=[],jn=[];function Yo(y,T){let L=he.show(n,T);if(L instanceof HTMLElement)return mi(L,K_),mi(L,y.class),ts(L,-10,-10,k,Le),p.insertBefore(L,ht[T]),L}function Br(y,T){if(s==1||T>0){let L=s==1&&b[y.scale].time,U=y.value;y.value=L?Ip(U)?Bp(Z,Op(U,G)):U||Q:U||hy,y.label=y.label||(L?ny:ty)}if(Ie||T>0){y.width=y.width==null?1:y.width,y.paths=y.paths||wy||px,y.fillTo=bt(y.fillTo||my),y.pxAlign=+At(y.pxAlign,v),y.pxRound=Yp(y.pxAlign),y.stroke=bt(y.stroke||null),y.fill=bt(y.fill||null),y._stroke=y._fill=y._paths=y._focus=null;let L=uy(ii(1,y.width),1),U=y.points=bn({},{size:L,width:ii(1,L*.2),stroke:y.stroke,space:L*2,paths:Ey,_stroke:null,_fill:null},y.points);U.show=bt(U.show),U.filter=bt(U.filter),U.fill=bt(U.fill),U.stroke=bt(U.stroke),U.paths=bt(U.paths),U.pxAlign=y.pxAlign}if(ee){let L=Ot(y,T);at.splice(T,0,L[0]),Xe.splice(T,0,L[1]),de.values.push(null)}if(ge){ie.splice(T,0,null);let L=null;Ie?T==0&&(L=Yo(y,T)):T>0&&(L=Yo(y,T)),ht.splice(T,0,L),qt.splice(T,0,0),jn.splice(T,0,0)}Un("addSeries",T)}function iu(y,T){T=T??_.length,y=s==1?Cu(y,T,zp,Xp):Cu(y,T,{},Wp),_.splice(T,0,y),Br(_[T],T)}n.addSeries=iu;function ll(y){if(_.splice(y,1),ee){de.values.splice(y,1),Xe.splice(y,1);let T=at.splice(y,1)[0];wn(null,T.firstChild),T.remove()}ge&&(ie.splice(y,1),ht.splice(y,1)[0].remove(),qt.splice(y,1),jn.splice(y,1)),Un("delSeries",y)}n.delSeries=ll;let Zi=[!1,!1,!1,!1];function hs(y,T){if(y._show=y.show,y.show){let L=y.side%2,U=b[y.scale];U==null&&(y.scale=L?_[1].scale:M,U=b[y.scale]);let X=U.time;y.size=bt(y.size),y.space=bt(y.space),y.rotate=bt(y.rotate),Gs(y.incrs)&&y.incrs.forEach(le=>{!Vs.has(le)&&Vs.set(le,om(le))}),y.incrs=bt(y.incrs||(U.distr==2?Fx:X?m==1?Bx:Hx:pr)),y.splits=bt(y.splits||(X&&U.distr==1?ce:U.distr==3?Eu:U.distr==4?ry:sy)),y.stroke=bt(y.stroke),y.grid.stroke=bt(y.grid.stroke),y.ticks.stroke=bt(y.ticks.stroke),y.border.stroke=bt(y.border.stroke);let J=y.values;y.values=Gs(J)&&!Gs(J[0])?bt(J):X?Gs(J)?Fp(Z,Up(J,G)):Ip(J)?Wx(Z,J):J||Y:J||iy,y.filter=bt(y.filter||(U.distr>=3&&U.log==10?ly:U.distr==3&&U.log==2?cy:sm)),y.font=Jp(y.font),y.labelFont=Jp(y.labelFont),y._size=y.size(n,null,T,0),y._space=y._rotate=y._incrs=y._found=y._splits=y._values=null,y._size>0&&(Zi[T]=!0,y._el=wi(q_,d))}}function us(y,T,L,U){let[X,J,le,pe]=L,be=T%2,Fe=0;return be==0&&(pe||J)&&(Fe=T==0&&!X||T==2&&!le?Tn(kp.size/3):0),be==1&&(X||le)&&(Fe=T==1&&!J||T==3&&!pe?Tn(Gp.size/2):0),Fe}let Zo=n.padding=(i.padding||[us,us,us,us]).map(y=>bt(At(y,us))),Pi=n._padding=Zo.map((y,T)=>y(n,T,Zi,0)),on,dn=null,fn=null,$i=s==1?_[0].idxs:null,ui=null,Fs=!1;function $o(y,T){if(e=y??[],n.data=n._data=e,s==2){on=0;for(let L=1;L<_.length;L++)on+=e[L][0].length}else{e.length==0&&(n.data=n._data=e=[[]]),ui=e[0],on=ui.length;let L=e;if(z==2){L=e.slice();let U=L[0]=Array(on);for(let X=0;X<on;X++)U[X]=X}n._data=e=L}if(dt(!0),Un("setData"),z==2&&(ve=!0),T!==!1){let L=D;L.auto(n,Fs)?Ko():ks(M,L.min,L.max),te=te||fe.left>=0,me=!0,Wn()}}n.setData=$o;function Ko(){Fs=!0;let y,T;s==1&&(on>0?(dn=$i[0]=0,fn=$i[1]=on-1,y=e[0][dn],T=e[0][fn],z==2?(y=dn,T=fn):y==T&&(z==3?[y,T]=vl(y,y,D.log,!1):z==4?[y,T]=Du(y,y,D.log,!1):D.time?T=y+Tn(86400/m):[y,T]=_l(y,T,Nu,!0))):(dn=$i[0]=y=null,fn=$i[1]=T=null)),ks(M,y,T)}let kr,Os,zr,A,H,j,$,K,Ae,De;function Re(y,T,L,U,X,J){y??=pp,L??=Fu,U??="butt",X??=pp,J??="round",y!=kr&&(u.strokeStyle=kr=y),X!=Os&&(u.fillStyle=Os=X),T!=zr&&(u.lineWidth=zr=T),J!=H&&(u.lineJoin=H=J),U!=j&&(u.lineCap=j=U),L!=A&&u.setLineDash(A=L)}function Ne(y,T,L,U){T!=Os&&(u.fillStyle=Os=T),y!=$&&(u.font=$=y),L!=K&&(u.textAlign=K=L),U!=Ae&&(u.textBaseline=Ae=U)}function Ge(y,T,L,U,X=0){if(U.length>0&&y.auto(n,Fs)&&(T==null||T.min==null)){let J=At(dn,0),le=At(fn,U.length-1),pe=L.min==null?lx(U,J,le,X,y.distr==3):[L.min,L.max];y.min=Ui(y.min,L.min=pe[0]),y.max=ii(y.max,L.max=pe[1])}}let it={min:null,max:null};function mt(){for(let U in b){let X=b[U];V[U]==null&&(X.min==null||V[M]!=null&&X.auto(n,Fs))&&(V[U]=it)}for(let U in b){let X=b[U];V[U]==null&&X.from!=null&&V[X.from]!=null&&(V[U]=it)}V[M]!=null&&dt(!0);let y={};for(let U in V){let X=V[U];if(X!=null){let J=y[U]=eo(b[U],_x);if(X.min!=null)bn(J,X);else if(U!=M||s==2)if(on==0&&J.from==null){let le=J.range(n,null,null,U);J.min=le[0],J.max=le[1]}else J.min=zt,J.max=-zt}}if(on>0){_.forEach((U,X)=>{if(s==1){let J=U.scale,le=V[J];if(le==null)return;let pe=y[J];if(X==0){let be=pe.range(n,pe.min,pe.max,J);pe.min=be[0],pe.max=be[1],dn=Ni(pe.min,e[0]),fn=Ni(pe.max,e[0]),fn-dn>1&&(e[0][dn]<pe.min&&dn++,e[0][fn]>pe.max&&fn--),U.min=ui[dn],U.max=ui[fn]}else U.show&&U.auto&&Ge(pe,le,U,e[X],U.sorted);U.idxs[0]=dn,U.idxs[1]=fn}else if(X>0&&U.show&&U.auto){let[J,le]=U.facets,pe=J.scale,be=le.scale,[Fe,Oe]=e[X],ke=y[pe],ot=y[be];ke!=null&&Ge(ke,V[pe],J,Fe,J.sorted),ot!=null&&Ge(ot,V[be],le,Oe,le.sorted),U.min=le.min,U.max=le.max}});for(let U in y){let X=y[U],J=V[U];if(X.from==null&&(J==null||J.min==null)){let le=X.range(n,X.min==zt?null:X.min,X.max==-zt?null:X.max,U);X.min=le[0],X.max=le[1]}}}for(let U in y){let X=y[U];if(X.from!=null){let J=y[X.from];if(J.min==null)X.min=X.max=null;else{let le=X.range(n,J.min,J.max,U);X.min=le[0],X.max=le[1]}}}let T={},L=!1;for(let U in y){let X=y[U],J=b[U];if(J.min!=X.min||J.max!=X.max){J.min=X.min,J.max=X.max;let le=J.distr;J._min=le==3?ms(J.min):le==4?gu(J.min,J.asinh):le==100?J.fwd(J.min):J.min,J._max=le==3?ms(J.max):le==4?gu(J.max,J.asinh):le==100?J.fwd(J.max):J.max,T[U]=L=!0}}if(L){_.forEach((U,X)=>{s==2?X>0&&T.y&&(U._paths=null):T[U.scale]&&(U._paths=null)});for(let U in T)ve=!0,Un("setScale",U);ge&&fe.left>=0&&(te=me=!0)}for(let U in V)V[U]=null}function He(y){let T=wu(dn-1,0,on-1),L=wu(fn+1,0,on-1);for(;y[T]==null&&T>0;)T--;for(;y[L]==null&&L<on-1;)L++;return[T,L]}function gt(){if(on>0){let y=_.some(T=>T._focus)&&De!=ze.alpha;y&&(u.globalAlpha=De=ze.alpha),_.forEach((T,L)=>{if(L>0&&T.show&&(sn(L,!1),sn(L,!0),T._paths==null)){let U=De;De!=T.alpha&&(u.globalAlpha=De=T.alpha);let X=s==2?[0,e[L][0].length-1]:He(e[L]);T._paths=T.paths(n,L,X[0],X[1]),De!=U&&(u.globalAlpha=De=U)}}),_.forEach((T,L)=>{if(L>0&&T.show){let U=De;De!=T.alpha&&(u.globalAlpha=De=T.alpha),T._paths!=null&&Nt(L,!1);{let X=T._paths!=null?T._paths.gaps:null,J=T.points.show(n,L,dn,fn,X),le=T.points.filter(n,L,J,X);(J||le)&&(T.points._paths=T.points.paths(n,L,dn,fn,le),Nt(L,!0))}De!=U&&(u.globalAlpha=De=U),Un("drawSeries",L)}}),y&&(u.globalAlpha=De=1)}}function sn(y,T){let L=T?_[y].points:_[y];L._stroke=L.stroke(n,y),L._fill=L.fill(n,y)}function Nt(y,T){let L=T?_[y].points:_[y],{stroke:U,fill:X,clip:J,flags:le,_stroke:pe=L._stroke,_fill:be=L._fill,_width:Fe=L.width}=L._paths;Fe=Ht(Fe*Ct,3);let Oe=null,ke=Fe%2/2;T&&be==null&&(be=Fe>0?"#fff":pe);let ot=L.pxAlign==1&&ke>0;if(ot&&u.translate(ke,ke),!T){let Rt=I-Fe/2,Tt=S-Fe/2,yt=q+Fe,je=ue+Fe;Oe=new Path2D,Oe.rect(Rt,Tt,yt,je)}T?Be(pe,Fe,L.dash,L.cap,be,U,X,le,J):Ut(y,pe,Fe,L.dash,L.cap,be,U,X,le,Oe,J),ot&&u.translate(-ke,-ke)}function Ut(y,T,L,U,X,J,le,pe,be,Fe,Oe){let ke=!1;be!=0&&C.forEach((ot,Rt)=>{if(ot.series[0]==y){let Tt=_[ot.series[1]],yt=e[ot.series[1]],je=(Tt._paths||oa).band;Gs(je)&&(je=ot.dir==1?je[0]:je[1]);let Ze,$t=null;Tt.show&&je&&hx(yt,dn,fn)?($t=ot.fill(n,Rt)||J,Ze=Tt._paths.clip):je=null,Be(T,L,U,X,$t,le,pe,be,Fe,Oe,Ze,je),ke=!0}}),ke||Be(T,L,U,X,J,le,pe,be,Fe,Oe)}let En=to|Au;function Be(y,T,L,U,X,J,le,pe,be,Fe,Oe,ke){Re(y,T,L,U,X),(be||Fe||ke)&&(u.save(),be&&u.clip(be),Fe&&u.clip(Fe)),ke?(pe&En)==En?(u.clip(ke),Oe&&u.clip(Oe),vt(X,le),_n(y,J,T)):pe&Au?(vt(X,le),u.clip(ke),_n(y,J,T)):pe&to&&(u.save(),u.clip(ke),Oe&&u.clip(Oe),vt(X,le),u.restore(),_n(y,J,T)):(vt(X,le),_n(y,J,T)),(be||Fe||ke)&&u.restore()}function _n(y,T,L){L>0&&(T instanceof Map?T.forEach((U,X)=>{u.strokeStyle=kr=X,u.stroke(U)}):T!=null&&y&&u.stroke(T))}function vt(y,T){T instanceof Map?T.forEach((L,U)=>{u.fillStyle=Os=U,u.fill(L)}):T!=null&&y&&u.fill(T)}function ds(y,T,L,U){let X=E[y],J;if(U<=0)J=[0,0];else{let le=X._space=X.space(n,y,T,L,U),pe=X._incrs=X.incrs(n,y,T,L,U,le);J=Iy(T,L,pe,U,le)}return X._found=J}function xn(y,T,L,U,X,J,le,pe,be,Fe){let Oe=le%2/2;v==1&&u.translate(Oe,Oe),Re(pe,le,be,Fe,pe),u.beginPath();let ke,ot,Rt,Tt,yt=X+(U==0||U==3?-J:J);L==0?(ot=X,Tt=yt):(ke=X,Rt=yt);for(let je=0;je<y.length;je++)T[je]!=null&&(L==0?ke=Rt=y[je]:ot=Tt=y[je],u.moveTo(ke,ot),u.lineTo(Rt,Tt));u.stroke(),v==1&&u.translate(-Oe,-Oe)}function Hr(y){let T=!0;return E.forEach((L,U)=>{if(!L.show)return;let X=b[L.scale];if(X.min==null){L._show&&(T=!1,L._show=!1,dt(!1));return}else L._show||(T=!1,L._show=!0,dt(!1));let J=L.side,le=J%2,{min:pe,max:be}=X,[Fe,Oe]=ds(U,pe,be,le==0?k:Le);if(Oe==0)return;let ke=X.distr==2,ot=L._splits=L.splits(n,U,pe,be,Fe,Oe,ke),Rt=X.distr==2?ot.map(Ze=>ui[Ze]):ot,Tt=X.distr==2?ui[ot[1]]-ui[ot[0]]:Fe,yt=L._values=L.values(n,L.filter(n,Rt,U,Oe,Tt),U,Oe,Tt);L._rotate=J==2?L.rotate(n,yt,U,Oe):0;let je=L._size;L._size=Ei(L.size(n,yt,U,y)),je!=null&&L._size!=je&&(T=!1)}),T}function Ki(y){let T=!0;return Zo.forEach((L,U)=>{let X=L(n,U,Zi,y);X!=Pi[U]&&(T=!1),Pi[U]=X}),T}function fs(){for(let y=0;y<E.length;y++){let T=E[y];if(!T.show||!T._show)continue;let L=T.side,U=L%2,X,J,le=T.stroke(n,y),pe=L==0||L==3?-1:1,[be,Fe]=T._found;if(T.label!=null){let ti=T.labelGap*pe,pi=Tn((T._lpos+ti)*Ct);Ne(T.labelFont[0],le,"center",L==2?"top":fp),u.save(),U==1?(X=J=0,u.translate(pi,Tn(S+ue/2)),u.rotate((L==3?-ml:ml)/2)):(X=Tn(I+q/2),J=pi);let dr=nm(T.label)?T.label(n,y,be,Fe):T.label;u.fillText(dr,X,J),u.restore()}if(Fe==0)continue;let Oe=b[T.scale],ke=U==0?q:ue,ot=U==0?I:S,Rt=T._splits,Tt=Oe.distr==2?Rt.map(ti=>ui[ti]):Rt,yt=Oe.distr==2?ui[Rt[1]]-ui[Rt[0]]:be,je=T.ticks,Ze=T.border,$t=je.show?je.size:0,ln=Tn($t*Ct),Fn=Tn((T.alignTo==2?T._size-$t-T.gap:T.gap)*Ct),Bt=T._rotate*-ml/180,cn=g(T._pos*Ct),di=(ln+Fn)*pe,ei=cn+di;J=U==0?ei:0,X=U==1?ei:0;let Mi=T.font[0],Ii=T.align==1?$r:T.align==2?fu:Bt>0?$r:Bt<0?fu:U==0?"center":L==3?fu:$r,Qi=Bt||U==1?"middle":L==2?"top":fp;Ne(Mi,le,Ii,Qi);let fi=T.font[1]*T.lineGap,Si=Rt.map(ti=>g(a(ti,Oe,ke,ot))),Li=T._values;for(let ti=0;ti<Li.length;ti++){let pi=Li[ti];if(pi!=null){U==0?X=Si[ti]:J=Si[ti],pi=""+pi;let dr=pi.indexOf(`
`)==-1?[pi]:pi.split(/\n/gm);for(let ni=0;ni<dr.length;ni++){let up=dr[ni];Bt?(u.save(),u.translate(X,J+ni*fi),u.rotate(Bt),u.fillText(up,0,0),u.restore()):u.fillText(up,X,J+ni*fi)}}}je.show&&xn(Si,je.filter(n,Tt,y,Fe,yt),U,L,cn,ln,Ht(je.width*Ct,3),je.stroke(n,y),je.dash,je.cap);let es=T.grid;es.show&&xn(Si,es.filter(n,Tt,y,Fe,yt),U,U==0?2:1,U==0?S:I,U==0?ue:q,Ht(es.width*Ct,3),es.stroke(n,y),es.dash,es.cap),Ze.show&&xn([cn],[1],U==0?1:0,U==0?1:2,U==1?S:I,U==1?ue:q,Ht(Ze.width*Ct,3),Ze.stroke(n,y),Ze.dash,Ze.cap)}Un("drawAxes")}function dt(y){_.forEach((T,L)=>{L>0&&(T._paths=null,y&&(s==1?(T.min=null,T.max=null):T.facets.forEach(U=>{U.min=null,U.max=null})))})}let an=!1,Qn=!1,Ft=[];function yn(){Qn=!1;for(let y=0;y<Ft.length;y++)Un(...Ft[y]);Ft.length=0}function Wn(){an||(wx(Yf),an=!0)}function cl(y,T=!1){an=!0,Qn=T,y(n),Yf(),T&&Ft.length>0&&queueMicrotask(yn)}n.batch=cl;function Yf(){if(oe&&(mt(),oe=!1),ve&&(Te(),ve=!1),xe){if(Kt(f,$r,Je),Kt(f,"top",lt),Kt(f,na,k),Kt(f,ia,Le),Kt(p,$r,Je),Kt(p,"top",lt),Kt(p,na,k),Kt(p,ia,Le),Kt(d,na,rn),Kt(d,ia,gn),h.width=Tn(rn*Ct),h.height=Tn(gn*Ct),E.forEach(({_el:y,_show:T,_size:L,_pos:U,side:X})=>{if(y!=null)if(T){let J=X===3||X===0?L:0,le=X%2==1;Kt(y,le?"left":"top",U-J),Kt(y,le?"width":"height",L),Kt(y,le?"top":"left",le?lt:Je),Kt(y,le?"height":"width",le?Le:k),Mu(y,mr)}else mi(y,mr)}),kr=Os=zr=H=j=$=K=Ae=A=null,De=1,Qo(!0),Je!=Ee||lt!=kt||k!=Ve||Le!=$e){dt(!1);let y=k/Ve,T=Le/$e;if(ge&&!te&&fe.left>=0){fe.left*=y,fe.top*=T,Gr&&ts(Gr,Tn(fe.left),0,k,Le),Vr&&ts(Vr,0,Tn(fe.top),k,Le);for(let L=0;L<ht.length;L++){let U=ht[L];U!=null&&(qt[L]*=y,jn[L]*=T,ts(U,Ei(qt[L]),Ei(jn[L]),k,Le))}}if(Zt.show&&!se&&Zt.left>=0&&Zt.width>0){Zt.left*=y,Zt.width*=y,Zt.top*=T,Zt.height*=T;for(let L in cu)Kt(qr,L,Zt[L])}Ee=Je,kt=lt,Ve=k,$e=Le}Un("setSize"),xe=!1}rn>0&&gn>0&&(u.clearRect(0,0,h.width,h.height),Un("drawClear"),w.forEach(y=>y()),Un("draw")),Zt.show&&se&&(hl(Zt),se=!1),ge&&te&&(ur(null,!0,!1),te=!1),de.show&&de.live&&me&&(au(),me=!1),l||(l=!0,n.status=1,Un("ready")),Fs=!1,an=!1}n.redraw=(y,T)=>{ve=T||!1,y!==!1?ks(M,D.min,D.max):Wn()};function su(y,T){let L=b[y];if(L.from==null){if(on==0){let U=L.range(n,T.min,T.max,y);T.min=U[0],T.max=U[1]}if(T.min>T.max){let U=T.min;T.min=T.max,T.max=U}if(on>1&&T.min!=null&&T.max!=null&&T.max-T.min<1e-16)return;y==M&&L.distr==2&&on>0&&(T.min=Ni(T.min,e[0]),T.max=Ni(T.max,e[0]),T.min==T.max&&T.max++),V[y]=T,oe=!0,Wn()}}n.setScale=su;let ru,ou,Gr,Vr,Zf,$f,Wr,Xr,Kf,Jf,Yt,Qt,Bs=!1,kn=fe.drag,Dn=kn.x,Nn=kn.y;ge&&(fe.x&&(ru=wi(Z_,p)),fe.y&&(ou=wi($_,p)),D.ori==0?(Gr=ru,Vr=ou):(Gr=ou,Vr=ru),Yt=fe.left,Qt=fe.top);let Zt=n.select=bn({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),qr=Zt.show?wi(Y_,Zt.over?p:f):null;function hl(y,T){if(Zt.show){for(let L in y)Zt[L]=y[L],L in cu&&Kt(qr,L,y[L]);T!==!1&&Un("setSelect")}}n.setSelect=hl;function A_(y){if(_[y].show)ee&&Mu(at[y],mr);else if(ee&&mi(at[y],mr),ge){let L=Ie?ht[0]:ht[y];L!=null&&ts(L,-10,-10,k,Le)}}function ks(y,T,L){su(y,{min:T,max:L})}function Ji(y,T,L,U){T.focus!=null&&L_(y),T.show!=null&&_.forEach((X,J)=>{J>0&&(y==J||y==null)&&(X.show=T.show,A_(J),s==2?(ks(X.facets[0].scale,null,null),ks(X.facets[1].scale,null,null)):ks(X.scale,null,null),Wn())}),L!==!1&&Un("setSeries",y,T),U&&ea("setSeries",n,y,T)}n.setSeries=Ji;function R_(y,T){bn(C[y],T)}function C_(y,T){y.fill=bt(y.fill||null),y.dir=At(y.dir,-1),T=T??C.length,C.splice(T,0,y)}function P_(y){y==null?C.length=0:C.splice(y,1)}n.addBand=C_,n.setBand=R_,n.delBand=P_;function I_(y,T){_[y].alpha=T,ge&&ht[y]!=null&&(ht[y].style.opacity=T),ee&&at[y]&&(at[y].style.opacity=T)}let ps,zs,hr,Yr={focus:!0};function L_(y){if(y!=hr){let T=y==null,L=ze.alpha!=1;_.forEach((U,X)=>{if(s==1||X>0){let J=T||X==0||X==y;U._focus=T?null:J,L&&I_(X,J?1:ze.alpha)}}),hr=y,L&&Wn()}}ee&&tt&&St(_p,Pe,y=>{fe._lock||(et(y),hr!=null&&Ji(null,Yr,!0,vn.setSeries))});function ji(y,T,L){let U=b[T];L&&(y=y/Ct-(U.ori==1?lt:Je));let X=k;U.ori==1&&(X=Le,y=X-y),U.dir==-1&&(y=X-y);let J=U._min,le=U._max,pe=y/X,be=J+(le-J)*pe,Fe=U.distr;return Fe==3?jr(10,be):Fe==4?dx(be,U.asinh):Fe==100?U.bwd(be):be}function D_(y,T){let L=ji(y,M,T);return Ni(L,e[0],dn,fn)}n.valToIdx=y=>Ni(y,e[0]),n.posToIdx=D_,n.posToVal=ji,n.valToPos=(y,T,L)=>b[T].ori==0?r(y,b[T],L?q:k,L?I:0):o(y,b[T],L?ue:Le,L?S:0),n.setCursor=(y,T,L)=>{Yt=y.left,Qt=y.top,ur(null,T,L)};function jf(y,T){Kt(qr,$r,Zt.left=y),Kt(qr,na,Zt.width=T)}function Qf(y,T){Kt(qr,"top",Zt.top=y),Kt(qr,ia,Zt.height=T)}let Jo=D.ori==0?jf:Qf,jo=D.ori==1?jf:Qf;function N_(){if(ee&&de.live)for(let y=s==2?1:0;y<_.length;y++){if(y==0&&ut)continue;let T=de.values[y],L=0;for(let U in T)Xe[y][L++].firstChild.nodeValue=T[U]}}function au(y,T){if(y!=null&&(y.idxs?y.idxs.forEach((L,U)=>{ie[U]=L}):gx(y.idx)||ie.fill(y.idx),de.idx=ie[0]),ee&&de.live){for(let L=0;L<_.length;L++)(L>0||s==1&&!ut)&&U_(L,ie[L]);N_()}me=!1,T!==!1&&Un("setLegend")}n.setLegend=au;function U_(y,T){let L=_[y],U=y==0&&z==2?ui:e[y],X;ut?X=L.values(n,y,T)??rt:(X=L.value(n,T==null?null:U[T],y,T),X=X==null?rt:{_:X}),de.values[y]=X}function ur(y,T,L){Kf=Yt,Jf=Qt,[Yt,Qt]=fe.move(n,Yt,Qt),fe.left=Yt,fe.top=Qt,ge&&(Gr&&ts(Gr,Tn(Yt),0,k,Le),Vr&&ts(Vr,0,Tn(Qt),k,Le));let U,X=dn>fn;ps=zt,zs=null;let J=D.ori==0?k:Le,le=D.ori==1?k:Le;if(Yt<0||on==0||X){U=fe.idx=null;for(let pe=0;pe<_.length;pe++){let be=ht[pe];be!=null&&ts(be,-10,-10,k,Le)}tt&&Ji(null,Yr,!0,y==null&&vn.setSeries),de.live&&(ie.fill(U),me=!0)}else{let pe,be,Fe;s==1&&(pe=D.ori==0?Yt:Qt,be=ji(pe,M),U=fe.idx=Ni(be,e[0],dn,fn),Fe=W(e[0][U],D,J,0));let Oe=-10,ke=-10,ot=0,Rt=0,Tt=!0,yt="",je="";for(let Ze=s==2?1:0;Ze<_.length;Ze++){let $t=_[Ze],ln=ie[Ze],Fn=ln==null?null:s==1?e[Ze][ln]:e[Ze][1][ln],Bt=fe.dataIdx(n,Ze,U,be),cn=Bt==null?null:s==1?e[Ze][Bt]:e[Ze][1][Bt];if(me=me||cn!=Fn||Bt!=ln,ie[Ze]=Bt,Ze>0&&$t.show){let di=Bt==null?-10:Bt==U?Fe:W(s==1?e[0][Bt]:e[Ze][0][Bt],D,J,0),ei=cn==null?-10:N(cn,s==1?b[$t.scale]:b[$t.facets[1].scale],le,0);if(tt&&cn!=null){let Mi=D.ori==1?Yt:Qt,Ii=An(ze.dist(n,Ze,Bt,ei,Mi));if(Ii<ps){let Qi=ze.bias;if(Qi!=0){let fi=ji(Mi,$t.scale),Si=cn>=0?1:-1,Li=fi>=0?1:-1;Li==Si&&(Li==1?Qi==1?cn>=fi:cn<=fi:Qi==1?cn<=fi:cn>=fi)&&(ps=Ii,zs=Ze)}else ps=Ii,zs=Ze}}if(me||Ie){let Mi,Ii;D.ori==0?(Mi=di,Ii=ei):(Mi=ei,Ii=di);let Qi,fi,Si,Li,es,ti,pi=!0,dr=he.bbox;if(dr!=null){pi=!1;let ni=dr(n,Ze);Si=ni.left,Li=ni.top,Qi=ni.width,fi=ni.height}else Si=Mi,Li=Ii,Qi=fi=he.size(n,Ze);if(ti=he.fill(n,Ze),es=he.stroke(n,Ze),Ie)Ze==zs&&ps<=ze.prox&&(Oe=Si,ke=Li,ot=Qi,Rt=fi,Tt=pi,yt=ti,je=es);else{let ni=ht[Ze];ni!=null&&(qt[Ze]=Si,jn[Ze]=Li,wp(ni,Qi,fi,pi),Mp(ni,ti,es),ts(ni,Ei(Si),Ei(Li),k,Le))}}}}if(Ie){let Ze=ze.prox,$t=hr==null?ps<=Ze:ps>Ze||zs!=hr;if(me||$t){let ln=ht[0];ln!=null&&(qt[0]=Oe,jn[0]=ke,wp(ln,ot,Rt,Tt),Mp(ln,yt,je),ts(ln,Ei(Oe),Ei(ke),k,Le))}}}if(Zt.show&&Bs)if(y!=null){let[pe,be]=vn.scales,[Fe,Oe]=vn.match,[ke,ot]=y.cursor.sync.scales,Rt=y.cursor.drag;if(Dn=Rt._x,Nn=Rt._y,Dn||Nn){let{left:Tt,top:yt,width:je,height:Ze}=y.select,$t=y.scales[ke].ori,ln=y.posToVal,Fn,Bt,cn,di,ei,Mi=pe!=null&&Fe(pe,ke),Ii=be!=null&&Oe(be,ot);Mi&&Dn?($t==0?(Fn=Tt,Bt=je):(Fn=yt,Bt=Ze),cn=b[pe],di=W(ln(Fn,ke),cn,J,0),ei=W(ln(Fn+Bt,ke),cn,J,0),Jo(Ui(di,ei),An(ei-di))):Jo(0,J),Ii&&Nn?($t==1?(Fn=Tt,Bt=je):(Fn=yt,Bt=Ze),cn=b[be],di=N(ln(Fn,ot),cn,le,0),ei=N(ln(Fn+Bt,ot),cn,le,0),jo(Ui(di,ei),An(ei-di))):jo(0,le)}else hu()}else{let pe=An(Kf-Zf),be=An(Jf-$f);if(D.ori==1){let ot=pe;pe=be,be=ot}Dn=kn.x&&pe>=kn.dist,Nn=kn.y&&be>=kn.dist;let Fe=kn.uni;Fe!=null?Dn&&Nn&&(Dn=pe>=Fe,Nn=be>=Fe,!Dn&&!Nn&&(be>pe?Nn=!0:Dn=!0)):kn.x&&kn.y&&(Dn||Nn)&&(Dn=Nn=!0);let Oe,ke;Dn&&(D.ori==0?(Oe=Wr,ke=Yt):(Oe=Xr,ke=Qt),Jo(Ui(Oe,ke),An(ke-Oe)),Nn||jo(0,le)),Nn&&(D.ori==1?(Oe=Wr,ke=Yt):(Oe=Xr,ke=Qt),jo(Ui(Oe,ke),An(ke-Oe)),Dn||Jo(0,J)),!Dn&&!Nn&&(Jo(0,0),jo(0,0))}if(kn._x=Dn,kn._y=Nn,y==null){if(L){if(hp!=null){let[pe,be]=vn.scales;vn.values[0]=pe!=null?ji(D.ori==0?Yt:Qt,pe):null,vn.values[1]=be!=null?ji(D.ori==1?Yt:Qt,be):null}ea(pu,n,Yt,Qt,k,Le,U)}if(tt){let pe=L&&vn.setSeries,be=ze.prox;hr==null?ps<=be&&Ji(zs,Yr,!0,pe):ps>be?Ji(null,Yr,!0,pe):zs!=hr&&Ji(zs,Yr,!0,pe)}}me&&(de.idx=U,au()),T!==!1&&Un("setCursor")}let Hs=null;Object.defineProperty(n,"rect",{get(){return Hs==null&&Qo(!1),Hs}});function Qo(y=!1){y?Hs=null:(Hs=p.getBoundingClientRect(),Un("syncRect",Hs))}function ep(y,T,L,U,X,J,le){fe._lock||Bs&&y!=null&&y.movementX==0&&y.movementY==0||(lu(y,T,L,U,X,J,le,!1,y!=null),y!=null?ur(null,!0,!0):ur(T,!0,!1))}function lu(y,T,L,U,X,J,le,pe,be){if(Hs==null&&Qo(!1),et(y),y!=null)L=y.clientX-Hs.left,U=y.clientY-Hs.top;else{if(L<0||U<0){Yt=-10,Qt=-10;return}let[Fe,Oe]=vn.scales,ke=T.cursor.sync,[ot,Rt]=ke.values,[Tt,yt]=ke.scales,[je,Ze]=vn.match,$t=T.axes[0].side%2==1,ln=D.ori==0?k:Le,Fn=D.ori==1?k:Le,Bt=$t?J:X,cn=$t?X:J,di=$t?U:L,ei=$t?L:U;if(Tt!=null?L=je(Fe,Tt)?a(ot,b[Fe],ln,0):-10:L=ln*(di/Bt),yt!=null?U=Ze(Oe,yt)?a(Rt,b[Oe],Fn,0):-10:U=Fn*(ei/cn),D.ori==1){let Mi=L;L=U,U=Mi}}be&&(T==null||T.cursor.event.type==pu)&&((L<=1||L>=k-1)&&(L=fr(L,k)),(U<=1||U>=Le-1)&&(U=fr(U,Le))),pe?(Zf=L,$f=U,[Wr,Xr]=fe.move(n,L,U)):(Yt=L,Qt=U)}let cu={width:0,height:0,left:0,top:0};function hu(){hl(cu,!1)}let tp,np,ip,sp;function rp(y,T,L,U,X,J,le){Bs=!0,Dn=Nn=kn._x=kn._y=!1,lu(y,T,L,U,X,J,le,!0,!1),y!=null&&(St(mu,vu,op,!1),ea(mp,n,Wr,Xr,k,Le,null));let{left:pe,top:be,width:Fe,height:Oe}=Zt;tp=pe,np=be,ip=Fe,sp=Oe}function op(y,T,L,U,X,J,le){Bs=kn._x=kn._y=!1,lu(y,T,L,U,X,J,le,!1,!0);let{left:pe,top:be,width:Fe,height:Oe}=Zt,ke=Fe>0||Oe>0,ot=tp!=pe||np!=be||ip!=Fe||sp!=Oe;if(ke&&ot&&hl(Zt),kn.setScale&&ke&&ot){let Rt=pe,Tt=Fe,yt=be,je=Oe;if(D.ori==1&&(Rt=be,Tt=Oe,yt=pe,je=Fe),Dn&&ks(M,ji(Rt,M),ji(Rt+Tt,M)),Nn)for(let Ze in b){let $t=b[Ze];Ze!=M&&$t.from==null&&$t.min!=zt&&ks(Ze,ji(yt+je,Ze),ji(yt,Ze))}hu()}else fe.lock&&(fe._lock=!fe._lock,ur(T,!0,y!=null));y!=null&&(wn(mu,vu),ea(mu,n,Yt,Qt,k,Le,null))}function F_(y,T,L,U,X,J,le){if(fe._lock)return;et(y);let pe=Bs;if(Bs){let be=!0,Fe=!0,Oe=10,ke,ot;D.ori==0?(ke=Dn,ot=Nn):(ke=Nn,ot=Dn),ke&&ot&&(be=Yt<=Oe||Yt>=k-Oe,Fe=Qt<=Oe||Qt>=Le-Oe),ke&&be&&(Yt=Yt<Wr?0:k),ot&&Fe&&(Qt=Qt<Xr?0:Le),ur(null,!0,!0),Bs=!1}Yt=-10,Qt=-10,ie.fill(null),ur(null,!0,!0),pe&&(Bs=pe)}function ap(y,T,L,U,X,J,le){fe._lock||(et(y),Ko(),hu(),y!=null&&ea(xp,n,Yt,Qt,k,Le,null))}function lp(){E.forEach(Ly),B(n.width,n.height,!0)}gr(gl,Jr,lp);let Zr={};Zr.mousedown=rp,Zr.mousemove=ep,Zr.mouseup=op,Zr.dblclick=ap,Zr.setSeries=(y,T,L,U)=>{let X=vn.match[2];L=X(n,T,L),L!=-1&&Ji(L,U,!0,!1)},ge&&(St(mp,p,rp),St(pu,p,ep),St(gp,p,y=>{et(y),Qo(!1)}),St(_p,p,F_),St(xp,p,ap),Ru.add(n),n.syncRect=Qo);let ul=n.hooks=i.hooks||{};function Un(y,T,L){Qn?Ft.push([y,T,L]):y in ul&&ul[y].forEach(U=>{U.call(null,n,T,L)})}(i.plugins||[]).forEach(y=>{for(let T in y.hooks)ul[T]=(ul[T]||[]).concat(y.hooks[T])});let cp=(y,T,L)=>L,vn=bn({key:null,setSeries:!1,filters:{pub:Cp,sub:Cp},scales:[M,_[1]?_[1].scale:null],match:[Pp,Pp,cp],values:[null,null]},fe.sync);vn.match.length==2&&vn.match.push(cp),fe.sync=vn;let hp=vn.key,uu=Tm(hp);function ea(y,T,L,U,X,J,le){vn.filters.pub(y,T,L,U,X,J,le)&&uu.pub(y,T,L,U,X,J,le)}uu.sub(n);function O_(y,T,L,U,X,J,le){vn.filters.sub(y,T,L,U,X,J,le)&&Zr[y](null,T,L,U,X,J,le)}n.pub=O_;function B_(){uu.unsub(n),Ru.delete(n),Ln.clear(),Su(gl,Jr,lp),c.remove(),Pe?.remove(),Un("destroy")}n.destroy=B_;function du(){Un("init",i,e),$o(e||i.data,!1),V[M]?su(M,V[M]):Ko(),se=Zt.show&&(Zt.width>0||Zt.height>0),te=me=!0,B(i.width,i.height)}return _.forEach(Br),E.forEach(hs),t?t instanceof HTMLElement?(t.appendChild(c),du()):t(n,du):du(),n}zn.assign=bn;zn.fmtNum=Uu;zn.rangeNum=_l;zn.rangeLog=vl;zn.rangeAsinh=Du;zn.orient=xr;zn.pxRatio=Ct;zn.join=Sx;zn.fmtDate=Ou,zn.tzDate=Nx;zn.sync=Tm;{zn.addGap=gy,zn.clipGaps=Sl;let i=zn.paths={points:Lm};i.linear=Nm,i.stepped=yy,i.bars=vy,i.spline=My}var Me=i=>document.getElementById(i),ae=(i,e={},...t)=>{let n=document.createElement(i);for(let[s,r]of Object.entries(e))typeof r=="function"?n.addEventListener(s.slice(2),r):s==="text"?n.textContent=String(r):r===!0?n.setAttribute(s,""):r!==!1&&r!==void 0&&n.setAttribute(s,String(r));return n.append(...t),n},Dy={play:"M7 4.5v15l12.500-7.500z",pause:"M6 4.5h4.200v15H6zM13.800 4.500H18v15h-4.200z",previous:"M5 5h2.4v14H5zM19 5v14L8.600 12z",next:"M16.600 5H19v14h-2.400zM5 5v14l10.400-7z",undo:"M9 5 3.500 10.500 9 16v-3.600h5a4 4 0 0 1 0 8h-3v2.100h3a6.100 6.100 0 0 0 0-12.200H9z",redo:"M15 5l5.500 5.500L15 16v-3.600h-5a4 4 0 0 0 0 8h3v2.100h-3a6.100 6.100 0 0 1 0-12.200h5z",save:"M4 4h12.500L20 7.500V20H4zM7 6v4.500h8V6zM12 12.800a2.700 2.700 0 1 0 0 5.400 2.700 2.700 0 0 0 0-5.400z",menu:"M4 6h16v2.200H4zM4 11h16v2.200H4zM4 16h16v2.200H4z",theme:"M12 3a9 9 0 1 0 0 18zM12 5.200v13.600a6.800 6.800 0 0 0 0-13.600z",key:"M12 3.500 20.500 12 12 20.500 3.500 12z",plus:"M10.900 4h2.200v6.900H20v2.200h-6.900V20h-2.200v-6.900H4v-2.200h6.900z",bin:"M9 3h6l1 2h4v2.200H4V5h4zM5.500 8.500h13L17.500 21h-11z",fold:"M8 5l8 7-8 7z"},Al=i=>{let e=document.createElementNS("http://www.w3.org/2000/svg","svg");e.setAttribute("viewBox","0 0 24 24"),e.setAttribute("aria-hidden","true");let t=document.createElementNS("http://www.w3.org/2000/svg","path");return t.setAttribute("d",Dy[i]),t.setAttribute("fill-rule","evenodd"),e.append(t),e},yr=(i,e)=>{i.textContent!==e&&(i.textContent=e)},Ws=(i,e,t,n="")=>{let s=ae("button",{type:"button",class:"tool",title:n?`${e} (${n})`:e,"aria-label":e,onclick:t});return s.append(Al(i)),s},Bm=0,Xn=(i,e="done")=>{if(!i)return;let t=Me("toast");t.textContent=i,t.className=e,t.setAttribute("role",e==="wrong"?"alert":"status"),t.hidden=!1,window.clearTimeout(Bm),Bm=window.setTimeout(()=>{t.hidden=!0},e==="wrong"?9e3:2600)},_s=(i,e=3)=>String(+i.toFixed(e));var ir={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},sr={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},_g=0,bd=1,xg=2;var Md=0,Ar=1,yg=2,Lo=3,rs=0,Gn=1,Kn=2,Rr=0,Do=1,Sd=2,wd=3,Ed=4,vg=5;var Cr=100,bg=101,Mg=102,Sg=103,wg=104,Eg=200,Tg=201,Ag=202,Rg=203,Td=204,Ad=205,Cg=206,Pg=207,Ig=208,Lg=209,Dg=210,Ng=211,Ug=212,Fg=213,Og=214,ic=0,sc=1,rc=2,bo=3,oc=4,ac=5,lc=6,cc=7,Nc=0,Bg=1,kg=2,os=0,Rd=1,Cd=2,Pd=3,Id=4,Ld=5,Dd=6,ka=7;var Nd=300,Pr=301,No=302,Uc=303,Fc=304,wr=1e3,is=1001,hc=1002,Bn=1003,zg=1004;var za=1005;var ri=1006,Uo=1007;var Is=1008;var ci=1009,Ud=1010,Fd=1011,Fo=1012,Oc=1013,Hi=1014,Gi=1015,Vi=1016,Bc=1017,kc=1018,Ir=1020,Od=35902,Bd=35899,kd=1021,zd=1022,Wi=1023,Es=1026,Ls=1027,Hd=1028,zc=1029,rr=1030,Hc=1031;var Gc=1033,Ha=33776,Ga=33777,Va=33778,Wa=33779,Vc=35840,Wc=35841,Xc=35842,qc=35843,Yc=36196,Zc=37492,$c=37496,Kc=37488,Jc=37489,Xa=37490,jc=37491,Qc=37808,eh=37809,th=37810,nh=37811,ih=37812,sh=37813,rh=37814,oh=37815,ah=37816,lh=37817,ch=37818,hh=37819,uh=37820,dh=37821,fh=36492,ph=36494,mh=36495,gh=36283,_h=36284,qa=36285,xh=36286;var ma=2300,uc=2301,tc=2302,dd=2303,fd=2400,pd=2401,md=2402;var Hg=3200;var Ya=0,Gg=1,Ds="",Sn="srgb",ga="srgb-linear",_a="linear",Dt="srgb";var nc=7680,Gd=7681;var Vd=517;var Vg=519,Wg=512,Xg=513,qg=514,Wd=515,Yg=516,Zg=517,Xd=518,qd=519,$g=35044,Yd=35048;var Zd="300 es",Ai=2e3,Mo=2001;function Ny(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function Uy(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function xa(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function Kg(){let i=xa("canvas");return i.style.display="block",i}var km={},So=null;function $d(...i){let e="THREE."+i.shift();So?So("log",e,...i):console.log(e,...i)}function Jg(i){let e=i[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=i[1];t&&t.isStackTrace?i[0]+=" "+t.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function Ke(...i){i=Jg(i);let e="THREE."+i.shift();if(So)So("warn",e,...i);else{let t=i[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...i)}}function nt(...i){i=Jg(i);let e="THREE."+i.shift();if(So)So("error",e,...i);else{let t=i[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...i)}}function fa(...i){let e=i.join(" ");e in km||(km[e]=!0,Ke(...i))}function jg(i,e,t){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:n()}}setTimeout(r,t)})}var Qg={[ic]:ic,[rc]:lc,[oc]:oc,[bo]:ac,[sc]:sc,[lc]:rc,[cc]:cc,[ac]:bo},ki=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let s=n[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},qn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],zm=1234567,yo=Math.PI/180,wo=180/Math.PI;function Oo(){let i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(qn[i&255]+qn[i>>8&255]+qn[i>>16&255]+qn[i>>24&255]+"-"+qn[e&255]+qn[e>>8&255]+"-"+qn[e>>16&15|64]+qn[e>>24&255]+"-"+qn[t&63|128]+qn[t>>8&255]+"-"+qn[t>>16&255]+qn[t>>24&255]+qn[n&255]+qn[n>>8&255]+qn[n>>16&255]+qn[n>>24&255]).toLowerCase()}function _t(i,e,t){return Math.max(e,Math.min(t,i))}function Kd(i,e){return(i%e+e)%e}function Fy(i,e,t,n,s){return n+(i-e)*(s-n)/(t-e)}function Oy(i,e,t){return i!==e?(t-i)/(e-i):0}function pa(i,e,t){return(1-t)*i+t*e}function By(i,e,t,n){return pa(i,e,1-Math.exp(-t*n))}function ky(i,e=1){return e-Math.abs(Kd(i,e*2)-e)}function zy(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*(3-2*i))}function Hy(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*i*(i*(i*6-15)+10))}function Gy(i,e){return i+Math.floor(Math.random()*(e-i+1))}function Vy(i,e){return i+Math.random()*(e-i)}function Wy(i){return i*(.5-Math.random())}function Xy(i){i!==void 0&&(zm=i);let e=zm+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function qy(i){return i*yo}function Yy(i){return i*wo}function Zy(i){return i>0&&Number.isInteger(i)&&2**Math.round(Math.log2(i))===i}function $y(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function Jd(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function Ky(i,e,t,n,s){let r=Math.cos,o=Math.sin,a=r(t/2),l=o(t/2),c=r((e+n)/2),h=o((e+n)/2),u=r((e-n)/2),d=o((e-n)/2),f=r((n-e)/2),p=o((n-e)/2);switch(s){case"XYX":i.set(a*h,l*u,l*d,a*c);break;case"YZY":i.set(l*d,a*h,l*u,a*c);break;case"ZXZ":i.set(l*u,l*d,a*h,a*c);break;case"XZX":i.set(a*h,l*p,l*f,a*c);break;case"YXY":i.set(l*f,a*h,l*p,a*c);break;case"ZYZ":i.set(l*p,l*f,a*h,a*c);break;default:Ke("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function jd(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function e0(i,e){if(e.constructor===Float32Array)return i;let t=jd(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/t,-1)}function t0(i,e){if(e.constructor===Float32Array)return i;let t=jd(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*t)}var yh={DEG2RAD:yo,RAD2DEG:wo,generateUUID:Oo,clamp:_t,euclideanModulo:Kd,mapLinear:Fy,inverseLerp:Oy,lerp:pa,damp:By,pingpong:ky,smoothstep:zy,smootherstep:Hy,randInt:Gy,randFloat:Vy,randFloatSpread:Wy,seededRandom:Xy,degToRad:qy,radToDeg:Yy,isPowerOfTwo:Zy,ceilPowerOfTwo:$y,floorPowerOfTwo:Jd,setQuaternionFromProperEuler:Ky,normalize:t0,denormalize:e0},We=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,s=e.elements;return this.x=s[0]*t+s[3]*n+s[6],this.y=s[1]*t+s[4]*n+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=_t(this.x,e.x,t.x),this.y=_t(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=_t(this.x,e,t),this.y=_t(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(_t(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(_t(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*n-o*s+e.x,this.y=r*s+o*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},ct=class{constructor(e=0,t=0,n=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=s}static slerpFlat(e,t,n,s,r,o,a){let l=n[s+0],c=n[s+1],h=n[s+2],u=n[s+3],d=r[o+0],f=r[o+1],p=r[o+2],v=r[o+3];if(u!==v||l!==d||c!==f||h!==p){let g=l*d+c*f+h*p+u*v;g<0&&(d=-d,f=-f,p=-p,v=-v,g=-g);let m=1-a;if(g<.9995){let _=Math.acos(g),E=Math.sin(_);m=Math.sin(m*_)/E,a=Math.sin(a*_)/E,l=l*m+d*a,c=c*m+f*a,h=h*m+p*a,u=u*m+v*a}else{l=l*m+d*a,c=c*m+f*a,h=h*m+p*a,u=u*m+v*a;let _=1/Math.sqrt(l*l+c*c+h*h+u*u);l*=_,c*=_,h*=_,u*=_}}e[t]=l,e[t+1]=c,e[t+2]=h,e[t+3]=u}static multiplyQuaternionsFlat(e,t,n,s,r,o){let a=n[s],l=n[s+1],c=n[s+2],h=n[s+3],u=r[o],d=r[o+1],f=r[o+2],p=r[o+3];return e[t]=a*p+h*u+l*f-c*d,e[t+1]=l*p+h*d+c*u-a*f,e[t+2]=c*p+h*f+a*d-l*u,e[t+3]=h*p-a*u-l*d-c*f,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,s){return this._x=e,this._y=t,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(n/2),h=a(s/2),u=a(r/2),d=l(n/2),f=l(s/2),p=l(r/2);switch(o){case"XYZ":this._x=d*h*u+c*f*p,this._y=c*f*u-d*h*p,this._z=c*h*p+d*f*u,this._w=c*h*u-d*f*p;break;case"YXZ":this._x=d*h*u+c*f*p,this._y=c*f*u-d*h*p,this._z=c*h*p-d*f*u,this._w=c*h*u+d*f*p;break;case"ZXY":this._x=d*h*u-c*f*p,this._y=c*f*u+d*h*p,this._z=c*h*p+d*f*u,this._w=c*h*u-d*f*p;break;case"ZYX":this._x=d*h*u-c*f*p,this._y=c*f*u+d*h*p,this._z=c*h*p-d*f*u,this._w=c*h*u+d*f*p;break;case"YZX":this._x=d*h*u+c*f*p,this._y=c*f*u+d*h*p,this._z=c*h*p-d*f*u,this._w=c*h*u-d*f*p;break;case"XZY":this._x=d*h*u-c*f*p,this._y=c*f*u-d*h*p,this._z=c*h*p+d*f*u,this._w=c*h*u+d*f*p;break;default:Ke("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let n=t/2,s=Math.sin(n);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,n=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],h=t[6],u=t[10],d=n+a+u;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(h-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(n>a&&n>u){let f=2*Math.sqrt(1+n-a-u);this._w=(h-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>u){let f=2*Math.sqrt(1+a-n-u);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+h)/f}else{let f=2*Math.sqrt(1+u-n-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+h)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(_t(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let s=Math.min(1,t/n);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,h=t._w;return this._x=n*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-n*c,this._z=r*h+o*c+n*l-s*a,this._w=o*h-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(n=-n,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),h=Math.sin(c);l=Math.sin(l*c)/h,t=Math.sin(t*c)/h,this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},F=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,n=0){this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(Hm.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(Hm.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6]*s,this.y=r[1]*t+r[4]*n+r[7]*s,this.z=r[2]*t+r[5]*n+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,n=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*n),h=2*(a*t-r*s),u=2*(r*n-o*t);return this.x=t+l*c+o*u-a*h,this.y=n+l*h+a*c-r*u,this.z=s+l*u+r*h-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*n+r[8]*s,this.y=r[1]*t+r[5]*n+r[9]*s,this.z=r[2]*t+r[6]*n+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=_t(this.x,e.x,t.x),this.y=_t(this.y,e.y,t.y),this.z=_t(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=_t(this.x,e,t),this.y=_t(this.y,e,t),this.z=_t(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(_t(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return Wu.copy(this).projectOnVector(e),this.sub(Wu)}reflect(e){return this.sub(Wu.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(_t(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y,s=this.z-e.z;return t*t+n*n+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let s=Math.sin(t)*e;return this.x=s*Math.sin(n),this.y=Math.cos(t)*e,this.z=s*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Wu=new F,Hm=new ct,st=class{static{this.prototype.isMatrix3=!0}constructor(e,t,n,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c)}set(e,t,n,s,r,o,a,l,c){let h=this.elements;return h[0]=e,h[1]=s,h[2]=a,h[3]=t,h[4]=r,h[5]=l,h[6]=n,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],h=n[4],u=n[7],d=n[2],f=n[5],p=n[8],v=s[0],g=s[3],m=s[6],_=s[1],E=s[4],b=s[7],C=s[2],M=s[5],x=s[8];return r[0]=o*v+a*_+l*C,r[3]=o*g+a*E+l*M,r[6]=o*m+a*b+l*x,r[1]=c*v+h*_+u*C,r[4]=c*g+h*E+u*M,r[7]=c*m+h*b+u*x,r[2]=d*v+f*_+p*C,r[5]=d*g+f*E+p*M,r[8]=d*m+f*b+p*x,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8];return t*o*h-t*a*c-n*r*h+n*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],u=h*o-a*c,d=a*l-h*r,f=c*r-o*l,p=t*u+n*d+s*f;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let v=1/p;return e[0]=u*v,e[1]=(s*c-h*n)*v,e[2]=(a*n-s*o)*v,e[3]=d*v,e[4]=(h*t-s*l)*v,e[5]=(s*r-a*t)*v,e[6]=f*v,e[7]=(n*l-c*t)*v,e[8]=(o*t-n*r)*v,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return fa("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Xu.makeScale(e,t)),this}rotate(e){return fa("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Xu.makeRotation(-e)),this}translate(e,t){return fa("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Xu.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<9;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}},Xu=new st,Gm=new st().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Vm=new st().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Jy(){let i={enabled:!0,workingColorSpace:ga,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Dt&&(s.r=ws(s.r),s.g=ws(s.g),s.b=ws(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Dt&&(s.r=vo(s.r),s.g=vo(s.g),s.b=vo(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Ds?_a:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[ga]:{primaries:e,whitePoint:n,transfer:_a,toXYZ:Gm,fromXYZ:Vm,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:Sn},outputColorSpaceConfig:{drawingBufferColorSpace:Sn}},[Sn]:{primaries:e,whitePoint:n,transfer:Dt,toXYZ:Gm,fromXYZ:Vm,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:Sn}}}),i}var Mt=Jy();function ws(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function vo(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var ro,dc=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{ro===void 0&&(ro=xa("canvas")),ro.width=e.width,ro.height=e.height;let s=ro.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),n=ro}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=xa("canvas");t.width=e.width,t.height=e.height;let n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);let s=n.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=ws(r[o]/255)*255;return n.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(ws(t[n]/255)*255):t[n]=ws(t[n]);return{data:t,width:e.width,height:e.height}}else return Ke("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},jy=0,Eo=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:jy++}),this.uuid=Oo(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(qu(s[o].image)):r.push(qu(s[o]))}else r=qu(s);n.url=r}return t||(e.images[this.uuid]=n),n}};function qu(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?dc.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(Ke("Texture: Unable to serialize Texture."),{})}var Qy=0,Yu=new F,Zn=class i extends ki{constructor(e=i.DEFAULT_IMAGE,t=i.DEFAULT_MAPPING,n=is,s=is,r=ri,o=Is,a=Wi,l=ci,c=i.DEFAULT_ANISOTROPY,h=Ds){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Qy++}),this.uuid=Oo(),this.name="",this.source=new Eo(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new We(0,0),this.repeat=new We(1,1),this.center=new We(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new st,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Yu).x}get height(){return this.source.getSize(Yu).y}get depth(){return this.source.getSize(Yu).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===void 0){Ke(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ke(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==Nd)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case wr:e.x=e.x-Math.floor(e.x);break;case is:e.x=e.x<0?0:1;break;case hc:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case wr:e.y=e.y-Math.floor(e.y);break;case is:e.y=e.y<0?0:1;break;case hc:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};Zn.DEFAULT_IMAGE=null;Zn.DEFAULT_MAPPING=Nd;Zn.DEFAULT_ANISOTROPY=1;var Xt=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,n=0,s=1){this.x=e,this.y=t,this.z=n,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,s){return this.x=e,this.y=t,this.z=n,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*n+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,s,r,l=e.elements,c=l[0],h=l[4],u=l[8],d=l[1],f=l[5],p=l[9],v=l[2],g=l[6],m=l[10];if(Math.abs(h-d)<.01&&Math.abs(u-v)<.01&&Math.abs(p-g)<.01){if(Math.abs(h+d)<.1&&Math.abs(u+v)<.1&&Math.abs(p+g)<.1&&Math.abs(c+f+m-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let E=(c+1)/2,b=(f+1)/2,C=(m+1)/2,M=(h+d)/4,x=(u+v)/4,w=(p+g)/4;return E>b&&E>C?E<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(E),s=M/n,r=x/n):b>C?b<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(b),n=M/s,r=w/s):C<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(C),n=x/r,s=w/r),this.set(n,s,r,t),this}let _=Math.sqrt((g-p)*(g-p)+(u-v)*(u-v)+(d-h)*(d-h));return Math.abs(_)<.001&&(_=1),this.x=(g-p)/_,this.y=(u-v)/_,this.z=(d-h)/_,this.w=Math.acos((c+f+m-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=_t(this.x,e.x,t.x),this.y=_t(this.y,e.y,t.y),this.z=_t(this.z,e.z,t.z),this.w=_t(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=_t(this.x,e,t),this.y=_t(this.y,e,t),this.z=_t(this.z,e,t),this.w=_t(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(_t(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},fc=class extends ki{constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:ri,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new Xt(0,0,e,t),this.scissorTest=!1,this.viewport=new Xt(0,0,e,t),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new Zn({width:e,height:t,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:ri,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new Eo(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},vi=class extends fc{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}},ya=class extends Zn{constructor(e=null,t=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=Bn,this.minFilter=Bn,this.wrapR=is,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var pc=class extends Zn{constructor(e=null,t=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=Bn,this.minFilter=Bn,this.wrapR=is,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var wt=class i{static{this.prototype.isMatrix4=!0}constructor(e,t,n,s,r,o,a,l,c,h,u,d,f,p,v,g){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c,h,u,d,f,p,v,g)}set(e,t,n,s,r,o,a,l,c,h,u,d,f,p,v,g){let m=this.elements;return m[0]=e,m[4]=t,m[8]=n,m[12]=s,m[1]=r,m[5]=o,m[9]=a,m[13]=l,m[2]=c,m[6]=h,m[10]=u,m[14]=d,m[3]=f,m[7]=p,m[11]=v,m[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),n.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,n=e.elements,s=1/oo.setFromMatrixColumn(e,0).length(),r=1/oo.setFromMatrixColumn(e,1).length(),o=1/oo.setFromMatrixColumn(e,2).length();return t[0]=n[0]*s,t[1]=n[1]*s,t[2]=n[2]*s,t[3]=0,t[4]=n[4]*r,t[5]=n[5]*r,t[6]=n[6]*r,t[7]=0,t[8]=n[8]*o,t[9]=n[9]*o,t[10]=n[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,n=e.x,s=e.y,r=e.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),u=Math.sin(r);if(e.order==="XYZ"){let d=o*h,f=o*u,p=a*h,v=a*u;t[0]=l*h,t[4]=-l*u,t[8]=c,t[1]=f+p*c,t[5]=d-v*c,t[9]=-a*l,t[2]=v-d*c,t[6]=p+f*c,t[10]=o*l}else if(e.order==="YXZ"){let d=l*h,f=l*u,p=c*h,v=c*u;t[0]=d+v*a,t[4]=p*a-f,t[8]=o*c,t[1]=o*u,t[5]=o*h,t[9]=-a,t[2]=f*a-p,t[6]=v+d*a,t[10]=o*l}else if(e.order==="ZXY"){let d=l*h,f=l*u,p=c*h,v=c*u;t[0]=d-v*a,t[4]=-o*u,t[8]=p+f*a,t[1]=f+p*a,t[5]=o*h,t[9]=v-d*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let d=o*h,f=o*u,p=a*h,v=a*u;t[0]=l*h,t[4]=p*c-f,t[8]=d*c+v,t[1]=l*u,t[5]=v*c+d,t[9]=f*c-p,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let d=o*l,f=o*c,p=a*l,v=a*c;t[0]=l*h,t[4]=v-d*u,t[8]=p*u+f,t[1]=u,t[5]=o*h,t[9]=-a*h,t[2]=-c*h,t[6]=f*u+p,t[10]=d-v*u}else if(e.order==="XZY"){let d=o*l,f=o*c,p=a*l,v=a*c;t[0]=l*h,t[4]=-u,t[8]=c*h,t[1]=d*u+v,t[5]=o*h,t[9]=f*u-p,t[2]=p*u-f,t[6]=a*h,t[10]=v*u+d}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(ev,e,tv)}lookAt(e,t,n){let s=this.elements;return xi.subVectors(e,t),xi.lengthSq()===0&&(xi.z=1),xi.normalize(),Xs.crossVectors(n,xi),Xs.lengthSq()===0&&(Math.abs(n.z)===1?xi.x+=1e-4:xi.z+=1e-4,xi.normalize(),Xs.crossVectors(n,xi)),Xs.normalize(),Rl.crossVectors(xi,Xs),s[0]=Xs.x,s[4]=Rl.x,s[8]=xi.x,s[1]=Xs.y,s[5]=Rl.y,s[9]=xi.y,s[2]=Xs.z,s[6]=Rl.z,s[10]=xi.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],h=n[1],u=n[5],d=n[9],f=n[13],p=n[2],v=n[6],g=n[10],m=n[14],_=n[3],E=n[7],b=n[11],C=n[15],M=s[0],x=s[4],w=s[8],O=s[12],P=s[1],D=s[5],z=s[9],W=s[13],N=s[2],V=s[6],Z=s[10],G=s[14],ce=s[3],Y=s[7],Q=s[11],ie=s[15];return r[0]=o*M+a*P+l*N+c*ce,r[4]=o*x+a*D+l*V+c*Y,r[8]=o*w+a*z+l*Z+c*Q,r[12]=o*O+a*W+l*G+c*ie,r[1]=h*M+u*P+d*N+f*ce,r[5]=h*x+u*D+d*V+f*Y,r[9]=h*w+u*z+d*Z+f*Q,r[13]=h*O+u*W+d*G+f*ie,r[2]=p*M+v*P+g*N+m*ce,r[6]=p*x+v*D+g*V+m*Y,r[10]=p*w+v*z+g*Z+m*Q,r[14]=p*O+v*W+g*G+m*ie,r[3]=_*M+E*P+b*N+C*ce,r[7]=_*x+E*D+b*V+C*Y,r[11]=_*w+E*z+b*Z+C*Q,r[15]=_*O+E*W+b*G+C*ie,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],h=e[2],u=e[6],d=e[10],f=e[14],p=e[3],v=e[7],g=e[11],m=e[15],_=l*f-c*d,E=a*f-c*u,b=a*d-l*u,C=o*f-c*h,M=o*d-l*h,x=o*u-a*h;return t*(v*_-g*E+m*b)-n*(p*_-g*C+m*M)+s*(p*E-v*C+m*x)-r*(p*b-v*M+g*x)}determinantAffine(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],h=e[10];return t*(o*h-a*c)-n*(r*h-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],u=e[9],d=e[10],f=e[11],p=e[12],v=e[13],g=e[14],m=e[15],_=t*a-n*o,E=t*l-s*o,b=t*c-r*o,C=n*l-s*a,M=n*c-r*a,x=s*c-r*l,w=h*v-u*p,O=h*g-d*p,P=h*m-f*p,D=u*g-d*v,z=u*m-f*v,W=d*m-f*g,N=_*W-E*z+b*D+C*P-M*O+x*w;if(N===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let V=1/N;return e[0]=(a*W-l*z+c*D)*V,e[1]=(s*z-n*W-r*D)*V,e[2]=(v*x-g*M+m*C)*V,e[3]=(d*M-u*x-f*C)*V,e[4]=(l*P-o*W-c*O)*V,e[5]=(t*W-s*P+r*O)*V,e[6]=(g*b-p*x-m*E)*V,e[7]=(h*x-d*b+f*E)*V,e[8]=(o*z-a*P+c*w)*V,e[9]=(n*P-t*z-r*w)*V,e[10]=(p*M-v*b+m*_)*V,e[11]=(u*b-h*M-f*_)*V,e[12]=(a*O-o*D-l*w)*V,e[13]=(t*D-n*O+s*w)*V,e[14]=(v*E-p*C-g*_)*V,e[15]=(h*C-u*E+d*_)*V,this}scale(e){let t=this.elements,n=e.x,s=e.y,r=e.z;return t[0]*=n,t[4]*=s,t[8]*=r,t[1]*=n,t[5]*=s,t[9]*=r,t[2]*=n,t[6]*=s,t[10]*=r,t[3]*=n,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,s))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),s=Math.sin(t),r=1-n,o=e.x,a=e.y,l=e.z,c=r*o,h=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+n,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,s,r,o){return this.set(1,n,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,n){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,h=o+o,u=a+a,d=r*c,f=r*h,p=r*u,v=o*h,g=o*u,m=a*u,_=l*c,E=l*h,b=l*u,C=n.x,M=n.y,x=n.z;return s[0]=(1-(v+m))*C,s[1]=(f+b)*C,s[2]=(p-E)*C,s[3]=0,s[4]=(f-b)*M,s[5]=(1-(d+m))*M,s[6]=(g+_)*M,s[7]=0,s[8]=(p+E)*x,s[9]=(g-_)*x,s[10]=(1-(d+v))*x,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,n){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),t.identity(),this;let o=oo.set(s[0],s[1],s[2]).length(),a=oo.set(s[4],s[5],s[6]).length(),l=oo.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Fi.copy(this);let c=1/o,h=1/a,u=1/l;return Fi.elements[0]*=c,Fi.elements[1]*=c,Fi.elements[2]*=c,Fi.elements[4]*=h,Fi.elements[5]*=h,Fi.elements[6]*=h,Fi.elements[8]*=u,Fi.elements[9]*=u,Fi.elements[10]*=u,t.setFromRotationMatrix(Fi),n.x=o,n.y=a,n.z=l,this}makePerspective(e,t,n,s,r,o,a=Ai,l=!1){let c=this.elements,h=2*r/(t-e),u=2*r/(n-s),d=(t+e)/(t-e),f=(n+s)/(n-s),p,v;if(l)p=r/(o-r),v=o*r/(o-r);else if(a===Ai)p=-(o+r)/(o-r),v=-2*o*r/(o-r);else if(a===Mo)p=-o/(o-r),v=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=u,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=p,c[14]=v,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,n,s,r,o,a=Ai,l=!1){let c=this.elements,h=2/(t-e),u=2/(n-s),d=-(t+e)/(t-e),f=-(n+s)/(n-s),p,v;if(l)p=1/(o-r),v=o/(o-r);else if(a===Ai)p=-2/(o-r),v=-(o+r)/(o-r);else if(a===Mo)p=-1/(o-r),v=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=u,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=p,c[14]=v,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<16;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}},oo=new F,Fi=new wt,ev=new F(0,0,0),tv=new F(1,1,1),Xs=new F,Rl=new F,xi=new F,Wm=new wt,Xm=new ct,Ri=class i{constructor(e=0,t=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,s=this._order){return this._x=e,this._y=t,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],u=s[2],d=s[6],f=s[10];switch(t){case"XYZ":this._y=Math.asin(_t(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-_t(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(_t(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-u,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-_t(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(_t(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-_t(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,f),this._y=0);break;default:Ke("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return Wm.makeRotationFromQuaternion(e),this.setFromRotationMatrix(Wm,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return Xm.setFromEuler(this),this.setFromQuaternion(Xm,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Ri.DEFAULT_ORDER="XYZ";var To=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},nv=0,qm=new F,ao=new ct,xs=new wt,Cl=new F,la=new F,iv=new F,sv=new ct,Ym=new F(1,0,0),Zm=new F(0,1,0),$m=new F(0,0,1),Km={type:"added"},rv={type:"removed"},lo={type:"childadded",child:null},Zu={type:"childremoved",child:null},tn=class i extends ki{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:nv++}),this.uuid=Oo(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let e=new F,t=new Ri,n=new ct,s=new F(1,1,1);function r(){n.setFromEuler(t,!1)}function o(){t.setFromQuaternion(n,void 0,!1)}t._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new wt},normalMatrix:{value:new st}}),this.matrix=new wt,this.matrixWorld=new wt,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new To,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return ao.setFromAxisAngle(e,t),this.quaternion.multiply(ao),this}rotateOnWorldAxis(e,t){return ao.setFromAxisAngle(e,t),this.quaternion.premultiply(ao),this}rotateX(e){return this.rotateOnAxis(Ym,e)}rotateY(e){return this.rotateOnAxis(Zm,e)}rotateZ(e){return this.rotateOnAxis($m,e)}translateOnAxis(e,t){return qm.copy(e).applyQuaternion(this.quaternion),this.position.add(qm.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(Ym,e)}translateY(e){return this.translateOnAxis(Zm,e)}translateZ(e){return this.translateOnAxis($m,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(xs.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?Cl.copy(e):Cl.set(e,t,n);let s=this.parent;this.updateWorldMatrix(!0,!1),la.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?xs.lookAt(la,Cl,this.up):xs.lookAt(Cl,la,this.up),this.quaternion.setFromRotationMatrix(xs),s&&(xs.extractRotation(s.matrixWorld),ao.setFromRotationMatrix(xs),this.quaternion.premultiply(ao.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(nt("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(Km),lo.child=e,this.dispatchEvent(lo),lo.child=null):nt("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(rv),Zu.child=e,this.dispatchEvent(Zu),Zu.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),xs.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),xs.multiply(e.parent.matrixWorld)),e.applyMatrix4(xs),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(Km),lo.child=e,this.dispatchEvent(lo),lo.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(la,e,iv),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(la,sv,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,n=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*n-r[8]*s,r[13]+=n-r[1]*t-r[5]*n-r[9]*s,r[14]+=s-r[2]*t-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t,n=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,n)}}toJSON(e){let t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let u=l[c];r(e.shapes,u)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),h=o(e.images),u=o(e.shapes),d=o(e.skeletons),f=o(e.animations),p=o(e.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),h.length>0&&(n.images=h),u.length>0&&(n.shapes=u),d.length>0&&(n.skeletons=d),f.length>0&&(n.animations=f),p.length>0&&(n.nodes=p)}return n.object=s,n;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){let s=e.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};tn.DEFAULT_UP=new F(0,1,0);tn.DEFAULT_MATRIX_AUTO_UPDATE=!0;tn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Rn=class extends tn{constructor(){super(),this.isGroup=!0,this.type="Group"}},ov={type:"move"},Ao=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Rn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Rn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new F,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new F),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Rn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new F,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new F,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let v of e.hand.values()){let g=t.getJointPose(v,n),m=this._getHandJoint(c,v);g!==null&&(m.matrix.fromArray(g.transform.matrix),m.matrix.decompose(m.position,m.quaternion,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=g.radius),m.visible=g!==null}let h=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],d=h.position.distanceTo(u.position),f=.02,p=.005;c.inputState.pinching&&d>f+p?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&d<=f-p&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(ov)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let n=new Rn;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}},n0={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},qs={h:0,s:0,l:0},Pl={h:0,s:0,l:0};function $u(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}var Qe=class{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=Sn){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,Mt.colorSpaceToWorking(this,t),this}setRGB(e,t,n,s=Mt.workingColorSpace){return this.r=e,this.g=t,this.b=n,Mt.colorSpaceToWorking(this,s),this}setHSL(e,t,n,s=Mt.workingColorSpace){if(e=Kd(e,1),t=_t(t,0,1),n=_t(n,0,1),t===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+t):n+t-n*t,o=2*n-r;this.r=$u(o,r,e+1/3),this.g=$u(o,r,e),this.b=$u(o,r,e-1/3)}return Mt.colorSpaceToWorking(this,s),this}setStyle(e,t=Sn){function n(r){r!==void 0&&parseFloat(r)<1&&Ke("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:Ke("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);Ke("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=Sn){let n=n0[e.toLowerCase()];return n!==void 0?this.setHex(n,t):Ke("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=ws(e.r),this.g=ws(e.g),this.b=ws(e.b),this}copyLinearToSRGB(e){return this.r=vo(e.r),this.g=vo(e.g),this.b=vo(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=Sn){return Mt.workingToColorSpace(Yn.copy(this),e),Math.round(_t(Yn.r*255,0,255))*65536+Math.round(_t(Yn.g*255,0,255))*256+Math.round(_t(Yn.b*255,0,255))}getHexString(e=Sn){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=Mt.workingColorSpace){Mt.workingToColorSpace(Yn.copy(this),t);let n=Yn.r,s=Yn.g,r=Yn.b,o=Math.max(n,s,r),a=Math.min(n,s,r),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let u=o-a;switch(c=h<=.5?u/(o+a):u/(2-o-a),o){case n:l=(s-r)/u+(s<r?6:0);break;case s:l=(r-n)/u+2;break;case r:l=(n-s)/u+4;break}l/=6}return e.h=l,e.s=c,e.l=h,e}getRGB(e,t=Mt.workingColorSpace){return Mt.workingToColorSpace(Yn.copy(this),t),e.r=Yn.r,e.g=Yn.g,e.b=Yn.b,e}getStyle(e=Sn){Mt.workingToColorSpace(Yn.copy(this),e);let t=Yn.r,n=Yn.g,s=Yn.b;return e!==Sn?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(e,t,n){return this.getHSL(qs),this.setHSL(qs.h+e,qs.s+t,qs.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(qs),e.getHSL(Pl);let n=pa(qs.h,Pl.h,t),s=pa(qs.s,Pl.s,t),r=pa(qs.l,Pl.l,t);return this.setHSL(n,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,n=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*n+r[6]*s,this.g=r[1]*t+r[4]*n+r[7]*s,this.b=r[2]*t+r[5]*n+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Yn=new Qe;Qe.NAMES=n0;var va=class i{constructor(e,t=1,n=1e3){this.isFog=!0,this.name="",this.color=new Qe(e),this.near=t,this.far=n}clone(){return new i(this.color,this.near,this.far)}toJSON(){return{type:"Fog",name:this.name,color:this.color.getHex(),near:this.near,far:this.far}}},ba=class extends tn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Ri,this.environmentIntensity=1,this.environmentRotation=new Ri,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},Oi=new F,ys=new F,Ku=new F,vs=new F,co=new F,ho=new F,Jm=new F,Ju=new F,ju=new F,Qu=new F,ed=new Xt,td=new Xt,nd=new Xt,Ss=class i{constructor(e=new F,t=new F,n=new F){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,s){s.subVectors(n,t),Oi.subVectors(e,t),s.cross(Oi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,n,s,r){Oi.subVectors(s,t),ys.subVectors(n,t),Ku.subVectors(e,t);let o=Oi.dot(Oi),a=Oi.dot(ys),l=Oi.dot(Ku),c=ys.dot(ys),h=ys.dot(Ku),u=o*c-a*a;if(u===0)return r.set(0,0,0),null;let d=1/u,f=(c*l-a*h)*d,p=(o*h-a*l)*d;return r.set(1-f-p,p,f)}static containsPoint(e,t,n,s){return this.getBarycoord(e,t,n,s,vs)===null?!1:vs.x>=0&&vs.y>=0&&vs.x+vs.y<=1}static getInterpolation(e,t,n,s,r,o,a,l){return this.getBarycoord(e,t,n,s,vs)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,vs.x),l.addScaledVector(o,vs.y),l.addScaledVector(a,vs.z),l)}static getInterpolatedAttribute(e,t,n,s,r,o){return ed.setScalar(0),td.setScalar(0),nd.setScalar(0),ed.fromBufferAttribute(e,t),td.fromBufferAttribute(e,n),nd.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(ed,r.x),o.addScaledVector(td,r.y),o.addScaledVector(nd,r.z),o}static isFrontFacing(e,t,n,s){return Oi.subVectors(n,t),ys.subVectors(e,t),Oi.cross(ys).dot(s)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,s){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,n,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Oi.subVectors(this.c,this.b),ys.subVectors(this.a,this.b),Oi.cross(ys).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return i.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return i.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,s,r){return i.getInterpolation(e,this.a,this.b,this.c,t,n,s,r)}containsPoint(e){return i.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return i.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,s=this.b,r=this.c,o,a;co.subVectors(s,n),ho.subVectors(r,n),Ju.subVectors(e,n);let l=co.dot(Ju),c=ho.dot(Ju);if(l<=0&&c<=0)return t.copy(n);ju.subVectors(e,s);let h=co.dot(ju),u=ho.dot(ju);if(h>=0&&u<=h)return t.copy(s);let d=l*u-h*c;if(d<=0&&l>=0&&h<=0&&l-h>0)return o=l/(l-h),t.copy(n).addScaledVector(co,o);Qu.subVectors(e,r);let f=co.dot(Qu),p=ho.dot(Qu);if(p>=0&&f<=p)return t.copy(r);let v=f*c-l*p;if(v<=0&&c>=0&&p<=0)return a=c/(c-p),t.copy(n).addScaledVector(ho,a);let g=h*p-f*u;if(g<=0&&u-h>=0&&f-p>=0)return Jm.subVectors(r,s),a=(u-h)/(u-h+(f-p)),t.copy(s).addScaledVector(Jm,a);let m=1/(g+v+d);return o=v*m,a=d*m,t.copy(n).addScaledVector(co,o).addScaledVector(ho,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},Ks=class{constructor(e=new F(1/0,1/0,1/0),t=new F(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(Bi.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(Bi.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=Bi.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let r=n.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Bi):Bi.fromBufferAttribute(r,o),Bi.applyMatrix4(e.matrixWorld),this.expandByPoint(Bi);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Il.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),Il.copy(n.boundingBox)),Il.applyMatrix4(e.matrixWorld),this.union(Il)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Bi),Bi.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(ca),Ll.subVectors(this.max,ca),uo.subVectors(e.a,ca),fo.subVectors(e.b,ca),po.subVectors(e.c,ca),Ys.subVectors(fo,uo),Zs.subVectors(po,fo),vr.subVectors(uo,po);let t=[0,-Ys.z,Ys.y,0,-Zs.z,Zs.y,0,-vr.z,vr.y,Ys.z,0,-Ys.x,Zs.z,0,-Zs.x,vr.z,0,-vr.x,-Ys.y,Ys.x,0,-Zs.y,Zs.x,0,-vr.y,vr.x,0];return!id(t,uo,fo,po,Ll)||(t=[1,0,0,0,1,0,0,0,1],!id(t,uo,fo,po,Ll))?!1:(Dl.crossVectors(Ys,Zs),t=[Dl.x,Dl.y,Dl.z],id(t,uo,fo,po,Ll))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Bi).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Bi).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(bs[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),bs[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),bs[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),bs[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),bs[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),bs[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),bs[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),bs[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(bs),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},bs=[new F,new F,new F,new F,new F,new F,new F,new F],Bi=new F,Il=new Ks,uo=new F,fo=new F,po=new F,Ys=new F,Zs=new F,vr=new F,ca=new F,Ll=new F,Dl=new F,br=new F;function id(i,e,t,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){br.fromArray(i,r);let a=s.x*Math.abs(br.x)+s.y*Math.abs(br.y)+s.z*Math.abs(br.z),l=e.dot(br),c=t.dot(br),h=n.dot(br);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var Mn=new F,Nl=new We,av=0,en=class extends ki{constructor(e,t,n=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:av++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=$g,this.updateRanges=[],this.gpuType=Gi,this.version=0,this._normalizationScale=e!==void 0?jd(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[n+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)Nl.fromBufferAttribute(this,t),Nl.applyMatrix3(e),this.setXY(t,Nl.x,Nl.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)Mn.fromBufferAttribute(this,t),Mn.applyMatrix3(e),this.setXYZ(t,Mn.x,Mn.y,Mn.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)Mn.fromBufferAttribute(this,t),Mn.applyMatrix4(e),this.setXYZ(t,Mn.x,Mn.y,Mn.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)Mn.fromBufferAttribute(this,t),Mn.applyNormalMatrix(e),this.setXYZ(t,Mn.x,Mn.y,Mn.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)Mn.fromBufferAttribute(this,t),Mn.transformDirection(e),this.setXYZ(t,Mn.x,Mn.y,Mn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):e0(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):t0(e,this.array)}};var Ma=class extends en{constructor(e,t,n){super(new Uint16Array(e),t,n)}};var Sa=class extends en{constructor(e,t,n){super(new Uint32Array(e),t,n)}};var Et=class extends en{constructor(e,t,n){super(new Float32Array(e),t,n)}},lv=new Ks,ha=new F,sd=new F,Js=class{constructor(e=new F,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t!==void 0?n.copy(t):lv.setFromPoints(e).getCenter(n);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,n.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;ha.subVectors(e,this.center);let t=ha.lengthSq();if(t>this.radius*this.radius){let n=Math.sqrt(t),s=(n-this.radius)*.5;this.center.addScaledVector(ha,s/n),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(sd.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(ha.copy(e.center).add(sd)),this.expandByPoint(ha.copy(e.center).sub(sd))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},cv=0,Ti=new wt,rd=new tn,mo=new F,yi=new Ks,ua=new Ks,On=new F,Pt=class i extends ki{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:cv++}),this.uuid=Oo(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(Ny(e)?Sa:Ma)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new st().getNormalMatrix(e);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Ti.makeRotationFromQuaternion(e),this.applyMatrix4(Ti),this}rotateX(e){return Ti.makeRotationX(e),this.applyMatrix4(Ti),this}rotateY(e){return Ti.makeRotationY(e),this.applyMatrix4(Ti),this}rotateZ(e){return Ti.makeRotationZ(e),this.applyMatrix4(Ti),this}translate(e,t,n){return Ti.makeTranslation(e,t,n),this.applyMatrix4(Ti),this}scale(e,t,n){return Ti.makeScale(e,t,n),this.applyMatrix4(Ti),this}lookAt(e){return rd.lookAt(e),rd.updateMatrix(),this.applyMatrix4(rd.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(mo).negate(),this.translate(mo.x,mo.y,mo.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let n=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Et(n,3))}else{let n=Math.min(e.length,t.count);for(let s=0;s<n;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&Ke("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Ks);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){nt("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new F(-1/0,-1/0,-1/0),new F(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,s=t.length;n<s;n++){let r=t[n];yi.setFromBufferAttribute(r),this.morphTargetsRelative?(On.addVectors(this.boundingBox.min,yi.min),this.boundingBox.expandByPoint(On),On.addVectors(this.boundingBox.max,yi.max),this.boundingBox.expandByPoint(On)):(this.boundingBox.expandByPoint(yi.min),this.boundingBox.expandByPoint(yi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&nt('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Js);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){nt("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new F,1/0);return}if(e){let n=this.boundingSphere.center;if(yi.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];ua.setFromBufferAttribute(a),this.morphTargetsRelative?(On.addVectors(yi.min,ua.min),yi.expandByPoint(On),On.addVectors(yi.max,ua.max),yi.expandByPoint(On)):(yi.expandByPoint(ua.min),yi.expandByPoint(ua.max))}yi.getCenter(n);let s=0;for(let r=0,o=e.count;r<o;r++)On.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(On));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)On.fromBufferAttribute(a,c),l&&(mo.fromBufferAttribute(e,c),On.add(mo)),s=Math.max(s,n.distanceToSquared(On))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&nt('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){nt("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new en(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(n.count);for(let O=0;O<n.count;O++)a[O]=new F,l[O]=new F;let h=new F,u=new F,d=new F,f=new We,p=new We,v=new We,g=new F,m=new F;function _(O,P,D){c[O]=c[P]=c[D]=1,h.fromBufferAttribute(n,O),u.fromBufferAttribute(n,P),d.fromBufferAttribute(n,D),f.fromBufferAttribute(r,O),p.fromBufferAttribute(r,P),v.fromBufferAttribute(r,D),u.sub(h),d.sub(h),p.sub(f),v.sub(f);let z=1/(p.x*v.y-v.x*p.y);isFinite(z)&&(g.copy(u).multiplyScalar(v.y).addScaledVector(d,-p.y).multiplyScalar(z),m.copy(d).multiplyScalar(p.x).addScaledVector(u,-v.x).multiplyScalar(z),a[O].add(g),a[P].add(g),a[D].add(g),l[O].add(m),l[P].add(m),l[D].add(m))}let E=this.groups;E.length===0&&(E=[{start:0,count:e.count}]);for(let O=0,P=E.length;O<P;++O){let D=E[O],z=D.start,W=D.count;for(let N=z,V=z+W;N<V;N+=3)_(e.getX(N+0),e.getX(N+1),e.getX(N+2))}let b=new F,C=new F,M=new F,x=new F;function w(O){M.fromBufferAttribute(s,O),x.copy(M);let P=a[O];b.copy(P),b.sub(M.multiplyScalar(M.dot(P))).normalize(),C.crossVectors(x,P);let z=C.dot(l[O])<0?-1:1;o.setXYZW(O,b.x,b.y,b.z,z)}for(let O=0,P=n.count;O<P;++O)c[O]&&w(O);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==t.count)n=new en(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let d=0,f=n.count;d<f;d++)n.setXYZ(d,0,0,0);let s=new F,r=new F,o=new F,a=new F,l=new F,c=new F,h=new F,u=new F;if(e)for(let d=0,f=e.count;d<f;d+=3){let p=e.getX(d+0),v=e.getX(d+1),g=e.getX(d+2);s.fromBufferAttribute(t,p),r.fromBufferAttribute(t,v),o.fromBufferAttribute(t,g),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),a.fromBufferAttribute(n,p),l.fromBufferAttribute(n,v),c.fromBufferAttribute(n,g),a.add(h),l.add(h),c.add(h),n.setXYZ(p,a.x,a.y,a.z),n.setXYZ(v,l.x,l.y,l.z),n.setXYZ(g,c.x,c.y,c.z)}else for(let d=0,f=t.count;d<f;d+=3)s.fromBufferAttribute(t,d+0),r.fromBufferAttribute(t,d+1),o.fromBufferAttribute(t,d+2),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),n.setXYZ(d+0,h.x,h.y,h.z),n.setXYZ(d+1,h.x,h.y,h.z),n.setXYZ(d+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)On.fromBufferAttribute(e,t),On.normalize(),e.setXYZ(t,On.x,On.y,On.z)}toNonIndexed(){function e(a,l){let c=a.array,h=a.itemSize,u=a.normalized,d=new c.constructor(l.length*h),f=0,p=0;for(let v=0,g=l.length;v<g;v++){a.isInterleavedBufferAttribute?f=l[v]*a.data.stride+a.offset:f=l[v]*h;for(let m=0;m<h;m++)d[p++]=c[f++]}return new en(d,h,u)}if(this.index===null)return Ke("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new i,n=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,n);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let h=0,u=c.length;h<u;h++){let d=c[h],f=e(d,n);l.push(f)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let l in n){let c=n[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let u=0,d=c.length;u<d;u++){let f=c[u];h.push(f.toJSON(e.data))}h.length>0&&(s[l]=h,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;n!==null&&this.setIndex(n.clone());let s=e.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(t))}let r=e.morphAttributes;for(let c in r){let h=[],u=r[c];for(let d=0,f=u.length;d<f;d++)h.push(u[d].clone(t));this.morphAttributes[c]=h}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,h=o.length;c<h;c++){let u=o[c];this.addGroup(u.start,u.count,u.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var od=new F,hv=new F,uv=new st,Hn=class{constructor(e=new F(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,s){return this.normal.set(e,t,n),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let s=od.subVectors(n,t).cross(hv.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,n=!0){let s=e.delta(od),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return n===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let n=t||uv.getNormalMatrix(e),s=this.coplanarPoint(od).applyMatrix4(e),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},dv=0,zi=class extends ki{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:dv++}),this.uuid=Oo(),this.name="",this.type="Material",this.blending=Do,this.side=rs,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Td,this.blendDst=Ad,this.blendEquation=Cr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Qe(0,0,0),this.blendAlpha=0,this.depthFunc=bo,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Vg,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=nc,this.stencilZFail=nc,this.stencilZPass=nc,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let n=e[t];if(n===void 0){Ke(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ke(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new Qe().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(n=>new Hn().fromJSON(n))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let n=e.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new We().fromArray(n)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new We().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,n=null;if(t!==null){let s=t.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=t[r].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var Ms=new F,ad=new F,Ul=new F,Fl=new F,Ts=class{constructor(e=new F,t=new F(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Ms)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=Ms.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Ms.copy(this.origin).addScaledVector(this.direction,t),Ms.distanceToSquared(e))}distanceSqToSegment(e,t,n,s){ad.copy(e).add(t).multiplyScalar(.5),Ul.copy(t).sub(e).normalize(),Fl.copy(this.origin).sub(ad);let r=e.distanceTo(t)*.5,o=-this.direction.dot(Ul),a=Fl.dot(this.direction),l=-Fl.dot(Ul),c=Fl.lengthSq(),h=Math.abs(1-o*o),u,d,f,p;if(h>0)if(u=o*l-a,d=o*a-l,p=r*h,u>=0)if(d>=-p)if(d<=p){let v=1/h;u*=v,d*=v,f=u*(u+o*d+2*a)+d*(o*u+d+2*l)+c}else d=r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;else d=-r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;else d<=-p?(u=Math.max(0,-(-o*r+a)),d=u>0?-r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c):d<=p?(u=0,d=Math.min(Math.max(-r,-l),r),f=d*(d+2*l)+c):(u=Math.max(0,-(o*r+a)),d=u>0?r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c);else d=o>0?-r:r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(ad).addScaledVector(Ul,d),f}intersectSphere(e,t){if(e.radius<0)return null;Ms.subVectors(e.center,this.origin);let n=Ms.dot(this.direction),s=Ms.dot(Ms)-n*n,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,s,r,o,a,l,c=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,d=this.origin;return c>=0?(n=(e.min.x-d.x)*c,s=(e.max.x-d.x)*c):(n=(e.max.x-d.x)*c,s=(e.min.x-d.x)*c),h>=0?(r=(e.min.y-d.y)*h,o=(e.max.y-d.y)*h):(r=(e.max.y-d.y)*h,o=(e.min.y-d.y)*h),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),u>=0?(a=(e.min.z-d.z)*u,l=(e.max.z-d.z)*u):(a=(e.max.z-d.z)*u,l=(e.min.z-d.z)*u),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,t)}intersectsBox(e){return this.intersectBox(e,Ms)!==null}intersectTriangle(e,t,n,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,h=a.z,u=e.x-o.x,d=e.y-o.y,f=e.z-o.z,p=t.x-o.x,v=t.y-o.y,g=t.z-o.z,m=n.x-o.x,_=n.y-o.y,E=n.z-o.z,b=Math.abs(l),C=Math.abs(c),M=Math.abs(h),x,w,O,P,D,z,W,N,V,Z,G,ce;if(b>=C&&b>=M?(O=l,z=u,V=p,ce=m,l>=0?(x=c,w=h,P=d,D=f,W=v,N=g,Z=_,G=E):(x=h,w=c,P=f,D=d,W=g,N=v,Z=E,G=_)):C>=M?(O=c,z=d,V=v,ce=_,c>=0?(x=h,w=l,P=f,D=u,W=g,N=p,Z=E,G=m):(x=l,w=h,P=u,D=f,W=p,N=g,Z=m,G=E)):(O=h,z=f,V=g,ce=E,h>=0?(x=l,w=c,P=u,D=d,W=p,N=v,Z=m,G=_):(x=c,w=l,P=d,D=u,W=v,N=p,Z=_,G=m)),O===0)return null;let Y=x/O,Q=w/O,ie=1/O,de=P-Y*z,fe=D-Q*z,ee=W-Y*V,ge=N-Q*V,ye=Z-Y*ce,Pe=G-Q*ce,we=ye*ge-Pe*ee,Ye=de*Pe-fe*ye,at=ee*fe-ge*de;if(s){if(we<0||Ye<0||at<0)return null}else if((we<0||Ye<0||at<0)&&(we>0||Ye>0||at>0))return null;let Xe=we+Ye+at;if(Xe===0)return null;let pt=ie*(we*z+Ye*V+at*ce);return(Xe>0?pt<0:pt>0)?null:this.at(pt/Xe,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},pn=class extends zi{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Qe(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ri,this.combine=Nc,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},jm=new wt,Mr=new Ts,Ol=new Js,Qm=new F,Bl=new F,kl=new F,zl=new F,ld=new F,Hl=new F,eg=new F,Gl=new F,Ce=class extends tn{constructor(e=new Pt,t=new pn){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){Hl.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=a[l],u=r[l];h!==0&&(ld.fromBufferAttribute(u,e),o?Hl.addScaledVector(ld,h):Hl.addScaledVector(ld.sub(t),h))}t.add(Hl)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),Ol.copy(n.boundingSphere),Ol.applyMatrix4(r),Mr.copy(e.ray).recast(e.near),!(Ol.containsPoint(Mr.origin)===!1&&(Mr.intersectSphere(Ol,Qm)===null||Mr.origin.distanceToSquared(Qm)>(e.far-e.near)**2))&&(jm.copy(r).invert(),Mr.copy(e.ray).applyMatrix4(jm),!(n.boundingBox!==null&&Mr.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,Mr)))}_computeIntersections(e,t,n){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,v=d.length;p<v;p++){let g=d[p],m=o[g.materialIndex],_=Math.max(g.start,f.start),E=Math.min(a.count,Math.min(g.start+g.count,f.start+f.count));for(let b=_,C=E;b<C;b+=3){let M=a.getX(b),x=a.getX(b+1),w=a.getX(b+2);s=Vl(this,m,e,n,c,h,u,M,x,w),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=g.materialIndex,t.push(s))}}else{let p=Math.max(0,f.start),v=Math.min(a.count,f.start+f.count);for(let g=p,m=v;g<m;g+=3){let _=a.getX(g),E=a.getX(g+1),b=a.getX(g+2);s=Vl(this,o,e,n,c,h,u,_,E,b),s&&(s.faceIndex=Math.floor(g/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let p=0,v=d.length;p<v;p++){let g=d[p],m=o[g.materialIndex],_=Math.max(g.start,f.start),E=Math.min(l.count,Math.min(g.start+g.count,f.start+f.count));for(let b=_,C=E;b<C;b+=3){let M=b,x=b+1,w=b+2;s=Vl(this,m,e,n,c,h,u,M,x,w),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=g.materialIndex,t.push(s))}}else{let p=Math.max(0,f.start),v=Math.min(l.count,f.start+f.count);for(let g=p,m=v;g<m;g+=3){let _=g,E=g+1,b=g+2;s=Vl(this,o,e,n,c,h,u,_,E,b),s&&(s.faceIndex=Math.floor(g/3),t.push(s))}}}};function fv(i,e,t,n,s,r,o,a){let l;if(e.side===Gn?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,e.side===rs,a),l===null)return null;Gl.copy(a),Gl.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(Gl);return c<t.near||c>t.far?null:{distance:c,point:Gl.clone(),object:i}}function Vl(i,e,t,n,s,r,o,a,l,c){i.getVertexPosition(a,Bl),i.getVertexPosition(l,kl),i.getVertexPosition(c,zl);let h=fv(i,e,t,n,Bl,kl,zl,eg);if(h){let u=new F;Ss.getBarycoord(eg,Bl,kl,zl,u),s&&(h.uv=Ss.getInterpolatedAttribute(s,a,l,c,u,new We)),r&&(h.uv1=Ss.getInterpolatedAttribute(r,a,l,c,u,new We)),o&&(h.normal=Ss.getInterpolatedAttribute(o,a,l,c,u,new F),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new F,materialIndex:0};Ss.getNormal(Bl,kl,zl,d.normal),h.face=d,h.barycoord=u}return h}var mc=class extends Zn{constructor(e=null,t=1,n=1,s,r,o,a,l,c=Bn,h=Bn,u,d){super(null,o,a,l,c,h,s,r,u,d),this.isDataTexture=!0,this.image={data:e,width:t,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Sr=new Js,pv=new We(.5,.5),Wl=new F,js=class{constructor(e=new Hn,t=new Hn,n=new Hn,s=new Hn,r=new Hn,o=new Hn){this.planes=[e,t,n,s,r,o]}set(e,t,n,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=Ai,n=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],h=r[4],u=r[5],d=r[6],f=r[7],p=r[8],v=r[9],g=r[10],m=r[11],_=r[12],E=r[13],b=r[14],C=r[15];if(s[0].setComponents(c-o,f-h,m-p,C-_).normalize(),s[1].setComponents(c+o,f+h,m+p,C+_).normalize(),s[2].setComponents(c+a,f+u,m+v,C+E).normalize(),s[3].setComponents(c-a,f-u,m-v,C-E).normalize(),n)s[4].setComponents(l,d,g,b).normalize(),s[5].setComponents(c-l,f-d,m-g,C-b).normalize();else if(s[4].setComponents(c-l,f-d,m-g,C-b).normalize(),t===Ai)s[5].setComponents(c+l,f+d,m+g,C+b).normalize();else if(t===Mo)s[5].setComponents(l,d,g,b).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),Sr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),Sr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(Sr)}intersectsSprite(e){Sr.center.set(0,0,0);let t=pv.distanceTo(e.center);return Sr.radius=.7071067811865476+t,Sr.applyMatrix4(e.matrixWorld),this.intersectsSphere(Sr)}intersectsSphere(e){let t=this.planes,n=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let s=t[n];if(Wl.x=s.normal.x>0?e.max.x:e.min.x,Wl.y=s.normal.y>0?e.max.y:e.min.y,Wl.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(Wl)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},tg=new wt,gc=class i{constructor(){this.coordinateSystem=Ai,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,n=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];tg.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new js),n[s].setFromProjectionMatrix(tg,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,n=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new js),t[s].copy(n[s]);return this._count=e._count,this}clone(){return new i().copy(this)}};var ss=class extends zi{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new Qe(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},_c=new F,xc=new F,ng=new wt,da=new Ts,Xl=new Js,cd=new F,ig=new F,oi=class extends tn{constructor(e=new Pt,t=new ss){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[0];for(let s=1,r=t.count;s<r;s++)_c.fromBufferAttribute(t,s-1),xc.fromBufferAttribute(t,s),n[s]=n[s-1],n[s]+=_c.distanceTo(xc);e.setAttribute("lineDistance",new Et(n,1))}else Ke("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Xl.copy(n.boundingSphere),Xl.applyMatrix4(s),Xl.radius+=r,e.ray.intersectsSphere(Xl)===!1)return;ng.copy(s).invert(),da.copy(e.ray).applyMatrix4(ng);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,h=n.index,d=n.attributes.position;if(h!==null){let f=Math.max(0,o.start),p=Math.min(h.count,o.start+o.count);for(let v=f,g=p-1;v<g;v+=c){let m=h.getX(v),_=h.getX(v+1),E=ql(this,e,da,l,m,_,v);E&&t.push(E)}if(this.isLineLoop){let v=h.getX(p-1),g=h.getX(f),m=ql(this,e,da,l,v,g,p-1);m&&t.push(m)}}else{let f=Math.max(0,o.start),p=Math.min(d.count,o.start+o.count);for(let v=f,g=p-1;v<g;v+=c){let m=ql(this,e,da,l,v,v+1,v);m&&t.push(m)}if(this.isLineLoop){let v=ql(this,e,da,l,p-1,f,p-1);v&&t.push(v)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function ql(i,e,t,n,s,r,o){let a=i.geometry.attributes.position;if(_c.fromBufferAttribute(a,s),xc.fromBufferAttribute(a,r),t.distanceSqToSegment(_c,xc,cd,ig)>n)return;cd.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(cd);if(!(c<e.near||c>e.far))return{distance:c,point:ig.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var sg=new F,rg=new F,wa=class extends oi{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[];for(let s=0,r=t.count;s<r;s+=2)sg.fromBufferAttribute(t,s),rg.fromBufferAttribute(t,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+sg.distanceTo(rg);e.setAttribute("lineDistance",new Et(n,1))}else Ke("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var Ro=class extends zi{constructor(e){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new Qe(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.alphaMap=e.alphaMap,this.size=e.size,this.sizeAttenuation=e.sizeAttenuation,this.fog=e.fog,this}},og=new wt,gd=new Ts,Yl=new Js,Zl=new F,Ea=class extends tn{constructor(e=new Pt,t=new Ro){super(),this.isPoints=!0,this.type="Points",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.matrixWorld,r=e.params.Points.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Yl.copy(n.boundingSphere),Yl.applyMatrix4(s),Yl.radius+=r,e.ray.intersectsSphere(Yl)===!1)return;og.copy(s).invert(),gd.copy(e.ray).applyMatrix4(og);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=n.index,u=n.attributes.position;if(c!==null){let d=Math.max(0,o.start),f=Math.min(c.count,o.start+o.count);for(let p=d,v=f;p<v;p++){let g=c.getX(p);Zl.fromBufferAttribute(u,g),ag(Zl,g,l,s,e,t,this)}}else{let d=Math.max(0,o.start),f=Math.min(u.count,o.start+o.count);for(let p=d,v=f;p<v;p++)Zl.fromBufferAttribute(u,p),ag(Zl,p,l,s,e,t,this)}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function ag(i,e,t,n,s,r,o){let a=gd.distanceSqToPoint(i);if(a<t){let l=new F;gd.closestPointToPoint(i,l),l.applyMatrix4(n);let c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:e,face:null,faceIndex:null,barycoord:null,object:o})}}var Ta=class extends Zn{constructor(e=[],t=Pr,n,s,r,o,a,l,c,h){super(e,t,n,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var As=class extends Zn{constructor(e,t,n=Hi,s,r,o,a=Bn,l=Bn,c,h=Es,u=1){if(h!==Es&&h!==Ls)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:e,height:t,depth:u};super(d,s,r,o,a,l,h,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Eo(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},Aa=class extends As{constructor(e,t=Hi,n=Pr,s,r,o=Bn,a=Bn,l,c=Es){let h={width:e,height:e,depth:1},u=[h,h,h,h,h,h];super(e,e,t,n,s,r,o,a,l,c),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},Ra=class extends Zn{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},Gt=class i extends Pt{constructor(e=1,t=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],h=[],u=[],d=0,f=0;p("z","y","x",-1,-1,n,t,e,o,r,0),p("z","y","x",1,-1,n,t,-e,o,r,1),p("x","z","y",1,1,e,n,t,s,o,2),p("x","z","y",1,-1,e,n,-t,s,o,3),p("x","y","z",1,-1,e,t,n,s,r,4),p("x","y","z",-1,-1,e,t,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new Et(c,3)),this.setAttribute("normal",new Et(h,3)),this.setAttribute("uv",new Et(u,2));function p(v,g,m,_,E,b,C,M,x,w,O){let P=b/x,D=C/w,z=b/2,W=C/2,N=M/2,V=x+1,Z=w+1,G=0,ce=0,Y=new F;for(let Q=0;Q<Z;Q++){let ie=Q*D-W;for(let de=0;de<V;de++){let fe=de*P-z;Y[v]=fe*_,Y[g]=ie*E,Y[m]=N,c.push(Y.x,Y.y,Y.z),Y[v]=0,Y[g]=0,Y[m]=M>0?1:-1,h.push(Y.x,Y.y,Y.z),u.push(de/x),u.push(1-Q/w),G+=1}}for(let Q=0;Q<w;Q++)for(let ie=0;ie<x;ie++){let de=d+ie+V*Q,fe=d+ie+V*(Q+1),ee=d+(ie+1)+V*(Q+1),ge=d+(ie+1)+V*Q;l.push(de,fe,ge),l.push(fe,ee,ge),ce+=6}a.addGroup(f,ce,O),f+=ce,d+=G}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}},Ca=class i extends Pt{constructor(e=1,t=1,n=4,s=8,r=1){super(),this.type="CapsuleGeometry",this.parameters={radius:e,height:t,capSegments:n,radialSegments:s,heightSegments:r},t=Math.max(0,t),n=Math.max(1,Math.floor(n)),s=Math.max(3,Math.floor(s)),r=Math.max(1,Math.floor(r));let o=[],a=[],l=[],c=[],h=t/2,u=Math.PI/2*e,d=t,f=2*u+d,p=n*2+r,v=s+1,g=new F,m=new F;for(let _=0;_<=p;_++){let E=0,b=0,C=0,M=0;if(_<=n){let O=_/n,P=O*Math.PI/2;b=-h-e*Math.cos(P),C=e*Math.sin(P),M=-e*Math.cos(P),E=O*u}else if(_<=n+r){let O=(_-n)/r;b=-h+O*t,C=e,M=0,E=u+O*d}else{let O=(_-n-r)/n,P=O*Math.PI/2;b=h+e*Math.sin(P),C=e*Math.cos(P),M=e*Math.sin(P),E=u+d+O*u}let x=Math.max(0,Math.min(1,E/f)),w=0;_===0?w=.5/s:_===p&&(w=-.5/s);for(let O=0;O<=s;O++){let P=O/s,D=P*Math.PI*2,z=Math.sin(D),W=Math.cos(D);m.x=-C*W,m.y=b,m.z=C*z,a.push(m.x,m.y,m.z),g.set(-C*W,M,C*z),g.normalize(),l.push(g.x,g.y,g.z),c.push(P+w,x)}if(_>0){let O=(_-1)*v;for(let P=0;P<s;P++){let D=O+P,z=O+P+1,W=_*v+P,N=_*v+P+1;o.push(D,z,W),o.push(z,N,W)}}}this.setIndex(o),this.setAttribute("position",new Et(a,3)),this.setAttribute("normal",new Et(l,3)),this.setAttribute("uv",new Et(c,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.height,e.capSegments,e.radialSegments,e.heightSegments)}};var hn=class i extends Pt{constructor(e=1,t=1,n=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:n,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let h=[],u=[],d=[],f=[],p=0,v=[],g=n/2,m=0;_(),o===!1&&(e>0&&E(!0),t>0&&E(!1)),this.setIndex(h),this.setAttribute("position",new Et(u,3)),this.setAttribute("normal",new Et(d,3)),this.setAttribute("uv",new Et(f,2));function _(){let b=new F,C=new F,M=0,x=(t-e)/n;for(let w=0;w<=r;w++){let O=[],P=w/r,D=P*(t-e)+e;for(let z=0;z<=s;z++){let W=z/s,N=W*l+a,V=Math.sin(N),Z=Math.cos(N);C.x=D*V,C.y=-P*n+g,C.z=D*Z,u.push(C.x,C.y,C.z),b.set(V,x,Z).normalize(),d.push(b.x,b.y,b.z),f.push(W,1-P),O.push(p++)}v.push(O)}for(let w=0;w<s;w++)for(let O=0;O<r;O++){let P=v[O][w],D=v[O+1][w],z=v[O+1][w+1],W=v[O][w+1];(e>0||O!==0)&&(h.push(P,D,W),M+=3),(t>0||O!==r-1)&&(h.push(D,z,W),M+=3)}c.addGroup(m,M,0),m+=M}function E(b){let C=p,M=new We,x=new F,w=0,O=b===!0?e:t,P=b===!0?1:-1;for(let z=1;z<=s;z++)u.push(0,g*P,0),d.push(0,P,0),f.push(.5,.5),p++;let D=p;for(let z=0;z<=s;z++){let N=z/s*l+a,V=Math.cos(N),Z=Math.sin(N);x.x=O*Z,x.y=g*P,x.z=O*V,u.push(x.x,x.y,x.z),d.push(0,P,0),M.x=V*.5+.5,M.y=Z*.5*P+.5,f.push(M.x,M.y),p++}for(let z=0;z<s;z++){let W=C+z,N=D+z;b===!0?h.push(N,N+1,W):h.push(N+1,N,W),w+=3}c.addGroup(m,w,b===!0?1:2),m+=w}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var Pa=class i extends Pt{constructor(e=[],t=[],n=1,s=0){super(),this.type="PolyhedronGeometry",this.parameters={vertices:e,indices:t,radius:n,detail:s};let r=[],o=[];a(s),c(n),h(),this.setAttribute("position",new Et(r,3)),this.setAttribute("normal",new Et(r.slice(),3)),this.setAttribute("uv",new Et(o,2)),s===0?this.computeVertexNormals():this.normalizeNormals();function a(_){let E=new F,b=new F,C=new F;for(let M=0;M<t.length;M+=3)f(t[M+0],E),f(t[M+1],b),f(t[M+2],C),l(E,b,C,_)}function l(_,E,b,C){let M=C+1,x=[];for(let w=0;w<=M;w++){x[w]=[];let O=_.clone().lerp(b,w/M),P=E.clone().lerp(b,w/M),D=M-w;for(let z=0;z<=D;z++)z===0&&w===M?x[w][z]=O:x[w][z]=O.clone().lerp(P,z/D)}for(let w=0;w<M;w++)for(let O=0;O<2*(M-w)-1;O++){let P=Math.floor(O/2);O%2===0?(d(x[w][P+1]),d(x[w+1][P]),d(x[w][P])):(d(x[w][P+1]),d(x[w+1][P+1]),d(x[w+1][P]))}}function c(_){let E=new F;for(let b=0;b<r.length;b+=3)E.x=r[b+0],E.y=r[b+1],E.z=r[b+2],E.normalize().multiplyScalar(_),r[b+0]=E.x,r[b+1]=E.y,r[b+2]=E.z}function h(){let _=new F;for(let E=0;E<r.length;E+=3){_.x=r[E+0],_.y=r[E+1],_.z=r[E+2];let b=g(_)/2/Math.PI+.5,C=m(_)/Math.PI+.5;o.push(b,1-C)}p(),u()}function u(){for(let _=0;_<o.length;_+=6){let E=o[_+0],b=o[_+2],C=o[_+4],M=Math.max(E,b,C),x=Math.min(E,b,C);M>.9&&x<.1&&(E<.2&&(o[_+0]+=1),b<.2&&(o[_+2]+=1),C<.2&&(o[_+4]+=1))}}function d(_){r.push(_.x,_.y,_.z)}function f(_,E){let b=_*3;E.x=e[b+0],E.y=e[b+1],E.z=e[b+2]}function p(){let _=new F,E=new F,b=new F,C=new F,M=new We,x=new We,w=new We;for(let O=0,P=0;O<r.length;O+=9,P+=6){_.set(r[O+0],r[O+1],r[O+2]),E.set(r[O+3],r[O+4],r[O+5]),b.set(r[O+6],r[O+7],r[O+8]),M.set(o[P+0],o[P+1]),x.set(o[P+2],o[P+3]),w.set(o[P+4],o[P+5]),C.copy(_).add(E).add(b).divideScalar(3);let D=g(C);v(M,P+0,_,D),v(x,P+2,E,D),v(w,P+4,b,D)}}function v(_,E,b,C){C<0&&_.x===1&&(o[E]=_.x-1),b.x===0&&b.z===0&&(o[E]=C/2/Math.PI+.5)}function g(_){return Math.atan2(_.z,-_.x)}function m(_){return Math.atan2(-_.y,Math.sqrt(_.x*_.x+_.z*_.z))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.vertices,e.indices,e.radius,e.detail)}};var $l=new F,Kl=new F,hd=new F,Jl=new Ss,Ia=class extends Pt{constructor(e=null,t=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:e,thresholdAngle:t},e!==null){let s=Math.pow(10,4),r=Math.cos(yo*t),o=e.getIndex(),a=e.getAttribute("position"),l=o?o.count:a.count,c=[0,0,0],h=["a","b","c"],u=new Array(3),d=new Map,f=[];for(let p=0;p<l;p+=3){o?(c[0]=o.getX(p),c[1]=o.getX(p+1),c[2]=o.getX(p+2)):(c[0]=p,c[1]=p+1,c[2]=p+2);let{a:v,b:g,c:m}=Jl;if(v.fromBufferAttribute(a,c[0]),g.fromBufferAttribute(a,c[1]),m.fromBufferAttribute(a,c[2]),Jl.getNormal(hd),u[0]=`${Math.round(v.x*s)},${Math.round(v.y*s)},${Math.round(v.z*s)}`,u[1]=`${Math.round(g.x*s)},${Math.round(g.y*s)},${Math.round(g.z*s)}`,u[2]=`${Math.round(m.x*s)},${Math.round(m.y*s)},${Math.round(m.z*s)}`,!(u[0]===u[1]||u[1]===u[2]||u[2]===u[0]))for(let _=0;_<3;_++){let E=(_+1)%3,b=u[_],C=u[E],M=Jl[h[_]],x=Jl[h[E]],w=`${b}_${C}`,O=`${C}_${b}`,P=d.get(O);P?(hd.dot(P.normal)<=r&&(f.push(M.x,M.y,M.z),f.push(x.x,x.y,x.z)),d.set(O,null)):d.has(w)||d.set(w,{index0:c[_],index1:c[E],normal:hd.clone()})}}for(let p of d.values())if(p){let{index0:v,index1:g}=p;$l.fromBufferAttribute(a,v),Kl.fromBufferAttribute(a,g),f.push($l.x,$l.y,$l.z),f.push(Kl.x,Kl.y,Kl.z)}this.setAttribute("position",new Et(f,3))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}};var La=class i extends Pa{constructor(e=1,t=0){let n=(1+Math.sqrt(5))/2,s=[-1,n,0,1,n,0,-1,-n,0,1,-n,0,0,-1,n,0,1,n,0,-1,-n,0,1,-n,n,0,-1,n,0,1,-n,0,-1,-n,0,1],r=[0,11,5,0,5,1,0,1,7,0,7,10,0,10,11,1,5,9,5,11,4,11,10,2,10,7,6,7,1,8,3,9,4,3,4,2,3,2,6,3,6,8,3,8,9,4,9,5,2,4,11,6,2,10,8,6,7,9,8,1];super(s,r,e,t),this.type="IcosahedronGeometry",this.parameters={radius:e,detail:t}}static fromJSON(e){return new i(e.radius,e.detail)}};var Qs=class i extends Pa{constructor(e=1,t=0){let n=[1,0,0,-1,0,0,0,1,0,0,-1,0,0,0,1,0,0,-1],s=[0,2,4,0,4,3,0,3,5,0,5,2,1,2,5,1,5,3,1,3,4,1,4,2];super(n,s,e,t),this.type="OctahedronGeometry",this.parameters={radius:e,detail:t}}static fromJSON(e){return new i(e.radius,e.detail)}},Rs=class i extends Pt{constructor(e=1,t=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(n),l=Math.floor(s),c=a+1,h=l+1,u=e/a,d=t/l,f=[],p=[],v=[],g=[];for(let m=0;m<h;m++){let _=m*d-o;for(let E=0;E<c;E++){let b=E*u-r;p.push(b,-_,0),v.push(0,0,1),g.push(E/a),g.push(1-m/l)}}for(let m=0;m<l;m++)for(let _=0;_<a;_++){let E=_+c*m,b=_+c*(m+1),C=_+1+c*(m+1),M=_+1+c*m;f.push(E,b,M),f.push(b,C,M)}this.setIndex(f),this.setAttribute("position",new Et(p,3)),this.setAttribute("normal",new Et(v,3)),this.setAttribute("uv",new Et(g,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.widthSegments,e.heightSegments)}};var $n=class i extends Pt{constructor(e=1,t=32,n=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:n,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),n=Math.max(2,Math.floor(n));let l=Math.min(o+a,Math.PI),c=0,h=[],u=new F,d=new F,f=[],p=[],v=[],g=[];for(let m=0;m<=n;m++){let _=[],E=m/n,b=o+E*a,C=e*Math.cos(b),M=Math.sqrt(e*e-C*C),x=0;m===0&&o===0?x=.5/t:m===n&&l===Math.PI&&(x=-.5/t);for(let w=0;w<=t;w++){let O=w/t,P=s+O*r;u.x=-M*Math.cos(P),u.y=C,u.z=M*Math.sin(P),p.push(u.x,u.y,u.z),d.copy(u).normalize(),v.push(d.x,d.y,d.z),g.push(O+x,1-E),_.push(c++)}h.push(_)}for(let m=0;m<n;m++)for(let _=0;_<t;_++){let E=h[m][_+1],b=h[m][_],C=h[m+1][_],M=h[m+1][_+1];(m!==0||o>0)&&f.push(E,b,M),(m!==n-1||l<Math.PI)&&f.push(b,C,M)}this.setIndex(f),this.setAttribute("position",new Et(p,3)),this.setAttribute("normal",new Et(v,3)),this.setAttribute("uv",new Et(g,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};var Cs=class i extends Pt{constructor(e=1,t=.4,n=12,s=48,r=Math.PI*2,o=0,a=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:e,tube:t,radialSegments:n,tubularSegments:s,arc:r,thetaStart:o,thetaLength:a},n=Math.floor(n),s=Math.floor(s);let l=[],c=[],h=[],u=[],d=new F,f=new F,p=new F;for(let v=0;v<=n;v++){let g=o+v/n*a;for(let m=0;m<=s;m++){let _=m/s*r;f.x=(e+t*Math.cos(g))*Math.cos(_),f.y=(e+t*Math.cos(g))*Math.sin(_),f.z=t*Math.sin(g),c.push(f.x,f.y,f.z),d.x=e*Math.cos(_),d.y=e*Math.sin(_),p.subVectors(f,d).normalize(),h.push(p.x,p.y,p.z),u.push(m/s),u.push(v/n)}}for(let v=1;v<=n;v++)for(let g=1;g<=s;g++){let m=(s+1)*v+g-1,_=(s+1)*(v-1)+g-1,E=(s+1)*(v-1)+g,b=(s+1)*v+g;l.push(m,_,b),l.push(_,E,b)}this.setIndex(l),this.setAttribute("position",new Et(c,3)),this.setAttribute("normal",new Et(h,3)),this.setAttribute("uv",new Et(u,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.tube,e.radialSegments,e.tubularSegments,e.arc,e.thetaStart,e.thetaLength)}};function Lr(i){let e={};for(let t in i){e[t]={};for(let n in i[t]){let s=i[t][n];if(lg(s))s.isRenderTargetTexture?(Ke("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=s.clone();else if(Array.isArray(s))if(lg(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][n]=r}else e[t][n]=s.slice();else e[t][n]=s}}return e}function Jn(i){let e={};for(let t=0;t<i.length;t++){let n=Lr(i[t]);for(let s in n)e[s]=n[s]}return e}function lg(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function mv(i){let e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function Qd(i){let e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:Mt.workingColorSpace}var i0={clone:Lr,merge:Jn},gv=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,_v=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Ci=class extends zi{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=gv,this.fragmentShader=_v,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Lr(e.uniforms),this.uniformsGroups=mv(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let n in e.uniforms){let s=e.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=t[s.value]||null;break;case"c":this.uniforms[n].value=new Qe().setHex(s.value);break;case"v2":this.uniforms[n].value=new We().fromArray(s.value);break;case"v3":this.uniforms[n].value=new F().fromArray(s.value);break;case"v4":this.uniforms[n].value=new Xt().fromArray(s.value);break;case"m3":this.uniforms[n].value=new st().fromArray(s.value);break;case"m4":this.uniforms[n].value=new wt().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let n in e.extensions)this.extensions[n]=e.extensions[n];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},yc=class extends Ci{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}},Er=class extends zi{constructor(e){super(),this.isMeshStandardMaterial=!0,this.type="MeshStandardMaterial",this.defines={STANDARD:""},this.color=new Qe(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Qe(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Ya,this.normalScale=new We(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ri,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.defines={STANDARD:""},this.color.copy(e.color),this.roughness=e.roughness,this.metalness=e.metalness,this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.roughnessMap=e.roughnessMap,this.metalnessMap=e.metalnessMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.envMapIntensity=e.envMapIntensity,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}};var Da=class extends zi{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new Qe(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Qe(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Ya,this.normalScale=new We(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ri,this.combine=Nc,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},vc=class extends zi{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Hg,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},bc=class extends zi{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function go(i,e){return!i||i.constructor===e?i:typeof e.BYTES_PER_ELEMENT=="number"?new e(i):Array.prototype.slice.call(i)}function jl(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var er=class{constructor(e,t,n,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(n),this.sampleValues=t,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,s=t[n],r=t[n-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=n+2;;){if(s===void 0){if(e<r)break i;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=t[++n],e<s)break e}o=t.length;break t}if(!(e>=r)){let a=t[1];e<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=t[--n-1],e>=r)break e}o=n,n=0;break t}break n}for(;n<o;){let a=n+o>>>1;e<t[a]?o=a:n=a+1}if(s=t[n],r=t[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=n[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Mc=class extends er{constructor(e,t,n,s){super(e,t,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:fd,endingEnd:fd}}intervalChanged_(e,t,n){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case pd:r=e,a=2*t-n;break;case md:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case pd:o=e,l=2*n-t;break;case md:o=1,l=n+s[1]-s[0];break;default:o=e-1,l=t}let c=(n-t)*.5,h=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-n),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=this._offsetPrev,u=this._offsetNext,d=this._weightPrev,f=this._weightNext,p=(n-t)/(s-t),v=p*p,g=v*p,m=-d*g+2*d*v-d*p,_=(1+d)*g+(-1.5-2*d)*v+(-.5+d)*p+1,E=(-1-f)*g+(1.5+f)*v+.5*p,b=f*g-f*v;for(let C=0;C!==a;++C)r[C]=m*o[h+C]+_*o[c+C]+E*o[l+C]+b*o[u+C];return r}},Sc=class extends er{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=(n-t)/(s-t),u=1-h;for(let d=0;d!==a;++d)r[d]=o[c+d]*u+o[l+d]*h;return r}},wc=class extends er{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e){return this.copySampleValue_(e-1)}},Ec=class extends er{interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=this.inTangents,u=this.outTangents;if(!h||!u){let p=(n-t)/(s-t),v=1-p;for(let g=0;g!==a;++g)r[g]=o[c+g]*v+o[l+g]*p;return r}let d=a*2,f=e-1;for(let p=0;p!==a;++p){let v=o[c+p],g=o[l+p],m=f*d+p*2,_=u[m],E=u[m+1],b=e*d+p*2,C=h[b],M=h[b+1],x=yv(n,t,_,C,s);r[p]=s0(x,v,E,M,g)}return r}};function s0(i,e,t,n,s){let r=1-i;return r*r*r*e+3*r*r*i*t+3*r*i*i*n+i*i*i*s}function xv(i,e,t,n,s){let r=1-i;return 3*r*r*(t-e)+6*r*i*(n-t)+3*i*i*(s-n)}function yv(i,e,t,n,s){let r=(i-e)/(s-e);for(let o=0;o<8;o++){let a=s0(r,e,t,n,s)-i;if(Math.abs(a)<1e-10)break;let l=xv(r,e,t,n,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var bi=class{constructor(e,t,n,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=go(t,this.TimeBufferType),this.values=go(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.toJSON(e);else{n={name:e.name,times:go(e.times,Array),values:go(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(n.interpolation=s),jl(e.settings)&&(n.settings={inTangents:go(e.settings.inTangents,Array),outTangents:go(e.settings.outTangents,Array)})}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){return new wc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new Sc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new Mc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new Ec(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case ma:t=this.InterpolantFactoryMethodDiscrete;break;case uc:t=this.InterpolantFactoryMethodLinear;break;case tc:t=this.InterpolantFactoryMethodSmooth;break;case dd:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return Ke("KeyframeTrack:",n),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return ma;case this.InterpolantFactoryMethodLinear:return uc;case this.InterpolantFactoryMethodSmooth:return tc;case this.InterpolantFactoryMethodBezier:return dd}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]+=e;jl(this.settings)&&(cg(this.settings.inTangents,e),cg(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]*=e;jl(this.settings)&&(hg(this.settings.inTangents,e),hg(this.settings.outTangents,e))}return this}trim(e,t){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<e;)++r;for(;o!==-1&&n[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(nt("KeyframeTrack: Invalid value size in track.",this),e=!1);let n=this.times,s=this.values,r=n.length;r===0&&(nt("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){nt("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){nt("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&Uy(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){nt("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===tc,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],h=e[a+1];if(c!==h&&(a!==1||c!==e[0]))if(s)l=!0;else{let u=a*n,d=u-n,f=u+n;for(let p=0;p!==n;++p){let v=t[u+p];if(v!==t[d+p]||v!==t[f+p]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let u=a*n,d=o*n;for(let f=0;f!==n;++f)t[d+f]=t[u+f]}++o}}if(r>0){e[o]=e[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*n)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),n=this.constructor,s=new n(this.name,e,t);return s.createInterpolant=this.createInterpolant,jl(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function cg(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]+=e}function hg(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]*=e}bi.prototype.ValueTypeName="";bi.prototype.TimeBufferType=Float32Array;bi.prototype.ValueBufferType=Float32Array;bi.prototype.DefaultInterpolation=uc;var tr=class extends bi{constructor(e,t,n){super(e,t,n)}};tr.prototype.ValueTypeName="bool";tr.prototype.ValueBufferType=Array;tr.prototype.DefaultInterpolation=ma;tr.prototype.InterpolantFactoryMethodLinear=void 0;tr.prototype.InterpolantFactoryMethodSmooth=void 0;var Tc=class extends bi{constructor(e,t,n,s){super(e,t,n,s)}};Tc.prototype.ValueTypeName="color";var Ac=class extends bi{constructor(e,t,n,s){super(e,t,n,s)}};Ac.prototype.ValueTypeName="number";var Rc=class extends er{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-t)/(s-t),c=e*a;for(let h=c+a;c!==h;c+=4)ct.slerpFlat(r,0,o,c-a,o,c,l);return r}},Na=class extends bi{constructor(e,t,n,s){super(e,t,n,s)}InterpolantFactoryMethodLinear(e){return new Rc(this.times,this.values,this.getValueSize(),e)}};Na.prototype.ValueTypeName="quaternion";Na.prototype.InterpolantFactoryMethodSmooth=void 0;var nr=class extends bi{constructor(e,t,n){super(e,t,n)}};nr.prototype.ValueTypeName="string";nr.prototype.ValueBufferType=Array;nr.prototype.DefaultInterpolation=ma;nr.prototype.InterpolantFactoryMethodLinear=void 0;nr.prototype.InterpolantFactoryMethodSmooth=void 0;var Cc=class extends bi{constructor(e,t,n,s){super(e,t,n,s)}};Cc.prototype.ValueTypeName="vector";var Pc=class{constructor(e,t,n){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=n,this._abortController=null,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,u){return c.push(h,u),this},this.removeHandler=function(h){let u=c.indexOf(h);return u!==-1&&c.splice(u,2),this},this.getHandler=function(h){for(let u=0,d=c.length;u<d;u+=2){let f=c[u],p=c[u+1];if(f.global&&(f.lastIndex=0),f.test(h))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},r0=new Pc,Ic=class{constructor(e){this.manager=e!==void 0?e:r0,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let n=this;return new Promise(function(s,r){n.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};Ic.DEFAULT_MATERIAL_NAME="__DEFAULT";var Ua=class extends tn{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new Qe(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}},Fa=class extends Ua{constructor(e,t,n){super(e,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(tn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new Qe(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}toJSON(e){let t=super.toJSON(e);return t.object.groundColor=this.groundColor.getHex(),t}},ud=new wt,ug=new F,dg=new F,Lc=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new We(512,512),this.mapType=ci,this.map=null,this.mapPass=null,this.matrix=new wt,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new js,this._frameExtents=new We(1,1),this._viewportCount=1,this._viewports=[new Xt(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;ug.setFromMatrixPosition(e.matrixWorld),t.position.copy(ug),dg.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(dg),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,n,s){ud.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),n.setFromProjectionMatrix(ud,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;e.coordinateSystem===Mo||e.reversedDepth?t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),t.multiply(ud)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},Ql=new F,ec=new ct,ns=new F,Oa=class extends tn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new wt,this.projectionMatrix=new wt,this.projectionMatrixInverse=new wt,this.coordinateSystem=Ai,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(Ql,ec,ns),ns.x===1&&ns.y===1&&ns.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Ql,ec,ns.set(1,1,1)).invert()}updateWorldMatrix(e,t,n=!1){super.updateWorldMatrix(e,t,n),this.matrixWorld.decompose(Ql,ec,ns),ns.x===1&&ns.y===1&&ns.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Ql,ec,ns.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},$s=new F,fg=new We,pg=new We,si=class extends Oa{constructor(e=50,t=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=wo*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(yo*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return wo*2*Math.atan(Math.tan(yo*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){$s.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set($s.x,$s.y).multiplyScalar(-e/$s.z),$s.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set($s.x,$s.y).multiplyScalar(-e/$s.z)}getViewSize(e,t){return this.getViewBounds(e,fg,pg),t.subVectors(pg,fg)}setViewOffset(e,t,n,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(yo*.5*this.fov)/this.zoom,n=2*t,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var Ba=class extends Oa{constructor(e=-1,t=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-e,o=n+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},_d=class extends Lc{constructor(){super(new Ba(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Co=class extends Ua{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(tn.DEFAULT_UP),this.updateMatrix(),this.target=new tn,this.shadow=new _d}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}};var _o=-90,xo=1,Po=class extends tn{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new si(_o,xo,e,t);s.layers=this.layers,this.add(s);let r=new si(_o,xo,e,t);r.layers=this.layers,this.add(r);let o=new si(_o,xo,e,t);o.layers=this.layers,this.add(o);let a=new si(_o,xo,e,t);a.layers=this.layers,this.add(a);let l=new si(_o,xo,e,t);l.layers=this.layers,this.add(l);let c=new si(_o,xo,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[n,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===Ai)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===Mo)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,h]=this.children,u=e.getRenderTarget(),d=e.getActiveCubeFace(),f=e.getActiveMipmapLevel(),p=e.xr.enabled;e.xr.enabled=!1;let v=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let g=!1;e.isWebGLRenderer===!0?g=e.state.buffers.depth.getReversed():g=e.reversedDepthBuffer,e.setRenderTarget(n,0,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(n,1,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(n,2,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(n,3,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(n,4,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),n.texture.mipmapsAutoUpdate=v,e.setRenderTarget(n,5,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,h),e.setRenderTarget(u,d,f),e.xr.enabled=p,n.texture.needsPMREMUpdate=!0}},Dc=class extends si{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var ef="\\[\\]\\.:\\/",vv=new RegExp("["+ef+"]","g"),tf="[^"+ef+"]",bv="[^"+ef.replace("\\.","")+"]",Mv=/((?:WC+[\/:])*)/.source.replace("WC",tf),Sv=/(WCOD+)?/.source.replace("WCOD",bv),wv=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",tf),Ev=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",tf),Tv=new RegExp("^"+Mv+Sv+wv+Ev+"$"),Av=["material","materials","bones","map"],xd=class{constructor(e,t,n){let s=n||Jt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},Jt=class i{constructor(e,t,n){this.path=t,this.parsedPath=n||i.parseTrackName(t),this.node=i.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,n){return e&&e.isAnimationObjectGroup?new i.Composite(e,t,n):new i(e,t,n)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(vv,"")}static parseTrackName(e){let t=Tv.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);Av.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return n}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);if(n!==void 0)return n}if(e.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=n(a.children);if(l)return l}return null},s=n(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)e[t++]=n[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,n=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=i.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Ke("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=t.objectIndex;switch(n){case"materials":if(!e.material){nt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){nt("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){nt("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let h=0;h<e.length;h++)if(e[h].name===c){c=h;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){nt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){nt("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[n]===void 0){nt("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[n]}if(c!==void 0){if(e[c]===void 0){nt("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;nt("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){nt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){nt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Jt.Composite=xd;Jt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Jt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Jt.prototype.GetterByBindingType=[Jt.prototype._getValue_direct,Jt.prototype._getValue_array,Jt.prototype._getValue_arrayElement,Jt.prototype._getValue_toArray];Jt.prototype.SetterByBindingTypeAndVersioning=[[Jt.prototype._setValue_direct,Jt.prototype._setValue_direct_setNeedsUpdate,Jt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Jt.prototype._setValue_array,Jt.prototype._setValue_array_setNeedsUpdate,Jt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Jt.prototype._setValue_arrayElement,Jt.prototype._setValue_arrayElement_setNeedsUpdate,Jt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Jt.prototype._setValue_fromArray,Jt.prototype._setValue_fromArray_setNeedsUpdate,Jt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var H1=new Float32Array(1);var mg=new wt,Ps=class{constructor(e,t,n=0,s=1/0){this.ray=new Ts(e,t),this.near=n,this.far=s,this.camera=null,this.layers=new To,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(e,t){this.ray.set(e,t)}setFromCamera(e,t){t.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(e.x,e.y,.5).unproject(t).sub(this.ray.origin).normalize(),this.camera=t):t.isOrthographicCamera?(this.ray.origin.set(e.x,e.y,t.projectionMatrix.elements[14]).unproject(t),this.ray.direction.set(0,0,-1).transformDirection(t.matrixWorld),this.camera=t):nt("Raycaster: Unsupported camera type: "+t.type)}setFromXRController(e){return mg.identity().extractRotation(e.matrixWorld),this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(mg),this}intersectObject(e,t=!0,n=[]){return yd(e,this,n,t),n.sort(gg),n}intersectObjects(e,t=!0,n=[]){for(let s=0,r=e.length;s<r;s++)yd(e[s],this,n,t);return n.sort(gg),n}};function gg(i,e){return i.distance-e.distance}function yd(i,e,t,n){let s=!0;if(i.layers.test(e.layers)&&i.raycast(e,t)===!1&&(s=!1),s===!0&&n===!0){let r=i.children;for(let o=0,a=r.length;o<a;o++)yd(r[o],e,t,!0)}}var Io=class{constructor(e=1,t=0,n=0){this.radius=e,this.phi=t,this.theta=n}set(e,t,n){return this.radius=e,this.phi=t,this.theta=n,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=_t(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,n){return this.radius=Math.sqrt(e*e+t*t+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,n),this.phi=Math.acos(_t(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var vd=class{static{this.prototype.isMatrix2=!0}constructor(e,t,n,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let n=0;n<4;n++)this.elements[n]=e[n+t];return this}set(e,t,n,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=n,r[3]=s,this}};var Tr=class extends ki{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function nf(i,e,t,n){let s=Rv(n);switch(t){case kd:return i*e;case Hd:return i*e/s.components*s.byteLength;case zc:return i*e/s.components*s.byteLength;case rr:return i*e*2/s.components*s.byteLength;case Hc:return i*e*2/s.components*s.byteLength;case zd:return i*e*3/s.components*s.byteLength;case Wi:return i*e*4/s.components*s.byteLength;case Gc:return i*e*4/s.components*s.byteLength;case Ha:case Ga:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Va:case Wa:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Wc:case qc:return Math.max(i,16)*Math.max(e,8)/4;case Vc:case Xc:return Math.max(i,8)*Math.max(e,8)/2;case Yc:case Zc:case Kc:case Jc:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case $c:case Xa:case jc:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Qc:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case eh:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case th:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case nh:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case ih:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case sh:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case rh:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case oh:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case ah:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case lh:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case ch:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case hh:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case uh:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case dh:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case fh:case ph:case mh:return Math.ceil(i/4)*Math.ceil(e/4)*16;case gh:case _h:return Math.ceil(i/4)*Math.ceil(e/4)*8;case qa:case xh:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function Rv(i){switch(i){case ci:case Ud:return{byteLength:1,components:1};case Fo:case Fd:case Vi:return{byteLength:2,components:1};case Bc:case kc:return{byteLength:2,components:4};case Hi:case Oc:case Gi:return{byteLength:4,components:1};case Od:case Bd:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Ke("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function A0(){let i=null,e=!1,t=null,n=null;function s(r,o){n=i.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&i!==null&&(n=i.requestAnimationFrame(s),e=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){i=r}}}function Fv(i){let e=new WeakMap;function t(a,l){let c=a.array,h=a.usage,u=c.byteLength,d=i.createBuffer();i.bindBuffer(l,d),i.bufferData(l,c,h),a.onUploadCallback();let f;if(c instanceof Float32Array)f=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=i.HALF_FLOAT:f=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=i.SHORT;else if(c instanceof Uint32Array)f=i.UNSIGNED_INT;else if(c instanceof Int32Array)f=i.INT;else if(c instanceof Int8Array)f=i.BYTE;else if(c instanceof Uint8Array)f=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:u}}function n(a,l,c){let h=l.array,u=l.updateRanges;if(i.bindBuffer(c,a),u.length===0)i.bufferSubData(c,0,h);else{u.sort((f,p)=>f.start-p.start);let d=0;for(let f=1;f<u.length;f++){let p=u[d],v=u[f];v.start<=p.start+p.count+1?p.count=Math.max(p.count,v.start+v.count-p.start):(++d,u[d]=v)}u.length=d+1;for(let f=0,p=u.length;f<p;f++){let v=u[f];i.bufferSubData(c,v.start*h.BYTES_PER_ELEMENT,h,v.start,v.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(i.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=e.get(a);(!h||h.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var Ov=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,Bv=`#ifdef USE_ALPHAHASH
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
#endif`,kv=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,zv=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Hv=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,Gv=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,Vv=`#ifdef USE_AOMAP
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
#endif`,Wv=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,Xv=`#ifdef USE_BATCHING
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
#endif`,qv=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,Yv=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,Zv=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,$v=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,Kv=`#ifdef USE_IRIDESCENCE
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
#endif`,Jv=`#ifdef USE_BUMPMAP
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
#endif`,jv=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,Qv=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,eb=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,tb=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,nb=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,ib=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,sb=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,rb=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,ob=`#define PI 3.141592653589793
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
} // validated`,ab=`vec3 transformedNormal = objectNormal;
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
#endif`,lb=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,cb=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,hb=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,ub=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,db="gl_FragColor = linearToOutputTexel( gl_FragColor );",fb=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,pb=`#ifdef USE_ENVMAP
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
#endif`,mb=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,gb=`#ifdef USE_ENVMAP
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
#endif`,_b=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,xb=`#ifdef USE_ENVMAP
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
#endif`,yb=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,vb=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,bb=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,Mb=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Sb=`#ifdef USE_GRADIENTMAP
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
}`,wb=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Eb=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,Tb=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Ab=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,Rb=`#ifdef USE_ENVMAP
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
#endif`,Cb=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,Pb=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Ib=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Lb=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,Db=`PhysicalMaterial material;
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
#endif`,Nb=`uniform sampler2D dfgLUT;
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
}`,Ub=`
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
#endif`,Fb=`#if defined( RE_IndirectDiffuse )
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
#endif`,Ob=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Bb=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,kb=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,zb=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Hb=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Gb=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Vb=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Wb=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Xb=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,qb=`#if defined( USE_POINTS_UV )
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
#endif`,Yb=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Zb=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,$b=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,Kb=`#if defined( USE_MORPHCOLORS )
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
#endif`,Jb=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,jb=`#ifdef USE_MORPHTARGETS
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
#endif`,Qb=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,eM=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,tM=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,nM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,iM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,sM=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,rM=`#ifdef USE_NORMALMAP
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
#endif`,oM=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,aM=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,lM=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,cM=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,hM=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,uM=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,dM=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,fM=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,pM=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,mM=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,gM=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,_M=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,xM=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,yM=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,vM=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,bM=`float getShadowMask() {
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
}`,MM=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,SM=`#ifdef USE_SKINNING
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
#endif`,wM=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,EM=`#ifdef USE_SKINNING
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
#endif`,TM=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,AM=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,RM=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,CM=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,PM=`#ifdef USE_TRANSMISSION
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
#endif`,IM=`#ifdef USE_TRANSMISSION
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
#endif`,LM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,DM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,NM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,UM=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,FM=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,OM=`uniform sampler2D t2D;
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
}`,BM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,kM=`uniform float backgroundBlurriness;
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
}`,zM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,HM=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,GM=`#include <common>
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
}`,VM=`#if DEPTH_PACKING == 3200
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
}`,WM=`#define DISTANCE
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
}`,XM=`#define DISTANCE
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
}`,qM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,YM=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,ZM=`uniform float scale;
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
}`,$M=`uniform vec3 diffuse;
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
}`,KM=`#include <common>
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
}`,JM=`uniform vec3 diffuse;
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
}`,jM=`#define LAMBERT
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
}`,QM=`#define LAMBERT
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
}`,eS=`#define MATCAP
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
}`,tS=`#define MATCAP
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
}`,nS=`#define NORMAL
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
}`,iS=`#define NORMAL
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
}`,sS=`#define PHONG
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
}`,rS=`#define PHONG
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
}`,oS=`#define STANDARD
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
}`,aS=`#define STANDARD
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
}`,lS=`#define TOON
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
}`,cS=`#define TOON
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
}`,hS=`uniform float size;
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
}`,uS=`uniform vec3 diffuse;
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
}`,dS=`#include <common>
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
}`,fS=`uniform vec3 color;
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
}`,pS=`uniform float rotation;
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
}`,mS=`uniform vec3 diffuse;
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
}`,ft={alphahash_fragment:Ov,alphahash_pars_fragment:Bv,alphamap_fragment:kv,alphamap_pars_fragment:zv,alphatest_fragment:Hv,alphatest_pars_fragment:Gv,aomap_fragment:Vv,aomap_pars_fragment:Wv,batching_pars_vertex:Xv,batching_vertex:qv,begin_vertex:Yv,beginnormal_vertex:Zv,bsdfs:$v,iridescence_fragment:Kv,bumpmap_pars_fragment:Jv,clipping_planes_fragment:jv,clipping_planes_pars_fragment:Qv,clipping_planes_pars_vertex:eb,clipping_planes_vertex:tb,color_fragment:nb,color_pars_fragment:ib,color_pars_vertex:sb,color_vertex:rb,common:ob,defaultnormal_vertex:ab,displacementmap_pars_vertex:lb,displacementmap_vertex:cb,emissivemap_fragment:hb,emissivemap_pars_fragment:ub,colorspace_fragment:db,colorspace_pars_fragment:fb,envmap_fragment:pb,envmap_common_pars_fragment:mb,envmap_pars_fragment:gb,envmap_pars_vertex:_b,envmap_physical_pars_fragment:Rb,envmap_vertex:xb,fog_vertex:yb,fog_pars_vertex:vb,fog_fragment:bb,fog_pars_fragment:Mb,gradientmap_pars_fragment:Sb,lightmap_pars_fragment:wb,lights_lambert_fragment:Eb,lights_lambert_pars_fragment:Tb,lights_pars_begin:Ab,lights_toon_fragment:Cb,lights_toon_pars_fragment:Pb,lights_phong_fragment:Ib,lights_phong_pars_fragment:Lb,lights_physical_fragment:Db,lights_physical_pars_fragment:Nb,lights_fragment_begin:Ub,lights_fragment_maps:Fb,lights_fragment_end:Ob,lightprobes_pars_fragment:Bb,logdepthbuf_fragment:kb,logdepthbuf_pars_fragment:zb,logdepthbuf_pars_vertex:Hb,logdepthbuf_vertex:Gb,map_fragment:Vb,map_pars_fragment:Wb,map_particle_fragment:Xb,map_particle_pars_fragment:qb,metalnessmap_fragment:Yb,metalnessmap_pars_fragment:Zb,morphinstance_vertex:$b,morphcolor_vertex:Kb,morphnormal_vertex:Jb,morphtarget_pars_vertex:jb,morphtarget_vertex:Qb,normal_fragment_begin:eM,normal_fragment_maps:tM,normal_pars_fragment:nM,normal_pars_vertex:iM,normal_vertex:sM,normalmap_pars_fragment:rM,clearcoat_normal_fragment_begin:oM,clearcoat_normal_fragment_maps:aM,clearcoat_pars_fragment:lM,iridescence_pars_fragment:cM,opaque_fragment:hM,packing:uM,premultiplied_alpha_fragment:dM,project_vertex:fM,dithering_fragment:pM,dithering_pars_fragment:mM,roughnessmap_fragment:gM,roughnessmap_pars_fragment:_M,shadowmap_pars_fragment:xM,shadowmap_pars_vertex:yM,shadowmap_vertex:vM,shadowmask_pars_fragment:bM,skinbase_vertex:MM,skinning_pars_vertex:SM,skinning_vertex:wM,skinnormal_vertex:EM,specularmap_fragment:TM,specularmap_pars_fragment:AM,tonemapping_fragment:RM,tonemapping_pars_fragment:CM,transmission_fragment:PM,transmission_pars_fragment:IM,uv_pars_fragment:LM,uv_pars_vertex:DM,uv_vertex:NM,worldpos_vertex:UM,background_vert:FM,background_frag:OM,backgroundCube_vert:BM,backgroundCube_frag:kM,cube_vert:zM,cube_frag:HM,depth_vert:GM,depth_frag:VM,distance_vert:WM,distance_frag:XM,equirect_vert:qM,equirect_frag:YM,linedashed_vert:ZM,linedashed_frag:$M,meshbasic_vert:KM,meshbasic_frag:JM,meshlambert_vert:jM,meshlambert_frag:QM,meshmatcap_vert:eS,meshmatcap_frag:tS,meshnormal_vert:nS,meshnormal_frag:iS,meshphong_vert:sS,meshphong_frag:rS,meshphysical_vert:oS,meshphysical_frag:aS,meshtoon_vert:lS,meshtoon_frag:cS,points_vert:hS,points_frag:uS,shadow_vert:dS,shadow_frag:fS,sprite_vert:pS,sprite_frag:mS},Ue={common:{diffuse:{value:new Qe(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new st},alphaMap:{value:null},alphaMapTransform:{value:new st},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new st}},envmap:{envMap:{value:null},envMapRotation:{value:new st},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new st}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new st}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new st},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new st},normalScale:{value:new We(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new st},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new st}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new st}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new st}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Qe(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Qe(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new st},alphaTest:{value:0},uvTransform:{value:new st}},sprite:{diffuse:{value:new Qe(16777215)},opacity:{value:1},center:{value:new We(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new st},alphaMap:{value:null},alphaMapTransform:{value:new st},alphaTest:{value:0}}},ls={basic:{uniforms:Jn([Ue.common,Ue.specularmap,Ue.envmap,Ue.aomap,Ue.lightmap,Ue.fog]),vertexShader:ft.meshbasic_vert,fragmentShader:ft.meshbasic_frag},lambert:{uniforms:Jn([Ue.common,Ue.specularmap,Ue.envmap,Ue.aomap,Ue.lightmap,Ue.emissivemap,Ue.bumpmap,Ue.normalmap,Ue.displacementmap,Ue.fog,Ue.lights,{emissive:{value:new Qe(0)},envMapIntensity:{value:1}}]),vertexShader:ft.meshlambert_vert,fragmentShader:ft.meshlambert_frag},phong:{uniforms:Jn([Ue.common,Ue.specularmap,Ue.envmap,Ue.aomap,Ue.lightmap,Ue.emissivemap,Ue.bumpmap,Ue.normalmap,Ue.displacementmap,Ue.fog,Ue.lights,{emissive:{value:new Qe(0)},specular:{value:new Qe(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:ft.meshphong_vert,fragmentShader:ft.meshphong_frag},standard:{uniforms:Jn([Ue.common,Ue.envmap,Ue.aomap,Ue.lightmap,Ue.emissivemap,Ue.bumpmap,Ue.normalmap,Ue.displacementmap,Ue.roughnessmap,Ue.metalnessmap,Ue.fog,Ue.lights,{emissive:{value:new Qe(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ft.meshphysical_vert,fragmentShader:ft.meshphysical_frag},toon:{uniforms:Jn([Ue.common,Ue.aomap,Ue.lightmap,Ue.emissivemap,Ue.bumpmap,Ue.normalmap,Ue.displacementmap,Ue.gradientmap,Ue.fog,Ue.lights,{emissive:{value:new Qe(0)}}]),vertexShader:ft.meshtoon_vert,fragmentShader:ft.meshtoon_frag},matcap:{uniforms:Jn([Ue.common,Ue.bumpmap,Ue.normalmap,Ue.displacementmap,Ue.fog,{matcap:{value:null}}]),vertexShader:ft.meshmatcap_vert,fragmentShader:ft.meshmatcap_frag},points:{uniforms:Jn([Ue.points,Ue.fog]),vertexShader:ft.points_vert,fragmentShader:ft.points_frag},dashed:{uniforms:Jn([Ue.common,Ue.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ft.linedashed_vert,fragmentShader:ft.linedashed_frag},depth:{uniforms:Jn([Ue.common,Ue.displacementmap]),vertexShader:ft.depth_vert,fragmentShader:ft.depth_frag},normal:{uniforms:Jn([Ue.common,Ue.bumpmap,Ue.normalmap,Ue.displacementmap,{opacity:{value:1}}]),vertexShader:ft.meshnormal_vert,fragmentShader:ft.meshnormal_frag},sprite:{uniforms:Jn([Ue.sprite,Ue.fog]),vertexShader:ft.sprite_vert,fragmentShader:ft.sprite_frag},background:{uniforms:{uvTransform:{value:new st},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ft.background_vert,fragmentShader:ft.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new st}},vertexShader:ft.backgroundCube_vert,fragmentShader:ft.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ft.cube_vert,fragmentShader:ft.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ft.equirect_vert,fragmentShader:ft.equirect_frag},distance:{uniforms:Jn([Ue.common,Ue.displacementmap,{referencePosition:{value:new F},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ft.distance_vert,fragmentShader:ft.distance_frag},shadow:{uniforms:Jn([Ue.lights,Ue.fog,{color:{value:new Qe(0)},opacity:{value:1}}]),vertexShader:ft.shadow_vert,fragmentShader:ft.shadow_frag}};ls.physical={uniforms:Jn([ls.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new st},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new st},clearcoatNormalScale:{value:new We(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new st},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new st},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new st},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new st},sheen:{value:0},sheenColor:{value:new Qe(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new st},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new st},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new st},transmissionSamplerSize:{value:new We},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new st},attenuationDistance:{value:0},attenuationColor:{value:new Qe(0)},specularColor:{value:new Qe(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new st},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new st},anisotropyVector:{value:new We},anisotropyMap:{value:null},anisotropyMapTransform:{value:new st}}]),vertexShader:ft.meshphysical_vert,fragmentShader:ft.meshphysical_frag};var vh={r:0,b:0,g:0},gS=new wt,R0=new st;R0.set(-1,0,0,0,1,0,0,0,1);function _S(i,e,t,n,s,r){let o=new Qe(0),a=s===!0?0:1,l,c,h=null,u=0,d=null;function f(_){let E=_.isScene===!0?_.background:null;if(E&&E.isTexture){let b=_.backgroundBlurriness>0;E=e.get(E,b)}return E}function p(_){let E=!1,b=f(_);b===null?g(o,a):b&&b.isColor&&(g(b,1),E=!0);let C=i.xr.getEnvironmentBlendMode();C==="additive"?t.buffers.color.setClear(0,0,0,1,r):C==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(i.autoClear||E)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function v(_,E){let b=f(E);b&&b.isCubeTexture?(c===void 0&&(c=new Ce(new Gt(1,1,1),new Ci({name:"BackgroundCubeMaterial",uniforms:Lr(ls.backgroundCube.uniforms),vertexShader:ls.backgroundCube.vertexShader,fragmentShader:ls.backgroundCube.fragmentShader,side:Gn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(C,M,x){this.matrixWorld.copyPosition(x.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=b,c.material.uniforms.backgroundBlurriness.value=E.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=E.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(gS.makeRotationFromEuler(E.backgroundRotation)).transpose(),b.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(R0),c.material.toneMapped=Mt.getTransfer(b.colorSpace)!==Dt,(h!==b||u!==b.version||d!==i.toneMapping)&&(c.material.needsUpdate=!0,h=b,u=b.version,d=i.toneMapping),c.layers.enableAll(),_.unshift(c,c.geometry,c.material,0,0,null)):b&&b.isTexture&&(l===void 0&&(l=new Ce(new Rs(2,2),new Ci({name:"BackgroundMaterial",uniforms:Lr(ls.background.uniforms),vertexShader:ls.background.vertexShader,fragmentShader:ls.background.fragmentShader,side:rs,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=b,l.material.uniforms.backgroundIntensity.value=E.backgroundIntensity,l.material.toneMapped=Mt.getTransfer(b.colorSpace)!==Dt,b.matrixAutoUpdate===!0&&b.updateMatrix(),l.material.uniforms.uvTransform.value.copy(b.matrix),(h!==b||u!==b.version||d!==i.toneMapping)&&(l.material.needsUpdate=!0,h=b,u=b.version,d=i.toneMapping),l.layers.enableAll(),_.unshift(l,l.geometry,l.material,0,0,null))}function g(_,E){_.getRGB(vh,Qd(i)),t.buffers.color.setClear(vh.r,vh.g,vh.b,E,r)}function m(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(_,E=1){o.set(_),a=E,g(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(_){a=_,g(o,a)},render:p,addToRenderList:v,dispose:m}}function xS(i,e){let t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=d(null),r=s,o=!1;function a(D,z,W,N,V){let Z=!1,G=u(D,N,W,z);r!==G&&(r=G,c(r.object)),Z=f(D,N,W,V),Z&&p(D,N,W,V),V!==null&&e.update(V,i.ELEMENT_ARRAY_BUFFER),(Z||o)&&(o=!1,b(D,z,W,N),V!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get(V).buffer))}function l(){return i.createVertexArray()}function c(D){return i.bindVertexArray(D)}function h(D){return i.deleteVertexArray(D)}function u(D,z,W,N){let V=N.wireframe===!0,Z=n[z.id];Z===void 0&&(Z={},n[z.id]=Z);let G=D.isInstancedMesh===!0?D.id:0,ce=Z[G];ce===void 0&&(ce={},Z[G]=ce);let Y=ce[W.id];Y===void 0&&(Y={},ce[W.id]=Y);let Q=Y[V];return Q===void 0&&(Q=d(l()),Y[V]=Q),Q}function d(D){let z=[],W=[],N=[];for(let V=0;V<t;V++)z[V]=0,W[V]=0,N[V]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:z,enabledAttributes:W,attributeDivisors:N,object:D,attributes:{},index:null}}function f(D,z,W,N){let V=r.attributes,Z=z.attributes,G=0,ce=W.getAttributes();for(let Y in ce)if(ce[Y].location>=0){let ie=V[Y],de=Z[Y];if(de===void 0&&(Y==="instanceMatrix"&&D.instanceMatrix&&(de=D.instanceMatrix),Y==="instanceColor"&&D.instanceColor&&(de=D.instanceColor)),ie===void 0||ie.attribute!==de||de&&ie.data!==de.data)return!0;G++}return r.attributesNum!==G||r.index!==N}function p(D,z,W,N){let V={},Z=z.attributes,G=0,ce=W.getAttributes();for(let Y in ce)if(ce[Y].location>=0){let ie=Z[Y];ie===void 0&&(Y==="instanceMatrix"&&D.instanceMatrix&&(ie=D.instanceMatrix),Y==="instanceColor"&&D.instanceColor&&(ie=D.instanceColor));let de={};de.attribute=ie,ie&&ie.data&&(de.data=ie.data),V[Y]=de,G++}r.attributes=V,r.attributesNum=G,r.index=N}function v(){let D=r.newAttributes;for(let z=0,W=D.length;z<W;z++)D[z]=0}function g(D){m(D,0)}function m(D,z){let W=r.newAttributes,N=r.enabledAttributes,V=r.attributeDivisors;W[D]=1,N[D]===0&&(i.enableVertexAttribArray(D),N[D]=1),V[D]!==z&&(i.vertexAttribDivisor(D,z),V[D]=z)}function _(){let D=r.newAttributes,z=r.enabledAttributes;for(let W=0,N=z.length;W<N;W++)z[W]!==D[W]&&(i.disableVertexAttribArray(W),z[W]=0)}function E(D,z,W,N,V,Z,G){G===!0?i.vertexAttribIPointer(D,z,W,V,Z):i.vertexAttribPointer(D,z,W,N,V,Z)}function b(D,z,W,N){v();let V=N.attributes,Z=W.getAttributes(),G=z.defaultAttributeValues;for(let ce in Z){let Y=Z[ce];if(Y.location>=0){let Q=V[ce];if(Q===void 0&&(ce==="instanceMatrix"&&D.instanceMatrix&&(Q=D.instanceMatrix),ce==="instanceColor"&&D.instanceColor&&(Q=D.instanceColor)),Q!==void 0){let ie=Q.normalized,de=Q.itemSize,fe=e.get(Q);if(fe===void 0)continue;let ee=fe.buffer,ge=fe.type,ye=fe.bytesPerElement,Pe=ge===i.INT||ge===i.UNSIGNED_INT||Q.gpuType===Oc;if(Q.isInterleavedBufferAttribute){let we=Q.data,Ye=we.isInterleavedBuffer===!0?we.stride:we.itemSize,at=Q.offset;if(we.isInstancedInterleavedBuffer||we.isInstancedBufferAttribute){for(let Xe=0;Xe<Y.locationSize;Xe++)m(Y.location+Xe,we.meshPerAttribute);D.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=we.meshPerAttribute*we.count)}else for(let Xe=0;Xe<Y.locationSize;Xe++)g(Y.location+Xe);i.bindBuffer(i.ARRAY_BUFFER,ee);for(let Xe=0;Xe<Y.locationSize;Xe++)E(Y.location+Xe,de/Y.locationSize,ge,ie,Ye*ye,(at+de/Y.locationSize*Xe)*ye,Pe)}else{if(Q.isInstancedBufferAttribute){for(let we=0;we<Y.locationSize;we++)m(Y.location+we,Q.meshPerAttribute);D.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let we=0;we<Y.locationSize;we++)g(Y.location+we);i.bindBuffer(i.ARRAY_BUFFER,ee);for(let we=0;we<Y.locationSize;we++)E(Y.location+we,de/Y.locationSize,ge,ie,de*ye,de/Y.locationSize*we*ye,Pe)}}else if(G!==void 0){let ie=G[ce];if(ie!==void 0)switch(ie.length){case 2:i.vertexAttrib2fv(Y.location,ie);break;case 3:i.vertexAttrib3fv(Y.location,ie);break;case 4:i.vertexAttrib4fv(Y.location,ie);break;default:i.vertexAttrib1fv(Y.location,ie)}}}}_()}function C(){O();for(let D in n){let z=n[D];for(let W in z){let N=z[W];for(let V in N){let Z=N[V];for(let G in Z)h(Z[G].object),delete Z[G];delete N[V]}}delete n[D]}}function M(D){if(n[D.id]===void 0)return;let z=n[D.id];for(let W in z){let N=z[W];for(let V in N){let Z=N[V];for(let G in Z)h(Z[G].object),delete Z[G];delete N[V]}}delete n[D.id]}function x(D){for(let z in n){let W=n[z];for(let N in W){let V=W[N];if(V[D.id]===void 0)continue;let Z=V[D.id];for(let G in Z)h(Z[G].object),delete Z[G];delete V[D.id]}}}function w(D){for(let z in n){let W=n[z],N=D.isInstancedMesh===!0?D.id:0,V=W[N];if(V!==void 0){for(let Z in V){let G=V[Z];for(let ce in G)h(G[ce].object),delete G[ce];delete V[Z]}delete W[N],Object.keys(W).length===0&&delete n[z]}}}function O(){P(),o=!0,r!==s&&(r=s,c(r.object))}function P(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:O,resetDefaultState:P,dispose:C,releaseStatesOfGeometry:M,releaseStatesOfObject:w,releaseStatesOfProgram:x,initAttributes:v,enableAttribute:g,disableUnusedAttributes:_}}function yS(i,e,t){let n;function s(l){n=l}function r(l,c){i.drawArrays(n,l,c),t.update(c,n,1)}function o(l,c,h){h!==0&&(i.drawArraysInstanced(n,l,c,h),t.update(c,n,h))}function a(l,c,h){if(h===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,h);let d=0;for(let f=0;f<h;f++)d+=c[f];t.update(d,n,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function vS(i,e,t,n){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let x=e.get("EXT_texture_filter_anisotropic");s=i.getParameter(x.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(x){return!(x!==Wi&&n.convert(x)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(x){let w=x===Vi&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(x!==ci&&x!==Gi&&!w&&n.convert(x)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(x){if(x==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";x="mediump"}return x==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",h=l(c);h!==c&&(Ke("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let u=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),d=t.logarithmicDepthBuffer===!0&&u===!1;t.reversedDepthBuffer===!0&&u===!1&&Ke("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&u===!0&&Ke("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),p=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),v=i.getParameter(i.MAX_TEXTURE_SIZE),g=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),m=i.getParameter(i.MAX_VERTEX_ATTRIBS),_=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),E=i.getParameter(i.MAX_VARYING_VECTORS),b=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),C=i.getParameter(i.MAX_SAMPLES),M=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:u,maxTextures:f,maxVertexTextures:p,maxTextureSize:v,maxCubemapSize:g,maxAttributes:m,maxVertexUniforms:_,maxVaryings:E,maxFragmentUniforms:b,maxSamples:C,samples:M}}function bS(i){let e=this,t=null,n=0,s=!1,r=!1,o=new Hn,a=new st,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,d){let f=u.length!==0||d||n!==0||s;return s=d,n=u.length,f},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,d){t=h(u,d,0)},this.setState=function(u,d,f){let p=u.clippingPlanes,v=u.clipIntersection,g=u.clipShadows,m=i.get(u);if(!s||p===null||p.length===0||r&&!g)r?h(null):c();else{let _=r?0:n,E=_*4,b=m.clippingState||null;l.value=b,b=h(p,d,E,f);for(let C=0;C!==E;++C)b[C]=t[C];m.clippingState=b,this.numIntersection=v?this.numPlanes:0,this.numPlanes+=_}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}function h(u,d,f,p){let v=u!==null?u.length:0,g=null;if(v!==0){if(g=l.value,p!==!0||g===null){let m=f+v*4,_=d.matrixWorldInverse;a.getNormalMatrix(_),(g===null||g.length<m)&&(g=new Float32Array(m));for(let E=0,b=f;E!==v;++E,b+=4)o.copy(u[E]).applyMatrix4(_,a),o.normal.toArray(g,b),g[b+3]=o.constant}l.value=g,l.needsUpdate=!0}return e.numPlanes=v,e.numIntersection=0,g}}var Ka=class extends vi{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},s=[n,n,n,n,n,n];this.texture=new Ta(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new Gt(5,5,5),r=new Ci({name:"CubemapFromEquirect",uniforms:Lr(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:Gn,blending:Rr});r.uniforms.tEquirect.value=t;let o=new Ce(s,r),a=t.minFilter;return t.minFilter===Is&&(t.minFilter=ri),new Po(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,n=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,n,s);e.setRenderTarget(r)}},o0=256,MS=3,SS=20,C0=256,P0=16,wS=3,ES=new F,TS=new Qe,Mh=class i{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Po(1,10,null),this._boxMesh=new Ce(new Gt(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,n=.1,s=100,r={}){let{size:o=256,position:a=ES}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),h=this._getSourceTarget(!0);t>0&&(h.texture.mipmapsAutoUpdate=!1);let u=l.autoClear,d=l.autoClearColor,f=l.autoClearDepth,p=l.autoClearStencil,v=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,v===null&&(e.background=l.getClearColor(TS));let g=new Po(n,s,h);return g.position.copy(a),g.update(l,e),l.autoClear=u,l.autoClearColor=d,l.autoClearDepth=f,l.autoClearStencil=p,e.background=v,t>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=c0(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=l0(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(o0,Jd(e))}_fromTexture(e,t){e.mapping===Pr||e.mapping===No?this._setSize(e.image.length===0?o0:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let n=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(n),n}_allocateTarget(){let e=this._cubeSize,t=a0(e,!1,!1),n=Math.log2(e)-MS;for(let s=0;s<=n;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==t||e&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=a0(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===Pr||e.mapping===No?(this._cubemapMaterial===null&&(this._cubemapMaterial=c0()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=l0()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=AS(),this._integrationMaterial=RS());let t=this._cubeSize,n=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/P0);for(let o=0;o<=n;o++){let a=i.lodToRoughness(o,n);if(o>n-wS)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(C0*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=CS());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,n),s.envMap.value=e.texture,this._renderCube(r,0,n)}};function a0(i,e,t){return new Ka(i,{minFilter:Is,generateMipmaps:e,type:Vi,colorSpace:ga,depthBuffer:t})}function Ja(i,e,t){return new Ci({name:i,uniforms:e,vertexShader:ft.cube_vert,fragmentShader:t,side:Gn,blending:Rr,depthTest:!1,depthWrite:!1})}function AS(){return Ja("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${C0}u

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
	`)}function RS(){return Ja("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:P0}},`

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
	`)}function CS(){return Ja("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${SS}
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
	`)}function l0(){return Ja("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function c0(){return Ja("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function PS(i){let e=new WeakMap,t=new WeakMap,n=null;function s(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===Uc||f===Fc)if(e.has(d)){let p=e.get(d).texture;return a(p,d.mapping)}else{let p=d.image;if(p&&p.height>0){let v=new Ka(p.height);return v.fromEquirectangularTexture(i,d),e.set(d,v),d.addEventListener("dispose",c),a(v.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,p=f===Uc||f===Fc,v=f===Pr||f===No;if(p||v){let g=t.get(d),m=g!==void 0?g.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==m)return n===null&&(n=new Mh(i)),g=p?n.fromEquirectangular(d,g):n.fromCubemap(d,g),g.texture.pmremVersion=d.pmremVersion,t.set(d,g),g.texture;if(g!==void 0)return g.texture;{let _=d.image;return p&&_&&_.height>0||v&&_&&l(_)?(n===null&&(n=new Mh(i)),g=p?n.fromEquirectangular(d):n.fromCubemap(d),g.texture.pmremVersion=d.pmremVersion,t.set(d,g),d.addEventListener("dispose",h),g.texture):null}}}return d}function a(d,f){return f===Uc?d.mapping=Pr:f===Fc&&(d.mapping=No),d}function l(d){let f=0,p=6;for(let v=0;v<p;v++)d[v]!==void 0&&f++;return f===p}function c(d){let f=d.target;f.removeEventListener("dispose",c);let p=e.get(f);p!==void 0&&(e.delete(f),p.dispose())}function h(d){let f=d.target;f.removeEventListener("dispose",h);let p=t.get(f);p!==void 0&&(t.delete(f),p.dispose())}function u(){e=new WeakMap,t=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:u}}function IS(i){let e={};function t(n){if(e[n]!==void 0)return e[n];let s=i.getExtension(n);return e[n]=s,s}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){let s=t(n);return s===null&&fa("WebGLRenderer: "+n+" extension not supported."),s}}}function LS(i,e,t,n){let s={},r=new WeakMap,o=new FinalizationRegistry(p=>delete s[p]);function a(p){l(p.target)}function l(p){p.index!==null&&e.remove(p.index);for(let g in p.attributes)e.remove(p.attributes[g]);p.removeEventListener("dispose",a),delete s[p.id],o.unregister(p);let v=r.get(p);v&&(e.remove(v),r.delete(p)),n.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,t.memory.geometries--}function c(p,v){return s[v.id]!==void 0||(v.addEventListener("dispose",a),s[v.id]=new WeakRef(v),o.register(v,v.id,v),t.memory.geometries++),v}function h(p){let v=p.attributes;for(let g in v)e.update(v[g],i.ARRAY_BUFFER)}function u(p){let v=p.index,g=p.attributes.position,m=0;if(g===void 0)return;let _=v!==null?v.array.length:g.array.length/3-1,E=g.count>=65535?Sa:Ma,b=new E(Math.ceil(_/3)*6,1),C=b.array;if(v!==null){let x=v.array;m=v.version;for(let w=0,O=0;w<_;w+=3){let P=x[w+0],D=x[w+1],z=x[w+2];C[O++]=P,C[O++]=D,C[O++]=D,C[O++]=z,C[O++]=z,C[O++]=P}}else{m=g.version;for(let x=0,w=0;x<_;x+=3){let O=x+0,P=x+1,D=x+2;C[w++]=O,C[w++]=P,C[w++]=P,C[w++]=D,C[w++]=D,C[w++]=O}}b.version=m;let M=r.get(p);M&&e.remove(M),r.set(p,b)}function d(p){let v=r.get(p);if(v){let g=p.index;g!==null&&v.version<g.version&&u(p)}else u(p);return r.get(p)}function f(){for(let p in s){let v=s[p].deref();v!==void 0&&l(v)}}return{get:c,update:h,getWireframeAttribute:d,dispose:f}}function DS(i,e,t){let n;function s(u){n=u}let r,o;function a(u){r=u.type,o=u.bytesPerElement}function l(u,d){i.drawElements(n,d,r,u*o),t.update(d,n,1)}function c(u,d,f){f!==0&&(i.drawElementsInstanced(n,d,r,u*o,f),t.update(d,n,f))}function h(u,d,f){if(f===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,d,0,r,u,0,f);let v=0;for(let g=0;g<f;g++)v+=d[g];t.update(v,n,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function NS(i){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(t.calls++,o){case i.TRIANGLES:t.triangles+=a*(r/3);break;case i.LINES:t.lines+=a*(r/2);break;case i.LINE_STRIP:t.lines+=a*(r-1);break;case i.LINE_LOOP:t.lines+=a*r;break;case i.POINTS:t.points+=a*r;break;default:nt("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:n}}function US(i,e,t){let n=new WeakMap,s=new Xt;function r(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=h!==void 0?h.length:0,d=n.get(a);if(d===void 0||d.count!==u){let O=function(){x.dispose(),n.delete(a),a.removeEventListener("dispose",O)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,v=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],m=a.morphAttributes.normal||[],_=a.morphAttributes.color||[],E=0;f===!0&&(E=1),p===!0&&(E=2),v===!0&&(E=3);let b=a.attributes.position.count*E,C=1;b>e.maxTextureSize&&(C=Math.ceil(b/e.maxTextureSize),b=e.maxTextureSize);let M=new Float32Array(b*C*4*u),x=new ya(M,b,C,u);x.type=Gi,x.needsUpdate=!0;let w=E*4;for(let P=0;P<u;P++){let D=g[P],z=m[P],W=_[P],N=b*C*4*P;for(let V=0;V<D.count;V++){let Z=V*w;f===!0&&(s.fromBufferAttribute(D,V),M[N+Z+0]=s.x,M[N+Z+1]=s.y,M[N+Z+2]=s.z,M[N+Z+3]=0),p===!0&&(s.fromBufferAttribute(z,V),M[N+Z+4]=s.x,M[N+Z+5]=s.y,M[N+Z+6]=s.z,M[N+Z+7]=0),v===!0&&(s.fromBufferAttribute(W,V),M[N+Z+8]=s.x,M[N+Z+9]=s.y,M[N+Z+10]=s.z,M[N+Z+11]=W.itemSize===4?s.w:1)}}d={count:u,texture:x,size:new We(b,C)},n.set(a,d),a.addEventListener("dispose",O)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,t);else{let f=0;for(let v=0;v<c.length;v++)f+=c[v];let p=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(i,"morphTargetBaseInfluence",p),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",d.texture,t),l.getUniforms().setValue(i,"morphTargetsTextureSize",d.size)}return{update:r}}function FS(i,e,t,n,s){let r=new WeakMap;function o(c){let h=s.render.frame,u=c.geometry,d=e.get(c,u);if(r.get(d)!==h&&(e.update(d),r.set(d,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(t.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,i.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==h&&(f.update(),r.set(f,h))}return d}function a(){r=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),n.releaseStatesOfObject(h),t.remove(h.instanceMatrix),h.instanceColor!==null&&t.remove(h.instanceColor)}return{update:o,dispose:a}}var OS={[Rd]:"LINEAR_TONE_MAPPING",[Cd]:"REINHARD_TONE_MAPPING",[Pd]:"CINEON_TONE_MAPPING",[Id]:"ACES_FILMIC_TONE_MAPPING",[Dd]:"AGX_TONE_MAPPING",[ka]:"NEUTRAL_TONE_MAPPING",[Ld]:"CUSTOM_TONE_MAPPING"};function BS(i,e,t,n,s,r){let o=new vi(e,t,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,h=new Pt;h.setAttribute("position",new Et([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new Et([0,2,0,0,2,0],2));let u=new yc({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),d=new Ce(h,u),f=new Ba(-1,1,1,-1,0,1),p=null,v=null,g=!1,m,_=null,E=[],b=!1;this.setSize=function(C,M){o.setSize(C,M),a!==null&&a.setSize(C,M),l!==null&&l.setSize(C,M);for(let x=0;x<E.length;x++){let w=E[x];w.setSize&&w.setSize(C,M)}},this.setEffects=function(C){E=C,b=E.length>0&&E[0].isRenderPass===!0;let M=o.width,x=o.height;E.length>0&&a===null&&(a=new vi(M,x,{type:Vi,depthBuffer:!1,stencilBuffer:!1}),l=new vi(M,x,{type:Vi,depthBuffer:!1,stencilBuffer:!1}));let w=s===!0&&E.some(O=>O.needsDepthTexture===!0);w!==(o.depthTexture!==null)&&(w===!0&&c===null&&(c=new As(M,x),r===!0&&(c.format=Ls,c.type=Ir)),o.dispose(),o.depthTexture=w?c:null,o.resolveDepthBuffer=w,o.storeMultisampledDepthBuffer=w);for(let O=0;O<E.length;O++){let P=E[O];P.setSize&&P.setSize(M,x),w&&P.needsDepthTexture===!0&&P.setDepthTexture&&P.setDepthTexture(c)}},this.begin=function(C,M){if(g||C.toneMapping===os&&E.length===0)return!1;if(_=M,M!==null){let x=M.width,w=M.height;(o.width!==x||o.height!==w)&&this.setSize(x,w)}return b===!1&&C.setRenderTarget(o),m=C.toneMapping,C.toneMapping=os,!0},this.hasRenderPass=function(){return b},this.end=function(C,M){C.toneMapping=m,g=!0;let x=o,w=a;for(let O=0;O<E.length;O++){let P=E[O];P.enabled!==!1&&(P.render(C,w,x,M),P.needsSwap!==!1&&(x=w,w=w===a?l:a))}if(p!==C.outputColorSpace||v!==C.toneMapping){p=C.outputColorSpace,v=C.toneMapping,u.defines={},Mt.getTransfer(p)===Dt&&(u.defines.SRGB_TRANSFER="");let O=OS[v];O&&(u.defines[O]=""),u.needsUpdate=!0}u.uniforms.tDiffuse.value=x.texture,C.setRenderTarget(_),C.render(d,f),_=null,g=!1},this.isCompositing=function(){return g},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),h.dispose(),u.dispose()}}var I0=new Zn,L0=new As(1,1),D0=new Aa(1),N0=new ya,U0=new pc,F0=new Ta,h0=[],u0=[],d0=new Float32Array(16),f0=new Float32Array(9),p0=new Float32Array(4);function ko(i,e,t){let n=i[0];if(n<=0||n>0)return i;let s=e*t,r=h0[s];if(r===void 0&&(r=new Float32Array(s),h0[s]=r),e!==0){n.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,i[o].toArray(r,a)}return r}function Cn(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function Pn(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}function wh(i,e){let t=u0[e];t===void 0&&(t=new Int32Array(e),u0[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function kS(i,e){let t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function zS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Cn(t,e))return;i.uniform2fv(this.addr,e),Pn(t,e)}}function HS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Cn(t,e))return;i.uniform3fv(this.addr,e),Pn(t,e)}}function GS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Cn(t,e))return;i.uniform4fv(this.addr,e),Pn(t,e)}}function VS(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(Cn(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),Pn(t,e)}else{if(Cn(t,n))return;p0.set(n),i.uniformMatrix2fv(this.addr,!1,p0),Pn(t,n)}}function WS(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(Cn(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),Pn(t,e)}else{if(Cn(t,n))return;f0.set(n),i.uniformMatrix3fv(this.addr,!1,f0),Pn(t,n)}}function XS(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(Cn(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),Pn(t,e)}else{if(Cn(t,n))return;d0.set(n),i.uniformMatrix4fv(this.addr,!1,d0),Pn(t,n)}}function qS(i,e){let t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}function YS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Cn(t,e))return;i.uniform2iv(this.addr,e),Pn(t,e)}}function ZS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Cn(t,e))return;i.uniform3iv(this.addr,e),Pn(t,e)}}function $S(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Cn(t,e))return;i.uniform4iv(this.addr,e),Pn(t,e)}}function KS(i,e){let t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function JS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Cn(t,e))return;i.uniform2uiv(this.addr,e),Pn(t,e)}}function jS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Cn(t,e))return;i.uniform3uiv(this.addr,e),Pn(t,e)}}function QS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Cn(t,e))return;i.uniform4uiv(this.addr,e),Pn(t,e)}}function Eh(i){return i.version===0&&(i.compareFunction=qd,i.needsUpdate=!0),i}function ew(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=Eh(L0):r=I0,t.setTexture2D(e||r,s)}function tw(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture3D(e||U0,s)}function nw(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=Eh(D0):r=F0,t.setTextureCube(e||r,s)}function iw(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture2DArray(e||N0,s)}function sw(i){switch(i){case 5126:return kS;case 35664:return zS;case 35665:return HS;case 35666:return GS;case 35674:return VS;case 35675:return WS;case 35676:return XS;case 5124:case 35670:return qS;case 35667:case 35671:return YS;case 35668:case 35672:return ZS;case 35669:case 35673:return $S;case 5125:return KS;case 36294:return JS;case 36295:return jS;case 36296:return QS;case 35678:case 36198:case 36298:case 36306:case 35682:return ew;case 35679:case 36299:case 36307:return tw;case 35680:case 36300:case 36308:case 36293:return nw;case 36289:case 36303:case 36311:case 36292:return iw}}function rw(i,e){i.uniform1fv(this.addr,e)}function ow(i,e){let t=ko(e,this.size,2);i.uniform2fv(this.addr,t)}function aw(i,e){let t=ko(e,this.size,3);i.uniform3fv(this.addr,t)}function lw(i,e){let t=ko(e,this.size,4);i.uniform4fv(this.addr,t)}function cw(i,e){let t=ko(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function hw(i,e){let t=ko(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function uw(i,e){let t=ko(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function dw(i,e){i.uniform1iv(this.addr,e)}function fw(i,e){i.uniform2iv(this.addr,e)}function pw(i,e){i.uniform3iv(this.addr,e)}function mw(i,e){i.uniform4iv(this.addr,e)}function gw(i,e){i.uniform1uiv(this.addr,e)}function _w(i,e){i.uniform2uiv(this.addr,e)}function xw(i,e){i.uniform3uiv(this.addr,e)}function yw(i,e){i.uniform4uiv(this.addr,e)}function vw(i,e,t){let n=this.cache,s=e.length,r=wh(t,s);Cn(n,r)||(i.uniform1iv(this.addr,r),Pn(n,r));let o;this.type===i.SAMPLER_2D_SHADOW?o=Eh(L0):o=I0;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function bw(i,e,t){let n=this.cache,s=e.length,r=wh(t,s);Cn(n,r)||(i.uniform1iv(this.addr,r),Pn(n,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||U0,r[o])}function Mw(i,e,t){let n=this.cache,s=e.length,r=wh(t,s);Cn(n,r)||(i.uniform1iv(this.addr,r),Pn(n,r));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=Eh(D0):o=F0;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function Sw(i,e,t){let n=this.cache,s=e.length,r=wh(t,s);Cn(n,r)||(i.uniform1iv(this.addr,r),Pn(n,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||N0,r[o])}function ww(i){switch(i){case 5126:return rw;case 35664:return ow;case 35665:return aw;case 35666:return lw;case 35674:return cw;case 35675:return hw;case 35676:return uw;case 5124:case 35670:return dw;case 35667:case 35671:return fw;case 35668:case 35672:return pw;case 35669:case 35673:return mw;case 5125:return gw;case 36294:return _w;case 36295:return xw;case 36296:return yw;case 35678:case 36198:case 36298:case 36306:case 35682:return vw;case 35679:case 36299:case 36307:return bw;case 35680:case 36300:case 36308:case 36293:return Mw;case 36289:case 36303:case 36311:case 36292:return Sw}}var of=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=sw(t.type)}},af=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=ww(t.type)}},lf=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],n)}}},sf=/(\w+)(\])?(\[|\.)?/g;function m0(i,e){i.seq.push(e),i.map[e.id]=e}function Ew(i,e,t){let n=i.name,s=n.length;for(sf.lastIndex=0;;){let r=sf.exec(n),o=sf.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){m0(t,c===void 0?new of(a,i,e):new af(a,i,e));break}else{let u=t.map[a];u===void 0&&(u=new lf(a),m0(t,u)),t=u}}}var Bo=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);Ew(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,n,s){let r=this.map[t];r!==void 0&&r.setValue(e,n,s)}setOptional(e,t,n){let s=t[n];s!==void 0&&this.setValue(e,n,s)}static upload(e,t,n,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let n=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&n.push(o)}return n}};function g0(i,e,t){let n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}var Tw=37297,Aw=0;function Rw(i,e){let t=i.split(`
`),n=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return n.join(`
`)}var _0=new st;function Cw(i){Mt._getMatrix(_0,Mt.workingColorSpace,i);let e=`mat3( ${_0.elements.map(t=>t.toFixed(4))} )`;switch(Mt.getTransfer(i)){case _a:return[e,"LinearTransferOETF"];case Dt:return[e,"sRGBTransferOETF"];default:return Ke("WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function x0(i,e,t){let n=i.getShaderParameter(e,i.COMPILE_STATUS),r=(i.getShaderInfoLog(e)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+Rw(i.getShaderSource(e),a)}else return r}function Pw(i,e){let t=Cw(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var Iw={[Rd]:"Linear",[Cd]:"Reinhard",[Pd]:"Cineon",[Id]:"ACESFilmic",[Dd]:"AgX",[ka]:"Neutral",[Ld]:"Custom"};function Lw(i,e){let t=Iw[e];return t===void 0?(Ke("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var bh=new F;function Dw(){Mt.getLuminanceCoefficients(bh);let i=bh.x.toFixed(4),e=bh.y.toFixed(4),t=bh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function Nw(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter($a).join(`
`)}function Uw(i){let e=[];for(let t in i){let n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}function Fw(i,e){let t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(e,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:i.getAttribLocation(e,o),locationSize:a}}return t}function $a(i){return i!==""}function y0(i,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function v0(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var Ow=/^[ \t]*#include +<([\w\d./]+)>/gm;function cf(i){return i.replace(Ow,Bw)}function Bw(i,e){let t=ft[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return cf(t)}var kw=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function b0(i){return i.replace(kw,zw)}function zw(i,e,t,n){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function M0(i){let e=`precision ${i.precision} float;
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
#define LOW_PRECISION`),e}var Hw={[Ar]:"SHADOWMAP_TYPE_PCF",[Lo]:"SHADOWMAP_TYPE_VSM"};function Gw(i){return Hw[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var Vw={[No]:"ENVMAP_MODE_REFRACTION"};function Ww(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":Vw[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var Xw={[Nc]:"ENVMAP_BLENDING_MULTIPLY",[Bg]:"ENVMAP_BLENDING_MIX",[kg]:"ENVMAP_BLENDING_ADD"};function qw(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":Xw[i.combine]||"ENVMAP_BLENDING_NONE"}function Yw(i,e,t,n){let s=i.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=Gw(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=Ww(t),u=qw(t),d=Nw(t),f=Uw(r),p=s.createProgram(),v,g,m=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(v=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter($a).join(`
`),v.length>0&&(v+=`
`),g=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter($a).join(`
`),g.length>0&&(g+=`
`)):(v=[M0(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+h:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter($a).join(`
`),g=[M0(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+h:"",t.envMap?"#define "+u:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==os?"#define TONE_MAPPING":"",t.toneMapping!==os?ft.tonemapping_pars_fragment:"",t.toneMapping!==os?Lw("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",ft.colorspace_pars_fragment,Pw("linearToOutputTexel",t.outputColorSpace),Dw(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter($a).join(`
`)),o=cf(o),o=y0(o,t),o=v0(o,t),a=cf(a),a=y0(a,t),a=v0(a,t),o=b0(o),a=b0(a),t.isRawShaderMaterial!==!0&&(m=`#version 300 es
`,v=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+v,g=["#define varying in",t.glslVersion===Zd?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Zd?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+g);let _=m+v+o,E=m+g+a,b=g0(s,s.VERTEX_SHADER,_),C=g0(s,s.FRAGMENT_SHADER,E);s.attachShader(p,b),s.attachShader(p,C),t.index0AttributeName!==void 0?s.bindAttribLocation(p,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function M(P){if(i.debug.checkShaderErrors){let D=s.getProgramInfoLog(p)||"",z=s.getShaderInfoLog(b)||"",W=s.getShaderInfoLog(C)||"",N=D.trim(),V=z.trim(),Z=W.trim(),G=!0,ce=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(G=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,p,b,C);else{let Y=x0(s,b,"vertex"),Q=x0(s,C,"fragment");nt("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+P.name+`
Material Type: `+P.type+`

Program Info Log: `+N+`
`+Y+`
`+Q)}else N!==""?Ke("WebGLProgram: Program Info Log:",N):(V===""||Z==="")&&(ce=!1);ce&&(P.diagnostics={runnable:G,programLog:N,vertexShader:{log:V,prefix:v},fragmentShader:{log:Z,prefix:g}})}s.deleteShader(b),s.deleteShader(C),x=new Bo(s,p),w=Fw(s,p)}let x;this.getUniforms=function(){return x===void 0&&M(this),x};let w;this.getAttributes=function(){return w===void 0&&M(this),w};let O=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return O===!1&&(O=s.getProgramParameter(p,Tw)),O},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=Aw++,this.cacheKey=e,this.usedTimes=1,this.program=p,this.vertexShader=b,this.fragmentShader=C,this}var Zw=0,hf=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,n){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new uf(e),t.set(e,n)),n}},uf=class{constructor(e){this.id=Zw++,this.code=e,this.usedTimes=0}};function $w(i){return i===rr||i===Xa||i===qa}function Kw(i,e,t,n,s,r){let o=new To,a=new hf,l=new Set,c=[],h=new Map,u=n.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(x){return l.add(x),x===0?"uv":`uv${x}`}function p(x,w,O,P,D,z){let W=P.fog,N=D.geometry,V=x.isMeshStandardMaterial||x.isMeshLambertMaterial||x.isMeshPhongMaterial?P.environment:null,Z=x.isMeshStandardMaterial||x.isMeshLambertMaterial&&!x.envMap||x.isMeshPhongMaterial&&!x.envMap,G=e.get(x.envMap||V,Z),ce=d[x.type],Y=n.precision;x.precision!==null&&(Y=n.getMaxPrecision(x.precision),Y!==x.precision&&Ke("WebGLProgram.getParameters:",x.precision,"not supported, using",Y,"instead."));let Q=N.morphAttributes.position||N.morphAttributes.normal||N.morphAttributes.color,ie=Q!==void 0?Q.length:0,de=0;N.morphAttributes.position!==void 0&&(de=1),N.morphAttributes.normal!==void 0&&(de=2),N.morphAttributes.color!==void 0&&(de=3);let fe,ee,ge,ye;if(ce){let Ie=ls[ce];fe=Ie.vertexShader,ee=Ie.fragmentShader}else{fe=x.vertexShader,ee=x.fragmentShader;let Ie=a.getVertexShaderStage(x),ht=a.getFragmentShaderStage(x);a.update(x,Ie,ht),ge=Ie.id,ye=ht.id}let Pe=i.getRenderTarget(),we=i.state.buffers.depth.getReversed(),Ye=D.isInstancedMesh===!0,at=D.isBatchedMesh===!0,Xe=!!x.map,pt=!!x.matcap,ut=!!G,rt=ut&&G.isPMREMTexture===!0,jt=!!x.aoMap,Wt=!!x.lightMap,mn=!!x.bumpMap&&x.wireframe===!1,Ot=!!x.normalMap,Ln=!!x.displacementMap,St=!!x.emissiveMap,wn=!!x.metalnessMap,rn=!!x.roughnessMap,gn=x.anisotropy>0,k=x.clearcoat>0,Le=x.diffuseRoughness>0,Je=x.dispersion>0,lt=x.retroreflectivity>0,Ee=x.iridescence>0,kt=x.sheen>0,Ve=x.transmission>0,$e=gn&&!!x.anisotropyMap,I=k&&!!x.clearcoatMap,S=k&&!!x.clearcoatNormalMap,q=k&&!!x.clearcoatRoughnessMap,ue=Le&&!!x.diffuseRoughnessMap,oe=Ee&&!!x.iridescenceMap,xe=Ee&&!!x.iridescenceThicknessMap,ve=kt&&!!x.sheenColorMap,te=kt&&!!x.sheenRoughnessMap,se=!!x.specularMap,me=!!x.specularColorMap,B=!!x.specularIntensityMap,re=Ve&&!!x.transmissionMap,ne=Ve&&!!x.thicknessMap,Te=!!x.gradientMap,_e=!!x.alphaMap,Se=x.alphaTest>0,qe=!!x.alphaHash,et=!!x.extensions,he=os;x.toneMapped&&(Pe===null||Pe.isXRRenderTarget===!0)&&(he=i.toneMapping);let ze=rt?G.isCompressedCubeTexture?G.image[0].mipmaps:G.mipmaps:null,tt={shaderID:ce,shaderType:x.type,shaderName:x.name,vertexShader:fe,fragmentShader:ee,defines:x.defines,customVertexShaderID:ge,customFragmentShaderID:ye,isRawShaderMaterial:x.isRawShaderMaterial===!0,glslVersion:x.glslVersion,precision:Y,batching:at,batchingColor:at&&D._colorsTexture!==null,instancing:Ye,instancingColor:Ye&&D.instanceColor!==null,instancingMorph:Ye&&D.morphTexture!==null,outputColorSpace:Pe===null?i.outputColorSpace:Pe.isXRRenderTarget===!0?Pe.texture.colorSpace:Mt.workingColorSpace,alphaToCoverage:!!x.alphaToCoverage,map:Xe,matcap:pt,envMap:ut,envMapMode:ut&&G.mapping,envMapPMREM:rt,envMapMaxLod:rt?ze.length-1:null,envMapSize:rt?ze[0].width:null,aoMap:jt,lightMap:Wt,bumpMap:mn,normalMap:Ot,displacementMap:Ln,emissiveMap:St,normalMapObjectSpace:Ot&&x.normalMapType===Gg,normalMapTangentSpace:Ot&&x.normalMapType===Ya,packedNormalMap:Ot&&x.normalMapType===Ya&&$w(x.normalMap.format),metalnessMap:wn,roughnessMap:rn,anisotropy:gn,anisotropyMap:$e,clearcoat:k,clearcoatMap:I,clearcoatNormalMap:S,clearcoatRoughnessMap:q,diffuseRoughness:Le,diffuseRoughnessMap:ue,dispersion:Je,retroreflection:lt,iridescence:Ee,iridescenceMap:oe,iridescenceThicknessMap:xe,sheen:kt,sheenColorMap:ve,sheenRoughnessMap:te,specularMap:se,specularColorMap:me,specularIntensityMap:B,transmission:Ve,transmissionMap:re,thicknessMap:ne,gradientMap:Te,opaque:x.transparent===!1&&x.blending===Do&&x.alphaToCoverage===!1,alphaMap:_e,alphaTest:Se,alphaHash:qe,combine:x.combine,mapUv:Xe&&f(x.map.channel),aoMapUv:jt&&f(x.aoMap.channel),lightMapUv:Wt&&f(x.lightMap.channel),bumpMapUv:mn&&f(x.bumpMap.channel),normalMapUv:Ot&&f(x.normalMap.channel),displacementMapUv:Ln&&f(x.displacementMap.channel),emissiveMapUv:St&&f(x.emissiveMap.channel),metalnessMapUv:wn&&f(x.metalnessMap.channel),roughnessMapUv:rn&&f(x.roughnessMap.channel),anisotropyMapUv:$e&&f(x.anisotropyMap.channel),clearcoatMapUv:I&&f(x.clearcoatMap.channel),clearcoatNormalMapUv:S&&f(x.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:q&&f(x.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ue&&f(x.diffuseRoughnessMap.channel),iridescenceMapUv:oe&&f(x.iridescenceMap.channel),iridescenceThicknessMapUv:xe&&f(x.iridescenceThicknessMap.channel),sheenColorMapUv:ve&&f(x.sheenColorMap.channel),sheenRoughnessMapUv:te&&f(x.sheenRoughnessMap.channel),specularMapUv:se&&f(x.specularMap.channel),specularColorMapUv:me&&f(x.specularColorMap.channel),specularIntensityMapUv:B&&f(x.specularIntensityMap.channel),transmissionMapUv:re&&f(x.transmissionMap.channel),thicknessMapUv:ne&&f(x.thicknessMap.channel),alphaMapUv:_e&&f(x.alphaMap.channel),vertexTangents:!!N.attributes.tangent&&(Ot||gn),vertexNormals:!!N.attributes.normal,vertexColors:x.vertexColors,vertexAlphas:x.vertexColors===!0&&!!N.attributes.color&&N.attributes.color.itemSize===4,pointsUvs:D.isPoints===!0&&!!N.attributes.uv&&(Xe||_e),fog:!!W,useFog:x.fog===!0,fogExp2:!!W&&W.isFogExp2,flatShading:x.wireframe===!1&&(x.flatShading===!0||N.attributes.normal===void 0&&Ot===!1&&(x.isMeshLambertMaterial||x.isMeshPhongMaterial||x.isMeshStandardMaterial||x.isMeshPhysicalMaterial)),sizeAttenuation:x.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:we,skinning:D.isSkinnedMesh===!0,hasPositionAttribute:N.attributes.position!==void 0,morphTargets:N.morphAttributes.position!==void 0,morphNormals:N.morphAttributes.normal!==void 0,morphColors:N.morphAttributes.color!==void 0,morphTargetsCount:ie,morphTextureStride:de,numSunLights:w.sun.length,numDirLights:w.directional.length,numPointLights:w.point.length,numSpotLights:w.spot.length,numSpotLightMaps:w.spotLightMap.length,numRectAreaLights:w.rectArea.length,numHemiLights:w.hemi.length,numSunLightShadows:w.sunShadowMap.length,numDirLightShadows:w.directionalShadowMap.length,numPointLightShadows:w.pointShadowMap.length,numSpotLightShadows:w.spotShadowMap.length,numSpotLightShadowsWithMaps:w.numSpotLightShadowsWithMaps,numLightProbes:w.numLightProbes,numLightProbeGrids:z.filter(Ie=>Ie.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:x.dithering,shadowMapEnabled:i.shadowMap.enabled&&O.length>0,shadowMapType:i.shadowMap.type,toneMapping:he,decodeVideoTexture:Xe&&x.map.isVideoTexture===!0&&Mt.getTransfer(x.map.colorSpace)===Dt,decodeVideoTextureEmissive:St&&x.emissiveMap.isVideoTexture===!0&&Mt.getTransfer(x.emissiveMap.colorSpace)===Dt,premultipliedAlpha:x.premultipliedAlpha,doubleSided:x.side===Kn,flipSided:x.side===Gn,useDepthPacking:x.depthPacking>=0,depthPacking:x.depthPacking||0,index0AttributeName:x.index0AttributeName,extensionClipCullDistance:et&&x.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(et&&x.extensions.multiDraw===!0||at)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:x.customProgramCacheKey()};return tt.vertexUv1s=l.has(1),tt.vertexUv2s=l.has(2),tt.vertexUv3s=l.has(3),l.clear(),tt}function v(x){let w=[];if(x.shaderID?w.push(x.shaderID):(w.push(x.customVertexShaderID),w.push(x.customFragmentShaderID)),x.defines!==void 0)for(let O in x.defines)w.push(O),w.push(x.defines[O]);return x.isRawShaderMaterial===!1&&(g(w,x),m(w,x),w.push(i.outputColorSpace)),w.push(x.customProgramCacheKey),w.join()}function g(x,w){x.push(w.precision),x.push(w.outputColorSpace),x.push(w.envMapMode),x.push(w.envMapPMREM),x.push(w.envMapMaxLod),x.push(w.envMapSize),x.push(w.mapUv),x.push(w.alphaMapUv),x.push(w.lightMapUv),x.push(w.aoMapUv),x.push(w.bumpMapUv),x.push(w.normalMapUv),x.push(w.displacementMapUv),x.push(w.emissiveMapUv),x.push(w.metalnessMapUv),x.push(w.roughnessMapUv),x.push(w.anisotropyMapUv),x.push(w.clearcoatMapUv),x.push(w.clearcoatNormalMapUv),x.push(w.clearcoatRoughnessMapUv),x.push(w.diffuseRoughnessMapUv),x.push(w.iridescenceMapUv),x.push(w.iridescenceThicknessMapUv),x.push(w.sheenColorMapUv),x.push(w.sheenRoughnessMapUv),x.push(w.specularMapUv),x.push(w.specularColorMapUv),x.push(w.specularIntensityMapUv),x.push(w.transmissionMapUv),x.push(w.thicknessMapUv),x.push(w.combine),x.push(w.fogExp2),x.push(w.sizeAttenuation),x.push(w.morphTargetsCount),x.push(w.numSunLights),x.push(w.numDirLights),x.push(w.numPointLights),x.push(w.numSpotLights),x.push(w.numSpotLightMaps),x.push(w.numHemiLights),x.push(w.numRectAreaLights),x.push(w.numSunLightShadows),x.push(w.numDirLightShadows),x.push(w.numPointLightShadows),x.push(w.numSpotLightShadows),x.push(w.numSpotLightShadowsWithMaps),x.push(w.numLightProbes),x.push(w.numLightProbeGrids),x.push(w.shadowMapType),x.push(w.toneMapping),x.push(w.numClippingPlanes),x.push(w.numClipIntersection),x.push(w.depthPacking)}function m(x,w){o.disableAll(),w.instancing&&o.enable(0),w.instancingColor&&o.enable(1),w.instancingMorph&&o.enable(2),w.matcap&&o.enable(3),w.envMap&&o.enable(4),w.normalMapObjectSpace&&o.enable(5),w.normalMapTangentSpace&&o.enable(6),w.clearcoat&&o.enable(7),w.iridescence&&o.enable(8),w.alphaTest&&o.enable(9),w.vertexColors&&o.enable(10),w.vertexAlphas&&o.enable(11),w.vertexUv1s&&o.enable(12),w.vertexUv2s&&o.enable(13),w.vertexUv3s&&o.enable(14),w.vertexTangents&&o.enable(15),w.anisotropy&&o.enable(16),w.alphaHash&&o.enable(17),w.batching&&o.enable(18),w.dispersion&&o.enable(19),w.retroreflection&&o.enable(24),w.diffuseRoughness&&o.enable(25),w.batchingColor&&o.enable(20),w.gradientMap&&o.enable(21),w.packedNormalMap&&o.enable(22),w.vertexNormals&&o.enable(23),x.push(o.mask),o.disableAll(),w.fog&&o.enable(0),w.useFog&&o.enable(1),w.flatShading&&o.enable(2),w.logarithmicDepthBuffer&&o.enable(3),w.reversedDepthBuffer&&o.enable(4),w.skinning&&o.enable(5),w.morphTargets&&o.enable(6),w.morphNormals&&o.enable(7),w.morphColors&&o.enable(8),w.premultipliedAlpha&&o.enable(9),w.shadowMapEnabled&&o.enable(10),w.doubleSided&&o.enable(11),w.flipSided&&o.enable(12),w.useDepthPacking&&o.enable(13),w.dithering&&o.enable(14),w.transmission&&o.enable(15),w.sheen&&o.enable(16),w.opaque&&o.enable(17),w.pointsUvs&&o.enable(18),w.decodeVideoTexture&&o.enable(19),w.decodeVideoTextureEmissive&&o.enable(20),w.alphaToCoverage&&o.enable(21),w.numLightProbeGrids>0&&o.enable(22),w.hasPositionAttribute&&o.enable(23),x.push(o.mask)}function _(x){let w=d[x.type],O;if(w){let P=ls[w];O=i0.clone(P.uniforms)}else O=x.uniforms;return O}function E(x,w){let O=h.get(w);return O!==void 0?++O.usedTimes:(O=new Yw(i,w,x,s),c.push(O),h.set(w,O)),O}function b(x){if(--x.usedTimes===0){let w=c.indexOf(x);c[w]=c[c.length-1],c.pop(),h.delete(x.cacheKey),x.destroy()}}function C(x){a.remove(x)}function M(){a.dispose()}return{getParameters:p,getProgramCacheKey:v,getUniforms:_,acquireProgram:E,releaseProgram:b,releaseShaderCache:C,programs:c,dispose:M}}function Jw(){let i=new WeakMap;function e(o){return i.has(o)}function t(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:e,get:t,remove:n,update:s,dispose:r}}function jw(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.materialVariant!==e.materialVariant?i.materialVariant-e.materialVariant:i.z!==e.z?i.z-e.z:i.id-e.id}function S0(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function w0(){let i=[],e=0,t=[],n=[],s=[];function r(){e=0,t.length=0,n.length=0,s.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,p,v,g,m){let _=i[e];return _===void 0?(_={id:d.id,object:d,geometry:f,material:p,materialVariant:o(d),groupOrder:v,renderOrder:d.renderOrder,z:g,group:m},i[e]=_):(_.id=d.id,_.object=d,_.geometry=f,_.material=p,_.materialVariant=o(d),_.groupOrder=v,_.renderOrder=d.renderOrder,_.z=g,_.group=m),e++,_}function l(d,f,p,v,g,m,_){_.reversedDepth===!0&&(g=-g);let E=a(d,f,p,v,g,m);p.transmission>0?n.push(E):p.transparent===!0?s.push(E):t.push(E)}function c(d,f,p,v,g,m){let _=a(d,f,p,v,g,m);p.transmission>0?n.unshift(_):p.transparent===!0?s.unshift(_):t.unshift(_)}function h(d,f){t.length>1&&t.sort(d||jw),n.length>1&&n.sort(f||S0),s.length>1&&s.sort(f||S0)}function u(){for(let d=e,f=i.length;d<f;d++){let p=i[d];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:t,transmissive:n,transparent:s,init:r,push:l,unshift:c,finish:u,sort:h}}function Qw(){let i=new WeakMap;function e(n,s){let r=i.get(n),o;return r===void 0?(o=new w0,i.set(n,[o])):s>=r.length?(o=new w0,r.push(o)):o=r[s],o}function t(){i=new WeakMap}return{get:e,dispose:t}}function eE(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new F,color:new Qe};break;case"SpotLight":t={position:new F,direction:new F,color:new Qe,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new F,color:new Qe,distance:0,decay:0};break;case"HemisphereLight":t={direction:new F,skyColor:new Qe,groundColor:new Qe};break;case"RectAreaLight":t={color:new Qe,position:new F,halfWidth:new F,halfHeight:new F};break}return i[e.id]=t,t}}}function tE(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new We};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new We};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new We,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t}}}var nE=0;function iE(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function sE(i){let e=new eE,t=tE(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new F);let s=new F,r=new wt,o=new wt;function a(c){let h=0,u=0,d=0;for(let z=0;z<9;z++)n.probe[z].set(0,0,0);let f=0,p=0,v=0,g=0,m=0,_=0,E=0,b=0,C=0,M=0,x=0,w=0,O=0,P=0;c.sort(iE);for(let z=0,W=c.length;z<W;z++){let N=c[z],V=N.color,Z=N.intensity,G=N.distance,ce=null;if(N.shadow&&N.shadow.map&&(N.shadow.map.texture.format===rr?ce=N.shadow.map.texture:ce=N.shadow.map.depthTexture||N.shadow.map.texture),N.isAmbientLight)h+=V.r*Z,u+=V.g*Z,d+=V.b*Z;else if(N.isLightProbe){for(let Y=0;Y<9;Y++)n.probe[Y].addScaledVector(N.sh.coefficients[Y],Z);P++}else if(N.isSunLight){let Y=e.get(N);if(Y.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let Q=N.shadow,ie=t.get(N);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),n.sunShadow[p]=ie,n.sunShadowMap[p]=ce;let de=Q.getViewportCount();for(let fe=0;fe<de;fe++)n.sunShadowMatrix[v+fe]=Q.getMatrix(fe),n.sunShadowCascade[v+fe]=Q._cascadeData[fe];v+=de,p++}n.sun[f]=Y,f++}else if(N.isDirectionalLight){let Y=e.get(N);if(Y.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let Q=N.shadow,ie=t.get(N);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize=Q.mapSize,n.directionalShadow[g]=ie,n.directionalShadowMap[g]=ce,n.directionalShadowMatrix[g]=N.shadow.matrix,C++}n.directional[g]=Y,g++}else if(N.isSpotLight){let Y=e.get(N);Y.position.setFromMatrixPosition(N.matrixWorld),Y.color.copy(V).multiplyScalar(Z),Y.distance=G,Y.coneCos=Math.cos(N.angle),Y.penumbraCos=Math.cos(N.angle*(1-N.penumbra)),Y.decay=N.decay,n.spot[_]=Y;let Q=N.shadow;if(N.map&&(n.spotLightMap[w]=N.map,w++,Q.updateMatrices(N),N.castShadow&&O++),n.spotLightMatrix[_]=Q.matrix,N.castShadow){let ie=t.get(N);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize=Q.mapSize,n.spotShadow[_]=ie,n.spotShadowMap[_]=ce,x++}_++}else if(N.isRectAreaLight){let Y=e.get(N);Y.color.copy(V).multiplyScalar(Z),Y.halfWidth.set(N.width*.5,0,0),Y.halfHeight.set(0,N.height*.5,0),n.rectArea[E]=Y,E++}else if(N.isPointLight){let Y=e.get(N);if(Y.color.copy(N.color).multiplyScalar(N.intensity),Y.distance=N.distance,Y.decay=N.decay,N.castShadow){let Q=N.shadow,ie=t.get(N);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize=Q.mapSize,ie.shadowCameraNear=Q.camera.near,ie.shadowCameraFar=Q.camera.far,n.pointShadow[m]=ie,n.pointShadowMap[m]=ce,n.pointShadowMatrix[m]=N.shadow.matrix,M++}n.point[m]=Y,m++}else if(N.isHemisphereLight){let Y=e.get(N);Y.skyColor.copy(N.color).multiplyScalar(Z),Y.groundColor.copy(N.groundColor).multiplyScalar(Z),n.hemi[b]=Y,b++}}E>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Ue.LTC_FLOAT_1,n.rectAreaLTC2=Ue.LTC_FLOAT_2):(n.rectAreaLTC1=Ue.LTC_HALF_1,n.rectAreaLTC2=Ue.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=u,n.ambient[2]=d;let D=n.hash;(D.sunLength!==f||D.directionalLength!==g||D.pointLength!==m||D.spotLength!==_||D.rectAreaLength!==E||D.hemiLength!==b||D.numSunShadows!==p||D.numDirectionalShadows!==C||D.numPointShadows!==M||D.numSpotShadows!==x||D.numSpotMaps!==w||D.numLightProbes!==P)&&(n.sun.length=f,n.directional.length=g,n.spot.length=_,n.rectArea.length=E,n.point.length=m,n.hemi.length=b,n.sunShadow.length=p,n.sunShadowMap.length=p,n.sunShadowMatrix.length=v,n.sunShadowCascade.length=v,n.directionalShadow.length=C,n.directionalShadowMap.length=C,n.directionalShadowMatrix.length=C,n.pointShadow.length=M,n.pointShadowMap.length=M,n.pointShadowMatrix.length=M,n.spotShadow.length=x,n.spotShadowMap.length=x,n.spotLightMatrix.length=x+w-O,n.spotLightMap.length=w,n.numSpotLightShadowsWithMaps=O,n.numLightProbes=P,D.sunLength=f,D.directionalLength=g,D.pointLength=m,D.spotLength=_,D.rectAreaLength=E,D.hemiLength=b,D.numSunShadows=p,D.numDirectionalShadows=C,D.numPointShadows=M,D.numSpotShadows=x,D.numSpotMaps=w,D.numLightProbes=P,n.version=nE++)}function l(c,h){let u=0,d=0,f=0,p=0,v=0,g=0,m=h.matrixWorldInverse;for(let _=0,E=c.length;_<E;_++){let b=c[_];if(b.isSunLight){let C=n.sun[u];C.direction.setFromMatrixPosition(b.matrixWorld),C.direction.transformDirection(m),u++}else if(b.isDirectionalLight){let C=n.directional[d];C.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(m),d++}else if(b.isSpotLight){let C=n.spot[p];C.position.setFromMatrixPosition(b.matrixWorld),C.position.applyMatrix4(m),C.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(m),p++}else if(b.isRectAreaLight){let C=n.rectArea[v];C.position.setFromMatrixPosition(b.matrixWorld),C.position.applyMatrix4(m),o.identity(),r.copy(b.matrixWorld),r.premultiply(m),o.extractRotation(r),C.halfWidth.set(b.width*.5,0,0),C.halfHeight.set(0,b.height*.5,0),C.halfWidth.applyMatrix4(o),C.halfHeight.applyMatrix4(o),v++}else if(b.isPointLight){let C=n.point[f];C.position.setFromMatrixPosition(b.matrixWorld),C.position.applyMatrix4(m),f++}else if(b.isHemisphereLight){let C=n.hemi[g];C.direction.setFromMatrixPosition(b.matrixWorld),C.direction.transformDirection(m),g++}}}return{setup:a,setupView:l,state:n}}function E0(i){let e=new sE(i),t=[],n=[],s=[];function r(u){h.camera=u,t.length=0,n.length=0,s.length=0}function o(u){u.isLightProbeGrid?s.push(u):t.push(u)}function a(u){n.push(u)}function l(){e.setup(t),s.sort((u,d)=>u.priority-d.priority||u.id-d.id)}function c(u){e.setupView(t,u)}let h={lightsArray:t,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function rE(i){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new E0(i),e.set(s,[a])):r>=o.length?(a=new E0(i),o.push(a)):a=o[r],a}function n(){e=new WeakMap}return{get:t,dispose:n}}var oE=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,aE=`uniform sampler2D shadow_pass;
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
}`,lE=[new F(1,0,0),new F(-1,0,0),new F(0,1,0),new F(0,-1,0),new F(0,0,1),new F(0,0,-1)],cE=[new F(0,-1,0),new F(0,-1,0),new F(0,0,1),new F(0,0,-1),new F(0,-1,0),new F(0,-1,0)],T0=new wt,Za=new F,rf=new F;function hE(i,e,t){let n=new js,s=new We,r=new We,o=new Xt,a=new vc,l=new bc,c={},h=t.maxTextureSize,u={[rs]:Gn,[Gn]:rs,[Kn]:Kn},d=new Ci({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new We},radius:{value:4}},vertexShader:oE,fragmentShader:aE}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let p=new Pt;p.setAttribute("position",new en(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let v=new Ce(p,d),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Ar;let m=this.type;this.render=function(M,x,w){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||M.length===0)return;this.type===yg&&(Ke("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Ar);let O=i.getRenderTarget(),P=i.getActiveCubeFace(),D=i.getActiveMipmapLevel(),z=i.state;z.setBlending(Rr),z.buffers.depth.getReversed()===!0?z.buffers.color.setClear(0,0,0,0):z.buffers.color.setClear(1,1,1,1),z.buffers.depth.setTest(!0),z.setScissorTest(!1);let W=m!==this.type;W&&x.traverse(function(N){N.material&&(Array.isArray(N.material)?N.material.forEach(V=>V.needsUpdate=!0):N.material.needsUpdate=!0)});for(let N=0,V=M.length;N<V;N++){let Z=M[N],G=Z.shadow;if(G===void 0){Ke("WebGLShadowMap:",Z,"has no shadow.");continue}if(G.autoUpdate===!1&&G.needsUpdate===!1)continue;s.copy(G.mapSize);let ce=G.getFrameExtents();s.multiply(ce),r.copy(G.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/ce.x),s.x=r.x*ce.x,G.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/ce.y),s.y=r.y*ce.y,G.mapSize.y=r.y));let Y=i.state.buffers.depth.getReversed();if(G.camera._reversedDepth=Y,G.map===null||W===!0){if(G.map!==null&&(G.map.depthTexture!==null&&(G.map.depthTexture.dispose(),G.map.depthTexture=null),G.map.dispose()),this.type===Lo){if(Z.isPointLight){Ke("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}G.map=new vi(s.x,s.y,{format:rr,type:Vi,minFilter:ri,magFilter:ri,generateMipmaps:!1}),G.map.texture.name=Z.name+".shadowMap",G.map.depthTexture=new As(s.x,s.y,Gi),G.map.depthTexture.name=Z.name+".shadowMapDepth",G.map.depthTexture.format=Es,G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=Bn,G.map.depthTexture.magFilter=Bn}else Z.isPointLight?(G.map=new Ka(s.x),G.map.depthTexture=new Aa(s.x,Hi)):(G.map=new vi(s.x,s.y),G.map.depthTexture=new As(s.x,s.y,Hi)),G.map.depthTexture.name=Z.name+".shadowMap",G.map.depthTexture.format=Es,this.type===Ar?(G.map.depthTexture.compareFunction=Y?Xd:Wd,G.map.depthTexture.minFilter=ri,G.map.depthTexture.magFilter=ri):(G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=Bn,G.map.depthTexture.magFilter=Bn);G.camera.updateProjectionMatrix()}G.map.isWebGLCubeRenderTarget!==!0&&(G.map.width!==s.x||G.map.height!==s.y)&&G.map.setSize(s.x,s.y);let Q=G.map.isWebGLCubeRenderTarget?6:G.getViewportCount();Z.isPointLight!==!0&&G.updateMatrices(Z,w);let ie=(G.camera.layers.mask&4294967294)!==0?G.camera.layers:w.layers;for(let de=0;de<Q;de++){let fe=G.getCamera(de);if(Z.isPointLight){let ee=G.camera,ge=G.matrix,ye=Z.distance||ee.far;ye!==ee.far&&(ee.far=ye,ee.updateProjectionMatrix()),Za.setFromMatrixPosition(Z.matrixWorld),ee.position.copy(Za),rf.copy(ee.position),rf.add(lE[de]),ee.up.copy(cE[de]),ee.lookAt(rf),ee.updateMatrixWorld(),ge.makeTranslation(-Za.x,-Za.y,-Za.z),T0.multiplyMatrices(ee.projectionMatrix,ee.matrixWorldInverse),G._frustum.setFromProjectionMatrix(T0,ee.coordinateSystem,ee.reversedDepth)}if(G.map.isWebGLCubeRenderTarget)i.setRenderTarget(G.map,de),i.clear();else{de===0&&(i.setRenderTarget(G.map),i.clear());let ee=G.getViewport(de);o.set(r.x*ee.x,r.y*ee.y,r.x*ee.z,r.y*ee.w),z.viewport(o)}n=G.getFrustum(de),b(x,w,fe,Z,ie,this.type)}G.isPointLightShadow!==!0&&this.type===Lo&&_(G,w),G.needsUpdate=!1}m=this.type,g.needsUpdate=!1,i.setRenderTarget(O,P,D)};function _(M,x){let w=e.update(v);d.defines.VSM_SAMPLES!==M.blurSamples&&(d.defines.VSM_SAMPLES=M.blurSamples,f.defines.VSM_SAMPLES=M.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),M.mapPass===null?M.mapPass=new vi(s.x,s.y,{format:rr,type:Vi}):(M.mapPass.width!==M.map.width||M.mapPass.height!==M.map.height)&&M.mapPass.setSize(M.map.width,M.map.height),d.uniforms.shadow_pass.value=M.map.depthTexture,d.uniforms.resolution.value.set(M.map.width,M.map.height),d.uniforms.radius.value=M.radius,i.setRenderTarget(M.mapPass),i.clear(),i.renderBufferDirect(x,null,w,d,v,null),f.uniforms.shadow_pass.value=M.mapPass.texture,f.uniforms.resolution.value.set(M.map.width,M.map.height),f.uniforms.radius.value=M.radius,i.setRenderTarget(M.map),i.clear(),i.renderBufferDirect(x,null,w,f,v,null)}function E(M,x,w,O){let P=null,D=w.isPointLight===!0?M.customDistanceMaterial:M.customDepthMaterial;if(D!==void 0)P=D;else if(P=w.isPointLight===!0?l:a,i.localClippingEnabled&&x.clipShadows===!0&&Array.isArray(x.clippingPlanes)&&x.clippingPlanes.length!==0||x.displacementMap&&x.displacementScale!==0||x.alphaMap&&x.alphaTest>0||x.map&&x.alphaTest>0||x.alphaToCoverage===!0){let z=P.uuid,W=x.uuid,N=c[z];N===void 0&&(N={},c[z]=N);let V=N[W];V===void 0&&(V=P.clone(),N[W]=V,x.addEventListener("dispose",C)),P=V}if(P.visible=x.visible,P.wireframe=x.wireframe,O===Lo?P.side=x.shadowSide!==null?x.shadowSide:x.side:P.side=x.shadowSide!==null?x.shadowSide:u[x.side],P.alphaMap=x.alphaMap,P.alphaTest=x.alphaToCoverage===!0?.5:x.alphaTest,P.map=x.map,P.clipShadows=x.clipShadows,P.clippingPlanes=x.clippingPlanes,P.clipIntersection=x.clipIntersection,P.displacementMap=x.displacementMap,P.displacementScale=x.displacementScale,P.displacementBias=x.displacementBias,P.wireframeLinewidth=x.wireframeLinewidth,P.linewidth=x.linewidth,w.isPointLight===!0&&P.isMeshDistanceMaterial===!0){let z=i.properties.get(P);z.light=w}return P}function b(M,x,w,O,P,D){if(M.visible===!1)return;if(M.layers.test(P)&&(M.isMesh||M.isLine||M.isPoints)&&(M.castShadow||M.receiveShadow&&D===Lo)&&(!M.frustumCulled||M.intersectsFrustum(n))){M.modelViewMatrix.multiplyMatrices(w.matrixWorldInverse,M.matrixWorld);let N=e.update(M),V=M.material;if(Array.isArray(V)){let Z=N.groups;for(let G=0,ce=Z.length;G<ce;G++){let Y=Z[G],Q=V[Y.materialIndex];if(Q&&Q.visible){let ie=E(M,Q,O,D);M.onBeforeShadow(i,M,x,w,N,ie,Y),i.renderBufferDirect(w,null,N,ie,M,Y),M.onAfterShadow(i,M,x,w,N,ie,Y)}}}else if(V.visible){let Z=E(M,V,O,D);M.onBeforeShadow(i,M,x,w,N,Z,null),i.renderBufferDirect(w,null,N,Z,M,null),M.onAfterShadow(i,M,x,w,N,Z,null)}}let W=M.children;for(let N=0,V=W.length;N<V;N++)b(W[N],x,w,O,P,D)}function C(M){M.target.removeEventListener("dispose",C);for(let w in c){let O=c[w],P=M.target.uuid;P in O&&(O[P].dispose(),delete O[P])}}}function uE(i,e){function t(){let B=!1,re=new Xt,ne=null,Te=new Xt(0,0,0,0);return{setMask:function(_e){ne!==_e&&!B&&(i.colorMask(_e,_e,_e,_e),ne=_e)},setLocked:function(_e){B=_e},setClear:function(_e,Se,qe,et,he){he===!0&&(_e*=et,Se*=et,qe*=et),re.set(_e,Se,qe,et),Te.equals(re)===!1&&(i.clearColor(_e,Se,qe,et),Te.copy(re))},reset:function(){B=!1,ne=null,Te.set(-1,0,0,0)}}}function n(){let B=!1,re=!1,ne=null,Te=null,_e=null;return{setReversed:function(Se){if(re!==Se){let qe=e.get("EXT_clip_control");Se?qe.clipControlEXT(qe.LOWER_LEFT_EXT,qe.ZERO_TO_ONE_EXT):qe.clipControlEXT(qe.LOWER_LEFT_EXT,qe.NEGATIVE_ONE_TO_ONE_EXT),re=Se;let et=_e;_e=null,this.setClear(et)}},getReversed:function(){return re},setTest:function(Se){Se?we(i.DEPTH_TEST):Ye(i.DEPTH_TEST)},setMask:function(Se){ne!==Se&&!B&&(i.depthMask(Se),ne=Se)},setFunc:function(Se){if(re&&(Se=Qg[Se]),Te!==Se){switch(Se){case ic:i.depthFunc(i.NEVER);break;case sc:i.depthFunc(i.ALWAYS);break;case rc:i.depthFunc(i.LESS);break;case bo:i.depthFunc(i.LEQUAL);break;case oc:i.depthFunc(i.EQUAL);break;case ac:i.depthFunc(i.GEQUAL);break;case lc:i.depthFunc(i.GREATER);break;case cc:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}Te=Se}},setLocked:function(Se){B=Se},setClear:function(Se){_e!==Se&&(_e=Se,re&&(Se=1-Se),i.clearDepth(Se))},reset:function(){B=!1,ne=null,Te=null,_e=null,re=!1}}}function s(){let B=!1,re=null,ne=null,Te=null,_e=null,Se=null,qe=null,et=null,he=null;return{setTest:function(ze){B||(ze?we(i.STENCIL_TEST):Ye(i.STENCIL_TEST))},setMask:function(ze){re!==ze&&!B&&(i.stencilMask(ze),re=ze)},setFunc:function(ze,tt,Ie){(ne!==ze||Te!==tt||_e!==Ie)&&(i.stencilFunc(ze,tt,Ie),ne=ze,Te=tt,_e=Ie)},setOp:function(ze,tt,Ie){(Se!==ze||qe!==tt||et!==Ie)&&(i.stencilOp(ze,tt,Ie),Se=ze,qe=tt,et=Ie)},setLocked:function(ze){B=ze},setClear:function(ze){he!==ze&&(i.clearStencil(ze),he=ze)},reset:function(){B=!1,re=null,ne=null,Te=null,_e=null,Se=null,qe=null,et=null,he=null}}}let r=new t,o=new n,a=new s,l={},c=new WeakMap,h={},u={},d={},f=new WeakMap,p=[],v=null,g=!1,m=null,_=null,E=null,b=null,C=null,M=null,x=null,w=new Qe(0,0,0),O=0,P=!1,D=null,z=null,W=null,N=null,V=null,Z=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),G=!1,ce=0,Y=i.getParameter(i.VERSION);Y.indexOf("WebGL")!==-1?(ce=parseFloat(/^WebGL (\d)/.exec(Y)[1]),G=ce>=1):Y.indexOf("OpenGL ES")!==-1&&(ce=parseFloat(/^OpenGL ES (\d)/.exec(Y)[1]),G=ce>=2);let Q=null,ie={},de=i.getParameter(i.SCISSOR_BOX),fe=i.getParameter(i.VIEWPORT),ee=new Xt().fromArray(de),ge=new Xt().fromArray(fe);function ye(B,re,ne,Te){let _e=new Uint8Array(4),Se=i.createTexture();i.bindTexture(B,Se),i.texParameteri(B,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(B,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let qe=0;qe<ne;qe++)B===i.TEXTURE_3D||B===i.TEXTURE_2D_ARRAY?i.texImage3D(re,0,i.RGBA,1,1,Te,0,i.RGBA,i.UNSIGNED_BYTE,_e):i.texImage2D(re+qe,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,_e);return Se}let Pe={};Pe[i.TEXTURE_2D]=ye(i.TEXTURE_2D,i.TEXTURE_2D,1),Pe[i.TEXTURE_CUBE_MAP]=ye(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Pe[i.TEXTURE_2D_ARRAY]=ye(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Pe[i.TEXTURE_3D]=ye(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),we(i.DEPTH_TEST),o.setFunc(bo),mn(!1),Ot(bd),we(i.CULL_FACE),jt(Rr);function we(B){h[B]!==!0&&(i.enable(B),h[B]=!0)}function Ye(B){h[B]!==!1&&(i.disable(B),h[B]=!1)}function at(B,re){return d[B]!==re?(i.bindFramebuffer(B,re),d[B]=re,B===i.DRAW_FRAMEBUFFER&&(d[i.FRAMEBUFFER]=re),B===i.FRAMEBUFFER&&(d[i.DRAW_FRAMEBUFFER]=re),!0):!1}function Xe(B,re){let ne=p,Te=!1;if(B){ne=f.get(re),ne===void 0&&(ne=[],f.set(re,ne));let _e=B.textures;if(ne.length!==_e.length||ne[0]!==i.COLOR_ATTACHMENT0){for(let Se=0,qe=_e.length;Se<qe;Se++)ne[Se]=i.COLOR_ATTACHMENT0+Se;ne.length=_e.length,Te=!0}}else ne[0]!==i.BACK&&(ne[0]=i.BACK,Te=!0);Te&&i.drawBuffers(ne)}function pt(B){return v!==B?(i.useProgram(B),v=B,!0):!1}let ut={[Cr]:i.FUNC_ADD,[bg]:i.FUNC_SUBTRACT,[Mg]:i.FUNC_REVERSE_SUBTRACT};ut[Sg]=i.MIN,ut[wg]=i.MAX;let rt={[Eg]:i.ZERO,[Tg]:i.ONE,[Ag]:i.SRC_COLOR,[Td]:i.SRC_ALPHA,[Dg]:i.SRC_ALPHA_SATURATE,[Ig]:i.DST_COLOR,[Cg]:i.DST_ALPHA,[Rg]:i.ONE_MINUS_SRC_COLOR,[Ad]:i.ONE_MINUS_SRC_ALPHA,[Lg]:i.ONE_MINUS_DST_COLOR,[Pg]:i.ONE_MINUS_DST_ALPHA,[Ng]:i.CONSTANT_COLOR,[Ug]:i.ONE_MINUS_CONSTANT_COLOR,[Fg]:i.CONSTANT_ALPHA,[Og]:i.ONE_MINUS_CONSTANT_ALPHA};function jt(B,re,ne,Te,_e,Se,qe,et,he,ze){if(B===Rr){g===!0&&(Ye(i.BLEND),g=!1);return}if(g===!1&&(we(i.BLEND),g=!0),B!==vg){if(B!==m||ze!==P){if((_!==Cr||C!==Cr)&&(i.blendEquation(i.FUNC_ADD),_=Cr,C=Cr),ze)switch(B){case Do:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Sd:i.blendFunc(i.ONE,i.ONE);break;case wd:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case Ed:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:nt("WebGLState: Invalid blending: ",B);break}else switch(B){case Do:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Sd:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case wd:nt("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Ed:nt("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:nt("WebGLState: Invalid blending: ",B);break}E=null,b=null,M=null,x=null,w.set(0,0,0),O=0,m=B,P=ze}return}_e=_e||re,Se=Se||ne,qe=qe||Te,(re!==_||_e!==C)&&(i.blendEquationSeparate(ut[re],ut[_e]),_=re,C=_e),(ne!==E||Te!==b||Se!==M||qe!==x)&&(i.blendFuncSeparate(rt[ne],rt[Te],rt[Se],rt[qe]),E=ne,b=Te,M=Se,x=qe),(et.equals(w)===!1||he!==O)&&(i.blendColor(et.r,et.g,et.b,he),w.copy(et),O=he),m=B,P=!1}function Wt(B,re){B.side===Kn?Ye(i.CULL_FACE):we(i.CULL_FACE);let ne=B.side===Gn;re&&(ne=!ne),mn(ne),B.blending===Do&&B.transparent===!1?jt(Rr):jt(B.blending,B.blendEquation,B.blendSrc,B.blendDst,B.blendEquationAlpha,B.blendSrcAlpha,B.blendDstAlpha,B.blendColor,B.blendAlpha,B.premultipliedAlpha),o.setFunc(B.depthFunc),o.setTest(B.depthTest),o.setMask(B.depthWrite),r.setMask(B.colorWrite);let Te=B.stencilWrite;a.setTest(Te),Te&&(a.setMask(B.stencilWriteMask),a.setFunc(B.stencilFunc,B.stencilRef,B.stencilFuncMask),a.setOp(B.stencilFail,B.stencilZFail,B.stencilZPass)),St(B.polygonOffset,B.polygonOffsetFactor,B.polygonOffsetUnits),B.alphaToCoverage===!0?we(i.SAMPLE_ALPHA_TO_COVERAGE):Ye(i.SAMPLE_ALPHA_TO_COVERAGE)}function mn(B){D!==B&&(B?i.frontFace(i.CW):i.frontFace(i.CCW),D=B)}function Ot(B){B!==_g?(we(i.CULL_FACE),B!==z&&(B===bd?i.cullFace(i.BACK):B===xg?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Ye(i.CULL_FACE),z=B}function Ln(B){B!==W&&(G&&i.lineWidth(B),W=B)}function St(B,re,ne){B?(we(i.POLYGON_OFFSET_FILL),(N!==re||V!==ne)&&(N=re,V=ne,o.getReversed()&&(re=-re,ne=-ne),i.polygonOffset(re,ne))):Ye(i.POLYGON_OFFSET_FILL)}function wn(B){B?we(i.SCISSOR_TEST):Ye(i.SCISSOR_TEST)}function rn(B){B===void 0&&(B=i.TEXTURE0+Z-1),Q!==B&&(i.activeTexture(B),Q=B)}function gn(B,re,ne){ne===void 0&&(Q===null?ne=i.TEXTURE0+Z-1:ne=Q);let Te=ie[ne];Te===void 0&&(Te={type:void 0,texture:void 0},ie[ne]=Te),(Te.type!==B||Te.texture!==re)&&(Q!==ne&&(i.activeTexture(ne),Q=ne),i.bindTexture(B,re||Pe[B]),Te.type=B,Te.texture=re)}function k(){let B=ie[Q];B!==void 0&&B.type!==void 0&&(i.bindTexture(B.type,null),B.type=void 0,B.texture=void 0)}function Le(){try{i.compressedTexImage2D(...arguments)}catch(B){nt("WebGLState:",B)}}function Je(){try{i.compressedTexImage3D(...arguments)}catch(B){nt("WebGLState:",B)}}function lt(){try{i.texSubImage2D(...arguments)}catch(B){nt("WebGLState:",B)}}function Ee(){try{i.texSubImage3D(...arguments)}catch(B){nt("WebGLState:",B)}}function kt(){try{i.compressedTexSubImage2D(...arguments)}catch(B){nt("WebGLState:",B)}}function Ve(){try{i.compressedTexSubImage3D(...arguments)}catch(B){nt("WebGLState:",B)}}function $e(){try{i.texStorage2D(...arguments)}catch(B){nt("WebGLState:",B)}}function I(){try{i.texStorage3D(...arguments)}catch(B){nt("WebGLState:",B)}}function S(){try{i.texImage2D(...arguments)}catch(B){nt("WebGLState:",B)}}function q(){try{i.texImage3D(...arguments)}catch(B){nt("WebGLState:",B)}}function ue(B){return u[B]!==void 0?u[B]:i.getParameter(B)}function oe(B,re){u[B]!==re&&(i.pixelStorei(B,re),u[B]=re)}function xe(B){ee.equals(B)===!1&&(i.scissor(B.x,B.y,B.z,B.w),ee.copy(B))}function ve(B){ge.equals(B)===!1&&(i.viewport(B.x,B.y,B.z,B.w),ge.copy(B))}function te(B,re){let ne=c.get(re);ne===void 0&&(ne=new WeakMap,c.set(re,ne));let Te=ne.get(B);Te===void 0&&(Te=i.getUniformBlockIndex(re,B.name),i.uniformBlockBinding(re,Te,Te),ne.set(B,Te))}function se(B,re,ne){let _e=c.get(re).get(B);l[_e]!==ne&&(i.bindBufferBase(i.UNIFORM_BUFFER,_e,ne),l[_e]=ne)}function me(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),h={},u={},Q=null,ie={},d={},l={},f=new WeakMap,p=[],v=null,g=!1,m=null,_=null,E=null,b=null,C=null,M=null,x=null,w=new Qe(0,0,0),O=0,P=!1,D=null,z=null,W=null,N=null,V=null,ee.set(0,0,i.canvas.width,i.canvas.height),ge.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:we,disable:Ye,bindFramebuffer:at,drawBuffers:Xe,useProgram:pt,setBlending:jt,setMaterial:Wt,setFlipSided:mn,setCullFace:Ot,setLineWidth:Ln,setPolygonOffset:St,setScissorTest:wn,activeTexture:rn,bindTexture:gn,unbindTexture:k,compressedTexImage2D:Le,compressedTexImage3D:Je,texImage2D:S,texImage3D:q,pixelStorei:oe,getParameter:ue,updateUBOMapping:te,uniformBlockBinding:se,texStorage2D:$e,texStorage3D:I,texSubImage2D:lt,texSubImage3D:Ee,compressedTexSubImage2D:kt,compressedTexSubImage3D:Ve,scissor:xe,viewport:ve,reset:me}}function dE(i,e,t,n,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new We,h=new WeakMap,u=new Set,d,f=new WeakMap,p=new Set,v=new FinalizationRegistry(I=>p.delete(I)),g=!1;try{g=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(I,S){return g?new OffscreenCanvas(I,S):xa("canvas")}function _(I,S,q){let ue=1,oe=$e(I);if((oe.width>q||oe.height>q)&&(ue=q/Math.max(oe.width,oe.height)),ue<1)if(typeof HTMLImageElement<"u"&&I instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&I instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&I instanceof ImageBitmap||typeof VideoFrame<"u"&&I instanceof VideoFrame){let xe=Math.floor(ue*oe.width),ve=Math.floor(ue*oe.height);d===void 0&&(d=m(xe,ve));let te=S?m(xe,ve):d;return te.width=xe,te.height=ve,te.getContext("2d").drawImage(I,0,0,xe,ve),Ke("WebGLRenderer: Texture has been resized from ("+oe.width+"x"+oe.height+") to ("+xe+"x"+ve+")."),te}else return"data"in I&&Ke("WebGLRenderer: Image in DataTexture is too big ("+oe.width+"x"+oe.height+")."),I;return I}function E(I){return I.generateMipmaps}function b(I){i.generateMipmap(I)}function C(I){return I.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:I.isWebGL3DRenderTarget?i.TEXTURE_3D:I.isWebGLArrayRenderTarget||I.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function M(I,S,q,ue,oe,xe=!1){if(I!==null){if(i[I]!==void 0)return i[I];Ke("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+I+"'")}let ve;ue&&(ve=e.get("EXT_texture_norm16"),ve||Ke("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let te=S;if(S===i.RED&&(q===i.FLOAT&&(te=i.R32F),q===i.HALF_FLOAT&&(te=i.R16F),q===i.UNSIGNED_BYTE&&(te=i.R8),q===i.UNSIGNED_SHORT&&ve&&(te=ve.R16_EXT),q===i.SHORT&&ve&&(te=ve.R16_SNORM_EXT)),S===i.RED_INTEGER&&(q===i.UNSIGNED_BYTE&&(te=i.R8UI),q===i.UNSIGNED_SHORT&&(te=i.R16UI),q===i.UNSIGNED_INT&&(te=i.R32UI),q===i.BYTE&&(te=i.R8I),q===i.SHORT&&(te=i.R16I),q===i.INT&&(te=i.R32I)),S===i.RG&&(q===i.FLOAT&&(te=i.RG32F),q===i.HALF_FLOAT&&(te=i.RG16F),q===i.UNSIGNED_BYTE&&(te=i.RG8),q===i.UNSIGNED_SHORT&&ve&&(te=ve.RG16_EXT),q===i.SHORT&&ve&&(te=ve.RG16_SNORM_EXT)),S===i.RG_INTEGER&&(q===i.UNSIGNED_BYTE&&(te=i.RG8UI),q===i.UNSIGNED_SHORT&&(te=i.RG16UI),q===i.UNSIGNED_INT&&(te=i.RG32UI),q===i.BYTE&&(te=i.RG8I),q===i.SHORT&&(te=i.RG16I),q===i.INT&&(te=i.RG32I)),S===i.RGB_INTEGER&&(q===i.UNSIGNED_BYTE&&(te=i.RGB8UI),q===i.UNSIGNED_SHORT&&(te=i.RGB16UI),q===i.UNSIGNED_INT&&(te=i.RGB32UI),q===i.BYTE&&(te=i.RGB8I),q===i.SHORT&&(te=i.RGB16I),q===i.INT&&(te=i.RGB32I)),S===i.RGBA_INTEGER&&(q===i.UNSIGNED_BYTE&&(te=i.RGBA8UI),q===i.UNSIGNED_SHORT&&(te=i.RGBA16UI),q===i.UNSIGNED_INT&&(te=i.RGBA32UI),q===i.BYTE&&(te=i.RGBA8I),q===i.SHORT&&(te=i.RGBA16I),q===i.INT&&(te=i.RGBA32I)),S===i.RGB&&(q===i.UNSIGNED_SHORT&&ve&&(te=ve.RGB16_EXT),q===i.SHORT&&ve&&(te=ve.RGB16_SNORM_EXT),q===i.UNSIGNED_INT_5_9_9_9_REV&&(te=i.RGB9_E5),q===i.UNSIGNED_INT_10F_11F_11F_REV&&(te=i.R11F_G11F_B10F)),S===i.RGBA){let se=xe?_a:Mt.getTransfer(oe);q===i.FLOAT&&(te=i.RGBA32F),q===i.HALF_FLOAT&&(te=i.RGBA16F),q===i.UNSIGNED_BYTE&&(te=se===Dt?i.SRGB8_ALPHA8:i.RGBA8),q===i.UNSIGNED_SHORT&&ve&&(te=ve.RGBA16_EXT),q===i.SHORT&&ve&&(te=ve.RGBA16_SNORM_EXT),q===i.UNSIGNED_SHORT_4_4_4_4&&(te=i.RGBA4),q===i.UNSIGNED_SHORT_5_5_5_1&&(te=i.RGB5_A1)}return(te===i.R16F||te===i.R32F||te===i.RG16F||te===i.RG32F||te===i.RGBA16F||te===i.RGBA32F)&&e.get("EXT_color_buffer_float"),te}function x(I,S){let q;return I?S===null||S===Hi||S===Ir?q=i.DEPTH24_STENCIL8:S===Gi?q=i.DEPTH32F_STENCIL8:S===Fo&&(q=i.DEPTH24_STENCIL8,Ke("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):S===null||S===Hi||S===Ir?q=i.DEPTH_COMPONENT24:S===Gi?q=i.DEPTH_COMPONENT32F:S===Fo&&(q=i.DEPTH_COMPONENT16),q}function w(I,S){return E(I)===!0||I.isFramebufferTexture&&I.minFilter!==Bn&&I.minFilter!==ri?Math.log2(Math.max(S.width,S.height))+1:I.mipmaps.length>0?I.mipmaps.length:I.isCompressedTexture&&Array.isArray(I.image)?S.mipmaps.length:1}function O(I){let S=new WeakRef(I);n.get(I).__ref=S,p.add(S),v.register(I,S,S)}function P(I){let S=n.get(I).__ref;S!==void 0&&(p.delete(S),v.unregister(S))}function D(I){W(I.target)}function z(I){N(I.target)}function W(I){I.removeEventListener("dispose",D),P(I),Z(I),I.isVideoTexture&&h.delete(I),I.isHTMLTexture&&u.delete(I)}function N(I){I.removeEventListener("dispose",z),P(I),ce(I)}function V(){for(let I of p){let S=I.deref();S!==void 0&&(S.isRenderTarget===!0?N(S):W(S))}p.clear(),u.clear()}function Z(I){let S=n.get(I);if(S.__webglInit===void 0)return;let q=I.source,ue=f.get(q);if(ue){let oe=ue[S.__cacheKey];oe.usedTimes--,oe.usedTimes===0&&G(I),Object.keys(ue).length===0&&f.delete(q)}n.remove(I)}function G(I){let S=n.get(I);i.deleteTexture(S.__webglTexture);let q=I.source,ue=f.get(q);delete ue[S.__cacheKey],o.memory.textures--}function ce(I){let S=n.get(I);S.__depthDisposeCallback&&S.__depthDisposeCallback();let q=I.depthTexture;if(q&&q.renderTarget===I&&W(q),I.isWebGLCubeRenderTarget)for(let oe=0;oe<6;oe++){if(Array.isArray(S.__webglFramebuffer[oe]))for(let xe=0;xe<S.__webglFramebuffer[oe].length;xe++)i.deleteFramebuffer(S.__webglFramebuffer[oe][xe]);else i.deleteFramebuffer(S.__webglFramebuffer[oe]);S.__webglDepthbuffer&&i.deleteRenderbuffer(S.__webglDepthbuffer[oe])}else{if(Array.isArray(S.__webglFramebuffer))for(let oe=0;oe<S.__webglFramebuffer.length;oe++)i.deleteFramebuffer(S.__webglFramebuffer[oe]);else i.deleteFramebuffer(S.__webglFramebuffer);if(S.__webglDepthbuffer&&i.deleteRenderbuffer(S.__webglDepthbuffer),S.__webglMultisampledFramebuffer&&i.deleteFramebuffer(S.__webglMultisampledFramebuffer),S.__webglColorRenderbuffer)for(let oe=0;oe<S.__webglColorRenderbuffer.length;oe++)S.__webglColorRenderbuffer[oe]&&i.deleteRenderbuffer(S.__webglColorRenderbuffer[oe]);S.__webglDepthRenderbuffer&&i.deleteRenderbuffer(S.__webglDepthRenderbuffer)}let ue=I.textures;for(let oe=0,xe=ue.length;oe<xe;oe++){let ve=n.get(ue[oe]);ve.__webglTexture&&(i.deleteTexture(ve.__webglTexture),o.memory.textures--),n.remove(ue[oe])}n.remove(I)}let Y=0;function Q(){Y=0}function ie(){return Y}function de(I){Y=I}function fe(){let I=Y;return I>=s.maxTextures&&Ke("WebGLTextures: Trying to use "+(I+1)+" texture units while this GPU supports only "+s.maxTextures),Y+=1,I}function ee(I){let S=[];return S.push(I.wrapS),S.push(I.wrapT),S.push(I.wrapR||0),S.push(I.magFilter),S.push(I.minFilter),S.push(I.anisotropy),S.push(I.internalFormat),S.push(I.format),S.push(I.type),S.push(I.generateMipmaps),S.push(I.mipmapsAutoUpdate),S.push(I.premultiplyAlpha),S.push(I.flipY),S.push(I.unpackAlignment),S.push(I.colorSpace),S.join()}function ge(I,S){let q=n.get(I);if(I.isVideoTexture&&kt(I),I.isRenderTargetTexture===!1&&I.isExternalTexture!==!0&&I.version>0&&q.__version!==I.version){let ue=I.image;if(ue===null)Ke("WebGLRenderer: Texture marked for update but no image data found.");else if(ue.complete===!1)Ke("WebGLRenderer: Texture marked for update but image is incomplete");else{Wt(q,I,S);return}}else I.isExternalTexture&&(q.__webglTexture=I.sourceTexture?I.sourceTexture:null);t.bindTexture(i.TEXTURE_2D,q.__webglTexture,i.TEXTURE0+S)}function ye(I,S){let q=n.get(I);if(I.isRenderTargetTexture===!1&&I.version>0&&q.__version!==I.version){Wt(q,I,S);return}else I.isExternalTexture&&(q.__webglTexture=I.sourceTexture?I.sourceTexture:null);t.bindTexture(i.TEXTURE_2D_ARRAY,q.__webglTexture,i.TEXTURE0+S)}function Pe(I,S){let q=n.get(I);if(I.isRenderTargetTexture===!1&&I.version>0&&q.__version!==I.version){Wt(q,I,S);return}t.bindTexture(i.TEXTURE_3D,q.__webglTexture,i.TEXTURE0+S)}function we(I,S){let q=n.get(I);if(I.version>0&&q.__version!==I.version){mn(q,I,S);return}t.bindTexture(i.TEXTURE_CUBE_MAP,q.__webglTexture,i.TEXTURE0+S)}let Ye={[wr]:i.REPEAT,[is]:i.CLAMP_TO_EDGE,[hc]:i.MIRRORED_REPEAT},at={[Bn]:i.NEAREST,[zg]:i.NEAREST_MIPMAP_NEAREST,[za]:i.NEAREST_MIPMAP_LINEAR,[ri]:i.LINEAR,[Uo]:i.LINEAR_MIPMAP_NEAREST,[Is]:i.LINEAR_MIPMAP_LINEAR},Xe={[Wg]:i.NEVER,[qd]:i.ALWAYS,[Xg]:i.LESS,[Wd]:i.LEQUAL,[qg]:i.EQUAL,[Xd]:i.GEQUAL,[Yg]:i.GREATER,[Zg]:i.NOTEQUAL};function pt(I,S){if(S.type===Gi&&e.has("OES_texture_float_linear")===!1&&(S.magFilter===ri||S.magFilter===Uo||S.magFilter===za||S.magFilter===Is||S.minFilter===ri||S.minFilter===Uo||S.minFilter===za||S.minFilter===Is)&&Ke("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(I,i.TEXTURE_WRAP_S,Ye[S.wrapS]),i.texParameteri(I,i.TEXTURE_WRAP_T,Ye[S.wrapT]),(I===i.TEXTURE_3D||I===i.TEXTURE_2D_ARRAY)&&i.texParameteri(I,i.TEXTURE_WRAP_R,Ye[S.wrapR]),i.texParameteri(I,i.TEXTURE_MAG_FILTER,at[S.magFilter]),i.texParameteri(I,i.TEXTURE_MIN_FILTER,at[S.minFilter]),S.compareFunction&&(i.texParameteri(I,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(I,i.TEXTURE_COMPARE_FUNC,Xe[S.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(S.magFilter===Bn||S.minFilter!==za&&S.minFilter!==Is||S.type===Gi&&e.has("OES_texture_float_linear")===!1)return;if(S.anisotropy>1||n.get(S).__currentAnisotropy){let q=e.get("EXT_texture_filter_anisotropic");i.texParameterf(I,q.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(S.anisotropy,s.getMaxAnisotropy())),n.get(S).__currentAnisotropy=S.anisotropy}}}function ut(I,S){let q=!1;I.__webglInit===void 0&&(I.__webglInit=!0,S.addEventListener("dispose",D),O(S));let ue=S.source,oe=f.get(ue);oe===void 0&&(oe={},f.set(ue,oe));let xe=ee(S);if(xe!==I.__cacheKey){oe[xe]===void 0&&(oe[xe]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,q=!0),oe[xe].usedTimes++;let ve=oe[I.__cacheKey];ve!==void 0&&(oe[I.__cacheKey].usedTimes--,ve.usedTimes===0&&G(S)),I.__cacheKey=xe,I.__webglTexture=oe[xe].texture}return q}function rt(I,S,q){return Math.floor(Math.floor(I/q)/S)}function jt(I,S,q,ue){let xe=I.updateRanges;if(xe.length===0)t.texSubImage2D(i.TEXTURE_2D,0,0,0,S.width,S.height,q,ue,S.data);else{xe.sort((B,re)=>B.start-re.start);let ve=0;for(let B=1;B<xe.length;B++){let re=xe[ve],ne=xe[B],Te=re.start+re.count,_e=rt(ne.start,S.width,4),Se=rt(re.start,S.width,4);ne.start<=Te+1&&_e===Se&&rt(ne.start+ne.count-1,S.width,4)===_e?re.count=Math.max(re.count,ne.start+ne.count-re.start):(++ve,xe[ve]=ne)}xe.length=ve+1;let te=t.getParameter(i.UNPACK_ROW_LENGTH),se=t.getParameter(i.UNPACK_SKIP_PIXELS),me=t.getParameter(i.UNPACK_SKIP_ROWS);t.pixelStorei(i.UNPACK_ROW_LENGTH,S.width);for(let B=0,re=xe.length;B<re;B++){let ne=xe[B],Te=Math.floor(ne.start/4),_e=Math.ceil(ne.count/4),Se=Te%S.width,qe=Math.floor(Te/S.width),et=_e,he=1;t.pixelStorei(i.UNPACK_SKIP_PIXELS,Se),t.pixelStorei(i.UNPACK_SKIP_ROWS,qe),t.texSubImage2D(i.TEXTURE_2D,0,Se,qe,et,he,q,ue,S.data)}I.clearUpdateRanges(),t.pixelStorei(i.UNPACK_ROW_LENGTH,te),t.pixelStorei(i.UNPACK_SKIP_PIXELS,se),t.pixelStorei(i.UNPACK_SKIP_ROWS,me)}}function Wt(I,S,q){let ue=i.TEXTURE_2D;(S.isDataArrayTexture||S.isCompressedArrayTexture)&&(ue=i.TEXTURE_2D_ARRAY),S.isData3DTexture&&(ue=i.TEXTURE_3D);let oe=ut(I,S),xe=S.source;t.bindTexture(ue,I.__webglTexture,i.TEXTURE0+q);let ve=n.get(xe);if(xe.version!==ve.__version||oe===!0){if(t.activeTexture(i.TEXTURE0+q),(typeof ImageBitmap<"u"&&S.image instanceof ImageBitmap)===!1){let he=Mt.getPrimaries(Mt.workingColorSpace),ze=S.colorSpace===Ds?null:Mt.getPrimaries(S.colorSpace),tt=S.colorSpace===Ds||he===ze?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,S.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,tt)}t.pixelStorei(i.UNPACK_ALIGNMENT,S.unpackAlignment);let se=_(S.image,!1,s.maxTextureSize);se=Ve(S,se);let me=r.convert(S.format,S.colorSpace),B=r.convert(S.type),re=M(S.internalFormat,me,B,S.normalized,S.colorSpace,S.isVideoTexture);pt(ue,S);let ne,Te=S.mipmaps,_e=S.isVideoTexture!==!0,Se=ve.__version===void 0||oe===!0,qe=xe.dataReady,et=w(S,se);if(S.isDepthTexture)re=x(S.format===Ls,S.type),Se&&(_e?t.texStorage2D(i.TEXTURE_2D,1,re,se.width,se.height):t.texImage2D(i.TEXTURE_2D,0,re,se.width,se.height,0,me,B,null));else if(S.isDataTexture)if(Te.length>0){_e&&Se&&t.texStorage2D(i.TEXTURE_2D,et,re,Te[0].width,Te[0].height);for(let he=0,ze=Te.length;he<ze;he++)ne=Te[he],_e?qe&&t.texSubImage2D(i.TEXTURE_2D,he,0,0,ne.width,ne.height,me,B,ne.data):t.texImage2D(i.TEXTURE_2D,he,re,ne.width,ne.height,0,me,B,ne.data);S.generateMipmaps=!1}else _e?(Se&&t.texStorage2D(i.TEXTURE_2D,et,re,se.width,se.height),qe&&jt(S,se,me,B)):t.texImage2D(i.TEXTURE_2D,0,re,se.width,se.height,0,me,B,se.data);else if(S.isCompressedTexture)if(S.isCompressedArrayTexture){_e&&Se&&t.texStorage3D(i.TEXTURE_2D_ARRAY,et,re,Te[0].width,Te[0].height,se.depth);for(let he=0,ze=Te.length;he<ze;he++)if(ne=Te[he],S.format!==Wi)if(me!==null)if(_e){if(qe)if(S.layerUpdates.size>0){let tt=nf(ne.width,ne.height,S.format,S.type);for(let Ie of S.layerUpdates){let ht=ne.data.subarray(Ie*tt/ne.data.BYTES_PER_ELEMENT,(Ie+1)*tt/ne.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,he,0,0,Ie,ne.width,ne.height,1,me,ht)}}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,he,0,0,0,ne.width,ne.height,se.depth,me,ne.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,he,re,ne.width,ne.height,se.depth,0,ne.data,0,0);else Ke("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else _e?qe&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,he,0,0,0,ne.width,ne.height,se.depth,me,B,ne.data):t.texImage3D(i.TEXTURE_2D_ARRAY,he,re,ne.width,ne.height,se.depth,0,me,B,ne.data);S.layerUpdates.size>0&&S.clearLayerUpdates()}else{_e&&Se&&t.texStorage2D(i.TEXTURE_2D,et,re,Te[0].width,Te[0].height);for(let he=0,ze=Te.length;he<ze;he++)ne=Te[he],S.format!==Wi?me!==null?_e?qe&&t.compressedTexSubImage2D(i.TEXTURE_2D,he,0,0,ne.width,ne.height,me,ne.data):t.compressedTexImage2D(i.TEXTURE_2D,he,re,ne.width,ne.height,0,ne.data):Ke("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):_e?qe&&t.texSubImage2D(i.TEXTURE_2D,he,0,0,ne.width,ne.height,me,B,ne.data):t.texImage2D(i.TEXTURE_2D,he,re,ne.width,ne.height,0,me,B,ne.data)}else if(S.isDataArrayTexture)if(_e){if(Se&&t.texStorage3D(i.TEXTURE_2D_ARRAY,et,re,se.width,se.height,se.depth),qe)if(S.layerUpdates.size>0){let he=nf(se.width,se.height,S.format,S.type);for(let ze of S.layerUpdates){let tt=se.data.subarray(ze*he/se.data.BYTES_PER_ELEMENT,(ze+1)*he/se.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,ze,se.width,se.height,1,me,B,tt)}S.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,se.width,se.height,se.depth,me,B,se.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,re,se.width,se.height,se.depth,0,me,B,se.data);else if(S.isData3DTexture)_e?(Se&&t.texStorage3D(i.TEXTURE_3D,et,re,se.width,se.height,se.depth),qe&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,se.width,se.height,se.depth,me,B,se.data)):t.texImage3D(i.TEXTURE_3D,0,re,se.width,se.height,se.depth,0,me,B,se.data);else if(S.isFramebufferTexture){if(Se)if(_e)t.texStorage2D(i.TEXTURE_2D,et,re,se.width,se.height);else{let he=se.width,ze=se.height;for(let tt=0;tt<et;tt++)t.texImage2D(i.TEXTURE_2D,tt,re,he,ze,0,me,B,null),he>>=1,ze>>=1}}else if(S.isHTMLTexture){if("texElementImage2D"in i){let he=i.canvas;if(he.hasAttribute("layoutsubtree")||he.setAttribute("layoutsubtree","true"),se.parentNode!==he){he.appendChild(se),u.add(S),he.onpaint=ze=>{let tt=ze.changedElements;for(let Ie of u)tt.includes(Ie.image)&&(Ie.needsUpdate=!0)},he.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,se);else{let tt=i.RGBA,Ie=i.RGBA,ht=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,tt,Ie,ht,se)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(Te.length>0){if(_e&&Se){let he=$e(Te[0]);t.texStorage2D(i.TEXTURE_2D,et,re,he.width,he.height)}for(let he=0,ze=Te.length;he<ze;he++)ne=Te[he],_e?qe&&t.texSubImage2D(i.TEXTURE_2D,he,0,0,me,B,ne):t.texImage2D(i.TEXTURE_2D,he,re,me,B,ne);S.generateMipmaps=!1}else if(_e){if(Se){let he=$e(se);t.texStorage2D(i.TEXTURE_2D,et,re,he.width,he.height)}qe&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,me,B,se)}else t.texImage2D(i.TEXTURE_2D,0,re,me,B,se);E(S)&&S.mipmapsAutoUpdate===!0&&b(ue),ve.__version=xe.version,S.onUpdate&&S.onUpdate(S)}I.__version=S.version}function mn(I,S,q){if(S.image.length!==6)return;let ue=ut(I,S),oe=S.source;t.bindTexture(i.TEXTURE_CUBE_MAP,I.__webglTexture,i.TEXTURE0+q);let xe=n.get(oe);if(oe.version!==xe.__version||ue===!0){t.activeTexture(i.TEXTURE0+q);let ve=Mt.getPrimaries(Mt.workingColorSpace),te=S.colorSpace===Ds?null:Mt.getPrimaries(S.colorSpace),se=S.colorSpace===Ds||ve===te?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,S.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),t.pixelStorei(i.UNPACK_ALIGNMENT,S.unpackAlignment),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,se);let me=S.isCompressedTexture||S.image[0].isCompressedTexture,B=S.image[0]&&S.image[0].isDataTexture,re=[];for(let Ie=0;Ie<6;Ie++)!me&&!B?re[Ie]=_(S.image[Ie],!0,s.maxCubemapSize):re[Ie]=B?S.image[Ie].image:S.image[Ie],re[Ie]=Ve(S,re[Ie]);let ne=re[0],Te=r.convert(S.format,S.colorSpace),_e=r.convert(S.type),Se=M(S.internalFormat,Te,_e,S.normalized,S.colorSpace),qe=S.isVideoTexture!==!0,et=xe.__version===void 0||ue===!0,he=oe.dataReady,ze=w(S,ne);pt(i.TEXTURE_CUBE_MAP,S);let tt;if(S.isDepthTexture){if(Se=x(S.format===Ls,S.type),et)if(qe)t.texStorage2D(i.TEXTURE_CUBE_MAP,1,Se,ne.width,ne.height);else for(let Ie=0;Ie<6;Ie++)t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,0,Se,ne.width,ne.height,0,Te,_e,null)}else if(me){qe&&et&&t.texStorage2D(i.TEXTURE_CUBE_MAP,ze,Se,ne.width,ne.height);for(let Ie=0;Ie<6;Ie++){tt=re[Ie].mipmaps;for(let ht=0;ht<tt.length;ht++){let qt=tt[ht];S.format!==Wi?Te!==null?qe?he&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,ht,0,0,qt.width,qt.height,Te,qt.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,ht,Se,qt.width,qt.height,0,qt.data):Ke("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):qe?he&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,ht,0,0,qt.width,qt.height,Te,_e,qt.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,ht,Se,qt.width,qt.height,0,Te,_e,qt.data)}}}else{if(tt=S.mipmaps,qe&&et){tt.length>0&&ze++;let Ie=$e(re[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,ze,Se,Ie.width,Ie.height)}for(let Ie=0;Ie<6;Ie++)if(B){qe?he&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,0,0,0,re[Ie].width,re[Ie].height,Te,_e,re[Ie].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,0,Se,re[Ie].width,re[Ie].height,0,Te,_e,re[Ie].data);for(let ht=0;ht<tt.length;ht++){let jn=tt[ht].image[Ie].image;qe?he&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,ht+1,0,0,jn.width,jn.height,Te,_e,jn.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,ht+1,Se,jn.width,jn.height,0,Te,_e,jn.data)}}else{qe?he&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,0,0,0,Te,_e,re[Ie]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,0,Se,Te,_e,re[Ie]);for(let ht=0;ht<tt.length;ht++){let qt=tt[ht];qe?he&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,ht+1,0,0,Te,_e,qt.image[Ie]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,ht+1,Se,Te,_e,qt.image[Ie])}}}E(S)&&S.mipmapsAutoUpdate===!0&&b(i.TEXTURE_CUBE_MAP),xe.__version=oe.version,S.onUpdate&&S.onUpdate(S)}I.__version=S.version}function Ot(I,S,q,ue,oe,xe){let ve=r.convert(q.format,q.colorSpace),te=r.convert(q.type),se=M(q.internalFormat,ve,te,q.normalized,q.colorSpace),me=n.get(S),B=n.get(q);if(B.__renderTarget=S,!me.__hasExternalTextures){let re=Math.max(1,S.width>>xe),ne=Math.max(1,S.height>>xe);oe===i.TEXTURE_3D||oe===i.TEXTURE_2D_ARRAY?t.texImage3D(oe,xe,se,re,ne,S.depth,0,ve,te,null):t.texImage2D(oe,xe,se,re,ne,0,ve,te,null)}t.bindFramebuffer(i.FRAMEBUFFER,I),Ee(S)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ue,oe,B.__webglTexture,0,lt(S)):(oe===i.TEXTURE_2D||oe>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&oe<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,ue,oe,B.__webglTexture,xe),t.bindFramebuffer(i.FRAMEBUFFER,null)}function Ln(I,S,q){if(i.bindRenderbuffer(i.RENDERBUFFER,I),S.depthBuffer){let ue=S.depthTexture,oe=ue&&ue.isDepthTexture?ue.type:null,xe=x(S.stencilBuffer,oe),ve=S.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;Ee(S)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,lt(S),xe,S.width,S.height):q?i.renderbufferStorageMultisample(i.RENDERBUFFER,lt(S),xe,S.width,S.height):i.renderbufferStorage(i.RENDERBUFFER,xe,S.width,S.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,ve,i.RENDERBUFFER,I)}else{let ue=S.textures;for(let oe=0;oe<ue.length;oe++){let xe=ue[oe],ve=r.convert(xe.format,xe.colorSpace),te=r.convert(xe.type),se=M(xe.internalFormat,ve,te,xe.normalized,xe.colorSpace);Ee(S)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,lt(S),se,S.width,S.height):q?i.renderbufferStorageMultisample(i.RENDERBUFFER,lt(S),se,S.width,S.height):i.renderbufferStorage(i.RENDERBUFFER,se,S.width,S.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function St(I,S,q){let ue=S.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(i.FRAMEBUFFER,I),!(S.depthTexture&&S.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let oe=n.get(S.depthTexture);oe.__renderTarget=S;let xe=ue?S.depthTexture.image[0]:S.depthTexture.image;(!oe.__webglTexture||xe.width!==S.width||xe.height!==S.height)&&(xe.width=S.width,xe.height=S.height,S.depthTexture.needsUpdate=!0),ue?we(S.depthTexture,0):ge(S.depthTexture,0);let ve=oe.__webglTexture,te=lt(S),se=ue?i.TEXTURE_CUBE_MAP_POSITIVE_X+q:i.TEXTURE_2D,me=S.depthTexture.format===Ls?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(S.depthTexture.format===Es)Ee(S)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,me,se,ve,0,te):i.framebufferTexture2D(i.FRAMEBUFFER,me,se,ve,0);else if(S.depthTexture.format===Ls)Ee(S)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,me,se,ve,0,te):i.framebufferTexture2D(i.FRAMEBUFFER,me,se,ve,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function wn(I){let S=n.get(I),q=I.isWebGLCubeRenderTarget===!0;if(S.__boundDepthTexture!==I.depthTexture){let ue=I.depthTexture;if(S.__depthDisposeCallback&&S.__depthDisposeCallback(),ue){let oe=()=>{delete S.__boundDepthTexture,delete S.__depthDisposeCallback,ue.removeEventListener("dispose",oe)};ue.addEventListener("dispose",oe),S.__depthDisposeCallback=oe}S.__boundDepthTexture=ue}if(I.depthTexture&&!S.__autoAllocateDepthBuffer)if(q)for(let ue=0;ue<6;ue++)St(S.__webglFramebuffer[ue],I,ue);else I.texture.mipmaps.length>0?St(S.__webglFramebuffer[0],I,0):St(S.__webglFramebuffer,I,0);else if(q){S.__webglDepthbuffer=[];for(let ue=0;ue<6;ue++)if(t.bindFramebuffer(i.FRAMEBUFFER,S.__webglFramebuffer[ue]),S.__webglDepthbuffer[ue]===void 0)S.__webglDepthbuffer[ue]=i.createRenderbuffer(),Ln(S.__webglDepthbuffer[ue],I,!1);else{let oe=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,xe=S.__webglDepthbuffer[ue];i.bindRenderbuffer(i.RENDERBUFFER,xe),i.framebufferRenderbuffer(i.FRAMEBUFFER,oe,i.RENDERBUFFER,xe)}}else if(I.texture.mipmaps.length>0?t.bindFramebuffer(i.FRAMEBUFFER,S.__webglFramebuffer[0]):t.bindFramebuffer(i.FRAMEBUFFER,S.__webglFramebuffer),S.__webglDepthbuffer===void 0)S.__webglDepthbuffer=i.createRenderbuffer(),Ln(S.__webglDepthbuffer,I,!1);else{let oe=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,xe=S.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,xe),i.framebufferRenderbuffer(i.FRAMEBUFFER,oe,i.RENDERBUFFER,xe)}t.bindFramebuffer(i.FRAMEBUFFER,null)}function rn(I,S,q){let ue=n.get(I);S!==void 0&&Ot(ue.__webglFramebuffer,I,I.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),q!==void 0&&wn(I)}function gn(I){let S=I.texture,q=n.get(I),ue=n.get(S);I.addEventListener("dispose",z),O(I);let oe=I.textures,xe=I.isWebGLCubeRenderTarget===!0,ve=oe.length>1;if(ve||(ue.__webglTexture===void 0&&(ue.__webglTexture=i.createTexture()),ue.__version=S.version,o.memory.textures++),xe){q.__webglFramebuffer=[];for(let te=0;te<6;te++)if(S.mipmaps.length>0){q.__webglFramebuffer[te]=[];for(let se=0;se<S.mipmaps.length;se++)q.__webglFramebuffer[te][se]=i.createFramebuffer()}else q.__webglFramebuffer[te]=i.createFramebuffer()}else{if(S.mipmaps.length>0){q.__webglFramebuffer=[];for(let te=0;te<S.mipmaps.length;te++)q.__webglFramebuffer[te]=i.createFramebuffer()}else q.__webglFramebuffer=i.createFramebuffer();if(ve)for(let te=0,se=oe.length;te<se;te++){let me=n.get(oe[te]);me.__webglTexture===void 0&&(me.__webglTexture=i.createTexture(),o.memory.textures++)}if(I.samples>0&&Ee(I)===!1){q.__webglMultisampledFramebuffer=i.createFramebuffer(),q.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,q.__webglMultisampledFramebuffer);for(let te=0;te<oe.length;te++){let se=oe[te];q.__webglColorRenderbuffer[te]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,q.__webglColorRenderbuffer[te]);let me=r.convert(se.format,se.colorSpace),B=r.convert(se.type),re=M(se.internalFormat,me,B,se.normalized,se.colorSpace,I.isXRRenderTarget===!0),ne=lt(I);i.renderbufferStorageMultisample(i.RENDERBUFFER,ne,re,I.width,I.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+te,i.RENDERBUFFER,q.__webglColorRenderbuffer[te])}i.bindRenderbuffer(i.RENDERBUFFER,null),I.depthBuffer&&(q.__webglDepthRenderbuffer=i.createRenderbuffer(),Ln(q.__webglDepthRenderbuffer,I,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(xe){t.bindTexture(i.TEXTURE_CUBE_MAP,ue.__webglTexture),pt(i.TEXTURE_CUBE_MAP,S);for(let te=0;te<6;te++)if(S.mipmaps.length>0)for(let se=0;se<S.mipmaps.length;se++)Ot(q.__webglFramebuffer[te][se],I,S,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+te,se);else Ot(q.__webglFramebuffer[te],I,S,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+te,0);E(S)?b(i.TEXTURE_CUBE_MAP):S.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),t.unbindTexture()}else if(ve){for(let te=0,se=oe.length;te<se;te++){let me=oe[te],B=n.get(me),re=i.TEXTURE_2D;(I.isWebGL3DRenderTarget||I.isWebGLArrayRenderTarget)&&(re=I.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(re,B.__webglTexture),pt(re,me),Ot(q.__webglFramebuffer,I,me,i.COLOR_ATTACHMENT0+te,re,0),E(me)&&b(re)}t.unbindTexture()}else{let te=i.TEXTURE_2D;if((I.isWebGL3DRenderTarget||I.isWebGLArrayRenderTarget)&&(te=I.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(te,ue.__webglTexture),pt(te,S),S.mipmaps.length>0)for(let se=0;se<S.mipmaps.length;se++)Ot(q.__webglFramebuffer[se],I,S,i.COLOR_ATTACHMENT0,te,se);else Ot(q.__webglFramebuffer,I,S,i.COLOR_ATTACHMENT0,te,0);E(S)?b(te):S.mipmaps.length>0&&i.texParameteri(te,i.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),t.unbindTexture()}I.depthBuffer&&wn(I)}function k(I){let S=I.textures;for(let q=0,ue=S.length;q<ue;q++){let oe=S[q];if(E(oe)&&oe.mipmapsAutoUpdate===!0){let xe=C(I),ve=n.get(oe).__webglTexture;t.bindTexture(xe,ve),b(xe),t.unbindTexture()}}}let Le=[];function Je(I){if(I.samples>0){if(Ee(I)===!1){let S=I.textures,q=I.width,ue=I.height,oe=i.COLOR_BUFFER_BIT,xe=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ve=n.get(I),te=S.length>1;if(te)for(let me=0;me<S.length;me++)t.bindFramebuffer(i.FRAMEBUFFER,ve.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+me,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,ve.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+me,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,ve.__webglMultisampledFramebuffer),I.texture.mipmaps.length>0?t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ve.__webglFramebuffer[0]):t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ve.__webglFramebuffer);for(let me=0;me<S.length;me++){if(I.resolveDepthBuffer&&(I.depthBuffer&&(oe|=i.DEPTH_BUFFER_BIT),I.stencilBuffer&&I.resolveStencilBuffer&&(oe|=i.STENCIL_BUFFER_BIT)),te){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,ve.__webglColorRenderbuffer[me]);let B=n.get(S[me]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,B,0)}i.blitFramebuffer(0,0,q,ue,0,0,q,ue,oe,i.NEAREST),l===!0&&(Le.length=0,Le.push(i.COLOR_ATTACHMENT0+me),I.depthBuffer&&I.storeMultisampledDepthBuffer===!1&&Le.push(xe),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Le))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),te)for(let me=0;me<S.length;me++){t.bindFramebuffer(i.FRAMEBUFFER,ve.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+me,i.RENDERBUFFER,ve.__webglColorRenderbuffer[me]);let B=n.get(S[me]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,ve.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+me,i.TEXTURE_2D,B,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ve.__webglMultisampledFramebuffer)}else if(I.depthBuffer&&I.storeMultisampledDepthBuffer===!1&&l){let S=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[S])}}}function lt(I){return Math.min(s.maxSamples,I.samples)}function Ee(I){let S=n.get(I);return I.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&S.__useRenderToTexture!==!1}function kt(I){let S=o.render.frame;h.get(I)!==S&&(h.set(I,S),I.update())}function Ve(I,S){let q=I.colorSpace,ue=I.format,oe=I.type;return I.isCompressedTexture===!0||I.isVideoTexture===!0||q!==ga&&q!==Ds&&(Mt.getTransfer(q)===Dt?(ue!==Wi||oe!==ci)&&Ke("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):nt("WebGLTextures: Unsupported texture color space:",q)),S}function $e(I){return typeof HTMLImageElement<"u"&&I instanceof HTMLImageElement?(c.width=I.naturalWidth||I.width,c.height=I.naturalHeight||I.height):typeof VideoFrame<"u"&&I instanceof VideoFrame?(c.width=I.displayWidth,c.height=I.displayHeight):(c.width=I.width,c.height=I.height),c}this.allocateTextureUnit=fe,this.resetTextureUnits=Q,this.getTextureUnits=ie,this.setTextureUnits=de,this.setTexture2D=ge,this.setTexture2DArray=ye,this.setTexture3D=Pe,this.setTextureCube=we,this.rebindTextures=rn,this.setupRenderTarget=gn,this.updateRenderTargetMipmap=k,this.updateMultisampleRenderTarget=Je,this.setupDepthRenderbuffer=wn,this.setupFrameBufferTexture=Ot,this.useMultisampledRTT=Ee,this.dispose=V}function fE(i,e){function t(n,s=Ds){let r,o=Mt.getTransfer(s);if(n===ci)return i.UNSIGNED_BYTE;if(n===Bc)return i.UNSIGNED_SHORT_4_4_4_4;if(n===kc)return i.UNSIGNED_SHORT_5_5_5_1;if(n===Od)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===Bd)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===Ud)return i.BYTE;if(n===Fd)return i.SHORT;if(n===Fo)return i.UNSIGNED_SHORT;if(n===Oc)return i.INT;if(n===Hi)return i.UNSIGNED_INT;if(n===Gi)return i.FLOAT;if(n===Vi)return i.HALF_FLOAT;if(n===kd)return i.ALPHA;if(n===zd)return i.RGB;if(n===Wi)return i.RGBA;if(n===Es)return i.DEPTH_COMPONENT;if(n===Ls)return i.DEPTH_STENCIL;if(n===Hd)return i.RED;if(n===zc)return i.RED_INTEGER;if(n===rr)return i.RG;if(n===Hc)return i.RG_INTEGER;if(n===Gc)return i.RGBA_INTEGER;if(n===Ha||n===Ga||n===Va||n===Wa)if(o===Dt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===Ha)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===Ga)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Va)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===Wa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===Ha)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===Ga)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Va)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===Wa)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===Vc||n===Wc||n===Xc||n===qc)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===Vc)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===Wc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===Xc)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===qc)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===Yc||n===Zc||n===$c||n===Kc||n===Jc||n===Xa||n===jc)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(n===Yc||n===Zc)return o===Dt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===$c)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===Kc)return r.COMPRESSED_R11_EAC;if(n===Jc)return r.COMPRESSED_SIGNED_R11_EAC;if(n===Xa)return r.COMPRESSED_RG11_EAC;if(n===jc)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===Qc||n===eh||n===th||n===nh||n===ih||n===sh||n===rh||n===oh||n===ah||n===lh||n===ch||n===hh||n===uh||n===dh)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(n===Qc)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===eh)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===th)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===nh)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===ih)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===sh)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===rh)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===oh)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===ah)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===lh)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===ch)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===hh)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===uh)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===dh)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===fh||n===ph||n===mh)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(n===fh)return o===Dt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===ph)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===mh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===gh||n===_h||n===qa||n===xh)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(n===gh)return r.COMPRESSED_RED_RGTC1_EXT;if(n===_h)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===qa)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===xh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===Ir?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:t}}var pE=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,mE=`
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

}`,df=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new Ra(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new Ci({vertexShader:pE,fragmentShader:mE,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Ce(new Rs(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},ff=class extends ki{constructor(e,t){super();let n=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,u=null,d=null,f=null,p=null,v=typeof XRWebGLBinding<"u",g=new df,m={},_=t.getContextAttributes(),E=null,b=null,C=[],M=[],x=new We,w=null,O=null,P=new si;P.viewport=new Xt;let D=new si;D.viewport=new Xt;let z=[P,D],W=new Dc,N=null,V=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(ee){let ge=C[ee];return ge===void 0&&(ge=new Ao,C[ee]=ge),ge.getTargetRaySpace()},this.getControllerGrip=function(ee){let ge=C[ee];return ge===void 0&&(ge=new Ao,C[ee]=ge),ge.getGripSpace()},this.getHand=function(ee){let ge=C[ee];return ge===void 0&&(ge=new Ao,C[ee]=ge),ge.getHandSpace()};function Z(ee){let ge=M.indexOf(ee.inputSource);if(ge===-1)return;let ye=C[ge];ye!==void 0&&(ye.update(ee.inputSource,ee.frame,c||o),ye.dispatchEvent({type:ee.type,data:ee.inputSource}))}function G(){s.removeEventListener("select",Z),s.removeEventListener("selectstart",Z),s.removeEventListener("selectend",Z),s.removeEventListener("squeeze",Z),s.removeEventListener("squeezestart",Z),s.removeEventListener("squeezeend",Z),s.removeEventListener("end",G),s.removeEventListener("inputsourceschange",ce);for(let ee=0;ee<C.length;ee++){let ge=M[ee];ge!==null&&(M[ee]=null,C[ee].disconnect(ge))}N=null,V=null,g.reset();for(let ee in m)delete m[ee];if(e.setRenderTarget(E),f=null,d=null,u=null,s=null,b=null,fe.stop(),n.isPresenting=!1,e.setPixelRatio(w),e.setSize(x.width,x.height,!1),O!==null){let ee=O.camera;ee.fov=O.fov,ee.zoom=O.zoom,ee.updateProjectionMatrix(),O=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(ee){r=ee,n.isPresenting===!0&&Ke("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(ee){a=ee,n.isPresenting===!0&&Ke("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(ee){c=ee},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return u===null&&v&&(u=new XRWebGLBinding(s,t)),u},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(ee){if(s=ee,s!==null){if(E=e.getRenderTarget(),s.addEventListener("select",Z),s.addEventListener("selectstart",Z),s.addEventListener("selectend",Z),s.addEventListener("squeeze",Z),s.addEventListener("squeezestart",Z),s.addEventListener("squeezeend",Z),s.addEventListener("end",G),s.addEventListener("inputsourceschange",ce),_.xrCompatible!==!0&&await t.makeXRCompatible(),w=e.getPixelRatio(),e.getSize(x),v&&"createProjectionLayer"in XRWebGLBinding.prototype){let ye=null,Pe=null,we=null;_.depth&&(we=_.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,ye=_.stencil?Ls:Es,Pe=_.stencil?Ir:Hi);let Ye={colorFormat:t.RGBA8,depthFormat:we,scaleFactor:r};u=this.getBinding(),d=u.createProjectionLayer(Ye),s.updateRenderState({layers:[d]}),e.setPixelRatio(1),e.setSize(d.textureWidth,d.textureHeight,!1),b=new vi(d.textureWidth,d.textureHeight,{format:Wi,type:ci,depthTexture:new As(d.textureWidth,d.textureHeight,Pe,void 0,void 0,void 0,void 0,void 0,void 0,ye),stencilBuffer:_.stencil,colorSpace:e.outputColorSpace,samples:_.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let ye={antialias:_.antialias,alpha:!0,depth:_.depth,stencil:_.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,t,ye),s.updateRenderState({baseLayer:f}),e.setPixelRatio(1),e.setSize(f.framebufferWidth,f.framebufferHeight,!1),b=new vi(f.framebufferWidth,f.framebufferHeight,{format:Wi,type:ci,colorSpace:e.outputColorSpace,stencilBuffer:_.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}b.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),fe.setContext(s),fe.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function ce(ee){for(let ge=0;ge<ee.removed.length;ge++){let ye=ee.removed[ge],Pe=M.indexOf(ye);Pe>=0&&(M[Pe]=null,C[Pe].disconnect(ye))}for(let ge=0;ge<ee.added.length;ge++){let ye=ee.added[ge],Pe=M.indexOf(ye);if(Pe===-1){for(let Ye=0;Ye<C.length;Ye++)if(Ye>=M.length){M.push(ye),Pe=Ye;break}else if(M[Ye]===null){M[Ye]=ye,Pe=Ye;break}if(Pe===-1)break}let we=C[Pe];we&&we.connect(ye)}}function Y(ee,ge){ge===null?ee.matrixWorld.copy(ee.matrix):ee.matrixWorld.multiplyMatrices(ge.matrixWorld,ee.matrix),ee.matrixWorldInverse.copy(ee.matrixWorld).invert()}this.updateCamera=function(ee){if(s===null)return;let ge=ee.near,ye=ee.far;g.texture!==null&&(g.depthNear>0&&(ge=g.depthNear),g.depthFar>0&&(ye=g.depthFar)),W.near=D.near=P.near=ge,W.far=D.far=P.far=ye,(N!==W.near||V!==W.far)&&(s.updateRenderState({depthNear:W.near,depthFar:W.far}),N=W.near,V=W.far),W.layers.mask=ee.layers.mask|6,P.layers.mask=W.layers.mask&-5,D.layers.mask=W.layers.mask&-3;let Pe=ee.parent,we=W.cameras;Y(W,Pe);for(let Ye=0;Ye<we.length;Ye++)Y(we[Ye],Pe);W.projectionMatrix.copy(P.projectionMatrix),W.projectionMatrixInverse.copy(P.projectionMatrixInverse),O===null&&ee.isPerspectiveCamera&&(O={camera:ee,fov:ee.fov,zoom:ee.zoom}),Q(ee,W,Pe)};function Q(ee,ge,ye){ye===null?ee.matrix.copy(ge.matrixWorld):(ee.matrix.copy(ye.matrixWorld),ee.matrix.invert(),ee.matrix.multiply(ge.matrixWorld)),ee.matrix.decompose(ee.position,ee.quaternion,ee.scale),ee.updateMatrixWorld(!0),ee.projectionMatrix.copy(ge.projectionMatrix),ee.projectionMatrixInverse.copy(ge.projectionMatrixInverse),ee.isPerspectiveCamera&&(ee.fov=wo*2*Math.atan(1/ee.projectionMatrix.elements[5]),ee.zoom=1)}this.getCamera=function(){return W},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function(ee){l=ee,d!==null&&(d.fixedFoveation=ee),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=ee)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(W)},this.getCameraTexture=function(ee){return m[ee]};let ie=null;function de(ee,ge){if(h=ge.getViewerPose(c||o),p=ge,h!==null){let ye=h.views;f!==null&&(e.setRenderTargetFramebuffer(b,f.framebuffer),e.setRenderTarget(b));let Pe=!1;ye.length!==W.cameras.length&&(W.cameras.length=0,Pe=!0);for(let Xe=0;Xe<ye.length;Xe++){let pt=ye[Xe],ut=null;if(f!==null)ut=f.getViewport(pt);else{let jt=u.getViewSubImage(d,pt);ut=jt.viewport,Xe===0&&(e.setRenderTargetTextures(b,jt.colorTexture,jt.depthStencilTexture),e.setRenderTarget(b))}let rt=z[Xe];rt===void 0&&(rt=new si,rt.layers.enable(Xe),rt.viewport=new Xt,z[Xe]=rt),rt.matrix.fromArray(pt.transform.matrix),rt.matrix.decompose(rt.position,rt.quaternion,rt.scale),rt.projectionMatrix.fromArray(pt.projectionMatrix),rt.projectionMatrixInverse.copy(rt.projectionMatrix).invert(),rt.viewport.set(ut.x,ut.y,ut.width,ut.height),Xe===0&&(W.matrix.copy(rt.matrix),W.matrix.decompose(W.position,W.quaternion,W.scale)),Pe===!0&&W.cameras.push(rt)}let we=s.enabledFeatures;if(we&&we.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&v){u=n.getBinding();let Xe=u.getDepthInformation(ye[0]);Xe&&Xe.isValid&&Xe.texture&&g.init(Xe,s.renderState)}if(we&&we.includes("camera-access")&&v){e.state.unbindTexture(),u=n.getBinding();for(let Xe=0;Xe<ye.length;Xe++){let pt=ye[Xe].camera;if(pt){let ut=m[pt];ut||(ut=new Ra,m[pt]=ut);let rt=u.getCameraImage(pt);ut.sourceTexture=rt}}}}for(let ye=0;ye<C.length;ye++){let Pe=M[ye],we=C[ye];Pe!==null&&we!==void 0&&we.update(Pe,ge,c||o)}ie&&ie(ee,ge),ge.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:ge}),p=null}let fe=new A0;fe.setAnimationLoop(de),this.setAnimationLoop=function(ee){ie=ee},this.dispose=function(){}}},gE=new wt,O0=new st;O0.set(-1,0,0,0,1,0,0,0,1);function _E(i,e){function t(g,m){g.matrixAutoUpdate===!0&&g.updateMatrix(),m.value.copy(g.matrix)}function n(g,m){m.color.getRGB(g.fogColor.value,Qd(i)),m.isFog?(g.fogNear.value=m.near,g.fogFar.value=m.far):m.isFogExp2&&(g.fogDensity.value=m.density)}function s(g,m,_,E,b){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?r(g,m):m.isMeshLambertMaterial?(r(g,m),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(r(g,m),u(g,m)):m.isMeshPhongMaterial?(r(g,m),h(g,m),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(r(g,m),d(g,m),m.isMeshPhysicalMaterial&&f(g,m,b)):m.isMeshMatcapMaterial?(r(g,m),p(g,m)):m.isMeshDepthMaterial?r(g,m):m.isMeshDistanceMaterial?(r(g,m),v(g,m)):m.isMeshNormalMaterial?r(g,m):m.isLineBasicMaterial?(o(g,m),m.isLineDashedMaterial&&a(g,m)):m.isPointsMaterial?l(g,m,_,E):m.isSpriteMaterial?c(g,m):m.isShadowMaterial?(g.color.value.copy(m.color),g.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function r(g,m){g.opacity.value=m.opacity,m.color&&g.diffuse.value.copy(m.color),m.emissive&&g.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(g.map.value=m.map,t(m.map,g.mapTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,t(m.alphaMap,g.alphaMapTransform)),m.bumpMap&&(g.bumpMap.value=m.bumpMap,t(m.bumpMap,g.bumpMapTransform),g.bumpScale.value=m.bumpScale,m.side===Gn&&(g.bumpScale.value*=-1)),m.normalMap&&(g.normalMap.value=m.normalMap,t(m.normalMap,g.normalMapTransform),g.normalScale.value.copy(m.normalScale),m.side===Gn&&g.normalScale.value.negate()),m.displacementMap&&(g.displacementMap.value=m.displacementMap,t(m.displacementMap,g.displacementMapTransform),g.displacementScale.value=m.displacementScale,g.displacementBias.value=m.displacementBias),m.emissiveMap&&(g.emissiveMap.value=m.emissiveMap,t(m.emissiveMap,g.emissiveMapTransform)),m.specularMap&&(g.specularMap.value=m.specularMap,t(m.specularMap,g.specularMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest);let _=e.get(m),E=_.envMap,b=_.envMapRotation;E&&(g.envMap.value=E,g.envMapRotation.value.setFromMatrix4(gE.makeRotationFromEuler(b)).transpose(),E.isCubeTexture&&E.isRenderTargetTexture===!1&&g.envMapRotation.value.premultiply(O0),g.reflectivity.value=m.reflectivity,g.ior.value=m.ior,g.refractionRatio.value=m.refractionRatio),m.lightMap&&(g.lightMap.value=m.lightMap,g.lightMapIntensity.value=m.lightMapIntensity,t(m.lightMap,g.lightMapTransform)),m.aoMap&&(g.aoMap.value=m.aoMap,g.aoMapIntensity.value=m.aoMapIntensity,t(m.aoMap,g.aoMapTransform))}function o(g,m){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,m.map&&(g.map.value=m.map,t(m.map,g.mapTransform))}function a(g,m){g.dashSize.value=m.dashSize,g.totalSize.value=m.dashSize+m.gapSize,g.scale.value=m.scale}function l(g,m,_,E){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,g.size.value=m.size*_,g.scale.value=E*.5,m.map&&(g.map.value=m.map,t(m.map,g.uvTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,t(m.alphaMap,g.alphaMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest)}function c(g,m){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,g.rotation.value=m.rotation,m.map&&(g.map.value=m.map,t(m.map,g.mapTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,t(m.alphaMap,g.alphaMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest)}function h(g,m){g.specular.value.copy(m.specular),g.shininess.value=Math.max(m.shininess,1e-4)}function u(g,m){m.gradientMap&&(g.gradientMap.value=m.gradientMap)}function d(g,m){g.metalness.value=m.metalness,m.metalnessMap&&(g.metalnessMap.value=m.metalnessMap,t(m.metalnessMap,g.metalnessMapTransform)),g.roughness.value=m.roughness,m.roughnessMap&&(g.roughnessMap.value=m.roughnessMap,t(m.roughnessMap,g.roughnessMapTransform)),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)}function f(g,m,_){g.ior.value=m.ior,m.diffuseRoughness>0&&(g.diffuseRoughness.value=m.diffuseRoughness,m.diffuseRoughnessMap&&(g.diffuseRoughnessMap.value=m.diffuseRoughnessMap,t(m.diffuseRoughnessMap,g.diffuseRoughnessMapTransform))),m.sheen>0&&(g.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),g.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(g.sheenColorMap.value=m.sheenColorMap,t(m.sheenColorMap,g.sheenColorMapTransform)),m.sheenRoughnessMap&&(g.sheenRoughnessMap.value=m.sheenRoughnessMap,t(m.sheenRoughnessMap,g.sheenRoughnessMapTransform))),m.clearcoat>0&&(g.clearcoat.value=m.clearcoat,g.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(g.clearcoatMap.value=m.clearcoatMap,t(m.clearcoatMap,g.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,t(m.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(g.clearcoatNormalMap.value=m.clearcoatNormalMap,t(m.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===Gn&&g.clearcoatNormalScale.value.negate())),m.dispersion>0&&(g.dispersion.value=m.dispersion),m.retroreflectivity>0&&(g.retroreflectivity.value=m.retroreflectivity),m.iridescence>0&&(g.iridescence.value=m.iridescence,g.iridescenceIOR.value=m.iridescenceIOR,g.iridescenceThicknessMinimum.value=m.iridescenceThicknessMinimum,g.iridescenceThicknessMaximum.value=m.iridescenceThicknessMaximum,m.iridescenceMap&&(g.iridescenceMap.value=m.iridescenceMap,t(m.iridescenceMap,g.iridescenceMapTransform)),m.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=m.iridescenceThicknessMap,t(m.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),m.transmission>0&&(g.transmission.value=m.transmission,g.transmissionSamplerMap.value=_.texture,g.transmissionSamplerSize.value.set(_.width,_.height),m.transmissionMap&&(g.transmissionMap.value=m.transmissionMap,t(m.transmissionMap,g.transmissionMapTransform)),g.thickness.value=m.thickness,m.thicknessMap&&(g.thicknessMap.value=m.thicknessMap,t(m.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=m.attenuationDistance,g.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(g.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(g.anisotropyMap.value=m.anisotropyMap,t(m.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=m.specularIntensity,g.specularColor.value.copy(m.specularColor),m.specularColorMap&&(g.specularColorMap.value=m.specularColorMap,t(m.specularColorMap,g.specularColorMapTransform)),m.specularIntensityMap&&(g.specularIntensityMap.value=m.specularIntensityMap,t(m.specularIntensityMap,g.specularIntensityMapTransform))}function p(g,m){m.matcap&&(g.matcap.value=m.matcap)}function v(g,m){let _=e.get(m).light;g.referencePosition.value.setFromMatrixPosition(_.matrixWorld),g.nearDistance.value=_.shadow.camera.near,g.farDistance.value=_.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function xE(i,e,t,n){let s={},r={};function o(_,E){let b=E.program;n.uniformBlockBinding(_,b,s[_.id])}function a(_,E){let b=s[_.id];b===void 0&&(p(_),b=l(_),s[_.id]=b,_.addEventListener("dispose",g));let C=E.program;n.updateUBOMapping(_,C);let M=e.render.frame;r[_.id]!==M&&(c(_),r[_.id]=M)}function l(_){let E=i.createBuffer(),b=_.__size,C=_.usage;return i.bindBuffer(i.UNIFORM_BUFFER,E),i.bufferData(i.UNIFORM_BUFFER,b,C),i.bindBuffer(i.UNIFORM_BUFFER,null),E}function c(_){let E=s[_.id],b=_.uniforms,C=_.__cache;i.bindBuffer(i.UNIFORM_BUFFER,E);for(let M=0,x=b.length;M<x;M++){let w=b[M];if(Array.isArray(w))for(let O=0,P=w.length;O<P;O++)h(w[O],M,O,C);else h(w,M,0,C)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function h(_,E,b,C){if(d(_,E,b,C)===!0){let M=_.__offset,x=_.value;if(Array.isArray(x)){let w=0;for(let O=0;O<x.length;O++){let P=x[O],D=v(P,!0);u(P,_.__data,w),w+=D.storage/Float32Array.BYTES_PER_ELEMENT}}else u(x,_.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,M,_.__data)}}function u(_,E,b){typeof _=="number"||typeof _=="boolean"?E[b]=_:_.isMatrix3?(E[b]=_.elements[0],E[b+1]=_.elements[1],E[b+2]=_.elements[2],E[b+3]=0,E[b+4]=_.elements[3],E[b+5]=_.elements[4],E[b+6]=_.elements[5],E[b+7]=0,E[b+8]=_.elements[6],E[b+9]=_.elements[7],E[b+10]=_.elements[8],E[b+11]=0):ArrayBuffer.isView(_)?E.set(_.subarray(0,E.length-b),b):_.toArray(E,b)}function d(_,E,b,C){let M=_.value,x=E+"_"+b;if(Array.isArray(M)){C[x]===void 0&&(C[x]=[]);let w=C[x],O=!1;for(let P=0;P<M.length;P++)f(M[P],w,P)===!0&&(O=!0);return O}return f(M,C,x)}function f(_,E,b){if(E[b]===void 0)return typeof _=="number"||typeof _=="boolean"?E[b]=_:ArrayBuffer.isView(_)?E[b]=_.slice():E[b]=_.clone(),!0;{let C=E[b];if(typeof _=="number"||typeof _=="boolean"){if(C!==_)return E[b]=_,!0}else{if(ArrayBuffer.isView(_))return!0;if(C.equals(_)===!1)return C.copy(_),!0}}return!1}function p(_){let E=_.uniforms,b=0,C=16;for(let x=0,w=E.length;x<w;x++){let O=Array.isArray(E[x])?E[x]:[E[x]];for(let P=0,D=O.length;P<D;P++){let z=O[P],W=Array.isArray(z.value)?z.value:[z.value],N=Array.isArray(E[x])||Array.isArray(z.value),V=b;for(let G=0,ce=W.length;G<ce;G++){let Y=W[G],Q=v(Y,N),ie=b%C,de=ie%Q.boundary,fe=ie+de;b+=de,fe!==0&&C-fe<Q.storage&&(b+=C-fe),G===0&&(V=b),b+=Q.storage}let Z=z.type==="int"?Int32Array:z.type==="uint"?Uint32Array:Float32Array;z.__data=new Z((b-V)/Float32Array.BYTES_PER_ELEMENT),z.__offset=V}}let M=b%C;return M>0&&(b+=C-M),_.__size=b,_.__cache={},this}function v(_,E){let b={boundary:0,storage:0};return typeof _=="number"||typeof _=="boolean"?(b.boundary=4,b.storage=4):_.isVector2?(b.boundary=8,b.storage=8):_.isVector3||_.isColor?(b.boundary=16,b.storage=12):_.isVector4?(b.boundary=16,b.storage=16):_.isMatrix3?(b.boundary=16,b.storage=48):_.isMatrix4?(b.boundary=16,b.storage=64):_.isTexture?Ke("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(_)?(b.boundary=16,b.storage=_.byteLength):Ke("WebGLRenderer: Unsupported uniform value type.",_),E===!0&&(b.boundary=16,b.storage=Math.ceil(b.storage/16)*16),b}function g(_){let E=_.target;E.removeEventListener("dispose",g),i.deleteBuffer(s[E.id]),delete s[E.id],delete r[E.id]}function m(){for(let _ in s)i.deleteBuffer(s[_]);s={},r={}}return{bind:o,update:a,dispose:m}}var yE=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),as=null;function vE(){return as===null&&(as=new mc(yE,16,16,rr,Vi),as.name="DFG_LUT",as.minFilter=ri,as.magFilter=ri,as.wrapS=is,as.wrapT=is,as.generateMipmaps=!1,as.needsUpdate=!0),as}var Sh=class{constructor(e={}){let{canvas:t=Kg(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:d=!1,outputBufferType:f=ci}=e;this.isWebGLRenderer=!0;let p;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=n.getContextAttributes().alpha}else p=o;let v=f,g=new Set([Gc,Hc,zc]),m=new Set([ci,Hi,Fo,Ir,Bc,kc]),_=new Uint32Array(4),E=new Int32Array(4),b={textures:[],min:[],max:[],resolution:[]},C=null,M=null,x=[],w=[],O=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=os,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let P=this,D=!1,z=null,W=null,N=null,V=null;this._outputColorSpace=Sn;let Z=0,G=0,ce=null,Y=-1,Q=null,ie=new Xt,de=new Xt,fe=null,ee=new Qe(0),ge=0,ye=t.width,Pe=t.height,we=1,Ye=null,at=null,Xe=new Xt(0,0,ye,Pe),pt=new Xt(0,0,ye,Pe),ut=!1,rt=new js,jt=new gc,Wt=!1,mn=!1,Ot=new wt,Ln=new F,St=new Xt,wn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},rn=!1;function gn(){return ce===null?we:1}let k=n;function Le(A,H){return t.getContext(A,H)}let Je,lt,Ee,kt,Ve,$e,I,S,q,ue,oe,xe,ve,te,se,me,B,re,ne,Te,_e,Se,qe;try{let A={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",ze,!1),t.addEventListener("webglcontextrestored",tt,!1),t.addEventListener("webglcontextcreationerror",Ie,!1),k===null){let H="webgl2";if(k=Le(H,A),k===null)throw Le(H)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}et()}catch(A){throw t.removeEventListener("webglcontextlost",ze,!1),t.removeEventListener("webglcontextrestored",tt,!1),t.removeEventListener("webglcontextcreationerror",Ie,!1),nt("WebGLRenderer: "+A.message),A}function et(){Je=new IS(k),Je.init(),_e=new fE(k,Je),lt=new vS(k,Je,e,_e),Ee=new uE(k,Je),lt.reversedDepthBuffer&&d&&Ee.buffers.depth.setReversed(!0),W=k.createFramebuffer(),N=k.createFramebuffer(),V=k.createFramebuffer(),kt=new NS(k),Ve=new Jw,$e=new dE(k,Je,Ee,Ve,lt,_e,kt),I=new PS(P),S=new Fv(k),Se=new xS(k,S),q=new LS(k,S,kt,Se),ue=new FS(k,q,S,Se,kt),re=new US(k,lt,$e),se=new bS(Ve),oe=new Kw(P,I,Je,lt,Se,se),xe=new _E(P,Ve),ve=new Qw,te=new rE(Je),B=new _S(P,I,Ee,ue,p,l),me=new hE(P,ue,lt),qe=new xE(k,kt,lt,Ee),ne=new yS(k,Je,kt),Te=new DS(k,Je,kt),kt.programs=oe.programs,P.capabilities=lt,P.extensions=Je,P.properties=Ve,P.renderLists=ve,P.shadowMap=me,P.state=Ee,P.info=kt}v!==ci&&(O=new BS(v,t.width,t.height,a,s,r));let he=new ff(P,k);this.xr=he,this.getContext=function(){return k},this.getContextAttributes=function(){return k.getContextAttributes()},this.forceContextLoss=function(){let A=Je.get("WEBGL_lose_context");A&&A.loseContext()},this.forceContextRestore=function(){let A=Je.get("WEBGL_lose_context");A&&A.restoreContext()},this.getPixelRatio=function(){return we},this.setPixelRatio=function(A){A!==void 0&&(we=A,this.setSize(ye,Pe,!1))},this.getSize=function(A){return A.set(ye,Pe)},this.setSize=function(A,H,j=!0){if(he.isPresenting){Ke("WebGLRenderer: Can't change size while VR device is presenting.");return}ye=A,Pe=H,t.width=Math.floor(A*we),t.height=Math.floor(H*we),j===!0&&(t.style.width=A+"px",t.style.height=H+"px"),O!==null&&O.setSize(t.width,t.height),this.setViewport(0,0,A,H)},this.getDrawingBufferSize=function(A){return A.set(ye*we,Pe*we).floor()},this.setDrawingBufferSize=function(A,H,j){ye=A,Pe=H,we=j,t.width=Math.floor(A*j),t.height=Math.floor(H*j),this.setViewport(0,0,A,H)},this.setEffects=function(A){if(v===ci){nt("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(A){for(let H=0;H<A.length;H++)if(A[H].isOutputPass===!0){Ke("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}O.setEffects(A||[])},this.getCurrentViewport=function(A){return A.copy(ie)},this.getViewport=function(A){return A.copy(Xe)},this.setViewport=function(A,H,j,$){A.isVector4?Xe.set(A.x,A.y,A.z,A.w):Xe.set(A,H,j,$),Ee.viewport(ie.copy(Xe).multiplyScalar(gn()).round())},this.getScissor=function(A){return A.copy(pt)},this.setScissor=function(A,H,j,$){A.isVector4?pt.set(A.x,A.y,A.z,A.w):pt.set(A,H,j,$),Ee.scissor(de.copy(pt).multiplyScalar(gn()).round())},this.getScissorTest=function(){return ut},this.setScissorTest=function(A){Ee.setScissorTest(ut=A)},this.setOpaqueSort=function(A){Ye=A},this.setTransparentSort=function(A){at=A},this.getClearColor=function(A){return A.copy(B.getClearColor())},this.setClearColor=function(){B.setClearColor(...arguments)},this.getClearAlpha=function(){return B.getClearAlpha()},this.setClearAlpha=function(){B.setClearAlpha(...arguments)},this.clear=function(A=!0,H=!0,j=!0){let $=0;if(A){let K=!1;if(ce!==null){let Ae=ce.texture.format;K=g.has(Ae)}if(K){let Ae=ce.texture.type,De=m.has(Ae),Re=B.getClearColor(),Ne=B.getClearAlpha(),Ge=Re.r,it=Re.g,mt=Re.b;De?(_[0]=Ge,_[1]=it,_[2]=mt,_[3]=Ne,k.clearBufferuiv(k.COLOR,0,_)):(E[0]=Ge,E[1]=it,E[2]=mt,E[3]=Ne,k.clearBufferiv(k.COLOR,0,E))}else $|=k.COLOR_BUFFER_BIT}H&&($|=k.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),j&&($|=k.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),$!==0&&k.clear($)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(A){A.setRenderer(this),z=A},this.dispose=function(){t.removeEventListener("webglcontextlost",ze,!1),t.removeEventListener("webglcontextrestored",tt,!1),t.removeEventListener("webglcontextcreationerror",Ie,!1),B.dispose(),ve.dispose(),te.dispose(),$e.dispose(),Ve.dispose(),I.dispose(),ue.dispose(),q.dispose(),Se.dispose(),qe.dispose(),oe.dispose(),he.dispose(),he.removeEventListener("sessionstart",ll),he.removeEventListener("sessionend",Zi),hs.stop()};function ze(A){A.preventDefault(),$d("WebGLRenderer: Context Lost."),D=!0}function tt(){$d("WebGLRenderer: Context Restored."),D=!1;let A=kt.autoReset,H=me.enabled,j=me.autoUpdate,$=me.needsUpdate,K=me.type;et(),kt.autoReset=A,me.enabled=H,me.autoUpdate=j,me.needsUpdate=$,me.type=K}function Ie(A){nt("WebGLRenderer: A WebGL context could not be created. Reason: ",A.statusMessage)}function ht(A){let H=A.target;H.removeEventListener("dispose",ht),qt(H)}function qt(A){jn(A),Ve.remove(A)}function jn(A){let H=Ve.get(A).programs;H!==void 0&&(H.forEach(function(j){oe.releaseProgram(j)}),A.isShaderMaterial&&oe.releaseShaderCache(A))}this.renderBufferDirect=function(A,H,j,$,K,Ae){H===null&&(H=wn);let De=K.isMesh&&K.matrixWorld.determinantAffine()<0,Re=Ko(A,H,j,$,K);Ee.setMaterial($,De);let Ne=j.index,Ge=1;if($.wireframe===!0){if(Ne=q.getWireframeAttribute(j),Ne===void 0)return;Ge=2}let it=j.drawRange,mt=j.attributes.position,He=it.start*Ge,gt=(it.start+it.count)*Ge;Ae!==null&&(He=Math.max(He,Ae.start*Ge),gt=Math.min(gt,(Ae.start+Ae.count)*Ge)),Ne!==null?(He=Math.max(He,0),gt=Math.min(gt,Ne.count)):mt!=null&&(He=Math.max(He,0),gt=Math.min(gt,mt.count));let sn=gt-He;if(sn<0||sn===1/0)return;Se.setup(K,$,Re,j,Ne);let Nt,Ut=ne;if(Ne!==null&&(Nt=S.get(Ne),Ut=Te,Ut.setIndex(Nt)),K.isMesh)$.wireframe===!0?(Ee.setLineWidth($.wireframeLinewidth*gn()),Ut.setMode(k.LINES)):Ut.setMode(k.TRIANGLES);else if(K.isLine){let En=$.linewidth;En===void 0&&(En=1),Ee.setLineWidth(En*gn()),K.isLineSegments?Ut.setMode(k.LINES):K.isLineLoop?Ut.setMode(k.LINE_LOOP):Ut.setMode(k.LINE_STRIP)}else K.isPoints?Ut.setMode(k.POINTS):K.isSprite&&Ut.setMode(k.TRIANGLES);if(K.isBatchedMesh)if(Je.get("WEBGL_multi_draw"))Ut.renderMultiDraw(K._multiDrawStarts,K._multiDrawCounts,K._multiDrawCount);else{let En=K._multiDrawStarts,Be=K._multiDrawCounts,_n=K._multiDrawCount,vt=Ne?S.get(Ne).bytesPerElement:1,ds=Ve.get($).currentProgram.getUniforms();for(let xn=0;xn<_n;xn++)ds.setValue(k,"_gl_DrawID",xn),Ut.render(En[xn]/vt,Be[xn])}else if(K.isInstancedMesh)Ut.renderInstances(He,sn,K.count);else if(j.isInstancedBufferGeometry){let En=j._maxInstanceCount!==void 0?j._maxInstanceCount:1/0,Be=Math.min(j.instanceCount,En);Ut.renderInstances(He,sn,Be)}else Ut.render(He,sn)};function Yo(A,H,j,$){z!==null&&A.isNodeMaterial&&z.setObject($,A),Wt===!0&&se.setState(A,j,!1),A.transparent===!0&&A.side===Kn&&A.forceSinglePass===!1?(A.side=Gn,A.needsUpdate=!0,$i(A,H,$),A.side=rs,A.needsUpdate=!0,$i(A,H,$),A.side=Kn):$i(A,H,$)}this.compile=function(A,H,j=null){j===null&&(j=A),z!==null&&z.renderStart(A,H,j),M=te.get(j),M.init(H),w.push(M),j.traverseVisible(function(K){K.isLight&&K.layers.test(H.layers)&&(M.pushLight(K),K.castShadow&&M.pushShadow(K))}),A!==j&&A.traverseVisible(function(K){K.isLight&&K.layers.test(H.layers)&&(M.pushLight(K),K.castShadow&&M.pushShadow(K))}),M.setupLights(),z!==null&&z.updateLights(M.state.lightsArray),mn=this.localClippingEnabled,Wt=se.init(this.clippingPlanes,mn),Wt===!0&&se.setGlobalState(this.clippingPlanes,H),z!==null&&me.render(M.state.shadowsArray,j,H);let $=new Set;return A.traverse(function(K){if(!(K.isMesh||K.isPoints||K.isLine||K.isSprite))return;let Ae=K.material;if(Ae)if(Array.isArray(Ae))for(let De=0;De<Ae.length;De++){let Re=Ae[De];Yo(Re,j,H,K),$.add(Re)}else Yo(Ae,j,H,K),$.add(Ae)}),M=w.pop(),z!==null&&z.renderEnd(),$},this.compileAsync=function(A,H,j=null){let $=this.compile(A,H,j);return new Promise(K=>{function Ae(){if($.forEach(function(De){let Ne=Ve.get(De).currentProgram;(Ne===void 0||Ne.isReady())&&$.delete(De)}),$.size===0){K(A);return}setTimeout(Ae,10)}Je.get("KHR_parallel_shader_compile")!==null?Ae():setTimeout(Ae,10)})};let Br=null;function iu(A){Br&&Br(A)}function ll(){hs.stop()}function Zi(){hs.start()}let hs=new A0;hs.setAnimationLoop(iu),typeof self<"u"&&hs.setContext(self),this.setAnimationLoop=function(A){Br=A,he.setAnimationLoop(A),A===null?hs.stop():hs.start()},he.addEventListener("sessionstart",ll),he.addEventListener("sessionend",Zi),this.render=function(A,H){if(H!==void 0&&H.isCamera!==!0){nt("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(D===!0)return;z!==null&&z.renderStart(A,H);let j=he.enabled===!0&&he.isPresenting===!0,$=O!==null&&(ce===null||j)&&O.begin(P,ce);if(A.matrixWorldAutoUpdate===!0&&A.updateMatrixWorld(),H.parent===null&&H.matrixWorldAutoUpdate===!0&&H.updateMatrixWorld(),he.enabled===!0&&he.isPresenting===!0&&(O===null||O.isCompositing()===!1)&&(he.cameraAutoUpdate===!0&&he.updateCamera(H),H=he.getCamera()),A.isScene===!0&&A.onBeforeRender(P,A,H,ce),M=te.get(A,w.length),M.init(H),M.state.textureUnits=$e.getTextureUnits(),w.push(M),Ot.multiplyMatrices(H.projectionMatrix,H.matrixWorldInverse),H.isArrayCamera?jt.setFromArrayCamera(H):rt.setFromProjectionMatrix(Ot,Ai,H.reversedDepth),mn=this.localClippingEnabled,Wt=se.init(this.clippingPlanes,mn),C=ve.get(A,x.length),C.init(),x.push(C),this.info.render.frame++,he.enabled===!0&&he.isPresenting===!0){let De=P.xr.getDepthSensingMesh();De!==null&&us(De,H,-1/0,P.sortObjects)}us(A,H,0,P.sortObjects),C.finish(),z!==null&&z.updateLights(M.state.lightsArray),P.sortObjects===!0&&C.sort(Ye,at),rn=he.enabled===!1||he.isPresenting===!1||he.hasDepthSensing()===!1,rn&&B.addToRenderList(C,A),this.info.autoReset===!0&&this.info.reset(),Wt===!0&&se.beginShadows();let K=M.state.shadowsArray;if(me.render(K,A,H),Wt===!0&&se.endShadows(),($&&O.hasRenderPass())===!1){let De=C.opaque,Re=C.transmissive;if(M.setupLights(),H.isArrayCamera){let Ne=H.cameras;if(Re.length>0)for(let Ge=0,it=Ne.length;Ge<it;Ge++){let mt=Ne[Ge];Pi(De,Re,A,mt)}rn&&B.render(A);for(let Ge=0,it=Ne.length;Ge<it;Ge++){let mt=Ne[Ge];Zo(C,A,mt,mt.viewport)}}else Re.length>0&&Pi(De,Re,A,H),rn&&B.render(A),Zo(C,A,H)}ce!==null&&G===0&&($e.updateMultisampleRenderTarget(ce),$e.updateRenderTargetMipmap(ce)),$&&O.end(P),A.isScene===!0&&A.onAfterRender(P,A,H),Se.resetDefaultState(),Y=-1,Q=null,w.pop(),w.length>0?(M=w[w.length-1],$e.setTextureUnits(M.state.textureUnits),Wt===!0&&se.setGlobalState(P.clippingPlanes,M.state.camera)):M=null,x.pop(),x.length>0?C=x[x.length-1]:C=null,z!==null&&z.renderEnd()};function us(A,H,j,$){if(A.visible===!1)return;if(A.layers.test(H.layers)){if(A.isGroup)j=A.renderOrder;else if(A.isLOD)A.autoUpdate===!0&&A.update(H);else if(A.isLight)M.pushLight(A),A.castShadow&&M.pushShadow(A);else if(A.isSprite){let De=H.isArrayCamera?jt:rt;if(!A.frustumCulled||A.intersectsFrustum(De)){$&&St.setFromMatrixPosition(A.matrixWorld).applyMatrix4(Ot);let Re=ue.update(A),Ne=A.material;Ne.visible&&C.push(A,Re,Ne,j,St.z,null,H)}}else if(A.isMesh||A.isLine||A.isPoints){let De=H.isArrayCamera?jt:rt;if(!A.frustumCulled||A.intersectsFrustum(De)){let Re=ue.update(A),Ne=A.material;if($&&(A.boundingSphere!==void 0?(A.boundingSphere===null&&A.computeBoundingSphere(),St.copy(A.boundingSphere.center)):(Re.boundingSphere===null&&Re.computeBoundingSphere(),St.copy(Re.boundingSphere.center)),St.applyMatrix4(A.matrixWorld).applyMatrix4(Ot)),Array.isArray(Ne)){let Ge=Re.groups;for(let it=0,mt=Ge.length;it<mt;it++){let He=Ge[it],gt=Ne[He.materialIndex];gt&&gt.visible&&C.push(A,Re,gt,j,St.z,He,H)}}else Ne.visible&&C.push(A,Re,Ne,j,St.z,null,H)}}}let Ae=A.children;for(let De=0,Re=Ae.length;De<Re;De++)us(Ae[De],H,j,$)}function Zo(A,H,j,$){let{opaque:K,transmissive:Ae,transparent:De}=A;M.setupLightsView(j),Wt===!0&&se.setGlobalState(P.clippingPlanes,j),$&&Ee.viewport(ie.copy($)),K.length>0&&on(K,H,j),Ae.length>0&&on(Ae,H,j),De.length>0&&on(De,H,j),Ee.buffers.depth.setTest(!0),Ee.buffers.depth.setMask(!0),Ee.buffers.color.setMask(!0),Ee.setPolygonOffset(!1)}function Pi(A,H,j,$){if((j.isScene===!0?j.overrideMaterial:null)!==null)return;if(M.state.transmissionRenderTarget[$.id]===void 0){let He=Je.has("EXT_color_buffer_half_float")||Je.has("EXT_color_buffer_float");M.state.transmissionRenderTarget[$.id]=new vi(1,1,{generateMipmaps:!0,type:He?Vi:ci,minFilter:Is,samples:Math.max(4,lt.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:Mt.workingColorSpace})}let Ae=M.state.transmissionRenderTarget[$.id],De=$.viewport||ie;Ae.setSize(De.z*P.transmissionResolutionScale,De.w*P.transmissionResolutionScale);let Re=P.getRenderTarget(),Ne=P.getActiveCubeFace(),Ge=P.getActiveMipmapLevel();P.setRenderTarget(Ae),P.getClearColor(ee),ge=P.getClearAlpha(),ge<1&&P.setClearColor(16777215,.5),P.clear(),rn&&B.render(j);let it=P.toneMapping;P.toneMapping=os;let mt=$.viewport;if($.viewport!==void 0&&($.viewport=void 0),M.setupLightsView($),Wt===!0&&se.setGlobalState(P.clippingPlanes,$),on(A,j,$),$e.updateMultisampleRenderTarget(Ae),$e.updateRenderTargetMipmap(Ae),Je.has("WEBGL_multisampled_render_to_texture")===!1){let He=!1;for(let gt=0,sn=H.length;gt<sn;gt++){let Nt=H[gt],{object:Ut,geometry:En,material:Be,group:_n}=Nt;if(Be.side===Kn&&Ut.layers.test($.layers)){let vt=Be.side;Be.side=Gn,Be.needsUpdate=!0,dn(Ut,j,$,En,Be,_n),Be.side=vt,Be.needsUpdate=!0,He=!0}}He===!0&&($e.updateMultisampleRenderTarget(Ae),$e.updateRenderTargetMipmap(Ae))}P.setRenderTarget(Re,Ne,Ge),P.setClearColor(ee,ge),mt!==void 0&&($.viewport=mt),P.toneMapping=it}function on(A,H,j){let $=H.isScene===!0?H.overrideMaterial:null;for(let K=0,Ae=A.length;K<Ae;K++){let De=A[K],{object:Re,geometry:Ne,group:Ge}=De,it=De.material;it.allowOverride===!0&&$!==null&&(it=$),Re.layers.test(j.layers)&&dn(Re,H,j,Ne,it,Ge)}}function dn(A,H,j,$,K,Ae){z!==null&&K.isNodeMaterial&&z.setObject(A,K),A.onBeforeRender(P,H,j,$,K,Ae),A.modelViewMatrix.multiplyMatrices(j.matrixWorldInverse,A.matrixWorld),A.normalMatrix.getNormalMatrix(A.modelViewMatrix),K.onBeforeRender(P,H,j,$,A,Ae),K.transparent===!0&&K.side===Kn&&K.forceSinglePass===!1?(K.side=Gn,K.needsUpdate=!0,P.renderBufferDirect(j,H,$,K,A,Ae),K.side=rs,K.needsUpdate=!0,P.renderBufferDirect(j,H,$,K,A,Ae),K.side=Kn):P.renderBufferDirect(j,H,$,K,A,Ae),A.onAfterRender(P,H,j,$,K,Ae)}function fn(A){let H=0;for(let j of A)j.texture!==null&&H++;return H}function $i(A,H,j){H.isScene!==!0&&(H=wn);let $=Ve.get(A),K=M.state.lights,Ae=M.state.shadowsArray,De=K.state.version,Re=oe.getParameters(A,K.state,Ae,H,j,M.state.lightProbeGridArray),Ne=oe.getProgramCacheKey(Re),Ge=$.programs;$.environment=A.isMeshStandardMaterial||A.isMeshLambertMaterial||A.isMeshPhongMaterial?H.environment:null,$.fog=H.fog;let it=A.isMeshStandardMaterial||A.isMeshLambertMaterial&&!A.envMap||A.isMeshPhongMaterial&&!A.envMap;$.envMap=I.get(A.envMap||$.environment,it),$.envMapRotation=$.environment!==null&&A.envMap===null?H.environmentRotation:A.envMapRotation,Ge===void 0&&(A.addEventListener("dispose",ht),Ge=new Map,$.programs=Ge,$.programVariants=new Map);let mt=Ge.get(Ne);if(mt!==void 0){if($.currentProgram===mt&&$.lightsStateVersion===De)return $o(A,Re),mt}else Re.uniforms=oe.getUniforms(A),z!==null&&A.isNodeMaterial&&z.build(A,j,Re),A.onBeforeCompile(Re,P),mt=oe.acquireProgram(Re,Ne),Ge.set(Ne,mt),$.uniforms=Re.uniforms;let He=$.uniforms;return(!A.isShaderMaterial&&!A.isRawShaderMaterial||A.clipping===!0)&&(He.clippingPlanes=se.uniform),$o(A,Re),$.needsLights=Os(A),$.lightsStateVersion=De,$.needsLights&&(He.ambientLightColor.value=K.state.ambient,He.lightProbe.value=K.state.probe,He.sunLights.value=K.state.sun,He.sunLightShadows.value=K.state.sunShadow,He.directionalLights.value=K.state.directional,He.directionalLightShadows.value=K.state.directionalShadow,He.spotLights.value=K.state.spot,He.spotLightShadows.value=K.state.spotShadow,He.rectAreaLights.value=K.state.rectArea,He.ltc_1.value=K.state.rectAreaLTC1,He.ltc_2.value=K.state.rectAreaLTC2,He.pointLights.value=K.state.point,He.pointLightShadows.value=K.state.pointShadow,He.hemisphereLights.value=K.state.hemi,He.sunShadowMatrix.value=K.state.sunShadowMatrix,He.sunShadowCascade.value=K.state.sunShadowCascade,He.directionalShadowMatrix.value=K.state.directionalShadowMatrix,He.spotLightMatrix.value=K.state.spotLightMatrix,He.spotLightMap.value=K.state.spotLightMap,He.pointShadowMatrix.value=K.state.pointShadowMatrix),$.numLightProbeGrids=fn(M.state.lightProbeGridArray),$.currentProgram=mt,$.uniformsList=null,mt}function ui(A,H,j,$,K){let Ae=Ve.get(A),De=Ae.currentProgram.id+","+$+","+K,Re=Ae.programVariants.get(De);return Re===void 0?(Re=$i(A,H,j),Ae.programVariants.set(De,Re)):(Ae.currentProgram=Re,Ae.uniformsList=null,Ae.outputColorSpace=$,Ae.toneMapping=K),Re}function Fs(A){if(A.uniformsList===null){let H=A.currentProgram.getUniforms();A.uniformsList=Bo.seqWithValue(H.seq,A.uniforms)}return A.uniformsList}function $o(A,H){let j=Ve.get(A);j.outputColorSpace=H.outputColorSpace,j.batching=H.batching,j.batchingColor=H.batchingColor,j.instancing=H.instancing,j.instancingColor=H.instancingColor,j.instancingMorph=H.instancingMorph,j.skinning=H.skinning,j.morphTargets=H.morphTargets,j.morphNormals=H.morphNormals,j.morphColors=H.morphColors,j.morphTargetsCount=H.morphTargetsCount,j.numClippingPlanes=H.numClippingPlanes,j.numIntersection=H.numClipIntersection,j.vertexAlphas=H.vertexAlphas,j.vertexTangents=H.vertexTangents,j.toneMapping=H.toneMapping}function Ko(A,H,j,$,K){H.isScene!==!0&&(H=wn),$e.resetTextureUnits();let Ae=H.fog,De=$.isMeshStandardMaterial||$.isMeshLambertMaterial||$.isMeshPhongMaterial?H.environment:null,Re=ce===null?P.outputColorSpace:ce.isXRRenderTarget===!0?ce.texture.colorSpace:Mt.workingColorSpace,Ne=$.isMeshStandardMaterial||$.isMeshLambertMaterial&&!$.envMap||$.isMeshPhongMaterial&&!$.envMap,Ge=I.get($.envMap||De,Ne),it=$.vertexColors===!0&&!!j.attributes.color&&j.attributes.color.itemSize===4,mt=!!j.attributes.tangent&&(!!$.normalMap||$.anisotropy>0),He=!!j.morphAttributes.position,gt=!!j.morphAttributes.normal,sn=!!j.morphAttributes.color,Nt=os;$.toneMapped&&(ce===null||ce.isXRRenderTarget===!0)&&(Nt=P.toneMapping);let Ut=j.morphAttributes.position||j.morphAttributes.normal||j.morphAttributes.color,En=Ut!==void 0?Ut.length:0,Be=Ve.get($),_n=M.state.lights;if(Wt===!0&&(mn===!0||A!==Q)){let Ft=A===Q&&$.id===Y;se.setState($,A,Ft)}let vt=!1,ds=!1;$.version===Be.__version?Be.needsLights&&Be.lightsStateVersion!==_n.state.version||K.isBatchedMesh&&Be.batching===!1||!K.isBatchedMesh&&Be.batching===!0||K.isBatchedMesh&&Be.batchingColor===!0&&K._colorsTexture===null||K.isBatchedMesh&&Be.batchingColor===!1&&K._colorsTexture!==null||K.isInstancedMesh&&Be.instancing===!1||!K.isInstancedMesh&&Be.instancing===!0||K.isSkinnedMesh&&Be.skinning===!1||!K.isSkinnedMesh&&Be.skinning===!0||K.isInstancedMesh&&Be.instancingColor===!0&&K.instanceColor===null||K.isInstancedMesh&&Be.instancingColor===!1&&K.instanceColor!==null||K.isInstancedMesh&&Be.instancingMorph===!0&&K.morphTexture===null||K.isInstancedMesh&&Be.instancingMorph===!1&&K.morphTexture!==null||Be.envMap!==Ge||$.fog===!0&&Be.fog!==Ae||Be.numClippingPlanes!==void 0&&(Be.numClippingPlanes!==se.numPlanes||Be.numIntersection!==se.numIntersection)||Be.vertexAlphas!==it||Be.vertexTangents!==mt||Be.morphTargets!==He||Be.morphNormals!==gt||Be.morphColors!==sn||Be.morphTargetsCount!==En||Be.numLightProbeGrids!==fn(M.state.lightProbeGridArray)?vt=!0:(Be.outputColorSpace!==Re||Be.toneMapping!==Nt)&&(ds=!0):(vt=!0,Be.__version=$.version);let xn=Be.currentProgram;(vt===!0||ds===!0)&&(xn=ds===!0?ui($,H,K,Re,Nt):$i($,H,K),z&&$.isNodeMaterial&&z.onUpdateProgram($,xn,Be));let Hr=!1,Ki=!1,fs=!1,dt=xn.getUniforms(),an=Be.uniforms;if(Ee.useProgram(xn.program)&&(Hr=!0,Ki=!0,fs=!0),$.id!==Y&&(Y=$.id,Ki=!0),Hr||Q!==A){Ee.buffers.depth.getReversed()&&A.reversedDepth!==!0&&(A._reversedDepth=!0,A.updateProjectionMatrix()),dt.setValue(k,"projectionMatrix",A.projectionMatrix),dt.setValue(k,"viewMatrix",A.matrixWorldInverse);let yn=dt.map.cameraPosition;yn!==void 0&&yn.setValue(k,Ln.setFromMatrixPosition(A.matrixWorld)),lt.logarithmicDepthBuffer&&dt.setValue(k,"logDepthBufFC",2/(Math.log(A.far+1)/Math.LN2)),($.isMeshPhongMaterial||$.isMeshToonMaterial||$.isMeshLambertMaterial||$.isMeshBasicMaterial||$.isMeshStandardMaterial||$.isShaderMaterial)&&dt.setValue(k,"isOrthographic",A.isOrthographicCamera===!0),Q!==A&&(Q=A,Ki=!0,fs=!0)}if(Be.needsLights&&(_n.state.sunShadowMap.length>0&&dt.setValue(k,"sunShadowMap",_n.state.sunShadowMap,$e),_n.state.directionalShadowMap.length>0&&dt.setValue(k,"directionalShadowMap",_n.state.directionalShadowMap,$e),_n.state.spotShadowMap.length>0&&dt.setValue(k,"spotShadowMap",_n.state.spotShadowMap,$e),_n.state.pointShadowMap.length>0&&dt.setValue(k,"pointShadowMap",_n.state.pointShadowMap,$e)),K.isSkinnedMesh){dt.setOptional(k,K,"bindMatrix"),dt.setOptional(k,K,"bindMatrixInverse");let Ft=K.skeleton;Ft&&(Ft.boneTexture===null&&Ft.computeBoneTexture(),dt.setValue(k,"boneTexture",Ft.boneTexture,$e))}K.isBatchedMesh&&(dt.setOptional(k,K,"batchingTexture"),dt.setValue(k,"batchingTexture",K._matricesTexture,$e),dt.setOptional(k,K,"batchingIdTexture"),dt.setValue(k,"batchingIdTexture",K._indirectTexture,$e),dt.setOptional(k,K,"batchingColorTexture"),K._colorsTexture!==null&&dt.setValue(k,"batchingColorTexture",K._colorsTexture,$e));let Qn=j.morphAttributes;if((Qn.position!==void 0||Qn.normal!==void 0||Qn.color!==void 0)&&re.update(K,j,xn),(Ki||Be.receiveShadow!==K.receiveShadow)&&(Be.receiveShadow=K.receiveShadow,dt.setValue(k,"receiveShadow",K.receiveShadow)),($.isMeshStandardMaterial||$.isMeshLambertMaterial||$.isMeshPhongMaterial)&&$.envMap===null&&H.environment!==null&&(an.envMapIntensity.value=H.environmentIntensity),an.dfgLUT!==void 0&&(an.dfgLUT.value=vE()),Ki){if(dt.setValue(k,"toneMappingExposure",P.toneMappingExposure),Be.needsLights&&kr(an,fs),Ae&&$.fog===!0&&xe.refreshFogUniforms(an,Ae),xe.refreshMaterialUniforms(an,$,we,Pe,M.state.transmissionRenderTarget[A.id]),Be.needsLights&&Be.numLightProbeGrids>0){let Ft=b,yn=0;for(let Wn of M.state.lightProbeGridArray)Wn.texture!==null&&(Ft.textures[yn]=Wn.texture,Ft.min[yn]=Wn.boundingBox.min,Ft.max[yn]=Wn.boundingBox.max,Ft.resolution[yn]=Wn.resolution,yn++);for(let Wn in Ft)Ft[Wn].length=yn;an.probesSH.value=Ft.textures,an.probesMin.value=Ft.min,an.probesMax.value=Ft.max,an.probesResolution.value=Ft.resolution}Bo.upload(k,Fs(Be),an,$e)}if($.isShaderMaterial&&$.uniformsNeedUpdate===!0&&(Bo.upload(k,Fs(Be),an,$e),$.uniformsNeedUpdate=!1),$.isSpriteMaterial&&dt.setValue(k,"center",K.center),dt.setValue(k,"modelViewMatrix",K.modelViewMatrix),dt.setValue(k,"normalMatrix",K.normalMatrix),dt.setValue(k,"modelMatrix",K.matrixWorld),$.uniformsGroups!==void 0){let Ft=$.uniformsGroups;for(let yn=0,Wn=Ft.length;yn<Wn;yn++){let cl=Ft[yn];qe.update(cl,xn),qe.bind(cl,xn)}}return xn}function kr(A,H){A.ambientLightColor.needsUpdate=H,A.lightProbe.needsUpdate=H,A.sunLights.needsUpdate=H,A.sunLightShadows.needsUpdate=H,A.directionalLights.needsUpdate=H,A.directionalLightShadows.needsUpdate=H,A.pointLights.needsUpdate=H,A.pointLightShadows.needsUpdate=H,A.spotLights.needsUpdate=H,A.spotLightShadows.needsUpdate=H,A.rectAreaLights.needsUpdate=H,A.hemisphereLights.needsUpdate=H}function Os(A){return A.isMeshLambertMaterial||A.isMeshToonMaterial||A.isMeshPhongMaterial||A.isMeshStandardMaterial||A.isShadowMaterial||A.isShaderMaterial&&A.lights===!0}this.getActiveCubeFace=function(){return Z},this.getActiveMipmapLevel=function(){return G},this.getRenderTarget=function(){return ce},this.setRenderTargetTextures=function(A,H,j){let $=Ve.get(A);$.__autoAllocateDepthBuffer=A.resolveDepthBuffer===!1,$.__autoAllocateDepthBuffer===!1&&($.__useRenderToTexture=!1),Ve.get(A.texture).__webglTexture=H,Ve.get(A.depthTexture).__webglTexture=$.__autoAllocateDepthBuffer?void 0:j,$.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(A,H){let j=Ve.get(A);j.__webglFramebuffer=H,j.__useDefaultFramebuffer=H===void 0},this.setRenderTarget=function(A,H=0,j=0){ce=A,Z=H,G=j;let $=null,K=!1,Ae=!1;if(A){let Re=Ve.get(A);if(Re.__useDefaultFramebuffer!==void 0){Ee.bindFramebuffer(k.FRAMEBUFFER,Re.__webglFramebuffer),ie.copy(A.viewport),de.copy(A.scissor),fe=A.scissorTest,Ee.viewport(ie),Ee.scissor(de),Ee.setScissorTest(fe),Y=-1;return}else if(Re.__webglFramebuffer===void 0)$e.setupRenderTarget(A);else if(Re.__hasExternalTextures)$e.rebindTextures(A,Ve.get(A.texture).__webglTexture,Ve.get(A.depthTexture).__webglTexture);else if(A.depthBuffer){let it=A.depthTexture;if(Re.__boundDepthTexture!==it){if(it!==null&&Ve.has(it)&&(A.width!==it.image.width||A.height!==it.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");$e.setupDepthRenderbuffer(A)}}let Ne=A.texture;(Ne.isData3DTexture||Ne.isDataArrayTexture||Ne.isCompressedArrayTexture)&&(Ae=!0);let Ge=Ve.get(A).__webglFramebuffer;A.isWebGLCubeRenderTarget?(Array.isArray(Ge[H])?$=Ge[H][j]:$=Ge[H],K=!0):A.samples>0&&$e.useMultisampledRTT(A)===!1?$=Ve.get(A).__webglMultisampledFramebuffer:Array.isArray(Ge)?$=Ge[j]:$=Ge,ie.copy(A.viewport),de.copy(A.scissor),fe=A.scissorTest}else ie.copy(Xe).multiplyScalar(we).floor(),de.copy(pt).multiplyScalar(we).floor(),fe=ut;if(j!==0&&($=W),Ee.bindFramebuffer(k.FRAMEBUFFER,$)&&Ee.drawBuffers(A,$),Ee.viewport(ie),Ee.scissor(de),Ee.setScissorTest(fe),K){let Re=Ve.get(A.texture);k.framebufferTexture2D(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_CUBE_MAP_POSITIVE_X+H,Re.__webglTexture,j)}else if(Ae){let Re=H;for(let Ne=0;Ne<A.textures.length;Ne++){let Ge=Ve.get(A.textures[Ne]);k.framebufferTextureLayer(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0+Ne,Ge.__webglTexture,j,Re)}}else if(A!==null&&j!==0){let Re=Ve.get(A.texture);k.framebufferTexture2D(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,Re.__webglTexture,j)}Y=-1};function zr(A){let H=Ve.get(A);return(H.__readFormat!==A.format||H.__readType!==A.type)&&(H.__readFormat=A.format,H.__readType=A.type,H.__formatReadable=lt.textureFormatReadable(A.format),H.__typeReadable=lt.textureTypeReadable(A.type)),H}this.readRenderTargetPixels=function(A,H,j,$,K,Ae,De,Re=0){if(!(A&&A.isWebGLRenderTarget)){nt("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ne=Ve.get(A).__webglFramebuffer;if(A.isWebGLCubeRenderTarget&&De!==void 0&&(Ne=Ne[De],Array.isArray(Ne)&&(Ne=Ne[0])),Ne){Ee.bindFramebuffer(k.FRAMEBUFFER,Ne);try{let Ge=A.textures[Re],it=Ge.format,mt=Ge.type;A.textures.length>1&&k.readBuffer(k.COLOR_ATTACHMENT0+Re);let He=zr(Ge);if(He.__formatReadable===!1){nt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(He.__typeReadable===!1){nt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}H>=0&&H<=A.width-$&&j>=0&&j<=A.height-K&&k.readPixels(H,j,$,K,_e.convert(it),_e.convert(mt),Ae)}finally{let Ge=ce!==null?Ve.get(ce).__webglFramebuffer:null;Ee.bindFramebuffer(k.FRAMEBUFFER,Ge)}}},this.readRenderTargetPixelsAsync=async function(A,H,j,$,K,Ae,De,Re=0){if(!(A&&A.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ne=Ve.get(A).__webglFramebuffer;if(A.isWebGLCubeRenderTarget&&De!==void 0&&(Ne=Ne[De],Array.isArray(Ne)&&(Ne=Ne[0])),Ne)if(H>=0&&H<=A.width-$&&j>=0&&j<=A.height-K){Ee.bindFramebuffer(k.FRAMEBUFFER,Ne);let Ge=A.textures[Re],it=Ge.format,mt=Ge.type;A.textures.length>1&&k.readBuffer(k.COLOR_ATTACHMENT0+Re);let He=zr(Ge);if(He.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(He.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let gt=k.createBuffer();k.bindBuffer(k.PIXEL_PACK_BUFFER,gt),k.bufferData(k.PIXEL_PACK_BUFFER,Ae.byteLength,k.STREAM_READ),k.readPixels(H,j,$,K,_e.convert(it),_e.convert(mt),0),k.bindBuffer(k.PIXEL_PACK_BUFFER,null);let sn=ce!==null?Ve.get(ce).__webglFramebuffer:null;Ee.bindFramebuffer(k.FRAMEBUFFER,sn);let Nt=k.fenceSync(k.SYNC_GPU_COMMANDS_COMPLETE,0);return k.flush(),await jg(k,Nt,4),k.bindBuffer(k.PIXEL_PACK_BUFFER,gt),k.getBufferSubData(k.PIXEL_PACK_BUFFER,0,Ae),k.bindBuffer(k.PIXEL_PACK_BUFFER,null),k.deleteBuffer(gt),k.deleteSync(Nt),Ae}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(A,H=null,j=0){let $=Math.pow(2,-j),K=Math.floor(A.image.width*$),Ae=Math.floor(A.image.height*$),De=H!==null?H.x:0,Re=H!==null?H.y:0;$e.setTexture2D(A,0),k.copyTexSubImage2D(k.TEXTURE_2D,j,0,0,De,Re,K,Ae),Ee.unbindTexture()},this.copyTextureToTexture=function(A,H,j=null,$=null,K=0,Ae=0){let De,Re,Ne,Ge,it,mt,He,gt,sn,Nt=A.isCompressedTexture?A.mipmaps[Ae]:A.image;if(j!==null)De=j.max.x-j.min.x,Re=j.max.y-j.min.y,Ne=j.isBox3?j.max.z-j.min.z:1,Ge=j.min.x,it=j.min.y,mt=j.isBox3?j.min.z:0;else{let dt=Math.pow(2,-K);De=Math.floor(Nt.width*dt),Re=Math.floor(Nt.height*dt),A.isDataArrayTexture?Ne=Nt.depth:A.isData3DTexture?Ne=Math.floor(Nt.depth*dt):Ne=1,Ge=0,it=0,mt=0}$!==null?(He=$.x,gt=$.y,sn=$.z):(He=0,gt=0,sn=0);let Ut=_e.convert(H.format),En=_e.convert(H.type),Be;H.isData3DTexture?($e.setTexture3D(H,0),Be=k.TEXTURE_3D):H.isDataArrayTexture||H.isCompressedArrayTexture?($e.setTexture2DArray(H,0),Be=k.TEXTURE_2D_ARRAY):($e.setTexture2D(H,0),Be=k.TEXTURE_2D),Ee.activeTexture(k.TEXTURE0),Ee.pixelStorei(k.UNPACK_FLIP_Y_WEBGL,H.flipY),Ee.pixelStorei(k.UNPACK_PREMULTIPLY_ALPHA_WEBGL,H.premultiplyAlpha),Ee.pixelStorei(k.UNPACK_ALIGNMENT,H.unpackAlignment);let _n=Ee.getParameter(k.UNPACK_ROW_LENGTH),vt=Ee.getParameter(k.UNPACK_IMAGE_HEIGHT),ds=Ee.getParameter(k.UNPACK_SKIP_PIXELS),xn=Ee.getParameter(k.UNPACK_SKIP_ROWS),Hr=Ee.getParameter(k.UNPACK_SKIP_IMAGES);Ee.pixelStorei(k.UNPACK_ROW_LENGTH,Nt.width),Ee.pixelStorei(k.UNPACK_IMAGE_HEIGHT,Nt.height),Ee.pixelStorei(k.UNPACK_SKIP_PIXELS,Ge),Ee.pixelStorei(k.UNPACK_SKIP_ROWS,it),Ee.pixelStorei(k.UNPACK_SKIP_IMAGES,mt);let Ki=A.isDataArrayTexture||A.isData3DTexture,fs=H.isDataArrayTexture||H.isData3DTexture;if(A.isDepthTexture){let dt=Ve.get(A),an=Ve.get(H),Qn=Ve.get(dt.__renderTarget),Ft=Ve.get(an.__renderTarget);Ee.bindFramebuffer(k.READ_FRAMEBUFFER,Qn.__webglFramebuffer),Ee.bindFramebuffer(k.DRAW_FRAMEBUFFER,Ft.__webglFramebuffer);for(let yn=0;yn<Ne;yn++)Ki&&(k.framebufferTextureLayer(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,Ve.get(A).__webglTexture,K,mt+yn),k.framebufferTextureLayer(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,Ve.get(H).__webglTexture,Ae,sn+yn)),k.blitFramebuffer(Ge,it,Ge+De,it+Re,He,gt,He+De,gt+Re,k.DEPTH_BUFFER_BIT,k.NEAREST);Ee.bindFramebuffer(k.READ_FRAMEBUFFER,null),Ee.bindFramebuffer(k.DRAW_FRAMEBUFFER,null)}else if(K!==0||A.isRenderTargetTexture||Ve.has(A)){let dt=Ve.get(A),an=Ve.get(H);Ee.bindFramebuffer(k.READ_FRAMEBUFFER,N),Ee.bindFramebuffer(k.DRAW_FRAMEBUFFER,V);for(let Qn=0;Qn<Ne;Qn++)Ki?k.framebufferTextureLayer(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,dt.__webglTexture,K,mt+Qn):k.framebufferTexture2D(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,dt.__webglTexture,K),fs?k.framebufferTextureLayer(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,an.__webglTexture,Ae,sn+Qn):k.framebufferTexture2D(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,an.__webglTexture,Ae),K!==0?k.blitFramebuffer(Ge,it,Ge+De,it+Re,He,gt,He+De,gt+Re,k.COLOR_BUFFER_BIT,k.NEAREST):fs?k.copyTexSubImage3D(Be,Ae,He,gt,sn+Qn,Ge,it,De,Re):k.copyTexSubImage2D(Be,Ae,He,gt,Ge,it,De,Re);Ee.bindFramebuffer(k.READ_FRAMEBUFFER,null),Ee.bindFramebuffer(k.DRAW_FRAMEBUFFER,null)}else fs?A.isDataTexture||A.isData3DTexture?k.texSubImage3D(Be,Ae,He,gt,sn,De,Re,Ne,Ut,En,Nt.data):H.isCompressedArrayTexture?k.compressedTexSubImage3D(Be,Ae,He,gt,sn,De,Re,Ne,Ut,Nt.data):k.texSubImage3D(Be,Ae,He,gt,sn,De,Re,Ne,Ut,En,Nt):A.isDataTexture?k.texSubImage2D(k.TEXTURE_2D,Ae,He,gt,De,Re,Ut,En,Nt.data):A.isCompressedTexture?k.compressedTexSubImage2D(k.TEXTURE_2D,Ae,He,gt,Nt.width,Nt.height,Ut,Nt.data):k.texSubImage2D(k.TEXTURE_2D,Ae,He,gt,De,Re,Ut,En,Nt);Ee.pixelStorei(k.UNPACK_ROW_LENGTH,_n),Ee.pixelStorei(k.UNPACK_IMAGE_HEIGHT,vt),Ee.pixelStorei(k.UNPACK_SKIP_PIXELS,ds),Ee.pixelStorei(k.UNPACK_SKIP_ROWS,xn),Ee.pixelStorei(k.UNPACK_SKIP_IMAGES,Hr),Ae===0&&H.generateMipmaps===!0&&H.mipmapsAutoUpdate===!0&&k.generateMipmap(Be),Ee.unbindTexture()},this.initRenderTarget=function(A){Ve.get(A).__webglFramebuffer===void 0&&$e.setupRenderTarget(A)},this.initTexture=function(A){A.isCubeTexture?$e.setTextureCube(A,0):A.isData3DTexture?$e.setTexture3D(A,0):A.isDataArrayTexture||A.isCompressedArrayTexture?$e.setTexture2DArray(A,0):$e.setTexture2D(A,0),Ee.unbindTexture()},this.resetState=function(){Z=0,G=0,ce=null,Ee.reset(),Se.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Ai}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=Mt._getDrawingBufferColorSpace(e),t.unpackColorSpace=Mt._getUnpackColorSpace()}};function k0(i,e=!1){let t=i[0].index!==null,n=new Set(Object.keys(i[0].attributes)),s=new Set(Object.keys(i[0].morphAttributes)),r={},o={},a=i[0].morphTargetsRelative,l=new Pt;l.morphTargetsRelative=a;let c=0;for(let h=0;h<i.length;++h){let u=i[h],d=0,f=0;if(t!==(u.index!==null))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". All geometries must have compatible attributes; make sure index attribute exists among all geometries, or in none of them."),null;for(let p in u.attributes){if(!n.has(p))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+'. All geometries must have compatible attributes; make sure "'+p+'" attribute exists among all geometries, or in none of them.'),null;r[p]===void 0&&(r[p]=[]),r[p].push(u.attributes[p]),d++}if(d!==n.size)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". Make sure all geometries have the same number of attributes."),null;if(a!==u.morphTargetsRelative)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". .morphTargetsRelative must be consistent throughout all geometries."),null;for(let p in u.morphAttributes){if(!s.has(p))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+".  .morphAttributes must be consistent throughout all geometries."),null;if(u.morphAttributes[p].length!==i[0].morphAttributes[p].length)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+'. All geometries must have the same number of morph targets for the "'+p+'" morph attribute.'),null;o[p]===void 0&&(o[p]=[]),o[p].push(u.morphAttributes[p]),f++}if(f!==s.size)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". Make sure all geometries have the same number of morph attributes."),null;if(e){let p;if(t)p=u.index.count;else if(u.attributes.position!==void 0)p=u.attributes.position.count;else return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". The geometry must have either an index or a position attribute"),null;l.addGroup(c,p,h),c+=p}}if(t){let h=0,u=[];for(let d=0;d<i.length;++d){let f=i[d].index;for(let p=0;p<f.count;++p)u.push(f.getX(p)+h);h+=i[d].attributes.position.count}l.setIndex(u)}for(let h in r){let u=B0(r[h]);if(!u)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+h+" attribute."),null;l.setAttribute(h,u)}for(let h in o){let u=o[h][0].length;if(u!==0){l.morphAttributes=l.morphAttributes||{},l.morphAttributes[h]=[];for(let d=0;d<u;++d){let f=[];for(let v=0;v<o[h].length;++v)f.push(o[h][v][d]);let p=B0(f);if(!p)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+h+" morphAttribute."),null;l.morphAttributes[h].push(p)}}}return l}function B0(i){let e,t,n,s=-1,r=0;for(let c=0;c<i.length;++c){let h=i[c];if(e===void 0&&(e=h.array.constructor),e!==h.array.constructor)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.array must be of consistent array types across matching attributes."),null;if(t===void 0&&(t=h.itemSize),t!==h.itemSize)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.itemSize must be consistent across matching attributes."),null;if(n===void 0&&(n=h.normalized),n!==h.normalized)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.normalized must be consistent across matching attributes."),null;if(s===-1&&(s=h.gpuType),s!==h.gpuType)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.gpuType must be consistent across matching attributes."),null;r+=h.count*t}let o=new e(r),a=new en(o,t,n),l=0;for(let c=0;c<i.length;++c){let h=i[c];if(h.isInterleavedBufferAttribute){let u=l/t;for(let d=0,f=h.count;d<f;d++)for(let p=0;p<t;p++){let v=h.getComponent(d,p);a.setComponent(d+u,p,v)}}else o.set(h.array,l);l+=h.count*t}return s!==void 0&&(a.gpuType=s),a}var H0=i=>Uint8Array.from(atob(i),e=>e.charCodeAt(0)).buffer,z0=i=>new Float32Array(H0(i)),pf={sag:6e-4,least:10,most:40,faces:4e4,plain:!1},G0={sag:.004,least:6,most:12,faces:1e3,plain:!0},mf=(i,e,t,n)=>{let s=[1/0,1/0,1/0],r=[-1/0,-1/0,-1/0];i.forEach((C,M)=>{s[M%3]=Math.min(s[M%3],C),r[M%3]=Math.max(r[M%3],C)});let o=r.map((C,M)=>Math.max(C-s[M],1e-6)),[a,l,c]=o,h=Math.sqrt(2*(a*l+l*c+c*a)*2/t),u=new Map,d=[],f=[],p=[],v=new Map,g=C=>{if(!n)return 0;let M=(Math.round(1e3*n[C])*1024+Math.round(1e3*n[C+1]))*1024+Math.round(1e3*n[C+2]),x=v.get(M);return x===void 0&&v.set(M,x=v.size),x},m=o.map(C=>Math.floor(C/h)+1),_=new Uint32Array(i.length/3);for(let C=0,M=0;M<i.length;C++,M+=3){let x=Math.floor((i[M]-s[0])/h),w=Math.floor((i[M+1]-s[1])/h),O=Math.floor((i[M+2]-s[2])/h),P=((g(M)*m[2]+O)*m[1]+w)*m[0]+x,D=u.get(P);D===void 0&&(D=u.size,u.set(P,D),d.push(0,0,0),f.push(0),n&&p.push(n[M],n[M+1],n[M+2]));for(let z=0;z<3;z++)d[3*D+z]+=i[M+z];f[D]+=1,_[C]=D}let E=[];for(let C=0;C<e.length;C+=3){let[M,x,w]=[_[e[C]],_[e[C+1]],_[e[C+2]]];M!==x&&x!==w&&w!==M&&E.push(M,x,w)}let b=new Pt;return b.setAttribute("position",new en(Float32Array.from(d,(C,M)=>C/f[Math.floor(M/3)]),3)),n&&b.setAttribute("color",new en(Float32Array.from(p),3)),b.setIndex(E),b.computeVertexNormals(),b},Th=class{constructor(e,t,n,s=pf){this.drawn=e;this.fineness=s;this.pictures=e.pictures.map(r=>{let o=new Zn(new Image);Object.assign(o,{wrapS:wr,wrapT:wr,colorSpace:Sn,anisotropy:t});let a=o.image;return a.onload=()=>{o.needsUpdate=!0,n()},a.src=r,o})}drawn;fineness;known=new Map;looks=new Map;pictures;joined=new Map;parts(e){let t=new Map;for(let r of e){let o=r.colour[3]<1||r.picture!==void 0||r.kind==="hfield"||r.kind==="plane",a=`${r.body}|${o?r.name:Math.round(2*r.gloss)}`;t.set(a,[...t.get(a)??[],r])}let n=[...t.values()].map(r=>r.map(o=>o.name).join()).join("|"),s=this.joined.get(n);return s||this.joined.set(n,s=[...t.values()].map(r=>this.part(r))),s}part(e){let t=e[0],n=t.kind!=="plane"&&t.colour[3]===1;if(t.colour[3]<1||t.picture!==void 0||t.kind==="hfield"||t.kind==="plane"){let c=this.look(t),h=this.moved(t,!0),u=c.map,d=t.kind==="plane"&&t.colour[3]===1?new pn({map:u&&this.cheaper(u)}):void 0;return d&&(d.userData.own=c.color),{body:t.body,geometry:h,material:c,casts:n,joined:!1,plain:d}}let r=k0(e.map(c=>this.moved(c,!1))),o=Math.max(.3,1-.75*(e.reduce((c,h)=>c+h.gloss,0)/e.length)),a=`joined|${o.toFixed(1)}`,l=this.looks.get(a);return l||this.looks.set(a,l=this.painted({vertexColors:!0},o)),{body:t.body,geometry:r,material:l,casts:n,joined:!0}}cheaper(e){let t=e.image,n=e.clone();return n.minFilter=Uo,t.complete?n.needsUpdate=!0:t.addEventListener("load",()=>{n.needsUpdate=!0}),this.pictures.push(n),n}moved(e,t){let n=this.shape(e).clone(),s=new ct().fromArray(e.rotation);if(n.applyMatrix4(new wt().compose(new F().fromArray(e.position),s,new F(1,1,1))),t)return n;n.deleteAttribute("uv");let r=new Qe().setRGB(e.colour[0],e.colour[1],e.colour[2],Sn),o=new Float32Array(3*n.attributes.position.count);for(let a=0;a<o.length;a+=3)r.toArray(o,a);return n.setAttribute("color",new en(o,3)),n}dispose(){let e=[...this.joined.values()].flat().flatMap(({geometry:t,plain:n})=>n?[t,n]:[t]);for(let t of[...this.known.values(),...this.looks.values(),...this.pictures,...e])t.dispose()}shape(e){let t=[e.kind,e.size,e.mesh??"",e.repeat??""].join("|"),n=this.known.get(t);return n||this.known.set(t,n=this.made(e)),n}painted(e,t){return this.fineness.plain?new Da(e):new Er({...e,roughness:t})}look(e){let t=JSON.stringify([e.colour,e.gloss,e.picture]),n=this.looks.get(t);if(!n){let[s,r,o,a]=e.colour;n=this.painted({color:new Qe().setRGB(s,r,o,Sn),transparent:a<1,opacity:a,map:e.picture===void 0?null:this.pictures[e.picture],side:e.kind==="hfield"?Kn:rs},Math.max(.3,1-.75*e.gloss)),this.looks.set(t,n)}return n}made({kind:e,size:t,mesh:n,repeat:s}){let[r,o,a]=t,l=h=>{let{sag:u,least:d,most:f}=this.fineness;return Math.min(f,Math.max(d,2*Math.ceil(Math.PI/Math.sqrt(2*u/h)/2)))},c=Math.PI/2;switch(e){case"plane":{let h=new Rs(2*r,2*o);if(s){let u=h.attributes.position,d=h.attributes.uv;for(let f=0;f<4;f++)d.setXY(f,u.getX(f)*s[0],u.getY(f)*s[1])}return h}case"box":return new Gt(2*r,2*o,2*a);case"sphere":return new $n(r,l(r),l(r)/2).rotateX(c);case"ellipsoid":{let h=l(Math.max(r,o,a));return new $n(1,h,h/2).rotateX(c).scale(r,o,a)}case"capsule":return new Ca(r,2*o,Math.max(2,Math.floor(l(r)/5)),l(r)).rotateX(c);case"cylinder":return new hn(r,r,2*o,l(r)).rotateX(c);default:{let h=this.drawn.meshes[n??0],u=new Pt,d=z0(h.points),f=new Uint32Array(H0(h.faces));return e==="mesh"&&f.length>3*this.fineness.faces?mf(d,f,this.fineness.faces):(u.setAttribute("position",new en(d,3)),u.setAttribute("normal",new en(z0(h.normals),3)),u.setIndex(new en(f,1)),u)}}}};var zo=class{mesh;spans=[];points;normals;constructor(e,t,n=1/0,s=!1){let r=e.map(u=>({body:u.body,geometry:bE(u.geometry,n,s)})),o=r.reduce((u,d)=>u+d.geometry.attributes.position.count,0);this.points=new Float32Array(3*o),this.normals=new Float32Array(3*o);let a=new Float32Array(3*o),l=[],c=0;for(let{body:u,geometry:d}of r){let{position:f,normal:p,color:v}=d.attributes,g=c+f.count;this.points.set(f.array,3*c),this.normals.set(p.array,3*c),v&&a.set(v.array,3*c);let m=d.index?Array.from(d.index.array):Array.from({length:f.count},(_,E)=>E);for(let _ of m)l.push(c+_);this.spans.push({body:u,begin:c,end:g}),c=g}let h=new Pt;for(let u of["position","normal"])h.setAttribute(u,new en(new Float32Array(3*o),3).setUsage(Yd));h.setAttribute("color",new en(a,3)),h.setIndex(l),this.mesh=new Ce(h,t),Object.assign(this.mesh,{castShadow:!0,receiveShadow:!0,frustumCulled:!1,matrixAutoUpdate:!1}),this.mesh.raycast=()=>{}}put(e){let{position:t,normal:n}=this.mesh.geometry.attributes,s=new wt,r=new ct;for(let{body:o,begin:a,end:l}of this.spans){s.makeRotationFromQuaternion(r.fromArray(e.rotation,4*o));let[c,h,u,,d,f,p,,v,g,m]=s.elements,_=e.position[3*o],E=e.position[3*o+1],b=e.position[3*o+2];V0(this.points,t.array,a,l,c,h,u,d,f,p,v,g,m,_,E,b),V0(this.normals,n.array,a,l,c,h,u,d,f,p,v,g,m,0,0,0)}t.needsUpdate=n.needsUpdate=!0}dispose(){this.mesh.geometry.dispose()}},bE=(i,e,t)=>{let{position:n,color:s}=i.attributes,r=i.index?.array??Uint32Array.from({length:n.count},(o,a)=>a);return r.length<=3*e?i:mf(n.array,Uint32Array.from(r),e,t?void 0:s?.array)},V0=(i,e,t,n,s,r,o,a,l,c,h,u,d,f,p,v)=>{for(let g=3*t;g<3*n;g+=3){let m=i[g],_=i[g+1],E=i[g+2];e[g]=s*m+a*_+h*E+f,e[g+1]=r*m+l*_+u*E+p,e[g+2]=o*m+c*_+d*E+v}};var ME=90,SE=240,gf=1,wE=new ct,Ah=(i,e,t=.05)=>{let n=[new pn({colorWrite:!1,transparent:!0}),new Er({color:i,transparent:!0,opacity:e,depthWrite:!1,roughness:.9})];for(let s of n)s.onBeforeCompile=r=>{r.vertexShader=r.vertexShader.replace("#include <project_vertex>",`#include <project_vertex>
      vec4 behind = projectionMatrix * vec4(mvPosition.xyz + ${t.toFixed(3)} * normalize(mvPosition.xyz), 1.0);
      gl_Position.z = behind.z / behind.w * gl_Position.w;`)};return n},or=class{root=new Rn;groups;planes=[];merged=null;outline=null;rough=null;constructor(e,t,n,s,r=!1){this.groups=e.map((l,c)=>Object.assign(new Rn,{name:l,userData:{body:c}}));let o=n.parts(t),a=r?o.filter(l=>l.joined):[];a.length&&(this.merged=new zo(a,a[0].material),this.outline=new zo(a,a[0].material,ME,!0),this.rough=new zo(a,a[0].material,SE),this.root.add(this.merged.mesh,this.rough.mesh),this.isRough=!1);for(let l of o)(s??[l.material]).forEach((c,h)=>{let u=new Ce(l.geometry,c);s&&(u.renderOrder=1+h),u.castShadow=!s&&l.casts,u.receiveShadow=!s,a.includes(l)&&u.layers.set(gf),l.plain&&this.planes.push({mesh:u,part:l}),this.groups[l.body].add(u)});this.root.add(...this.groups)}dispose(){this.root.removeFromParent(),this.merged?.dispose(),this.outline?.dispose(),this.rough?.dispose()}set isRough(e){this.merged&&(this.merged.mesh.visible=!e),this.rough&&(this.rough.mesh.visible=e)}put(e){this.groups.forEach((t,n)=>{t.position.fromArray(e.position,3*n),t.quaternion.fromArray(e.rotation,4*n)});for(let t of[this.merged,this.rough])t?.mesh.visible&&t.put(e);this.outline?.put(e)}},Rh=(i,e,t,n)=>{let s=new ct;for(let r=0;r<n.position.length;r++)n.position[r]=i.position[r]+t*(e.position[r]-i.position[r]);for(let r=0;r<n.rotation.length;r+=4)wE.fromArray(i.rotation,r).slerp(s.fromArray(e.rotation,r),t).toArray(n.rotation,r)};var Ch=class{constructor(e,t,n,s,r,o,a,l){this.first=e;this.last=t;this.rate=n;this.count=s;this.bodies=r;this.position=o;this.rotation=a;this.centre=l;this.out={position:new Float32Array(3*r),rotation:new Float32Array(4*r)}}first;last;rate;count;bodies;position;rotation;centre;out;timeOf(e){return e>=this.count-1?this.last:this.first+e/this.rate}found(e){let t=Math.min(Math.max(e,this.first),this.last),n=Math.min(Math.floor((t-this.first)*this.rate+1e-9),this.count-2);if(n<0)return[0,0];let s=this.timeOf(n),r=this.timeOf(n+1);return[n,r>s?Math.min(1,(t-s)/(r-s)):0]}at(e){let[t,n]=this.found(e),s=3*this.bodies,r=4*this.bodies,o=Math.min(t+1,this.count-1);return Rh({position:this.position.subarray(t*s,(t+1)*s),rotation:this.rotation.subarray(t*r,(t+1)*r)},{position:this.position.subarray(o*s,(o+1)*s),rotation:this.rotation.subarray(o*r,(o+1)*r)},n,this.out),this.out}centreAt(e){let[t,n]=this.found(e),s=Math.min(t+1,this.count-1),r=this.centre;return[0,1,2].map(o=>r[3*t+o]+n*(r[3*s+o]-r[3*t+o]))}get extent(){let e=0;for(let t=0;t<2;t++){let n=1/0,s=-1/0;for(let r=t;r<this.centre.length;r+=3)n=Math.min(n,this.centre[r]),s=Math.max(s,this.centre[r]);e=Math.max(e,s-n)}return e}};var _f=class{document=null;loaded=null;stage=null;now=null;raw=null;snapshot=null;course=null;violations=[];kinds=[];status={state:"loading",go:!0};time=0;playing=!1;speed=1;loop=!0;follow=!0;which="after";ghosts=!1;trails=!1;partial=!1;frames=0;keys=new Set;bar=null;joint=null;obstacle=null;ears=new Map;on(e,t){for(let n of[e].flat())this.ears.set(n,[...this.ears.get(n)??[],t])}tell(e){for(let t of this.ears.get(e)??[])t()}get first(){return this.now?.first??this.document?.keys[0]?.time??0}get last(){return this.now?.last??this.document?.keys.at(-1)?.time??1}get fps(){return this.document?.fps??30}get here(){let e=this.document?.keys.findIndex(t=>Math.abs(t.time-this.time)<1e-4)??-1;return e<0?null:e}get limb(){let{stage:e}=this,t=e?.limbs.find(s=>this.joint!==null&&s.joints.includes(this.joint));if(!e||!t)return null;let n=new Set(e.joints.filter(s=>t.joints.includes(s.name)).map(s=>s.body));return{joints:t.joints,hands:e.sites.filter(s=>n.has(s.body)).map(s=>s.name),bodies:n}}seek(e){this.time=Math.min(Math.max(e,this.first),this.last),this.tell("time")}select(e){this.keys=new Set(e),this.bar=null,this.tell("selection")}},R=new _f;var EE=new URLSearchParams(location.search).get("token")??"",Nr=new Map,Lh=null,Ph=0,Ih=250,TE=new Set(["edit","pin","free","rest","mirror","copy"]),AE=sessionStorage["dynsplines-tab"]??=String(Math.random()),RE=4409,CE=new Set(["grip","drag","turn"]),W0=0,xf=0,X0=()=>Nr.size>0,q0=()=>Nr.has(W0),ai=(i,e={})=>new Promise(t=>{if(!Lh||Lh.readyState!==WebSocket.OPEN){t({ok:!1,words:"no connection to the studio; try again"});return}Ph+=1,Nr.set(Ph,t),CE.has(i)||(W0=Ph,xf=performance.now());let n=TE.has(i)?{revision:R.document?.revision}:{};Lh.send(JSON.stringify({do:i,id:Ph,...n,...e},(s,r)=>Number.isNaN(r)?"NaN":r))}),xt=async(i,e={})=>{let t=await ai(i,e);return t.ok?t.words&&Xn(t.words):Xn(t.words??"the request failed","wrong"),t},li=(i,e)=>xt("edit",{name:i,...e}),Vn=(i,e,t=R.document?.revision)=>li("change",{at:i,entries:e,revision:t}),ar=({kind:i,index:e})=>i==="step"?["scene",i]:["scene",i,e],PE=i=>{let e=new DataView(i).getUint32(0,!0),t=JSON.parse(new TextDecoder().decode(new Uint8Array(i,4,e))),{count:n,bodies:s}=t,r=4+e,o=l=>{let c=new Float32Array(i,r,l);return r+=4*l,c},a=new Ch(t.first,t.last,t.rate,n,s,o(3*n*s),o(4*n*s),o(3*n));t.kind==="raw"?R.raw=a:(R.now=a,R.course=t,R.frames+=1),R.tell("path")},IE={stage:i=>{R.stage=i.stage,R.tell("stage")},document:i=>{let e=R.document,t=i,n=(...s)=>s.some(r=>e?.[r].length!==t[r].length);R.document=t,n("keys")&&(R.keys=new Set),n("contacts","grasps")&&(R.bar=null),R.obstacle&&n("obstacles")&&(R.obstacle=null,R.tell("joint")),R.tell("document")},loaded:i=>{R.loaded=i,R.tell("loaded")},settled:i=>{R.violations=i.violations,R.tell("settled")},status:i=>{R.status=i,R.tell("status")},kinds:i=>{R.kinds=i.kinds,R.tell("kinds")},curves:i=>{Ns=i.curves,R.tell("curves")},task:i=>{Dh=i.words===null?null:`${i.what}: ${i.words}`,R.tell("task")},offer:i=>{Nh=i.words,R.tell("offer")},note:i=>Xn(i.words,"note"),refused:i=>Xn(i.words,"wrong"),gone:i=>Xn(i.words,"wrong"),answer:i=>{Nr.get(i.id)?.(i),Nr.delete(i.id)}},Ns=null,Dh=null,Nh=null,Dr="lost",ja=(i=!1)=>{let e=new WebSocket(`ws${location.protocol==="https:"?"s":""}://${location.host}/line?token=${encodeURIComponent(EE)}&tab=${AE}${i?"&take":""}`);e.binaryType="arraybuffer",Lh=e,e.onopen=()=>{Dr="open",Ih=250,R.tell("line")},e.onmessage=({data:t})=>{if(t instanceof ArrayBuffer){PE(t);return}let n=JSON.parse(t);IE[n.is]?.(n)},e.onclose=({code:t})=>{Dr=t===RE?"elsewhere":"lost";for(let n of Nr.values())n({ok:!1,words:"connection to the studio lost; check whether the change was applied"});Nr.clear(),R.tell("line"),Dr!=="elsewhere"&&(window.setTimeout(ja,Ih),Ih=Math.min(2*Ih,4e3))}};var Uh=188,Qa=16,LE=6,DE=[.001,.002,.005,.01,.02,.05,.1,.2,.5,1,2,5,10,30,60],Fh=class{box=Me("timeline");head=ae("div",{class:"playhead","aria-hidden":"true"});rows=ae("div",{class:"rows"});ruler=ae("div",{class:"ruler"});frames=ae("div",{class:"frames"});band=ae("div",{class:"band",hidden:!0});begin=0;end=1;fitted="";unfolded=!1;drag=null;preview=new Map;redraw=0;wide=0;ticked="";constructor(){this.box.append(this.ruler,this.rows,this.band,this.head),R.on(["document","loaded","selection","stage","joint"],()=>this.draw());let e="";R.on("path",()=>{let t=`${R.first}|${R.last}`;t!==e?this.draw():this.ticks(),e=t}),R.on("time",()=>this.point()),new ResizeObserver(()=>{this.wide=0,this.draw()}).observe(this.box),this.box.addEventListener("wheel",t=>this.wheel(t),{passive:!1}),this.box.addEventListener("pointerdown",t=>this.down(t)),window.addEventListener("pointermove",t=>this.drag?.move(this.timeAt(t),t)),window.addEventListener("pointerup",t=>{let{drag:n}=this;this.drag=null,n?.up(this.timeAt(t),t)})}get width(){return this.wide||=this.box.clientWidth,Math.max(50,this.wide-Uh-2*Qa)}x(e){return Uh+Qa+(e-this.begin)/(this.end-this.begin)*this.width}timeAt(e){let t=this.box.getBoundingClientRect().left;return this.begin+(e.clientX-t-Uh-Qa)/this.width*(this.end-this.begin)}snapped(e,t,n=!1){if(t.altKey)return Math.round(e*1e4)/1e4;let s=LE/this.width*(this.end-this.begin),o=[R.time,...n?(R.document?.keys??[]).map(a=>a.time):[]].filter(a=>Math.abs(a-e)<s).sort((a,l)=>Math.abs(a-e)-Math.abs(l-e))[0];return o!==void 0?o:Math.round(Math.round(e*R.fps)/R.fps*1e4)/1e4}fit(){this.begin=R.first,this.end=Math.max(R.last,R.first+.01),this.draw()}zoom(e,t=R.time){let n=Math.min(Math.max((this.end-this.begin)*e,.02),3*(R.last-R.first)+1),s=(t-this.begin)/(this.end-this.begin);this.begin=t-s*n,this.end=this.begin+n,this.draw()}wheel(e){if(e.ctrlKey||e.metaKey)e.preventDefault(),this.zoom(Math.exp(e.deltaY*.002),this.timeAt(e));else if(e.shiftKey||Math.abs(e.deltaX)>Math.abs(e.deltaY)){e.preventDefault();let t=(e.deltaX||e.deltaY)/this.width*(this.end-this.begin);this.begin+=t,this.end+=t,this.draw()}}point(){this.head.style.transform=`translateX(${this.x(R.time)}px)`;let e=R.here;for(let t of this.rows.querySelectorAll(".keys .diamond"))t.classList.toggle("here",Number(t.dataset.key)===e);this.ruler.setAttribute("aria-valuenow",R.time.toFixed(3)),this.ruler.setAttribute("aria-valuetext",`${R.time.toFixed(2)} seconds`)}draw(){this.redraw||(this.redraw=requestAnimationFrame(()=>{this.redraw=0,this.drawn()}))}drawn(){let{document:e}=R;if(!e)return;let t=`${e.name}|${R.first}|${R.last}`;t!==this.fitted&&(this.fitted=t,this.begin=R.first,this.end=Math.max(R.last,R.first+.01));let n=window.document.activeElement?.dataset.id;this.rows.replaceChildren(this.keysRow(),...this.unfolded?this.limbRows():[],...this.barRows()),this.drawRuler(),this.point(),R.tell("zoom"),n&&this.rows.querySelector(`[data-id="${CSS.escape(n)}"]`)?.focus()}drawRuler(){let e=(this.end-this.begin)/this.width*70,t=DE.find(s=>s>=e)??60,n=[];for(let s=Math.ceil((this.begin-1e-9)/t);s*t<=this.end+1e-9;s++){let r=ae("span",{class:"tick",text:(s*t).toFixed(t<.01?3:t<1?2:0)});r.style.left=`${this.x(s*t)}px`,n.push(r)}this.ruler.replaceChildren(ae("span",{class:"label",text:"s"}),...n),Object.entries({role:"slider",tabindex:"0","aria-label":"time","aria-valuemin":R.first.toFixed(3),"aria-valuemax":R.last.toFixed(3)}).forEach(([s,r])=>this.ruler.setAttribute(s,r))}label(e,t){let n=ae("span",{class:"label",title:e});return t&&n.append(t),n.append(ae("span",{text:e})),n}keysRow(){let e=ae("button",{type:"button",class:"fold","aria-expanded":String(this.unfolded),"aria-label":"limbs",title:"limbs (U)",onclick:()=>{this.unfolded=!this.unfolded,this.draw()}},this.unfolded?"▾":"▸"),t=ae("div",{class:"row keys"},this.label("keyframes",e));return t.append(this.frames),this.ticks(),R.document.keys.forEach((n,s)=>{let r=R.loaded?.keys[s],o=r?!r.fixed.every(Boolean):!1,a=this.preview.get(s)??n.time;a<this.begin-1e-6||a>this.end+1e-6||t.append(this.diamond(s,a,o,`keyframe ${s+1} at ${n.time.toFixed(3)} s${o?", partial":""}`))}),t}ticks(){let e=(R.course?.frames??[]).filter(n=>n>=this.begin&&n<=this.end),t=`${e}|${this.begin}|${this.end}|${this.width}`;t!==this.ticked&&(this.ticked=t,this.frames.replaceChildren(...e.map(n=>{let s=ae("i",{class:"frame"});return s.style.left=`${this.x(n)}px`,s})))}diamond(e,t,n,s){let r=R.keys.has(e),o=ae("button",{type:"button",class:`diamond${n?" hollow":""}${r?" selected":""}`,title:s,"aria-label":s,"aria-pressed":String(r),"data-key":e,"data-id":`key${e}`});return o.style.left=`${this.x(t)}px`,o.addEventListener("keydown",a=>{(a.key==="Enter"||a.key===" ")&&(a.preventDefault(),a.stopPropagation(),this.choose(e,a),R.seek(R.document.keys[e].time))}),o}limbRows(){let{stage:e,loaded:t,document:n}=R,s=n.revision;return!e||!t?[]:e.limbs.map(r=>{let o=ae("div",{class:"row limb"},this.label(r.name)),a=r.joints.map(l=>e.joints.find(c=>c.name===l)).filter(Boolean);return n.keys.forEach((l,c)=>{let h=t.keys[c];if(!h||l.time<this.begin||l.time>this.end)return;let u=a.map(g=>h.fixed[g.kind==="free"?g.qpos+3:g.qpos]),d=!u.every(Boolean),f=!u.some(Boolean),p=`${r.name}, keyframe ${c+1}: ${f?"free":d?"partly free":"fixed"}; Enter or double click ${f?"pins":"frees"} it`,v=ae("button",{type:"button",class:`diamond small${d?" hollow":""}${f?" none":""}`,title:p,"aria-label":p,"data-id":`limb${r.name}${c}`,ondblclick:()=>{xt(f?"pin":"free",{key:c,revision:s,joints:r.joints})}});v.addEventListener("keydown",g=>{g.key==="Enter"&&xt(f?"pin":"free",{key:c,revision:s,joints:r.joints})}),v.style.left=`${this.x(l.time)}px`,o.append(v)}),o})}barRows(){let{document:e,loaded:t,stage:n}=R,s=[...new Set([...(n?.soles??[]).map(a=>a.name),...e.contacts.map(a=>a.point)])],r=[...new Set([...R.limb?.hands??[],...e.grasps.map(a=>a.hand)])],o=s.slice(0,24).map(a=>{let l=ae("div",{class:"row bars","data-point":a},this.label(a));for(let c of t?.stances.filter(h=>h.point===a)??[])l.append(this.told(c.from,c.to,`${a}: stance inferred from keyframes`));return e.contacts.forEach((c,h)=>{c.point===a&&l.append(this.bar("contact",h,c,`contact of ${a}`))}),l});for(let a of r){let l=ae("div",{class:"row bars","data-hand":a,title:"drag here for a new grasp"},this.label(`${a} holds`));e.grasps.forEach((c,h)=>{c.hand===a&&l.append(this.bar("grasp",h,c,`${a} holds ${c.body}`))}),o.push(l)}if(t?.flights.length){let a=ae("div",{class:"row bars"},this.label("flights"));for(let[l,c]of t.flights)a.append(this.told(l,c,"flight inferred from keyframes","flight"));o.push(a)}return o}placed(e,t,n){let s=this.x(Math.max(t,this.begin)),r=this.x(Math.min(n,this.end));return e.style.left=`${s}px`,e.style.width=`${Math.max(3,r-s)}px`,e}told(e,t,n,s="stance"){return this.placed(ae("span",{class:`bar ${s}`,title:`${n}: ${e.toFixed(2)} to ${t.toFixed(2)} s`}),e,t)}bar(e,t,n,s){let r=R.bar?.kind===e&&R.bar.index===t,o=`${s}, ${n.from.toFixed(2)} to ${n.to.toFixed(2)} s`,a=ae("button",{type:"button",class:`bar ${e}${r?" selected":""}`,title:`${o}; drag it or its ends`,"aria-label":o,"data-bar":e,"data-index":t,"data-id":`${e}${t}`,"aria-pressed":String(r),onfocus:()=>{(R.bar?.index!==t||R.bar.kind!==e)&&(R.bar={kind:e,index:t},R.keys.clear(),R.tell("selection"))}});return this.placed(a,n.from,n.to)}down(e){if(e.button!==0)return;let t=e.target,n=this.timeAt(e),s=e.clientX-this.box.getBoundingClientRect().left;if(t.closest(".fold")||s<Uh)return;if(t.closest(".ruler")){R.playing=!1;let l=(c,h)=>R.seek(this.snapped(c,h,!0));l(n,e),this.drag={move:l,up:()=>{}};return}let r=t.closest(".keys .diamond"),o=t.closest("[data-bar]"),a=t.closest("[data-point], [data-hand]");r?this.grabKey(Number(r.dataset.key),n,e):o?this.grabBar(o,n,e):a?this.drawBar(a,n,e):t.closest("button")||this.boxSelect(n,e)}choose(e,t){let n=new Set(R.keys);if(t.ctrlKey||t.metaKey)n.has(e)?n.delete(e):n.add(e);else if(t.shiftKey&&n.size){let s=[...n,e];for(let r=Math.min(...s);r<=Math.max(...s);r++)n.add(r)}else n.has(e)||(n.clear(),n.add(e));R.select(n)}grabKey(e,t,n){let s=R.document.keys.map(u=>u.time),{revision:r}=R.document,o=R.keys.has(e);this.choose(e,n);let a=[...R.keys];R.playing=!1,R.seek(s[e]);let l=!1,c=n.ctrlKey&&n.altKey,h=(u,d)=>{let f=this.snapped(s[e]+u-t,d);if(c&&a.length>1){let p=Math.min(...a.map(g=>s[g])),v=Math.max(.01,(f-p)/Math.max(1e-6,s[e]-p));return new Map(a.map(g=>[g,Math.round((p+v*(s[g]-p))*1e4)/1e4]))}return new Map(a.map(p=>[p,Math.round((s[p]+f-s[e])*1e4)/1e4]))};this.drag={move:(u,d)=>{!l&&Math.abs(this.x(u)-this.x(t))<3||(l=!0,this.preview=h(u,d),this.draw())},up:(u,d)=>{if(this.preview.clear(),this.draw(),!l){o&&R.keys.size>1&&!d.shiftKey&&!d.ctrlKey&&R.select([e]);return}let f=h(u,d);li("move_keys",{moves:[...f],revision:r}).then(p=>{p.ok&&R.seek(f.get(e)??s[e])})}}}grabBar(e,t,n){let s=e.dataset.bar,r=Number(e.dataset.index),{revision:o}=R.document,a=(s==="contact"?R.document.contacts:R.document.grasps)[r],l=e.getBoundingClientRect(),c=n.clientX-l.left<7?"from":l.right-n.clientX<7?"to":"";R.bar={kind:s,index:r},R.keys.clear(),R.tell("selection");let h=(d,f)=>{if(c==="from")return[this.snapped(d,f,!0),a.to];if(c==="to")return[a.from,this.snapped(d,f,!0)];let p=this.snapped(a.from+d-t,f,!0);return[p,p+a.to-a.from]},u=!1;this.drag={move:(d,f)=>{if(!u&&Math.abs(this.x(d)-this.x(t))<3)return;u=!0;let p=this.rows.querySelector(`[data-id="${s}${r}"]`);p&&this.placed(p,...h(d,f))},up:(d,f)=>{if(!u)return;let[p,v]=h(d,f);Vn([s,r],{from:p,to:v},o).then(()=>this.draw())}}}drawBar(e,t,n){let{point:s,hand:r}=e.dataset,o=s?"contact":"grasp",a=this.snapped(t,n,!0),l=ae("span",{class:`bar ${o} new`}),c=!1;this.drag={move:(h,u)=>{if(!c&&Math.abs(this.x(h)-this.x(t))<5)return;c||this.rows.querySelector(`[data-${s?"point":"hand"}="${CSS.escape(s??r)}"]`)?.append(l),c=!0;let d=this.snapped(h,u,!0);this.placed(l,Math.min(a,d),Math.max(a,d))},up:(h,u)=>{let d=this.snapped(h,u,!0),f={from:Math.min(a,d),to:Math.max(a,d)};if(!c||d===a){l.remove(),R.select([]),R.seek(this.snapped(t,u,!0));return}if(s){l.remove(),li("add",{at:["contact"],entries:{point:s,...f}});return}this.graspable(r,f.from,u,p=>{l.remove(),p!==null&&li("add",{at:["grasp"],entries:{hand:r,body:p,...f}})})}}}graspable(e,t,n,s){let{stage:r,now:o}=R,a=r?.sites.find(m=>m.name===e);if(!r||!o||!a){s(null);return}let l=o.at(t),c=m=>r.parents[m]?c(r.parents[m]):m,h=(m,_)=>{let E=new ct().fromArray(l.rotation,4*m);return new F().fromArray(_).applyQuaternion(E).add(new F().fromArray(l.position,3*m))},u=h(a.body,a.offset),d=r.limbs.find(m=>r.joints.some(_=>_.body===a.body&&m.joints.includes(_.name))),f=r.bodies.map((m,_)=>({name:m,body:_,away:u.distanceTo(h(_,[0,0,0])),other:c(_)!==c(a.body)})).filter(({name:m,body:_})=>_&&m&&!r.still[_]&&_!==a.body&&r.joints.some(E=>E.body===_)&&!d?.joints.some(E=>r.joints.find(b=>b.name===E)?.body===_)).sort((m,_)=>Number(_.other)-Number(m.other)||m.away-_.away).slice(0,8);if(!f.length){Xn("there is no free body to grasp","note"),s(null);return}let p=ae("dialog",{class:"menu","aria-label":`body held by ${e}`}),v=null;p.append(ae("p",{class:"hint",text:`${e} holds`}),...f.map(({name:m})=>ae("button",{type:"button",text:m,onclick:()=>{v=m,p.close()}}))),p.addEventListener("close",()=>{p.remove(),s(v)}),p.addEventListener("click",m=>{m.target===p&&p.close()}),document.body.append(p),p.showModal();let g=p.getBoundingClientRect();p.style.left=`${Math.max(4,Math.min(n.clientX,innerWidth-g.width-8))}px`,p.style.top=`${Math.max(4,Math.min(n.clientY,innerHeight-g.height-8))}px`,p.querySelector("button")?.focus()}boxSelect(e,t){let n=!1,s=t.shiftKey?new Set(R.keys):new Set;this.drag={move:r=>{n||=Math.abs(this.x(r)-this.x(e))>4,this.band.hidden=!n,this.placed(this.band,Math.min(e,r),Math.max(e,r))},up:(r,o)=>{if(this.band.hidden=!0,!n){R.select(s),R.playing=!1,R.seek(this.snapped(e,o,!0));return}let[a,l]=[Math.min(e,r),Math.max(e,r)];R.document.keys.forEach((c,h)=>{c.time>=a&&c.time<=l&&s.add(h)}),R.select(s),s.size||Xn("no keyframe there","note")}}}};var Oh=["#58a6ff","#f0883e","#56d364","#ff7b9c","#bc8cff","#e3b341","#39c5cf","#a5b1c2"],Y0=14,NE=56,UE=8,Us=null,Bh="angle",el=new Set,qi=!1,Z0=()=>[R.first,R.last];var vf=()=>{qi=!qi,Me("curves").hidden=!qi,Me("show-curves").setAttribute("aria-pressed",String(qi)),ai("curves",{on:qi}),qi&&Ho()},yf=i=>getComputedStyle(document.documentElement).getPropertyValue(i).trim(),Ho=()=>{if(!qi||!Ns)return;let i=Me("plot"),e=Ns.groups.find(c=>c.name===Bh)??Ns.groups[0],t=e.series.filter(c=>!el.has(`${Bh}|${c.name}`)),n=R.which!=="after"||Me("curves-before").checked,s=[Ns.time],r=[{label:"time"}];t.forEach(c=>{let h=Oh[e.series.indexOf(c)%Oh.length];s.push(c.after),r.push({label:c.name,stroke:h,width:1.5,points:{show:!1}}),n&&c.before?.length&&(s.push(c.before),r.push({label:`${c.name}, before`,stroke:h,width:1,dash:[4,4],points:{show:!1}}))});let o=yf("--soft"),a=yf("--line"),l={stroke:o,grid:{stroke:a,width:1},ticks:{stroke:a},font:"11px system-ui"};Us?.destroy(),Us=new zn({width:Math.max(200,i.clientWidth),height:Math.max(90,i.clientHeight),series:r,padding:[10,Qa,0,0],scales:{x:{time:!1,range:()=>Z0()}},axes:[{...l,size:26},{...l,size:NE-Y0,label:e.unit,labelSize:Y0,labelFont:"11px system-ui"}],legend:{show:!1},cursor:{drag:{x:!1,y:!1}},hooks:{draw:[FE]}},s,i),Us.over.addEventListener("pointerdown",c=>{R.playing=!1;let h=f=>R.seek(Us.posToVal(f.clientX-Us.over.getBoundingClientRect().left,"x"));h(c);let u=f=>h(f),d=()=>{window.removeEventListener("pointermove",u),window.removeEventListener("pointerup",d)};window.addEventListener("pointermove",u),window.addEventListener("pointerup",d)}),OE(e)},FE=i=>{let e=i.valToPos(R.time,"x",!0),{ctx:t,bbox:n}=i;t.save(),t.strokeStyle=yf("--accent"),t.lineWidth=1.5,t.beginPath(),t.moveTo(e,n.top),t.lineTo(e,n.top+n.height),t.stroke(),t.restore()},OE=i=>{Me("curve-names").replaceChildren(...i.series.map((t,n)=>{let s=`${Bh}|${t.name}`,r=!el.has(s),o=ae("input",{type:"checkbox",checked:r,onchange:()=>{r?el.add(s):el.delete(s),Ho()}}),a=ae("i",{class:"dot"});return a.style.background=Oh[n%Oh.length],ae("label",{},o,a,t.name)}))},$0=i=>{Z0=()=>[i.begin,i.end],R.on("zoom",()=>{qi&&Us&&Us.setScale("x",{min:i.begin,max:i.end})});let e=Me("curve-group");e.addEventListener("change",()=>{Bh=e.value,Ho()}),Me("curves-before").addEventListener("change",Ho),Me("show-curves").addEventListener("click",vf);let t=!0;R.on("curves",()=>{if(t&&Ns){t=!1,e.replaceChildren(...Ns.groups.map(n=>ae("option",{value:n.name,text:n.name})));for(let n of Ns.groups)n.series.slice(UE).forEach(s=>el.add(`${n.name}|${s.name}`))}Ho()}),R.on("time",()=>{qi&&Us?.redraw(!1)}),R.on(["theme","which"],Ho),new ResizeObserver(()=>{qi&&Us?.setSize({width:Math.max(200,Me("plot").clientWidth),height:Math.max(90,Me("plot").clientHeight)})}).observe(Me("plot")),R.on("line",()=>{qi&&ai("curves",{on:!0})})};var bf=(i,...e)=>{let t=ae("dialog",{"aria-label":i});return t.append(ae("form",{method:"dialog"},ae("h2",{text:i}),...e)),t.addEventListener("close",()=>t.remove()),document.body.append(t),t.showModal(),t},Ur=(i,e)=>ae("label",{class:"line"},ae("span",{text:i}),e),Mf=(i,e,t)=>{let n=ae("button",{type:"submit",class:"main",text:e});return n.addEventListener("click",s=>{s.preventDefault(),t().then(r=>{r&&i().close()})}),ae("div",{class:"buttons end"},ae("button",{type:"button",text:"Cancel",onclick:()=>i().close()}),n)},Sf=()=>{let i=ae("input",{type:"checkbox"});return[i,ae("label",{class:"line"},i," overwrite an existing file")]},wf=()=>(R.document?.name??"clip").replace(/[^\w.-]+/g,"_"),K0=()=>{let i=ae("input",{type:"text",value:`${wf()}.toml`,"aria-label":"file name"}),[e,t]=Sf(),n=bf("Save as",Ur("name",i),t,Mf(()=>n,"Save",async()=>(await xt("save",{name:i.value,overwrite:e.checked})).ok));i.select()},BE=async()=>{let i=await ai("formats");if(!i.ok)return;let e=i.formats,t=ae("select",{"aria-label":"format"},...e.map(l=>ae("option",{value:l.name,text:`${l.name} – ${l.description}`}))),n=ae("input",{type:"text","aria-label":"file name"}),s=()=>{n.value=`${wf()}${e.find(l=>l.name===t.value)?.ending.split(/[ ,]/)[0]??""}`};t.addEventListener("change",s),s();let[r,o]=Sf(),a=bf("Export",Ur("format",t),Ur("name",n),o,Mf(()=>a,"Export",async()=>(xt("export",{to:t.value,name:n.value,overwrite:r.checked}),!0)))},kE=()=>{let i=ae("input",{type:"text",value:`${wf()}.mp4`,"aria-label":"file name of the video"}),e=ae("input",{type:"text",value:"1280x720","aria-label":"size, pixels"}),t=ae("select",{"aria-label":"camera"},...["side","left","front","three_quarter","back"].map(a=>ae("option",{value:a,text:a}))),n=ae("select",{"aria-label":"view"},ae("option",{value:"after",text:"the motion"}),ae("option",{value:"",text:"before | after"})),[s,r]=Sf(),o=bf("Render",Ur("name, .mp4 .webm .gif .png",i),Ur("size",e),Ur("camera",t),Ur("what",n),r,Mf(()=>o,"Render",async()=>(xt("render",{name:i.value,size:e.value,camera:t.value,only:n.value,overwrite:s.checked}),!0)))},J0=()=>{let i=Me("files");i.addEventListener("save-as",K0);let t=ae("div",{class:"menu",role:"menu",hidden:!0},...[["Save as …",K0],["Export …",()=>{BE()}],["Render …",kE]].map(([n,s])=>ae("button",{type:"button",role:"menuitem",text:n,onclick:()=>{t.hidden=!0,i.setAttribute("aria-expanded","false"),s()}})));i.after(t),i.addEventListener("click",()=>{t.hidden=!t.hidden,i.setAttribute("aria-expanded",String(!t.hidden)),t.hidden||t.querySelector("button").focus()}),t.addEventListener("keydown",n=>{let s=[...t.querySelectorAll("button")],r=s.indexOf(document.activeElement);n.key==="Escape"&&(t.hidden=!0,i.focus(),n.stopPropagation()),n.key==="ArrowDown"&&s[(r+1)%s.length].focus(),n.key==="ArrowUp"&&s[(r+s.length-1)%s.length].focus()}),document.addEventListener("pointerdown",n=>{!t.contains(n.target)&&n.target!==i&&!i.contains(n.target)&&(t.hidden=!0)})};var Fr=new Ps,un=new F,lr=new F,nn=new ct,j0={X:new F(1,0,0),Y:new F(0,1,0),Z:new F(0,0,1)},Ef={type:"change"},Q0={type:"mouseDown",mode:null},e_={type:"mouseUp",mode:null},t_={type:"objectChange"},Vh=class extends Tr{constructor(e,t=null){super(void 0,t);let n=new Af(this);this._root=n;let s=new Rf;this._gizmo=s,n.add(s);let r=new Cf;this._plane=r,n.add(r);let o=this;function a(E,b){let C=b;Object.defineProperty(o,E,{get:function(){return C!==void 0?C:b},set:function(M){C!==M&&(C=M,r[E]=M,s[E]=M,o.dispatchEvent({type:E+"-changed",value:M}),o.dispatchEvent(Ef))}}),o[E]=b,r[E]=b,s[E]=b}a("camera",e),a("object",void 0),a("enabled",!0),a("axis",null),a("mode","translate"),a("translationSnap",null),a("rotationSnap",null),a("scaleSnap",null),a("space","world"),a("size",1),this.viewport=null,a("dragging",!1),a("showX",!0),a("showY",!0),a("showZ",!0),a("showXY",!0),a("showYZ",!0),a("showXZ",!0),a("showXYZE",!0),a("showE",!0),a("minX",-1/0),a("maxX",1/0),a("minY",-1/0),a("maxY",1/0),a("minZ",-1/0),a("maxZ",1/0);let l=new F,c=new F,h=new ct,u=new ct,d=new F,f=new ct,p=new F,v=new F,g=new F,m=0,_=new F;a("worldPosition",l),a("worldPositionStart",c),a("worldQuaternion",h),a("worldQuaternionStart",u),a("cameraPosition",d),a("cameraQuaternion",f),a("pointStart",p),a("pointEnd",v),a("rotationAxis",g),a("rotationAngle",m),a("eye",_),this._offset=new F,this._startNorm=new F,this._endNorm=new F,this._cameraScale=new F,this._parentPosition=new F,this._parentQuaternion=new ct,this._parentQuaternionInv=new ct,this._parentScale=new F,this._worldScaleStart=new F,this._worldQuaternionInv=new ct,this._worldScale=new F,this._positionStart=new F,this._quaternionStart=new ct,this._scaleStart=new F,this._getPointer=zE.bind(this),this._onPointerDown=GE.bind(this),this._onPointerHover=HE.bind(this),this._onPointerMove=VE.bind(this),this._onPointerUp=WE.bind(this),t!==null&&this.connect(t)}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointermove",this._onPointerHover),this.domElement.addEventListener("pointerup",this._onPointerUp),this.domElement.style.touchAction="none"}disconnect(){this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.removeEventListener("pointermove",this._onPointerHover),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.domElement.removeEventListener("pointerup",this._onPointerUp),this.domElement.style.touchAction=""}getHelper(){return this._root}pointerHover(e){if(this.object===void 0||this.dragging===!0)return;e!==null&&Fr.setFromCamera(e,this.camera);let t=Tf(this._gizmo.picker[this.mode],Fr);t?this.axis=t.object.name:this.axis=null}pointerDown(e){if(!(this.object===void 0||this.dragging===!0||e!=null&&e.button!==0)&&this.axis!==null){e!==null&&Fr.setFromCamera(e,this.camera);let t=Tf(this._plane,Fr,!0);t&&(this.object.updateMatrixWorld(),this.object.parent.updateMatrixWorld(),this._positionStart.copy(this.object.position),this._quaternionStart.copy(this.object.quaternion),this._scaleStart.copy(this.object.scale),this.object.matrixWorld.decompose(this.worldPositionStart,this.worldQuaternionStart,this._worldScaleStart),this.pointStart.copy(t.point).sub(this.worldPositionStart)),this.dragging=!0,Q0.mode=this.mode,this.dispatchEvent(Q0)}}pointerMove(e){let t=this.axis,n=this.mode,s=this.object,r=this.space;if(n==="scale"?r="local":(t==="E"||t==="XYZE"||t==="XYZ")&&(r="world"),s===void 0||t===null||this.dragging===!1||e!==null&&e.button!==-1)return;e!==null&&Fr.setFromCamera(e,this.camera);let o=Tf(this._plane,Fr,!0);if(o){if(this.pointEnd.copy(o.point).sub(this.worldPositionStart),n==="translate")this._offset.copy(this.pointEnd).sub(this.pointStart),r==="local"&&t!=="XYZ"&&this._offset.applyQuaternion(this._worldQuaternionInv),t.indexOf("X")===-1&&(this._offset.x=0),t.indexOf("Y")===-1&&(this._offset.y=0),t.indexOf("Z")===-1&&(this._offset.z=0),r==="local"&&t!=="XYZ"?this._offset.applyQuaternion(this._quaternionStart).divide(this._parentScale):this._offset.applyQuaternion(this._parentQuaternionInv).divide(this._parentScale),s.position.copy(this._offset).add(this._positionStart),this.translationSnap&&(r==="local"&&(s.position.applyQuaternion(nn.copy(this._quaternionStart).invert()),t.search("X")!==-1&&(s.position.x=Math.round(s.position.x/this.translationSnap)*this.translationSnap),t.search("Y")!==-1&&(s.position.y=Math.round(s.position.y/this.translationSnap)*this.translationSnap),t.search("Z")!==-1&&(s.position.z=Math.round(s.position.z/this.translationSnap)*this.translationSnap),s.position.applyQuaternion(this._quaternionStart)),r==="world"&&(s.getWorldPosition(un),t.search("X")!==-1&&(un.x=Math.round(un.x/this.translationSnap)*this.translationSnap),t.search("Y")!==-1&&(un.y=Math.round(un.y/this.translationSnap)*this.translationSnap),t.search("Z")!==-1&&(un.z=Math.round(un.z/this.translationSnap)*this.translationSnap),s.position.copy(s.parent.worldToLocal(un)))),s.position.x=Math.max(this.minX,Math.min(this.maxX,s.position.x)),s.position.y=Math.max(this.minY,Math.min(this.maxY,s.position.y)),s.position.z=Math.max(this.minZ,Math.min(this.maxZ,s.position.z));else if(n==="scale"){if(t.search("XYZ")!==-1){let a=this.pointEnd.length()/this.pointStart.length();this.pointEnd.dot(this.pointStart)<0&&(a*=-1),lr.set(a,a,a)}else un.copy(this.pointStart),lr.copy(this.pointEnd),un.applyQuaternion(this._worldQuaternionInv),lr.applyQuaternion(this._worldQuaternionInv),lr.divide(un),t.search("X")===-1&&(lr.x=1),t.search("Y")===-1&&(lr.y=1),t.search("Z")===-1&&(lr.z=1);s.scale.copy(this._scaleStart).multiply(lr),this.scaleSnap&&(t.search("X")!==-1&&(s.scale.x=Math.round(s.scale.x/this.scaleSnap)*this.scaleSnap||this.scaleSnap),t.search("Y")!==-1&&(s.scale.y=Math.round(s.scale.y/this.scaleSnap)*this.scaleSnap||this.scaleSnap),t.search("Z")!==-1&&(s.scale.z=Math.round(s.scale.z/this.scaleSnap)*this.scaleSnap||this.scaleSnap))}else if(n==="rotate"){this._offset.copy(this.pointEnd).sub(this.pointStart);let a=20/this.worldPosition.distanceTo(un.setFromMatrixPosition(this.camera.matrixWorld)),l=!1;t==="XYZE"?(this.rotationAxis.copy(this._offset).cross(this.eye).normalize(),this.rotationAngle=this._offset.dot(un.copy(this.rotationAxis).cross(this.eye))*a):(t==="X"||t==="Y"||t==="Z")&&(this.rotationAxis.copy(j0[t]),un.copy(j0[t]),r==="local"&&un.applyQuaternion(this.worldQuaternion),un.cross(this.eye),un.length()===0?l=!0:this.rotationAngle=this._offset.dot(un.normalize())*a),(t==="E"||l)&&(this.rotationAxis.copy(this.eye),this.rotationAngle=this.pointEnd.angleTo(this.pointStart),this._startNorm.copy(this.pointStart).normalize(),this._endNorm.copy(this.pointEnd).normalize(),this.rotationAngle*=this._endNorm.cross(this._startNorm).dot(this.eye)<0?1:-1),this.rotationSnap&&(this.rotationAngle=Math.round(this.rotationAngle/this.rotationSnap)*this.rotationSnap),r==="local"&&t!=="E"&&t!=="XYZE"?(s.quaternion.copy(this._quaternionStart),s.quaternion.multiply(nn.setFromAxisAngle(this.rotationAxis,this.rotationAngle)).normalize()):(this.rotationAxis.applyQuaternion(this._parentQuaternionInv),s.quaternion.copy(nn.setFromAxisAngle(this.rotationAxis,this.rotationAngle)),s.quaternion.multiply(this._quaternionStart).normalize())}this.dispatchEvent(Ef),this.dispatchEvent(t_)}}pointerUp(e){e!==null&&e.button!==0||(this.dragging&&this.axis!==null&&(e_.mode=this.mode,this.dispatchEvent(e_)),this.dragging=!1,this.axis=null)}dispose(){this.disconnect(),this._root.dispose()}attach(e){return this.object=e,this._root.visible=!0,this}detach(){return this.object=void 0,this.axis=null,this._root.visible=!1,this}reset(){this.enabled&&this.dragging&&(this.object.position.copy(this._positionStart),this.object.quaternion.copy(this._quaternionStart),this.object.scale.copy(this._scaleStart),this.dispatchEvent(Ef),this.dispatchEvent(t_),this.pointStart.copy(this.pointEnd))}getRaycaster(){return Fr}getMode(){return this.mode}setMode(e){this.mode=e}setTranslationSnap(e){this.translationSnap=e}setRotationSnap(e){this.rotationSnap=e}setScaleSnap(e){this.scaleSnap=e}setSize(e){this.size=e}setSpace(e){this.space=e}setColors(e,t,n,s){let r=this._gizmo.materialLib;r.xAxis.color.set(e),r.yAxis.color.set(t),r.zAxis.color.set(n),r.active.color.set(s),r.xAxisTransparent.color.set(e),r.yAxisTransparent.color.set(t),r.zAxisTransparent.color.set(n),r.activeTransparent.color.set(s),r.xAxis._color&&r.xAxis._color.set(e),r.yAxis._color&&r.yAxis._color.set(t),r.zAxis._color&&r.zAxis._color.set(n),r.active._color&&r.active._color.set(s),r.xAxisTransparent._color&&r.xAxisTransparent._color.set(e),r.yAxisTransparent._color&&r.yAxisTransparent._color.set(t),r.zAxisTransparent._color&&r.zAxisTransparent._color.set(n),r.activeTransparent._color&&r.activeTransparent._color.set(s)}};function zE(i){if(this.domElement.ownerDocument.pointerLockElement)return{x:0,y:0,button:i.button};{let e=this.domElement.getBoundingClientRect(),t=this.viewport,n,s,r,o;return t!==null?(n=t.x,s=e.height-t.y-t.w,r=t.z,o=t.w):(n=0,s=0,r=e.width,o=e.height),{x:(i.clientX-e.left-n)/r*2-1,y:-(i.clientY-e.top-s)/o*2+1,button:i.button}}}function HE(i){if(this.enabled)switch(i.pointerType){case"mouse":case"pen":this.pointerHover(this._getPointer(i));break}}function GE(i){this.enabled&&(document.pointerLockElement||this.domElement.setPointerCapture(i.pointerId),this.domElement.addEventListener("pointermove",this._onPointerMove),this.pointerHover(this._getPointer(i)),this.pointerDown(this._getPointer(i)))}function VE(i){this.enabled&&this.pointerMove(this._getPointer(i))}function WE(i){this.enabled&&(this.domElement.releasePointerCapture(i.pointerId),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.pointerUp(this._getPointer(i)))}function Tf(i,e,t){let n=e.intersectObject(i,!0);for(let s=0;s<n.length;s++)if(n[s].object.visible||t)return n[s];return!1}var kh=new Ri,Vt=new F(0,1,0),n_=new F(0,0,0),i_=new wt,zh=new ct,Gh=new ct,cs=new F,Wh=new wt,il=new F(1,0,0),Or=new F(0,1,0),sl=new F(0,0,1),Hh=new F,tl=new F,nl=new F,Af=class extends tn{constructor(e){super(),this.isTransformControlsRoot=!0,this.controls=e,this.visible=!1}updateMatrixWorld(e){let t=this.controls;t.object!==void 0&&(t.object.updateMatrixWorld(),t.object.parent===null?console.error("TransformControls: The attached 3D object must be a part of the scene graph."):t.object.parent.matrixWorld.decompose(t._parentPosition,t._parentQuaternion,t._parentScale),t.object.matrixWorld.decompose(t.worldPosition,t.worldQuaternion,t._worldScale),t._parentQuaternionInv.copy(t._parentQuaternion).invert(),t._worldQuaternionInv.copy(t.worldQuaternion).invert()),t.camera.updateMatrixWorld(),t.camera.matrixWorld.decompose(t.cameraPosition,t.cameraQuaternion,t._cameraScale),t.camera.isOrthographicCamera?t.camera.getWorldDirection(t.eye).negate():t.eye.copy(t.cameraPosition).sub(t.worldPosition).normalize(),this.parent&&(Wh.copy(this.parent.matrixWorld).invert(),Wh.decompose(this.position,this.quaternion,this.scale)),super.updateMatrixWorld(e)}dispose(){this.traverse(function(e){e.geometry&&e.geometry.dispose(),e.material&&e.material.dispose()})}},Rf=class extends tn{constructor(){super(),this.isTransformControlsGizmo=!0,this.type="TransformControlsGizmo";let e=new pn({depthTest:!1,depthWrite:!1,fog:!1,toneMapped:!1,transparent:!0}),t=new ss({depthTest:!1,depthWrite:!1,fog:!1,toneMapped:!1,transparent:!0}),n=e.clone();n.opacity=.15;let s=t.clone();s.opacity=.5;let r=e.clone();r.color.setHex(16711680);let o=e.clone();o.color.setHex(65280);let a=e.clone();a.color.setHex(255);let l=e.clone();l.color.setHex(16711680),l.opacity=.5;let c=e.clone();c.color.setHex(65280),c.opacity=.5;let h=e.clone();h.color.setHex(255),h.opacity=.5;let u=e.clone();u.opacity=.25;let d=e.clone();d.color.setHex(16776960),d.opacity=.25;let f=e.clone();f.color.setHex(16776960);let p=e.clone();p.color.setHex(7895160),this.materialLib={xAxis:r,yAxis:o,zAxis:a,active:f,xAxisTransparent:l,yAxisTransparent:c,zAxisTransparent:h,activeTransparent:d};let v=new hn(0,.04,.1,12);v.translate(0,.05,0);let g=new Gt(.08,.08,.08);g.translate(0,.04,0);let m=new Pt;m.setAttribute("position",new Et([0,0,0,1,0,0],3));let _=new hn(.0075,.0075,.5,3);_.translate(0,.25,0);function E(V,Z){let G=new Cs(V,.0075,3,64,Z*Math.PI*2);return G.rotateY(Math.PI/2),G.rotateX(Math.PI/2),G}function b(){let V=new Pt;return V.setAttribute("position",new Et([0,0,0,1,1,1],3)),V}let C={X:[[new Ce(v,r),[.5,0,0],[0,0,-Math.PI/2]],[new Ce(v,r),[-.5,0,0],[0,0,Math.PI/2]],[new Ce(_,r),[0,0,0],[0,0,-Math.PI/2]]],Y:[[new Ce(v,o),[0,.5,0]],[new Ce(v,o),[0,-.5,0],[Math.PI,0,0]],[new Ce(_,o)]],Z:[[new Ce(v,a),[0,0,.5],[Math.PI/2,0,0]],[new Ce(v,a),[0,0,-.5],[-Math.PI/2,0,0]],[new Ce(_,a),null,[Math.PI/2,0,0]]],XYZ:[[new Ce(new Qs(.1,0),u),[0,0,0]]],XY:[[new Ce(new Gt(.15,.15,.01),h),[.15,.15,0]]],YZ:[[new Ce(new Gt(.15,.15,.01),l),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new Ce(new Gt(.15,.15,.01),c),[.15,0,.15],[-Math.PI/2,0,0]]]},M={X:[[new Ce(new hn(.2,0,.6,4),n),[.3,0,0],[0,0,-Math.PI/2]],[new Ce(new hn(.2,0,.6,4),n),[-.3,0,0],[0,0,Math.PI/2]]],Y:[[new Ce(new hn(.2,0,.6,4),n),[0,.3,0]],[new Ce(new hn(.2,0,.6,4),n),[0,-.3,0],[0,0,Math.PI]]],Z:[[new Ce(new hn(.2,0,.6,4),n),[0,0,.3],[Math.PI/2,0,0]],[new Ce(new hn(.2,0,.6,4),n),[0,0,-.3],[-Math.PI/2,0,0]]],XYZ:[[new Ce(new Qs(.2,0),n)]],XY:[[new Ce(new Gt(.2,.2,.01),n),[.15,.15,0]]],YZ:[[new Ce(new Gt(.2,.2,.01),n),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new Ce(new Gt(.2,.2,.01),n),[.15,0,.15],[-Math.PI/2,0,0]]]},x={START:[[new Ce(new Qs(.01,2),s),null,null,null,"helper"]],END:[[new Ce(new Qs(.01,2),s),null,null,null,"helper"]],DELTA:[[new oi(b(),s),null,null,null,"helper"]],X:[[new oi(m,s),[-1e3,0,0],null,[1e6,1,1],"helper"]],Y:[[new oi(m,s),[0,-1e3,0],[0,0,Math.PI/2],[1e6,1,1],"helper"]],Z:[[new oi(m,s),[0,0,-1e3],[0,-Math.PI/2,0],[1e6,1,1],"helper"]]},w={XYZE:[[new Ce(E(.5,1),p),null,[0,Math.PI/2,0]]],X:[[new Ce(E(.5,.5),r)]],Y:[[new Ce(E(.5,.5),o),null,[0,0,-Math.PI/2]]],Z:[[new Ce(E(.5,.5),a),null,[0,Math.PI/2,0]]],E:[[new Ce(E(.75,1),d),null,[0,Math.PI/2,0]]]},O={AXIS:[[new oi(m,s),[-1e3,0,0],null,[1e6,1,1],"helper"]]},P={XYZE:[[new Ce(new $n(.25,10,8),n)]],X:[[new Ce(new Cs(.5,.1,4,24),n),[0,0,0],[0,-Math.PI/2,-Math.PI/2]]],Y:[[new Ce(new Cs(.5,.1,4,24),n),[0,0,0],[Math.PI/2,0,0]]],Z:[[new Ce(new Cs(.5,.1,4,24),n),[0,0,0],[0,0,-Math.PI/2]]],E:[[new Ce(new Cs(.75,.1,2,24),n)]]},D={X:[[new Ce(g,r),[.5,0,0],[0,0,-Math.PI/2]],[new Ce(_,r),[0,0,0],[0,0,-Math.PI/2]],[new Ce(g,r),[-.5,0,0],[0,0,Math.PI/2]]],Y:[[new Ce(g,o),[0,.5,0]],[new Ce(_,o)],[new Ce(g,o),[0,-.5,0],[0,0,Math.PI]]],Z:[[new Ce(g,a),[0,0,.5],[Math.PI/2,0,0]],[new Ce(_,a),[0,0,0],[Math.PI/2,0,0]],[new Ce(g,a),[0,0,-.5],[-Math.PI/2,0,0]]],XY:[[new Ce(new Gt(.15,.15,.01),h),[.15,.15,0]]],YZ:[[new Ce(new Gt(.15,.15,.01),l),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new Ce(new Gt(.15,.15,.01),c),[.15,0,.15],[-Math.PI/2,0,0]]],XYZ:[[new Ce(new Gt(.1,.1,.1),u)]]},z={X:[[new Ce(new hn(.2,0,.6,4),n),[.3,0,0],[0,0,-Math.PI/2]],[new Ce(new hn(.2,0,.6,4),n),[-.3,0,0],[0,0,Math.PI/2]]],Y:[[new Ce(new hn(.2,0,.6,4),n),[0,.3,0]],[new Ce(new hn(.2,0,.6,4),n),[0,-.3,0],[0,0,Math.PI]]],Z:[[new Ce(new hn(.2,0,.6,4),n),[0,0,.3],[Math.PI/2,0,0]],[new Ce(new hn(.2,0,.6,4),n),[0,0,-.3],[-Math.PI/2,0,0]]],XY:[[new Ce(new Gt(.2,.2,.01),n),[.15,.15,0]]],YZ:[[new Ce(new Gt(.2,.2,.01),n),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new Ce(new Gt(.2,.2,.01),n),[.15,0,.15],[-Math.PI/2,0,0]]],XYZ:[[new Ce(new Gt(.2,.2,.2),n),[0,0,0]]]},W={X:[[new oi(m,s),[-1e3,0,0],null,[1e6,1,1],"helper"]],Y:[[new oi(m,s),[0,-1e3,0],[0,0,Math.PI/2],[1e6,1,1],"helper"]],Z:[[new oi(m,s),[0,0,-1e3],[0,-Math.PI/2,0],[1e6,1,1],"helper"]]};function N(V){let Z=new tn;for(let G in V)for(let ce=V[G].length;ce--;){let Y=V[G][ce][0].clone(),Q=V[G][ce][1],ie=V[G][ce][2],de=V[G][ce][3],fe=V[G][ce][4];Y.name=G,Y.tag=fe,Q&&Y.position.set(Q[0],Q[1],Q[2]),ie&&Y.rotation.set(ie[0],ie[1],ie[2]),de&&Y.scale.set(de[0],de[1],de[2]),Y.updateMatrix();let ee=Y.geometry.clone();ee.applyMatrix4(Y.matrix),Y.geometry=ee,Y.renderOrder=1/0,Y.position.set(0,0,0),Y.rotation.set(0,0,0),Y.scale.set(1,1,1),Z.add(Y)}return Z}this.gizmo={},this.picker={},this.helper={},this.add(this.gizmo.translate=N(C)),this.add(this.gizmo.rotate=N(w)),this.add(this.gizmo.scale=N(D)),this.add(this.picker.translate=N(M)),this.add(this.picker.rotate=N(P)),this.add(this.picker.scale=N(z)),this.add(this.helper.translate=N(x)),this.add(this.helper.rotate=N(O)),this.add(this.helper.scale=N(W)),this.picker.translate.visible=!1,this.picker.rotate.visible=!1,this.picker.scale.visible=!1}updateMatrixWorld(e){let n=(this.mode==="scale"?"local":this.space)==="local"?this.worldQuaternion:Gh;this.gizmo.translate.visible=this.mode==="translate",this.gizmo.rotate.visible=this.mode==="rotate",this.gizmo.scale.visible=this.mode==="scale",this.helper.translate.visible=this.mode==="translate",this.helper.rotate.visible=this.mode==="rotate",this.helper.scale.visible=this.mode==="scale";let s=[];s=s.concat(this.picker[this.mode].children),s=s.concat(this.gizmo[this.mode].children),s=s.concat(this.helper[this.mode].children);for(let r=0;r<s.length;r++){let o=s[r];o.visible=!0,o.rotation.set(0,0,0),o.position.copy(this.worldPosition);let a;if(this.camera.isOrthographicCamera?a=(this.camera.top-this.camera.bottom)/this.camera.zoom:a=this.worldPosition.distanceTo(this.cameraPosition)*Math.min(1.9*Math.tan(Math.PI*this.camera.fov/360)/this.camera.zoom,7),o.scale.set(1,1,1).multiplyScalar(a*this.size/4),o.tag==="helper"){o.visible=!1,o.name==="AXIS"?(o.visible=!!this.axis,this.axis==="X"&&(nn.setFromEuler(kh.set(0,0,0)),o.quaternion.copy(n).multiply(nn),Math.abs(Vt.copy(il).applyQuaternion(n).dot(this.eye))>.9&&(o.visible=!1)),this.axis==="Y"&&(nn.setFromEuler(kh.set(0,0,Math.PI/2)),o.quaternion.copy(n).multiply(nn),Math.abs(Vt.copy(Or).applyQuaternion(n).dot(this.eye))>.9&&(o.visible=!1)),this.axis==="Z"&&(nn.setFromEuler(kh.set(0,Math.PI/2,0)),o.quaternion.copy(n).multiply(nn),Math.abs(Vt.copy(sl).applyQuaternion(n).dot(this.eye))>.9&&(o.visible=!1)),this.axis==="XYZE"&&(nn.setFromEuler(kh.set(0,Math.PI/2,0)),Vt.copy(this.rotationAxis),o.quaternion.setFromRotationMatrix(i_.lookAt(n_,Vt,Or)),o.quaternion.multiply(nn),o.visible=this.dragging),this.axis==="E"&&(o.visible=!1)):o.name==="START"?(o.position.copy(this.worldPositionStart),o.visible=this.dragging):o.name==="END"?(o.position.copy(this.worldPosition),o.visible=this.dragging):o.name==="DELTA"?(o.position.copy(this.worldPositionStart),o.quaternion.copy(this.worldQuaternionStart),un.set(1e-10,1e-10,1e-10).add(this.worldPositionStart).sub(this.worldPosition).multiplyScalar(-1),un.applyQuaternion(this.worldQuaternionStart.clone().invert()),o.scale.copy(un),o.visible=this.dragging):(o.quaternion.copy(n),this.dragging?o.position.copy(this.worldPositionStart):o.position.copy(this.worldPosition),this.axis&&(o.visible=this.axis.search(o.name)!==-1));continue}o.quaternion.copy(n),this.mode==="translate"||this.mode==="scale"?(o.name==="X"&&Math.abs(Vt.copy(il).applyQuaternion(n).dot(this.eye))>.99&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="Y"&&Math.abs(Vt.copy(Or).applyQuaternion(n).dot(this.eye))>.99&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="Z"&&Math.abs(Vt.copy(sl).applyQuaternion(n).dot(this.eye))>.99&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="XY"&&Math.abs(Vt.copy(sl).applyQuaternion(n).dot(this.eye))<.2&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="YZ"&&Math.abs(Vt.copy(il).applyQuaternion(n).dot(this.eye))<.2&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="XZ"&&Math.abs(Vt.copy(Or).applyQuaternion(n).dot(this.eye))<.2&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1)):this.mode==="rotate"&&(zh.copy(n),Vt.copy(this.eye).applyQuaternion(nn.copy(n).invert()),o.name.search("E")!==-1&&o.quaternion.setFromRotationMatrix(i_.lookAt(this.eye,n_,Or)),o.name==="X"&&(nn.setFromAxisAngle(il,Math.atan2(-Vt.y,Vt.z)),nn.multiplyQuaternions(zh,nn),o.quaternion.copy(nn)),o.name==="Y"&&(nn.setFromAxisAngle(Or,Math.atan2(Vt.x,Vt.z)),nn.multiplyQuaternions(zh,nn),o.quaternion.copy(nn)),o.name==="Z"&&(nn.setFromAxisAngle(sl,Math.atan2(Vt.y,Vt.x)),nn.multiplyQuaternions(zh,nn),o.quaternion.copy(nn))),o.visible=o.visible&&(o.name.indexOf("X")===-1||this.showX),o.visible=o.visible&&(o.name.indexOf("Y")===-1||this.showY),o.visible=o.visible&&(o.name.indexOf("Z")===-1||this.showZ),o.visible=o.visible&&(o.name.indexOf("E")===-1||this.showX&&this.showY&&this.showZ),o.visible=o.visible&&(o.name.indexOf("XY")===-1||this.showXY),o.visible=o.visible&&(o.name.indexOf("YZ")===-1||this.showYZ),o.visible=o.visible&&(o.name.indexOf("XZ")===-1||this.showXZ),o.visible=o.visible&&(o.name!=="E"||this.showE),o.visible=o.visible&&(o.name!=="XYZE"||this.showXYZE),o.material._color=o.material._color||o.material.color.clone(),o.material._opacity=o.material._opacity||o.material.opacity,o.material.color.copy(o.material._color),o.material.opacity=o.material._opacity,this.enabled&&this.axis&&(o.name===this.axis?(o.material.color.copy(this.materialLib.active.color),o.material.opacity=1):this.axis.split("").some(function(l){return o.name===l})&&(o.material.color.copy(this.materialLib.active.color),o.material.opacity=1))}super.updateMatrixWorld(e)}},Cf=class extends Ce{constructor(){super(new Rs(1e5,1e5,2,2),new pn({visible:!1,wireframe:!0,side:Kn,transparent:!0,opacity:.1,toneMapped:!1})),this.isTransformControlsPlane=!0,this.type="TransformControlsPlane"}updateMatrixWorld(e){let t=this.space;switch(this.position.copy(this.worldPosition),this.mode==="scale"&&(t="local"),Hh.copy(il).applyQuaternion(t==="local"?this.worldQuaternion:Gh),tl.copy(Or).applyQuaternion(t==="local"?this.worldQuaternion:Gh),nl.copy(sl).applyQuaternion(t==="local"?this.worldQuaternion:Gh),Vt.copy(tl),this.mode){case"translate":case"scale":switch(this.axis){case"X":Vt.copy(this.eye).cross(Hh),cs.copy(Hh).cross(Vt);break;case"Y":Vt.copy(this.eye).cross(tl),cs.copy(tl).cross(Vt);break;case"Z":Vt.copy(this.eye).cross(nl),cs.copy(nl).cross(Vt);break;case"XY":cs.copy(nl);break;case"YZ":cs.copy(Hh);break;case"XZ":Vt.copy(nl),cs.copy(tl);break;case"XYZ":case"E":cs.set(0,0,0);break}break;default:cs.set(0,0,0)}cs.length()===0?this.quaternion.copy(this.cameraQuaternion):(Wh.lookAt(un.set(0,0,0),cs,Vt),this.quaternion.setFromRotationMatrix(Wh)),super.updateMatrixWorld(e)}};var Go=(i,e)=>{let t=new F().fromArray(e.position??[0,0,0]),n=R.stage?.pieces??[],s=h=>t.distanceTo(new F().fromArray(h))<1e-4,r=n.find(h=>h.kind===e.kind&&h.name===e.name)??n.find(h=>h.kind===e.kind&&s(h.position)),o=e.body===void 0||e.body===null?-1:R.stage?.bodies.indexOf(e.body)??-1,a=i.figure?.groups[o],l=a?a.quaternion.clone():new ct,c=a?a.position.clone():new F;return{turn:new ct().fromArray(r?.rotation??[0,0,0,1]),within:l,out:h=>h.clone().applyQuaternion(l).add(c),into:h=>h.clone().sub(c).applyQuaternion(l.clone().invert())}};var Pf=i=>i.toArray().map(e=>Math.round(1e3*e)/1e3),s_=({from:i,to:e})=>[i,e].map(t=>new F().fromArray(t)),r_=i=>{if(i.kind==="step")return new F(i.x,i.y??0,i.height);if(i.position)return new F().fromArray(i.position);if(!i.from||!i.to)return;let[e,t]=s_(i);return e.add(t).multiplyScalar(.5)},XE=(i,e)=>{let[t,n,s]=Pf(e);if(i.kind==="step")return{x:t,y:n,height:Math.max(.02,s)};if(i.position)return{position:[t,n,s]};let r=e.clone().sub(r_(i)),[o,a]=s_(i);return{from:Pf(o.add(r)),to:Pf(a.add(r))}},Xh=class{constructor(e){this.stage=e;this.controls=new Vh(e.camera,e.canvas),this.controls.setSize(.7),e.extra.add(this.handle,this.controls.getHelper()),this.controls.getHelper().visible=!1,this.controls.enabled=!1,this.controls.addEventListener("change",()=>e.draw()),this.controls.addEventListener("mouseDown",()=>this.start()),this.controls.addEventListener("mouseUp",()=>{this.end()}),this.controls.addEventListener("objectChange",()=>this.changed()),R.on(["joint","time","path","selection"],()=>this.place()),e.sights.push(()=>{e.canvas.dataset.gizmo=this.controls.axis?"on":"",this.dragging||this.place()})}stage;controls;handle=new tn;begin=new ct;revision=0;time=0;held;dragging=!1;waiting=!1;again=!1;place(){let{figure:e}=this.stage,t=R.joint===null?this.thing():void 0,n=t&&r_(t),s=t&&n&&Go(this.stage,t).out(n),r=R.stage?.joints.find(o=>o.name===R.joint);if(R.playing||!e||!(r??s)){this.hide();return}if(!this.dragging){if(r){let o=e.groups[r.body];this.handle.position.copy(this.stage.placeOf(r.body,r.anchor)),this.handle.quaternion.copy(o.quaternion),this.controls.setMode("rotate");let a=r.kind==="hinge"?r.axis.map(Math.abs):null,l=a?a.indexOf(Math.max(...a)):-1;this.controls.showX=!a||l===0,this.controls.showY=!a||l===1,this.controls.showZ=!a||l===2,this.controls.setSpace("local")}else s&&(this.handle.position.copy(s),this.handle.quaternion.identity(),this.controls.setMode("translate"),Object.assign(this.controls,{showX:!0,showY:!0,showZ:!0}),this.controls.setSpace("world"));this.controls.object!==this.handle&&this.controls.attach(this.handle),this.controls.enabled=!0}}hide(){let{dragging:e}=this;this.dragging=this.again=!1,e&&this.controls.pointerUp(null),this.controls.object&&(this.controls.detach(),this.controls.enabled=!1),e&&(this.stage.orbit.enabled=!0,this.stage.override=null,ai("cancel"),this.stage.draw())}thing(){let{obstacle:e,document:t}=R;return t?.obstacles.find(n=>n.kind===e?.kind&&n.index===e?.index)}start(){this.dragging=!0,this.revision=R.document?.revision??0,this.stage.orbit.enabled=!1,this.begin.copy(this.handle.quaternion),this.held=this.thing(),this.time=R.time}changed(){if(!this.dragging||R.joint===null)return;if(this.waiting){this.again=!0;return}let e=this.handle.quaternion.clone().multiply(this.begin.clone().invert());this.waiting=!0,ai("turn",{time:this.time,joint:R.joint,turn:[e.w,e.x,e.y,e.z]}).then(t=>{this.waiting=!1,t.ok&&this.dragging&&(this.stage.override={position:t.position,rotation:t.rotation},this.stage.draw()),this.again&&(this.again=!1,this.changed())})}async end(){for(;this.waiting;)await new Promise(e=>window.setTimeout(e,4));this.dragging&&(this.dragging=!1,this.stage.orbit.enabled=!0,R.joint!==null?await xt("drop",{time:this.time,partial:R.partial}):R.obstacle&&this.held&&await Vn(ar(R.obstacle),XE(this.held,Go(this.stage,this.held).into(this.handle.position)),this.revision),this.stage.override=null,this.stage.draw())}};var qE=11,qh=.02,Yi=[new F(1,0,0),new F(0,1,0),new F(0,0,1)],Vo=i=>new F().fromArray(i??[0,0,0]),YE=i=>Array.isArray(i)?i.map(e=>Math.round(1e3*e)/1e3):typeof i=="number"?Math.round(1e3*i)/1e3:i,Yh=class{constructor(e){this.stage=e;let{canvas:t}=e;this.frame.visible=!1,this.frame.renderOrder=9,e.extra.add(this.spots,this.frame),t.addEventListener("pointerdown",n=>this.down(n),!0),t.addEventListener("pointermove",n=>this.move(n),!0),window.addEventListener("pointerup",n=>{this.up(n)}),R.on(["joint","document","stage"],()=>e.draw()),e.sights.push(()=>this.place())}stage;spots=new Rn;frame=new wa(new Pt,new ss({color:16757844,depthTest:!1,transparent:!0}));ball=new $n(1,14,10);paint=new pn({color:16757844,depthTest:!1,transparent:!0,opacity:.95});ray=new Ps;shown=[];held=null;get busy(){return this.held!==null}places(){return this.place(),this.shown.map(({at:e})=>this.seen(e))}cancel(){this.held=null,this.frame.visible=!1,this.stage.orbit.enabled=!0,this.stage.draw()}thing(){let{obstacle:e,document:t}=R;return!e||R.playing||!this.stage.figure?null:t?.obstacles.find(n=>n.kind===e.kind&&n.index===e.index)??null}handles(e){if(e.kind==="step")return this.ofStep(e);let{turn:t,out:n,into:s,within:r}=Go(this.stage,e),o=Vo(e.position),a=e.radius,l=(f,p,v)=>({at:n(o.clone().addScaledVector(f,p)),along:f.clone().applyQuaternion(r),entries:v}),c=(f,p)=>o.clone().addScaledVector(f,p/2).toArray(),h=f=>l(f,a,p=>({radius:Math.max(qh/2,a+p)}));if(e.kind==="box"){let f=e.size;return[0,1,2].flatMap(p=>[1,-1].map(v=>{let g=Yi[p].clone().multiplyScalar(v).applyQuaternion(t);return l(g,f[p]/2,m=>{let _=Math.max(m,qh-f[p]);return{size:f.map((E,b)=>b===p?E+_:E),position:c(g,_)}})}))}if(e.kind==="sphere")return Yi.map(f=>h(f));if(e.from&&e.to){let f=[Vo(e.from),Vo(e.to)],p=f[1].clone().sub(f[0]).normalize(),v=new F().crossVectors(p,Math.abs(p.z)<.9?Yi[2]:Yi[0]).normalize();return o.copy(f[0]).add(f[1]).multiplyScalar(.5),[...["from","to"].map((g,m)=>({at:n(f[m]),along:null,entries:(_,E)=>({[g]:s(E).toArray()})})),h(v)]}let u=e.length,d=Yi[2].clone().applyQuaternion(t);return[...[1,-1].map(f=>{let p=d.clone().multiplyScalar(f);return l(p,u/2,v=>{let g=Math.max(v,qh-u);return{length:u+g,position:c(p,g)}})}),h(Yi[0].clone().applyQuaternion(t))]}ofStep(e){let{x:t,height:n,y:s=0,length:r=3,width:o=2.4}=e,a=(c,h,u)=>new F(t+c,s+h,u),l=(c,h)=>Math.max(h,qh-c);return[{at:a(r/2,0,n),along:Yi[2],entries:c=>({height:n+l(n,c)})},{at:a(0,0,n/2),along:Yi[0].clone().negate(),entries:c=>({x:t-l(r,c),length:r+l(r,c)})},{at:a(r,0,n/2),along:Yi[0],entries:c=>({length:r+l(r,c)})},...[1,-1].map(c=>({at:a(r/2,c*o/2,n/2),along:Yi[1].clone().multiplyScalar(c),entries:h=>({width:o+l(o,h),y:s+c*l(o,h)/2})}))]}place(){let e=this.thing();for(this.shown=e&&!this.held?this.handles(e):this.held?this.shown:[];this.spots.children.length<this.shown.length;){let n=new Ce(this.ball,this.paint);n.renderOrder=11,this.spots.add(n)}let t=this.stage.canvas.getBoundingClientRect().height||1;this.spots.children.forEach((n,s)=>{if(n.visible=s<this.shown.length&&!this.held,!n.visible)return;n.position.copy(this.shown[s].at);let r=n.position.distanceTo(this.stage.camera.position);n.scale.setScalar(5.5/t*2*r*Math.tan(this.stage.camera.fov*Math.PI/360))})}seen(e){let t=e.clone().project(this.stage.camera),n=this.stage.canvas.getBoundingClientRect();return[n.left+(t.x+1)/2*n.width,n.top+(1-t.y)/2*n.height,t.z]}found(e){let n=this.shown.map(s=>({handle:s,px:this.seen(s.at)})).filter(({px:s})=>s[2]<1).map(({handle:s,px:r})=>({handle:s,px:Math.hypot(r[0]-e.clientX,r[1]-e.clientY)})).sort((s,r)=>s.px-r.px)[0];return n&&n.px<qE?n.handle:null}down(e){let t=this.thing(),n=t&&e.button===0?this.found(e):null;!t||!n||(e.stopImmediatePropagation(),this.stage.orbit.enabled=!1,this.stage.canvas.setPointerCapture(e.pointerId),this.held={handle:n,thing:t,revision:R.document.revision,entries:{}})}move(e){let{held:t}=this;if(!t){e.buttons===0&&this.shown.length&&this.found(e)&&(this.stage.canvas.style.cursor="grab",e.stopImmediatePropagation());return}e.stopImmediatePropagation();let n=this.stage.canvas.getBoundingClientRect();this.ray.setFromCamera(new We((e.clientX-n.left)/n.width*2-1,1-(e.clientY-n.top)/n.height*2),this.stage.camera);let{at:s,along:r}=t.handle,{origin:o,direction:a}=this.ray.ray,l=0,c=s.clone();if(r){let h=o.clone().sub(s),u=r.dot(a),d=1-u*u;if(d<1e-4)return;l=(r.dot(h)-u*a.dot(h))/d}else{let h=new Hn().setFromNormalAndCoplanarPoint(this.stage.camera.getWorldDirection(new F),s);c=this.ray.ray.intersectPlane(h,new F)??c}t.entries=Object.fromEntries(Object.entries(t.handle.entries(l,c)).map(([h,u])=>[h,YE(u)])),Xn(Object.entries(t.entries).map(([h,u])=>`${h} ${[u].flat().map(d=>_s(d)).join(" ")} m`).join(", "),"note"),this.outline({...t.thing,...t.entries}),this.stage.draw()}outline(e){let{frame:t}=this,{turn:n,out:s,within:r}=Go(this.stage,{...e,position:this.held.thing.position}),{x:o,height:a,y:l=0,length:c=e.kind==="step"?3:1,width:h=2.4,radius:u}=e;t.geometry.dispose(),t.quaternion.copy(r).multiply(n),t.position.copy(s(Vo(e.position)));let d;if(e.kind==="step")d=new Gt(c,h,a),t.position.set(o+c/2,l,a/2),t.quaternion.identity();else if(e.kind==="box")d=new Gt(...e.size);else if(e.kind==="sphere")d=new La(u,1);else{let f=e.from&&e.to?[Vo(e.from),Vo(e.to)]:null;d=new hn(u,u,f?f[0].distanceTo(f[1]):c,12).rotateX(Math.PI/2),f&&(t.position.copy(s(f[0].clone().add(f[1]).multiplyScalar(.5))),t.quaternion.copy(r).multiply(new ct().setFromUnitVectors(Yi[2],f[1].clone().sub(f[0]).normalize())))}t.geometry=new Ia(d,1),d.dispose(),t.visible=!0}async up(e){let{held:t}=this;if(!t||e.button!==0)return;let{thing:n,entries:s,revision:r}=t;this.cancel(),Object.keys(s).length&&await Vn(ar(n),s,r)}};var ZE=4,Zh=class{constructor(e){this.stage=e;let{canvas:t}=e;this.ray.layers.enable(gf),this.mark.visible=!1,this.mark.renderOrder=10,e.extra.add(this.mark),t.addEventListener("pointermove",n=>this.move(n)),t.addEventListener("pointerdown",n=>this.down(n),!0),window.addEventListener("pointerup",n=>this.up(n)),t.addEventListener("pointerleave",()=>{this.held||this.light(null)})}stage;ray=new Ps;held=null;waiting=!1;next=null;mark=new Ce(new $n(.022,16,12),new pn({color:16757844,depthTest:!1,transparent:!0,opacity:.95}));times=[];trips=[];get busy(){return this.held!==null}async cancel(){this.held&&(this.held=null,this.stage.orbit.enabled=!0,await ai("cancel"),this.stage.override=null,this.stage.draw())}hit(e){let{figure:t,camera:n,canvas:s}=this.stage;if(!t||!t.root.visible)return null;let r=s.getBoundingClientRect(),o=new We((e.clientX-r.left)/r.width*2-1,1-(e.clientY-r.top)/r.height*2);this.ray.setFromCamera(o,n);let a=this.ray.intersectObject(t.root,!0)[0];if(!a)return null;let l=a.object;for(;l&&l.userData.body===void 0;)l=l.parent;return l?{body:l.userData.body,point:a.point}:null}light(e){let t=e!==null;this.stage.canvas.style.cursor=t?"grab":"",(this.mark.visible!==t||t)&&this.stage.draw(),this.mark.visible=t,e&&this.mark.position.copy(e.point)}down(e){if(e.button!==0||e.shiftKey||this.stage.canvas.dataset.gizmo==="on")return;let t=this.hit(e);if(!t)return;e.stopImmediatePropagation(),this.stage.orbit.enabled=!1,this.stage.canvas.setPointerCapture(e.pointerId),R.playing=!1;let n=R.document?.keys.find(a=>Math.abs(a.time-R.time)<.5/R.fps);n&&R.seek(n.time);let s=this.stage.figure.groups[t.body],r=t.point.clone().sub(s.position).applyQuaternion(s.quaternion.clone().invert()).toArray(),o=new Hn().setFromNormalAndCoplanarPoint(this.stage.camera.getWorldDirection(new F),t.point);this.held={body:t.body,offset:r,plane:o,x:e.clientX,y:e.clientY,time:R.time,moved:!1},this.stage.canvas.style.cursor="grabbing"}move(e){let{held:t}=this;if(!t){e.buttons===0&&this.light(this.hit(e));return}if(!t.moved&&Math.hypot(e.clientX-t.x,e.clientY-t.y)<ZE)return;t.moved||(t.moved=!0,this.waiting=!0,ai("grip",{time:t.time,body:t.body,offset:t.offset,plant:!e.altKey,alone:R.partial&&R.here===null}).then(r=>{this.waiting=!1,r.ok?this.follow():(Xn(r.words??"","wrong"),this.cancel())}));let n=this.stage.canvas.getBoundingClientRect(),s=new We((e.clientX-n.left)/n.width*2-1,1-(e.clientY-n.top)/n.height*2);this.ray.setFromCamera(s,this.stage.camera),this.next=this.ray.ray.intersectPlane(t.plane,new F),this.follow()}follow(){if(this.waiting||!this.next||!this.held)return;let e=this.next.toArray(),t=performance.now();this.next=null,this.waiting=!0,ai("drag",{position:e}).then(n=>{if(this.waiting=!1,!!this.held){if(!n.ok){Xn(n.words??"","wrong"),this.cancel();return}this.times.push(n.ms),this.trips.push(performance.now()-t),this.stage.override={position:n.position,rotation:n.rotation},this.mark.visible=!0,this.stage.figure.put(this.stage.override),this.mark.position.copy(this.stage.placeOf(this.held.body,this.held.offset)),this.mark.material.color.set(n.missed>.005?16735324:16757844),this.stage.draw(),this.follow()}})}async up(e){let{held:t}=this;if(!(!t||e.button!==0)){for(;t.moved&&(this.waiting||this.next)&&this.held;)await new Promise(n=>window.setTimeout(n,4));if(this.held=null,this.stage.orbit.enabled=!0,this.stage.canvas.style.cursor="",this.mark.visible=!1,!t.moved){R.joint=R.stage?.joints.find(n=>n.body===t.body)?.name??null,R.tell("joint"),this.stage.draw();return}$E=performance.now(),await xt("drop",{time:t.time,partial:R.partial}),this.stage.override=null,this.stage.draw()}}},$E=0;var Wo=["pose","problems","weights","scene"],cr=i=>{for(let e of Wo){let t=e===i;Me(`tab-${e}`).setAttribute("aria-selected",String(t)),Me(`tab-${e}`).tabIndex=t?0:-1,Me(`panel-${e}`).hidden=!t}(i==="weights"||i==="scene")&&Df[i]()},o_=([i,e,t,n])=>{let s=i<0?-1:1,r=Math.hypot(e,t,n),o=2*Math.atan2(r,Math.abs(i))*(180/Math.PI);return[e,t,n].map(a=>r>1e-12?s*a*o/r:0)},KE=(i,e)=>i.kind==="free"?[...e.slice(i.qpos,i.qpos+3),...o_(e.slice(i.qpos+3,i.qpos+7))]:i.kind==="ball"?o_(e.slice(i.qpos,i.qpos+4)):[i.kind==="hinge"?e[i.qpos]*180/Math.PI:e[i.qpos]],If=i=>{let e=i.value.trim().replace(",",".");return e===""?NaN:Number(e)},Xo=(i,e,t,n,s=1)=>{let r=ae("input",{type:"text",inputmode:"decimal",class:"number",value:_s(e,3),"aria-label":`${i} [${t}]`,title:`${i} [${t}]; arrow keys change it`});return r.addEventListener("change",()=>n(If(r))),r.addEventListener("keydown",o=>{if(o.key==="Enter"&&r.blur(),o.key!=="ArrowUp"&&o.key!=="ArrowDown")return;o.preventDefault();let a=(o.key==="ArrowUp"?1:-1)*s*(o.shiftKey?10:1);r.value=_s(If(r)+a,3),n(If(r))}),r},JE=(i,e)=>{let{loaded:t,document:n}=R,s=n.revision,r=t.keys[i],o=n.keys[i],a=e.kind==="free"?e.qpos+3:e.qpos,l=r.fixed[a],c=KE(e,r.qpos),h=["keyframe",i],u=e===R.stage.joints.find(b=>b.kind==="free"),d=b=>u?{root:b}:{roots:{[e.name]:b}},f=e.kind==="free"||o.joints?.[e.name]!==void 0,p=l?"pin":"free",v=ae("select",{class:"mode","aria-label":`${e.name}: pinned, free, or by the keyframe's rule for other joints`,title:"pinned: fixed at this value; free: chosen by the optimiser; others: by the keyframe's rule for other joints"});for(let[b,C]of[["pin","pinned"],["free","free"],...e.kind==="free"?[]:[["none",`others (${o.others})`]]])v.append(ae("option",{value:b,text:C,selected:b===(f?p:"none")}));v.addEventListener("change",()=>{v.value==="none"?Vn(h,{joints:{[e.name]:null}},s):xt(v.value,{key:i,revision:s,joints:[e.name]})});let g=ae("div",{class:`joint${R.joint===e.name?" selected":""}${l?"":" free"}`},ae("button",{type:"button",class:"name",text:e.name,title:e.range?`range ${e.range.map(b=>_s(b,1)).join(" to ")}`:e.kind,onclick:()=>{R.joint=R.joint===e.name?null:e.name,R.tell("joint")}}),v),m=ae("div",{class:"numbers"}),_=(b,C)=>{let M=[...c];if(M[b]=C,e.kind==="free"){let x=M.slice(0,3).map((w,O)=>O!==b&&!r.fixed[e.qpos+O]?"free":w);Vn(h,d(b<3?{position:x}:{rotation:{rotvec:M.slice(3)}}),s).then(Df.pose)}else Vn(h,{joints:{[e.name]:e.kind==="ball"?{rotvec:M}:C}},s).then(Df.pose)},E=e.kind==="free"?["x","y","z","turn x","turn y","turn z"]:e.kind==="ball"?["x","y","z"]:[""];return c.forEach((b,C)=>{let M=e.kind==="slide"||e.kind==="free"&&C<3,x=Xo(`${e.name} ${E[C]}`.trim(),b,M?"m":"degrees",O=>_(C,O),M?.01:1),w=e.kind==="free"&&C<3?r.fixed[e.qpos+C]:l;x.classList.toggle("loose",!w),m.append(x),e.kind==="free"&&C<3&&m.append(ae("button",{type:"button",class:"axis",text:w?"•":"○","aria-pressed":String(!w),"aria-label":`${e.name} ${E[C]}: ${w?"pinned; press to free it":"free; press to pin it"}`,title:w?"free this axis":"pin this axis",onclick:()=>{let O=c.slice(0,3).map((P,D)=>(D===C?w:!r.fixed[e.qpos+D])?"free":P);Vn(h,d({position:O}),s)}}))}),g.append(m),g},a_=null,Nf=()=>{let i=Me("panel-pose"),{stage:e,loaded:t,document:n}=R;if(i.contains(window.document.activeElement)&&window.document.activeElement.matches("input:focus")&&R.playing)return;let s=R.here;if(!e||!t||!n)return;if(s===null||!t.keys[s]){i.replaceChildren(ae("p",{class:"hint"},"No keyframe here. Drag any point of the figure, or press ",ae("kbd",{text:"K"}),", to make one from the path."));return}let r=n.keys[s],{revision:o}=n,a=ae("select",{"aria-label":"joints that this keyframe does not name"});for(let h of new Set(["free","rest","previous",r.others]))a.append(ae("option",{value:h,text:h,selected:h===r.others}));a.addEventListener("change",()=>{Vn(["keyframe",s],{others:a.value==="free"?null:a.value},o)});let l=Xo("time",r.time,"s",h=>{li("move_keys",{moves:[[s,h]],revision:o}).then(u=>{u.ok?R.seek(h):Nf()})},1/R.fps),c=window.document.activeElement?.getAttribute("aria-label");i.replaceChildren(ae("div",{class:"heading"},ae("h2",{text:`Keyframe ${s+1}`}),ae("label",{},"at ",l," s")),ae("div",{class:"buttons"},ae("button",{type:"button",text:"mirror",title:"mirror left and right (M)",onclick:()=>{xt("mirror",{keys:[s],revision:o})}}),ae("button",{type:"button",text:"rest",title:"set every joint to rest",onclick:()=>{xt("rest",{key:s,revision:o})}}),ae("button",{type:"button",text:"pin all",onclick:()=>{xt("pin",{key:s,revision:o,joints:e.joints.map(h=>h.name)})}}),ae("button",{type:"button",text:"free all",onclick:()=>{xt("free",{key:s,revision:o,joints:e.joints.map(h=>h.name)})}})),ae("label",{class:"line"},"other joints: ",a),...["sites","bodies"].flatMap(h=>Object.entries(r[h]??{}).map(([u,d])=>ae("div",{class:"line place"},ae("span",{text:`${u} → ${JSON.stringify(d)}`}),...h==="sites"?[ae("button",{type:"button",text:"remove target",onclick:()=>{Vn(["keyframe",s],{sites:{[u]:null}},o)}})]:[]))),...e.joints.map(h=>JE(s,h))),R.joint!==a_&&(a_=R.joint,i.querySelector(".joint.selected")?.scrollIntoView({block:"nearest"})),c&&!i.contains(window.document.activeElement)&&i.querySelector(`[aria-label="${CSS.escape(c)}"]`)?.focus()},l_=()=>{let{violations:i}=R,e=i.length;Me("count").textContent=e?String(e):"",Me("count").hidden=!e;let t=Me("panel-problems");if(!e){t.replaceChildren(ae("p",{class:"hint good",id:"nothing-wrong",text:R.status.state==="settled"?"No problems.":"No problems so far."}));return}t.replaceChildren(ae("p",{class:"hint",text:"Worst first. Click one to go there."}),ae("ol",{class:"violations"},...i.map(n=>ae("li",{},ae("button",{type:"button",class:n.keyframe===null?"":"own",text:n.text,onclick:()=>{n.time!==null&&(R.playing=!1,R.seek(n.time));let s=R.stage?.joints.find(r=>r.name===n.name);s&&(R.joint=s.name,R.tell("joint")),n.keyframe!==null&&R.select([n.keyframe-1]),n.time===null&&Xn("it concerns the whole motion","note")}})))))},$h=4,Lf=()=>{let{kinds:i,document:e,loaded:t,course:n}=R;if(!i.length||!e||Me("panel-weights").hidden)return;let s=Me("panel-weights"),r=n?.parts??{},o=s.scrollTop;if(s.contains(window.document.activeElement)&&window.document.activeElement.type==="range")return;let a=Object.values(r).reduce((u,d)=>u+d,0),l=i.map(({kind:u,part:d,term:f,weight:p,quantity:v,"is on":g})=>{let m=e.weights[f],_=f in e.weights,E=m??t?.weights[f]??(g?p:0),b=ae("input",{type:"range",min:-$h,max:$h,step:.05,"aria-label":`weight of ${f}`,value:E>0?Math.log10(E/p):-$h}),C=Xo(`weight of ${f}`,E,"",w=>{li("set_weight",{kind:u,part:d,weight:w})},.1);b.addEventListener("input",()=>{C.value=_s(p*10**Number(b.value),4)}),b.addEventListener("change",()=>{let w=Number(b.value)<=-$h?0:Number((p*10**Number(b.value)).toPrecision(3));b.blur(),li("set_weight",{kind:u,part:d,weight:w})});let M=a>0?(r[f]??0)/a:0,x=ae("i",{class:"share"});return x.style.width=`${100*M}%`,ae("div",{class:`weight${f in(t?.weights??{})?"":" off"}`,title:`penalises ${v}`},ae("span",{class:"name"},ae("b",{text:f}),ae("small",{text:v})),b,C,ae("button",{type:"button",class:"axis",text:"↺",disabled:!_,title:"its default","aria-label":`default weight of ${f}`,onclick:()=>{li("set_weight",{kind:u,part:d,weight:null})}}),ae("span",{class:"part",title:"its share of E"},x,ae("small",{text:r[f]===void 0?"":r[f].toPrecision(2)})))}),c=Xo("tolerance of the search",Number(e.solve.tolerance??.001),"",u=>{Vn(["solve"],{tolerance:u})},.001);c.value=String(e.solve.tolerance??.001);let h=ae("input",{type:"checkbox",checked:(e.weights.prior??t?.weights.prior??0)>0});h.addEventListener("change",()=>{li("set_weight",{kind:"prior",weight:h.checked?i.find(({term:u})=>u==="prior")?.weight:0})}),s.replaceChildren(ae("label",{class:"line",title:"stay near the poses of people between such keyframes"},h," as people move"),ae("label",{class:"line"},"tolerance of the search ",c),...l),s.scrollTop=o},jE={box:{position:[0,0,.2],size:[.4,.4,.4]},step:{x:0,height:.2},sphere:{position:[0,0,.2],radius:.2},capsule:{position:[0,0,.9],length:1,radius:.03},cylinder:{position:[0,0,.25],length:.5,radius:.15}},Uf=()=>{let{document:i}=R;if(!i||Me("panel-scene").hidden)return;let e=Me("panel-scene"),{revision:t,obstacles:n}=i,s=Object.entries(jE).map(([o,a])=>ae("button",{type:"button",text:`+ ${o}`,disabled:o==="step"&&n.some(l=>l.kind===o),onclick:()=>{let l=Math.round(100*(R.now?R.now.centreAt(R.time)[0]+.8:.6))/100;o==="step"?Vn(["scene"],{step:{...a,x:l}}):li("add",{at:["scene",o],entries:{...a,position:[l,0,a.position[2]]}})}})),r=n.map(o=>{let a=R.obstacle?.kind===o.kind&&R.obstacle.index===o.index,l=`${o.kind}${o.name?` ‘${o.name}’`:""}`,c=ae("div",{class:`joint${a?" selected":""}`},ae("button",{type:"button",class:"name",text:l,title:"select it on the stage",onclick:()=>{R.obstacle=a?null:{kind:o.kind,index:o.index},R.joint=null,R.tell("joint"),Uf()}}),ae("button",{type:"button",class:"axis",text:"✕","aria-label":`delete the ${l}`,onclick:()=>{R.obstacle=null,R.tell("joint"),li("remove",{at:ar(o),revision:t})}})),h=ae("div",{class:"numbers"});for(let[u,d]of Object.entries(o))["kind","index","color","mass"].includes(u)||(typeof d=="number"?h.append(Xo(`${l} ${u}`,d,"m",f=>{Vn(ar(o),{[u]:f},t)},.01)):Array.isArray(d)&&d.forEach((f,p)=>h.append(Xo(`${l} ${u} ${"xyz"[p]}`,f,"m",v=>{let g=[...d];g[p]=v,Vn(ar(o),{[u]:g},t)},.01))));return c.append(h),c});e.replaceChildren(ae("div",{class:"buttons"},...s),...r.length?r:[ae("p",{class:"hint",text:"Nothing but the floor. Add something to step on or to run into."})])},Df={pose:Nf,problems:l_,weights:Lf,scene:Uf},c_=()=>{for(let n of Wo)Me(`tab-${n}`).addEventListener("click",()=>cr(n)),Me(`tab-${n}`).addEventListener("keydown",s=>{let r=s.key==="ArrowRight"?1:s.key==="ArrowLeft"?-1:0;if(!r)return;s.stopPropagation();let o=Wo[(Wo.indexOf(n)+r+Wo.length)%Wo.length];cr(o),Me(`tab-${o}`).focus()});let i="",e=()=>{let n=`${R.here}|${R.joint}|${R.document?.revision}`;R.playing||n===i&&R.here===null||n!==i&&(i=n,Nf())};R.on(["time","joint"],e),R.on(["loaded","stage","document"],()=>{R.document?.revision===R.loaded?.revision&&(i="",e())}),R.on(["settled","status"],l_),R.on(["kinds","document","loaded","settled"],Lf);let t=0;R.on("path",()=>{t||(t=window.setTimeout(()=>{t=0,Lf()},300))}),R.on(["document","joint"],Uf),cr("pose")};var QE="M7 4.5v15l12.500-7.500z",e1="M6 4.5h4.200v15H6zM13.800 4.500H18v15h-4.200z",t1=120,n1=[.1,.25,.5,1,1.5,2],i1={loading:"loading …",searching:"optimising",settled:"converged",refused:"refused",gone:"gone"},s1={INTERRUPTED:"stopped",paused:"paused",MAX_EVALUATIONS:"evaluation limit reached",NO_PROGRESS:"no progress",CONVERGED:"converged"},ol=(i=!R.playing)=>{i&&R.time>=R.last-1e-6&&R.seek(R.first),R.playing=i,R.tell("time")},Ff=i=>{ol(!1),R.seek(R.first+(Math.round((R.time-R.first)*R.fps)+i)/R.fps)},rl=i=>{ol(!1);let e=(R.document?.keys??[]).map(s=>s.time),t=1e-4,n=i>0?e.find(s=>s>R.time+t):e.findLast(s=>s<R.time-t);R.seek(n??(i>0?R.last:R.first))},Of=async()=>{R.document?.file?await xt("save"):Me("files").dispatchEvent(new CustomEvent("save-as"))},Bf=async()=>{(await xt("key",{time:Math.round(R.time*1e4)/1e4,...R.partial&&R.limb?{limb:R.limb.joints}:{}})).ok&&R.select([...R.document?.keys.keys()??[]].filter(e=>Math.abs(R.document.keys[e].time-R.time)<1e-4))},kf=async()=>{if(R.bar){let{kind:t,index:n}=R.bar;R.bar=null,await li("remove",{at:[t,n]});return}let i=R.keys.size?[...R.keys]:R.here===null?[]:[R.here];if(!i.length)return;(await xt("edit",{name:"delete_keys",keys:i})).ok&&R.select([])},h_=(i,e)=>{let t=Me("play").querySelector("path");Me("play").addEventListener("click",()=>ol()),Me("transport").prepend(Ws("previous","previous keyframe",()=>rl(-1),"page up")),Me("play").after(Ws("next","next keyframe",()=>rl(1),"page down")),Me("tools").append(Ws("key","insert a keyframe from the path",()=>{Bf()},"K"),Ws("bin","delete the selection",()=>{kf()},"Delete")),Me("history").append(Ws("undo","undo",()=>{xt("undo")},"Ctrl-Z"),Ws("redo","redo",()=>{xt("redo")},"Ctrl-Shift-Z"),Ws("save","save",()=>{Of()},"Ctrl-S"));let s=Me("speed");for(let h of n1)s.append(ae("option",{value:h,text:`${h}×`,selected:h===1}));s.addEventListener("change",()=>{R.speed=Number(s.value)});for(let[h,u]of[["loop","loop"],["follow","follow"],["ghosts","ghosts"],["trails","trails"],["partial","partial"]]){let d=Me(h);d.checked=R[u],d.addEventListener("change",()=>{R[u]=d.checked,R.tell("shown")})}let r=Me("which");r.addEventListener("change",()=>{r.value==="take"&&(R.snapshot=R.now,r.value="snapshot"),R.which=r.value,R.tell("which")}),Me("views").addEventListener("change",h=>i.aim(h.target.value)),Me("fit").addEventListener("click",()=>e.fit()),Me("zoom-in").addEventListener("click",()=>e.zoom(.7)),Me("zoom-out").addEventListener("click",()=>e.zoom(1.4)),Me("go").addEventListener("click",()=>{xt(R.status.go?"stop":"go")}),Me("anew").addEventListener("click",()=>{xt("go",{anew:!0})});let o=ae("b"),a=ae("span");Me("clock").replaceChildren(o,a);let l=-1/0;R.on(["time","path"],()=>{let h=R.playing?e1:QE;if(t.getAttribute("d")!==h)t.setAttribute("d",h);else if(R.playing&&performance.now()-l<t1)return;l=performance.now(),yr(o,R.time.toFixed(2)),yr(a,` / ${R.last.toFixed(2)} s`),yr(Me("image"),`frame ${Math.round((R.time-R.first)*R.fps)}`)});let c=()=>{let{status:h,course:u}=R,d=h.state==="settled"?s1[h.stop??""]??"converged":i1[h.state]??h.state;yr(Me("state"),Dr==="open"?d:"no connection to the studio"),Me("state").dataset.state=Dr==="open"?h.state:"gone",yr(Me("energy"),u?.value===void 0?"":`E ${u.value>=1e3?u.value.toExponential(2):_s(u.value)}`),yr(Me("go"),h.go?"Stop":"Continue"),Me("go").title=h.go?"stop optimising, now and after edits (G)":"optimise, now and after edits (G)"};R.on(["status","path","line"],c),R.on("document",()=>{let{document:h}=R;if(!h)return;Me("name").textContent=h.file??`${h.name} (no file yet)`,Me("dirty").hidden=!h.dirty,window.document.title=`${h.dirty?"• ":""}${h.name} – dynsplines studio`;let[u,d]=[...Me("history").querySelectorAll("button")];u.disabled=!h.undo,d.disabled=!h.redo,u.title=h.undo?`undo: ${h.undo} (Ctrl-Z)`:"nothing to undo",d.title=h.redo?`redo: ${h.redo} (Ctrl-Shift-Z)`:"nothing to redo"}),R.on("task",()=>{Me("task").hidden=Dh===null,Me("task-words").textContent=Dh??""}),R.on("offer",()=>{Me("offer").hidden=Nh===null,Me("offer-words").textContent=Nh??""}),R.on("line",()=>{Me("elsewhere").hidden=Dr!=="elsewhere"}),Me("take-over").addEventListener("click",()=>ja(!0)),Me("offer-take").addEventListener("click",()=>{xt("offer",{take:!0})}),Me("offer-drop").addEventListener("click",()=>{xt("offer",{take:!1})}),Me("task-stop").addEventListener("click",()=>{xt("stop_task")})};var qo=i=>()=>Me(i).click(),al=()=>R.keys.size?[...R.keys].sort((i,e)=>i-e):R.here===null?[]:[R.here],zf=[],Hf=!1,p_=async i=>{if(zf.push(i),!Hf){Hf=!0;try{for(;zf.length;){let e=al(),t=R.here,n=zf.splice(0).reduce((r,o)=>o(r),e.map(r=>R.document.keys[r].time));if(!e.length)return;(await xt("edit",{name:"move_keys",moves:e.map((r,o)=>[r,Math.round(n[o]*1e4)/1e4])})).ok&&t!==null&&e.includes(t)&&R.seek(R.document.keys[t].time)}}finally{Hf=!1}}},u_=i=>p_(e=>e.map(t=>t+i/R.fps)),d_=async i=>{al().length>1&&await p_(e=>e.map(t=>e[0]+i*(t-e[0])))},m_=(i,e,t,n)=>[["Space","play or pause",()=>ol()],["ArrowLeft","previous frame",()=>Ff(-1)],["ArrowRight","next frame",()=>Ff(1)],["PageUp","previous keyframe",()=>rl(-1)],["PageDown","next keyframe",()=>rl(1)],["Home","first frame",()=>R.seek(R.first)],["End","last frame",()=>R.seek(R.last)],["+","faster",()=>f_(1)],["-","slower",()=>f_(-1)],["L","loop",qo("loop")],["F","camera follows the figure",qo("follow")],["1","view: three-quarter",()=>i.aim("quarter")],["2","view: right side",()=>i.aim("side")],["3","view: left side",()=>i.aim("left")],["4","view: front",()=>i.aim("front")],["5","view: back",()=>i.aim("back")],["6","view: top",()=>i.aim("top")],["B","before, both, side by side, after",()=>{let s=["after","before","both","side"],r=s[(s.indexOf(R.which)+1)%s.length],o=Me("which");o.value=r,o.dispatchEvent(new Event("change"))}],["H","onion skin: the figure at every keyframe",qo("ghosts")],["T","motion paths and contact points",qo("trails")],["C","curves",vf],["U","limb rows on the timeline",()=>{e.unfolded=!e.unfolded,e.draw()}],["Z","show all of the timeline",()=>e.fit()],["[","timeline: zoom out",()=>e.zoom(1.4)],["]","timeline: zoom in",()=>e.zoom(.7)],["K","insert a keyframe from the path",()=>{Bf()}],["N","new keyframes: of one limb, or of the whole figure",qo("partial")],["Delete","delete keyframes, a contact or grasp",()=>{kf()}],["Alt-ArrowLeft","move the keyframe one frame earlier",()=>{u_(-1)}],["Alt-ArrowRight","move the keyframe one frame later",()=>{u_(1)}],["Alt-ArrowUp","spread selected keyframes by 10 %",()=>{d_(1.1)}],["Alt-ArrowDown","compress selected keyframes by 10 %",()=>{d_(1/1.1)}],["M","mirror keyframes",()=>{let s=al();s.length&&xt("mirror",{keys:s})}],["Ctrl-A","select all keyframes",()=>R.select(R.document?.keys.keys()??[])],["Ctrl-C","copy keyframes",()=>{let s=al();s.length&&xt("copy",{keys:s})}],["Ctrl-V","paste keyframes here",()=>{xt("paste",{time:R.time})}],["Ctrl-D","duplicate keyframes to here",()=>{let s=al();s.length&&xt("copy",{keys:s}).then(r=>{r.ok&&xt("paste",{time:R.time})})}],["Ctrl-Z","undo",()=>{xt("undo")}],["Ctrl-Shift-Z","redo",()=>{xt("redo")}],["Ctrl-S","save",()=>{Of()}],["G","stop or continue optimising",qo("go")],["P","panel: pose",()=>{cr("pose"),Me("tab-pose").focus()}],["O","panel: problems",()=>{cr("problems"),Me("tab-problems").focus()}],["W","panel: weights",()=>{cr("weights"),Me("tab-weights").focus()}],["S","panel: scene",()=>{cr("scene"),Me("tab-scene").focus()}],["J","next joint, with rotation rings",()=>{let s=R.stage?.joints.map(r=>r.name)??[];R.joint=s[(s.indexOf(R.joint??"")+1)%s.length]??null,R.tell("joint")}],["Escape","cancel a drag; deselect",()=>{if(t.busy){t.cancel();return}if(n.busy){n.cancel();return}R.joint!==null||R.obstacle!==null?(R.joint=R.obstacle=null,R.tell("joint")):R.select([])}],["?","this list",()=>o1(i,e,t,n)]],f_=i=>{let e=Me("speed");e.selectedIndex=Math.min(Math.max(e.selectedIndex+i,0),e.length-1),e.dispatchEvent(new Event("change"))},r1=[["drag the figure","pose it: the limb bends, then the whole figure follows; planted soles stay (Alt: they may move)"],["click the figure","select a joint and rotate it by its rings"],["select an obstacle in the panel Scene","arrows move it; the dots on its faces and ends resize it"],["drag the background","orbit; right button or Shift: pan; wheel: zoom"],["drag a diamond","move keyframes; Shift or Ctrl: select more; Ctrl-Alt: scale in time; Alt: do not snap"],["drag over a point's row","new contact; drag it or its ends; on a hand's row (select a joint of its arm): new grasp"],["Ctrl-wheel, Shift-wheel","zoom and move the timeline"]],o1=(i,e,t,n)=>{let s=a=>a.replace("Arrow","").replace("Left","←").replace("Right","→").replace("Up","↑").replace("Down","↓").replace("Page↑","PgUp").replace("Page↓","PgDn"),r=(a,l)=>ae("div",{},ae("kbd",{text:a}),ae("span",{text:l})),o=ae("dialog",{class:"help","aria-label":"keys"},ae("h2",{text:"Keys"}),ae("div",{class:"columns"},...m_(i,e,t,n).map(([a,l])=>r(s(a),l))),ae("h2",{text:"Mouse"}),ae("div",{class:"columns wide"},...r1.map(([a,l])=>r(a,l))),ae("form",{method:"dialog"},ae("div",{class:"buttons end"},ae("button",{type:"submit",class:"main",text:"Close"}))));o.addEventListener("close",()=>o.remove()),document.body.append(o),o.showModal()},g_=(i,e,t,n)=>{let s=new Map(m_(i,e,t,n).map(([r,,o])=>[r,o]));Me("help").addEventListener("click",()=>s.get("?")()),window.addEventListener("keydown",r=>{let o=r.target;if(document.querySelector("dialog[open]"))return;let a=o.matches("input[type=text], select, textarea"),l=o.matches("input[type=range]"),c=r.ctrlKey||r.metaKey;if(a&&!(c&&"zs".includes(r.key.toLowerCase()))&&r.key!=="Escape"||l&&r.key.startsWith("Arrow")||o.matches("button, summary, input[type=checkbox], [role=tab]")&&(r.key===" "||r.key==="Enter")||o.matches("[role=tab]")&&r.key.startsWith("Arrow"))return;let h=r.key===" "?"Space":r.key.length===1?r.key.toUpperCase():r.key==="Backspace"?"Delete":r.key,u=r.shiftKey&&c?"Shift-":"",d=`${c?"Ctrl-":""}${u}${r.altKey?"Alt-":""}${h==="="?"+":h}`,f=s.get(d==="Ctrl-Y"?"Ctrl-Shift-Z":d);f&&(c&&h==="C"&&String(getSelection())||(r.preventDefault(),f()))})};var __={type:"change"},Vf={type:"start"},y_={type:"end"},Kh=new Ts,x_=new Hn,a1=Math.cos(70*yh.DEG2RAD),In=new F,hi=2*Math.PI,It={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Gf=1e-6,Jh=class extends Tr{constructor(e,t=null){super(e,t),this.state=It.NONE,this.target=new F,this.cursor=new F,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:ir.ROTATE,MIDDLE:ir.DOLLY,RIGHT:ir.PAN},this.touches={ONE:sr.ROTATE,TWO:sr.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new F,this._lastQuaternion=new ct,this._lastTargetPosition=new F,this._quat=new ct().setFromUnitVectors(e.up,new F(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new Io,this._sphericalDelta=new Io,this._scale=1,this._panOffset=new F,this._rotateStart=new We,this._rotateEnd=new We,this._rotateDelta=new We,this._panStart=new We,this._panEnd=new We,this._panDelta=new We,this._dollyStart=new We,this._dollyEnd=new We,this._dollyDelta=new We,this._dollyDirection=new F,this._mouse=new We,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=c1.bind(this),this._onPointerDown=l1.bind(this),this._onPointerUp=h1.bind(this),this._onContextMenu=_1.bind(this),this._onMouseWheel=f1.bind(this),this._onKeyDown=p1.bind(this),this._onTouchStart=m1.bind(this),this._onTouchMove=g1.bind(this),this._onMouseDown=u1.bind(this),this._onMouseMove=d1.bind(this),this._interceptControlDown=x1.bind(this),this._interceptControlUp=y1.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(e){this._cursorStyle=e,e==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=It.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(__),this.update(),this.state=It.NONE}pan(e,t){this._pan(e,t),this.update()}dollyIn(e){this._dollyIn(e),this.update()}dollyOut(e){this._dollyOut(e),this.update()}rotateLeft(e){this._rotateLeft(e),this.update()}rotateUp(e){this._rotateUp(e),this.update()}update(e=null){let t=this.object.position;In.copy(t).sub(this.target),In.applyQuaternion(this._quat),this._spherical.setFromVector3(In),this.autoRotate&&this.state===It.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(n)&&isFinite(s)&&(n<-Math.PI?n+=hi:n>Math.PI&&(n-=hi),s<-Math.PI?s+=hi:s>Math.PI&&(s-=hi),n<=s?this._spherical.theta=Math.max(n,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+s)/2?Math.max(n,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(In.setFromSpherical(this._spherical),In.applyQuaternion(this._quatInverse),t.copy(this.target).add(In),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=In.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new F(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new F(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=In.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(Kh.origin.copy(this.object.position),Kh.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Kh.direction))<a1?this.object.lookAt(this.target):(x_.setFromNormalAndCoplanarPoint(this.object.up,this.target),Kh.intersectPlane(x_,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Gf||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Gf||this._lastTargetPosition.distanceToSquared(this.target)>Gf?(this.dispatchEvent(__),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?hi/60*this.autoRotateSpeed*e:hi/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){In.setFromMatrixColumn(t,0),In.multiplyScalar(-e),this._panOffset.add(In)}_panUp(e,t){this.screenSpacePanning===!0?In.setFromMatrixColumn(t,1):(In.setFromMatrixColumn(t,0),In.crossVectors(this.object.up,In)),In.multiplyScalar(e),this._panOffset.add(In)}_pan(e,t){let n=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;In.copy(s).sub(this.target);let r=In.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*r/n.clientHeight,this.object.matrix),this._panUp(2*t*r/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),s=e-n.left,r=t-n.top,o=n.width,a=n.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientY),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(hi*this._rotateDelta.x/t.clientHeight),this._rotateUp(hi*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(hi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-hi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(hi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-hi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(n,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(n,s)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(n*n+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let n=this._getSecondPointerPosition(e),s=.5*(e.pageX+n.x),r=.5*(e.pageY+n.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(hi*this._rotateDelta.x/t.clientHeight),this._rotateUp(hi*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(n,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(n*n+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(e.pageX+t.x)*.5,a=(e.pageY+t.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new We,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,n={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function l1(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function c1(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function h1(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(y_),this.state=It.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function u1(i){let e;switch(i.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case ir.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=It.DOLLY;break;case ir.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=It.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=It.ROTATE}break;case ir.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=It.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=It.PAN}break;default:this.state=It.NONE}this.state!==It.NONE&&this.dispatchEvent(Vf)}function d1(i){switch(this.state){case It.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case It.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case It.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function f1(i){this.enabled===!1||this.enableZoom===!1||this.state!==It.NONE||(i.preventDefault(),this.dispatchEvent(Vf),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(y_))}function p1(i){this.enabled!==!1&&this._handleKeyDown(i)}function m1(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case sr.ROTATE:if(this.enableRotate===!1){this.state=It.NONE;break}this._handleTouchStartRotate(i),this.state=It.TOUCH_ROTATE;break;case sr.PAN:if(this.enablePan===!1){this.state=It.NONE;break}this._handleTouchStartPan(i),this.state=It.TOUCH_PAN;break;default:this.state=It.NONE}break;case 2:switch(this.touches.TWO){case sr.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=It.TOUCH_DOLLY_PAN;break;case sr.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=It.TOUCH_DOLLY_ROTATE;break;default:this.state=It.NONE}break;default:this.state=It.NONE}this.state!==It.NONE&&this.dispatchEvent(Vf)}function g1(i){switch(this._trackPointer(i),this.state){case It.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case It.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case It.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case It.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=It.NONE}}function _1(i){this.enabled!==!1&&i.preventDefault()}function x1(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function y1(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var v1=.001,b1=.003,M1=6,S1=`
uniform float top; uniform vec2 slope; varying vec2 at;
void main() {
  at = position.xy - max(position.z - top, 0.0) * slope;
  gl_Position = projectionMatrix * viewMatrix * vec4(at, top + ${b1.toFixed(4)}, 1.0);
}`,w1=`
uniform vec4 field; uniform vec2 turn; uniform float dark; varying vec2 at;
void main() {
  vec2 away = at - field.xy;
  if (abs(dot(away, turn)) > field.z || abs(dot(away, vec2(-turn.y, turn.x))) > field.w) discard;
  gl_FragColor = vec4(0.0, 0.0, 0.0, dark);
}`,jh=class{root=new Rn;constructor(e,t,n,s,r){t.filter(({kind:a,colour:l})=>(a==="plane"||a==="box")&&l[3]===1).forEach(a=>{let l=new ct().fromArray(a.rotation).premultiply(n[a.body].quaternion),c=new F(0,0,1).applyQuaternion(l),h=new F(1,0,0).applyQuaternion(l);if(c.z<1-v1||this.root.children.length>=M1)return;let u=new F().fromArray(a.position).applyQuaternion(n[a.body].quaternion).add(n[a.body].position),d=this.root.children.length+1,f=new Ci({vertexShader:S1,fragmentShader:w1,transparent:!0,depthWrite:!1,side:Kn,stencilWrite:!0,stencilRef:d,stencilFunc:Vd,stencilZPass:Gd,uniforms:{top:{value:u.z+(a.kind==="box"?a.size[2]:0)},slope:{value:new We(s.x/s.z,s.y/s.z)},field:{value:new Xt(u.x,u.y,a.size[0],a.size[1])},turn:{value:new We(h.x,h.y).normalize()},dark:{value:r}}}),p=new Ce(e,f);p.frustumCulled=!1,this.root.add(p)})}dispose(){this.root.removeFromParent();for(let e of this.root.children)e.material.dispose()}};var Xf={haze:[.9,.915,.93],zenith:[.6,.69,.78],ground:12168090,sky:16054527,bright:1},qf={haze:[.17,.185,.21],zenith:[.07,.08,.1],ground:9274488,sky:14674165,bright:.78},b_=i=>{let e={alpha:!1,antialias:!1,stencil:!0,powerPreference:"high-performance"},t=a=>{let l=a.getExtension("WEBGL_debug_renderer_info");return/swiftshader|llvmpipe|softpipe|software|basic render/i.test(String(a.getParameter(l?l.UNMASKED_RENDERER_WEBGL:a.RENDERER)))},n=i,s=i.getContext("webgl2",e);if(!s)throw new Error("no WebGL 2");let r=t(s);r||(n=i.cloneNode(),i.replaceWith(n),s.getExtension("WEBGL_lose_context")?.loseContext(),s=n.getContext("webgl2",{...e,antialias:!0,stencil:!1}));let o=new Sh({canvas:n,context:s});return o.debug.checkShaderErrors=!1,r||o.setPixelRatio(Math.min(window.devicePixelRatio,2)),o.shadowMap.enabled=!0,o.shadowMap.type=r?Md:Ar,o.toneMapping=ka,{canvas:n,renderer:o,software:r}},Wf=new F(2.6,-3.2,5.2),v_=new F(-2,3,2.5),Qh=class{scene=new ba;sun=new Co(16774370,2.3);sky=new Fa(16054527,12168090,1.9);fill=new Co(14674431,.5);dome;constructor(e,t=Xf,n=!1){this.dome=new $n(150+20*e,32,24).rotateX(Math.PI/2),this.dome.setAttribute("color",new en(new Float32Array(this.dome.attributes.position.count*3),3));let s={vertexColors:!0,side:Gn,fog:!1,toneMapped:!1},r=new Ce(this.dome,new pn(s));r.renderOrder=1,this.scene.add(r),this.scene.fog=new va(0,4+2*e,22+6*e);let{sun:o}=this;o.castShadow=!0,o.shadow.mapSize.setScalar(n?1024:2048),Object.assign(o.shadow,{bias:-4e-4,normalBias:.012,radius:2.5}),Object.assign(o.shadow.camera,{left:-2.6,right:2.6,top:2.6,bottom:-2.6,near:.5,far:16}),this.fill.position.copy(v_),this.scene.add(this.sky,o,o.target,this.fill),this.light(t)}light(e){let t=new Qe().setRGB(...e.haze,Sn),n=new Qe().setRGB(...e.zenith,Sn);this.scene.background=t,this.scene.fog.color.copy(t),this.sun.intensity=2.3*(.4+.6*e.bright),this.sky.intensity=1.9*e.bright,this.sky.color.set(e.sky),this.sky.groundColor.set(e.ground);let s=this.dome.attributes.position,r=this.dome.attributes.color,o=new Qe;for(let a=0;a<s.count;a++){let l=Math.max(0,s.getZ(a))/this.dome.parameters.radius;o.copy(t).lerp(n,Math.min(1,1.3*l)).toArray(r.array,3*a)}r.needsUpdate=!0}follow(e){this.sun.target.position.copy(e),this.sun.position.copy(e).add(Wf)}get sunward(){return Wf}set shadows(e){this.sun.castShadow=e}get shade(){let e=this.onGround(!0);return 1-(this.onGround(!1).g/e.g)**(1/2.2)}onGround(e=!0){let t=(o,a)=>o.color.clone().multiplyScalar(o.intensity*a.z/a.length()),{sky:n}=this,s=.5+.5*n.position.clone().normalize().z,r=n.groundColor.clone().lerp(n.color,s).multiplyScalar(n.intensity).add(t(this.fill,v_));return(e?r.add(t(this.sun,Wf)):r).multiplyScalar(1/Math.PI)}};var M_={quarter:[.62,-1,.32],side:[0,-1,.08],left:[0,1,.08],front:[1,0,.08],back:[-1,0,.08],top:[-.001,0,1]};var E1=140,T1=14,S_=45,A1=18,R1=30,w_=220,C1=900,P1=90,I1=130,eu=[.4,.55,.75,1],L1=.75,D1=1.4,tu=class{drawing=b_(Me("view"));canvas=this.drawing.canvas;software=this.drawing.software;renderer=this.drawing.renderer;around=new Qh(4,qf,this.software);camera=new si(32,1,.03,900);orbit;extra=new Rn;figure=null;override=null;sights=[];longest=0;images=0;shapes=null;still=null;sides={};ghosts=[];melting=null;previous=null;wanted=!0;step=this.software?1:eu.length-1;quick=0;drawnAt=eu[this.step];box=[0,0];cast=null;stamp=0;moved=0;then=null;centre=new F;aimed=!1;mix={position:new Float32Array(0),rotation:new Float32Array(0)};constructor(){let{camera:e}=this;e.up.set(0,0,1),this.orbit=new Jh(e,this.canvas),Object.assign(this.orbit,{enableDamping:!0,dampingFactor:.15,minDistance:.25,maxDistance:90,maxPolarAngle:.97*Math.PI}),this.orbit.addEventListener("change",()=>this.draw()),this.around.scene.add(this.extra),R.on("stage",()=>this.build()),R.on("path",()=>this.arrived()),R.on(["time","which","selection","document"],()=>this.draw()),R.on("loaded",()=>this.haunt()),R.on("shown",()=>this.haunt()),R.on("theme",()=>{this.around.light(document.documentElement.dataset.theme==="light"?Xf:qf),this.cast?.dispose(),this.cast=null,this.draw()}),new ResizeObserver(()=>this.resize()).observe(this.canvas.parentElement),this.resize(),requestAnimationFrame(this.tick)}draw(){this.wanted=!0}aim(e){let t=R.stage?.size??1.7;this.centre.copy(this.middle()),this.orbit.target.copy(this.centre);let n=2.5*Math.max(.4,t)/Math.min(1,this.camera.aspect*.9);this.camera.position.copy(this.centre).addScaledVector(new F(...M_[e]).normalize(),n),this.orbit.update(),this.draw()}placeOf(e,t){let n=this.figure.groups[e];return new F().fromArray(t).applyQuaternion(n.quaternion).add(n.position)}build(){let{stage:e}=R;if(!e)return;for(let s of[this.figure,this.still,...Object.values(this.sides).map(r=>r.figure),...this.ghosts])s?.dispose();this.cast?.dispose(),this.cast=null,this.shapes?.dispose();let t=this.shapes=new Th(e,this.software?1:this.renderer.capabilities.getMaxAnisotropy(),()=>this.draw(),this.software?G0:pf),n=e.pieces.filter(s=>!s.still);this.still=new or(e.bodies,e.pieces.filter(s=>s.still),t),this.figure=new or(e.bodies,n,t,void 0,this.software),this.sides={before:{figure:new or(e.bodies,n,t,Ah(14706239,.42)),path:()=>R.raw},snapshot:{figure:new or(e.bodies,n,t,Ah(5218272,.45)),path:()=>R.snapshot}},this.ghosts=[],this.around.scene.add(this.still.root,this.figure.root,...Object.values(this.sides).map(s=>s.figure.root)),this.melting=null,this.previous=null,this.haunt(),this.draw()}haunt(){for(let s of this.ghosts)s.root.visible=!1;let{stage:e,document:t,now:n}=R;if(R.ghosts&&e&&this.shapes&&t&&n){let s=Math.ceil(t.keys.length/T1),r=e.pieces.filter(o=>!o.still);t.keys.filter((o,a)=>a%s===0).forEach((o,a)=>{this.ghosts[a]||(this.ghosts[a]=new or(e.bodies,r,this.shapes,Ah(9417945,.2,.08)),this.around.scene.add(this.ghosts[a].root)),this.ghosts[a].root.visible=!0,this.ghosts[a].put(n.at(o.time))})}this.draw()}arrived(){let{now:e}=R;e&&e!==this.previous&&(this.previous&&this.previous.bodies===e.bodies&&(this.melting={from:this.previous,began:performance.now()}),this.previous=e,!this.aimed&&R.stage&&(this.aimed=!0,this.aim("quarter")),R.ghosts&&this.haunt()),this.draw()}pose(e){if(this.override)return this.override;let{now:t}=R;if(!t||t.bodies!==this.figure?.groups.length)return null;let n=t.at(R.time);if(!this.melting)return n;let s=(e-this.melting.began)/E1;return s>=1?(this.melting=null,n):(this.mix.position.length!==n.position.length&&(this.mix.position=new Float32Array(n.position.length),this.mix.rotation=new Float32Array(n.rotation.length)),Rh(this.melting.from.at(R.time),n,s*s*(3-2*s),this.mix),this.wanted=!0,this.mix)}middle(){let{now:e}=R;if(!e)return new F(0,0,.8);let[t,n,s]=e.centreAt(R.time);return new F(t,n,s)}tick=e=>{if(requestAnimationFrame(this.tick),R.playing){if(this.then!==null){let r=e-this.then;this.longest=Math.max(this.longest,r);let o=R.time+Math.min(250,r)/1e3*R.speed;o>R.last&&!R.loop?(R.playing=!1,R.seek(R.last)):R.seek(o>R.last?R.first+(o-R.first)%Math.max(.001,R.last-R.first):o)}this.then=R.playing?e:null}else this.then=null;this.orbit.update();let t=this.software&&(R.status.state==="searching"||R.status.state==="loaded"||X0()),n=this.software&&R.status.state==="loading",s=t&&(!this.override||q0())&&e-Math.max(this.moved,xf)<(R.playing?P1:I1);if(!this.figure||!(R.now||this.override)||s){this.stamp=e;return}this.wanted?(this.pace(e),this.render(e,eu[this.step]),this.moved=e):this.drawnAt<this.finest&&e-this.moved>(t||n?C1:w_)&&this.render(e,this.finest),this.stamp=e};get finest(){return this.software?D1:1}pace(e){let t=e-this.stamp;e-this.moved>2*w_||(this.quick=t<A1?this.quick+1:0,t>S_?this.step=Math.max(0,this.step-(t>2.5*S_?2:1)):this.quick>=R1&&(this.quick=0,this.step=Math.min(eu.length-1,this.step+1)))}simplified(e){let{still:t,figure:n,around:s}=this;if(!this.software||!t||!n)return;s.shadows=!e;let r=s.onGround();for(let{mesh:o,part:a}of t.planes)a.plain.color.copy(a.plain.userData.own).multiply(r),o.material=e?a.plain:a.material;if(!this.cast&&n.outline&&R.stage){let o=R.stage.pieces.filter(a=>a.still);this.cast=new jh(n.outline.mesh.geometry,o,t.groups,s.sunward,s.shade),s.scene.add(this.cast.root)}this.cast&&(this.cast.root.visible=e&&n.root.visible)}render(e,t){this.wanted=!1,this.take(t);let n=this.pose(e);if(this.figure&&n){this.figure.isRough=this.software&&t<=L1,this.figure.put(n),this.still?.put(n),this.figure.root.visible=R.which!=="before"||this.override!==null;for(let[a,l]of Object.entries(this.sides)){let c=l.path(),h=a==="before"?R.which==="before"||R.which==="both":R.which==="snapshot";l.figure.root.visible=h&&c!==null&&c.bodies===l.figure.groups.length,l.figure.root.visible&&l.figure.put(c.at(R.time))}}let s=this.middle();if(R.follow&&!this.override){let a=s.clone().sub(this.centre);this.camera.position.add(a),this.orbit.target.add(a)}this.centre.copy(s),this.around.follow(s);for(let a of this.sights)a();this.simplified(t<this.finest);let{renderer:r}=this,o=this.around.scene;R.which==="side"?this.renderHalves(...r.getSize(new We).toArray()):r.render(o,this.camera),this.images+=1}renderHalves(e,t){let{renderer:n,camera:s}=this,r=Math.floor(e/2);n.setScissorTest(!0),s.aspect=r/t,s.updateProjectionMatrix();let o=this.sides.before?.figure,a=this.figure;for(let[l,c]of[[0,!0],[r,!1]])n.setViewport(l,0,r,t),n.setScissor(l,0,r,t),c&&o&&a&&R.raw?a.put(R.raw.at(R.time)):a&&R.now&&a.put(R.now.at(R.time)),n.render(this.around.scene,s);n.setScissorTest(!1),n.setViewport(0,0,e,t),s.aspect=e/t,s.updateProjectionMatrix()}take(e){e!==this.drawnAt&&(this.drawnAt=e,this.sized())}sized(){let[e,t]=this.box,n=this.drawnAt*(this.software?1:Math.min(window.devicePixelRatio,2));e&&t&&this.renderer.setDrawingBufferSize(e,t,n)}resize(){let e=this.canvas.parentElement.getBoundingClientRect();!e.width||!e.height||e.width===this.box[0]&&e.height===this.box[1]||(this.box=[e.width,e.height],this.sized(),this.camera.aspect=e.width/e.height,this.camera.updateProjectionMatrix(),this.draw())}};var E_=[7128319,16753756,9167499,16748467,13215999,16769162,8380628],N1=16119285,nu=class{constructor(e){this.stage=e;e.extra.add(this.lines,this.dots),R.on(["path","shown","stage","document"],()=>this.draw()),e.sights.push(()=>this.colour())}stage;lines=new Rn;dots=new Rn;spot=new $n(.016,12,8);paints={rests:new pn({color:6280077,depthTest:!1,transparent:!0}),stands:new pn({color:5809919,depthTest:!1,transparent:!0}),free:new pn({color:10134704,depthTest:!1,transparent:!0,opacity:.5})};ends(){let{stage:e}=R;if(!e)return[];let t=n=>e.sites.filter(s=>s.body===n).at(-1);return e.limbs.filter(n=>n.name!=="root and trunk").map(n=>t(n.end)??e.soles.find(s=>s.body===n.end)??{name:n.name,body:n.end,offset:[0,0,0]})}draw(){for(let n of[...this.lines.children])n.removeFromParent(),n.geometry.dispose();let{now:e,stage:t}=R;R.trails&&e&&t&&e.bodies===t.bodies.length&&(this.ends().forEach((n,s)=>this.line(this.places(e,n),E_[s%E_.length])),this.line(Array.from({length:e.count},(n,s)=>new F().fromArray(e.centre,3*s)),N1)),this.stage.draw()}places(e,t){let n=new ct,s=new F().fromArray(t.offset);return Array.from({length:e.count},(r,o)=>{let a=o*e.bodies+t.body;return s.clone().applyQuaternion(n.fromArray(e.rotation,4*a)).add(new F().fromArray(e.position,3*a))})}line(e,t){let n=new ss({color:t,transparent:!0,opacity:.85});this.lines.add(new oi(new Pt().setFromPoints(e),n));let{now:s,document:r}=R;if(!s||!r)return;let o=r.keys.map(l=>e[Math.min(e.length-1,Math.max(0,Math.round((l.time-s.first)*s.rate)))]),a=new Ro({color:t,size:5,sizeAttenuation:!1});this.lines.add(new Ea(new Pt().setFromPoints(o),a))}colour(){let{stage:e,loaded:t,document:n,time:s}=R,o=R.trails&&e!==null&&this.stage.figure!==null?e.soles:[];for(;this.dots.children.length<o.length;){let a=new Ce(this.spot,this.paints.free);a.renderOrder=9,this.dots.add(a)}this.dots.children.forEach((a,l)=>{if(a.visible=l<o.length,!a.visible)return;let c=o[l],h=f=>f.from-1e-6<=s&&s<=f.to+1e-6,u=n?.contacts.some(f=>f.point===c.name&&h(f)),d=t?.stances.some(f=>f.point===c.name&&h(f));a.material=this.paints[u?"rests":d?"stands":"free"],a.position.copy(this.stage.placeOf(c.body,c.offset))})}};var T_=()=>{let i=localStorage.getItem("dynsplines-theme")??"dark";document.documentElement.dataset.theme=i};T_();ja();try{let i=new tu,e=new Xh(i),t=new Yh(i),n=new Zh(i),s=new Fh;new nu(i),h_(i,s),c_(),$0(s),J0(),g_(i,s,n,t),Me("files").prepend(Al("menu")),Me("theme").append(Al("theme")),Me("theme").addEventListener("click",()=>{localStorage.setItem("dynsplines-theme",document.documentElement.dataset.theme==="light"?"dark":"light"),T_(),R.tell("theme")}),R.on("stage",()=>{Me("waiting").hidden=!0}),R.on("status",()=>{!R.stage&&R.status.words&&(Me("waiting").textContent=R.status.words,Me("waiting").hidden=!1)}),R.tell("theme"),Object.assign(window,{studio:{ask:ai,model:R,stage:i,hands:n,handles:t,gizmo:e,timeline:s}})}catch(i){Me("waiting").replaceChildren(ae("p",{text:`This browser cannot draw in three dimensions: WebGL 2 is missing or switched off. (${i})`}))}
