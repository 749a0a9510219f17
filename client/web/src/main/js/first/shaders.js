// @ts-check
// A surface under the light of three/lights.js, in few operations. Terms and tone are those of three.js; its tables are
// approximated by functions that were fitted to them.

import { FACING } from './light.js';

/** The lamps of the studio: direction and strength. A rough surface mirrors each as a lobe (Wang and others 2009). */
const LAMPS = [
  [-0.68, 0.65, 0.34, 0.088],
  [-0.599, 0.733, -0.321, 0.085],
  [0.761, 0.645, -0.071, 0.188],
  [-0.015, 0.518, 0.855, 0.486],
  [0.119, 0.7, -0.704, 0.091],
  [0.013, 1, 0.018, 0.188],
];
const LOBES = LAMPS.map(([x, y, z, strength]) => `+${strength}*exp(k*(dot(d,vec3(${x},${y},${z}))-1.))`).join('');

export const VERTEX = `#version 300 es
layout(location=0) in vec3 position;
layout(location=1) in vec3 normal;
layout(location=2) in vec4 colour;
uniform mat4 view, projection;
uniform mat3 rig;
uniform vec3 center;
out vec3 vEye, vNormal;
out vec4 vColour;
void main(){
  vec4 eye=view*vec4(rig*(position-center)+center,1);
  vEye=eye.xyz;
  vNormal=mat3(view)*(rig*normal);
  vec3 c=colour.rgb;
  vColour=vec4(mix(c/12.92,pow((c+.055)/1.055,vec3(2.4)),step(.04045,c)),colour.a);
  gl_Position=projection*eye;
}`;

export const FRAGMENT = `#version 300 es
precision highp float;
in vec3 vEye, vNormal;
in vec4 vColour;
uniform mat4 view;
uniform vec4 base;
uniform vec3 emission, key;
uniform float metal, rough;
uniform bool coloured, isFlat, isMatte, showsNormals;
out vec4 pixel;
const float PI=3.14159265;
// Light from all sides that a surface of roughness r mirrors from direction d; a matte one gets that of 1.
float studio(vec3 d,float r){
  float k=exp((.732*r-4.823)*r+5.523);
  return .45*max(0.,dot(vec4(d,1),vec4(.042,-.372,.087,.47)+r*vec4(-.022,.118,-.041,-.006))+k*(0.${LOBES}));
}
vec3 toned(vec3 c){
  c*=.92;
  float least=min(c.r,min(c.g,c.b));
  c-=least<.08?least-6.25*least*least:.04;
  float peak=max(c.r,max(c.g,c.b));
  if(peak<.76)return c;
  float lower=1.-.0576/(peak-.52);
  return mix(vec3(lower),c*lower/peak,1./(.15*(peak-lower)+1.));
}
void main(){
  vec3 toEye=normalize(-vEye);
  vec3 n=cross(dFdx(vEye),dFdy(vEye));
  n=n==vec3(0)?toEye:normalize(n);
  if(!isFlat&&vNormal!=vec3(0)){
    n=normalize(vNormal);
    ${FACING}
  }
  if(showsNormals){pixel=vec4(n*.5+.5,1);return;}
  vec4 c=coloured?base*vColour:base;
  float up=dot(n,view[1].xyz)*.5+.5;
  float lit=clamp(dot(n,key),0.,1.);
  vec3 sent;
  if(isMatte)sent=c.rgb*(mix(vec3(.2,.19,.18),vec3(.62,.64,.66),up)+lit*vec3(.5,.49,.46));
  else{
    vec3 f0=mix(vec3(.04),c.rgb,metal),matte=c.rgb*(1.-metal);
    vec3 sun=vec3(1,.905,.791)*2.1*lit;
    vec3 h=normalize(key+toEye);
    vec3 bend=max(abs(dFdx(n)),abs(dFdy(n)));
    float r=min(max(rough,.0525)+max(bend.x,max(bend.y,bend.z)),1.),a=r*r,q=a*a;
    float eye=clamp(dot(n,toEye),0.,1.),tilt=clamp(dot(n,h),0.,1.),spread=tilt*tilt*(q-1.)+1.;
    float hidden=lit*sqrt(q+(1.-q)*eye*eye)+eye*sqrt(q+(1.-q)*lit*lit);
    vec3 gloss=mix(f0,vec3(1),pow(1.-clamp(dot(toEye,h),0.,1.),5.))*q/(PI*spread*spread)*.5/max(hidden,1e-6);
    // Of the light from all sides, what is reflected once, and after that again.
    float edge=exp2((4.486*r-8.479)*eye+.248-(2.738+3.995*r)*r),lost=-.014+r*(.262-.133*r+eye*(1.249*r-.053-.582*eye));
    vec3 once=f0*(1.-lost-edge)+edge,mean=f0+(1.-f0)/21.,again=once*mean*lost/(1.-lost*mean),all=once+again;
    mat3 back=transpose(mat3(view));
    float around=studio(back*n,1.);
    sent=sun*(matte/PI+gloss)+matte*.55*mix(vec3(.266,.231,.188),vec3(1),up)/PI
      +matte*(1.-max(all.r,max(all.g,all.b)))*around+again*around+once*studio(back*normalize(mix(reflect(-toEye,n),n,q)),r);
    sent=toned(sent+emission);
  }
  vec3 s=clamp(sent,0.,1.);
  pixel=vec4(mix(12.92*s,1.055*pow(s,vec3(1./2.4))-.055,step(.0031308,s))*c.a,c.a);
}`;
