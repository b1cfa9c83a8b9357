/** Lets the phone page open without a network. Only encrypted pages may have such a worker; others do without. */
export async function registerWorker(
  workers: ServiceWorkerContainer | undefined = (navigator as { serviceWorker?: ServiceWorkerContainer })
    .serviceWorker,
): Promise<void> {
  try {
    await workers?.register('./follow-worker.js', { scope: './follow' });
  } catch (thrown) {
    // The page works without it as long as there is a network.
    console.info('This browser keeps no copy of the page:', thrown);
  }
}
