import { fileURLToPath } from 'node:url';
import { svelte } from '@sveltejs/vite-plugin-svelte';
import { svelteTesting } from '@testing-library/svelte/vite';
import { defineConfig } from 'vitest/config';

const server = process.env['DRONEMAP_SERVER'] ?? 'http://127.0.0.1:8080';
const port = Number(process.env['DRONEMAP_WEB_PORT'] ?? 5173);

/** Beside the page: a service worker looks after what lies below it. */
const FOLLOW_WORKER = 'follow-worker';

/** The client, as its sources are: it is built with the page, and has no packages of its own. */
const client = fileURLToPath(new URL('../sdk-typescript/src/', import.meta.url));

export default defineConfig({
  plugins: [svelte()],
  resolve: { alias: { '@dronemap/client': `${client}index.ts` } },
  base: './',
  build: {
    target: 'es2022',
    chunkSizeWarningLimit: 1500,
    rolldownOptions: {
      input: { index: 'index.html', [FOLLOW_WORKER]: `src/follow/${FOLLOW_WORKER}.ts` },
      output: {
        entryFileNames: ({ name }) => (name === FOLLOW_WORKER ? '[name].js' : 'assets/[name]-[hash].js'),
      },
    },
  },
  worker: { format: 'es' },
  server: {
    host: '127.0.0.1',
    port,
    strictPort: true,
    fs: { allow: ['.', client] },
    proxy: { '/api': { target: server, changeOrigin: true } },
  },
  test: {
    restoreMocks: true,
    projects: [
      {
        extends: true,
        plugins: [svelteTesting()],
        test: { name: 'page', environment: 'happy-dom', css: true, include: ['src/**/*.test.ts'] },
      },
      // What runs on Node and in no browser: libraries that have a form for each are to be those for Node.
      { extends: true, test: { name: 'dev', environment: 'node', include: ['dev/**/*.test.ts'] } },
    ],
  },
});
