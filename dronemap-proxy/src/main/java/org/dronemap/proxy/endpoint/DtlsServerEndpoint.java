package org.dronemap.proxy.endpoint;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.concurrent.TimeUnit;
import org.dronemap.core.time.Time;
import org.eclipse.californium.elements.DtlsEndpointContext;
import org.eclipse.californium.elements.EndpointContext;
import org.eclipse.californium.elements.PrincipalEndpointContextMatcher;
import org.eclipse.californium.elements.RawData;
import org.eclipse.californium.elements.auth.PreSharedKeyIdentity;
import org.eclipse.californium.elements.config.Configuration;
import org.eclipse.californium.scandium.DTLSConnector;
import org.eclipse.californium.scandium.config.DtlsConfig;
import org.eclipse.californium.scandium.config.DtlsConfig.DtlsRole;
import org.eclipse.californium.scandium.config.DtlsConnectorConfig;
import org.eclipse.californium.scandium.dtls.SingleNodeConnectionIdGenerator;
import org.eclipse.californium.scandium.dtls.cipher.CipherSuite;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A UDP port for peers that authenticate with pre-shared keys of their own (DTLS 1.2). Vehicles that use a connection
 * id keep their place when their address changes. Sessions are never resumed: a revoked key is of no use at once.
 */
final class DtlsServerEndpoint implements Endpoint {
    private static final Logger LOG = LoggerFactory.getLogger(DtlsServerEndpoint.class);
    private static final int MOST_CONNECTIONS = 2_000;
    private static final int LINKS_PER_IDENTITY = 4;
    private static final PeerRegistry.Limits LIMITS = new PeerRegistry.Limits(MOST_CONNECTIONS, LINKS_PER_IDENTITY);
    private static final int RECEIVE_BUFFER_BYTES = 4 * 1024 * 1024;
    private static final int CONNECTION_ID_BYTES = 6;
    private static final int MOST_WAITING_OUT = 2_000;
    private static final long STALE_SECONDS = 60;

    private final EndpointUrl url;
    private final DTLSConnector connector;
    private final boolean local;
    private final EndpointCounters counters = new EndpointCounters();
    private final PeerRegistry<Handshake> peers;
    private final Time time;

    /** The identity and time of one DTLS handshake, which tell one link of a vehicle from the next. */
    private record Handshake(String identity, long atMillis) {}

    private DtlsServerEndpoint(
            EndpointUrl url, InetSocketAddress address, PeerHandler.Factory handlers, DtlsKeys keys, Time time) {
        this.url = url;
        this.time = time;
        this.local = SocketAddresses.isLocal(address);
        peers = new PeerRegistry<>(counters, handlers, LIMITS, time);
        connector = new DTLSConnector(config(address, keys));
        connector.setEndpointContextMatcher(new PrincipalEndpointContextMatcher());
        connector.setRawDataReceiver(this::received);
    }

    static DtlsServerEndpoint open(EndpointUrl url, PeerHandler.Factory handlers, DtlsKeys keys, Time time)
            throws IOException {
        DtlsServerEndpoint endpoint = new DtlsServerEndpoint(url, SocketAddresses.resolve(url), handlers, keys, time);
        try {
            endpoint.connector.start();
        } catch (IOException e) {
            endpoint.connector.destroy();
            throw SocketAddresses.cannotListen(url, e);
        }
        return endpoint;
    }

    private static DtlsConnectorConfig config(InetSocketAddress address, DtlsKeys keys) {
        DtlsConnectorConfig.Builder config = DtlsConnectorConfig.builder(new Configuration(DtlsConfig.DEFINITIONS));
        config.setAddress(address)
                .set(DtlsConfig.DTLS_ROLE, DtlsRole.SERVER_ONLY)
                .setAdvancedPskStore(new DtlsPskStore(keys))
                .setConnectionIdGenerator(new SingleNodeConnectionIdGenerator(CONNECTION_ID_BYTES))
                .set(DtlsConfig.DTLS_USE_HELLO_VERIFY_REQUEST, true)
                .set(DtlsConfig.DTLS_SERVER_USE_SESSION_ID, false)
                .set(DtlsConfig.DTLS_MAX_CONNECTIONS, MOST_CONNECTIONS)
                .set(DtlsConfig.DTLS_STALE_CONNECTION_THRESHOLD, STALE_SECONDS, TimeUnit.SECONDS)
                .set(DtlsConfig.DTLS_RECEIVE_BUFFER_SIZE, RECEIVE_BUFFER_BYTES)
                .set(DtlsConfig.DTLS_MAX_PENDING_OUTBOUND_JOBS, MOST_WAITING_OUT)
                .set(DtlsConfig.DTLS_RECEIVER_THREAD_COUNT, 1)
                .set(DtlsConfig.DTLS_CONNECTOR_THREAD_COUNT, 1)
                .setAsList(
                        DtlsConfig.DTLS_CIPHER_SUITES,
                        CipherSuite.TLS_ECDHE_PSK_WITH_AES_128_GCM_SHA256,
                        CipherSuite.TLS_PSK_WITH_AES_128_GCM_SHA256,
                        CipherSuite.TLS_PSK_WITH_AES_128_CCM_8);
        return config.build();
    }

    @Override
    public EndpointUrl url() {
        return url.withPort(connector.getAddress().getPort());
    }

    @Override
    public EndpointCounters counters() {
        return counters;
    }

    @Override
    public List<PeerStatus> peers() {
        return peers.status();
    }

    @Override
    public OptionalLong kernelDrops() {
        return KernelDrops.of(connector.getAddress().getPort());
    }

    /** The one connector thread brings all data. */
    private void received(RawData data) {
        EndpointContext context = data.getEndpointContext();
        Long handshakeMillis = context.get(DtlsEndpointContext.KEY_HANDSHAKE_TIMESTAMP);
        if (!(data.getSenderIdentity() instanceof PreSharedKeyIdentity identity) || handshakeMillis == null) {
            return;
        }
        long now = time.nanos();
        Handshake handshake = new Handshake(identity.getIdentity(), handshakeMillis);
        EndpointPeer seat = peers.find(handshake);
        if (seat == null) {
            seat = admit(handshake, context, now);
        }
        if (seat != null) {
            follow(seat, context);
            seat.received(ByteBuffer.wrap(data.getBytes()), now);
        }
        peers.sweep(now);
    }

    private @Nullable EndpointPeer admit(Handshake handshake, EndpointContext context, long now) {
        peers.makeRoomFor(handshake.identity());
        EndpointPeer.Origin place =
                new EndpointPeer.Origin(url.kind().transport(), local, true, Optional.of(handshake.identity()));
        DtlsFrameSender wire = new DtlsFrameSender(connector, context, counters);
        return peers.add(
                handshake,
                handshake.identity(),
                now,
                welcome -> new EndpointPeer(place, PeerAddress.of(context.getPeerAddress()), wire, welcome));
    }

    private void follow(EndpointPeer seat, EndpointContext context) {
        PeerAddress address = PeerAddress.of(context.getPeerAddress());
        if (!address.equals(seat.address())) {
            LOG.info(
                    "{} moved from {} to {}",
                    seat.authenticatedIdentity().orElse("a vehicle"),
                    seat.address(),
                    address);
            seat.movedTo(address);
        }
        if (seat.wire() instanceof DtlsFrameSender wire) {
            wire.now(context);
        }
    }

    @Override
    public void disconnect(String identity) {
        peers.removeAllOf(identity);
    }

    @Override
    public void close() {
        connector.destroy();
        peers.clear();
    }
}
