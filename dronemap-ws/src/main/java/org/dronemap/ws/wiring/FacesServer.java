package org.dronemap.ws.wiring;

import java.util.LinkedHashMap;
import java.util.Map;
import org.dronemap.ws.environment.EnvironmentVariables;
import org.dronemap.ws.server.ServerComponents;
import org.dronemap.ws.settings.ServerSettings;
import org.springframework.boot.Banner;
import org.springframework.boot.SpringApplication;
import org.springframework.boot.builder.SpringApplicationBuilder;
import org.springframework.context.ConfigurableApplicationContext;
import org.springframework.context.support.GenericApplicationContext;

/** Starts the web server with the REST, SOAP and stream faces on built {@link ServerComponents}. */
public final class FacesServer {
    static final String TLS_BUNDLE = "faces";

    private FacesServer() {}

    /** {@code variables}: what use cases read for themselves. */
    public static ConfigurableApplicationContext start(
            ServerSettings settings, EnvironmentVariables variables, ServerComponents house) {
        SpringApplication application = new SpringApplicationBuilder(FacesApplication.class)
                .bannerMode(Banner.Mode.OFF)
                .logStartupInfo(false)
                .registerShutdownHook(false)
                .properties(properties(settings))
                .initializers(context -> {
                    if (context instanceof GenericApplicationContext generic) {
                        generic.registerBean(ServerSettings.class, () -> settings);
                        generic.registerBean(EnvironmentVariables.class, () -> variables);
                        generic.registerBean(ServerComponents.class, () -> house);
                    }
                })
                .build();
        return application.run();
    }

    private static Map<String, Object> properties(ServerSettings settings) {
        Map<String, Object> properties = new LinkedHashMap<>();
        properties.put("server.address", settings.bindAddress());
        properties.put("server.port", settings.httpPort());
        ServerSettings.Tls tls = settings.tls();
        if (tls != null) {
            properties.put(
                    "spring.ssl.bundle.pem." + TLS_BUNDLE + ".keystore.certificate", "file:" + tls.certificate());
            properties.put("spring.ssl.bundle.pem." + TLS_BUNDLE + ".keystore.private-key", "file:" + tls.key());
            // renewed certificates are used without a restart
            properties.put("spring.ssl.bundle.pem." + TLS_BUNDLE + ".reload-on-update", true);
            properties.put("spring.ssl.bundle.watch.file.quiet-period", "3s");
            properties.put("server.ssl.bundle", TLS_BUNDLE);
        }
        return properties;
    }
}
