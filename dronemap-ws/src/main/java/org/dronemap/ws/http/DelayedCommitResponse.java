package org.dronemap.ws.http;

import jakarta.servlet.ServletOutputStream;
import jakarta.servlet.WriteListener;
import jakarta.servlet.http.HttpServletResponse;
import jakarta.servlet.http.HttpServletResponseWrapper;
import java.io.IOException;

/** HTTP response that stays in the server's buffer until its audit record is stored. */
final class DelayedCommitResponse extends HttpServletResponseWrapper {
    /** Well within the server's buffer. */
    private static final int SMALL_BYTES = 4_096;

    private volatile boolean held = true;
    private final Runnable beforeItLeaves;

    /** {@code beforeItLeaves}: whoever sent too much is told so before all of that was read, but not before this. */
    DelayedCommitResponse(HttpServletResponse response, Runnable beforeItLeaves) {
        super(response);
        this.beforeItLeaves = beforeItLeaves;
    }

    void letGo() {
        held = false;
    }

    /** A small answer goes without: its length is known at its end, and one that is all there would leave at once. */
    @Override
    public void setContentLength(int length) {
        setContentLengthLong(length);
    }

    @Override
    public void setContentLengthLong(long length) {
        if (length > SMALL_BYTES) {
            super.setContentLengthLong(length);
        }
    }

    @Override
    public void setHeader(String name, String value) {
        if (isSmall(name, value)) {
            return;
        }
        super.setHeader(name, value);
    }

    @Override
    public void addHeader(String name, String value) {
        if (isSmall(name, value)) {
            return;
        }
        super.addHeader(name, value);
    }

    private static boolean isSmall(String name, String value) {
        return name.equalsIgnoreCase("Content-Length")
                && value.matches("\\d{1,9}")
                && Integer.parseInt(value) <= SMALL_BYTES;
    }

    @Override
    public void flushBuffer() throws IOException {
        if (held) {
            held = false;
            beforeItLeaves.run();
        }
        super.flushBuffer();
    }

    @Override
    public ServletOutputStream getOutputStream() throws IOException {
        return new DelayedOutputStream(super.getOutputStream());
    }

    private final class DelayedOutputStream extends ServletOutputStream {
        private final ServletOutputStream out;

        DelayedOutputStream(ServletOutputStream out) {
            this.out = out;
        }

        @Override
        public void write(int value) throws IOException {
            out.write(value);
        }

        @Override
        public void write(byte[] bytes, int offset, int length) throws IOException {
            out.write(bytes, offset, length);
        }

        @Override
        public void flush() throws IOException {
            if (!held) {
                out.flush();
            }
        }

        @Override
        public boolean isReady() {
            return out.isReady();
        }

        @Override
        public void setWriteListener(WriteListener listener) {
            out.setWriteListener(listener);
        }
    }
}
