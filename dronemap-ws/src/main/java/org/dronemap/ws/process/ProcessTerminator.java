package org.dronemap.ws.process;

import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.time.Clock;
import java.util.function.IntConsumer;
import org.jspecify.annotations.Nullable;

/**
 * Ends the server process when one of its threads dies of an error, as nothing else would do its work. Whoever started
 * it starts it again. What libraries fail with otherwise is told to the log.
 */
final class ProcessTerminator implements Thread.UncaughtExceptionHandler {
    /** As sysexits.h has it for a fault of the software itself. */
    static final int EXIT_CODE = 70;

    private static final FileOutputStream ERRORS = new FileOutputStream(FileDescriptor.err);

    private final ProcessStateFile run;
    private final Clock clock;
    private final IntConsumer halt;

    ProcessTerminator(ProcessStateFile run, Clock clock) {
        this(run, clock, Runtime.getRuntime()::halt);
    }

    ProcessTerminator(ProcessStateFile run, Clock clock, IntConsumer halt) {
        this.run = run;
        this.clock = clock;
        this.halt = halt;
    }

    @Override
    public void uncaughtException(Thread thread, Throwable thrown) {
        if (thrown instanceof Error) {
            boolean ofTheThread = !(thrown instanceof OutOfMemoryError);
            end(thread.getName(), "It ended with " + thrown + ".", ofTheThread, thrown);
        } else {
            write("The thread " + thread.getName() + " ended.", thrown);
        }
    }

    /** A part of the server cannot do its duty, and nothing helps but to start again. */
    void end(String part, String why) {
        end(part, why, false, null);
    }

    private void end(String part, String why, boolean ofThisThread, @Nullable Throwable thrown) {
        try {
            run.ending(clock.instant(), part, why, ofThisThread);
            write("The server ends, to be started again. " + part + ": " + why, thrown);
        } finally {
            halt.accept(EXIT_CODE);
        }
    }

    /** Past all loggers: a thread that ended may hold their locks for ever. */
    private void write(String sentence, @Nullable Throwable thrown) {
        StringWriter text = new StringWriter();
        text.append(clock.instant().toString())
                .append(" ERROR ")
                .append(sentence)
                .append(System.lineSeparator());
        if (thrown != null) {
            thrown.printStackTrace(new PrintWriter(text, true));
        }
        try {
            ERRORS.write(text.toString().getBytes(StandardCharsets.UTF_8));
        } catch (IOException e) {
            throw new UncheckedIOException("nobody is left to tell", e);
        }
    }
}
