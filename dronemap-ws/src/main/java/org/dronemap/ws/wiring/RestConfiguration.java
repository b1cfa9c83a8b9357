package org.dronemap.ws.wiring;

import com.fasterxml.jackson.annotation.Nulls;
import io.swagger.v3.oas.models.OpenAPI;
import java.util.Map;
import org.dronemap.core.audit.AuditRecorder;
import org.dronemap.proxy.endpoint.BoundedWebSocketFactory;
import org.dronemap.ws.access.RestOperations;
import org.dronemap.ws.budget.Budgets;
import org.dronemap.ws.http.AccessLogFilter;
import org.dronemap.ws.http.AuditBodyAdvice;
import org.dronemap.ws.http.AuditFilter;
import org.dronemap.ws.http.FallbackErrorController;
import org.dronemap.ws.http.ProblemAdvice;
import org.dronemap.ws.http.SecurityHeadersFilter;
import org.dronemap.ws.http.VersionHeaderValve;
import org.dronemap.ws.http.WebClientPages;
import org.dronemap.ws.limit.BodyLimitFilter;
import org.dronemap.ws.limit.BoundedHttpProtocol;
import org.dronemap.ws.limit.CanonicalUriFilter;
import org.dronemap.ws.limit.ClientLimits;
import org.dronemap.ws.limit.HostConcurrencyFilter;
import org.dronemap.ws.openapi.AlternativesSchemaCustomizer;
import org.dronemap.ws.openapi.CommandPurposeCustomizer;
import org.dronemap.ws.openapi.FileContentCustomizer;
import org.dronemap.ws.openapi.NullabilityCustomizer;
import org.dronemap.ws.openapi.OpenApiMetadata;
import org.dronemap.ws.openapi.RecordSchemaRegistry;
import org.dronemap.ws.openapi.SoapNameCustomizer;
import org.dronemap.ws.openapi.StatusCustomizer;
import org.dronemap.ws.openapi.StreamDescriptionHandler;
import org.dronemap.ws.reading.JsonCodec;
import org.dronemap.ws.security.AccessFilter;
import org.dronemap.ws.security.CallerAuthenticator;
import org.dronemap.ws.security.ProblemWriter;
import org.dronemap.ws.security.TomcatErrorValve;
import org.dronemap.ws.server.BuildVersion;
import org.dronemap.ws.settings.ServerSettings;
import org.dronemap.ws.stream.StreamClientRegistry;
import org.dronemap.ws.stream.description.StreamDescription;
import org.springframework.boot.jackson.autoconfigure.JsonMapperBuilderCustomizer;
import org.springframework.boot.tomcat.ConfigurableTomcatWebServerFactory;
import org.springframework.boot.tomcat.servlet.TomcatServletWebServerFactory;
import org.springframework.boot.web.server.WebServerFactoryCustomizer;
import org.springframework.boot.web.servlet.FilterRegistrationBean;
import org.springframework.context.annotation.Bean;
import org.springframework.context.annotation.Configuration;
import org.springframework.context.annotation.Import;
import org.springframework.core.Ordered;
import org.springframework.web.filter.OncePerRequestFilter;
import org.springframework.web.servlet.config.annotation.WebMvcConfigurer;
import org.springframework.web.servlet.handler.SimpleUrlHandlerMapping;
import tools.jackson.databind.DeserializationFeature;

/** Spring configuration of the servlet filters, of the web server and of the description of REST. */
@Configuration(proxyBeanMethods = false)
@Import({AuditBodyAdvice.class, ProblemAdvice.class, FallbackErrorController.class})
class RestConfiguration {
    /** One for the process, as what reads records for descriptions is: a second server would take it from the first. */
    private static final RecordSchemaRegistry RECORDS = new RecordSchemaRegistry();

    private static final AlternativesSchemaCustomizer ALTERNATIVES = new AlternativesSchemaCustomizer(RECORDS);

    private static final int KEEP_ALIVE_MILLIS = 30_000;

    @Bean
    JsonMapperBuilderCustomizer strictJson() {
        return builder -> builder.enable(DeserializationFeature.FAIL_ON_UNKNOWN_PROPERTIES)
                .disable(DeserializationFeature.ACCEPT_FLOAT_AS_INT)
                .changeDefaultNullHandling(usual -> usual.withContentNulls(Nulls.FAIL));
    }

    @Bean
    ProblemWriter problemWriter(JsonCodec json) {
        return new ProblemWriter(json);
    }

    @Bean
    WebServerFactoryCustomizer<ConfigurableTomcatWebServerFactory> refusedByTomcat(JsonCodec json) {
        return factory -> factory.addContextCustomizers(
                context -> context.getParent().getPipeline().addValve(new TomcatErrorValve(json)));
    }

    @Bean
    WebServerFactoryCustomizer<ConfigurableTomcatWebServerFactory> versionHeader() {
        return factory -> factory.addContextCustomizers(
                context -> context.getParent().getPipeline().addValve(new VersionHeaderValve(BuildVersion.current())));
    }

    @Bean
    FilterRegistrationBean<OncePerRequestFilter> accessLog() {
        return first(new AccessLogFilter(), 0);
    }

    @Bean
    FilterRegistrationBean<OncePerRequestFilter> securityHeaders(ServerSettings settings, StreamPort stream) {
        return first(new SecurityHeadersFilter(stream.number(), settings.tileAddress()), 1);
    }

    /** Before all that turn requests away. */
    @Bean
    FilterRegistrationBean<OncePerRequestFilter> audit(AuditRecorder desk, RestOperations operations) {
        return first(new AuditFilter(desk, operations), 2);
    }

    @Bean
    HostConcurrencyFilter crowdFilter(ProblemWriter problems, ServerSettings settings) {
        return new HostConcurrencyFilter(problems, settings.protection().clients());
    }

    @Bean
    ProtectionCounters protections(
            Budgets budgets,
            HostConcurrencyFilter crowd,
            BoundedWebSocketFactory streamDoor,
            StreamClientRegistry streamCrowd) {
        return new ProtectionCounters(budgets, crowd, streamDoor, streamCrowd);
    }

    @Bean
    FilterRegistrationBean<OncePerRequestFilter> crowd(HostConcurrencyFilter filter) {
        return first(filter, 3);
    }

    @Bean
    FilterRegistrationBean<OncePerRequestFilter> bodyLimit(ProblemWriter problems, ServerSettings settings) {
        return first(new BodyLimitFilter(problems, settings.protection().clients()), 4);
    }

    /** The web server's own patience begins anew with each byte. */
    @Bean
    WebServerFactoryCustomizer<TomcatServletWebServerFactory> patientServer(
            ServerSettings settings, ProtectionCounters protections) {
        ClientLimits limits = settings.protection().clients();
        return factory -> {
            factory.setProtocol(BoundedHttpProtocol.class.getName());
            factory.addConnectorCustomizers(connector -> {
                if (connector.getProtocolHandler() instanceof BoundedHttpProtocol patient) {
                    patient.limits(limits);
                    protections.web(patient);
                    patient.setConnectionTimeout((int) limits.patience().toMillis());
                    patient.setKeepAliveTimeout(KEEP_ALIVE_MILLIS);
                }
            });
        };
    }

    /** Within the bounds of time and length, and before it is judged who may go there. */
    @Bean
    FilterRegistrationBean<OncePerRequestFilter> plainAddress(ProblemWriter problems) {
        return first(new CanonicalUriFilter(problems), 5);
    }

    @Bean
    FilterRegistrationBean<OncePerRequestFilter> access(
            RestOperations operations, CallerAuthenticator authentication, Budgets budgets, ProblemWriter problems) {
        return first(new AccessFilter(operations, authentication, budgets, problems), 6);
    }

    @Bean
    WebMvcConfigurer webClientPages() {
        return new WebClientPages();
    }

    /** Before what answers that there is nothing at an address. */
    @Bean
    SimpleUrlHandlerMapping streamDescriptions(StreamDescription description, StreamPort port) {
        StreamDescriptionHandler handler = new StreamDescriptionHandler(
                (encrypted, host) -> description.at(encrypted ? "wss" : "ws", host + ":" + port.number()));
        return new SimpleUrlHandlerMapping(Map.of("/api/asyncapi.json", handler), 1);
    }

    @Bean
    OpenAPI apiDescription() {
        return OpenApiMetadata.of(BuildVersion.current());
    }

    @Bean
    RecordSchemaRegistry describedRecords() {
        return RECORDS;
    }

    @Bean
    AlternativesSchemaCustomizer describedAlternatives() {
        return ALTERNATIVES;
    }

    @Bean
    StatusCustomizer describedStatuses() {
        return new StatusCustomizer();
    }

    @Bean
    FileContentCustomizer describedFiles() {
        return new FileContentCustomizer();
    }

    @Bean
    SoapNameCustomizer describedSoapNames() {
        return new SoapNameCustomizer();
    }

    @Bean
    CommandPurposeCustomizer describedPurposes() {
        return new CommandPurposeCustomizer();
    }

    @Bean
    NullabilityCustomizer describedNulls(RecordSchemaRegistry records) {
        return new NullabilityCustomizer(records);
    }

    private static FilterRegistrationBean<OncePerRequestFilter> first(OncePerRequestFilter filter, int place) {
        FilterRegistrationBean<OncePerRequestFilter> registration = new FilterRegistrationBean<>(filter);
        registration.setOrder(Ordered.HIGHEST_PRECEDENCE + 100 + place);
        registration.addUrlPatterns("/*");
        return registration;
    }
}
