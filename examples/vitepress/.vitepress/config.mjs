export default {
  title: 'Furry figures',
  vue: { template: { compilerOptions: { isCustomElement: (tag) => tag.startsWith('wet-fur') } } },
  vite: { optimizeDeps: { exclude: ['wet-fur'] } },
};
