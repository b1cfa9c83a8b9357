package org.dronemap.ws.openapi;

import io.swagger.v3.oas.models.Operation;
import io.swagger.v3.oas.models.media.BinarySchema;
import io.swagger.v3.oas.models.media.Content;
import io.swagger.v3.oas.models.media.MediaType;
import io.swagger.v3.oas.models.parameters.RequestBody;
import io.swagger.v3.oas.models.responses.ApiResponse;
import org.dronemap.ws.http.FileMediaTypes;
import org.springdoc.core.customizers.OperationCustomizer;
import org.springframework.core.Ordered;
import org.springframework.core.annotation.Order;
import org.springframework.web.method.HandlerMethod;

/**
 * Adds to the OpenAPI description the media types of files that an operation takes and returns. Before statuses are
 * listed, which take the content over.
 */
@Order(Ordered.HIGHEST_PRECEDENCE)
public final class FileContentCustomizer implements OperationCustomizer {
    @Override
    public Operation customize(Operation operation, HandlerMethod handler) {
        FileMediaTypes files = handler.getMethodAnnotation(FileMediaTypes.class);
        if (files == null) {
            return operation;
        }
        if (files.consumes().length > 0) {
            operation.setRequestBody(new RequestBody().required(true).content(content(files.consumes())));
        }
        if (files.produces().length > 0) {
            operation
                    .getResponses()
                    .computeIfAbsent("200", status -> new ApiResponse())
                    .setContent(content(files.produces()));
        }
        return operation;
    }

    private static Content content(String[] mediaTypes) {
        Content content = new Content();
        for (String type : mediaTypes) {
            content.addMediaType(type, new MediaType().schema(new BinarySchema()));
        }
        return content;
    }
}
