package org.dronemap.ws.wiring;

import jakarta.servlet.ServletContext;
import java.time.Clock;
import java.util.List;
import java.util.stream.Stream;
import org.apache.cxf.Bus;
import org.apache.cxf.bus.extension.ExtensionManagerBus;
import org.apache.cxf.transport.servlet.CXFNonSpringServlet;
import org.dronemap.ws.door.OriginalAddresses;
import org.dronemap.ws.reading.JsonReader;
import org.dronemap.ws.security.Authentication;
import org.dronemap.ws.security.ProblemWriter;
import org.dronemap.ws.settings.Settings;
import org.dronemap.ws.soap.PublishedServices;
import org.dronemap.ws.soap.RestCalls;
import org.dronemap.ws.soap.ServiceDescriptions;
import org.dronemap.ws.soap.SoapCaller;
import org.dronemap.ws.soap.SoapCalls;
import org.dronemap.ws.soap.SoapContract;
import org.dronemap.ws.soap.UsernameTokens;
import org.springframework.boot.web.servlet.FilterRegistrationBean;
import org.springframework.boot.web.servlet.ServletRegistrationBean;
import org.springframework.context.annotation.Bean;
import org.springframework.context.annotation.Configuration;
import org.springframework.web.filter.OncePerRequestFilter;
import org.springframework.web.servlet.DispatcherServlet;

/** Constructs the SOAP face: all of it follows from what REST says of itself. */
@Configuration(proxyBeanMethods = false)
public class SoapConfiguration {
    private static final String DESCRIPTION = "/api/openapi.json";

    /** The one bus of this server; services appear on it when they are first asked for. */
    @Bean(destroyMethod = "shutdown")
    Bus soapBus() {
        return new ExtensionManagerBus();
    }

    /** A call passes the filters that judge and note requests; those that bound connections have seen it already. */
    @Bean
    RestCalls restCalls(
            DispatcherServlet dispatcher,
            FilterRegistrationBean<OncePerRequestFilter> audit,
            FilterRegistrationBean<OncePerRequestFilter> plainAddress,
            FilterRegistrationBean<OncePerRequestFilter> access,
            ProblemWriter problems) {
        return new RestCalls(
                dispatcher, List.of(audit.getFilter(), plainAddress.getFilter(), access.getFilter()), problems);
    }

    @Bean
    SoapContract soapContract(RestCalls rest, JsonReader json, ServletContext context) {
        return new SoapContract(() -> json.mapper().readTree(rest.read(context, DESCRIPTION)));
    }

    @Bean
    SoapCalls soapCalls(
            SoapContract contract, RestCalls rest, Authentication authentication, Clock clock, JsonReader json) {
        return new SoapCalls(contract, new SoapCaller(authentication, new UsernameTokens(clock)), rest, json);
    }

    @Bean
    PublishedServices publishedServices(Bus soapBus, SoapContract contract, SoapCalls calls) {
        return new PublishedServices(soapBus, contract, calls);
    }

    @Bean
    FilterRegistrationBean<ServiceDescriptions> serviceDescriptions(
            PublishedServices published, ProblemWriter problems, Settings settings) {
        FilterRegistrationBean<ServiceDescriptions> registration =
                new FilterRegistrationBean<>(new ServiceDescriptions(published, problems));
        registration.addUrlPatterns("/services");
        registration.addUrlPatterns(paths(settings));
        return registration;
    }

    @Bean
    ServletRegistrationBean<CXFNonSpringServlet> soapServlet(Bus soapBus, Settings settings) {
        CXFNonSpringServlet servlet = new CXFNonSpringServlet();
        servlet.setBus(soapBus);
        ServletRegistrationBean<CXFNonSpringServlet> registration =
                new ServletRegistrationBean<>(servlet, paths(settings));
        registration.setName("soap");
        registration.addInitParameter("hide-service-list-page", "true");
        return registration;
    }

    private static String[] paths(Settings settings) {
        Stream<String> original = settings.originalAddresses() ? OriginalAddresses.paths().stream() : Stream.empty();
        return Stream.concat(Stream.of("/services/*"), original).toArray(String[]::new);
    }
}
