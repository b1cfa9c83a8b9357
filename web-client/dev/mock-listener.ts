/** The sockets of the mock server: HTTP for REST, WebSocket for the stream. */
import { once } from 'node:events';
import { createServer, type IncomingMessage, type ServerResponse } from 'node:http';
import type { AddressInfo } from 'node:net';
import { WebSocketServer } from 'ws';
import { readRest, readStream } from './description';
import { MockCloud } from './mock-cloud';
import { MockRest } from './mock-rest';
import { MockStream } from './mock-stream';

export interface ListenerOptions {
  /** 0: any that is free. */
  readonly port: number;
  /** 0: any that is free. */
  readonly streamPort: number;
  readonly drones: number;
  /** Where tiles of maps are; null: nowhere. */
  readonly tileAddress: string | null;
  /** Called with the reason when a message is not as it is described. */
  readonly breach: (sentence: string) => void;
}

export interface Listener {
  /** Without a path. */
  readonly address: string;
  readonly streamAddress: string;
  readonly cloud: MockCloud;
  readonly rest: MockRest;
  close(): Promise<void>;
}

export async function listen(options: ListenerOptions): Promise<Listener> {
  const { breach, drones, tileAddress } = options;
  const host = '127.0.0.1';
  const sockets = new WebSocketServer({ port: options.streamPort, host });
  await once(sockets, 'listening');
  const { port: streamPort } = sockets.address() as AddressInfo;
  const cloud: MockCloud = new MockCloud({
    drones,
    tileAddress,
    streamPort: () => streamPort,
    broadcast: (message) => stream.broadcast(message),
  });
  const stream = new MockStream(readStream(), {
    greeting: () => cloud.greeting(),
    answer: (request) => cloud.answer(request),
    phoneLeft: () => cloud.phoneLeft(),
    breach,
  });
  const rest = new MockRest(readRest(), {
    handlers: cloud.handlers,
    signedIn: () => cloud.accounts.session !== null,
    breach,
  });
  sockets.on('connection', (client) => stream.accept(client));
  const server = createServer((request, response) => void serve(rest, request, response));
  server.listen(options.port, host);
  await once(server, 'listening');
  cloud.run();
  return {
    address: `http://${host}:${(server.address() as AddressInfo).port}`,
    streamAddress: `ws://${host}:${streamPort}/stream`,
    cloud,
    rest,
    close: async () => {
      cloud.close();
      sockets.clients.forEach((client) => client.terminate());
      server.closeAllConnections();
      const closed = [once(server, 'close'), once(sockets, 'close')];
      server.close();
      sockets.close();
      await Promise.all(closed);
    },
  };
}

async function serve(rest: MockRest, request: IncomingMessage, response: ServerResponse): Promise<void> {
  const chunks: Buffer[] = [];
  for await (const chunk of request) {
    chunks.push(chunk as Buffer);
  }
  const { method = 'GET', url = '/', headers } = request;
  const { status, type, body } = rest.answer({
    method,
    url,
    headers,
    text: Buffer.concat(chunks).toString(),
  });
  response.writeHead(status, type === null ? {} : { 'Content-Type': type });
  response.end(type === null ? '' : typeof body === 'string' ? body : JSON.stringify(body));
}
