// What a scene shows, in a sentence each.
export const captions = Object.freeze({
  'five-coats': 'Five spheres, five coats: four kinds of fur on one body, the fifth trimmed short and piebald.',
  'shells-8': 'Fur drawn in 8 layers: from the side the gaps between them show.',
  'shells-16': 'Fur drawn in 16 layers: smoother, with gaps only where the fur is long.',
  'shells-32': 'Fur drawn in 32 layers: strands run through without a gap.',
  'fins-everywhere': 'The fins that stand out from every edge of the model, on their own.',
  'fins-outline': 'Only the fins that are drawn: those at the outline, where layers would come apart.',
  fading: 'Fur thins out towards bald skin, one strand after the other, without a border.',
  variance: 'Left every strand is alike; right, colour and length vary from strand to strand.',
  interpolation: 'One kind of fur runs into another, and that into a third, over a curved body.',
  'wet-bunny': 'A bunny that has been out in the rain: wet clumps, dark and glossy, drying while you watch.',
  'half-wet': 'One half soaked, the other dry: where they meet, single clumps stand apart.',
  'wet-letters': 'Letters of water: each drop ties one clump, and the clumps spell a word.',
  'wet-straight': 'Clumps tied by water whose strands lean in straight (clump shape 0).',
  'wet-bent': 'Clumps tied by water whose strands bend in from the root (clump shape 1).',
  'wet-tile': 'A patch of fur, dry and with drops on it, seen from above.',
});
