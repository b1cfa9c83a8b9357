// A development tool: plays the pinned descriptions of REST and of the stream, so that the page can be worked on without a
// server. Never shipped. `npm run mock`, then `DRONEMAP_SERVER=http://127.0.0.1:8090 npm run dev`.
// Signs in anybody with the password "flight-deck"; "first-password" asks for a new one. The user "viewer" is one.
import { listen } from './mock-listener';

const port = Number(process.env['DRONEMAP_MOCK_PORT'] ?? 8090);

const { address, streamAddress, cloud } = await listen({
  port,
  streamPort: port + 1,
  drones: Number(process.env['DRONEMAP_MOCK_DRONES'] ?? 4),
  tileAddress: process.env['DRONEMAP_TILES'] ?? null,
  breach: (sentence) => {
    console.error(`Not sent, as the description does not have it: ${sentence}`);
    process.exitCode = 1;
  },
});
console.log(`Mock cloud on ${address}, stream on ${streamAddress}`);

// One drone falls silent and comes back, for the eyes.
if (process.env['DRONEMAP_MOCK_SILENT'] === '1' && cloud.drones[1] !== undefined) {
  cloud.drones[1].silentSince = Date.now();
}
