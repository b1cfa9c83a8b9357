package org.dronemap.ws.server;

import java.util.ArrayDeque;
import java.util.Deque;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Closes resources in the reverse order of their opening; one that fails does not stop the others. */
public final class ShutdownSequence implements AutoCloseable {
    private static final Logger LOG = LoggerFactory.getLogger(ShutdownSequence.class);

    // guarded by this
    private final Deque<Step> steps = new ArrayDeque<>();

    private record Step(String name, AutoCloseable resource) {}

    public synchronized void add(String name, AutoCloseable resource) {
        steps.push(new Step(name, resource));
    }

    /** The same resource, which is closed in its turn from now on. */
    <T extends AutoCloseable> T adding(String name, T resource) {
        add(name, resource);
        return resource;
    }

    @Override
    public synchronized void close() {
        while (!steps.isEmpty()) {
            Step step = steps.pop();
            try {
                step.resource().close();
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
                LOG.warn("Closing {} was interrupted", step.name());
            } catch (Exception e) {
                LOG.error("Closing {} failed", step.name(), e);
            }
        }
    }
}
