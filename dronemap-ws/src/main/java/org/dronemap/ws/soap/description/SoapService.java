package org.dronemap.ws.soap.description;

import java.util.List;
import java.util.Optional;

/** A service: what stands in one WSDL. {@code port} and {@code portType} are names there. */
public record SoapService(String name, String port, String portType, List<SoapOperation> operations) {
    public Optional<SoapOperation> operation(String name) {
        return operations.stream().filter(one -> one.name().equals(name)).findFirst();
    }
}
