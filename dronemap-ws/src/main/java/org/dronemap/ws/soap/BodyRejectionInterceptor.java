package org.dronemap.ws.soap;

import java.io.FilterInputStream;
import java.io.IOException;
import java.io.InputStream;
import org.apache.cxf.interceptor.AttachmentInInterceptor;
import org.apache.cxf.message.Exchange;
import org.apache.cxf.message.Message;
import org.apache.cxf.phase.AbstractPhaseInterceptor;
import org.apache.cxf.phase.Phase;
import org.dronemap.ws.problem.Rejection;

/**
 * Lets the body of a SOAP message that is too long or too slow be rejected once only. The library reads on after a
 * fault, to have nothing left on the connection, and what is refused then would be a failure of the server.
 */
final class BodyRejectionInterceptor extends AbstractPhaseInterceptor<Message> {
    BodyRejectionInterceptor() {
        super(Phase.RECEIVE);
        addBefore(AttachmentInInterceptor.class.getName());
    }

    @Override
    public void handleMessage(Message message) {
        InputStream body = message.getContent(InputStream.class);
        if (body != null) {
            message.setContent(InputStream.class, new RefusedOnce(body, message.getExchange()));
        }
    }

    private static final class RefusedOnce extends FilterInputStream {
        private final Exchange exchange;
        private boolean refused;

        RefusedOnce(InputStream body, Exchange exchange) {
            super(body);
            this.exchange = exchange;
        }

        @Override
        public int read() throws IOException {
            byte[] one = new byte[1];
            return read(one, 0, 1) < 0 ? -1 : one[0] & 0xFF;
        }

        @Override
        public int read(byte[] buffer, int offset, int length) throws IOException {
            if (refused) {
                return -1;
            }
            try {
                return super.read(buffer, offset, length);
            } catch (Rejection rejection) {
                refused = true;
                // The parser may call it bad XML.
                exchange.put(Rejection.class, rejection);
                throw rejection;
            }
        }
    }
}
