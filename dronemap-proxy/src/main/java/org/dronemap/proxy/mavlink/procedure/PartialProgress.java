package org.dronemap.proxy.mavlink.procedure;

/** One part of a longer whole: what it tells of its progress counts on from the steps before it. */
public record PartialProgress(ExchangeObserver whole, int stepsBefore, int stepsInAll) implements ExchangeObserver {
    @Override
    public void accepted() {
        whole.accepted();
    }

    @Override
    public void progress(int done, int total) {
        whole.progress(Math.min(stepsBefore + done, stepsInAll), stepsInAll);
    }
}
