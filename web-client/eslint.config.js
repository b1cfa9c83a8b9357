import js from '@eslint/js';
import prettier from 'eslint-config-prettier';
import svelte from 'eslint-plugin-svelte';
import globals from 'globals';
import ts from 'typescript-eslint';
import svelteConfig from './svelte.config.js';

/** What speaks to a server past the client, by its names as a global and as a member of one. */
const PAST_THE_CLIENT = ['fetch', 'WebSocket', 'XMLHttpRequest', 'EventSource'];
const message = 'The page speaks to the cloud by @dronemap/client alone.';

export default ts.config(
  { ignores: ['dist/', 'node_modules/'] },
  js.configs.recommended,
  ...ts.configs.strict,
  ...svelte.configs.recommended,
  prettier,
  ...svelte.configs.prettier,
  {
    languageOptions: { globals: { ...globals.browser, ...globals.node } },
    rules: {
      'max-lines': ['error', { max: 300 }],
      complexity: ['error', 12],
      eqeqeq: 'error',
      'no-undef': 'off',
      // Maps here are replaced, never changed in place: `$state.raw` sees that.
      'svelte/prefer-svelte-reactivity': 'off',
      '@typescript-eslint/no-unused-vars': ['error', { argsIgnorePattern: '^_' }],
    },
  },
  {
    files: ['src/**'],
    // These fetch files that the page itself consists of.
    ignores: ['src/**/*.test.ts', 'src/follow/follow-worker.ts', 'src/map/basemap.ts'],
    rules: {
      'no-restricted-globals': ['error', ...PAST_THE_CLIENT.map((name) => ({ name, message }))],
      'no-restricted-properties': [
        'error',
        ...['globalThis', 'window', 'self'].flatMap((object) =>
          PAST_THE_CLIENT.map((property) => ({ object, property, message })),
        ),
        { object: 'navigator', property: 'sendBeacon', message },
      ],
      'no-restricted-syntax': [
        'error',
        {
          selector: ':matches(Literal[value=/^.api.v1..+/], TemplateElement[value.raw=/^.api.v1..+/])',
          message: 'Addresses are those of operations: ask the client for one.',
        },
      ],
    },
  },
  {
    files: ['**/*.svelte', '**/*.svelte.ts'],
    languageOptions: {
      parserOptions: { parser: ts.parser, extraFileExtensions: ['.svelte'], svelteConfig },
    },
  },
);
