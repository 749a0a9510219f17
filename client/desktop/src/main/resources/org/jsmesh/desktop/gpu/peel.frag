#version 330 core
#extension GL_ARB_sample_shading : require
// Finds the next layer of translucent surfaces: what lies behind the layer before, and before all that is opaque. At each
// sample, because edges of layers have samples on either side.

uniform sampler2DMS opaque;
uniform sampler2DMS before;
uniform bool isFirst;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    if (gl_FragCoord.z > texelFetch(opaque, pixel, gl_SampleID).r) discard;
    if (!isFirst && gl_FragCoord.z <= texelFetch(before, pixel, gl_SampleID).r) discard;
}
