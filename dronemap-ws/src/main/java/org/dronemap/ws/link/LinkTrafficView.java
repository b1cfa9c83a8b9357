package org.dronemap.ws.link;

import io.swagger.v3.oas.annotations.media.Schema;
import org.jspecify.annotations.Nullable;

/** Message counts between one vehicle and the cloud over one link since the session began, as clients see them. */
@Schema(name = "TrafficView")
public record LinkTrafficView(
        @Nullable String drone,
        String address,
        int port,
        int systemId,
        String transport,
        long received,
        long sent,
        long lost,
        long doubled,
        long dropped,
        int queue) {
    LinkTrafficView withoutDrone() {
        return new LinkTrafficView(
                null, address, port, systemId, transport, received, sent, lost, doubled, dropped, queue);
    }
}
