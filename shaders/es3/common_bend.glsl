// Vertex shaders only. xyz: how far a vertex's strand is bent (model space, radians, across the normal)  w: the length
// of its fur, a share.
uniform sampler2D bends;

vec4 bendOf(int vertex) { return texelFetch(bends, ivec2(vertex % FUR_BEND_ROW, vertex / FUR_BEND_ROW), 0); }
