package org.dronemap.ws.soap;

import java.util.function.Supplier;
import org.dronemap.ws.soap.description.OpenApiOperationReader;
import org.dronemap.ws.soap.description.SoapServices;
import org.jspecify.annotations.Nullable;
import tools.jackson.databind.JsonNode;

/** The SOAP services, derived from the OpenAPI description of the running server when first asked for. Any thread. */
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
