package org.dronemap.core.time;

import java.util.Optional;

/**
 * Recognises fatal errors such as out of memory, and passes them to the handler that ends the process. What a thread
 * fails with in the end goes to its uncaught exception handler; libraries and executors keep some of it to themselves.
 */
public final class FatalErrors {
    private static final int DEEPEST = 20;

    private FatalErrors() {}

    /**
     * That thread, for a duty that nobody else would do: whatever ends it is told as an error. A thread that is stopped in a
     * lock, for one, ends with another exception.
     */
    public static Thread onDuty(Thread thread) {
        thread.setUncaughtExceptionHandler((ended, why) -> ended.getThreadGroup()
                .uncaughtException(ended, why instanceof Error ? why : new EssentialThreadEnded(why)));
        return thread;
    }

    /** Something ended a thread that had a duty. */
    private static final class EssentialThreadEnded extends Error {
        private static final long serialVersionUID = 1L;

        EssentialThreadEnded(Throwable why) {
            super(why.toString(), why);
        }
    }

    /** Gives it to who ends the process, as if this thread had ended with it. */
    public static void report(Error error) {
        Thread thread = Thread.currentThread();
        thread.getUncaughtExceptionHandler().uncaughtException(thread, error);
    }

    /** The same, for what a library caught, if there is such an error behind it; else nothing happens. */
    public static void reportCause(Throwable caught) {
        behind(caught).ifPresent(FatalErrors::report);
    }

    /** No memory, no threads, a machine that failed, a thread that was stopped; a stack that was too deep is gone again. */
    static Optional<Error> behind(Throwable caught) {
        Throwable cause = caught;
        for (int depth = 0; cause != null && depth < DEEPEST; depth++) {
            boolean ofTheMachine = cause instanceof VirtualMachineError && !(cause instanceof StackOverflowError);
            if (ofTheMachine || cause instanceof ThreadDeath) {
                return Optional.of((Error) cause);
            }
            cause = cause.getCause();
        }
        return Optional.empty();
    }
}
