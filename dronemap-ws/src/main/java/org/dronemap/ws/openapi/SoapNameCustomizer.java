package org.dronemap.ws.openapi;

import io.swagger.v3.oas.models.Operation;
import java.util.Arrays;
import java.util.Map;
import java.util.stream.Collectors;
import org.dronemap.ws.access.SoapName;
import org.dronemap.ws.access.WithoutSoap;
import org.springdoc.core.customizers.OperationCustomizer;
import org.springframework.web.method.HandlerMethod;

/**
 * Adds to the OpenAPI description an operation's name in SOAP, or why SOAP lacks it, as x-soap-name and x-without-soap.
 */
public final class SoapNameCustomizer implements OperationCustomizer {
    public static final String NAME = "x-soap-name";
    public static final String ALTERNATIVES = "x-soap-names";
    public static final String WITHOUT = "x-without-soap";

    @Override
    public Operation customize(Operation operation, HandlerMethod handler) {
        SoapName name = handler.getMethodAnnotation(SoapName.class);
        if (name != null && !name.value().isEmpty()) {
            operation.addExtension(NAME, name.value());
        }
        if (name != null && name.alternatives().length > 0) {
            operation.addExtension(ALTERNATIVES, names(name.alternatives()));
        }
        WithoutSoap without = handler.getMethodAnnotation(WithoutSoap.class);
        if (without != null) {
            operation.addExtension(WITHOUT, without.value());
        }
        return operation;
    }

    private static Map<String, String> names(String[] alternatives) {
        return Arrays.stream(alternatives)
                .map(pair -> pair.split("=", 2))
                .collect(Collectors.toMap(pair -> pair[0], pair -> pair[1]));
    }
}
