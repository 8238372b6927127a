// Added up in the picture: red is full at 3, green at 9, blue at 27.
vec4 heat(float amount) { return vec4(amount / vec3(3.0, 9.0, 27.0), 0.0); }
