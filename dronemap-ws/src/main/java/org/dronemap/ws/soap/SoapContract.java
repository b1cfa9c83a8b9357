package org.dronemap.ws.soap;

import java.util.function.Supplier;
import org.dronemap.ws.soap.description.OpenApiOperationReader;
import org.dronemap.ws.soap.description.SoapServices;
import org.jspecify.annotations.Nullable;
import tools.jackson.databind.JsonNode;

/**
 * The services as they are described, read when they are first asked for: REST, from which they follow, describes itself only
 * when the server is up. Any thread.
 */
public final class SoapContract {
    private final Supplier<JsonNode> openApi;
    private volatile @Nullable SoapServices read;

    /** {@code openApi}: the description of REST. */
    public SoapContract(Supplier<JsonNode> openApi) {
        this.openApi = openApi;
    }

    SoapServices services() {
        SoapServices services = read;
        return services == null ? first() : services;
    }

    private synchronized SoapServices first() {
        SoapServices services = read;
        if (services == null) {
            services = OpenApiOperationReader.read(openApi.get());
            read = services;
        }
        return services;
    }
}
