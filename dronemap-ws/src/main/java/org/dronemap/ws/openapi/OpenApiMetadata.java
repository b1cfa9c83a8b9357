package org.dronemap.ws.openapi;

import io.swagger.v3.core.converter.ModelConverters;
import io.swagger.v3.oas.models.Components;
import io.swagger.v3.oas.models.OpenAPI;
import io.swagger.v3.oas.models.info.Info;
import io.swagger.v3.oas.models.info.License;
import io.swagger.v3.oas.models.media.Schema;
import io.swagger.v3.oas.models.security.SecurityRequirement;
import io.swagger.v3.oas.models.security.SecurityScheme;
import java.util.LinkedHashMap;
import java.util.Objects;
import org.dronemap.ws.problem.ProblemView;

/** Metadata at the head of the OpenAPI description. */
public final class OpenApiMetadata {
    private OpenApiMetadata() {}

    public static OpenAPI of(String version) {
        return new OpenAPI()
                .info(new Info()
                        .title("Dronemap")
                        .version(version)
                        .description(
                                "Drones from anywhere, flown by many users. Angles in degrees, distances in metres,"
                                        + " speeds in m/s, times in UTC; a fact that nobody knows is null. A request that is not"
                                        + " carried out is answered with application/problem+json, whose detail is a sentence"
                                        + " for people. Programs send an access key as Authorization: Bearer KEY; a browser's"
                                        + " session has to send X-Dronemap: 1 with every change. Each answer has the version"
                                        + " of the server in the header Dronemap-Version.")
                        .license(new License().name("Apache-2.0").url("https://www.apache.org/licenses/LICENSE-2.0")))
                .components(typed(new Components()
                        .schemas(new LinkedHashMap<>(
                                ModelConverters.getInstance(true).readAll(ProblemView.class)))
                        .addSecuritySchemes(
                                "accessKey",
                                new SecurityScheme()
                                        .type(SecurityScheme.Type.HTTP)
                                        .scheme("bearer"))
                        .addSecuritySchemes(
                                "session",
                                new SecurityScheme()
                                        .type(SecurityScheme.Type.APIKEY)
                                        .in(SecurityScheme.In.COOKIE)
                                        .name("dronemap-session"))))
                .addSecurityItem(new SecurityRequirement().addList("accessKey"))
                .addSecurityItem(new SecurityRequirement().addList("session"));
    }

    /** Its parameters are texts, numbers or truths, which the type of their map does not say. */
    private static Components typed(Components components) {
        Schema<?> problem = Objects.requireNonNull(components.getSchemas().get("Problem"));
        Schema<?> parameters = Objects.requireNonNull(problem.getProperties().get("parameters"));
        parameters.setAdditionalProperties(AllowedValuesSchema.plain());
        return components;
    }
}
