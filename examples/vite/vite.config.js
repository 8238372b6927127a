import { defineConfig } from 'vite';

export default defineConfig({
  base: './',
  // Else the development server would take the scripts away from the programs beside them.
  optimizeDeps: { exclude: ['wet-fur'] },
});
