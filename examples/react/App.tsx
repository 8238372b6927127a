import { useRef, useState } from 'react';
import type { WetFurElement } from 'wet-fur/element';
import type {} from 'wet-fur/react';  // our tags in JSX

export function App() {
  const fur = useRef<WetFurElement>(null);
  const [wetness, setWetness] = useState(0);
  const [shown, setShown] = useState(true);
  return (
    <>
      <h1>A furry figure in React</h1>
      {shown && (
        <wet-fur ref={fur} id="fig" src="torus" alt="A furry ring. Click to wet its fur." tool="droplet" camera-controls
          onwetness-change={({ detail }) => setWetness(detail.wetness)}></wet-fur>
      )}
      <wet-fur-slider for="fig" setting="curl"></wet-fur-slider>
      <p>
        <button onClick={() => fur.current?.setWetness(1)}>Soak</button>
        <button onClick={() => setShown(!shown)}>{shown ? 'Take it away' : 'Bring it back'}</button>
        <output>{Math.round(100 * wetness)} % wet</output>
      </p>
    </>
  );
}
