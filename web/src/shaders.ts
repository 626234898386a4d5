// SPDX-License-Identifier: Apache-2.0
// Every particle is one point, drawn as the sphere it stands for.

export const vertexShader = /* glsl */ `
attribute vec3 kind;               // category, size, value
attribute vec3 mirrored;           // 1 along the axes in whose planes of symmetry this is an image
uniform vec3 boxMinimum, boxSize;  // m
uniform vec3 mirrorPlaces;         // m
uniform vec4 clip;                 // keeps places with dot(clip.xyz, place) <= clip.w
uniform float halfHeight;          // of the picture, px
uniform bool byValue;
uniform bool ghosts;               // this pass draws the faint categories, or the others
uniform sampler2D categoryTable, valueTable, diameterTable;
varying vec3 colour;
varying float opacity, pixels, depth, radius;

void main() {
  vec4 category = texelFetch(categoryTable, ivec2(int(kind.x), 0), 0);
  vec3 place = boxMinimum + position * boxSize;
  place = mix(place, 2.0 * mirrorPlaces - place, mirrored);
  bool absent = category.a == 0.0 || (category.a < 1.0) != ghosts || dot(clip.xyz, place) > clip.w;
  if (absent) {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);  // outside the picture
    gl_PointSize = 0.0;
    return;
  }
  vec4 seen = modelViewMatrix * vec4(place, 1.0);
  float diameter = texelFetch(diameterTable, ivec2(int(kind.y), 0), 0).r;
  gl_Position = projectionMatrix * seen;
  pixels = diameter * projectionMatrix[1][1] * halfHeight / gl_Position.w;
  gl_PointSize = max(pixels + 0.75, 1.5);  // the soft edge takes half a pixel on each side
  depth = seen.z;
  radius = 0.5 * diameter;
  opacity = category.a;
  // Values are for what is whole: a ghost keeps the colour of its category.
  colour = byValue && !ghosts ? texelFetch(valueTable, ivec2(int(kind.z), 0), 0).rgb : category.rgb;
}
`;

export const fragmentShader = /* glsl */ `
uniform bool ghosts;
uniform mat4 projectionMatrix;
varying vec3 colour;
varying float opacity, pixels, depth, radius;

const vec3 light = vec3(-0.36, 0.58, 0.73);

void main() {
  vec2 at = vec2(2.0, -2.0) * gl_PointCoord - vec2(1.0, -1.0);
  // Particles of a few pixels fill their square: between discs the paper would shine through.
  float roundness = smoothstep(2.0, 5.0, pixels);
  float away = mix(max(abs(at.x), abs(at.y)), length(at), roundness);
  float cover = 1.0 - smoothstep(1.0 - 1.5 / max(pixels, 2.0) * roundness, 1.0, away);
  if (cover <= 0.0) discard;
  float towards = sqrt(max(1.0 - dot(at, at), 0.0));
  float lit = max(dot(vec3(at, towards), light), 0.0);
  float shade = mix(1.0, AMBIENT + (1.04 - AMBIENT) * lit, smoothstep(2.5, 9.0, pixels));
  gl_FragColor = vec4(colour * shade, ghosts ? opacity : cover);
#ifdef SPHERES
  float front = depth + radius * towards;
  float clipZ = projectionMatrix[2][2] * front + projectionMatrix[3][2];
  float clipW = projectionMatrix[2][3] * front + projectionMatrix[3][3];
  gl_FragDepth = clamp(0.5 * clipZ / clipW + 0.5, 0.0, 1.0);
#endif
}
`;
