package org.dronemap.proxy.endpoint;

import java.io.IOException;
import java.net.BindException;
import java.net.InetSocketAddress;
import java.net.UnknownHostException;

/** Resolves the socket addresses of endpoint URLs, and tells local ones. */
final class SocketAddresses {
    private SocketAddresses() {}

    /** Looks the host up; blocks as long as that takes. */
    static InetSocketAddress resolve(EndpointUrl url) throws UnknownHostException {
        InetSocketAddress address = new InetSocketAddress(url.host().replaceAll("[\\[\\]]", ""), url.port());
        if (address.isUnresolved()) {
            throw new UnknownHostException("The address of " + url + " cannot be found"
                    + (url.kind().isListener()
                            ? "; name one of this machine, such as 127.0.0.1, or 0.0.0.0 for all."
                            : "; is the name right, and does this machine reach a name server?"));
        }
        return address;
    }

    static boolean isLocal(InetSocketAddress address) {
        return address.getAddress() != null && address.getAddress().isLoopbackAddress();
    }

    static IOException cannotListen(EndpointUrl url, IOException cause) {
        String why = cause instanceof BindException
                        && String.valueOf(cause.getMessage()).contains("in use")
                ? "port " + url.port() + " is taken by another program; stop it or configure another port."
                : cause.getMessage() + ".";
        return new IOException("Cannot listen on " + url + ": " + why, cause);
    }
}
