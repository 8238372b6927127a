import { mount } from 'svelte';
import 'wet-fur/companions';
import 'wet-fur/element';
import App from './App.svelte';

mount(App, { target: document.getElementById('app') });
