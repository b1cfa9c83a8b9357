package org.dronemap.proxy.mavlink.procedure;

/** Observer of one step of a longer exchange, which reports its progress as a part of the whole. */
public record StepProgressObserver(ExchangeObserver whole, int stepsBefore, int stepsInAll)
        implements ExchangeObserver {
    @Override
    public void accepted() {
        whole.accepted();
    }

    @Override
    public void progress(int done, int total) {
        whole.progress(Math.min(stepsBefore + done, stepsInAll), stepsInAll);
    }
}
