import { createApp } from 'vue';
import 'wet-fur/companions';
import 'wet-fur/element';
import App from './App.vue';

createApp(App).mount('#app');
