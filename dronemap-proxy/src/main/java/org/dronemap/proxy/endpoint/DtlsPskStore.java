package org.dronemap.proxy.endpoint;

import java.net.InetSocketAddress;
import java.util.Arrays;
import javax.crypto.SecretKey;
import org.eclipse.californium.scandium.dtls.ConnectionId;
import org.eclipse.californium.scandium.dtls.HandshakeResultHandler;
import org.eclipse.californium.scandium.dtls.PskPublicInformation;
import org.eclipse.californium.scandium.dtls.PskSecretResult;
import org.eclipse.californium.scandium.dtls.pskstore.AdvancedPskStore;
import org.eclipse.californium.scandium.util.SecretUtil;
import org.eclipse.californium.scandium.util.ServerNames;
import org.jspecify.annotations.Nullable;

/** Gives the DTLS library the pre-shared key of an identity; the handshake of an unknown one fails. */
final class DtlsPskStore implements AdvancedPskStore {
    private final DtlsKeys keys;

    DtlsPskStore(DtlsKeys keys) {
        this.keys = keys;
    }

    @Override
    public boolean hasEcdhePskSupported() {
        return true;
    }

    @Override
    public PskSecretResult requestPskSecretResult(
            ConnectionId connection,
            @Nullable ServerNames serverNames,
            PskPublicInformation identity,
            String hmacAlgorithm,
            @Nullable SecretKey otherSecret,
            byte[] seed,
            boolean useExtendedMasterSecret) {
        return new PskSecretResult(connection, identity, secret(identity.getPublicInfoAsString()));
    }

    private @Nullable SecretKey secret(String identity) {
        byte[] secret = keys.secret(identity).orElse(null);
        if (secret == null) {
            return null;
        }
        SecretKey key = SecretUtil.create(secret, PskSecretResult.ALGORITHM_PSK);
        Arrays.fill(secret, (byte) 0);
        return key;
    }

    @Override
    public @Nullable PskPublicInformation getIdentity(InetSocketAddress peer, @Nullable ServerNames serverNames) {
        // Asked of clients only; this end always listens.
        return null;
    }

    @Override
    public void setResultHandler(HandshakeResultHandler handler) {
        // Every answer is given at once.
    }
}
