package org.dronemap.ws.soap;

import jakarta.servlet.ServletOutputStream;
import jakarta.servlet.WriteListener;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.dronemap.ws.problem.RejectionKind;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.springframework.mock.web.MockHttpServletResponse;
import org.springframework.web.context.request.async.AsyncRequestNotUsableException;

/**
 * The complete answer of the REST API to a call from SOAP, limited to the size of one SOAP message: XML of what a handler
 * answered, else the bytes that REST writes.
 */
final class RestResponse extends MockHttpServletResponse {
    /** As many letters of XML; a file of this size is a message of 6 MB. */
    static final int LONGEST_BYTES = 4 << 20;

    private static final Logger LOG = LoggerFactory.getLogger(RestResponse.class);
    private static final int FIRST_REFUSAL = 400;
    private static final int OWN_FAULT = 500;

    // The mock's own takes one byte at a time.
    private final ByteArrayOutputStream content = new ByteArrayOutputStream();
    private final ServletOutputStream bounded = new Bounded();
    private final @Nullable BodyWriter xmlWriter;
    private @Nullable PrintWriter writer;
    private @Nullable List<String> xml;
    private boolean tooLong;

    /** Writes what a handler answers as XML, in parts; null: that is longer than {@link #LONGEST_BYTES}. */
    interface BodyWriter {
        @Nullable
        List<String> write(Object body);
    }

    /** {@code xmlWriter}: null: nothing is written as XML. */
    RestResponse(@Nullable BodyWriter xmlWriter) {
        this.xmlWriter = xmlWriter;
    }

    /** False: it is to be written by others. */
    boolean write(Object body) {
        if (xmlWriter == null || isRefusal()) {
            return false;
        }
        xml = xmlWriter.write(body);
        tooLong = xml == null;
        return true;
    }

    /** The answer of a handler, in parts; null: that was no value. */
    @Nullable
    List<String> xml() {
        return xml;
    }

    boolean isRefusal() {
        return getStatus() >= FIRST_REFUSAL;
    }

    @Override
    public ServletOutputStream getOutputStream() {
        return bounded;
    }

    @Override
    public PrintWriter getWriter() {
        PrintWriter texts = writer;
        if (texts == null) {
            texts = new PrintWriter(bounded, false, StandardCharsets.UTF_8);
            writer = texts;
        }
        return texts;
    }

    @Override
    public byte[] getContentAsByteArray() {
        if (writer != null) {
            writer.flush();
        }
        return content.toByteArray();
    }

    @Override
    public void resetBuffer() {
        super.resetBuffer();
        content.reset();
    }

    @Override
    public int getStatus() {
        return tooLong ? RejectionKind.TOO_LARGE.status() : super.getStatus();
    }

    /** There is more of it: what is here is to be thrown away. */
    boolean tooLong() {
        return tooLong;
    }

    void failed(Exception why) {
        if (tooLong) {
            return;
        }
        LOG.error("A request of SOAP to REST failed", why);
        setStatus(OWN_FAULT);
    }

    String text() {
        return new String(getContentAsByteArray(), StandardCharsets.UTF_8);
    }

    private final class Bounded extends ServletOutputStream {
        @Override
        public void write(int letter) throws IOException {
            reserve(1);
            content.write(letter);
        }

        @Override
        public void write(byte[] bytes, int from, int length) throws IOException {
            reserve(length);
            content.write(bytes, from, length);
        }

        private void reserve(int more) throws IOException {
            if (content.size() + more > LONGEST_BYTES) {
                tooLong = true;
                // As if the client had gone: that is no fault of the server.
                throw new AsyncRequestNotUsableException("the answer is longer than a message may be");
            }
        }

        @Override
        public boolean isReady() {
            return true;
        }

        @Override
        public void setWriteListener(WriteListener listener) {
            throw new IllegalStateException("this answer is written at once");
        }
    }
}
