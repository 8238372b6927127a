// How long the coat is where a fragment is.
#ifdef GROOMED
in float vLength;  // a share of the fur length
float coatHere() { return furLength * vLength; }  // model units
#else
float coatHere() { return furLength; }
#endif
