import { defineConfig } from 'vitest/config';

export default defineConfig({
  test: {
    restoreMocks: true,
    environment: 'node',
    testTimeout: 30_000,
    include: ['src/**/*.test.ts', 'dev/**/*.test.ts'],
  },
});
