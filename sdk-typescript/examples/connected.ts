// Where the examples find their server: DRONEMAP_URL, and DRONEMAP_KEY or the key that the server wrote for this machine.
import { readFileSync } from 'node:fs';
import { Dronemap } from '@dronemap/client';
import { WebSocket } from 'ws';

const LOCAL_KEY = new URL('../../.data/local-key', import.meta.url);

export function connected(): Promise<Dronemap> {
  const { DRONEMAP_URL: url = 'http://127.0.0.1:8080', DRONEMAP_KEY: key } = process.env;
  return Dronemap.connect({ url, key: key ?? readFileSync(LOCAL_KEY, 'utf8').trim(), WebSocket });
}
