package org.dronemap.ws.testserver;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;

/** Lets what happens beside a request wait until the request is answered: otherwise the answer would be a matter of luck. */
public final class ResponseLatch {
    private static final int PATIENCE_SECONDS = 10;

    private volatile CountDownLatch open = new CountDownLatch(0);

    public void shut() {
        open = new CountDownLatch(1);
    }

    public void open() {
        open.countDown();
    }

    /** Goes on at once while it is open. */
    public void pass() {
        try {
            if (!open.await(PATIENCE_SECONDS, TimeUnit.SECONDS)) {
                throw new IllegalStateException("nobody opened the gate");
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
