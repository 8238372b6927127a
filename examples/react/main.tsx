import { createRoot } from 'react-dom/client';
import 'wet-fur/companions';
import 'wet-fur/element';
import { App } from './App';

createRoot(document.getElementById('app')!).render(<App />);
