import { defineConfig } from 'vitest/config';

export default defineConfig({
  test: { restoreMocks: true, environment: 'node', include: ['src/**/*.test.ts', 'dev/**/*.test.ts'] },
});
