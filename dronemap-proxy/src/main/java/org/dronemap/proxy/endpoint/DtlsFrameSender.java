package org.dronemap.proxy.endpoint;

import org.eclipse.californium.elements.DtlsEndpointContext;
import org.eclipse.californium.elements.EndpointContext;
import org.eclipse.californium.elements.MessageCallback;
import org.eclipse.californium.elements.RawData;
import org.eclipse.californium.scandium.DTLSConnector;
import org.eclipse.californium.scandium.dtls.DTLSContext;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Sends frames to one vehicle over its DTLS connection, also after the vehicle's address has changed. */
final class DtlsFrameSender implements FrameSender {
    private static final Logger LOG = LoggerFactory.getLogger(DtlsFrameSender.class);

    private final DTLSConnector connector;
    private final MessageCallback failures;
    private volatile EndpointContext context;

    DtlsFrameSender(DTLSConnector connector, EndpointContext context, EndpointCounters counters) {
        this.connector = connector;
        this.context = context;
        this.failures = new Failures(counters);
    }

    /** Where its vehicle was heard last. */
    void now(EndpointContext latest) {
        context = latest;
    }

    @Override
    public boolean send(byte[] frame) {
        if (!connector.isRunning()) {
            return false;
        }
        connector.send(RawData.outbound(frame, context, failures, false));
        return true;
    }

    @Override
    public void close() {
        EndpointContext latest = context;
        if (!connector.isRunning()) {
            return;
        }
        DTLSContext there = connector.getDtlsContextByAddress(latest.getPeerAddress());
        Long handshake = latest.get(DtlsEndpointContext.KEY_HANDSHAKE_TIMESTAMP);
        // A later handshake from the same address is another link.
        if (there != null && handshake != null && there.getLastHandshakeTime() == handshake) {
            connector.close(latest.getPeerAddress());
        }
    }

    /** Counts what the connector took and could not send. */
    private record Failures(EndpointCounters counters) implements MessageCallback {
        @Override
        public void onConnecting() {
            LOG.debug("a frame waits for a handshake");
        }

        @Override
        public void onDtlsRetransmission(int flight) {
            LOG.debug("a handshake is retransmitted");
        }

        @Override
        public void onContextEstablished(EndpointContext established) {
            LOG.trace("a frame goes out");
        }

        @Override
        public void onSent() {
            LOG.trace("a frame went out");
        }

        @Override
        public void onError(Throwable error) {
            counters.droppedOut();
            LOG.debug("A frame was not sent", error);
        }
    }
}
