package org.dronemap.proxy.mavlink.procedure;

/** Is told of the acceptance and progress of an exchange with a vehicle. */
public interface ExchangeObserver {
    ExchangeObserver NONE = new ExchangeObserver() {};

    /** The vehicle took it and is at it. */
    default void accepted() {}

    /** Steps done of steps in all. */
    default void progress(int done, int total) {}
}
