package org.dronemap.bench.planning;

import java.lang.management.ManagementFactory;
import java.util.function.LongSupplier;

/**
 * CPU that a run may use, counted over the whole process: all its threads, compiler and collector included. Safe for
 * several threads.
 */
public final class CpuBudget {
    private static final double NANOS = 1e9;

    private final LongSupplier cpuNanos;
    private final long began;
    private final double seconds;

    private CpuBudget(double seconds, LongSupplier cpuNanos, long began) {
        this.seconds = seconds;
        this.cpuNanos = cpuNanos;
        this.began = began;
    }

    /** From the start of the process: loading and building count. */
    public static CpuBudget ofProcess(double seconds) {
        return new CpuBudget(seconds, processCpu(), 0);
    }

    /** From now on. */
    public static CpuBudget fromNow(double seconds) {
        return fromNow(seconds, processCpu());
    }

    static CpuBudget fromNow(double seconds, LongSupplier cpuNanos) {
        return new CpuBudget(seconds, cpuNanos, cpuNanos.getAsLong());
    }

    private static LongSupplier processCpu() {
        return ManagementFactory.getPlatformMXBean(com.sun.management.OperatingSystemMXBean.class)::getProcessCpuTime;
    }

    public double usedSeconds() {
        return (cpuNanos.getAsLong() - began) / NANOS;
    }

    public double seconds() {
        return seconds;
    }

    public double share() {
        return usedSeconds() / seconds;
    }

    public boolean isSpent() {
        return share() >= 1;
    }
}
