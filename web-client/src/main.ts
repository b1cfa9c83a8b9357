import '@fontsource-variable/inter/index.css';
import 'maplibre-gl/dist/maplibre-gl.css';
import './styles/tokens.css';
import './styles/base.css';
import { mount } from 'svelte';
import App from './App.svelte';
import { Station } from './state/station.svelte';

const target = document.getElementById('app');
if (target === null) {
  throw new Error('The page has no element "app".');
}
mount(App, { target, props: { station: new Station() } });
