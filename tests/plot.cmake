thaum_test(test_plot
    SOURCES unit/plot_test.cpp unit/report_test.cpp
    LINK thaum_plot)
